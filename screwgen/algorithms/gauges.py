"""Strain gauges at the bases of links: their list, and the curvatures of the mode shapes there."""

from __future__ import annotations

from dataclasses import dataclass

from ..bodies.markers import strains
from ..topology.chain import Chain


@dataclass(frozen=True)
class Gauge:
    """A gauge at the base section of a link that measures its bending in one direction.

    A fibre at the distance ``d`` from the centreline, on the side of positive y (z), has the strain
    ``-d sum_k curvatures[k] / l^2 eta[first + k]`` of bending in y (z), ``l`` the link's length.
    """

    link: int
    direction: str
    """``bending_y`` or ``bending_z``."""
    first: int
    """Index of the direction's first mode among all modal coordinates."""
    curvatures: tuple[float, ...]
    """Second derivatives of the mode shapes at s = 0, dimensionless."""


def gauges(chain: Chain) -> list[Gauge]:
    """One gauge per link and direction with bending modes, link by link, y before z."""
    return [
        Gauge(
            chain.segments[i].link,
            bending.direction,
            chain.eta_offset[i] + bending.modes[0],
            tuple(chain.segments[i].count ** bending.order * weight for weight in bending.weights),
        )
        for i in chain.firsts
        for bending in strains(chain.keys[i], 0.0)
        if bending.direction.startswith("bending")
    ]
