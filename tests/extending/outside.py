"""A robot with something that the product does not contain goes through the checks of the matrix of features."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from conformance.cases import Case
from conformance.checks import CHECKS
from helpers import EPS, QUICK, Model, relative

from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.estimator import Estimator

every_check = pytest.mark.parametrize(
    "check",
    ["DAE form", "CasADi", "JAX", "C, fused", "C, modular", "lanes", "derivatives", "derivatives of steps", "runs"],
)
"""What is built on the dynamics; runs are those of C, of CasADi and of rollouts."""


class Outside(Case):
    """A model in a state q, v, tau, w_ext, with the accelerations, and wrenches, that somebody else expects there."""

    def __init__(self, model: Model, given: tuple, vdot, wrench=None):
        super().__init__({})
        self.expected = [np.asarray(x) for x in (vdot, wrench) if x is not None]
        mass_matrix = model.numpy().mass_matrix(given[0])
        condition = np.linalg.cond(mass_matrix)
        tolerance = max(1e-10, 50 * EPS * condition)
        judge = SimpleNamespace(given=given, tolerance=tolerance, errors=self._errors, condition=condition)
        vars(judge).update(
            vdot=self.expected[0], forces=np.asarray(given[2]), taken=np.zeros(0), mass_matrix=mass_matrix
        )
        vars(self).update(model=model, judge=judge)

    @property
    def acting(self) -> np.ndarray:
        """The inputs, which nothing limits."""
        return self.given[2]

    def acting_at(self, v: np.ndarray) -> np.ndarray:
        """The same in any state."""
        return self.acting

    def _errors(self, *found) -> dict[int, float]:
        pairs = zip(found, self.expected, strict=False)
        return {k: relative(np.reshape(x, expected.shape), expected) for k, (x, expected) in enumerate(pairs)}

    def holds(self, check: str) -> None:
        """In NumPy it moves as it is expected to, and what else is built on that agrees."""
        assert max(self._errors(*self.model.numpy().forward_dynamics(*self.given)).values()) <= self.tolerance
        CHECKS[check].run(self)


def filters_agree(model: Model, q, v, tau, w_ext, h: float) -> None:
    """The filter in C does what that in Python does, over a step of h seconds and a measured acceleration."""
    noise = Noise(np.array([0.02] * 5 + [1e-4]), 1e-10, 1e-3, 1e-5, 0.05, 0.02)
    filters = CompiledEstimator(model, flags=QUICK), Estimator(model)
    for e in filters:
        e.start(q, v, 1e-2, 1e-1, noise)
        e.predict(tau, w_ext, h)
        e.update(tau, w_ext, acceleration=np.array([1.0, -2.0, 3.0]))
    assert relative(*(np.concatenate(e.state) for e in filters)) < 1e-9
    assert relative(*(e.covariance for e in filters)) < 1e-6
    assert relative(*(e.innovations["acceleration"].value for e in filters)) < 1e-9
