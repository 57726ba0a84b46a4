/* ella_links.c: what each class of links does in each phase, and the phases in their order.
 *
 * A chain of n links has n + 1 nodes: node 0 is the base, node i + 1 the tip of link i. A phase of link i
 * reads and writes the link's own store, its two nodes, and the arrays of the call.
 */
#include "ella_links.h"

static const int Q_OFFSET[ELLA_NLINKS] = { 0, 2 };
static const int ETA_OFFSET[ELLA_NLINKS] = { 0, 3 };

/* Where the entries of M_sys that a link computes stand among the structural nonzeros. */
static const int M_PLACE[ELLA_NNZ] = {
    0, 3, 1, 4, 6, 11, 28, 12, 29, 60, 76, 92, 19, 36, 51, 67, 83, 99, 20, 37,
    52, 68, 84, 100, 21, 38, 53, 69, 85, 101, 22, 39, 54, 70, 86, 102, 23, 40, 55, 71,
    87, 103, 24, 41, 56, 72, 88, 104, 234, 249, 264, 235, 250, 265, 236, 251, 266, 237, 252, 267,
    238, 253, 268, 239, 254, 269, 2, 5, 7, 8, 9, 10, 13, 30, 45, 61, 77, 93, 14, 31,
    46, 62, 78, 94, 15, 32, 47, 63, 79, 95, 16, 33, 48, 64, 80, 96, 17, 34, 49, 65,
    81, 97, 18, 35, 50, 66, 82, 98, 228, 243, 258, 229, 244, 259, 230, 245, 260, 231, 246, 261,
    232, 247, 262, 233, 248, 263, 108, 118, 128, 139, 149, 159, 109, 119, 129, 140, 150, 160, 110, 120,
    130, 141, 151, 161, 111, 121, 131, 142, 152, 162, 112, 122, 132, 143, 153, 163, 113, 123, 133, 144,
    154, 164, 25, 42, 57, 73, 89, 105, 26, 43, 58, 74, 90, 106, 27, 44, 59, 75, 91, 107,
    240, 255, 270, 241, 256, 271, 242, 257, 272, 115, 125, 136, 146, 156, 166, 116, 126, 137, 147, 157,
    167, 117, 127, 138, 148, 158, 168, 134, 169, 179, 198, 208, 218, 114, 124, 135, 145, 155, 165, 170,
    180, 189, 199, 209, 219, 171, 181, 190, 200, 210, 220, 172, 182, 191, 201, 211, 221, 173, 183, 192,
    202, 212, 222, 174, 184, 193, 203, 213, 223, 175, 185, 194, 204, 214, 224, 273, 282, 291, 274, 283,
    292, 275, 284, 293, 276, 285, 294, 277, 286, 295, 278, 287, 296, 176, 186, 195, 205, 215, 225, 177,
    187, 196, 206, 216, 226, 178, 188, 197, 207, 217, 227, 279, 288, 297, 280, 289, 298, 281, 290, 299,
};
static const int M_OFFSET[ELLA_NLINKS] = { 0, 207 };

