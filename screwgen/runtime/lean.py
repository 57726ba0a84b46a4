"""The generated C without what checks it: what is compiled for this machine."""

from __future__ import annotations

from ..backends.c.columns import rendered
from ..backends.c.project import CProject


class LeanProject(CProject):
    """The library alone, without the self-check, whose reference values take as long as all the rest."""

    _recorded = ()

    def files(self) -> dict[str, str]:
        used = {file: template for file, template in self.library.items() if template != "reference.h"}
        return {file: rendered(template, **self.context) for file, template in used.items()}
