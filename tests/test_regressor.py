"""Forces as a matrix times parameters, beside Pinocchio's regressor; base parameters of known robots."""

import subprocess

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest
from conftest import require_tool
from helpers import example_file, model_of
from identified_arms import pendulum

import screwgen
from screwgen.errors import UsageError

AXES = ("z", "y", "x", "y")
LENGTHS = (0.5, 0.4, 0.3, 0.2)
INERTIA = (0.05, 0.06, 0.07, 0.004, -0.003, 0.002)
GRAVITY = (0.4, -0.3, -9.81)
IN_PINOCCHIO = (0, 1, 2, 3, 4, 6, 9, 5, 7, 8)
"""Where a body's mass, first moments and inertias xx, yy, zz, xy, xz, yz stand in Pinocchio's ten."""


def body(k: int) -> dict:
    return {"at": "base", "mass": 1.0 + k, "com": [0.2, 0.03 * k, -0.02], "inertia": list(INERTIA)}


def chain(axes=AXES, gravity=GRAVITY, drive=None) -> screwgen.Model:
    """A rigid arm whose links have a body each."""
    links = [
        {"name": f"link{k}", "length": LENGTHS[k], "joint": {"axes": [axis]}, "bodies": [body(k)]}
        for k, axis in enumerate(axes)
    ]
    for link in links if drive else ():
        link["joint"]["drives"] = [drive]
    return model_of({"name": "chain", "gravity": list(gravity), "links": links})


def beside() -> pin.Model:
    """The same arm in Pinocchio."""
    model, parent = pin.Model(), 0
    for k, axis in enumerate(AXES):
        joint = {"x": pin.JointModelRX, "y": pin.JointModelRY, "z": pin.JointModelRZ}[axis]()
        at = pin.SE3(np.eye(3), np.array([LENGTHS[k - 1] if k else 0.0, 0.0, 0.0]))
        parent = model.addJoint(parent, joint, at, f"joint{k}")
        own, (xx, yy, zz, xy, xz, yz) = body(k), INERTIA
        J = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        model.appendBodyToJoint(parent, pin.Inertia(own["mass"], np.array(own["com"]), J), pin.SE3.Identity())
    model.gravity.linear = np.array(GRAVITY)
    return model


def motion(model, seed=0):
    rng = np.random.default_rng(seed)
    wide = np.where(np.arange(model.nq) < model.n_joints, 1.0, 0.01)
    return wide * rng.uniform(-1, 1, model.nq), *rng.uniform(-2, 2, (2, model.nv))


def test_columns_of_bodies_are_those_of_pinocchio():
    model, judge = chain(), beside()
    found = model.regressor("*.bodies*")
    assert len(found.names) == 10 * len(AXES) and not found.left_out
    order = [10 * k + place for k in range(len(AXES)) for place in IN_PINOCCHIO]
    for seed in range(5):
        state = motion(model, seed)
        theirs = pin.computeJointTorqueRegressor(judge, judge.createData(), *state)[:, order]
        Y, rest = found(*state)
        assert pytest.approx(theirs, abs=1e-10 * np.abs(theirs).max()) == Y
        assert np.abs(rest).max() < 1e-10 * np.abs(Y @ found.values).max()


def test_there_are_as_many_base_parameters_as_pinocchio_has_independent_columns():
    model, judge = chain(), beside()
    rows = [pin.computeJointTorqueRegressor(judge, judge.createData(), *motion(model, k)) for k in range(40)]
    assert len(model.regressor("*.bodies*").base_parameters) == np.linalg.matrix_rank(np.vstack(rows), rtol=1e-9)


@pytest.mark.parametrize(("gravity", "number"), [((0.0, 0.0, -9.81), 4), ((0.0, -9.81, 0.0), 6)])
def test_a_planar_arm_of_two_joints_has_the_base_parameters_of_textbooks(gravity, number):
    """Across gravity ZZ1R, ZZ2, MX2 and MY2 of Khalil and Dombre, in gravity MX1R and MY1 too."""
    found = chain("zz", gravity).regressor("*.bodies*")
    names = [one.name for one in found.base_parameters]
    assert len(names) == number
    assert "link0.bodies[0].inertia_about_point[2] + 0.25 link1.bodies[0].mass" in names
    assert ("link0.bodies[0].first_moment[0] + 0.5 link1.bodies[0].mass" in names) == (number == 6)


