"""The lengths of tendons along a link, and the shapes that they and others need, apart from the product."""

from __future__ import annotations

from types import SimpleNamespace

import casadi as ca
import numpy as np
from oracle_exact import ExactLink, gauss


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
    most, rod = max(link.counts.values()), rod_of(link, table)
    count = table["modes"].get("points", most + 2 if rod.basis == "polynomial" else 2 * most + 4)
    a, b = tendon.get("from", 0.0), tendon.get("to", 1.0)
    begin, end = (np.array(x) for x in tendon["at"])
    slope, total = (end - begin) / ((b - a) * link.length), ca.SX(0)
    x, w = gauss(count)
    for s, weight in zip(x, w * (b - a) * link.length, strict=True):
        _, kappa, gamma = ExactLink.strains(rod, a + (b - a) * s)
        offset = begin + s * (end - begin)
        direction = ca.SX([1.0, 0, 0]) + ca.DM(gamma) @ eta + ca.cross(ca.DM(kappa) @ eta, ca.DM(offset)) + slope
        total += weight * ca.norm_2(direction)
    if table.get("order", 1) != 1:
        return total
    start = ca.substitute(total, eta, ca.SX.zeros(eta.numel()))
    pull = ca.substitute(ca.gradient(total, eta), eta, ca.SX.zeros(eta.numel()))
    return start + ca.dot(pull, eta)
