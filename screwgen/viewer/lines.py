"""The lines of forces between frames: springs as coils, ropes that hang where they are slack."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any

import numpy as np

from ..model import Model
from .solids import DARK_METAL, METAL, THREAD, strut

PLACES = {"spring": 112, "rope": 25, "line": 2}
"""Points of a line, by how it is drawn."""
TURNS, LEAD, RAMP = 7, 0.12, 0.05
"""Turns of a coil, its straight part at either end over its length, and the part over which it widens there."""
HALVINGS = 40
"""Steps in which the sag of a rope is found."""
SIDES, AROUND = 4, 10
"""Faces around a wire, and around the ring at a point of the world."""


def lines(model: Model, values: Mapping[str, float], tips: np.ndarray, thin: float) -> Iterator[dict[str, Any]]:
    """The lines of all forces: their ends, each the tip of a link, or where that is -1 a point of the world, m.

    `values`: the parameters by name; `tips` (n, 3): those of all links at first, m; `thin`: the least radius of a tube.
    """
    for force, placed in zip(model.robot.acting_forces, model.chain.forces, strict=True):
        if placed.shape.drawn not in PLACES:
            continue
        point = [values[f"{force.name}.world[{k}]"] for k in range(3)] if force.point else []
        own = [{"link": -1, "at": point} if i is None else {"link": i} for i in placed.ends]
        first, second = (np.array(point) if i is None else tips[i] for i in placed.ends)
        rest = values.get(f"{force.name}.rest", 0.0)
        wide = min(2.6 * thin, 0.12 * (rest or float(np.linalg.norm(second - first)) or thin))
        yield {
            "ends": own,
            "drawn": placed.shape.drawn,
            "rest": rest,
            "wide": wide,
            "thick": min(0.3 * thin, 0.3 * wide),
        }


def path(line: dict[str, Any], near: np.ndarray, far: np.ndarray, down: np.ndarray, spare: float) -> np.ndarray:
    """The points (N, 3) of a line between its ends, as in templates/view/actuators.js.

    `down`: a unit vector to where things fall; `spare`: how much longer a rope is than its way, m.
    """
    s = np.linspace(0.0, 1.0, PLACES[line["drawn"]])[:, None]
    straight = near + s * (far - near)
    if line["drawn"] == "spring":
        wide = line["wide"] * _smooth((s - LEAD) / RAMP) * _smooth((1 - LEAD - s) / RAMP)
        angle = 2 * np.pi * TURNS * (s - LEAD) / (1 - 2 * LEAD)
        y, z = _across(far - near)
        return straight + wide * (np.cos(angle) * y + np.sin(angle) * z)
    if line["drawn"] == "rope":
        return straight + 4 * s * (1 - s) * _sag(spare, far - near, down) * down
    return straight


def faces(
    line: dict[str, Any], near: np.ndarray, far: np.ndarray, down: np.ndarray, spare: float
) -> tuple[np.ndarray, list[str]]:
    """The faces (F, 4, 3) of a line and of the rings at points of the world, and their colours; always as many."""
    wire = _swept(path(line, near, far, down, spare), line["thick"])
    out, colors = [wire], [METAL if line["drawn"] == "spring" else THREAD] * len(wire)
    for end, at, way in zip(line["ends"], (near, far), (far - near, near - far), strict=True):
        if end["link"] < 0:
            ring = _ring(at, way, line)
            out.append(ring)
            colors += [DARK_METAL] * len(ring)
    return np.concatenate(out), colors


def _smooth(x: np.ndarray) -> np.ndarray:
    x = np.clip(x, 0.0, 1.0)
    return np.asarray(x * x * (3 - 2 * x))


def _across(way: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Two unit vectors across a way and each other."""
    x = way / max(float(np.linalg.norm(way)), 1e-12)
    y = np.cross(np.eye(3)[2 if abs(x[2]) < 0.9 else 0], x)
    y /= max(float(np.linalg.norm(y)), 1e-12)
    return y, np.cross(x, y)


def ends(line: dict[str, Any], tips: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The ends of a line, of the tips (n, 3) of all links."""
    near, far = (np.array(x["at"]) if x["link"] < 0 else tips[x["link"]] for x in line["ends"])
    return near, far


def _sag(spare: float, way: np.ndarray, down: np.ndarray) -> float:
    """How far the middle of a rope hangs below the line between its ends; 0 where it is taut."""
    if spare <= 0:
        return 0.0
    s, length = np.linspace(0.0, 1.0, PLACES["rope"])[:, None], float(np.linalg.norm(way)) + spare
    low, high = 0.0, length
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        steps = np.diff(s * way + 4 * s * (1 - s) * middle * down, axis=0)
        low, high = (middle, high) if np.linalg.norm(steps, axis=1).sum() < length else (low, middle)
    return low


def _swept(points: np.ndarray, radius: float) -> np.ndarray:
    """The faces of a wire along points: a ring across it at each, turned as little as it can from one to the next."""
    along = np.gradient(points, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-12)
    angle = 2 * np.pi * np.arange(SIDES)[:, None] / SIDES
    y, rings = _across(along[0])[0], []
    for at, x in zip(points, along, strict=True):
        y = y - (y @ x) * x
        y /= max(float(np.linalg.norm(y)), 1e-12)
        rings.append(at + radius * (np.cos(angle) * y + np.sin(angle) * np.cross(x, y)))
    ring, after = np.array(rings), np.roll(rings, -1, axis=1)
    return np.stack([ring[:-1], after[:-1], after[1:], ring[1:]], axis=2).reshape(-1, 4, 3)


def _ring(at: np.ndarray, way: np.ndarray, line: dict[str, Any]) -> np.ndarray:
    """The eye at a point of the world, in a plane of the line."""
    x, (y, _) = way / max(float(np.linalg.norm(way)), 1e-12), _across(way)
    angle = 2 * np.pi * np.arange(AROUND + 1)[:, None] / AROUND
    corners = at + 5 * line["thick"] * (np.cos(angle) * x + np.sin(angle) * y)
    return np.concatenate([strut(a, b, 1.4 * line["thick"]) for a, b in pairwise(corners)])
