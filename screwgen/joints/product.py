"""A joint of slides, turns and screws: relative pose and motion subspace, from the screws.

It is a product of exponentials of unit screws, ``exp(s_1 q_1) exp(s_2 q_2) ...``, between the mount on the parent
and the link's frame at the joint point. All other joint quantities follow from these.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

from ..algebra.expression import Expression, Rotation, Symbol, add, block, hat, identity, vector, zeros
from ..algebra.notation import axis_latex
from ..lazily import sp
from .kind import JointKind, Kinematics
from .screw import Screw


@dataclass(frozen=True)
class ScrewProduct(JointKind):
    """``exp(s_1 q_1) exp(s_2 q_2) ...`` of the screws in order; none: a weld."""

    def kinematics(self, coordinates: Sequence[Symbol]) -> Kinematics:
        return kinematics(self.screws, coordinates)


def product(screws: Sequence[Screw]) -> ScrewProduct:
    """The kind of a joint of these screws."""
    count = len(screws)
    return ScrewProduct(count, count, count, tuple(screws), slides=any(screw.slides for screw in screws))


WELD = product(())


def kinematics(screws: Sequence[Screw], coordinates: Sequence[Symbol]) -> Kinematics:
    """The relative motion of a product of exponentials: its derivatives by each coordinate are the columns."""
    axes = [_axis(screw) for screw in screws]
    turns = [Rotation(_exact(s.axis), q) if s.turn else identity(3) for s, q in zip(screws, coordinates, strict=True)]
    shifts = [
        (_exact_number(s.travel) * axis) @ q if s.slides else zeros(3)
        for s, axis, q in zip(screws, axes, coordinates, strict=True)
    ]
    unturned: Expression = identity(3)
    angular, linear = [], []
    for k, screw in enumerate(screws):
        turning = axes[k] if screw.turn else zeros(3)
        later = _displacement(turns[k + 1 :], shifts[k + 1 :])
        moving = add(_exact_number(screw.travel) * axes[k] if screw.slides else zeros(3), hat(turning) @ later)
        angular.append(_turned_back(turns[k + 1 :], turning))
        linear.append(_turned_back(turns[k + 1 :], moving))
    return Kinematics(
        reduce(lambda a, b: a @ b, turns, unturned),
        _displacement(turns, shifts),
        block(angular) if screws else zeros(3, 0),
        block(linear) if screws else zeros(3, 0),
    )


def _displacement(turns: Sequence[Expression], shifts: Sequence[Expression]) -> Expression:
    """The displacement of a product of exponentials, in the axes before its first screw."""
    total: Expression = zeros(3)
    for turn, shift in zip(reversed(turns), reversed(shifts), strict=True):
        total = add(shift, turn @ total)
    return total


def _turned_back(turns: Sequence[Expression], column: Expression) -> Expression:
    """A column in the axes after all rotations in ``turns``."""
    return reduce(lambda x, turn: turn.T @ x, turns, column)


def _axis(screw: Screw) -> Expression:
    exact = _exact(screw.axis)
    return vector(exact, axis_latex(exact))


def _exact(values: Sequence[float]) -> tuple[sp.Expr, ...]:
    return tuple(_exact_number(x) for x in values)


def _exact_number(x: float) -> sp.Expr:
    return sp.Integer(int(x)) if x == int(x) else sp.Float(x)
