"""A link as a cloud of elements and bodies in CasADi SX: the kinematic field of the oracle; no package code."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

import casadi as ca
import numpy as np
from oracle_link import Link, hat
from oracle_shapes import DIRECTIONS


def turn(axis: np.ndarray, angle: ca.SX) -> ca.SX:
    """Rotation about a unit axis (Rodrigues)."""
    K = hat(axis)
    return ca.SX(np.eye(3)) + ca.sin(angle) * ca.SX(K) + (1 - ca.cos(angle)) * ca.SX(K @ K)


def rotation_vector_matrix(theta: ca.SX, terms: int = 18) -> ca.SX:
    """exp(hat(θ)) by its power series in θ·θ: smooth at 0 under AD; exact to rounding for |θ| < 4."""
    x = ca.dot(theta, theta)
    sine, cosine = ca.SX(1), ca.SX(1)  # sin|θ|/|θ| and 2(1 - cos|θ|)/|θ|², by Horner
    for j in reversed(range(terms)):
        sine = 1 - x * sine / ((2 * j + 2) * (2 * j + 3))
        cosine = 1 - x * cosine / ((2 * j + 3) * (2 * j + 4))
    K = ca.skew(theta)
    return ca.SX(np.eye(3)) + sine * K + cosine / 2 * (K @ K)


def rates(expressions: list[ca.SX], variables: ca.SX, direction: ca.SX) -> list[ca.SX]:
    """Directional derivatives of several matrices in one forward sweep."""
    flat = ca.vertcat(*[ca.vec(ca.densify(e)) for e in expressions])
    moves = variables.numel() > 0
    flat = ca.densify(ca.jtimes(flat, variables, direction)) if moves else ca.SX.zeros(flat.numel())
    parts = slices([e.numel() for e in expressions])
    return [ca.reshape(flat[part], *e.shape) for part, e in zip(parts, expressions, strict=True)]


def slices(sizes: list[int], first: int = 0) -> list[slice]:
    """Consecutive slices of the given sizes, the first one starting at `first`."""
    ends = np.cumsum([first, *sizes])
    return [slice(int(begin), int(end)) for begin, end in pairwise(ends)]


def gradient(scalar: ca.SX, variables: ca.SX) -> ca.SX:
    """∂scalar/∂variables as a column, also where there are no variables."""
    return ca.gradient(scalar, variables) if variables.numel() else ca.SX.zeros(0, 1)


def vee(R: ca.SX, R_rate: ca.SX) -> ca.SX:
    """Angular velocity in body components from a rotation matrix and its rate."""
    S = R.T @ R_rate
    return ca.vertcat(S[2, 1] - S[1, 2], S[0, 2] - S[2, 0], S[1, 0] - S[0, 1]) / 2


def cross_sum(points: ca.SX, vectors: ca.SX) -> ca.SX:
    """Σ_j points_j × vectors_j of two 3×N matrices."""
    (x, y, z), (u, v, w) = ca.vertsplit(points), ca.vertsplit(vectors)
    return ca.vertcat(ca.dot(y, w) - ca.dot(z, v), ca.dot(z, u) - ca.dot(x, w), ca.dot(x, v) - ca.dot(y, u))


def per_column(matrix: ca.SX, numbers: np.ndarray) -> ca.SX:
    """Scale column j of a 3×N matrix by numbers[j]."""
    return matrix * ca.repmat(ca.DM(numbers).T, matrix.shape[0], 1)


@dataclass
class Cloud:
    """One link as point masses, turning bodies and spinning sections.

    points, origin, joint_point, tip_point: 3×N or 3×1, inertial axes, m; R, tip_R: body to inertial axes;
    twist: angles of each section about the axes of the undeformed link, 3×N; rate: d/dt of the `MOVING` ones along a
    velocity.
    """

    masses: np.ndarray
    points: ca.SX
    R: ca.SX
    origin: ca.SX
    joint_point: ca.SX
    tip_R: ca.SX
    tip_point: ca.SX
    twist: ca.SX
    spin_inertia: np.ndarray  # (3, N): rhoIp, rhoIy, rhoIz times l weights, kg·m²
    base_inertia: np.ndarray  # (3, 3), in F_i axes
    tip_inertia: np.ndarray  # (3, 3), in tip-frame axes
    bare: ca.SX | None = None  # points of the undeformed link, 3×N; of a link of order 2
    second: ca.SX | None = None  # second-order displacement of the points, 3×N, inertial axes
    sections: ca.SX | None = None  # rotations of the sections, 3×3N, inertial axes; of a link of order "exact"
    rate: dict[str, ca.SX] = field(default_factory=dict)

    @property
    def moving(self) -> tuple[str, ...]:
        """What has a rate. Of products with the second order only those with the undeformed link are kept."""
        names = ("points", "R", "origin", "tip_R", "tip_point", "twist")
        names = names if self.sections is None else (*names, "sections")
        return names if self.second is None else (*names, "bare", "second")

    @property
    def omega(self) -> ca.SX:
        """Angular velocity of F_i, in F_i."""
        return vee(self.R, self.rate["R"])

    @property
    def tip_omega(self) -> ca.SX:
        """Angular velocity of the tip frame, in the tip frame."""
        return vee(self.tip_R, self.rate["tip_R"])

    @property
    def spin_rate(self) -> ca.SX:
        """ω + dθ/dt of every section, 3×N, in F_i."""
        return ca.repmat(self.omega, 1, self.twist.shape[1]) + self.rate["twist"]

    @property
    def spin(self) -> ca.SX:
        """Angular momentum of every section about its own centre, 3×N, in F_i."""
        return self.spin_rate * ca.DM(self.spin_inertia)

    @property
    def section_spin(self) -> tuple[ca.SX, ca.SX]:
        """Angular momentum and velocity of every section, 3×N, inertial axes; of a link of order "exact"."""
        momenta, rates = [], []
        count = self.sections.shape[1] // 3
        for k in range(count):
            R, R_rate = (x[:, 3 * k : 3 * k + 3] for x in (self.sections, self.rate["sections"]))
            nu = vee(R, R_rate)
            momenta.append(R @ (ca.DM(self.spin_inertia[:, k]) * nu))
            rates.append(R @ nu)
        return ca.horzcat(*momenta), ca.horzcat(*rates)

    @property
    def turning(self) -> tuple[ca.SX, ca.SX]:
        """Angular momentum of every section, 3×N, and its angular velocity relative to F_i, in the same axes."""
        if self.sections is None:
            return self.spin, self.rate["twist"]
        momenta, rates = self.section_spin
        return momenta, rates - ca.repmat(self.R @ self.omega, 1, rates.shape[1])

    def kinetic(self) -> ca.SX:
        velocity = self.rate["points"]
        points = ca.dot(per_column(velocity, self.masses), velocity)
        spins = ca.dot(*self.section_spin) if self.sections is not None else ca.dot(self.spin, self.spin_rate)
        base = ca.dot(self.omega, ca.DM(self.base_inertia) @ self.omega)
        tip = ca.dot(self.tip_omega, ca.DM(self.tip_inertia) @ self.tip_omega)
        if self.second is not None:
            points += 2 * ca.dot(per_column(self.rate["bare"], self.masses), self.rate["second"])
        return (points + spins + base + tip) / 2

    def first_moment(self) -> ca.SX:
        """Σ m r (3)."""
        return (self.points if self.second is None else self.points + self.second) @ ca.DM(self.masses)

    def linear_momentum(self) -> ca.SX:
        velocity = self.rate["points"]
        return (velocity if self.second is None else velocity + self.rate["second"]) @ ca.DM(self.masses)

    def angular_momentum(self) -> ca.SX:
        """About the inertial origin, inertial components."""
        orbital = cross_sum(self.points, per_column(self.rate["points"], self.masses))
        if self.second is not None:
            orbital += cross_sum(self.second, per_column(self.rate["bare"], self.masses))
            orbital += cross_sum(self.bare, per_column(self.rate["second"], self.masses))
        return orbital + self.intrinsic_momentum() + self.tip_momentum()

    def intrinsic_momentum(self) -> ca.SX:
        """Of base bodies about their centre of mass and of the sections' spin; inertial components."""
        own = ca.sum2(self.section_spin[0]) if self.sections is not None else self.R @ ca.sum2(self.spin)
        return self.R @ (ca.DM(self.base_inertia) @ self.omega) + own

    def tip_momentum(self) -> ca.SX:
        return self.tip_R @ (ca.DM(self.tip_inertia) @ self.tip_omega)

    def twist_vector(self) -> ca.SX:
        """[ω; v] of F_i, in F_i components (6)."""
        return ca.vertcat(self.omega, self.R.T @ self.rate["origin"])

    def tip_twist(self) -> ca.SX:
        """[ω; v] of the tip frame, in tip-frame components (6)."""
        return ca.vertcat(self.tip_omega, self.tip_R.T @ self.rate["tip_point"])


