"""A link from finite elements: a square tube with a flange and a bracket, meshed and assembled by scikit-fem.

The solid model is reduced when the robot file is read, and compared with itself in full and with the same link as a
rod that carries a rigid bracket. Writes the mesh, two robot files, standard input data and a figure to build/bracket.
Needs scikit-fem: `pip install screwgen[fem]`.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import scipy.sparse as sparse
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from scipy.sparse.linalg import eigsh
from skfem import Basis, BilinearForm, ElementHex2, ElementVector, MeshHex
from skfem.helpers import dot
from skfem.models.elasticity import lame_parameters, linear_elasticity

import screwgen
from screwgen.plotting.look import INK, PALETTE, canvas, png, styled
from screwgen.studies.modes import mode_shapes

FOLDER = Path(__file__).resolve().parents[1] / "build" / "bracket"
E, NU, DENSITY, PAYLOAD = 70e9, 0.33, 2700.0, 2.0
X = [0.0, 0.012, *np.linspace(0.012, 0.6, 11)[1:], 0.615]
Y = [-0.05, -0.03, -0.026, 0.0, 0.026, 0.03, 0.05]
Z = [-0.12, -0.085, -0.05, -0.03, -0.026, 0.0, 0.026, 0.03, 0.05]
"""m: planes of the grid; the flange ends at X[1], the tube at X[-2], the bracket reaches down to Z[0]."""
COUNTS = (0, 2, 4, 6)
"""Numbers of normal modes."""
LOWEST = 6

REDUCED = """name = "bracket"
gravity = [0.0, 0.0, -9.81]

[[links]]
name = "boom"
body = {{ npz = "boom.npz", modes = {modes} }}
damping = {{ ratio = 0.01 }}
joint = {{ axes = ["y"] }}
bodies = [{{ at = "tip", mass = {payload} }}]
"""
ROD = """name = "rod"
gravity = [0.0, 0.0, -9.81]

[[links]]
name = "boom"
length = 0.6
profile = {{ box = {{ height = 0.06, breadth = 0.06, wall = 0.004 }}, E = {E}, density = {density}, nu = {nu} }}
modes = {{ axial = 1, bending_y = 4, bending_z = 4, torsion = 2 }}
damping = {{ ratio = 0.01 }}
joint = {{ axes = ["y"] }}
bodies = [
    {{ at = "tip", mass = {bracket}, com = [0.0075, 0.0, -0.045], inertia = {inertia} }},
    {{ at = "tip", mass = {payload}, com = [0.0075, 0.0, -0.12] }},
]
"""


class Solid:
    """The finite-element model: quadratic hexahedra, displacements node by node."""

    def __init__(self):
        grid = MeshHex.init_tensor(np.array(X), np.array(Y), np.array(Z))
        x, y, z = grid.p[:, grid.t].mean(axis=1)
        tube = (abs(y) < Y[-2]) & (abs(z) < Z[-2]) & ~((abs(y) < Y[-3]) & (abs(z) < Z[-3]))
        inside = np.where(x < X[1], abs(z) < Z[-1], np.where(x < X[-2], tube, (abs(y) < Y[-2]) & (z < Z[-2])))
        self.mesh = grid.restrict(np.flatnonzero(inside))
        basis = Basis(self.mesh, ElementVector(ElementHex2()), intorder=4)
        tables = (basis.dofs.nodal_dofs, basis.dofs.edge_dofs, basis.dofs.facet_dofs, basis.dofs.interior_dofs)
        rows = np.hstack([t.reshape(-1, 3, t.shape[1]).transpose(0, 2, 1).reshape(-1, 3).T for t in tables]).T
        mass = BilinearForm(lambda u, v, _: DENSITY * dot(u, v)).assemble(basis)
        stiffness = linear_elasticity(*lame_parameters(E, NU)).assemble(basis)
        self.M, self.K = (A[rows.ravel()][:, rows.ravel()].tocsr() for A in (mass, stiffness))
        self.nodes = basis.doflocs[:, rows[:, 0]].T
        self.sets = {"base": self.at(0, X[0]), "tip": self.at(2, Z[0])}

    def at(self, axis: int, place: float) -> np.ndarray:
        """The nodes in a plane."""
        return np.flatnonzero(abs(self.nodes[:, axis] - place) < 1e-9)

    def write(self, path: Path) -> None:
        """The file that a robot file names."""
        parts = {f"{n}_{k}": getattr(A, k) for n, A in (("M", self.M), ("K", self.K)) for k in PARTS}
        np.savez(path, nodes=self.nodes, **parts, **{f"set_{name}": nodes for name, nodes in self.sets.items()})

    def frequencies(self, payload: float) -> tuple[np.ndarray, np.ndarray]:
        """The lowest natural frequencies, Hz, and modes (n, 3, count); base clamped, tip rigid with a payload."""
        tip, n = self.sets["tip"], len(self.nodes)
        free = np.setdiff1d(np.arange(n), np.append(tip, self.sets["base"]))
        inner = (3 * free[:, None] + np.arange(3)).ravel()
        rigid = np.zeros((3 * n, 6))
        for k, axis in enumerate(np.eye(3)):
            rigid[3 * tip + k, k] = 1.0
            lever = np.cross(axis, self.nodes[tip] - self.nodes[tip].mean(axis=0))
            rigid[(3 * tip[:, None] + np.arange(3)).ravel(), 3 + k] = lever.ravel()
        T = sparse.hstack([sparse.identity(3 * n, format="csc")[:, inner], sparse.csc_matrix(rigid)]).tocsc()
        added = sparse.diags(np.append(np.zeros(len(inner)), [payload] * 3 + [0.0] * 3))
        M, K = T.T @ self.M @ T + added, T.T @ self.K @ T
        squares, shapes = eigsh(K, k=LOWEST, M=M, sigma=0, v0=np.ones(K.shape[0]))
        order = np.argsort(squares)
        return np.sqrt(squares[order]) / (2 * np.pi), (T @ shapes[:, order]).reshape(n, 3, LOWEST)


PARTS = ("data", "indices", "indptr", "shape")


def robots(solid: Solid) -> dict[str, screwgen.Robot]:
    """The arm with its boom reduced, by number of normal modes, and as a rod."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    solid.write(FOLDER / "boom.npz")
    size = np.array([0.015, 0.06, 0.15])
    bracket = DENSITY * size.prod()
    inertia = [float(x) for x in bracket / 12 * (size @ size - size**2)] + [0.0] * 3
    texts = {f"{n} modes": REDUCED.format(modes=n, payload=PAYLOAD) for n in COUNTS}
    texts["rod"] = ROD.format(E=E, density=DENSITY, nu=NU, bracket=bracket, inertia=inertia, payload=PAYLOAD)
    out = {}
    for name, text in texts.items():
        path = FOLDER / ("rod.toml" if name == "rod" else "bracket.toml")
        path.write_text(text, encoding="utf-8")
        out[name] = screwgen.load(path)
    return out


