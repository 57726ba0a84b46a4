"""Progress of long work, on a terminal's stderr alone."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager


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
def told(what: str, quiet: bool) -> Iterator[Callable[[str], None] | None]:
    """A spinner, as the function to call with a line that says how far the work is; None if stderr is no terminal."""
    if not shows_progress(quiet):
        yield None
        return
    from rich.console import Console

    with Console(stderr=True).status(what) as status:
        yield lambda line: status.update(f"{what}: {line}")


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
