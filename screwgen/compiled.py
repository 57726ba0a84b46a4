"""The generated C, compiled and loaded: its functions on NumPy arrays."""

from __future__ import annotations

import ctypes
import math
import os
from collections.abc import Sequence
from functools import cached_property
from typing import Protocol

import numpy as np

from .chain.chain import Chain
from .chain.dae_functions import state_size, unknown_size
from .emit.c import METHODS, CProject
from .emit.c_shim import shims
from .errors import ScrewgenError, SingularError, UsageError
from .library import load

__all__ = ["STATUS", "Compiled", "CompiledStepper"]

STATUS = ("ok", "non-finite input or result", "singular", "bad argument")
SINGULAR = 2
PRECISIONS = ("double", "single")
LAYOUTS = ("auto", "fused", "modular")
BINDINGS = ("runtime", "baked")
FIELDS = ("size", "q", "v", "tau", "w_ext", "vdot", "wrench", "tip_rotation", "tip_position", "energy")
"""What the library says about its memory: its size, and where these are, in bytes."""

CONVERTED = (ValueError, TypeError, AttributeError, NotImplementedError)
"""What memoryviews say to values that are no arrays of their shape and number type."""

Array = np.ndarray


class Derived(Protocol):
    """What is compiled: :class:`screwgen.Model`."""

    chain: Chain
    parameter_values: list[float]

    @property
    def version(self) -> str: ...


class LeanProject(CProject):
    """The C without the reference values of its self-check, which take as long as all the rest."""

    reference = ()
    check = {"tolerance": {"double": "", "single": ""}, "lost": ""}  # noqa: RUF012


