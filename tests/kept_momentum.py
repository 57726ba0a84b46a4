"""A step that keeps momentum, as docs/robot.md measures it: the base's twist corrected by the locked inertia."""

import numpy as np
from helpers import rotation_of


def frames(q) -> np.ndarray:
    """(6, 6): momentum about the inertial origin, inertial axes, from that in axes of the base at its origin."""
    R, (x, y, z) = rotation_of(q[3:7]), q[:3]
    hat = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.block([[R, hat @ R], [np.zeros((3, 3)), R]])


def keeping(step, inertia):
    """Runs of `step(q, v, h)` without loads; `inertia(q)` is the mass matrix. The momentum stays that of the start."""

    def run(q, v, h: float, count: int, keep: bool) -> tuple[np.ndarray, np.ndarray]:
        first = frames(q) @ inertia(q)[:6] @ v
        for _ in range(count):
            q, v = step(q, v, h)
            rows = inertia(q)[:6]
            missing = np.linalg.solve(frames(q), first) - rows @ v
            v[:6] += np.linalg.solve(rows[:, :6], missing) * keep
        return q, v

    return run
