"""The oracle's reading of a robot's dict: every link as numbers; no package code."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import scipy.linalg
from oracle_second_order import SecondOrder, second_order
from oracle_sections import intervals, property_at, stations_of
from oracle_shapes import DIRECTIONS, Shapes, quadrature, shapes_of

STIFFNESS_OF = {
    "axial": "EA", "bending_y": "EIz", "bending_z": "EIy", "torsion": "GJ", "shear_y": "GAy", "shear_z": "GAz"
}  # fmt: skip
UNIT = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


class Body(NamedTuple):
    """Mass, centre of mass (3,), inertia tensor (3, 3) about it; axes of F_i or of the tip frame."""

    mass: float
    com: np.ndarray
    inertia: np.ndarray


@dataclass(frozen=True)
class Link:
    """Numbers of one link. K, D and mode tables are ordered as `DIRECTIONS`."""

    length: float
    a: float  # coordinate of the link's base on its centreline, from F_i (m)
    rhoA: np.ndarray  # (N,)
    inertia: np.ndarray  # (3, N), rhoIp, rhoIy, rhoIz; 0 where the file states none
    axes: np.ndarray  # (m, 3), unit vectors
    turns: tuple[bool, ...]  # of each axis; a link that does not turn about it slides along it
    travel: np.ndarray  # (m,), m along the axis per unit of the coordinate
    mount_R: np.ndarray  # (3, 3)
    mount_xyz: np.ndarray  # (3,), parent's tip axes
    armature: np.ndarray  # (m,)
    joint_damping: np.ndarray  # (m,)
    joint_stiffness: np.ndarray  # (m,)
    base: list[Body]
    tip: list[Body]
    shapes: dict[str, Shapes]
    counts: dict[str, int]
    nodes: np.ndarray  # (N,), s
    weights: np.ndarray  # (N,), sum 1
    K: np.ndarray  # (r, r), modal stiffness
    damping: np.ndarray  # (r,), modal damping coefficients
    second: SecondOrder | None  # of a link of order 2 with modes


def hat(a) -> np.ndarray:
    """Numeric (3, 3) matrix of a × ."""
    x, y, z = (float(c) for c in a)
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def rpy_matrix(rpy) -> np.ndarray:
    """URDF's Rz(yaw) Ry(pitch) Rx(roll)."""
    return np.linalg.multi_dot([scipy.linalg.expm(hat(UNIT[k]) * rpy["xyz".index(k)]) for k in "zyx"])


def unit_axis(axis) -> np.ndarray:
    """Unit vector of a letter or of three numbers."""
    vector = np.array(UNIT[axis] if isinstance(axis, str) else axis, dtype=float)
    return vector / np.linalg.norm(vector)


class Axis(NamedTuple):
    """One degree of freedom of a joint: its unit vector, whether the link turns about it, and m along it per unit."""

    direction: np.ndarray
    turns: bool
    travel: float


def read_axis(axis) -> Axis:
    """A letter, a vector, the table of a slide or a screw, or an object with axis, turn and travel."""
    if isinstance(axis, dict):
        slides = "slide" in axis
        return Axis(unit_axis(axis["slide" if slides else "screw"]), not slides, 1.0 if slides else axis["pitch"])
    return Axis(unit_axis(getattr(axis, "axis", axis)), getattr(axis, "turn", True), getattr(axis, "travel", 0.0))


LINE = ("rhoA", "EA", "EIy", "EIz", "GJ", "rhoIp", "GAy", "GAz", "rhoIy", "rhoIz")
TURNED = {"torsion": "rhoIp", "bending_y": "rhoIz", "bending_z": "rhoIy"}


def properties_along(section, nodes: np.ndarray) -> dict[str, np.ndarray]:
    """The line properties of a section at the places `nodes`, (N,) each."""
    stations, between = stations_of(section)
    line = [{"at": x["at"], **line_properties(x)} for x in stations]
    whole = {"stations": line, "between": between} if line else line_properties(section)
    return {name: property_at(whole, name, nodes) for name in LINE}


