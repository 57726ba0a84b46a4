"""The numbers behind the errata of Section 4: printed and derived rows of joints and links, on motions and on ELLA."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.linalg import inv, norm

from ..algebra.expression import BlockMatrix, block, zeros
from ..algebra.rewrite import substitute
from ..model import Model, derive
from ..spec.robot import Joint, Link, Modes, Robot
from ..studies.analysis.regularity import regularity, with_projectors_alone
from .arm import SECTION, SET_POINTS, ella
from .arm_state import ArmState, EquationValues
from .equation import Equality, Equation, relation
from .erratum import Figure, misfit
from .evaluate import evaluate
from .jets import Jet, skew, turn, unskew
from .random_motion import RandomMotion
from .stacking import EQUATIONS as STACKED
from .stacking import M_S, ONE, PRINTED_M_S
from .synthesis import AXES, BEFORE, GAP, GAP_RATE, I3, NONE, L, printed_rate, section_rate
from .synthesis import EQUATIONS as SYNTHESIS

EQUATIONS = (*SYNTHESIS, *STACKED)
E_X, E_Y, E_Z = np.eye(3).reshape(3, 3, 1)
QUARTER = np.pi / 2


def misses(*labels: str) -> tuple[Figure, ...]:
    return tuple(misfit(EQUATIONS, label) for label in labels)


def found(label: str) -> Equation:
    return next(e for e in EQUATIONS if e.label == label)


@cache
def model(section_rotation: bool = False) -> Model:
    return derive(ella(section_rotation=section_rotation))


def posture(q: tuple[float, ...], v: tuple[float, ...], link: int) -> EquationValues:
    """ELLA undeformed with joint angles ``q`` and rates ``v``; ``i`` is the link with the number 0 or 1."""
    return ArmState(model(), state(q, v)).view(i=link)


def state(q: tuple[float, ...], v: tuple[float, ...]) -> np.ndarray:
    """The state ``x`` of ELLA undeformed."""
    still = [0.0] * (model().nq - len(q))
    return model().numpy().dae_state([*q, *still], [*v, *still])


# ------------------------------------------------------------------------------------------ the joint


def elbow_apart() -> tuple[Figure, ...]:
    """E12: ELLA straight, the elbow alone turning."""
    view = posture((0, 0, 0), (0, 0, 1), 1)
    twists = {"V_T:i-1": BEFORE.V + BEFORE.V_b_c, "V_B:i": L.V + L.V_b_a}
    printed, derived = (
        np.abs(evaluate(substitute(relation(e).left, twists), view)).max()
        for e in (found("45").printed[0], found("45").derived[0])
    )
    what = "velocity with which the elbow of ELLA, straight, comes apart while it turns at 1 rad/s"
    return (*misses("45", "accconst4", "63"), Figure(what, "m/s", printed, derived, scale=0.95))


def blocked_turn() -> tuple[Figure, ...]:
    """E13: what the rows block of a turn that the base joint makes; what axes fixed in the link let through."""
    view = posture(SET_POINTS, (1, 0, 0), 0)
    fixed = L.R @ L.A_zero
    printed, derived = (
        float(norm(evaluate((I3 - x) @ (L.R @ L.omega), view))) for x in (fixed @ fixed.T, L.A @ L.A_plus)
    )
    motion = RandomMotion(1)
    twice_over = [np.abs(P @ P - P).max() for P in (np.eye(3) - _outer(motion), motion.values["P:i"][:3, :3])]
    return (
        *misses("43", "oA"),
        Figure.of("largest entry of PP − P for two skew axes", "-", twice_over, scale=1.0),
        Figure("angular velocity that the rows of ELLA's base block while it turns about y at 1 rad/s, at the set "
               "points", "rad/s", printed, derived, scale=1.0),
        Figure("turn left over when a joint about y and z has made a quarter turn about each and taken both back",
               "rad", turn_left(fixed=True), turn_left(fixed=False), scale=QUARTER),
    )  # fmt: skip


def _outer(motion: RandomMotion) -> np.ndarray:
    return motion.values["A:i"] @ motion.values["A:i"].T


def turn_left(fixed: bool) -> float:
    """The angle of what remains of a closed path of the two joint coordinates, q1 and q2 by turns, to and fro."""
    R, q2 = np.eye(3), 0.0
    for which, way in ((0, 1), (1, 1), (0, -1), (1, -1)):
        given = {"R_two:i": turn(E_Z, 0.0 if fixed else q2, 0, 0).value, "a_one:i": E_Y, "a_two:i": E_Z}
        axis = evaluate(AXES, EquationValues(given, {}))[:, which]
        R = R @ turn(axis, way * QUARTER, 0, 0).value
        q2 += which * way * QUARTER
    return float(np.arctan2(norm(R - R.T) / np.sqrt(8), (np.trace(R) - 1) / 2))


def blocked_share() -> tuple[Figure, ...]:
    """E14: the diagonals of the text of Section 7 against the axes of ELLA, at q = 0."""
    out = []
    for link, printed, axis, unit, truth in (
        (0, (0, 1, 1), "x", E_X, 1.0),
        (0, (0, 1, 1), "y, which a motor turns", E_Y, 0.0),
        (1, (0, 0, 1), "x", E_X, 1.0),
        (1, (0, 0, 1), "z, which a motor turns", E_Z, 0.0),
    ):
        P = evaluate(I3 - L.A @ L.A_plus, posture((0, 0, 0), (0, 0, 0), link))
        shares = [(unit.T @ matrix @ unit).item() for matrix in (np.diag(printed), P)]
        what = f"share that joint {link + 1} of ELLA blocks of a turn about {axis}"
        out.append(Figure.of(what, "-", shares, truth, scale=1.0))
    return tuple(out)


def turning_projector() -> tuple[Figure, ...]:
    """E27: the rows with the Adjoint mended, without the rate of P; and the elbow of ELLA at constant joint rates."""
    motion = RandomMotion(1)
    rows = (Equality(L.P @ GAP_RATE, NONE), Equality(L.P @ GAP_RATE + L.Pdot @ GAP, NONE))
    gaps = [r.misfit(motion) for r in rows]
    q, v = (0, 0, 0), (1, 0, 1)
    printed = -evaluate(relation(found("accconst5").printed[0]).right, posture(q, v, 1))[0, 0]
    H = model().numpy().assemble(state(q, v), [0.0] * 3, np.zeros((2, 6)))[1]
    carried = np.cross(E_Y[:, 0], E_Z[:, 0])[0]
    what = "angular acceleration of ELLA's forearm about x, base turning about y and elbow about z at 1 rad/s"
    return (
        *misses("accconst1", "accconst5"),
        Figure.of("relative misfit of (accconst1) with the Adjoint mended", "-", gaps, within=1e-11, scale=1.0),
        Figure(what, "rad/s²", printed, -H[12], carried),
    )


def lost_reference() -> tuple[Figure, ...]:
    """E23: the elbow of ELLA on a circle; at constant rate, the frame's own velocity and all rates are zero."""
    view = posture((0, 0, 0), (0, 1, 0), 1)
    still = {f"{name}:i-1": zeros(6) for name in ("Vdot", "Vdot_xi_c", "Vdot_b_c")}
    printed, derived = (evaluate(substitute(f(BEFORE, "c"), still), view)[3, 0] for f in (printed_rate, section_rate))
    what = "acceleration of ELLA's elbow along the arm, base turning about z at 1 rad/s"
    return (*misses("accconst1b", "accconst2"), Figure(what, "m/s²", printed, derived, -0.95))


