"""Drives of the judge: rotors, gears and friction of all axes, from the tables of the robot file."""

from __future__ import annotations

import casadi as ca
import numpy as np


class Drives:
    """Inertia, stiffness, damping and dry friction that drives add to the coordinates, and where torques act.

    `drives`: the table of each axis, in the order of q; rotors of elastic drives follow the joints in q.
    Attributes: rotors (the axes with one), driven (tau's coordinates), inertia (nv,), K and D (nv, nv).
    """

    def __init__(self, drives: list[dict], nv: int):
        self.rotors = [axis for axis, drive in enumerate(drives) if "stiffness" in drive]
        self.inertia, self.K, self.D = np.zeros(nv), np.zeros((nv, nv)), np.zeros((nv, nv))
        self.driven, self.dry = [], []
        for axis, drive in enumerate(drives):
            ratio, inertia = drive.get("ratio", 1.0), drive.get("rotor_inertia", 0.0)
            place = axis
            if axis in self.rotors:
                place = len(drives) + self.rotors.index(axis)
                twist = np.zeros(nv)
                twist[place], twist[axis] = 1 / ratio, -1.0
                self.K += drive["stiffness"] * np.outer(twist, twist)
                self.D += drive.get("damping", 0.0) * np.outer(twist, twist)
            self.inertia[place] += inertia if place != axis else ratio**2 * inertia
            friction = drive.get("friction", {})
            self.D[place, place] += friction.get("viscous", 0.0)
            if "coulomb" in friction:
                self.dry.append((place, friction["coulomb"], friction["velocity"]))
            self.driven.append(place)

    def friction(self, v):
        """(nv,): the force of dry friction at the rates, symbols or numbers of CasADi."""
        out = type(v).zeros(v.shape[0])
        for place, dry, velocity in self.dry:
            out[place] += dry * v[place] / ca.sqrt(v[place] ** 2 + velocity**2)
        return out
