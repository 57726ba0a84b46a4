"""A law of what a step holds that the product does not contain: a motor that gives the less the faster it turns."""

from dataclasses import dataclass

import casadi
import numpy as np
import pytest
from fmi_units import Unit
from helpers import arm, link, model_of, quick, quick_batch, relative
from outside import filters_agree

from screwgen import LimitWarning, UsageError, plan, rollout, simulate, sweep
from screwgen.backends.fmi.variables import METHOD
from screwgen.backends.numpy.held import HeldChain
from screwgen.elements import HeldLaw, key
from screwgen.integrators import METHODS
from screwgen.simulation.linearised import Linearised
from screwgen.simulation.simulate import stepper


@dataclass(frozen=True)
class MotorCurve(HeldLaw):
    """A straight line from the torque at rest to the speed without load, for either sign of both."""

    KIND = "curve"
    WORDS = "curves of motors"
    FORMULA = r"\min\left( \max\left( \tau, -\tau_w \right), \tau_w \right),"
    FORMULA += r" \quad \tau_w = \max\left( 0, \tau_0 \left( 1 - |w| / w_0 \right) \right)"
    SAID = "at the curve of its motor"

    stall: float = key("N·m", "N", "effort at rest", r"\tau_0", sign="positive")
    idle: float = key("rad/s", "m/s", "speed without load", "w_0", sign="positive")

    @staticmethod
    def held(t, tau, x, w, stall, idle):
        part = 1.0 - w * (t.call("on", w) - t.call("on", -w)) / idle
        most = stall * part * t.call("on", part)
        above, below = t.call("on", tau - most), t.call("on", -tau - most)
        return tau * (1.0 - above - below) + most * (above - below)


