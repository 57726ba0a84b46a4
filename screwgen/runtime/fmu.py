"""Functional mock-up units of a model, with a binary of this machine where there is a compiler."""

from __future__ import annotations

import platform
import sys
import warnings
from collections.abc import Sequence

from ..algorithms.marker_functions import STRAINED
from ..algorithms.robot_functions import OUTPUTS, SENSORS
from ..backends.fmi.code import content
from ..backends.fmi.package import archive, unit
from ..errors import TargetWarning
from ..integrators.method import Method
from ..robot_model import RobotModel
from .lean import RuntimeProject
from .library import binary, has_compiler

FLAGS = ("-O2", "-fvisibility=hidden", "-Wl,-s")
EXPORTS = {"fmi.map": "{ global: fmi2*; fmi3*; local: *; };\n"}
"""Nothing but the functions of FMI is seen from outside, so units of equal names can be in one process."""

PLACES = {
    2: {"x86_64": "linux64"},
    3: {"x86_64": "x86_64-linux", "aarch64": "aarch64-linux"},
}
"""The folders of binaries of Linux, by version and processor."""


class UnitProject(RuntimeProject):
    """The library of a unit, which knows the strains besides."""

    further = (STRAINED,)


def unit_files(
    model: RobotModel,
    target: str,
    parameters: str = "runtime",
    layout: str = "auto",
    methods: Sequence[Method] = (),
    sensors: bool = False,
) -> dict[str, bytes]:
    """``<robot>.fmu`` in the version of FMI of ``target``; a TargetWarning where binary or derivatives are missing.

    ``sensors``: whether what sensors measure at markers is among its outputs.
    """
    key = ("unit", parameters, layout, tuple(methods), sensors)
    project, programs, objects = model.once(key, lambda: _common(model, *key[1:]))
    made = unit(project, programs, target)
    name, places = f"{made.name}.fmu", PLACES[made.version] if sys.platform == "linux" else {}
    place = places.get(platform.machine(), "")
    lacks = "" if place and has_compiler() else "no C compiler" if place else "no name in FMI for this machine"
    if lacks:
        _warn(f"{target}/{name} holds sources alone, since there is {lacks}; compile it where it is used")
    if not made.derived:
        _warn(f"{target}/{name} has no directional derivatives: they would take too long to compile")
    return {
        name: archive(
            made,
            None if lacks else binary(made.sources | EXPORTS, (*FLAGS, "-Wl,--version-script=fmi.map"), objects),
            place,
        )
    }


def _common(model: RobotModel, parameters: str, layout: str, methods: Sequence[Method], sensors: bool) -> tuple:
    """What the units of both versions share: the library, the programs besides, and what is compiled of them."""
    told = [OUTPUTS] + [SENSORS] * sensors
    project = UnitProject(model.chain, model.version, parameters, layout, methods=methods, outputs=told)
    return project, content(project), {}


def _warn(text: str) -> None:
    warnings.warn(text, TargetWarning, stacklevel=4)
