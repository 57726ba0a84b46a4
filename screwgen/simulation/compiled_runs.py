"""The loop of a run in the generated C: many steps per call, or one where Python computes the torques."""

from __future__ import annotations

import ctypes
import warnings

import numpy as np

from ..errors import ScrewgenError, SingularError, UsageError
from ..integrators.method import Method
from ..integrators.methods import METHODS
from ..robot_model import RobotModel
from ..runtime.compiled import Compiled
from ..runtime.compiling import compile_model
from ..runtime.differentiated import SINGULAR
from ..runtime.library import has_compiler
from ..runtime.pace import slices
from .controllers import PD
from .inputs import at_time
from .integrate import LIMIT, JointState, JointStepper, diverged, left
from .recording import WATCH, RunTask, SampleTable
from .validity import FAR

LEFT, OPEN = 16, 17
"""``SHIM_LEFT`` and ``SHIM_OPEN`` of the library."""

RUNAWAY = 1e4
"""A state with a number beyond this (rad, m, per second) means that the method diverges, not that it is singular."""


class _PD(ctypes.Structure):
    """``shim_pd`` of the library."""

    _fields_ = (
        *((name, ctypes.c_void_p) for name in ("kp", "kd", "goal", "start", "limit")),
        ("duration", ctypes.c_double),
    )


class _Run(ctypes.Structure):
    """``shim_run`` of the library."""

    _fields_ = (
        ("method", ctypes.c_int),
        ("steps", ctypes.c_int),
        ("every", ctypes.c_int),
        ("step", ctypes.c_double),
        ("duration", ctypes.c_double),
        ("most", ctypes.c_double),
        ("pd", ctypes.c_void_p),
        ("sampling", ctypes.c_int),
        ("watch", ctypes.c_int),
        ("far", ctypes.c_double),
        *((name, ctypes.c_void_p) for name in ("largest", "at", "first", "hits", "limited_first", "limited_count")),
        ("settling", ctypes.c_double),
        ("loops", ctypes.c_void_p),
    )


def _compiled(model: RobotModel, method: Method) -> Compiled:
    """The compiled model with a method, cached by the model."""
    return model.once(_key(method), lambda: compile_model(model, methods=added(method)))


def _key(method: Method) -> tuple:
    return "compiled", *added(method)


def added(method: Method) -> tuple[Method, ...]:
    """The methods that are not built in."""
    return () if method in METHODS.values() else (method,)


def instance(model: RobotModel, p: np.ndarray, method: Method) -> Compiled:
    """The model in C with memory of its own at the parameters `p`; compiled when it is first asked for."""
    compiled = _compiled(model, method)
    try:
        return compiled.fresh(p)
    except ScrewgenError:
        said = "parameters: no robot has these; lengths and stiffnesses must be > 0 and masses >= 0"
        raise UsageError(said + ", and no loop may be opened by them" * bool(model.chain.closing.idle)) from None


def available(model: RobotModel, method: Method) -> bool:
    """Whether the model can be compiled with a method; warns if there is a compiler and it fails."""
    try:
        if not model.made(_key(method)) and not has_compiler():
            return False
        return _compiled(model, method) is not None
    except ScrewgenError as error:
        warnings.warn(f"the run goes on in NumPy: {error}", stacklevel=4)
        return False


