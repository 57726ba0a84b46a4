"""The estimator of the generated C, compiled for this machine and loaded: an extended Kalman filter over q and v."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..algorithms.gauges import Gauge, gauges
from ..algorithms.joint_sensors import POSE_SIZES, encoders, pose_measurements
from ..arguments import Given, Loads, Numbers, array, real_numbers
from ..errors import UsageError
from ..robot_model import RobotModel
from .differentiated import failure
from .lean import LeanProject
from .library import load
from .memory import Real, StructMemory, pointer

if TYPE_CHECKING:
    from ..topology.chain import Chain


def sensors(chain: Chain) -> dict[str, tuple[int, int, int]]:
    """How many values, flags and variances every measurement has."""
    sizes = {"encoder": len(encoders(chain)), "strain": len(gauges(chain)), "acceleration": 3}
    return {name: (size,) * 3 for name, size in sizes.items()} | pose_measurements(chain)


ABSENT = {"base": "a fixed base", "joint": "no ball joint"}
"""What a robot has that lacks the measurements of a pose whose names begin so."""


def _no_measurement(chain: Chain, name: str) -> str:
    """Why a name is not one of a robot's measurements, and what to do."""
    word, _, what = name.partition("_")
    if word in ABSENT and what in POSE_SIZES and (word, what) != ("joint", "position"):
        return f"{name}: robot '{chain.robot.name}' has {ABSENT[word]}; leave it out"
    return f"{name}: is no measurement; choose of {', '.join(sensors(chain))}"


def given_measurements(chain: Chain, given: Mapping[str, Any]) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """The values of every measurement, and which were made: what is None or NaN was not; raises UsageError."""
    out, known = {}, sensors(chain)
    for name in given.keys() - known.keys():
        raise UsageError(_no_measurement(chain, name))
    for name, (size, flags, _) in known.items():
        try:
            values = np.full(size, np.nan) if given.get(name) is None else np.array(given[name], float)
        except (TypeError, ValueError):
            raise UsageError(f"{name} is not an array of numbers; give {size} numbers") from None
        if values.shape != (size,):
            raise UsageError(f"{name}: shape {values.shape}, must be ({size},); give NaN for what was not measured")
        made = ~np.isnan(values)
        if flags < size:
            values, made = _directions(values.reshape(flags, -1)).ravel(), made.reshape(flags, -1).all(axis=1)
        out[name] = values, made
    return out


def _directions(quaternions: np.ndarray) -> np.ndarray:
    """The same directions (n, 4): these count, and the squares of large numbers are infinite."""
    largest = np.max(np.abs(quaternions), axis=1, keepdims=True)
    scale = np.where(np.isfinite(largest) & (largest > 0), largest, 1.0)
    return quaternions / scale


def spread(values: Any, name: str, size: int) -> np.ndarray:
    """Deviations or densities (size,), of which one number stands for all; raises UsageError where any is negative."""
    given = real_numbers(values)
    if given is None or given.shape not in ((), (1,), (size,)) or not (np.isfinite(given) & (given >= 0)).all():
        raise UsageError(f"{name}: must be a number >= 0, or {size} of them")
    return np.broadcast_to(given, size)


def check_noise(chain: Chain, noise: Noise) -> None:
    """Raises UsageError where a density or a deviation is negative or no number, or the number of them is wrong."""
    sizes = {"density_q": chain.nv, "density_v": chain.nv} | {
        name: size for name, (_, _, size) in sensors(chain).items()
    }
    for name, size in sizes.items():
        spread(getattr(noise, name), name, size)


def _members(model: RobotModel) -> dict[str, tuple[int, ...]]:
    """The members of a filter's memory that are read or written here, and their shapes."""
    n, m, g = model.nv, model.n_joints, len(gauges(model.chain))
    states = {f"{state}.q": (model.nq,) for state in ("state", "estimator.state")} | {"deviation.q": (n,)}
    states |= {f"{state}.v": (n,) for state in ("state", "deviation", "estimator.state")}
    places = ("measurement.{}", "measurement.has_{}", "estimator.{}_variance")
    measured = {
        place.format(name): (size,)
        for name, sizes in sensors(model.chain).items()
        for place, size in zip(places, sizes, strict=True)
    }
    noise = {"estimator.density_q": (n,), "estimator.density_v": (n,), "estimator.fibre": (g,)}
    inputs = {"input.tau": (m,), "input.w_ext": (model.n_links, 6)}
    return states | measured | noise | inputs | {"estimator.P": (2 * n, 2 * n)}


def _files(model: RobotModel, binding: str) -> dict[str, str]:
    """The sources of an estimator."""
    project = LeanProject(model.chain, model.version, binding, estimator=True)
    return project.files() | {"shim.c": project.shim("estimator_shim.c", list(_members(model)))}


@dataclass(frozen=True)
class Noise:
    """The noise model of a filter; a single number applies to all entries.

    ``density_q``, ``density_v`` (nv): spectral densities of white noise on the rates of q and v, rad²/s and rad²/s³
    (modes and slides: m²/s, m²/s³).  ``encoder`` (n_joints, rad or m), ``strain`` (gauges), ``acceleration``
    (3, m/s²): standard deviations of a measurement.  ``fibre`` (gauges): distance of each gauge from the centreline, m,
    on the side of positive y or z.  Of a floating base ``base_position`` (3, m), ``base_attitude`` (3, rad, about axes
    of F_1) and ``base_rate`` (3, rad/s), and densities that belong to changes [turn; shift] of its pose, rad and m.
    Of ball joints ``joint_attitude`` and ``joint_rate`` (3 each), about axes of the link; encoders measure the others.
    """

    density_v: np.ndarray | float
    density_q: np.ndarray | float = 0.0
    encoder: np.ndarray | float = 0.0
    strain: np.ndarray | float = 0.0
    acceleration: np.ndarray | float = 0.0
    fibre: np.ndarray | float = 0.0
    base_position: np.ndarray | float = 0.0
    base_attitude: np.ndarray | float = 0.0
    base_rate: np.ndarray | float = 0.0
    joint_attitude: np.ndarray | float = 0.0
    joint_rate: np.ndarray | float = 0.0


