"""Random modes and sections of a link, as plain dicts in the robot file's format; no package code."""

from __future__ import annotations

import numpy as np


def chance(rng, probability: float) -> bool:
    return bool(rng.random() < probability)


def log_uniform(rng, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def random_modes(rng, limits: dict) -> dict:
    """Counts per direction; {} is a rigid link. A count of 0 is sometimes stated, sometimes left out."""
    if chance(rng, limits["rigid"]):
        return {}
    most = limits["max_modes"] + (2 if chance(rng, 0.1) else 0)
    modes = {d: int(rng.integers(0, most + 1)) for d in ("axial", "bending_y", "bending_z")}
    modes["torsion"] = int(rng.integers(1, most + 1)) if most and chance(rng, limits["torsion"]) else 0
    modes = {d: n for d, n in modes.items() if n or chance(rng, 0.5)}
    basis = limits["basis"] or str(rng.choice(["clamped_free", "polynomial"]))
    return modes if basis == "polynomial" and chance(rng, 0.3) else {"basis": basis, **modes}


def random_section(rng, modes: dict, limits: dict) -> dict:
    """Either spelling; states the stiffness of every direction that has modes, others sometimes."""
    material = _material(rng, modes) if chance(rng, limits["material"]) else None
    if material is not None:
        return material
    stated = lambda direction: modes.get(direction, 0) or chance(rng, 0.4)  # noqa: E731
    section = {"rhoA": log_uniform(rng, 0.3, 3.0)}
    for direction, key, low, high in (
        ("axial", "EA", 1e4, 1e7),
        ("bending_z", "EIy", 20.0, 4e3),
        ("bending_y", "EIz", 20.0, 4e3),
        ("torsion", "GJ", 10.0, 1e3),
    ):
        if stated(direction):
            section[key] = log_uniform(rng, low, high)
    if modes.get("torsion", 0) or chance(rng, limits["rhoIp"]):
        section["rhoIp"] = log_uniform(rng, 2e-4, 1e-2)
    return section


def add_shear(rng, section: dict, modes: dict, limits: dict) -> None:
    """Shear modes with their stiffness, which may stand without them, and rotary inertia, which two of them need."""
    for axis, other in ("yz", "zy") if limits["shear"] else ():
        if modes and chance(rng, limits["shear"]):
            modes[f"shear_{axis}"] = int(rng.integers(1, limits["max_modes"] + 1))
        if f"shear_{axis}" in modes or chance(rng, 0.2):
            section[f"GA{axis}"] = log_uniform(rng, 1e3, 1e5)
        if modes.get(f"shear_{axis}", 0) > 1 or chance(rng, limits["shear"]):
            section[f"rhoI{other}"] = log_uniform(rng, 2e-4, 1e-2)


def varied(rng, section: dict):
    """Stations whose properties differ from those of `section` by factors, all in one spelling; some have steps."""
    places = [0.0, *sorted(rng.uniform(0.05, 0.95, int(rng.integers(0, 3)))), 1.0]
    if len(places) > 2 and chance(rng, 0.5):
        places.insert(1, places[1])
    factor = lambda: log_uniform(rng, 0.5, 2.0)  # noqa: E731
    stations = [{"at": float(s), **{key: value * factor() for key, value in section.items()}} for s in places]
    if len(set(places)) < len(places) or chance(rng, 0.6):
        return stations
    places = np.linspace(0.0, 1.0, len(stations))
    stations = [{**station, "at": float(s)} for station, s in zip(stations, places, strict=True)]
    near = [
        {key: v if key == "at" else float(section[key] * rng.uniform(0.8, 1.2)) for key, v in x.items()}
        for x in stations
    ]
    return {"stations": near, "between": "polynomial"}


def soften(section: dict) -> None:
    """Lower every stiffness: axially by 1e4, else by 1e2; a soft material by 1e3 in all."""
    factors = {"EA": 1e-4, "EIy": 1e-2, "EIz": 1e-2, "GJ": 1e-2, "GAy": 1e-2, "GAz": 1e-2, "E": 1e-3, "G": 1e-3}
    for key, factor in factors.items():
        if key in section:
            section[key] *= factor


def _material(rng, modes: dict) -> dict:
    """A tube or bar of some material; wide sections, so that rhoIp is not tiny."""
    density, area = float(rng.uniform(1200, 8000)), log_uniform(rng, 1e-4, 4e-4)
    radius = rng.uniform(0.01, 0.04, 2)  # radii of gyration, m
    section = {"density": density, "area": area, "E": log_uniform(rng, 1e9, 2e11)}
    section |= {"Iy": float(area * radius[0] ** 2), "Iz": float(area * radius[1] ** 2)}
    if modes.get("torsion", 0) or chance(rng, 0.3):
        section |= {"G": section["E"] / 2.6, "J": section["Iy"] + section["Iz"]}
    if chance(rng, 0.3):
        section["rhoIp"] = log_uniform(rng, 2e-4, 1e-2)
    return section
