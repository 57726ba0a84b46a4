"""The arm of Section 7 as a frame of beam elements: a judge of frequencies that shares nothing with the derivation.

Two-node Euler-Bernoulli elements with consistent mass; bending in both planes, axial, and rigid in torsion, as a link
is without a torsional stiffness.  Joints are locked, there is no gravity.  A link that follows the section on which it
sits shares the rotation of that node; one that does not (the paper's zero rotational coordinates) keeps its direction.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
import scipy.linalg
from scipy.spatial.transform import Rotation

from .arm import AXES, LENGTHS, MASSES, ROD, SET_POINTS, turn

ELEMENTS = 24
"""Elements per link: the lowest frequencies have converged to nine digits."""


@dataclass(frozen=True)
class Bar:
    """A straight link: rotation (3, 3) from its axes to the inertial frame, length, and the mass at its tip."""

    R: np.ndarray
    length: float
    tip_mass: float
    EIy: float = ROD.EIy
    EIz: float = ROD.EIz


def arm_bars(angles: Sequence[float] = SET_POINTS) -> list[Bar]:
    """The two links of the arm at joint angles ``theta_y1, theta_z1, theta_z2``."""
    R, bars, left = Rotation.identity(), [], list(angles)
    for axes, length, mass in zip(AXES, LENGTHS, MASSES, strict=True):
        R = R * turn(axes, [left.pop(0) for _ in axes])
        bars.append(Bar(R.as_matrix(), length, mass))
    return bars


@cache
def arm_frequencies(section_rotation: bool = True) -> np.ndarray:
    """The lowest natural frequencies of the arm in Hz, joints locked in the posture of the set points."""
    return frequencies(arm_bars(), section_rotation)


def frequencies(bars: Sequence[Bar], section_rotation: bool = True, elements: int = ELEMENTS) -> np.ndarray:
    """The natural frequencies in Hz, ascending."""
    size = len(bars) * 5 * elements
    K, M = np.zeros((size, size)), np.zeros((size, size))
    place, turn = np.zeros((3, size)), np.zeros((3, size))
    for n, bar in enumerate(bars):
        if not section_rotation:
            turn = np.zeros((3, size))
        place, turn = _add_bar(K, M, bar, place, turn, elements, 5 * elements * n)
    periods = scipy.linalg.eigh(M, K, eigvals_only=True)[::-1]  # squared; the largest lose no digits
    return 1 / np.sqrt(np.maximum(periods, np.finfo(float).tiny)) / (2 * np.pi)


def _add_bar(
    K: np.ndarray, M: np.ndarray, bar: Bar, place: np.ndarray, turn: np.ndarray, elements: int, first: int
) -> tuple[np.ndarray, np.ndarray]:
    """Add a bar on a node whose displacement and rotation (3, size) are given; returns those of its tip."""
    h, spin = bar.length / elements, bar.R[:, :1].T @ turn
    stiff, mass = element(bar, h)
    into = scipy.linalg.block_diag(*[bar.R.T] * 4)
    M += ROD.rhoIp * bar.length * spin.T @ spin
    for k in range(elements):
        after, bent, at = np.zeros_like(place), np.zeros_like(place), first + 5 * k
        after[:, at : at + 3], bent[:, at + 3 : at + 5] = np.eye(3), bar.R[:, 1:]
        bent += bar.R[:, :1] @ spin
        B = into @ np.vstack([place, turn, after, bent])
        used = np.flatnonzero(np.abs(B).max(axis=0))
        K[np.ix_(used, used)] += B[:, used].T @ stiff @ B[:, used]
        M[np.ix_(used, used)] += B[:, used].T @ mass @ B[:, used]
        place, turn = after, bent
    M += bar.tip_mass * place.T @ place
    return place, turn


def element(bar: Bar, h: float) -> tuple[np.ndarray, np.ndarray]:
    """Stiffness and mass (12, 12) over ``[u, theta, u, theta]`` of the two nodes, in the bar's axes."""
    K, M = np.zeros((12, 12)), np.zeros((12, 12))
    axial, pair = np.ix_([0, 6], [0, 6]), np.array([[1.0, -1], [-1, 1]])
    K[axial], M[axial] = ROD.EA / h * pair, ROD.rhoA * h / 6 * (1 + np.eye(2))
    for EI, turned, sign in ((bar.EIz, (1, 5, 7, 11), 1), (bar.EIy, (2, 4, 8, 10), -1)):
        slope = np.array([1, sign * h, 1, sign * h])  # the slope of u_z is minus the turn about y
        at = np.ix_(turned, turned)
        K[at], M[at] = (
            EI / h**3 * np.outer(slope, slope) * BENT,
            ROD.rhoA * h / 420 * np.outer(slope, slope) * MOVED,
        )
    return K, M


BENT = np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]])
MOVED = np.array([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]])
"""Of the cubic element, over displacement and slope times h of both nodes."""
