"""The figures of vibration: displacement fields, amplitude spectra, and how forward Euler diverges."""

from __future__ import annotations

import numpy as np
from matplotlib import rc_context

from screwgen.motion import displacements
from screwgen.plot import GREY, LOOK, PALETTE

from .arm import MOVE
from .frequencies import CHOSEN, CHOSEN_AT_START
from .growth import SMALL
from .sheet import Sheet
from .task import Results, spectrum

POINTS, COLUMNS = 61, 1200
HIGHEST = 25.0
"""Hz: where the spectra end."""


def fields(r: Results, link: int) -> Sheet:
    """Displacement fields of a link in x, y and z over time, as images."""
    model, length = r.arm.axial, r.arm.robot.links[link].length
    rows = np.linspace(0, len(r.run.t) - 1, min(COLUMNS, len(r.run.t))).round().astype(int)
    values = displacements(model, r.run.q[rows], link, np.linspace(0, 1, POINTS))
    out = Sheet(3, 1, f"Displacement field of link {link + 1} along its centreline", (8.6, 2.0))
    for k, axis in enumerate("xyz"):
        scale, unit = (1e6, "µm") if axis == "x" else (1e3, "mm")
        name = f"r$_{{ξ{axis}{link + 1}}}$"
        panel, field = out.axes(name, ylabel="ξ (m)"), scale * values[:, :, k].T
        size = np.abs(field).max()
        with rc_context(LOOK):
            extent = (r.run.t[0], r.run.t[-1], 0.0, length)
            image = panel.imshow(
                field, cmap="RdBu_r", vmin=-size, vmax=size, origin="lower", extent=extent, aspect="auto"
            )
            panel.grid(False)
            out.figure.colorbar(image, ax=panel, label=f"{name} ({unit})", pad=0.01)
    return out


def spectra(r: Results) -> Sheet:
    """Amplitude spectra of the end-point deformation, with the frequencies of the closed loop."""
    out = Sheet(3, 1, "Amplitude spectrum of the end-point deformation, inertial components", (8.6, 2.2))
    windows = ((0.0, "whole run", PALETTE[0], "-"), (MOVE, f"after {MOVE:g} s, tapered", PALETTE[1], "-"))
    for k, axis in enumerate("xyz"):
        panel = out.axes(f"{axis}$_{{ξE}}$", xlabel="f (Hz)", ylabel="amplitude (mm)")
        with rc_context(LOOK):
            for since, label, shade, style in windows:
                f, a = spectrum(r.arm, r.run, k, since)
                shown = f <= HIGHEST
                panel.semilogy(f[shown], 1e3 * np.maximum(a[shown], 1e-12), style, color=shade, label=label)
            panel.set_ylim(*decades(panel))
            marked(panel, r, CHOSEN, ":", 1.0)
            marked(panel, r, CHOSEN_AT_START, "--", 0.12)
            panel.set_xlim(0, HIGHEST)
            if k == 0:
                panel.legend(loc="upper center", bbox_to_anchor=(0.5, 1.32), ncols=4)
    return out


def marked(panel, r: Results, name: str, style: str, height: float) -> None:
    """Vertical lines at the frequencies of a closed loop; of two close ones the lower is named to its left."""
    found = next(loop for loop in r.loops if loop.name == name).frequencies
    where = "at the start" if name == CHOSEN_AT_START else "at the set points"
    for number, f in enumerate(found):
        panel.axvline(f, color=GREY, linewidth=0.9, linestyle=style, label=None if number else f"closed loop {where}")
        side = "right" if number + 1 < len(found) and found[number + 1] < f + 1.5 else "left"
        place = dict(transform=panel.get_xaxis_transform(), fontsize=7, va="top", ha=side, color=GREY)
        panel.text(f, height, f" {f:.2f} ", **place)


def decades(panel) -> tuple[float, float]:
    """Limits of a logarithmic axis: at most four decades below the largest value drawn."""
    top = max(float(np.max(line.get_ydata())) for line in panel.lines if len(line.get_ydata()) > 2)
    return top * 1e-4, top * 2


def divergence(r: Results) -> Sheet:
    """Small disturbances under forward Euler with the predicted growth, and the task by every method."""
    out = Sheet(2, 2, "Forward Euler beside methods that hold", (4.6, 3.0))
    euler = [x for x in zip(r.growth[1:], r.histories, strict=True) if x[0].name.startswith("forward Euler")]
    kept = out.axes("axial modes kept: held arm, disturbed", "t (ms)", "leading motion (1 = start)")
    grown(kept, [x for x in euler if x[0].axial and x[0].predicted > 0], 1e3, 12e-3)
    gone = out.axes("axial modes dropped: held arm, disturbed", "t (s)", "leading motion (1 = start)")
    grown(gone, [x for x in euler if not x[0].axial and "DAE" not in x[0].name], 1.0, 0.6)
    task = out.axes("the task: distance of the end point from the reference run", "t (s)", "distance (mm)", span=2)
    with rc_context(LOOK):
        for k, (way, motion, distance) in enumerate(r.motions):
            t = motion.t[:: round(1e-3 / way.sample)]
            shade, style = PALETTE[k % len(PALETTE)], "-" if "forward" in way.name else "--"
            label = way.name if motion.complete else f"{way.name}: lost after {motion.t[-1] * 1e3:.0f} ms"
            task.semilogy(t[1:], 1e3 * np.maximum(distance[1:], 1e-9), style, color=shade, label=label)
        task.set_xlim(0, r.run.t[-1])
        task.set_ylim(1e-3, 1e5)
        task.legend(loc="upper right", ncols=2, fontsize=7)
    return out


def grown(panel, rows, scale: float, until: float) -> None:
    """Observed shares with the predicted exponentials, both from 1."""
    with rc_context(LOOK):
        for k, (row, history) in enumerate(rows):
            shown = (history.t <= until) & (history.share < 1e6 * SMALL)
            t, share = history.t[shown], history.share[shown] / history.share[0]
            name = row.name.removeprefix("forward Euler, ").removesuffix(", no axial modes")
            joints = "" if row.joints == "PD" else f", {row.joints}"
            panel.semilogy(scale * t, share, color=PALETTE[k], label=f"{name}{joints}: {row.predicted:+.4g} /s")
            panel.semilogy(scale * t, np.exp(row.predicted * t), "--", color="#1a202c", linewidth=0.8)
        panel.plot([], [], "--", color="#1a202c", linewidth=0.8, label="predicted")
        panel.margins(x=0)
        panel.legend(loc="best", fontsize=7)
