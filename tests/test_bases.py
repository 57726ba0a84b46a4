"""The bases: published numbers, orthonormality by quadrature, exactness under static loads, frequencies."""

from itertools import product

import mpmath
import numpy as np
import pytest
from conftest import swept
from mpmath import mpc, mpf
from scipy.linalg import eigh

from screwgen.bases import BASES, of_order, products
from screwgen.bases import shapes as shapes_of
from screwgen.bases.closed_form import ClosedForm, inner
from screwgen.bases.shapes import Shapes, latex_number, working_digits

MANY = 32
COUNTS = (1, 2, 5, MANY)
KINDS = {
    "clamped_free": ("clamped_free", 2),
    "polynomial": ("polynomial", 2),
    "sine": ("clamped_free", 1),
    "polynomial rod": ("polynomial", 1),
}
"""Names of the families, and the basis and order by which they are had."""


FEW = [*product(KINDS, COUNTS[:3]), ("polynomial", MANY)]


@pytest.fixture(scope="module", params=swept(product(KINDS, COUNTS), *FEW), ids=str)
def shapes(request) -> Shapes:
    name, count = request.param
    return of_order(*KINDS[name], count)


def bending(basis: str, count: int) -> Shapes:
    return of_order(basis, 2, count)


def axial(basis: str, count: int) -> Shapes:
    return of_order(basis, 1, count)


