"""Errata of Section 7 and of the sections' rotation, which its arm shows."""

from __future__ import annotations

from functools import cache
from math import pi, sqrt

import numpy as np
import sympy as sp

from ..model import derive
from ..spec.robot import Body, Joint, Link, Modes, Robot
from ..studies.modes import natural_frequencies
from . import ella_judges as judges
from .arm import LENGTHS, MASSES, ROD, SECTION, SET_POINTS, ella
from .clamped_beam import Beam
from .ella_section import axial, axial_frequency, clamped_free, printed_bending, printed_bound
from .erratum import Erratum, Figure
from .frame_elements import arm_frequencies

STEP = 1e-3
"""s: the paper's."""
CONVERGED = 1e-5
"""How far the lowest frequencies of a few modes may be from those of many beam elements."""
TEXT = {"bound": 10.04e-3, "EIy": 3.67e3, "ratio": (4.6941 / 1.8751) ** 2, "roots": 1.8751, "fast mode": 30.7}
"""What the paper's text says: s, N·m², -, -; the last, Hz, is the arm's as printed, E16."""


def shapes() -> tuple[Figure, ...]:
    """The printed shapes on the second link."""
    L = LENGTHS[1]
    x = [judges.values(axial(wave).rhs, a=1.0, L=L) for wave in (sp.cos, sp.sin)]
    y = [[judges.bending(f("y").rhs, n, L) for n in (1, 2, 3)] for f in (printed_bending, clamped_free)]
    grams = [judges.gram(shapes, L) for shapes in y]
    overlap = [G[0, 1] / sqrt(G[0, 0] * G[1, 1]) for G in grams]
    further = [G[0, 2] / sqrt(G[0, 0] * G[2, 2]) for G in grams]
    slope = [shape[0](1)(0.0) / np.abs(shape[0](1)(np.linspace(0, L, 101))).max() for shape in y]
    moved = [shape(0)(0.0) / judges.greatest(shape, L) for shape in x]
    bent = [judges.tip_deflection(shape[0], L) for shape in y]
    return (
        Figure.of("$\\phi_x$ at the clamp, over its greatest value", "-", moved, scale=1.0),
        Figure.of("$\\phi_y'$ at the clamp, over its greatest value", "-", slope, scale=1.0),
        Figure.of("overlap of the first two $\\phi_y$, both of norm 1", "-", overlap, scale=1.0),
        Figure.of("overlap of the first and the third $\\phi_y$, both of norm 1", "-", further, scale=1.0),
        Figure.of(
            "tip deflection under a force in the first $\\phi_y$, over the exact", "-", bent, 12 / judges.root(1) ** 4
        ),
    )


def steps() -> tuple[Figure, ...]:
    """The bound and what happens under it."""
    first = 2 * pi * judges.FOREARM.frequencies(1)[0]
    second = Beam(1.0, 1.0, 1.0).squares[1] ** 0.5
    fast, rod = 2 * pi * TEXT["fast mode"], axial_frequency()
    per_second = round(1 / STEP)
    grows = lambda omega: sqrt(1 + (omega * STEP) ** 2)  # noqa: E731
    stepped = lambda omega: judges.euler_growth(omega, STEP)  # noqa: E731
    return (
        Figure("(stability) with the text's own numbers", "s", TEXT["bound"], printed_bound(), 2 / first, CONVERGED),
        Figure("$(\\beta l)^2$ of the second mode", "-", TEXT["roots"] ** 2 * 4, judges.root(2) ** 2, second),
        Figure(
            f"growth of {TEXT['fast mode']} Hz by forward Euler in 1 s, steps of 1 ms",
            "-", 1.0, grows(fast) ** per_second, stepped(fast) ** per_second, 1e-8,
        ),
        Figure("growth of the first axial mode in one such step", "-", 1.0, grows(rod), stepped(rod)),
        Figure(
            "largest step that symplectic Euler bears with the first axial mode",
            "s", TEXT["bound"], 2 / rod, judges.symplectic_limit(rod), 1e-3,
        ),
    )  # fmt: skip