# ------------------------------------------------------------------------------------------ the rows


def misplaced() -> tuple[Figure, ...]:
    """E15: one misplacement at a time, everything else as derived."""
    motion, rows = RandomMotion(1), [list(row) for row in M_S.rows]
    right = relation(found("66").printed[0])
    missing = lambda M: right.read({"M_s:all": M}).misfit(motion)  # noqa: E731
    signs = [[-x for x in rows[0]], rows[1], [-x for x in rows[2]], rows[3]]
    shifted = [*rows[:3], list(PRINTED_M_S.rows[3])]
    own = relation(found("59").derived[0]).right
    assert isinstance(own, BlockMatrix)
    below = own.rows[1]
    wrong = block(own.rows[0], (below[0], below[3], below[2], below[1]))
    pair = relation(found("58").printed[0])
    in_pair = [pair.read({"M_c:i": M}).misfit(motion) for M in (wrong, own)]
    exact = missing(M_S)
    head = "relative misfit on a random motion of"
    return (
        Figure.of(f"{head} (58), only the link's inertia in the column printed", "-", in_pair, scale=1.0),
        Figure(f"{head} (66), only the fourth row of (68) as printed", "-", missing(block(*shifted)), exact, scale=1.0),
        Figure(f"{head} (66), only the signs of rows one and three as printed", "-", missing(block(*signs)), exact,
               scale=1.0),
    )  # fmt: skip