def modal_slices(link: Link, first: int) -> dict[str, slice]:
    """Where each direction's modal coordinates sit in q, the link's first one being q[first]."""
    return dict(zip(DIRECTIONS, slices([link.counts[d] for d in DIRECTIONS], first), strict=True))


def build_cloud(link, q, angles, where, parent_R, parent_point, section_rotation) -> Cloud:
    """Place one link's elements and bodies in the inertial frame, outboard of a tip frame."""
    eta = q[where[DIRECTIONS[0]].start : where[DIRECTIONS[-1]].stop]
    R = parent_R @ ca.DM(link.mount_R)
    joint_point = parent_point + parent_R @ ca.DM(link.mount_xyz)
    for axis, turns, travel, angle in zip(link.axes, link.turns, link.travel, angles, strict=True):
        joint_point += R @ ca.DM(axis * travel) * angle
        R = R @ turn(axis, angle) if turns else R
    origin = joint_point - R @ ca.DM([link.a, 0, 0])
    places, count = ca.DM(link.undeformed()), len(link.masses)
    exact, sections = hasattr(link, "points"), None
    if exact:
        rotations = link.rotations(eta)
        at = link.places(eta, np.append(link.nodes, 1.0), rotations)
        tip_point, tip_R = origin + R @ at[:, -1], R @ link.rotation_at(eta, 1.0, rotations)
        placed = [ca.repmat(origin, 1, count) + R @ at[:, :-1]]
        sections = ca.horzcat(*[R @ x for x in rotations])
        spin_inertia = link.section_inertia * link.length * link.section_weights
    else:
        tip_point = origin + R @ link.tip_place(eta)
        tip_R = R @ rotation_vector_matrix(link.tip_turn(eta)) @ ca.DM(link.tip_axes) if section_rotation else R
        placed = [ca.repmat(origin, 1, count) + R @ (places + link.shift(eta))]
        spin_inertia = link.spin_inertia
    placed += [joint_point + R @ ca.DM(body.com) for body in link.base]
    placed += [tip_point + tip_R @ ca.DM(body.com) for body in link.tip]
    bare, second = None, None if exact else link.second_shift(eta)
    if second is not None:
        fixed = ca.SX.zeros(3, len(link.base) + len(link.tip))
        bare = ca.horzcat(ca.repmat(origin, 1, count) + R @ places, fixed)
        second = ca.horzcat(R @ second, fixed)
    return Cloud(
        bare=bare,
        second=second,
        masses=np.array([*link.masses, *(b.mass for b in link.base + link.tip)]),
        points=ca.horzcat(*placed),
        R=R,
        origin=origin,
        joint_point=joint_point,
        tip_R=tip_R,
        tip_point=tip_point,
        twist=ca.SX.zeros(3, 0) if exact else link.twist(eta),
        spin_inertia=spin_inertia,
        sections=sections,
        base_inertia=sum((b.inertia for b in link.base), np.zeros((3, 3))),
        tip_inertia=sum((b.inertia for b in link.tip), np.zeros((3, 3))),
    )
