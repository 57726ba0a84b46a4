"""Robots whose links are cut into welded links by hand: the judge of `segments`."""

from __future__ import annotations

import numpy as np
import random_robots as rr

from screwgen import Robot
from screwgen.spec import Joint, Link, Section, Stations
from screwgen.spec.section import LineProperties
from screwgen.spec.stations import lagrange

NAMES = tuple(LineProperties.model_fields)


def random_divided(seed: int, n_links: int, **limits) -> Robot:
    """A random robot of which every flexible link has 2 to 4 segments."""
    rng = np.random.default_rng(seed)
    given = {"frame_at": 0.0, "no_section_rotation": 0.0, "rigid": 0.1, "second_order": 0.5, "soft": 1.0, **limits}
    table = rr.random_robot(rng, n_links, **given)
    for link in table["links"]:
        if any(n for d, n in link.get("modes", {}).items() if d != "basis"):
            link["segments"] = int(rng.integers(2, 5))
    return Robot.model_validate(table)


def cut(robot: Robot) -> Robot:
    """The same robot with a link of the file for each segment."""
    pieces = [_piece(link, k) for link in robot.links for k in range(link.segments)]
    return robot.model_copy(update={"links": tuple(pieces)})


def _piece(link: Link, k: int) -> Link:
    count = link.segments
    here = {"base": k == 0, "tip": k == count - 1}
    return link.model_copy(
        update={
            "name": f"{link.name}_piece_{k}",
            "length": link.length / count if link.length else None,
            "section": _section(link.section, k / count, (k + 1) / count),
            "joint": link.joint if k == 0 else Joint(axes=()),
            "bodies": tuple(body for body in link.bodies if here[body.at]),
            "segments": 1,
        }
    )


def _section(section: Section | Stations | None, low: float, high: float) -> Section | Stations | None:
    """A section that varies, between two places: its own stations there, and values at the ends."""
    if not isinstance(section, Stations):
        return section
    if section.between == "polynomial":
        places = [low + (high - low) * s for s in section.places]
        rows = [_values(section, lambda values, s=s: lagrange(section.places, values, s)) for s in places]
    else:
        inside = [k for k, s in enumerate(section.places) if low < s < high]
        places = [low, *(section.places[k] for k in inside), high]
        ends = [_values(section, lambda values, s=s: np.interp(s, section.places, values)) for s in (low, high)]
        inner = [_values(section, lambda values, k=k: values[k]) for k in inside]
        rows = [ends[0], *inner, ends[1]]
    at = [0.0, *((s - low) / (high - low) for s in places[1:-1]), 1.0]
    return Stations(stations=[{"at": s, **row} for s, row in zip(at, rows, strict=True)], between=section.between)


def _values(section: Stations, at) -> dict[str, float]:
    return {name: float(at(section.values(name))) for name in NAMES if section.states(name)}


def state(model, seed: int, angle=2.0) -> tuple:
    """q, v, tau and w_ext of a moderate motion."""
    rng, m, r = np.random.default_rng(seed), model.n_joints, model.nq - model.n_joints
    q = np.append(rng.uniform(-angle, angle, m), rng.uniform(-2e-3, 2e-3, r))
    v = np.append(rng.uniform(-1, 1, m), rng.uniform(-0.05, 0.05, r))
    return q, v, rng.uniform(-5, 5, m), rng.uniform(-5, 5, (model.n_links, 6))
