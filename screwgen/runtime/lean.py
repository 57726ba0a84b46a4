"""The generated C without what checks it: what is compiled for this machine."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property

from ..algorithms.robot_functions import SENSORS
from ..backends.c.forms import split
from ..backends.c.project import CProject
from ..backends.c.shim import SENSING, shims

LEFT_OUT = ("reference.h", SENSORS)
"""What begins the names of templates of which a shared library has no use at once."""


class RuntimeProject(CProject):
    """The library alone, without the self-check, whose reference values take as long as all the rest."""

    _recorded = ()

    def files(self) -> dict[str, str]:
        return self.some(lambda _: True)

    def some(self, wanted: Callable[[str], bool]) -> dict[str, str]:
        """Those of the library whose names are ``wanted``."""
        used = {file: template for file, template in self.library.items() if not template.startswith(LEFT_OUT)}
        return {file: self.text(template) for file, template in used.items() if wanted(file)}

    def part(self, name: str) -> Mapping[str, str]:
        """The files of a shared library: of the joint form, of the DAE form, or of sensors, written when asked for."""
        return self._sensing if name == "sensors" else self._forms[name == "dae"]

    @cached_property
    def _forms(self) -> tuple[dict[str, str], dict[str, str]]:
        return split(self, self.files() | shims(self))

    @cached_property
    def _sensing(self) -> dict[str, str]:
        """The library of sensors."""
        headers = {name: text for name, text in self._forms[0].items() if name.endswith(".h")}
        own = {f"{self.name}_{name}": name for name in ("sensors.h", "sensors.c", "real.c")} | {SENSING: SENSING}
        return headers | {file: self.text(template) for file, template in own.items()}
