"""Modal convergence: how far one more mode in each direction would change the natural frequencies.

The spaces of a basis are nested: its shapes of one count are sums of those of a larger count. So one model with one
more mode in every direction tells of each direction alone too, by Ritz's method in the space where the others stay.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

import numpy as np

from ..arguments import Given, Numbers
from ..backends.numpy.vibrations import uncoupled, vibrations, without_rigid_motion
from ..bases import products
from ..errors import SingularError
from ..lazily import linalg
from ..robot_model import RobotModel
from ..simulation.mobility import jacobian
from ..spec.modes import DIRECTIONS, NEEDS, SHEARED, Modes
from ..spec.reduced import elastic
from ..spec.robot import Link, Robot
from ..spec.values import MAX_MODES
from .modes import closed_posture, following, loaded_motion, loaded_shapes, movable, under_loads
from .standing import StandingBase
from .steady import Steady, steady
from .stiffness import from_travels, pressed, relative, stiffness_matrix
from .vibrations_with_loops import about

NOTHING = 5e-5
"""A relative change of a frequency below this is none."""


class Convergence(NamedTuple):
    """Relative changes of the natural frequencies, ascending, zero or negative."""

    total: np.ndarray
    """(count,) with one more mode in every direction."""
    alone: dict[str, np.ndarray]
    """(count,) by direction, with one more mode in that one."""

    def short(self, k: int) -> str | None:
        """The direction in which one more mode changes frequency `k` most; None if none changes it."""
        direction = min(self.alone, key=lambda d: self.alone[d][k], default=None)
        return direction if direction and self.alone[direction][k] < -NOTHING else None


def convergence(
    model: RobotModel,
    q: Numbers | None = None,
    joints: str = "locked",
    parameters: Given = None,
    rates: Numbers | None = None,
    loaded: bool = False,
) -> Convergence:
    """How far one more mode per direction would move each frequency of :func:`.modes.mode_shapes`; arguments as there.

    A direction without modes counts where the section states its stiffness; links without any modes stay rigid. What
    cannot have one more stays as it is: a direction whose frequencies are measured, or with the largest count. The
    deflection under loads is that of the present modes.
    """
    own = model.chain.parameters.vector(parameters)
    if model.chain.moving:
        standing = StandingBase(model, q, own)
        return convergence(standing.fixed, standing.q, joints, standing.values, rates, loaded)
    rich = RobotModel(enriched(model.robot))
    names = dict(zip(model.parameter_names, own, strict=True))
    values = [names.get(name, value) for name, value in zip(rich.parameter_names, rich.parameter_values, strict=True)]
    q = closed_posture(model, q, own)
    moving = movable(model, joints, q, own)
    if not len(moving):
        return Convergence(np.zeros(0), {})
    joints_move, held = joints == "free", np.setdiff1d(np.arange(model.nv), moving)
    if under_loads(model, rates, loaded):
        loads = loaded_motion(model, q, rates, loaded, own, moving)
        motion = _loaded(rich, _enriched(model, rich, loads.q), loads, rates, loaded, np.array(values), held)
        T = np.eye(rich.nv) if joints_move else from_travels(rich, motion.q, np.array(values))
        ritz = lambda basis: loaded_shapes(rich, motion, T @ basis, joints_move)[0].omega  # noqa: E731
    else:
        at = _enriched(model, rich, q)
        T = relative(rich, values) if joints_move else np.eye(rich.nv)
        K = stiffness_matrix(rich, values, relative=joints_move)
        if rich.chain.elastic_travels and not joints_move:
            T = from_travels(rich, at, np.array(values))
            K = T.T @ K @ T
        K = K + np.diag(pressed(rich, at, values))
        M = T.T @ rich.numpy(values).mass_matrix(at) @ T
        J = jacobian(rich, at, values) @ T
        ritz = lambda basis: _at_rest(model, basis, M, K, J)  # noqa: E731
    frequencies = lambda directions: ritz(np.delete(_space(model, rich, directions), held, axis=1))  # noqa: E731
    now = frequencies(())
    more = [d for d in DIRECTIONS if any(_more(link, d) for link in model.robot.links)]
    change = lambda directions: _change(now, frequencies(directions))  # noqa: E731
    return Convergence(change(DIRECTIONS), {d: change((d,)) for d in more})


def _enriched(model: RobotModel, rich: RobotModel, q: np.ndarray) -> np.ndarray:
    """The coordinates of the rich model in a posture `q` (nq,) of the other."""
    modes = _space(model, rich, ())[model.chain.eta_v :, model.chain.eta_v :] @ q[model.chain.eta_q :]
    return np.append(q[: model.chain.eta_q], modes)


def _loaded(
    rich: RobotModel, q: np.ndarray, loads: Steady, rates: Numbers | None, loaded: bool, p: np.ndarray, held: np.ndarray
) -> Steady:
    """Small motions of the rich model about `q` (nq,), where the other model is under `loads`."""
    if not rich.chain.closing.rows:
        return steady(rich, q, rates, loaded, p, np.setdiff1d(np.arange(rich.nv), held), settle=False)
    weight = p if loaded else np.append(np.zeros(3), p[3:])
    return about(rich, q, weight, loads.loops, loads.tau)


def _change(now: np.ndarray, then: np.ndarray) -> np.ndarray:
    """Relative changes of frequencies; of one that is zero, being of a motion that grows, 0."""
    then = then[: len(now)]
    return np.divide(then - now, now, out=np.zeros(len(now)), where=now > 0)


def _at_rest(model: RobotModel, basis: np.ndarray, M: np.ndarray, K: np.ndarray, J: np.ndarray) -> np.ndarray:
    """Circular frequencies of motions in the columns of a `basis` that keep gaps, whose Jacobian is `J`, closed."""
    if len(J):
        basis = basis @ following(J @ basis, np.diag(basis.T @ K @ basis))
    try:
        left, k = _springs(model, basis, K)
        rest, springs, _ = without_rigid_motion(left.T @ M @ left, k)
        return vibrations(rest, springs)[0]
    except np.linalg.LinAlgError:
        what = "one more mode per direction: the mass matrix is singular to rounding"
        why = model.chain.caution or "; masses or lengths differ by too many orders of magnitude"
        raise SingularError(what + why) from None


def _springs(model: RobotModel, basis: np.ndarray, K: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The ``basis`` with its columns combined such that the stiffness is diagonal, and that diagonal."""
    if not (model.chain.coupled or model.chain.closing.rows):
        return basis, np.diag(K) @ basis**2
    change, k = uncoupled(basis.T @ K @ basis)
    return basis @ change, k


