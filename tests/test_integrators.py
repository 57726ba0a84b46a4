"""Integrators as data: what a table must fulfil, and that any table steps alike in every back end and has its order."""

from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from helpers import QUICK, arm, link, model_of

from screwgen import UsageError
from screwgen.integrators import METHODS, Method, Move, Stage
from screwgen.integrators.plan import Plan
from screwgen.simulation.simulate import stepper

KUTTA = Method(
    "kutta", 3, (Stage(), Stage(["1/2"]), Stage([-1, 2])), Move(["1/6", "2/3", "1/6"]), "Kutta's third order"
)
EIGHTHS = Method(
    "eighths",
    4,
    (Stage(), Stage(["1/3"]), Stage(["-1/3", 1]), Stage([1, -1, 1])),
    Move(["1/8", "3/8", "3/8", "1/8"]),
    "the rule of three eighths",
)
HALFWAY = Method("halfway", 2, (Stage(), Stage(["1/2"], "mean")), Move([0, 1], "mean"), "explicit midpoint, mean rates")
ROOT = 2**-0.5
RALSTON = Method("ralston", 2, (Stage(), Stage([ROOT])), Move([1 - ROOT, ROOT]), "a second-order rule of doubles")
OWN = (KUTTA, EIGHTHS, HALFWAY, RALSTON)


@cache
def model():
    """A bending link on two joints, and a link that twists on one with a spring: soft, so that they swing."""
    soft = {"EA": 5e3, "EIy": 5.0, "EIz": 8.0, "GJ": 3.0}
    spring = {"stiffness": [20.0], "damping": [0.3]}
    return model_of(arm(
        link("upper", 0.8, ["y", "z"], modes={"bending_y": 1, "bending_z": 1}, section=soft,
             bodies=[{"at": "tip", "mass": 1.0}]),
        link("fore", 0.6, [[1, 2, 2]], modes={"bending_y": 1, "torsion": 1}, section=soft, joint=spring, frame_at=0.2,
             bodies=[{"at": "tip", "mass": 0.5, "com": [0.05, 0.02, 0.0]}]),
    ))  # fmt: skip


@cache
def compiled():
    return model().compile(flags=QUICK, methods=OWN)


@cache
def start():
    rng = np.random.default_rng(4)
    q, v = 0.02 * rng.normal(size=model().nq), 0.1 * rng.normal(size=model().nq)
    q[:3], v[:3] = [0.3, -0.5, 0.7], [1.0, -2.0, 1.5]
    return q, v, np.array([2.0, -1.0, 0.5]), rng.normal(size=(2, 6))


def close(a, b) -> bool:
    return np.allclose(a, b, rtol=0, atol=1e-12 * np.abs(b).max())


# -------- tables


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"order": 3}, "it has the order 2, not 3"),
        ({"order": 5}, "its order is 5; it must be from 1 to 4"),
        ({"end": Move(["1/2", "1/3"])}, "the weights of its end add up to 5/6, not to 1"),
        ({"end": Move(["2/3", "1/3"])}, "it has the order 1, not 2"),
        ({"end": Move([1])}, "nothing reads stage 2"),
        ({"end": Move(["1/2", 0, "1/2"])}, "the end has 3 weights; there are 2 stages"),
        ({"stages": (Stage(), Stage([0, 1]))}, "stage 2 has 2 weights; only 1 stages stand before it"),
        ({"stages": (Stage(), Stage([1], implicit=1))}, "stage 2 is implicit over another part of the step"),
        ({"stages": (Stage(implicit=1), Stage([1], implicit=1))}, "it has the order 1, not 2"),
        ({"name": "Heun 2"}, "its name becomes part of C names"),
        ({"meaning": "an end */ of a comment"}, "its meaning must be one line"),
    ],
)  # fmt: skip
def test_wrong_tables_are_refused(change, message):
    right = {"name": "x", "order": 2, "stages": (Stage(), Stage([1])), "end": Move(["1/2", "1/2"]), "meaning": "x"}
    assert Method(**right).order == 2
    with pytest.raises(UsageError, match=r"^method '.*': ") as error:
        Method(**right | change)
    assert message in str(error.value)


