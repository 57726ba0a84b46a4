"""The planar arm of two flexible links as De Luca and Siciliano publish it, with hubs, a tip mass and deflections.

A. De Luca, B. Siciliano, Closed-form dynamic model of planar multilink lightweight robots, IEEE Trans. Systems, Man and
Cybernetics 21(4), 1991. The paper was not at hand: its coefficients b and h were read from a transcription for Matlab
by J. Alvaro Perez, 19 May 2016, which names it: github.com/andreabrugnoli/PHD_github, file `model_constants_bis.m` in
`MatlabProjects/PH/PH_TITOP/TwoLinks_Manipulator/DeLuca`. Here they are written for one shape a link. A Lagrangian of
its own stands between both. With turns of the tip section as they are it equals the tool's equations in every term.
With turns to first order, as the paper has them, and to first order in the deflections it equals the published ones.
"""

from __future__ import annotations

from functools import cache

import pytest
import sympy as sp
from textbook_robots import beam, symbols

import screwgen
from screwgen import Robot
from screwgen.backends.equations.equations import Equations

l1, l2, rho1, rho2, hub1, hub2, Jp, mh, mp = symbols("l_1 l_2 rhoA_1 rhoA_2 I_1 I_2a I_2b m_2a m_2b")
q = q1, q2, eta1, eta2 = symbols("q_1 q_2 eta_1 eta_2")
rates = v1, v2, w1, w2 = symbols("qdot_1 qdot_2 etadot_1 etadot_2")
x, c, s = symbols("x c s")
"""``c`` and ``s``: cosine and sine of the second link's turn in the frame of the first."""


def shape(length: sp.Symbol) -> sp.Expr:
    return sp.sqrt(5) * (x / length) ** 2


end1, end2 = (shape(length).subs(x, length) for length in (l1, l2))
slope1, slope2 = (shape(length).diff(x).subs(x, length) for length in (l1, l2))


def along(integrand: sp.Expr, length: sp.Symbol) -> sp.Expr:
    return sp.expand(sp.integrate(sp.expand(integrand), (x, 0, length)))


# -------- Lagrange's equations


def derivative(e: sp.Expr, k: int, exact: bool) -> sp.Expr:
    """By coordinate k; c and s turn with q_2, and where turns are exact with the first link's deflection."""
    turn = 1 if k == 1 else slope1 if k == 2 and exact else 0
    return e.diff(q[k]) + turn * (-s * e.diff(c) + c * e.diff(s))


def reduced(e: sp.Expr) -> sp.Expr:
    return sp.expand(sp.expand(e).subs(s**2, 1 - c**2))


def christoffel(M: sp.Matrix, exact: bool) -> sp.Matrix:
    """The velocity terms that follow from an inertia matrix."""
    terms = [
        [
            (derivative(M[i, j], k, exact) - derivative(M[j, k], i, exact) / 2) * rates[j] * rates[k]
            for j in range(4)
            for k in range(4)
        ]
        for i in range(4)
    ]
    return sp.Matrix([reduced(sp.Add(*row)) for row in terms])


@cache
def inertia(exact: bool) -> sp.Matrix:
    """Of the kinetic energy of beams, hubs and tip mass; turns of the first tip section exact or to first order."""
    bent = sp.eye(2) if exact else sp.Matrix([[1, -slope1 * eta1], [slope1 * eta1, 1]])
    first = sp.Matrix([x, shape(l1) * eta1])
    second = sp.Matrix([l1, end1 * eta1]) + bent * sp.Matrix([[c, -s], [s, c]]) * sp.Matrix([x, shape(l2) * eta2])

    def squared(place: sp.Matrix) -> sp.Expr:
        own = sum((derivative(place, k, exact) * rates[k] for k in (1, 2, 3)), sp.zeros(2, 1))
        velocity = own + v1 * sp.Matrix([-place[1], place[0]])
        return sp.expand(velocity.dot(velocity))

    outer, turning = squared(second), v1 + v2 + slope1 * w1
    twice = rho1 * along(squared(first), l1) + rho2 * along(outer, l2) + mh * outer.subs(x, 0) + mp * outer.subs(x, l2)
    twice += hub1 * v1**2 + hub2 * turning**2 + Jp * (turning + slope2 * w2) ** 2
    return sp.Matrix(4, 4, lambda i, j: reduced(sp.expand(twice).diff(rates[i], rates[j]) / 2))


# -------- the tool


@cache
def equations() -> Equations:
    def body(at: str, mass: float, moment: float) -> dict:
        return {"at": at, "mass": mass, "com": [0.0] * 3, "inertia": [moment] * 3 + [0.0] * 3}

    first = beam("first", 1.0, 0.9, 40.0) | {"bodies": [body("base", 0.3, 0.1)]}
    second = beam("second", 0.8, 0.6, 25.0) | {"bodies": [body("base", 1.0, 0.2), body("tip", 0.1, 5e-4)]}
    robot = Robot(name="published", gravity=[0.0, 0.0, 0.0], links=[first, second])
    return screwgen.derive(robot).equations()


def turned(matrix: sp.Matrix) -> sp.Matrix:
    angle = q2 + slope1 * eta1
    return matrix.subs({c: sp.cos(angle), s: sp.sin(angle)})


