"""Couplings: two axes of a robot that move in a fixed ratio, as in gear trains and grippers (URDF's `mimic`)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from pydantic import Field, PlainValidator

from .loops import STABILISATION
from .part import Part
from .ranges import within
from .values import Path, quoted, refuse, shown

if TYPE_CHECKING:
    from .robot import Link

AXIS = re.compile(r"(\w+)\.(joint|slide)\[(\d+)\]")
"""An axis by the name of its coordinate."""


class Axis(NamedTuple):
    """An axis of a robot: the number of its link, and its own in that link's joint."""

    link: int
    number: int


def axis_name(value: Any) -> str:
    """The name of an axis' coordinate, as `finger.joint[0]`."""
    if not isinstance(value, str) or not AXIS.fullmatch(value):
        raise refuse(f'is {shown(value)}; it must name the coordinate of an axis, as "finger.joint[0]"')
    return value


def made_in_python(value: Any) -> Any:
    """A relation that was made in Python."""
    if value is None or not (callable(getattr(value, "position", None)) and hasattr(value, "words")):
        raise refuse(f"is {shown(value)}; it must be a Python object with position and words; a file cannot state one")
    hash(value)
    return value


class Coupling(Part):
    """Two axes whose coordinates are coupled: that of `axis` is `ratio` times that of `of`, plus `offset`.

    They may be anywhere in the tree. What couples them has no mass and does no work. Ratio and offset are structure,
    like the axes of joints: they are numbers in generated code, no run-time parameters. In Python a `relation` f, see
    :class:`screwgen.elements.Relation`, makes it `ratio` times f of the other's. `stabilisation` λ (1/s): a gap
    g that rounding or the integrator has opened closes by `g̈ + 2 λ ġ + λ² g = 0`.
    """

    axis: Annotated[str, PlainValidator(axis_name)] = Field(
        description="the axis that follows, by the name of its coordinate"
    )
    of: Annotated[str, PlainValidator(axis_name)] = Field(description="the axis that it follows")
    ratio: Annotated[float, PlainValidator(within("coupling ratio"))] = Field(
        1.0, description="the rate of the following axis over that of the other"
    )
    offset: Annotated[float, PlainValidator(within("coupling offset"))] = Field(
        0.0, description="the coordinate of the following axis where the other's is zero, rad, of a slide m"
    )
    relation: Annotated[Any, PlainValidator(made_in_python)] = Field(
        None, description="in Python: a function f, the following axis is at ratio f(of) + offset", exclude=True
    )
    stabilisation: Annotated[float, PlainValidator(within("stabilisation"))] = Field(
        STABILISATION, description="the rate at which an open gap closes, rad/s"
    )


def coupled_axis(links: Sequence[Link], name: str, at: Path = ()) -> Axis:
    """The axis with a name; refuses names of none."""
    found = AXIS.fullmatch(name)
    assert found
    owner, kind, number = found[1], found[2], int(found[3])
    names = [link.name for link in links]
    if owner not in names:
        raise refuse(f"is an axis of {quoted(owner)}, which is no link; choose {_known(links)}", at)
    screws = links[i := names.index(owner)].joint.screws
    if number >= len(screws):
        raise refuse(f"is {quoted(name)}, but that joint has {len(screws)} axes; choose {_known(links)}", at)
    if (kind == "joint") != screws[number].turn:
        does, other = ("turns", "joint") if screws[number].turn else ("slides", "slide")
        raise refuse(f"is {quoted(name)}, but that axis {does}; call it {quoted(f'{owner}.{other}[{number}]')}", at)
    return Axis(i, number)


def _known(links: Sequence[Link]) -> str:
    """Some names of axes, for a message."""
    of = lambda link: (f"{link.name}.{'joint' if s.turn else 'slide'}[{k}]" for k, s in enumerate(link.joint.screws))  # noqa: E731
    return " or ".join(quoted(name) for name in [name for link in links for name in of(link)][:6])


def refuse_couplings(links: Sequence[Link], couplings: Sequence[Coupling]) -> None:
    """Refuse couplings of what is no axis, of an axis with itself, of axes behind elastic gears or transmissions."""
    for k, coupling in enumerate(couplings):
        at: Path = ("couplings", k)
        if coupling.axis == coupling.of:
            raise refuse("couples an axis with itself; name two axes", (*at, "of"))
        for key in ("axis", "of"):
            link, number = coupled_axis(links, getattr(coupling, key), (*at, key))
            if between := links[link].joint.between(number):
                what = f"is driven through {between}, whose effort does not act on the axis"
                raise refuse(f"{what}; drive and couple another one", (*at, key))
