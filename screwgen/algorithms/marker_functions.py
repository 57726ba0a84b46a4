"""The functions that measure at the markers of a robot, its gauges among them; results in the axes of each marker."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Self

import numpy as np

from ..ir.program import Value
from ..topology.chain import Chain
from . import gauges, given_motion
from . import motions as mo
from .schedule import OUTWARD, Algorithm, Phase

PLACED: Algorithm = (Phase(mo.poses, OUTWARD, at_markers=True),)
MOVING: Algorithm = (Phase(mo.velocities, OUTWARD, at_markers=True),)
GIVEN_MOTION: Algorithm = (Phase(given_motion.motion, OUTWARD),)
ACCELERATING: Algorithm = (replace(GIVEN_MOTION[0], at_markers=True),)
STRAINED: Algorithm = (Phase(gauges.strain, OUTWARD, at_markers=True),)
MEASURED = (PLACED, MOVING, ACCELERATING, STRAINED)
"""The algorithms that measure at markers."""


class MarkerFunctions:
    """What :class:`.functions.Functions` has besides for markers; the attributes are set there.

    Markers are in the order of ``chain.markers``; what they measure stands one after the other.
    """

    chain: Chain
    alone: Callable[[], Self]
    _run: Callable[..., tuple[list, list]]
    motion: Callable[..., list[dict[str, list]]]
    _state: Callable[..., list[dict[str, list]]]

    def marker_poses(self, q: Sequence) -> tuple[list, list]:
        """Rotation (9, row by row) and position (3) of every marker in the inertial frame."""
        found = self._at_markers(PLACED, self.chain.split(q, "q", "eta"))
        return [x for node in found for x in node["R"]], [x for node in found for x in node["r"]]

    def marker_velocities(self, q: Sequence, v: Sequence) -> list:
        """The twist (6) of every marker."""
        found = self._at_markers(MOVING, self.motion(q, v))
        return [x for node in found for x in (*node["omega_T"], *node["v_T"])]

    def marker_jacobians(self, q: Sequence) -> list:
        """The Jacobian (6, nv) of every marker, row by row: its twist per unit of each entry of v."""
        units = np.eye(self.chain.nv).tolist()
        return [x for row in zip(*(self.marker_velocities(q, unit) for unit in units), strict=True) for x in row]

    def marker_accelerations(self, q: Sequence, v: Sequence, vdot: Sequence) -> list:
        """Angular acceleration, and acceleration of the point against free fall, of every marker (6)."""
        found = self._at_markers(ACCELERATING, self.motion(q, v), self.chain.split(vdot, "qddot", "etaddot"))
        return [x for node in found for x in node["acc"]]

    def tip_acceleration(self, q: Sequence, v: Sequence, vdot: Sequence) -> list:
        """The same of the last tip alone: acceleration against free fall (3), in tip-frame components."""
        motion = self.chain.split(vdot, "qddot", "etaddot")
        _, places = self._run(GIVEN_MOTION, self._state(q, v), motion)
        return places[self.chain.tree.tip(self.chain.last)]["acc"][3:]

    def marker_biases(self, q: Sequence, v: Sequence) -> list:
        """The accelerations (6) that the markers have while no coordinate accelerates, gravity left out."""
        return self.alone().marker_accelerations(q, v, [0.0] * self.chain.nv)

    def strains(self, q: Sequence) -> list[Value]:
        """The strains of ``gauges.strain_names``: at the bases of all links, then at the markers that links declare."""
        links, places = self._run(STRAINED, self.chain.split(q, "q", "eta"))
        at_bases = [x for i in self.chain.firsts for x in links[i]["strain"]]
        nodes = [places[self.chain.node(marker)] for marker in self.chain.markers if not marker.is_tip]
        return at_bases + [x for node in nodes for x in node["strain"]]

    def _at_markers(self, algorithm: Algorithm, *parts: Sequence[Mapping[str, list]]) -> list[dict[str, list]]:
        """The nodes of the markers after an algorithm."""
        _, places = self._run(algorithm, *parts)
        return [places[self.chain.node(marker)] for marker in self.chain.markers]
