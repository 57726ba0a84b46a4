"""The published task: an arm with two flexible links from rest to rest, N = 125 at 5 ms."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import casadi as ca
import numpy as np
from mpc.arms import projected

import screwgen
from screwgen import Model, ModelValidityWarning
from screwgen.runtime.compiled import Compiled

from .judge import Judge
from .solver import Options, Problem, Solver

FILE = Path(__file__).resolve().parents[1] / "flexible_arm.toml"
START = np.array([np.pi / 2, np.pi / 10, -np.pi / 8])
GOAL = np.array([0.0, 2 * np.pi / 5, -np.pi / 3])
"""rad: joint angles at rest, of the published point-to-point motion."""
LIMIT = np.array([20.0, 10.0, 10.0])
"""N·m"""
FASTEST = np.array([2.5, 3.5, 3.5])
"""rad/s: bound of the joint rates, with slacks as published."""
H, N = 0.005, 125
JOINTS, MODES, JOINT_RATES, MODE_RATES = 0.01, 0.01, 0.1, 10.0
"""Per second: published weights; those of "modes" are of the passive joints of three segments for each link."""
TORQUES, TIP = np.array([1.0, 10.0, 10.0]), 2e3
JOINTS_END, JOINT_RATES_END, TIP_END = 0.1, 1.0, 1e4
SEGMENTS = 3
"""Of a link in the published model: the squares of its passive angles sum up to l/3 times the integral of κ²."""
EI, LENGTH = 1.9e11 * 0.05 * 0.002**3 / 12, 0.5
"""N·m², m"""


@dataclass(frozen=True)
class Task:
    """The model with so many modes for each link, and the problem with so many intervals."""

    modes: int = 3
    N: int = N

    @cached_property
    def model(self) -> Model:
        robot = screwgen.load(FILE)
        links = [
            link.model_copy(update={"modes": link.modes.model_copy(update={"bending_z": self.modes})})
            for link in robot.links
        ]
        return screwgen.derive(robot.model_copy(update={"links": tuple(links)}))

    @cached_property
    def p(self) -> np.ndarray:
        return np.array(self.model.parameter_values)

    def rest(self, joints) -> tuple[np.ndarray, np.ndarray]:
        """State (nx,) and torques (3,) at rest."""
        with warnings.catch_warnings():  # axial loads of 2 to 8 % of the buckling load: see the robot file
            warnings.simplefilter("ignore", ModelValidityWarning)
            found = screwgen.equilibrium(self.model, joints, hold=True)
        return np.r_[found.q, np.zeros(self.model.nq)], found.tau

    @cached_property
    def ends(self) -> list[tuple[np.ndarray, np.ndarray]]:
        return [self.rest(START), self.rest(GOAL)]

    @cached_property
    def modal(self) -> np.ndarray:
        """(r,) 1/m²: what a squared modal coordinate adds to the squares of the passive angles."""
        K = np.array(self.model.modal_functions["modal_properties"](self.p)[1]).ravel()
        return LENGTH / SEGMENTS * K / EI

    def tip(self, q) -> ca.SX:
        return self.model.casadi()["tip_pose"](q, self.p)[1]

    @cached_property
    def problem(self) -> Problem:
        nq, e = self.model.nq, self.model.acados(parameters="baked")
        q, v = e.x[:nq], e.x[nq:]
        q_next, v_next = self.model.casadi()["step"](q, v, e.u, 0, self.p, H)
        state = np.r_[np.full(3, JOINTS), MODES * self.modal, np.full(3, JOINT_RATES), MODE_RATES * self.modal]
        end = np.r_[np.full(3, JOINTS_END), MODES * self.modal, np.full(3, JOINT_RATES_END), MODE_RATES * self.modal]
        return Problem(
            name=f"flexible_arm_{self.modes}",
            export=e,
            N=self.N,
            h=H,
            y=ca.vertcat(e.x, e.u, self.tip(q)),
            W=np.diag(np.r_[state, TORQUES, np.full(3, TIP)]),
            y_end=ca.vertcat(e.x, self.tip(q)),
            W_end=np.diag(np.r_[end, np.full(3, TIP_END)]),
            limit=LIMIT,
            bounded=nq + np.arange(3),
            bound=FASTEST,
            after=ca.vertcat(q_next, v_next),
        )

    def reference(self) -> tuple[np.ndarray, np.ndarray]:
        """What y and y_end shall be: the rest at `GOAL`."""
        x, tau = self.ends[1]
        place = np.array(ca.DM(self.model.casadi()["tip_pose"](x[: self.model.nq], self.p)[1])).ravel()
        return np.r_[x, tau, place], np.r_[x, place]


FAST = Options(hpipm="SPEED_ABS", condensed=25, qp_tolerance=1e-3)
"""For the real-time iteration: five intervals condensed into one, the interior point method stopped early."""
PLANT_STEP, PLANT_MODES = 5e-4, 4
"""s, modes of each link of the richer plant."""


@dataclass(frozen=True)
class Run:
    """A closed loop sampled every `H`."""

    x: np.ndarray
    """(n + 1, nx): the model's state as it is measured."""
    u: np.ndarray
    tip: np.ndarray
    """(n, 3) m: of the plant."""
    preparation: np.ndarray
    feedback: np.ndarray
    """(n,) s"""
    failed: int
    """Samples in which the QP was not solved."""
    iterations: np.ndarray
    """(n,): of the interior point method."""
    predicted: np.ndarray
    """(n, N + 1, nx)"""


