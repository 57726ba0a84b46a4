"""An element of an axis that the product does not contain: a stop whose force grows with the square of its depth."""

from dataclasses import dataclass

import casadi as ca
import numpy as np
import pytest
from conftest import package
from helpers import arm, link, model_of, quick, relative

from screwgen import Robot, RobotFileError, ScrewgenError, UsageError, dump, simulate
from screwgen.elements import AxisElement, key
from screwgen.integrators import METHODS


@dataclass(frozen=True)
class Buffer(AxisElement):
    """A buffer of rubber beyond an angle: ``F = k d² + c d w`` at a depth d > 0."""

    KIND = "buffer"
    WORDS = "rubber buffers"
    FORMULA = r"k\,d^2 + c\,d\,\dot q"

    stiffness: float = key("N·m/rad²", "N/m²", "stiffness of the buffer", "k", sign="positive")
    damping: float = key("N·m·s/rad²", "N·s/m²", "damping of the buffer", "c", sign="non-negative")
    at: float = key("rad", "m", "coordinate at which the buffer begins", "q_0")

    @staticmethod
    def force(t, x, w, stiffness, damping, at):
        depth = x - at
        return t.call("on", depth) * (stiffness * depth * depth + damping * depth * w)

    @staticmethod
    def energy(t, x, stiffness, damping, at):
        depth = x - at
        return t.call("on", depth) * (stiffness * (depth * depth * depth)) / 3.0


BUFFER = Buffer(stiffness=900.0, damping=30.0, at=0.2)
SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}


def dressed(element=BUFFER):
    """A link of two axes and one that slides; the element on the second axis and on the slide."""
    first = link("upper", 0.7, ("z", "y"), joint={"elements": [{}, element], "damping": [0.3, 0.2]}, **SOFT)
    slide = link("fore", 0.4, [{"slide": "x"}], joint={"elements": element, "drives": {"rotor_inertia": 0.1}}, **SOFT)
    return model_of(arm(first, slide, gravity=(0.0, 0.0, -2.0)))


def state(model):
    q = 0.01 * np.arange(1.0, model.nq + 1)
    q[1], q[2] = 0.5, 0.35
    return q, 0.3 * np.cos(np.arange(model.nv)), np.array([0.4, -0.3, 2.0]), np.zeros((2, 6))


def force(x, w):
    depth = np.maximum(x - BUFFER.at, 0.0)
    return BUFFER.stiffness * depth**2 + BUFFER.damping * depth * w


def test_it_pushes_as_its_law_says_in_every_back_end():
    """The same motion as with the force among the torques of an arm without it."""
    model, bare = dressed(), dressed({})
    q, v, tau, w_ext = state(model)
    pushed = tau - np.r_[0.0, force(q[1:3], v[1:3])]
    expected = bare.numpy().forward_dynamics(q, v, pushed, w_ext)[0]
    jax = package("jax")
    with jax.enable_x64(True):
        found = {"JAX": model.jax()["forward_dynamics"](q, v, tau, w_ext, np.array(model.parameter_values))[0]}
    found |= {"NumPy": model.numpy().forward_dynamics(q, v, tau, w_ext)[0]}
    found |= {"DAE": model.numpy().dae_forward_dynamics(q, v, tau, w_ext)[0]}
    found |= {
        "CasADi": model.casadi()["forward_dynamics"](q, v, tau, w_ext.T, model.parameter_values)[0].full().ravel()
    }
    for options in ({"layout": "fused"}, {"layout": "modular"}, {"parameters": "baked"}):
        found[str(options)] = quick(model, **options).forward_dynamics(q, v, tau, w_ext)[0]
    for name, vdot in found.items():
        assert relative(np.asarray(vdot), expected) < 1e-10, name


def test_its_energy_is_the_work_against_it():
    model, bare = dressed(), dressed({})
    q, v, *_ = state(model)
    more = model.numpy().energy(q, v)[1] - bare.numpy().energy(q, v)[1]
    assert more == pytest.approx(np.sum(BUFFER.stiffness * (q[1:3] - BUFFER.at) ** 3 / 3), rel=1e-12)


