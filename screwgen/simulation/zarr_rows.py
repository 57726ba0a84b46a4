"""The tables of a sweep as a Zarr group; the package `zarr` is an extra."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import UsageError

MISSING = {"values": 0, "status": 255}
"""What is read where a chunk was not written; no status of a scenario is 255."""


class Zarr:
    """The group ``NAME.zarr`` with the arrays ``values`` and ``status``; a chunk of scenarios is a chunk of each."""

    def __init__(self, path: Path, count: int, chunk: int):
        try:
            import zarr
        except ImportError:
            raise UsageError(f"store '{path}': Zarr is not installed; pip install 'screwgen[zarr]'") from None
        self.paths: tuple[Path, ...] = (path,)
        self.manifest = path.with_suffix(".zarr.chunks")
        self._zarr: Any = zarr
        self._count, self._chunk = count, min(chunk, count)
        self._arrays: list[Any] = []

    def create(self, values: np.ndarray, status: np.ndarray) -> None:
        self.paths[0].mkdir()
        group = self._zarr.create_group(self.paths[0])
        for name, rows in (("values", values), ("status", status)):
            array = group.create_array(
                name,
                shape=(self._count, *rows.shape[1:]),
                chunks=(self._chunk, *rows.shape[1:]),
                dtype=rows.dtype,
                dimension_names=["scenario", *(f"axis_{i}" for i in range(1, rows.ndim))],
                fill_value=MISSING[name],
                config={"write_empty_chunks": True},
            )
            self._arrays.append(array)

    def open(self) -> None:
        group = self._zarr.open_group(self.paths[0], mode="r+")
        self._arrays = [group["values"], group["status"]]

    def complete(self, chunks: set[int]) -> bool:
        folders = [(self.paths[0] / array.basename / "c", (0,) * (array.ndim - 1)) for array in self._arrays]
        return all(folder.joinpath(str(k), *map(str, rest)).is_file() for folder, rest in folders for k in chunks)

    def write(self, k: int, values: np.ndarray, status: np.ndarray) -> None:
        start = k * self._chunk
        for array, rows in zip(self._arrays, (values, status), strict=True):
            array[start : start + len(rows)] = rows

    def close(self) -> None:
        self._arrays.clear()

    def remove(self) -> None:
        if self.paths[0].is_dir():
            shutil.rmtree(self.paths[0])
        elif os.path.lexists(self.paths[0]):
            raise UsageError(f"store '{self.paths[0]}' is no folder; remove it or name another store")

    def result(self) -> tuple[Any, np.ndarray]:
        group = self._zarr.open_group(self.paths[0], mode="r")
        return group["values"], group["status"][:]