class SamePlant:
    """The model itself, by the step that the controller has."""

    def __init__(self, task: Task):
        e = task.problem.export
        self.task, self.x = task, task.ends[0][0]
        self.after = ca.Function("after", [e.x, e.u], [task.problem.after])

    def step(self, u) -> None:
        self.x = np.array(self.after(self.x, u)).ravel()

    def tip(self) -> np.ndarray:
        nq, pose = self.task.model.nq, self.task.model.casadi()["tip_pose"]
        return np.array(pose(self.x[:nq], self.task.p)[1]).ravel()


class RicherPlant:
    """Generated C with one mode more in each link, in steps of `PLANT_STEP`."""

    def __init__(self, task: Task):
        richer = Task(modes=PLANT_MODES)
        self.model, (x, _) = richer.model, richer.ends[0]
        self.compiled = Compiled(self.model, flags=("-O1",), cache=True)
        self.compiled.prepare(np.array(self.model.parameter_values))
        self.T = projected(task.model, self.model, {"bending_z": 2})
        self.q, self.v = x[: self.model.nq], np.zeros(self.model.nq)

    @property
    def x(self) -> np.ndarray:
        return np.r_[self.T @ self.q, self.T @ self.v]

    def step(self, u) -> None:
        free, count = np.zeros((2, 6)), round(H / PLANT_STEP)
        self.q, self.v = self.compiled.step(self.q, self.v, u, free, PLANT_STEP, "modal_midpoint", count)

    def tip(self) -> np.ndarray:
        pose = self.model.casadi()["tip_pose"]
        return np.array(pose(self.q, self.model.parameter_values)[1]).ravel()


def begun(task: Task, options: Options = FAST, first: int = 20) -> Solver:
    """A solver after `first` iterations at the start, from a guess that rests there: a cold start without a plan."""
    solver, (x, u) = Solver(task.problem, options), task.ends[0]
    solver.options_set(qp_mu0=0.1)
    solver.refer(*task.reference())
    solver.guess(np.tile(x, (task.N + 1, 1)), np.tile(u, (task.N, 1)))
    solver.settle(x, first)
    return solver


def closed_loop(task: Task, solver: Solver, plant, duration: float) -> Run:
    """Real-time iterations: prepare, measure, feed back; the torque acts at once, as in the published loop."""
    rows = []
    for _ in range(round(duration / H)):
        preparation, x = solver.prepare(), plant.x
        u, feedback, status = solver.feedback(x)
        count = int(solver.acados.get_stats("qp_iter")[-1])
        rows.append((x, u, plant.tip(), preparation, feedback, status, count, solver.x))
        plant.step(u)
    x, u, tip, preparation, feedback, status, count, predicted = (np.array(c) for c in zip(*rows, strict=True))
    return Run(x, u, tip, preparation, feedback, int(np.count_nonzero(status)), count, predicted)


def settled(run: Run, place, band: float) -> float | None:
    """s after which the tip stays within `band` of `place`; None: it does not."""
    outside = np.flatnonzero(np.linalg.norm(run.tip - place, axis=1) > band)
    last = outside[-1] + 1 if len(outside) else 0
    return float(last * H) if last < len(run.tip) else None


def judged(task: Task, run: Run, every: int) -> dict[str, list]:
    """Beside converged IPOPT at every so many samples: torques over their limits, predicted tips (m), rates (rad/s)."""
    judge, out = Judge(task.problem, *task.reference()), {"sample": [], "torque": [], "tip": [], "converged": []}
    e, nq = task.problem.export, task.model.nq
    tips = ca.Function("tips", [e.x], [task.tip(e.x[:nq])]).map(task.N + 1)
    for k in range(0, len(run.u), every):
        found = judge.solve(run.x[k], run.predicted[k], np.tile(run.u[k], (task.N, 1)))
        off = np.array(tips(run.predicted[k].T) - tips(found.x.T))
        out["sample"].append(k)
        out["converged"].append(bool(found.converged))
        out["torque"].append(float(np.abs((run.u[k] - found.u[0]) / LIMIT).max()))
        out["tip"].append(float(np.linalg.norm(off, axis=0).max()))
    return out
