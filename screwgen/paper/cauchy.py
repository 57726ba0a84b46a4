"""Section 6, its end: the solution of the system, the Cauchy form and the algorithm of Table 1."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ..algebra.expression import Expression, Inverse, Symbol, block, identity, stack, zeros
from .cauchy_state import inertial_states, measured_states, solution_misfits, step_defects
from .equation import Equality, Equation, Formula, Judge
from .evaluate import evaluate
from .quantities import symbol
from .random_motion import RandomMotion


def all_links(name: str, display: str) -> Symbol:
    """A column quantity of all links, one below the other."""
    return Symbol(f"{name}:all", (12, 1), display)


q, eta = all_links("q", r"\underline{\mathbf{q}}"), all_links("eta", r"\underline{\boldsymbol{\eta}}")
Z, etadot = all_links("Z", r"\underline{\mathbf{Z}}"), all_links("etadot", r"\dot{\underline{\boldsymbol{\eta}}}")
x_c, xdot_c, A_c, g_c, J_q, Zdot, etaddot = (
    symbol(name, "all") for name in ("x_c", "xdot_c", "A_c", "g_c", "J_q", "Zdot_star", "etaddot_star")
)
M_sys, H_sys, W_sys = (symbol(name, "all") for name in ("M_sys", "H_sys", "W_sys"))
SOLUTION = Symbol("q_sys:all", (36, 1), r"\mathbf{q}_{sys}^{*}")
COMPLETED = Symbol("M_sys_completed:all", (36, 36), r"\mathbf{M}_{sys}^{c}")
LOADS = Symbol("W_sys_completed:all", (36, 1), r"\boldsymbol{\mathcal{W}}_{sys}^{c}")
STATE = stack(q, eta, Z, etadot)
O1, O12, I12 = zeros(12), zeros(12, 12), identity(12)


def at_start(s: Symbol) -> Symbol:
    """A symbol at t = 0, the instant of the judge's motion."""
    return Symbol(s.name, s.shape, rf"{s.display}_0" if s is not x_c else rf"{s.display}(0)")


def coordinate_rates(J: Expression) -> Equality:
    """``A_c`` with the map from Z to the rates of the coordinates."""
    return Equality(A_c, block([O12, O12, J, O12], [O12, O12, O12, I12], *[[O12] * 4] * 2))


def equation(label: str, title: str, *printed: Equality | Formula, **rest: Any) -> Equation:
    return Equation(label=label, section="6", title=title, printed=printed, **rest)


# ------------------------------------------------------------------------------------------- judges


def on_motion(misfits: Callable) -> Judge:
    """A judge from a function of a motion's values and links."""

    def judge(seed: int) -> tuple[float, float]:
        motion = RandomMotion(seed)
        return misfits(motion.values, motion.links)

    return judge


def the_state_is_enough(seed: int) -> tuple[float, float]:
    """Places and velocities built up from ``x_c`` alone, against the motion."""
    motion = RandomMotion(seed)
    truth = measured_states(motion.links)
    gap = float(np.abs(inertial_states(evaluate(STATE, motion), motion.links) - truth).max() / np.abs(truth).max())
    return gap, gap


