"""A satellite with two arms, states of it, and the momentum of a robot with a floating base."""

import numpy as np
from helpers import rotation_of
from scipy.spatial.transform import Rotation

TAU = (0.3, -0.2, 0.1, 0.2)
SECTION = {"rhoA": 1.5, "EIy": 60.0, "EIz": 80.0, "rhoIp": 1e-3}
HULL = {"at": "base", "mass": 8.0, "com": [0.1, 0.05, 0.0], "inertia": [0.5, 0.6, 0.7, 0.02, 0.0, 0.0]}


def rod(name: str, axes: list, **more) -> dict:
    joint = {"axes": axes, **({"mount": more.pop("mount")} if "mount" in more else {})}
    modes = {"bending_y": 1, "bending_z": 1}
    return {"name": name, "length": 0.7, "section": SECTION, "modes": modes, "joint": joint, **more}


SATELLITE = {
    "name": "satellite",
    "gravity": [0.0, 0.0, 0.0],
    "base": "floating",
    "links": [
        {"name": "hull", "joint": {"axes": []}, "bodies": [HULL]},
        rod("left", ["z"], parent="hull", mount={"xyz": [0.0, 0.3, 0.0]}),
        rod("left_fore", ["y"]),
        rod("right", ["z", "x"], parent="hull", mount={"xyz": [0.0, -0.3, 0.0]}),
    ],
}


def start(model, rate=0.3) -> tuple[np.ndarray, np.ndarray]:
    """A posture and rates without pattern."""
    rng, chain = np.random.default_rng(3), model.chain
    q, v = np.array(chain.home), rate * rng.normal(size=chain.nv)
    q[:3], q[3:7] = rng.normal(size=3), Rotation.random(random_state=3).as_quat(scalar_first=True)
    q[7 : chain.eta_q] = rng.uniform(-1, 1, chain.n_joints)
    q[chain.eta_q :], v[chain.eta_v :] = 0.01 * rng.normal(size=chain.n_modes), 0.05 * rng.normal(size=chain.n_modes)
    return q, v


def momentum(model, q, v) -> np.ndarray:
    """Angular momentum about the inertial origin, and linear momentum, in inertial axes: of the base's rows of M v."""
    h = (model.numpy().mass_matrix(q) @ v)[:6]
    R = rotation_of(q[3:7])
    return np.concatenate([R @ h[:3] + np.cross(q[:3], R @ h[3:]), R @ h[3:]])
