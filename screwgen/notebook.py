"""HTML tables for notebooks."""

from collections.abc import Iterable, Sequence
from html import escape
from importlib import import_module
from typing import Any


def number(value: float) -> str:
    """Five digits; rounding errors beside 1 as 0."""
    return f"{value:.5g}" if abs(value) > 1e-14 else "0"


def table(caption: str, head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """An HTML table; numbers to five digits, all else as text."""
    titles = "".join(f"<th>{escape(x)}</th>" for x in head)
    lines = ("".join(f"<td>{escape(_shown(x))}</td>" for x in row) for row in rows)
    body = "".join(f"<tr>{line}</tr>" for line in lines)
    return f"<table><caption>{escape(caption)}</caption><thead><tr>{titles}</tr></thead><tbody>{body}</tbody></table>"


def player(run: Any) -> str:
    """The viewer's page of a run that knows its robot, in a frame; made by the layer above, when it is asked for."""
    return "" if run.robot is None else import_module("screwgen").view(run, labels=[run.name])._repr_html_()


def _shown(x: Any) -> str:
    return x if isinstance(x, str) else number(float(x))
