"""Rest where the motion of the base is given, or where it floats: the robot is on a fixed base, mounted at its pose."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import Numbers
from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.base import BASE_MOTION, FIXED
from ..spec.joint import Mount
from .linear import checked, whole

if TYPE_CHECKING:
    from .equilibrium import Equilibrium
    from .modes import ModeShapes

NOWHERE = (0.0, 0.0, 0.0)


class StandingBase:
    """A robot whose base moves as is given, or floats, at rest in a posture: the `fixed` robot, its coordinates `q` and
    `values` of its parameters."""

    def __init__(self, model: RobotModel, q: Numbers | None, p: np.ndarray):
        posture = whole(model.chain, q, p)
        self.model, self.fixed = model, model.once("mounted base", lambda: RobotModel(mounted(model)))
        self.pose, self.q = np.split(posture, [model.chain.base_q])
        stated = dict(zip(model.parameter_names, p, strict=True))
        first = model.robot.links[0].name
        R, origin = model.numpy(p).link_pose(posture)
        self.point = np.array([-stated.get(f"{first}.frame_at", 0.0), 0.0, 0.0])
        """The joint point of the first link, in its axes."""
        placed = {"xyz": origin[0] + R[0] @ self.point, "rpy": roll_pitch_yaw(R[0])}
        mount = {f"{first}.joint.mount.{name}[{k}]": float(x) for name, xs in placed.items() for k, x in enumerate(xs)}
        self.values = stated | mount

    @property
    def _inputs(self) -> slice:
        return self.model.chain.inputs[BASE_MOTION]

    def without_base(self, tau: Numbers | None) -> np.ndarray | None:
        """The inputs of the robot on a fixed base. Raises UsageError where the base would accelerate."""
        n, m, own = self.model.n_tau, self.model.n_joints, self._inputs
        if tau is None or np.size(tau) not in (n, n - m):
            return None if tau is None else np.asarray(tau, float)
        given = checked(tau, "tau", np.size(tau))
        base = slice(own.start - (n - len(given)), own.stop - (n - len(given)))
        if given[base].any():
            raise UsageError(f"tau accelerates the base of '{self.model.robot.name}'; what rests has zeros there")
        rest = np.delete(given, base)
        return rest if len(rest) else None

    def with_base(self, tau: np.ndarray, base: np.ndarray) -> np.ndarray:
        """Inputs of the robot, or what drives exert, with those of the base."""
        return np.insert(tau, [self._inputs.start] * len(base), base)

    def equilibrium(self, found: Callable[..., Equilibrium], tau: Numbers | None, w_ext: Any, *how: Any) -> Equilibrium:
        """What `equilibrium` finds."""
        rest = found(self.fixed, self.q, self.without_base(tau), w_ext, how[0], self.values, how[1])
        moment, force = np.split(rest.wrench[0], 2)
        borne = np.append(moment + np.cross(self.point, force), force)
        return replace(
            rest,
            q=np.append(self.pose, rest.q),
            wrench=np.vstack([borne, rest.wrench[1:]]),
            tau=self.with_base(rest.tau, np.zeros(6)),
            effort=self.with_base(rest.effort, borne),
            q_names=tuple(self.model.q_names),
        )

    def mode_shapes(self, found: Callable[..., ModeShapes], *how: Any) -> ModeShapes:
        """What `mode_shapes` finds: the base does not move."""
        shapes = found(self.fixed, self.q, how[0], self.values, *how[1:])
        return shapes._replace(shapes=np.pad(shapes.shapes, ((6, 0), (0, 0))))


def mounted(model: RobotModel) -> Any:
    """The robot on a fixed base, with a mount."""
    first, *others = model.robot.links
    joint = first.joint.model_copy(update={"mount": Mount(xyz=NOWHERE, rpy=NOWHERE)})
    links = (first.model_copy(update={"joint": joint}), *others)
    return model.robot.model_copy(update={"base": FIXED, "links": links})


def roll_pitch_yaw(R: np.ndarray) -> np.ndarray:
    """(3,): the angles of `R = Rz(y) Ry(p) Rx(r)`."""
    level = float(np.hypot(R[0, 0], R[1, 0]))
    upright = level < 1e-12
    roll = np.arctan2(-R[1, 2], R[1, 1]) if upright else np.arctan2(R[2, 1], R[2, 2])
    return np.array([roll, np.arctan2(-R[2, 0], level), 0.0 if upright else np.arctan2(R[1, 0], R[0, 0])])
