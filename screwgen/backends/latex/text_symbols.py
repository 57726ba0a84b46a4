"""The symbols of a document's text that no step defines, in groups of which a document shows those that it uses."""

from __future__ import annotations

from ...ir.block import Binding
from .content import Named

STATE, PARAMETER = Binding.STATE, Binding.PARAMETER
TWIST, TWIST_RATE, WRENCH = "rad/s, m/s", "rad/s^2, m/s^2", "N*m, N"
MIXED, LINK, JOINT, ALL = "kg, kg*m, kg*m^2", "6 × 6", "n_{q,i} × n_{q,i}", r"(6 + r_i) × (6 + r_i)"
SYSTEM = r"12\,n + \sum r_i"

TEXT: tuple[Named, ...] = (
    (r"\mathcal{F}_i", "frame of link $i$", "-", "-", "-", STATE),
    (r"\xi", "place on the centreline, from the origin of F_i", "m", "1", "F_i", None),
    (r"s", "place on the centreline from base to tip, 0 to 1", "-", "1", "-", None),
    (r"\mathbf{V}_i", "twist of F_i", TWIST, "6", "F_i", STATE),
    (r"\boldsymbol{\nu}_i", "twist and modal rates", TWIST, "6 + r_i", "F_i", STATE),
    (r"\mathbf{w}_i", "wrench of link $i-1$ on link $i$ at the joint point", WRENCH, "6", "F_i", STATE),
    (r"\boldsymbol{\mathcal{W}}^*_i", "wrench on the link", WRENCH, "6", "F_i", STATE),
    (r"\mathbf{f}^*_i", "forces on the modes", "N", "r_i", "-", STATE),
    (r"\mathbf{D}^*_i", "what the deformation's inertia adds to the twist rows", WRENCH, "6", "F_i", STATE),
    (r"\mathbf{M}_i", "inertia of twist and modes together", "kg, kg*m, kg*m^2", ALL, "F_i", STATE),
    (r"\mathbf{h}_i", "bias of twist and modal rows together", WRENCH, "6 + r_i", "F_i", STATE),
    (r"\mathbf{J}_T", "takes twist and modal rates to the tip's twist", "1, m, 1/m", "6 × (6 + r_i)", "tip", STATE),
    (r"\boldsymbol{\mathcal{W}}_{ext,i}", "external wrench on the tip section", WRENCH, "6", "tip", STATE),
    (r"\boldsymbol{\tau}_i", "torques of the joint's motors", "N*m", "n_{q,i}", "-", STATE),
    (r"\mathbf{b}_T", "rate of the tip's twist that the velocities cause", "rad/s^2, m/s^2", "6", "tip", STATE),
    (r"\mathbf{X}_i", "takes the parent tip's twist to the joint point", "1, m", "6 × 6", "F_i", STATE),
    (r"\mathbf{J}_B", "takes the twist of F_i to the joint point", "1, m", "6 × 6", "F_i", PARAMETER),
    (r"\mathbf{r}_B", "joint point", "m", "3", "F_i", PARAMETER),
    (r"\mathbf{r}_M", "joint point from the parent's tip point", "m", "3", "parent's tip", PARAMETER),
    (r"\boldsymbol{\beta}_i", "joint's rate of the twist due to velocities", "rad/s^2, m/s^2", "6", "F_i", STATE),
    (r"\mathbf{P}_i", "projector onto the directions that the joint constrains", "-", "6 × 6", "F_i", STATE),
    (r"\mathbf{A}_i^{+}", "pseudo-inverse of the joint's axes", "-", "n_{q,i} × 3", "F_i", STATE),
    (r"m_T", "mass of the bodies at the tip", "kg", "1", "-", PARAMETER),
    (r"\mathbf{s}_T", "first moment of the bodies at the tip", "kg*m", "3", "tip", PARAMETER),
    (r"\mathbf{I}_T", "inertia of the bodies at the tip about the tip point", "kg*m^2", "3 × 3", "tip", PARAMETER),
    (r"\mathbf{h}_{T\tau}", "bias moment of the bodies at the tip", "N*m", "3", "tip", STATE),
    (r"\mathbf{h}_{TF}", "bias force of the bodies at the tip", "N", "3", "tip", STATE),
    (
        r"\boldsymbol{\beta}_{\omega}",
        "angular part of the joint's rate due to velocities",
        "rad/s^2",
        "3",
        "F_i",
        STATE,
    ),
    (r"\boldsymbol{\beta}_{v}", "linear part of the joint's rate due to velocities", "m/s^2", "3", "F_i", STATE),
    (r"\mathbf{b}_{\omega}", "angular part of the tip's rate due to velocities", "rad/s^2", "3", "tip", STATE),
    (r"\mathbf{b}_{v}", "linear part of the tip's rate due to velocities", "m/s^2", "3", "tip", STATE),
    (r"\mathbf{M}_T", "inertia of the bodies at the tip", "kg, kg*m, kg*m^2", "6 × 6", "tip", PARAMETER),
    (r"\mathbf{h}_T", "bias of the bodies at the tip", WRENCH, "6", "tip", STATE),
    (r"\mathbf{J}_m", "armature, rotor inertias seen at the axes", "kg*m^2", "n_{q,i} × n_{q,i}", "-", PARAMETER),
    (r"\mathbf{D}_q", "damping of the joint", "N*m*s/rad", "n_{q,i} × n_{q,i}", "-", PARAMETER),
    (r"\mathbf{K}_q", "stiffness of the joint", "N*m/rad", "n_{q,i} × n_{q,i}", "-", PARAMETER),
    (r"\mathbf{g}", "free fall", "m/s^2", "3", "inertial", PARAMETER),
)
"""Of every document: the links, their joints and what joins them."""

