"""The motion of axes and of a base that a run is given: where they are at the ends of steps, and how they get there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any

import numpy as np

from ..arguments import choice
from ..errors import UsageError
from ..joints.exponential import quaternion_rate
from ..joints.free import MOVING
from ..robot_model import RobotModel
from ..spec.base import BASE_MOTION
from .inputs import floats

Curve = Callable[..., Any]
"""A spline of SciPy, whose `f(t)` is the coordinate and `f(t, 1)` its rate; or `f(t) -> (coordinate, rate)`.

Of a base the coordinates are six, its place and its rotation vector, or seven, its place and its quaternion.
"""
BASE = "base"
"""The name of a base among the curves."""

WHOLE = 1 - 1e-9
"""The share of a run that a spline must reach."""
LOOKED_AT = np.linspace(0.011, 0.989, 41)
"""The shares of a run at which the rates of a function are compared with differences of its coordinates."""
APART, MISSED = 1e-5, 0.05
"""How far apart these are taken, by the duration, and how far a rate may miss them, by the largest."""


class GivenMotion:
    """The coordinates of axes whose motion is given, by name, in a run of a `step` that ends at a `duration`.

    At the ends of steps the axes are exactly there. Over a step an axis accelerates evenly, from its rate at the
    beginning to that at the end; of a base the components of its twist do, in its own axes. What is not named stays
    where it begins, or goes on as its inputs say.
    """

    def __init__(self, model: RobotModel, curves: Mapping[str, Curve], step: float, duration: float):
        chain, at = model.chain, _places(model)
        known = {model.q_names[place]: k for k, place in at.items()}
        for name in curves:
            choice(name, [BASE] * chain.moving + [*known], "motion: of what moves as is given there is no coordinate")
        for name, curve in curves.items():
            _check_curve(curve, name, (6, 7) if name == BASE else (1,), duration)
        self.base, self.step, self.duration = curves.get(BASE), step, duration
        self.curves = {name: curve for name, curve in curves.items() if name != BASE}
        own, led = [known[name] for name in self.curves], 6 * (self.base is not None)
        self.axes = [*range(chain.n_tau)[chain.inputs[BASE_MOTION]], *own] if led else own
        self._found: dict[float, tuple[np.ndarray, np.ndarray]] = {}
        self.of_q, self.of_v = [at[k] for k in own], [*range(led), *(chain.held_places[k] for k in own)]

    def at(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        """Coordinates and rates at a time, those of the base first."""
        if t not in self._found:
            base = [_base(self.base, t)] if self.base is not None else []
            points = [*base, *(_point(curve, t, name, (1,)) for name, curve in self.curves.items())]
            q, v = (np.concatenate([np.zeros(0), *parts]) for parts in zip(*points, strict=True))
            self._found = {t: (q, v)}
        return self._found[t]

    def place(self, t: float, q: np.ndarray, v: np.ndarray) -> None:
        """Put what is given of a state where it is at a time."""
        given, v[self.of_v] = self.at(t)
        if self.base is not None:
            pose, given = np.split(given, [7])
            q[:3], q[3:7] = pose[:3], pose[3:] if pose[3:] @ q[3:7] >= 0 else -pose[3:]
        q[self.of_q] = given

    def accelerations(self, t: float) -> np.ndarray:
        """(k,): those over the step that begins at a time; at the end of a run those over the last of it."""
        t = t if t < self.duration else max(self.duration - self.step, 0.0)
        end = min(t + self.step, self.duration)
        before = self.at(t)[1]
        return (self.at(end)[1] - before) / (end - t)


def given_axes(model: RobotModel) -> list[str]:
    """The names of the coordinates of axes whose motion is given."""
    return [model.q_names[place] for place in _places(model).values()]


def _places(model: RobotModel) -> dict[int, int]:
    """The places in `q` of these coordinates, by the numbers of their axes; of an elastic drive that of its rotor."""
    chain, held = model.chain, model.chain.held_places
    own = lambda k: chain.place_in_q(held[k])  # noqa: E731
    return {k: own(k) for k in chain.prescribed}


def _check_curve(curve: Curve, name: str, sizes: tuple[int, ...], duration: float) -> None:
    """Refuse a spline that ends before the run, and a function whose rates are not those of its coordinates."""
    if not callable(curve):
        raise UsageError(f"motion: {name} is no function of t; give a spline, or f(t) -> (coordinate, rate)")
    known = getattr(curve, "x", None)
    if known is not None:
        ends = float(np.min(known)), float(np.max(known))
        if getattr(curve, "extrapolate", None) != "periodic" and not (ends[0] <= 0 and ends[1] >= duration * WHOLE):
            said = f"is a spline from {ends[0]:g} to {ends[1]:g} s"
            raise UsageError(f"motion: {name} {said}; the run goes from 0 to {duration:g} s")
        return
    apart = APART * duration
    points = [[_point(curve, t + k * apart, name, sizes) for k in (-1, 0, 1)] for t in duration * LOOKED_AT]
    slopes = np.array([(after[0] - before[0]) / (2 * apart) for before, _, after in points])
    rates = np.array([there[1] for _, there, _ in points])
    off, size = np.abs(slopes - rates).max(axis=1), max(np.abs(slopes).max(), np.abs(rates).max())
    if (off > MISSED * size).sum() > len(LOOKED_AT) // 8:
        k = int(off.argmax())
        j = int(np.abs(slopes[k] - rates[k]).argmax())
        said = f"gives the rate {rates[k][j]:.4g} at t = {duration * LOOKED_AT[k]:.3g} s"
        raise UsageError(f"motion: {name} {said}, its coordinate has {slopes[k][j]:.4g}; give the coordinate's rate")


def _base(curve: Curve, t: float) -> tuple[np.ndarray, np.ndarray]:
    """Pose (7,) and twist (6,), in axes of the base."""
    at, rate = _point(curve, t, BASE, (6, 7))
    if len(at) == 6:
        half, turned = _half_turn(at[3:]), _turned(at[3:], rate[3:])
        at, rate = np.append(at[:3], half), np.append(rate[:3], quaternion_rate(half, turned))
    size = float(np.linalg.norm(at[3:]))
    if not size > 0:
        raise UsageError(f"motion: {BASE} has a quaternion of zeros at t = {t:g} s; give one of length 1")
    at[3:], rate[3:] = at[3:] / size, rate[3:] / size
    return at, MOVING.rates_of(at, rate)


def _half_turn(turn: np.ndarray) -> np.ndarray:
    """The quaternion of a rotation vector."""
    angle = float(np.linalg.norm(turn))
    return np.append(np.cos(angle / 2), turn * (np.sinc(angle / (2 * np.pi)) / 2))


def _turned(turn: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """The angular velocity, in turned axes, of a rotation vector that changes at a rate."""
    angle = float(np.linalg.norm(turn))
    a = np.sinc(angle / (2 * np.pi)) ** 2 / 2  # (1 - cos) / angle², without cancellation
    b = (1 - np.sinc(angle / np.pi)) / angle**2 if angle > 1e-3 else 1 / 6 - angle**2 / 120
    across = np.cross(turn, rate)
    return rate - a * across + b * np.cross(turn, across)


def _point(curve: Curve, t: float, name: str, sizes: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray]:
    """Coordinates and rates, as many as one of the `sizes` says."""
    found = np.ravel(floats(curve(t), f"motion: {name}"))
    if len(found) in sizes:
        with suppress(TypeError):  # a function of t alone
            found = np.append(found, np.ravel(floats(curve(t, 1), f"motion: {name}")))
    if len(found) not in [2 * n for n in sizes]:
        said = f"motion: {name} gives {len(found)} numbers"
        what = "coordinate and rate" if sizes == (1,) else "place and rotation vector, or quaternion, with their rates"
        raise UsageError(f"{said}; give a spline, or a function of t that gives {what}")
    at, rate = np.split(found, 2)
    return at, rate
