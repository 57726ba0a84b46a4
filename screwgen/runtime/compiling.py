"""What :meth:`screwgen.Model.compile` does: its arguments are checked, then the C is compiled and loaded."""

from __future__ import annotations

from ..arguments import choice
from ..errors import UsageError
from .compiled import Compiled, Derived

PRECISIONS = ("double", "single")
LAYOUTS = ("auto", "fused", "modular")
BINDINGS = ("runtime", "baked")


def compile_model(
    model: Derived, layout: str, precision: str, derivatives: bool, flags, cache, parameters: str, methods
) -> Compiled:
    """The implementation of :meth:`screwgen.Model.compile`."""
    choices = (("layout", layout, LAYOUTS), ("precision", precision, PRECISIONS), ("parameters", parameters, BINDINGS))
    for name, given, known in choices:
        choice(given, known, f"{name}: there is no")
    if isinstance(flags, str):
        raise UsageError("flags is a string; give a sequence such as ('-O3', '-march=native')")
    single = precision == "single"
    return Compiled(model, layout, parameters, single, tuple(flags), None, derivatives, cache, tuple(methods))
