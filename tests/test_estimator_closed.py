"""The filters of robots with loops and of floating bases: NumPy and C, against trees, differences and statistics."""

import subprocess
from functools import cache

import dual_arm
import floating_robots
import numpy as np
import pytest
import scipy.stats
from conformance.c_warnings import WARNINGS
from conftest import require_tool
from dense_filter import DenseFilter
from helpers import QUICK, model_of
from scipy.spatial.transform import Rotation
from sensors import felt, measured
from test_analyse_loops import one_bar, parallelogram
from test_linear_loops import BALL, GEAR, linkage
from test_loops import angles

from screwgen import SingularError, UsageError, equilibrium
from screwgen.algorithms.measurement_names import measurement
from screwgen.plotting.mode_plot import displaced
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.runtime.lean import RuntimeProject
from screwgen.simulation.estimator import Estimator
from screwgen.simulation.integrate import JointStepper

BENDING = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"rhoA": 1.5, "EIy": 300.0, "EIz": 300.0}}
HEAVY = floating_robots.SATELLITE | {"gravity": [0.4, -0.3, 0.6]}


@cache
def model(name):
    robots = {"satellite": HEAVY, "dual": dual_arm.dual_arm()}
    return linkage(BALL, {"joint": {"drives": [GEAR]}}, BENDING) if name == "bent" else model_of(robots[name])


@cache
def begin(name) -> tuple[np.ndarray, np.ndarray]:
    if name == "bent":
        return equilibrium(model(name), angles(0.4), hold=True).q, np.zeros(model(name).nv)
    return {"satellite": floating_robots, "dual": dual_arm}[name].start(model(name))


@cache
def compiled(name, single=False):
    return CompiledEstimator(model(name), single=single, flags=QUICK)


def rigid(robot) -> np.ndarray:
    return np.arange(robot.nv) < robot.chain.eta_v


def noise_of(robot) -> Noise:
    density = np.where(rigid(robot), 0.02, 1e-4)
    return Noise(density, 1e-10, 1e-3, 1e-5, 0.05, 0.02, base_position=2e-3, base_attitude=2e-3, base_rate=5e-3)


def deviation(robot) -> np.ndarray:
    return np.where(rigid(robot), 1e-2, 1e-4)


# ------------------------------------------------------------------------------ the same in both languages


LONG = pytest.param("dual", marks=pytest.mark.long)


@pytest.mark.parametrize("name", ["satellite", "bent", LONG])
def test_numpy_and_c_are_the_same_and_stay_closed(name):
    """Entries of the measurements there or not by chance."""
    robot, rng, noise = model(name), np.random.default_rng(1), noise_of(model(name))
    filters = (compiled(name), Estimator(robot))
    for e in filters:
        e.start(*begin(name), deviation(robot), 10 * deviation(robot), noise)
    tau = 0.1 * robot.chain.at_efforts(rng.normal(size=robot.n_tau), robot.parameter_values)
    w_ext = 0.1 * rng.normal(size=(robot.n_links, 6))
    for k in range(10):
        for e in filters:
            e.predict(tau, w_ext, 2e-3)
        if k % 2 == 0:
            z = measured(robot, *filters[1].state, tau, w_ext, rng, noise)
            z = {key: np.where(rng.uniform(size=np.shape(x)) < 0.8, x, np.nan) for key, x in z.items()}
            for e in filters:
                e.update(tau, w_ext, **z)
        (q, v), (q_n, v_n) = (e.state for e in filters)
        assert np.max(np.abs(q - q_n)) < 1e-12 and np.max(np.abs(v - v_n)) < 1e-11 * max(1, np.max(np.abs(v_n)))
        P, P_n = (e.covariance for e in filters)
        sd = np.sqrt(np.diag(P_n)) + 1e-12 * (np.diag(P_n) < 1e-24)
        assert np.max(np.abs(P - P_n) / np.outer(sd, sd)) < 1e-9 and np.array_equal(P, P.T)
        assert np.linalg.eigvalsh(P / np.outer(sd, sd))[0] > -1e-13
        if robot.chain.closing.rows:
            assert np.max(np.abs(robot.numpy().gaps(q, v))) < 1e-12
            J = filters[1]._rows_of_loops[: len(robot.chain.closing.rows), : robot.nv]
            assert np.max(np.abs(J @ P[: robot.nv, : robot.nv] @ J.T)) < 1e-16
        if robot.chain.floating:
            assert abs(np.linalg.norm(q[3:7]) - 1) < 1e-15


