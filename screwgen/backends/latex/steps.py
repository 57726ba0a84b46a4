"""A step in a document: its name, its meaning, the equation, and its components where they help."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import sympy as sp

from ...algebra import expression as ex
from ...algebra.components import Array
from ...algebra.notation import axis_latex, latex, terms, tilde
from ...algebra.rewrite import symbols
from ...ir.block import Binding, Block, NamedSignal, Step
from .blocks import Parts, by_blocks
from .layout import PAGE, TALL, Formula, abridged, columns, dots, equation, matrix, width
from .scalars import Scalars, entry, scalars
from .tidy import has_integral, is_elementwise, is_symbols_product, tidy

Axes = Sequence[tuple[tuple[sp.Expr, ...], str]]
"""Unit axes with their names."""
Labels = Mapping[str, tuple[str, tuple[int, int]]]
"""By the label of an entry: the LaTeX of its symbol, and its place."""
KEY_STEPS = ("M_star", "M_DPsi", "M_D", "h_MD", "H_star", "M_Dphi", "M_Wphi", "h_phi")
"""The blocks of a link's equations, by which the paper calls them."""


Seen = tuple[str, tuple[sp.Expr, ...]]
"""Formula and entries of a step that has been shown."""


@dataclass(frozen=True)
class Definition:
    """What a step says, with all digits: the symbol, the right side of its equation, and the entries of its components.

    ``entries`` are over the labels of entries of earlier symbols; ``labels`` has, for each of these, the LaTeX of the
    symbol with row and column of the entry. Equal are definitions with the same integrals and numbers.
    """

    signal: NamedSignal = field(compare=False)
    right: ex.Expression = field(compare=False)
    entries: Array = field(compare=False)
    labels: Labels = field(compare=False)
    numbers: tuple[sp.Expr, ...]


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
    """Empty if the matrix equation suffices."""
    definition: Definition
    digits: tuple[tuple[str, str], ...] = ()
    """The entries that have numbers, each with its LaTeX with all digits."""
    alone: Formula = ()
    """The equation without its components, where they only write out its products and sums; else empty."""


@dataclass(frozen=True)
class BlockView:
    """The steps of a block that say something, and the symbols that they use."""

    name: str
    title: str
    steps: tuple[StepView, ...]
    used: tuple[ex.Symbol, ...]
    defined: tuple[NamedSignal, ...]
    counts: tuple[int, int]
    """The numbers of joint rates and of modes in the class of links."""
    zeros: tuple[str, ...] = ()
    """The symbols of steps that are shown of another section, and are zero here."""
    identities: tuple[str, ...] = ()


AXES_OF_JOINT = ("A", "T")
"""Identities that are shown: what a joint does without them is nothing."""
DIAGONAL = 4
"""From that size on a diagonal matrix is written by its diagonal."""
DIGITS = 17
"""How many digits tell a number in double precision from all others."""
MANY = 36
"""Of more components than that only the first and the last are shown."""


def block_view(
    block: Block,
    seen: dict[str, Seen] | None = None,
    axes: Axes = (),
    structure: Mapping[str, Array] | None = None,
    counts: tuple[int, int] = (0, 0),
    parts: Parts = (),
    *,
    told: Collection[str] = (),
) -> BlockView:
    """The block without steps that are zero or identity, and without those that ``seen`` holds by name.

    ``axes`` are those that have a name: they are written so in place of their components. ``structure`` holds
    values of inputs that other blocks give: what is zero there is left out here. ``counts``: :attr:`BlockView.counts`.
    ``parts``: the directions of the modes, by which wide matrices are shown. ``told``: the names of steps that are
    shown of another section; those of them that are zero or identity here are listed.
    """
    seen = {} if seen is None else seen
    values = block.values | {n: v for n, v in (structure or {}).items() if n in block.inputs}
    write, labels = scalars(block), _labels(block)
    steps, used, defined = [], [], []
    zeros: list[str] = []
    identities: list[str] = []
    for step in block.steps.values():
        right = tidy(step.expression, values, write)
        found = latex(right), tuple(_entries(block, step).flat)
        none = ex.is_zero(right) or _vanishes(block, step)
        if none or (ex.is_identity(right) and step.signal.name not in AXES_OF_JOINT):
            values[step.signal.name] = (
                np.zeros(step.signal.shape, dtype=int) if none else np.eye(*step.signal.shape, dtype=int)
            )
            if step.signal.name in told:
                (zeros if none else identities).append(_written(step.signal))
            continue
        if seen.get(step.signal.name) == found or (isinstance(right, ex.Stumpff) and ex.is_zero(right.arg)):
            continue  # a Stumpff function of no angle meets the skew matrix of none
        seen[step.signal.name] = found
        view = _view(block, step, right, write, axes, parts, labels)
        if len(view.formula) == 1 and not view.formula[0][1]:
            continue  # its symbol says it all
        steps.append(view)
        used += symbols(right)
        defined.append(step.signal)
    return BlockView(
        block.name, block.title, tuple(steps), tuple(used), tuple(defined), counts, tuple(zeros), tuple(identities)
    )