def test_rates_of_whole_steps_do_not_reach_a_higher_order():
    with pytest.raises(UsageError, match="poses move with order 3 by the rates of stages alone"):
        Method("x", 3, HALFWAY.stages, HALFWAY.end, "x")


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Move([1], "old"), "moved is 'old'"),
        (lambda: Move(["1/2", "1/2"], "mean"), "coordinates moved by the mean rates need one acceleration"),
        (lambda: Move(["one"]), "a coefficient is 'one'"),
        (lambda: Move([float("nan")]), "a coefficient is nan"),
        (lambda: Stage(implicit=2), "implicit is 2; it must be from 0 to 1"),
    ],
)
def test_wrong_entries_are_refused(make, message):
    with pytest.raises(UsageError, match=f"^{message}"):
        make()


@pytest.mark.parametrize("method", [*METHODS.values(), *OWN], ids=str)
def test_no_table_has_a_higher_order_than_it_says(method):
    if method.order < 4:
        with pytest.raises(UsageError, match="order"):
            Method("x", method.order + 1, method.stages, method.end, "x")


@pytest.mark.parametrize("stage", [1, 2, 3])
@pytest.mark.parametrize("error", ["1/1000", "-1/50"])
def test_a_wrong_coefficient_of_runge_and_kutta_is_found(stage, error):
    stages = list(METHODS["rk4"].stages)
    stages[stage] = Stage([*stages[stage].weights[:-1], stages[stage].weights[-1] + Fraction(error)])
    with pytest.raises(UsageError, match=r"it has the order [123], not 4"):
        Method("x", 4, stages, METHODS["rk4"].end, "x")


def test_built_in_methods_cannot_be_changed():
    with pytest.raises(TypeError):
        METHODS["heun"] = KUTTA


def test_two_methods_of_one_name_are_refused():
    other = Method("rk4", 3, KUTTA.stages, KUTTA.end, "x")
    with pytest.raises(UsageError, match="there is another integrator 'rk4'"):
        model().compile(methods=(other,))
    with pytest.raises(UsageError, match="'rk4' is no Method"):
        model().compile(methods=("rk4",))
    with pytest.raises(UsageError, match=r"no integrator 'rk4' as it is given; compile .* methods=\(rk4,\)"):
        compiled().step(*start(), 1e-4, other)


@pytest.mark.parametrize(("method", "count"), [(METHODS["rk4"], 1), (KUTTA, 2), (EIGHTHS, 3)], ids=str)
def test_stages_share_states(method, count):
    """Those of the classical method follow one another in one state."""
    assert len(Plan(method).registers) == count


# -------- steps


@pytest.mark.parametrize("method", OWN, ids=str)
def test_back_ends_agree(method):
    q, v, tau, w_ext = start()
    joint, dae = stepper(model(), method), stepper(model(), method, "dae")
    expected = np.concatenate(joint.step(joint.initial(q, v), tau, w_ext, 1e-3))
    functions = model().casadi(methods=(method,))
    found = functions[f"step_{method}"](q, v, tau, w_ext.T, model().parameter_values, 1e-3)
    assert close(np.concatenate([np.array(x).ravel() for x in found]), expected)
    assert functions["step"] is model().casadi()["step"]
    assert close(np.concatenate(compiled().step(q, v, tau, w_ext, 1e-3, method)), expected)
    assert close(compiled().dae_step(compiled().dae_state(q, v), tau, w_ext, 1e-3, method.name),
                 dae.step(dae.initial(q, v), tau, w_ext, 1e-3))  # fmt: skip


@pytest.mark.parametrize("form", ["joint", "dae"])
@pytest.mark.parametrize("method", [*METHODS.values(), *OWN], ids=str)
def test_order_is_that_of_the_table(form, method):
    """Halving the step divides the error by 2 to the order; both forms meet the same solution."""
    c, (q, v, *inputs) = compiled(), start()

    def end(method, steps: int, form=form) -> np.ndarray:
        if form == "joint":
            return c.dae_state(*c.step(q, v, *inputs, 0.1 / steps, method, steps))
        return c.dae_step(c.dae_state(q, v), *inputs, 0.1 / steps, method, steps)

    exact = end("rk4", 20000, "joint")
    counts = (4000, 8000, 16000) if method.order == 1 else (200, 400, 800)
    errors = [np.abs(end(method, n) - exact).max() for n in counts]
    slopes = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.allclose(slopes, method.order, atol=0.2), (slopes, errors)
