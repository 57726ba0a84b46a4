"""Rest of robots with floating bases: without gravity the posture is that on a base which is fixed where it floats."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import Numbers
from ..robot_model import RobotModel
from .held_joints import Hold
from .linear import checked, whole
from .no_equilibrium import NoEquilibriumError
from .standing import StandingBase

if TYPE_CHECKING:
    from .equilibrium import Equilibrium

UNBALANCED = 1e-9
"""The part of the largest load that may be left on the base."""


def floating_equilibrium(
    equilibrium: Callable[..., Equilibrium],
    model: RobotModel,
    q: Numbers | None,
    tau: Numbers | None,
    w_ext: Any,
    hold: Hold,
    p: np.ndarray,
    free: Sequence[str],
) -> Equilibrium:
    """What `equilibrium` does where the base floats: the base is kept as given, the rest settles relative to it.

    Joints, gears, modes and loops act between links, so nothing pushes the base, and the search is that of the robot on
    a base which is fixed at its pose; what acts from the world must leave nothing on it. `stability` is that of the
    posture relative to the base, whose own motion nothing resists.
    """
    if p[:3].any():
        said = f"robot '{model.robot.name}' has a floating base, which nothing holds against gravity"
        raise NoEquilibriumError(f"{said}; set gravity = [0.0, 0.0, 0.0], or fix the base to find its posture")
    m, given = model.chain.n_redundant, None
    if q is not None:
        given = checked(q, "q", m if np.size(q) == m else model.nq)
    start = whole(model.chain, given, p)
    there = StandingBase(model, start, p)
    w_ext = model.chain.tip_wrenches(w_ext, "w_ext:")
    found = equilibrium(there.fixed, there.q, tau, w_ext, hold, there.values, free)
    _balanced(model, found, w_ext)
    wrench = np.vstack([np.zeros(6), found.wrench[1:]])
    return replace(found, q=np.append(there.pose, found.q), wrench=wrench, q_names=tuple(model.q_names))


def _balanced(model: RobotModel, found: Equilibrium, w_ext: np.ndarray) -> None:
    """Refuse wrenches on the tips and forces to the world that leave something on the base, as a fixed one bears it."""
    for part, unit in ((slice(3, 6), "N"), (slice(0, 3), "N·m")):
        left = float(np.linalg.norm(found.wrench[0, part]))
        if left > UNBALANCED * max(1.0, float(np.max(np.abs(w_ext), initial=0.0))):
            tied = any(None in force.ends for force in model.chain.forces)
            acting = "the wrenches on its tips" + " and forces between it and the world" * tied
            said = f"robot '{model.robot.name}': {acting} leave {left:.3g} {unit} on the floating base"
            raise NoEquilibriumError(f"{said}; let them balance, or fix the base")
