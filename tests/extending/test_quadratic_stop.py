"""An element of an axis that the product does not contain: a stop whose force grows with the square of its depth."""

from dataclasses import dataclass

import numpy as np
import pytest
from helpers import arm, link, model_of, quick, relative
from outside import Outside, every_check

from screwgen import Robot, RobotFileError, ScrewgenError, UsageError, dump
from screwgen.elements import AxisElement, key


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


@pytest.fixture(scope="module")
def pushed():
    """The same motion as with the force among the torques of an arm without it."""
    model, bare = dressed(), dressed({})
    q, v, tau, w_ext = state(model)
    expected = bare.numpy().forward_dynamics(q, v, tau - np.r_[0.0, force(q[1:3], v[1:3])], w_ext)
    return Outside(model, (q, v, tau, w_ext), *expected)


@every_check
def test_it_pushes_as_its_law_says(pushed, check):
    pushed.holds(check)


def test_its_energy_is_the_work_against_it():
    model, bare = dressed(), dressed({})
    q, v, *_ = state(model)
    more = model.numpy().energy(q, v)[1] - bare.numpy().energy(q, v)[1]
    assert more == pytest.approx(np.sum(BUFFER.stiffness * (q[1:3] - BUFFER.at) ** 3 / 3), rel=1e-12)


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
