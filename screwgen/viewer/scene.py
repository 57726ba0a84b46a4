"""What is drawn of a robot: its links with the shapes of their modes, joints, bodies and feet, as plain data.

The page finds poses itself, from the coordinates of a run: by the screws of the joints and the sections of the links.
So they are right at any magnification of the modes, and take no room in the file. Where the mounts are is read off
the model's own poses at zero coordinates, with the parameters of the run.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ..backends.numpy.numeric import Numeric
from ..backends.numpy.rest_shape import section_at_rest
from ..model import Model
from ..spec.link_class import EXACT, LinkClass
from ..spec.robot import Body, Link
from ..spec.segments import Segment
from .actuators import cylinders, tendons
from .lines import lines
from .pack import floats
from .shapes import FINE, at_rest, sections, strains
from .solids import thinnest
from .surfaces import surfaces

ROWS = 25
"""Sections at which a flexible link is drawn; links with segments have about as many in all."""
PER_POINT = 4
"""The same of a rod that is curved at rest, for each of its points: of a spring some in each of its turns."""
SLENDER, STOUT, PLAIN = 0.01, 0.03, 0.012
"""Least and largest radius of a tube over the size of the robot, and that of one whose section says nothing."""
MODULUS_OVER_DENSITY = 2.6e7
"""m²/s²: of steel, aluminium and titanium alike; it tells the size of a section from its stiffness and its mass."""
HANGING = 0.2
"""How far below its foot the middle of a robot that hangs is, over how far it reaches."""
DENSITY = 2700.0
"""kg/m³: a body without inertia is drawn as a sphere of aluminium."""


def scene(model: Model, p: np.ndarray | None = None, q: np.ndarray | None = None) -> dict[str, Any]:
    """The robot for the page; `p`: values of its parameters, those of the file by default.

    `q`: the posture that tells whether the robot hangs from its foot, by default that of zero coordinates.
    """
    robot, chain = model.robot, model.chain
    values = dict(zip(model.parameter_names, model.parameter_values if p is None else p, strict=True))
    numeric, rest = model.numpy(p), chain.home
    (R, r), (R_tip, r_tip) = numeric.link_pose(rest), numeric.tip_poses(rest)
    tips = np.einsum("nba,nb->na", R, r_tip - r)
    bases = [_base(chain.segments[i], robot.links[chain.segments[i].link], values) for i in range(chain.n)]
    lengths = [values.get(f"{robot.links[x.link].name}.length", 0.0) / x.count for x in chain.segments]
    straight = [base + np.array([x, 0.0, 0.0]) for base, x in zip(bases, lengths, strict=True)]
    ends = np.where([[bool(key.rest)] for key in chain.keys], straight, tips)
    size = _size(chain.tree.parents, ends, np.array(bases), r)
    links = []
    for i, (segment, key) in enumerate(zip(chain.segments, chain.keys, strict=True)):
        own, parent, reach = robot.links[segment.link], chain.tree.parents[i], ends[i] - bases[i]
        places = _places(key, own.pieces)
        length, exact = float(np.linalg.norm(reach)) or 1.0, key.order == EXACT
        table = sections(key, length, places)
        columns = strains(key, length, places) if exact else table.columns
        if key.rest:
            columns = np.concatenate([columns, at_rest(key, _curvature(own, values), places)[:, None]], axis=1)
        at, carried = _carried(model, i)
        mount = _between(carried, (R, r), i, parent, R_tip, r_tip, tips, np.array(bases))
        if parent >= 0 and chain.keys[parent].rest and carried != 1.0:
            rest = _curvature(robot.links[chain.segments[parent].link], values)
            turn, place = section_at_rest(chain.keys[parent], lengths[parent], rest, carried)
            mount = _mount(R[parent] @ turn, r[parent] + R[parent] @ place, R[i], r[i] + R[i] @ bases[i])
        radius = 0.0 if segment.marker is not None else _radius(own, values, size)
        screws = [{"axis": s.axis, "turn": s.turn, "travel": s.travel} for s in key.screws]
        links.append(
            {
                "name": segment.name,
                "owner": segment.link,
                "parent": parent,
                "place": at,
                "mount": mount,
                "ball": key.joint.name == "ball",
                "in_space": key.joint.in_space,
                "loose": key.joint.in_space or sum(not s["turn"] for s in screws) == 3,
                "joint": chain.q_offset[i],
                "force": chain.tau_offset[i],
                "screws": screws,
                "welded": not segment.first or segment.marker is not None,
                "eta": chain.eta_q + chain.eta_offset[i],
                "modes": key.modes,
                "pairs": table.pairs.ravel().tolist(),
                "base": list(bases[i]),
                "reach": reach.tolist(),
                "axes": _quaternion(np.eye(3) if key.rest else R[i].T @ R_tip[i]),
                "turns": robot.section_rotation,
                "places": places.tolist(),
                "fine": FINE * exact,
                "curved": bool(key.rest),
                "columns": floats(columns.swapaxes(0, 1)),
                "radius": radius,
                "twists": own.modes.torsion > 0,
                "bodies": list(_bodies(own, segment)),
                "tendons": list(tendons(own, segment, values, radius)),
                "hangs": parent < 0 and _hangs(numeric, chain.tree.parents, i, np.array(rest if q is None else q)),
                "cylinders": list(cylinders(own, segment, screws, reach, values)),
            }
        )
    gravity = [float(x) for x in numeric.p[:3]]
    thin = thinnest(links, size)
    started = numeric.tip_poses(np.array(rest if q is None else q, float))
    whole: dict[str, Any] = {"lines": list(lines(model, values, started[1], thin)), "links": links}
    whole["surfaces"] = list(surfaces(model, values, started, size))
    whole |= {"name": robot.name, "size": size, "gravity": gravity, "nq": model.nq, "closed": bool(robot.rigid_loops)}
    return whole


def _hangs(numeric: Numeric, carriers: Sequence[int], i: int, q: np.ndarray) -> bool:
    """Whether the links that link `i` carries, and itself, are below its foot."""
    down, branch = np.array(numeric.p[:3], float), {i}
    for k, parent in enumerate(carriers):
        branch |= {k} if parent in branch else set()
    (_, r), (_, tips) = numeric.link_pose(q), numeric.tip_poses(q)
    ways = np.array([x[k] for x in (r, tips) for k in sorted(branch)]) - r[i]
    far = float(np.linalg.norm(ways, axis=1).max())
    size = float(np.linalg.norm(down))
    return size > 0 and far > 0 and float(ways.mean(axis=0) @ down) > HANGING * far * size


def _places(key: LinkClass, pieces: int) -> np.ndarray:
    """Where along a link or segment its sections are known: evenly, and where it carries others; the tip is last."""
    count = max(ROWS // pieces, 5, PER_POINT * key.points * bool(key.rest)) if key.modes else 2
    return np.unique([*np.linspace(0.0, 1.0, count), *key.stations_at])


def _carried(model: Model, i: int) -> tuple[int, float]:
    """The row of the parent's sections that carries a link, and its place s there."""
    tree, keys = model.chain.tree, model.chain.keys
    parent = tree.parents[i]
    if parent < 0:
        return -1, 1.0
    s = 1.0 if tree.at(i) < 0 else keys[parent].stations_at[tree.at(i)]
    places = _places(keys[parent], model.robot.links[model.chain.segments[parent].link].pieces)
    return int(np.argmin(np.abs(places - s))), s


