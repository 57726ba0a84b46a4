"""The formulation as printed: the paper's system of an arm, with the formulas that fail put into it one by one.

The system is the derived one in the paper's unknowns ``[w_1; Zdot_1; …; etaddot]``; each printed formula replaces its
derived counterpart, both taken from the register of equations.  The completed rows of the joints stay: with the
projector alone the matrix is singular (E17).  Where the print cannot run at all it is read as it must be meant: rows
with the angular part first (E24), M* in its own column (E15), what (B2) prints in column 2n - 1 in column 2n (E28), the
bias of the joints projected (E32).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from ..arguments import Loads, Numbers
from ..errors import SingularError, UsageError
from ..model import derive
from ..simulation.controllers import Controller
from ..simulation.inputs import coordinates
from ..simulation.integrate import DivergedError
from ..simulation.runs import OWN, Run
from ..simulation.simulate import time_grid
from ..spec.robot import Robot
from ..topology.chain import Chain
from .arm_state import ArmState
from .printed_system import CORRECTIONS, System

PRINTED = {
    "29": "H* with weight about the inertial origin, stresses on the whole link, and without its transport terms",
    "43": "projector with axes fixed in the link's frame",
    "45": "Adjoint of the frames applied to the velocity of the joint's point",
    "accconst5": "bias of the joints without reference twists, transport terms and the rate of the projector",
    "85": "no wrenches in the modal rows; places from the link's frame",
    "88": "gyroscopic forces on the modes from the link's frame, stiffness in its strong form",
    "B1": "columns of the modal accelerations without mass per length, with the displacement for the place",
    "B2": "columns that the deformation adds, likewise",
    "B3": "bias of the deformation, likewise",
    "97": "no h_s: neither weight nor gyroscopic wrench in the links' rows",
    "26": "no motors and no payload",
}
"""The printed equations that change the numbers of a system, and what they do to it."""
FAR = 1e9
"""A state beyond this, in SI units, is none of an arm."""


class PrintedModel:
    """A robot's system with some of its equations as printed; default: all that can be run.

    ``as_printed``: labels of :data:`PRINTED`.  Sections do not turn (E21).  Bodies of the robot are kept unless "26" is
    among the labels; the paper's ``g`` is read as the opposite of free fall (E22).
    """

    def __init__(self, robot: Robot, as_printed: Iterable[str] = tuple(PRINTED)):
        self.as_printed = tuple(as_printed)
        for label in self.as_printed:
            if label not in PRINTED:
                raise UsageError(f"({label}) changes no number of a system; choose {' or '.join(PRINTED)}")
        if any(link.pieces > 1 for link in robot.links):
            raise UsageError(f"{robot.name}: the paper has no segments of links; leave them out, or the formulation")
        if any(link.rest for link in robot.links):
            raise UsageError(
                f"{robot.name}: the paper's links are straight at rest; leave out rest, or the formulation"
            )
        self.robot = self._reduced(robot)
        self.model = derive(self.robot)
        if any(direction == "torsion" for key in self.model.chain.keys for direction, _ in key.directions):
            raise UsageError(f"{robot.name}: the paper has no torsion modes; leave them out, or the formulation")
        if not self.model.chain.serial:
            raise UsageError(f"{robot.name}: the paper's arm is a chain; leave out parent, or the formulation")
        if self.model.chain.n_added or self.model.chain.laws:
            said = f"{robot.name}: the paper has neither gears nor friction nor stops"
            raise UsageError(f"{said}; leave out drives and limits, or the formulation")

    def _reduced(self, robot: Robot) -> Robot:
        bare = {"bodies": ()} if "26" in self.as_printed else {}
        links = tuple(link.model_copy(update=bare) for link in robot.links)
        return robot.model_copy(update={"section_rotation": False, "links": links})

    @property
    def chain(self) -> Chain:
        return self.model.chain

    def record(self) -> dict:
        """Which equations are as printed."""
        return {"as_printed": list(self.as_printed)}

    def assemble(
        self, q: Numbers, v: Numbers, tau: Loads, w_ext: Loads = None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """``M_sys``, ``H_sys``, ``W_sys`` at joint form ``q``, ``v`` (nq,), torques and external wrenches (n, 6)."""
        numeric = self.model.numpy()
        w_ext = np.zeros((self.chain.n, 6)) if w_ext is None else w_ext
        x = numeric.dae_state(q, v)
        M, H, W = numeric.assemble(x, tau, w_ext)
        system = System(self.chain, ArmState(self.model, x), M, H, W)
        for label in self.as_printed:
            CORRECTIONS.get(label, lambda _: None)(system)
        if "97" in self.as_printed:
            system.drop_h_s()
        return system.M, system.H, system.W

    def forward_dynamics(
        self, q: Numbers, v: Numbers, tau: Loads, w_ext: Loads = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """``vdot`` (nq,) and the joint wrenches (n, 6) by dense solution; SingularError where there is none."""
        M, H, W = self.assemble(q, v, tau, w_ext)
        if np.linalg.matrix_rank(M) < len(M):
            raise SingularError("M_sys with the printed equations is singular in this state")
        z = np.linalg.solve(M, W - H)
        n, x = self.chain.n, self.model.numpy().dae_state(q, v)
        state = ArmState(self.model, x)
        pairs = z[: 12 * n].reshape(n, 12)
        Vdot = [_twist_rate(link.values, row[6:].reshape(6, 1)) for link, row in zip(state.links, pairs, strict=True)]
        return np.concatenate([*self._joint_rates(state, Vdot), z[12 * n :]]), pairs[:, :6]

    def simulate(
        self,
        duration: float,
        step: float = 1e-3,
        q: Numbers | None = None,
        v: Numbers | None = None,
        controller: Controller | None = None,
    ) -> Run:
        """Table 1, forward Euler from ``q``, ``v``; ``controller(t, q, v)`` gives the torques, zero without.

        Raises DivergedError, which names the time, when a number leaves what doubles hold.
        """
        times, numeric = time_grid(duration, step), self.model.numpy()
        x, u, rows = coordinates(q, "q", self.model), coordinates(v, "v", self.model), []
        for k, t in enumerate(times):
            tau = np.zeros(self.model.n_joints) if controller is None else np.asarray(controller(t, x, u), float)
            with np.errstate(over="ignore", invalid="ignore"):
                vdot, wrench = self._rates(t, x, u, tau)
                rows.append((x, u, tau, wrench, numeric.tip_pose(x)[1], numeric.energy(x, u)))
                if k + 1 < len(times):
                    h = times[k + 1] - t
                    x, u = x + h * u, u + h * vdot
        columns = (np.array(column) for column in zip(*rows, strict=True))
        fields: dict[str, Any] = dict(zip((*OWN, "energy"), (times, *columns), strict=True))
        names = {f"{kind}_names": tuple(getattr(self.model, f"{kind}_names")) for kind in ("q", "v", "tau", "wrench")}
        return Run(self.robot.name, **fields | names)

    def _rates(self, t: float, q: np.ndarray, v: np.ndarray, tau: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        largest = max(np.abs(q).max(initial=0.0), np.abs(v).max(initial=0.0))
        if not largest < FAR:
            raise DivergedError(f"the printed system diverged at t = {t:g} s: the state exceeds {FAR:g}")
        return self.forward_dynamics(q, v, tau)

    def _joint_rates(self, state: ArmState, Vdot: list[np.ndarray]) -> list[np.ndarray]:
        """``qddot`` of every joint from the angular accelerations of the links."""
        out = []
        for i, link in enumerate(state.links):
            own, before = link.values, state.links[i - 1].values if i else None
            turning = before["R"] @ before["omega"] if before else np.zeros((3, 1))
            parent = before["R"] @ Vdot[i - 1][:3] if before else np.zeros((3, 1))
            qdot = own["A_plus"] @ (own["R"] @ own["omega"] - turning)
            bias = state._axes_rate(i, own["A"], own["A_plus"]) @ qdot
            out.append((own["A_plus"] @ (own["R"] @ Vdot[i][:3] - parent - bias)).ravel())
        return out


def _twist_rate(values: dict, Zdot: np.ndarray) -> np.ndarray:
    """``Vdot = (I + T_gamma) Zdot + gamma*``."""
    return Zdot + values["T_gamma"] @ Zdot + values["gamma_star"]
