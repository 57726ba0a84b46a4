"""The lengths of tendons along a link, and the shapes that they and others need, apart from the product."""

from __future__ import annotations

from types import SimpleNamespace

import casadi as ca
import numpy as np
from oracle_exact import ExactLink, between, count_of_points, curvature_at_rest


def rod_of(link, table: dict) -> SimpleNamespace:
    """What the shapes of a link of any order need, by the names of those that are exact."""
    rod = SimpleNamespace(counts=link.counts, basis=table["modes"].get("basis", "polynomial"), length=link.length)
    rod._tables = lambda s: ExactLink._tables(rod, s)
    return rod


def tables(link, table: dict, s: float) -> dict[str, np.ndarray]:
    """Of each direction (3, r): the shapes at a section, their slopes and second derivatives with s."""
    return rod_of(link, table)._tables(s) if table.get("modes") else {}


def tendon_length(link, table: dict, tendon: dict, eta: ca.SX) -> ca.SX:
    """The length of a piece of a tendon along a link: ``∫ |e_x + gamma + kappa x d + d'| ds``, at Gauss points."""
    rod, rest, count = rod_of(link, table), table.get("rest"), count_of_points(table)
    a, b = tendon.get("from", 0.0), tendon.get("to", 1.0)
    begin, end = (np.array(x) for x in tendon["at"])
    slope, total = (end - begin) / ((b - a) * link.length), ca.SX(0)
    for s, weight in zip(*between(rest, a, b, count), strict=True):
        _, kappa, gamma = ExactLink.strains(rod, s)
        offset, bend = begin + (s - a) / (b - a) * (end - begin), ca.DM(kappa) @ eta + curvature_at_rest(rest, s)
        direction = ca.SX([1.0, 0, 0]) + ca.DM(gamma) @ eta + ca.cross(bend, ca.DM(offset)) + slope
        total += weight * link.length * ca.norm_2(direction)
    if table.get("order", 1) != 1:
        return total
    start = ca.substitute(total, eta, ca.SX.zeros(eta.numel()))
    pull = ca.substitute(ca.gradient(total, eta), eta, ca.SX.zeros(eta.numel()))
    return start + ca.dot(pull, eta)
