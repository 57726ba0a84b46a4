"""The equations of coordinates that brakes act on, among those of all others."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...algorithms.brake_functions import BrakedRows
from ...arguments import Loads, Numbers
from ...spec.brake import BRAKES
from ...topology.chain import Chain

if TYPE_CHECKING:
    from .numeric import Numeric


@dataclass(frozen=True)
class BalancedRates:
    """Rows ``A dvdot = forces`` of the accelerations' changes: those of the mass matrix, and where brakes act theirs.

    ``share`` (nv,): what is left of each row of ``M``, 1 without a brake; ``inertia`` (nv,): what brakes hold it with;
    ``rows``: those that brakes act on.
    """

    chain: Chain
    M: np.ndarray
    share: np.ndarray
    inertia: np.ndarray
    rows: BrakedRows | None

    @property
    def A(self) -> np.ndarray:
        return self.over(self.M)

    def over(self, M: np.ndarray) -> np.ndarray:
        """The same matrix with another mass matrix."""
        return self.share[:, None] * M + np.diag(self.inertia)

    def solve(self, forces: np.ndarray) -> np.ndarray:
        """The changes of the accelerations (nv, k) by generalised forces (nv, k)."""
        return np.linalg.solve(self.A, self.share[:, None] * forces)

    def changes(self, by_q: np.ndarray, by_v: np.ndarray, by_tau: np.ndarray) -> list[np.ndarray]:
        """Those by state and inputs, of which forces depend so, and brakes besides."""
        scaled = [self.share[:, None] * by for by in (by_q, by_v, by_tau)]
        if self.rows is not None:
            at, own = places(self.chain), self.chain.inputs[BRAKES]
            scaled[1][at, at] -= self.rows.by_rate
            scaled[2][at, range(own.start, own.stop)] -= self.rows.by_input
        A = self.A
        return [np.linalg.solve(A, by) for by in scaled]


def balance(
    numeric: Numeric, M: np.ndarray, q: Numbers, v: Numbers, vdot: Numbers, tau: Loads, w_ext: Loads
) -> BalancedRates:
    """The equations of the accelerations' changes in a state, with a mass matrix."""
    chain, share, inertia = numeric.chain, np.ones(len(M)), np.zeros(len(M))
    if not chain.braked:
        return BalancedRates(chain, M, share, inertia, None)
    rows = numeric.braking.braked_rows(*numeric.rows(q=q, v=v, vdot=vdot, tau=tau, w_ext=w_ext))
    share[places(chain)], inertia[places(chain)] = rows.share, rows.inertia
    return BalancedRates(chain, M, share, inertia, rows)


def places(chain: Chain) -> list[int]:
    """The coordinates that brakes act on, as indices in `v`."""
    return [chain.held_places[k] for k in chain.braked]
