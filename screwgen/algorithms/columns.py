"""The columns of a robot: inertia, stiffness and damping of all coordinates that integrators give theirs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..elements import Law
from ..topology.chain import Chain
from .axis_laws import of_robot
from .schedule import COLUMNS


def columns(chain: Chain, links: Sequence[Mapping[str, Sequence]]) -> dict[str, list]:
    """The robot's columns ``M_eta``, ``K``, ``D`` from those of its links; zero for joints without forces of axes.

    Entries below the diagonal, if modes or rotors are coupled, follow the diagonal's. Those of laws follow, an entry
    for each coordinate on which a law acts.
    """
    out = {name: [0.0] * chain.n_inertia for name in COLUMNS["eta"]}
    for one in of_robot(chain):
        out |= {name: [0.0] * len(one.coordinates) for name in one.law.constants}
    for i, link in enumerate(links):
        for part, span in chain.coordinate_spans(i).items():
            for name, own in zip(robot_columns(part), link_columns(part), strict=True):
                out[name][span] = link[own]
    return out


def width(span: slice) -> int:
    """The number of entries of a slice."""
    return span.stop - span.start


def link_columns(part: str | Law) -> tuple[str, ...]:
    """The columns of a part of every link."""
    return COLUMNS[part] if isinstance(part, str) else part.constants


def robot_columns(part: str | Law) -> tuple[str, ...]:
    """The robot's columns that hold those of a part of every link."""
    return link_columns("eta" if isinstance(part, str) else part)
