"""A satellite whose two arms, with elastic gears, hold one object: a loop on a floating base."""

from __future__ import annotations

import numpy as np
from floating_robots import HULL

DRY = {"coulomb": 0.05, "viscous": 1e-3, "velocity": 0.2}
GEAR = {"ratio": 40.0, "rotor_inertia": 2e-4, "stiffness": 900.0}
RUBBED = {"ratio": 10.0, "rotor_inertia": 1e-3, "friction": DRY}
SECTION = {"rhoA": 1.5, "EIy": 300.0, "EIz": 400.0, "rhoIp": 1e-3}
OBJECT = {"at": "base", "mass": 6.0, "com": [0.1, 0.3, 0.02], "inertia": [0.6, 0.2, 0.7, 0.01, 0.0, 0.02]}
TAU = (0.02, -0.5, 0.4, 0.3, 0.02, 0.2, -0.4, 0.2)
"""At the rotor of each shoulder's first axis, else at the joint."""


def arm(side: str, y: float, friction: bool) -> list[dict]:
    """Two flexible links with two axes each, the first of them with an elastic gear."""
    gear = GEAR | ({"friction": DRY, "damping": 2.0} if friction else {})
    shoulder = {"axes": ["z", "y"], "mount": {"xyz": [0.2, y, 0.0]}, "drives": [gear, RUBBED if friction else {}]}
    part = {"length": 0.7, "section": SECTION, "modes": {"bending_y": 1, "bending_z": 1}}
    upper = {"name": side, "parent": "hull", "joint": shoulder, **part}
    return [upper, {"name": f"{side}_fore", "parent": side, "joint": {"axes": ["y", "x"]}, **part}]


def dual_arm(friction: bool = True) -> dict:
    """The object is welded to the left hand; the loop is the right hand's grip on it. Without friction no damping."""
    hold = {"axes": [], "mount": {"xyz": [0.0, -0.6, 0.0]}}
    held = {"name": "object", "parent": "left_fore", "joint": hold, "bodies": [OBJECT]}
    return {
        "name": "dual_arm",
        "gravity": [0.0, 0.0, 0.0],
        "base": "floating",
        "links": [
            {"name": "hull", "joint": {"axes": []}, "bodies": [HULL]},
            *arm("left", 0.3, friction),
            held,
            *arm("right", -0.3, friction),
        ],
        "loops": [{"between": ["object.tip", "right_fore.tip"], "joint": {"axes": []}}],
    }


def start(model, seed: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """A closed posture without pattern, gears without load, and rates that keep the loop closed."""
    from screwgen import assemble
    from screwgen.backends.numpy.closing import moving

    rng, chain, p = np.random.default_rng(seed), model.chain, model.parameter_values
    q, v = np.array(chain.home), 0.3 * rng.normal(size=chain.nv)
    q[:3], turn = rng.normal(size=3), rng.normal(size=4)
    q[3:7] = turn / np.linalg.norm(turn)
    joints = np.array([0.3, -0.7, 1.1, 0.2, -0.1, -0.4, 0.6, 0.3])
    q[7 : chain.eta_q] = chain.relaxed(joints, p)
    rotors = slice(chain.base_v + chain.n_joints, chain.eta_v)
    v[rotors] = chain.relaxed(v[6 : 6 + chain.n_joints], p)[chain.n_joints :]
    v[chain.eta_v :] = 0.02 * rng.normal(size=chain.n_modes)
    q = assemble(model, q)
    return q, moving(model.numpy(), q, v)
