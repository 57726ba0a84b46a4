"""Regularity of the assembled system: rank and condition number of M_sys, and the structure of its blocks.

The paper shows M_sys invertible from a positive definite differential-modal block, (Msys_diff), and rows of the joints
that are independent of it. Both can fail: the block is only semidefinite where a link has no inertia about its own
axis (E29), and the projectors P alone leave one zero singular value per joint axis (E17). So both are computed.
SI mixes newtons and radians; numbers that depend on it are also given after equilibration: rows and columns scaled
to length 1, symmetric blocks to a diagonal of 1.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...algorithms import fused
from ...algorithms.dae_functions import block_places, edge_places, unknown_size
from ...algorithms.station_names import plain
from ...ir.block import Binding
from ...ir.lower import lower
from ...ir.program import Tracer
from ...robot_model import RobotModel
from ...simulation.mobility import jacobian
from ...topology.tree import BASE

EPSILON = float(np.finfo(float).eps)
ROUNDING = 64
"""How many ε the entries themselves may be off: a joint of nearly dependent axes costs some digits."""
SWEEPS = 10
DIRECTIONS = ("omega_x", "omega_y", "omega_z", "v_x", "v_y", "v_z")
PURE = 1e-6
"""Components of a null direction below this, relative to the largest, are none."""


@dataclass(frozen=True)
class Regularity:
    """A square matrix in numbers: `condition` and `smallest` singular value in SI, and after equilibration.

    `rank`: singular values of the equilibrated matrix above `64 size ε` times the largest.
    """

    size: int
    rank: int
    condition: float
    smallest: float
    condition_scaled: float
    smallest_scaled: float

    @property
    def regular(self) -> bool:
        return self.rank == self.size


@dataclass(frozen=True)
class LinkRegularity:
    """The differential-modal block of a link, (Msys_diff): rows and columns of V̇_i and η̈_i.

    `smallest`, `largest`: its eigenvalues in SI, `_scaled`: after equilibration; `definite`: positive definite, else
    only semidefinite; `null`: its null direction in words, "" if there is none; `asymmetry`: the largest entry of
    M − Mᵀ over the largest of M; `rank_M_star`: the rank of (27), base bodies included.
    """

    link: str
    smallest: float
    largest: float
    smallest_scaled: float
    largest_scaled: float
    definite: bool
    null: str
    asymmetry: float
    rank_M_star: int


@dataclass(frozen=True)
class Structure:
    """The entries of M_sys that are not structurally zero, in the paper's order of rows and columns.

    `rows`, `columns` (nonzeros,): their places; `kinds` (nonzeros,): of which block each is; `block_bandwidth`: how
    many blocks of six the wrench and twist part, (68), reaches from its diagonal; `bandwidth`: how many entries;
    `labels`, `starts`: names and first rows of the blocks w_1, V̇_1, …, η̈_1, …
    """

    size: int
    rows: np.ndarray
    columns: np.ndarray
    kinds: tuple[str, ...]
    block_bandwidth: int
    bandwidth: int
    labels: tuple[str, ...]
    starts: tuple[int, ...]

    @property
    def nonzeros(self) -> int:
        return len(self.rows)

    @property
    def fill(self) -> float:
        """The share of the entries that are not zero."""
        return self.nonzeros / self.size**2


# ------------------------------------------------------------------------------ the whole


def regularity(M: np.ndarray, like: np.ndarray | None = None) -> Regularity:
    """Rank, condition and smallest singular value of a square matrix (size, size).

    `like`: the matrix by whose scales it is equilibrated, if not its own: rows of mere rounding stay small.
    """
    rows, columns = scales(M if like is None else like)
    plain, scaled = singular_values(M), singular_values(rows[:, None] * M * columns)
    size = len(M)
    rank = int(np.sum(scaled > ROUNDING * size * EPSILON * scaled.max(initial=0.0)))
    return Regularity(size, rank, ratio(plain), float(plain[-1]), ratio(scaled), float(scaled[-1]))


def loops_of(model: RobotModel, q: np.ndarray) -> Regularity | None:
    """That of `J M⁻¹ Jᵀ` of the loops' rows, which must be regular for their forces to be unique, at `q` (nq,).

    None without rows.
    """
    J = jacobian(model, q, model.parameter_values)
    if not len(J):
        return None
    return regularity(J @ np.linalg.solve(model.numpy().mass_matrix(q), J.T))


def singular_values(M: np.ndarray) -> np.ndarray:
    return np.linalg.svd(M, compute_uv=False)


def ratio(values: np.ndarray) -> float:
    """The largest over the smallest of descending singular values."""
    return float(values[0] / values[-1]) if values[-1] > 0 else np.inf


def scales(M: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Factors (size,) of rows and of columns that bring all of them to about length 1.

    Some sweeps of Sinkhorn and Knopp, not to the end, which need not exist for a matrix with
    zeros. The units of the rows have no effect.
    """
    square = np.abs(M) ** 2
    rows, columns = np.ones(len(M)), np.ones(len(M))
    for _ in range(SWEEPS):
        rows = 1 / _positive(square @ columns)
        columns = 1 / _positive(square.T @ rows)
    return np.sqrt(rows), np.sqrt(columns)


def _positive(x: np.ndarray) -> np.ndarray:
    return np.where(x > 0, x, 1.0)


