"""Equilibria of an arm under gravity, at given joint angles or torques, and their stability."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from .. import notebook
from ..arguments import Given, Numbers
from ..backends.numpy.closing import OpenLoopError, closed_softly
from ..backends.numpy.travel_numbers import efforts
from ..errors import UsageError
from ..lazily import linalg
from ..robot_model import RobotModel
from ..simulation.limited_inputs import warn_at_rest
from ..simulation.mobility import stated_joints
from ..simulation.motion import displacements
from ..simulation.validity import Validity, validity_at_rest
from ..spec.brake import BRAKES
from ..spec.parameters import changes
from ..spec.robot import Robot
from .equilibrium_of_floating_bases import floating_equilibrium
from .held_joints import Asked, Hold, asked, efforts_beside, joint_names, refuse_followers
from .linear import whole
from .no_equilibrium import NoEquilibriumError
from .standing import StandingBase
from .statics import Balance, Statics, newton_step, search
from .statics_with_loops import StaticsWithLoops
from .steady import wound
from .stiffness import stiffness

__all__ = ["Equilibrium", "NoEquilibriumError", "equilibrium"]

MOST = 500
"""Coordinates: the exact stiffness, differentiated twice, takes memory as their square, 0.8 GB for so many."""
NEUTRAL = 1e-9
"""Scaled stiffness below which a direction counts as without."""


@dataclass(frozen=True, eq=False, repr=False)
class Equilibrium:
    """An arm at rest. SI units, radians; n links, nq coordinates."""

    q: np.ndarray
    """(nq,): joint coordinates, those of rotors, then modal ones."""
    tau: np.ndarray
    """(n_tau,): torques where they act, N·m, of slides forces, N; for held joints those that hold them; tensions, N."""
    effort: np.ndarray
    """(n_tau,): the same where the motion of axes is given; their entries in `tau`, accelerations, are zero."""
    held: bool
    """Whether joints are held; if not, they are free under `tau`."""
    held_joints: tuple[str, ...]
    """The joint coordinates that are held, to which the torques in `tau` belong that were found."""
    passive: tuple[str, ...]
    """The joint coordinates that their springs carry while the others are held."""
    residual: float
    """The largest unbalanced force over what the loads exert before they cancel, `Statics.scales`: at most 1e-10."""
    stability: str
    """What the signs of `stiffness` say: "stable", "neutral" or "unstable"; "flutter": see `equilibrium`."""
    stiffness: np.ndarray
    """Eigenvalues, ascending, of the stiffness of the free coordinates, scaled by their springs and weights."""
    loose: tuple[str, ...]
    """The coordinates that move most in the directions whose eigenvalue is not positive."""
    wrench: np.ndarray
    """(n, 6): joint wrenches [τ; F], what link i−1 exerts on link i at the joint point, F_i components."""
    tip_position: np.ndarray
    """(3,): the last tip in the inertial frame, m."""
    tip_deflection: np.ndarray
    """(3,): the tip's displacement from its place with straight links, inertial components, m. Joints that follow loops
    do so with straight links too, unless these cannot close the loops."""
    deflections: np.ndarray
    """(n, 3): each link's own tip from its undeformed centreline, F_i components, m."""
    validity: Validity
    """How far the links are from the limits of the model, of which `stability` knows nothing."""
    q_names: tuple[str, ...]
    """The names of the coordinates."""
    following: tuple[str, ...]
    """The joint coordinates that follow the loops while the others are held."""
    loop_wrench: np.ndarray
    """(n, 6): what loops exert on the tips [τ; F], tip-frame components; zero without loops."""

    def __repr__(self) -> str:
        joints = "joints held" if self.held else "joints free"
        loose = f" with {', '.join(self.loose)}" if self.loose else ""
        sag = 1e3 * float(np.linalg.norm(self.tip_deflection))
        return f"<Equilibrium: {self.stability}{loose}, {joints}; the tip is deflected by {sag:.4g} mm>"

    def _repr_html_(self) -> str:
        """Coordinates, with the torques on joints that have one for each, and the tip."""
        own = self.effort if not any(name.endswith(".qw") for name in self.q_names) else ()
        torques = [*map(notebook.number, own), *[""] * (len(self.q) - len(own))]
        rows = [*zip(self.q_names, self.q, torques, strict=True)]
        rows += [(f"tip_position.{axis}", x, "") for axis, x in zip("xyz", self.tip_position, strict=True)]
        force = "torque, N·m; of slides force, N" if any(".slide[" in x for x in self.q_names) else "torque, N·m"
        return notebook.table(repr(self).strip("<>"), ("", "value", force), rows)


