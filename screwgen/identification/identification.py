"""The result of `identify`: numbers with intervals, how much they explain, what the data leave open, what is odd."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field

import numpy as np

from ..errors import UsageError
from ..spec.columns import TIME, Columns
from ..spec.load import decode, one_line, read
from .robot_text import folder_of, with_values

NARROW = 0.05
"""Intervals of a smaller half, over the number, are written with ±."""
LACKING = "if the model lacks nothing"


@dataclass(frozen=True)
class Estimated:
    """A number that was free: where it started, where it ended, and the interval that holds it in 95 of 100 cases."""

    name: str
    unit: str
    kind: str
    """``parameter``, ``sensor`` or ``input``."""
    start: float
    value: float
    low: float
    high: float
    determined: bool
    """Whether the data determine it."""
    bound: str = ""
    """``low`` or ``high`` where it ended at a bound."""
    members: tuple[str, ...] = ()
    """The names of all that are this number."""
    lacking: bool = False
    """Whether residuals say that the model lacks something. What of it acts as this number does no residual shows, and
    the interval does not count it."""

    @property
    def interval(self) -> str:
        """The interval in words."""
        if not self.determined:
            return "not determined by the data"
        half = (self.high - self.low) / 2
        narrow = half < NARROW * abs(self.value)
        known = f"± {half:.2g}" if narrow else f"{self.low:.3g} to {self.high:.3g}"
        known = f"at its bound; {known}" if self.bound else known
        return f"{known} {LACKING}" if self.lacking else known


@dataclass(frozen=True, eq=False)
class Explained:
    """A log beside the model: readings, what the model reads, and the shares of variance that it explains.

    `windows`: over windows whose starts are fitted, be the log held out or not; `whole`: the log in one run from its
    first readings on, driven by its inputs alone; `before`: that with the numbers from which the fit started. Arrays
    (N, sensors) in the columns' units.
    """

    log: str
    held_out: bool
    t: np.ndarray
    sensors: tuple[str, ...]
    readings: np.ndarray
    whole: np.ndarray
    before: np.ndarray
    windows: np.ndarray
    first: np.ndarray
    """The first samples of the windows."""
    quantities: tuple[str, ...] = ()
    """Of each sensor what it is one of, where several make a quantity, as the coordinates of points."""
    static: bool = False
    """Whether rows are shapes at rest; then `windows` is `whole`, the model's rest."""
    distance: float | None = None
    """m: how far measured points are from those of the model, on average."""

    def share(self, of: str) -> dict[str, float]:
        """The share of variance that ``windows``, ``whole`` or ``before`` explains of each sensor or quantity."""
        return shares(self.quantities or self.sensors, self.readings, getattr(self, of))

    def line(self) -> str:
        """How much the model explains, in words."""
        told = ", ".join(f"{name} {_percent(x)}" for name, x in self.share("whole").items())
        kind, how = "held out" if self.held_out else "fitted", "at rest" if self.static else "in one run"
        points = "" if self.distance is None else f"; points are {1e3 * self.distance:.2f} mm off on average"
        return f"{self.log} ({kind}), variance explained {how}: {told}{points}"

    def picture(self) -> bytes:
        """Measured against model, and what is left, as PNG."""
        from .report_figures import against_model

        return against_model(self, f"{self.log}, {'held out' if self.held_out else 'fitted'}")


def shares(names: Sequence[str], readings: np.ndarray, model: np.ndarray) -> dict[str, float]:
    """1 less the mean square of the difference over the variance, of columns of each name; NaN are left out."""
    left, spread = dict.fromkeys(names, 0.0), dict.fromkeys(names, 0.0)
    for name, y, z in zip(names, readings.T, model.T, strict=True):
        there = np.isfinite(y) & np.isfinite(z)
        if there.any():
            left[name] += float(np.sum((y[there] - z[there]) ** 2))
            spread[name] += float(np.sum((y[there] - y[there].mean()) ** 2))
    return {name: 1 - left[name] / spread[name] if spread[name] > 0 else float("nan") for name in left}


def _percent(share: float) -> str:
    return f"{100 * share:.1f} %" if np.isfinite(share) else "nothing, as it has no such motion"


@dataclass(frozen=True)
class MeasuredVibration:
    """A vibration that was measured, beside the model."""

    test: str
    mode: int
    """Its number among those of the model, from 1."""
    frequency: float
    """Hz"""
    before: float
    """That of the model of the start, Hz."""
    found: float
    damping: float | None
    damping_before: float
    damping_found: float

    def line(self) -> str:
        """The vibration in words."""
        told = f"{self.test}: {self.frequency:.4g} Hz is mode {self.mode}, {self.before:.4g} -> {self.found:.4g} Hz"
        if self.damping is None:
            return told
        return f"{told}, damping ratio {self.damping:.3g}, {self.damping_before:.3g} -> {self.damping_found:.3g}"


@dataclass(frozen=True)
class NumberPair:
    """Two numbers that the data determine, whose errors go together."""

    first: str
    second: str
    correlation: float
    better: float
    """By how much either would be better known if the other were."""
    remedy: str
    """What would tell them apart."""


