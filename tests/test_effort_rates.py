"""Limits of the rate of efforts: torques grow by no more than the file says, in every step, run and unit."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from helpers import arm, link, model_of, quick, quick_batch, relative
from scipy.integrate import solve_ivp

from screwgen import LimitWarning, ScrewgenError, UsageError, equilibrium, plan, rollout, simulate
from screwgen.integrators import METHODS
from screwgen.interchange.urdf_write import export_urdf
from screwgen.spec.parameters import parameters

RATE, TIME, MOST = 40.0, 0.02, 15.0
LIMIT = {"effort": MOST, "effort_rate": RATE, "effort_time": TIME}
INERTIA = 0.3


def robot(limit=LIMIT):
    """A link that turns in a plane."""
    one = link("arm", 0.5, "z", joint={"armature": INERTIA, "limits": limit})
    return arm(one, gravity=(0.0, 0.0, 0.0))


MODEL, FREE = model_of(robot()), model_of(robot({}))


def ramp(asked: float, duration: float) -> np.ndarray:
    """What acts at the end, and the state that follows it: ``zdot = (tau - z)/T`` of what is within ``z ± r T``."""
    held = lambda z: np.clip(asked, max(-MOST, z - RATE * TIME), min(MOST, z + RATE * TIME))  # noqa: E731
    found = solve_ivp(
        lambda t, z: (held(z[0]) - z) / TIME, (0.0, duration), [0.0], rtol=1e-10, atol=1e-12, max_step=1e-3
    )
    return np.array([held(found.y[0, -1]), found.y[0, -1]])


@pytest.mark.parametrize("method", ["euler", "semi_implicit", "modal_midpoint", "rk4"])
@pytest.mark.parametrize("form", ["joint", "dae"])
@pytest.mark.filterwarnings("ignore::screwgen.LimitWarning")
def test_a_step_of_a_torque_becomes_a_ramp_up_to_its_limit(form, method):
    """In fine steps that of the differential equation; with steps of a twentieth of T by 5 % less, never faster."""
    for duration in (0.1, 0.6):
        run = simulate(MODEL, duration, 1e-4, controller=[100.0], integrator=method, form=form)
        found = np.array([run.tau[-1, 0], run.v[-1, 1]])
        assert relative(found, ramp(100.0, duration)) < 6e-3
        assert np.diff(run.tau[:, 0]).max() <= RATE * 1e-4 * (1 + 1e-9) and run.tau[0, 0] == pytest.approx(RATE * TIME)
    assert run.tau[-1, 0] == MOST
    run = simulate(MODEL, 0.1, 1e-3, controller=[100.0], integrator=method, form=form)
    assert 0.94 * RATE < np.diff(run.tau[:, 0]).mean() / 1e-3 <= RATE * (1 + 1e-9)


@pytest.mark.parametrize("method", METHODS)
def test_steps_are_those_of_the_torque_that_is_left(method):
    """In NumPy's runs, C and lanes: as a step of the arm without limits."""
    q, v, tau = np.array([0.2]), np.array([0.5, 3.0]), np.array([9.0])
    want = FREE.casadi()[f"step_{method}"](q, v[:1], 3.0 + RATE * TIME, 0.0, FREE.parameter_values, 1e-3)
    want = np.concatenate([x.full().ravel() for x in want])
    assert MODEL.numpy().held_inputs(q, v, tau) == pytest.approx([3.8], rel=1e-15)
    found = np.concatenate(quick(MODEL).step(q, v, tau, np.zeros((1, 6)), 1e-3, method))
    quick_batch(MODEL)
    with pytest.warns(
        LimitWarning, match=r"arm.torque\[0\] was held at the limit of its effort or at the limit of its rate"
    ):
        ran = rollout(MODEL, np.r_[q, v], tau, step=1e-3, steps=1, integrator=method)
    assert relative(found[:2], want) < 1e-13
    assert relative(np.concatenate([ran.q[0, 1], ran.v[0, 1]]), found) < 1e-13


def test_they_are_parameters():
    names = [name for name in MODEL.parameter_names if ".limits" in name]
    assert names == [f"arm.joint.limits[0].{key}" for key in LIMIT]
    c = quick(MODEL)
    c.prepare({"arm.joint.limits[0].effort_rate": 100.0})
    found = np.concatenate(c.step(np.zeros(1), np.zeros(2), np.array([9.0]), np.zeros((1, 6)), 1e-3))
    want = np.concatenate(quick(FREE).step(np.zeros(1), np.zeros(1), np.array([2.0]), np.zeros((1, 6)), 1e-3))
    assert relative(found[:2], want) < 1e-13
    for name in names[1:]:
        with pytest.raises(ScrewgenError):
            c.prepare({name: 0.0})


def test_a_slide_has_its_own_units():
    model = model_of(
        arm(link("cart", 0.3, [{"slide": "x"}], joint={"limits": {"effort_rate": 9.0, "effort_time": 0.1}}))
    )
    units = {p.name.rpartition(".")[2]: p.unit for p in parameters(model.robot) if "effort" in p.name}
    assert units == {"effort_rate": "N/s", "effort_time": "s"}


def test_at_rest_it_remembers_what_holds_the_arm():
    heavy = model_of(arm(link("boom", 1.0, "y", joint={"limits": LIMIT}), gravity=(0.0, 0.0, -9.81)))
    with warnings.catch_warnings():
        warnings.simplefilter("error", LimitWarning)
        assert abs(equilibrium(heavy, [0.0], hold=True).tau[0]) > 2 * RATE * TIME


@pytest.mark.parametrize(
    ("limit", "said"),
    [
        ({"effort_rate": 9.0}, "is stated without effort_time; state both, or none"),
        ({"effort_time": 0.1}, "is stated without effort_rate; state both, or none"),
        ({"effort_rate": -9.0, "effort_time": 0.1}, "must be > 0"),
        ({"effort_rate": 9.0, "effort_time": 1e9}, "must be from 1e-09 to 1e.06 s"),
    ],
)
def test_what_cannot_be_is_refused_in_a_line(limit, said):
    with pytest.raises(ValueError, match=f"(?s){said}"):
        model_of(robot(limit))


def test_what_does_not_know_them_says_so(tmp_path):
    file = tmp_path / "mpc.toml"
    file.write_text(
        "[horizon]\nstep = 0.02\nintervals = 6\n[goal]\njoints = [0.1]\n[cost]\njoints = 1.0\ntorques = 0.1\n"
    )
    with pytest.raises(UsageError, match="has drives whose steps hold what their motion allows"):
        MODEL.c_files(mpc=file)
    notes = export_urdf(MODEL.robot).notes
    assert "arm.joint.limits: are written without limits of the rate of efforts" in notes
    with pytest.raises(UsageError, match="has internal states, for which there is no plan yet"):
        plan(MODEL, [0.0], [0.5], time=1.0)
