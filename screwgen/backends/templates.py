"""Rendering of the templates; the only module that uses Jinja.

A template is a skeleton, loops and names and no arithmetic.  A name that a template uses and nobody
gives is an error; the rendered text is a function of template and values alone.

What a feature of some robots, such as loops, writes in many files stands in one: a template leaves a place for it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import jinja2
import jinja2.ext
from jinja2 import nodes
from jinja2.parser import Parser
from jinja2.runtime import Context, Macro

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


class TemplatePlaces(jinja2.ext.Extension):
    """Tags of places where the features of a robot write; the template that has a place names none of them.

    ``{% added sizes %}`` is what every feature adds there.  ``{% replaced start %}…{% endreplaced %}`` is what a
    feature writes in place of the text between, which stays where none does and which the feature has as ``caller()``.
    What a feature writes is the macro of the place's name in ``features/<feature>.jinja`` beside the template; it may
    have places itself.
    """

    tags = {"added", "replaced"}  # noqa: RUF012 - Jinja's own name and type

    def parse(self, parser: Parser) -> nodes.Node:
        """The call that finds what stands at a place."""
        tag = next(parser.stream)
        place = nodes.Const(parser.stream.expect("name").value)
        body = parser.parse_statements(("name:endreplaced",), drop_needle=True) if tag.value == "replaced" else []
        call = self.call_method("_written", [place, nodes.DerivedContextReference()])
        return nodes.CallBlock(call, [], [], body, lineno=tag.lineno)

    def _written(self, place: str, context: Context, caller: Macro) -> str:
        values, folder = context.get_all(), Path(str(context.name)).parent
        beside = folder if folder.name == FEATURES else folder / FEATURES
        names = [f"{beside}/{feature}.jinja" for feature in values[FEATURES]]
        modules = [file.make_module(values, shared=True) for file in self._stored(names)]
        macros = [getattr(module, place) for module in modules if hasattr(module, place)]
        return "".join(macro(caller=caller) if macro.caller else macro() for macro in macros) if macros else caller()

    def _stored(self, names: Sequence[str]) -> Iterator[jinja2.Template]:
        """Those of these files that there are: a feature need not write in every folder."""
        for name in names:
            with suppress(jinja2.TemplateNotFound):
                yield self.environment.get_template(name)


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
    return jinja2.utils.markupsafe.Markup(html)


def _kind(template: str) -> str:
    suffixes = Path(template).suffixes
    return next((kind for kind in (".tex", ".html") if kind in suffixes), "")


@cache
def _environment(kind: str, below: Path) -> jinja2.Environment:
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(below),
        undefined=jinja2.StrictUndefined,
        autoescape=kind == ".html",
        keep_trailing_newline=True,
        trim_blocks=True,
        lstrip_blocks=True,
        extensions=(TemplatePlaces,),
        **(ANGLES if kind == ".tex" else BRACES),
    )
