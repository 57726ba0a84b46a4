"""The motion of axes that a run is given: where they are at the ends of steps, and the accelerations between."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from ..arguments import choice
from ..errors import UsageError
from ..robot_model import RobotModel
from .inputs import floats

Curve = Callable[..., Any]
"""A spline of SciPy, whose `f(t)` is the coordinate and `f(t, 1)` its rate; or `f(t) -> (coordinate, rate)`."""


class GivenMotion:
    """The coordinates of axes whose motion is given, by name, in a run of a `step` that ends at a `duration`.

    At the ends of steps the axes are exactly there. Over a step an axis accelerates evenly, from its rate at the
    beginning to that at the end. Axes that are not named stay where they begin, or go on as their inputs say.
    """

    def __init__(self, model: RobotModel, curves: Mapping[str, Curve], step: float, duration: float):
        chain = model.chain
        places = {k: chain.held_places[k] for k in chain.prescribed}
        at = {k: chain.axis_places[k] if v == chain.base_v + k else v + chain.nq - chain.nv for k, v in places.items()}
        known = {model.q_names[at[k]]: k for k in places}
        for name in curves:
            choice(name, known, 'motion: of what has actuation = "motion" there is no coordinate')
        self.curves = list(curves.values())
        self.axes = [known[name] for name in curves]
        self.names, self.step, self.duration = list(curves), step, duration
        self.of_q, self.of_v = [at[k] for k in self.axes], [places[k] for k in self.axes]

    def at(self, t: float) -> np.ndarray:
        """(2, k): coordinates and rates at a time."""
        found = [_point(curve, t, name) for curve, name in zip(self.curves, self.names, strict=True)]
        return np.array(found, float).reshape(-1, 2).T

    def place(self, t: float, q: np.ndarray, v: np.ndarray) -> None:
        """Put the axes of a state where they are at a time."""
        q[self.of_q], v[self.of_v] = self.at(t)

    def accelerations(self, t: float) -> np.ndarray:
        """(k,): those over the step that begins at a time."""
        end = min(t + self.step, self.duration)
        return np.zeros(len(self.axes)) if end <= t else (self.at(end)[1] - self.at(t)[1]) / (end - t)


def _point(curve: Curve, t: float, name: str) -> tuple[float, float]:
    found = np.ravel(floats(curve(t), f"motion: {name}"))
    if len(found) == 1:
        found = np.append(found, floats(curve(t, 1), f"motion: {name}"))
    if len(found) != 2:
        said = f"motion: {name} gives {len(found)} numbers"
        raise UsageError(f"{said}; give a spline, or a function of t that gives coordinate and rate")
    return float(found[0]), float(found[1])
