"""The Kalman filter of the generated C: against a dense one, over long runs, in failure."""

from functools import cache

import numpy as np
import pytest
from dense_filter import DenseFilter
from drive_robots import ELASTIC, RIGID
from helpers import QUICK, G, arm, example, link, model_of
from varying_robots import tapered_arm

from screwgen import SingularError, UsageError
from screwgen.algorithms.gauges import gauges
from screwgen.errors import ScrewgenError
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.integrate import JointStepper

FIBRE = 0.02


def noise_of(model) -> Noise:
    """Forces that the model does not know of: on joints and bending; stiff directions are believed."""
    modes = [0.1 if d.startswith("bending") else 1e-6 for key in model.chain.keys for d, _ in key.directions]
    density = np.r_[np.full(model.chain.eta_v, 2.0), modes]
    return Noise(density, density_q=1e-12, encoder=1e-4, strain=2e-6, acceleration=0.2, fibre=FIBRE)


SOFT = {"EA": 5e4, "EIy": 300.0, "EIz": 500.0, "GJ": 20.0}
TIP = [{"at": "tip", "mass": 1.0, "com": [0.1, 0.0, 0.02], "inertia": [0.01, 0.02, 0.02, 0.001, 0.0, 0.0]}]
MOUNT = {"mount": {"xyz": [0.1, 0, 0.2], "rpy": [1, 2, 3]}, "stiffness": [5.0], "damping": [0.3], "armature": [0.05]}
MODES = {"basis": "polynomial", "axial": 1, "bending_z": 2}
SKEW = arm(
    link("a", axes=["z", [1, 2, 3]], modes={"bending_y": 2, "torsion": 1}, section=SOFT, frame_at=0.4, bodies=TIP),
    link("b", axes="y", modes=MODES, section=SOFT, joint=MOUNT, bodies=TIP),
)

GEARED = arm(
    link("a", axes=["z", [1, 2, 3]], modes={"bending_y": 2}, section=SOFT, bodies=TIP, joint={"drives": [ELASTIC, {}]}),
    link("b", axes="y", modes={"bending_z": 1}, section=SOFT, bodies=TIP, joint={"drives": [RIGID]}),
)
"""Elastic and rigid gears with friction: encoders are on the rotors."""

TAPERED = tapered_arm()
SHORT = TAPERED | {"links": TAPERED["links"][1:]}
ROBOTS = {"skew": SKEW, "tapered": SHORT, "second order": SKEW | {"order": 2}, "drives": GEARED}


@cache
def model(name):
    return example("ella") if name == "ella" else model_of(ROBOTS[name])


@cache
def compiled(name, single=False, binding="runtime"):
    return CompiledEstimator(model(name), single=single, binding=binding, flags=QUICK)


def gauge_rows(model) -> np.ndarray:
    """Strain as rows over [q; v], from shapes by differences: psi = s^2 (a + b s + c s^2 + ...) near the base."""
    rows, m = [], model.chain.eta_q
    s = 0.01 * np.arange(1, 9)
    for i, (part, key) in enumerate(zip(model.robot.links, model.chain.keys, strict=True)):
        for direction in ("bending_y", "bending_z"):
            row = np.zeros(2 * model.nq)
            for k, (d, number) in enumerate(key.directions):
                if d == direction:
                    values = np.array(key.shapes(direction).evaluate(s)[number]) / s**2
                    row[m + model.chain.eta_offset[i] + k] = -FIBRE * 2 * np.polyfit(s, values, 7)[-1] / part.length**2
            if row.any():
                rows.append(row)
    return np.array(rows).reshape(-1, 2 * model.nq)


def deviation_of(model) -> np.ndarray:
    """Standard deviations of q at the start."""
    stiff = [not d.startswith("bending") for key in model.chain.keys for d, _ in key.directions]
    return np.r_[np.full(model.chain.eta_q, 1e-2), np.where(stiff, 1e-7, 1e-3)]


