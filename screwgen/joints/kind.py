"""What a kind of joint states: the contract of the files in this folder.

A kind knows how many coordinates and rates its joint has, how the link moves by them, and how they move in time. What
is done with a robot asks its joints, at their places in `q` and `v`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..algebra.expression import Expression, Symbol
from .exponential import Series
from .screw import Screw


@dataclass(frozen=True)
class Kinematics:
    """The relative motion of a joint, as expressions of its coordinates."""

    rotation: Expression
    """(3, 3): components in F_i to components in the mount's axes."""
    displacement: Expression
    """(3, 1), m: the joint point of the link relative to that of the mount, in the mount's axes."""
    angular: Expression
    """(3, nv): the motion subspace's angular part, the axes, in F_i."""
    linear: Expression
    """(3, nv): its linear part at the link's joint point, in F_i."""


MOVES = ("integrate", "difference", "rate", "coordinate_rates", "rates_of", "carried")
"""How coordinates move that do not add up: a kind states all of these or none."""


@dataclass(frozen=True)
class JointKind:
    """A kind of joint; hashable, for it is a part of the class of a link.

    Of its coordinates `q` (nq,) and its rates `v` (nv,), entries may be numbers or symbols. `v` are components of the
    link's twist relative to its carrier where the coordinates hold a quaternion, and ``dq/dt`` elsewhere.
    """

    nq: int
    """The number of coordinates."""
    nv: int
    """The number of rates."""
    torques: int
    """The number of torques, each along one rate: of all rates or of none."""
    screws: tuple[Screw, ...] = ()
    """The screws in order, of a product of them; none of other kinds."""
    slides: bool = False
    """Whether the joint point of the link moves relative to that of the carrier."""
    in_space: bool = False
    """Whether the motion is relative to the inertial frame, so that nothing carries the link or bears its wrench."""
    given: bool = False
    """Whether the motion is given: accelerations are inputs, and what carries the link bears the wrench."""
    name: str = ""
    """What tables and the functions of generated C call it; a product of screws is called by its screws."""
    along: tuple[Screw, ...] = ()
    """What each rate with a torque is like, for names and units: a turn or a slide; of a product its screws."""
    turn_at: int | None = None
    """Where the coordinates have a unit quaternion (w, x, y, z), which no sums move; None where they add up."""

    def __init_subclass__(cls) -> None:
        """Raises TypeError where a kind says in part how its coordinates move: what is inherited is of sums."""
        missing = [name for name in MOVES if getattr(cls, name) is getattr(JointKind, name)]
        if 0 < len(missing) < len(MOVES):
            stated = ", ".join(name for name in MOVES if name not in missing)
            raise TypeError(f"{cls.__name__} states {stated}; it must state {', '.join(missing)} as well")

    @property
    def curved(self) -> bool:
        """Whether coordinates move by other means than sums."""
        return self.turn_at is not None

    @property
    def home(self) -> tuple[float, ...]:
        """The coordinates (nq,) of the joint at rest: no turn and no shift."""
        return tuple(float(k == self.turn_at) for k in range(self.nq))

    def kinematics(self, coordinates: Sequence[Symbol]) -> Kinematics:
        """Pose and motion subspace as functions of the coordinates."""
        raise NotImplementedError

    def integrate(self, q: np.ndarray, u: np.ndarray, series: Series) -> np.ndarray:
        """The coordinates at ``u`` (nv,) from ``q``, the rates times a time if these are constant."""
        return q + u

    def difference(self, q: np.ndarray, other: np.ndarray, series: Series) -> np.ndarray:
        """The ``u`` (nv,) by which :meth:`integrate` moves ``q`` to ``other``; of numbers."""
        return other - q

    def rate(self, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The rate (nv,) of ``u`` in ``integrate(q, u)`` where the rates are ``v``, to order four in ``u``."""
        return v

    def coordinate_rates(self, q: np.ndarray, v: np.ndarray) -> Any:
        """``dq/dt`` (nq,) at the rates ``v``; only the direction of a quaternion counts in other functions."""
        return v

    def rates_of(self, q: np.ndarray, change: np.ndarray) -> Any:
        """The rates (nv,) at which the coordinates change by ``change`` (nq,), the inverse of `coordinate_rates`."""
        return change

    def carried(self, v: np.ndarray) -> np.ndarray:
        """(nv, nv): by a change ``delta``, ``integrate(q, delta)``, its rate at the rates ``v``."""
        return np.zeros((self.nv, self.nv))

    def unit(self, q: np.ndarray, sqrt: Callable[[Any], Any] = np.sqrt) -> np.ndarray:
        """The coordinates with a quaternion of length one; ``sqrt``: that of the entries' algebra."""
        if self.turn_at is None:
            return q
        first, end = self.turn_at, self.turn_at + 4
        turn = q[first:end] * (1.0 / sqrt(sum(q[first:end] * q[first:end])))
        return np.concatenate([q[:first], turn, q[end:]])
