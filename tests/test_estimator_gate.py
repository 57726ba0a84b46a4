"""What filters refuse and say: false samples behind a gate, innovations, arguments, covariances that are none."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from floating_robots import rod
from helpers import QUICK, arm, link, model_of
from sensors import measured
from test_estimator import SOFT, TIP

from screwgen import ScrewgenError, SingularError, UsageError
from screwgen.algorithms.gauges import gauges
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.estimator import Estimator
from screwgen.simulation.integrate import JointStepper

BEAM = arm(link("a", axes="z", modes={"bending_y": 1, "bending_z": 1}, section=SOFT, bodies=TIP))
PULLED = arm(link("rod", axes="z", modes={"bending_y": 1, "bending_z": 1}, section=SOFT))
PULLED["links"][0]["tendons"] = [{"name": "left", "at": [[0.0, 0.01, 0.0], [0.0, 0.01, 0.0]]}]
NOISE = Noise([2.0, 0.1, 0.1], 1e-12, 1e-4, 2e-6, 0.2, 0.02)
SPREAD, REST, STEP = np.array([1e-2, 1e-3, 1e-3]), np.zeros((1, 6)), 1e-3
FILTERS = [CompiledEstimator, Estimator]


@cache
def model(pulled=False):
    return model_of(PULLED if pulled else BEAM)


def begun(kind, noise=NOISE, pulled=False):
    e = kind(model(pulled), flags=QUICK) if kind is CompiledEstimator else kind(model(pulled))
    e.start(np.zeros(3), np.zeros(3), SPREAD, 10 * SPREAD, noise)
    return e


@cache
def samples(count=75):
    """Torques and measurements of a beam that unknown forces push."""
    robot, rng, rows = model(), np.random.default_rng(1), []
    stepper, q, v = JointStepper(robot, "modal_midpoint", robot.parameter_values), np.zeros(3), np.zeros(3)
    for _ in range(count):
        tau = np.array([-q[0] - 0.05 * v[0]]) + rng.normal(size=1)
        q, v = stepper.step(stepper.initial(q, v), tau, REST, STEP)
        v = v + np.sqrt(STEP * np.array(NOISE.density_v)) * rng.normal(size=3)
        rows.append((tau, measured(robot, q, v, tau, REST, rng, NOISE)))
    return rows


def estimates(kind, noise, first=0, length=0, name="encoder", entry=0, added=0.0) -> tuple[np.ndarray, np.ndarray]:
    """The states after each sample, of which a burst is falsified, and their deviations."""
    e, states, sizes = begun(kind, noise), [], []
    for k, (tau, exact) in enumerate(samples()):
        z = {key: value.copy() for key, value in exact.items()}
        z[name][entry] += added if first <= k < first + length else 0.0
        e.predict(tau, REST, STEP)
        e.update(tau, REST, **z)
        states, sizes = [*states, np.concatenate(e.state)], [*sizes, np.sqrt(np.diag(e.covariance))]
    return np.array(states), np.array(sizes)


# ------------------------------------------------------------------------------ a gate


ENTRIES = [("encoder", 0), ("strain", 0), ("strain", 1), ("acceleration", 0), ("acceleration", 2)]


@pytest.mark.parametrize(
    ("kind", "name", "entry"), [*((CompiledEstimator, *x) for x in ENTRIES), (Estimator, "strain", 1)]
)
def test_false_samples_are_as_samples_that_are_missing(kind, name, entry):
    """Every size that the estimate excludes, bursts of 1, 3 and 10; without a gate the worst of them leads far away."""
    noise, unit = replace(NOISE, gate=5.0), getattr(NOISE, name)
    for length in (1, 3, 10) if kind is CompiledEstimator else (3,):
        missing, _ = estimates(kind, noise, 40, length, name, entry, np.nan)
        for size in (1e3, -1e4, 1e6, 1e9, 1e300) if kind is CompiledEstimator else (1e3, 1e9):
            found, _ = estimates(kind, noise, 40, length, name, entry, size * unit)
            assert np.array_equal(found, missing)
    ungated, deviation = estimates(kind, NOISE, 40, 3, name, entry, 1e3 * unit)
    assert np.max(np.abs(ungated - missing)[42] / deviation[42]) > 30


@pytest.mark.parametrize(("name", "entry"), ENTRIES)
def test_samples_near_the_gate_are_forgotten_within_the_patience(name, entry):
    """Sizes about the gate may pass it; then what follows may be refused, but never longer than is stated."""
    noise, unit = replace(NOISE, gate=5.0, patience=12), getattr(NOISE, name)
    for length in (1, 3, 10):
        undisturbed, deviation = estimates(CompiledEstimator, noise)
        ungated, _ = estimates(CompiledEstimator, NOISE, 30, length, name, entry, 10 * unit)
        for size in (1.0, 3.0, 10.0, 30.0, 100.0):
            gated, _ = estimates(CompiledEstimator, noise, 30, length, name, entry, size * unit)
            off = [x - undisturbed for x in (ungated, gated)]
            back = [int(np.flatnonzero(np.max(np.abs(x) / deviation, axis=1) > 0.5).max(initial=30)) for x in off]
            assert back[1] <= max(back[0], 30 + length) + 12


@pytest.mark.parametrize("kind", FILTERS)
@pytest.mark.parametrize("within", [1, 3, 30])
def test_a_measurement_that_stays_beyond_the_gate_is_taken_again(kind, within):
    """A slip by 0.3 rad is refused as often as stated, or as the encoder was within the gate since a refusal before."""
    e, patience = begun(kind, replace(NOISE, gate=5.0, patience=7)), min(within, 7)
    for k in range(31 + within):
        e.predict([0.0], REST, STEP)
        e.update([0.0], REST, [50.0 * (k == 30)])
    refused = []
    for _ in range(250):
        e.predict([0.0], REST, STEP)
        e.update([0.0], REST, [0.3])
        refused.append(bool(e.innovations["encoder"].refused[0]))
    assert refused[: patience + 1] == [True] * patience + [False] and not any(refused[patience:])
    assert abs(e.state[0][0] - 0.3) < 1e-6 and abs(e.state[0][1]) < 1e-5


@pytest.mark.parametrize("kind", FILTERS)
def test_a_patience_that_becomes_less_leaves_the_gate_there(kind):
    """22 samples of a slip and 3 right ones, then 5 in place of 20: a sample that is 9 rad off is refused."""
    e, noise = begun(kind, replace(NOISE, gate=5.0)), replace(NOISE, gate=5.0, patience=5)
    for z in [0.3] * 22 + [e.state[0][0]] * 3:
        e.update([0.0], REST, [z])
    before = e.state
    e.set(noise)
    e.update([0.0], REST, [9.0])
    assert e.innovations["encoder"].refused.all() and np.array_equal(e.state[0], before[0])


def test_the_gate_of_a_sensor_alone_bounds_its_doubt():
    for kind in FILTERS:
        more = {"flags": QUICK} if kind is CompiledEstimator else {}
        e = kind(model(), measurements=["encoder gated"], **more)
        e.start(np.zeros(3), np.zeros(3), SPREAD, SPREAD, Noise(0.0, encoder=1e-3, encoder_gate=5.0, doubt=3.0))
        e.update([0.0], REST, [4.0 * np.hypot(SPREAD[0], 1e-3)])
        assert e.innovations["encoder"].weight[0] == pytest.approx(9 / 16)
        with pytest.raises(UsageError, match=r"^doubt: must be a number from 0 to the gate"):
            e.set(Noise(0.0, encoder=1e-3, encoder_gate=2.0, doubt=3.0))


@pytest.mark.parametrize("names", [("encoder",), ("encoder", "strain", "acceleration")], ids=len)
def test_an_estimate_that_is_wrong_and_sure_of_it_comes_back(names):
    """The joint is 0.3 rad off and turns at 3 rad/s; both filters are sure to 0.1 mrad that it rests."""
    filters, rng, robot, still = list(map(begun, FILTERS)), np.random.default_rng(3), model(), (np.zeros(1), REST)
    noise = replace(NOISE, gate=5.0, density_v=np.array([2e-3, 1e-4, 1e-4]))
    for e in filters:
        e.start(np.zeros(3), np.zeros(3), SPREAD / 100, SPREAD / 10, noise)
    stepper, q, v = JointStepper(robot, "modal_midpoint", robot.parameter_values), [0.3, 0, 0], [3.0, 0, 0]
    for _ in range(250):
        q, v = stepper.step(stepper.initial(np.array(q), np.array(v)), *still, STEP)
        z = measured(robot, q, v, *still, rng, NOISE)
        for e in filters:
            e.predict(*still, STEP)
            e.update(*still, **{name: z[name] for name in names})
    (found, P), (other, _) = ((np.concatenate(e.state), e.covariance) for e in filters)
    assert np.all(np.abs(found - np.concatenate([q, v])) < 4 * np.sqrt(np.diag(P)))
    assert np.allclose(found, other, rtol=0, atol=1e-8)


def test_an_attitude_is_refused_as_a_whole():
    ball = model_of({"name": "arm", "gravity": [0.0, 0.0, 0.0], "links": [rod("a", "ball")]})
    still = np.zeros(ball.n_tau), REST
    turned = [np.cos(0.3), np.sin(0.3), 0.0, 0.0]
    for e in (CompiledEstimator(ball, flags=QUICK), Estimator(ball)):
        e.start(ball.chain.home, np.zeros(ball.nv), 1e-2, 1e-2, Noise(0.0, joint_attitude=1e-3, gate=4.0))
        e.update(*still, joint_attitude=turned)
        found = e.innovations["joint_attitude"]
        assert np.allclose(found.value, [2 * np.sin(0.3), 0, 0]) and found.refused.all()
        assert np.array_equal(e.state[0], ball.chain.home)


@pytest.mark.parametrize("kind", FILTERS)
@pytest.mark.parametrize(("off", "weight"), [(1.9, 1.0), (4.0, 0.25), (-4.9, (2 / 4.9) ** 2), (5.1, 0.0)])
def test_what_is_doubted_counts_as_the_textbook_says(kind, off, weight):
    """A variance of the innovation that is larger by 1 / weight: mean and covariance by Kalman's formulas."""
    e = begun(kind, replace(NOISE, gate=5.0, doubt=2.0))
    e.predict([0.3], REST, STEP)
    x, P = np.concatenate(e.state), e.covariance
    s, gain = P[0, 0] + 1e-8, weight / (P[0, 0] + 1e-8) * P[:, 0]
    e.update([0.3], REST, [x[0] + off * np.sqrt(s)])
    assert e.innovations["encoder"].weight == pytest.approx([weight])
    assert np.concatenate(e.state) == pytest.approx(x + gain * off * np.sqrt(s), rel=1e-9, abs=1e-15)
    left = (e.covariance - P + np.outer(gain, P[0])) / np.sqrt(np.outer(np.diag(P), np.diag(P)))
    assert np.max(np.abs(left)) < 1e-12


