"""The quantities of the paper as symbols: shape, notation, meaning and unit, for any link index.

A symbol's name is ``quantity:index``, with the index as the paper writes it: ``omega:i``, ``V:i-1``, ``R:1``.
Fields vary along the link; they are integrated, or taken at a place of the centreline.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from ..algebra.expression import Expression, Integral, Symbol


@dataclass(frozen=True)
class Letter:
    """One letter of the paper; ``@`` in its LaTeX stands for the link's index."""

    shape: tuple[int, int]
    display: str
    unit: str
    meaning: str
    field: bool = False


S, V3, V6, M3, M6 = (1, 1), (3, 1), (6, 1), (3, 3), (6, 6)
MODES = 6
"""The modes of the judge's links: two in each direction, so that the paper's r is 2."""

QUANTITIES = {
    # configuration and velocity of a link's frame
    "theta": Letter(V3, r"\boldsymbol{\theta}_@", "rad", "exponential coordinates of the link's rotation"),
    "thetadot": Letter(V3, r"\dot{\boldsymbol{\theta}}_@", "rad/s", "their rate"),
    "J_theta": Letter(M3, r"\mathbf{J}(\boldsymbol{\theta}_@)", "-", "body-frame Jacobian of the exponential map"),
    "R": Letter(M3, r"\mathbf{R}_{o@}", "-", "rotation: components in F_i to inertial ones"),
    "r_o": Letter(V3, r"{}^{o}\mathbf{r}_@", "m", "position of the link's frame, inertial components"),
    "r": Letter(V3, r"\mathbf{r}_@", "m", "position of the link's frame, body components"),
    "rdot": Letter(V3, r"\dot{\mathbf{r}}_@", "m/s", "rate of the components of r"),
    "rddot": Letter(V3, r"\ddot{\mathbf{r}}_@", "m/s^2", "second rate of the components of r"),
    "omega": Letter(V3, r"\boldsymbol{\omega}_@", "rad/s", "angular velocity"),
    "omegadot": Letter(V3, r"\dot{\boldsymbol{\omega}}_@", "rad/s^2", "rate of the components of omega"),
    "v": Letter(V3, r"\mathbf{v}_@", "m/s", "velocity of the frame's origin"),
    "vdot": Letter(V3, r"\dot{\mathbf{v}}_@", "m/s^2", "rate of the components of v"),
    "V": Letter(V6, r"\mathbf{V}_@", "rad/s, m/s", "twist of the link"),
    "Vdot": Letter(V6, r"\dot{\mathbf{V}}_@", "rad/s^2, m/s^2", "rate of the components of the twist"),
    "dV": Letter(V6, r"\frac{d\mathbf{V}_@}{dt}", "rad/s^2, m/s^2", "inertial derivative of the twist"),
    "d_r": Letter(V3, r"\frac{d}{dt}\mathbf{r}_@", "m/s", "inertial derivative of r"),
    "dd_r": Letter(V3, r"\frac{d^2}{dt^2}\mathbf{r}_@", "m/s^2", "second inertial derivative of r"),
    "Z": Letter(V6, r"\mathbf{Z}_@", "rad/s, m/s", "[omega; rdot]"),
    "Zdot": Letter(V6, r"\dot{\mathbf{Z}}_@", "rad/s^2, m/s^2", "rate of Z"),
    "gamma": Letter(V6, r"\boldsymbol{\gamma}_@", "rad/s, m/s", "V - Z"),
    "T_gamma": Letter(M6, r"\mathbf{T}_{\gamma_@}", "m", "what the origin's lever adds to the rate of Z"),
    "gamma_star": Letter(V6, r"\boldsymbol{\gamma}_@^{*}", "rad/s^2, m/s^2", "bias of the rate of gamma"),
    "J_q_link": Letter(M6, r"\mathbf{J}(\mathbf{q}_@)", "-", "from Z to the rates of the coordinates"),
    "q": Letter(V6, r"\mathbf{q}_@", "rad, m", "generalised coordinates [theta; r]"),
    "qdot": Letter(V6, r"\dot{\mathbf{q}}_@", "rad/s, m/s", "their rate"),
    "Ad": Letter(M6, r"\mathbf{Ad}_{o@}", "-, m", "Adjoint of the link's frame"),
    "Ad_back": Letter(M6, r"\mathbf{Ad}_{@o}", "-, m", "Adjoint from the inertial frame"),
    "Ad_R": Letter(M6, r"\mathbf{Ad}^{R}_{o@}", "-", "blkdiag(R, R): the Adjoint without its lever"),
    "ad": Letter(M6, r"\mathrm{ad}_{\mathbf{V}_@}", "rad/s, m/s", "small adjoint of the twist"),
    "u": Letter(V6, r"\mathbf{u}", "rad/s, m/s", "any screw"),
    "bracket": Letter(V6, r"\left[\mathbf{V}_@, \mathbf{u}\right]", "-", "Lie bracket of the twist and u"),
    # fields along a link
    "r_b": Letter(V3, r"\mathbf{r}_{b_@}", "m", "undeformed place of an element", True),
    "r_xi": Letter(V3, r"\mathbf{r}_{\xi_@}", "m", "elastic displacement", True),
    "rdot_xi": Letter(V3, r"\dot{\mathbf{r}}_{\xi_@}", "m/s", "rate of its components", True),
    "rddot_xi": Letter(V3, r"\ddot{\mathbf{r}}_{\xi_@}", "m/s^2", "second rate of its components", True),
    "r_ib": Letter(V3, r"\mathbf{r}_{@b_@}", "m", "place of an element from the frame's origin", True),
    "rdot_ib": Letter(V3, r"\dot{\mathbf{r}}_{@b_@}", "m/s", "rate of its components", True),
    "r_ob": Letter(V3, r"\mathbf{r}_{ob_@}", "m", "place of an element from the inertial origin", True),
    "rdot_ob": Letter(V3, r"\dot{\mathbf{r}}_{ob_@}", "m/s", "rate of its components", True),
    "d_r_xi": Letter(V3, r"\frac{d}{dt}\mathbf{r}_{\xi_@}", "m/s", "inertial derivative", True),
    "d_r_b": Letter(V3, r"\frac{d}{dt}\mathbf{r}_{b_@}", "m/s", "inertial derivative", True),
    "d_r_ob": Letter(V3, r"\frac{d}{dt}\mathbf{r}_{ob_@}", "m/s", "inertial derivative", True),
    "dd_r_ib": Letter(V3, r"\frac{d^2}{dt^2}\mathbf{r}_{@b_@}", "m/s^2", "second inertial derivative", True),
    "dd_r_ob": Letter(V3, r"\frac{d^2}{dt^2}\mathbf{r}_{ob_@}", "m/s^2", "acceleration of an element", True),
    "v_b": Letter(V3, r"\mathbf{v}_{b_@}", "m/s", "velocity that the turning frame gives r_b", True),
    "v_xi": Letter(V3, r"\mathbf{v}_{\xi_@}", "m/s", "velocity of the elastic displacement", True),
    "vdot_b": Letter(V3, r"\dot{\mathbf{v}}_{b_@}", "m/s^2", "rate of its components", True),
    "vdot_xi": Letter(V3, r"\dot{\mathbf{v}}_{\xi_@}", "m/s^2", "rate of its components", True),
    "v_ib": Letter(V3, r"\mathbf{v}_{@b_@}", "m/s", "velocity of an element against the origin", True),
    "v_ob": Letter(V3, r"\mathbf{v}_{ob_@}", "m/s", "velocity of an element", True),
    "V_b": Letter(V6, r"\mathbf{V}_{b_@}", "rad/s, m/s", "twist of the reference geometry", True),
    "V_xi": Letter(V6, r"\mathbf{V}_{\xi_@}", "rad/s, m/s", "twist of the deformation", True),
    "Vdot_b": Letter(V6, r"\dot{\mathbf{V}}_{b_@}", "m/s^2", "rate of its components", True),
    "Vdot_xi": Letter(V6, r"\dot{\mathbf{V}}_{\xi_@}", "m/s^2", "rate of its components", True),
    "dV_b": Letter(V6, r"\frac{d\mathbf{V}_{b_@}}{dt}", "m/s^2", "inertial derivative", True),
    "dV_xi": Letter(V6, r"\frac{d\mathbf{V}_{\xi_@}}{dt}", "m/s^2", "inertial derivative", True),
    "q_b": Letter(V6, r"\mathbf{q}_{b_@}", "rad, m", "reference coordinates", True),
    "qdot_b": Letter(V6, r"\dot{\mathbf{q}}_{b_@}", "rad/s, m/s", "their rate", True),
    "q_xi": Letter(V6, r"\mathbf{q}_{\xi_@}", "rad, m", "elastic coordinates", True),
    "qdot_xi": Letter(V6, r"\dot{\mathbf{q}}_{\xi_@}", "rad/s, m/s", "their rate", True),
    "xi": Letter(S, r"\xi_@", "m", "place on the centreline", True),
    "r_xi1": Letter(V3, r"\mathbf{r}_{\xi_@}'", "-", "first derivative along the link", True),
    "r_xi2": Letter(V3, r"\mathbf{r}_{\xi_@}''", "1/m", "second derivative along the link", True),
    "r_xi4": Letter(V3, r"\mathbf{r}_{\xi_@}''''", "1/m^3", "fourth derivative along the link", True),
    "load": Letter(V3, r"\mathbf{f}_@", "m/s^2", "distributed load per mass, zero in the paper", True),
    # the link's ends
    "r_b_a": Letter(V3, r"\mathbf{r}_{b_@}(a_@)", "m", "undeformed base"),
    "r_b_c": Letter(V3, r"\mathbf{r}_{b_@}(c_@)", "m", "undeformed tip"),
    "r_xi_a": Letter(V3, r"\mathbf{r}_{\xi(a_@)}", "m", "displacement of the base"),
    "r_xi_c": Letter(V3, r"\mathbf{r}_{\xi(c_@)}", "m", "displacement of the tip"),
    "V_xi_a": Letter(V6, r"\mathbf{V}_{@\xi(a_@)}", "m/s", "deformation's twist at the base"),
    "V_xi_c": Letter(V6, r"\mathbf{V}_{@\xi(c_@)}", "m/s", "deformation's twist at the tip"),
    "V_b_a": Letter(V6, r"\mathbf{V}_{b_@}(a_@)", "m/s", "reference twist at the base"),
    "V_b_c": Letter(V6, r"\mathbf{V}_{b_@}(c_@)", "m/s", "reference twist at the tip"),
    "Vdot_xi_a": Letter(V6, r"\dot{\mathbf{V}}_{@\xi(a_@)}", "m/s^2", "rate of the deformation's twist at the base"),
    "Vdot_xi_c": Letter(V6, r"\dot{\mathbf{V}}_{@\xi(c_@)}", "m/s^2", "rate of the deformation's twist at the tip"),
    "Vdot_b_a": Letter(V6, r"\dot{\mathbf{V}}_{b_@}(a_@)", "m/s^2", "rate of the reference twist at the base"),
    "Vdot_b_c": Letter(V6, r"\dot{\mathbf{V}}_{b_@}(c_@)", "m/s^2", "rate of the reference twist at the tip"),
    "J_b_a": Letter(M6, r"\mathbf{J}_{b_@}(a_@)", "-, m", "[I, 0; -hat(r_b), I]: twist of the undeformed base"),
    "J_b_c": Letter(M6, r"\mathbf{J}_{b_@}(c_@)", "-, m", "[I, 0; -hat(r_b), I]: twist of the undeformed tip"),
    "V_T": Letter(V6, r"\mathbf{V}_{T_{@}}", "rad/s, m/s", "twist of the tip section"),
    "V_B": Letter(V6, r"\mathbf{V}_{B_{@}}", "rad/s, m/s", "twist of the base section"),
    "dV_T": Letter(V6, r"\frac{d\mathbf{V}_{T_{@}}}{dt}", "rad/s^2, m/s^2", "inertial derivative of the tip twist"),
    "dV_B": Letter(V6, r"\frac{d\mathbf{V}_{B_{@}}}{dt}", "rad/s^2, m/s^2", "inertial derivative of the base twist"),
    "r_xi1_a": Letter(V3, r"\mathbf{r}_{\xi_@}'(a_@)", "-", "slope at the base"),
    "r_xi1_c": Letter(V3, r"\mathbf{r}_{\xi_@}'(c_@)", "-", "slope at the tip"),
    "r_xi2_a": Letter(V3, r"\mathbf{r}_{\xi_@}''(a_@)", "1/m", "curvature at the base"),
    "r_xi2_c": Letter(V3, r"\mathbf{r}_{\xi_@}''(c_@)", "1/m", "curvature at the tip"),
    "r_xi3_a": Letter(V3, r"\mathbf{r}_{\xi_@}'''(a_@)", "1/m^2", "third derivative at the base"),
    "r_xi3_c": Letter(V3, r"\mathbf{r}_{\xi_@}'''(c_@)", "1/m^2", "third derivative at the tip"),
    # inertia, stiffness, loads
    "g": Letter(V3, r"\mathbf{g}", "m/s^2", "gravitational acceleration (here: of free fall), inertial"),
    "m": Letter(S, r"m_@", "kg", "mass of the beam"),
    "l": Letter(S, "l_@", "m", "length of the link"),
    "rhoA": Letter(S, r"\rho_@ A_@", "kg/m", "mass per length"),
    "EA": Letter(S, r"E_@A_@", "N", "axial stiffness"),
    "EIy": Letter(S, r"E_@I_{y_@}", "N*m^2", "bending stiffness for displacement in z"),
    "EIz": Letter(S, r"E_@I_{z_@}", "N*m^2", "bending stiffness for displacement in y"),
    "I_b": Letter(M3, r"\mathbf{I}_{b_@}", "kg*m^2", "inertia of the undeformed beam about the origin"),
    "I_v1": Letter(M3, r"\mathbf{I}_{v1_@}", "N", "axial section stiffness"),
    "I_v2": Letter(M3, r"\mathbf{I}_{v2_@}", "N*m^2", "bending section stiffness"),
    "H": Letter(M3, r"\mathbf{H}", "-", "bending moments from torques"),
    "M_star": Letter(M6, r"\mathbf{M}^*_@", "kg, kg*m, kg*m^2", "inertia of the undeformed link"),
    "D_star": Letter(V6, r"\mathbf{D}^*_@", "N*m, N", "inertia of the deformation"),
    "H_star": Letter(V6, r"\mathbf{H}^*_@", "N*m, N", "gyroscopic wrench and weight"),
    "W_star": Letter(V6, r"\boldsymbol{\mathcal{W}}^*_@", "N*m, N", "external wrench on the link"),
    "tau_B": Letter(V3, r"\boldsymbol{\tau}_{extB_@}", "N*m", "torque at the base"),
    "F_B": Letter(V3, r"\mathbf{F}_{extB_@}", "N", "force at the base"),
    "tau_T": Letter(V3, r"\boldsymbol{\tau}_{extT_@}", "N*m", "torque at the tip"),
    "F_T": Letter(V3, r"\mathbf{F}_{extT_@}", "N", "force at the tip"),
    # the chain
    "W": Letter(V6, r"\boldsymbol{\mathcal{W}}_{@}", "N*m, N", "wrench of link i+1 on link i, in F_i"),
    "W_below": Letter(V6, r"{}^{@}\boldsymbol{\mathcal{W}}_{@-1}", "N*m, N", "W of the link before, in F_i"),
    "P": Letter(M6, r"\mathbf{P}_{@}", "-", "projector on what the joint blocks"),
    "Pdot": Letter(M6, r"\dot{\mathbf{P}}_{@}", "1/s", "rate of the projector"),
    "A": Letter((3, 2), r"{}^{o}\mathbf{A}_@", "-", "axes of the joint, inertial components"),
    "A_plus": Letter((2, 3), r"{}^{o}\mathbf{A}_@^{+}", "-", "their pseudo-inverse"),
    "A_body": Letter((3, 2), r"{}^{@}\mathbf{A}_@", "-", "axes of the joint in F_i"),
    "A_zero": Letter((3, 2), r"{}^{@}\mathbf{A}_@(0)", "-", "axes of the joint in F_i at q = 0"),
    "a_one": Letter(V3, r"\mathbf{a}_{@_1}", "-", "first axis of the joint at q = 0, in F_i"),
    "a_two": Letter(V3, r"\mathbf{a}_{@_2}", "-", "second axis of the joint, in F_i"),
    "R_two": Letter(M3, r"\mathbf{R}_{@_2}", "-", "rotation about the joint's second axis"),
    "H_p": Letter(V6, r"\mathbf{H}_{p@}", "rad/s^2, m/s^2", "bias of the joint's rows"),
    "M_c": Letter((12, 24), r"\mathbf{M}^*_{c@}", "mixed", "columns of the unknowns in the rows of a joint and link"),
    "D_c": Letter((12, 1), r"\mathbf{D}^*_{c@}", "mixed", "what the deformation adds to these rows"),
    "H_c": Letter((12, 1), r"\mathbf{H}^*_{c@}", "mixed", "bias of these rows"),
    "W_c": Letter((12, 1), r"\boldsymbol{\mathcal{W}}^*_{c@}", "N*m, N", "external wrench in these rows"),
    # modal projection
    "phi": Letter((3, MODES), r"\boldsymbol{\phi}_@", "-", "mode shapes", True),
    "phi2": Letter((3, MODES), r"\boldsymbol{\phi}_@''", "1/m^2", "their second derivatives", True),
    "phi1": Letter((3, MODES), r"\boldsymbol{\phi}_@'", "1/m", "their derivatives", True),
    "phi4": Letter((3, MODES), r"\boldsymbol{\phi}_@''''", "1/m^4", "their fourth derivatives", True),
    "phi_a": Letter((3, MODES), r"\boldsymbol{\phi}_@(a_@)", "-", "mode shapes at the base"),
    "phi_c": Letter((3, MODES), r"\boldsymbol{\phi}_@(c_@)", "-", "mode shapes at the tip"),
    "phi1_c": Letter((3, MODES), r"\boldsymbol{\phi}_@'(c_@)", "1/m", "their slopes at the tip"),
    "phi1_a": Letter((3, MODES), r"\boldsymbol{\phi}_@'(a_@)", "1/m", "their slopes at the base"),
    "eta": Letter((MODES, 1), r"\boldsymbol{\eta}_@", "m", "modal coordinates"),
    "etadot": Letter((MODES, 1), r"\dot{\boldsymbol{\eta}}_@", "m/s", "modal rates"),
    "etaddot": Letter((MODES, 1), r"\ddot{\boldsymbol{\eta}}_@", "m/s^2", "modal accelerations"),
    "eta_one": Letter((MODES // 2, 1), r"\boldsymbol{\eta}_{@_1}", "m", "the first mode of each direction"),
    "eta_two": Letter((MODES // 2, 1), r"\boldsymbol{\eta}_{@_2}", "m", "the second mode of each direction"),
    "phi_one": Letter((3, 3), r"\boldsymbol{\phi}_{@_1}", "-", "shapes of the first mode", True),
    "phi_two": Letter((3, 3), r"\boldsymbol{\phi}_{@_2}", "-", "shapes of the second mode", True),
    "phi_x": Letter(S, r"\phi_{x_{@_1}}", "-", "first axial shape", True),
    "phi_y": Letter(S, r"\phi_{y_{@_1}}", "-", "first shape in y", True),
    "phi_z": Letter(S, r"\phi_{z_{@_1}}", "-", "first shape in z", True),
    "eta_x": Letter(S, r"\eta_{x_{@_1}}", "m", "first axial coordinate"),
    "eta_y": Letter(S, r"\eta_{y_{@_1}}", "m", "first coordinate in y"),
    "eta_z": Letter(S, r"\eta_{z_{@_1}}", "m", "first coordinate in z"),
    "M_Dphi": Letter((MODES, 12), r"\mathbf{M}_{D\phi,@}", "kg, kg*m", "modal rows, wrench and acceleration columns"),
    "M_Wphi": Letter((MODES, MODES), r"\mathbf{M}_{W\phi,@}", "kg", "inertia of the modes"),
    "h_phi": Letter((MODES, 1), r"\mathbf{h}_{@\phi}", "N", "bias of the modal rows"),
    "Psi_Z": Letter((12, 1), r"\boldsymbol{\Psi}_{Z_@}", "N*m, N, rad/s^2, m/s^2", "wrench below and rate of Z"),
    "h_phi_one": Letter(V3, r"\mathbf{h}_{@\phi}", "N", "bias of the modal rows of one mode"),
    "etaddot_one": Letter(V3, r"\ddot{\boldsymbol{\eta}}_{@_1}", "m/s^2", "acceleration of the first mode"),
    "load_one": Letter(V3, r"\mathbf{f}_{@_1}", "m^1.5/s^2", "load on the first mode, zero in the paper"),
    "phi1_one": Letter(M3, r"\boldsymbol{\phi}_{@_1}'", "1/m", "first derivatives of the first mode", True),
    "phi2_one": Letter(M3, r"\boldsymbol{\phi}_{@_1}''", "1/m^2", "second derivatives of the first mode", True),
    "phi4_one": Letter(M3, r"\boldsymbol{\phi}_{@_1}''''", "1/m^4", "fourth derivatives of the first mode", True),
    "phi_one_a": Letter(M3, r"\boldsymbol{\phi}_{@_1}(a_@)", "-", "shapes of the first mode at the base"),
    "phi_one_c": Letter(M3, r"\boldsymbol{\phi}_{@_1}(c_@)", "-", "shapes of the first mode at the tip"),
    "phi1_one_a": Letter(M3, r"\boldsymbol{\phi}_{@_1}'(a_@)", "1/m", "slopes of the first mode at the base"),
    "phi1_one_c": Letter(M3, r"\boldsymbol{\phi}_{@_1}'(c_@)", "1/m", "slopes of the first mode at the tip"),
    "J_a": Letter((6, MODES), r"\mathbf{J}_{\eta_@}(a_@)", "1/m, -", "twist that modal rates give the base section"),
    "J_c": Letter((6, MODES), r"\mathbf{J}_{\eta_@}(c_@)", "1/m, -", "twist that modal rates give the tip section"),
    "J_a_one": Letter((6, 3), r"\mathbf{J}_{\eta_{@_1}}(a_@)", "1/m, -", "twist of the base by the first mode"),
    "J_a_two": Letter((6, 3), r"\mathbf{J}_{\eta_{@_2}}(a_@)", "1/m, -", "twist of the base by the second mode"),
    "f_phi": Letter((MODES, 1), r"\mathbf{f}_{@\phi}", "N", "force of the external loads on the modes"),
    "T": Letter(S, "T_@", "J", "kinetic energy of the link"),
    "M_D_link": Letter((6, MODES), r"\boldsymbol{M}_{D,@}", "kg, kg*m", "columns of the modes in the link's rows"),
    "M_Dphi_diff": Letter((MODES, 6), r"\mathbf{M}_{D\phi,@}^{(diff)}", "kg, kg*m", "modal rows, columns of Zdot"),
    "M_dyn_diff": Letter(M6, r"\mathbf{M}_{dyn,@}^{(diff)}", "kg, kg*m, kg*m^2", "inertia in the rate of Z"),
    # the discretised system of two links, index "all"
    "Psi": Letter((24, 1), r"\boldsymbol{\Psi}", "mixed", "wrenches and rates of the twists, by turns"),
    "Psi_Z_s": Letter((24, 1), r"\boldsymbol{\Psi}_Z", "mixed", "wrenches and rates of Z, by turns"),
    "eta_s": Letter((2 * MODES, 1), r"\ddot{\underline{\boldsymbol{\eta}}}", "m/s^2", "modal accelerations"),
    "M_s": Letter((24, 24), r"\mathbf{M}_s", "mixed", "inertia of the undeformed links, and joints"),
    "D_s": Letter((24, 1), r"\mathbf{D}_s(\dot{\mathbf{V}}_\xi)", "mixed", "inertia of the deformation"),
    "h_s": Letter((24, 1), r"\mathbf{h}_s", "mixed", "gyroscopic wrenches and weight"),
    "W_s": Letter((24, 1), r"\boldsymbol{\mathcal{W}}_s", "N*m, N", "external wrenches"),
    "T_gamma_s": Letter((24, 24), r"\mathbf{T}_\gamma", "m", "levers of the origins"),
    "Gamma_star": Letter((24, 1), r"\boldsymbol{\Gamma}^*", "mixed", "biases of the rates of gamma"),
    "h_Ms": Letter((24, 1), r"\mathbf{h}_{M_s}", "mixed", "bias of the change from V to Z"),
    "M_D": Letter((24, 2 * MODES), r"\boldsymbol{M}_D", "mixed", "columns of the modal accelerations"),
    "M_DPsi": Letter((24, 24), r"\boldsymbol{M}_{D\Psi}", "mixed", "columns that the deformation adds"),
    "h_MD": Letter((24, 1), r"\mathbf{h}_{M_D}", "mixed", "bias of the deformation's inertia"),
    "M_dyn": Letter((24, 24), r"\mathbf{M}_{dyn}", "mixed", "columns of the wrenches and rates of Z"),
    "h_dyn": Letter((24, 1), r"\mathbf{h}_{dyn}", "mixed", "bias of the rows of joints and links"),
    "M_Dphi_s": Letter((2 * MODES, 24), r"\mathbf{M}_{D\phi}", "mixed", "modal rows, wrenches and rates of Z"),
    "M_Wphi_s": Letter((2 * MODES,) * 2, r"\mathbf{M}_{W\phi}", "kg", "inertia of the modes"),
    "h_phi_s": Letter((2 * MODES, 1), r"\mathbf{h}_\phi", "N", "bias of the modal rows"),
    "f_phi_s": Letter((2 * MODES, 1), r"\mathbf{f}_\phi", "N", "force of the external loads on the modes"),
    "M_sys": Letter((36, 36), r"\mathbf{M}_{sys}", "mixed", "matrix of the discretised system"),
    "q_sys": Letter((36, 1), r"\mathbf{q}_{sys}", "mixed", "unknowns of the discretised system"),
    "H_sys": Letter((36, 1), r"\mathbf{H}_{sys}", "mixed", "bias of the discretised system"),
    "W_sys": Letter((36, 1), r"\boldsymbol{\mathcal{W}}_{sys}", "mixed", "external loads of the discretised system"),
    # the Cauchy form of two links, index "all"
    "x_c": Letter((48, 1), r"\mathbf{x}_c", "mixed", "state: coordinates, then velocities"),
    "xdot_c": Letter((48, 1), r"\dot{\mathbf{x}}_c", "mixed", "rate of the state"),
    "A_c": Letter((48, 48), r"\mathbf{A}_c(\mathbf{x}_c)", "mixed", "from velocities to rates of coordinates"),
    "g_c": Letter((48, 1), r"\mathbf{g}_c", "mixed", "accelerations"),
    "J_q": Letter((12, 12), r"\mathbf{J}(\underline{\mathbf{q}})", "-", "the J(q_i) of (jacobian), block by block"),
    "Zdot_star": Letter((12, 1), r"\dot{\underline{\mathbf{Z}}}^*", "rad/s^2, m/s^2", "rates of Z of the solution"),
    "etaddot_star": Letter((12, 1), r"\ddot{\underline{\boldsymbol{\eta}}}^*", "m/s^2", "modal accelerations"),
}


def symbol(quantity: str, index: str = "i") -> Symbol:
    """The symbol of a quantity of a link."""
    q = QUANTITIES[quantity]
    return Symbol(f"{quantity}:{index}", q.shape, indexed(q.display, index))


def indexed(display: str, index: str) -> str:
    """LaTeX with the index written in; one of several characters in braces or parentheses, as the paper does."""
    if len(index) > 1:
        display = re.sub(r"(?<=_)@", f"{{{index}}}", display)
        display = re.sub(r"(?<=[A-Za-z])@|@(?=[A-Za-z\\])", f"({index})", display)
    return display.replace("@", index)


def quantity(s: Symbol) -> Letter:
    """What the paper means by a symbol, with its link's index written in."""
    name, _, _index = s.name.partition(":")
    return replace(QUANTITIES[name], display=s.display, meaning=QUANTITIES[name].meaning)


class LinkLetters:
    """The quantities of one link as attributes: ``Link("i").omega``."""

    def __init__(self, index: str = "i"):
        self.index = index

    def __getattr__(self, name: str) -> Symbol:
        if name not in QUANTITIES:
            raise AttributeError(name)
        return symbol(name, self.index)

    def integral(self, integrand: Expression, weight: Symbol | None = None) -> Integral:
        """``weight ∫ integrand dξ`` over the link."""
        return Integral(integrand, weight, None, self.index)
