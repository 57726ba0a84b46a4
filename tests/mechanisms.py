"""Linkages with loops, each stated by its hinges at a closed posture: chains of rigid bodies whose frames are then
parallel to the inertial frame, so that all coordinates are zero where it is closed."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from scipy.optimize import brentq, least_squares

Joint = tuple[Sequence[float], object]
"""A place in the inertial frame and an axis as the robot file states it."""
INERTIA = [0.02, 0.03, 0.025, 0.0, 0.0, 0.0]


def body(name: str, joint: Joint, before: Sequence[float], centre: Sequence[float], mass: float = 1.0, **more) -> dict:
    """A rigid body on a joint; `before`: the place of the joint that carries its parent; `centre`: of mass."""
    place, axis = np.array(joint[0], float), joint[1]
    mount = {"xyz": (place - before).tolist()}
    own = {"at": "base", "mass": mass, "com": (np.array(centre, float) - place).tolist()}
    own["inertia"] = [x * mass for x in INERTIA]
    return {"name": name, "bodies": [own], "joint": {"axes": axes_of(axis), "mount": mount}} | more


def axes_of(axis: object) -> list:
    """The axes of a joint of one axis, a letter or a vector, or of several."""
    return axis if isinstance(axis, list) and not isinstance(axis[0], float) else [axis]


def place(name: str, parent: str, at: Sequence[float], before: Sequence[float]) -> dict:
    """A frame welded to a link, or to the world, for an end of a loop."""
    mount = {"xyz": (np.array(at, float) - before).tolist()}
    nothing = [{"at": "base", "mass": 0.0}]
    return {"name": name, "parent": parent, "bodies": nothing, "joint": {"axes": [], "mount": mount}}


def ring(joints: Sequence[Joint], name: str = "ring", gravity=(0.0, 0.0, -9.81)) -> dict:
    """A single loop of hinges: the first on the world, the last, on the world too, is that of the loop."""
    links, places = [], [np.zeros(3), *(np.array(p, float) for p, _ in joints)]
    for k, joint in enumerate(joints[:-1]):
        centre = (places[k + 1] + places[k + 2]) / 2
        links.append(body(f"bar{k + 1}", joint, places[k] if k else np.zeros(3), centre))
    end = joints[-1][0]
    links.append(place("end", links[-1]["name"], end, places[-2]))
    links.append(place("bearing", "world", end, np.zeros(3)))
    loop = {"between": ["end.tip", "bearing.tip"], "joint": {"axes": axes_of(joints[-1][1])}}
    return {"name": name, "gravity": list(gravity), "links": links, "loops": [loop]}


def denavit_hartenberg(angles, lengths, twists, offsets=None) -> tuple[list[Joint], np.ndarray]:
    """The hinges of a chain by ``Rz(θ) Tz(d) Tx(a) Rx(α)``, and the transform (4, 4) behind the last of them."""
    T, out = np.eye(4), []
    for theta, a, alpha, d in zip(angles, lengths, twists, offsets or [0.0] * len(lengths), strict=True):
        out.append((T[:3, 3].tolist(), T[:3, 2].tolist()))
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        T = T @ np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])
    return out, T


def bennett(a=0.6, alpha=np.pi / 3, beta=np.pi / 4, theta=0.9) -> dict:
    """Four hinges whose opposite bars are alike, with `a / sin α = b / sin β`; `tan θ₁/2 tan θ₂/2` is constant."""
    b = a * np.sin(beta) / np.sin(alpha)
    other = 2 * np.arctan(np.sin((beta + alpha) / 2) / np.sin((beta - alpha) / 2) / np.tan(theta / 2))
    hinges, T = denavit_hartenberg([theta, other, -theta, -other], [a, b, a, b], [alpha, beta, alpha, beta])
    assert np.allclose(T, np.eye(4), atol=1e-12)
    return ring(hinges, "bennett")


def bricard(a=0.4, theta=1.0) -> dict:
    """Six equal bars whose hinges are at right angles in turn (threefold symmetric)."""

    def apart(other: float) -> float:
        turns = [theta, other] * 3
        return denavit_hartenberg(turns, [a] * 6, [np.pi / 2, -np.pi / 2] * 3)[1][0, 3]

    grid = np.linspace(-3.1, 3.1, 400)
    for low, high in itertools.pairwise(grid):
        if apart(low) * apart(high) < 0:
            other = brentq(apart, low, high, xtol=1e-15)
            hinges, T = denavit_hartenberg([theta, other] * 3, [a] * 6, [np.pi / 2, -np.pi / 2] * 3)
            if np.allclose(T, np.eye(4), atol=1e-9):
                return ring(hinges, "bricard")
    raise AssertionError("no closed posture")


def bricard_in_a_line(lengths=(0.3, 0.4, 0.5), twists=(1.0, -0.8, 1.4)) -> dict:
    """Six bars that a half turn about a line brings into each other."""

    def chain(turns):
        return denavit_hartenberg([*turns, *turns], lengths * 2, twists * 2)

    return ring(chain(closing_turns(lambda turns: chain(turns)[1], 3))[0], "bricard_in_a_line")


def schatz(a=0.4, offset=0.2) -> dict:
    """Six hinges, two of them with offsets: the linkage of a mixer that turns its drum over."""
    lengths, twists = [0.0, a, a, a, 0.0, np.sqrt(3) * a], [np.pi / 2] * 5 + [0.0]
    offsets = [offset, 0.0, 0.0, 0.0, 0.0, -offset]
    hinges = denavit_hartenberg(
        closing_turns(lambda turns: denavit_hartenberg(turns, lengths, twists, offsets)[1], 6), lengths, twists, offsets
    )[0]
    return ring(hinges, "schatz")


def closing_turns(end, count: int) -> np.ndarray:
    """The angles (count,) with which the transform `end` of them is the identity, out of a seeded search."""
    rng = np.random.default_rng(1)
    apart = lambda turns: (end(turns) - np.eye(4))[:3].ravel()  # noqa: E731
    for _ in range(100):
        tried = least_squares(apart, rng.uniform(-3.0, 3.0, count), xtol=1e-15, ftol=1e-15, gtol=1e-15)
        if tried.cost < 1e-24:
            return tried.x
    raise AssertionError("no closed posture")


def spherical(axes=((1.0, 0.0, 0.0), (0.6, 0.7, 0.2), (0.0, 1.0, 0.3), (-0.4, 0.5, 0.9)), radius=0.4) -> dict:
    """Four hinges whose axes meet in a point."""
    units = [np.array(x) / np.linalg.norm(x) for x in axes]
    return ring([((radius * u).tolist(), u.tolist()) for u in units], "spherical")


def hooke(bend=0.6, arm=0.6) -> dict:
    """Two shafts at an angle, a cross between them; the second shaft's bearing is that of the loop."""
    second = np.array([np.cos(bend), np.sin(bend), 0.0])
    across = np.array([-np.sin(bend), np.cos(bend), 0.0])
    origin = [0.0, 0.0, 0.0]
    shaft = body("shaft", ([-arm, 0.0, 0.0], "x"), np.zeros(3), [-arm / 2, 0.0, 0.0])
    cross = body("cross", (origin, "z"), [-arm, 0.0, 0.0], origin, 0.3)
    driven = body("driven", (origin, across.tolist()), origin, second * arm / 2)
    end, bearing = place("end", "driven", second * arm, origin), place("bearing", "world", second * arm, origin)
    loop = {"between": ["end.tip", "bearing.tip"], "joint": {"axes": [second.tolist()]}}
    return {"name": "hooke", "gravity": [0.0, 0.0, 0.0], "links": [shaft, cross, driven, end, bearing], "loops": [loop]}


