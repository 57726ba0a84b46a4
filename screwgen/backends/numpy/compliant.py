"""Loops whose joints give way, on NumPy arrays."""

from __future__ import annotations

import numpy as np

from ...algorithms.functions import MOTION
from ...arguments import Numbers
from .numeric import Numeric


def compliance(numeric: Numeric, q: Numbers) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of their rows the rates of the gaps per unit of each entry of v (rows, nv), stiffness and damping (rows,)."""
    k, c = np.array(numeric._functions(MOTION).stiffness_and_damping(), float).reshape(-1, 2).T
    return numeric.by_rates(lambda functions, q, v: functions.row_terms(q, v)[len(k) :], q), k, c
