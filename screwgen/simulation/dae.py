"""Runs of the DAE form: the steps of :mod:`..backends.numpy.dae_step`, each of which ends with a projection."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..algorithms.tip_programs import COMPLIANT
from ..arguments import Numbers
from ..backends.numpy.dae_step import DaeDynamics, HeldDae
from ..integrators.method import Method
from ..integrators.methods import method_of
from ..robot_model import RobotModel
from .integrate import DEFAULT, LIMIT, CasadiEvaluator, DivergedError, holding


def dynamics(model: RobotModel, p: Numbers) -> DaeDynamics:
    """The DAE form with parameters ``p``, evaluated by CasADi."""
    functions, given = model.modal_functions, np.array(p, float)

    def at_p(name: str) -> Callable[..., list[np.ndarray]]:
        evaluate = CasadiEvaluator(functions[name])
        return lambda *values: evaluate(*values, given)

    properties = at_p("modal_properties")()
    memory = at_p("dae_force_rates") if model.chain.n_force_states else None
    rows = [at_p(f"dae_{x.__name__}") for x in COMPLIANT] if model.chain.compliant else ()
    solve = at_p("dae_dynamics"), at_p("project"), at_p("joint_rates")
    return DaeDynamics(model.chain, properties, *solve, memory, rows)


class DaeStepper:
    """Steps of the DAE form, each followed by a projection onto the joint constraints."""

    default = DEFAULT

    def __init__(self, model: RobotModel, integrator: str | Method, p: Numbers):
        self.method, self.dynamics = method_of(integrator), dynamics(model, p)
        self.reference, self.chain = model.numpy(p), model.chain
        self.hold = holding(model, p)
        self.p, self.place = np.array(p, float), CasadiEvaluator(model.casadi()["dae_state"])

    def initial(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The state that satisfies the joint constraints."""
        return self.place(q, v, self.p)[0]

    def step(self, x: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, dt: float) -> np.ndarray:
        """The state ``dt`` later, projected."""
        if self.chain.holds:
            tau = self.hold(*self.coordinates(x), tau)
        try:
            new = self.dynamics.project(HeldDae(self.dynamics, x, tau, w_ext, dt).step(self.method))
        except (ValueError, OverflowError):  # a turn that is not finite: the run says that it diverged
            new = np.full_like(x, np.nan)
        if not (np.abs(new) < LIMIT).all():
            self.reference.dae_rates(x, tau, w_ext)
            raise DivergedError(f"the integrator '{self.method}' diverged; take a smaller step")
        return new

    def coordinates(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """``q`` and ``v``; the joint rates follow from the twists."""
        d, qdot = self.dynamics, self.dynamics.joint_rates(x)[0]
        pose, twist = (x[[4, 5, 6, 0, 1, 2, 3]], x[d.twist][:6]) if self.chain.base_v else (x[:0], x[:0])
        q = x[d.q]
        return np.concatenate([pose, q, x[d.eta]]), np.concatenate([twist, qdot, x[d.etadot], x[d.z]])