def double_hooke(bend=0.5, arm=0.6) -> dict:
    """Two parallel shafts and one between them, a cross at both of its ends: the driven shaft turns as the driving."""
    second, across = np.array([np.cos(bend), np.sin(bend), 0.0]), np.array([-np.sin(bend), np.cos(bend), 0.0])
    origin, there, ahead = np.zeros(3), arm * second, np.array([arm, 0.0, 0.0])
    links = [
        body("shaft", (-ahead, "x"), origin, -ahead / 2),
        body("cross", (origin, "z"), -ahead, origin, 0.3),
        body("middle", (origin, across.tolist()), origin, there / 2),
        body("second_cross", (there, across.tolist()), origin, there, 0.3),
        body("driven", (there, "z"), there, there + ahead / 2),
        place("end", "driven", there + ahead, there),
        place("bearing", "world", there + ahead, origin),
    ]
    loop = {"between": ["end.tip", "bearing.tip"], "joint": {"axes": ["x"]}}
    return {"name": "double_hooke", "gravity": [0.0, 0.0, -9.81], "links": links, "loops": [loop]}


def tripod(height=0.8) -> dict:
    """A platform on three legs that lean in planes, slide out and end in ball joints."""
    links, loops, origin = [], [], np.zeros(3)
    for k, angle in enumerate(2 * np.pi * np.arange(3) / 3):
        out, across = np.array([np.cos(angle), np.sin(angle), 0.0]), [-np.sin(angle), np.cos(angle), 0.0]
        foot, top = 0.5 * out, 0.3 * out + [0.0, 0.0, height]
        along = ((top - foot) / np.linalg.norm(top - foot)).tolist()
        links.append(body(f"leg{k}", (foot, across), origin, (foot + top) / 2, parent="world"))
        links.append(body(f"rod{k}", (foot, [{"slide": along}]), foot, top, parent=f"leg{k}"))
        if k == 0:
            first = top
            links.append(body("platform", (top, ["x", "y", "z"]), foot, [0.0, 0.0, height], parent="rod0"))
        else:
            links += [place(f"end{k}a", f"rod{k}", top, foot), place(f"end{k}b", "platform", top, first)]
            loops.append({"between": [f"end{k}a.tip", f"end{k}b.tip"], "joint": {"axes": ["x", "y", "z"]}})
    return {"name": "tripod", "gravity": [0.0, 0.0, -9.81], "links": links, "loops": loops}


