"""Poses, tip twists, Jacobian and gravity torques of the generated C against the other back ends."""

import ctypes
from functools import cache

import numpy as np
import pytest
from c_robots import strange
from helpers import Model, example, model_of, quick
from varying_robots import tapered_arm

from screwgen.studies.equilibrium import equilibrium

MODELS = {
    "ella": lambda: example("ella"),
    "strange": lambda: model_of(strange()),
    "tapered": lambda: model_of(tapered_arm(stiff=20.0, springs=False)),
}


class Posture:
    """The functions of `<robot>_posture.c` on NumPy arrays, called as C calls them."""

    def __init__(self, model: Model):
        self.model, self.name = model, model.robot.name
        self.library = quick(model).library
        self.parameters, self.constants, self.chain = (ctypes.create_string_buffer(1 << 18) for _ in range(3))
        self.call("parameters_default", self.parameters)
        assert self.call("prepare", self.parameters, self.constants) == 0

    def call(self, function: str, *given) -> int:
        taken = [ctypes.c_void_p(x.ctypes.data) if isinstance(x, np.ndarray) else x for x in given]
        return getattr(self.library, f"{self.name}_{function}")(*taken)

    def motion(self, q, v) -> tuple[list[np.ndarray], np.ndarray]:
        """Rotations and positions of links and of tips, tip twists; and the Jacobian."""
        n, nv = self.model.n_links, self.model.nq
        motion, J = np.zeros(30 * n), np.zeros((6, nv))
        assert self.call("tip_jacobian", self.constants, np.concatenate([q, v]), self.chain, motion, J) == 0
        parts = np.split(motion, np.cumsum([9 * n, 3 * n, 9 * n, 3 * n]))
        return [x.reshape(n, *shape) for x, shape in zip(parts, ((3, 3), (3,), (3, 3), (3,), (6,)), strict=True)], J

    def gravity(self, q, w_ext) -> tuple[np.ndarray, np.ndarray]:
        """The forces and the coordinates of rest at the joint angles of q."""
        nv, m = self.model.nq, self.model.n_joints
        state, force = np.concatenate([q, np.ones(nv)]), np.zeros(nv)
        given = np.concatenate([np.zeros(max(m, 1)), np.ravel(w_ext)])
        assert self.call("gravity", self.constants, state, given, self.chain, force, state) == 0
        assert not state[nv:].any()
        return force, state[:nv]


@cache
def posture(name: str) -> Posture:
    return Posture(MODELS[name]())


def state(model: Model) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(11)
    scale = np.where(np.arange(model.nq) < model.n_joints, 1.0, 1e-2)
    return rng.normal(size=model.nq) * scale, rng.normal(size=model.nq) * scale


every_robot = pytest.mark.parametrize("name", MODELS)


@every_robot
def test_poses_are_those_of_numpy(name):
    p = posture(name)
    q, v = state(p.model)
    (R, r, R_T, r_T, _), _ = p.motion(q, v)
    judge = p.model.numpy()
    for found, expected in zip((R, r, R_T, r_T), (*judge.link_pose(q), *judge.tip_poses(q)), strict=True):
        assert np.allclose(found, expected, rtol=0, atol=1e-13)


@every_robot
def test_jacobian_and_twists_are_the_rates_of_the_poses(name):
    """Central differences of every tip's pose along v; the last tip's twist is J v."""
    p = posture(name)
    q, v = state(p.model)
    (_, _, R_T, _, twist), J = p.motion(q, v)
    h = 1e-6
    (ahead, behind) = (p.motion(q + s * h * v, v)[0] for s in (1, -1))
    assert np.allclose((ahead[3] - behind[3]) / (2 * h), twist[:, 3:], rtol=0, atol=1e-8)
    spin = (ahead[2] - behind[2]) / (2 * h) @ R_T.transpose(0, 2, 1)
    assert np.allclose(np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], 1), twist[:, :3], rtol=0, atol=1e-8)
    assert np.allclose(J @ v, twist[-1], rtol=0, atol=1e-12)


def test_gravity_of_a_limp_arm_says_what_it_leaves():
    """Links that sag by a tenth of their length: the rounds do not converge, and the modal forces tell."""
    p, m = posture("strange"), posture("strange").model.n_joints
    force, _ = p.gravity(np.zeros(p.model.nq), np.zeros((p.model.n_links, 6)))
    assert np.max(np.abs(force[m:])) > 1.0


@pytest.mark.parametrize("name", ["ella", "tapered"])
def test_gravity_is_the_equilibrium_of_held_joints(name):
    """The torques and modal coordinates of the search for rest, in one call."""
    p, model = posture(name), posture(name).model
    m, w_ext = model.n_joints, np.zeros((model.n_links, 6))
    w_ext[-1] = [0.1, -0.2, 0.1, 1.0, -2.0, 0.5]
    q = np.append(np.linspace(0.4, 1.0, m), np.zeros(model.nq - m))
    for wrenches in (0 * w_ext, w_ext):
        force, at = p.gravity(q, wrenches)
        rest = equilibrium(model, q[:m], w_ext=wrenches, hold=True)
        assert np.allclose(force[:m], rest.tau, rtol=0, atol=1e-6 * np.max(np.abs(rest.tau)))
        assert np.allclose(at, rest.q, rtol=0, atol=1e-6 * np.max(np.abs(rest.q[m:])))
        assert np.max(np.abs(force[m:])) < 1e-6 * np.max(np.abs(rest.wrench[:, 3:]))


def test_statuses():
    """Null pointers are bad arguments; what is not finite is said, and the state stays as it was."""
    p = posture("ella")
    nv, n = p.model.nq, p.model.n_links
    x, motion, force = np.zeros(2 * nv), np.zeros(30 * n), np.zeros(nv)
    u, J = np.zeros(p.model.n_joints + 6 * n), np.zeros(6 * nv)
    for k in range(4):
        given = [p.constants, x, p.chain, motion]
        given[k] = None
        assert p.call("kinematics", *given) == p.call("tip_jacobian", *given, J) == 3
    x[0] = np.nan
    assert p.call("kinematics", p.constants, x, p.chain, motion) == 1
    assert p.call("tip_jacobian", p.constants, x, p.chain, motion, J) == 1
    assert p.call("gravity", p.constants, x, u, p.chain, force, x) == 1 and np.isnan(x[0])
    assert p.call("gravity", p.constants, x, u, p.chain, None, x) == 3
