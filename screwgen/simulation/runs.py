"""Runs: the result of a simulation, and its files, which appear whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, ExitStack, contextmanager, suppress
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np

from .. import notebook
from ..algorithms.entry_names import entry_names
from ..algorithms.robot_functions import BY_NAME, FUNCTIONS, OUTPUTS
from ..errors import UsageError
from ..files import Arrays
from ..robot_model import RobotModel
from ..spec.array_files import arrays_of
from ..spec.inputs import TORQUES, places
from ..spec.load import dump, one_line
from ..spec.tendons import TENSIONS
from ..unfinished import claimed, part_of, remove_parts
from .hits import Hit
from .measured import is_measured, measured
from .validity import Validity

if TYPE_CHECKING:
    from ..spec.robot import Robot

OWN = ("t", "q", "v", "tau", "wrench", "tip_position")
REPORTED = tuple(row.name for row in FUNCTIONS if row.c_file == OUTPUTS)
"""What is reported at every sample besides, by the names of the functions that give it."""
ARRAYS = (*OWN, *REPORTED)
NEEDED = (*OWN, "energy")
"""What every file of a run has; files of earlier versions lack the rest."""
NAMES = ("q_names", "v_names", "tau_names", "wrench_names")
TIP_NAMES = ("tip_position.x", "tip_position.y", "tip_position.z")


@dataclass(frozen=True, eq=False, repr=False)
class Run:
    """A simulated motion: N samples of a robot with n links; SI units, radians.

    `t` (N,); `q` (N, nq): coordinates, joints then modes; `v` (N, nv): their rates; `tau` (N, n_tau): the torques held
    from each sample to the next; `wrench` (N, n, 6): joint wrenches [τ; F], what link i−1 exerts on link i at
    the joint point, in F_i components; `tip_position` (N, 3): the last link's tip in the inertial frame. The names
    belong to the columns. What functions of the robot report at every sample are attributes by the names of these, see
    docs/functions.md, as `energy` (N, 2), J: kinetic, potential, and `drive_power` (N, n_tau), W.

    Computed when first asked for: `accelerometer` (N, m, 3), m/s², `gyro` (N, m, 3), rad/s, and the others that
    sensors read, at the markers in the order of `model.marker_names`; `strain` (N, strains), as `model.strain_names`.
    """

    name: str
    t: np.ndarray
    q: np.ndarray
    v: np.ndarray
    tau: np.ndarray
    wrench: np.ndarray
    tip_position: np.ndarray
    energy: np.ndarray
    q_names: tuple[str, ...]
    v_names: tuple[str, ...]
    tau_names: tuple[str, ...]
    wrench_names: tuple[str, ...]
    told: Mapping[str, np.ndarray] = field(default_factory=dict)
    """What functions report besides the energy, by their names: `run.drive_power` is `run.told["drive_power"]`."""
    validity: Validity | None = None
    """The validity measures of the motion; files do not store them."""
    hits: tuple[Hit, ...] = ()
    """The joints beyond their limits, by their beginning, looked for at every step; files do not store them."""
    robot: Robot | None = None
    """The robot; .npz files store it as the text of its file, where a file can state it."""
    parameters: np.ndarray | None = None
    """The values of its parameters; those of the file if None."""
    ended: str = ""
    """Why the run ended before its time; .npz files store it where it did."""
    w_ext: np.ndarray | None = None
    """(N, n, 6): the tip wrenches held from each sample to the next; .npz files store them where any acted."""
    model: RobotModel | None = None
    """The model, of a run that is not from a file."""
    quantity_units: Mapping[str, str] = field(default_factory=dict)
    """The names of what forces between frames report, with units; .npz files store them where there are any."""

    def __getattr__(self, name: str) -> Any:
        """What functions report, None where a file of an earlier version lacks it; and what sensors measure at the
        samples, computed when it is first asked for."""
        if name in REPORTED:
            return self.told.get(name)
        if not is_measured(name, self.__dict__.get("robot")):
            raise AttributeError(f"'Run' has no attribute '{name}'", name=name, obj=self)
        if self.robot is None:
            raise UsageError(f"this run does not know its robot, so there is no {name}; take one of simulate")
        acted = np.zeros((len(self.t), *self.wrench.shape[1:])) if self.w_ext is None else self.w_ext
        samples, model = {"q": self.q, "v": self.v, "tau": self.tau, "w_ext": acted}, self._model
        self.__dict__[name] = measured(model, name, samples, model.chain.parameters.vector(self.parameters))
        return self.__dict__[name]

    @classmethod
    def of(cls, name: str, arrays: Mapping[str, np.ndarray], **more: Any) -> Run:
        """The run with `arrays` by the names of `ARRAYS`."""
        told = {key: values for key, values in arrays.items() if key not in NEEDED}
        own: dict[str, Any] = {key: arrays[key] for key in NEEDED}
        return cls(name, **own, told=told, **more)

    @cached_property
    def _model(self) -> RobotModel:
        assert self.robot is not None
        return RobotModel(self.robot) if self.model is None else self.model

    def __repr__(self) -> str:
        joints, tendons, others = (len(places(self.tau_names, row)) for row in (TORQUES, TENSIONS, None))
        counts = {"joint": joints, "mode": self.q.shape[1] - joints}
        counts |= {word: count for word, count in (("tendon", tendons), ("other input", others)) if count}
        early = ", ended early" if self.ended else ""
        size = ", ".join(f"{count} {word}{'s' * (count != 1)}" for word, count in counts.items())
        return f"<Run of {self.name}: {len(self.t)} samples to {self.t[-1]:.6g} s{early}, {size}>"

    def _repr_html_(self) -> str:
        """The run in motion, and first, last and extreme values of the coordinates and of the tip position."""
        names = (*self.q_names, *TIP_NAMES)
        values = np.column_stack([self.q, self.tip_position]).T
        rows = ((name, x[0], x[-1], x.min(), x.max()) for name, x in zip(names, values, strict=True))
        table = notebook.table(repr(self).strip("<>"), ("", "first", "last", "least", "most"), rows)
        return notebook.player(self) + table

    @property
    def reports(self) -> dict[str, np.ndarray]:
        """What the run has of what functions of the robot report, by the names of these."""
        found = {name: getattr(self, name) for name in REPORTED}
        return {name: values for name, values in found.items() if values is not None}

    def names_of(self, array: str) -> tuple[str, ...]:
        """The names of the columns of an array, such as `tau`; raises AttributeError where the run has none of it."""
        if array in self.reports:
            links = segments(self.wrench_names)
            return entry_names(BY_NAME[array], self.tau_names, links=links, quantities=self.quantity_units)
        return getattr(self, f"{array}_names")

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of the columns of `table`."""
        return column_names(
            *(getattr(self, name) for name in NAMES), reports=self.reports, quantities=self.quantity_units
        )

    @property
    def arrays(self) -> dict[str, np.ndarray]:
        """What the columns hold, by name, (N, …) each."""
        return {name: getattr(self, name) for name in OWN} | self.reports

    @property
    def table(self) -> np.ndarray:
        """Everything side by side, (N, columns)."""
        return np.column_stack([values.reshape(len(self.t), -1) for values in self.arrays.values()])

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a .npz file (keys as the attributes, and the names) or a .csv table with a header.

        An existing file is replaced atomically, once the new one is complete. Raises UsageError.
        """
        check_output(path, FORMATS)
        with outputs(path) as (stream,):
            self.write(stream, path)

    def write(self, stream: BinaryIO, path: str | os.PathLike[str]) -> None:
        """Write to `stream` in the format of the suffix of `path`."""
        FORMATS[suffix(path)](self, stream)


def column_names(*names: Sequence[str], reports: Iterable[str], quantities: Iterable[str] = ()) -> tuple[str, ...]:
    """The names of the columns of a table, of a run with these `NAMES`, whose forces report ``quantities``."""
    of = dict(zip(NAMES, names, strict=True))
    links = segments(of["wrench_names"])
    more: dict[str, Any] = {"links": links, "quantities": quantities}
    told = (x for name in reports for x in entry_names(BY_NAME[name], of["tau_names"], **more))
    return ("t", *(x for group in names for x in group), *TIP_NAMES, *told)


def segments(wrench_names: Sequence[str]) -> list[str]:
    """The names of the links, and of the segments of those that are divided, from those of the wrenches at them."""
    return [name.rpartition(".")[0] for name in wrench_names[::6]]


def write_npz(run: Run, stream: BinaryIO) -> None:
    arrays: dict[str, Any] = run.arrays
    arrays |= {name: np.array(getattr(run, name), dtype=str) for name in NAMES}
    if run.robot is not None:
        with suppress(UsageError):
            arrays["robot"] = np.array(dump(run.robot))
        arrays["parameters"] = run.parameters
    if run.w_ext is not None and np.any(run.w_ext):
        arrays["w_ext"] = run.w_ext
    if run.quantity_units:
        arrays["quantity_names"] = np.array([*run.quantity_units], str)
        arrays["quantity_units"] = np.array([*run.quantity_units.values()], str)
    if run.ended:
        arrays["ended"] = np.array(run.ended)
    np.savez(stream, **arrays)


def write_csv(run: Run, stream: BinaryIO) -> None:
    stream.write(csv_header(run.columns))
    stream.writelines(csv_lines(run.table))


def csv_header(columns: Sequence[str]) -> bytes:
    """The first line of a CSV table."""
    return (",".join(columns) + "\n").encode()


def csv_lines(rows: np.ndarray) -> Iterator[bytes]:
    """The other lines: numbers in the shortest form that reads back bit for bit."""
    for row in rows:
        yield (",".join(map(repr, row.tolist())) + "\n").encode()


FORMATS: dict[str, Callable[[Run, BinaryIO], None]] = {".npz": write_npz, ".csv": write_csv}


# ------------------------------------------------------------------------------ files


def run_arrays(path: str | os.PathLike[str]) -> AbstractContextManager[Arrays]:
    """The arrays of the .npz file of a run; what cannot be read becomes a UsageError that names the file."""
    return arrays_of(path, "a run", "a .npz of simulate")


def suffix(path: str | os.PathLike[str]) -> str:
    """The suffix of a path in lower case, `.npz`."""
    return os.path.splitext(os.fsdecode(path))[1].lower()


def failed_name(path: str | os.PathLike[str]) -> str:
    """The name of what a run that failed leaves, `run.failed.npz`: it cannot be taken for a whole one."""
    stem, end = os.path.splitext(os.fsdecode(path))
    return f"{stem}.failed{end}"


def check_output(path: str | os.PathLike[str], suffixes: Sequence[str] | dict) -> None:
    """Refuse, before any work is done, a path that cannot be written: suffix, folder, kind of file."""
    shown = one_line(os.fsdecode(path))
    if suffix(path) not in suffixes:
        raise UsageError(f"{shown or 'the output'}: has an unknown suffix; it must end in {' or '.join(suffixes)}")
    try:
        target = Path(os.path.realpath(path))
        if not target.parent.is_dir():
            raise UsageError(f"{shown}: its folder does not exist; create it first")
        if target.is_dir():
            raise UsageError(f"{shown}: is a directory; name a file in it")
        if target.exists() and not target.is_file():
            raise UsageError(f"{shown}: is not a regular file; choose another name")
    except (OSError, ValueError) as error:
        raise unwritable(path, error) from None


def unwritable(path: str | os.PathLike[str], error: Exception) -> UsageError:
    """The error for an output that the system refuses."""
    reason = getattr(error, "strerror", None) or str(error)
    return UsageError(f"{one_line(os.fsdecode(path))}: cannot be written ({one_line(reason)}); choose another place")


@contextmanager
def outputs(*paths: str | os.PathLike[str]) -> Iterator[list[BinaryIO]]:
    """Streams to temporary files beside `paths`, which replace the destinations together on success.
    An existing file keeps its mode.

    The temporary files are opened at once, so that a folder that cannot be written is refused before the work;
    they are removed when the work fails, and where the process was killed by the next one that writes to a path.
    Raises UsageError.
    """
    targets = [Path(os.path.realpath(path)) for path in paths]
    parts = [part_of(target) for target in targets]
    try:
        for target in targets:
            remove_parts(target)
        with ExitStack() as stack:
            yield [stack.enter_context(_opened(*names)) for names in zip(parts, targets, paths, strict=True)]
        for part, target in zip(parts, targets, strict=True):
            os.replace(part, target)
    except OSError as error:
        raise unwritable(paths[0], error) from None
    finally:
        for part in parts:
            with suppress(OSError):
                part.unlink()


def _opened(part: Path, target: Path, path: str | os.PathLike[str]) -> BinaryIO:
    try:
        return claimed(part, like=target)
    except OSError as error:
        raise unwritable(path, error) from None
