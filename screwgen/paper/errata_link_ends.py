"""Errata of Section 3: end loads, weight, rank of the inertia, bodies, and what places the frame."""

from __future__ import annotations

import numpy as np
from numpy.linalg import matrix_rank, norm
from numpy.polynomial.legendre import leggauss

from ..model import derive
from ..spec.robot import Joint, Link, Robot
from ..spec.section import Section
from .arm import LENGTHS, MASSES, ROD, ella
from .beam_at_rest import BeamAtRest
from .equation import relation
from .erratum import Erratum, Figure, misfit
from .evaluate import evaluate
from .jets import skew, turn
from .link import DEFORMATION, DERIVED_H_STAR, EQUATIONS, M_STAR, PRINTED_H_STAR, WRENCHES, L
from .link_ends import DERIVED_H, PRINTED_H
from .random_motion import RandomMotion
from .single_link import INSIDE, LENGTH, RHO_A, SingleLink

G = 9.81
NOTHING = (0.0, 0.0, 0.0)
(END_WRENCH,) = (e for e in WRENCHES if e.label == "30")


def end_force() -> tuple[Figure, ...]:
    """A force on the tip of a straight link, and a beam that is pulled."""
    link = SingleLink(R=turn((0, 0, 1), 0.3, 0, 0))
    free = {f"{name}:i": np.zeros((3, 1)) for name in ("tau_B", "tau_T", "F_B")}
    link.values |= free | {"F_T:i": np.array([[0.0], [-1.0], [0.0]])}
    lines = (*END_WRENCH.printed, *END_WRENCH.derived)
    printed, derived = (evaluate(relation(line).right, link)[2, 0] for line in lines)
    truth = (LENGTH - INSIDE) * 1.0
    pulled = BeamAtRest(1, force=(1.0, 0, 0), torque=NOTHING, gravity=NOTHING).values
    exerted = pulled["F_T:i"][0, 0]
    inside = (pulled["I_v2:i"] @ pulled["r_xi3_c:i"] - pulled["I_v1:i"] @ pulled["r_xi1_c:i"])[0, 0]
    return (
        misfit(EQUATIONS, "30"),
        Figure("torque about z of 1 N in y, applied at the tip, 0.75 m from the frame", "N·m", printed, derived, truth),
        Figure("F_extT by (36) of a beam pulled with 1 N (printed: as applied)", "N", -exerted, exerted, inside),
    )


def direction_of_bending() -> tuple[Figure, ...]:
    """A torque about y on the tip of a clamped beam."""
    beam = BeamAtRest(1, force=NOTHING, torque=(0.0, 0.01, 0.0), gravity=NOTHING)
    exerted = beam.values["tau_T:i"]
    tip = lambda H: -(evaluate(H, beam) @ exerted)[2, 0] * beam.l**2 / (2 * beam.EIy)  # noqa: E731
    truth = beam.values["r_xi_c:i"][2, 0]
    what = "deflection in z of the tip of a clamped beam under 0.01 N·m about y"
    return misfit(EQUATIONS, "38"), Figure(what, "m", tip(PRINTED_H), tip(DERIVED_H), truth)


def direction_of_weight() -> tuple[Figure, ...]:
    """A link at rest in gravity of free fall, and a beam that sags under its weight."""
    link = SingleLink(R=turn((0, 0, 1), 0.3, 0, 0), gravity=(0, 0, -G))
    held = [evaluate(H, link)[5, 0] for H in (PRINTED_H_STAR, DERIVED_H_STAR)]
    beam = BeamAtRest(1, force=NOTHING, torque=NOTHING, gravity=(0, 0, -G))
    left_over = [np.abs(evaluate(relation(s[0]).left, beam)).max() for s in (DEFORMATION.printed, DEFORMATION.derived)]
    return (
        Figure.of("force in z that holds a link of 2 kg at rest, with g of free fall", "N", held, RHO_A * LENGTH * G),
        Figure.of("what (34) leaves over for a beam that sags under its weight", "m/s²", left_over, scale=G),
    )


def rank_of_inertia() -> tuple[Figure, ...]:
    """The inertia of a straight centreline, and of a round bar, whose sections have area."""
    motion = RandomMotion(1)
    rank = matrix_rank(evaluate(M_STAR, motion)), matrix_rank(motion.values["M_star:i"])
    line, bar = evaluate(L.I_b, motion)[0, 0], _spin_of_bar(density=2700.0, radius=0.02, length=1.0)
    mass = 2700 * np.pi * 0.02**2
    what = "inertia of a round bar of aluminium, 1 m long and 40 mm thick, about its own centreline"
    return Figure("rank of M*", "-", 6, *rank), Figure(what, "kg·m²", line, bar, mass * 0.02**2 / 2)


def _spin_of_bar(density: float, radius: float, length: float) -> float:
    """What the joint of a derived model feels that turns a round bar about its centreline, kg·m²."""
    area = np.pi * radius**2
    I = area * radius**2 / 4
    section = Section.model_validate({"density": density, "area": area, "Iy": I, "Iz": I})
    bar = Link(name="bar", length=length, section=section, joint=Joint(axes=("x",)))
    return derive(Robot(name="bar", gravity=NOTHING, links=[bar])).numpy().mass_matrix([0.0])[0, 0]


