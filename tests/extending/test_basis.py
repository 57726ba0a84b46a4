"""A basis that the product does not contain: Ritz modes of monomials, found with NumPy, given as an argument."""

import mpmath
import numpy as np
import pytest
from helpers import arm, link, model_of
from mpmath import mpf

from screwgen import natural_frequencies
from screwgen.bases.closed_form import polynomial_form
from screwgen.bases.shapes import Family, Shapes, tabulate, working_digits


def monomials(count: int, order: int) -> Shapes:
    """The modes of a clamped beam (order 2) or rod (order 1) in span{s^order, s^(order + 1), ...}."""
    with mpmath.workdps(working_digits(count)):
        powers = [order + k for k in range(count)]
        fall = lambda n: mpf(n * (n - 1) if order == 2 else n)  # noqa: E731
        M = mpmath.matrix(count, count)
        K = mpmath.matrix(count, count)
        for i, m in enumerate(powers):
            for j, n in enumerate(powers):
                M[i, j] = mpf(1) / (m + n + 1)
                K[i, j] = fall(m) * fall(n) / (m + n - 2 * order + 1)
        modes, stiffness = _modes(M, K, powers) if count else ([], [])
        family = Family(
            name="monomials",
            title="Ritz modes of monomials",
            formula=r"\psi_k(s) = \sum_j Q_{jk}\,s^{j}",
            condition=r"\int_0^1\psi_k\,\psi_l\,ds = \delta_{kl}",
            order=order,
            changes=True,
        )
        return tabulate(family, modes, stiffness, [rf"\psi_{{{k + 1}}}(s)" for k in range(count)])


def _modes(M, K, powers):
    L = mpmath.cholesky(M)
    inverse = L**-1
    values, vectors = mpmath.eigsy(inverse * K * inverse.T)
    columns = inverse.T * vectors
    modes = []
    for k in range(len(powers)):
        column = [columns[i, k] for i in range(len(powers))]
        sign = 1 if sum(column) > 0 else -1
        modes.append(polynomial_form([mpf(0)] * powers[0] + [sign * c for c in column]))
    return modes, list(values)


def ritz(basis) -> dict:
    section = {"rhoA": 1.5, "EA": 4e6, "EIy": 900.0, "EIz": 700.0, "GJ": 300.0, "rhoIp": 1e-3}
    modes = {"basis": basis, "bending_y": 2, "bending_z": 1, "axial": 1, "torsion": 1}
    more = {"section": section, "modes": modes, "bodies": [{"at": "tip", "mass": 1.0, "com": [0.1, 0.2, 0.0]}]}
    return arm(link("upper", 0.8, "yz", **more), link("lower", 0.8, "z", **more)) | {"name": "ritz"}


@pytest.fixture(scope="module")
def models():
    return model_of(ritz(monomials)), model_of(ritz("polynomial"))


def test_the_same_space_has_the_same_frequencies(models):
    own, product = (natural_frequencies(m, np.r_[0.3, -0.4, 0.8, np.zeros(m.nq - 3)]) for m in models)
    assert np.allclose(own, product, rtol=1e-10)


def test_c_and_documents_follow(models, tmp_path):
    model = models[0]
    rng = np.random.default_rng(1)
    q, v = rng.normal(size=(2, model.nq)) * 0.01
    state = (q, v, rng.normal(size=3), rng.normal(size=(2, 6)))
    expected, _ = model.numpy().forward_dynamics(*state)
    found, _ = model.compile(flags=("-O0",)).forward_dynamics(*state)
    assert np.allclose(found, expected, rtol=0, atol=1e-10 * abs(expected).max())
    model.write(tmp_path / "out", targets=("latex",))
    assert "monomials" in (tmp_path / "out" / "latex" / "ritz.tex").read_text()