def _renamed(text: str, axes: Axes) -> str:
    for axis, name in axes:
        components = axis_latex(axis)
        text = text.replace(tilde(components), tilde(name)).replace(components, name)
    return text


def _vanishes(block: Block, step: Step) -> bool:
    return not any(value != 0 for value in block.values[step.signal.name].flat)


def _labels(block: Block) -> Labels:
    """By the label of every entry of a block's signals: the LaTeX of the signal, and the place of the entry."""
    signals = (*block.inputs.values(), *(step.signal for step in block.steps.values()))
    return {label: (_written(s), index) for s in signals for index, label in s.labels()}


def _written(s: NamedSignal) -> str:
    return latex(ex.Symbol(s.name, s.shape, s.display))


def _entries(block: Block, step: Step) -> Array:
    """The entries of a step over those of earlier symbols."""
    made = dict(step.assignments)
    return np.vectorize(lambda v: made.get(v, v), otypes=[object])(block.values[step.signal.name])


def _view(
    block: Block, step: Step, right: ex.Expression, write: Scalars, axes: Axes, parts: Parts, labels: Labels
) -> StepView:
    s = step.signal
    left = _written(s)
    # a step that only names what its symbol says (omega~ squared) is shown by its entries alone
    sides = (
        []
        if latex(right).replace(r"\,", "") == left.replace(r"\,", "")
        else [[_renamed(term, axes) for term in _terms(right)]]
    )
    bracket, below = _components(block, step, right, write, parts)
    formula = equation(left, *sides, *([[bracket]] if bracket else []))
    entries = _entries(block, step)
    own = tuple(e for e in entries.flat if has_integral(right) or sp.sympify(e).has(sp.Float))
    definition = Definition(s, right, entries, labels, own)
    digits = _digits(s, entries, write) if s.binding <= Binding.PARAMETER else ()
    alone = equation(left, *sides) if sides and (bracket or below) and _repeats(block, right) else ()
    meaning = s.meaning + ", symmetric" * bool(below and _is_symmetric(entries))
    about = (s.name, meaning, s.unit, s.frame, step.equation, s.binding)
    return StepView(*about, formula, below, definition, digits, alone)


def _repeats(block: Block, right: ex.Expression) -> bool:
    """Whether components of an equation say no more than it: sums and products of symbols that have steps."""
    if isinstance(right, ex.Symbol):
        return right.name in block.inputs or right.name in block.steps
    simple = (ex.Sum, ex.Product, ex.Negative, ex.Transpose, ex.Hat, ex.Trace, ex.Diagonal, ex.Constant, ex.BlockMatrix)
    return isinstance(right, simple) and all(_repeats(block, child) for child in right.children)


def _digits(signal: NamedSignal, entries: Array, write: Scalars) -> tuple[tuple[str, str], ...]:
    """The entries with numbers that are not short, with all their digits; equal ones together."""
    whole = replace(write, digits=DIGITS)
    found: dict[str, list[str]] = {}
    for index, value in np.ndenumerate(entries):
        text = whole(sp.sympify(value))
        if text != write(sp.sympify(value)):
            found.setdefault(text, []).append(entry(signal, index))
    return tuple((" = ".join(names), text) for text, names in found.items())


def _terms(right: ex.Expression) -> list[str]:
    """The terms of the right side; a Stumpff function by its series, for its symbol says no more than its name."""
    if isinstance(right, ex.Stumpff):
        return [rf"\sum\limits_{{j=0}}^{{\infty}} \frac{{(-{latex(right.arg)})^{{j}}}}{{({right.order}+2j)!}}"]
    return terms(right)


# ----------------------------------------------------------------------------------------- components


def _components(block: Block, step: Step, right: ex.Expression, write: Scalars, parts: Parts) -> tuple[str, Formula]:
    """The components in brackets, by blocks or entry by entry below the equation, or none."""
    entries = _entries(block, step)
    if not _worth_showing(block, step, right, entries, write):
        return "", ()
    bracket = _bracket(entries, write)
    if bracket == latex(right):
        return "", ()
    if width(bracket) <= PAGE - 8.0 and max(entries.shape) <= TALL:
        return bracket, ()
    evaluated = step.signal.binding <= Binding.PARAMETER or has_integral(right)
    if entries.shape[1] > 1 and evaluated:
        whole, blocks = by_blocks(step.signal, entries, write, parts, lambda block: _bracket(block, write))
        if whole:
            return whole, blocks
    if width(bracket) <= PAGE - 8.0:
        return bracket, ()
    return "", _rows(step, entries, write) if evaluated else ()


