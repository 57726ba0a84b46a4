"""The section of one link class: its kinematic field, its mode shapes, and its blocks."""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from ...algebra.notation import axis_latex
from ...bodies.collocation import collocation
from ...bodies.varying_fields import weights
from ...ir.block import Binding, Block
from ...reduction.invariants import Invariants
from ...spec.link_class import AXIS, EXACT, LinkClass
from ..templates import render
from .all_digits import constants, exact_shapes, has_formulas
from .content import Display, DocumentSection, DocumentTable, Heading, Item, Paragraph, StepEquation, equation, parse
from .layout import PAGE, Formula, fill, matrix, width
from .layout import equation as broken
from .steps import BlockView
from .tables import DIRECTION, decimal, modes, named_axes, stations

FIELD = "Kinematic field"
ORDER = (
    *("section", "element", "section_spin", "section_load"),
    *("link", "turning_link", "tip", "tip_body", "tip_pose", "joint", "posture"),
    *("energy", "link_rows", "joint_rows"),
)
"""The order of the blocks that are known; others follow."""

DISPLACEMENT: dict[int | str, str] = {
    1: r"The elastic displacement is $\mathbf{r}_{\xi} = \boldsymbol{\phi}_i(\xi)\,\boldsymbol{\eta}_i$ (72),",
    2: r"To first order the elastic displacement is $\boldsymbol{\phi}_i(\xi)\,\boldsymbol{\eta}_i$ (72),",
    EXACT: r"The strains are those of a small displacement $\boldsymbol{\phi}_i(\xi)\,\boldsymbol{\eta}_i$ (72),",
}
"""What the modes displace, by the order of the link."""

OTHERS = "Not needed for the algorithm: energies, poses, the rows of the stacked system, limits of the model."
"""What the further forms of the equations are."""


def pointwise(key: LinkClass) -> bool:
    """Whether steps are evaluated at points along a link, so that they are read in their order."""
    return key.order == EXACT or bool(key.tendons)


def said_of_field(key: LinkClass) -> Iterator[tuple[str, str]]:
    """The symbols that the formulas on the kinematic field define, each with what these say."""
    for item in _field(key):
        for row in item.formula if isinstance(item, Display) else ():
            for left, right in zip(row[::2], row[1::2], strict=False):
                if right.strip().startswith("="):
                    yield re.sub(r"^\\q*quad\s*", "", left.strip()), right


def prose_of_field(key: LinkClass) -> str:
    """The sentences on the kinematic field."""
    return " ".join(item.text for item in _field(key) if isinstance(item, Paragraph))


def ordered(blocks: Mapping[str, Block]) -> list[str]:
    """The names of the blocks in the order in which a reader wants them."""
    return sorted(blocks, key=lambda name: ORDER.index(name) if name in ORDER else len(ORDER))


Part = tuple[str, tuple[Item, ...]]
"""A heading with its content."""


@dataclass
class PrintedClasses:
    """What the sections of earlier classes print, with the number of the class: parts, and steps by their headings."""

    parts: dict[Part, int] = field(default_factory=dict)
    steps: dict[Hashable, int] = field(default_factory=dict)


def class_section(
    number: int,
    key: LinkClass,
    members: Sequence[str],
    views: Sequence[BlockView],
    printed: PrintedClasses,
    shown: dict[Item, str],
    appendix: bool = False,
) -> DocumentSection:
    """The section of a class; parts and steps that an earlier class has ``printed`` are only named.

    So are steps that are ``shown`` under an earlier heading of the class.
    ``appendix``: of further forms of the equations, without the kinematic field.
    """
    names = ", ".join(f"`{name}`" for name in members)
    items: list[Item] = [Paragraph(f"Links of this class: {names}.", essential=True)]
    if appendix:
        items = [Paragraph(f"{OTHERS} Links of this class: {names}.")]
    parts = list(_parts(key, views, appendix))
    for earlier in sorted({printed.parts[part] for part in parts if part in printed.parts}):
        titles = [part[0] for part in parts if printed.parts.get(part) == earlier]
        items.append(Paragraph(f"As for class {earlier}: {', '.join(titles).lower()}."))
    for title, below in parts:
        if (title, below) not in printed.parts:
            printed.parts[title, below] = number
            own = _once(title, below, shown)
            items += [Heading(title), *(own if pointwise(key) else _others(title, own, number, printed.steps))]
    return DocumentSection(f"Link class {number}{', other forms' * appendix}", items, number, appendix)


