"""Joints without rotors that carry links which bend: what a loop of control on them asks of a time step.

Let a joint move the inertia M while its links are held straight, and feel only J where they give way: for a bare beam
with three modes J is 1/400 of M, with a payload at its tip far less. A loop of control of the frequency ω, critically
damped, has `kd = 2 ω M`; a torque held over a step h changes the rate of J by `kd h / J` of it, which must be less
than 2. So `h < J / (ω M)`. A rotor of a hundredth of M allows 1.6 ms at 1 Hz.
"""

from __future__ import annotations

import numpy as np

from ..errors import SingularError
from ..robot_model import RobotModel
from ..simulation.mobility import stated_joints
from ..simulation.stable_steps import shown_time
from ..topology.chain import Chain

SLOW = 2 * np.pi
"""rad/s: the slowest loop of control that is of use, 1 Hz."""
SHORT = 1e-3
"""The step, s, at which such a loop should be stable."""
SPREAD = 0.7
"""Of the joints' coordinates, rad or m, in the second posture that is looked at."""


def light_joints(model: RobotModel) -> list[str]:
    """One line on the joints whose slowest useful loop of control needs steps below a millisecond, if there are any."""
    try:
        limits = steps_borne(model)
    except (SingularError, np.linalg.LinAlgError):  # said where the robot is simulated
        return []
    short = {name: h for name, h in limits.items() if h < SHORT}
    if not short:
        return []
    one = "carries links that bend and states no rotor"
    what = "carry links that bend and state no rotors" if len(short) > 1 else one
    worst = f"a loop of control of 1 Hz is stable up to steps of {shown_time(min(short.values()), 2)}"
    return [f"{', '.join(short)}: {what}; {worst}; state joint.armature or rotor_inertia where there are motors"]


def steps_borne(model: RobotModel) -> dict[str, float]:
    """For each axis without a rotor in front of modes the longest step, s, of a loop of 1 Hz; ball joints have none."""
    chain, rng = model.chain, np.random.default_rng(0)
    if not chain.n_modes:
        return {}
    out: dict[str, float] = {}
    p = np.array(model.parameter_values)
    for joints in (np.zeros(model.n_joints), SPREAD * rng.uniform(-1, 1, model.n_joints)):
        posture = np.array(chain.home)
        posture[np.array(chain.axis_places, int)[of_axes(chain)]] = joints[of_axes(chain)]
        q = np.array(chain.complete(posture[chain.base_q : chain.base_q + chain.n_redundant], p), float)
        M = model.numpy().mass_matrix(q)
        for j in _bare(model, q):
            own = [chain.base_v + j, *range(chain.eta_v, chain.nv)]
            felt = 1 / np.linalg.inv(M[np.ix_(own, own)])[0, 0]
            name = model.q_names[chain.axis_places[j]]
            out[name] = min(out.get(name, np.inf), float(felt / (SLOW * M[own[0], own[0]])))
    return out


def _bare(model: RobotModel, q: np.ndarray) -> list[int]:
    """The joints that a drive may move, without rotors and springs."""
    joints = [(link, k) for link in model.robot.links for k in range(link.joint.kind.torques)]
    stated = stated_joints(model, q, model.parameter_values)
    light = [not (link.joint.has_inertia(k) or link.joint.has_spring(k)) for link, k in joints]
    return [j for j in np.flatnonzero(of_axes(model.chain)).tolist() if stated[j] and light[j]]


def of_axes(chain: Chain) -> np.ndarray:
    """(n_joints,) of bool: the torques about or along axes, which may have rotors."""
    return np.isin(chain.base_v + np.arange(chain.n_joints), chain.flat_v)
