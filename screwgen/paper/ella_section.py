"""Section 7: the two-link arm ELLA, its section, control law, shapes, wavenumbers and step bound."""

from __future__ import annotations

from typing import Any

import sympy as sp

from . import ella_judges as judges
from .arm import LENGTHS, ROD
from .equation import Equation, Formula

XI, L = sp.Symbol(r"\xi_i"), sp.Symbol("L")
RHO_A, EI, EA = sp.Symbol(r"\rho A"), sp.Symbol("EI"), sp.Symbol("EA")
T_S, OMEGA, OMEGA_MAX = sp.Symbol("T_s"), sp.Symbol(r"\omega"), sp.Symbol(r"\omega_{\max}")
l, n, FIRST_ROOT = sp.Symbol("l"), sp.Symbol("n"), sp.Symbol("(1.8751)")


def plus(*terms: sp.Expr) -> sp.Expr:
    """A sum that keeps its order."""
    return sp.Add(*terms, evaluate=False)


def times(*factors: sp.Expr) -> sp.Expr:
    """A product that keeps its order."""
    return sp.Mul(*factors, evaluate=False)


def minus(term: sp.Expr) -> sp.Expr:
    return times(-1, term)


def equals(left: sp.Expr, right: sp.Expr) -> sp.Eq:
    return sp.Eq(left, right, evaluate=False)


def equation(label: str, title: str, *printed: Formula, **rest: Any) -> Equation:
    return Equation(label=label, section="7", title=title, printed=printed, **rest)


# ------------------------------------------------------------------------------------------- shapes


def axial(wave: type[sp.Function]) -> sp.Eq:
    """The first axial shape with a sine or cosine, as a derivative or not."""
    factors = [sp.pi / (2 * L)] if wave is sp.cos else []
    shape = times(sp.Symbol("a_x"), *factors, wave(times(sp.pi / (2 * L), XI)))
    return equals(sp.Function("phi_x")(XI), shape)


def printed_bending(d: str) -> sp.Eq:
    """(phi_y), (phi_z) as printed."""
    a, beta, r, x = _letters(d)
    inner = plus(sp.sinh(x), sp.sin(x), times(-1, r, plus(sp.cosh(x), minus(sp.cos(x)))))
    return equals(sp.Function(f"phi_{d}")(XI), times(a, beta, inner))


def clamped_free(d: str) -> sp.Eq:
    """The mode of which (phi_y), (phi_z) are the derivative."""
    a, _, r, x = _letters(d)
    inner = plus(sp.cosh(x), minus(sp.cos(x)), times(-1, r, plus(sp.sinh(x), minus(sp.sin(x)))))
    return equals(sp.Function(f"phi_{d}")(XI), times(a, inner))


def _letters(d: str) -> tuple[sp.Expr, ...]:
    beta = sp.Symbol(rf"\beta_{d}")
    return sp.Symbol(f"a_{d}"), beta, sp.Symbol(rf"r_{{\phi_{d}}}"), times(beta, XI)


def bending_equation(d: str, title: str) -> Equation:
    printed, derived = printed_bending(d), clamped_free(d)

    def judge(seed: int) -> tuple[float, float]:
        n, length = judges.mode(seed), judges.drawn(seed).L
        misfit = lambda e: judges.bending_misfit(e.rhs, n, length)  # noqa: E731
        return misfit(printed), misfit(derived)

    return equation(
        f"phi_{d}",
        title,
        Formula(printed),
        derived=(Formula(derived),),
        errata=("E1",),
        judge=judge,
        note="Printed is the derivative of the mode, so the clamped end has the slope $2 a \\beta^2$. Judged by the "
        "conditions at both ends and by the overlap with another mode.",
    )


def judge_axial(seed: int) -> tuple[float, float]:
    misfit = lambda wave: judges.axial_misfit(axial(wave).rhs, judges.drawn(seed).L)  # noqa: E731
    return misfit(sp.cos), misfit(sp.sin)


# --------------------------------------------------------------------------------- single statements

BETA, BETA_N = sp.Symbol(r"\beta"), sp.Symbol(r"\beta_n")
WAVE = times(BETA, L)
RATIO = equals(
    sp.Symbol(r"r_{\phi}"),
    times(plus(sp.sinh(WAVE), minus(sp.sin(WAVE))), sp.Pow(plus(sp.cosh(WAVE), sp.cos(WAVE)), -1)),
)
WAVENUMBER = equals(BETA_N**2, times(2, sp.pi, sp.Symbol("f_n"), sp.sqrt(RHO_A / EI)))
BOUND = times(2 * l**2 / (FIRST_ROOT**2 * n**2), sp.sqrt(RHO_A / EI))
"""(stability) as printed."""

