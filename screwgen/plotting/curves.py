"""Curves over time: thinned without losing peaks, in suitable units, on scales that ignore short transients."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..elements import ADDED
from .look import GREY, SMALL

if TYPE_CHECKING:
    from matplotlib.axes import Axes

NOTHING = 1e-12
"""What never exceeds this, in SI units, counts as zero throughout."""
MOST_POINTS = 4000
TRANSIENT = 0.05
"""The share of a run that counts as its start."""
SPOILT = 2.5
"""A start that takes this many times the scale of the rest is cut off."""
FAINT = 1e-6
"""A rest that varies by less than this share of the whole is no reason to cut the start off."""
FLAT = 1e-3
"""The least extent of a scale, over the largest value on it."""
PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


class AxisCurves(NamedTuple):
    """A panel of quantities that joint axes or their drives have: the columns of one array whose names have a word."""

    title: str
    symbol: str
    unit: str
    array: str
    """The attribute of a run."""
    word: str
    """What the names of the panel's columns have behind that of the link."""
    kind: str = ""
    """What stands beside the curves: the `goal` of an angle or a slide, the `bound` of a torque or a force."""


AXIS_CURVES = (
    AxisCurves("Joint angles", "q", "rad", "q", ".joint[", "goal"),
    AxisCurves("Slides", "q", "m", "q", ".slide[", "goal"),
    *(AxisCurves(one.title, one.symbol, one.unit, "q", f".{one.name}[") for one in ADDED),
    AxisCurves("Torques", "τ", "N·m", "tau", ".torque[", "bound"),
    AxisCurves("Forces of drives", "f", "N", "tau", ".force[", "bound"),
    AxisCurves("Given accelerations, rad/s² or m/s²", "a", "", "tau", ".acceleration["),
    AxisCurves("Efforts of drives, N·m or N", "τ", "", "drive_effort", ".effort["),
    AxisCurves("Power of drives", "P", "W", "drive_power", ".power["),
    AxisCurves("Power of drives", "P", "W", "effort_power", ".power["),
    AxisCurves("Brakes, 0 open, 1 closed", "b", "", "tau", ".brake["),
    AxisCurves("Efforts of brakes, N·m or N", "τ", "", "drive_effort", ".brake_effort["),
    AxisCurves("Power of brakes", "P", "W", "effort_power", ".brake_power["),
)
"""The panels of axes, for figures and for the viewer."""


class Scale(NamedTuple):
    """The limits of an axis in `unit`, which is SI over `factor`, and a text on values beyond them, perhaps empty."""

    low: float
    high: float
    factor: float
    unit: str
    note: str = ""


def thin(t: np.ndarray, values: np.ndarray, most: int = MOST_POINTS) -> tuple[np.ndarray, np.ndarray]:
    """At most `most` of the samples (N,): the smallest and the largest of every stretch, in their order."""
    if len(t) <= most:
        return t, values
    edges = np.linspace(0, len(t), most // 2).round().astype(int)
    pairs = [(a + np.argmin(values[a:b]), a + np.argmax(values[a:b])) for a, b in pairwise(edges)]
    kept = np.unique([0, *np.ravel(pairs), len(t) - 1])
    return t[kept], values[kept]


def prefixed(size: float, unit: str) -> tuple[float, str]:
    """Factor to, and name of, the unit that suits values up to `size` SI units: mm, kN, mrad; kg·m/s and "" stay."""
    power = 0
    if not unit:
        return 1.0, unit
    while power > -12 and not unit.startswith("k") and size * 10.0**-power < 0.2:
        power -= 3
    while power < 9 and size * 10.0**-power >= 2e4 and unit != "rad" and not unit.startswith("k"):
        power += 3
    return 10.0**-power, PREFIXES[power] + unit


def scale(
    t: np.ndarray, curves: Sequence[np.ndarray], unit: str, bounds: Sequence[float] = (), ends: Sequence[float] = ()
) -> Scale:
    """The scale for curves (N,) over t, SI: all values, unless a transient at the start would flatten the rest.

    `bounds`: limits ±b of the curves; they are on the scale where that leaves half of it to the curves.
    `ends`: limits of single signs, likewise.
    """
    low, high, peak = _extent(t, curves)
    near = [x for x in ends if low - (high - low) / 2 <= x <= high + (high - low) / 2]
    low, high = min([low, *near]), max([high, *near])
    size = max(abs(low), abs(high))
    shown = [b for b in bounds if b <= 2 * size]
    low, high = min([low, *(-b for b in shown)]), max([high, *shown])
    factor, unit = prefixed(max(abs(low), abs(high)), unit)
    notes = [f"start off scale: {number(factor * peak[0])} {unit} at {number(peak[1])} s"] if peak else []
    if len(shown) < len(bounds):
        notes.append(f"limits off scale: from ±{number(factor * min(set(bounds) - set(shown)))} {unit}")
    room = max(0.05 * (high - low), FLAT * size, NOTHING)
    return Scale(factor * (low - room), factor * (high + room), factor, unit, "; ".join(notes))


def _extent(t: np.ndarray, curves: Sequence[np.ndarray]) -> tuple[float, float, tuple[float, float] | None]:
    """Least and largest value to show, and the largest that is not shown with its time."""
    ends = lambda part: (min(float(c[part].min()) for c in curves), max(float(c[part].max()) for c in curves))  # noqa: E731
    least, most = ends(slice(None))
    low, high = ends(t > t[0] + TRANSIENT * (t[-1] - t[0]))
    if not FAINT * (most - least) < high - low < (most - least) / SPOILT:
        return least, most, None
    room = 0.2 * (high - low)
    low, high = max(least, low - room), min(most, high + room)
    extremes = [(c[k], t[k]) for c in curves for k in (c.argmin(), c.argmax()) if not low <= c[k] <= high]
    return low, high, max(extremes, key=lambda x: abs(x[0]))


def number(x: float) -> str:
    """A number in three figures, as one writes it."""
    digits, _, power = f"{x:.3g}".partition("e")
    text = digits + (f"·10{str(int(power)).translate(SUPERSCRIPTS)}" if power else "")
    return text.replace("-", "−")


def over_time(axes: Axes, t: np.ndarray, title: str, label: str, fitted: Scale) -> None:
    """The frame of curves over time: title, labels with units, limits, and a note on values beyond the scale."""
    axes.set_title(title)
    axes.set_xlabel("t (s)", loc="left" if fitted.note else "center")
    axes.set_ylabel(label)
    axes.set_xlim(t[0], t[-1])
    axes.set_ylim(fitted.low, fitted.high)
    if fitted.note:
        place = dict(xycoords="axes fraction", textcoords="offset points", ha="right", va="top")
        axes.annotate(fitted.note, (1, 0), (0, -17), fontsize=SMALL, color=GREY, annotation_clip=False, **place)
