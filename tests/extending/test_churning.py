"""An element that the product does not contain: what a gear that churns in oil takes, by the square of the rate."""

from dataclasses import dataclass

import numpy as np
import pytest
from helpers import arm, link, model_of
from outside import Outside, every_check

from screwgen.elements import AxisElement, key


@dataclass(frozen=True)
class Churning(AxisElement):
    """``F = (a + b sin² x) w |w|``: the deeper a tooth dips the more it moves."""

    KIND = "churning"
    WORDS = "gears that churn oil"
    FORMULA = r"\left( a + b\,\left( \sin q \right)^2 \right)\,\dot{q}\,\left| \dot{q} \right|"

    least: float = key("N·m·s²/rad²", "N·s²/m²", "drag at the coordinate 0, over the square of the rate", "a")
    dipped: float = key("N·m·s²/rad²", "N·s²/m²", "what it is more at a quarter of a turn", "b")

    @staticmethod
    def force(t, x, w, least, dipped):
        depth = t.call("sin", x)
        return t.named("drag", least + dipped * (depth * depth)) * w * w * (t.call("on", w) - t.call("on", -w))


OIL = Churning(3.0, 5.0)
SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}


def dressed(element=OIL):
    """A link of two axes and one that slides; the element on the second axis and on the slide."""
    first = link("upper", 0.7, ("z", "y"), joint={"elements": [{}, element], "damping": [0.3, 0.2]}, **SOFT)
    return model_of(arm(first, link("fore", 0.4, [{"slide": "x"}], joint={"elements": element}, **SOFT)))


@pytest.fixture(scope="module")
def wet():
    """The same motion as with the drag among the torques of an arm without it."""
    model, bare = dressed(), dressed({})
    q, w_ext, tau = 0.3 * np.cos(np.arange(model.nq)), np.zeros((2, 6)), np.array([0.4, -0.3, 2.0])
    q[3:], v = 0.01, 0.9 * np.cos(np.arange(model.nv))
    drag = (3.0 + 5.0 * np.sin(q[1:3]) ** 2) * v[1:3] * np.abs(v[1:3])
    expected = bare.numpy().forward_dynamics(q, v, tau - np.append(0.0, drag), w_ext)
    return Outside(model, (q, v, tau, w_ext), *expected)


@every_check
def test_it_brakes_as_its_law_says(wet, check):
    wet.holds(check)


@pytest.mark.parametrize(
    "check", ["derivatives of wrenches", "document", "C folder", "acados", "estimator", "linear model"]
)
def test_it_goes_on_to(wet, check):
    wet.holds(check)
