"""The estimator of the generated C, compiled for this machine and loaded: an extended Kalman filter over q and v."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..algorithms.gauges import Gauge, gauges
from ..arguments import array
from ..errors import ScrewgenError, SingularError, UsageError
from .compiled import STATUS, LeanProject
from .library import load

if TYPE_CHECKING:
    from ..model import Model


def _files(model: Model, binding: str) -> dict[str, str]:
    """The sources of an estimator."""
    project = LeanProject(model.chain, model.version, binding, estimator=True)
    return project.files() | {"shim.c": project.shim("estimator_shim.c")}


@dataclass(frozen=True)
class Noise:
    """The noise model of a filter; a single number applies to all entries.

    ``density_q``, ``density_v`` (nq): spectral densities of white noise on the rates of q and v, rad²/s and rad²/s³
    (modes: m²/s, m²/s³).  ``encoder`` (n_joints, rad), ``strain`` (gauges), ``acceleration`` (3, m/s²): standard
    deviations of a measurement.  ``fibre`` (gauges): distance of each gauge from the centreline, m, on the side of
    positive y or z.
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
        self._memory = ctypes.create_string_buffer(self.library.shim_size())

    def start(self, q, v, deviation_q, deviation_v, noise: Noise) -> None:
        """Begin at a state (nq, nq) with the standard deviations of its entries."""
        n = self.model.nq
        given = (self._in(self._p), *(self._in(x, n) for x in (q, v, deviation_q, deviation_v)))
        self._check(self.library.shim_init(self._memory, *given))
        self.set(noise)

    def set(self, noise: Noise) -> None:
        """Change the noise model."""
        n, m, g = self.model.nq, self.model.n_joints, len(self.gauges)
        square = lambda x, size: self._in(np.square(np.broadcast_to(np.asarray(x, float), size)), size)  # noqa: E731
        self.library.shim_set(
            self._memory,
            self._in(noise.density_q, n),
            self._in(noise.density_v, n),
            square(noise.encoder, m),
            square(noise.strain, g),
            square(noise.acceleration, 3),
            self._in(noise.fibre, g),
        )

    def predict(self, tau, w_ext, dt: float) -> None:
        """Predict the state ``dt`` seconds later, with torques (n_joints) and tip wrenches (n, 6) held."""
        self._check(self.library.shim_predict(self._memory, *self._input(tau, w_ext), self._number(dt)))

    def update(self, tau, w_ext, encoder=None, strain=None, acceleration=None) -> None:
        """Update the estimate by measurements; those left out, and entries that are None or NaN, were not made.

        ``encoder`` (n_joints) in rad, ``strain`` (gauges), ``acceleration`` (3) in m/s², of the last tip in tip-frame
        components, less free fall.
        """
        sizes = (self.model.n_joints, len(self.gauges), 3)
        given = [
            np.full(n, np.nan) if x is None else np.array(x, float)
            for x, n in zip((encoder, strain, acceleration), sizes, strict=True)
        ]
        for name, x, n in zip(("encoder", "strain", "acceleration"), given, sizes, strict=True):
            if x.shape != (n,):
                raise UsageError(f"{name}: shape {x.shape}, must be ({n},); give NaN for what was not measured")
        has = np.isfinite(np.concatenate(given)).astype(np.int32)
        infinite = np.isinf(np.concatenate(given))
        has[infinite] = 1
        values = [self._in(np.where(np.isnan(x), 0.0, x), n) for x, n in zip(given, sizes, strict=True)]
        flags = np.ctypeslib.as_ctypes(np.append(has, np.int32(0)))
        self._check(self.library.shim_update(self._memory, *self._input(tau, w_ext), flags, *values))

    @property
    def state(self) -> tuple[np.ndarray, np.ndarray]:
        """The mean of q and of v, (nq,) each."""
        return self._got()[:2]

    @property
    def covariance(self) -> np.ndarray:
        """``P`` of [q; v], (2 nq, 2 nq)."""
        return self._got()[2]

    @property
    def fault(self) -> int:
        """After :class:`SingularError`: the link whose joint is singular, or -1 for the filter itself."""
        return self.library.shim_fault(self._memory)

    def put(self, q, v, P) -> None:
        """Set mean and covariance."""
        n = self.model.nq
        self.library.shim_put(self._memory, self._in(q, n), self._in(v, n), self._in(P, 4 * n * n))

    def _got(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        n = self.model.nq
        arrays = [np.zeros(shape, self.real) for shape in (n, n, (2 * n, 2 * n))]
        self.library.shim_get(self._memory, *(ctypes.c_void_p(x.ctypes.data) for x in arrays))
        return tuple(arrays)

    def _input(self, tau, w_ext):
        given = (("tau", tau, (self.model.n_joints,)), ("w_ext", w_ext, (self.model.n_links, 6)))
        return [self._in(array(values, name, shape, finite=False)) for name, values, shape in given]

    def _in(self, values, size: int | None = None):
        values = np.asarray(values, float)
        flat = np.ravel(values if size is None or values.ndim else np.full(size, values))
        if size is not None and flat.size != size:
            raise UsageError(f"{flat.size} numbers where {size} are needed; see the docstring for the shapes")
        return np.ctypeslib.as_ctypes(np.append(flat, 0.0).astype(self.real))

    def _number(self, value: float):
        return ctypes.c_float(value) if self.real is np.float32 else ctypes.c_double(value)

    def _check(self, status: int) -> None:
        if status == 2 and self.fault >= 0:
            link = self.model.robot.links[self.fault].name
            raise SingularError(f"the joint of link '{link}' is singular in this posture")
        if status == 2:
            raise SingularError("the filter's covariance has lost its definiteness, or its step is too long")
        if status:
            raise ScrewgenError(f"the generated C reports: {STATUS[status]}")
