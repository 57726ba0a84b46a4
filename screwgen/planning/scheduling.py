"""Over what gains are scheduled: a grid of joint coordinates and loads, and where something lies in it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product

import numpy as np

from ..arguments import Numbers, real_numbers
from ..errors import UsageError
from ..robot_model import RobotModel
from .make import scaled
from .refusals import ROUNDING

MOST = 400
"""Vertices of a grid at most."""


@dataclass(frozen=True, eq=False)
class Grid:
    """Scheduling variables with their values: coordinates of joints, and factors of parameters, which are loads."""

    names: tuple[str, ...]
    joints: tuple[int, ...]
    """Of each variable the joint whose coordinate it is; -1: it is a load."""
    values: tuple[np.ndarray, ...]
    """Of each variable, ascending, two at least."""

    @classmethod
    def of(cls, model: RobotModel, given: Mapping[str, Numbers]) -> Grid:
        """Of values by names of joint coordinates and patterns of parameters; raises UsageError."""
        own, names = model.q_names[: model.n_joints], tuple(given)
        for name in names:
            if name not in own:
                model.chain.parameters.chosen(name)
        joints = tuple(own.index(name) if name in own else -1 for name in names)
        values = tuple(_ascending(name, x) for name, x in given.items())
        for j, name, x in zip(joints, names, values, strict=True):
            lower, upper = model.chain.limits[j] if j >= 0 else (0.0, np.inf)
            if x[0] < lower - ROUNDING or x[-1] > upper + ROUNDING or (j < 0 and x[0] <= 0):
                raise UsageError(
                    f"grid: {name}: goes from {x[0]:g} to {x[-1]:g}; its limits are {lower:g} and {upper:g}"
                )
        if (count := int(np.prod([len(x) for x in values]))) > MOST:
            raise UsageError(f"grid: has {count} vertices; {MOST} are allowed, so take fewer values")
        return cls(names, joints, values)

    @property
    def loads(self) -> tuple[str, ...]:
        """The variables that are no coordinates."""
        return tuple(name for name, j in zip(self.names, self.joints, strict=True) if j < 0)

    @property
    def vertices(self) -> np.ndarray:
        """(V, k): the last variable changes fastest."""
        return np.array(list(product(*self.values))).reshape(-1, len(self.values))

    @property
    def middles(self) -> np.ndarray:
        """(c, k): the middles of the cells."""
        between = [(x[1:] + x[:-1]) / 2 for x in self.values]
        return np.array(list(product(*between))).reshape(-1, len(self.values))

    def drawn(self, rng: np.random.Generator, count: int) -> np.ndarray:
        """(count, k): random points within."""
        lower, upper = ([x[end] for x in self.values] for end in (0, -1))
        return rng.uniform(lower, upper, (count, len(self.values)))

    def point(self, reference: np.ndarray, loads: np.ndarray) -> np.ndarray:
        """(k,): the variables at references of the joints and loads."""
        rest = iter(loads)
        return np.array([reference[j] if j >= 0 else next(rest) for j in self.joints])

    def corners(self, point: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The vertices of the cell of a point, and their weights; points outside are taken at the edge."""
        places, weights = np.zeros(1, int), np.ones(1)
        for x, values in zip(point, self.values, strict=True):
            k = int(np.clip(np.searchsorted(values, x, "right") - 1, 0, len(values) - 2))
            share = min(max((x - values[k]) / (values[k + 1] - values[k]), 0.0), 1.0)
            places = np.add.outer(places * len(values), [k, k + 1]).ravel()
            weights = np.multiply.outer(weights, [1.0 - share, share]).ravel()
        return places, weights

    def posture(self, point: np.ndarray, others: np.ndarray) -> np.ndarray:
        """The joints (n_joints,) at a point; those that are no variables stand as in `others`."""
        q = others.copy()
        for j, x in zip(self.joints, point, strict=True):
            if j >= 0:
                q[j] = x
        return q

    def parameters(self, model: RobotModel, values: np.ndarray, point: np.ndarray) -> np.ndarray:
        """The parameters of a model under the loads at a point."""
        each = zip(self.names, self.joints, point, strict=True)
        return scaled(model, values, {name: x for name, j, x in each if j < 0})


def _ascending(name: str, given: Numbers) -> np.ndarray:
    found = real_numbers(given)
    if (
        found is None
        or found.ndim != 1
        or len(found) < 2
        or not np.isfinite(found).all()
        or (np.diff(found) <= 0).any()
    ):
        raise UsageError(f"grid: {name}: must have two or more finite numbers, ascending")
    return found
