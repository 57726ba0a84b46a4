"""A force with a state that an input drives and that the product does not contain: a pneumatic muscle, one file."""

from dataclasses import dataclass

import numpy as np
import pytest
from fmi_units import Unit
from helpers import arm, link, model_of, relative
from outside import Outside, every_check

from screwgen import simulate
from screwgen.interactions import ForceInput, ForceState, Interaction, StateRate, WrenchOnSecond, number
from screwgen.spec.forces import Force


@dataclass(frozen=True)
class Muscle(Interaction):
    """A braided hose that pulls with ``P p (a (L/L0)² - b)``; the share p of the supply P follows its valve."""

    KIND = "muscle"
    WORDS = "pneumatic muscles"
    INPUTS = {"opened": ForceInput("1", "share of the supply that the valve is told", "p_v")}  # noqa: RUF012
    STATES = {"filled": ForceState("1", "share of the supply in the hose", "p", 1.0)}  # noqa: RUF012

    supply: float = number("Pa", "pressure of the supply", "P", sign="positive")
    length: float = number("m", "length without contraction", "L_0", sign="positive")
    swelling: float = number("m²", "area by the square of the length", "a", sign="positive")
    core: float = number("m²", "area that pushes", "b", sign="positive")
    time: float = number("s", "time in which it fills", "T", sign="positive")

    @staticmethod
    def wrench(t, x, supply, length, swelling, core, time, opened, filled):
        long = t.call("sqrt", x.d[0] * x.d[0] + x.d[1] * x.d[1] + x.d[2] * x.d[2])
        pull = filled * supply * (swelling * (long / length) * (long / length) - core) / long
        return WrenchOnSecond((0.0, 0.0, 0.0), [-pull * y for y in x.d])

    @staticmethod
    def rates(t, x, supply, length, swelling, core, time, opened, filled):
        return {"filled": StateRate(opened / time, 1.0 / time)}

    @staticmethod
    def power(t, x, **keys):
        """None: a valve passes air."""
        return {"opened": 0.0}


MUSCLE = Muscle(supply=4e5, length=0.9, swelling=9e-4, core=3e-4, time=0.03)
SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}
POST = np.array([0.2, -0.3, 0.5])


def robot(muscles=True) -> dict:
    """Two links that bend, and a muscle from a post to the tip."""
    out = arm(link("upper", 0.7, ("z", "y"), **SOFT), link("fore", 0.5, ("y",), **SOFT), gravity=(0.0, 0.0, -2.0))
    muscle = Force(name="muscle", between=({"world": POST.tolist()}, "fore.tip"), law=MUSCLE)
    return out | {"name": "muscled", "forces": [muscle] * muscles}


MODEL, BARE = model_of(robot()), model_of(robot(muscles=False))


def state():
    q, v = 0.01 * np.cos(np.arange(BARE.nq)), 0.6 * np.cos(np.arange(BARE.nv))
    q[:3] = 0.4, 0.5, -0.9
    return q, np.append(v, 0.5), np.array([0.4, -0.3, 0.2, 0.9]), np.zeros((BARE.n_links, 6))


@pytest.fixture(scope="module")
def judged():
    """The same motion as with the hose's pull among the wrenches on the tip of an arm without it."""
    q, v, tau, w_ext = state()
    R, r = (x[BARE.marker_names.index("fore.tip")] for x in BARE.numpy().marker_pose(q))
    long = np.linalg.norm(r - POST)
    borne = w_ext.copy()
    borne[-1, 3:] = R.T @ (POST - r) / long * v[-1] * 4e5 * (9e-4 * (long / 0.9) ** 2 - 3e-4)
    vdot, wrench = BARE.numpy().forward_dynamics(q, v[:-1], tau[:-1], borne)
    return Outside(MODEL, (q, v, tau, w_ext), np.append(vdot, (tau[-1] - v[-1]) / 0.03), wrench)


@every_check
def test_it_pulls_as_its_law_says(judged, check):
    judged.holds(check)


@pytest.mark.parametrize("check", ["estimator", "linear model", "derivatives of wrenches", "document", "acados"])
def test_it_goes_on_to(judged, check):
    judged.holds(check)


@pytest.mark.parametrize("target", ["fmu2", "fmu3"])
def test_a_mock_up_unit_has_it(target):
    unit = Unit(target, "me", robot)
    q, v, tau, w_ext = state()
    unit.ready(**dict(zip(unit.states, [*q, *v], strict=True)))
    unit.set(dict(zip(unit.inputs, [*tau, *w_ext.ravel()], strict=True)))
    vdot = MODEL.numpy().forward_dynamics(q, v, tau, w_ext)[0]
    assert relative(unit.get([f"der({name})" for name in MODEL.v_names]), vdot) < 1e-11


def test_it_fills_in_its_time():
    """To 1 - 1/e of what is told at once, to the order of the method."""
    run = simulate(MODEL, 0.03, 1e-3, q0=state()[0], controller=np.array([0.0, 0.0, 0.0, 0.25]), integrator="rk4")
    assert run.v[-1, -1] == pytest.approx(0.25 * (1 - np.exp(-1)), rel=1e-6)