@pytest.mark.parametrize("name", ["bent", LONG])
def test_in_float(name):
    robot, noise = model(name), noise_of(model(name))
    e, q, rest = compiled(name, True), begin(name)[0], np.zeros((model(name).n_links, 6))
    driven = np.array(robot.chain.effort_places) + robot.chain.base_q - robot.chain.base_v
    e.start(*begin(name), deviation(robot), deviation(robot), noise)
    for _ in range(20):
        e.predict(np.zeros(robot.n_tau), rest, 1e-3)
        e.update(np.zeros(robot.n_tau), rest, q[driven])
    assert np.max(np.abs(robot.numpy().gaps(*(x.astype(float) for x in e.state))[0])) < 1e-5
    assert np.isfinite(e.covariance).all() and (np.diag(e.covariance) >= 0).all()


# ------------------------------------------------------------------------------ a tree that moves alike


def test_a_start_at_open_rates_has_the_covariance_of_closed_ones():
    """Rows of the closure by differences: the rates of the gaps are linear in v."""
    robot = model("bent")
    e, n = Estimator(robot), robot.nv
    e.start(begin("bent")[0], 5.0 * np.eye(n)[0], 0.1, 0.5, Noise(1.0))
    (q, v), P, gaps = e.state, e.covariance, robot.numpy().gaps
    rates = lambda q: gaps(q, v)[1]  # noqa: E731
    J = np.column_stack([gaps(q, one)[1] for one in np.eye(n)])
    J_q = np.column_stack([(rates(q + one) - rates(q - one)) / 2e-6 for one in 1e-6 * np.eye(n)])
    assert np.max(np.abs(J @ v)) < 1e-12 and np.max(np.abs(J @ P[:n])) < 1e-14
    assert np.max(np.abs(np.hstack([J_q, J]) @ P)) < 1e-9


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"deviation_q": -1.0}, "deviation_q: must be a number >= 0, or 16 of them"),
        ({"deviation_v": np.ones(3)}, "deviation_v: must be"),
        ({"noise": Noise(-1.0)}, "density_v: must be"),
        ({"q": np.zeros(17)}, "the quaternion of the base is zero"),
    ],
)
def test_starts_that_are_none_are_refused(change, said):
    robot = model("satellite")
    q, v = begin("satellite")
    given = {"q": q, "v": v, "deviation_q": 0.1, "deviation_v": 0.1, "noise": Noise(1.0)} | change
    with pytest.raises(UsageError, match=said):
        Estimator(robot).start(**given)


def alike(h: float, count: int) -> float:
    """The parallelogram's filter against that of one bar, whose one encoder is worth the three: in deviations."""
    shut, bar = parallelogram(20.0), one_bar()
    e, judge_noise = Estimator(shut), Noise(0.0, 0.0, 2e-3 / np.sqrt(3))
    q, rate, sd = 0.4, 0.5, (0.05, 0.4)
    judge = DenseFilter(bar, [q], [rate], sd[0] / np.sqrt(3), sd[1] / np.sqrt(3), judge_noise, np.zeros((0, 2)))
    e.start([q, -q, q], [rate, -rate, rate], sd[0], sd[1], Noise(0.0, 0.0, 2e-3))
    assert np.allclose(e.covariance[np.ix_([0, 3], [0, 3])], judge.P, rtol=1e-9)
    rng, worst = np.random.default_rng(0), 0.0
    for _ in range(count):
        e.predict([20.0, 0.0, 0.0], np.zeros((3, 6)), h)
        judge.predict(np.array([20.0]), np.zeros((1, 6)), h)
        z = 0.41 + 2e-3 * rng.normal(size=3)
        e.update([20.0, 0.0, 0.0], np.zeros((3, 6)), z * [1, -1, 1])
        judge.update(np.array([20.0]), np.zeros((1, 6)), [z.mean()], [], [np.nan] * 3)
        size = np.sqrt(np.diag(judge.P))
        own = [e.state[0][0], e.state[1][0]]
        worst = max(worst, np.max(np.abs(own - judge.x) / size))
        worst = max(worst, np.max(np.abs(e.covariance[np.ix_([0, 3], [0, 3])] - judge.P) / np.outer(size, size)))
    return worst


def test_a_parallelogram_is_estimated_as_one_bar():
    assert alike(2e-3, 12) < 1e-10


# ------------------------------------------------------------------------------ derivatives


def changed(robot, q, v, d):
    return displaced(robot, q, d[: robot.nv]), v + d[robot.nv :]