/* dae kinematics, links like upper_arm: 486 operations */
static ella_status dae_kinematics_upper_arm(const ella_link_constants *c, ella_link_store *link, const ella_node *base, ella_node *tip,
    const ella_real twist[6], const ella_real q[2], const ella_real eta[3], const ella_real etadot[3],
    ella_real qdot[2])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_zz = ella_cos(q[0]);
    const ella_real R_rel_yy = ella_cos(q[1]);
    const ella_real R_rel_xx = R_rel_zz * R_rel_yy;
    const ella_real R_rel_yx = ella_sin(q[1]);
    const ella_real minus_R_rel_xy = R_rel_yx * R_rel_zz;
    const ella_real R_rel_xz = ella_sin(q[0]);
    const ella_real minus_R_rel_zx = R_rel_xz * R_rel_yy;
    const ella_real R_rel_zy = R_rel_xz * R_rel_yx;

    const ella_real t1 = R_rel_yx * R_rel_yx + R_rel_yy * R_rel_yy;
    if (!(t1 - ELLA_REAL_EPSILON * 64 > 0)) { return ELLA_SINGULAR; }
    const ella_real t2 = 1 / t1;
    const ella_real omega_R_x = R_rel_xx * base->omega[0] + R_rel_yx * base->omega[1]
        - minus_R_rel_zx * base->omega[2];
    const ella_real omega_R_y = R_rel_yy * base->omega[1] - minus_R_rel_xy * base->omega[0]
        + R_rel_zy * base->omega[2];
    const ella_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_zz * base->omega[2];
    const ella_real qdot_2 = twist[2] - omega_R_z;
    const ella_real qdot_1 = R_rel_yx * t2 * (twist[0] - omega_R_x) + R_rel_yy * t2 * (twist[1] - omega_R_y);

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx * qdot_1;
    const ella_real omega_J_y = R_rel_yy * qdot_1;

    /* v_R: velocity of the joint point */
    const ella_real v_R_x = R_rel_xx * base->v[0] + R_rel_yx * base->v[1] - minus_R_rel_zx * base->v[2];
    const ella_real v_R_y = R_rel_yy * base->v[1] - minus_R_rel_xy * base->v[0] + R_rel_zy * base->v[2];
    const ella_real v_R_z = R_rel_xz * base->v[0] + R_rel_zz * base->v[2];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real t3 = qdot_1 * qdot_2;
    const ella_real beta_omega_x = omega_R_y * qdot_2 + t3 * R_rel_yy - omega_J_y * omega_R_z;
    const ella_real beta_omega_y = omega_J_x * omega_R_z - omega_R_x * qdot_2 - t3 * R_rel_yx;
    const ella_real beta_omega_z = omega_J_y * omega_R_x - omega_J_x * omega_R_y;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const ella_real beta_v_x = qdot_2 * v_R_y - omega_J_y * v_R_z;
    const ella_real beta_v_y = omega_J_x * v_R_z - qdot_2 * v_R_x;
    const ella_real beta_v_z = omega_J_y * v_R_x - omega_J_x * v_R_y;

    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_z3;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_x = etadot[0] * c->sigma_x1;
    const ella_real Sdot_y = etadot[1] * c->sigma_y2;
    const ella_real Sdot_z = etadot[2] * c->sigma_z3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->M_Wphi_11 * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_x3 = c->chi_3 + c->Gamma_xz_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->M_Wphi_22 * eta[1];
    const ella_real L_y3 = eta[1] * c->mu;
    const ella_real L_z1 = c->Gamma_xz_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;
    const ella_real L_z3 = c->M_Wphi_33 * eta[2];

    /* Ldot: rate of L */
    const ella_real Ldot_x2 = c->Gamma_xy_11 * etadot[0];
    const ella_real Ldot_x3 = c->Gamma_xz_11 * etadot[0];
    const ella_real Ldot_y1 = c->Gamma_xy_11 * etadot[1];
    const ella_real Ldot_y3 = etadot[1] * c->mu;
    const ella_real Ldot_z1 = c->Gamma_xz_11 * etadot[2];
    const ella_real Ldot_z2 = etadot[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_3 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z3 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const ella_real a_0_x = twist[1] * twist[5] - twist[2] * twist[4];
    const ella_real a_0_y = twist[2] * twist[3] - twist[0] * twist[5];
    const ella_real a_0_z = twist[0] * twist[4] - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const ella_real t4 = twist[1] * twist[1];
    const ella_real t5 = twist[2] * twist[2];
    const ella_real minus_Omega_xx = t4 + t5;
    const ella_real Omega_xy = twist[0] * twist[1];
    const ella_real Omega_xz = twist[0] * twist[2];
    const ella_real t6 = twist[0] * twist[0];
    const ella_real minus_Omega_yy = t6 + t5;
    const ella_real Omega_yz = twist[1] * twist[2];
    const ella_real minus_Omega_zz = t6 + t4;

    /* B: moment of the elastic velocity */
    const ella_real B_xx = L_x1 * etadot[0];
    const ella_real B_xy = L_y1 * etadot[0];
    const ella_real B_xz = L_z1 * etadot[0];
    const ella_real B_yx = L_x2 * etadot[1];
    const ella_real B_yy = L_y2 * etadot[1];
    const ella_real B_yz = L_z2 * etadot[1];
    const ella_real B_zx = L_x3 * etadot[2];
    const ella_real B_zy = L_y3 * etadot[2];
    const ella_real B_zz = L_z3 * etadot[2];

    /* h_c: half of the Coriolis wrench */
    const ella_real h_c_1 = B_yy * twist[0] + B_zz * twist[0] - B_xy * twist[1] - B_xz * twist[2];
    const ella_real h_c_2 = B_xx * twist[1] + B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const ella_real h_c_3 = B_xx * twist[2] + B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const ella_real h_c_4 = Sdot_z * twist[1] - Sdot_y * twist[2];
    const ella_real h_c_5 = Sdot_x * twist[2] - Sdot_z * twist[0];
    const ella_real h_c_6 = Sdot_y * twist[0] - Sdot_x * twist[1];

    /* H_star: gyroscopic wrench and weight (29) */
    const ella_real t7 = h_c_1 + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const ella_real H_star_1 = t7 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const ella_real t8 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const ella_real t9 = c->I_s * twist[0];
    const ella_real H_star_2 = t8 + t9 * twist[2] - J_xx * Omega_xz - J_xy * Omega_yz - S_x * a_0_z;
    const ella_real t10 = h_c_3 + J_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + S_x * a_0_y;
    const ella_real H_star_3 = t10 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t9 * twist[1];
    const ella_real H_star_4 = h_c_4 - minus_Omega_xx * S_x + Omega_xy * S_y + Omega_xz * S_z + a_0_x * c->mu;
    const ella_real H_star_5 = h_c_5 + Omega_xy * S_x - minus_Omega_yy * S_y + Omega_yz * S_z + a_0_y * c->mu;
    const ella_real H_star_6 = h_c_6 + Omega_xz * S_x + Omega_yz * S_y - minus_Omega_zz * S_z + a_0_z * c->mu;

    /* h_V: bias of the twist rows */
    const ella_real h_V_1 = H_star_1 + h_c_1;
    const ella_real h_V_2 = H_star_2 + h_c_2;
    const ella_real h_V_3 = H_star_3 + h_c_3;
    const ella_real h_V_4 = H_star_4 + h_c_4;
    const ella_real h_V_5 = H_star_5 + h_c_5;
    const ella_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const ella_real t11 = L_y1 * Omega_xy - L_x1 * minus_Omega_xx + L_z1 * Omega_xz + a_0_x * c->sigma_x1
        + Ldot_z1 * 2 * twist[1];
    const ella_real h_eta_1 = t11 - Ldot_y1 * 2 * twist[2];
    const ella_real t12 = L_x2 * Omega_xy - L_y2 * minus_Omega_yy + L_z2 * Omega_yz + a_0_y * c->sigma_y2
        + Ldot_x2 * 2 * twist[2];
    const ella_real h_eta_2 = t12 - Ldot_z2 * 2 * twist[0];
    const ella_real t13 = L_x3 * Omega_xz + L_y3 * Omega_yz - L_z3 * minus_Omega_zz + a_0_z * c->sigma_z3
        + Ldot_y3 * 2 * twist[0];
    const ella_real h_eta_3 = t13 - Ldot_x3 * 2 * twist[1];

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    const ella_real r_T_y = eta[1] * 2;
    const ella_real r_T_z = eta[2] * 2;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_y = c->Psi_c_y3 * eta[2];
    const ella_real theta_z = c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const ella_real minus_theta_hat2_33 = theta_y * theta_y;
    const ella_real minus_theta_hat2_22 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const ella_real t14 = ella_c5(x);
    const ella_real c3 = REAL(0.16666666666666666) - x * t14;
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real t15 = ella_c4(x);
    const ella_real c2 = REAL(0.5) - x * t15;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real minus_J_l_xy = c2 * theta_z;
    const ella_real J_l_xz = c2 * theta_y;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const ella_real J_l_yz = c3 * theta_hat2_23;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    const ella_real minus_R_T_xy = c1 * theta_z;
    const ella_real R_T_xz = c1 * theta_y;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_x = etadot[0] * REAL(1.4142135623730951);
    const ella_real udot_T_y = etadot[1] * 2;
    const ella_real udot_T_z = etadot[2] * 2;

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_y = c->Psi_c_y3 * etadot[2];
    const ella_real thetadot_z = c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t16 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t16;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t16;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t16;

    /* xdot: rate of the squared angle */
    const ella_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const ella_real c2dot = xdot * (t15 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const ella_real c3dot = xdot * (t14 * REAL(1.5) - t15 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_x = c2dot * t16;
    const ella_real alpha_s_y = c3 * thetadot_z * t16 + c3dot * theta_z * t16;
    const ella_real minus_alpha_s_z = c3 * thetadot_y * t16 + c3dot * theta_y * t16;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t17 = omega_s_x + twist[0];
    const ella_real t18 = omega_s_y + twist[1];
    const ella_real t19 = omega_s_z + twist[2];
    const ella_real omega_T_x = R_T_xx * t17 + minus_R_T_xy * t18 - R_T_xz * t19;
    const ella_real omega_T_y = R_T_yy * t18 - minus_R_T_xy * t17 + R_T_yz * t19;
    const ella_real omega_T_z = R_T_xz * t17 + R_T_yz * t18 + R_T_zz * t19;

    /* v_T: velocity of the tip point (46) */
    const ella_real t20 = udot_T_x + twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const ella_real t21 = udot_T_y + twist[4] + twist[2] * r_T_x - twist[0] * r_T_z;
    const ella_real t22 = udot_T_z + twist[5] + twist[0] * r_T_y - twist[1] * r_T_x;
    const ella_real v_T_x = R_T_xx * t20 + minus_R_T_xy * t21 - R_T_xz * t22;
    const ella_real v_T_y = R_T_yy * t21 - minus_R_T_xy * t20 + R_T_yz * t22;
    const ella_real v_T_z = R_T_xz * t20 + R_T_yz * t21 + R_T_zz * t22;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const ella_real t23 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const ella_real t24 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const ella_real t25 = omega_s_y * twist[0] - minus_alpha_s_z - omega_s_x * twist[1];
    const ella_real b_omega_x = R_T_xx * t23 + minus_R_T_xy * t24 - R_T_xz * t25;
    const ella_real b_omega_y = R_T_yy * t24 - minus_R_T_xy * t23 + R_T_yz * t25;
    const ella_real b_omega_z = R_T_xz * t23 + R_T_yz * t24 + R_T_zz * t25;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const ella_real t26 = omega_s_z * t21 + twist[1] * udot_T_z - omega_s_y * t22 - twist[2] * udot_T_y;
    const ella_real t27 = omega_s_x * t22 + twist[2] * udot_T_x - omega_s_z * t20 - twist[0] * udot_T_z;
    const ella_real t28 = omega_s_y * t20 + twist[0] * udot_T_y - omega_s_x * t21 - twist[1] * udot_T_x;
    const ella_real b_v_x = R_T_xx * t26 + minus_R_T_xy * t27 - R_T_xz * t28;
    const ella_real b_v_y = R_T_yy * t27 - minus_R_T_xy * t26 + R_T_yz * t28;
    const ella_real b_v_z = R_T_xz * t26 + R_T_yz * t27 + R_T_zz * t28;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const ella_real a_T_x = omega_T_y * v_T_z - omega_T_z * v_T_y;
    const ella_real a_T_y = omega_T_z * v_T_x - omega_T_x * v_T_z;
    const ella_real a_T_z = omega_T_x * v_T_y - omega_T_y * v_T_x;

    /* h_T_F: force that the bodies' velocities and weight need */
    const ella_real h_T_F_x = a_T_x * c->body0_mass;
    const ella_real h_T_F_y = a_T_y * c->body0_mass;
    const ella_real h_T_F_z = a_T_z * c->body0_mass;

    /* outputs */
    qdot[0] = qdot_1;
    qdot[1] = qdot_2;
    link->R_rel[0] = R_rel_xx;
    link->R_rel[1] = minus_R_rel_xy;
    link->R_rel[2] = R_rel_xz;
    link->R_rel[3] = R_rel_yx;
    link->R_rel[4] = R_rel_yy;
    link->R_rel[5] = minus_R_rel_zx;
    link->R_rel[6] = R_rel_zy;
    link->R_rel[7] = R_rel_zz;
    link->A[0] = R_rel_yx;
    link->A[1] = R_rel_yy;
    link->beta[0] = beta_omega_x;
    link->beta[1] = beta_omega_y;
    link->beta[2] = beta_omega_z;
    link->beta[3] = beta_v_x;
    link->beta[4] = beta_v_y;
    link->beta[5] = beta_v_z;
    link->M_V[0] = I_xx;
    link->M_V[1] = J_xy;
    link->M_V[2] = J_xz;
    link->M_V[3] = S_z;
    link->M_V[4] = S_y;
    link->M_V[5] = I_yy;
    link->M_V[6] = J_yz;
    link->M_V[7] = S_x;
    link->M_V[8] = I_zz;
    link->M_D[0] = L_z2;
    link->M_D[1] = L_y3;
    link->M_D[2] = L_z1;
    link->M_D[3] = L_x3;
    link->M_D[4] = L_y1;
    link->M_D[5] = L_x2;
    link->h_V[0] = h_V_1;
    link->h_V[1] = h_V_2;
    link->h_V[2] = h_V_3;
    link->h_V[3] = h_V_4;
    link->h_V[4] = h_V_5;
    link->h_V[5] = h_V_6;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
    link->h_eta[2] = h_eta_3;
    link->r_T[0] = r_T_x;
    link->r_T[1] = r_T_y;
    link->r_T[2] = r_T_z;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = minus_R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yy;
    link->R_T[4] = R_T_yz;
    link->R_T[5] = R_T_zz;
    link->G[0] = c1;
    link->G[1] = minus_J_l_xy;
    link->G[2] = J_l_xz;
    link->G[3] = J_l_yy;
    link->G[4] = J_l_yz;
    link->G[5] = J_l_zz;
    link->b_T[0] = b_omega_x;
    link->b_T[1] = b_omega_y;
    link->b_T[2] = b_omega_z;
    link->b_T[3] = b_v_x;
    link->b_T[4] = b_v_y;
    link->b_T[5] = b_v_z;
    tip->omega[0] = omega_T_x;
    tip->omega[1] = omega_T_y;
    tip->omega[2] = omega_T_z;
    tip->v[0] = v_T_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    link->h_T[0] = h_T_F_x;
    link->h_T[1] = h_T_F_y;
    link->h_T[2] = h_T_F_z;
    return ELLA_OK;
}

/* dae kinematics, links like forearm: 432 operations */
static ella_status dae_kinematics_forearm(const ella_link_constants *c, ella_link_store *link, const ella_node *base, ella_node *tip,
    const ella_real twist[6], const ella_real q[1], const ella_real eta[3], const ella_real etadot[3],
    ella_real qdot[1])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_xx = ella_cos(q[0]);
    const ella_real minus_R_rel_xy = ella_sin(q[0]);

    const ella_real omega_R_x = R_rel_xx * base->omega[0] + minus_R_rel_xy * base->omega[1];
    const ella_real omega_R_y = R_rel_xx * base->omega[1] - minus_R_rel_xy * base->omega[0];
    const ella_real qdot_1 = twist[2] - base->omega[2];

    /* v_R: velocity of the joint point */
    const ella_real v_R_x = R_rel_xx * base->v[0] + minus_R_rel_xy * base->v[1];
    const ella_real v_R_y = R_rel_xx * base->v[1] - minus_R_rel_xy * base->v[0];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real beta_omega_x = omega_R_y * qdot_1;
    const ella_real minus_beta_omega_y = omega_R_x * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const ella_real beta_v_x = qdot_1 * v_R_y;
    const ella_real minus_beta_v_y = qdot_1 * v_R_x;

    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_z3;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_x = etadot[0] * c->sigma_x1;
    const ella_real Sdot_y = etadot[1] * c->sigma_y2;
    const ella_real Sdot_z = etadot[2] * c->sigma_z3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->M_Wphi_11 * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_x3 = c->chi_3 + c->Gamma_xz_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->M_Wphi_22 * eta[1];
    const ella_real L_y3 = eta[1] * c->mu;
    const ella_real L_z1 = c->Gamma_xz_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;
    const ella_real L_z3 = c->M_Wphi_33 * eta[2];

    /* Ldot: rate of L */
    const ella_real Ldot_x2 = c->Gamma_xy_11 * etadot[0];
    const ella_real Ldot_x3 = c->Gamma_xz_11 * etadot[0];
    const ella_real Ldot_y1 = c->Gamma_xy_11 * etadot[1];
    const ella_real Ldot_y3 = etadot[1] * c->mu;
    const ella_real Ldot_z1 = c->Gamma_xz_11 * etadot[2];
    const ella_real Ldot_z2 = etadot[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_3 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z3 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const ella_real a_0_x = twist[1] * twist[5] - twist[2] * twist[4];
    const ella_real a_0_y = twist[2] * twist[3] - twist[0] * twist[5];
    const ella_real a_0_z = twist[0] * twist[4] - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const ella_real t1 = twist[1] * twist[1];
    const ella_real t2 = twist[2] * twist[2];
    const ella_real minus_Omega_xx = t1 + t2;
    const ella_real Omega_xy = twist[0] * twist[1];
    const ella_real Omega_xz = twist[0] * twist[2];
    const ella_real t3 = twist[0] * twist[0];
    const ella_real minus_Omega_yy = t3 + t2;
    const ella_real Omega_yz = twist[1] * twist[2];
    const ella_real minus_Omega_zz = t3 + t1;

    /* B: moment of the elastic velocity */
    const ella_real B_xx = L_x1 * etadot[0];
    const ella_real B_xy = L_y1 * etadot[0];
    const ella_real B_xz = L_z1 * etadot[0];
    const ella_real B_yx = L_x2 * etadot[1];
    const ella_real B_yy = L_y2 * etadot[1];
    const ella_real B_yz = L_z2 * etadot[1];
    const ella_real B_zx = L_x3 * etadot[2];
    const ella_real B_zy = L_y3 * etadot[2];
    const ella_real B_zz = L_z3 * etadot[2];

    /* h_c: half of the Coriolis wrench */
    const ella_real h_c_1 = B_yy * twist[0] + B_zz * twist[0] - B_xy * twist[1] - B_xz * twist[2];
    const ella_real h_c_2 = B_xx * twist[1] + B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const ella_real h_c_3 = B_xx * twist[2] + B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const ella_real h_c_4 = Sdot_z * twist[1] - Sdot_y * twist[2];
    const ella_real h_c_5 = Sdot_x * twist[2] - Sdot_z * twist[0];
    const ella_real h_c_6 = Sdot_y * twist[0] - Sdot_x * twist[1];

    /* H_star: gyroscopic wrench and weight (29) */
    const ella_real t4 = h_c_1 + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const ella_real H_star_1 = t4 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const ella_real t5 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const ella_real t6 = c->I_s * twist[0];
    const ella_real H_star_2 = t5 + t6 * twist[2] - J_xx * Omega_xz - J_xy * Omega_yz - S_x * a_0_z;
    const ella_real t7 = h_c_3 + J_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + S_x * a_0_y;
    const ella_real H_star_3 = t7 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t6 * twist[1];
    const ella_real H_star_4 = h_c_4 - minus_Omega_xx * S_x + Omega_xy * S_y + Omega_xz * S_z + a_0_x * c->mu;
    const ella_real H_star_5 = h_c_5 + Omega_xy * S_x - minus_Omega_yy * S_y + Omega_yz * S_z + a_0_y * c->mu;
    const ella_real H_star_6 = h_c_6 + Omega_xz * S_x + Omega_yz * S_y - minus_Omega_zz * S_z + a_0_z * c->mu;

    /* h_V: bias of the twist rows */
    const ella_real h_V_1 = H_star_1 + h_c_1;
    const ella_real h_V_2 = H_star_2 + h_c_2;
    const ella_real h_V_3 = H_star_3 + h_c_3;
    const ella_real h_V_4 = H_star_4 + h_c_4;
    const ella_real h_V_5 = H_star_5 + h_c_5;
    const ella_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const ella_real t8 = L_y1 * Omega_xy - L_x1 * minus_Omega_xx + L_z1 * Omega_xz + a_0_x * c->sigma_x1
        + Ldot_z1 * 2 * twist[1];
    const ella_real h_eta_1 = t8 - Ldot_y1 * 2 * twist[2];
    const ella_real t9 = L_x2 * Omega_xy - L_y2 * minus_Omega_yy + L_z2 * Omega_yz + a_0_y * c->sigma_y2
        + Ldot_x2 * 2 * twist[2];
    const ella_real h_eta_2 = t9 - Ldot_z2 * 2 * twist[0];
    const ella_real t10 = L_x3 * Omega_xz + L_y3 * Omega_yz - L_z3 * minus_Omega_zz + a_0_z * c->sigma_z3
        + Ldot_y3 * 2 * twist[0];
    const ella_real h_eta_3 = t10 - Ldot_x3 * 2 * twist[1];

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    const ella_real r_T_y = eta[1] * 2;
    const ella_real r_T_z = eta[2] * 2;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_y = c->Psi_c_y3 * eta[2];
    const ella_real theta_z = c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const ella_real minus_theta_hat2_33 = theta_y * theta_y;
    const ella_real minus_theta_hat2_22 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const ella_real t11 = ella_c5(x);
    const ella_real c3 = REAL(0.16666666666666666) - x * t11;
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real t12 = ella_c4(x);
    const ella_real c2 = REAL(0.5) - x * t12;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real minus_J_l_xy = c2 * theta_z;
    const ella_real J_l_xz = c2 * theta_y;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const ella_real J_l_yz = c3 * theta_hat2_23;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    const ella_real minus_R_T_xy = c1 * theta_z;
    const ella_real R_T_xz = c1 * theta_y;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_x = etadot[0] * REAL(1.4142135623730951);
    const ella_real udot_T_y = etadot[1] * 2;
    const ella_real udot_T_z = etadot[2] * 2;

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_y = c->Psi_c_y3 * etadot[2];
    const ella_real thetadot_z = c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t13 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t13;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t13;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t13;

    /* xdot: rate of the squared angle */
    const ella_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const ella_real c2dot = xdot * (t12 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const ella_real c3dot = xdot * (t11 * REAL(1.5) - t12 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_x = c2dot * t13;
    const ella_real alpha_s_y = c3 * thetadot_z * t13 + c3dot * theta_z * t13;
    const ella_real minus_alpha_s_z = c3 * thetadot_y * t13 + c3dot * theta_y * t13;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t14 = omega_s_x + twist[0];
    const ella_real t15 = omega_s_y + twist[1];
    const ella_real t16 = omega_s_z + twist[2];
    const ella_real omega_T_x = R_T_xx * t14 + minus_R_T_xy * t15 - R_T_xz * t16;
    const ella_real omega_T_y = R_T_yy * t15 - minus_R_T_xy * t14 + R_T_yz * t16;
    const ella_real omega_T_z = R_T_xz * t14 + R_T_yz * t15 + R_T_zz * t16;

    /* v_T: velocity of the tip point (46) */
    const ella_real t17 = udot_T_x + twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const ella_real t18 = udot_T_y + twist[4] + twist[2] * r_T_x - twist[0] * r_T_z;
    const ella_real t19 = udot_T_z + twist[5] + twist[0] * r_T_y - twist[1] * r_T_x;
    const ella_real v_T_x = R_T_xx * t17 + minus_R_T_xy * t18 - R_T_xz * t19;
    const ella_real v_T_y = R_T_yy * t18 - minus_R_T_xy * t17 + R_T_yz * t19;
    const ella_real v_T_z = R_T_xz * t17 + R_T_yz * t18 + R_T_zz * t19;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const ella_real t20 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const ella_real t21 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const ella_real t22 = omega_s_y * twist[0] - minus_alpha_s_z - omega_s_x * twist[1];
    const ella_real b_omega_x = R_T_xx * t20 + minus_R_T_xy * t21 - R_T_xz * t22;
    const ella_real b_omega_y = R_T_yy * t21 - minus_R_T_xy * t20 + R_T_yz * t22;
    const ella_real b_omega_z = R_T_xz * t20 + R_T_yz * t21 + R_T_zz * t22;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const ella_real t23 = omega_s_z * t18 + twist[1] * udot_T_z - omega_s_y * t19 - twist[2] * udot_T_y;
    const ella_real t24 = omega_s_x * t19 + twist[2] * udot_T_x - omega_s_z * t17 - twist[0] * udot_T_z;
    const ella_real t25 = omega_s_y * t17 + twist[0] * udot_T_y - omega_s_x * t18 - twist[1] * udot_T_x;
    const ella_real b_v_x = R_T_xx * t23 + minus_R_T_xy * t24 - R_T_xz * t25;
    const ella_real b_v_y = R_T_yy * t24 - minus_R_T_xy * t23 + R_T_yz * t25;
    const ella_real b_v_z = R_T_xz * t23 + R_T_yz * t24 + R_T_zz * t25;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const ella_real a_T_x = omega_T_y * v_T_z - omega_T_z * v_T_y;
    const ella_real a_T_y = omega_T_z * v_T_x - omega_T_x * v_T_z;
    const ella_real a_T_z = omega_T_x * v_T_y - omega_T_y * v_T_x;

    /* h_T_F: force that the bodies' velocities and weight need */
    const ella_real h_T_F_x = a_T_x * c->body0_mass;
    const ella_real h_T_F_y = a_T_y * c->body0_mass;
    const ella_real h_T_F_z = a_T_z * c->body0_mass;

    /* outputs */
    qdot[0] = qdot_1;
    link->R_rel[0] = R_rel_xx;
    link->R_rel[1] = minus_R_rel_xy;
    link->beta[0] = beta_omega_x;
    link->beta[1] = minus_beta_omega_y;
    link->beta[2] = beta_v_x;
    link->beta[3] = minus_beta_v_y;
    link->M_V[0] = I_xx;
    link->M_V[1] = J_xy;
    link->M_V[2] = J_xz;
    link->M_V[3] = S_z;
    link->M_V[4] = S_y;
    link->M_V[5] = I_yy;
    link->M_V[6] = J_yz;
    link->M_V[7] = S_x;
    link->M_V[8] = I_zz;
    link->M_D[0] = L_z2;
    link->M_D[1] = L_y3;
    link->M_D[2] = L_z1;
    link->M_D[3] = L_x3;
    link->M_D[4] = L_y1;
    link->M_D[5] = L_x2;
    link->h_V[0] = h_V_1;
    link->h_V[1] = h_V_2;
    link->h_V[2] = h_V_3;
    link->h_V[3] = h_V_4;
    link->h_V[4] = h_V_5;
    link->h_V[5] = h_V_6;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
    link->h_eta[2] = h_eta_3;
    link->r_T[0] = r_T_x;
    link->r_T[1] = r_T_y;
    link->r_T[2] = r_T_z;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = minus_R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yy;
    link->R_T[4] = R_T_yz;
    link->R_T[5] = R_T_zz;
    link->G[0] = c1;
    link->G[1] = minus_J_l_xy;
    link->G[2] = J_l_xz;
    link->G[3] = J_l_yy;
    link->G[4] = J_l_yz;
    link->G[5] = J_l_zz;
    link->b_T[0] = b_omega_x;
    link->b_T[1] = b_omega_y;
    link->b_T[2] = b_omega_z;
    link->b_T[3] = b_v_x;
    link->b_T[4] = b_v_y;
    link->b_T[5] = b_v_z;
    tip->omega[0] = omega_T_x;
    tip->omega[1] = omega_T_y;
    tip->omega[2] = omega_T_z;
    tip->v[0] = v_T_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    link->h_T[0] = h_T_F_x;
    link->h_T[1] = h_T_F_y;
    link->h_T[2] = h_T_F_z;
    return ELLA_OK;
}

/* eliminate, links like upper_arm: 1338 operations */
static ella_status eliminate_upper_arm(const ella_link_constants *c, ella_link_store *link, ella_node *base, const ella_node *tip,
    const ella_real w_ext[6], const ella_real m_eta[3], const ella_real f_eta[3], const ella_real tau[2])
{

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real t1 = tip->Lambda[15] + c->body0_mass;
    const ella_real t2 = tip->Lambda[18] + c->body0_mass;
    const ella_real t3 = tip->Lambda[20] + c->body0_mass;
    const ella_real t4 = tip->Lambda[0] * link->b_T[0] + tip->Lambda[1] * link->b_T[1]
        + tip->Lambda[2] * link->b_T[2] + tip->Lambda[3] * link->b_T[3];
    const ella_real t5 = tip->Lambda[1] * link->b_T[0] + tip->Lambda[6] * link->b_T[1]
        + tip->Lambda[7] * link->b_T[2] + tip->Lambda[8] * link->b_T[3];
    const ella_real t6 = tip->Lambda[2] * link->b_T[0] + tip->Lambda[7] * link->b_T[1]
        + tip->Lambda[11] * link->b_T[2] + tip->Lambda[12] * link->b_T[3];
    const ella_real t7 = tip->Lambda[3] * link->b_T[0] + tip->Lambda[8] * link->b_T[1]
        + tip->Lambda[12] * link->b_T[2] + t1 * link->b_T[3];
    const ella_real t8 = tip->Lambda[4] * link->b_T[0] + tip->Lambda[9] * link->b_T[1]
        + tip->Lambda[13] * link->b_T[2] + tip->Lambda[16] * link->b_T[3];
    const ella_real t9 = tip->Lambda[5] * link->b_T[0] + tip->Lambda[10] * link->b_T[1]
        + tip->Lambda[14] * link->b_T[2] + tip->Lambda[17] * link->b_T[3];
    const ella_real t10 = tip->p[0] - w_ext[0]
        + (t4 + tip->Lambda[4] * link->b_T[4] + tip->Lambda[5] * link->b_T[5]);
    const ella_real t11 = tip->p[1] - w_ext[1]
        + (t5 + tip->Lambda[9] * link->b_T[4] + tip->Lambda[10] * link->b_T[5]);
    const ella_real t12 = tip->p[2] - w_ext[2]
        + (t6 + tip->Lambda[13] * link->b_T[4] + tip->Lambda[14] * link->b_T[5]);
    const ella_real t13 = tip->p[3] + link->h_T[0] - w_ext[3]
        + (t7 + tip->Lambda[16] * link->b_T[4] + tip->Lambda[17] * link->b_T[5]);
    const ella_real t14 = tip->p[4] + link->h_T[1] - w_ext[4]
        + (t8 + t2 * link->b_T[4] + tip->Lambda[19] * link->b_T[5]);
    const ella_real t15 = tip->p[5] + link->h_T[2] - w_ext[5]
        + (t9 + tip->Lambda[19] * link->b_T[4] + t3 * link->b_T[5]);
    const ella_real t16 = tip->Lambda[1] * link->R_T[1];
    const ella_real t17 = tip->Lambda[2] * link->R_T[2];
    const ella_real t18 = tip->Lambda[0] * link->R_T[1] + tip->Lambda[1] * link->R_T[3]
        + tip->Lambda[2] * link->R_T[4];
    const ella_real t19 = tip->Lambda[1] * link->R_T[4] - tip->Lambda[0] * link->R_T[2]
        + tip->Lambda[2] * link->R_T[5];
    const ella_real t20 = tip->Lambda[7] * link->R_T[4];
    const ella_real t21 = t16 + tip->Lambda[6] * link->R_T[3] + t20;
    const ella_real t22 = tip->Lambda[6] * link->R_T[4] - tip->Lambda[1] * link->R_T[2]
        + tip->Lambda[7] * link->R_T[5];
    const ella_real t23 = tip->Lambda[2] * link->R_T[1] + tip->Lambda[7] * link->R_T[3]
        + tip->Lambda[11] * link->R_T[4];
    const ella_real t24 = t20 - t17 + tip->Lambda[11] * link->R_T[5];
    const ella_real t25 = link->R_T[1]
        * (tip->Lambda[1] * link->R_T[0] - tip->Lambda[6] * link->R_T[1] + tip->Lambda[7] * link->R_T[2]);
    const ella_real t26 = link->R_T[2]
        * (tip->Lambda[2] * link->R_T[0] - tip->Lambda[7] * link->R_T[1] + tip->Lambda[11] * link->R_T[2]);
    const ella_real Lambda_T_11 = link->R_T[0] * (tip->Lambda[0] * link->R_T[0] - t16 + t17) - t25 + t26;
    const ella_real Lambda_T_12 = link->R_T[0] * t18 - link->R_T[1] * t21 + link->R_T[2] * t23;
    const ella_real Lambda_T_13 = link->R_T[0] * t19 - link->R_T[1] * t22 + link->R_T[2] * t24;
    const ella_real Lambda_T_22 = link->R_T[1] * t18 + link->R_T[3] * t21 + link->R_T[4] * t23;
    const ella_real Lambda_T_23 = link->R_T[1] * t19 + link->R_T[3] * t22 + link->R_T[4] * t24;
    const ella_real Lambda_T_33 = link->R_T[4] * t22 - link->R_T[2] * t19 + link->R_T[5] * t24;
    const ella_real t27 = tip->Lambda[3] * link->R_T[0] - tip->Lambda[4] * link->R_T[1]
        + tip->Lambda[5] * link->R_T[2];
    const ella_real t28 = tip->Lambda[3] * link->R_T[1] + tip->Lambda[4] * link->R_T[3]
        + tip->Lambda[5] * link->R_T[4];
    const ella_real t29 = tip->Lambda[4] * link->R_T[4] - tip->Lambda[3] * link->R_T[2]
        + tip->Lambda[5] * link->R_T[5];
    const ella_real t30 = tip->Lambda[8] * link->R_T[0] - tip->Lambda[9] * link->R_T[1]
        + tip->Lambda[10] * link->R_T[2];
    const ella_real t31 = tip->Lambda[8] * link->R_T[1] + tip->Lambda[9] * link->R_T[3]
        + tip->Lambda[10] * link->R_T[4];
    const ella_real t32 = tip->Lambda[9] * link->R_T[4] - tip->Lambda[8] * link->R_T[2]
        + tip->Lambda[10] * link->R_T[5];
    const ella_real t33 = tip->Lambda[12] * link->R_T[0] - tip->Lambda[13] * link->R_T[1]
        + tip->Lambda[14] * link->R_T[2];
    const ella_real t34 = tip->Lambda[12] * link->R_T[1] + tip->Lambda[13] * link->R_T[3]
        + tip->Lambda[14] * link->R_T[4];
    const ella_real t35 = tip->Lambda[13] * link->R_T[4] - tip->Lambda[12] * link->R_T[2]
        + tip->Lambda[14] * link->R_T[5];
    const ella_real Lambda_T_14 = link->R_T[0] * t27 - link->R_T[1] * t30 + link->R_T[2] * t33;
    const ella_real Lambda_T_15 = link->R_T[0] * t28 - link->R_T[1] * t31 + link->R_T[2] * t34;
    const ella_real Lambda_T_16 = link->R_T[0] * t29 - link->R_T[1] * t32 + link->R_T[2] * t35;
    const ella_real Lambda_T_24 = link->R_T[1] * t27 + link->R_T[3] * t30 + link->R_T[4] * t33;
    const ella_real Lambda_T_25 = link->R_T[1] * t28 + link->R_T[3] * t31 + link->R_T[4] * t34;
    const ella_real Lambda_T_26 = link->R_T[1] * t29 + link->R_T[3] * t32 + link->R_T[4] * t35;
    const ella_real Lambda_T_34 = link->R_T[4] * t30 - link->R_T[2] * t27 + link->R_T[5] * t33;
    const ella_real Lambda_T_35 = link->R_T[4] * t31 - link->R_T[2] * t28 + link->R_T[5] * t34;
    const ella_real Lambda_T_36 = link->R_T[4] * t32 - link->R_T[2] * t29 + link->R_T[5] * t35;
    const ella_real t36 = tip->Lambda[16] * link->R_T[1];
    const ella_real t37 = tip->Lambda[17] * link->R_T[2];
    const ella_real t38 = t1 * link->R_T[1] + tip->Lambda[16] * link->R_T[3] + tip->Lambda[17] * link->R_T[4];
    const ella_real t39 = tip->Lambda[16] * link->R_T[4] - t1 * link->R_T[2] + tip->Lambda[17] * link->R_T[5];
    const ella_real t40 = tip->Lambda[19] * link->R_T[4];
    const ella_real t41 = t36 + t2 * link->R_T[3] + t40;
    const ella_real t42 = t2 * link->R_T[4] - tip->Lambda[16] * link->R_T[2] + tip->Lambda[19] * link->R_T[5];
    const ella_real t43 = tip->Lambda[17] * link->R_T[1] + tip->Lambda[19] * link->R_T[3] + t3 * link->R_T[4];
    const ella_real t44 = t40 - t37 + t3 * link->R_T[5];
    const ella_real t45 = link->R_T[1]
        * (tip->Lambda[16] * link->R_T[0] - t2 * link->R_T[1] + tip->Lambda[19] * link->R_T[2]);
    const ella_real t46 = link->R_T[2]
        * (tip->Lambda[17] * link->R_T[0] - tip->Lambda[19] * link->R_T[1] + t3 * link->R_T[2]);
    const ella_real Lambda_T_44 = link->R_T[0] * (t1 * link->R_T[0] - t36 + t37) - t45 + t46;
    const ella_real Lambda_T_45 = link->R_T[0] * t38 - link->R_T[1] * t41 + link->R_T[2] * t43;
    const ella_real Lambda_T_46 = link->R_T[0] * t39 - link->R_T[1] * t42 + link->R_T[2] * t44;
    const ella_real Lambda_T_55 = link->R_T[1] * t38 + link->R_T[3] * t41 + link->R_T[4] * t43;
    const ella_real Lambda_T_56 = link->R_T[1] * t39 + link->R_T[3] * t42 + link->R_T[4] * t44;
    const ella_real Lambda_T_66 = link->R_T[4] * t42 - link->R_T[2] * t39 + link->R_T[5] * t44;
    const ella_real p_T_1 = link->R_T[0] * t10 - link->R_T[1] * t11 + link->R_T[2] * t12;
    const ella_real p_T_2 = link->R_T[1] * t10 + link->R_T[3] * t11 + link->R_T[4] * t12;
    const ella_real p_T_3 = link->R_T[4] * t11 - link->R_T[2] * t10 + link->R_T[5] * t12;
    const ella_real p_T_4 = link->R_T[0] * t13 - link->R_T[1] * t14 + link->R_T[2] * t15;
    const ella_real p_T_5 = link->R_T[1] * t13 + link->R_T[3] * t14 + link->R_T[4] * t15;
    const ella_real p_T_6 = link->R_T[4] * t14 - link->R_T[2] * t13 + link->R_T[5] * t15;

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real t47 = link->r_T[2] * Lambda_T_45;
    const ella_real t48 = link->r_T[1] * Lambda_T_46;
    const ella_real t49 = link->r_T[0] * Lambda_T_56;
    const ella_real M_loaded_14 = Lambda_T_14 + (t48 - t47);
    const ella_real t50 = Lambda_T_15 + (link->r_T[1] * Lambda_T_56 - link->r_T[2] * Lambda_T_55);
    const ella_real t51 = Lambda_T_16 + (link->r_T[1] * Lambda_T_66 - link->r_T[2] * Lambda_T_56);
    const ella_real t52 = Lambda_T_24 + (link->r_T[2] * Lambda_T_44 - link->r_T[0] * Lambda_T_46);
    const ella_real M_loaded_25 = Lambda_T_25 + (t47 - t49);
    const ella_real t53 = Lambda_T_26 + (link->r_T[2] * Lambda_T_46 - link->r_T[0] * Lambda_T_66);
    const ella_real t54 = Lambda_T_34 + (link->r_T[0] * Lambda_T_45 - link->r_T[1] * Lambda_T_44);
    const ella_real t55 = Lambda_T_35 + (link->r_T[0] * Lambda_T_55 - link->r_T[1] * Lambda_T_45);
    const ella_real M_loaded_36 = Lambda_T_36 + (t49 - t48);
    const ella_real t56 = Lambda_T_11 - (Lambda_T_15 * link->r_T[2] - Lambda_T_16 * link->r_T[1])
        + (link->r_T[1] * t51 - link->r_T[2] * t50);
    const ella_real t57 = Lambda_T_12 - (Lambda_T_16 * link->r_T[0] - Lambda_T_14 * link->r_T[2])
        + (link->r_T[1] * t53 - link->r_T[2] * M_loaded_25);
    const ella_real t58 = Lambda_T_13 - (Lambda_T_14 * link->r_T[1] - Lambda_T_15 * link->r_T[0])
        + (link->r_T[1] * M_loaded_36 - link->r_T[2] * t55);
    const ella_real t59 = Lambda_T_22 - (Lambda_T_26 * link->r_T[0] - Lambda_T_24 * link->r_T[2])
        + (link->r_T[2] * t52 - link->r_T[0] * t53);
    const ella_real t60 = Lambda_T_23 - (Lambda_T_24 * link->r_T[1] - Lambda_T_25 * link->r_T[0])
        + (link->r_T[2] * t54 - link->r_T[0] * M_loaded_36);
    const ella_real t61 = Lambda_T_33 - (Lambda_T_34 * link->r_T[1] - Lambda_T_35 * link->r_T[0])
        + (link->r_T[0] * t55 - link->r_T[1] * t54);
    const ella_real M_loaded_11 = link->M_V[0] + t56;
    const ella_real M_loaded_12 = t57 - link->M_V[1];
    const ella_real M_loaded_13 = t58 - link->M_V[2];
    const ella_real M_loaded_15 = t50 - link->M_V[3];
    const ella_real M_loaded_16 = link->M_V[4] + t51;
    const ella_real M_loaded_22 = link->M_V[5] + t59;
    const ella_real M_loaded_23 = t60 - link->M_V[6];
    const ella_real M_loaded_24 = link->M_V[3] + t52;
    const ella_real M_loaded_26 = t53 - link->M_V[7];
    const ella_real M_loaded_33 = link->M_V[8] + t61;
    const ella_real M_loaded_34 = t54 - link->M_V[4];
    const ella_real M_loaded_35 = link->M_V[7] + t55;
    const ella_real M_loaded_44 = c->mu + Lambda_T_44;
    const ella_real M_loaded_55 = c->mu + Lambda_T_55;
    const ella_real M_loaded_66 = c->mu + Lambda_T_66;
    const ella_real h_loaded_1 = link->h_V[0] + (p_T_1 + (link->r_T[1] * p_T_6 - link->r_T[2] * p_T_5));
    const ella_real h_loaded_2 = link->h_V[1] + (p_T_2 + (link->r_T[2] * p_T_4 - link->r_T[0] * p_T_6));
    const ella_real h_loaded_3 = link->h_V[2] + (p_T_3 + (link->r_T[0] * p_T_5 - link->r_T[1] * p_T_4));
    const ella_real h_loaded_4 = link->h_V[3] + p_T_4;
    const ella_real h_loaded_5 = link->h_V[4] + p_T_5;
    const ella_real h_loaded_6 = link->h_V[5] + p_T_6;
    const ella_real t62 = Lambda_T_12 * link->G[3] - Lambda_T_11 * link->G[1] + Lambda_T_13 * link->G[4];
    const ella_real t63 = Lambda_T_11 * link->G[2] + Lambda_T_12 * link->G[4] + Lambda_T_13 * link->G[5];
    const ella_real t64 = Lambda_T_23 * link->G[4];
    const ella_real t65 = Lambda_T_22 * link->G[3] - Lambda_T_12 * link->G[1] + t64;
    const ella_real t66 = Lambda_T_12 * link->G[2] + Lambda_T_22 * link->G[4] + Lambda_T_23 * link->G[5];
    const ella_real t67 = Lambda_T_23 * link->G[3] - Lambda_T_13 * link->G[1] + Lambda_T_33 * link->G[4];
    const ella_real t68 = Lambda_T_13 * link->G[2] + t64 + Lambda_T_33 * link->G[5];
    const ella_real t69 = Lambda_T_15 * link->G[2] + Lambda_T_25 * link->G[4] + Lambda_T_35 * link->G[5];
    const ella_real t70 = Lambda_T_26 * link->G[3] - Lambda_T_16 * link->G[1] + Lambda_T_36 * link->G[4];
    const ella_real t71 = Lambda_T_16 * link->G[2] + Lambda_T_26 * link->G[4] + Lambda_T_36 * link->G[5];
    const ella_real t72 = Lambda_T_44 * REAL(1.4142135623730951);
    const ella_real C_42 = (Lambda_T_14 * link->G[2] + Lambda_T_24 * link->G[4] + Lambda_T_34 * link->G[5])
        * c->Psi_c_z2 + Lambda_T_45 * 2;
    const ella_real C_43 = (Lambda_T_24 * link->G[3] - Lambda_T_14 * link->G[1] + Lambda_T_34 * link->G[4])
        * c->Psi_c_y3 + Lambda_T_46 * 2;
    const ella_real C_51 = Lambda_T_45 * REAL(1.4142135623730951);
    const ella_real t73 = t69 * c->Psi_c_z2 + Lambda_T_55 * 2;
    const ella_real t74 = Lambda_T_56 * 2;
    const ella_real C_53 = (Lambda_T_25 * link->G[3] - Lambda_T_15 * link->G[1] + Lambda_T_35 * link->G[4])
        * c->Psi_c_y3 + t74;
    const ella_real C_61 = Lambda_T_46 * REAL(1.4142135623730951);
    const ella_real C_62 = t71 * c->Psi_c_z2 + t74;
    const ella_real t75 = t70 * c->Psi_c_y3 + Lambda_T_66 * 2;
    const ella_real C_11 = Lambda_T_14 * REAL(1.4142135623730951) + (link->r_T[1] * C_61 - link->r_T[2] * C_51);
    const ella_real C_22 = t66 * c->Psi_c_z2 + Lambda_T_25 * 2 + (link->r_T[2] * C_42 - link->r_T[0] * C_62);
    const ella_real C_33 = t67 * c->Psi_c_y3 + Lambda_T_36 * 2 + (link->r_T[0] * C_53 - link->r_T[1] * C_43);
    const ella_real C_12 = t63 * c->Psi_c_z2 + Lambda_T_15 * 2 + (link->r_T[1] * C_62 - link->r_T[2] * t73)
        - link->M_D[0];
    const ella_real C_13 = link->M_D[1]
        + (t62 * c->Psi_c_y3 + Lambda_T_16 * 2 + (link->r_T[1] * t75 - link->r_T[2] * C_53));
    const ella_real C_21 = link->M_D[2]
        + (Lambda_T_24 * REAL(1.4142135623730951) + (link->r_T[2] * t72 - link->r_T[0] * C_61));
    const ella_real C_23 = t65 * c->Psi_c_y3 + Lambda_T_26 * 2 + (link->r_T[2] * C_43 - link->r_T[0] * t75)
        - link->M_D[3];
    const ella_real C_31 = Lambda_T_34 * REAL(1.4142135623730951) + (link->r_T[0] * C_51 - link->r_T[1] * t72)
        - link->M_D[4];
    const ella_real C_32 = link->M_D[5]
        + (t68 * c->Psi_c_z2 + Lambda_T_35 * 2 + (link->r_T[0] * t73 - link->r_T[1] * C_42));
    const ella_real C_41 = c->sigma_x1 + t72;
    const ella_real C_52 = c->sigma_y2 + t73;
    const ella_real C_63 = c->sigma_z3 + t75;
    const ella_real modal_inertia_12 = C_42 * REAL(1.4142135623730951);
    const ella_real modal_inertia_13 = C_43 * REAL(1.4142135623730951);
    const ella_real t76 = c->Psi_c_z2
        * ((link->G[2] * t63 + link->G[4] * t66 + link->G[5] * t68) * c->Psi_c_z2 + t69 * 2) + t73 * 2;
    const ella_real modal_inertia_23 = c->Psi_c_z2
        * ((link->G[3] * t66 - link->G[1] * t63 + link->G[4] * t68) * c->Psi_c_y3 + t71 * 2) + C_53 * 2;
    const ella_real t77 = c->Psi_c_y3
        * ((link->G[3] * t65 - link->G[1] * t62 + link->G[4] * t67) * c->Psi_c_y3 + t70 * 2) + t75 * 2;
    const ella_real modal_inertia_11 = Lambda_T_44 * REAL(2.0000000000000004) + m_eta[0];
    if (!(modal_inertia_11 > 0)) { return ELLA_SINGULAR; }
    const ella_real modal_inertia_22 = t76 + m_eta[1];
    const ella_real modal_inertia_33 = t77 + m_eta[2];
    const ella_real h_phi_1 = link->h_eta[0] + f_eta[0] + p_T_4 * REAL(1.4142135623730951);
    const ella_real h_phi_2 = link->h_eta[1] + f_eta[1]
        + (c->Psi_c_z2 * (link->G[2] * p_T_1 + link->G[4] * p_T_2 + link->G[5] * p_T_3) + p_T_5 * 2);
    const ella_real h_phi_3 = link->h_eta[2] + f_eta[2]
        + (c->Psi_c_y3 * (link->G[3] * p_T_2 - link->G[1] * p_T_1 + link->G[4] * p_T_3) + p_T_6 * 2);
    const ella_real modes_inverse_1 = 1 / modal_inertia_11;
    const ella_real modes_L_21 = modal_inertia_12 * modes_inverse_1;
    const ella_real modes_L_31 = modal_inertia_13 * modes_inverse_1;
    const ella_real t78 = modal_inertia_22 - modal_inertia_12 * modes_L_21;
    if (!(t78 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_2 = 1 / t78;
    const ella_real t79 = modal_inertia_23 - modal_inertia_12 * modes_L_31;
    const ella_real modes_L_32 = t79 * modes_inverse_2;
    const ella_real t80 = modal_inertia_33 - (modal_inertia_13 * modes_L_31 + t79 * modes_L_32);
    if (!(t80 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_3 = 1 / t80;
    const ella_real t81 = C_12 - modes_L_21 * C_11;
    const ella_real t82 = C_22 - modes_L_21 * C_21;
    const ella_real t83 = C_32 - modes_L_21 * C_31;
    const ella_real t84 = C_42 - modes_L_21 * C_41;
    const ella_real t85 = C_52 - modes_L_21 * C_51;
    const ella_real t86 = C_62 - modes_L_21 * C_61;
    const ella_real t87 = C_13 - modes_L_31 * C_11 - modes_L_32 * t81;
    const ella_real t88 = C_23 - modes_L_31 * C_21 - modes_L_32 * t82;
    const ella_real t89 = C_33 - modes_L_31 * C_31 - modes_L_32 * t83;
    const ella_real t90 = C_43 - modes_L_31 * C_41 - modes_L_32 * t84;
    const ella_real t91 = C_53 - modes_L_31 * C_51 - modes_L_32 * t85;
    const ella_real t92 = C_63 - modes_L_31 * C_61 - modes_L_32 * t86;
    const ella_real t93 = h_phi_2 - modes_L_21 * h_phi_1;
    const ella_real t94 = h_phi_3 - modes_L_31 * h_phi_1 - modes_L_32 * t93;
    const ella_real modes_W_11 = C_11 * modes_inverse_1;
    const ella_real modes_W_12 = C_21 * modes_inverse_1;
    const ella_real modes_W_13 = C_31 * modes_inverse_1;
    const ella_real modes_W_14 = C_41 * modes_inverse_1;
    const ella_real modes_W_15 = C_51 * modes_inverse_1;
    const ella_real modes_W_16 = C_61 * modes_inverse_1;
    const ella_real modes_W_21 = t81 * modes_inverse_2;
    const ella_real modes_W_22 = t82 * modes_inverse_2;
    const ella_real modes_W_23 = t83 * modes_inverse_2;
    const ella_real modes_W_24 = t84 * modes_inverse_2;
    const ella_real modes_W_25 = t85 * modes_inverse_2;
    const ella_real modes_W_26 = t86 * modes_inverse_2;
    const ella_real modes_W_31 = t87 * modes_inverse_3;
    const ella_real modes_W_32 = t88 * modes_inverse_3;
    const ella_real modes_W_33 = t89 * modes_inverse_3;
    const ella_real modes_W_34 = t90 * modes_inverse_3;
    const ella_real modes_W_35 = t91 * modes_inverse_3;
    const ella_real modes_W_36 = t92 * modes_inverse_3;
    const ella_real modes_w_1 = h_phi_1 * modes_inverse_1;
    const ella_real modes_w_2 = t93 * modes_inverse_2;
    const ella_real modes_w_3 = t94 * modes_inverse_3;
    const ella_real M_i_11 = M_loaded_11 - (C_11 * modes_W_11 + t81 * modes_W_21 + t87 * modes_W_31);
    const ella_real M_i_12 = M_loaded_12 - (C_11 * modes_W_12 + t81 * modes_W_22 + t87 * modes_W_32);
    const ella_real M_i_13 = M_loaded_13 - (C_11 * modes_W_13 + t81 * modes_W_23 + t87 * modes_W_33);
    const ella_real M_i_14 = M_loaded_14 - (C_11 * modes_W_14 + t81 * modes_W_24 + t87 * modes_W_34);
    const ella_real M_i_15 = M_loaded_15 - (C_11 * modes_W_15 + t81 * modes_W_25 + t87 * modes_W_35);
    const ella_real M_i_16 = M_loaded_16 - (C_11 * modes_W_16 + t81 * modes_W_26 + t87 * modes_W_36);
    const ella_real M_i_22 = M_loaded_22 - (C_21 * modes_W_12 + t82 * modes_W_22 + t88 * modes_W_32);
    const ella_real M_i_23 = M_loaded_23 - (C_21 * modes_W_13 + t82 * modes_W_23 + t88 * modes_W_33);
    const ella_real M_i_24 = M_loaded_24 - (C_21 * modes_W_14 + t82 * modes_W_24 + t88 * modes_W_34);
    const ella_real M_i_25 = M_loaded_25 - (C_21 * modes_W_15 + t82 * modes_W_25 + t88 * modes_W_35);
    const ella_real M_i_26 = M_loaded_26 - (C_21 * modes_W_16 + t82 * modes_W_26 + t88 * modes_W_36);
    const ella_real M_i_33 = M_loaded_33 - (C_31 * modes_W_13 + t83 * modes_W_23 + t89 * modes_W_33);
    const ella_real M_i_34 = M_loaded_34 - (C_31 * modes_W_14 + t83 * modes_W_24 + t89 * modes_W_34);
    const ella_real M_i_35 = M_loaded_35 - (C_31 * modes_W_15 + t83 * modes_W_25 + t89 * modes_W_35);
    const ella_real M_i_36 = M_loaded_36 - (C_31 * modes_W_16 + t83 * modes_W_26 + t89 * modes_W_36);
    const ella_real M_i_44 = M_loaded_44 - (C_41 * modes_W_14 + t84 * modes_W_24 + t90 * modes_W_34);
    const ella_real M_i_45 = Lambda_T_45 - (C_41 * modes_W_15 + t84 * modes_W_25 + t90 * modes_W_35);
    const ella_real M_i_46 = Lambda_T_46 - (C_41 * modes_W_16 + t84 * modes_W_26 + t90 * modes_W_36);
    const ella_real M_i_55 = M_loaded_55 - (C_51 * modes_W_15 + t85 * modes_W_25 + t91 * modes_W_35);
    const ella_real M_i_56 = Lambda_T_56 - (C_51 * modes_W_16 + t85 * modes_W_26 + t91 * modes_W_36);
    const ella_real M_i_66 = M_loaded_66 - (C_61 * modes_W_16 + t86 * modes_W_26 + t92 * modes_W_36);
    const ella_real h_i_1 = h_loaded_1 - (modes_W_11 * h_phi_1 + modes_W_21 * t93 + modes_W_31 * t94);
    const ella_real h_i_2 = h_loaded_2 - (modes_W_12 * h_phi_1 + modes_W_22 * t93 + modes_W_32 * t94);
    const ella_real h_i_3 = h_loaded_3 - (modes_W_13 * h_phi_1 + modes_W_23 * t93 + modes_W_33 * t94);
    const ella_real h_i_4 = h_loaded_4 - (modes_W_14 * h_phi_1 + modes_W_24 * t93 + modes_W_34 * t94);
    const ella_real h_i_5 = h_loaded_5 - (modes_W_15 * h_phi_1 + modes_W_25 * t93 + modes_W_35 * t94);
    const ella_real h_i_6 = h_loaded_6 - (modes_W_16 * h_phi_1 + modes_W_26 * t93 + modes_W_36 * t94);

    /* joint: its accelerations eliminated from its rows (43) */
    const ella_real U_11 = M_i_11 * link->A[0] + M_i_12 * link->A[1];
    const ella_real U_21 = M_i_12 * link->A[0] + M_i_22 * link->A[1];
    const ella_real U_31 = M_i_13 * link->A[0] + M_i_23 * link->A[1];
    const ella_real U_41 = M_i_14 * link->A[0] + M_i_24 * link->A[1];
    const ella_real U_51 = M_i_15 * link->A[0] + M_i_25 * link->A[1];
    const ella_real U_61 = M_i_16 * link->A[0] + M_i_26 * link->A[1];
    const ella_real t95 = M_i_11 * link->beta[0] + M_i_12 * link->beta[1] + M_i_13 * link->beta[2]
        + M_i_14 * link->beta[3];
    const ella_real t96 = M_i_12 * link->beta[0] + M_i_22 * link->beta[1] + M_i_23 * link->beta[2]
        + M_i_24 * link->beta[3];
    const ella_real t97 = M_i_13 * link->beta[0] + M_i_23 * link->beta[1] + M_i_33 * link->beta[2]
        + M_i_34 * link->beta[3];
    const ella_real t98 = M_i_14 * link->beta[0] + M_i_24 * link->beta[1] + M_i_34 * link->beta[2]
        + M_i_44 * link->beta[3];
    const ella_real t99 = M_i_15 * link->beta[0] + M_i_25 * link->beta[1] + M_i_35 * link->beta[2]
        + M_i_45 * link->beta[3];
    const ella_real t100 = M_i_16 * link->beta[0] + M_i_26 * link->beta[1] + M_i_36 * link->beta[2]
        + M_i_46 * link->beta[3];
    const ella_real bias_1 = h_i_1 + (t95 + M_i_15 * link->beta[4] + M_i_16 * link->beta[5]);
    const ella_real bias_2 = h_i_2 + (t96 + M_i_25 * link->beta[4] + M_i_26 * link->beta[5]);
    const ella_real bias_3 = h_i_3 + (t97 + M_i_35 * link->beta[4] + M_i_36 * link->beta[5]);
    const ella_real bias_4 = h_i_4 + (t98 + M_i_45 * link->beta[4] + M_i_46 * link->beta[5]);
    const ella_real bias_5 = h_i_5 + (t99 + M_i_55 * link->beta[4] + M_i_56 * link->beta[5]);
    const ella_real bias_6 = h_i_6 + (t100 + M_i_56 * link->beta[4] + M_i_66 * link->beta[5]);
    const ella_real joint_inertia_11 = link->A[0] * U_11 + link->A[1] * U_21;
    const ella_real t101 = ELLA_REAL_EPSILON * 8 * (M_i_11 + M_i_22 + M_i_33);
    if (!(joint_inertia_11 - t101 > 0)) { return ELLA_SINGULAR; }
    const ella_real joint_inverse_1 = 1 / joint_inertia_11;
    const ella_real joint_L_21 = U_31 * joint_inverse_1;
    const ella_real t102 = M_i_33 - U_31 * joint_L_21;
    if (!(t102 - t101 > 0)) { return ELLA_SINGULAR; }
    const ella_real joint_inverse_2 = 1 / t102;
    const ella_real t103 = M_i_13 - joint_L_21 * U_11;
    const ella_real t104 = M_i_23 - joint_L_21 * U_21;
    const ella_real t105 = M_i_34 - joint_L_21 * U_41;
    const ella_real t106 = M_i_35 - joint_L_21 * U_51;
    const ella_real t107 = M_i_36 - joint_L_21 * U_61;
    const ella_real joint_W_11 = U_11 * joint_inverse_1;
    const ella_real joint_W_12 = U_21 * joint_inverse_1;
    const ella_real joint_W_14 = U_41 * joint_inverse_1;
    const ella_real joint_W_15 = U_51 * joint_inverse_1;
    const ella_real joint_W_16 = U_61 * joint_inverse_1;
    const ella_real joint_W_21 = t103 * joint_inverse_2;
    const ella_real joint_W_22 = t104 * joint_inverse_2;
    const ella_real joint_W_24 = t105 * joint_inverse_2;
    const ella_real joint_W_25 = t106 * joint_inverse_2;
    const ella_real joint_W_26 = t107 * joint_inverse_2;
    const ella_real t108 = tau[0] - (link->A[0] * bias_1 + link->A[1] * bias_2);
    const ella_real t109 = tau[1] - bias_3 - joint_L_21 * t108;
    const ella_real joint_w_1 = t108 * joint_inverse_1;
    const ella_real joint_w_2 = t109 * joint_inverse_2;
    const ella_real Lambda_i_11 = M_i_11 - (U_11 * joint_W_11 + t103 * joint_W_21);
    const ella_real Lambda_i_12 = M_i_12 - (U_11 * joint_W_12 + t103 * joint_W_22);
    const ella_real Lambda_i_14 = M_i_14 - (U_11 * joint_W_14 + t103 * joint_W_24);
    const ella_real Lambda_i_15 = M_i_15 - (U_11 * joint_W_15 + t103 * joint_W_25);
    const ella_real Lambda_i_16 = M_i_16 - (U_11 * joint_W_16 + t103 * joint_W_26);
    const ella_real Lambda_i_22 = M_i_22 - (U_21 * joint_W_12 + t104 * joint_W_22);
    const ella_real Lambda_i_24 = M_i_24 - (U_21 * joint_W_14 + t104 * joint_W_24);
    const ella_real Lambda_i_25 = M_i_25 - (U_21 * joint_W_15 + t104 * joint_W_25);
    const ella_real Lambda_i_26 = M_i_26 - (U_21 * joint_W_16 + t104 * joint_W_26);
    const ella_real Lambda_i_34 = M_i_34 - (U_31 * joint_W_14 + t105);
    const ella_real Lambda_i_35 = M_i_35 - (U_31 * joint_W_15 + t106);
    const ella_real Lambda_i_36 = M_i_36 - (U_31 * joint_W_16 + t107);
    const ella_real Lambda_i_44 = M_i_44 - (U_41 * joint_W_14 + t105 * joint_W_24);
    const ella_real Lambda_i_45 = M_i_45 - (U_41 * joint_W_15 + t105 * joint_W_25);
    const ella_real Lambda_i_46 = M_i_46 - (U_41 * joint_W_16 + t105 * joint_W_26);
    const ella_real Lambda_i_55 = M_i_55 - (U_51 * joint_W_15 + t106 * joint_W_25);
    const ella_real Lambda_i_56 = M_i_56 - (U_51 * joint_W_16 + t106 * joint_W_26);
    const ella_real Lambda_i_66 = M_i_66 - (U_61 * joint_W_16 + t107 * joint_W_26);
    const ella_real p_i_1 = bias_1 + (U_11 * joint_w_1 + t103 * joint_w_2);
    const ella_real p_i_2 = bias_2 + (U_21 * joint_w_1 + t104 * joint_w_2);
    const ella_real p_i_3 = bias_3 + (U_31 * joint_w_1 + t109);
    const ella_real p_i_4 = bias_4 + (U_41 * joint_w_1 + t105 * joint_w_2);
    const ella_real p_i_5 = bias_5 + (U_51 * joint_w_1 + t106 * joint_w_2);
    const ella_real p_i_6 = bias_6 + (U_61 * joint_w_1 + t107 * joint_w_2);

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const ella_real t110 = Lambda_i_11 * link->R_rel[3] + Lambda_i_12 * link->R_rel[4];
    const ella_real t111 = Lambda_i_12 * link->R_rel[6] - Lambda_i_11 * link->R_rel[5];
    const ella_real t112 = Lambda_i_12 * link->R_rel[3] + Lambda_i_22 * link->R_rel[4];
    const ella_real t113 = Lambda_i_22 * link->R_rel[6] - Lambda_i_12 * link->R_rel[5];
    const ella_real Lambda_1 = link->R_rel[0] * (Lambda_i_11 * link->R_rel[0] - Lambda_i_12 * link->R_rel[1])
        - link->R_rel[1] * (Lambda_i_12 * link->R_rel[0] - Lambda_i_22 * link->R_rel[1]);
    const ella_real Lambda_2 = link->R_rel[0] * t110 - link->R_rel[1] * t112;
    const ella_real Lambda_3 = link->R_rel[0] * t111 - link->R_rel[1] * t113;
    const ella_real Lambda_7 = link->R_rel[3] * t110 + link->R_rel[4] * t112;
    const ella_real Lambda_8 = link->R_rel[3] * t111 + link->R_rel[4] * t113;
    const ella_real Lambda_12 = link->R_rel[6] * t113 - link->R_rel[5] * t111;
    const ella_real t114 = Lambda_i_14 * link->R_rel[0] - Lambda_i_15 * link->R_rel[1]
        + Lambda_i_16 * link->R_rel[2];
    const ella_real t115 = Lambda_i_14 * link->R_rel[3] + Lambda_i_15 * link->R_rel[4];
    const ella_real t116 = Lambda_i_15 * link->R_rel[6] - Lambda_i_14 * link->R_rel[5]
        + Lambda_i_16 * link->R_rel[7];
    const ella_real t117 = Lambda_i_24 * link->R_rel[0] - Lambda_i_25 * link->R_rel[1]
        + Lambda_i_26 * link->R_rel[2];
    const ella_real t118 = Lambda_i_24 * link->R_rel[3] + Lambda_i_25 * link->R_rel[4];
    const ella_real t119 = Lambda_i_25 * link->R_rel[6] - Lambda_i_24 * link->R_rel[5]
        + Lambda_i_26 * link->R_rel[7];
    const ella_real t120 = Lambda_i_34 * link->R_rel[0] - Lambda_i_35 * link->R_rel[1]
        + Lambda_i_36 * link->R_rel[2];
    const ella_real t121 = Lambda_i_34 * link->R_rel[3] + Lambda_i_35 * link->R_rel[4];
    const ella_real t122 = Lambda_i_35 * link->R_rel[6] - Lambda_i_34 * link->R_rel[5]
        + Lambda_i_36 * link->R_rel[7];
    const ella_real Lambda_4 = link->R_rel[0] * t114 - link->R_rel[1] * t117 + link->R_rel[2] * t120;
    const ella_real Lambda_5 = link->R_rel[0] * t115 - link->R_rel[1] * t118 + link->R_rel[2] * t121;
    const ella_real Lambda_6 = link->R_rel[0] * t116 - link->R_rel[1] * t119 + link->R_rel[2] * t122;
    const ella_real Lambda_9 = link->R_rel[3] * t114 + link->R_rel[4] * t117;
    const ella_real Lambda_10 = link->R_rel[3] * t115 + link->R_rel[4] * t118;
    const ella_real Lambda_11 = link->R_rel[3] * t116 + link->R_rel[4] * t119;
    const ella_real Lambda_13 = link->R_rel[6] * t117 - link->R_rel[5] * t114 + link->R_rel[7] * t120;
    const ella_real Lambda_14 = link->R_rel[6] * t118 - link->R_rel[5] * t115 + link->R_rel[7] * t121;
    const ella_real Lambda_15 = link->R_rel[6] * t119 - link->R_rel[5] * t116 + link->R_rel[7] * t122;
    const ella_real t123 = Lambda_i_44 * link->R_rel[3] + Lambda_i_45 * link->R_rel[4];
    const ella_real t124 = Lambda_i_45 * link->R_rel[6] - Lambda_i_44 * link->R_rel[5]
        + Lambda_i_46 * link->R_rel[7];
    const ella_real t125 = Lambda_i_45 * link->R_rel[3] + Lambda_i_55 * link->R_rel[4];
    const ella_real t126 = Lambda_i_55 * link->R_rel[6] - Lambda_i_45 * link->R_rel[5]
        + Lambda_i_56 * link->R_rel[7];
    const ella_real t127 = Lambda_i_56 * link->R_rel[6] - Lambda_i_46 * link->R_rel[5]
        + Lambda_i_66 * link->R_rel[7];
    const ella_real t128 = link->R_rel[0]
        * (Lambda_i_44 * link->R_rel[0] - Lambda_i_45 * link->R_rel[1] + Lambda_i_46 * link->R_rel[2]);
    const ella_real t129 = link->R_rel[1]
        * (Lambda_i_45 * link->R_rel[0] - Lambda_i_55 * link->R_rel[1] + Lambda_i_56 * link->R_rel[2]);
    const ella_real t130 = link->R_rel[2]
        * (Lambda_i_46 * link->R_rel[0] - Lambda_i_56 * link->R_rel[1] + Lambda_i_66 * link->R_rel[2]);
    const ella_real Lambda_16 = t128 - t129 + t130;
    const ella_real Lambda_17 = link->R_rel[0] * t123 - link->R_rel[1] * t125
        + link->R_rel[2] * (Lambda_i_46 * link->R_rel[3] + Lambda_i_56 * link->R_rel[4]);
    const ella_real Lambda_18 = link->R_rel[0] * t124 - link->R_rel[1] * t126 + link->R_rel[2] * t127;
    const ella_real Lambda_19 = link->R_rel[3] * t123 + link->R_rel[4] * t125;
    const ella_real Lambda_20 = link->R_rel[3] * t124 + link->R_rel[4] * t126;
    const ella_real Lambda_21 = link->R_rel[6] * t126 - link->R_rel[5] * t124 + link->R_rel[7] * t127;
    const ella_real p_1 = link->R_rel[0] * p_i_1 - link->R_rel[1] * p_i_2 + link->R_rel[2] * p_i_3;
    const ella_real p_2 = link->R_rel[3] * p_i_1 + link->R_rel[4] * p_i_2;
    const ella_real p_3 = link->R_rel[6] * p_i_2 - link->R_rel[5] * p_i_1 + link->R_rel[7] * p_i_3;
    const ella_real p_4 = link->R_rel[0] * p_i_4 - link->R_rel[1] * p_i_5 + link->R_rel[2] * p_i_6;
    const ella_real p_5 = link->R_rel[3] * p_i_4 + link->R_rel[4] * p_i_5;
    const ella_real p_6 = link->R_rel[6] * p_i_5 - link->R_rel[5] * p_i_4 + link->R_rel[7] * p_i_6;

    /* outputs */
    link->modes_L[0] = modes_L_21;
    link->modes_L[1] = modes_L_31;
    link->modes_L[2] = modes_L_32;
    link->modes_W[0] = modes_W_11;
    link->modes_W[1] = modes_W_12;
    link->modes_W[2] = modes_W_13;
    link->modes_W[3] = modes_W_14;
    link->modes_W[4] = modes_W_15;
    link->modes_W[5] = modes_W_16;
    link->modes_W[6] = modes_W_21;
    link->modes_W[7] = modes_W_22;
    link->modes_W[8] = modes_W_23;
    link->modes_W[9] = modes_W_24;
    link->modes_W[10] = modes_W_25;
    link->modes_W[11] = modes_W_26;
    link->modes_W[12] = modes_W_31;
    link->modes_W[13] = modes_W_32;
    link->modes_W[14] = modes_W_33;
    link->modes_W[15] = modes_W_34;
    link->modes_W[16] = modes_W_35;
    link->modes_W[17] = modes_W_36;
    link->modes_w[0] = modes_w_1;
    link->modes_w[1] = modes_w_2;
    link->modes_w[2] = modes_w_3;
    link->joint_L[0] = joint_L_21;
    link->joint_W[0] = joint_W_11;
    link->joint_W[1] = joint_W_12;
    link->joint_W[2] = joint_L_21;
    link->joint_W[3] = joint_W_14;
    link->joint_W[4] = joint_W_15;
    link->joint_W[5] = joint_W_16;
    link->joint_W[6] = joint_W_21;
    link->joint_W[7] = joint_W_22;
    link->joint_W[8] = joint_W_24;
    link->joint_W[9] = joint_W_25;
    link->joint_W[10] = joint_W_26;
    link->joint_w[0] = joint_w_1;
    link->joint_w[1] = joint_w_2;
    link->Lambda_i[0] = Lambda_i_11;
    link->Lambda_i[1] = Lambda_i_12;
    link->Lambda_i[2] = Lambda_i_14;
    link->Lambda_i[3] = Lambda_i_15;
    link->Lambda_i[4] = Lambda_i_16;
    link->Lambda_i[5] = Lambda_i_22;
    link->Lambda_i[6] = Lambda_i_24;
    link->Lambda_i[7] = Lambda_i_25;
    link->Lambda_i[8] = Lambda_i_26;
    link->Lambda_i[9] = Lambda_i_34;
    link->Lambda_i[10] = Lambda_i_35;
    link->Lambda_i[11] = Lambda_i_36;
    link->Lambda_i[12] = Lambda_i_44;
    link->Lambda_i[13] = Lambda_i_45;
    link->Lambda_i[14] = Lambda_i_46;
    link->Lambda_i[15] = Lambda_i_55;
    link->Lambda_i[16] = Lambda_i_56;
    link->Lambda_i[17] = Lambda_i_66;
    link->p_i[0] = p_i_1;
    link->p_i[1] = p_i_2;
    link->p_i[2] = p_i_3;
    link->p_i[3] = p_i_4;
    link->p_i[4] = p_i_5;
    link->p_i[5] = p_i_6;
    base->Lambda[0] = Lambda_1;
    base->Lambda[1] = Lambda_2;
    base->Lambda[2] = Lambda_3;
    base->Lambda[3] = Lambda_4;
    base->Lambda[4] = Lambda_5;
    base->Lambda[5] = Lambda_6;
    base->Lambda[6] = Lambda_7;
    base->Lambda[7] = Lambda_8;
    base->Lambda[8] = Lambda_9;
    base->Lambda[9] = Lambda_10;
    base->Lambda[10] = Lambda_11;
    base->Lambda[11] = Lambda_12;
    base->Lambda[12] = Lambda_13;
    base->Lambda[13] = Lambda_14;
    base->Lambda[14] = Lambda_15;
    base->Lambda[15] = Lambda_16;
    base->Lambda[16] = Lambda_17;
    base->Lambda[17] = Lambda_18;
    base->Lambda[18] = Lambda_19;
    base->Lambda[19] = Lambda_20;
    base->Lambda[20] = Lambda_21;
    base->p[0] = p_1;
    base->p[1] = p_2;
    base->p[2] = p_3;
    base->p[3] = p_4;
    base->p[4] = p_5;
    base->p[5] = p_6;
    return ELLA_OK;
}

/* eliminate, links like forearm: 1095 operations */
static ella_status eliminate_forearm(const ella_link_constants *c, ella_link_store *link, ella_node *base, const ella_node *tip,
    const ella_real w_ext[6], const ella_real m_eta[3], const ella_real f_eta[3], const ella_real tau[1])
{

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real t1 = tip->Lambda[15] + c->body0_mass;
    const ella_real t2 = tip->Lambda[18] + c->body0_mass;
    const ella_real t3 = tip->Lambda[20] + c->body0_mass;
    const ella_real t4 = tip->Lambda[0] * link->b_T[0] + tip->Lambda[1] * link->b_T[1]
        + tip->Lambda[2] * link->b_T[2] + tip->Lambda[3] * link->b_T[3];
    const ella_real t5 = tip->Lambda[1] * link->b_T[0] + tip->Lambda[6] * link->b_T[1]
        + tip->Lambda[7] * link->b_T[2] + tip->Lambda[8] * link->b_T[3];
    const ella_real t6 = tip->Lambda[2] * link->b_T[0] + tip->Lambda[7] * link->b_T[1]
        + tip->Lambda[11] * link->b_T[2] + tip->Lambda[12] * link->b_T[3];
    const ella_real t7 = tip->Lambda[3] * link->b_T[0] + tip->Lambda[8] * link->b_T[1]
        + tip->Lambda[12] * link->b_T[2] + t1 * link->b_T[3];
    const ella_real t8 = tip->Lambda[4] * link->b_T[0] + tip->Lambda[9] * link->b_T[1]
        + tip->Lambda[13] * link->b_T[2] + tip->Lambda[16] * link->b_T[3];
    const ella_real t9 = tip->Lambda[5] * link->b_T[0] + tip->Lambda[10] * link->b_T[1]
        + tip->Lambda[14] * link->b_T[2] + tip->Lambda[17] * link->b_T[3];
    const ella_real t10 = tip->p[0] - w_ext[0]
        + (t4 + tip->Lambda[4] * link->b_T[4] + tip->Lambda[5] * link->b_T[5]);
    const ella_real t11 = tip->p[1] - w_ext[1]
        + (t5 + tip->Lambda[9] * link->b_T[4] + tip->Lambda[10] * link->b_T[5]);
    const ella_real t12 = tip->p[2] - w_ext[2]
        + (t6 + tip->Lambda[13] * link->b_T[4] + tip->Lambda[14] * link->b_T[5]);
    const ella_real t13 = tip->p[3] + link->h_T[0] - w_ext[3]
        + (t7 + tip->Lambda[16] * link->b_T[4] + tip->Lambda[17] * link->b_T[5]);
    const ella_real t14 = tip->p[4] + link->h_T[1] - w_ext[4]
        + (t8 + t2 * link->b_T[4] + tip->Lambda[19] * link->b_T[5]);
    const ella_real t15 = tip->p[5] + link->h_T[2] - w_ext[5]
        + (t9 + tip->Lambda[19] * link->b_T[4] + t3 * link->b_T[5]);
    const ella_real t16 = tip->Lambda[1] * link->R_T[1];
    const ella_real t17 = tip->Lambda[2] * link->R_T[2];
    const ella_real t18 = tip->Lambda[0] * link->R_T[1] + tip->Lambda[1] * link->R_T[3]
        + tip->Lambda[2] * link->R_T[4];
    const ella_real t19 = tip->Lambda[1] * link->R_T[4] - tip->Lambda[0] * link->R_T[2]
        + tip->Lambda[2] * link->R_T[5];
    const ella_real t20 = tip->Lambda[7] * link->R_T[4];
    const ella_real t21 = t16 + tip->Lambda[6] * link->R_T[3] + t20;
    const ella_real t22 = tip->Lambda[6] * link->R_T[4] - tip->Lambda[1] * link->R_T[2]
        + tip->Lambda[7] * link->R_T[5];
    const ella_real t23 = tip->Lambda[2] * link->R_T[1] + tip->Lambda[7] * link->R_T[3]
        + tip->Lambda[11] * link->R_T[4];
    const ella_real t24 = t20 - t17 + tip->Lambda[11] * link->R_T[5];
    const ella_real t25 = link->R_T[1]
        * (tip->Lambda[1] * link->R_T[0] - tip->Lambda[6] * link->R_T[1] + tip->Lambda[7] * link->R_T[2]);
    const ella_real t26 = link->R_T[2]
        * (tip->Lambda[2] * link->R_T[0] - tip->Lambda[7] * link->R_T[1] + tip->Lambda[11] * link->R_T[2]);
    const ella_real Lambda_T_11 = link->R_T[0] * (tip->Lambda[0] * link->R_T[0] - t16 + t17) - t25 + t26;
    const ella_real Lambda_T_12 = link->R_T[0] * t18 - link->R_T[1] * t21 + link->R_T[2] * t23;
    const ella_real Lambda_T_13 = link->R_T[0] * t19 - link->R_T[1] * t22 + link->R_T[2] * t24;
    const ella_real Lambda_T_22 = link->R_T[1] * t18 + link->R_T[3] * t21 + link->R_T[4] * t23;
    const ella_real Lambda_T_23 = link->R_T[1] * t19 + link->R_T[3] * t22 + link->R_T[4] * t24;
    const ella_real Lambda_T_33 = link->R_T[4] * t22 - link->R_T[2] * t19 + link->R_T[5] * t24;
    const ella_real t27 = tip->Lambda[3] * link->R_T[0] - tip->Lambda[4] * link->R_T[1]
        + tip->Lambda[5] * link->R_T[2];
    const ella_real t28 = tip->Lambda[3] * link->R_T[1] + tip->Lambda[4] * link->R_T[3]
        + tip->Lambda[5] * link->R_T[4];
    const ella_real t29 = tip->Lambda[4] * link->R_T[4] - tip->Lambda[3] * link->R_T[2]
        + tip->Lambda[5] * link->R_T[5];
    const ella_real t30 = tip->Lambda[8] * link->R_T[0] - tip->Lambda[9] * link->R_T[1]
        + tip->Lambda[10] * link->R_T[2];
    const ella_real t31 = tip->Lambda[8] * link->R_T[1] + tip->Lambda[9] * link->R_T[3]
        + tip->Lambda[10] * link->R_T[4];
    const ella_real t32 = tip->Lambda[9] * link->R_T[4] - tip->Lambda[8] * link->R_T[2]
        + tip->Lambda[10] * link->R_T[5];
    const ella_real t33 = tip->Lambda[12] * link->R_T[0] - tip->Lambda[13] * link->R_T[1]
        + tip->Lambda[14] * link->R_T[2];
    const ella_real t34 = tip->Lambda[12] * link->R_T[1] + tip->Lambda[13] * link->R_T[3]
        + tip->Lambda[14] * link->R_T[4];
    const ella_real t35 = tip->Lambda[13] * link->R_T[4] - tip->Lambda[12] * link->R_T[2]
        + tip->Lambda[14] * link->R_T[5];
    const ella_real Lambda_T_14 = link->R_T[0] * t27 - link->R_T[1] * t30 + link->R_T[2] * t33;
    const ella_real Lambda_T_15 = link->R_T[0] * t28 - link->R_T[1] * t31 + link->R_T[2] * t34;
    const ella_real Lambda_T_16 = link->R_T[0] * t29 - link->R_T[1] * t32 + link->R_T[2] * t35;
    const ella_real Lambda_T_24 = link->R_T[1] * t27 + link->R_T[3] * t30 + link->R_T[4] * t33;
    const ella_real Lambda_T_25 = link->R_T[1] * t28 + link->R_T[3] * t31 + link->R_T[4] * t34;
    const ella_real Lambda_T_26 = link->R_T[1] * t29 + link->R_T[3] * t32 + link->R_T[4] * t35;
    const ella_real Lambda_T_34 = link->R_T[4] * t30 - link->R_T[2] * t27 + link->R_T[5] * t33;
    const ella_real Lambda_T_35 = link->R_T[4] * t31 - link->R_T[2] * t28 + link->R_T[5] * t34;
    const ella_real Lambda_T_36 = link->R_T[4] * t32 - link->R_T[2] * t29 + link->R_T[5] * t35;
    const ella_real t36 = tip->Lambda[16] * link->R_T[1];
    const ella_real t37 = tip->Lambda[17] * link->R_T[2];
    const ella_real t38 = t1 * link->R_T[1] + tip->Lambda[16] * link->R_T[3] + tip->Lambda[17] * link->R_T[4];
    const ella_real t39 = tip->Lambda[16] * link->R_T[4] - t1 * link->R_T[2] + tip->Lambda[17] * link->R_T[5];
    const ella_real t40 = tip->Lambda[19] * link->R_T[4];
    const ella_real t41 = t36 + t2 * link->R_T[3] + t40;
    const ella_real t42 = t2 * link->R_T[4] - tip->Lambda[16] * link->R_T[2] + tip->Lambda[19] * link->R_T[5];
    const ella_real t43 = tip->Lambda[17] * link->R_T[1] + tip->Lambda[19] * link->R_T[3] + t3 * link->R_T[4];
    const ella_real t44 = t40 - t37 + t3 * link->R_T[5];
    const ella_real t45 = link->R_T[1]
        * (tip->Lambda[16] * link->R_T[0] - t2 * link->R_T[1] + tip->Lambda[19] * link->R_T[2]);
    const ella_real t46 = link->R_T[2]
        * (tip->Lambda[17] * link->R_T[0] - tip->Lambda[19] * link->R_T[1] + t3 * link->R_T[2]);
    const ella_real Lambda_T_44 = link->R_T[0] * (t1 * link->R_T[0] - t36 + t37) - t45 + t46;
    const ella_real Lambda_T_45 = link->R_T[0] * t38 - link->R_T[1] * t41 + link->R_T[2] * t43;
    const ella_real Lambda_T_46 = link->R_T[0] * t39 - link->R_T[1] * t42 + link->R_T[2] * t44;
    const ella_real Lambda_T_55 = link->R_T[1] * t38 + link->R_T[3] * t41 + link->R_T[4] * t43;
    const ella_real Lambda_T_56 = link->R_T[1] * t39 + link->R_T[3] * t42 + link->R_T[4] * t44;
    const ella_real Lambda_T_66 = link->R_T[4] * t42 - link->R_T[2] * t39 + link->R_T[5] * t44;
    const ella_real p_T_1 = link->R_T[0] * t10 - link->R_T[1] * t11 + link->R_T[2] * t12;
    const ella_real p_T_2 = link->R_T[1] * t10 + link->R_T[3] * t11 + link->R_T[4] * t12;
    const ella_real p_T_3 = link->R_T[4] * t11 - link->R_T[2] * t10 + link->R_T[5] * t12;
    const ella_real p_T_4 = link->R_T[0] * t13 - link->R_T[1] * t14 + link->R_T[2] * t15;
    const ella_real p_T_5 = link->R_T[1] * t13 + link->R_T[3] * t14 + link->R_T[4] * t15;
    const ella_real p_T_6 = link->R_T[4] * t14 - link->R_T[2] * t13 + link->R_T[5] * t15;

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real t47 = link->r_T[2] * Lambda_T_45;
    const ella_real t48 = link->r_T[1] * Lambda_T_46;
    const ella_real t49 = link->r_T[0] * Lambda_T_56;
    const ella_real M_loaded_14 = Lambda_T_14 + (t48 - t47);
    const ella_real t50 = Lambda_T_15 + (link->r_T[1] * Lambda_T_56 - link->r_T[2] * Lambda_T_55);
    const ella_real t51 = Lambda_T_16 + (link->r_T[1] * Lambda_T_66 - link->r_T[2] * Lambda_T_56);
    const ella_real t52 = Lambda_T_24 + (link->r_T[2] * Lambda_T_44 - link->r_T[0] * Lambda_T_46);
    const ella_real M_loaded_25 = Lambda_T_25 + (t47 - t49);
    const ella_real t53 = Lambda_T_26 + (link->r_T[2] * Lambda_T_46 - link->r_T[0] * Lambda_T_66);
    const ella_real t54 = Lambda_T_34 + (link->r_T[0] * Lambda_T_45 - link->r_T[1] * Lambda_T_44);
    const ella_real t55 = Lambda_T_35 + (link->r_T[0] * Lambda_T_55 - link->r_T[1] * Lambda_T_45);
    const ella_real M_loaded_36 = Lambda_T_36 + (t49 - t48);
    const ella_real t56 = Lambda_T_11 - (Lambda_T_15 * link->r_T[2] - Lambda_T_16 * link->r_T[1])
        + (link->r_T[1] * t51 - link->r_T[2] * t50);
    const ella_real t57 = Lambda_T_12 - (Lambda_T_16 * link->r_T[0] - Lambda_T_14 * link->r_T[2])
        + (link->r_T[1] * t53 - link->r_T[2] * M_loaded_25);
    const ella_real t58 = Lambda_T_13 - (Lambda_T_14 * link->r_T[1] - Lambda_T_15 * link->r_T[0])
        + (link->r_T[1] * M_loaded_36 - link->r_T[2] * t55);
    const ella_real t59 = Lambda_T_22 - (Lambda_T_26 * link->r_T[0] - Lambda_T_24 * link->r_T[2])
        + (link->r_T[2] * t52 - link->r_T[0] * t53);
    const ella_real t60 = Lambda_T_23 - (Lambda_T_24 * link->r_T[1] - Lambda_T_25 * link->r_T[0])
        + (link->r_T[2] * t54 - link->r_T[0] * M_loaded_36);
    const ella_real t61 = Lambda_T_33 - (Lambda_T_34 * link->r_T[1] - Lambda_T_35 * link->r_T[0])
        + (link->r_T[0] * t55 - link->r_T[1] * t54);
    const ella_real M_loaded_11 = link->M_V[0] + t56;
    const ella_real M_loaded_12 = t57 - link->M_V[1];
    const ella_real M_loaded_13 = t58 - link->M_V[2];
    const ella_real M_loaded_15 = t50 - link->M_V[3];
    const ella_real M_loaded_16 = link->M_V[4] + t51;
    const ella_real M_loaded_22 = link->M_V[5] + t59;
    const ella_real M_loaded_23 = t60 - link->M_V[6];
    const ella_real M_loaded_24 = link->M_V[3] + t52;
    const ella_real M_loaded_26 = t53 - link->M_V[7];
    const ella_real M_loaded_33 = link->M_V[8] + t61;
    const ella_real M_loaded_34 = t54 - link->M_V[4];
    const ella_real M_loaded_35 = link->M_V[7] + t55;
    const ella_real M_loaded_44 = c->mu + Lambda_T_44;
    const ella_real M_loaded_55 = c->mu + Lambda_T_55;
    const ella_real M_loaded_66 = c->mu + Lambda_T_66;
    const ella_real h_loaded_1 = link->h_V[0] + (p_T_1 + (link->r_T[1] * p_T_6 - link->r_T[2] * p_T_5));
    const ella_real h_loaded_2 = link->h_V[1] + (p_T_2 + (link->r_T[2] * p_T_4 - link->r_T[0] * p_T_6));
    const ella_real h_loaded_3 = link->h_V[2] + (p_T_3 + (link->r_T[0] * p_T_5 - link->r_T[1] * p_T_4));
    const ella_real h_loaded_4 = link->h_V[3] + p_T_4;
    const ella_real h_loaded_5 = link->h_V[4] + p_T_5;
    const ella_real h_loaded_6 = link->h_V[5] + p_T_6;
    const ella_real t62 = Lambda_T_12 * link->G[3] - Lambda_T_11 * link->G[1] + Lambda_T_13 * link->G[4];
    const ella_real t63 = Lambda_T_11 * link->G[2] + Lambda_T_12 * link->G[4] + Lambda_T_13 * link->G[5];
    const ella_real t64 = Lambda_T_23 * link->G[4];
    const ella_real t65 = Lambda_T_22 * link->G[3] - Lambda_T_12 * link->G[1] + t64;
    const ella_real t66 = Lambda_T_12 * link->G[2] + Lambda_T_22 * link->G[4] + Lambda_T_23 * link->G[5];
    const ella_real t67 = Lambda_T_23 * link->G[3] - Lambda_T_13 * link->G[1] + Lambda_T_33 * link->G[4];
    const ella_real t68 = Lambda_T_13 * link->G[2] + t64 + Lambda_T_33 * link->G[5];
    const ella_real t69 = Lambda_T_15 * link->G[2] + Lambda_T_25 * link->G[4] + Lambda_T_35 * link->G[5];
    const ella_real t70 = Lambda_T_26 * link->G[3] - Lambda_T_16 * link->G[1] + Lambda_T_36 * link->G[4];
    const ella_real t71 = Lambda_T_16 * link->G[2] + Lambda_T_26 * link->G[4] + Lambda_T_36 * link->G[5];
    const ella_real t72 = Lambda_T_44 * REAL(1.4142135623730951);
    const ella_real C_42 = (Lambda_T_14 * link->G[2] + Lambda_T_24 * link->G[4] + Lambda_T_34 * link->G[5])
        * c->Psi_c_z2 + Lambda_T_45 * 2;
    const ella_real C_43 = (Lambda_T_24 * link->G[3] - Lambda_T_14 * link->G[1] + Lambda_T_34 * link->G[4])
        * c->Psi_c_y3 + Lambda_T_46 * 2;
    const ella_real C_51 = Lambda_T_45 * REAL(1.4142135623730951);
    const ella_real t73 = t69 * c->Psi_c_z2 + Lambda_T_55 * 2;
    const ella_real t74 = Lambda_T_56 * 2;
    const ella_real C_53 = (Lambda_T_25 * link->G[3] - Lambda_T_15 * link->G[1] + Lambda_T_35 * link->G[4])
        * c->Psi_c_y3 + t74;
    const ella_real C_61 = Lambda_T_46 * REAL(1.4142135623730951);
    const ella_real C_62 = t71 * c->Psi_c_z2 + t74;
    const ella_real t75 = t70 * c->Psi_c_y3 + Lambda_T_66 * 2;
    const ella_real C_11 = Lambda_T_14 * REAL(1.4142135623730951) + (link->r_T[1] * C_61 - link->r_T[2] * C_51);
    const ella_real C_22 = t66 * c->Psi_c_z2 + Lambda_T_25 * 2 + (link->r_T[2] * C_42 - link->r_T[0] * C_62);
    const ella_real C_33 = t67 * c->Psi_c_y3 + Lambda_T_36 * 2 + (link->r_T[0] * C_53 - link->r_T[1] * C_43);
    const ella_real C_12 = t63 * c->Psi_c_z2 + Lambda_T_15 * 2 + (link->r_T[1] * C_62 - link->r_T[2] * t73)
        - link->M_D[0];
    const ella_real C_13 = link->M_D[1]
        + (t62 * c->Psi_c_y3 + Lambda_T_16 * 2 + (link->r_T[1] * t75 - link->r_T[2] * C_53));
    const ella_real C_21 = link->M_D[2]
        + (Lambda_T_24 * REAL(1.4142135623730951) + (link->r_T[2] * t72 - link->r_T[0] * C_61));
    const ella_real C_23 = t65 * c->Psi_c_y3 + Lambda_T_26 * 2 + (link->r_T[2] * C_43 - link->r_T[0] * t75)
        - link->M_D[3];
    const ella_real C_31 = Lambda_T_34 * REAL(1.4142135623730951) + (link->r_T[0] * C_51 - link->r_T[1] * t72)
        - link->M_D[4];
    const ella_real C_32 = link->M_D[5]
        + (t68 * c->Psi_c_z2 + Lambda_T_35 * 2 + (link->r_T[0] * t73 - link->r_T[1] * C_42));
    const ella_real C_41 = c->sigma_x1 + t72;
    const ella_real C_52 = c->sigma_y2 + t73;
    const ella_real C_63 = c->sigma_z3 + t75;
    const ella_real modal_inertia_12 = C_42 * REAL(1.4142135623730951);
    const ella_real modal_inertia_13 = C_43 * REAL(1.4142135623730951);
    const ella_real t76 = c->Psi_c_z2
        * ((link->G[2] * t63 + link->G[4] * t66 + link->G[5] * t68) * c->Psi_c_z2 + t69 * 2) + t73 * 2;
    const ella_real modal_inertia_23 = c->Psi_c_z2
        * ((link->G[3] * t66 - link->G[1] * t63 + link->G[4] * t68) * c->Psi_c_y3 + t71 * 2) + C_53 * 2;
    const ella_real t77 = c->Psi_c_y3
        * ((link->G[3] * t65 - link->G[1] * t62 + link->G[4] * t67) * c->Psi_c_y3 + t70 * 2) + t75 * 2;
    const ella_real modal_inertia_11 = Lambda_T_44 * REAL(2.0000000000000004) + m_eta[0];
    if (!(modal_inertia_11 > 0)) { return ELLA_SINGULAR; }
    const ella_real modal_inertia_22 = t76 + m_eta[1];
    const ella_real modal_inertia_33 = t77 + m_eta[2];
    const ella_real h_phi_1 = link->h_eta[0] + f_eta[0] + p_T_4 * REAL(1.4142135623730951);
    const ella_real h_phi_2 = link->h_eta[1] + f_eta[1]
        + (c->Psi_c_z2 * (link->G[2] * p_T_1 + link->G[4] * p_T_2 + link->G[5] * p_T_3) + p_T_5 * 2);
    const ella_real h_phi_3 = link->h_eta[2] + f_eta[2]
        + (c->Psi_c_y3 * (link->G[3] * p_T_2 - link->G[1] * p_T_1 + link->G[4] * p_T_3) + p_T_6 * 2);
    const ella_real modes_inverse_1 = 1 / modal_inertia_11;
    const ella_real modes_L_21 = modal_inertia_12 * modes_inverse_1;
    const ella_real modes_L_31 = modal_inertia_13 * modes_inverse_1;
    const ella_real t78 = modal_inertia_22 - modal_inertia_12 * modes_L_21;
    if (!(t78 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_2 = 1 / t78;
    const ella_real t79 = modal_inertia_23 - modal_inertia_12 * modes_L_31;
    const ella_real modes_L_32 = t79 * modes_inverse_2;
    const ella_real t80 = modal_inertia_33 - (modal_inertia_13 * modes_L_31 + t79 * modes_L_32);
    if (!(t80 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_3 = 1 / t80;
    const ella_real t81 = C_12 - modes_L_21 * C_11;
    const ella_real t82 = C_22 - modes_L_21 * C_21;
    const ella_real t83 = C_32 - modes_L_21 * C_31;
    const ella_real t84 = C_42 - modes_L_21 * C_41;
    const ella_real t85 = C_52 - modes_L_21 * C_51;
    const ella_real t86 = C_62 - modes_L_21 * C_61;
    const ella_real t87 = C_13 - modes_L_31 * C_11 - modes_L_32 * t81;
    const ella_real t88 = C_23 - modes_L_31 * C_21 - modes_L_32 * t82;
    const ella_real t89 = C_33 - modes_L_31 * C_31 - modes_L_32 * t83;
    const ella_real t90 = C_43 - modes_L_31 * C_41 - modes_L_32 * t84;
    const ella_real t91 = C_53 - modes_L_31 * C_51 - modes_L_32 * t85;
    const ella_real t92 = C_63 - modes_L_31 * C_61 - modes_L_32 * t86;
    const ella_real t93 = h_phi_2 - modes_L_21 * h_phi_1;
    const ella_real t94 = h_phi_3 - modes_L_31 * h_phi_1 - modes_L_32 * t93;
    const ella_real modes_W_11 = C_11 * modes_inverse_1;
    const ella_real modes_W_12 = C_21 * modes_inverse_1;
    const ella_real modes_W_13 = C_31 * modes_inverse_1;
    const ella_real modes_W_14 = C_41 * modes_inverse_1;
    const ella_real modes_W_15 = C_51 * modes_inverse_1;
    const ella_real modes_W_16 = C_61 * modes_inverse_1;
    const ella_real modes_W_21 = t81 * modes_inverse_2;
    const ella_real modes_W_22 = t82 * modes_inverse_2;
    const ella_real modes_W_23 = t83 * modes_inverse_2;
    const ella_real modes_W_24 = t84 * modes_inverse_2;
    const ella_real modes_W_25 = t85 * modes_inverse_2;
    const ella_real modes_W_26 = t86 * modes_inverse_2;
    const ella_real modes_W_31 = t87 * modes_inverse_3;
    const ella_real modes_W_32 = t88 * modes_inverse_3;
    const ella_real modes_W_33 = t89 * modes_inverse_3;
    const ella_real modes_W_34 = t90 * modes_inverse_3;
    const ella_real modes_W_35 = t91 * modes_inverse_3;
    const ella_real modes_W_36 = t92 * modes_inverse_3;
    const ella_real modes_w_1 = h_phi_1 * modes_inverse_1;
    const ella_real modes_w_2 = t93 * modes_inverse_2;
    const ella_real modes_w_3 = t94 * modes_inverse_3;
    const ella_real M_i_11 = M_loaded_11 - (C_11 * modes_W_11 + t81 * modes_W_21 + t87 * modes_W_31);
    const ella_real M_i_12 = M_loaded_12 - (C_11 * modes_W_12 + t81 * modes_W_22 + t87 * modes_W_32);
    const ella_real M_i_13 = M_loaded_13 - (C_11 * modes_W_13 + t81 * modes_W_23 + t87 * modes_W_33);
    const ella_real M_i_14 = M_loaded_14 - (C_11 * modes_W_14 + t81 * modes_W_24 + t87 * modes_W_34);
    const ella_real M_i_15 = M_loaded_15 - (C_11 * modes_W_15 + t81 * modes_W_25 + t87 * modes_W_35);
    const ella_real M_i_16 = M_loaded_16 - (C_11 * modes_W_16 + t81 * modes_W_26 + t87 * modes_W_36);
    const ella_real M_i_22 = M_loaded_22 - (C_21 * modes_W_12 + t82 * modes_W_22 + t88 * modes_W_32);
    const ella_real M_i_23 = M_loaded_23 - (C_21 * modes_W_13 + t82 * modes_W_23 + t88 * modes_W_33);
    const ella_real M_i_24 = M_loaded_24 - (C_21 * modes_W_14 + t82 * modes_W_24 + t88 * modes_W_34);
    const ella_real M_i_25 = M_loaded_25 - (C_21 * modes_W_15 + t82 * modes_W_25 + t88 * modes_W_35);
    const ella_real M_i_26 = M_loaded_26 - (C_21 * modes_W_16 + t82 * modes_W_26 + t88 * modes_W_36);
    const ella_real M_i_33 = M_loaded_33 - (C_31 * modes_W_13 + t83 * modes_W_23 + t89 * modes_W_33);
    const ella_real M_i_34 = M_loaded_34 - (C_31 * modes_W_14 + t83 * modes_W_24 + t89 * modes_W_34);
    const ella_real M_i_35 = M_loaded_35 - (C_31 * modes_W_15 + t83 * modes_W_25 + t89 * modes_W_35);
    const ella_real M_i_36 = M_loaded_36 - (C_31 * modes_W_16 + t83 * modes_W_26 + t89 * modes_W_36);
    const ella_real M_i_44 = M_loaded_44 - (C_41 * modes_W_14 + t84 * modes_W_24 + t90 * modes_W_34);
    const ella_real M_i_45 = Lambda_T_45 - (C_41 * modes_W_15 + t84 * modes_W_25 + t90 * modes_W_35);
    const ella_real M_i_46 = Lambda_T_46 - (C_41 * modes_W_16 + t84 * modes_W_26 + t90 * modes_W_36);
    const ella_real M_i_55 = M_loaded_55 - (C_51 * modes_W_15 + t85 * modes_W_25 + t91 * modes_W_35);
    const ella_real M_i_56 = Lambda_T_56 - (C_51 * modes_W_16 + t85 * modes_W_26 + t91 * modes_W_36);
    const ella_real M_i_66 = M_loaded_66 - (C_61 * modes_W_16 + t86 * modes_W_26 + t92 * modes_W_36);
    const ella_real h_i_1 = h_loaded_1 - (modes_W_11 * h_phi_1 + modes_W_21 * t93 + modes_W_31 * t94);
    const ella_real h_i_2 = h_loaded_2 - (modes_W_12 * h_phi_1 + modes_W_22 * t93 + modes_W_32 * t94);
    const ella_real h_i_3 = h_loaded_3 - (modes_W_13 * h_phi_1 + modes_W_23 * t93 + modes_W_33 * t94);
    const ella_real h_i_4 = h_loaded_4 - (modes_W_14 * h_phi_1 + modes_W_24 * t93 + modes_W_34 * t94);
    const ella_real h_i_5 = h_loaded_5 - (modes_W_15 * h_phi_1 + modes_W_25 * t93 + modes_W_35 * t94);
    const ella_real h_i_6 = h_loaded_6 - (modes_W_16 * h_phi_1 + modes_W_26 * t93 + modes_W_36 * t94);

    /* joint: its accelerations eliminated from its rows (43) */
    const ella_real t95 = M_i_11 * link->beta[0] - M_i_12 * link->beta[1] + M_i_14 * link->beta[2]
        - M_i_15 * link->beta[3];
    const ella_real t96 = M_i_12 * link->beta[0] - M_i_22 * link->beta[1] + M_i_24 * link->beta[2]
        - M_i_25 * link->beta[3];
    const ella_real t97 = M_i_13 * link->beta[0] - M_i_23 * link->beta[1] + M_i_34 * link->beta[2]
        - M_i_35 * link->beta[3];
    const ella_real t98 = M_i_14 * link->beta[0] - M_i_24 * link->beta[1] + M_i_44 * link->beta[2]
        - M_i_45 * link->beta[3];
    const ella_real t99 = M_i_15 * link->beta[0] - M_i_25 * link->beta[1] + M_i_45 * link->beta[2]
        - M_i_55 * link->beta[3];
    const ella_real t100 = M_i_16 * link->beta[0] - M_i_26 * link->beta[1] + M_i_46 * link->beta[2]
        - M_i_56 * link->beta[3];
    const ella_real bias_1 = h_i_1 + t95;
    const ella_real bias_2 = h_i_2 + t96;
    const ella_real bias_3 = h_i_3 + t97;
    const ella_real bias_4 = h_i_4 + t98;
    const ella_real bias_5 = h_i_5 + t99;
    const ella_real bias_6 = h_i_6 + t100;
    if (!(M_i_33 - ELLA_REAL_EPSILON * 8 * (M_i_11 + M_i_22 + M_i_33) > 0)) { return ELLA_SINGULAR; }
    const ella_real joint_inverse_1 = 1 / M_i_33;
    const ella_real joint_W_11 = M_i_13 * joint_inverse_1;
    const ella_real joint_W_12 = M_i_23 * joint_inverse_1;
    const ella_real joint_W_14 = M_i_34 * joint_inverse_1;
    const ella_real joint_W_15 = M_i_35 * joint_inverse_1;
    const ella_real joint_W_16 = M_i_36 * joint_inverse_1;
    const ella_real joint_w_1 = (tau[0] - bias_3) * joint_inverse_1;
    const ella_real Lambda_i_11 = M_i_11 - M_i_13 * joint_W_11;
    const ella_real Lambda_i_12 = M_i_12 - M_i_13 * joint_W_12;
    const ella_real Lambda_i_14 = M_i_14 - M_i_13 * joint_W_14;
    const ella_real Lambda_i_15 = M_i_15 - M_i_13 * joint_W_15;
    const ella_real Lambda_i_16 = M_i_16 - M_i_13 * joint_W_16;
    const ella_real Lambda_i_22 = M_i_22 - M_i_23 * joint_W_12;
    const ella_real Lambda_i_24 = M_i_24 - M_i_23 * joint_W_14;
    const ella_real Lambda_i_25 = M_i_25 - M_i_23 * joint_W_15;
    const ella_real Lambda_i_26 = M_i_26 - M_i_23 * joint_W_16;
    const ella_real Lambda_i_44 = M_i_44 - M_i_34 * joint_W_14;
    const ella_real Lambda_i_45 = M_i_45 - M_i_34 * joint_W_15;
    const ella_real Lambda_i_46 = M_i_46 - M_i_34 * joint_W_16;
    const ella_real Lambda_i_55 = M_i_55 - M_i_35 * joint_W_15;
    const ella_real Lambda_i_56 = M_i_56 - M_i_35 * joint_W_16;
    const ella_real Lambda_i_66 = M_i_66 - M_i_36 * joint_W_16;
    const ella_real p_i_1 = bias_1 + M_i_13 * joint_w_1;
    const ella_real p_i_2 = bias_2 + M_i_23 * joint_w_1;
    const ella_real p_i_4 = bias_4 + M_i_34 * joint_w_1;
    const ella_real p_i_5 = bias_5 + M_i_35 * joint_w_1;
    const ella_real p_i_6 = bias_6 + M_i_36 * joint_w_1;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const ella_real t101 = Lambda_i_12 * link->R_rel[1];
    const ella_real t102 = Lambda_i_12 * link->R_rel[0];
    const ella_real t103 = Lambda_i_11 * link->R_rel[1] + t102;
    const ella_real t104 = t101 + Lambda_i_22 * link->R_rel[0];
    const ella_real Lambda_1 = link->R_rel[0] * (Lambda_i_11 * link->R_rel[0] - t101)
        - link->R_rel[1] * (t102 - Lambda_i_22 * link->R_rel[1]);
    const ella_real Lambda_2 = link->R_rel[0] * t103 - link->R_rel[1] * t104;
    const ella_real Lambda_7 = link->R_rel[1] * t103 + link->R_rel[0] * t104;
    const ella_real t105 = Lambda_i_14 * link->R_rel[0] - Lambda_i_15 * link->R_rel[1];
    const ella_real t106 = Lambda_i_14 * link->R_rel[1] + Lambda_i_15 * link->R_rel[0];
    const ella_real t107 = Lambda_i_24 * link->R_rel[0] - Lambda_i_25 * link->R_rel[1];
    const ella_real t108 = Lambda_i_24 * link->R_rel[1] + Lambda_i_25 * link->R_rel[0];
    const ella_real Lambda_4 = link->R_rel[0] * t105 - link->R_rel[1] * t107;
    const ella_real Lambda_5 = link->R_rel[0] * t106 - link->R_rel[1] * t108;
    const ella_real Lambda_6 = link->R_rel[0] * Lambda_i_16 - link->R_rel[1] * Lambda_i_26;
    const ella_real Lambda_9 = link->R_rel[1] * t105 + link->R_rel[0] * t107;
    const ella_real Lambda_10 = link->R_rel[1] * t106 + link->R_rel[0] * t108;
    const ella_real Lambda_11 = link->R_rel[1] * Lambda_i_16 + link->R_rel[0] * Lambda_i_26;
    const ella_real t109 = Lambda_i_45 * link->R_rel[1];
    const ella_real t110 = Lambda_i_45 * link->R_rel[0];
    const ella_real t111 = Lambda_i_44 * link->R_rel[1] + t110;
    const ella_real t112 = t109 + Lambda_i_55 * link->R_rel[0];
    const ella_real Lambda_18 = Lambda_i_46 * link->R_rel[0] - Lambda_i_56 * link->R_rel[1];
    const ella_real Lambda_20 = Lambda_i_46 * link->R_rel[1] + Lambda_i_56 * link->R_rel[0];
    const ella_real Lambda_16 = link->R_rel[0] * (Lambda_i_44 * link->R_rel[0] - t109)
        - link->R_rel[1] * (t110 - Lambda_i_55 * link->R_rel[1]);
    const ella_real Lambda_17 = link->R_rel[0] * t111 - link->R_rel[1] * t112;
    const ella_real Lambda_19 = link->R_rel[1] * t111 + link->R_rel[0] * t112;
    const ella_real p_1 = link->R_rel[0] * p_i_1 - link->R_rel[1] * p_i_2;
    const ella_real p_2 = link->R_rel[1] * p_i_1 + link->R_rel[0] * p_i_2;
    const ella_real p_4 = link->R_rel[0] * p_i_4 - link->R_rel[1] * p_i_5;
    const ella_real p_5 = link->R_rel[1] * p_i_4 + link->R_rel[0] * p_i_5;

    /* outputs */
    link->modes_L[0] = modes_L_21;
    link->modes_L[1] = modes_L_31;
    link->modes_L[2] = modes_L_32;
    link->modes_W[0] = modes_W_11;
    link->modes_W[1] = modes_W_12;
    link->modes_W[2] = modes_W_13;
    link->modes_W[3] = modes_W_14;
    link->modes_W[4] = modes_W_15;
    link->modes_W[5] = modes_W_16;
    link->modes_W[6] = modes_W_21;
    link->modes_W[7] = modes_W_22;
    link->modes_W[8] = modes_W_23;
    link->modes_W[9] = modes_W_24;
    link->modes_W[10] = modes_W_25;
    link->modes_W[11] = modes_W_26;
    link->modes_W[12] = modes_W_31;
    link->modes_W[13] = modes_W_32;
    link->modes_W[14] = modes_W_33;
    link->modes_W[15] = modes_W_34;
    link->modes_W[16] = modes_W_35;
    link->modes_W[17] = modes_W_36;
    link->modes_w[0] = modes_w_1;
    link->modes_w[1] = modes_w_2;
    link->modes_w[2] = modes_w_3;
    link->joint_W[0] = joint_W_11;
    link->joint_W[1] = joint_W_12;
    link->joint_W[2] = joint_W_14;
    link->joint_W[3] = joint_W_15;
    link->joint_W[4] = joint_W_16;
    link->joint_w[0] = joint_w_1;
    link->Lambda_i[0] = Lambda_i_11;
    link->Lambda_i[1] = Lambda_i_12;
    link->Lambda_i[2] = Lambda_i_14;
    link->Lambda_i[3] = Lambda_i_15;
    link->Lambda_i[4] = Lambda_i_16;
    link->Lambda_i[5] = Lambda_i_22;
    link->Lambda_i[6] = Lambda_i_24;
    link->Lambda_i[7] = Lambda_i_25;
    link->Lambda_i[8] = Lambda_i_26;
    link->Lambda_i[9] = Lambda_i_44;
    link->Lambda_i[10] = Lambda_i_45;
    link->Lambda_i[11] = Lambda_i_46;
    link->Lambda_i[12] = Lambda_i_55;
    link->Lambda_i[13] = Lambda_i_56;
    link->Lambda_i[14] = Lambda_i_66;
    link->p_i[0] = p_i_1;
    link->p_i[1] = p_i_2;
    link->p_i[2] = tau[0];
    link->p_i[3] = p_i_4;
    link->p_i[4] = p_i_5;
    link->p_i[5] = p_i_6;
    base->Lambda[0] = Lambda_1;
    base->Lambda[1] = Lambda_2;
    base->Lambda[2] = 0;
    base->Lambda[3] = Lambda_4;
    base->Lambda[4] = Lambda_5;
    base->Lambda[5] = Lambda_6;
    base->Lambda[6] = Lambda_7;
    base->Lambda[7] = 0;
    base->Lambda[8] = Lambda_9;
    base->Lambda[9] = Lambda_10;
    base->Lambda[10] = Lambda_11;
    base->Lambda[11] = 0;
    base->Lambda[12] = 0;
    base->Lambda[13] = 0;
    base->Lambda[14] = 0;
    base->Lambda[15] = Lambda_16;
    base->Lambda[16] = Lambda_17;
    base->Lambda[17] = Lambda_18;
    base->Lambda[18] = Lambda_19;
    base->Lambda[19] = Lambda_20;
    base->Lambda[20] = Lambda_i_66;
    base->p[0] = p_1;
    base->p[1] = p_2;
    base->p[2] = tau[0];
    base->p[3] = p_4;
    base->p[4] = p_5;
    base->p[5] = p_i_6;
    return ELLA_OK;
}

/* accelerate, links like upper_arm: 237 operations */
static ella_status accelerate_upper_arm(const ella_link_constants *c, const ella_link_store *link, const ella_node *base, ella_node *tip,
    ella_real qddot[2], ella_real wrench[6], ella_real alpha[6], ella_real etaddot[3])
{

    /* joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const ella_real carried_1 = link->R_rel[0] * base->alpha[0] + link->R_rel[3] * base->alpha[1]
        - link->R_rel[5] * base->alpha[2];
    const ella_real carried_2 = link->R_rel[4] * base->alpha[1] - link->R_rel[1] * base->alpha[0]
        + link->R_rel[6] * base->alpha[2];
    const ella_real carried_3 = link->R_rel[2] * base->alpha[0] + link->R_rel[7] * base->alpha[2];
    const ella_real carried_4 = link->R_rel[0] * base->alpha[3] + link->R_rel[3] * base->alpha[4]
        - link->R_rel[5] * base->alpha[5];
    const ella_real carried_5 = link->R_rel[4] * base->alpha[4] - link->R_rel[1] * base->alpha[3]
        + link->R_rel[6] * base->alpha[5];
    const ella_real carried_6 = link->R_rel[2] * base->alpha[3] + link->R_rel[7] * base->alpha[5];
    const ella_real t1 = link->joint_W[0] * carried_1 + link->joint_W[1] * carried_2
        + link->joint_W[2] * carried_3 + link->joint_W[3] * carried_4;
    const ella_real t2 = link->joint_W[6] * carried_1 + link->joint_W[7] * carried_2 + carried_3
        + link->joint_W[8] * carried_4;
    const ella_real qddot_2 = link->joint_w[1]
        - (t2 + link->joint_W[9] * carried_5 + link->joint_W[10] * carried_6);
    const ella_real qddot_1 = link->joint_w[0]
        - (t1 + link->joint_W[4] * carried_5 + link->joint_W[5] * carried_6) - link->joint_L[0] * qddot_2;
    const ella_real t3 = link->Lambda_i[0] * carried_1 + link->Lambda_i[1] * carried_2
        + link->Lambda_i[2] * carried_4 + link->Lambda_i[3] * carried_5;
    const ella_real t4 = link->Lambda_i[1] * carried_1 + link->Lambda_i[5] * carried_2
        + link->Lambda_i[6] * carried_4 + link->Lambda_i[7] * carried_5;
    const ella_real t5 = link->Lambda_i[2] * carried_1 + link->Lambda_i[6] * carried_2
        + link->Lambda_i[9] * carried_3 + link->Lambda_i[12] * carried_4;
    const ella_real t6 = link->Lambda_i[3] * carried_1 + link->Lambda_i[7] * carried_2
        + link->Lambda_i[10] * carried_3 + link->Lambda_i[13] * carried_4;
    const ella_real t7 = link->Lambda_i[4] * carried_1 + link->Lambda_i[8] * carried_2
        + link->Lambda_i[11] * carried_3 + link->Lambda_i[14] * carried_4;
    const ella_real wrench_1 = t3 + link->Lambda_i[4] * carried_6 + link->p_i[0];
    const ella_real wrench_2 = t4 + link->Lambda_i[8] * carried_6 + link->p_i[1];
    const ella_real wrench_3 = link->Lambda_i[9] * carried_4 + link->Lambda_i[10] * carried_5
        + link->Lambda_i[11] * carried_6 + link->p_i[2];
    const ella_real wrench_4 = t5 + link->Lambda_i[13] * carried_5 + link->Lambda_i[14] * carried_6
        + link->p_i[3];
    const ella_real wrench_5 = t6 + link->Lambda_i[15] * carried_5 + link->Lambda_i[16] * carried_6
        + link->p_i[4];
    const ella_real wrench_6 = t7 + link->Lambda_i[16] * carried_5 + link->Lambda_i[17] * carried_6
        + link->p_i[5];

    /* link: acceleration of F_i, modal accelerations (83) */
    const ella_real alpha_1 = carried_1 + link->A[0] * qddot_1 + link->beta[0];
    const ella_real alpha_2 = carried_2 + link->A[1] * qddot_1 + link->beta[1];
    const ella_real alpha_3 = carried_3 + qddot_2 + link->beta[2];
    const ella_real alpha_4 = carried_4 + link->beta[3];
    const ella_real alpha_5 = carried_5 + link->beta[4];
    const ella_real alpha_6 = carried_6 + link->beta[5];
    const ella_real t8 = link->modes_W[0] * alpha_1 + link->modes_W[1] * alpha_2 + link->modes_W[2] * alpha_3
        + link->modes_W[3] * alpha_4;
    const ella_real t9 = link->modes_W[6] * alpha_1 + link->modes_W[7] * alpha_2 + link->modes_W[8] * alpha_3
        + link->modes_W[9] * alpha_4;
    const ella_real t10 = link->modes_W[12] * alpha_1 + link->modes_W[13] * alpha_2 + link->modes_W[14] * alpha_3
        + link->modes_W[15] * alpha_4;
    const ella_real minus_etaddot_3 = link->modes_w[2]
        + (t10 + link->modes_W[16] * alpha_5 + link->modes_W[17] * alpha_6);
    const ella_real minus_etaddot_2 = link->modes_w[1]
        + (t9 + link->modes_W[10] * alpha_5 + link->modes_W[11] * alpha_6) - link->modes_L[2] * minus_etaddot_3;
    const ella_real t11 = link->modes_w[0] + (t8 + link->modes_W[4] * alpha_5 + link->modes_W[5] * alpha_6)
        - link->modes_L[0] * minus_etaddot_2;
    const ella_real minus_etaddot_1 = t11 - link->modes_L[1] * minus_etaddot_3;
    const ella_real t12 = -minus_etaddot_1;
    const ella_real t13 = -minus_etaddot_2;
    const ella_real t14 = -minus_etaddot_3;

    /* tip: acceleration of the tip section (accconst1b) */
    const ella_real t15 = c->Psi_c_y3 * minus_etaddot_3;
    const ella_real t16 = c->Psi_c_z2 * minus_etaddot_2;
    const ella_real t17 = alpha_1 + (link->G[1] * t15 - link->G[2] * t16);
    const ella_real t18 = alpha_2 - (link->G[3] * t15 + link->G[4] * t16);
    const ella_real t19 = alpha_3 - (link->G[4] * t15 + link->G[5] * t16);
    const ella_real t20 = alpha_4 + (alpha_2 * link->r_T[2] - alpha_3 * link->r_T[1])
        - minus_etaddot_1 * REAL(1.4142135623730951);
    const ella_real t21 = alpha_5 + (alpha_3 * link->r_T[0] - alpha_1 * link->r_T[2]) - minus_etaddot_2 * 2;
    const ella_real t22 = alpha_6 + (alpha_1 * link->r_T[1] - alpha_2 * link->r_T[0]) - minus_etaddot_3 * 2;
    const ella_real alpha_T_1 = link->R_T[0] * t17 + link->R_T[1] * t18 - link->R_T[2] * t19 + link->b_T[0];
    const ella_real alpha_T_2 = link->R_T[3] * t18 - link->R_T[1] * t17 + link->R_T[4] * t19 + link->b_T[1];
    const ella_real alpha_T_3 = link->R_T[2] * t17 + link->R_T[4] * t18 + link->R_T[5] * t19 + link->b_T[2];
    const ella_real alpha_T_4 = link->R_T[0] * t20 + link->R_T[1] * t21 - link->R_T[2] * t22 + link->b_T[3];
    const ella_real alpha_T_5 = link->R_T[3] * t21 - link->R_T[1] * t20 + link->R_T[4] * t22 + link->b_T[4];
    const ella_real alpha_T_6 = link->R_T[2] * t20 + link->R_T[4] * t21 + link->R_T[5] * t22 + link->b_T[5];

    /* outputs */
    qddot[0] = qddot_1;
    qddot[1] = qddot_2;
    wrench[0] = wrench_1;
    wrench[1] = wrench_2;
    wrench[2] = wrench_3;
    wrench[3] = wrench_4;
    wrench[4] = wrench_5;
    wrench[5] = wrench_6;
    alpha[0] = alpha_1;
    alpha[1] = alpha_2;
    alpha[2] = alpha_3;
    alpha[3] = alpha_4;
    alpha[4] = alpha_5;
    alpha[5] = alpha_6;
    etaddot[0] = t12;
    etaddot[1] = t13;
    etaddot[2] = t14;
    tip->alpha[0] = alpha_T_1;
    tip->alpha[1] = alpha_T_2;
    tip->alpha[2] = alpha_T_3;
    tip->alpha[3] = alpha_T_4;
    tip->alpha[4] = alpha_T_5;
    tip->alpha[5] = alpha_T_6;
    return ELLA_OK;
}

/* accelerate, links like forearm: 191 operations */
static ella_status accelerate_forearm(const ella_link_constants *c, const ella_link_store *link, const ella_node *base, ella_node *tip,
    ella_real qddot[1], ella_real wrench[6], ella_real alpha[6], ella_real etaddot[3])
{

    /* joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const ella_real carried_1 = link->R_rel[0] * base->alpha[0] + link->R_rel[1] * base->alpha[1];
    const ella_real carried_2 = link->R_rel[0] * base->alpha[1] - link->R_rel[1] * base->alpha[0];
    const ella_real carried_4 = link->R_rel[0] * base->alpha[3] + link->R_rel[1] * base->alpha[4];
    const ella_real carried_5 = link->R_rel[0] * base->alpha[4] - link->R_rel[1] * base->alpha[3];
    const ella_real t1 = link->joint_W[0] * carried_1 + link->joint_W[1] * carried_2 + base->alpha[2]
        + link->joint_W[2] * carried_4;
    const ella_real qddot_1 = link->joint_w[0]
        - (t1 + link->joint_W[3] * carried_5 + link->joint_W[4] * base->alpha[5]);
    const ella_real t2 = link->Lambda_i[0] * carried_1 + link->Lambda_i[1] * carried_2
        + link->Lambda_i[2] * carried_4 + link->Lambda_i[3] * carried_5;
    const ella_real t3 = link->Lambda_i[1] * carried_1 + link->Lambda_i[5] * carried_2
        + link->Lambda_i[6] * carried_4 + link->Lambda_i[7] * carried_5;
    const ella_real t4 = link->Lambda_i[2] * carried_1 + link->Lambda_i[6] * carried_2
        + link->Lambda_i[9] * carried_4 + link->Lambda_i[10] * carried_5;
    const ella_real t5 = link->Lambda_i[3] * carried_1 + link->Lambda_i[7] * carried_2
        + link->Lambda_i[10] * carried_4 + link->Lambda_i[12] * carried_5;
    const ella_real t6 = link->Lambda_i[4] * carried_1 + link->Lambda_i[8] * carried_2
        + link->Lambda_i[11] * carried_4 + link->Lambda_i[13] * carried_5;
    const ella_real wrench_1 = t2 + link->Lambda_i[4] * base->alpha[5] + link->p_i[0];
    const ella_real wrench_2 = t3 + link->Lambda_i[8] * base->alpha[5] + link->p_i[1];
    const ella_real wrench_4 = t4 + link->Lambda_i[11] * base->alpha[5] + link->p_i[3];
    const ella_real wrench_5 = t5 + link->Lambda_i[13] * base->alpha[5] + link->p_i[4];
    const ella_real wrench_6 = t6 + link->Lambda_i[14] * base->alpha[5] + link->p_i[5];

    /* link: acceleration of F_i, modal accelerations (83) */
    const ella_real alpha_3 = base->alpha[2] + qddot_1;
    const ella_real alpha_1 = carried_1 + link->beta[0];
    const ella_real alpha_2 = carried_2 - link->beta[1];
    const ella_real alpha_4 = carried_4 + link->beta[2];
    const ella_real alpha_5 = carried_5 - link->beta[3];
    const ella_real t7 = link->modes_W[0] * alpha_1 + link->modes_W[1] * alpha_2 + link->modes_W[2] * alpha_3
        + link->modes_W[3] * alpha_4;
    const ella_real t8 = link->modes_W[6] * alpha_1 + link->modes_W[7] * alpha_2 + link->modes_W[8] * alpha_3
        + link->modes_W[9] * alpha_4;
    const ella_real t9 = link->modes_W[12] * alpha_1 + link->modes_W[13] * alpha_2 + link->modes_W[14] * alpha_3
        + link->modes_W[15] * alpha_4;
    const ella_real minus_etaddot_3 = link->modes_w[2]
        + (t9 + link->modes_W[16] * alpha_5 + link->modes_W[17] * base->alpha[5]);
    const ella_real minus_etaddot_2 = link->modes_w[1]
        + (t8 + link->modes_W[10] * alpha_5 + link->modes_W[11] * base->alpha[5])
        - link->modes_L[2] * minus_etaddot_3;
    const ella_real t10 = link->modes_w[0]
        + (t7 + link->modes_W[4] * alpha_5 + link->modes_W[5] * base->alpha[5])
        - link->modes_L[0] * minus_etaddot_2;
    const ella_real minus_etaddot_1 = t10 - link->modes_L[1] * minus_etaddot_3;
    const ella_real t11 = -minus_etaddot_1;
    const ella_real t12 = -minus_etaddot_2;
    const ella_real t13 = -minus_etaddot_3;

    /* tip: acceleration of the tip section (accconst1b) */
    const ella_real t14 = c->Psi_c_y3 * minus_etaddot_3;
    const ella_real t15 = c->Psi_c_z2 * minus_etaddot_2;
    const ella_real t16 = alpha_1 + (link->G[1] * t14 - link->G[2] * t15);
    const ella_real t17 = alpha_2 - (link->G[3] * t14 + link->G[4] * t15);
    const ella_real t18 = alpha_3 - (link->G[4] * t14 + link->G[5] * t15);
    const ella_real t19 = alpha_4 + (alpha_2 * link->r_T[2] - alpha_3 * link->r_T[1])
        - minus_etaddot_1 * REAL(1.4142135623730951);
    const ella_real t20 = alpha_5 + (alpha_3 * link->r_T[0] - alpha_1 * link->r_T[2]) - minus_etaddot_2 * 2;
    const ella_real t21 = base->alpha[5] + (alpha_1 * link->r_T[1] - alpha_2 * link->r_T[0])
        - minus_etaddot_3 * 2;
    const ella_real alpha_T_1 = link->R_T[0] * t16 + link->R_T[1] * t17 - link->R_T[2] * t18 + link->b_T[0];
    const ella_real alpha_T_2 = link->R_T[3] * t17 - link->R_T[1] * t16 + link->R_T[4] * t18 + link->b_T[1];
    const ella_real alpha_T_3 = link->R_T[2] * t16 + link->R_T[4] * t17 + link->R_T[5] * t18 + link->b_T[2];
    const ella_real alpha_T_4 = link->R_T[0] * t19 + link->R_T[1] * t20 - link->R_T[2] * t21 + link->b_T[3];
    const ella_real alpha_T_5 = link->R_T[3] * t20 - link->R_T[1] * t19 + link->R_T[4] * t21 + link->b_T[4];
    const ella_real alpha_T_6 = link->R_T[2] * t19 + link->R_T[4] * t20 + link->R_T[5] * t21 + link->b_T[5];

    /* outputs */
    qddot[0] = qddot_1;
    wrench[0] = wrench_1;
    wrench[1] = wrench_2;
    wrench[2] = link->p_i[2];
    wrench[3] = wrench_4;
    wrench[4] = wrench_5;
    wrench[5] = wrench_6;
    alpha[0] = alpha_1;
    alpha[1] = alpha_2;
    alpha[2] = alpha_3;
    alpha[3] = alpha_4;
    alpha[4] = alpha_5;
    alpha[5] = base->alpha[5];
    etaddot[0] = t11;
    etaddot[1] = t12;
    etaddot[2] = t13;
    tip->alpha[0] = alpha_T_1;
    tip->alpha[1] = alpha_T_2;
    tip->alpha[2] = alpha_T_3;
    tip->alpha[3] = alpha_T_4;
    tip->alpha[4] = alpha_T_5;
    tip->alpha[5] = alpha_T_6;
    return ELLA_OK;
}

/* twist rates, links like upper_arm: 55 operations */
static ella_status twist_rates_upper_arm(const ella_real quaternion[4], const ella_real gravity[3], const ella_real alpha[6], ella_real Vdot[6])
{

    const ella_real t1 = quaternion[1] * quaternion[1];
    const ella_real t2 = quaternion[2] * quaternion[2];
    const ella_real t3 = quaternion[3] * quaternion[3];
    const ella_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const ella_real t5 = t1 + t2 + t3;
    const ella_real t6 = quaternion[1] * quaternion[2];
    const ella_real t7 = quaternion[1] * quaternion[3];
    const ella_real t8 = quaternion[2] * quaternion[3];
    const ella_real t9 = quaternion[0] * quaternion[3];
    const ella_real t10 = quaternion[0] * quaternion[2];
    const ella_real t11 = quaternion[0] * quaternion[1];
    const ella_real Vdot_4 = alpha[3]
        + ((1 + t4 * (t1 - t5)) * gravity[0] + t4 * (t9 + t6) * gravity[1] + t4 * (t7 - t10) * gravity[2]);
    const ella_real Vdot_5 = alpha[4]
        + (t4 * (t6 - t9) * gravity[0] + (1 + t4 * (t2 - t5)) * gravity[1] + t4 * (t11 + t8) * gravity[2]);
    const ella_real Vdot_6 = alpha[5]
        + (t4 * (t10 + t7) * gravity[0] + t4 * (t8 - t11) * gravity[1] + (1 + t4 * (t3 - t5)) * gravity[2]);

    /* outputs */
    Vdot[0] = alpha[0];
    Vdot[1] = alpha[1];
    Vdot[2] = alpha[2];
    Vdot[3] = Vdot_4;
    Vdot[4] = Vdot_5;
    Vdot[5] = Vdot_6;
    return ELLA_OK;
}

/* project, links like upper_arm: 579 operations */
static ella_status project_upper_arm(const ella_link_constants *c, const ella_node *base, ella_node *tip, const ella_real q[2],
    const ella_real twist[6], const ella_real eta[3], const ella_real etadot[3],
    const ella_real quaternion[4], ella_real new_q[2], ella_real new_twist[6], ella_real new_quaternion[4],
    ella_real new_position[3])
{

    const ella_real t1 = quaternion[1] * quaternion[1];
    const ella_real t2 = quaternion[2] * quaternion[2];
    const ella_real t3 = quaternion[3] * quaternion[3];
    const ella_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const ella_real t5 = t1 + t2 + t3;
    const ella_real t6 = quaternion[1] * quaternion[2];
    const ella_real t7 = quaternion[1] * quaternion[3];
    const ella_real t8 = quaternion[2] * quaternion[3];
    const ella_real t9 = quaternion[0] * quaternion[3];
    const ella_real t10 = quaternion[0] * quaternion[2];
    const ella_real t11 = quaternion[0] * quaternion[1];
    const ella_real t12 = t4 * (t6 - t9);
    const ella_real t13 = t4 * (t10 + t7);
    const ella_real t14 = t4 * (t9 + t6);
    const ella_real t15 = t4 * (t8 - t11);
    const ella_real t16 = t4 * (t7 - t10);
    const ella_real t17 = t4 * (t11 + t8);
    const ella_real t18 = 1 + t4 * (t1 - t5);
    const ella_real t19 = 1 + t4 * (t2 - t5);
    const ella_real t20 = 1 + t4 * (t3 - t5);
    const ella_real t21 = base->R_m[0] * t18 + base->R_m[3] * t14 + base->R_m[6] * t16;
    const ella_real t22 = base->R_m[0] * t12 + base->R_m[3] * t19 + base->R_m[6] * t17;
    const ella_real t23 = base->R_m[0] * t13 + base->R_m[3] * t15 + base->R_m[6] * t20;
    const ella_real t24 = base->R_m[1] * t18 + base->R_m[4] * t14 + base->R_m[7] * t16;
    const ella_real t25 = base->R_m[1] * t12 + base->R_m[4] * t19 + base->R_m[7] * t17;
    const ella_real t26 = base->R_m[1] * t13 + base->R_m[4] * t15 + base->R_m[7] * t20;
    const ella_real t27 = base->R_m[2] * t18 + base->R_m[5] * t14 + base->R_m[8] * t16;
    const ella_real t28 = base->R_m[2] * t12 + base->R_m[5] * t19 + base->R_m[8] * t17;
    const ella_real t29 = base->R_m[2] * t13 + base->R_m[5] * t15 + base->R_m[8] * t20;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_zz = ella_cos(q[0]);
    const ella_real R_rel_yy = ella_cos(q[1]);
    const ella_real R_rel_xx = R_rel_zz * R_rel_yy;
    const ella_real R_rel_yx = ella_sin(q[1]);
    const ella_real minus_R_rel_xy = R_rel_yx * R_rel_zz;
    const ella_real R_rel_xz = ella_sin(q[0]);
    const ella_real minus_R_rel_zx = R_rel_xz * R_rel_yy;
    const ella_real R_rel_zy = R_rel_xz * R_rel_yx;

    const ella_real t30 = R_rel_yx * R_rel_yx + R_rel_yy * R_rel_yy;
    const ella_real t31 = ELLA_REAL_EPSILON * 64;
    if (!(t30 - t31 > 0)) { return ELLA_SINGULAR; }
    const ella_real t32 = 1 / t30;
    const ella_real t33 = R_rel_yy * t24 - minus_R_rel_xy * t21 + R_rel_zy * t27
        - (R_rel_xx * t22 + R_rel_yx * t25 - minus_R_rel_zx * t28);
    const ella_real t34 = (R_rel_xz * t22 + R_rel_zz * t28
        - (R_rel_yy * t26 - minus_R_rel_xy * t23 + R_rel_zy * t29)) * REAL(0.5);
    const ella_real t35 = (R_rel_xx * t23 + R_rel_yx * t26 - minus_R_rel_zx * t29
        - (R_rel_xz * t21 + R_rel_zz * t27)) * REAL(0.5);
    const ella_real t36 = q[0] + (R_rel_yx * t32 * t34 + R_rel_yy * t32 * t35);
    const ella_real t37 = q[1] + t33 * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_zz_2 = ella_cos(t36);
    const ella_real R_rel_yy_2 = ella_cos(t37);
    const ella_real R_rel_xx_2 = R_rel_zz_2 * R_rel_yy_2;
    const ella_real R_rel_yx_2 = ella_sin(t37);
    const ella_real minus_R_rel_xy_2 = R_rel_yx_2 * R_rel_zz_2;
    const ella_real R_rel_xz_2 = ella_sin(t36);
    const ella_real minus_R_rel_zx_2 = R_rel_xz_2 * R_rel_yy_2;
    const ella_real R_rel_zy_2 = R_rel_xz_2 * R_rel_yx_2;

    const ella_real t38 = R_rel_yx_2 * R_rel_yx_2 + R_rel_yy_2 * R_rel_yy_2;
    if (!(t38 - t31 > 0)) { return ELLA_SINGULAR; }
    const ella_real t39 = 1 / t38;
    const ella_real t40 = R_rel_xz_2 * t22 + R_rel_zz_2 * t28
        - (R_rel_yy_2 * t26 - minus_R_rel_xy_2 * t23 + R_rel_zy_2 * t29);
    const ella_real t41 = R_rel_xx_2 * t23 + R_rel_yx_2 * t26 - minus_R_rel_zx_2 * t29
        - (R_rel_xz_2 * t21 + R_rel_zz_2 * t27);
    const ella_real t42 = R_rel_yy_2 * t24 - minus_R_rel_xy_2 * t21 + R_rel_zy_2 * t27
        - (R_rel_xx_2 * t22 + R_rel_yx_2 * t25 - minus_R_rel_zx_2 * t28);
    const ella_real new_q_1 = t36 + (R_rel_yx_2 * t39 * (t40 * REAL(0.5)) + R_rel_yy_2 * t39 * (t41 * REAL(0.5)));
    const ella_real new_q_2 = t37 + t42 * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_zz_3 = ella_cos(new_q_1);
    const ella_real R_rel_yy_3 = ella_cos(new_q_2);
    const ella_real R_rel_xx_3 = R_rel_zz_3 * R_rel_yy_3;
    const ella_real R_rel_yx_3 = ella_sin(new_q_2);
    const ella_real minus_R_rel_xy_3 = R_rel_yx_3 * R_rel_zz_3;
    const ella_real R_rel_xz_3 = ella_sin(new_q_1);
    const ella_real minus_R_rel_zx_3 = R_rel_xz_3 * R_rel_yy_3;
    const ella_real R_rel_zy_3 = R_rel_xz_3 * R_rel_yx_3;

    const ella_real t43 = R_rel_yx_3 * R_rel_yx_3 + R_rel_yy_3 * R_rel_yy_3;
    if (!(t43 - t31 > 0)) { return ELLA_SINGULAR; }
    const ella_real t44 = 1 / t43;
    const ella_real t45 = R_rel_xx_3 * base->omega_m[0] + R_rel_yx_3 * base->omega_m[1]
        - minus_R_rel_zx_3 * base->omega_m[2];
    const ella_real t46 = R_rel_yy_3 * base->omega_m[1] - minus_R_rel_xy_3 * base->omega_m[0]
        + R_rel_zy_3 * base->omega_m[2];
    const ella_real t47 = twist[2] - (R_rel_xz_3 * base->omega_m[0] + R_rel_zz_3 * base->omega_m[2]);
    const ella_real t48 = R_rel_yx_3 * t44 * (twist[0] - t45) + R_rel_yy_3 * t44 * (twist[1] - t46);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_y = c->Psi_c_y3 * eta[2];
    const ella_real theta_z = c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const ella_real minus_theta_hat2_33 = theta_y * theta_y;
    const ella_real minus_theta_hat2_22 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const ella_real c3 = REAL(0.16666666666666666) - x * ella_c5(x);
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    const ella_real minus_R_T_xy = c1 * theta_z;
    const ella_real R_T_xz = c1 * theta_y;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_y = c->Psi_c_y3 * etadot[2];
    const ella_real thetadot_z = c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t49 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t49;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t49;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t49;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t50 = omega_s_x + twist[0];
    const ella_real t51 = omega_s_y + twist[1];
    const ella_real t52 = omega_s_z + twist[2];
    const ella_real omega_T_x = R_T_xx * t50 + minus_R_T_xy * t51 - R_T_xz * t52;
    const ella_real omega_T_y = R_T_yy * t51 - minus_R_T_xy * t50 + R_T_yz * t52;
    const ella_real omega_T_z = R_T_xz * t50 + R_T_yz * t51 + R_T_zz * t52;

    const ella_real R_m_11 = t18 * R_T_xx + t12 * minus_R_T_xy - t13 * R_T_xz;
    const ella_real R_m_12 = t12 * R_T_yy - t18 * minus_R_T_xy + t13 * R_T_yz;
    const ella_real R_m_13 = t18 * R_T_xz + t12 * R_T_yz + t13 * R_T_zz;
    const ella_real R_m_21 = t14 * R_T_xx + t19 * minus_R_T_xy - t15 * R_T_xz;
    const ella_real R_m_22 = t19 * R_T_yy - t14 * minus_R_T_xy + t15 * R_T_yz;
    const ella_real R_m_23 = t14 * R_T_xz + t19 * R_T_yz + t15 * R_T_zz;
    const ella_real R_m_31 = t16 * R_T_xx + t17 * minus_R_T_xy - t20 * R_T_xz;
    const ella_real R_m_32 = t17 * R_T_yy - t16 * minus_R_T_xy + t20 * R_T_yz;
    const ella_real R_m_33 = t16 * R_T_xz + t17 * R_T_yz + t20 * R_T_zz;

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx_3 * t48;
    const ella_real omega_J_y = R_rel_yy_3 * t48;

    /* omega_R: angular velocity of the parent's tip */
    const ella_real omega_R_x = R_rel_xx_3 * base->omega[0] + R_rel_yx_3 * base->omega[1]
        - minus_R_rel_zx_3 * base->omega[2];
    const ella_real omega_R_y = R_rel_yy_3 * base->omega[1] - minus_R_rel_xy_3 * base->omega[0]
        + R_rel_zy_3 * base->omega[2];
    const ella_real omega_R_z = R_rel_xz_3 * base->omega[0] + R_rel_zz_3 * base->omega[2];

    /* omega: angular velocity of the link (45) */
    const ella_real omega_x = omega_J_x + omega_R_x;
    const ella_real omega_y = omega_J_y + omega_R_y;
    const ella_real omega_z = omega_R_z + t47;

    /* v_R: velocity of the joint point */
    const ella_real v_R_x = R_rel_xx_3 * base->v[0] + R_rel_yx_3 * base->v[1] - minus_R_rel_zx_3 * base->v[2];
    const ella_real v_R_y = R_rel_yy_3 * base->v[1] - minus_R_rel_xy_3 * base->v[0] + R_rel_zy_3 * base->v[2];
    const ella_real v_R_z = R_rel_xz_3 * base->v[0] + R_rel_zz_3 * base->v[2];

    const ella_real t53 = base->R[0] * R_rel_xx_3 + base->R[1] * R_rel_yx_3 - base->R[2] * minus_R_rel_zx_3;
    const ella_real t54 = base->R[1] * R_rel_yy_3 - base->R[0] * minus_R_rel_xy_3 + base->R[2] * R_rel_zy_3;
    const ella_real t55 = base->R[0] * R_rel_xz_3 + base->R[2] * R_rel_zz_3;
    const ella_real t56 = base->R[3] * R_rel_xx_3 + base->R[4] * R_rel_yx_3 - base->R[5] * minus_R_rel_zx_3;
    const ella_real t57 = base->R[4] * R_rel_yy_3 - base->R[3] * minus_R_rel_xy_3 + base->R[5] * R_rel_zy_3;
    const ella_real t58 = base->R[3] * R_rel_xz_3 + base->R[5] * R_rel_zz_3;
    const ella_real t59 = base->R[6] * R_rel_xx_3 + base->R[7] * R_rel_yx_3 - base->R[8] * minus_R_rel_zx_3;
    const ella_real t60 = base->R[7] * R_rel_yy_3 - base->R[6] * minus_R_rel_xy_3 + base->R[8] * R_rel_zy_3;
    const ella_real t61 = base->R[6] * R_rel_xz_3 + base->R[8] * R_rel_zz_3;
    const ella_real t62 = new_q_1 * REAL(0.5);
    const ella_real t63 = ella_sin(t62);
    const ella_real t64 = ella_cos(t62);
    const ella_real t65 = new_q_2 * REAL(0.5);
    const ella_real t66 = ella_sin(t65);
    const ella_real t67 = ella_cos(t65);
    const ella_real t68 = t64 * t67;
    const ella_real t69 = t64 * t66;
    const ella_real t70 = t67 * t63;
    const ella_real t71 = t63 * t66;
    const ella_real new_quaternion_1 = base->Q[0] * t68
        - (base->Q[1] * t71 + base->Q[2] * t70 + base->Q[3] * t69);
    const ella_real new_quaternion_2 = base->Q[0] * t71 + t68 * base->Q[1]
        + (base->Q[2] * t69 - base->Q[3] * t70);
    const ella_real new_quaternion_3 = base->Q[0] * t70 + t68 * base->Q[2]
        + (base->Q[3] * t71 - base->Q[1] * t69);
    const ella_real new_quaternion_4 = base->Q[0] * t69 + t68 * base->Q[3]
        + (base->Q[1] * t70 - base->Q[2] * t71);

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    const ella_real r_T_y = eta[1] * 2;
    const ella_real r_T_z = eta[2] * 2;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_x = etadot[0] * REAL(1.4142135623730951);
    const ella_real udot_T_y = etadot[1] * 2;
    const ella_real udot_T_z = etadot[2] * 2;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t72 = omega_s_x + omega_x;
    const ella_real t73 = omega_s_y + omega_y;
    const ella_real t74 = omega_s_z + omega_z;
    const ella_real omega_T_x_2 = R_T_xx * t72 + minus_R_T_xy * t73 - R_T_xz * t74;
    const ella_real omega_T_y_2 = R_T_yy * t73 - minus_R_T_xy * t72 + R_T_yz * t74;
    const ella_real omega_T_z_2 = R_T_xz * t72 + R_T_yz * t73 + R_T_zz * t74;

    /* v_T: velocity of the tip point (46) */
    const ella_real t75 = udot_T_x + v_R_x + omega_y * r_T_z - omega_z * r_T_y;
    const ella_real t76 = udot_T_y + v_R_y + omega_z * r_T_x - omega_x * r_T_z;
    const ella_real t77 = udot_T_z + v_R_z + omega_x * r_T_y - omega_y * r_T_x;
    const ella_real v_T_x = R_T_xx * t75 + minus_R_T_xy * t76 - R_T_xz * t77;
    const ella_real v_T_y = R_T_yy * t76 - minus_R_T_xy * t75 + R_T_yz * t77;
    const ella_real v_T_z = R_T_xz * t75 + R_T_yz * t76 + R_T_zz * t77;

    const ella_real R_xx = t53 * R_T_xx + t54 * minus_R_T_xy - t55 * R_T_xz;
    const ella_real R_xy = t54 * R_T_yy - t53 * minus_R_T_xy + t55 * R_T_yz;
    const ella_real R_xz = t53 * R_T_xz + t54 * R_T_yz + t55 * R_T_zz;
    const ella_real R_yx = t56 * R_T_xx + t57 * minus_R_T_xy - t58 * R_T_xz;
    const ella_real R_yy = t57 * R_T_yy - t56 * minus_R_T_xy + t58 * R_T_yz;
    const ella_real R_yz = t56 * R_T_xz + t57 * R_T_yz + t58 * R_T_zz;
    const ella_real R_zx = t59 * R_T_xx + t60 * minus_R_T_xy - t61 * R_T_xz;
    const ella_real R_zy = t60 * R_T_yy - t59 * minus_R_T_xy + t61 * R_T_yz;
    const ella_real R_zz = t59 * R_T_xz + t60 * R_T_yz + t61 * R_T_zz;
    const ella_real r_x = base->r[0] + (t53 * r_T_x + t54 * r_T_y + t55 * r_T_z);
    const ella_real r_y = base->r[1] + (t56 * r_T_x + t57 * r_T_y + t58 * r_T_z);
    const ella_real r_z = base->r[2] + (t59 * r_T_x + t60 * r_T_y + t61 * r_T_z);
    const ella_real t78 = x * REAL(0.25);
    const ella_real t79 = 1 - t78 * (REAL(0.5) - t78 * ella_c4(t78));
    const ella_real t80 = (1 - t78 * (REAL(0.16666666666666666) - t78 * ella_c5(t78))) * REAL(0.5);
    const ella_real t81 = t80 * theta_y;
    const ella_real t82 = t80 * theta_z;
    const ella_real Q_1 = new_quaternion_1 * t79 - (new_quaternion_3 * t81 + new_quaternion_4 * t82);
    const ella_real Q_2 = t79 * new_quaternion_2 + (new_quaternion_3 * t82 - new_quaternion_4 * t81);
    const ella_real Q_3 = new_quaternion_1 * t81 + t79 * new_quaternion_3 - new_quaternion_2 * t82;
    const ella_real Q_4 = new_quaternion_1 * t82 + t79 * new_quaternion_4 + new_quaternion_2 * t81;

    /* outputs */
    new_q[0] = new_q_1;
    new_q[1] = new_q_2;
    tip->omega_m[0] = omega_T_x;
    tip->omega_m[1] = omega_T_y;
    tip->omega_m[2] = omega_T_z;
    tip->R_m[0] = R_m_11;
    tip->R_m[1] = R_m_12;
    tip->R_m[2] = R_m_13;
    tip->R_m[3] = R_m_21;
    tip->R_m[4] = R_m_22;
    tip->R_m[5] = R_m_23;
    tip->R_m[6] = R_m_31;
    tip->R_m[7] = R_m_32;
    tip->R_m[8] = R_m_33;
    new_twist[0] = omega_x;
    new_twist[1] = omega_y;
    new_twist[2] = omega_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega[0] = omega_T_x_2;
    tip->omega[1] = omega_T_y_2;
    tip->omega[2] = omega_T_z_2;
    tip->v[0] = v_T_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    tip->R[0] = R_xx;
    tip->R[1] = R_xy;
    tip->R[2] = R_xz;
    tip->R[3] = R_yx;
    tip->R[4] = R_yy;
    tip->R[5] = R_yz;
    tip->R[6] = R_zx;
    tip->R[7] = R_zy;
    tip->R[8] = R_zz;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = Q_1;
    tip->Q[1] = Q_2;
    tip->Q[2] = Q_3;
    tip->Q[3] = Q_4;
    return ELLA_OK;
}

/* project, links like forearm: 378 operations */
static ella_status project_forearm(const ella_link_constants *c, const ella_node *base, ella_node *tip, const ella_real q[1],
    const ella_real twist[6], const ella_real eta[3], const ella_real etadot[3],
    const ella_real quaternion[4], ella_real new_q[1], ella_real new_twist[6], ella_real new_quaternion[4],
    ella_real new_position[3])
{

    const ella_real t1 = quaternion[1] * quaternion[1];
    const ella_real t2 = quaternion[2] * quaternion[2];
    const ella_real t3 = quaternion[3] * quaternion[3];
    const ella_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const ella_real t5 = t1 + t2 + t3;
    const ella_real t6 = quaternion[1] * quaternion[2];
    const ella_real t7 = quaternion[1] * quaternion[3];
    const ella_real t8 = quaternion[2] * quaternion[3];
    const ella_real t9 = quaternion[0] * quaternion[3];
    const ella_real t10 = quaternion[0] * quaternion[2];
    const ella_real t11 = quaternion[0] * quaternion[1];
    const ella_real t12 = t4 * (t6 - t9);
    const ella_real t13 = t4 * (t10 + t7);
    const ella_real t14 = t4 * (t9 + t6);
    const ella_real t15 = t4 * (t8 - t11);
    const ella_real t16 = t4 * (t7 - t10);
    const ella_real t17 = t4 * (t11 + t8);
    const ella_real t18 = 1 + t4 * (t1 - t5);
    const ella_real t19 = 1 + t4 * (t2 - t5);
    const ella_real t20 = 1 + t4 * (t3 - t5);
    const ella_real t21 = base->R_m[0] * t18 + base->R_m[3] * t14 + base->R_m[6] * t16;
    const ella_real t22 = base->R_m[0] * t12 + base->R_m[3] * t19 + base->R_m[6] * t17;
    const ella_real t23 = base->R_m[1] * t18 + base->R_m[4] * t14 + base->R_m[7] * t16;
    const ella_real t24 = base->R_m[1] * t12 + base->R_m[4] * t19 + base->R_m[7] * t17;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_xx = ella_cos(q[0]);
    const ella_real minus_R_rel_xy = ella_sin(q[0]);

    const ella_real t25 = q[0]
        + (R_rel_xx * t23 - minus_R_rel_xy * t21 - (R_rel_xx * t22 + minus_R_rel_xy * t24)) * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_xx_2 = ella_cos(t25);
    const ella_real minus_R_rel_xy_2 = ella_sin(t25);

    const ella_real t26 = (R_rel_xx_2 * t23 - minus_R_rel_xy_2 * t21
        - (R_rel_xx_2 * t22 + minus_R_rel_xy_2 * t24)) * REAL(0.5);
    const ella_real new_q_1 = t25 + t26;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_xx_3 = ella_cos(new_q_1);
    const ella_real minus_R_rel_xy_3 = ella_sin(new_q_1);

    const ella_real t27 = twist[2] - base->omega_m[2];

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_y = c->Psi_c_y3 * eta[2];
    const ella_real theta_z = c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const ella_real minus_theta_hat2_33 = theta_y * theta_y;
    const ella_real minus_theta_hat2_22 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const ella_real c3 = REAL(0.16666666666666666) - x * ella_c5(x);
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    const ella_real minus_R_T_xy = c1 * theta_z;
    const ella_real R_T_xz = c1 * theta_y;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_y = c->Psi_c_y3 * etadot[2];
    const ella_real thetadot_z = c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t28 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t28;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t28;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t28;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t29 = omega_s_x + twist[0];
    const ella_real t30 = omega_s_y + twist[1];
    const ella_real t31 = omega_s_z + twist[2];
    const ella_real omega_T_x = R_T_xx * t29 + minus_R_T_xy * t30 - R_T_xz * t31;
    const ella_real omega_T_y = R_T_yy * t30 - minus_R_T_xy * t29 + R_T_yz * t31;
    const ella_real omega_T_z = R_T_xz * t29 + R_T_yz * t30 + R_T_zz * t31;

    const ella_real R_m_11 = t18 * R_T_xx + t12 * minus_R_T_xy - t13 * R_T_xz;
    const ella_real R_m_12 = t12 * R_T_yy - t18 * minus_R_T_xy + t13 * R_T_yz;
    const ella_real R_m_13 = t18 * R_T_xz + t12 * R_T_yz + t13 * R_T_zz;
    const ella_real R_m_21 = t14 * R_T_xx + t19 * minus_R_T_xy - t15 * R_T_xz;
    const ella_real R_m_22 = t19 * R_T_yy - t14 * minus_R_T_xy + t15 * R_T_yz;
    const ella_real R_m_23 = t14 * R_T_xz + t19 * R_T_yz + t15 * R_T_zz;
    const ella_real R_m_31 = t16 * R_T_xx + t17 * minus_R_T_xy - t20 * R_T_xz;
    const ella_real R_m_32 = t17 * R_T_yy - t16 * minus_R_T_xy + t20 * R_T_yz;
    const ella_real R_m_33 = t16 * R_T_xz + t17 * R_T_yz + t20 * R_T_zz;

    /* omega_R: angular velocity of the parent's tip */
    const ella_real omega_R_x = R_rel_xx_3 * base->omega[0] + minus_R_rel_xy_3 * base->omega[1];
    const ella_real omega_R_y = R_rel_xx_3 * base->omega[1] - minus_R_rel_xy_3 * base->omega[0];

    /* omega: angular velocity of the link (45) */
    const ella_real omega_z = base->omega[2] + t27;

    /* v_R: velocity of the joint point */
    const ella_real v_R_x = R_rel_xx_3 * base->v[0] + minus_R_rel_xy_3 * base->v[1];
    const ella_real v_R_y = R_rel_xx_3 * base->v[1] - minus_R_rel_xy_3 * base->v[0];

    const ella_real t32 = base->R[0] * R_rel_xx_3 + base->R[1] * minus_R_rel_xy_3;
    const ella_real t33 = base->R[1] * R_rel_xx_3 - base->R[0] * minus_R_rel_xy_3;
    const ella_real t34 = base->R[3] * R_rel_xx_3 + base->R[4] * minus_R_rel_xy_3;
    const ella_real t35 = base->R[4] * R_rel_xx_3 - base->R[3] * minus_R_rel_xy_3;
    const ella_real t36 = base->R[6] * R_rel_xx_3 + base->R[7] * minus_R_rel_xy_3;
    const ella_real t37 = base->R[7] * R_rel_xx_3 - base->R[6] * minus_R_rel_xy_3;
    const ella_real t38 = new_q_1 * REAL(0.5);
    const ella_real t39 = ella_sin(t38);
    const ella_real t40 = ella_cos(t38);
    const ella_real new_quaternion_1 = base->Q[0] * t40 - base->Q[3] * t39;
    const ella_real new_quaternion_4 = base->Q[0] * t39 + t40 * base->Q[3];
    const ella_real new_quaternion_2 = t40 * base->Q[1] + base->Q[2] * t39;
    const ella_real new_quaternion_3 = t40 * base->Q[2] - base->Q[1] * t39;

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    const ella_real r_T_y = eta[1] * 2;
    const ella_real r_T_z = eta[2] * 2;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_x = etadot[0] * REAL(1.4142135623730951);
    const ella_real udot_T_y = etadot[1] * 2;
    const ella_real udot_T_z = etadot[2] * 2;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t41 = omega_s_x + omega_R_x;
    const ella_real t42 = omega_s_y + omega_R_y;
    const ella_real t43 = omega_s_z + omega_z;
    const ella_real omega_T_x_2 = R_T_xx * t41 + minus_R_T_xy * t42 - R_T_xz * t43;
    const ella_real omega_T_y_2 = R_T_yy * t42 - minus_R_T_xy * t41 + R_T_yz * t43;
    const ella_real omega_T_z_2 = R_T_xz * t41 + R_T_yz * t42 + R_T_zz * t43;

    /* v_T: velocity of the tip point (46) */
    const ella_real t44 = udot_T_x + v_R_x + omega_R_y * r_T_z - omega_z * r_T_y;
    const ella_real t45 = udot_T_y + v_R_y + omega_z * r_T_x - omega_R_x * r_T_z;
    const ella_real t46 = udot_T_z + base->v[2] + omega_R_x * r_T_y - omega_R_y * r_T_x;
    const ella_real v_T_x = R_T_xx * t44 + minus_R_T_xy * t45 - R_T_xz * t46;
    const ella_real v_T_y = R_T_yy * t45 - minus_R_T_xy * t44 + R_T_yz * t46;
    const ella_real v_T_z = R_T_xz * t44 + R_T_yz * t45 + R_T_zz * t46;

    const ella_real R_xx = t32 * R_T_xx + t33 * minus_R_T_xy - base->R[2] * R_T_xz;
    const ella_real R_xy = t33 * R_T_yy - t32 * minus_R_T_xy + base->R[2] * R_T_yz;
    const ella_real R_xz = t32 * R_T_xz + t33 * R_T_yz + base->R[2] * R_T_zz;
    const ella_real R_yx = t34 * R_T_xx + t35 * minus_R_T_xy - base->R[5] * R_T_xz;
    const ella_real R_yy = t35 * R_T_yy - t34 * minus_R_T_xy + base->R[5] * R_T_yz;
    const ella_real R_yz = t34 * R_T_xz + t35 * R_T_yz + base->R[5] * R_T_zz;
    const ella_real R_zx = t36 * R_T_xx + t37 * minus_R_T_xy - base->R[8] * R_T_xz;
    const ella_real R_zy = t37 * R_T_yy - t36 * minus_R_T_xy + base->R[8] * R_T_yz;
    const ella_real R_zz = t36 * R_T_xz + t37 * R_T_yz + base->R[8] * R_T_zz;
    const ella_real r_x = base->r[0] + (t32 * r_T_x + t33 * r_T_y + base->R[2] * r_T_z);
    const ella_real r_y = base->r[1] + (t34 * r_T_x + t35 * r_T_y + base->R[5] * r_T_z);
    const ella_real r_z = base->r[2] + (t36 * r_T_x + t37 * r_T_y + base->R[8] * r_T_z);
    const ella_real t47 = x * REAL(0.25);
    const ella_real t48 = 1 - t47 * (REAL(0.5) - t47 * ella_c4(t47));
    const ella_real t49 = (1 - t47 * (REAL(0.16666666666666666) - t47 * ella_c5(t47))) * REAL(0.5);
    const ella_real t50 = t49 * theta_y;
    const ella_real t51 = t49 * theta_z;
    const ella_real Q_1 = new_quaternion_1 * t48 - (new_quaternion_3 * t50 + new_quaternion_4 * t51);
    const ella_real Q_2 = t48 * new_quaternion_2 + (new_quaternion_3 * t51 - new_quaternion_4 * t50);
    const ella_real Q_3 = new_quaternion_1 * t50 + t48 * new_quaternion_3 - new_quaternion_2 * t51;
    const ella_real Q_4 = new_quaternion_1 * t51 + t48 * new_quaternion_4 + new_quaternion_2 * t50;

    /* outputs */
    new_q[0] = new_q_1;
    tip->omega_m[0] = omega_T_x;
    tip->omega_m[1] = omega_T_y;
    tip->omega_m[2] = omega_T_z;
    tip->R_m[0] = R_m_11;
    tip->R_m[1] = R_m_12;
    tip->R_m[2] = R_m_13;
    tip->R_m[3] = R_m_21;
    tip->R_m[4] = R_m_22;
    tip->R_m[5] = R_m_23;
    tip->R_m[6] = R_m_31;
    tip->R_m[7] = R_m_32;
    tip->R_m[8] = R_m_33;
    new_twist[0] = omega_R_x;
    new_twist[1] = omega_R_y;
    new_twist[2] = omega_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = base->v[2];
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega[0] = omega_T_x_2;
    tip->omega[1] = omega_T_y_2;
    tip->omega[2] = omega_T_z_2;
    tip->v[0] = v_T_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    tip->R[0] = R_xx;
    tip->R[1] = R_xy;
    tip->R[2] = R_xz;
    tip->R[3] = R_yx;
    tip->R[4] = R_yy;
    tip->R[5] = R_yz;
    tip->R[6] = R_zx;
    tip->R[7] = R_zy;
    tip->R[8] = R_zz;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = Q_1;
    tip->Q[1] = Q_2;
    tip->Q[2] = Q_3;
    tip->Q[3] = Q_4;
    return ELLA_OK;
}

/* forward kinematics, links like upper_arm: 303 operations */
static ella_status forward_kinematics_upper_arm(const ella_link_constants *c, const ella_node *base, ella_node *tip, const ella_real q[2],
    const ella_real qdot[2], const ella_real eta[3], const ella_real etadot[3], ella_real new_twist[6],
    ella_real new_quaternion[4], ella_real new_position[3])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_zz = ella_cos(q[0]);
    const ella_real R_rel_yy = ella_cos(q[1]);
    const ella_real R_rel_xx = R_rel_zz * R_rel_yy;
    const ella_real R_rel_yx = ella_sin(q[1]);
    const ella_real minus_R_rel_xy = R_rel_yx * R_rel_zz;
    const ella_real R_rel_xz = ella_sin(q[0]);
    const ella_real minus_R_rel_zx = R_rel_xz * R_rel_yy;
    const ella_real R_rel_zy = R_rel_xz * R_rel_yx;

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx * qdot[0];
    const ella_real omega_J_y = R_rel_yy * qdot[0];

    /* omega_R: angular velocity of the parent's tip */
    const ella_real omega_R_x = R_rel_xx * base->omega[0] + R_rel_yx * base->omega[1]
        - minus_R_rel_zx * base->omega[2];
    const ella_real omega_R_y = R_rel_yy * base->omega[1] - minus_R_rel_xy * base->omega[0]
        + R_rel_zy * base->omega[2];
    const ella_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_zz * base->omega[2];

    /* omega: angular velocity of the link (45) */
    const ella_real omega_x = omega_J_x + omega_R_x;
    const ella_real omega_y = omega_J_y + omega_R_y;
    const ella_real omega_z = omega_R_z + qdot[1];

    /* v_R: velocity of the joint point */
    const ella_real v_R_x = R_rel_xx * base->v[0] + R_rel_yx * base->v[1] - minus_R_rel_zx * base->v[2];
    const ella_real v_R_y = R_rel_yy * base->v[1] - minus_R_rel_xy * base->v[0] + R_rel_zy * base->v[2];
    const ella_real v_R_z = R_rel_xz * base->v[0] + R_rel_zz * base->v[2];

    const ella_real t1 = base->R[0] * R_rel_xx + base->R[1] * R_rel_yx - base->R[2] * minus_R_rel_zx;
    const ella_real t2 = base->R[1] * R_rel_yy - base->R[0] * minus_R_rel_xy + base->R[2] * R_rel_zy;
    const ella_real t3 = base->R[0] * R_rel_xz + base->R[2] * R_rel_zz;
    const ella_real t4 = base->R[3] * R_rel_xx + base->R[4] * R_rel_yx - base->R[5] * minus_R_rel_zx;
    const ella_real t5 = base->R[4] * R_rel_yy - base->R[3] * minus_R_rel_xy + base->R[5] * R_rel_zy;
    const ella_real t6 = base->R[3] * R_rel_xz + base->R[5] * R_rel_zz;
    const ella_real t7 = base->R[6] * R_rel_xx + base->R[7] * R_rel_yx - base->R[8] * minus_R_rel_zx;
    const ella_real t8 = base->R[7] * R_rel_yy - base->R[6] * minus_R_rel_xy + base->R[8] * R_rel_zy;
    const ella_real t9 = base->R[6] * R_rel_xz + base->R[8] * R_rel_zz;
    const ella_real t10 = q[0] * REAL(0.5);
    const ella_real t11 = ella_sin(t10);
    const ella_real t12 = ella_cos(t10);
    const ella_real t13 = q[1] * REAL(0.5);
    const ella_real t14 = ella_sin(t13);
    const ella_real t15 = ella_cos(t13);
    const ella_real t16 = t12 * t15;
    const ella_real t17 = t12 * t14;
    const ella_real t18 = t15 * t11;
    const ella_real t19 = t11 * t14;
    const ella_real new_quaternion_1 = base->Q[0] * t16
        - (base->Q[1] * t19 + base->Q[2] * t18 + base->Q[3] * t17);
    const ella_real new_quaternion_2 = base->Q[0] * t19 + t16 * base->Q[1]
        + (base->Q[2] * t17 - base->Q[3] * t18);
    const ella_real new_quaternion_3 = base->Q[0] * t18 + t16 * base->Q[2]
        + (base->Q[3] * t19 - base->Q[1] * t17);
    const ella_real new_quaternion_4 = base->Q[0] * t17 + t16 * base->Q[3]
        + (base->Q[1] * t18 - base->Q[2] * t19);

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    const ella_real r_T_y = eta[1] * 2;
    const ella_real r_T_z = eta[2] * 2;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_y = c->Psi_c_y3 * eta[2];
    const ella_real theta_z = c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const ella_real minus_theta_hat2_33 = theta_y * theta_y;
    const ella_real minus_theta_hat2_22 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const ella_real c3 = REAL(0.16666666666666666) - x * ella_c5(x);
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    const ella_real minus_R_T_xy = c1 * theta_z;
    const ella_real R_T_xz = c1 * theta_y;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_x = etadot[0] * REAL(1.4142135623730951);
    const ella_real udot_T_y = etadot[1] * 2;
    const ella_real udot_T_z = etadot[2] * 2;

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_y = c->Psi_c_y3 * etadot[2];
    const ella_real thetadot_z = c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t20 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t20;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t20;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t20;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t21 = omega_s_x + omega_x;
    const ella_real t22 = omega_s_y + omega_y;
    const ella_real t23 = omega_s_z + omega_z;
    const ella_real omega_T_x = R_T_xx * t21 + minus_R_T_xy * t22 - R_T_xz * t23;
    const ella_real omega_T_y = R_T_yy * t22 - minus_R_T_xy * t21 + R_T_yz * t23;
    const ella_real omega_T_z = R_T_xz * t21 + R_T_yz * t22 + R_T_zz * t23;

    /* v_T: velocity of the tip point (46) */
    const ella_real t24 = udot_T_x + v_R_x + omega_y * r_T_z - omega_z * r_T_y;
    const ella_real t25 = udot_T_y + v_R_y + omega_z * r_T_x - omega_x * r_T_z;
    const ella_real t26 = udot_T_z + v_R_z + omega_x * r_T_y - omega_y * r_T_x;
    const ella_real v_T_x = R_T_xx * t24 + minus_R_T_xy * t25 - R_T_xz * t26;
    const ella_real v_T_y = R_T_yy * t25 - minus_R_T_xy * t24 + R_T_yz * t26;
    const ella_real v_T_z = R_T_xz * t24 + R_T_yz * t25 + R_T_zz * t26;

    const ella_real R_xx = t1 * R_T_xx + t2 * minus_R_T_xy - t3 * R_T_xz;
    const ella_real R_xy = t2 * R_T_yy - t1 * minus_R_T_xy + t3 * R_T_yz;
    const ella_real R_xz = t1 * R_T_xz + t2 * R_T_yz + t3 * R_T_zz;
    const ella_real R_yx = t4 * R_T_xx + t5 * minus_R_T_xy - t6 * R_T_xz;
    const ella_real R_yy = t5 * R_T_yy - t4 * minus_R_T_xy + t6 * R_T_yz;
    const ella_real R_yz = t4 * R_T_xz + t5 * R_T_yz + t6 * R_T_zz;
    const ella_real R_zx = t7 * R_T_xx + t8 * minus_R_T_xy - t9 * R_T_xz;
    const ella_real R_zy = t8 * R_T_yy - t7 * minus_R_T_xy + t9 * R_T_yz;
    const ella_real R_zz = t7 * R_T_xz + t8 * R_T_yz + t9 * R_T_zz;
    const ella_real r_x = base->r[0] + (t1 * r_T_x + t2 * r_T_y + t3 * r_T_z);
    const ella_real r_y = base->r[1] + (t4 * r_T_x + t5 * r_T_y + t6 * r_T_z);
    const ella_real r_z = base->r[2] + (t7 * r_T_x + t8 * r_T_y + t9 * r_T_z);
    const ella_real t27 = x * REAL(0.25);
    const ella_real t28 = 1 - t27 * (REAL(0.5) - t27 * ella_c4(t27));
    const ella_real t29 = (1 - t27 * (REAL(0.16666666666666666) - t27 * ella_c5(t27))) * REAL(0.5);
    const ella_real t30 = t29 * theta_y;
    const ella_real t31 = t29 * theta_z;
    const ella_real Q_1 = new_quaternion_1 * t28 - (new_quaternion_3 * t30 + new_quaternion_4 * t31);
    const ella_real Q_2 = t28 * new_quaternion_2 + (new_quaternion_3 * t31 - new_quaternion_4 * t30);
    const ella_real Q_3 = new_quaternion_1 * t30 + t28 * new_quaternion_3 - new_quaternion_2 * t31;
    const ella_real Q_4 = new_quaternion_1 * t31 + t28 * new_quaternion_4 + new_quaternion_2 * t30;

    /* outputs */
    new_twist[0] = omega_x;
    new_twist[1] = omega_y;
    new_twist[2] = omega_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega[0] = omega_T_x;
    tip->omega[1] = omega_T_y;
    tip->omega[2] = omega_T_z;
    tip->v[0] = v_T_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    tip->R[0] = R_xx;
    tip->R[1] = R_xy;
    tip->R[2] = R_xz;
    tip->R[3] = R_yx;
    tip->R[4] = R_yy;
    tip->R[5] = R_yz;
    tip->R[6] = R_zx;
    tip->R[7] = R_zy;
    tip->R[8] = R_zz;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = Q_1;
    tip->Q[1] = Q_2;
    tip->Q[2] = Q_3;
    tip->Q[3] = Q_4;
    return ELLA_OK;
}

/* forward kinematics, links like forearm: 235 operations */
static ella_status forward_kinematics_forearm(const ella_link_constants *c, const ella_node *base, ella_node *tip, const ella_real q[1],
    const ella_real qdot[1], const ella_real eta[3], const ella_real etadot[3], ella_real new_twist[6],
    ella_real new_quaternion[4], ella_real new_position[3])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_xx = ella_cos(q[0]);
    const ella_real minus_R_rel_xy = ella_sin(q[0]);

    /* omega_R: angular velocity of the parent's tip */
    const ella_real omega_R_x = R_rel_xx * base->omega[0] + minus_R_rel_xy * base->omega[1];
    const ella_real omega_R_y = R_rel_xx * base->omega[1] - minus_R_rel_xy * base->omega[0];

    /* omega: angular velocity of the link (45) */
    const ella_real omega_z = base->omega[2] + qdot[0];

    /* v_R: velocity of the joint point */
    const ella_real v_R_x = R_rel_xx * base->v[0] + minus_R_rel_xy * base->v[1];
    const ella_real v_R_y = R_rel_xx * base->v[1] - minus_R_rel_xy * base->v[0];

    const ella_real t1 = base->R[0] * R_rel_xx + base->R[1] * minus_R_rel_xy;
    const ella_real t2 = base->R[1] * R_rel_xx - base->R[0] * minus_R_rel_xy;
    const ella_real t3 = base->R[3] * R_rel_xx + base->R[4] * minus_R_rel_xy;
    const ella_real t4 = base->R[4] * R_rel_xx - base->R[3] * minus_R_rel_xy;
    const ella_real t5 = base->R[6] * R_rel_xx + base->R[7] * minus_R_rel_xy;
    const ella_real t6 = base->R[7] * R_rel_xx - base->R[6] * minus_R_rel_xy;
    const ella_real t7 = q[0] * REAL(0.5);
    const ella_real t8 = ella_sin(t7);
    const ella_real t9 = ella_cos(t7);
    const ella_real new_quaternion_1 = base->Q[0] * t9 - base->Q[3] * t8;
    const ella_real new_quaternion_4 = base->Q[0] * t8 + t9 * base->Q[3];
    const ella_real new_quaternion_2 = t9 * base->Q[1] + base->Q[2] * t8;
    const ella_real new_quaternion_3 = t9 * base->Q[2] - base->Q[1] * t8;

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    const ella_real r_T_y = eta[1] * 2;
    const ella_real r_T_z = eta[2] * 2;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_y = c->Psi_c_y3 * eta[2];
    const ella_real theta_z = c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const ella_real minus_theta_hat2_33 = theta_y * theta_y;
    const ella_real minus_theta_hat2_22 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const ella_real c3 = REAL(0.16666666666666666) - x * ella_c5(x);
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    const ella_real minus_R_T_xy = c1 * theta_z;
    const ella_real R_T_xz = c1 * theta_y;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_x = etadot[0] * REAL(1.4142135623730951);
    const ella_real udot_T_y = etadot[1] * 2;
    const ella_real udot_T_z = etadot[2] * 2;

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_y = c->Psi_c_y3 * etadot[2];
    const ella_real thetadot_z = c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t10 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t10;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t10;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t10;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t11 = omega_s_x + omega_R_x;
    const ella_real t12 = omega_s_y + omega_R_y;
    const ella_real t13 = omega_s_z + omega_z;
    const ella_real omega_T_x = R_T_xx * t11 + minus_R_T_xy * t12 - R_T_xz * t13;
    const ella_real omega_T_y = R_T_yy * t12 - minus_R_T_xy * t11 + R_T_yz * t13;
    const ella_real omega_T_z = R_T_xz * t11 + R_T_yz * t12 + R_T_zz * t13;

    /* v_T: velocity of the tip point (46) */
    const ella_real t14 = udot_T_x + v_R_x + omega_R_y * r_T_z - omega_z * r_T_y;
    const ella_real t15 = udot_T_y + v_R_y + omega_z * r_T_x - omega_R_x * r_T_z;
    const ella_real t16 = udot_T_z + base->v[2] + omega_R_x * r_T_y - omega_R_y * r_T_x;
    const ella_real v_T_x = R_T_xx * t14 + minus_R_T_xy * t15 - R_T_xz * t16;
    const ella_real v_T_y = R_T_yy * t15 - minus_R_T_xy * t14 + R_T_yz * t16;
    const ella_real v_T_z = R_T_xz * t14 + R_T_yz * t15 + R_T_zz * t16;

    const ella_real R_xx = t1 * R_T_xx + t2 * minus_R_T_xy - base->R[2] * R_T_xz;
    const ella_real R_xy = t2 * R_T_yy - t1 * minus_R_T_xy + base->R[2] * R_T_yz;
    const ella_real R_xz = t1 * R_T_xz + t2 * R_T_yz + base->R[2] * R_T_zz;
    const ella_real R_yx = t3 * R_T_xx + t4 * minus_R_T_xy - base->R[5] * R_T_xz;
    const ella_real R_yy = t4 * R_T_yy - t3 * minus_R_T_xy + base->R[5] * R_T_yz;
    const ella_real R_yz = t3 * R_T_xz + t4 * R_T_yz + base->R[5] * R_T_zz;
    const ella_real R_zx = t5 * R_T_xx + t6 * minus_R_T_xy - base->R[8] * R_T_xz;
    const ella_real R_zy = t6 * R_T_yy - t5 * minus_R_T_xy + base->R[8] * R_T_yz;
    const ella_real R_zz = t5 * R_T_xz + t6 * R_T_yz + base->R[8] * R_T_zz;
    const ella_real r_x = base->r[0] + (t1 * r_T_x + t2 * r_T_y + base->R[2] * r_T_z);
    const ella_real r_y = base->r[1] + (t3 * r_T_x + t4 * r_T_y + base->R[5] * r_T_z);
    const ella_real r_z = base->r[2] + (t5 * r_T_x + t6 * r_T_y + base->R[8] * r_T_z);
    const ella_real t17 = x * REAL(0.25);
    const ella_real t18 = 1 - t17 * (REAL(0.5) - t17 * ella_c4(t17));
    const ella_real t19 = (1 - t17 * (REAL(0.16666666666666666) - t17 * ella_c5(t17))) * REAL(0.5);
    const ella_real t20 = t19 * theta_y;
    const ella_real t21 = t19 * theta_z;
    const ella_real Q_1 = new_quaternion_1 * t18 - (new_quaternion_3 * t20 + new_quaternion_4 * t21);
    const ella_real Q_2 = t18 * new_quaternion_2 + (new_quaternion_3 * t21 - new_quaternion_4 * t20);
    const ella_real Q_3 = new_quaternion_1 * t20 + t18 * new_quaternion_3 - new_quaternion_2 * t21;
    const ella_real Q_4 = new_quaternion_1 * t21 + t18 * new_quaternion_4 + new_quaternion_2 * t20;

    /* outputs */
    new_twist[0] = omega_R_x;
    new_twist[1] = omega_R_y;
    new_twist[2] = omega_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = base->v[2];
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega[0] = omega_T_x;
    tip->omega[1] = omega_T_y;
    tip->omega[2] = omega_T_z;
    tip->v[0] = v_T_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    tip->R[0] = R_xx;
    tip->R[1] = R_xy;
    tip->R[2] = R_xz;
    tip->R[3] = R_yx;
    tip->R[4] = R_yy;
    tip->R[5] = R_yz;
    tip->R[6] = R_zx;
    tip->R[7] = R_zy;
    tip->R[8] = R_zz;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = Q_1;
    tip->Q[1] = Q_2;
    tip->Q[2] = Q_3;
    tip->Q[3] = Q_4;
    return ELLA_OK;
}

/* joint rows, links like upper_arm: 623 operations */
static ella_status joint_rows_upper_arm(const ella_link_constants *c, ella_link_store *link, ella_node *base, ella_node *tip,
    const ella_real twist[6], const ella_real q[2], const ella_real quaternion[4],
    const ella_real gravity[3], const ella_real eta[3], const ella_real etadot[3], const ella_real tau[2],
    const int *place, ella_real *M, ella_real H[12], ella_real W[12])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_zz = ella_cos(q[0]);
    const ella_real R_rel_yy = ella_cos(q[1]);
    const ella_real R_rel_xx = R_rel_zz * R_rel_yy;
    const ella_real R_rel_yx = ella_sin(q[1]);
    const ella_real minus_R_rel_xy = R_rel_yx * R_rel_zz;
    const ella_real t1 = -minus_R_rel_xy;
    const ella_real R_rel_xz = ella_sin(q[0]);
    const ella_real minus_R_rel_zx = R_rel_xz * R_rel_yy;
    const ella_real t2 = -minus_R_rel_zx;
    const ella_real R_rel_zy = R_rel_xz * R_rel_yx;

    const ella_real t3 = R_rel_yx * R_rel_yx + R_rel_yy * R_rel_yy;
    if (!(t3 - ELLA_REAL_EPSILON * 64 > 0)) { return ELLA_SINGULAR; }
    const ella_real t4 = 1 / t3;
    const ella_real t5 = R_rel_yx * t4;
    const ella_real t6 = R_rel_yy * t4;
    const ella_real omega_R_x = R_rel_xx * base->omega[0] + R_rel_yx * base->omega[1]
        - minus_R_rel_zx * base->omega[2];
    const ella_real omega_R_y = R_rel_yy * base->omega[1] - minus_R_rel_xy * base->omega[0]
        + R_rel_zy * base->omega[2];
    const ella_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_zz * base->omega[2];
    const ella_real qdot_2 = twist[2] - omega_R_z;
    const ella_real qdot_1 = t5 * (twist[0] - omega_R_x) + t6 * (twist[1] - omega_R_y);

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx * qdot_1;
    const ella_real omega_J_y = R_rel_yy * qdot_1;

    /* v_R: velocity of the joint point */
    const ella_real v_R_x = R_rel_xx * base->v[0] + R_rel_yx * base->v[1] - minus_R_rel_zx * base->v[2];
    const ella_real v_R_y = R_rel_yy * base->v[1] - minus_R_rel_xy * base->v[0] + R_rel_zy * base->v[2];
    const ella_real v_R_z = R_rel_xz * base->v[0] + R_rel_zz * base->v[2];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real t7 = qdot_1 * qdot_2;
    const ella_real beta_omega_x = omega_R_y * qdot_2 + t7 * R_rel_yy - omega_J_y * omega_R_z;
    const ella_real beta_omega_y = omega_J_x * omega_R_z - omega_R_x * qdot_2 - t7 * R_rel_yx;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const ella_real beta_v_x = qdot_2 * v_R_y - omega_J_y * v_R_z;
    const ella_real beta_v_y = omega_J_x * v_R_z - qdot_2 * v_R_x;
    const ella_real beta_v_z = omega_J_y * v_R_x - omega_J_x * v_R_y;

    const ella_real t8 = quaternion[1] * quaternion[1];
    const ella_real t9 = quaternion[2] * quaternion[2];
    const ella_real t10 = quaternion[3] * quaternion[3];
    const ella_real t11 = 2 / (quaternion[0] * quaternion[0] + t8 + t9 + t10);
    const ella_real t12 = t8 + t9 + t10;
    const ella_real t13 = quaternion[1] * quaternion[2];
    const ella_real t14 = quaternion[1] * quaternion[3];
    const ella_real t15 = quaternion[2] * quaternion[3];
    const ella_real t16 = quaternion[0] * quaternion[3];
    const ella_real t17 = quaternion[0] * quaternion[2];
    const ella_real t18 = quaternion[0] * quaternion[1];
    const ella_real t19 = (1 + t11 * (t8 - t12)) * gravity[0] + t11 * (t16 + t13) * gravity[1]
        + t11 * (t14 - t17) * gravity[2];
    const ella_real t20 = t11 * (t13 - t16) * gravity[0] + (1 + t11 * (t9 - t12)) * gravity[1]
        + t11 * (t18 + t15) * gravity[2];
    const ella_real t21 = t11 * (t17 + t14) * gravity[0] + t11 * (t15 - t18) * gravity[1]
        + (1 + t11 * (t10 - t12)) * gravity[2];

    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_z3;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_x = etadot[0] * c->sigma_x1;
    const ella_real Sdot_y = etadot[1] * c->sigma_y2;
    const ella_real Sdot_z = etadot[2] * c->sigma_z3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->M_Wphi_11 * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_x3 = c->chi_3 + c->Gamma_xz_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->M_Wphi_22 * eta[1];
    const ella_real L_y3 = eta[1] * c->mu;
    const ella_real L_z1 = c->Gamma_xz_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;
    const ella_real L_z3 = c->M_Wphi_33 * eta[2];

    /* Ldot: rate of L */
    const ella_real Ldot_x2 = c->Gamma_xy_11 * etadot[0];
    const ella_real Ldot_x3 = c->Gamma_xz_11 * etadot[0];
    const ella_real Ldot_y1 = c->Gamma_xy_11 * etadot[1];
    const ella_real Ldot_y3 = etadot[1] * c->mu;
    const ella_real Ldot_z1 = c->Gamma_xz_11 * etadot[2];
    const ella_real Ldot_z2 = etadot[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_3 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z3 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const ella_real a_0_x = twist[1] * twist[5] - t19 - twist[2] * twist[4];
    const ella_real a_0_y = twist[2] * twist[3] - t20 - twist[0] * twist[5];
    const ella_real a_0_z = twist[0] * twist[4] - t21 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const ella_real t22 = twist[1] * twist[1];
    const ella_real t23 = twist[2] * twist[2];
    const ella_real minus_Omega_xx = t22 + t23;
    const ella_real Omega_xy = twist[0] * twist[1];
    const ella_real Omega_xz = twist[0] * twist[2];
    const ella_real t24 = twist[0] * twist[0];
    const ella_real minus_Omega_yy = t24 + t23;
    const ella_real Omega_yz = twist[1] * twist[2];
    const ella_real minus_Omega_zz = t24 + t22;

    /* B: moment of the elastic velocity */
    const ella_real B_xx = L_x1 * etadot[0];
    const ella_real B_xy = L_y1 * etadot[0];
    const ella_real B_xz = L_z1 * etadot[0];
    const ella_real B_yx = L_x2 * etadot[1];
    const ella_real B_yy = L_y2 * etadot[1];
    const ella_real B_yz = L_z2 * etadot[1];
    const ella_real B_zx = L_x3 * etadot[2];
    const ella_real B_zy = L_y3 * etadot[2];
    const ella_real B_zz = L_z3 * etadot[2];

    /* h_c: half of the Coriolis wrench */
    const ella_real h_c_1 = B_yy * twist[0] + B_zz * twist[0] - B_xy * twist[1] - B_xz * twist[2];
    const ella_real h_c_2 = B_xx * twist[1] + B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const ella_real h_c_3 = B_xx * twist[2] + B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const ella_real h_c_4 = Sdot_z * twist[1] - Sdot_y * twist[2];
    const ella_real h_c_5 = Sdot_x * twist[2] - Sdot_z * twist[0];
    const ella_real h_c_6 = Sdot_y * twist[0] - Sdot_x * twist[1];

    /* H_star: gyroscopic wrench and weight (29) */
    const ella_real t25 = h_c_1 + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const ella_real H_star_1 = t25 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const ella_real t26 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const ella_real t27 = c->I_s * twist[0];
    const ella_real H_star_2 = t26 + t27 * twist[2] - J_xx * Omega_xz - J_xy * Omega_yz - S_x * a_0_z;
    const ella_real t28 = h_c_3 + J_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + S_x * a_0_y;
    const ella_real H_star_3 = t28 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t27 * twist[1];
    const ella_real H_star_4 = h_c_4 - minus_Omega_xx * S_x + Omega_xy * S_y + Omega_xz * S_z + a_0_x * c->mu;
    const ella_real H_star_5 = h_c_5 + Omega_xy * S_x - minus_Omega_yy * S_y + Omega_yz * S_z + a_0_y * c->mu;
    const ella_real H_star_6 = h_c_6 + Omega_xz * S_x + Omega_yz * S_y - minus_Omega_zz * S_z + a_0_z * c->mu;

    /* h_V: bias of the twist rows */
    const ella_real h_V_1 = H_star_1 + h_c_1;
    const ella_real h_V_2 = H_star_2 + h_c_2;
    const ella_real h_V_3 = H_star_3 + h_c_3;
    const ella_real h_V_4 = H_star_4 + h_c_4;
    const ella_real h_V_5 = H_star_5 + h_c_5;
    const ella_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const ella_real t29 = L_y1 * Omega_xy - L_x1 * minus_Omega_xx + L_z1 * Omega_xz + a_0_x * c->sigma_x1
        + Ldot_z1 * 2 * twist[1];
    const ella_real h_eta_1 = t29 - Ldot_y1 * 2 * twist[2];
    const ella_real t30 = L_x2 * Omega_xy - L_y2 * minus_Omega_yy + L_z2 * Omega_yz + a_0_y * c->sigma_y2
        + Ldot_x2 * 2 * twist[2];
    const ella_real h_eta_2 = t30 - Ldot_z2 * 2 * twist[0];
    const ella_real t31 = L_x3 * Omega_xz + L_y3 * Omega_yz - L_z3 * minus_Omega_zz + a_0_z * c->sigma_z3
        + Ldot_y3 * 2 * twist[0];
    const ella_real h_eta_3 = t31 - Ldot_x3 * 2 * twist[1];

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    const ella_real r_T_y = eta[1] * 2;
    const ella_real r_T_z = eta[2] * 2;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_y = c->Psi_c_y3 * eta[2];
    const ella_real theta_z = c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const ella_real minus_theta_hat2_33 = theta_y * theta_y;
    const ella_real minus_theta_hat2_22 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const ella_real t32 = ella_c5(x);
    const ella_real c3 = REAL(0.16666666666666666) - x * t32;
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real t33 = ella_c4(x);
    const ella_real c2 = REAL(0.5) - x * t33;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real minus_J_l_xy = c2 * theta_z;
    const ella_real J_l_xz = c2 * theta_y;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const ella_real J_l_yz = c3 * theta_hat2_23;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    const ella_real minus_R_T_xy = c1 * theta_z;
    const ella_real R_T_xz = c1 * theta_y;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_x = etadot[0] * REAL(1.4142135623730951);
    const ella_real udot_T_y = etadot[1] * 2;
    const ella_real udot_T_z = etadot[2] * 2;

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_y = c->Psi_c_y3 * etadot[2];
    const ella_real thetadot_z = c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t34 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t34;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t34;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t34;

    /* xdot: rate of the squared angle */
    const ella_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const ella_real c2dot = xdot * (t33 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const ella_real c3dot = xdot * (t32 * REAL(1.5) - t33 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_x = c2dot * t34;
    const ella_real alpha_s_y = c3 * thetadot_z * t34 + c3dot * theta_z * t34;
    const ella_real minus_alpha_s_z = c3 * thetadot_y * t34 + c3dot * theta_y * t34;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t35 = omega_s_x + twist[0];
    const ella_real t36 = omega_s_y + twist[1];
    const ella_real t37 = omega_s_z + twist[2];
    const ella_real omega_T_x = R_T_xx * t35 + minus_R_T_xy * t36 - R_T_xz * t37;
    const ella_real omega_T_y = R_T_yy * t36 - minus_R_T_xy * t35 + R_T_yz * t37;
    const ella_real omega_T_z = R_T_xz * t35 + R_T_yz * t36 + R_T_zz * t37;

    /* v_T: velocity of the tip point (46) */
    const ella_real t38 = udot_T_x + twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const ella_real t39 = udot_T_y + twist[4] + twist[2] * r_T_x - twist[0] * r_T_z;
    const ella_real t40 = udot_T_z + twist[5] + twist[0] * r_T_y - twist[1] * r_T_x;
    const ella_real v_T_x = R_T_xx * t38 + minus_R_T_xy * t39 - R_T_xz * t40;
    const ella_real v_T_y = R_T_yy * t39 - minus_R_T_xy * t38 + R_T_yz * t40;
    const ella_real v_T_z = R_T_xz * t38 + R_T_yz * t39 + R_T_zz * t40;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const ella_real t41 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const ella_real t42 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const ella_real t43 = omega_s_y * twist[0] - minus_alpha_s_z - omega_s_x * twist[1];
    const ella_real b_omega_x = R_T_xx * t41 + minus_R_T_xy * t42 - R_T_xz * t43;
    const ella_real b_omega_y = R_T_yy * t42 - minus_R_T_xy * t41 + R_T_yz * t43;
    const ella_real b_omega_z = R_T_xz * t41 + R_T_yz * t42 + R_T_zz * t43;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const ella_real t44 = omega_s_z * t39 + twist[1] * udot_T_z - omega_s_y * t40 - twist[2] * udot_T_y;
    const ella_real t45 = omega_s_x * t40 + twist[2] * udot_T_x - omega_s_z * t38 - twist[0] * udot_T_z;
    const ella_real t46 = omega_s_y * t38 + twist[0] * udot_T_y - omega_s_x * t39 - twist[1] * udot_T_x;
    const ella_real b_v_x = R_T_xx * t44 + minus_R_T_xy * t45 - R_T_xz * t46;
    const ella_real b_v_y = R_T_yy * t45 - minus_R_T_xy * t44 + R_T_yz * t46;
    const ella_real b_v_z = R_T_xz * t44 + R_T_yz * t45 + R_T_zz * t46;

    const ella_real t47 = R_T_xx * t19 + minus_R_T_xy * t20 - R_T_xz * t21;
    const ella_real t48 = R_T_yy * t20 - minus_R_T_xy * t19 + R_T_yz * t21;
    const ella_real t49 = R_T_xz * t19 + R_T_yz * t20 + R_T_zz * t21;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const ella_real a_T_x = omega_T_y * v_T_z - t47 - omega_T_z * v_T_y;
    const ella_real a_T_y = omega_T_z * v_T_x - t48 - omega_T_x * v_T_z;
    const ella_real a_T_z = omega_T_x * v_T_y - t49 - omega_T_y * v_T_x;

    /* h_T_F: force that the bodies' velocities and weight need */
    const ella_real h_T_F_x = a_T_x * c->body0_mass;
    const ella_real h_T_F_y = a_T_y * c->body0_mass;
    const ella_real h_T_F_z = a_T_z * c->body0_mass;

    /* N: projector onto the joint's axes */
    const ella_real N_xx = t5 * R_rel_yx;
    const ella_real N_xy = t6 * R_rel_yx;
    const ella_real N_yx = t5 * R_rel_yy;
    const ella_real N_yy = t6 * R_rel_yy;

    /* P_c: P with the rotor inertias about the axes (43) */
    const ella_real P_c_11 = 1 - N_xx;
    const ella_real P_c_22 = 1 - N_yy;

    /* PX: columns of the parent's tip, with a minus sign (59) */
    const ella_real PX_11 = P_c_11 * R_rel_xx + N_xy * minus_R_rel_xy;
    const ella_real PX_12 = P_c_11 * R_rel_yx - N_xy * R_rel_yy;
    const ella_real minus_PX_13 = P_c_11 * minus_R_rel_zx + N_xy * R_rel_zy;
    const ella_real t50 = -minus_PX_13;
    const ella_real minus_PX_21 = P_c_22 * minus_R_rel_xy + N_yx * R_rel_xx;
    const ella_real t51 = -minus_PX_21;
    const ella_real PX_22 = P_c_22 * R_rel_yy - N_yx * R_rel_yx;
    const ella_real PX_23 = P_c_22 * R_rel_zy + N_yx * minus_R_rel_zx;

    /* joint_H: what the velocities, springs and dampers leave in the joint's rows (61) */
    const ella_real joint_H_1 = N_xy * beta_omega_y - PX_11 * base->b[0] - PX_12 * base->b[1]
        + minus_PX_13 * base->b[2] - P_c_11 * beta_omega_x;
    const ella_real joint_H_2 = N_yx * beta_omega_x + minus_PX_21 * base->b[0] - PX_22 * base->b[1]
        - PX_23 * base->b[2] - P_c_22 * beta_omega_y;
    const ella_real joint_H_4 = minus_R_rel_zx * base->b[5]
        - (beta_v_x + R_rel_xx * base->b[3] + R_rel_yx * base->b[4]);
    const ella_real joint_H_5 = minus_R_rel_xy * base->b[3] - beta_v_y - R_rel_yy * base->b[4]
        - R_rel_zy * base->b[5];
    const ella_real minus_joint_H_6 = beta_v_z + R_rel_xz * base->b[3] + R_rel_zz * base->b[5];
    const ella_real t52 = -minus_joint_H_6;

    /* joint_W: the motors' torques in the joint's rows (62) */
    const ella_real joint_W_1 = t5 * tau[0];
    const ella_real joint_W_2 = t6 * tau[0];

    const ella_real t53 = -N_xy;
    const ella_real t54 = -N_yx;

    /* outputs */
    link->M_V[0] = I_xx;
    link->M_V[1] = J_xy;
    link->M_V[2] = J_xz;
    link->M_V[3] = S_z;
    link->M_V[4] = S_y;
    link->M_V[5] = I_yy;
    link->M_V[6] = J_yz;
    link->M_V[7] = S_x;
    link->M_V[8] = I_zz;
    link->M_D[0] = L_z2;
    link->M_D[1] = L_y3;
    link->M_D[2] = L_z1;
    link->M_D[3] = L_x3;
    link->M_D[4] = L_y1;
    link->M_D[5] = L_x2;
    link->h_V[0] = h_V_1;
    link->h_V[1] = h_V_2;
    link->h_V[2] = h_V_3;
    link->h_V[3] = h_V_4;
    link->h_V[4] = h_V_5;
    link->h_V[5] = h_V_6;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
    link->h_eta[2] = h_eta_3;
    link->r_T[0] = r_T_x;
    link->r_T[1] = r_T_y;
    link->r_T[2] = r_T_z;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = minus_R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yy;
    link->R_T[4] = R_T_yz;
    link->R_T[5] = R_T_zz;
    link->G[0] = c1;
    link->G[1] = minus_J_l_xy;
    link->G[2] = J_l_xz;
    link->G[3] = J_l_yy;
    link->G[4] = J_l_yz;
    link->G[5] = J_l_zz;
    link->b_T[0] = b_omega_x;
    link->b_T[1] = b_omega_y;
    link->b_T[2] = b_omega_z;
    link->b_T[3] = b_v_x;
    link->b_T[4] = b_v_y;
    link->b_T[5] = b_v_z;
    tip->omega[0] = omega_T_x;
    tip->omega[1] = omega_T_y;
    tip->omega[2] = omega_T_z;
    tip->v[0] = v_T_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    link->h_T[0] = h_T_F_x;
    link->h_T[1] = h_T_F_y;
    link->h_T[2] = h_T_F_z;
    M[place[0]] = N_xx;
    M[place[1]] = N_xy;
    M[place[2]] = N_yx;
    M[place[3]] = N_yy;
    M[place[4]] = 1;
    M[place[5]] = P_c_11;
    M[place[6]] = t53;
    M[place[7]] = t54;
    M[place[8]] = P_c_22;
    M[place[9]] = 1;
    M[place[10]] = 1;
    M[place[11]] = 1;
    H[0] = joint_H_1;
    H[1] = joint_H_2;
    H[2] = 0;
    H[3] = joint_H_4;
    H[4] = joint_H_5;
    H[5] = t52;
    W[0] = joint_W_1;
    W[1] = joint_W_2;
    W[2] = tau[1];
    W[3] = 0;
    W[4] = 0;
    W[5] = 0;
    base->X[0] = R_rel_xx;
    base->X[1] = R_rel_yx;
    base->X[2] = t2;
    base->X[3] = 0;
    base->X[4] = 0;
    base->X[5] = 0;
    base->X[6] = t1;
    base->X[7] = R_rel_yy;
    base->X[8] = R_rel_zy;
    base->X[9] = 0;
    base->X[10] = 0;
    base->X[11] = 0;
    base->X[12] = R_rel_xz;
    base->X[13] = 0;
    base->X[14] = R_rel_zz;
    base->X[15] = 0;
    base->X[16] = 0;
    base->X[17] = 0;
    base->X[18] = 0;
    base->X[19] = 0;
    base->X[20] = 0;
    base->X[21] = R_rel_xx;
    base->X[22] = R_rel_yx;
    base->X[23] = t2;
    base->X[24] = 0;
    base->X[25] = 0;
    base->X[26] = 0;
    base->X[27] = t1;
    base->X[28] = R_rel_yy;
    base->X[29] = R_rel_zy;
    base->X[30] = 0;
    base->X[31] = 0;
    base->X[32] = 0;
    base->X[33] = R_rel_xz;
    base->X[34] = 0;
    base->X[35] = R_rel_zz;
    base->PX[0] = PX_11;
    base->PX[1] = PX_12;
    base->PX[2] = t50;
    base->PX[3] = 0;
    base->PX[4] = 0;
    base->PX[5] = 0;
    base->PX[6] = t51;
    base->PX[7] = PX_22;
    base->PX[8] = PX_23;
    base->PX[9] = 0;
    base->PX[10] = 0;
    base->PX[11] = 0;
    base->PX[12] = 0;
    base->PX[13] = 0;
    base->PX[14] = 0;
    base->PX[15] = 0;
    base->PX[16] = 0;
    base->PX[17] = 0;
    base->PX[18] = 0;
    base->PX[19] = 0;
    base->PX[20] = 0;
    base->PX[21] = R_rel_xx;
    base->PX[22] = R_rel_yx;
    base->PX[23] = t2;
    base->PX[24] = 0;
    base->PX[25] = 0;
    base->PX[26] = 0;
    base->PX[27] = t1;
    base->PX[28] = R_rel_yy;
    base->PX[29] = R_rel_zy;
    base->PX[30] = 0;
    base->PX[31] = 0;
    base->PX[32] = 0;
    base->PX[33] = R_rel_xz;
    base->PX[34] = 0;
    base->PX[35] = R_rel_zz;
    tip->b[0] = b_omega_x;
    tip->b[1] = b_omega_y;
    tip->b[2] = b_omega_z;
    tip->b[3] = b_v_x;
    tip->b[4] = b_v_y;
    tip->b[5] = b_v_z;
    return ELLA_OK;
}

/* joint rows, links like forearm: 525 operations */
static ella_status joint_rows_forearm_last(const ella_link_constants *c, ella_link_store *link, ella_node *base, ella_node *tip,
    const ella_real twist[6], const ella_real q[1], const ella_real quaternion[4],
    const ella_real gravity[3], const ella_real eta[3], const ella_real etadot[3], const ella_real tau[1],
    const int *place, ella_real *M, ella_real H[12], ella_real W[12])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_xx = ella_cos(q[0]);
    const ella_real minus_R_rel_xy = ella_sin(q[0]);
    const ella_real t1 = -minus_R_rel_xy;

    const ella_real omega_R_x = R_rel_xx * base->omega[0] + minus_R_rel_xy * base->omega[1];
    const ella_real omega_R_y = R_rel_xx * base->omega[1] - minus_R_rel_xy * base->omega[0];
    const ella_real qdot_1 = twist[2] - base->omega[2];

    /* v_R: velocity of the joint point */
    const ella_real v_R_x = R_rel_xx * base->v[0] + minus_R_rel_xy * base->v[1];
    const ella_real v_R_y = R_rel_xx * base->v[1] - minus_R_rel_xy * base->v[0];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real beta_omega_x = omega_R_y * qdot_1;
    const ella_real minus_beta_omega_y = omega_R_x * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const ella_real beta_v_x = qdot_1 * v_R_y;
    const ella_real minus_beta_v_y = qdot_1 * v_R_x;

    const ella_real t2 = quaternion[1] * quaternion[1];
    const ella_real t3 = quaternion[2] * quaternion[2];
    const ella_real t4 = quaternion[3] * quaternion[3];
    const ella_real t5 = 2 / (quaternion[0] * quaternion[0] + t2 + t3 + t4);
    const ella_real t6 = t2 + t3 + t4;
    const ella_real t7 = quaternion[1] * quaternion[2];
    const ella_real t8 = quaternion[1] * quaternion[3];
    const ella_real t9 = quaternion[2] * quaternion[3];
    const ella_real t10 = quaternion[0] * quaternion[3];
    const ella_real t11 = quaternion[0] * quaternion[2];
    const ella_real t12 = quaternion[0] * quaternion[1];
    const ella_real t13 = (1 + t5 * (t2 - t6)) * gravity[0] + t5 * (t10 + t7) * gravity[1]
        + t5 * (t8 - t11) * gravity[2];
    const ella_real t14 = t5 * (t7 - t10) * gravity[0] + (1 + t5 * (t3 - t6)) * gravity[1]
        + t5 * (t12 + t9) * gravity[2];
    const ella_real t15 = t5 * (t11 + t8) * gravity[0] + t5 * (t9 - t12) * gravity[1]
        + (1 + t5 * (t4 - t6)) * gravity[2];

    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_z3;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_x = etadot[0] * c->sigma_x1;
    const ella_real Sdot_y = etadot[1] * c->sigma_y2;
    const ella_real Sdot_z = etadot[2] * c->sigma_z3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->M_Wphi_11 * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_x3 = c->chi_3 + c->Gamma_xz_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->M_Wphi_22 * eta[1];
    const ella_real L_y3 = eta[1] * c->mu;
    const ella_real L_z1 = c->Gamma_xz_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;
    const ella_real L_z3 = c->M_Wphi_33 * eta[2];

    /* Ldot: rate of L */
    const ella_real Ldot_x2 = c->Gamma_xy_11 * etadot[0];
    const ella_real Ldot_x3 = c->Gamma_xz_11 * etadot[0];
    const ella_real Ldot_y1 = c->Gamma_xy_11 * etadot[1];
    const ella_real Ldot_y3 = etadot[1] * c->mu;
    const ella_real Ldot_z1 = c->Gamma_xz_11 * etadot[2];
    const ella_real Ldot_z2 = etadot[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_3 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z3 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const ella_real a_0_x = twist[1] * twist[5] - t13 - twist[2] * twist[4];
    const ella_real a_0_y = twist[2] * twist[3] - t14 - twist[0] * twist[5];
    const ella_real a_0_z = twist[0] * twist[4] - t15 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const ella_real t16 = twist[1] * twist[1];
    const ella_real t17 = twist[2] * twist[2];
    const ella_real minus_Omega_xx = t16 + t17;
    const ella_real Omega_xy = twist[0] * twist[1];
    const ella_real Omega_xz = twist[0] * twist[2];
    const ella_real t18 = twist[0] * twist[0];
    const ella_real minus_Omega_yy = t18 + t17;
    const ella_real Omega_yz = twist[1] * twist[2];
    const ella_real minus_Omega_zz = t18 + t16;

    /* B: moment of the elastic velocity */
    const ella_real B_xx = L_x1 * etadot[0];
    const ella_real B_xy = L_y1 * etadot[0];
    const ella_real B_xz = L_z1 * etadot[0];
    const ella_real B_yx = L_x2 * etadot[1];
    const ella_real B_yy = L_y2 * etadot[1];
    const ella_real B_yz = L_z2 * etadot[1];
    const ella_real B_zx = L_x3 * etadot[2];
    const ella_real B_zy = L_y3 * etadot[2];
    const ella_real B_zz = L_z3 * etadot[2];

    /* h_c: half of the Coriolis wrench */
    const ella_real h_c_1 = B_yy * twist[0] + B_zz * twist[0] - B_xy * twist[1] - B_xz * twist[2];
    const ella_real h_c_2 = B_xx * twist[1] + B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const ella_real h_c_3 = B_xx * twist[2] + B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const ella_real h_c_4 = Sdot_z * twist[1] - Sdot_y * twist[2];
    const ella_real h_c_5 = Sdot_x * twist[2] - Sdot_z * twist[0];
    const ella_real h_c_6 = Sdot_y * twist[0] - Sdot_x * twist[1];

    /* H_star: gyroscopic wrench and weight (29) */
    const ella_real t19 = h_c_1 + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const ella_real H_star_1 = t19 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const ella_real t20 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const ella_real t21 = c->I_s * twist[0];
    const ella_real H_star_2 = t20 + t21 * twist[2] - J_xx * Omega_xz - J_xy * Omega_yz - S_x * a_0_z;
    const ella_real t22 = h_c_3 + J_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + S_x * a_0_y;
    const ella_real H_star_3 = t22 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t21 * twist[1];
    const ella_real H_star_4 = h_c_4 - minus_Omega_xx * S_x + Omega_xy * S_y + Omega_xz * S_z + a_0_x * c->mu;
    const ella_real H_star_5 = h_c_5 + Omega_xy * S_x - minus_Omega_yy * S_y + Omega_yz * S_z + a_0_y * c->mu;
    const ella_real H_star_6 = h_c_6 + Omega_xz * S_x + Omega_yz * S_y - minus_Omega_zz * S_z + a_0_z * c->mu;

    /* h_V: bias of the twist rows */
    const ella_real h_V_1 = H_star_1 + h_c_1;
    const ella_real h_V_2 = H_star_2 + h_c_2;
    const ella_real h_V_3 = H_star_3 + h_c_3;
    const ella_real h_V_4 = H_star_4 + h_c_4;
    const ella_real h_V_5 = H_star_5 + h_c_5;
    const ella_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const ella_real t23 = L_y1 * Omega_xy - L_x1 * minus_Omega_xx + L_z1 * Omega_xz + a_0_x * c->sigma_x1
        + Ldot_z1 * 2 * twist[1];
    const ella_real h_eta_1 = t23 - Ldot_y1 * 2 * twist[2];
    const ella_real t24 = L_x2 * Omega_xy - L_y2 * minus_Omega_yy + L_z2 * Omega_yz + a_0_y * c->sigma_y2
        + Ldot_x2 * 2 * twist[2];
    const ella_real h_eta_2 = t24 - Ldot_z2 * 2 * twist[0];
    const ella_real t25 = L_x3 * Omega_xz + L_y3 * Omega_yz - L_z3 * minus_Omega_zz + a_0_z * c->sigma_z3
        + Ldot_y3 * 2 * twist[0];
    const ella_real h_eta_3 = t25 - Ldot_x3 * 2 * twist[1];

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    const ella_real r_T_y = eta[1] * 2;
    const ella_real r_T_z = eta[2] * 2;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_y = c->Psi_c_y3 * eta[2];
    const ella_real theta_z = c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const ella_real minus_theta_hat2_33 = theta_y * theta_y;
    const ella_real minus_theta_hat2_22 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const ella_real t26 = ella_c5(x);
    const ella_real c3 = REAL(0.16666666666666666) - x * t26;
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real t27 = ella_c4(x);
    const ella_real c2 = REAL(0.5) - x * t27;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real minus_J_l_xy = c2 * theta_z;
    const ella_real J_l_xz = c2 * theta_y;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const ella_real J_l_yz = c3 * theta_hat2_23;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    const ella_real minus_R_T_xy = c1 * theta_z;
    const ella_real R_T_xz = c1 * theta_y;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_x = etadot[0] * REAL(1.4142135623730951);
    const ella_real udot_T_y = etadot[1] * 2;
    const ella_real udot_T_z = etadot[2] * 2;

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_y = c->Psi_c_y3 * etadot[2];
    const ella_real thetadot_z = c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t28 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t28;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t28;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t28;

    /* xdot: rate of the squared angle */
    const ella_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const ella_real c2dot = xdot * (t27 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const ella_real c3dot = xdot * (t26 * REAL(1.5) - t27 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_x = c2dot * t28;
    const ella_real alpha_s_y = c3 * thetadot_z * t28 + c3dot * theta_z * t28;
    const ella_real minus_alpha_s_z = c3 * thetadot_y * t28 + c3dot * theta_y * t28;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t29 = omega_s_x + twist[0];
    const ella_real t30 = omega_s_y + twist[1];
    const ella_real t31 = omega_s_z + twist[2];
    const ella_real omega_T_x = R_T_xx * t29 + minus_R_T_xy * t30 - R_T_xz * t31;
    const ella_real omega_T_y = R_T_yy * t30 - minus_R_T_xy * t29 + R_T_yz * t31;
    const ella_real omega_T_z = R_T_xz * t29 + R_T_yz * t30 + R_T_zz * t31;

    /* v_T: velocity of the tip point (46) */
    const ella_real t32 = udot_T_x + twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const ella_real t33 = udot_T_y + twist[4] + twist[2] * r_T_x - twist[0] * r_T_z;
    const ella_real t34 = udot_T_z + twist[5] + twist[0] * r_T_y - twist[1] * r_T_x;
    const ella_real v_T_x = R_T_xx * t32 + minus_R_T_xy * t33 - R_T_xz * t34;
    const ella_real v_T_y = R_T_yy * t33 - minus_R_T_xy * t32 + R_T_yz * t34;
    const ella_real v_T_z = R_T_xz * t32 + R_T_yz * t33 + R_T_zz * t34;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const ella_real t35 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const ella_real t36 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const ella_real t37 = omega_s_y * twist[0] - minus_alpha_s_z - omega_s_x * twist[1];
    const ella_real b_omega_x = R_T_xx * t35 + minus_R_T_xy * t36 - R_T_xz * t37;
    const ella_real b_omega_y = R_T_yy * t36 - minus_R_T_xy * t35 + R_T_yz * t37;
    const ella_real b_omega_z = R_T_xz * t35 + R_T_yz * t36 + R_T_zz * t37;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const ella_real t38 = omega_s_z * t33 + twist[1] * udot_T_z - omega_s_y * t34 - twist[2] * udot_T_y;
    const ella_real t39 = omega_s_x * t34 + twist[2] * udot_T_x - omega_s_z * t32 - twist[0] * udot_T_z;
    const ella_real t40 = omega_s_y * t32 + twist[0] * udot_T_y - omega_s_x * t33 - twist[1] * udot_T_x;
    const ella_real b_v_x = R_T_xx * t38 + minus_R_T_xy * t39 - R_T_xz * t40;
    const ella_real b_v_y = R_T_yy * t39 - minus_R_T_xy * t38 + R_T_yz * t40;
    const ella_real b_v_z = R_T_xz * t38 + R_T_yz * t39 + R_T_zz * t40;

    const ella_real t41 = R_T_xx * t13 + minus_R_T_xy * t14 - R_T_xz * t15;
    const ella_real t42 = R_T_yy * t14 - minus_R_T_xy * t13 + R_T_yz * t15;
    const ella_real t43 = R_T_xz * t13 + R_T_yz * t14 + R_T_zz * t15;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const ella_real a_T_x = omega_T_y * v_T_z - t41 - omega_T_z * v_T_y;
    const ella_real a_T_y = omega_T_z * v_T_x - t42 - omega_T_x * v_T_z;
    const ella_real a_T_z = omega_T_x * v_T_y - t43 - omega_T_y * v_T_x;

    /* h_T_F: force that the bodies' velocities and weight need */
    const ella_real h_T_F_x = a_T_x * c->body0_mass;
    const ella_real h_T_F_y = a_T_y * c->body0_mass;
    const ella_real h_T_F_z = a_T_z * c->body0_mass;

    /* joint_H: what the velocities, springs and dampers leave in the joint's rows (61) */
    const ella_real minus_joint_H_1 = R_rel_xx * base->b[0] + minus_R_rel_xy * base->b[1] + beta_omega_x;
    const ella_real t44 = -minus_joint_H_1;
    const ella_real joint_H_2 = minus_R_rel_xy * base->b[0] - R_rel_xx * base->b[1] + minus_beta_omega_y;
    const ella_real minus_joint_H_4 = beta_v_x + R_rel_xx * base->b[3] + minus_R_rel_xy * base->b[4];
    const ella_real t45 = -minus_joint_H_4;
    const ella_real joint_H_5 = minus_beta_v_y + minus_R_rel_xy * base->b[3] - R_rel_xx * base->b[4];
    const ella_real t46 = -base->b[5];

    /* outputs */
    link->M_V[0] = I_xx;
    link->M_V[1] = J_xy;
    link->M_V[2] = J_xz;
    link->M_V[3] = S_z;
    link->M_V[4] = S_y;
    link->M_V[5] = I_yy;
    link->M_V[6] = J_yz;
    link->M_V[7] = S_x;
    link->M_V[8] = I_zz;
    link->M_D[0] = L_z2;
    link->M_D[1] = L_y3;
    link->M_D[2] = L_z1;
    link->M_D[3] = L_x3;
    link->M_D[4] = L_y1;
    link->M_D[5] = L_x2;
    link->h_V[0] = h_V_1;
    link->h_V[1] = h_V_2;
    link->h_V[2] = h_V_3;
    link->h_V[3] = h_V_4;
    link->h_V[4] = h_V_5;
    link->h_V[5] = h_V_6;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
    link->h_eta[2] = h_eta_3;
    link->r_T[0] = r_T_x;
    link->r_T[1] = r_T_y;
    link->r_T[2] = r_T_z;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = minus_R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yy;
    link->R_T[4] = R_T_yz;
    link->R_T[5] = R_T_zz;
    link->G[0] = c1;
    link->G[1] = minus_J_l_xy;
    link->G[2] = J_l_xz;
    link->G[3] = J_l_yy;
    link->G[4] = J_l_yz;
    link->G[5] = J_l_zz;
    link->b_T[0] = b_omega_x;
    link->b_T[1] = b_omega_y;
    link->b_T[2] = b_omega_z;
    link->b_T[3] = b_v_x;
    link->b_T[4] = b_v_y;
    link->b_T[5] = b_v_z;
    tip->omega[0] = omega_T_x;
    tip->omega[1] = omega_T_y;
    tip->omega[2] = omega_T_z;
    tip->v[0] = v_T_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    link->h_T[0] = h_T_F_x;
    link->h_T[1] = h_T_F_y;
    link->h_T[2] = h_T_F_z;
    M[place[0]] = 1;
    M[place[1]] = 1;
    M[place[2]] = 1;
    M[place[3]] = 1;
    M[place[4]] = 1;
    M[place[5]] = 1;
    H[0] = t44;
    H[1] = joint_H_2;
    H[2] = 0;
    H[3] = t45;
    H[4] = joint_H_5;
    H[5] = t46;
    W[0] = 0;
    W[1] = 0;
    W[2] = tau[0];
    W[3] = 0;
    W[4] = 0;
    W[5] = 0;
    base->X[0] = R_rel_xx;
    base->X[1] = minus_R_rel_xy;
    base->X[2] = 0;
    base->X[3] = 0;
    base->X[4] = 0;
    base->X[5] = 0;
    base->X[6] = t1;
    base->X[7] = R_rel_xx;
    base->X[8] = 0;
    base->X[9] = 0;
    base->X[10] = 0;
    base->X[11] = 0;
    base->X[12] = 0;
    base->X[13] = 0;
    base->X[14] = 1;
    base->X[15] = 0;
    base->X[16] = 0;
    base->X[17] = 0;
    base->X[18] = 0;
    base->X[19] = 0;
    base->X[20] = 0;
    base->X[21] = R_rel_xx;
    base->X[22] = minus_R_rel_xy;
    base->X[23] = 0;
    base->X[24] = 0;
    base->X[25] = 0;
    base->X[26] = 0;
    base->X[27] = t1;
    base->X[28] = R_rel_xx;
    base->X[29] = 0;
    base->X[30] = 0;
    base->X[31] = 0;
    base->X[32] = 0;
    base->X[33] = 0;
    base->X[34] = 0;
    base->X[35] = 1;
    base->PX[0] = R_rel_xx;
    base->PX[1] = minus_R_rel_xy;
    base->PX[2] = 0;
    base->PX[3] = 0;
    base->PX[4] = 0;
    base->PX[5] = 0;
    base->PX[6] = t1;
    base->PX[7] = R_rel_xx;
    base->PX[8] = 0;
    base->PX[9] = 0;
    base->PX[10] = 0;
    base->PX[11] = 0;
    base->PX[12] = 0;
    base->PX[13] = 0;
    base->PX[14] = 0;
    base->PX[15] = 0;
    base->PX[16] = 0;
    base->PX[17] = 0;
    base->PX[18] = 0;
    base->PX[19] = 0;
    base->PX[20] = 0;
    base->PX[21] = R_rel_xx;
    base->PX[22] = minus_R_rel_xy;
    base->PX[23] = 0;
    base->PX[24] = 0;
    base->PX[25] = 0;
    base->PX[26] = 0;
    base->PX[27] = t1;
    base->PX[28] = R_rel_xx;
    base->PX[29] = 0;
    base->PX[30] = 0;
    base->PX[31] = 0;
    base->PX[32] = 0;
    base->PX[33] = 0;
    base->PX[34] = 0;
    base->PX[35] = 1;
    tip->b[0] = b_omega_x;
    tip->b[1] = b_omega_y;
    tip->b[2] = b_omega_z;
    tip->b[3] = b_v_x;
    tip->b[4] = b_v_y;
    tip->b[5] = b_v_z;
    return ELLA_OK;
}

/* link rows, links like upper_arm: 1388 operations */
static ella_status link_rows_upper_arm(const ella_link_constants *c, const ella_link_store *link, const ella_node *tip,
    const ella_real m_eta[3], const ella_real f_eta[3], const ella_real w_ext[6], ella_real eta_H[3],
    ella_real eta_W[3], const int *place, ella_real *M, ella_real H[12], ella_real W[12])
{

    const ella_real t1 = link->h_eta[0] + f_eta[0];
    const ella_real t2 = link->h_eta[1] + f_eta[1];
    const ella_real t3 = link->h_eta[2] + f_eta[2];

    /* J_TV: twist of the tip section from that of F_i (46) */
    const ella_real t4 = link->R_T[2] * link->r_T[1];
    const ella_real t5 = link->R_T[1] * link->r_T[2];
    const ella_real minus_J_TV_41 = t4 + t5;
    const ella_real J_TV_42 = link->R_T[0] * link->r_T[2] + link->R_T[2] * link->r_T[0];
    const ella_real J_TV_43 = link->R_T[1] * link->r_T[0] - link->R_T[0] * link->r_T[1];
    const ella_real J_TV_51 = link->R_T[4] * link->r_T[1] - link->R_T[3] * link->r_T[2];
    const ella_real t6 = link->R_T[4] * link->r_T[0];
    const ella_real minus_J_TV_52 = t5 + t6;
    const ella_real J_TV_53 = link->R_T[3] * link->r_T[0] + link->R_T[1] * link->r_T[1];
    const ella_real J_TV_61 = link->R_T[5] * link->r_T[1] - link->R_T[4] * link->r_T[2];
    const ella_real J_TV_62 = link->R_T[2] * link->r_T[2] - link->R_T[5] * link->r_T[0];
    const ella_real J_TV_63 = t6 - t4;

    /* J_Teta: twist of the tip section from the modal rates (46) */
    const ella_real t7 = link->G[2] * c->Psi_c_z2;
    const ella_real t8 = link->G[4] * c->Psi_c_z2;
    const ella_real t9 = link->G[5] * c->Psi_c_z2;
    const ella_real J_Teta_12 = link->R_T[0] * t7 + link->R_T[1] * t8 - link->R_T[2] * t9;
    const ella_real t10 = link->G[1] * c->Psi_c_y3;
    const ella_real t11 = link->G[3] * c->Psi_c_y3;
    const ella_real t12 = link->G[4] * c->Psi_c_y3;
    const ella_real J_Teta_13 = link->R_T[1] * t11 - link->R_T[0] * t10 - link->R_T[2] * t12;
    const ella_real J_Teta_22 = link->R_T[3] * t8 - link->R_T[1] * t7 + link->R_T[4] * t9;
    const ella_real J_Teta_23 = link->R_T[1] * t10 + link->R_T[3] * t11 + link->R_T[4] * t12;
    const ella_real J_Teta_32 = link->R_T[2] * t7 + link->R_T[4] * t8 + link->R_T[5] * t9;
    const ella_real J_Teta_33 = link->R_T[4] * t11 - link->R_T[2] * t10 + link->R_T[5] * t12;
    const ella_real J_Teta_41 = link->R_T[0] * REAL(1.4142135623730951);
    const ella_real J_Teta_42 = link->R_T[1] * 2;
    const ella_real minus_J_Teta_43 = link->R_T[2] * 2;
    const ella_real minus_J_Teta_51 = link->R_T[1] * REAL(1.4142135623730951);
    const ella_real J_Teta_52 = link->R_T[3] * 2;
    const ella_real J_Teta_53 = link->R_T[4] * 2;
    const ella_real J_Teta_61 = link->R_T[2] * REAL(1.4142135623730951);
    const ella_real J_Teta_63 = link->R_T[5] * 2;

    /* V_V: twist rows, twist columns (100) */
    const ella_real t13 = minus_J_TV_41 * c->body0_mass;
    const ella_real t14 = J_TV_51 * c->body0_mass;
    const ella_real t15 = J_TV_61 * c->body0_mass;
    const ella_real V_V_11 = link->M_V[0] + minus_J_TV_41 * t13 + J_TV_51 * t14 + J_TV_61 * t15;
    const ella_real V_V_12 = J_TV_62 * t15 - (link->M_V[1] + J_TV_42 * t13 + minus_J_TV_52 * t14);
    const ella_real V_V_13 = J_TV_53 * t14 - (link->M_V[2] + J_TV_43 * t13) + J_TV_63 * t15;
    const ella_real V_V_14 = link->R_T[2] * t15 - (link->R_T[0] * t13 + link->R_T[1] * t14);
    const ella_real V_V_15 = link->R_T[3] * t14 - (link->M_V[3] + link->R_T[1] * t13) + link->R_T[4] * t15;
    const ella_real V_V_16 = link->M_V[4] + link->R_T[2] * t13 + link->R_T[4] * t14 + link->R_T[5] * t15;
    const ella_real t16 = J_TV_42 * c->body0_mass;
    const ella_real t17 = minus_J_TV_52 * c->body0_mass;
    const ella_real t18 = J_TV_62 * c->body0_mass;
    const ella_real V_V_22 = link->M_V[5] + J_TV_42 * t16 + minus_J_TV_52 * t17 + J_TV_62 * t18;
    const ella_real V_V_23 = J_TV_43 * t16 - link->M_V[6] - J_TV_53 * t17 + J_TV_63 * t18;
    const ella_real V_V_24 = link->M_V[3] + link->R_T[0] * t16 + link->R_T[1] * t17 + link->R_T[2] * t18;
    const ella_real V_V_25 = link->R_T[1] * t16 - link->R_T[3] * t17 + link->R_T[4] * t18;
    const ella_real V_V_26 = link->R_T[5] * t18 - (link->M_V[7] + link->R_T[2] * t16 + link->R_T[4] * t17);
    const ella_real t19 = J_TV_43 * c->body0_mass;
    const ella_real t20 = J_TV_53 * c->body0_mass;
    const ella_real t21 = J_TV_63 * c->body0_mass;
    const ella_real V_V_33 = link->M_V[8] + J_TV_43 * t19 + J_TV_53 * t20 + J_TV_63 * t21;
    const ella_real V_V_34 = link->R_T[0] * t19 - link->M_V[4] - link->R_T[1] * t20 + link->R_T[2] * t21;
    const ella_real V_V_35 = link->M_V[7] + link->R_T[1] * t19 + link->R_T[3] * t20 + link->R_T[4] * t21;
    const ella_real V_V_36 = link->R_T[4] * t20 - link->R_T[2] * t19 + link->R_T[5] * t21;
    const ella_real t22 = c->body0_mass * link->R_T[0];
    const ella_real t23 = c->body0_mass * link->R_T[1];
    const ella_real t24 = link->R_T[1] * t23;
    const ella_real t25 = c->body0_mass * link->R_T[2];
    const ella_real t26 = link->R_T[2] * t25;
    const ella_real V_V_44 = c->mu + link->R_T[0] * t22 + t24 + t26;
    const ella_real V_V_45 = link->R_T[1] * t22 - link->R_T[3] * t23 + link->R_T[4] * t25;
    const ella_real V_V_46 = link->R_T[5] * t25 - (link->R_T[2] * t22 + link->R_T[4] * t23);
    const ella_real t27 = c->body0_mass * link->R_T[3];
    const ella_real t28 = c->body0_mass * link->R_T[4];
    const ella_real t29 = link->R_T[4] * t28;
    const ella_real V_V_55 = c->mu + t24 + link->R_T[3] * t27 + t29;
    const ella_real V_V_56 = link->R_T[4] * t27 - link->R_T[2] * t23 + link->R_T[5] * t28;
    const ella_real t30 = c->body0_mass * link->R_T[5];
    const ella_real V_V_66 = c->mu + t26 + t29 + link->R_T[5] * t30;

    /* V_eta: twist rows, modal columns (100) */
    const ella_real V_eta_11 = J_Teta_61 * t15 - (J_Teta_41 * t13 + minus_J_Teta_51 * t14);
    const ella_real V_eta_12 = J_Teta_52 * t14 - (link->M_D[0] + J_Teta_42 * t13) + J_Teta_53 * t15;
    const ella_real V_eta_13 = link->M_D[1] + minus_J_Teta_43 * t13 + J_Teta_53 * t14 + J_Teta_63 * t15;
    const ella_real V_eta_21 = link->M_D[2] + J_Teta_41 * t16 + minus_J_Teta_51 * t17 + J_Teta_61 * t18;
    const ella_real V_eta_22 = J_Teta_42 * t16 - J_Teta_52 * t17 + J_Teta_53 * t18;
    const ella_real V_eta_23 = J_Teta_63 * t18 - (link->M_D[3] + minus_J_Teta_43 * t16 + J_Teta_53 * t17);
    const ella_real V_eta_31 = J_Teta_41 * t19 - link->M_D[4] - minus_J_Teta_51 * t20 + J_Teta_61 * t21;
    const ella_real V_eta_32 = link->M_D[5] + J_Teta_42 * t19 + J_Teta_52 * t20 + J_Teta_53 * t21;
    const ella_real V_eta_33 = J_Teta_53 * t20 - minus_J_Teta_43 * t19 + J_Teta_63 * t21;
    const ella_real V_eta_41 = c->sigma_x1 + J_Teta_41 * t22 + minus_J_Teta_51 * t23 + J_Teta_61 * t25;
    const ella_real V_eta_42 = J_Teta_42 * t22 - J_Teta_52 * t23 + J_Teta_53 * t25;
    const ella_real V_eta_43 = J_Teta_63 * t25 - (minus_J_Teta_43 * t22 + J_Teta_53 * t23);
    const ella_real V_eta_51 = J_Teta_41 * t23 - minus_J_Teta_51 * t27 + J_Teta_61 * t28;
    const ella_real t31 = J_Teta_53 * t28;
    const ella_real V_eta_52 = c->sigma_y2 + J_Teta_42 * t23 + J_Teta_52 * t27 + t31;
    const ella_real V_eta_53 = J_Teta_53 * t27 - minus_J_Teta_43 * t23 + J_Teta_63 * t28;
    const ella_real V_eta_61 = J_Teta_61 * t30 - (J_Teta_41 * t25 + minus_J_Teta_51 * t28);
    const ella_real V_eta_62 = J_Teta_52 * t28 - J_Teta_42 * t25 + J_Teta_53 * t30;
    const ella_real V_eta_63 = c->sigma_z3 + minus_J_Teta_43 * t25 + t31 + J_Teta_63 * t30;

    /* eta_eta: modal rows, modal columns (100) */
    const ella_real t32 = J_Teta_41 * c->body0_mass;
    const ella_real t33 = minus_J_Teta_51 * c->body0_mass;
    const ella_real t34 = J_Teta_61 * c->body0_mass;
    const ella_real eta_eta_11 = m_eta[0] + J_Teta_41 * t32 + minus_J_Teta_51 * t33 + J_Teta_61 * t34;
    const ella_real eta_eta_12 = J_Teta_42 * t32 - J_Teta_52 * t33 + J_Teta_53 * t34;
    const ella_real eta_eta_13 = J_Teta_63 * t34 - (minus_J_Teta_43 * t32 + J_Teta_53 * t33);
    const ella_real t35 = J_Teta_42 * c->body0_mass;
    const ella_real t36 = J_Teta_52 * c->body0_mass;
    const ella_real t37 = J_Teta_53 * c->body0_mass;
    const ella_real t38 = J_Teta_53 * t37;
    const ella_real eta_eta_22 = m_eta[1] + J_Teta_42 * t35 + J_Teta_52 * t36 + t38;
    const ella_real eta_eta_23 = J_Teta_53 * t36 - minus_J_Teta_43 * t35 + J_Teta_63 * t37;
    const ella_real eta_eta_33 = m_eta[2] + minus_J_Teta_43 * (minus_J_Teta_43 * c->body0_mass) + t38
        + J_Teta_63 * (J_Teta_63 * c->body0_mass);

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const ella_real t39 = J_TV_51 * tip->X[4] - minus_J_TV_41 * tip->X[3] + J_TV_61 * tip->X[5]
        + link->R_T[0] * tip->X[0] - link->R_T[1] * tip->X[1];
    const ella_real V_next_11 = t39 + link->R_T[2] * tip->X[2];
    const ella_real t40 = J_TV_51 * tip->X[10] - minus_J_TV_41 * tip->X[9] + J_TV_61 * tip->X[11]
        + link->R_T[0] * tip->X[6];
    const ella_real V_next_12 = t40 - link->R_T[1] * tip->X[7] + link->R_T[2] * tip->X[8];
    const ella_real t41 = J_TV_51 * tip->X[16] - minus_J_TV_41 * tip->X[15] + J_TV_61 * tip->X[17]
        + link->R_T[0] * tip->X[12];
    const ella_real V_next_13 = t41 - link->R_T[1] * tip->X[13] + link->R_T[2] * tip->X[14];
    const ella_real t42 = J_TV_51 * tip->X[22] - minus_J_TV_41 * tip->X[21] + J_TV_61 * tip->X[23]
        + link->R_T[0] * tip->X[18];
    const ella_real V_next_14 = t42 - link->R_T[1] * tip->X[19] + link->R_T[2] * tip->X[20];
    const ella_real t43 = J_TV_51 * tip->X[28] - minus_J_TV_41 * tip->X[27] + J_TV_61 * tip->X[29]
        + link->R_T[0] * tip->X[24];
    const ella_real V_next_15 = t43 - link->R_T[1] * tip->X[25] + link->R_T[2] * tip->X[26];
    const ella_real t44 = J_TV_51 * tip->X[34] - minus_J_TV_41 * tip->X[33] + J_TV_61 * tip->X[35]
        + link->R_T[0] * tip->X[30];
    const ella_real V_next_16 = t44 - link->R_T[1] * tip->X[31] + link->R_T[2] * tip->X[32];
    const ella_real t45 = J_TV_42 * tip->X[3] - minus_J_TV_52 * tip->X[4] + J_TV_62 * tip->X[5]
        + link->R_T[1] * tip->X[0] + link->R_T[3] * tip->X[1];
    const ella_real V_next_21 = t45 + link->R_T[4] * tip->X[2];
    const ella_real t46 = J_TV_42 * tip->X[9] - minus_J_TV_52 * tip->X[10] + J_TV_62 * tip->X[11]
        + link->R_T[1] * tip->X[6];
    const ella_real V_next_22 = t46 + link->R_T[3] * tip->X[7] + link->R_T[4] * tip->X[8];
    const ella_real t47 = J_TV_42 * tip->X[15] - minus_J_TV_52 * tip->X[16] + J_TV_62 * tip->X[17]
        + link->R_T[1] * tip->X[12];
    const ella_real V_next_23 = t47 + link->R_T[3] * tip->X[13] + link->R_T[4] * tip->X[14];
    const ella_real t48 = J_TV_42 * tip->X[21] - minus_J_TV_52 * tip->X[22] + J_TV_62 * tip->X[23]
        + link->R_T[1] * tip->X[18];
    const ella_real V_next_24 = t48 + link->R_T[3] * tip->X[19] + link->R_T[4] * tip->X[20];
    const ella_real t49 = J_TV_42 * tip->X[27] - minus_J_TV_52 * tip->X[28] + J_TV_62 * tip->X[29]
        + link->R_T[1] * tip->X[24];
    const ella_real V_next_25 = t49 + link->R_T[3] * tip->X[25] + link->R_T[4] * tip->X[26];
    const ella_real t50 = J_TV_42 * tip->X[33] - minus_J_TV_52 * tip->X[34] + J_TV_62 * tip->X[35]
        + link->R_T[1] * tip->X[30];
    const ella_real V_next_26 = t50 + link->R_T[3] * tip->X[31] + link->R_T[4] * tip->X[32];
    const ella_real t51 = J_TV_43 * tip->X[3] + J_TV_53 * tip->X[4] + J_TV_63 * tip->X[5]
        - link->R_T[2] * tip->X[0] + link->R_T[4] * tip->X[1];
    const ella_real V_next_31 = t51 + link->R_T[5] * tip->X[2];
    const ella_real t52 = J_TV_43 * tip->X[9] + J_TV_53 * tip->X[10] + J_TV_63 * tip->X[11]
        - link->R_T[2] * tip->X[6] + link->R_T[4] * tip->X[7];
    const ella_real V_next_32 = t52 + link->R_T[5] * tip->X[8];
    const ella_real t53 = J_TV_43 * tip->X[15] + J_TV_53 * tip->X[16] + J_TV_63 * tip->X[17]
        - link->R_T[2] * tip->X[12] + link->R_T[4] * tip->X[13];
    const ella_real V_next_33 = t53 + link->R_T[5] * tip->X[14];
    const ella_real t54 = J_TV_43 * tip->X[21] + J_TV_53 * tip->X[22] + J_TV_63 * tip->X[23]
        - link->R_T[2] * tip->X[18] + link->R_T[4] * tip->X[19];
    const ella_real V_next_34 = t54 + link->R_T[5] * tip->X[20];
    const ella_real t55 = J_TV_43 * tip->X[27] + J_TV_53 * tip->X[28] + J_TV_63 * tip->X[29]
        - link->R_T[2] * tip->X[24] + link->R_T[4] * tip->X[25];
    const ella_real V_next_35 = t55 + link->R_T[5] * tip->X[26];
    const ella_real t56 = J_TV_43 * tip->X[33] + J_TV_53 * tip->X[34] + J_TV_63 * tip->X[35]
        - link->R_T[2] * tip->X[30] + link->R_T[4] * tip->X[31];
    const ella_real V_next_36 = t56 + link->R_T[5] * tip->X[32];
    const ella_real V_next_41 = link->R_T[0] * tip->X[3] - link->R_T[1] * tip->X[4] + link->R_T[2] * tip->X[5];
    const ella_real V_next_42 = link->R_T[0] * tip->X[9] - link->R_T[1] * tip->X[10] + link->R_T[2] * tip->X[11];
    const ella_real V_next_43 = link->R_T[0] * tip->X[15] - link->R_T[1] * tip->X[16] + link->R_T[2] * tip->X[17];
    const ella_real V_next_44 = link->R_T[0] * tip->X[21] - link->R_T[1] * tip->X[22] + link->R_T[2] * tip->X[23];
    const ella_real V_next_45 = link->R_T[0] * tip->X[27] - link->R_T[1] * tip->X[28] + link->R_T[2] * tip->X[29];
    const ella_real V_next_46 = link->R_T[0] * tip->X[33] - link->R_T[1] * tip->X[34] + link->R_T[2] * tip->X[35];
    const ella_real V_next_51 = link->R_T[1] * tip->X[3] + link->R_T[3] * tip->X[4] + link->R_T[4] * tip->X[5];
    const ella_real V_next_52 = link->R_T[1] * tip->X[9] + link->R_T[3] * tip->X[10] + link->R_T[4] * tip->X[11];
    const ella_real V_next_53 = link->R_T[1] * tip->X[15] + link->R_T[3] * tip->X[16] + link->R_T[4] * tip->X[17];
    const ella_real V_next_54 = link->R_T[1] * tip->X[21] + link->R_T[3] * tip->X[22] + link->R_T[4] * tip->X[23];
    const ella_real V_next_55 = link->R_T[1] * tip->X[27] + link->R_T[3] * tip->X[28] + link->R_T[4] * tip->X[29];
    const ella_real V_next_56 = link->R_T[1] * tip->X[33] + link->R_T[3] * tip->X[34] + link->R_T[4] * tip->X[35];
    const ella_real V_next_61 = link->R_T[4] * tip->X[4] - link->R_T[2] * tip->X[3] + link->R_T[5] * tip->X[5];
    const ella_real V_next_62 = link->R_T[4] * tip->X[10] - link->R_T[2] * tip->X[9] + link->R_T[5] * tip->X[11];
    const ella_real V_next_63 = link->R_T[4] * tip->X[16] - link->R_T[2] * tip->X[15] + link->R_T[5] * tip->X[17];
    const ella_real V_next_64 = link->R_T[4] * tip->X[22] - link->R_T[2] * tip->X[21] + link->R_T[5] * tip->X[23];
    const ella_real V_next_65 = link->R_T[4] * tip->X[28] - link->R_T[2] * tip->X[27] + link->R_T[5] * tip->X[29];
    const ella_real V_next_66 = link->R_T[4] * tip->X[34] - link->R_T[2] * tip->X[33] + link->R_T[5] * tip->X[35];

    /* eta_next: modal rows, columns of the next joint's wrench (100) */
    const ella_real eta_next_11 = J_Teta_41 * tip->X[3] - minus_J_Teta_51 * tip->X[4] + J_Teta_61 * tip->X[5];
    const ella_real eta_next_12 = J_Teta_41 * tip->X[9] - minus_J_Teta_51 * tip->X[10] + J_Teta_61 * tip->X[11];
    const ella_real eta_next_13 = J_Teta_41 * tip->X[15] - minus_J_Teta_51 * tip->X[16] + J_Teta_61 * tip->X[17];
    const ella_real eta_next_14 = J_Teta_41 * tip->X[21] - minus_J_Teta_51 * tip->X[22] + J_Teta_61 * tip->X[23];
    const ella_real eta_next_15 = J_Teta_41 * tip->X[27] - minus_J_Teta_51 * tip->X[28] + J_Teta_61 * tip->X[29];
    const ella_real eta_next_16 = J_Teta_41 * tip->X[33] - minus_J_Teta_51 * tip->X[34] + J_Teta_61 * tip->X[35];
    const ella_real t57 = J_Teta_12 * tip->X[0] + J_Teta_22 * tip->X[1] + J_Teta_32 * tip->X[2]
        + J_Teta_42 * tip->X[3] + J_Teta_52 * tip->X[4];
    const ella_real eta_next_21 = t57 + J_Teta_53 * tip->X[5];
    const ella_real t58 = J_Teta_12 * tip->X[6] + J_Teta_22 * tip->X[7] + J_Teta_32 * tip->X[8]
        + J_Teta_42 * tip->X[9] + J_Teta_52 * tip->X[10];
    const ella_real eta_next_22 = t58 + J_Teta_53 * tip->X[11];
    const ella_real t59 = J_Teta_12 * tip->X[12] + J_Teta_22 * tip->X[13] + J_Teta_32 * tip->X[14]
        + J_Teta_42 * tip->X[15];
    const ella_real eta_next_23 = t59 + J_Teta_52 * tip->X[16] + J_Teta_53 * tip->X[17];
    const ella_real t60 = J_Teta_12 * tip->X[18] + J_Teta_22 * tip->X[19] + J_Teta_32 * tip->X[20]
        + J_Teta_42 * tip->X[21];
    const ella_real eta_next_24 = t60 + J_Teta_52 * tip->X[22] + J_Teta_53 * tip->X[23];
    const ella_real t61 = J_Teta_12 * tip->X[24] + J_Teta_22 * tip->X[25] + J_Teta_32 * tip->X[26]
        + J_Teta_42 * tip->X[27];
    const ella_real eta_next_25 = t61 + J_Teta_52 * tip->X[28] + J_Teta_53 * tip->X[29];
    const ella_real t62 = J_Teta_12 * tip->X[30] + J_Teta_22 * tip->X[31] + J_Teta_32 * tip->X[32]
        + J_Teta_42 * tip->X[33];
    const ella_real eta_next_26 = t62 + J_Teta_52 * tip->X[34] + J_Teta_53 * tip->X[35];
    const ella_real t63 = J_Teta_13 * tip->X[0] + J_Teta_23 * tip->X[1] + J_Teta_33 * tip->X[2]
        - minus_J_Teta_43 * tip->X[3];
    const ella_real eta_next_31 = t63 + J_Teta_53 * tip->X[4] + J_Teta_63 * tip->X[5];
    const ella_real t64 = J_Teta_13 * tip->X[6] + J_Teta_23 * tip->X[7] + J_Teta_33 * tip->X[8]
        - minus_J_Teta_43 * tip->X[9];
    const ella_real eta_next_32 = t64 + J_Teta_53 * tip->X[10] + J_Teta_63 * tip->X[11];
    const ella_real t65 = J_Teta_13 * tip->X[12] + J_Teta_23 * tip->X[13] + J_Teta_33 * tip->X[14]
        - minus_J_Teta_43 * tip->X[15];
    const ella_real eta_next_33 = t65 + J_Teta_53 * tip->X[16] + J_Teta_63 * tip->X[17];
    const ella_real t66 = J_Teta_13 * tip->X[18] + J_Teta_23 * tip->X[19] + J_Teta_33 * tip->X[20]
        - minus_J_Teta_43 * tip->X[21];
    const ella_real eta_next_34 = t66 + J_Teta_53 * tip->X[22] + J_Teta_63 * tip->X[23];
    const ella_real t67 = J_Teta_13 * tip->X[24] + J_Teta_23 * tip->X[25] + J_Teta_33 * tip->X[26]
        - minus_J_Teta_43 * tip->X[27];
    const ella_real eta_next_35 = t67 + J_Teta_53 * tip->X[28] + J_Teta_63 * tip->X[29];
    const ella_real t68 = J_Teta_13 * tip->X[30] + J_Teta_23 * tip->X[31] + J_Teta_33 * tip->X[32]
        - minus_J_Teta_43 * tip->X[33];
    const ella_real eta_next_36 = t68 + J_Teta_53 * tip->X[34] + J_Teta_63 * tip->X[35];

    /* next_V: next joint's rows, twist columns (100) */
    const ella_real t69 = minus_J_TV_41 * tip->PX[3] - J_TV_51 * tip->PX[4] - J_TV_61 * tip->PX[5]
        - tip->PX[0] * link->R_T[0];
    const ella_real next_V_11 = t69 + tip->PX[1] * link->R_T[1] - tip->PX[2] * link->R_T[2];
    const ella_real t70 = minus_J_TV_52 * tip->PX[4] - J_TV_42 * tip->PX[3] - J_TV_62 * tip->PX[5]
        - tip->PX[0] * link->R_T[1];
    const ella_real next_V_12 = t70 - tip->PX[1] * link->R_T[3] - tip->PX[2] * link->R_T[4];
    const ella_real t71 = tip->PX[0] * link->R_T[2]
        - (J_TV_43 * tip->PX[3] + J_TV_53 * tip->PX[4] + J_TV_63 * tip->PX[5]) - tip->PX[1] * link->R_T[4];
    const ella_real next_V_13 = t71 - tip->PX[2] * link->R_T[5];
    const ella_real next_V_14 = tip->PX[4] * link->R_T[1] - tip->PX[3] * link->R_T[0] - tip->PX[5] * link->R_T[2];
    const ella_real minus_next_V_15 = tip->PX[3] * link->R_T[1] + tip->PX[4] * link->R_T[3]
        + tip->PX[5] * link->R_T[4];
    const ella_real t72 = -minus_next_V_15;
    const ella_real next_V_16 = tip->PX[3] * link->R_T[2] - tip->PX[4] * link->R_T[4] - tip->PX[5] * link->R_T[5];
    const ella_real t73 = minus_J_TV_41 * tip->PX[9] - J_TV_51 * tip->PX[10] - J_TV_61 * tip->PX[11]
        - tip->PX[6] * link->R_T[0];
    const ella_real next_V_21 = t73 + tip->PX[7] * link->R_T[1] - tip->PX[8] * link->R_T[2];
    const ella_real t74 = minus_J_TV_52 * tip->PX[10] - J_TV_42 * tip->PX[9] - J_TV_62 * tip->PX[11]
        - tip->PX[6] * link->R_T[1];
    const ella_real next_V_22 = t74 - tip->PX[7] * link->R_T[3] - tip->PX[8] * link->R_T[4];
    const ella_real t75 = tip->PX[6] * link->R_T[2]
        - (J_TV_43 * tip->PX[9] + J_TV_53 * tip->PX[10] + J_TV_63 * tip->PX[11]);
    const ella_real next_V_23 = t75 - tip->PX[7] * link->R_T[4] - tip->PX[8] * link->R_T[5];
    const ella_real next_V_24 = tip->PX[10] * link->R_T[1] - tip->PX[9] * link->R_T[0]
        - tip->PX[11] * link->R_T[2];
    const ella_real minus_next_V_25 = tip->PX[9] * link->R_T[1] + tip->PX[10] * link->R_T[3]
        + tip->PX[11] * link->R_T[4];
    const ella_real t76 = -minus_next_V_25;
    const ella_real next_V_26 = tip->PX[9] * link->R_T[2] - tip->PX[10] * link->R_T[4]
        - tip->PX[11] * link->R_T[5];
    const ella_real t77 = minus_J_TV_41 * tip->PX[15] - J_TV_51 * tip->PX[16] - J_TV_61 * tip->PX[17]
        - tip->PX[12] * link->R_T[0];
    const ella_real next_V_31 = t77 + tip->PX[13] * link->R_T[1] - tip->PX[14] * link->R_T[2];
    const ella_real t78 = minus_J_TV_52 * tip->PX[16] - J_TV_42 * tip->PX[15] - J_TV_62 * tip->PX[17]
        - tip->PX[12] * link->R_T[1];
    const ella_real next_V_32 = t78 - tip->PX[13] * link->R_T[3] - tip->PX[14] * link->R_T[4];
    const ella_real t79 = tip->PX[12] * link->R_T[2]
        - (J_TV_43 * tip->PX[15] + J_TV_53 * tip->PX[16] + J_TV_63 * tip->PX[17]);
    const ella_real next_V_33 = t79 - tip->PX[13] * link->R_T[4] - tip->PX[14] * link->R_T[5];
    const ella_real next_V_34 = tip->PX[16] * link->R_T[1] - tip->PX[15] * link->R_T[0]
        - tip->PX[17] * link->R_T[2];
    const ella_real minus_next_V_35 = tip->PX[15] * link->R_T[1] + tip->PX[16] * link->R_T[3]
        + tip->PX[17] * link->R_T[4];
    const ella_real t80 = -minus_next_V_35;
    const ella_real next_V_36 = tip->PX[15] * link->R_T[2] - tip->PX[16] * link->R_T[4]
        - tip->PX[17] * link->R_T[5];
    const ella_real t81 = minus_J_TV_41 * tip->PX[21] - J_TV_51 * tip->PX[22] - J_TV_61 * tip->PX[23]
        - tip->PX[18] * link->R_T[0];
    const ella_real next_V_41 = t81 + tip->PX[19] * link->R_T[1] - tip->PX[20] * link->R_T[2];
    const ella_real t82 = minus_J_TV_52 * tip->PX[22] - J_TV_42 * tip->PX[21] - J_TV_62 * tip->PX[23]
        - tip->PX[18] * link->R_T[1];
    const ella_real next_V_42 = t82 - tip->PX[19] * link->R_T[3] - tip->PX[20] * link->R_T[4];
    const ella_real t83 = tip->PX[18] * link->R_T[2]
        - (J_TV_43 * tip->PX[21] + J_TV_53 * tip->PX[22] + J_TV_63 * tip->PX[23]);
    const ella_real next_V_43 = t83 - tip->PX[19] * link->R_T[4] - tip->PX[20] * link->R_T[5];
    const ella_real next_V_44 = tip->PX[22] * link->R_T[1] - tip->PX[21] * link->R_T[0]
        - tip->PX[23] * link->R_T[2];
    const ella_real minus_next_V_45 = tip->PX[21] * link->R_T[1] + tip->PX[22] * link->R_T[3]
        + tip->PX[23] * link->R_T[4];
    const ella_real t84 = -minus_next_V_45;
    const ella_real next_V_46 = tip->PX[21] * link->R_T[2] - tip->PX[22] * link->R_T[4]
        - tip->PX[23] * link->R_T[5];
    const ella_real t85 = minus_J_TV_41 * tip->PX[27] - J_TV_51 * tip->PX[28] - J_TV_61 * tip->PX[29]
        - tip->PX[24] * link->R_T[0];
    const ella_real next_V_51 = t85 + tip->PX[25] * link->R_T[1] - tip->PX[26] * link->R_T[2];
    const ella_real t86 = minus_J_TV_52 * tip->PX[28] - J_TV_42 * tip->PX[27] - J_TV_62 * tip->PX[29]
        - tip->PX[24] * link->R_T[1];
    const ella_real next_V_52 = t86 - tip->PX[25] * link->R_T[3] - tip->PX[26] * link->R_T[4];
    const ella_real t87 = tip->PX[24] * link->R_T[2]
        - (J_TV_43 * tip->PX[27] + J_TV_53 * tip->PX[28] + J_TV_63 * tip->PX[29]);
    const ella_real next_V_53 = t87 - tip->PX[25] * link->R_T[4] - tip->PX[26] * link->R_T[5];
    const ella_real next_V_54 = tip->PX[28] * link->R_T[1] - tip->PX[27] * link->R_T[0]
        - tip->PX[29] * link->R_T[2];
    const ella_real minus_next_V_55 = tip->PX[27] * link->R_T[1] + tip->PX[28] * link->R_T[3]
        + tip->PX[29] * link->R_T[4];
    const ella_real t88 = -minus_next_V_55;
    const ella_real next_V_56 = tip->PX[27] * link->R_T[2] - tip->PX[28] * link->R_T[4]
        - tip->PX[29] * link->R_T[5];
    const ella_real t89 = minus_J_TV_41 * tip->PX[33] - J_TV_51 * tip->PX[34] - J_TV_61 * tip->PX[35]
        - tip->PX[30] * link->R_T[0];
    const ella_real next_V_61 = t89 + tip->PX[31] * link->R_T[1] - tip->PX[32] * link->R_T[2];
    const ella_real t90 = minus_J_TV_52 * tip->PX[34] - J_TV_42 * tip->PX[33] - J_TV_62 * tip->PX[35]
        - tip->PX[30] * link->R_T[1];
    const ella_real next_V_62 = t90 - tip->PX[31] * link->R_T[3] - tip->PX[32] * link->R_T[4];
    const ella_real t91 = tip->PX[30] * link->R_T[2]
        - (J_TV_43 * tip->PX[33] + J_TV_53 * tip->PX[34] + J_TV_63 * tip->PX[35]);
    const ella_real next_V_63 = t91 - tip->PX[31] * link->R_T[4] - tip->PX[32] * link->R_T[5];
    const ella_real next_V_64 = tip->PX[34] * link->R_T[1] - tip->PX[33] * link->R_T[0]
        - tip->PX[35] * link->R_T[2];
    const ella_real minus_next_V_65 = tip->PX[33] * link->R_T[1] + tip->PX[34] * link->R_T[3]
        + tip->PX[35] * link->R_T[4];
    const ella_real t92 = -minus_next_V_65;
    const ella_real next_V_66 = tip->PX[33] * link->R_T[2] - tip->PX[34] * link->R_T[4]
        - tip->PX[35] * link->R_T[5];

    /* next_eta: next joint's rows, modal columns (100) */
    const ella_real next_eta_11 = minus_J_Teta_51 * tip->PX[4] - J_Teta_41 * tip->PX[3] - J_Teta_61 * tip->PX[5];
    const ella_real t93 = J_Teta_12 * tip->PX[0] + J_Teta_22 * tip->PX[1] + J_Teta_32 * tip->PX[2]
        + J_Teta_42 * tip->PX[3];
    const ella_real minus_next_eta_12 = t93 + J_Teta_52 * tip->PX[4] + J_Teta_53 * tip->PX[5];
    const ella_real t94 = -minus_next_eta_12;
    const ella_real t95 = minus_J_Teta_43 * tip->PX[3]
        - (J_Teta_13 * tip->PX[0] + J_Teta_23 * tip->PX[1] + J_Teta_33 * tip->PX[2]);
    const ella_real next_eta_13 = t95 - J_Teta_53 * tip->PX[4] - J_Teta_63 * tip->PX[5];
    const ella_real next_eta_21 = minus_J_Teta_51 * tip->PX[10] - J_Teta_41 * tip->PX[9]
        - J_Teta_61 * tip->PX[11];
    const ella_real t96 = J_Teta_12 * tip->PX[6] + J_Teta_22 * tip->PX[7] + J_Teta_32 * tip->PX[8]
        + J_Teta_42 * tip->PX[9];
    const ella_real minus_next_eta_22 = t96 + J_Teta_52 * tip->PX[10] + J_Teta_53 * tip->PX[11];
    const ella_real t97 = -minus_next_eta_22;
    const ella_real t98 = minus_J_Teta_43 * tip->PX[9]
        - (J_Teta_13 * tip->PX[6] + J_Teta_23 * tip->PX[7] + J_Teta_33 * tip->PX[8]);
    const ella_real next_eta_23 = t98 - J_Teta_53 * tip->PX[10] - J_Teta_63 * tip->PX[11];
    const ella_real next_eta_31 = minus_J_Teta_51 * tip->PX[16] - J_Teta_41 * tip->PX[15]
        - J_Teta_61 * tip->PX[17];
    const ella_real t99 = J_Teta_12 * tip->PX[12] + J_Teta_22 * tip->PX[13] + J_Teta_32 * tip->PX[14]
        + J_Teta_42 * tip->PX[15];
    const ella_real minus_next_eta_32 = t99 + J_Teta_52 * tip->PX[16] + J_Teta_53 * tip->PX[17];
    const ella_real t100 = -minus_next_eta_32;
    const ella_real t101 = minus_J_Teta_43 * tip->PX[15]
        - (J_Teta_13 * tip->PX[12] + J_Teta_23 * tip->PX[13] + J_Teta_33 * tip->PX[14]);
    const ella_real next_eta_33 = t101 - J_Teta_53 * tip->PX[16] - J_Teta_63 * tip->PX[17];
    const ella_real next_eta_41 = minus_J_Teta_51 * tip->PX[22] - J_Teta_41 * tip->PX[21]
        - J_Teta_61 * tip->PX[23];
    const ella_real t102 = J_Teta_12 * tip->PX[18] + J_Teta_22 * tip->PX[19] + J_Teta_32 * tip->PX[20]
        + J_Teta_42 * tip->PX[21];
    const ella_real minus_next_eta_42 = t102 + J_Teta_52 * tip->PX[22] + J_Teta_53 * tip->PX[23];
    const ella_real t103 = -minus_next_eta_42;
    const ella_real t104 = minus_J_Teta_43 * tip->PX[21]
        - (J_Teta_13 * tip->PX[18] + J_Teta_23 * tip->PX[19] + J_Teta_33 * tip->PX[20]);
    const ella_real next_eta_43 = t104 - J_Teta_53 * tip->PX[22] - J_Teta_63 * tip->PX[23];
    const ella_real next_eta_51 = minus_J_Teta_51 * tip->PX[28] - J_Teta_41 * tip->PX[27]
        - J_Teta_61 * tip->PX[29];
    const ella_real t105 = J_Teta_12 * tip->PX[24] + J_Teta_22 * tip->PX[25] + J_Teta_32 * tip->PX[26]
        + J_Teta_42 * tip->PX[27];
    const ella_real minus_next_eta_52 = t105 + J_Teta_52 * tip->PX[28] + J_Teta_53 * tip->PX[29];
    const ella_real t106 = -minus_next_eta_52;
    const ella_real t107 = minus_J_Teta_43 * tip->PX[27]
        - (J_Teta_13 * tip->PX[24] + J_Teta_23 * tip->PX[25] + J_Teta_33 * tip->PX[26]);
    const ella_real next_eta_53 = t107 - J_Teta_53 * tip->PX[28] - J_Teta_63 * tip->PX[29];
    const ella_real next_eta_61 = minus_J_Teta_51 * tip->PX[34] - J_Teta_41 * tip->PX[33]
        - J_Teta_61 * tip->PX[35];
    const ella_real t108 = J_Teta_12 * tip->PX[30] + J_Teta_22 * tip->PX[31] + J_Teta_32 * tip->PX[32]
        + J_Teta_42 * tip->PX[33];
    const ella_real minus_next_eta_62 = t108 + J_Teta_52 * tip->PX[34] + J_Teta_53 * tip->PX[35];
    const ella_real t109 = -minus_next_eta_62;
    const ella_real t110 = minus_J_Teta_43 * tip->PX[33]
        - (J_Teta_13 * tip->PX[30] + J_Teta_23 * tip->PX[31] + J_Teta_33 * tip->PX[32]);
    const ella_real next_eta_63 = t110 - J_Teta_53 * tip->PX[34] - J_Teta_63 * tip->PX[35];

    /* h_carried: bias of the bodies at the tip, its acceleration bias included */
    const ella_real h_carried_4 = link->h_T[0] + c->body0_mass * link->b_T[3];
    const ella_real h_carried_5 = link->h_T[1] + c->body0_mass * link->b_T[4];
    const ella_real h_carried_6 = link->h_T[2] + c->body0_mass * link->b_T[5];

    /* V_H: bias of the twist rows (100) */
    const ella_real V_H_1 = link->h_V[0] - minus_J_TV_41 * h_carried_4 + J_TV_51 * h_carried_5
        + J_TV_61 * h_carried_6;
    const ella_real V_H_2 = link->h_V[1] + J_TV_42 * h_carried_4 - minus_J_TV_52 * h_carried_5
        + J_TV_62 * h_carried_6;
    const ella_real V_H_3 = link->h_V[2] + J_TV_43 * h_carried_4 + J_TV_53 * h_carried_5 + J_TV_63 * h_carried_6;
    const ella_real V_H_4 = link->h_V[3] + link->R_T[0] * h_carried_4 - link->R_T[1] * h_carried_5
        + link->R_T[2] * h_carried_6;
    const ella_real V_H_5 = link->h_V[4] + link->R_T[1] * h_carried_4 + link->R_T[3] * h_carried_5
        + link->R_T[4] * h_carried_6;
    const ella_real V_H_6 = link->h_V[5] - link->R_T[2] * h_carried_4 + link->R_T[4] * h_carried_5
        + link->R_T[5] * h_carried_6;

    /* eta_H: bias of the modal rows (100) */
    const ella_real eta_H_1 = t1 + J_Teta_41 * h_carried_4 - minus_J_Teta_51 * h_carried_5
        + J_Teta_61 * h_carried_6;
    const ella_real eta_H_2 = t2 + J_Teta_42 * h_carried_4 + J_Teta_52 * h_carried_5 + J_Teta_53 * h_carried_6;
    const ella_real eta_H_3 = t3 - minus_J_Teta_43 * h_carried_4 + J_Teta_53 * h_carried_5
        + J_Teta_63 * h_carried_6;

    /* V_W: external wrench in the twist rows (100) */
    const ella_real t111 = J_TV_51 * w_ext[4] - minus_J_TV_41 * w_ext[3] + J_TV_61 * w_ext[5]
        + link->R_T[0] * w_ext[0] - link->R_T[1] * w_ext[1];
    const ella_real V_W_1 = t111 + link->R_T[2] * w_ext[2];
    const ella_real t112 = J_TV_42 * w_ext[3] - minus_J_TV_52 * w_ext[4] + J_TV_62 * w_ext[5]
        + link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1];
    const ella_real V_W_2 = t112 + link->R_T[4] * w_ext[2];
    const ella_real t113 = J_TV_43 * w_ext[3] + J_TV_53 * w_ext[4] + J_TV_63 * w_ext[5] - link->R_T[2] * w_ext[0]
        + link->R_T[4] * w_ext[1];
    const ella_real V_W_3 = t113 + link->R_T[5] * w_ext[2];
    const ella_real V_W_4 = link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5];
    const ella_real V_W_5 = link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5];
    const ella_real V_W_6 = link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5];

    /* eta_W: external wrench in the modal rows (100) */
    const ella_real eta_W_1 = J_Teta_41 * w_ext[3] - minus_J_Teta_51 * w_ext[4] + J_Teta_61 * w_ext[5];
    const ella_real t114 = J_Teta_12 * w_ext[0] + J_Teta_22 * w_ext[1] + J_Teta_32 * w_ext[2]
        + J_Teta_42 * w_ext[3] + J_Teta_52 * w_ext[4];
    const ella_real eta_W_2 = t114 + J_Teta_53 * w_ext[5];
    const ella_real t115 = J_Teta_13 * w_ext[0] + J_Teta_23 * w_ext[1] + J_Teta_33 * w_ext[2]
        - minus_J_Teta_43 * w_ext[3] + J_Teta_53 * w_ext[4];
    const ella_real eta_W_3 = t115 + J_Teta_63 * w_ext[5];

    /* outputs */
    M[place[12]] = next_V_11;
    M[place[13]] = next_V_12;
    M[place[14]] = next_V_13;
    M[place[15]] = next_V_14;
    M[place[16]] = t72;
    M[place[17]] = next_V_16;
    M[place[18]] = next_V_21;
    M[place[19]] = next_V_22;
    M[place[20]] = next_V_23;
    M[place[21]] = next_V_24;
    M[place[22]] = t76;
    M[place[23]] = next_V_26;
    M[place[24]] = next_V_31;
    M[place[25]] = next_V_32;
    M[place[26]] = next_V_33;
    M[place[27]] = next_V_34;
    M[place[28]] = t80;
    M[place[29]] = next_V_36;
    M[place[30]] = next_V_41;
    M[place[31]] = next_V_42;
    M[place[32]] = next_V_43;
    M[place[33]] = next_V_44;
    M[place[34]] = t84;
    M[place[35]] = next_V_46;
    M[place[36]] = next_V_51;
    M[place[37]] = next_V_52;
    M[place[38]] = next_V_53;
    M[place[39]] = next_V_54;
    M[place[40]] = t88;
    M[place[41]] = next_V_56;
    M[place[42]] = next_V_61;
    M[place[43]] = next_V_62;
    M[place[44]] = next_V_63;
    M[place[45]] = next_V_64;
    M[place[46]] = t92;
    M[place[47]] = next_V_66;
    M[place[48]] = next_eta_11;
    M[place[49]] = t94;
    M[place[50]] = next_eta_13;
    M[place[51]] = next_eta_21;
    M[place[52]] = t97;
    M[place[53]] = next_eta_23;
    M[place[54]] = next_eta_31;
    M[place[55]] = t100;
    M[place[56]] = next_eta_33;
    M[place[57]] = next_eta_41;
    M[place[58]] = t103;
    M[place[59]] = next_eta_43;
    M[place[60]] = next_eta_51;
    M[place[61]] = t106;
    M[place[62]] = next_eta_53;
    M[place[63]] = next_eta_61;
    M[place[64]] = t109;
    M[place[65]] = next_eta_63;
    M[place[66]] = -1;
    M[place[67]] = -1;
    M[place[68]] = -1;
    M[place[69]] = -1;
    M[place[70]] = -1;
    M[place[71]] = -1;
    M[place[72]] = V_V_11;
    M[place[73]] = V_V_12;
    M[place[74]] = V_V_13;
    M[place[75]] = V_V_14;
    M[place[76]] = V_V_15;
    M[place[77]] = V_V_16;
    M[place[78]] = V_V_12;
    M[place[79]] = V_V_22;
    M[place[80]] = V_V_23;
    M[place[81]] = V_V_24;
    M[place[82]] = V_V_25;
    M[place[83]] = V_V_26;
    M[place[84]] = V_V_13;
    M[place[85]] = V_V_23;
    M[place[86]] = V_V_33;
    M[place[87]] = V_V_34;
    M[place[88]] = V_V_35;
    M[place[89]] = V_V_36;
    M[place[90]] = V_V_14;
    M[place[91]] = V_V_24;
    M[place[92]] = V_V_34;
    M[place[93]] = V_V_44;
    M[place[94]] = V_V_45;
    M[place[95]] = V_V_46;
    M[place[96]] = V_V_15;
    M[place[97]] = V_V_25;
    M[place[98]] = V_V_35;
    M[place[99]] = V_V_45;
    M[place[100]] = V_V_55;
    M[place[101]] = V_V_56;
    M[place[102]] = V_V_16;
    M[place[103]] = V_V_26;
    M[place[104]] = V_V_36;
    M[place[105]] = V_V_46;
    M[place[106]] = V_V_56;
    M[place[107]] = V_V_66;
    M[place[108]] = V_eta_11;
    M[place[109]] = V_eta_12;
    M[place[110]] = V_eta_13;
    M[place[111]] = V_eta_21;
    M[place[112]] = V_eta_22;
    M[place[113]] = V_eta_23;
    M[place[114]] = V_eta_31;
    M[place[115]] = V_eta_32;
    M[place[116]] = V_eta_33;
    M[place[117]] = V_eta_41;
    M[place[118]] = V_eta_42;
    M[place[119]] = V_eta_43;
    M[place[120]] = V_eta_51;
    M[place[121]] = V_eta_52;
    M[place[122]] = V_eta_53;
    M[place[123]] = V_eta_61;
    M[place[124]] = V_eta_62;
    M[place[125]] = V_eta_63;
    M[place[126]] = V_next_11;
    M[place[127]] = V_next_12;
    M[place[128]] = V_next_13;
    M[place[129]] = V_next_14;
    M[place[130]] = V_next_15;
    M[place[131]] = V_next_16;
    M[place[132]] = V_next_21;
    M[place[133]] = V_next_22;
    M[place[134]] = V_next_23;
    M[place[135]] = V_next_24;
    M[place[136]] = V_next_25;
    M[place[137]] = V_next_26;
    M[place[138]] = V_next_31;
    M[place[139]] = V_next_32;
    M[place[140]] = V_next_33;
    M[place[141]] = V_next_34;
    M[place[142]] = V_next_35;
    M[place[143]] = V_next_36;
    M[place[144]] = V_next_41;
    M[place[145]] = V_next_42;
    M[place[146]] = V_next_43;
    M[place[147]] = V_next_44;
    M[place[148]] = V_next_45;
    M[place[149]] = V_next_46;
    M[place[150]] = V_next_51;
    M[place[151]] = V_next_52;
    M[place[152]] = V_next_53;
    M[place[153]] = V_next_54;
    M[place[154]] = V_next_55;
    M[place[155]] = V_next_56;
    M[place[156]] = V_next_61;
    M[place[157]] = V_next_62;
    M[place[158]] = V_next_63;
    M[place[159]] = V_next_64;
    M[place[160]] = V_next_65;
    M[place[161]] = V_next_66;
    M[place[162]] = V_eta_11;
    M[place[163]] = V_eta_21;
    M[place[164]] = V_eta_31;
    M[place[165]] = V_eta_41;
    M[place[166]] = V_eta_51;
    M[place[167]] = V_eta_61;
    M[place[168]] = V_eta_12;
    M[place[169]] = V_eta_22;
    M[place[170]] = V_eta_32;
    M[place[171]] = V_eta_42;
    M[place[172]] = V_eta_52;
    M[place[173]] = V_eta_62;
    M[place[174]] = V_eta_13;
    M[place[175]] = V_eta_23;
    M[place[176]] = V_eta_33;
    M[place[177]] = V_eta_43;
    M[place[178]] = V_eta_53;
    M[place[179]] = V_eta_63;
    M[place[180]] = eta_eta_11;
    M[place[181]] = eta_eta_12;
    M[place[182]] = eta_eta_13;
    M[place[183]] = eta_eta_12;
    M[place[184]] = eta_eta_22;
    M[place[185]] = eta_eta_23;
    M[place[186]] = eta_eta_13;
    M[place[187]] = eta_eta_23;
    M[place[188]] = eta_eta_33;
    M[place[189]] = eta_next_11;
    M[place[190]] = eta_next_12;
    M[place[191]] = eta_next_13;
    M[place[192]] = eta_next_14;
    M[place[193]] = eta_next_15;
    M[place[194]] = eta_next_16;
    M[place[195]] = eta_next_21;
    M[place[196]] = eta_next_22;
    M[place[197]] = eta_next_23;
    M[place[198]] = eta_next_24;
    M[place[199]] = eta_next_25;
    M[place[200]] = eta_next_26;
    M[place[201]] = eta_next_31;
    M[place[202]] = eta_next_32;
    M[place[203]] = eta_next_33;
    M[place[204]] = eta_next_34;
    M[place[205]] = eta_next_35;
    M[place[206]] = eta_next_36;
    H[6] = V_H_1;
    H[7] = V_H_2;
    H[8] = V_H_3;
    H[9] = V_H_4;
    H[10] = V_H_5;
    H[11] = V_H_6;
    eta_H[0] = eta_H_1;
    eta_H[1] = eta_H_2;
    eta_H[2] = eta_H_3;
    W[6] = V_W_1;
    W[7] = V_W_2;
    W[8] = V_W_3;
    W[9] = V_W_4;
    W[10] = V_W_5;
    W[11] = V_W_6;
    eta_W[0] = eta_W_1;
    eta_W[1] = eta_W_2;
    eta_W[2] = eta_W_3;
    return ELLA_OK;
}

/* link rows, links like forearm: 476 operations */
static ella_status link_rows_forearm_last(const ella_link_constants *c, const ella_link_store *link, const ella_real m_eta[3],
    const ella_real f_eta[3], const ella_real w_ext[6], ella_real eta_H[3], ella_real eta_W[3],
    const int *place, ella_real *M, ella_real H[12], ella_real W[12])
{

    const ella_real t1 = link->h_eta[0] + f_eta[0];
    const ella_real t2 = link->h_eta[1] + f_eta[1];
    const ella_real t3 = link->h_eta[2] + f_eta[2];

    /* J_TV: twist of the tip section from that of F_i (46) */
    const ella_real t4 = link->R_T[2] * link->r_T[1];
    const ella_real t5 = link->R_T[1] * link->r_T[2];
    const ella_real minus_J_TV_41 = t4 + t5;
    const ella_real J_TV_42 = link->R_T[0] * link->r_T[2] + link->R_T[2] * link->r_T[0];
    const ella_real J_TV_43 = link->R_T[1] * link->r_T[0] - link->R_T[0] * link->r_T[1];
    const ella_real J_TV_51 = link->R_T[4] * link->r_T[1] - link->R_T[3] * link->r_T[2];
    const ella_real t6 = link->R_T[4] * link->r_T[0];
    const ella_real minus_J_TV_52 = t5 + t6;
    const ella_real J_TV_53 = link->R_T[3] * link->r_T[0] + link->R_T[1] * link->r_T[1];
    const ella_real J_TV_61 = link->R_T[5] * link->r_T[1] - link->R_T[4] * link->r_T[2];
    const ella_real J_TV_62 = link->R_T[2] * link->r_T[2] - link->R_T[5] * link->r_T[0];
    const ella_real J_TV_63 = t6 - t4;

    /* J_Teta: twist of the tip section from the modal rates (46) */
    const ella_real t7 = link->G[2] * c->Psi_c_z2;
    const ella_real t8 = link->G[4] * c->Psi_c_z2;
    const ella_real t9 = link->G[5] * c->Psi_c_z2;
    const ella_real J_Teta_12 = link->R_T[0] * t7 + link->R_T[1] * t8 - link->R_T[2] * t9;
    const ella_real t10 = link->G[1] * c->Psi_c_y3;
    const ella_real t11 = link->G[3] * c->Psi_c_y3;
    const ella_real t12 = link->G[4] * c->Psi_c_y3;
    const ella_real J_Teta_13 = link->R_T[1] * t11 - link->R_T[0] * t10 - link->R_T[2] * t12;
    const ella_real J_Teta_22 = link->R_T[3] * t8 - link->R_T[1] * t7 + link->R_T[4] * t9;
    const ella_real J_Teta_23 = link->R_T[1] * t10 + link->R_T[3] * t11 + link->R_T[4] * t12;
    const ella_real J_Teta_32 = link->R_T[2] * t7 + link->R_T[4] * t8 + link->R_T[5] * t9;
    const ella_real J_Teta_33 = link->R_T[4] * t11 - link->R_T[2] * t10 + link->R_T[5] * t12;
    const ella_real J_Teta_41 = link->R_T[0] * REAL(1.4142135623730951);
    const ella_real J_Teta_42 = link->R_T[1] * 2;
    const ella_real minus_J_Teta_43 = link->R_T[2] * 2;
    const ella_real minus_J_Teta_51 = link->R_T[1] * REAL(1.4142135623730951);
    const ella_real J_Teta_52 = link->R_T[3] * 2;
    const ella_real J_Teta_53 = link->R_T[4] * 2;
    const ella_real J_Teta_61 = link->R_T[2] * REAL(1.4142135623730951);
    const ella_real J_Teta_63 = link->R_T[5] * 2;

    /* V_V: twist rows, twist columns (100) */
    const ella_real t13 = minus_J_TV_41 * c->body0_mass;
    const ella_real t14 = J_TV_51 * c->body0_mass;
    const ella_real t15 = J_TV_61 * c->body0_mass;
    const ella_real V_V_11 = link->M_V[0] + minus_J_TV_41 * t13 + J_TV_51 * t14 + J_TV_61 * t15;
    const ella_real V_V_12 = J_TV_62 * t15 - (link->M_V[1] + J_TV_42 * t13 + minus_J_TV_52 * t14);
    const ella_real V_V_13 = J_TV_53 * t14 - (link->M_V[2] + J_TV_43 * t13) + J_TV_63 * t15;
    const ella_real V_V_14 = link->R_T[2] * t15 - (link->R_T[0] * t13 + link->R_T[1] * t14);
    const ella_real V_V_15 = link->R_T[3] * t14 - (link->M_V[3] + link->R_T[1] * t13) + link->R_T[4] * t15;
    const ella_real V_V_16 = link->M_V[4] + link->R_T[2] * t13 + link->R_T[4] * t14 + link->R_T[5] * t15;
    const ella_real t16 = J_TV_42 * c->body0_mass;
    const ella_real t17 = minus_J_TV_52 * c->body0_mass;
    const ella_real t18 = J_TV_62 * c->body0_mass;
    const ella_real V_V_22 = link->M_V[5] + J_TV_42 * t16 + minus_J_TV_52 * t17 + J_TV_62 * t18;
    const ella_real V_V_23 = J_TV_43 * t16 - link->M_V[6] - J_TV_53 * t17 + J_TV_63 * t18;
    const ella_real V_V_24 = link->M_V[3] + link->R_T[0] * t16 + link->R_T[1] * t17 + link->R_T[2] * t18;
    const ella_real V_V_25 = link->R_T[1] * t16 - link->R_T[3] * t17 + link->R_T[4] * t18;
    const ella_real V_V_26 = link->R_T[5] * t18 - (link->M_V[7] + link->R_T[2] * t16 + link->R_T[4] * t17);
    const ella_real t19 = J_TV_43 * c->body0_mass;
    const ella_real t20 = J_TV_53 * c->body0_mass;
    const ella_real t21 = J_TV_63 * c->body0_mass;
    const ella_real V_V_33 = link->M_V[8] + J_TV_43 * t19 + J_TV_53 * t20 + J_TV_63 * t21;
    const ella_real V_V_34 = link->R_T[0] * t19 - link->M_V[4] - link->R_T[1] * t20 + link->R_T[2] * t21;
    const ella_real V_V_35 = link->M_V[7] + link->R_T[1] * t19 + link->R_T[3] * t20 + link->R_T[4] * t21;
    const ella_real V_V_36 = link->R_T[4] * t20 - link->R_T[2] * t19 + link->R_T[5] * t21;
    const ella_real t22 = c->body0_mass * link->R_T[0];
    const ella_real t23 = c->body0_mass * link->R_T[1];
    const ella_real t24 = link->R_T[1] * t23;
    const ella_real t25 = c->body0_mass * link->R_T[2];
    const ella_real t26 = link->R_T[2] * t25;
    const ella_real V_V_44 = c->mu + link->R_T[0] * t22 + t24 + t26;
    const ella_real V_V_45 = link->R_T[1] * t22 - link->R_T[3] * t23 + link->R_T[4] * t25;
    const ella_real V_V_46 = link->R_T[5] * t25 - (link->R_T[2] * t22 + link->R_T[4] * t23);
    const ella_real t27 = c->body0_mass * link->R_T[3];
    const ella_real t28 = c->body0_mass * link->R_T[4];
    const ella_real t29 = link->R_T[4] * t28;
    const ella_real V_V_55 = c->mu + t24 + link->R_T[3] * t27 + t29;
    const ella_real V_V_56 = link->R_T[4] * t27 - link->R_T[2] * t23 + link->R_T[5] * t28;
    const ella_real t30 = c->body0_mass * link->R_T[5];
    const ella_real V_V_66 = c->mu + t26 + t29 + link->R_T[5] * t30;

    /* V_eta: twist rows, modal columns (100) */
    const ella_real V_eta_11 = J_Teta_61 * t15 - (J_Teta_41 * t13 + minus_J_Teta_51 * t14);
    const ella_real V_eta_12 = J_Teta_52 * t14 - (link->M_D[0] + J_Teta_42 * t13) + J_Teta_53 * t15;
    const ella_real V_eta_13 = link->M_D[1] + minus_J_Teta_43 * t13 + J_Teta_53 * t14 + J_Teta_63 * t15;
    const ella_real V_eta_21 = link->M_D[2] + J_Teta_41 * t16 + minus_J_Teta_51 * t17 + J_Teta_61 * t18;
    const ella_real V_eta_22 = J_Teta_42 * t16 - J_Teta_52 * t17 + J_Teta_53 * t18;
    const ella_real V_eta_23 = J_Teta_63 * t18 - (link->M_D[3] + minus_J_Teta_43 * t16 + J_Teta_53 * t17);
    const ella_real V_eta_31 = J_Teta_41 * t19 - link->M_D[4] - minus_J_Teta_51 * t20 + J_Teta_61 * t21;
    const ella_real V_eta_32 = link->M_D[5] + J_Teta_42 * t19 + J_Teta_52 * t20 + J_Teta_53 * t21;
    const ella_real V_eta_33 = J_Teta_53 * t20 - minus_J_Teta_43 * t19 + J_Teta_63 * t21;
    const ella_real V_eta_41 = c->sigma_x1 + J_Teta_41 * t22 + minus_J_Teta_51 * t23 + J_Teta_61 * t25;
    const ella_real V_eta_42 = J_Teta_42 * t22 - J_Teta_52 * t23 + J_Teta_53 * t25;
    const ella_real V_eta_43 = J_Teta_63 * t25 - (minus_J_Teta_43 * t22 + J_Teta_53 * t23);
    const ella_real V_eta_51 = J_Teta_41 * t23 - minus_J_Teta_51 * t27 + J_Teta_61 * t28;
    const ella_real t31 = J_Teta_53 * t28;
    const ella_real V_eta_52 = c->sigma_y2 + J_Teta_42 * t23 + J_Teta_52 * t27 + t31;
    const ella_real V_eta_53 = J_Teta_53 * t27 - minus_J_Teta_43 * t23 + J_Teta_63 * t28;
    const ella_real V_eta_61 = J_Teta_61 * t30 - (J_Teta_41 * t25 + minus_J_Teta_51 * t28);
    const ella_real V_eta_62 = J_Teta_52 * t28 - J_Teta_42 * t25 + J_Teta_53 * t30;
    const ella_real V_eta_63 = c->sigma_z3 + minus_J_Teta_43 * t25 + t31 + J_Teta_63 * t30;

    /* eta_eta: modal rows, modal columns (100) */
    const ella_real t32 = J_Teta_41 * c->body0_mass;
    const ella_real t33 = minus_J_Teta_51 * c->body0_mass;
    const ella_real t34 = J_Teta_61 * c->body0_mass;
    const ella_real eta_eta_11 = m_eta[0] + J_Teta_41 * t32 + minus_J_Teta_51 * t33 + J_Teta_61 * t34;
    const ella_real eta_eta_12 = J_Teta_42 * t32 - J_Teta_52 * t33 + J_Teta_53 * t34;
    const ella_real eta_eta_13 = J_Teta_63 * t34 - (minus_J_Teta_43 * t32 + J_Teta_53 * t33);
    const ella_real t35 = J_Teta_42 * c->body0_mass;
    const ella_real t36 = J_Teta_52 * c->body0_mass;
    const ella_real t37 = J_Teta_53 * c->body0_mass;
    const ella_real t38 = J_Teta_53 * t37;
    const ella_real eta_eta_22 = m_eta[1] + J_Teta_42 * t35 + J_Teta_52 * t36 + t38;
    const ella_real eta_eta_23 = J_Teta_53 * t36 - minus_J_Teta_43 * t35 + J_Teta_63 * t37;
    const ella_real eta_eta_33 = m_eta[2] + minus_J_Teta_43 * (minus_J_Teta_43 * c->body0_mass) + t38
        + J_Teta_63 * (J_Teta_63 * c->body0_mass);

    /* h_carried: bias of the bodies at the tip, its acceleration bias included */
    const ella_real h_carried_4 = link->h_T[0] + c->body0_mass * link->b_T[3];
    const ella_real h_carried_5 = link->h_T[1] + c->body0_mass * link->b_T[4];
    const ella_real h_carried_6 = link->h_T[2] + c->body0_mass * link->b_T[5];

    /* V_H: bias of the twist rows (100) */
    const ella_real V_H_1 = link->h_V[0] - minus_J_TV_41 * h_carried_4 + J_TV_51 * h_carried_5
        + J_TV_61 * h_carried_6;
    const ella_real V_H_2 = link->h_V[1] + J_TV_42 * h_carried_4 - minus_J_TV_52 * h_carried_5
        + J_TV_62 * h_carried_6;
    const ella_real V_H_3 = link->h_V[2] + J_TV_43 * h_carried_4 + J_TV_53 * h_carried_5 + J_TV_63 * h_carried_6;
    const ella_real V_H_4 = link->h_V[3] + link->R_T[0] * h_carried_4 - link->R_T[1] * h_carried_5
        + link->R_T[2] * h_carried_6;
    const ella_real V_H_5 = link->h_V[4] + link->R_T[1] * h_carried_4 + link->R_T[3] * h_carried_5
        + link->R_T[4] * h_carried_6;
    const ella_real V_H_6 = link->h_V[5] - link->R_T[2] * h_carried_4 + link->R_T[4] * h_carried_5
        + link->R_T[5] * h_carried_6;

    /* eta_H: bias of the modal rows (100) */
    const ella_real eta_H_1 = t1 + J_Teta_41 * h_carried_4 - minus_J_Teta_51 * h_carried_5
        + J_Teta_61 * h_carried_6;
    const ella_real eta_H_2 = t2 + J_Teta_42 * h_carried_4 + J_Teta_52 * h_carried_5 + J_Teta_53 * h_carried_6;
    const ella_real eta_H_3 = t3 - minus_J_Teta_43 * h_carried_4 + J_Teta_53 * h_carried_5
        + J_Teta_63 * h_carried_6;

    /* V_W: external wrench in the twist rows (100) */
    const ella_real t39 = J_TV_51 * w_ext[4] - minus_J_TV_41 * w_ext[3] + J_TV_61 * w_ext[5]
        + link->R_T[0] * w_ext[0] - link->R_T[1] * w_ext[1];
    const ella_real V_W_1 = t39 + link->R_T[2] * w_ext[2];
    const ella_real t40 = J_TV_42 * w_ext[3] - minus_J_TV_52 * w_ext[4] + J_TV_62 * w_ext[5]
        + link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1];
    const ella_real V_W_2 = t40 + link->R_T[4] * w_ext[2];
    const ella_real t41 = J_TV_43 * w_ext[3] + J_TV_53 * w_ext[4] + J_TV_63 * w_ext[5] - link->R_T[2] * w_ext[0]
        + link->R_T[4] * w_ext[1];
    const ella_real V_W_3 = t41 + link->R_T[5] * w_ext[2];
    const ella_real V_W_4 = link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5];
    const ella_real V_W_5 = link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5];
    const ella_real V_W_6 = link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5];

    /* eta_W: external wrench in the modal rows (100) */
    const ella_real eta_W_1 = J_Teta_41 * w_ext[3] - minus_J_Teta_51 * w_ext[4] + J_Teta_61 * w_ext[5];
    const ella_real t42 = J_Teta_12 * w_ext[0] + J_Teta_22 * w_ext[1] + J_Teta_32 * w_ext[2]
        + J_Teta_42 * w_ext[3] + J_Teta_52 * w_ext[4];
    const ella_real eta_W_2 = t42 + J_Teta_53 * w_ext[5];
    const ella_real t43 = J_Teta_13 * w_ext[0] + J_Teta_23 * w_ext[1] + J_Teta_33 * w_ext[2]
        - minus_J_Teta_43 * w_ext[3] + J_Teta_53 * w_ext[4];
    const ella_real eta_W_3 = t43 + J_Teta_63 * w_ext[5];

    /* outputs */
    M[place[6]] = -1;
    M[place[7]] = -1;
    M[place[8]] = -1;
    M[place[9]] = -1;
    M[place[10]] = -1;
    M[place[11]] = -1;
    M[place[12]] = V_V_11;
    M[place[13]] = V_V_12;
    M[place[14]] = V_V_13;
    M[place[15]] = V_V_14;
    M[place[16]] = V_V_15;
    M[place[17]] = V_V_16;
    M[place[18]] = V_V_12;
    M[place[19]] = V_V_22;
    M[place[20]] = V_V_23;
    M[place[21]] = V_V_24;
    M[place[22]] = V_V_25;
    M[place[23]] = V_V_26;
    M[place[24]] = V_V_13;
    M[place[25]] = V_V_23;
    M[place[26]] = V_V_33;
    M[place[27]] = V_V_34;
    M[place[28]] = V_V_35;
    M[place[29]] = V_V_36;
    M[place[30]] = V_V_14;
    M[place[31]] = V_V_24;
    M[place[32]] = V_V_34;
    M[place[33]] = V_V_44;
    M[place[34]] = V_V_45;
    M[place[35]] = V_V_46;
    M[place[36]] = V_V_15;
    M[place[37]] = V_V_25;
    M[place[38]] = V_V_35;
    M[place[39]] = V_V_45;
    M[place[40]] = V_V_55;
    M[place[41]] = V_V_56;
    M[place[42]] = V_V_16;
    M[place[43]] = V_V_26;
    M[place[44]] = V_V_36;
    M[place[45]] = V_V_46;
    M[place[46]] = V_V_56;
    M[place[47]] = V_V_66;
    M[place[48]] = V_eta_11;
    M[place[49]] = V_eta_12;
    M[place[50]] = V_eta_13;
    M[place[51]] = V_eta_21;
    M[place[52]] = V_eta_22;
    M[place[53]] = V_eta_23;
    M[place[54]] = V_eta_31;
    M[place[55]] = V_eta_32;
    M[place[56]] = V_eta_33;
    M[place[57]] = V_eta_41;
    M[place[58]] = V_eta_42;
    M[place[59]] = V_eta_43;
    M[place[60]] = V_eta_51;
    M[place[61]] = V_eta_52;
    M[place[62]] = V_eta_53;
    M[place[63]] = V_eta_61;
    M[place[64]] = V_eta_62;
    M[place[65]] = V_eta_63;
    M[place[66]] = V_eta_11;
    M[place[67]] = V_eta_21;
    M[place[68]] = V_eta_31;
    M[place[69]] = V_eta_41;
    M[place[70]] = V_eta_51;
    M[place[71]] = V_eta_61;
    M[place[72]] = V_eta_12;
    M[place[73]] = V_eta_22;
    M[place[74]] = V_eta_32;
    M[place[75]] = V_eta_42;
    M[place[76]] = V_eta_52;
    M[place[77]] = V_eta_62;
    M[place[78]] = V_eta_13;
    M[place[79]] = V_eta_23;
    M[place[80]] = V_eta_33;
    M[place[81]] = V_eta_43;
    M[place[82]] = V_eta_53;
    M[place[83]] = V_eta_63;
    M[place[84]] = eta_eta_11;
    M[place[85]] = eta_eta_12;
    M[place[86]] = eta_eta_13;
    M[place[87]] = eta_eta_12;
    M[place[88]] = eta_eta_22;
    M[place[89]] = eta_eta_23;
    M[place[90]] = eta_eta_13;
    M[place[91]] = eta_eta_23;
    M[place[92]] = eta_eta_33;
    H[6] = V_H_1;
    H[7] = V_H_2;
    H[8] = V_H_3;
    H[9] = V_H_4;
    H[10] = V_H_5;
    H[11] = V_H_6;
    eta_H[0] = eta_H_1;
    eta_H[1] = eta_H_2;
    eta_H[2] = eta_H_3;
    W[6] = V_W_1;
    W[7] = V_W_2;
    W[8] = V_W_3;
    W[9] = V_W_4;
    W[10] = V_W_5;
    W[11] = V_W_6;
    eta_W[0] = eta_W_1;
    eta_W[1] = eta_W_2;
    eta_W[2] = eta_W_3;
    return ELLA_OK;
}

static ella_status dae_dynamics_dae_kinematics(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return dae_kinematics_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->eta + e, call->etadot + e, call->new_qdot + q);
    default:
        return dae_kinematics_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->eta + e, call->etadot + e, call->new_qdot + q);
    }
}

static ella_status dae_dynamics_eliminate(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return eliminate_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->tau + q);
    default:
        return eliminate_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->tau + q);
    }
}

