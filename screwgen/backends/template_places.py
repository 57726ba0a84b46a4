"""The tags of templates that name a place where features of a robot write: an extension of Jinja."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path

import jinja2
import jinja2.ext
from jinja2 import nodes
from jinja2.parser import Parser
from jinja2.runtime import Context, Macro


class TemplatePlaces(jinja2.ext.Extension):
    """Tags of places where the features of a robot write; the template that has a place names none of them.

    ``{% added sizes %}`` is what every feature adds there.  ``{% replaced start %}…{% endreplaced %}`` is what a
    feature writes in place of the text between, which stays where none does and which the feature has as ``caller()``.
    What a feature writes is the macro of the place's name in ``features/<feature>.jinja`` beside the template; it may
    have places itself.
    """

    tags = {"added", "replaced"}  # noqa: RUF012 - Jinja's own name and type
    features: str
    """The value that lists the features of a robot, and the folder beside a template that has what they write."""

    def parse(self, parser: Parser) -> nodes.Node:
        """The call that finds what stands at a place."""
        tag = next(parser.stream)
        place = nodes.Const(parser.stream.expect("name").value)
        body = parser.parse_statements(("name:endreplaced",), drop_needle=True) if tag.value == "replaced" else []
        call = self.call_method("_written", [place, nodes.DerivedContextReference()])
        return nodes.CallBlock(call, [], [], body, lineno=tag.lineno)

    def _written(self, place: str, context: Context, caller: Macro) -> str:
        values, folder = context.get_all(), Path(str(context.name)).parent
        beside = folder if folder.name == self.features else folder / self.features
        names = [f"{beside}/{feature}.jinja" for feature in values[self.features]]
        modules = [file.make_module(values, shared=True) for file in self._stored(names)]
        macros = [getattr(module, place) for module in modules if hasattr(module, place)]
        return "".join(macro(caller=caller) if macro.caller else macro() for macro in macros) if macros else caller()

    def _stored(self, names: Sequence[str]) -> Iterator[jinja2.Template]:
        """Those of these files that there are: a feature need not write in every folder."""
        for name in names:
            with suppress(jinja2.TemplateNotFound):
                yield self.environment.get_template(name)
