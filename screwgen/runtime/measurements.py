"""What estimators are told: the noise model, measurements, inputs; and the innovations that they return."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..algorithms.measurement import Measurement
from ..algorithms.measurements import ROWS
from ..arguments import Loads, Numbers, array, real_numbers, suggestion, whole
from ..backends.c.estimator import PATIENCE
from ..errors import UsageError
from ..topology.chain import Chain

Measured = dict[str, tuple[np.ndarray, np.ndarray]]
"""Of every measurement its values, and which of its groups of entries were made."""
OF_ALL = [row for row in ROWS if not row.missing]
IN_ORDER = (
    *(row.name for row in OF_ALL),
    *(number.name for row in OF_ALL for number in row.numbers if number.stated),
    *(row.name for row in ROWS if row.missing),
)
"""What a noise model may be told by position: deviations of what all robots have, their numbers, then of the rest."""


@dataclass(frozen=True, init=False)
class Noise:
    """The noise model of a filter; a single number applies to all entries.

    ``density_v``, ``density_q`` (nv): spectral densities of white noise on the rates of v and q, rad²/s³ and rad²/s
    (modes and slides: m²/s³, m²/s); of a floating base they belong to changes [turn; shift] of its pose, rad and m.
    ``density_v`` (nvz) has those of internal states behind, rad²/s or m²/s, which are zero unless they are stated so:
    a single number is that of all accelerations.
    By the name of each measurement the standard deviation of its entries, in its unit, of attitudes about axes of what
    turns: ``encoder=1e-4``. By their names the numbers of a sensor: ``fibre`` (gauges), the distance of each gauge from
    the centreline, m, on the side of positive y or z, not zero where ``strain`` is stated. A measurement that is
    ``calibrated`` has ``<name>_scale`` and ``<name>_offset``: it reads scale × value + offset.

    ``gate``: an update refuses an entry whose innovation exceeds so many of its standard deviations; 0: none is
    refused. ``patience``: so often in a row, then it is believed until it is within the gate again; after refusals as
    often as it was within the gate since then, if that is less. What is believed beyond the gate makes all deviations
    larger, and the first in a row moves what it measures, and nothing else. ``doubt``: between so many standard
    deviations and the gate an entry counts less, with the weight (doubt / normalised innovation)²; 0: all within the
    gate count in full.
    A measurement that is ``gated`` has ``<name>_gate``, which counts in place of ``gate`` unless it is 0.
    """

    density_v: np.ndarray | float
    density_q: np.ndarray | float = 0.0
    gate: float = 0.0
    patience: int = PATIENCE
    doubt: float = 0.0
    sensors: Mapping[str, Any] = field(default_factory=dict)
    """Deviations of measurements and numbers of sensors, by name; what is not stated is as their rows say, mostly zero,
    and scales are one."""

    def __init__(
        self,
        density_v: Any,
        density_q: Any = 0.0,
        *in_order: Any,
        gate: float = 0.0,
        patience: int = PATIENCE,
        doubt: float = 0.0,
        sensors: Mapping[str, Any] | None = None,
        **named: Any,
    ):
        positions = dict(zip(IN_ORDER, in_order, strict=False))
        if len(in_order) > len(IN_ORDER) or positions.keys() & named.keys():
            raise TypeError("Noise: more arguments by position than there are, or the same again by name")
        everything = {**(sensors or {}), **positions, **named}
        said = {"density_v": density_v, "density_q": density_q, "gate": gate, "patience": patience, "doubt": doubt}
        for name, value in {**said, "sensors": everything}.items():
            object.__setattr__(self, name, value)

    def __getattr__(self, name: str) -> Any:
        """A deviation or number of a sensor that the product knows, or that was stated."""
        sensors = vars(self).get("sensors", {})
        if name not in sensors and name not in IN_ORDER:
            raise AttributeError(f"'Noise' has no attribute '{name}'", name=name, obj=self)
        return sensors.get(name, 0.0)


@dataclass(frozen=True)
class Innovation:
    """What an update made of a measurement, entry by entry; of an attitude in turns about the axes of its link."""

    value: np.ndarray
    """What was measured less what the estimate before the update says; NaN where nothing was measured."""
    normalised: np.ndarray
    """The value over its standard deviation."""
    refused: np.ndarray
    """Whether it was beyond the gate and did not change the estimate."""
    weight: np.ndarray
    """1 where it counted in full, 0 where it was refused or not measured, between them where it was doubted."""


@dataclass(frozen=True)
class Consistency:
    """Whether an update fits the model: what a chi-squared number is if model and noise are right."""

    squared: float = 0.0
    """The normalised innovation squared, νᵀ S⁻¹ ν of all entries that the update took, with their variances S."""
    entries: int = 0
    """How many these are: the degrees of freedom, and the mean of `squared`; its variance is twice that."""


# ------------------------------------------------------------------------------ the noise model


def spread(values: Any, name: str, size: int) -> np.ndarray:
    """Deviations or densities (size,), of which one number stands for all; raises UsageError where any is negative."""
    given = real_numbers(values)
    if given is None or given.shape not in ((), (1,), (size,)) or not (np.isfinite(given) & (given >= 0)).all():
        raise UsageError(f"{name}: must be a number >= 0, or {size} of them")
    return np.broadcast_to(given, size)


def of_rates(chain: Chain, values: Any, name: str) -> np.ndarray:
    """The same of `v` (nvz,): where rates (nv,) alone are given, or one number for them, internal states have 0."""
    if chain.n_internal and np.shape(values) == (chain.nvz,):
        return spread(values, name, chain.nvz)
    return np.append(spread(values, name, chain.nv), np.zeros(chain.n_internal))


def deviations(chain: Chain, row: Measurement, noise: Noise) -> np.ndarray:
    """The standard deviation of every entry of a measurement."""
    return spread(noise.sensors.get(row.name, row.noise), row.name, row.size(chain))


def numbers(chain: Chain, row: Measurement, noise: Noise) -> dict[str, np.ndarray]:
    """The numbers of a sensor that a caller may state; raises UsageError unless readings are known to follow."""
    out, measured = {}, deviations(chain, row, noise) > 0
    for number in row.numbers:
        if callable(number.start):
            continue
        size, given = number.size(chain), real_numbers(noise.sensors.get(number.name, number.starts(chain)))
        if given is None or given.shape not in ((), (1,), (size,)) or not np.isfinite(given).all():
            raise UsageError(f"{number.name}: must be a finite number, or {size} of them")
        out[number.name] = np.broadcast_to(given, size)
        if number.zero and (measured & (out[number.name] == 0)).any():
            raise UsageError(f"{number.name}: {number.zero}")
    return out


def gate_name(row: Measurement) -> str:
    """What a measurement's own gate is called."""
    return f"{row.name}_gate"


