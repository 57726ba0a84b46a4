"""The entries of the mass matrix that have short formulas.

The Jacobian of the inertial forces in the accelerations is run on exact sums. What takes a long sum, or has no closed
form, is given up, and so is what is made of it, but for its product with zero: a large robot takes no longer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ...algorithms import fused
from ...algorithms.functions import INVERSE, Functions
from ...ir.derivative import columns
from ...ir.program import Program, Value
from ...ir.replay import BINARY, run
from ...topology.chain import Chain
from .forms import flat, written
from .functions import NoClosedFormError, function
from .make import BUDGET, ParameterSymbols
from .names import Name
from .ring import COORDINATE, ExactSum, Generator, Ring, TooLargeError
from .trees import FormulaSum
from .writing import LATEX, FormulaWriter

TERMS = 40
"""A sum of more terms is given up."""
OPERATIONS = 50
"""A formula of more operations is not short."""

Place = tuple[int, int]
Known = ExactSum | None
"""A sum, or None where it is given up."""


@dataclass(frozen=True)
class Coordinate:
    """A coordinate by its name, and whether it is an angle of a joint."""

    name: Name
    turns: bool


@dataclass(frozen=True)
class ShortEntries:
    """Formulas of entries by row and column, none below the diagonal; that of an entry that is always zero is empty.

    ``parameters``: the places of those that occur.
    """

    formulas: Mapping[Place, FormulaSum]
    latex: FormulaWriter
    parameters: Sequence[int]


def short_entries(chain: Chain, q: Sequence[Coordinate | None], p: Sequence[Name]) -> ShortEntries:
    """The entries that are short, with names for coordinates and parameters.

    An entry that needs a coordinate without a name, such as one of a quaternion, is none of them.
    """
    ring = Ring(BUDGET)
    known = [None if x is None else _generator(ring, x) for x in q]
    inputs = ParameterSymbols(ring, chain)
    program, places = _program(chain)
    given: dict[str, list[Known]] = {"p": [*inputs.p], "vdot": [None] * chain.nv}
    given["q"] = [None if x is None else ring.of(x) for x in known]
    formulas = {
        place: formula
        for place, entry in zip(places, _run(ring, program, given), strict=True)
        if entry is not None and not _has_parts(entry) and (formula := _formula(entry)).operations <= OPERATIONS
    }
    used = {n for formula in formulas.values() for atom in formula.atoms() for n, _ in atom.of}
    names = {x.number: own.name for x, own in zip(known, q, strict=True) if x is not None and own is not None}
    moving = frozenset(names)
    names |= {n: p[place] for n, place in inputs.of_generator.items()}
    names |= {root.number: Name(f"sqrt({prime})", rf"\sqrt{{{prime}}}") for prime, root in ring.roots.items()}
    names[ring.pi.number] = Name("pi", r"\pi")
    stated = sorted(inputs.of_generator[n] for n in used if n in inputs.of_generator)
    return ShortEntries(formulas, FormulaWriter(names, LATEX, moving), stated)


def _generator(ring: Ring, x: Coordinate) -> Generator:
    return (ring.turning if x.turns else ring.generator)(x.name.text, COORDINATE)


def _program(chain: Chain) -> tuple[Program, list[Place]]:
    """The entries from the diagonal upwards, column by column, from coordinates and parameters."""
    places = [(i, j) for j in range(chain.nv) for i in range(j + 1)]

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Mapping[str, Sequence[Value]]:
        rest, unloaded = [0.0] * chain.nv, [0.0] * 6 * chain.n
        forces = f.alone().inverse_dynamics(x["q"], rest, x["vdot"], unloaded)
        found = columns(forces, x["vdot"])
        return {"M": [found[j][i] for i, j in places]}

    return fused.fuse(chain, "mass_entries", fused.inputs(chain, "q vdot"), body, algorithms=[INVERSE]), places


def _run(ring: Ring, program: Program, given: Mapping[str, list[Known]]) -> Iterator[Known]:
    known = lambda op, *x: None if any(a is None for a in x) else _tried(lambda: function(ring, op, *x))  # noqa: E731
    binary = {op: _operation(ring, op) for op in BINARY}
    outputs, _ = run(program, given, known, literal=ring.literal, binary=binary)
    yield from outputs["M"]


def _operation(ring: Ring, op: str) -> Callable[[Known, Known], Known]:
    """A binary operation; what is given up makes all else unknown, but zero times or over it is zero."""

    def apply(a: Known, b: Known) -> Known:
        if a is None or b is None:
            zero = op in ("mul", "div") and any(x is not None and not x for x in (a, b))
            return ring.literal(0) if zero else None
        return _tried(lambda: BINARY[op](a, b))

    return apply


def _tried(operation: Callable[[], Any]) -> Known:
    """The result of an operation, unless it is long or has no closed form."""
    try:
        found = operation()
    except (NoClosedFormError, TooLargeError):
        return None
    return found if len(found.terms) <= TERMS else None


def _has_parts(entry: ExactSum) -> bool:
    """Whether symbols stand for sums: turns of sections, what is below a fraction bar, functions of no closed form."""
    generators = [entry.ring.generators[n] for n in entry.generators()]
    unsolved = {x.number for x in entry.ring.open.values()}
    return any(x.number in unsolved or (x.angle or x).part is not None for x in generators)


def _formula(entry: ExactSum) -> FormulaSum:
    """The shorter of the forms with angles in sums and in products."""
    forms = [written(entry.ring, flat(entry, products)) for products in (True, False)]
    return min(forms, key=lambda form: form.operations)