def ground() -> tuple[Figure, ...]:
    """E31: W_0 from the balance of the first link against that of the whole arm about the inertial origin."""
    motion = RandomMotion(1)
    inner = ONE.W_star + ONE.W - ONE.M_star @ ONE.Vdot - ONE.D_star - ONE.H_star
    printed, truth = evaluate(inner, motion), on_ground(motion)
    derived = evaluate(ONE.Ad_back.T @ inner, motion)
    what = {0: ("moment about x", "N·m"), 5: ("force along z", "N")}
    return (
        *misses("65"),
        *(
            Figure(f"{text} of the arm on the ground, against the balance of the whole arm", unit,
                   printed[k, 0], derived[k, 0], truth[k, 0])
            for k, (text, unit) in what.items()
        ),
    )  # fmt: skip


def on_ground(motion: RandomMotion) -> np.ndarray:
    """External wrenches less the rate of momentum and weight of every element, about the inertial origin, (6, 1)."""
    total = np.zeros((6, 1))
    for link in motion.links:
        v, R = link.values, link.R.value
        place, force = R @ v["r_ob"], link.rhoA * (R @ v["dd_r_ob"] - motion.gravity)
        moments, forces = link.sum(skew(place) @ force), link.sum(force)
        total += inv(v["Ad"]).T @ v["W_star"] - np.vstack([moments, forces])
    return total


def own_axis() -> tuple[Figure, ...]:
    """E32: a link that rolls while its tip section bends about y; the next joint's axis is the section's z.

    ``H_p`` is then the angular acceleration of the section while the link's twist and the modal rates are constant.
    """
    hat = skew(E_X)
    R, bend = Jet(np.eye(3), hat, hat @ hat), turn(E_Y, 0.0, 1.0, 0.0)
    T = R @ bend
    alpha = unskew(T.second @ T.value.T + T.rate @ T.rate.T)
    axis = T.value @ E_Z
    P = np.eye(3) - axis @ axis.T
    printed, derived = (axis.T @ alpha).item(), (axis.T @ P @ alpha).item()
    what = (
        "angular acceleration about its own free axis that an elbow's row holds, link rolling and tip section "
        "bending at 1 rad/s"
    )
    return (Figure(what, "rad/s²", printed, derived, scale=1.0),)


# ------------------------------------------------------------------------------------------ regularity


def zero_singular_values() -> tuple[Figure, ...]:
    """E17: M_sys with the projectors alone and with the motors' rows, of ELLA and of an arm of three joints."""
    out = []
    for name, arm in (("ELLA", model(True)), ("an arm with joints about z, y z and x y z", mixed())):
        judge, n = arm.numpy(), arm.nq
        q, v = 0.3 + 0.1 * np.arange(n), np.zeros(n)
        q[arm.n_joints :] = 0
        M = judge.assemble(judge.dae_state(q, v), [0.0] * arm.n_joints, np.zeros((arm.n_links, 6)))[0]
        lost = [len(M) - regularity(x, like=M).rank for x in (with_projectors_alone(arm, M), M)]
        what = rf"zero singular values of $\mathbf{{M}}_{{sys}}$ of {name} ({arm.n_joints} axes)"
        out.append(Figure.of(what, "-", lost))
    return tuple(out)


@cache
def mixed() -> Model:
    """Three flexible links behind joints of one, two and three axes."""
    modes = Modes(basis="clamped_free", bending_y=1, bending_z=1)
    links = [
        Link(name=f"link_{axes}", length=0.5, section=SECTION, modes=modes, joint=Joint(axes=tuple(axes)))
        for axes in ("z", "yz", "xyz")
    ]
    return derive(Robot(name="mixed", gravity=(0.0, 0.0, -9.81), links=links))
