"""The equations in scalars as a document: LaTeX and HTML."""

from __future__ import annotations

from ...spec.parameters import coordinate_names, coordinate_units
from ...topology.chain import Chain
from ...version import __version__
from ..latex.content import SYMBOLS, Display, Document, DocumentSection, DocumentTable, Heading, Item, Paragraph
from ..latex.layout import columns
from ..latex.tables import decimal
from .equations import Equations, Shown

MATRICES = {
    "M": "Inertia",
    "C": "Coriolis and centrifugal terms",
    "D": "Damping",
    "K": "Stiffness",
    "g": "Weight, and what else acts at rest",
    "tau": "Forces that hold the posture",
}


def content(chain: Chain, equations: Equations, linear: Shown | None = None) -> Document:
    """The equations of a robot, and those about a posture if they are given, independent of the output format."""
    name = chain.robot.name
    sections = [DocumentSection("Equations of motion", [_about(equations), *_formulas(equations)])]
    if linear is not None:
        sections.append(DocumentSection("Small motions about rest", _formulas(linear)))
    sections.append(DocumentSection(SYMBOLS, [_coordinates(chain, equations), _parameters(equations)]))
    return Document(name, __version__, tuple(sections), f"Equations of motion of `{name}` in scalars")


def _about(equations: Equations) -> Paragraph:
    text = "Entries that are not written are zero; so is what the robot file states as zero. "
    skew = r"$C$ has Christoffel's symbols, so that $\dot{M} - 2\,C$ is skew-symmetric. "
    return Paragraph(f"{text}{skew}The formulas take {equations.operations} operations.")


def _formulas(shown: Shown) -> list[Item]:
    """The equation, then matrix by matrix the entries."""
    groups = shown.grouped()
    items: list[Item] = [Display(formula) for formula in groups.pop("")]
    for letter, formulas in groups.items():
        items.append(Heading(MATRICES[letter]))
        items.append(Display(columns(formulas)))
    return items


def _coordinates(chain: Chain, equations: Equations) -> DocumentTable:
    known = zip(equations.coordinates, coordinate_names(chain.robot).q, coordinate_units(chain.robot), strict=True)
    rows = [(f"${name.latex}$", f"`{own}`", unit) for name, own, unit in known]
    rows += [(f"${name.latex}$", meaning, "") for name, meaning in equations.meanings]
    return DocumentTable(("coordinate", "name", "unit"), (0.2, 0.6, 0.2), tuple(rows))


def _parameters(equations: Equations) -> DocumentTable:
    rows = [
        (f"${name.latex}$", f"`{p.name}`", p.description, p.unit, decimal(value)) for name, value, p in equations.stated
    ]
    return DocumentTable(("parameter", "name", "meaning", "unit", "value"), (0.12, 0.31, 0.33, 0.12, 0.12), tuple(rows))