def test_every_term_is_lagrange_s():
    e, M = equations(), inertia(True)
    assert (e.expanded(e.M) - turned(M)).applyfunc(sp.expand) == sp.zeros(4, 4)
    velocity = e.expanded(e.C * sp.Matrix(e.qdot)) - turned(christoffel(M, True))
    assert velocity.applyfunc(sp.expand) == sp.zeros(4, 1)


# -------- the published form

m2, half = rho2 * l2, l2 / 2
first_moment = m2 * half + mp * l2
tip = along(rho2 * shape(l2), l2) + mp * end2
turn = along(rho2 * shape(l2) * x, l2) + Jp * slope2 + mp * l2 * end2
about = hub2 + rho2 * l2**3 / 3 + Jp + mp * l2**2
carried = mh + m2 + mp
t1, t2, t3 = (end1 - l1 * slope1) * eta1, tip * eta2, slope1 * eta1
reach = end1 + l1 * slope1
"""The published v_21 + m_p phi_21e is ``tip`` here, its t's are of one shape each."""


def published_inertia() -> sp.Matrix:
    """B; the paper norms its shapes so that b_331 and b_551 are masses, here these are the modes' own inertias."""
    B = sp.zeros(4, 4)
    B[0, 0] = hub1 + rho1 * l1**3 / 3 + about + carried * l1**2 + 2 * first_moment * l1 * c
    B[0, 0] += 2 * (first_moment * t1 - l1 * t2) * s
    B[0, 1] = about + first_moment * l1 * c + (first_moment * t1 - l1 * t2) * s
    B[0, 2] = along(rho1 * shape(l1) * x, l1) + about * slope1 + carried * l1 * end1
    B[0, 2] += first_moment * reach * c - reach * t2 * s
    B[0, 3] = turn + tip * l1 * c + tip * t1 * s
    B[1, 1], B[1, 3] = about, turn
    B[1, 2] = about * slope1 + first_moment * end1 * c - end1 * (t2 + first_moment * t3) * s
    B[2, 2] = along(rho1 * shape(l1) ** 2, l1) + carried * end1**2 + about * slope1**2
    B[2, 2] += 2 * end1 * slope1 * (first_moment * c - t2 * s)
    B[2, 3] = turn * slope1 + tip * end1 * (c - t3 * s)
    B[3, 3] = along(rho2 * shape(l2) ** 2, l2) + mp * end2**2 + Jp * slope2**2
    return sp.Matrix(4, 4, lambda i, j: B[min(i, j), max(i, j)])


def published_velocity_terms() -> list[sp.Expr]:
    G = first_moment
    h1 = (-2 * G * l1 * v2 + 2 * G * (end1 - l1 * slope1) * w1 - 2 * tip * l1 * w2) * v1 * s
    h1 += ((-G * l1 * v2 - G * l1 * slope1 * w1 - 2 * tip * l1 * w2) * v2 - 2 * tip * l1 * slope1 * w2 * w1) * s
    h1 += ((2 * G * v1 + G * v2 - tip * w2) * t1 - (2 * l1 * v1 + l1 * v2 + reach * w1) * t2) * v2 * c
    h2 = (G * l1 * v1 + 2 * G * end1 * w1) * v1 * s
    h2 += ((-(G * v1 + tip * w2) * t1 + (l1 * v1 + reach * w1) * t2) * v1) * c
    h2 += (end1 * slope1 * w1 * t2 + tip * end1 * w2 * t3) * w1 * c
    h3 = (-G * (end1 - l1 * slope1) * v1 - 2 * G * end1 * v2 - 2 * tip * end1 * w2) * v1 * s
    h3 -= (
        (G * end1 * v2 + 2 * G * end1 * slope1 * w1 + 2 * tip * end1 * w2) * v2 + 2 * tip * end1 * slope1 * w2 * w1
    ) * s
    h3 -= ((reach * v1 + end1 * v2 + 2 * end1 * slope1 * w1) * t2 + end1 * (G * v2 + tip * w2) * t3) * v2 * c
    h4 = tip * (l1 * v1 + 2 * end1 * w1) * v1 * s + tip * (t1 * v1 - end1 * w1 * t3) * v2 * c
    return [h1, h2, h3, h4]


def linear(e: sp.Expr) -> sp.Expr:
    """To first order in the deflections."""
    poly = sp.Poly(sp.expand(e), eta1, eta2)
    return sp.expand(sum(poly.coeff_monomial(term) * term for term in (sp.S.One, eta1, eta2)))


def test_the_published_inertia_is_that_of_turns_to_first_order():
    difference = inertia(False).applyfunc(linear) - published_inertia()
    assert difference.applyfunc(sp.expand) == sp.zeros(4, 4)


@pytest.mark.parametrize("row", range(4))
def test_the_published_velocity_terms_follow_from_the_published_inertia(row):
    """All but two of the first row: with h_107, a factor 2 is missing, that h_108 has; h_117 has the other sign."""
    missing = [(-first_moment * l1 * slope1 * w1 * s + 2 * tip * w2 * t1 * c) * v2, 0, 0, 0]
    follows = linear(christoffel(published_inertia(), False)[row])
    assert sp.expand(follows - published_velocity_terms()[row] - missing[row]) == 0
