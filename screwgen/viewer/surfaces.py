"""What touches: the spheres of contacts, and a part of each plane on which one presses."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ..model import Model
from .solids import turn_along

THICK = 0.02
"""The thickness of a plane's part, and the width of its border, over its width."""

Poses = tuple[np.ndarray, np.ndarray]
"""Rotations (n, 3, 3) and places (n, 3)."""


def surfaces(model: Model, values: Mapping[str, float], tips: Poses, size: float) -> Iterator[dict[str, Any]]:
    """Balls and boxes as bodies of links are, each fixed to the tip of a link, or where `link` is -1 to the world.

    `values`: the parameters by name; `tips`: the poses of the tips of all links at first; `size`: that of the robot, m,
    and of the part of a plane that is drawn, about the foot of the sphere at first. What is `clear` hides nothing.
    """
    for force, placed in zip(model.robot.acting_forces, model.chain.forces, strict=True):
        if placed.shape.drawn != "contact":
            continue
        point = [values[f"{force.name}.world[{k}]"] for k in range(3)] if force.point else [0.0] * 3
        own = [{"link": -1, "at": point} if i is None else {"link": i, "at": [0.0] * 3} for i in placed.ends]
        for end, name in zip(own, ("radius", "other"), strict=True):
            if values.get(f"{force.name}.{name}"):
                yield end | {"ball": values[f"{force.name}.{name}"]}
        if "normal" in placed.shape.stated:
            normal = np.array([values[f"{force.name}.normal[{k}]"] for k in range(3)])
            yield from _plane(own, normal / np.linalg.norm(normal), tips, size)


def _plane(ends: list[dict[str, Any]], normal: np.ndarray, tips: Poses, size: float) -> Iterator[dict[str, Any]]:
    """A part of the plane through the second end, as seen from there, and its border."""
    sphere, (turn, at) = _pose(ends[0], tips)[1], _pose(ends[1], tips)
    reach = turn.T @ (sphere - at)
    foot, axes = np.array(ends[1]["at"]) + reach - (reach @ normal) * normal, turn_along(normal)
    quaternion = Rotation.from_matrix(axes).as_quat().tolist()
    thick = THICK * size

    def box(middle: tuple[float, float], edges: tuple[float, float], **more: Any) -> dict[str, Any]:
        place = foot + axes @ [-thick / 2, *middle]
        return {"link": ends[1]["link"], "at": place.tolist(), "turn": quaternion, "box": [thick, *edges], **more}

    half = (size - thick) / 2
    yield box((0.0, 0.0), (size, size), clear=True)
    for sign in (-1.0, 1.0):
        yield box((sign * half, 0.0), (thick, size))
        yield box((0.0, sign * half), (size, thick))


def _pose(end: dict[str, Any], tips: Poses) -> tuple[np.ndarray, np.ndarray]:
    """Rotation and place of an end of a force at first."""
    i = end["link"]
    return (np.eye(3), np.array(end["at"])) if i < 0 else (tips[0][i], tips[1][i])