def apart(robot, one, other) -> np.ndarray:
    """The change [δ; δv] that leads from one state to another, to first order."""
    chain, (q, v), (q_o, v_o) = robot.chain, one, other
    delta = (q_o - q)[chain.base_q - chain.base_v :]
    if chain.floating:
        R = Rotation.from_quat(q[3:7], scalar_first=True)
        delta[:3] = (R.inv() * Rotation.from_quat(q_o[3:7], scalar_first=True)).as_rotvec()
        delta[3:6] = R.inv().apply(q_o[:3] - q[:3])
    return np.append(delta, v_o - v)


def test_the_transition_is_that_of_the_step_up_to_its_order():
    """Of changes on the group; the rule and the step are of second order, so what differs falls as h³."""
    robot, name = model("satellite"), "satellite"
    e, tau, w_ext = Estimator(robot), np.array(floating_robots.TAU), np.zeros((4, 6))
    q, v = begin(name)
    stepper, errors = JointStepper(robot, "modal_midpoint", robot.parameter_values), []
    for h in (1e-3, 5e-4):
        step = lambda q, v, h=h: stepper.step(stepper.initial(q, v), tau, w_ext, h)  # noqa: E731
        end = step(q, v)
        e.put(q, v, np.zeros((32, 32)))
        middle = e._middle(*end, h)
        Phi = e._transition(*middle, e._slopes(*middle, tau, tau, w_ext), h)[0]
        ends = lambda d: apart(robot, end, step(*changed(robot, q, v, d)))  # noqa: E731, B023
        found = np.array([(ends(1e-5 * x) - ends(-1e-5 * x)) / 2e-5 for x in np.eye(32)]).T
        errors.append(np.max(np.abs(Phi - found)[:, :10]) + np.max(np.abs(Phi - found)[:, 16:26]))
        assert np.max(np.abs(Phi - found)[:6]) < 1e-5
    assert errors[1] < errors[0] / 3 and errors[1] < 1e-3


def test_the_rows_of_measurements_are_differences():
    """Of the accelerometer with values of another program: the inertial acceleration of the linear model's outputs."""
    robot, (q, v), rng = model("satellite"), begin("satellite"), np.random.default_rng(2)
    given = np.array(floating_robots.TAU), 0.2 * rng.normal(size=(4, 6))
    e = Estimator(robot)
    e.put(q, v, np.eye(32))
    beside = lambda name, values: e.compared(measurement(robot.chain, name), np.array(values), *given)  # noqa: E731
    H, left = beside("acceleration", felt(robot, q, v, *given))
    assert np.max(np.abs(left)) < 1e-12
    for _ in range(3):
        d = rng.normal(size=32)
        ahead, behind = (felt(robot, *changed(robot, q, v, x * d), *given) for x in (1e-5, -1e-5))
        slope = (ahead - behind) / 2e-5
        assert np.allclose(H @ d, slope, rtol=0, atol=1e-7 * np.max(np.abs(H @ d)))
    turn, z = Rotation.from_quat(q[3:7], scalar_first=True), np.array([1e-4, -2e-4, 3e-4])
    far = (turn * Rotation.from_rotvec(z)).as_quat(scalar_first=True)
    for sign in (1, -3):
        assert np.allclose(beside("base_attitude", sign * far).rest, z, rtol=1e-6)
    moved = displaced(robot, q, np.eye(16)[4] * 1e-3)
    assert np.allclose(beside("base_position", moved[:3]).H[:, 4] * 1e-3, moved[:3] - q[:3], atol=1e-12)


# ------------------------------------------------------------------------------ statistics


@pytest.mark.parametrize("name", ["satellite", LONG])
def test_errors_are_as_large_as_the_covariance_says(name):
    """NEES over 10 runs, within the 95 % band of chi-square: kicks on the rates, noise on every sensor.

    The filter holds noise over a step, kicks are sudden: steps are short for what vibrates.
    """
    robot, runs, h = model(name), 10, 1.5e-3
    noise, e, eye = noise_of(robot), compiled(name), Estimator(robot)
    rng, n, w_ext = np.random.default_rng(7), robot.nv, np.zeros((robot.n_links, 6))
    stepper, sizes = JointStepper(robot, "modal_midpoint", robot.parameter_values), {10: [], 25: []}
    free = independent_of(robot, begin(name)[0])
    for _ in range(runs):
        q, v = begin(name)
        e.start(q, v, deviation(robot), 10 * deviation(robot), noise)
        P = e.covariance
        d = np.linalg.cholesky(P[np.ix_(free, free)] + 0) @ rng.normal(size=len(free))
        off = P[:, free] @ np.linalg.solve(P[np.ix_(free, free)], d)
        q, v = settled(eye, *changed(robot, q, v, off))
        for k in range(1, max(sizes) + 1):
            tau = 0.1 * robot.chain.at_efforts(np.cos(np.arange(robot.n_tau) + k * h), robot.parameter_values)
            q, v = stepper.step(stepper.initial(q, v), tau, w_ext, h)
            q, v = settled(eye, q, v + np.sqrt(h * noise.density_v) * rng.normal(size=n))
            e.predict(tau, w_ext, h)
            e.update(tau, w_ext, **measured(robot, q, v, tau, w_ext, rng, noise, k % 10 == 0))
            if k in sizes:
                error = apart(robot, e.state, (q, v))[free]
                sizes[k].append(error @ np.linalg.solve(e.covariance[np.ix_(free, free)], error))
    band = scipy.stats.chi2.interval(0.95, runs * len(free))
    for found in sizes.values():
        assert band[0] < sum(found) < band[1], (sum(found), band)


