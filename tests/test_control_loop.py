"""Loops of control that are unstable at the step of a run are named, with the step, gain or rotor that would do."""

import warnings

import control_loops as loops
import numpy as np
import pytest

from screwgen.simulation.control_loop import ControlLoopWarning
from screwgen.simulation.validity import ModelValidityWarning


@pytest.mark.parametrize("name", loops.UNSTABLE)
def test_an_unstable_loop_is_named_with_its_longest_step(name):
    """Within a factor of 1.5 of the limit that runs have: they are stable below it, and grow above."""
    case, model = loops.UNSTABLE[name], loops.model_of_case(name)
    (line,) = loops.said(lambda: loops.moved(model, case, case.step))
    assert "\n" not in line and "unstable at a step of" in line
    named = loops.named_step(line)
    assert not loops.grows(model, case, named / 1.5) and loops.grows(model, case, 1.5 * named)


@pytest.mark.parametrize("name", loops.STABLE)
def test_nothing_is_said_of_a_stable_loop_whose_links_bend_far(name):
    case, model = loops.STABLE[name], loops.model_of_case(name)
    with warnings.catch_warnings(record=True, action="always") as noted:
        run = loops.swung(model, case)
    assert not [w for w in noted if issubclass(w.category, ControlLoopWarning)]
    assert not run.validity.holds and [w for w in noted if issubclass(w.category, ModelValidityWarning)]
    assert np.isfinite(run.q).all()
