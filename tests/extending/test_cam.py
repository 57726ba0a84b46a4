"""A coupling that the product does not contain: an axis that follows another by a cam."""

from dataclasses import dataclass

import numpy as np
import pytest
from helpers import arm, link, model_of, relative
from outside import Outside, every_check

from screwgen import Robot, RobotFileError, UsageError, assemble, dump, simulate
from screwgen.interchange.urdf_write import export_urdf


@dataclass(frozen=True)
class Cam:
    """``f(x) = x + lift sin(x)``."""

    lift: float
    words: str = "cam"

    def position(self, t, x):
        return x + self.lift * t.call("sin", x)


SOFT = {"modes": {"bending_y": 1}, "section": {"EIz": 300.0}}
RATIO, OFFSET = -0.8, 0.1


def coupled(relation, **more):
    """Two arms side by side; the second follows the first."""
    first = link("left", 0.7, ("z",), joint={"armature": [0.02], "damping": [0.1]}, **SOFT)
    second = link("right", 0.5, ("z",), joint={"armature": [0.03], "mount": {"xyz": [0.0, 0.3, 0.0]}}, **SOFT)
    more = {"axis": "right.joint[0]", "of": "left.joint[0]", "ratio": RATIO, "offset": OFFSET, **more}
    couplings = [more | ({} if relation is None else {"relation": relation})]
    robot = arm(first, second | {"parent": "world"}, gravity=(0.0, -3.0, 0.0), couplings=couplings)
    return model_of(robot)


MODEL = coupled(Cam(0.3))


def state(model=MODEL, angle=0.7, rate=0.9):
    """On the cam, with the modes bent."""
    slope = RATIO * (1 + 0.3 * np.cos(angle))
    q = np.array([angle, RATIO * (angle + 0.3 * np.sin(angle)) + OFFSET, 0.01, -0.02])
    return q, np.array([rate, slope * rate, 0.1, 0.2]), np.array([1.5, -0.4]), np.zeros((2, 6))


@pytest.fixture(scope="module")
def reduced():
    """With ``v = B u`` the equations are ``Bᵀ M B u̇ = Bᵀ (F - M Ḃ u)``, M and F those of the arms without the cam."""
    tree = type(MODEL)(MODEL.robot.model_copy(update={"couplings": ()}))
    q, v, tau, w_ext = state()
    B = np.zeros((4, 3))
    B[0, 0] = B[2, 1] = B[3, 2] = 1.0
    B[1, 0] = RATIO * (1 + 0.3 * np.cos(q[0]))
    drift = np.array([0.0, -RATIO * 0.3 * np.sin(q[0]) * v[0] ** 2, 0.0, 0.0])
    M, force = tree.numpy().mass_matrix(q), np.r_[tau, 0.0, 0.0] - tree.numpy().bias(q, v, w_ext)
    vdot = B @ np.linalg.solve(B.T @ M @ B, B.T @ (force - M @ drift)) + drift
    return Outside(MODEL, (q, v, tau, w_ext), vdot), (M @ vdot - force)[:2]


@every_check
def test_it_moves_as_the_reduced_equations_say(reduced, check):
    reduced[0].holds(check)


def test_its_torques_do_no_work(reduced):
    case, torques = reduced
    assert relative(MODEL.numpy().coupling_torques(*case.given), torques) < 1e-9
    assert torques @ case.given[1][:2] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_a_run_stays_on_the_cam_and_keeps_its_energy(backend):
    q, v, *_ = state(angle=0.4)
    model = coupled(Cam(0.3))
    run = simulate(model, 0.5, 2.5e-4, q0=q, v0=v, integrator="rk4", backend=backend)
    assert np.abs(run.q[:, 1] - RATIO * (run.q[:, 0] + 0.3 * np.sin(run.q[:, 0])) - OFFSET).max() < 1e-8
    lost = 0.1 * np.sum((run.v[1:, 0] ** 2 + run.v[:-1, 0] ** 2) / 2 * np.diff(run.t))
    energy = run.energy.sum(axis=1)
    assert energy[0] - energy[-1] == pytest.approx(lost, rel=1e-3)


def test_a_posture_is_found_on_the_cam():
    q = assemble(MODEL, [0.9, 0.0], hold=["left.joint[0]"])
    assert q[1] == pytest.approx(RATIO * (0.9 + 0.3 * np.sin(0.9)) + OFFSET, abs=1e-12)


def test_what_is_no_relation_is_refused_and_files_cannot_state_one():
    table = {"axis": "right.joint[0]", "of": "left.joint[0]"}
    links = [link("left"), link("right", parent="world")]
    with pytest.raises(RobotFileError, match=r"couplings\[0\].relation: is 3; it must be a Python object"):
        Robot(**arm(*links, couplings=[table | {"relation": 3}]))
    with pytest.raises(UsageError, match=r"couplings\[0\]: relation is an object made in Python"):
        dump(MODEL.robot)
    assert "right.joint[0] = -0.8 cam(left.joint[0]) + 0.1" in MODEL.chain.closing.rows[0].text


def test_a_urdf_says_that_it_lacks_the_relation():
    found = export_urdf(MODEL.robot)
    assert "<mimic" not in found.text and "right.joint[0]: a coupling by a relation is left out" in "\n".join(
        found.notes
    )
