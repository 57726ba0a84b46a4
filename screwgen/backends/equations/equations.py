"""The equations of motion of a robot entry by entry, as expressions of sympy, in text, LaTeX and HTML."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

from ...arguments import Numbers
from ...lazily import sp
from ...spec.parameters import Parameter
from ..latex.layout import PAGE, Formula, equation
from .names import MEANINGS, Name, dotted
from .trees import FormulaSum
from .writing import LATEX, TEXT, FormulaWriter, expression

TEXT_LETTERS, LATEX_LETTERS = {"tau": "tau0"}, {"tau": r"\tau^{\circ}"}
"""The letters of entries in text and in LaTeX, where they are not those of the matrix."""
ROOM = PAGE - 6.0
"""The width that a term may take before it is broken inside its bracket, em."""


@dataclass(frozen=True)
class Letters:
    """The names of generators, what stands for them in expressions, and which of them move."""

    names: Mapping[int, Name]
    symbols: Mapping[int, sp.Expr]
    moving: frozenset[int]

    def text(self, formula: FormulaSum) -> str:
        """A formula in text."""
        return FormulaWriter(self.names, TEXT, self.moving)(formula)

    def latex(self, formula: FormulaSum) -> list[str]:
        """The terms of a formula in LaTeX."""
        return FormulaWriter(self.names, LATEX, self.moving).terms(formula, ROOM) or ["0"]

    def expression(self, formula: FormulaSum) -> sp.Expr:
        """A formula as an expression."""
        return expression(formula, self.symbols)


SIDES = {
    "M": ("M(q) qddot", r"\mathbf{M}(\mathbf{q})\,\ddot{\mathbf{q}}"),
    "C": ("C(q, qdot) qdot", r"\mathbf{C}(\mathbf{q}, \dot{\mathbf{q}})\,\dot{\mathbf{q}}"),
    "D": ("D qdot", r"\mathbf{D}\,\dot{\mathbf{q}}"),
    "K": ("K q", r"\mathbf{K}\,\mathbf{q}"),
    "g": ("g(q)", r"\mathbf{g}(\mathbf{q})"),
}
"""What the left side of the equations is made of, in text and in LaTeX."""
ROUNDING = 1e-12
"""What arithmetic leaves of an angle, rad."""

Forms = Mapping[str, Sequence[Sequence[FormulaSum]]]
"""The entries of matrices and columns by their letter."""


class Shown:
    """Matrices entry by entry, and how they show themselves.

    ``operations``: how many additions, multiplications, powers and functions all entries take as they are written.
    """

    heading = ""
    latex_heading: tuple[str, ...] = ()

    def __init__(self, robot: str, forms: Forms, letters: Letters, parts: Mapping[int, FormulaSum]):
        self.robot, self._forms, self._letters, self._parts = robot, forms, letters, parts

    def _matrix(self, letter: str) -> sp.ImmutableMatrix:
        rows = self._forms[letter]
        return sp.ImmutableMatrix([[self._letters.expression(entry) for entry in row] for row in rows])

    @cached_property
    def operations(self) -> int:
        """The number of operations of what is shown; of a symmetric matrix half is."""
        shown = sum(entry.operations for _, _, entry in self._entries())
        return shown + sum(part.operations for part in self._parts.values())

    @cached_property
    def parts(self) -> dict[sp.Symbol, sp.Expr]:
        """What symbols of common parts stand for, such as the turn of a bent link's tip."""
        letters = self._letters
        return {letters.symbols[number]: letters.expression(part) for number, part in self._parts.items()}

    def expanded(self, e: sp.Expr) -> sp.Expr:
        """An expression, or a matrix, with common parts written out."""
        for symbol, part in reversed(self.parts.items()):
            e = e.subs(symbol, part)
        return e

    def has(self, letter: str) -> bool:
        """Whether a matrix has an entry that is not zero."""
        return any(entry.terms for row in self._forms[letter] for entry in row)

    def _entries(self) -> Iterator[tuple[str, tuple[int, ...], FormulaSum]]:
        """Letter, place and formula of every entry that is not zero; of a symmetric matrix its upper half."""
        for letter, rows in self._forms.items():
            for i, row in enumerate(rows):
                for j, entry in enumerate(row):
                    if entry.terms and not (letter in self.symmetric and j < i):
                        yield letter, (i + 1, j + 1)[: 1 if len(row) == 1 else 2], entry

    @cached_property
    def symmetric(self) -> frozenset[str]:
        """The letters of symmetric matrices; of C, which changes with the order of its indices, none is."""
        square = {letter: rows for letter, rows in self._forms.items() if len(rows) == len(rows[0]) and letter != "C"}
        alike = lambda rows: [list(row) for row in rows] == [list(row) for row in zip(*rows, strict=True)]  # noqa: E731
        return frozenset(letter for letter, rows in square.items() if alike(rows))

    def _place(self, letter: str, place: tuple[int, ...]) -> tuple[str, ...]:
        """An entry's place, and of a symmetric matrix also the other one with the same formula."""
        comma = "," if len(self._forms[letter]) > 9 else ""
        both = [place] if letter not in self.symmetric or len(set(place)) == 1 else [place, place[::-1]]
        return tuple(comma.join(map(str, p)) for p in both)

    def __str__(self) -> str:
        lines = [f"{self.robot}: {self.heading}"]
        lines += [f"{self._letters.names[k].text} = {self._letters.text(part)}" for k, part in self._parts.items()]
        for letter, place, entry in self._entries():
            left = " = ".join(f"{TEXT_LETTERS.get(letter, letter)}_{p}" for p in self._place(letter, place))
            lines.append(f"{left} = {self._letters.text(entry)}")
        return "\n".join(lines)

    __repr__ = __str__

    def grouped(self) -> dict[str, list[Formula]]:
        """By letter the entries that are not zero, as rows of cells in LaTeX; by "" those of common parts."""
        letters = self._letters
        out = {"": [equation(letters.names[k].latex, letters.latex(part)) for k, part in self._parts.items()]}
        for letter, place, entry in self._entries():
            left = " = ".join(f"{LATEX_LETTERS.get(letter, letter)}_{{{p}}}" for p in self._place(letter, place))
            out.setdefault(letter, []).append(equation(left, letters.latex(entry)))
        return out

    def latex(self) -> str:
        """The equations as one environment for a display: the equation of motion above, the entries aligned below."""
        formulas = [formula for group in self.grouped().values() for formula in group]
        rows = " \\\\\n".join(" & ".join(row) for formula in formulas for row in formula)
        aligned = f"\\begin{{aligned}}\n{rows}\n\\end{{aligned}}"
        return "\\begin{gathered}\n" + " \\\\\n".join([*self.latex_heading, aligned]) + "\n\\end{gathered}"

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex()}$"


