"""The files of a sweep: values, statuses, and the manifest of the chunks that are done."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import BinaryIO

import numpy as np

from ..errors import UsageError
from ..files import create, open_regular


class Store:
    """``NAME.npy`` with a row per scenario, ``NAME.status.npy``, and ``NAME.chunks``: a header, a line per chunk done.

    A chunk is listed after its rows are written, so what is listed is there. Rows are written, not mapped: a mapping
    would count as memory.
    """

    def __init__(self, path: Path, digest: str, count: int, chunk: int):
        if path.suffix != ".npy":
            raise UsageError(f"store '{path}': its name must end in .npy")
        self.path, self.count, self.chunk = path, count, chunk
        self.statuses, self.manifest = path.with_suffix(".status.npy"), path.with_suffix(".chunks")
        self.header = json.dumps({"sweep": digest, "count": count, "chunk": chunk})
        self.done: set[int] = set()
        self._files: list[tuple[BinaryIO, int]] = []
        self._list: BinaryIO | None = None

    def __enter__(self) -> Store:
        if not os.path.lexists(self.manifest):
            if taken := [p for p in (self.path, self.statuses) if os.path.lexists(p)]:
                raise UsageError(
                    f"'{taken[0]}' exists and is no sweep that was stopped; remove it or name another store"
                )
            return self
        try:
            with open_regular(self.manifest) as file:
                header, *lines = file.read().decode("ascii", "replace").split("\n")
        except OSError as error:
            raise UsageError(f"'{self.manifest}' cannot be read: {error}") from None
        if header != self.header:
            said = "is the store of another robot, other arguments or another version"
            raise UsageError(f"'{self.path}' {said}; remove '{self.manifest}' with it, or name another store")
        self.done = {int(line) for line in lines[:-1] if line.isdigit()}  # the last is empty, or was cut off
        if not self.done:
            for path in (self.path, self.statuses):
                path.unlink(missing_ok=True)
        for path in (self.path, self.statuses) if self.done else ():
            self._open(path)
        self._list = open(self.manifest, "r+b")
        self._list.truncate(len(header) + 1 + sum(len(line) + 1 for line in lines[:-1]))
        self._list.seek(0, os.SEEK_END)
        return self

    def __exit__(self, *_: object) -> None:
        for file in (*(file for file, _ in self._files), self._list):
            if file is not None:
                file.close()

    def _open(self, path: Path) -> None:
        try:
            rows = np.load(path, mmap_mode="r")
        except (OSError, ValueError) as error:
            raise UsageError(f"'{path}' cannot be read: {error}; remove '{self.manifest}' to start again") from None
        if len(rows) != self.count:
            raise UsageError(f"'{path}' has {len(rows)} rows for {self.count} scenarios; remove it and its manifest")
        self._files.append((open(path, "r+b"), rows.offset))  # noqa: SIM115

    def _create(self, path: Path, like: np.ndarray) -> None:
        file = create(path, path)
        shape = (self.count, *like.shape[1:])
        np.lib.format.write_array_header_1_0(file, {"descr": like.dtype.str, "fortran_order": False, "shape": shape})
        start = file.tell()
        file.truncate(start + like[:1].nbytes * self.count)
        self._files.append((file, start))

    def write(self, k: int, values: np.ndarray, status: np.ndarray) -> None:
        """The rows of chunk k."""
        if self._list is None:
            self._list = create(self.manifest, self.manifest)
            self._list.write(f"{self.header}\n".encode())
        if not self._files:
            self._create(self.path, values)
            self._create(self.statuses, status)
        for (file, start), rows in zip(self._files, (values, status), strict=True):
            file.seek(start + k * self.chunk * rows[:1].nbytes)
            file.write(np.ascontiguousarray(rows).tobytes())
            file.flush()
        self._list.write(f"{k}\n".encode())
        self._list.flush()
        self.done.add(k)

    def result(self) -> tuple[np.ndarray, np.ndarray]:
        """Values and statuses, mapped."""
        return np.load(self.path, mmap_mode="r"), np.load(self.statuses, mmap_mode="r")
