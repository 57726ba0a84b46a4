"""The judge is judged: its shape functions, and rigid links, by textbook results; nothing is from the package."""

import numpy as np
import pytest
from oracle import Oracle
from oracle_robots import G, arm, regular, relative, rod
from oracle_shapes import bending_shapes, quadrature, sine_shapes

# -------- shape functions


@pytest.mark.parametrize("basis", ["clamped_free", "polynomial"])
@pytest.mark.parametrize("modes", [1, 2, 3, 4, 8])
def test_bending_shapes_are_orthonormal_ritz_modes(basis, modes):
    shapes = bending_shapes(basis, modes, 16 + 4 * modes)
    gram = (shapes.nodes * quadrature(16 + 4 * modes)[1]) @ shapes.nodes.T
    scale = np.sqrt(np.diag(shapes.stiffness))
    assert np.allclose(gram, np.eye(modes), atol=1e-12)
    assert np.allclose(shapes.stiffness / np.outer(scale, scale), np.eye(modes), atol=1e-12)
    assert np.all(np.diff(scale) > 0)


def test_clamped_free_figures_of_section_5():
    shapes = bending_shapes("clamped_free", 3, 40)
    nodes, weights = quadrature(40)
    roots = np.array([1.8751040687119611, 4.694091132974175, 7.854757438237613])
    assert np.allclose(np.diag(shapes.stiffness) ** 0.25, roots, rtol=1e-13)
    assert np.allclose(shapes.tip, [2, -2, 2], rtol=1e-13)
    assert np.allclose(np.abs(shapes.nodes @ weights), [0.782992, 0.433936, 0.254425], atol=5e-7)
    assert np.allclose(shapes.nodes @ (weights * nodes), 2 / roots**2, rtol=1e-12)


def test_polynomial_shapes_span_jacobi_form():
    """√(2k+5) s² P_k^(0,4)(2s-1) is orthonormal, and every Ritz mode is a rotation of these."""
    from scipy.special import eval_jacobi

    nodes, weights = quadrature(32)
    jacobi = np.array([np.sqrt(2 * k + 5) * nodes**2 * eval_jacobi(k, 0, 4, 2 * nodes - 1) for k in range(4)])
    shapes = bending_shapes("polynomial", 4, 32)
    turn = (shapes.nodes * weights) @ jacobi.T
    assert np.allclose(turn @ turn.T, np.eye(4), atol=1e-13)
    assert np.allclose(turn @ jacobi, shapes.nodes, atol=1e-13)
    assert np.all(shapes.tip > 0)


@pytest.mark.parametrize("basis", ["clamped_free", "polynomial"])
def test_tip_slope_agrees_with_values(basis):
    """∫ ψ''(s) s ds = ψ'(1) - ψ(1), here by the polynomial through the nodes."""
    shapes = bending_shapes(basis, 3, 40)
    for values, tip, slope in zip(shapes.nodes, shapes.tip, shapes.tip_slope, strict=True):
        fit = np.polynomial.Chebyshev.fit(quadrature(40)[0], values, 25, domain=[0, 1])
        assert np.isclose(fit(1.0), tip, rtol=1e-10)
        assert np.isclose(fit.deriv()(1.0), slope, rtol=1e-8)


def test_sine_shapes():
    shapes = sine_shapes(3, 40)
    assert np.allclose((shapes.nodes * quadrature(40)[1]) @ shapes.nodes.T, np.eye(3), atol=1e-13)
    assert np.allclose(np.diag(shapes.stiffness), (np.array([1, 3, 5]) * np.pi / 2) ** 2, rtol=1e-13)


@pytest.mark.parametrize("seed", range(4))
def test_quadrature_is_exact(seed):
    robot, state, oracle = regular(seed)
    for value, finer in zip(
        oracle.forward_dynamics(**state), Oracle(robot, extra_nodes=9).forward_dynamics(**state), strict=True
    ):
        assert relative(value, finer) < max(1e-12, 2e-16 * oracle.condition(state["q"]))


# -------- rigid links


