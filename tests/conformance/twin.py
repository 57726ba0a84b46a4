"""The robot of the oracle: what it does not know is brought to what it does.

A segment is a link of its own, a ball joint three turns, a floating base three slides and three turns; sections by a
profile and measured frequencies are spelled out as line properties.
"""

from __future__ import annotations

import copy

import numpy as np
from oracle_exact import TURNS as TURNS_AT_REST
from oracle_exact import count_of_points, curvature_at_rest
from oracle_floating import JOINTS, TURNS
from oracle_link import read_link
from oracle_sections import property_at

ACCELERATION = (0.8, -1.3, 2.1)
"""That of an accelerated base, m/s², inertial axes; to the oracle free fall is another there."""


def as_pieces(robot: dict) -> dict:
    """The robot with a link for each segment: sections, places and tendons of a link are shared out among its own."""
    links, names = [], {}
    for link in robot["links"]:
        k = link.get("segments", 1)
        names[link["name"]] = [f"{link['name']}_{i}" for i in range(k - 1)] + [link["name"]]
        links += [_piece(link, i, k) for i in range(k)] if k > 1 else [link]
    for link in links:
        pieces = names.get(link.get("parent"), [None])
        if len(pieces) > 1 and not link["name"].startswith(f"{link['parent']}_"):
            _carry_on_piece(link, pieces)
    return robot | {"links": links}


def first_piece(link: dict) -> str:
    """The name of the first of the links that a link of the robot is there."""
    return link["name"] + "_0" * (link.get("segments", 1) > 1)


def _piece(link: dict, i: int, k: int) -> dict:
    kept = ("name", "parent", "at", "joint", "bodies", "segments", "markers", "tendons")
    piece = {key: copy.deepcopy(x) for key, x in link.items() if key not in kept}
    first, last = i / k, (i + 1) / k
    piece["length"] = link["length"] / k
    if isinstance(link["section"], list):
        line = [key for key in link["section"][0] if key != "at"]
        inner = [x["at"] for x in link["section"] if first < x["at"] < last]
        at = lambda s: {x: float(property_at(link["section"], x, np.array([s]))[0]) for x in line}  # noqa: E731
        eps = 1e-15
        places = [first + eps, *(s - eps for s in inner), last - eps]
        piece["section"] = [{"at": (s - first) * k, **at(s)} for s in places]
        piece["section"][0]["at"], piece["section"][-1]["at"] = 0.0, 1.0
    if "rest" in link:
        cut = [_cut(link["rest"], j / k, (j + 1) / k) for j in range(k)]
        piece["modes"]["points"] = max(count_of_points(piece | {"rest": own}) for own in cut)
        piece["rest"] = cut[i]
    own = lambda end: [b for b in link.get("bodies", []) if b["at"] == end]  # noqa: E731
    piece["bodies"] = own("base") * (i == 0) + own("tip") * (i == k - 1)
    piece["name"] = link["name"] if i == k - 1 else f"{link['name']}_{i}"
    if i == 0:
        piece |= {key: link[key] for key in ("parent", "at") if key in link} | {"joint": link["joint"]}
    else:
        piece |= {"parent": f"{link['name']}_{i - 1}", "joint": {"axes": []}}
    tendons = []
    for tendon in link.get("tendons", []):
        if not tendon.get("actuated", True):
            continue
        a, b = tendon.get("from", 0.0), tendon.get("to", 1.0)
        start, to = max(a, first), min(b, last)
        if start < to:
            begin, end = (np.array(x) for x in tendon["at"])
            at = [(begin + (s - a) / (b - a) * (end - begin)).tolist() for s in (start, to)]
            tendons.append({"name": tendon["name"], "from": (start - first) * k, "to": (to - first) * k, "at": at})
    return piece | ({"tendons": tendons} if tendons else {})


def _cut(stations: dict | list[dict], first: float, last: float) -> dict | list[dict]:
    """The stations of a piece from `first` to `last`, of what is linear between those of the whole."""
    if isinstance(stations, dict):
        return stations
    line, near = [key for key in stations[0] if key != "at"], 1e-14
    inner = [x for x in stations if first < x["at"] < last]
    ends = [curvature_at_rest(stations, s) for s in (first + near, last - near)]
    begin, end = ({key: sign * x[axis] for key, (axis, sign) in TURNS_AT_REST.items() if key in line} for x in ends)
    moved = [x | {"at": (x["at"] - first) / (last - first)} for x in inner]
    return [{"at": 0.0, **begin}, *moved, {"at": 1.0, **end}]


