"""The unit screw: one degree of freedom of a joint."""

from __future__ import annotations

from dataclasses import dataclass

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Screw:
    """A motion ``exp(s q)`` along one axis through the joint point, where ``q`` is the joint's coordinate.

    ``axis``: a unit vector, in the axes of the mount turned by the screws before it. ``turn``: whether the link turns
    about the axis, by ``q`` in rad; otherwise ``q`` is in m. ``travel``: how far the link moves along the axis per unit
    of ``q``: m per rad where it turns (the pitch of a robot file), m per m where it slides.
    """

    axis: Vector
    turn: bool = True
    travel: float = 0.0

    @property
    def slides(self) -> bool:
        """Whether the link moves along the axis."""
        return self.travel != 0.0
