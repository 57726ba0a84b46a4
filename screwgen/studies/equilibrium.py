"""Equilibria of an arm under gravity, at given joint angles or torques, and their stability."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy.linalg

from .. import notebook
from ..arguments import Given, Numbers, choice
from ..errors import UsageError
from ..simulation.motion import displacements
from ..simulation.validity import Validity
from .linear import checked
from .modes import stiffness
from .statics import Balance, NoEquilibriumError, Statics, search

if TYPE_CHECKING:
    from ..model import Model

__all__ = ["Equilibrium", "NoEquilibriumError", "equilibrium"]

MOST = 500
"""Coordinates: the exact stiffness, differentiated twice, takes memory as their square, 0.8 GB for so many."""
NEUTRAL = 1e-9
"""Scaled stiffness below which a direction counts as without."""


@dataclass(frozen=True, eq=False, repr=False)
class Equilibrium:
    """An arm at rest. SI units, radians; n links, nq coordinates."""

    q: np.ndarray
    """(nq,): joint coordinates, then modal ones."""
    tau: np.ndarray
    """(n_joints,): the joint torques, N·m, of slides forces, N; for held joints those that hold them."""
    held: bool
    """Whether joints are held; if not, they are free under `tau`."""
    passive: tuple[str, ...]
    """The joint coordinates that their springs carry while the others are held."""
    residual: float
    """The largest unbalanced force over the largest load of its unit, `Statics.scales`: at most 1e-10."""
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
    """(3,): the tip's displacement from its place with straight links, inertial components, m."""
    deflections: np.ndarray
    """(n, 3): each link's own tip from its undeformed centreline, F_i components, m."""
    validity: Validity
    """How far the links are from the limits of the model, of which `stability` knows nothing."""
    q_names: tuple[str, ...]
    """The names of the coordinates."""

    def __repr__(self) -> str:
        joints = "joints held" if self.held else "joints free"
        loose = f" with {', '.join(self.loose)}" if self.loose else ""
        sag = 1e3 * float(np.linalg.norm(self.tip_deflection))
        return f"<Equilibrium: {self.stability}{loose}, {joints}; the tip is deflected by {sag:.4g} mm>"

    def _repr_html_(self) -> str:
        """Coordinates with the torques on the joints, and the tip."""
        torques = [*map(notebook.number, self.tau), *[""] * (len(self.q) - len(self.tau))]
        rows = [*zip(self.q_names, self.q, torques, strict=True)]
        rows += [(f"tip_position.{axis}", x, "") for axis, x in zip("xyz", self.tip_position, strict=True)]
        force = "torque, N·m; of slides force, N" if any(".slide[" in x for x in self.q_names) else "torque, N·m"
        return notebook.table(repr(self).strip("<>"), ("", "value", force), rows)


def equilibrium(
    model: Model,
    q: Numbers | None = None,
    tau: Numbers | None = None,
    w_ext: Any = None,
    hold: bool | str = False,
    p: Given = None,
) -> Equilibrium:
    """The posture in which the arm rests.

    `hold`: the joints are held at `q` (n_joints,) and the torques follow. An axis with a spring, a stiffness > 0, is
    passive: nothing drives it, and it settles on its spring, from `q` on; "all" holds such axes too. Otherwise the
    torques `tau` (n_joints,), N·m, zero by default, act besides joint springs, and the angles follow: the search goes
    down the potential energy from `q`, so it ends in a stable posture, unless `q` is an equilibrium itself. `q` may
    hold the modes' start too (nq,).
    `w_ext` (n, 6), of the robot's n links or of all segments: wrenches [τ; F] that turn with the tip sections; they
    have no potential, so the search is one for forces that vanish, and what has positive stiffness may still flutter:
    then `stability` says so. `p`: parameter values. A :class:`ModelValidityWarning` says where a link is past the
    bounds of the model, in which a column beyond its buckling load is "stable". Raises UsageError, and
    NoEquilibriumError, which names the joint, where nothing balances the torques.
    """
    if not isinstance(hold, bool):
        choice(hold, ("all",), "hold: True, False or 'all'; there is no")
    if hold and tau is not None:
        raise UsageError("the torques follow where the joints are held; leave out the torques, or do not hold")
    model.chain.needs_fixed("equilibrium", "fix the base to find the posture of its arms")
    m = model.n_joints
    if model.nq > MOST:
        raise UsageError(f"the arm has {model.nq} coordinates; an equilibrium is sought for at most {MOST}")
    start = checked(q, "q", m) if q is not None and np.size(q) == m != model.nq else checked(q, "q", model.nq)
    start = np.append(start, np.zeros(model.nq - len(start)))
    load = np.append(checked(tau, "tau", m), np.zeros(model.nq - m))
    values = model.chain.parameters.vector(p)
    held = np.arange(model.nq) < m if hold else np.zeros(model.nq, bool)
    if hold != "all":
        held &= stiffness(model, values) == 0
    statics = Statics(model, values, load, model.chain.tip_wrenches(w_ext, "w_ext:"), np.flatnonzero(~held))
    found = _report(statics, search(statics, start), held[:m], bool(hold))
    found.validity.warn()
    return found


def _report(statics: Statics, b: Balance, held: np.ndarray, hold: bool) -> Equilibrium:
    model, m = statics.model, statics.model.n_joints
    straight = statics.at(np.append(b.q[:m], np.zeros(model.nq - m)))
    own = [displacements(model, b.q[None], i, [1.0])[0, 0] for i in range(len(model.robot.links))]
    stability, eigenvalues, loose = _stability(statics, b)
    return Equilibrium(
        q=b.q,
        tau=np.where(held, b.force[:m] + 0.0, statics.load[:m]),
        held=hold,
        passive=tuple(name for name, h in zip(model.q_names, held, strict=False) if hold and not h),
        residual=b.residual,
        stability=stability,
        stiffness=eigenvalues,
        loose=loose,
        wrench=b.wrench[model.chain.firsts],
        tip_position=b.tip,
        tip_deflection=b.tip - straight.tip,
        deflections=np.array(own),
        q_names=tuple(model.q_names),
        validity=model.validity_at_rest(b.q, statics.w_ext, statics.p),
    )


def _stability(statics: Statics, b: Balance) -> tuple[str, np.ndarray, tuple[str, ...]]:
    """The verdict, the eigenvalues and the names of the unstable coordinates."""
    K = statics.scaled(b)[1]
    if not len(K):
        return "stable", np.zeros(0), ()
    eigenvalues, vectors = scipy.linalg.eig(K) if statics.w_ext.any() else scipy.linalg.eigh((K + K.T) / 2)
    order = np.argsort(eigenvalues.real)
    values, vectors = eigenvalues.real[order], vectors[:, order]
    weak = [statics.moving[np.argmax(np.abs(vectors[:, k]))] for k in np.flatnonzero(values <= NEUTRAL)]
    loose = tuple(statics.model.q_names[k] for k in dict.fromkeys(weak))
    if values[0] < -NEUTRAL:
        return "unstable", values, loose
    if statics.w_ext.any() and _flutters(statics, b):
        return "flutter", values, loose
    return "neutral" if loose else "stable", values, loose


def _flutters(statics: Statics, b: Balance) -> bool:
    """Whether the undamped small motions have growing oscillations: squares of frequencies that are not real."""
    i = statics.moving
    M = statics.model.numpy(statics.p).mass_matrix(b.q)[np.ix_(i, i)]
    squares = scipy.linalg.eigvals(b.stiffness[np.ix_(i, i)], M)
    squares = squares[np.isfinite(squares)]
    return bool((np.abs(squares.imag) > 1e-6 * np.abs(squares)).any())
