"""Sweeps: rollouts of any number of scenarios in chunks, on any executor, into a file.

A chunk draws its scenarios from a seed of its own, so results depend on neither the executor nor the number of its
workers. Beside the store a manifest lists the finished chunks: a sweep that was stopped goes on there.
"""

from __future__ import annotations

import hashlib
import inspect
import os
import pickle
import sys
from collections.abc import Callable, Mapping
from concurrent.futures import Executor
from concurrent.futures.thread import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..arguments import whole
from ..errors import UsageError
from ..integrators.method import Method
from ..integrators.methods import method_of
from ..robot_model import RobotModel
from ..runtime.differentiated import NO_METHOD
from ..version import __version__ as VERSION
from . import collocated
from .chunks import CHUNK, HERE, How, completed, merged, ready, unpacked
from .collocated import LeftOut, left_out, worst_of
from .limited_inputs import LimitedInputs
from .rollout import Rollout, checked, rolled
from .rollout_validity import warn_refused
from .store import Store
from .validity import Validity

if TYPE_CHECKING:
    import zarr


NUMBERS = "?bhilqBHILQefdFD"
"""What may be kept: the types that every store holds."""
ARGUMENTS = ("x0", "tau", "w_ext", "parameters")

Draw = Callable[[np.random.Generator, int], Mapping[str, Any]]
Keep = Callable[[Rollout], np.ndarray]


@dataclass(frozen=True, repr=False)
class Sweep:
    """The results of a sweep: ``values`` (count, ...), an array on disk; ``status`` (count,) as of a rollout."""

    values: np.ndarray | zarr.Array
    status: np.ndarray

    @property
    def ok(self) -> np.ndarray:
        """Which scenarios completed (count,)."""
        return self.status == 0

    def __repr__(self) -> str:
        return f"<Sweep of {len(self.status)} scenarios, {(~self.ok).sum()} stopped; values {self.values.shape}>"


def final(run: Rollout) -> np.ndarray:
    """The last states [q; v] (batch, nq + nv)."""
    return run.x[:, -1]


def sweep(
    model: RobotModel,
    draw: Draw,
    count: int,
    store: str | os.PathLike,
    *,
    step: float,
    steps: int,
    keep: Keep = final,
    seed: int = 0,
    chunk: int = CHUNK,
    executor: Executor | None = None,
    substeps: int = 1,
    integrator: str | Method = "modal_midpoint",
    single: bool = False,
    progress: Callable[[int, int], object] | None = None,
) -> Sweep:
    """Roll out `count` scenarios in chunks and keep numbers of each in `store`, an ``.npy`` or ``.zarr``.

    ``draw(rng, n)`` gives `x0`, `tau`, `w_ext`, `parameters` of :func:`screwgen.rollout` for `n` scenarios, as a
    mapping; ``rng`` follows from `seed` and the chunk's number. ``keep(rollout)`` gives what is kept, (n, ...) of one
    type, by default the last states. `executor`: any of ``concurrent.futures``; one thread by default. Where its
    workers are processes, `draw` and `keep` must be functions of a module; each process derives and compiles the robot
    once. `progress` is told how many scenarios are done, and of how many. Memory holds some chunks, never all.

    Called again, with the same arguments, it does the chunks that are missing; a store of another robot or of other
    arguments is refused. The bits are those of one machine; processors with other instructions may differ in the last
    bits of elementary functions alone. Raises UsageError, and ScrewgenError where chunks fail.
    """
    whole(count, "count", 1, 10**12)
    whole(chunk, "chunk", 1)
    whole(seed, "seed", 0)
    options = {
        "step": step,
        "steps": steps,
        "substeps": substeps,
        "integrator": integrator,
        "threads": 1,
        "single": single,
    }
    packed = None if isinstance(executor, ThreadPoolExecutor | None) else _packed(model, draw, keep, options)
    task = SweepTask(_digest(model, draw, keep, options, count, chunk, seed), count, chunk, seed, packed)
    if packed is None:
        HERE[task.digest] = (model, draw, keep, options)
    target = Store(Path(store), task.digest, count, chunk)
    try:
        with target:
            if executor is None:
                with ThreadPoolExecutor(1) as own:
                    found = _run(own, task, target, progress)
            else:
                found = _run(executor, task, target, progress)
    finally:
        HERE.pop(task.digest, None)
    if found is not None:
        found.validity.warn(model, stacklevel=2)
        collocated.warn(model, found.errors)
        found.limited.warn(model)
        warn_refused(found.refused, found.failed, "status")
    return Sweep(*target.result())


