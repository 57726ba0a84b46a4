"""A force between frames with internal states that the product does not contain: a pad of bristles, one file."""

from dataclasses import dataclass

import numpy as np
import pytest
from fmi_units import Unit
from helpers import arm, link, model_of, relative
from outside import Outside, every_check

from screwgen import simulate
from screwgen.interactions import ForceState, Interaction, StateRate, WrenchOnSecond, number
from screwgen.spec.forces import Force


@dataclass(frozen=True)
class Pad(Interaction):
    """A pad at the second frame on a plane across z of the first: bristles bend by its slip, and slip as Dahl's do."""

    KIND = "pad"
    WORDS = "pads of bristles"
    STATES = {f"bent_{x}": ForceState("m", f"deflection along {x}", f"z_{x}", 1e-3) for x in "xy"}  # noqa: RUF012

    stiffness: float = number("N/m", "stiffness of the bristles", r"\sigma", sign="positive")
    friction: float = number("N", "friction that they slip at", "F_c", sign="positive")

    @staticmethod
    def wrench(t, x, stiffness, friction, **z):
        return WrenchOnSecond((0.0, 0.0, 0.0), (-stiffness * z["bent_x"], -stiffness * z["bent_y"], 0.0))

    @staticmethod
    def energy(t, x, stiffness, friction, **z):
        return 0.5 * stiffness * (z["bent_x"] * z["bent_x"] + z["bent_y"] * z["bent_y"])

    @staticmethod
    def rates(t, x, stiffness, friction, **z):
        decay = stiffness / friction * t.call("sqrt", x.v[0] * x.v[0] + x.v[1] * x.v[1] + 1e-12)
        return {"bent_x": StateRate(x.v[0], decay), "bent_y": StateRate(x.v[1], decay)}


PAD = Pad(stiffness=900.0, friction=4.0)
SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}


def robot(pads=True) -> dict:
    """Two links that bend, and a pad at the tip on a table."""
    out = arm(link("upper", 0.7, ("z", "y"), **SOFT), link("fore", 0.5, ("y",), **SOFT), gravity=(0.0, 0.0, -2.0))
    pad = Force(name="pad", between=({"world": [0.4, 0.3, -0.1]}, "fore.tip"), law=PAD)
    return out | {"name": "padded", "forces": [pad] * pads}


MODEL, BARE = model_of(robot()), model_of(robot(pads=False))


def state():
    q, v = 0.01 * np.cos(np.arange(BARE.nq)), 0.6 * np.cos(np.arange(BARE.nv))
    q[:3] = 0.4, 0.5, -0.9
    return q, np.append(v, [2e-3, -1e-3]), np.array([0.4, -0.3, 0.2]), np.zeros((BARE.n_links, 6))


@pytest.fixture(scope="module")
def judged():
    """The same motion as with the bristles' force among the wrenches on the tip of an arm without a pad."""
    q, v, tau, w_ext = state()
    rates, z = v[: BARE.nv], v[BARE.nv :]
    R, tip = BARE.numpy().marker_pose(q)[0][-1], BARE.marker_names.index("fore.tip")
    slip = R[:2] @ BARE.numpy().marker_velocity(q, rates)[tip][3:]
    borne = w_ext.copy()
    borne[-1, 3:] = R.T @ np.append(-PAD.stiffness * z, 0.0)
    vdot, wrench = BARE.numpy().forward_dynamics(q, rates, tau, borne)
    zdot = slip - PAD.stiffness / PAD.friction * np.linalg.norm(slip) * z
    assert np.linalg.norm(slip) > 0.1 and tip == len(BARE.marker_names) - 1
    return Outside(MODEL, (q, v, tau, w_ext), np.append(vdot, zdot), wrench)


@every_check
def test_it_rubs_as_its_law_says(judged, check):
    judged.holds(check)


@pytest.mark.parametrize("check", ["estimator", "linear model", "derivatives of wrenches", "document"])
def test_who_asks_for_states_has_them(judged, check):
    judged.holds(check)


def test_names_and_energy():
    q, v, *_ = state()
    assert MODEL.v_names[-2:] == ["pad.bent_x_state[0]", "pad.bent_y_state[0]"]
    assert MODEL.linearise(None).state_names[-2:] == ("pad.bent_x_state[0]", "pad.bent_y_state[0]")
    stored = MODEL.numpy().energy(q, v)[1] - BARE.numpy().energy(q, v[: BARE.nv])[1]
    assert stored == pytest.approx(PAD.stiffness * 5e-6 / 2, rel=1e-9)


def test_a_mock_up_unit_has_them():
    unit = Unit("fmu2", "me", robot)
    q, v, tau, w_ext = state()
    unit.ready(**dict(zip(unit.states, [*q, *v], strict=True)))
    unit.set(dict(zip(unit.inputs, [*tau, *w_ext.ravel()], strict=True)))
    vdot = MODEL.numpy().forward_dynamics(q, v, tau, w_ext)[0]
    assert relative(unit.get([f"der({name})" for name in MODEL.v_names]), vdot) < 1e-11


def test_implicit_steps_are_stable_where_bristles_are_far_faster():
    """Slipping at 1 m/s with decay of 2e6/s and steps of 5 ms: the force is the friction, whatever the step."""
    slide = link("sled", 0.4, [{"slide": "x"}], bodies=[{"at": "tip", "mass": 3.0}])
    pad = Force(name="pad", between=("world", "sled.tip"), law=Pad(stiffness=8e6, friction=4.0))
    model = model_of(arm(slide, gravity=(0.0, 0.0, 0.0)) | {"forces": [pad]})
    run = simulate(model, 0.25, 5e-3, v0=[1.0], integrator="modal_implicit")
    mass = model.numpy().mass_matrix(run.q[0])[0, 0]
    assert run.v[-1, 0] == pytest.approx(1.0 - 4.0 * (run.t[-1] - run.t[1]) / mass, abs=1e-3)
    assert run.v[2:, 1] == pytest.approx(4.0 / 8e6, rel=1e-3)
