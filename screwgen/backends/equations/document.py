"""The equations in scalars as a document: LaTeX and HTML."""

from __future__ import annotations

from collections.abc import Sequence

from ...topology.chain import Chain
from ...version import __version__
from ..latex.content import Display, Document, DocumentSection, Heading, Item, Paragraph
from ..latex.layout import columns
from ..latex.sketch import figure
from .equations import Equations, Shown
from .letters import coordinates, parameters, sketched
from .shapes import shapes

MATRICES = {
    "M": "Inertia",
    "C": "Coriolis and centrifugal terms",
    "D": "Damping",
    "K": "Stiffness",
    "g": "Weight, and what else acts at rest",
    "tau": "Forces that hold the posture",
}
LETTERS = (
    "Bold letters are columns and matrices, all others are numbers. $M_{12}$ is the entry of $\\mathbf{M}$ in the "
    "first row and second column, $g_1$ the first entry of $\\mathbf{g}$. A name is that of the robot file, of states "
    "and of results."
)


def content(chain: Chain, equations: Equations, linear: Shown | None = None, taken: Sequence[str] = ()) -> Document:
    """The equations of a robot, and those about a posture if they are given, independent of the output format.

    ``taken``: sentences on how the posture that was stated is understood.
    """
    name = chain.robot.name
    drawn = figure(chain, sketched(chain, equations))
    robot: list[Item] = [drawn, Paragraph(LETTERS), coordinates(chain, equations), *shapes(chain)]
    if equations.stated:
        robot += [Heading("Parameters"), parameters(equations)]
    sections = [DocumentSection("The robot and its letters", robot)]
    sections.append(DocumentSection("Equations of motion", [_about(equations), *_formulas(equations)]))
    if linear is not None:
        about = [Paragraph(" ".join(taken))] if taken else []
        sections.append(DocumentSection("Small motions about rest", [*about, *_formulas(linear)]))
    return Document(name, __version__, tuple(sections), f"Equations of motion of `{name}` in scalars")


def _about(equations: Equations) -> Paragraph:
    text = "Entries that are not written are zero; so is what the robot file states as zero. "
    skew = r"$\mathbf{C}$ has Christoffel's symbols, so that $\dot{\mathbf{M}} - 2\,\mathbf{C}$ is skew-symmetric. "
    return Paragraph(f"{text}{skew * equations.has('C')}The formulas take {equations.operations} operations.")


def _formulas(shown: Shown) -> list[Item]:
    """The equation, then matrix by matrix the entries."""
    groups = shown.grouped()
    items: list[Item] = [Display(tuple(("", line) for line in shown.latex_heading))]
    if parts := groups.pop(""):
        items += [Paragraph("Common parts:"), Display(columns(parts))]
    for letter, formulas in groups.items():
        items.append(Heading(MATRICES[letter]))
        items.append(Display(columns(formulas)))
    return items
