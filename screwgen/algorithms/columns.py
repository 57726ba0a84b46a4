"""The columns of a robot: inertia, stiffness and damping of all coordinates that integrators give theirs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..topology.chain import Chain
from .schedule import COLUMNS

LAWS = ("dry", "stop")
"""The parts whose columns are those of forces that are not linear, see :mod:`.axis_laws`."""


def columns(chain: Chain, links: Sequence[Mapping[str, Sequence]]) -> dict[str, list]:
    """The robot's columns ``M_eta``, ``K``, ``D`` from those of its links; zero for joints that are not sprung.

    Entries below the diagonal, if modes or rotors are coupled, follow the diagonal's. ``coulomb`` and ``speed`` are of
    the coordinates in ``chain.dry``, if there are any, ``STOP`` of ``chain.stops``.
    """
    out = {name: [0.0] * chain.n_inertia for name in COLUMNS["eta"]}
    for part, places in (("dry", chain.dry), ("stop", chain.stops)):
        out |= {name: [0.0] * len(places) for name in COLUMNS[part] if places}
    for i, link in enumerate(links):
        for part, span in chain.given(i).items():
            for name, own in zip(robot_columns(part), COLUMNS[part], strict=True):
                out[name][span] = link[own]
    return out


def robot_columns(part: str) -> tuple[str, ...]:
    """The robot's columns that hold those of a part of every link."""
    return COLUMNS[part if part in LAWS else "eta"]
