"""The strains of links at their bases and markers, and the strain gauges of estimators among them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ..bodies.markers import STRAIN_UNITS, strained, strains
from ..ir.program import Value
from ..spec.markers import BASE
from ..spec.parameters import parameters
from ..topology.chain import Chain
from . import matrices as mx
from .scope import Scope


def strain(s: Scope) -> None:
    """The strains of the centreline at the link's base, and at its tip and stations."""
    s.write("strain", _strains(s, BASE))
    for section in s.sections:
        section.write("tip.strain", _strains(s, section.key.section_at))


def _strains(s: Scope, place: float) -> list[Value]:
    """At a place along the link, one for each direction that has modes: ``weights . eta / l^order``."""
    eta, out = s.read("eta"), []
    for found in strains(s.key, place):
        total = mx.dot(found.weights, eta[found.modes])
        for _ in range(found.order):
            total = total / s.constant("length" if s.key.segments == 1 else "segment")
        out.append(total)
    return out


def base_strains(chain: Chain) -> int:
    """How many strains there are at bases; they are the first."""
    return sum(len(strained(chain.keys[i])) for i in chain.firsts)


def strain_names(chain: Chain) -> dict[str, str]:
    """The names and units of the strains: at the bases of all links, then at the markers that links declare."""
    bases = [(f"{chain.segments[i].owner}.base_strain", i) for i in chain.firsts]
    named = [(f"{m.name}.strain", m.segment) for m in chain.markers if not m.is_tip]
    return {f"{name}.{d}": STRAIN_UNITS[d] for name, i in bases + named for d in strained(chain.keys[i])}


@dataclass(frozen=True)
class Gauge:
    """A gauge at a section of a link that measures its bending in one direction.

    A fibre at the distance ``d`` from the centreline, on the side of positive y (z), has the strain
    ``-d sum_k curvatures[k] / l^2 eta[first + k]`` of bending in y (z), ``l`` the link's length.
    """

    link: int
    direction: str
    """``bending_y`` or ``bending_z``."""
    first: int
    """Index of the direction's first mode among all modal coordinates."""
    curvatures: tuple[float, ...]
    """Second derivatives of the mode shapes there with the abscissa over the link's length, dimensionless."""


def gauges(chain: Chain, places: Iterable[tuple[int, float]] | None = None) -> list[Gauge]:
    """One gauge per place and direction with bending modes, y before z.

    ``places``: segments of the chain and abscissas along them; without it the bases of all links.
    """
    return [
        Gauge(
            chain.segments[i].link,
            bending.direction,
            chain.eta_offset[i] + bending.modes[0],
            tuple(chain.segments[i].count ** bending.order * weight for weight in bending.weights),
        )
        for i, at in ([(i, BASE) for i in chain.firsts] if places is None else places)
        for bending in strains(chain.keys[i], at)
        if bending.direction.startswith("bending")
    ]


def curvatures(chain: Chain, p: Sequence[Value], found: Sequence[Gauge]) -> list[Value]:
    """The second derivative of every mode's shape where a gauge measures it, over the square of the link's length."""
    out: list[Value] = [0.0] * chain.n_modes
    names = [x.name for x in parameters(chain.robot)]
    for gauge in found:
        length = p[names.index(f"{chain.robot.links[gauge.link].name}.length")]
        for k, curvature in enumerate(gauge.curvatures, gauge.first):
            out[k] = curvature / (length * length)
    return out