def equilibrium(
    model: RobotModel,
    q: Numbers | None = None,
    tau: Numbers | None = None,
    w_ext: Any = None,
    hold: Hold = False,
    parameters: Given = None,
    free: Sequence[str] = (),
) -> Equilibrium:
    """The posture in which the arm rests.

    `hold`: the joints are held at `q` (n_joints,) and the torques follow. An axis with a spring, a stiffness > 0, is
    passive: nothing drives it, and it settles on its spring, from `q` on; "all" holds such axes too. Names of links, or
    of coordinates such as "boom.joint[0]", hold these alone, with springs or without; `free` names those that stay free
    while all others are held. The torques and tensions `tau` (n_tau,), N·m and N, zero by default, act besides joint
    springs; of held joints they are zero, and where all are held `tau` may be the tensions alone. The angles of free
    joints follow: the search goes down the potential energy from `q`, so it ends in a stable posture, unless `q` is an
    equilibrium itself. `q` may hold the modes' start too (nq,).
    Where there are loops they are closed. Held are then as many joints as the loops leave to state, those with drives
    before others and those first in the file before later ones; the others follow.
    `w_ext` (n, 6), of the robot's n links or of all segments: wrenches [τ; F] that turn with the tip sections; they
    have no potential, so the search is one for forces that vanish, and what has positive stiffness may still flutter:
    then `stability` says so. A floating base is kept as in `q` and needs a robot without gravity: the others settle
    relative to it. One whose motion is given stands where `q` has it. `parameters`: their values. A
    :class:`ModelValidityWarning` says where a link is past the bounds of the model, in which a column beyond its
    buckling load is "stable"; a :class:`LimitWarning` where a drive does not have the effort that the posture takes.
    Raises UsageError, and NoEquilibriumError, which names the joint, where nothing balances the torques.
    """
    if model.chain.moving:
        at = StandingBase(model, q, model.chain.parameters.vector(parameters))
        return at.equilibrium(equilibrium, tau, model.chain.tip_wrenches(w_ext, "w_ext:"), hold, free)
    if model.chain.floating:
        p = model.chain.parameters.vector(parameters)
        return floating_equilibrium(equilibrium, model, q, tau, w_ext, hold, p, free)
    values = model.chain.parameters.vector(parameters)
    found = _report(*rest_of(model, q, tau, w_ext, hold, values, free))
    found.validity.warn()
    warn_at_rest(model, found.q, found.tau, values)
    return found


def rest_of(
    model: RobotModel,
    q: Numbers | None,
    tau: Numbers | None,
    w_ext: Any,
    hold: Hold,
    values: np.ndarray,
    free: Sequence[str] = (),
) -> tuple[Statics, Balance, np.ndarray, Asked, np.ndarray]:
    """What :func:`equilibrium` finds of a robot on a fixed base at parameters (n,), without report and warnings.

    The forces, the rest, which joints are held (n_joints,) of bool, what was asked for, and which joints may be stated.
    """
    m = model.n_joints
    if model.nq > MOST:
        raise UsageError(f"the arm has {model.nq} coordinates; an equilibrium is sought for at most {MOST}")
    start = whole(model.chain, q, values)
    wanted = asked(model, hold, free, stiffness(model, values)[:m] > 0)
    start, stated = closed_start(model, values, start, wanted.at_all, wanted.preferred)
    refuse_followers(model, wanted, stated)
    held = wanted.held & stated
    torques = efforts_beside(model, tau, held, wanted.at_all)
    _refuse_brakes(model, torques, held)
    values = model.chain.fallen(values, torques)
    w_ext = model.chain.tip_wrenches(w_ext, "w_ext:")
    return *rest(model, values, torques, w_ext, held, start), held, wanted, stated


