"""Unfinished files and folders: they stand beside their place until they are whole, and whoever writes them locks them.

The system takes the lock of a process back when that is killed. So the next one knows that nobody writes a leftover any
more, and removes it. Where there are no locks a leftover is removed when it is a day old.
"""

from __future__ import annotations

import os
import secrets
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from glob import escape
from pathlib import Path
from typing import BinaryIO

from .files import create

try:
    import fcntl
except ImportError:  # not on Windows
    fcntl = None  # type: ignore[assignment]

ABANDONED = 24 * 3600.0
"""Age in s at which a leftover belongs to nobody where the system has no locks."""
DIGITS = 8
"""Random digits in the name of what is unfinished."""
LETTERS = 40
"""The most letters of its own name there, so that the whole is never too long for a file system."""


def part_of(target: Path, folder: Path | None = None) -> Path:
    """A new name for what is to become `target`, beside it or in a `folder`."""
    part = f".{target.name[:LETTERS]}.{secrets.token_hex(DIGITS // 2)}.part"
    return (folder or target.parent) / part


def remove_parts(target: Path, folder: Path | None = None) -> None:
    """Remove what killed processes left of `target`."""
    for left in (folder or target.parent).glob(f".{escape(target.name[:LETTERS])}.{'[0-9a-f]' * DIGITS}.part"):
        remove_if_abandoned(left)


def remove_if_abandoned(path: Path) -> None:
    """Remove an unfinished file or folder that nobody writes any more."""
    with suppress(OSError), abandoned(path) as left:
        if left and path.is_dir():
            shutil.rmtree(path)
        elif left:
            path.unlink()


@contextmanager
def abandoned(path: Path) -> Iterator[bool]:
    """Whether nobody writes an unfinished file or folder any more; it stays so within the context. Raises OSError."""
    file = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
    try:
        old = time.time() - os.fstat(file).st_mtime > ABANDONED
        yield (_lock(file) if fcntl is not None else old) and _is_at(file, path)
    finally:
        os.close(file)


def claimed(path: Path, like: str | os.PathLike[str]) -> BinaryIO:
    """A new file, as :func:`.files.create` makes it, locked; made again if another process took it for a leftover."""
    while True:
        stream = create(path, like)
        _lock(stream.fileno())
        if _is_at(stream.fileno(), path):
            return stream
        stream.close()


@contextmanager
def claimed_folder(path: Path, mode: int = 0o777) -> Iterator[None]:
    """A new folder at `path`, locked while the context lasts."""
    while True:
        path.mkdir(mode=mode)
        if fcntl is None:
            yield
            return
        with suppress(FileNotFoundError):
            file = os.open(path, os.O_RDONLY)
            _lock(file)
            if _is_at(file, path):
                break
            os.close(file)
    try:
        yield
    finally:
        os.close(file)


def _is_at(file: int, path: Path) -> bool:
    """Whether an open file or folder still stands at `path`."""
    with suppress(FileNotFoundError):
        return os.path.samestat(os.fstat(file), os.stat(path))
    return False


def _lock(file: int) -> bool:
    """Lock an open file or folder until it is closed; False where another process has it, or where it cannot be."""
    try:
        if fcntl is not None:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return True
    except OSError:
        pass
    return False
