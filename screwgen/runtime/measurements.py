"""What estimators are told: the noise model, measurements, inputs; and the innovations that they return."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..algorithms.gauges import gauges
from ..algorithms.joint_sensors import POSE_SIZES, encoders, pose_measurements, pose_sensors
from ..arguments import Loads, Numbers, array, real_numbers, whole
from ..backends.c.estimator import PATIENCE
from ..errors import UsageError
from ..topology.chain import Chain

ABSENT = {"base": "a fixed base", "joint": "no ball joint"}
"""What a robot has that lacks the measurements of a pose whose names begin so."""
Measured = dict[str, tuple[np.ndarray, np.ndarray]]
"""Of every measurement its values, and which of its entries were made."""


@dataclass(frozen=True)
class Noise:
    """The noise model of a filter; a single number applies to all entries.

    ``density_q``, ``density_v`` (nv): spectral densities of white noise on the rates of q and v, rad²/s and rad²/s³
    (modes and slides: m²/s, m²/s³).  ``encoder`` (n_joints, rad or m), ``strain`` (gauges), ``acceleration``
    (3, m/s²): standard deviations of a measurement.  ``fibre`` (gauges): distance of each gauge from the centreline, m,
    on the side of positive y or z, not zero where ``strain`` is stated.  Of a floating base ``base_position`` (3, m),
    ``base_attitude`` (3, rad, about axes of F_1) and ``base_rate`` (3, rad/s), and densities that belong to changes
    [turn; shift] of its pose, rad and m. Of ball joints ``joint_attitude`` and ``joint_rate`` (3 each), about axes of
    the link; encoders measure the others.

    ``gate``: an update refuses an entry whose innovation exceeds so many of its standard deviations; 0: none is
    refused. ``patience``: so often in a row, then it is believed until it is within the gate again; after refusals as
    often as it was within the gate since then, if that is less. What is believed beyond the gate makes all deviations
    larger, and the first in a row moves what it measures, and nothing else. ``doubt``: between so many standard deviations and the
    gate an entry counts less, with the weight (doubt / normalised innovation)²; 0: all within the gate count in full.
    """

    density_v: np.ndarray | float
    density_q: np.ndarray | float = 0.0
    encoder: np.ndarray | float = 0.0
    strain: np.ndarray | float = 0.0
    acceleration: np.ndarray | float = 0.0
    fibre: np.ndarray | float = 0.0
    base_position: np.ndarray | float = 0.0
    base_attitude: np.ndarray | float = 0.0
    base_rate: np.ndarray | float = 0.0
    joint_attitude: np.ndarray | float = 0.0
    joint_rate: np.ndarray | float = 0.0
    gate: float = 0.0
    patience: int = PATIENCE
    doubt: float = 0.0


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


def sensors(chain: Chain) -> dict[str, tuple[int, int, int]]:
    """How many values, flags and variances every measurement has."""
    sizes = {"encoder": len(encoders(chain)), "strain": len(gauges(chain)), "acceleration": 3}
    return {name: (size,) * 3 for name, size in sizes.items()} | pose_measurements(chain)


# ------------------------------------------------------------------------------ the noise model


def spread(values: Any, name: str, size: int) -> np.ndarray:
    """Deviations or densities (size,), of which one number stands for all; raises UsageError where any is negative."""
    given = real_numbers(values)
    if given is None or given.shape not in ((), (1,), (size,)) or not (np.isfinite(given) & (given >= 0)).all():
        raise UsageError(f"{name}: must be a number >= 0, or {size} of them")
    return np.broadcast_to(given, size)


def fibres(chain: Chain, noise: Noise) -> np.ndarray:
    """The distances of the gauges (gauges,); raises UsageError unless strains are known to follow from them."""
    size, given = len(gauges(chain)), real_numbers(noise.fibre)
    if given is None or given.shape not in ((), (1,), (size,)) or not np.isfinite(given).all():
        raise UsageError(f"fibre: must be a finite number, or {size} of them")
    given = np.broadcast_to(given, size)
    if ((spread(noise.strain, "strain", size) > 0) & (given == 0)).any():
        raise UsageError("fibre: is 0 of a gauge whose strain is measured; state its distance from the centreline, m")
    return given


def check_noise(chain: Chain, noise: Noise) -> None:
    """Raises UsageError where a density or a deviation is negative or no number, or the number of them is wrong."""
    sizes = {"density_q": chain.nv, "density_v": chain.nv} | {
        name: size for name, (_, _, size) in sensors(chain).items()
    }
    for name, size in sizes.items():
        spread(getattr(noise, name), name, size)
    fibres(chain, noise)
    gate = real_numbers(noise.gate)
    if gate is None or gate.shape or not 0 <= gate < np.inf:
        raise UsageError("gate: must be a finite number >= 0, of standard deviations")
    doubt = real_numbers(noise.doubt)
    if doubt is None or doubt.shape or not 0 <= doubt <= gate:
        raise UsageError("doubt: must be a number from 0 to the gate, of standard deviations")
    whole(noise.patience, "patience", 1)


# ------------------------------------------------------------------------------ arguments of calls


def checked_start(
    chain: Chain, q: Numbers, v: Numbers, deviation_q: Any, deviation_v: Any
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """The arguments of ``start`` as arrays; raises UsageError."""
    q, v = array(q, "q", (chain.nq,)), array(v, "v", (chain.nv,))
    for one in pose_sensors(chain):
        if not one.turn(q).any():
            whose = "the base" if one.word == "base" else f"link '{chain.names[one.part.link]}'"
            raise UsageError(f"q: the quaternion of {whose} is zero; give [1, 0, 0, 0] for no turn")
    return q, v, spread(deviation_q, "deviation_q", chain.nv), spread(deviation_v, "deviation_v", chain.nv)


def checked_input(chain: Chain, tau: Loads, w_ext: Loads) -> tuple[np.ndarray, np.ndarray]:
    """Torques and tensions (n_tau,), and wrenches (n, 6); raises UsageError."""
    return array(tau, "tau", (chain.n_tau,)), array(w_ext, "w_ext", (chain.n, 6))


def check_step(dt: float) -> None:
    """Raises UsageError unless a step is a time > 0."""
    if not (np.isfinite(dt) and dt > 0):
        raise UsageError(f"the step is {dt:g} s; it must be a finite number > 0")


def checked_measurements(chain: Chain, noise: Noise, given: Mapping[str, Any]) -> Measured:
    """The values of every measurement, and which entries were made: what is None or NaN was not; raises UsageError."""
    out, known = {}, sensors(chain)
    for name in given.keys() - known.keys():
        raise UsageError(_no_measurement(chain, name))
    for name, (size, flags, variances) in known.items():
        values = _values(name, given.get(name), size)
        made = ~np.isnan(values)
        if flags < size:
            values, made = _directions(values.reshape(flags, -1)), made.reshape(flags, -1).all(axis=1)
            if not values[made].any(axis=1).all():
                raise UsageError(f"{name} is zero; give a quaternion")
            values = values.ravel()
        if not np.isfinite(values[~np.isnan(values)]).all():
            raise UsageError(f"{name} is not finite; give NaN for what was not measured")
        of_made = np.repeat(made, variances // flags if flags else 1)
        if not (spread(getattr(noise, name), name, variances)[of_made] > 0).all():
            raise UsageError(f"noise: {name} has no standard deviation > 0; state it for what is measured")
        out[name] = values, made
    return out


def _values(name: str, given: Any, size: int) -> np.ndarray:
    try:
        values = np.full(size, np.nan) if given is None else np.array(given, float)
    except (TypeError, ValueError):
        raise UsageError(f"{name} is not an array of numbers; give {size} numbers") from None
    if values.shape != (size,):
        raise UsageError(f"{name}: shape {values.shape}, must be ({size},); give NaN for what was not measured")
    return values


def _no_measurement(chain: Chain, name: str) -> str:
    """Why a name is not one of a robot's measurements, and what to do."""
    word, _, what = name.partition("_")
    if word in ABSENT and what in POSE_SIZES and (word, what) != ("joint", "position"):
        return f"{name}: robot '{chain.robot.name}' has {ABSENT[word]}; leave it out"
    return f"{name}: is no measurement; choose of {', '.join(sensors(chain))}"


def _directions(quaternions: np.ndarray) -> np.ndarray:
    """The same directions (n, 4): these count, and the squares of large numbers are infinite."""
    largest = np.max(np.abs(quaternions), axis=1, keepdims=True)
    scale = np.where(np.isfinite(largest) & (largest > 0), largest, 1.0)
    return quaternions / scale