def _once(title: str, below: Sequence[Item], shown: dict[Item, str]) -> Iterator[Item]:
    """What is below a title; steps that are ``shown`` below an earlier title, by which they go, are only named."""
    repeated = [item for item in below if isinstance(item, StepEquation) and item in shown]
    for earlier in dict.fromkeys(shown[item] for item in repeated):
        symbols = ", ".join(f"${item.step.formula[0][0]}$" for item in repeated if shown[item] == earlier)
        yield Paragraph(f"As under “{earlier}”: {symbols}.")
    for item in below:
        if item not in repeated:
            shown[item] = title
            yield item


def _others(title: str, below: Iterable[Item], number: int, printed: dict[Hashable, int]) -> Iterator[Item]:
    """What is below a title; steps that an earlier class prints below the same title are only named."""
    items = list(below)
    steps = {item: (title, item, *_size(item)) for item in items if isinstance(item, StepEquation)}
    known = {item: printed[step] for item, step in steps.items() if step in printed}
    for earlier in sorted(set(known.values())):
        symbols = ", ".join(f"${item.step.formula[0][0]}$" for item, own in known.items() if own == earlier)
        yield Paragraph(f"As under “{title}” of class {earlier}: {symbols}.")
    yield from (item for item in items if item not in known)
    for step in steps.values():
        printed.setdefault(step, number)


def _size(item: StepEquation) -> tuple[Hashable, ...]:
    """What tells steps apart that print alike: of how many entries they and what they are made of are."""
    definition = item.step.definition
    return definition.signal.shape, *definition.entries.ravel()


def _parts(key: LinkClass, views: Sequence[BlockView], appendix: bool) -> Iterator[Part]:
    """The field, then every block; constants come first in the link block."""
    if not appendix:
        yield FIELD, tuple(map(_essential, _field(key)))
    axes = tuple((name, f"= {axis_latex(axis)}") for axis, name in named_axes(key))
    for view in views:
        groups = [(view.title, view.steps)]
        if view.name == "link":
            known = tuple(s for s in view.steps if s.binding <= Binding.PARAMETER)
            groups = [(f"{view.title}: constants", known), (view.title, tuple(s for s in view.steps if s not in known))]
        for title, steps in groups:
            named: list[Item] = [Paragraph("Axes:"), Display(axes)] if axes and view.name == "joint" else []
            if steps or view.zeros or view.identities:
                yield title, (*_plain(view), *named, *map(equation, steps))
    digits = [row for view in views for step in view.steps for row in step.digits]
    digits += exact_shapes(key)
    if digits and not appendix:
        yield "Constants with all digits", tuple(constants(digits))


def _essential(item: Item) -> Item:
    return replace(item, essential=True) if isinstance(item, Paragraph | Display | DocumentTable) else item


def _plain(view: BlockView) -> Iterator[Item]:
    """What is zero or identity at a section, and is not at the tip."""
    for symbols, what in ((view.zeros, "Zero"), (view.identities, "The identity")):
        if symbols:
            where = "at this section" if view.title.startswith("Section") else "here"
            yield Paragraph(f"{what} {where}: {', '.join(f'${symbol}$' for symbol in symbols)}.")


# ------------------------------------------------------------------------------------ kinematic field


def _stations(key: LinkClass) -> Iterator[Item]:
    """How the properties of a section vary."""
    if key.stations:
        places = ", ".join(f"{place:.6g}" for place in key.stations)
        between = "linearly" if key.between == "linear" else "by the polynomial through all values"
        yield Paragraph(
            rf"The section varies: its properties, such as $\rho_i A_i(\xi)$, are stated at stations, $s = {places}$, "
            f"and interpolated {between}; an index is the number of the station."
        )


