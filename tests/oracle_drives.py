"""Drives of the judge: rotors, gears and friction of all axes, from the tables of the robot file."""

from __future__ import annotations

import casadi as ca
import numpy as np


class Drives:
    """Inertia, stiffness, damping and dry friction that drives add to the coordinates, and where torques act.

    `drives`: the table of each axis, in the order of q; rotors of elastic drives follow the joints in q. The elastic
    gear of a transmission stands among them by how far the rotor's travel is ahead of the length (or crank's angle).
    Attributes: rotors (the axes with one), driven (tau's coordinates), inertia (nv,), K and D (nv, nv).
    """

    def __init__(self, drives: list[dict], nv: int):
        self.rotors = [axis for axis, drive in enumerate(drives) if "stiffness" in drive]
        self.inertia, self.K, self.D = np.zeros(nv), np.zeros((nv, nv)), np.zeros((nv, nv))
        self.driven, self.dry = [], []
        self.cylinders = [(axis, drive) for axis, drive in enumerate(drives) if "transmission" in drive]
        for axis, drive in enumerate(drives):
            ratio, inertia = drive.get("ratio", 1.0), drive.get("rotor_inertia", 0.0)
            place = axis
            if "transmission" in drive:
                self.driven.append(axis)
                if axis in self.rotors:
                    place = self.gear(len(drives), axis)
                    self.K[place, place], self.D[place, place] = drive["stiffness"], drive.get("damping", 0.0)
                continue
            if axis in self.rotors:
                place = len(drives) + self.rotors.index(axis)
                twist = np.zeros(nv)
                twist[place], twist[axis] = 1 / ratio, -1.0
                self.K += drive["stiffness"] * np.outer(twist, twist)
                self.D += drive.get("damping", 0.0) * np.outer(twist, twist)
            self.inertia[place] += inertia if place != axis else ratio**2 * inertia
            friction = drive.get("friction", {})
            self.D[place, place] += friction.get("viscous", 0.0)
            self.dry.append((place, axis, drive))
            self.driven.append(place)

    def lengths(self, q):
        """The lengths of the cylinders, the distances of two eyes in the plane of the joint, and angles of cranks.

        Behind an elastic gear it is the rotor's travel, which is ahead of them.
        """
        ahead = [q[self.gear(len(self.driven), axis)] if axis in self.rotors else 0 for axis, _ in self.cylinders]
        return self._lengths(q) + ca.vertcat(type(q)(0, 1), *ahead)

    def gear(self, n_axes: int, axis: int) -> int:
        """The place in q of the rotor or gear of an axis."""
        return n_axes + self.rotors.index(axis)

    def _lengths(self, q):
        out = []
        for axis, drive in self.cylinders:
            given = drive["transmission"]
            if "four_bar" in given:
                out.append(crank_angle(given["four_bar"], q[axis], ca))
                continue
            angle = q[axis] + given["angle"]
            out.append(
                ca.norm_2(given["crank"] * ca.vertcat(ca.cos(angle), ca.sin(angle)) - ca.vertcat(given["base"], 0))
            )
        return ca.vertcat(type(q)(0, 1), *out)

    def kinetic(self, q, v):
        """The energy of the rotors that the cylinders turn."""
        return ca.dot(self._masses, ca.jtimes(self.lengths(q), q, v) ** 2) / 2

    def pushed(self, q, v, a):
        """(nv,): what the inertia of these rotors asks of the coordinates, by the accelerations of the lengths."""
        rate = ca.jtimes(self.lengths(q), q, v)
        change = ca.jtimes(rate, ca.vertcat(q, v), ca.vertcat(v, a))
        return ca.jtimes(self.lengths(q), q, self._masses * change, True)

    def applied(self, q, tau) -> np.ndarray:
        """(nv,): the generalised forces of torques (n_tau,) at the numbers q."""
        x, out = ca.SX.sym("x", len(q)), np.zeros(len(q))
        slopes = ca.Function("f", [x], [ca.jacobian(self.lengths(x), x)])(q).full()
        out[self.driven] = tau
        out[[axis for axis, _ in self.cylinders]] = 0.0
        for k, (axis, _) in enumerate(self.cylinders):
            out += slopes[k] * tau[axis]
        return out

    @property
    def _masses(self) -> ca.DM:
        return ca.DM([d.get("ratio", 1.0) ** 2 * d.get("rotor_inertia", 0.0) for _, d in self.cylinders])

    def friction(self, q, v):
        """(nv,): the force of dry friction, and of all friction of cylinders, at the rates."""
        lengths = self.lengths(q)
        rates, forces = ca.jtimes(lengths, q, v), []
        for k, (_, drive) in enumerate(self.cylinders):
            given, w = drive.get("friction", {}), rates[k]
            forces.append(given.get("viscous", 0.0) * w + dry_friction(given, w))
        out = ca.jtimes(lengths, q, ca.vertcat(ca.SX(0, 1), *forces), True)
        for place, axis, drive in self.dry:
            ratio = drive.get("ratio", 1.0)
            load = drive.get("stiffness", 0.0) / ratio * (q[place] / ratio - q[axis])
            out[place] += dry_friction(drive.get("friction", {}), v[place], load)
        return out


def dry_friction(given: dict, w, load=0.0):
    """The friction of a table of the robot file at the rate w, but for what is viscous; `load`: on the rotor."""
    size = given.get("coulomb", 0.0)
    if falling := given.get("stribeck"):
        size += (falling["static"] - size) * ca.exp(-((w / falling["velocity"]) ** 2))
    size += given.get("load", 0.0) * ca.fabs(load)
    smooth = lambda size, velocity: size * w / ca.sqrt(w**2 + velocity**2)  # noqa: E731
    bend = given.get("bend", {"friction": 0.0, "velocity": 1.0})
    return smooth(size, given.get("velocity", 1.0)) + smooth(bend["friction"], bend["velocity"])


def crank_angle(linkage: dict, q, ops):
    """The crank's angle by the rocker's, from the ground line, by the cosine rule of the triangle of both pins and its
    pivot; `ops`: the functions, of CasADi or mpmath. In a linkage that is open the crank's pin and the joint are on
    different sides of the line between pivot and rocker's pin."""
    g, c, k, r = (linkage[name] for name in ("ground", "crank", "coupler", "rocker"))
    x, y = r * ops.cos(q + linkage["angle"]) - g, r * ops.sin(q + linkage["angle"])
    side = 1 if np.sin(float(linkage["angle"])) > 0 else -1
    inner = ops.acos((c**2 + x**2 + y**2 - k**2) / (2 * c * ops.sqrt(x**2 + y**2)))
    return ops.atan2(y, x) + (-side if linkage["branch"] == "open" else side) * inner