def stiffness() -> tuple[Figure, ...]:
    """The two statements of EI_y."""
    L, rhoA = LENGTHS[1], ROD.rhoA
    found = [Beam(L, EI, rhoA).frequencies(1)[0] for EI in (TEXT["EIy"], ROD.EIy)]
    y = Beam(L, ROD.EIz, rhoA).frequencies(1)[0]
    truth = judges.root(1) ** 2 / (2 * pi * L**2) * sqrt(ROD.EIy / rhoA)
    ratios = [y / z for z in found]
    return (
        Figure.of("lowest frequency of the bare second link in z", "Hz", found, truth),
        Figure.of("its lowest frequency in y over that in z", "-", ratios, sqrt(ROD.EIz / ROD.EIy)),
    )


@cache
def model_frequencies(robot: Robot) -> np.ndarray:
    """Natural frequencies in Hz of the derived model of an arm, its joints locked."""
    return natural_frequencies(derive(robot))


def arm(section_rotation: bool = True) -> np.ndarray:
    """The arm's frequencies with four polynomials per plane."""
    return model_frequencies(ella(4, "polynomial", axial=2, locked=True, section_rotation=section_rotation))


def rotation() -> tuple[Figure, ...]:
    """The lowest frequencies of the arm, sections turning or not, against a frame of beam elements."""
    printed, derived, truth = arm(False), arm(True), arm_frequencies()
    names = ("lowest", "second")
    what = "{} frequency of the arm, joints locked in the posture of the set points"
    return tuple(
        Figure(what.format(name), "Hz", printed[k], derived[k], truth[k], CONVERGED) for k, name in enumerate(names)
    )


def loaded_forearm() -> Robot:
    """The second link alone, clamped, with the payload, bending in y in six polynomials."""
    link = Link(
        name="forearm",
        length=LENGTHS[1],
        section=SECTION,
        modes=Modes(basis="polynomial", bending_y=6),
        joint=Joint(axes=()),
        bodies=[Body(at="tip", mass=MASSES[1])],
    )
    return Robot(name="loaded", gravity=(0.0, 0.0, 0.0), links=[link])


def second_mode() -> tuple[Figure, ...]:
    """Ratios of frequencies under the loads that the arm carries."""
    derived, truth = model_frequencies(loaded_forearm()), Beam(LENGTHS[1], ROD.EIz, ROD.rhoA, MASSES[1])
    first, second = truth.frequencies(2)
    frame, whole = arm_frequencies(), arm()
    return (
        Figure(
            "second over first frequency of the clamped second link with its payload",
            "-", TEXT["ratio"], derived[1] / derived[0], second / first, CONVERGED,
        ),
        Figure(
            "third over first frequency of the arm, joints locked",
            "-", TEXT["ratio"], whole[2] / whole[0], frame[2] / frame[0], CONVERGED,
        ),
    )  # fmt: skip


def control() -> tuple[Figure, ...]:
    """Exponential coordinates in the place of joint angles."""
    printed, joints, _ = judges.loop_work(np.array([0.0, 100.0, 100.0]), 0.3)
    y, *z = SET_POINTS
    one, two = (judges.rotation_vector("yz", y, turned) for turned in (z[0], sum(z)))
    return (
        Figure("$\\theta_{z_2}$ with the joints at the set points", "rad", two[2], SET_POINTS[2], SET_POINTS[2]),
        Figure("$\\theta_{y_1}$ with the joints at the set points", "rad", one[1], SET_POINTS[0], SET_POINTS[0]),
        Figure("work of 100 N·m/rad round a circle of 0.3 rad about the set point", "J", printed, joints),
    )


