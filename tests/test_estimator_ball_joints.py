"""The filters of robots with ball joints: NumPy and C, differences of steps, simulated runs, what is refused."""

import subprocess
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from conformance.c_warnings import WARNINGS
from floating_robots import SATELLITE, rod
from helpers import QUICK, model_of
from scipy.spatial.transform import Rotation
from sensors import felt, measured

from screwgen import ScrewgenError, UsageError
from screwgen.algorithms.measurements import ACCELERATION
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.runtime.lean import RuntimeProject
from screwgen.simulation.estimator import Estimator
from screwgen.simulation.integrate import JointStepper

MOUNTED = {
    "name": "mounted",
    "gravity": [0.3, -0.4, -9.7],
    "links": [
        rod("arm", ["y"], mount={"xyz": [0.1, 0, 0.2]}),
        rod("fore", "ball"),
        rod("hand", ["z"]),
        rod("tip", "ball"),
    ],
}
"""Two ball joints on a fixed base, one at the end, and axes before and between them."""
_, *RODS = SATELLITE["links"]
PROBE = SATELLITE | {
    "name": "probe",
    "links": [SATELLITE["links"][0], {**RODS[0], "joint": {**RODS[0]["joint"], "axes": "ball"}}, *RODS[1:]],
}
"""A floating base whose first arm hangs on a ball joint."""
ROBOTS = {"mounted": MOUNTED, "probe": PROBE}


@cache
def model(name):
    return model_of(ROBOTS[name])


@cache
def compiled(name, single=False):
    return CompiledEstimator(model(name), single=single, flags=QUICK)


def begin(robot, seed=3) -> tuple[np.ndarray, np.ndarray]:
    """A posture far from home, and rates."""
    rng, chain = np.random.default_rng(seed), robot.chain
    change = np.where(np.arange(robot.nv) < chain.eta_v, rng.normal(size=robot.nv), 1e-3 * rng.normal(size=robot.nv))
    rates = np.where(np.arange(robot.nv) < chain.eta_v, 0.4 * rng.normal(size=robot.nv), 0.0)
    return chain.unit(chain.integrate(np.array(chain.home), change, SERIES)), rates


def rigid(robot) -> np.ndarray:
    return np.arange(robot.nv) < robot.chain.eta_v


def noise_of(robot) -> Noise:
    poses = {f"base_{name}": x for name, x in (("position", 2e-3), ("attitude", 2e-3), ("rate", 5e-3))}
    density = np.where(rigid(robot), 0.02, 1e-4)
    return Noise(density, 1e-10, 1e-3, 1e-5, 0.05, 0.02, **poses, joint_attitude=2e-3, joint_rate=5e-3)


def deviation(robot) -> np.ndarray:
    return np.where(rigid(robot), 1e-2, 1e-4)


@pytest.mark.parametrize("name", ROBOTS)
def test_numpy_and_c_are_the_same(name):
    """Entries of the measurements there or not by chance, some of them doubted."""
    robot, rng, weights = model(name), np.random.default_rng(1), []
    filters, noise = (compiled(name), Estimator(robot)), replace(noise_of(robot), gate=4.0, doubt=0.5)
    for e in filters:
        e.start(*begin(robot), deviation(robot), 10 * deviation(robot), noise)
    tau, w_ext = 0.1 * rng.normal(size=robot.n_tau), 0.1 * rng.normal(size=(robot.n_links, 6))
    for k in range(8):
        for e in filters:
            e.predict(tau, w_ext, 2e-3)
        if k % 2 == 0:
            z = measured(robot, *filters[1].state, tau, w_ext, rng, noise)
            z = {key: np.where(rng.uniform(size=np.shape(x)) < 0.85, x, np.nan) for key, x in z.items()}
            for e in filters:
                e.update(tau, w_ext, **z)
            weights += [[np.concatenate([x.weight for x in e.innovations.values()]) for e in filters]]
        (q, v), (q_n, v_n) = (e.state for e in filters)
        assert np.max(np.abs(q - q_n)) < 1e-12 and np.max(np.abs(v - v_n)) < 1e-11 * max(1, np.max(np.abs(v_n)))
        P, P_n = (e.covariance for e in filters)
        sd = np.sqrt(np.diag(P_n))
        assert np.max(np.abs(P - P_n) / np.outer(sd, sd)) < 1e-9 and np.array_equal(P, P.T)
        for part in robot.chain.curved:
            first = part.q.start + part.joint.turn_at
            assert abs(np.linalg.norm(q[first : first + 4]) - 1) < 1e-15
    of_c, of_numpy = np.array(weights).transpose(1, 0, 2)
    assert of_c == pytest.approx(of_numpy, rel=1e-6) and ((of_c > 0) & (of_c < 1)).mean() > 0.1


