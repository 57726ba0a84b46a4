"""Tables for notebooks: in HTML, and where cells have formulas in Markdown, whose formulas every notebook sets."""

import re
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from importlib import import_module
from typing import Any

MARKS = re.compile(r"[\\`*_|$\[\]]")
"""The signs of Markdown."""


def number(value: float) -> str:
    """Five digits; rounding errors beside 1 as 0."""
    return f"{value:.5g}" if abs(value) > 1e-14 else "0"


def table(caption: str, head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """An HTML table; numbers to five digits, all else as text."""
    titles = "".join(f"<th>{escape(x)}</th>" for x in head)
    lines = ("".join(f"<td>{escape(_shown(x))}</td>" for x in row) for row in rows)
    body = "".join(f"<tr>{line}</tr>" for line in lines)
    return f"<table><caption>{escape(caption)}</caption><thead><tr>{titles}</tr></thead><tbody>{body}</tbody></table>"


def markdown_table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A Markdown table; cells are Markdown, such as `formula` and `plain` make it."""
    lines = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def formula(tex: str) -> str:
    """A formula in a line or a cell of Markdown; bars would end the cell."""
    return r"$\displaystyle " + tex.replace("|", r"\vert ") + "$"


def plain(text: str) -> str:
    """Text in Markdown, none of whose signs mean anything there."""
    return MARKS.sub(r"\\\g<0>", text).replace("<", "&lt;")


def code(text: str) -> str:
    """A name or a unit in Markdown; nothing for ``-``, by which signals say that they have none."""
    return f"`{text}`" if text not in ("", "-") else ""


def steps_table(steps: Iterable[Sequence[str]]) -> str:
    """Steps of a derivation: name, LaTeX, unit, frame, meaning, number in the paper."""
    rows = (
        (code(name), formula(tex), code(unit), code(frame), plain(meaning), number and f"({plain(number)})")
        for name, tex, unit, frame, meaning, number in steps
    )
    return markdown_table(("step", "formula", "unit", "frame", "meaning", "paper"), rows)


def program_text(title: str, inputs: Mapping[str, int], outputs: Mapping[str, int], work: Mapping[str, int]) -> str:
    """A program: the entries of its inputs and results, and the operations of every part of it."""
    sides = [", ".join(f"`{name}` ({n})" for name, n in side.items()) or "none" for side in (inputs, outputs)]
    rows = [(plain(part) or "–", str(n)) for part, n in work.items()]
    about = f"**{plain(title.strip('<>'))}**: {sides[0]} → {sides[1]}"
    return f"{about}\n\n{markdown_table(('part', 'operations'), rows)}"


def player(run: Any) -> str:
    """The viewer's page of a run that knows its robot, in a frame; made by the layer above, when it is asked for."""
    return "" if run.robot is None else import_module("screwgen").view(run, labels=[run.name])._repr_html_()


def _shown(x: Any) -> str:
    return x if isinstance(x, str) else number(float(x))
