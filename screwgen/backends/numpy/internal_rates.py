"""The derivatives of the rates of internal states, below those of accelerations, on NumPy arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...algorithms.inverse_slopes import Slopes
from ...algorithms.robot_programs import force_rate_slopes
from ...arguments import Loads, Numbers

if TYPE_CHECKING:
    from .numeric import Numeric


def with_internal_rates(
    numeric: Numeric, found: Slopes, at: tuple[Numbers, Numbers, Loads], by: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Derivatives of accelerations ``by`` q, v and tau, side by side, with those of the rates of internal states below.

    Those of laws are among the slopes; those of what one program of the whole robot finds are taken ``at`` q, v, tau.
    """
    chain, z_u = numeric.chain, np.zeros((len(found.z_q), numeric.chain.n_tau))
    if chain.n_force_states:
        q, v, tau = numeric.rows(**dict(zip(("q", "v", "tau"), at, strict=True)))
        given = {"q": q, "v": v, "tau": tau, "start": v[chain.force_states], "h": [0.0], "p": numeric.p}
        made = numeric.whole("force_rate_slopes", lambda: force_rate_slopes(chain, "parameters"), given)
        slopes = {name: np.array(values, float).reshape(chain.n_force_states, -1) for name, values in made.items()}
        rows = slice(chain.force_states.start - chain.nv, None)
        found.z_q[rows], found.z_v[rows], z_u[rows] = slopes["by_q"], slopes["by_v"], slopes.get("by_tau", 0.0)
        found.z_v[rows, chain.force_states] += slopes["by_start"]
    by_q, by_v, by_tau = np.split(by, [chain.nv, chain.nv + chain.nvz], axis=1)
    return np.vstack([by_q, found.z_q]), np.vstack([by_v, found.z_v]), np.vstack([by_tau, z_u])
