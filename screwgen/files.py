"""Safe file access: a file that is read must be regular, a file that is created must not exist yet.

Arrays in NumPy's formats are read as untrusted: their sizes are known, and bounded, before any of them is unpacked.
"""

from __future__ import annotations

import io
import math
import os
import stat
import struct
import tokenize
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import IO, Any, BinaryIO, NamedTuple

import numpy as np

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


# ------------------------------------------------------------------------------ arrays

MAX_BYTES = 4 * 2**30
"""The most that the arrays of a file may take."""
SPARE, PACKED = 64 * 2**20, 100
"""What packed members may unpack to: so many bytes, and so many times the size of the file."""
MOST_MEMBERS, ENTRY = 10_000, 46
"""Members of a .npz file at most, and the least bytes of one in the file's directory."""
PIECE = 2**22
"""Bytes that are unpacked at once."""
LARGEST = 1e30
"""A number of a file beyond this measures nothing, and its powers overflow."""
KINDS = "biufcU"
"""Of NumPy's types, those that are read: booleans, numbers and text."""
DAMAGE = (
    ArithmeticError,
    EOFError,
    LookupError,
    NotImplementedError,
    OSError,
    RecursionError,
    RuntimeError,
    SyntaxError,
    TypeError,
    ValueError,
    struct.error,
    tokenize.TokenError,
    zipfile.BadZipFile,
    zlib.error,
)
"""What NumPy and zipfile raise on bytes that are not what they should be."""


class ArrayFileError(ValueError):
    """An .npz or .npy file that is damaged, too large, or none; the text says what is wrong, without the file."""


class Header(NamedTuple):
    """What a .npy file says about its array."""

    shape: tuple[int, ...]
    fortran: bool
    dtype: np.dtype

    @property
    def size(self) -> int:
        """The bytes of the array."""
        return math.prod(self.shape) * self.dtype.itemsize

    def array(self, content: bytearray) -> np.ndarray:
        """The array in these bytes."""
        if self.dtype.kind == "U":
            _check_letters(np.frombuffer(content, self.dtype.byteorder.replace("|", "=") + "u4"))
        return np.frombuffer(content, self.dtype).reshape(self.shape, order="F" if self.fortran else "C")


class Arrays:
    """The arrays of an open .npz file, each read when it is asked for: ``name in arrays``, ``arrays[name]``.

    Raises ArrayFileError.
    """

    def __init__(self, file: zipfile.ZipFile, size: int):
        self._file, self._size, self._left = file, size, SPARE + PACKED * size
        self._members = {info.filename.removesuffix(".npy"): info for info in file.infolist()}
        if (total := sum(info.file_size for info in self._members.values())) > MAX_BYTES:
            raise ArrayFileError(f"its arrays would take {_gigabytes(total)}; at most {_gigabytes(MAX_BYTES)} are read")

    def __iter__(self) -> Iterator[str]:
        return iter(self._members)

    def __contains__(self, name: str) -> bool:
        return name in self._members

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self._members:
            raise ArrayFileError(f"it has no '{name}'")
        info = self._members[name]
        if info.flag_bits & 1:
            raise ArrayFileError(f"'{name}' is encrypted; store it without a password")
        if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise ArrayFileError(f"'{name}' is packed in an unusual way; write it with numpy.savez")
        self._account(name, info)
        with _damage_in(f"'{name}'"), self._file.open(info) as stream:
            header = _header(stream)
            if (there := info.file_size - stream.tell()) != header.size:
                raise ArrayFileError(f"its header promises {header.size} bytes, but there are {there}")
            return header.array(_exactly(stream, header.size))

    def numbers(self, name: str) -> np.ndarray:
        """An array of numbers in double precision."""
        found = self[name]
        if found.dtype.kind not in "biuf":
            raise ArrayFileError(f"'{name}' holds {found.dtype}; it must hold numbers")
        with np.errstate(over="ignore"):
            return found.astype(float)

    def texts(self, name: str) -> tuple[str, ...]:
        """The words of a list, or the only one."""
        found = self[name]
        if found.dtype.kind != "U" or found.ndim > 1:
            raise ArrayFileError(f"'{name}' has the shape {found.shape} of {found.dtype}; it must be a list of text")
        return tuple(map(str, found.reshape(-1)))

    def _account(self, name: str, info: zipfile.ZipInfo) -> None:
        """Refuse a member that unpacks to far more than a file of this size holds."""
        if info.compress_type == zipfile.ZIP_DEFLATED:
            self._left -= info.file_size
        elif info.file_size != info.compress_size or info.file_size > self._size:
            raise ArrayFileError(f"'{name}' is damaged: its sizes contradict each other")
        if self._left < 0:
            said = f"would unpack to {_gigabytes(info.file_size)}, too much for a file of this size"
            raise ArrayFileError(f"'{name}' {said}; write it with numpy.savez")


