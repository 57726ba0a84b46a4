"""Tendons in phases: their lengths, and what their tensions do to the modes.

A tendon of length ``l(eta)`` and tension T acts on the modes with ``-T`` times the derivative of l, its *pull*. At
order 1 the length is linear in the modes, as strains are; at other orders it is that along the bent link.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..bodies.collocation import collocation, points
from ..ir.derivative import columns
from ..ir.program import Array, Value
from ..spec.link_class import LinkClass
from ..spec.tendons import TendonClass, offset_label
from . import matrices as mx
from .rod_sections import constants, length_of, modal_scale, rest_turns
from .scope import Scope


@dataclass(frozen=True)
class TendonPoint:
    """A point of a quadrature along a piece of a tendon, or a sum over several."""

    share: float
    """Its weight, as a share of the length of the link."""
    mixed: float
    """Where it is between the two offsets that the file states."""
    stretch: np.ndarray
    """(3, r): the stretch there by each mode."""
    curvature: np.ndarray
    """(3, r + p): the curvature there by each mode, and by each number at rest, times the length."""


def quadrature(key: LinkClass, tendon: TendonClass) -> list[TendonPoint]:
    """The Gauss points of a piece of a tendon."""
    (first, last), (a, b), rod = tendon.span, tendon.mixed, collocation(key)
    at = lambda s: (rod.stretch(s), rod.curvature(s))  # noqa: E731
    pieces = rod.within(first, last, points(key))
    pairs = [pair for x, w in pieces for pair in zip(x.tolist(), ((last - first) * w).tolist(), strict=True)]
    return [TendonPoint(share, a + (b - a) * s, *at(first + (last - first) * s)) for s, share in pairs]


def straight(key: LinkClass, tendon: TendonClass) -> list[TendonPoint]:
    """Two points, the ends, that give what all do where the link is straight: there all is linear in the offset."""
    (a, b), own = tendon.mixed, quadrature(key, tendon)
    total = lambda values: np.sum(list(values), axis=0)  # noqa: E731
    stretch = total(x.share * x.stretch for x in own)
    first, last = (
        total(x.share * (x.mixed - far) / (end - far) * x.curvature for x in own) for end, far in ((a, b), (b, a))
    )
    return [TendonPoint(1.0, a, stretch, first), TendonPoint(1.0, b, np.zeros_like(stretch), last)]


def lengths(s: Scope) -> None:
    """The lengths of the pieces of tendons along the link."""
    s.write("tendon_length", mx.array([_length(s, tendon) for tendon in s.key.tendons]))


def pulls(s: Scope) -> Array:
    """(n, r): of each piece along the link, the derivative of its length with the modes."""
    return mx.array([x for tendon in s.key.tendons for x in _pull(s, tendon)], (len(s.key.tendons), s.key.modes))


def write_pulls(s: Scope) -> None:
    """The same."""
    s.write("pull", pulls(s))


def pulled(s: Scope) -> Array:
    """(r,): what the tensions add to the bias forces of the modes."""
    if not s.key.tendons:
        return mx.zeros(s.key.modes)
    with s.step("tendons: what their tensions do to the modes"):
        return mx.multiply(pulls(s).T, s.read("tension"))


def pulled_slopes(s: Scope) -> Array:
    """(r, r): the derivative of that with the modes, at held tensions."""
    r = s.key.modes
    if not s.key.tendons or s.key.order == 1:
        return mx.zeros(r, r)
    return mx.array(columns([*pulled(s)], s.read("eta")), (r, r)).T


def power(s: Scope) -> None:
    """The power that each tension whose piece is here gives to the link."""
    rates = mx.multiply(pulls(s), s.read("etadot")) if s.key.tendons else mx.zeros(0)
    s.write("tendon_power", -(s.read("tension") * rates) if s.key.tendons else rates)


def _pull(s: Scope, tendon: TendonClass) -> Array:
    """(r,)"""
    bent, length = s.key.order != 1, length_of(s)
    at = quadrature(s.key, tendon) if bent else straight(s.key, tendon)
    total = _total(s, tendon, at, "pull_k", bent)
    return mx.array([length * x if d == "torsion" else x for x, (d, _) in zip(total, s.key.directions, strict=True)])


def _length(s: Scope, tendon: TendonClass) -> Value:
    """That of a piece, m."""
    bent = s.key.order != 1
    total = length_of(s) * _total(s, tendon, quadrature(s.key, tendon), "length_k", bent).item()
    return total if bent else total + mx.dot(_pull(s, tendon), s.read("eta"))


def _total(s: Scope, tendon: TendonClass, at: list[TendonPoint], what: str, bent: bool) -> Array:
    """The sum of a step of the tendon's block over its points, along the bent link or the straight one."""
    (per_length,), (first, last) = s.lower("link", {}, "per_length")[0], tendon.span
    eta = modal_scale(s) * s.read("eta") if bent else mx.zeros(s.key.modes)
    zeta = np.append(eta, rest_turns(s)) if s.key.rest else eta
    ends = [[per_length * s.constant(offset_label(tendon.number, end, axis)) for axis in "yz"] for end in range(2)]
    offset = lambda x: mx.array([0.0, *((1.0 - x) * a + x * b for a, b in zip(*ends, strict=True))])  # noqa: E731
    slope, total = (offset(tendon.mixed[1]) - offset(tendon.mixed[0])) * (1.0 / (last - first)), None
    for x in at:
        gamma_eta, kappa_eta = constants(x.stretch), constants(x.curvature)
        given = {"share": mx.array([x.share]), "offset": offset(x.mixed), "slope": slope}
        given |= {"gamma": mx.multiply(gamma_eta, eta), "kappa": mx.multiply(kappa_eta, zeta)}
        given |= {"gamma_eta": gamma_eta, "kappa_eta": kappa_eta[:, : s.key.modes]}
        (value,) = s.lower("tendon", given, what)
        total = value if total is None else total + value
    assert total is not None
    return total
