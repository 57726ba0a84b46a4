"""Growth of small disturbances: predicted from the spectrum of the step map, observed in runs of the generated C."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
import scipy.linalg

from screwgen import PD, Model
from screwgen.simulation.linearised import Linearised
from screwgen.simulation.motion import modal_columns
from screwgen.studies.analysis.spectrum import growth, jacobian, step_map
from screwgen.studies.stiffness import stiffness

from .arm import STEP, Arm, start
from .motions import EULER, PRINTED, REFERENCE, Library, Way, follow

SMALL = 1e-4
"""m, rad: below this deviation a run counts as linear."""
VISIBLE = 1e-2
"""The same for the paper's task, whose start is no small disturbance."""
DECADES = 4
"""Growth by less leaves other motions their part in the size of a deviation."""
ENOUGH = 400
"""Samples that a fit is made from at most where the motion grows fast, and at least where time allows."""


@dataclass(frozen=True)
class Case:
    """A way of stepping and what holds the joints."""

    way: Way
    law: str = "PD"
    damping: float = 1.0
    """Times the chosen kd."""


@dataclass(frozen=True)
class Growth:
    """One row of the table; rates in 1/s, positive: growing."""

    name: str
    axial: bool
    joints: str
    frequency: float
    """Hz, of the motion of the closed loop in continuous time that grows fastest, or decays slowest, when stepped."""
    predicted: float
    observed: float
    by_size: float | None
    """The rate fitted to the plain size of the deviation, where it grows by `DECADES`."""

    @property
    def error(self) -> float:
        """Relative difference of observed and predicted."""
        return abs(self.observed - self.predicted) / abs(self.predicted)


CASES = (
    Case(PRINTED),
    Case(Way("forward Euler, 0.1 ms", "axial", "euler", STEP / 10)),
    Case(EULER),
    Case(Way("forward Euler, 1 ms, DAE form", "bending", "euler", STEP, form="dae")),
    Case(EULER, damping=1.5),
    Case(Way("forward Euler, 0.1 ms, no axial modes", "bending", "euler", STEP / 10)),
    Case(Way("forward Euler, 1 ms, no axial modes", "locked", "euler", STEP), law="locked"),
    Case(Way("semi-implicit Euler, 1 ms, no axial modes", "bending", "semi_implicit", STEP)),
    Case(Way("semi-implicit Euler, 0.1 ms", "axial", "semi_implicit", STEP / 10)),
    Case(Way("modal implicit, 1 ms", "axial", "modal_implicit", STEP)),
    Case(Way("modal midpoint, 1 ms", "axial", "modal_midpoint", STEP)),
    Case(REFERENCE),
    Case(replace(REFERENCE, model="bending"), damping=1.5),
)


class History(NamedTuple):
    """How the leading motion's share in the deviation grows: times (N,) and magnitudes (N,)."""

    t: np.ndarray
    share: np.ndarray


def table(library: Library, duration: float, progress: Callable[[str], None]) -> list[tuple[Growth, History]]:
    """All cases, disturbed by the paper's initial displacement made small, for at most `duration` seconds each."""
    rows = []
    for case in CASES:
        progress(case.way.name)
        rows.append(measure(library, case, duration))
    return rows


def measure(library: Library, case: Case, duration: float) -> tuple[Growth, History]:
    """One case."""
    model, way = getattr(library.arm, case.way.model), case.way
    law = library.arm.law(moving=False, damping=case.damping) if case.law == "PD" else None
    rest = equilibrium(model, law)
    S = sampled_map(model, way, law, rest)
    value, left, right = leading(S)
    predicted = np.log(abs(value)) / way.sample
    axial = bool(modal_columns(model, 1, "axial"))
    disturbance = start(model, axial, 1e-8 if predicted > 0 else 1e-7)
    time = min(duration, ENOUGH * way.sample if predicted > 100 else duration)
    motion = follow(library[way.model], law, rest + disturbance, way, time, large=1.0)
    deviation = np.hstack([motion.q - rest, motion.v])
    observed, by_size = fit(motion.t, deviation, left, model.nq)
    row = Growth(
        name=way.name,
        axial=axial,
        joints="locked" if law is None else "PD" if case.damping == 1 else f"PD, kd × {case.damping:g}",
        frequency=nearest_frequency(model, jacobian(model, rest, np.zeros(model.nq), controller=law), right),
        predicted=float(predicted),
        observed=observed,
        by_size=by_size if predicted * motion.t[-1] > DECADES * np.log(10) else None,
    )
    return row, History(motion.t, np.abs(deviation @ left))


def equilibrium(model: Model, law: PD | None) -> np.ndarray:
    """The coordinates (nq,) at which the arm rests under gravity and the law, by Newton's method."""
    q, nq = np.zeros(model.nq), model.nq
    if law:
        q[: model.n_joints] = law.q_des
    for _ in range(20):
        there = Linearised(model, q, np.zeros(nq), controller=law)
        stiffness = jacobian(model, q, np.zeros(nq), controller=law)[nq:, :nq]
        step = np.linalg.solve(stiffness, there.vdot)
        q = q - step
        if np.abs(step).max() < 1e-13:
            break
    return q


