"""A step as a document shows it: its name, what it means, the equation, and its components where they help."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp

from ..algebra import expression as ex
from ..algebra.notation import latex, number, terms
from ..derive.block import Binding, Block, Signal, Step
from .latex_layout import PAGE, Formula, columns, equation, matrix, width
from .latex_scalars import Scalars, entry, scalars
from .latex_tidy import has_integral, is_elementwise, symbols, tidy

MANY = 36
"""Of more components than that only the first and the last are shown."""


@dataclass(frozen=True)
class StepView:
    """What is shown of one step."""

    name: str
    meaning: str
    unit: str
    frame: str
    equation: str
    binding: Binding
    formula: Formula
    components: Formula
    """Empty where the matrix equation says it all."""


@dataclass(frozen=True)
class BlockView:
    """The steps of a block that say something, and the symbols that they use."""

    name: str
    title: str
    steps: tuple[StepView, ...]
    used: tuple[ex.Symbol, ...]
    defined: tuple[Signal, ...]


def block_view(block: Block, seen: dict[str, str] | None = None) -> BlockView:
    """The block without steps that are zero or identity, and without those that ``seen`` holds by name."""
    seen = {} if seen is None else seen
    write = scalars(block)
    steps, used, defined = [], [], []
    for step in block.steps.values():
        right = tidy(step.expression, block, write)
        text = latex(right)
        if ex.is_zero(right) or ex.is_identity(right) or seen.get(step.signal.name) == text or _vanishes(block, step):
            continue
        seen[step.signal.name] = text
        steps.append(_view(block, step, right, write))
        used += symbols(right)
        defined.append(step.signal)
    return BlockView(block.name, block.title, tuple(steps), tuple(used), tuple(defined))


def _vanishes(block: Block, step: Step) -> bool:
    return not any(value != 0 for value in block.values[step.signal.name].flat)


def _view(block: Block, step: Step, right: ex.Expression, write: Scalars) -> StepView:
    s = step.signal
    left = latex(ex.Symbol(s.name, s.shape, s.display))
    # a step that only names what its symbol says (omega~ squared) is shown by its entries alone
    sides = [] if latex(right) == left else [terms(right)]
    bracket, below = _components(block, step, right, write)
    formula = equation(left, *sides, *([[bracket]] if bracket else []))
    return StepView(s.name, s.meaning, s.unit, s.frame, step.equation, s.binding, formula, below)


# ----------------------------------------------------------------------------------------- components


def _components(block: Block, step: Step, right: ex.Expression, write: Scalars) -> tuple[str, Formula]:
    """The components in brackets, or entry by entry below the equation, or neither."""
    made = {symbol: e for symbol, e in step.assignments}
    known = step.signal.binding <= Binding.PARAMETER
    if not made or (is_elementwise(right) and not known) or step.signal.shape == (1, 1) and _says_it_all(right):
        return "", ()
    values = block.values[step.signal.name]
    entries = np.vectorize(lambda v: made.get(v, v), otypes=[object])(values)
    bracket = _bracket(entries, write)
    if width(bracket) <= PAGE - 8.0:
        return bracket, ()
    if known or has_integral(right):
        return "", _rows(step, made, write)
    return "", ()


def _says_it_all(right: ex.Expression) -> bool:
    """Whether the components of a scalar would only repeat its equation."""
    return not has_integral(right) and all(s.shape == (1, 1) for s in symbols(right))


def _bracket(entries: np.ndarray, write: Scalars) -> str:
    """A matrix of entries with what they have in common before the bracket."""
    if entries.shape == (1, 1):
        return write(entries.item())
    common = _common(entries)
    inside = [[write(sp.nsimplify(e / common, rational=False) if e != 0 else sp.S.Zero) for e in row] for row in entries]
    return (rf"{write(common)}\," if common != 1 else "") + matrix(inside)


def _common(entries: np.ndarray) -> sp.Expr:
    """The product of symbols that divides every entry; numbers stay inside."""
    powers = [e.as_coeff_Mul()[1].as_powers_dict() for e in entries.flat if e != 0]
    if len(powers) < 2 or any(not base.is_Symbol for p in powers for base in p if base != 1):
        return sp.S.One
    shared = set.intersection(*(set(p) for p in powers)) - {sp.S.One}
    signs = {b: {p[b].is_positive for p in powers} for b in shared}
    kept = [b for b in shared if len(signs[b]) == 1]
    return sp.Mul(*(b ** min((p[b] for p in powers), key=abs) for b in kept))


def _rows(step: Step, made: dict[sp.Symbol, sp.Expr], write: Scalars) -> Formula:
    """One equation per component that needs one; a component that is too long is left to the equation above."""
    shown = {label: index for index, label in step.signal.labels()}
    equations = []
    for symbol, e in made.items():
        left = entry(step.signal, shown[symbol.name])
        formula = equation(left, write.terms(e))
        if len(formula) > 3 or any(width(" ".join(row)) > PAGE + 2.0 for row in formula):
            return ()
        equations.append(formula)
    return _shortened(equations)


def _shortened(equations: Sequence[Formula]) -> Formula:
    if len(equations) <= MANY:
        return columns(equations)
    first, last = columns(equations[:8]), columns(equations[-4:])
    return (*first, ("", r"\;\;\vdots"), *last)


__all__ = ["BlockView", "StepView", "block_view", "number"]