@dataclass(frozen=True)
class SweepTask:
    """What a worker is told: `packed` holds the model and the functions, unless it shares the memory."""

    digest: str
    count: int
    chunk: int
    seed: int
    packed: bytes | None

    def size(self, k: int) -> int:
        """The number of scenarios of chunk k."""
        return min(self.chunk, self.count - k * self.chunk)

    @property
    def chunks(self) -> int:
        return -(-self.count // self.chunk)


def _packed(*what: Any) -> bytes:
    try:
        return pickle.dumps(what)
    except (pickle.PicklingError, AttributeError, TypeError) as error:
        said = "draw and keep must be functions of a module"
        raise UsageError(f"the task cannot be sent to other processes: {error}; {said}") from None


def _digest(model: RobotModel, draw: Draw, keep: Keep, options: dict, *numbers: int) -> str:
    with np.printoptions(threshold=sys.maxsize, floatmode="unique"):
        said = [VERSION, _said(model), _said(options), _said(numbers), _said(draw), _said(keep)]
    return hashlib.sha256("\n".join(said).encode()).hexdigest()


def _said(what: Any) -> str:
    """What tells one sweep from another: numbers, robots, the source of functions and what is bound to them."""
    if hasattr(what, "robot"):
        return repr(what.robot.model_dump())
    if isinstance(what, partial):
        return _said((what.func, what.args, what.keywords))
    if isinstance(what, dict):
        return _said([x for pair in what.items() for x in pair])
    if isinstance(what, list | tuple):
        return f"({', '.join(map(_said, what))})"
    if not inspect.isfunction(what):
        return repr(what)
    inner = _said([cell.cell_contents for cell in what.__closure__ or ()] + list(what.__defaults__ or ()))
    try:
        return inspect.getsource(what) + inner
    except (TypeError, OSError):
        return f"{what.__module__}.{what.__qualname__}{inner}"


class Limits(NamedTuple):
    """What scenarios are warned of: how near they come to the limits of the model, what the points of exact rods leave
    out in them, the inputs that are limited, and the parameters that no robot has: those of the first scenario, and
    how many have such."""

    validity: Validity
    errors: tuple[LeftOut, ...]
    limited: LimitedInputs
    refused: Mapping[int, str]
    failed: int

    def joined(self, other: Limits) -> Limits:
        """Those of both."""
        refused = {**self.refused, **other.refused}
        return Limits(
            merged([self.validity, other.validity]),
            worst_of((*self.errors, *other.errors)),
            self.limited.joined(other.limited),
            {k: refused[k] for k in sorted(refused)[:1]},
            self.failed + other.failed,
        )


def work(task: SweepTask, k: int) -> tuple[np.ndarray, np.ndarray, Limits]:
    """Values, statuses and limits of chunk `k`; runs in a worker."""
    model, draw, keep, options = unpacked(task.digest, task.packed)
    ready(model, options["single"], options["integrator"])
    n, rng = task.size(k), np.random.default_rng([task.seed, k])
    given = dict(draw(rng, n))
    if wrong := given.keys() - set(ARGUMENTS) or {"x0"} - given.keys():
        raise UsageError(f"draw: wrong or missing is '{min(wrong)}'; it gives x0, and may {', '.join(ARGUMENTS[1:])}")
    method = method_of(options["integrator"], missing=NO_METHOD)
    how = How(options["step"], options["substeps"], method, options["threads"], options["single"])
    run = rolled(model, *checked(model, dict.fromkeys(ARGUMENTS) | given, options["steps"], how))
    values = np.asarray(keep(run))
    if values.dtype.char not in NUMBERS:
        raise UsageError(f"keep gave {values.dtype}; it must give booleans, or numbers of double precision at most")
    if len(run.status) != n or values.shape[:1] != (n,):
        raise UsageError(f"draw gave {len(run.status)} scenarios, keep the shape {values.shape}; both must be of {n}")
    return (
        values.astype(values.dtype.char, copy=False),
        run.status.astype(np.uint8),
        Limits(
            *(run.validity, left_out(model, run.q), run._source.limited(run.t, run.q, run.v)),
            *(_first(run.refused, k * task.chunk), len(run.refused)),
        ),
    )


def _first(refused: Mapping[int, str], start: int) -> dict[int, str]:
    """The first of the scenarios that did not run, by its number among those of all chunks."""
    return {start + i: refused[i] for i in sorted(refused)[:1]}


def _run(
    executor: Executor, task: SweepTask, target: Store, progress: Callable[[int, int], object] | None
) -> Limits | None:
    """Store what the workers find; the limits of all scenarios, if there were any."""
    limits: Limits | None = None
    done = sum(task.size(k) for k in target.done)
    missing = (k for k in range(task.chunks) if k not in target.done)
    for k, (values, status, own) in completed(lambda k: executor.submit(work, task, k), missing, executor):
        target.write(k, values, status)
        limits = own if limits is None else limits.joined(own)
        done += task.size(k)
        if progress is not None:
            progress(done, task.count)
    return limits
