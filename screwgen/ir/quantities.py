"""The quantities of the derivation, described once: blocks look up what they do not say otherwise."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple


class Quantity(NamedTuple):
    """How a quantity is written, its unit, the frame of its components, its equation in the paper, what it is."""

    display: str
    unit: str
    frame: str
    equation: str
    meaning: str
    numbered: tuple[int, ...] = ()


def _read(path: Path) -> dict[str, Quantity]:
    table = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            name, display, unit, frame, equation, meaning, *numbered = (cell.strip() for cell in line.split("|"))
            dimensions = tuple(int(n) for cell in numbered for n in cell.split())
            table[name] = Quantity(display, unit, frame, equation, meaning, dimensions)
    return table


QUANTITIES = _read(Path(__file__).with_suffix(".txt"))
"""By name."""


def described(block: str, name: str, given: dict) -> Quantity:
    """The quantity ``name`` of a block: as ``given``, or from the table with what is given in place of its words.

    The table's entry ``block.name`` goes before ``name``. ValueError if a word is missing.
    """
    given = {key: value for key, value in given.items() if value is not None}
    missing = {"display", "unit", "meaning"} - given.keys()
    if not missing:
        return Quantity(**{"frame": "-", "equation": "", **given})
    if known := QUANTITIES.get(f"{block}.{name}", QUANTITIES.get(name)):
        return known._replace(**given)
    raise ValueError(f"{block}: {name} is no quantity of the table; state its {', '.join(sorted(missing))}")
