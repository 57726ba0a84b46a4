"""Errata of Section 3: accelerations, inertia and gyroscopic terms; then those of loads, ends and bodies."""

from __future__ import annotations

import numpy as np

from ..algebra.expression import Expression
from ..algebra.rewrite import substitute
from .equation import relation
from .errata_link_ends import ERRATA as ENDS
from .erratum import Erratum, Figure, misfit
from .evaluate import evaluate
from .jets import Jet, constant, turn
from .link import (
    DEFORMATION,
    DERIVED_D,
    DERIVED_H_STAR,
    EQUATIONS,
    FREE_FALL,
    M_STAR,
    PRINTED_D,
    PRINTED_H_STAR,
    STRESS,
    L,
)
from .single_link import LENGTH, RHO_A, TO_MASS_CENTRE, SingleLink, shaped

READ_H_STAR = substitute(PRINTED_H_STAR, FREE_FALL)
"""The printed (29), with its g read as the opposite of free fall."""
X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
G = 9.81
TORQUE_X, TORQUE_Y, TORQUE_Z = range(3)


def wrench(link: SingleLink, D: Expression = DERIVED_D, H: Expression = DERIVED_H_STAR) -> np.ndarray:
    """The external wrench by (26), perhaps with a part as printed."""
    return evaluate(M_STAR @ L.Vdot + D + H, link)[:, 0]


def torque(what: str, link: SingleLink, row: int, **printed: Expression) -> Figure:
    """A torque on the link by (26), against the balance of momentum of its elements."""
    return Figure(what, "N·m", wrench(link, **printed)[row], wrench(link)[row], link.values["total:i"][row, 0])


def counted_twice() -> tuple[Figure, ...]:
    """A bent link at rest begins to turn about its centreline: only what is displaced is accelerated."""
    link = SingleLink(R=turn(X, 0.3, 0, 10), eta=shaped(0, 0.05))
    lines = (*DEFORMATION.printed, *DEFORMATION.derived)
    printed, derived = (evaluate(relation(line).left - STRESS, link)[-1, 2, 0] for line in lines)
    truth = link.values["dd_r_ob:i"][-1, 2, 0]
    what = "acceleration near the tip of a bent link at rest that begins to turn about x with 10 rad/s²"
    return misfit(EQUATIONS, "34"), Figure(what, "m/s²", printed, derived, truth)


def weight_about_inertial_origin() -> tuple[Figure, ...]:
    """A straight level link at rest, far from the inertial origin: its weight turns it about its own frame."""
    link = SingleLink(R=turn(Z, 0.3, 0, 0), origin=constant([[4.0], [0.0], [0.0]]), gravity=(0, 0, -G))
    held = torque("", link, TORQUE_Y, H=READ_H_STAR)
    truth = -RHO_A * LENGTH * G * TO_MASS_CENTRE
    what = "torque about y that holds a level link of 2 kg, its mass centre 0.25 m and the inertial origin 4 m away"
    return misfit(EQUATIONS, "29"), Figure(what, "N·m", held.printed, held.derived, truth)


def moment_of_stress() -> tuple[Figure, ...]:
    """A bent and stretched link is let go, without weight and without external forces."""
    link = SingleLink(R=turn(Z, 0.3, 0, 0), eta=shaped(0.001, 0.002, 0.002, 0.001, 0.002, 0.002))
    what = "torque about {} on a bent and stretched link at rest that is let go, without weight"
    rows = ((TORQUE_X, "x"), (TORQUE_Z, "z"))
    return tuple(torque(what.format(axis), link, row, H=READ_H_STAR) for row, axis in rows)


def flight() -> tuple[Figure, ...]:
    """A straight link flies freely: its mass centre moves uniformly, its spin about z is steady."""
    R = turn(Z, 0.3, 3, 0)
    centre = Jet(np.array([[0.5], [0.2], [0.0]]), np.array([[2.0], [0.5], [0.0]]), np.zeros((3, 1)))
    link = SingleLink(R=R, origin=centre - R @ constant([[TO_MASS_CENTRE], [0.0], [0.0]]))
    what = "torque about z on a straight link in free flight at 2.1 m/s that spins with 3 rad/s"
    return (torque(what, link, TORQUE_Z, H=READ_H_STAR),)


