"""The generated C without what checks it: what is compiled for this machine."""

from __future__ import annotations

from ..algorithms.robot_functions import SENSORS
from ..backends.c.project import CProject
from ..backends.c.shim import SENSING

LEFT_OUT = ("reference.h", SENSORS)
"""What begins the names of templates of which a shared library has no use at once."""


class RuntimeProject(CProject):
    """The library alone, without the self-check, whose reference values take as long as all the rest."""

    _recorded = ()

    def files(self) -> dict[str, str]:
        used = {file: template for file, template in self.library.items() if not template.startswith(LEFT_OUT)}
        return {file: self.text(template) for file, template in used.items()}

    def sensing(self) -> dict[str, str]:
        """What the library of sensors, which is compiled when it is asked for, is made of besides other headers."""
        own = {f"{self.name}_{name}": name for name in ("sensors.h", "sensors.c", "real.c")} | {SENSING: SENSING}
        return {file: self.text(template) for file, template in own.items()}
