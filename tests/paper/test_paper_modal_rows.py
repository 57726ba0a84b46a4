"""The measured rows of the judge's arm: against its motion, its kinetic energy and its potential."""

from copy import copy

import numpy as np
import pytest

from screwgen.paper.function_spaces import Cubic
from screwgen.paper.jets import Jet, skew
from screwgen.paper.modal_rows import Accelerated, ModalRows, coordinate_rates, potential, section_twist, stress
from screwgen.paper.moving_link import exponential_coordinates
from screwgen.paper.random_motion import RandomMotion

SEEDS = (4, 5)


def close(a, b, within=1e-11):
    assert np.abs(a - b).max() <= within * max(np.abs(b).max(), 1.0)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_link_with_its_own_accelerations_is_the_link(seed):
    for link in RandomMotion(seed).links:
        again = Accelerated(link, link.values["Zdot"], link.eta.second).values
        for name in ("dd_r_ob", "Vdot", "dV_B", "dV_T", "total", "D_star", "Vdot_xi_c"):
            close(again[name], link.values[name])


@pytest.mark.parametrize("seed", SEEDS)
def test_inertia_is_the_second_derivative_of_the_kinetic_energy(seed):
    """In the velocities V and etadot, whose rates the columns belong to once they are taken from Z to V."""
    link = RandomMotion(seed).links[0]
    v = link.values
    N = np.concatenate([-skew(v["r_ib"]), np.broadcast_to(np.eye(3), (len(link.xi), 3, 3)), v["phi"]], -1)
    hessian = link.rhoA * link.sum(np.swapaxes(N, -1, -2) @ N)
    to_Z = np.eye(6) - v["T_gamma"]
    close(v["M_dyn_diff"] @ to_Z, hessian[:6, :6])
    close(v["M_D_link"], hessian[:6, 6:])
    close(v["M_Dphi_diff"] @ to_Z, hessian[6:, :6])
    close(v["M_Wphi"], hessian[6:, 6:])


def test_rows_are_affine():
    motion = RandomMotion(4)
    rows, random = ModalRows(motion.links), np.random.default_rng(0)
    x = random.normal(size=(36, 1))
    close(rows(x)[0], motion.values["M_sys:all"] @ x + motion.values["H_sys:all"])
    close(rows(x)[1], (rows(2 * x)[1] + rows(0 * x)[1]) / 2)


def test_stress_is_the_gradient_of_the_potential():
    link = RandomMotion(4).links[0]
    d = np.random.default_rng(0).normal(size=(6, 1))
    h = 1e-6
    rise = (potential(link, link.eta.value + h * d) - potential(link, link.eta.value - h * d)) / (2 * h)
    assert float((stress(link).T @ d)[0, 0]) == pytest.approx(rise, rel=1e-6)


@pytest.mark.parametrize("end", ["a", "c"])
def test_section_twist_moves_the_section_and_keeps_it_normal(end):
    """At small deflections: the twist carries the section's centre by phi, and its normal along the centreline."""
    link = copy(RandomMotion(4).links[0])
    place = getattr(link, end)
    link.eta = Jet(*(0 * x for x in (link.eta.value, link.eta.rate, link.eta.second)))
    turn, velocity = np.split(section_twist(link, place), 2)
    at = np.array([place, 0.0, 0.0])
    for k in range(6):
        close(velocity[:, k] + np.cross(turn[:, k], at), link.shapes(place)[:, k])
        close(np.cross(turn[:, k], [1.0, 0, 0])[1:], link.shapes(place, 1)[1:, k])


def test_coordinate_rates_are_those_of_a_turned_link():
    link = RandomMotion(4).links[1]
    R, omega, h = link.R.value, np.array([[0.3], [-0.8], [0.5]]), 1e-6
    turned = lambda t: exponential_coordinates(R @ (np.eye(3) + t * skew(omega)))  # noqa: E731
    rate = (turned(h) - turned(-h)) / (2 * h)
    close(coordinate_rates(R) @ np.vstack([omega, omega]), np.vstack([rate, omega]), 1e-7)


@pytest.mark.parametrize("order", [1, 2])
def test_derivatives_of_the_cubic(order):
    f, h = Cubic(4), 1e-5
    fine = lambda s: 3 * s**2 - 2 * s**3  # noqa: E731
    value = lambda x: fine(np.where(x < f.h, x, 2 * f.h - x) / f.h)  # noqa: E731
    steps = {
        1: (value(f.xi + h) - value(f.xi - h)) / (2 * h),
        2: (value(f.xi + h) - 2 * value(f.xi) + value(f.xi - h)) / h**2,
    }
    assert f.derivative(order) == pytest.approx(steps[order], rel=1e-4, abs=1e-4)
