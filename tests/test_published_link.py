"""The single flexible link as A. De Luca and B. Siciliano publish it, with a hub and a payload that has inertia.

Trajectory control of a non-linear one-link flexible arm, Int. J. Control 50(5), 1989. The paper was not at hand: the
form was read from a transcription for Matlab that bears its title and names no authors,
github.com/YuanpeiCAI/Trajectory-Control-of-a-Non-Linear-One-Link-Flexible-Arm, file
`trajectory_control_of_non_linear_flexible_arm.m`. Here it is written for one shape. Of what the deflection adds to the
inertia about the joint it has the payload's part alone; the tool has the rod's part too.
"""

from __future__ import annotations

from functools import cache

import sympy as sp
from textbook_robots import beam, shape, symbols

import screwgen
from screwgen import Robot
from screwgen.backends.equations.equations import Equations

l, rho, EI, hub, ML, Jp = symbols("l rhoA EIz I_a m_b I_b")
eta, v, w = symbols("eta qdot etadot")
s = shape(l, rho, EI)


@cache
def equations() -> Equations:
    def body(at: str, mass: float, moment: float) -> dict:
        return {"at": at, "mass": mass, "com": [0.0] * 3, "inertia": [moment] * 3 + [0.0] * 3}

    link = beam("beam", 1.2, 0.8, 30.0) | {"bodies": [body("base", 0.3, 0.1), body("tip", 0.5, 0.01)]}
    return screwgen.derive(Robot(name="link", gravity=[0.0, 0.0, 0.0], links=[link])).equations()


def same(ours: sp.Matrix, theirs: sp.Matrix) -> bool:
    return (ours - theirs).applyfunc(sp.expand) == sp.zeros(*theirs.shape)


def test_the_inertia_is_the_published_one_and_the_rod_s_part():
    """J_0 of the publication is that of the straight rod about the joint, I_0 the hub's, phi' a slope per length."""
    e = equations()
    M11 = rho * l**3 / 3 + Jp + ML * l**2 + hub + ML * (s.end * eta) ** 2
    M12 = ML * l * s.end + Jp * s.slope + s.w
    published = sp.Matrix([[M11, M12], [M12, s.z + ML * s.end**2 + Jp * s.slope**2]])
    assert same(e.expanded(e.M), published + sp.diag(s.z * eta**2, 0))


def test_velocity_terms_and_stiffness_are_the_published_ones_and_the_rod_s_part():
    e = equations()
    published = sp.Matrix([2 * ML * v * (s.end * eta) * (s.end * w), -ML * v**2 * s.end * (s.end * eta)])
    rod = sp.Matrix([2 * s.z * eta * w * v, -s.z * eta * v**2])
    assert same(e.expanded(e.C * sp.Matrix(e.qdot)), published + rod)
    assert same(e.K * sp.Matrix(e.q), sp.Matrix([0, s.k * eta]))
