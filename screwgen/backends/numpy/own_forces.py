"""The coordinates with inertia, spring and damper of their own: modes, and joints and rotors where any is sprung."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from ...algorithms.axis_laws import Secants, secants
from ...topology.chain import Chain

NONE = np.zeros(0)


def on(x: np.ndarray) -> np.ndarray:
    """1 where x > 0, else 0."""
    return (x > 0).astype(float)


@dataclass
class OwnForces:
    """Inertia, stiffness and damping of these coordinates, the last ``n_given`` of ``q``.

    ``M``, ``K``, ``D`` (n_inertia, ...): the diagonal, then the entries below it where modes or rotors are coupled;
    ``coulomb``, ``speed``: dry friction of the coordinates in ``chain.dry`` and the squares of its velocities;
    ``stop_at``, ``stop_K``, ``stop_D``: limit, stiffness and damping of ``chain.stops``; ``pressed``: what these exert,
    as linear forces, which :meth:`acting` sets.
    """

    chain: Chain
    M: np.ndarray
    K: np.ndarray
    D: np.ndarray
    coulomb: np.ndarray = field(default_factory=lambda: NONE)
    speed: np.ndarray = field(default_factory=lambda: NONE)
    stop_at: np.ndarray = field(default_factory=lambda: NONE)
    stop_K: np.ndarray = field(default_factory=lambda: NONE)
    stop_D: np.ndarray = field(default_factory=lambda: NONE)
    pressed: Secants | None = None

    @classmethod
    def of_columns(cls, chain: Chain, columns: Sequence[np.ndarray]) -> OwnForces:
        """Out of the robot's columns, in the order of :func:`...algorithms.columns.columns`."""
        M, K, D, *laws = columns
        dry, stops = (laws[:2], laws[2:]) if chain.dry else ((NONE, NONE), laws)
        return cls(chain, M, K, D, *dry, *stops)

    def of(self, x: np.ndarray) -> np.ndarray:
        """The part of ``q`` or ``v`` (nq, ...) that belongs to these coordinates."""
        return x[len(x) - self.chain.n_given :]

    def acting(self, x: np.ndarray, rate: np.ndarray, h: float = 0.0, there: np.ndarray | None = None) -> OwnForces:
        """The same with dry friction and stops as linear forces ``h`` after the coordinates ``x`` with ``rate``.

        ``x``, ``rate`` (n_given,); ``there``: the rates at the stage, those of ``rate`` by default.
        """
        there, chain = rate if there is None else there, self.chain
        D, pressed = self.D, None
        if chain.dry:
            D = self.D.copy()
            D[chain.dry] += self.coulomb / np.sqrt(there[chain.dry] ** 2 + self.speed)
        if chain.stops:
            k, side = self._stops
            columns = (self.stop_at, self.stop_K, self.stop_D)
            pressed = secants(side, x[k], rate[k], there[k], h, *columns, on)
        return replace(self, D=D, pressed=pressed)

    @property
    def _stops(self) -> tuple[np.ndarray, np.ndarray]:
        """Coordinates and sides of the stops."""
        return tuple(np.array(self.chain.stops, int).T)  # type: ignore[return-value]

    @property
    def slopes(self) -> OwnForces:
        """The same for small changes of coordinates and rates: stops are then at rest at zero."""
        if self.pressed is None:
            return self
        return replace(self, pressed=self.pressed._replace(rest=np.zeros(len(self.stop_at))))

    def softened(self, rate: np.ndarray, felt: np.ndarray, change: np.ndarray) -> np.ndarray:
        """(n_given, ...): what the fall of dry friction's secant adds to its force by a ``change`` of the rates.

        ``felt`` (n_given,): the rates that the secant multiplies.
        """
        out, dry = np.zeros_like(change), self.chain.dry
        if dry:
            w, shape = rate[dry], (-1, *(1,) * (change.ndim - 1))
            fall = -self.coulomb * w * felt[dry] / (w**2 + self.speed) ** 1.5
            out[dry] = fall.reshape(shape) * change[dry]
        return out

    def inertia(self, h: float) -> np.ndarray:
        """(n_inertia,): the inertia with the forces implicit over ``h`` seconds, ``M + h (D + h K)``."""
        return self.M + self.added(h)

    def added(self, h: float) -> np.ndarray:
        """(n_inertia,): what the forces add to the inertia."""
        out = h * (self.D + h * self.K)
        if self.pressed is not None:
            np.add.at(out, self._stops[0], h * (self.pressed.damping + h * self.pressed.stiffness))
        return out

    def force(self, x: np.ndarray, rate: np.ndarray, h: float) -> np.ndarray:
        """(n_given, ...): the force ``h`` after ``x``, ``rate`` (n_given, ...) without the accelerations' part."""
        column = lambda A: A.reshape(-1, *(1,) * (x.ndim - 1))  # noqa: E731
        K, D = column(self.K), column(self.D)
        out = self.chain.modal_product(K, x + h * rate) + self.chain.modal_product(D, rate)
        if self.pressed is not None:
            k, (stiffness, damping, rest) = self._stops[0], map(column, self.pressed)
            np.add.at(out, k, stiffness * (x[k] - rest + h * rate[k]) + damping * rate[k])
        return out
