"""The work of the command `latex`: equations by links, or entry by entry in scalars, in the format of the suffix."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ..backends.equations import document as scalars
from ..backends.latex import document as latex
from ..backends.latex.content import Document
from ..backends.latex.engine import engine, pdf
from ..backends.latex.notation import notation as named
from ..backends.latex.style import DocumentStyle, style
from ..errors import UsageError
from ..model import derive
from ..plugins import plugins
from ..progress import busy
from ..simulation.runs import check_output, outputs, suffix
from ..simulation.state import read_state
from ..spec.parameters import turning
from ..spec.robot import Robot
from .output import load_robot, notes, say
from .posture import posture
from .stated_numbers import numbers

FORMATS: dict[str, Callable[[Document, DocumentStyle, Robot | None, Sequence[float] | None], bytes]] = {
    ".tex": lambda shown, around, *_: latex.tex(shown, around).encode(),
    ".pdf": lambda shown, around, *_: pdf(latex.tex(shown, around)),
    ".html": lambda shown, _, robot, q: latex.page(
        shown, latex.extras(latex.chain_of(robot), q) if robot else None
    ).encode(),
}
"""How a document is written, with the robot whose steps it shows and the posture for its numbers."""


def run_latex(
    robot: str,
    output: str,
    scalar: bool,
    about: str | None,
    documentclass: str | None,
    fragment: bool,
    notation: str | None,
    at: str | None,
    whole: bool,
    quiet: bool,
) -> None:
    """Write the equations in the format of the suffix."""
    check_output(output, FORMATS)
    kind = suffix(output)
    if about is not None and not scalar:
        raise UsageError("--about: only equations in scalars are linearised; give --scalar too")
    if notation is not None and scalar:
        raise UsageError("--notation: equations in scalars have letters of their own; leave out one of the two options")
    if kind == ".html" and documentclass is not None:
        raise UsageError("--documentclass: a page for the browser has no class; leave it out, or write .tex or .pdf")
    if at is not None and (scalar or kind != ".html"):
        raise UsageError(
            "--at: only a page for the browser has the mass matrix in numbers; write .html without --scalar"
        )
    if whole and (scalar or kind == ".html"):
        raise UsageError("--all: equations in scalars and pages for the browser are whole; leave it out")
    if fragment and kind != ".tex":
        raise UsageError(f"--fragment: is LaTeX for \\input, not {kind}; write .tex")
    around, letters = style(documentclass, fragment, whole), None if notation is None else named(notation)
    if kind == ".pdf":
        engine()
    loaded = load_robot(robot, quiet)
    q = None if at is None else read_state(at, derive(loaded)).q.tolist()
    with busy("typesetting", quiet), outputs(output) as (stream,):
        shown = _scalars(loaded, about, quiet) if scalar else latex.content(loaded, plugins(), letters)
        stream.write(FORMATS[kind](shown, around, None if scalar else loaded, q))
    say(output, quiet)


def _scalars(robot: Robot, about: str | None, quiet: bool) -> Document:
    """The equations entry by entry, and about a posture if one is given."""
    model = derive(robot)
    found = model.equations()
    if about is None:
        return scalars.content(model.chain, found)
    at = posture("--about", about, turning(robot))
    notes("--about", at.taken, quiet)
    q = numbers("q", " ".join(map(repr, at.q)), model.n_joints, "joint coordinates", "about")
    return scalars.content(model.chain, found, found.linearised(q, at.rounding), at.taken)
