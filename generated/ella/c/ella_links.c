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
    0, 3, 1, 4, 6, 11, 27, 12, 28, 57, 70, 83, 19, 35, 49, 20, 36, 50, 21, 37,
    51, 64, 77, 90, 22, 38, 52, 65, 78, 91, 23, 39, 53, 66, 79, 92, 222, 236, 223, 237,
    210, 224, 238, 211, 225, 239, 212, 226, 240, 2, 5, 7, 8, 9, 10, 13, 29, 43, 58, 71,
    84, 14, 30, 44, 59, 72, 85, 15, 31, 45, 60, 73, 86, 16, 32, 46, 61, 74, 87, 17,
    33, 47, 62, 75, 88, 18, 34, 48, 63, 76, 89, 204, 216, 230, 205, 217, 231, 206, 218, 232,
    207, 219, 233, 208, 220, 234, 209, 221, 235, 96, 102, 108, 115, 125, 135, 97, 103, 109, 116, 126,
    136, 98, 104, 110, 117, 127, 137, 118, 128, 138, 119, 129, 139, 120, 130, 140, 24, 40, 54, 67,
    80, 93, 25, 41, 55, 68, 81, 94, 26, 42, 56, 69, 82, 95, 213, 227, 241, 214, 228, 242,
    215, 229, 243, 122, 132, 142, 100, 106, 113, 123, 133, 143, 101, 107, 114, 124, 134, 144, 111, 145,
    155, 174, 184, 194, 99, 105, 112, 121, 131, 141, 146, 156, 165, 175, 185, 195, 147, 157, 166, 176,
    186, 196, 148, 158, 167, 177, 187, 197, 149, 159, 168, 178, 188, 198, 150, 160, 169, 179, 189, 199,
    151, 161, 170, 180, 190, 200, 244, 253, 262, 245, 254, 263, 246, 255, 264, 247, 256, 265, 248, 257,
    266, 249, 258, 267, 152, 162, 171, 181, 191, 201, 153, 163, 172, 182, 192, 202, 154, 164, 173, 183,
    193, 203, 250, 259, 268, 251, 260, 269, 252, 261, 270,
};
static const int M_OFFSET[ELLA_NLINKS] = { 0, 178 };