def _worth_showing(block: Block, step: Step, right: ex.Expression, entries: np.ndarray, write: Scalars) -> bool:
    """Whether components say more than the matrix equation, briefly.

    Evaluated integrals, constants and matrices do; of vectors those that are linear in the state.
    """
    if has_integral(right):
        return entries.shape != (1, 1) or len(sp.Add.make_args(entries.item())) <= 6
    if isinstance(right, ex.Symbol):
        return right.name not in block.inputs and right.name not in block.steps
    if step.signal.binding <= Binding.PARAMETER:
        if isinstance(right, ex.Negative) and ex.is_identity(right.arg):
            return False
        aliases = entries.shape[1] == 1 and len(entries) > 1 and not step.assignments and symbols(right)
        return not aliases and (entries.shape != (1, 1) or not _says_it_all(right))
    if not step.assignments or is_elementwise(right) or is_symbols_product(right):
        return False
    if entries.shape == (1, 1):
        return not _says_it_all(right)
    assembled = isinstance(right, ex.BlockMatrix) and len(right.rows) > 1
    return not assembled and (entries.shape[1] > 1 or all(_is_plain(e, write) for e in entries.flat))


def _says_it_all(right: ex.Expression) -> bool:
    """Whether the components of a scalar would only repeat its equation."""
    return all(s.shape == (1, 1) for s in symbols(right))


def _is_plain(e: sp.Expr, write: Scalars) -> bool:
    """At most two terms, or linear in the state; nothing nested."""
    terms_ = sp.Add.make_args(e)
    nested = any(f.is_Add for t in terms_ for f in sp.Mul.make_args(t))
    linear = all(sum(write.is_state(s) for s in t.free_symbols) <= 1 for t in terms_)
    return not nested and (linear or len(terms_) <= 2)


def _bracket(entries: np.ndarray, write: Scalars) -> str:
    """A matrix of entries with their common factor before the bracket."""
    if entries.shape == (1, 1):
        return write(entries.item())
    common = _common(entries)
    if common != 1 and _is_identity(entries / common):
        return rf"{_before(common, write)}\mathbf{{I}}_{{{len(entries)}}}"
    if (diagonal := _diagonal(entries)) is not None:
        inside = r",\ ".join(write(value / common) for value in diagonal)
        return rf"{_before(common, write)}\mathrm{{diag}}\left({inside}\right)"
    shown = [[_entry(entries, i, j, common, write) for j in abridged(entries.shape[1])] for i in abridged(len(entries))]
    return _before(common, write) + matrix(shown)


def _entry(entries: np.ndarray, i: int | None, j: int | None, common: sp.Expr, write: Scalars) -> str:
    return dots(i, j) if i is None or j is None else write(entries[i, j] / common)


def _is_identity(entries: np.ndarray) -> bool:
    square = entries.shape[0] == entries.shape[1]
    return square and all(value == int(i == j) for (i, j), value in np.ndenumerate(entries))


def _diagonal(entries: np.ndarray) -> np.ndarray | None:
    """The diagonal of a large matrix that has nothing else."""
    n = len(entries)
    if not DIAGONAL <= n <= TALL or entries.shape[1] != n:
        return None
    beside = any(value != 0 for (i, j), value in np.ndenumerate(entries) if i != j)
    return None if beside else np.diagonal(entries)


def _before(common: sp.Expr, write: Scalars) -> str:
    if common == 1:
        return ""
    above, below = common.as_numer_denom()
    return (rf"\tfrac{{{write(above)}}}{{{write(below)}}}" if below != 1 else write(above)) + r"\,"


def _common(entries: np.ndarray) -> sp.Expr:
    """The product of symbols that divides every entry and leaves no fraction; numbers stay inside."""
    powers = [e.as_coeff_Mul()[1].as_powers_dict() for e in entries.flat if e != 0]
    if len(powers) < 2 or any(not base.is_Symbol for p in powers for base in p if base != 1):
        return sp.S.One
    shared = sorted(set.intersection(*(set(p) for p in powers)) - {sp.S.One}, key=str)
    lowest = {base: min(p[base] for p in powers) for base in shared}
    equal = {base for base in shared if len({p[base] for p in powers}) == 1}
    return sp.Mul(*(base**n for base, n in lowest.items() if n > 0 or base in equal))


def _is_symmetric(entries: np.ndarray) -> bool:
    return len(entries) > 1 and entries.shape[0] == entries.shape[1] and bool((entries == entries.T).all())


def _rows(step: Step, entries: np.ndarray, write: Scalars) -> Formula:
    """One equation per component that is not zero; components that are too long are left to the equation above.

    Of a symmetric matrix those on the diagonal and above it.
    """
    mirrored = _is_symmetric(entries)
    wanted = [(i, j) for (i, j), value in np.ndenumerate(entries) if value != 0 and not (mirrored and j < i)]
    first, last = (wanted, []) if len(wanted) <= MANY else (wanted[:8], wanted[-4:])
    equations = [equation(entry(step.signal, place), write.terms(entries[place])) for place in first + last]
    if not step.assignments or any(
        len(e) > 3 or any(width(" ".join(row)) > PAGE + 2.0 for row in e) for e in equations
    ):
        return ()
    return columns(equations[: len(first)], equations[len(first) :])
