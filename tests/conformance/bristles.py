"""Friction that remembers, beside the oracle: ``zdot = w - σ |w| z / g(w)`` and ``F = σ z + d zdot``, by the file.

Of Dahl's friction with a ductility b zdot is ``1 - b + b |1 - F/(g sign w)|`` times as much, and F = σ z.
"""

from __future__ import annotations

import numpy as np
from oracle_drives import Drives


class Bristles:
    """``places``: of the oracle's coordinates on which bristles act, behind an elastic gear the rotor's; ``tables``:
    what the robot file states of each."""

    def __init__(self, robot: dict, axes: dict[str, int], drives: Drives):
        self.places, self.tables = [], []
        for link in robot["links"]:
            for k, drive in enumerate(link["joint"].get("drives", [])):
                if {"memory", "dahl"} & set(drive.get("friction", {})):
                    names = [name for name in axes if name.split(".")[0].removesuffix("_0") == link["name"]]
                    axis = axes[names[k]]
                    self.places.append(drives.gear(len(axes), axis) if axis in drives.rotors else axis)
                    self.tables.append(drive["friction"])
        self.z = np.zeros(len(self.places))

    def rates(self, v: np.ndarray) -> np.ndarray:
        """The rates of the deflections z."""
        out = []
        for place, table, z in zip(self.places, self.tables, self.z, strict=True):
            w, size = v[place], table["coulomb"]
            if falling := table.get("stribeck"):
                size += (falling["static"] - size) * np.exp(-((w / falling["velocity"]) ** 2))
            stiffness, ductility = spring_of(table)["stiffness"], spring_of(table).get("ductility", 0.0)
            left = abs(1.0 - stiffness * z * np.sign(w) / size)
            out.append((1.0 - ductility + ductility * left) * (w - stiffness * abs(w) * z / size))
        return np.array(out)

    def forces(self, v: np.ndarray) -> np.ndarray:
        """(nv,): what they exert on the oracle's coordinates."""
        out = np.zeros(len(v))
        for place, table, z, rate in zip(self.places, self.tables, self.z, self.rates(v), strict=True):
            out[place] -= spring_of(table)["stiffness"] * z + spring_of(table).get("damping", 0.0) * rate
        return out

    @property
    def energy(self) -> float:
        """What is stored in them, J."""
        return sum(spring_of(table)["stiffness"] * z * z / 2 for table, z in zip(self.tables, self.z, strict=True))


def spring_of(friction: dict) -> dict:
    """What the file states of the bristles."""
    return friction["dahl" if "dahl" in friction else "memory"]
