"""The second-order part of a rod's shape: what ``R' = R hat(kappa)``, ``r' = R (e_x + gamma)`` adds to the linear one.

With the strains linear in the modal coordinates and ``psi = ∫ kappa`` the shape to second order from the base is

    u_2 = ∫(∫ hat(psi) hat(kappa) e_x + hat(psi) gamma),    theta_2 = 1/2 ∫ psi x kappa.

Both are quadratic forms: component c of ``u_2`` is ``1/2 eta^T H_c(ξ) eta``, with one matrix of shapes for each of the
three axes. Every entry is an integral of the product of two shapes, or of such an integral.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import sympy as sp

from ..bases import integrals
from ..spec.link_class import LinkClass


class Term(NamedTuple):
    """``factor · ∫…∫ first second``, integrated ``times`` over ξ; a factor is a direction and an order of derivative."""

    factor: sp.Expr
    first: tuple[str, int]
    second: tuple[str, int]
    times: int


NAMES = {"a": "axial", "y": "bending_y", "z": "bending_z", "t": "torsion"}


def _strains() -> tuple[sp.Matrix, sp.Matrix, sp.Matrix]:
    """``psi``, ``kappa`` and ``gamma``: the letter of a direction with the order of its derivative."""
    a1, y1, y2, z1, z2, t0, t1 = sp.symbols("a1 y1 y2 z1 z2 t0 t1")
    return sp.Matrix([t0, -z1, y1]), sp.Matrix([t1, -z2, y2]), sp.Matrix([a1, 0, 0])


def _terms(quadratic: sp.Matrix, times: int) -> list[list[Term]]:
    """The products of two strains in each component, which is integrated ``times``."""
    read = lambda x: (NAMES[x.name[0]], int(x.name[1]))  # noqa: E731
    out: list[list[Term]] = []
    for component in quadratic:
        polynomial = sp.Poly(sp.expand(component), *sorted(quadratic.free_symbols, key=str))
        factors = ([g for g, n in zip(polynomial.gens, powers, strict=True) for _ in range(n)] for powers in polynomial.monoms())
        pairs = zip(factors, polynomial.coeffs(), strict=True)
        out.append([Term(c, read(x), read(y), times) for (x, y), c in pairs] if component != 0 else [])
    return out


def _derived() -> tuple[list[list[Term]], list[list[Term]]]:
    psi, kappa, gamma = _strains()
    bent = _terms(psi.cross(kappa.cross(sp.Matrix([1, 0, 0]))), 2)
    stretched = _terms(psi.cross(gamma), 1)
    place = [b + s for b, s in zip(bent, stretched, strict=True)]
    return place, _terms(psi.cross(kappa) / 2, 1)


PLACE, TURN = _derived()
"""The terms of ``u_2`` and ``theta_2``, component by component."""


def entries(key: LinkClass, terms: list[Term]) -> Iterator[tuple[int, int, Term, int, int]]:
    """The modes whose product a term has, with the term and the number of each mode in its direction."""
    modes = {mode: k for k, mode in enumerate(key.directions)}
    counts = dict.fromkeys(NAMES.values(), 0) | {d: n + 1 for d, n in key.directions}
    for term in terms:
        for i in range(counts[term.first[0]]):
            for j in range(counts[term.second[0]]):
                yield modes[term.first[0], i], modes[term.second[0], j], term, i, j


def matrix(key: LinkClass, terms: list[Term], length: sp.Expr, weight: int | None) -> sp.Matrix:
    """The symmetric matrix ``H`` with ``1/2 eta^T H eta`` the sum of ``terms``.

    ``weight`` None: at the tip. Otherwise ``∫ s^weight H ds`` over the rod, with s from 0 to 1.
    """
    out = sp.zeros(key.modes, key.modes)
    for k, m, term, i, j in entries(key, terms):
        (first, a), (second, b) = term.first, term.second
        shapes = key.shapes(first), key.shapes(second)
        value = term.factor * integrals(*shapes, a, b, term.times, weight)[i][j] * length ** (term.times - a - b)
        out[k, m] += value
        out[m, k] += value
    return out
