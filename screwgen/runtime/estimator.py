"""The estimator of the generated C, compiled for this machine and loaded: an extended Kalman filter over q and v."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..algorithms.gauges import Gauge, gauges
from ..arguments import array
from ..errors import ScrewgenError, SingularError, UsageError
from .compiled import LeanProject
from .differentiated import STATUS
from .library import load
from .memory import Block, pointer

if TYPE_CHECKING:
    from ..model import Model


SENSORS = ("encoder", "strain", "acceleration")


def _members(model: Model) -> dict[str, tuple[int, ...]]:
    """The members of a filter's memory that are read or written here, and their shapes."""
    n, m, g = model.nq, model.n_joints, len(gauges(model.chain))
    states = {f"{state}.{part}": (n,) for state in ("state", "deviation", "estimator.state") for part in "qv"}
    sensors = dict(zip(SENSORS, (m, g, 3), strict=True))
    places = ("estimator.{}_variance", "measurement.{}", "measurement.has_{}")
    measured = {place.format(name): (size,) for name, size in sensors.items() for place in places}
    noise = {"estimator.density_q": (n,), "estimator.density_v": (n,), "estimator.fibre": (g,)}
    inputs = {"input.tau": (m,), "input.w_ext": (model.n_links, 6)}
    return states | measured | noise | inputs | {"estimator.P": (2 * n, 2 * n)}


def _files(model: Model, binding: str) -> dict[str, str]:
    """The sources of an estimator."""
    project = LeanProject(model.chain, model.version, binding, estimator=True)
    return project.files() | {"shim.c": project.shim("estimator_shim.c", list(_members(model)))}


@dataclass(frozen=True)
class Noise:
    """The noise model of a filter; a single number applies to all entries.

    ``density_q``, ``density_v`` (nq): spectral densities of white noise on the rates of q and v, rad²/s and rad²/s³
    (modes and slides: m²/s, m²/s³).  ``encoder`` (n_joints, rad or m), ``strain`` (gauges), ``acceleration``
    (3, m/s²): standard deviations of a measurement.  ``fibre`` (gauges): distance of each gauge from the centreline, m,
    on the side of positive y or z.
    """

    density_v: np.ndarray | float
    density_q: np.ndarray | float = 0.0
    encoder: np.ndarray | float = 0.0
    strain: np.ndarray | float = 0.0
    acceleration: np.ndarray | float = 0.0
    fibre: np.ndarray | float = 0.0


class CompiledEstimator:
    """``<robot>_estimator`` of the generated C; its arrays are NumPy's, in the order of ``model.q_names``.

    ``parameters``: values in the order of ``model.parameter_names``, the file's by default; ``single``: in float.
    Raises :class:`ScrewgenError` where there is no C compiler or a call does not return OK, :class:`SingularError`
    where a joint is singular or the covariance has lost its definiteness; then the estimate is as it was.
    """

    def __init__(
        self,
        model: Model,
        parameters=None,
        single=False,
        binding="runtime",
        flags=("-O2",),
        compiler: str | None = None,
    ):
        self.model, self.real = model, np.float32 if single else np.float64
        self.gauges: list[Gauge] = gauges(model.chain)
        self._p = model.chain.parameters.vector(parameters)
        files = model.once(("estimator files", binding), lambda: _files(model, binding))
        define = [f"-D{model.robot.name.upper()}_REAL_FLOAT"] if single else []
        self.library = load(files, [*flags, *define], compiler)
        members = _members(model)
        self._block = Block(self.library, list(members), np.dtype(self.real))
        self._memory, kind = self._block.address, lambda name: ctypes.c_int if "has_" in name else None
        self._at = {name: self._block.view(name, *shape, kind=kind(name)) for name, shape in members.items()}

    def start(self, q, v, deviation_q, deviation_v, noise: Noise) -> None:
        """Begin at a state (nq, nq) with the standard deviations of its entries."""
        self._write({"state.q": q, "state.v": v, "deviation.q": deviation_q, "deviation.v": deviation_v})
        p = np.append(self._p, 0.0).astype(self.real)
        self._check(self.library.shim_init(self._memory, pointer(p)))
        self.set(noise)

    def set(self, noise: Noise) -> None:
        """Change the noise model."""
        self._write({f"estimator.{name}_variance": np.square(getattr(noise, name)) for name in SENSORS})
        self._write({f"estimator.{name}": getattr(noise, name) for name in ("density_q", "density_v", "fibre")})

    def predict(self, tau, w_ext, dt: float) -> None:
        """Predict the state ``dt`` seconds later, with torques (n_joints) and tip wrenches (n, 6) held."""
        self._input(tau, w_ext)
        self._check(self.library.shim_predict(self._memory, self._number(dt)))

    def update(self, tau, w_ext, encoder=None, strain=None, acceleration=None) -> None:
        """Update the estimate by measurements; those left out, and entries that are None or NaN, were not made.

        ``encoder`` (n_joints) in rad or m, ``strain`` (gauges), ``acceleration`` (3) in m/s², of the last tip in
        tip-frame components, less free fall.
        """
        self._input(tau, w_ext)
        for name, given in zip(SENSORS, (encoder, strain, acceleration), strict=True):
            size = len(self._at[f"measurement.{name}"])
            values = np.full(size, np.nan) if given is None else np.array(given, float)
            if values.shape != (size,):
                raise UsageError(f"{name}: shape {values.shape}, must be ({size},); give NaN for what was not measured")
            missing = np.isnan(values)
            self._write({f"measurement.{name}": np.where(missing, 0.0, values), f"measurement.has_{name}": ~missing})
        self._check(self.library.shim_update(self._memory))

    @property
    def state(self) -> tuple[np.ndarray, np.ndarray]:
        """The mean of q and of v, (nq,) each."""
        return self._at["estimator.state.q"].copy(), self._at["estimator.state.v"].copy()

    @property
    def covariance(self) -> np.ndarray:
        """``P`` of [q; v], (2 nq, 2 nq)."""
        return self._at["estimator.P"].copy()

    @property
    def fault(self) -> int:
        """After :class:`SingularError`: the link whose joint is singular, or -1 for the filter itself."""
        return self.library.shim_fault(self._memory)

    def put(self, q, v, P) -> None:
        """Set mean and covariance."""
        self._write({"estimator.state.q": q, "estimator.state.v": v, "estimator.P": P})

    def _input(self, tau, w_ext) -> None:
        for name, values in (("tau", tau), ("w_ext", w_ext)):
            place = self._at[f"input.{name}"]
            place[:] = array(values, name, place.shape, finite=False)

    def _write(self, members: Mapping[str, Any]) -> None:
        """Set members to arrays of their size; a single number is set in all entries."""
        for name, given in members.items():
            place, values = self._at[name], np.asarray(given, float)
            if values.ndim and values.size != place.size:
                raise UsageError(
                    f"{values.size} numbers where {place.size} are needed; see the docstring for the shapes"
                )
            place[...] = values.reshape(place.shape) if values.ndim else values

    def _number(self, value: float):
        return ctypes.c_float(value) if self.real is np.float32 else ctypes.c_double(value)

    def _check(self, status: int) -> None:
        if status == 2 and self.fault >= 0:
            raise self.model.chain.singular(self.fault)
        if status == 2:
            raise SingularError("the filter's covariance has lost its definiteness, or its step is too long")
        if status:
            raise ScrewgenError(f"the generated C reports: {STATUS[status]}")
