"""Forces between frames in a sketch, as springs or lines between their ends, and wrenches from outside as arrows."""

from __future__ import annotations

import numpy as np

from ...topology.chain import Chain
from ...topology.forces import PlacedForce
from .sketch_pen import Pen
from .sketch_pose import MOST_LINKS, SketchPose

FARTHEST = 0.8
"""The longest line that leads to a point of the world, over the size of the robot on paper; longer ones have a gap."""
BROKEN, GAP = 0.8, 7.0
"""Where along a line that gap begins, and its size, px."""
NEAR = 3.0
"""px: ends that are no further apart are one place."""
STRAIGHT, COIL, MOST_COILS = 0.18, 5.0, 14
"""The straight part at each end of a spring, over its length; the length of a coil, px; and the most of them."""
HALF, GROUND = 4.0, 7.0
"""px: half the width of a spring, and half the line of a point of the world."""
PUSH, BEFORE = 30.0, 4.0
"""px: the arrow of a push, and its distance from the marker."""


def forces(pen: Pen, chain: Chain, pose: SketchPose) -> None:
    """The forces between what is drawn, with their names."""
    most = FARTHEST * float(np.max(np.ptp(pen.corners(), axis=0)))
    for force in chain.forces:
        if all(chain.segments[i].link < MOST_LINKS for i in force.tips):
            _force(pen, pose, chain, force, most)


def _force(pen: Pen, pose: SketchPose, chain: Chain, force: PlacedForce, most: float) -> None:
    point = next(one.point for one in chain.robot.acting_forces if one.name == force.name)
    a, b = (pen.flat(np.array(point) if i is None else pose.ends[i]) for i in force.ends)
    if force.ends[0] is None:
        a, b = b, a
    if (far := float(np.linalg.norm(b - a))) > NEAR:
        b = a + min(far, np.inf if point is None else most) / far * (b - a)
        _joined(pen, force.shape.drawn, a, b, cut=point is not None and far > most)
        if point is not None:
            _ground(pen, b, (b - a) / np.linalg.norm(b - a))
    pen.wish("pull", f"`{force.name}`", (a + b) / 2, towards=(float(a[1] - b[1]), float(b[0] - a[0])))


def _joined(pen: Pen, drawn: str, a: np.ndarray, b: np.ndarray, cut: bool) -> None:
    """A spring or a line between two places, with a gap where it is longer than drawn."""
    end = a + BROKEN * (b - a) if cut else b
    if drawn == "spring":
        pen.drawn("drive", _spring(a, end))
    else:
        pen.drawn("pull", [a, end])
    if cut:
        pen.drawn("pull", [end + GAP / np.linalg.norm(b - a) * (b - a), b])
        pen.shortened = True


def _spring(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(n, 2): a zigzag from one point to another."""
    far = float(np.linalg.norm(b - a))
    along = (b - a) / far
    across = np.array([-along[1], along[0]])
    count = int(np.clip(round((1.0 - 2.0 * STRAIGHT) * far / COIL), 2, MOST_COILS))
    s = np.linspace(STRAIGHT, 1.0 - STRAIGHT, 2 * count + 1)
    side = np.zeros(len(s))
    side[1::2] = HALF * (-1.0) ** np.arange(count)
    coils = a + np.outer(s * far, along) + np.outer(side, across)
    return np.array([a, *coils, b])


def _ground(pen: Pen, place: np.ndarray, way: np.ndarray) -> None:
    """A point of the world: a line across the direction of what ends there, hatched behind."""
    across = GROUND * np.array([-way[1], way[0]])
    pen.drawn("ground", [place - across, place + across])
    for share in (-1.0, -0.4, 0.2, 0.8):
        first = place + share * across
        pen.drawn("ground", [first, first + 0.4 * across + 0.5 * GROUND * way])


def pushes(pen: Pen, chain: Chain, pose: SketchPose) -> None:
    """An arrow to each marker at which a wrench acts from outside, with its name; which way it acts a caller says."""
    for i, segment in enumerate(chain.segments):
        part = pose.part(chain.tree.parents[i])
        if segment.pushed and part is not None:
            x, y = pen.flat(part.tip - part.joint)
            side = np.array([-y, x]) if (x, 0.0) > (0.0, y) else np.array([y, -x])
            side = side / max(float(np.linalg.norm(side)), 1e-9)
            place = pen.flat(pose.ends[i])
            start = place + (BEFORE + PUSH) * side
            pen.drawn("force", [start, place + BEFORE * side], head=True)
            pen.wish("force", f"`{segment.label}`", start, towards=(float(side[0]), float(side[1])))