static ella_status dae_dynamics_accelerate(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return accelerate_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->qddot + q, call->wrench + 6 * i, call->alpha + 6 * i, call->etaddot + e);
    default:
        return accelerate_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->qddot + q, call->wrench + 6 * i, call->alpha + 6 * i, call->etaddot + e);
    }
}

static ella_status dae_dynamics_twist_rates(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return twist_rates_upper_arm(call->quaternion + 4 * i, call->gravity, call->given_alpha + 6 * i, call->Vdot + 6 * i);
    default:
        return twist_rates_upper_arm(call->quaternion + 4 * i, call->gravity, call->given_alpha + 6 * i, call->Vdot + 6 * i);
    }
}

static ella_status projection_project(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return project_upper_arm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    default:
        return project_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    }
}

static ella_status placement_forward_kinematics(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return forward_kinematics_upper_arm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->eta + e, call->etadot + e, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    default:
        return forward_kinematics_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->eta + e, call->etadot + e, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    }
}

static ella_status assembly_joint_rows(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return joint_rows_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->eta + e, call->etadot + e, call->tau + q, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    default:
        return joint_rows_forearm_last(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->eta + e, call->etadot + e, call->tau + q, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    }
}

static ella_status assembly_link_rows(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return link_rows_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->m_eta + e, call->f_eta + e, call->w_ext + 6 * i, call->H + 24 + e, call->W + 24 + e, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    default:
        return link_rows_forearm_last(&c->links[i], &chain->links[i], call->m_eta + e, call->f_eta + e, call->w_ext + 6 * i, call->H + 24 + e, call->W + 24 + e, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    }
}

