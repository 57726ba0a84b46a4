"""The programs of relations between axes (:mod:`..elements.relation`): values, and the slopes of their rows."""

from __future__ import annotations

from functools import cache

from ..elements import Relation
from ..ir.derivative import columns
from ..ir.program import Program, Tracer, Value


def _derivatives(relation: Relation, tracer: Tracer, count: int) -> tuple[Value, list[Value]]:
    """The coordinate, and f with its first derivatives there."""
    (x,) = tracer.input("x", 1)
    found = [relation.position(tracer, x)]
    for _ in range(count):
        found.append(columns([found[-1]], [x])[0][0])
    return x, found


@cache
def curve(relation: Relation) -> Program:
    """``(x) -> (f, slope, bend)``: f, f' and f''."""
    tracer = Tracer()
    _, found = _derivatives(relation, tracer, 2)
    return tracer.program("curve", {"x": 1}, {name: [y] for name, y in zip(("f", "slope", "bend"), found, strict=True)})


@cache
def row_slopes(relation: Relation) -> Program:
    """``(x, w, acc, force, rate) -> (slope, by_x, by_w, bend)`` of the row ``g = y - f(x)``.

    ``w``, ``acc``: rate and acceleration of x; ``rate``: of the stabilisation. ``by_x``, ``by_w``: the derivatives of
    the row's acceleration with its stabilisation; ``bend``: of the force that the row's ``force`` exerts on x.
    """
    tracer, names = Tracer(), ("x", "w", "acc", "force", "rate")
    x, (f, slope, bend) = _derivatives(relation, tracer, 2)
    w, acc, force, c = (tracer.input(name, 1)[0] for name in names[1:])
    row = -(slope * acc + bend * w * w + 2.0 * c * (slope * w) + c * c * f)
    (by_x,), (by_w,) = columns([row], [x, w])
    ((turned,),) = columns([-(slope * force)], [x])
    outputs = {"slope": slope, "by_x": by_x, "by_w": by_w, "bend": turned}
    return tracer.program("row_slopes", dict.fromkeys(names, 1), {name: [value] for name, value in outputs.items()})
