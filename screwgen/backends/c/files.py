"""The files of the generated C and the templates that they are made from."""

from collections.abc import Sequence

from .batch import FILES as BATCH
from .derivatives import FILES as DERIVATIVES
from .estimator import FILES as ESTIMATOR

LIBRARY = (
    "real.h",
    "real.c",
    "parameters.c",
    "dynamics.c",
    "links.h",
    "links.c",
    "step.c",
    "posture.c",
    "se3.h",
    "dae.c",
    "reference.h",
)
"""The files of every library; their names begin with ``<robot>_``."""

BESIDE = ("check.c", "main.c", "Makefile", "CMakeLists.txt", "README.md")
"""The files besides the library, under these names."""


def library(
    name: str, closing: Sequence[str], derivatives: bool, estimator: bool, batch: bool, reports: Sequence[str]
) -> dict[str, str]:
    """The files of a robot's library, with the template of each.

    ``closing``: the files of what closes its tree; ``reports``: those of what it reports.
    """
    options = ((derivatives, DERIVATIVES), (estimator, ESTIMATOR), (batch, BATCH))
    files = [*LIBRARY, *closing, *(file for asked, more in options if asked for file in more)]
    files += [f"{part}.{end}" for part in reports for end in "hc"]
    return {f"{name}.h": "model.h"} | {f"{name}_{file}": file for file in files}