def _between(
    carried: float,
    frames: tuple[np.ndarray, np.ndarray],
    i: int,
    parent: int,
    R_tip: np.ndarray,
    r_tip: np.ndarray,
    tips: np.ndarray,
    bases: np.ndarray,
) -> dict[str, list[float]]:
    """The pose of a link's joint point, with its joint at zero, in the section that carries it."""
    R, r = frames
    if parent < 0:
        Rp, rp = np.eye(3), np.zeros(3)
    elif carried == 1.0:
        Rp, rp = R_tip[parent], r_tip[parent]
    else:
        Rp, rp = R[parent], r[parent] + R[parent] @ (bases[parent] + carried * (tips[parent] - bases[parent]))
    return _mount(Rp, rp, R[i], r[i] + R[i] @ bases[i])


def _mount(Rp: np.ndarray, rp: np.ndarray, R: np.ndarray, r: np.ndarray) -> dict[str, list[float]]:
    """A joint point at `r` with the axes `R` of its link, in a section at `rp` with the axes `Rp`."""
    return {"at": (Rp.T @ (r - rp)).tolist(), "turn": _quaternion(Rp.T @ R)}


def _curvature(link: Link, values: dict[str, float]) -> list[float]:
    """The numbers of the curvature at rest of a link, 1/m."""
    directions, places = (link.rest.directions, link.rest.places) if link.rest else ((), ())
    stations = [f"[{k}]" for k in range(len(places))] or [""]
    return [values[f"{link.name}.rest{station}.{direction}"] for direction in directions for station in stations]


