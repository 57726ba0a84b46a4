"""Recording of a run: a table with a row per sample, and a file that can be read if the run stops.

A run that is stored to `run.npz` is in `run.part.npy` until it ends. This is a NumPy array with the fields of `Run`;
`numpy.load` can read it at any moment, also after the run was killed. A run for `run.csv` is in `run.part.csv`; its
last line may be cut if the run is killed. At most the last `AGE` seconds of computing are missing.
"""

from __future__ import annotations

import io
import os
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO, TypeVar

import numpy as np
from numpy.lib import format as npy

from ..algorithms.robot_function import entries
from ..algorithms.robot_functions import reported
from ..backends.c.shim import PARTS
from ..bodies.validity import MEASURES
from ..errors import ScrewgenError, SingularError, UsageError
from ..robot_model import RobotModel
from ..spec.load import one_line
from ..unfinished import abandoned, claimed
from .hits import Hits
from .inputs import Inputs
from .integrate import CasadiEvaluator, Dynamics, EquationForm, holding
from .limited_inputs import LimitedInputs
from .loop_watch import LoopWatch
from .runs import NAMES, Run, column_names, csv_header, csv_lines, suffix, unwritable
from .validity import Watch

_State = TypeVar("_State")
Held = tuple[np.ndarray, np.ndarray, float]
"""Torques, wrenches, and the seconds for which they are held."""

MAX_BYTES = 4 * 2**30
WATCH = 8
"""The largest number of steps between two evaluations of the validity measures."""
AGE = 0.25
"""Samples wait this long, in seconds, to be stored together."""

BLOCK = 4096
"""Samples that are written at once."""


