"""The estimator that also finds parameters of the robot: they are states that change as a random walk.

An example: an arm picks up a payload. The filter's model has another mass at the tip, so its innovations grow; the
covariance says how they go with the mass, and an update moves it. The derivatives by parameters are traced.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np

from ..algorithms.estimated_parameters import gaps
from ..algorithms.measurement import Measurement
from ..algorithms.measurement_slopes import expected_along
from ..algorithms.parameter_slopes import Differentiable, along
from ..algorithms.robot_functions import BY_NAME
from ..arguments import Given
from ..errors import ScrewgenError
from ..ir.program import Program
from ..lazily import linalg
from ..robot_model import RobotModel
from ..runtime.parameter_states import ParameterState, ParameterStates
from .estimator import AtParameters, Compared, Estimator


class ParameterEstimator(Estimator):
    """The filter in NumPy over q, v and ``states``, parameters of the robot; the rest as of :class:`.Estimator`.

    ``covariance`` has their rows behind those of v, in the order of the robot's parameters. Where loops close the tree
    its changes keep them closed: coordinates follow the lengths of links. Refused are parameters that no motion
    follows, as what tilts a hinge out of its plane, and those of what a step holds of its inputs, as limits of efforts.
    """

    states: ParameterStates

    def __init__(
        self,
        model: RobotModel,
        states: Sequence[ParameterState],
        parameters: Given = None,
        measurements: Sequence[str | Measurement] | None = None,
    ):
        super().__init__(model, parameters, measurements)
        self.states = ParameterStates(model.chain, states, self._p)
        self._P = linalg.block_diag(self._P, np.diag(self.states.deviation**2))

    def _found_values(self) -> np.ndarray:
        return self._p[self.states.places]

    def _start(self, q: np.ndarray, v: np.ndarray, deviation_q: np.ndarray, deviation_v: np.ndarray) -> None:
        before = self._at
        self._take(self._with_values(self.states.start))
        try:
            super()._start(q, v, deviation_q, deviation_v)
        except ScrewgenError:
            self._take(before)
            raise

    def _spread(self, deviations: np.ndarray) -> np.ndarray:
        return np.diag(np.append(deviations, self.states.deviation))

    def _carried(
        self, S: np.ndarray, Phi: np.ndarray, G: np.ndarray, at: tuple[np.ndarray, ...], dt: float
    ) -> np.ndarray:
        """The rule of the step, with accelerations that change with the parameters, and their random walk."""
        n = len(Phi)
        moved, still = S[:n], S[n:]
        walk = np.diag(np.sqrt(dt * self.states.density))
        carried = np.vstack([Phi @ moved + dt * G @ self._accelerations_by_p(*at) @ still, still])
        return np.hstack([carried, np.vstack([np.zeros((n, len(walk))), walk])])

    def compared(self, row: Measurement, values: np.ndarray, tau: np.ndarray, w_ext: np.ndarray) -> Compared:
        """A measurement beside the estimate; the last columns are derivatives with the parameters."""
        H, rest = super().compared(row, values, tau, w_ext)
        chain, held = self.model.chain, self._hold(self._q, self._v, tau)
        key = ("expected along", row, tuple(self.states.places))
        program = self.model.once(key, lambda: expected_along(row, chain, self.states.places))
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

    def _gaps_by_p(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        key = ("gaps along", tuple(self.states.places))
        program = self.model.once(key, lambda: along(self.model.chain, gaps(self.model.chain), self.states.places))
        given = {"q": q, "v": v, "p": self._p}
        found = [self._found(program, given | {"d_p": unit}) for unit in np.eye(len(self.states))]
        by_gap, by_rate = (np.array([one[name] for one in found]).T for name in ("d_gap", "d_rate"))
        return by_gap, by_rate

    @cached_property
    def _dynamics(self) -> Program:
        chain, row = self.model.chain, BY_NAME["forward_dynamics"]
        what = Differentiable.of(chain, row.of(chain))
        places = self.states.places
        return self.model.once(("along", row.name, tuple(places)), lambda: along(chain, what, places))

    def _learnt(self, change: np.ndarray) -> AtParameters:
        """The model at the parameters of an update, within their bounds."""
        return self._with_values(np.clip(self._p[self.states.places] + change, self.states.lower, self.states.upper))

    def _with_values(self, values: np.ndarray) -> AtParameters:
        p = self._p.copy()
        p[self.states.places] = values
        return self._at_parameters(p)
