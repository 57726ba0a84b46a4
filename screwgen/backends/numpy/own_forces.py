"""The coordinates with inertia, spring and damper of their own: modes, and joints and rotors where any is sprung."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from ...topology.chain import Chain

NONE = np.zeros(0)


@dataclass
class OwnForces:
    """Inertia, stiffness and damping of these coordinates, the last ``n_given`` of ``q``.

    ``M``, ``K``, ``D`` (n_inertia, ...): the diagonal, then the entries below it where modes or rotors are coupled;
    ``coulomb``, ``speed``: dry friction of the coordinates in ``chain.dry`` and the squares of its velocities.
    """

    chain: Chain
    M: np.ndarray
    K: np.ndarray
    D: np.ndarray
    coulomb: np.ndarray = field(default_factory=lambda: NONE)
    speed: np.ndarray = field(default_factory=lambda: NONE)

    def of(self, x: np.ndarray) -> np.ndarray:
        """The part of ``q`` or ``v`` (nq, ...) that belongs to these coordinates."""
        return x[len(x) - self.chain.n_given :]

    def rubbing(self, rate: np.ndarray) -> OwnForces:
        """The same with dry friction as the damping that it is at the rates (n_given,) of these coordinates."""
        if not self.chain.dry:
            return self
        D = self.D.copy()
        D[self.chain.dry] += self.coulomb / np.sqrt(rate[self.chain.dry] ** 2 + self.speed)
        return replace(self, D=D)

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
        return h * (self.D + h * self.K)

    def force(self, x: np.ndarray, rate: np.ndarray, h: float) -> np.ndarray:
        """(n_given, ...): the force ``h`` after ``x``, ``rate`` (n_given, ...) without the accelerations' part."""
        K, D = (A.reshape(-1, *(1,) * (x.ndim - 1)) for A in (self.K, self.D))
        return self.chain.modal_product(K, x + h * rate) + self.chain.modal_product(D, rate)
