"""Output for the user: progress on a terminal's stderr, file names on stdout."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager

from ..interchange.load import import_urdf, is_urdf
from ..spec.advice import advice
from ..spec.load import load, one_line
from ..spec.robot import Robot


def say(text: str, quiet: bool) -> None:
    """A summary on stdout."""
    if text and not quiet:
        print(text)


def load_robot(path: str, quiet: bool = False) -> Robot:
    """The robot in a file, with notes on stderr: what of a URDF is left out, and probable mistakes."""
    found = import_urdf(path) if is_urdf(path) else None
    robot = found.robot if found else load(path)
    notes(path, (*(found.notes if found else ()), *advice(robot)), quiet)
    return robot


def notes(path: str, lines: Iterable[str], quiet: bool) -> None:
    """Notes on a file, on stderr."""
    for line in () if quiet else lines:
        print(f"screwgen: note: {one_line(path)}: {line}", file=sys.stderr)


def shows_progress(quiet: bool) -> bool:
    """Whether somebody watches."""
    return not quiet and sys.stderr is not None and sys.stderr.isatty()


@contextmanager
def busy(what: str, quiet: bool) -> Iterator[None]:
    """A spinner, while work of unknown length is done."""
    if not shows_progress(quiet):
        yield
        return
    from rich.console import Console

    with Console(stderr=True).status(what):
        yield


@contextmanager
def bar(what: str, total: int, quiet: bool) -> Iterator[Callable[[int, int], None] | None]:
    """A progress bar, as the function `(done, total)` to call; None if stderr is no terminal."""
    if not shows_progress(quiet):
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task(what, total=total)
        yield lambda done, whole: progress.update(task, completed=done, total=whole)
