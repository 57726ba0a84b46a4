"""Poses on SE(3), moved by the exponential map: for the links of the DAE form, and for a floating base.

The exponential itself is :mod:`..algorithms.exponential`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

import numpy as np

from ..algorithms.exponential import Series, cross, exponential
from ..ir.program import Program, Tracer


def algebra_rate(u: np.ndarray, V: np.ndarray) -> np.ndarray:
    """The rate of ``u`` in ``pose = start exp(u)`` at the twist ``V``, row by row, with terms up to order four."""
    first = bracket(u, V)
    return V + first / 2 + bracket(u, first) / 12


def bracket(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The Lie bracket of se(3), row by row, (25)."""
    return np.hstack([cross(a[:, :3], b[:, :3]), cross(a[:, 3:], b[:, :3]) + cross(a[:, :3], b[:, 3:])])


def carried(V: np.ndarray) -> np.ndarray:
    """(6, 6): by a change ``delta`` of a pose, ``pose exp(delta)``, its rate at the twist V (6,), ``-[V, delta]``."""
    return -bracket(np.broadcast_to(V, (6, 6)), np.eye(6)).T


class Space(Protocol):
    """The coordinates of a robot: a change ``u`` (nv,) of them, and its rate."""

    def moved(self, q: Any, u: Any) -> Any:
        """The coordinates (nq,) at ``u`` from ``q``."""

    def rate(self, u: Any, v: Any) -> Any:
        """The rate of ``u`` where the rates are ``v`` (nv,)."""


class Flat:
    """Coordinates that add up: those of a fixed base."""

    def moved(self, q: Any, u: Any) -> Any:
        return q + u

    def rate(self, u: Any, v: Any) -> Any:
        return v


FLAT = Flat()


class Floating:
    """Those behind the pose of a floating base, ``q = [position; quaternion; ...]``, which moves by ``exp(u)``.

    The pose is a product of poses, so the quaternion keeps its length but for rounding.
    """

    def __init__(self, series: Series):
        self.series = series

    def moved(self, q: np.ndarray, u: np.ndarray) -> np.ndarray:
        pose = exponential(np.concatenate([q[3:7], q[:3]]), u[:6], self.series)
        return np.concatenate([pose[4:], pose[:4], q[7:] + u[6:]])

    def rate(self, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        return np.concatenate([algebra_rate(u[None, :6], v[None, :6])[0], v[6:]])


def unit(q: np.ndarray) -> np.ndarray:
    """Coordinates behind the pose of a floating base, the quaternion scaled to length one."""
    out = np.array(q, float)
    out[3:7] /= np.sqrt(sum(out[3:7] * out[3:7]))
    return out


def programs(nq: int, nv: int) -> tuple[Program, Program]:
    """``(q, u) -> (q)`` and ``(u, v) -> (rate)`` of :class:`Floating`, for symbols of any kind."""
    return (
        _traced("moved", {"q": nq, "u": nv}, lambda space, q, u: {"q": space.moved(q, u)}),
        _traced("rate", {"u": nv, "v": nv}, lambda space, u, v: {"rate": space.rate(u, v)}),
    )


def _traced(name: str, sizes: dict[str, int], body: Callable[..., dict]) -> Program:
    tracer = Tracer()
    space = Floating(Series(lambda x: tracer.call("c4", x), lambda x: tracer.call("c5", x)))
    values = (np.array(tracer.input(x, size), dtype=object) for x, size in sizes.items())
    return tracer.program(name, sizes, {x: list(out) for x, out in body(space, *values).items()})
