"""Every documented frame is true: what nodes, links and calls hold, against the oracle in the frame that is stated."""

import numpy as np
import pytest
import random_robots as rr
from helpers import EPS, Case, model_of

from screwgen.algorithms import fused
from screwgen.algorithms.functions import DAE_FORWARD, FORWARD, MOTION, PLACEMENT, nodes
from screwgen.algorithms.schedule import execute
from screwgen.algorithms.signals import CALL, CARRIER, F_I, INERTIAL, NODE, STORE, TIP
from screwgen.backends.numpy.numeric import function_of


@pytest.fixture(scope="module")
def case() -> Case:
    rng = np.random.default_rng(11)
    robot, state, oracle = rr.draw_regular(rng, 3, torsion=1.0, rigid=0.0, frame_at=1.0)
    return Case(robot, state, oracle, model_of(robot))


class Frames:
    """Rotations of the frames of link i, and its vectors in the inertial frame, all from the oracle."""

    def __init__(self, case: Case, i: int, vdot):
        q, v, _, _ = case.inputs
        poses, h = case.oracle.poses(q), 1e-6
        self.axes = {INERTIAL: np.eye(3), F_I: poses["R"][i], TIP: poses["tip_R"][i], CARRIER: poses["R"][i]}
        link, tip = case.oracle.link_twists(q, v)[i], case.oracle.tip_twists(q, v)[i]
        R, R_T = poses["R"][i], poses["tip_R"][i]
        self.vectors = {
            "R": R,
            "tip R": R_T,
            "r": poses["origin"][i],
            "tip r": poses["tip_point"][i],
            "twist": np.r_[R @ link[:3], R @ link[3:]],
            "tip twist": np.r_[R_T @ tip[:3], R_T @ tip[3:]],
        }
        ends = [self._tip(case, i, q + s * h * v, v + s * h * vdot) for s in (1, -1)]
        gravity = np.r_[np.zeros(3), case.robot["gravity"]]
        self.vectors["tip acceleration"] = (ends[0] - ends[1]) / (2 * h) - gravity

    def _tip(self, case: Case, i: int, q, v):
        R, twist = case.oracle.poses(q)["tip_R"][i], case.oracle.tip_twists(q, v)[i]
        return np.r_[R @ twist[:3], R @ twist[3:]]

    def seen(self, name: str, frame: str):
        """A vector, twist or rotation in the axes of a frame."""
        axes, value = self.axes[frame], self.vectors[name]
        return axes.T @ value if value.shape != (6,) else np.r_[axes.T @ value[:3], axes.T @ value[3:]]


@pytest.fixture(scope="module")
def vdot(case):
    return case.model.numpy().forward_dynamics(*case.inputs)[0]


def run(case: Case, algorithm, *parts):
    """The stores of the links and the nodes after an algorithm on floats."""
    model, apply = case.model, lambda _, __, program, inputs: function_of(program)(inputs, EPS)[0]
    prepare = lambda _, program, inputs: function_of(program)(inputs, EPS)[0]  # noqa: E731
    links = fused.prepared(model.chain, model.parameter_values, prepare, (algorithm,))
    for part in parts:
        links = [a | b for a, b in zip(links, part, strict=True)]
    places = nodes(model.chain, case.robot["gravity"])
    return execute(model.chain, algorithm, links, places, apply), places


def joint_state(case: Case) -> list[dict]:
    chain, (q, v, tau, w_ext) = case.model.chain, case.inputs
    numeric = case.model.numpy()
    state = [a | b for a, b in zip(chain.split(q, "q", "eta"), chain.split(v, "qdot", "etadot"), strict=True)]
    torques = chain.split(np.r_[tau, np.zeros(chain.n_modes)], "tau", "none")
    for i, (link, torque) in enumerate(zip(state, torques, strict=True)):
        link |= {"tau": torque["tau"], "w_ext": list(w_ext[i]), "gravity": case.robot["gravity"]}
        for part, names in (("eta", ("M_eta", "K", "D")), ("q", ("M_q", "K_q", "D_q"))):
            if names[0] in numeric.constants[i]:
                M, K, D = (numeric.constants[i][name] for name in names)
                pairs = zip(K, link[part], D, link[f"{part}dot"], strict=True)
                link |= {f"m_{part}": list(M), f"f_{part}": [k * a + d * b for k, a, d, b in pairs]}
    return state


def check(found, kind, name, frames, vector, tolerance=1e-9):
    expected = frames.seen(vector, kind[name].frame)
    assert np.shape(found) == (expected.size,)
    assert np.allclose(found, expected.ravel(), rtol=0, atol=tolerance * max(1.0, abs(expected).max())), name


def test_frames_of_the_joint_form(case, vdot):
    stores, places = run(case, FORWARD, joint_state(case))
    for i, link in enumerate(stores):
        frames, node = Frames(case, i, vdot), places[i + 1]
        expected = frames.seen("tip twist", NODE["omega"].frame)
        assert np.allclose(node["omega"], expected[:3], atol=1e-10)
        check(node["R_T"], NODE, "R_T", frames, "tip R")
        total = np.add(node["acc_0"], node["delta"])
        check(total, NODE, "delta", frames, "tip acceleration", 1e-5)
        assert np.allclose(link["motion"][:2], frames.seen("twist", CALL["motion"].frame)[1:3], atol=1e-10)


def test_frames_of_poses_and_twists(case, vdot):
    stores, places = run(case, MOTION, joint_state(case))
    for i, link in enumerate(stores):
        frames, node = Frames(case, i, vdot), places[i + 1]
        twist = frames.seen("tip twist", NODE["omega_T"].frame)
        assert np.allclose(node["omega_T"], twist[:3], atol=1e-10) and np.allclose(node["v_T"], twist[3:], atol=1e-10)
        check(link["tip_twist"], CALL, "tip_twist", frames, "tip twist")
        for name in ("R", "r"):
            check(link[name], CALL, name, frames, name)
            check(node[name], NODE, name, frames, f"tip {name}")


def test_frames_of_the_dae_form(case, vdot):
    placed, places = run(case, PLACEMENT, joint_state(case))
    state = [
        link | {name: found[f"new_{name}"] for name in ("quaternion", "position", "twist")}
        for link, found in zip(joint_state(case), placed, strict=True)
    ]
    stores, moving = run(case, DAE_FORWARD, state)
    for i, link in enumerate(stores):
        frames = Frames(case, i, vdot)
        check(placed[i]["new_twist"], CALL, "new_twist", frames, "twist")
        check(placed[i]["new_position"], CALL, "new_position", frames, "r")
        for name, part in (("omega", slice(0, 3)), ("v", slice(3, 6))):
            expected = frames.seen("tip twist", NODE[name].frame)[part]
            assert np.allclose(moving[i + 1][name], expected, atol=1e-9), name
            expected = frames.seen("tip twist", NODE[f"{name}_T"].frame)[part]
            assert np.allclose(places[i + 1][f"{name}_T"], expected, atol=1e-9), name
        wrench = case.oracle.wrenches(case.inputs[0], case.inputs[1], vdot, case.inputs[3])[i]
        assert np.allclose(link["wrench"], wrench, rtol=0, atol=1e-7 * abs(wrench).max())


def test_every_signal_states_unit_frame_and_meaning():
    for kind in (NODE, CALL, STORE):
        for name, signal in kind.items():
            assert signal.unit and signal.frame and signal.meaning, name
            assert signal.comment.isascii() and "_" not in signal.meaning.replace("F_i", ""), name
