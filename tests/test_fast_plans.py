"""Plans by least squares over polynomials: judged by the arm that plays them, and by the search with limits."""

import numpy as np
import pytest
from conformance import planned
from conformance.cases import case_of
from conformance.features import FACTORS
from test_planning import LAW, ella, one_mode, smooth

import screwgen
from screwgen import UsageError
from screwgen.planning.plan import PlanWarning


def test_a_fast_plan_leaves_its_model_at_rest():
    """Played by the integrator of runs, which the search does not use: 0.2 % of what least jerk leaves."""
    model = one_mode(gravity=True)
    plan = screwgen.plan(model, [0.0], [1.0], 1.2, gains=LAW, fast=True)
    arrived = screwgen.play(model, plan, step=5e-4)
    assert arrived.residual <= 2e-3 * screwgen.play(one_mode(), smooth(plan), step=5e-4).residual
    assert np.abs(arrived.joints).max() < 1e-5


def test_a_fast_plan_costs_what_the_search_with_limits_finds():
    model = one_mode()
    slow, fast = (screwgen.plan(model, [0.0], [1.0], 1.2, gains=LAW, fast=x) for x in (False, True))
    assert fast.said["cost"] == pytest.approx(slow.said["cost"], rel=0.03)
    t = np.linspace(0.0, 1.2, 50)
    assert np.abs(fast.reference(t)[0] - slow.reference(t)[0]).max() < 0.02


def test_a_fast_plan_brings_other_loads_to_rest_each_with_its_sag(recwarn):
    """Whence it is played without a word: `play` itself rests the arm there."""
    model = one_mode(gravity=True)
    loads = [{"*.mass": 0.9}, {"*.mass": 1.1}]
    left = []
    for models in ((), loads):
        plan = screwgen.plan(model, [0.0], [1.0], 1.5, gains=LAW, models=models, fast=True)
        runs = [screwgen.play(model, plan, parameters={"rod.bodies[0].mass": x}) for x in (0.9, 1.0, 1.1)]
        left.append([run.residual for run in runs])
    assert max(left[1]) < 0.35 * max(left[0]) and PlanWarning not in [x.category for x in recwarn]


def test_a_fast_plan_passes_its_waypoints():
    model = one_mode()
    plan = screwgen.plan(model, [0.0], [1.0], 1.2, gains=LAW, through=[{"q": [1.2], "t": 0.7}], fast=True)
    assert plan.reference(0.7)[0] == pytest.approx([1.2], abs=1e-7)
    assert screwgen.play(model, plan).residual < 2e-4


@pytest.mark.parametrize(
    ("group", "limits"),
    [
        ("efforts", {"efforts": [5.0]}),
        ("rates", {"rates": [1.5]}),
        ("joint ranges", {"upper": [1.0], "lower": [0.0]}),
        ("rates of efforts", {"effort_rates": [3.0]}),
        ("strains", {"strains": {"*": 0.05}}),
        ("joint wrenches", {"wrenches": {"rod.tau_z": 2.0}}),
    ],
)
def test_a_fast_plan_that_passes_a_limit_is_refused_with_its_name(group, limits):
    said = rf"the fast plan passes the limits of {group}: rod.* would take .*; plan without fast.* or take more time$"
    with pytest.raises(UsageError, match=said):
        screwgen.plan(one_mode(), [0.0], [1.0], 1.2, gains=LAW, limits=limits, fast=True)


def test_limits_of_further_models_are_told_apart():
    """A load that is heavier by half strains the rod more than the one that is planned for."""
    model, loads = one_mode(), [{"*.mass": 1.5}]
    plan = screwgen.plan(model, [0.0], [1.0], 1.5, gains=LAW, models=loads, fast=True)
    reached = []
    for mass in (1.0, 1.5):
        run = screwgen.play(model, plan, parameters={"rod.bodies[0].mass": mass}).run
        reached.append(max(float(np.abs(model.numpy().strain(q)).max()) for q in run.q))
    assert reached[1] > 1.05 * reached[0]
    limits = {"strains": {"*": float(np.mean(reached))}}
    with pytest.raises(UsageError, match=r"the limits of strains of models\[0\]: rod"):
        screwgen.plan(model, [0.0], [1.0], 1.5, gains=LAW, models=loads, limits=limits, fast=True)


def test_what_no_polynomial_does_is_refused():
    with pytest.raises(UsageError, match=r"time: is 'shortest', which is sought with limits; plan without fast"):
        screwgen.plan(one_mode(), [0.0], [1.0], "shortest", limits={"efforts": [20.0]}, fast=True)
    with pytest.raises(UsageError, match=r"the fast search brings the arm to no rest in 0\.1 s"):
        screwgen.plan(one_mode(), [0.0], [1.0], 0.1, fast=True)


@pytest.mark.long
def test_fast_plans_of_ella_leave_an_exact_arm_at_rest():
    design, plant, goal = ella(1, 2), ella("exact", 4), [-0.5, 0.7, 0.45]
    found = screwgen.gains(design, [[0.0, 0.0, 0.0], goal])
    law = screwgen.PD(tuple(found.kp), tuple(found.kd), (0.0, 0.0, 0.0))
    nominal = screwgen.plan(design, [0.0] * 3, goal, 1.2, gains=law, fast=True)
    assert screwgen.play(plant, nominal).residual <= 1.5e-4
    payloads = [{"forearm.bodies[0].mass": f} for f in (0.7, 1.3)]
    robust = screwgen.plan(design, [0.0] * 3, goal, 1.2, gains=law, models=payloads, fast=True)
    own = dict(zip(plant.parameter_names, plant.parameter_values, strict=True))["forearm.bodies[0].mass"]
    assert all(
        screwgen.play(plant, robust, parameters={"forearm.bodies[0].mass": f * own}).residual <= 3e-3
        for f in (0.7, 1.3)
    )


def test_steps_that_go_too_far_are_shortened():
    """Three axes at a joint and dry friction behind it: whole steps of the search never ended there."""
    row = {**{factor: next(iter(levels)) for factor, levels in FACTORS.items()}, "turn": "three axes"}
    row |= {"order": "second order", "modes": "frequencies", "damping": "time", "friction": "friction", "more": "frame"}
    planned.plan(case_of(tuple(row.items()), 26))
