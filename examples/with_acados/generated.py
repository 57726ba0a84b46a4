"""The published task in generated C: `model.mpc` with move blocking, on the same step, weights and bounds."""

from __future__ import annotations

import tempfile
import time
import warnings
from pathlib import Path

import numpy as np

from screwgen import ModelValidityWarning
from screwgen.runtime.mpc import CompiledMpc

from .arm import FASTEST, GOAL, JOINT_RATES, JOINTS, LIMIT, MODE_RATES, MODES, TIP, TORQUES, H, Run, Task

PATTERNS = {
    "18": ((1, 4), (2, 3), (5, 5), (10, 3), (20, 3)),
    "25": ((1, 5), (3, 5), (7, 15)),
    "35": ((1, 10), (2, 10), (5, 10), (9, 5)),
}
"""Blocks of constant torques, as (intervals, how many such blocks), by their number."""
CHOSEN = "18"
ITERATIONS = 200
"""Of a quadratic program, at most."""
FACTOR = 1 / (TIP * H) * 1e4
"""Of the last stage: the tip's weight is then the published one; `controller` sets the others."""


def stated(task: Task, blocks: list[int]) -> str:
    """The controller's file."""
    entries = lambda x: "[" + ", ".join(f"{value:.17g}" for value in x) + "]"  # noqa: E731
    return f"""
[horizon]
intervals = {task.N}
step = {H}
blocks = {blocks}
[goal]
joints = {entries(GOAL)}
[cost]
tip_position = {TIP}
joints = {JOINTS}
joint_rates = {JOINT_RATES}
modes = {entries(MODES * task.modal)}
mode_rates = {entries(MODE_RATES * task.modal)}
torques = {entries(TORQUES)}
terminal = {{ factor = {FACTOR}, riccati = true }}
[bounds]
torques = {entries(LIMIT)}
joint_rates = {entries(FASTEST)}
[solver]
iterations = {ITERATIONS}
delay = 0
"""


def controller(task: Task, pattern: str = CHOSEN) -> CompiledMpc:
    """Compiled, with the last stage's published weights, from a cold start that rests at the start."""
    blocks = [length for length, count in PATTERNS[pattern] for _ in range(count)]
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelValidityWarning)  # axial loads: see the robot file
        file = Path(folder) / "mpc.toml"
        file.write_text(stated(task, blocks))
        out = task.model.mpc(file)
    weights = (task.problem.W, task.problem.W_end)
    stage, end = (np.diag(W)[: 2 * task.model.nq] for W in weights)
    out.options["terminal"][:] = np.diag(end - FACTOR * H * stage)
    (x, u), nq = task.ends[0], task.model.nq
    out.initialise(x[:nq], x[nq:], u)
    return out


def closed_loop(task: Task, control: CompiledMpc, plant, duration: float) -> Run:
    """What `arm.closed_loop` does with acados; `iterations` are those of DAQP."""
    rows, nq = [], task.model.nq
    for _ in range(round(duration / H)):
        begin = time.thread_time()
        control.prepare()
        preparation, x = time.thread_time() - begin, plant.x
        begin = time.thread_time()
        u = control.feedback(x[:nq], x[nq:])
        feedback, failed = time.thread_time() - begin, control.outcome != "solved"
        rows.append((x, u, plant.tip(), preparation, feedback, failed, control.iterations, control.states))
        plant.step(u)
    x, u, tip, preparation, feedback, failed, count, predicted = (np.array(c) for c in zip(*rows, strict=True))
    return Run(x, u, tip, preparation, feedback, int(np.count_nonzero(failed)), count, predicted)
