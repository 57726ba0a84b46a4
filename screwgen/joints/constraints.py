"""What a joint of slides and turns forbids: the rows that close a loop.

A loop joins the tip frames A and B of two links. With `d` from A's point to B's, every row is one of two scalars that
vanish where the loop is closed: `n · d` with `n` fixed in A, or `x · y − c` with `x` fixed in A and `y` in B.

A coupling of two axes is a loop with one row, a :class:`Ratio` of their coordinates.

Rows bear the loop's forces, but they do not tell a closed loop from every open one: the cosines of a hinge and of a
weld also vanish half a turn away. Whether a loop is closed say its :func:`demands`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..elements import Relation
from ..joints.screw import Screw

Direction = tuple[float, float, float]
X, Y, Z = np.eye(3)
SMALL = 1e-9


@dataclass(frozen=True)
class Distance:
    """No distance along `normal`, a unit vector in A."""

    normal: Direction
    unit = "m"


@dataclass(frozen=True)
class Angle:
    """A constant cosine of the angle between `first`, a unit vector in A, and `second`, one in B."""

    first: Direction
    second: Direction
    cosine: float
    unit = "rad"


@dataclass(frozen=True)
class Alignment:
    """A unit vector in A that is the same direction in B; `weight` times the difference of the two is a gap."""

    direction: Direction
    weight: float = 1.0


@dataclass(frozen=True)
class Ratio:
    """The coordinate of the joint axis `axis` is `ratio` times that of `of`, plus `offset`.

    With a `relation` f it is `ratio` times f of it. Axes are meant by their numbers among the robot's joint
    coordinates; `names`: of these coordinates, `unit`: of the first, rad or m.
    """

    axis: int
    of: int
    ratio: float
    offset: float
    unit: str
    names: tuple[str, str]
    relation: Relation | None = None


Row = Distance | Angle | Ratio
Demand = Distance | Angle | Alignment | Ratio


def rows(screws: Sequence[Screw]) -> tuple[Distance | Angle, ...]:
    """The rows of a joint: three less one per slide, then three less one per turn."""
    slides = [np.array(s.axis) for s in screws if not s.turn]
    turns = [np.array(s.axis) for s in screws if s.turn]
    distances = [Distance(_direction(n)) for n in complement(slides)]
    return (*distances, *_angles(turns))


def demands(screws: Sequence[Screw]) -> tuple[Demand, ...]:
    """What holds where the loop is closed, and nowhere else.

    A weld aligns all three axes; with the weight √½ the norm of their differences is 2 sin(θ/2) of the angle θ between
    the frames, as that of a hinge's one axis is.
    """
    turns = [np.array(s.axis) for s in screws if s.turn]
    apart = [row for row in rows(screws) if isinstance(row, Distance)]
    if not turns:
        return (*apart, *(Alignment(_direction(axis), 0.5**0.5) for axis in (X, Y, Z)))
    if len(turns) == 1:
        return (*apart, Alignment(_direction(turns[0])))
    return (*apart, *_angles(turns))


def _angles(turns: Sequence[np.ndarray]) -> list[Angle]:
    if not turns:
        return [_angle(a, b) for a, b in ((Y, Z), (Z, X), (X, Y))]
    if len(turns) == 1:
        return [_angle(n, turns[0]) for n in complement(turns)]
    if len(turns) == 2:
        return [_angle(*turns)]
    return []


def _angle(first: np.ndarray, second: np.ndarray) -> Angle:
    return Angle(_direction(first), _direction(second), float(first @ second))


def complement(directions: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Unit vectors at right angles to each other and to all of `directions`; axes of the frame where these will do."""
    found: list[np.ndarray] = []
    basis = list(np.linalg.qr(np.array(directions).T)[0].T) if len(directions) else []
    for axis in (X, Y, Z):
        rest = axis - sum((b * (b @ axis) for b in basis), np.zeros(3))
        if len(basis) < 3 and np.linalg.norm(rest) > 0.5:
            found.append(rest / np.linalg.norm(rest))
            basis.append(found[-1])
    return found


def _direction(n: np.ndarray) -> Direction:
    x, y, z = (float(c) if abs(c) > SMALL else 0.0 for c in n)
    return x, y, z
