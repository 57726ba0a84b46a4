"""The columns of a robot: inertia, stiffness and damping of all coordinates that integrators give theirs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..elements.axis_element import PREFIX, OfElement
from ..topology.chain import Chain
from .axis_laws import of_robot
from .schedule import COLUMNS

LAWS = ("dry", "stop")
"""The parts whose columns are those of friction and stops."""


def columns(chain: Chain, links: Sequence[Mapping[str, Sequence]]) -> dict[str, list]:
    """The robot's columns ``M_eta``, ``K``, ``D`` from those of its links; zero for joints that are not sprung.

    Entries below the diagonal, if modes or rotors are coupled, follow the diagonal's. ``coulomb`` and ``speed`` are of
    the coordinates in ``chain.dry``, if there are any; those of stops and elements follow.
    """
    out = {name: [0.0] * chain.n_inertia for name in COLUMNS["eta"]}
    for one in of_robot(chain):
        out |= {name: [0.0] * len(one.coordinates) for name in one.law.constants}
    for i, link in enumerate(links):
        for part, span in chain.given(i).items():
            for name, own in zip(robot_columns(chain, part), link_columns(chain, part), strict=True):
                out[name][span] = link[own]
    return out


def link_columns(chain: Chain, part: str) -> tuple[str, ...]:
    """The columns of a part of every link."""
    return COLUMNS[part] if part in COLUMNS else _of_element(chain, part)


def robot_columns(chain: Chain, part: str) -> tuple[str, ...]:
    """The robot's columns that hold those of a part of every link."""
    return link_columns(chain, part if is_of_law(part) else "eta")


def is_of_law(part: str) -> bool:
    """Whether the columns of a part are those of forces that are not linear, see :mod:`.axis_laws`."""
    return part in LAWS or part.startswith(PREFIX)


def _of_element(chain: Chain, part: str) -> tuple[str, ...]:
    return next(OfElement(kind).constants for kind in chain.elements if f"{PREFIX}{kind.KIND}" == part)
