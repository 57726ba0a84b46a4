"""Simulation: time steps of the joint or DAE form, sampled into a run."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Any

import numpy as np

from ..arguments import MAX_STEPS, Given, Numbers, choice, seconds, whole
from ..errors import ScrewgenError, UsageError
from ..integrators.method import Method
from ..integrators.methods import method_of
from ..robot_model import RobotModel
from . import braked_steps, collocated, compiled_runs, hits
from .control_loop import Sampled
from .controllers import PD, Controller
from .dae import DaeStepper
from .failed_runs import Judge
from .inputs import Inputs, at_time, coordinates, started
from .integrate import EquationForm, JointStepper, left
from .mobility import check_closed, check_staying_closed
from .prescribed_motion import Curve, GivenMotion
from .recording import WATCH, Recorder, RunTask, SampleTable, Walk, check_size, stored
from .runs import FORMATS, Run, check_output

MakeStepper = Callable[[RobotModel, str | Method, Numbers], EquationForm]

FORMS: Mapping[str, MakeStepper] = MappingProxyType({"joint": JointStepper, "dae": DaeStepper})
"""The forms of the equations: name -> stepper, made with (model, integrator, p)."""

BACKENDS = ("c", "casadi")
FORMER = {"numpy": "casadi"}
"""Earlier names of back ends, which users' scripts may have."""
RELATIVE_SLACK = 1e-9
"""The relative tolerance within which a duration counts as a multiple of the step."""

Wrenches = Callable[[float, np.ndarray, np.ndarray], Any]


