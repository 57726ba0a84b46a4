"""Laws that the equations must obey, whatever the robot: energy, momentum, symmetry, and two ways to one answer."""

from functools import cache

import casadi as ca
import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from helpers import Case, case_of, drawn, flat, link, model_of, quick, relative, rotation_of
from oracle import part_error
from oracle_robots import pinocchio_model

SEEDS = range(300, 306)
every_robot = pytest.mark.parametrize("seed", swept(SEEDS, 300, 301, 302))


@cache
def robot_case(seed: int) -> Case:
    return drawn(seed, 1 + seed % 4)


def along(function: ca.Function, p, *pairs):
    """d/dt of a CasADi function's outputs: `pairs` are (value, rate) of every input but the parameters `p`."""
    t = ca.MX.sym("t")
    inputs = [ca.DM(x) + t * ca.DM(dx) for x, dx in pairs]
    outputs = function.call([*inputs, ca.DM(p)])
    slope = ca.Function("slope", [t], [ca.jacobian(ca.vec(ca.densify(y)), t) for y in outputs])
    return [np.array(d).reshape(y.shape, order="F") for d, y in zip(slope.call([0.0]), outputs, strict=True)]


def rigid_motion_free(robot: dict) -> dict:
    """The robot without losses and springs in its joints and without gravity."""
    for part in robot["links"]:
        part.pop("damping", None)
        for key in ("damping", "stiffness"):
            part["joint"].pop(key, None)
    return robot | {"gravity": [0.0, 0.0, 0.0]}


# -------- the mass matrix


@every_robot
def test_mass_matrix_is_symmetric_and_positive(seed):
    case = robot_case(seed)
    M = case.model.numpy().mass_matrix(case.inputs[0])
    assert np.max(np.abs(M - M.T)) <= 1e-13 * np.max(np.abs(M))
    values = np.linalg.eigvalsh((M + M.T) / 2)
    definite = all("rhoIp" in x["section"] or "density" in x["section"] for x in case.robot["links"])
    assert values[0] > 0 if definite else values[0] > -1e-12 * values[-1]


# -------- energy


@every_robot
def test_energy_changes_by_the_power(seed):
    """d/dt (T + U) = tau . qdot + tip wrench . tip twist - losses: all by the package's own functions.

    This is the skew symmetry of Mdot - 2C along the motion. The tip twist comes from the pose, not the dynamics.
    """
    case, model = robot_case(seed), robot_case(seed).model
    functions, p, m = model.casadi(), model.parameter_values, model.n_joints
    q, v, tau, _ = case.inputs
    w_ext = np.zeros((model.n_links, 6))
    w_ext[-1] = case.state["w_ext"][-1]
    vdot = flat(functions["forward_dynamics"](q, v, tau, w_ext.T, p)[0])
    kinetic, potential = (float(x.item()) for x in along(functions["energy"], p, (q, v), (v, vdot)))
    R_dot, velocity = along(functions["tip_pose"], p, (q, v))
    R = np.array(functions["tip_pose"](q, p)[0])
    S = R.T @ R_dot
    twist = [S[2, 1], S[0, 2], S[1, 0], *(R.T @ velocity[:, 0])]
    gains = [tau @ v[:m], np.dot(w_ext[-1], twist), -np.sum(case.oracle.damping * v**2)]
    scale = abs(kinetic) + abs(potential) + sum(map(abs, gains))
    assert abs(kinetic + potential - sum(gains)) <= 1e-10 * scale


