"""Chunks of scenarios on any executor of ``concurrent.futures``, and those of lost workers again."""

from __future__ import annotations

import hashlib
import os
import pickle
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from concurrent.futures.thread import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np

from ..errors import ScrewgenError
from ..integrators.method import Method
from ..integrators.methods import method_of
from ..robot_model import RobotModel
from ..runtime.batch import compiled_batch
from ..runtime.differentiated import NO_METHOD
from .compiled_runs import added
from .validity import Validity

TRIES = 4
"""How often a chunk is tried whose worker was lost."""
AHEAD = 4
"""Chunks under way per worker: those that run, and those that wait."""

CHUNK = 1024
"""Scenarios of a chunk."""
LOST = ("KilledWorker", "FutureCancelledError", "CommClosedError")
"""Exceptions of dask that say that a worker was lost."""


class How(NamedTuple):
    """How scenarios are rolled out: `periods` samples of `step` seconds, each of `substeps` steps of `method`."""

    step: float
    substeps: int
    method: Method
    threads: int
    single: bool
    periods: int = 0

    @property
    def settling(self) -> float:
        """As of :meth:`.Method.settling`, s."""
        return self.method.settling(self.step / self.substeps)


_kept: dict[str, Any] = {}
"""What a task that came packed needs, by its digest: that of the last one."""
HERE: dict[str, Any] = {}
"""What tasks that share this process' memory need."""
_lock = threading.Lock()


def unpacked(digest: str, packed: bytes | None) -> Any:
    """What a task needs; a process keeps that of one, so that it derives and compiles a robot once."""
    if packed is None:
        return HERE[digest]
    with _lock:
        if digest not in _kept:
            _kept.clear()
            _kept[digest] = pickle.loads(packed)
        return _kept[digest]


def ready(model: RobotModel, single: bool, integrator: str | Method) -> None:
    """Derive and compile what a rollout needs, once in a process."""
    with _lock:
        compiled_batch(model, single, added(method_of(integrator, missing=NO_METHOD)))
        model.casadi()["validity"]


def completed(submit: Callable[[int], Future], numbers: Iterable[int], executor: Executor) -> Iterator[tuple[int, Any]]:
    """The results of chunks, as they end; those whose worker was lost are made again."""
    running: dict[Future, int] = {}
    left = iter(numbers)
    lost: dict[int, int] = {}
    ahead = AHEAD * _workers(executor)
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


def _workers(executor: Executor) -> int:
    """How many workers an executor has, where it says so; that of dask asks its client."""
    client = getattr(executor, "_client", None)
    count = sum(client.nthreads().values()) if client else getattr(executor, "_max_workers", None)
    return count or os.cpu_count() or 1


def _again(error: BaseException, tries: int) -> int:
    """How often a chunk was lost; raises what is no loss of a worker, and what happens too often."""
    if isinstance(error, BrokenExecutor):
        said = "a worker process died, and its pool with it"
        raise ScrewgenError(f"{said}; call again with a new one: a store keeps the finished chunks") from error
    gone = isinstance(error, CancelledError | ConnectionError | EOFError) or type(error).__name__ in LOST
    if not gone or tries + 1 >= TRIES:
        raise error
    return tries + 1


def in_chunks(
    run: Callable, model: RobotModel, given: Mapping[str, np.ndarray], count: int, how: How, executor: Executor
) -> list:
    """What ``run(model, given, count, how)`` gives of each chunk of the scenarios, in their order."""
    packed = None if isinstance(executor, ThreadPoolExecutor) else pickle.dumps(model)
    digest = hashlib.sha256(packed or str(id(model)).encode()).hexdigest()
    if packed is None:
        HERE[digest] = model

    def call(k: int) -> Future:
        first, size = k * CHUNK, min(CHUNK, count - k * CHUNK)
        rows = slice(first, first + size)
        own = {name: a[rows] if len(a) > 1 else a for name, a in given.items()}
        return executor.submit(part, run, digest, packed, own, size, how)

    try:
        found = dict(completed(call, range(max(1, -(-count // CHUNK))), executor))
    finally:
        HERE.pop(digest, None)
    return [found[k] for k in sorted(found)]


def part(
    run: Callable, digest: str, packed: bytes | None, given: Mapping[str, np.ndarray], count: int, how: How
) -> Any:
    """A chunk of :func:`in_chunks`; runs in a worker."""
    model = unpacked(digest, packed)
    ready(model, how.single, how.method)
    return run(model, given, count, how)


def merged(validities: list[Validity]) -> Validity:
    """The largest measures of several motions, and when each was first past its bound."""
    values, at, first = (np.array([getattr(v, name) for v in validities]) for name in ("values", "at", "first"))
    largest = np.argmax(np.abs(values), axis=0)[None]
    pick = lambda a: np.take_along_axis(a, largest, axis=0)[0]  # noqa: E731
    earliest = np.fmin.reduce(first, axis=0)
    return Validity(validities[0].links, pick(values), earliest, pick(at))