class CompiledEstimator:
    """``<robot>_estimator`` of the generated C; its arrays are NumPy's, in the order of ``model.q_names``.

    ``parameters``: values in the order of ``model.parameter_names``, the file's by default; ``single``: in float.
    Raises :class:`ScrewgenError` where there is no C compiler or a call does not return OK, :class:`SingularError`
    where a joint is singular or the covariance has lost its definiteness; then the estimate is as it was.
    """

    def __init__(
        self,
        model: RobotModel,
        parameters: Given = None,
        single: bool = False,
        binding: str = "runtime",
        flags: Sequence[str] = ("-O2",),
        compiler: str | None = None,
    ):
        self.model, self.real = model, np.float32 if single else np.float64
        self.gauges: list[Gauge] = gauges(model.chain)
        self._p = model.chain.parameters.vector(parameters)
        files = model.once(("estimator files", binding), lambda: _files(model, binding))
        define = [f"-D{model.robot.name.upper()}_REAL_FLOAT"] if single else []
        self.library = load(files, [*flags, *define], compiler)
        members = _members(model)
        self._block = StructMemory(self.library, list(members), np.dtype(self.real))
        self._memory, kind = self._block.address, lambda name: ctypes.c_int if "has_" in name else None
        self._at = {name: self._block.view(name, *shape, kind=kind(name)) for name, shape in members.items()}

    def start(
        self, q: Numbers, v: Numbers, deviation_q: Numbers | float, deviation_v: Numbers | float, noise: Noise
    ) -> None:
        """Begin at a state (nq, nv) with the standard deviations of its entries (nv, nv).

        Those of the pose of a floating base are of a change [turn; shift] in its own axes. Where loops close the tree
        the state is closed, and the covariance is that of the deviations under the condition that the loops are closed.
        """
        self._write({"state.q": q, "state.v": v, "deviation.q": deviation_q, "deviation.v": deviation_v})
        p = np.append(self._p, 0.0).astype(self.real)
        self._check(self.library.shim_init(self._memory, pointer(p)))
        self.set(noise)

    def set(self, noise: Noise) -> None:
        """Change the noise model."""
        check_noise(self.model.chain, noise)
        names = sensors(self.model.chain)
        self._write({f"estimator.{name}_variance": np.square(getattr(noise, name)) for name in names})
        self._write({f"estimator.{name}": getattr(noise, name) for name in ("density_q", "density_v", "fibre")})

    def predict(self, tau: Loads, w_ext: Loads, dt: float) -> None:
        """Predict the state ``dt`` seconds later, with torques (n_joints) and tip wrenches (n, 6) held."""
        self._input(tau, w_ext)
        self._check(self.library.shim_predict(self._memory, self._number(dt)))

    def update(
        self,
        tau: Loads,
        w_ext: Loads,
        encoder: Numbers | None = None,
        strain: Numbers | None = None,
        acceleration: Numbers | None = None,
        **poses: Numbers | None,
    ) -> None:
        """Update the estimate by measurements; those left out, and entries that are None or NaN, were not made.

        ``encoder`` (n_joints) in rad or m, ``strain`` (gauges), ``acceleration`` (3) in m/s², of the last tip in
        tip-frame components, less free fall.  Of a floating base also ``base_position`` (3), ``base_attitude`` (4: the
        quaternion, of either sign) and ``base_rate`` (3), the angular velocity in axes of F_1. Of ball joints, which
        have no encoders, ``joint_attitude`` (4 each) and ``joint_rate`` (3 each), as in q and v, link by link.
        """
        self._input(tau, w_ext)
        given = {"encoder": encoder, "strain": strain, "acceleration": acceleration} | poses
        for name, (values, made) in given_measurements(self.model.chain, given).items():
            self._write({f"measurement.{name}": np.nan_to_num(values, posinf=np.inf, neginf=-np.inf)})
            self._write({f"measurement.has_{name}": made})
        self._check(self.library.shim_update(self._memory))

    @property
    def state(self) -> tuple[np.ndarray, np.ndarray]:
        """The mean of q (nq,) and of v (nv,)."""
        return self._at["estimator.state.q"].copy(), self._at["estimator.state.v"].copy()

    @property
    def covariance(self) -> np.ndarray:
        """``P`` of [q; v], (2 nv, 2 nv); of the pose of a floating base that of a change [turn; shift]."""
        return self._at["estimator.P"].copy()

    @property
    def fault(self) -> int:
        """After :class:`SingularError`: the link whose joint is singular, or -1 for the filter itself."""
        return self.library.shim_fault(self._memory)

    def put(self, q: Numbers, v: Numbers, P: np.ndarray) -> None:
        """Set mean and covariance."""
        self._write({"estimator.state.q": q, "estimator.state.v": v, "estimator.P": P})

    def _input(self, tau: Loads, w_ext: Loads) -> None:
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

    def _number(self, value: float) -> Real:
        return ctypes.c_float(value) if self.real is np.float32 else ctypes.c_double(value)

    def _check(self, status: int) -> None:
        if status:
            chain, lost = self.model.chain, "the filter's covariance has lost its definiteness, or its step is too long"
            raise failure(chain, status, self.fault, lost + ", or its loops do not close" * bool(chain.closing.rows))
