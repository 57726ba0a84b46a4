"""The rod of varying section: a cone, a telescopic boom, a flange. Its properties are stated at stations."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..algebra.expression import Expression, Symbol, add, zeros
from ..algebra.notation import ALONG
from ..ir.block import Block
from ..ir.quantities import QUANTITIES
from ..lazily import sp
from ..spec.link_class import LinkClass
from ..spec.modes import DIRECTIONS
from .collocation import collocation
from .coupled_rod import CoupledRod
from .fields import STRAIN, number
from .rod_stiffness import SECTION
from .varying_fields import VaryingFields, weights

LETTERS = dict(zip(DIRECTIONS, ("x", "y", "z", "t", r"\gamma y", r"\gamma z"), strict=True))


class VaryingRod(CoupledRod):
    """A rod whose section varies. The modes of one direction are coupled, by inertia and by stiffness."""

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
        self._values[name] = list(self.b.values[at_stations(self.b, self.key, name).name][:, 0])
        display = QUANTITIES[name].display + ALONG
        return self.b.field(name, np.array([[sp.Symbol(name, real=True)]], dtype=object), display)

    def sampled(self, name: str, s: float) -> sp.Expr:
        """A property of the section at the place s in [0, 1]: interpolated between the stations."""
        return sp.Add(*(number(w) * self._values[name][station] for station, w in weights(self.key).at(s).items()))

    def shared(self, name: str) -> list[sp.Expr]:
        """A property shared out among the Gauss points of an exact rod, per unit of its length."""
        values = self._values[name]
        return [sp.Add(*(number(w) * values[k] for k, w in row.items())) for row in collocation(self.key).shared]

    def _section_stiffness(self) -> Symbol:
        """``∫ EA φ_x' φ_x'^T + EIz φ_y'' φ_y''^T + ...``: every direction by the property that resists it."""
        terms: list[Expression] = [zeros(self.key.modes, self.key.modes)]
        for direction, name, count in zip(DIRECTIONS, SECTION, self.key.counts, strict=False):
            if count:
                shapes = self.fields.strain()[[STRAIN[direction]]]
                shown = rf"\boldsymbol{{\varphi}}_{{\varepsilon {LETTERS[direction]}}}^{{\top}}"
                strain = self.b.field(f"strain_{direction}", shapes, shown)
                terms.append(self.integral(strain.T @ strain, self._property(name)))
        return self.b.step("K_full", add(*terms), symmetric=True)


def acting(b: Block, key: LinkClass, name: str) -> list[Symbol]:
    """The values of a property at the stations that determine it along the link or segment."""
    values = b.entries(at_stations(b, key, name))
    return [values[k] for k in weights(key).acting()]


def at_stations(b: Block, key: LinkClass, name: str) -> Symbol:
    """The values of a property of the section at the stations, a parameter."""
    q = QUANTITIES[name]
    words = (q.display, q.unit, "-", f"{q.meaning}, at each station")
    return b.parameter(f"section_{name}", (len(key.stations), 1), *words, numbered=(0,))
