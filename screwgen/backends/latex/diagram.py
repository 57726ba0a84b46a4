"""The block diagram of a robot's solution: links, the three passes between them, loops, blocks of the matrix."""

from __future__ import annotations

from dataclasses import dataclass

from ...topology.chain import Chain
from ..templates import render
from .pattern import Place, occupied

WIDE, HIGH, STEP, ROW = 132, 74, 212, 112
"""Size of a box, and the distance of boxes along and across the tree, in px."""
NARROW = 60
"""By how much the box of the base is narrower."""
LEFT, TOP = 2, 12
ACROSS, LINE = 4, 154
"""So many links of a chain stand side by side; the others follow in further lines, at this distance."""
MOST_LINKS, MOST_BLOCKS = 24, 36
"""Of more links only the first are drawn; a larger matrix is left out."""
CELL = 16
LETTERS = 15


@dataclass(frozen=True)
class LinkBox:
    x: float
    y: float
    name: str
    number: int
    coordinates: str
    """What is solved for in the link, in words."""


PASSES = ((1, -22, "V, b"), (2, 2, "Λ, p"), (3, 26, "V̇"))
"""The three passes: number, place beside the middle between two boxes, and what is handed over."""


@dataclass(frozen=True)
class Flow:
    """What one pass hands from box to box: the number of the pass, its path, a label and the label's place."""

    number: int
    path: str
    label: str
    x: float
    y: float


@dataclass(frozen=True)
class Passes:
    """The three passes through a joint."""

    flows: tuple[Flow, ...]
    joint: str


@dataclass(frozen=True)
class LoopArc:
    path: str
    name: str
    x: float
    y: float


def diagram(chain: Chain) -> str:
    """The diagram as SVG, which takes its colours from the page."""
    shown = min(chain.n, MOST_LINKS)
    places = _places(chain, shown)
    boxes = [LinkBox(*places[i], _short(chain.names[i]), i + 1, _coordinates(chain, i)) for i in range(shown)]
    base = (LEFT, sum(y for _, y in places.values()) / shown if _forks(chain) else TOP)
    parents = chain.tree.parents
    passes = [Passes(_flows(places.get(parents[i], base), places[i]), _joint(chain, i)) for i in range(shown)]
    names = {junction.name: (junction.first, junction.second) for junction in chain.closing.junctions}
    loops = [_loop(name, *ends, places) for name, ends in names.items() if max(ends) < shown]
    deep = max(y for _, y in places.values()) + HIGH
    blocks = _matrix(chain)
    return render(
        "latex/diagram.html.jinja",
        base=base,
        boxes=boxes,
        passes=passes,
        loops=loops,
        size=(WIDE, HIGH),
        base_width=WIDE - NARROW,
        width=max(x for x, _ in places.values()) + WIDE + LEFT,
        height=deep + (54 if loops else 12),
        more=chain.n - shown,
        ground=("moves as given" if chain.moving else "floats") if chain.floating else "at rest, −g",
        blocks=blocks,
        cell=CELL,
    )


