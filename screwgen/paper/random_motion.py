"""The judge: an arm in motion, with every quantity of the paper taken from its definition.

Two links in the paper's world: sections do not turn by themselves, (5)-(8), joints have two axes, frames sit inside
the links.  Positions are differentiated twice in the inertial frame; velocities, twists and accelerations follow from
that, inertia from quadrature over elements, wrenches from the balance of momentum.  No formula of the derivation is
used.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.linalg import inv

from .cauchy_state import add_cauchy
from .jets import constant
from .joint_values import add_joint_values
from .modal_rows import add_system
from .moving_link import MovingLink

INDICES = {"i-1": 0, "i": 1, "1": 0, "2": 1}
"""What the paper calls the judge's two links."""


class RandomMotion:
    """One instant of a random motion.

    ``values`` holds the value of every symbol by name: an array of its shape, a field with one more axis in front,
    (points, r, c); ``weights`` the quadrature weights (points,) by link index.  Links are joined by interaction
    wrenches, or, if ``isolated``, each is moved by its external wrenches alone.  Accelerations are arbitrary: ``load``
    is the distributed load per mass that makes every element obey Newton's law; the paper has none.
    """

    def __init__(self, seed: int = 0, isolated: bool = False):
        random = np.random.default_rng(seed)
        self.values: dict[str, np.ndarray] = {}
        self.weights: dict[str, np.ndarray] = {}
        self.gravity = 5 * random.normal(size=(3, 1))
        self.links = [MovingLink(random, self.gravity) for _ in range(2)]
        self._move()
        self._wrenches(random, isolated)
        add_system(self.values, self.links)
        add_cauchy(self.values, self.links)
        add_joint_values(self.values, self.links)
        for index, k in INDICES.items():
            self.weights[index] = self.links[k].weights
            self.values.update({f"{name}:{index}": value for name, value in self.links[k].values.items()})
            self.values[f"g:{index}"] = self.gravity

    def _move(self) -> None:
        """Kinematics from base to tip."""
        R, tip = constant(np.eye(3)), constant(np.zeros((3, 1)))
        for link in self.links:
            R, tip = link.move(R, tip)

    def _wrenches(self, random: np.random.Generator, isolated: bool) -> None:
        """External wrenches, then the interaction wrenches from the balance of each link, tip to base."""
        inertial = np.zeros((6, 1))  # of the next link on this one, about the inertial origin
        for link in reversed(self.links):
            link.load(random, isolated)
            v = link.values
            v["W"] = v["Ad"].T @ inertial
            v["W_below"] = np.zeros((6, 1)) if isolated else v["W_star"] + v["W"] - v["total"]
            inertial = inv(v["Ad"]).T @ v["W_below"]
        self.values["W:0"] = inertial


@lru_cache(maxsize=16)
def instant(seed: int, isolated: bool = False) -> RandomMotion:
    """The motion of a seed, made once: to be read, not changed."""
    return RandomMotion(seed, isolated)
