"""The sections of a plan's report, as they stand on its page."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from .plan_figures import errors_of_the_model, joint_units, off_path_over_time, over_time, tip_over_time
from .report_page import Context, ReportSection, TableRow, report_page, said, table

if TYPE_CHECKING:
    from ..simulation.robustness import Robustness
    from .plan_report import PlanReport

PASSED = 1e-3
"""By what share of its size a limit may be passed in a run without a word."""
FOUND = {
    "models": "models",
    "iterations": "iterations",
    "seconds": "seconds of the search",
    "cost": "cost",
    "left": "energy left, over that of the motion",
    "preview": "of it before the tip moves, and as much after, s",
}
"""What is said of the search, by the keys of `MotionPlan.said`."""


def plan_page(report: PlanReport) -> str:
    """The page, which needs nothing else."""
    return report_page(f"Plan of {report.plan.robot}", SECTIONS, report)


class Remark(NamedTuple):
    """A sentence on what the numbers say."""

    text: str
    odd: bool = False


def in_words(report: PlanReport) -> Iterator[Remark]:
    """What the numbers say, sentence by sentence."""
    plan, arrived = report.plan, report.first
    behind = arrived.run.t[-1] - plan.time
    moves = f"the tip moves within {_mm(arrived.residual)} mm"
    yield Remark(f"In the {behind:.2g} s after the end of the motion, which takes {plan.time:.4g} s, {moves}.")
    if report.path is not None:
        yield Remark(f"On its way it is off its path by {_mm(report.off_path(arrived).max())} mm at most.")
    if len(report.arrivals) > 1:
        name, worst = max(report.arrivals.items(), key=lambda item: item[1].residual)
        yield Remark(f"Of the models that share the motion the worst is {name}: {_mm(worst.residual)} mm.")
    shares = report.shares
    if np.isfinite(shares).any():
        j = int(np.nanargmax(shares))
        yield Remark(f"The drive of {plan.joints[j]} is loaded most, with {100 * shares[j]:.0f} % of its limit.")
    else:
        yield Remark("No limit of efforts is stated: check whether the drives have these efforts.", True)
    for name, one in report.arrivals.items():
        if one.saturated:
            yield Remark(f"{name}: {one.saturated} samples are saturated; a drive at its limit corrects nothing.", True)
    yield from _passed(report)
    for what, found in report.robustness.items():
        yield from _left(what, found, report.path is None)
        if found.saturated.any():
            factors = ", ".join(f"{x:g}" for x in found.factors[found.saturated > 0])
            yield Remark(f"Drives are saturated where the {what} is multiplied by {factors}.", True)
        yield from (Remark(f"The arm does not arrive with its {what} multiplied {x}.", True) for x in found.failed)
    if not plan.kp.any():
        yield Remark("Without gains nothing corrects what the model does not know.", True)


def _left(what: str, found: Robustness, at_rest: bool) -> Iterator[Remark]:
    """What the smallest and the largest error leave, of the runs that reach their ends: at rest, or off a path."""
    leaves, left = ("leaves", "") if at_rest else ("takes the tip", " off its path")
    off = np.abs(found.factors - 1.0).round(6)
    sizes = sorted({float(x) for x in off[np.isfinite(found.residuals)] if x})
    said = [f"by {100 * x:.3g} % {leaves} up to {_mm(np.nanmax(found.residuals[off == x]))} mm{left}" for x in sizes]
    if said:
        yield Remark(f"A {what} that is off {', '.join(dict.fromkeys((said[0], said[-1])))}.")


def _passed(report: PlanReport) -> Iterator[Remark]:
    """The limits that the run passes."""
    names, limits, model = report.plan.joints, report.limits, report.model
    for what, sizes, most, every in (
        ("rate", report.first.rates, limits.rates, names),
        ("rate of effort", report.effort_rates, limits.effort_rates, names),
        ("strain", report.strains, limits.strains, model.strain_names),
        ("joint wrench", report.wrenches, limits.wrenches, model.wrench_names),
    ):
        for j in np.flatnonzero(sizes > most * (1 + PASSED)):
            yield Remark(f"The {what} of {every[j]} reaches {sizes[j]:.4g}; its limit is {most[j]:.4g}.", True)
    q = report.drives.driven(report.first.run.q)
    for reached, end, over in (
        (q.min(axis=0), limits.lower, limits.lower - q.min(axis=0)),
        (q.max(axis=0), limits.upper, q.max(axis=0) - limits.upper),
    ):
        for j in np.flatnonzero(over > PASSED * np.ptp(q, axis=0)):
            yield Remark(f"{names[j]} goes to {reached[j]:.4g}; its limit is {end[j]:.4g}.", True)


def _mm(x: float) -> str:
    return f"{1e3 * x:.3g}" if np.isfinite(x) else "–"


def _number(x: float) -> str:
    return f"{x:.4g}" if np.isfinite(x) else "–"


def _short(report: PlanReport) -> Context:
    remarks = list(in_words(report))
    return {"lines": [x.text for x in remarks], "odd": [x.text for x in remarks if x.odd], "nothing": ""}


def _still(report: PlanReport) -> Context:
    rows = []
    for name, one in report.arrivals.items():
        off, effort = np.abs(one.joints).max(), one.effort.max()
        cells = name, _mm(one.residual), f"{off:.2g}", f"{effort:.4g}", str(one.saturated)
        rows.append(TableRow(cells, bool(one.saturated)))
    return table(
        ("model", "residual, mm", "joints from the goal, rad or m", "largest effort, N·m or N", "samples saturated"),
        rows,
        "The residual is the diagonal of the box in which the tip moves after the end of the motion. What the model "
        "does not have, as further modes, is not in it: play the plan on a model that has them, too.",
        {"The distance of the tip from its rest, over time": tip_over_time(report)},
    )


def _on_path(report: PlanReport) -> Context:
    """No section where no path is asked for."""
    if report.path is None:
        return {}
    rows = []
    for name, one in report.arrivals.items():
        off = report.off_path(one)
        rows.append(TableRow((name, _mm(off.max()), _mm(np.sqrt(np.mean(off**2))), _number(one.run.t[np.argmax(off)]))))
    return table(
        ("model", "largest, mm", "root mean square, mm", "largest at t, s"),
        rows,
        "The distance of the tip, in the run, from the place where the path is at the same time.",
        {"That distance over time": off_path_over_time(report)},
    )


def _joints(report: PlanReport) -> Context:
    plan, limits, units = report.plan, report.limits, joint_units(report)
    rows = []
    for j, (name, share) in enumerate(zip(plan.joints, report.shares, strict=True)):
        motion = plan.q[0, j], plan.q[-1, j], report.first.rates[j], limits.rates[j]
        efforts = plan.effort[j], report.first.effort[j], plan.tau_max[j]
        part = f"{100 * share:.0f} %" if np.isfinite(share) else "–"
        cells = name, ", ".join(units[j]), *map(_number, motion), *map(_number, efforts), part
        rows.append(TableRow(cells, report.first.rates[j] > limits.rates[j] * (1 + PASSED)))
    return table(
        ("joint", "units", "from", "to", "largest rate", "limit", "effort, planned", "in the run", "limit", "share"),
        rows,
        pictures={"References and rates of joints, and efforts in the run, with limits": over_time(report)},
        words=2,
    )


def _loads(report: PlanReport) -> Context:
    """Strains, and wrenches that have a limit; no section where there are none."""
    limits, model, rows = report.limits, report.model, []
    for sizes, bounds, names, every in (
        (report.strains, limits.strains, model.strain_names, True),
        (report.wrenches, limits.wrenches, model.wrench_names, False),
    ):
        for name, size, most in zip(names, sizes, bounds, strict=True):
            if every or np.isfinite(most):
                rows.append(TableRow((name, _number(size), _number(most)), size > most * (1 + PASSED)))
    return table(("of the centreline, or at the joint", "largest, SI units", "limit"), rows) if rows else {}


def _errors(report: PlanReport) -> Context:
    """No section where nothing is varied."""
    curves = report.robustness
    if not curves:
        return {}
    factors = next(iter(curves.values())).factors
    rows = [
        TableRow((what, *map(_mm, found.residuals)), bool(found.saturated.any() or found.failed))
        for what, found in curves.items()
    ]
    varied = "; ".join(f"{what}: {', '.join(_arrays(found.parameters))}" for what, found in curves.items())
    return table(
        ("", *(f"× {x:g}" for x in factors)),
        rows,
        f"The {report.measured}, mm, where all of these parameters are others by a factor. {varied}.",
        {f"The {report.measured} over factors of parameters": errors_of_the_model(report)},
    )


def _arrays(names: Sequence[str]) -> Iterable[str]:
    """Names without the numbers of their components, each once."""
    return dict.fromkeys(re.sub(r"\[\d+\]$", "", name) for name in names)


def _search(report: PlanReport) -> Context:
    plan = report.plan
    rows = [("time of the motion, s", _number(plan.time)), ("points of its tables", str(len(plan.t)))]
    rows += [(text, _number(plan.said[key])) for key, text in FOUND.items() if key in plan.said]
    rows += [(name, ", ".join(map(_number, gains))) for name, gains in (("gains kp", plan.kp), ("gains kd", plan.kd))]
    return table(("", ""), [TableRow(row) for row in rows])


def _notes(report: PlanReport) -> Context:
    """No section where no run warned."""
    return said(report.notes) if report.notes else {}


SECTIONS: Sequence[ReportSection[PlanReport]] = (
    ReportSection("In short", "report/said", _short),
    ReportSection("How far the tip is off its path", "report/table", _on_path),
    ReportSection("How still the arm stands", "report/table", _still),
    ReportSection("Joints and drives", "report/table", _joints),
    ReportSection("What the arm bears", "report/table", _loads),
    ReportSection("Where the arm is not as planned", "report/table", _errors),
    ReportSection("How it was found", "report/table", _search),
    ReportSection("What runs warned of", "report/said", _notes),
)
"""In the order of the page."""
