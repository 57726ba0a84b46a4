"""Work that a second process does while this one does something else.

An example: `screwgen generate` writes a robot's documents beside its C. The second process is a copy of this one, so it
has the derived robot already. Where there is no second core, where the system cannot copy a process, or where threads
run whose locks a copy would keep, this process does the work itself when the result is asked for.
"""

from __future__ import annotations

import os
import pickle
import signal
import sys
import threading
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import NoReturn, TypeVar

_T = TypeVar("_T")

WITH_THREADS = ("jax", "torch", "tensorflow")
"""Packages that start threads of their own which a copied process lacks."""


@contextmanager
def beside(work: Callable[[], _T]) -> Iterator[Callable[[], _T]]:
    """What gives the result of ``work``, on which a second process is at work from here on, where there may be one."""
    if not _can_copy():
        yield work
        return
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        _work(work, reading, writing)
    os.close(writing)
    with open(reading, "rb") as results:
        try:
            yield lambda: _received(results.read(), work)
        finally:
            with suppress(ProcessLookupError):
                os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)


def _can_copy() -> bool:
    quiet = threading.active_count() == 1 and not any(name in sys.modules for name in WITH_THREADS)
    return sys.platform == "linux" and quiet and len(os.sched_getaffinity(0)) > 1


def _work(work: Callable[[], object], reading: int, writing: int) -> NoReturn:
    """The second process: sends what the work gives, with its warnings; nothing where it fails."""
    status = 1
    try:
        os.close(reading)
        with open(writing, "wb") as results, warnings.catch_warnings(record=True, action="always") as noted:
            done = work()
            results.write(pickle.dumps((done, [note.message for note in noted])))
        status = 0
    finally:
        os._exit(status)


def _received(sent: bytes, work: Callable[[], _T]) -> _T:
    """The result that was sent; where the second process failed or was killed, that of one's own, or its error."""
    try:
        done, noted = pickle.loads(sent)
    except (EOFError, pickle.UnpicklingError):
        return work()
    for note in noted:
        warnings.warn(note, stacklevel=2)
    return done