class Truth:
    """A motion of the same model, seen through noise."""

    def __init__(self, model, seed=0):
        self.model, self.rng = model, np.random.default_rng(seed)
        self.stepper = JointStepper(model, "modal_midpoint", model.parameter_values)
        joints = self.rng.uniform(-0.5, 0.5, model.n_joints) + 0.3
        self.q = model.chain.with_inner(joints, model.parameter_values)
        self.v = np.zeros(model.nq)
        self.rows = gauge_rows(model)

    def torque(self):
        driven = self.model.chain.effort_places
        stiff = 40.0 if self.model.robot.name == "ella" else 1.0
        noise = self.rng.normal(size=len(driven))
        return -stiff * self.q[driven] - stiff / 20 * self.v[driven] + noise

    def step(self, tau, w_ext, h):
        self.q, self.v = self.stepper.step(self.stepper.initial(self.q, self.v), tau, w_ext, h)

    def measured(self, rng):
        """Encoders and strain."""
        strain, noise = self.rows[:, : self.model.nq] @ self.q, noise_of(self.model)
        return (
            self.q[self.model.chain.effort_places] + noise.encoder * rng.normal(size=self.model.n_tau),
            strain + noise.strain * rng.normal(size=strain.size),
        )


# -------- against the dense filter


@pytest.mark.parametrize(
    ("name", "binding", "steps"),
    [
        ("ella", "runtime", 100),
        ("skew", "baked", 60),
        ("tapered", "runtime", 25),
        ("second order", "runtime", 60),
        ("drives", "runtime", 40),
    ],
)
def test_equals_a_dense_filter(name, binding, steps):
    as_the_dense_filter(model(name), compiled(name, binding=binding), steps)


def as_the_dense_filter(robot, e: CompiledEstimator, steps: int) -> None:
    """Every entry of the measurement there or not by chance; mean and covariance in standard deviations."""
    truth, rng = Truth(robot, 1), np.random.default_rng(2)
    w_ext, h, n = rng.normal(size=(robot.n_links, 6)), 1e-3, robot.nq
    start = (truth.q + 0.01 * np.r_[rng.normal(size=robot.n_joints), np.zeros(n - robot.n_joints)], truth.v)
    deviation = deviation_of(robot)
    judge = DenseFilter(robot, *start, deviation, 10 * deviation, noise_of(robot), truth.rows)
    e.start(*start, deviation, 10 * deviation, noise_of(robot))
    for k in range(steps):
        tau = truth.torque()
        truth.step(tau, w_ext, h)
        judge.predict(tau, w_ext, h)
        e.predict(tau, w_ext, h)
        if k % 3 == 0:
            a, _ = judge.accelerometer(np.r_[truth.q, truth.v], tau, w_ext.T)
            given = [*truth.measured(rng), a.full()[:, 0] + 0.2 * rng.normal(size=3)]
            given = [np.where(rng.uniform(size=x.size) < 0.7, x, np.nan) for x in given]
            judge.update(tau, w_ext, *given)
            e.update(tau, w_ext, *given)
        sd = np.sqrt(np.diag(judge.P))
        assert np.max(np.abs(np.concatenate(e.state) - judge.x) / sd) < 1e-9
        assert np.max(np.abs(e.covariance - judge.P) / np.outer(sd, sd)) < 1e-9
    assert np.max(np.abs(np.r_[truth.q, truth.v] - judge.x) / sd) < 5


# -------- over long runs


@pytest.mark.parametrize("steps", [1000, pytest.param(10_000, marks=pytest.mark.long)])
@pytest.mark.parametrize("single", [False, True], ids=["double", "float"])
def test_covariance_stays_symmetric_and_definite_over_many_steps(single, steps):
    """And the estimate stays where the truth is: within five deviations, or a few rounding errors of float."""
    robot, e = model("ella"), compiled("ella", single)
    truth, rng, w_ext = Truth(robot, 4), np.random.default_rng(5), np.zeros((2, 6))
    e.start(truth.q, truth.v, deviation_of(robot), 10 * deviation_of(robot), noise_of(robot))
    for k in range(steps):
        tau = truth.torque()
        truth.step(tau, w_ext, 1e-3)
        e.predict(tau, w_ext, 1e-3)
        e.update(tau, w_ext, *truth.measured(rng))
        if k % 50 == 49:
            P = e.covariance.astype(float)
            sd = np.sqrt(np.diag(P))
            assert np.array_equal(P, P.T)
            assert np.linalg.eigvalsh(P / np.outer(sd, sd))[0] > 0
            measured = np.r_[0:3, [3 + g.first for g in gauges(robot.chain)]]
            assert np.max((np.abs(e.state[0] - truth.q) / sd[:9])[measured]) < 6


