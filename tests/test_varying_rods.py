"""Rods whose sections vary along the link: against the oracle, and against uniform rods."""

from functools import cache

import judges
import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from helpers import Case, case_of, disagreement, drawn, flat, model_of, quick, relative
from oracle import Oracle
from oracle_robots import beam
from varying_robots import tapered_arm

from screwgen.algorithms import schedule
from screwgen.studies.modes import natural_frequencies

SEEDS = range(700, 716)
SHORT = (700, 703, 705, 706, 708, 709, 713)
"""One to four links, both kinds of sections, and two robots with up to five modes per direction."""
EQUAL = {"rhoA": 1.3, "EA": 4e3, "EIy": 30.0, "EIz": 50.0, "GJ": 7.0, "rhoIp": 2e-3}


def rod(*args, **more) -> dict:
    return beam(*args, **more) | {"name": "rod", "gravity": [0.0, 0.0, -9.81]}


@cache
def varied(seed: int) -> Case:
    """A random robot, most links with stations; one in four has up to five modes per direction."""
    return drawn(seed, 1 + seed % 4, stations=0.75, rigid=0.1, max_modes=5 if seed % 4 == 0 else 2)


every = pytest.mark.parametrize("seed", swept(SEEDS, *SHORT))


def test_most_robots_vary_and_have_coupled_modes():
    models = [varied(seed).model for seed in SEEDS]
    assert sum(bool(m.chain.coupled) for m in models) > 11
    assert {key.between for m in models for key in m.chain.keys if key.stations} == {"linear", "polynomial"}


@every
def test_numpy_in_both_forms(seed):
    judges.numpy_forms(varied(seed))


@every
def test_inverse_dynamics_mass_matrix_and_energy(seed):
    case = varied(seed)
    (q, v, _, w_ext), numeric, rng = case.inputs, case.model.numpy(), np.random.default_rng(seed)
    vdot = rng.uniform(-1, 1, len(q))
    assert (
        relative(numeric.inverse_dynamics(q, v, vdot, w_ext), case.oracle.inverse_dynamics(q, v, vdot, w_ext)) < 1e-11
    )
    assert relative(numeric.mass_matrix(q), case.oracle.mass_matrix(q)) < 1e-12
    functions, p = case.model.casadi(), case.model.parameter_values
    assert relative(functions["mass_matrix"](q, p).full(), case.oracle.mass_matrix(q)) < 1e-12
    assert np.allclose(numeric.energy(q, v), case.oracle.energy(q, v), rtol=1e-12)


@pytest.mark.parametrize("basis", ["polynomial", "clamped_free"])
@pytest.mark.parametrize("section", [
    [{"at": 0.0, **EQUAL}, {"at": 1.0, **EQUAL}],
    [{"at": 0.0, **EQUAL}, {"at": 0.4, **EQUAL}, {"at": 0.4, **EQUAL}, {"at": 1.0, **EQUAL}],
    {"stations": [{"at": s, **EQUAL} for s in (0.0, 0.3, 1.0)], "between": "polynomial"},
])  # fmt: skip
def test_equal_stations_are_a_uniform_rod(basis, section):
    modes = {"basis": basis, "axial": 2, "bending_y": 3, "bending_z": 2, "torsion": 2}
    more = {"damping": {"ratio": 0.02}, "frame_at": 0.3, "modes": modes}
    tip = {"mass": 0.6, "com": [0.0, 0.1, 0.05]}
    uniform, stated = (rod(["z", "y"], tip, section=s, **more) for s in (EQUAL, section))
    rng = np.random.default_rng(3)
    state = {
        "q": rng.uniform(-0.1, 0.1, 11),
        "v": rng.uniform(-1, 1, 11),
        "tau": [1.0, 2.0],
        "w_ext": [[1, 2, 3, 4, 5, 6]],
    }
    first, second = case_of(uniform, state), case_of(stated, state)
    expected, found = (case.model.numpy().forward_dynamics(*case.inputs) for case in (first, second))
    bound = max(1e-13, 50 * np.finfo(float).eps * first.oracle.condition(state["q"]))
    assert disagreement(first.oracle, expected, found) < bound
    M, N = (case.model.numpy().mass_matrix(state["q"]) for case in (first, second))
    assert relative(N, M) < 1e-13
    for name in ("M_eta", "K", "D"):
        a, b = (case.model.numpy().constants[0][name] for case in (first, second))
        assert np.allclose(a, b, rtol=1e-13, atol=0)
    known = natural_frequencies(first.model)
    assert np.allclose(natural_frequencies(second.model), known, rtol=1e-12)


def test_station_values_are_parameters():
    """A parameter vector gives what a file with these numbers gives, in NumPy, CasADi and C."""
    section = [{"at": 0.0, **EQUAL}, {"at": 0.5, **EQUAL}, {"at": 1.0, **EQUAL}]
    thin = [section[0], *({"at": s["at"], **{key: 0.6 * EQUAL[key] for key in EQUAL}} for s in section[1:])]
    modes = {"bending_y": 3, "bending_z": 2, "axial": 1, "torsion": 1}
    given, wanted = (model_of(rod(["z"], section=s, modes=modes)) for s in (section, thin))
    assert given.parameter_names == wanted.parameter_names
    assert "beam.section[2].EIz" in given.parameter_names and "beam.rhoA" not in given.parameter_names
    rng, p = np.random.default_rng(5), wanted.parameter_values
    q, v = rng.uniform(-0.05, 0.05, (2, 8))
    state = (q, v, np.array([0.3]), np.ones((1, 6)))
    expected = wanted.numpy().forward_dynamics(*state)[0]
    assert np.array_equal(given.numpy(p).forward_dynamics(*state)[0], expected)
    found = given.casadi()["forward_dynamics"](q, v, state[2], state[3].T, p)[0]
    assert relative(flat(found), expected) < 1e-12
    compiled = quick(given)
    compiled.prepare(p)
    assert relative(compiled.forward_dynamics(*state)[0], expected) < 1e-12


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
