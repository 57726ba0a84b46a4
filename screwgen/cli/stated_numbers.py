"""Numbers that stand in options: `0.1,-0.2`, by commas or blanks."""

from __future__ import annotations

import sys
from collections.abc import Iterable

import numpy as np

from ..errors import UsageError
from ..model import Model
from ..simulation.state import refusals
from ..spec.load import one_line
from ..spec.parameters import coordinate_units
from ..spec.ranges import within

TURNS = 4.0 * np.pi
"""rad: a larger angle in an option is more likely one in degrees."""


def joint_coordinates(given: str, model: Model, option: str = "q") -> np.ndarray:
    """The joint coordinates, quaternions among them, in an option; a note names angles that are likely degrees."""
    what = "joint coordinates" if model.chain.sliding or model.chain.curved else "joint angles in rad"
    q = numbers("q", given, model.chain.n_redundant, what, option)
    note_degrees(q, model, f"--{option}")
    return q


def note_degrees(q: Iterable[float], model: Model, where: str) -> None:
    """Name joint coordinates that are likely degrees."""
    joints = slice(model.chain.base_q, model.chain.base_q + model.chain.n_redundant)
    units = coordinate_units(model.robot)[joints]
    for name, unit, x in zip(model.q_names[joints], units, q, strict=False):  # another count is refused later
        if unit == "rad":
            note_angle(x, name, where)


def note_angle(x: float, name: str, where: str) -> None:
    """Name an angle that is likely one in degrees."""
    if abs(x) > TURNS:
        said = f"{name} is {x:g} rad, {x / (2 * np.pi):.3g} turns"
        print(f"screwgen: note: {where}: {said}; {x:g} degrees are {np.radians(x):.4g}", file=sys.stderr)


def numbers(quantity: str, given: str, size: int, what: str, option: str = "") -> np.ndarray:
    """`size` numbers in the range of a quantity out of the option of that name, by commas or blanks."""
    option, words = f"--{option or quantity}", given.replace(",", " ").split()
    try:
        out = np.array([float(word) for word in words])
    except ValueError:
        wanted = f"give {size} {what}, as 0.1,-0.2"
        raise UsageError(f"{option}: '{one_line(given)}' is no list of numbers; {wanted}") from None
    if len(out) != size:
        raise UsageError(f"{option}: has {len(out)} numbers; it must have {size} finite {what}, separated by commas")
    if not np.isfinite(out).all():
        raise UsageError(f"{option}: {one_line(given)} is not finite; it must have {size} finite {what}")
    with refusals(option):
        return np.array([within(quantity)(x) for x in out.tolist()])
