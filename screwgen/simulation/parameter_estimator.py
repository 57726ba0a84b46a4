"""The estimator that also finds parameters of the robot: they are states that change as a random walk.

An example: an arm picks up a payload. The filter's model has another mass at the tip, so its innovations grow; the
covariance says how they go with the mass, and an update moves it. The derivatives by parameters are traced.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..algorithms.measurement import Measurement
from ..algorithms.measurement_slopes import expected_along
from ..algorithms.parameter_slopes import Differentiable, along
from ..algorithms.robot_functions import BY_NAME
from ..algorithms.robot_programs import held_inputs
from ..arguments import Given
from ..errors import UsageError
from ..ir.program import Program
from ..lazily import linalg
from ..robot_model import RobotModel
from .estimator import AtParameters, Compared, Estimator


@dataclass(frozen=True)
class ParameterState:
    """A parameter that a filter finds, in its unit."""

    parameter: str
    """Its name, as ``forearm.bodies[0].mass``."""
    deviation: float
    """The standard deviation of its value at the start."""
    density: float = 0.0
    """The variance that it gains per second, as a random walk: how fast it may change."""
    lower: float = -math.inf
    """The least value that it is given; of those that must be positive a millionth of the start at least."""
    upper: float = math.inf

    def __post_init__(self) -> None:
        for name in ("deviation", "density"):
            if not 0 <= getattr(self, name) < math.inf:
                raise UsageError(f"{self.parameter}: {name} is {getattr(self, name)}; it must be a number >= 0")
        if not self.lower < self.upper:
            raise UsageError(f"{self.parameter}: lower is {self.lower}; it must be less than upper, {self.upper}")


LEAST = 1e-6
"""Of a parameter that must be positive: the least value, over that at the start."""


class ParameterEstimator(Estimator):
    """The filter in NumPy over q, v and ``states``, parameters of the robot; the rest as of :class:`.Estimator`.

    ``covariance`` has their rows behind those of v. Robots with loops are refused, and parameters of what a
    step holds of its inputs, as limits of efforts.
    """

    def __init__(
        self,
        model: RobotModel,
        states: Sequence[ParameterState],
        parameters: Given = None,
        measurements: Sequence[str | Measurement] | None = None,
    ):
        model.chain.refuse_loops("filter of parameters", "leave the parameters out")
        self.states = tuple(states)
        super().__init__(model, parameters, measurements)
        places = [model.chain.parameters.place(one.parameter) for one in self.states]
        if len(set(places)) < len(places) or not places:
            raise UsageError("states: each parameter must be named once, and one at least; leave out the others")
        self._refuse_held(places)
        self._places, self._begin = places, self._p[places]
        own = model.chain.parameters
        least = np.where(own.least[places] == 0.0, np.maximum(0.0, LEAST * self._begin), -np.inf)
        self._low = np.maximum([one.lower for one in self.states], least)
        self._high = np.array([one.upper for one in self.states])
        if ((self._begin < self._low) | (self._begin > self._high)).any():
            raise UsageError(f"states: values at the start, {self._begin.tolist()}, are not within their bounds")
        self._P = self._with_parameters(self._P)

    def _refuse_held(self, places: Sequence[int]) -> None:
        """Refuse parameters, at these places, of what a step holds of its inputs: derivatives are at held inputs."""
        nodes = held_inputs(self.model.chain).nodes if self.model.chain.holds else ()
        held = {node.args[1] for node in nodes if node.op == "input" and node.args[0] == "p"}
        for one, place in zip(self.states, places, strict=True):
            if place in held:
                said = f"states: {one.parameter} decides what a step holds of its inputs"
                raise UsageError(f"{said}, of which a filter has no derivative; state it in the robot file")

    @property
    def values(self) -> dict[str, float]:
        """The values of the parameters that are found, by name."""
        return dict(zip((one.parameter for one in self.states), self._p[self._places].tolist(), strict=True))

    @property
    def deviations(self) -> dict[str, float]:
        """Their standard deviations."""
        own = np.sqrt(np.diag(self._P)[self.model.chain.n_changes :])
        return dict(zip((one.parameter for one in self.states), own.tolist(), strict=True))

    def _start(self, q: np.ndarray, v: np.ndarray, deviation_q: np.ndarray, deviation_v: np.ndarray) -> None:
        super()._start(q, v, deviation_q, deviation_v)
        self._take(self._with_values(self._begin))
        self._P = self._with_parameters(self._P)

    def _with_parameters(self, P: np.ndarray) -> np.ndarray:
        """A covariance of states with that of the parameters as they begin."""
        return linalg.block_diag(P, np.diag([one.deviation**2 for one in self.states]))

    def put(self, q: Any, v: Any, P: Any) -> None:
        """Not of this filter: its covariance belongs to its parameters too."""
        raise UsageError("a filter of parameters is not put into a state; start it there")

    def _carried(
        self, S: np.ndarray, Phi: np.ndarray, G: np.ndarray, at: tuple[np.ndarray, ...], dt: float
    ) -> np.ndarray:
        """The rule of the step, with accelerations that change with the parameters, and their random walk."""
        n = len(Phi)
        moved, still = S[:n], S[n:]
        walk = np.diag(np.sqrt([dt * one.density for one in self.states]))
        carried = np.vstack([Phi @ moved + dt * G @ self._accelerations_by_p(*at) @ still, still])
        return np.hstack([carried, np.vstack([np.zeros((n, len(walk))), walk])])

    def compared(self, row: Measurement, values: np.ndarray, tau: np.ndarray, w_ext: np.ndarray) -> Compared:
        """A measurement beside the estimate; the last columns are derivatives with the parameters."""
        H, rest = super().compared(row, values, tau, w_ext)
        chain, held = self.model.chain, self._hold(self._q, self._v, tau)
        key = ("expected along", row, tuple(self._places))
        program = self.model.once(key, lambda: expected_along(row, chain, self._places))
        given: dict[str, Any] = {"q": self._q, "v": self._v, "tau": held, "w_ext": w_ext.ravel(), "p": self._p}
        given["measured"] = np.where(np.isnan(values), 1.0, values)
        given |= {number.keyword: self._number(row, number) for number in row.numbers if number.stated}
        by_p = np.zeros((chain.nvz, len(self.states)))
        if "vdot" in program.inputs:
            given["vdot"] = self._numeric.forward_dynamics(self._q, self._v, held, w_ext)[0]
            by_p = self._accelerations_by_p(self._q, self._v, held, w_ext)
        columns = [
            self._found(program, given | {"d_p": unit, "d_vdot": own})["slope"]
            for unit, own in zip(np.eye(len(self.states)), by_p.T, strict=True)
        ]
        return Compared(np.hstack([H, np.array(columns).T.reshape(len(H), -1)]), rest)

    def _accelerations_by_p(self, q: np.ndarray, v: np.ndarray, held: np.ndarray, w_ext: np.ndarray) -> np.ndarray:
        """(nvz, k): the derivatives of the accelerations with the parameters."""
        given = {"q": q, "v": v, "tau": held, "w_ext": np.ravel(w_ext), "p": self._p}
        found = [self._found(self._dynamics, given | {"d_p": unit})["d_vdot"] for unit in np.eye(len(self.states))]
        return np.array(found).T

    @cached_property
    def _dynamics(self) -> Program:
        chain, row = self.model.chain, BY_NAME["forward_dynamics"]
        what = Differentiable.of(chain, row.of(chain))
        return self.model.once(("along", row.name, tuple(self._places)), lambda: along(chain, what, self._places))

    def _learnt(self, change: np.ndarray) -> AtParameters:
        """The model at the parameters of an update, within their bounds."""
        return self._with_values(np.clip(self._p[self._places] + change, self._low, self._high))

    def _with_values(self, values: np.ndarray) -> AtParameters:
        p = self._p.copy()
        p[self._places] = values
        return self._at_parameters(p)
