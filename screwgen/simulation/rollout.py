"""Rollouts: many motions of one robot at once, for sampling MPC, Monte-Carlo studies and learning."""

from __future__ import annotations

import math
from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from ..algorithms.gauges import base_strains
from ..arguments import Given, real_numbers, seconds, whole
from ..errors import UsageError
from ..integrators.method import Method
from ..integrators.methods import method_of
from ..robot_model import RobotModel
from ..runtime.batch import OK, SINGULAR, CompiledBatch, compiled_batch
from ..runtime.differentiated import NO_METHOD
from ..topology.coordinates import SLACK
from . import collocated
from .chunks import How, in_chunks, merged
from .compiled_runs import added
from .measured import is_measured
from .rollout_loops import opened
from .rollout_samples import Source
from .rollout_validity import warn_refused, watched
from .runs import REPORTED
from .validity import Validity

MAX_BYTES = 4 * 2**30
COMPUTED = ("wrench", "tip_position", *REPORTED)
REFUSED, OPEN = 3, 4
"""The statuses of scenarios whose parameters no robot can have, and whose loops are open."""


@dataclass(frozen=True, repr=False)
class Rollout:
    """The motions of a batch of scenarios; SI units, radians.

    ``t`` (steps + 1,): sample times; ``q`` (batch, steps + 1, nq), ``v`` (.., nv): coordinates in their order and their
    rates, views of arrays that hold the scenarios side by side. ``status`` (batch,): 0 for a scenario that completed, 1
    where the state or a result is not finite (a bad input, or the motion diverged), 2 where a joint or mode could not
    be solved for, 3 where its parameters are those of no robot, 4 where a loop is open; that scenario keeps its last
    good state from there on.
    ``completed`` (batch,): how many steps it made; ``fault`` (batch,): after 2 the link's number, else -1.

    Computed when first asked for, at every sample, NaN where there is none, the last input held on at the end:
    ``wrench`` (batch, steps + 1, n, 6), joint wrenches [τ; F], what link i−1 exerts on link i, in F_i components;
    ``tip_position`` (.., 3), the last link's tip in the inertial frame, m; what functions report, as ``energy`` (..,
    2), kinetic, potential, J, and ``drive_power`` (.., n_tau), W; what sensors measure at markers, see
    :class:`.runs.Run`.
    """

    t: np.ndarray
    q: np.ndarray
    v: np.ndarray
    status: np.ndarray
    completed: np.ndarray
    fault: np.ndarray
    links: tuple[str, ...]
    validity: Validity
    """The largest validity measures: deflection and slope of all samples, loads of some, the fastest included."""
    refused: Mapping[int, str] = field(default_factory=dict)
    """What is wrong with the parameters of scenarios of status 3."""
    source: Source | None = field(default=None, compare=False)
    """The model and the inputs."""

    def __repr__(self) -> str:
        count, samples, _ = self.q.shape
        stopped = f", {count - self.ok.sum()} stopped: see report()" if not self.ok.all() else ""
        return f"<Rollout of {count} scenarios, {samples - 1} steps to {self.t[-1]:.6g} s{stopped}>"

    @property
    def ok(self) -> np.ndarray:
        """Which scenarios completed (batch,)."""
        return self.status == OK

    @property
    def x(self) -> np.ndarray:
        """The states [q; v], (batch, steps + 1, nq + nv)."""
        return np.concatenate([self.q, self.v], axis=2)

    def __getattr__(self, name: str) -> np.ndarray:
        """What follows from the motions, by name: computed when it is first asked for, in double precision."""
        robot = self.source.model.robot if self.source else None
        if name in self.__dict__ or not (name in COMPUTED or is_measured(name, robot)):
            raise AttributeError(f"'Rollout' has no attribute '{name}'", name=name, obj=self)
        if name not in COMPUTED:
            return self.__dict__.setdefault(name, self._source.measured(name, self.q, self.v))
        quick = self._source.at_states(name, self.q, self.v) if name in self._source.shapes else None
        return self.__dict__.setdefault(name, self._samples[name] if quick is None else quick)

    @cached_property
    def tau(self) -> np.ndarray:
        """(batch, steps + 1, n_tau): the inputs as steps from the samples on hold them, within limits of efforts."""
        return self._source.applied(self.q, self.v)

    @cached_property
    def base_strain(self) -> np.ndarray:
        """(batch, steps + 1, strains): as the output ``base_strain`` of :meth:`screwgen.Model.linearise`, its order."""
        return self.strain[:, :, : base_strains(self._source.model.chain)]

    @cached_property
    def _samples(self) -> dict[str, np.ndarray]:
        return self._source.samples(self.q, self.v)

    @property
    def _source(self) -> Source:
        if self.source is None:
            raise UsageError("this rollout holds no model; take the one that screwgen.rollout returns")
        return self.source

    def report(self) -> list[str]:
        """One line for every scenario that stopped: when, and why."""
        return [self._line(int(i)) for i in np.flatnonzero(~self.ok)]

    def _line(self, i: int) -> str:
        why = self.refused.get(i, "its state or a result is not finite")
        if self.status[i] == OPEN:
            why = "a loop is open; start from what screwgen.assemble gives, or take shorter steps"
        if self.status[i] == SINGULAR:
            link = self.links[self.fault[i]]
            why = f"link '{link}' cannot be solved for: its joint is singular in this posture, or the motion diverged"
        return f"scenario {i} stopped at t = {self.t[self.completed[i]]:.6g} s: {why}"