def test_drives_add_friction_and_rotors():
    drive = {"rotor_inertia": 0.01, "ratio": 10.0, "friction": {"coulomb": 0.3, "viscous": 0.2, "velocity": 0.02}}
    found = chain("zz", (0.0, -9.81, 0.0), drive).regressor()
    assert len(found.base_parameters) == 6 + 2 * 2 + 1  # the rotor of the first joint adds to ZZ1R
    assert found.left_out["link0.joint.drives[0].ratio"] == "forces are not linear in it"
    assert "gravity[1]" in found.left_out and "link1.bodies[0].mass" in found.names


@pytest.mark.parametrize("make", [pendulum, lambda: screwgen.derive(screwgen.load(example_file("ella")))])
def test_flexible_arms_have_the_forces_of_inverse_dynamics_at_other_parameters_too(make):
    """With all chosen parameters changed at once: that they are linear together, the product has from one regressor."""
    model = make()
    found = model.regressor()
    q, v, vdot = motion(model)
    w_ext = np.random.default_rng(1).normal(size=(model.n_links, 6))
    Y, rest = found(q, v, vdot, w_ext)
    assert Y[:, found.base_columns] @ found.base_matrix == pytest.approx(Y, abs=1e-9 * np.abs(Y).max())
    factors = np.random.default_rng(2).uniform(0.7, 1.4, len(found.names))
    other = dict(zip(found.names, (factors * found.values).tolist(), strict=True))
    force = model.numpy(model.chain.parameters.vector(other)).inverse_dynamics(q, v, vdot, w_ext)
    assert Y @ (factors * found.values) + rest == pytest.approx(force, abs=1e-10 * np.abs(force).max())


def test_what_is_not_linear_is_left_out_and_changes_the_rest_alone():
    model = pendulum()
    found = model.regressor()
    assert "rod.joint.drives[0].friction.velocity" in found.left_out and "rod.length" in found.left_out
    state = motion(model)
    Y, rest = found(*state, parameters={"rod.length": 1.2})
    force = model.numpy(model.chain.parameters.vector({"rod.length": 1.2})).inverse_dynamics(*state, None)
    assert Y @ found.values + rest == pytest.approx(force, abs=1e-10 * np.abs(force).max())


def test_numbers_of_laws_that_act_seldom_are_found_in_all_states():
    """Friction that falls within 0.01 rad/s, and a stop beyond the random states."""
    falls = {"coulomb": 0.3, "velocity": 0.002, "stribeck": {"static": 0.5, "velocity": 0.01}}
    link = {"name": "link", "length": 0.5, "bodies": [body(0)]}
    joint = {"axes": ["z"], "drives": [{"friction": falls}]}
    stop = {"upper": 2.5, "stiffness": 100.0, "damping": 1.0}
    robot = {"name": "stopped", "gravity": list(GRAVITY)}
    model = model_of(robot | {"links": [link | {"joint": joint | {"limits": [stop]}}]})
    found = model.regressor("link.joint*")
    for name in ("friction.stribeck.velocity", "friction.velocity"):
        assert f"link.joint.drives[0].{name}" in found.left_out
    for key in ("upper", "stiffness", "damping"):  # a stop never pulls: its numbers decide together when it lets go
        assert found.left_out[f"link.joint.limits[0].{key}"] == "forces are not linear in it"
    assert "link.joint.drives[0].friction.stribeck.static" in found.names
    other = dict(zip(found.names, (1.3 * found.values).tolist(), strict=True))
    judge = model.numpy(model.chain.parameters.vector(other))
    for state in (([0.3], [0.008], [0.0]), ([2.6], [0.5], [1.0])):
        Y, rest = found(*state)
        assert Y @ (1.3 * found.values) + rest == pytest.approx(judge.inverse_dynamics(*map(np.array, state), None))


def test_the_function_generates_c(tmp_path, monkeypatch):
    require_tool("cc")
    monkeypatch.chdir(tmp_path)
    model = chain()
    found = model.regressor("*.bodies*")
    found.function.generate("regressor.c")
    subprocess.run(
        ["cc", "-std=c99", "-O1", "-fPIC", "-shared", "regressor.c", "-o", "regressor.so", "-lm"], check=True
    )
    compiled, state = ca.external("regressor", "./regressor.so"), motion(model)
    Y, _ = compiled(*state, np.zeros((6, model.n_links)), model.parameter_values)
    assert np.array(Y) == pytest.approx(found(*state)[0], abs=1e-12 * np.abs(found(*state)[0]).max())


def test_faults_are_one_line():
    with pytest.raises(UsageError, match=r"regressor: there is no parameter 'arm\.mass'"):
        chain().regressor("arm.mass")
