"""Figures and report."""

from __future__ import annotations

import numpy as np
from ella.document import Document
from ella.sheet import LIMITS, Sheet

from screwgen.plot import GREY, PALETTE

from .arms import ARMATURE, LIMIT, RATE_GAIN, STEP
from .ocp import TOLERANCE, Form
from .task import Results, numbers
from .wrench import BOUND, COMPONENT, MOVE, PLANNED
from .wrench import N as INTERVALS

BLUE, ORANGE = PALETTE[:2]


def draw(r: Results) -> dict[str, bytes]:
    sheets = {"closed_loop.png": closed_loop(r), "solves.png": solves(r), "wrench.png": moment(r)}
    return {name: sheet.png(r.extent.dpi) for name, sheet in sheets.items()}


def closed_loop(r: Results) -> Sheet:
    out, runs = (
        Sheet(2, 2, "Point to point, payload 30 % heavier than the model's"),
        {"MPC": r.mpc, "PD": r.baseline[0][1]},
    )
    t = np.arange(len(r.mpc.q)) * STEP
    away = lambda m: 1e3 * np.linalg.norm(m.tip - r.goal, axis=1)  # noqa: E731
    curves = [(name, away(m), c, "-") for (name, m), c in zip(runs.items(), (BLUE, ORANGE), strict=True)]
    panel = out.curves("tip from its goal", t, curves, "distance (mm)")
    panel.set_yscale("log")
    panel.axhline(1e3 * r.band, **LIMITS)
    for k, name in enumerate(("θ$_{y1}$", "θ$_{z1}$", "θ$_{z2}$")):
        curves = [(n, m.tau[:, k], c, "-") for (n, m), c in zip(runs.items(), (BLUE, ORANGE), strict=True)]
        panel = out.curves(f"torque of {name}", t, curves, "τ (N·m)")
        for limit in (-LIMIT[k], LIMIT[k]):
            panel.axhline(limit, **LIMITS)
    return out


def solves(r: Results) -> Sheet:
    out, h = Sheet(1, 2, "Solves of the receding horizon"), Form("collocation", "ipopt").h
    t = h * np.arange(len(r.solutions))
    panel = out.axes("time of a solve, one core", ylabel="ms")
    panel.plot(t, [1e3 * s.seconds for s in r.solutions], ".", color=BLUE)
    panel.axhline(1e3 * h, **LIMITS)
    panel.set_ylim(bottom=0)
    panel = out.axes("iterations", ylabel="iterations")
    panel.plot(t, [s.iterations for s in r.solutions], ".", color=BLUE)
    panel.set_ylim(bottom=0)
    return out


def moment(r: Results) -> Sheet:
    out = Sheet(1, 1, "Bending moment at the elbow in the plant", (6.4, 3.2))
    t = np.arange(len(r.plans[0][2])) * STEP
    names = ("plan without bound", "plan on the DAE form, moment bounded")
    curves = [(n, m, c, "-") for n, (_, _, m), c in zip(names, r.plans, (ORANGE, BLUE), strict=True)]
    panel = out.curves(COMPONENT, t, curves, "N·m")
    for bound in (-BOUND, BOUND):
        panel.axhline(bound, color=GREY, linestyle=":", linewidth=0.9)
    return out


