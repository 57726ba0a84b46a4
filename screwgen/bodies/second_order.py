"""The second-order part of a rod's shape: what ``R' = R hat(kappa)``, ``r' = R (e_x + gamma)`` adds to the linear one.

With the strains linear in the modal coordinates and ``psi = ∫ kappa`` the shape to second order from the base is

    u_2 = ∫(∫ hat(psi) hat(kappa) e_x + hat(psi) gamma),    theta_2 = 1/2 ∫ psi x kappa.

Both are quadratic forms: component c of ``u_2`` is ``1/2 eta^T H_c(ξ) eta``, with one matrix of shapes for each of the
three axes. Every entry is an integral of the product of two shapes, or of such an integral.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from typing import NamedTuple

import numpy as np

from ..algebra.expression import Expression, Integral, Symbol, block
from ..algebra.notation import latex
from ..algebra.quadratic import form, half_form
from ..bases import Shapes, integrals
from ..ir.block import Binding, Block
from ..lazily import sp
from ..spec.link_class import LinkClass
from .moments import Moments, xi

AXES = "xyz"


class Term(NamedTuple):
    """``factor · ∫…∫ first second``, integrated ``times`` over ξ; of each strain its direction and derivative."""

    factor: sp.Expr
    first: tuple[str, int]
    second: tuple[str, int]
    times: int


NAMES = {"a": "axial", "y": "bending_y", "z": "bending_z", "t": "torsion", "v": "shear_y", "w": "shear_z"}


def _strains() -> tuple[sp.Matrix, sp.Matrix, sp.Matrix]:
    """``psi``, ``kappa`` and ``gamma``: the letter of a direction with the order of its derivative."""
    a1, y1, y2, z1, z2, t0, t1, v1, w1 = sp.symbols("a1 y1 y2 z1 z2 t0 t1 v1 w1")
    return sp.Matrix([t0, -z1, y1]), sp.Matrix([t1, -z2, y2]), sp.Matrix([a1, v1, w1])


def _terms(quadratic: sp.Matrix, times: int) -> list[list[Term]]:
    """The products of two strains in each component, which is integrated ``times``."""
    read = lambda x: (NAMES[x.name[0]], int(x.name[1]))  # noqa: E731
    out: list[list[Term]] = []
    for component in quadratic:
        polynomial = sp.Poly(sp.expand(component), *sorted(quadratic.free_symbols, key=str))
        out.append([])
        for powers, factor in polynomial.terms() if component != 0 else ():
            first, second = (read(g) for g, n in zip(polynomial.gens, powers, strict=True) for _ in range(n))
            out[-1].append(Term(factor, first, second, times))
    return out


@cache
def quadratic_terms() -> tuple[list[list[Term]], list[list[Term]]]:
    """The terms of ``u_2`` and ``theta_2``, component by component."""
    psi, kappa, gamma = _strains()
    bent = _terms(psi.cross(kappa.cross(sp.Matrix([1, 0, 0]))), 2)
    stretched = _terms(psi.cross(gamma), 1)
    place = [b + s for b, s in zip(bent, stretched, strict=True)]
    return place, _terms(psi.cross(kappa) / 2, 1)


def entries(key: LinkClass, terms: list[Term]) -> Iterator[tuple[int, int, Term, int, int]]:
    """The modes whose product a term has, with the term and the number of each mode in its direction."""
    modes = {mode: k for k, mode in enumerate(key.directions)}
    counts = dict.fromkeys(NAMES.values(), 0) | {d: n + 1 for d, n in key.directions}
    for term in terms:
        for i in range(counts[term.first[0]]):
            for j in range(counts[term.second[0]]):
                yield modes[term.first[0], i], modes[term.second[0], j], term, i, j


class EntryTerm(NamedTuple):
    """A part of an entry of ``H_c(ξ)``: ``factor l^power ∫…∫ psi_i^(.) psi_j^(.) ds``, as its term says."""

    factor: sp.Expr
    first: Shapes
    second: Shapes
    i: int
    j: int
    term: Term

    @property
    def power(self) -> int:
        return self.term.times - self.term.first[1] - self.term.second[1]

    @property
    def strains(self) -> tuple[Shapes, Shapes, int, int, int]:
        """The two families of shapes, the derivatives of each, and how often their product is integrated."""
        return self.first, self.second, self.term.first[1], self.term.second[1], self.term.times


def parts(key: LinkClass) -> dict[sp.Symbol, list[EntryTerm]]:
    """The entries of the ``H_c(ξ)``."""
    out: dict[sp.Symbol, list[EntryTerm]] = {}
    for axis, terms in zip(AXES, quadratic_terms()[0], strict=True):
        for k, m, term, i, j in entries(key, terms):
            families = key.shapes(term.first[0]), key.shapes(term.second[0])
            part = EntryTerm(term.factor * (2 if k == m else 1), *families, i, j, term)
            out.setdefault(entry(axis, k, m), []).append(part)
    return out


def entry(axis: str, k: int, m: int) -> sp.Symbol:
    """The entry of the symmetric ``H_c(ξ)`` of two modes."""
    return sp.Symbol(f"h_{axis}_{min(k, m) + 1}_{max(k, m) + 1}", real=True)


def at_tip(key: LinkClass, terms: list[Term], length: sp.Expr) -> np.ndarray:
    """The symmetric (r, r) matrix ``H`` with ``1/2 eta^T H eta`` the sum of ``terms`` at the tip, or at a station."""
    out = np.full((key.modes, key.modes), sp.S.Zero, dtype=object)
    for k, m, term, i, j in entries(key, terms):
        (first, a), (second, b) = term.first, term.second
        constant = integrals(key.shapes(first), key.shapes(second), a, b, term.times, end=key.section_at)[i][j]
        value = term.factor * constant * length ** (term.times - a - b)
        out[k, m] += value
        out[m, k] += value
    return out


def rows(x: Symbol, H: Sequence[Symbol]) -> Expression:
    """The matrix with the rows ``x^T H_c``."""
    return block(*([x.T @ h] for h in H))


def halves(b: Block, Gamma: Symbol, H: Sequence[Symbol], x: Symbol) -> Symbol:
    """``1/2 Gamma x`` (3, 1), of an earlier step ``Gamma`` with the rows ``x^T H_c``: each product computed once."""
    values, known = b.values, b.values[x.name][:, 0]
    entries = [half_form(values[h.name], known, values[Gamma.name][c]) for c, h in enumerate(H)]
    return _column(b, f"half {Gamma.name}", entries, sp.Rational(1, 2) * (Gamma @ x))


def forms(b: Block, name: str, H: Sequence[Symbol], x: Symbol) -> Symbol:
    """The column (3, 1) of ``x^T H_c x``, each product computed once; ``name`` is its own."""
    entries = [form(b.values[h.name], b.values[x.name][:, 0]) for h in H]
    return _column(b, name, entries, block(*([x.T @ (h @ x)] for h in H)))


def _column(b: Block, name: str, entries: list[sp.Expr], written: Expression) -> Symbol:
    return b.field(name, np.array([[entry] for entry in entries], dtype=object), latex(written))


class SecondOrder:
    """The second-order fields of a rod in its link's block, and their moments of mass.

    ``Phi_2 = d u_2/d eta`` has the rows ``eta^T H_c``. The fields are sums of generators, one for each of its entries.
    """

    def __init__(self, b: Block, fields: Moments, known: dict[sp.Symbol, object], modes: int):
        self.b, self.fields = b, fields
        eta, etadot = b.values["eta"], b.values["etadot"]
        at = lambda c, k, m: entry(c, k, m) if entry(c, k, m) in known else sp.S.Zero  # noqa: E731
        r = range(modes)
        self.H = [b.field(f"H_{c}", np.array([[at(c, k, m) for m in r] for k in r], dtype=object)) for c in AXES]
        self.rows = self._rows("phi2", eta)
        self.udot = self.rows.dot(etadot)
        self.Phi = b.field("Phi_eta", b.values["Phi"] + self.rows)
        self.u, self.bend = b.generators("u_2"), b.generators("bend")
        fields.name_coarse(b.values["u_2"], sp.Rational(1, 2) * self.rows.dot(eta))
        fields.name_coarse(b.values["bend"], [etadot.T.dot(b.values[H.name]).dot(etadot).item() for H in self.H])

    def _rows(self, name: str, x: np.ndarray) -> np.ndarray:
        """The (3, r) matrix with the rows ``x^T H_c``, each entry a generator."""
        out = np.array([self.b.values[H.name].dot(x)[:, 0] for H in self.H], dtype=object)
        for (i, k), value in np.ndenumerate(out):
            if value != 0:
                out[i, k] = sp.Symbol(f"{name}_{AXES[i]}_{k + 1}", real=True)
                self.b.bindings[out[i, k]] = Binding.STATE
                self.fields.name_coarse([out[i, k]], [value])
        return out

    def momenta(self, rhoA: Symbol) -> None:
        """``∫ρA H_c dξ``, and with it the moments of ``Phi_2``, ``u_2`` and of the acceleration at constant rates."""
        self.displaced = self._moments(rhoA, self.H, "E_{}", "sigma2", "bend_0")

    def moments(self, rhoA: Symbol) -> None:
        """The same, and those weighted by the place on the centreline, ``∫ρA ξ H_c dξ``."""
        place = self.b.field("xi", np.array([[xi()]], dtype=object))
        self.momenta(rhoA)
        self._moments(rhoA, [place @ H for H in self.H], "E_{}_1", "chi2", "bend_1", xi())

    def _moments(self, rhoA: Symbol, fields: list, names: str, row: str, bend: str, *arm: sp.Symbol) -> Symbol:
        """The moments, with a power of the place, of all second-order fields; returns that of ``u_2`` (3, 1)."""
        b, E = self.b, []
        for axis, field, H in zip(AXES, fields, self.H, strict=True):
            E.append(b.step(names.format(axis), Integral(field, rhoA, self.fields.integrate), symmetric=True))
            self._name(E[-1], b.values[H.name], arm)
        Gamma = b.step(row, rows(b.symbol("eta"), E))
        self._name(Gamma, self.rows, arm)
        displaced = halves(b, Gamma, E, b.symbol("eta"))
        self._name(displaced, b.values["u_2"], arm)
        self._name(b.step(bend, forms(b, f"forms {bend}", E, b.symbol("etadot"))), b.values["bend"], arm)
        return displaced

    def _name(self, step: Symbol, generators: np.ndarray, arm: tuple[sp.Symbol, ...]) -> None:
        for index, generator in np.ndenumerate(generators):
            if generator != 0:
                self.fields.name_moment("rhoA", self.b.values[step.name][index], *arm, generator)
