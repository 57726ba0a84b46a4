"""Loops beside others, on links that they do not hold, and loops that nothing can open."""

import numpy as np
import pytest
from conformance.numbers import judge
from helpers import arm, link, model_of, quick, quick_batch
from mechanisms import bennett, beside, carried, parallelogram, place
from mixed_arms import case_of

from screwgen import assemble, rollout, simulate
from screwgen.backends.numpy.closing import moving

BOOM = link("boom", 0.5, "z", 2.0, modes={"bending_y": 1, "bending_z": 1}, section={"EIy": 500.0, "EIz": 500.0})


@pytest.mark.parametrize(
    ("robot", "rows"),
    [
        (beside(bennett(), parallelogram()), 7),
        (carried(bennett(), BOOM), 5),
    ],
    ids=["bennett beside a four-bar", "bennett on a boom"],
)
def test_a_linkage_is_overconstrained_whatever_else_moves(robot, rows):
    """What the loops leave free besides must not pass for a motion that does not go on."""
    model = model_of(robot)
    assert model.chain.closing.overconstrained and len(model.chain.closing.rows) == rows
    q = np.zeros(model.nq)
    v = moving(model.numpy(), q, np.arange(1, model.nv + 1) ** 1.5)
    run = simulate(model, 0.3, 1e-3, q0=q, v0=v / np.max(np.abs(v)), backend="casadi")
    assert max(np.max(model.numpy().mismatch(x)) for x in run.q[::50]) < 1e-5


@pytest.mark.parametrize("axes", [[], ["y"]], ids=["weld", "hinge"])
def test_loops_that_no_motion_opens_bear_no_rows(axes):
    """Both ends stand on the world: there is nothing to bear, and parameters alone can open the loop."""
    ends = [place(name, "world", [1.0, 0.0, 0.0], np.zeros(3)) for name in ("a", "b")]
    loop = {"between": ["a.tip", "b.tip"], "joint": {"axes": axes}}
    model = model_of(arm(link("bar", 0.4, "y"), *ends) | {"loops": [loop]})
    assert not model.chain.closing.rows and len(model.chain.closing.idle) == 6 - len(axes)
    quick_batch(model)
    assert not quick(model).loop_mismatch(np.zeros(1)).any()
    off = {"a.joint.mount.xyz[1]": [0.0, 0.1]}
    assert rollout(model, np.zeros((2, 2)), step=1e-3, steps=3, parameters=off).status.tolist() == [0, 3]


@pytest.mark.parametrize("away", [1e-4, 0.05])
def test_assembling_leaves_alone_what_the_loops_leave_free(away):
    """A four-bar on a boom, a little open: the boom stays, and no bar turns by much more than it was off."""
    model = model_of(carried(parallelogram(), BOOM))
    q = np.array([0.3, away, 0.0, 0.0, 0.0, 0.0])
    found = assemble(model, q)
    assert np.max(model.numpy().mismatch(found)) < 1e-12
    assert found[0] == pytest.approx(0.3, abs=1e-12) and np.max(np.abs(found - q)) < 2 * away


def test_a_strip_is_curled_to_a_ring():
    """No search from straight links closes it, and what those cannot change at first, the way to the tip, counts."""
    base = {"mount": {"xyz": [0.5, 0.0, 0.0]}}
    strip = link("strip", modes={"bending_y": 2, "bending_z": 2}, section={"EIz": 0.3}, order="exact", joint=base)
    pin = link("pin", 0.5, [], parent="world")
    robot = arm(strip, pin) | {"loops": [{"between": ["strip.tip", "pin.tip"], "joint": {"axes": ["x", "y", "z"]}}]}
    model = model_of(robot)
    assert [row.text[-1] for row in model.chain.closing.rows] == ["x", "y", "z"]
    q = assemble(model, [0.3, 0.7, 0.1, 0.2, 0.1])
    state = {"q": q, "v": [0.4, 0.5, 0.6, 0.7, 0.8], "tau": [0.2], "w_ext": np.ones((2, 6))}
    judge(case_of(robot, state))