class Compiled:
    """A robot's C in a shared library.  Arrays are those of the NumPy back end; precision may be single.

    Numbers go from the caller's arrays straight into the structs of the C, and from there into ``out`` or new arrays:
    nothing lies between where an array has the number type of the library and one axis, or lies in one piece; all
    else that is numbers of the right count is converted.  ``q`` (nq,), ``v`` (nq,), ``tau`` (n_joints,), ``w_ext`` (n,
    6), ``vdot`` (nq,), ``wrench`` (n, 6), ``tip_rotation`` (3, 3), ``tip_position`` (3,) are views of those structs as
    the last call left them.

    An instance keeps its state in memory of its own: many may be used at once, each by one thread.

    ``cache``: as :func:`screwgen.library.load` takes it.  Raises :class:`ScrewgenError` where there is no C compiler or
    a call does not return OK, :class:`SingularError` naming the link whose joint is singular, and
    :class:`UsageError` on arrays of another size.
    """

    def __init__(
        self,
        model: Derived,
        layout="auto",
        parameters="runtime",
        single=False,
        flags: Sequence[str] = ("-O2",),
        compiler: str | None = None,
        derivatives=False,
        cache: bool | str | os.PathLike = False,
    ):
        self.model, self.chain, self.single = model, model.chain, single
        self.real = np.dtype(np.float32 if single else np.float64)
        self.project = LeanProject(self.chain, model.version, parameters, layout, derivatives=derivatives)
        define = [f"-D{self.project.name.upper()}_REAL_FLOAT"] if single else []
        self.library = load(self.project.files() | shims(self.project), [*flags, *define], compiler, cache)
        self._place()
        self.prepare(None)

    def fresh(self, p: Sequence[float] | None = None) -> Compiled:
        """Another instance with memory of its own in the same library, at the parameters ``p`` (None: the file's)."""
        out = object.__new__(Compiled)
        out.__dict__.update({k: v for k, v in self.__dict__.items() if k != "_linearise_memory"})
        out._place()
        out.prepare(p)
        return out

    def _place(self) -> None:
        """Allocate the memory and find the views in it."""
        c, offsets = self.chain, (ctypes.c_size_t * len(FIELDS))()
        self.library.shim_layout(offsets)
        place = dict(zip(FIELDS, offsets, strict=True))
        self._buffer = np.zeros(place["size"] + 64, np.uint8)
        start = -self._buffer.ctypes.data % 64
        self.memory = ctypes.c_void_p(self._buffer.ctypes.data + start)

        def view(name: str, *shape: int) -> Array:
            size = math.prod(shape) * self.real.itemsize
            return self._buffer[start + place[name] :][:size].view(self.real).reshape(shape)

        self.q, self.v, self.vdot = (view(name, c.nq) for name in ("q", "v", "vdot"))
        self.tau, self.w_ext, self.wrench = view("tau", c.n_joints), view("w_ext", c.n, 6), view("wrench", c.n, 6)
        self.tip_rotation, self.tip_position = view("tip_rotation", 3, 3), view("tip_position", 3)
        self._energy = view("energy", 2)
        self._q, self._v, self._tau = memoryview(self.q), memoryview(self.v), memoryview(self.tau)
        self._w_ext = memoryview(self.w_ext.reshape(-1))
        self._no_v, self._no_tau, self._no_w_ext = (np.zeros(k, self.real) for k in (c.nq, c.n_joints, 6 * c.n))
        self._forward, self._accelerations = self.library.shim_forward, self.library.shim_accelerations

    def prepare(self, p: Sequence[float] | None) -> None:
        """Set the parameters (None: the robot file's values)."""
        if p is None:
            self.check(self.library.shim_prepare(self.memory, None))
        else:
            values = self._in(p, len(self.model.parameter_values), "p")
            self.check(self.library.shim_prepare(self.memory, _pointer(values)))

    # joint form -------------------------------------------------------------------------------

    def forward_dynamics(
        self, q, v, tau=None, w_ext=None, form="joint", out: tuple[Array, Array] | None = None
    ) -> tuple[Array, Array]:
        """``vdot`` (nq,) and the joint wrenches (n, 6); torques and tip wrenches left out are zero."""
        self._set(q, v, tau, w_ext)
        status = self._forward(self.memory) if form == "joint" else self.library.shim_dae_forward(self.memory)
        if status:
            self.check(status)
        if out is None:
            return self.vdot.copy(), self.wrench.copy()
        vdot, wrench = out
        return self._give(vdot, self.vdot, "vdot"), self._give(wrench, self.wrench, "wrench")

    def complete_dynamics(self, q, v, tau=None, w_ext=None, form="joint"):
        """``vdot``, wrenches, rotation (3, 3) and position (3,) of the last tip."""
        vdot, wrench = self.forward_dynamics(q, v, tau, w_ext, form)
        return vdot, wrench, self.tip_rotation.copy(), self.tip_position.copy()

    def accelerations(self, q, v, tau=None, w_ext=None, out: Array | None = None) -> Array:
        """``vdot`` alone."""
        self._set(q, v, tau, w_ext)
        if status := self._accelerations(self.memory):
            self.check(status)
        return self.vdot.copy() if out is None else self._give(out, self.vdot, "vdot")

    def energy(self, q, v) -> tuple[float, float]:
        """Kinetic and potential energy, J."""
        self._set(q, v)
        self.check(self.library.shim_energy(self.memory))
        kinetic, potential = self._energy.tolist()
        return kinetic, potential

    def linearise(self, q, v, tau=None, w_ext=None) -> tuple[Array, Array, Array, Array]:
        """``vdot`` (nq,) and its partial derivatives with q, v (nq, nq) and tau (nq, m).

        Needs ``derivatives=True``.  Arrays of a robot without joint coordinates have no columns in the last.
        """
        if not self.project.with_derivatives:
            raise UsageError("this model was compiled without derivatives; compile it with derivatives=True")
        nq, m = self.chain.nq, self.chain.n_joints
        arrays = [np.zeros(shape, self.real) for shape in (nq, (nq, nq), (nq, nq), (nq, m))]
        self._set(q, v, tau, w_ext)
        self.check(self.library.shim_linearise(self.memory, self._linearise_memory, *map(_pointer, arrays)))
        return tuple(arrays)

    @cached_property
    def _linearise_memory(self):
        self.library.shim_linearise_size.restype = ctypes.c_size_t
        return ctypes.create_string_buffer(self.library.shim_linearise_size())

    def inverse_dynamics(self, q, v, vdot, w_ext=None) -> tuple[Array, Array]:
        """The forces on all coordinates (nq,) and the joint wrenches (n, 6) that a motion needs."""
        c = self.chain
        force, wrench = np.zeros(max(c.nq, 1), self.real), np.zeros((c.n, 6), self.real)
        self._set(q, v, None, w_ext)
        given = _pointer(self._in(vdot, c.nq, "vdot"))
        self.check(self.library.shim_inverse(self.memory, given, _pointer(force), _pointer(wrench)))
        return force[: c.nq], wrench

    def mass_matrix(self, q) -> Array:
        """``M`` (nq, nq)."""
        size = max(self.chain.nq, 1)
        M = np.zeros((size, size), self.real)
        self._set(q, self._no_v)
        self.check(self.library.shim_mass_matrix(self.memory, _pointer(M)))
        return M[: self.chain.nq, : self.chain.nq]

    def step(self, q, v, tau, w_ext, dt: float, method="rk4", count=1) -> tuple[Array, Array]:
        """The state after ``count`` steps of the joint form, the input held."""
        q, v = self._copy(q, self.chain.nq, "q"), self._copy(v, self.chain.nq, "v")
        call, number = self.library.shim_step, _number(method)
        inputs = map(_pointer, (*self._input(tau, w_ext), q, v))
        self.check(call(self.memory, number, count, self._real(dt), *inputs))
        return q[: self.chain.nq], v[: self.chain.nq]

    # DAE form ---------------------------------------------------------------------------------

    def dae_state(self, q, v) -> Array:
        """The state ``x`` of the DAE form."""
        x = np.zeros(state_size(self.chain), self.real)
        self._set(q, v)
        self.check(self.library.shim_dae_state(self.memory, _pointer(x)))
        return x

    def dae_step(self, x, tau, w_ext, dt: float, method="rk4", count=1) -> Array:
        """``x`` after ``count`` steps of the DAE form, each projected, the input held."""
        x = self._copy(x, state_size(self.chain), "x")
        call, number = self.library.shim_dae_step, _number(method)
        inputs = map(_pointer, (*self._input(tau, w_ext), x))
        self.check(call(self.memory, number, count, self._real(dt), *inputs))
        return x

    def assemble(self, x, tau, w_ext) -> tuple[Array, Array, Array]:
        """``M_sys`` (dense), ``H_sys`` and ``W_sys``."""
        size, rows, columns = unknown_size(self.chain), *self._pattern()
        values, H, W = np.zeros(len(rows), self.real), np.zeros(size, self.real), np.zeros(size, self.real)
        arrays = (self._in(x, state_size(self.chain), "x"), *self._input(tau, w_ext), values, H, W)
        self.check(self.library.shim_assemble(self.memory, *map(_pointer, arrays)))
        M = np.zeros((size, size), self.real)
        for j in range(size):
            M[rows[columns[j] : columns[j + 1]], j] = values[columns[j] : columns[j + 1]]
        return M, H, W

    def _pattern(self) -> tuple[Array, Array]:
        rows = np.zeros(self.project.context["nnz"], np.int32)
        columns = np.zeros(unknown_size(self.chain) + 1, np.int32)
        self.library.shim_pattern(_pointer(rows), _pointer(columns))
        return rows, columns

    # arrays -----------------------------------------------------------------------------------

    def _set(self, q, v, tau=None, w_ext=None) -> None:
        """Into the structs by memoryviews, which take arrays of their type and length, and leave all else."""
        try:
            self._q[:] = q
            self._v[:] = v
            self._tau[:] = self._no_tau if tau is None else tau
            self._w_ext[:] = self._no_w_ext if w_ext is None else w_ext.ravel()
        except CONVERTED:
            self._take(q, v, tau, w_ext)

    def _give(self, array: Array, value: Array, name: str) -> Array:
        """``array`` with the value in it."""
        if array.shape != value.shape:
            raise UsageError(f"out: {name} has the shape {array.shape}; it must be {value.shape}")
        array[...] = value
        return array

    def _take(self, q, v, tau, w_ext) -> None:
        """Any numbers of the right count into the structs; None is zero."""
        given = {"q": (q, self.q), "v": (v, self.v), "tau": (tau, self.tau), "w_ext": (w_ext, self.w_ext)}
        for name, (values, place) in given.items():
            place[...] = (
                0.0 if values is None else self._in(values, place.size, name)[: place.size].reshape(place.shape)
            )

    def _input(self, tau, w_ext):
        return self._in(tau, self.chain.n_joints, "tau"), self._in(w_ext, 6 * self.chain.n, "w_ext")

    def _in(self, values, size: int, name: str) -> Array:
        """Numbers as one axis: the caller's memory where type and layout fit."""
        try:
            array = np.ascontiguousarray(values, self.real).reshape(-1)
        except (TypeError, ValueError):
            raise UsageError(f"{name} is not an array of numbers; give {size} numbers") from None
        if array.size != size:
            raise UsageError(f"{name} has {array.size} numbers; it must have {size}")
        return array if size else np.zeros(1, self.real)

    def _copy(self, values, size: int, name: str) -> Array:
        return self._in(values, size, name).copy()

    def _real(self, value: float):
        return ctypes.c_float(value) if self.single else ctypes.c_double(value)

    def check(self, status: int) -> None:
        """Raise the error of a status that is not OK."""
        if status == SINGULAR:
            link = self.chain.robot.links[self.library.shim_fault(self.memory)].name
            raise SingularError(f"the joint of link '{link}' is singular in this posture")
        if status:
            raise ScrewgenError(f"the generated C reports: {STATUS[status]}")