def _segments(key: LinkClass) -> Iterator[Item]:
    if key.segments > 1:
        yield Paragraph(
            rf"The link of length $l_{{0,i}}$ is {key.segments} equal segments of length "
            rf"$l_i = l_{{0,i}}/{key.segments}$, each welded to the tip section of the one before it. These are the "
            r"equations of one of them: a link of its own, with $s$ along the segment."
        )


def _carries(key: LinkClass) -> Iterator[Item]:
    """The sections besides the tip at which links are carried."""
    if key.stations_at:
        places = ", ".join(f"{s:.6g}" for s in key.stations_at)
        shapes = f", with the shapes there{', integrals of the second order from the base to there' * (key.order == 2)}"
        yield Paragraph(
            rf"The link carries others at $s = {places}$ too. What is said of the tip section holds of each of these "
            rf"sections, with the place $s\,l_i$ in place of $l_i${shapes * bool(key.modes)}; in the equations of "
            r"the link and of its modes $\boldsymbol{\Lambda}$ and $\mathbf{p}$ of all sections are summed, each moved "
            r"by the $\mathbf{J}_T$ of its own. Bodies and external wrenches are those of the tip."
        )
        if key.modes:
            yield stations(key)


def _field(key: LinkClass) -> Iterator[Item]:
    yield from _segments(key)
    yield from _stations(key)
    yield from _carries(key)
    if not key.modes:
        yield Paragraph(r"The link is rigid: $\mathbf{r}_{ib} = \mathbf{r}_b = [\xi,\ 0,\ 0]^{\top}$.")
        return
    if key.elastic is not None:
        yield from _from_file(key.elastic)
        return
    yield Paragraph(
        DISPLACEMENT.get(key.order, DISPLACEMENT[1])
        + r" with shapes $\varphi_k(\xi) = \psi(s)$ along the axes of $\mathcal{F}_i$:"
    )
    yield Display(broken(r"\boldsymbol{\phi}_i", [_shape_matrix(key)]))
    sheared = len(key.counts) > 4
    stretched = sheared or key.counts[0] > 0
    if sheared or key.rotary:
        yield from parse(render("latex/timoshenko.tex.jinja", shear=sheared, rotary=key.rotary))
    if key.order == 2:
        yield from parse(render("latex/second_order.tex.jinja", shear=sheared))
    if key.order == EXACT:
        yield from _exact(key, sheared, stretched)
    if key.tendons:
        count, straight = len(collocation(key).places), key.order == 1
        kinks = ", ".join(f"{s:.6g}" for s in _within(key, key.rest_at))
        given: dict[str, int | str] = {"points": count, "straight": straight, "stretched": stretched or straight}
        given |= {"rest": bool(key.rest), "kinks": kinks}
        yield from parse(render("latex/tendon.tex.jinja", segments=key.segments > 1, **given))
    alike: dict[tuple, list[str]] = {}
    for direction in dict.fromkeys(d for d, _ in key.directions):
        shapes = key.shapes(direction)
        alike.setdefault((shapes.family.name, shapes.family.changes and shapes.count), []).append(direction)
    for directions in alike.values():
        yield from _family(key, directions)
    printed = all(has_formulas(key.shapes(directions[0])) for directions in alike.values())
    yield from (replace(item, repeats=printed and not pointwise(key)) for item in _constants(key, sheared))


def _constants(key: LinkClass, sheared: bool) -> Iterator[Paragraph | DocumentTable]:
    """The constants of the shapes; shapes whose coefficients are printed do not need them."""
    yield Paragraph(
        f"Constants of the shapes; $p$ is 1 for axial{', shear' * sheared} and torsion shapes and 2 for bending, "
        r"so that the last but two "
        r"is the dimensionless stiffness:"
    )
    yield modes(key)


def _exact(key: LinkClass, sheared: bool, stretched: bool) -> Iterator[Item]:
    """The recursion along a rod whose kinematics are kept whole."""
    rod = collocation(key)
    ends = weights(key).ends() if key.stations else []
    given = {
        "points": len(rod.places),
        "stations": key.stations,
        "masses": len(rod.masses) // len(ends) if rod.masses else 0,
        "pieces": ", ".join(f"{s:.6g}" for s in dict.fromkeys(x for pair in ends for x in pair)),
        "turned": bool(key.turned),
        "offset": key.frame_at,
        "stretched": stretched,
        "rest": key.rest,
        "rest_at": ", ".join(f"{s:.6g}" for s in key.rest_at),
        "start": r"\mathbf{a}_r" if key.frame_at else r"\mathbf{a}_0",
    }
    yield from parse(render("latex/exact_rod.tex.jinja", shear=sheared, **given))


