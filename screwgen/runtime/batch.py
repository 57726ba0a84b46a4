"""The batch of the generated C, compiled for this machine and loaded: many scenarios at once."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np

from ..errors import ScrewgenError, UsageError
from ..integrators.method import Method
from ..integrators.methods import with_built_in
from ..robot_model import RobotModel
from .asked import digest
from .differentiated import STATUS, known
from .lean import RuntimeProject
from .library import load
from .memory import pointer
from .pace import FIRST, slices

FLAGS = ("-O2", "-march=native", "-ffp-contract=off")
"""Without contraction the results do not depend on the width of the registers."""

OK, NONFINITE, SINGULAR = range(3)
"""The statuses of a scenario."""

BLOCK = 16
"""The largest number of lanes of any register; a thread's share of the scenarios is a multiple of it."""


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

    def __init__(
        self,
        model: RobotModel,
        single: bool = False,
        flags: Sequence[str] = FLAGS,
        compiler: str | None = None,
        methods: Sequence[Method] = (),
    ):
        self.model, self.real = model, np.float32 if single else np.float64
        name = model.robot.name
        define = [f"-D{name.upper()}_REAL_FLOAT"] if single else []
        self.methods = with_built_in(methods)
        files = lambda: model.once(("batch files", *methods), lambda: _files(model, methods))  # noqa: E731
        asked = digest("batch", model.robot, tuple(methods))
        self.library = load(files, [*flags, *define], compiler, asked=asked)

    def prepared(self, p: np.ndarray) -> tuple[np.ndarray, dict[int, str]]:
        """The constants of robots with the parameters ``p`` (robots, n_parameters), as bytes (robots, size).

        Beside them, what is wrong with robots whose parameters are invalid, by their number.
        """
        p, status = np.ascontiguousarray(p, self.real), np.zeros(len(p), np.int32)
        out = np.zeros((len(p), self.library.shim_constants_size()), np.uint8)
        self.library.shim_prepare(pointer(p), len(p), pointer(out), pointer(status))
        wrong = "parameters: {}; lengths, masses and stiffnesses must be > 0"
        return out, {int(k): wrong.format(STATUS[status[k]]) for k in np.flatnonzero(status)}

    def constants(self, p: np.ndarray) -> np.ndarray:
        """The constants of :meth:`prepared`; raises :class:`UsageError` where the parameters of a robot are invalid."""
        out, refused = self.prepared(p)
        for k, said in refused.items():
            raise UsageError(f"scenario {k}: {said}")
        return out

    def run(
        self,
        q: np.ndarray,
        v: np.ndarray,
        tau: np.ndarray,
        w_ext: np.ndarray,
        constants: np.ndarray,
        dt: float,
        hold: int,
        method: str | Method,
        threads: int,
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Fill the paths ``q`` (periods + 1, nq, batch) and ``v`` (.., nv, batch) from their first rows on.

        ``tau`` and ``w_ext`` are (periods, n, batch), or (1, n, batch) for all periods.  Returns, for every
        scenario, status, link at fault and steps done, (batch,) each.  Can be interrupted.
        """
        status, fault, done = (np.full(q.shape[2], x, np.int32) for x in (OK, -1, 0))
        task = _Task(q, v, tau, w_ext, constants, hold, q[0].copy(), v[0].copy(), status, fault)
        real = ctypes.c_float if self.real is np.float32 else ctypes.c_double
        step = getattr(self.library, f"{self.model.robot.name}_step_batch_{known(method, self.methods)}")

        def call(first: int, size: int, k: int, periods: int) -> None:
            """Some periods of the scenarios from `first` on."""
            own = task.constants[first if len(constants) > 1 else 0 :]
            batch, made = task.part(first, size, k), np.zeros(size, np.int32)
            batch.completed = pointer(made)
            if failed := step(pointer(own), ctypes.byref(batch), real(dt), periods):
                raise ScrewgenError(f"the generated C reports: {STATUS[failed]}")
            done[first : first + size] += made

        _in_threads(call, blocks(q.shape[2], threads), len(q) - 1)
        return status, fault, done


class _Task(NamedTuple):
    """The arrays that a batch reads and writes."""

    q: np.ndarray
    v: np.ndarray
    tau: np.ndarray
    w_ext: np.ndarray
    constants: np.ndarray
    hold: int
    q_now: np.ndarray
    v_now: np.ndarray
    status: np.ndarray
    fault: np.ndarray

    def part(self, first: int, size: int, k: int) -> _Batch:
        """The scenarios from `first` on, from period k on."""
        count, held = self.q.shape[2], dict[str, ctypes.c_void_p | int]()
        for name in ("tau", "w_ext"):
            values = getattr(self, name)
            varies = len(values) > 1
            held[name] = pointer(values[k if varies else 0, :, first:])
            held[f"{name}_period"] = values[0].size if varies else 0
        return _Batch(
            count=size,
            stride=count,
            own_constants=int(len(self.constants) > 1),
            q=pointer(self.q_now[:, first:]),
            v=pointer(self.v_now[:, first:]),
            hold=self.hold,
            q_path=pointer(self.q[k + 1, :, first:]),
            v_path=pointer(self.v[k + 1, :, first:]),
            status=pointer(self.status[first:]),
            fault=pointer(self.fault[first:]),
            **held,
        )


def blocks(count: int, threads: int) -> list[tuple[int, int]]:
    """The first scenario and the number of them for every thread; a block fills the lanes of registers."""
    size = -(-count // (threads * BLOCK)) * BLOCK
    return [(first, min(size, count - first)) for first in range(0, count, max(size, 1))]


def _in_threads(call: Callable[[int, int, int, int], None], shares: Sequence[tuple[int, int]], periods: int) -> None:
    """Work on blocks of scenarios, each in a thread, by parts between which all can be stopped.

    The threads are Python's, which run in parallel inside the C; OpenMP's threads do not survive a fork.
    """
    over = threading.Event()

    def work(first: int, size: int) -> None:
        for k, part in slices(periods, max(1, FIRST // size)):
            if over.is_set():
                break
            call(first, size, k, part)

    if len(shares) == 1:
        return work(*shares[0])
    with ThreadPoolExecutor(max(1, len(shares))) as pool:
        try:
            for done in [pool.submit(work, *share) for share in shares]:
                done.result()
        finally:
            over.set()


def _files(model: RobotModel, methods: Sequence[Method]) -> dict[str, str]:
    """The sources of a batch."""
    project, name = RuntimeProject(model.chain, model.version, batch=True, methods=methods), model.robot.name
    library = (f"{name}_batch.c", f"{name}_parameters.c", f"{name}_real.c")
    files = project.some(lambda file: file.endswith(".h") or file in library)
    return files | {"shim.c": project.shim("batch_shim.c")}


def compiled_batch(model: RobotModel, single: bool, methods: Sequence[Method] = ()) -> CompiledBatch:
    """The batch of a model, compiled when it is first asked for and kept by the model."""
    return model.once(("batch", single, *methods), lambda: CompiledBatch(model, single, methods=methods))
