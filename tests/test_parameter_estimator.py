"""A filter that finds parameters: a payload that is picked up in motion; its derivatives beside differences."""

from functools import cache

import numpy as np
import pytest
from helpers import arm, example_file, model_of

import screwgen
from screwgen.errors import UsageError
from screwgen.planning.members import Still
from screwgen.runtime.estimator import Noise
from screwgen.simulation.controllers import Holding
from screwgen.simulation.estimator import Estimator
from screwgen.simulation.parameter_estimator import ParameterEstimator, ParameterState

PAYLOAD, STIFFNESS, UPPER = "rod.bodies[0].mass", "rod.EIz", "rod.joint.limits[0].upper"
ENCODER, GAUGE, FIBRE = 1e-4, 1e-6, 0.013
NOISE = Noise(density_v=1e-7, encoder=ENCODER, strain=GAUGE, fibre=FIBRE)


def rod() -> screwgen.Model:
    return model_of(
        arm(
            {
                "name": "rod",
                "length": 1.0,
                "section": {"rhoA": 0.8, "EIz": 60.0},
                "modes": {"bending_y": 1},
                "joint": {"axes": ["z"], "armature": [0.2], "damping": [0.5]},
                "bodies": [{"at": "tip", "mass": 0.5}],
            },
            gravity=[0.0, -9.81, 0.0],
        )
    )


def swung(t, q, v):
    return np.array([9.0 * np.cos(3.0 * t) + 4.0 * np.sin(9.0 * t)])


def picked_up(model, controller, q0, payload, at, until, step):
    """States and inputs of a motion in which the payload is another one from a time on."""
    first = screwgen.simulate(model, at, step, q0=q0, controller=controller)
    later = lambda t, q, v: controller(t + at, q, v)  # noqa: E731
    then = screwgen.simulate(
        model, until - at, step, q0=first.q[-1], v0=first.v[-1], controller=later, parameters=payload
    )
    return (np.vstack([getattr(first, name)[:-1], getattr(then, name)]) for name in ("q", "v", "tau"))


def filtered(filter_, q, v, tau, step, seed=0):
    """The filter fed with noisy encoders and gauges of a motion, sample after sample, from the true start on."""
    model, rng = filter_.model, np.random.default_rng(seed)
    nothing, strains = np.zeros((model.n_links, 6)), model.numpy().strain_slopes() @ q[:, model.n_joints :].T
    bent = strains[[k for k, name in enumerate(model.strain_names) if ".base_strain.bending" in name]].T
    filter_.start(q[0], v[0], ENCODER, 1e-3, NOISE)
    for k in range(1, len(q)):
        filter_.predict(tau[k - 1], nothing, step)
        encoder = q[k, : model.n_joints] + ENCODER * rng.standard_normal(model.n_joints)
        strain = -FIBRE * bent[k] + GAUGE * rng.standard_normal(bent.shape[1])
        filter_.update(tau[k], nothing, encoder=encoder, strain=strain)
        yield k


def tip_error(model, filter_, q) -> float:
    return float(np.linalg.norm(np.subtract(*(model.numpy().tip_pose(x)[1] for x in (filter_.state[0], q)))))


def test_a_payload_that_is_picked_up_is_found_in_a_second_and_a_plain_filter_says_that_it_is_wrong():
    model, step = rod(), 4e-3
    q, v, tau = picked_up(model, swung, [-1.5, 0.0], {PAYLOAD: 0.9}, 0.4, 1.4, step)
    found = ParameterEstimator(model, [ParameterState(PAYLOAD, 0.02, 0.02)], measurements=["encoder", "strain"])
    sizes = [found.consistency.squared / 2 for _ in filtered(found, q, v, tau, step)]
    assert found.values[PAYLOAD] == pytest.approx(0.9, rel=0.01)
    assert tip_error(model, found, q[-1]) < 0.4e-3
    plain = Estimator(model, measurements=["encoder", "strain"])
    others = [plain.consistency.squared / 2 for _ in filtered(plain, q, v, tau, step)]
    assert np.mean(sizes[:98]) < 1.5 and np.mean(sizes[-125:]) < 1.5
    assert np.mean(others[:98]) < 1.5 and np.mean(others[-125:]) > 10.0


