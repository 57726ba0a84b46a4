"""Sweeps: rollouts of any number of scenarios in chunks, on any executor, into a file.

A chunk draws its scenarios from a seed of its own, so results depend on neither the executor nor the number of its
workers. Beside the ``.npy`` file a manifest lists the finished chunks: a sweep that was stopped goes on there.
"""

from __future__ import annotations

import hashlib
import inspect
import os
import pickle
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from concurrent.futures.thread import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import whole
from ..errors import ScrewgenError, UsageError
from ..integrators.method import Method
from ..integrators.methods import method_of
from ..runtime.batch import compiled_batch
from ..runtime.compiled import NO_METHOD
from ..version import __version__ as VERSION
from .loop import added
from .rollout import Rollout, checked, rolled
from .store import Store
from .validity import Validity

if TYPE_CHECKING:
    from ..model import Model

TRIES = 4
"""How often a chunk is tried whose worker was lost."""
AHEAD = 4
"""Chunks under way per worker: those that run, and those that wait."""

CHUNK = 1024
"""Scenarios of a chunk."""
LOST = ("KilledWorker", "FutureCancelledError", "CommClosedError")
"""Exceptions of dask that say that a worker was lost."""
ARGUMENTS = ("x0", "tau", "w_ext", "parameters")

Draw = Callable[[np.random.Generator, int], Mapping[str, Any]]
Keep = Callable[[Rollout], np.ndarray]


@dataclass(frozen=True, repr=False)
class Sweep:
    """The results of a sweep: ``values`` (count, ...), mapped from the file; ``status`` (count,) as of a rollout."""

    values: np.ndarray
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
    model: Model,
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
    """Roll out `count` scenarios in chunks and keep numbers of each in the file `store`, an ``.npy``.

    ``draw(rng, n)`` gives `x0`, `tau`, `w_ext`, `parameters` of :func:`screwgen.rollout` for `n` scenarios, as a
    mapping; ``rng`` follows from `seed` and the chunk's number. ``keep(rollout)`` gives what is kept, (n, ...), by
    default the last states. `executor`: any of ``concurrent.futures``; one thread by default. Where its workers are
    processes, `draw` and `keep` must be functions of a module; each process derives and compiles the robot once.
    `progress` is told how many scenarios are done, and of how many. Memory holds some chunks, never all.

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
    task = Task(_digest(model, draw, keep, options, count, chunk, seed), count, chunk, seed, packed)
    if packed is None:
        _here[task.digest] = (model, draw, keep, options)
    target = Store(Path(store), task.digest, count, chunk)
    try:
        with target:
            if executor is None:
                with ThreadPoolExecutor(1) as own:
                    _run(own, task, target, progress)
            else:
                _run(executor, task, target, progress)
    finally:
        _here.pop(task.digest, None)
    return Sweep(*target.result())


@dataclass(frozen=True)
class Task:
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


def _digest(model: Model, draw: Draw, keep: Keep, options: dict, *numbers: int) -> str:
    with np.printoptions(threshold=sys.maxsize, floatmode="unique"):
        said = [VERSION, _said(model), _said(options), _said(numbers), _said(draw), _said(keep)]
    return hashlib.sha256("\n".join(said).encode()).hexdigest()


def _said(what: Any) -> str:
    """What tells one sweep from another: numbers, robots, the source of functions and what is bound to them."""
    if hasattr(what, "robot"):
        return repr(what.robot)
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


_kept: dict[str, Any] = {}
"""What a task that came packed needs, by its digest: that of the last one."""
_here: dict[str, Any] = {}
"""What tasks that share this process' memory need."""
_lock = threading.Lock()


def _unpacked(digest: str, packed: bytes | None) -> Any:
    """What a task needs; a process keeps that of one, so that it derives and compiles a robot once."""
    if packed is None:
        return _here[digest]
    with _lock:
        if digest not in _kept:
            _kept.clear()
            _kept[digest] = pickle.loads(packed)
        return _kept[digest]


def work(task: Task, k: int) -> tuple[np.ndarray, np.ndarray, Validity]:
    """Values, statuses and validity of chunk `k`; runs in a worker."""
    model, draw, keep, options = _unpacked(task.digest, task.packed)
    ready(model, options["single"], options["integrator"])
    n, rng = task.size(k), np.random.default_rng([task.seed, k])
    given = dict(draw(rng, n))
    if wrong := given.keys() - set(ARGUMENTS) or {"x0"} - given.keys():
        raise UsageError(f"draw: wrong or missing is '{min(wrong)}'; it gives x0, and may {', '.join(ARGUMENTS[1:])}")
    given, count, how = checked(model, **(dict.fromkeys(ARGUMENTS) | given), **options)
    run = rolled(model, given, count, *how)
    values = np.asarray(keep(run))
    if len(run.status) != n or values.shape[:1] != (n,):
        raise UsageError(f"draw gave {len(run.status)} scenarios, keep the shape {values.shape}; both must be of {n}")
    return values, run.status.astype(np.uint8), run.validity