def independent_of(robot, q) -> np.ndarray:
    """The changes of [q; v] that loops leave free."""
    from screwgen.simulation.mobility import by_effort, jacobian, mobility

    own = np.arange(robot.nv)
    if robot.chain.closing.rows:
        own = mobility(jacobian(robot, q, robot.parameter_values), by_effort(robot.chain)).independent
    return np.append(own, robot.nv + own)


def settled(e: Estimator, q, v):
    return e._shut(q, v)[:2] if e.model.chain.closing.rows else (q, v)


# ------------------------------------------------------------------------------ what users see


def test_what_leads_astray_is_refused_and_changes_nothing():
    robot, e = model("bent"), compiled("bent")
    for f in (e, Estimator(robot)):
        f.start(*begin("bent"), 1e-2, 1e-1, Noise(1.0, 0.0, 1e-9))
        before = (*f.state, f.covariance)
        with pytest.raises(SingularError, match=r"loops do not close|singular"):
            f.update(np.zeros(3), np.zeros((3, 6)), [np.nan, 90.0, np.nan])
        assert all(np.array_equal(a, b) for a, b in zip((*f.state, f.covariance), before, strict=True))
        with pytest.raises(UsageError, match=r"^base_rate: robot 'arm' has a fixed base; leave it out"):
            f.update(np.zeros(3), np.zeros((3, 6)), base_rate=np.zeros(3))
        with pytest.raises(UsageError, match=r"^encodr: is no measurement; choose of encoder, strain, acceleration$"):
            f.update(np.zeros(3), np.zeros((3, 6)), encodr=None)
        with pytest.raises(UsageError, match=r"^strain: shape \(3,\), must be \(2,\)"):
            f.update(np.zeros(3), np.zeros((3, 6)), strain=np.zeros(3))
        with pytest.raises(UsageError, match="deviation_q: must be a number >= 0"):
            f.start(*begin("bent"), -1.0, 1.0, Noise(1.0))
        f.start(*begin("bent"), 1e-2, 1e-1, Noise(1.0))
        with pytest.raises(UsageError, match="encoder has no standard deviation"):
            f.update(np.zeros(3), np.zeros((3, 6)), np.zeros(3))
        with pytest.raises(UsageError, match="the step is -1 s"):
            f.predict(np.zeros(3), np.zeros((3, 6)), -1.0)
    g = compiled("satellite")
    g.start(*begin("satellite"), 1e-2, 1e-1, noise_of(model("satellite")))
    with pytest.raises(UsageError, match=r"^base_attitude is zero; give a quaternion"):
        g.update(np.zeros(4), np.zeros((4, 6)), base_attitude=np.zeros(4))
    with pytest.raises(UsageError, match=r"^base_attitude: shape \(3,\), must be \(4,\)"):
        g.update(np.zeros(4), np.zeros((4, 6)), base_attitude=np.zeros(3))


@pytest.mark.parametrize(
    ("name", "compiler", "binding", "define"),
    [("satellite", "clang", "baked", []), ("bent", "gcc", "runtime", ["-DARM_REAL_FLOAT"])],
)
def test_folders_compile_without_a_warning(tmp_path, name, compiler, binding, define):
    robot = model(name)
    for file, text in RuntimeProject(robot.chain, robot.version, binding, estimator=True).files().items():
        (tmp_path / file).write_text(text)
    source = f"{robot.robot.name}_estimator.c"
    command = [require_tool(compiler), *WARNINGS, *define, "-fsyntax-only", source]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0 and not done.stderr, done.stderr[:2000]
    text = (tmp_path / source).read_text()
    assert "malloc" not in text and "free(" not in text
