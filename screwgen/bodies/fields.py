"""The field of a rod: mode shapes as matrices, and integrals along it in closed form."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from ..algebra.expression import Symbol
from ..bases import ORDER, Shapes, integrals, products
from ..ir.block import Block
from ..lazily import sp
from ..spec.link_class import AXIS, TURN, LinkClass
from ..spec.markers import TIP
from ..spec.modes import DIRECTIONS
from .moments import Moments, xi
from .second_order import EntryTerm, parts

STRAIN = {direction: row for row, direction in enumerate(DIRECTIONS)}
"""Row of the strain vector u_x', u_y'', u_z'', θ_x', γ_y, γ_z; without shear the first four."""


def length(b: Block, key: LinkClass) -> Symbol:
    """The length of the rod: the link's, or that of one of its equal segments."""
    if key.segments == 1:
        return b.parameter("length", (1, 1))
    whole = b.parameter("length", (1, 1), "l_{0,i}", meaning="length of the link, all segments")
    return b.step("segment", sp.Rational(1, key.segments) * whole)


class Fields(Moments):
    """The generators of a link class, their basis constants, and the rule that integrates them."""

    def __init__(self, key: LinkClass, length: sp.Expr, start: sp.Expr):
        self.key, self.length, self.start = key, length, start
        self.phi = [sp.Symbol(f"phi_{k + 1}", real=True) for k in range(key.modes)]
        self.strain_shape = [sp.Symbol(f"psi_{k + 1}", real=True) for k in range(key.modes)]
        self._constants = {d: key.shapes(d) for d, _ in key.directions}
        self.second = parts(key) if key.order == 2 else {}
        turned = [k for k, (d, _) in enumerate(key.directions) if d in TURN and TURN[d][0] in key.rotary]
        self.slope = {k: sp.Symbol(f"slope_{k + 1}", real=True) for k in turned}
        super().__init__([xi(), *self.phi, *self.strain_shape, *self.slope.values(), *self.second])

    # the shapes as matrices -------------------------------------------------------------------

    def Phi(self, values: Sequence[sp.Expr] | None = None) -> np.ndarray:
        """The 3 x r matrix of displacement shapes; torsion columns are zero."""
        return self._matrix(3, lambda d: AXIS.get(d), values or self.phi)

    def turns(self, axis: int) -> np.ndarray:
        """The 1 x r row of the sections' turns about an axis: torsion shapes, -u_z' or u_y'."""
        sign = {direction: sign for direction, (turned, sign) in TURN.items() if turned == axis}
        shapes = [sign.get(d, 0) * self.slope.get(k, self.phi[k]) for k, (d, _) in enumerate(self.key.directions)]
        return self._matrix(1, lambda d: 0 if d in sign else None, shapes)

    def strain(self) -> np.ndarray:
        """The strain operator: u_x', u_y'', u_z'', θ_x' and, with shear, γ_y and γ_z of every mode."""
        return self._matrix(len(self.key.counts), lambda d: STRAIN[d], self.strain_shape)

    def translational(self) -> np.ndarray:
        """The 1 x r row of displacement shapes regardless of their axis."""
        return self._matrix(1, lambda d: 0 if d in AXIS else None, self.phi)

    def rotation(self) -> np.ndarray:
        """Ψ(c), 3 x r: the rotation of the tip section, [torsion angle, -u_z', u_y']."""
        out = np.full((3, self.key.modes), sp.S.Zero, dtype=object)
        for k, (d, _) in enumerate(self.key.directions):
            if d == "torsion":
                out[0, k] = self._at_section(k, 0)
            elif d in TURN:
                row, sign = TURN[d]
                out[row, k] = sign * self._at_section(k, 1) / self.length
        return out

    def tip(self) -> np.ndarray:
        """Φ(c), 3 x r: the displacement of the tip section."""
        return self.Phi([self._at_section(k, 0) for k in range(self.key.modes)])

    def _at_section(self, k: int, derivative: int) -> sp.Expr:
        """The value of a mode's shape, or its slope, at the tip, or at the station that stands for it."""
        (shape, i), s = self._shape(k), self.key.section_at
        if s == TIP:
            return number((shape.tip_slope if derivative else shape.tip_value)[i])
        return number(shape.evaluate((s,), derivative)[i][0])

    def _matrix(self, rows: int, row_of: Callable[[str], int | None], values: Sequence[sp.Expr]) -> np.ndarray:
        out = np.full((rows, self.key.modes), sp.S.Zero, dtype=object)
        for k, (d, _) in enumerate(self.key.directions):
            if row_of(d) is not None:
                out[row_of(d), k] = values[k]
        return out

    # integration ------------------------------------------------------------------------------

    def _fine(self, monomial: list[sp.Symbol]) -> sp.Expr:
        """The integral of a product of ξ, φ_k, slopes and strain shapes: powers of l times constants of the basis.

        The grading of the second order: with a second-order shape everything else is that of the undeformed rod.
        """
        l, a = self.length, self.start
        powers = sum(g == xi() for g in monomial)
        shapes = [self.phi.index(g) for g in monomial if g in self.phi]
        strains = [self.strain_shape.index(g) for g in monomial if g in self.strain_shape]
        if slopes := self._slopes(monomial):
            return self._turned(slopes)
        if second := [g for g in monomial if g in self.second]:
            if len(monomial) > 1 + powers:
                return sp.S.Zero
            terms = self._arms(second[0], powers)
            return sp.Add(*(l**n * x * integrals(*part.strains, k)[part.i][part.j] for n, x, part, k in terms))
        if strains:
            return self._stiffness(*strains)
        if not shapes:
            return sum(sp.binomial(powers, j) * a ** (powers - j) * l ** (j + 1) / (j + 1) for j in range(powers + 1))
        if len(shapes) == 2 and powers == 0:
            return l * self.gram(*shapes)
        if len(shapes) == 1 and powers <= 1:
            shape, k = self._shape(shapes[0])
            integral = number(shape.integral[k])
            return l * integral if powers == 0 else l * (a * integral + l * number(shape.moment[k]))
        raise ValueError(f"no closed form for the integral of {sp.Mul(*monomial)}")

    def _arms(self, second: sp.Symbol, powers: int) -> Iterator[tuple[int, sp.Expr, EntryTerm, int]]:
        """The integral of a power of ξ times a second-order shape: power of l, factor, part, and power of s."""
        for part, k in itertools.product(self.second[second], range(powers + 1)):
            arm = sp.binomial(powers, k) * self.start ** (powers - k)
            yield k + 1 + part.power, arm * part.factor, part, k

    def _slopes(self, monomial: list[sp.Symbol]) -> list[int]:
        """The modes whose slopes a product has."""
        return [k for g in monomial for k, slope in self.slope.items() if g == slope]

    def _turned(self, slopes: list[int]) -> sp.Expr:
        """The integral of a slope, or of the product of two of one direction."""
        (shape, i), (_, j) = self._shape(slopes[0]), self._shape(slopes[-1])
        if len(slopes) == 1:
            return number(shape.tip_value[i])
        return number(integrals(shape, shape, 1, 1, 1)[i][j]) / self.length

    def _shape(self, k: int) -> tuple[Shapes, int]:
        direction, i = self.key.directions[k]
        return self._constants[direction], i

    def gram(self, k: int, m: int) -> sp.Expr:
        """``∫ psi_k psi_m ds`` of two modes."""
        (first, i), (second, j) = self._shape(k), self._shape(m)
        return number(products(first, second)[i][j])

    def _stiffness(self, k: int, m: int) -> sp.Expr:
        (direction, i), (shape, _) = self.key.directions[k], self._shape(k)
        order = ORDER[direction]
        return number(shape.stiffness[i]) / self.length ** (2 * order - 1) if k == m else sp.S.Zero


def number(value: float) -> sp.Expr:
    """A basis constant: exact if it is a whole number, else the nearest double."""
    value = float(value)
    return sp.Integer(int(value)) if value == int(value) else sp.Float(value)
