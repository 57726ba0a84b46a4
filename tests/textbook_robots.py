"""Robots of textbooks, as robot files state them, and their equations in the textbooks' form.

Each has inertia matrix, velocity terms (of Christoffel's symbols) and forces at rest, and names where the form stands.
The symbols are those of the tool; where a source has another letter or zero, the docstring says which. The books were
not at hand when these were written down. The forms that were compared with pages that print them are listed with their
addresses in `docs/research.md`; De Luca and Siciliano's arm with all its terms: `tests/test_published_arm.py`, their
single link with hub and payload: `tests/test_published_link.py`.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import sympy as sp

import screwgen
from screwgen import Robot

DIGESTS = Path(__file__).with_suffix(".sha256")
"""`python tests/textbook_robots.py` writes it."""
DOWN = [0.0, 1.5707963267948966, 0.0]
"""A mount that lets the x axis of a link hang down where gravity is along -z."""


@dataclass(frozen=True)
class Textbook:
    """A robot with its equations in the textbook's form.

    ``M``: the inertia matrix; ``velocity``: the terms of Coriolis, centrifugal and damping forces; ``rest``: those of
    weight and springs.
    """

    robot: dict
    source: str
    M: sp.Matrix
    velocity: sp.Matrix
    rest: sp.Matrix


def symbols(names: str) -> list[sp.Symbol]:
    return [sp.Symbol(name) for name in names.split()]


def lump(mass: float, x: float, inertia: float) -> dict:
    """A rigid body on the x axis of a link."""
    return {"at": "base", "mass": mass, "com": [x, 0.0, 0.0], "inertia": [inertia, inertia, inertia, 0.0, 0.0, 0.0]}


def double_pendulum() -> Textbook:
    """Two point masses at the ends of massless links in a vertical plane."""
    links = [
        {"name": "upper", "length": 0.9, "joint": {"axes": ["z"]}, "bodies": [{"at": "tip", "mass": 2.0}]},
        {"name": "lower", "length": 0.7, "joint": {"axes": ["z"]}, "bodies": [{"at": "tip", "mass": 1.2}]},
    ]
    m1, m2, l1, l2, g = symbols("m_1 m_2 l_1 l_2 g")
    q1, q2, v1, v2 = symbols("q_1 q_2 qdot_1 qdot_2")
    c2, s2, c1, c12 = sp.cos(q2), sp.sin(q2), sp.cos(q1), sp.cos(q1 + q2)
    M12 = m2 * l2**2 + m2 * l1 * l2 * c2
    return Textbook(
        {"name": "double_pendulum", "gravity": [0.0, -9.81, 0.0], "links": links},
        "Craig, Introduction to Robotics, 3rd ed., section 6.7, (6.59)-(6.61)",
        sp.Matrix([[l2**2 * m2 + 2 * l1 * l2 * m2 * c2 + l1**2 * (m1 + m2), M12], [M12, l2**2 * m2]]),
        sp.Matrix([-m2 * l1 * l2 * s2 * v2**2 - 2 * m2 * l1 * l2 * s2 * v1 * v2, m2 * l1 * l2 * s2 * v1**2]),
        sp.Matrix([m2 * l2 * g * c12 + (m1 + m2) * l1 * g * c1, m2 * l2 * g * c12]),
    )


def two_link() -> Textbook:
    """The planar elbow manipulator with distributed mass; the book's l_c is c here."""
    links = [
        {"name": "upper", "length": 1.0, "joint": {"axes": ["z"]}, "bodies": [lump(2.0, 0.4, 0.2)]},
        {"name": "fore", "length": 0.8, "joint": {"axes": ["z"]}, "bodies": [lump(1.1, 0.3, 0.1)]},
    ]
    m1, m2, l1, lc1, lc2, I1, I2, g = symbols("m_1 m_2 l_1 c_1 c_2 I_1 I_2 g")
    q1, q2, v1, v2 = symbols("q_1 q_2 qdot_1 qdot_2")
    d11 = m1 * lc1**2 + m2 * (l1**2 + lc2**2 + 2 * l1 * lc2 * sp.cos(q2)) + I1 + I2
    d12 = m2 * (lc2**2 + l1 * lc2 * sp.cos(q2)) + I2
    d22 = m2 * lc2**2 + I2
    h = -m2 * l1 * lc2 * sp.sin(q2)
    g2 = m2 * lc2 * g * sp.cos(q1 + q2)
    C = sp.Matrix([[h * v2, h * v2 + h * v1], [-h * v1, 0]])
    return Textbook(
        {"name": "two_link", "gravity": [0.0, -9.81, 0.0], "links": links},
        "Spong, Hutchinson, Vidyasagar, Robot Modeling and Control, 1st ed., section 7.4, planar elbow manipulator",
        sp.Matrix([[d11, d12], [d12, d22]]),
        C * sp.Matrix([v1, v2]),
        sp.Matrix([(m1 * lc1 + m2 * l1) * g * sp.cos(q1) + g2, g2]),
    )


