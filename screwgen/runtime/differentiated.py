"""The derivatives of a compiled model: of the accelerations, of a step, and of the joint wrenches."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from ..algorithms.parameter_slopes import BY_P, Differentiable
from ..arguments import Loads, Numbers, choice, seconds
from ..backends.c.by_p import STEPS, rows
from ..backends.numpy.numeric import singular
from ..errors import ScrewgenError, SingularError, UsageError
from ..integrators.method import Method
from ..integrators.methods import method_of
from ..topology.chain import Chain
from .memory import Array, Memory, Real, pointer

STATUS = ("ok", "non-finite input or result", "singular", "bad argument")
NONFINITE, SINGULAR, BAD_ARGUMENT = 1, 2, 3
OUT_OF_REACH = "a linkage does not reach this posture; give an angle within its range"
Derivatives = tuple[Array, Array, Array, Array]
NO_METHOD = "in the generated C there is no integrator"


def known(method: str | Method, methods: Mapping[str, Method]) -> Method:
    """An integrator of a library with some methods; raises UsageError where it is not one of them."""
    wanted = method_of(method, methods, NO_METHOD)
    if wanted not in methods.values():
        raise UsageError(f"{NO_METHOD} '{wanted}' as it is given; compile the model with methods=({wanted},)")
    return wanted


def failure(chain: Chain, status: int, fault: int, otherwise: str = "") -> ScrewgenError:
    """The error of a status that is not OK; ``fault``: the link at fault, or -1 where that is ``otherwise``."""
    if status == SINGULAR:
        return SingularError(otherwise) if otherwise and fault < 0 else singular(chain, fault)
    return ScrewgenError(f"the generated C reports: {STATUS[status]}")


class Scratch(dict):
    """Memory for the functions of derivatives, by name, as each is first called."""

    def __init__(self, library: Any):
        super().__init__()
        self.library = library

    def __missing__(self, name: str) -> ctypes.Array:
        size = self.library[f"shim_{name}_size"]
        size.restype = ctypes.c_size_t
        return self.setdefault(name, ctypes.create_string_buffer(size()))


class CompiledDerivatives(Memory):
    """The functions that need ``derivatives=True``."""

    methods: Mapping[str, Method]
    chosen: tuple[int, ...]
    with_derivatives: bool
    single: bool
    p: np.ndarray | None
    _prepared_for: object = ()
    """The parameters that the slopes of the constants are of."""

    def linearise(self, q: Numbers, v: Numbers, tau: Loads = None, w_ext: Loads = None) -> Derivatives:
        """``vdot`` (nvz,) and its partial derivatives with q (nvz, nv), v (nvz, nvz) and tau (nvz, n_tau).

        Of a floating base those with q are with a change δ (6,) = [turn; shift] of its pose in its own axes,
        ``pose exp(δ)``.  Needs ``derivatives=True``.  Without joint coordinates the last has no columns.
        """
        nv, nvz, m = self.chain.nv, self.chain.nvz, self.chain.n_tau
        return self._differentiated("linearise", (nvz, (nvz, nv), (nvz, nvz), (nvz, m)), (q, v, tau, w_ext))

    def step_derivatives(
        self, q: Numbers, v: Numbers, tau: Loads, w_ext: Loads, dt: float, method: str | Method = "modal_midpoint"
    ) -> Derivatives:
        """The state after one step, and its derivatives: ``q, v, A, B``.

        ``A`` (nv + nvz, nv + nvz) is with respect to [q; v], ``B`` (nv + nvz, n_tau) with respect to tau; of a
        floating base the first six rows and columns are changes δ = [turn; shift] of its pose in its own axes,
        ``pose exp(δ)``, after and before the step.  Needs ``derivatives=True``.
        """
        self._needs_derivatives()
        c, step = self.chain, (self.number(method), self._real(seconds(dt, "dt")))
        size = c.nv + c.nvz
        shapes = c.nq, c.nvz, (size, size), (size, c.n_tau)
        return self._differentiated("step_derivatives", shapes, (q, v, tau, w_ext), *step)

    def linearise_wrenches(self, q: Numbers, v: Numbers, tau: Loads = None, w_ext: Loads = None) -> Derivatives:
        """The joint wrenches (n, 6) and their derivatives with q (n, 6, nv), v (n, 6, nvz) and tau (n, 6, n_tau).

        The accelerations follow. The columns are those of :meth:`linearise`.  Needs ``derivatives=True``.
        """
        self._needs_derivatives()
        c = self.chain
        shapes = [(c.n, 6, *k) for k in ((), (c.nv,), (c.nvz,), (c.n_tau,))]
        return self._differentiated("linearise_wrenches", shapes, (q, v, tau, w_ext))

    def _differentiated(
        self, name: str, shapes: Sequence[int | tuple[int, ...]], given: tuple, *more: object
    ) -> Derivatives:
        """What a function of the library writes into new arrays of these shapes, at a state and inputs."""
        self._needs_derivatives()
        arrays = a, b, c, d = [np.zeros(shape, self.real) for shape in shapes]
        with self._lock:
            self._set(*given)
            call = getattr(self.library, f"shim_{name}")
            self.check(call(self.memory, self._scratch[name], *more, *map(pointer, arrays)))
        return a, b, c, d

    def __getattr__(self, name: str) -> Callable:
        """Derivatives by the parameters ``by_p`` that the model was compiled with, ``<function>_by_p``, by name."""
        known = {row.name + BY_P: row for row in rows(self.chain)} if name.endswith(BY_P) else {}
        if name not in known:
            raise AttributeError(f"'Compiled' has no attribute '{name}'", name=name, obj=self)
        shapes = Differentiable.of(self.chain, known[name]).results.values()
        return lambda q, v=None, tau=None, w_ext=None: self._by_p(name, tuple(shapes), (q, v, tau, w_ext))

    def step_by_p(
        self, q: Numbers, v: Numbers, tau: Loads, w_ext: Loads, dt: float, method: str = "modal_midpoint"
    ) -> tuple[Array, ...]:
        """The derivatives of coordinates (nq, k) and rates (nvz, k) after a step by those parameters."""
        choice(method, STEPS, "in C there are no derivatives by parameters of")
        shapes = (self.chain.nq,), (self.chain.nvz,)
        return self._by_p(f"step_{method}{BY_P}", shapes, (q, v, tau, w_ext), seconds(dt, "dt"))

    def _by_p(self, name: str, shapes: tuple[tuple[int, ...], ...], given: tuple, dt: float = 0.0) -> Any:
        """What such a function writes, an array for each result, the last axis that of the parameters."""
        if not (count := len(self.chosen)):
            raise UsageError('this model was compiled without parameters to differentiate by; give by_p=("arm.*",)')
        sizes = [math.prod(shape) * count for shape in shapes]
        found = np.zeros(sum(sizes), self.real)
        q, v, tau, w_ext = given
        with self._lock:
            self._set(q, self._no_v if v is None else v, tau, w_ext)
            own = self._scratch["by_p"]
            if self._prepared_for is not self.p:
                self.check(self.library.shim_prepare_by_p(self.memory, own))
                self._prepared_for = self.p
            self.check(getattr(self.library, f"shim_{name}")(self.memory, own, self._real(dt), pointer(found)))
        parts = np.split(found, np.cumsum(sizes)[:-1])
        out = tuple(part.reshape(*shape, count) for part, shape in zip(parts, shapes, strict=True))
        return out if len(out) > 1 else out[0]

    def _needs_derivatives(self) -> None:
        if not self.with_derivatives:
            raise UsageError("this model was compiled without derivatives; compile it with derivatives=True")

    @cached_property
    def _scratch(self) -> Scratch:
        return Scratch(self.library)

    def number(self, method: str | Method) -> int:
        """The number that an integrator has in the library; raises UsageError where it has none."""
        if isinstance(method, str) and method in self.methods:
            return list(self.methods).index(method)
        return list(self.methods.values()).index(known(method, self.methods))

    def _real(self, value: float) -> Real:
        return ctypes.c_float(value) if self.single else ctypes.c_double(value)

    def check(self, status: int) -> None:
        """Raise the error of a status that is not OK."""
        if status:
            raise failure(self.chain, status, self.library.shim_fault(self.memory), OUT_OF_REACH)
