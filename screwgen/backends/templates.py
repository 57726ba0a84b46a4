"""Rendering of the templates: with :mod:`.template_places` all that uses Jinja, which is imported when a text is made.

A template is a skeleton, loops and names and no arithmetic.  A name that a template uses and nobody
gives is an error; the rendered text is a function of template and values alone.

What a feature of some robots, such as loops, writes in many files stands in one: a template leaves a place for it.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import jinja2

PACKAGE = Path(__file__).resolve().parents[1]

BRACES: Mapping[str, Any] = {}
"""Jinja's own delimiters, ``{{ name }}`` and ``{% for ... %}``: C, HTML, text."""

ANGLES: Mapping[str, Any] = {
    "variable_start_string": "<<",
    "variable_end_string": ">>",
    "block_start_string": "<%",
    "block_end_string": "%>",
    "comment_start_string": "<#",
    "comment_end_string": "#>",
}
"""Delimiters that LaTeX does not need: ``<< name >>`` and ``<% for ... %>``."""


FEATURES = "features"
"""The value that lists the features of a robot, and the folder beside a template that has what they write."""


def folder() -> Path:
    """Where the templates are: inside an installed package, or beside it in a checkout."""
    installed = PACKAGE / "_templates"
    return installed if installed.is_dir() else PACKAGE.parent / "templates"


def render(template: str, below: Path | None = None, /, **values: object) -> str:
    """The text of ``template``, a path such as ``latex/document.tex.jinja`` below the product's templates or ``below``.

    Templates of LaTeX (``.tex``) have delimiters of their own; values that enter HTML (``.html``) are
    escaped unless they have an ``__html__`` method, as `markup` gives it.
    """
    return _environment(_kind(template), below or folder()).get_template(template).render(**values)


def markup(html: str) -> str:
    """A piece of HTML that a template takes as it is."""
    import jinja2

    return jinja2.utils.markupsafe.Markup(html)


def _kind(template: str) -> str:
    suffixes = Path(template).suffixes
    return next((kind for kind in (".tex", ".html") if kind in suffixes), "")


@cache
def _environment(kind: str, below: Path) -> jinja2.Environment:
    import jinja2

    from .template_places import TemplatePlaces

    class OwnPlaces(TemplatePlaces):
        features = FEATURES

    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(below),
        undefined=jinja2.StrictUndefined,
        autoescape=kind == ".html",
        keep_trailing_newline=True,
        trim_blocks=True,
        lstrip_blocks=True,
        extensions=(OwnPlaces,),
        **(ANGLES if kind == ".tex" else BRACES),
    )
