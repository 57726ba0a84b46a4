"""The sketch of a robot: what its coordinates are, drawn from the model.

Links are drawn bent by the first mode of each direction, beside their undeformed centrelines, in a posture and from a
side that show them apart. Deflections are far larger than a robot's.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from ...spec.link_class import AXIS
from ...spec.reduced import ELASTIC
from ...topology.chain import Chain
from . import coordinate_symbols
from .content import DrawingItem
from .drawing import Drawing
from .sketch_acting import bodies, drives, gravity, loops, masses, tendons, wrenches
from .sketch_forces import forces, pushes
from .sketch_joints import foot, joint, names, on_world
from .sketch_pen import Pen, respelled
from .sketch_pose import MOST_LINKS, LinkShape, SketchPose, SketchView, drawn_lengths, poses, true_lengths
from .sketch_view import chosen

WIDE, PER_LINK, WIDEST, HIGHEST = 210.0, 90.0, 430.0, 250.0
"""px: the width of the robot of one link, what each further link adds, and the most of width and height."""
BESIDE = 80.0
"""px: the further room of what is drawn beside the links."""
FRAME = 21.0
"""px: the axes of the frames of links."""
TWIST, TWISTED = 9.0, 0.62
"""px: the radius of the arc of torsion, and where along the link it is."""
SHORT = 1.5
"""px: a shorter line is not drawn."""
LEAST, SEEN = 18.0, 8.0
"""px: the arrow of a deflection that is smaller than can be seen."""
TICK = 5.0
"""px: half the size of a weld, and of the mark of a marker."""
MOST_PIECES, MOST_FRAMES = 3, 8
"""Of a link with more segments the modes stand at the last one; of a robot with more links frames have no letters."""
MOST_NAMED = 6
"""Coordinates of a posture that the caption says one by one."""


def figure(chain: Chain, letters: Mapping[str, str] | None = None) -> DrawingItem:
    """The sketch of a robot with its caption.

    ``letters``: those of equations that have letters of their own, and no external wrenches, by those of a document.
    """
    pose, view = chosen(poses(chain), chain.robot.gravity)
    pen = _whole(chain, pose, view, letters)
    caption = respelled(_caption(chain, pose, pen.shortened), pen.letters)
    return DrawingItem(pen.drawing(), caption, essential=True)


def sketch(chain: Chain) -> Drawing:
    """The sketch of a robot."""
    return figure(chain).drawing


def _whole(chain: Chain, pose: SketchPose, view: SketchView, letters: Mapping[str, str] | None) -> Pen:
    """The picture of a robot in a posture; a smaller one where what is drawn beside the links needs room."""
    scale = _scale(pose, view)
    pen = _drawn(chain, pose, Pen(view, scale, letters))
    width, height = np.ptp(pen.corners(), axis=0)
    share = min(1.0, (WIDEST + BESIDE) / width, (HIGHEST + BESIDE) / height)
    pen = pen if share == 1.0 else _drawn(chain, pose, Pen(view, share * scale, letters))
    gravity(pen, chain.robot.gravity, chain.floating)
    return pen


def _drawn(chain: Chain, pose: SketchPose, pen: Pen) -> Pen:
    """All that is in space."""
    letters, pulled, along = masses(chain), set[int](), names(chain)
    for part in pose.parts:
        joint(pen, chain, part, along)
    for part in pose.parts:
        _link(pen, chain, part)
        drives(pen, chain, pose, part)
        tendons(pen, chain, part, pulled)
        bodies(pen, chain, part, letters)
    for group in _mode_groups(chain, pose):
        _modes(pen, chain, *group)
    loops(pen, chain, pose)
    forces(pen, chain, pose)
    pushes(pen, chain, pose)
    if not pen.letters:
        wrenches(pen, chain, pose)
    for i, parent in enumerate(chain.tree.parents):
        carrier = pose.part(parent)
        if chain.segments[i].link >= MOST_LINKS and carrier is not None:
            pen.wish("link", "…", carrier.tip, towards=(1.0, 0.0))
    for part in pose.parts:
        _frame(pen, chain, part)
    return pen


def _scale(pose: SketchPose, view: SketchView) -> float:
    """px per m, by which the robot fills its room."""
    points = view.flat(np.concatenate([np.vstack([part.line, part.mount]) for part in pose.parts]))
    extent = np.maximum(np.ptp(points, axis=0), 1e-9)
    room = min(WIDEST, WIDE + PER_LINK * (len({part.number for part in pose.parts}) - 1)), HIGHEST
    scale = min(room[0] / extent[0], room[1] / extent[1])
    return float(scale) if np.max(extent) > 1e-6 else 100.0


# --------------------------------------------------------------------------------------------- links


def _link(pen: Pen, chain: Chain, part: LinkShape) -> None:
    """A link with its name, what it is mounted by, and the ground below it."""
    i, key, segment = part.number, chain.keys[part.number], chain.segments[part.number]
    if pen.far(part.carrier, part.mount) > SHORT:
        pen.line("offset", part.carrier, part.mount)
    if pen.far(*part.straight) > SHORT:
        pen.line("rod" if key.modes else "rigid", *part.line)
        if key.modes:
            pen.line("straight", *part.rest)
    if on_world(chain, part):
        foot(pen, part, _hangs(pen, part), welded=not key.joint.nv)
    elif not key.joint.nv and segment.first:
        _weld(pen, part)
    if segment.number == segment.count // 2:
        pen.wish("link", f"`{segment.owner}`", part.at(0.5), towards=_beside(pen, part))
    for marker in chain.markers:
        if marker.segment == i and not marker.is_tip:
            _marker(pen, part, marker.at, marker.name.partition(".")[2])


def _beside(pen: Pen, part: LinkShape) -> tuple[float, float]:
    """The direction across a link, away from where its modes bend it."""
    x, y = pen.flat(part.line[-1] - part.line[0])
    bent = pen.flat(part.at(0.5) - (part.rest[0] + part.rest[-1]) / 2)
    side = np.array([-y, x]) * (1.0 if -y * bent[0] + x * bent[1] > 0 else -1.0)
    return float(side[0]), float(side[1] or 1.0)


def _hangs(pen: Pen, part: LinkShape) -> bool:
    """Whether a link goes down from its foot."""
    x, y = pen.flat(part.tip - part.mount)
    return bool(y < -abs(x))


def _weld(pen: Pen, part: LinkShape) -> None:
    """A cross where a link is welded."""
    x, y = pen.point(part.joint)
    for s in (1.0, -1.0):
        pen.drawn("ground", [(x - TICK, y - s * TICK), (x + TICK, y + s * TICK)])


def _marker(pen: Pen, part: LinkShape, s: float, name: str) -> None:
    """A tick across a link, with the name of the marker."""
    place, way = pen.flat(part.at(s)), pen.flat(part.at(min(s + 0.05, 1.0)) - part.at(s - 0.05))
    across = np.array([-way[1], way[0]]) / max(float(np.linalg.norm(way)), 1e-9)
    pen.drawn("ground", [place - TICK * across, place + TICK * across])
    pen.wish("link", f"`{name}`", place, needed=False, reach=34.0, towards=(float(across[0]), float(across[1])))


def _frame(pen: Pen, chain: Chain, part: LinkShape) -> None:
    """The axes y and z of a link's frame, and x where no link lies along it."""
    if not chain.segments[part.number].first:
        return
    ways = [0, 1, 2] if pen.far(*part.straight) <= SHORT else [1, 2]
    few = len(chain.robot.links) <= MOST_FRAMES
    for k in ways:
        end = pen.along(part.origin, part.turn[:, k], FRAME)
        pen.line("frame", part.origin, end, head=True)
        if few:
            way = pen.flat(part.turn[:, k])
            towards = (float(way[0]), float(way[1]))
            pen.wish("frame", f"${'xyz'[k]}$", end, towards=towards, needed=False, reach=13.0)
    text = rf"$\mathcal{{F}}_{{{part.number + 1}}}$"
    reach = 62.0 if few else 20.0
    pen.wish("frame", text, part.origin, towards=(-1.0, -0.6), needed=False, reach=reach)


