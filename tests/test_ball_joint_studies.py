"""Studies of robots with ball joints and of floating bases: natural frequencies, linear motion, the analysis."""

import numpy as np
import pytest
import random_robots as rr
import scipy.linalg
from dual_arm import dual_arm
from floating_robots import SATELLITE, rod
from helpers import model_of, quick, relative
from test_ball_joints import PROBE, begun

from screwgen import ScrewgenError, analyse, natural_frequencies
from screwgen.backends.numpy.closing import closed, moving
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.cli.main import main
from screwgen.integrators import METHODS
from screwgen.robot_model import RobotModel
from screwgen.simulation.linearised_loops import LinearisedWithLoops
from screwgen.studies.analysis import spectrum
from screwgen.studies.analysis.analyse import sample_states
from screwgen.studies.convergence import convergence, enriched
from screwgen.studies.light_joints import steps_borne


@pytest.fixture(scope="module", params=[PROBE, SATELLITE], ids=["ball joint", "floating base"])
def model(request):
    return model_of(request.param)


def energy_curvature(model, q: np.ndarray) -> np.ndarray:
    """(nv, nv): the second differences of the energy without gravity along moves, where nothing is stretched."""
    chain, h = model.chain, 1e-4
    numeric = model.numpy(dict.fromkeys(model.parameter_names[:3], 0.0))
    still, units = np.zeros(chain.nv), np.eye(chain.nv)
    at = lambda u: numeric.energy(chain.integrate(q, h * u, SERIES), still)[1]  # noqa: E731
    return np.array([[(at(a + b) - at(a - b) - at(b - a) + at(-a - b)) / (2 * h) ** 2 for a in units] for b in units])


@pytest.mark.parametrize("joints", ["free", "locked"])
def test_natural_frequencies_are_those_of_energies_along_moves(model, joints):
    q = begun(model)[0]
    chain = model.chain
    q[chain.eta_q :] = 0.0
    moving = np.arange(model.nv) if joints == "free" else np.setdiff1d(np.arange(model.nv), chain.held_places)
    M, K = (x[np.ix_(moving, moving)] for x in (model.numpy().mass_matrix(q), energy_curvature(model, q)))
    squares = scipy.linalg.eigh(K, M)[0]
    found = natural_frequencies(model, q, joints)
    assert len(found) == len(moving)
    assert np.allclose((2 * np.pi * found) ** 2, squares, rtol=1e-5, atol=1e-6 * squares.max())


def test_one_more_mode_changes_frequencies_as_in_a_robot_that_has_it():
    model = model_of(PROBE)
    rich = RobotModel(enriched(model.robot))
    change = convergence(model, joints="free").total
    own, more = natural_frequencies(model, joints="free"), natural_frequencies(rich, joints="free")
    first = np.count_nonzero(own == 0)
    assert relative(change, more[first : len(own)] / own[first:] - 1) < 1e-8


def test_the_spectrum_is_that_of_the_linear_model(model):
    q, v = begun(model)
    tau = 0.1 * np.arange(model.n_tau)
    A = spectrum.jacobian(model, q, v, tau)
    assert relative(A, model.linearise(q, v, tau).A) < 1e-12


def test_at_rest_the_analysis_finds_the_natural_frequencies(model):
    q = np.array(model.chain.home)
    (state,) = analyse(model, {"home": {"q": q}}).states
    assert state.system.regular and not state.singular
    found = [x.frequency_hz for x in state.motions if x.frequency_hz]
    expected = natural_frequencies(model, q, "free")
    assert relative(np.sort(found), expected[expected > 0]) < 1e-9
    assert any(x.coordinate.startswith("base.") for x in state.motions)


@pytest.mark.parametrize("method", METHODS)
def test_at_rest_a_step_map_is_the_derivative_of_the_step(model, method):
    q, v = np.array(model.chain.home), np.zeros(model.nv)
    expected = quick(model, derivatives=True).step_derivatives(q, v, None, None, 1e-3, method)[2]
    assert relative(spectrum.step_map(model, method, q, v, 1e-3), expected) < 1e-11


def test_random_states_rest_where_coordinates_do_not_add_up(model):
    found = analyse(model)
    assert len(found.states) == 21 and all(not state.singular for state in found.states)
    assert "WELL POSED" in found.text()


def test_a_floating_base_with_a_loop_is_analysed():
    model = model_of(dual_arm())
    q = closed(model.numpy(), np.array(model.chain.home))
    v = moving(model.numpy(), q, np.where(np.arange(model.nv) < model.chain.eta_v, 0.2, 0.0))
    assert relative(LinearisedWithLoops(model, q, v).jacobian, model.linearise(q, v).A) < 1e-9
    found = analyse(model, sample_states(model, 2))
    assert len(found.states) == 2 and all(not state.singular for state in found.states)


def test_a_state_in_which_they_move_is_refused_in_a_line(model):
    q, v = begun(model)
    with pytest.raises(ScrewgenError, match=r"the free joint of link 'hull' moves in this state.*give states in which"):
        analyse(model, {"turning": {"q": q, "v": v}})


def test_only_axes_are_asked_for_rotors_when_c_is_generated(tmp_path):
    """The command said that there is no limit of steps, after it had written all files."""
    links = [rod("arm", ["y"]), {**rod("fore", []), "joint": {"axes": "ball"}}]
    robot = {"name": "robot", "gravity": [0.0, 0.0, -9.81], "links": links}
    (tmp_path / "robot.toml").write_text(rr.to_toml(robot))
    assert main(["generate", str(tmp_path / "robot.toml"), "--target", "casadi", "-o", str(tmp_path / "out")]) == 0
    assert list(steps_borne(model_of(robot))) == ["arm.joint[0]"]