/* dae kinematics, links like upper_arm: 161 operations */
ELLA_PART ella_status dae_kinematics_upper_arm(const ella_link_constants *restrict c, ella_link_store *restrict link, const ella_node *restrict base,
    ella_node *restrict tip, const ella_real q[restrict 2], const ella_real twist[restrict 6],
    const ella_real eta[restrict 3], const ella_real etadot[restrict 3], ella_real qdot[restrict 2])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_xz = turn.sine, R_rel_zz = turn.cosine;
    const ella_sincos turn_2 = ella_sine_cosine(q[1]);
    const ella_real R_rel_yx = turn_2.sine, R_rel_yy = turn_2.cosine;
    link->A[0] = R_rel_yx;
    link->A[1] = R_rel_yy;
    const ella_real R_rel_xx = R_rel_zz * R_rel_yy;
    const ella_real minus_R_rel_xy = R_rel_yx * R_rel_zz;
    const ella_real minus_R_rel_zx = R_rel_xz * R_rel_yy;
    const ella_real R_rel_zy = R_rel_xz * R_rel_yx;

    const ella_real t1 = R_rel_yx * R_rel_yx + R_rel_yy * R_rel_yy;
    if (!(t1 - ELLA_REAL_EPSILON * 64 > 0)) { return ELLA_SINGULAR; }
    const ella_real t2 = 1 / t1;
    const ella_real qdot_1 = R_rel_yx * t2 * twist[0] + R_rel_yy * t2 * twist[1];
    qdot[0] = qdot_1;

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx * qdot_1;
    link->omega[0] = omega_J_x;
    const ella_real omega_J_y = R_rel_yy * qdot_1;
    link->omega[1] = omega_J_y;

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real t3 = qdot_1 * twist[2];
    const ella_real beta_omega_x = t3 * R_rel_yy;
    link->alpha_0[0] = beta_omega_x;
    const ella_real minus_beta_omega_y = t3 * R_rel_yx;
    link->alpha_0[1] = -minus_beta_omega_y;

    /* alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const ella_real alpha_0_4 = R_rel_xx * base->alpha_0[3] + R_rel_yx * base->alpha_0[4]
        - minus_R_rel_zx * base->alpha_0[5];
    link->alpha_0[3] = alpha_0_4;
    const ella_real alpha_0_5 = R_rel_yy * base->alpha_0[4] - minus_R_rel_xy * base->alpha_0[3]
        + R_rel_zy * base->alpha_0[5];
    link->alpha_0[4] = alpha_0_5;
    const ella_real alpha_0_6 = R_rel_xz * base->alpha_0[3] + R_rel_zz * base->alpha_0[5];
    link->alpha_0[5] = alpha_0_6;

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    link->r_T[0] = r_T_x;
    const ella_real r_T_y = eta[1] * 2;
    link->r_T[1] = r_T_y;
    const ella_real r_T_z = eta[2] * 2;
    link->r_T[2] = r_T_z;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_y = c->Psi_c_y3 * eta[2];
    const ella_real theta_z = c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const ella_real minus_theta_hat2_33 = theta_y * theta_y;
    const ella_real minus_theta_hat2_22 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const ella_real t4 = ella_c5(x);
    const ella_real c3 = REAL(0.16666666666666666) - x * t4;
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real t5 = ella_c4(x);
    const ella_real c2 = REAL(0.5) - x * t5;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real minus_J_l_xy = c2 * theta_z;
    link->J_l[1] = minus_J_l_xy;
    const ella_real J_l_xz = c2 * theta_y;
    link->J_l[2] = J_l_xz;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    link->J_l[3] = J_l_yy;
    const ella_real J_l_yz = c3 * theta_hat2_23;
    link->J_l[4] = J_l_yz;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;
    link->J_l[5] = J_l_zz;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    link->R_T[0] = R_T_xx;
    tip->R_T[0] = R_T_xx;
    const ella_real minus_R_T_xy = c1 * theta_z;
    link->R_T[1] = minus_R_T_xy;
    tip->R_T[1] = -minus_R_T_xy;
    tip->R_T[3] = minus_R_T_xy;
    const ella_real R_T_xz = c1 * theta_y;
    link->R_T[2] = R_T_xz;
    tip->R_T[2] = R_T_xz;
    tip->R_T[6] = -R_T_xz;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    link->R_T[3] = R_T_yy;
    tip->R_T[4] = R_T_yy;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    link->R_T[4] = R_T_yz;
    tip->R_T[5] = R_T_yz;
    tip->R_T[7] = R_T_yz;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;
    link->R_T[5] = R_T_zz;
    tip->R_T[8] = R_T_zz;

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_y = c->Psi_c_y3 * etadot[2];
    const ella_real thetadot_z = c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t6 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t6;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t6;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t6;

    /* xdot: rate of the squared angle */
    const ella_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const ella_real c2dot = xdot * (t5 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const ella_real c3dot = xdot * (t4 * REAL(1.5) - t5 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_x = c2dot * t6;
    const ella_real alpha_s_y = c3 * thetadot_z * t6 + c3dot * theta_z * t6;
    const ella_real minus_alpha_s_z = c3 * thetadot_y * t6 + c3dot * theta_y * t6;

    /* tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const ella_real omega_T_1 = omega_J_x + omega_s_x;
    tip->omega[0] = omega_T_1;
    const ella_real omega_T_2 = omega_J_y + omega_s_y;
    tip->omega[1] = omega_T_2;
    const ella_real omega_T_3 = twist[2] + omega_s_z;
    tip->omega[2] = omega_T_3;
    const ella_real alpha_0_T_1 = beta_omega_x + alpha_s_x + (omega_J_y * omega_s_z - twist[2] * omega_s_y);
    tip->alpha_0[0] = alpha_0_T_1;
    const ella_real alpha_0_T_2 = alpha_s_y - minus_beta_omega_y + (twist[2] * omega_s_x - omega_J_x * omega_s_z);
    tip->alpha_0[1] = alpha_0_T_2;
    const ella_real alpha_0_T_3 = omega_J_x * omega_s_y - omega_J_y * omega_s_x - minus_alpha_s_z;
    tip->alpha_0[2] = alpha_0_T_3;
    const ella_real t7 = omega_J_y * r_T_z - twist[2] * r_T_y + etadot[0] * REAL(2.8284271247461903);
    const ella_real t8 = twist[2] * r_T_x - omega_J_x * r_T_z + etadot[1] * 4;
    const ella_real t9 = omega_J_x * r_T_y - omega_J_y * r_T_x + etadot[2] * 4;
    const ella_real alpha_0_T_4 = alpha_0_4 - minus_beta_omega_y * r_T_z + (omega_J_y * t9 - twist[2] * t8);
    tip->alpha_0[3] = alpha_0_T_4;
    const ella_real alpha_0_T_5 = alpha_0_5 - beta_omega_x * r_T_z + (twist[2] * t7 - omega_J_x * t9);
    tip->alpha_0[4] = alpha_0_T_5;
    const ella_real alpha_0_T_6 = alpha_0_6 + (beta_omega_x * r_T_y + minus_beta_omega_y * r_T_x)
        + (omega_J_x * t8 - omega_J_y * t7);
    tip->alpha_0[5] = alpha_0_T_6;

    /* outputs */
    qdot[1] = twist[2];
    link->omega[2] = twist[2];
    return ELLA_OK;
}

/* dae kinematics, links like forearm: 143 operations */
ELLA_PART ella_status dae_kinematics_forearm(const ella_link_constants *restrict c, ella_link_store *restrict link, const ella_node *restrict base,
    ella_node *restrict tip, const ella_real q[restrict 1], const ella_real twist[restrict 6],
    const ella_real eta[restrict 3], const ella_real etadot[restrict 3], ella_real qdot[restrict 1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real minus_R_rel_xy = turn.sine, R_rel_xx = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const ella_real R_P_11 = base->R_T[0] * R_rel_xx + base->R_T[1] * minus_R_rel_xy;
    link->R_P[0] = R_P_11;
    const ella_real R_P_12 = base->R_T[1] * R_rel_xx - base->R_T[0] * minus_R_rel_xy;
    link->R_P[1] = R_P_12;
    const ella_real R_P_21 = base->R_T[3] * R_rel_xx + base->R_T[4] * minus_R_rel_xy;
    link->R_P[3] = R_P_21;
    const ella_real R_P_22 = base->R_T[4] * R_rel_xx - base->R_T[3] * minus_R_rel_xy;
    link->R_P[4] = R_P_22;
    const ella_real R_P_31 = base->R_T[6] * R_rel_xx + base->R_T[7] * minus_R_rel_xy;
    link->R_P[6] = R_P_31;
    const ella_real R_P_32 = base->R_T[7] * R_rel_xx - base->R_T[6] * minus_R_rel_xy;
    link->R_P[7] = R_P_32;
    const ella_real omega_R_1 = R_P_11 * base->omega[0] + R_P_21 * base->omega[1] + R_P_31 * base->omega[2];
    link->omega[0] = omega_R_1;
    const ella_real omega_R_2 = R_P_12 * base->omega[0] + R_P_22 * base->omega[1] + R_P_32 * base->omega[2];
    link->omega[1] = omega_R_2;
    const ella_real omega_R_3 = base->R_T[2] * base->omega[0] + base->R_T[5] * base->omega[1]
        + base->R_T[8] * base->omega[2];

    const ella_real qdot_1 = twist[2] - omega_R_3;
    qdot[0] = qdot_1;

    /* alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const ella_real alpha_0_3 = base->R_T[2] * base->alpha_0[0] + base->R_T[5] * base->alpha_0[1]
        + base->R_T[8] * base->alpha_0[2];
    link->alpha_0[2] = alpha_0_3;
    const ella_real alpha_0_1 = R_P_11 * base->alpha_0[0] + R_P_21 * base->alpha_0[1] + R_P_31 * base->alpha_0[2]
        + omega_R_2 * qdot_1;
    link->alpha_0[0] = alpha_0_1;
    const ella_real alpha_0_2 = R_P_12 * base->alpha_0[0] + R_P_22 * base->alpha_0[1] + R_P_32 * base->alpha_0[2]
        - omega_R_1 * qdot_1;
    link->alpha_0[1] = alpha_0_2;
    const ella_real alpha_0_4 = R_P_11 * base->alpha_0[3] + R_P_21 * base->alpha_0[4] + R_P_31 * base->alpha_0[5];
    link->alpha_0[3] = alpha_0_4;
    const ella_real alpha_0_5 = R_P_12 * base->alpha_0[3] + R_P_22 * base->alpha_0[4] + R_P_32 * base->alpha_0[5];
    link->alpha_0[4] = alpha_0_5;
    const ella_real alpha_0_6 = base->R_T[2] * base->alpha_0[3] + base->R_T[5] * base->alpha_0[4]
        + base->R_T[8] * base->alpha_0[5];
    link->alpha_0[5] = alpha_0_6;

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    link->r_T[0] = r_T_x;
    const ella_real r_T_y = eta[1] * 2;
    link->r_T[1] = r_T_y;
    const ella_real r_T_z = eta[2] * 2;
    link->r_T[2] = r_T_z;

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

    /* J_l: left Jacobian of the exponential */
    const ella_real minus_J_l_xy = c2 * theta_z;
    link->J_l[1] = minus_J_l_xy;
    const ella_real J_l_xz = c2 * theta_y;
    link->J_l[2] = J_l_xz;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    link->J_l[3] = J_l_yy;
    const ella_real J_l_yz = c3 * theta_hat2_23;
    link->J_l[4] = J_l_yz;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;
    link->J_l[5] = J_l_zz;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    link->R_T[0] = R_T_xx;
    const ella_real minus_R_T_xy = c1 * theta_z;
    link->R_T[1] = minus_R_T_xy;
    const ella_real R_T_xz = c1 * theta_y;
    link->R_T[2] = R_T_xz;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    link->R_T[3] = R_T_yy;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    link->R_T[4] = R_T_yz;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;
    link->R_T[5] = R_T_zz;

    /* tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const ella_real t1 = omega_R_2 * r_T_z - twist[2] * r_T_y + etadot[0] * REAL(2.8284271247461903);
    const ella_real t2 = twist[2] * r_T_x - omega_R_1 * r_T_z + etadot[1] * 4;
    const ella_real t3 = omega_R_1 * r_T_y - omega_R_2 * r_T_x + etadot[2] * 4;
    const ella_real alpha_0_T_4 = alpha_0_4 + (alpha_0_2 * r_T_z - alpha_0_3 * r_T_y)
        + (omega_R_2 * t3 - twist[2] * t2);
    tip->alpha_0[3] = alpha_0_T_4;
    const ella_real alpha_0_T_5 = alpha_0_5 + (alpha_0_3 * r_T_x - alpha_0_1 * r_T_z)
        + (twist[2] * t1 - omega_R_1 * t3);
    tip->alpha_0[4] = alpha_0_T_5;
    const ella_real alpha_0_T_6 = alpha_0_6 + (alpha_0_1 * r_T_y - alpha_0_2 * r_T_x)
        + (omega_R_1 * t2 - omega_R_2 * t1);
    tip->alpha_0[5] = alpha_0_T_6;

    /* outputs */
    link->R_P[2] = base->R_T[2];
    link->R_P[5] = base->R_T[5];
    link->R_P[8] = base->R_T[8];
    link->omega[2] = twist[2];
    return ELLA_OK;
}

/* eliminate, links like upper_arm: 830 operations */
ELLA_PART ella_status eliminate_upper_arm(const ella_link_constants *restrict c, ella_link_store *restrict link, const ella_node *restrict tip,
    const ella_real eta[restrict 3], const ella_real etadot[restrict 3], const ella_real w_ext[restrict 6],
    const ella_real m_eta[restrict 3], const ella_real f_eta[restrict 3], const ella_real tau[restrict 2])
{
    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_x = etadot[0] * c->sigma_x1;
    const ella_real Sdot_y = etadot[1] * c->sigma_y2;
    const ella_real Sdot_z = etadot[2] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->mu * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_z1 = c->Gamma_xy_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_x2 = c->Gamma_xy_11 * etadot[0];
    const ella_real Ldot_y1 = c->Gamma_xy_11 * etadot[1];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_z1 = c->Gamma_xy_11 * etadot[2];
    const ella_real Ldot_z2 = etadot[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_2 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z2 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const ella_real t1 = link->omega[1] * link->omega[1];
    const ella_real t2 = link->omega[2] * link->omega[2];
    const ella_real minus_Omega_xx = t1 + t2;
    const ella_real Omega_xy = link->omega[0] * link->omega[1];
    const ella_real t3 = link->omega[0] * link->omega[2];
    const ella_real Omega_xz = link->alpha_0[1] + t3;
    const ella_real t4 = link->omega[0] * link->omega[0];
    const ella_real minus_Omega_yy = t4 + t2;
    const ella_real t5 = link->omega[1] * link->omega[2];
    const ella_real Omega_yz = t5 - link->alpha_0[0];
    const ella_real Omega_zx = t3 - link->alpha_0[1];
    const ella_real Omega_zy = link->alpha_0[0] + t5;
    const ella_real minus_Omega_zz = t4 + t1;

    /* B: moment of the elastic velocity */
    const ella_real B_xx = L_x1 * etadot[0];
    const ella_real B_xy = L_y1 * etadot[0];
    const ella_real B_xz = L_z1 * etadot[0];
    const ella_real B_yx = L_x2 * etadot[1];
    const ella_real B_yy = L_y2 * etadot[1];
    const ella_real B_yz = L_z2 * etadot[1];
    const ella_real B_zx = L_x2 * etadot[2];
    const ella_real B_zy = L_y2 * etadot[2];
    const ella_real B_zz = L_z2 * etadot[2];

    /* h_c: half of the Coriolis wrench */
    const ella_real h_c_1 = B_yy * link->omega[0] + B_zz * link->omega[0] - B_xy * link->omega[1]
        - B_xz * link->omega[2];
    const ella_real h_c_2 = B_xx * link->omega[1] + B_zz * link->omega[1] - B_yx * link->omega[0]
        - B_yz * link->omega[2];
    const ella_real h_c_3 = B_xx * link->omega[2] + B_yy * link->omega[2] - B_zx * link->omega[0]
        - B_zy * link->omega[1];
    const ella_real h_c_4 = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
    const ella_real h_c_5 = Sdot_x * link->omega[2] - Sdot_z * link->omega[0];
    const ella_real h_c_6 = Sdot_y * link->omega[0] - Sdot_x * link->omega[1];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t6 = h_c_1 + c->I_s * link->alpha_0[0] + J_xy * Omega_zx + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const ella_real H_star_1 = t6 + S_y * link->alpha_0[5] - J_xz * Omega_xy - J_zz * Omega_yz
        - S_z * link->alpha_0[4];
    const ella_real t7 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->alpha_0[3];
    const ella_real t8 = c->I_s * link->omega[0];
    const ella_real H_star_2 = t7 + t8 * link->omega[2] - J_xx * Omega_zx - J_xy * Omega_zy
        - S_x * link->alpha_0[5];
    const ella_real t9 = h_c_3 + J_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + S_x * link->alpha_0[4];
    const ella_real H_star_3 = t9 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->alpha_0[3]
        - t8 * link->omega[1];
    const ella_real H_star_4 = h_c_4 - minus_Omega_xx * S_x + Omega_xy * S_y + Omega_xz * S_z
        + link->alpha_0[3] * c->mu;
    const ella_real H_star_5 = h_c_5 + Omega_xy * S_x - minus_Omega_yy * S_y + Omega_yz * S_z
        + link->alpha_0[4] * c->mu;
    const ella_real H_star_6 = h_c_6 + Omega_zx * S_x + Omega_zy * S_y - minus_Omega_zz * S_z
        + link->alpha_0[5] * c->mu;

    /* h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_1 = H_star_1 + h_c_1;
    const ella_real h_V_2 = H_star_2 + h_c_2;
    const ella_real h_V_3 = H_star_3 + h_c_3;
    const ella_real h_V_4 = H_star_4 + h_c_4;
    const ella_real h_V_5 = H_star_5 + h_c_5;
    const ella_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real t10 = L_y1 * Omega_xy - L_x1 * minus_Omega_xx + L_z1 * Omega_xz
        + link->alpha_0[3] * c->sigma_x1 + Ldot_z1 * 2 * link->omega[1];
    const ella_real h_eta_1 = t10 - Ldot_y1 * 2 * link->omega[2];
    const ella_real t11 = Ldot_x2 * 2;
    const ella_real t12 = L_x2 * Omega_xy - L_y2 * minus_Omega_yy + L_z2 * Omega_yz
        + link->alpha_0[4] * c->sigma_y2 + t11 * link->omega[2];
    const ella_real h_eta_2 = t12 - Ldot_z2 * 2 * link->omega[0];
    const ella_real t13 = L_x2 * Omega_zx + L_y2 * Omega_zy - L_z2 * minus_Omega_zz
        + link->alpha_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];
    const ella_real h_eta_3 = t13 - t11 * link->omega[1];

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real Lambda_T_44 = tip->Lambda[15] + c->body0_mass;
    const ella_real Lambda_T_55 = tip->Lambda[18] + c->body0_mass;
    const ella_real Lambda_T_66 = tip->Lambda[20] + c->body0_mass;
    const ella_real p_T_1 = tip->p[0]
        - (link->R_T[0] * w_ext[0] - link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2]);
    const ella_real p_T_2 = tip->p[1]
        - (link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1] + link->R_T[4] * w_ext[2]);
    const ella_real p_T_3 = tip->p[2]
        - (link->R_T[4] * w_ext[1] - link->R_T[2] * w_ext[0] + link->R_T[5] * w_ext[2]);
    const ella_real p_T_4 = tip->p[3] + c->body0_mass * tip->alpha_0[3]
        - (link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const ella_real p_T_5 = tip->p[4] + c->body0_mass * tip->alpha_0[4]
        - (link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5]);
    const ella_real p_T_6 = tip->p[5] + c->body0_mass * tip->alpha_0[5]
        - (link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5]);

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real Theta_12 = link->J_l[2] * c->Psi_c_z2;
    const ella_real minus_Theta_13 = link->J_l[1] * c->Psi_c_y3;
    const ella_real Theta_22 = link->J_l[4] * c->Psi_c_z2;
    const ella_real Theta_23 = link->J_l[3] * c->Psi_c_y3;
    const ella_real Theta_32 = link->J_l[5] * c->Psi_c_z2;
    const ella_real Theta_33 = link->J_l[4] * c->Psi_c_y3;
    const ella_real t14 = link->r_T[2] * tip->Lambda[16];
    const ella_real t15 = link->r_T[1] * tip->Lambda[17];
    const ella_real t16 = link->r_T[0] * tip->Lambda[19];
    const ella_real M_loaded_14 = tip->Lambda[3] + (t15 - t14);
    const ella_real t17 = tip->Lambda[4] + (link->r_T[1] * tip->Lambda[19] - link->r_T[2] * Lambda_T_55);
    const ella_real t18 = tip->Lambda[5] + (link->r_T[1] * Lambda_T_66 - link->r_T[2] * tip->Lambda[19]);
    const ella_real t19 = tip->Lambda[8] + (link->r_T[2] * Lambda_T_44 - link->r_T[0] * tip->Lambda[17]);
    const ella_real M_loaded_25 = tip->Lambda[9] + (t14 - t16);
    const ella_real t20 = tip->Lambda[10] + (link->r_T[2] * tip->Lambda[17] - link->r_T[0] * Lambda_T_66);
    const ella_real t21 = tip->Lambda[12] + (link->r_T[0] * tip->Lambda[16] - link->r_T[1] * Lambda_T_44);
    const ella_real t22 = tip->Lambda[13] + (link->r_T[0] * Lambda_T_55 - link->r_T[1] * tip->Lambda[16]);
    const ella_real M_loaded_36 = tip->Lambda[14] + (t16 - t15);
    const ella_real t23 = tip->Lambda[0] - (tip->Lambda[4] * link->r_T[2] - tip->Lambda[5] * link->r_T[1])
        + (link->r_T[1] * t18 - link->r_T[2] * t17);
    const ella_real t24 = tip->Lambda[1] - (tip->Lambda[5] * link->r_T[0] - tip->Lambda[3] * link->r_T[2])
        + (link->r_T[1] * t20 - link->r_T[2] * M_loaded_25);
    const ella_real t25 = tip->Lambda[2] - (tip->Lambda[3] * link->r_T[1] - tip->Lambda[4] * link->r_T[0])
        + (link->r_T[1] * M_loaded_36 - link->r_T[2] * t22);
    const ella_real t26 = tip->Lambda[6] - (tip->Lambda[10] * link->r_T[0] - tip->Lambda[8] * link->r_T[2])
        + (link->r_T[2] * t19 - link->r_T[0] * t20);
    const ella_real t27 = tip->Lambda[7] - (tip->Lambda[8] * link->r_T[1] - tip->Lambda[9] * link->r_T[0])
        + (link->r_T[2] * t21 - link->r_T[0] * M_loaded_36);
    const ella_real t28 = tip->Lambda[11] - (tip->Lambda[12] * link->r_T[1] - tip->Lambda[13] * link->r_T[0])
        + (link->r_T[0] * t22 - link->r_T[1] * t21);
    const ella_real M_loaded_11 = I_xx + t23;
    const ella_real M_loaded_12 = t24 - J_xy;
    const ella_real M_loaded_13 = t25 - J_xz;
    const ella_real M_loaded_15 = t17 - S_z;
    const ella_real M_loaded_16 = S_y + t18;
    const ella_real M_loaded_22 = I_yy + t26;
    const ella_real M_loaded_23 = t27 - J_yz;
    const ella_real M_loaded_24 = S_z + t19;
    const ella_real M_loaded_26 = t20 - S_x;
    const ella_real M_loaded_33 = I_zz + t28;
    const ella_real M_loaded_34 = t21 - S_y;
    const ella_real M_loaded_35 = S_x + t22;
    const ella_real h_loaded_1 = h_V_1 + (p_T_1 + (link->r_T[1] * p_T_6 - link->r_T[2] * p_T_5));
    const ella_real h_loaded_2 = h_V_2 + (p_T_2 + (link->r_T[2] * p_T_4 - link->r_T[0] * p_T_6));
    const ella_real h_loaded_3 = h_V_3 + (p_T_3 + (link->r_T[0] * p_T_5 - link->r_T[1] * p_T_4));
    const ella_real h_loaded_4 = h_V_4 + p_T_4;
    const ella_real h_loaded_5 = h_V_5 + p_T_5;
    const ella_real h_loaded_6 = h_V_6 + p_T_6;
    const ella_real t29 = tip->Lambda[0] * Theta_12 + tip->Lambda[1] * Theta_22 + tip->Lambda[2] * Theta_32
        + tip->Lambda[4] * 2;
    const ella_real t30 = tip->Lambda[1] * Theta_23 - tip->Lambda[0] * minus_Theta_13 + tip->Lambda[2] * Theta_33
        + tip->Lambda[5] * 2;
    const ella_real t31 = tip->Lambda[1] * Theta_12 + tip->Lambda[6] * Theta_22 + tip->Lambda[7] * Theta_32
        + tip->Lambda[9] * 2;
    const ella_real t32 = tip->Lambda[6] * Theta_23 - tip->Lambda[1] * minus_Theta_13 + tip->Lambda[7] * Theta_33
        + tip->Lambda[10] * 2;
    const ella_real t33 = tip->Lambda[2] * Theta_12 + tip->Lambda[7] * Theta_22 + tip->Lambda[11] * Theta_32
        + tip->Lambda[13] * 2;
    const ella_real t34 = tip->Lambda[7] * Theta_23 - tip->Lambda[2] * minus_Theta_13
        + tip->Lambda[11] * Theta_33 + tip->Lambda[14] * 2;
    const ella_real t35 = Lambda_T_44 * REAL(1.4142135623730951);
    const ella_real C_42 = tip->Lambda[3] * Theta_12 + tip->Lambda[8] * Theta_22 + tip->Lambda[12] * Theta_32
        + tip->Lambda[16] * 2;
    const ella_real C_43 = tip->Lambda[8] * Theta_23 - tip->Lambda[3] * minus_Theta_13
        + tip->Lambda[12] * Theta_33 + tip->Lambda[17] * 2;
    const ella_real C_51 = tip->Lambda[16] * REAL(1.4142135623730951);
    const ella_real t36 = tip->Lambda[4] * Theta_12 + tip->Lambda[9] * Theta_22 + tip->Lambda[13] * Theta_32
        + Lambda_T_55 * 2;
    const ella_real t37 = tip->Lambda[19] * 2;
    const ella_real C_53 = tip->Lambda[9] * Theta_23 - tip->Lambda[4] * minus_Theta_13
        + tip->Lambda[13] * Theta_33 + t37;
    const ella_real C_61 = tip->Lambda[17] * REAL(1.4142135623730951);
    const ella_real C_62 = tip->Lambda[5] * Theta_12 + tip->Lambda[10] * Theta_22 + tip->Lambda[14] * Theta_32
        + t37;
    const ella_real t38 = tip->Lambda[10] * Theta_23 - tip->Lambda[5] * minus_Theta_13
        + tip->Lambda[14] * Theta_33 + Lambda_T_66 * 2;
    const ella_real C_11 = tip->Lambda[3] * REAL(1.4142135623730951)
        + (link->r_T[1] * C_61 - link->r_T[2] * C_51);
    const ella_real C_22 = t31 + (link->r_T[2] * C_42 - link->r_T[0] * C_62);
    const ella_real C_33 = t34 + (link->r_T[0] * C_53 - link->r_T[1] * C_43);
    const ella_real C_12 = t29 + (link->r_T[1] * C_62 - link->r_T[2] * t36) - L_z2;
    const ella_real C_13 = L_y2 + (t30 + (link->r_T[1] * t38 - link->r_T[2] * C_53));
    const ella_real C_21 = L_z1
        + (tip->Lambda[8] * REAL(1.4142135623730951) + (link->r_T[2] * t35 - link->r_T[0] * C_61));
    const ella_real C_23 = t32 + (link->r_T[2] * C_43 - link->r_T[0] * t38) - L_x2;
    const ella_real C_31 = tip->Lambda[12] * REAL(1.4142135623730951)
        + (link->r_T[0] * C_51 - link->r_T[1] * t35) - L_y1;
    const ella_real C_32 = L_x2 + (t33 + (link->r_T[0] * t36 - link->r_T[1] * C_42));
    const ella_real C_41 = c->sigma_x1 + t35;
    const ella_real C_52 = c->sigma_y2 + t36;
    const ella_real C_63 = c->sigma_y2 + t38;
    const ella_real modal_inertia_11 = Lambda_T_44 * REAL(2.0000000000000004) + m_eta[0];
    if (!(modal_inertia_11 > 0)) { return ELLA_SINGULAR; }
    const ella_real modal_inertia_12 = C_42 * REAL(1.4142135623730951);
    const ella_real modal_inertia_13 = C_43 * REAL(1.4142135623730951);
    const ella_real modal_inertia_22 = Theta_12 * t29 + Theta_22 * t31 + Theta_32 * t33 + t36 * 2 + m_eta[1];
    const ella_real modal_inertia_23 = Theta_12 * t30 + Theta_22 * t32 + Theta_32 * t34 + C_53 * 2;
    const ella_real modal_inertia_33 = Theta_23 * t32 - minus_Theta_13 * t30 + Theta_33 * t34 + t38 * 2
        + m_eta[2];
    const ella_real h_phi_1 = h_eta_1 + f_eta[0] + p_T_4 * REAL(1.4142135623730951);
    const ella_real h_phi_2 = h_eta_2 + f_eta[1]
        + (Theta_12 * p_T_1 + Theta_22 * p_T_2 + Theta_32 * p_T_3 + p_T_5 * 2);
    const ella_real h_phi_3 = h_eta_3 + f_eta[2]
        + (Theta_23 * p_T_2 - minus_Theta_13 * p_T_1 + Theta_33 * p_T_3 + p_T_6 * 2);
    const ella_real modes_inverse_1 = 1 / modal_inertia_11;
    const ella_real modes_L_21 = modal_inertia_12 * modes_inverse_1;
    link->modes_L[0] = modes_L_21;
    const ella_real modes_L_31 = modal_inertia_13 * modes_inverse_1;
    link->modes_L[1] = modes_L_31;
    const ella_real t39 = modal_inertia_22 - modal_inertia_12 * modes_L_21;
    if (!(t39 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_2 = 1 / t39;
    const ella_real t40 = modal_inertia_23 - modal_inertia_12 * modes_L_31;
    const ella_real modes_L_32 = t40 * modes_inverse_2;
    link->modes_L[2] = modes_L_32;
    const ella_real t41 = modal_inertia_33 - (modal_inertia_13 * modes_L_31 + t40 * modes_L_32);
    if (!(t41 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_3 = 1 / t41;
    const ella_real t42 = C_12 - modes_L_21 * C_11;
    const ella_real t43 = C_22 - modes_L_21 * C_21;
    const ella_real t44 = C_32 - modes_L_21 * C_31;
    const ella_real t45 = C_42 - modes_L_21 * C_41;
    const ella_real t46 = C_52 - modes_L_21 * C_51;
    const ella_real t47 = C_62 - modes_L_21 * C_61;
    const ella_real t48 = C_13 - modes_L_31 * C_11 - modes_L_32 * t42;
    const ella_real t49 = C_23 - modes_L_31 * C_21 - modes_L_32 * t43;
    const ella_real t50 = C_33 - modes_L_31 * C_31 - modes_L_32 * t44;
    const ella_real t51 = h_phi_2 - modes_L_21 * h_phi_1;
    const ella_real t52 = h_phi_3 - modes_L_31 * h_phi_1 - modes_L_32 * t51;
    const ella_real modes_W_11 = C_11 * modes_inverse_1;
    link->modes_W[0] = modes_W_11;
    const ella_real modes_W_12 = C_21 * modes_inverse_1;
    link->modes_W[1] = modes_W_12;
    const ella_real modes_W_13 = C_31 * modes_inverse_1;
    link->modes_W[2] = modes_W_13;
    const ella_real modes_W_14 = C_41 * modes_inverse_1;
    const ella_real modes_W_15 = C_51 * modes_inverse_1;
    const ella_real modes_W_16 = C_61 * modes_inverse_1;
    const ella_real modes_W_21 = t42 * modes_inverse_2;
    link->modes_W[6] = modes_W_21;
    const ella_real modes_W_22 = t43 * modes_inverse_2;
    link->modes_W[7] = modes_W_22;
    const ella_real modes_W_23 = t44 * modes_inverse_2;
    link->modes_W[8] = modes_W_23;
    const ella_real modes_W_24 = t45 * modes_inverse_2;
    const ella_real modes_W_25 = t46 * modes_inverse_2;
    const ella_real modes_W_26 = t47 * modes_inverse_2;
    const ella_real modes_W_31 = t48 * modes_inverse_3;
    link->modes_W[12] = modes_W_31;
    const ella_real modes_W_32 = t49 * modes_inverse_3;
    link->modes_W[13] = modes_W_32;
    const ella_real modes_W_33 = t50 * modes_inverse_3;
    link->modes_W[14] = modes_W_33;
    const ella_real modes_W_34 = (C_43 - modes_L_31 * C_41 - modes_L_32 * t45) * modes_inverse_3;
    const ella_real modes_W_35 = (C_53 - modes_L_31 * C_51 - modes_L_32 * t46) * modes_inverse_3;
    const ella_real modes_W_36 = (C_63 - modes_L_31 * C_61 - modes_L_32 * t47) * modes_inverse_3;
    const ella_real modes_w_1 = h_phi_1 * modes_inverse_1;
    link->modes_w[0] = modes_w_1;
    const ella_real modes_w_2 = t51 * modes_inverse_2;
    link->modes_w[1] = modes_w_2;
    const ella_real modes_w_3 = t52 * modes_inverse_3;
    link->modes_w[2] = modes_w_3;
    const ella_real M_i_11 = M_loaded_11 - (C_11 * modes_W_11 + t42 * modes_W_21 + t48 * modes_W_31);
    const ella_real M_i_12 = M_loaded_12 - (C_11 * modes_W_12 + t42 * modes_W_22 + t48 * modes_W_32);
    const ella_real M_i_13 = M_loaded_13 - (C_11 * modes_W_13 + t42 * modes_W_23 + t48 * modes_W_33);
    const ella_real M_i_14 = M_loaded_14 - (C_11 * modes_W_14 + t42 * modes_W_24 + t48 * modes_W_34);
    const ella_real M_i_15 = M_loaded_15 - (C_11 * modes_W_15 + t42 * modes_W_25 + t48 * modes_W_35);
    const ella_real M_i_16 = M_loaded_16 - (C_11 * modes_W_16 + t42 * modes_W_26 + t48 * modes_W_36);
    const ella_real M_i_22 = M_loaded_22 - (C_21 * modes_W_12 + t43 * modes_W_22 + t49 * modes_W_32);
    const ella_real M_i_23 = M_loaded_23 - (C_21 * modes_W_13 + t43 * modes_W_23 + t49 * modes_W_33);
    const ella_real M_i_24 = M_loaded_24 - (C_21 * modes_W_14 + t43 * modes_W_24 + t49 * modes_W_34);
    const ella_real M_i_25 = M_loaded_25 - (C_21 * modes_W_15 + t43 * modes_W_25 + t49 * modes_W_35);
    const ella_real M_i_26 = M_loaded_26 - (C_21 * modes_W_16 + t43 * modes_W_26 + t49 * modes_W_36);
    const ella_real M_i_33 = M_loaded_33 - (C_31 * modes_W_13 + t44 * modes_W_23 + t50 * modes_W_33);
    const ella_real M_i_34 = M_loaded_34 - (C_31 * modes_W_14 + t44 * modes_W_24 + t50 * modes_W_34);
    const ella_real M_i_35 = M_loaded_35 - (C_31 * modes_W_15 + t44 * modes_W_25 + t50 * modes_W_35);
    const ella_real M_i_36 = M_loaded_36 - (C_31 * modes_W_16 + t44 * modes_W_26 + t50 * modes_W_36);
    const ella_real h_i_1 = h_loaded_1 - (modes_W_11 * h_phi_1 + modes_W_21 * t51 + modes_W_31 * t52);
    const ella_real h_i_2 = h_loaded_2 - (modes_W_12 * h_phi_1 + modes_W_22 * t51 + modes_W_32 * t52);
    const ella_real h_i_3 = h_loaded_3 - (modes_W_13 * h_phi_1 + modes_W_23 * t51 + modes_W_33 * t52);
    const ella_real h_i_4 = h_loaded_4 - (modes_W_14 * h_phi_1 + modes_W_24 * t51 + modes_W_34 * t52);
    const ella_real h_i_5 = h_loaded_5 - (modes_W_15 * h_phi_1 + modes_W_25 * t51 + modes_W_35 * t52);
    const ella_real h_i_6 = h_loaded_6 - (modes_W_16 * h_phi_1 + modes_W_26 * t51 + modes_W_36 * t52);

    /* joint: its accelerations eliminated from its rows (43) */
    const ella_real U_11 = M_i_11 * link->A[0] + M_i_12 * link->A[1];
    const ella_real U_21 = M_i_12 * link->A[0] + M_i_22 * link->A[1];
    const ella_real U_31 = M_i_13 * link->A[0] + M_i_23 * link->A[1];
    const ella_real U_41 = M_i_14 * link->A[0] + M_i_24 * link->A[1];
    const ella_real U_51 = M_i_15 * link->A[0] + M_i_25 * link->A[1];
    const ella_real U_61 = M_i_16 * link->A[0] + M_i_26 * link->A[1];
    const ella_real joint_inertia_11 = link->A[0] * U_11 + link->A[1] * U_21;
    const ella_real t53 = ELLA_REAL_EPSILON * 8 * (M_i_11 + M_i_22 + M_i_33);
    if (!(joint_inertia_11 - t53 > 0)) { return ELLA_SINGULAR; }
    const ella_real joint_inverse_1 = 1 / joint_inertia_11;
    const ella_real joint_L_21 = U_31 * joint_inverse_1;
    link->joint_L[0] = joint_L_21;
    const ella_real t54 = M_i_33 - U_31 * joint_L_21;
    if (!(t54 - t53 > 0)) { return ELLA_SINGULAR; }
    const ella_real joint_inverse_2 = 1 / t54;
    const ella_real t55 = tau[0] - (link->A[0] * h_i_1 + link->A[1] * h_i_2);
    const ella_real t56 = tau[1] - h_i_3 - joint_L_21 * t55;
    const ella_real joint_w_1 = t55 * joint_inverse_1;
    link->joint_w[0] = joint_w_1;
    const ella_real joint_w_2 = t56 * joint_inverse_2;
    link->joint_w[1] = joint_w_2;
    const ella_real p_i_1 = h_i_1 + (U_11 * joint_w_1 + (M_i_13 - joint_L_21 * U_11) * joint_w_2);
    link->p_i[0] = p_i_1;
    const ella_real p_i_2 = h_i_2 + (U_21 * joint_w_1 + (M_i_23 - joint_L_21 * U_21) * joint_w_2);
    link->p_i[1] = p_i_2;
    const ella_real p_i_3 = h_i_3 + (U_31 * joint_w_1 + t56);
    link->p_i[2] = p_i_3;
    const ella_real p_i_4 = h_i_4 + (U_41 * joint_w_1 + (M_i_34 - joint_L_21 * U_41) * joint_w_2);
    link->p_i[3] = p_i_4;
    const ella_real p_i_5 = h_i_5 + (U_51 * joint_w_1 + (M_i_35 - joint_L_21 * U_51) * joint_w_2);
    link->p_i[4] = p_i_5;
    const ella_real p_i_6 = h_i_6 + (U_61 * joint_w_1 + (M_i_36 - joint_L_21 * U_61) * joint_w_2);
    link->p_i[5] = p_i_6;
    return ELLA_OK;
}

/* eliminate, links like forearm: 620 operations */
ELLA_PART ella_status eliminate_forearm(const ella_link_constants *restrict c, ella_link_store *restrict link, ella_node *restrict base,
    const ella_node *restrict tip, const ella_real eta[restrict 3], const ella_real etadot[restrict 3],
    const ella_real w_ext[restrict 6], const ella_real m_eta[restrict 3],
    const ella_real f_eta[restrict 3], const ella_real tau[restrict 1])
{
    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_x = etadot[0] * c->sigma_x1;
    const ella_real Sdot_y = etadot[1] * c->sigma_y2;
    const ella_real Sdot_z = etadot[2] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->mu * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_z1 = c->Gamma_xy_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_x2 = c->Gamma_xy_11 * etadot[0];
    const ella_real Ldot_y1 = c->Gamma_xy_11 * etadot[1];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_z1 = c->Gamma_xy_11 * etadot[2];
    const ella_real Ldot_z2 = etadot[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_2 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z2 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const ella_real t1 = link->omega[1] * link->omega[1];
    const ella_real t2 = link->omega[2] * link->omega[2];
    const ella_real minus_Omega_xx = t1 + t2;
    const ella_real t3 = link->omega[0] * link->omega[1];
    const ella_real Omega_xy = t3 - link->alpha_0[2];
    const ella_real t4 = link->omega[0] * link->omega[2];
    const ella_real Omega_xz = link->alpha_0[1] + t4;
    const ella_real Omega_yx = link->alpha_0[2] + t3;
    const ella_real t5 = link->omega[0] * link->omega[0];
    const ella_real minus_Omega_yy = t5 + t2;
    const ella_real t6 = link->omega[1] * link->omega[2];
    const ella_real Omega_yz = t6 - link->alpha_0[0];
    const ella_real Omega_zx = t4 - link->alpha_0[1];
    const ella_real Omega_zy = link->alpha_0[0] + t6;
    const ella_real minus_Omega_zz = t5 + t1;

    /* B: moment of the elastic velocity */
    const ella_real B_xx = L_x1 * etadot[0];
    const ella_real B_xy = L_y1 * etadot[0];
    const ella_real B_xz = L_z1 * etadot[0];
    const ella_real B_yx = L_x2 * etadot[1];
    const ella_real B_yy = L_y2 * etadot[1];
    const ella_real B_yz = L_z2 * etadot[1];
    const ella_real B_zx = L_x2 * etadot[2];
    const ella_real B_zy = L_y2 * etadot[2];
    const ella_real B_zz = L_z2 * etadot[2];

    /* h_c: half of the Coriolis wrench */
    const ella_real h_c_1 = B_yy * link->omega[0] + B_zz * link->omega[0] - B_xy * link->omega[1]
        - B_xz * link->omega[2];
    const ella_real h_c_2 = B_xx * link->omega[1] + B_zz * link->omega[1] - B_yx * link->omega[0]
        - B_yz * link->omega[2];
    const ella_real h_c_3 = B_xx * link->omega[2] + B_yy * link->omega[2] - B_zx * link->omega[0]
        - B_zy * link->omega[1];
    const ella_real h_c_4 = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
    const ella_real h_c_5 = Sdot_x * link->omega[2] - Sdot_z * link->omega[0];
    const ella_real h_c_6 = Sdot_y * link->omega[0] - Sdot_x * link->omega[1];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t7 = h_c_1 + c->I_s * link->alpha_0[0] + J_xy * Omega_zx + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const ella_real H_star_1 = t7 + S_y * link->alpha_0[5] - J_xz * Omega_yx - J_zz * Omega_yz
        - S_z * link->alpha_0[4];
    const ella_real t8 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->alpha_0[3];
    const ella_real t9 = c->I_s * link->omega[0];
    const ella_real H_star_2 = t8 + t9 * link->omega[2] - J_xx * Omega_zx - J_xy * Omega_zy
        - S_x * link->alpha_0[5];
    const ella_real t10 = h_c_3 + J_xx * Omega_yx + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + S_x * link->alpha_0[4];
    const ella_real H_star_3 = t10 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->alpha_0[3]
        - t9 * link->omega[1];
    const ella_real H_star_4 = h_c_4 - minus_Omega_xx * S_x + Omega_xy * S_y + Omega_xz * S_z
        + link->alpha_0[3] * c->mu;
    const ella_real H_star_5 = h_c_5 + Omega_yx * S_x - minus_Omega_yy * S_y + Omega_yz * S_z
        + link->alpha_0[4] * c->mu;
    const ella_real H_star_6 = h_c_6 + Omega_zx * S_x + Omega_zy * S_y - minus_Omega_zz * S_z
        + link->alpha_0[5] * c->mu;

    /* h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_1 = H_star_1 + h_c_1;
    const ella_real h_V_2 = H_star_2 + h_c_2;
    const ella_real h_V_3 = H_star_3 + h_c_3;
    const ella_real h_V_4 = H_star_4 + h_c_4;
    const ella_real h_V_5 = H_star_5 + h_c_5;
    const ella_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real t11 = L_y1 * Omega_xy - L_x1 * minus_Omega_xx + L_z1 * Omega_xz
        + link->alpha_0[3] * c->sigma_x1 + Ldot_z1 * 2 * link->omega[1];
    const ella_real h_eta_1 = t11 - Ldot_y1 * 2 * link->omega[2];
    const ella_real t12 = Ldot_x2 * 2;
    const ella_real t13 = L_x2 * Omega_yx - L_y2 * minus_Omega_yy + L_z2 * Omega_yz
        + link->alpha_0[4] * c->sigma_y2 + t12 * link->omega[2];
    const ella_real h_eta_2 = t13 - Ldot_z2 * 2 * link->omega[0];
    const ella_real t14 = L_x2 * Omega_zx + L_y2 * Omega_zy - L_z2 * minus_Omega_zz
        + link->alpha_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];
    const ella_real h_eta_3 = t14 - t12 * link->omega[1];

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real minus_p_T_1 = link->R_T[0] * w_ext[0] - link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2];
    const ella_real minus_p_T_2 = link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1] + link->R_T[4] * w_ext[2];
    const ella_real minus_p_T_3 = link->R_T[4] * w_ext[1] - link->R_T[2] * w_ext[0] + link->R_T[5] * w_ext[2];
    const ella_real p_T_4 = c->body0_mass * tip->alpha_0[3]
        - (link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const ella_real p_T_5 = c->body0_mass * tip->alpha_0[4]
        - (link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5]);
    const ella_real p_T_6 = c->body0_mass * tip->alpha_0[5]
        - (link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5]);

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real Theta_12 = link->J_l[2] * c->Psi_c_z2;
    const ella_real minus_Theta_13 = link->J_l[1] * c->Psi_c_y3;
    const ella_real Theta_22 = link->J_l[4] * c->Psi_c_z2;
    const ella_real Theta_23 = link->J_l[3] * c->Psi_c_y3;
    const ella_real Theta_32 = link->J_l[5] * c->Psi_c_z2;
    const ella_real Theta_33 = link->J_l[4] * c->Psi_c_y3;
    const ella_real t15 = link->r_T[2] * c->body0_mass;
    const ella_real t16 = link->r_T[1] * c->body0_mass;
    const ella_real t17 = link->r_T[0] * c->body0_mass;
    const ella_real t18 = link->r_T[2] * t15;
    const ella_real t19 = link->r_T[1] * t16;
    const ella_real t20 = link->r_T[0] * t17;
    const ella_real M_loaded_11 = I_xx + (t19 + t18);
    const ella_real minus_M_loaded_12 = link->r_T[1] * t17 + J_xy;
    const ella_real minus_M_loaded_13 = link->r_T[2] * t17 + J_xz;
    const ella_real minus_M_loaded_15 = t15 + S_z;
    const ella_real M_loaded_16 = S_y + t16;
    const ella_real M_loaded_22 = I_yy + (t18 + t20);
    const ella_real minus_M_loaded_23 = link->r_T[2] * t16 + J_yz;
    const ella_real minus_M_loaded_26 = t17 + S_x;
    const ella_real M_loaded_33 = I_zz + (t20 + t19);
    const ella_real M_loaded_44 = c->mu + c->body0_mass;
    const ella_real h_loaded_1 = h_V_1 + (link->r_T[1] * p_T_6 - link->r_T[2] * p_T_5 - minus_p_T_1);
    const ella_real h_loaded_2 = h_V_2 + (link->r_T[2] * p_T_4 - link->r_T[0] * p_T_6 - minus_p_T_2);
    const ella_real h_loaded_3 = h_V_3 + (link->r_T[0] * p_T_5 - link->r_T[1] * p_T_4 - minus_p_T_3);
    const ella_real h_loaded_4 = h_V_4 + p_T_4;
    const ella_real h_loaded_5 = h_V_5 + p_T_5;
    const ella_real h_loaded_6 = h_V_6 + p_T_6;
    const ella_real t21 = c->body0_mass * REAL(1.4142135623730951);
    const ella_real t22 = c->body0_mass * 2;
    const ella_real minus_C_12 = link->r_T[2] * t22 + L_z2;
    const ella_real C_13 = L_y2 + link->r_T[1] * t22;
    const ella_real C_21 = L_z1 + link->r_T[2] * t21;
    const ella_real minus_C_23 = link->r_T[0] * t22 + L_x2;
    const ella_real minus_C_31 = link->r_T[1] * t21 + L_y1;
    const ella_real C_41 = c->sigma_x1 + t21;
    const ella_real C_52 = c->sigma_y2 + t22;
    const ella_real modal_inertia_11 = c->body0_mass * REAL(2.0000000000000004) + m_eta[0];
    if (!(modal_inertia_11 > 0)) { return ELLA_SINGULAR; }
    const ella_real t23 = c->body0_mass * 4;
    const ella_real modal_inertia_22 = t23 + m_eta[1];
    if (!(modal_inertia_22 > 0)) { return ELLA_SINGULAR; }
    const ella_real modal_inertia_33 = t23 + m_eta[2];
    if (!(modal_inertia_33 > 0)) { return ELLA_SINGULAR; }
    const ella_real h_phi_1 = h_eta_1 + f_eta[0] + p_T_4 * REAL(1.4142135623730951);
    const ella_real h_phi_2 = h_eta_2 + f_eta[1]
        + (p_T_5 * 2 - (Theta_12 * minus_p_T_1 + Theta_22 * minus_p_T_2 + Theta_32 * minus_p_T_3));
    const ella_real h_phi_3 = h_eta_3 + f_eta[2]
        + (minus_Theta_13 * minus_p_T_1 - Theta_23 * minus_p_T_2 - Theta_33 * minus_p_T_3 + p_T_6 * 2);
    const ella_real modes_inverse_1 = 1 / modal_inertia_11;
    const ella_real modes_inverse_2 = 1 / modal_inertia_22;
    const ella_real modes_inverse_3 = 1 / modal_inertia_33;
    const ella_real modes_W_12 = C_21 * modes_inverse_1;
    link->modes_W[1] = modes_W_12;
    const ella_real minus_modes_W_13 = minus_C_31 * modes_inverse_1;
    link->modes_W[2] = -minus_modes_W_13;
    const ella_real modes_W_14 = C_41 * modes_inverse_1;
    link->modes_W[3] = modes_W_14;
    const ella_real minus_modes_W_21 = minus_C_12 * modes_inverse_2;
    link->modes_W[6] = -minus_modes_W_21;
    const ella_real modes_W_23 = minus_C_23 * modes_inverse_2;
    link->modes_W[8] = modes_W_23;
    const ella_real modes_W_25 = C_52 * modes_inverse_2;
    link->modes_W[10] = modes_W_25;
    const ella_real modes_W_31 = C_13 * modes_inverse_3;
    link->modes_W[12] = modes_W_31;
    const ella_real minus_modes_W_32 = minus_C_23 * modes_inverse_3;
    link->modes_W[13] = -minus_modes_W_32;
    const ella_real modes_W_36 = C_52 * modes_inverse_3;
    link->modes_W[17] = modes_W_36;
    const ella_real modes_w_1 = h_phi_1 * modes_inverse_1;
    link->modes_w[0] = modes_w_1;
    const ella_real modes_w_2 = h_phi_2 * modes_inverse_2;
    link->modes_w[1] = modes_w_2;
    const ella_real modes_w_3 = h_phi_3 * modes_inverse_3;
    link->modes_w[2] = modes_w_3;
    const ella_real M_i_11 = M_loaded_11 - (minus_C_12 * minus_modes_W_21 + C_13 * modes_W_31);
    const ella_real M_i_12 = C_13 * minus_modes_W_32 - minus_M_loaded_12;
    const ella_real M_i_13 = minus_C_12 * modes_W_23 - minus_M_loaded_13;
    const ella_real M_i_15 = minus_C_12 * modes_W_25 - minus_M_loaded_15;
    const ella_real M_i_16 = M_loaded_16 - C_13 * modes_W_36;
    link->Lambda_i[4] = M_i_16;
    const ella_real M_i_22 = M_loaded_22 - (C_21 * modes_W_12 + minus_C_23 * minus_modes_W_32);
    const ella_real M_i_23 = C_21 * minus_modes_W_13 - minus_M_loaded_23;
    const ella_real M_i_24 = minus_M_loaded_15 - C_21 * modes_W_14;
    const ella_real M_i_26 = minus_C_23 * modes_W_36 - minus_M_loaded_26;
    link->Lambda_i[8] = M_i_26;
    const ella_real M_i_33 = M_loaded_33 - (minus_C_31 * minus_modes_W_13 + minus_C_23 * modes_W_23);
    const ella_real M_i_34 = minus_C_31 * modes_W_14 - M_loaded_16;
    const ella_real M_i_35 = minus_M_loaded_26 - minus_C_23 * modes_W_25;
    const ella_real M_i_44 = M_loaded_44 - C_41 * modes_W_14;
    const ella_real M_i_55 = M_loaded_44 - C_52 * modes_W_25;
    const ella_real M_i_66 = M_loaded_44 - C_52 * modes_W_36;
    link->Lambda_i[14] = M_i_66;
    const ella_real h_i_1 = h_loaded_1 - (modes_W_31 * h_phi_3 - minus_modes_W_21 * h_phi_2);
    const ella_real h_i_2 = h_loaded_2 - (modes_W_12 * h_phi_1 - minus_modes_W_32 * h_phi_3);
    const ella_real h_i_3 = h_loaded_3 - (modes_W_23 * h_phi_2 - minus_modes_W_13 * h_phi_1);
    const ella_real h_i_4 = h_loaded_4 - modes_W_14 * h_phi_1;
    const ella_real h_i_5 = h_loaded_5 - modes_W_25 * h_phi_2;
    const ella_real h_i_6 = h_loaded_6 - modes_W_36 * h_phi_3;
    link->p_i[5] = h_i_6;

    /* joint: its accelerations eliminated from its rows (43) */
    if (!(M_i_33 - ELLA_REAL_EPSILON * 8 * (M_i_11 + M_i_22 + M_i_33) > 0)) { return ELLA_SINGULAR; }
    const ella_real joint_inverse_1 = 1 / M_i_33;
    const ella_real joint_W_11 = M_i_13 * joint_inverse_1;
    link->joint_W[0] = joint_W_11;
    const ella_real joint_W_12 = M_i_23 * joint_inverse_1;
    link->joint_W[1] = joint_W_12;
    const ella_real joint_W_14 = M_i_34 * joint_inverse_1;
    link->joint_W[2] = joint_W_14;
    const ella_real joint_W_15 = M_i_35 * joint_inverse_1;
    link->joint_W[3] = joint_W_15;
    const ella_real joint_w_1 = (tau[0] - h_i_3) * joint_inverse_1;
    link->joint_w[0] = joint_w_1;
    const ella_real Lambda_i_11 = M_i_11 - M_i_13 * joint_W_11;
    link->Lambda_i[0] = Lambda_i_11;
    const ella_real Lambda_i_12 = M_i_12 - M_i_13 * joint_W_12;
    link->Lambda_i[1] = Lambda_i_12;
    const ella_real minus_Lambda_i_14 = M_i_13 * joint_W_14;
    link->Lambda_i[2] = -minus_Lambda_i_14;
    const ella_real Lambda_i_15 = M_i_15 - M_i_13 * joint_W_15;
    link->Lambda_i[3] = Lambda_i_15;
    const ella_real Lambda_i_22 = M_i_22 - M_i_23 * joint_W_12;
    link->Lambda_i[5] = Lambda_i_22;
    const ella_real Lambda_i_24 = M_i_24 - M_i_23 * joint_W_14;
    link->Lambda_i[6] = Lambda_i_24;
    const ella_real minus_Lambda_i_25 = M_i_23 * joint_W_15;
    link->Lambda_i[7] = -minus_Lambda_i_25;
    const ella_real Lambda_i_44 = M_i_44 - M_i_34 * joint_W_14;
    link->Lambda_i[9] = Lambda_i_44;
    const ella_real minus_Lambda_i_45 = M_i_34 * joint_W_15;
    link->Lambda_i[10] = -minus_Lambda_i_45;
    const ella_real Lambda_i_55 = M_i_55 - M_i_35 * joint_W_15;
    link->Lambda_i[12] = Lambda_i_55;
    const ella_real p_i_1 = h_i_1 + M_i_13 * joint_w_1;
    link->p_i[0] = p_i_1;
    const ella_real p_i_2 = h_i_2 + M_i_23 * joint_w_1;
    link->p_i[1] = p_i_2;
    const ella_real p_i_4 = h_i_4 + M_i_34 * joint_w_1;
    link->p_i[3] = p_i_4;
    const ella_real p_i_5 = h_i_5 + M_i_35 * joint_w_1;
    link->p_i[4] = p_i_5;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const ella_real t24 = Lambda_i_11 * link->R_P[3] + Lambda_i_12 * link->R_P[4];
    const ella_real t25 = Lambda_i_11 * link->R_P[6] + Lambda_i_12 * link->R_P[7];
    const ella_real t26 = Lambda_i_12 * link->R_P[3] + Lambda_i_22 * link->R_P[4];
    const ella_real t27 = Lambda_i_12 * link->R_P[6] + Lambda_i_22 * link->R_P[7];
    const ella_real Lambda_1 = link->R_P[0] * (Lambda_i_11 * link->R_P[0] + Lambda_i_12 * link->R_P[1])
        + link->R_P[1] * (Lambda_i_12 * link->R_P[0] + Lambda_i_22 * link->R_P[1]);
    base->Lambda[0] = Lambda_1;
    const ella_real Lambda_2 = link->R_P[0] * t24 + link->R_P[1] * t26;
    base->Lambda[1] = Lambda_2;
    const ella_real Lambda_3 = link->R_P[0] * t25 + link->R_P[1] * t27;
    base->Lambda[2] = Lambda_3;
    const ella_real Lambda_7 = link->R_P[3] * t24 + link->R_P[4] * t26;
    base->Lambda[6] = Lambda_7;
    const ella_real Lambda_8 = link->R_P[3] * t25 + link->R_P[4] * t27;
    base->Lambda[7] = Lambda_8;
    const ella_real Lambda_12 = link->R_P[6] * t25 + link->R_P[7] * t27;
    base->Lambda[11] = Lambda_12;
    const ella_real t28 = Lambda_i_15 * link->R_P[1] - minus_Lambda_i_14 * link->R_P[0] + M_i_16 * link->R_P[2];
    const ella_real t29 = Lambda_i_15 * link->R_P[4] - minus_Lambda_i_14 * link->R_P[3] + M_i_16 * link->R_P[5];
    const ella_real t30 = Lambda_i_15 * link->R_P[7] - minus_Lambda_i_14 * link->R_P[6] + M_i_16 * link->R_P[8];
    const ella_real t31 = Lambda_i_24 * link->R_P[0] - minus_Lambda_i_25 * link->R_P[1] + M_i_26 * link->R_P[2];
    const ella_real t32 = Lambda_i_24 * link->R_P[3] - minus_Lambda_i_25 * link->R_P[4] + M_i_26 * link->R_P[5];
    const ella_real t33 = Lambda_i_24 * link->R_P[6] - minus_Lambda_i_25 * link->R_P[7] + M_i_26 * link->R_P[8];
    const ella_real Lambda_4 = link->R_P[0] * t28 + link->R_P[1] * t31;
    base->Lambda[3] = Lambda_4;
    const ella_real Lambda_5 = link->R_P[0] * t29 + link->R_P[1] * t32;
    base->Lambda[4] = Lambda_5;
    const ella_real Lambda_6 = link->R_P[0] * t30 + link->R_P[1] * t33;
    base->Lambda[5] = Lambda_6;
    const ella_real Lambda_9 = link->R_P[3] * t28 + link->R_P[4] * t31;
    base->Lambda[8] = Lambda_9;
    const ella_real Lambda_10 = link->R_P[3] * t29 + link->R_P[4] * t32;
    base->Lambda[9] = Lambda_10;
    const ella_real Lambda_11 = link->R_P[3] * t30 + link->R_P[4] * t33;
    base->Lambda[10] = Lambda_11;
    const ella_real Lambda_13 = link->R_P[6] * t28 + link->R_P[7] * t31;
    base->Lambda[12] = Lambda_13;
    const ella_real Lambda_14 = link->R_P[6] * t29 + link->R_P[7] * t32;
    base->Lambda[13] = Lambda_14;
    const ella_real Lambda_15 = link->R_P[6] * t30 + link->R_P[7] * t33;
    base->Lambda[14] = Lambda_15;
    const ella_real t34 = (Lambda_i_44 - M_i_66) * REAL(0.5);
    const ella_real t35 = t34 * link->R_P[0] - minus_Lambda_i_45 * link->R_P[1];
    const ella_real t36 = t34 * link->R_P[3] - minus_Lambda_i_45 * link->R_P[4];
    const ella_real t37 = t34 * link->R_P[6] - minus_Lambda_i_45 * link->R_P[7];
    const ella_real t38 = (Lambda_i_55 - M_i_66) * REAL(0.5);
    const ella_real t39 = t38 * link->R_P[1];
    const ella_real t40 = t38 * link->R_P[4];
    const ella_real t41 = t38 * link->R_P[7];
    const ella_real Lambda_16 = (link->R_P[0] * t35 + link->R_P[1] * t39) * 2 + M_i_66;
    base->Lambda[15] = Lambda_16;
    const ella_real Lambda_17 = link->R_P[0] * t36 + link->R_P[1] * t40
        + (link->R_P[3] * t35 + link->R_P[4] * t39);
    base->Lambda[16] = Lambda_17;
    const ella_real Lambda_18 = link->R_P[0] * t37 + link->R_P[1] * t41
        + (link->R_P[6] * t35 + link->R_P[7] * t39);
    base->Lambda[17] = Lambda_18;
    const ella_real Lambda_19 = (link->R_P[3] * t36 + link->R_P[4] * t40) * 2 + M_i_66;
    base->Lambda[18] = Lambda_19;
    const ella_real Lambda_20 = link->R_P[3] * t37 + link->R_P[4] * t41
        + (link->R_P[6] * t36 + link->R_P[7] * t40);
    base->Lambda[19] = Lambda_20;
    const ella_real Lambda_21 = (link->R_P[6] * t37 + link->R_P[7] * t41) * 2 + M_i_66;
    base->Lambda[20] = Lambda_21;
    const ella_real p_1 = link->R_P[0] * p_i_1 + link->R_P[1] * p_i_2 + link->R_P[2] * tau[0];
    base->p[0] = p_1;
    const ella_real p_2 = link->R_P[3] * p_i_1 + link->R_P[4] * p_i_2 + link->R_P[5] * tau[0];
    base->p[1] = p_2;
    const ella_real p_3 = link->R_P[6] * p_i_1 + link->R_P[7] * p_i_2 + link->R_P[8] * tau[0];
    base->p[2] = p_3;
    const ella_real p_4 = link->R_P[0] * p_i_4 + link->R_P[1] * p_i_5 + link->R_P[2] * h_i_6;
    base->p[3] = p_4;
    const ella_real p_5 = link->R_P[3] * p_i_4 + link->R_P[4] * p_i_5 + link->R_P[5] * h_i_6;
    base->p[4] = p_5;
    const ella_real p_6 = link->R_P[6] * p_i_4 + link->R_P[7] * p_i_5 + link->R_P[8] * h_i_6;
    base->p[5] = p_6;

    /* outputs */
    link->p_i[2] = tau[0];
    return ELLA_OK;
}

/* accelerate, links like upper_arm: 62 operations */
ELLA_PART ella_status accelerate_upper_arm(const ella_link_constants *restrict c, const ella_link_store *restrict link, ella_node *restrict tip,
    ella_real qddot[restrict 2], ella_real wrench[restrict 6], ella_real alpha[restrict 6],
    ella_real etaddot[restrict 3])
{
    /* joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const ella_real qddot_1 = link->joint_w[0] - link->joint_L[0] * link->joint_w[1];
    qddot[0] = qddot_1;

    /* link: what is added to the acceleration of F_i, modal accelerations (83) */
    const ella_real delta_1 = link->A[0] * qddot_1;
    const ella_real delta_2 = link->A[1] * qddot_1;
    const ella_real alpha_1 = delta_1 + link->alpha_0[0];
    alpha[0] = alpha_1;
    const ella_real alpha_2 = delta_2 + link->alpha_0[1];
    alpha[1] = alpha_2;
    const ella_real t1 = link->modes_w[0]
        + (link->modes_W[0] * delta_1 + link->modes_W[1] * delta_2 + link->modes_W[2] * link->joint_w[1]);
    const ella_real t2 = link->modes_w[1]
        + (link->modes_W[6] * delta_1 + link->modes_W[7] * delta_2 + link->modes_W[8] * link->joint_w[1]);
    const ella_real minus_etaddot_3 = link->modes_w[2]
        + (link->modes_W[12] * delta_1 + link->modes_W[13] * delta_2 + link->modes_W[14] * link->joint_w[1]);
    etaddot[2] = -minus_etaddot_3;
    const ella_real minus_etaddot_2 = t2 - link->modes_L[2] * minus_etaddot_3;
    etaddot[1] = -minus_etaddot_2;
    const ella_real minus_etaddot_1 = t1 - link->modes_L[0] * minus_etaddot_2
        - link->modes_L[1] * minus_etaddot_3;
    etaddot[0] = -minus_etaddot_1;

    /* tip: what is added to the acceleration of the tip section (accconst1b) */
    const ella_real t3 = c->Psi_c_y3 * minus_etaddot_3;
    const ella_real t4 = c->Psi_c_z2 * minus_etaddot_2;
    const ella_real delta_T_1 = delta_1 + (link->J_l[1] * t3 - link->J_l[2] * t4);
    tip->delta[0] = delta_T_1;
    const ella_real delta_T_2 = delta_2 - (link->J_l[3] * t3 + link->J_l[4] * t4);
    tip->delta[1] = delta_T_2;
    const ella_real delta_T_3 = link->joint_w[1] - (link->J_l[4] * t3 + link->J_l[5] * t4);
    tip->delta[2] = delta_T_3;
    const ella_real delta_T_4 = delta_2 * link->r_T[2] - link->joint_w[1] * link->r_T[1]
        - minus_etaddot_1 * REAL(1.4142135623730951);
    tip->delta[3] = delta_T_4;
    const ella_real delta_T_5 = link->joint_w[1] * link->r_T[0] - delta_1 * link->r_T[2] - minus_etaddot_2 * 2;
    tip->delta[4] = delta_T_5;
    const ella_real delta_T_6 = delta_1 * link->r_T[1] - delta_2 * link->r_T[0] - minus_etaddot_3 * 2;
    tip->delta[5] = delta_T_6;

    /* outputs */
    qddot[1] = link->joint_w[1];
    alpha[2] = link->joint_w[1];
    alpha[3] = link->alpha_0[3];
    alpha[4] = link->alpha_0[4];
    alpha[5] = link->alpha_0[5];

    if (wrench) {
        /* outputs */
        wrench[0] = link->p_i[0];
        wrench[1] = link->p_i[1];
        wrench[2] = link->p_i[2];
        wrench[3] = link->p_i[3];
        wrench[4] = link->p_i[4];
        wrench[5] = link->p_i[5];
    }
    return ELLA_OK;
}

/* accelerate, links like forearm: 109 operations */
ELLA_PART ella_status accelerate_forearm(const ella_link_store *restrict link, const ella_node *restrict base, ella_real qddot[restrict 1],
    ella_real wrench[restrict 6], ella_real alpha[restrict 6], ella_real etaddot[restrict 3])
{
    /* joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const ella_real carried_1 = link->R_P[0] * base->delta[0] + link->R_P[3] * base->delta[1]
        + link->R_P[6] * base->delta[2];
    const ella_real carried_2 = link->R_P[1] * base->delta[0] + link->R_P[4] * base->delta[1]
        + link->R_P[7] * base->delta[2];
    const ella_real carried_3 = link->R_P[2] * base->delta[0] + link->R_P[5] * base->delta[1]
        + link->R_P[8] * base->delta[2];
    const ella_real carried_4 = link->R_P[0] * base->delta[3] + link->R_P[3] * base->delta[4]
        + link->R_P[6] * base->delta[5];
    const ella_real carried_5 = link->R_P[1] * base->delta[3] + link->R_P[4] * base->delta[4]
        + link->R_P[7] * base->delta[5];
    const ella_real carried_6 = link->R_P[2] * base->delta[3] + link->R_P[5] * base->delta[4]
        + link->R_P[8] * base->delta[5];
    const ella_real t1 = link->joint_W[0] * carried_1 + link->joint_W[1] * carried_2 + carried_3
        + link->joint_W[2] * carried_4;
    const ella_real qddot_1 = link->joint_w[0] - (t1 + link->joint_W[3] * carried_5);
    qddot[0] = qddot_1;

    /* link: what is added to the acceleration of F_i, modal accelerations (83) */
    const ella_real delta_3 = carried_3 + qddot_1;
    const ella_real alpha_1 = carried_1 + link->alpha_0[0];
    alpha[0] = alpha_1;
    const ella_real alpha_2 = carried_2 + link->alpha_0[1];
    alpha[1] = alpha_2;
    const ella_real alpha_3 = delta_3 + link->alpha_0[2];
    alpha[2] = alpha_3;
    const ella_real alpha_4 = carried_4 + link->alpha_0[3];
    alpha[3] = alpha_4;
    const ella_real alpha_5 = carried_5 + link->alpha_0[4];
    alpha[4] = alpha_5;
    const ella_real alpha_6 = carried_6 + link->alpha_0[5];
    alpha[5] = alpha_6;
    const ella_real minus_etaddot_1 = link->modes_w[0]
        + (link->modes_W[1] * carried_2 + link->modes_W[2] * delta_3 + link->modes_W[3] * carried_4);
    etaddot[0] = -minus_etaddot_1;
    const ella_real minus_etaddot_2 = link->modes_w[1]
        + (link->modes_W[6] * carried_1 + link->modes_W[8] * delta_3 + link->modes_W[10] * carried_5);
    etaddot[1] = -minus_etaddot_2;
    const ella_real minus_etaddot_3 = link->modes_w[2]
        + (link->modes_W[12] * carried_1 + link->modes_W[13] * carried_2 + link->modes_W[17] * carried_6);
    etaddot[2] = -minus_etaddot_3;

    if (wrench) {
        /* joint wrench (48) */
        const ella_real t2 = link->Lambda_i[0] * carried_1 + link->Lambda_i[1] * carried_2
            + link->Lambda_i[2] * carried_4 + link->Lambda_i[3] * carried_5;
        const ella_real t3 = link->Lambda_i[1] * carried_1 + link->Lambda_i[5] * carried_2
            + link->Lambda_i[6] * carried_4 + link->Lambda_i[7] * carried_5;
        const ella_real t4 = link->Lambda_i[2] * carried_1 + link->Lambda_i[6] * carried_2
            + link->Lambda_i[9] * carried_4 + link->Lambda_i[10] * carried_5;
        const ella_real t5 = link->Lambda_i[3] * carried_1 + link->Lambda_i[7] * carried_2
            + link->Lambda_i[10] * carried_4 + link->Lambda_i[12] * carried_5;
        const ella_real wrench_1 = t2 + link->Lambda_i[4] * carried_6 + link->p_i[0];
        wrench[0] = wrench_1;
        const ella_real wrench_2 = t3 + link->Lambda_i[8] * carried_6 + link->p_i[1];
        wrench[1] = wrench_2;
        const ella_real wrench_4 = t4 + link->p_i[3];
        wrench[3] = wrench_4;
        const ella_real wrench_5 = t5 + link->p_i[4];
        wrench[4] = wrench_5;
        const ella_real wrench_6 = link->Lambda_i[4] * carried_1 + link->Lambda_i[8] * carried_2
            + link->Lambda_i[14] * carried_6 + link->p_i[5];
        wrench[5] = wrench_6;

        /* outputs */
        wrench[2] = link->p_i[2];
    }
    return ELLA_OK;
}

/* twist rates, links like upper_arm: 67 operations */
ELLA_PART ella_status twist_rates_upper_arm(const ella_real quaternion[restrict 4], const ella_real gravity[restrict 3],
    const ella_real alpha[restrict 6], const ella_real twist[restrict 6], ella_real Vdot[restrict 6])
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
    const ella_real t12 = alpha[3]
        + ((1 + t4 * (t1 - t5)) * gravity[0] + t4 * (t9 + t6) * gravity[1] + t4 * (t7 - t10) * gravity[2]);
    const ella_real t13 = alpha[4]
        + (t4 * (t6 - t9) * gravity[0] + (1 + t4 * (t2 - t5)) * gravity[1] + t4 * (t11 + t8) * gravity[2]);
    const ella_real t14 = alpha[5]
        + (t4 * (t10 + t7) * gravity[0] + t4 * (t8 - t11) * gravity[1] + (1 + t4 * (t3 - t5)) * gravity[2]);
    const ella_real Vdot_4 = t12 - (twist[1] * twist[5] - twist[2] * twist[4]);
    Vdot[3] = Vdot_4;
    const ella_real Vdot_5 = t13 - (twist[2] * twist[3] - twist[0] * twist[5]);
    Vdot[4] = Vdot_5;
    const ella_real Vdot_6 = t14 - (twist[0] * twist[4] - twist[1] * twist[3]);
    Vdot[5] = Vdot_6;

    /* outputs */
    Vdot[0] = alpha[0];
    Vdot[1] = alpha[1];
    Vdot[2] = alpha[2];
    return ELLA_OK;
}

/* project, links like upper_arm: 342 operations */
ELLA_PART ella_status project_upper_arm(const ella_link_constants *c, ella_node *tip, const ella_real q[2], const ella_real twist[6],
    const ella_real eta[3], const ella_real etadot[3], const ella_real quaternion[4], ella_real new_q[2],
    ella_real new_twist[6], ella_real new_quaternion[4], ella_real new_position[3])
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

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_xz = turn.sine, R_rel_zz = turn.cosine;
    const ella_sincos turn_2 = ella_sine_cosine(q[1]);
    const ella_real R_rel_yx = turn_2.sine, R_rel_yy = turn_2.cosine;
    const ella_real R_rel_xx = R_rel_zz * R_rel_yy;
    const ella_real minus_R_rel_xy = R_rel_yx * R_rel_zz;
    const ella_real minus_R_rel_zx = R_rel_xz * R_rel_yy;
    const ella_real R_rel_zy = R_rel_xz * R_rel_yx;

    const ella_real t21 = R_rel_yx * R_rel_yx + R_rel_yy * R_rel_yy;
    const ella_real t22 = ELLA_REAL_EPSILON * 64;
    if (!(t21 - t22 > 0)) { return ELLA_SINGULAR; }
    const ella_real t23 = 1 / t21;
    const ella_real t24 = R_rel_yy * t14 - minus_R_rel_xy * t18 + R_rel_zy * t16
        - (R_rel_xx * t12 + R_rel_yx * t19 - minus_R_rel_zx * t17);
    const ella_real t25 = (R_rel_xz * t12 + R_rel_zz * t17
        - (R_rel_yy * t15 - minus_R_rel_xy * t13 + R_rel_zy * t20)) * REAL(0.5);
    const ella_real t26 = (R_rel_xx * t13 + R_rel_yx * t15 - minus_R_rel_zx * t20
        - (R_rel_xz * t18 + R_rel_zz * t16)) * REAL(0.5);
    const ella_real t27 = q[0] + (R_rel_yx * t23 * t25 + R_rel_yy * t23 * t26);
    const ella_real t28 = q[1] + t24 * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn_3 = ella_sine_cosine(t27);
    const ella_real R_rel_xz_2 = turn_3.sine, R_rel_zz_2 = turn_3.cosine;
    const ella_sincos turn_4 = ella_sine_cosine(t28);
    const ella_real R_rel_yx_2 = turn_4.sine, R_rel_yy_2 = turn_4.cosine;
    const ella_real R_rel_xx_2 = R_rel_zz_2 * R_rel_yy_2;
    const ella_real minus_R_rel_xy_2 = R_rel_yx_2 * R_rel_zz_2;
    const ella_real minus_R_rel_zx_2 = R_rel_xz_2 * R_rel_yy_2;
    const ella_real R_rel_zy_2 = R_rel_xz_2 * R_rel_yx_2;

    const ella_real t29 = R_rel_yx_2 * R_rel_yx_2 + R_rel_yy_2 * R_rel_yy_2;
    if (!(t29 - t22 > 0)) { return ELLA_SINGULAR; }
    const ella_real t30 = 1 / t29;
    const ella_real t31 = R_rel_xz_2 * t12 + R_rel_zz_2 * t17
        - (R_rel_yy_2 * t15 - minus_R_rel_xy_2 * t13 + R_rel_zy_2 * t20);
    const ella_real t32 = R_rel_xx_2 * t13 + R_rel_yx_2 * t15 - minus_R_rel_zx_2 * t20
        - (R_rel_xz_2 * t18 + R_rel_zz_2 * t16);
    const ella_real t33 = R_rel_yy_2 * t14 - minus_R_rel_xy_2 * t18 + R_rel_zy_2 * t16
        - (R_rel_xx_2 * t12 + R_rel_yx_2 * t19 - minus_R_rel_zx_2 * t17);
    const ella_real new_q_1 = t27 + (R_rel_yx_2 * t30 * (t31 * REAL(0.5)) + R_rel_yy_2 * t30 * (t32 * REAL(0.5)));
    const ella_real new_q_2 = t28 + t33 * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn_5 = ella_sine_cosine(new_q_1);
    const ella_real R_rel_xz_3 = turn_5.sine, R_rel_zz_3 = turn_5.cosine;
    const ella_sincos turn_6 = ella_sine_cosine(new_q_2);
    const ella_real R_rel_yx_3 = turn_6.sine, R_rel_yy_3 = turn_6.cosine;
    const ella_real R_rel_xx_3 = R_rel_zz_3 * R_rel_yy_3;
    const ella_real minus_R_rel_xy_3 = R_rel_yx_3 * R_rel_zz_3;
    const ella_real minus_R_rel_zx_3 = R_rel_xz_3 * R_rel_yy_3;
    const ella_real R_rel_zy_3 = R_rel_xz_3 * R_rel_yx_3;

    const ella_real t34 = R_rel_yx_3 * R_rel_yx_3 + R_rel_yy_3 * R_rel_yy_3;
    if (!(t34 - t22 > 0)) { return ELLA_SINGULAR; }
    const ella_real t35 = 1 / t34;
    const ella_real t36 = R_rel_yx_3 * t35 * twist[0] + R_rel_yy_3 * t35 * twist[1];

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
    const ella_real t37 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t37;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t37;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t37;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t38 = omega_s_z + twist[2];
    const ella_real t39 = R_T_xz * t38;
    const ella_real t40 = R_T_yz * t38;
    const ella_real t41 = R_T_zz * t38;
    const ella_real omega_T_z = R_T_xz * (omega_s_x + twist[0]) + R_T_yz * (omega_s_y + twist[1]) + t41;

    const ella_real R_m_11 = t18 * R_T_xx + t12 * minus_R_T_xy - t13 * R_T_xz;
    const ella_real R_m_12 = t12 * R_T_yy - t18 * minus_R_T_xy + t13 * R_T_yz;
    const ella_real R_m_21 = t14 * R_T_xx + t19 * minus_R_T_xy - t15 * R_T_xz;
    const ella_real R_m_22 = t19 * R_T_yy - t14 * minus_R_T_xy + t15 * R_T_yz;
    const ella_real R_m_31 = t16 * R_T_xx + t17 * minus_R_T_xy - t20 * R_T_xz;
    const ella_real R_m_32 = t17 * R_T_yy - t16 * minus_R_T_xy + t20 * R_T_yz;

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx_3 * t36;
    const ella_real omega_J_y = R_rel_yy_3 * t36;

    const ella_real t42 = new_q_1 * REAL(0.5);
    const ella_sincos turn_7 = ella_sine_cosine(t42);
    const ella_real t43 = turn_7.sine, t44 = turn_7.cosine;
    const ella_real t45 = new_q_2 * REAL(0.5);
    const ella_sincos turn_8 = ella_sine_cosine(t45);
    const ella_real t46 = turn_8.sine, t47 = turn_8.cosine;
    const ella_real new_quaternion_1 = t44 * t47;
    const ella_real new_quaternion_4 = t44 * t46;
    const ella_real new_quaternion_3 = t47 * t43;
    const ella_real new_quaternion_2 = t43 * t46;

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    const ella_real r_T_y = eta[1] * 2;
    const ella_real r_T_z = eta[2] * 2;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_x = etadot[0] * REAL(1.4142135623730951);
    const ella_real udot_T_y = etadot[1] * 2;
    const ella_real udot_T_z = etadot[2] * 2;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t48 = omega_s_x + omega_J_x;
    const ella_real t49 = omega_s_y + omega_J_y;
    const ella_real omega_T_x = R_T_xx * t48 + minus_R_T_xy * t49 - t39;
    const ella_real omega_T_y = R_T_yy * t49 - minus_R_T_xy * t48 + t40;
    const ella_real omega_T_z_2 = R_T_xz * t48 + R_T_yz * t49 + t41;

    /* v_T: velocity of the tip point (46) */
    const ella_real t50 = udot_T_x + omega_J_y * r_T_z - twist[2] * r_T_y;
    const ella_real t51 = udot_T_y + twist[2] * r_T_x - omega_J_x * r_T_z;
    const ella_real t52 = udot_T_z + omega_J_x * r_T_y - omega_J_y * r_T_x;
    const ella_real v_T_x = R_T_xx * t50 + minus_R_T_xy * t51 - R_T_xz * t52;
    const ella_real v_T_y = R_T_yy * t51 - minus_R_T_xy * t50 + R_T_yz * t52;
    const ella_real v_T_z = R_T_xz * t50 + R_T_yz * t51 + R_T_zz * t52;

    const ella_real r_x = R_rel_xx_3 * r_T_x - minus_R_rel_xy_3 * r_T_y + R_rel_xz_3 * r_T_z;
    const ella_real r_y = R_rel_yx_3 * r_T_x + R_rel_yy_3 * r_T_y;
    const ella_real r_z = R_rel_zy_3 * r_T_y - minus_R_rel_zx_3 * r_T_x + R_rel_zz_3 * r_T_z;
    const ella_real t53 = x * REAL(0.25);
    const ella_real t54 = 1 - t53 * (REAL(0.5) - t53 * ella_c4(t53));
    const ella_real t55 = (1 - t53 * (REAL(0.16666666666666666) - t53 * ella_c5(t53))) * REAL(0.5);
    const ella_real t56 = t55 * theta_y;
    const ella_real t57 = t55 * theta_z;
    const ella_real Q_1 = new_quaternion_1 * t54 - (new_quaternion_3 * t56 + new_quaternion_4 * t57);
    const ella_real Q_2 = t54 * new_quaternion_2 + (new_quaternion_3 * t57 - new_quaternion_4 * t56);
    const ella_real Q_3 = new_quaternion_1 * t56 + t54 * new_quaternion_3 - new_quaternion_2 * t57;
    const ella_real Q_4 = new_quaternion_1 * t57 + t54 * new_quaternion_4 + new_quaternion_2 * t56;

    /* outputs */
    new_q[0] = new_q_1;
    new_q[1] = new_q_2;
    tip->omega_m[2] = omega_T_z;
    tip->R_m[0] = R_m_11;
    tip->R_m[1] = R_m_12;
    tip->R_m[3] = R_m_21;
    tip->R_m[4] = R_m_22;
    tip->R_m[6] = R_m_31;
    tip->R_m[7] = R_m_32;
    new_twist[0] = omega_J_x;
    new_twist[1] = omega_J_y;
    new_twist[2] = twist[2];
    new_twist[3] = 0;
    new_twist[4] = 0;
    new_twist[5] = 0;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = 0;
    new_position[1] = 0;
    new_position[2] = 0;
    tip->omega[0] = omega_T_x;
    tip->omega[1] = omega_T_y;
    tip->omega[2] = omega_T_z_2;
    tip->v[0] = v_T_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = Q_1;
    tip->Q[1] = Q_2;
    tip->Q[2] = Q_3;
    tip->Q[3] = Q_4;
    return ELLA_OK;
}

/* project, links like forearm: 103 operations */
ELLA_PART ella_status project_forearm(const ella_node *base, const ella_real q[1], const ella_real twist[6], const ella_real quaternion[4],
    ella_real new_q[1], ella_real new_twist[6], ella_real new_quaternion[4], ella_real new_position[3])
{
    const ella_real t1 = quaternion[1] * quaternion[1];
    const ella_real t2 = quaternion[2] * quaternion[2];
    const ella_real t3 = quaternion[3] * quaternion[3];
    const ella_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const ella_real t5 = t1 + t2 + t3;
    const ella_real t6 = quaternion[1] * quaternion[2];
    const ella_real t7 = quaternion[0] * quaternion[3];
    const ella_real t8 = t4 * (t6 - t7);
    const ella_real t9 = t4 * (t7 + t6);
    const ella_real t10 = t4 * (quaternion[1] * quaternion[3] - quaternion[0] * quaternion[2]);
    const ella_real t11 = t4 * (quaternion[0] * quaternion[1] + quaternion[2] * quaternion[3]);
    const ella_real t12 = 1 + t4 * (t1 - t5);
    const ella_real t13 = 1 + t4 * (t2 - t5);
    const ella_real t14 = base->R_m[0] * t12 + base->R_m[3] * t9 + base->R_m[6] * t10;
    const ella_real t15 = base->R_m[0] * t8 + base->R_m[3] * t13 + base->R_m[6] * t11;
    const ella_real t16 = base->R_m[1] * t12 + base->R_m[4] * t9 + base->R_m[7] * t10;
    const ella_real t17 = base->R_m[1] * t8 + base->R_m[4] * t13 + base->R_m[7] * t11;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real minus_R_rel_xy = turn.sine, R_rel_xx = turn.cosine;

    const ella_real t18 = q[0]
        + (R_rel_xx * t16 - minus_R_rel_xy * t14 - (R_rel_xx * t15 + minus_R_rel_xy * t17)) * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn_2 = ella_sine_cosine(t18);
    const ella_real minus_R_rel_xy_2 = turn_2.sine, R_rel_xx_2 = turn_2.cosine;

    const ella_real t19 = (R_rel_xx_2 * t16 - minus_R_rel_xy_2 * t14
        - (R_rel_xx_2 * t15 + minus_R_rel_xy_2 * t17)) * REAL(0.5);
    const ella_real new_q_1 = t18 + t19;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn_3 = ella_sine_cosine(new_q_1);
    const ella_real minus_R_rel_xy_3 = turn_3.sine, R_rel_xx_3 = turn_3.cosine;

    const ella_real t20 = twist[2] - base->omega_m[2];

    /* omega_R: angular velocity of the parent's tip */
    const ella_real omega_R_x = R_rel_xx_3 * base->omega[0] + minus_R_rel_xy_3 * base->omega[1];
    const ella_real omega_R_y = R_rel_xx_3 * base->omega[1] - minus_R_rel_xy_3 * base->omega[0];

    /* omega: angular velocity of the link (45) */
    const ella_real omega_z = base->omega[2] + t20;

    /* v_R: velocity of the joint point */
    const ella_real v_R_x = R_rel_xx_3 * base->v[0] + minus_R_rel_xy_3 * base->v[1];
    const ella_real v_R_y = R_rel_xx_3 * base->v[1] - minus_R_rel_xy_3 * base->v[0];

    const ella_real t21 = new_q_1 * REAL(0.5);
    const ella_sincos turn_4 = ella_sine_cosine(t21);
    const ella_real t22 = turn_4.sine, t23 = turn_4.cosine;
    const ella_real new_quaternion_1 = base->Q[0] * t23 - base->Q[3] * t22;
    const ella_real new_quaternion_4 = base->Q[0] * t22 + t23 * base->Q[3];
    const ella_real new_quaternion_2 = t23 * base->Q[1] + base->Q[2] * t22;
    const ella_real new_quaternion_3 = t23 * base->Q[2] - base->Q[1] * t22;

    /* outputs */
    new_q[0] = new_q_1;
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
    return ELLA_OK;
}

/* forward kinematics, links like upper_arm: 193 operations */
ELLA_PART ella_status forward_kinematics_upper_arm(const ella_link_constants *c, ella_node *tip, const ella_real q[2], const ella_real qdot[2],
    const ella_real eta[3], const ella_real etadot[3], ella_real new_twist[6], ella_real new_quaternion[4],
    ella_real new_position[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_xz = turn.sine, R_rel_zz = turn.cosine;
    const ella_sincos turn_2 = ella_sine_cosine(q[1]);
    const ella_real R_rel_yx = turn_2.sine, R_rel_yy = turn_2.cosine;
    const ella_real R_rel_xx = R_rel_zz * R_rel_yy;
    const ella_real minus_R_rel_xy = R_rel_yx * R_rel_zz;
    const ella_real minus_R_rel_zx = R_rel_xz * R_rel_yy;
    const ella_real R_rel_zy = R_rel_xz * R_rel_yx;

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx * qdot[0];
    const ella_real omega_J_y = R_rel_yy * qdot[0];

    const ella_real t1 = q[0] * REAL(0.5);
    const ella_sincos turn_3 = ella_sine_cosine(t1);
    const ella_real t2 = turn_3.sine, t3 = turn_3.cosine;
    const ella_real t4 = q[1] * REAL(0.5);
    const ella_sincos turn_4 = ella_sine_cosine(t4);
    const ella_real t5 = turn_4.sine, t6 = turn_4.cosine;
    const ella_real new_quaternion_1 = t3 * t6;
    const ella_real new_quaternion_4 = t3 * t5;
    const ella_real new_quaternion_3 = t6 * t2;
    const ella_real new_quaternion_2 = t2 * t5;

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
    const ella_real t7 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t7;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t7;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t7;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t8 = omega_s_x + omega_J_x;
    const ella_real t9 = omega_s_y + omega_J_y;
    const ella_real t10 = omega_s_z + qdot[1];
    const ella_real omega_T_x = R_T_xx * t8 + minus_R_T_xy * t9 - R_T_xz * t10;
    const ella_real omega_T_y = R_T_yy * t9 - minus_R_T_xy * t8 + R_T_yz * t10;
    const ella_real omega_T_z = R_T_xz * t8 + R_T_yz * t9 + R_T_zz * t10;

    /* v_T: velocity of the tip point (46) */
    const ella_real t11 = udot_T_x + omega_J_y * r_T_z - qdot[1] * r_T_y;
    const ella_real t12 = udot_T_y + qdot[1] * r_T_x - omega_J_x * r_T_z;
    const ella_real t13 = udot_T_z + omega_J_x * r_T_y - omega_J_y * r_T_x;
    const ella_real v_T_x = R_T_xx * t11 + minus_R_T_xy * t12 - R_T_xz * t13;
    const ella_real v_T_y = R_T_yy * t12 - minus_R_T_xy * t11 + R_T_yz * t13;
    const ella_real v_T_z = R_T_xz * t11 + R_T_yz * t12 + R_T_zz * t13;

    const ella_real R_xx = R_rel_xx * R_T_xx - minus_R_rel_xy * minus_R_T_xy - R_rel_xz * R_T_xz;
    const ella_real R_xy = R_rel_xz * R_T_yz - (minus_R_rel_xy * R_T_yy + R_rel_xx * minus_R_T_xy);
    const ella_real R_xz = R_rel_xx * R_T_xz - minus_R_rel_xy * R_T_yz + R_rel_xz * R_T_zz;
    const ella_real R_yx = R_rel_yx * R_T_xx + R_rel_yy * minus_R_T_xy;
    const ella_real R_yy = R_rel_yy * R_T_yy - R_rel_yx * minus_R_T_xy;
    const ella_real R_yz = R_rel_yx * R_T_xz + R_rel_yy * R_T_yz;
    const ella_real R_zx = R_rel_zy * minus_R_T_xy - minus_R_rel_zx * R_T_xx - R_rel_zz * R_T_xz;
    const ella_real R_zy = R_rel_zy * R_T_yy + minus_R_rel_zx * minus_R_T_xy + R_rel_zz * R_T_yz;
    const ella_real R_zz = R_rel_zy * R_T_yz - minus_R_rel_zx * R_T_xz + R_rel_zz * R_T_zz;
    const ella_real r_x = R_rel_xx * r_T_x - minus_R_rel_xy * r_T_y + R_rel_xz * r_T_z;
    const ella_real r_y = R_rel_yx * r_T_x + R_rel_yy * r_T_y;
    const ella_real r_z = R_rel_zy * r_T_y - minus_R_rel_zx * r_T_x + R_rel_zz * r_T_z;
    const ella_real t14 = x * REAL(0.25);
    const ella_real t15 = 1 - t14 * (REAL(0.5) - t14 * ella_c4(t14));
    const ella_real t16 = (1 - t14 * (REAL(0.16666666666666666) - t14 * ella_c5(t14))) * REAL(0.5);
    const ella_real t17 = t16 * theta_y;
    const ella_real t18 = t16 * theta_z;
    const ella_real Q_1 = new_quaternion_1 * t15 - (new_quaternion_3 * t17 + new_quaternion_4 * t18);
    const ella_real Q_2 = t15 * new_quaternion_2 + (new_quaternion_3 * t18 - new_quaternion_4 * t17);
    const ella_real Q_3 = new_quaternion_1 * t17 + t15 * new_quaternion_3 - new_quaternion_2 * t18;
    const ella_real Q_4 = new_quaternion_1 * t18 + t15 * new_quaternion_4 + new_quaternion_2 * t17;

    /* outputs */
    new_twist[0] = omega_J_x;
    new_twist[1] = omega_J_y;
    new_twist[2] = qdot[1];
    new_twist[3] = 0;
    new_twist[4] = 0;
    new_twist[5] = 0;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = 0;
    new_position[1] = 0;
    new_position[2] = 0;
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

/* forward kinematics, links like forearm: 138 operations */
ELLA_PART ella_status forward_kinematics_forearm(const ella_link_constants *c, const ella_node *base, ella_node *tip, const ella_real q[1],
    const ella_real qdot[1], const ella_real eta[3], ella_real new_twist[6], ella_real new_quaternion[4],
    ella_real new_position[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real minus_R_rel_xy = turn.sine, R_rel_xx = turn.cosine;

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
    const ella_sincos turn_2 = ella_sine_cosine(t7);
    const ella_real t8 = turn_2.sine, t9 = turn_2.cosine;
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
    return ELLA_OK;
}

/* kinematics, links like upper_arm: 150 operations */
ELLA_PART ella_status kinematics_upper_arm(const ella_link_constants *c, ella_link_store *link, const ella_node *base, ella_node *tip,
    const ella_real q[2], const ella_real qdot[2], const ella_real eta[3], const ella_real etadot[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_xz = turn.sine, R_rel_zz = turn.cosine;
    const ella_sincos turn_2 = ella_sine_cosine(q[1]);
    const ella_real R_rel_yx = turn_2.sine, R_rel_yy = turn_2.cosine;
    const ella_real R_rel_xx = R_rel_zz * R_rel_yy;
    const ella_real minus_R_rel_xy = R_rel_yx * R_rel_zz;
    const ella_real minus_R_rel_zx = R_rel_xz * R_rel_yy;
    const ella_real R_rel_zy = R_rel_xz * R_rel_yx;

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx * qdot[0];
    const ella_real omega_J_y = R_rel_yy * qdot[0];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real t1 = qdot[0] * qdot[1];
    const ella_real beta_omega_x = t1 * R_rel_yy;
    const ella_real minus_beta_omega_y = t1 * R_rel_yx;

    /* alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const ella_real t2 = -minus_beta_omega_y;
    const ella_real alpha_0_4 = R_rel_xx * base->alpha_0[3] + R_rel_yx * base->alpha_0[4]
        - minus_R_rel_zx * base->alpha_0[5];
    const ella_real alpha_0_5 = R_rel_yy * base->alpha_0[4] - minus_R_rel_xy * base->alpha_0[3]
        + R_rel_zy * base->alpha_0[5];
    const ella_real alpha_0_6 = R_rel_xz * base->alpha_0[3] + R_rel_zz * base->alpha_0[5];

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
    const ella_real t3 = ella_c5(x);
    const ella_real c3 = REAL(0.16666666666666666) - x * t3;
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real t4 = ella_c4(x);
    const ella_real c2 = REAL(0.5) - x * t4;

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
    const ella_real t5 = -minus_R_T_xy;
    const ella_real R_T_xz = c1 * theta_y;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    const ella_real t6 = -R_T_xz;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_y = c->Psi_c_y3 * etadot[2];
    const ella_real thetadot_z = c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t7 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t7;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t7;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t7;

    /* xdot: rate of the squared angle */
    const ella_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const ella_real c2dot = xdot * (t4 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const ella_real c3dot = xdot * (t3 * REAL(1.5) - t4 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_x = c2dot * t7;
    const ella_real alpha_s_y = c3 * thetadot_z * t7 + c3dot * theta_z * t7;
    const ella_real minus_alpha_s_z = c3 * thetadot_y * t7 + c3dot * theta_y * t7;

    /* tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const ella_real omega_T_1 = omega_J_x + omega_s_x;
    const ella_real omega_T_2 = omega_J_y + omega_s_y;
    const ella_real omega_T_3 = qdot[1] + omega_s_z;
    const ella_real alpha_0_T_1 = beta_omega_x + alpha_s_x + (omega_J_y * omega_s_z - qdot[1] * omega_s_y);
    const ella_real alpha_0_T_2 = alpha_s_y - minus_beta_omega_y + (qdot[1] * omega_s_x - omega_J_x * omega_s_z);
    const ella_real alpha_0_T_3 = omega_J_x * omega_s_y - omega_J_y * omega_s_x - minus_alpha_s_z;
    const ella_real t8 = omega_J_y * r_T_z - qdot[1] * r_T_y + etadot[0] * REAL(2.8284271247461903);
    const ella_real t9 = qdot[1] * r_T_x - omega_J_x * r_T_z + etadot[1] * 4;
    const ella_real t10 = omega_J_x * r_T_y - omega_J_y * r_T_x + etadot[2] * 4;
    const ella_real alpha_0_T_4 = alpha_0_4 - minus_beta_omega_y * r_T_z + (omega_J_y * t10 - qdot[1] * t9);
    const ella_real alpha_0_T_5 = alpha_0_5 - beta_omega_x * r_T_z + (qdot[1] * t8 - omega_J_x * t10);
    const ella_real alpha_0_T_6 = alpha_0_6 + (beta_omega_x * r_T_y + minus_beta_omega_y * r_T_x)
        + (omega_J_x * t9 - omega_J_y * t8);

    /* outputs */
    link->A[0] = R_rel_yx;
    link->A[1] = R_rel_yy;
    link->omega[0] = omega_J_x;
    link->omega[1] = omega_J_y;
    link->omega[2] = qdot[1];
    link->alpha_0[0] = beta_omega_x;
    link->alpha_0[1] = t2;
    link->alpha_0[3] = alpha_0_4;
    link->alpha_0[4] = alpha_0_5;
    link->alpha_0[5] = alpha_0_6;
    link->r_T[0] = r_T_x;
    link->r_T[1] = r_T_y;
    link->r_T[2] = r_T_z;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = minus_R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yy;
    link->R_T[4] = R_T_yz;
    link->R_T[5] = R_T_zz;
    link->J_l[1] = minus_J_l_xy;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yy;
    link->J_l[4] = J_l_yz;
    link->J_l[5] = J_l_zz;
    tip->R_T[0] = R_T_xx;
    tip->R_T[1] = t5;
    tip->R_T[2] = R_T_xz;
    tip->R_T[3] = minus_R_T_xy;
    tip->R_T[4] = R_T_yy;
    tip->R_T[5] = R_T_yz;
    tip->R_T[6] = t6;
    tip->R_T[7] = R_T_yz;
    tip->R_T[8] = R_T_zz;
    tip->omega[0] = omega_T_1;
    tip->omega[1] = omega_T_2;
    tip->omega[2] = omega_T_3;
    tip->alpha_0[0] = alpha_0_T_1;
    tip->alpha_0[1] = alpha_0_T_2;
    tip->alpha_0[2] = alpha_0_T_3;
    tip->alpha_0[3] = alpha_0_T_4;
    tip->alpha_0[4] = alpha_0_T_5;
    tip->alpha_0[5] = alpha_0_T_6;
    return ELLA_OK;
}

/* kinematics, links like forearm: 143 operations */
ELLA_PART ella_status kinematics_forearm(const ella_link_constants *c, ella_link_store *link, const ella_node *base, ella_node *tip,
    const ella_real q[1], const ella_real qdot[1], const ella_real eta[3], const ella_real etadot[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real minus_R_rel_xy = turn.sine, R_rel_xx = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const ella_real R_P_11 = base->R_T[0] * R_rel_xx + base->R_T[1] * minus_R_rel_xy;
    const ella_real R_P_12 = base->R_T[1] * R_rel_xx - base->R_T[0] * minus_R_rel_xy;
    const ella_real R_P_21 = base->R_T[3] * R_rel_xx + base->R_T[4] * minus_R_rel_xy;
    const ella_real R_P_22 = base->R_T[4] * R_rel_xx - base->R_T[3] * minus_R_rel_xy;
    const ella_real R_P_31 = base->R_T[6] * R_rel_xx + base->R_T[7] * minus_R_rel_xy;
    const ella_real R_P_32 = base->R_T[7] * R_rel_xx - base->R_T[6] * minus_R_rel_xy;
    const ella_real omega_R_1 = R_P_11 * base->omega[0] + R_P_21 * base->omega[1] + R_P_31 * base->omega[2];
    const ella_real omega_R_2 = R_P_12 * base->omega[0] + R_P_22 * base->omega[1] + R_P_32 * base->omega[2];
    const ella_real omega_R_3 = base->R_T[2] * base->omega[0] + base->R_T[5] * base->omega[1]
        + base->R_T[8] * base->omega[2];

    /* alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const ella_real omega_z = omega_R_3 + qdot[0];
    const ella_real alpha_0_3 = base->R_T[2] * base->alpha_0[0] + base->R_T[5] * base->alpha_0[1]
        + base->R_T[8] * base->alpha_0[2];
    const ella_real alpha_0_1 = R_P_11 * base->alpha_0[0] + R_P_21 * base->alpha_0[1] + R_P_31 * base->alpha_0[2]
        + omega_R_2 * qdot[0];
    const ella_real alpha_0_2 = R_P_12 * base->alpha_0[0] + R_P_22 * base->alpha_0[1] + R_P_32 * base->alpha_0[2]
        - omega_R_1 * qdot[0];
    const ella_real alpha_0_4 = R_P_11 * base->alpha_0[3] + R_P_21 * base->alpha_0[4] + R_P_31 * base->alpha_0[5];
    const ella_real alpha_0_5 = R_P_12 * base->alpha_0[3] + R_P_22 * base->alpha_0[4] + R_P_32 * base->alpha_0[5];
    const ella_real alpha_0_6 = base->R_T[2] * base->alpha_0[3] + base->R_T[5] * base->alpha_0[4]
        + base->R_T[8] * base->alpha_0[5];

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

    /* tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const ella_real t1 = omega_R_2 * r_T_z - omega_z * r_T_y + etadot[0] * REAL(2.8284271247461903);
    const ella_real t2 = omega_z * r_T_x - omega_R_1 * r_T_z + etadot[1] * 4;
    const ella_real t3 = omega_R_1 * r_T_y - omega_R_2 * r_T_x + etadot[2] * 4;
    const ella_real alpha_0_T_4 = alpha_0_4 + (alpha_0_2 * r_T_z - alpha_0_3 * r_T_y)
        + (omega_R_2 * t3 - omega_z * t2);
    const ella_real alpha_0_T_5 = alpha_0_5 + (alpha_0_3 * r_T_x - alpha_0_1 * r_T_z)
        + (omega_z * t1 - omega_R_1 * t3);
    const ella_real alpha_0_T_6 = alpha_0_6 + (alpha_0_1 * r_T_y - alpha_0_2 * r_T_x)
        + (omega_R_1 * t2 - omega_R_2 * t1);

    /* outputs */
    link->R_P[0] = R_P_11;
    link->R_P[1] = R_P_12;
    link->R_P[2] = base->R_T[2];
    link->R_P[3] = R_P_21;
    link->R_P[4] = R_P_22;
    link->R_P[5] = base->R_T[5];
    link->R_P[6] = R_P_31;
    link->R_P[7] = R_P_32;
    link->R_P[8] = base->R_T[8];
    link->omega[0] = omega_R_1;
    link->omega[1] = omega_R_2;
    link->omega[2] = omega_z;
    link->alpha_0[0] = alpha_0_1;
    link->alpha_0[1] = alpha_0_2;
    link->alpha_0[2] = alpha_0_3;
    link->alpha_0[3] = alpha_0_4;
    link->alpha_0[4] = alpha_0_5;
    link->alpha_0[5] = alpha_0_6;
    link->r_T[0] = r_T_x;
    link->r_T[1] = r_T_y;
    link->r_T[2] = r_T_z;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = minus_R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yy;
    link->R_T[4] = R_T_yz;
    link->R_T[5] = R_T_zz;
    link->J_l[1] = minus_J_l_xy;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yy;
    link->J_l[4] = J_l_yz;
    link->J_l[5] = J_l_zz;
    tip->alpha_0[3] = alpha_0_T_4;
    tip->alpha_0[4] = alpha_0_T_5;
    tip->alpha_0[5] = alpha_0_T_6;
    return ELLA_OK;
}

/* inverse outward, links like upper_arm: 31 operations */
ELLA_PART ella_status inverse_outward_upper_arm(const ella_link_constants *c, ella_link_store *link, ella_node *tip, const ella_real qddot[2],
    const ella_real etaddot[3])
{
    const ella_real delta_1 = link->A[0] * qddot[0];
    const ella_real delta_2 = link->A[1] * qddot[0];
    const ella_real t1 = c->Psi_c_y3 * etaddot[2];
    const ella_real t2 = c->Psi_c_z2 * etaddot[1];
    const ella_real delta_1_2 = delta_1 + (link->J_l[2] * t2 - link->J_l[1] * t1);
    const ella_real delta_2_2 = delta_2 + (link->J_l[3] * t1 + link->J_l[4] * t2);
    const ella_real delta_3 = qddot[1] + (link->J_l[4] * t1 + link->J_l[5] * t2);
    const ella_real delta_4 = delta_2 * link->r_T[2] - qddot[1] * link->r_T[1]
        + etaddot[0] * REAL(1.4142135623730951);
    const ella_real delta_5 = qddot[1] * link->r_T[0] - delta_1 * link->r_T[2] + etaddot[1] * 2;
    const ella_real delta_6 = delta_1 * link->r_T[1] - delta_2 * link->r_T[0] + etaddot[2] * 2;

    /* outputs */
    link->delta[0] = delta_1;
    link->delta[1] = delta_2;
    link->delta[2] = qddot[1];
    tip->delta[0] = delta_1_2;
    tip->delta[1] = delta_2_2;
    tip->delta[2] = delta_3;
    tip->delta[3] = delta_4;
    tip->delta[4] = delta_5;
    tip->delta[5] = delta_6;
    return ELLA_OK;
}

/* inverse outward, links like forearm: 49 operations */
ELLA_PART ella_status inverse_outward_forearm(ella_link_store *link, const ella_node *base, ella_node *tip, const ella_real qddot[1],
    const ella_real etaddot[3])
{
    const ella_real delta_1 = link->R_P[0] * base->delta[0] + link->R_P[3] * base->delta[1]
        + link->R_P[6] * base->delta[2];
    const ella_real delta_2 = link->R_P[1] * base->delta[0] + link->R_P[4] * base->delta[1]
        + link->R_P[7] * base->delta[2];
    const ella_real delta_4 = link->R_P[0] * base->delta[3] + link->R_P[3] * base->delta[4]
        + link->R_P[6] * base->delta[5];
    const ella_real delta_5 = link->R_P[1] * base->delta[3] + link->R_P[4] * base->delta[4]
        + link->R_P[7] * base->delta[5];
    const ella_real delta_6 = link->R_P[2] * base->delta[3] + link->R_P[5] * base->delta[4]
        + link->R_P[8] * base->delta[5];
    const ella_real delta_3 = link->R_P[2] * base->delta[0] + link->R_P[5] * base->delta[1]
        + link->R_P[8] * base->delta[2] + qddot[0];
    const ella_real delta_4_2 = delta_4 + (delta_2 * link->r_T[2] - delta_3 * link->r_T[1])
        + etaddot[0] * REAL(1.4142135623730951);
    const ella_real delta_5_2 = delta_5 + (delta_3 * link->r_T[0] - delta_1 * link->r_T[2]) + etaddot[1] * 2;
    const ella_real delta_6_2 = delta_6 + (delta_1 * link->r_T[1] - delta_2 * link->r_T[0]) + etaddot[2] * 2;

    /* outputs */
    link->delta[0] = delta_1;
    link->delta[1] = delta_2;
    link->delta[2] = delta_3;
    link->delta[3] = delta_4;
    link->delta[4] = delta_5;
    link->delta[5] = delta_6;
    tip->delta[3] = delta_4_2;
    tip->delta[4] = delta_5_2;
    tip->delta[5] = delta_6_2;
    return ELLA_OK;
}

/* inverse inward, links like upper_arm: 364 operations */
ELLA_PART ella_status inverse_inward_upper_arm(const ella_link_constants *c, const ella_link_store *link, const ella_node *tip,
    const ella_real etaddot[3], const ella_real eta[3], const ella_real etadot[3],
    const ella_real w_ext[6], const ella_real m_eta[3], const ella_real f_eta[3], ella_real force_eta[3],
    ella_real force[2], ella_real wrench[6])
{
    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->mu * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_z1 = c->Gamma_xy_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_x2 = c->Gamma_xy_11 * etadot[0];
    const ella_real Ldot_y1 = c->Gamma_xy_11 * etadot[1];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_z1 = c->Gamma_xy_11 * etadot[2];
    const ella_real Ldot_z2 = etadot[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_2 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z2 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const ella_real t1 = link->omega[1] * link->omega[1];
    const ella_real t2 = link->omega[2] * link->omega[2];
    const ella_real minus_Omega_xx = t1 + t2;
    const ella_real Omega_xy = link->omega[0] * link->omega[1];
    const ella_real t3 = link->omega[0] * link->omega[2];
    const ella_real Omega_xz = link->alpha_0[1] + t3;
    const ella_real t4 = link->omega[0] * link->omega[0];
    const ella_real minus_Omega_yy = t4 + t2;
    const ella_real t5 = link->omega[1] * link->omega[2];
    const ella_real Omega_yz = t5 - link->alpha_0[0];
    const ella_real Omega_zx = t3 - link->alpha_0[1];
    const ella_real Omega_zy = link->alpha_0[0] + t5;
    const ella_real minus_Omega_zz = t4 + t1;

    /* B: moment of the elastic velocity */
    const ella_real B_xx = L_x1 * etadot[0];
    const ella_real B_xy = L_y1 * etadot[0];
    const ella_real B_xz = L_z1 * etadot[0];
    const ella_real B_yx = L_x2 * etadot[1];
    const ella_real B_yy = L_y2 * etadot[1];
    const ella_real B_yz = L_z2 * etadot[1];
    const ella_real B_zx = L_x2 * etadot[2];
    const ella_real B_zy = L_y2 * etadot[2];
    const ella_real B_zz = L_z2 * etadot[2];

    /* h_c: half of the Coriolis wrench */
    const ella_real h_c_1 = B_yy * link->omega[0] + B_zz * link->omega[0] - B_xy * link->omega[1]
        - B_xz * link->omega[2];
    const ella_real h_c_2 = B_xx * link->omega[1] + B_zz * link->omega[1] - B_yx * link->omega[0]
        - B_yz * link->omega[2];
    const ella_real h_c_3 = B_xx * link->omega[2] + B_yy * link->omega[2] - B_zx * link->omega[0]
        - B_zy * link->omega[1];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t6 = h_c_1 + c->I_s * link->alpha_0[0] + J_xy * Omega_zx + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const ella_real H_star_1 = t6 + S_y * link->alpha_0[5] - J_xz * Omega_xy - J_zz * Omega_yz
        - S_z * link->alpha_0[4];
    const ella_real t7 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->alpha_0[3];
    const ella_real t8 = c->I_s * link->omega[0];
    const ella_real H_star_2 = t7 + t8 * link->omega[2] - J_xx * Omega_zx - J_xy * Omega_zy
        - S_x * link->alpha_0[5];
    const ella_real t9 = h_c_3 + J_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + S_x * link->alpha_0[4];
    const ella_real H_star_3 = t9 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->alpha_0[3]
        - t8 * link->omega[1];

    /* h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_1 = H_star_1 + h_c_1;
    const ella_real h_V_2 = H_star_2 + h_c_2;
    const ella_real h_V_3 = H_star_3 + h_c_3;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real t10 = L_y1 * Omega_xy - L_x1 * minus_Omega_xx + L_z1 * Omega_xz
        + link->alpha_0[3] * c->sigma_x1 + Ldot_z1 * 2 * link->omega[1];
    const ella_real h_eta_1 = t10 - Ldot_y1 * 2 * link->omega[2];
    const ella_real t11 = Ldot_x2 * 2;
    const ella_real t12 = L_x2 * Omega_xy - L_y2 * minus_Omega_yy + L_z2 * Omega_yz
        + link->alpha_0[4] * c->sigma_y2 + t11 * link->omega[2];
    const ella_real h_eta_2 = t12 - Ldot_z2 * 2 * link->omega[0];
    const ella_real t13 = L_x2 * Omega_zx + L_y2 * Omega_zy - L_z2 * minus_Omega_zz
        + link->alpha_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];
    const ella_real h_eta_3 = t13 - t11 * link->omega[1];

    const ella_real t14 = c->body0_mass * (tip->alpha_0[3] + tip->delta[3])
        - (link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const ella_real t15 = c->body0_mass * (tip->alpha_0[4] + tip->delta[4])
        - (link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5]);
    const ella_real t16 = c->body0_mass * (tip->alpha_0[5] + tip->delta[5])
        - (link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5]);
    const ella_real t17 = tip->p[0]
        - (link->R_T[0] * w_ext[0] - link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2]);
    const ella_real t18 = tip->p[1]
        - (link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1] + link->R_T[4] * w_ext[2]);
    const ella_real t19 = tip->p[2]
        - (link->R_T[4] * w_ext[1] - link->R_T[2] * w_ext[0] + link->R_T[5] * w_ext[2]);
    const ella_real t20 = t14 + tip->p[3];
    const ella_real t21 = t15 + tip->p[4];
    const ella_real t22 = t16 + tip->p[5];
    const ella_real t23 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2]
        + (L_y2 * etaddot[2] - L_z2 * etaddot[1]);
    const ella_real t24 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2]
        + (L_z1 * etaddot[0] - L_x2 * etaddot[2]);
    const ella_real t25 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        + (L_x2 * etaddot[1] - L_y1 * etaddot[0]);
    const ella_real wrench_1 = t23 + h_V_1 + (t17 + (link->r_T[1] * t22 - link->r_T[2] * t21));
    const ella_real wrench_2 = t24 + h_V_2 + (t18 + (link->r_T[2] * t20 - link->r_T[0] * t22));
    const ella_real force_2 = t25 + h_V_3 + (t19 + (link->r_T[0] * t21 - link->r_T[1] * t20));
    const ella_real t26 = L_x2 * link->delta[2] - L_z2 * link->delta[0] + m_eta[1] * etaddot[1] + h_eta_2
        + f_eta[1] + c->Psi_c_z2 * (link->J_l[2] * t17 + link->J_l[4] * t18 + link->J_l[5] * t19);
    const ella_real t27 = L_y2 * link->delta[0] - L_x2 * link->delta[1] + m_eta[2] * etaddot[2] + h_eta_3
        + f_eta[2] + c->Psi_c_y3 * (link->J_l[3] * t18 - link->J_l[1] * t17 + link->J_l[4] * t19);
    const ella_real force_eta_1 = L_z1 * link->delta[1] - L_y1 * link->delta[2] + m_eta[0] * etaddot[0] + h_eta_1
        + f_eta[0] + t20 * REAL(1.4142135623730951);
    const ella_real force_eta_2 = t26 + t21 * 2;
    const ella_real force_eta_3 = t27 + t22 * 2;
    const ella_real force_1 = link->A[0] * wrench_1 + link->A[1] * wrench_2;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force[0] = force_1;
    force[1] = force_2;

    if (wrench) {
        /* Sdot: rate of the first moment */
        const ella_real Sdot_x = etadot[0] * c->sigma_x1;
        const ella_real Sdot_y = etadot[1] * c->sigma_y2;
        const ella_real Sdot_z = etadot[2] * c->sigma_y2;

        /* h_c: half of the Coriolis wrench */
        const ella_real h_c_4 = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
        const ella_real h_c_5 = Sdot_x * link->omega[2] - Sdot_z * link->omega[0];
        const ella_real h_c_6 = Sdot_y * link->omega[0] - Sdot_x * link->omega[1];

        /* H_star: gyroscopic wrench and weight, angular acceleration included */
        const ella_real H_star_4 = h_c_4 - minus_Omega_xx * S_x + Omega_xy * S_y + Omega_xz * S_z
            + link->alpha_0[3] * c->mu;
        const ella_real H_star_5 = h_c_5 + Omega_xy * S_x - minus_Omega_yy * S_y + Omega_yz * S_z
            + link->alpha_0[4] * c->mu;
        const ella_real H_star_6 = h_c_6 + Omega_zx * S_x + Omega_zy * S_y - minus_Omega_zz * S_z
            + link->alpha_0[5] * c->mu;

        /* h_V: bias of the twist rows, angular acceleration included */
        const ella_real h_V_4 = H_star_4 + h_c_4;
        const ella_real h_V_5 = H_star_5 + h_c_5;
        const ella_real h_V_6 = H_star_6 + h_c_6;

        const ella_real wrench_4 = S_z * link->delta[1] - S_y * link->delta[2] + c->sigma_x1 * etaddot[0] + h_V_4
            + t20;
        const ella_real wrench_5 = S_x * link->delta[2] - S_z * link->delta[0] + c->sigma_y2 * etaddot[1] + h_V_5
            + t21;
        const ella_real wrench_6 = S_y * link->delta[0] - S_x * link->delta[1] + c->sigma_y2 * etaddot[2] + h_V_6
            + t22;

        /* outputs */
        wrench[0] = wrench_1;
        wrench[1] = wrench_2;
        wrench[2] = force_2;
        wrench[3] = wrench_4;
        wrench[4] = wrench_5;
        wrench[5] = wrench_6;
    }
    return ELLA_OK;
}

/* inverse inward, links like forearm: 411 operations */
ELLA_PART ella_status inverse_inward_forearm(const ella_link_constants *c, const ella_link_store *link, ella_node *base, const ella_node *tip,
    const ella_real etaddot[3], const ella_real eta[3], const ella_real etadot[3],
    const ella_real w_ext[6], const ella_real m_eta[3], const ella_real f_eta[3], ella_real force_eta[3],
    ella_real force[1], ella_real wrench[6])
{
    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_x = etadot[0] * c->sigma_x1;
    const ella_real Sdot_y = etadot[1] * c->sigma_y2;
    const ella_real Sdot_z = etadot[2] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->mu * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_z1 = c->Gamma_xy_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_x2 = c->Gamma_xy_11 * etadot[0];
    const ella_real Ldot_y1 = c->Gamma_xy_11 * etadot[1];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_z1 = c->Gamma_xy_11 * etadot[2];
    const ella_real Ldot_z2 = etadot[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_2 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z2 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const ella_real t1 = link->omega[1] * link->omega[1];
    const ella_real t2 = link->omega[2] * link->omega[2];
    const ella_real minus_Omega_xx = t1 + t2;
    const ella_real t3 = link->omega[0] * link->omega[1];
    const ella_real Omega_xy = t3 - link->alpha_0[2];
    const ella_real t4 = link->omega[0] * link->omega[2];
    const ella_real Omega_xz = link->alpha_0[1] + t4;
    const ella_real Omega_yx = link->alpha_0[2] + t3;
    const ella_real t5 = link->omega[0] * link->omega[0];
    const ella_real minus_Omega_yy = t5 + t2;
    const ella_real t6 = link->omega[1] * link->omega[2];
    const ella_real Omega_yz = t6 - link->alpha_0[0];
    const ella_real Omega_zx = t4 - link->alpha_0[1];
    const ella_real Omega_zy = link->alpha_0[0] + t6;
    const ella_real minus_Omega_zz = t5 + t1;

    /* B: moment of the elastic velocity */
    const ella_real B_xx = L_x1 * etadot[0];
    const ella_real B_xy = L_y1 * etadot[0];
    const ella_real B_xz = L_z1 * etadot[0];
    const ella_real B_yx = L_x2 * etadot[1];
    const ella_real B_yy = L_y2 * etadot[1];
    const ella_real B_yz = L_z2 * etadot[1];
    const ella_real B_zx = L_x2 * etadot[2];
    const ella_real B_zy = L_y2 * etadot[2];
    const ella_real B_zz = L_z2 * etadot[2];

    /* h_c: half of the Coriolis wrench */
    const ella_real h_c_1 = B_yy * link->omega[0] + B_zz * link->omega[0] - B_xy * link->omega[1]
        - B_xz * link->omega[2];
    const ella_real h_c_2 = B_xx * link->omega[1] + B_zz * link->omega[1] - B_yx * link->omega[0]
        - B_yz * link->omega[2];
    const ella_real h_c_3 = B_xx * link->omega[2] + B_yy * link->omega[2] - B_zx * link->omega[0]
        - B_zy * link->omega[1];
    const ella_real h_c_4 = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
    const ella_real h_c_5 = Sdot_x * link->omega[2] - Sdot_z * link->omega[0];
    const ella_real h_c_6 = Sdot_y * link->omega[0] - Sdot_x * link->omega[1];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t7 = h_c_1 + c->I_s * link->alpha_0[0] + J_xy * Omega_zx + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const ella_real H_star_1 = t7 + S_y * link->alpha_0[5] - J_xz * Omega_yx - J_zz * Omega_yz
        - S_z * link->alpha_0[4];
    const ella_real t8 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->alpha_0[3];
    const ella_real t9 = c->I_s * link->omega[0];
    const ella_real H_star_2 = t8 + t9 * link->omega[2] - J_xx * Omega_zx - J_xy * Omega_zy
        - S_x * link->alpha_0[5];
    const ella_real t10 = h_c_3 + J_xx * Omega_yx + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + S_x * link->alpha_0[4];
    const ella_real H_star_3 = t10 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->alpha_0[3]
        - t9 * link->omega[1];
    const ella_real H_star_4 = h_c_4 - minus_Omega_xx * S_x + Omega_xy * S_y + Omega_xz * S_z
        + link->alpha_0[3] * c->mu;
    const ella_real H_star_5 = h_c_5 + Omega_yx * S_x - minus_Omega_yy * S_y + Omega_yz * S_z
        + link->alpha_0[4] * c->mu;
    const ella_real H_star_6 = h_c_6 + Omega_zx * S_x + Omega_zy * S_y - minus_Omega_zz * S_z
        + link->alpha_0[5] * c->mu;

    /* h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_1 = H_star_1 + h_c_1;
    const ella_real h_V_2 = H_star_2 + h_c_2;
    const ella_real h_V_3 = H_star_3 + h_c_3;
    const ella_real h_V_4 = H_star_4 + h_c_4;
    const ella_real h_V_5 = H_star_5 + h_c_5;
    const ella_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real t11 = L_y1 * Omega_xy - L_x1 * minus_Omega_xx + L_z1 * Omega_xz
        + link->alpha_0[3] * c->sigma_x1 + Ldot_z1 * 2 * link->omega[1];
    const ella_real h_eta_1 = t11 - Ldot_y1 * 2 * link->omega[2];
    const ella_real t12 = Ldot_x2 * 2;
    const ella_real t13 = L_x2 * Omega_yx - L_y2 * minus_Omega_yy + L_z2 * Omega_yz
        + link->alpha_0[4] * c->sigma_y2 + t12 * link->omega[2];
    const ella_real h_eta_2 = t13 - Ldot_z2 * 2 * link->omega[0];
    const ella_real t14 = L_x2 * Omega_zx + L_y2 * Omega_zy - L_z2 * minus_Omega_zz
        + link->alpha_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];
    const ella_real h_eta_3 = t14 - t12 * link->omega[1];

    const ella_real t15 = link->R_T[0] * w_ext[0] - link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2];
    const ella_real t16 = link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1] + link->R_T[4] * w_ext[2];
    const ella_real t17 = link->R_T[4] * w_ext[1] - link->R_T[2] * w_ext[0] + link->R_T[5] * w_ext[2];
    const ella_real t18 = c->body0_mass * (tip->alpha_0[3] + tip->delta[3])
        - (link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const ella_real t19 = c->body0_mass * (tip->alpha_0[4] + tip->delta[4])
        - (link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5]);
    const ella_real t20 = c->body0_mass * (tip->alpha_0[5] + tip->delta[5])
        - (link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5]);
    const ella_real t21 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2]
        - S_z * link->delta[4] + S_y * link->delta[5];
    const ella_real t22 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2]
        + S_z * link->delta[3] - S_x * link->delta[5];
    const ella_real t23 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        - S_y * link->delta[3] + S_x * link->delta[4];
    const ella_real t24 = S_z * link->delta[1] - S_y * link->delta[2] + c->mu * link->delta[3]
        + c->sigma_x1 * etaddot[0] + h_V_4;
    const ella_real t25 = S_x * link->delta[2] - S_z * link->delta[0] + c->mu * link->delta[4]
        + c->sigma_y2 * etaddot[1] + h_V_5;
    const ella_real t26 = S_y * link->delta[0] - S_x * link->delta[1] + c->mu * link->delta[5]
        + c->sigma_y2 * etaddot[2] + h_V_6;
    const ella_real wrench_1 = t21 + (L_y2 * etaddot[2] - L_z2 * etaddot[1]) + h_V_1
        + (link->r_T[1] * t20 - link->r_T[2] * t19 - t15);
    const ella_real wrench_2 = t22 + (L_z1 * etaddot[0] - L_x2 * etaddot[2]) + h_V_2
        + (link->r_T[2] * t18 - link->r_T[0] * t20 - t16);
    const ella_real force_1 = t23 + (L_x2 * etaddot[1] - L_y1 * etaddot[0]) + h_V_3
        + (link->r_T[0] * t19 - link->r_T[1] * t18 - t17);
    const ella_real wrench_4 = t24 + t18;
    const ella_real wrench_5 = t25 + t19;
    const ella_real wrench_6 = t26 + t20;
    const ella_real t27 = L_z1 * link->delta[1] - L_y1 * link->delta[2] + c->sigma_x1 * link->delta[3]
        + m_eta[0] * etaddot[0];
    const ella_real t28 = L_x2 * link->delta[2] - L_z2 * link->delta[0] + c->sigma_y2 * link->delta[4]
        + m_eta[1] * etaddot[1];
    const ella_real t29 = L_y2 * link->delta[0] - L_x2 * link->delta[1] + c->sigma_y2 * link->delta[5]
        + m_eta[2] * etaddot[2];
    const ella_real t30 = t28 + h_eta_2 + f_eta[1]
        - c->Psi_c_z2 * (link->J_l[2] * t15 + link->J_l[4] * t16 + link->J_l[5] * t17);
    const ella_real t31 = t29 + h_eta_3 + f_eta[2]
        + c->Psi_c_y3 * (link->J_l[1] * t15 - link->J_l[3] * t16 - link->J_l[4] * t17);
    const ella_real force_eta_1 = t27 + h_eta_1 + f_eta[0] + t18 * REAL(1.4142135623730951);
    const ella_real force_eta_2 = t30 + t19 * 2;
    const ella_real force_eta_3 = t31 + t20 * 2;
    const ella_real p_1 = link->R_P[0] * wrench_1 + link->R_P[1] * wrench_2 + link->R_P[2] * force_1;
    const ella_real p_2 = link->R_P[3] * wrench_1 + link->R_P[4] * wrench_2 + link->R_P[5] * force_1;
    const ella_real p_3 = link->R_P[6] * wrench_1 + link->R_P[7] * wrench_2 + link->R_P[8] * force_1;
    const ella_real p_4 = link->R_P[0] * wrench_4 + link->R_P[1] * wrench_5 + link->R_P[2] * wrench_6;
    const ella_real p_5 = link->R_P[3] * wrench_4 + link->R_P[4] * wrench_5 + link->R_P[5] * wrench_6;
    const ella_real p_6 = link->R_P[6] * wrench_4 + link->R_P[7] * wrench_5 + link->R_P[8] * wrench_6;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force[0] = force_1;
    base->p[0] = p_1;
    base->p[1] = p_2;
    base->p[2] = p_3;
    base->p[3] = p_4;
    base->p[4] = p_5;
    base->p[5] = p_6;

    if (wrench) {
        /* outputs */
        wrench[0] = wrench_1;
        wrench[1] = wrench_2;
        wrench[2] = force_1;
        wrench[3] = wrench_4;
        wrench[4] = wrench_5;
        wrench[5] = wrench_6;
    }
    return ELLA_OK;
}

/* kinematics, links like upper_arm: 38 operations */
ELLA_PART ella_status kinematics_upper_arm_2(const ella_link_constants *c, ella_link_store *link, ella_node *tip, const ella_real q[2],
    const ella_real eta[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[1]);
    const ella_real R_rel_yx = turn.sine, R_rel_yy = turn.cosine;

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

    /* J_l: left Jacobian of the exponential */
    const ella_real minus_J_l_xy = c2 * theta_z;
    const ella_real J_l_xz = c2 * theta_y;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const ella_real J_l_yz = c3 * theta_hat2_23;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * x;
    const ella_real minus_R_T_xy = c1 * theta_z;
    const ella_real t1 = -minus_R_T_xy;
    const ella_real R_T_xz = c1 * theta_y;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real R_T_yz = c2 * theta_hat2_23;
    const ella_real t2 = -R_T_xz;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* outputs */
    link->A[0] = R_rel_yx;
    link->A[1] = R_rel_yy;
    link->r_T[0] = r_T_x;
    link->r_T[1] = r_T_y;
    link->r_T[2] = r_T_z;
    link->J_l[1] = minus_J_l_xy;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yy;
    link->J_l[4] = J_l_yz;
    link->J_l[5] = J_l_zz;
    tip->R_T[0] = R_T_xx;
    tip->R_T[1] = t1;
    tip->R_T[2] = R_T_xz;
    tip->R_T[3] = minus_R_T_xy;
    tip->R_T[4] = R_T_yy;
    tip->R_T[5] = R_T_yz;
    tip->R_T[6] = t2;
    tip->R_T[7] = R_T_yz;
    tip->R_T[8] = R_T_zz;
    return ELLA_OK;
}

/* kinematics, links like forearm: 24 operations */
ELLA_PART ella_status kinematics_forearm_2(const ella_link_constants *c, ella_link_store *link, const ella_node *base, const ella_real q[1],
    const ella_real eta[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real minus_R_rel_xy = turn.sine, R_rel_xx = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const ella_real R_P_11 = base->R_T[0] * R_rel_xx + base->R_T[1] * minus_R_rel_xy;
    const ella_real R_P_12 = base->R_T[1] * R_rel_xx - base->R_T[0] * minus_R_rel_xy;
    const ella_real R_P_21 = base->R_T[3] * R_rel_xx + base->R_T[4] * minus_R_rel_xy;
    const ella_real R_P_22 = base->R_T[4] * R_rel_xx - base->R_T[3] * minus_R_rel_xy;
    const ella_real R_P_31 = base->R_T[6] * R_rel_xx + base->R_T[7] * minus_R_rel_xy;
    const ella_real R_P_32 = base->R_T[7] * R_rel_xx - base->R_T[6] * minus_R_rel_xy;

    /* r_T: tip point (11) */
    const ella_real r_T_x = c->length + eta[0] * REAL(1.4142135623730951);
    const ella_real r_T_y = eta[1] * 2;
    const ella_real r_T_z = eta[2] * 2;

    /* outputs */
    link->R_P[0] = R_P_11;
    link->R_P[1] = R_P_12;
    link->R_P[2] = base->R_T[2];
    link->R_P[3] = R_P_21;
    link->R_P[4] = R_P_22;
    link->R_P[5] = base->R_T[5];
    link->R_P[6] = R_P_31;
    link->R_P[7] = R_P_32;
    link->R_P[8] = base->R_T[8];
    link->r_T[0] = r_T_x;
    link->r_T[1] = r_T_y;
    link->r_T[2] = r_T_z;
    return ELLA_OK;
}

/* inverse inward, links like upper_arm: 111 operations */
ELLA_PART ella_status inverse_inward_upper_arm_2(const ella_link_constants *c, const ella_link_store *link, const ella_node *tip,
    const ella_real etaddot[3], const ella_real eta[3], const ella_real m_eta[3], ella_real force_eta[3],
    ella_real force[2])
{
    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->mu * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_z1 = c->Gamma_xy_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_2 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z2 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    const ella_real t1 = c->body0_mass * tip->delta[3] + tip->p[3];
    const ella_real t2 = c->body0_mass * tip->delta[4] + tip->p[4];
    const ella_real t3 = c->body0_mass * tip->delta[5] + tip->p[5];
    const ella_real t4 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2]
        + (L_y2 * etaddot[2] - L_z2 * etaddot[1]);
    const ella_real t5 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2]
        + (L_z1 * etaddot[0] - L_x2 * etaddot[2]);
    const ella_real t6 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        + (L_x2 * etaddot[1] - L_y1 * etaddot[0]);
    const ella_real wrench_1 = t4 + (tip->p[0] + (link->r_T[1] * t3 - link->r_T[2] * t2));
    const ella_real wrench_2 = t5 + (tip->p[1] + (link->r_T[2] * t1 - link->r_T[0] * t3));
    const ella_real force_2 = t6 + (tip->p[2] + (link->r_T[0] * t2 - link->r_T[1] * t1));
    const ella_real t7 = L_x2 * link->delta[2] - L_z2 * link->delta[0] + m_eta[1] * etaddot[1]
        + c->Psi_c_z2 * (link->J_l[2] * tip->p[0] + link->J_l[4] * tip->p[1] + link->J_l[5] * tip->p[2]);
    const ella_real t8 = L_y2 * link->delta[0] - L_x2 * link->delta[1] + m_eta[2] * etaddot[2]
        + c->Psi_c_y3 * (link->J_l[3] * tip->p[1] - link->J_l[1] * tip->p[0] + link->J_l[4] * tip->p[2]);
    const ella_real force_eta_1 = L_z1 * link->delta[1] - L_y1 * link->delta[2] + m_eta[0] * etaddot[0]
        + t1 * REAL(1.4142135623730951);
    const ella_real force_eta_2 = t7 + t2 * 2;
    const ella_real force_eta_3 = t8 + t3 * 2;
    const ella_real force_1 = link->A[0] * wrench_1 + link->A[1] * wrench_2;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force[0] = force_1;
    force[1] = force_2;
    return ELLA_OK;
}

/* inverse inward, links like forearm: 164 operations */
ELLA_PART ella_status inverse_inward_forearm_2(const ella_link_constants *c, const ella_link_store *link, ella_node *base, const ella_node *tip,
    const ella_real etaddot[3], const ella_real eta[3], const ella_real m_eta[3], ella_real force_eta[3],
    ella_real force[1])
{
    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->mu * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_z1 = c->Gamma_xy_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_2 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z2 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    const ella_real t1 = c->body0_mass * tip->delta[3];
    const ella_real t2 = c->body0_mass * tip->delta[4];
    const ella_real t3 = c->body0_mass * tip->delta[5];
    const ella_real t4 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2]
        - S_z * link->delta[4] + S_y * link->delta[5];
    const ella_real t5 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2]
        + S_z * link->delta[3] - S_x * link->delta[5];
    const ella_real t6 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        - S_y * link->delta[3] + S_x * link->delta[4];
    const ella_real wrench_1 = t4 + (L_y2 * etaddot[2] - L_z2 * etaddot[1])
        + (link->r_T[1] * t3 - link->r_T[2] * t2);
    const ella_real wrench_2 = t5 + (L_z1 * etaddot[0] - L_x2 * etaddot[2])
        + (link->r_T[2] * t1 - link->r_T[0] * t3);
    const ella_real force_1 = t6 + (L_x2 * etaddot[1] - L_y1 * etaddot[0])
        + (link->r_T[0] * t2 - link->r_T[1] * t1);
    const ella_real wrench_4 = S_z * link->delta[1] - S_y * link->delta[2] + c->mu * link->delta[3]
        + c->sigma_x1 * etaddot[0] + t1;
    const ella_real wrench_5 = S_x * link->delta[2] - S_z * link->delta[0] + c->mu * link->delta[4]
        + c->sigma_y2 * etaddot[1] + t2;
    const ella_real wrench_6 = S_y * link->delta[0] - S_x * link->delta[1] + c->mu * link->delta[5]
        + c->sigma_y2 * etaddot[2] + t3;
    const ella_real t7 = L_z1 * link->delta[1] - L_y1 * link->delta[2] + c->sigma_x1 * link->delta[3]
        + m_eta[0] * etaddot[0];
    const ella_real t8 = L_x2 * link->delta[2] - L_z2 * link->delta[0] + c->sigma_y2 * link->delta[4]
        + m_eta[1] * etaddot[1];
    const ella_real t9 = L_y2 * link->delta[0] - L_x2 * link->delta[1] + c->sigma_y2 * link->delta[5]
        + m_eta[2] * etaddot[2];
    const ella_real force_eta_1 = t7 + t1 * REAL(1.4142135623730951);
    const ella_real force_eta_2 = t8 + t2 * 2;
    const ella_real force_eta_3 = t9 + t3 * 2;
    const ella_real p_1 = link->R_P[0] * wrench_1 + link->R_P[1] * wrench_2 + link->R_P[2] * force_1;
    const ella_real p_2 = link->R_P[3] * wrench_1 + link->R_P[4] * wrench_2 + link->R_P[5] * force_1;
    const ella_real p_3 = link->R_P[6] * wrench_1 + link->R_P[7] * wrench_2 + link->R_P[8] * force_1;
    const ella_real p_4 = link->R_P[0] * wrench_4 + link->R_P[1] * wrench_5 + link->R_P[2] * wrench_6;
    const ella_real p_5 = link->R_P[3] * wrench_4 + link->R_P[4] * wrench_5 + link->R_P[5] * wrench_6;
    const ella_real p_6 = link->R_P[6] * wrench_4 + link->R_P[7] * wrench_5 + link->R_P[8] * wrench_6;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force[0] = force_1;
    base->p[0] = p_1;
    base->p[1] = p_2;
    base->p[2] = p_3;
    base->p[3] = p_4;
    base->p[4] = p_5;
    base->p[5] = p_6;
    return ELLA_OK;
}

/* joint rows, links like upper_arm: 508 operations */
ELLA_PART ella_status joint_rows_upper_arm(const ella_link_constants *c, ella_link_store *link, ella_node *tip, const ella_real twist[6],
    const ella_real q[2], const ella_real quaternion[4], const ella_real gravity[3],
    const ella_real eta[3], const ella_real etadot[3], const ella_real tau[2], const int *place,
    ella_real *M, ella_real H[12], ella_real W[12])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[1]);
    const ella_real R_rel_yx = turn.sine, R_rel_yy = turn.cosine;

    const ella_real t1 = R_rel_yx * R_rel_yx + R_rel_yy * R_rel_yy;
    if (!(t1 - ELLA_REAL_EPSILON * 64 > 0)) { return ELLA_SINGULAR; }
    const ella_real t2 = 1 / t1;
    const ella_real t3 = R_rel_yx * t2;
    const ella_real t4 = R_rel_yy * t2;
    const ella_real t5 = t3 * twist[0] + t4 * twist[1];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real t6 = t5 * twist[2];
    const ella_real beta_omega_x = t6 * R_rel_yy;
    const ella_real minus_beta_omega_y = t6 * R_rel_yx;

    const ella_real t7 = quaternion[1] * quaternion[1];
    const ella_real t8 = quaternion[2] * quaternion[2];
    const ella_real t9 = quaternion[3] * quaternion[3];
    const ella_real t10 = 2 / (quaternion[0] * quaternion[0] + t7 + t8 + t9);
    const ella_real t11 = t7 + t8 + t9;
    const ella_real t12 = quaternion[1] * quaternion[2];
    const ella_real t13 = quaternion[1] * quaternion[3];
    const ella_real t14 = quaternion[2] * quaternion[3];
    const ella_real t15 = quaternion[0] * quaternion[3];
    const ella_real t16 = quaternion[0] * quaternion[2];
    const ella_real t17 = quaternion[0] * quaternion[1];
    const ella_real t18 = (1 + t10 * (t7 - t11)) * gravity[0] + t10 * (t15 + t12) * gravity[1]
        + t10 * (t13 - t16) * gravity[2];
    const ella_real t19 = t10 * (t12 - t15) * gravity[0] + (1 + t10 * (t8 - t11)) * gravity[1]
        + t10 * (t17 + t14) * gravity[2];
    const ella_real t20 = t10 * (t16 + t13) * gravity[0] + t10 * (t14 - t17) * gravity[1]
        + (1 + t10 * (t9 - t11)) * gravity[2];

    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_x = etadot[0] * c->sigma_x1;
    const ella_real Sdot_y = etadot[1] * c->sigma_y2;
    const ella_real Sdot_z = etadot[2] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->mu * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_z1 = c->Gamma_xy_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_x2 = c->Gamma_xy_11 * etadot[0];
    const ella_real Ldot_y1 = c->Gamma_xy_11 * etadot[1];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_z1 = c->Gamma_xy_11 * etadot[2];
    const ella_real Ldot_z2 = etadot[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_2 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z2 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const ella_real a_0_x = twist[1] * twist[5] - t18 - twist[2] * twist[4];
    const ella_real a_0_y = twist[2] * twist[3] - t19 - twist[0] * twist[5];
    const ella_real a_0_z = twist[0] * twist[4] - t20 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const ella_real t21 = twist[1] * twist[1];
    const ella_real t22 = twist[2] * twist[2];
    const ella_real minus_Omega_xx = t21 + t22;
    const ella_real Omega_xy = twist[0] * twist[1];
    const ella_real Omega_xz = twist[0] * twist[2];
    const ella_real t23 = twist[0] * twist[0];
    const ella_real minus_Omega_yy = t23 + t22;
    const ella_real Omega_yz = twist[1] * twist[2];
    const ella_real minus_Omega_zz = t23 + t21;

    /* B: moment of the elastic velocity */
    const ella_real B_xx = L_x1 * etadot[0];
    const ella_real B_xy = L_y1 * etadot[0];
    const ella_real B_xz = L_z1 * etadot[0];
    const ella_real B_yx = L_x2 * etadot[1];
    const ella_real B_yy = L_y2 * etadot[1];
    const ella_real B_yz = L_z2 * etadot[1];
    const ella_real B_zx = L_x2 * etadot[2];
    const ella_real B_zy = L_y2 * etadot[2];
    const ella_real B_zz = L_z2 * etadot[2];

    /* h_c: half of the Coriolis wrench */
    const ella_real h_c_1 = B_yy * twist[0] + B_zz * twist[0] - B_xy * twist[1] - B_xz * twist[2];
    const ella_real h_c_2 = B_xx * twist[1] + B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const ella_real h_c_3 = B_xx * twist[2] + B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const ella_real h_c_4 = Sdot_z * twist[1] - Sdot_y * twist[2];
    const ella_real h_c_5 = Sdot_x * twist[2] - Sdot_z * twist[0];
    const ella_real h_c_6 = Sdot_y * twist[0] - Sdot_x * twist[1];

    /* H_star: gyroscopic wrench and weight (29) */
    const ella_real t24 = h_c_1 + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const ella_real H_star_1 = t24 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const ella_real t25 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const ella_real t26 = c->I_s * twist[0];
    const ella_real H_star_2 = t25 + t26 * twist[2] - J_xx * Omega_xz - J_xy * Omega_yz - S_x * a_0_z;
    const ella_real t27 = h_c_3 + J_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + S_x * a_0_y;
    const ella_real H_star_3 = t27 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t26 * twist[1];
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
    const ella_real t28 = L_y1 * Omega_xy - L_x1 * minus_Omega_xx + L_z1 * Omega_xz + a_0_x * c->sigma_x1
        + Ldot_z1 * 2 * twist[1];
    const ella_real h_eta_1 = t28 - Ldot_y1 * 2 * twist[2];
    const ella_real t29 = Ldot_x2 * 2;
    const ella_real h_eta_2 = L_x2 * Omega_xy - L_y2 * minus_Omega_yy + L_z2 * Omega_yz + a_0_y * c->sigma_y2
        + t29 * twist[2] - Ldot_z2 * 2 * twist[0];
    const ella_real t30 = L_x2 * Omega_xz + L_y2 * Omega_yz - L_z2 * minus_Omega_zz + a_0_z * c->sigma_y2
        + Ldot_y2 * 2 * twist[0];
    const ella_real h_eta_3 = t30 - t29 * twist[1];

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
    const ella_real t31 = ella_c5(x);
    const ella_real c3 = REAL(0.16666666666666666) - x * t31;
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real t32 = ella_c4(x);
    const ella_real c2 = REAL(0.5) - x * t32;

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
    const ella_real t33 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t33;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t33;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t33;

    /* xdot: rate of the squared angle */
    const ella_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const ella_real c2dot = xdot * (t32 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const ella_real c3dot = xdot * (t31 * REAL(1.5) - t32 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_x = c2dot * t33;
    const ella_real alpha_s_y = c3 * thetadot_z * t33 + c3dot * theta_z * t33;
    const ella_real minus_alpha_s_z = c3 * thetadot_y * t33 + c3dot * theta_y * t33;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t34 = omega_s_x + twist[0];
    const ella_real t35 = omega_s_y + twist[1];
    const ella_real t36 = omega_s_z + twist[2];
    const ella_real omega_T_x = R_T_xx * t34 + minus_R_T_xy * t35 - R_T_xz * t36;
    const ella_real omega_T_y = R_T_yy * t35 - minus_R_T_xy * t34 + R_T_yz * t36;
    const ella_real omega_T_z = R_T_xz * t34 + R_T_yz * t35 + R_T_zz * t36;

    /* v_T: velocity of the tip point (46) */
    const ella_real t37 = udot_T_x + twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const ella_real t38 = udot_T_y + twist[4] + twist[2] * r_T_x - twist[0] * r_T_z;
    const ella_real t39 = udot_T_z + twist[5] + twist[0] * r_T_y - twist[1] * r_T_x;
    const ella_real v_T_x = R_T_xx * t37 + minus_R_T_xy * t38 - R_T_xz * t39;
    const ella_real v_T_y = R_T_yy * t38 - minus_R_T_xy * t37 + R_T_yz * t39;
    const ella_real v_T_z = R_T_xz * t37 + R_T_yz * t38 + R_T_zz * t39;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const ella_real t40 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const ella_real t41 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const ella_real t42 = omega_s_y * twist[0] - minus_alpha_s_z - omega_s_x * twist[1];
    const ella_real b_omega_x = R_T_xx * t40 + minus_R_T_xy * t41 - R_T_xz * t42;
    const ella_real b_omega_y = R_T_yy * t41 - minus_R_T_xy * t40 + R_T_yz * t42;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const ella_real t43 = omega_s_z * t38 + twist[1] * udot_T_z - omega_s_y * t39 - twist[2] * udot_T_y;
    const ella_real t44 = omega_s_x * t39 + twist[2] * udot_T_x - omega_s_z * t37 - twist[0] * udot_T_z;
    const ella_real t45 = omega_s_y * t37 + twist[0] * udot_T_y - omega_s_x * t38 - twist[1] * udot_T_x;
    const ella_real b_v_x = R_T_xx * t43 + minus_R_T_xy * t44 - R_T_xz * t45;
    const ella_real b_v_y = R_T_yy * t44 - minus_R_T_xy * t43 + R_T_yz * t45;
    const ella_real b_v_z = R_T_xz * t43 + R_T_yz * t44 + R_T_zz * t45;

    const ella_real t46 = R_T_xx * t18 + minus_R_T_xy * t19 - R_T_xz * t20;
    const ella_real t47 = R_T_yy * t19 - minus_R_T_xy * t18 + R_T_yz * t20;
    const ella_real t48 = R_T_xz * t18 + R_T_yz * t19 + R_T_zz * t20;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const ella_real a_T_x = omega_T_y * v_T_z - t46 - omega_T_z * v_T_y;
    const ella_real a_T_y = omega_T_z * v_T_x - t47 - omega_T_x * v_T_z;
    const ella_real a_T_z = omega_T_x * v_T_y - t48 - omega_T_y * v_T_x;

    /* h_T_F: force that the bodies' velocities and weight need */
    const ella_real h_T_F_x = a_T_x * c->body0_mass;
    const ella_real h_T_F_y = a_T_y * c->body0_mass;
    const ella_real h_T_F_z = a_T_z * c->body0_mass;

    /* N: projector onto the joint's axes */
    const ella_real N_xx = t3 * R_rel_yx;
    const ella_real N_xy = t4 * R_rel_yx;
    const ella_real N_yx = t3 * R_rel_yy;
    const ella_real N_yy = t4 * R_rel_yy;

    /* P_c: P with the rotor inertias about the axes (43) */
    const ella_real P_c_11 = 1 - N_xx;
    const ella_real P_c_22 = 1 - N_yy;

    /* joint_H: what the velocities, springs and dampers leave in the joint's rows (61) */
    const ella_real minus_joint_H_1 = N_xy * minus_beta_omega_y + P_c_11 * beta_omega_x;
    const ella_real t49 = -minus_joint_H_1;
    const ella_real joint_H_2 = N_yx * beta_omega_x + P_c_22 * minus_beta_omega_y;

    /* joint_W: the motors' torques in the joint's rows (62) */
    const ella_real joint_W_1 = t3 * tau[0];
    const ella_real joint_W_2 = t4 * tau[0];

    const ella_real t50 = -N_xy;
    const ella_real t51 = -N_yx;

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
    link->M_D[1] = L_y2;
    link->M_D[2] = L_z1;
    link->M_D[3] = L_x2;
    link->M_D[4] = L_y1;
    link->h_V[0] = h_V_1;
    link->h_V[1] = h_V_2;
    link->h_V[2] = h_V_3;
    link->h_V[3] = h_V_4;
    link->h_V[4] = h_V_5;
    link->h_V[5] = h_V_6;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
    link->h_eta[2] = h_eta_3;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = minus_R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yy;
    link->R_T[4] = R_T_yz;
    link->R_T[5] = R_T_zz;
    link->J_l[1] = minus_J_l_xy;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yy;
    link->J_l[4] = J_l_yz;
    link->J_l[5] = J_l_zz;
    link->r_T[0] = r_T_x;
    link->r_T[1] = r_T_y;
    link->r_T[2] = r_T_z;
    link->b_T[3] = b_v_x;
    link->b_T[4] = b_v_y;
    link->b_T[5] = b_v_z;
    tip->omega[0] = omega_T_x;
    tip->omega[1] = omega_T_y;
    tip->omega[2] = omega_T_z;
    tip->v[0] = v_T_x;
    tip->v[1] = v_T_y;
    link->h_T[0] = h_T_F_x;
    link->h_T[1] = h_T_F_y;
    link->h_T[2] = h_T_F_z;
    M[place[0]] = N_xx;
    M[place[1]] = N_xy;
    M[place[2]] = N_yx;
    M[place[3]] = N_yy;
    M[place[4]] = 1;
    M[place[5]] = P_c_11;
    M[place[6]] = t50;
    M[place[7]] = t51;
    M[place[8]] = P_c_22;
    M[place[9]] = 1;
    M[place[10]] = 1;
    M[place[11]] = 1;
    H[0] = t49;
    H[1] = joint_H_2;
    H[2] = 0;
    H[3] = 0;
    H[4] = 0;
    H[5] = 0;
    W[0] = joint_W_1;
    W[1] = joint_W_2;
    W[2] = tau[1];
    W[3] = 0;
    W[4] = 0;
    W[5] = 0;
    tip->b[0] = b_omega_x;
    tip->b[1] = b_omega_y;
    tip->b[3] = b_v_x;
    tip->b[4] = b_v_y;
    tip->b[5] = b_v_z;
    return ELLA_OK;
}

/* joint rows, links like forearm: 469 operations */
ELLA_PART ella_status joint_rows_forearm(const ella_link_constants *c, ella_link_store *link, ella_node *base, const ella_real twist[6],
    const ella_real q[1], const ella_real quaternion[4], const ella_real gravity[3],
    const ella_real eta[3], const ella_real etadot[3], const ella_real tau[1], const int *place,
    ella_real *M, ella_real H[12], ella_real W[12])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real minus_R_rel_xy = turn.sine, R_rel_xx = turn.cosine;
    const ella_real t1 = -minus_R_rel_xy;

    const ella_real omega_R_x = R_rel_xx * base->omega[0] + minus_R_rel_xy * base->omega[1];
    const ella_real omega_R_y = R_rel_xx * base->omega[1] - minus_R_rel_xy * base->omega[0];
    const ella_real t2 = twist[2] - base->omega[2];

    /* v_R: velocity of the joint point */
    const ella_real v_R_x = R_rel_xx * base->v[0] + minus_R_rel_xy * base->v[1];
    const ella_real v_R_y = R_rel_xx * base->v[1] - minus_R_rel_xy * base->v[0];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real beta_omega_x = omega_R_y * t2;
    const ella_real minus_beta_omega_y = omega_R_x * t2;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const ella_real beta_v_x = t2 * v_R_y;
    const ella_real minus_beta_v_y = t2 * v_R_x;

    const ella_real t3 = quaternion[1] * quaternion[1];
    const ella_real t4 = quaternion[2] * quaternion[2];
    const ella_real t5 = quaternion[3] * quaternion[3];
    const ella_real t6 = 2 / (quaternion[0] * quaternion[0] + t3 + t4 + t5);
    const ella_real t7 = t3 + t4 + t5;
    const ella_real t8 = quaternion[1] * quaternion[2];
    const ella_real t9 = quaternion[1] * quaternion[3];
    const ella_real t10 = quaternion[2] * quaternion[3];
    const ella_real t11 = quaternion[0] * quaternion[3];
    const ella_real t12 = quaternion[0] * quaternion[2];
    const ella_real t13 = quaternion[0] * quaternion[1];
    const ella_real t14 = (1 + t6 * (t3 - t7)) * gravity[0] + t6 * (t11 + t8) * gravity[1]
        + t6 * (t9 - t12) * gravity[2];
    const ella_real t15 = t6 * (t8 - t11) * gravity[0] + (1 + t6 * (t4 - t7)) * gravity[1]
        + t6 * (t13 + t10) * gravity[2];
    const ella_real t16 = t6 * (t12 + t9) * gravity[0] + t6 * (t10 - t13) * gravity[1]
        + (1 + t6 * (t5 - t7)) * gravity[2];

    /* S: first moment */
    const ella_real S_x = c->S_0_x + eta[0] * c->sigma_x1;
    const ella_real S_y = eta[1] * c->sigma_y2;
    const ella_real S_z = eta[2] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_x = etadot[0] * c->sigma_x1;
    const ella_real Sdot_y = etadot[1] * c->sigma_y2;
    const ella_real Sdot_z = etadot[2] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_x1 = c->chi_1 + c->mu * eta[0];
    const ella_real L_x2 = c->chi_2 + c->Gamma_xy_11 * eta[0];
    const ella_real L_y1 = c->Gamma_xy_11 * eta[1];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_z1 = c->Gamma_xy_11 * eta[2];
    const ella_real L_z2 = eta[2] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_x2 = c->Gamma_xy_11 * etadot[0];
    const ella_real Ldot_y1 = c->Gamma_xy_11 * etadot[1];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_z1 = c->Gamma_xy_11 * etadot[2];
    const ella_real Ldot_z2 = etadot[2] * c->mu;

    /* J: second moment */
    const ella_real J_xx = c->J_0_xx + L_x1 * eta[0] + c->chi_1 * eta[0];
    const ella_real J_xy = L_y1 * eta[0] + c->chi_2 * eta[1];
    const ella_real J_xz = L_z1 * eta[0] + c->chi_2 * eta[2];
    const ella_real J_yy = L_y2 * eta[1];
    const ella_real J_yz = L_z2 * eta[1];
    const ella_real J_zz = L_z2 * eta[2];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = J_xx + J_zz;
    const ella_real I_zz = J_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const ella_real a_0_x = twist[1] * twist[5] - t14 - twist[2] * twist[4];
    const ella_real a_0_y = twist[2] * twist[3] - t15 - twist[0] * twist[5];
    const ella_real a_0_z = twist[0] * twist[4] - t16 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const ella_real t17 = twist[1] * twist[1];
    const ella_real t18 = twist[2] * twist[2];
    const ella_real minus_Omega_xx = t17 + t18;
    const ella_real Omega_xy = twist[0] * twist[1];
    const ella_real Omega_xz = twist[0] * twist[2];
    const ella_real t19 = twist[0] * twist[0];
    const ella_real minus_Omega_yy = t19 + t18;
    const ella_real Omega_yz = twist[1] * twist[2];
    const ella_real minus_Omega_zz = t19 + t17;

    /* B: moment of the elastic velocity */
    const ella_real B_xx = L_x1 * etadot[0];
    const ella_real B_xy = L_y1 * etadot[0];
    const ella_real B_xz = L_z1 * etadot[0];
    const ella_real B_yx = L_x2 * etadot[1];
    const ella_real B_yy = L_y2 * etadot[1];
    const ella_real B_yz = L_z2 * etadot[1];
    const ella_real B_zx = L_x2 * etadot[2];
    const ella_real B_zy = L_y2 * etadot[2];
    const ella_real B_zz = L_z2 * etadot[2];

    /* h_c: half of the Coriolis wrench */
    const ella_real h_c_1 = B_yy * twist[0] + B_zz * twist[0] - B_xy * twist[1] - B_xz * twist[2];
    const ella_real h_c_2 = B_xx * twist[1] + B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const ella_real h_c_3 = B_xx * twist[2] + B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const ella_real h_c_4 = Sdot_z * twist[1] - Sdot_y * twist[2];
    const ella_real h_c_5 = Sdot_x * twist[2] - Sdot_z * twist[0];
    const ella_real h_c_6 = Sdot_y * twist[0] - Sdot_x * twist[1];

    /* H_star: gyroscopic wrench and weight (29) */
    const ella_real t20 = h_c_1 + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const ella_real H_star_1 = t20 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const ella_real t21 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const ella_real t22 = c->I_s * twist[0];
    const ella_real H_star_2 = t21 + t22 * twist[2] - J_xx * Omega_xz - J_xy * Omega_yz - S_x * a_0_z;
    const ella_real t23 = h_c_3 + J_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + S_x * a_0_y;
    const ella_real H_star_3 = t23 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t22 * twist[1];
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
    const ella_real t24 = L_y1 * Omega_xy - L_x1 * minus_Omega_xx + L_z1 * Omega_xz + a_0_x * c->sigma_x1
        + Ldot_z1 * 2 * twist[1];
    const ella_real h_eta_1 = t24 - Ldot_y1 * 2 * twist[2];
    const ella_real t25 = Ldot_x2 * 2;
    const ella_real h_eta_2 = L_x2 * Omega_xy - L_y2 * minus_Omega_yy + L_z2 * Omega_yz + a_0_y * c->sigma_y2
        + t25 * twist[2] - Ldot_z2 * 2 * twist[0];
    const ella_real t26 = L_x2 * Omega_xz + L_y2 * Omega_yz - L_z2 * minus_Omega_zz + a_0_z * c->sigma_y2
        + Ldot_y2 * 2 * twist[0];
    const ella_real h_eta_3 = t26 - t25 * twist[1];

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
    const ella_real t27 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real omega_s_x = c2 * t27;
    const ella_real omega_s_y = thetadot_y + c3 * theta_z * t27;
    const ella_real omega_s_z = thetadot_z - c3 * theta_y * t27;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t28 = omega_s_x + twist[0];
    const ella_real t29 = omega_s_y + twist[1];
    const ella_real t30 = omega_s_z + twist[2];
    const ella_real omega_T_x = R_T_xx * t28 + minus_R_T_xy * t29 - R_T_xz * t30;
    const ella_real omega_T_y = R_T_yy * t29 - minus_R_T_xy * t28 + R_T_yz * t30;
    const ella_real omega_T_z = R_T_xz * t28 + R_T_yz * t29 + R_T_zz * t30;

    /* v_T: velocity of the tip point (46) */
    const ella_real t31 = udot_T_x + twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const ella_real t32 = udot_T_y + twist[4] + twist[2] * r_T_x - twist[0] * r_T_z;
    const ella_real t33 = udot_T_z + twist[5] + twist[0] * r_T_y - twist[1] * r_T_x;
    const ella_real v_T_x = R_T_xx * t31 + minus_R_T_xy * t32 - R_T_xz * t33;
    const ella_real v_T_y = R_T_yy * t32 - minus_R_T_xy * t31 + R_T_yz * t33;
    const ella_real v_T_z = R_T_xz * t31 + R_T_yz * t32 + R_T_zz * t33;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const ella_real t34 = omega_s_z * t32 + twist[1] * udot_T_z - omega_s_y * t33 - twist[2] * udot_T_y;
    const ella_real t35 = omega_s_x * t33 + twist[2] * udot_T_x - omega_s_z * t31 - twist[0] * udot_T_z;
    const ella_real t36 = omega_s_y * t31 + twist[0] * udot_T_y - omega_s_x * t32 - twist[1] * udot_T_x;
    const ella_real b_v_x = R_T_xx * t34 + minus_R_T_xy * t35 - R_T_xz * t36;
    const ella_real b_v_y = R_T_yy * t35 - minus_R_T_xy * t34 + R_T_yz * t36;
    const ella_real b_v_z = R_T_xz * t34 + R_T_yz * t35 + R_T_zz * t36;

    const ella_real t37 = R_T_xx * t14 + minus_R_T_xy * t15 - R_T_xz * t16;
    const ella_real t38 = R_T_yy * t15 - minus_R_T_xy * t14 + R_T_yz * t16;
    const ella_real t39 = R_T_xz * t14 + R_T_yz * t15 + R_T_zz * t16;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const ella_real a_T_x = omega_T_y * v_T_z - t37 - omega_T_z * v_T_y;
    const ella_real a_T_y = omega_T_z * v_T_x - t38 - omega_T_x * v_T_z;
    const ella_real a_T_z = omega_T_x * v_T_y - t39 - omega_T_y * v_T_x;

    /* h_T_F: force that the bodies' velocities and weight need */
    const ella_real h_T_F_x = a_T_x * c->body0_mass;
    const ella_real h_T_F_y = a_T_y * c->body0_mass;
    const ella_real h_T_F_z = a_T_z * c->body0_mass;

    /* joint_H: what the velocities, springs and dampers leave in the joint's rows (61) */
    const ella_real minus_joint_H_1 = R_rel_xx * base->b[0] + minus_R_rel_xy * base->b[1] + beta_omega_x;
    const ella_real t40 = -minus_joint_H_1;
    const ella_real joint_H_2 = minus_R_rel_xy * base->b[0] - R_rel_xx * base->b[1] + minus_beta_omega_y;
    const ella_real minus_joint_H_4 = beta_v_x + R_rel_xx * base->b[3] + minus_R_rel_xy * base->b[4];
    const ella_real t41 = -minus_joint_H_4;
    const ella_real joint_H_5 = minus_beta_v_y + minus_R_rel_xy * base->b[3] - R_rel_xx * base->b[4];
    const ella_real t42 = -base->b[5];

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
    link->M_D[1] = L_y2;
    link->M_D[2] = L_z1;
    link->M_D[3] = L_x2;
    link->M_D[4] = L_y1;
    link->h_V[0] = h_V_1;
    link->h_V[1] = h_V_2;
    link->h_V[2] = h_V_3;
    link->h_V[3] = h_V_4;
    link->h_V[4] = h_V_5;
    link->h_V[5] = h_V_6;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
    link->h_eta[2] = h_eta_3;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = minus_R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yy;
    link->R_T[4] = R_T_yz;
    link->R_T[5] = R_T_zz;
    link->J_l[1] = minus_J_l_xy;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yy;
    link->J_l[4] = J_l_yz;
    link->J_l[5] = J_l_zz;
    link->r_T[0] = r_T_x;
    link->r_T[1] = r_T_y;
    link->r_T[2] = r_T_z;
    link->b_T[3] = b_v_x;
    link->b_T[4] = b_v_y;
    link->b_T[5] = b_v_z;
    link->h_T[0] = h_T_F_x;
    link->h_T[1] = h_T_F_y;
    link->h_T[2] = h_T_F_z;
    M[place[0]] = 1;
    M[place[1]] = 1;
    M[place[2]] = 1;
    M[place[3]] = 1;
    M[place[4]] = 1;
    M[place[5]] = 1;
    H[0] = t40;
    H[1] = joint_H_2;
    H[2] = 0;
    H[3] = t41;
    H[4] = joint_H_5;
    H[5] = t42;
    W[0] = 0;
    W[1] = 0;
    W[2] = tau[0];
    W[3] = 0;
    W[4] = 0;
    W[5] = 0;
    base->X[0] = R_rel_xx;
    base->X[1] = minus_R_rel_xy;
    base->X[6] = t1;
    base->X[7] = R_rel_xx;
    base->X[21] = R_rel_xx;
    base->X[22] = minus_R_rel_xy;
    base->X[27] = t1;
    base->X[28] = R_rel_xx;
    base->PX[0] = R_rel_xx;
    base->PX[1] = minus_R_rel_xy;
    base->PX[6] = t1;
    base->PX[7] = R_rel_xx;
    base->PX[21] = R_rel_xx;
    base->PX[22] = minus_R_rel_xy;
    base->PX[27] = t1;
    base->PX[28] = R_rel_xx;
    return ELLA_OK;
}

/* link rows, links like upper_arm: 665 operations */
ELLA_PART ella_status link_rows_upper_arm(const ella_link_constants *c, const ella_link_store *link, const ella_node *tip,
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
    const ella_real t7 = link->J_l[2] * c->Psi_c_z2;
    const ella_real t8 = link->J_l[4] * c->Psi_c_z2;
    const ella_real t9 = link->J_l[5] * c->Psi_c_z2;
    const ella_real J_Teta_12 = link->R_T[0] * t7 + link->R_T[1] * t8 - link->R_T[2] * t9;
    const ella_real t10 = link->J_l[1] * c->Psi_c_y3;
    const ella_real t11 = link->J_l[3] * c->Psi_c_y3;
    const ella_real t12 = link->J_l[4] * c->Psi_c_y3;
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
    const ella_real V_eta_32 = link->M_D[3] + J_Teta_42 * t19 + J_Teta_52 * t20 + J_Teta_53 * t21;
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
    const ella_real V_eta_63 = c->sigma_y2 + minus_J_Teta_43 * t25 + t31 + J_Teta_63 * t30;

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
    const ella_real V_next_11 = link->R_T[0] * tip->X[0] - link->R_T[1] * tip->X[1];
    const ella_real V_next_12 = link->R_T[0] * tip->X[6] - link->R_T[1] * tip->X[7];
    const ella_real V_next_14 = J_TV_51 * tip->X[22] - minus_J_TV_41 * tip->X[21];
    const ella_real V_next_15 = J_TV_51 * tip->X[28] - minus_J_TV_41 * tip->X[27];
    const ella_real V_next_21 = link->R_T[1] * tip->X[0] + link->R_T[3] * tip->X[1];
    const ella_real V_next_22 = link->R_T[1] * tip->X[6] + link->R_T[3] * tip->X[7];
    const ella_real V_next_24 = J_TV_42 * tip->X[21] - minus_J_TV_52 * tip->X[22];
    const ella_real V_next_25 = J_TV_42 * tip->X[27] - minus_J_TV_52 * tip->X[28];
    const ella_real V_next_31 = link->R_T[4] * tip->X[1] - link->R_T[2] * tip->X[0];
    const ella_real V_next_32 = link->R_T[4] * tip->X[7] - link->R_T[2] * tip->X[6];
    const ella_real V_next_34 = J_TV_43 * tip->X[21] + J_TV_53 * tip->X[22];
    const ella_real V_next_35 = J_TV_43 * tip->X[27] + J_TV_53 * tip->X[28];
    const ella_real V_next_44 = link->R_T[0] * tip->X[21] - link->R_T[1] * tip->X[22];
    const ella_real V_next_45 = link->R_T[0] * tip->X[27] - link->R_T[1] * tip->X[28];
    const ella_real V_next_54 = link->R_T[1] * tip->X[21] + link->R_T[3] * tip->X[22];
    const ella_real V_next_55 = link->R_T[1] * tip->X[27] + link->R_T[3] * tip->X[28];
    const ella_real V_next_64 = link->R_T[4] * tip->X[22] - link->R_T[2] * tip->X[21];
    const ella_real V_next_65 = link->R_T[4] * tip->X[28] - link->R_T[2] * tip->X[27];

    /* eta_next: modal rows, columns of the next joint's wrench (100) */
    const ella_real eta_next_14 = J_Teta_41 * tip->X[21] - minus_J_Teta_51 * tip->X[22];
    const ella_real eta_next_15 = J_Teta_41 * tip->X[27] - minus_J_Teta_51 * tip->X[28];
    const ella_real eta_next_21 = J_Teta_12 * tip->X[0] + J_Teta_22 * tip->X[1];
    const ella_real eta_next_22 = J_Teta_12 * tip->X[6] + J_Teta_22 * tip->X[7];
    const ella_real eta_next_24 = J_Teta_42 * tip->X[21] + J_Teta_52 * tip->X[22];
    const ella_real eta_next_25 = J_Teta_42 * tip->X[27] + J_Teta_52 * tip->X[28];
    const ella_real eta_next_31 = J_Teta_13 * tip->X[0] + J_Teta_23 * tip->X[1];
    const ella_real eta_next_32 = J_Teta_13 * tip->X[6] + J_Teta_23 * tip->X[7];
    const ella_real eta_next_34 = J_Teta_53 * tip->X[22] - minus_J_Teta_43 * tip->X[21];
    const ella_real eta_next_35 = J_Teta_53 * tip->X[28] - minus_J_Teta_43 * tip->X[27];

    /* next_V: next joint's rows, twist columns (100) */
    const ella_real next_V_11 = tip->PX[1] * link->R_T[1] - tip->PX[0] * link->R_T[0];
    const ella_real minus_next_V_12 = tip->PX[0] * link->R_T[1] + tip->PX[1] * link->R_T[3];
    const ella_real t39 = -minus_next_V_12;
    const ella_real next_V_13 = tip->PX[0] * link->R_T[2] - tip->PX[1] * link->R_T[4];
    const ella_real next_V_21 = tip->PX[7] * link->R_T[1] - tip->PX[6] * link->R_T[0];
    const ella_real minus_next_V_22 = tip->PX[6] * link->R_T[1] + tip->PX[7] * link->R_T[3];
    const ella_real t40 = -minus_next_V_22;
    const ella_real next_V_23 = tip->PX[6] * link->R_T[2] - tip->PX[7] * link->R_T[4];
    const ella_real next_V_41 = minus_J_TV_41 * tip->PX[21] - J_TV_51 * tip->PX[22];
    const ella_real next_V_42 = minus_J_TV_52 * tip->PX[22] - J_TV_42 * tip->PX[21];
    const ella_real minus_next_V_43 = J_TV_43 * tip->PX[21] + J_TV_53 * tip->PX[22];
    const ella_real t41 = -minus_next_V_43;
    const ella_real next_V_44 = tip->PX[22] * link->R_T[1] - tip->PX[21] * link->R_T[0];
    const ella_real minus_next_V_45 = tip->PX[21] * link->R_T[1] + tip->PX[22] * link->R_T[3];
    const ella_real t42 = -minus_next_V_45;
    const ella_real next_V_46 = tip->PX[21] * link->R_T[2] - tip->PX[22] * link->R_T[4];
    const ella_real next_V_51 = minus_J_TV_41 * tip->PX[27] - J_TV_51 * tip->PX[28];
    const ella_real next_V_52 = minus_J_TV_52 * tip->PX[28] - J_TV_42 * tip->PX[27];
    const ella_real minus_next_V_53 = J_TV_43 * tip->PX[27] + J_TV_53 * tip->PX[28];
    const ella_real t43 = -minus_next_V_53;
    const ella_real next_V_54 = tip->PX[28] * link->R_T[1] - tip->PX[27] * link->R_T[0];
    const ella_real minus_next_V_55 = tip->PX[27] * link->R_T[1] + tip->PX[28] * link->R_T[3];
    const ella_real t44 = -minus_next_V_55;
    const ella_real next_V_56 = tip->PX[27] * link->R_T[2] - tip->PX[28] * link->R_T[4];
    const ella_real t45 = -J_TV_61;
    const ella_real t46 = -J_TV_62;
    const ella_real t47 = -J_TV_63;
    const ella_real t48 = -link->R_T[2];
    const ella_real t49 = -link->R_T[4];
    const ella_real t50 = -link->R_T[5];

    /* next_eta: next joint's rows, modal columns (100) */
    const ella_real minus_next_eta_12 = J_Teta_12 * tip->PX[0] + J_Teta_22 * tip->PX[1];
    const ella_real t51 = -minus_next_eta_12;
    const ella_real minus_next_eta_13 = J_Teta_13 * tip->PX[0] + J_Teta_23 * tip->PX[1];
    const ella_real t52 = -minus_next_eta_13;
    const ella_real minus_next_eta_22 = J_Teta_12 * tip->PX[6] + J_Teta_22 * tip->PX[7];
    const ella_real t53 = -minus_next_eta_22;
    const ella_real minus_next_eta_23 = J_Teta_13 * tip->PX[6] + J_Teta_23 * tip->PX[7];
    const ella_real t54 = -minus_next_eta_23;
    const ella_real next_eta_41 = minus_J_Teta_51 * tip->PX[22] - J_Teta_41 * tip->PX[21];
    const ella_real minus_next_eta_42 = J_Teta_42 * tip->PX[21] + J_Teta_52 * tip->PX[22];
    const ella_real t55 = -minus_next_eta_42;
    const ella_real next_eta_43 = minus_J_Teta_43 * tip->PX[21] - J_Teta_53 * tip->PX[22];
    const ella_real next_eta_51 = minus_J_Teta_51 * tip->PX[28] - J_Teta_41 * tip->PX[27];
    const ella_real minus_next_eta_52 = J_Teta_42 * tip->PX[27] + J_Teta_52 * tip->PX[28];
    const ella_real t56 = -minus_next_eta_52;
    const ella_real next_eta_53 = minus_J_Teta_43 * tip->PX[27] - J_Teta_53 * tip->PX[28];
    const ella_real t57 = -J_Teta_61;
    const ella_real t58 = -J_Teta_53;
    const ella_real t59 = -J_Teta_63;

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
    const ella_real t60 = J_TV_51 * w_ext[4] - minus_J_TV_41 * w_ext[3] + J_TV_61 * w_ext[5]
        + link->R_T[0] * w_ext[0] - link->R_T[1] * w_ext[1];
    const ella_real V_W_1 = t60 + link->R_T[2] * w_ext[2];
    const ella_real t61 = J_TV_42 * w_ext[3] - minus_J_TV_52 * w_ext[4] + J_TV_62 * w_ext[5]
        + link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1];
    const ella_real V_W_2 = t61 + link->R_T[4] * w_ext[2];
    const ella_real t62 = J_TV_43 * w_ext[3] + J_TV_53 * w_ext[4] + J_TV_63 * w_ext[5] - link->R_T[2] * w_ext[0]
        + link->R_T[4] * w_ext[1];
    const ella_real V_W_3 = t62 + link->R_T[5] * w_ext[2];
    const ella_real V_W_4 = link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5];
    const ella_real V_W_5 = link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5];
    const ella_real V_W_6 = link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5];

    /* eta_W: external wrench in the modal rows (100) */
    const ella_real eta_W_1 = J_Teta_41 * w_ext[3] - minus_J_Teta_51 * w_ext[4] + J_Teta_61 * w_ext[5];
    const ella_real t63 = J_Teta_12 * w_ext[0] + J_Teta_22 * w_ext[1] + J_Teta_32 * w_ext[2]
        + J_Teta_42 * w_ext[3] + J_Teta_52 * w_ext[4];
    const ella_real eta_W_2 = t63 + J_Teta_53 * w_ext[5];
    const ella_real t64 = J_Teta_13 * w_ext[0] + J_Teta_23 * w_ext[1] + J_Teta_33 * w_ext[2]
        - minus_J_Teta_43 * w_ext[3] + J_Teta_53 * w_ext[4];
    const ella_real eta_W_3 = t64 + J_Teta_63 * w_ext[5];

    /* outputs */
    M[place[12]] = next_V_11;
    M[place[13]] = t39;
    M[place[14]] = next_V_13;
    M[place[15]] = next_V_21;
    M[place[16]] = t40;
    M[place[17]] = next_V_23;
    M[place[18]] = next_V_41;
    M[place[19]] = next_V_42;
    M[place[20]] = t41;
    M[place[21]] = next_V_44;
    M[place[22]] = t42;
    M[place[23]] = next_V_46;
    M[place[24]] = next_V_51;
    M[place[25]] = next_V_52;
    M[place[26]] = t43;
    M[place[27]] = next_V_54;
    M[place[28]] = t44;
    M[place[29]] = next_V_56;
    M[place[30]] = t45;
    M[place[31]] = t46;
    M[place[32]] = t47;
    M[place[33]] = t48;
    M[place[34]] = t49;
    M[place[35]] = t50;
    M[place[36]] = t51;
    M[place[37]] = t52;
    M[place[38]] = t53;
    M[place[39]] = t54;
    M[place[40]] = next_eta_41;
    M[place[41]] = t55;
    M[place[42]] = next_eta_43;
    M[place[43]] = next_eta_51;
    M[place[44]] = t56;
    M[place[45]] = next_eta_53;
    M[place[46]] = t57;
    M[place[47]] = t58;
    M[place[48]] = t59;
    M[place[49]] = -1;
    M[place[50]] = -1;
    M[place[51]] = -1;
    M[place[52]] = -1;
    M[place[53]] = -1;
    M[place[54]] = -1;
    M[place[55]] = V_V_11;
    M[place[56]] = V_V_12;
    M[place[57]] = V_V_13;
    M[place[58]] = V_V_14;
    M[place[59]] = V_V_15;
    M[place[60]] = V_V_16;
    M[place[61]] = V_V_12;
    M[place[62]] = V_V_22;
    M[place[63]] = V_V_23;
    M[place[64]] = V_V_24;
    M[place[65]] = V_V_25;
    M[place[66]] = V_V_26;
    M[place[67]] = V_V_13;
    M[place[68]] = V_V_23;
    M[place[69]] = V_V_33;
    M[place[70]] = V_V_34;
    M[place[71]] = V_V_35;
    M[place[72]] = V_V_36;
    M[place[73]] = V_V_14;
    M[place[74]] = V_V_24;
    M[place[75]] = V_V_34;
    M[place[76]] = V_V_44;
    M[place[77]] = V_V_45;
    M[place[78]] = V_V_46;
    M[place[79]] = V_V_15;
    M[place[80]] = V_V_25;
    M[place[81]] = V_V_35;
    M[place[82]] = V_V_45;
    M[place[83]] = V_V_55;
    M[place[84]] = V_V_56;
    M[place[85]] = V_V_16;
    M[place[86]] = V_V_26;
    M[place[87]] = V_V_36;
    M[place[88]] = V_V_46;
    M[place[89]] = V_V_56;
    M[place[90]] = V_V_66;
    M[place[91]] = V_eta_11;
    M[place[92]] = V_eta_12;
    M[place[93]] = V_eta_13;
    M[place[94]] = V_eta_21;
    M[place[95]] = V_eta_22;
    M[place[96]] = V_eta_23;
    M[place[97]] = V_eta_31;
    M[place[98]] = V_eta_32;
    M[place[99]] = V_eta_33;
    M[place[100]] = V_eta_41;
    M[place[101]] = V_eta_42;
    M[place[102]] = V_eta_43;
    M[place[103]] = V_eta_51;
    M[place[104]] = V_eta_52;
    M[place[105]] = V_eta_53;
    M[place[106]] = V_eta_61;
    M[place[107]] = V_eta_62;
    M[place[108]] = V_eta_63;
    M[place[109]] = V_next_11;
    M[place[110]] = V_next_12;
    M[place[111]] = link->R_T[2];
    M[place[112]] = V_next_14;
    M[place[113]] = V_next_15;
    M[place[114]] = J_TV_61;
    M[place[115]] = V_next_21;
    M[place[116]] = V_next_22;
    M[place[117]] = link->R_T[4];
    M[place[118]] = V_next_24;
    M[place[119]] = V_next_25;
    M[place[120]] = J_TV_62;
    M[place[121]] = V_next_31;
    M[place[122]] = V_next_32;
    M[place[123]] = link->R_T[5];
    M[place[124]] = V_next_34;
    M[place[125]] = V_next_35;
    M[place[126]] = J_TV_63;
    M[place[127]] = V_next_44;
    M[place[128]] = V_next_45;
    M[place[129]] = link->R_T[2];
    M[place[130]] = V_next_54;
    M[place[131]] = V_next_55;
    M[place[132]] = link->R_T[4];
    M[place[133]] = V_next_64;
    M[place[134]] = V_next_65;
    M[place[135]] = link->R_T[5];
    M[place[136]] = V_eta_11;
    M[place[137]] = V_eta_21;
    M[place[138]] = V_eta_31;
    M[place[139]] = V_eta_41;
    M[place[140]] = V_eta_51;
    M[place[141]] = V_eta_61;
    M[place[142]] = V_eta_12;
    M[place[143]] = V_eta_22;
    M[place[144]] = V_eta_32;
    M[place[145]] = V_eta_42;
    M[place[146]] = V_eta_52;
    M[place[147]] = V_eta_62;
    M[place[148]] = V_eta_13;
    M[place[149]] = V_eta_23;
    M[place[150]] = V_eta_33;
    M[place[151]] = V_eta_43;
    M[place[152]] = V_eta_53;
    M[place[153]] = V_eta_63;
    M[place[154]] = eta_eta_11;
    M[place[155]] = eta_eta_12;
    M[place[156]] = eta_eta_13;
    M[place[157]] = eta_eta_12;
    M[place[158]] = eta_eta_22;
    M[place[159]] = eta_eta_23;
    M[place[160]] = eta_eta_13;
    M[place[161]] = eta_eta_23;
    M[place[162]] = eta_eta_33;
    M[place[163]] = eta_next_14;
    M[place[164]] = eta_next_15;
    M[place[165]] = J_Teta_61;
    M[place[166]] = eta_next_21;
    M[place[167]] = eta_next_22;
    M[place[168]] = J_Teta_32;
    M[place[169]] = eta_next_24;
    M[place[170]] = eta_next_25;
    M[place[171]] = J_Teta_53;
    M[place[172]] = eta_next_31;
    M[place[173]] = eta_next_32;
    M[place[174]] = J_Teta_33;
    M[place[175]] = eta_next_34;
    M[place[176]] = eta_next_35;
    M[place[177]] = J_Teta_63;
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
ELLA_PART ella_status link_rows_forearm(const ella_link_constants *c, const ella_link_store *link, const ella_real m_eta[3],
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
    const ella_real t7 = link->J_l[2] * c->Psi_c_z2;
    const ella_real t8 = link->J_l[4] * c->Psi_c_z2;
    const ella_real t9 = link->J_l[5] * c->Psi_c_z2;
    const ella_real J_Teta_12 = link->R_T[0] * t7 + link->R_T[1] * t8 - link->R_T[2] * t9;
    const ella_real t10 = link->J_l[1] * c->Psi_c_y3;
    const ella_real t11 = link->J_l[3] * c->Psi_c_y3;
    const ella_real t12 = link->J_l[4] * c->Psi_c_y3;
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
    const ella_real V_eta_32 = link->M_D[3] + J_Teta_42 * t19 + J_Teta_52 * t20 + J_Teta_53 * t21;
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
    const ella_real V_eta_63 = c->sigma_y2 + minus_J_Teta_43 * t25 + t31 + J_Teta_63 * t30;

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

static ELLA_TARGETS ella_status dae_dynamics_dae_kinematics(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return dae_kinematics_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->new_qdot + q);
    default:
        return dae_kinematics_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->new_qdot + q);
    }
}

static ELLA_TARGETS ella_status dae_dynamics_eliminate(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return eliminate_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->eta + e, call->etadot + e, call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->tau + q);
    default:
        return eliminate_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->eta + e, call->etadot + e, call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->tau + q);
    }
}