def with_projectors_alone(model: RobotModel, M: np.ndarray) -> np.ndarray:
    """M_sys with the joints' rows as the paper has them, `P` (compatibility), without the motors' (E17).

    The columns of the wrench hold I − P in the completed rows, up to rounding, and P takes away what completed them.
    """
    out = M.copy()
    for i in range(model.n_links):
        rows = slice(12 * i, 12 * i + 6)
        shares, directions = np.linalg.eigh((M[rows, rows] + M[rows, rows].T) / 2)
        axes = directions[:, shares > 0.5]
        out[rows] -= axes @ (axes.T @ M[rows])
    return out


# ------------------------------------------------------------------------------ the differential-modal block


def link_blocks(model: RobotModel, M: np.ndarray) -> list[LinkRegularity]:
    """The differential-modal block of every link; the arm's is their direct sum."""
    return [_link_block(model, M, i) for i in range(model.n_links)]


def _link_block(model: RobotModel, M: np.ndarray, i: int) -> LinkRegularity:
    chain = model.chain
    modal = 12 * chain.n + chain.eta_offset[i]
    places = [*range(12 * i + 6, 12 * i + 12), *range(modal, modal + chain.keys[i].modes)]
    block = M[np.ix_(places, places)]
    size = float(np.abs(block).max())
    symmetric = (block + block.T) / 2
    plain = np.linalg.eigvalsh(symmetric)
    root = np.sqrt(_positive(np.diag(symmetric)))
    scaled, vectors = np.linalg.eigh(symmetric / np.outer(root, root))
    definite = bool(scaled[0] > len(places) * EPSILON * scaled[-1])
    name, loose = chain.names[i], ""
    if not definite:
        names = [model.dae_names["z"][k] for k in places]
        loose = null_direction(name, vectors[:, 0] / root, names) if size else f"{name}: has no mass"
    return LinkRegularity(
        name,
        float(plain[0]),
        float(plain[-1]),
        float(scaled[0]),
        float(scaled[-1]),
        definite,
        loose,
        float(np.abs(block - block.T).max() / (size or 1.0)),
        rank_M_star(model, i),
    )


def null_direction(link: str, direction: np.ndarray, names: list[str]) -> str:
    """In words, a motion (of V̇_i and η̈_i) that meets no inertia."""
    size = np.abs(direction) / np.abs(direction).max()
    rigid = size[:6] / size[:6].max(initial=PURE)
    if size[:6].max() > PURE and (rigid[1:] < PURE).all():
        along = ", its modes giving way," if (size[6:] > PURE).any() else ""
        return f"{link}: turning about its own axis{along} has no inertia; give rhoIp or a body with inertia"
    largest = [names[k] for k in np.argsort(-size, kind="stable")[:3] if size[k] > PURE]
    return f"{link}: a motion of {', '.join(largest)} has no inertia"


def rank_M_star(model: RobotModel, i: int) -> int:
    """The rank of `M*_i`, (27), the undeformed inertia of link `i` with its base bodies."""
    block, places = model.blocks(i)["link"], model.chain.parameter_labels[i]
    given = {
        name: np.array([model.parameter_values[places[symbol.name]] for symbol in block.values[name].flat], object)
        for name, signal in block.inputs.items()
        if signal.binding == Binding.PARAMETER
    }
    entries = lower(block, given, ("M_star",), Tracer())["M_star"]
    M_star = np.asarray(entries).astype(float).reshape(6, 6)
    root = np.sqrt(_positive(np.diag(M_star)))
    return int(np.linalg.matrix_rank(M_star / np.outer(root, root)))


# ------------------------------------------------------------------------------ the structure

KINDS = {
    "joint": ("joint_w", "joint_V", "next_V", "next_eta"),
    "inertia": ("V_V", "eta_eta"),
    "wrench": ("V_w", "V_next", "eta_next"),
    "coupling": ("V_eta", "eta_V"),
}
"""Kinds of blocks: rows of the joints, inertia, wrenches in the rows of links and modes, twist against modes."""


def structure(model: RobotModel) -> Structure:
    """The structure of M_sys, the same in all states."""
    chain, n = model.chain, model.n_links
    size, places = unknown_size(chain), sorted(fused.assembly(chain)[1])
    rows, columns = np.array(places, int).T
    kinds = np.full((size, size), "", dtype="<U8")
    named = {name: kind for kind, names in KINDS.items() for name in names}
    for i in range(n):
        blocks = block_places(chain, i) | (edge_places(chain, i) if chain.tree.parents[i] != BASE else {})
        for name, (row, column, height, width) in blocks.items():
            kinds[row : row + height, column : column + width] = named[plain(name)]
    core = (rows < 12 * n) & (columns < 12 * n)
    across = np.abs(rows // 6 - columns // 6)[core]
    labels = [name for i in range(1, n + 1) for name in (f"w_{i}", f"V_{i}")]
    bent = [i for i in range(n) if chain.keys[i].modes]
    return Structure(
        size,
        rows,
        columns,
        tuple(str(x) for x in kinds[rows, columns]),
        int(across.max()),
        int(np.abs(rows - columns)[core].max()),
        (*labels, *(f"eta_{i + 1}" for i in bent)),
        (*range(0, 12 * n, 6), *(12 * n + chain.eta_offset[i] for i in bent)),
    )
