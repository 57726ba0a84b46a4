"""The coordinates with inertia, spring and damper of their own: all modes, and the joints' where any is sprung."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...topology.chain import Chain


@dataclass
class OwnForces:
    """Inertia, stiffness and damping of these coordinates, the last ``n_given`` of ``q``.

    ``M``, ``K``, ``D`` (n_inertia,): the diagonal, then the entries below it where modes are coupled.
    """

    chain: Chain
    M: np.ndarray
    K: np.ndarray
    D: np.ndarray

    def of(self, x: np.ndarray) -> np.ndarray:
        """The part of ``q`` or ``v`` (nq, ...) that belongs to these coordinates."""
        return x[len(x) - self.chain.n_given :]

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
