"""Natural frequencies of the arm: by basis and count, with and without section rotation, printed and derived."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

import screwgen
from screwgen import PD, Model, Robot, natural_frequencies
from screwgen.algorithms.dae_functions import unknown_size
from screwgen.studies.analysis.spectrum import jacobian

from .arm import SET_POINTS, Arm, bodies_beyond_the_joints, choose_gains, welded, with_modes
from .growth import equilibrium

COUNT = 4
"""How many frequencies a row of the table has."""
BASES = (("clamped_free", 1), ("clamped_free", 5), ("polynomial", 2), ("polynomial", 6))
QUICK = (("clamped_free", 1), ("polynomial", 2))
"""Basis and modes per plane; the last of `BASES` has converged."""
CHOSEN, CHOSEN_AT_START = "PD as chosen", "PD as chosen, at q = 0"
DIFFERENCE = 1e-6
"""m: by how much modal coordinates are varied; without gravity the forces are linear to the square of it."""


@dataclass(frozen=True)
class Row:
    """The lowest frequencies, Hz, of one kind of model for each choice of basis: (bases, COUNT)."""

    name: str
    frequencies: tuple[tuple[float, ...], ...]


def table(arm: Arm, bases=BASES) -> list[Row]:
    """Joints locked in the posture of the set points, without gravity."""
    kinds = {
        "derived, with section rotation": locked,
        "derived, without section rotation": partial(locked, rotation=False),
        "wrench columns of the modal rows dropped": dropped,
    }
    return [Row(name, tuple(found(arm.robot, *basis) for basis in bases)) for name, found in kinds.items()]


def flexible(robot: Robot, basis: str, count: int, rotation: bool = True) -> Robot:
    """The robot with one axial mode per link and `count` modes per bending plane."""
    return with_modes(robot, rotation, basis=basis, axial=1, bending_y=count, bending_z=count)


def locked(robot: Robot, basis: str, count: int, rotation: bool = True) -> tuple[float, ...]:
    model = screwgen.derive(flexible(robot, basis, count, rotation))
    q = np.append(SET_POINTS, np.zeros(model.nq - len(SET_POINTS)))
    return tuple(natural_frequencies(model, q)[:COUNT].tolist())


def dropped(robot: Robot, basis: str, count: int) -> tuple[float, ...]:
    """The frequencies that (85) and (103) give: no wrench in the modal rows (E16), no body in them (E34)."""
    return tuple(assembled(welded_chain(robot, basis, count), drop=True)[:COUNT].tolist())


def welded_chain(robot: Robot, basis: str, count: int) -> Model:
    """The arm welded in the posture, its bodies where they reach the modes through joint wrenches alone."""
    chain = bodies_beyond_the_joints(welded(flexible(robot, basis, count), SET_POINTS))
    stub = chain.links[-1].model_copy(update={"modes": screwgen.Modes()})
    still = {"gravity": (0.0, 0.0, 0.0), "links": (*chain.links[:-1], stub)}
    return screwgen.derive(chain.model_copy(update=still))


def assembled(model: Model, drop: bool) -> np.ndarray:
    """All frequencies, Hz, ascending, of the assembled system (100) at rest; `drop`: modal rows without wrenches."""
    n, size, numeric = model.nq, unknown_size(model.chain), model.numpy()
    wrenches = [12 * i + k for i in range(model.n_links) for k in range(6)]

    def acceleration(eta: np.ndarray) -> np.ndarray:
        x = numeric.dae_state(eta, np.zeros(n))
        M, H, W = numeric.assemble(x, np.zeros(0), np.zeros((model.n_links, 6)))
        if drop:
            M[np.ix_(range(size - n, size), wrenches)] = 0.0
        return np.linalg.solve(M, W - H)[size - n :]

    sides = [(acceleration(e) - acceleration(-e)) / (2 * DIFFERENCE) for e in DIFFERENCE * np.eye(n)]
    squares = np.linalg.eigvals(-np.array(sides).T)
    return np.sqrt(np.sort(squares.real)) / (2 * np.pi)


# ------------------------------------------------------------------------------ with the joints' control


@dataclass(frozen=True)
class Loop:
    """The oscillating motions of the arm held by PD at the set points: frequencies, Hz, and decay rates, 1/s."""

    name: str
    frequencies: tuple[float, ...]
    decay: tuple[float, ...]


def loops(arm: Arm) -> list[Loop]:
    """From free joints over softer and stiffer PD laws to locked joints, at the set points, one mode per plane.

    `STIFFNESS` times 1/2, 1, 2, 4: the gains kp times the square, kd as chosen.
    """
    q = np.append(SET_POINTS, np.zeros(arm.bending.nq - 3))
    free = natural_frequencies(arm.bending, q, "free")
    fixed = natural_frequencies(arm.bending, q)
    rows = [Loop("joints free, no gravity", *undamped(free[free > 0]))]
    kp, kd = choose_gains(arm.rigid, arm.bending)
    for factor in (0.5, 1.0, 2.0, 4.0):
        law = PD(tuple(map(float, factor**2 * kp)), tuple(map(float, kd)), SET_POINTS)
        name = CHOSEN if factor == 1 else f"PD, kp × {factor**2:g}"
        rows.append(Loop(name, *oscillations(arm.bending, law)))
    law = PD(tuple(map(float, kp)), tuple(map(float, kd)), (0.0,) * 3)
    rows.append(Loop(CHOSEN_AT_START, *oscillations(arm.bending, law)))
    return [*rows, Loop("joints locked, no gravity", *undamped(fixed))]


def undamped(frequencies: np.ndarray) -> tuple[tuple[float, ...], tuple[float, ...]]:
    return tuple(frequencies[:COUNT].tolist()), (0.0,) * len(frequencies[:COUNT])


def oscillations(model: Model, law: PD) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """The lowest oscillating motions about rest under gravity: those that turn faster than they decay."""
    values = np.linalg.eigvals(jacobian(model, equilibrium(model, law), np.zeros(model.nq), controller=law))
    turning = sorted((x for x in values if x.imag > abs(x.real)), key=lambda x: x.imag)[:COUNT]
    return tuple(float(x.imag / (2 * np.pi)) for x in turning), tuple(float(-x.real) for x in turning)
