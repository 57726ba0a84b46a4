"""The functions that measure at markers: held against the oracle, laws of mechanics, and each other's derivatives."""

import numpy as np
import pytest
from helpers import arm, link, model_of, relative

import screwgen
from screwgen import rollout, simulate
from screwgen.algorithms.robot_functions import BY_NAME
from screwgen.viewer.view import read_run


def parts(found) -> list[np.ndarray]:
    return list(found) if isinstance(found, tuple) else [found]


NAMES = "marker_pose marker_velocity marker_jacobian marker_bias gyro accelerometer strain".split()
BALL = {"at": "tip", "mass": 1.5, "com": [0.0, 0.02, 0.05], "inertia": [0.02, 0.03, 0.02, 0.0, 0.0, 0.0]}


def pendulum(**more) -> dict:
    """Two flexible links of three modes each, with a marker, behind a mount that turns."""
    joint, section = {"mount": {"rpy": [0.3, -0.2, 0.5]}}, {"EIy": 90.0, "EIz": 60.0}
    modes = {"bending_y": 2, "bending_z": 1}
    sensor = [{"name": "imu", "at": 0.3}]
    upper = link("upper", 0.9, ["y", "z"], modes=modes, joint=joint, section=section, markers=sensor)
    lower = link("lower", 0.7, ["y"], modes={"bending_y": 1}, section=section, bodies=[BALL])
    return arm(upper, lower, **more)


@pytest.mark.parametrize("segments", [1, 3])
def test_at_rest_accelerometers_read_what_holds_them_up(segments):
    robot = pendulum()
    robot["links"][0]["segments"] = segments
    model = model_of(robot)
    numeric, g = model.numpy(), np.array(robot["gravity"])
    q = screwgen.equilibrium(model, [0.4, -0.3, 0.6]).q
    tau = numeric.inverse_dynamics(q, 0 * q, 0 * q, None)[: model.n_tau]
    a, R = numeric.accelerometer(q, 0 * q, tau, None), numeric.marker_pose(q)[0]
    assert np.allclose(a, -np.einsum("kji,j->ki", R, g), atol=1e-9)
    assert np.abs(numeric.gyro(q, 0 * q)).max() == 0.0


def test_in_free_fall_accelerometers_read_nothing():
    robot = pendulum(base="floating")
    robot["links"][0]["joint"] = {"axes": []}
    model = model_of(robot)
    q, v = np.array(model.chain.home), np.zeros(model.nv)
    assert np.abs(model.numpy().accelerometer(q, v)).max() < 1e-11


def test_runs_and_rollouts_measure_at_their_samples():
    """Wrenches that vary are part of what accelerometers feel."""
    model = model_of(pendulum())
    push = lambda t, q, v: [[0.0] * 6, [0.0, 0.1, 0.0, 5.0 * np.cos(9.0 * t), 0.0, 1.0]]  # noqa: E731
    for backend, w_ext in (("c", push), ("numpy", push), ("c", np.ones((2, 6)))):
        run = simulate(model, 0.01, 1e-3, controller=[0.1, 0.2, 0.3], w_ext=w_ext, backend=backend)
        acted = np.array([w_ext(t, None, None) if callable(w_ext) else w_ext for t in run.t])
        assert np.array_equal(run.w_ext, acted)
        for k in (0, 7, 10):
            given = {"q": run.q[k], "v": run.v[k], "tau": run.tau[k], "w_ext": acted[k]}
            for name in NAMES:
                row = BY_NAME[name]
                expected = parts(getattr(model.numpy(), name)(*(given[x] for x in row.names)))
                for found, y in zip(parts(getattr(run, name)), expected, strict=True):
                    assert found[k].shape == y.shape and relative(found[k], y) < 1e-9
    many = rollout(model, np.r_[run.q[0], run.v[0]], run.tau[0], w_ext=w_ext, step=1e-3, steps=10)
    for name in NAMES:
        for found, y in zip(parts(getattr(many, name)), parts(getattr(run, name)), strict=True):
            assert relative(found[0], y) < 1e-8
    assert np.array_equal(many.base_strain, many.strain[:, :, :3])


def test_the_file_of_a_run_keeps_the_wrenches_that_acted(tmp_path):
    model = model_of(pendulum())
    for w_ext in (None, np.ones((2, 6))):
        run = simulate(model, 2e-3, 1e-3, w_ext=w_ext)
        run.save(tmp_path / "run.npz")
        again = read_run(tmp_path / "run.npz")
        assert (again.w_ext is None) == (w_ext is None)
        assert np.array_equal(again.accelerometer, run.accelerometer)
