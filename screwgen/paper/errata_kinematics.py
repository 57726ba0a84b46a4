"""Errata of Section 2 and Appendix A."""

from __future__ import annotations

import numpy as np

from .erratum import Erratum, Figure, misfit
from .evaluate import evaluate
from .kinematics import EQUATIONS, L
from .random_motion import RandomMotion


def missing_transport() -> tuple[Figure, ...]:
    """(dvi) + (dvxi) + (dvb) against the acceleration (21) of an element, and against the term that is missing."""
    motion = RandomMotion(1)
    total = sum(evaluate(x, motion)[..., 3:, :] for x in (L.dV_xi, L.dV_b))  # as printed, and these two hold
    truth, lost = motion.values["dd_r_ob:i"], evaluate(L.omega, motion)
    lost = np.cross(lost, motion.values["v:i"], axis=0)
    printed = np.abs(total + motion.values["vdot:i"] - truth).max()
    derived = np.abs(total + motion.values["vdot:i"] + lost - truth).max()
    return (
        misfit(EQUATIONS, "dvi"),
        Figure("(dvi) + (dvxi) + (dvb) against (21), largest gap", "m/s²", printed, derived),
        Figure("the largest component of ω × v_i, against that gap", "m/s²", 0.0, printed, np.abs(lost).max()),
    )


ERRATA = (
    Erratum(
        number="E3",
        where=("dvi", "34", "29", "accconst1b", "accconst2", "accconst5"),
        title=r"the acceleration of the frame lacks $\tilde{\boldsymbol{\omega}}_i\mathbf{v}_i$",
        printed=r"$\frac{d\mathbf{V}_i}{dt} = \dot{\mathbf{V}}_i + \mathrm{ad}_{\mathbf{V}_i}\mathbf{V}_i = "
        r"\dot{\mathbf{V}}_i$: the Lie derivative of a twist along itself vanishes, and with it the transport term",
        holds=r"components of a velocity in a turning frame change by the transport theorem (14): "
        r"$\frac{d\mathbf{v}_i}{dt} = \dot{\mathbf{v}}_i + \tilde{\boldsymbol{\omega}}_i\mathbf{v}_i$. "
        "(dvxi) and (dvb) keep their terms, so the sum of the three misses (21) by this one",
        evidence=missing_transport,
    ),
)
