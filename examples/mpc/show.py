"""Figures."""

from __future__ import annotations

import numpy as np
from ella.sheet import Sheet

from screwgen.plotting.look import GREY, LIMITS, PALETTE, styled

from .arms import LIMIT, STEP
from .ocp import Form
from .task import BAND, BANDS, BOUND, COMPONENT, Results, settled

BLUE, ORANGE, GREEN, PINK, PURPLE = PALETTE[:5]
STYLES = {
    "mpc": (BLUE, "-"),
    "cold": (BLUE, ":"),
    "pd": (ORANGE, "-"),
    "told": (PINK, "-"),
    "hindsight": (GREEN, "-"),
    "plan": (PURPLE, "--"),
}
SHORT = {
    "mpc": "MPC",
    "cold": "MPC without a plan",
    "pd": "PD, nominal",
    "told": "PD, told the payload",
    "hindsight": "PD, best in hindsight",
    "plan": "PD along the plan",
}
GHOST = "IPOPT in every sample, recorded"


def draw(r: Results) -> dict[str, bytes]:
    sheets = {
        "settling.png": settling_times(r),
        "closed_loop.png": closed_loop(r),
        "latency.png": latency(r),
        "late.png": late(r),
        "wrench.png": moment(r),
    }
    return {name: sheet.png(r.extent.dpi) for name, sheet in sheets.items()}


@styled
def settling_times(r: Results) -> Sheet:
    """Settling time against band, about the goal and about the own rest."""
    out = Sheet(1, 2, "When the tip has settled within a band, payload 30 % heavier")
    bands = np.geomspace(1e-3, 0.04, 120)
    for own, title in ((False, "about the goal"), (True, "about its own rest")):
        panel = out.axes(title, xlabel="band (mm)", ylabel="settling time (s)")
        for name, (color, style) in STYLES.items():
            times = [np.nan if t is None else t for t in settled(r, name, own, tuple(bands))]
            panel.plot(1e3 * bands, times, style, color=color, label=SHORT[name])
        ghost = r.ghost["settling_about_own_rest" if own else "settling"]
        panel.plot([1e3 * b for b in BANDS], [t or np.nan for t in ghost], "o", color=GREY, label=GHOST, mfc="none")
        if r.bounds:
            label = "fastest possible"
            panel.plot([1e3 * b for b in BANDS], [b.duration for b in r.bounds], "v:", color=GREY, label=label)
        panel.axvline(1e3 * BANDS[BAND], **LIMITS)
        panel.set(xscale="log", ylim=(0.0, 2.7), xlim=(1, 40))
        panel.set_xticks([1, 2, 5, 10, 20, 40], labels=["1", "2", "5", "10", "20", "40"])
        panel.minorticks_off()
    out.legend()
    return out


@styled
def closed_loop(r: Results) -> Sheet:
    out, shown = Sheet(2, 2, "Point to point, payload 30 % heavier than designed for"), ("mpc", "cold", "pd", "told")
    end = len(r.motions["pd"].tip) * STEP
    panel = out.axes("tip from its goal", ylabel="distance (mm)")
    for name in shown:
        tip, (color, style) = r.motions[name].tip, STYLES[name]
        away = 1e3 * np.linalg.norm(tip - r.arms.goal, axis=1)
        panel.plot(STEP * np.arange(len(tip)), away, style, color=color, label=SHORT[name], linewidth=1.1)
    tip = np.linalg.norm(np.array(r.ghost["tip"]) - r.arms.goal, axis=1)
    t = r.ghost["every"] * np.arange(len(tip))
    panel.plot(t, 1e3 * tip, color=GREY, alpha=0.5, linewidth=3, label=GHOST, zorder=0)
    panel.axhline(1e3 * BANDS[BAND], **LIMITS)
    panel.set(yscale="log", ylim=(0.3, 3000), xlim=(0, min(end, 1.8)))
    out.legend()
    for k, name in enumerate(("θ$_{y1}$", "θ$_{z1}$", "θ$_{z2}$")):
        panel = out.axes(f"torque of {name}", ylabel="τ (N·m)")
        for which in ("mpc", "told"):
            tau = r.motions[which].tau[:, k]
            panel.plot(STEP * np.arange(len(tau)), tau, color=STYLES[which][0], label=SHORT[which], linewidth=1.0)
        for limit in (-LIMIT[k], LIMIT[k]):
            panel.axhline(limit, **LIMITS)
        panel.set_xlim(0, min(end, 1.8))
    return out


@styled
def latency(r: Results) -> Sheet:
    """Processor time along the motion, and its distribution beside the ghost's."""
    out, h, times = Sheet(1, 2, "Time of a sample, measured in C"), Form().h, r.latency["warm"].cpu
    panel, count = out.axes("along the motion", ylabel="ms"), len(r.samples) - 1
    t = h * np.arange(count)
    for name, color in (("preparation", BLUE), ("feedback", ORANGE)):
        runs = 1e3 * times[name].reshape(-1, count)
        panel.fill_between(t, runs.min(axis=0), runs.max(axis=0), color=color, alpha=0.25, linewidth=0, step="mid")
        panel.plot(t, np.median(runs, axis=0), drawstyle="steps-mid", color=color, label=name)
    panel.set_ylim(bottom=0)
    panel = out.axes("share of samples below", xlabel="ms", ylabel="share")
    curves = [("warm caches", times["sum"], PURPLE, "-"), ("cold caches", r.latency["cold"].cpu["sum"], GREEN, "-")]
    for name, values, color, style in (*curves, (GHOST, np.array(r.ghost["solve_seconds"]), GREY, "-")):
        panel.plot(1e3 * np.sort(values), np.linspace(0, 1, len(values)), style, color=color, label=name)
    panel.axvline(1e3 * h, **LIMITS)
    panel.set(xscale="log", xlim=(0.2, 300))
    marks = [0.2, 0.5, 1, 2, 5, 10, 20, 50, 200]
    panel.set_xticks(marks, labels=[f"{mark:g}" for mark in marks])
    panel.minorticks_off()
    out.legend()
    return out


@styled
def late(r: Results) -> Sheet:
    """The tip and the elbow's torque where samples are late."""
    out = Sheet(1, 2, "Late samples: the plan goes on")
    away = out.axes("tip from its goal", ylabel="distance (mm)")
    torque = out.axes("torque of θ$_{z2}$", ylabel="τ (N·m)")
    for (name, m), color in zip(r.late.items(), (BLUE, ORANGE, GREEN, PINK), strict=True):
        t = STEP * np.arange(len(m.tip))
        away.plot(t, 1e3 * np.linalg.norm(m.tip - r.arms.goal, axis=1), color=color, label=name, linewidth=1.1)
        torque.plot(t, m.tau[:, 2], color=color, linewidth=1.0)
    away.axhline(1e3 * BANDS[BAND], **LIMITS)
    for limit in (-LIMIT[2], LIMIT[2]):
        torque.axhline(limit, **LIMITS)
    away.set(yscale="log", ylim=(0.3, 3000), xlim=(0, 1.2))
    torque.set_xlim(0, 1.2)
    out.legend()
    return out


@styled
def moment(r: Results) -> Sheet:
    out = Sheet(1, 1, "Bending moment at the elbow in the plant", (6.4, 3.2))
    t = np.arange(len(r.wrench[0][2])) * STEP
    names = ("without the bound", "with the bound")
    curves = [(n, m, c, "-") for n, (_, _, m), c in zip(names, r.wrench, (ORANGE, BLUE), strict=True)]
    out.curves("with and without its bound", t, curves, COMPONENT, "N·m", bounds=(BOUND,))
    out.legend()
    return out
