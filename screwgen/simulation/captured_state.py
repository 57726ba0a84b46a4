"""Whether a controller may be asked for torques without a trace: what its function sees, and how that was.

A controller may remember: a list that it appends to, an integral that it adds up. Asking it for its gains before a run
must not change the run. So a function is asked only where all that it sees is known: numbers, arrays, lists,
dictionaries, functions that see no more, and what does not change. What could change is put back afterwards.
"""

from __future__ import annotations

from collections.abc import Callable
from types import BuiltinFunctionType, CellType, CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

LIBRARIES = {"math", "cmath", "numpy", "casadi", "scipy", "screwgen"}
"""Modules whose functions remember nothing, but for `FORBIDDEN`."""
FORBIDDEN = {"random", "print", "open", "input", "exec", "eval", "setattr", "time", "sleep", "import_module"}
"""Names in a function that make it one that leaves traces."""
FIXED = (type(None), bool, int, float, complex, str, bytes, np.generic, type, range)
"""Kinds of values that cannot change."""
OURS = {"screwgen.model", "screwgen.simulation.controllers", "screwgen.backends.numpy.numeric"}
"""Modules of this package whose objects are not changed by a call, as far as results tell."""


class CapturedState:
    """What a function sees; `admissible`: whether it can be called and all be as before after :meth:`restore`."""

    def __init__(self, function: Any):
        self._undo: list[Callable[[], None]] = []
        self._known: set[int] = set()
        self.admissible = isinstance(function, FunctionType) and self._admits(function)

    def restore(self) -> None:
        """Put back what could have changed."""
        for undo in self._undo:
            undo()

    def _admits(self, x: Any) -> bool:
        if isinstance(x, FIXED) or id(x) in self._known:
            return True
        self._known.add(id(x))
        if isinstance(x, ModuleType):
            return x.__name__.split(".")[0] in LIBRARIES
        if isinstance(x, FunctionType):
            return x.__module__.split(".")[0] in LIBRARIES or self._admits_function(x)
        if isinstance(x, np.ndarray):
            return self._keeps(x, x.copy()) and x.dtype != object
        if isinstance(x, list):
            return self._keeps(x, list(x)) and all(map(self._admits, x))
        if isinstance(x, dict):
            before = dict(x)
            self._undo += [x.clear, lambda: x.update(before)]
            return all(map(self._admits, x.values()))
        if isinstance(x, tuple | frozenset):
            return all(map(self._admits, x))
        home = x.__module__ if isinstance(x, BuiltinFunctionType) else type(x).__module__
        return (home or "") in OURS or (home or "").split(".")[0] in {"builtins", "math", "casadi"} or is_ufunc(x)

    def _keeps(self, x: Any, before: Any) -> bool:
        self._undo.append(lambda: x.__setitem__(slice(None) if isinstance(x, list) else ..., before))
        return True

    def _admits_function(self, f: FunctionType) -> bool:
        names = {name for code in _codes(f.__code__) for name in code.co_names}
        if names & FORBIDDEN:
            return False
        space, cells = f.__globals__, f.__closure__ or ()
        used = {name: space[name] for name in names & space.keys()}
        self._undo.append(lambda: space.update(used))
        return (
            all(map(self._admits_cell, cells))
            and all(map(self._admits, used.values()))
            and all(map(self._admits, (*(f.__defaults__ or ()), *(f.__kwdefaults__ or {}).values())))
        )

    def _admits_cell(self, cell: CellType) -> bool:
        try:
            before = cell.cell_contents
        except ValueError:
            return False
        self._undo.append(lambda: setattr(cell, "cell_contents", before))
        return self._admits(before)


def is_ufunc(x: Any) -> bool:
    """Whether it is one of NumPy's functions."""
    return isinstance(x, np.ufunc) or type(x).__name__ == "_ArrayFunctionDispatcher"


def _codes(code: CodeType) -> list[CodeType]:
    """A function's code and that of the functions inside it."""
    return [code, *(c for x in code.co_consts if isinstance(x, CodeType) for c in _codes(x))]
