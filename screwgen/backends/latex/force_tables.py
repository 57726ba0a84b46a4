"""The tables of forces between frames, and of wrenches from outside."""

from __future__ import annotations

from ...interactions import Number
from ...spec.forces import Push, WorldPoint
from ...spec.parents import WORLD
from ...topology.chain import Chain
from .content import DocumentTable
from .tables import exact, plain_unit, vector

ACTING = (
    r"A force acts between two frames A and B, the tips of two links or one tip and a point $\mathbf{r}_w$ of the "
    "world. Its law and its numbers are those of its row."
)
PUSHED = (
    "A push is a wrench from outside at a marker, its moment about the point there first. It stands among the external "
    "wrenches, with components in axes of the world or of the marker's section."
)


def forces(chain: Chain) -> DocumentTable | None:
    """Which frames the forces join, by which laws."""
    rows = []
    for force, placed in zip(chain.robot.acting_forces, chain.forces, strict=True):
        ends = (_end(end, i) for end, i in zip(force.between, placed.ends, strict=True))
        law = ", ".join([force.law.KIND, *(name for name, on in placed.shape.chosen if on)])
        numbers = ", ".join(_number(force.law.table()[name], x) for name, x in force.law.numbers.items())
        rows.append((f"`{force.name}`", *ends, law, numbers))
    head = ("acting", "A", "B", "law", "numbers")
    return DocumentTable(head, (0.14, 0.23, 0.23, 0.12, 0.28), tuple(rows)) if rows else None


def _end(end: str | WorldPoint, segment: int | None) -> str:
    if isinstance(end, WorldPoint):
        return rf"`{WORLD}`, $\mathbf{{r}}_w =$ {vector(end)}"
    assert segment is not None
    return f"`{end}`, link {segment + 1}"


def _number(one: Number, value: float | tuple[float, ...]) -> str:
    shown = vector(value) if isinstance(value, tuple) else exact(value)
    return f"${one.symbol} =$ {shown} {plain_unit(one.unit)}".rstrip()


def pushes(chain: Chain) -> DocumentTable | None:
    """Where wrenches act from outside, and in which axes."""
    own = {segment.label: i for i, segment in enumerate(chain.segments) if segment.pushed}
    rows = tuple(_push(push, own[push.name]) for push in chain.robot.pushes)
    return (
        DocumentTable(("push", "wrench", "at", "components in axes of"), (0.2, 0.2, 0.3, 0.3), rows) if rows else None
    )


def _push(push: Push, i: int) -> tuple[str, ...]:
    axes = f"the {WORLD}" if push.axes == WORLD else "the marker's section"
    return f"`{push.name}`", rf"$\boldsymbol{{\mathcal{{W}}}}_{{ext,{i + 1}}}$", f"`{push.at}`", axes
