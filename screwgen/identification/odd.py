"""What is odd about a fit: units that are off, filters taken for the truth, a hold-out that repeats the fit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..robot_model import RobotModel
from ..spec.columns import Columns
from ..spec.parameters import parameters
from .identification import Explained
from .logged_motion import moved_places
from .logs import Log
from .solve import Estimate, Fit
from .unknowns import Unknowns

FACTORS = {57.2958: "degrees and radians", 1000.0: "a factor of 1000, as between mm and m"}
NEAR = 0.8
"""By how much its logarithm may differ from theirs."""
ALIKE = 0.5
"""The correlation of readings and model from which on they may be the same in other units."""
POOR = 0.5
"""The share of variance over windows below which a sensor counts as not explained."""
COLOURED = 0.5
"""The correlation of neighbours from which on residuals are said to be no noise."""
DAMPED = 0.15
"""The damping ratio of a vibration from which on links are suspected not to have it."""
REPEATED = 0.98
"""The share of variance of a held-out log that a fitted one has at the same place, from which on it repeats it."""


def whiteness(fit: Fit, at: Estimate) -> dict[str, float]:
    """Of each sensor the correlation of a residual with the next: 0 of noise, near 1 where a cause is not modelled."""
    return dict(zip(fit.problem.sensor_names, fit.correlations(at.differences).tolist(), strict=True))


def of_fit(fit: Fit, at: Estimate) -> list[str]:
    """That it did not converge."""
    return [f"the fit ended early: {at.stopped}; what it had found until then is given"] if at.stopped else []


def of_shares(explained: Sequence[Explained]) -> list[str]:
    """Sensors of fitted logs that the model hardly explains although windows begin as they like."""
    low = [
        (log.log, name, 100 * share)
        for log in explained
        for name, share in log.share("windows").items()
        if not log.held_out and not share >= POOR
    ]
    said = "the model lacks what it measures, so numbers and intervals are not to be trusted"
    return [f"{log}: of the variance of {name} windows explain {_percent(x)}: {said}" for log, name, x in low]


def _percent(x: float) -> str:
    return "nothing" if not x > 0 else f"{x:.0f} %"


def of_inputs(model: RobotModel, columns: Columns) -> list[str]:
    """Inputs that act on the robot, and that no column drives. Accelerations of what columns move are known."""
    driven = {column.drives for column in columns.inputs}
    given = model.chain.given if columns.static else moved_places(model, columns).of_tau
    silent = [name for k, name in enumerate(model.tau_names) if k not in given and name not in driven]
    return [f"no column drives {', '.join(silent)}: taken as zero"] if silent else []


def coloured(correlations: Mapping[str, float]) -> list[str]:
    """Sensors whose residuals have a cause that the model lacks."""
    return [name for name, x in correlations.items() if x > COLOURED]


def of_whiteness(correlations: Mapping[str, float]) -> list[str]:
    """That residuals have such a cause."""
    found = coloured(correlations)
    said = "neighbours have much in common, so the model lacks something"
    more = "what of it acts as a number does has moved that number, and no interval counts it"
    return [f"residuals of {', '.join(found)} are no noise: {said}; {more}"] if found else []


def of_bounds(asked: Unknowns, at: Estimate, fit: Fit) -> list[str]:
    """Numbers that ended at a bound."""
    ended = [one.name for k, one in enumerate(asked) if at.sought[k] <= fit.low[k] or at.sought[k] >= fit.high[k]]
    return [f"{name} is at its bound; the data would have it beyond" for name in ended]


def of_units(explained: Sequence[Explained]) -> list[str]:
    """Sensors of fitted logs whose readings are some 57.3 or 1000 times what the model reads, or as many times less.

    The model is that of the start. That of the fit may have found numbers with which it reads what is wrong. Where over
    a whole log it falls or spins as the robot did not, it also varies many times more, but unlike the readings.
    """
    out = []
    for log in (x for x in explained if not x.held_out):
        for name, y, z in zip(log.sensors, log.readings.T, log.before.T, strict=True):
            there = np.isfinite(y) & np.isfinite(z)
            sizes = np.std(y[there]), max(np.std(z[there]), 1e-300)
            factor, together = sizes[0] / sizes[1], np.mean((y[there] - y[there].mean()) * (z[there] - z[there].mean()))
            if abs(together) < ALIKE * sizes[0] * sizes[1]:
                continue
            for known, said in FACTORS.items():
                if any(abs(np.log(max(factor, 1e-300) / way)) < NEAR for way in (known, 1 / known)):
                    much = f"vary {factor:.2g} times as much as those of the model"
                    out.append(f"{log.log}: readings of {name} {much}: {said}? state the unit")
    return out


def of_filters(model: RobotModel, columns: Columns, asked: Unknowns, p: np.ndarray, first: float) -> list[str]:
    """Damping of links that no such link has, at parameters (n,), though no filter is stated.

    A ratio is that of a link's own modes. The loaded arm vibrates more slowly, at its `first` frequency (Hz), and its
    damping is less in proportion.
    """
    damping = {x.name: (x.field, x.link) for x in parameters(model.robot) if x.field.startswith("damping.")}
    free = [name for one in asked for name in one.members if name in damping]
    if not free or any(column.filter for column in columns.sensors):
        return []
    lowest = 2 * np.pi * first
    own = dict(zip(model.parameter_names, p.tolist(), strict=True))
    found = []
    for name in free:
        field, link = damping[name]
        slowest = _bare(model, p, int(link or 0))
        share = own[name] * (lowest / 2 if field == "damping.time" else lowest / slowest)
        if share > DAMPED:
            found.append(f"{name} damps the slowest vibration with a ratio of {share:.2f}")
    said = "more than links do: does the logger filter? state its filter, or leave its cutoff free"
    return [f"{', '.join(found)}, {said}"] if found else []


def _bare(model: RobotModel, p: np.ndarray, link: int) -> float:
    """The slowest mode (rad/s) of a link by itself."""
    chain = model.chain
    at = next(i for i, segment in enumerate(chain.segments) if segment.link == link)
    K, M = (np.asarray(model.numpy(p).constants[at][name], float)[: chain.keys[at].modes] for name in ("K", "M_eta"))
    return float(np.sqrt(np.min(K / M)))


def of_repetition(logs: Sequence[Log], compared: Sequence[Log], columns: Columns) -> list[str]:
    """Held-out logs that do what the fitted ones did."""
    out = []
    for other in compared:
        share, log = max(((_repeated(log, other, columns), log) for log in logs), key=lambda x: x[0])
        if share > REPEATED:
            said = f"{100 * share:.1f} % of its variance is that of {log.name}"
            out.append(f"{other.name}, held out, repeats the fit: {said}; it says little of other motions")
    return out


def _repeated(log: Log, other: Log, columns: Columns) -> float:
    """The largest share of variance of a log that a shift of another one has, of all sensors together."""
    if abs(log.step / other.step - 1) > 1e-3:
        return 0.0
    names = [column.name for column in columns.sensors]
    y, z = (np.nan_to_num(np.column_stack([x.columns[name] for name in names])) for x in (other, log))
    size = np.maximum(y.std(axis=0), 1e-300)
    y, z = (y - y.mean(axis=0)) / size, (z - y.mean(axis=0)) / size
    z = z - z.mean(axis=0)
    n = len(y) + len(z)
    product = np.fft.irfft(np.sum(np.conj(np.fft.rfft(y, n, axis=0)) * np.fft.rfft(z, n, axis=0), axis=1), n)
    best = 0.0
    for lag in np.argsort(-product)[:3]:
        shift = int(lag) if lag < len(z) else int(lag) - n
        first, last = max(0, -shift), min(len(y), len(z) - shift)
        if last - first > len(y) / 2:
            a, b = y[first:last], z[first + shift : last + shift]
            best = max(best, 1 - np.sum((a - b) ** 2) / np.sum((a - a.mean(axis=0)) ** 2))
    return float(best)