def column(entries: Sequence[str]) -> str:
    """A column in LaTeX, written as a row."""
    return "[" + r",\ ".join(entries) + r"]^{\top}"


Values = Sequence[tuple[Name, float, Parameter]]
"""Parameters with their names in formulas and their values."""


class Given(Protocol):
    """What equations were made from."""

    @property
    def q(self) -> Sequence[Name]: ...

    @property
    def tau(self) -> Sequence[Name]: ...

    @property
    def right(self) -> Sequence[Name | None]: ...

    def linearised(self, robot: str, q: Numbers | None, rounding: float) -> LinearEquations: ...


class Equations(Shown):
    """``M(q) qddot + C(q, qdot) qdot + D qdot + K q + g(q) = tau`` of a robot, entry by entry in closed form.

    ``q``, ``qdot``, ``qddot`` (nv): tuples of symbols, in the order of the model's ``q_names`` (joints rad or m, rotors
    rad, modes m or rad); ``tau`` (n_tau): the symbols of the drives' efforts, N·m or N. ``M`` (nv, nv): inertia; ``C``
    (nv, nv): Coriolis and centrifugal terms by Christoffel's symbols, so that ``Mdot - 2 C`` is skew-symmetric; ``D``,
    ``K`` (nv, nv): damping and stiffness; ``g`` (nv, 1): weight and what else acts at rest; ``forces`` (nv, 1): the
    right-hand side, ``tau`` on the axes or on the rotors of elastic gears, and zero. ``parameters``: the robot file's
    value of every symbol of a parameter, ``parameter_names`` its name there; ``parts``: what the symbols of common
    parts stand for. A parameter that the file states as zero is left out.
    """

    def __init__(
        self, robot: str, forms: Forms, letters: Letters, parts: Mapping[int, FormulaSum], given: Given, values: Values
    ):
        super().__init__(robot, forms, letters, parts)
        self._given, self._values = given, values
        sides = [side for side in SIDES if side == "M" or self.has(side)]
        q, right = [name.latex for name in given.q], [name.latex if name else "0" for name in given.right]
        self.latex_heading = (
            " + ".join(SIDES[side][1] for side in sides) + r" = \boldsymbol{\tau}",
            rf"\mathbf{{q}} = {column(q)}",
            rf"\boldsymbol{{\tau}} = {column(right)}",
        )
        words, forces = (
            " + ".join(SIDES[side][0] for side in sides),
            (name.text if name else "0" for name in given.right),
        )
        self.heading = f"{words} = [{', '.join(forces)}], q = [{', '.join(name.text for name in given.q)}]"

    @cached_property
    def q(self) -> tuple[sp.Symbol, ...]:
        """The coordinates (nv)."""
        return tuple(sp.Symbol(name.text) for name in self._given.q)

    @cached_property
    def qdot(self) -> tuple[sp.Symbol, ...]:
        """Their rates (nv)."""
        return tuple(sp.Symbol(dotted(name, 1).text) for name in self._given.q)

    @cached_property
    def qddot(self) -> tuple[sp.Symbol, ...]:
        """Their accelerations (nv)."""
        return tuple(sp.Symbol(dotted(name, 2).text) for name in self._given.q)

    @cached_property
    def tau(self) -> tuple[sp.Symbol, ...]:
        """The efforts of the drives (n_tau)."""
        return tuple(sp.Symbol(name.text) for name in self._given.tau)

    @cached_property
    def forces(self) -> sp.ImmutableMatrix:
        """The right-hand side (nv, 1): an effort on each row of a drive, zero on the others."""
        return sp.ImmutableMatrix([sp.Symbol(name.text) if name else sp.S.Zero for name in self._given.right])

    @cached_property
    def M(self) -> sp.ImmutableMatrix:
        """The inertia matrix (nv, nv)."""
        return self._matrix("M")

    @cached_property
    def C(self) -> sp.ImmutableMatrix:
        """The matrix (nv, nv) of Coriolis and centrifugal terms, linear in the rates."""
        return self._matrix("C")

    @cached_property
    def D(self) -> sp.ImmutableMatrix:
        """The damping matrix (nv, nv)."""
        return self._matrix("D")

    @cached_property
    def K(self) -> sp.ImmutableMatrix:
        """The stiffness matrix (nv, nv)."""
        return self._matrix("K")

    @cached_property
    def g(self) -> sp.ImmutableMatrix:
        """The forces of weight (nv, 1)."""
        return self._matrix("g")

    @property
    def meanings(self) -> list[tuple[Name, tuple[str, str]]]:
        """What the common parts are, each with its unit."""
        names = [self._letters.names[number] for number in self._parts]
        return [(name, MEANINGS[name.text.partition("_")[0]]) for name in names]

    @property
    def stated(self) -> Values:
        """The parameters that occur: name in formulas, value, and what the robot file calls it."""
        return self._values

    @property
    def coordinates(self) -> Sequence[Name]:
        """The names of the coordinates."""
        return self._given.q

    @property
    def parameters(self) -> dict[sp.Symbol, float]:
        """The value of each parameter's symbol in the robot file; ``g``: of gravity, where it has one axis."""
        return {sp.Symbol(name.text): value for name, value, _ in self._values}

    @property
    def parameter_names(self) -> dict[sp.Symbol, str]:
        """The name of each parameter's symbol in the robot file."""
        return {sp.Symbol(name.text): p.name for name, _, p in self._values}

    @cached_property
    def residual(self) -> sp.ImmutableMatrix:
        """The left-hand side less the right-hand one (nv, 1): zero where the equations hold."""
        q, qdot, qddot = (sp.Matrix(x) for x in (self.q, self.qdot, self.qddot))
        left = self.M * qddot + self.C * qdot + self.D * qdot + self.K * q + self.g - self.forces
        return sp.ImmutableMatrix(left)

    def linearised(self, q: Numbers | None = None, rounding: float = ROUNDING) -> LinearEquations:
        """The equations for small motions about rest in a posture ``q`` (nq, or joints alone), zero by default; rad, m.

        Multiples of 30 and 45 degrees give roots, other angles decimals; a sum of angles is such a multiple that
        differs from it by ``rounding`` (rad) or less.  Raises UsageError for another length.
        """
        return self._given.linearised(self.robot, q, rounding)