CURVES = (MotorCurve(4.0, 5.0), MotorCurve(6.0, 2.0), MotorCurve(9.0, 3.0), MotorCurve(0.5, 60.0))
SOFT = {"modes": {"bending_y": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}
GEAR = {"ratio": 20.0, "rotor_inertia": 1e-4, "stiffness": 400.0, "damping": 0.5}
H = 1e-3


def driven(curves=CURVES):
    """A link of two axes, one that slides, one behind an elastic gear: its curve is that of the rotor."""
    of = lambda *own: {"elements": list(own) if curves else [{} for _ in own]}  # noqa: E731
    first = link("upper", 0.7, ("z", "y"), joint=of(*CURVES[:2]) | {"damping": [0.3, 0.2]}, **SOFT)
    slide = link("fore", 0.4, [{"slide": "x"}], joint=of(CURVES[2]), bodies=[{"at": "tip", "mass": 0.4}])
    hand = link("hand", 0.2, ("y",), joint=of(CURVES[3]) | {"drives": GEAR})
    return arm(first, slide, hand, gravity=(0.0, 0.0, -2.0))


MODEL, BARE = model_of(driven()), model_of(driven(()))
Q, W_EXT = np.array([0.3, -0.4, 0.05, 0.2, 4.1, 0.01]), np.zeros((3, 6))
V, TAU = np.array([1.0, -0.4, -0.7, 0.5, 12.0, 0.1]), np.array([7.0, -2.0, -8.0, 0.9])
"""The first torque, the slide's force and the rotor's torque are beyond the curves, the second torque is within."""


def within(v, tau=TAU):
    """What the motors give at rates (…, nv)."""
    stall, idle = np.array([(one.stall, one.idle) for one in CURVES]).T
    most = np.maximum(0.0, stall * (1 - np.abs(v[..., [0, 1, 2, 4]]) / idle))
    return np.clip(tau, -most, most)


def stepped(method):
    """The state after a step of the arm without curves that gets what the motors give."""
    bare = stepper(BARE, method)
    return np.concatenate(bare.step(bare.initial(Q, V), within(V), W_EXT, H))


@pytest.fixture(scope="module")
def c():
    return quick(MODEL, derivatives=True)


@pytest.fixture
def jax():
    found = pytest.importorskip("jax")
    with found.enable_x64(True):
        yield found


@pytest.mark.parametrize("method", METHODS)
def test_every_step_holds_what_the_motors_give(method, c):
    """As a step of the arm without curves does that gets as much; the state of the DAE form agrees to its own order."""
    own, want, given = stepper(MODEL, method), stepped(method), (Q, V, TAU, W_EXT)
    found = {"NumPy": np.concatenate(own.step(own.initial(Q, V), TAU, W_EXT, H))}
    found["CasADi"] = np.concatenate(
        [x.full().ravel() for x in MODEL.casadi()[f"step_{method}"](Q, V, TAU, W_EXT.T, MODEL.parameter_values, H)]
    )
    found["C"] = np.concatenate(c.step(*given, H, method))
    found["lanes"] = np.concatenate(_lanes(method))
    for name, x in found.items():
        assert relative(x, want) < 1e-13, name
    bare, own = stepper(BARE, method, "dae"), stepper(MODEL, method, "dae")
    want = bare.step(bare.initial(Q, V), within(V), W_EXT, H)
    for x in (own.step(own.initial(Q, V), TAU, W_EXT, H), c.dae_step(c.dae_state(Q, V), TAU, W_EXT, H, method)):
        assert relative(x, want) < 1e-13


def _lanes(method):
    quick_batch(MODEL)
    with pytest.warns(LimitWarning) as said:
        found = rollout(MODEL, np.r_[Q, V], TAU, step=H, steps=1, integrator=method)
    assert str(said[0].message).startswith("upper.torque[0] was held at the curve of its motor: in 100 %")
    assert relative(found.tau[0], within(found.v[0])) < 1e-14
    return found.q[0, 1], found.v[0, 1]


def test_sweeps_say_what_was_limited(tmp_path):
    """Of all scenarios once; half of them ask for nothing."""
    quick_batch(MODEL)
    tau = np.repeat([TAU, np.zeros(4)], 2, axis=0)[:, None]
    draw = lambda rng, n: {"x0": np.r_[Q, V], "tau": tau}  # noqa: E731
    with pytest.warns(LimitWarning) as said:
        sweep(MODEL, draw, 8, tmp_path / "sweep.zarr", step=H, steps=3, chunk=4)
    texts = [str(x.message) for x in said if x.category is LimitWarning]
    assert len(texts) == 3 and all("in 50 % of the samples, first at t = 0 s" in text for text in texts)


def test_jax_holds_them(jax, c):
    """And has the slopes of the curves, as CasADi has."""
    given = Q, V, TAU, W_EXT, np.array(MODEL.parameter_values), H
    step = MODEL.jax()["step_rk4"]
    assert relative(np.concatenate(step(*given)), stepped("rk4")) < 1e-12
    want = np.hstack(c.step_derivatives(Q, V, TAU, W_EXT, H, "rk4")[-2:])
    found = [np.hstack(row) for row in jax.jacrev(step, argnums=(0, 1, 2))(*given)]
    assert relative(np.vstack(found), want) < 1e-10
    q, v, tau, p = (casadi.SX.sym(name, n) for name, n in zip("qvup", (6, 6, 4, len(given[4])), strict=True))
    after = casadi.vertcat(*MODEL.casadi()["step_rk4"](q, v, tau, W_EXT.T, p, H))
    slopes = casadi.Function("slopes", [q, v, tau, p], [casadi.jacobian(after, casadi.vertcat(q, v, tau))])
    assert relative(slopes(Q, V, TAU, given[4]).full(), want) < 1e-10


@pytest.mark.parametrize("method", ["euler", "modal_midpoint", "rk4"])
def test_derivatives_of_steps_have_the_slopes_of_the_curves(method, c):
    """Beside central differences of the step itself."""
    x = np.concatenate([Q, V, TAU])
    step = lambda x: np.concatenate(c.step(x[:6], x[6:12], x[12:], W_EXT, 4e-3, method))  # noqa: E731
    widths = 1e-5 * np.maximum(1.0, np.abs(x))
    want = np.transpose([(step(x + e) - step(x - e)) / (2 * d) for e, d in zip(np.diag(widths), widths, strict=True)])
    *_, A, B = c.step_derivatives(Q, V, TAU, W_EXT, 4e-3, method)
    assert relative(np.hstack([A, B]), want) < 1e-8
    assert not B[:, [0, 2, 3]].any() and B[:, 1].any()


def test_a_run_records_what_acted():
    """In C and in Python, in both forms; the energy balance has the power of what acted."""
    law = lambda t, q, v: TAU * np.cos(40 * t)  # noqa: E731
    for options in ({"backend": "c"}, {"backend": "casadi"}, {"form": "dae"}):
        with pytest.warns(LimitWarning, match="was held at the curve of its motor: in .* first at t = 0 s"):
            run = simulate(MODEL, 0.05, H, Q, V, law, **options)
        asked = np.array([law(t, None, None) for t in run.t])
        assert relative(run.tau, within(run.v, asked)) < 1e-12
        assert relative(run.drive_power[:, 0], run.tau[:, 0] * run.v[:, 0]) < 1e-12


def test_there_is_no_plan_for_them():
    """A search knows limits, and not what is left of a torque at a rate."""
    one = model_of(arm(link("upper", 0.7, ("z",), joint={"elements": CURVES[0], "limits": [{"effort": 4.0}]})))
    with pytest.raises(UsageError, match="whose steps hold what their motion allows, for which there is no plan yet"):
        plan(one, [0.0], [0.5], 2.0)


def test_filters_know_them():
    """Their linearisation beside differences of the accelerations; the filter in C is that in Python."""
    x = np.concatenate([Q, V, TAU])
    vdot = lambda x: BARE.numpy().forward_dynamics(x[:6], x[6:12], within(x[6:12], x[12:]), W_EXT)[0]  # noqa: E731
    found = BARE.numpy().derivatives(Q, V, within(V), W_EXT)
    found = HeldChain(MODEL.chain, MODEL.parameter_values)(Q, V, TAU, *found)
    want = np.transpose([(vdot(x + e) - vdot(x - e)) / 2e-5 for e in 1e-5 * np.eye(16)])
    assert relative(np.hstack(found), want) < 1e-8
    filters_agree(MODEL, Q, V, TAU, W_EXT, H)


@pytest.mark.parametrize("target", ["fmu2", "fmu3"])
def test_units_hold_them(target):
    """Rates of model exchange, and steps of co-simulation, are those under what the motors give."""
    start = dict(zip((*MODEL.q_names, *MODEL.v_names, *MODEL.tau_names), np.r_[Q, V, TAU], strict=True))
    unit = Unit(target, "me", driven).ready(**start)
    rates = [x.variable.name for x in unit.description.derivatives]
    want = BARE.numpy().forward_dynamics(Q, V, within(V), W_EXT)[0]
    assert relative(unit.get(rates), np.r_[V, want]) < 1e-12
    unit = Unit(target, "cs", driven).ready(**start | {"solver.step": H})
    unit.step(0.0, H)
    assert relative(unit.get(unit.states), stepped(METHOD)) < 1e-12


def test_the_analysis_of_a_step_knows_them(c):
    """The amplification matrix of a short step is its derivative, but for the square of its length."""
    found = Linearised(MODEL, Q, V, TAU).step_map("rk4", 1e-6) - np.eye(12)
    assert relative(found, c.step_derivatives(Q, V, TAU, W_EXT, 1e-6, "rk4")[-2] - np.eye(12)) < 1e-4
