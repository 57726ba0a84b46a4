"""Where integrators move: the coordinates of a robot, of numbers or of symbols of any kind."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

import numpy as np

from ..algorithms.joint_moves import traced
from ..ir.program import Program
from ..joints.exponential import Series
from ..topology.chain import Chain


class Space(Protocol):
    """The coordinates of a robot: a change ``u`` (nv,) of them, and its rate."""

    def moved(self, q: Any, u: Any) -> Any:
        """The coordinates (nq,) at ``u`` from ``q``."""

    def rate(self, u: Any, v: Any) -> Any:
        """The rate (nv,) of ``u`` where the rates are ``v`` (nvz,); of None that where ``u`` is zero."""


class Flat:
    """Coordinates that add up: those of slides, turns and screws."""

    def moved(self, q: Any, u: Any) -> Any:
        return q + u

    def rate(self, u: Any, v: Any) -> Any:
        return v


FLAT = Flat()


class BesideStates:
    """A space whose ``nv`` rates stand before internal states in ``v``, which move no coordinate."""

    def __init__(self, space: Space, nv: int):
        self.space, self.nv = space, nv

    def moved(self, q: Any, u: Any) -> Any:
        return self.space.moved(q, u[: self.nv])

    def rate(self, u: Any, v: Any) -> Any:
        return self.space.rate(u, v[: self.nv])


class Curved:
    """Coordinates that joints move, of numbers; quaternions keep their lengths but for rounding."""

    def __init__(self, chain: Chain, series: Series):
        self.chain, self.series = chain, series

    def moved(self, q: np.ndarray, u: np.ndarray) -> np.ndarray:
        return self.chain.integrate(q, u, self.series)

    def rate(self, u: np.ndarray | None, v: np.ndarray) -> np.ndarray:
        return v if u is None else self.chain.rate(u, v)


Evaluate = Callable[[Program, dict[str, Any]], dict[str, Any]]


class Replayed:
    """The same of symbols: ``evaluate`` runs a program on them."""

    def __init__(self, chain: Chain, evaluate: Evaluate):
        self.evaluate = evaluate
        sizes, rates = {"q": chain.nq, "u": chain.nv}, {"u": chain.nv, "v": chain.nv}
        self._moved = traced("moved", sizes, q=chain.integrate)
        self._rate = traced("rate", rates, rate=lambda u, v, _: chain.rate(u, v))

    def moved(self, q: Any, u: Any) -> Any:
        return self.evaluate(self._moved, {"q": q, "u": u})["q"]

    def rate(self, u: Any, v: Any) -> Any:
        return v if u is None else self.evaluate(self._rate, {"u": u, "v": v})["rate"]


def replayed(chain: Chain, evaluate: Evaluate) -> Space:
    """The space of a robot's symbols."""
    return beside_states(Replayed(chain, evaluate) if chain.curved else FLAT, chain)


def beside_states(space: Space, chain: Chain) -> Space:
    """The space of a robot's coordinates where it has internal states besides."""
    return BesideStates(space, chain.nv) if chain.n_internal else space
