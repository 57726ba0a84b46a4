"""Mode shapes against the oracle, and their picture."""

import numpy as np
import pytest
import random_robots as rr
from helpers import arm, example, link, model_of

from screwgen import UsageError
from screwgen.cli import main
from screwgen.look import view
from screwgen.mode_plot import STATIONS, TURN, amplified, field, figure, meaning, png, sections
from screwgen.modes import mode_shapes, natural_frequencies
from screwgen.motion import centrelines

SETPOINTS = [-0.4928, 0.6922, 0.4270]


def posture(model, joints=SETPOINTS):
    return np.append(joints, np.zeros(model.nq - len(joints)))


@pytest.mark.parametrize("seed", range(3))
def test_shapes_solve_the_eigenvalue_problem_of_the_oracle(seed):
    """`K φ = ω² M φ` for what moves, with unit modal mass; the oracle's M and K."""
    robot, state, oracle = rr.draw_regular(np.random.default_rng(seed), limit=1e6, max_links=2)
    model, q = model_of(robot), state["q"]
    for joints, first in (("locked", oracle.n_joint), ("free", 0)):
        found, moving = mode_shapes(model, q, joints), slice(first, None)
        M, K, phi = oracle.mass_matrix(q)[moving, moving], oracle.K[moving, moving], found.shapes[moving]
        assert not found.shapes[:first].any() and len(found.frequencies) + found.rigid == len(M)
        assert np.allclose(phi.T @ M @ phi, np.eye(phi.shape[1]), atol=1e-9)
        left, right = K @ phi, M @ phi * (2 * np.pi * found.frequencies) ** 2
        assert np.allclose(left, right, atol=1e-8 * np.abs(left).max(initial=1e-300))
        assert np.array_equal(
            np.append(np.zeros(found.rigid), found.frequencies), natural_frequencies(model, q, joints)
        )


def test_centrelines_run_from_joint_to_tip():
    model = example("six_link")
    q = np.random.default_rng(0).uniform(-0.5, 0.5, model.nq) * np.where(np.arange(model.nq) < 6, 1.0, 0.02)
    lines, tips = centrelines(model, q, STATIONS), model.numpy().tip_poses(q)[1]
    assert lines.shape == (6, len(STATIONS), 3) and np.allclose(lines[:, -1], tips, atol=1e-12)
    straight = centrelines(model, posture(model, [0.3] * 6), STATIONS)
    lengths = np.linalg.norm(np.diff(straight, axis=1), axis=2).sum(axis=1)
    assert np.allclose(lengths, [x.length for x in model.robot.links])


def test_the_field_is_the_clamped_beams():
    """One beam, bending in y: its first mode is the basis's first shape, however large; at mid-length 0.3395."""
    soft = link("beam", 2.0, [], modes={"bending_y": 3}, section={"EIz": 50.0})
    model = model_of(arm(soft, gravity=(0, 0, 0)))
    q, found = np.zeros(model.nq), mode_shapes(model)
    motion = field(model, q, found.shapes[:, 0]).motion[0]
    assert not motion[:, [0, 2]].any() and not motion[0].any()
    share = motion[:, 1] / motion[-1, 1]
    assert abs(share[len(STATIONS) // 2] - 0.3395) < 1e-4 and (np.diff(share) > 0).all()
    drawn = amplified(centrelines(model, q, STATIONS), field(model, q, -7 * found.shapes[:, 0])).motion
    assert np.allclose(drawn[0, -1], [0, 0.15 * 2.0, 0], atol=1e-9)


def test_the_view_shows_the_motion():
    line = np.linspace([0, 0, 0], [1, 0, 0], 9)[None]
    up, sideways = (np.linspace(0, 1, 9)[None, :, None] * np.eye(3)[k] for k in (2, 1))
    assert view(line, up)[0] < 30 < view(line, sideways)[0]


def test_words_say_where_the_energy_is():
    model = example("ella")
    found = mode_shapes(model, posture(model))
    assert meaning(model, found.shapes[:, 0]).startswith("bending in z of upper_arm, 9")
    sprung = model_of(arm(link("rod", axes="z", joint={"stiffness": [5.0]})))
    assert meaning(sprung, np.ones(1)) == "joint spring of rod, 100 % of its energy"


@pytest.mark.parametrize("joints", ["locked", "free"])
def test_picture(joints):
    model = example("ella")
    q = posture(model)
    found = mode_shapes(model, q, joints)
    picture = figure(model, q, found)
    titles = [text.get_text() for text in picture.texts if text.get_text().endswith(" Hz")]
    assert titles == [f"{k + 1}: {f:.4g} Hz" for k, f in enumerate(found.frequencies[:6])]
    assert len(picture.axes) == len(titles)
    assert png(model, q, found) == png(model, q, found)


def test_command_draws_and_prints(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "rod.toml").write_text(rr.to_toml(arm(link("rod", modes={"bending_y": 1}))))
    assert main(["modes", "rod.toml", "--plot", "rod.png"]) == 0
    out = capsys.readouterr()
    assert out.err == "" and out.out.count(" Hz") == 1 and (tmp_path / "rod.png").read_bytes().startswith(b"\x89PNG")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["rod.png", "rod.toml"]


def test_without_modes_there_is_nothing_to_draw():
    model = model_of(arm(link("rod")))
    with pytest.raises(UsageError, match="no modes to draw"):
        figure(model, np.zeros(1), mode_shapes(model))