def rollout(
    model: RobotModel,
    x0: Any,
    tau: Any = None,
    *,
    step: float,
    steps: int | None = None,
    substeps: int = 1,
    w_ext: Any = None,
    integrator: str | Method = "modal_midpoint",
    parameters: Given = None,
    threads: int = 1,
    single: bool = False,
    executor: Executor | None = None,
) -> Rollout:
    """Roll out a batch of scenarios in the compiled C, as many at a time as a vector register has lanes.

    `x0`: initial states [q; v], (batch, nq + nv), or (nq + nv,) for all; the quaternion of a floating base has length 1
    to a thousandth and is scaled to it. `tau`: joint torques in N·m, (batch, steps, n_tau); (steps, n_tau) for all
    scenarios; (n_tau,) for all and held; zero by default. `w_ext`: tip wrenches [τ; F] likewise, (batch, steps, n, 6),
    (steps, n, 6) or (n, 6). An input is held over a sample of `step` seconds, which the integrator, by name or a
    :class:`~screwgen.integrators.Method`, divides into `substeps` steps, which keep limits of efforts. `steps` is
    needed where no sequence says it. `parameters`: one vector as `model.parameter_values`, or (batch, n); or those that
    differ by name, each a number or (batch,). `threads`: cores. `single`: in single precision, in half the time.
    `executor`: any of ``concurrent.futures``, which gets chunks of scenarios, those of lost workers again;
    :func:`screwgen.sweep` keeps more than memory holds.

    The batch is compiled with the first call for a model (seconds). Arguments are broadcast to one batch size. Where a
    link is past the bounds of the model a :class:`ModelValidityWarning` says so (`Rollout.validity`), also where the
    points of a link of order "exact" are too few for the states in which it bends most.
    A scenario that fails is reported in `Rollout.status` and keeps its state; the others go on. Raises UsageError on
    arguments that make no sense, ScrewgenError where the C cannot be compiled.
    """
    how = How(step, substeps, method_of(integrator, missing=NO_METHOD), threads, single)
    given, count, how = checked(model, {"x0": x0, "tau": tau, "w_ext": w_ext, "parameters": parameters}, steps, how)
    if len(given["parameters"]) == 1:
        model.chain.parameters.check(given["parameters"])
    if executor is None:
        run = rolled(model, given, count, how)
    else:
        found = joined(in_chunks(rolled, model, given, count, how, executor))
        run = replace(found, source=Source(model, given, how.settling))
    warn_refused(run.refused, len(run.refused), "report()")
    run.validity.warn(model, stacklevel=2)
    run._source.limited(run.t, run.q, run.v).warn(model)
    collocated.warn(model, collocated.left_out(model, run.q))
    return run


