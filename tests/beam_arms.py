"""Arms for the finite beam elements, as plain dicts in the robot file's format; no package code."""

from __future__ import annotations

import copy

import numpy as np
import random_robots as rr

MATERIALS = {"aluminium": (7.0e10, 2700.0), "steel": (2.1e11, 7850.0)}
"""Young's modulus (Pa) and density (kg/m^3)."""


def random_arm(count: int, seed: int | None = None) -> tuple[dict, list[float]]:
    """An arm of `count` links in space and a posture of its joints; the seed is the count where none is given.

    Links are box sections with offset and turned mounts, skew axes, and bodies off the centreline at base and tip;
    those at the tips, motors and payload, are heavier than most links. All directions are flexible.
    """
    rng = np.random.default_rng(count if seed is None else seed)
    arm = {"name": f"arm_{count}", "gravity": [0.0, 0.0, -9.81], "links": [_link(rng, i) for i in range(count)]}
    return with_modes(arm, 2, 1), rr.numbers(rng.uniform(-2, 2, rr.joint_count(arm)))


def welded_corner() -> dict:
    """Two equal links welded at a right angle, without bodies; each has the section of ELLA's and torsion."""
    section = {"rhoA": 1.6302, "EA": 4.38e7, "EIy": 2.12e3, "EIz": 3.67e3, "GJ": 1.65e3, "rhoIp": 2.15e-4}
    links = [
        {"name": name, "length": length, "section": section, "joint": {"axes": [], "mount": {"rpy": [0.0, 0.0, turn]}}}
        for name, length, turn in (("first", 0.8, 0.0), ("second", 0.6, np.pi / 2))
    ]
    return with_modes({"name": "corner", "gravity": [0.0, 0.0, 0.0], "links": links}, 2, 1)


def with_modes(arm: dict, bending: int, other: int, basis: str = "polynomial") -> dict:
    """A copy whose links have these counts: `bending` per plane, `other` in stretching and in torsion."""
    out = copy.deepcopy(arm)
    for link in out["links"]:
        link["modes"] = {"basis": basis, "axial": other, "bending_y": bending, "bending_z": bending, "torsion": other}
    return out


def box_section(rng) -> dict:
    """Line properties of a thin box of aluminium or steel, 20 to 50 mm wide; torsion by Bredt's formula."""
    E, density = MATERIALS[str(rng.choice(sorted(MATERIALS)))]
    width, height = rng.uniform(0.02, 0.05, 2)
    wall = rng.uniform(0.06, 0.12) * min(width, height)
    inner = width - 2 * wall, height - 2 * wall
    area = width * height - inner[0] * inner[1]
    Iy, Iz = (width * height**3 - inner[0] * inner[1] ** 3) / 12, (height * width**3 - inner[1] * inner[0] ** 3) / 12
    J = 2 * wall * ((width - wall) * (height - wall)) ** 2 / (width + height - 2 * wall)
    section = {"rhoA": density * area, "EA": E * area, "EIy": E * Iy, "EIz": E * Iz, "GJ": E / 2.6 * J}
    return {key: float(x) for key, x in (section | {"rhoIp": density * (Iy + Iz)}).items()}


def _link(rng, index: int) -> dict:
    mount = {"xyz": rr.numbers(rng.uniform(-0.1, 0.1, 3)), "rpy": rr.numbers(rng.uniform(-np.pi, np.pi, 3))}
    return {
        "name": f"link_{index}",
        "length": float(rng.uniform(0.3, 0.8)),
        "section": box_section(rng),
        "joint": {"axes": rr.random_axes(rng, int(rng.integers(1, 3))), "mount": mount},
        "bodies": [_body(rng, "base", 0.5, 2.0), _body(rng, "tip", 3.0, 8.0)],
    }


def _body(rng, at: str, low: float, high: float) -> dict:
    mass = float(rng.uniform(low, high))
    com = rr.numbers(rng.uniform(-0.08, 0.08, 3))
    return {"at": at, "mass": mass, "com": com, "inertia": rr.cloud_inertia(rng, mass, 0.12)}
