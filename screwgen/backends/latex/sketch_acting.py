"""What acts in a sketch: bodies, drives across joints, tendons, loops, couplings, wrenches on tips, and gravity."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...elements import FourBarLinkage
from ...elements.cylinder import Cylinder
from ...joints.constraints import Ratio
from ...spec.parameters import parameters
from ...topology.chain import Chain
from . import coordinate_symbols
from .sketch_pen import Pen, across
from .sketch_pose import MOST_LINKS, LinkShape, SketchPose, rotation

MASS = 4.5
"""px: the radius of the dot of a body."""
EYE = 2.6
"""px: the radius of the pins of drives."""
BARREL, HALF = 0.55, 3.2
"""The part of a cylinder that is its barrel, and half of that one's width, px."""
ASIDE = 8.0
"""px: how far a tendon is drawn from the centreline at least."""
PULL = 20.0
"""px: the arrow of a tension."""
OPEN = 5.0
"""px: from here on the tips that a loop joins are drawn apart."""
FORCE, GAP = 30.0, 11.0
"""px: the arrow of a wrench, and its distance from the tip."""
MOST_WRENCHES = 3
WEIGHT, AXES = 34.0, 28.0
"""px: the arrow of gravity, and those of the inertial axes."""


# -------------------------------------------------------------------------------------------- bodies


def masses(chain: Chain) -> dict[tuple[int, int], str]:
    """The letter of the mass of each body, by the numbers of link and body."""
    bodies = ((i, k) for i, link in enumerate(chain.robot.links) for k in range(len(link.bodies)))
    return {(i, k): rf"m_{{b{k + 1},{chain.firsts[i] + 1}}}" for i, k in bodies}


def bodies(pen: Pen, chain: Chain, part: LinkShape, letters: dict[tuple[int, int], str]) -> None:
    """Bodies as dots; those at one place have one label."""
    segment = chain.segments[part.number]
    places: dict[tuple[float, ...], list[str]] = {}
    for k, body in enumerate(chain.robot.links[segment.link].bodies):
        if segment.first if body.at == "base" else segment.last:
            section = part.joint if body.at == "base" else part.tip
            place = section + part.turn @ np.array(body.com or (0.0, 0.0, 0.0))
            pen.line("offset", section, place)
            places.setdefault(tuple(place.tolist()), []).append(letters[segment.link, k])
    for place, own in places.items():
        pen.dot("body", np.array(place), MASS)
        pen.wish("body", f"${', '.join(own)}$", np.array(place), towards=(0.4, -1.0))


# -------------------------------------------------------------------------------------------- drives


def drives(pen: Pen, chain: Chain, pose: SketchPose, part: LinkShape) -> None:
    """The cylinders and four-bar linkages across a joint."""
    p = [x.value for x in parameters(chain.robot)]
    for link, axis, kind, numbers in chain.travel_numbers(p):
        if link == part.number:
            way = part.axes[axis - chain.tau_offset[link]]
            on_link, _ = across(way, part.straight[1] - part.straight[0])
            q = float(pose.q[chain.axis_places[axis]])
            ground = rotation(way, -q - numbers[-1]) @ on_link
            effort = coordinate_symbols.inputs(chain)[axis]
            if isinstance(kind, Cylinder):
                _cylinder(pen, part.joint, numbers, (ground, on_link), effort)
            elif isinstance(kind, FourBarLinkage):
                crank = rotation(way, kind.travel(q, *numbers)) @ ground
                _four_bar(pen, part.joint, numbers, (ground, crank, on_link), effort)


def _cylinder(
    pen: Pen, joint: np.ndarray, numbers: Sequence[float], ways: tuple[np.ndarray, np.ndarray], effort: str
) -> None:
    """A barrel from the eye on the carrier, a rod to that on the link."""
    crank, base, _ = numbers
    first, last = joint + base * ways[0], joint + crank * ways[1]
    a, b = pen.flat(first), pen.flat(last)
    side = HALF * np.array([a[1] - b[1], b[0] - a[0]]) / max(float(np.linalg.norm(b - a)), 1e-9)
    middle = a + BARREL * (b - a)
    pen.drawn("drive", [a + side, middle + side, middle - side, a - side, a + side])
    pen.drawn("drive", [middle, b])
    _linkage(pen, joint, [first], [first, last])
    pen.wish("drive", f"${effort}$", (a + middle) / 2, towards=_point(np.sign(a[0] - b[0] or 1.0) * side))


def _four_bar(
    pen: Pen,
    joint: np.ndarray,
    numbers: Sequence[float],
    ways: tuple[np.ndarray, np.ndarray, np.ndarray],
    effort: str,
) -> None:
    """A crank on the carrier, a coupler, and the rocker on the link."""
    ground, crank, _, rocker, _ = numbers
    pivot = joint + ground * ways[0]
    pins = [pivot, pivot + crank * ways[1], joint + rocker * ways[2]]
    pen.line("drive", *pins, joint)
    _linkage(pen, joint, [pivot], pins)
    pen.wish("drive", f"${effort}$", pivot)


def _linkage(pen: Pen, joint: np.ndarray, ground: Sequence[np.ndarray], pins: Sequence[np.ndarray]) -> None:
    """What holds the pins on the carrier, and all pins."""
    for place in ground:
        pen.line("straight", joint, place)
    for place in pins:
        pen.ball(place, EYE)


def _point(way: np.ndarray) -> tuple[float, float]:
    return float(way[0]), float(way[1])


# ------------------------------------------------------------------------------------------- tendons


