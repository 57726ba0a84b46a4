"""The centreline of an exact rod: a program that places points of it, for pictures and tables of deflections."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from ..ir.program import Program, Tracer
from ..spec.link_class import LinkClass
from . import matrices as mx
from .rod_sections import motion_along
from .scope import Scope, derived


@cache
def rod_line(key: LinkClass, places: tuple[float, ...]) -> Program:
    """``eta`` (r) to ``line`` (3 per place): positions of the centreline at s in [0, 1] from the rod's base, m, F_i.

    Its constants are those of :func:`lengths`.
    """
    scope = Scope(key, Tracer(), {})
    motion = motion_along(scope, {"eta": scope.read("eta")})
    line = [motion.sum_of(motion.points.reach(s).tolist(), "t")[0] if s else mx.zeros(3) for s in places]
    scope.outputs["line"] = [x for point in line for x in point]
    return scope.program("rod_line")


@cache
def rod_pose(key: LinkClass, s: float) -> Program:
    """The same at one place, with ``turn``, the rotation of the section there, row by row."""
    scope = Scope(key, Tracer(), {})
    motion = motion_along(scope, {"eta": scope.read("eta")})
    scope.outputs["line"] = [*motion.sum_of(motion.points.reach(s).tolist(), "t")[0]] if s else [0.0] * 3
    scope.outputs["turn"] = [*motion.end(s).R.ravel()]
    return scope.program("rod_pose")


def lengths(key: LinkClass, length: float, rest: Sequence[float] = ()) -> dict[str, list[float]]:
    """The constants of :func:`rod_line` for a link, or a segment, of that length in m.

    `rest`: the numbers of its curvature at rest, 1/m.
    """
    own = {"c.length" if key.segments == 1 else "c.segment": [length], "c.per_length": [1.0 / length]}
    names = derived(key)["link"].values["kappa_0"].flat if key.rest else ()
    return own | {f"c.{x.name}": [length * kappa] for x, kappa in zip(names, rest, strict=True)}
