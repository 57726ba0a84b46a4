"""Films of runs, read back: how many frames, how long, and where the tip is drawn in them."""

import os
import subprocess

import numpy as np
import pytest
from conftest import require_tool
from dressed_arm import run_of, still
from helpers import ROOT, arm, link, model_of
from PIL import Image, ImageSequence

import screwgen
from screwgen.cli.main import main
from screwgen.viewer.film import Film
from screwgen.viewer.frames import film

SIZE = (480, 360)
MAGNIFIED = 4.0
MARK = 0.15
"""The length of a last link, whose colour no other thing has, m."""
GREEN = (60, 154, 107)


@pytest.fixture(scope="module")
def bent():
    """An arm of second order that swings and bends, with a short link at its tip; 0.3 s of it."""
    first = link("first", axes="y", modes={"bending_y": 2, "bending_z": 1})
    second = link("second", axes="zy", modes={"bending_y": 1, "bending_z": 1})
    model = model_of(arm(first, second, link("mark", MARK, axes=(), section={"EA": 1.0, "EIy": 1.0})) | {"order": 2})
    t = np.linspace(0.0, 0.3, 301)
    random = np.random.default_rng(1)
    sizes = np.where(np.arange(model.nq) < model.chain.eta_q, 0.6, 0.04)
    q = sizes * np.sin(np.outer(t, random.uniform(10, 25, model.nq)) + random.uniform(0, 6, model.nq))
    return model, run_of(model, t, q)


def frames_of(path) -> tuple[list[np.ndarray], list[float]]:
    """The pictures of a GIF, and how long each is shown, ms."""
    with Image.open(path) as image:
        found = [(np.array(x.convert("RGB")), x.info["duration"]) for x in ImageSequence.Iterator(image)]
    return [x for x, _ in found], [x for _, x in found]


def projected(camera, point) -> np.ndarray:
    """Where a point of the inertial frame is seen: a pinhole, told by its angle of view."""
    x, y, z = camera.axes @ (camera.turn @ point - camera.eye)
    return np.array(SIZE) / 2 + np.array([x, -y]) / -z * SIZE[1] / 2 / np.tan(np.radians(16))


def test_tip_is_drawn_where_it_is(bent, tmp_path):
    """In every frame, with the modes magnified; against the model's own pose. The arm is seen to bend."""
    model, run = bent
    count = film(run, path=tmp_path / "run.gif", fps=20, size=SIZE, speed=0.5, magnify=MAGNIFIED)
    pictures, durations = frames_of(tmp_path / "run.gif")
    assert count == len(pictures) == 13 and durations == [50] * 13
    camera = Film([(run, model, "")], SIZE, MAGNIFIED).camera
    bends, free = [], 0
    for k, picture in enumerate(pictures):
        found = np.argwhere(hue(picture))
        assert 50 < len(found) < 640 and picture.shape == (SIZE[1], SIZE[0], 3)
        expected = []
        for factor in (0.0, MAGNIFIED):
            q = run.q[25 * k].copy()
            q[model.chain.eta_q :] *= factor
            R, r = model.numpy().tip_pose(q)
            expected.append(projected(camera, r - MARK / 2 * R[:, 0]))
        place = (found.mean(axis=0) + 0.5)[::-1]
        nearer = camera.axes[2] @ camera.turn @ R[:, 0] > 0.2  # else the link before hides a part
        free += nearer
        seen = projected(camera, r + MARK * camera.turn.T @ camera.axes[0]) - projected(camera, r)
        assert np.linalg.norm(place - expected[1]) < (0.5 if nearer else np.linalg.norm(seen) / 3), k
        bends.append(np.linalg.norm(place - expected[0]))
    assert free >= 4 and max(bends) > 20


def hue(picture: np.ndarray) -> np.ndarray:
    """Where something of the tip's colour is, in any light."""
    x = picture.astype(float)
    share = x / np.maximum(x.max(axis=2, keepdims=True), 1.0)
    return (np.abs(share - np.array(GREEN) / max(GREEN)).max(axis=2) < 0.08) & (x.max(axis=2) > 60)


def test_frames_last_as_long_as_the_run(bent, tmp_path):
    """At rates that a GIF cannot count the sum is right to a hundredth of a second; a longer ghost counts."""
    model, run = bent
    short = run_of(model, run.t[:100], run.q[:100])
    calls = []
    count = film(short, run, path=tmp_path / "x.gif", fps=30, size=(96, 64), progress=lambda *x: calls.append(x))
    _, durations = frames_of(tmp_path / "x.gif")
    assert count == len(durations) == 10 and set(durations) == {30, 40}
    assert sum(durations) == pytest.approx(10 * 1000 / 30, abs=10)
    assert calls == [(k, 10) for k in range(1, 11)]


@pytest.mark.examples
@pytest.mark.parametrize("name", ["space_arm", "gantry", "parallelogram", "finger_on_wall"])
def test_any_robot_is_drawn(name):
    """Bases that float or move, slides and loops: tubes end at the tips that the model says."""
    model = screwgen.derive(screwgen.load(ROOT / "examples" / f"{name}.toml"))
    home = np.array(model.chain.home)
    drawn = Film([(still(model, home), model, name)], (200, 150))
    (actor,) = drawn.actors
    faces = actor.faces(home).reshape(-1, 3)
    _, r = model.numpy().tip_poses(home)
    r = r[[link["radius"] > 0 and not link["in_space"] for link in actor.scene["links"]]]
    nearest = np.linalg.norm(faces[None] - r[:, None], axis=2).min(axis=1)
    assert len(r) and nearest.max() < 1e-6
    assert len(np.unique(drawn.picture(0.5).reshape(-1, 3), axis=0)) > 50


