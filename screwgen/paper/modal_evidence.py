"""Numbers that show what the printed modal projection misses, on the judge's arm, on beams and on a turning link."""

from __future__ import annotations

from collections.abc import Callable
from copy import copy

import numpy as np
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import leggauss
from scipy.linalg import block_diag, eigh
from scipy.spatial.transform import Rotation

from ..algebra.expression import Expression, Symbol
from ..algebra.rewrite import symbols
from .appendix_b import DERIVED_H_MD, DERIVED_M_DPSI, PRINTED_H_MD, PRINTED_M_DPSI
from .arm import LENGTHS
from .arm_state import EquationValues
from .discretised import RATE, VELOCITY, energy
from .evaluate import evaluate
from .jets import Jet, skew
from .modal_rows import Accelerated
from .moving_link import body_jacobian
from .projection import L
from .random_motion import RandomMotion

ROOT = 1.8751040687119611
"""The first root of cos x cosh x = -1."""
STRAIGHT = {f"{name}:{k}": np.zeros((n, 1)) for name, n in (("eta", 6), ("r_xi", 3)) for k in "12"}


# --------------------------------------------------------------------------------- a turning link


def at_origin_of_link_2(left: Expression) -> float:
    """The acceleration along the arm, m/s², that the left side of (81) gives the first element of link 2.

    The straight rigid arm turns about the vertical at 1 rad/s; there is no gravity.
    """
    r = np.array([[LENGTHS[0]], [0.0], [0.0]])
    given = {"omega:i": np.array([[0.0], [0], [1]]), "r_ob:i": r, "r:i": r, "rhoA:i": np.ones((1, 1)), "R:i": np.eye(3)}
    zeros = {s.name: np.zeros(s.shape) for s in symbols(left) if isinstance(s, Symbol)}
    return float(evaluate(left, EquationValues(zeros | given, {}))[0, 0])


# ------------------------------------------------------------------------------- the judge's arm


def cross_energy(seed: int = 1) -> tuple[float, float, float]:
    """What twist and modal rates add to the kinetic energy together, J: without ρA, with it, and by definition."""
    link = RandomMotion(seed).links[1]
    v = link.values
    rigid = v["v"] + skew(v["omega"]) @ v["r_ib"]
    elastic = link.shapes(link.xi) @ v["etadot"]
    kinetic = lambda u: float(link.sum(np.swapaxes(u, -1, -2) @ u)[0, 0]) * link.rhoA / 2  # noqa: E731
    phi = np.swapaxes(link.shapes(link.xi), -1, -2)
    per_mass = np.hstack([link.sum(-phi @ skew(v["r_ib"])), link.sum(phi)])
    form = float((v["etadot"].T @ per_mass @ v["V"])[0, 0])
    return form, link.rhoA * form, kinetic(rigid + elastic) - kinetic(rigid) - kinetic(elastic)


def ratio_to_transpose(seed: int = 1) -> tuple[float, float]:
    """The force columns of ``M_Dphi`` over the measured ``M_D``, transposed: as (85) prints them, and with ρA."""
    motion = RandomMotion(seed)
    size = lambda X: float(np.abs(X).max())  # noqa: E731
    measured = size(motion.values["M_D_link:i"][3:])
    printed, derived = L.integral(L.phi.T), L.integral(L.phi.T, L.rhoA)
    return size(evaluate(printed, motion)) / measured, size(evaluate(derived, motion)) / measured


def gap_of_row_order(seed: int = 1) -> tuple[float, float]:
    """Misfits of (95) with all of (B1) as derived, but with its translational rows first; and as derived."""
    v = {name: value for name, value in RandomMotion(seed).values.items() if name.endswith(":all")}
    rest = v["M_DPsi:all"] @ v["Psi_Z_s:all"] + v["h_MD:all"] - v["D_s:all"]
    swapped = np.vstack([half for rows in np.split(v["M_D:all"], 4) for half in (rows[3:], rows[:3])])
    gap = lambda M: float(np.abs(M @ v["eta_s:all"] + rest).max() / np.abs(v["D_s:all"]).max())  # noqa: E731
    return gap(swapped), gap(v["M_D:all"])


def differential_rows(links: int = 2) -> tuple[int, int, int]:
    """How many row blocks of three (103) pairs: with k = 1 … n, with k = 0 … n-1, and how many there are."""
    named = lambda start: {4 * k + j for k in range(start, start + links) for j in (3, 4)}  # noqa: E731
    there = set(range(1, 4 * links + 1))
    return len(named(1) & there), len(named(0) & there), 2 * links


def kinetic_energies(seed: int = 1) -> tuple[float, float, float]:
    """The kinetic energy of the judge's link, J: (2T) as printed, as derived, and by definition."""
    motion = RandomMotion(seed)
    printed, derived = (evaluate(e.right, motion).item() / 2 for e in (energy(RATE, RATE), energy(VELOCITY, L.Z)))
    return printed, derived, motion.values["T:i"].item()


def lowest_eigenvalue(seed: int = 1) -> tuple[float, float]:
    """Of the symmetric part of the differential-modal block, over the largest: printed, and with its rows in Z."""
    v = RandomMotion(seed).values
    M = np.block([[v["M_dyn_diff:i"], v["M_D_link:i"]], [v["M_Dphi_diff:i"], v["M_Wphi:i"]]])
    rows = block_diag(np.eye(6) + v["T_gamma:i"].T, np.eye(len(M) - 6))
    printed, derived = (np.linalg.eigvalsh((X + X.T) / 2) for X in (M, rows @ M))
    return float(printed[0] / printed[-1]), float(derived[0] / derived[-1])


