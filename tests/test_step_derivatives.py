"""Derivatives of a step and of the joint wrenches in the generated C: see step_judges."""

import ctypes

import numpy as np
import pytest
from drive_robots import ELASTIC, FALLING
from floating_robots import HULL, rod
from helpers import arm, link, model_of, quick
from step_judges import by_casadi, point, worst

from screwgen import SingularError, UsageError
from screwgen.errors import ScrewgenError
from screwgen.integrators import Method, Move, Stage

SOFT = {"EA": 5e4, "EIy": 30.0, "EIz": 50.0, "GJ": 20.0}
BENT = {"modes": {"bending_y": 1}, "section": SOFT}
LOADED = {"bodies": [{"at": "tip", "mass": 1.0, "com": [0.1, 0.0, 0.02], "inertia": [0.01, 0.02, 0.02, 0, 0, 0]}]}
STOP = {"lower": -0.3, "upper": 0.25, "stiffness": 900.0, "damping": 8.0}
SMALL = {
    "gears": arm(
        link("a", 0.6, "y", joint={"drives": [ELASTIC]}, **BENT), link("b", 0.4, "y", joint={"drives": [FALLING]})
    ),
    "stops": arm(
        link("a", 0.6, "zy", joint={"limits": [STOP, STOP]}, **BENT), link("b", 0.4, [{"slide": "x"}], **LOADED)
    ),
    "floating": arm({"name": "hull", "joint": {"axes": []}, "bodies": [HULL]}, rod("fore", ["y"]), base="floating"),
}
"""Small robots, since CasADi's jacobian of a step is long."""

KUTTA = Method(
    "kutta", 3, (Stage(), Stage(["1/2"]), Stage([-1, 2])), Move(["1/6", "2/3", "1/6"]), "Kutta's third order"
)
OWN = Method("late", 1, (Stage(implicit=1), Stage([1], "new", implicit=1)), Move(["1/2", "1/2"]), "two implicit stages")
LONG = pytest.mark.long


def compiled(model, **options):
    """One library per robot, with the methods of one's own."""
    return quick(model, derivatives=True, methods=(KUTTA, OWN), **options)


def found(model, x, h, method, **options):
    return compiled(model, **options).step_derivatives(*x, h, method)


# -------- against CasADi


@pytest.mark.parametrize("robot", SMALL)
def test_methods_of_ones_own(robot):
    """Negative weights, several stages in one, two implicit stages; the C is made of the table."""
    model, h = model_of(SMALL[robot]), 0.003
    for method in (KUTTA, OWN):
        x = point(model, 5)
        _, _, *AB = found(model, x, h, method)
        assert worst(AB, by_casadi(model, method, *x, h), model.chain.nv) < 1e-10


@LONG
def test_stops_over_every_branch():
    """A way that enters, leaves, crosses and misses the range; the deeper of two rates, and a pull that is no force."""
    model, h = model_of(SMALL["stops"]), 0.05
    rng, share = np.random.default_rng(0), 0
    for _ in range(12):
        q, v, tau, w_ext = point(model, 6)
        q[:2], v[:2] = rng.uniform(-0.5, 0.5, 2), rng.uniform(-8, 8, 2)
        _, _, *AB = found(model, (q, v, tau, w_ext), h, "modal_midpoint")
        assert worst(AB, by_casadi(model, "modal_midpoint", q, v, tau, w_ext, h), model.chain.nv) < 1e-9
        share += bool((np.abs(q[:2]) < 0.25).any() and (np.abs(q[:2]) > 0.3).any())
    assert share >= 2


# -------- the step that is differentiated


def test_a_pendulum_by_hand():
    """Semi-implicit: v' = v + h a(q), q' = q + h v'."""
    model = model_of(arm(link("rod", 2.0, "y", rhoA=0.5)))
    h, q, inertia = 0.01, 0.3, 0.5 * 2.0**3 / 3
    slope = -0.5 * 2.0 * 9.81 * np.sin(q) / inertia
    _, _, A, B = found(model, ([q], [0.7], [0.0], np.zeros((1, 6))), h, "semi_implicit")
    assert np.allclose(A, [[1 + h * h * slope, h], [h * slope, 1]], rtol=1e-5, atol=1e-12)
    assert np.allclose(B, [[h * h / inertia], [h / inertia]], rtol=1e-12)


def test_statuses():
    """Unless all is well, the new state keeps its value; null pointers and steps are refused."""
    spherical = model_of(arm(link("wrist", axes="xzx", **LOADED)))
    c = quick(spherical, derivatives=True)
    rest = np.zeros(3), np.zeros(3), np.zeros(3), np.zeros((1, 6))
    with pytest.raises(SingularError, match="wrist"):
        c.step_derivatives(*rest, 0.01)
    good = [np.array([0.1, 0.5, 0.2]), *rest[1:]]
    for number in range(4):
        bad = [x.copy() for x in good]
        bad[number].flat[0] = np.nan
        with pytest.raises(ScrewgenError, match="non-finite"):
            c.step_derivatives(*bad, 0.01)
    with pytest.raises(UsageError, match="dt"):
        c.step_derivatives(*good, 0.0)
    with pytest.raises(UsageError, match="derivatives=True"):
        quick(spherical).step_derivatives(*good, 0.01)
    call, buffer = c.library[f"{spherical.robot.name}_step_rk4_derivatives"], ctypes.create_string_buffer(100_000)
    for missing in (0, 1, 2, 4, 5, 6):
        pointers = [None if k == missing else ctypes.byref(buffer) for k in range(7)]
        pointers[3] = ctypes.c_double(0.01)
        assert call(*pointers) == 3
    for h in (0.0, -1.0, np.nan, np.inf):
        assert call(*[ctypes.byref(buffer)] * 3, ctypes.c_double(h), *[ctypes.byref(buffer)] * 3) == 3
