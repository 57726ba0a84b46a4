"""All that the example computes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .arms import ERROR, LIMIT, STEP, Arms
from .loop import FEW, GRID, SOFT, Baseline, Controller, Gains, Motion
from .ocp import Form, Solution
from .plan import Plan, fastest
from .wrench import BOUND, PLANNED, Planner, follow
from .wrench import Plan as BoundedPlan

BANDS = (0.02, 0.01, 0.005, 0.002)
"""m: within which the tip counts as settled."""
BAND = BANDS.index(0.005)
"""That of the headline: what a gripper can still catch; the payload's error moves the resting tip by as much."""
LATE = 0.3
"""s: how long, at least, the tip must stay in a band, and over which its own rest is taken."""
CONTROLLERS = {
    "mpc": "MPC",
    "pd": "PD, as designed",
    "told": "PD, told the payload",
    "hindsight": "PD, told, best gains in hindsight",
    "plan": "PD along the MPC's plan",
}
AMID, OFF = 0.3, 0.02
"""s, rad: when, and how far off the plan, the problem starts that every form solves."""
FORMS = [Form(t, s, 0.01, 6) for t in ("collocation", "shooting") for s in ("ipopt", "fatrop")]


@dataclass(frozen=True)
class Extent:
    duration: float
    """s: of the MPC's closed loop."""
    pd_duration: float
    intervals: int
    """Of the plan and of the bounds."""
    grid: list[Gains]
    soft: list[Gains]
    """Of the PD along the MPC's plan."""
    forms: list[Form]
    bounds: bool
    """Whether the fastest motion for every band is computed."""
    dpi: int


FULL = Extent(2.4, 2.4, 36, GRID, SOFT, FORMS, True, 130)
QUICK = Extent(
    1.0, 2.0, 36, FEW, SOFT[:2], [Form("collocation", solver, 0.01, 4) for solver in ("ipopt", "fatrop")], False, 50
)


@dataclass(frozen=True)
class Results:
    extent: Extent
    arms: Arms
    found: float
    """kg: payload beyond the file's, as the MPC found it."""
    plan: Plan
    bounds: list[Plan]
    """The fastest motion for each of `BANDS`; empty in the short form."""
    solutions: list[Solution]
    motions: dict[str, Motion]
    """By controller; of "hindsight" that with the best gains for the headline's band."""
    gains: dict[str, list[Gains]]
    """Of "hindsight" one for each of `BANDS`; of "plan" the best of `soft` on the plant; else those rehearsed."""
    hindsight: list[Motion]
    first: list[tuple[Form, Solution]]
    wrench: list[tuple[float | None, BoundedPlan, np.ndarray]]
    """Bound, plan and the plant's moment, without and with the bound."""


def compute(extent: Extent, progress: Callable[[str], None]) -> Results:
    """All of it; `progress(what)` is called before each part."""
    progress("derive the arm, compile the plant")
    arms = Arms()
    arms.compiled.prepare(arms.p)
    progress("MPC: the fastest motion")
    mpc = Controller(arms, Form(), extent.intervals)
    tick = lambda t: progress(f"MPC in closed loop: {t:.1f} of {extent.duration:g} s")  # noqa: E731
    motion, solutions = mpc.run(extent.duration, tick)
    motions, gains, hindsight = baselines(arms, mpc, extent, progress)
    return Results(
        extent=extent,
        arms=arms,
        found=mpc.extra,
        plan=mpc.plan,
        bounds=list(lower_bounds(mpc, extent, progress)),
        solutions=solutions,
        motions={"mpc": motion} | motions,
        gains=gains,
        hindsight=hindsight,
        first=list(first_problems(mpc, extent, progress)),
        wrench=list(bounded_wrench(arms, progress)),
    )


def baselines(arms: Arms, mpc: Controller, extent: Extent, progress: Callable[[str], None]):
    """Motions and gains of every PD, and the motions that were best in hindsight for each band."""
    plain, told = Baseline(arms, 0.0), Baseline(arms, mpc.extra)
    rehearsed, tried = [], []
    for k, gains in enumerate(extent.grid):
        if k % 10 == 0:
            progress(f"PD: {k + 1} of {len(extent.grid)} sets of gains")
        rehearsed.append(plain.run(gains, extent.pd_duration, rehearse=True))
        tried.append(told.run(gains, extent.pd_duration))
    chosen = extent.grid[best(rehearsed, arms.goal, BANDS[BAND])]
    late = [best(tried, arms.goal, band) for band in BANDS]
    progress("PD along the MPC's plan")
    followed = [told.follow(gains, mpc.plan, extent.pd_duration) for gains in extent.soft]
    soft = best(followed, arms.goal, BANDS[BAND])
    motions = {
        "pd": plain.run(chosen, extent.pd_duration),
        "told": told.run(chosen, extent.pd_duration),
        "hindsight": tried[late[BAND]],
        "plan": followed[soft],
    }
    gains = {"pd": [chosen], "told": [chosen], "plan": [extent.soft[soft]]}
    gains["hindsight"] = [extent.grid[k] for k in late]
    return motions, gains, [tried[k] for k in late]


