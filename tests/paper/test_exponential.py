"""Exponential coordinates: exp, its Jacobian and the inverse of that, and the rotation vector of a quaternion."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from helpers import example, flat, relative
from oracle_link import hat
from z_form_cases import series

from screwgen.paper.z_casadi import rotation_vector

ANGLES = [0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 1.0, 1.999, 2.001, np.pi - 1e-6, np.pi, np.pi + 1e-3, 5.0, 6.2, 6.283]


@pytest.mark.parametrize("angle", ANGLES)
def test_exponential_equals_its_series(angle):
    axis = np.array([0.48, -0.6, 0.64])
    theta = angle * axis
    found = [y.full() for y in example("ella").casadi()["exponential"](theta)]
    # near a full turn the rounding of theta . theta counts by the distance that is left
    allowed = 1e-14 * max(1.0, np.abs(found[2]).max())
    assert all(relative(y, exact) <= allowed for y, exact in zip(found, series(theta), strict=True))
    beside = ~np.eye(3, dtype=bool)  # the diagonal hides how a small angle enters
    assert all(relative(y[beside], exact[beside]) <= allowed for y, exact in zip(found, series(theta), strict=True))
    assert relative(found[1] @ found[2], np.eye(3)) <= allowed


@pytest.mark.parametrize("angle", [0.0, 1e-6, 0.3, 2.0, 3.1, 5.5])
def test_jacobian_is_that_of_the_body(angle):
    """R^T dR/dt = hat(J thetadot), by central differences of exp: body-frame components, not inertial ones (E18)."""
    exponential = example("ella").casadi()["exponential"]
    theta, thetadot, h = angle * np.array([0.48, -0.6, 0.64]), np.array([0.3, 0.8, -0.5]), 1e-3
    at = lambda t: exponential(theta + t * thetadot)[0].full()  # noqa: E731
    slope = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h)
    R, J, J_inverse = (y.full() for y in exponential(theta))
    turn = R.T @ slope
    omega = np.array([turn[2, 1], turn[0, 2], turn[1, 0]])
    assert np.allclose(turn, hat(omega), atol=1e-10)
    assert np.allclose(J @ thetadot, omega, atol=1e-10) and np.allclose(J_inverse @ omega, thetadot, atol=1e-10)
    if angle > 0.1:  # the printed relation, which takes J where its inverse belongs
        assert not np.allclose(J @ omega, thetadot, atol=1e-2)


def test_inverse_jacobian_ends_at_a_full_turn():
    """Infinite at 2 pi and beyond, never a wrong number; large before."""
    exponential = example("ella").casadi()["exponential"]
    for angle in (2 * np.pi, np.nextafter(2 * np.pi, 9), 6.5, 20.0):
        assert np.all(np.isinf(exponential([angle, 0, 0])[2].full()))
    assert 1e2 < np.abs(exponential([2 * np.pi - 0.01, 0, 0])[2].full()).max() < np.inf


@pytest.mark.parametrize("kind", ["value", "first derivative"])
@pytest.mark.parametrize("angle", [0.0, 1e-12, 1e-6, 1e-3, 0.19, 0.2, 0.21, 1.0, 3.0, np.pi - 1e-9])
def test_logarithm(angle, kind):
    """theta of exp(theta), through rest and up to half a turn, with its derivative; either sign of the quaternion."""
    theta, quaternion = ca.SX.sym("theta", 3), ca.SX.sym("Q", 4)
    half = ca.norm_2(theta) / 2
    Q = ca.vertcat(ca.cos(half), ca.sin(half) * theta / (2 * half))
    log = ca.Function("log", [quaternion], [rotation_vector(quaternion)])
    exact = angle * np.array([0.48, -0.6, 0.64])
    if kind == "value":
        given = np.r_[np.cos(angle / 2), np.sin(angle / 2) * np.array([0.48, -0.6, 0.64])]
        for scaled in (given, -given, 3.7 * given):
            assert np.allclose(flat(log(scaled)), exact, rtol=1e-14, atol=1e-16 * (1 + angle) if angle < 3 else 1e-14)
    elif angle:
        slope = ca.Function("slope", [theta], [ca.jacobian(log(Q), theta)])
        assert np.allclose(slope(exact).full(), np.eye(3), atol=1e-7 if angle < 1e-9 else 1e-9)
    else:
        at_rest = ca.Function("slope", [quaternion], [ca.jacobian(rotation_vector(quaternion), quaternion)])
        assert np.allclose(at_rest([1, 0, 0, 0]).full(), np.c_[np.zeros(3), 2 * np.eye(3)], atol=1e-15)