def test_an_undamped_vibration_neither_grows_nor_decays():
    """Without noise the expected energy tr(K P_qq) + tr(M P_vv) of a free beam is conserved, however long the step."""
    beam = model_of(arm(link("beam", axes=[], modes={"axial": 1, "bending_y": 3}, section=SOFT), gravity=(0, 0, 0)))
    e, n = CompiledEstimator(beam, flags=QUICK), beam.nq
    M, K = beam.numpy().mass_matrix(np.zeros(n)), np.diag(beam.numpy().constants[0]["K"])
    assert np.sqrt(np.max(np.diag(K) / np.diag(M))) * 0.01 > 2, "the step must be long for the stiffest mode"
    energy = lambda P: np.trace(K @ P[:n, :n]) + np.trace(M @ P[n:, n:])  # noqa: E731
    e.start(np.zeros(n), np.zeros(n), [1e-3, 2e-3, 1e-3, 1e-4], 0.1, Noise(0.0))
    before = energy(e.covariance)
    for _ in range(1000):
        e.predict([], np.zeros((1, 6)), 0.01)
    assert np.isclose(energy(e.covariance), before, rtol=1e-10)


def test_the_root_keeps_what_a_precise_measurement_leaves():
    """In float 1 - 1/(1 + 1e-10) is 0: a difference of variances would leave none, or a negative one."""
    robot, e = model("ella"), compiled("ella", single=True)
    sd = np.where(deviation_of(robot) < 1e-3, 1e-6, 1.0)
    e.start(np.zeros(9), np.zeros(9), sd, sd, Noise(0.0, encoder=1e-5))
    e.update(np.zeros(3), np.zeros((2, 6)), [0.1, np.nan, -0.2])
    assert np.allclose(np.diag(e.covariance)[[0, 2]], 1e-10, rtol=1e-5, atol=0)
    assert np.allclose(e.state[0][:3], [0.1, 0.0, -0.2], rtol=1e-6)
    assert np.array_equal(np.diag(e.covariance)[1:2], [1.0])


# -------- measurements


@pytest.mark.parametrize("direction", ["bending_y", "bending_z"])
def test_a_gauge_measures_what_beam_theory_says(direction):
    """A clamped beam with a force F at its tip: u'' = F l / EI at the base; the fibre on that side is compressed."""
    beam = model_of(arm(link("beam", 0.8, [], modes={"basis": "polynomial", direction: 2}, section=SOFT)))
    e = CompiledEstimator(beam, flags=QUICK)
    eta = np.array([0.01, 0.002])
    force = beam.numpy().inverse_dynamics(eta, np.zeros(2), np.zeros(2), np.zeros((1, 6)))
    force = force - beam.numpy().inverse_dynamics(np.zeros(2), np.zeros(2), np.zeros(2), np.zeros((1, 6)))
    shape = beam.chain.keys[0].shapes(direction)
    F = 3.0
    eta = F * np.array(shape.tip_value) / (force / eta)
    EI = SOFT["EIz" if direction == "bending_y" else "EIy"]
    row = gauges(beam.chain)[0].curvatures
    assert np.isclose(-FIBRE * np.dot(row, eta) / 0.8**2, -FIBRE * F * 0.8 / EI, rtol=1e-12)
    e.start(np.zeros(2), np.zeros(2), 1.0, 1.0, Noise(0.0, strain=1e-9, fibre=FIBRE))
    e.update([], np.zeros((1, 6)), [], [-FIBRE * F * 0.8 / EI])
    assert np.isclose(np.dot(row, e.state[0]) / 0.8**2, F * 0.8 / EI, rtol=1e-6)


def test_an_accelerometer_at_rest_feels_the_ground():
    """A pendulum that hangs, in its frame: free fall is along x, what is felt against it."""
    rod = model_of(arm(link("rod", 1.0, "y")))
    e, hanging = CompiledEstimator(rod, flags=QUICK), [np.pi / 2]
    e.start(hanging, [0.0], 1e-3, 1e-3, Noise(0.0, acceleration=1e-3))
    e.update([0.0], np.zeros((1, 6)), acceleration=[-G, 0.0, 0.0])
    assert np.allclose(e.state, [hanging, [0.0]], rtol=0, atol=1e-12)


def test_parameters_at_run_time_reach_the_gauges():
    robot = model("ella")
    p = np.array(robot.parameter_values)
    p[robot.parameter_names.index("upper_arm.length")] *= 2
    found = []
    for values in (None, p):
        e = CompiledEstimator(robot, values, flags=QUICK)
        e.start(np.zeros(9), np.zeros(9), 1e-9, 1e-9, Noise(0.0, strain=1.0, fibre=1.0))
        e.put(np.zeros(9), np.zeros(9), np.diag(np.r_[np.zeros(4), 1e6, np.zeros(13)]))
        e.update(np.zeros(3), np.zeros((2, 6)), strain=[1.0, np.nan, np.nan, np.nan])
        found.append(e.state[0][4])
    assert np.isclose(found[1] / found[0], 4.0, rtol=1e-5)


