"""Figures of both tasks."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from mpc.arms import LIMIT as ELLA_LIMIT
from mpc.arms import STEP

from screwgen.plotting import look

from .arm import FASTEST, LIMIT, H, Run


@look.styled
def ella(motion, goal, solutions) -> bytes:
    """Tip, torques and times of the motion of `make mpc`."""
    figure = look.canvas(9.5, 6, "ELLA by real-time iterations of acados")
    (away, times), (torques, spread) = figure.subplots(2, 2)
    t = STEP * np.arange(len(motion.tip))
    distance(away, {"tip": (t, motion.tip)}, goal, (5.0,))
    shares(torques, t, motion.tau / ELLA_LIMIT, ("base y", "base z", "elbow"))
    sampled(times, spread, [s.preparation for s in solutions], [s.feedback for s in solutions])
    return look.png(figure)


@look.styled
def arm(own: Run, richer: Run, place) -> bytes:
    """The same of the published arm, on its own model and on the richer plant."""
    figure = look.canvas(9.5, 9, "An arm with two flexible links: N = 125 at 5 ms")
    (away, times), (torques, spread), (rates, count) = figure.subplots(3, 2)
    t = H * np.arange(len(own.u))
    distance(away, {"own model": (t, own.tip), "richer plant": (t, richer.tip)}, place, (10.0,))
    names = ("base", "shoulder", "elbow")
    shares(torques, t, richer.u / LIMIT, names)
    nq = richer.x.shape[1] // 2
    shares(rates, t, richer.x[:, nq : nq + 3] / FASTEST, names)
    rates.set(title="joint rates", ylabel="share of the bound", xlabel="t (s)")
    sampled(times, spread, own.preparation, own.feedback)
    count.step(t, own.iterations, where="post", color=look.PALETTE[0])
    count.set(title="steps of the interior point method", xlabel="t (s)", ylabel="count", ylim=(0, None))
    return look.png(figure)


def distance(axes: Axes, tips: dict, place, bands) -> None:
    for (name, (t, tip)), shade in zip(tips.items(), look.PALETTE, strict=False):
        axes.semilogy(t, 1e3 * np.linalg.norm(tip - place, axis=1), color=shade, label=name)
    for band in bands:
        axes.axhline(band, label=f"{band:g} mm", **look.LIMITS)
    axes.set(title="tip", ylabel="from its goal (mm)", xlabel="t (s)")
    look.legend_above(axes)


def shares(axes: Axes, t, values, names) -> None:
    for column, name, shade in zip(values.T, names, look.PALETTE, strict=False):
        axes.plot(t, column, color=shade, label=name)
    for bound in (-1, 1):
        axes.axhline(bound, **look.LIMITS)
    axes.set(title="torques", ylabel="share of the limit", xlabel="t (s)")
    look.legend_above(axes)


def sampled(times: Axes, spread: Axes, preparation, feedback) -> None:
    parts = {"preparation": np.array(preparation), "feedback": np.array(feedback)}
    for (name, seconds), shade in zip(parts.items(), look.PALETTE, strict=False):
        times.plot(1e3 * seconds, ".", markersize=3, color=shade, label=name)
        spread.plot(1e3 * np.sort(seconds), np.linspace(0, 1, len(seconds)), color=shade, label=name)
    times.set(title="samples", xlabel="sample", ylabel="processor time (ms)", ylim=(0, None))
    spread.set(title="share of samples below", xlabel="processor time (ms)", ylabel="share", xlim=(0, None))
    look.legend_above(times)