ERRATA = (
    Erratum(
        number="E1",
        where=("phi_x", "phi_y", "phi_z"),
        title="the shapes are the derivatives of the clamped-free modes",
        printed=r"$\phi_x = a_x\frac{\pi}{2L}\cos\frac{\pi\xi}{2L}$ moves at the clamp, and $\phi_y = a_y\beta_y[\sinh"
        r"\beta_y\xi + \sin\beta_y\xi - r_{\phi_y}(\cosh\beta_y\xi - \cos\beta_y\xi)]$ has a slope there",
        holds=r"$\phi_x = a_x\sin\frac{\pi\xi}{2L}$ and $\phi_y = a_y[\cosh\beta_y\xi - \cos\beta_y\xi - r_{\phi_y}("
        r"\sinh\beta_y\xi - \sin\beta_y\xi)]$, and $\phi_z$ alike: what is printed is their derivative. The printed "
        "bending shapes are not orthogonal either",
        evidence=shapes,
    ),
    Erratum(
        number="E19",
        where=("stability",),
        title="the bound on the time step is not that of forward Euler, nor of the fastest mode",
        printed=r"forward Euler is stable for $T_s \leq 2/\omega_{\max}$, with $\omega_{\max} = (1.8751)^2n^2l^{-2}"
        r"\sqrt{EI/\rho A}$, which for the arm is 10.04 ms",
        holds=r"forward Euler multiplies an undamped oscillation by $\sqrt{1 + \omega^2T_s^2} > 1$ every step, however "
        r"short; $2/\omega_{\max}$ is the bound of symplectic Euler and central differences. $(1.8751)^2n^2$ is the "
        "eigenvalue of the first mode only, the printed formula gives 10.37 ms, and the retained axial mode is faster "
        "than all bending modes",
        evidence=steps,
    ),
    Erratum(
        number="E20",
        where=("ella",),
        title="two values of $EI_y$",
        printed=r"$EI_z = 3.67\times10^3$ and $EI_y = 2.12\times10^3$ N·m², later $EI_y = 3.67\times10^3$ N·m² in the "
        "strongest bending direction",
        holds=r"the first pair: the strongest direction is that of $EI_z$, displacement in y",
        evidence=stiffness,
    ),
    Erratum(
        number="E21",
        where=("8",),
        title="sections have no rotation at the joint",
        printed="the rotational coordinates of the displacement are zero, so the next link keeps the direction of the "
        "frame, whatever the slope of the tip",
        holds="sections of an Euler-Bernoulli beam stay normal to the centreline: the tip section turns by the slope "
        "and the next link with it. The judge is a frame of beam elements whose node at the elbow turns both links",
        evidence=rotation,
    ),
    Erratum(
        number="E33",
        where=("second_mode",),
        title="a second mode where one is retained, in the ratio of an unloaded beam",
        printed=r"with one mode in each direction, a component near 13 Hz is the second bending mode of the "
        r"clamped-free beam, $(4.6941/1.8751)^2 = 6.27$ times the first",
        holds="one mode has no second. 6.27 belongs to a link without load: with the payload at its tip the ratio is "
        "that of the roots of another equation, and the frequencies of the arm are those of both links together",
        evidence=second_mode,
    ),
    Erratum(
        number="E37",
        where=("PD",),
        title="the angles of the control law are not those of (1)",
        printed=r"the torque is a gain times $\boldsymbol{\theta}_{di} - \boldsymbol{\theta}_i$, where "
        r"$\boldsymbol{\theta}_i$ of (1) are exponential coordinates from the inertial frame; the set points "
        r"$\theta_{y_1}, \theta_{z_1}, \theta_{z_2}$ are angles of joints",
        holds="joint angles and their rates, and torques about the axes of the joints. Exponential coordinates of a "
        "universal joint have a third component, those of link 2 contain the turn of link 1, and a torque "
        "proportional to them is no spring: it does work on a closed path",
        evidence=control,
    ),
)
