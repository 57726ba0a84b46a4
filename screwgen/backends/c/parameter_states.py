"""Parameters of the robot that the filter in C finds: they are states behind [q; v], see the template of this name."""

from __future__ import annotations

from ...algorithms.estimated_parameters import LEAST
from ...algorithms.measurement import NOTHING, Further, Measurement
from ...algorithms.measurement_slopes import by_chosen
from ...spec.parameters import parameters
from ...topology.chain import Chain
from .by_p import ParameterDerivatives, slopes
from .code import literal
from .parameters import place
from .written import once


def count(asked: ParameterDerivatives) -> int:
    """How many they are."""
    return len(asked.chosen) if asked.estimated else 0


def further(chain: Chain, asked: ParameterDerivatives, row: Measurement) -> Further:
    """What they add to the derivatives of a measurement."""
    return by_chosen(row, asked.chosen, once(slopes, chain, asked)) if asked.estimated else NOTHING


def content(chain: Chain, asked: ParameterDerivatives) -> list[dict[str, str]]:
    """Of each its name, its C expression in the parameters, and the least value that it has at first."""
    own, out = parameters(chain.robot), []
    for k in asked.chosen:
        at = place(own[k])
        least = f"{literal(LEAST)} * start_p.{at}" if chain.parameters.least[k] == 0 else "-$$_LARGEST"
        out.append({"name": own[k].name, "place": at, "least": least})
    return out
