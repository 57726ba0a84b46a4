"""Statics of robots with loops: postures that keep them closed, and the forces with which they do so."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..lazily import linalg
from ..simulation.mobility import closing, sharing
from .statics import Balance, Statics

ROUNDS, CLOSED = 20, 1e-13
"""Corrections that close the loops at most, and the gap, m or of cosines, at which they are closed."""
RANK = 1e-9
"""A row of the loops counts as dependent, for the coordinates that may move, where less than this part of it is new."""


@dataclass(frozen=True, eq=False)
class BalanceWithLoops(Balance):
    """The same under the forces of the loops: these are part of `force`, `stiffness` and `wrench`."""

    J: np.ndarray
    """(rows, nq): the derivative of the gaps with q."""
    motions: np.ndarray
    """(moving, d): orthonormal motions, in the coordinates D q, that keep the loops closed."""
    forces: np.ndarray
    """(rows,): of the loops."""
    loop_wrench: np.ndarray
    """(n, 6): what the loops exert on the tips, in the tip frames."""


class StaticsWithLoops(Statics):
    """The forces on a robot at rest whose loops hold it besides. What moves are the motions that keep these closed."""

    straight = False

    def at(self, q: np.ndarray) -> BalanceWithLoops:
        """The balance at `q`, with the loops' forces that leave the least force unbalanced."""
        b, i, D = super().at(q), self.moving, self.units[self.moving]
        J = self._loops(q, None)[1]
        A = J[:, i] / D
        shares = sharing(self.model, q, J, self.p)
        forces = shares * (linalg.lstsq(shares * A.T, b.force[i] / D, cond=RANK)[0] if len(i) else 0.0)
        bend, wrench = self._loops(q, forces)[3:]
        more = {"J": J, "forces": forces, "motions": linalg.null_space(A, rcond=RANK), "loop_wrench": wrench.T}
        own = {name: getattr(b, name) for name in Balance.__dataclass_fields__}
        own |= {"force": b.force - J.T @ forces, "stiffness": b.stiffness - bend}
        own["scale"] = np.maximum(b.scale, np.abs(J.T) @ np.abs(forces))
        return BalanceWithLoops(**own, **more)

    def _loops(self, q: np.ndarray, forces: np.ndarray | None) -> list[np.ndarray]:
        rows, rest = len(self.model.chain.closing.rows), np.zeros(self.model.nv)
        return [np.array(x) for x in closing(self.model)(q, rest, np.zeros(rows) if forces is None else forces, self.p)]

    def scaled(self, b: Balance) -> tuple[np.ndarray, np.ndarray]:
        force, K = super().scaled(b)
        Z = self.directions(b)
        return Z.T @ force, Z.T @ K @ Z

    def directions(self, b: Balance) -> np.ndarray:
        assert isinstance(b, BalanceWithLoops)
        return b.motions

    def moved(self, b: Balance, step: np.ndarray) -> Balance:
        there = super().moved(b, step)
        return there if np.max(np.abs(self._loops(there.q, None)[0])) < CLOSED else replace(there, energy=np.inf)

    def near(self, q: np.ndarray) -> np.ndarray:
        """The posture with closed loops next to `q`, by Newton's method; some posture where it does not converge."""
        i, D = self.moving, self.units[self.moving]
        for _ in range(ROUNDS):
            gap, J, *_ = self._loops(q, None)
            if not np.max(np.abs(gap)) >= CLOSED:
                break
            q = q.copy()
            q[i] -= linalg.lstsq(J[:, i] / D, gap[:, 0], cond=RANK)[0] / D
            if not np.isfinite(q).all():
                break
        return q

    def borne(self, b: Balance) -> np.ndarray:
        assert isinstance(b, BalanceWithLoops)
        return self.w_ext + b.loop_wrench

    def wrenches(self, b: Balance) -> np.ndarray:
        return self._functions(b.q, self.borne(b))[4].T
