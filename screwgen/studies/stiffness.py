"""The stiffness of a robot: of joint springs, gears and modes."""

from __future__ import annotations

import numpy as np

from ..algorithms.axis_laws import of_robot
from ..algorithms.columns import columns
from ..algorithms.law_programs import forces, on_arrays
from ..arguments import Numbers
from ..backends.numpy.travel_numbers import travels
from ..ir.replay import run
from ..robot_model import RobotModel


def stiffness(model: RobotModel, p: Numbers | None = None) -> np.ndarray:
    """The stiffness of joint springs (N·m/rad) and of modes (N/m, torsion: N·m/rad), (nv,); of rotors zero.

    A floating base, whose six entries come first, has none.
    """
    given = np.array(model.parameter_values if p is None else p, float)
    return model.once_for("stiffness", given, lambda: _stiffness(model, given)).copy()


def _stiffness(model: RobotModel, p: np.ndarray) -> np.ndarray:
    values = dict(zip(model.parameter_names, p, strict=True))
    springs = [
        values.get(f"{link.name}.joint.stiffness[{j}]", 0.0)
        for link in model.robot.links
        for j in range(len(link.joint.axes))
    ]
    modal = (k for constants in model.numpy(p).constants for k in constants["K"])
    chain = model.chain
    return np.array([*[0.0] * chain.base_v, *springs, *[0.0] * chain.n_added, *modal], float)


def added_stiffness(model: RobotModel, p: Numbers | None = None) -> list[float]:
    """The stiffness of each elastic gear at its joint, N·m/rad, of slides N/m."""
    return [k for constants in model.numpy(p).constants for k in constants.get("K_theta", ())]


def stiffness_matrix(model: RobotModel, p: Numbers | None = None, relative: bool = False) -> np.ndarray:
    """The stiffness (nv, nv) of joint springs and gears (N·m/rad) and modes (N/m, torsion: N·m/rad).

    `relative`: in coordinates in which gears act on rotors alone, those of rotors whose motion is given excepted; see
    the function of that name.
    """
    K, first = np.diag(stiffness(model, p)), model.chain.eta_v - model.chain.n_added
    springs = added_stiffness(model, p)
    ratios = model.chain.ratios(model.parameter_values if p is None else p)
    joints = (model.chain.base_v + joint for joint in model.chain.added_joints)
    for place, (joint, k, ratio) in enumerate(zip(joints, springs, ratios, strict=True), first):
        K[place, place] = k
        if not relative or joint - model.chain.base_v in model.chain.prescribed:
            K[joint, joint] += ratio**2 * k
            K[place, joint] = K[joint, place] = -ratio * k
    for i, key in enumerate(model.chain.keys):
        first = model.chain.eta_v + model.chain.eta_offset[i]
        for (a, b), k in zip(key.coupled, model.numpy(p).constants[i].get("K_below", ()), strict=True):
            K[first + a, first + b] = K[first + b, first + a] = k
    return K


def relative(model: RobotModel, p: Numbers) -> np.ndarray:
    """T (nq, nq): the coordinates from those with rotors relative to where their joints would turn them.

    Rotors whose motion is given are as they are.
    """
    chain, T = model.chain, np.eye(model.nv)
    for place, (joint, ratio) in enumerate(
        zip(chain.added_joints, chain.ratios(p), strict=True), chain.eta_v - chain.n_added
    ):
        T[place, chain.base_v + joint] = 0.0 if joint in chain.prescribed else ratio
    return T


def from_travels(model: RobotModel, q: np.ndarray, p: Numbers) -> np.ndarray:
    """T (nv, nv): rates at `q` (nq,) from those with the travels of rotors behind elastic gears of transmissions.

    These stand in the place of how far the rotor is ahead, so a joint moves on its gear where they are zero.
    """
    chain, T = model.chain, np.eye(model.nv)
    if chain.elastic_travels:
        slopes = travels(chain, chain.of_joints(q), p)[1]
        for joint, place in chain.elastic_travels.items():
            T[place, chain.base_v + joint] = -slopes[joint]
    return T


def pressed(model: RobotModel, q: np.ndarray, p: Numbers | None = None) -> np.ndarray:
    """The stiffness (nv,) at rest in `q` (nq,) of what depends on single coordinates: stops, elements of axes."""
    numeric, out = model.numpy(p), np.zeros(model.nv)
    chain, own = model.chain, columns(model.chain, numeric.constants)
    for law, coordinates, sides, _ in of_robot(chain):
        for k, (place, side) in enumerate(zip(coordinates, sides, strict=True)) if law.positional else ():
            rate = chain.base_v + place
            given = {"x": [q[chain.place_in_q(rate)]], "w": [0.0]} | {name: [own[name][k]] for name in law.constants}
            out[rate] += run(forces(law, (side,)), given, on_arrays)[0]["by_x"][0]
    return out
