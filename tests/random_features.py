"""Ball joints, springs, tendons and markers on a random robot, which the oracle takes as turns and potentials."""

from __future__ import annotations

import copy

import numpy as np
from random_sections import chance

BALL, SPRING, TENDON, MARKER = 0.12, 0.2, 0.2, 0.3
"""Chances: of a link that it hangs on a ball joint, of an axis, of a flexible link, of a link."""


def with_balls(rng, robot: dict, probability: float = BALL) -> dict:
    """The robot with some joints of three turns about any axis, but for that which a floating base has."""
    links = copy.deepcopy(robot["links"])
    for i, link in enumerate(links):
        if (i or "base" not in robot) and link["joint"]["axes"] and chance(rng, probability):
            mount = link["joint"].get("mount")
            link["joint"] = {"axes": "ball"} | ({"mount": mount} if mount else {})
    return robot | {"links": links}


def with_springs(rng, robot: dict) -> dict:
    """The robot with springs on some axes."""
    links = copy.deepcopy(robot["links"])
    for link in links:
        axes = link["joint"]["axes"]
        if axes != "ball" and any(springs := [chance(rng, SPRING) for _ in axes]):
            numbers = [{"stiffness": float(rng.uniform(1, 50)), "rest": float(rng.uniform(-1, 1))} for _ in axes]
            link["joint"]["elements"] = [{"spring": x} if k else {} for x, k in zip(numbers, springs, strict=True)]
    return robot | {"links": links}


def with_tendons(rng, robot: dict, probability: float = TENDON) -> dict:
    """The robot with a tendon along some of its flexible links, or two that pull against each other."""
    links = []
    for link in robot["links"]:
        bends = any(link.get("modes", {}).get(d) for d in ("bending_y", "bending_z"))
        if bends and "cloud" not in link and "segments" not in link and rng.random() < probability:
            y, z = rng.uniform(0.005, 0.02, 2).tolist()
            own = [{"name": f"cord_{link['name']}", "at": [[0.0, y, z], [0.0, y, 0.5 * z]]}]
            if rng.random() < 0.5:
                own.append({"name": f"against_{link['name']}", "at": [[0.0, -y, -z], [0.0, -y, -0.5 * z]]})
            link = link | {"tendons": own}
        links.append(link)
    return robot | {"links": links}


def with_markers(rng, robot: dict) -> dict:
    """The robot with a marker on some links, at the tip or along them."""
    links = []
    for link in robot["links"]:
        if "length" in link and "cloud" not in link and chance(rng, MARKER):
            link = link | {"markers": [{"name": "eye", "at": float(rng.choice([1.0, rng.uniform(0.1, 0.9)]))}]}
        links.append(link)
    return robot | {"links": links}


def dressed(seed: list[int], robot: dict) -> dict:
    """The robot with all of these, drawn from a stream of their own."""
    rng = np.random.default_rng([16, *seed])
    for add in (with_balls, with_springs, with_tendons, with_markers):
        robot = add(rng, robot)
    return robot
