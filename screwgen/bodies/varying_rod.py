"""The rod of varying section: a cone, a telescopic boom, a flange. Its properties are stated at stations."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence

import numpy as np
import sympy as sp

from ..algebra.expression import Expression, Symbol, add, zeros
from ..algebra.notation import ALONG
from ..ir.block import Block
from ..ir.quantities import QUANTITIES
from ..spec.link_class import DIRECTIONS, LinkClass
from .fields import STRAIN
from .rod import Rod
from .rod_stiffness import SECTION
from .varying_fields import VaryingFields, weights

LETTERS = {"axial": "x", "bending_y": "y", "bending_z": "z", "torsion": "t"}


class VaryingRod(Rod):
    """A rod whose section varies. The modes of one direction are coupled, by inertia and by stiffness.

    The damping is diagonal, ``D_kk = 2 zeta sqrt(K_kk M_kk)`` of the assumed modes: closed in the parameters, and
    positive semidefinite.
    """

    kind = VaryingFields
    fields: VaryingFields

    def __init__(self, b: Block, key: LinkClass):
        self._values: dict[str, Sequence[sp.Symbol]] = {}
        super().__init__(b, key)

    def declare(self, start: Expression) -> None:
        """The fields along the rod, with the properties that the stations state."""
        super().declare(start)
        self.fields.properties = self._values

    def _property(self, name: str) -> Symbol:
        """The property as a field along the rod; its values at the stations are the parameters."""
        self._values[name] = self.b.values[at_stations(self.b, self.key, name).name][:, 0]
        display = QUANTITIES[name].display + ALONG
        return self.b.field(name, np.array([[sp.Symbol(name, real=True)]], dtype=object), display)

    def _name_products(self) -> None:
        """Products of the shapes of one direction."""
        M, phi, direction = self.b.values["M_Wphi"], self.fields.phi, self.key.directions
        for i, j in itertools.combinations_with_replacement(range(self.key.modes), 2):
            if direction[i][0] == direction[j][0]:
                weight = "rhoIp" if direction[i][0] == "torsion" else "rhoA"
                self.fields.name_moment(weight, M[i, j], phi[i], phi[j])

    def _section_stiffness(self) -> Symbol:
        """``∫ EA φ_x' φ_x'^T + EIz φ_y'' φ_y''^T + ...``: every direction by the property that resists it."""
        terms: list[Expression] = [zeros(self.key.modes, self.key.modes)]
        for direction, name, count in zip(DIRECTIONS, SECTION, self.key.counts, strict=True):
            if count:
                shapes = self.fields.strain()[[STRAIN[direction]]]
                shown = rf"\boldsymbol{{\varphi}}_{{\varepsilon {LETTERS[direction]}}}^{{\top}}"
                strain = self.b.field(f"strain_{direction}", shapes, shown)
                terms.append(self.integral(strain.T @ strain, self._property(name)))
        return self.b.step("K_full", add(*terms), symmetric=True)

    def _column(self, name: str, full: Symbol) -> Symbol:
        """The diagonal of a modal matrix; the entries below it are a column of their own."""
        values = self.b.values[full.name]
        out = self.b.step(name, self._entries(f"{name}_entries", rf"\mathrm{{diag}}\,{full.display}", np.diag(values)))
        if self.key.coupled:
            below = [values[place] for place in self.key.coupled]
            lower = self._entries(f"{name[0]}_lower", rf"\mathrm{{low}}\,{full.display}", below)
            self.b.step(f"{name[0]}_below", lower)
        return out

    @property
    def stiffness(self) -> Expression:
        """The (r, r) stiffness of the modes."""
        return self.b.symbol("K_full")

    def _entries(self, name: str, display: str, values: Iterable[sp.Expr]) -> Symbol:
        return self.b.field(name, np.array([*values], dtype=object).reshape(-1, 1), display)

    def _damping(self, inertia: Symbol) -> None:
        super()._damping(inertia)
        if self.key.damping and self.key.coupled:
            self.b.step("D_below", zeros(len(self.key.coupled)))


def acting(b: Block, key: LinkClass, name: str) -> list[Symbol]:
    """The values of a property at the stations that determine it along the link or segment."""
    values = b.entries(at_stations(b, key, name))
    return [values[k] for k in weights(key).acting()]


def at_stations(b: Block, key: LinkClass, name: str) -> Symbol:
    """The values of a property of the section at the stations, a parameter."""
    q = QUANTITIES[name]
    words = (q.display, q.unit, "-", f"{q.meaning}, at each station")
    return b.parameter(f"section_{name}", (len(key.stations), 1), *words, numbered=(0,))