SLIDING: tuple[Named, ...] = (
    (r"\boldsymbol{\tau}_i", "torques of the joint's drives, of slides forces", "N*m, N", "n_{q,i}", "-", STATE),
    (r"\mathbf{S}_i^{+}", "pseudo-inverse of the joint's motion subspace", "-", "n_{q,i} × 6", "F_i", STATE),
    (r"\mathbf{J}_m", "armature, of the drives at the axes", "kg*m^2, kg", "n_{q,i} × n_{q,i}", "-", PARAMETER),
    (r"\mathbf{D}_q", "damping of the joint", "N*m*s/rad, N*s/m", "n_{q,i} × n_{q,i}", "-", PARAMETER),
    (r"\mathbf{K}_q", "stiffness of the joint", "N*m/rad, N/m", "n_{q,i} × n_{q,i}", "-", PARAMETER),
)
"""Of robots whose joints slide, in place of those above."""

ELEMENT: tuple[Named, ...] = (
    (r"\mathbf{N}", "takes twist and modal rates to the velocity of an element", "1, m", "3 × (6 + r_i)", "F_i", STATE),
    (r"\mathbf{v}_{ob}", "velocity of an element", "m/s", "3", "F_i", STATE),
)
"""Of an element of a link."""

PLACES: tuple[Named, ...] = (
    (r"\mathbf{R}_{oi}", "takes components in F_i to inertial ones", "-", "3 × 3", "-", STATE),
    (r"\mathbf{r}_{oi}", "position of the origin of F_i", "m", "3", "inertial", STATE),
    (r"\mathbf{V}_T", "twist of the tip section", TWIST, "6", "tip", STATE),
    (r"\mathbf{V}_{T,i-1}", "twist of the section that carries link $i$", TWIST, "6", "parent's tip", STATE),
    (r"\mathbf{R}_{oT}", "takes components in the tip frame to inertial ones", "-", "3 × 3", "-", STATE),
    (r"\mathbf{r}_{oT}", "position of the tip point", "m", "3", "inertial", STATE),
    (r"\mathbf{R}_{oT,i-1}", "$\\mathbf{R}_{oT}$ of the section that carries link $i$", "-", "3 × 3", "-", STATE),
    (r"\mathbf{r}_{oT,i-1}", "position of the section that carries link $i$", "m", "3", "inertial", STATE),
    (r"\mathbf{I}_3", "identity", "-", "3 × 3", "-", Binding.CONSTANT),
    (r"\mathbf{I}_6", "identity", "-", "6 × 6", "-", Binding.CONSTANT),
    (r"\mathbf{q}_i", "coordinates of the joint", "rad, m", "n_{q,i}", "-", STATE),
    (r"\boldsymbol{\tau}_{w,i}", "angular part of $\\mathbf{w}_i$", "N*m", "3", "F_i", STATE),
    (
        r"\mathbf{w}_{i+1}",
        "wrench of link $i$ on one that it carries, at its joint point",
        WRENCH,
        "6",
        "F_{i+1}",
        STATE,
    ),
    (r"\mathbf{S}_i", "motion subspace of the joint, at the joint point", "-, m", "6 × n_{q,i}", "F_i", STATE),
    (
        r"\partial\boldsymbol{\ell}_c",
        "derivative of the length of a tendon's piece along the link with the modes",
        "1",
        "r_i",
        "-",
        STATE,
    ),
    (r"\mathbf{A}_i", "axes of the joint", "-", "3 × n_{q,i}", "F_i", STATE),
    (r"\mathbf{j}_m", "armatures of the axes", "kg*m^2, kg", "n_{q,i}", "-", PARAMETER),
    (r"\mathbf{d}_q", "dampings of the axes", "N*m*s/rad, N*s/m", "n_{q,i}", "-", PARAMETER),
    (r"\mathbf{k}_q", "stiffnesses of the axes", "N*m/rad, N/m", "n_{q,i}", "-", PARAMETER),
)
"""Of tips and joints."""