def compile_model(
    model: Derived, layout: str, precision: str, derivatives: bool, flags, cache, parameters: str
) -> Compiled:
    """What :meth:`screwgen.Model.compile` does."""
    choices = (("layout", layout, LAYOUTS), ("precision", precision, PRECISIONS), ("parameters", parameters, BINDINGS))
    for name, given, known in choices:
        if given not in known:
            raise UsageError(f"{name}: there is no '{given}'; choose {' or '.join(known)}")
    if isinstance(flags, str):
        raise UsageError("flags is a string; give a sequence such as ('-O3', '-march=native')")
    single = precision == "single"
    return Compiled(model, layout, parameters, single, tuple(flags), derivatives=derivatives, cache=cache)


def _number(method: str) -> int:
    if method not in METHODS:
        raise UsageError(f"there is no integrator '{method}' in the generated C; choose {', '.join(METHODS)}")
    return METHODS.index(method)


def _pointer(array: Array) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


class CompiledStepper:
    """A stepper of :mod:`screwgen.simulation` that steps the joint form in the generated C."""

    default = "modal_implicit"

    def __init__(self, compiled: Compiled, model: Derived, integrator: str, p):
        self.compiled, self.integrator = compiled, integrator
        compiled.prepare(p)

    def initial(self, q, v):
        return np.array(q, float), np.array(v, float)

    def step(self, state, tau, w_ext, dt: float):
        return self.compiled.step(*state, tau, w_ext, dt, self.integrator)

    def coordinates(self, state):
        return state
