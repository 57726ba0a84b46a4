"""Rods whose sections vary along the link: against the oracle, and against uniform rods."""

import numpy as np
import pytest
import random_robots as rr
from helpers import case_of, model_of
from oracle import Oracle
from oracle_robots import beam
from varying_robots import tapered_arm

from screwgen.algorithms import schedule
from screwgen.studies.modes import natural_frequencies

EQUAL = {"rhoA": 1.3, "EA": 4e3, "EIy": 30.0, "EIz": 50.0, "GJ": 7.0, "rhoIp": 2e-3}


def rod(*args, **more) -> dict:
    return beam(*args, **more) | {"name": "rod", "gravity": [0.0, 0.0, -9.81]}


@pytest.mark.parametrize("joints", ["locked", "free"])
def test_frequencies_are_the_oracles(joints):
    robot = tapered_arm()
    model = model_of(robot)
    q = np.append([0.3, -0.4, 0.2, 0.5], np.zeros(model.nq - 4))
    found, expected = natural_frequencies(model, q, joints), Oracle(robot).frequencies(q, joints)
    moving = expected > 1e-3
    assert np.allclose(found[moving], expected[moving], rtol=1e-9)


@pytest.mark.parametrize("way", schedule.WAYS)
@pytest.mark.parametrize("counts", [(1, 1, 1, 0), (2, 2, 2, 1), (3, 4, 4, 3)])
def test_both_ways_to_eliminate_coupled_modes(monkeypatch, counts, way):
    """The r x r factor and the modes' compliance."""
    thin = {key: 0.6 * EQUAL[key] for key in EQUAL}
    modes = dict(zip(("axial", "bending_y", "bending_z", "torsion"), counts, strict=True))
    section = [{"at": 0.0, **EQUAL}, {"at": 1.0, **thin}]
    robot = rod(["z", "y"], {"mass": 0.6, "com": [0.0, 0.1, 0.05]}, modes=modes, section=section)
    case = case_of(robot, rr.random_state(np.random.default_rng(4), robot))
    for name, value in (("WAYS", (way,)), ("FEW", 0), ("MANY", 99)):
        monkeypatch.setattr(schedule, name, value)
    schedule.trace.cache_clear()
    try:
        found = case.model.numpy().forward_dynamics(*case.inputs)
    finally:
        schedule.trace.cache_clear()
    assert max(case.oracle.errors(case.state, *found).values()) < case.tolerance
