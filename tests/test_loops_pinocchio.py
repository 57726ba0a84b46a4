"""Loops of rigid robots against Pinocchio's constraint dynamics: accelerations, and the forces of the loops."""

import numpy as np
import pytest
import random_robots as rr
from helpers import arm, link, model_of, relative
from mixed_loops import Loops, bridged
from oracle import Oracle
from oracle_robots import pinocchio_model

BALL = ["x", "y", "z"]


def closed(*links, tips, joint) -> dict:
    return arm(*links) | {"loops": [{"between": [f"{tip}.tip" for tip in tips], "joint": {"axes": joint}}]}


def on_the_ground(part: dict, x: float) -> dict:
    part["joint"]["mount"] = {"xyz": [x, 0.0, 0.0]}
    return part | {"parent": "world"}


def four_bar() -> tuple[dict, np.ndarray]:
    """A parallelogram in the x-z plane with a ball joint: its place across the plane is redundant."""
    bars = (
        link("crank", 0.3, "y", 2.0),
        link("coupler", 0.8, "y", 1.5),
        on_the_ground(link("rocker", 0.3, "y", 1.8), 0.8),
    )
    return closed(*bars, tips=("coupler", "rocker"), joint=BALL), np.array([-0.7, 0.7, -0.7])


def slider_crank() -> tuple[dict, np.ndarray]:
    crank, rod = link("crank", 0.15, "y", 4.0), link("rod", 0.3, "y", 1.0)
    slider = on_the_ground(link("slider", 0.1, [{"slide": "x"}], 9.0), 0.2)
    angle, q = 0.8, np.zeros(3)
    q[0], tilt = -angle, np.arcsin(0.5 * np.sin(angle))
    q[1], q[2] = angle + tilt, 0.15 * np.cos(angle) + 0.3 * np.cos(tilt) - 0.3
    return closed(crank, rod, slider, tips=("rod", "slider"), joint=BALL), q


def spatial(seed: int, joint: list) -> tuple[dict, np.ndarray]:
    """A random tree of rigid links with slides and screws, and a loop that is closed in its state.

    Seeds whose trees are numbered branch by branch, as Pinocchio's sparse factorisation needs them, and of full rank.
    """
    rng = np.random.default_rng([14, seed])
    rigid = {"rigid": 1.0, "material": 0.0, "frame_at": 0.0, "welded": 0.0, "drives": 0.0}
    tree, state, oracle = rr.draw_regular(rng, 5, **rigid, sliding=0.3, branching=0.5)
    robot, _ = bridged(rng, joint, tree, state, oracle)
    return robot, np.array(state["q"])


CASES = {
    "four-bar": four_bar,
    "slider-crank": slider_crank,
    "spatial, ball": lambda: spatial(3, BALL),
    "spatial, weld": lambda: spatial(5, []),
}


def constrained(robot: dict, oracle: Oracle, q, v, tau) -> tuple[np.ndarray, np.ndarray]:
    """Pinocchio's accelerations, and the wrench [τ; F] on the loop's first tip, in its frame."""
    pin, model, found = pinocchio_model(robot)
    model.gravity.linear, model.armature = np.array(robot["gravity"]), oracle.armature
    names, (loop,) = [x["name"] for x in robot["links"]], robot["loops"]
    ends = []
    for end in loop["between"]:
        k = names.index(end.removesuffix(".tip"))
        carrier, place = found[k]
        ends += [carrier, place * pin.SE3(np.eye(3), np.array([robot["links"][k]["length"], 0.0, 0.0]))]
    kind = pin.ContactType.CONTACT_6D if not loop["joint"]["axes"] else pin.ContactType.CONTACT_3D
    rows = pin.StdVec_RigidConstraintModel()
    rows.append(pin.RigidConstraintModel(kind, model, *ends, pin.ReferenceFrame.LOCAL))
    kept = pin.StdVec_RigidConstraintData()
    kept.append(rows[0].createData())
    data = model.createData()
    pin.initConstraintDynamics(model, data, rows, kept)
    force = tau - oracle.damping * v - oracle.K @ q
    vdot = pin.constraintDynamics(model, data, q, v, force, rows, kept, pin.ProximalSettings(1e-14, 1e-10, 50))
    found = kept[0].contact_force
    return np.array(vdot), np.array([*found.angular, *found.linear])


@pytest.mark.parametrize("name", CASES)
def test_accelerations_and_forces_are_pinocchios(name):
    robot, q = CASES[name]()
    oracle, rng = Oracle(robot), np.random.default_rng(5)
    loops = Loops(oracle, robot)
    v, tau = loops.moving(q, rng.normal(size=len(q))), rng.normal(size=len(q))
    assert np.max(np.abs(loops.rows(q, v)[0].full())) < 1e-12
    expected, wrench = constrained(robot, oracle, q, v, tau)
    numeric, still = model_of(robot).numpy(), np.zeros((oracle.n, 6))
    assert relative(numeric.forward_dynamics(q, v, tau, still)[0], expected) < 1e-10
    tip = [x["name"] for x in robot["links"]].index(robot["loops"][0]["between"][0].removesuffix(".tip"))
    assert relative(numeric.loop_wrenches(q, v, tau, still)[tip], wrench) < 1e-10