def crane() -> Textbook:
    """A trolley with a load on a rope that stays straight; with the trolley's friction."""
    links = [
        {
            "name": "trolley",
            "joint": {"axes": [{"slide": "x"}], "damping": [3.0]},
            "bodies": [{"at": "base", "mass": 40.0}],
        },
        {
            "name": "rope",
            "length": 2.5,
            "joint": {"axes": ["y"], "mount": {"rpy": DOWN}},
            "bodies": [{"at": "tip", "mass": 15.0}],
        },
    ]
    m1, m2, l2, d1, g = symbols("m_1 m_2 l_2 d_1 g")
    q2, v1, v2 = symbols("q_2 qdot_1 qdot_2")
    M12 = -m2 * l2 * sp.cos(q2)
    return Textbook(
        {"name": "crane", "gravity": [0.0, 0.0, -9.81], "links": links},
        "Khalil, Nonlinear Systems, 3rd ed., section 1.2 and exercise 1.15; Ogata, Modern Control Engineering, crane",
        sp.Matrix([[m1 + m2, M12], [M12, m2 * l2**2]]),
        sp.Matrix([m2 * l2 * sp.sin(q2) * v2**2 + d1 * v1, 0]),
        sp.Matrix([0, m2 * g * l2 * sp.sin(q2)]),
    )


def spherical_pendulum() -> Textbook:
    """A mass on a rod at azimuth q_1 and at the angle q_2 from the vertical; the book's length is -c here."""
    links = [
        {"name": "rod", "joint": {"axes": ["z", "y"]}, "bodies": [{"at": "base", "mass": 1.5, "com": [0.0, 0.0, -0.6]}]}
    ]
    m, c, g = symbols("m c g")
    q2, v1, v2 = symbols("q_2 qdot_1 qdot_2")
    s, k = sp.sin(q2), sp.cos(q2)
    return Textbook(
        {"name": "spherical_pendulum", "gravity": [0.0, 0.0, -9.81], "links": links},
        "Landau, Lifshitz, Mechanics, section 14, problem 1; Goldstein, Classical Mechanics, spherical pendulum",
        sp.Matrix([[m * c**2 * s**2, 0], [0, m * c**2]]),
        sp.Matrix([2 * m * c**2 * s * k * v1 * v2, -m * c**2 * s * k * v1**2]),
        sp.Matrix([0, -m * g * c * s]),
    )


def polar_arm() -> Textbook:
    """A turning and a sliding joint in a vertical plane; the book's d_2 is q_2, its l_1 is c_1 here."""
    links = [
        {"name": "turret", "joint": {"axes": ["z"]}, "bodies": [lump(4.0, 0.3, 0.4)]},
        {"name": "ram", "joint": {"axes": [{"slide": "x"}]}, "bodies": [lump(2.0, 0.0, 0.2)]},
    ]
    m1, m2, l1, I1, I2, g = symbols("m_1 m_2 c_1 I_1 I_2 g")
    q1, d2, v1, v2 = symbols("q_1 q_2 qdot_1 qdot_2")
    return Textbook(
        {"name": "polar_arm", "gravity": [0.0, -9.81, 0.0], "links": links},
        "Craig, Introduction to Robotics, 3rd ed., example 6.5, RP manipulator",
        sp.Matrix([[m1 * l1**2 + I1 + I2 + m2 * d2**2, 0], [0, m2]]),
        sp.Matrix([2 * m2 * d2 * v1 * v2, -m2 * d2 * v1**2]),
        sp.Matrix([(m1 * l1 + m2 * d2) * g * sp.cos(q1), m2 * g * sp.sin(q1)]),
    )


def elastic_joint() -> Textbook:
    """A pendulum behind an elastic gear; the book has a ratio of one, its M l is m c, its k is k_g here."""
    drive = {"ratio": 8.0, "rotor_inertia": 0.02, "stiffness": 300.0, "damping": 0.4}
    links = [{"name": "arm", "joint": {"axes": ["z"], "drives": [drive]}, "bodies": [lump(1.4, 0.5, 0.1)]}]
    m, c, inertia, J, k, d, N, g = symbols("m c I J_r k_g d_g N g")
    q, theta, v, w = symbols("q theta qdot thetadot")
    between, rate = k * (q - theta / N), d * (v - w / N)
    return Textbook(
        {"name": "elastic_joint", "gravity": [0.0, -9.81, 0.0], "links": links},
        "Spong, Modeling and control of elastic joint robots, ASME J. Dyn. Sys. 109, 1987; the single link, "
        "from the horizontal",
        sp.Matrix([[inertia + m * c**2, 0], [0, J]]),
        sp.Matrix([rate, -rate / N]),
        sp.Matrix([m * g * c * sp.cos(q) + between, -between / N]),
    )


def beam(name: str, length: float, density: float, stiffness: float) -> dict:
    """A flexible link in the horizontal plane with one mode."""
    section = {"rhoA": density, "EIy": stiffness, "EIz": stiffness}
    return {
        "name": name,
        "length": length,
        "section": section,
        "modes": {"basis": "polynomial", "bending_y": 1},
        "joint": {"axes": ["z"]},
    }


