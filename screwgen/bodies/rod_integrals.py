"""The mass integrals of a rod as numbers, at the values that its file states."""

from __future__ import annotations

import itertools

import numpy as np

from ..lazily import sp
from ..reduction.invariants import EPS, BodyNode
from ..spec.link_class import TURN, LinkClass
from ..spec.robot import Link
from ..spec.stations import Stations
from . import markers
from .fields import Fields, xi
from .second_order import at_tip, entry, quadratic_terms
from .varying_fields import VaryingFields

DENSITIES = ("rhoIp", "rhoIy", "rhoIz")
"""The inertia of the sections about x, y, z."""


class Integrals:
    """The mass integrals of a rod as numbers."""

    def __init__(self, link: Link, key: LinkClass):
        self.key, self.length, self.start = key, float(link.length or 0.0), -float(link.frame_at or 0.0)
        kind = VaryingFields if key.stations else Fields
        self.fields = kind(key, sp.Float(self.length), sp.Float(self.start))
        self.values: dict[sp.Symbol, float] = {}
        for name in ("rhoA", *DENSITIES):
            if isinstance(self.fields, VaryingFields) and isinstance(link.section, Stations):
                self.fields.properties[name] = [sp.Float(x) for x in link.section.values(name)]
            elif getattr(link.section, name) is not None:
                self.values[sp.Symbol(name, real=True)] = getattr(link.section, name)

    def of(self, *generators: sp.Expr, weight: str = "rhoA") -> float:
        """The integral of a product."""
        return float(self.fields.integrate(sp.Mul(*generators), weight).subs(self.values))

    def gram(self) -> np.ndarray:
        """Integrals of products of the generators, rotary inertia about the centreline and second order included."""
        r = self.key.modes
        known: list[sp.Expr] = [sp.S.One, xi(), sp.S.Zero, sp.S.Zero, *self.fields.Phi().T.ravel()]
        G = np.zeros((len(known),) * 2)
        for i, j in itertools.combinations_with_replacement(range(len(known)), 2):
            G[i, j] = G[j, i] = self.of(known[i], known[j]) if known[i] != 0 and known[j] != 0 else 0.0
        for axis in self.key.turned:
            G[[1, 2, 3], [1, 2, 3]] += self.of(sp.S.One, weight=DENSITIES[axis]) * (0.5 - np.eye(3)[axis])
            for k, shape in enumerate(self.fields.turns(axis)[0]):
                if shape != 0:
                    self._turn(G, axis, 4 + 3 * k, self.of(shape, weight=DENSITIES[axis]) / 2)
        return G + self._lengthened(r)

    def _turn(self, G: np.ndarray, axis: int, mode: int, arm: float) -> None:
        """Add sections that turn about an axis with a mode: as displacements across, half of the momentum each."""
        first, second = (axis + 1) % 3, (axis + 2) % 3
        for a, b, sign in ((first, second, 1.0), (second, first, -1.0)):
            G[1 + a, mode + b] += sign * arm
            G[mode + b, 1 + a] += sign * arm

    def _lengthened(self, r: int) -> np.ndarray:
        """What the second-order displacement adds to the second moment, the part along the product of two modes."""
        out, (_, moment) = np.zeros((4 + 3 * r,) * 2), self._second()
        even = (moment + moment.transpose(1, 0, 2, 3)) / 2
        out[4:, 4:] = even.transpose(2, 0, 3, 1).reshape(3 * r, 3 * r)
        return out

    def second(self) -> tuple[np.ndarray, np.ndarray]:
        """The integral of the second-order displacement and its moment, (3, r, r) each."""
        sag, moment = self._second()
        return sag, np.einsum("cab,abkl->ckl", EPS, moment)

    def _second(self) -> tuple[np.ndarray, np.ndarray]:
        """``∫ h_c`` (3, r, r) and ``∫ r_a h_c`` (3, 3, r, r)."""
        r = self.key.modes
        sag, moment = np.zeros((3, r, r)), np.zeros((3, 3, r, r))
        for (c, axis), k, m in itertools.product(enumerate("xyz"), range(r), range(r)):
            h = entry(axis, k, m)
            if h in self.fields.second:
                sag[c, k, m], moment[0, c, k, m] = self.of(h), self.of(xi(), h)
        return sag, moment

    def node(self, s: float, name: str) -> BodyNode:
        """A section as a node; second-order parts are those of the tip."""
        psi = np.zeros((3, self.key.modes))
        for k, (d, i) in enumerate(self.key.directions):
            if d in TURN:
                (axis, sign), slope = TURN[d], d != "torsion"
                psi[axis, k] = sign * self.key.shapes(d).evaluate([s], int(slope))[i][0] / self.length**slope
        quadratic = self.key.order == 2 and s == 1.0
        parts = [
            [at_tip(self.key, term, sp.Float(self.length)) for term in x] if quadratic else ()
            for x in quadratic_terms()
        ]
        second = [np.array(x, float) if quadratic else np.zeros((3,) + psi.shape[1:] * 2) for x in parts]
        place = np.array([self.start + s * self.length, 0.0, 0.0])
        return BodyNode(name, place, markers.displacement(self.key, (s,))[0], psi, np.eye(3), *second)
