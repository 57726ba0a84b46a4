"""Vibrations about a steady motion: joints that turn at constant rates, links bent by centrifugal forces and weight.

About such a motion the linear equations have constant coefficients, ``M ẍ + G ẋ + K x = 0``: `G` is gyroscopic, and
`K` has the stiffness that the loads add or take. Damping is left out, as in :mod:`.modes`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..arguments import Numbers
from ..backends.numpy import prescribed
from ..backends.numpy.dae_step import SERIES
from ..backends.numpy.travel_numbers import efforts
from ..errors import SingularError, UsageError
from ..lazily import linalg
from ..robot_model import RobotModel
from ..simulation import validity as valid
from ..simulation.definiteness import check_definite
from ..simulation.validity import Validity
from ..topology.chain import Chain
from .linear import checked
from .statics import RESIDUAL, Statics, downhill, polished
from .stiffness import added_stiffness

if TYPE_CHECKING:
    from ..topology.loops import ClosingRow

ITERATIONS, SETTLED = 50, 1e-10
"""Newton steps to the steady deflection at most; a step of this size relative to the deflection is the last."""
FURTHER, SAME = 0.7, 1e-9
"""rad or m along the motion at which the loads on the links are compared, and the relative change that is none."""
NOTHING = 1e-12
"""Gyroscopic coupling, relative to the largest, that is a rounding error."""
UNRESISTED = 1e-10
"""Change of the forces by the turn of a joint, relative to the loads on the arm, that is a rounding error."""
PULLED = 1e-9
"""A force on a base that floats, relative to the largest, that is a rounding error."""
GROWTH = 1e-7
"""Real part of an eigenvalue, relative to the largest modulus, that is a rounding error."""


class Steady(NamedTuple):
    """Small motions x about a steady motion, ``M ẍ + G ẋ + K x = 0``, (nq, nq) each."""

    q: np.ndarray
    """(nq,): the joints as given, the links as the loads bend them."""
    v: np.ndarray
    """(nq,): the joints' rates, zeros for the modes."""
    M: np.ndarray
    G: np.ndarray
    K: np.ndarray
    tau: np.ndarray
    """(n_tau,): what keeps the joints at their rates."""
    p: np.ndarray
    """The parameter values, gravity zero where it is left out."""
    rigid: np.ndarray
    """(m, r): orthonormal motions of joints and rotors, the first m coordinates, that nothing resists."""
    J: np.ndarray
    """(rows, nq): of the gaps of loops, with q."""
    loops: Mapping[ClosingRow, float]
    """The forces of their rows."""
    w_ext: np.ndarray | None = None
    """(n, 6): what loops exert on the tips; None without."""

    def validity(self, model: RobotModel) -> Validity:
        """How far the motion is from the limits of the model."""
        if self.w_ext is not None:
            return valid.validity_at_rest(model, self.q, self.w_ext, self.p)
        return valid.validity(model, self.q, self.v, self.tau, parameters=self.p)


def steady(
    model: RobotModel,
    q: np.ndarray,
    rates: Numbers | None,
    loaded: bool,
    p: np.ndarray,
    moving: np.ndarray,
    settle: bool = True,
) -> Steady:
    """Small motions about the steady motion of the joints at `rates` (n_joints,) from `q` (nq,).

    `loaded`: gravity acts. `settle`: the modes of `q` move to where the loads hold them, rotors to where their
    gears carry the joints. The coordinates `moving` may move. What holds a ball joint is a moment with a potential
    that is linear in the vector of its turn: one that turned along with the link would have none. Raises UsageError
    where there is no such deflection, and where the loads on them change as joints turn.
    """
    chain = model.chain
    v = np.append(np.zeros(chain.base_v), chain.with_inner(checked(rates, "rates", model.n_joints), p))
    _refuse_turning_balls(chain, v)
    p = np.array(p, float) if loaded else np.r_[np.zeros(3), p[3:]]
    numeric, m = model.numpy(p), chain.eta_v
    if chain.base_v and not v.any():
        refuse_pulled_base(model, numeric.inverse_dynamics(q, v, None, None), numeric.slopes(q, v, None, None)[1])
    q = deflected(model, q, v, p) if settle else q
    M, K, C = numeric.slopes(q, v, None, None)
    check_definite(model, q, p)
    if np.linalg.eigvalsh(M[np.ix_(moving, moving)])[0] <= 0:
        raise SingularError(f"the mass matrix is singular in this posture; lock the joints{model.chain.caution}")
    force = numeric.inverse_dynamics(q, v, None, None)
    refuse_pulled_base(model, force, K)
    tau = chain.with_idle_inputs(efforts(chain, force[chain.held_places], chain.of_joints(q), p, held=True))
    if chain.travels:
        M, K, C = numeric.slopes(q, v, None, None, tau)
    if v.any():
        further = chain.integrate(q, FURTHER / np.max(np.abs(v)) * v, SERIES)
        loads = np.max(np.abs(K @ chain.flat(q)))
        _unchanged(force, numeric.inverse_dynamics(further, v, None, None), loads, moving)
        _unchanged(M, numeric.mass_matrix(further), np.max(np.abs(M)), moving)
    potential = (K + K.T) / 2
    K = K if v.any() else potential
    rigid = unresisted(K[:, unprescribed(chain)], force[chain.held_places], K[:, m:] @ q[chain.eta_q :])
    return Steady(q, v, M, (C - C.T) / 2, potential, tau, p, rigid, np.zeros((0, model.nv)), {})


