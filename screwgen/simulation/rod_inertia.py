"""The inertia of exact rods beside that with twice as many points, from the sections that their points place.

All is of a uniform rod of unit length and unit mass, with modal coordinates of unit length, many states at once.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial
from itertools import pairwise

import numpy as np

from ..bodies.collocation import FINE, RodTurn, collocation, gauss, points
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
    line, unit = partial(centreline, key, places=tuple(PLACES.tolist())), STEP * np.eye(zeta.shape[1])
    r, by_modes = line(zeta), [(line(zeta + unit[m]) - line(zeta - unit[m])) / (2 * STEP) for m in moving]
    turned = [np.cross(axis, r) for axis in np.eye(3)]
    moved = [np.broadcast_to(axis, r.shape) for axis in np.eye(3)]
    columns = np.stack([*turned, *moved, *by_modes])
    return np.einsum("s,ansi,bnsi->nab", WEIGHTS, columns, columns)


def centreline(key: LinkClass, zeta: np.ndarray, places: tuple[float, ...]) -> np.ndarray:
    """That of a rod of unit length (N, places, 3) in states (N, r + p), from the tangents at the points of the rod."""
    turns, stretches, reach = _numbers(key, places)
    R, tangents = transform.Rotation.from_quat(np.tile([0.0, 0.0, 0.0, 1.0], (len(zeta), 1))), []
    for turn, stretch in zip(turns, stretches, strict=True):
        crossed = sum((np.cross(zeta @ a.T, zeta @ b.T) for a, b in turn.crossed), np.zeros(3))
        R = R * transform.Rotation.from_rotvec(zeta @ turn.linear.T + crossed)
        tangents.append(R.apply(np.array([1.0, 0.0, 0.0]) + zeta[:, : key.modes] @ stretch.T))
    return np.einsum("pk,kni->npi", reach, np.array(tangents))


@cache
def _numbers(key: LinkClass, places: tuple[float, ...]) -> tuple[list[RodTurn], list[np.ndarray], np.ndarray]:
    """The turns from point to point of a rod, the stretches there by its modes, and what integrates to ``places``."""
    rod = collocation(key)
    at = rod.places.tolist()
    turns = [rod.turn(a, b) for a, b in pairwise([0.0, *at])]
    return turns, [rod.stretch(s) for s in at], np.array([rod.reach(x) for x in places])


def _apart(coarse: np.ndarray, fine: np.ndarray) -> float:
    """The largest eigenvalue, in size, of the difference of two symmetric matrices over the second."""
    size = np.sqrt(np.diag(fine))
    kept = size > 1e-6 * size.max(initial=0.0)
    scale = np.outer(size[kept], size[kept])
    values, vectors = np.linalg.eigh(fine[np.ix_(kept, kept)] / scale)
    known = values > DEPENDENT * values.max(initial=0.0)
    whole = vectors[:, known] / np.sqrt(values[known])
    return float(np.abs(np.linalg.eigvalsh(whole.T @ ((coarse - fine)[np.ix_(kept, kept)] / scale) @ whole)).max())
