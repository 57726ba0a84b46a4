"""Motions of the arm in the generated C."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from screwgen import Run, ScrewgenError, simulate
from screwgen.runtime.compiled import Compiled
from screwgen.runtime.stepper import CompiledStepper
from screwgen.simulation.simulate import step_count

from .arm import STEP, Arm

LARGE = 1e3
"""A coordinate beyond this, m or rad, ends a motion: it has diverged."""


class Motion(NamedTuple):
    """Samples of a motion, and whether it reached its end."""

    t: np.ndarray
    q: np.ndarray
    v: np.ndarray
    complete: bool


@dataclass(frozen=True)
class Way:
    """How the arm is stepped: method, step and how many steps a torque is held for."""

    name: str
    model: str
    """Which of the models of `Arm`."""
    method: str
    step: float
    substeps: int = 1
    form: str = "joint"

    @property
    def sample(self) -> float:
        """The time between two torques, s."""
        return self.step * self.substeps


PRINTED = Way("forward Euler, 1 ms", "axial", "euler", STEP, form="dae")
"""Table 1: poses and twists are the state."""
EULER = Way("forward Euler, 1 ms, no axial modes", "bending", "euler", STEP)
REFERENCE = Way("Runge–Kutta 4, 20 µs", "axial", "rk4", STEP / 50, 50)
BESIDE = (
    EULER,
    Way("forward Euler, 0.1 ms, no axial modes", "bending", "euler", STEP / 10),
    Way("semi-implicit Euler, 1 ms, no axial modes", "bending", "semi_implicit", STEP),
    Way("semi-implicit Euler, 0.1 ms", "axial", "semi_implicit", STEP / 10),
    Way("modal implicit, 1 ms", "axial", "modal_implicit", STEP),
    Way("modal midpoint, 1 ms", "axial", "modal_midpoint", STEP),
)
"""What the paper's task is run with, beside the reference and the printed way."""


class Library:
    """The arm's models, compiled when they are first needed."""

    def __init__(self, arm: Arm, flags: tuple[str, ...] = ("-O2",)):
        self.arm, self.flags, self._compiled = arm, flags, {}

    def __getitem__(self, name: str) -> Compiled:
        if name not in self._compiled:
            self._compiled[name] = getattr(self.arm, name).compile(flags=self.flags)
        return self._compiled[name]


def follow(compiled: Compiled, law, q0: np.ndarray, way: Way, duration: float, large: float = LARGE) -> Motion:
    """The motion from rest at `q0` (nq,) for `duration` seconds, sampled at every torque, or until it diverges."""
    count = step_count(duration, way.sample)
    t, (q, v) = way.sample * np.arange(count + 1), np.zeros((2, count + 1, compiled.model.nq))
    q[0], free = q0, np.zeros((compiled.model.n_links, 6))
    step = {"joint": joint_step, "dae": dae_step}[way.form](compiled, way, q0)
    for k in range(count):
        tau = law(t[k], q[k], v[k]) if law else np.zeros(0)
        try:
            q[k + 1], v[k + 1] = step(q[k], v[k], tau, free)
        except ScrewgenError:
            return Motion(t[: k + 1], q[: k + 1], v[: k + 1], False)
        if np.abs(q[k + 1]).max() > large:
            return Motion(t[: k + 2], q[: k + 2], v[: k + 2], False)
    return Motion(t, q, v, True)


def joint_step(compiled: Compiled, way: Way, q0):
    return lambda q, v, tau, w: compiled.step(q, v, tau, w, way.step, way.method, way.substeps)


def dae_step(compiled: Compiled, way: Way, q0):
    """Steps of the DAE form: its own state is kept, coordinates are read from it, joint rates through the twists."""
    model, x = compiled.model, compiled.dae_state(q0, np.zeros(len(q0)))
    m, n, r = model.n_joints, model.n_links, model.nq - model.n_joints
    read = model.casadi()["dae_state"]
    p, unit = model.parameter_values, np.eye(model.nq)

    def step(q, v, tau, w):
        nonlocal x
        x = compiled.dae_step(x, tau, w, way.step, way.method, way.substeps)
        q = np.append(x[-m:], x[7 * n : 7 * n + r])
        columns = np.array(read.map(model.nq)(np.tile(q, (model.nq, 1)).T, unit, np.tile(p, (model.nq, 1)).T))
        rates = slice(7 * n + r, 13 * n + 2 * r)
        return q, np.linalg.lstsq(columns[rates], x[rates], rcond=None)[0]

    return step


def recorded(library: Library, name: str, q0: np.ndarray, duration: float, method="modal_midpoint") -> Run:
    """A complete run, wrenches and energies included, of a model under the PD law at 1 ms."""
    compiled = library[name]
    law, form = library.arm.law(), partial(CompiledStepper, compiled)
    return simulate(compiled.model, duration, STEP, q0, controller=law, form=form, integrator=method)
