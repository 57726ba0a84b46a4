"""The predictive controller of the generated C, compiled for this machine and loaded."""

from __future__ import annotations

import ctypes
import math
import os
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from ..arguments import Given, Numbers, array
from ..backends.c.mpc import Fitted, MpcProject
from ..errors import UsageError
from ..robot_model import RobotModel
from .differentiated import failure
from .lean import RuntimeProject
from .library import load
from .memory import StructMemory, pointer

OUTCOMES = ("solved", "limited", "infeasible")
COUNTS = (
    *(f"options.{name}" for name in ("patience", "qp_iterations", "delay")),
    *(f"mpc.{name}" for name in ("outcome", "iterations", "converged", "refused", "mark", "prepared", "lost")),
)


class RuntimeMpcProject(MpcProject, RuntimeProject):
    """The library alone, without self-check and example."""

    def example(self) -> dict[str, str]:
        return {}


def _members(f: Fitted, content: dict[str, Any]) -> dict[str, tuple[int, ...]]:
    """The members of a controller's memory that are read or written here, and their shapes."""
    n, m, nx, N = f.n, f.modes, f.states, content["intervals"]
    nz, rows = content["nz"], content["rows"]
    weights = dict.fromkeys(("tip_position", "tip_orientation", "tip_velocity"), (3,))
    bounds = dict.fromkeys(("torques", "torque_rates", "torque_lower", "torque_upper", "torque_rate"), (n,))
    bounds |= dict.fromkeys(("joints", "joint_rates", "joint_lower", "joint_upper", "joint_rate"), (f.joints,))
    more = {"modes": (m,), "mode_rates": (m,), "terminal": (nx, nx), "terminal_factor": (1,), "penalty": (1,)}
    gauges, wrenches = (len(content["gauges"]),), (len(content["wrenches"]),)
    more |= {
        "strain": gauges,
        "fibre": gauges,
        "wrench": wrenches,
        "reference": (0,),
        "scatter": (nx,),
        "margin": (1,),
        "patience": (1,),
        "qp_iterations": (1,),
        "delay": (1,),
    }
    out = {f"options.{name}": shape for name, shape in (weights | bounds | more).items()}
    nq, nvz = f.chain.nq, f.chain.nvz
    out |= {"state.q": (nq,), "state.v": (nvz,), "acting": (n,), "tau": (n,)}
    out |= {"options.given": (len(f.given),)} if f.given else {}
    own = {
        "x": (N + 1, nq + nvz),
        "tau": (content["blocks"], n),
        "acting": (n,),
        "cost": (1,),
        "change": (1,),
        "violation": (1,),
    }
    own |= dict.fromkeys(("outcome", "iterations", "converged", "refused", "mark", "prepared", "lost"), (1,))
    own |= {
        "A": (N, nx, nx),
        "B": (N, nx, n),
        "d": (N, nx),
        "G": (N + 1, nx, nz),
        "H": (nz, nz),
        "g": (nz,),
    }
    own |= {
        "row": (rows, nz),
        "lower": (nz + rows,),
        "upper": (nz + rows,),
        "z": (nz,),
        "unit": (n,),
        "dx": (N + 1, nx),
    }
    return out | {f"mpc.{name}": shape for name, shape in own.items()}