def _within(key: LinkClass, places: Sequence[float]) -> list[float]:
    """Which places along a link are within its segment, along this."""
    own = (s * key.segments - key.segment for s in dict.fromkeys(places))
    return [s for s in own if 0.0 < s < 1.0]


def _from_file(body: Invariants) -> Iterator[Item]:
    """What the symbols of a body given by numbers mean."""
    modes = ", ".join(f"{k}: {name}" for k, name in enumerate(body.names, 1) if name)
    yield Paragraph(
        r"The body is given by numbers, standard input data: $\mathbf{C}_t$, $\mathbf{M}_e$, $\mathbf{K}_e$ and "
        r"$\mathbf{D}_e$ are matrices of the file. $\mathbf{r}_b$ is an element's place, the columns of "
        r"$\boldsymbol{\phi}$ its displacements by the modes, and integrals with $\rho_iA_i\,d\xi$ are those over the "
        rf"mass, {decimal(body.mass)} kg; those of products of two fields are numbers. Modes: {modes or 'no names'}."
    )
    if body.geometric:
        yield Paragraph(
            r"The displacement has a part of second order, $\tfrac{1}{2}\,\boldsymbol{\eta}_i^{\top}\,\mathbf{H}_c\,"
            r"\boldsymbol{\eta}_i$ along the axes $c$; it meets the undeformed body only: the geometric stiffness."
        )


def _family(key: LinkClass, directions: list[str]) -> Iterator[Item]:
    shapes = key.shapes(directions[0])
    family, own = shapes.family, [n for n, (direction, _) in enumerate(key.directions, 1) if direction in directions]
    sought = ", ".join(f"shape of mode {n}" for n in own)
    which, about = " and ".join(DIRECTION[d] for d in directions).capitalize(), f" {family.about}" * bool(family.about)
    yield Paragraph(f"{which}: {family.title}{about},")
    formula = family.formula.replace(r",\quad", r",\qquad", 1)
    parts = [*formula.split(r",\qquad"), family.condition]
    printed = has_formulas(shapes)
    yield Display(_side_by_side([part.strip() for part in parts]), sought="" if printed else sought)
    if printed:
        yield Paragraph("which are here")
        rows = (row for k, text in enumerate(shapes.formulas) for row in _polynomial(k, text))
        yield Display(tuple(rows), sought=sought)


def _side_by_side(formulas: list[str]) -> Formula:
    """Short formulas share a line."""
    lines = fill([f if f is formulas[-1] else rf"{f},\qquad" for f in formulas], PAGE)
    return tuple(("", line.removesuffix(r"\qquad")) for line in lines)


def _polynomial(k: int, text: str) -> Formula:
    terms = text.replace(" - ", " + - ").split(" + ")
    signed = [terms[0]] + [t if t.startswith("- ") else f"+ {t}" for t in terms[1:]]
    return broken(rf"\psi_{{{k + 1}}}(s)", signed)


def _shape_matrix(key: LinkClass) -> str:
    """``phi``: a column per mode, those of a direction abridged if there are many."""
    columns: list[list[str]] = []
    for direction in dict.fromkeys(d for d, _ in key.directions):
        numbers = [k + 1 for k, (d, _) in enumerate(key.directions) if d == direction]
        shown = numbers if len(numbers) <= 3 else [numbers[0], 0, numbers[-1]]
        columns += [_column(AXIS.get(direction), k) for k in shown]
    text = matrix([[column[i] for column in columns] for i in range(3)])
    assert width(text) <= PAGE
    return text


def _column(row: int | None, k: int) -> list[str]:
    entry = rf"\varphi_{{{k}}}" if k else r"\cdots"
    return [entry if i == row else (r"\cdots" if k == 0 else "0") for i in range(3)]
