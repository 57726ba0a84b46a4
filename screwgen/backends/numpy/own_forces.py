"""The coordinates with inertia, spring and damper of their own: modes, and joints and rotors where any is sprung."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from ...algorithms.axis_laws import LawsOfRobot, of_robot
from ...algorithms.law_programs import replayed, secants, spring_stage, stage_slopes
from ...elements.law import Secant
from ...topology.chain import Chain


class LinearisedLaw(NamedTuple):
    """A law on its coordinates, with its constants by name; over a step the linear force of ``held``."""

    law: LawsOfRobot
    constants: Mapping[str, np.ndarray]
    held: Secant | None = None

    def stage(self, x: np.ndarray, rate: np.ndarray, there: np.ndarray, h: float) -> dict[str, np.ndarray]:
        """The inputs of its programs."""
        at = self.law.coordinates
        state = {"side": np.array(self.law.sides, float), "x": x[at], "w": rate[at], "there": there[at]}
        return state | {"h": np.full(len(at), h)} | dict(self.constants)


@dataclass
class CoordinateForces:
    """Inertia, stiffness and damping of these coordinates, the last ``n_given`` of ``q``.

    ``M``, ``K``, ``D`` (n_inertia, ...): the diagonal, then the entries below it where modes or rotors are coupled;
    ``laws``: what else acts, as linear forces once :meth:`linearised_over` has set them.
    """

    chain: Chain
    M: np.ndarray
    K: np.ndarray
    D: np.ndarray
    laws: Sequence[LinearisedLaw] = ()

    @classmethod
    def of_columns(cls, chain: Chain, columns: Sequence[np.ndarray]) -> CoordinateForces:
        """Out of the robot's columns, in the order of :func:`...algorithms.columns.columns`."""
        M, K, D, *rest = columns
        own, laws = iter(rest), of_robot(chain)
        return cls(
            chain, M, K, D, [LinearisedLaw(one, {name: next(own) for name in one.law.constants}) for one in laws]
        )

    def of(self, x: np.ndarray) -> np.ndarray:
        """The part of ``q`` or ``v`` (nq, ...) that belongs to these coordinates."""
        if self.chain.curved and len(x) == self.chain.nq:
            return x[self.chain.given_places]
        return x[len(x) - self.chain.n_given :]

    def linearised_over(
        self, x: np.ndarray, rate: np.ndarray, h: float = 0.0, there: np.ndarray | None = None
    ) -> CoordinateForces:
        """The same with the laws as linear forces ``h`` after the coordinates ``x`` with ``rate``.

        ``x``, ``rate`` (n_given,); ``there``: the rates at the stage, those of ``rate`` by default.
        """
        there = rate if there is None else there
        found = (replayed(secants(one.law.law), one.stage(x, rate, there, h)) for one in self.laws)
        return replace(self, laws=[a._replace(held=Secant(**held)) for a, held in zip(self.laws, found, strict=True)])

    @property
    def slopes(self) -> CoordinateForces:
        """The same for small changes of coordinates and rates: laws are then at rest at zero."""
        at_zero = [
            one._replace(held=one.held._replace(rest=0.0, constant=0.0)) if one.held else one for one in self.laws
        ]
        return replace(self, laws=at_zero)

    def softened(self, x: np.ndarray, rate: np.ndarray, felt: np.ndarray, change: np.ndarray) -> np.ndarray:
        """(n_given, ...): what the secants of laws on rates alone add to their forces by a ``change`` of the rates.

        ``felt`` (n_given,): the rates that the secants multiply.
        """
        out, shape = np.zeros_like(change), (-1, *(1,) * (change.ndim - 1))
        for one in self.laws:
            if not one.law.law.positional:
                at, given = one.law.coordinates, one.stage(x, felt, rate, 0.0) | {"a": 0.0}
                fall = replayed(stage_slopes(one.law.law), given)["by_there"]
                np.add.at(out, at, np.reshape(fall, shape) * change[at])
        return out

    def inertia(self, h: float) -> np.ndarray:
        """(n_inertia,): the inertia with the forces implicit over ``h`` seconds, ``M + h (D + h K)``."""
        return self.M + self.added(h)

    def added(self, h: float) -> np.ndarray:
        """(n_inertia,): what the forces add to the inertia."""
        out = replayed(spring_stage(), {"x": 0.0, "w": 0.0, "h": h, "K": self.K, "D": self.D})["inertia"]
        for one in self.laws:
            if one.held is not None:
                np.add.at(out, one.law.coordinates, h * (one.held.damping + h * one.held.stiffness))
        return out

    def force(self, x: np.ndarray, rate: np.ndarray, h: float) -> np.ndarray:
        """(n_given, ...): the force ``h`` after ``x``, ``rate`` (n_given, ...) without the accelerations' part."""
        column = lambda A: np.reshape(A, (-1, *(1,) * (x.ndim - 1)))  # noqa: E731
        rows, felt, entries = self.chain.springs
        given = {"x": x[felt], "w": rate[felt], "h": h, "K": column(self.K)[entries], "D": column(self.D)[entries]}
        out = np.zeros(np.broadcast_shapes(np.shape(x), np.shape(rate)))
        np.add.at(out, rows, replayed(spring_stage(), given)["force"])
        for one in self.laws:
            if one.held is not None:
                k, (stiffness, damping, rest, constant) = one.law.coordinates, map(column, one.held)
                np.add.at(out, k, stiffness * (x[k] - rest + h * rate[k]) + damping * rate[k] + constant)
        return out
