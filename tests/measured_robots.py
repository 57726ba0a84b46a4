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
