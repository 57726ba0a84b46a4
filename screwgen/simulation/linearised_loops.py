"""Linearised motions of a robot with loops: those of its independent coordinates, and how its loops close."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ..integrators.method import Method
from ..integrators.methods import method_of
from ..robot_model import RobotModel
from .linearised import Linearised
from .mobility import motions


class LinearisedWithLoops(Linearised):
    """The accelerations of the coordinates that the loops leave independent, to first order about a state.

    Motions are those of d coordinates and their rates. A method steps them as it would a robot written in these alone:
    each evaluation moves all coordinates along, and takes the accelerations of its own. Raises UsageError where a loop
    is open.
    """

    def __init__(self, *given: Any, **named: Any):
        super().__init__(*given, **named)
        self.independent, self.moves = motions(self.model, self.q, self.v, self.p)
        self.identity, self.gains = np.vsplit(np.eye(2 * len(self.independent)), 2), self.gains @ self.moves

    def with_gains(self, gains: np.ndarray) -> Linearised:
        return super().with_gains(gains @ self.moves)

    @property
    def inertia(self) -> np.ndarray:
        """That of the motions (d, d)."""
        N = self.moves[: self.model.nv, : len(self.independent)]
        return N.T @ self.mass_matrix @ N

    @property
    def carried(self) -> np.ndarray:
        """As of `Linearised`, (d, d)."""
        return super().carried[self.independent] @ self.moves[: self.model.nv, : len(self.independent)]

    @property
    def names(self) -> list[str]:
        return [super(LinearisedWithLoops, self).names[k] for k in self.independent]

    def implicit(self, q: np.ndarray, v: np.ndarray, h: float, there: tuple | None = None) -> np.ndarray:
        """As of `Linearised`, of motions (d, k)."""
        return super().implicit(*self._all(q, v), h, there and self._all(*there))[self.independent]

    def _all(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The motions of all coordinates and of their rates, (nv, k) each."""
        whole = self.moves @ np.vstack([q, v])
        return whole[: self.model.nv], whole[self.model.nv :]

    def closing_factors(self, method: str | Method, step: float) -> np.ndarray:
        """Of `g̈ + 2 c ġ + c² g = 0`, which no method takes implicitly, for every stabilisation c of the loops."""
        x, v = np.eye(2)[:, None]
        maps = [method_of(method).step(Gap(c.stabilisation), x, v, step) for c in self.model.chain.closing.rows]
        return np.concatenate([np.linalg.eigvals(np.vstack(S)) for S in maps])


def linearised(model: RobotModel, *given: Any) -> Linearised:
    """The accelerations of all motions that a robot has, with or without loops; arguments as of `Linearised`."""
    return (LinearisedWithLoops if model.chain.closing.rows else Linearised)(model, *given)


class Gap(NamedTuple):
    """A gap that a stabilisation closes, as methods step it."""

    c: float

    def explicit(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        return -2 * self.c * v - self.c**2 * q

    def implicit(self, q: np.ndarray, v: np.ndarray, h: float, there: tuple | None = None) -> np.ndarray:
        return self.explicit(*(there or (q, v)))
