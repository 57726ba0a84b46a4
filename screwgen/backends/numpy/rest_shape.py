"""Where the sections of links are at rest: along a straight line, or along a rod that is curved at rest."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...algorithms.rod_line import lengths, rod_line, rod_pose
from ...spec.link_class import LinkClass
from ...spec.reduced import end
from ...topology.chain import Chain
from .numeric import EPSILON, function_of


def line_at_rest(key: LinkClass, length: float, rest: Sequence[float], places: Sequence[float]) -> np.ndarray:
    """The centreline (places, 3) of a link, or of a segment, of that length from its base, in F_i components, m.

    `rest`: the numbers of its curvature at rest, 1/m.
    """
    if not key.rest:
        return np.outer(places, [length, 0.0, 0.0])
    return bent_line(key, length, rest, np.zeros(key.modes), places)


def bent_line(
    key: LinkClass, length: float, rest: Sequence[float], eta: np.ndarray, places: Sequence[float]
) -> np.ndarray:
    """The same of a rod of order EXACT at modal coordinates (r,)."""
    place, constants = function_of(rod_line(key, tuple(places))), lengths(key, length, rest)
    return np.reshape(place({"eta": eta.tolist(), **constants}, EPSILON)[0]["line"], (len(places), 3))


def section_at_rest(key: LinkClass, length: float, rest: Sequence[float], s: float) -> tuple[np.ndarray, np.ndarray]:
    """Rotation (3, 3) and place (3,) of a section of such a link from its base, in F_i components."""
    if not key.rest:
        return np.eye(3), np.array([s * length, 0.0, 0.0])
    pose, constants = function_of(rod_pose(key, s)), lengths(key, length, rest)
    found = pose({"eta": [0.0] * key.modes, **constants}, EPSILON)[0]
    return np.reshape(found["turn"], (3, 3)), np.array(found["line"])


def link_at_rest(chain: Chain, number: int, s: float) -> tuple[np.ndarray, np.ndarray]:
    """The same of a section of a whole link, through its segments, with the numbers of the robot file."""
    link, R, r = chain.robot.links[number], np.eye(3), np.zeros(3)
    if not link.rest:
        return R, s * end(link)
    first, length = chain.firsts[number], (link.length or 0.0) / link.pieces
    for k in range(link.pieces):
        share = float(np.clip(link.pieces * s - k, 0.0, 1.0))
        turn, place = section_at_rest(chain.keys[first + k], length, link.rest.numbers, share)
        R, r = R @ turn, r + R @ place
    return R, r