# ------------------------------------------------------------------------------ innovations


def test_innovations_are_the_textbooks():
    """Of both filters: z - H x over sqrt(H P H^T + R) with rows by hand; NaN where nothing was measured."""
    for e in map(begun, FILTERS):
        e.predict([0.3], REST, STEP)
        (q, _), P = e.state, e.covariance
        e.update([0.3], REST, [0.02], [np.nan, 3e-5])
        assert e.innovations["encoder"].value == pytest.approx([0.02 - q[0]])
        assert e.innovations["encoder"].normalised == pytest.approx([(0.02 - q[0]) / np.sqrt(P[0, 0] + 1e-8)])
        row = np.array(gauges(model().chain)[1].curvatures) * -NOISE.fibre / model().robot.links[0].length ** 2
        rest = 3e-5 - row[0] * q[2]
        assert e.innovations["strain"].value == pytest.approx([np.nan, rest], nan_ok=True)
        size = rest / np.sqrt(row[0] ** 2 * P[2, 2] + 4e-12)
        assert e.innovations["strain"].normalised == pytest.approx([np.nan, size], nan_ok=True)
        assert np.isnan(e.innovations["acceleration"].normalised).all() and not e.innovations["encoder"].refused.any()


@pytest.mark.parametrize("kind", FILTERS)
def test_a_payload_that_nobody_told_is_seen(kind):
    """The accelerometer at the tip of a pendulum with 100 kg more than its model has, under the same torque."""
    light, heavy = (model_of(arm(link("a", axes="z", bodies=[{**TIP[0], "mass": m}]))) for m in (1.0, 101.0))
    vdot = [x.numpy().forward_dynamics([0.0], [0.0], [20.0], REST)[0][0] for x in (light, heavy)]
    e = kind(light, flags=QUICK) if kind is CompiledEstimator else kind(light)
    e.start([0.0], [0.0], 1e-4, 1e-3, Noise(1e-4, encoder=1e-5))
    worst = []
    for k in range(1, 51):
        e.predict([20.0], REST, STEP)
        e.update([20.0], REST, [vdot[1] * (k * STEP) ** 2 / 2])
        worst.append(abs(e.innovations["encoder"].normalised[0]))
    assert vdot[0] > 10 * vdot[1] and max(worst) > 20


