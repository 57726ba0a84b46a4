"""All that the example computes."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .arms import ERROR, LIMIT, STEP, Arms
from .generated import BOUNDED, Generated, Sampled, always_in_time
from .loop import FEW, FREE, GRID, SOFT, Baseline, Controller, Gains, Motion
from .ocp import Form
from .plan import Plan, fastest
from .timing import MARKS, Latency, machine, measured, percentiles

BANDS = (0.02, 0.01, 0.005, 0.002)
"""m: within which the tip counts as settled."""
BAND = BANDS.index(0.005)
"""That of the headline: what a gripper can still catch; the payload's error moves the resting tip by as much."""
BOUND, COMPONENT = 60.0, "forearm.tau_y"
"""N·m: on the plant's bending moment at the elbow across its axis. No motor acts there: no torque limit bounds it."""
LATE = 0.3
"""s: how long, at least, the tip must stay in a band, and over which its own rest is taken."""
CONTROLLERS = {
    "mpc": "MPC",
    "cold": "MPC without a plan",
    "pd": "PD, as designed",
    "told": "PD, told the payload",
    "hindsight": "PD, told, best gains in hindsight",
    "plan": "PD along the MPC's plan",
}
LATE_SAMPLES: dict[str, Callable[[int], bool]] = {
    "none": always_in_time,
    "one in four": lambda k: k % 4 == 3,
    "one in two": lambda k: k % 2 == 1,
    "three at once, at 0.2 and 0.4 s": lambda k: k in (10, 11, 12, 20, 21, 22),
}
"""Which preparations are late, by number of the sample from the start of the motion."""
GHOST = Path(__file__).with_name("ghost.json")
"""The recorded run of `mpc_ella.py --ghost`: IPOPT, converged in every sample."""
THIN = 4
"""Of the ghost's tip every so many `STEP` are kept."""


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
    bounds: bool
    """Whether the fastest motion for every band is computed."""
    repeats: int
    """Of the closed loop, for the latencies."""
    dpi: int


FULL = Extent(2.4, 2.4, 36, GRID, SOFT, True, 50, 130)
QUICK = Extent(1.8, 2.0, 36, FEW, SOFT[:2], False, 3, 50)


@dataclass(frozen=True)
class Results:
    extent: Extent
    arms: Arms
    found: float
    """kg: payload beyond the file's, as the MPC found it."""
    plan: Plan
    bounds: list[Plan]
    """The fastest motion for each of `BANDS`; empty in the short form."""
    samples: list[Sampled]
    latency: dict[str, Latency]
    """By state of the caches: `warm` or `cold`."""
    motions: dict[str, Motion]
    """By controller; of "hindsight" that with the best gains for the headline's band."""
    gains: dict[str, list[Gains]]
    """Of "hindsight" one for each of `BANDS`; of "plan" the best of `soft` on the plant; else those rehearsed."""
    hindsight: list[Motion]
    late: dict[str, Motion]
    """By `LATE_SAMPLES`."""
    wrench: list[tuple[float | None, Motion, np.ndarray]]
    """Bound, motion and the plant's moment, without and with the bound."""
    ghost: dict
    """`GHOST`."""


def compute(extent: Extent, progress: Callable[[str], None]) -> Results:
    """All of it; `progress(what)` is called before each part."""
    progress("derive the arm, compile the plant")
    arms = Arms()
    arms.compiled.prepare(arms.p)
    progress("MPC: the fastest motion, and its controller in C")
    mpc = Generated(arms, extent.intervals)
    motion, samples = mpc.run(extent.duration, quietly(progress, "MPC in closed loop", extent))
    progress("MPC: latencies in C")
    latency = measured(arms, samples, mpc.extra, extent.repeats)
    late = {"none": motion}
    for name, when in list(LATE_SAMPLES.items())[1:]:
        loop = Generated(arms, plan=mpc.plan, late=when)
        late[name], _ = loop.run(extent.duration, quietly(progress, f"MPC, late samples: {name}", extent))
    alone = Generated(arms)
    cold, _ = alone.run(extent.duration, quietly(progress, "MPC without a plan", extent))
    wrench = list(bounded_wrench(arms, extent, progress))
    motions, gains, hindsight = baselines(arms, mpc, extent, progress)
    return Results(
        extent=extent,
        arms=arms,
        found=mpc.extra,
        plan=mpc.plan,
        bounds=list(lower_bounds(mpc, extent, progress)),
        samples=samples,
        latency=latency,
        motions={"mpc": motion, "cold": cold} | motions,
        gains=gains,
        hindsight=hindsight,
        late=late,
        wrench=wrench,
        ghost=json.loads(GHOST.read_text()),
    )


