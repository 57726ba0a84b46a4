"""screwgen: symbolic code generation for flexible robot arms.

One derivation in screw theory gives CasADi functions, standalone C and LaTeX. Names are imported when they are first
asked for, so that the command line's help and small scripts start quickly. `__init__.pyi` states them once, for type
checkers too.
"""

import re
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

from .version import __version__ as __version__

STUB = Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8")
HOMES = {name: home for home, name in re.findall(r"^from \.(\S+) import (\w+)", STUB, re.MULTILINE)}
"""The module that defines each public name."""

__all__ = [*HOMES]


def __getattr__(name: str):
    """A public name, or a module of the package."""
    if name in HOMES:
        value = getattr(import_module(f"{__name__}.{HOMES[name]}"), name)
        globals()[name] = value
        return value
    if not name.startswith("_") and find_spec(f"{__name__}.{name}"):
        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'", name=name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
