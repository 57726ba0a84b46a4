"""The oracle's sections between base and tip of a link, at which it carries others; no package code.

A section is where the link's displacement field puts it: the shapes are evaluated anew at its place s.
"""

from __future__ import annotations

import casadi as ca
import numpy as np
from oracle_cloud import Cloud, rotation_vector_matrix
from oracle_link import Link, quadratic
from oracle_second_order import second_order
from oracle_shapes import DIRECTIONS, clamped_free, polynomial, tabulate


def place_of(robot: dict, i: int, carrier: int) -> float:
    """The place s on its parent at which link i is carried, 1 at the tip."""
    at = robot["links"][i].get("at", "tip")
    return at["s"] if isinstance(at, dict) else named(robot["links"][carrier], at)


def named(link: dict, name: str) -> float:
    """The place of a link's marker."""
    return {"base": 0.0, "tip": 1.0, **{x["name"]: x["at"] for x in link.get("markers", [])}}[name]


def section(table: dict, link: Link, cloud: Cloud, eta: ca.SX, s: float, robot: dict) -> tuple[ca.SX, ca.SX]:
    """Rotation and place of a link's section at s in the inertial frame."""
    if s == 1.0:
        return cloud.tip_R, cloud.tip_point
    if hasattr(link, "points"):
        rotations = link.rotations(eta)
        place = link.places(eta, np.array([s]), rotations)
        return cloud.R @ link.rotation_at(eta, s, rotations), cloud.origin + cloud.R @ place
    basis = table.get("modes", {}).get("basis", "polynomial")
    place, turn, first = ca.SX([link.a + s * link.length, 0, 0]), ca.SX.zeros(3), 0
    for direction in DIRECTIONS:
        count = link.counts[direction]
        modes, first = eta[first : first + count], first + count
        if not count:
            continue
        value, slope = (ca.dot(ca.DM(x), modes) for x in shapes_at(direction, basis, count, s))
        match direction.split("_"):
            case ["axial"]:
                place[0] += value
            case ["torsion"]:
                turn[0] += value
            case ["shear", axis]:
                place["xyz".index(axis)] += value
            case ["bending", "y"]:
                place[1] += value
                turn[2] += slope / link.length
            case ["bending", "z"]:
                place[2] += value
                turn[1] -= slope / link.length
    if link.second is not None:
        second = second_order(basis, link.counts, link.length, np.array([0.0]), s)
        place, turn = place + quadratic(second.tip, eta), turn + quadratic(second.turn, eta)
    R = cloud.R @ rotation_vector_matrix(turn) if robot.get("section_rotation", True) else cloud.R
    return R, cloud.origin + cloud.R @ place


def shapes_at(direction: str, basis: str, count: int, s: float) -> tuple[np.ndarray, np.ndarray]:
    """The values and slopes of a direction's shapes at s, (count,) each."""
    bends = direction.startswith("bending")
    if not bends and basis == "clamped_free":
        wave = (2 * np.arange(1, count + 1) - 1) * np.pi / 2
        return np.sqrt(2) * np.sin(wave * s), np.sqrt(2) * wave * np.cos(wave * s)
    functions = clamped_free(count) if basis == "clamped_free" else polynomial(count, 2 if bends else 1)
    table = tabulate(functions, [max(s, 1e-40)])  # the second derivatives of the rod's have a power of -1 at the base
    return table[0, :, 0], table[1, :, 0]