static ELLA_TARGETS ella_status dae_dynamics_accelerate(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return accelerate_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->qddot + q, call->wrench ? call->wrench + 6 * i : 0, call->alpha + 6 * i, call->etaddot + e);
    default:
        return accelerate_forearm(&chain->links[i], &chain->nodes[i], call->qddot + q, call->wrench ? call->wrench + 6 * i : 0, call->alpha + 6 * i, call->etaddot + e);
    }
}

static ELLA_TARGETS ella_status dae_dynamics_twist_rates(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    return twist_rates_upper_arm(call->quaternion + 4 * i, call->gravity, call->given_alpha + 6 * i, call->twist + 6 * i, call->Vdot + 6 * i);
}

static ELLA_TARGETS ella_status projection_project(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return project_upper_arm(&c->links[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    default:
        return project_forearm(&chain->nodes[i], call->q + q, call->twist + 6 * i, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    }
}

static ELLA_TARGETS ella_status placement_forward_kinematics(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return forward_kinematics_upper_arm(&c->links[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->eta + e, call->etadot + e, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    default:
        return forward_kinematics_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->eta + e, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    }
}

static ELLA_TARGETS ella_status inverse_kinematics(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return kinematics_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->eta + e, call->etadot + e);
    default:
        return kinematics_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->eta + e, call->etadot + e);
    }
}

