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


def with_forces(seed: list[int], robot: dict, judged: dict, q: np.ndarray) -> dict:
    """The robot, perhaps with one to three springs or ropes along lines, and up to two pushes.

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
        if _length(robot, judged, oracle, ends, q) > SHORTEST:
            forces.append({"name": f"force{number}", "between": ends, "line": _line(rng)})
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


def _length(robot: dict, judged: dict, oracle: Oracle, ends: list, q: np.ndarray) -> float:
    outer = Outer(robot, judged, oracle)
    points = [x["world"] if isinstance(x, dict) else oracle.section_pose(*_of(outer, q, x))[1] for x in ends]
    return float(np.linalg.norm(np.subtract(*points)))


def _of(outer: Outer, q: np.ndarray, marker: str) -> tuple:
    place = outer.place(marker)
    return place.link, q, place.s
