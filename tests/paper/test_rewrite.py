"""Expansion and difference of matrix expressions, judged by their values; and their text on a terminal."""

import numpy as np
import pytest

from screwgen.algebra.expression import Inverse, Negative, Product, Sum, block, hat, identity, is_zero, stack, zeros
from screwgen.algebra.rewrite import difference, expand, rebuild, substitute, symbols
from screwgen.paper.equation import rank
from screwgen.paper.evaluate import evaluate
from screwgen.paper.plain import WIDTH, boxed, letters, plain, relation, shown
from screwgen.paper.quantities import LinkLetters
from screwgen.paper.random_motion import RandomMotion

L = LinkLetters("i")
MOTION = RandomMotion(1)
VECTORS = [L.omega, L.v, L.r, L.omegadot, L.rdot]
FIELDS = [L.r_b, L.r_xi, L.rdot_xi]


def random_vector(random, depth, fields=False):
    """A random 3-vector: sums, cross products, rotations, signs and multiples."""
    if depth == 0:
        pool = VECTORS + (FIELDS if fields else [])
        return pool[random.integers(len(pool))]
    inner = lambda: random_vector(random, depth - 1, fields)  # noqa: E731
    choice = random.integers(6)
    if choice == 0:
        return Sum((inner(), inner()))
    if choice == 1:
        return Product(hat(inner()), inner())
    if choice == 2:
        return Negative(inner())
    if choice == 3:
        return Product(L.R.T, inner())
    if choice == 4:
        return 3 * inner()
    if fields:
        return Product(L.R, Product(L.R.T, inner()))
    return L.integral(random_vector(random, depth - 1, True), L.rhoA)


def close(a, b):
    return np.allclose(a, b, rtol=1e-11, atol=1e-11 * (1 + np.abs(b).max()))


@pytest.mark.parametrize("seed", range(40))
def test_expansion_keeps_the_value(seed):
    e = random_vector(np.random.default_rng(seed), 4)
    assert close(evaluate(rebuild(expand(e, rank), e.shape), MOTION), evaluate(e, MOTION))


@pytest.mark.parametrize("seed", range(40))
def test_a_difference_is_one(seed):
    random = np.random.default_rng(seed)
    a, b = random_vector(random, 3), random_vector(random, 3)
    assert close(evaluate(difference(a, b, rank), MOTION), evaluate(a, MOTION) - evaluate(b, MOTION))
    assert is_zero(difference(a + b, b + a, rank))


def test_a_cross_product_and_its_mirror_cancel():
    a, b = hat(L.omega) @ L.v, -(hat(L.v) @ L.omega)
    assert is_zero(difference(a, b, rank))
    whole, parts = hat(L.r_b + L.r_xi) @ L.omegadot, hat(L.r_b) @ L.omegadot + hat(L.r_xi) @ L.omegadot
    assert is_zero(difference(whole, parts, rank))


def test_matrices_are_compared_block_by_block():
    a = block([identity(3), hat(L.r)], [zeros(3, 3), L.R])
    b = block([identity(3), zeros(3, 3)], [zeros(3, 3), L.R])
    d = difference(a, b)
    assert not is_zero(d)
    assert is_zero(d.rows[0][0]) and is_zero(d.rows[1][1])
    assert is_zero(difference(a, a))


def test_substitution_and_symbols():
    e = hat(L.r_ib) @ L.omegadot + L.integral(L.r_ib, L.rhoA)
    put = substitute(e, {"r_ib:i": L.r_b + L.r_xi})
    assert [s.name for s in symbols(put)] == ["r_b:i", "r_xi:i", "omegadot:i", "rhoA:i"]
    assert close(evaluate(put, MOTION), evaluate(e, MOTION))


def test_text_of_expressions():
    assert plain(L.rhoA @ L.integral(hat(L.r_b) @ (hat(L.omega) @ L.v_ib))) == "ρ_i A_i ∫ r̃_bi ω̃_i v_ibi dξ"
    assert plain(hat(L.omega) @ (hat(L.omega) @ L.r)) == "ω̃_i² r_i"
    assert plain(Inverse(L.Ad.T) @ L.W) == "Ad_oi⁻ᵀ W_i"
    assert plain(L.v - (L.rdot + L.r)) == "v_i − (ṙ_i + r_i)"
    assert relation(L.V, stack(L.omega, L.v)) == ["V_i = ⎡ ω_i ⎤", "      ⎣ v_i ⎦"]
    assert letters(r"{}^{o}\tilde{\boldsymbol{\omega}}_i^{\top}") == "ᵒω̃_iᵀ"


def test_text_stays_within_the_width():
    term = hat(L.omega) @ L.r_ob
    long = Sum(tuple(k * term for k in range(2, 30)))
    assert all(shown(line) <= WIDTH for line in relation(L.v, long))
    wide = block([long, long], [zeros(3), term])
    lines = boxed(wide)
    assert all(shown(line) <= WIDTH for line in lines)
    assert lines[0].startswith("row 1, column 1:")
