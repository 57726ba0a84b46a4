"""A joint that gives way in the directions that it blocks: a spring and a damper across each of its rows.

With the gap g of a row (:mod:`.constraints`), m or the difference of two cosines, the force along the row is
``-(k g + c gdot)`` and the potential ``k g²/2``. For k without bound that is the rigid joint.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

from ..interactions import Interaction, InteractionClass, Relative, WrenchOnSecond, number
from ..interactions.vectors import Value, Vector, cross, dot
from .constraints import Angle, Distance

BlockedMotion = Distance | Angle
"""A row of a joint that blocks a motion."""
ROWS = "rows"
"""The key of the rows among what its programs are made from."""


@dataclass(frozen=True)
class CompliantJoint(Interaction):
    """The joint of a loop that gives way: in its ``rows`` springs and dampers."""

    KIND = "joint"
    WORDS = "joints that give way"

    stiffness: float = number(
        "N/m", "stiffness along blocked axes, about these in N·m per rad", "k_g", sign="positive", least=1e-9, most=1e18
    )
    damping: float | None = number(
        *("N·s/m", "damping along blocked axes, about these in N·m·s per rad", "c_g"),
        default=None,
        sign="non-negative",
        least=1e-12,
        most=1e18,
    )
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
            size = t.named(f"row_force_{k}", -(keys["stiffness"] * gap + keys["damping"] * rate))
            along = force if isinstance(row, Distance) else torque
            along[:] = [a + n * size for a, n in zip(along, way, strict=True)]
        return WrenchOnSecond(torque, force)

    @staticmethod
    def energy(t: Any, x: Relative, **keys: Any) -> Value:
        gaps = [t.named(f"gap_{k}", _gap(row, x)) for k, row in enumerate(keys["rows"])]
        squares = [gap * gap for gap in gaps]
        return 0.5 * keys["stiffness"] * sum(squares[1:], squares[0])

    @staticmethod
    def drawn(has: Collection[str]) -> str:
        return "none"


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
