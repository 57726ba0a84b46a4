"""The numbers that the paper states, computed: ratio of bending frequencies, step bound, the axial displacement."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import screwgen
from screwgen import Joint, natural_frequencies
from screwgen.bases import shapes

from .arm import TIP_DISPLACEMENT, Arm, with_modes


@dataclass(frozen=True)
class Numbers:
    """SI units unless said."""

    ratio_roots: float
    """(4.6941 / 1.8751)^2 from the roots of cos x cosh x = -1."""
    ratio_model: float
    """Second over first bending frequency of the bare, clamped link 2 with two modes per plane, from the model."""
    bare: tuple[float, float]
    """Hz: the two of its stiffer plane."""
    ratio_payload: float
    """The same with the payload at its tip, converged."""
    payload: tuple[float, float]
    bound: float
    """s: (stability) with the paper's own numbers."""
    axial_frequency: float
    """Hz: first axial mode of the bare link 2."""
    axial_bound: float
    """s: 2 / omega of that mode."""
    axial_energy: float
    """J: stored by the axial part of the initial displacement in the first axial mode."""
    axial_force: float
    """N: at the base of the link, in that shape."""
    uniform_energy: float
    uniform_force: float
    """The same for a uniform stretch."""
    strain: float
    """That of a uniform stretch."""
    foreshortening: float
    """m: by which the initial bending pulls the tip back, 1/2 times the integral of the squared slope."""


def compute(arm: Arm) -> Numbers:
    """All numbers, for link 2: the shorter one, and the one that starts displaced."""
    link = arm.robot.links[1]
    l, rhoA = link.length, link.section.rhoA
    EA, EI = link.section.EA, link.section.EIz
    u, rod, curve = abs(TIP_DISPLACEMENT[0]), shapes("clamped_free", "axial", 1), shapes("clamped_free", "bending_y", 2)
    omega = np.sqrt(rod.stiffness[0] * EA / rhoA) / l
    eta = u / rod.tip_value[0]
    bare, loaded = clamped(arm, "clamped_free", 2, False), clamped(arm, "polynomial", 6, True)
    s = np.linspace(0, 1, 2001)
    slope = np.array(curve.evaluate(s, 1))[0] / curve.tip_value[0]
    lateral = TIP_DISPLACEMENT[1] ** 2 + TIP_DISPLACEMENT[2] ** 2
    return Numbers(
        ratio_roots=float((curve.eigenvalues[1] / curve.eigenvalues[0]) ** 2),
        ratio_model=bare[1] / bare[0],
        bare=bare,
        ratio_payload=loaded[1] / loaded[0],
        payload=loaded,
        bound=float(2 * l**2 / curve.eigenvalues[0] ** 2 * np.sqrt(rhoA / EI)),
        axial_frequency=float(omega / (2 * np.pi)),
        axial_bound=float(2 / omega),
        axial_energy=float(EA / l * rod.stiffness[0] * eta**2 / 2),
        axial_force=float(EA / l * eta * np.array(rod.evaluate([0.0], 1))[0, 0]),
        uniform_energy=EA * u**2 / (2 * l),
        uniform_force=EA * u / l,
        strain=u / l,
        foreshortening=float(np.trapezoid(slope**2, s) * lateral / (2 * l)),
    )


def clamped(arm: Arm, basis: str, count: int, payload: bool) -> tuple[float, float]:
    """The first two bending frequencies, Hz, of link 2 clamped at its base, in its stiffer plane (EI_z)."""
    robot = with_modes(arm.robot, basis=basis, bending_y=count)
    link = robot.links[1].model_copy(update={"joint": Joint(axes=())})
    link = link if payload else link.model_copy(update={"bodies": ()})
    found = natural_frequencies(screwgen.derive(robot.model_copy(update={"links": (link,)})))
    return float(found[0]), float(found[1])