def _places(chain: Chain, shown: int) -> dict[int, tuple[float, float]]:
    """The upper left corner of every link's box: the depth in the tree to the right, leaves below each other."""
    if not _forks(chain) and not chain.closing.junctions:
        across = [(LEFT + STEP * (i % ACROSS + 1) - NARROW, TOP + LINE * (i // ACROSS)) for i in range(shown)]
        return dict(enumerate(across))
    parents, depth, row = chain.tree.parents, {-1: 0}, {}
    for i in range(shown):
        depth[i] = depth[parents[i]] + 1
    leaves = [i for i in range(shown) if i not in parents[:shown]]
    for place, leaf in enumerate(leaves):
        row[leaf] = float(place)
    for i in reversed(range(shown)):
        below = [row[k] for k in range(shown) if parents[k] == i]
        row[i] = row[i] if i in row else sum(below) / len(below)
    return {i: (LEFT + STEP * depth[i] - NARROW, TOP + ROW * row[i]) for i in range(shown)}


def _forks(chain: Chain) -> bool:
    return not chain.tree.is_chain


def _flows(carrier: tuple[float, float], carried: tuple[float, float]) -> tuple[Flow, ...]:
    """The passes between a box and one that it carries, on its right or at the start of the next line."""
    return tuple((_next_line if carried[0] < carrier[0] else _beside)(carrier, carried, *one) for one in PASSES)


def _beside(carrier: tuple[float, float], carried: tuple[float, float], number: int, aside: float, label: str) -> Flow:
    """From the right side of a box to the left side of the other."""
    x1 = carrier[0] + (WIDE if carrier[0] > LEFT else WIDE - NARROW) + 4
    x2, y1, y2 = carried[0] - 4, carrier[1] + HIGH / 2 + aside, carried[1] + HIGH / 2 + aside
    middle, level = (x1 + x2) / 2, y1 == y2
    (a, b), (c, d) = ((x1, y1), (x2, y2)) if number != 2 else ((x2, y2), (x1, y1))
    path = f"M{a:g} {b:g} H{c:g}" if level else f"M{a:g} {b:g} C{middle:g} {b:g} {middle:g} {d:g} {c:g} {d:g}"
    return Flow(number, path, label, middle if level else x2 - 22, y2 - 5)


def _next_line(
    carrier: tuple[float, float], carried: tuple[float, float], number: int, aside: float, label: str
) -> Flow:
    """From the lower side of the last box of a line to the upper side of the first one of the next; no two cross."""
    x1, x2 = carrier[0] + WIDE / 2 + aside, carried[0] + WIDE / 2 + aside
    y1, y2 = carrier[1] + HIGH + 4, carried[1] - 4
    between = (y1 + y2) / 2 + aside
    (a, b), (c, d) = ((x1, y1), (x2, y2)) if number != 2 else ((x2, y2), (x1, y1))
    return Flow(number, f"M{a:g} {b:g} V{between:g} H{c:g} V{d:g}", label, (x1 + x2) / 2, between - 5)


def _coordinates(chain: Chain, i: int) -> str:
    key = chain.keys[i]
    joint = f"{key.joints} {'axis' if key.joints == 1 else 'axes'}" if key.joints else key.joint.name or "welded"
    joint = ("moves as given" if key.joint.given else "floats") if key.floats else joint
    return f"{joint}, {key.modes} mode{'s' * (key.modes > 1)}" if key.modes else f"{joint}, rigid"


def _short(name: str) -> str:
    return name if len(name) <= LETTERS else f"{name[: LETTERS - 1]}…"


def _joint(chain: Chain, i: int) -> str:
    return f"joint of {chain.names[i]}"


def _loop(name: str, first: int, second: int, places: dict[int, tuple[float, float]]) -> LoopArc:
    """An edge below the boxes that it joins."""
    (x1, y1), (x2, y2) = places[first], places[second]
    x1, x2, low = x1 + WIDE / 2, x2 + WIDE / 2, max(y1, y2) + HIGH + 24
    path = f"M{x1:g} {y1 + HIGH:g} C{x1:g} {low:g} {x2:g} {low:g} {x2 + 12:g} {y2 + HIGH:g}"
    return LoopArc(path, name, (x1 + x2) / 2, low + 4)


def _matrix(chain: Chain) -> tuple[list[tuple[str, str, int]], list[tuple[int, int, str]]] | None:
    """The rows of the system's matrix with letter, accent and link, and its occupied blocks with their kind."""
    places, grid = occupied(chain)
    if len(places) > MOST_BLOCKS:
        return None
    cells = [
        (i, j, places[i][0] if places[i][0] == places[j][0] else "between")
        for i, row in enumerate(grid)
        for j, full in enumerate(row)
        if full
    ]
    return [(*_letter(place), place[1] + 1) for place in places], cells


def _letter(place: Place) -> tuple[str, str]:
    return {"joint": ("w", ""), "link": ("V", "\u0307"), "modes": ("\u03b7", "\u0308")}[place[0]]
