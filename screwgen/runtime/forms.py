"""The libraries of a compiled model: that of the joint form, and others, which are compiled when they are called."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable
from typing import Any


class LazyLibrary:
    """The functions of a library by name; it is compiled when the first is asked for.

    Raises AttributeError for a name that it does not have, ScrewgenError where it does not compile.
    """

    def __init__(self, make: Callable[[], ctypes.CDLL]):
        self._make, self._lock = make, threading.Lock()
        self._made: ctypes.CDLL | None = None

    def __getattr__(self, name: str) -> Callable[..., Any]:
        with self._lock:
            if self._made is None:
                self._made = self._make()
        return getattr(self._made, name)


class Forms:
    """The functions of a robot's library by name; those of the DAE form come from a library of their own."""

    def __init__(self, joint: ctypes.CDLL, dae: LazyLibrary):
        self._joint, self._dae = joint, dae

    def __getattr__(self, name: str) -> Callable[..., Any]:
        """A function; raises as :class:`LazyLibrary`."""
        try:
            found = getattr(self._joint, name)
        except AttributeError:
            found = getattr(self._dae, name)
        setattr(self, name, found)
        return found

    def __getitem__(self, name: str) -> Callable[..., Any]:
        return getattr(self, name)
