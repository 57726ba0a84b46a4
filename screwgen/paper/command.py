"""The command `paper`: the printed equations, what became of them, and the errata."""

from __future__ import annotations

import json as json_format
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

import typer

from ..cli.main import EPILOG
from ..cli.options import Quiet
from ..errors import UsageError
from ..progress import busy

if TYPE_CHECKING:
    from .equation import Equation
    from .erratum import Erratum


def add(app: typer.Typer) -> None:
    """Add the command."""
    app.command(short_help="Show the paper's equations, checked.", epilog=EPILOG)(paper)


def paper(
    context: typer.Context,
    label: Annotated[
        list[str] | None, typer.Argument(metavar="[LABEL]...", help="Equations (29, B1, phi_y) or errata (E7).")
    ] = None,
    errata: Annotated[bool, typer.Option("--errata", help="The errata, not the equations.")] = False,
    json: Annotated[bool, typer.Option("--json", help="Print as JSON, formulas in LaTeX.")] = False,
    output: Annotated[
        str | None,
        typer.Option("-o", "--output", metavar="FILE", help="Write paper.tex, .pdf, .html; errata also .md."),
    ] = None,
    quiet: Quiet = False,
) -> None:
    """Show the paper's printed equations: what holds, what fails, and what holds instead, judged by numbers.

    Without a label: the list. With labels: equations printed, derived, their difference; errata with their figures.
    """
    run_paper(label or (), errata, json, output, quiet or context.obj)


def run_paper(labels: Sequence[str], errata: bool, json: bool, output: str | None, quiet: bool) -> None:
    """Print or write what was asked for: by label, all equations, or all errata."""
    from ..simulation.runs import check_output
    from . import register

    if labels and errata:
        raise UsageError("--errata means all errata; leave it out, or the labels")
    if json and output:
        raise UsageError("--json prints; leave out --json or -o")
    chosen = [register.erratum(x) if register.is_erratum(x) else register.equation(x) for x in labels]
    if output is None:
        print(_json(chosen, errata) if json else _text(chosen, errata))
        return
    check_output(output, WRITERS)
    equations = [e for e in chosen if hasattr(e, "label")] if chosen else ([] if errata else register.equations())
    faults = [e for e in chosen if hasattr(e, "number")] if chosen else register.errata()
    _write(output, equations, faults, quiet)


def _text(chosen: list, errata: bool) -> str:
    from . import register, terminal

    if not chosen:
        return terminal.errata_listing() if errata else terminal.listing(register.equations())
    show = lambda e: terminal.equation_text(e) if hasattr(e, "label") else terminal.erratum_text(e)  # noqa: E731
    return f"\n\n{'─' * terminal.WIDTH}\n\n".join(map(show, chosen))


def _json(chosen: list, errata: bool) -> str:
    from . import register, terminal

    rows = chosen or (register.errata() if errata else register.equations())
    return json_format.dumps([terminal.record(e) for e in rows], ensure_ascii=not _shows_all(), indent=1)


def _shows_all() -> bool:
    """Whether stdout can show every letter."""
    return "utf" in (getattr(sys.stdout, "encoding", None) or "utf").lower()


def _write(output: str, equations: Sequence, errata: Sequence, quiet: bool) -> None:
    from ..backends.latex.engine import engine
    from ..cli.output import say
    from ..simulation.runs import outputs, suffix

    if suffix(output) == ".pdf":
        engine()
    with busy("typesetting", quiet), outputs(output) as (stream,):
        stream.write(WRITERS[suffix(output)](equations, errata))
    say(output, quiet)


def _tex(equations: Sequence[Equation], errata: Sequence[Erratum]) -> bytes:
    from . import document

    return document.tex(equations, errata).encode()


def _html(equations: Sequence[Equation], errata: Sequence[Erratum]) -> bytes:
    from . import document

    return document.html(equations, errata).encode()


def _pdf(equations: Sequence[Equation], errata: Sequence[Erratum]) -> bytes:
    from ..backends.latex.engine import pdf

    return pdf(_tex(equations, errata).decode())


def _markdown(equations: Sequence[Equation], errata: Sequence[Erratum]) -> bytes:
    from . import document

    if equations or not errata:
        raise UsageError("a .md file holds errata alone; name errata such as E7, or give --errata")
    return document.errata_page(errata).encode()


WRITERS = {".tex": _tex, ".pdf": _pdf, ".html": _html, ".md": _markdown}