@every_robot
def test_coriolis_forces_are_skew(seed):
    """v^T (Mdot - 2C) v = 0 with C v the bias of a robot without gravity, springs and losses."""
    case = robot_case(seed)
    model = model_of(rigid_motion_free(case.robot))
    functions, p, q, v = model.casadi(), model.parameter_values, *case.inputs[:2]
    undeformed = np.array([*q[: model.n_joints], *np.zeros(model.nq - model.n_joints)])
    zero = np.zeros((6, model.n_links))
    (M_dot,) = along(functions["mass_matrix"], p, (undeformed, v))
    coriolis = flat(functions["bias"](undeformed, v, zero, p))
    scale = np.abs(v) @ np.abs(M_dot) @ np.abs(v) + 2 * np.abs(v) @ np.abs(coriolis)
    assert abs(v @ M_dot @ v - 2 * v @ coriolis) <= 1e-12 * (scale or 1.0)


# -------- momentum


@every_robot
def test_base_wrench_changes_the_momentum(seed):
    """Base force and moment, weights and tip wrenches together are the rate of the oracle's momentum."""
    case, oracle = robot_case(seed), robot_case(seed).oracle
    q, v, _, w_ext = case.inputs
    vdot, wrench = case.model.numpy().forward_dynamics(*case.inputs)
    x, y = ca.MX.sym("x", oracle.nv), ca.MX.sym("y", oracle.nv)
    momenta = ca.vertcat(*oracle._total_momentum(x, y))
    rate = ca.jtimes(momenta, ca.vertcat(x), ca.DM(v)) + ca.jtimes(momenta, y, ca.DM(vdot))
    rates = flat(ca.Function("rate", [x, y], [rate])(q, v))
    poses, weight = oracle.poses(q), np.zeros(6)
    for i, cloud in enumerate(oracle.clouds):
        moment = flat(ca.Function("s", [oracle.q], [cloud.first_moment()])(q))
        force, torque = poses["tip_R"][i] @ w_ext[i, 3:], poses["tip_R"][i] @ w_ext[i, :3]
        weight[:3] += cloud.masses.sum() * oracle.gravity + force
        weight[3:] += np.cross(moment, oracle.gravity) + np.cross(poses["tip_point"][i], force) + torque
    force = poses["R"][0] @ wrench[0, 3:]
    moment = poses["R"][0] @ wrench[0, :3] + np.cross(poses["joint_point"][0], force)
    scale = max(np.abs(rates).max(), np.abs(weight).max(), np.abs(wrench).max())
    assert np.max(np.abs(np.array([*force, *moment]) + weight - rates)) <= case.tolerance * scale


@every_robot
def test_angular_momentum_about_a_free_vertical_axis(seed):
    """No gravity, no torque about the first axis: d/dt of the momentum about it is zero."""
    robot = rigid_motion_free(robot_case(seed).robot)
    first = robot["links"][0]["joint"]
    first["axes"] = ["z", *[a for a in first["axes"][1:] if a != "z"]]
    first.pop("armature", None)
    first.pop("mount", None)
    state = rr.random_state(np.random.default_rng(seed), robot)
    state["w_ext"], state["tau"][0] = np.zeros_like(state["w_ext"]), 0.0
    case = case_of(robot, state)
    functions, p = case.model.casadi(), case.model.parameter_values
    q, v, tau, w_ext = case.inputs
    vdot = flat(functions["forward_dynamics"](q, v, tau, w_ext.T, p)[0])
    M = np.array(functions["mass_matrix"](q, p))[0]
    (M_dot,) = along(functions["mass_matrix"], p, (q, v))
    terms = np.array([*(M_dot[0] * v), *(M * vdot)])
    assert abs(terms.sum()) <= 1e-10 * np.abs(terms).sum()


# -------- two ways to one answer