@cache
def ella_picks_up():
    """ELLA, states and inputs of a second after it picks up 1 kg, 0.2 s after the start; and what a filter seeks.

    Its loop is nearly undamped at this step, so it also vibrates.
    """
    model, step = screwgen.derive(screwgen.load(example_file("ella"))), 2e-3
    payload, start = "forearm.bodies[0].mass", np.array([0.2, -0.3, 0.8])
    rest, p = Still(model, np.array(model.parameter_values)).held(start).q, model.chain.parameters.values
    law = screwgen.PD(
        (400.0, 400.0, 120.0), (1.0, 0.9, 0.35), (0.9, 0.3, 1.4), duration=2.0, q_start=tuple(start)
    ).through(model.chain, p)
    weight = Holding(model)
    hold = lambda t, q, v: law(t, q, v) + weight(q[:3])  # noqa: E731
    run = tuple(picked_up(model, hold, rest, {payload: 3.1}, 0.2, 1.2, step))
    return model, run, ParameterState(payload, 0.02, 0.03)


def test_ella_finds_its_payload_in_a_second():
    """1 kg more, within 1 % and 0.4 mm at the tip."""
    model, (q, v, tau), state = ella_picks_up()
    found, payload = ParameterEstimator(model, [state], measurements=["encoder", "strain"]), state.parameter
    for _ in filtered(found, q, v, tau, 2e-3):
        pass
    assert found.values[payload] == pytest.approx(3.1, rel=0.01) and found.deviations[payload] < 0.01 * 3.1
    assert tip_error(model, found, q[-1]) < 0.4e-3


def test_deviations_say_how_far_off_the_numbers_are():
    """A mass and a stiffness that start 10 % off, in runs with other noise: normalised errors are of size one."""
    model, step, errors = rod(), 4e-3, []
    run = screwgen.simulate(model, 0.6, step, q0=[-1.5, 0.0], controller=swung)
    for seed in range(6):
        start = 1.0 + 0.1 * np.random.default_rng(100 + seed).standard_normal(2)
        names = {PAYLOAD: 0.5, STIFFNESS: 60.0}
        off = {name: x * s for (name, x), s in zip(names.items(), start, strict=True)}
        states = [ParameterState(name, 0.1 * x) for name, x in names.items()]
        found = ParameterEstimator(model, states, off, ["encoder", "strain"])
        for _ in filtered(found, run.q, run.v, run.tau, step, seed):
            pass
        errors.append([(found.values[n] - x) / found.deviations[n] for n, x in names.items()])
    assert 0.5 < np.sqrt(np.mean(np.square(errors))) < 1.5
    assert all(found.deviations[name] < 0.02 * x for name, x in names.items())


@pytest.mark.parametrize("said", ["encoder", "strain", "acceleration", "marker_attitude@rod.tip", "gyro@rod.tip"])
def test_what_is_expected_changes_with_parameters_as_differences_say(said):
    model, name, size = rod(), "rod.length", 1e-6
    q, v, tau, w_ext = np.array([0.4, 0.01]), np.array([0.7, 0.2]), np.array([3.0]), np.zeros((1, 6))
    states = [ParameterState(name, 0.1), ParameterState(STIFFNESS, 1.0)]

    def rest(change: float):
        found = ParameterEstimator(model, states, {name: 1.0 + change}, [said])
        found.start(q, v, 1e-3, 1e-3, Noise(1e-3, fibre=FIBRE) if said == "strain" else Noise(1e-3))
        (row,) = found.measurements
        measured = np.array([0.8, 0.1, -0.2, 0.5]) if "attitude" in said else np.zeros(row.n_values(model.chain))
        return found.compared(row, measured, tau, w_ext)

    slope = -(rest(size).rest - rest(-size).rest) / (2 * size)
    H = rest(0.0).H[:, model.chain.n_changes]
    assert pytest.approx(slope, abs=1e-6 * max(1.0, np.abs(slope).max())) == H


def test_a_step_carries_what_is_not_known_of_parameters_as_steps_with_other_parameters_say():
    """Of a short step, whose linear rule differs from the derivative of the step in the third order."""
    model, h, size = rod(), 1e-4, 1e-4
    found = ParameterEstimator(model, [ParameterState(PAYLOAD, 1.0)], measurements=["encoder"])
    q, v, tau = np.array([0.4, 0.01]), np.array([0.7, 0.2]), np.array([3.0])
    found.start(q, v, 0.0, 0.0, Noise(0.0, encoder=1e-4))
    found.predict(tau, np.zeros((1, 6)), h)
    column = found.covariance[:-1, -1]
    runs = [screwgen.simulate(model, h, h, q, v, tau, parameters={PAYLOAD: 0.5 + s}) for s in (size, -size)]
    after = [np.hstack([run.q[-1], run.v[-1]]) for run in runs]
    assert column == pytest.approx((after[0] - after[1]) / (2 * size), rel=1e-3, abs=1e-9)


