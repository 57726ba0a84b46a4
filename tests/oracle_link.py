"""The oracle's reading of a robot's dict: every link as numbers; no package code."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import casadi as ca
import numpy as np
import scipy.linalg
from oracle_flexible import FlexibleLink
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
    drives: list[dict]  # of each axis, as the file states them
    limits: list[dict]  # likewise
    base: list[Body]
    tip: list[Body]
    shapes: dict[str, Shapes]
    counts: dict[str, int]
    nodes: np.ndarray  # (N,), s
    weights: np.ndarray  # (N,), sum 1
    K: np.ndarray  # (r, r), modal stiffness
    damping: np.ndarray  # (r,), modal damping coefficients
    second: SecondOrder | None  # of a link of order 2 with modes

    tip_axes = np.eye(3)

    @property
    def masses(self) -> np.ndarray:
        """(N,) kg, of the elements."""
        return self.rhoA * self.length * self.weights

    @property
    def spin_inertia(self) -> np.ndarray:
        """(3, N) kg·m², of the elements about the axes of F_i."""
        return self.inertia * self.length * self.weights

    def undeformed(self) -> np.ndarray:
        """(3, N): the elements of the straight link, in F_i."""
        return np.outer([1.0, 0, 0], self.a + self.length * self.nodes)

    def _columns(self, eta: ca.SX, values: dict[str, np.ndarray]) -> dict[str, ca.SX]:
        """Of each direction the sum of its modes, whose values (r, N) are given; a row."""
        out, first = {}, 0
        for d in DIRECTIONS:
            coefficients = np.atleast_2d(values[d])
            modes, first = eta[first : first + self.counts[d]], first + self.counts[d]
            out[d] = modes.T @ ca.DM(coefficients) if modes.numel() else ca.SX.zeros(1, coefficients.shape[-1])
        return out

    def shift(self, eta: ca.SX) -> ca.SX:
        """(3, N): the elements' linear displacements."""
        return self._moved(eta, {d: self.shapes[d].nodes for d in DIRECTIONS})

    def _moved(self, eta: ca.SX, values: dict[str, np.ndarray]) -> ca.SX:
        """Displacements along x, y, z: bending and shear add."""
        by = self._columns(eta, values)
        return ca.vertcat(by["axial"], by["bending_y"] + by["shear_y"], by["bending_z"] + by["shear_z"])

    def twist(self, eta: ca.SX) -> ca.SX:
        """(3, N): the turns of the sections, of first order: torsion angle, -u_z' and u_y' of bending."""
        slopes = {d: self.shapes[d].slope / self.length for d in ("bending_y", "bending_z")}
        by = self._columns(eta, {d: slopes.get(d, self.shapes[d].nodes) for d in DIRECTIONS})
        return ca.vertcat(by["torsion"], -by["bending_z"], by["bending_y"])

    def second_shift(self, eta: ca.SX) -> ca.SX | None:
        """(3, N): their second-order displacements."""
        if self.second is None:
            return None
        return ca.horzcat(*[quadratic(self.second.place[..., j], eta) for j in range(len(self.nodes))])

    def tip_place(self, eta: ca.SX) -> ca.SX:
        """The tip point in F_i."""
        place = self._moved(eta, {d: self.shapes[d].tip[:, None] for d in DIRECTIONS})
        place += ca.DM([self.a + self.length, 0, 0])
        return place if self.second is None else place + quadratic(self.second.tip, eta)

    def tip_turn(self, eta: ca.SX) -> ca.SX:
        """The rotation vector of the tip section: [torsion, -u_z', u_y'] at the tip."""
        slopes = {d: self.shapes[d].tip_slope / self.length for d in ("bending_y", "bending_z")}
        at = self._columns(eta, {d: slopes.get(d, self.shapes[d].tip)[:, None] for d in DIRECTIONS})
        theta = ca.vertcat(at["torsion"], -at["bending_z"], at["bending_y"])
        return theta if self.second is None else theta + quadratic(self.second.turn, eta)


def quadratic(H: np.ndarray, eta: ca.SX) -> ca.SX:
    """1/2 eta^T H_c eta for the three axes c of H (3, r, r)."""
    return ca.vertcat(*[ca.dot(eta, ca.DM(h) @ eta) / 2 for h in H])


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