@contextmanager
def open_arrays(path: str | os.PathLike[str]) -> Iterator[Arrays]:
    """The arrays of the .npz file at `path`; raises ArrayFileError, OSError where the file cannot be opened."""
    with open_regular(path) as stream:
        if not stream.seekable():
            stream = io.BytesIO(stream.read(MAX_BYTES + 1))
        size = stream.seek(0, os.SEEK_END)
        if size > MAX_BYTES:
            raise ArrayFileError(f"it has {_gigabytes(size)}; at most {_gigabytes(MAX_BYTES)} are read")
        with _damage_in("it"):
            _check_directory(stream, size)
            file = zipfile.ZipFile(stream)
        with file:
            yield Arrays(file, size)


def mapped_array(path: str | os.PathLike[str]) -> np.memmap:
    """The array of the .npy file at `path`, which stays in the file; raises ArrayFileError and OSError."""
    with open_regular(path) as stream, _damage_in("it"):
        header = _header(stream)
        start, there = stream.tell(), os.fstat(stream.fileno()).st_size - stream.tell()
        if there < header.size:
            raise ArrayFileError(f"its header promises {header.size} bytes, but there are {there}")
        order: Any = "F" if header.fortran else "C"
        return np.memmap(stream, header.dtype, "r", start, header.shape, order)


def sound(values: np.ndarray) -> bool:
    """Whether all numbers are finite, and none is beyond what measures anything."""
    with np.errstate(over="ignore"):
        return bool((np.abs(values.astype(float)) < LARGEST).all())


def _exactly(stream: IO[bytes], size: int) -> bytearray:
    """So many bytes, read in pieces."""
    out, at = bytearray(size), 0
    while piece := stream.read(min(PIECE, size - at + 1)):
        out[at : at + len(piece)] = piece
        at += len(piece)
    if at != size:
        raise EOFError("it is cut off")
    return out


def _header(stream: IO[bytes]) -> Header:
    """What stands at the head of an array; the stream is then at its first byte."""
    readers = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}
    version = np.lib.format.read_magic(stream)
    if version not in readers:
        raise ArrayFileError(f"its format {version[0]}.{version[1]} is unknown")
    try:
        shape, fortran, dtype = readers[version](stream)
    except MemoryError:
        raise ArrayFileError("its header is nested too deeply") from None
    if dtype.kind not in KINDS or not dtype.itemsize:
        raise ArrayFileError("it holds neither numbers nor text")
    if min(shape, default=0) < 0:
        raise ArrayFileError(f"it has the shape {shape}")
    return Header(shape, fortran, dtype)


def _check_directory(stream: BinaryIO, size: int) -> None:
    """Refuse a file that is no .npz file, and one whose directory alone would fill the memory."""
    stream.seek(0)
    if stream.read(6) == np.lib.format.MAGIC_PREFIX:
        raise ArrayFileError("it is a single array, no .npz file")
    stream.seek(max(0, size - 2**16 - 22))
    end = stream.read()
    at = end.rfind(b"PK\5\6")
    if at < 0:
        raise ArrayFileError("it is no .npz file, or is cut off")
    (members,) = struct.unpack_from("<H", end, at + 10)
    (directory,) = struct.unpack_from("<I", end, at + 12)
    if max(members, directory // (ENTRY * 10)) > MOST_MEMBERS:
        raise ArrayFileError(f"it has more than {MOST_MEMBERS} members")


def _check_letters(codes: np.ndarray) -> None:
    """Refuse numbers that are no letters of Unicode."""
    if ((codes > 0x10FFFF) | (codes >= 0xD800) & (codes < 0xE000)).any():
        raise ArrayFileError("its text is damaged")


@contextmanager
def _damage_in(what: str) -> Iterator[None]:
    """Turns what the readers of NumPy and zipfile raise on damaged bytes into an ArrayFileError about `what`."""
    try:
        yield
    except ArrayFileError as error:
        reason = str(error)
        raise ArrayFileError(reason if what == "it" else f"{what}: {reason}") from None
    except DAMAGE as error:
        reason = " ".join(str(error).split())[:120]
        raise ArrayFileError(f"{what} is damaged ({reason or type(error).__name__})") from None


def _gigabytes(size: int) -> str:
    return f"{size / 1e9:.3g} GB"
