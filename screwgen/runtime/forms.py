"""The libraries of a compiled model: that of the joint form, and that of the DAE form, compiled when it is called."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable
from typing import Any


class Forms:
    """The functions of a robot's library by name; those of the DAE form come from a library of their own."""

    def __init__(self, joint: ctypes.CDLL, dae: Callable[[], ctypes.CDLL]):
        self._joint, self._make, self._lock = joint, dae, threading.Lock()
        self._made: ctypes.CDLL | None = None

    def __getattr__(self, name: str) -> Callable[..., Any]:
        """A function; raises AttributeError where there is none, ScrewgenError where the DAE form does not compile."""
        try:
            found = getattr(self._joint, name)
        except AttributeError:
            found = getattr(self._dae, name)
        setattr(self, name, found)
        return found

    def __getitem__(self, name: str) -> Callable[..., Any]:
        return getattr(self, name)

    @property
    def _dae(self) -> ctypes.CDLL:
        with self._lock:
            if self._made is None:
                self._made = self._make()
            return self._made
