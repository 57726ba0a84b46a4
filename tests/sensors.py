"""What the sensors of a filter say in a state of a robot; no filter has a part in it."""

import numpy as np
from scipy.spatial.transform import Rotation

from screwgen.algorithms.gauges import gauges
from screwgen.bodies.markers import displacement
from screwgen.runtime.estimator import Noise


def felt(robot, q, v, tau, w_ext) -> np.ndarray:
    """What an accelerometer at the tip feels, by the inertial acceleration of the linear model's outputs."""
    a = robot.linearise(q, v, tau, w_ext, outputs=["tip_acceleration"]).y
    return robot.numpy().tip_pose(q)[0].T @ (a - robot.robot.gravity)


def strains(robot, q, fibre: float) -> list[float]:
    """Of fibres at the bases of links, by deflections at two sections near these: ``w / s^2 = w'' / 2 + O(s)``."""
    chain, out = robot.chain, []
    for g in gauges(chain):
        i, axis, s = chain.firsts[g.link], "xyz".index(g.direction[-1]), np.array([1e-3, 2e-3])
        eta = q[chain.eta_q + chain.eta_offset[i] :][: chain.keys[i].modes]
        near, far = displacement(chain.keys[i], tuple(s))[:, axis] @ eta / s**2
        out.append(-fibre * 2 * (2 * near - far) / robot.robot.links[g.link].length ** 2)
    return out


def measured(robot, q, v, tau, w_ext, rng, noise: Noise, accelerometer=True) -> dict:
    """Measurements by their names, with their noise."""
    chain = robot.chain
    flat = dict(zip(chain.flat_v.tolist(), chain.flat_q.tolist(), strict=True))
    turns = q[[flat[k] for k in chain.effort_places if k in flat]]
    z = {"encoder": turns, "strain": strains(robot, q, noise.fibre)}
    if accelerometer:
        z["acceleration"] = felt(robot, q, v, tau, w_ext)
    z = {name: exact + getattr(noise, name) * rng.normal(size=len(exact)) for name, exact in z.items()}
    if chain.floating:
        z["base_position"] = q[:3] + noise.base_position * rng.normal(size=3)
        z["base_attitude"] = -seen(q[3:7], noise.base_attitude, rng)
        z["base_rate"] = v[:3] + noise.base_rate * rng.normal(size=3)
    balls = [part for part in chain.curved if not part.joint.in_space]
    if balls:
        turns = [seen(q[part.q], noise.joint_attitude, rng) for part in balls]
        z["joint_attitude"] = np.concatenate(turns)
        rates = np.concatenate([v[part.v] for part in balls])
        z["joint_rate"] = rates + noise.joint_rate * rng.normal(size=len(rates))
    return z


def seen(quaternion, deviation: float, rng) -> np.ndarray:
    """An attitude as a sensor sees it, turned by noise about axes of the link."""
    turn = Rotation.from_rotvec(deviation * rng.normal(size=3))
    return (Rotation.from_quat(quaternion, scalar_first=True) * turn).as_quat(scalar_first=True)
