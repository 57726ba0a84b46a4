"""The tables of a document: links, mode constants, parameters, symbols."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import sympy as sp

from ...algebra.notation import number
from ...bases import Basis, Shapes
from ...ir.block import Binding
from ...joints.screw import Screw
from ...spec.link_class import LinkClass
from ...spec.modes import DIRECTIONS
from ...spec.parameters import Parameter
from ...spec.parents import WORLD
from ...spec.robot import Link
from ...topology.chain import Chain
from ...topology.tree import BASE, TIP
from . import elements, forces
from .content import DocumentTable
from .symbols import Entry

DIRECTION = {direction: direction.replace("_", " in ") for direction in DIRECTIONS}
KNOWN: dict[Binding | None, str] = {Binding.CONSTANT: "always", Binding.PARAMETER: "parameters", Binding.STATE: "state"}

NONE = "–"
"""The content of an empty cell."""


def decimal(value: float) -> str:
    """A number as a formula."""
    return f"${number(sp.Float(value) if value != int(value) or abs(value) > 1e6 else sp.Integer(int(value)))}$"


def exact(value: float) -> str:
    """A number with all its digits, as a formula."""
    mantissa, _, exponent = repr(float(value)).removesuffix(".0").partition("e")
    power = rf"\times 10^{{{int(exponent)}}}" if exponent else ""
    return f"${mantissa}{power}$"


def vector(values: Sequence[float]) -> str:
    """A vector with all its digits, which may be broken behind commas; a unit vector along an axis by its letter."""
    for letter, axis in zip("xyz", np.eye(3), strict=True):
        if tuple(axis) == tuple(values):
            return rf"$\mathbf{{e}}_{letter}$"
    first, *between, last = (exact(x).strip("$") for x in values)
    return " ".join([f"$[{first},$", *(f"${x},$" for x in between), rf"${last}]^{{\top}}$"])


def links(chain: Chain) -> DocumentTable:
    """One row per link: its class, joint, shapes and bodies; one per marker at which something acts."""
    robot, keys, classes = chain.robot, chain.keys, chain.classes
    kinds = "x, y, z, torsion" + ", shear" * any(len(key.counts) > 4 for key in keys)
    head = ("link", "name", "class", "length", "joint axes", f"modes: {kinds}", "bodies, remarks")
    rows, pieces = [], chain.segments
    for link, first in zip(robot.links, chain.firsts, strict=True):
        own = keys[first : first + link.pieces]
        numbers = dict.fromkeys(f"{classes.index(key) + 1}" for key in own)
        place = f"{first + 1}" if len(own) == 1 else f"{first + 1}–{first + len(own)}"
        remarks = _remarks(chain, first) or NONE
        rows.append((place, f"`{link.name}`", ", ".join(numbers), *_link(link, own[0]), remarks))
        for i in range(first + link.pieces, len(pieces)):
            if pieces[i].first:
                break
            where = f"{forces.marker_remark(chain, i)}, {_carrier(chain, i)}"
            rows.append(
                (f"{i + 1}", f"`{pieces[i].name}`", f"{classes.index(keys[i]) + 1}", NONE, "welded", "rigid", where)
            )
    return DocumentTable(head, (0.06, 0.17, 0.07, 0.1, 0.2, 0.19, 0.21), tuple(rows))


def _link(link: Link, key: LinkClass) -> tuple[str, ...]:
    length = link.length if key.elastic is None else key.elastic.reach
    return f"{decimal(length)} m" if length is not None else NONE, _axes(key), _modes(key)


def named_axes(key: LinkClass) -> list[tuple[tuple[sp.Expr, ...], str]]:
    """The axes of a joint that are not a coordinate axis, with the names that the equations use."""
    exact = [tuple(sp.Integer(int(x)) if x == int(x) else sp.Float(x) for x in s.axis) for s in key.screws]
    return [(axis, rf"\mathbf{{a}}_{{{j}}}") for j, axis in enumerate(exact, 1) if sorted(axis) != [0, 0, 1]]


def _axes(key: LinkClass) -> str:
    return ", ".join(map(axis_text, key.screws)) or key.joint.name or "welded"


def axis_text(screw: Screw) -> str:
    """An axis of a joint in words."""
    axis = _axis(screw.axis)
    if not screw.slides:
        return axis
    return f"{axis}, {screw.travel:.6g} m/rad" if screw.turn else f"{axis}, sliding"


def _axis(axis: Sequence[float]) -> str:
    letters = [name for name, unit in zip("xyz", np.eye(3), strict=True) if tuple(unit) == tuple(axis)]
    return letters[0] if letters else f"({', '.join(f'{x:.6g}' for x in axis)})"


def _modes(key: LinkClass) -> str:
    if key.elastic is not None:
        return f"{key.modes}, from a file"
    counts = ", ".join(str(n) for n in key.counts)
    return f"{counts} `{'`, `'.join(dict.fromkeys(_basis(b) for b in key.bases if b))}`" if key.modes else "rigid"


def _basis(basis: str | Basis) -> str:
    return basis if isinstance(basis, str) else basis(1, 2).family.name


def _remarks(chain: Chain, i: int) -> str:
    link, key = chain.robot.links[chain.segments[i].link], chain.keys[i]
    split = [f"{link.pieces} segments"] if link.pieces > 1 else []
    bodies = [f"{decimal(body.mass)} kg at the {body.at}" for body in link.bodies]
    stated = {
        "mount": key.mount_xyz or key.mount_rpy,
        "armature": key.armature,
        **elements.remarks(key),
        "joint damping": key.joint_damping,
        "joint stiffness": key.stiffness,
        "modal damping": key.damping,
        "frame off the joint": key.frame_at,
        f"order {key.order}": key.modes and key.order != 1,
        "curved at rest": key.rest,
        "spin inertia": key.spin,
        "rotary inertia": key.rotary,
        "measured frequencies": key.measured,
    }
    bodies += [_carrier(chain, i)] if chain.tree.parents[i] != i - 1 or chain.tree.at(i) != TIP else []
    return "; ".join(split + bodies + [name for name, present in stated.items() if present])


def _carrier(chain: Chain, i: int) -> str:
    """What carries a link, and where if not at the tip: with segments that of one of them."""
    parent, station = chain.tree.parents[i], chain.tree.at(i)
    if parent == BASE:
        return f"on `{WORLD}`"
    place = "" if station == TIP else f" at $s =$ {exact(chain.keys[parent].stations_at[station])}"
    return f"on `{chain.names[parent]}`, link {parent + 1}{place}"


def stations(key: LinkClass) -> DocumentTable:
    """The values and slopes of the mode shapes at the sections where a link carries others, besides its tip."""
    head = ("shape", *(rf"${x}({s:.6g})$" for s in key.stations_at for x in (r"\psi", r"\psi'")))
    rows = []
    for k, (direction, i) in enumerate(key.directions):
        at = [key.shapes(direction).evaluate(key.stations_at, derivative)[i] for derivative in (0, 1)]
        rows.append((rf"$\varphi_{{{k + 1}}}$", *(decimal(x) for pair in zip(*at, strict=True) for x in pair)))
    return DocumentTable(head, (0.1, *[0.9 / (len(head) - 1)] * (len(head) - 1)), tuple(rows))


def modes(key: LinkClass) -> DocumentTable:
    """The constants of every mode shape, dimensionless."""
    head = (
        "shape",
        "direction",
        "no.",
        "eigenvalue",
        r"$\int\psi\,ds$",
        r"$\int s\,\psi\,ds$",
        r"$\int\psi^{(p)2}\,ds$",
        r"$\psi(1)$",
        r"$\psi'(1)$",
    )
    rows = (
        (rf"$\varphi_{{{k + 1}}}$", DIRECTION[direction], f"{i + 1}", *_constants(key.shapes(direction), i))
        for k, (direction, i) in enumerate(key.directions)
    )
    return DocumentTable(head, (0.07, 0.15, 0.06, 0.13, 0.12, 0.13, 0.13, 0.1, 0.11), tuple(rows))


def _constants(shapes: Shapes, i: int) -> Iterable[str]:
    columns = (shapes.eigenvalues, shapes.integral, shapes.moment, shapes.stiffness, shapes.tip_value, shapes.tip_slope)
    return (decimal(column[i]) for column in columns)


def parameters(items: Sequence[tuple[Parameter, str]]) -> DocumentTable:
    """The numbers of the robot file, each with the LaTeX of its symbol in the equations, if it has one."""
    rows = (
        (f"`{p.name}`", f"${symbol}$" if symbol else "not used", exact(p.value), plain_unit(p.unit), p.description)
        for p, symbol in items
    )
    head, widths = ("parameter", "symbol", "value", "unit", "meaning"), (0.23, 0.09, 0.245, 0.12, 0.315)
    return DocumentTable(head, widths, tuple(rows))


def span(first: int, count: int) -> str:
    """The numbers of entries in a row, from one, of which the first is counted from zero: 4–6 of three behind three."""
    return f"{first + 1}" if count == 1 else f"{first + 1}–{first + count}"


def plain_unit(text: str) -> str:
    """A unit in the spelling of the robot file, as a formula."""
    replaced = text.replace("·", r"\,").replace("²", "^{2}").replace("³", "^{3}")
    return rf"$\mathrm{{{replaced}}}$" if text not in ("", "1") else ""


def symbols(entries: Iterable[Entry]) -> DocumentTable:
    """Every symbol with its meaning and binding time."""
    head = ("symbol", "meaning", "unit", "frame", "shape", "follows from")
    rows = ((f"${e.display}$", e.meaning, e.unit, e.frame, e.shape, KNOWN.get(e.binding, "")) for e in entries)
    widths = (0.13, 0.31, 0.15, 0.12, 0.16, 0.13)
    return DocumentTable(head, widths, tuple(tuple(c or NONE for c in row) for row in rows))
