"""Natural frequencies: small vibrations about a posture, at rest without gravity or turning and loaded."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import scipy.linalg

from ..arguments import Given, Numbers, choice
from ..errors import SingularError, UsageError
from ..simulation.validity import Validity, Watch
from .linear import checked
from .steady import oscillations, steady

if TYPE_CHECKING:
    from ..model import Model

JOINTS = ("locked", "free")


STUDY = "table of modes", "look at the robot with a fixed base and without loops"


def natural_frequencies(
    model: Model,
    q: Numbers | None = None,
    joints: str = "locked",
    p: Given = None,
    rates: Numbers | None = None,
    loaded: bool = False,
) -> np.ndarray:
    """The natural frequencies in Hz, ascending, at rest at `q` (nq,) or the joints alone, without gravity or damping.

    `joints`: "locked" leaves the modes alone to move, (n_modes,), joints with springs locked like all others; where
    drives are elastic it locks their rotors, and the joint moves on its gear. "free" lets the joints turn on their own
    springs, (nq,): motions that no spring resists give exactly 0. `p`: parameter
    values, the file's by default.
    `rates` (n_joints,), rad/s or m/s: of an arm whose joints turn steadily, kept at their rates where they are locked,
    under constant torques where they are free. `loaded`: gravity bends the links and changes their stiffness. In both
    cases torques hold the joints at `q`, and the vibrations are about the deflection that follows.
    Raises UsageError, also where the loads change with the motion or where vibrations grow, and SingularError where
    the mass matrix of what may move is singular.

    Where the links bear or bend more than the bounds of the model allow, a :class:`ModelValidityWarning` says so: under
    their weight also where gravity has no part in the frequencies.
    """
    found = mode_shapes(model, q, joints, p, rates, loaded)
    found.validity.warn()
    if found.growth.any():
        raise UsageError(f"{found.unstable}; mode_shapes tells how fast they grow")
    return np.append(np.zeros(found.rigid), found.frequencies)


class ModeShapes(NamedTuple):
    """Small vibrations about a posture: `frequencies` (count,) in Hz, ascending; motions without springs left out."""

    frequencies: np.ndarray
    shapes: np.ndarray
    """(nq, count): each mode's column of coordinates, of unit modal mass; its sign is arbitrary. About a turning arm:
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
    model: Model,
    q: Numbers | None = None,
    joints: str = "locked",
    p: Given = None,
    rates: Numbers | None = None,
    loaded: bool = False,
) -> ModeShapes:
    """Natural frequencies with their shapes; arguments and errors as those of `natural_frequencies`."""
    model.chain.needs_fixed_tree(*STUDY)
    p = model.chain.parameters.vector(p)
    q, moving = posture(model, q, p), movable(model, joints)
    if not len(moving):
        nothing = Watch(model.chain.names).validity()
        return ModeShapes(np.zeros(0), np.zeros((model.nq, 0)), 0, nothing, np.zeros(0))
    if loaded or rates is not None:
        about = steady(model, q, rates, loaded, p, moving)
        M, G, K = (x[np.ix_(moving, moving)] for x in (about.M, about.G, about.K))
        omega, growth, columns, rigid = oscillations(M, G, K, about.rigid if len(moving) == model.nv else None)
        shapes = np.zeros((model.nv, len(omega)))
        shapes[moving] = columns
        return ModeShapes(omega / (2 * np.pi), shapes, rigid, about.validity(model), growth)
    out, frequencies, rigid = _at_rest(model, q, p, moving)
    validity = model.validity_at_rest(q, parameters=p)
    return ModeShapes(frequencies / (2 * np.pi), out, rigid, validity, np.zeros(len(frequencies)))


def _at_rest(model: Model, q: np.ndarray, p: np.ndarray, moving: np.ndarray) -> tuple[np.ndarray, np.ndarray, int]:
    """Shapes (nq, count) and circular frequencies at rest without gravity, and the number of rigid motions.

    Where rotors move, their coordinates are those relative to their joints, so that the stiffness of gears is theirs.
    """
    T, K = np.eye(model.nv), stiffness_matrix(model, p)
    if len(moving) == model.nv and model.chain.n_motors:
        T, K = relative(model, p), stiffness_matrix(model, p, relative=True)
    M, K = (x[np.ix_(moving, moving)] for x in (T.T @ model.numpy(p).mass_matrix(q) @ T, K))
    free, held = np.flatnonzero(np.diag(K) == 0), np.flatnonzero(np.diag(K))
    out = np.zeros((model.nv, len(held)))
    try:
        basis, k = uncoupled(K)
        M = basis.T @ ((M + M.T) / 2) @ basis
        rest, springs, rigid = without_rigid_motion(M, k)
        frequencies, vectors = vibrations(rest, springs)
        out[moving[held]] = vectors
        if len(free):
            coupling = M[np.ix_(free, held)] @ vectors
            out[moving[free]] = -scipy.linalg.solve(M[np.ix_(free, free)], coupling, assume_a="pos")
        out[moving] = basis @ out[moving]
    except np.linalg.LinAlgError:
        raise _singular(model, q, p) from None
    return T @ out, frequencies, rigid


def posture(model: Model, q: Numbers | None, p: Numbers) -> np.ndarray:
    """The coordinates (nq,) of a posture: as given, the joints alone, or all zero; a floating base at home."""
    if model.chain.floating and (q is None or np.size(q) == model.n_joints):
        joints = np.zeros(model.n_joints) if q is None else checked(q, "q", model.n_joints)
        return np.append(model.chain.home[: model.chain.base_q], model.chain.filled(joints, p))
    if q is not None and np.size(q) == model.n_joints != model.nq:
        q = model.chain.filled(checked(q, "q", model.n_joints), p)
    return checked(q, "q", model.nq)