def tendons(pen: Pen, chain: Chain, part: LinkShape, drawn: set[int]) -> None:
    """The pieces of tendons along a link, the first of each with the arrow of its tension; ``drawn`` has those."""
    key, link = chain.keys[part.number], chain.robot.links[chain.segments[part.number].link]
    for piece, tension in zip(key.tendons, chain.tensions[part.number], strict=True):
        stated = np.array(link.tendons[piece.number].at)
        share = np.linspace(*piece.mixed, 9)[:, None]
        offsets = (1 - share) * stated[0] + share * stated[1]
        sizes = np.linalg.norm(offsets, axis=1, keepdims=True)
        outward = offsets / np.where(sizes > 0, sizes, 1.0)
        offsets = np.maximum(sizes, ASIDE / pen.scale) * outward
        line = [part.at(s) + part.turn @ x for s, x in zip(np.linspace(*piece.span, 9), offsets, strict=True)]
        pen.line("pull", *line)
        if tension not in drawn:
            drawn.add(tension)
            end = pen.along(line[0], line[0] - line[1], PULL)
            pen.line("pull", line[0], end, head=True)
            pen.wish("pull", f"${coordinate_symbols.inputs(chain)[chain.n_joints + tension]}$", end)


# --------------------------------------------------------------------------------------------- loops


def loops(pen: Pen, chain: Chain, pose: SketchPose) -> None:
    """The points that loops join, and the axes that couplings join."""
    axes = coordinate_symbols.axes(chain)
    for junction in chain.closing.junctions:
        ends = (junction.first, junction.second)
        if all(chain.segments[end].link < MOST_LINKS for end in ends):
            ratio = junction.demands[0] if junction.demands else None
            if isinstance(ratio, Ratio):
                text = _relation(ratio, axes[ratio.axis], axes[ratio.of])
                _coupling(pen, pose, ends, text)
            else:
                _loop(pen, pose.ends[ends[0]], pose.ends[ends[1]], junction.name)


def _loop(pen: Pen, first: np.ndarray, second: np.ndarray, name: str) -> None:
    """A ring around what a loop joins; a line between tips that are drawn apart."""
    pen.ring("loop", first, 2 * OPEN)
    if pen.far(first, second) > OPEN:
        pen.ring("loop", second, 2 * OPEN)
        pen.line("loop", first, second)
    pen.wish("loop", f"`{name}`", (first + second) / 2, towards=(1.0, 0.5))


def _relation(ratio: Ratio, follows: str, of: str) -> str:
    """What a coupling demands, as a formula."""
    if ratio.relation is not None:
        return f"${follows}$ follows ${of}$"
    factor = "" if ratio.ratio == 1 else "-" if ratio.ratio == -1 else rf"{ratio.ratio:.4g}\,"
    shift = f" {'-' if ratio.offset < 0 else '+'} {abs(ratio.offset):.4g}" if ratio.offset else ""
    return f"${follows} = {factor}{of}{shift}$"


def _coupling(pen: Pen, pose: SketchPose, ends: tuple[int, int], text: str) -> None:
    """An arc between the joints of two coupled axes."""
    parts = [pose.part(end) for end in ends]
    if parts[0] is None or parts[1] is None:
        return
    a, b = (pen.flat(part.joint) for part in parts if part is not None)
    side = np.array([a[1] - b[1], b[0] - a[0]])
    side = -side if side[1] > 0 else side
    s = np.linspace(0.0, 1.0, 25)[:, None]
    arc = a + s * (b - a) + 0.9 * s * (1 - s) * side
    pen.drawn("loop", arc)
    pen.wish("loop", text, arc[12], towards=_point(side))


# ---------------------------------------------------------------------------- wrenches and gravity


def wrenches(pen: Pen, chain: Chain, pose: SketchPose) -> None:
    """The external wrenches on the tips of links that carry none."""
    held = {end for junction in chain.closing.junctions for end in (junction.first, junction.second)}
    carrying = {*chain.tree.parents, *held} if chain.robot.rigid_loops else set(chain.tree.parents)
    leaves = [part for part in pose.parts if part.number not in carrying]
    for part in leaves[:MOST_WRENCHES]:
        way = part.straight[1] - part.straight[0] if part.long else part.turn[:, 0]
        first, last = (pen.along(part.tip, way, size) for size in (GAP, GAP + FORCE))
        pen.line("force", first, last, head=True)
        text = rf"$\boldsymbol{{\mathcal{{W}}}}_{{ext,{part.number + 1}}}$"
        pen.wish("force", text, last, towards=_point(pen.flat(way)))


def gravity(pen: Pen, fall: Sequence[float], floats: bool) -> None:
    """The inertial axes, and the direction of free fall, beside the robot at the lower left."""
    low = pen.corners().min(axis=0)
    corner = low - np.array([52.0, 34.0 if floats else -14.0])
    for letter, axis in zip("xyz", np.eye(3), strict=True):
        tip = corner + AXES * pen.view.flat(axis)
        pen.drawn("frame", [corner, tip], head=True)
        pen.wish("frame", f"${letter}$", tip, towards=_point(tip - corner), reach=25.0)
    pen.wish("frame", "inertial", corner, towards=(0.0, -1.0), reach=34.0)
    if any(fall):
        way = pen.view.flat(np.array(fall) / np.linalg.norm(fall))
        top = corner + np.array([-6.0, AXES + WEIGHT + 20.0])
        tip = top + WEIGHT * way
        pen.drawn("force", [top, tip], head=True)
        pen.wish("force", r"$\mathbf{g}$", (top + tip) / 2, towards=(-1.0, 0.0))