def enriched(robot: Robot) -> Robot:
    """The robot with one more mode wherever there can be one."""
    links = (link.model_copy(update={"modes": _modes(link)}) if link.modes.total else link for link in robot.links)
    return robot.model_copy(update={"links": tuple(links)})


def _modes(link: Link) -> Modes:
    return link.modes.model_copy(update={d: getattr(link.modes, d) + _more(link, d) for d in DIRECTIONS})


def _more(link: Link, direction: str) -> bool:
    """Whether a link can have one more mode in a direction."""
    needed = NEEDS[direction]
    if direction in SHEARED and link.modes.alike(direction, 1):
        needed += SHEARED[direction][1:]
    stated = link.section and all(link.section.least(name) for name in needed)
    room = direction not in link.modes.measured and getattr(link.modes, direction) < MAX_MODES
    return bool(link.modes.total and stated and room)


def _space(model: RobotModel, rich: RobotModel, directions: Collection[str]) -> np.ndarray:
    """The rates of the rich model, one column for each that stays: all modes of `directions`."""
    blocks = [np.eye(model.chain.eta_v)]
    for segment in (s for s in model.chain.segments if s.marker is None):
        few, many = (robot.links[segment.link] for robot in (model.robot, rich.robot))
        for d in DIRECTIONS:
            shapes = many.modes.shapes(d)
            kept = shapes if d in directions else few.modes.shapes(d)
            blocks.append(np.reshape(products(shapes, kept), (shapes.count, kept.count)))
        body = elastic(few)
        blocks.append(np.eye(body.modes if body else 0))
    return linalg.block_diag(*blocks)