def gate_of(row: Measurement, noise: Noise) -> float:
    """The gate of a measurement: its own, if it has one that is not 0, or that of all; raises UsageError."""
    own = _gate(noise.sensors.get(gate_name(row), 0.0), gate_name(row)) if row.gated else 0.0
    return own or _gate(noise.gate, "gate")


def _gate(given: Any, name: str) -> float:
    gate = real_numbers(given)
    if gate is None or gate.shape or not 0 <= gate < np.inf:
        raise UsageError(f"{name}: must be a finite number >= 0, of standard deviations")
    return float(gate)


def known(rows: Sequence[Measurement]) -> list[str]:
    """The names of what a noise model may state of these measurements."""
    own = [name for row in rows for name in (row.name, *(number.name for number in row.numbers if number.stated))]
    return own + [gate_name(row) for row in rows if row.gated]


def check_noise(chain: Chain, rows: Sequence[Measurement], noise: Noise) -> None:
    """Raises UsageError where a density or a deviation is negative or no number, or the number of them is wrong."""
    spread(noise.density_q, "density_q", chain.nv)
    of_rates(chain, noise.density_v, "density_v")
    for row in rows:
        deviations(chain, row, noise)
    for row in rows:
        numbers(chain, row, noise)
    gates, doubt = [_gate(noise.gate, "gate")], real_numbers(noise.doubt)
    gates = [gate_of(row, noise) for row in rows] or gates
    if doubt is None or doubt.shape or not 0 <= doubt <= min(gates):
        raise UsageError("doubt: must be a number from 0 to the gate, of standard deviations")
    whole(noise.patience, "patience", 1)
    for name in noise.sensors.keys() - {*known(rows), *IN_ORDER}:
        raise UsageError(f"{name}: is nothing that is measured; {suggestion(name, known(rows))}")