def quietly(progress: Callable[[str], None], what: str, extent: Extent) -> Callable[[float], None]:
    return lambda t: progress(f"{what}: {t:.1f} of {extent.duration:g} s")


def ghost(progress: Callable[[str], None]) -> dict:
    """The content of `GHOST`: the same loop with IPOPT, converged in every sample."""
    arms = Arms()
    mpc = Controller(arms, Form(), FULL.intervals)
    motion, solutions = mpc.run(FULL.duration, quietly(progress, "IPOPT in closed loop", FULL))
    return {
        "every": THIN * STEP,
        "tip": np.round(motion.tip[::THIN], 4).tolist(),
        "bands": list(BANDS),
        "settling": [settling(motion, arms.goal, band) for band in BANDS],
        "settling_about_own_rest": [settling(motion, rest(motion), band) for band in BANDS],
        "converged": all(s.converged for s in solutions),
        "iterations": [s.iterations for s in solutions],
        "solve_seconds": [round(s.seconds, 4) for s in solutions],
    }


def baselines(arms: Arms, mpc: Generated, extent: Extent, progress: Callable[[str], None]):
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


def lower_bounds(mpc: Generated, extent: Extent, progress: Callable[[str], None]):
    for band in BANDS if extent.bounds else ():
        progress(f"the fastest motion into {1e3 * band:g} mm")
        yield fastest(mpc.dynamics, mpc.ends, mpc.extra, extent.intervals, band=band)


def bounded_wrench(arms: Arms, extent: Extent, progress: Callable[[str], None]):
    """The motion of the file that bounds `COMPONENT`, and without that bound; the moment (N,) is of the plant's C."""
    for bound in (None, BOUND):
        loop = Generated(arms, file=BOUNDED)
        if bound is None:
            loop.problem.options["wrench"][:] = np.inf
        run, _ = loop.run(extent.duration, quietly(progress, "MPC with a bounded joint wrench", extent))
        rows = zip(run.q, run.v, run.tau, strict=True)
        yield bound, run, np.array([arms.compiled.forward_dynamics(*row, FREE)[1][1, 1] for row in rows])


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
    iterations = [s.iterations for s in r.samples]
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
        "samples": len(r.samples),
        "solved": all(s.converged for s in (*r.samples, r.plan, *r.bounds)),
        "qp_iterations": {"median": float(np.median(iterations)), "max": max(iterations)},
        "latency": {
            "machine": machine(),
            "bound_to_a_core": r.latency["warm"].bound,
            "samples": {name: len(found.wall["sum"]) for name, found in r.latency.items()},
            "unit": "ms",
        }
        | {f"{name}_cpu": percentiles(found.cpu) for name, found in r.latency.items()}
        | {f"{name}_wall": percentiles(found.wall) for name, found in r.latency.items()},
        "late": {name: [settling(m, r.arms.goal, band) for band in BANDS] for name, m in r.late.items()},
        "late_peak": {name: np.abs(m.tau).max(axis=0).tolist() for name, m in r.late.items()},
        "ghost": {k: v for k, v in r.ghost.items() if k.startswith("settling")}
        | {"solve_ms": {m: float(1e3 * np.percentile(r.ghost["solve_seconds"], q)) for m, q in MARKS.items()}},
        "wrench": {
            "component": COMPONENT,
            "bound": BOUND,
            "margin": BOUND - moments["bounded"],
            "plant": moments,
            "settling": {
                ("bounded" if b else "free"): [settling(m, r.arms.goal, band) for band in BANDS] for b, m, _ in r.wrench
            },
        },
    }