def simulate(
    model: RobotModel,
    duration: float,
    step: float,
    q0: Numbers | None = None,
    v0: Numbers | None = None,
    controller: Controller | Numbers | None = None,
    w_ext: Wrenches | Sequence[Sequence[float]] | np.ndarray | None = None,
    integrator: str | Method | None = None,
    form: str | MakeStepper = "joint",
    parameters: Given = None,
    progress: Callable[[int, int], None] | None = None,
    *,
    motion: Mapping[str, Curve] | None = None,
    backend: str | None = None,
    every: int = 1,
    store: str | os.PathLike[str] | None = None,
) -> Run:
    """The motion over `duration` seconds in steps of `step` seconds, sampled at every step or every `every`-th.

    `q0` (nq,), `v0` (nv,) or the joints alone, zero by default or at rest where a plan begins, a floating base at the
    inertial frame;
    `controller(t, q, v)` gives the joint torques
    (n_tau,), `w_ext(t, q, v)` the tip wrenches (n, 6), both once a step and held over it; arrays stand for
    constants. `integrator`: the name of one of :data:`screwgen.integrators.METHODS`, or a
    :class:`~screwgen.integrators.Method`; modal_midpoint if none is given. `form`: "joint", "dae", or what makes a
    stepper of one's own of `(model, integrator, p)`, such as
    `partial(CompiledStepper, compiled)`; its `default` is the integrator where none is given.
    `parameters`: all values, or those that differ from the file's by name. `progress(done, all)` is called
    now and then. A run has steps + 1 samples, or with `every` those of every so many steps and of the end; where
    `duration` is no multiple of `step` the last step is shorter and ends at `duration`.

    `motion`: of axes with `actuation = "motion"`, by the names of their coordinates: a spline of SciPy's, or a function
    of t that gives coordinate and rate. They are exactly there at the ends of steps, and accelerate evenly between.

    `backend`: "c" steps the joint form in the generated C, compiled when it is first needed and kept (`library`);
    constants and :class:`PD` stay in it, other controllers are called from it. "casadi" steps in Python, on functions
    of CasADi. By default "c" in the joint form where there is a compiler. The numbers agree to rounding.

    `store`: a .npz or .csv file for the run, which grows meanwhile as `run.part.npy` (`numpy.load` reads it, its
    fields are those of the run) or `run.part.csv`. A run that is stopped, fails or is killed leaves that file.

    The samples, and every eighth step at least, are watched for the limits of the model: `run.validity`, and a
    :class:`ModelValidityWarning` where one is passed, once for a model, link and measure. Another says where the points
    of a link of order "exact" were too few for its bends, and how many would do.

    With a controller the loop is examined beforehand as it is sampled, about the start and the set points of a
    :class:`PD`: a :class:`ControlLoopWarning` says where it is unstable at this step, and which step, gain or rotor
    would make it stable. Gains of other controllers are estimated by differences, but only if the function is
    smooth and has no side effects.

    Joints beyond their limits are looked for at every step: `run.hits`. A :class:`LimitWarning` says where one leaves a
    range that has no stop, and where the set points of a :class:`PD` lie beyond a limit. Every step keeps
    limits of efforts, and `tau` of the run has what acted; a :class:`LimitWarning` for each axis says when, how often.

    Raises UsageError on arguments that make no sense, SingularError in a posture whose mass matrix cannot be
    inverted, DivergedError when the method does not hold at this step, ModelLeftError, which is one too, when a link
    bends by more than its length. Such an error has the run until then as `error.run`.
    """
    steps, p = step_count(duration, step), model.chain.parameters.vector(parameters)
    if store is not None:
        check_output(store, FORMATS)
    every = whole(every, "every", 1)
    check_size(model, -(-steps // every) + 1)
    walk = (_c_walk if _in_c(backend, form, model, integrator) else _numpy_walk)(model, integrator, form, p)
    if q0 is None and (rest := getattr(controller, "rest", None)):
        q0 = rest(model, p)
    q0, v0 = coordinates(q0, "q0", model, p), coordinates(v0, "v0", model, p)
    moved = GivenMotion(model, motion, step, duration) if motion else None
    if moved is not None:
        moved.place(0.0, q0, v0)
    check_loops(model, p, q0, v0)
    braked_steps.warn(model, p, step)
    law = started(controller, q0, model, p, step)
    if isinstance(law, PD):
        hits.warn_goals(model, p, law.set_points)
    given = Inputs(model, law, w_ext, moved)
    table = SampleTable(model, time_grid(duration, step, every), p, q0, given)
    judge = Judge(Sampled(model, p, given, law, method_used(form, integrator), step, duration), q0, v0)
    try:
        with judge.of(table), stored(table, store):
            walk(RunTask(steps, step, duration, every, q0, v0, given, law, progress), table)
            run = table.run()
            hits.warn(run.hits)
            table.limited.warn(model)
            table.loops.warn()
            collocated.warn(model, collocated.left_out(model, run.q))
            return run
    except ScrewgenError as error:
        error.run = table.run(str(error)) if table.count else None
        raise


def _in_c(backend: str | None, form: str | MakeStepper, model: RobotModel, integrator: str | Method | None) -> bool:
    """Whether a run is stepped in C."""
    if backend is not None:
        backend = choice(FORMER.get(backend, backend), BACKENDS, "backend: there is no")
    if form != "joint":
        if backend == "c" and (callable(form) or form in FORMS):
            raise UsageError(
                f"the backend 'c' steps the joint form, not '{form}'; leave out backend, or choose form 'joint'"
            )
        return False
    return backend == "c" or (backend is None and compiled_runs.available(model, _method(integrator)))


def _method(integrator: str | Method | None) -> Method:
    """The method that steps the joint form."""
    return method_of(JointStepper.default if integrator is None else integrator)


def method_used(form: str | MakeStepper, integrator: str | Method | None) -> Method | None:
    """The method that a form steps by, as far as it is one of ours."""
    default = getattr(FORMS.get(form) if isinstance(form, str) else form, "default", None)
    try:
        return method_of(integrator or default or "")
    except UsageError:
        return None


def _c_walk(model: RobotModel, integrator: str | Method | None, form: str | MakeStepper, p: np.ndarray) -> Walk:
    method = _method(integrator)
    return compiled_runs.CompiledRuns(compiled_runs.instance(model, p, method), method)


def _numpy_walk(model: RobotModel, integrator: str | Method | None, form: str | MakeStepper, p: np.ndarray) -> Walk:
    plant = stepper(model, integrator, form, p)

    def walk(task: RunTask, table: SampleTable) -> None:
        record = Recorder(table)
        _check_posture(model, p, task.given, task.q0, task.v0)
        state, often = plant.initial(task.q0, task.v0), max(1, task.steps // 200)
        for k in range(task.steps + 1):
            t = task.time(k)
            with at_time(t):
                q, v = plant.coordinates(state)
                if task.given.motion is not None:
                    task.given.place(t, q, v)
                    state = plant.initial(q, v)
                tau, wrench = task.given(t, q, v)
                held = record.hold(q, v, tau)
                table.hits(t, q, v)
                if task.sampled(k) or k % WATCH == 0:
                    if not table.loops.look(t, q):
                        raise table.loops.opened()
                    felt = record.felt(q, v, held, wrench, plant.method.settling(task.step))
                    joints = record.look(t, q, v, held, felt)
                    if joints is None:
                        raise left(plant.method, table.watch)
                    if task.sampled(k):
                        table.acted(task.rows(k), wrench)
                        if model.chain.holds:
                            table.limited.take(np.array([t]), tau, held)
                        record(task.rows(k), q, v, joints, (held, felt))
                if k < task.steps:
                    before, given = state, (tau, wrench, task.reach(k))
                    state = plant.step(before, *given)
                    record.weigh(t, plant, before, state, given)
            if task.progress and (k % often == 0 or k == task.steps):
                task.progress(k, task.steps)
        record.check()

    return walk


def stepper(
    model: RobotModel,
    integrator: str | Method | None = None,
    form: str | MakeStepper = "joint",
    p: Numbers | None = None,
) -> EquationForm:
    """The stepper of a form and an integrator (None: the form's own choice) at the parameters `p`.

    Raises UsageError on unknown names.
    """
    make = form if callable(form) else FORMS[choice(form, FORMS, "there is no simulation in the form")]
    chosen = getattr(make, "default", None) if integrator is None else integrator
    if chosen is None:
        raise UsageError("this form names no integrator of its own; give one")
    return make(model, chosen, model.parameter_values if p is None else p)


# ------------------------------------------------------------------------------ what is given


def step_count(duration: float, step: float) -> int:
    """The number of steps to `duration`, the last one shorter if it is no multiple; raises UsageError."""
    duration, step = seconds(duration, "the duration"), seconds(step, "the step")
    if duration > MAX_STEPS * step:
        raise UsageError(f"duration / step is over {MAX_STEPS:g} steps; take a shorter duration or a longer step")
    nearest = round(duration / step)
    whole = nearest >= 1 and abs(duration / step - nearest) <= RELATIVE_SLACK * nearest
    return nearest if whole else math.ceil(duration / step)


def time_grid(duration: float, step: float, every: int = 1) -> np.ndarray:
    """The times of every `every`-th step from 0 on, and `duration`; raises UsageError."""
    return np.append(step * np.arange(0, step_count(duration, step), every), float(duration))


def check_loops(model: RobotModel, p: np.ndarray, q: np.ndarray, v: np.ndarray) -> None:
    """Refuse a start at which a loop is open or opens; raises UsageError."""
    if model.chain.closing.junctions:
        check_closed(model.numpy(p), "q0", q)
        check_staying_closed(model.chain, "v0", model.numpy(p).gaps(q, v)[1])


def _check_posture(model: RobotModel, p: np.ndarray, given: Inputs, q: np.ndarray, v: np.ndarray) -> None:
    """Refuse a singular start; the NumPy dynamics names the joint."""
    with at_time(0.0):
        model.numpy(p).forward_dynamics(q, v, *given(0.0, q, v))
