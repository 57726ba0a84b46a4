"""The sections of a link as markers: what a unit of each mode does to the section at s, as numbers.

Drawings, strain gauges and the strains of a linearisation ask here, and know nothing of bases and directions.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ..bases import ORDER
from ..reduction.invariants import Invariants
from ..spec.link_class import AXIS, LinkClass

STRAIN_UNITS = dict.fromkeys(ORDER, "1") | {"bending_y": "1/m", "bending_z": "1/m", "torsion": "rad/m"}
NEAR = 0.01
"""Distance from the straight line between base and tip, over its length, within which a node shapes the line drawn."""


class Strain(NamedTuple):
    """A strain of the centreline at a section, ``weights @ eta[modes] / l**order`` with the length l of the link."""

    direction: str
    """``axial`` (1), ``bending_y``, ``bending_z`` (1/m), ``torsion`` (rad/m), ``shear_y`` or ``shear_z`` (1)."""
    modes: list[int]
    """The modes that cause it, neighbours in the link's modal coordinates."""
    weights: list[float]
    """The derivatives of their shapes with respect to s."""
    order: int


@lru_cache(maxsize=64)
def displacement(key: LinkClass, points: tuple[float, ...]) -> np.ndarray:
    """(points, 3, r): displacement of the centreline at s in [0, 1] by each mode, in F_i components.

    The line of a body from a file runs from base to tip through its nodes that are near the straight line between.
    """
    if key.elastic is not None:
        return through_nodes(key.elastic, np.array(points))
    out = np.zeros((len(points), 3, key.modes))
    for direction in dict.fromkeys(d for d, _ in key.directions if d in AXIS):
        out[:, AXIS[direction], _columns(key, direction)] = _values(key, direction, points)
    return out


def through_nodes(body: Invariants, points: np.ndarray) -> np.ndarray:
    """(points, 3, r): between two nodes the cubic that has their displacements, and their rotations as slopes."""
    from scipy.interpolate import CubicHermiteSpline  # half a second, which arms without such bodies do not need

    places: dict = {}
    line = body.tip.origin
    for n in (body.base, body.tip, *body.nodes[1:-1]):
        s = float(n.origin @ line / (line @ line)) if body.reach else 0.0
        if 0 <= s <= 1 and np.linalg.norm(n.origin - s * line) <= NEAR * body.reach:
            places.setdefault(round(s, 6), n)
    if len(places) < 2:
        return points[:, None, None] * body.tip.phi
    nodes = [places[s] for s in sorted(places)]
    slopes = [np.cross(n.psi.T, line).T for n in nodes]
    return CubicHermiteSpline(sorted(places), np.array([n.phi for n in nodes]), np.array(slopes))(points)


@lru_cache(maxsize=64)
def twist(key: LinkClass, points: tuple[float, ...]) -> np.ndarray:
    """(points, r): torsion angle of the sections at s in [0, 1] by each mode, about x of F_i."""
    out = np.zeros((len(points), key.modes))
    if columns := _columns(key, "torsion"):
        out[:, columns] = _values(key, "torsion", points)
    return out


def strained(key: LinkClass) -> list[str]:
    """The directions that have modes, each with a strain at every section; none of a body from a file."""
    return list(dict.fromkeys(d for d, _ in key.directions if d in ORDER))


def strains(key: LinkClass, s: float) -> list[Strain]:
    """The strains at the section s, one for each direction of `strained`."""
    return [
        Strain(d, _columns(key, d), [float(x) for x in _values(key, d, (s,), ORDER[d])[0]], ORDER[d])
        for d in strained(key)
    ]


def _columns(key: LinkClass, direction: str) -> list[int]:
    return [k for k, (d, _) in enumerate(key.directions) if d == direction]


@lru_cache(maxsize=512)
def _values(key: LinkClass, direction: str, points: tuple[float, ...], order: int = 0) -> np.ndarray:
    return np.array(key.shapes(direction).evaluate(points, order)).T
