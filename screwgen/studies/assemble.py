"""Postures in which the loops of a robot are closed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arguments import Given, Numbers, choice
from ..backends.numpy.closing import closed_softly
from ..errors import UsageError
from ..robot_model import RobotModel
from .modes import posture


def redundant(model: RobotModel) -> list[str]:
    """The rows of the loops, in words, that follow from the other rows and are left out."""
    closing = model.chain.closing
    return [row.text for row in closing.stated if row not in closing.rows]


def bent(model: RobotModel, start: Numbers, found: np.ndarray) -> list[str]:
    """The names of the modes that differ between the start (nq,), or of the joints alone, and the posture found."""
    first = model.chain.eta_q
    before = np.asarray(start, float)[first:] if np.size(start) == model.nq else np.zeros(model.nq - first)
    return [model.q_names[first + k] for k in np.flatnonzero(found[first:] != before)]


def assemble(
    model: RobotModel, q: Numbers | None = None, hold: Sequence[str] = (), parameters: Given = None
) -> np.ndarray:
    """The coordinates (nq,) nearest to `q` (nq,), or the joints alone, with which the loops are closed.

    `hold`: names out of `model.q_names`, whose coordinates stay. Modes stay at what `q` states, or at zero, unless the
    loops close with other ones alone; gears are without load. A floating base stays as well. `parameters`: their
    values. Raises UsageError, and OpenLoopError where the search ends with an open loop, which it says.
    """
    model.chain.refuse_quaternion_joints("assembly", "state its coordinates")
    if not model.chain.closing.junctions:
        said = f"robot '{model.robot.name}' has neither loops nor couplings"
        raise UsageError(f"{said}; state [[loops]] or [[couplings]] tables, or leave this out")
    for name in hold:
        choice(name, model.q_names, "hold: there is no coordinate")
    held, p = [name in hold for name in model.q_names], model.chain.parameters.vector(parameters)
    found, chain = closed_softly(model.numpy(p), posture(model, q, p), held), model.chain
    base, joints, _ = np.split(found, [chain.base_q, chain.base_q + chain.n_joints])
    return np.concatenate([base, chain.with_added(joints, p), found[chain.eta_q :]])
