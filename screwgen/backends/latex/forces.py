"""What a document says of forces between frames (:mod:`screwgen.interactions`), and of wrenches from outside.

Their tables: :mod:`.force_tables`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ...interactions import POTENTIAL
from ...ir.block import Binding
from ...spec.forces import POINT, Force
from ...spec.parameters import Parameter
from ...spec.robot import Robot
from ...topology.chain import Chain
from ..templates import render
from .breaking import terms
from .content import Named
from .law_equations import ROOM, equations
from .law_equations import symbols as number_symbols
from .layout import fill, width

STATE, PARAMETER = Binding.STATE, Binding.PARAMETER
TURNED = " External wrenches of pushes in axes of the world have inertial components instead."
BORNE = " External wrenches hold those of forces between frames."
ENDS: tuple[Named, ...] = tuple(
    (f"{letter}_{{{place}{end}}}", f"{meaning} {end}", unit, size, frame, STATE)
    for end in "AB"
    for letter, place, meaning, unit, size, frame in (
        (r"\mathbf{R}", "o", "to inertial axes from those of tip", "-", "3 × 3", "-"),
        (r"\mathbf{r}", "o", "position of tip", "m", "3", "inertial"),
        (r"\boldsymbol{\omega}", "T,", "angular velocity of tip", "rad/s", "3", "tip"),
        (r"\mathbf{v}", "T,", "velocity of tip", "m/s", "3", "tip"),
    )
)
"""Of the two tips between which a force acts."""
SYMBOLS: tuple[Named, ...] = (
    (r"\mathbf{R}_{AB}", "takes components in axes of B to those of A", "-", "3 × 3", "-", STATE),
    (r"\mathbf{d}_{AB}", "point B from point A", "m", "3", "A", STATE),
    (r"\boldsymbol{\omega}_{AB}", "angular velocity of B relative to A", "rad/s", "3", "A", STATE),
    (r"\mathbf{v}_{AB}", "rate of $\\mathbf{d}_{AB}$ as seen from A", "m/s", "3", "A", STATE),
    (r"\boldsymbol{\tau}_{AB}", "moment of a force between frames on B, at its point", "N*m", "3", "A", STATE),
    (r"\mathbf{F}_{AB}", "the force itself, on B", "N", "3", "A", STATE),
    (POTENTIAL, "potential of a force between frames", "N*m", "1", "-", STATE),
    (r"\mathbf{r}_w", "point of the world at which a force ends", "m", "3", "inertial", PARAMETER),
)


class _Law(NamedTuple):
    """Equations that some forces share."""

    words: str
    names: str
    lines: str


# ------------------------------------------------------------------------------------------ in words


def acting(chain: Chain) -> bool:
    """Whether there are forces between frames, or wrenches from outside at markers."""
    return bool(chain.forces or chain.robot.pushes)


def marker_remark(chain: Chain, i: int) -> str:
    """What a marker among the links is there for."""
    segment = chain.segments[i]
    if segment.pushed:
        return f"marker of the push `{segment.label}`"
    joined = any(i in (junction.first, junction.second) for junction in chain.closing.junctions)
    forced = any(i in force.ends for force in chain.forces)
    return "marker " + " and ".join(["that a loop joins"] * joined + ["at which forces act"] * forced)


def markers(chain: Chain, count: int) -> str:
    """How many markers stand among the links."""
    what = "at which something acts" if acting(chain) else "that loops join"
    return f"{count} marker{'s' * (count > 1)} {what}"


# ------------------------------------------------------------------------------------------ symbols


def symbols(chain: Chain) -> Iterator[Named]:
    """The symbols of what acts on tips."""
    if not chain.forces:
        return
    yield from (*ENDS, *SYMBOLS)
    for kind in dict.fromkeys(force.shape.kind for force in chain.forces):
        for one in kind.table().values():
            yield one.symbol, one.meaning, _asterisks(one.unit), f"{len(one.entries) or 1}", "-", PARAMETER
    for shape in dict.fromkeys(force.shape for force in chain.forces):
        told = [(one.symbol, one.meaning, one.unit) for one in shape.inputs.values()]
        told += [(one.symbol, one.meaning, one.unit) for one in shape.states.values()]
        yield from ((symbol, meaning, _asterisks(unit), "1", "-", STATE) for symbol, meaning, unit in told)
    for shape in dict.fromkeys(force.shape for force in chain.forces):
        for own in equations(shape):
            if own.meaning:
                size = "3" if r"\mathbf" in own.symbol else "1"
                yield from ((symbol, own.meaning, own.unit, size, "-", STATE) for symbol in _split(own.symbol))


def _split(left: str) -> list[str]:
    """The symbols of a left side, which may stack several."""
    return left.strip("[]").split(r";\ ")


def _asterisks(unit: str) -> str:
    """A unit of a robot file in the spelling of signals."""
    return unit.replace("·", "*").replace("²", "^2").replace("³", "^3") if unit not in ("", "1") else "-"


def parameter_symbol(robot: Robot, p: Parameter) -> str:
    """The LaTeX of a number of a force."""
    if p.field == POINT:
        return f"r_{{w,{'xyz'[p.index[0]]}}}"
    force = next(force for force in robot.acting_forces if force.name == p.name.partition(".")[0])
    own = number_symbols(force.law.table()[p.field.rpartition(".")[2]])
    return own[p.index[0] if p.index else 0]


# ---------------------------------------------------------------------------------------- the lines


def lines(chain: Chain) -> str:
    """What acts on tips, for the section of the algorithm; empty where nothing does."""
    if not acting(chain):
        return ""
    laws = list(_laws(chain))
    return render(
        "latex/forces.tex.jinja",
        markers=any(segment.marker is not None for segment in chain.segments),
        turned=bool(chain.turned_wrenches),
        chosen=chain.chooses_forces,
        remembering=any(force.shape.states for force in chain.forces),
        laws=laws,
        world=any(None in force.ends for force in chain.forces),
        steps=any(r"\mathrm{H}" in law.lines for law in laws),
    )


def _laws(chain: Chain) -> Iterator[_Law]:
    """The laws, each with the forces that obey it."""
    alike: dict[tuple[str, str], list[Force]] = {}
    for force, placed in zip(chain.robot.acting_forces, chain.forces, strict=True):
        text = "\n".join(line for own in equations(placed.shape) for line in _line(own.symbol, own.formula))
        words = ", ".join([force.law.WORDS, *(name for name, on in placed.shape.chosen if on)])
        alike.setdefault((words, text), []).append(force)
    for (words, text), own in alike.items():
        yield _Law(words[:1].upper() + words[1:], ", ".join(f"`{force.name}`" for force in own), text)


def _line(left: str, right: str) -> Sequence[str]:
    """A numbered line of an equation, broken where it is long."""
    first, *more = fill(terms(right), ROOM - width(left))
    rows = [f"{left} &= {first}", *(rf" & \quad {line}" for line in more)]
    return [*rows[:-1], rows[-1] + r" & \qquad & \text{(A#)}"]
