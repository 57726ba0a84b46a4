"""Lagrange's equations in CasADi, as one writes them today without a tool for flexible arms.

Kinetic and potential energy of the arm from closed-form mode integrals; the mass matrix is the Jacobian of the
momenta, the bias a directional derivative, the solve CasADi's LDLᵀ. Nothing of screwgen's derivation is used: the
robot's description goes in, shapes and integrals are computed here by quadrature. Robots without mounts and bodies.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np
import scipy.optimize

NODES = 40
SERIES = 6
"""Terms of the section's rotation: exact to rounding at the measured states, and cheaper than sine, cosine and root."""


@dataclass(frozen=True)
class Integrals:
    """Constants of one link of mass ``m`` (kg): ``first`` (3,) = ∫ρA r and ``second`` (3, 3) = ∫ρA r rᵀ of the straight
    link, ``S`` (3, r) = ∫ρA Φ, ``X`` (3, 3, r) = ∫ρA r Φᵀ, ``G`` (3, 3, r, r) = ∫ρA ΦΦᵀ, by axes of displacement; ``K``
    (r,) modal stiffness, ``tip`` (3, r) displacement and ``slope`` (3, r) rotation of the tip section."""

    m: float
    first: np.ndarray
    second: np.ndarray
    S: np.ndarray
    X: np.ndarray
    G: np.ndarray
    K: np.ndarray
    tip: np.ndarray
    slope: np.ndarray


def clamped_free(k: int, s):
    """ψ, ψ', ψ'' of the k-th clamped-free beam mode, orthonormal on [0, 1]."""
    guess = (k - 0.5) * np.pi + (0.3042 if k == 1 else 0.0)
    root = scipy.optimize.brentq(lambda x: np.cos(x) + 1 / np.cosh(x), guess - 0.3, guess + 0.3, xtol=1e-15)
    ratio = (np.sinh(root) - np.sin(root)) / (np.cosh(root) + np.cos(root))
    x = root * s
    value = np.cosh(x) - np.cos(x) - ratio * (np.sinh(x) - np.sin(x))
    slope = root * (np.sinh(x) + np.sin(x) - ratio * (np.cosh(x) - np.cos(x)))
    return value, slope, root**2 * (np.cosh(x) + np.cos(x) - ratio * (np.sinh(x) + np.sin(x)))


def stretching(k: int, s):
    """√2 sin((2k−1)πs/2), its first derivative twice: the stiffness of a rod rests on ψ'."""
    w = (2 * k - 1) * np.pi / 2
    slope = np.sqrt(2) * w * np.cos(w * s)
    return np.sqrt(2) * np.sin(w * s), slope, slope


def integrals(link) -> Integrals:
    """The constants of a link of the robot's description."""
    l, section, modes = link.length, link.section, link.modes
    if link.bodies or link.joint.mount or modes.torsion or modes.basis != "clamped_free":
        raise ValueError(f"{link.name}: only links with clamped-free modes, without bodies, mounts and torsion")
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    s, w = (nodes + 1) / 2, weights / 2
    shapes = [(0, stretching, k, section.EA / l) for k in range(1, modes.axial + 1)]
    for axis, count, stiffness in ((1, modes.bending_y, section.EIz), (2, modes.bending_z, section.EIy)):
        shapes += [(axis, clamped_free, k, stiffness / l**3) for k in range(1, count + 1)]
    r, m = len(shapes), section.rhoA * l
    Phi, tip, slope, K = np.zeros((3, r, NODES)), np.zeros((3, r)), np.zeros((3, r)), np.zeros(r)
    for j, (axis, shape, k, stiffness) in enumerate(shapes):
        Phi[axis, j], _, bent = shape(k, s)
        K[j] = stiffness * w @ bent**2
        tip[axis, j], slope_at_tip, _ = shape(k, 1.0)
        if axis:  # θ = [0, −u_z', u_y']
            slope[3 - axis, j] = slope_at_tip / l * (1 if axis == 1 else -1)
    line = np.stack([l * s, 0 * s, 0 * s])
    return Integrals(
        m=m,
        first=m * line @ w,
        second=m * np.einsum("an,bn,n->ab", line, line, w),
        S=clean(m * Phi @ w),
        X=clean(m * np.einsum("an,bjn,n->abj", line, Phi, w)),
        G=clean(m * np.einsum("ajn,bkn,n->abjk", Phi, Phi, w)),
        K=K,
        tip=tip,
        slope=slope,
    )


def clean(x: np.ndarray) -> np.ndarray:
    """Integrals that vanish but for rounding as zeros, as a user would leave them out."""
    return np.where(np.abs(x) < 1e-12 * np.max(np.abs(x), initial=1e-300), 0.0, x)


def turn(axis, angle: ca.SX) -> ca.SX:
    """The rotation about a unit axis."""
    a = ca.sparsify(ca.SX(ca.skew(ca.DM(list(axis)))))
    return ca.sparsify(ca.SX.eye(3) + ca.sin(angle) * a + (1 - ca.cos(angle)) * (a @ a))


def section_rotation(theta: ca.SX) -> ca.SX:
    """exp of a small rotation vector, by the power series in θ·θ."""
    x, sine, cosine = ca.dot(theta, theta), ca.SX(1), ca.SX(1)
    for j in reversed(range(SERIES)):
        sine = 1 - x * sine / ((2 * j + 2) * (2 * j + 3))
        cosine = 1 - x * cosine / ((2 * j + 3) * (2 * j + 4))
    T = ca.skew(ca.sparsify(theta))
    return ca.SX.eye(3) + sine * T + cosine / 2 * (T @ T)