def test_values_stay_within_their_bounds():
    model, step = rod(), 2e-3
    q, v, tau = picked_up(model, swung, [-1.5, 0.0], {PAYLOAD: 0.9}, 0.1, 0.5, step)
    states = [ParameterState(PAYLOAD, 0.02, 0.02, lower=0.4, upper=0.6)]
    found = ParameterEstimator(model, states, measurements=["encoder", "strain"])
    values = [found.values[PAYLOAD] for _ in filtered(found, q, v, tau, step)]
    assert max(values) == 0.6 and min(values) >= 0.4


WRONG = {
    "there is no 'rod.mass'": [ParameterState("rod.mass", 0.1)],
    "each parameter must be named once": [ParameterState(PAYLOAD, 0.1)] * 2,
    "and one at least": [],
    "are not within their bounds": [ParameterState(PAYLOAD, 0.1, lower=0.6)],
}


@pytest.mark.parametrize("words", WRONG)
def test_states_that_make_no_sense_get_a_line(words):
    with pytest.raises(UsageError, match=words):
        ParameterEstimator(rod(), WRONG[words])


def test_numbers_of_states_that_make_no_sense_get_a_line():
    with pytest.raises(UsageError, match=r"deviation is -1\.0; it must be a number >= 0"):
        ParameterState(PAYLOAD, -1.0)
    with pytest.raises(UsageError, match="it must be less than upper"):
        ParameterState(PAYLOAD, 1.0, lower=2.0, upper=1.0)


def test_numbers_that_decide_what_a_step_holds_are_refused():
    """A limit of an effort acts before the dynamics, whose derivative by it would be 0; a stop acts in them."""
    limits = {"effort": 3.0, "upper": 1.0, "stiffness": 100.0, "damping": 1.0}
    link = {"name": "rod", "length": 0.5, "bodies": [{"at": "tip", "mass": 1.0}]}
    model = model_of(arm(link | {"joint": {"axes": ["z"], "limits": [limits]}}))
    with pytest.raises(UsageError, match=r"a filter does not find rod\.joint\.limits\[0\]\.effort: it decides what"):
        ParameterEstimator(model, [ParameterState("rod.joint.limits[0].effort", 0.1)])
    found = ParameterEstimator(model, [ParameterState("rod.joint.limits[0].upper", 0.1)], measurements=["encoder"])
    q, still, nothing = np.array([1.1]), np.zeros(1), np.zeros((1, 6))
    slope = found._accelerations_by_p(q, still, still, nothing)
    low, high = (
        model.numpy(model.chain.parameters.vector({"rod.joint.limits[0].upper": x})).forward_dynamics(
            q, still, still, nothing
        )[0]
        for x in (1.0 - 1e-6, 1.0 + 1e-6)
    )
    assert slope[:, 0] == pytest.approx((high - low) / 2e-6, rel=1e-6) and slope[0, 0] > 1.0


def stopped() -> screwgen.Model:
    """A rod at a stop, whose range is narrow."""
    limits = {"lower": 0.9, "upper": 1.0, "stiffness": 100.0, "damping": 1.0}
    link = {"name": "rod", "length": 0.5, "bodies": [{"at": "tip", "mass": 1.0}]}
    return model_of(arm(link | {"joint": {"axes": ["z"], "limits": [limits]}}))


def test_an_update_whose_parameters_no_robot_has_changes_nothing():
    """A hard push back from the stop says that it begins below the other one."""
    found = ParameterEstimator(stopped(), [ParameterState(UPPER, 0.1)], measurements=["acceleration"])
    found.start([1.1], [0.0], 1e-3, 1e-3, Noise(1e-3, acceleration=1e-3))
    before = [*found.state, found.covariance, found.values]
    with pytest.raises(UsageError, match="must be less than rod"):
        found.update([0.0], np.zeros((1, 6)), acceleration=[0.0, -80.0, 9.81])
    assert np.array_equal(np.hstack(found.state), np.hstack(before[:2])) and found.values == before[3]
    assert np.array_equal(found.covariance, before[2])
    found.update([0.0], np.zeros((1, 6)), acceleration=[0.0, -22.0, 9.81])
    assert found.values[UPPER] < before[3][UPPER]


def test_a_filter_that_was_not_started_is_at_home_and_knows_its_parameters_as_stated():
    found = ParameterEstimator(rod(), [ParameterState(PAYLOAD, 0.2)])
    found.predict([1.0], None, 1e-3)
    assert found.deviations[PAYLOAD] == pytest.approx(0.2) and found.values[PAYLOAD] == 0.5
