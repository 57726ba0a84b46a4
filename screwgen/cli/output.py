"""Output for the user: notes on stderr, file names on stdout."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager

from ..errors import StoppedError
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


@contextmanager
def stoppable() -> Iterator[None]:
    """An interruption whose text names the remaining results becomes an error with that text."""
    try:
        yield
    except KeyboardInterrupt as interruption:
        if not interruption.args:
            raise
        raise StoppedError(str(interruption)) from None