# -------- failures


def test_failures_leave_the_estimate_untouched():
    e, free, nan = compiled("ella"), np.zeros((2, 6)), np.nan
    start = (np.full(9, 1e-3), np.full(9, 1e-2), 1e-2, 1e-1)

    def refused(call, error=ScrewgenError, match="", noise=None, P=None):
        e.start(*start, noise or noise_of(model("ella")))
        if P is not None:
            e.put(start[0], start[1], P)
        before = (*(x.copy() for x in e.state), e.covariance.copy())
        with pytest.raises(error, match=match):
            call()
        assert all(np.array_equal(a, b) for a, b in zip((*e.state, e.covariance), before, strict=True))

    silent = Noise(1.0)
    inf = [np.inf, 0.0, 0.0]
    refused(lambda: e.predict(inf, free, 1e-3), UsageError, "tau holds a number that is not finite")
    refused(lambda: e.update(np.zeros(3), free, inf), UsageError, "encoder is not finite")
    refused(lambda: e.update(np.zeros(3), free, np.zeros(3), [0.0, 0.0, np.inf, 0.0]), UsageError, "strain is not fin")
    refused(lambda: e.update(inf, free, acceleration=np.zeros(3)), UsageError, "tau holds a number")
    for dt in (0.0, -1e-3, nan, np.inf):
        refused(lambda dt=dt: e.predict(np.zeros(3), free, dt), UsageError, "the step is")
    for given in ({"encoder": np.zeros(3)}, {"strain": np.zeros(4)}, {"acceleration": np.zeros(3)}):
        refused(lambda given=given: e.update(np.zeros(3), free, **given), UsageError, "no standard deviat", silent)
    for name, density in (("density_v", -1000.0), ("density_v", nan), ("density_q", -1e-9)):

        def predict(name=name, density=density):
            e._at[f"estimator.{name}"][1] = density
            e.predict(np.zeros(3), free, 1e-3)

        refused(predict, match="bad argument")
    lost = np.diag(np.r_[1.0, -1.0, np.ones(16)])
    refused(lambda: e.update(np.zeros(3), free, np.zeros(3)), SingularError, "definiteness", P=lost)
    assert e.fault == -1
    refused(lambda: e.update(np.zeros(3), free, np.zeros(2)), UsageError, r"shape \(2,\), must be \(3,\)")
    refused(lambda: e.predict(np.zeros(3), free.T, 1e-3), UsageError, r"^w_ext has the shape \(6, 2\)")


def test_a_singular_posture_names_its_link():
    wrist = model_of(arm(link("wrist", axes="xzx", bodies=TIP)))
    e, free = CompiledEstimator(wrist, flags=QUICK), np.zeros((1, 6))
    e.start(np.zeros(3), np.zeros(3), 1e-3, 1e-3, Noise(1.0, acceleration=1.0))
    with pytest.raises(SingularError, match="wrist"):
        e.predict(np.zeros(3), free, 1e-3)
    with pytest.raises(SingularError, match="wrist"):
        e.update(np.zeros(3), free, acceleration=np.ones(3))
    assert not np.any(e.state)


# -------- robots of every kind


@pytest.mark.parametrize(
    "robot",
    [arm(link("a", axes=[], modes={"bending_y": 2})), arm(link("a"), link("b", axes="y")), arm(link(axes=[]))],
    ids=["no joints", "no modes", "nothing"],
)
def test_without_joints_or_without_modes(robot):
    robot = model_of(robot)
    e, n, m = CompiledEstimator(robot, flags=QUICK), robot.nq, robot.n_joints
    e.start(np.zeros(n), np.zeros(n), 1e-3, 1e-3, Noise(1.0, 0.0, 1e-3, 1e-3, 1e-1, FIBRE))
    free = np.zeros((robot.n_links, 6))
    for _ in range(3):
        e.predict(np.zeros(m), free, 1e-4)
        e.update(np.zeros(m), free, np.zeros(m), np.zeros(len(gauges(robot.chain))), np.zeros(3))
    assert e.covariance.shape == (2 * n, 2 * n) and np.isfinite(e.covariance).all()
    assert np.linalg.eigvalsh(e.covariance).min(initial=1.0) > 0
