"""The memory of a compiled model: views of the structs of its C, and arrays on their way in and out."""

from __future__ import annotations

import ctypes
import math
import threading
from collections.abc import Sequence
from typing import Any, NamedTuple, TypeVar

import numpy as np

from ..algorithms.robot_function import entries
from ..algorithms.robot_functions import reported
from ..arguments import Loads, Numbers, array
from ..backends.c.shim import views
from ..bodies.validity import MEASURES
from ..errors import UsageError
from ..topology.chain import Chain

CONVERTED = (ValueError, TypeError, AttributeError, NotImplementedError)
"""The errors of memoryviews for values that are not arrays of their shape and number type."""

Array = np.ndarray
Pair = tuple[Array, Array]
Real = ctypes.c_float | ctypes.c_double
_T = TypeVar("_T", bound=Sequence[Array])

MOTION = {"rotation": (3, 3), "position": (3,), "tip_rotation": (3, 3), "tip_position": (3,), "tip_twist": (6,)}
"""The members of the motion of a robot, with their shape for one link."""


class LinkMotions(NamedTuple):
    """Poses and twists of a robot with n links, in the inertial frame."""

    rotation: Array
    """(n, 3, 3): of the frame F_i of every link."""
    position: Array
    """(n, 3) m: its origin."""
    tip_rotation: Array
    """(n, 3, 3): of the tip frame of every link."""
    tip_position: Array
    """(n, 3) m: its tip point."""
    tip_twist: Array
    """(n, 6): [omega; v] of tip section and tip point, rad/s and m/s."""


class StructMemory:
    """Memory for a struct of a library, and its members by name."""

    def __init__(self, library: Any, names: Sequence[str], real: np.dtype):
        offsets = (ctypes.c_size_t * (1 + len(names)))()
        library.shim_layout(offsets)
        size, *places = offsets
        self.bytes, self.real = np.zeros(size + 64, np.uint8), real
        self._start = -self.bytes.ctypes.data % 64
        self._places = dict(zip(names, places, strict=True))
        self.address = ctypes.c_void_p(self.bytes.ctypes.data + self._start)

    def view(self, name: str, *shape: int, kind: Any = None) -> Array:
        """A member as an array, of reals by default."""
        dtype = np.dtype(kind or self.real)
        first = self._start + self._places[name]
        return self.bytes[first:][: math.prod(shape) * dtype.itemsize].view(dtype).reshape(shape)


class Memory:
    """The memory of one instance of a library, and its lock."""

    chain: Chain
    library: Any
    real: np.dtype
    _q: Any
    """A memoryview; what it refuses, it refuses by an error, so that any value may be tried."""
    _v: Any
    _tau: Any
    _w_ext: Any

    def _place(self) -> None:
        """Allocate the memory and find the views in it."""
        self._lock = threading.Lock()
        c, self._block = self.chain, StructMemory(self.library, views(self.chain), self.real)
        self.memory, view = self._block.address, self._block.view
        self.q, self.v, self.vdot = view("state.q", c.nq), view("state.v", c.nvz), view("output.vdot", c.nvz)
        self.tau, self.w_ext = view("input.tau", c.n_tau), view("input.w_ext", c.n, 6)
        self.wrench = view("output.wrench", c.n, 6)
        self.tip_rotation, self.tip_position = view("output.tip_rotation", 3, 3), view("output.tip_position", 3)
        self._reports = {row.name: view(row.name, entries(row, c)) for row in reported(c)}
        self._measures = view("measures", c.n, len(MEASURES))
        self._motion = [view(f"motion.{name}", c.n, *shape) for name, shape in MOTION.items()]
        self._order = _order(c)
        self._dae = view("dae", int(max(self._order)) + 1)
        self._q, self._v, self._tau = self.q.data, self.v.data, self.tau.data
        self._w_ext = self.w_ext.reshape(-1).data
        self._no_v, self._no_tau, self._no_w_ext = (np.zeros(k, self.real) for k in (c.nvz, c.n_tau, 6 * c.n))
        self._w_shape = self.w_ext.shape
        self._forward, self._accelerations = self.library.shim_forward, self.library.shim_accelerations

    @property
    def x(self) -> Array:
        """The state of the DAE form in memory."""
        return self._dae[self._order]

    @x.setter
    def x(self, values: Array) -> None:
        self._dae[self._order] = values

    def _set(self, q: Numbers, v: Numbers, tau: Loads = None, w_ext: Loads = None) -> None:
        """Copy values into the structs by memoryviews, which accept arrays of their type and length only."""
        try:
            self._q[:] = q
            self._v[:] = v
            self._tau[:] = self._no_tau if tau is None else tau
            if w_ext is None:
                self._w_ext[:] = self._no_w_ext
            elif isinstance(w_ext, np.ndarray) and w_ext.shape == self._w_shape:
                self._w_ext[:] = w_ext.ravel()
            else:
                self._take(q, v, tau, w_ext)
        except CONVERTED:
            self._take(q, v, tau, w_ext)

    def _given(self, out: _T, *values: Array) -> _T:
        """The caller's arrays with the values in them, if all of them can hold them."""
        real = self.real
        try:
            for place, value in zip(out, values, strict=True):
                if place.dtype is not real or place.shape != value.shape:
                    self._check_out(out, values)
            for place, value in zip(out, values):  # noqa: B905
                place[...] = value
        except (ValueError, TypeError, AttributeError):
            raise UsageError(f"out cannot be written to; give arrays of {real} for vdot and wrench") from None
        return out

    def _check_out(self, out: Sequence[Array], values: Sequence[Array]) -> None:
        """Refuse arrays that cannot hold the values."""
        for place, value, name in zip(out, values, ("vdot", "wrench"), strict=False):
            if place.dtype.kind != "f":
                raise UsageError(f"out: {name} holds {place.dtype}; give an array of {self.real}")
            if place.shape != value.shape:
                raise UsageError(f"out: {name} has the shape {place.shape}; it must be {value.shape}")

    def _take(self, q: Numbers, v: Numbers, tau: Loads, w_ext: Loads) -> None:
        """Convert and copy numbers of the right count into the structs; None is zero."""
        given = {
            "q": (q, self.q),
            "v": (self.chain.with_internal(v), self.v),
            "tau": (tau, self.tau),
            "w_ext": (w_ext, self.w_ext),
        }
        for name, (values, place) in given.items():
            place[...] = array(values, name, place.shape, finite=False)

    def _input(self, tau: Loads, w_ext: Loads) -> list[Array]:
        given = ((tau, "tau", (self.chain.n_tau,)), (w_ext, "w_ext", (self.chain.n, 6)))
        return [array(values, name, shape, finite=False) for values, name, shape in given]

    def _in(self, values: Loads, shape: tuple[int, ...], name: str) -> Array:
        """Numbers as a new array for the C; zeros for None."""
        out = array(values, name, shape, finite=False).astype(self.real)
        return out if out.size else np.zeros(1, self.real)


def _order(c: Chain) -> Array:
    """The places of the entries of x in ``<robot>_dae_state``: there positions follow all quaternions."""
    sizes = (4 * c.n, 3 * c.n, c.n_inner, 6 * c.n, c.n_inner, c.n_redundant, *[c.n_internal] * (c.n_internal > 0))
    starts = np.cumsum([0, *(max(size, 1) for size in sizes)])
    quaternion, position, *rest = (start + np.arange(size) for start, size in zip(starts, sizes, strict=False))
    return np.concatenate([np.hstack([quaternion.reshape(-1, 4), position.reshape(-1, 3)]).ravel(), *rest])


def pointer(array: Array) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)
