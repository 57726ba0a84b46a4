"""A predictive controller's file fitted to a model: its goal at rest, and the cost-to-go of a regulator there."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from ..algorithms.columns import columns
from ..algorithms.law_programs import forces, on_arrays
from ..backends.c.mpc import Fitted, MpcProject, Rest
from ..backends.c.project import CProject
from ..ir.replay import run
from ..progress import busy
from ..robot_model import RobotModel
from ..runtime.mpc import CompiledMpc
from ..spec.load import one_line
from ..spec.mpc import load_mpc
from .equilibrium import equilibrium
from .stiffness import stiffness_matrix

JOINT_SCATTER = 2e-3
"""rad, of slides m: of measured joints."""
ROUNDS = 60
"""Doublings, at most: each squares what is left of the initial error."""
FREE = 1e10
"""What stands for no limit; in C a bound counts below a tenth of it."""


def fitted(model: RobotModel, file: str | os.PathLike[str]) -> Fitted:
    """A controller's file at the sizes of a model.

    Raises RobotFileError or UsageError: the file, the key, the fault and the remedy in one line.
    """
    out = Fitted(model.chain, model.wrench_names, load_mpc(file), one_line(os.fsdecode(file)))
    found = equilibrium(model, out.goal, out.still if out.still.any() else None, hold="all")
    R, r = model.numpy().tip_pose(found.q)
    out.rest = Rest(np.array(found.q), np.array(found.tau), np.array(r), np.array(R))
    slipping, free = slipping_robot(model), free_changes(model)
    A, own = _interval(slipping, out, free)
    B = np.zeros((2 * model.nv, out.n))
    B[free] = own
    out.scatter = np.append(scatter(slipping, out, B), ranges(model, out, B))
    if out.said.cost.terminal.riccati:
        out.terminal = np.zeros((out.states, out.states))
        out.terminal[np.ix_(free, free)] = cost_to_go(slipping, out, A, own, free)
    return out


def free_changes(model: RobotModel) -> list[int]:
    """The changes of coordinates, then those of their rates, that inputs which are chosen can change."""
    given = {*model.chain.given.values()}
    places = [k for k in range(model.nv) if k not in given]
    return places + [model.nv + k for k in places]


def slipping_robot(model: RobotModel) -> RobotModel:
    """The robot without internal states, which is the robot itself if it has none.

    At rest bristles are springs that stick: coordinate and bristle keep their distance whatever the torques are, so a
    regulator there has no finite cost. In a motion they slip, and their force is a constant, which has no slopes.
    """
    if not model.chain.n_internal:
        return model
    joints = {link.name: link.joint.without_internal_states() for link in model.robot.links}
    links = tuple(link.model_copy(update={"joint": joints[link.name]}) for link in model.robot.links)
    return model.once("slipping", lambda: RobotModel(model.robot.model_copy(update={"links": links})))


def ranges(model: RobotModel, f: Fitted, B: np.ndarray) -> np.ndarray:
    """How far it is from one end to the other of where each internal state can be, (n_internal,).

    A state with `zdot = gain w - decay z` does not leave the values that it has at steady rates, and crosses them where
    the rate changes its sign. The rates are those that the torques can give in the horizon, the slow ones among them,
    at which dry friction is largest; gain and decay are those at z = 0. There is no limit where nothing decays, and
    none to states of forces between frames, whose rates follow more than one coordinate.
    """
    fastest = f.said.horizon.intervals * np.abs(B) @ half_ranges(f)
    chain, own, out = model.chain, columns(model.chain, model.numpy().constants), np.zeros(model.chain.n_internal)
    out[chain.z_offset[-1] :], ahead = FREE, chain.base_q
    for law, states in chain.internal.items():
        for k, (place, state) in enumerate(zip(chain.acted(law), states, strict=True)):
            for w in np.outer(
                [-1.0, 1.0], np.geomspace(1e-9, 1.0, 37) * fastest[model.nv + chain.base_v + place.coordinate]
            ).ravel():
                given = {"x": [f.rest.q[place.coordinate + ahead]], "w": [w], "z": [0.0]}
                given |= {name: [own[name][k]] for name in law.constants}
                given |= {} if place.axis is None else {"axis": [f.rest.q[place.axis + ahead]]}
                found = run(forces(law, (place.side,)), given, on_arrays)[0]
                rate, decay = found["rate"][0], -found["rate_z"][0]
                steady = abs(rate) / decay if decay > 0 else FREE * (rate != 0)
                out[state - chain.nv] = max(out[state - chain.nv], min(2 * steady, FREE))
    out[out == 0.0] = FREE  # of coordinates that no torque moves
    return out


def project(model: RobotModel, file: str | os.PathLike[str] | None, *said: Any, **options: Any) -> CProject:
    """The C of a model, with the controller of a file if there is one; the rest as :class:`CProject` takes it."""
    if file is None:
        return CProject(model.chain, model.version, *said, **options)
    return MpcProject(fitted(model, file), model.version, *said, **options)


def controller(model: RobotModel, file: str | os.PathLike[str], **options: Any) -> CompiledMpc:
    """The implementation of :meth:`screwgen.Model.mpc`; a terminal is told of the minutes that it may take."""
    with busy("linearising at the controller's goal", quiet=False):
        fit = fitted(model, file)
    with busy("generating and compiling the predictive controller, minutes for the first time", quiet=False):
        return CompiledMpc(model, fit, **options)


def _interval(model: RobotModel, f: Fitted, free: list[int]) -> tuple[np.ndarray, np.ndarray]:
    """The derivatives of an interval at the goal with the ``free`` changes and with the inputs that are chosen.

    States of forces between frames are held.
    """
    from ..backends.casadi.intervals import interval_slopes

    step = model.casadi()[f"step_{f.said.horizon.method}"]
    nq, nv = model.nq, model.nv
    places = [model.chain.place_in_q(k) if k < nv else nq + k - nv for k in free]
    x = np.append(f.rest.q, np.zeros(model.chain.nvz))
    A, B = interval_slopes(step, f.said.horizon, model.parameter_values, x, nq, f.rest.tau, places)
    return A, B[:, f.chosen]


def scatter(model: RobotModel, f: Fitted, B: np.ndarray) -> np.ndarray:
    """By how much an ordinary sample may miss the model's prediction whatever the torques are, (2 nv,); of internal
    states :func:`ranges` says that.

    Joints by JOINT_SCATTER, their rates as differences of such positions have it. A mode by as much energy as half the
    range of the torques gives to the mode that they excite most, times the margin: some they do not excite at all.
    What is given is believed.
    """
    n, nv, h = model.chain.eta_v, model.nv, f.said.horizon.step
    out = np.r_[np.full(nv, JOINT_SCATTER), np.full(nv, JOINT_SCATTER / h)]
    reach = f.said.solver.margin * np.abs(B) @ half_ranges(f)
    K, M = np.diag(stiffness_matrix(model)), np.diag(model.numpy().mass_matrix(f.rest.q))
    energies = np.r_[K * reach[:nv] ** 2, M * reach[nv:] ** 2]
    most = energies[nv + n :].max(initial=0.0) or energies.max()
    out[n:nv] = np.sqrt(most / K[n:])
    out[nv + n :] = np.sqrt(most / M[n:])
    out[[k for place in model.chain.given.values() for k in (place, nv + place)]] = FREE
    return out


def half_ranges(f: Fitted) -> np.ndarray:
    """Half of what the inputs that are chosen may vary."""
    return (np.array(f.bounds["torque_upper"]) - np.array(f.bounds["torque_lower"])) / 2


def cost_to_go(model: RobotModel, f: Fitted, A: np.ndarray, B: np.ndarray, free: list[int]) -> np.ndarray:
    """``P``: ``x'Px / 2`` behind a plan is what the regulator's motion from there on costs; x the ``free`` changes.

    Motion (``A``, ``B``: of an interval) and tip are linearised at rest at the goal; what the last stage costs itself
    is taken off.
    """
    said, weights, q = f.said, f.weights, f.rest.q
    functions, h, n, none = model.casadi(), said.horizon.step, len(free) // 2, [0.0] * model.chain.base_v
    own = [*none, *weights["joints"], *weights["modes"], *none, *weights["joint_rates"], *weights["mode_rates"]]
    Q = h * np.diag(np.array(own)[free])
    J = np.array(functions["tip_jacobian"](q, model.parameter_values))[:, free[:n]]
    for name, part, first in (
        ("tip_position", J[3:], 0),
        ("tip_orientation", J[:3], 0),
        ("tip_velocity", J[3:], n),
    ):
        if name in weights:
            C = np.zeros((3, 2 * n))
            C[:, first : first + n] = part
            Q += h * C.T @ np.diag(weights[name]) @ C
    R = np.diag(h * np.array(weights["torques"]) + np.array(weights["torque_rates"]) / h)
    try:
        return riccati(A, B, Q, R) - said.cost.terminal.factor * Q
    except np.linalg.LinAlgError:
        remedy = "weigh joints, joint_rates, modes and mode_rates, or leave riccati out"
        raise f.refuse("cost.terminal.riccati", f"has no finite cost-to-go at the goal; {remedy}") from None


def riccati(A: np.ndarray, B: np.ndarray, Q: np.ndarray, R: np.ndarray) -> np.ndarray:
    """The stabilising solution of ``P = Q + A'PA − A'PB (R + B'PB)⁻¹ B'PA`` by doubling.

    Raises LinAlgError where it does not settle: a motion that the weights do not see or torques cannot stop.
    """
    G, P, unit = B @ np.linalg.solve(R, B.T), Q.copy(), np.eye(len(A))
    for _ in range(ROUNDS):
        W = np.linalg.solve(unit + G @ P, np.hstack([A, G]))
        V1, V2 = W[:, : len(A)], W[:, len(A) :]
        more = A.T @ P @ V1
        A, G, P = A @ V1, G + A @ V2 @ A.T, P + 0.5 * (more + more.T)
        if not np.isfinite(P).all():
            break
        if np.abs(more).max() <= 1e-13 * np.abs(P).max():
            return P
    raise np.linalg.LinAlgError("no finite solution")