def best(motions: list[Motion], about, band: float) -> int:
    return int(np.argmin([settling(m, about, band) or np.inf for m in motions]))


def lower_bounds(mpc: Controller, extent: Extent, progress: Callable[[str], None]):
    for band in BANDS if extent.bounds else ():
        progress(f"the fastest motion into {1e3 * band:g} mm")
        yield fastest(mpc.dynamics, mpc.ends, mpc.extra, extent.intervals, band=band)


def first_problems(mpc: Controller, extent: Extent, progress: Callable[[str], None]):
    """A problem amid the motion, the joints `OFF` the plan, in every form, from the same guess."""
    x = mpc.plan.states(AMID)
    x[:3] += OFF
    for form in extent.forms:
        progress(f"one problem by {form.transcription} and {form.solver}")
        yield form, mpc.solve(mpc.stated(form), x, AMID)


def bounded_wrench(arms: Arms, progress: Callable[[str], None]):
    progress("the wrench-bounded motion on the DAE form")
    planner = Planner()
    for bound in (None, PLANNED):
        plan = planner.plan(bound)
        yield bound, plan, follow(arms, plan, 1.2)[1]


# ------------------------------------------------------------------------------ figures


def settling(motion: Motion, about, band: float) -> float | None:
    """s: last time that the tip is farther than `band` from `about` (3,); None: within the last `LATE` seconds."""
    outside = np.flatnonzero(np.linalg.norm(motion.tip - about, axis=1) > band)
    last = outside[-1] + 1 if len(outside) else 0
    return float(last * STEP) if last <= len(motion.tip) - round(LATE / STEP) else None


def rest(motion: Motion) -> np.ndarray:
    """(3,) m: where the tip comes to rest, its mean over the last `LATE` seconds."""
    return motion.tip[-round(LATE / STEP) :].mean(axis=0)


def settled(r: Results, name: str, own: bool, bands=BANDS) -> list[float | None]:
    """Settling about the goal or about the tip's own rest; "hindsight" takes for each of `BANDS` its best gains."""
    motions = r.hindsight if name == "hindsight" and bands is BANDS else [r.motions[name]] * len(bands)
    return [settling(m, rest(m) if own else r.arms.goal, band) for m, band in zip(motions, bands, strict=True)]


def faster(r: Results, name: str, own: bool) -> list[float | None]:
    """How many times as fast as this controller the MPC settles, for each band; None: one of them does not."""
    pairs = zip(settled(r, name, own), settled(r, "mpc", own), strict=True)
    return [other / mpc if other and mpc else None for other, mpc in pairs]


def numbers(r: Results) -> dict:
    """What is written as JSON; times of solves depend on the machine."""
    seconds, iterations = ([getattr(s, name) for s in r.solutions] for name in ("seconds", "iterations"))
    moments = {("bounded" if b else "free"): float(np.abs(m).max()) for b, _, m in r.wrench}
    late = {name: m.tip[-round(LATE / STEP) :] for name, m in r.motions.items()}
    return {
        "limit": LIMIT.tolist(),
        "payload_error": ERROR - 1,
        "payload_found": r.found,
        "bands": list(BANDS),
        "headline": {"band": BANDS[BAND], "against": "told", "faster": faster(r, "told", False)[BAND]},
        "settling": {name: settled(r, name, False) for name in CONTROLLERS},
        "settling_about_own_rest": {name: settled(r, name, True) for name in CONTROLLERS},
        "faster": {name: faster(r, name, False) for name in CONTROLLERS if name != "mpc"},
        "faster_about_own_rest": {name: faster(r, name, True) for name in CONTROLLERS if name != "mpc"},
        "lower_bounds": [b.duration for b in r.bounds],
        "offset": {name: float(np.linalg.norm(rest(m) - r.arms.goal)) for name, m in r.motions.items()},
        "residual": {name: float(np.linalg.norm(tip - tip.mean(axis=0), axis=1).max()) for name, tip in late.items()},
        "peak": {name: np.abs(m.tau).max(axis=0).tolist() for name, m in r.motions.items()},
        "gains": {name: [vars(g) for g in given] for name, given in r.gains.items()},
        "plan": {"duration": r.plan.duration, "seconds": r.plan.seconds},
        "solves": len(r.solutions),
        "converged": all(s.converged for s in (*r.solutions, r.plan, *r.bounds, *(p for _, p, _ in r.wrench))),
        "iterations": {"median": float(np.median(iterations)), "max": max(iterations)},
        "solve_seconds": {"median": float(np.median(seconds)), "max": max(seconds)},
        "first": [
            vars(f) | {"converged": s.converged, "iterations": s.iterations, "cost": s.cost, "seconds": s.seconds}
            for f, s in r.first
        ],
        "wrench": {"bound": BOUND, "planned": PLANNED, "margin": BOUND - moments["bounded"], "plant": moments},
    }
