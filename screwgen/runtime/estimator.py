"""The estimator of the generated C, compiled for this machine and loaded: an extended Kalman filter over q and v."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..algorithms.measurement import Measurement
from ..arguments import Given
from ..backends.c.parameters import place
from ..backends.numpy.covariance import LOST, root
from ..errors import DivergedError, SingularError, UsageError
from ..robot_model import RobotModel
from ..spec.parameters import parameters
from .differentiated import BAD_ARGUMENT, NONFINITE, SINGULAR, failure
from .filtering import Judged, KalmanFilter
from .lean import RuntimeProject
from .library import load
from .measurements import Consistency, Innovation, Measured, Noise, deviations, gate_name, numbers, of_rates
from .memory import Real, StructMemory, pointer
from .parameter_states import ParameterState, ParameterStates

__all__ = ["CompiledEstimator", "Noise"]

NOT_FINITE = "the estimate is not finite; take a shorter step, or look at the measurements"
OPEN = "the filter's loops do not close from where it leads; look at the measurements"
TOO_LONG = "the step is too long for the filter; take a shorter one"
OWN = ("density_q", "density_v", "gate", "doubt", "patience")
"""Members of a noise model that belong to no measurement."""
WHOLE = ("refused", "beyond", "trial", "taken", "patience")
"""Members that are integers, beside flags."""


REFUSED = "the update leads to parameters that no robot has; give the states bounds, lower and upper"
PER_PARAMETER = {"density_p": "density", "lower": "lower", "upper": "upper"}
"""Members of a filter of parameters that have an entry for each, and what of :class:`.ParameterStates` they are."""


def _members(
    model: RobotModel, rows: Sequence[Measurement], states: ParameterStates | None
) -> dict[str, tuple[int, ...]]:
    """The members of a filter's memory that are read or written here, and their shapes."""
    chain, n, k = model.chain, model.nv, len(states.places) if states else 0
    out = {f"{state}.q": (model.nq,) for state in ("state", "estimator.state")} | {"deviation.q": (n,)}
    out |= {f"{state}.v": (chain.nvz,) for state in ("state", "deviation", "estimator.state")}
    for row in rows:
        size = row.size(chain)
        out |= {f"measurement.{row.name}": (row.n_values(chain),), f"measurement.has_{row.name}": (size // row.group,)}
        out |= {f"estimator.{row.name}_variance": (size,), f"estimator.innovations.{row.name}": (size,)}
        out |= {f"estimator.{number.name}": (number.size(chain),) for number in row.numbers if number.stated}
        out |= {f"estimator.{gate_name(row)}": (1,)} if row.gated else {}
    sizes = {"density_q": n, "density_v": chain.nvz}
    out |= {f"estimator.{name}": (sizes.get(name, 1),) for name in OWN}
    out |= {f"estimator.innovations.{name}": (1,) for name in ("squared", "taken")}
    inputs: dict[str, tuple[int, ...]] = {"input.tau": (model.n_tau,), "input.w_ext": (model.n_links, 6)}
    if states:
        out |= {f"estimator.{name}": (k,) for name in PER_PARAMETER} | {"deviation_p": (k,)}
        out |= dict.fromkeys(_places(model, states), (1,))
    return out | inputs | {"estimator.P": (chain.n_changes + k, chain.n_changes + k)}


def _places(model: RobotModel, states: ParameterStates) -> list[str]:
    """The members that the parameters are which a filter finds."""
    own = parameters(model.robot)
    return [f"estimator.parameters.{place(own[k])}" for k in states.places]


def _files(
    model: RobotModel, rows: Sequence[Measurement], binding: str, states: ParameterStates | None
) -> dict[str, str]:
    """The sources of an estimator."""
    names = states.names if states else ()
    project = RuntimeProject(model.chain, model.version, binding, estimator=rows, estimate=names)
    return project.files() | {"shim.c": project.shim("estimator_shim.c", list(_members(model, rows, states)))}


class CompiledEstimator(KalmanFilter):
    """``<robot>_estimator`` of the generated C. ``single``: in float; ``binding``, ``flags``, ``compiler``: of the C.

    ``states``: parameters that it finds, too, as :class:`.ParameterEstimator` does.
    Raises :class:`ScrewgenError` where there is no C compiler; the rest as of :class:`.KalmanFilter`.
    """

    def __init__(
        self,
        model: RobotModel,
        parameters: Given = None,
        single: bool = False,
        binding: str = "runtime",
        flags: Sequence[str] = ("-O2",),
        compiler: str | None = None,
        measurements: Sequence[str | Measurement] | None = None,
        states: Sequence[ParameterState] | None = None,
    ):
        super().__init__(model, parameters, measurements)
        self.states = own = None if states is None else ParameterStates(model.chain, states, self._p)
        self.real, rows = np.float32 if single else np.float64, self.measurements
        key = ("estimator files", binding, rows, tuple(own.names) if own else ())
        files = model.once(key, lambda: _files(model, rows, binding, own))
        define = [f"-D{model.robot.name.upper()}_REAL_FLOAT"] if single else []
        self.library = load(files, [*flags, *define], compiler)
        members = _members(model, rows, own)
        self._block = StructMemory(self.library, list(members), np.dtype(self.real))
        self._memory = self._block.address
        self._at = {name: self._block.view(name, *shape, kind=self._kind(name)) for name, shape in members.items()}

    def _start(self, q: np.ndarray, v: np.ndarray, deviation_q: np.ndarray, deviation_v: np.ndarray) -> None:
        self._write({"state.q": q, "state.v": v, "deviation.q": deviation_q, "deviation.v": deviation_v})
        p = np.append(self._p, 0.0).astype(self.real)
        if self.states:
            self._write({"deviation_p": self.states.deviation})
        self._check(self.library.shim_init(self._memory, pointer(p)), LOST)
        if own := self.states:
            self._write({f"estimator.{name}": getattr(own, of) for name, of in PER_PARAMETER.items()})

    def set(self, noise: Noise) -> None:
        super().set(noise)
        chain, rows = self.model.chain, self.measurements
        self._write({f"estimator.{row.name}_variance": deviations(chain, row, noise) ** 2 for row in rows})
        self._write({f"estimator.{name}": x for row in rows for name, x in numbers(chain, row, noise).items()})
        gates = [gate_name(row) for row in rows if row.gated]
        self._write({f"estimator.{name}": noise.sensors.get(name, 0.0) for name in gates})
        own = {name: getattr(noise, name) for name in OWN} | {
            "density_v": of_rates(chain, noise.density_v, "density_v")
        }
        self._write({f"estimator.{name}": value for name, value in own.items()})

    def _predict(self, tau: np.ndarray, w_ext: np.ndarray, dt: float) -> None:
        self._write({"input.tau": tau, "input.w_ext": w_ext})
        self._check(self.library.shim_predict(self._memory, self._number(dt)), TOO_LONG)

    def _update(self, tau: np.ndarray, w_ext: np.ndarray, measured: Measured) -> Judged:
        self._write({"input.tau": tau, "input.w_ext": w_ext})
        for name, (values, made) in measured.items():
            self._write({f"measurement.{name}": np.nan_to_num(values), f"measurement.has_{name}": made})
        status = self.library.shim_update(self._memory)
        if status == BAD_ARGUMENT and self.states:  # all else was checked
            raise UsageError(REFUSED)
        self._check(status, LOST)
        squared, taken = (self._at[f"estimator.innovations.{name}"][0] for name in ("squared", "taken"))
        found = {row.name: self._innovation(row, measured[row.name][1]) for row in self.measurements}
        return found, Consistency(float(squared), int(taken))

    def _innovation(self, row: Measurement, made: np.ndarray) -> Innovation:
        """What the update made of a measurement."""
        found, there = self._at[f"estimator.innovations.{row.name}"], np.repeat(made, row.group)
        value, normalised = (np.where(there, found[x].astype(float), np.nan) for x in ("value", "normalised"))
        return Innovation(value, normalised, found["refused"] != 0, found["weight"].astype(float))

    @property
    def state(self) -> tuple[np.ndarray, np.ndarray]:
        """The mean of q (nq,) and of v (nvz,)."""
        return self._at["estimator.state.q"].copy(), self._at["estimator.state.v"].copy()

    @property
    def covariance(self) -> np.ndarray:
        """``P`` of [q; v], (nv + nvz, nv + nvz); of the pose of a floating base that of a change [turn; shift]."""
        return self._at["estimator.P"].copy()

    def _found_values(self) -> np.ndarray:
        return np.hstack([self._at[name] for name in _places(self.model, self.states)]) if self.states else np.zeros(0)

    @property
    def fault(self) -> int:
        """After :class:`SingularError`: the link whose joint is singular, or -1 for the filter itself."""
        return self.library.shim_fault(self._memory)

    def _put(self, q: np.ndarray, v: np.ndarray, P: np.ndarray) -> None:
        self._write({"estimator.state.q": q, "estimator.state.v": v, "estimator.P": P})

    def _kind(self, name: str) -> Any:
        """What a member is made of."""
        last = name.rpartition(".")[2]
        if last in WHOLE or last.startswith("has_"):
            return ctypes.c_int
        if name.startswith("estimator.innovations.") and last != "squared":
            fields = [(x, self.real) for x in ("value", "variance", "normalised", "weight")]
            return np.dtype([*fields, *((x, ctypes.c_int) for x in WHOLE[:3])], align=True)
        return None

    def _write(self, members: Mapping[str, Any]) -> None:
        """Set members to arrays of their size; a single number is set in all entries."""
        for name, given in members.items():
            place, values = self._at[name], np.asarray(given, float)
            if values.ndim and values.size != place.size:
                raise UsageError(
                    f"{values.size} numbers where {place.size} are needed; see the docstring for the shapes"
                )
            place[...] = values.reshape(place.shape) if values.ndim else values

    def _number(self, value: float) -> Real:
        return ctypes.c_float(value) if self.real is np.float32 else ctypes.c_double(value)

    def _check(self, status: int, otherwise: str) -> None:
        """Raises the error of a status that is not OK; ``otherwise``: what it is where no link is at fault."""
        if status == NONFINITE:
            raise DivergedError(NOT_FINITE)
        if status == SINGULAR and self.fault < 0:
            root(self.covariance.astype(float), self.real)
            raise SingularError(OPEN if self.model.chain.closing.rows else otherwise)
        if status:
            raise failure(self.model.chain, status, self.fault)
