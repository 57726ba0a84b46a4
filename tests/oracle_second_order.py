"""The oracle's second-order shape of a rod, by numerical integration of its strains; no package code.

``u_2 = ∫(∫ psi x (kappa x e_x) + psi x gamma)`` and ``theta_2 = 1/2 ∫ psi x kappa`` along the rod, mode by mode, as
Chebyshev series: every component is a quadratic form in the modal coordinates.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from oracle_shapes import DIRECTIONS, clamped_free, polynomial, tabulate

DEGREE = 60


class SecondOrder(NamedTuple):
    """Symmetric matrices H with 1/2 eta^T H eta the second-order displacement (m) or turn (rad) along an axis."""

    place: np.ndarray  # (3, r, r, N), at the nodes
    tip: np.ndarray  # (3, r, r)
    turn: np.ndarray  # (3, r, r), at the tip


@cache
def points() -> np.ndarray:
    """Chebyshev points on [-1, 1]; the abscissa is s = (x + 1) / 2."""
    return np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))


@cache
def derivatives(direction: str, basis: str, modes: int) -> np.ndarray:
    """(3, r, points): value, first and second derivative with s."""
    s = (points() + 1) / 2
    order = 2 if direction.startswith("bending") else 1
    if order == 1 and basis == "clamped_free":
        wave = (2 * np.arange(1, modes + 1)[:, None] - 1) * np.pi / 2
        return np.sqrt(2) * np.array([np.sin(wave * s), wave * np.cos(wave * s), -(wave**2) * np.sin(wave * s)])
    functions = clamped_free(modes) if basis == "clamped_free" else polynomial(modes, order)
    return tabulate(functions, s)


def strains(basis: str, counts: dict[str, int], length: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """``psi``, ``kappa``, ``gamma`` of every mode, (r, 3, points) each."""
    psi, kappa, gamma = [], [], []
    e_x, e_y, e_z = np.eye(3)
    for direction in DIRECTIONS:
        for k in range(counts[direction]):
            value, slope, curvature = derivatives(direction, basis, counts[direction])[:, k]
            turn, bent, stretched = {
                "bending": (slope / length, curvature / length**2, 0 * value),
                "torsion": (value, slope / length, 0 * value),
            }.get(direction.partition("_")[0], (0 * value, 0 * value, slope / length))
            axis = {"bending_y": e_z, "bending_z": -e_y}.get(direction, e_x)
            psi.append(np.outer(axis, turn))
            kappa.append(np.outer(axis, bent))
            gamma.append(np.outer({"shear_y": e_y, "shear_z": e_z}.get(direction, e_x), stretched))
    return tuple(np.array(x).reshape(-1, 3, DEGREE + 1) for x in (psi, kappa, gamma))


def integrated(values: np.ndarray, length: float, times: int) -> np.ndarray:
    """Chebyshev coefficients, along the first axis, of the integral from the base, taken so many times."""
    flat = values.reshape(-1, values.shape[-1]).T
    series = chebyshev.chebfit(points(), flat, DEGREE)
    for _ in range(times):
        series = chebyshev.chebint(series, lbnd=-1, scl=length / 2)
    return series.reshape(len(series), *values.shape[:-1])


def second_order(basis: str, counts: dict[str, int], length: float, nodes: np.ndarray, end: float = 1.0) -> SecondOrder:
    """The second-order shape of a rod at its nodes (s) and at its tip, or at another section, `end`."""
    psi, kappa, gamma = strains(basis, counts, length)
    across = lambda a, b: np.cross(a[:, None], b[None], axis=2)  # noqa: E731  (r, r, 3, points)
    swung = np.stack([0 * kappa[:, 0], kappa[:, 2], -kappa[:, 1]], axis=1)  # kappa x e_x
    curved = across(psi, swung)
    twice, once = integrated(curved, length, 2), integrated(across(psi, gamma), length, 1)
    turned = integrated(across(psi, kappa) / 2, length, 1)
    symmetric = lambda x: np.moveaxis(x + np.swapaxes(x, 0, 1), 2, 0)  # noqa: E731
    place = lambda x: chebyshev.chebval(x, twice) + chebyshev.chebval(x, once)  # noqa: E731
    at_nodes = np.moveaxis(np.array([place(2 * s - 1) for s in nodes]), 0, -1)
    x = 2 * end - 1
    return SecondOrder(symmetric(at_nodes), symmetric(place(x)), symmetric(chebyshev.chebval(x, turned)))
