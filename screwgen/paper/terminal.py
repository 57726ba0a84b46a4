"""The paper's equations on a terminal."""

from __future__ import annotations

import re
import textwrap
from collections import Counter
from collections.abc import Iterable, Sequence

from ..algebra.expression import Symbol
from ..algebra.notation import latex
from .equation import Equality, Equation, Formula, Standing
from .erratum import Erratum, Figure
from .numbers import on_page
from .plain import WIDTH, boxed, hung, letters, relation, shown
from .quantities import QUANTITIES
from .register import SECTIONS, errata, erratum

SEED = 1
LABELLED = "An equation is called by its label in the paper's source; beside it is its number on the page."


def listing(equations: Iterable[Equation]) -> str:
    """One line an equation, section by section, and how many stand."""
    lines, section = ["", f"  {'label':<14} {'number':<7} stands"], ""
    chosen = list(equations)
    for e in chosen:
        if e.section != section:
            section = e.section
            name = f"Section {section}" if section.isdigit() else f"Appendix {section}"
            lines += ["", f"{name}: {SECTIONS[section]}"]
        standing = {Standing.NOTATION: "notation"}.get(e.standing, e.standing.value)
        lines.append(
            f"  {f'({e.label})':<14} {on_page(e.label):<7} {standing:<9} {e.title}"
            + (f"  [{', '.join(e.errata)}]" if e.errata else "")
        )
    return "\n".join([*lines[1:], "", summary(chosen)])


def summary(equations: Sequence[Equation]) -> str:
    """How many hold and fail, and how to see more."""
    hint = "'screwgen paper 29' shows an equation, 'screwgen paper E7' an erratum with its numbers."
    return f"{counted(equations)}\n{LABELLED}\n{hint}"


def counted(equations: Sequence[Equation]) -> str:
    """How many hold, hold after a change of notation, and fail."""
    count = Counter(e.standing for e in equations)
    return (
        f"{len(equations)} equations: {count[Standing.HOLDS]} hold, {count[Standing.NOTATION]} hold after a change of "
        f"notation, {count[Standing.FAILS]} fail ({len(errata())} errata)."
    )


def equation_text(e: Equation) -> str:
    """An equation: printed, derived, the difference, the judgement, the errata and the symbols."""
    part = "Section" if e.section.isdigit() else "Appendix"
    number = f", number {on_page(e.label)} on the page" if on_page(e.label) else ""
    lines = [f"({e.label})  {e.title}", f"{part} {e.section}{number}: {e.standing.value}", ""]
    lines += _formulas("printed", e.printed)
    for name, value in e.reading.items():
        lines += ["", "  read", *(f"    {line}" for line in relation(_named(e, name), value, WIDTH - 4))]
    if e.derived:
        lines += ["", *_formulas("derived", e.derived)]
    for d in e.gaps():
        text = _text(d, WIDTH - 22) if isinstance(d, Formula) else boxed(d, WIDTH - 22)
        lines += ["", *(f"  {line}" for line in hung("printed − derived = ", text))]
    lines += ["", *_wrapped(judgement(e))]
    if e.note:
        lines += ["", *_wrapped(f"{letters_in(e.note)}")]
    if e.errata:
        lines += [""] + [f"  {n}  {letters_in(erratum(n).title)}" for n in e.errata]
    if e.block:
        lines += ["", f"  derived block and step: {e.block}"]
    return "\n".join(lines + _symbols(e))


def _named(e: Equation, name: str) -> Symbol:
    return next(s for s in e.symbols if s.name == name)


def _formulas(head: str, statements: tuple[Equality | Formula, ...]) -> list[str]:
    lines = [f"  {head}"]
    for s in statements:
        text = relation(s.left, s.right, WIDTH - 4) if isinstance(s, Equality) else _text(s)
        lines += [f"    {line}" for line in text]
    return lines


def _text(s: Formula, width: int = WIDTH - 4) -> list[str]:
    if isinstance(s.statement, str):
        return [line for part in letters_in(s.statement).splitlines() for line in textwrap.wrap(part, width)]
    return textwrap.wrap(letters(s.latex), width, subsequent_indent="  ")