def rate(x: ca.SX, q: ca.SX, v: ca.SX) -> ca.SX:
    """d/dt of a matrix along v."""
    return ca.reshape(ca.jtimes(ca.vec(ca.densify(x)), q, v), *x.shape)


def angular_velocity(R: ca.SX, q: ca.SX, v: ca.SX) -> ca.SX:
    """Of a rotation matrix that depends on q, in components of the turned frame."""
    W = R.T @ rate(R, q, v)
    return ca.vertcat(W[2, 1], W[0, 2], W[1, 0])


@dataclass
class Frame:
    """A frame on the way along the arm: pose in inertial components, twist in its own (for recursion only)."""

    R: ca.SX
    position: ca.SX
    omega: ca.SX
    velocity: ca.SX

    def turned(self, axis, angle: ca.SX, speed: ca.SX) -> Frame:
        step = turn(axis, angle)
        omega = step.T @ self.omega + ca.DM(list(axis)) * speed
        return Frame(self.R @ step, self.position, omega, step.T @ self.velocity)


def kinetic(x: Integrals, eta: ca.SX, etadot: ca.SX, omega: ca.SX, velocity: ca.SX) -> ca.SX:
    """Kinetic energy of a link from its twist and modal velocities, in the link's components."""
    second, L = ca.SX(ca.DM(x.second)), ca.SX.zeros(3, 3)  # ∫ρA ρρᵀ with ρ = r + Φη, and ∫ρA ρ(Φη̇)ᵀ
    for a in range(3):
        for b in range(3):
            X, Y, G = ca.DM(x.X[a, b]), ca.DM(x.X[b, a]), ca.sparsify(ca.DM(x.G[a, b]))
            second[a, b] += ca.dot(X, eta) + ca.dot(Y, eta) + ca.dot(eta, G @ eta)
            L[a, b] = ca.dot(X, etadot) + ca.dot(eta, G @ etadot)
    inertia = ca.trace(second) * ca.SX.eye(3) - second
    moment = ca.vertcat(L[1, 2] - L[2, 1], L[2, 0] - L[0, 2], L[0, 1] - L[1, 0])
    elastic = sum(ca.dot(etadot, ca.sparsify(ca.DM(x.G[a, a])) @ etadot) for a in range(3))
    momentum = ca.cross(omega, x.first + ca.DM(x.S) @ eta) + ca.DM(x.S) @ etadot
    return (
        x.m / 2 * ca.dot(velocity, velocity)
        + ca.dot(velocity, momentum)
        + ca.dot(omega, inertia @ omega) / 2
        + ca.dot(omega, moment)
        + elastic / 2
    )


def energies(robot, q: ca.SX, v: ca.SX, recursive: bool) -> tuple[ca.SX, ca.SX]:
    """Kinetic and potential energy (J) of the arm; velocities by differentiating positions, or link by link."""
    gravity, T, U = ca.DM(list(robot.gravity)), ca.SX(0), ca.SX(0)
    here = Frame(ca.SX.eye(3), ca.SX.zeros(3), ca.SX.zeros(3), ca.SX.zeros(3))
    joint, mode = 0, sum(len(link.joint.axes) for link in robot.links)
    for link in robot.links:
        x = integrals(link)
        for axis in link.joint.axes:
            here, joint = here.turned(axis, q[joint], v[joint]), joint + 1
        if not recursive:
            here.omega = angular_velocity(here.R, q, v)
            here.velocity = here.R.T @ rate(here.position, q, v)
        eta, etadot = q[mode : mode + len(x.K)], v[mode : mode + len(x.K)]
        mode += len(x.K)
        T += kinetic(x, eta, etadot, here.omega, here.velocity)
        T += (link.section.rhoIp or 0.0) * link.length / 2 * here.omega[0] ** 2
        U += ca.dot(ca.DM(x.K), eta**2) / 2
        U -= ca.dot(gravity, x.m * here.position + here.R @ (x.first + ca.DM(x.S) @ eta))
        here = tip(here, link.length, x, eta, etadot, q, v)
    return T, U


def tip(at: Frame, length: float, x: Integrals, eta: ca.SX, etadot: ca.SX, q: ca.SX, v: ca.SX) -> Frame:
    """The frame of the tip section."""
    place = ca.DM([length, 0, 0]) + ca.DM(x.tip) @ eta
    E = section_rotation(ca.DM(x.slope) @ eta)
    velocity = at.velocity + ca.cross(at.omega, place) + ca.DM(x.tip) @ etadot
    omega = E.T @ at.omega + angular_velocity(E, q, v)
    return Frame(at.R @ E, at.position + at.R @ place, omega, E.T @ velocity)


def forward_dynamics(robot, name: str, tuned: bool = False) -> ca.Function:
    """(q, v, tau) to vdot.

    Velocities are derivatives of positions and rotations. ``tuned``: they run from link to link in body components,
    and CasADi removes common subexpressions of the result, which somebody does who has looked at the operation count.
    """
    joints = sum(len(link.joint.axes) for link in robot.links)
    n = joints + sum(link.modes.total for link in robot.links)
    q, v, tau = ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("tau", joints)
    T, U = energies(robot, q, v, recursive=tuned)
    momenta = ca.gradient(T, v)
    force = ca.vertcat(tau, ca.SX.zeros(n - joints)) - ca.jtimes(momenta, q, v) + ca.gradient(T - U, q)
    D, LT, order = ca.ldl(ca.jacobian(momenta, v))
    vdot = ca.ldl_solve(force, D, LT, order)
    return ca.Function(name, [q, v, tau], [ca.cse(vdot) if tuned else vdot])
