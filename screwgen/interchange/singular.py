"""Whether a robot of rigid links can be moved: each joint must move some inertia, whatever joints behind it do."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..reduction.invariants import hat
from ..spec.axes import GENERIC
from .rigid import Pose, turned

TOO_LITTLE = 1e-12
"""Share of what a joint carries below which the inertia about its axis is rounding."""


def motion(axis: Sequence[float] | dict[str, Sequence[float]], q: float) -> Pose:
    """The motion of a joint by `q` along an axis of a robot file."""
    if isinstance(axis, dict):
        return Pose(np.eye(3), q * np.array(axis["slide"]) / np.linalg.norm(axis["slide"]))
    return Pose(turned(axis, q), np.zeros(3))


def subspace(axis: Sequence[float] | dict[str, Sequence[float]]) -> np.ndarray:
    """(6,): the unit twist [ω; v] of an axis."""
    a = np.array(axis["slide"] if isinstance(axis, dict) else axis)
    zero, unit = np.zeros(3), a / np.linalg.norm(a)
    return np.concatenate([zero, unit] if isinstance(axis, dict) else [unit, zero])


def adjoint(T: Pose) -> np.ndarray:
    """(6, 6): twists [ω; v] of a frame at T from those of the frame in which T is stated."""
    p = hat(T.p)
    return np.block([[T.R.T, np.zeros((3, 3))], [-T.R.T @ p, T.R.T]])


def first_without_inertia(
    carriers: Sequence[int],
    mounts: Sequence[Pose],
    axes: Sequence[list],
    inertias: Sequence[np.ndarray],
    armature: Sequence[float],
) -> int | None:
    """The number of a link whose joint moves nothing in a posture that is not special; None where all move something.

    Articulated inertias from the tips to the base: the pivot of each axis must be positive.  `mounts`: each joint frame
    in the frame of its carrier; `inertias` (6, 6) of the links about their frames; `armature` of each link's axes.
    """
    total = [inertia.copy() for inertia in inertias]
    for i in reversed(range(len(carriers))):
        inertia = total[i]
        placed = [motion(axis, GENERIC[k]) for k, axis in enumerate(axes[i])]
        for axis, moved in reversed(list(zip(axes[i], placed, strict=True))):
            S = subspace(axis)
            U = inertia @ S
            pivot = S @ U + armature[i]
            block = inertia[3:, 3:] if isinstance(axis, dict) else inertia[:3, :3]
            if pivot <= TOO_LITTLE * np.trace(block) or not pivot:
                return i
            inertia = inertia - np.outer(U, U) / pivot
            inertia = adjoint(moved).T @ inertia @ adjoint(moved)
        if carriers[i] >= 0:
            X = adjoint(mounts[i])
            total[carriers[i]] += X.T @ inertia @ X
    return None
