"""The judges of Section 7: shapes by their boundary conditions, frequencies by Ritz's method, steps by stepping."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import cos, cosh, exp, hypot, log, pi, sin, sinh, sqrt

import numpy as np
import sympy as sp
from scipy.optimize import brentq

from .arm import AXES, LENGTHS, ROD, SET_POINTS, turn
from .clamped_beam import Beam, places
from .moving_link import exponential_coordinates

STEPS = 200
Shape = Callable[[int], Callable]
"""The derivatives of a function, by their order."""
FOREARM = Beam(LENGTHS[1], ROD.EIz, ROD.rhoA)
"""The paper's second link, clamped, bending in y, without its payload."""


def root(n: int, mu: float = 0.0) -> float:
    """The n-th wavenumber times length of a clamped beam with a tip mass of ``mu`` times its own."""
    f = lambda x: cos(x) + 1 / cosh(x) + mu * x * (cos(x) * sinh(x) - sin(x) * cosh(x)) / cosh(x)  # noqa: E731
    return brentq(f, (n - 1) * pi + 1e-9, n * pi, xtol=1e-15, rtol=1e-15)


# ------------------------------------------------------------------------------------------- shapes


def ratio(wave: float) -> float:
    """``r_phi`` at ``beta L``."""
    return (sinh(wave) - sin(wave)) / (cosh(wave) + cos(wave))


def values(right: sp.Expr, **given: float) -> Shape:
    """The derivatives of a shape as functions of xi: its symbols by the letter of their LaTeX."""
    known = {s: given[s.name.strip("\\").partition("_")[0]] for s in right.free_symbols if s.name != r"\xi_i"}
    xi = sp.Symbol(r"\xi_i")
    shape = right.subs(known).doit()
    return lambda order: sp.lambdify(xi, sp.diff(shape, xi, order), "numpy")


def bending(right: sp.Expr, n: int, L: float) -> Shape:
    """The n-th shape of a bending formula on a link of length L."""
    wave = root(n)
    return values(right, a=1.0, beta=wave / L, r=ratio(wave))


def gram(shapes: Sequence[Shape], L: float) -> np.ndarray:
    """Integrals of the products of shapes, by quadrature."""
    s, weights = places()
    found = np.array([shape(0)(s * L) for shape in shapes])
    return L * (found * weights) @ found.T


def bending_misfit(right: sp.Expr, n: int, L: float) -> float:
    """The worst of: displacement and slope at the clamp, moment and shear at the tip, overlap with the next shape."""
    shape, wave = bending(right, n, L), root(n)
    ends = [(0, 0.0), (1, 0.0), (2, L), (3, L)]
    conditions = [abs(shape(k)(at)) * (L / wave) ** k / greatest(shape, L) for k, at in ends]
    G = gram([shape, bending(right, n - 1 if n > 1 else 2, L)], L)
    return float(max(*conditions, abs(G[0, 1]) / sqrt(G[0, 0] * G[1, 1])))


def axial_misfit(right: sp.Expr, L: float) -> float:
    """The worse of: displacement at the clamp, strain at the tip."""
    shape = values(right, a=1.0, L=L)
    return float(max(abs(shape(0)(0.0)), abs(shape(1)(L)) * 2 * L / pi) / greatest(shape, L))


def greatest(shape: Shape, L: float) -> float:
    return float(np.abs(shape(0)(np.linspace(0, L, 101))).max())


def tip_deflection(shape: Shape, L: float) -> float:
    """Of a clamped beam that bends in one shape alone, the deflection under a force at its tip over the exact one."""
    s, weights = places()
    return 3 * shape(0)(L) ** 2 / (L**4 * (weights @ shape(2)(s * L) ** 2))


def drawn(seed: int) -> Beam:
    """A random beam."""
    random = np.random.default_rng(seed)
    return Beam(*random.uniform([0.5, 500, 0.5], [2.0, 5000, 3.0]))


def mode(seed: int) -> int:
    """The mode to judge by: one of the first three."""
    return 1 + (seed - 1) % 3


def free_end(right: sp.Expr, seed: int) -> float:
    """How far moment and shear of the clamped-free shape are from zero at the free end, with this ratio."""
    L, wave = drawn(seed).L, root(mode(seed))
    (beta,) = right.free_symbols - {sp.Symbol("L")}
    r = float(right.subs({beta: wave / L, sp.Symbol("L"): L}).doit())
    moment = cosh(wave) + cos(wave) - r * (sinh(wave) + sin(wave))
    shear = sinh(wave) - sin(wave) - r * (cosh(wave) + cos(wave))
    return max(abs(moment), abs(shear)) / (cosh(wave) + r * sinh(wave))


def wavenumber(right: sp.Expr, seed: int) -> float:
    """beta_n by the formula from the frequencies of a beam by Ritz's method, against the clamped-free root."""
    beam = drawn(seed)
    given = {"f_n": beam.frequencies(mode(seed))[-1], r"\rho A": beam.rhoA, "EI": beam.EI}
    beta = sqrt(float(right.subs({sp.Symbol(name): value for name, value in given.items()}).doit()))
    return abs(beta * beam.L / root(mode(seed)) - 1)


