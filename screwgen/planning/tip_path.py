"""Paths of a tip from rest to rest: arcs, lines, and what goes through rows of a table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..errors import UsageError
from ..lazily import interpolate, transform
from ..spec.tip_path import CircularPath, StraightPath, TipPathFile

LEAST = 8
"""The fewest rows of a table."""
UNEVEN = 0.01
"""By how much of their mean two steps of a table's clock may differ."""
CORNER = 1.6
"""The ratio of the largest accelerations over one step and over two: 4 where a path jumps, 2 where its rate does."""
COARSE = 1e-3
"""By the size of a path, how far one through every second row may be from the rows between."""
DEGREE = 7


@dataclass(frozen=True, eq=False)
class TipPath:
    """A path from rest to rest: at times (…), s, places (…, 3), m, in inertial axes. Before and behind it rests."""

    curve: Callable[[np.ndarray], np.ndarray]
    """Of times from 0 to `time`."""
    time: float
    """s."""
    turn: float = 0.0
    """The angle of an arc, rad."""

    def __call__(self, t: np.ndarray) -> np.ndarray:
        return self.curve(np.clip(np.asarray(t, float), 0.0, self.time))


def eased(s: np.ndarray) -> np.ndarray:
    """From 0 to 1 over shares of a time, with rates, accelerations and jerks that are zero at both ends."""
    return s**4 * (35 - 84 * s + 70 * s**2 - 20 * s**3)


def shaped(stated: TipPathFile) -> TipPath:
    """The path that a file states; the tip goes along it from rest to rest, eased."""
    shape = _arc(stated.circle) if stated.circle is not None else _line(stated.line)
    turn = 0.0 if stated.circle is None else stated.circle.angle
    return TipPath(lambda t: shape(eased(t / stated.time)), stated.time, turn)


def _arc(circle: CircularPath) -> Callable[[np.ndarray], np.ndarray]:
    """Places over shares of the way."""
    centre, axis = np.array(circle.centre), np.array(circle.axis)
    arm, turn = np.array(circle.start) - centre, circle.angle * axis / np.linalg.norm(axis)

    def place(s: np.ndarray) -> np.ndarray:
        turned = transform.Rotation.from_rotvec(s.reshape(-1, 1) * turn).apply(arm)
        return centre + turned.reshape(*s.shape, 3)

    return place


def _line(line: StraightPath | None) -> Callable[[np.ndarray], np.ndarray]:
    """Places over shares of the way."""
    assert line is not None, "a file states one shape"
    start, way = np.array(line.start), np.array(line.goal) - np.array(line.start)
    return lambda s: start + s[..., None] * way


def through_rows(t: np.ndarray, places: np.ndarray) -> TipPath:
    """The path through places (k, 3), m, at times (k,), s, that grow evenly; the first is its start.

    A spline of order 7, at rest at both ends up to its third derivative. Raises UsageError, a fault and its remedy,
    where rows are too few or too far apart, jump, or do not begin and end at rest.
    """
    if len(t) < LEAST:
        raise UsageError(f"has {len(t)} rows; a path needs {LEAST} or more")
    steps, mean = np.diff(t), (t[-1] - t[0]) / (len(t) - 1)
    if (worst := np.abs(steps / mean - 1.0)).max() > UNEVEN:
        k = int(worst.argmax())
        said = f"t goes by {steps[k]:.4g} s after {t[k]:.6g} s, on average by {mean:.4g} s"
        raise UsageError(f"{said}; give rows at even times")
    size = np.ptp(places, axis=0).max()
    if not size:
        raise UsageError("stays at one place; give a path that goes somewhere")
    still = 4
    rested = np.concatenate([np.repeat(places[:1], still, axis=0), places, np.repeat(places[-1:], still, axis=0)])
    if k := jump(rested, mean):
        at = t[0] + mean * np.clip(k - still, 0, len(t) - 1)
        said = f"jumps, or its rate does, at {at:.4g} s"
        raise UsageError(f"{said}; begin and end at rest, and give smooth places with all their digits")
    even = mean * np.arange(len(t))
    half = np.append(np.arange(0, len(t) - 1, 2), len(t) - 1)
    between = np.setdiff1d(np.arange(len(t)), half)
    off = np.abs(_spline(even[half], places[half])(even[between]) - places[between]).max(axis=1)
    if off.max() > COARSE * size:
        at = t[between[int(off.argmax())]]
        said = f"is sampled too coarsely: every second row alone misses the place at {at:.4g} s by {off.max():.2g} m"
        raise UsageError(f"{said}; give rows at shorter times")
    return TipPath(_spline(even, places), float(even[-1]))


def _spline(t: np.ndarray, places: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
    """Through places (k, 3) at times (k,), the last of which may lie closer."""
    unit, none = t[-1] / (len(t) - 1), np.zeros(3)
    rest = [(k, none) for k in (1, 2, 3)]
    spline = interpolate.make_interp_spline(t / unit, places, k=DEGREE, bc_type=(rest, rest))
    return lambda at: spline(at / unit)


def jump(x: np.ndarray, step: float) -> int:
    """The sample of rows (count, …) at which they or their rates jump, 0 where they are smooth."""
    over = [np.abs(x[2 * k :] - 2 * x[k:-k] + x[: -2 * k]).max(axis=1) / (k * step) ** 2 for k in (1, 2)]
    return int(over[0].argmax()) + 1 if over[0].max() > CORNER * over[1].max() else 0