def sarrus(arm=0.5) -> dict:
    """Two pairs of bars with three parallel hinges each, at right angles, between a base and a plate that rises."""
    fold = 0.7
    out, up = arm * np.cos(fold), arm * np.sin(fold)
    side = [([0.3, 0.0, 0.0], "y"), ([0.3 + out, 0.0, up], "y"), ([0.3, 0.0, 2 * up], "y")]
    other = [([0.0, 0.3, 2 * up], "x"), ([0.0, 0.3 + out, up], "x"), ([0.0, 0.3, 0.0], "x")]
    return ring([*side, *other], "sarrus")


def planar(name: str, bars: dict[str, tuple], loops: Sequence[tuple]) -> dict:
    """Bars in the x-z plane with hinges about y. `bars`: name -> (parent, place of its hinge); `loops`: pairs of
    bars with the place of the hinge between them, or a bar with the world."""
    links, origin = [], np.zeros(3)
    spatial = lambda x: np.array([x[0], 0.0, x[1]])  # noqa: E731
    at = {"world": origin} | {bar: spatial(where) for bar, (_, where) in bars.items()}
    far = {bar: where for first, second, where in loops for bar in (first, second)}
    far |= dict(bars.values())
    for bar, (parent, where) in bars.items():
        centre = (spatial(where) + spatial(far[bar])) / 2
        links.append(body(bar, (spatial(where), "y"), at[parent], centre, parent=parent))
    tables = []
    for k, (first, second, where) in enumerate(loops):
        for side, bar in (("a", first), ("b", second)):
            links.append(place(f"end{k}{side}", bar, spatial(where), at[bar]))
        tables.append({"between": [f"end{k}a.tip", f"end{k}b.tip"], "joint": {"axes": ["y"]}})
    return {"name": name, "gravity": [0.0, 0.0, -9.81], "links": links, "loops": tables}


def rockers(name: str, *feet: float) -> dict:
    """A crank and rockers as long as it, which stand at these places, on one coupler."""
    tip = (0.3 * np.cos(1.0), 0.3 * np.sin(1.0))
    bars = {"crank": ("world", (0.0, 0.0)), "coupler": ("crank", tip)}
    bars |= {f"rocker{k}": ("world", (x, 0.0)) for k, x in enumerate(feet)}
    return planar(name, bars, [("coupler", f"rocker{k}", (x + tip[0], tip[1])) for k, x in enumerate(feet)])


def parallelogram() -> dict:
    """Equal cranks and a coupler as long as the ground; in line it may go on as a crossed one."""
    return rockers("parallelogram", 0.8)


def antiparallelogram(crank=0.3, ground=0.8) -> dict:
    """The bars of a parallelogram, crossed."""
    tip, foot = crank * np.array([np.cos(1.0), np.sin(1.0)]), np.array([ground, 0.0])
    along = (foot - tip) / np.linalg.norm(foot - tip)
    end = tip + 2 * (foot @ along) * along - foot  # the parallelogram's, mirrored in the diagonal
    bars = {"crank": ("world", (0.0, 0.0)), "coupler": ("crank", tuple(tip)), "rocker": ("world", (ground, 0.0))}
    return planar("antiparallelogram", bars, [("coupler", "rocker", tuple(end))])


