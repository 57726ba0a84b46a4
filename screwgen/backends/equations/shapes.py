"""The shape functions of the flexible links, as formulas from which the numbers of the equations follow."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...bases import Shapes
from ...spec.link_class import LinkClass
from ...topology.chain import Chain
from ..latex.content import Display, Heading, Item, Paragraph
from ..latex.layout import Formula, Row
from ..latex.layout import equation as broken
from ..latex.tables import DIRECTION, decimal
from .forms import flat, written
from .names import Name, modal_names
from .ring import ExactSum, Ring
from .writing import LATEX, FormulaWriter

DEFLECTION = {
    "axial": "u_x",
    "bending_y": "u_y",
    "bending_z": "u_z",
    "torsion": r"\vartheta_x",
    "shear_y": r"\gamma_y",
    "shear_z": r"\gamma_z",
}
"""What the modes of a direction deflect: the centreline, or the sections about their axes."""
LETTERS = (r"\varphi", r"\chi", r"\beta", r"\epsilon", r"\kappa", r"\upsilon")
"""Of the first sets of shapes; equal shapes of several directions or links are one set."""
FEW = 6
"""Of up to that many shapes each is written out."""


def shapes(chain: Chain) -> Iterator[Item]:
    """The deflections of the links and their shapes; nothing of a robot whose links are rigid."""
    flexible = [i for i, key in enumerate(chain.keys) if key.modes]
    if not flexible:
        return
    yield Heading("Shapes of the flexible links")
    yield Paragraph(" ".join(chain.assumptions("`")))
    names: dict[int, list[Name]] = {i: [] for i in flexible}
    numbers = [i for i in flexible for _ in range(chain.keys[i].modes)]
    for i, name in zip(numbers, modal_names(chain), strict=True):
        names[i].append(name)
    sets = list(dict.fromkeys(own for i in flexible for own in _sets(chain.keys[i]).values()))
    for i in flexible:
        yield from _deflections(chain, i, names[i], sets)
    for number, own in enumerate(sets):
        directions = dict.fromkeys(d for i in flexible for d, known in _sets(chain.keys[i]).items() if known is own)
        yield from _definition(own, _letter(number), list(directions))


def _sets(key: LinkClass) -> dict[str, Shapes]:
    """The shapes of a link by direction; those of a body from a file are not functions."""
    directions = dict.fromkeys(direction for direction, _ in key.directions) if key.elastic is None else {}
    return {direction: key.shapes(direction) for direction in directions}


def _letter(number: int) -> str:
    """The letter of a set of shapes."""
    return LETTERS[number] if number < len(LETTERS) else rf"\varphi^{{[{number + 1}]}}"


def _deflections(chain: Chain, i: int, names: Sequence[Name], sets: Sequence[Shapes]) -> Iterator[Item]:
    key = chain.keys[i]
    where = f"link {i + 1}, `{chain.names[i]}`" if chain.n > 1 else f"`{chain.names[i]}`"
    if key.elastic is not None:
        yield Paragraph(f"The displacements of {where} are those of its file, times the modal coordinates.")
        return
    order = ", to first order" * (key.order != 1)
    yield Paragraph(f"Deflection of {where} at $s$, from 0 at its base to 1 at its tip{order}:")
    own = _sets(key)
    rows: list[Row] = []
    for direction, known in own.items():
        letter = _letter(sets.index(known))
        held = [name for name, (d, _) in zip(names, key.directions, strict=True) if d == direction]
        terms = [rf"{letter}_{{{k}}}(s)\,{name.latex}" for k, name in enumerate(held, 1)]
        rows += broken(f"{DEFLECTION[direction]}(s)", [terms[0], *(f"+ {term}" for term in terms[1:])])
    yield Display(tuple(rows))


def _definition(shapes: Shapes, letter: str, directions: Sequence[str]) -> Iterator[Item]:
    """The shapes of a set, their normalisation and order, so that all numbers of the equations follow."""
    family, count, prime = shapes.family, shapes.count, "'" * shapes.family.order
    named = lambda formula: formula.replace(r"\psi", letter)  # noqa: E731
    where = " and ".join(DIRECTION[direction] for direction in directions).capitalize()
    sizes = ", ".join(decimal(x) for x in shapes.stiffness[:FEW]) + ", …" * (count > FEW)
    jacobi = " with Jacobi's polynomials $P_j^{(a,b)}$" * ("P_j^{(" in family.formula)
    if count > 1:
        size = rf"\int_0^1 {letter}_k{prime}\,{letter}_l{prime}\,ds"
        yield Paragraph(
            rf"{where}: $r = {count}$ shapes, {family.title}{jacobi}, normalised and in the order of rising stiffness, "
            rf"$\int_0^1 {letter}_k\,{letter}_l\,ds = \delta_{{kl}}$, ${size} = 0$ for $k \neq l$, "
            rf"and for $k = l$ {sizes}:"
        )
    else:
        yield Paragraph(
            rf"{where}: one shape, of the {family.title}, normalised, $\int_0^1 {letter}_1^2\,ds = 1$, with the "
            rf"stiffness $\int_0^1 ({letter}_1{prime})^2\,ds =$ {sizes}:"
        )
    rows: list[Row] = []
    if count > 1 or not family.changes:
        parts = named(family.formula).replace(r",\quad", r",\qquad").split(r",\qquad")
        rows += [*(("", part.strip()) for part in parts), ("", named(family.condition))]
    if family.changes and count <= FEW:
        rows += [("", " ".join(row)) for k in range(count) for row in _polynomial(shapes, k, rf"{letter}_{{{k + 1}}}")]
    yield Display(tuple(rows))


def _polynomial(shapes: Shapes, k: int, name: str) -> Formula:
    """A shape that is a polynomial, its coefficients exact where they are roots of fractions."""
    ring = Ring(1000)
    s = ring.generator("s")
    total = ExactSum(ring, {})
    for coefficients in shapes.functions[k].terms.values():
        for power, c in enumerate(coefficients):
            total = total + ring.literal(float(c)) * (ring.of(s, power) if power else 1)
    formula = written(ring, flat(total, products=False))
    names = {s.number: Name("s", "s")}
    names |= {root.number: Name(f"sqrt({prime})", rf"\sqrt{{{prime}}}") for prime, root in ring.roots.items()}
    return broken(f"{name}(s)", FormulaWriter(names, LATEX).terms(formula))