@every_robot
def test_elimination_equals_dense_solution_of_the_assembled_system(seed):
    case, numeric = robot_case(seed), robot_case(seed).model.numpy()
    q, v, tau, w_ext = case.inputs
    n = case.model.n_links
    x = numeric.dae_state(q, v)
    M, H, W = numeric.assemble(x, tau, w_ext)
    z = np.linalg.solve(M, W - H)
    rates, wrench = numeric.dae_rates(x, tau, w_ext)
    at_twist = 7 * n + case.model.nq - case.model.n_joints
    at_modes = at_twist + 6 * n
    twists, modal = rates[at_twist:at_modes].reshape(n, 6), rates[at_modes : len(rates) - case.model.n_joints]
    links = z[: 12 * n].reshape(n, 12)
    parts = {
        "tau": (wrench[:, :3], links[:, :3], "F"),
        "F": (wrench[:, 3:], links[:, 3:6], "tau"),
        "alpha": (twists[:, :3], links[:, 6:9], "a"),
        "a": (twists[:, 3:], links[:, 9:], "alpha"),
        "eta": (modal, z[12 * n :], "alpha"),
    }
    errors = {k: part_error(ours, lu, parts[other][0]) for k, (ours, lu, other) in parts.items()}
    assert max(errors.values()) <= case.tolerance, errors


@every_robot
def test_assembled_system_is_the_same_in_all_back_ends(seed):
    case = robot_case(seed)
    q, v, tau, w_ext = case.inputs
    numeric, functions, p = case.model.numpy(), case.model.casadi(), case.model.parameter_values
    x = numeric.dae_state(q, v)
    compiled = quick(case.model, layout="modular")
    assert relative(flat(functions["dae_state"](q, v, p)), x) <= 1e-13
    assert relative(compiled.dae_state(q, v), x) <= 1e-13
    expected = numeric.assemble(x, tau, w_ext)
    from_casadi = [a.full() for a in functions["assemble"](x, tau, w_ext.T, p)]
    for ours, theirs, c in zip(expected, from_casadi, compiled.assemble(x, tau, w_ext), strict=True):
        assert relative(np.reshape(theirs, ours.shape), ours) <= 1e-12
        assert relative(c, ours) <= 1e-12


@every_robot
def test_forward_and_inverse_dynamics_undo_each_other(seed):
    case, numeric = robot_case(seed), robot_case(seed).model.numpy()
    q, v, tau, w_ext = case.inputs
    vdot, _ = numeric.forward_dynamics(q, v, tau, w_ext)
    applied = np.concatenate([tau, np.zeros(case.model.nq - len(tau))])
    M, h = numeric.mass_matrix(q), numeric.bias(q, v, w_ext)
    scale = max(np.abs(M) @ np.abs(vdot)) + np.abs(h).max()
    assert np.max(np.abs(numeric.inverse_dynamics(q, v, vdot, w_ext) - applied)) <= case.tolerance * scale
    assert np.max(np.abs(M @ vdot + h - applied)) <= case.tolerance * scale


# -------- the rigid limit


RIGID = [(n, share) for share in (0.0, 0.6) for n in (1, 2, 3, 5, 8, 12)]


@pytest.mark.parametrize("kind", swept(RIGID, (1, 0.0), (3, 0.0), (8, 0.0), (3, 0.6), (8, 0.6)))
def test_rigid_robots_equal_pinocchio(kind):
    """ABA and RNEA of Pinocchio: axes, mounts, bodies, armature, springs, losses, tip wrenches; slides and branches."""
    import pinocchio as pin

    n_links, share = kind
    limit = 1e8 if n_links < 8 else 1e9
    case = drawn(
        500 + n_links, n_links, rigid=1.0, material=0.0, limit=limit, frame_at=0.3, sliding=share, branching=share
    )
    _, model, found = pinocchio_model(case.robot)
    oracle, (q, v, tau, w_ext) = case.oracle, case.inputs
    model.gravity.linear, model.armature = np.array(case.robot["gravity"]), oracle.armature
    external = pin.StdVec_Force()
    external.extend([pin.Force.Zero() for _ in range(model.njoints)])
    for (joint, place), part, w in zip(found, case.robot["links"], w_ext, strict=True):
        tip = place * pin.SE3(np.eye(3), np.array([part["length"], 0, 0]))
        external[joint] = external[joint] + tip.act(pin.Force(w[3:], w[:3]))
    passive = oracle.damping * v + oracle.K @ q
    numeric = case.model.numpy()
    vdot, wrench = numeric.forward_dynamics(q, v, tau, w_ext)
    expected = pin.aba(model, model.createData(), q, v, tau - passive, external)
    assert relative(vdot, expected) <= case.tolerance
    data = model.createData()
    force = pin.rnea(model, data, q, v, vdot, external)
    assert relative(numeric.inverse_dynamics(q, v, vdot, w_ext), force + passive) <= 1e-10
    for i, (joint, _) in enumerate(found):
        if case.robot["links"][i]["joint"]["axes"]:
            force = data.f[joint]
            assert np.allclose(
                wrench[i], [*force.angular, *force.linear], rtol=0, atol=case.tolerance * np.abs(wrench).max()
            )