def bodies() -> tuple[Figure, ...]:
    """The arm of Section 7 at rest, held by its base: two beams, a motor, a payload."""
    model = derive(ella(0, axial=0, locked=True))
    _, wrenches = model.numpy().forward_dynamics([], [], [], np.zeros((2, 6)))
    beams = ROD.rhoA * sum(LENGTHS)
    return (
        Figure(
            "force that holds the arm of Section 7 at rest",
            "N",
            beams * G,
            float(norm(wrenches[0, 3:])),
            (beams + sum(MASSES)) * G,
        ),
    )


def frame_without_place() -> tuple[Figure, ...]:
    """Motions that frame and deformation share: combinations of both that move no element."""
    rigid, clamped = [[0, 1, 2, 3]] * 3, [[1, 2, 3], [2, 3, 4], [2, 3, 4]]
    what = "motions of a straight link's frame that a displacement undoes, of 5 (spin about x apart)"
    return (Figure(what, "-", _shared(rigid), _shared(clamped), 0.0),)


def _shared(powers: list[list[int]]) -> int:
    """How many columns of ``[-hat(r_b), I, phi]``, without the spin, the others make up, for shapes ``x**power``."""
    nodes, weights = leggauss(8)
    x = (1 + nodes) / 2
    r_b = np.stack([x, 0 * x, 0 * x], -1)[..., None]
    frame = np.concatenate([-skew(r_b)[..., 1:], np.broadcast_to(np.eye(3), (len(x), 3, 3))], -1)
    shapes = [np.outer(x**p, axis) for axis, some in zip(np.eye(3), powers, strict=True) for p in some]
    N = np.concatenate([frame, np.stack(shapes, -1)], -1)
    M = np.tensordot(weights / 2, np.swapaxes(N, -1, -2) @ N, 1)
    return len(M) - int(matrix_rank(M, tol=1e-10))


ERRATA = (
    Erratum(
        number="E10",
        where=("30", "36"),
        title="the lever of the end forces, and who exerts the force at the tip",
        printed=r"$-\tilde{\mathbf{r}}_{\xi(a_i)}\mathbf{F}_{extB_i} + "
        r"\tilde{\mathbf{r}}_{\xi(c_i)}\mathbf{F}_{extT_i}$: a straight link has no lever, a bent one the "
        "wrong sign; and the text calls both forces applied to the link",
        holds=r"with $\mathbf{F}_{extB_i} - \mathbf{F}_{extT_i}$ as in the second row, the moment is "
        r"$\tilde{\mathbf{r}}_{ib_i}(a_i)\mathbf{F}_{extB_i} - \tilde{\mathbf{r}}_{ib_i}(c_i)\mathbf{F}_{extT_i}$. "
        r"The sign there, and (36), make $\mathbf{F}_{extT_i}$ the force that the link exerts at its tip",
        evidence=end_force,
    ),
    Erratum(
        number="E11",
        where=("37", "38", "39"),
        title="a torque about y bends the beam the other way",
        printed=r"$\mathbf{H}$ with $+1$ in row 3, column 2",
        holds=r"$EI_y u_z'' = -M_y$, so that entry is $-1$ and $\mathbf{H} = -\tilde{\mathbf{e}}_x$",
        evidence=direction_of_bending,
    ),
    Erratum(
        number="E22",
        where=("29", "34"),
        title="the sign of gravity",
        printed=r"$+\mathbf{R}_{oi}^{\top}\mathbf{g}$ on the left, with $\mathbf{g}$ the gravitational acceleration",
        holds=r"with $\mathbf{g}$ of free fall the sign is minus; the printed terms stand if "
        r"$\mathbf{g}$ is its opposite",
        evidence=direction_of_weight,
    ),
    Erratum(
        number="E29",
        where=("27", "Iibi"),
        title="the inertia of a straight centreline is not positive definite",
        printed=r"$\mathbf{M}^*_i$ is positive definite by construction and of full rank, Sections 3 and 6",
        holds=r"with $a_i = 0$, $\mathbf{I}_{b_i} = \frac{1}{3}\rho_i A_i l_i^3\,\mathrm{diag}(0, 1, 1)$, so "
        r"$\mathbf{M}^*_i$ has rank 5. The polar inertia of the sections, $\rho_i I_{p_i}$, is what makes it definite",
        evidence=rank_of_inertia,
    ),
    Erratum(
        number="E34",
        where=("26", "27"),
        title="links carry no motor and no payload",
        printed="every term is an integral over the beam; Section 7 has a motor of 3.3 kg at the elbow and a payload "
        "of 2.1 kg, and no formula has a place for them",
        holds=r"rigid bodies at the base and at the tip section belong in $\mathbf{M}^*$, $\mathbf{D}^*$, "
        r"$\mathbf{H}^*$ and in the modal rows",
        evidence=bodies,
    ),
    Erratum(
        number="E35",
        where=("26", "35", "37"),
        title="nothing places the frame in the link",
        printed="(35) and (37) are the conditions at the base, beside (26). But (26) is, to first order in the "
        "displacement, the integral of (34) and of its moment with (35)-(38): nothing tells a motion of the frame from "
        "a displacement of all elements",
        holds=r"the frame is fixed to the base section, $\mathbf{r}_{\xi_i}(a_i) = \mathbf{0}$ and, of bending, "
        r"$\mathbf{r}_{\xi_i}'(a_i) = \mathbf{0}$, as the clamped mode shapes have it. These are the conditions at the "
        "base; (35) and (37) then say what the base exerts",
        evidence=frame_without_place,
    ),
)
