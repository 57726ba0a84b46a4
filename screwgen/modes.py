"""Natural frequencies: small vibrations about a posture at rest, without gravity."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import scipy.linalg

from .errors import SingularError, UsageError
from .linear import checked

if TYPE_CHECKING:
    from .build import Model

JOINTS = ("locked", "free")


def natural_frequencies(
    model: Model, q: Sequence[float] | None = None, joints: str = "locked", p: Sequence[float] | None = None
) -> np.ndarray:
    """The natural frequencies in Hz, ascending, at rest at `q` (nq,) or the joints alone, without gravity or damping.

    `joints`: "locked" leaves the modes alone to move, (n_modes,); "free" lets the joints turn on their own
    springs, (nq,): motions that no spring resists give exactly 0. `p`: parameter values, the file's by default.
    Raises UsageError, and SingularError where the mass matrix of what may move is singular.
    """
    found = mode_shapes(model, q, joints, p)
    return np.append(np.zeros(found.rigid), found.frequencies)


class ModeShapes(NamedTuple):
    """Small vibrations about a posture: `frequencies` (count,) in Hz, ascending; motions without springs left out."""

    frequencies: np.ndarray
    shapes: np.ndarray
    """(nq, count): each mode's column of coordinates, of unit modal mass; its sign is arbitrary."""
    rigid: int
    """The number of motions that no spring resists."""


def mode_shapes(
    model: Model, q: Sequence[float] | None = None, joints: str = "locked", p: Sequence[float] | None = None
) -> ModeShapes:
    """Natural frequencies with their shapes; arguments and errors as those of `natural_frequencies`."""
    if joints not in JOINTS:
        raise UsageError(f"joints are '{joints}'; they must be {' or '.join(JOINTS)}")
    if q is not None and np.size(q) == model.n_joints != model.nq:
        q = np.append(checked(q, "q", model.n_joints), np.zeros(model.nq - model.n_joints))
    q = checked(q, "q", model.nq)
    first = model.n_joints if joints == "locked" else 0
    M, k = model.numpy(p).mass_matrix(q)[first:, first:], stiffness(model, p)[first:]
    free, held = np.flatnonzero(k == 0), np.flatnonzero(k)
    out = np.zeros((model.nq, len(held)))
    try:
        M = (M + M.T) / 2
        rest, springs, rigid = without_rigid_motion(M, k)
        squares, vectors = scipy.linalg.eigh(np.diag(springs), rest) if len(springs) else (np.zeros(0), out[:0])
        out[first + held] = vectors
        if len(free):
            coupling = M[np.ix_(free, held)] @ vectors
            out[first + free] = -scipy.linalg.solve(M[np.ix_(free, free)], coupling, assume_a="pos")
    except np.linalg.LinAlgError:
        raise _singular(model, q, p) from None
    return ModeShapes(np.sqrt(np.maximum(squares, 0.0)) / (2 * np.pi), out, rigid)


def stiffness(model: Model, p: Sequence[float] | None = None) -> np.ndarray:
    """The diagonal of the stiffness matrix (nq,): joint springs (N·m/rad), then modes (N/m, torsion: N·m/rad)."""
    values = dict(zip(model.parameter_names, model.parameter_values if p is None else p, strict=True))
    springs = [
        values.get(f"{link.name}.joint.stiffness[{j}]", 0.0)
        for link in model.robot.links
        for j in range(len(link.joint.axes))
    ]
    return np.array([*springs, *(k for constants in model.numpy(p).constants for k in constants["K"])], float)


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


def _singular(model: Model, q: np.ndarray, p: Sequence[float] | None) -> SingularError:
    """The error that names the joint, if the dynamics know it."""
    zero = np.zeros(model.nq)
    try:
        model.numpy(p).forward_dynamics(q, zero, np.zeros(model.n_joints), np.zeros((model.n_links, 6)))
    except SingularError as error:
        return error
    return SingularError("the mass matrix is singular in this posture; lock the joints")
