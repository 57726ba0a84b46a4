"""Which posture of a robot is drawn, and from where it is looked at: the pair that shows most."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .sketch_pose import Part, Pose, View

AZIMUTHS = (-55.0, -35.0, 35.0, 55.0, -15.0, 15.0, -75.0, 75.0)
ELEVATIONS = (25.0, 12.0)
"""Degrees: directions from which a reader may look."""
SAMPLES = (0, 4, 8, 12, 16)
"""Places along a link at which distances are taken."""
APART = 0.14
"""The distance of links and joints, over the size of the picture, beyond which more is no better."""
NEUTRAL = 0.5
"""What counts for the posture with all joints at zero."""
TALL = 0.3
"""What counts against a picture for every width that it is higher than one."""
ARROW, ARC = 0.5, 0.25
"""The parts of a unit of an axis, across the view and along it, with which its arrow and the arc about it show well."""
NEAR = 1e-6


def chosen(poses: Sequence[Pose], gravity: Sequence[float]) -> tuple[Pose, View]:
    """The posture and the view in which links and joints are well apart; equal ones: the first."""
    pairs = [(pose, view) for pose in poses for view in views(gravity)]
    scores = [round(score(pose, view) + NEUTRAL * pose.neutral, 4) for pose, view in pairs]
    return pairs[int(np.argmax(scores))]


def views(gravity: Sequence[float]) -> list[View]:
    """Views with the direction against gravity upwards."""
    fall = np.array(gravity, float)
    axis = int(np.argmax(np.abs(fall))) if fall.any() else 2
    up = np.zeros(3)
    up[axis] = -np.sign(fall[axis]) or 1.0
    level = np.eye(3)[1 if axis == 0 else 0]
    return [_view(up, level, *np.radians([a, e])) for e in ELEVATIONS for a in AZIMUTHS]


def _view(up: np.ndarray, level: np.ndarray, azimuth: float, elevation: float) -> View:
    """A view at whose azimuth 0 a level axis, x or y, runs to the right."""
    ahead = np.cos(azimuth) * np.cross(level, up) + np.sin(azimuth) * level
    towards = np.cos(elevation) * ahead + np.sin(elevation) * up
    right = np.cross(up, towards)
    right = right / np.linalg.norm(right)
    return View(right, np.cross(towards, right), towards)


def score(pose: Pose, view: View) -> float:
    """How well a picture shows a robot: long links, links and joints apart, wide rather than tall."""
    points = np.array([view.flat(part.line[list(SAMPLES)]) for part in pose.parts])
    width, height = np.ptp(np.concatenate([points.reshape(-1, 2), [view.flat(p.mount) for p in pose.parts]]), axis=0)
    extent = max(float(np.hypot(width, height)), NEAR)
    tall = TALL * max(0.0, height / max(width, NEAR, 0.2 * height) - 1.0)
    return _shown(pose, view) + _apart(pose, points / extent) - tall


def _shown(pose: Pose, view: View) -> float:
    """The mean length of links over their true one, and how well the arrows of axes and of deflections show."""
    ways = [(part.straight[1] - part.straight[0]) / part.long for part in pose.parts if part.long > NEAR]
    long = [float(np.linalg.norm(view.flat(way))) for way in ways]
    axes = [
        (float(np.linalg.norm(view.flat(axis))), abs(float(axis @ view.towards))) for p in pose.parts for axis in p.axes
    ]
    shown = [min(arrow / ARROW, 1.0) + min(arc / ARC, 1.0) for arrow, arc in axes]
    bends = [min(float(np.linalg.norm(view.flat(way))) / ARROW, 1.0) for part in pose.parts for way in part.bends]
    return float(np.mean(long or [1.0])) + 0.4 * float(np.mean(shown or [2.0])) + 0.5 * min(bends, default=1.0)


def _apart(pose: Pose, points: np.ndarray) -> float:
    """How far links that are not neighbours, the far ends of neighbours, and joints are apart; 2 at most."""
    gaps = [APART]
    for i, part in enumerate(pose.parts):
        for j, other in enumerate(pose.parts[:i]):
            gaps.append(_gap(part, other, points[i], points[j]))
            gaps.append(_fold(part, other, points[i], points[j]))
    joints = [p[0] for p in points] + [p[-1] for p in points]
    places = [part.joint for part in pose.parts] + [part.tip for part in pose.parts]
    pairs = [APART]
    for i in range(len(places)):
        for j in range(i):
            if np.linalg.norm(places[i] - places[j]) > NEAR:
                pairs.append(float(np.linalg.norm(joints[i] - joints[j])))
    return min(1.0, min(gaps) / APART) + min(1.0, min(pairs) / APART)


def _fold(part: Part, other: Part, a: np.ndarray, b: np.ndarray) -> float:
    """The distance of the middle of a link from a link before it, and of that one's if it does not carry the first."""
    if not part.long or not other.long:
        return APART
    middle = len(SAMPLES) // 2
    own = float(np.min(np.linalg.norm(b - a[middle], axis=1)))
    carried = np.min(np.linalg.norm(other.line - part.carrier, axis=1)) < 0.1 * other.long
    return own if carried else min(own, float(np.min(np.linalg.norm(a - b[middle], axis=1))))


def _gap(part: Part, other: Part, a: np.ndarray, b: np.ndarray) -> float:
    """The distance of two links where they do not touch each other in space."""
    apart = np.linalg.norm(part.line[list(SAMPLES)][:, None] - other.line[list(SAMPLES)][None], axis=2)
    seen = np.linalg.norm(a[:, None] - b[None], axis=2)
    free = apart > 0.35 * max(part.long, other.long, NEAR)
    return float(np.min(seen[free])) if free.any() else APART
