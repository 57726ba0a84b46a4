"""The curves below the picture of a page: joints with their set points, tips of links, torques, energy."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..plotting.curves import NOTHING
from ..simulation.motion import displacements
from ..simulation.runs import Run
from .pack import POINTS, curve

if TYPE_CHECKING:
    from ..model import Model

COLORS = 8
"""Of links, in templates/view/style.css."""
KINDS = (
    ("Joint angles", "rad", "q", ".joint["),
    ("Slides", "m", "q", ".slide["),
    ("Torques", "N·m", "tau", ".torque["),
    ("Forces of drives", "N", "tau", ".force["),
)
"""Title, unit, where the numbers are, and what their names have."""


class Curve(NamedTuple):
    """A quantity over time: its label, the name of its colour, the number of its dashes, its set points."""

    label: str
    values: np.ndarray
    color: str
    dash: int = 0
    goal: np.ndarray | None = None


def panels(run: Run, model: Model, goals: np.ndarray | None = None) -> list[dict[str, Any]]:
    """The panels of a run that show anything; `goals` (n_joints, N): set points of its joints."""
    found = {title: (unit, run.t, _of_axes(run, model, where, part, goals)) for title, unit, where, part in KINDS}
    rows = np.unique(np.linspace(0, len(run.t) - 1, min(len(run.t), 4 * POINTS)).round().astype(int))
    found["Bending at tips"] = "m", run.t[rows], list(_tips(model, run.q[rows]))
    kinetic, potential = run.energy.T
    energies = {"kinetic": kinetic, "potential": potential, "total": kinetic + potential}
    found["Tip position"] = "m", run.t, [Curve(x, y, x) for x, y in zip("xyz", run.tip_position.T, strict=True)]
    found["Energy"] = "J", run.t, [Curve(name, y, name) for name, y in energies.items()]
    return [
        {"title": title, "unit": unit, "curves": [part for x in curves for part in _drawn(x, t)]}
        for title, (unit, t, curves) in found.items()
        if max((np.abs(x.values).max() for x in curves), default=0.0) > NOTHING
    ]


def _drawn(x: Curve, t: np.ndarray) -> Iterator[dict[str, Any]]:
    if x.goal is not None:
        yield curve(f"{x.label}, set point", t, x.goal, x.color, goal=True)
    yield curve(x.label, t, x.values, x.color, x.dash)


def _of_axes(run: Run, model: Model, where: str, part: str, goals: np.ndarray | None) -> list[Curve]:
    """The coordinates, or the torques, of joint axes whose names have `part`, in the colours of their links."""
    names = getattr(run, f"{where}_names")
    owners = [link.name for link in model.robot.links]
    joints = [name for name in names if ".joint[" in name or ".slide[" in name]
    out = []
    for k, name in enumerate(names):
        if part not in name:
            continue
        link, number = name.split(part)
        axis, i = int(number[:-1]), owners.index(link)
        goal = goals[joints.index(name)] if where == "q" and goals is not None else None
        label = _axis(model.robot.links[i], axis)
        out.append(Curve(label, getattr(run, where)[:, k], f"c{i % COLORS}", axis, goal))
    return out


def _axis(link: Any, axis: int) -> str:
    """What an axis is called: its link, and of several about what it turns, or along what it slides."""
    name, screws = link.name.replace("_", " "), link.joint.screws
    if len(screws) < 2:
        return str(name)
    way = np.abs(screws[axis].axis)
    letter = "xyz"[int(way.argmax())] if np.isclose(way.max(), np.linalg.norm(way)) else f"axis {axis + 1}"
    return f"{name} {letter}"


def _tips(model: Model, q: np.ndarray) -> Iterator[Curve]:
    """How far the tips of flexible links are from their undeformed centrelines, across these, link by link."""
    for i, link in enumerate(model.robot.links):
        if not model.chain.keys[model.chain.firsts[i]].modes:
            continue
        u = displacements(model, q, i, [1.0])[:, 0]
        for k, letter in ((1, "y"), (2, "z")):
            if np.abs(u[:, k]).max() > NOTHING:
                yield Curve(f"{link.name.replace('_', ' ')} {letter}", u[:, k], f"c{i % COLORS}", k - 1)