class CompiledMpc:
    """``<robot>_mpc`` of the generated C; arrays are NumPy's, in the order of ``model.q_names`` and ``tau_names``.

    Made by :meth:`screwgen.Model.mpc` from a file.  ``parameters``: values in the order of ``model.parameter_names`` or
    by name, the robot file's by default.  Options are views of the C's memory by the names of the header, such as
    ``controller.options["torque_upper"][:] = 100``; ``controller.reference`` is a list of views, one per stage.
    Raises :class:`ScrewgenError` where a call does not return OK.

    As a controller of :func:`screwgen.simulate` it is called ``(t, q, v) -> tau``, with the state of its own model
    or, through ``projection`` (nq, nq of the plant), with that of another; it samples by itself, and with the delay of
    its file a torque acts from the next sample on.  Of inputs that are given and not chosen, as brakes, lines of
    winches, motions of axes and of a base, :attr:`given` says what they are.  Internal states are taken as they are;
    they are zero, or left out, where one of both models alone has any.
    """

    def __init__(
        self,
        model: RobotModel,
        fitted: Fitted,
        parameters: Given = None,
        single: bool = False,
        flags: Sequence[str] = ("-O3",),
        compiler: str | None = None,
        cache: bool | str | os.PathLike = True,
        projection: np.ndarray | None = None,
    ):
        self.model, self.real, self.projection = model, np.dtype(np.float32 if single else np.float64), projection
        self.fitted, self.said = fitted, fitted.said
        project = RuntimeMpcProject(self.fitted, model.version)
        content = project.context["mpc"]
        members = _members(self.fitted, content)
        files = project.files() | {"shim.c": project.shim("mpc_shim.c", list(members))}
        define = [f"-D{model.robot.name.upper()}_REAL_FLOAT"] if single else []
        self.library = load(files, [*flags, *define], compiler, cache)
        self._block = StructMemory(self.library, list(members), self.real)
        self._memory = self._block.address
        kind = lambda name: ctypes.c_int if name in COUNTS else None  # noqa: E731
        at = {k: self._block.view(k, *s, kind=kind(k)) for k, s in members.items() if k != "options.reference"}
        self.options = {name[8:]: view for name, view in at.items() if name.startswith("options.")}
        self.inner = {name[4:]: view for name, view in at.items() if name.startswith("mpc.")}
        self._at = at
        n, stages = self.fitted.n, content["intervals"] + 1
        nvz = model.chain.nvz
        width = model.nq + nvz + model.n_tau + 15
        whole = self._block.view("options.reference", stages, width)
        ends = np.cumsum([model.nq, nvz, model.n_tau, 3, 9, 3])
        names = ("q", "v", "tau", "tip_position", "tip_rotation", "tip_velocity")
        self.reference = [
            {
                k: (p.reshape(3, 3) if k == "tip_rotation" else p)
                for k, p in zip(names, np.split(row, ends[:-1]), strict=True)
            }
            for row in whole
        ]
        self.block = content["block"]
        self.library.shim_default(self._memory)
        self.set_parameters(parameters)
        self.given: Callable[[float], Numbers] = lambda t: self.fitted.still[self.fitted.given]
        """``t -> (n_given,)``: what the inputs that are given are over time, in their order in ``model.tau_names``."""
        self._due, self._last = 0.0, math.inf
        self._held, self._next = np.zeros(n), np.zeros(n)

    def set_parameters(self, parameters: Given = None) -> None:
        """Other parameters from the next :meth:`prepare` on, a payload for one."""
        p = np.append(self.model.chain.parameters.vector(parameters), 0.0).astype(self.real)
        self._check(self.library.shim_parameters(self._memory, pointer(p)))

    def initialise(self, q: Numbers, v: Numbers, acting: Numbers | None = None) -> None:
        """A plan from a state (nq,), (nvz,), near or far from the references, by iterations until it settles.

        Of ``v`` rates (nv,) alone will do: internal states are then zero.  ``acting`` (n_tau,): the torques that act
        until the next sample; those that hold the arm if left out.  Then call :meth:`feedback` with the same state.
        """
        self._state(q, self.model.chain.with_internal(v))
        if acting is not None:
            self._at["acting"][:] = array(acting, "acting", self._at["acting"].shape)
        self._check(self.library.shim_initialise(self._memory, int(acting is not None)))

    def prepare(self) -> None:
        """Between two samples: shift the plan, linearise, condense."""
        self._check(self.library.shim_prepare(self._memory))

    def feedback(self, q: Numbers, v: Numbers) -> np.ndarray:
        """The torques (n_chosen,) from a sample on, with the file's delay from the next one on; no given inputs.

        ``q`` (nq,), ``v`` (nvz,): measured or estimated, internal states among them, as an estimator has them.
        Where :attr:`refused` is not zero after the call, the arm cannot have come to this state since the last one: the
        torques are then those of the state that the model predicts. After ``options["patience"]`` refusals in a row the
        next state is believed; :meth:`initialise` starts from another state at once.
        """
        status = self._sample(q, v)
        if self.refused:
            return self._at["tau"].astype(float)
        self._check(status)
        return self._at["tau"].astype(float)

    @property
    def refused(self) -> int:
        """Samples in a row that were finite and not believed."""
        return int(self.inner["refused"][0])

    @property
    def outcome(self) -> str:
        """Of the last quadratic program: ``solved``, ``limited`` or ``infeasible``."""
        return OUTCOMES[int(self.inner["outcome"][0])]

    @property
    def iterations(self) -> int:
        """Of the last quadratic program; after :meth:`initialise` of the outer loop."""
        return int(self.inner["iterations"][0])

    @property
    def converged(self) -> bool:
        """Whether :meth:`initialise` has settled."""
        return bool(self.inner["converged"][0])

    @property
    def states(self) -> np.ndarray:
        """The plan's states [q; v] (intervals + 1, nq + nvz)."""
        return self.inner["x"].astype(float)

    @property
    def torques(self) -> np.ndarray:
        """The plan's torques (intervals, n_chosen), N·m."""
        return self.inner["tau"][self.block].astype(float)

    def __call__(self, t: float, q: Numbers, v: Numbers) -> np.ndarray:
        """All inputs at time ``t`` of a run, torques new at a sample, else the last; an earlier time begins anew."""
        begun = t >= self._last
        if begun and t < self._due - 1e-9 * max(1.0, abs(t)):
            return self._whole(t)
        q, v = self._of_own_model(np.asarray(q), np.asarray(v))
        self.foresee(self._due if begun else t)
        if begun:
            self.prepare()
        else:
            self.initialise(q, v)
            self._next, self._due = self.inner["acting"].astype(float), t
        self._held, self._last = self._next, t
        status = self._sample(q, v)
        if not self.refused:  # else the plan goes on
            self._check(status)
        self._next = self._at["tau"].astype(float)
        if not self.options["delay"][0]:
            self._held = self._next
        self._due += self.said.horizon.step
        return self._whole(t)

    def foresee(self, t: float) -> None:
        """Tell the plan of the sample at time ``t`` what :attr:`given` says, of each interval that in its middle."""
        if not self.fitted.given:
            return
        step = self.said.horizon.step
        middle, delay = t + step / 2, int(self.options["delay"][0])
        self.options["given"][:] = self.given(middle)
        for k, stage in enumerate(self.reference, delay):
            stage["tau"][self.fitted.given] = self.given(middle + k * step)

    def _whole(self, t: float) -> np.ndarray:
        """All inputs: the torques that are held, and those that are given."""
        if not self.fitted.given:
            return self._held
        out = np.zeros(self.model.n_tau)
        out[self.fitted.chosen], out[self.fitted.given] = self._held, self.given(t)
        return out

    def _of_own_model(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The state of the controller's model from that of the plant."""
        own, P = self.model.chain.n_internal, self.projection
        n = len(q) - (self.model.nq - self.model.nv)
        z = v[n:] if own and len(v) > n else np.zeros(own)
        if len(z) != own:
            raise UsageError(
                f"the plant has {len(z)} internal states and the controller's model {own}; which of them belong "
                "together is not known; call feedback in a loop of your own"
            )
        q, rates = (x if P is None else P @ x for x in (q, v[:n]))
        return q, np.append(rates, z)

    def _sample(self, q: Numbers, v: Numbers) -> int:
        self._state(q, v)
        return int(self.library.shim_feedback(self._memory))

    def _state(self, q: Numbers, v: Numbers) -> None:
        for name, values in (("q", q), ("v", v)):
            place = self._at[f"state.{name}"]
            place[:] = array(values, name, place.shape, finite=False)

    def _check(self, status: int) -> None:
        if status:
            loose = "the weights leave torques undetermined; weigh all torques or their rates"
            raise failure(self.model.chain, status, self.library.shim_fault(self._memory), loose)
