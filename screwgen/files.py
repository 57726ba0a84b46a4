"""Safe file access: a file that is read must be regular, a file that is created must not exist yet."""

from __future__ import annotations

import os
import stat
from typing import BinaryIO

HANDED = ("/dev/stdin", "/dev/fd/")
"""Names of files that are already open in this process, such as a pipe of the shell."""


class NotRegularError(OSError):
    """A pipe, a socket or a device in the place of a file."""


def open_regular(path: str | os.PathLike[str]) -> BinaryIO:
    """The file at `path`, to be read; raises OSError, NotRegularError for a pipe that nobody may ever write to."""
    if os.fsdecode(path).startswith(HANDED):
        return open(path, "rb")
    without_waiting = lambda name, flags: os.open(name, flags | getattr(os, "O_NONBLOCK", 0))  # noqa: E731
    stream = open(path, "rb", opener=without_waiting)  # noqa: SIM115
    if not stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
        stream.close()
        raise NotRegularError("is not a regular file")
    return stream


def create(path: str | os.PathLike[str], like: str | os.PathLike[str]) -> BinaryIO:
    """A new file at `path`, to be written and read, with the mode of `like` where that is there.

    Whatever is at `path`, be it a link that leads nowhere, is left alone: raises FileExistsError.
    """
    mode = stat.S_IMODE(os.stat(like).st_mode) if os.path.exists(like) else None
    rights = 0o666 if mode is None else mode & 0o600
    stream = open(path, "x+b", opener=lambda name, flags: os.open(name, flags, rights))  # noqa: SIM115
    if mode is not None:
        os.chmod(stream.fileno(), mode)
    return stream