class CompiledRuns:
    """Runs of the joint form by an integrator, in C."""

    def __init__(self, compiled: Compiled, method: Method):
        self.compiled, self.method = compiled, method

    def __call__(self, task: RunTask, table: SampleTable) -> None:
        """Fill the table."""
        c, self.task, self.table = self.compiled, task, table
        table.limited.samples = len(table.times)
        number = c.number(self.method)
        arrays = (x.ctypes.data for x in (table.watch.values, table.watch.at, table.watch.first))
        run = (number, task.steps, task.every, task.step, task.duration, LIMIT, None, 0)
        self.plan = _Run(*run, WATCH, FAR, *arrays, ctypes.addressof(table.hits.plan) if table.hits.bounds else None)
        self.plan.limited_first, self.plan.limited_count = (
            x.ctypes.data for x in (table.limited.first, table.limited.count)
        )
        self.plan.settling = self.method.settling(task.step)
        self.plan.loops = ctypes.addressof(table.loops.seen)
        c.q[:], c.v[:] = task.q0, task.v0
        with at_time(0.0):
            c.tau[:], c.w_ext[:] = task.given(0.0, task.q0, task.v0)
        if task.progress:
            task.progress(0, task.steps)
        alone = not task.given.wrenches_vary and task.given.motion is None
        if type(task.law) is PD and task.law.plain and alone:
            self._take_law(task.law)
        asked = self.plan.pd is None and (task.given.torques_vary or task.given.wrenches_vary)
        asked = asked or task.given.motion is not None
        (self._step_by_step if asked else self._in_slices)(task)

    def _take_law(self, law: PD) -> None:
        """Run a PD law in the C; the arrays must live as long as the run."""
        path = law.duration is not None and law.q_start is not None
        powers = {"kp": -2, "kd": -2, "q_des": 1, "q_start": 1, "tau_max": -1}
        self._arrays = [None if name == "q_start" and not path else law.scaled(name, k) for name, k in powers.items()]
        self._law = _PD(*(None if a is None else a.ctypes.data for a in self._arrays), law.duration if path else 0.0)
        self.plan.pd = ctypes.addressof(self._law)

    def _in_slices(self, task: RunTask) -> None:
        """Run entirely in C, with as many steps per call as take about one slice of time."""
        for k, count in slices(task.steps + 1):
            self._call(k, count)
            self.table.filled(task.rows(k + count))
            if task.progress:
                task.progress(min(k + count, task.steps), task.steps)

    def _step_by_step(self, task: RunTask) -> None:
        """Run step by step, with torques or wrenches from Python."""
        c, often = self.compiled, max(1, task.steps // 200)
        for k in range(task.steps + 1):
            with at_time(task.time(k)):
                task.given.place(task.time(k), c.q, c.v)
                c.tau[:], c.w_ext[:] = task.given(task.time(k), c.q, c.v)
            if task.sampled(k):
                self.table.acted(task.rows(k), c.w_ext)
            self._call(k, 1)
            self.table.filled(task.rows(k + 1))
            if task.progress and k and (k % often == 0 or k == task.steps):
                task.progress(k, task.steps)

    def _call(self, k: int, count: int) -> None:
        """The steps k to k + count - 1 and their samples; the C returns before when it has many hits to hand over."""
        end = k + count
        while k < end:
            k += self._called(k, end - k)
            self.table.hits.drain()

    def _called(self, k: int, count: int) -> int:
        """Make these steps, and return how many were made."""
        rows, status = self.table.rows, ctypes.c_int()
        place = ctypes.c_void_p(rows.ctypes.data + rows.strides[0] * self.task.rows(k))
        call = self.compiled.library.shim_run_steps
        done = call(self.compiled.memory, ctypes.byref(self.plan), k, count, place, ctypes.byref(status))
        if status.value:
            self.table.filled(self.task.rows(k + done) + (not self.plan.sampling and self.task.sampled(k + done)))
            self._fail(k + done, status.value)
        return done

    def _fail(self, k: int, status: int) -> None:
        """Raise the error of step k, which is repeated by the NumPy stepper to find the reason."""
        c, task, p = self.compiled, self.task, self.table.p
        q, v = c.q.copy(), c.v.copy()
        with at_time(task.time(k)), np.errstate(all="ignore"):
            if status == LEFT:
                raise left(self.method, self.table.watch)
            if status == OPEN:
                raise self.table.loops.opened()
            tau, w_ext = task.given(task.time(k), q, v) if self.plan.pd else (c.tau.copy(), c.w_ext.copy())
            if k < task.steps:
                JointStepper(c.model, self.method, p).step(JointState(q, v), tau, w_ext, task.reach(k))
            if max(np.abs(q).max(initial=0.0), np.abs(v).max(initial=0.0)) > RUNAWAY:
                raise diverged(self.method)
            if status == SINGULAR:
                c.check(status)
            c.model.numpy(p).forward_dynamics(q, v, tau, w_ext)
            raise SingularError("a joint wrench is not finite; the motion passed through a singular posture")
