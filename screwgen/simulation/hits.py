"""Joint axes beyond their limits during a run: where, when, how deep, and with which force of a stop."""

from __future__ import annotations

import ctypes
import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..arguments import Numbers
from ..robot_model import RobotModel
from ..spec.axis_laws import SIDES
from ..spec.limit import Limit

MOST = 8
"""Hits of one axis and side that text lists one by one."""
ROOM = 1024
"""Hits that the C keeps before it hands them over, beyond one for each limit."""


class LimitWarning(UserWarning):
    """A joint leaves a range that no stop holds it in, or is sent beyond a limit."""


@dataclass(frozen=True)
class Hit:
    """A joint axis beyond one of its limits, from its first contact until it is back.

    Times are interpolated between the ends of steps; `depth` and `force` are the largest at the ends of steps.
    """

    axis: str
    """The name of its coordinate, `arm.joint[0]`."""
    side: str
    """`lower` or `upper`."""
    begin: float
    """s; a run that starts beyond a limit begins with a hit."""
    end: float | None
    """s; None: still there when the run ended."""
    depth: float
    """How far beyond the limit, rad, of slides m."""
    force: float
    """Of the stop, N·m, of slides N; 0 where a range has no stop."""
    stop: bool
    """Whether the limit has a stop."""

    def __str__(self) -> str:
        turns = ".joint[" in self.axis
        until = "to the end" if self.end is None else f"to {self.end:.6g} s"
        what = f"on its {self.side} stop" if self.stop else f"past its {self.side} limit"
        force = f", at most {self.force:.4g} {'N·m' if turns else 'N'}" if self.stop else ""
        depth = f"{self.depth:.4g} {'rad' if turns else 'm'} deep"
        return f"{self.axis} {what} from {self.begin:.6g} s {until}: {depth}{force}"


def lines(hits: Sequence[Hit]) -> list[str]:
    """A line per hit, or one for all of an axis and a side that are many."""
    groups: dict[tuple[str, str], list[Hit]] = {}
    for hit in hits:
        groups.setdefault((hit.axis, hit.side), []).append(hit)
    out: list[str] = []
    for (axis, side), own in groups.items():
        if len(own) <= MOST:
            out += map(str, own)
            continue
        worst = max(own, key=lambda hit: hit.depth)
        what = "stop" if worst.stop else "limit"
        times = f"{len(own)} times, first at {own[0].begin:.6g} s, last at {own[-1].begin:.6g} s"
        out.append(f"{axis} at its {side} {what} {times}; the deepest: {worst}")
    return out


class Bound(NamedTuple):
    """One limit of an axis, by its number among the joint coordinates, and the stop there (stiffness 0: none)."""

    axis: int
    side: str
    at: float
    stiffness: float
    damping: float


def bounds(model: RobotModel, p: Numbers) -> list[Bound]:
    """The limits of all axes, at the parameters `p`, and the ends of the reach of linkages where none are stated."""
    values, out, first = dict(zip(model.parameter_names, map(float, p), strict=True)), list[Bound](), 0
    for link in model.robot.links:
        for axis in range(len(link.joint.limits or ())):
            own = {name: values.get(f"{link.name}.joint.limits[{axis}].{name}") for name in Limit.model_fields}
            push = own["stiffness"] or 0.0, own["damping"] or 0.0
            out += [Bound(first + axis, side, at, *push) for side in SIDES if (at := own[side]) is not None]
        first += len(link.joint.axes)
    stated = {(bound.axis, bound.side) for bound in out}
    for _, axis, travel, numbers in model.chain.travel_numbers(p):
        ends = [x for x in zip(SIDES, travel.reach(*numbers), strict=True) if (axis, x[0]) not in stated]
        out += [Bound(axis, side, end, 0.0, 0.0) for side, end in ends if math.isfinite(end)]
    return out


class _Plan(ctypes.Structure):
    """``shim_hits`` of the library."""

    _fields_ = (
        ("count", ctypes.c_int),
        *((name, ctypes.c_void_p) for name in ("q", "v", "side", "at", "stiffness", "damping")),
        *((name, ctypes.c_void_p) for name in ("begin", "depth", "force", "before")),
        ("last", ctypes.c_double),
        ("rows", ctypes.c_void_p),
        ("room", ctypes.c_int),
        ("used", ctypes.c_int),
    )


