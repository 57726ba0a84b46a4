"""CasADi functions that refuse arguments of a wrong length, where CasADi would spread one number over all entries."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import casadi as ca
import numpy as np

from ...errors import UsageError


class CheckedFunction(ca.Function):
    """A function whose arguments have their length; one zero stands for zeros, and columns side by side for calls."""

    def call(self, given: Any, *options: Any) -> Any:
        """As of `casadi.Function`. Raises UsageError, which begins with the argument's name."""
        named = given.items() if isinstance(given, Mapping) else zip(self.name_in(), given, strict=False)
        for name, value in named:
            _check(name, value, self.numel_in(name))
        return super().call(given, *options)


def _check(name: str, value: Any, size: int) -> None:
    count = value.numel() if hasattr(value, "numel") else np.size(value)
    if count == size or not count * size or (count > 1 and count % size == 0):
        return
    if count > 1 or not (value.is_zero() if hasattr(value, "is_zero") else np.all(np.equal(value, 0))):
        raise UsageError(f"{name} has {count} number{'s' * (count > 1)}; it must have {size}, or be 0")
