"""A coordinate that an element adds to those of the joints, and what linear forces couple it with its axis.

An example: the rotor behind an elastic gear. Its angle is a coordinate of its own; inertia, stiffness and damping of
the gear act on it, on the axis, and between both. The dynamics condense every such coordinate into the rows of its
axis.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple


class Added(NamedTuple):
    """A coordinate of its own: its name and unit in tables, its title and letter in plots."""

    name: str
    unit: str
    title: str
    symbol: str


Stated = Callable[[str], Any]
"""The value of a key of an element, 0 where the file does not state it."""
Formula = Callable[[Stated], Any]


def none(stated: Stated) -> Any:
    """Nothing."""
    return 0.0


class Terms(NamedTuple):
    """Inertia, stiffness and damping out of the keys: constants that an implicit step takes as they are."""

    inertia: Formula = none
    stiffness: Formula = none
    damping: Formula = none


class Linear(NamedTuple):
    """What an element is in the linear equations of its axis, of the coordinate that it adds, and between both."""

    axis: Terms = Terms()
    added: Terms = Terms()
    between: Terms = Terms()