def watt() -> dict:
    """A four-bar linkage whose rocker drives a second one."""
    bars = {"crank": ("world", (0.0, 0.0)), "coupler": ("crank", (0.1, 0.25)), "rocker": ("world", (0.8, 0.0))}
    bars |= {"arm": ("rocker", (0.9, 0.6)), "lever": ("world", (1.6, 0.1))}
    return planar("watt", bars, [("coupler", "rocker", (0.75, 0.5)), ("arm", "lever", (1.5, 0.55))])


def stephenson() -> dict:
    """A four-bar linkage whose coupler drives a lever through a fifth bar."""
    bars = {"crank": ("world", (0.0, 0.0)), "coupler": ("crank", (0.1, 0.25)), "rocker": ("world", (0.8, 0.0))}
    bars |= {"arm": ("coupler", (0.4, 0.7)), "lever": ("world", (1.3, 0.2))}
    return planar("stephenson", bars, [("coupler", "rocker", (0.75, 0.5)), ("arm", "lever", (1.2, 0.8))])


def slider_crank(kind: str = "slide", crank=0.3, rod=0.7) -> dict:
    """Crank and rod in the x-z plane. `slide`: the loop lets the rod's end slide and turn; `guide`: a piston on the
    rod, which the loop lets slide alone; `weld`: a slide on the ground carries a piston that is welded to the rod."""
    turn, origin = 1.0, np.zeros(3)
    tip = np.array([crank * np.cos(turn), 0.0, crank * np.sin(turn)])
    end = np.array([tip[0] + np.sqrt(rod**2 - tip[2] ** 2), 0.0, 0.0])
    links = [body("crank", (origin, "y"), origin, tip / 2), body("rod", (tip, "y"), origin, (tip + end) / 2)]
    if kind == "slide":
        links += [place("end", "rod", end, tip), place("guide", "world", end, origin)]
        axes, between = [{"slide": "x"}, "y"], ["guide.tip", "end.tip"]
    elif kind == "guide":
        links += [body("piston", (end, "y"), tip, end, 0.5), place("guide", "world", end, origin)]
        axes, between = [{"slide": "x"}], ["guide.tip", "piston.tip"]
    else:
        links += [place("end", "rod", end, tip)]
        links += [body("piston", (end, [{"slide": "x"}, "y"]), origin, end, 0.5, parent="world")]
        axes, between = [], ["end.tip", "piston.tip"]
    loop = {"between": between, "joint": {"axes": axes}}
    return {"name": f"slider_{kind}", "gravity": [0.0, 0.0, -9.81], "links": links, "loops": [loop]}


def carried(robot: dict, boom: dict) -> dict:
    """A robot on the tip of a link."""
    stood = [link | {"parent": "boom"} if link.get("parent") == "world" else link for link in robot["links"][1:]]
    return robot | {"links": [boom | {"name": "boom"}, robot["links"][0] | {"parent": "boom"}, *stood]}


def beside(robot: dict, other: dict) -> dict:
    """Two robots on one base; the names of the other's links begin with `other_`."""
    links, before = [], "world"
    for link in other["links"]:
        parent = link.get("parent", before)
        links.append(
            link | {"name": f"other_{link['name']}", "parent": parent if parent == "world" else f"other_{parent}"}
        )
        before = link["name"]
    loops = [loop | {"between": [f"other_{end}" for end in loop["between"]]} for loop in other["loops"]]
    return robot | {"links": [*robot["links"], *links], "loops": [*robot["loops"], *loops]}


MECHANISMS = {
    "hooke": hooke,
    "bennett": bennett,
    "spherical": spherical,
    "watt": watt,
    "stephenson": stephenson,
    "bricard": bricard,
    "sarrus": sarrus,
    "slider_slide": lambda: slider_crank("slide"),
    "slider_guide": lambda: slider_crank("guide"),
    "slider_weld": lambda: slider_crank("weld"),
    "parallelogram": parallelogram,
    "locomotive": lambda: rockers("locomotive", 0.8, 1.6),
    "other_bennett": lambda: bennett(0.7, -2.0, -0.7),
    "crossed_bennett": lambda: bennett(0.5, 1.2, -0.5, -0.6),
    "bent_hooke": lambda: hooke(1.2),
    "double_hooke": double_hooke,
    "spherical_at_right_angles": lambda: spherical(((1, 0, 0), (0, 1, 0), (0, 0, 1), (0.5, 0.5, 0.8))),
    "bricard_in_a_line": bricard_in_a_line,
    "schatz": schatz,
    "three_rockers": lambda: rockers("three_rockers", 0.5, 1.0, 1.5),
    "antiparallelogram": antiparallelogram,
    "tripod": tripod,
}
"""Linkages that move, by name."""
