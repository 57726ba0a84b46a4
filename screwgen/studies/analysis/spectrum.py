"""The spectrum of the motions linearised about a state, their Jacobian, and methods' amplification matrices."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arguments import Numbers
from ...errors import UsageError
from ...robot_model import RobotModel
from ...simulation.linearised import STILL, TOLERANCE, Law, Linearised, Parameters


def check_moves(model: RobotModel, v: np.ndarray) -> None:
    """Refuse rates (nv,) of a base or of ball joints: steps are linearised where these rest."""
    for part in model.chain.curved:
        if np.any(v[part.v]):
            said = f"the {part.joint.name} joint of link '{model.chain.names[part.link]}' moves in this state"
            raise UsageError(f"{said}, about which steps are not linearised; give states in which it rests")


def jacobian(
    model: RobotModel,
    q: Numbers,
    v: Numbers,
    tau: Numbers | None = None,
    w_ext: Numbers | None = None,
    parameters: Parameters | None = None,
    controller: Law | None = None,
) -> np.ndarray:
    """`A` (2 nv, 2 nv) with `d/dt [δ; δv] = A [δ; δv]`: the dynamics linearised at `q` (nq,), `v` (nv,), exactly.

    `tau` (n_joints,), N·m, and `w_ext` (n, 6) are held; with a `controller(t, q, v)` the torques follow the
    motion instead, at t = 0. Derivatives by automatic differentiation. Raises UsageError, SingularError.
    """
    return Linearised(model, q, v, tau, controller, w_ext, parameters).jacobian


def step_map(
    model: RobotModel,
    method: str,
    q: Numbers,
    v: Numbers,
    step: float,
    tau: Numbers | None = None,
    controller: Law | None = None,
    w_ext: Numbers | None = None,
    parameters: Parameters | None = None,
) -> np.ndarray:
    """`S` (2 nv, 2 nv) with `[δ; δv]` after a step `= S [δ; δv]` before it: the amplification matrix.

    It is the method itself (of `integrators`, which the generated C steps too) applied to the dynamics
    linearised at `q`, `v`; `step` in s. `tau` (n_joints,), N·m, is held; with a `controller(t, q, v)` the
    torques are those of the step's start, held over the step, as in a simulation. For methods that evaluate the
    dynamics once a step, and for all of them at an equilibrium, S is the exact derivative of the step.
    Raises UsageError, SingularError.
    """
    check_moves(model, np.asarray(v, float))
    return Linearised(model, q, v, tau, controller, w_ext, parameters).step_map(method, step)


def growth(S: np.ndarray) -> float:
    """The spectral radius of a step map: the asymptotic growth factor per step."""
    return float(np.abs(np.linalg.eigvals(S)).max(initial=0.0))


# ------------------------------------------------------------------------------ motions


@dataclass(frozen=True)
class LinearMotion:
    """A motion `exp(λ t)` of the linearised arm; a conjugate pair is one, with the positive imaginary part.

    `kind`: "oscillates", "grows" (an oscillation that gains), "falls" (real, growing), "decays" (real, shrinking) or
    "free" (nothing drives it back); `frequency_hz`: |λ| / 2π of an oscillation, else 0; `damping`: its ratio −Re λ/|λ|;
    `coordinate`: the one with the largest share of the motion's kinetic energy.
    """

    eigenvalue: complex
    kind: str
    frequency_hz: float
    damping: float
    coordinate: str


def motions(motion: Linearised) -> list[LinearMotion]:
    """The spectrum: motions that fall, then the others by |λ|, slowest first."""
    eigenvalues, vectors = np.linalg.eig(motion.jacobian)
    largest = np.abs(eigenvalues).max(initial=0.0)
    found = []
    for x, vector in zip(eigenvalues.astype(complex), vectors.T, strict=True):
        if abs(x) <= STILL * largest:
            x = 0j
        if x.imag >= 0:
            u = vector[: len(vector) // 2]
            share = np.abs((u.conj() * (motion.inertia @ u)).real)
            found.append(_motion(complex(x), motion.names[int(share.argmax())]))
    return sorted(found, key=lambda m: (m.kind != "falls", abs(m.eigenvalue)))


def _motion(x: complex, coordinate: str) -> LinearMotion:
    if x == 0:
        return LinearMotion(x, "free", 0.0, 0.0, coordinate)
    if x.imag == 0:
        return LinearMotion(x, "falls" if x.real > 0 else "decays", 0.0, float(-np.sign(x.real)), coordinate)
    damping = -x.real / abs(x)
    return LinearMotion(x, "grows" if damping < -TOLERANCE else "oscillates", abs(x) / (2 * np.pi), damping, coordinate)
