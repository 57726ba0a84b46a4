"""An element that the product does not contain, by the angle of a point: atan2 in a law, through every back end."""

from dataclasses import dataclass

import numpy as np
import pytest
from helpers import arm, link, model_of
from outside import Outside, every_check

from screwgen.backends.c.project import CProject
from screwgen.elements import AxisElement, key


@dataclass(frozen=True)
class Pointing(AxisElement):
    """``F = k atan2(sin x + a, cos x - b)``: by the angle at which a point beside the axis sees one that turns."""

    KIND = "pointing"
    WORDS = "springs between points"
    FORMULA = r"k\,\operatorname{atan2}(\sin q + a, \cos q - b)"

    stiffness: float = key("N·m/rad", "N", "torque per angle", "k")
    across: float = key("1", "1", "how far the point is beside the axis", "a")
    ahead: float = key("1", "1", "how far it is ahead", "b")

    @staticmethod
    def force(t, x, w, stiffness, across, ahead):
        return stiffness * t.call("atan2", t.call("sin", x) + across, t.call("cos", x) - ahead)


def pointing(*given) -> dict:
    axes = {"joint": {"elements": [Pointing(*given)] * 2, "damping": [0.3, 0.2]}} if given else {}
    bend = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}
    return model_of(arm(link("upper", 0.7, ("z", "y"), **axes, **bend), link("fore", 0.4, "y", **bend)))


ANGLES = [(0.4, 2.2), (-0.5, -2.4)]
"""Postures whose points lie in all four quarters."""


def spring(q):
    return 4.0 * np.arctan2(np.sin(q[:2]) + 0.1, np.cos(q[:2]) - 0.2)


@pytest.fixture(scope="module", params=ANGLES)
def sprung(request):
    model, plain = pointing(4.0, 0.1, 0.2), pointing()
    q, v = 0.01 * np.cos(np.arange(model.nq)), 0.5 * np.cos(np.arange(model.nv))
    q[:2], w_ext, tau = request.param, np.zeros((2, 6)), np.array([0.4, -0.3, 0.2])
    torque = spring(q) + np.array([0.3, 0.2]) * v[:2]
    expected = plain.numpy().forward_dynamics(q, v, tau - np.append(torque, 0.0), w_ext)
    return Outside(model, (q, v, tau, w_ext), *expected)


@every_check
def test_a_law_may_call_it(sprung, check):
    sprung.holds(check)


@pytest.mark.parametrize(
    "check", ["C, float", "lanes, float", "derivatives by parameters", "document", "C folder", "estimator"]
)
def test_it_goes_on_to(sprung, check):
    sprung.holds(check)


def test_the_points_are_in_all_quarters():
    found = np.concatenate([spring(np.array(q)) / 4.0 for q in ANGLES])
    assert sorted(np.floor(found / (np.pi / 2)).astype(int)) == [-2, -1, 0, 1]


def test_only_c_that_asks_for_it_has_it():
    given, plain = (CProject(model.chain, "0", batch=True).files() for model in (pointing(4.0, 0.1, 0.2), pointing()))
    having = {name for name, text in given.items() if "_atan2" in text}
    assert {"arm_real.h", "arm_batch.c"} <= having and not [name for name, text in plain.items() if "atan2" in text]
