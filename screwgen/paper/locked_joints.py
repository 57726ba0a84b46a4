"""The arm of Section 7 with its joints welded: what wrenches in the modal rows, and biases, do to it."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.polynomial import Polynomial

from ..model import derive
from ..studies.modes import natural_frequencies
from .arm import FREE_FALL, LENGTHS, MASSES, ROD, STILL, ella

STEP = 1e-6
"""m: by how much modal coordinates are varied; the forces are linear in them but for parts of second order."""


@cache
def frequencies_without_wrenches() -> tuple[float, ...]:
    """The natural frequencies, Hz, ascending, with the wrench columns of the modal rows zero, as (85) has them.

    One clamped-free mode per direction, as in the paper: for bare links these are exact.
    """
    model = derive(ella(locked=True, gravity=STILL, bodies_beyond=True))
    r, n, numeric = model.nq, model.n_links, model.numpy()
    wrenches = [12 * i + k for i in range(n) for k in range(6)]

    def acceleration(eta: np.ndarray) -> np.ndarray:
        M, H, W = numeric.assemble(numeric.dae_state(eta, 0 * eta), np.zeros(0), np.zeros((n, 6)))
        M[np.ix_(range(12 * n, 12 * n + r), wrenches)] = 0.0
        return np.linalg.solve(M, W - H)[12 * n :]

    sides = [(acceleration(e) - acceleration(-e)) / (2 * STEP) for e in STEP * np.eye(r)]
    squares = np.linalg.eigvals(-np.array(sides).T)
    return tuple((np.sqrt(np.sort(squares.real)) / (2 * np.pi)).tolist())


@cache
def derived_frequencies() -> tuple[float, ...]:
    """The natural frequencies, Hz, of the derived model with two polynomial modes per link and plane."""
    return tuple(natural_frequencies(derive(ella(2, "polynomial", locked=True))).tolist())


@cache
def base_force_at_rest() -> tuple[float, float]:
    """The force of the ground on the resting rigid arm, N: without ``h_s`` in ``h_dyn``, and with it.

    At rest ``h_Ms`` and ``h_MD`` are zero: without ``h_s`` the rows of the links have no bias at all.
    """
    model = derive(ella(0, axial=0, locked=True))
    numeric, nothing = model.numpy(), np.zeros(0)
    M, H, W = numeric.assemble(numeric.dae_state(nothing, nothing), nothing, np.zeros((model.n_links, 6)))
    force = lambda bias: float(np.linalg.norm(np.linalg.solve(M, W - bias)[3:6]))  # noqa: E731
    return force(0 * H), force(H)


def weight() -> float:
    """The weight of the arm, N."""
    return -FREE_FALL[2] * (ROD.rhoA * sum(LENGTHS) + sum(MASSES))


def tip_deflection(force: float) -> tuple[float, float]:
    """The deflection of the clamped link 2 under a force at its tip, m: by the weak form in s², s³, and by statics."""
    L, EI = LENGTHS[1], ROD.EIz
    shapes = [Polynomial([0, 0, 1]), Polynomial([0, 0, 0, 1])]
    energy = lambda p, q: float((p.deriv(2) * q.deriv(2)).integ()(1.0)) * EI / L**3  # noqa: E731
    K, tip = np.array([[energy(p, q) for q in shapes] for p in shapes]), np.array([p(1.0) for p in shapes])
    return float(tip @ np.linalg.solve(K, tip * force)), force * L**3 / (3 * EI)