def report(r: Results) -> Document:
    n, form = numbers(r), Form("collocation", "ipopt")
    out = Document("ELLA under model-predictive control")
    out.text(
        "The arm of `examples/ella.toml` moves from rest, straight and horizontal, to rest at the set points of the",
        f"paper. All controllers have the same torque limits, {listed(LIMIT)} N·m, by saturation. Added to the file:",
        f"rotor inertias of {listed(ARMATURE)} kg·m² at the joints, in plant and model; without any, no loop of 1 kHz",
        "can damp a joint, which would be unfair to PD.",
    )
    out.text(
        "**Plant**: generated C, two polynomial bending modes per plane and an axial mode in each link, modal midpoint",
        "at 1 ms, no modal damping, payload 30 % heavier than the model's. **Model**: one clamped-free bending mode",
        "per plane and link. **State**: joint angles and rates as they are; modal coordinates by least squares from",
        "the deflections of the plant's links at eight stations. **Payload**: the holding torques at rest give it",
        f"by least squares, {n['payload_found']:+.2f} kg here; the PD's gravity compensation gets it too. A",
        "Kalman filter follows what else is wrong with the model, as joint torques and tip forces.",
    )
    out.heading("Receding horizon")
    out.text(
        f"Collocation at two Radau points, {form.N} intervals of {1e3 * form.h:g} ms, then the cost of the linear",
        "quadratic regulator; torque held over an interval and limited at its start and at the points; a solve per",
        f"interval, warm from the last. IPOPT, tolerance {TOLERANCE:g}, Hessian of the cost alone. Below it a rate",
        f"loop at 1 kHz, {listed(RATE_GAIN)} N·m·s/rad, which the model knows as joint damping. The time of a solve",
        "is not simulated: its torque acts at once.",
    )
    best, s = n["pd"], n["solve_seconds"]
    rows = [("MPC", *cells(n["mpc"])), (f"PD, {described(best['gains'])}", *cells(best))]
    out.table(("controller", "settling (s)", "offset (mm)", "residual (mm)", "torque peaks (N·m)"), rows)
    out.text(
        f"**Settling**: last time that the tip is farther than {1e3 * r.band:.1f} mm, 1 % of its travel, from its own",
        "mean over the last 0.3 s. **Offset**: that mean from where the plant rests with its joints at the set points.",
        f"**Residual**: largest distance from that mean in those 0.3 s. PD: the fastest of {len(r.extent.grid)} sets",
        f"of gains, of which {len(r.baseline)} settle. MPC settles {n['faster']:.2f} times as fast.",
    )
    out.text(
        f"{n['solves']} solves, {'all' if n['converged'] else 'NOT all'} converged; {n['iterations']['median']:g}",
        f"iterations in the median, {n['iterations']['max']} at most; {1e3 * s['median']:.0f} ms of one core in the",
        f"median, {1e3 * s['max']:.0f} ms at most, in CasADi's virtual machine: more than the {1e3 * form.h:g} ms",
        "between two solves, so this is no real-time controller as it stands.",
    )
    out.figure("closed_loop.png", "Distance of the tip from its goal, and torques with their limits (dotted).")
    out.figure("solves.png", "Time and iterations of every solve; dotted: the time between two.")
    out.heading("Two transcriptions, two solvers")
    rows = [
        (
            f.transcription,
            f.solver,
            "yes" if s.converged else "no",
            str(s.iterations),
            f"{s.cost:.6g}",
            f"{s.seconds:.2f}",
        )
        for f, s in r.first
    ]
    out.text(
        f"The first problem of the motion with {r.first[0][0].N} intervals, from a cold start. Shooting: Runge–Kutta 4",
        "in steps of 3 ms under `map`. fatrop takes the exact Hessian, IPOPT that of the cost.",
    )
    out.table(("transcription", "solver", "converged", "iterations", "cost", "core s"), rows)
    out.heading("A bounded joint wrench")
    free, bounded = n["wrench"]["plant"]["free"], n["wrench"]["plant"]["bounded"]
    out.text(
        f"The same move within {MOVE:g} s, planned on the DAE form: `dae` by collocation at two Radau points in",
        f"{INTERVALS} intervals, the joint wrenches unknowns of the problem, the rows of M_sys z + H_sys = W_sys its",
        f"constraints, |{COMPONENT}| bounded at every point. No motor acts on that moment. The plan keeps to",
        f"{PLANNED:g} N·m, since the plant's payload is heavier than the model's; the plant shall keep to {BOUND:g}",
        "N·m. The plant gets the plan's torques and a PD law about its joint angles; its moment is that of",
        f"`forward_dynamics` in C, each ms for 1.2 s: at most **{bounded:.1f} N·m, a margin of {BOUND - bounded:.1f}",
        f"N·m**; with the plan that has no bound, {free:.1f} N·m.",
    )
    out.figure("wrench.png", "The plant's moment under the two plans; dotted: the bound.")
    return out


def listed(values) -> str:
    return ", ".join(f"{x:g}" for x in values)


def described(gains: dict) -> str:
    way = f"minimum jerk in {gains['move']:g} s" if gains["move"] else "set point from the start"
    return f"{gains['frequency']:g} Hz, damping {gains['damping']:g}, {way}"


def cells(figures: dict) -> tuple[str, str, str, str]:
    mm = (f"{1e3 * figures[name]:.2f}" for name in ("offset", "residual"))
    settling = "–" if figures["settling"] is None else f"{figures['settling']:.3f}"
    return settling, *mm, ", ".join(f"{x:.0f}" for x in figures["peak"])
