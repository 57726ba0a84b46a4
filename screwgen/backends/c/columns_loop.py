"""Loops over the coordinates of a robot in C, whose body is a program of one of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...ir.program import Program
from .code import Writer, trimmed

Expressions = Mapping[str, str | tuple[int, str]]
"""What signals are in C, with braces for the number of the entry."""


def over_columns(program: Program, own: Expressions, adding: bool = False, column: str = "j") -> list[str]:
    """The body of a loop over coordinates j; ``own``: the expressions of signals that are no columns of changes.

    ``adding``: results are added to what is in their place; ``column``: of results that ``own`` leaves out.
    """

    def place(name: str, k: int) -> str:
        if name not in own and name in program.outputs:
            return f"{name}[{column}]"
        text = own.get(name, f"change->{name}[{{}}][j]")
        if isinstance(text, str):
            return text.format(k)
        first, shifted = text
        return f"change->{name}[{k}][j]" if k < first else f"moved->{shifted}[{k - first}][j]"

    taken = {*program.inputs, *program.outputs, "change", "moved", "work", "tip", "joint", "r", "j"}
    added = frozenset(program.outputs) if adding else frozenset()
    return trimmed(Writer(program, place, None, taken, apart=True, adding=added).lines())


def starts(lists: Sequence[Sequence]) -> list[int]:
    """Where the entries of each list begin in all of them together, and their end."""
    out = [0]
    for entries in lists:
        out.append(out[-1] + len(entries))
    return out
