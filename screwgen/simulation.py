"""Simulation: steps of a form of the equations by a method, sampled into a run."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .controllers import Controller
from .dae import DaeStepper
from .errors import ScrewgenError, SingularError, UsageError
from .integrate import Dynamics, Evaluator, JointStepper, Stepper
from .runs import Run

if TYPE_CHECKING:
    from .build import Model

FORMS: dict[str, type[Stepper]] = {"joint": JointStepper, "dae": DaeStepper}
"""The forms of the equations: name -> stepper, made with (model, integrator, p)."""

MAX_STEPS = 10**8
MAX_BYTES = 4 * 2**30
RELATIVE_SLACK = 1e-9
"""A duration this close to a multiple of the step is one."""

Wrenches = Callable[[float, np.ndarray, np.ndarray], Any]


def simulate(
    model: Model,
    duration: float,
    step: float,
    q0: Sequence[float] | None = None,
    v0: Sequence[float] | None = None,
    controller: Controller | Sequence[float] | None = None,
    w_ext: Wrenches | Sequence[Sequence[float]] | None = None,
    integrator: str | None = None,
    form: str = "joint",
    parameters: Sequence[float] | Mapping[str, float] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Run:
    """The motion over `duration` seconds in steps of `step` seconds, sampled at every step.

    `q0`, `v0` (nq,) or the joints alone, zero by default; `controller(t, q, v)` gives the joint torques
    (n_joints,), `w_ext(t, q, v)` the tip wrenches (n, 6), both once a step and held over it; arrays stand for
    constants. `integrator`: one of `integrate.METHODS` in the joint form, modal_midpoint if none is named.
    `parameters`: all values, or those that differ from the file's by name. `progress(done, all)` is called
    now and then. A run has steps + 1 samples; where `duration` is no multiple of `step` the last step is
    shorter and ends at `duration`.

    Raises UsageError on arguments that make no sense, SingularError in a posture whose mass matrix cannot be
    inverted, DivergedError when the method does not hold at this step.
    """
    steps, p = step_count(duration, step), parameter_vector(model, parameters)
    plant = stepper(model, integrator, form, p)
    q0, v0 = coordinates(q0, "q0", model), coordinates(v0, "v0", model)
    given = Inputs(model, started(controller, q0), w_ext)
    record = Recorder(model, p, duration, step)
    _check_posture(model, p, given, q0, v0)
    state, every = plant.initial(q0, v0), max(1, steps // 200)
    for k in range(steps + 1):
        t = float(record.times[k])
        with at_time(t):
            q, v = plant.coordinates(state)
            tau, wrench = given(t, q, v)
            record(k, q, v, tau, wrench)
            if k < steps:
                state = plant.step(state, tau, wrench, step if k < steps - 1 else duration - t)
        if progress and (k % every == 0 or k == steps):
            progress(k, steps)
    return record.run()


def stepper(
    model: Model, integrator: str | None = None, form: str = "joint", p: Sequence[float] | None = None
) -> Stepper:
    """The stepper of a form and an integrator (None: the form's own choice) at the parameters `p`.

    Raises UsageError on unknown names.
    """
    if form not in FORMS:
        raise UsageError(f"there is no simulation in the form '{form}'; known: {', '.join(FORMS)}")
    chosen = FORMS[form].default if integrator is None else integrator
    return FORMS[form](model, chosen, model.parameter_values if p is None else p)


# ------------------------------------------------------------------------------ what is given


def step_count(duration: float, step: float) -> int:
    """How many steps reach `duration`, the last one shorter where it is no multiple; raises UsageError."""
    for name, value in (("duration", duration), ("step", step)):
        if not (math.isfinite(value) and value > 0):
            raise UsageError(f"the {name} is {value:g} s; it must be a finite number > 0")
    if duration > MAX_STEPS * step:
        raise UsageError(f"duration / step is over {MAX_STEPS:g} steps; take a shorter duration or a longer step")
    nearest = round(duration / step)
    whole = nearest >= 1 and abs(duration / step - nearest) <= RELATIVE_SLACK * nearest
    return nearest if whole else math.ceil(duration / step)


def time_grid(duration: float, step: float) -> np.ndarray:
    """The sample times 0, step, 2 step, …, duration (steps + 1,); raises UsageError."""
    return np.append(step * np.arange(step_count(duration, step)), float(duration))


def coordinates(values: Sequence[float] | None, name: str, model: Model) -> np.ndarray:
    """`values` as (nq,); the joints alone leave the modes at zero."""
    given = np.ravel(_floats([] if values is None else values, name))
    if len(given) not in (0, model.n_joints, model.nq):
        allowed = f"{model.nq}, or {model.n_joints} for the joints alone"
        raise UsageError(f"{name} has length {len(given)}; it must have {allowed}")
    return np.append(given, np.zeros(model.nq - len(given)))


def parameter_vector(model: Model, parameters: Sequence[float] | Mapping[str, float] | None) -> np.ndarray:
    """All parameter values; names in a mapping override the robot file's."""
    if isinstance(parameters, Mapping):
        values = dict(zip(model.parameter_names, model.parameter_values, strict=True))
        if unknown := [name for name in parameters if name not in values]:
            raise UsageError(f"parameters: there is no '{unknown[0]}'; see model.parameter_names")
        parameters = list((values | dict(parameters)).values())
    out = np.ravel(_floats(model.parameter_values if parameters is None else parameters, "parameters"))
    if len(out) != len(model.parameter_names):
        raise UsageError(f"parameters has length {len(out)}; it must have {len(model.parameter_names)}")
    return out


def started(controller: Any, q0: np.ndarray) -> Any:
    """The controller at the start of a run: one with `starting_at(q)` is asked for itself there."""
    return controller.starting_at(q0) if hasattr(controller, "starting_at") else controller


class Inputs:
    """Torques (n_joints,) and tip wrenches (n, 6) at an instant, from functions, constants or nothing."""

    def __init__(self, model: Model, controller: Any, w_ext: Any):
        self.sources = (
            _source(controller, "the controller", (model.n_joints,)),
            _source(w_ext, "w_ext", (model.n_links, 6)),
        )

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        torque, wrench = self.sources
        return torque(t, q, v), wrench(t, q, v)


def _source(given: Any, name: str, shape: tuple[int, ...]) -> Callable:
    if callable(given):
        return lambda t, q, v: _shaped(given(t, q.copy(), v.copy()), name, shape)
    constant = np.zeros(shape) if given is None else _shaped(given, name, shape)
    return lambda t, q, v: constant


def _shaped(values: Any, name: str, shape: tuple[int, ...]) -> np.ndarray:
    out = _floats(values, name)
    if out.size != math.prod(shape):
        raise UsageError(f"{name} gives an array of shape {out.shape}; it must give {shape}")
    return out.reshape(shape)


def _floats(values: Any, name: str) -> np.ndarray:
    try:
        out = np.array(values, dtype=float)
    except (TypeError, ValueError):
        raise UsageError(f"{name} gives something else than numbers; it must give an array of numbers") from None
    if not np.isfinite(out).all():
        raise UsageError(f"{name} gives a NaN or an infinity; it must give finite numbers")
    return out


def _check_posture(model: Model, p: np.ndarray, given: Inputs, q: np.ndarray, v: np.ndarray) -> None:
    """Refuse a singular start; NumPy's dynamics knows the joint."""
    with at_time(0.0):
        model.numpy(p).forward_dynamics(q, v, *given(0.0, q, v))


class at_time:
    """Puts the time in front of an error inside."""

    def __init__(self, t: float):
        self.t = t

    def __enter__(self) -> None:
        return None

    def __exit__(self, kind: type | None, error: BaseException | None, _: object) -> None:
        if isinstance(error, ScrewgenError):
            raise type(error)(f"t = {self.t:.6g} s: {error}") from None


# ------------------------------------------------------------------------------ what is kept


class Recorder:
    """The arrays of a run while they fill."""

    def __init__(self, model: Model, p: np.ndarray, duration: float, step: float):
        widths = {"q": model.nq, "v": model.nq, "tau": model.n_joints}
        widths |= {"wrench": 6 * model.n_links, "tip_position": 3, "energy": 2}
        samples = step_count(duration, step) + 1
        if (size := 8 * samples * (1 + sum(widths.values()))) > MAX_BYTES:
            raise UsageError(f"the run would take {size / 1e9:.0f} GB; take a shorter duration or a longer step")
        functions = model.casadi()
        self.model, self.p, self.dynamics = model, p, Dynamics(model, p)
        self.energy, self.tip_pose = Evaluator(functions["energy"]), Evaluator(functions["tip_pose"])
        self.times = time_grid(duration, step)
        self.arrays = {"t": self.times} | {name: np.zeros((samples, width)) for name, width in widths.items()}

    def __call__(self, k: int, q: np.ndarray, v: np.ndarray, tau: np.ndarray, w_ext: np.ndarray) -> None:
        """Keep sample `k`."""
        sample = {
            "q": q,
            "v": v,
            "tau": tau,
            "wrench": self.dynamics.explicit(q, v, tau, w_ext)[1],
            "tip_position": self.tip_pose(q, self.p)[1],
            "energy": np.concatenate(self.energy(q, v, self.p)),
        }
        for name, values in sample.items():
            self.arrays[name][k] = values

    def run(self) -> Run:
        """The run; raises SingularError where a joint wrench is no number."""
        m, arrays = self.model, self.arrays
        if not np.isfinite(arrays["wrench"]).all():
            raise SingularError("a joint wrench is not finite; the motion passed through a singular posture")
        wrench = arrays["wrench"].reshape(len(arrays["t"]), m.n_links, 6)
        names = {f"{kind}_names": tuple(getattr(m, f"{kind}_names")) for kind in ("q", "v", "tau", "wrench")}
        return Run(m.robot.name, **(arrays | {"wrench": wrench}), **names)