def sampled_map(model: Model, way: Way, law: PD | None, q: np.ndarray) -> np.ndarray:
    """The map from one torque to the next, linearised at rest at `q`: of `substeps` steps under one torque."""
    at = (model, way.method, q, np.zeros(model.nq), way.step)
    closed = step_map(*at, controller=law)
    if way.substeps == 1:
        return closed
    free = step_map(*at, tau=law(0.0, q, np.zeros(model.nq)))
    response, power = np.zeros_like(free), np.eye(len(free))
    for _ in range(way.substeps):
        response, power = response + power, power @ free
    return power + response @ (closed - free)


def leading(S: np.ndarray) -> tuple[complex, np.ndarray, np.ndarray]:
    """The eigenvalue of largest magnitude, its left and its right eigenvector."""
    values, left, right = scipy.linalg.eig(S, left=True)
    k = int(np.argmax(np.abs(values)))
    return values[k], left[:, k].conj(), right[:, k]


def nearest_frequency(model: Model, A: np.ndarray, shape: np.ndarray) -> float:
    """The frequency, Hz, of the eigenvector of `A` that is nearest to `shape`, by the modes' elastic energy."""
    values, vectors = np.linalg.eig(A)
    weight = np.sqrt(stiffness(model))[:, None]
    places, wanted = weight * vectors[: model.nq], weight[:, 0] * shape[: model.nq]
    k = int(np.argmax(np.abs(wanted @ places.conj()) / np.linalg.norm(places, axis=0)))
    return float(abs(values[k].imag) / (2 * np.pi))


def fit(t: np.ndarray, deviation: np.ndarray, left: np.ndarray, nq: int) -> tuple[float, float]:
    """Growth rates, 1/s, by least squares on logarithms over the samples in the linear range.

    Of the leading motion's share in the deviation, and of the size of the deviation, over the last half of them.
    """
    size = np.abs(deviation[:, :nq]).max(axis=1)
    beyond = np.flatnonzero(size > SMALL)
    end = beyond[0] if len(beyond) and beyond[0] > 3 else len(t)
    share, half = np.abs(deviation[:end] @ left), end // 2
    by_size = np.polyfit(t[half:end], np.log(np.linalg.norm(deviation[half:end], axis=1)), 1)[0]
    return float(np.polyfit(t[:end], np.log(share), 1)[0]), float(by_size)


def in_the_task(library: Library, way: Way) -> Growth:
    """The same for the paper's task itself, from its own start: how the run leaves one with a good integrator.

    Predicted at the good run's state in the middle of the stretch that is fitted, until the deviation is `VISIBLE`.
    """
    model, law = getattr(library.arm, way.model), library.arm.law()
    q0, good = start(model), replace(REFERENCE, model=way.model)
    run, other = (follow(library[way.model], law, q0, x, 0.1) for x in (good, way))
    count = min(len(run.t), len(other.t))
    deviation = np.hstack([other.q[:count] - run.q[:count], other.v[:count] - run.v[:count]])[1:]
    end = int(np.argmax(np.abs(deviation[:, : model.nq]).max(axis=1) > VISIBLE))
    k = 1 + end // 2
    near = Linearised(model, run.q[k], run.v[k], controller=lambda t, q, v: law(run.t[k], q, v))
    value, left, right = leading(near.step_map(way.method, way.step))
    observed = np.polyfit(run.t[1 : end + 1], np.log(np.abs(deviation[:end] @ left)), 1)[0]
    held = jacobian(model, run.q[k], run.v[k], controller=lambda t, q, v: law(run.t[k], q, v))
    return Growth(
        way.name,
        bool(modal_columns(model, 1, "axial")),
        "PD, the task",
        nearest_frequency(model, held, right),
        float(np.log(abs(value)) / way.step),
        float(observed),
        None,
    )


# ------------------------------------------------------------------------------ limits of the step


def step_limits(arm: Arm) -> list[tuple[str, float | None, float | None]]:
    """Per method the largest step, s, at which the arm held at its set points does not grow.

    With the axial modes and without; torques sampled every step. None: no such step below 20 ms ends it.
    """
    law = arm.law(moving=False)
    methods = ("euler", "semi_implicit", "modal_implicit", "modal_midpoint", "rk4")
    return [(m, *(largest_step(model, m, law) for model in (arm.axial, arm.bending))) for m in methods]


def largest_step(model: Model, method: str, law: PD | None) -> float | None:
    """The first step, from small to large, at which the spectral radius of the step map exceeds 1."""
    q = equilibrium(model, law)
    near = Linearised(model, q, np.zeros(model.nq), controller=law)
    if method == "euler":
        values = np.linalg.eigvals(jacobian(model, q, np.zeros(model.nq), controller=law))
        return float(max(0.0, (-2 * values.real / np.abs(values) ** 2).min()))
    stable = lambda h: growth(near.step_map(method, h)) <= 1 + 1e-12  # noqa: E731
    grid = np.geomspace(1e-5, 2e-2, 120)
    first = next((k for k, h in enumerate(grid) if not stable(h)), None)
    if first is None:
        return None
    low, high = grid[max(first - 1, 0)], grid[first]
    for _ in range(30):
        middle = (low + high) / 2
        low, high = (middle, high) if stable(middle) else (low, middle)
    return float(low)