def test_folder_of_pictures(bent, tmp_path, capsys, monkeypatch):
    """By the command; the pictures are numbered, and no folder that holds something is touched."""
    _, run = bent
    run.save(tmp_path / "run.npz")
    given = ["view", str(tmp_path / "run.npz"), "--frames", str(tmp_path / "film"), "--fps", "10", "--size", "120x80"]
    assert main(given) == 0 and capsys.readouterr().out == f"{tmp_path / 'film'}\n"
    assert sorted(os.listdir(tmp_path / "film")) == [f"{k:04}.png" for k in range(1, 5)]
    with Image.open(tmp_path / "film" / "0004.png") as picture:
        assert picture.size == (120, 80)
    assert main(given) == 2 and "is no empty folder" in capsys.readouterr().err
    assert sorted(os.listdir(tmp_path)) == ["film", "run.npz"]
    empty = tmp_path / "empty"
    empty.mkdir(mode=0o700)
    before, replace = empty.stat(), os.replace

    def failing(path, to):
        if path.name == "0003.png":
            raise OSError("the disk is gone")
        replace(path, to)

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", failing)
        assert main([*given[:3], str(empty), *given[4:]]) == 2 and "the disk is gone" in capsys.readouterr().err
    assert not os.listdir(empty)
    assert main([*given[:3], str(empty), *given[4:]]) == 0 and len(os.listdir(empty)) == 4
    assert (empty.stat().st_ino, empty.stat().st_mode) == (before.st_ino, before.st_mode)


def test_refusals(bent, tmp_path, capsys, monkeypatch):
    """One line each, and nothing is left of the work."""
    _, run = bent
    run.save(tmp_path / "run.npz")
    broken, none = tmp_path / "broken", tmp_path / "none"
    for folder in (broken, none):
        folder.mkdir()
    (broken / "ffmpeg").write_text("#!/bin/sh\necho no encoder >&2\nexit 3\n")
    (broken / "ffmpeg").chmod(0o755)
    before = sorted(os.listdir(tmp_path))
    monkeypatch.setenv("PATH", str(none))
    for arguments, said in [
        ((), "there is nothing to write"),
        (("-o", "x.html", "--speed", "2"), "--speed: is of films; add --frames run.gif"),
        (("--frames", ""), "'' is no name of a film"),
        (("--frames", ".gif"), "'.gif' is no name of a film"),
        (("--frames", "x." + 300 * "x" + "/y"), "cannot be written"),
        (("--frames", "x.avi"), "must end in .gif or .mp4, or have none: a folder"),
        (("--frames", "x.mp4"), "needs ffmpeg, which is not there; install it, or write a .gif"),
        (("--frames", "no/x.gif"), "its folder does not exist"),
        (("--frames", "no/x"), "cannot be written"),
        (("--frames", "x.gif", "--fps", "60"), "a GIF plays at most 50"),
        (("--frames", "x.gif", "--fps", "nan"), "fps: is nan; it must be from 0.1 to 120"),
        (("--frames", "x.gif", "--speed", "0.0001", "--fps", "50"), "would have 150001 frames; at most 20000"),
        (("--frames", "x.gif", "--speed", "0.001", "--fps", "50"), "are too much for a GIF"),
        (("--frames", "x.gif", "--size", "800"), "--size: is 800; it must be width x height"),
        (("--frames", "x.gif", "--size", "8x8"), "both must be from 64 to 4096 pixels"),
        (("--frames", "x.gif", "--magnify", "-1"), "magnify: is -1"),
    ]:
        given = [str(tmp_path / x) if x.startswith(("x.", "no/")) else x for x in arguments]
        assert main(["view", str(tmp_path / "run.npz"), *given]) == 2
        error = capsys.readouterr().err
        assert said in error and error.count("\n") == 1
    monkeypatch.setenv("PATH", f"{broken}:/usr/bin:/bin")
    mp4 = ["--frames", str(tmp_path / "x.mp4"), "--fps", "10"]
    assert main(["view", str(tmp_path / "run.npz"), *mp4, "--size", "101x80"]) == 2
    assert "an MP4 needs even numbers" in capsys.readouterr().err
    assert main(["view", str(tmp_path / "run.npz"), *mp4, "--size", "100x80"]) == 2
    assert "ffmpeg failed (no encoder)" in capsys.readouterr().err
    assert sorted(os.listdir(tmp_path)) == before


@pytest.mark.examples
def test_mp4_holds_the_frames(bent, tmp_path):
    """Read back by ffmpeg; the pictures are those of the film, but for what the codec loses."""
    program, (model, run) = require_tool("ffmpeg"), bent
    film(run, path=tmp_path / "run.mp4", fps=10, size=SIZE)
    raw = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    read = subprocess.run(
        [program, "-loglevel", "error", "-i", tmp_path / "run.mp4", *raw], check=True, capture_output=True
    )
    pictures = np.frombuffer(read.stdout, np.uint8).reshape(-1, SIZE[1], SIZE[0], 3)
    drawn = Film([(run, model, "run 1")], SIZE)
    assert len(pictures) == 4
    for k, picture in enumerate(pictures):
        assert np.abs(picture.astype(int) - drawn.picture(0.1 * k)).mean() < 3