@pytest.mark.parametrize("n_links", swept([6, 8, 12], 6))
def test_long_flexible_chains(n_links):
    """Six to twelve different flexible links against the oracle, both forms."""
    case = drawn(600 + n_links, n_links, limit=1e9, max_modes=1)
    compiled = quick(case.model, layout="modular")
    for form in ("joint", "dae"):
        errors = case.oracle.errors(case.state, *compiled.forward_dynamics(*case.inputs, form=form))
        assert max(errors.values()) <= case.tolerance, errors


# -------- projection


@every_robot
def test_projection_puts_states_onto_the_joints(seed):
    """Poses and twists then follow from q, eta and their rates to 1e-12, as the oracle places them."""
    case, oracle, numeric = robot_case(seed), robot_case(seed).oracle, robot_case(seed).model.numpy()
    n, m, r = case.model.n_links, case.model.n_joints, case.model.nq - case.model.n_joints
    x = numeric.dae_state(*case.inputs[:2])
    moved = x + 1e-4 * np.random.default_rng(seed).standard_normal(len(x))
    projected = numeric.project(moved)
    q = np.concatenate([projected[-m:] if m else [], projected[7 * n : 7 * n + r]])
    poses, frames = oracle.poses(q), projected[: 7 * n].reshape(n, 7)
    assert np.allclose(np.linalg.norm(frames[:, :4], axis=1), 1, atol=1e-12)
    assert np.allclose([rotation_of(f[:4]) for f in frames], poses["R"], atol=1e-12)
    assert np.allclose(frames[:, 4:], poses["origin"], atol=1e-12)
    twists, etadot = projected[7 * n + r : 13 * n + r], projected[13 * n + r : 13 * n + 2 * r]
    columns = np.array([oracle.link_twists(q, e).ravel() for e in np.eye(oracle.nv)]).T
    rest = twists - columns[:, m:] @ etadot
    qdot = np.linalg.lstsq(columns[:, :m], rest, rcond=None)[0] if m else np.zeros(0)
    assert np.max(np.abs(rest - columns[:, :m] @ qdot)) <= 1e-12 * max(1, np.abs(twists).max())
    assert np.max(np.abs(numeric.project(projected) - projected)) <= 1e-12 * np.abs(projected).max()
    assert np.max(np.abs(numeric.project(x) - x)) <= 1e-12 * np.abs(x).max()
    assert np.max(np.abs(projected - x)) <= 0.1


# -------- singular robots


def test_a_link_without_spin_inertia_is_semidefinite():
    """Straight and without rhoIp a link has no inertia about its own axis: one zero eigenvalue, no negative one."""
    table = link(axes=["x", "y"], modes={"bending_y": 1, "bending_z": 1})
    del table["section"]["rhoIp"]
    model = model_of({"name": "bare", "gravity": [0, 0, 0], "links": [table]})
    values = np.linalg.eigvalsh(model.numpy().mass_matrix(np.zeros(4)))
    assert abs(values[0]) < 1e-15 and values[1] > 1e-3
