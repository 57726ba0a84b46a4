"""Joint coordinates at which the tip of an arm that rests under its weight is at a place: inverse kinematics."""

from __future__ import annotations

import casadi as ca
import numpy as np

from ..arguments import Given, Numbers, array
from ..errors import UsageError
from ..robot_model import RobotModel
from .members import Still
from .refusals import refuse_robot

CLOSE = 1e-9
"""How near to the place the tip has to be, over the reach of the arm."""
NEARLY = 1e-5
"""From which on, over the reach, a place counts as out of it; in between searches end where the arm is singular."""
SINGULAR = 1e-4
"""The least ratio of a singular value of the tip's Jacobian to what it is in the best of other postures."""
STARTS, SEED = 12, 1


def inverse_kinematics(
    model: RobotModel, tip: Numbers, near: Numbers | None = None, *, parameters: Given = None
) -> np.ndarray:
    """The joint coordinates (n_joints,), rad, of slides m, at which the last tip rests at `tip` (3,), m, in the world.

    The links sag under their weight. Of several postures it is one close to `near` (n_joints,), zero if not given.
    Raises UsageError where the place is out of reach within the limits of joints, or the posture is singular there.
    """
    refuse_robot(model, "inverse kinematics", "state joint coordinates")
    m = model.n_joints
    place = array(tip, "tip:", (3,))
    begin = np.zeros(m) if near is None else array(near, "near:", (m,))
    arm = TipAtRest(model, model.chain.parameters.vector(parameters))
    lower, upper = model.chain.limits.T
    rng = np.random.default_rng(SEED)
    wide = np.clip(lower, -np.pi, np.pi), np.clip(upper, -np.pi, np.pi)
    others = rng.uniform(*wide, (STARTS, m)) if (wide[0] < wide[1]).all() else np.empty((0, m))
    scale = max(arm.reach(others), float(np.abs(place).max()), 1e-6)
    best, left = begin, np.inf
    for start in (begin, *others):
        found, gap = arm.solved(place, start, lower, upper)
        if gap < left:
            best, left = found, gap
        if left <= CLOSE * scale:
            break
    else:
        if left < NEARLY * scale:
            raise _singular(best)
        at = ", ".join(f"{x:.4g}" for x in arm.position(best))
        raise UsageError(
            f"tip: is out of reach; the closest place found is ({at}), {left:.3g} m away; take another one"
        )
    return _regular(arm, best, others)


def _regular(arm: TipAtRest, found: np.ndarray, others: np.ndarray) -> np.ndarray:
    """The joints themselves; refuses a posture in which the tip cannot move as elsewhere."""
    values = [np.linalg.svd(arm.jacobian(q), compute_uv=False) for q in others]
    generic, own = np.max([np.zeros(min(3, len(found))), *values], axis=0), np.linalg.svd(arm.jacobian(found))[1]
    if (own < SINGULAR * generic).any():
        raise _singular(found)
    return found


def _singular(joints: np.ndarray) -> UsageError:
    said = ", ".join(f"{x:.4g}" for x in joints)
    return UsageError(f"tip: the arm is singular there, with joints at {said}; take another place, or state joints")


class TipAtRest:
    """The tip's position at rest as a function of the joints, links sagging, and its Jacobian."""

    def __init__(self, model: RobotModel, p: np.ndarray):
        self.still, self.joints = Still(model, p), model.n_joints
        q = ca.SX.sym("q", model.nq)
        position = model.casadi()["tip_pose"](self.still.drives.to_robot(q), p)[1]
        self.place = ca.Function("place", [q], [position, ca.jacobian(position, q)])

    def position(self, joints: np.ndarray) -> np.ndarray:
        """(3,), m."""
        return np.array(self.place(self.still.held(joints).q)[0]).ravel()

    def jacobian(self, joints: np.ndarray) -> np.ndarray:
        """(3, n_joints): of the position by the joints, the modes at equilibrium."""
        q, m = self.still.held(joints).q, self.joints
        K, whole = np.array(self.still.statics(q)[1]), np.array(self.place(q)[1])
        return whole[:, :m] - whole[:, m:] @ np.linalg.solve(K[m:, m:], K[m:, :m])

    def reach(self, postures: np.ndarray) -> float:
        """The farthest from the origin that the tip is in postures, m."""
        return max((float(np.linalg.norm(self.position(q))) for q in postures), default=0.0)

    def solved(
        self, place: np.ndarray, start: np.ndarray, lower: np.ndarray, upper: np.ndarray
    ) -> tuple[np.ndarray, float]:
        """The joints within bounds with the tip closest to a place, sought from a start, and how far it is, m."""
        from scipy.optimize import least_squares

        gap = lambda joints: self.position(joints) - place  # noqa: E731
        start = np.clip(start, lower, upper)
        found = least_squares(gap, start, self.jacobian, (lower - 1e-12, upper + 1e-12), xtol=1e-15, ftol=1e-15).x
        return found, float(np.linalg.norm(gap(found)))
