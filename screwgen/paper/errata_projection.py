"""Errata of Section 5, Appendix B and the symmetry of Section 6: the modal projection."""

from __future__ import annotations

from . import locked_joints, modal_evidence
from .appendix_b import EQUATIONS as APPENDIX
from .discretised import EQUATIONS as SYSTEM
from .erratum import Erratum, Figure, misfit
from .function_spaces import weak_stiffness
from .projection import EQUATIONS, L, field, gravity

FORCE = 10.0
"""N, at the tip of link 2."""
CONVERGED = 1e-4
"""Two modes per plane against the beam elements, relative."""


def of(label: str) -> Figure:
    """The misfit of an equation of these sections."""
    return misfit((*EQUATIONS, *SYSTEM, *APPENDIX), label)


def lever_of_the_origin() -> tuple[Figure, ...]:
    printed, derived = (field(L.r_ib, L.rdot_ib, gravity), field(L.r_ob, L.rdot_ob, -gravity))
    along = [modal_evidence.at_origin_of_link_2(left) for left in (printed, derived)]
    what = "the straight arm turns at 1 rad/s: acceleration of the elbow, 0.95 m from the axis, along the arm"
    return Figure.of(what, "m/s²", along, truth=-0.95), of("81")


def mass_per_length() -> tuple[Figure, ...]:
    printed, derived, truth = modal_evidence.cross_energy()
    what = "kinetic energy that the twist and the modal rates of a link have together"
    ratios = modal_evidence.ratio_to_transpose()
    return (
        Figure(
            r"entries of $\mathbf{M}_{D\phi}$ over those of $\boldsymbol{M}_D^{\top}$, which (103) calls equal",
            "-",
            *ratios,
            truth=1.0,
        ),
        Figure(what, "J", printed, derived, truth),
    )


def wrenches_in_modal_rows() -> tuple[Figure, ...]:
    from .frame_elements import arm_frequencies

    printed, derived = locked_joints.frequencies_without_wrenches(), locked_joints.derived_frequencies()
    truth, bent = arm_frequencies(), locked_joints.tip_deflection(FORCE)
    what = "frequency of the arm of Section 7, joints locked at the set points, against beam elements"
    return (
        *(
            Figure(f"{order} {what}", "Hz", printed[k], derived[k], float(truth[k]), CONVERGED)
            for k, order in enumerate(("first", "second"))
        ),
        Figure(f"deflection of the clamped link 2 by {FORCE:g} N at its tip, against statics", "m", 0.0, *bent),
        of("85"),
        of("89"),
    )


def inverse_jacobian() -> tuple[Figure, ...]:
    printed, derived = modal_evidence.attitude_errors()
    what = r"attitude error after a second of turning at 1 rad/s, started with $\boldsymbol{\theta} = [1, 0, 0]$"
    return Figure(what, "°", printed, derived), of("jacobian")


def order_of_rows() -> tuple[Figure, ...]:
    named, derived, there = modal_evidence.differential_rows()
    gaps = modal_evidence.gap_of_row_order()
    return (
        Figure(
            "misfit of (95) with (B1) repaired in all but the order of its rows", "-", *gaps, within=1e-11, scale=1.0
        ),
        Figure("differential block rows that (103) pairs, for two links", "-", named, derived, there),
    )


def weight_in_the_rows() -> tuple[Figure, ...]:
    printed, derived = locked_joints.base_force_at_rest()
    what = "force of the ground on the resting arm of Section 7, against its weight"
    return Figure(what, "N", printed, derived, locked_joints.weight()), of("97")


def symmetry_in_z() -> tuple[Figure, ...]:
    lowest = [min(x, 0.0) for x in modal_evidence.lowest_eigenvalue()]
    what = r"largest asymmetry of $\mathbf{M}^*_i(\mathbf{I}+\mathbf{T}_{\gamma_i})$, relative"
    return (
        Figure(what, "-", *modal_evidence.block_asymmetry()),
        Figure("negative eigenvalue of the differential-modal block over its largest", "-", *lowest),
        Figure("kinetic energy of the judge's second link by (2T)", "J", *modal_evidence.kinetic_energies()),
    )


def constraint_rows() -> tuple[Figure, ...]:
    return (
        Figure("elastic acceleration of the base of a straight link at 1 rad/s²", "m/s²", *modal_evidence.moved_end()),
        Figure(
            "force that turning link 2 at 1 rad/s² needs by its deflection", "N", *modal_evidence.force_of_turning()
        ),
        of("B2"),
    )


def carried_deformation() -> tuple[Figure, ...]:
    columns, biases = modal_evidence.deformation_carried()
    return (
        Figure(
            "moment that the deflection of link 2 adds where its frame moves off at 1 m/s² along y", "N·m", *columns
        ),
        Figure(r"moment of $\mathbf{h}_{M_D}$ on link 2 where the modal rates are zero", "N·m", *biases),
    )