def main(arguments: Sequence[str] = ()) -> int:
    """Make, reduce, compare and draw; `--quick` leaves the figure out."""
    solid = Solid()
    arms = robots(solid)
    exact, shapes = solid.frequencies(PAYLOAD)
    found = {name: mode_shapes(screwgen.derive(robot)).frequencies[:LOWEST] for name, robot in arms.items()}
    screwgen.write_sid(arms[f"{COUNTS[-1]} modes"].links[0], FOLDER / "boom.SID_FEM")
    print(f"{len(solid.nodes)} nodes, base clamped, {PAYLOAD:g} kg at the bracket; natural frequencies in Hz")
    print(f"{'finite elements':>16}" + "".join(f"{f:10.3f}" for f in exact))
    for name, values in found.items():
        print(f"{name:>16}" + "".join(f"{f:10.3f}" for f in values))
    if "--quick" not in arguments:
        (FOLDER / "bracket.png").write_bytes(png(draw(solid, exact, shapes, found)))
        print(FOLDER / "bracket.png")
    return 0


@styled
def draw(solid: Solid, exact: np.ndarray, shapes: np.ndarray, found: dict[str, np.ndarray]) -> Figure:
    """Two modes of the solid, and the errors of the reduced body and of the rod."""
    out = canvas(11.5, 4.6, f"A boom of {len(solid.nodes)} nodes and {PAYLOAD:g} kg, reduced to a few coordinates")
    grid = out.add_gridspec(1, 3, width_ratios=(1, 1, 1.1))
    for k, place in ((0, grid[0]), (2, grid[1])):
        axes = out.add_subplot(place, projection="3d")
        surface(axes, solid, shapes[..., k], PALETTE[0])
        axes.set_title(f"mode {k + 1}: {exact[k]:.1f} Hz")
    axes = out.add_subplot(grid[2])
    for shade, (name, values) in zip(PALETTE, found.items(), strict=False):
        label = "rod with rigid bracket" if name == "rod" else f"static shapes and {name}"
        style = dict(color=INK, linestyle="--") if name == "rod" else dict(color=shade)
        number = np.arange(1, LOWEST + 1)[: len(values)]
        axes.semilogy(
            number,
            np.maximum(abs(values / exact[: len(values)] - 1), 1e-12),
            label=label,
            marker="o",
            markersize=4,
            **style,
        )
    axes.set(xlabel="natural frequency, number", title="error against the finite elements")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2)
    return out


def surface(axes, solid: Solid, mode: np.ndarray, color: str) -> None:
    """The outer faces of the elements, displaced by a mode."""
    mesh, points = solid.mesh, solid.mesh.p.T
    corners = [int(np.argmin(np.sum((solid.nodes - p) ** 2, axis=1))) for p in points]
    largest = mode[corners].ravel()[np.abs(mode[corners]).argmax()]
    moved = points + 0.08 * mode[corners] / largest
    faces = mesh.facets[:, mesh.boundary_facets()].T
    shown = Poly3DCollection(moved[around(points, faces)], facecolor=color, edgecolor="white", lw=0.3)
    axes.add_collection3d(shown)
    low, high = moved.min(axis=0), moved.max(axis=0)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axes.set_axis_off()
    axes.set_box_aspect(high - low, zoom=0.85)
    axes.view_init(elev=22, azim=-58)


def around(points: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The corners of every face in an order that goes around it."""
    middle = points[faces].mean(axis=1, keepdims=True)
    out = []
    for face, arms in zip(faces, points[faces] - middle, strict=True):
        u, v = np.linalg.svd(arms)[2][:2]
        out.append(face[np.argsort(np.arctan2(arms @ v, arms @ u))])
    return np.array(out)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
