"""All that the example computes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .arms import ERROR, GOAL, LIMIT, STEP, Arms
from .loop import FEW, GRID, Estimator, Gains, Motion, pd, receding_horizon
from .ocp import Dynamics, Form, Problem, Solution
from .wrench import BOUND, PLANNED, Plan, Planner, follow

BAND = 0.01
"""Of the tip's travel: where the tip counts as settled."""
FORMS = [Form(t, s, N=12) for t in ("collocation", "shooting") for s in ("ipopt", "fatrop")]


@dataclass(frozen=True)
class Extent:
    duration: float
    """s: of each closed loop."""
    grid: list[Gains]
    forms: list[Form]
    dpi: int


FULL = Extent(2.4, GRID, FORMS, 130)
QUICK = Extent(1.5, FEW, [Form("collocation", "ipopt", N=6)], 50)


@dataclass(frozen=True)
class Figures:
    """What a closed loop did."""

    settling: float | None
    """s: last time that the tip is outside the band about its own rest; None: it is still outside at the end."""
    offset: float
    """m: its own rest from where it should rest."""
    residual: float
    """m: largest distance from its own rest in the last 0.3 s."""
    peak: list[float]
    """N·m, of the three motors."""


@dataclass(frozen=True)
class Results:
    extent: Extent
    goal: np.ndarray
    """(3,) m: the tip of the plant at rest with its joints at the set points."""
    band: float
    mpc: Motion
    solutions: list[Solution]
    found: np.ndarray
    baseline: list[tuple[Gains, Motion, Figures]]
    """Every PD that settles, the fastest first."""
    first: list[tuple[Form, Solution]]
    plans: list[tuple[float | None, Plan, np.ndarray]]
    """Bound, plan and the plant's moment, without and with the bound."""
    figures: Figures


def compute(extent: Extent, progress: Callable[[str], None]) -> Results:
    """All of it; `progress(what)` is called before each part."""
    progress("derive the arm, compile the plant")
    arms = Arms()
    rests = [arms.tip(arms.rest(joints)[0][None])[0] for joints in (np.zeros(3), GOAL)]
    band = BAND * float(np.linalg.norm(rests[1] - rests[0]))
    tick = lambda t: progress(f"MPC in closed loop: {t:.2f} of {extent.duration:g} s")  # noqa: E731
    mpc, solutions, found = receding_horizon(arms, Form("collocation", "ipopt"), extent.duration, tick)
    baseline = []
    for k, gains in enumerate(extent.grid):
        progress(f"PD: {k + 1} of {len(extent.grid)} sets of gains")
        motion = pd(arms, gains, found[7], extent.duration)
        baseline.append((gains, motion, judge(motion, rests[1], band)))
    settled = [row for row in baseline if row[2].settling is not None]
    first = []
    for form in extent.forms:
        progress(f"one problem by {form.transcription} and {form.solver}")
        first.append((form, solve_first(arms, form)))
    progress("the wrench-bounded motion on the DAE form")
    planner, plans = Planner(), []
    for bound in (None, PLANNED):
        plan = planner.plan(bound)
        plans.append((bound, plan, follow(arms, plan, 1.2)[1]))
    return Results(
        extent=extent,
        goal=rests[1],
        band=band,
        mpc=mpc,
        solutions=solutions,
        found=found,
        baseline=sorted(settled, key=lambda row: row[2].settling),
        first=first,
        plans=plans,
        figures=judge(mpc, rests[1], band),
    )


def judge(motion: Motion, goal: np.ndarray, band: float) -> Figures:
    late = motion.tip[-round(0.3 / STEP) :]
    rest = late.mean(axis=0)
    outside = np.flatnonzero(np.linalg.norm(motion.tip - rest, axis=1) > band)
    settled = outside[-1] < len(motion.tip) - len(late)
    return Figures(
        settling=float((outside[-1] + 1) * STEP) if settled else None,
        offset=float(np.linalg.norm(rest - goal)),
        residual=float(np.linalg.norm(late - rest, axis=1).max()),
        peak=[float(x) for x in np.abs(motion.tau).max(axis=0)],
    )


def solve_first(arms: Arms, form: Form) -> Solution:
    """The first problem of the motion, from a cold start."""
    dynamics = Dynamics(arms.model)
    d = Estimator(arms, dynamics, form.h).d
    goal, hold = dynamics.target(GOAL, d)
    x = np.append(arms.projection @ arms.rest(np.zeros(3))[0], np.zeros(7))
    return Problem(dynamics, form, dynamics.cost_to_go(form.h, goal, hold, d)).solve(x, d, goal, hold)


def numbers(r: Results) -> dict:
    """What is written as JSON; times depend on the machine."""
    seconds, best = [s.seconds for s in r.solutions], r.baseline[0]
    moments = {("bounded" if b else "free"): float(np.abs(m).max()) for b, _, m in r.plans}
    return {
        "limit": LIMIT.tolist(),
        "payload_error": ERROR - 1,
        "payload_found": float(r.found[7]),
        "band": r.band,
        "mpc": vars(r.figures),
        "pd": vars(best[2]) | {"gains": vars(best[0])},
        "faster": best[2].settling / r.figures.settling if r.figures.settling else None,
        "solves": len(r.solutions),
        "converged": all(s.converged for s in r.solutions),
        "iterations": {"median": float(np.median(i := [s.iterations for s in r.solutions])), "max": max(i)},
        "solve_seconds": {"median": float(np.median(seconds)), "max": max(seconds)},
        "first": [
            vars(f) | {"converged": s.converged, "iterations": s.iterations, "cost": s.cost, "seconds": s.seconds}
            for f, s in r.first
        ],
        "wrench": {"bound": BOUND, "planned": PLANNED, "margin": BOUND - moments["bounded"], "plant": moments},
        "plans_converged": all(p.converged for _, p, _ in r.plans),
    }