def gauss(points: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and weights of Gauss-Legendre quadrature on [0, 1]."""
    x, w = np.polynomial.legendre.leggauss(points)
    return (x + 1) / 2, w / 2


def independent_root(k: int) -> mpf:
    """The k-th clamped-free root from cos x cosh x = -1 as printed, bracketed between its neighbours."""
    centre = (2 * k - 1) * mpmath.pi / 2
    bracket = (centre - 1, centre + 1)
    return mpmath.findroot(lambda x: mpmath.cos(x) * mpmath.cosh(x) + 1, bracket, solver="anderson")


def frequencies(shapes: Shapes, tip_mass: float, tip_inertia: float) -> np.ndarray:
    """Dimensionless natural frequencies of the clamped beam that carries a rigid body at its tip."""
    value, slope = np.array(shapes.tip_value), np.array(shapes.tip_slope)
    mass = np.eye(shapes.count) + tip_mass * np.outer(value, value) + tip_inertia * np.outer(slope, slope)
    return np.sqrt(eigh(np.diag(shapes.stiffness), mass, eigvals_only=True))


# --- closed forms -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("alpha", [0, 1e-43, -1e-5, 0.3, 7, -60, 0.01j, 3j, 101 - 99j])
def test_integrals_equal_quadrature(alpha):
    with mpmath.workdps(50):
        for n in (0, 1, 7, 40):
            form = ClosedForm({mpc(alpha): [mpf(0)] * n + [mpf(1)]})
            pieces = mpmath.linspace(0, 1, 9)
            expected = mpmath.quad(lambda s, n=n: s**n * mpmath.exp(mpc(alpha) * s), pieces).real
            assert abs(form.integral() - expected) < mpf("1e-38") * mpmath.exp(max(mpc(alpha).real, 0))


def test_derivative_of_a_product_is_leibniz():
    with mpmath.workdps(40):
        f = ClosedForm({mpf(2): [mpf(1), mpf(3)], mpf(0): [mpf(0), mpf(0), mpf(5)]})
        g = ClosedForm({mpc(0, 3): [mpc(1, 2)], mpc(0, -3): [mpc(1, -2)]})
        product, leibniz = (f * g).derivative(), f.derivative() * g + f * g.derivative()
        assert abs(product(mpf("0.7")) - leibniz(mpf("0.7"))) < mpf("1e-37")
        assert abs(product.integral() - (f(1) * g(1) - f(0) * g(0))) < mpf("1e-37")


# --- what every basis promises ------------------------------------------------------------------------------


def test_what_integrals_say_by_quadrature(shapes):
    """Modes are orthonormal, their stiffness is diagonal, and the first moments are those stated."""
    nodes, weights = gauss(4 * shapes.count + 40)
    psi = np.array(shapes.evaluate(nodes))
    strain = np.array(shapes.evaluate(nodes, shapes.family.order)) / np.sqrt(shapes.stiffness)[:, None]
    np.testing.assert_allclose(psi * weights @ psi.T, np.eye(shapes.count), atol=2e-12)
    np.testing.assert_allclose(strain * weights @ strain.T, np.eye(shapes.count), atol=2e-11)
    np.testing.assert_allclose(psi @ weights, shapes.integral, atol=1e-13)
    np.testing.assert_allclose(psi @ (weights * nodes), shapes.moment, atol=1e-13)


def test_orthonormal_to_forty_digits(shapes):
    with mpmath.workdps(working_digits(shapes.count)):
        modes = shapes.functions[-4:] + shapes.functions[:2]
        for f in modes:
            for g in modes:
                assert abs(inner(f, g) - (f is g)) < mpf("1e-40")


def test_clamped_at_the_base_and_tip_data(shapes):
    assert all(row == (0.0,) for row in shapes.evaluate([0.0]))
    assert tuple(row[0] for row in shapes.evaluate([1.0])) == shapes.tip_value
    assert tuple(row[0] for row in shapes.evaluate([1.0], 1)) == shapes.tip_slope
    if shapes.family.order == 2:
        assert all(row == (0.0,) for row in shapes.evaluate([0.0], 1))


def test_modes_ascend_and_have_documents(shapes):
    assert all(np.diff(shapes.stiffness) > 0)
    assert len(shapes.formulas) == len(shapes.eigenvalues) == shapes.count
    assert all("e+" not in text and "e-" not in text for text in shapes.formulas)
    assert shapes.family.name in KINDS


# --- clamped-free modes -------------------------------------------------------------------------------------


def test_clamped_free_published_values():
    shapes = bending("clamped_free", 3)
    roots = [1.8751040687119611, 4.694091132974175, 7.854757438237613]
    np.testing.assert_allclose(shapes.eigenvalues, roots, rtol=0, atol=1e-12)
    assert shapes.tip_value == (2.0, -2.0, 2.0)
    np.testing.assert_allclose(np.abs(shapes.integral), [0.782992, 0.433936, 0.254425], atol=5e-7)


def test_clamped_free_against_the_textbook_formula():
    """Constants and values of 32 modes against cosh and sinh at 200 digits; 1 - sigma falls to 1e-43."""
    shapes, points = bending("clamped_free", MANY), [0.013, 0.25, 0.5, 0.77, 0.991, 1.0]
    values, slopes = shapes.evaluate(points), shapes.evaluate(points, 1)
    with mpmath.workdps(200):
        for k in range(MANY):
            x = independent_root(k + 1)
            cos, sin, cosh, sinh = mpmath.cos(x), mpmath.sin(x), mpmath.cosh(x), mpmath.sinh(x)
            sigma = (sinh - sin) / (cosh + cos)
            assert shapes.eigenvalues[k] == float(x)
            assert shapes.stiffness[k] == float(x**4)
            assert shapes.integral[k] == float(2 * sigma / x)
            assert shapes.moment[k] == float(2 / x**2)
            assert shapes.tip_value[k] == 2.0 * (-1) ** k
            assert shapes.tip_slope[k] == float(x * (sinh + sin - sigma * (cosh - cos)))
            for s, value, slope in zip(points, values[k], slopes[k], strict=True):
                z = x * mpf(s)
                psi = mpmath.cosh(z) - mpmath.cos(z) - sigma * (mpmath.sinh(z) - mpmath.sin(z))
                dpsi = x * (mpmath.sinh(z) + mpmath.sin(z) - sigma * (mpmath.cosh(z) - mpmath.cos(z)))
                assert abs(value - psi) < 1e-15
                assert abs(slope - dpsi) < 1e-15 * x


def test_clamped_free_modes_do_not_depend_on_their_number():
    few, many = bending("clamped_free", 3), bending("clamped_free", MANY)
    for field in ("formulas", "eigenvalues", "integral", "moment", "stiffness", "tip_value", "tip_slope"):
        assert getattr(many, field)[:3] == getattr(few, field)


def test_clamped_free_static_tip_deflection():
    for count, ratio in enumerate([0.970688, 0.995404, 0.998556, 0.999377, 0.999678], start=1):
        shapes = bending("clamped_free", count)
        deflection = sum(v**2 / k for v, k in zip(shapes.tip_value, shapes.stiffness, strict=True))
        assert 3 * deflection == pytest.approx(ratio, abs=5e-7)


# --- polynomial modes ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(("order", "count"), [*product((2,), (1, 2, 3, 4, 5)), *product((1,), (1, 2, 5))])
def test_polynomials_equal_ritz_in_monomials(order, count):
    """The same Ritz problem, straight from s^order on: eigenvalues and tip values; eigenvalues come from above."""
    n = np.arange(order, count + order)
    total, slope = n[:, None] + n, n * (n - 1) if order == 2 else n
    eigenvalues, vectors = eigh(np.outer(slope, slope) / (total - 2 * order + 1), 1.0 / (total + 1))
    shapes = of_order("polynomial", order, count)
    np.testing.assert_allclose(shapes.stiffness, eigenvalues, rtol=1e-7)
    np.testing.assert_allclose(shapes.tip_value, np.abs(vectors.sum(axis=0)), rtol=1e-6)
    assert shapes.eigenvalues == shapes.stiffness
    assert all(np.array(shapes.stiffness) >= np.array(of_order("clamped_free", order, count).stiffness) * (1 - 1e-15))


def test_polynomial_of_one_mode_is_the_parabola():
    shapes = bending("polynomial", 1)
    assert shapes.stiffness == (20.0,)
    assert shapes.tip_value == (5**0.5,)


def test_polynomial_stiffness_converges_from_above():
    exact = np.array(bending("clamped_free", 5).stiffness)
    previous = np.full(5, np.inf)
    for count in range(1, 13):
        found = np.array(bending("polynomial", count).stiffness)[:5]
        size = len(found)
        assert all(found >= exact[:size] * (1 - 1e-15))
        assert all(found <= previous[:size] * (1 + 1e-15))
        previous[:size] = found
    np.testing.assert_allclose(previous, exact, rtol=1e-5)
    many = np.array(bending("polynomial", MANY).stiffness)
    np.testing.assert_allclose(many[:10], bending("clamped_free", 10).stiffness, rtol=1e-12)


@pytest.mark.parametrize("count", [2, 3, 6, MANY])
def test_polynomial_is_exact_for_static_tip_loads(count):
    """Unit tip force: deflection 1/3, slope 1/2; unit tip moment: deflection 1/2, slope 1."""
    shapes = bending("polynomial", count)
    tip = np.array([shapes.tip_value, shapes.tip_slope])
    flexibility = tip / np.array(shapes.stiffness) @ tip.T
    np.testing.assert_allclose(flexibility, [[1 / 3, 1 / 2], [1 / 2, 1]], rtol=1e-13)
    assert all(value > 0 for value in shapes.tip_value)


@pytest.mark.parametrize(
    "mass, inertia, first, second",
    [(1, 0, 1.557298, 16.250085), (0.1, 0, 2.967838, 19.355801), (1, 1, 0.867900, 3.390572)],
)
def test_frequencies_under_a_payload(mass, inertia, first, second):
    for count in range(4, 9):
        assert frequencies(bending("polynomial", count), mass, inertia)[0] == pytest.approx(first, rel=1e-5)
    for count in range(6, 9):
        assert frequencies(bending("polynomial", count), mass, inertia)[1] == pytest.approx(second, rel=1e-5)
    assert frequencies(bending("clamped_free", 20), mass, inertia)[0] == pytest.approx(first, rel=2e-2)


# --- axial and torsion modes, products ----------------------------------------------------------------------


def test_sine_modes_are_the_rod_modes():
    shapes = axial("clamped_free", MANY)
    frequency = (2 * np.arange(1, MANY + 1) - 1) * np.pi / 2
    sign = (-1.0) ** np.arange(MANY)
    np.testing.assert_allclose(shapes.eigenvalues, frequency, rtol=4e-16)
    np.testing.assert_allclose(shapes.stiffness, frequency**2, rtol=1e-15)
    np.testing.assert_allclose(shapes.integral, 2**0.5 / frequency, rtol=1e-15)
    np.testing.assert_allclose(shapes.moment, 2**0.5 * sign / frequency**2, rtol=1e-15)
    assert shapes.tip_value == tuple(2**0.5 * sign)
    assert shapes.tip_slope == (0.0,) * MANY
    assert shapes.formulas[1] == r"\sqrt{2}\,\sin\tfrac{3\pi}{2}s"


@pytest.mark.parametrize("count", [1, 2, 6, MANY])
def test_polynomial_rod_modes_are_exact_for_a_static_tip_load(count):
    """Unit tip force: displacement 1; sines give 81 % of it with one mode, 99.4 % with 32."""
    flexibility = lambda shapes: sum(v * v / k for v, k in zip(shapes.tip_value, shapes.stiffness, strict=True))  # noqa: E731
    assert flexibility(axial("polynomial", count)) == pytest.approx(1, rel=1e-13)
    sines = {1: 0.8106, 32: 0.9937}
    assert count not in sines or flexibility(axial("clamped_free", count)) == pytest.approx(sines[count], abs=5e-5)


def test_a_direction_has_the_order_that_stores_its_energy():
    for basis in BASES:
        assert shapes_of(basis, "axial", 2) is shapes_of(basis, "torsion", 2) is axial(basis, 2)
        assert shapes_of(basis, "bending_y", 2) is shapes_of(basis, "bending_z", 2) is bending(basis, 2)


@pytest.mark.parametrize("name", sorted(BASES))
@pytest.mark.parametrize("counts", swept([(2, 3), (MANY, MANY)], (2, 3)))
def test_axial_with_bending_by_quadrature(name, counts):
    a, b = axial(name, counts[0]), bending(name, counts[1])
    nodes, weights = gauss(160)
    expected = np.array(a.evaluate(nodes)) * weights @ np.array(b.evaluate(nodes)).T
    np.testing.assert_allclose(products(a, b), expected, atol=1e-13)


def test_products_are_exact_within_a_family_and_symmetric():
    a, b = bending("clamped_free", 2), bending("clamped_free", 3)
    assert products(a, b) == ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    assert products(b, b) == ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    assert products(axial("clamped_free", 1), axial("clamped_free", 2)) == ((1.0, 0.0),)
    c = bending("polynomial", 3)
    assert products(a, c) == tuple(zip(*products(c, a), strict=True))


# --- the registry -------------------------------------------------------------------------------------------


def test_results_ignore_the_precision_of_the_process():
    point = [0.3]
    expected = [BASES[name](3, order) for name in sorted(BASES) for order in (1, 2)]
    values = [shapes.evaluate(point, 1) for shapes in expected]
    with mpmath.workdps(5):
        again = [BASES[name](3, order) for name in sorted(BASES) for order in (1, 2)]
        assert [shapes.evaluate(point, 1) for shapes in again] == values
        assert mpmath.mp.dps == 5
    for old, new in zip(expected, again, strict=True):
        assert (old.integral, old.moment, old.stiffness) == (new.integral, new.moment, new.stiffness)
        assert (old.tip_value, old.tip_slope, old.formulas) == (new.tip_value, new.tip_slope, new.formulas)


def test_no_modes_at_all():
    for empty in (of_order(name, order, 0) for name in BASES for order in (1, 2)):
        assert empty.count == 0 and empty.integral == ()
        assert products(axial("polynomial", 2), empty) == ((), ())


def test_refusals_say_what_is_wrong():
    with pytest.raises(ValueError, match="'cubic': choose one of clamped_free, polynomial"):
        bending("cubic", 2)
    with pytest.raises(ValueError, match="must not be negative, got -1"):
        bending("polynomial", -1)
    with pytest.raises(ValueError, match="unknown direction 'shear': choose one of axial"):
        shapes_of("polynomial", "shear", 2)


def test_numbers_in_latex():
    assert latex_number(mpf("1.87510406")) == "1.875104"
    assert latex_number(mpf("-2.5e21")) == r"-2.5\times 10^{21}"
    assert latex_number(mpf("3e-9")) == r"3.0\times 10^{-9}"