def rest_beside(at: Statics, b: Balance, held: np.ndarray, wanted: Asked, tau: Numbers, p: np.ndarray) -> np.ndarray:
    """The coordinates (nq,) at rest beside one that :func:`rest_of` found, with other inputs and parameters.

    These are so near that one step of Newton's leads there. Of robots without elastic gears.
    """
    model = at.model
    torques = efforts_beside(model, tau, held, wanted.at_all)
    other = _statics(model, model.chain.fallen(p, torques), torques, at.w_ext, held)
    there = other.at(b.q)
    return other.displaced(there, newton_step(other, there))


def _refuse_brakes(model: RobotModel, tau: np.ndarray, held: np.ndarray) -> None:
    """A closed brake holds its axis wherever it is: no search, but what the caller holds, finds where."""
    chain = model.chain
    for k, place in zip(chain.braked, range(model.n_tau)[chain.inputs[BRAKES]] if chain.braked else (), strict=True):
        if tau[place] >= 1 and not held[k]:
            axis = joint_names(model)[k]
            raise UsageError(f"tau: {model.tau_names[place]} is closed and holds its axis anywhere; hold {axis} too")


def rest(
    model: RobotModel, p: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, held: np.ndarray, start: np.ndarray
) -> tuple[Statics, Balance]:
    """The forces, and the rest in which the search from `start` (nq,) ends, the joints in `held` (n_joints,) locked."""
    return (_rested if model.chain.n_added else _balanced)(model, p, tau, w_ext, held, start)


