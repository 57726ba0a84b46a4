"""From a robot to its equations: parameters as symbols, derivation, form, names; or a line on what is too large."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from ...algorithms import fused
from ...arguments import Numbers
from ...errors import UsageError
from ...lazily import sp
from ...spec.parameters import Parameter, parameters
from ...topology.chain import Chain
from . import names as nm
from .derive import Derivation, ScalarMotion, check
from .equations import Equations, Forms, Letters, LinearEquations
from .forms import flat, written
from .functions import NoClosedFormError, at, exchanged, special
from .ring import PARAMETER, ExactSum, Generator, Ring, TooLargeError, derivative
from .trees import FormulaSum
from .writing import LATEX

BUDGET = 150_000
"""Products of terms before a derivation is given up: some seconds."""
OPERATIONS = 2000
"""Of all entries together; nobody reads more."""
PROGRAM = 1200
"""Of the inverse dynamics as a program with common parts: what takes more is not written out to be counted."""
EXACT = 1e-12
"""A fixed angle this near to a multiple of 30 or 45 degrees is one."""


@dataclass(frozen=True)
class BeamMass:
    """A common part that may be named: the mass of a beam, by which ``rhoA`` is replaced."""

    mass: Generator
    density: Generator
    length: Generator


class ParameterSymbols:
    """The parameters of a robot as sums: a symbol for each that is not zero, gravity along an axis as ``g``."""

    def __init__(self, ring: Ring, chain: Chain):
        self.ring = ring
        self.of_generator: dict[int, int] = {}
        self.signs: dict[int, int] = {}
        known = parameters(chain.robot)
        one = sum(p.value != 0 for p in known[:3]) == 1
        masses = {k: ring.generator("mass of a beam", PARAMETER) for k, p in enumerate(known) if p.field == "rhoA"}
        ordered = sorted(enumerate(known), key=lambda pair: (nm.order(pair[1]), pair[0]))
        found = {k: self._sum(k, p, one and p.field == "gravity") for k, p in ordered}
        self.p = [found[k] for k in range(len(known))]
        places = {place: ring.generators[n] for n, place in self.of_generator.items()}
        self.beams = [_beam(mass, k, known, places) for k, mass in masses.items() if k in places]
        self.masses = {mass.number: known[k].link for k, mass in masses.items()}

    def _sum(self, place: int, p: Parameter, alone: bool) -> ExactSum:
        ring = self.ring
        if p.value == 0:
            return ring.literal(0)
        turns = p.field == "joint.mount.rpy"
        known = Fraction(p.value / math.pi).limit_denominator(12)
        if turns and abs(known * math.pi - p.value) < EXACT and special(ring, known) is not None:
            return ring.of(ring.pi, 1, known)
        generator = ring.turning(p.name, PARAMETER) if turns else ring.generator(p.name, PARAMETER)
        self.of_generator[generator.number] = place
        sign = -1 if alone and p.value < 0 else 1
        self.signs[place] = sign
        return ring.of(generator, 1, sign)


def _beam(mass: Generator, place: int, known: Sequence[Parameter], places: Mapping[int, Generator]) -> BeamMass:
    """The mass of the beam whose mass per length stands at a place: this times its length."""
    link = known[place].link
    length = next(places[k] for k, p in enumerate(known) if p.link == link and p.field == "length")
    density = places[place]
    mass.part = mass.ring.of(density) * mass.ring.of(length)
    return BeamMass(mass, density, length)


@dataclass
class EquationSource:
    """What equations were made from: the robot, its equations as exact sums, names."""

    chain: Chain
    inputs: ParameterSymbols
    motion: ScalarMotion

    @property
    def q(self) -> list[nm.Name]:
        """The names of the coordinates."""
        return nm.coordinate_names(self.chain)

    @property
    def tau(self) -> list[nm.Name]:
        """The names of the efforts."""
        return nm.effort_names(self.chain)

    @property
    def right(self) -> list[nm.Name | None]:
        """The effort that acts on each row, if one does."""
        rows = dict(zip(self.chain.effort_places, self.tau, strict=True))
        return [rows.get(k) for k in range(self.chain.nv)]

    def letters(self, forms: Forms) -> tuple[Letters, dict[int, FormulaSum], list[tuple[nm.Name, float, Parameter]]]:
        """Names of all that formulas have, the formulas of common parts, and the parameters with their values."""
        ring = self.motion.ring
        used = {n for rows in forms.values() for row in rows for e in row for atom in e.atoms() for n, _ in atom.of}
        parts: dict[int, FormulaSum] = {}
        for number in sorted(used):
            self._part(ring.generators[number], parts, used)
        places = sorted(self.inputs.of_generator[n] for n in used if n in self.inputs.of_generator)
        named, known = nm.parameter_names(self.chain, places), parameters(self.chain.robot)
        names = {n: named[place] for n, place in self.inputs.of_generator.items() if place in named}
        for generators, dots in ((self.motion.q, 0), (self.motion.v, 1), (self.motion.vdot, 2)):
            for generator, name in zip(generators, self.q, strict=True):
                names[generator.number] = nm.dotted(name, dots) if dots else name
        names |= nm.part_names(ring, list(parts), self.inputs.masses, [x.number for x in self.motion.q], self.chain)
        symbols: dict[int, sp.Expr] = {n: sp.Symbol(name.text) for n, name in names.items()}
        for prime, root in ring.roots.items():
            names[root.number] = nm.Name(f"sqrt({prime})", rf"\sqrt{{{prime}}}")
            symbols[root.number] = sp.sqrt(prime)
        names[ring.pi.number], symbols[ring.pi.number] = nm.Name("pi", r"\pi"), sp.pi
        values = [(named[k], known[k].value * self.inputs.signs[k], known[k]) for k in places]
        moving = frozenset(x.number for x in (*self.motion.q, *self.motion.v, *self.motion.vdot))
        return (
            Letters(names, symbols, moving | {n for n in parts if ring.generators[n].wave is not None}),
            parts,
            values,
        )

    def _part(self, generator: Generator, parts: dict[int, FormulaSum], used: set[int]) -> None:
        """Adds the formula of a common part, behind those that it has itself."""
        if generator.part is None or generator.number in parts:
            return
        for number in sorted(generator.part.generators()):
            owner = generator.ring.generators[number]
            self._part(owner.angle or owner, parts, used)
        parts[generator.number] = written(generator.ring, flat(generator.part, products=False))
        used |= {n for atom in parts[generator.number].atoms() for n, _ in atom.of}

    def linearised(self, robot: str, q: Numbers | None, rounding: float) -> LinearEquations:
        """The equations about rest in a posture, whose angles are known but for ``rounding``."""
        ring, motion, n = self.motion.ring, self.motion, self.chain.nq
        values = np.zeros(n) if q is None else np.asarray(q, dtype=float)
        if values.shape == (self.chain.n_joints,):
            values = np.append(values, np.zeros(n - len(values)))
        if values.shape != (n,):
            raise UsageError(f"q has {values.size} entries; give the {n} of the posture, or those of its joints alone")
        posture = {x.number: ring.literal(float(v)) for x, v in zip(motion.q, values, strict=True)}
        here = lambda e: at(e, posture, rounding)  # noqa: E731
        slopes, hold = [], []
        for g, row in zip(motion.g, motion.K, strict=True):
            pairs = list(zip(row, motion.q, strict=True))
            slopes.append([k + derivative(g, x) for k, x in pairs])
            hold.append(g + sum((k * posture[x.number] for k, x in pairs), ring.literal(0)))
        rows = {"M": motion.M, "D": motion.D, "K": slopes, "tau": [[x] for x in hold]}
        ring.spent = 0
        forms = named(
            ring,
            {name: [[here(e) for e in row] for row in matrix] for name, matrix in rows.items()},
            self.inputs.beams,
        )
        letters, parts, _ = self.letters(forms)
        rest = [_stated(letters, posture[x.number], float(v)) for x, v in zip(motion.q, values, strict=True)]
        return LinearEquations(robot, forms, letters, parts, rest)


def _stated(letters: Letters, value: ExactSum, number: float) -> str:
    """A coordinate of a posture in LaTeX: a multiple of π as one, all else as a decimal number."""
    if value.ring.pi.number not in value.generators():
        return LATEX.number(f"{number:.10g}")
    return "".join(letters.latex(written(value.ring, flat(value, products=False))))


def form(ring: Ring, matrices: Mapping[str, Sequence[Sequence[ExactSum]]]) -> tuple[Forms, int]:
    """The entries with angles in sums, or in products where these take no more operations, which are counted."""
    both: list[Forms] = []
    for products in (True, False):
        made: dict[ExactSum, FormulaSum] = {}
        for rows in matrices.values():
            for entry in (e for row in rows for e in row):
                if entry not in made:
                    made[entry] = written(ring, flat(entry, products))
        both.append({name: [[made[e] for e in row] for row in rows] for name, rows in matrices.items()})
    sizes = [sum(e.operations for rows in forms.values() for row in rows for e in row) for forms in both]
    return both[sizes.index(min(sizes))], min(sizes)


def named(ring: Ring, matrices: Mapping[str, Sequence[Sequence[ExactSum]]], beams: Sequence[BeamMass]) -> Forms:
    """The form with masses of beams named where that takes fewer operations, their own included."""
    best, size = form(ring, matrices)
    for part in beams:
        swap = lambda e, part=part: exchanged(e, part.density, part.mass, part.length)  # noqa: E731
        other = {name: [[swap(e) for e in row] for row in rows] for name, rows in matrices.items()}
        forms, operations = form(ring, other)
        if operations + 1 < size:
            best, size, matrices = forms, operations + 1, other
    return best


def equations(chain: Chain, operations: int = OPERATIONS) -> Equations:
    """The equations of a robot in scalars; ``operations``: how many they may take as they are written.

    Raises UsageError for what has no closed form, and for robots whose equations would be larger, with their size.
    """
    check(chain)
    name, program = chain.robot.name, fused.inverse_dynamics(chain).operation_count
    if program > PROGRAM:
        raise UsageError(_too_large(chain, program, "many times as many written out"))
    ring = Ring(BUDGET)
    try:
        inputs = ParameterSymbols(ring, chain)
        source = EquationSource(chain, inputs, Derivation(ring, chain, inputs.p, _turns(chain)).motion())
        motion = source.motion
        rows = {"M": motion.M, "C": motion.C, "D": motion.D, "K": motion.K, "g": [[x] for x in motion.g]}
        if (terms := sum(len(e.terms) for matrix in rows.values() for row in matrix for e in row)) > operations:
            raise TooLargeError(f"{terms} terms written out")
        forms = named(ring, rows, inputs.beams)
    except NoClosedFormError as error:
        raise UsageError(f"robot '{name}' has no equations in scalars: {error}") from None
    except TooLargeError as error:
        raise UsageError(_too_large(chain, program, str(error))) from None
    letters, parts, values = source.letters(forms)
    made = Equations(name, forms, letters, parts, source, values)
    if made.operations > operations:
        raise UsageError(_too_large(chain, program, f"{made.operations} operations written out"))
    return made


def _turns(chain: Chain) -> list[bool]:
    """Which coordinates are angles of joints: those have sines and cosines."""
    joints = [screw.turn for key in chain.keys for screw in key.screws]
    return joints + [False] * (chain.nq - len(joints))


def _too_large(chain: Chain, program: int, size: str) -> str:
    return (
        f"the equations of '{chain.robot.name}' in scalars are too large to read: {program} operations as a program, "
        f"{size}; `screwgen latex` without --scalar shows them by links"
    )
