"""The paper's figures over time, from our runs: coordinates, twists, angles, end point, torques, wrenches."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from screwgen.motion import modal_columns, screws, tip_deformation, tip_position
from screwgen.plot import GREY, PALETTE

from .figures_of_vibration import divergence, fields, spectra
from .sheet import Sheet, xyz
from .task import Results, reference

BLUE, ORANGE = PALETTE[:2]
JOINTS = ("θ$_{y1}$", "θ$_{z1}$", "θ$_{z2}$")


def coordinates(r: Results) -> Sheet:
    found, t = screws(r.arm.axial, r.run.q, r.run.v), r.run.t
    out = Sheet(2, 2, "Coordinates of both links in body-fixed components")
    for i in range(2):
        out.curves(f"position of link {i + 1}", t, xyz(found.r[:, i], "r"), f"r$_{i + 1}$ (m)")
        out.curves(f"exponential coordinates of link {i + 1}", t, xyz(found.theta[:, i], "θ"), f"θ$_{i + 1}$ (rad)")
    return out


def twists(r: Results) -> Sheet:
    found, t = screws(r.arm.axial, r.run.q, r.run.v), r.run.t
    out = Sheet(2, 2, "Twists of both links in body-fixed components")
    for i in range(2):
        out.curves(f"velocity of link {i + 1}", t, xyz(found.v[:, i], "v"), f"v$_{i + 1}$ (m/s)")
        out.curves(f"angular velocity of link {i + 1}", t, xyz(found.omega[:, i], "ω"), f"ω$_{i + 1}$ (rad/s)")
    return out


def joint_angles(r: Results) -> Sheet:
    out, wanted = Sheet(1, 3, "Joint angles under PD torques", (3.6, 2.9)), reference(r.arm, r.run.t)
    for k, name in enumerate(JOINTS):
        curves = [("flexible arm", r.run.q[:, k], BLUE, "-"), ("reference", wanted[:, k], ORANGE, "--")]
        out.curves(name, r.run.t, curves, f"{name} (rad)")
    return out


def end_point(r: Results) -> Sheet:
    model, out = r.arm.axial, Sheet(1, 3, "End-point position, inertial frame", (3.6, 2.9))
    q = np.zeros_like(r.run.q)
    q[:, :3] = reference(r.arm, r.run.t)
    wanted = tip_position(model, q)
    for k, name in enumerate("xyz"):
        curves = [("flexible arm", r.run.tip_position[:, k], BLUE, "-")]
        curves += [("straight links at the reference", wanted[:, k], ORANGE, "--")]
        out.curves(f"{name}$_E$", r.run.t, curves, f"{name}$_E$ (m)")
    return out


def deformation(r: Results) -> Sheet:
    out, found = Sheet(1, 3, "End-point deformation, inertial components", (3.6, 2.9)), tip_deformation
    values = 1e3 * found(r.arm.axial, r.run.q)
    for k, name in enumerate("xyz"):
        title = f"{name}$_{{ξE}}$"
        out.curves(title, r.run.t, [(None, values[:, k], PALETTE[k], "-")], f"{title} (mm)", legend=False)
    return out


def modal(r: Results) -> Sheet:
    model, out = r.arm.axial, Sheet(1, 3, "Modal coordinates of both links", (3.6, 2.9))
    scales = {"axial": (1e6, "µm", "x"), "bending_y": (1e3, "mm", "y"), "bending_z": (1e3, "mm", "z")}
    for direction, (scale, unit, axis) in scales.items():
        columns = [modal_columns(model, i, direction)[0] for i in range(2)]
        curves = [
            (f"link {i + 1}", scale * r.run.q[:, c], shade, style)
            for i, (c, shade, style) in enumerate(zip(columns, (BLUE, ORANGE), ("-", "--"), strict=True))
        ]
        out.curves(f"η$_{axis}$", r.run.t, curves, f"η$_{axis}$ ({unit})")
    return out


def torques(r: Results) -> Sheet:
    out = Sheet(1, 3, "Joint torques, and those of the rigid arm under the same PD law", (3.6, 2.9))
    for k, name in enumerate(("τ$_{y1}$", "τ$_{z1}$", "τ$_{z2}$")):
        curves = [("flexible arm", r.run.tau[:, k], BLUE, "-"), ("rigid links", r.rigid.tau[:, k], ORANGE, "--")]
        out.curves(name, r.run.t, curves, f"{name} (N·m)")
    return out


def wrench(r: Results, joint: int) -> Sheet:
    title = ("base joint, on link 1", "connecting joint, on link 2")[joint]
    out = Sheet(2, 3, f"Interaction wrench at the {title}, in its frame", (3.6, 2.5))
    for start, symbol, unit in ((3, "F", "N"), (0, "τ", "N·m")):
        for k, axis in enumerate("xyz"):
            name, values = f"{symbol}$_{{{joint}{axis}}}$", r.run.wrench[:, joint, start + k]
            curves = [("flexible arm", values, BLUE, "-")]
            curves += [("rigid links", r.rigid.wrench[:, joint, start + k], ORANGE, "--")]
            panel = out.curves(name, r.run.t, curves, f"{name} ({unit})", legend=start == 3 and k == 0)
            panel.axhline(0, color=GREY, linewidth=0.6)
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
