"""Films of runs: an animated GIF, an MP4 by ffmpeg, or a folder of PNG pictures; whole, or not at all."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import BinaryIO

import numpy as np
from PIL import Image

from ..errors import UsageError
from ..simulation.runs import Run, check_output, outputs, suffix, unwritable
from ..spec.load import one_line
from ..spec.robot import Robot
from ..unfinished import claimed_folder, part_of, remove_parts
from .film import Film
from .meshes import Looks
from .view import modelled, worn

FILMS = (".gif", ".mp4")
SIDES, RATES, SPEEDS, MAGNIFIED = (64, 4096), (0.1, 120.0), (1e-4, 1e4), (0.0, 1e4)
GIF_RATE = 50.0
"""Frames per second of a GIF at most: it counts in hundredths of a second, and browsers play single ones slowly."""
MOST_FRAMES, MOST_PIXELS = 20_000, 600_000_000
"""Of a film, and of all frames of a GIF, which are held in memory."""
LOOKED_AT = 6
"""Frames from which the colours of a GIF are chosen."""
Progress = Callable[[int, int], None]


def film(
    *runs: Run,
    path: str | os.PathLike[str],
    robot: Robot | None = None,
    labels: Sequence[str] = (),
    fps: float = 25.0,
    size: tuple[int, int] = (800, 600),
    speed: float = 1.0,
    magnify: float = 1.0,
    meshes: str | os.PathLike[str] | Looks | None = None,
    progress: Progress | None = None,
) -> int:
    """Write a run as a film, a second one as its ghost: a .gif, an .mp4, or a folder of .png; returns how many frames.

    `fps`: frames per second; `size`: width and height, pixels; `speed`: seconds of the run in a second of the film;
    `magnify`: factor of the modes; `progress`: is called with the frames done and all; the rest as of
    :func:`screwgen.view`. Raises UsageError.
    """
    kind, shown = suffix(path), one_line(os.fsdecode(path))
    for name, value, (low, high) in [("fps", fps, RATES), ("speed", speed, SPEEDS), ("magnify", magnify, MAGNIFIED)]:
        if not low <= value <= high:
            raise UsageError(f"{name}: is {value:g}; it must be from {low:g} to {high:g}")
    for side in size:
        if not SIDES[0] <= side <= SIDES[1]:
            raise UsageError(f"size: is {size[0]}x{size[1]}; both must be from {SIDES[0]} to {SIDES[1]} pixels")
    if not shown or os.path.basename(shown).lower() in FILMS:
        raise UsageError(f"'{shown}' is no name of a film; name one such as run.gif, or a folder")
    if kind in FILMS:
        check_output(path, FILMS)
    elif kind:
        raise UsageError(f"{shown}: has an unknown suffix; it must end in {' or '.join(FILMS)}, or have none: a folder")
    found = modelled(runs, robot, labels)
    first, last = min(run.t[0] for run in runs), max(run.t[-1] for run in runs)
    count = int(np.floor((last - first) / speed * fps * (1 + 1e-12))) + 1
    _refuse(kind, shown, fps, size, count)
    drawn = Film(found, size, magnify, worn(meshes))
    times = first + np.arange(count) * speed / fps
    pictures = _counted((drawn.picture(float(t)) for t in times), count, progress)
    if kind == ".gif":
        palette = _palette(drawn, [drawn.picture(float(t)) for t in times[:: -(-count // LOOKED_AT)]])
        with outputs(path) as (stream,):
            _gif(stream, pictures, count, fps, palette)
    elif kind == ".mp4":
        with tempfile.TemporaryDirectory() as folder, outputs(path) as (stream,):
            _mp4(Path(folder) / "film.mp4", pictures, fps, size, shown)
            with open(Path(folder) / "film.mp4", "rb") as made:
                shutil.copyfileobj(made, stream)
    else:
        _folder(Path(os.path.realpath(path)), pictures, shown)
    return count


def read_size(text: str) -> tuple[int, int]:
    """The width and height that `text` states, 800x600."""
    if not (found := re.fullmatch(r"(\d{1,5})x(\d{1,5})", text)):
        raise UsageError(f"--size: is {one_line(text)}; it must be width x height in pixels, 800x600")
    return int(found[1]), int(found[2])


def _refuse(kind: str, shown: str, fps: float, size: tuple[int, int], count: int) -> None:
    less = "give a higher speed, or a lower fps"
    if count > MOST_FRAMES:
        raise UsageError(f"{shown}: would have {count} frames; at most {MOST_FRAMES}: {less}")
    if kind == ".gif" and fps > GIF_RATE:
        raise UsageError(f"{shown}: fps is {fps:g}; a GIF plays at most {GIF_RATE:g}: give less, or an .mp4")
    if kind == ".gif" and count * size[0] * size[1] > MOST_PIXELS:
        raise UsageError(f"{shown}: {count} frames of {size[0]}x{size[1]} are too much for a GIF; {less}, or an .mp4")
    if kind == ".mp4" and shutil.which("ffmpeg") is None:
        raise UsageError(f"{shown}: needs ffmpeg, which is not there; install it, or write a .gif or a folder of .png")
    if kind == ".mp4" and any(side % 2 for side in size):
        raise UsageError(f"{shown}: size is {size[0]}x{size[1]}; an MP4 needs even numbers")


def _counted(pictures: Iterator[np.ndarray], count: int, progress: Progress | None) -> Iterator[np.ndarray]:
    for k, picture in enumerate(pictures):
        yield picture
        if progress is not None:
            progress(k + 1, count)


def _palette(drawn: Film, pictures: list[np.ndarray]) -> Image.Image:
    """256 colours for all frames, so that what does not move does not flicker; small things keep theirs."""
    own = drawn.shades()[:128]
    found = Image.fromarray(np.concatenate(pictures)).quantize(256 - len(own)).getpalette() or []
    out = Image.new("P", (1, 1))
    out.putpalette(found[: 3 * (256 - len(own))] + own.ravel().tolist())
    return out


def _gif(stream: BinaryIO, pictures: Iterator[np.ndarray], count: int, fps: float, palette: Image.Image) -> None:
    """Each frame lasts whole hundredths of a second; their sum is right to one of them."""
    until = np.rint(100 * np.arange(count + 1) / fps).astype(int)
    frames = (Image.fromarray(x).quantize(palette=palette, dither=Image.Dither.NONE) for x in pictures)
    options = dict(duration=(10 * np.diff(until)).tolist(), loop=0, optimize=False, disposal=1)
    next(frames).save(stream, format="GIF", save_all=True, append_images=frames, **options)


def _mp4(made: Path, pictures: Iterator[np.ndarray], fps: float, size: tuple[int, int], shown: str) -> None:
    given = f"-f rawvideo -pix_fmt rgb24 -s {size[0]}x{size[1]} -r {fps:.6g} -i -".split()
    coded = "-an -c:v libx264 -crf 20 -pix_fmt yuv420p -movflags +faststart".split()
    command = ["ffmpeg", "-loglevel", "error", *given, *coded, str(made)]
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=said)
        assert process.stdin is not None
        try:
            for picture in pictures:
                process.stdin.write(picture.tobytes())
            process.stdin.close()
        except BrokenPipeError:
            pass
        except BaseException:
            process.kill()
            raise
        finally:
            status = process.wait()
        if status or not made.exists():
            said.seek(0)
            reason = one_line(said.read().decode(errors="replace").strip()) or f"status {status}"
            raise UsageError(f"{shown}: ffmpeg failed ({reason}); write a .gif or a folder of .png")


def _folder(target: Path, pictures: Iterator[np.ndarray], shown: str) -> None:
    """A folder 0001.png, 0002.png, …; a new one, or one that is empty, which then stays the same folder."""
    try:
        there = target.exists()
        beside = target if there else target.parent
        remove_parts(target, beside)
        if there and (not target.is_dir() or any(target.iterdir())):
            raise UsageError(f"{shown}: is there, and is no empty folder; name a new one")
    except OSError as error:
        raise unwritable(shown, error) from None
    part = part_of(target, beside)
    try:
        with claimed_folder(part):
            _fill(part, pictures)
            if not there:
                os.replace(part, target)
            else:
                _move_all(part, target)
    except OSError as error:
        raise unwritable(shown, error) from None
    finally:
        shutil.rmtree(part, ignore_errors=True)


def _fill(folder: Path, pictures: Iterator[np.ndarray]) -> None:
    for k, picture in enumerate(pictures):
        Image.fromarray(picture).save(folder / f"{k + 1:04}.png")


def _move_all(folder: Path, target: Path) -> None:
    """Move the files of a folder into another one, all of them or none."""
    names = sorted(os.listdir(folder))
    try:
        for name in names:
            os.replace(folder / name, target / name)
    except BaseException:
        for name in names:
            (target / name).unlink(missing_ok=True)
        raise