def judgement(e: Equation) -> str:
    """What the judge says, in a sentence."""
    printed, derived = e.misfits(SEED)
    where = "By its own judge" if e.judge else "On a random motion"
    if e.standing is Standing.FAILS:
        return (
            f"{where}, the printed formula misses by {printed:.2g} of its largest term, "
            f"the derived one by {bounded(derived)}."
        )
    return f"{where}, the two sides agree to {bounded(printed)} of the largest term."


def bounded(misfit: float) -> str:
    """A rounding error as a bound, which does not depend on the machine."""
    return "less than 1e-11" if misfit < 1e-11 else f"{misfit:.2g}"


def _symbols(e: Equation) -> list[str]:
    rows = []
    for s in e.symbols:
        q = QUANTITIES.get(s.name.partition(":")[0])
        if q:
            rows.append((letters(s.display), q.meaning, "" if q.unit == "-" else q.unit.replace("*", "·")))
    if not rows:
        return []
    wide = max(shown(name) for name, *_ in rows) + 2
    return ["", "  symbols"] + [f"    {n}{' ' * (wide - shown(n))}{m}" + (f"  [{u}]" if u else "") for n, m, u in rows]


# ------------------------------------------------------------------------------------------ errata


def errata_listing() -> str:
    """One line an erratum."""
    return "\n".join(f"  {e.number:<4} {where(e):<28} {letters_in(e.title)}" for e in errata())


def erratum_text(e: Erratum) -> str:
    """An erratum: what is printed, what holds, and the figures."""
    lines = [f"{e.number}  {letters_in(e.title)}", f"in {where(e)}", ""]
    lines += [*_wrapped(f"printed: {letters_in(e.printed)}"), "", *_wrapped(f"holds: {letters_in(e.holds)}"), ""]
    figures = e.figures
    wide = min(max(len(f.what) for f in figures), 64)
    lines.append(f"  {'':<{wide}}  {'printed':>12} {'derived':>12} {'must be':>12}")
    for f in figures:
        *above, last = textwrap.wrap(letters_in(f.what), wide) or [""]
        unit = "" if f.unit == "-" else f" {f.unit}"
        lines += [f"  {line}" for line in above]
        lines.append(
            f"  {last:<{wide}}  {number(f, f.printed):>12} {number(f, f.derived):>12} {number(f, f.truth):>12}{unit}"
        )
    return "\n".join(lines)


def where(e: Erratum) -> str:
    """The labels of an erratum."""
    return ", ".join(f"({label})" for label in e.where)


def number(f: Figure, value: float) -> str:
    """A figure's number; what is rounding beside its scale is 0."""
    if abs(value) <= 1e-9 * f.size:
        return "0"
    return f"{value:.4g}"


def letters_in(text: str) -> str:
    """Text with its ``$formulas$`` as letters."""
    return re.sub(r"\$([^$]*)\$", lambda m: letters(m[1]), text)


def _wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, WIDTH, initial_indent="  ", subsequent_indent="  ")


# ------------------------------------------------------------------------------------------ machines


def record(e: Equation | Erratum) -> dict:
    """An equation or an erratum as plain data, its formulas in LaTeX."""
    if isinstance(e, Erratum):
        figures = [{"what": f.what, "unit": f.unit, **_numbers(f)} for f in e.figures]
        return {"number": e.number, "where": e.where, "printed": e.printed, "holds": e.holds, "figures": figures}
    return {
        "label": e.label,
        "section": e.section,
        "title": e.title,
        "standing": e.standing.value,
        "errata": e.errata,
        "printed": [_latex(s) for s in e.printed],
        "derived": [_latex(s) for s in e.derived],
        "difference": [d.latex if isinstance(d, Formula) else latex(d) for d in e.gaps()],
        "reading": {latex(_named(e, name)): latex(value) for name, value in e.reading.items()},
        "block": e.block,
    }


def _numbers(f: Figure) -> dict[str, str]:
    return {"printed": number(f, f.printed), "derived": number(f, f.derived), "truth": number(f, f.truth)}


def _latex(s: Equality | Formula) -> str:
    return f"{latex(s.left)} = {latex(s.right)}" if isinstance(s, Equality) else s.latex