@dataclass(frozen=True, eq=False, repr=False)
class Identification:
    """What was identified."""

    robot: str
    estimates: tuple[Estimated, ...]
    parameters: Mapping[str, float]
    """The parameters that were free, by name: what `parameters=` of runs takes."""
    columns: Columns
    """The columns of the logs with their identified numbers."""
    explained: tuple[Explained, ...]
    undetermined: tuple[str, ...]
    """Of each direction that the data do not determine a sentence."""
    notes: tuple[str, ...]
    """What is odd, a sentence each."""
    whiteness: Mapping[str, float] = field(default_factory=dict)
    """Of each sensor the correlation of a residual with the next."""
    frequencies: tuple[float, ...] = ()
    """The natural frequencies of the identified robot in its first posture, Hz."""
    tried: Mapping[str, float | int | str] = field(default_factory=dict)
    """How the fit went: iterations, rollouts, seconds, why it stopped."""
    vibrations: tuple[MeasuredVibration, ...] = ()
    """Measured vibrations beside the model."""
    pairs: tuple[NumberPair, ...] = ()
    """Numbers that are hard to tell apart."""

    def __getitem__(self, name: str) -> Estimated:
        for one in self.estimates:
            if one.name == name:
                return one
        raise UsageError(f"'{name}' was not free; choose {' or '.join(one.name for one in self.estimates[:8])}")

    def __repr__(self) -> str:
        return f"<Identification of {self.robot}: {len(self.estimates)} numbers from {len(self.explained)} logs>"

    def summary(self, notes: bool = True) -> str:
        """Numbers, shares, and unless they are said elsewhere notes, as text, a line each."""
        lines = [
            f"{one.name}: {one.start:.4g} -> {one.value:.4g} {one.unit}".rstrip() + f"  ({one.interval})"
            for one in self.estimates
        ]
        lines += [log.line() for log in self.explained] + [one.line() for one in self.vibrations]
        if notes:
            lines += [f"undetermined: {line}" for line in self.undetermined]
            lines += [f"note: {line}" for line in self.notes]
        return "\n".join(lines)

    def to_json(self) -> str:
        """All but the curves."""
        table = {
            "robot": self.robot,
            "estimates": [asdict(one) for one in self.estimates],
            "explained": [
                {"log": x.log, "held_out": x.held_out, "distance": x.distance}
                | {of: x.share(of) for of in ("windows", "whole", "before")}
                for x in self.explained
            ],
            "undetermined": list(self.undetermined),
            "pairs": [asdict(one) for one in self.pairs],
            "notes": list(self.notes),
            "whiteness": dict(self.whiteness),
            "vibrations": [asdict(one) for one in self.vibrations],
            "frequencies": list(self.frequencies),
            "fit": dict(self.tried),
        }
        return json.dumps(_finite(table), indent=1)

    def sensors_text(self) -> str:
        """A table of the columns, TOML, with their identified numbers."""
        return columns_text(self.columns)

    def report(self) -> str:
        """One HTML page: measured against model, numbers with intervals, what is odd and what is left open."""
        from .report import report_html

        return report_html(self)

    @property
    def explains(self) -> bool:
        """Whether the model explains something of every sensor of the fitted logs."""
        return all(x > 0 for log in self.explained if not log.held_out for x in log.share("windows").values())

    def robot_text(self, robot_file: str | os.PathLike[str]) -> str:
        """The text of a robot file with the identified parameters in it, intervals as comments, all else as it is."""
        file = one_line(os.fsdecode(robot_file))
        own = {name: one for one in self.estimates if one.kind == "parameter" for name in one.members}
        doubt = "" if self.explains else "; not to be trusted: the model does not explain the log"
        notes = {name: (one.interval if one.determined else "undetermined") + doubt for name, one in own.items()}
        text = decode(read(robot_file, file), file)
        values = {name: one.value for name, one in own.items()}
        return with_values(text, values, notes, file, folder_of(robot_file))


def columns_text(columns: Columns) -> str:
    """A table of columns as TOML."""
    lines = [] if columns.time == TIME else [f"time = {json.dumps(columns.time)}", ""]
    lines += ["static = true", ""] if columns.static else []
    for column in columns.columns:
        stated = column.model_dump(exclude_defaults=True)
        lines += ["[[columns]]", *(f"{key} = {_toml(value)}" for key, value in stated.items()), ""]
    return "\n".join(lines)


def _toml(value: object) -> str:
    """A value of a column in TOML."""
    if isinstance(value, dict):
        return f"{{ {', '.join(f'{key} = {_toml(x)}' for key, x in value.items() if x is not None)} }}"
    if isinstance(value, list | tuple):
        return _toml(value[0]) if len(value) == 1 else f"[{', '.join(map(_toml, value))}]"
    return json.dumps(value) if isinstance(value, str) else repr(value)


def _finite(value: object) -> object:
    """Numbers that JSON cannot state become null."""
    if isinstance(value, dict):
        return {key: _finite(x) for key, x in value.items()}
    if isinstance(value, list):
        return [_finite(x) for x in value]
    return None if isinstance(value, float) and not np.isfinite(value) else value
