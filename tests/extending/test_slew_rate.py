"""A law of what a step holds with a state, which the product does not contain: a limit of the rate of an input."""

import warnings
from dataclasses import dataclass

import numpy as np
import pytest
from fmi_units import Unit
from helpers import arm, link, model_of, quick, quick_batch, relative
from outside import Outside, filters_agree

from screwgen import LimitWarning, UsageError, assemble, equilibrium, rollout, simulate
from screwgen.backends.fmi.variables import METHOD
from screwgen.backends.latex.document import document
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.elements import HeldLaw, Key, MemoryRate, key
from screwgen.integrators import METHODS
from screwgen.simulation.simulate import stepper


@dataclass(frozen=True)
class SlewRate(HeldLaw):
    """The rate of what is held, filtered with a time T, is ``(tau - z)/T`` of the state z that follows it: |.| ≤ r."""

    KIND = "slew"
    WORDS = "limits of the rate of efforts"
    FORMULA = r"\min\left( \max\left( \tau, z - r\,T \right), z + r\,T \right)"
    RATE = r"\frac{\tau - z}{T}"
    SAID = "at the limit of its rate"
    state = Key("N·m", "N", "effort that follows what is held", "z")

    most: float = key("N·m/s", "N/s", "largest rate, of either sign", "r", sign="positive")
    time: float = key("s", "s", "time over which the rate is measured", "T", sign="positive")

    @staticmethod
    def held(t, tau, x, w, z, most, time):
        above, below = t.call("on", tau - z - most * time), t.call("on", z - tau - most * time)
        return tau * (1.0 - above - below) + z * (above + below) + most * time * (above - below)

    @staticmethod
    def rate(t, tau, x, w, z, most, time):
        return MemoryRate(tau / time, 1.0 / time)