def checked(
    model: RobotModel, asked: Mapping[str, Any], steps: int | None, how: How
) -> tuple[dict[str, np.ndarray], int, How]:
    """What :func:`rolled` takes: arrays of `x0`, `tau`, `w_ext`, `parameters`, their number of scenarios, and how."""
    _check_numbers(how.step, steps, how.substeps, how.threads)
    tau, w_ext = asked["tau"], asked["w_ext"]
    given = {
        "x0": _states(asked["x0"], model),
        "tau": _sequence(tau, "tau", (model.n_tau,)),
        "w_ext": _sequence(w_ext, "w_ext", (model.n_links, 6)),
        "parameters": _parameters(asked["parameters"], model),
    }
    count = _common({name: len(a) for name, a in given.items()}, "scenarios")
    periods = _periods(steps, {"tau": np.shape(tau)[:-1], "w_ext": np.shape(w_ext)[:-2]})
    _check_size(count, periods, model)
    return given, count, how._replace(periods=periods)


def rolled(model: RobotModel, given: Mapping[str, np.ndarray], count: int, how: How) -> Rollout:
    """The motions of scenarios whose arguments are checked, without warnings."""
    step, substeps, method, threads, single, periods = how
    batch = compiled_batch(model, single, added(method))
    starts = np.split(np.broadcast_to(given["x0"], (count, model.nq + model.chain.nvz)).T, [model.nq])
    path = [np.empty((periods + 1, *start.shape), batch.real) for start in starts]
    for rows, start in zip(path, starts, strict=True):
        rows[0] = start
    p, constants, refused = _constants(model, batch, given["parameters"])
    if refused and len(p) < count:
        raise UsageError(refused[0])
    given = {**given, "parameters": p}
    tau, w_ext = (_rows(given[name], count, batch.real) for name in ("tau", "w_ext"))
    status, fault, done = batch.run(path[0], path[1], tau, w_ext, constants, step / substeps, substeps, method, threads)
    q, v = (rows.transpose(2, 0, 1) for rows in path)
    done //= substeps
    for k, first in enumerate(opened(model, p, q)):
        if first <= done[k]:
            status[k], done[k] = OPEN, max(first - 1, 0)
            q[k, first:], v[k, first:] = q[k, done[k]], v[k, done[k]]
    for k in refused:
        status[k], done[k], fault[k], q[k], v[k] = REFUSED, 0, -1, q[k, 0], v[k, 0]
    t = step * np.arange(periods + 1)
    found = watched(model, given, t, q, v, how.settling), refused, Source(model, given, how.settling)
    return Rollout(t, q, v, status, done, fault, tuple(model.chain.names), *found)


def _constants(model: RobotModel, batch: CompiledBatch, p: np.ndarray) -> tuple[np.ndarray, np.ndarray, dict[int, str]]:
    """Parameters (batch or 1, n), constants, and what is wrong with those of scenarios that have the file's instead."""
    own = model.chain.parameters
    refused = own.refused(p)
    p = np.where(np.isin(np.arange(len(p)), list(refused))[:, None], own.values, p)
    constants, more = batch.prepared(p)
    refused |= more
    if more:
        p[list(more)], constants[list(more)] = own.values, batch.constants(own.values[None])
    return p, constants, refused


def joined(runs: list[Rollout]) -> Rollout:
    """Rollouts one behind the other."""
    names = ("q", "v", "status", "completed", "fault")
    stacked: dict[str, Any] = {name: np.concatenate([getattr(run, name) for run in runs]) for name in names}
    starts = np.cumsum([0, *(len(run.status) for run in runs)])
    refused = {k + start: said for run, start in zip(runs, starts, strict=False) for k, said in run.refused.items()}
    validity = merged([run.validity for run in runs])
    return Rollout(t=runs[0].t, **stacked, links=runs[0].links, validity=validity, refused=refused)


def _rows(values: np.ndarray, count: int, real: type) -> np.ndarray:
    """A sequence (batch or 1, periods, n) with the scenarios last: (periods, n, batch)."""
    whole = np.broadcast_to(values, (count, *values.shape[1:]))
    return np.ascontiguousarray(whole.transpose(1, 2, 0), real)


# ------------------------------------------------------------------------------ what is given


def _check_numbers(step: float, steps: int | None, substeps: int, threads: int) -> None:
    seconds(step, "step")
    for name, value, least in (("steps", steps, 0), ("substeps", substeps, 1), ("threads", threads, 1)):
        if value is not None:
            whole(value, name, least)


def _floats(values: Any, name: str) -> np.ndarray:
    out = real_numbers(values)
    if out is None:
        raise UsageError(f"{name} is not an array of numbers; give nested lists of one length, or an array")
    return out


