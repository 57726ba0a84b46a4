"""Errata of Section 4."""

from __future__ import annotations

from . import synthesis_figures as figures
from .erratum import Erratum

ERRATA = (
    Erratum(
        number="E12",
        where=("45", "accconst1", "accconst4", "59", "63", "68"),
        title=r"$\mathbf{Ad}_{oi}$ applied to velocities of the joint's point",
        printed=r"$\mathbf{P}_i[\mathbf{Ad}_{o(i-1)}\mathbf{V}_{T_{i-1}} - \mathbf{Ad}_{oi}\mathbf{V}_{B_i}] = "
        r"\mathbf{0}$, and the same of the derivatives",
        holds=r"the twists of (46) and (47) hold the velocity of the joint's point, which is one vector: it only "
        r"turns, by $\mathrm{blkdiag}(\mathbf{R}_{oi}, \mathbf{R}_{oi})$. The Adjoint adds ${}^{o}\mathbf{r}_i \times "
        r"\mathbf{R}_{oi}\boldsymbol{\omega}_i$, which differs on the two sides of a turning joint",
        evidence=figures.elbow_apart,
    ),
    Erratum(
        number="E13",
        where=("43", "oA"),
        title=r"a joint of two axes whose axes are fixed in the link; $\mathbf{I} - \mathbf{A}\mathbf{A}^{\top}$",
        printed=r"${}^{i}\mathbf{A}_i$ is time-invariant in the link's frame, and "
        r"$\mathbf{I}_3 - {}^{o}\mathbf{A}_i{}^{o}\mathbf{A}_i^{\top}$ projects on what the joint blocks",
        holds=r"the first axis of a universal joint is turned by the second rotation: "
        r"${}^{i}\mathbf{A}_i = [\mathbf{R}_{i_2}^{\top}\mathbf{a}_{i_1}, \mathbf{a}_{i_2}]$. To block a constant axis "
        r"of the body is a non-holonomic condition: it blocks motions of the joint and lets the link drift about the "
        r"blocked axis. For axes that are not perpendicular the projector is "
        r"$\mathbf{I}_3 - \mathbf{A}\mathbf{A}^{+}$",
        evidence=figures.blocked_turn,
    ),
    Erratum(
        number="E14",
        where=("43",),
        title=r"ELLA's projectors $\mathrm{diag}(0,1,1)$ and $\mathrm{diag}(0,0,1)$",
        printed=r"Section 7: $\mathbf{I}_3 - \mathbf{A}_1\mathbf{A}_1^{\top} = \mathrm{diag}(0,1,1)$ for the axes y, z "
        r"and $\mathbf{I}_3 - \mathbf{A}_2\mathbf{A}_2^{\top} = \mathrm{diag}(0,0,1)$ for the axis z",
        holds=r"these are $\mathbf{A}\mathbf{A}^{\top}$: they block what the motors turn and free the rest. With (43), "
        r"in the link's frame and at $q = 0$: $\mathrm{diag}(1,0,0)$ and $\mathrm{diag}(1,1,0)$",
        evidence=figures.blocked_share,
    ),
    Erratum(
        number="E15",
        where=("59", "68"),
        title="columns and signs that do not match the unknowns",
        printed=r"$\mathbf{M}^{*}_i$ in the column of $\dot{\mathbf{V}}_{i-1}$ in (59); in (68) the whole fourth row "
        r"one column to the left, and rows one and three with the signs opposite to those of (59), (63) and (69)",
        holds=r"a link's inertia multiplies its own $\dot{\mathbf{V}}_i$. With the unknowns (67), link two has "
        r"$\mathbf{Ad}_{2o}^{-\top}\mathbf{Ad}_{o1}^{-\top}$ in the column of $\boldsymbol{\mathcal{W}}_1$, "
        r"$\mathbf{M}^{*}_2$ in that of $\dot{\mathbf{V}}_2$ and $-\mathbf{I}$ in that of "
        r"$\boldsymbol{\mathcal{W}}_2$; the rows of the joints have the signs of (63) and (59)",
        evidence=figures.misplaced,
    ),
    Erratum(
        number="E17",
        where=("43", "68"),
        title=r"$\mathbf{M}_{sys}$ is singular with the projectors alone",
        printed=r"Section 6, Step 2: with the rows of (43)-(45) as the joints' rows, $\mathbf{M}_{sys}$ is invertible",
        holds=r"$\mathbf{P}_i$ has rank $6 - m_i$, so $\mathbf{M}_{sys}$ has one zero singular value per joint axis: "
        r"the rows say nothing about the motion along the axes, and no torque of a motor occurs in them. The $m_i$ "
        r"missing rows are $\mathbf{A}^{\top}\boldsymbol{\tau}_w = \boldsymbol{\tau}$, what the motors supply; "
        r"completed by them the system is regular",
        evidence=figures.zero_singular_values,
    ),
    Erratum(
        number="E23",
        where=("accconst1b", "accconst2", "accconst4", "accconst5", "59", "63", "68"),
        title=r"the derivative of $\mathbf{V}_b$ is lost",
        printed=r"$\frac{d\mathbf{V}_T}{dt} = \dot{\mathbf{V}} + \dot{\mathbf{V}}_{\xi} + "
        r"\mathrm{ad}_{\mathbf{V}}\mathbf{V}_{\xi}$, of two of the three terms of (46)",
        holds=r"the third gives $\dot{\mathbf{V}}_b + \mathrm{ad}_{\mathbf{V}}\mathbf{V}_b$, whose lower part is "
        r"$-\tilde{\mathbf{r}}_b\dot{\boldsymbol{\omega}} + \tilde{\boldsymbol{\omega}}^2\mathbf{r}_b$. The first is "
        r"the lever in the columns of $\dot{\mathbf{V}}_i$, the second belongs to $\mathbf{H}_p$, as does "
        r"$\tilde{\boldsymbol{\omega}}_i\mathbf{v}_i$ (E3)",
        evidence=figures.lost_reference,
    ),
    Erratum(
        number="E27",
        where=("accconst1", "accconst5"),
        title=r"the rate of $\mathbf{P}_i$ is lost",
        printed=r"(45) differentiated with $\mathbf{P}_i$ constant",
        holds=r"the axes turn, so $\dot{\mathbf{P}}_i[\ldots]$ of the relative twist is part of the derivative and of "
        r"$\mathbf{H}_p$: $\boldsymbol{\omega}_{i-1}\times\mathbf{a}\dot{q}$ for a revolute joint",
        evidence=figures.turning_projector,
    ),
    Erratum(
        number="E31",
        where=("65", "68"),
        title=r"$\boldsymbol{\mathcal{W}}_0$ without its co-Adjoint",
        printed=r"$+\boldsymbol{\mathcal{W}}_0$ in the first link's balance, and $\mathbf{I}$ in its column",
        holds=r"(50) at $i = 1$ with $\mathbf{Ad}_{00} = \mathbf{I}$ leaves "
        r"$\mathbf{Ad}_{1o}^{-\top}\boldsymbol{\mathcal{W}}_0$: the unknown is about the inertial origin in inertial "
        r"components, the balance about the link's frame. As printed, $\boldsymbol{\mathcal{W}}_0$ would have to be "
        r"${}^{1}\boldsymbol{\mathcal{W}}_0$, unlike every other unknown of (67)",
        evidence=figures.ground,
    ),
    Erratum(
        number="E32",
        where=("61", "70"),
        title=r"$\mathbf{H}_p$ without its projector",
        printed=r"$\mathbf{H}_{pi}$ in the stacked rows, where (accconst4) has $\mathbf{P}_i\mathbf{H}_{pi}$",
        holds=r"the two agree as long as sections do not turn: the $\mathbf{H}_p$ printed has no rotation part, and "
        r"that derived has $\dot{\mathbf{P}}_i[\ldots]$, which $\mathbf{P}_i$ leaves as it is; so (61) and (70) hold "
        r"in the paper's own world. Once sections turn (E21), $\mathbf{H}_p$ has a part along the joint's axes, and "
        r"only $\mathbf{P}_i\mathbf{H}_p$ keeps the row of a free direction empty",
        evidence=figures.own_axis,
    ),
)
