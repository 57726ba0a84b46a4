"""The inertia of exact rods beside that with twice as many points, from the sections that their points place.

All is of a uniform rod of unit length and unit mass, with modal coordinates of unit length, many states at once.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import accumulate, pairwise

import numpy as np

from ..bodies.collocation import FINE, collocation, gauss, points
from ..lazily import transform
from ..spec.link_class import LinkClass

PLACES, WEIGHTS = gauss(2 * FINE)
STEP = 1e-5
"""The change of a modal coordinate of unit length by which places are differentiated."""
DEPENDENT = 1e-8
"""Motions whose inertia is below this part of the largest, over their own entries, are no motions of their own."""


def inertia_error(key: LinkClass, eta: np.ndarray, rest: np.ndarray) -> float:
    """The largest part by which the inertia of a rod is off in states (N, r) of unit length, in any of its motions.

    `rest`: the numbers of its curvature at rest, times the length.

    It is an eigenvalue of the difference over the inertia: accelerations under given forces are off by about as much.
    """
    fine = replace(key, points=2 * points(key))
    zeta = np.hstack([eta, np.tile(rest, (len(eta), 1))])
    pairs = zip(*(inertia(one, zeta) for one in (key, fine)), strict=True)
    return max((_apart(coarse, exact) for coarse, exact in pairs), default=0.0)


def inertia(key: LinkClass, zeta: np.ndarray) -> np.ndarray:
    """(N, 6 + modes that move the centreline, the same): of the turn and the motion of its base, and of its modes.

    `zeta` (N, r + p): modal coordinates of unit length, then the numbers of the curvature at rest.
    """
    moving = [m for m, (direction, _) in enumerate(key.directions) if direction != "torsion"]
    steps = STEP * np.eye(zeta.shape[1])[moving]
    states = np.concatenate([zeta[None], zeta + steps[:, None], zeta - steps[:, None]])
    lines = centreline(key, states.reshape(-1, zeta.shape[1]), tuple(PLACES.tolist()))
    r, *moved_by = lines.reshape(*states.shape[:2], *lines.shape[1:])
    by_modes = [(moved_by[k] - moved_by[k + len(moving)]) / (2 * STEP) for k in range(len(moving))]
    turned = [np.cross(axis, r) for axis in np.eye(3)]
    moved = [np.broadcast_to(axis, r.shape) for axis in np.eye(3)]
    columns = np.stack([*turned, *moved, *by_modes])
    return np.einsum("s,ansi,bnsi->nab", WEIGHTS, columns, columns)


def centreline(key: LinkClass, zeta: np.ndarray, places: tuple[float, ...]) -> np.ndarray:
    """That of a rod of unit length (N, places, 3) in states (N, r + p), from the tangents at the points of the rod."""
    linear, crossed, stretches, reach = _numbers(key, places)
    angles = zeta @ linear.swapaxes(1, 2)
    for a, b in np.moveaxis(crossed, 0, 2):
        angles += np.cross(zeta @ a.swapaxes(1, 2), zeta @ b.swapaxes(1, 2))
    turns = transform.Rotation.from_rotvec(angles.reshape(-1, 3)).as_matrix().reshape(*angles.shape, 3)
    strained = np.array([1.0, 0.0, 0.0]) + zeta[:, : key.modes] @ stretches.swapaxes(1, 2)
    poses = accumulate(turns, np.matmul)
    tangents = np.array([(R @ t[..., None])[..., 0] for R, t in zip(poses, strained, strict=True)])
    return np.einsum("pk,kni->npi", reach, tangents)


@cache
def _numbers(key: LinkClass, places: tuple[float, ...]) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Of the turns from point to point of a rod the linear parts (k, 3, r + p) and the pairs of their products.

    Then the stretches at the points (k, 3, r) and what integrates the tangents there to ``places`` (places, k).
    Pairs (k, pairs, 2, 3, r + p): where a turn has fewer than another the rest are zeros.
    """
    rod = collocation(key)
    at = rod.places.tolist()
    turns = [rod.turn(a, b) for a, b in pairwise([0.0, *at])]
    linear = np.array([turn.linear for turn in turns])
    crossed = np.zeros((len(at), max(len(turn.crossed) for turn in turns), 2, *linear.shape[1:]))
    for padded, turn in zip(crossed, turns, strict=True):
        padded[: len(turn.crossed)] = np.array(turn.crossed).reshape(-1, *crossed.shape[2:])
    return linear, crossed, np.array([rod.stretch(s) for s in at]), np.array([rod.reach(x) for x in places])


def _apart(coarse: np.ndarray, fine: np.ndarray) -> float:
    """The largest eigenvalue, in size, of the difference of two symmetric matrices over the second."""
    size = np.sqrt(np.diag(fine))
    kept = size > 1e-6 * size.max(initial=0.0)
    scale = np.outer(size[kept], size[kept])
    values, vectors = np.linalg.eigh(fine[np.ix_(kept, kept)] / scale)
    known = values > DEPENDENT * values.max(initial=0.0)
    whole = vectors[:, known] / np.sqrt(values[known])
    return float(np.abs(np.linalg.eigvalsh(whole.T @ ((coarse - fine)[np.ix_(kept, kept)] / scale) @ whole)).max())