@pytest.mark.parametrize("name", ROBOTS)
def test_the_covariance_is_carried_as_differences_of_steps_say(name):
    """The midpoint rule's transition is that of the step but for terms in h³, so their difference falls eightfold."""
    robot, n = model(name), model(name).nv
    chain, (q, v), rng = robot.chain, begin(robot), np.random.default_rng(5)
    tau, w_ext = 0.1 * rng.normal(size=robot.n_tau), 0.1 * rng.normal(size=(robot.n_links, 6))
    sd = np.concatenate([deviation(robot), 10 * deviation(robot)])
    L = rng.normal(size=(2 * n, 2 * n)) * sd[:, None]
    stepper, e = JointStepper(robot, "modal_midpoint", robot.parameter_values), Estimator(robot)

    def error(h):
        def step(u):
            return stepper.step(stepper.initial(chain.integrate(q, u[:n], SERIES), v + u[n:]), tau, w_ext, h)

        after, rates = step(np.zeros(2 * n))
        e.start(q, v, 0.0, 0.0, Noise(0.0))
        e.put(q, v, L @ L.T)
        e.predict(tau, w_ext, h)

        def found(u):
            there, faster = step(u)
            return np.concatenate([chain.difference(after, there, SERIES), faster - rates])

        small = 1e-6
        Phi = np.transpose([(found(u) - found(-u)) / (2 * small) for u in small * np.eye(2 * n)])
        P, expected = e.covariance, Phi @ L @ (Phi @ L).T
        spread = np.sqrt(np.diag(expected))
        return np.max(np.abs(P - expected) / np.outer(spread, spread))

    coarse, fine = error(2e-4), error(1e-4)
    assert fine < 1e-4 and coarse / fine > 3.5


@pytest.mark.parametrize("name", ROBOTS)
def test_it_finds_a_simulated_motion(name):
    """From a start three deviations off, with noise in all measurements."""
    robot, rng, noise = model(name), np.random.default_rng(4), noise_of(model(name))
    chain, h, n = robot.chain, 2e-3, robot.nv
    e, stepper = compiled(name), JointStepper(robot, "modal_midpoint", robot.parameter_values)
    (q, v), w_ext, tau = begin(robot), np.zeros((robot.n_links, 6)), np.zeros(robot.n_tau)
    off = np.where(rigid(robot), 0.05, 0.0) * rng.choice([-1.0, 1.0], n)
    e.start(
        chain.integrate(q, off, SERIES),
        v + off,
        np.where(rigid(robot), 0.05, 1e-4),
        np.where(rigid(robot), 0.05, 1e-2),
        noise,
    )
    for k in range(200):
        q, v = stepper.step(stepper.initial(q, v), tau, w_ext, h)
        e.predict(tau, w_ext, h)
        if k % 5 == 0:
            e.update(tau, w_ext, **measured(robot, q, v, tau, w_ext, rng, noise, accelerometer=False))
    q_e, v_e = e.state
    left = np.concatenate([chain.difference(q_e, q, SERIES), v - v_e])
    sd = np.sqrt(np.diag(e.covariance))
    assert np.max(np.abs(left) / sd) < 4.5
    assert np.max(np.abs(left[:n][rigid(robot)])) < 3e-3 and np.max(sd[:n][rigid(robot)]) < 3e-3


