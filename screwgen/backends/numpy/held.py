"""Derivatives with inputs as they are given, from those with inputs as a step holds them."""

from __future__ import annotations

import numpy as np

from ...algorithms.held_slopes import held_slopes
from ...arguments import Numbers
from ...topology.chain import Chain
from .numeric import EPSILON, function_of


class HeldChain:
    """The chain rule through what a step of a robot holds of its inputs, at parameters ``p``."""

    def __init__(self, chain: Chain, p: Numbers):
        self.chain, self.p = chain, list(p)
        self.program, self.places = held_slopes(chain)

    def __call__(
        self, q: Numbers, v: Numbers, tau: Numbers, by_q: np.ndarray, by_v: np.ndarray, by_tau: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Derivatives with changes of q (.., nv), v (.., nvz) and inputs (.., n_tau) as given, of those as held."""
        given = {"q": list(q), "v": list(v), "tau": list(tau), "p": self.p}
        program = function_of(self.program)
        found = program({name: given.get(name, ()) for name in self.program.inputs}, EPSILON)[0]
        by_motion = np.zeros((self.chain.n_tau, self.chain.n_changes))
        for (k, column), slope in zip(self.places, found["by_motion"], strict=True):
            by_motion[k, column] += slope
        of_q, of_v = np.hsplit(by_motion, [self.chain.nv])
        return by_q + by_tau @ of_q, by_v + by_tau @ of_v, by_tau * np.array(found["by_tau"], float)
