"""The oracle's shape functions, by textbook formulas with many digits; no package code."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import mpmath as mp
import numpy as np

DIRECTIONS = ("axial", "bending_y", "bending_z", "torsion", "shear_y", "shear_z")


class Shapes(NamedTuple):
    """r shape functions ψ of one direction on s in [0, 1], with N quadrature nodes."""

    nodes: np.ndarray  # (r, N): ψ_k(s_j)
    tip: np.ndarray  # (r,): ψ_k(1)
    tip_slope: np.ndarray  # (r,): ψ_k'(1)
    stiffness: np.ndarray  # (r, r): ∫ψ''ψ'' ds in bending, ∫ψ'ψ' ds for axial and torsion
    strain: np.ndarray  # (r, N): ψ'' in bending, ψ' in the others
    slope: np.ndarray  # (r, N): ψ'


WHOLE = ((0.0, 1.0),)
"""The intervals of a smooth integrand."""


@cache
def quadrature(count: int, parts: tuple = WHOLE) -> tuple[np.ndarray, np.ndarray]:
    """Gauss-Legendre nodes and weights, `count` in each of the intervals that [0, 1] is divided into."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    places = [start + (end - start) * (nodes + 1.0) / 2.0 for start, end in parts]
    return np.concatenate(places), np.concatenate([(end - start) * weights / 2.0 for start, end in parts])


@cache
def bending_shapes(basis: str, modes: int, count: int, parts: tuple = WHOLE) -> Shapes:
    """Bending shapes of the named basis on `count` quadrature nodes."""
    return _shapes({"clamped_free": clamped_free, "polynomial": polynomial}[basis](modes), 2, count, parts)


@cache
def rod_shapes(basis: str, modes: int, count: int, parts: tuple = WHOLE) -> Shapes:
    """Axial, torsion and shear shapes of the named basis on `count` quadrature nodes."""
    if basis == "clamped_free":
        return sine_shapes(modes, count, parts)
    return _shapes(polynomial(modes, 1), 1, count, parts)


def _shapes(functions: list, order: int, count: int, parts: tuple) -> Shapes:
    nodes, weights = quadrature(count, parts)
    table, tip = tabulate(functions, nodes), tabulate(functions, [1.0])
    stiffness = (table[order] * weights) @ table[order].T
    return Shapes(table[0], tip[0, :, 0], tip[1, :, 0], stiffness, table[order], table[1])


@cache
def sine_shapes(modes: int, count: int, parts: tuple = WHOLE) -> Shapes:
    """√2 sin((2k-1)πs/2): axial and torsion shapes of a fixed-free rod."""
    nodes, weights = quadrature(count, parts)
    wave = (2 * np.arange(1, modes + 1)[:, None] - 1) * np.pi / 2
    derivative = np.sqrt(2) * wave * np.cos(wave * nodes)
    value, tip = np.sqrt(2) * np.sin(wave * nodes), np.sqrt(2) * np.sin(wave[:, 0])
    return Shapes(value, tip, np.zeros(modes), (derivative * weights) @ derivative.T, derivative, derivative)


def shapes_of(direction: str, basis: str, modes: int, count: int, parts: tuple = WHOLE) -> Shapes:
    """Shapes of one direction."""
    if modes == 0:
        none = np.zeros((0, count * len(parts)))
        return Shapes(none, np.zeros(0), np.zeros(0), np.zeros((0, 0)), none, none)
    if direction.startswith("bending"):
        return bending_shapes(basis, modes, count, parts)
    return rod_shapes(basis, modes, count, parts)


def tabulate(functions, points) -> np.ndarray:
    """(3, r, N): value, first and second derivative of each function; a function maps s to these three."""
    with mp.workdps(120):
        table = [[[float(d) for d in f(mp.mpf(float(s)))] for s in points] for f in functions]
    return np.array(table).reshape(len(functions), len(points), 3).transpose(2, 0, 1)


@cache
def clamped_free(modes: int) -> list:
    """Clamped-free beam modes by the textbook formula, at 120 digits: s -> (ψ, ψ', ψ'')."""
    return [_clamped_free_mode(clamped_free_root(k)) for k in range(1, modes + 1)]


@cache
def clamped_free_root(k: int):
    """k-th positive root of cos λ cosh λ = -1 (cos λ + 1/cosh λ = 0 is better scaled)."""
    with mp.workdps(120):
        guess = 1.8751 if k == 1 else (k - mp.mpf(1) / 2) * mp.pi
        return mp.findroot(lambda x: mp.cos(x) + mp.sech(x), guess)


def _clamped_free_mode(root):
    with mp.workdps(120):
        sigma = (mp.sinh(root) - mp.sin(root)) / (mp.cosh(root) + mp.cos(root))

    def mode(s):
        x = root * s
        ch, c, sh, sn = mp.cosh(x), mp.cos(x), mp.sinh(x), mp.sin(x)
        value = ch - c - sigma * (sh - sn)
        slope = root * (sh + sn - sigma * (ch - c))
        return value, slope, root**2 * (ch + c - sigma * (sh + sn))

    return mode


@cache
def polynomial(modes: int, order: int = 2) -> list:
    """Ritz modes of the clamped beam in span{s², …, s^(r+1)}, of the rod (order 1) in span{s, …, s^r}: in exact
    monomials at high precision."""
    with mp.workdps(60 + 6 * modes):
        powers = range(order, modes + order)
        mass = mp.matrix([[mp.mpf(1) / (i + j + 1) for j in powers] for i in powers])
        fall = {n: n * (n - 1) if order == 2 else n for n in powers}
        bend = mp.matrix([[mp.mpf(fall[i] * fall[j]) / (i + j + 1 - 2 * order) for j in powers] for i in powers])
        inverse = mp.inverse(mp.cholesky(mass))
        _, vectors = mp.eigsy(inverse * bend * inverse.T)
        coefficients = inverse.T * vectors
        return [_polynomial_mode([coefficients[i, k] for i in range(modes)], order) for k in range(modes)]


def _polynomial_mode(coefficients, order):
    """s -> (ψ, ψ', ψ'') of ±Σ c_i s^(i+order), the sign such that ψ(1) > 0."""
    sign = 1 if mp.fsum(coefficients) > 0 else -1
    terms = [(sign * c, i + order) for i, c in enumerate(coefficients)]

    def mode(s):
        value = mp.fsum(c * s**p for c, p in terms)
        slope = mp.fsum(c * p * s ** (p - 1) for c, p in terms)
        return value, slope, mp.fsum(c * p * (p - 1) * s ** (p - 2) for c, p in terms)

    return mode