def test_an_attitude_alone_is_believed():
    robot = model("mounted")
    e, (q, v) = compiled("mounted"), begin(robot)
    turn = Rotation.from_rotvec([1e-3, -2e-3, 1.5e-3])
    balls = list(robot.chain.curved)
    there = [(Rotation.from_quat(q[part.q], scalar_first=True) * turn).as_quat(scalar_first=True) for part in balls]
    still = np.zeros(robot.n_tau), np.zeros((robot.n_links, 6))
    e.start(q, v, 0.1, 0.1, Noise(0.0, joint_attitude=1e-7))
    e.update(*still, joint_attitude=np.concatenate([there[0], np.full(4, np.nan)]))
    (first, second), found = balls, e.state[0]
    assert np.allclose(found[first.q], there[0], atol=1e-8) and np.allclose(found[second.q], q[second.q], atol=1e-15)
    e.update(*still, joint_attitude=np.concatenate([np.full(4, np.nan), -5e200 * there[1]]))
    assert np.allclose(e.state[0][second.q], there[1], atol=1e-8)


def test_the_accelerometer_of_a_robot_with_ball_joints():
    """Rows by differences of what is felt, along changes of the posture."""
    robot = model("mounted")
    (q, v), rng, n = begin(robot), np.random.default_rng(2), robot.nv
    tau, w_ext = 0.1 * rng.normal(size=robot.n_tau), 0.1 * rng.normal(size=(robot.n_links, 6))
    e = Estimator(robot)
    e.start(q, v, 0.1, 0.1, Noise(0.0))
    H, rest = e.compared(ACCELERATION, felt(robot, q, v, tau, w_ext), tau, w_ext)
    assert np.max(np.abs(rest)) < 1e-9

    def at(u):
        return felt(robot, robot.chain.integrate(q, u[:n], SERIES), v + u[n:], tau, w_ext)

    expected = np.transpose([(at(u) - at(-u)) / 2e-6 for u in 1e-6 * np.eye(2 * n)])
    assert np.max(np.abs(H - expected)) < 1e-6 * np.max(np.abs(expected))


WRONG = [
    ({"base_attitude": [1, 0, 0, 0]}, "base_attitude: robot 'mounted' has a fixed base; leave it out"),
    ({"joint_position": [1, 0, 0]}, "joint_position: is no measurement; choose of encoder, strain, acceleration, "),
    ({"joint_attitude": [1, 0, 0, 0]}, r"joint_attitude: shape \(4,\), must be \(8,\)"),
    ({"encoder": np.zeros(8)}, r"encoder: shape \(8,\), must be \(2,\)"),
]


@pytest.mark.parametrize(("given", "said"), WRONG, ids=[next(iter(given)) for given, _ in WRONG])
def test_what_is_not_measured_is_refused(given, said):
    robot = model("mounted")
    for e in (compiled("mounted"), Estimator(robot)):
        e.start(*begin(robot), 0.1, 0.1, noise_of(robot))
        with pytest.raises(UsageError, match=said):
            e.update(np.zeros(robot.n_tau), np.zeros((robot.n_links, 6)), **given)


def test_a_quaternion_of_no_length_is_refused():
    robot = model("mounted")
    q, v = begin(robot)
    q[robot.chain.curved[0].q] = 0.0
    for e in (compiled("mounted"), Estimator(robot)):
        with pytest.raises(ScrewgenError):
            e.start(q, v, 0.1, 0.1, noise_of(robot))


@pytest.mark.parametrize("name", ROBOTS)
def test_the_c_compiles_without_a_warning(name, tmp_path):
    robot = model(name)
    for file, text in RuntimeProject(robot.chain, "0", "baked", estimator=True).files().items():
        (tmp_path / file).write_text(text)
    source = tmp_path / f"{robot.robot.name}_estimator.c"
    done = subprocess.run(
        ["gcc", *WARNINGS, "-c", source, "-o", "/dev/null"], capture_output=True, text=True, check=False
    )
    assert not done.returncode and not done.stderr, done.stderr