class LinearEquations(Shown):
    """``M x'' + D x' + K x = tau - tau_0`` with ``x = q - q0``, about rest in a ``posture`` q0, whose LaTeX is given.

    ``M``, ``D``, ``K`` (nv, nv); ``tau_0`` (nv, 1): the forces that hold the posture, N·m or N, zero in equilibrium.
    """

    heading = "M x'' + D x' + K x = tau - tau0, x = q - q0"

    def __init__(
        self,
        robot: str,
        forms: Forms,
        letters: Letters,
        parts: Mapping[int, FormulaSum],
        posture: Sequence[str],
    ):
        super().__init__(robot, forms, letters, parts)
        sides = [r"\mathbf{M}\,\ddot{\mathbf{x}}", *[r"\mathbf{D}\,\dot{\mathbf{x}}"] * self.has("D")]
        sides += [r"\mathbf{K}\,\mathbf{x}"] * self.has("K")
        hold = r" - \boldsymbol{\tau}^{\circ}" * self.has("tau")
        self.latex_heading = (
            rf"{' + '.join(sides)} = \boldsymbol{{\tau}}{hold}",
            rf"\mathbf{{x}} = \mathbf{{q}} - \mathbf{{q}}^{{\circ}}, \qquad \mathbf{{q}}^{{\circ}} = {column(posture)}",
        )

    M = property(lambda self: self._matrix("M"), doc="The inertia matrix (nv, nv) in the posture.")
    D = property(lambda self: self._matrix("D"), doc="The damping matrix (nv, nv).")
    K = property(lambda self: self._matrix("K"), doc="The stiffness (nv, nv), that of weight included.")
    tau_0 = property(lambda self: self._matrix("tau"), doc="The forces (nv, 1) that hold the posture.")