def weak_form() -> tuple[Figure, ...]:
    printed, equal, derived = modal_evidence.first_frequencies()
    strong, weak = weak_stiffness(1)
    truth = modal_evidence.ROOT**2
    what = "(βl)² of a cantilever's first mode, orthonormal polynomials of degrees 2 to 5"
    return (
        Figure(f"{what}, as printed", "-", printed, derived, truth, 1e-5),
        Figure(f"{what}, equal modes alone in the weak form", "-", equal, derived, truth, 1e-5),
        Figure("stiffness of the cubic of two beam elements over 24 EI/h³", "-", 1 - strong, 1 - weak, 1.0),
        of("88"),
    )


ERRATA = (
    Erratum(
        number="E4",
        where=("81", "82", "85", "88"),
        title=r"with $\ddot{\mathbf{r}}_i$ as unknown the place is $\mathbf{r}_{ob}$, not $\mathbf{r}_{ib}$",
        printed=r"$-\tilde{\mathbf{r}}_{ib_i}\dot{\boldsymbol{\omega}}_i + 2\tilde{\boldsymbol{\omega}}_i"
        r"\dot{\mathbf{r}}_{ib_i} + \tilde{\boldsymbol{\omega}}_i^2\mathbf{r}_{ib_i}$ beside $\ddot{\mathbf{r}}_i$",
        holds=r"the components of $\mathbf{r}_i$ turn too: by (21) all three places are measured from the inertial "
        r"origin. What is lost is $-\tilde{\mathbf{r}}_i\dot{\boldsymbol{\omega}}_i + 2\tilde{\boldsymbol{\omega}}_i"
        r"\dot{\mathbf{r}}_i + \tilde{\boldsymbol{\omega}}_i^2\mathbf{r}_i$: a frame carried round a circle is not "
        "accelerated",
        evidence=lever_of_the_origin,
    ),
    Erratum(
        number="E9",
        where=("B1", "B2", "B3", "82", "85", "86", "88", "103"),
        title=r"the mass per length $\rho_i A_i$ is missing",
        printed=r"$\int\boldsymbol{\phi}_1 d\xi_1$ in (B1), $\int\boldsymbol{\phi}_{ip}^{\top} d\xi_i$ in (82) and "
        r"(85)",
        holds=r"(28) and (69), from which (B1) to (B3) follow, have $\rho_i A_i$ before each integral. The modal rows "
        r"may be divided by it, but then $\mathbf{M}_{D\phi}$ is $\boldsymbol{M}_D^{\top}/(\rho_i A_i)$ and (103), "
        r"(cross) and (2T) fail: it is kept in both",
        evidence=mass_per_length,
    ),
    Erratum(
        number="E16",
        where=("82", "83", "85", "89", "100", "103"),
        title="no wrench reaches the modes",
        printed=r"the wrench columns of $\mathbf{M}_{D\phi}$ are zero and so is the right-hand side of the modal rows",
        holds=r"integration by parts leaves $\boldsymbol{\phi}(c)^{\top}\mathbf{F}$ and $\boldsymbol{\phi}'(c)^{\top}"
        r"\mathbf{H}\boldsymbol{\tau}$ at the ends, (35) to (38): "
        r"$\mathbf{J}_{\eta_i}(c_i)^{\top}\boldsymbol{\mathcal{W}}_i$ belongs in the rows of link $i$. Its columns are "
        r"among the unknowns of link $i+1$, so $\mathbf{M}_{D\phi}$ is not block-diagonal. Without it every link "
        r"vibrates as a bare cantilever, whatever it carries",
        evidence=wrenches_in_modal_rows,
    ),
    Erratum(
        number="E18",
        where=("jacobian", "111"),
        title=r"$\mathbf{J}(\boldsymbol{\theta}_i)$ where its inverse belongs",
        printed=r"$\boldsymbol{\omega}_i = \mathbf{J}(\boldsymbol{\theta}_i)\dot{\boldsymbol{\theta}}_i$ in Section 2, "
        r"and $\dot{\boldsymbol{\theta}}_i = \mathbf{J}(\boldsymbol{\theta}_i)\boldsymbol{\omega}_i$ in (jacobian)",
        holds=r"$\dot{\boldsymbol{\theta}}_i = \mathbf{J}(\boldsymbol{\theta}_i)^{-1}\boldsymbol{\omega}_i$",
        evidence=inverse_jacobian,
    ),
    Erratum(
        number="E24",
        where=("B1", "B2", "B3", "103"),
        title="rows with the translational part first, and k from 1",
        printed=r"rows in the order translation, rotation, linear momentum, angular momentum; (103) for $k = "
        r"1,\dots,n$",
        holds=r"twists, wrenches and (27) have the angular part first. As numbered, (103) sets the columns of "
        r"$\dot{\boldsymbol{\omega}}$ against rows of force, and it leaves out the first link: $k = 0,\dots,n-1$",
        evidence=order_of_rows,
    ),
    Erratum(
        number="E25",
        where=("97",),
        title=r"$\mathbf{h}_{dyn}$ lacks $\mathbf{h}_s$",
        printed=r"$\mathbf{h}_{dyn} = \mathbf{h}_{M_s} + \mathbf{h}_{M_D}$",
        holds=r"$\mathbf{h}_{dyn} = \mathbf{h}_{M_s} + \mathbf{h}_{M_D} + \mathbf{h}_s$: (66) has $\mathbf{h}_s$, and "
        r"with it go $\mathbf{H}^*_i$ and $\mathbf{H}_{pi}$, gyroscopic wrenches and weight",
        evidence=weight_in_the_rows,
    ),
    Erratum(
        number="E26",
        where=("103", "cross", "2T", "Msys_diff"),
        title=r"$\mathbf{M}_s(\mathbf{I}+\mathbf{T}_\gamma)$ is not symmetric, and $2T$ takes velocities",
        printed=r"the differential-modal block in the unknowns $\dot{\mathbf{Z}}_i$ is a quadratic form, positive "
        r"definite, and twice the kinetic energy in accelerations",
        holds=r"rows are dual to twists, columns are rates of $\mathbf{Z}$: symmetric for $\mathbf{r}_i = \mathbf{0}$ "
        r"alone, or with the rows multiplied by $(\mathbf{I}+\mathbf{T}_\gamma)^{\top}$. Then it is twice the kinetic "
        r"energy in $\mathbf{Z}_i$ and $\dot{\boldsymbol{\eta}}_i$",
        evidence=symmetry_in_z,
    ),
    Erratum(
        number="E28",
        where=("B2",),
        title="constraint rows without the displacement, last entries one column left",
        printed=r"$-\mathbf{R}_{o1}$, and $\mathbf{R}_{o1}$, $-\mathbf{R}_{o2}$ in the columns of angular "
        r"accelerations; the last two rows in column $2n-1$, that of a wrench",
        holds=r"$+\mathbf{R}_{o1}\widetilde{\boldsymbol{\phi}_1\boldsymbol{\eta}_1}(a_1)$, and "
        r"$-\mathbf{R}_{o1}\widetilde{\boldsymbol{\phi}_1\boldsymbol{\eta}_1}(c_1)$, "
        r"$+\mathbf{R}_{o2}\widetilde{\boldsymbol{\phi}_2\boldsymbol{\eta}_2}(a_2)$, as the units ask; column $2n$. "
        r"Step 2 of the proof of regularity takes the printed entries for full-rank blocks; they vanish for straight "
        r"links",
        evidence=constraint_rows,
    ),
    Erratum(
        number="E30",
        where=("77", "82", "88"),
        title="stiffness in its strong form, and of equal modes alone",
        printed=r"$\int(\boldsymbol{\phi}_{ip}'''')^{\top}\boldsymbol{\phi}_{ip}\,d\xi_i$ for functions of $H^2$",
        holds=r"$\int(\boldsymbol{\phi}_{ip}'')^{\top}\mathbf{I}_{v2_i}\boldsymbol{\phi}_{iq}''\,d\xi_i$ for all pairs "
        r"$p, q$: orthogonal shapes need not have orthogonal curvatures, $H^2$ does not carry $\boldsymbol{\phi}''''$, "
        r"and the boundary terms of the strong form are those of E16",
        evidence=weak_form,
    ),
    Erratum(
        number="E36",
        where=("B2", "B3"),
        title="the deformation's inertia depends on the motion of the frame's origin",
        printed=r"zero columns of $\boldsymbol{M}_{D\Psi}$ at $\ddot{\mathbf{r}}_j$, which the text says confirm that "
        r"only $\dot{\boldsymbol{\omega}}_j$ couples; and $\mathbf{h}_{M_D}$ vanishes identically where "
        r"$\dot{\boldsymbol{\eta}}_i = \mathbf{0}$",
        holds=r"the moment of a deflected link has $\rho_iA_i\int\tilde{\mathbf{r}}_{\xi_i}d\xi\,\dot{\mathbf{v}}_i$ "
        r"(E8). In the unknowns of (84) it gives the columns $\rho_iA_i\int\tilde{\mathbf{r}}_{\xi_i}d\xi$ at "
        r"$\ddot{\mathbf{r}}_i$ and the bias "
        r"$\rho_iA_i\int\tilde{\mathbf{r}}_{\xi_i}d\xi\,\tilde{\boldsymbol{\omega}}_i\dot{\mathbf{r}}_i$, whatever the "
        r"modal rates",
        evidence=carried_deformation,
    ),
)
