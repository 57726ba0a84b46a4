"""Names in generated code: of values, and of groups of operations."""

from __future__ import annotations

from typing import NamedTuple


class Label(NamedTuple):
    """The name of a value in generated code: a quantity, the place of an entry in it, and the link that it belongs to.

    ``negative``: the value is the negative of that entry.
    """

    quantity: str
    place: str = ""
    link: str = ""
    negative: bool = False

    def __str__(self) -> str:
        return "_".join(x for x in ("minus" * self.negative, self.quantity, self.link, self.place) if x)


PARTS = {"N*m, N": ("tau", "f"), "rad/s, m/s": ("omega", "v"), "rad/s^2, m/s^2": ("alpha", "a")}
"""The letters of the angular and the linear part of six components, by their unit."""


def component(unit: str, k: int) -> str:
    """The name of one of six components: ``tau_x`` ... ``f_z`` of a wrench, a number where the unit has no letters."""
    return f"{PARTS[unit][k // 3]}_{'xyz'[k % 3]}" if unit in PARTS else str(k + 1)


class OperationGroup(NamedTuple):
    """A group of operations in generated code: its title, and the call of a routine that they belong to, if any."""

    title: str
    routine: str = ""
    """The name of the routine, such as ``rod_section``."""
    call: str = ""
    """What tells one call from the others of the program."""
