"""The rows of stiff lines and of loops whose joints give way in a linearised motion, as implicit steps take them."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..backends.numpy.compliant import compliance
from ..backends.numpy.numeric import Numeric

Motions = tuple[np.ndarray, np.ndarray]
"""Small changes of coordinates and rates, (nv, k) each."""


class LinearisedRows(NamedTuple):
    """Rows about a state: slopes of their gaps (rows, nv), stiffness and damping (rows,); and over a step ``h`` what
    their unit forces accelerate, (nv, rows), without and with the rows of rigid loops."""

    J: np.ndarray
    k: np.ndarray
    c: np.ndarray
    free: np.ndarray
    held: np.ndarray
    h: float

    @classmethod
    def of(
        cls, numeric: Numeric, q: np.ndarray, tau: np.ndarray, h: float, answers: Callable[[np.ndarray], np.ndarray]
    ) -> LinearisedRows:
        """``answers (J) -> (nv, rows)``: what unit forces of rows accelerate over the step."""
        J, k, c = compliance(numeric, q, tau)
        free = held = answers(J)
        if numeric.chain.closing.rows:
            closing = numeric.gap_slopes(q)
            reach = answers(closing)
            held = free - reach @ numeric.row_forces(closing @ reach, closing @ free)
        return cls(J, k, c, free, held, h)

    def added(self, start: Motions, there: Motions, a: np.ndarray, ahead: bool) -> np.ndarray:
        """(nv, k): the accelerations beside ``a``, those with the forces at a stage; ``ahead``: it is not the start.

        The law is that of :mod:`...algorithms.compliant_functions`, but for what turns of the rows add to it.
        """
        (q, v), own, h = start, np.sum(self.J * self.free.T, axis=1), self.h
        late = [ahead * z / (1.0 + z) for z in (h * h * self.k * own, h * self.c * own)]
        S = h * (self.c * (1.0 + late[1]) + h * self.k * (1.0 + 3.0 * late[0]))
        column = lambda x: x[:, None]  # noqa: E731
        later = column(self.k) * (self.J @ q + column(h * (1.0 + 2.0 * late[0])) * (self.J @ v))
        less = self._force(*there) - later - column(self.c) * (self.J @ v)
        root = np.sqrt(S)
        firm = np.eye(len(S)) + column(root) * (self.J @ self.held) * root
        nu = less - column(root) * np.linalg.solve(firm, column(root) * (self.J @ (a + self.held @ less)))
        return np.asarray(self.held @ nu)

    def _force(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """(rows, k): the forces against the gaps at a motion."""
        return np.asarray(self.k[:, None] * (self.J @ q) + self.c[:, None] * (self.J @ v))
