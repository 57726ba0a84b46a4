"""The estimator of the generated C, compiled for this machine and loaded: an extended Kalman filter over q and v."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..algorithms.gauges import Gauge, gauges
from ..arguments import Given, Loads, Numbers
from ..backends.numpy.covariance import LOST, root
from ..errors import DivergedError, SingularError, UsageError
from ..robot_model import RobotModel
from .differentiated import NONFINITE, SINGULAR, failure
from .lean import RuntimeProject
from .library import load
from .measurements import (
    Innovation,
    Noise,
    check_noise,
    check_step,
    checked_input,
    checked_measurements,
    checked_start,
    fibres,
    sensors,
)
from .memory import Real, StructMemory, pointer

__all__ = ["CompiledEstimator", "Noise"]

NOT_FINITE = "the estimate is not finite; take a shorter step, or look at the measurements"
OPEN = "the filter's loops do not close from where it leads; look at the measurements"
TOO_LONG = "the step is too long for the filter; take a shorter one"
JUDGED = ("gate", "doubt", "patience")
"""Members of a noise model by which an update judges what is measured."""


def _members(model: RobotModel) -> dict[str, tuple[int, ...]]:
    """The members of a filter's memory that are read or written here, and their shapes."""
    n, g = model.nv, len(gauges(model.chain))
    states = {f"{state}.q": (model.nq,) for state in ("state", "estimator.state")} | {"deviation.q": (n,)}
    states |= {f"{state}.v": (n,) for state in ("state", "deviation", "estimator.state")}
    places = ("measurement.{}", "measurement.has_{}", "estimator.{}_variance")
    measured = {
        place.format(name): (size,)
        for name, sizes in sensors(model.chain).items()
        for place, size in zip(places, sizes, strict=True)
    }
    measured |= {f"estimator.innovations.{name}": (size,) for name, (_, _, size) in sensors(model.chain).items()}
    noise = {"estimator.density_q": (n,), "estimator.density_v": (n,), "estimator.fibre": (g,)}
    noise |= {f"estimator.{name}": (1,) for name in JUDGED}
    inputs = {"input.tau": (model.n_tau,), "input.w_ext": (model.n_links, 6)}
    return states | measured | noise | inputs | {"estimator.P": (2 * n, 2 * n)}


def _files(model: RobotModel, binding: str) -> dict[str, str]:
    """The sources of an estimator."""
    project = RuntimeProject(model.chain, model.version, binding, estimator=True)
    return project.files() | {"shim.c": project.shim("estimator_shim.c", list(_members(model)))}


class CompiledEstimator:
    """``<robot>_estimator`` of the generated C; its arrays are NumPy's, in the order of ``model.q_names``.

    ``parameters``: values in the order of ``model.parameter_names``, the file's by default; ``single``: in float.
    Raises :class:`ScrewgenError` where there is no C compiler, :class:`UsageError` for arguments that are none,
    :class:`DivergedError` where a result is not finite, :class:`SingularError` where a joint is singular or the
    covariance has lost its definiteness; then the estimate is as it was.
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
        self._memory = self._block.address
        self._at = {name: self._block.view(name, *shape, kind=self._kind(name)) for name, shape in members.items()}
        self.noise, self._made = Noise(0.0), dict[str, np.ndarray]()

    def start(
        self, q: Numbers, v: Numbers, deviation_q: Numbers | float, deviation_v: Numbers | float, noise: Noise
    ) -> None:
        """Begin at a state (nq, nv) with the standard deviations of its entries (nv, nv).

        Those of the pose of a floating base are of a change [turn; shift] in its own axes. Where loops close the tree
        the state is closed, and the covariance is that of the deviations under the condition that the loops are closed.
        """
        names = ("state.q", "state.v", "deviation.q", "deviation.v")
        given = checked_start(self.model.chain, q, v, deviation_q, deviation_v)
        check_noise(self.model.chain, noise)
        self._write(dict(zip(names, given, strict=True)))
        self._made = {}
        p = np.append(self._p, 0.0).astype(self.real)
        self._check(self.library.shim_init(self._memory, pointer(p)), LOST)
        self.set(noise)

    def set(self, noise: Noise) -> None:
        """Change the noise model."""
        check_noise(self.model.chain, noise)
        names, self.noise = sensors(self.model.chain), noise
        self._write({f"estimator.{name}_variance": np.square(getattr(noise, name)) for name in names})
        self._write({f"estimator.{name}": getattr(noise, name) for name in ("density_q", "density_v")})
        self._write({"estimator.fibre": fibres(self.model.chain, noise)})
        self._write({f"estimator.{name}": getattr(noise, name) for name in JUDGED})

    def predict(self, tau: Loads, w_ext: Loads, dt: float) -> None:
        """Predict the state ``dt`` seconds later; torques and tensions (n_tau) and tip wrenches (n, 6) are held."""
        self._input(tau, w_ext)
        check_step(dt)
        self._check(self.library.shim_predict(self._memory, self._number(dt)), TOO_LONG)

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
        Torques and tensions ``tau`` (n_tau) and tip wrenches (n, 6) are those at the time of the measurement.
        """
        self._input(tau, w_ext)
        given = {"encoder": encoder, "strain": strain, "acceleration": acceleration} | poses
        measured = checked_measurements(self.model.chain, self.noise, given)
        for name, (values, made) in measured.items():
            self._write({f"measurement.{name}": np.nan_to_num(values), f"measurement.has_{name}": made})
        self._check(self.library.shim_update(self._memory), LOST)
        self._made = {name: made for name, (_, made) in measured.items()}

    @property
    def innovations(self) -> dict[str, Innovation]:
        """What the last update made of each measurement; empty before one."""
        out = {}
        for name, made in self._made.items():
            found = self._at[f"estimator.innovations.{name}"]
            there = np.repeat(made, found.size // made.size if made.size else 1)
            value, normalised = (np.where(there, found[x].astype(float), np.nan) for x in ("value", "normalised"))
            out[name] = Innovation(value, normalised, found["refused"] != 0, found["weight"].astype(float))
        return out

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

    def _kind(self, name: str) -> Any:
        """What a member is made of."""
        if ".innovations." in name:
            reals, whole = ("value", "variance", "normalised", "weight"), ("refused", "beyond", "trial")
            fields = [(x, self.real) for x in reals] + [(x, ctypes.c_int) for x in whole]
            return np.dtype(fields, align=True)
        return ctypes.c_int if "has_" in name or name.endswith("patience") else None

    def _input(self, tau: Loads, w_ext: Loads) -> None:
        tau, w_ext = checked_input(self.model.chain, tau, w_ext)
        self._write({"input.tau": tau, "input.w_ext": w_ext})

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
