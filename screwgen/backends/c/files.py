"""The files of the generated C and the templates that they are made from."""

from collections.abc import Sequence

from .batch import FILES as BATCH
from .by_p import FILES as BY_P
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


OPTIONS = DERIVATIVES, ESTIMATOR, BATCH, BY_P
"""The files that options add."""


def library(name: str, closing: Sequence[str], asked: Sequence[bool], reports: Sequence[str]) -> dict[str, str]:
    """The files of a robot's library, with the template of each.

    ``closing``: the files of what closes its tree; ``asked``: whether each of ``OPTIONS`` is; ``reports``: those of
    what it reports.
    """
    more = (file for wanted, own in zip(asked, OPTIONS, strict=True) if wanted for file in own)
    files = [*LIBRARY, *closing, *more]
    files += [f"{part}.{end}" for part in reports for end in "hc"]
    return {f"{name}.h": "model.h"} | {f"{name}_{file}": file for file in files}
