"""Strain gauges at the bases of links: their list, and the curvatures of the mode shapes there."""

from __future__ import annotations

from dataclasses import dataclass

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
    out = []
    for i, key in enumerate(chain.keys):
        for direction in ("bending_y", "bending_z"):
            places = [k for k, (d, _) in enumerate(key.directions) if d == direction]
            if places:
                curvatures = (row[0] for row in key.shapes(direction).evaluate([0.0], 2))
                out.append(Gauge(i, direction, chain.eta_offset[i] + places[0], tuple(curvatures)))
    return out