def _base(segment: Segment, link: Link, values: dict[str, float]) -> tuple[float, float, float]:
    """The base of a link's centreline in F_i, m."""
    first = segment.number == 0 and segment.marker is None
    return (-values.get(f"{link.name}.frame_at", 0.0) if first else 0.0, 0.0, 0.0)


def _size(parents: Sequence[int], tips: np.ndarray, bases: np.ndarray, r: np.ndarray) -> float:
    """The reach of the longest branch from the world, m, or how far the frames are apart."""
    reach: list[float] = []
    for i, parent in enumerate(parents):
        reach.append(float(np.linalg.norm(tips[i] - bases[i])) + (reach[parent] if parent >= 0 else 0.0))
    return max(max(reach), float(np.linalg.norm(np.ptp(r, axis=0)))) or 1.0


def _radius(link: Link, values: dict[str, float], size: float) -> float:
    """The radius of the tube, m: that of a thin one with the section's radius of gyration, within bounds."""

    def mean(quantity: str) -> float:
        names = (f"{link.name}.{quantity}", f"{link.name}.section[")
        stations = lambda name: name.startswith(names[1]) and name.endswith(f"].{quantity}")  # noqa: E731
        own = [x for name, x in values.items() if name == names[0] or stations(name)]
        return float(np.mean(own)) if own else 0.0

    bending = max(mean("EIy"), mean("EIz"))
    area = mean("EA") or MODULUS_OVER_DENSITY * mean("rhoA")
    radius = np.sqrt(2 * bending / area) if bending and area else PLAIN * size
    return float(np.clip(radius, SLENDER * size, STOUT * size))


def _bodies(link: Link, segment: Segment) -> Iterator[dict[str, Any]]:
    """The rigid bodies on a segment: where, and a sphere or the box of the same inertia."""
    for body in link.bodies:
        here = segment.first if body.at == "base" else segment.last
        if here and body.mass > 0:
            yield {"tip": body.at == "tip", "at": list(body.com or (0.0, 0.0, 0.0)), **_solid(body)}


def _solid(body: Body) -> dict[str, Any]:
    if body.inertia is not None and any(body.inertia[:3]):
        xx, yy, zz, xy, xz, yz = body.inertia
        moments, axes = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        axes[:, 2] *= np.sign(np.linalg.det(axes))
        edges = np.sqrt(np.maximum(6 * (moments.sum() - 2 * moments) / body.mass, 0.0))
        return {"box": edges.tolist(), "turn": _quaternion(axes)}
    return {"ball": float((3 * body.mass / (4 * np.pi * DENSITY)) ** (1 / 3))}


def _quaternion(R: np.ndarray) -> list[float]:
    """(x, y, z, w) of a rotation matrix."""
    return Rotation.from_matrix(R).as_quat().tolist()