# --------------------------------------------------------------------------------------------- modes

Group = tuple[LinkShape, str, list[int]]
"""The part at which modes are drawn, their direction, and their numbers among all modes."""


def _mode_groups(chain: Chain, pose: SketchPose) -> Iterator[Group]:
    """The modes of each link by the direction in which they displace it; of many segments together."""
    for link in dict.fromkeys(chain.segments[part.number].link for part in pose.parts):
        own = [part for part in pose.parts if chain.segments[part.number].link == link]
        shown = [[part] for part in own] if len(own) <= MOST_PIECES else [own]
        for parts in shown:
            groups: dict[str, list[int]] = {}
            for part in parts:
                for k, (direction, _) in enumerate(chain.keys[part.number].directions):
                    letter = "xyz"[AXIS[direction]] if direction in AXIS else direction
                    groups.setdefault(letter, []).append(chain.eta_offset[part.number] + k)
            yield from ((parts[-1], letter, modes) for letter, modes in groups.items())


def _modes(pen: Pen, chain: Chain, part: LinkShape, letter: str, modes: Sequence[int]) -> None:
    """The arrow of a deflection, with the modes that make it."""
    known, titles, rates = coordinate_symbols.modes(chain), names(chain), chain.eta_v
    text = f"${ranges([known[k] for k in modes])}$"
    arrow = _twist(pen, part) if letter == "torsion" else _deflection(pen, part, letter)
    pen.line("mode", *arrow, head=True)
    middle = arrow[len(arrow) // 2] if letter == "torsion" else arrow.mean(axis=0)
    way = pen.flat(middle - part.at(0.5))
    own = tuple(titles[rates + k] for k in modes)
    pen.wish("mode", text, middle, towards=(float(way[0]), float(way[1])), names=own)


def ranges(letters: Sequence[str]) -> str:
    """Two letters, or the first and the last of several."""
    return ", ".join(letters) if len(letters) < 3 else rf"{letters[0]} \ldots {letters[-1]}"


def _twist(pen: Pen, part: LinkShape) -> np.ndarray:
    """(n, 3): an arc about the centreline."""
    way = part.at(TWISTED + 0.05) - part.at(TWISTED - 0.05)
    return pen.circle(part.at(TWISTED), way, TWIST, 1.5 * np.pi, np.pi / 2)


def _deflection(pen: Pen, part: LinkShape, letter: str) -> np.ndarray:
    """(2, 3): from where the undeformed tip is, along one axis of the frame; y before z, and all of them of a body."""
    moved = part.turn.T @ (part.tip - part.rest[-1])
    if letter == ELASTIC:
        return np.array([part.rest[-1], part.tip])
    k = "xyz".index(letter)
    start, way = part.rest[-1] + part.turn[:, :k] @ moved[:k], part.turn[:, k]
    least = LEAST / pen.scale if abs(moved[k]) * pen.scale < SEEN else moved[k]
    return np.array([start, start + least * way])


# ------------------------------------------------------------------------------------------- caption


def _caption(chain: Chain, pose: SketchPose, shortened: bool) -> str:
    """One sentence on what is drawn."""
    more = len(chain.robot.links) - MOST_LINKS
    what = f"The first {MOST_LINKS} links of the robot" if more > 0 else "The robot"
    posture = _posture(chain, pose)
    posture = f" at {posture}" if posture else ""
    scale = ", not to scale" if drawn_lengths(chain) != true_lengths(chain) else ""
    bent = "; flexible links are bent by the first mode of each direction (dashed: undeformed)" if chain.n_modes else ""
    bent += "" if pose.closed else "; loops are open, as no posture near this one closes them"
    bent += "; a line with a gap is longer than it is drawn" if shortened else ""
    return rf"{what}{posture}{scale}{bent}; $x$ of each frame $\mathcal{{F}}_i$ runs along its link."


def _posture(chain: Chain, pose: SketchPose) -> str:
    """The coordinates of the joints, in words."""
    balls = {k for part in chain.curved for k in range(part.q.start, part.q.stop)}
    named = zip(chain.axis_places, coordinate_symbols.axes(chain), strict=True)
    all_moved = [(place, name) for place, name in named if abs(pose.q[place]) > 5e-3]
    moved = [(name, pose.q[place]) for place, name in all_moved if place not in balls]
    said = [f"${name} = {x:.2g}$" for name, x in moved]
    if len(moved) > MOST_NAMED:
        said = [rf"coordinates of its joints up to $\pm {max(abs(x) for _, x in moved):.2g}$"]
    elif not moved:
        said = [r"$\mathbf{q} = \mathbf{0}$"] * (not all_moved and chain.n_joints > 0)
    elif len(all_moved) < chain.n_joints:
        said.append("other coordinates zero")
    return ", ".join(said + ["with its ball joints turned"] * (len(all_moved) > len(moved)))
