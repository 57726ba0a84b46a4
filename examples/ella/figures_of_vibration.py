"""The figures of vibration: displacement fields, amplitude spectra, and how forward Euler diverges."""

from __future__ import annotations

import numpy as np

from screwgen.plotting.look import GREY, INK, PALETTE, SMALL, legend_below, styled
from screwgen.simulation.motion import displacements

from .arm import MOVE
from .frequencies import CHOSEN, CHOSEN_AT_START
from .growth import SMALL as SMALL_MOTION
from .sheet import Sheet
from .task import Results, spectrum

POINTS, COLUMNS = 61, 1200
HIGHEST = 25.0
"""Hz: where the spectra end."""
LEAST, MOST = 1e-3, 1e5
"""mm: of distances from the reference run."""


@styled
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
        extent = (r.run.t[0], r.run.t[-1], 0.0, length)
        image = panel.imshow(field, cmap="RdBu_r", vmin=-size, vmax=size, origin="lower", extent=extent, aspect="auto")
        panel.grid(False)
        out.figure.colorbar(image, ax=panel, label=f"{name} ({unit})", pad=0.01)
    return out


@styled
def spectra(r: Results) -> Sheet:
    """Amplitude spectra of the end-point deformation, with the frequencies of the closed loop."""
    out = Sheet(3, 1, "Amplitude spectrum of the end-point deformation, inertial components", (8.6, 2.2))
    windows = ((0.0, "whole run", PALETTE[0]), (MOVE, f"after {MOVE:g} s, tapered", PALETTE[1]))
    for k, axis in enumerate("xyz"):
        panel = out.axes(f"{axis}$_{{ξE}}$", xlabel="f (Hz)", ylabel="amplitude (mm)")
        for since, label, shade in windows:
            f, a = spectrum(r.arm, r.run, k, since)
            shown = f <= HIGHEST
            panel.semilogy(f[shown], 1e3 * np.maximum(a[shown], 1e-12), color=shade, label=label)
        panel.set_ylim(*decades(panel))
        marked(panel, r, CHOSEN, ":")
        marked(panel, r, CHOSEN_AT_START, "--")
        panel.set_xlim(0, HIGHEST)
    out.legend()
    return out


def marked(panel, r: Results, name: str, style: str) -> None:
    """Vertical lines at the frequencies of a closed loop, which the legend names."""
    found = next(loop for loop in r.loops if loop.name == name).frequencies
    where = "at the start" if name == CHOSEN_AT_START else "at the set points"
    label = f"closed loop {where}: {', '.join(f'{f:.2f}' for f in found)} Hz"
    for number, f in enumerate(found):
        panel.axvline(f, color=GREY, linewidth=0.9, linestyle=style, label=None if number else label)


def decades(panel) -> tuple[float, float]:
    """Limits of a logarithmic axis: at most four decades below the largest value drawn."""
    top = max(float(np.max(line.get_ydata())) for line in panel.lines if len(line.get_ydata()) > 2)
    return top * 1e-4, top * 2


@styled
def divergence(r: Results) -> Sheet:
    """Small disturbances under forward Euler with the predicted growth, and the task by every method."""
    out = Sheet(2, 2, "Forward Euler beside methods that hold", (4.6, 3.3))
    euler = [x for x in zip(r.growth[1:], r.histories, strict=True) if x[0].name.startswith("forward Euler")]
    kept = out.axes("axial modes kept: held arm, disturbed", "t (ms)", "leading motion (1 = start)")
    grown(kept, [x for x in euler if x[0].axial and x[0].predicted > 0], 1e3, 12e-3)
    gone = out.axes("axial modes dropped: held arm, disturbed", "t (s)", "leading motion (1 = start)")
    grown(gone, [x for x in euler if not x[0].axial and "DAE" not in x[0].name], 1.0, 0.6)
    task = out.axes("the task: end point from the reference run", "t (s)", "largest distance yet (mm)", span=2)
    held_and_lost(r, task)
    return out


def held_and_lost(r: Results, panel) -> None:
    """The largest distance of the end points up to every instant; those that are lost are named where they are."""
    held = []
    for k, (way, motion, distance) in enumerate(r.motions):
        t, away = motion.t[:: round(1e-3 / way.sample)][1:], 1e3 * np.maximum.accumulate(distance[1:])
        (line,) = panel.loglog(t, np.maximum(away, LEAST), color=PALETTE[k], label=way.name)
        if motion.complete:
            line.set_linestyle(("-", "--")[len(held) % 2])
            held.append(line)
        else:
            end, text = motion.t[-1], f"{way.name}:\nlost after {motion.t[-1] * 1e3:.0f} ms"
            place = dict(textcoords="offset points", fontsize=SMALL, va="top", color=PALETTE[k])
            panel.annotate(text, (end, MOST), (6, -4), **place)
    panel.set_xlim(1e-3, r.run.t[-1])
    panel.set_ylim(LEAST, MOST)
    legend_below(panel, 3, held)


@styled
def grown(panel, rows, scale: float, until: float) -> None:
    """Observed shares with the predicted exponentials, both from 1."""
    for k, (row, history) in enumerate(rows):
        shown = (history.t <= until) & (history.share < 1e6 * SMALL_MOTION)
        t, share = history.t[shown], history.share[shown] / history.share[0]
        name = row.name.removeprefix("forward Euler, ").removesuffix(", no axial modes")
        joints = "" if row.joints == "PD" else f", {row.joints}"
        label = f"{name}{joints}: {row.predicted:+.4g} /s".replace("-", "−")
        panel.semilogy(scale * t, share, color=PALETTE[k], label=label)
        panel.semilogy(scale * t, np.exp(row.predicted * t), "--", color=INK, linewidth=0.8)
    panel.plot([], [], "--", color=INK, linewidth=0.8, label="predicted")
    panel.margins(x=0)
    legend_below(panel, 2)
