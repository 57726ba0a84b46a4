"""Stiff lines and loops whose joints give way, on NumPy arrays."""

from __future__ import annotations

import numpy as np

from ...algorithms.functions import EVERYTHING, MOTION
from ...arguments import Numbers
from .numeric import Numeric


def compliance(numeric: Numeric, q: Numbers, tau: Numbers) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of their rows the rates of the gaps per unit of each entry of v (rows, nv), stiffness and damping (rows,).

    A rope that is slack has none.
    """
    f = numeric._functions(MOTION)
    laws = f.under_inputs(list(map(float, tau))).row_laws()
    lengths = f.row_terms(list(map(float, q)), [0.0] * numeric.chain.nv)[: len(laws)]
    taut = [not law.slack or length > law.rest for law, length in zip(laws, lengths, strict=True)]
    k, c = np.array([(x * law.stiffness, x * law.damping) for x, law in zip(taut, laws, strict=True)], float).T
    return numeric.by_rates(lambda functions, q, v: functions.row_terms(q, v)[len(k) :], q), k, c


def settled(numeric: Numeric, q: Numbers, v: Numbers, tau: Numbers, w_ext: Numbers | None, h: float) -> np.ndarray:
    """The tip wrenches (n, 6) under which runs of implicit steps of ``h`` report: see
    :meth:`...algorithms.compliant_functions.CompliantFunctions.settled`."""
    flat = numeric.rows(q=q, v=v, tau=tau, w_ext=w_ext)
    found = numeric._functions(*EVERYTHING).settled(flat[0], flat[1], flat[2], flat[3], h)
    return np.array([float(x) for x in found]).reshape(-1, 6)  # type: ignore[arg-type]  # numbers, as all that is given
