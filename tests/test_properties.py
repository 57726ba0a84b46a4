"""Rigid robots beside Pinocchio, long chains, states put onto the joints, links without inertia."""

from functools import cache

import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from helpers import Case, drawn, link, model_of, quick, relative, rotation_of
from oracle_robots import pinocchio_model

SEEDS = range(300, 306)
every_robot = pytest.mark.parametrize("seed", swept(SEEDS, 300, 301, 302))


@cache
def robot_case(seed: int) -> Case:
    return drawn(seed, 1 + seed % 4)


# -------- the rigid limit


def along(rng, robot: dict) -> dict:
    """The robot with most of its links carried at the base, at a marker or at a place of their parents."""
    names = [table["name"] for table in robot["links"]]
    for i, table in enumerate(robot["links"][1:], 1):
        if table.get("parent") == "world" or rng.random() > 0.8:
            continue
        s, kind = float(rng.uniform(0.05, 0.95)), rng.integers(3)
        parent = robot["links"][names.index(table.get("parent", names[i - 1]))]
        if kind == 2:
            parent.setdefault("markers", []).append({"name": f"m{i}", "at": s})
        table["at"] = ("base", {"s": s}, f"m{i}")[kind]
    return robot


RIGID = [(n, share) for share in (0.0, 0.6) for n in (1, 2, 3, 5, 8, 12)]


@pytest.mark.parametrize("kind", swept(RIGID, (1, 0.0), (3, 0.0), (8, 0.0), (3, 0.6), (8, 0.6)))
def test_rigid_robots_equal_pinocchio(kind):
    """ABA and RNEA of Pinocchio, beside which the oracle is judged too: axes, mounts, bodies, armature, springs,
    losses, tip wrenches; slides, branches, and links that are carried along others."""
    import pinocchio as pin

    n_links, share = kind
    limit = 1e8 if n_links < 8 else 1e9
    limits = dict(rigid=1.0, material=0.0, limit=limit, frame_at=0.3, sliding=share, branching=share)
    robots = rr.random_robot if share < 0.6 else lambda rng, n, **more: along(rng, rr.random_robot(rng, n, **more))
    case = drawn(500 + n_links, n_links, robots=robots, **limits)
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
    assert max(oracle.errors(case.state, expected, wrench).values()) <= case.tolerance
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