@dataclass(frozen=True)
class Shape:
    """The integrals of a mode shape phi(x) over a link: of rho phi, rho phi x, rho phi^2, EI phi''^2; its end."""

    v: sp.Expr
    w: sp.Expr
    z: sp.Expr
    k: sp.Expr
    end: sp.Expr
    slope: sp.Expr


def shape(length: sp.Symbol, rho: sp.Symbol, EI: sp.Symbol) -> Shape:
    """Of the polynomial basis with one shape, sqrt(5) (x/l)^2, by sympy."""
    x = sp.Symbol("x", positive=True)
    phi = sp.sqrt(5) * (x / length) ** 2
    over = lambda e: sp.integrate(e, (x, 0, length))  # noqa: E731
    bent = sp.diff(phi, x, 2)
    moments = [over(rho * phi * x**k) for k in (0, 1)]
    end = [phi.subs(x, length), sp.diff(phi, x).subs(x, length)]
    return Shape(*moments, over(rho * phi**2), over(EI * bent**2), *end)


def flexible_link() -> Textbook:
    """One flexible link with a payload, one mode."""
    link = beam("beam", 1.2, 0.8, 30.0) | {"bodies": [{"at": "tip", "mass": 0.5}]}
    m, rho, EI, l = symbols("m rhoA EIz l")
    eta, v, w = symbols("eta qdot etadot")
    s = shape(l, rho, EI)
    b11 = rho * l**3 / 3 + m * l**2 + (s.z + m * s.end**2) * eta**2
    b12 = s.w + m * l * s.end
    n = s.z + m * s.end**2
    return Textbook(
        {"name": "flexible_link", "gravity": [0.0, 0.0, 0.0], "links": [link]},
        "De Luca, Siciliano, Flexible links, in Canudas de Wit, Siciliano, Bastin (eds.), Theory of Robot Control, "
        "chapter 6, one link",
        sp.Matrix([[b11, b12], [b12, n]]),
        sp.Matrix([2 * n * eta * v * w, -n * eta * v**2]),
        sp.Matrix([0, s.k * eta]),
    )


def flexible_arm() -> Textbook:
    """Two flexible links with one mode each; the inertia is that of links without deflection, as the paper has it."""
    links = [beam("first", 1.0, 0.9, 40.0), beam("second", 0.8, 0.6, 25.0)]
    r1, r2, E1, E2, l1, l2, q2 = symbols("rhoA_1 rhoA_2 EIz_1 EIz_2 l_1 l_2 q_2")
    eta1, eta2 = symbols("eta_1 eta_2")
    a, b, c = shape(l1, r1, E1), shape(l2, r2, E2), sp.cos(q2)
    m2, d2, J1, J2 = r2 * l2, l2 / 2, r1 * l1**3 / 3, r2 * l2**3 / 3
    b11 = J1 + J2 + m2 * l1**2 + 2 * m2 * d2 * l1 * c
    b12 = J2 + m2 * d2 * l1 * c
    b13 = a.w + m2 * l1 * a.end + J2 * a.slope + m2 * d2 * (a.end + l1 * a.slope) * c
    b14 = b.w + b.v * l1 * c
    b23 = J2 * a.slope + m2 * d2 * a.end * c
    b33 = a.z + m2 * a.end**2 + J2 * a.slope**2 + 2 * m2 * d2 * a.end * a.slope * c
    b34 = b.w * a.slope + b.v * a.end * c
    rows = [[b11, b12, b13, b14], [b12, J2, b23, b.w], [b13, b23, b33, b34], [b14, b.w, b34, b.z]]
    return Textbook(
        {"name": "flexible_arm", "gravity": [0.0, 0.0, 0.0], "links": links},
        "De Luca, Siciliano, Closed-form dynamic model of planar multilink lightweight robots, IEEE Trans. SMC 21(4), "
        "1991",
        sp.Matrix(rows),
        sp.zeros(4, 1),
        sp.Matrix([0, 0, a.k * eta1, b.k * eta2]),
    )


TEXTBOOKS: dict[str, Callable[[], Textbook]] = {
    make.__name__: make
    for make in (
        double_pendulum,
        two_link,
        crane,
        spherical_pendulum,
        polar_arm,
        elastic_joint,
        flexible_link,
        flexible_arm,
    )
}


def digests() -> str:
    """A line for every robot, with the digest of its equations as text and as LaTeX: the same with all versions."""
    lines = []
    for name, make in TEXTBOOKS.items():
        equations = screwgen.derive(Robot(**make().robot)).equations()
        data = f"{equations}\n{equations.latex()}\n{equations.linearised()}".encode()
        lines.append(f"{hashlib.sha256(data).hexdigest()}  {name}\n")
    return "".join(lines)


if __name__ == "__main__":
    DIGESTS.write_text(digests(), encoding="utf-8")
