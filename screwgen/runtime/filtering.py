"""The interface of all filters: what they are told is checked here, and handed on as arrays."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..algorithms.measurement import Measurement
from ..algorithms.measurement_names import chosen, measurement
from ..arguments import Given, Loads, Numbers, array
from ..errors import UsageError
from ..robot_model import RobotModel
from .measurements import (
    Consistency,
    Innovation,
    Measured,
    Noise,
    check_noise,
    check_step,
    checked_input,
    checked_measurements,
    checked_start,
)
from .parameter_states import ParameterStates

Judged = tuple[dict[str, Innovation], Consistency]
"""What an update made of the measurements."""


class KalmanFilter(ABC):
    """An extended Kalman filter over q and v of a robot; arrays are in the order of ``model.q_names``.

    ``parameters``: values in the order of ``model.parameter_names``, or some by name, the file's by default.
    ``measurements``: what it is told, rows or names as ``encoder``, ``gyro@boom.tip``, ``tendon_length calibrated``;
    without them encoders, base strain, tip acceleration, and poses of floating bases and ball joints.
    Raises :class:`UsageError` for arguments that are none, :class:`DivergedError` where a result is not finite,
    :class:`SingularError` where a joint is singular or the covariance has lost its definiteness; then the estimate is
    as it was.
    """

    states: ParameterStates | None = None
    """The parameters of the robot that it finds; their rows of the covariance are behind those of v."""

    def __init__(self, model: RobotModel, parameters: Given, measurements: Sequence[str | Measurement] | None):
        self.model, self.measurements = model, _rows(model, measurements)
        self.noise, self._p = Noise(0.0), model.chain.parameters.vector(parameters)
        self.innovations: dict[str, Innovation] = {}
        """What the last update made of each measurement; empty before one."""
        self.consistency = Consistency()
        """The normalised innovation squared of the last update."""

    def start(
        self, q: Numbers, v: Numbers, deviation_q: Numbers | float, deviation_v: Numbers | float, noise: Noise
    ) -> None:
        """Begin at a state (nq, nvz) with the standard deviations of its entries (nv, nvz).

        Of ``v`` and its deviations rates (nv) alone will do, or for the deviations one number: internal states are then
        zero, and known. Those of the pose of a floating base are of a change [turn; shift] in its own axes. Where loops
        close the tree the state is closed, and the covariance is that of the deviations under the condition that the
        loops are closed.
        """
        given = checked_start(self.model.chain, q, v, deviation_q, deviation_v)
        check_noise(self.model.chain, self.measurements, noise)
        self._start(*given)
        self.innovations, self.consistency = {}, Consistency()
        self.set(noise)

    def set(self, noise: Noise) -> None:
        """Change the noise model."""
        check_noise(self.model.chain, self.measurements, noise)
        self.noise = noise

    def predict(self, tau: Loads, w_ext: Loads, dt: float) -> None:
        """Predict the state ``dt`` seconds later; torques and tensions (n_tau) and tip wrenches (n, 6) are held."""
        tau, w_ext = checked_input(self.model.chain, tau, w_ext)
        check_step(dt)
        self._predict(tau, w_ext, dt)

    def update(self, tau: Loads, w_ext: Loads, *values: Numbers | None, **named: Numbers | None) -> None:
        """Update the estimate by measurements; those left out, and entries that are None or NaN, were not made.

        By name, or in the order of ``measurements``: ``encoder`` (n_joints) in rad or m, ``strain`` (gauges),
        ``acceleration`` (3) in m/s², … . Of attitudes quaternions, of either sign.
        Torques and tensions ``tau`` (n_tau) and tip wrenches (n, 6) are those at the time of the measurement.
        """
        tau, w_ext = checked_input(self.model.chain, tau, w_ext)
        measured = checked_measurements(self.model.chain, self.measurements, self.noise, values, named)
        self.innovations, self.consistency = self._update(tau, w_ext, measured)

    @property
    @abstractmethod
    def state(self) -> tuple[np.ndarray, np.ndarray]:
        """The mean of q (nq,) and of v (nvz,)."""

    @property
    @abstractmethod
    def covariance(self) -> np.ndarray:
        """``P`` of [q; v], (nv + nvz, nv + nvz); of the pose of a floating base that of a change [turn; shift]."""

    def put(self, q: Numbers, v: Numbers, P: Any) -> None:
        """Set mean, q (nq,) and v (nvz,), and covariance (nv + nvz, nv + nvz)."""
        chain = self.model.chain
        n = chain.n_changes
        if self.states:
            raise UsageError("a filter of parameters is not put into a state; start it there")
        self._put(array(q, "q", (chain.nq,)), array(v, "v", (chain.nvz,)), array(P, "P", (n, n)))

    @property
    def values(self) -> dict[str, float]:
        """The values of the parameters that are found, by name."""
        return self.states.named(self._found_values()) if self.states else {}

    @property
    def deviations(self) -> dict[str, float]:
        """Their standard deviations."""
        return self.states.deviations(self.covariance) if self.states else {}

    def _found_values(self) -> np.ndarray:
        """(k,): the values of the parameters that are found."""
        return np.zeros(0)

    @abstractmethod
    def _start(self, q: np.ndarray, v: np.ndarray, deviation_q: np.ndarray, deviation_v: np.ndarray) -> None: ...

    @abstractmethod
    def _put(self, q: np.ndarray, v: np.ndarray, P: np.ndarray) -> None: ...

    @abstractmethod
    def _predict(self, tau: np.ndarray, w_ext: np.ndarray, dt: float) -> None: ...

    @abstractmethod
    def _update(self, tau: np.ndarray, w_ext: np.ndarray, measured: Measured) -> Judged: ...


def _rows(model: RobotModel, asked: Sequence[str | Measurement] | None) -> tuple[Measurement, ...]:
    """The rows; those of names are made once for a robot."""
    chain = model.chain

    def row(one: str | Measurement) -> Measurement:
        return model.once(("measurement", one), lambda: measurement(chain, one)) if isinstance(one, str) else one

    return chosen(chain, True if asked is None else [row(one) for one in asked])