static ELLA_TARGETS ella_status inverse_inverse_outward(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_outward_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->given_qddot + q, call->given_etaddot + e);
    default:
        return inverse_outward_forearm(&chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->given_qddot + q, call->given_etaddot + e);
    }
}

static ELLA_TARGETS ella_status inverse_inverse_inward(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_inward_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->given_etaddot + e, call->eta + e, call->etadot + e, call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->force_eta + e, call->force + q, call->wrench ? call->wrench + 6 * i : 0);
    default:
        return inverse_inward_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->given_etaddot + e, call->eta + e, call->etadot + e, call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->force_eta + e, call->force + q, call->wrench ? call->wrench + 6 * i : 0);
    }
}

static ELLA_TARGETS ella_status inertia_kinematics(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return kinematics_upper_arm_2(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->q + q, call->eta + e);
    default:
        return kinematics_forearm_2(&c->links[i], &chain->links[i], &chain->nodes[i], call->q + q, call->eta + e);
    }
}

static ELLA_TARGETS ella_status inertia_inverse_outward(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_outward_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->given_qddot + q, call->given_etaddot + e);
    default:
        return inverse_outward_forearm(&chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->given_qddot + q, call->given_etaddot + e);
    }
}

static ELLA_TARGETS ella_status inertia_inverse_inward(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_inward_upper_arm_2(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->given_etaddot + e, call->eta + e, call->m_eta + e, call->force_eta + e, call->force + q);
    default:
        return inverse_inward_forearm_2(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->given_etaddot + e, call->eta + e, call->m_eta + e, call->force_eta + e, call->force + q);
    }
}

