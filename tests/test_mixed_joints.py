"""Prismatic, helical, cylindrical and mixed joints of robot files against the oracle."""

from functools import cache

import numpy as np
import pytest
from conftest import swept
from helpers import Case, casadi_forward, drawn

from screwgen.spec import coordinate_names
from screwgen.spec.parameters import coordinate_units, force_units


@cache
def mixed(seed: int) -> Case:
    """A random arm, most of whose axes are slides and screws."""
    return drawn(7000 + seed, 1 + seed % 4, sliding=0.7, second_order=0.2)


@pytest.fixture(params=swept(range(24), 0, 1, 2))
def case(request) -> Case:
    return mixed(request.param)


def test_numpy_and_casadi_equal_the_oracle(case):
    numeric = case.model.numpy()
    for vdot, wrench in (numeric.forward_dynamics(*case.inputs), casadi_forward(case.model, *case.inputs)):
        assert max(case.oracle.errors(case.state, vdot, wrench).values()) < case.tolerance


def test_tips_are_where_the_oracle_has_them(case):
    q = case.inputs[0]
    R, point = case.oracle.tip_pose(q)
    found = case.model.casadi()["tip_pose"](q, case.model.parameter_values)
    assert np.allclose(found[0], R, atol=1e-12) and np.allclose(np.ravel(found[1]), np.ravel(point), atol=1e-12)


def test_names_and_units_say_which_axes_slide(case):
    robot = case.model.robot
    names = coordinate_names(robot)
    slides = [not screw.turn for link in robot.links for screw in link.joint.screws]
    m = len(slides)
    assert [".slide[" in x for x in names.q[:m]] == [".slide_rate[" in x for x in names.v[:m]] == slides
    assert [".force[" in x for x in names.tau] == slides == [".joint[" not in x for x in names.q[:m]]
    assert coordinate_units(robot)[:m] == ["m" if s else "rad" for s in slides]
    assert force_units(robot) == ["N" if s else "N·m" for s in slides]
