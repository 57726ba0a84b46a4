"""Robots with forces between frames, and what their lines are by geometry alone."""

from __future__ import annotations

import numpy as np
from helpers import Model, arm, link, model_of

SPRING = {"stiffness": 12.0, "rest": 0.5, "damping": 0.5}
ROPE = {"stiffness": 4.0, "rest": 1.0, "slack": True}
EYE = (0.1, 0.2, 2.0)


def sprung(rest: float = 1.0) -> dict:
    """Two links that bend, a spring from a place on the first to the tip of the second, and a rope to the world."""
    soft = {"section": {"EIy": 200.0, "EIz": 200.0}}
    upper = link("upper", 1.0, ("z", "y"), modes={"bending_y": 1, "bending_z": 1}, **soft)
    upper |= {"markers": [{"name": "eye", "at": 0.6}]}
    lower = link("lower", 0.8, ("y",), modes={"bending_z": 1}, bodies=[{"at": "tip", "mass": 0.2}], **soft)
    spring = {"name": "spring", "between": ["upper.eye", "lower.tip"], "line": SPRING}
    rope = {"name": "rope", "between": [{"world": list(EYE)}, "lower.tip"], "line": ROPE | {"rest": rest}}
    return arm(upper, lower, forces=[spring, rope]) | {"name": "sprung"}


def state(model: Model) -> tuple[np.ndarray, np.ndarray]:
    """Bent and in motion."""
    q, v = 0.01 * np.cos(np.arange(model.nq)), 0.4 * np.sin(1.0 + np.arange(model.nv))
    q[:3] = 0.3, -0.4, 0.8
    return q, v


def ends(model: Model, q: np.ndarray, v: np.ndarray) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Places and velocities of the ends, in the inertial frame, by the functions of markers."""
    (R, r), twist = model.numpy().marker_pose(q), model.numpy().marker_velocity(q, v)
    moving = dict(zip(model.marker_names, zip(r, np.einsum("kij,kj->ki", R, twist[:, 3:]), strict=True), strict=True))
    return moving | {"world": (np.array(EYE), np.zeros(3))}


def lines(model: Model, q: np.ndarray, v: np.ndarray, rest: float = 1.0) -> np.ndarray:
    """Length and pull of the spring, then of the rope."""
    at, out = ends(model, q, v), []
    for first, second, own in (("upper.eye", "lower.tip", SPRING), ("world", "lower.tip", ROPE | {"rest": rest})):
        way, rate = (b - a for a, b in zip(at[first], at[second], strict=True))
        length = float(np.linalg.norm(way))
        pull = own["stiffness"] * (length - own["rest"]) + own.get("damping", 0.0) * (way @ rate) / length
        slack = own.get("slack") and (length < own["rest"] or pull < 0)
        out += [length, 0.0 if slack else pull]
    return np.array(out)


def sprung_model(rest: float = 1.0) -> Model:
    return model_of(sprung(rest))


def touching() -> Model:
    """A tip that presses on a plane of the link before, and on a sphere of the world; the links bend."""
    robot = sprung() | {"name": "touching"}
    law = {"radius": 0.12, "stiffness": 300.0, "width": 0.01}
    wall = {"between": ["lower.tip", "upper.tip"], "contact": law | {"normal": [0.3, -1.0, 0.8]}}
    ball = {"between": ["lower.tip", {"world": [0.9, 0.3, 0.4]}], "contact": law | {"other": 0.3}}
    return model_of(robot | {"forces": [wall | {"name": "wall"}, ball | {"name": "ball"}]})
