"""Numbers with several values at once, for functions that are linear in some of their arguments."""

from __future__ import annotations

import numpy as np


class ValuesPerRate:
    """What a number is for each of several arguments, as one entry of an array of objects."""

    __slots__ = ("entries",)
    __array_ufunc__ = None

    def __init__(self, entries: np.ndarray):
        self.entries = entries

    def __add__(self, other: ValuesPerRate | float) -> ValuesPerRate:
        return ValuesPerRate(self.entries + _entries(other))

    __radd__ = __add__

    def __sub__(self, other: ValuesPerRate | float) -> ValuesPerRate:
        return ValuesPerRate(self.entries - _entries(other))

    def __rsub__(self, other: float) -> ValuesPerRate:
        return ValuesPerRate(other - self.entries)

    def __mul__(self, other: ValuesPerRate | float) -> ValuesPerRate:
        return ValuesPerRate(self.entries * _entries(other))

    __rmul__ = __mul__

    def __truediv__(self, other: float) -> ValuesPerRate:
        return ValuesPerRate(self.entries / other)

    def __neg__(self) -> ValuesPerRate:
        return ValuesPerRate(-self.entries)


def _entries(x: ValuesPerRate | float) -> np.ndarray | float:
    return x.entries if isinstance(x, ValuesPerRate) else x