def test_derivatives_are_those_of_casadi():
    model = dressed()
    q, v, tau, w_ext = state(model)
    f = model.casadi()["forward_dynamics"]
    J = f.jacobian()(q, v, tau, w_ext.T, model.parameter_values, 0, 0)
    c = quick(model, derivatives=True).linearise(q, v, tau, w_ext)[1:]
    for found, in_c, expected in zip(model.numpy().derivatives(q, v, tau, w_ext), c, J[:3], strict=True):
        assert relative(found, expected.full()) < 1e-9 and relative(in_c, expected.full()) < 1e-9


@pytest.mark.parametrize("name", METHODS)
def test_a_step_and_its_derivatives_follow_from_the_force_alone(name):
    """In C against CasADi's automatic differentiation of the same step."""
    model = dressed()
    q, v, tau, w_ext = state(model)
    step, p, h = model.casadi()[f"step_{name}"], model.parameter_values, 1e-3
    compiled = quick(model, derivatives=True)
    for found, expected in zip(compiled.step(q, v, tau, w_ext, h, name), step(q, v, tau, w_ext.T, p, h), strict=True):
        assert relative(found, expected.full().ravel()) < 1e-12
    x, u = ca.SX.sym("x", model.nq + model.nv), ca.SX.sym("u", model.n_tau)
    after = ca.vertcat(*step(x[: model.nq], x[model.nq :], u, w_ext.T, p, h))
    A = ca.Function("A", [x, u], [ca.jacobian(after, x), ca.jacobian(after, u)])(np.r_[q, v], tau)
    _, _, by_x, by_u = compiled.step_derivatives(q, v, tau, w_ext, h, name)
    assert relative(by_x, A[0].full()) < 1e-9 and relative(by_u, A[1].full()) < 1e-8


def test_runs_rollouts_and_both_forms_agree():
    model = dressed()
    q, v, tau, _ = state(model)
    c, numpy = (simulate(model, 0.05, 1e-3, q0=q, v0=v, controller=tau, backend=x) for x in ("c", "numpy"))
    assert relative(c.q, numpy.q) < 1e-10
    given = dict(q0=q, v0=v, controller=tau, integrator="rk4")
    ends = [[simulate(model, 0.02, h, form=x, **given).q[-1] for x in ("dae", "joint")] for h in (2e-4, 1e-4)]
    errors = [relative(*pair) for pair in ends]
    assert errors[1] < 1e-7 and errors[0] / errors[1] > 12, "of fourth order in the step"


def test_its_numbers_are_parameters():
    model = dressed()
    names = [name for name in model.parameter_names if ".elements[" in name]
    assert names[0] == "upper.joint.elements[1].buffer.stiffness" and len(names) == 6
    q, v, tau, w_ext = state(model)
    softer = {names[0]: 1.0, names[1]: 0.0}
    expected = dressed(Buffer(1.0, 0.0, 0.2)).numpy().forward_dynamics(q, v, tau, w_ext)[0]
    both = softer | {names[3]: 1.0, names[4]: 0.0}
    assert relative(model.numpy(both).forward_dynamics(q, v, tau, w_ext)[0], expected) < 1e-13
    compiled = quick(model)
    compiled.prepare(both)
    assert relative(compiled.forward_dynamics(q, v, tau, w_ext)[0], expected) < 1e-12
    with pytest.raises(ScrewgenError):
        compiled.prepare(both | {names[0]: -1.0})


def test_a_file_cannot_state_one_and_bad_numbers_are_refused():
    robot = lambda element: Robot(**arm(link(joint={"elements": element})))  # noqa: E731
    with pytest.raises(RobotFileError, match=r"elements\[0\].buffer .link arm.: is an unknown key; known here: spring"):
        robot({"buffer": {"stiffness": 1.0}})
    with pytest.raises(RobotFileError, match=r"elements\[0\].buffer.stiffness .link arm.: is -1.0; it must be > 0"):
        robot(Buffer(-1.0, 0.0, 0.0))
    with pytest.raises(UsageError, match=r"joint\.elements holds an object made in Python"):
        dump(robot(BUFFER))