def _refuse_turning_balls(chain: Chain, v: np.ndarray) -> None:
    """Raise UsageError where a ball joint turns: a small turn in axes that turn along has another rate than its own."""
    for part in chain.curved:
        if v[part.v].any():
            said = f"rates: the {part.joint.name} joint of link '{chain.names[part.link]}' turns, for which there is no"
            raise UsageError(f"{said} table of modes; leave its rates at zero, or simulate it")


def refuse_pulled_base(model: RobotModel, force: np.ndarray, K: np.ndarray) -> None:
    """Raise UsageError where forces to the world pull a base that floats, or hold it by their stiffness."""
    first = model.chain.base_v
    left, size = np.abs(force[:first]).max(initial=0.0), max(np.abs(force).max(initial=0.0), 1.0)
    if left > PULLED * size or np.abs(K[:, :first]).max(initial=0.0) > PULLED * np.abs(K).max():
        said = f"robot '{model.robot.name}' has a floating base, which forces between it and the world pull"
        raise UsageError(f"{said}; there is no table of its modes: take the eigenvalues of model.linearise")


def unprescribed(chain: Chain) -> np.ndarray:
    """The coordinates before the modes, in `v`, but for those whose motion is given."""
    return np.setdiff1d(np.arange(chain.eta_v), prescribed.places(chain))


def unresisted(columns: np.ndarray, *others: np.ndarray) -> np.ndarray:
    """(m, r): orthonormal combinations of m `columns` that vanish beside the columns and the `others`, all forces."""
    loads = max(np.max(np.abs(x), initial=0.0) for x in (columns, *others))
    _, sizes, rows = np.linalg.svd(columns)
    return rows[np.append(sizes, np.zeros(len(rows) - len(sizes))) <= UNRESISTED * loads].T


def deflected(model: RobotModel, q: np.ndarray, v: np.ndarray, p: np.ndarray) -> np.ndarray:
    """`q` with the modal coordinates at which no mode accelerates, by Newton's method from those of `q`.

    Where that leads nowhere and nothing moves, down the potential energy. The gears of elastic drives are wound by
    what holds their joints.
    """
    chain, q = model.chain, q.copy()
    if chain.n_added:
        first = chain.base_q
        q[first : chain.eta_q] = chain.with_added(q[first : chain.q_offset[-1]], p)
    found = _by_newton(model, q, v, p)
    if found is None and not (v.any() or chain.base_v):
        found = _downhill(model, q, p)
    if found is None:
        raise UsageError("the links find no steady deflection under these rates and loads")
    joints = slice(chain.base_v, chain.base_v + chain.n_joints)
    force = model.numpy(p).inverse_dynamics(found, v, None, None)[joints]
    return wound(model, found, efforts(chain, force, chain.of_joints(found), p) if chain.elastic_travels else force, p)


def _by_newton(model: RobotModel, q: np.ndarray, v: np.ndarray, p: np.ndarray) -> np.ndarray | None:
    """The same by Newton's method alone, gears as they are; None where it does not settle."""
    numeric, modes, eta = model.numpy(p), slice(model.chain.eta_v, model.nv), slice(model.chain.eta_q, model.nq)
    q = q.copy()
    for _ in range(ITERATIONS):
        K = numeric.slopes(q, v, None, None)[1][modes, modes]
        step = np.linalg.lstsq(K, numeric.inverse_dynamics(q, v, None, None)[modes])[0]
        q[eta] -= step
        if not np.isfinite(q).all():
            return None
        if np.max(np.abs(step), initial=0.0) <= SETTLED * np.max(np.abs(q[eta]), initial=0.0):
            return q
    return None


def _downhill(model: RobotModel, q: np.ndarray, p: np.ndarray) -> np.ndarray | None:
    """The same where the potential energy of the modes is least near `q`; None where there is no such place."""
    modes = np.arange(model.chain.eta_v, model.nv)
    statics = Statics(model, p, np.zeros(model.nv), np.zeros((model.chain.n, 6)), modes)
    b = polished(statics, downhill(statics, statics.at(q)))
    return b.q if b.residual <= RESIDUAL else None


def wound(model: RobotModel, q: np.ndarray, force: np.ndarray, p: np.ndarray) -> np.ndarray:
    """`q`, whose gears are without load, with rotors turned until their gears pass on the `force` (n_joints,).

    That is the torque at the joint, or the effort of its transmission.
    """
    chain, out = model.chain, q.copy()
    springs = np.array(added_stiffness(model, p), float)
    added = slice(chain.eta_q - chain.n_added, chain.eta_q)
    ratios = np.array([ratio or 1.0 for ratio in chain.ratios(p)], float)
    out[added] = out[added] + force[chain.added_joints] / (springs * ratios)
    return out