static ELLA_TARGETS ella_status assembly_joint_rows(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return joint_rows_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->eta + e, call->etadot + e, call->tau + q, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    default:
        return joint_rows_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->eta + e, call->etadot + e, call->tau + q, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    }
}

static ELLA_TARGETS ella_status assembly_link_rows(const ella_constants *c, const ella_call *call, ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return link_rows_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->m_eta + e, call->f_eta + e, call->w_ext + 6 * i, call->H + 24 + e, call->W + 24 + e, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    default:
        return link_rows_forearm(&c->links[i], &chain->links[i], call->m_eta + e, call->f_eta + e, call->w_ext + 6 * i, call->H + 24 + e, call->W + 24 + e, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    }
}

/* A base at rest falls up; all else that is known of base and last tip is folded into the code. */
static void start(const ella_call *call, ella_chain *chain)
{
    int k;
    for (k = 0; k < 3; ++k) {
        chain->nodes[0].alpha_0[k + 3] = -call->gravity[k];
    }
}

ELLA_TARGETS ella_status ella_dae_dynamics(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
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

ELLA_TARGETS ella_status ella_projection(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = projection_project(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    return ELLA_OK;
}

ELLA_TARGETS ella_status ella_placement(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = placement_forward_kinematics(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    return ELLA_OK;
}

ELLA_TARGETS ella_status ella_inverse(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    start(call, chain);
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = inverse_kinematics(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = inverse_inverse_outward(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = ELLA_NLINKS - 1; i >= 0; --i) {
        status = inverse_inverse_inward(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    return ELLA_OK;
}

ELLA_TARGETS ella_status ella_inertia_posture(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = inertia_kinematics(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    return ELLA_OK;
}

ELLA_TARGETS ella_status ella_inertia_column(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = inertia_inverse_outward(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = ELLA_NLINKS - 1; i >= 0; --i) {
        status = inertia_inverse_inward(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    return ELLA_OK;
}

ELLA_TARGETS ella_status ella_assembly(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
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
