"""What a robot has beside its links, with all numbers: transmissions, tendons, forces, and what closes the tree."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ...elements import FourBarLinkage
from ...joints.constraints import Angle, Distance
from ...spec.inputs import efforts
from ...spec.parameters import coordinate_names, per_axis
from ...topology.chain import Chain
from ...topology.loops import ClosingRow
from .content import DocumentTable, Heading, Item, Paragraph
from .force_tables import ACTING, PUSHED, forces, pushes
from .tables import NONE, axis_text, exact, vector

Rows = Iterable[Sequence[str]]


def besides(chain: Chain) -> Iterator[Item]:
    """The tables of what the robot has."""
    tables: list[tuple[str, str, DocumentTable | None]] = [
        ("Transmissions", TRANSMITTED + ASSEMBLED * _linked(chain), transmissions(chain)),
        ("Tendons", PULLED, tendons(chain)),
        ("Forces between frames", ACTING, forces(chain)),
        ("Wrenches from outside", PUSHED, pushes(chain)),
        ("What loops join", JOINED, loops(chain)),
        ("Couplings", COUPLED, couplings(chain)),
        ("Rows that close the loops", CLOSED, rows(chain)),
    ]
    for title, about, table in tables:
        if table is not None:
            yield from (Heading(title), Paragraph(about), table)


TRANSMITTED = (
    "The drives that act on their axes through a transmission; their lengths and angles are among the parameters."
)
ASSEMBLED = (
    r" The sign $\sigma$ says how a linkage is assembled: 1 where the crank's pin is left of the line from its pivot "
    "to the rocker's pin, else $-1$."
)
PULLED = (
    r"Each piece of a tendon runs from $s_0$ to $s_1$ along its link, at the offsets $\mathbf{d}_a$ and $\mathbf{d}_b$ "
    r"from the centreline there, in axes of the section. Pieces with the same tension $T_c$ belong to one tendon."
)
JOINED = (
    "A loop joins the tip frames A and B of two links by a joint, whose axes are those of A; what the joint leaves "
    r"free is not a coordinate. Gaps close at the rate $c_s$."
)
COUPLED = r"An axis follows another, $q_b = r\,q_a + c$; a gap closes at the rate $c_s$."
CLOSED = (
    r"The conditions that bear a force $\lambda_j$ each. Directions $\mathbf{n}$ and $\mathbf{x}$ of loops are in axes "
    r"of A, $\mathbf{y}$ in axes of B. Conditions that the robot fulfils in every posture, as those across the plane "
    "of a planar arm, bear none."
)


def _table(head: Sequence[str], widths: Sequence[float], rows: Rows) -> DocumentTable | None:
    found = tuple(tuple(cell or NONE for cell in row) for row in rows)
    return DocumentTable(tuple(head), tuple(widths), found) if found else None


def transmissions(chain: Chain) -> DocumentTable | None:
    """Which axis has which transmission, and how a linkage is assembled."""
    columns = 3 + _linked(chain)
    head, widths = ("axis", "input", "transmission", r"$\sigma$")[:columns], (0.3, 0.3, 0.3, 0.1)[:columns]
    names, inputs = per_axis(chain.robot, "joint", "slide"), coordinate_names(chain.robot).tau
    out = []
    for k, (link, axis, *_) in enumerate(efforts(chain.robot)):
        if (kind := link.joint.driven[axis].travel) is not None:
            side = f"${kind.side}$" if isinstance(kind, FourBarLinkage) else ""
            out.append((f"$q_{{{k + 1}}}$, `{names[k]}`", f"`{inputs[k]}`", kind.WORD, side)[:columns])
    return _table(head, widths, out)


def _linked(chain: Chain) -> bool:
    return any(isinstance(kind, FourBarLinkage) for kind in chain.travels.values())


def tendons(chain: Chain) -> DocumentTable | None:
    """The pieces of tendons along the links."""
    head = ("tension", "input", "link", r"$s_0$", r"$s_1$", r"$\mathbf{d}_a$, m", r"$\mathbf{d}_b$, m")
    inputs, out = coordinate_names(chain.robot).tau[chain.n_joints :], []
    names = [name.rpartition(".")[0] for name in inputs]
    for link in chain.robot.links:
        for own in link.tendons:
            if own.actuated:
                k = names.index(own.name)
                offsets = (vector((0.0, *own.offset(end))) for end in range(2))
                out.append(
                    (f"$T_{{{k + 1}}}$", f"`{inputs[k]}`", f"`{link.name}`", exact(own.start), exact(own.to), *offsets)
                )
    return _table(head, (0.09, 0.19, 0.14, 0.09, 0.09, 0.2, 0.2), out)


def loops(chain: Chain) -> DocumentTable | None:
    """Which tips the loops join, and what their joints leave free."""
    head, widths = ("loop", "A", "B", "joint leaves free", r"$c_s$, $1/\mathrm{s}$"), (0.1, 0.25, 0.25, 0.25, 0.15)
    out = []
    for loop, junction in zip(chain.robot.rigid_loops.values(), chain.closing.junctions, strict=False):
        numbers = (junction.first + 1, junction.second + 1)
        ends = (f"`{end}`, link {number}" for end, number in zip(loop.between, numbers, strict=True))
        free = ", ".join(map(axis_text, loop.joint.screws)) or "nothing, welded"
        out.append((f"`{junction.name}`", *ends, free, exact(loop.stabilisation)))
    return _table(head, widths, out)


def couplings(chain: Chain) -> DocumentTable | None:
    """Which axis follows which."""
    head = ("coupling", r"$q_b$ follows", r"$q_a$", r"$r$", r"$c$", r"$c_s$, $1/\mathrm{s}$")
    names, out = per_axis(chain.robot, "joint", "slide"), []
    for k, coupling in enumerate(chain.robot.couplings):
        axes = (f"$q_{{{names.index(name) + 1}}}$, `{name}`" for name in (coupling.axis, coupling.of))
        relation = f", through {coupling.relation.words}" if coupling.relation is not None else ""
        ratio = exact(coupling.ratio) + relation
        out.append((f"`coupling[{k}]`", *axes, ratio, exact(coupling.offset), exact(coupling.stabilisation)))
    return _table(head, (0.15, 0.24, 0.24, 0.14, 0.12, 0.11), out)


def rows(chain: Chain) -> DocumentTable | None:
    """The rows that bear forces."""
    head, widths = ("force", "of", "gap"), (0.1, 0.18, 0.72)
    return _table(
        head, widths, [(rf"$\lambda_{{{k}}}$", f"`{c.name}`", _gap(c)) for k, c in enumerate(chain.closing.rows, 1)]
    )


def _gap(closing: ClosingRow) -> str:
    row = closing.row
    if isinstance(row, Distance):
        return rf"distance along $\mathbf{{n}} =$ {vector(row.normal)}"
    if isinstance(row, Angle):
        first, second = vector(row.first), vector(row.second)
        return rf"angle between $\mathbf{{x}} =$ {first} and $\mathbf{{y}} =$ {second}, $c =$ {exact(row.cosine)}"
    return r"$q_b - r\,q_a - c$ of the coupling"
