"""What is around the formulas of a LaTeX document: its class, or nothing in a fragment."""

from __future__ import annotations

import re
from dataclasses import dataclass

from ...errors import UsageError, one_line

CLASS = re.compile(r"(?P<name>[A-Za-z][A-Za-z0-9-]*)(?:\[(?P<options>[A-Za-z0-9=.,\- ]*)\])?")
MARGINS = {"11pt": "17mm", "12pt": "10mm"}
"""A line of formulas is 42 em wide: of larger letters the margins are smaller."""
ELEVEN = ("scrartcl", "scrreprt", "scrbook", "scrlttr2")
"""Classes whose letters are of 11 pt unless an option says otherwise."""
SIZE = re.compile(r"(?:fontsize=)?(\d+pt)")


@dataclass(frozen=True)
class DocumentStyle:
    """A LaTeX file: a document of a class, by default article, or a fragment for ``\\input``."""

    documentclass: str = ""
    options: str = ""
    fragment: bool = False
    whole: bool = False
    """Whether the derivation and further forms of the equations follow those that the algorithm needs."""

    @property
    def margin(self) -> str:
        """The margins of the page."""
        options = (SIZE.fullmatch(option.strip()) for option in self.options.split(","))
        stated = [match[1] for match in options if match]
        own = "11pt" if self.documentclass in ELEVEN else "10pt"
        return MARGINS.get(stated[-1] if stated else own, "22mm")


def style(documentclass: str | None, fragment: bool, whole: bool = False) -> DocumentStyle:
    """The style that options state, ``NAME[options]``; raises UsageError for what is none."""
    if documentclass is None:
        return DocumentStyle(fragment=fragment, whole=whole)
    if fragment:
        raise UsageError("--documentclass: a fragment has no class of its own; leave out one of the two options")
    match = CLASS.fullmatch(documentclass)
    if match is None:
        raise UsageError(
            f"--documentclass: '{one_line(documentclass)}' is no class; write NAME or 'NAME[option,option]'"
        )
    return DocumentStyle(match["name"], match["options"] or "", whole=whole)