def test_pendulum():
    """Rod 2 kg, 1.5 m with 3 kg at its tip, armature, friction and a spring."""
    length, rhoA, tip, J, b, k = 1.5, 2 / 1.5, 3.0, 0.7, 0.3, 4.0
    joint = {"axes": ["z"], "armature": [J], "damping": [b], "stiffness": [k]}
    link = rod(length, rhoA, ["z"], bodies=[{"at": "tip", "mass": tip}]) | {"joint": joint}
    angle, rate, torque = 0.7, -1.3, 5.0
    inertia = 2 * length**2 / 3 + tip * length**2 + J
    moment = torque - b * rate - k * angle - G * np.cos(angle) * (2 * length / 2 + tip * length)
    vdot, wrench = Oracle(arm(link)).forward_dynamics([angle], [rate], [torque], None)
    assert np.isclose(vdot[0], moment / inertia, rtol=1e-14)
    assert np.isclose(wrench[0, 2], torque - b * rate - k * angle - J * vdot[0], rtol=1e-13)
    centre = (2 * length / 2 + tip * length) * np.array([-(rate**2), vdot[0]])
    weight = 5.0 * G * np.array([np.sin(angle), np.cos(angle)])
    assert np.allclose(wrench[0, 3:5], centre + weight, rtol=1e-13)


def test_double_pendulum():
    l1, l2, m1, m2, M1, M2 = 1.2, 0.8, 1.5, 0.9, 0.4, 0.6
    body = lambda mass: [{"at": "tip", "mass": mass}]  # noqa: E731
    robot = arm(rod(l1, m1 / l1, ["z"], bodies=body(M1)), rod(l2, m2 / l2, ["z"], bodies=body(M2)))
    q, v, tau = [0.4, 1.1], [0.9, -2.0], [3.0, -1.0]
    first, second = q[0], q[0] + q[1]
    static = (m2 / 2 + M2) * l2
    coupling, delta = static * l1, first - second
    A = m1 * l1**2 / 3 + (M1 + m2 + M2) * l1**2
    M = np.array([[A, coupling * np.cos(delta)], [coupling * np.cos(delta), (m2 / 3 + M2) * l2**2]])
    w1, w2 = v[0], v[0] + v[1]
    rhs = [
        tau[0] - tau[1] - coupling * np.sin(delta) * w2**2 - G * (m1 / 2 + M1 + m2 + M2) * l1 * np.cos(first),
        tau[1] + coupling * np.sin(delta) * w1**2 - G * static * np.cos(second),
    ]
    absolute = np.linalg.solve(M, rhs)
    vdot, _ = Oracle(robot).forward_dynamics(q, v, tau, None)
    assert np.allclose(vdot, [absolute[0], absolute[1] - absolute[0]], rtol=1e-13)


def test_steady_precession_of_a_heavy_top():
    """A Ω² cos α - C ω_3 Ω + m g d = 0 keeps the nutation at rest."""
    mass, d, A_centre, C = 2.0, 0.4, 0.05, 0.03
    disc = {"at": "base", "mass": mass, "com": [d, 0, 0], "inertia": [C, A_centre, A_centre, 0, 0, 0]}
    robot = arm(rod(0.5, 1e-12, ["z", "y", "x"], bodies=[disc]), gravity=(0, 0, -G))
    A, nutation, precession = A_centre + mass * d**2, -0.5, 1.7
    cos_alpha = -np.sin(nutation)
    spin = (A * precession**2 * cos_alpha + mass * G * d) / (C * precession)
    own_rate = spin + precession * np.sin(nutation)
    vdot, _ = Oracle(robot).forward_dynamics([0.3, nutation, 0.9], [precession, 0, own_rate], [0, 0, 0], None)
    assert np.allclose(vdot, 0, atol=1e-9)


def test_rigid_rod_spin_inertia():
    """rhoIp l alone resists a roll joint, without torsion modes."""
    oracle = Oracle(arm(rod(0.7, 2.0, ["x"], rhoIp=3e-3)))
    assert np.isclose(oracle.mass_matrix([0.4])[0, 0], 0.7 * 3e-3, rtol=1e-13)
