"""The mass integrals of a rod as numbers, at the values that its file states."""

from __future__ import annotations

import itertools

import numpy as np
import sympy as sp

from ..reduction.invariants import EPS, Node
from ..spec.link_class import LinkClass
from ..spec.robot import Link
from ..spec.stations import Stations
from . import markers
from .fields import AXIS, XI, Fields
from .second_order import PLACE, TURN, at_tip, entry
from .varying_fields import VaryingFields


class Integrals:
    """The mass integrals of a rod as numbers."""

    def __init__(self, link: Link, key: LinkClass):
        self.key, self.length, self.start = key, float(link.length or 0.0), -float(link.frame_at or 0.0)
        kind = VaryingFields if key.stations else Fields
        self.fields = kind(key, sp.Float(self.length), sp.Float(self.start))
        self.values: dict[sp.Symbol, float] = {}
        for name in ("rhoA", "rhoIp"):
            if isinstance(link.section, Stations):
                self.fields.properties[name] = [sp.Float(x) for x in link.section.values(name)]
            elif getattr(link.section, name) is not None:
                self.values[sp.Symbol(name, real=True)] = getattr(link.section, name)

    def of(self, *generators: sp.Expr, weight: str = "rhoA") -> float:
        """The integral of a product."""
        return float(self.fields.integrate(sp.Mul(*generators), weight).subs(self.values))

    def gram(self) -> np.ndarray:
        """Integrals of products of the generators, rotary inertia about the centreline and second order included."""
        r = self.key.modes
        known: list[sp.Expr] = [sp.S.One, XI, sp.S.Zero, sp.S.Zero, *self.fields.Phi().T.ravel()]
        G = np.zeros((len(known),) * 2)
        for i, j in itertools.combinations_with_replacement(range(len(known)), 2):
            G[i, j] = G[j, i] = self.of(known[i], known[j]) if known[i] != 0 and known[j] != 0 else 0.0
        if self.key.spin:
            spin = self.of(sp.S.One, weight="rhoIp")
            G[[1, 2, 3], [1, 2, 3]] += spin * np.array([-0.5, 0.5, 0.5])
        for k, shape in enumerate(self.fields.twist_row()[0]):
            if shape != 0:
                lever = self.of(shape, weight="rhoIp") / 2
                for a, b, sign in ((2, 2, 1.0), (3, 1, -1.0)):
                    place = 4 + 3 * k + b
                    G[a, place] += sign * lever
                    G[place, a] += sign * lever
        return G + self._lengthened(r)

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
                sag[c, k, m], moment[0, c, k, m] = self.of(h), self.of(XI, h)
        return sag, moment

    def node(self, s: float, name: str) -> Node:
        """A section as a node; second-order parts are those of the tip."""
        psi = np.zeros((3, self.key.modes))
        for k, (d, i) in enumerate(self.key.directions):
            shapes = self.key.shapes(d)
            if d == "torsion":
                psi[0, k] = shapes.evaluate([s], 0)[i][0]
            elif AXIS.get(d):
                slope = shapes.evaluate([s], 1)[i][0] / self.length
                psi[3 - AXIS[d], k] = slope if d == "bending_y" else -slope
        quadratic = self.key.order == 2 and s == 1.0
        parts = [
            [at_tip(self.key, term, sp.Float(self.length)) for term in x] if quadratic else () for x in (PLACE, TURN)
        ]
        second = [np.array(x, float) if quadratic else np.zeros((3,) + psi.shape[1:] * 2) for x in parts]
        place = np.array([self.start + s * self.length, 0.0, 0.0])
        return Node(name, place, markers.displacement(self.key, (s,))[0], psi, np.eye(3), *second)