ELIMINATION: tuple[Named, ...] = (
    (r"\mathbf{M}^A_i", "$\\mathbf{M}_i$ and what carried links add", MIXED, ALL, "F_i", STATE),
    (r"\mathbf{h}^A_i", "$\\mathbf{h}_i$ and what carried links add, less loads", WRENCH, "6 + r_i", "F_i", STATE),
    (r"\hat{\mathbf{M}}_i", "inertia of the link and of all further out, modes eliminated", MIXED, LINK, "F_i", STATE),
    (r"\hat{\mathbf{h}}_i", "bias of the link and of all further out, modes eliminated", WRENCH, "6", "F_i", STATE),
    (r"\dot{\mathbf{V}}_g", "rate of the twist of a base whose motion is given", TWIST_RATE, "6", "F_1", STATE),
    (r"\bar{\mathbf{S}}_i", "motion subspace of the joint, for the origin of F_i", "1, m", "6 × n_{q,i}", "F_i", STATE),
    (r"\mathbf{E}_i", "1 for each axis whose motion is given", "-", "n_{q,i} × n_{q,i}", "-", Binding.CONSTANT),
    (r"\bar{\mathbf{E}}_i", "1 for each axis whose motion follows", "-", "n_{q,i} × n_{q,i}", "-", Binding.CONSTANT),
    (r"\mathbf{S}^f_i", "motion subspace of the axes whose motion follows", "1, m", "6 × n_{q,i}", "F_i", STATE),
    (r"\hat{\mathbf{h}}^a_i", "bias with what accelerations that are given take", WRENCH, "6", "F_i", STATE),
    (r"\boldsymbol{\sigma}_{b,i}", "what brakes leave of the balance of each axis", "-", "n_{q,i}", "-", STATE),
    (r"\mathbf{j}_{b,i}", "inertia with which brakes hold each axis", "kg*m^2, kg", "n_{q,i}", "-", STATE),
    (r"\ddot{\mathbf{q}}_{b,i}", "accelerations by which brakes stop axes", "rad/s^2, m/s^2", "n_{q,i}", "-", STATE),
    (r"\boldsymbol{\Sigma}_{b,i}", "the diagonal matrix of what brakes leave", "-", JOINT, "-", STATE),
    (r"\mathbf{J}_{b,i}", "the diagonal matrix of the inertias of brakes", "kg*m^2, kg", JOINT, "-", STATE),
    (r"\boldsymbol{\Delta}_i", "inertia that the axes of the joint move", "kg*m^2, kg", JOINT, "-", STATE),
    (r"\mathbf{f}_{q,i}", "forces of the axes that are left to accelerate them", "N*m, N", "n_{q,i}", "-", STATE),
    (r"\boldsymbol{\Lambda}_i", "articulated inertia: modes and joint eliminated", MIXED, LINK, "F_i", STATE),
    (r"\mathbf{p}_i", "articulated bias: modes and joint eliminated", WRENCH, "6", "F_i", STATE),
    (
        r"\boldsymbol{\Lambda}^P_i",
        "articulated inertia, for the section that carries the link",
        MIXED,
        LINK,
        "tip",
        STATE,
    ),
    (r"\mathbf{p}^P_i", "articulated bias, for the section that carries the link", WRENCH, "6", "tip", STATE),
    (r"\mathbf{a}_{c,i}", "acceleration of F_i with the joint at rest", TWIST_RATE, "6", "F_i", STATE),
)
"""Of the forward dynamics."""