LIMITS = (SlewRate(40.0, 0.02), SlewRate(90.0, 0.01), SlewRate(30.0, 0.02))
SOFT = {"modes": {"bending_y": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}
GEAR = {"ratio": 20.0, "rotor_inertia": 1e-4, "stiffness": 400.0, "damping": 0.5}
RUBBING = {"friction": {"coulomb": 0.3, "viscous": 0.1, "memory": {"stiffness": 70.0}}}
H = 1e-3


def driven(limits=LIMITS):
    """A link of two axes, of which one remembers friction besides, one that slides, one behind an elastic gear."""
    a, b, c = limits or ({},) * 3
    first = {"elements": [a, {}], "drives": [{}, RUBBING], "damping": [0.3, 0.2]}
    slide = link("fore", 0.4, [{"slide": "x"}], joint={"elements": b}, bodies=[{"at": "tip", "mass": 0.4}])
    hand = link("hand", 0.2, ("y",), joint={"elements": c, "drives": GEAR})
    return arm(link("upper", 0.7, ("z", "y"), joint=first, **SOFT), slide, hand, gravity=(0.0, 0.0, -2.0))


MODEL, BARE = model_of(driven()), model_of(driven(()))
Q, W_EXT = np.array([0.3, -0.4, 0.05, 0.2, 4.1, 0.01]), np.zeros((3, 6))
V = np.array([1.0, -0.4, -0.7, 0.5, 12.0, 0.1, 1e-3, 1.5, -4.0, 0.2])
"""The rates, the deflection of the bristles, what the three limits remember."""
TAU = np.array([7.0, -2.0, -4.5, 0.3])
"""The first torque is beyond the limit of its rate, the force of the slide and the torque of the rotor are within."""


def within(v, tau=TAU):
    """What the drives give with the states in ``v`` (…, 10)."""
    out = np.broadcast_to(tau, (*np.shape(v)[:-1], 4)).copy()
    for place, z, one in zip((0, 2, 3), np.moveaxis(v[..., 7:], -1, 0), LIMITS, strict=True):
        out[..., place] = np.clip(out[..., place], z - one.most * one.time, z + one.most * one.time)
    return out


def follows(z, tau):
    """The rates of these states."""
    return (tau[[0, 2, 3]] - z) / [one.time for one in LIMITS]


@pytest.fixture(scope="module")
def c():
    return quick(MODEL, derivatives=True)


class Limited(Outside):
    """A case whose inputs are limited."""

    acting = property(lambda self: within(V))


@pytest.fixture(scope="module")
def judged():
    """Dynamics take the input as it is, and its states follow that."""
    vdot, wrench = BARE.numpy().forward_dynamics(Q, V[:7], TAU, W_EXT)
    return Limited(MODEL, (Q, V, TAU, W_EXT), np.append(vdot, follows(V[7:], TAU)), wrench)


CHECKS = ["DAE form", "CasADi", "JAX", "C, fused", "C, modular", "lanes", "derivatives", "derivatives of steps"]
CHECKS += ["derivatives of wrenches", "linear model", "acados", "C folder"]


@pytest.mark.parametrize("check", CHECKS)
def test_dynamics_take_inputs_as_they_are(judged, check):
    judged.holds(check)


def test_documents_say_its_law_and_name_its_states():
    text = str(document(MODEL.robot))
    assert r"\dot{z} & = \frac{\tau - z}{T}" in text and text.count("effort that follows what is held, of $q_") == 3


def test_its_states_have_names_and_units():
    names = ["upper.friction_state[1]", "upper.slew_state[0]", "fore.slew_state[0]", "hand.slew_state[0]"]
    assert MODEL.v_names[-4:] == names and within(V)[0] == 1.5 + 0.8 and np.array_equal(within(V)[1:], TAU[1:])


@pytest.mark.parametrize("method", METHODS)
def test_every_step_holds_what_the_drives_give(method, c):
    """As a step of the arm without limits that gets as much; its states as the same method takes their own rule."""
    own, bare, tau = stepper(MODEL, method), stepper(BARE, method), within(V)
    want = np.concatenate(bare.step(bare.initial(Q, V[:7]), tau, W_EXT, H))
    found = {"NumPy": np.concatenate(own.step(own.initial(Q, V), TAU, W_EXT, H))}
    given = Q, V, TAU, W_EXT.T, MODEL.parameter_values, H
    found["CasADi"] = np.concatenate([x.full().ravel() for x in MODEL.casadi()[f"step_{method}"](*given)])
    found["C"] = np.concatenate(c.step(Q, V, TAU, W_EXT, H, method))
    quick_batch(MODEL)
    with pytest.warns(LimitWarning, match=r"upper.torque\[0\] was held at the limit of its rate: in 100 %"):
        ran = rollout(MODEL, np.r_[Q, V], TAU, step=H, steps=1, integrator=method)
    found["lanes"] = np.concatenate([ran.q[0, 1], ran.v[0, 1]])
    for name, x in found.items():
        assert relative(x[:13], want) < 1e-13, name
        assert relative(x[13:], found["NumPy"][13:]) < 1e-13, name
        moved = (x[13:] - V[7:]) / H
        assert np.abs(moved - follows(V[7:], tau)).max() < 0.11 * np.abs(follows(V[7:], tau)).max(), name
    bare, own = stepper(BARE, method, "dae"), stepper(MODEL, method, "dae")
    want = bare.step(bare.initial(Q, V[:7]), tau, W_EXT, H)
    for x in (own.step(own.initial(Q, V), TAU, W_EXT, H), c.dae_step(c.dae_state(Q, V), TAU, W_EXT, H, method)):
        assert relative(x[:-3], want) < 1e-13 and relative(x[-3:], found["NumPy"][13:]) < 1e-12


@pytest.mark.parametrize("method", ["euler", "modal_midpoint", "rk4"])
def test_derivatives_of_steps_have_their_slopes(method, c):
    """Beside central differences of the step itself."""
    x = np.concatenate([Q, V, TAU])
    step = lambda x: np.concatenate(c.step(x[:6], x[6:16], x[16:], W_EXT, 4e-3, method))  # noqa: E731
    widths = 1e-5 * np.maximum(1.0, np.abs(x))
    widths[12] = 1e-7
    want = np.transpose([(step(x + e) - step(x - e)) / (2 * d) for e, d in zip(np.diag(widths), widths, strict=True)])
    *_, A, B = c.step_derivatives(Q, V, TAU, W_EXT, 4e-3, method)
    assert relative(np.hstack([A, B]), want) < 1e-7
    assert not B[:, 0].any() and A[:, 13].any() and B[13:, 2].any()


def test_jax_has_them_too():
    jax = pytest.importorskip("jax")
    with jax.enable_x64(True):
        step = MODEL.jax()["step_rk4"]
        found = step(Q, V, TAU, W_EXT, np.array(MODEL.parameter_values), H)
        own = stepper(MODEL, "rk4")
        assert relative(np.concatenate(found), np.concatenate(own.step(own.initial(Q, V), TAU, W_EXT, H))) < 1e-12


def test_a_run_records_what_acted_and_no_rate_is_larger_than_allowed():
    """A step of a torque becomes a ramp, in C and in Python, in both forms."""
    tau, start = np.array([20.0, 0.0, 0.0, 0.0]), np.append(V[:7], np.zeros(3))
    for options in ({"backend": "c"}, {"backend": "casadi"}, {"form": "dae"}):
        with pytest.warns(LimitWarning, match="was held at the limit of its rate: in .* first at t = 0 s"):
            run = simulate(MODEL, 0.4, H, Q, start, tau, **options)
        assert relative(run.tau, within(run.v, tau)) < 1e-12
        rates = np.diff(run.tau[:, 0]) / H
        assert 0.9 * 40.0 < rates[1] < 40.0 and rates.max() <= 40.0 + 1e-9
        assert run.tau[0, 0] == pytest.approx(0.8)
    fine = simulate(MODEL, 0.1, 1e-5, Q, start, tau, integrator="rk4")
    assert fine.tau[-1, 0] == pytest.approx(0.8 + 40.0 * 0.1, rel=1e-3)


RELAXES = {"stiffness": 90.0, "rest": 0.3, "relaxation": 40.0, "relaxation_time": 0.1}


def beside(kind):
    """Limits beside what else is remembered: by lines that relax, in a linkage and on a floating base."""
    own = lambda axes, k: {"joint": {"elements": [LIMITS[k]] * axes, "damping": [0.2] * axes}}  # noqa: E731
    line = [{"name": "rope", "between": [{"world": [0.2, 0.3, 0.9]}, "b.tip"], "line": RELAXES}]
    if kind == "floating":
        hull = {"bodies": [{"at": "base", "mass": 3.0, "inertia": [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]}]}
        return arm(
            link("a", 0.2, [], **hull), link("b", 0.6, ("y", "z"), **own(2, 0), **SOFT), base="floating", forces=line
        )
    bars = [link("a", 0.3, "y", **own(1, 0)), link("b", 0.7, "y"), link("c", 0.6, "y", parent="world", **own(1, 1))]
    bars[2]["joint"]["mount"] = {"xyz": [0.8, 0.0, 0.0]}
    loop = {"between": ["b.tip", "c.tip"], "joint": {"axes": ["y"]}}
    return arm(*bars, loops=[loop], forces=line * (kind == "linkage with a line"))


@pytest.mark.parametrize("kind", ["floating", "linkage", "linkage with a line"])
def test_they_stand_beside_other_states(kind):
    """Steps of both forms, lanes and derivatives in C are those of NumPy."""
    model = model_of(beside(kind))
    c, chain, n = quick(model, derivatives=True), model.chain, model.nv
    q = np.array(chain.integrate(np.array(chain.home), np.where(np.arange(n) < chain.eta_v, 0.2, 1e-3), SERIES))
    q = assemble(model, [0.3, -0.4, -1.5], hold=["a.joint[0]"]) if kind != "floating" else q
    v = np.append(0.2 * np.cos(np.arange(n)) * (kind == "floating"), np.linspace(-0.5, 0.4, chain.n_internal))
    tau, w_ext = 3.0 * np.cos(np.arange(model.n_tau)), np.zeros((model.n_links, 6))
    assert chain.n_internal == 2 + (kind != "linkage") and relative(model.numpy().held_inputs(q, v, tau), tau) > 0.1
    quick_batch(model)
    for method in ("euler", "modal_midpoint", "rk4"):
        own, dae = stepper(model, method), stepper(model, method, "dae")
        want = np.concatenate(own.step(own.initial(q, v), tau, w_ext, H))
        with pytest.warns(LimitWarning):
            ran = rollout(model, np.r_[q, v], tau, step=H, steps=1, integrator=method)
        assert relative(np.concatenate(c.step(q, v, tau, w_ext, H, method)), want) < 1e-11
        assert relative(np.concatenate([ran.q[0, 1], ran.v[0, 1]]), want) < 1e-11
        found = c.dae_step(c.dae_state(q, v), tau, w_ext, H, method)
        assert relative(found, dae.step(dae.initial(q, v), tau, w_ext, H)) < 1e-11
        assert relative(found[-chain.n_internal :], want[-chain.n_internal :]) < 1e-4
    compiled, numeric = c.linearise(q, v, tau, w_ext)[1:], model.numpy().derivatives(q, v, tau, w_ext)
    assert all(relative(x, y) < 1e-9 for x, y in zip(compiled, numeric, strict=True))


def test_at_rest_they_remember_what_acts():
    """No rate, no limit; a limit of the effort besides is one there too."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", LimitWarning)
        posture = equilibrium(MODEL, Q[:4], hold="all")
    assert np.abs(posture.tau[:2]).max() > 1.0  # beyond 0.8 N·m, which a drive that exerted nothing would give
    weak = driven()
    weak["links"][0]["joint"]["limits"] = [{}, {"effort": 0.5}]
    with pytest.warns(LimitWarning, match=r"upper.torque\[1\] is .* in this posture, and -?0.5 as a step holds it"):
        equilibrium(model_of(weak), Q[:4], hold="all")


def test_what_does_not_know_them_says_so(tmp_path):
    (tmp_path / "mpc.toml").write_text(
        "[horizon]\nstep = 0.02\nintervals = 6\n[goal]\njoints = [0.1]\n[cost]\njoints = 1.0\ntorques = 0.1\n"
    )
    model = model_of(arm(link("a", 0.5, "z", joint={"elements": LIMITS[0]})))
    with pytest.raises(
        UsageError, match="has drives whose steps hold what their motion allows; predictive control in C"
    ):
        model.c_files(mpc=tmp_path / "mpc.toml")
    with pytest.raises(UsageError, match="no equations in scalars: its forces or inputs have internal states"):
        model.equations()


def test_filters_know_them():
    filters_agree(MODEL, Q, V, TAU, W_EXT, H)


@pytest.mark.parametrize("target", ["fmu2", "fmu3"])
def test_units_hold_them(target):
    """Rates of model exchange, and steps of co-simulation, are those under what the drives give."""
    start = dict(zip((*MODEL.q_names, *MODEL.v_names, *MODEL.tau_names), np.r_[Q, V, TAU], strict=True))
    unit = Unit(target, "me", driven).ready(**start)
    rates = [x.variable.name for x in unit.description.derivatives]
    vdot = BARE.numpy().forward_dynamics(Q, V[:7], within(V), W_EXT)[0]
    assert relative(unit.get(rates), np.r_[V[:6], vdot, follows(V[7:], within(V))]) < 1e-12
    unit = Unit(target, "cs", driven).ready(**start | {"solver.step": H})
    unit.step(0.0, H)
    own = stepper(MODEL, METHOD)
    assert relative(unit.get(unit.states), np.concatenate(own.step(own.initial(Q, V), TAU, W_EXT, H))) < 1e-12
