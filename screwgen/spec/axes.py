"""The axes of a joint: how a file states them, and the screws that they stand for."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..joints.ball import BALL
from ..joints.kind import JointKind
from ..joints.screw import Screw, Vector
from .messages import unknown
from .ranges import within
from .values import Path, array, numbers, refuse, shown

LETTERS: dict[str, Vector] = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}

KEYS = ("slide", "screw", "pitch")
TABLES = '{ slide = "x" } or { screw = "x", pitch = 0.002 }'
MAX_AXES = 3
PARALLEL = 1e-6  # sine of the angle below which two axes count as parallel
UNIT = 4 * 2.0**-52  # a vector this near to unit length stays as it is, so that dump and load agree
GENERIC = (0.7, -1.1, 0.4)  # coordinates of no special posture


class AxesOfKind(tuple[Screw, ...]):
    """The axes of a joint that is no product of screws: along each there is a rate and a torque, but no coordinate."""

    kind: JointKind

    def __new__(cls, kind: JointKind) -> AxesOfKind:
        out = super().__new__(cls, kind.along)
        out.kind = kind
        return out

    def __getnewargs__(self) -> tuple[JointKind]:
        return (self.kind,)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, AxesOfKind) and self.kind == other.kind

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash(self.kind)


def axes(value: Any) -> tuple[Vector | Screw, ...]:
    """At most three unit vectors or screws, each of which adds a motion to those before it; "ball"; or a kind."""
    if isinstance(value, AxesOfKind):
        return value
    if isinstance(value, JointKind) or value == BALL.name:
        return AxesOfKind(value if isinstance(value, JointKind) else BALL)
    stated = array(value, 'an array of axes, as ["y", "z"], or "ball"')
    if len(stated) > MAX_AXES:
        raise refuse(f"has {len(stated)} axes; at most {MAX_AXES} are allowed")
    units = tuple(axis(entry, at=(i,)) for i, entry in enumerate(stated))
    for i in range(1, len(units)):
        if parallel(units[i - 1], units[i]):
            raise refuse("is parallel to the axis before it; the two must differ in direction", at=(i,))
        if rank(units[: i + 1]) <= i:
            raise refuse("adds no motion to the axes before it, in any posture; leave it out", at=(i,))
    return units


def axis(value: Any, *, at: Path) -> Vector | Screw:
    """A letter, a vector or the table of a slide or a screw, as the unit vector or unit screw that it stands for."""
    if isinstance(value, Screw):
        return checked(value, at)
    if isinstance(value, dict):
        return tabled(value, at)
    return direction(value, f'"x", "y", "z", an array of 3 numbers, {TABLES}', at)


def direction(value: Any, allowed: str, at: Path) -> Vector:
    """A letter or a vector, as a unit vector."""
    if isinstance(value, str):
        if value not in LETTERS:
            raise refuse(f"is {shown(value)}; it must be {allowed}", at)
        return LETTERS[value]
    return unit(numbers(value, 3, at=at), at=at)


def tabled(table: dict[str, Any], at: Path) -> Screw:
    """`{ slide = axis }`, or `{ screw = axis, pitch = … }` in m per rad."""
    for key in table:
        if key not in KEYS:
            raise refuse(unknown(str(key), KEYS), (*at, str(key)))
    if ("slide" in table) == ("screw" in table):
        both = "is a slide and a screw at once" if "slide" in table else "is neither a slide nor a screw"
        raise refuse(f"{both}; write {TABLES}", at)
    kind = "slide" if "slide" in table else "screw"
    along = direction(table[kind], '"x", "y", "z" or an array of 3 numbers', (*at, kind))
    if kind == "screw":
        return Screw(along, travel=_pitch(table, at))
    if "pitch" in table:
        raise refuse(
            "is stated of a slide, which does not turn; leave it out, or write screw for slide", (*at, "pitch")
        )
    return Screw(along, turn=False, travel=1.0)


def _pitch(table: dict[str, Any], at: Path) -> float:
    if "pitch" not in table:
        raise refuse("is missing; state how far the link moves along the axis, m per rad", (*at, "pitch"))
    return _nonzero(table["pitch"], (*at, "pitch"))


def _nonzero(value: Any, at: Path) -> float:
    pitch = within("pitch")(value, at=at)
    if pitch == 0:
        raise refuse('is 0; an axis about which the link turns alone is written "x"', at)
    return pitch


def checked(screw: Screw, at: Path) -> Vector | Screw:
    """A screw made in Python; one that turns alone is its axis."""
    along = unit(numbers(screw.axis, 3, at=at), at=at)
    if not screw.turn and screw.travel != 1:
        raise refuse(f"slides by {shown(screw.travel)} m per m; the travel of a slide is 1", at)
    if screw.turn and screw.travel == 0:
        return along
    return Screw(along, screw.turn, _nonzero(screw.travel, at))


def written(axes: Sequence[Vector | Screw]) -> list[Vector | dict[str, Any]] | str:
    """The axes as a file states them."""
    if isinstance(axes, AxesOfKind):
        return axes.kind.name
    return [_table(axis) if isinstance(axis, Screw) else axis for axis in axes]


def _table(screw: Screw) -> dict[str, Any]:
    return {"screw": screw.axis, "pitch": screw.travel} if screw.turn else {"slide": screw.axis}


def screw_of(axis: Vector | Screw) -> Screw:
    """The screw that an axis stands for."""
    return axis if isinstance(axis, Screw) else Screw(axis)


def parallel(a: Vector | Screw, b: Vector | Screw) -> bool:
    """Whether two motions are the same but for their size."""
    first, second = screw_of(a), screw_of(b)
    alike = first.turn == second.turn and (first.travel == second.travel or not first.turn)
    return alike and math.hypot(*np.cross(first.axis, second.axis)) < PARALLEL


def rank(axes: Sequence[Vector | Screw]) -> int:
    """The number of independent motions of a joint in a posture that is not special."""
    columns: list[np.ndarray] = []
    for screw, q in zip(map(screw_of, axes), GENERIC, strict=False):
        moved = np.linalg.inv(_adjoint(screw, q))
        columns = [*(moved @ column for column in columns), _column(screw)]
    return int(np.linalg.matrix_rank(np.array(columns).T, tol=PARALLEL / 2))


def _column(screw: Screw) -> np.ndarray:
    """The unit twist [ω; v] of a screw; its size, but not its direction, depends on the unit of length."""
    twist = np.concatenate([np.multiply(screw.axis, float(screw.turn)), np.multiply(screw.axis, screw.travel)])
    return twist / np.linalg.norm(twist)


def _adjoint(screw: Screw, q: float) -> np.ndarray:
    """Ad of the motion by `q`; a slide moves by `q` in m."""
    K = np.cross(np.eye(3), screw.axis).T * float(screw.turn)
    R = np.eye(3) + math.sin(q) * K + (1 - math.cos(q)) * K @ K
    shift = np.cross(np.eye(3), np.multiply(screw.axis, screw.travel * q)).T
    return np.block([[R, np.zeros((3, 3))], [shift @ R, R]])


def unit(a: Sequence[float], *, at: Path) -> Vector:
    """`a`, normalised."""
    largest = max(map(abs, a))
    if largest == 0:
        raise refuse("is the zero vector; an axis needs a direction", at)
    x, y, z = a
    if abs(math.hypot(*a) - 1) <= UNIT:
        return x, y, z
    length = math.hypot(x / largest, y / largest, z / largest)
    return x / largest / length, y / largest / length, z / largest / length