def closed_start(
    model: RobotModel, p: np.ndarray, start: np.ndarray, hold: bool, preferred: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """`start` (nq,) with closed loops, and which joints (n_joints,) of bool may be stated; `hold`: these stay.

    `preferred` (n_joints,) of bool: joints to state before others, which then stay alone. A floating base stays.
    """
    chain = model.chain
    if not chain.closing.rows:
        return start, np.ones(chain.n_joints, bool)
    numeric, fixed = model.numpy(p), np.zeros(chain.nq, bool)
    joints = slice(chain.base_q, chain.base_q + chain.n_joints)
    fixed[joints.stop : chain.eta_q] = True
    near = closed_softly(numeric, start, fixed)
    stated = stated_joints(model, near, p, preferred)
    if hold:
        fixed[joints] = stated if preferred is None else stated & preferred
        near[joints] = np.where(fixed[joints], start[joints], near[joints])
        near = closed_softly(numeric, near, fixed)
    return np.concatenate([near[: joints.start], chain.with_added(near[joints], p), near[chain.eta_q :]]), stated


def _statics(model: RobotModel, p: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, held: np.ndarray) -> Statics:
    """The forces under `tau` (n_tau,) where it acts, with the drives of the axes in `held` (n_joints,) at rest."""
    load, still = np.zeros(model.nv), np.zeros(model.nv, bool)
    torques, others = np.split(tau, [model.n_joints])
    load[model.chain.held_places], still[model.chain.held_places] = torques, held
    kind = StaticsWithLoops if model.chain.closing.rows else Statics
    return kind(model, p, load, w_ext, np.flatnonzero(~still), others)


def _balanced(
    model: RobotModel, p: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, held: np.ndarray, start: np.ndarray
) -> tuple[Statics, Balance]:
    """The equilibrium that the search from `start` (nq,) ends in."""
    statics = _statics(model, p, tau, w_ext, held)
    return statics, search(statics, start)


def _rested(
    model: RobotModel, p: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, held: np.ndarray, start: np.ndarray
) -> tuple[Statics, Balance]:
    """The same with elastic drives: at rest a gear passes on its torque, so the arm rests as one with rigid gears does.

    The rotors are turned until their gears pass on the torques at the joints.
    """
    chain, stiff = model.chain, model.once("rigid gears", lambda: RobotModel(rigid(model.robot)))
    values = dict(zip(model.parameter_names, p, strict=True))
    own, added = np.array([values[name] for name in stiff.parameter_names]), range(chain.n_redundant, chain.eta_q)
    m, at_joints = chain.n_joints, tau / chain.at_efforts(np.ones(chain.n_tau), p)
    held = np.append(held, np.zeros(chain.n_tau - m, bool))
    _, b = _balanced(stiff, own, at_joints, w_ext, held[:m], np.delete(start, added))
    holding = efforts(chain, np.where(held[:m], b.force[:m], 0.0), stiff.chain.of_joints(b.q), p)
    torques = np.where(held[:m], holding, at_joints[:m])
    q = np.concatenate([chain.with_added(b.q[: chain.n_redundant], p), b.q[chain.n_redundant :]])
    statics = _statics(model, p, np.where(held, 0.0, tau), w_ext, held[:m])
    return statics, statics.at(wound(model, q, torques, p))


def rigid(robot: Robot) -> Robot:
    """The robot with rigid gears in place of elastic ones."""
    links = tuple(link.model_copy(update={"joint": link.joint.rigid()}) for link in robot.links)
    return robot.model_copy(update={"links": links})


def _report(statics: Statics, b: Balance, held: np.ndarray, wanted: Asked, stated: np.ndarray) -> Equilibrium:
    model, m, driven = statics.model, statics.model.n_joints, statics.model.chain.held_places
    straight = np.append(b.q[: model.chain.n_redundant], np.zeros(model.nq - model.chain.n_redundant))
    with suppress(OpenLoopError):
        straight = closed_start(model, statics.p, straight, True, wanted.preferred)[0]
    own = [displacements(model, b.q[None], i, [1.0])[0, 0] for i in range(len(model.robot.links))]
    holding = efforts(
        model.chain, np.where(held, b.force[driven], 0.0), model.chain.of_joints(b.q), statics.p, held=True
    )
    stability, eigenvalues, loose = _stability(statics, b)
    named = lambda which: tuple(name for name, there in zip(joint_names(model), which, strict=True) if there)  # noqa: E731
    effort = np.append(np.where(held, holding + 0.0, statics.load[driven]), statics.others)
    return Equilibrium(
        q=b.q,
        tau=np.where(np.isin(np.arange(model.n_tau), model.chain.prescribed), 0.0, effort),
        effort=effort,
        held=wanted.at_all,
        held_joints=named(held),
        passive=named(wanted.joints & ~held & (statics.springs[:m] > 0)),
        residual=b.residual,
        stability=stability,
        stiffness=eigenvalues,
        loose=loose,
        wrench=statics.wrenches(b)[model.chain.firsts],
        tip_position=b.tip,
        tip_deflection=b.tip - statics.at(straight).tip,
        deflections=np.array(own),
        q_names=tuple(model.q_names),
        validity=validity_at_rest(model, b.q, statics.borne(b), statics.p),
        following=named(wanted.following(stated)),
        loop_wrench=(statics.borne(b) - statics.w_ext)[model.chain.lasts],
    )


def _stability(statics: Statics, b: Balance) -> tuple[str, np.ndarray, tuple[str, ...]]:
    """The verdict, the eigenvalues and the names of the unstable coordinates."""
    K = statics.scaled(b)[1]
    if not len(K):
        return "stable", np.zeros(0), ()
    eigenvalues, vectors = linalg.eig(K) if statics.turn_along else linalg.eigh((K + K.T) / 2)
    order = np.argsort(eigenvalues.real)
    values, vectors = eigenvalues.real[order], vectors[:, order]
    moved = statics.directions(b) @ vectors
    weak = [statics.moving[np.argmax(np.abs(moved[:, k]))] for k in np.flatnonzero(values <= NEUTRAL)]
    loose = tuple(list(changes(statics.model.robot))[k] for k in dict.fromkeys(weak))
    if values[0] < -NEUTRAL:
        return "unstable", values, loose
    if statics.turn_along and _flutters(statics, b):
        return "flutter", values, loose
    return "neutral" if loose else "stable", values, loose


def _flutters(statics: Statics, b: Balance) -> bool:
    """Whether the undamped small motions have growing oscillations: squares of frequencies that are not real."""
    i, D = statics.moving, statics.units[statics.moving]
    M = statics.model.numpy(statics.p).mass_matrix(b.q)[np.ix_(i, i)]
    Z = statics.directions(b)
    squares = linalg.eigvals(statics.scaled(b)[1], Z.T @ (M / np.outer(D, D)) @ Z)
    squares = squares[np.isfinite(squares)]
    return bool((np.abs(squares.imag) > 1e-6 * np.abs(squares)).any())