ROOTS = tuple(sp.Symbol(rf"\lambda_{k}") for k in (1, 2))
MU, LAMBDA, LAMBDA_N = sp.Symbol(r"\mu"), sp.Symbol(r"\lambda"), sp.Symbol(r"\lambda_n")
LOADED = equals(
    plus(
        1,
        times(sp.cos(LAMBDA), sp.cosh(LAMBDA)),
        times(MU, LAMBDA, plus(times(sp.cos(LAMBDA), sp.sinh(LAMBDA)), minus(times(sp.sin(LAMBDA), sp.cosh(LAMBDA))))),
    ),
    sp.Integer(0),
)
FASTEST = equals(
    OMEGA_MAX,
    sp.Max(
        times(LAMBDA_N**2 / l**2, sp.sqrt(EI / RHO_A)),
        times(plus(2 * n, -1), sp.pi / (2 * l), sp.sqrt(EA / RHO_A)),
        evaluate=False,
    ),
)
GROWTH = sp.Gt(sp.sqrt(plus(1, times(OMEGA**2, T_S**2))), 1, evaluate=False)
TWICE = sp.Symbol("f_2") / sp.Symbol("f_1")
"""The second frequency over the first."""

DENSITY, AREA, YOUNG = 7800.0, 2.09e-4, 2.1e11
"""kg/m³, m², Pa: the text's."""
INITIAL = (-0.02, 0.0065, -0.0083)
"""m: the text's displacement of the second link's tip at t = 0."""


def axial_load() -> tuple[float, float]:
    """Force in MN and energy in kJ that the x component of the initial displacement takes in a link along x."""
    force = ROD.EA * abs(INITIAL[0]) / LENGTHS[1]
    return force / 1e6, force * abs(INITIAL[0]) / 2 / 1e3


def printed_bound() -> float:
    """(stability) in s with the text's numbers."""
    given = {FIRST_ROOT: 1.8751, n: 1, l: LENGTHS[1], RHO_A: DENSITY * AREA, EI: ROD.EIz}
    return float(BOUND.subs(given).doit())


def axial_frequency() -> float:
    """rad/s of the first axial mode of the second link, clamped."""
    return float(sp.pi) / (2 * LENGTHS[1]) * (ROD.EA / ROD.rhoA) ** 0.5


SECTION_TEXT = (
    r"$EI_z = 3.67 \times 10^3$ N·m², $EI_y = 2.12 \times 10^3$ N·m², $EA = 4.38 \times 10^7$ N, "
    r"$A = 2.09 \times 10^{-4}$ m², $l_1 = 0.95$ m, $l_2 = 0.93$ m; motors of 3.3 kg, payload of 2.1 kg",
    r"later: $E = 2.1 \times 10^{11}$ Pa, $\rho = 7800$ kg/m³, strongest bending direction "
    r"$EI_y = 3.67 \times 10^3$ N·m²",
)
CONTROL = (
    r"$\boldsymbol{\tau}_{extB_i} = \mathrm{diag}(k_{p_1}, k_{p_2}, k_{p_2})"
    r"(\boldsymbol{\theta}_{di} - \boldsymbol{\theta}_i) + \mathrm{diag}(k_{d_1}, k_{d_2}, k_{d_2})"
    r"(\boldsymbol{\omega}_{di} - \boldsymbol{\omega}_i)$"
)
JOINT_CONTROL = (
    r"$\tau_{ij} = k_{p_{ij}}(q_{d,ij} - q_{ij}) + k_{d_{ij}}(\dot{q}_{d,ij} - \dot{q}_{ij})$ about axis j of joint i"
)

