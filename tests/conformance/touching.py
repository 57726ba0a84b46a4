"""Contact and drag between two frames, in inertial axes: what acts at the points that touch, by its virtual work."""

from __future__ import annotations

from typing import NamedTuple

import casadi as ca


class Body(NamedTuple):
    """A frame as it moves: its rotation, its origin, and the velocities of both."""

    R: ca.SX
    at: ca.SX
    spin: ca.SX
    speed: ca.SX

    def moving(self, point: ca.SX) -> ca.SX:
        """The velocity of its material that is at a point."""
        return self.speed + ca.cross(self.spin, point - self.at)


class Touch(NamedTuple):
    """What the first frame feels at a point of both; the second feels the opposite."""

    point: ca.SX
    force: ca.SX
    energy: ca.SX = ca.SX(0)


def pressed(law: dict, first: Body, second: Body) -> Touch:
    """A sphere at the first origin that presses on a plane or a sphere of the second frame, and rubs along it."""
    if "normal" in law:
        n = second.R @ ca.DM(law["normal"])
        n, reach = n / ca.norm_2(n), ca.dot(n / ca.norm_2(n), first.at - second.at)
    else:
        n, reach = (first.at - second.at) / ca.norm_2(first.at - second.at), ca.norm_2(first.at - second.at)
    depth, w = law["radius"] + law.get("other", 0.0) - reach, law["width"]
    point = first.at - law["radius"] * n
    closing = second.moving(point) - first.moving(point)
    rate = ca.dot(n, closing)
    soft = ca.if_else(depth > w, depth, ca.if_else(depth > -w, (depth + w) ** 2 / (4 * w), 0))
    stored = ca.if_else(depth > w, depth**2 / 2 + w**2 / 6, ca.if_else(depth > -w, (depth + w) ** 3 / (12 * w), 0))
    press = law["stiffness"] * soft * ca.fmax(0, 1 + law.get("damping", 0.0) * rate)
    slip = closing - rate * n
    rubbing = law.get("friction", 0.0) * press * slip / ca.sqrt(ca.sumsqr(slip) + law.get("velocity", 1e-3) ** 2)
    return Touch(point, press * n + rubbing, law["stiffness"] * stored)


def dragged(law: dict, first: Body, second: Body) -> Touch:
    """What slows the first origin as it moves through a fluid that rests in the second frame."""
    u = first.R.T @ (first.speed - second.moving(first.at))
    quadratic = law.get("quadratic", 0.0) * ca.norm_2(u) if "quadratic" in law else 0.0
    return Touch(first.at, -first.R @ ((ca.DM(law.get("linear", [0.0] * 3)) + quadratic) * u))
