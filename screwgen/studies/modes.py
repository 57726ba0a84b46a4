"""Natural frequencies: small vibrations about a posture, at rest without gravity or turning and loaded."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..arguments import Given, Numbers, choice
from ..backends.numpy import prescribed
from ..backends.numpy.closing import closed_softly
from ..backends.numpy.vibrations import uncoupled, vibrations, without_rigid_motion
from ..errors import SingularError, UsageError
from ..lazily import linalg
from ..robot_model import RobotModel
from ..simulation.definiteness import check_definite
from ..simulation.mobility import by_spring, check_closed, jacobian, loads_of_loops, mobility, stated_joints
from ..simulation.validity import Validity, Watch, validity_at_rest
from .linear import whole
from .standing import StandingBase
from .steady import Oscillations, Steady, oscillations, steady
from .stiffness import from_travels, pressed, relative, stiffness_matrix
from .vibrations_with_loops import hanging

JOINTS = ("locked", "free")

LOADED = "table of modes under loads or at rates", "leave these out"


def natural_frequencies(
    model: RobotModel,
    q: Numbers | None = None,
    joints: str = "locked",
    parameters: Given = None,
    rates: Numbers | None = None,
    loaded: bool = False,
) -> np.ndarray:
    """The natural frequencies in Hz, ascending, at rest at `q` (nq,) or the joints alone, without gravity or damping.

    `joints`: "locked" leaves the modes alone to move, (n_modes,), joints with springs locked like all others; where
    drives are elastic it locks their rotors, and the joint moves on its gear. "free" lets the joints turn on their own
    springs: motions that no spring resists give exactly 0. A floating base moves in either case, which gives six
    zeros. A base and axes whose motion is given stand in either case, of elastic drives the rotors. Where loops are
    closed at `q`, as many motions as they leave are found; "locked" locks the joints of
    :func:`..simulation.mobility.stated_joints`, and the others follow. `parameters`:
    values, the file's by default.
    `rates` (n_joints,), rad/s or m/s: of an arm whose joints turn steadily, kept at their rates where they are locked,
    under constant torques where they are free. `loaded`: gravity bends the links and changes their stiffness. In both
    cases torques hold the joints at `q`, and the vibrations are about the deflection that follows; and so they are of a
    robot with forces between frames, which act in any case.
    Raises UsageError, also where the loads change with the motion or where vibrations grow, and SingularError where
    the mass matrix of what may move is singular.

    Where the links bear or bend more than the bounds of the model allow, a :class:`ModelValidityWarning` says so: under
    their weight also where gravity has no part in the frequencies.
    """
    found = mode_shapes(model, q, joints, parameters, rates, loaded)
    found.validity.warn()
    if found.growth.any():
        first = rates is not None and any(key.order == 1 and key.modes for key in model.chain.keys)
        remedy = '; give links that turn order = 2 or "exact", whose rotation stiffens them' if first else ""
        if model.chain.forces and not loaded:
            remedy += "; with gravity, loaded, the forces between frames may be in balance"
        raise UsageError(f"{found.unstable}; screwgen.mode_shapes tells how fast they grow{remedy}")
    return np.append(np.zeros(found.rigid), found.frequencies)


class ModeShapes(NamedTuple):
    """Small vibrations about a posture: `frequencies` (count,) in Hz, ascending; motions without springs left out."""

    frequencies: np.ndarray
    shapes: np.ndarray
    """(nv, count): each mode's column of coordinates, of unit modal mass; its sign is arbitrary. About a turning arm:
    the displacement when its largest coordinate is at its peak, others being out of phase.
    """
    rigid: int
    """The number of motions that no spring resists."""
    validity: Validity
    """How far the posture is from the limits of the model, under its weight unless the arm turns without gravity."""
    growth: np.ndarray
    """(count,) in 1/s: zero, or how fast an unstable motion grows; one that does not oscillate has frequency 0."""

    @property
    def unstable(self) -> str:
        """What grows, in words."""
        count, fastest = np.count_nonzero(self.growth), max(self.growth)
        return f"{count} of {len(self.growth)} vibrations grow, the fastest as exp({fastest:.4g}/s t)"


def mode_shapes(
    model: RobotModel,
    q: Numbers | None = None,
    joints: str = "locked",
    parameters: Given = None,
    rates: Numbers | None = None,
    loaded: bool = False,
) -> ModeShapes:
    """Natural frequencies with their shapes; arguments and errors as those of `natural_frequencies`."""
    p = model.chain.parameters.vector(parameters)
    if model.chain.moving:
        return StandingBase(model, q, p).mode_shapes(mode_shapes, joints, rates, loaded)
    q = closed_posture(model, q, p)
    moving = movable(model, joints, q, p)
    if not len(moving):
        nothing = Watch(model.chain.names).validity()
        return ModeShapes(np.zeros(0), np.zeros((model.nv, 0)), 0, nothing, np.zeros(0))
    if under_loads(model, rates, loaded):
        about = loaded_motion(model, q, rates, loaded, p, moving)
        free = joints == "free"
        T = np.eye(model.nv) if free else from_travels(model, about.q, p)
        found, basis = loaded_shapes(model, about, T[:, moving], free)
        frequencies, shapes = found.omega / (2 * np.pi), basis @ found.shapes
        return ModeShapes(frequencies, shapes, found.rigid, about.validity(model), found.growth)
    check_definite(model, q, p)
    out, frequencies, rigid = _at_rest(model, q, p, moving, joints == "free")
    weight = np.append(np.zeros(3), p[3:]) if model.chain.floating else p
    validity = validity_at_rest(model, q, loads_of_loops(model, q, weight), weight)
    return ModeShapes(frequencies / (2 * np.pi), out, rigid, validity, np.zeros(len(frequencies)))


def _at_rest(
    model: RobotModel, q: np.ndarray, p: np.ndarray, moving: np.ndarray, free: bool
) -> tuple[np.ndarray, np.ndarray, int]:
    """Shapes (nv, count) and circular frequencies at rest without gravity, and the number of rigid motions.

    Where rotors move, their coordinates are those relative to their joints, so that the stiffness of gears is theirs.
    """
    T, K = np.eye(model.nv), stiffness_matrix(model, p)
    if free and model.chain.n_added:
        T, K = relative(model, p), stiffness_matrix(model, p, relative=True)
    elif model.chain.elastic_travels:
        T = from_travels(model, q, p)
        K = T.T @ K @ T
    K += np.diag(pressed(model, q, p))
    M, K = (x[np.ix_(moving, moving)] for x in (T.T @ model.numpy(p).mass_matrix(q) @ T, K))
    N = following((jacobian(model, q, p) @ T)[:, moving], np.diag(K))
    M, K = (M, K) if N is None else (N.T @ M @ N, N.T @ K @ N)
    loose, held = np.flatnonzero(np.diag(K) == 0), np.flatnonzero(np.diag(K))
    columns, out = np.zeros((len(K), len(held))), np.zeros((model.nv, len(held)))
    try:
        basis, k = uncoupled(K)
        M = basis.T @ ((M + M.T) / 2) @ basis
        rest, springs, rigid = without_rigid_motion(M, k)
        frequencies, vectors = vibrations(rest, springs)
        columns[held] = vectors
        if len(loose):
            coupling = M[np.ix_(loose, held)] @ vectors
            columns[loose] = -linalg.solve(M[np.ix_(loose, loose)], coupling, assume_a="pos")
        out[moving] = basis @ columns if N is None else N @ (basis @ columns)
    except np.linalg.LinAlgError:
        raise _singular(model, q, p) from None
    return T @ out, frequencies, rigid


CHANGED = 0.1
"""The relative change of a frequency by gravity from which it is worth saying."""


class Changed(NamedTuple):
    """A frequency that gravity changes: its number among those of `natural_frequencies`, without and with gravity."""

    number: int
    without: float
    loaded: float
    growth: float
    """1/s: how fast the motion grows under gravity, if it does."""


def changed_by_gravity(
    model: RobotModel, q: Numbers | None, joints: str, found: ModeShapes, parameters: Given = None
) -> Changed | None:
    """The first frequency of `found`, without gravity, that gravity changes by more than `CHANGED`; None without.

    None also where there are no modes under load: of floating bases, and where links find no rest.
    """
    p = model.chain.parameters.vector(parameters)
    if not p[:3].any():
        return None
    try:
        under = mode_shapes(model, q, joints, p, loaded=True)
    except (UsageError, SingularError):
        return None
    whole = lambda x, values: np.append(np.zeros(x.rigid), values)  # noqa: E731
    triples = zip(whole(found, found.frequencies), *(whole(under, x) for x in under[:1] + under[4:]), strict=False)
    for k, (f, loaded, growth) in enumerate(triples):
        if abs(loaded - f) > CHANGED * max(loaded, f) or growth:
            return Changed(k + 1, float(f), float(loaded), float(growth))
    return None


def under_loads(model: RobotModel, rates: Numbers | None, loaded: bool) -> bool:
    """Whether vibrations are about a deflection; forces between frames are loads that always act."""
    return loaded or rates is not None or bool(model.chain.forces)


def loaded_motion(
    model: RobotModel, q: np.ndarray, rates: Numbers | None, loaded: bool, p: np.ndarray, moving: np.ndarray
) -> Steady:
    """Small motions about a steady motion, of which those of a robot with loops are about rest; see :func:`steady`."""
    if loaded or rates is not None:
        model.chain.refuse_floating_base(*LOADED)
    if not model.chain.closing.rows:
        return steady(model, q, rates, loaded, p, moving)
    if rates is not None:
        what = f"robot '{model.robot.name}' has loops, for which there is no table of modes at rates"
        raise UsageError(f"{what}; leave the rates out, or simulate it")
    return hanging(model, q, p if loaded else np.append(np.zeros(3), p[3:]))


def loaded_shapes(model: RobotModel, about: Steady, basis: np.ndarray, free: bool) -> tuple[Oscillations, np.ndarray]:
    """The natural motions in the columns of `basis` (nv, n), and where there are loops columns (nv, d) that keep them.

    `free`: whether the joints move.
    """
    afloat = np.eye(model.chain.base_v) if model.chain.floating else None
    rigid = about.rigid if free else afloat
    if len(about.J):
        J, springs = about.J @ basis, np.diag(basis.T @ stiffness_matrix(model, about.p) @ basis)
        independent, _, N = mobility(J, by_spring(J, springs))
        if rigid is not None:
            rigid = np.vstack([rigid, np.zeros((len(N) - len(rigid), rigid.shape[1]))])[independent]
        basis = basis @ N
    M, G, K = (basis.T @ x @ basis for x in (about.M, about.G, about.K))
    return oscillations(M, G, K, rigid), basis


def posture(model: RobotModel, q: Numbers | None, p: Numbers) -> np.ndarray:
    """The coordinates (nq,) of a posture: as given, the joints alone, or where everything is zero."""
    return whole(model.chain, q, p)


def closed_posture(model: RobotModel, q: Numbers | None, p: Numbers) -> np.ndarray:
    """The same; without a `q` the posture with closed loops next to zero.

    Raises UsageError where a loop is open, and SingularError where loops are singular.
    """
    chain, at = model.chain, posture(model, q, p)
    if not chain.closing.rows:
        return at
    if q is None:
        near, first = closed_softly(model.numpy(p), at, np.zeros(chain.nq, bool)), chain.base_q
        joints = chain.with_added(near[first : chain.q_offset[-1]], p)
        at = np.concatenate([near[:first], joints, near[chain.eta_q :]])
    check_closed(model.numpy(p), "q", at)
    stated_joints(model, at, p)
    return at


def movable(model: RobotModel, joints: str, q: np.ndarray, p: Numbers) -> np.ndarray:
    """The coordinates that may move: all, or those that no drive acts on and joints that follow loops.

    A base and axes whose motion is given stand.
    """
    chain, driven = model.chain, np.array(model.chain.held_places, int)
    every = np.arange(chain.base_v if chain.moving else 0, model.nv)
    if choice(joints, JOINTS, "joints: there is no") == "free":
        return np.setdiff1d(every, prescribed.places(chain))
    added = driven >= chain.eta_v - chain.n_added
    return np.setdiff1d(every, driven[stated_joints(model, q, p) | added])


def following(J: np.ndarray, springs: np.ndarray) -> np.ndarray | None:
    """How coordinates follow those that loops leave independent, (n, d), by the Jacobian (rows, n) of the gaps.

    None without loops. `springs` (n,): those without a spring follow first, so that the others keep their stiffness.
    """
    return mobility(J, by_spring(J, springs)).follow if len(J) else None


def _singular(model: RobotModel, q: np.ndarray, p: Numbers | None) -> SingularError:
    """The error that names the joint, if the dynamics know it."""
    zero = np.zeros(model.nv)
    try:
        model.numpy(p).forward_dynamics(q, zero, np.zeros(model.n_tau), np.zeros((model.n_links, 6)))
    except SingularError as error:
        return error
    return SingularError(f"the mass matrix is singular in this posture; lock the joints{model.chain.caution}")
