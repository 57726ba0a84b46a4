"""What :meth:`screwgen.Model.compile` does: its arguments are checked, then the C is compiled and loaded."""

from __future__ import annotations

import os
from collections.abc import Sequence

from ..arguments import choice
from ..errors import UsageError
from ..integrators.method import Method
from ..robot_model import RobotModel
from .compiled import Compiled

PRECISIONS = ("double", "single")
LAYOUTS = ("auto", "fused", "modular")
BINDINGS = ("runtime", "baked")


def compile_model(
    model: RobotModel,
    layout: str = "auto",
    precision: str = "double",
    derivatives: bool = False,
    flags: Sequence[str] | None = None,
    cache: bool | str | os.PathLike = True,
    parameters: str = "runtime",
    methods: Sequence[Method] = (),
    by_p: str | Sequence[str] = (),
) -> Compiled:
    """The implementation of :meth:`screwgen.Model.compile`."""
    choices = (("layout", layout, LAYOUTS), ("precision", precision, PRECISIONS), ("parameters", parameters, BINDINGS))
    for name, given, known in choices:
        choice(given, known, f"{name}: there is no")
    flags = model.compiler_flags if flags is None else flags
    if isinstance(flags, str):
        raise UsageError("flags is a string; give a sequence such as ('-O3', '-march=native')")
    single = precision == "single"
    chosen = (by_p,) if isinstance(by_p, str) else tuple(by_p)
    return Compiled(model, layout, parameters, single, tuple(flags), None, derivatives, cache, tuple(methods), chosen)