# ------------------------------------------------------------------------------------------- steps


def euler_growth(omega: float, h: float, steps: int = STEPS) -> float:
    """The factor by which forward Euler multiplies an oscillation's amplitude per step, by stepping it."""
    x, v, total = 1.0, 0.0, 0.0
    for _ in range(steps):
        x, v = x + h * v * omega, v - h * x * omega
        size = hypot(x, v)
        x, v, total = x / size, v / size, total + log(size)
    return exp(total / steps)


def symplectic_bears(omega: float, h: float, steps: int = 4000) -> bool:
    """Whether symplectic Euler keeps an oscillation bounded."""
    x, v, bound = 1.0, 0.0, 1e6
    for _ in range(steps):
        v -= h * omega * x
        x += h * omega * v
        if abs(x) > bound:
            return False
    return True


def symplectic_limit(omega: float) -> float:
    """The largest step that symplectic Euler bears, by trying."""
    low, high = 0.5 / omega, 8.0 / omega
    for _ in range(30):
        middle = (low + high) / 2
        low, high = (middle, high) if symplectic_bears(omega, middle, 1000) else (low, middle)
    return low


def stability(seed: int) -> tuple[float, float]:
    """Forward Euler at 0.9 of the printed bound: by how much it grows per step, against none and against the root."""
    omega = 2 * pi * drawn(seed).frequencies(1)[0]
    h = 0.9 * 2 / omega
    grown = euler_growth(omega, h)
    derived = abs(grown / sqrt(1 + (omega * h) ** 2) - 1)
    limits = symplectic_bears(omega, 0.999 * 2 / omega) and not symplectic_bears(omega, 1.001 * 2 / omega)
    waves = [abs(root(n) / sqrt(w) - 1) for n, w in enumerate(np.sqrt(Beam(1, 1, 1).squares[:3]), 1)]
    return grown - 1, max(derived, *waves) if limits else 1.0


def second_mode(seed: int) -> tuple[float, float]:
    """Second over first frequency of a clamped beam with a load at its tip: the unloaded beam's, and its own roots'."""
    beam = drawn(seed)
    loaded = Beam(beam.L, beam.EI, beam.rhoA, np.random.default_rng(seed).uniform(0.5, 2.0) * beam.rhoA * beam.L)
    first, second = loaded.frequencies(2)
    mu = loaded.tip_mass / (beam.rhoA * beam.L)
    gap = lambda x: abs(x * first / second - 1)  # noqa: E731
    return gap((4.6941 / 1.8751) ** 2), gap((root(2, mu) / root(1, mu)) ** 2)


def section(seed: int) -> tuple[float, float]:
    """A frequency of the second link in z: the two statements of its stiffness against Ritz's method."""
    truth = Beam(LENGTHS[1], ROD.EIy, ROD.rhoA).frequencies(mode(seed))[-1]
    found = lambda EI: root(mode(seed)) ** 2 / (2 * pi * LENGTHS[1] ** 2) * sqrt(EI / ROD.rhoA)  # noqa: E731
    gap = lambda EI: abs(found(EI) / truth - 1)  # noqa: E731
    return gap(3.67e3), gap(2.12e3)


# --------------------------------------------------------------------------------------- control law


def rotation_vector(axes: str, *angles: float) -> np.ndarray:
    """The exponential coordinates of turns about axes in order, such as "yz" of the universal joint."""
    return exponential_coordinates(turn(axes, list(angles)).as_matrix())[:, 0]


def loop_work(gains: np.ndarray, radius: float, points: int = 128) -> tuple[float, float, float]:
    """The work in J of the proportional torque round a circle of joint angles about the set point.

    With exponential coordinates of the link and body-fixed torques; with joint angles; and the first one's amount.
    """
    centre = np.array(SET_POINTS[:2])
    target = rotation_vector(AXES[0], *centre)
    printed, joints, amount = 0.0, 0.0, 0.0
    for t in 2 * pi * np.arange(points) / points:
        q, dq = centre + radius * np.array([cos(t), sin(t)]), radius * np.array([-sin(t), cos(t)])
        omega = dq[0] * turn("z", [-q[1]]).apply([0, 1, 0]) + dq[1] * np.array([0, 0, 1])
        torque = gains * (target - rotation_vector(AXES[0], *q))
        printed += torque @ omega * 2 * pi / points
        amount += abs(torque @ omega) * 2 * pi / points
        joints += float(gains[1:] @ ((centre - q) * dq)) * 2 * pi / points
    return printed, joints, amount


def control_law(seed: int) -> tuple[float, float]:
    """The work round a closed path of joint angles, relative to what is exchanged on it: zero for a spring."""
    printed, joints, amount = loop_work(np.random.default_rng(seed).uniform(50, 200, 2)[[0, 1, 1]], 0.5)
    return abs(printed) / amount, abs(joints) / amount
