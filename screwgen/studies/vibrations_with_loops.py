"""Vibrations of a robot with loops under its weight, about the posture in which it rests while joints are held.

The loops' forces λ add their part to the stiffness: `K = ∂(f − Jᵀ λ)/∂q`, with f what must act on the open tree.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..backends.numpy.travel_numbers import efforts
from ..lazily import linalg
from ..robot_model import RobotModel
from ..simulation.definiteness import check_definite
from ..simulation.mobility import closing
from ..topology.loops import ClosingRow
from .equilibrium import closed_start, rest
from .standing import StandingBase
from .statics_with_loops import RANK, BalanceWithLoops
from .steady import Steady, refuse_pulled_base, unprescribed, unresisted


def hanging(model: RobotModel, q: np.ndarray, p: np.ndarray) -> Steady:
    """Small motions about rest under gravity, with the stated joints of `q` (nq,) held while the links bend."""
    chain, robot, own = model.chain, model, p
    if chain.floating:
        there = StandingBase(model, q, p)
        robot, own = there.fixed, there.fixed.chain.parameters.vector(there.values)
    start, stated = closed_start(robot, own, q[chain.base_q :], True)
    b = rest(robot, own, np.zeros(robot.n_tau), np.zeros((robot.n_links, 6)), stated, start)[1]
    assert isinstance(b, BalanceWithLoops)
    torques = np.where(stated, b.force[robot.chain.held_places], 0.0)
    tau = chain.with_idle_inputs(efforts(chain, torques, b.q[: model.n_joints], p, held=True))
    forces = dict(zip(chain.closing.rows, b.forces, strict=True))
    return about(model, np.append(q[: chain.base_q], b.q), p, forces, tau)


def about(
    model: RobotModel, q: np.ndarray, p: np.ndarray, loops: Mapping[ClosingRow, float], tau: np.ndarray | None = None
) -> Steady:
    """The same about `q` (nq,) with forces of rows, zero of those left out. `tau` (n_tau,): what the drives exert."""
    check_definite(model, q, p)
    numeric, m, still = model.numpy(p), model.chain.eta_v, np.zeros(model.nv)
    forces = np.array([loops.get(row, 0.0) for row in model.chain.closing.rows])
    tau = np.zeros(model.n_tau) if tau is None else tau
    M, K, _ = numeric.slopes(q, still, None, None, tau)
    if model.chain.floating:
        refuse_pulled_base(model, numeric.inverse_dynamics(q, still, None, None), K)
    _, J, _, bend, wrench = (np.array(x) for x in closing(model)(q, still, forces, p))
    K = K - bend
    own = unprescribed(model.chain)
    kept = linalg.null_space(J[:, own], rcond=RANK)
    rigid = kept @ unresisted(K[:, own] @ kept, tau, K[:, m:] @ q[model.chain.eta_q :])
    return Steady(q, still, M, np.zeros_like(M), (K + K.T) / 2, tau, p, rigid, J, dict(loops), wrench.T)