EQUATIONS = (
    equation(
        "ella",
        "section and masses of the arm",
        *map(Formula, SECTION_TEXT),
        derived=(Formula(SECTION_TEXT[0]), Formula(SECTION_TEXT[1].replace("EI_y", "EI_z"))),
        errata=("E20",),
        gap=(Formula(r"$EI_y$: $3.67 \times 10^3 - 2.12 \times 10^3 = 1.55 \times 10^3$ N·m²"),),
        judge=judges.section,
        note="Judged by the frequencies of the bare second link in z. The text's $EA$ is "
        f"{100 * (1 - ROD.EA / (YOUNG * AREA)):.1f} % below its product of E and A; with its density, "
        f"$\\rho A = {DENSITY * AREA:.4f}$ kg/m. It gives the tip of the second link a displacement at t = 0, "
        f"{list(INITIAL)} m in inertial components, at $b_i$, elsewhere $c_i$, and no posture. Of a link along x, "
        "the first would be axial and take {:.2f} MN and {:.1f} kJ: bending moves the tip across the link.".format(
            *axial_load()
        ),
    ),
    equation(
        "PD",
        "control law",
        Formula(CONTROL),
        derived=(Formula(JOINT_CONTROL),),
        errata=("E37",),
        gap=(
            Formula(
                r"$\boldsymbol{\theta}_i - \mathbf{q}_i$ for the angles, with $\exp(\tilde{\boldsymbol{\theta}}_i) = "
                r"\mathbf{R}_{o(i-1)}\prod_j\exp(\tilde{\mathbf{a}}_{ij}q_{ij})$: "
                "zero for a single axis of the first joint alone"
            ),
        ),
        judge=judges.control_law,
        note="Judged by the work of the proportional torque round a closed path of the universal joint: a spring does "
        "none. The paper gives no gains.",
    ),
    equation(
        "phi_x",
        "axial shape",
        Formula(axial(sp.cos)),
        derived=(Formula(axial(sp.sin)),),
        errata=("E1",),
        judge=judge_axial,
        note="Printed is the derivative of the mode: the clamped end moves. Judged by the conditions at both ends.",
    ),
    bending_equation("y", "bending shape in y"),
    bending_equation("z", "bending shape in z"),
    equation(
        "r_phi",
        "ratio of the clamped-free shapes",
        Formula(RATIO),
        judge=lambda seed: (judges.free_end(RATIO.rhs, seed),) * 2,
        note="Judged by moment and shear of the clamped-free mode at its free end.",
    ),
    equation(
        "wavenumber",
        "wavenumber from a natural frequency",
        Formula(WAVENUMBER),
        judge=lambda seed: (judges.wavenumber(WAVENUMBER.rhs, seed),) * 2,
        block="link.K",
        note="Of the bare clamped link; judged with frequencies found by Ritz's method in polynomials. A frequency of "
        "the arm, with payload, motors and joints, gives no wavenumber of these shapes.",
    ),
    equation(
        "stability",
        "bound on the time step",
        Formula(sp.Le(T_S, 2 / OMEGA_MAX, evaluate=False)),
        Formula(equals(2 / OMEGA_MAX, BOUND)),
        Formula(r"$T_s \leq 10.04 \times 10^{-3}$ s with $n = 1$, $l = 0.93$ m, $EI = 3.67 \times 10^3$ N·m²"),
        derived=(
            Formula(GROWTH),
            Formula(FASTEST),
            Formula(
                r"forward Euler multiplies an undamped oscillation by this root every step; symplectic Euler bears "
                r"$T_s < 2/\omega_{\max}$, $\cos\lambda_n\cosh\lambda_n = -1$: "
                rf"${1e3 * printed_bound():.2f} \times 10^{{-3}}$ s with the first bending mode alone, "
                rf"${2e3 / axial_frequency():.3f} \times 10^{{-3}}$ s with the first axial mode"
            ),
        ),
        errata=("E19",),
        gap=(
            Formula(r"amplification per step: $1 - \sqrt{1 + T_s^2\omega^2}$"),
            Formula(r"$\omega_n$ of bending: $(1.8751^2 n^2 - \lambda_n^2)\sqrt{EI/\rho A}/l^2$"),
        ),
        judge=judges.stability,
        note="Judged by stepping an oscillation of the bare link at 0.9 of the bound, and with symplectic Euler on "
        "both sides of it.",
    ),
    equation(
        "second_mode",
        "second frequency over the first",
        Formula(equals(TWICE, sp.Symbol(r"\left(\frac{4.6941}{1.8751}\right)") ** 2)),
        Formula("one mode is retained in each direction; a component near 13 Hz is said to be the second bending mode"),
        derived=(Formula(equals(TWICE, (ROOTS[1] / ROOTS[0]) ** 2)), Formula(LOADED)),
        errata=("E33",),
        judge=judges.second_mode,
        note=r"Of a clamped link with a load at its tip, $\mu$ times its own mass: its roots $\lambda_n$ depend on it. "
        "Judged by Ritz's method in polynomials with a random load.",
    ),
)
