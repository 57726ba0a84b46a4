"""Which posture of a robot is drawn, and from where it is looked at: the pair that shows most."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from .sketch_pose import SketchPose, SketchView

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
MEETING = 0.35
"""Links may meet within that part of the longer one around a point at which they touch."""
NEAR = 1e-6


def chosen(poses: Sequence[SketchPose], gravity: Sequence[float]) -> tuple[SketchPose, SketchView]:
    """The posture and the view in which links and joints are well apart; equal ones: the first."""
    pairs = [(pose, view, apart) for pose in poses for apart in [spread(pose)] for view in views(gravity)]
    scores = [round(score(*pair) + NEUTRAL * pair[0].neutral, 4) for pair in pairs]
    return pairs[int(np.argmax(scores))][:2]


def views(gravity: Sequence[float]) -> list[SketchView]:
    """Views with the direction against gravity upwards."""
    fall = np.array(gravity, float)
    axis = int(np.argmax(np.abs(fall))) if fall.any() else 2
    up = np.zeros(3)
    up[axis] = -np.sign(fall[axis]) or 1.0
    level = np.eye(3)[1 if axis == 0 else 0]
    return [_view(up, level, *np.radians([a, e])) for e in ELEVATIONS for a in AZIMUTHS]


def _view(up: np.ndarray, level: np.ndarray, azimuth: float, elevation: float) -> SketchView:
    """A view at whose azimuth 0 a level axis, x or y, runs to the right."""
    ahead = np.cos(azimuth) * np.cross(level, up) + np.sin(azimuth) * level
    towards = np.cos(elevation) * ahead + np.sin(elevation) * up
    right = np.cross(up, towards)
    right = right / np.linalg.norm(right)
    return SketchView(right, np.cross(towards, right), towards)


class Spread(NamedTuple):
    """Points of a robot in space, and the pairs of them that a picture must keep apart."""

    points: np.ndarray
    """(m, 3): along all links."""
    links: np.ndarray
    """(m, m): whether two points are of links that do not meet there."""
    joints: np.ndarray
    """(m, m): whether they are joints or tips at different places, or joints that slides can move apart."""


def spread(pose: SketchPose) -> Spread:
    """The pairs of a posture: points of two links that are apart in space, the middle of a link and another link."""
    points = np.concatenate([part.line[list(SAMPLES)] for part in pose.parts])
    count, middle = len(SAMPLES), len(SAMPLES) // 2
    owner, place = np.divmod(np.arange(len(points)), count)
    long = np.array([part.long for part in pose.parts])[owner]
    apart = np.linalg.norm(points[:, None] - points[None], axis=2)
    others = (owner[:, None] != owner[None]) & (np.minimum(long[:, None], long[None]) > 0)
    far = apart > MEETING * np.maximum(np.maximum(long[:, None], long[None]), NEAR)
    folded = (place == middle)[:, None] & ~_carrying(pose)[np.ix_(owner, owner)]
    ends = (place == 0) | (place == count - 1)
    slid = (place == 0) & np.array([part.slides for part in pose.parts])[owner]
    met = (slid[:, None] | slid[None]) & (place == 0)[:, None] & (place == 0)[None] & (owner[:, None] != owner[None])
    return Spread(points, others & (far | folded), ends[:, None] & ends[None] & (apart > NEAR) | met)


def _carrying(pose: SketchPose) -> np.ndarray:
    """(n, n): whether the first part carries the second."""
    near = lambda a, b: bool(np.min(np.linalg.norm(a.line - b.carrier, axis=1)) <= 0.1 * a.long)  # noqa: E731
    return np.array([[near(a, b) for b in pose.parts] for a in pose.parts])


def score(pose: SketchPose, view: SketchView, apart: Spread) -> float:
    """How well a picture shows a robot: long links, links and joints apart, wide rather than tall."""
    points = view.flat(apart.points)
    width, height = np.ptp(np.concatenate([points, [view.flat(part.mount) for part in pose.parts]]), axis=0)
    distances = np.linalg.norm(points[:, None] - points[None], axis=2) / max(float(np.hypot(width, height)), NEAR)
    gaps = [min(1.0, float(np.min(distances[pairs], initial=APART)) / APART) for pairs in (apart.links, apart.joints)]
    tall = TALL * max(0.0, height / max(width, NEAR, 0.2 * height) - 1.0)
    return _shown(pose, view) + sum(gaps) - tall


def _shown(pose: SketchPose, view: SketchView) -> float:
    """The mean and least length of links over the true one, and how well arrows of axes and deflections show."""
    ways = [(part.straight[1] - part.straight[0]) / part.long for part in pose.parts if part.long > NEAR]
    axes = [axis for part in pose.parts for axis in part.axes]
    long, arrows, bends = (_lengths(view, of) for of in (ways, axes, [x for part in pose.parts for x in part.bends]))
    arcs = np.abs(np.reshape(axes, (-1, 3)) @ view.towards)
    turns = np.minimum(arrows / ARROW, 1.0) + np.minimum(arcs / ARC, 1.0)
    links = 0.5 * (_mean(long, 1.0) + float(np.min(long, initial=1.0)))
    return links + 0.4 * _mean(turns, 2.0) + 0.5 * float(np.min(bends / ARROW, initial=1.0))


def _lengths(view: SketchView, ways: Sequence[np.ndarray]) -> np.ndarray:
    """The lengths of unit vectors as they are seen."""
    return np.asarray(np.linalg.norm(view.flat(np.reshape(ways, (-1, 3))), axis=1))


def _mean(values: np.ndarray, otherwise: float) -> float:
    return float(np.mean(values)) if len(values) else otherwise
