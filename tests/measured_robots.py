"""Robots whose stiffness is stated by measured frequencies."""

from __future__ import annotations

import copy

import numpy as np
from helpers import arm, model_of
from oracle_link import STIFFNESS_OF, line_properties
from oracle_shapes import DIRECTIONS, shapes_of

from screwgen import natural_frequencies

BARE = {"rhoA": 1.2, "rhoIp": 3e-3}
FOUND = {"axial": [900.0, 2500.0], "bending_y": [20.0, 131.0, 340.0], "bending_z": [27.0], "torsion": [310.0]}


def counted(frequencies: dict, **more) -> dict:
    """A `modes` table whose stiffness is all measured."""
    counts = {d: len(f) for d, f in frequencies.items()}
    return {"basis": "clamped_free", **counts, "frequencies": frequencies, **more}


def rod(frequencies=FOUND, **more) -> dict:
    """A robot of one clamped link without bodies and without any stiffness in its section."""
    table = {"name": "rod", "length": 0.8, "section": BARE, "modes": counted(frequencies), "joint": {"axes": []}}
    return arm(table | more)


def two_links() -> dict:
    """The first link measured in every direction, the second in one; bodies, damping, skew axes."""
    first = {
        "name": "first", "length": 0.7, "section": BARE, "frame_at": 0.1, "damping": {"ratio": 0.02},
        "modes": counted({"axial": [60.0], "bending_y": [3.0, 22.0], "bending_z": [4.0], "torsion": [9.0, 31.0]}),
        "joint": {"axes": ["y", [0.1, 0.3, 1.0]]},
        "bodies": [{"at": "tip", "mass": 1.3, "com": [0.02, 0.0, -0.03], "inertia": [0.01, 0.02, 0.02, 0, 0, 0]}],
    }  # fmt: skip
    second = {
        "name": "second", "length": 0.5, "section": {"rhoA": 0.8, "EIy": 7.0, "rhoIp": 2e-3},
        "modes": {"basis": "clamped_free", "bending_y": 2, "bending_z": 2, "frequencies": {"bending_y": [5.0, 40.0]}},
        "damping": {"ratio": 0.1}, "joint": {"axes": ["z"]}, "bodies": [{"at": "tip", "mass": 0.4}],
    }  # fmt: skip
    return arm(first, second)


def clamped(table: dict) -> dict:
    """The natural frequencies (Hz) of a link's directions, by the oracle's quadrature of its own shapes."""
    line, modes = line_properties(table["section"]), table.get("modes", {})
    out = {}
    for d in DIRECTIONS:
        if modes.get(d, 0):
            shapes = shapes_of(d, "clamped_free", modes[d], 160)
            inertia = line["rhoIp" if d == "torsion" else "rhoA"]
            power = 4 if d.startswith("bending") else 2
            squares = line[STIFFNESS_OF[d]] / inertia * np.diag(shapes.stiffness) / table["length"] ** power
            out[d] = [float(f) for f in np.sqrt(squares) / (2 * np.pi)]
    return out


def by_frequencies(robot: dict, directions=DIRECTIONS) -> dict:
    """The same robot, its stiffness in these directions stated by frequencies."""
    robot = copy.deepcopy(robot)
    for table in robot["links"]:
        found = {d: f for d, f in clamped(table).items() if d in directions}
        line = line_properties(table["section"])
        dropped = {STIFFNESS_OF[d] for d in found}
        table["section"] = {name: x for name, x in line.items() if x and name not in dropped}
        if found:
            table["modes"]["frequencies"] = found
    return robot


def flat(frequencies: dict) -> np.ndarray:
    return np.sort([f for values in frequencies.values() for f in values])


def bare_frequencies(frequencies: dict) -> np.ndarray:
    return natural_frequencies(model_of(rod(frequencies)))