TABLE = (
    "i. input: mechanical and geometric properties",
    r"ii. input: initial inertial-frame states ${}^{o}\mathbf{q}_i(0)$, ${}^{o}\mathbf{q}_{\xi_i}(0)$, "
    r"${}^{o}\mathbf{V}_i(0)$, ${}^{o}\mathbf{V}_{\xi_i}(0)$",
    r"iii. input: initial Adjoint $\mathbf{Ad}_{oi}(0)$ from the initial configuration",
    r"iv. transform to body-fixed frame: ${}^{i}\mathbf{q}_i(0)$, ${}^{i}\mathbf{q}_{\xi_i}(0)$, "
    r"${}^{i}\mathbf{V}_i(0)$, ${}^{i}\mathbf{V}_{\xi_i}(0)$",
    r"v. calculate: $\boldsymbol{\phi}_i$ based on (35)-(38)",
    r"vi. input: ${}^{i}\mathbf{q}_{i}(k-1)$, ${}^{i}\mathbf{q}_{\xi_i}(k-1)$, ${}^{i}\mathbf{V}_{i}(k-1)$, "
    r"${}^{i}\mathbf{V}_{\xi_i}(k-1)$, $\mathbf{Ad}_{oi}(k-1)$",
    r"vii. solve: discretized model (98) to obtain $\dot{\underline{\mathbf{Z}}}^*(k-1)$, "
    r"$\ddot{\underline{\boldsymbol{\eta}}}^*(k-1)$, $\underline{\boldsymbol{\mathcal{W}}}^*(k-1)$",
    r"viii. integrate: update body-fixed states ${}^{i}\mathbf{q}_{i}(k)$, ${}^{i}\mathbf{q}_{\xi_i}(k)$, "
    r"${}^{i}\mathbf{V}_{i}(k)$, ${}^{i}\mathbf{V}_{\xi_i}(k)$ via $\dot{\mathbf{q}}_i = "
    r"\mathbf{J}_i(\mathbf{q}_i)\mathbf{Z}_i$ and $\boldsymbol{\eta}_i$, $\dot{\boldsymbol{\eta}}_i$ from (vii)",
    r"ix. update: $\mathbf{Ad}_{oi}(k)$ from ${}^{i}\mathbf{q}_i(k)$",
    r"x. transform to inertial frame: ${}^{o}\mathbf{q}_{i}(k)$, ${}^{o}\mathbf{q}_{\xi_i}(k)$, "
    r"${}^{o}\mathbf{V}_{i}(k)$, ${}^{o}\mathbf{V}_{\xi_i}(k)$ using $\mathbf{Ad}_{oi}(k)$",
    "xi. k = k + 1, go to (vi)",
)
MENDED = {
    6: (r"discretized model (98)", r"discretized model (98), its joint rows completed by the motors' torques,"),
    7: (r"\mathbf{J}_i(\mathbf{q}_i)\mathbf{Z}_i", r"\mathbf{J}_i(\mathbf{q}_i)^{-1}\mathbf{Z}_i"),
}
"""Steps that must read otherwise."""


def mended(step: int) -> str:
    return TABLE[step].replace(*MENDED[step]) if step in MENDED else TABLE[step]


EQUATIONS = (
    equation(
        "DAESOL",
        "solution of the system",
        Equality(SOLUTION, Inverse(M_sys) @ (W_sys - H_sys)),
        derived=(Equality(SOLUTION, Inverse(COMPLETED) @ (LOADS - H_sys)),),
        errata=("E17",),
        judge=on_motion(solution_misfits),
        block="joint_rows.P_c",
        note="The matrix has no inverse: with P of rank 6 - m it lacks one row per joint axis, and of all solutions "
        "the judge takes the smallest. The matrix marked c, with the loads, also says what torque the motors "
        "give about the axes.",
    ),
    equation(
        "109",
        "state of the Cauchy form",
        Equality(x_c, STATE),
        judge=the_state_is_enough,
        note="Judged by building up places, rotations and velocities of both links and of their deformed tips from "
        "these numbers alone.",
    ),
    equation(
        "110",
        "Cauchy form",
        Equality(xdot_c, A_c @ x_c + g_c),
        Equality(at_start(x_c), stack(*map(at_start, (q, eta, Z, etadot)))),
        note="Holds with the matrix of the derived (111): on the motion it is found by turning the links.",
    ),
    equation(
        "111",
        "matrix and accelerations of the Cauchy form",
        coordinate_rates(J_q),
        Equality(g_c, stack(O1, O1, Zdot, etaddot)),
        derived=(coordinate_rates(Inverse(J_q)), Equality(g_c, stack(O1, O1, Zdot, etaddot))),
        errata=("E18",),
        block="z_form.J_theta, z_form.J_inverse",
        note="By the text of Section 2 the Jacobian takes the rate of the exponential coordinates to the angular "
        "velocity. The accelerations on the left are those of the motion, on the right the solution of the completed "
        "system.",
    ),
    equation(
        "Table 1",
        "algorithm: assemble, solve, integrate, transform",
        *(Formula(line) for line in TABLE),
        derived=tuple(Formula(mended(k)) for k in range(len(TABLE))),
        errata=("E17", "E18"),
        gap=(
            Formula(
                r"step viii: $(\mathbf{J}(\boldsymbol{\theta}_i) - \mathbf{J}(\boldsymbol{\theta}_i)^{-1})"
                r"\boldsymbol{\omega}_i$ in $\dot{\boldsymbol{\theta}}_i$"
            ),
        ),
        judge=on_motion(step_defects),
        note="Judged by steps vii to x on the motion, one step of forward Euler forwards and backwards: the error per "
        "length of the step, extrapolated to a step of zero, which is zero if and only if the steps follow the motion. "
        "The printed figure takes the accelerations of the completed system and the printed step viii. In step x the "
        "rotation of Ad takes places and displacements to the inertial frame, Ad itself the twists.",
    ),
)