def _unchanged(here: np.ndarray, there: np.ndarray, scale: float, moving: np.ndarray) -> None:
    """Raise UsageError if forces or masses of what may move differ at two places along the motion."""
    places = np.ix_(*(moving,) * here.ndim)
    change = np.max(np.abs((there - here)[places]), initial=0.0)
    if change > SAME * max(scale, np.max(np.abs(here), initial=0.0)):
        text = "the loads on what may move change as the joints turn, so there is no steady motion at these rates"
        raise UsageError(f"{text}; turn one joint about the vertical, or leave gravity out")


class Oscillations(NamedTuple):
    """Natural motions: `omega` (count,) in rad/s, ascending, their `growth` (count,) in 1/s and `shapes` (n, count)."""

    omega: np.ndarray
    growth: np.ndarray
    """Zero where a motion does not grow; a motion that grows without oscillating has `omega` = 0 and comes first."""
    shapes: np.ndarray
    rigid: int
    """The number of motions that neither a spring nor a load resists."""


def oscillations(M: np.ndarray, G: np.ndarray, K: np.ndarray, rigid: np.ndarray | None = None) -> Oscillations:
    """The natural motions of ``M ẍ + G ẋ + K x = 0``; raises SingularError where `M` is.

    `rigid` (m, r): motions of the first m coordinates that nothing resists.
    """
    try:
        root = np.linalg.inv(np.linalg.cholesky((M + M.T) / 2)).T
    except np.linalg.LinAlgError:
        raise SingularError("the mass matrix is singular in this posture; lock the joints") from None
    rigid_motions = np.zeros((len(M), 0))
    if rigid is not None:
        rigid_motions = np.linalg.solve(root, np.vstack([rigid, np.zeros((len(M) - len(rigid), rigid.shape[1]))]))
    K, G = root.T @ K @ root, root.T @ G @ root
    held, space = _resisted(K, G, rigid_motions)
    omega, growth, columns = _natural(held, space.T @ G @ space)
    return Oscillations(omega, growth, root @ space @ columns, len(K) - len(held))


def _resisted(K: np.ndarray, G: np.ndarray, rigid_motions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Stiffness in the space of motions that are resisted, and orthonormal columns of that space.

    A motion x_0 with ``K x_0 = 0`` conserves its momentum, ``ẋ_0 + G_0 x = 0``. This adds ``G_0ᵀ G_0`` to the
    stiffness of the others. Where `G` couples such motions with each other, all motions stay.
    """
    vectors, count = np.linalg.qr(rigid_motions, mode="complete")[0], rigid_motions.shape[1]
    still, space = vectors[:, :count], vectors[:, count:]
    if np.max(np.abs(still.T @ G @ still), initial=0.0) > NOTHING * np.max(np.abs(G), initial=0.0):
        return K, np.eye(len(K))
    coupling = still.T @ G @ space
    return space.T @ K @ space + coupling.T @ coupling, space


def _natural(K: np.ndarray, G: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Circular frequencies, growth and columns of ``ẍ + G ẋ + K x = 0``."""
    k, vectors = np.linalg.eigh((K + K.T) / 2)
    if np.max(np.abs(G), initial=0.0) <= NOTHING * np.sqrt(np.max(np.abs(k), initial=0.0)):
        roots = np.sqrt(np.abs(k))
        return np.where(k > 0, roots, 0.0), np.where(k > 0, 0.0, roots), vectors
    n, G = len(k), vectors.T @ G @ vectors
    if (k > 0).all():
        # With positive stiffness the motion is stable: the state [√K x, ẋ] has a skew-symmetric matrix.
        skew = np.block([[np.zeros((n, n)), np.diag(np.sqrt(k))], [-np.diag(np.sqrt(k)), -G]])
        omega, states = np.linalg.eigh(-1j * skew)
        x = states[:n, n:] / np.sqrt(k)[:, None]
        return omega[n:], np.zeros(n), vectors @ _real(x)
    values, states = linalg.eig(np.block([[np.zeros((n, n)), np.eye(n)], [-np.diag(k), -G]]))
    size = GROWTH * np.max(np.abs(values))
    real, turn = np.where(np.abs(values.real) > size, values.real, 0.0), np.where(values.imag > size, values.imag, 0.0)
    kept = np.flatnonzero((turn > 0) & (real >= 0) | (real > 0) & (np.abs(values.imag) <= size))
    kept = kept[np.lexsort((real[kept], turn[kept]))]
    return turn[kept], real[kept], vectors @ _real(states[:n, kept])


def _real(x: np.ndarray) -> np.ndarray:
    """The columns at the phase at which their largest entry is real, of unit length."""
    largest = np.take_along_axis(x, np.argmax(np.abs(x), axis=0)[None], axis=0)
    out = (x * np.conj(largest) / np.maximum(np.abs(largest), np.finfo(float).tiny)).real
    return out / np.linalg.norm(out, axis=0)
