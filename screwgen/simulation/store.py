"""The files of a sweep: values, statuses, and the manifest of the chunks that are done."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, BinaryIO, Protocol

import numpy as np

from ..errors import UsageError
from ..files import create, mapped_array, open_regular
from .zarr_rows import Zarr


class RowStore(Protocol):
    """How a format keeps two tables with a row per scenario, values and statuses; `paths` are what it makes."""

    paths: tuple[Path, ...]
    manifest: Path

    def __init__(self, path: Path, count: int, chunk: int): ...
    def create(self, values: np.ndarray, status: np.ndarray) -> None:
        """Make the tables for rows like those of a first chunk, and open them for writing."""

    def open(self) -> None:
        """Open the tables of a stopped sweep for writing."""

    def complete(self, chunks: set[int]) -> bool:
        """Whether the open tables hold these chunks; a file that was lost holds none."""

    def write(self, k: int, values: np.ndarray, status: np.ndarray) -> None:
        """The rows of chunk k; they are in the file when this returns."""

    def close(self) -> None: ...
    def remove(self) -> None:
        """Remove what is there of tables in which no chunk is done."""

    def result(self) -> tuple[Any, np.ndarray]:
        """Both tables, for reading; raises OSError, ValueError, KeyError."""


class Npy:
    """``NAME.npy`` and ``NAME.status.npy``. Rows are written, not mapped: a mapping would count as memory."""

    def __init__(self, path: Path, count: int, chunk: int):
        self.paths: tuple[Path, ...] = path, path.with_suffix(".status.npy")
        self.manifest = path.with_suffix(".chunks")
        self._count, self._chunk = count, chunk
        self._files: list[tuple[BinaryIO, int]] = []

    def create(self, values: np.ndarray, status: np.ndarray) -> None:
        for path, like in zip(self.paths, (values, status), strict=True):
            file, shape = create(path, path), (self._count, *like.shape[1:])
            header = {"descr": like.dtype.str, "fortran_order": False, "shape": shape}
            np.lib.format.write_array_header_1_0(file, header)
            start = file.tell()
            file.truncate(start + like[:1].nbytes * self._count)
            self._files.append((file, start))

    def open(self) -> None:
        for path, rows in zip(self.paths, self.result(), strict=True):
            self._files.append((open(path, "r+b"), rows.offset))  # noqa: SIM115

    def complete(self, chunks: set[int]) -> bool:
        return True  # a file that is too short is not mapped

    def write(self, k: int, values: np.ndarray, status: np.ndarray) -> None:
        for (file, start), rows in zip(self._files, (values, status), strict=True):
            file.seek(start + k * self._chunk * rows[:1].nbytes)
            file.write(np.ascontiguousarray(rows).tobytes())
            file.flush()

    def close(self) -> None:
        for file, _ in self._files:
            file.close()

    def remove(self) -> None:
        for path in self.paths:
            path.unlink(missing_ok=True)

    def result(self) -> tuple[np.memmap, np.memmap]:
        values, statuses = map(mapped_array, self.paths)
        return values, statuses


FORMATS: dict[str, type[RowStore]] = {".npy": Npy, ".zarr": Zarr}


class Store:
    """The tables of a format, and a manifest beside them: a header, and a line per chunk done.

    A chunk is listed after its rows are written, so what is listed is there.
    """

    def __init__(self, path: Path, digest: str, count: int, chunk: int):
        if path.suffix not in FORMATS:
            raise UsageError(f"store '{path}': its name must end in {' or '.join(FORMATS)}")
        if not path.parent.is_dir():
            raise UsageError(f"store '{path}': there is no folder '{path.parent}'; make it first")
        self.path, self.count, self.chunk = path, count, chunk
        self.rows = FORMATS[path.suffix](path, count, chunk)
        self.manifest = self.rows.manifest
        self.header = json.dumps({"sweep": digest, "count": count, "chunk": chunk})
        self.done: set[int] = set()
        self._like: Any = None
        self._list: BinaryIO | None = None

    def __enter__(self) -> Store:
        text = self._manifest()
        if self.header.startswith(text):  # its writing was cut off, and it is written before the tables are made
            if taken := [p for p in self.rows.paths if os.path.lexists(p)]:
                raise UsageError(
                    f"'{taken[0]}' exists and is no sweep that was stopped; remove it or name another store"
                )
            self.manifest.unlink(missing_ok=True)
            return self
        header, *lines = text.split("\n")
        if header != self.header:
            said = "is the store of another robot, other arguments or another version"
            raise UsageError(f"'{self.path}' {said}; remove '{self.manifest}' with it, or name another store")
        listed = (line for line in lines[:-1] if line.isdecimal() and len(line) <= len(str(self.count)))
        self.done = {int(line) for line in listed if int(line) * self.chunk < self.count}  # the last may be cut off
        if self.done:
            self._open()
        else:
            self.rows.remove()
        self._list = open(self.manifest, "r+b")
        self._list.truncate(len(header) + 1 + sum(len(line) + 1 for line in lines[:-1]))
        self._list.seek(0, os.SEEK_END)
        return self

    def __exit__(self, *_: object) -> None:
        self.rows.close()
        if self._list is not None:
            self._list.close()

    def _open(self) -> None:
        tables = self.result()
        for path, table in zip(self.rows.paths, tables, strict=False):
            if table.shape[:1] != (self.count,):
                said = f"'{path}' has the shape {table.shape} for {self.count} scenarios"
                raise UsageError(f"{said}; remove it and its manifest")
        self._like = tables[0]
        self.rows.open()
        if not self.rows.complete(self.done):
            raise UsageError(f"'{self.path}' lacks chunks that its manifest lists; remove both to start again")

    def _manifest(self) -> str:
        """The text of the manifest, empty where there is none."""
        if not os.path.lexists(self.manifest):
            return ""
        try:
            with open_regular(self.manifest) as file:
                return file.read().decode("ascii", "replace")
        except OSError as error:
            raise UsageError(f"'{self.manifest}' cannot be read: {error}") from None

    def write(self, k: int, values: np.ndarray, status: np.ndarray) -> None:
        """The rows of chunk k, like those of every other."""
        if self._list is None:
            self._list = create(self.manifest, self.manifest)
            self._list.write(f"{self.header}\n".encode())
            self._list.flush()
        if self._like is None:
            self.rows.create(values, status)
            self._like = values
        kept, given = ((rows.dtype, rows.shape[1:]) for rows in (self._like, values))
        if given != kept:
            now, before = (f"{shape} of {dtype}" for dtype, shape in (given, kept))
            raise UsageError(f"keep gave rows {now} of chunk {k}, {before} before; they must be alike")
        self.rows.write(k, values, status)
        self._list.write(f"{k}\n".encode())
        self._list.flush()
        self.done.add(k)

    def result(self) -> tuple[Any, np.ndarray]:
        """Values and statuses, for reading."""
        try:
            return self.rows.result()
        except (OSError, ValueError, KeyError) as error:
            raise UsageError(
                f"'{self.path}' cannot be read: {error}; remove it and '{self.manifest}' to start again"
            ) from None