def _carry_on_piece(link: dict, pieces: list[str]) -> None:
    """Put a link that a link in pieces carries onto the right one."""
    at, k = link.get("at", "tip"), len(pieces)
    if at == "base":
        link["parent"] = pieces[0]
    elif isinstance(at, dict):
        i = min(int(at["s"] * k), k - 1)
        link["parent"], link["at"] = pieces[i], {"s": at["s"] * k - i}


def spelled_out(link: dict) -> dict:
    """The link with line properties: of a round rod its own, in place of frequencies the stiffness that has them."""
    link = copy.deepcopy(link)
    if "profile" in link:
        given = link.pop("profile")
        d, E, nu, density = given["rod"]["diameter"], given["E"], given["nu"], given["density"]
        area, inertia, G = np.pi * d**2 / 4, np.pi * d**4 / 64, E / (2 * (1 + nu))
        factor = 6 * (1 + nu) / (7 + 6 * nu)  # Cowper's, of a circle
        link["section"] = {"rhoA": density * area, "EA": E * area, "EIy": E * inertia, "EIz": E * inertia}
        link["section"] |= {"GJ": 2 * G * inertia, "rhoIp": 2 * density * inertia}
        if "shear_y" in link["modes"]:
            link["section"] |= {"GAy": factor * G * area, "GAz": factor * G * area}
            link["section"] |= {"rhoIy": density * inertia, "rhoIz": density * inertia}
    if frequencies := link.get("modes", {}).pop("frequencies", {}):
        link["modes"]["basis"] = "clamped_free"
        stiff = {"bending_y": "EIz", "bending_z": "EIy"}
        unit = link | {"section": link["section"] | dict.fromkeys(stiff.values(), 1.0), "joint": {"axes": []}}
        K, mass = np.diag(read_link(unit).K), link["section"]["rhoA"] * link["length"]
        for k, (direction, (f,)) in enumerate(frequencies.items()):
            link["section"][stiff[direction]] = float((2 * np.pi * f) ** 2 * mass / K[k])
    return link


def _without_bristles(joint: dict) -> dict:
    """The joint without dry friction where that remembers."""
    drives = []
    for drive in joint.get("drives", []):
        friction = drive.get("friction", {})
        other = {key: x for key, x in friction.items() if key in ("viscous", "bend")}
        drives.append(drive | {"friction": other} if {"memory", "dahl"} & set(friction) else drive)
    return joint | ({"drives": drives} if drives else {})


def as_turns(robot: dict) -> dict:
    """The robot of the oracle: line properties, pieces, turns in place of balls, axes in place of a free base."""
    robot = as_pieces(robot | {"links": [spelled_out(link) for link in robot["links"]]})
    for link in robot["links"]:
        link["joint"] = _without_bristles(link["joint"])
        if link["joint"]["axes"] == "ball":
            link["joint"] = {**link["joint"], "axes": TURNS}
    if "base" in robot:
        robot["links"][0] = robot["links"][0] | {"joint": {"axes": JOINTS}}
    first = {name.removesuffix("_0"): name for name in (x["name"] for x in robot["links"]) if name.endswith("_0")}
    moved = lambda name: first.get(name.split(".")[0], name.split(".")[0]) + "." + name.split(".")[1]  # noqa: E731
    loops = [x for x in robot.pop("loops", []) if "stiffness" not in x["joint"]]
    robot |= {"loops": loops} if loops else {}
    couplings = [x | {key: moved(x[key]) for key in ("axis", "of")} for x in robot.get("couplings", [])]
    if robot.pop("base_acceleration", False):
        robot["gravity"] = [g - a for g, a in zip(robot["gravity"], ACCELERATION, strict=True)]
    return {key: x for key, x in robot.items() if key != "base"} | ({"couplings": couplings} if couplings else {})


def axes_of(robot: dict) -> dict[str, int]:
    """The place in q of every axis of the oracle's robot, by the product's names of scalar axes."""
    places, k = {}, 0
    for link in robot["links"]:
        for n, axis in enumerate(link["joint"]["axes"]):
            kind = "slide" if isinstance(axis, dict) and "slide" in axis else "joint"
            name = link["name"].removesuffix("_0")
            places[f"{name}.{kind}[{n}]"] = k
            k += 1
    return places
