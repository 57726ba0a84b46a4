"""A moderate motion of robots in segments."""

from __future__ import annotations

import numpy as np


def state(model, seed: int, angle=2.0) -> tuple:
    """q, v, tau and w_ext of a moderate motion."""
    rng, m, r = np.random.default_rng(seed), model.n_joints, model.nq - model.n_joints
    q = np.append(rng.uniform(-angle, angle, m), rng.uniform(-2e-3, 2e-3, r))
    v = np.append(rng.uniform(-1, 1, m), rng.uniform(-0.05, 0.05, r))
    return q, v, rng.uniform(-5, 5, m), rng.uniform(-5, 5, (model.n_links, 6))
