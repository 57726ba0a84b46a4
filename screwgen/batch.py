"""The batch of the generated C, compiled for this machine and loaded: many scenarios at once."""

from __future__ import annotations

import ctypes
from weakref import WeakKeyDictionary

import numpy as np

from .build import Model
from .compiled import STATUS
from .emit.c import METHODS, CProject
from .errors import ScrewgenError, UsageError
from .library import load

FLAGS = ("-O2", "-march=native", "-ffp-contract=off")
"""Without contraction a machine with wider registers gives the same numbers."""

OK, NONFINITE, SINGULAR = range(3)
"""The statuses of a scenario."""

_written: WeakKeyDictionary[Model, dict[str, str]] = WeakKeyDictionary()
_loaded: WeakKeyDictionary[Model, dict[tuple, CompiledBatch]] = WeakKeyDictionary()


class _Batch(ctypes.Structure):
    """``<robot>_batch`` of the generated C."""

    _fields_ = (
        ("count", ctypes.c_int),
        ("stride", ctypes.c_int),
        ("own_constants", ctypes.c_int),
        ("q", ctypes.c_void_p),
        ("v", ctypes.c_void_p),
        ("hold", ctypes.c_int),
        ("tau", ctypes.c_void_p),
        ("tau_period", ctypes.c_size_t),
        ("w_ext", ctypes.c_void_p),
        ("w_ext_period", ctypes.c_size_t),
        ("q_path", ctypes.c_void_p),
        ("v_path", ctypes.c_void_p),
        ("status", ctypes.c_void_p),
        ("fault", ctypes.c_void_p),
        ("completed", ctypes.c_void_p),
    )


class CompiledBatch:
    """The batch of a robot in a shared library; arrays have the scenarios last.

    Raises :class:`ScrewgenError` where there is no C compiler or it does not take the flags.
    """

    def __init__(self, model: Model, single=False, openmp=False, flags=FLAGS, compiler: str | None = None):
        self.model, self.real = model, np.float32 if single else np.float64
        name = model.robot.name
        define = [f"-D{name.upper()}_REAL_FLOAT"] if single else []
        options = [*flags, *define, *(["-fopenmp"] if openmp else [])]
        self.library = load(_files(model), options, compiler)

    def constants(self, p: np.ndarray) -> np.ndarray:
        """The constants of robots with the parameters ``p`` (robots, n_parameters), as bytes (robots, size).

        Raises :class:`UsageError` naming the first whose parameters no robot has.
        """
        p, failed = np.ascontiguousarray(p, self.real), ctypes.c_int()
        out = np.zeros((len(p), self.library.shim_constants_size()), np.uint8)
        if status := self.library.shim_prepare(_pointer(p), len(p), _pointer(out), ctypes.byref(failed)):
            raise UsageError(
                f"parameters of scenario {failed.value}: {STATUS[status]}; lengths, masses and stiffnesses must be > 0"
            )
        return out

    def run(self, q, v, tau, w_ext, constants, dt: float, hold: int, method: str, threads: int) -> tuple:
        """Fill the paths ``q``, ``v`` (periods + 1, nq, batch) from their first rows on.

        ``tau`` and ``w_ext`` are (periods, n, batch), or (1, n, batch) for all periods.  Returns, for every
        scenario, status, link at fault and steps done, (batch,) each.
        """
        count, periods = q.shape[2], len(q) - 1
        status, fault, done = (np.full(count, x, np.int32) for x in (OK, -1, 0))
        q_now, v_now = q[0].copy(), v[0].copy()
        batch = _Batch(
            count=count,
            stride=count,
            own_constants=int(len(constants) > 1),
            q=_pointer(q_now),
            v=_pointer(v_now),
            hold=hold,
            tau=_pointer(tau),
            tau_period=tau[0].size if len(tau) > 1 else 0,
            w_ext=_pointer(w_ext),
            w_ext_period=w_ext[0].size if len(w_ext) > 1 else 0,
            q_path=_pointer(q[1:]),
            v_path=_pointer(v[1:]),
            status=_pointer(status),
            fault=_pointer(fault),
            completed=_pointer(done),
        )
        real = ctypes.c_float if self.real is np.float32 else ctypes.c_double
        number = METHODS.index(method)
        call = self.library.shim_batch(number, _pointer(constants), ctypes.byref(batch), real(dt), periods, threads)
        if call:
            raise ScrewgenError(f"the generated C reports: {STATUS[call]}")
        return status, fault, done


def _files(model: Model) -> dict[str, str]:
    """What a batch is compiled from; written once per model."""
    if model not in _written:
        project, name = CProject(model.chain, model.version, batch=True), model.robot.name
        library = (f"{name}_batch.c", f"{name}_parameters.c", f"{name}_real.c")
        files = {file: text for file, text in project.files().items() if file.endswith(".h") or file in library}
        _written[model] = files | {"shim.c": project.shim("batch_shim.c")}
    return _written[model]


def compiled_batch(model: Model, single: bool, openmp: bool) -> CompiledBatch:
    """The batch of a model, compiled when it is first asked for."""
    known = _loaded.setdefault(model, {})
    if (single, openmp) not in known:
        known[single, openmp] = CompiledBatch(model, single, openmp)
    return known[single, openmp]


def _pointer(array: np.ndarray) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)
