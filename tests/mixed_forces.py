"""Forces between frames of random robots, and pushes: between any two markers, or a marker and the world."""

from __future__ import annotations

import numpy as np
from conformance.outer import Outer
from oracle import Oracle
from random_sections import log_uniform

FORCED = 0.6
"""Of the robots."""
SHORTEST = 0.05
"""m: the length of a line below which its direction turns too fast to be judged."""
TURNED = -0.3
"""The least cosine of the turn between the ends of a bushing."""


def with_forces(seed: list[int], robot: dict, judged: dict, q: np.ndarray) -> dict:
    """The robot, perhaps with one to three springs, ropes or bushings, and up to two pushes.

    They are drawn from a stream of their own. `judged`: the oracle's robot; its coordinates are `q`.
    """
    rng, oracle = np.random.default_rng(seed), Oracle(judged)
    if rng.random() > FORCED:
        return robot
    robot = robot | {"links": [dict(link) for link in robot["links"]]}
    forces, pushes = [], []
    for number in range(int(rng.integers(1, 4))):
        ends = [_marker(rng, robot, f"eye{number}{k}") for k in range(2)]
        if rng.random() < 0.3:
            ends[rng.integers(2)] = {"world": rng.uniform(-2.0, 2.0, 3).tolist()}
        length, cosine = _apart(Outer(robot, judged, oracle), ends, q)
        if length > SHORTEST:
            law = {"bushing": _bushing(rng)} if cosine > TURNED and rng.random() < 0.5 else {"line": _line(rng)}
            forces.append({"name": f"force{number}", "between": ends} | law)
    for number in range(int(rng.integers(0, 3))):
        push = {"name": f"push{number}", "at": _marker(rng, robot, f"hand{number}")}
        pushes.append(push | ({"axes": "marker"} if rng.random() < 0.4 else {}))
    return robot | ({"forces": forces} if forces else {}) | ({"pushes": pushes} if pushes else {})


def _line(rng) -> dict:
    line = {"stiffness": log_uniform(rng, 3.0, 300.0)}
    line |= {"rest": float(rng.uniform(0.1, 1.5))} if rng.random() < 0.7 else {}
    line |= {"damping": log_uniform(rng, 0.1, 10.0)} if rng.random() < 0.6 else {}
    return line | ({"slack": True} if rng.random() < 0.35 else {})


def _marker(rng, robot: dict, name: str) -> str:
    """A marker of a link, a new one unless it is the tip."""
    link = robot["links"][rng.integers(len(robot["links"]))]
    if "cloud" in link or rng.random() < 0.4:
        return f"{link['name']}.tip"
    s = round(float(rng.uniform(0.1, 0.9)), 3) if rng.random() < 0.8 else 0.5
    link["markers"] = [*link.get("markers", []), {"name": name, "at": s}]
    return f"{link['name']}.{name}"


def _bushing(rng) -> dict:
    bushing = {"stiffness": [log_uniform(rng, 3.0, 100.0) for _ in range(6)]}
    return bushing | ({"damping": [log_uniform(rng, 0.05, 3.0) for _ in range(6)]} if rng.random() < 0.6 else {})


def _apart(outer: Outer, ends: list, q: np.ndarray) -> tuple[float, float]:
    """How far the ends are from each other, and the cosine of the turn between them."""
    frames = []
    for end in ends:
        if isinstance(end, dict):
            frames.append((np.eye(3), np.array(end["world"])))
        else:
            place = outer.place(end)
            frames.append(outer.oracle.section_pose(place.link, q, place.s))
    (R_a, a), (R_b, b) = frames
    return float(np.linalg.norm(b - a)), float((np.trace(R_a.T @ R_b) - 1) / 2)