ROBOT: tuple[Named, ...] = (
    (r"\mathbf{M}", "mass matrix of the robot", MIXED, "n_v × n_v", "-", STATE),
    (r"\mathbf{h}", "bias, the generalised forces that need no acceleration and no input", "N*m, N", "n_v", "-", STATE),
    (r"\mathbf{q}", "coordinates of the robot", "rad, m", "n_q", "-", STATE),
    (r"\mathbf{u}", "inputs: torques and forces of the drives, tensions", "N*m, N", "n_u", "-", STATE),
    (r"\mathbf{B}_u", "directions of the inputs", "1, m", "n_v × n_u", "-", STATE),
    (r"\mathbf{v}", "rates of the robot", TWIST, "n_v", "-", STATE),
    (r"\mathbf{G}_i", "takes the rates of the robot to those of link $i$", "1, m", "(6 + r_i) × n_v", "F_i", STATE),
    (r"\mathbf{G}_{T,i}", "takes the rates of the robot to the twist of the tip", "1, m", "6 × n_v", "tip", STATE),
    (r"\mathbf{M}_{sys}", "matrix of the stacked system", MIXED, rf"({SYSTEM}) × ({SYSTEM})", "F_i", STATE),
    (r"\mathbf{q}_{sys}", "unknowns of the stacked system", WRENCH, SYSTEM, "F_i", STATE),
    (r"\mathbf{H}_{sys}", "bias of the stacked system", WRENCH, SYSTEM, "F_i", STATE),
    (r"\boldsymbol{\mathcal{W}}_{sys}", "loads of the stacked system", WRENCH, SYSTEM, "F_i", STATE),
)
"""Of all links together."""

CLOSING: tuple[Named, ...] = (
    (r"\boldsymbol{\lambda}", "forces of all rows that close loops or couple axes", "N, N*m", "n_g", "-", STATE),
    (r"\lambda_j", "force of row j that closes a loop or couples axes", "N, N*m", "1", "-", STATE),
    (r"g", "gap of a row", "m, 1", "1", "-", STATE),
    (r"\gamma", "what velocities add to a gap's acceleration, beside the tips'", "m/s^2, 1/s^2", "1", "-", STATE),
    (r"\ddot{g}_0", "acceleration of a gap while no row bears a force", "m/s^2, 1/s^2", "1", "-", STATE),
    (r"\mathbf{W}_A", "wrench by a unit force of a row on tip A", "1, m", "6", "inertial", STATE),
    (r"\mathbf{W}_B", "wrench by a unit force of a row on tip B", "1, m", "6", "inertial", STATE),
)
"""Of rows that close loops."""

BLOCKS: tuple[Named, ...] = (
    (r"\mathbf{M}^c_j", "inertia of link $j$ with all further out, no joint or mode moving", MIXED, LINK, "F_j", STATE),
    (r"\mathbf{Y}_k", "takes the twist of the carrying link to that of link $k$", "-, m", LINK, "F_k", STATE),
    (r"\mathbf{Y}_{\eta,k}", "takes its modal rates to the twist of link $k$", "1/m, -", "6 × r_i", "F_k", STATE),
    (r"\mathbf{U}_{q,j}", "wrenches on link $j$ by accelerations of its joint", WRENCH, "6 × n_{q,j}", "F_j", STATE),
    (r"\mathbf{U}_{\eta,j}", "wrenches on link $j$ by accelerations of its modes", WRENCH, "6 × r_j", "F_j", STATE),
)
"""Of the blocks of the mass matrix."""

THEORY = (*ELEMENT, *PLACES, *ELIMINATION, *ROBOT, *CLOSING, *BLOCKS)
"""Those that a document has stand in its table."""