@dataclass(frozen=True)
class RunTask:
    """A run to make: `steps` steps of `step` seconds that end at `duration`, every `every`-th sampled, and the end.

    `q0`, `v0` (nq,): where it starts; `given`: what acts on the arm; `law`: the controller behind its torques;
    `progress`: to be called with steps done and all, or None.
    """

    steps: int
    step: float
    duration: float
    every: int
    q0: np.ndarray
    v0: np.ndarray
    given: Inputs
    law: object
    progress: Callable[[int, int], None] | None

    def time(self, k: int) -> float:
        """When step k begins, s."""
        return k * self.step if k < self.steps else self.duration

    def reach(self, k: int) -> float:
        """How long step k is, s."""
        return self.step if k < self.steps - 1 else self.duration - self.time(k)

    def rows(self, k: int) -> int:
        """The number of samples before step k; number `steps` is the end."""
        return -(-min(k, self.steps) // self.every) + (k > self.steps)

    def sampled(self, k: int) -> bool:
        """Whether step k, or number `steps`, the end, is a sample."""
        return k % self.every == 0 or k == self.steps


Walk = Callable[[RunTask, "SampleTable"], None]
"""A way to make a run."""


def check_size(model: RobotModel, samples: int) -> None:
    """Refuse a run of more samples than memory should hold; raises UsageError."""
    if (size := 8 * samples * sum(_widths(model).values())) > MAX_BYTES:
        raise UsageError(f"the run would take {size / 1e9:.0f} GB; take a shorter duration or a longer step")


def _widths(model: RobotModel) -> dict[str, int]:
    """How many numbers each quantity has in one sample."""
    widths = {"t": 1, "q": model.nq, "v": model.chain.nvz, "tau": model.n_tau}
    widths |= {"wrench": 6 * model.n_links, "tip_position": 3}
    return widths | {row.name: entries(row, model.chain) for row in reported(model.chain)}


class SampleTable:
    """The samples of a run, one row of numbers each: t, q, v, tau, wrench, tip_position, and what is reported."""

    def __init__(self, model: RobotModel, times: np.ndarray, p: np.ndarray, q0: np.ndarray, given: Inputs):
        self.model, self.times, self.p, self.given = model, times, p, given
        self.w_ext = given.wrenches(len(times))
        self.widths = widths = _widths(model)
        ends = np.cumsum(list(widths.values()))
        self.places = {name: slice(end - size, end) for (name, size), end in zip(widths.items(), ends, strict=True)}
        self.width = int(ends[-1])
        self.rows, self.count = np.empty((len(times), self.width)), 0
        self.watch, self.hits, self.loops = Watch(model.chain.names), Hits(model, p), LoopWatch(model, p, q0)
        self.limited = LimitedInputs.none(model)
        self.store: RunFile | None = None

    @property
    def shapes(self) -> dict[str, tuple[int, ...]]:
        """The shape of every quantity in one sample."""
        sizes = {name: (size,) for name, size in self.widths.items()}
        return sizes | {"t": (), "wrench": (self.model.n_links, 6)}

    def acted(self, row: int, w_ext: np.ndarray) -> None:
        """Keep the tip wrenches of a sample, if they vary."""
        if self.given.wrenches_vary:
            self.w_ext[row] = w_ext

    def filled(self, count: int) -> None:
        """Report that the first `count` rows are filled."""
        self.count = count
        if self.store is not None:
            self.store.filled(count)

    def run(self, ended: str = "") -> Run:
        """The run; `ended`: why it ended before its time, and then with the rows that are filled."""
        m, rows = self.model, self.rows[: self.count] if ended else self.rows
        arrays: dict[str, Any] = {name: rows[:, place] for name, place in self.places.items()}
        arrays |= {"t": rows[:, 0], "wrench": arrays["wrench"].reshape(len(rows), m.n_links, 6)}
        more: dict[str, Any] = {name: tuple(getattr(m, name)) for name in NAMES}
        more |= {"robot": m.robot, "parameters": np.array(self.p, float), "model": m, "w_ext": self.w_ext[: len(rows)]}
        more |= {"validity": self.watch.validity(), "hits": self.hits.all, "ended": ended}
        more |= {"quantity_units": m.force_quantities}
        return Run.of(m.robot.name, arrays, **more)


class Recorder:
    """Samples of a motion by CasADi's functions."""

    def __init__(self, table: SampleTable):
        functions, self.table = table.model.casadi(), table
        self.dynamics, self.hold = Dynamics(table.model, table.p), holding(table.model, table.p)
        modal = table.model.modal_functions
        self.watched, self.measures = CasadiEvaluator(modal["watched_dynamics"]), CasadiEvaluator(modal["measures"])
        self.settled = CasadiEvaluator(modal["settled_rows"]) if table.model.chain.compliant else None
        self.tip_pose = CasadiEvaluator(functions["tip_pose"])
        rows = reported(table.model.chain)
        self.reports = {row.name: (row.names, CasadiEvaluator(functions[row.name])) for row in rows}

    def felt(self, q: np.ndarray, v: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, settling: float) -> np.ndarray:
        """The tip wrenches with what stiff rows of loops bear besides; ``settling``: as of :meth:`.Method.settling`."""
        if self.settled is None or not settling:
            return w_ext
        return self.settled(q, v, tau, w_ext, np.array(settling), self.table.p)[0].reshape(w_ext.shape)

    def look(self, t: float, q: np.ndarray, v: np.ndarray, tau: np.ndarray, w_ext: np.ndarray) -> np.ndarray | None:
        """The joint wrenches under what a step holds; None if a link bends by more than its length."""
        wrench, motion = self.watched(q, v, tau, w_ext, *self.dynamics.modes(q, v), self.table.p)
        measures = self.measures(q, wrench, motion, self.table.p)[0]
        return wrench if self.table.watch(t, measures.reshape(-1, len(MEASURES))) else None

    def __call__(self, row: int, q: np.ndarray, v: np.ndarray, wrench: np.ndarray, held: Sequence[np.ndarray]) -> None:
        """Keep a sample; ``held``: the inputs and tip wrenches that act."""
        p = self.table.p
        given, tip = {"q": q, "v": v, "tau": (tau := held[0]), "w_ext": held[1]}, self.tip_pose(q, p)[1]
        told = [x for names, report in self.reports.values() for x in report(*(given[name] for name in names), p)]
        self.table.rows[row] = np.concatenate([self.table.times[row : row + 1], q, v, tau, wrench, tip, *told])
        self.table.filled(row + 1)

    def weigh(self, t: float, plant: EquationForm[_State], before: _State, after: _State, held: Held) -> None:
        """Note the energies of the states before and after a step at `t` under held (torques, wrenches, seconds)."""
        if not self.table.loops:
            return
        tau, w_ext, dt = held

        def reported(name: str, state: _State, *more: np.ndarray) -> np.ndarray:
            return np.concatenate(self.reports[name][1](*plant.coordinates(state), *more, self.table.p))

        def energy(state: _State) -> np.ndarray:
            return reported("energy", state, *[given] * ("tau" in self.reports["energy"][0]))

        def again() -> np.ndarray:
            state = before
            for _ in range(PARTS):
                state = plant.step(state, tau, w_ext, dt / PARTS)
            return energy(state)

        given = self.hold(*plant.coordinates(before), tau)
        told, more = ("effort_power", (given, w_ext)) if "effort_power" in self.reports else ("drive_power", (given,))
        power = sum(float(np.sum(reported(told, x, *more))) for x in (before, after)) / 2
        self.table.loops.begin(lambda: energy(before))
        alone = not (np.any(w_ext) or self.table.model.chain.n_internal)
        self.table.loops.weigh(t, energy(after), power * dt, again, alone)

    def check(self) -> None:
        """Raise SingularError if a joint wrench is not finite."""
        if not np.isfinite(self.table.rows[:, self.table.places["wrench"]]).all():
            raise SingularError("a joint wrench is not finite; the motion passed through a singular posture")


# ------------------------------------------------------------------------------ the file


def part_of(path: str | os.PathLike[str]) -> Path:
    """The path of the file that holds a run for `path` until it ends."""
    target = Path(os.path.realpath(path))
    return target.with_suffix({".npz": ".part.npy", ".csv": ".part.csv"}[suffix(path)])


@contextmanager
def stored(table: SampleTable, path: str | os.PathLike[str] | None) -> Iterator[None]:
    """Store the table's samples as they come; a run that ends is moved to `path`. Without a path nothing is stored.

    The text of an error or interruption names the file that remains.
    """
    if path is None:
        yield
        return
    part, text = part_of(path), suffix(path) == ".csv"
    stream = _claimed(part, path, _header(table, text, 0))
    try:
        with stream:
            table.store = RunFile(table, stream, text)
            try:
                yield
            finally:
                table.store.append()
        if text:
            os.replace(part, os.path.realpath(path))
        else:
            table.run().save(path)
            part.unlink()
    except OSError as error:
        raise unwritable(path, error) from None
    except (ScrewgenError, KeyboardInterrupt) as error:
        if table.store is None or not table.store.count:
            raise
        reason = str(error) or "interrupted"
        raise type(error)(f"{reason}; {one_line(part.name)} keeps the run until then") from None
    finally:
        if table.store is None or not table.store.count:
            with suppress(OSError):
                part.unlink()


def _claimed(part: Path, path: str | os.PathLike[str], header: bytes) -> BinaryIO:
    """The new file of a run for `path`, with the access rights of the existing one; raises UsageError.

    In place of one that a killed process left with its `header` alone.
    """
    said = "that was stopped, or one that still goes on"
    try:
        with suppress(OSError), abandoned(part) as left:
            if left and part.stat().st_size <= len(header):
                part.unlink()
            said = "that was stopped" if left else "that still goes on"
        return claimed(part, like=path)
    except FileExistsError:
        kept = f"is there already: it keeps a run {said}"
        raise UsageError(f"{one_line(str(part))}: {kept}; move it away, or choose another output") from None
    except OSError as error:
        raise unwritable(path, error) from None


class RunFile:
    """The file of a run that has not ended."""

    def __init__(self, table: SampleTable, stream: BinaryIO, text: bool):
        self.table, self.stream, self.text = table, stream, text
        self.count, self.ready, self.clock = 0, 0, time.monotonic()
        self.end = stream.write(_header(table, text, 0))
        stream.flush()

    def filled(self, count: int) -> None:
        """Append the rows before `count`, at intervals."""
        self.ready = count
        if count - self.count > BLOCK or time.monotonic() - self.clock > AGE:
            self.append()

    def append(self) -> None:
        """Append all rows that are ready, block by block. A block that is interrupted is written again."""
        while self.count < self.ready:
            rows = self.table.rows[self.count : min(self.count + BLOCK, self.ready)]
            data = b"".join(csv_lines(rows)) if self.text else rows.astype("<f8", copy=False).tobytes()
            self._write(self.end, data)
            self.count, self.end = self.count + len(rows), self.end + len(data)
            if not self.text:
                self._write(0, _header(self.table, False, self.count))
        self.clock = time.monotonic()

    def _write(self, place: int, data: bytes) -> None:
        """Write a block, then the count in the header, so that the file is valid at any moment."""
        self.stream.seek(place)
        self.stream.write(data)
        self.stream.flush()


def _columns(model: RobotModel) -> tuple[str, ...]:
    names = (model.q_names, model.v_names, model.tau_names, model.wrench_names)
    told = [row.name for row in reported(model.chain)]
    return column_names(*names, reports=told, quantities=model.force_quantities)


def _header(table: SampleTable, text: bool, count: int) -> bytes:
    """The head of the file of a run of so many samples."""
    if text:
        return csv_header(_columns(table.model))
    return npy_header(np.dtype([(name, "<f8", shape) for name, shape in table.shapes.items()]), count)


def npy_header(dtype: np.dtype, count: int) -> bytes:
    """The header of an array of `count` records in NumPy's format 1.0, which leaves room for any count."""
    header = io.BytesIO()
    what = {"descr": npy.dtype_to_descr(dtype), "fortran_order": False, "shape": (count,)}
    npy.write_array_header_1_0(header, what)
    return header.getvalue()
