"""Robots whose sections vary along their links, as plain dicts in the robot file's format; no package code."""

from __future__ import annotations

SECTION = {"rhoA": 2.0, "EA": 1e4, "EIy": 300.0, "EIz": 500.0, "GJ": 40.0, "rhoIp": 1e-2}


def scaled(section: dict, mass: float, stiffness: float) -> dict:
    """A section with its densities and its stiffnesses times a factor each."""
    return {key: value * (mass if key.startswith("rho") else stiffness) for key, value in section.items()}


def tapered_arm(stiff: float = 1.0, springs: bool = True) -> dict:
    """A stepped boom with all directions and a tapered one on joints with springs, if wanted, then a uniform link."""
    thick, thin = scaled(SECTION, 1.0, stiff), scaled(SECTION, 0.4, 0.3 * stiff)
    boom = [{"at": 0.0, **thick}, {"at": 0.4, **thick}, {"at": 0.4, **thin}, {"at": 1.0, **thin}]
    cone = [{"at": 0.0, **thick}, {"at": 1.0, **thin}]
    body = {"at": "tip", "mass": 0.4, "com": [0.0, 0.05, 0.02], "inertia": [2e-3, 3e-3, 3e-3, 0.0, 0.0, 0.0]}
    sprung = {"axes": ["z", "y"]}
    if springs:
        sprung |= {"stiffness": [30.0, 50.0], "damping": [0.2, 0.3], "armature": [0.05, 0.05]}
    links = [
        {"name": "boom", "length": 0.8, "section": boom, "joint": sprung, "bodies": [body], "frame_at": 0.1,
         "modes": {"axial": 2, "bending_y": 3, "bending_z": 2, "torsion": 1}, "damping": {"ratio": 0.02}},
        {"name": "cone", "length": 0.6, "section": cone, "joint": {"axes": ["y"]}, "bodies": [body],
         "modes": {"basis": "clamped_free", "bending_y": 2, "bending_z": 1}},
        {"name": "rod", "length": 0.3, "section": thin, "joint": {"axes": ["z"]}, "bodies": [body],
         "modes": {"bending_y": 1}},
    ]  # fmt: skip
    return {"name": "arm", "gravity": [0.0, 0.0, -9.81], "links": links}
