"""Figures."""

from __future__ import annotations

import numpy as np
from ella.sheet import Sheet

from screwgen.plotting.look import GREY, LIMITS, PALETTE, styled

from .arms import LIMIT, STEP
from .ocp import Form
from .task import BAND, BANDS, Results, settled
from .wrench import BOUND, COMPONENT

BLUE, ORANGE, GREEN, PINK, PURPLE = PALETTE[:5]
STYLES = {
    "mpc": (BLUE, "-"),
    "pd": (ORANGE, "-"),
    "told": (PINK, "-"),
    "hindsight": (GREEN, "-"),
    "plan": (PURPLE, "--"),
}
SHORT = {
    "mpc": "MPC",
    "pd": "PD, nominal",
    "told": "PD, told the payload",
    "hindsight": "PD, best in hindsight",
    "plan": "PD along the plan",
}


def draw(r: Results) -> dict[str, bytes]:
    sheets = {
        "settling.png": settling_times(r),
        "closed_loop.png": closed_loop(r),
        "solves.png": solves(r),
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
    out, shown = Sheet(2, 2, "Point to point, payload 30 % heavier than designed for"), ("mpc", "pd", "told", "plan")
    end = len(r.motions["pd"].tip) * STEP
    panel = out.axes("tip from its goal", ylabel="distance (mm)")
    for name in shown:
        tip, (color, style) = r.motions[name].tip, STYLES[name]
        away = 1e3 * np.linalg.norm(tip - r.arms.goal, axis=1)
        panel.plot(STEP * np.arange(len(tip)), away, style, color=color, label=SHORT[name], linewidth=1.1)
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
def solves(r: Results) -> Sheet:
    out, h = Sheet(1, 2, "Solves of the receding horizon"), Form().h
    t = h * np.arange(len(r.solutions))
    panel = out.axes("time of a solve, one core", ylabel="ms")
    panel.plot(t, [1e3 * s.seconds for s in r.solutions], ".", color=BLUE)
    panel.axhline(1e3 * h, **LIMITS)
    panel.set_ylim(bottom=0)
    panel = out.axes("iterations", ylabel="iterations")
    panel.plot(t, [s.iterations for s in r.solutions], ".", color=BLUE)
    panel.set_ylim(bottom=0)
    return out


@styled
def moment(r: Results) -> Sheet:
    out = Sheet(1, 1, "Bending moment at the elbow in the plant", (6.4, 3.2))
    t = np.arange(len(r.wrench[0][2])) * STEP
    names = ("plan without bound", "plan on the DAE form, moment bounded")
    curves = [(n, m, c, "-") for n, (_, _, m), c in zip(names, r.wrench, (ORANGE, BLUE), strict=True)]
    out.curves("with and without its bound", t, curves, COMPONENT, "N·m", bounds=(BOUND,))
    out.legend()
    return out
