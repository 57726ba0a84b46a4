"""The paper's figures over time, from our runs: coordinates, twists, angles, end point, torques, wrenches."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from screwgen.plotting.curves import NOTHING
from screwgen.plotting.look import GREY, PALETTE
from screwgen.simulation.motion import modal_columns, screws, tip_deformation, tip_position

from .figures_of_vibration import divergence, fields, spectra
from .sheet import Sheet, xyz
from .task import Results, reference

BLUE, ORANGE = PALETTE[:2]
WIDE = (3.6, 2.9)
"""Inches: a panel of three in a row."""
JOINTS = ("θ$_{y1}$", "θ$_{z1}$", "θ$_{z2}$")


def coordinates(r: Results) -> Sheet:
    found = screws(r.arm.axial, r.run.q, r.run.v)
    rows = (("position", found.r, "r", "m"), ("exponential coordinates", found.theta, "θ", "rad"))
    return links("Coordinates of both links in body-fixed components", r.run.t, rows)


def twists(r: Results) -> Sheet:
    found = screws(r.arm.axial, r.run.q, r.run.v)
    rows = (("velocity", found.v, "v", "m/s"), ("angular velocity", found.omega, "ω", "rad/s"))
    return links("Twists of both links in body-fixed components", r.run.t, rows)


def links(title: str, t: np.ndarray, rows: tuple) -> Sheet:
    """Vectors (N, links, 3) link by link, each a name, values, symbol and unit; what is zero throughout is said."""
    panels = [(f"{name} of link {i + 1}", x[:, i], s, i, unit) for i in range(2) for name, x, s, unit in rows]
    silent = [name for name, x, *_ in panels if np.abs(x).max() <= NOTHING]
    shown = [panel for panel in panels if panel[0] not in silent]
    note = f"   (zero throughout: {', '.join(silent)})" if silent else ""
    out = Sheet(-(-len(shown) // 2), 2, title + note) if len(shown) > 3 else Sheet(1, len(shown), title + note)
    for name, x, symbol, i, unit in shown:
        out.curves(name, t, xyz(x), f"{symbol}$_{i + 1}$", unit)
    out.legend()
    return out


def joint_angles(r: Results) -> Sheet:
    out, wanted = Sheet(1, 3, "Joint angles under PD torques", WIDE), reference(r.arm, r.run.t)
    for k, name in enumerate(JOINTS):
        curves = [("flexible arm", r.run.q[:, k], BLUE, "-"), ("reference", wanted[:, k], ORANGE, "--")]
        out.curves(name, r.run.t, curves, name, "rad")
    out.legend()
    return out


def end_point(r: Results) -> Sheet:
    model, out = r.arm.axial, Sheet(1, 3, "End-point position, inertial frame", WIDE)
    q = np.zeros_like(r.run.q)
    q[:, :3] = reference(r.arm, r.run.t)
    wanted = tip_position(model, q)
    for k, name in enumerate("xyz"):
        curves = [("flexible arm", r.run.tip_position[:, k], BLUE, "-")]
        curves += [("straight links at the reference", wanted[:, k], ORANGE, "--")]
        out.curves(f"{name}$_E$", r.run.t, curves, f"{name}$_E$", "m")
    out.legend()
    return out


def deformation(r: Results) -> Sheet:
    out, values = Sheet(1, 3, "End-point deformation, inertial components", WIDE), tip_deformation(r.arm.axial, r.run.q)
    for k, name in enumerate("xyz"):
        title = f"{name}$_{{ξE}}$"
        out.curves(title, r.run.t, [(None, values[:, k], PALETTE[k], "-")], title, "m")
    return out


def modal(r: Results) -> Sheet:
    model, out = r.arm.axial, Sheet(1, 3, "Modal coordinates of both links", WIDE)
    for direction, axis in (("axial", "x"), ("bending_y", "y"), ("bending_z", "z")):
        columns = [modal_columns(model, i, direction) for i in range(2)]
        curves = [
            (f"link {i + 1}, mode {j + 1}", r.run.q[:, c], PALETTE[2 * j + i], ("-", "--")[i])
            for i in range(2)
            for j, c in enumerate(columns[i])
        ]
        out.curves(f"η$_{axis}$", r.run.t, curves, f"η$_{axis}$", "m")
    out.legend()
    return out


def torques(r: Results) -> Sheet:
    out = Sheet(1, 3, "Joint torques, and those of the rigid arm under the same PD law", WIDE)
    for k, name in enumerate(("τ$_{y1}$", "τ$_{z1}$", "τ$_{z2}$")):
        curves = [("flexible arm", r.run.tau[:, k], BLUE, "-"), ("rigid links", r.rigid.tau[:, k], ORANGE, "--")]
        out.curves(name, r.run.t, curves, name, "N·m")
    out.legend()
    return out


def wrench(r: Results, joint: int) -> Sheet:
    title = ("base joint, on link 1", "connecting joint, on link 2")[joint]
    out = Sheet(2, 3, f"Interaction wrench at the {title}, in its frame", (3.6, 2.5))
    for start, symbol, unit in ((3, "F", "N"), (0, "τ", "N·m")):
        for k, axis in enumerate("xyz"):
            name, values = f"{symbol}$_{{{joint}{axis}}}$", r.run.wrench[:, joint, start + k]
            curves = [("flexible arm", values, BLUE, "-")]
            curves += [("rigid links", r.rigid.wrench[:, joint, start + k], ORANGE, "--")]
            out.curves(name, r.run.t, curves, name, unit).axhline(0, color=GREY, linewidth=0.6)
    out.legend()
    return out


FIGURES: dict[str, Callable[[Results], Sheet]] = {
    "fig03_joint_angles.png": joint_angles,
    "fig04_coordinates.png": coordinates,
    "fig06_twists.png": twists,
    "fig07_end_point.png": end_point,
    "fig08_deformation.png": deformation,
    "fig08_spectrum.png": spectra,
    "fig09_field_link1.png": lambda r: fields(r, 0),
    "fig10_field_link2.png": lambda r: fields(r, 1),
    "fig11_modal.png": modal,
    "fig12_torques.png": torques,
    "fig13_base_wrench.png": lambda r: wrench(r, 0),
    "fig14_joint_wrench.png": lambda r: wrench(r, 1),
    "divergence.png": divergence,
}


def draw(r: Results, progress: Callable[[str], None]) -> dict[str, bytes]:
    """All figures as PNG by file name."""
    out = {}
    for name, make in FIGURES.items():
        progress(f"figure {name}")
        out[name] = make(r).png(r.extent.dpi)
    return out
