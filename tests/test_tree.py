"""The topology: what several links hand to one node is summed."""

import numpy as np
import pytest
from helpers import model_of

from screwgen.algorithms.fused import forward_dynamics, inverse_dynamics
from screwgen.ir.replay import run
from screwgen.topology.tree import Tree

SECTION = {"rhoA": 1.5, "EIy": 900.0, "EIz": 700.0}
BRANCHES = [
    {"axes": ["z"], "mount": {"xyz": [0.1, 0.0, 0.0]}},
    {"axes": ["y"], "mount": {"xyz": [0.0, -0.2, 0.1], "rpy": [0.3, 0.0, 0.2]}},
]


def rod(name: str, joint: dict, length=0.7, **more) -> dict:
    modes = {"bending_y": 2, "bending_z": 1}
    return {"name": name, "length": length, "section": SECTION, "modes": modes, "joint": joint, **more}


def arm(*links: dict):
    return model_of({"name": "tree", "gravity": [0.0, 1.0, -9.81], "links": list(links)})


def tree_of(model, parents):
    model.chain.tree = Tree(parents)
    return model


def energy_balance(model, q, v, tau):
    """Rate of the energy, by differences, less the power of the torques, W."""
    n, h = model.numpy(), 1e-6
    w_ext = np.zeros((model.n_links, 6))
    vdot = n.forward_dynamics(q, v, tau, w_ext)[0]
    ends = [sum(n.energy(q + s * h * v + h * h / 2 * vdot, v + s * h * vdot)) for s in (1, -1)]
    return (ends[0] - ends[1]) / (2 * h) - tau @ v[: model.n_joints]


@pytest.fixture
def forked():
    """A trunk with two branches at its tip."""
    branches = [rod(name, joint) for name, joint in zip(("left", "right"), BRANCHES, strict=True)]
    return tree_of(arm(rod("trunk", {"axes": ["y"]}), *branches), (-1, 0, 0))


def test_branches_that_are_stiff_and_welded_are_bodies_of_the_trunk():
    body = {"at": "tip", "mass": 0.8, "com": [0.1, 0.2, 0.0], "inertia": [0.01, 0.02, 0.02, 0.0, 0.0, 0.0]}
    other = {"at": "tip", "mass": 0.3, "com": [0.0, -0.1, 0.2]}
    bodies = {"a": body, "b": other}
    welded = [{"name": n, "joint": {"axes": []}, "bodies": [b | {"at": "base"}]} for n, b in bodies.items()]
    trunk = rod("trunk", {"axes": ["y", "z"]})
    tree = tree_of(arm(trunk, *welded), (-1, 0, 0))
    chain = arm(trunk | {"bodies": [body, other]})
    rng = np.random.default_rng(0)
    q, v, tau = 0.2 * rng.normal(size=chain.nq), rng.normal(size=chain.nq), rng.normal(size=2)
    found = tree.numpy().forward_dynamics(q, v, tau, np.zeros((3, 6)))[0]
    expected = chain.numpy().forward_dynamics(q, v, tau, np.zeros((1, 6)))[0]
    assert np.allclose(found, expected, rtol=1e-11)


def test_the_energy_of_a_fork_changes_by_the_power_of_its_torques(forked):
    rng = np.random.default_rng(1)
    size = np.r_[np.ones(3), np.full(forked.nq - 3, 1e-3)]  # the modes are fast: differences see small motions of them
    q, v, tau = size * rng.normal(size=forked.nq), size * rng.normal(size=forked.nq), 5 * rng.normal(size=3)
    assert abs(energy_balance(forked, q, v, tau)) < 1e-4 * abs(tau @ v[:3])


def test_the_mass_matrix_of_a_fork_couples_its_branches_through_the_trunk_alone(forked):
    M = forked.numpy().mass_matrix(np.zeros(forked.nq))
    assert np.allclose(M, M.T, atol=1e-12) and np.linalg.eigvalsh(M).min() > 0
    assert M[1, 2] == 0.0 and np.all(M[6:9, 9:12] == 0.0) and np.any(M[0, 6:] != 0.0)


def test_fused_programs_follow_the_tree(forked):
    rng = np.random.default_rng(2)
    q, v, tau = 0.05 * rng.normal(size=forked.nq), rng.normal(size=forked.nq), rng.normal(size=3)
    expected = forked.numpy().forward_dynamics(q, v, tau, np.zeros((3, 6)))[0]
    unary = lambda op, x: getattr(np, {"neg": "negative"}.get(op, op), _stumpff(op))(x)  # noqa: E731
    given = {"q": list(q), "v": list(v), "tau": list(tau), "w_ext": [0.0] * 18, "p": forked.parameter_values}
    found = run(forward_dynamics(forked.chain), given, unary)[0]["vdot"]
    assert np.allclose(found, expected, rtol=1e-10)
    back = run(inverse_dynamics(forked.chain), given | {"vdot": list(found)}, unary)[0]["force"]
    assert np.allclose(back, [*tau, *np.zeros(9)], atol=1e-12 * abs(expected).max())


def _stumpff(op: str):
    from screwgen.backends.numpy import python

    return getattr(python, op, None)


def test_a_child_must_come_after_its_parent():
    with pytest.raises(ValueError, match="must come after"):
        Tree((-1, 2, 0))