# ------------------------------------------------------------------------------ tensions


def test_both_filters_take_tensions():
    """A tendon pulls 40 N: the mean is that of a step of the model, and both filters agree."""
    robot, tau = model(pulled=True), [0.1, 40.0]
    stepper = JointStepper(robot, "modal_midpoint", robot.parameter_values)
    state = stepper.initial(np.zeros(3), np.zeros(3))
    filters = [begun(kind, pulled=True) for kind in FILTERS]
    for _ in range(5):
        state = stepper.step(state, tau, REST, STEP)
        for e in filters:
            e.predict(tau, REST, STEP)
            e.update(tau, REST)
    slack = begun(CompiledEstimator, pulled=True)
    slack.predict([0.1, 0.0], REST, STEP)
    for e in filters:
        assert np.allclose(e.state[0], state.q, rtol=1e-10, atol=1e-15)
        with pytest.raises(UsageError, match=r"^tau has 1 numbers; it must have 2$"):
            e.predict([0.1], REST, STEP)
    assert np.max(np.abs(state.q[1:])) > 1e-6


# ------------------------------------------------------------------------------ what is no argument


NO_NOISE = [
    ({"fibre": 0.0}, "fibre: is 0 of a gauge whose strain is measured; state its distance from the centreline, m"),
    ({"fibre": [0.02, 0.0]}, "fibre: is 0 of a gauge whose strain is measured"),
    ({"fibre": [0.02] * 3}, "fibre: must be a finite number, or 2 of them"),
    ({"fibre": np.nan}, "fibre: must be a finite number, or 2 of them"),
    ({"fibre": "wide"}, "fibre: must be a finite number, or 2 of them"),
    ({"strain": np.nan}, "strain: must be a number >= 0, or 2 of them"),
    ({"gate": -1.0}, "gate: must be a finite number >= 0, of standard deviations"),
    ({"gate": np.nan}, "gate: must be a finite number"),
    ({"doubt": 2.0}, "doubt: must be a number from 0 to the gate, of standard deviations"),
    ({"gate": 5.0, "doubt": np.nan}, "doubt: must be a number from 0 to the gate"),
    ({"patience": 0}, "patience is 0; it must be a whole number from 1"),
]
NO_CALL = [
    (lambda e: e.predict([np.inf], REST, STEP), UsageError, "tau holds a number that is not finite"),
    (lambda e: e.predict([0.0], REST, 0.0), UsageError, "the step is 0 s; it must be a finite number > 0"),
    (lambda e: e.update([0.0], REST, [np.inf]), UsageError, "encoder is not finite; give NaN for what was not"),
    (lambda e: e.start(np.zeros(2), np.zeros(3), 1, 1, NOISE), UsageError, "q has 2 numbers; it must have 3"),
    (lambda e: e.start(np.zeros(3), np.zeros(3), [1, 2], 1, NOISE), UsageError, "deviation_q: must be a number >= 0"),
    (lambda e: e.put(np.zeros(2), np.zeros(3), np.eye(6)), UsageError, "q has 2 numbers; it must have 3"),
    (lambda e: e.put(np.zeros(3), np.zeros(3), np.eye(3)), UsageError, "P has 9 numbers; it must have 36"),
    (lambda e: (e.set(Noise(0.0)), e.update([0.0], REST, [1.0])), UsageError, "noise: encoder has no standard deviat"),
    (
        lambda e: (e.put(np.zeros(3), np.zeros(3), np.diag([1.0, -1, 1, 1, 1, 1])), e.predict([0.0], REST, STEP)),
        SingularError,
        "the filter's covariance has lost its definiteness",
    ),
    (
        lambda e: (e.put(np.zeros(3), np.zeros(3), np.eye(6) + 2 * np.eye(6)[::-1]), e.update([0.0], REST, [0.1])),
        SingularError,
        "the filter's covariance has lost its definiteness",
    ),
]


