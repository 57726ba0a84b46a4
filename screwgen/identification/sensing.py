"""From what a sensor would read to what stands in the log: scale, offset, delay, and the filter of the logger."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from ..spec.columns import Column

NUMBERS = ("scale", "offset", "delay", "cutoff", "damping")
"""The numbers of a sensor that may be free."""


class Start(NamedTuple):
    """The reading of a column at the beginning of each lane and its rate, (lanes,) each: the state of a filter."""

    value: np.ndarray
    rate: np.ndarray


def numbers_of(column: Column) -> dict[str, float]:
    """The numbers of a sensor as they are stated."""
    own = {"scale": column.scale, "offset": column.offset, "delay": column.delay}
    if column.filter is not None:
        own["cutoff"] = column.filter.cutoff
        if column.filter.damping is not None:
            own["damping"] = column.filter.damping
    return own


def readings(values: np.ndarray, numbers: Mapping[str, np.ndarray], step: float, start: Start) -> np.ndarray:
    """What the log would have of values (lanes, samples), by `numbers` of the sensor (lanes,) each, NaN where unknown.

    A filter starts from the reading that was logged, so `start` is needed where there is one.
    """
    out = numbers["scale"][:, None] * values + numbers["offset"][:, None]
    if numbers["delay"].any():
        out = _delayed(out, numbers["delay"] / step)
    if "cutoff" in numbers:
        out = _filtered(out, numbers, step, start)
    return out


def _delayed(values: np.ndarray, late: np.ndarray) -> np.ndarray:
    """The values so many samples later, linear between them, NaN before the first."""
    at, out = np.arange(values.shape[1], dtype=float), np.empty_like(values)
    for k, own in enumerate(values):
        out[k] = np.interp(at - late[k], at, own, left=np.nan)
    return out


def _filtered(values: np.ndarray, numbers: Mapping[str, np.ndarray], step: float, start: Start) -> np.ndarray:
    """The low-pass of first or second order, by Euler's rule at the samples, lanes of equal numbers together."""
    known = [numbers["cutoff"], numbers.get("damping", np.zeros(len(values)))]
    kinds, of = np.unique(np.column_stack(known), axis=0, return_inverse=True)
    first = np.nan_to_num(values, nan=0.0) if np.isnan(values).any() else values
    out = np.empty_like(values)
    for k, (cutoff, damping) in enumerate(kinds):
        lanes = np.flatnonzero(of.ravel() == k)
        pull, began = 2 * np.pi * cutoff * step, Start(start.value[lanes], start.rate[lanes] * step)
        make = _second_order if "damping" in numbers else _first_order
        out[lanes] = make(first[lanes], pull, damping, began)
    return out


def _first_order(values: np.ndarray, pull: float, _: float, start: Start) -> np.ndarray:
    """``y[k + 1] = y[k] + pull (u[k] - y[k])`` from the logged reading on."""
    from scipy.signal import lfilter  # nearly a second, and most logs name no filter

    rest, _ = lfilter([pull], [1.0, pull - 1.0], values[:, :-1], axis=1, zi=((1.0 - pull) * start.value)[:, None])
    return np.column_stack([start.value, rest])


def _second_order(values: np.ndarray, pull: float, damping: float, start: Start) -> np.ndarray:
    """``y'' = pull² (u - y) - 2 damping pull y'`` per sample, from the logged reading and its rate on."""
    from scipy.signal import lfilter

    a1, a2 = 2 * damping * pull - 2.0, 1.0 - 2 * damping * pull + pull**2
    second = start.value + start.rate
    zi = np.column_stack([-a1 * second - a2 * start.value, -a2 * second])
    rest, _ = lfilter([pull**2], [1.0, a1, a2], values[:, :-2], axis=1, zi=zi)
    return np.column_stack([start.value, second, rest])
