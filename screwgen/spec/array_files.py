"""What files of runs, plans and laws have in common, .npz: whatever is wrong with one is a line."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

import numpy as np

from ..errors import UsageError
from ..files import Arrays, open_arrays, sound
from .load import one_line

UNLIMITED = "tau_max"
"""The array that may be infinite."""


@contextmanager
def arrays_of(path: str | os.PathLike[str], what: str, remedy: str) -> Iterator[Arrays]:
    """The arrays of a file while they are read and checked; OSError and ValueError become UsageError, one line.

    `what`: what the file should be, as "a plan"; `remedy`: what is to be given instead.
    """
    try:
        with open_arrays(path) as arrays:
            yield arrays
    except (OSError, ValueError) as error:
        why = one_line(getattr(error, "strerror", None) or str(error))
        raise UsageError(f"{one_line(os.fsdecode(path))}: cannot be read as {what} ({why}); give {remedy}") from None


def check_numbers(found: Mapping[str, np.ndarray]) -> None:
    """Raises ValueError where numbers are not finite, or beyond what measures anything."""
    for name, x in found.items():
        if not sound(x[np.isfinite(x)] if name == UNLIMITED and not np.isnan(x).any() else x):
            raise ValueError(f"{name} holds something else than measured numbers")


def check_shapes(found: Mapping[str, np.ndarray], shapes: Mapping[str, tuple[int, ...]]) -> None:
    """Raises ValueError where an array has another shape than it must have."""
    for name, wanted in shapes.items():
        if found[name].shape != wanted:
            raise ValueError(f"{name} has the shape {found[name].shape}; it must have {wanted}")