def block_asymmetry(seed: int = 1) -> tuple[float, float]:
    """The asymmetry of ``M_s (I + T_gamma)`` of a link, relative to its largest entry, and with its rows in Z too."""
    v = RandomMotion(seed).values
    to_V = np.eye(6) + v["T_gamma:i"]
    gap = lambda M: float(np.abs(M - M.T).max() / np.abs(M).max())  # noqa: E731
    return gap(v["M_star:i"] @ to_V), gap(to_V.T @ v["M_star:i"] @ to_V)


def force_of_turning(seed: int = 1) -> tuple[float, float, float]:
    """The largest force, N, that the deformation of link 2 needs at 1 rad/s² about z: (B2) printed, derived, truth."""
    motion = RandomMotion(seed)
    unit = np.zeros((24, 1))
    unit[20] = 1.0
    link = motion.links[1]
    truth = link.rhoA * link.sum(np.cross([0.0, 0, 1], motion.values["r_xi:2"][..., 0])[..., None])
    printed = evaluate(PRINTED_M_DPSI, motion)[18:21] @ unit  # its third row block of link 2 is the force
    derived = evaluate(DERIVED_M_DPSI, motion)[21:24] @ unit
    size = lambda x: float(np.abs(x).max())  # noqa: E731
    return size(printed), size(derived), size(truth)


def moved_end() -> tuple[float, float]:
    """The elastic acceleration of the base of a straight link at 1 rad/s² about z, printed in (B2) and derived."""
    motion = RandomMotion(1)
    straight = EquationValues(motion.values | STRAIGHT, motion.weights)
    size = lambda x: float(np.linalg.norm(x @ [0.0, 0, 1]))  # noqa: E731
    return size(evaluate(PRINTED_M_DPSI, straight)[0:3, 6:9]), size(evaluate(DERIVED_M_DPSI, straight)[3:6, 6:9])


def deformation_carried(seed: int = 1) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """Largest entries of what the deformation adds to the rows of link 2, N·m: (B2), (B3) printed, derived, and D*.

    First where only ``rddot``, 1 m/s² along y, is not zero; then ``h_MD`` without modal rates, so with all of the
    accelerations and modal rates zero.
    """
    motion = RandomMotion(seed)
    link, Zdot = copy(motion.links[1]), np.eye(6)[:, 4:5]
    still = np.zeros_like(link.eta.value)
    link.eta = Jet(link.eta.value, still, still)
    bias, moved = (Accelerated(link, Z, still).values["D_star"] for Z in (0 * Zdot, Zdot))
    rigid = EquationValues(motion.values | {"etadot:1": still, "etadot:2": still}, motion.weights)
    size = lambda x: float(np.abs(x).max())  # noqa: E731
    columns = lambda M: size(evaluate(M, motion)[18:, 18:] @ Zdot)  # noqa: E731
    biases = lambda h: size(evaluate(h, rigid)[18:])  # noqa: E731
    return (
        (columns(PRINTED_M_DPSI), columns(DERIVED_M_DPSI), size(moved - bias)),
        (biases(PRINTED_H_MD), biases(DERIVED_H_MD), size(bias)),
    )


# ------------------------------------------------------------------------------------ a cantilever


def first_frequencies(count: int = 4) -> tuple[float, float, float]:
    """``(beta l)²`` of the first bending mode of a cantilever by orthonormal polynomials s², s³, …

    With the stiffness as (82) prints it, from fourth derivatives of equal modes; in the weak form of equal modes; and
    in the weak form of all pairs.
    """
    x, w = leggauss(20)
    s, weights = (1 + x) / 2, w / 2
    powers = [Polynomial([0] * (k + 2) + [1]) for k in range(count)]
    table = lambda order: np.array([(p.deriv(order) if order else p)(s) for p in powers])  # noqa: E731
    mix = np.linalg.inv(np.linalg.cholesky((table(0) * weights) @ table(0).T))
    value, bent, fourth = (mix @ table(order) for order in (0, 2, 4))
    strong, weak = np.diag((fourth * weights) @ value.T), (bent * weights) @ bent.T
    root = lambda x: float(np.sqrt(max(x, 0.0)))  # noqa: E731
    return root(strong.min()), root(np.diag(weak).min()), root(eigh(weak, eigvals_only=True)[0])


# ------------------------------------------------------------------------------------ coordinates


def attitude_errors(duration: float = 1.0, steps: int = 400) -> tuple[float, float]:
    """Degrees by which a link that turns at 1 rad/s about its z axis is misplaced after a second.

    It starts turned by 1 rad about x; theta is integrated by RK4 with ``thetadot = J omega``, and with ``J^-1 omega``.
    """
    omega, start = np.array([[0.0], [0], [1]]), np.array([[1.0], [0], [0]])
    truth = Rotation.from_rotvec(start[:, 0]) * Rotation.from_rotvec(duration * omega[:, 0])

    def error(law: Callable[[np.ndarray], np.ndarray]) -> float:
        turned = _integrated(law, start, duration / steps, steps)
        return float(np.degrees((truth.inv() * turned).magnitude()))

    return error(lambda t: body_jacobian(t) @ omega), error(lambda t: np.linalg.solve(body_jacobian(t), omega))


def _integrated(law: Callable[[np.ndarray], np.ndarray], theta: np.ndarray, h: float, steps: int) -> Rotation:
    for _ in range(steps):
        k1 = law(theta)
        k2 = law(theta + h / 2 * k1)
        k3 = law(theta + h / 2 * k2)
        theta = theta + h / 6 * (k1 + 2 * k2 + 2 * k3 + law(theta + h * k3))
    return Rotation.from_rotvec(theta[:, 0])
