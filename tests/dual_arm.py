"""A satellite whose two arms, with elastic gears, hold one object: a loop on a floating base."""

from __future__ import annotations

import numpy as np
from floating_robots import HULL

from screwgen import assemble
from screwgen.backends.numpy.closing import moving

DRY = {"coulomb": 0.05, "viscous": 1e-3, "velocity": 0.2}
GEAR = {"ratio": 40.0, "rotor_inertia": 2e-4, "stiffness": 900.0, "damping": 2.0, "friction": DRY}
RUBBED = {"ratio": 10.0, "rotor_inertia": 1e-3, "friction": DRY}
SECTION = {"rhoA": 1.5, "EIy": 300.0, "EIz": 400.0, "rhoIp": 1e-3}
OBJECT = {"at": "base", "mass": 6.0, "com": [0.1, 0.3, 0.02], "inertia": [0.6, 0.2, 0.7, 0.01, 0.0, 0.02]}
POSTURE = {True: [0.3, -0.7, -0.1, -0.6], False: [0.3, -0.7, 1.1, 0.2, -0.1, -0.4, 0.6, 0.3]}


def arm(side: str, y: float, planar: bool) -> list[dict]:
    """Two links; the first axis has an elastic gear, and the upper link bends."""
    axes, wrist, drives = (["z"], ["z"], [GEAR]) if planar else (["z", "y"], ["y", "x"], [GEAR, RUBBED])
    part = {"length": 0.7, "section": SECTION}
    modes = {"bending_y": 1} if planar else {"bending_y": 1, "bending_z": 1}
    shoulder = {"axes": axes, "mount": {"xyz": [0.2, y, 0.0]}, "drives": drives}
    upper = {"name": side, "parent": "hull", "joint": shoulder, "modes": modes, **part}
    fore = {"name": f"{side}_fore", "parent": side, "joint": {"axes": wrist}, **part}
    return [upper, fore if planar else fore | {"modes": modes}]


def dual_arm(planar: bool = True) -> dict:
    """The object is welded to the left hand; the loop is the right hand's grip on it."""
    hold = {"axes": [], "mount": {"xyz": [0.0, -0.6, 0.0]}}
    held = {"name": "object", "parent": "left_fore", "joint": hold, "bodies": [OBJECT]}
    hull = {"name": "hull", "joint": {"axes": []}, "bodies": [HULL]}
    return {
        "name": "dual_arm",
        "gravity": [0.0, 0.0, 0.0],
        "base": "floating",
        "links": [hull, *arm("left", 0.4, planar), held, *arm("right", -0.35, planar)],
        "loops": [{"between": ["object.tip", "right_fore.tip"], "joint": {"axes": []}}],
    }


def torques(model) -> np.ndarray:
    """Small where they act on rotors."""
    return model.chain.at_efforts(0.5 * np.cos(1.0 + np.arange(model.n_tau)), model.parameter_values)


def start(model, seed: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """A closed posture without pattern, gears without load, and rates that keep the loop closed."""
    rng, chain, p = np.random.default_rng(seed), model.chain, model.parameter_values
    q, v = np.array(chain.home), 0.3 * rng.normal(size=chain.nv)
    q[:3], turn = rng.normal(size=3), rng.normal(size=4)
    q[3:7] = turn / np.linalg.norm(turn)
    q[7 : chain.eta_q] = chain.with_added(POSTURE[chain.n_joints == 4], p)
    v[6 : chain.eta_v] = chain.with_added(v[6 : 6 + chain.n_joints], p)
    v[chain.eta_v :] = 0.02 * rng.normal(size=chain.n_modes)
    return (q := assemble(model, q)), moving(model.numpy(), q, v)
