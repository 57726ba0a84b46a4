"""What a library of generated C is asked for by, before any of its sources is written.

An example: ELLA's C has 700 kB, and to write it takes a second; it follows from the robot, the options and the product.
So their digest names it. Two robots that differ in one number have different digests; so have two versions of the
product, whose own files are part of it, and of the packages that write with it.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import is_dataclass
from fractions import Fraction
from functools import cache, cached_property
from importlib.metadata import version
from pathlib import PurePath
from types import FunctionType
from typing import Any

import numpy as np

from ..backends.templates import PACKAGE, folder
from ..spec.part import Part

WRITING = ("jinja2", "mpmath", "numpy", "sympy")
"""The packages that have a part in what is written."""
KNOWN = ("builtins", "collections", "fractions", "numpy", "pathlib", "screwgen")
"""The packages whose classes are what their names say."""


class _UnknownError(Exception):
    """A value whose meaning its name does not fix."""


def digest(*said: object) -> str:
    """A text that two askings share only if they mean the same; empty where none can be given.

    That is so where a user's own class is a part of the robot, whose lines may change under its name.
    """
    try:
        stated = _stated(said)
    except _UnknownError:
        return ""
    return hashlib.sha256(product() + stated.encode()).hexdigest()


def _stated(value: Any) -> str:
    """A value with all that it consists of, the same in every process; raises _UnknownError."""
    kind = value if isinstance(value, type | FunctionType) else type(value)
    if kind.__module__.partition(".")[0] not in KNOWN:
        raise _UnknownError(kind.__module__)
    name = f"{kind.__module__}.{kind.__qualname__}"
    if value is kind or isinstance(value, int | str | bytes | Fraction | PurePath | None):
        return f"{name} {len(text := str(value))}:{text}"
    if isinstance(value, float):
        return f"{name} {value.hex()}"
    return f"{name}({' '.join(_parts(value))})"


def _parts(value: Any) -> list[str]:
    """The parts of a value that has some."""
    if isinstance(value, np.ndarray) and value.dtype != object:
        return [value.dtype.str, str(value.shape), value.tobytes().hex()]
    if isinstance(value, set | frozenset):
        return sorted(map(_stated, value))
    if isinstance(value, Mapping):
        return [_stated(x) for item in value.items() for x in item]
    if isinstance(value, tuple | list):
        return [_stated(x) for x in (*value, *getattr(value, "__dict__", {}).values())]
    if isinstance(value, Part) or is_dataclass(value):
        kind = type(value)  # what follows from the rest is there once it was asked for
        return _parts({k: x for k, x in vars(value).items() if not isinstance(getattr(kind, k, None), cached_property)})
    raise _UnknownError(type(value))


@cache
def product() -> bytes:
    """The digest of all that writes C: the files of this package, its templates of C, and the packages beside it."""
    out = hashlib.sha256("".join(f"{name} {version(name)} " for name in WRITING).encode())
    for place, pattern in ((PACKAGE, "*.py"), (folder() / "c", "*")):
        for path in sorted(place.rglob(pattern)):
            if path.is_file() and path.suffix != ".pyc":
                out.update(f"{path.relative_to(place)} ".encode() + path.read_bytes())
    return out.digest()
