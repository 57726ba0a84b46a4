"""Derivatives by parameters on NumPy arrays: one traced program, run on the units of all chosen parameters at once."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ...algorithms.parameter_slopes import Differentiable, along
from ...algorithms.robot_function import RobotFunction
from ...arguments import Loads, seconds
from ...integrators.method import Method
from ...integrators.methods import method_of
from ...integrators.traced import step

if TYPE_CHECKING:
    from .numeric import Numeric

Chosen = str | Sequence[str]
"""Names of parameters, or patterns as ``arm.*``."""


def of_function(numeric: Numeric, row: RobotFunction, *given: Loads, of: Chosen = "*", **more: Loads) -> Any:
    """The derivatives of the results of a function by the parameters ``of``, which number the last axis; a tuple where
    the results are several."""
    arguments = dict(zip(row.names, given, strict=False)) | more
    if len(given) > len(row.names) or not arguments.keys() <= set(row.names):
        raise TypeError(f"the arguments of {row.name} are ({', '.join(row.names)})")
    values = numeric.rows(**{name: arguments.get(name) for name in row.names})
    return _found(numeric, Differentiable.of(numeric.chain, row), dict(zip(row.names, values, strict=True)), of)


def slopes(
    numeric: Numeric, what: Differentiable, given: Mapping[str, Sequence[float]], places: Sequence[int]
) -> tuple[np.ndarray, ...]:
    """The derivatives of the results of ``what`` by the parameters at these places, which number the last axis."""
    return _slopes(numeric, what, given, tuple(places), None)


def of_step(
    numeric: Numeric,
    q: Loads,
    v: Loads,
    tau: Loads,
    w_ext: Loads,
    dt: float,
    of: Chosen = "*",
    method: str | Method = "modal_midpoint",
) -> tuple[np.ndarray, np.ndarray]:
    """The derivatives of coordinates (nq, k) and rates (nv, k) after a step by the parameters ``of``."""
    values = numeric.rows(q=q, v=v, tau=tau, w_ext=w_ext)
    given = dict(zip(("q", "v", "tau", "w_ext"), values, strict=True)) | {"dt": [seconds(dt, "dt")]}
    own = method_of(method)  # of which two may have one name
    return _found(numeric, step(numeric.chain, own), given, of, own)


def _found(
    numeric: Numeric,
    what: Differentiable,
    given: Mapping[str, Sequence[float]],
    of: Chosen,
    method: Method | None = None,
) -> Any:
    parts = _slopes(numeric, what, given, numeric.chain.parameters.chosen(of), method)
    return parts if len(parts) > 1 else parts[0]


def _slopes(
    numeric: Numeric,
    what: Differentiable,
    given: Mapping[str, Sequence[float]],
    chosen: tuple[int, ...],
    method: Method | None,
) -> tuple[np.ndarray, ...]:
    inputs = {**given, "p": numeric.p, "d_p": list(np.eye(len(chosen)))}
    outputs = numeric.whole((what.name, method, chosen), lambda: along(numeric.chain, what, chosen), inputs)
    parts = []
    for name, shape in what.results.items():
        rows = [np.broadcast_to(x, len(chosen)) for x in outputs[f"d_{name}"]]
        parts.append(np.array(rows, float).reshape(math.prod(shape), len(chosen)).reshape(*shape, len(chosen)))
    return tuple(parts)