class Hits:
    """Gathers the hits of a run, step by step, in Python or, by :attr:`plan`, in C."""

    def __init__(self, model: RobotModel, p: Numbers):
        self.bounds, self.names, chain = bounds(model, p), model.chain.axis_names, model.chain
        axes = np.array([x.axis for x in self.bounds], int)
        self.q, self.v = np.array(chain.axis_places, np.int32)[axes], (axes + chain.base_v).astype(np.int32)
        self.side = np.array([SIDES[x.side] for x in self.bounds], float)
        self.at, self.stiffness, self.damping = (
            np.array([getattr(x, name) for x in self.bounds], float) for name in ("at", "stiffness", "damping")
        )
        count = len(self.bounds)
        self.begin, self.before = np.full(count, np.nan), np.zeros(count)
        self.depth, self.force = np.zeros(count), np.zeros(count)
        self.last = math.nan
        self.found: list[Hit] = []

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> None:
        """Look at the state at the end of a step."""
        if not self.bounds:
            return
        deep, rate = self.side * (q[self.q] - self.at), self.side * v[self.v]
        force = np.maximum(0.0, self.stiffness * deep + self.damping * rate)
        for i in map(int, np.flatnonzero((deep > 0) | ~np.isnan(self.begin))):
            inside, crossing = not np.isnan(self.begin[i]), t
            if not np.isnan(self.last) and deep[i] != self.before[i]:
                crossing = self.last + (t - self.last) * self.before[i] / (self.before[i] - deep[i])
            if deep[i] <= 0:
                self._keep(i, self.begin[i], crossing, self.depth[i], self.force[i])
                self.begin[i] = np.nan
            elif inside:
                self.depth[i], self.force[i] = max(self.depth[i], deep[i]), max(self.force[i], force[i])
            else:
                self.begin[i], self.depth[i], self.force[i] = crossing, deep[i], force[i]
        self.before, self.last = deep, t

    def _keep(self, i: int, begin: float, end: float | None, depth: float, force: float) -> None:
        x = self.bounds[i]
        numbers = float(begin), None if end is None else float(end), float(depth), float(force)
        self.found.append(Hit(self.names[x.axis], x.side, *numbers, x.stiffness > 0))

    @property
    def all(self) -> tuple[Hit, ...]:
        """The hits so far, by their beginning; those that have not ended are without an end."""
        self.drain()
        kept = list(self.found)
        for i in map(int, np.flatnonzero(~np.isnan(self.begin))):
            self._keep(i, self.begin[i], None, self.depth[i], self.force[i])
        self.found, out = kept, self.found
        return tuple(sorted(out, key=lambda hit: hit.begin))

    # in C --------------------------------------------------------------------------------------

    _plan: _Plan | None = None

    @property
    def plan(self) -> _Plan:
        """The struct of the library that gathers into this object's arrays."""
        if self._plan is None:
            room = ROOM + len(self.bounds)
            self._rows = np.zeros((room, 5))
            names = ("q", "v", "side", "at", "stiffness", "damping", "begin", "depth", "force", "before")
            arrays = (getattr(self, name).ctypes.data for name in names)
            self._plan = _Plan(len(self.bounds), *arrays, math.nan, self._rows.ctypes.data, room, 0)
        return self._plan

    def drain(self) -> None:
        """Take over what the C has gathered."""
        if self._plan is not None:
            for i, *numbers in self._rows[: self._plan.used].tolist():
                self._keep(int(i), *numbers)
            self._plan.used = 0


# ------------------------------------------------------------------------------ warnings


def warn(hits: Sequence[Hit]) -> None:
    """A :class:`LimitWarning` where a joint has left a range that has no stop."""
    loose = [hit for hit in hits if not hit.stop]
    if loose:
        more = f"; {len(loose) - 1} more such" if len(loose) > 1 else ""
        what = "nothing holds it there: give the limit a stiffness, or change what drives the joint"
        warnings.warn(f"{loose[0]}; {what}{more}", LimitWarning, stacklevel=3)


def warn_goals(model: RobotModel, p: Numbers, points: Sequence[tuple[float, Sequence[float]]]) -> None:
    """A :class:`LimitWarning` where a reference of the joints, at one of its set points, is beyond a limit."""
    for bound in bounds(model, p):
        worst = max((q[bound.axis] for _, q in points), key=lambda x: SIDES[bound.side] * x)
        if SIDES[bound.side] * (worst - bound.at) > 0:
            name = model.chain.axis_names[bound.axis]
            unit = "rad" if ".joint[" in name else "m"
            what = f"the controller sends {name} to {worst:g} {unit}, past its {bound.side} limit {bound.at:g} {unit}"
            warnings.warn(f"{what}; move the set point, or the limit", LimitWarning, stacklevel=3)
            return