def movable(model: Model, joints: str) -> np.ndarray:
    """The coordinates that may move: all, or those that no drive acts on."""
    locked = choice(joints, JOINTS, "joints: there is no") == "locked"
    return np.setdiff1d(np.arange(model.nv), model.chain.driven if locked else [])


def relative(model: Model, p: Numbers) -> np.ndarray:
    """T (nq, nq): the coordinates from those with rotors relative to where their joints would turn them."""
    chain, T = model.chain, np.eye(model.nv)
    T[chain.eta_v - chain.n_motors + np.arange(chain.n_motors), chain.geared] = chain.ratios(p)
    return T


def vibrations(M: np.ndarray, k: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Angular frequencies, ascending, and columns of unit modal mass of `M ẍ + k x = 0`; all `k` > 0.

    With `M = L Lᵀ` the columns of `Lᵀ k^(-1/2)` have the singular values 1/ω. Springs that differ by many orders of
    magnitude scale its columns, which a Jacobi method bears: every frequency keeps its digits. An eigenvalue solver
    for `k` and `M` leaves an error of the stiffest spring's size in the softest mode.
    """
    if not len(k):
        return np.zeros(0), np.zeros((0, 0))
    L = scipy.linalg.cholesky(M, lower=True)
    periods, vectors, _, scale, _, failed = scipy.linalg.lapack.dgejsv(L.T / np.sqrt(k), joba=0, jobv=3, jobp=0)
    if failed:
        raise np.linalg.LinAlgError("the Jacobi method does not converge")
    return scale[1] / scale[0] / periods, scipy.linalg.solve_triangular(L.T, vectors)


def stiffness_matrix(model: Model, p: Numbers | None = None, relative: bool = False) -> np.ndarray:
    """The stiffness (nv, nv) of joint springs and gears (N·m/rad) and modes (N/m, torsion: N·m/rad).

    `relative`: in coordinates in which gears act on rotors alone, see the function of that name.
    """
    K, first = np.diag(stiffness(model, p)), model.chain.eta_v - model.chain.n_motors
    gears = [k for constants in model.numpy(p).constants for k in constants.get("K_theta", ())]
    ratios = model.chain.ratios(model.parameter_values if p is None else p)
    for rotor, (joint, k, ratio) in enumerate(zip(model.chain.geared, gears, ratios, strict=True), first):
        K[rotor, rotor] = k
        if not relative:
            K[joint, joint] += ratio**2 * k
            K[rotor, joint] = K[joint, rotor] = -ratio * k
    for i, key in enumerate(model.chain.keys):
        first = model.chain.eta_v + model.chain.eta_offset[i]
        for (a, b), k in zip(key.coupled, model.numpy(p).constants[i].get("K_below", ()), strict=True):
            K[first + a, first + b] = K[first + b, first + a] = k
    return K


def uncoupled(K: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Columns ``T`` (n, n) with ``T^T K T = diag(k)``, and ``k`` (n,); rows of ``K`` without a spring are zero.

    ``K = L diag(k) L^T`` and ``T = L^-T``, so that small stiffnesses keep their digits beside large ones.
    """
    k, held = np.diag(K).copy(), np.flatnonzero(np.diag(K))
    T = np.eye(len(K))
    if not np.array_equal(K, np.diag(k)):
        C = scipy.linalg.cholesky(K[np.ix_(held, held)], lower=True)
        k[held] = np.diag(C) ** 2
        T[np.ix_(held, held)] = scipy.linalg.solve_triangular(C / np.diag(C), np.eye(len(held)), lower=True).T
    return T, k


def stiffness(model: Model, p: Numbers | None = None) -> np.ndarray:
    """The stiffness of joint springs (N·m/rad) and of modes (N/m, torsion: N·m/rad), (nv,); of rotors zero.

    A floating base, whose six entries come first, has none.
    """
    values = dict(zip(model.parameter_names, model.parameter_values if p is None else p, strict=True))
    springs = [
        values.get(f"{link.name}.joint.stiffness[{j}]", 0.0)
        for link in model.robot.links
        for j in range(len(link.joint.axes))
    ]
    modal = (k for constants in model.numpy(p).constants for k in constants["K"])
    chain = model.chain
    return np.array([*[0.0] * chain.base_v, *springs, *[0.0] * chain.n_motors, *modal], float)


def without_rigid_motion(M: np.ndarray, k: np.ndarray) -> tuple[np.ndarray, np.ndarray, int]:
    """Mass and stiffness with the coordinates that no spring holds eliminated, and how many they are.

    Such a coordinate follows the others without force: `M <- M_ee − M_er M_rr⁻¹ M_re`.
    """
    free, held = np.flatnonzero(k == 0), np.flatnonzero(k)
    factor = scipy.linalg.cho_factor(M[np.ix_(free, free)]) if len(free) else None
    rest = M[np.ix_(held, held)]
    if factor is not None and len(held):
        coupling = M[np.ix_(free, held)]
        rest = rest - coupling.T @ scipy.linalg.cho_solve(factor, coupling)
    return rest, k[held], len(free)


def _singular(model: Model, q: np.ndarray, p: Numbers | None) -> SingularError:
    """The error that names the joint, if the dynamics know it."""
    zero = np.zeros(model.nv)
    try:
        model.numpy(p).forward_dynamics(q, zero, np.zeros(model.n_tau), np.zeros((model.n_links, 6)))
    except SingularError as error:
        return error
    return SingularError(f"the mass matrix is singular in this posture; lock the joints{model.chain.caution}")