def _ends_in(array: np.ndarray, shape: tuple[int, ...], more: int) -> bool:
    """Whether the last axes are ``shape``, with at most ``more`` before them."""
    lead = array.ndim - len(shape)
    return 0 <= lead <= more and array.shape[lead:] == shape


def _array(values: Any, name: str, shape: tuple[int, ...], allowed: str) -> np.ndarray:
    """An array with one axis in front of ``shape``."""
    out = _floats(values, name)
    if not _ends_in(out, shape, 1):
        ending = f", here ending in {shape}" if shape else ""
        raise UsageError(f"{name} has the shape {out.shape}; it must be {allowed}{ending}")
    return out if out.ndim > len(shape) else out[None]


def _states(values: Any, model: RobotModel) -> np.ndarray:
    """Initial states, (batch or 1, nq + nv)."""
    count, sizes = model.nq + model.chain.nvz, "nq + nv" if model.chain.curved else "2 nq"
    out = _array(values, "x0", (count,), f"(batch, {sizes}) or ({sizes},)")
    for part in model.chain.curved:
        first = part.q.start + (part.joint.turn_at or 0)
        length = np.linalg.norm(out[:, first : first + 4], axis=1, keepdims=True)
        for k in np.flatnonzero(~(np.abs(length[:, 0] - 1) <= SLACK))[:1]:
            said = f"entries {first} to {first + 3} (w, x, y, z) of scenario {k}"
            raise UsageError(f"x0 has a quaternion of length {length[k, 0]:.6g}, {said}; it must have length 1")
        out = np.hstack([out[:, :first], out[:, first : first + 4] / length, out[:, first + 4 :]])
    return out


def _sequence(values: Any, name: str, shape: tuple[int, ...]) -> np.ndarray:
    """An input as (batch or 1, periods or 1, entries)."""
    out = np.zeros(shape) if values is None else _floats(values, name)
    if not _ends_in(out, shape, 2):
        raise UsageError(
            f"{name} has the shape {out.shape}; it must be (batch, steps), (steps) or nothing before {shape}"
        )
    lead = (1,) * (len(shape) + 2 - out.ndim) + out.shape[: out.ndim - len(shape)]
    return out.reshape(*lead, math.prod(shape))


def _parameters(given: Given, model: RobotModel) -> np.ndarray:
    """Parameter vectors, (batch or 1, n)."""
    known = model.chain.parameters
    if isinstance(given, Mapping):
        columns = {
            name: _array(value, f"parameters['{name}']", (), "a number or (batch,)") for name, value in given.items()
        }
        count = _common({f"parameters['{name}']": len(c) for name, c in columns.items()}, "scenarios")
        out = np.tile(known.values, (count, 1))
        for name, column in columns.items():
            out[:, known.place(name)] = column
    else:
        out = _array(known.values if given is None else given, "parameters", known.values.shape, "(batch, n) or (n,)")
    return out


def _common(lengths: Mapping[str, int], what: str) -> int:
    """The common length; lengths of 1 are broadcast."""
    several = {name: n for name, n in lengths.items() if n != 1}
    if len(set(several.values())) > 1:
        text = ", ".join(f"{name} {n}" for name, n in several.items())
        raise UsageError(f"the numbers of {what} differ: {text}; give one number of them, or one for all")
    return next(iter(several.values()), 1)


def _periods(steps: int | None, leads: Mapping[str, tuple[int, ...]]) -> int:
    """The number of steps; ``leads`` are the axes (batch, steps) of the inputs, empty for held ones."""
    lengths = {name: lead[-1] for name, lead in leads.items() if lead}
    if steps is None:
        if not lengths:
            raise UsageError("nothing says how many steps there are; give steps, or a sequence of torques")
        return _common(lengths, "steps")
    if wrong := [f"{name} has {n}" for name, n in lengths.items() if n not in (1, steps)]:
        raise UsageError(f"steps is {steps}, but {wrong[0]}; give one number of steps, or one input for all")
    return steps


def _check_size(count: int, periods: int, model: RobotModel) -> None:
    size = 8 * count * (periods + 1) * max(model.nq + model.chain.nvz, 1)
    if size > MAX_BYTES:
        raise UsageError(f"the rollout would take {size / 1e9:.0f} GB; take fewer scenarios or steps")
