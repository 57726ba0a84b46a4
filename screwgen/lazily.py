"""Packages that are imported when they are first used: reading a robot and running its compiled C need none of them."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import mpmath
    import scipy.interpolate as interpolate
    import scipy.linalg as linalg
    import scipy.optimize as optimize
    import scipy.spatial.transform as transform
    import sympy as sp
else:

    class _Lazy:
        """A module by name, imported when the first of its attributes is asked for."""

        def __init__(self, name: str):
            self._name = name

        def __getattr__(self, attribute: str) -> Any:
            found = self.__dict__[attribute] = getattr(import_module(self._name), attribute)
            return found

    sp, linalg, transform = _Lazy("sympy"), _Lazy("scipy.linalg"), _Lazy("scipy.spatial.transform")
    interpolate, optimize = _Lazy("scipy.interpolate"), _Lazy("scipy.optimize")
    mpmath = _Lazy("mpmath")

__all__ = ["interpolate", "linalg", "mpmath", "optimize", "sp", "transform"]
