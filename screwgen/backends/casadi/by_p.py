"""Derivatives by chosen parameters as CasADi functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

import casadi as ca

from ...algorithms.parameter_slopes import BY_P
from ...algorithms.robot_functions import offered
from ...topology.chain import Chain
from .functions import function


def by_parameters(
    chain: Chain, known: Mapping[str, ca.Function], chosen: Sequence[int]
) -> dict[str, Callable[[], ca.Function]]:
    """What makes ``<function>_by_p`` of every function of the robot and of every step, by name.

    Its results are matrices: a row for each entry of a result, column by column, and a column for each parameter.
    """
    names = [*(row.name for row in offered(chain)), *(name for name in known if name.split("_")[0] == "step")]
    return {name + BY_P: partial(_made, name, known, list(chosen)) for name in names}


def _made(name: str, known: Mapping[str, ca.Function], chosen: list[int]) -> ca.Function:
    whole = known[name]
    given = {x: ca.SX.sym(x, whole.sparsity_in(x)) for x in whole.name_in()}
    found = whole.call(given)
    slopes = {x + BY_P: ca.jacobian(ca.vec(ca.densify(found[x])), given["p"])[:, chosen] for x in whole.name_out()}
    return function(name + BY_P, given, **slopes)