def read_mounting(link: dict) -> dict:
    """The joint of a link and its bodies, by the names of `Link`."""
    joint, bodies = link["joint"], link.get("bodies", [])
    screws = [read_axis(axis) for axis in joint["axes"]]
    axes = np.array([screw.direction for screw in screws]).reshape(-1, 3)
    per_axis = lambda key: np.array(joint.get(key, [0.0] * len(axes)), dtype=float)  # noqa: E731
    mount = joint.get("mount", {})
    return dict(
        axes=axes,
        turns=tuple(screw.turns for screw in screws),
        travel=np.array([screw.travel for screw in screws]),
        mount_R=rpy_matrix(mount.get("rpy", [0.0] * 3)),
        mount_xyz=np.array(mount.get("xyz", [0.0] * 3), dtype=float),
        armature=per_axis("armature"),
        joint_damping=per_axis("damping"),
        joint_stiffness=per_axis("stiffness"),
        drives=joint.get("drives", [{}] * len(axes)),
        limits=joint.get("limits", [{}] * len(axes)),
        base=[read_body(b) for b in bodies if b["at"] == "base"],
        tip=[read_body(b) for b in bodies if b["at"] == "tip"],
    )


def read_link(link: dict, extra_nodes: int = 0, order: int = 1) -> Link:
    """Turn one `[[links]]` table into numbers; `extra_nodes` raises the quadrature order."""
    if "cloud" in link:
        cloud = link["cloud"]
        damping = np.zeros(cloud.modes) if cloud.damping is None else cloud.damping
        return FlexibleLink(cloud=cloud, damping=damping, **read_mounting(link))
    modes, parts = link.get("modes", {}), tuple(intervals(link["section"]))
    counts = {name: modes.get(name, 0) for name in DIRECTIONS}
    count = 16 + 4 * max(counts.values()) + extra_nodes
    shapes = {d: shapes_of(d, modes.get("basis", "polynomial"), counts[d], count, parts) for d in DIRECTIONS}
    nodes, weights = quadrature(count, parts)
    line = properties_along(link["section"], nodes)
    K, damping = modal_matrices(link, line, shapes, weights)
    quadratic = link.get("order", order) == 2 and any(counts.values())
    exact = link.get("order", order) == "exact" and any(counts.values())
    kind, more = (Link, {}) if not exact else exact_parts(link, parts)
    if exact:
        nodes, weights = more.pop("masses")
        line = properties_along(link["section"], nodes)
    return kind(
        **more,
        length=link["length"],
        a=-link.get("frame_at", 0.0),
        rhoA=line["rhoA"],
        inertia=np.array([line[name] for name in ("rhoIp", "rhoIy", "rhoIz")]),
        **read_mounting(link),
        shapes=shapes,
        counts=counts,
        nodes=nodes,
        weights=weights,
        K=K,
        damping=damping,
        second=second_order(modes.get("basis", "polynomial"), counts, link["length"], nodes) if quadratic else None,
    )


def exact_parts(link: dict, parts: tuple) -> tuple[type, dict]:
    """What a link of order "exact" has besides: its sections, and where its masses are."""
    from oracle_exact import ExactLink, count_of_points, gauss

    basis, count = link["modes"].get("basis", "polynomial"), count_of_points(link)
    points, weights = gauss(count)
    stations, between = stations_of(link["section"])
    degree = len(stations) - 1 if between == "polynomial" else 1
    masses = quadrature(count - 1 + (degree + 2) // 2, parts) if stations else gauss(20)
    fine, shares = quadrature(count + degree, parts)
    line = properties_along(link["section"], fine)
    others = [np.delete(points, k) for k in range(count)]
    products = [[np.prod((s - x) / (p - x)) for s in fine] for p, x in zip(points, others, strict=True)]
    inertia = np.array([products @ (shares * line[name]) for name in ("rhoIp", "rhoIy", "rhoIz")]) / weights
    own = dict(points=points, section_weights=weights, section_inertia=inertia, basis=basis, masses=masses)
    return ExactLink, own | {"rest": link.get("rest")}
