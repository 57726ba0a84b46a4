"""The coordinates, inputs and wrenches of a robot in their order, with their symbols and what they mean."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ...spec.parameters import coordinate_names, coordinate_units, rate_units
from ...topology.chain import Chain
from . import inputs
from .content import DocumentTable, Heading, Item, Paragraph
from .forces import TURNED
from .tables import DIRECTION, NONE, axis_text, plain_unit, span

ROWS = 60
"""Of more modes than that the table has one row for those of a link in one direction."""

ABOUT = (
    r"The entries of $\mathbf{q}$ and of the rates $\mathbf{v}$ in their order, as all functions of the tool take "
    r"and give them. $\mathbf{q}_i$, $\dot{\mathbf{q}}_i$ and $\boldsymbol{\eta}_i$ are those of the joint and of the "
    r"modes of link $i$; in the section of a class their entries are numbered within the link."
)
INTERNAL = (
    r" Behind the rates $\mathbf{v}$ holds internal states, which forces remember of the motion. They are of first "
    r"order and move no coordinate; in the equation of motion $\mathbf{v}$ is the rates alone."
)
BALL = (
    r" Those of $\mathbf{q}_i$ of a ball joint are its quaternion, those of $\dot{\mathbf{q}}_i$ its angular velocity."
)
INPUTS = (
    r"The entries of the inputs $\mathbf{u}$ in their order. Besides, an external wrench "
    r"$\boldsymbol{\mathcal{W}}_{ext,i}$ may act on the tip section of each link, its moment first, in components of "
    r"the tip frame. The joint wrenches $\mathbf{w}_i$ come link by link, the moment first."
)

GIVEN = (
    r" Of axes whose motion is given the input is the acceleration; their rows of the equation of motion then say what "
    r"their drives exert."
)


def tables(chain: Chain) -> Iterator[Item]:
    """The table of the coordinates, and that of the inputs."""
    yield Heading("Coordinates and inputs")
    sizes = zip(np.diff(chain.q_offset), np.diff(chain.v_offset), chain.keys, strict=True)
    balls = any(nq != nv and not key.floats for nq, nv, key in sizes)
    yield Paragraph(ABOUT + BALL * balls + INTERNAL * bool(chain.n_internal), essential=True)
    yield _table(("in $\\mathbf{q}$", "in $\\mathbf{v}$", "symbol", "name", "meaning", "unit"), coordinates(chain))
    said = INPUTS + GIVEN * bool(chain.prescribed) + TURNED * bool(chain.turned_wrenches)
    yield Paragraph(said, essential=True)
    rows = inputs.lines(chain)
    if rows:
        yield DocumentTable(
            ("in $\\mathbf{u}$", "symbol", "name", "acts on", "unit"), (0.08, 0.1, 0.3, 0.42, 0.1), rows
        )


def _table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> DocumentTable:
    return DocumentTable(head, (0.09, 0.09, 0.1, 0.27, 0.35, 0.1), tuple(rows))


def coordinates(chain: Chain) -> list[tuple[str, ...]]:
    """One row for each coordinate; a pose, and the turn of a ball joint, have one for all of theirs."""
    out: list[tuple[str, ...]] = []
    names, units = coordinate_names(chain.robot), coordinate_units(chain.robot)
    for i, key in enumerate(chain.keys):
        at_q, at_v = chain.q_offset[i], chain.v_offset[i]
        size = (chain.q_offset[i + 1] - at_q, chain.v_offset[i + 1] - at_v)
        if not any(size):
            continue
        if key.floats:
            out += _floating(at_q, at_v)
        elif size[0] != size[1]:
            about = (
                f"unit quaternion (w, x, y, z) of link {i + 1} in the axes of the joint's mount; in $\\mathbf{{v}}$ "
            )
            about += f"its angular velocity relative to these, in axes of $\\mathcal{{F}}_{i + 1}$"
            name = names.q[at_q].rpartition(".")[0]
            places = (span(at_q, size[0]), span(at_v, size[1]))
            out.append((*places, rf"$\mathbf{{q}}_{i + 1}$", f"`{name}`", about, r"1; $\mathrm{rad/s}$"))
        else:
            for k, screw in enumerate(key.screws):
                number = chain.tau_offset[i] + k + 1
                motion = f"turn of link {i + 1} about" if screw.turn else f"travel of link {i + 1} along"
                about = f"{motion} {axis_text(screw)}"
                cells = (f"{at_q + k + 1}", f"{at_v + k + 1}", f"$q_{{{number}}}$", f"`{names.q[at_q + k]}`")
                out.append((*cells, about, plain_unit(units[at_q + k])))
    out += _added(chain, names.q, units)
    return out + _modes(chain, names.q, units) + list(_internal(chain, names.v))


def _floating(at_q: int, at_v: int) -> Iterator[tuple[str, ...]]:
    yield (
        span(at_q, 3),
        span(at_v + 3, 3),
        r"$\mathbf{r}_{o1}$",
        "`base.x` …",
        (r"place of $\mathcal{F}_1$, inertial axes; in $\mathbf{v}$ its velocity $\mathbf{v}_1$ in its own"),
        plain_unit("m"),
    )
    yield (
        span(at_q + 3, 4),
        span(at_v, 3),
        r"$\mathbf{Q}_1$",
        "`base.qw` …",
        (
            r"unit quaternion (w, x, y, z) of $\mathcal{F}_1$; in $\mathbf{v}$ its angular velocity "
            r"$\boldsymbol{\omega}_1$ in its own axes"
        ),
        "1",
    )


def _added(chain: Chain, names: Sequence[str], units: Sequence[str]) -> Iterator[tuple[str, ...]]:
    first_q, first_v = chain.eta_q - chain.n_added, chain.eta_v - chain.n_added
    for k in range(chain.n_added):
        travel = chain.added_joints[k] in chain.elastic_travels
        about = "travel by which the rotor is ahead of its transmission" if travel else "angle of the rotor"
        letter = "e" if travel else r"\vartheta"
        joint = chain.added_joints[k] + 1
        cells = (f"{first_q + k + 1}", f"{first_v + k + 1}", rf"${letter}_{{{joint}}}$", f"`{names[first_q + k]}`")
        yield (*cells, f"{about}, of the drive of $q_{{{joint}}}$", plain_unit(units[first_q + k]))


def _modes(chain: Chain, names: Sequence[str], units: Sequence[str]) -> list[tuple[str, ...]]:
    out: list[tuple[str, ...]] = []
    for i, key in enumerate(chain.keys):
        at_q, at_v = (first + chain.eta_offset[i] for first in (chain.eta_q, chain.eta_v))
        for k, direction, number, count in _groups(key.directions, chain.n_modes > ROWS):
            cells = (span(at_q + k, count), span(at_v + k, count))
            symbol = rf"$\eta_{{{i + 1},{k + 1}}}$" + (rf" … $\eta_{{{i + 1},{k + count}}}$" if count > 1 else "")
            which = f"mode {number}" if count == 1 else f"modes {number}–{number + count - 1}"
            about = f"link {i + 1}, {DIRECTION.get(direction, direction)}, {which}"
            out.append(
                (*cells, symbol, f"`{names[at_q + k]}`" + " …" * (count > 1), about, plain_unit(units[at_q + k]))
            )
    return out


def _internal(chain: Chain, names: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """The internal states, which stand in ``v`` alone."""
    units = rate_units(chain.robot)
    own = [(i, one) for i, key in enumerate(chain.keys) for one in key.internal]
    for k, (i, (law, part, place, *_)) in enumerate(own, chain.nv):
        assert law.state is not None
        rotors = part == "theta"
        joint = chain.added_joints[chain.theta_offset[i] + place] if rotors else chain.tau_offset[i] + place
        of = f"{'of the rotor of the drive ' * rotors}of $q_{{{joint + 1}}}$"
        symbol = rf"${law.state.symbol}_{{{joint + 1}}}$"
        yield NONE, f"{k + 1}", symbol, f"`{names[k]}`", f"{law.state.meaning}, {of}", plain_unit(units[k])
    kept = ((force.name, state) for force in chain.forces for state in force.shape.states.values())
    for k, (force, state) in enumerate(kept, chain.force_states.start):
        about = f"`{force}`: {state.meaning}"
        yield NONE, f"{k + 1}", f"${state.symbol}$", f"`{names[k]}`", about, plain_unit(units[k])
    axes = ((i, one) for i, key in enumerate(chain.keys) for one in key.remembering)
    held = ((chain.tau_offset[i] + one.axis + 1, one.kind.state) for i, one in axes)
    for k, (joint, own_state) in enumerate(held, chain.held_states.start):
        assert own_state is not None
        symbol, about = rf"${own_state.symbol}_{{{joint}}}$", f"{own_state.meaning}, of $q_{{{joint}}}$"
        yield NONE, f"{k + 1}", symbol, f"`{names[k]}`", about, plain_unit(units[k])


def _groups(directions: Sequence[tuple[str, int]], grouped: bool) -> Iterator[tuple[int, str, int, int]]:
    """Place, direction, number of the first mode and count of the modes that share a row."""
    start = 0
    while start < len(directions):
        direction, number = directions[start]
        count = sum(d == direction for d, _ in directions[start:]) if grouped else 1
        yield start, direction, number + 1, count
        start += count
