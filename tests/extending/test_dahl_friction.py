"""An element with an internal state that the product does not contain: Dahl's friction, one file."""

from dataclasses import dataclass

import numpy as np
import pytest
from helpers import arm, link, model_of
from outside import Outside, every_check

from screwgen import simulate
from screwgen.elements import AxisElement, Bristle, Key, key


@dataclass(frozen=True)
class Dahl(AxisElement):
    """Friction ``F = σ z`` of bristles that bend by ``zdot = w - σ |w| z / F_c``."""

    KIND = "dahl"
    WORDS = "Dahl's friction"
    FORMULA = r"\sigma\,z"
    RATE = r"\dot{q} - \frac{\sigma\,\left| \dot{q} \right|}{F_c}\,z"
    state = Key("rad", "m", "deflection of the bristles", "z")

    stiffness: float = key("N·m/rad", "N/m", "stiffness of the bristles", r"\sigma", sign="positive")
    coulomb: float = key("N·m", "N", "friction that they slip at", "F_c", sign="positive")

    @staticmethod
    def bristle(t, x, w, z, stiffness, coulomb):
        speed = w * (t.call("on", w) - t.call("on", -w))
        return Bristle(stiffness, 0.0, 1.0, stiffness * speed / coulomb)


DAHL = Dahl(stiffness=70.0, coulomb=2.0)
SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}


def dressed(element=DAHL):
    """A link of two axes and one that slides; the element on the second axis and on the slide."""
    first = link("upper", 0.7, ("z", "y"), joint={"elements": [{}, element], "damping": [0.3, 0.2]}, **SOFT)
    slide = link("fore", 0.4, [{"slide": "x"}], joint={"elements": element, "drives": {"rotor_inertia": 0.1}}, **SOFT)
    return model_of(arm(first, slide, gravity=(0.0, 0.0, -2.0)))


@pytest.fixture(scope="module")
def rubbed():
    """The same motion as with the friction among the torques of an arm without it."""
    model, bare = dressed(), dressed({})
    q, z, w_ext = 0.01 * np.arange(1.0, model.nq + 1), np.array([0.02, -0.015]), np.zeros((2, 6))
    v, tau = 0.3 * np.cos(np.arange(model.nv)), np.array([0.4, -0.3, 2.0])
    vdot, wrench = bare.numpy().forward_dynamics(q, v, tau - np.r_[0.0, DAHL.stiffness * z], w_ext)
    zdot = v[1:3] - DAHL.stiffness * np.abs(v[1:3]) * z / DAHL.coulomb
    return Outside(model, (q, np.append(v, z), tau, w_ext), np.append(vdot, zdot), wrench)


@every_check
def test_it_rubs_as_its_law_says(rubbed, check):
    rubbed.holds(check)


def test_its_states_have_names_and_stand_in_linear_models(rubbed):
    assert rubbed.model.v_names[-2:] == ["upper.dahl_state[1]", "fore.dahl_state[0]"]
    assert rubbed.model.linearise(None).state_names[-2:] == ("upper.dahl_state[1]", "fore.dahl_state[0]")


def test_it_holds_a_slide_that_a_plain_arm_lets_fall():
    """Along gravity: bristles carry the weight as a spring would, and it creeps no further."""
    slide = link("fore", 0.4, [{"slide": "z"}], joint={"elements": Dahl(5000.0, 60.0), "damping": 20.0})
    model = model_of(arm(slide, gravity=(0.0, 0.0, -2.0)))
    run = simulate(model, duration=20.0, step=2e-3)
    weight = -model.numpy().inverse_dynamics(run.q[-1], [0.0], [0.0], None)[0]
    assert 0 < -run.q[-1, 0] < 0.05 and abs(weight) < 60.0
    assert abs(run.q[-1, 0] - run.q[len(run.t) // 2, 0]) < 1e-9


@dataclass(frozen=True)
class InHalves(Dahl):
    """The same with a state of twice the size: its gain is 2, its stiffness a half."""

    KIND = "halves"

    @staticmethod
    def bristle(t, x, w, z, stiffness, coulomb):
        same = Dahl.bristle(t, x, w, z / 2, stiffness, coulomb)
        return Bristle(same.stiffness / 2, 0.0, 2.0, same.decay, sticks=2.0)


def test_the_size_of_a_state_is_a_choice():
    """Motion and energy are the same."""
    one, other = dressed(), dressed(InHalves(DAHL.stiffness, DAHL.coulomb))
    q, v, z = 0.01 * np.arange(1.0, one.nq + 1), 0.3 * np.cos(np.arange(one.nv)), np.array([0.02, -0.015])
    tau, w_ext = np.array([0.4, -0.3, 2.0]), np.zeros((2, 6))
    first = one.numpy().forward_dynamics(q, np.append(v, z), tau, w_ext)[0]
    second = other.numpy().forward_dynamics(q, np.append(v, 2 * z), tau, w_ext)[0]
    assert np.allclose(second * np.where(np.arange(len(second)) < one.nv, 1.0, 0.5), first, rtol=1e-12, atol=1e-12)
    stored = [model.numpy().energy(q, np.append(v, x))[1] for model, x in ((one, z), (other, 2 * z))]
    assert stored[1] == pytest.approx(stored[0], rel=1e-12)
