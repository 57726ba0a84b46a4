"""The figures of a plan's report: joints and efforts over time, the tip behind the end, errors of the model."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..spec.parameters import coordinate_units
from .curves import thin
from .look import GREY, LIMITS, PALE, PALETTE, SMALL, canvas, legend_above, png, styled

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.axes import Axes

    from ..simulation.arrival import Arrival
    from .plan_report import PlanReport

DPI = 110
WIDE = 11.0
NEAR = 3.0
"""A limit beyond so many times the largest value is stated, not drawn: it would flatten the curve."""
STILL = 1e-7
"""m: what is less than this counts as this on a logarithmic scale."""


def joint_units(report: PlanReport) -> list[tuple[str, str]]:
    """The units of each joint's coordinate and of its effort: of elastic drives at the joint, of cylinders N."""
    units, cylinders = coordinate_units(report.model.robot)[: report.model.n_joints], report.model.chain.cylinders
    return [(unit, "N" if unit == "m" or joint in cylinders else "N·m") for joint, unit in enumerate(units)]


@styled
def over_time(report: PlanReport) -> bytes:
    """Of each joint its reference, its rate and its effort over time, with their limits."""
    plan, run, m = report.plan, report.first.run, report.model.n_joints
    units, tau = joint_units(report), report.drives.efforts(run.tau)
    out = canvas(WIDE, 1.7 * m + 0.5)
    grid = out.subplots(m, 3, squeeze=False, sharex=True)
    t = np.linspace(0.0, run.t[-1], 1000)
    q, v = plan.reference(t)
    held = np.arange(len(run.t) - 1)
    limits = report.limits
    for j, (row, (unit, effort)) in enumerate(zip(grid, units, strict=True)):
        colour = PALETTE[j % len(PALETTE)]
        ends = limits.lower[j], limits.upper[j]
        for axes, x, y, title, bounds in (
            (row[0], t, q[:, j], unit, ends),
            (row[1], t, v[:, j], f"{unit}/s", (-limits.rates[j], limits.rates[j])),
            (row[2], *thin(run.t[held], tau[held, j]), effort, (-plan.tau_max[j], plan.tau_max[j])),
        ):
            axes.plot(x, y, color=colour, drawstyle="steps-post" if axes is row[2] else "default")
            axes.set_title(title, loc="right", color=GREY, fontsize=SMALL, fontweight="normal")
            axes.axvline(plan.time, color=PALE, linewidth=0.8)
            _bounds(axes, bounds)
        row[0].set_title(plan.joints[j])
    for axes, what in zip(grid[0], ("", "rate", "effort"), strict=True):
        if what:
            axes.set_title(what)
    for axes in grid[-1]:
        axes.set_xlabel("t (s)")
        axes.set_xlim(0.0, run.t[-1])
    return png(out, DPI)


def _bounds(axes: Axes, bounds: tuple[float, float]) -> None:
    """Lines at limits that are near the curve."""
    low, high = axes.get_ylim()
    size = max(abs(low), abs(high))
    for bound in bounds:
        if np.isfinite(bound) and abs(bound) <= NEAR * size:
            axes.axhline(bound, **LIMITS)


@styled
def tip_over_time(report: PlanReport) -> bytes:
    """How far the tip is from the middle of where it moves behind the end, over time, of all models."""

    def off(arrived: Arrival) -> np.ndarray:
        run = arrived.run
        behind = run.tip_position[run.t >= report.plan.time * (1 - 1e-12)]
        return np.linalg.norm(run.tip_position - (behind.min(axis=0) + behind.max(axis=0)) / 2, axis=1)

    least = 50 * min(x.residual for x in report.arrivals.values())
    return _distances(report, off, "tip from its rest (mm)", least)


@styled
def off_path_over_time(report: PlanReport) -> bytes:
    """How far the tip is from its path over time, of all models."""
    return _distances(report, report.off_path, "tip from its path (mm)")


def _distances(report: PlanReport, off: Callable[[Arrival], np.ndarray], what: str, least: float = 0.0) -> bytes:
    """Distances ``off`` of the tip, m, over time, of all models; ``least``: where their scale begins, mm."""
    out = canvas(WIDE, 3.0)
    axes = out.subplots()
    for k, (name, arrived) in enumerate(report.arrivals.items()):
        far = np.maximum(off(arrived), STILL)
        axes.semilogy(*thin(arrived.run.t, 1e3 * far), color=PALETTE[k % len(PALETTE)], label=name)
    axes.set_ylim(bottom=max(1e3 * STILL, least))
    axes.axvline(report.plan.time, **LIMITS)
    axes.set_xlim(0.0, report.first.run.t[-1])
    axes.set_xlabel("t (s)")
    axes.set_ylabel(what)
    legend_above(axes)
    return png(out, DPI)


@styled
def errors_of_the_model(report: PlanReport) -> bytes:
    """The residual, or what is measured in its place, over factors of parameters."""
    out = canvas(WIDE, 3.0)
    axes = out.subplots()
    for k, (what, found) in enumerate(report.robustness.items()):
        axes.plot(found.factors, 1e3 * found.residuals, "o-", markersize=4, color=PALETTE[k % len(PALETTE)], label=what)
    axes.axvline(1.0, **LIMITS)
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel("factor of what was planned for")
    axes.set_ylabel(f"{report.measured} (mm)")
    legend_above(axes)
    return png(out, DPI)
