"""The curves below the picture of a page: joints with their set points, tips of links, torques, energy."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from ..model import Model
from ..plotting.curves import AXIS_CURVES, NOTHING, AxisCurves
from ..plotting.demands import axis_word
from ..simulation.motion import tip_deflections
from ..simulation.runs import Run
from .pack import POINTS, curve

COLORS = 8
"""Of links, in templates/view/style.css."""


class Curve(NamedTuple):
    """A quantity over time: its label, the name of its colour, the number of its dashes, its set points."""

    label: str
    values: np.ndarray
    color: str
    dash: int = 0
    goal: np.ndarray | None = None


def panels(run: Run, model: Model, goals: np.ndarray | None = None) -> list[dict[str, Any]]:
    """The panels of a run that show anything; `goals` (n_joints, N): set points of its joints."""
    found = {x.title: (x.unit, run.t, _of_axes(run, model, x, goals)) for x in AXIS_CURVES if x.array in run.arrays}
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


def _of_axes(run: Run, model: Model, x: AxisCurves, goals: np.ndarray | None) -> list[Curve]:
    """The curves of a panel of axes, in the colours of their links."""
    names, values = run.names_of(x.array), run.arrays[x.array]
    owners = [link.name for link in model.robot.links]
    joints = [name for name in names if ".joint[" in name or ".slide[" in name]
    out = []
    for k, name in enumerate(names):
        if x.word not in name:
            continue
        link, number = name.split(x.word)
        axis, i = int(number[:-1]), owners.index(link)
        goal = goals[joints.index(name)] if x.kind == "goal" and goals is not None else None
        label = f"{link.replace('_', ' ')} {axis_word(model.robot.links[i], axis)}".strip()
        out.append(Curve(label, values[:, k], f"c{i % COLORS}", axis, goal))
    return out


def _tips(model: Model, q: np.ndarray) -> Iterator[Curve]:
    """How far the tips of flexible links are from their undeformed centrelines, across these, link by link."""
    for i, u in tip_deflections(model, q).items():
        for k, letter in ((1, "y"), (2, "z")):
            if np.abs(u[:, k]).max() > NOTHING:
                yield Curve(f"{model.robot.links[i].name.replace('_', ' ')} {letter}", u[:, k], f"c{i % COLORS}", k - 1)
