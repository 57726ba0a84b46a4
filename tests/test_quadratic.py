"""Quadratic forms that the second-order shapes are written in."""

import itertools

import numpy as np
import pytest
import sympy as sp

from screwgen.algebra.quadratic import form, half_form

COUPLINGS = {
    "none": [],
    "diagonal": [(0, 0), (2, 2)],
    "two groups": [(0, 3), (1, 3), (2, 3), (0, 4), (1, 4)],
    "one coupled to all others": [(0, 1), (0, 2), (0, 3), (0, 4)],
    "dense": list(itertools.combinations_with_replacement(range(5), 2)),
    "dense beside two groups": [(0, 0), (0, 1), (1, 1), (2, 3), (2, 4)],
    "an odd ring": [(0, 1), (1, 2), (0, 2), (3, 4)],
}


def matrix(pairs) -> np.ndarray:
    H = np.full((5, 5), sp.S.Zero, dtype=object)
    for i, j in pairs:
        H[i, j] = H[j, i] = sp.Symbol(f"h{i}{j}", real=True)
    return H


@pytest.mark.parametrize("name", COUPLINGS)
def test_forms_are_the_products(name):
    H, x = matrix(COUPLINGS[name]), np.array(sp.symbols("x:5", real=True))
    product = x.dot(H).dot(x)
    assert sp.expand(form(H, x) - product) == 0
    assert sp.expand(2 * half_form(H, x, H.dot(x)) - product) == 0


@pytest.mark.parametrize("name, operations", [("two groups", 3), ("one coupled to all others", 1), ("dense", 10)])
def test_each_product_is_computed_once(name, operations):
    """With the rows known: a product and a sum for each coordinate of the smaller group, or half of all at the end."""
    H, x = matrix(COUPLINGS[name]), np.array(sp.symbols("x:5", real=True))
    rows = np.array([sp.Symbol(f"r{k}") if any(row) else sp.S.Zero for k, row in enumerate(H)])
    assert sp.count_ops(half_form(H, x, rows)) == operations
