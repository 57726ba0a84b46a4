"""The command `paper`: the printed equations, what became of them, and the errata."""

from __future__ import annotations

import json as json_format
import sys
from collections.abc import Sequence
from pathlib import Path

from ..errors import UsageError
from .output import busy, say


def run_paper(labels: Sequence[str], errata: bool, json: bool, output: str | None, quiet: bool) -> None:
    """Print or write what was asked for: by label, all equations, or all errata."""
    from ..paper import register
    from ..simulation.runs import check_output

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
    from ..paper import register, terminal

    if not chosen:
        return terminal.errata_listing() if errata else terminal.listing(register.equations())
    show = lambda e: terminal.equation_text(e) if hasattr(e, "label") else terminal.erratum_text(e)  # noqa: E731
    return f"\n\n{'─' * terminal.WIDTH}\n\n".join(map(show, chosen))


def _json(chosen: list, errata: bool) -> str:
    from ..paper import register, terminal

    rows = chosen or (register.errata() if errata else register.equations())
    return json_format.dumps([terminal.record(e) for e in rows], ensure_ascii=not _shows_all(), indent=1)


def _shows_all() -> bool:
    """Whether stdout can show every letter."""
    return "utf" in (getattr(sys.stdout, "encoding", None) or "utf").lower()


def _write(output: str, equations: Sequence, errata: Sequence, quiet: bool) -> None:
    from ..simulation.runs import outputs, suffix

    with busy("typesetting", quiet), outputs(output) as (stream,):
        stream.write(WRITERS[suffix(output)](equations, errata))
    say(output, quiet)


def _tex(equations, errata) -> bytes:
    from ..paper import document

    return document.tex(equations, errata).encode()


def _html(equations, errata) -> bytes:
    from ..paper import document

    return document.html(equations, errata).encode()


def _pdf(equations, errata) -> bytes:
    import tempfile

    from ..backends.latex import document as latex

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "paper.pdf"
        latex.write_pdf(_tex(equations, errata).decode(), path)
        return path.read_bytes()


def _markdown(equations, errata) -> bytes:
    from ..paper import document

    if equations or not errata:
        raise UsageError("a .md file holds errata alone; name errata such as E7, or give --errata")
    return document.errata_page(errata).encode()


WRITERS = {".tex": _tex, ".pdf": _pdf, ".html": _html, ".md": _markdown}
