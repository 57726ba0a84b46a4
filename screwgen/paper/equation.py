"""An equation of the paper: as printed, as derived, and how the two stand to each other."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import Enum

import numpy as np
import sympy as sp

from ..algebra.expression import Constant, Expression, Symbol, is_zero
from ..algebra.rewrite import difference, expand, substitute, symbols
from .evaluate import Instant, evaluate, size
from .random_motion import instant

TOLERANCE = 1e-11
"""What a formula that holds may miss, relative to its largest term."""
SEEDS = (1, 2, 3)


class Standing(Enum):
    """What became of a printed equation."""

    HOLDS = "holds"
    NOTATION = "holds after a change of notation"
    FAILS = "fails"


@dataclass(frozen=True)
class Equality:
    """``left = right``: matrix expressions over the paper's symbols."""

    left: Expression
    right: Expression

    @property
    def residual(self) -> Expression:
        return self.left - self.right

    def read(self, reading: Mapping[str, Expression]) -> Equality:
        """The relation with symbols replaced."""
        return Equality(substitute(self.left, reading), substitute(self.right, reading)) if reading else self

    def misfit(self, motion: Instant) -> float:
        """How far the two sides are apart, relative to the largest term of either."""
        gap = np.abs(evaluate(self.left, motion) - evaluate(self.right, motion)).max()
        scale = max(size(self.left, motion), size(self.right, motion))
        return float(gap / scale) if scale else 0.0


@dataclass(frozen=True)
class Formula:
    """A scalar statement in sympy: of the ELLA section, of function spaces; ``text`` where it is no formula at all."""

    statement: sp.Basic | str

    @property
    def latex(self) -> str:
        return self.statement if isinstance(self.statement, str) else sp.latex(self.statement, order="none")

    @property
    def terms(self) -> list[str]:
        """The LaTeX of the terms of a sum, each with its sign: where a long line may be broken."""
        first, *rest = (sp.latex(t, order="none") for t in sp.Add.make_args(self.statement))
        return [first, *(t if t.startswith("-") else f"+ {t}" for t in rest)]


Statement = Equality | Formula
Judge = Callable[[int], tuple[float, float]]
"""From a seed to the relative misfits of the printed and of the derived statement."""


@dataclass(frozen=True, kw_only=True)
class Equation:
    """One labelled equation.

    ``printed``: what the paper says, line by line.  ``derived``: what holds instead; empty where the printed lines
    stand.  ``reading``: symbols (by name) that must be read as something else for the printed lines to hold.
    ``where``: definitions by which symbols are replaced before formulas are compared or judged.  ``isolated``: the
    link of the judge is moved by its own external wrenches, as in the paper's Section 3.  ``judge`` replaces the
    judgement on motions where an equation is not about motion.  ``block``: the derived block and its step.  ``gap``:
    the difference of printed and derived where they are statements that no algebra can subtract.
    """

    label: str
    section: str
    title: str
    printed: tuple[Statement, ...]
    derived: tuple[Statement, ...] = ()
    reading: Mapping[str, Expression] = field(default_factory=dict)
    where: Mapping[str, Expression] = field(default_factory=dict)
    errata: tuple[str, ...] = ()
    block: str = ""
    note: str = ""
    isolated: bool = False
    judge: Judge | None = None
    gap: tuple[Formula, ...] = ()

    @property
    def standing(self) -> Standing:
        if self.derived:
            return Standing.FAILS
        return Standing.NOTATION if self.reading else Standing.HOLDS

    @property
    def symbols(self) -> list[Symbol]:
        """The symbols of the printed lines, then of the derived ones, in the order of their appearance."""
        sides = [side for s in (*self.printed, *self.derived) if isinstance(s, Equality) for side in (s.left, s.right)]
        return list(dict.fromkeys(s for side in sides for s in symbols(side)))

    def misfits(self, seed: int) -> tuple[float, float]:
        """The relative misfits of the printed and of the derived lines on one random motion, or by the judge."""
        if self.judge:
            return self.judge(seed)
        motion = instant(seed, self.isolated)
        as_read = max(relation(s).read(self.reading).read(self.where).misfit(motion) for s in self.printed)
        derived = [relation(s).read(self.where).misfit(motion) for s in self.derived]
        return as_read, max(derived, default=as_read)

    def differences(self) -> list[Expression]:
        """Printed minus derived, line by line, with equal terms cancelled; empty where nothing differs."""
        if not self.derived or not all(isinstance(s, Equality) for s in (*self.printed, *self.derived)):
            return []
        pairs = zip(map(relation, self.printed), map(relation, self.derived), strict=True)
        return [d for d in (self._difference(p.read(self.reading), d) for p, d in pairs) if not is_zero(d)]

    def gaps(self) -> tuple[Expression | Formula, ...]:
        """The differences as they are shown: of matrix expressions, of sympy's equalities, or as stated."""
        pairs = zip(self.printed, self.derived, strict=False)
        equalities = [_subtracted(*both) for p, d in pairs if (both := _equalities(p, d))]
        return (*self.differences(), *equalities, *self.gap)

    def _difference(self, printed: Equality, derived: Equality) -> Expression:
        """The shorter of the differences with and without the definitions put in."""
        found = []
        for where in ({}, self.where):
            p, d = printed.read(where), derived.read(where)
            same = p.left == d.left
            found.append(difference(p.right, d.right, rank) if same else difference(p.residual, d.residual, rank))
        return min(found, key=length)


def relation(statement: Statement) -> Equality:
    """A line that relates matrix expressions; TypeError for a formula of sympy."""
    if isinstance(statement, Equality):
        return statement
    raise TypeError(f"{statement} relates no matrix expressions")


def _equalities(*lines: Statement) -> list[sp.Eq]:
    """Two lines that give the same quantity by formulas of sympy; else none."""
    found = [s.statement for s in lines if isinstance(s, Formula) and isinstance(s.statement, sp.Eq)]
    return found if len(found) == 2 and found[0].lhs == found[1].lhs else []


def _subtracted(printed: sp.Eq, derived: sp.Eq) -> Formula:
    return Formula(sp.Add(printed.rhs, -derived.rhs, evaluate=False))


def length(e: Expression) -> int:
    """How many terms a reader sees."""
    rows = getattr(e, "rows", None)
    return sum(length(x) for row in rows for x in row) if rows and hasattr(rows[0][0], "shape") else len(expand(e))


def rank(e: Expression) -> int:
    """Order of crossed vectors: angular velocity, places, velocities, accelerations, angular acceleration, force."""
    if not isinstance(e, Symbol):
        return 1 if isinstance(e, Constant) else 5
    name = e.name.partition(":")[0]
    if name[:2] in ("F_", "ta"):
        return 6
    if name in ("omega", "omegadot"):
        return 0 if name == "omega" else 4
    return 3 if ("dot" in name and name[0] in "v") or "ddot" in name else 2 if name[0] in "v" or "dot" in name else 1
