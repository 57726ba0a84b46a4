"""A joint that gives way in the directions that it blocks: a spring and a damper across each of its rows.

With the gap g of a row (:mod:`.constraints`), m or the difference of two cosines, the force along the row is
``-(k g + c gdot)`` and the potential ``k g²/2``. For k without bound that is the rigid joint.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..interactions import ROWS, Interaction, InteractionClass, Relative, SoftRow, WrenchOnSecond, number
from ..interactions.vectors import Value, Vector, cross, dot
from .constraints import Angle, Distance

BlockedMotion = Distance | Angle
"""A row of a joint that blocks a motion."""

ALONG, ABOUT = "along blocked axes", "about blocked axes"
UNITS = {ALONG: ("N/m", "N·s/m"), ABOUT: ("N·m/rad", "N·m·s/rad")}
"""The units of stiffness and damping of the directions that have numbers of their own."""


def _numbers(*groups: str) -> tuple[Any, Any]:
    """The fields of stiffness and damping of joints that block motions of these groups, an entry for each."""
    of_springs, of_dampers = (", ".join(UNITS[name][k] for name in groups) for k in (0, 1))
    damping = number(
        *(of_dampers, "damping", r"\mathbf{c}_g"),
        default=None,
        sign="non-negative",
        least=1e-12,
        most=1e18,
        entries=groups,
    )
    stiffness = number(of_springs, "stiffness", r"\mathbf{k}_g", sign="positive", least=1e-9, most=1e18, entries=groups)
    return stiffness, damping


@dataclass(frozen=True)
class CompliantJoint(Interaction):
    """The joint of a loop that gives way: in its ``rows`` springs and dampers, along axes and about them."""

    KIND = "joint"
    WORDS = "joints that give way"

    stiffness: tuple[float, ...] = _numbers(ALONG, ABOUT)[0]
    damping: tuple[float, ...] | None = _numbers(ALONG, ABOUT)[1]
    rows: tuple[BlockedMotion, ...] = ()

    @property
    def shape(self) -> InteractionClass:
        return InteractionClass(type(self), tuple(self.numbers), (), ((ROWS, self.rows),))

    @staticmethod
    def wrench(t: Any, x: Relative, **keys: Any) -> WrenchOnSecond:
        torque, force = [0.0] * 3, [0.0] * 3
        for k, row in enumerate(keys["rows"]):
            gap, way = t.named(f"gap_{k}", _gap(row, x)), _way(row, x)
            rate = t.named(f"gap_rate_{k}", dot(way, x.v if isinstance(row, Distance) else x.omega))
            stiffness, damping = of_row(row, keys)
            size = t.named(f"row_force_{k}", -(stiffness * gap + damping * rate))
            along = force if isinstance(row, Distance) else torque
            along[:] = [a + n * size for a, n in zip(along, way, strict=True)]
        return WrenchOnSecond(torque, force)

    @staticmethod
    def soft_row(row: Any, **keys: Any) -> SoftRow:
        return SoftRow(*of_row(row, keys))

    @staticmethod
    def energy(t: Any, x: Relative, **keys: Any) -> Value:
        gaps = [t.named(f"gap_{k}", _gap(row, x)) for k, row in enumerate(keys["rows"])]
        stored = [of_row(row, keys)[0] * (gap * gap) for row, gap in zip(keys["rows"], gaps, strict=True)]
        return 0.5 * sum(stored[1:], stored[0])

    @staticmethod
    def drawn(has: Collection[str]) -> str:
        return "none"


@dataclass(frozen=True)
class CompliantAlong(CompliantJoint):
    """One that blocks no turns."""

    stiffness: tuple[float, ...] = _numbers(ALONG)[0]
    damping: tuple[float, ...] | None = _numbers(ALONG)[1]


@dataclass(frozen=True)
class CompliantAbout(CompliantJoint):
    """One that blocks turns alone."""

    stiffness: tuple[float, ...] = _numbers(ABOUT)[0]
    damping: tuple[float, ...] | None = _numbers(ABOUT)[1]


def blocked(rows: Sequence[BlockedMotion]) -> list[str]:
    """The groups of directions that a joint with these rows blocks."""
    kinds = {type(row) for row in rows}
    return [ALONG] * (Distance in kinds) + [ABOUT] * (Angle in kinds)


def compliant(
    stiffness: Sequence[float], damping: Sequence[float] | None, rows: tuple[BlockedMotion, ...]
) -> CompliantJoint:
    """The joint with these rows; ``stiffness``, ``damping``: along axes and about them, of which it takes its own."""
    groups = blocked(rows)
    kind = CompliantJoint if len(groups) > 1 else CompliantAlong if ALONG in groups else CompliantAbout
    own = lambda x: tuple(one for name, one in zip(UNITS, x, strict=True) if name in groups)  # noqa: E731
    return kind(own(stiffness), None if damping is None else own(damping), rows)


def of_row(row: object, keys: Mapping[str, Any]) -> tuple[Value, Value]:
    """Stiffness and damping of a row, among what its laws take."""
    place = -1 if isinstance(row, Angle) else 0
    return keys["stiffness"][place], keys["damping"][place]


def _gap(row: BlockedMotion, x: Relative) -> Value:
    """What the row demands to be zero."""
    if isinstance(row, Distance):
        return dot(row.normal, x.d)
    return dot(row.first, _turned(row, x)) - row.cosine


def _way(row: BlockedMotion, x: Relative) -> Vector:
    """(3,) in the first frame's axes: along which its force acts on the second frame, or about which its torque."""
    return row.normal if isinstance(row, Distance) else cross(_turned(row, x), row.first)


def _turned(row: Angle, x: Relative) -> Vector:
    """The direction that is fixed in the second frame, in the first frame's axes."""
    return [dot(x.R[k], row.second) for k in range(3)]
