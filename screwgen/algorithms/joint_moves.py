"""How the coordinates of joints move that do not add up, as programs of their kinds."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np

from ..ir.program import Program, Tracer, Value
from ..joints.exponential import Series
from ..joints.kind import JointKind
from ..topology.chain import Chain
from .schedule import Apply


@cache
def integration(joint: JointKind) -> Program:
    """``(q, u) -> (moved)``: :meth:`.JointKind.integrate`."""
    return traced("integration", {"q": joint.nq, "u": joint.nv}, moved=joint.integrate)


@cache
def change_rate(joint: JointKind) -> Program:
    """``(u, v) -> (rate)``: :meth:`.JointKind.rate`."""
    return traced("change_rate", {"u": joint.nv, "v": joint.nv}, rate=lambda u, v, _: joint.rate(u, v))


@cache
def coordinate_rates(joint: JointKind) -> Program:
    """``(q, v) -> (rates)``: :meth:`.JointKind.coordinate_rates`."""
    sizes = {"q": joint.nq, "v": joint.nv}
    return traced("coordinate_rates", sizes, rates=lambda q, v, _: joint.coordinate_rates(q, v))


@cache
def midpoint_carry(joint: JointKind) -> Program:
    """``(u) -> (E)``, (nv, nv), row by row: ``(1 - carried(u))^-1``, where u is the change of half a step.

    By the implicit midpoint rule a change of the coordinates becomes ``2 E - 1`` of it, as the axes of changes turn.
    """
    return traced(
        "midpoint_carry", {"u": joint.nv}, E=lambda u, _: list(_inverse(np.eye(joint.nv) - joint.carried(u)).flat)
    )


def _inverse(A: np.ndarray) -> np.ndarray:
    """The inverse of a matrix of symbols whose leading minors are positive, as those of 1 and a skew matrix are."""
    n = len(A)
    rows = np.hstack([A, np.eye(n)]).astype(object)
    for k in range(n):
        rows[k] = rows[k] * (1.0 / rows[k, k])
        for i in range(n):
            if i != k:
                rows[i] = rows[i] - rows[i, k] * rows[k]
    return rows[:, n:]


def traced(name: str, sizes: dict[str, int], **results: Callable[..., Any]) -> Program:
    """The program of functions of symbols and of the symbols' :class:`.Series`, by the names of their results."""
    tracer = Tracer()
    series = Series(lambda x: tracer.call("c4", x), lambda x: tracer.call("c5", x))
    given = [np.array([*tracer.input(x, size), None], dtype=object)[:-1] for x, size in sizes.items()]
    return tracer.program(name, sizes, {x: list(body(*given, series)) for x, body in results.items()})


def rates(chain: Chain, q: Sequence[Value], v: Sequence[Value], apply: Apply) -> list[Value]:
    """``dq/dt`` (nq,): the rates themselves, but for joints whose coordinates do not add up."""
    out = {k: v[j] for k, j in zip(chain.flat_q.tolist(), chain.flat_v.tolist(), strict=True)}
    for part in chain.curved:
        given = {"q": list(q[part.q]), "v": list(v[part.v])}
        found = apply(part.link, 0, coordinate_rates(part.joint), given)["rates"]
        out |= dict(zip(range(part.q.start, part.q.stop), found, strict=True))
    return [out[k] for k in range(chain.nq)]
