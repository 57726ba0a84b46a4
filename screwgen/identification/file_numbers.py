"""Numbers of a robot file that are no parameters by themselves but give some, as Young's modulus of a profile.

How parameters follow from them is what loading makes of the file: its tables are loaded again with other numbers.
"""

from __future__ import annotations

import copy
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..errors import ScrewgenError, UsageError
from ..robot_model import RobotModel
from ..spec.load import decode, one_line, parse, read, validated
from ..spec.parameters import parameters
from ..spec.ranges import RANGES
from ..spec.values import Path

NUDGE, WITHIN = 1e-6, 1e-4
"""The relative change by which it is found what follows from a number, and the distance from the end of a range."""
QUANTITIES = {"diameter": "dimension", "outer": "dimension", "wall": "dimension"} | dict.fromkeys(
    ("height", "breadth"), "dimension"
)
"""Which range a key has, where it is not called like it."""


@dataclass(frozen=True)
class FileNumber:
    """A number of a robot file: its name, where it stands, and its value there."""

    file: FileNumbers
    name: str
    keys: Path
    value: float

    @cached_property
    def _quantity(self) -> Any:
        key = next(x for x in reversed(self.keys) if isinstance(x, str))
        return RANGES.get(QUANTITIES.get(key, key))

    @property
    def unit(self) -> str:
        """Its unit, empty where it has none."""
        found = self._quantity
        return "" if found is None or found.unit == "1" else str(found.unit)

    @property
    def range(self) -> tuple[float, float]:
        """The least and the largest value that it may have in a search."""
        found = self._quantity
        return (0.0, np.inf) if found is None else (found.low, found.high * (1 - WITHIN))


class FileNumbers:
    """The numbers of a robot file, by names as ``arm.profile.E`` and ``arm.profile.tube.wall[1]``."""

    def __init__(self, text: str, file: str, folder: str = ""):
        self.file, self.folder, self.tables = file, folder, parse(text, file)
        self.names = {name: FileNumber(self, name, keys, x) for name, keys, x in _numbers(self.tables)}

    @cached_property
    def start(self) -> np.ndarray:
        """The parameters (n,) that the file states."""
        return self.parameters((), ())

    def parameters(self, changed: Sequence[FileNumber], values: Iterable[float]) -> np.ndarray:
        """The parameters (n,) of the file with other numbers; raises RobotFileError where it cannot have them."""
        tables = copy.deepcopy(self.tables)
        for one, value in zip(changed, values, strict=True):
            at: Any = tables
            for key in one.keys[:-1]:
                at = at[key]
            at[one.keys[-1]] = float(value)
        robot = validated(tables, self.folder, lambda path: (self.file, path))
        return np.array([one.value for one in parameters(robot)])

    def giving_several(self, names: Iterable[str]) -> list[FileNumber]:
        """Those of these numbers that give parameters and are none by themselves."""
        return [one for name in names if self._gives_several(one := self.names[name])]

    def _gives_several(self, one: FileNumber) -> bool:
        for factor in (1 + NUDGE, 1 - NUDGE):
            try:
                found = self.parameters([one], [one.value * factor])
            except ScrewgenError:
                continue
            if found.shape != self.start.shape:
                return False
            changed = np.flatnonzero(found != self.start)
            return len(changed) > 1 or (len(changed) == 1 and self.start[changed[0]] != one.value)
        return False


def file_numbers(path: str | os.PathLike[str], model: RobotModel) -> FileNumbers:
    """The numbers of the file that states a robot; raises UsageError where the robot has other ones."""
    file = one_line(os.fsdecode(path))
    found = FileNumbers(decode(read(path, file), file), file, os.path.dirname(os.fspath(path)))
    if not np.array_equal(found.start, model.chain.parameters.values):
        raise UsageError(f"{file}: states other numbers than the robot has; name the file that it was loaded from")
    return found


def with_numbers(changed: Sequence[FileNumber], values: Iterable[float]) -> np.ndarray:
    """The parameters (n,) of the file that has these numbers, with other values."""
    return changed[0].file.parameters(changed, values)


def _numbers(tables: Any, keys: Path = (), name: str = "") -> list[tuple[str, Path, float]]:
    """Name, place and value of all numbers of tables, those of links by the name of the link."""
    if isinstance(tables, bool | str) or not isinstance(tables, int | float | dict | list):
        return []
    if isinstance(tables, int | float):
        return [(name, keys, float(tables))]
    found = []
    for key, value in tables.items() if isinstance(tables, dict) else enumerate(tables):
        if isinstance(tables, dict):
            own = "" if not keys and key == "links" else f"{name}.{key}".lstrip(".")
        else:
            link = keys == ("links",) and isinstance(value, dict) and isinstance(value.get("name"), str)
            own = value["name"] if link else f"{name}[{key}]"
        found += _numbers(value, (*keys, key), own)
    return found
