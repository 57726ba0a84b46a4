"""The joints of a sketch: their solids, their axes with the sense of a turn, and the ground on which they stand."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...spec.parameters import added, changes
from ...topology.chain import Chain
from ...topology.tree import BASE
from . import coordinate_symbols
from .sketch_pen import Pen
from .sketch_pose import LinkShape

RADIUS, HALF = 6.0, 9.0
"""px: the radius and half the length of the cylinder of a hinge."""
SIDE = 5.0
"""px: half the side of what slides."""
BEHIND, AHEAD, ARC = 17.0, 42.0, 29.0
"""px: where the arrow of an axis begins behind its joint, where it ends, and where the arc about it is."""
ROUND = 8.5
"""px: the radius of that arc."""
SWEPT = 1.5 * np.pi
GROUND, HATCH = 30.0, 6.0
"""px: the width of the mark of the ground, and the length of its hatching."""
STEM = 13.0
"""px: from a joint to the ground."""


def names(chain: Chain) -> list[str]:
    """The names of the coordinates along v."""
    return list(changes(chain.robot))


def joint(pen: Pen, chain: Chain, part: LinkShape, along: Sequence[str]) -> None:
    """A joint with its axes and their coordinates, of the :func:`names` along v."""
    i, key = part.number, chain.keys[part.number]
    rates = along[chain.v_offset[i] : chain.v_offset[i + 1]]
    if key.screws or not rates:
        _axes(pen, chain, part, rates)
        return
    if key.floats:
        how = "moves" if key.joint.given else "floats"
        text = rf"{how}: $\mathbf{{r}}_{{o1}}, \mathbf{{Q}}_1$"
        pen.wish("q", text, part.joint, names=tuple(rates), towards=(1.0, -1.0))
        return
    pen.ball(part.joint, RADIUS)
    pen.ring("joint", part.joint, RADIUS + 3.0)
    for axis in part.axes:
        _turn(pen, part.joint, axis)
    pen.wish("q", rf"$\mathbf{{q}}_{{{i + 1}}}$", part.joint, names=tuple(rates), towards=(-1.0, 1.0))


def _axes(pen: Pen, chain: Chain, part: LinkShape, rates: Sequence[str]) -> None:
    """A joint of hinges, slides and screws, or a weld."""
    screws = chain.keys[part.number].screws
    turning = [axis for screw, axis in zip(screws, part.axes, strict=True) if screw.turn]
    sliding = [axis for screw, axis in zip(screws, part.axes, strict=True) if not screw.turn]
    if sliding:
        pen.box(part.joint, sliding[-1], HALF + 1.0, SIDE)
    elif len(turning) == 1:
        pen.cylinder(part.joint, turning[0], RADIUS, HALF)
    elif turning:
        pen.ball(part.joint, RADIUS + 1.0)
    known, rotors = coordinate_symbols.axes(chain), coordinate_symbols.rotors(chain)
    titles = dict(zip(chain.added_joints, _added(chain), strict=True))
    for k, (screw, axis) in enumerate(zip(screws, part.axes, strict=True)):
        if screw.turn:
            _turn(pen, part.joint, axis)
        if screw.slides:
            _slide(pen, part, axis, screw.turn)
        number, way = chain.tau_offset[part.number] + k, pen.flat(axis)
        text = ", ".join(filter(None, (known[number], rotors.get(number))))
        own = tuple(filter(None, (rates[k], titles.get(number))))
        towards = (float(way[0]), float(way[1]))
        pen.wish("q", f"${text}$", pen.along(part.joint, axis, AHEAD), names=own, towards=towards)


def _added(chain: Chain) -> list[str]:
    return [f"{link.name}.{one.name}[{j}]" for link, j, one in added(chain.robot)]


def _turn(pen: Pen, place: np.ndarray, axis: np.ndarray) -> None:
    """An axis with its direction, and the sense of a turn about it."""
    pen.line("axis", pen.along(place, axis, -BEHIND), pen.along(place, axis, AHEAD), head=True)
    arc = pen.circle(pen.along(place, axis, ARC), axis, ROUND, SWEPT, np.pi / 6)
    pen.line("axis", *arc, head=True)


def _slide(pen: Pen, part: LinkShape, axis: np.ndarray, turns: bool) -> None:
    """The rail along which a joint slides, and its direction."""
    ends = sorted(float((p - part.mount) @ axis) for p in (part.mount, part.joint))
    rail = [part.mount + s * axis for s in ends]
    pen.line("offset", pen.along(rail[0], axis, -2 * BEHIND), pen.along(rail[1], axis, BEHIND))
    first = part.joint if turns else pen.along(part.joint, axis, BEHIND)
    pen.line("axis", first, pen.along(part.joint, axis, AHEAD - 5.0 * turns), head=True)


# ------------------------------------------------------------------------------------------- the base


def foot(pen: Pen, part: LinkShape, hangs: bool, welded: bool) -> None:
    """The mark of the ground below a joint on the world, above it where the robot hangs."""
    way = np.array([0.0, 1.0 if hangs else -1.0])
    place = np.array(pen.point(part.mount))
    first = place + (3.0 if welded else STEM) * way
    side = np.array([1.0, 0.0])
    if not welded:
        pen.drawn("offset", [place, first])
    pen.drawn("ground", [first - GROUND / 2 * side, first + GROUND / 2 * side])
    for k in range(6):
        top = first + (GROUND / 5 * k - GROUND / 2) * side
        pen.drawn("ground", [top, top + HATCH * (way - 0.8 * side)])


def on_world(chain: Chain, part: LinkShape) -> bool:
    """Whether a link's joint stands on the world."""
    return chain.tree.parents[part.number] == BASE and not chain.keys[part.number].floats