def ready(model: Model, single: bool, integrator: str | Method) -> None:
    """Derive and compile what a rollout needs, once in a process."""
    with _lock:
        compiled_batch(model, single, added(method_of(integrator, missing=NO_METHOD)))
        model.casadi()["validity"]


def _run(executor: Executor, task: Task, target: Store, progress: Callable[[int, int], object] | None) -> None:
    validities: list[Validity] = []
    done = sum(task.size(k) for k in target.done)
    missing = (k for k in range(task.chunks) if k not in target.done)
    for k, (values, status, validity) in completed(lambda k: executor.submit(work, task, k), missing, executor):
        target.write(k, values, status)
        validities = [merged([*validities, validity])]
        done += task.size(k)
        if progress is not None:
            progress(done, task.count)
    for validity in validities:
        validity.warn(stacklevel=4)


def completed(submit: Callable[[int], Future], numbers: Iterable[int], executor: Executor) -> Iterator[tuple[int, Any]]:
    """The results of chunks, as they end; those whose worker was lost are made again."""
    running: dict[Future, int] = {}
    left = iter(numbers)
    lost: dict[int, int] = {}
    ahead = AHEAD * (getattr(executor, "_max_workers", None) or os.cpu_count() or 1)
    try:
        while True:
            while len(running) < ahead and (k := next(left, None)) is not None:
                running[submit(k)] = k
            if not running:
                return
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                k = running.pop(future)
                try:
                    found = future.result()
                except Exception as error:
                    lost[k] = _again(error, lost.get(k, 0))
                    running[submit(k)] = k
                else:
                    yield k, found
    finally:
        for future in running:
            future.cancel()


def _again(error: BaseException, tries: int) -> int:
    """How often a chunk was lost; raises what is no loss of a worker, and what happens too often."""
    if isinstance(error, BrokenExecutor):
        said = "a worker process died, and its pool with it"
        raise ScrewgenError(f"{said}; call again with a new one: a store keeps the finished chunks") from error
    gone = isinstance(error, CancelledError | ConnectionError | EOFError) or type(error).__name__ in LOST
    if not gone or tries + 1 >= TRIES:
        raise error
    return tries + 1


# ------------------------------------------------------------------------------ arrays, joined in memory


def in_chunks(model: Model, given: Mapping[str, np.ndarray], count: int, how: tuple, executor: Executor) -> Rollout:
    """:func:`screwgen.rollout` by an executor: the same results, joined."""
    packed = None if isinstance(executor, ThreadPoolExecutor) else pickle.dumps(model)
    digest = hashlib.sha256(packed or str(id(model)).encode()).hexdigest()
    if packed is None:
        _here[digest] = model

    def call(k: int) -> Future:
        rows = slice(k * CHUNK, min((k + 1) * CHUNK, count))
        own = {name: a[rows] if len(a) > 1 else a for name, a in given.items()}
        return executor.submit(part, digest, packed, own, rows.stop - rows.start, how)

    try:
        found = dict(completed(call, range(max(1, -(-count // CHUNK))), executor))
    finally:
        _here.pop(digest, None)
    return joined([found[k] for k in sorted(found)])


def part(digest: str, packed: bytes | None, given: Mapping[str, np.ndarray], count: int, how: tuple) -> Rollout:
    """A chunk of :func:`in_chunks`; runs in a worker."""
    model = _unpacked(digest, packed)
    *_, method, _, single = how
    ready(model, single, method)
    return rolled(model, given, count, *how)


def joined(runs: list[Rollout]) -> Rollout:
    """Rollouts one behind the other."""
    names = ("q", "v", "status", "completed", "fault")
    stacked = {name: np.concatenate([getattr(run, name) for run in runs]) for name in names}
    return Rollout(t=runs[0].t, **stacked, links=runs[0].links, validity=merged([run.validity for run in runs]))


def merged(validities: list[Validity]) -> Validity:
    """The largest measures of several motions, and when each was first past its bound."""
    values, at, first = (np.array([getattr(v, name) for v in validities]) for name in ("values", "at", "first"))
    largest = np.argmax(np.abs(values), axis=0)[None]
    pick = lambda a: np.take_along_axis(a, largest, axis=0)[0]  # noqa: E731
    earliest = np.fmin.reduce(first, axis=0)
    return Validity(validities[0].links, pick(values), earliest, pick(at))