@pytest.mark.parametrize(("change", "said"), NO_NOISE)
def test_a_noise_model_that_is_none_is_refused_in_a_line(change, said):
    for e in map(begun, FILTERS):
        with pytest.raises(UsageError, match=f"^{said}"):
            e.set(replace(NOISE, **change))


@pytest.mark.parametrize(("call", "error", "said"), NO_CALL)
def test_both_filters_refuse_alike(call, error, said):
    caught = []
    for e in map(begun, FILTERS):
        with pytest.raises(error, match=f"^{said}") as found:
            call(e)
        caught.append((found.type, str(found.value)))
    assert caught[0] == caught[1]


# ------------------------------------------------------------------------------ a covariance


@pytest.mark.parametrize("single", [False, True], ids=["double", "float"])
def test_no_input_makes_a_variance_negative(single):
    """Wild steps, torques, deviations and measurements: what is not refused leaves a covariance."""
    e, rng = CompiledEstimator(model(), single=single, flags=QUICK), np.random.default_rng(3)
    taken, fine = 0, np.finfo(e.real).eps
    for k in range(3000):
        wild = 10 ** rng.uniform(-8, 8, 3)
        if k % 100 == 0:
            e.start(np.zeros(3), np.zeros(3), SPREAD * wild[0], SPREAD * wild[1], NOISE)
        try:
            e.predict(rng.normal(size=1) * wild[0], REST, 10 ** rng.uniform(-6, 0))
            e.update([0.0], REST, 1e-3 * wild[1] * rng.normal(size=1), 1e-6 * wild[2] * rng.normal(size=2))
        except ScrewgenError:
            continue
        P, taken = e.covariance.astype(float), taken + 1
        deviation = np.sqrt(np.diag(P))
        there = deviation > 1e-15
        assert (np.diag(P) >= 0).all() and np.array_equal(P, P.T)
        scaled = (P / np.outer(deviation + ~there, deviation + ~there))[np.ix_(there, there)]
        assert np.linalg.eigvalsh(scaled)[0] > -16 * fine
    assert taken > 100


def test_a_variance_that_vanishes_is_no_fault():
    """Far below the smallest number of full precision, where a covariance is indefinite by rounding."""
    P = np.diag([1e-8, 2e-317, 1e-8, 1e-4, 1e-4, 1e-4])
    P[0, 1] = P[1, 0] = 1.00001 * np.sqrt(P[0, 0]) * np.sqrt(P[1, 1])
    for e in map(begun, FILTERS):
        e.put(np.zeros(3), np.zeros(3), P)
        e.update([0.0], REST, [1e-4])
        assert e.covariance[1, 1] >= 0 and e.covariance[0, 0] == pytest.approx(5e-9)