# ------------------------------------------------------------------------------ arguments of calls


def checked_start(
    chain: Chain, q: Numbers, v: Numbers, deviation_q: Any, deviation_v: Any
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """The arguments of ``start`` as arrays; raises UsageError."""
    q, v = array(q, "q", (chain.nq,)), array(chain.with_internal(v), "v", (chain.nvz,))
    for part in chain.curved:
        first = part.q.start + (part.joint.turn_at or 0)
        if not q[first : first + 4].any():
            whose = "the base" if part.joint.in_space else f"link '{chain.names[part.link]}'"
            raise UsageError(f"q: the quaternion of {whose} is zero; give [1, 0, 0, 0] for no turn")
    return q, v, spread(deviation_q, "deviation_q", chain.nv), of_rates(chain, deviation_v, "deviation_v")


def checked_input(chain: Chain, tau: Loads, w_ext: Loads) -> tuple[np.ndarray, np.ndarray]:
    """Torques and tensions (n_tau,), and wrenches (n, 6); raises UsageError."""
    return array(tau, "tau", (chain.n_tau,)), array(w_ext, "w_ext", (chain.n, 6))


def check_step(dt: float) -> None:
    """Raises UsageError unless a step is a time > 0."""
    if not (np.isfinite(dt) and dt > 0):
        raise UsageError(f"the step is {dt:g} s; it must be a finite number > 0")


def checked_measurements(
    chain: Chain, rows: Sequence[Measurement], noise: Noise, in_order: Sequence[Any], named: Mapping[str, Any]
) -> Measured:
    """The values of every measurement, and which entries were made: what is None or NaN was not; raises UsageError.

    Values ``in_order`` are those of the first measurements.
    """
    names = [row.name for row in rows]
    given = dict(zip(names, in_order, strict=False))
    if len(in_order) > len(rows) or given.keys() & named.keys():
        said = "update: more values by position than there are measurements, or the same again by name"
        raise UsageError(f"{said}; in order they are {', '.join(names)}")
    given |= named
    for name in given.keys() - set(names):
        raise UsageError(_no_measurement(chain, rows, name))
    return {row.name: _readings(chain, row, noise, given.get(row.name)) for row in rows}


def _readings(chain: Chain, row: Measurement, noise: Noise, given: Any) -> tuple[np.ndarray, np.ndarray]:
    """The values of a measurement, and which groups of its entries were made; raises UsageError."""
    name, values = row.name, _values(row.name, given, row.n_values(chain))
    made = ~np.isnan(values)
    if row.readings > 1:
        values, made = _directions(values.reshape(-1, row.readings)), made.reshape(-1, row.readings).all(axis=1)
        if not values[made].any(axis=1).all():
            raise UsageError(f"{name} is zero; give a quaternion")
        values = values.ravel()
    if not np.isfinite(values[~np.isnan(values)]).all():
        raise UsageError(f"{name} is not finite; give NaN for what was not measured")
    if not (deviations(chain, row, noise)[np.repeat(made, row.group)] > 0).all():
        raise UsageError(f"noise: {name} has no standard deviation > 0; state it for what is measured")
    return values, made


def _values(name: str, given: Any, size: int) -> np.ndarray:
    try:
        values = np.full(size, np.nan) if given is None else np.array(given, float)
    except (TypeError, ValueError):
        raise UsageError(f"{name} is not an array of numbers; give {size} numbers") from None
    if values.shape != (size,):
        raise UsageError(f"{name}: shape {values.shape}, must be ({size},); give NaN for what was not measured")
    return values


def _no_measurement(chain: Chain, rows: Sequence[Measurement], name: str) -> str:
    """Why a name is not one of a filter's measurements, and what to do."""
    for row in ROWS:
        if row.name == name and not row.offered(chain):
            return f"{name}: robot '{chain.robot.name}' has {row.missing}; leave it out"
    return f"{name}: is no measurement; choose of {', '.join(row.name for row in rows)}"


def _directions(quaternions: np.ndarray) -> np.ndarray:
    """The same directions (n, 4): these count, and the squares of large numbers are infinite."""
    largest = np.max(np.abs(quaternions), axis=1, keepdims=True)
    scale = np.where(np.isfinite(largest) & (largest > 0), largest, 1.0)
    return quaternions / scale