def lever_of_the_displacement() -> tuple[Figure, ...]:
    """Bent links: one begins to turn about its centreline, one turns steadily about an oblique axis."""
    begins = SingleLink(R=turn(X, 0.3, 0, 10), eta=shaped(0, 0.05))
    oblique = np.array([[0.6], [0.0], [0.8]])
    steady = SingleLink(R=turn(oblique, 0.3, 4, 0), eta=shaped(0, 0.05))
    return (
        misfit(EQUATIONS, "28"),
        torque("torque that begins to turn a bent link about x with 10 rad/s²", begins, TORQUE_X, D=PRINTED_D),
        torque("torque about x of a bent link that turns steadily with 4 rad/s", steady, TORQUE_X, H=READ_H_STAR),
    )


ERRATA = (
    Erratum(
        number="E2",
        where=("34",),
        title="the frame's angular acceleration carries the displacement twice",
        printed=r"$-\tilde{\mathbf{r}}_{ib_i}\dot{\boldsymbol{\omega}}_i$ beside $\dot{\mathbf{v}}_{\xi_i}$, which "
        r"already holds $-\tilde{\mathbf{r}}_{\xi_i}\dot{\boldsymbol{\omega}}_i$",
        holds=r"$-\tilde{\mathbf{r}}_{b_i}\dot{\boldsymbol{\omega}}_i$, as the paper's own acceleration (21) has it",
        evidence=counted_twice,
    ),
    Erratum(
        number="E5",
        where=("29",),
        title="moment of the weight about the inertial origin, in an equation about the link's",
        printed=r"$m_i\tilde{\mathbf{r}}_i\mathbf{R}_{oi}^{\top}\mathbf{g}$ in the moment row: the torque depends on "
        "where the inertial origin is",
        holds=r"the weight's moment is that of its elements about the origin of $\mathcal{F}_i$, "
        r"$\rho_i A_i\int\tilde{\mathbf{r}}_{ib_i}\mathbf{R}_{oi}^{\top}\mathbf{g}\,d\xi$, and no more",
        evidence=weight_about_inertial_origin,
    ),
    Erratum(
        number="E6",
        where=("29",),
        title="a moment of the internal stresses",
        printed=r"$\int\tilde{\mathbf{r}}_{\xi_i}'\mathbf{I}_{v1_i}\mathbf{r}_{\xi_i}'\,d\xi + "
        r"\int\tilde{\mathbf{r}}_{\xi_i}''\mathbf{I}_{v2_i}\mathbf{r}_{\xi_i}''\,d\xi$ in the moment row",
        holds="the strain energy does not change when the link is turned as a whole, so the stresses have no moment on "
        "the link. The two integrals are what integration by parts of the linear stresses in (34) leaves over, of "
        "second order in the displacement",
        evidence=moment_of_stress,
    ),
    Erratum(
        number="E7",
        where=("29",),
        title="the gyroscopic moment of a moving origin",
        printed=r"$\rho_i A_i\int\tilde{\mathbf{v}}_{ib_i}\mathbf{v}_{ob_i}\,d\xi$, which is "
        r"$-\tilde{\mathbf{v}}_i\,\rho_i A_i\int\mathbf{v}_{ib_i}\,d\xi$ and vanishes with $\mathbf{v}_i$",
        holds=r"$\rho_i A_i\int\tilde{\mathbf{r}}_{ib_i}\tilde{\boldsymbol{\omega}}_i\mathbf{v}_i\,d\xi$, the "
        "moment of the acceleration that the turning frame gives its own velocity",
        evidence=flight,
    ),
    Erratum(
        number="E8",
        where=("28", "29", "B1", "B2", "B3"),
        title="levers without the displacement, or with nothing else",
        printed=r"moments with the lever $\tilde{\mathbf{r}}_{b_i}$ in (28) and (29), with "
        r"$\tilde{\mathbf{r}}_{\xi_i}$ in the appendix",
        holds=r"the lever is the place of the element, $\tilde{\mathbf{r}}_{ib_i} = \tilde{\mathbf{r}}_{b_i} + "
        r"\tilde{\mathbf{r}}_{\xi_i}$, in all of them, and (28) gains $\rho_i A_i\int\tilde{\mathbf{r}}_{\xi_i}"
        r"(\dot{\mathbf{v}}_i - \tilde{\mathbf{r}}_{b_i}\dot{\boldsymbol{\omega}}_i)\,d\xi$. Only then "
        r"$\mathbf{M}_{D\phi} = \mathbf{M}_D^{\top}$",
        evidence=lever_of_the_displacement,
    ),
    *ENDS,
)