def line_properties(section: dict) -> dict:
    """The line properties of a section in either spelling; 0 for what it does not state."""
    if "density" not in section:
        return {key: section.get(key, 0.0) for key in LINE}
    keys = ("density", "area", "E", "G", "Iy", "Iz", "J")
    density, area, E, shear, Iy, Iz, J = (section.get(key, 0.0) for key in keys)
    line = {"rhoA": density * area, "EA": E * area, "EIy": E * Iy, "EIz": E * Iz, "GJ": shear * J}
    default = density * (Iy + Iz) if Iy and Iz else 0.0
    return line | {"rhoIp": section.get("rhoIp", default)} | {key: section.get(key, 0.0) for key in LINE[6:]}


def read_body(body: dict) -> Body:
    """Body of one entry of `bodies`; products of inertia are the tensor's entries."""
    xx, yy, zz, xy, xz, yz = body.get("inertia", [0.0] * 6)
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], dtype=float)
    return Body(body["mass"], np.array(body.get("com", [0.0] * 3), dtype=float), tensor)


def modal_matrices(link: dict, line: dict, shapes: dict, weights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """K (r, r) and the damping coefficients (r,) of one link."""
    length, ratio = link["length"], link.get("damping", {}).get("ratio", 0.0)
    blocks, inertia = [np.zeros((0, 0))], []
    for name in DIRECTIONS:
        power = 3 if name.startswith("bending") else 1
        strain, values = shapes[name].strain, shapes[name].nodes
        blocks.append((strain * weights * line[STIFFNESS_OF[name]]) @ strain.T / length**power)
        turns = shapes[name].slope / length if name.startswith("bending") else values
        own = turns**2 @ (weights * line[TURNED[name]]) if name in TURNED else 0.0
        moved = 0.0 if name == "torsion" else values**2 @ (weights * line["rhoA"])
        inertia += [*(np.broadcast_to(moved + own, len(values)) * length)]
    K = scipy.linalg.block_diag(*blocks)
    return K, 2.0 * ratio * np.sqrt(np.diag(K) * np.array(inertia))


def read_link(link: dict, extra_nodes: int = 0, order: int = 1) -> Link:
    """Turn one `[[links]]` table into numbers; `extra_nodes` raises the quadrature order."""
    modes, joint, parts = link.get("modes", {}), link["joint"], tuple(intervals(link["section"]))
    counts = {name: modes.get(name, 0) for name in DIRECTIONS}
    count = 16 + 4 * max(counts.values()) + extra_nodes
    shapes = {d: shapes_of(d, modes.get("basis", "polynomial"), counts[d], count, parts) for d in DIRECTIONS}
    nodes, weights = quadrature(count, parts)
    line = properties_along(link["section"], nodes)
    K, damping = modal_matrices(link, line, shapes, weights)
    screws = [read_axis(axis) for axis in joint["axes"]]
    axes = np.array([screw.direction for screw in screws]).reshape(-1, 3)
    per_axis = lambda key: np.array(joint.get(key, [0.0] * len(axes)), dtype=float)  # noqa: E731
    mount, bodies = joint.get("mount", {}), link.get("bodies", [])
    quadratic = link.get("order", order) == 2 and any(counts.values())
    return Link(
        length=link["length"],
        a=-link.get("frame_at", 0.0),
        rhoA=line["rhoA"],
        inertia=np.array([line[name] for name in ("rhoIp", "rhoIy", "rhoIz")]),
        axes=axes,
        turns=tuple(screw.turns for screw in screws),
        travel=np.array([screw.travel for screw in screws]),
        mount_R=rpy_matrix(mount.get("rpy", [0.0] * 3)),
        mount_xyz=np.array(mount.get("xyz", [0.0] * 3), dtype=float),
        armature=per_axis("armature"),
        joint_damping=per_axis("damping"),
        joint_stiffness=per_axis("stiffness"),
        base=[read_body(b) for b in bodies if b["at"] == "base"],
        tip=[read_body(b) for b in bodies if b["at"] == "tip"],
        shapes=shapes,
        counts=counts,
        nodes=nodes,
        weights=weights,
        K=K,
        damping=damping,
        second=second_order(modes.get("basis", "polynomial"), counts, link["length"], nodes) if quadratic else None,
    )