/* What is known beforehand: a base at rest that falls up, a tip that carries nothing. */
static void start(const ella_call *call, ella_chain *chain)
{
    ella_node *base = &chain->nodes[0], *tip = &chain->nodes[ELLA_NLINKS];
    int k;
    for (k = 0; k < 3; ++k) {
        base->omega[k] = 0;
        base->v[k] = 0;
        base->omega_m[k] = 0;
        base->r[k] = 0;
        base->R[3 * k] = 0;
        base->R[3 * k + 1] = 0;
        base->R[3 * k + 2] = 0;
        base->R[4 * k] = 1;
        base->R_m[3 * k] = 0;
        base->R_m[3 * k + 1] = 0;
        base->R_m[3 * k + 2] = 0;
        base->R_m[4 * k] = 1;
        base->alpha[k] = 0;
        base->alpha[k + 3] = -call->gravity[k];
        base->b[k] = 0;
        base->b[k + 3] = 0;
        base->Q[k + 1] = 0;
    }
    base->Q[0] = 1;
    for (k = 0; k < 6; ++k) {
        tip->p[k] = 0;
    }
    for (k = 0; k < 21; ++k) {
        tip->Lambda[k] = 0;
    }
}

ella_status ella_dae_dynamics(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    start(call, chain);
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = dae_dynamics_dae_kinematics(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = ELLA_NLINKS - 1; i >= 0; --i) {
        status = dae_dynamics_eliminate(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = dae_dynamics_accelerate(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = dae_dynamics_twist_rates(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    return ELLA_OK;
}

ella_status ella_projection(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    start(call, chain);
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = projection_project(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    return ELLA_OK;
}

ella_status ella_placement(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    start(call, chain);
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = placement_forward_kinematics(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    return ELLA_OK;
}

ella_status ella_assembly(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    start(call, chain);
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = assembly_joint_rows(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = ELLA_NLINKS - 1; i >= 0; --i) {
        status = assembly_link_rows(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    return ELLA_OK;
}
