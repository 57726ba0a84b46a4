/* ella_links.c: the phases of the algorithms for each class of links, and the loops over the links.
 *
 * A chain of n links has n + 1 nodes: node 0 is the base, node i + 1 the tip of link i. A phase of link i
 * reads and writes the link's store, its two nodes, and the arrays of the call.
 */
/* Long straight lines: GCC schedules them before it hands out registers on most processors, on x86 only where it is
 * told to, and makes vectors of neighbours there, which takes longer than it saves. Results are the same to the bit.
 */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#pragma GCC optimize("no-tree-slp-vectorize", "schedule-insns", "sched-pressure")
#endif
#include "ella_links.h"

static const int Q_OFFSET[ELLA_NLINKS] = { 0, 2 };
static const int ETA_OFFSET[ELLA_NLINKS] = { 0, 7 };

/* The places, among the structural nonzeros, of the entries of M_sys that each link computes. */
static const int M_PLACE[ELLA_NNZ] = {
    0, 3, 1, 4, 6, 11, 31, 12, 32, 67, 83, 99, 19, 39, 56, 20, 40, 57, 21, 41,
    58, 74, 90, 106, 22, 42, 59, 75, 91, 107, 23, 43, 60, 76, 92, 108, 272, 289, 306, 323,
    340, 357, 369, 273, 290, 307, 324, 341, 358, 370, 274, 291, 308, 325, 342, 359, 275, 292, 309, 326,
    343, 360, 276, 293, 310, 327, 344, 361, 2, 5, 7, 8, 9, 10, 13, 33, 50, 68, 84, 100,
    14, 34, 51, 69, 85, 101, 15, 35, 52, 70, 86, 102, 16, 36, 53, 71, 87, 103, 17, 37,
    54, 72, 88, 104, 18, 38, 55, 73, 89, 105, 266, 283, 300, 317, 334, 351, 368, 267, 284, 301,
    318, 335, 352, 268, 285, 302, 319, 336, 353, 269, 286, 303, 320, 337, 354, 270, 287, 304, 321, 338,
    355, 271, 288, 305, 322, 339, 356, 115, 126, 137, 149, 162, 175, 116, 127, 138, 150, 163, 176, 117,
    128, 139, 151, 164, 177, 152, 165, 178, 153, 166, 179, 154, 167, 180, 24, 44, 61, 77, 93, 109,
    25, 45, 62, 78, 94, 110, 26, 46, 63, 79, 95, 111, 27, 47, 64, 80, 96, 112, 28, 48,
    65, 81, 97, 113, 29, 49, 66, 82, 98, 114, 30, 277, 294, 311, 328, 345, 362, 278, 295, 312,
    329, 346, 363, 279, 296, 313, 330, 347, 364, 280, 297, 314, 331, 348, 365, 281, 298, 315, 332, 349,
    366, 282, 299, 316, 333, 350, 367, 371, 119, 130, 142, 156, 169, 182, 120, 131, 143, 157, 170, 183,
    121, 132, 144, 158, 171, 184, 122, 133, 145, 159, 172, 185, 123, 134, 146, 160, 173, 186, 124, 135,
    147, 161, 174, 187, 125, 136, 148, 140, 188, 202, 227, 240, 253, 118, 129, 141, 155, 168, 181, 189,
    203, 215, 228, 241, 254, 190, 204, 216, 229, 242, 255, 191, 205, 217, 230, 243, 256, 192, 206, 218,
    231, 244, 257, 193, 207, 219, 232, 245, 258, 194, 208, 220, 233, 246, 259, 372, 384, 396, 408, 420,
    432, 444, 373, 385, 397, 409, 421, 433, 374, 386, 398, 410, 422, 434, 375, 387, 399, 411, 423, 435,
    376, 388, 400, 412, 424, 436, 377, 389, 401, 413, 425, 437, 195, 209, 221, 234, 247, 260, 196, 210,
    222, 235, 248, 261, 197, 211, 223, 236, 249, 262, 198, 212, 224, 237, 250, 263, 199, 213, 225, 238,
    251, 264, 200, 214, 226, 239, 252, 265, 201, 378, 390, 402, 414, 426, 438, 379, 391, 403, 415, 427,
    439, 380, 392, 404, 416, 428, 440, 381, 393, 405, 417, 429, 441, 382, 394, 406, 418, 430, 442, 383,
    395, 407, 419, 431, 443, 445,
};
static const int M_OFFSET[ELLA_NLINKS] = { 0, 287 };

/* dae kinematics, links like upper_arm: 253 operations */
ELLA_PART ella_status dae_kinematics_upper_arm(const ella_link_constants *restrict c, ella_link_store *restrict link,
    const ella_node *restrict base, ella_node *restrict tip, const ella_real q[restrict 2],
    const ella_real twist[restrict 6], const ella_real eta[restrict 7], const ella_real etadot[restrict 7],
    ella_real qdot[restrict 2])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_xz = turn.sine, R_rel_zz = turn.cosine;
    const ella_sincos turn_2 = ella_sine_cosine(q[1]);
    const ella_real R_rel_yx = turn_2.sine, R_rel_yy = turn_2.cosine;
    link->S[0] = R_rel_yx;
    link->S[1] = R_rel_yy;
    const ella_real R_rel_xx = R_rel_zz * R_rel_yy;
    const ella_real minus_R_rel_xy = R_rel_yx * R_rel_zz;
    const ella_real minus_R_rel_zx = R_rel_xz * R_rel_yy;
    const ella_real R_rel_zy = R_rel_xz * R_rel_yx;

    const ella_real t1 = R_rel_yx * R_rel_yx + R_rel_yy * R_rel_yy;
    if (!(t1 - ELLA_REAL_EPSILON * 64 > 0)) { return ELLA_SINGULAR; }
    const ella_real t2 = 1 / t1;
    const ella_real qdot_1 = R_rel_yx * t2 * twist[0] + R_rel_yy * t2 * twist[1];
    qdot[0] = qdot_1;

    /* acceleration of the parent's tip in F_i axes */
    const ella_real acc_0_a_x = R_rel_xx * base->acc_0[3] + R_rel_yx * base->acc_0[4] - minus_R_rel_zx * base->acc_0[5];
    link->acc_0[3] = acc_0_a_x;
    const ella_real acc_0_a_y = R_rel_yy * base->acc_0[4] - minus_R_rel_xy * base->acc_0[3] + R_rel_zy * base->acc_0[5];
    link->acc_0[4] = acc_0_a_y;
    const ella_real acc_0_a_z = R_rel_xz * base->acc_0[3] + R_rel_zz * base->acc_0[5];
    link->acc_0[5] = acc_0_a_z;

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx * qdot_1;
    link->omega[0] = omega_J_x;
    const ella_real omega_J_y = R_rel_yy * qdot_1;
    link->omega[1] = omega_J_y;

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const ella_real t3 = qdot_1 * twist[2];
    const ella_real alpha_x = t3 * R_rel_yy;
    link->acc_0[0] = alpha_x;
    const ella_real minus_alpha_y = t3 * R_rel_yx;
    link->acc_0[1] = -minus_alpha_y;

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    link->r_T[0] = r_T_y;
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);
    link->r_T[1] = r_T_z;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t4 = theta_x * theta_x;
    const ella_real t5 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t4 + t5;
    const ella_real t6 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t6;

    /* c2: Stumpff function of order 2 */
    const ella_real t7 = ella_c4(x);
    const ella_real c2 = ELLA_REAL(0.5) - x * t7;

    /* c3: Stumpff function of order 3 */
    const ella_real t8 = ella_c5(x);
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * t8;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_y = etadot[0] * ELLA_REAL(2.0011941703010714) + etadot[1] * ELLA_REAL(2.0700807911885764)
        + etadot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_z = etadot[3] * ELLA_REAL(2.0011941703010714) + etadot[4] * ELLA_REAL(2.0700807911885764)
        + etadot[5] * ELLA_REAL(3.5651069283690613);

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_x = etadot[6] * ELLA_REAL(1.7320508075688772);
    const ella_real thetadot_y = c->Psi_c_y4 * etadot[3] + c->Psi_c_y5 * etadot[4] + c->Psi_c_y6 * etadot[5];
    const ella_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1] + c->Psi_c_z3 * etadot[2];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t9 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real t10 = theta_x * thetadot_y - theta_y * thetadot_x;
    const ella_real t11 = theta_z * thetadot_x - theta_x * thetadot_z;
    const ella_real t12 = theta_y * t10 - theta_z * t11;
    const ella_real omega_s_x = thetadot_x + c2 * t9 + c3 * t12;
    const ella_real t13 = theta_z * t9 - theta_x * t10;
    const ella_real omega_s_y = thetadot_y + c2 * t11 + c3 * t13;
    const ella_real t14 = theta_x * t11 - theta_y * t9;
    const ella_real omega_s_z = thetadot_z + c2 * t10 + c3 * t14;

    /* xdot: rate of the squared angle */
    const ella_real xdot = eta[6] * ELLA_REAL(3.4641016151377544) * thetadot_x + theta_y * 2 * thetadot_y
        + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const ella_real c2dot = xdot * (t7 - c3 * ELLA_REAL(0.5));

    /* c3dot: rate of c3 */
    const ella_real c3dot = xdot * (t8 * ELLA_REAL(1.5) - t7 * ELLA_REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_x = c2dot * t9 + c3 * (thetadot_y * t10 - thetadot_z * t11) + c3dot * t12;
    const ella_real alpha_s_y = c2dot * t11 + c3 * (thetadot_z * t9 - thetadot_x * t10) + c3dot * t13;
    const ella_real alpha_s_z = c2dot * t10 + c3 * (thetadot_x * t11 - thetadot_y * t9) + c3dot * t14;

    /* omega_t: angular velocity of the tip section (46) */
    const ella_real omega_t_x = omega_s_x + omega_J_x;
    tip->omega[0] = omega_t_x;
    const ella_real omega_t_y = omega_s_y + omega_J_y;
    tip->omega[1] = omega_t_y;
    const ella_real omega_t_z = omega_s_z + twist[2];
    tip->omega[2] = omega_t_z;

    /* alpha_t: angular acceleration of the tip section (accconst1b) */
    const ella_real alpha_t_x = alpha_s_x + alpha_x + omega_s_z * omega_J_y - omega_s_y * twist[2];
    tip->acc_0[0] = alpha_t_x;
    const ella_real alpha_t_y = alpha_s_y - minus_alpha_y + omega_s_x * twist[2] - omega_s_z * omega_J_x;
    tip->acc_0[1] = alpha_t_y;
    const ella_real alpha_t_z = alpha_s_z + omega_s_y * omega_J_x - omega_s_x * omega_J_y;
    tip->acc_0[2] = alpha_t_z;

    /* a_t: acceleration of the tip point (accconst1b) */
    const ella_real t15 = udot_T_z * 2 + omega_J_x * r_T_y - c->length * omega_J_y;
    const ella_real t16 = udot_T_y * 2 + c->length * twist[2] - omega_J_x * r_T_z;
    const ella_real a_t_x = acc_0_a_x - minus_alpha_y * r_T_z + omega_J_y * t15 - twist[2] * t16;
    tip->acc_0[3] = a_t_x;
    const ella_real t17 = omega_J_y * r_T_z - twist[2] * r_T_y;
    const ella_real a_t_y = acc_0_a_y + twist[2] * t17 - alpha_x * r_T_z - omega_J_x * t15;
    tip->acc_0[4] = a_t_y;
    const ella_real a_t_z = acc_0_a_z + alpha_x * r_T_y + omega_J_x * t16 + minus_alpha_y * c->length - omega_J_y * t17;
    tip->acc_0[5] = a_t_z;

    /* c1: Stumpff function of order 1 */
    const ella_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t5 + t6;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t4 + t6;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    link->J_l[0] = J_l_xx;
    const ella_real t18 = c3 * theta_hat2_12;
    const ella_real t19 = c2 * theta_z;
    const ella_real J_l_xy = t18 - t19;
    link->J_l[1] = J_l_xy;
    const ella_real t20 = c2 * theta_y;
    const ella_real t21 = c3 * theta_hat2_13;
    const ella_real J_l_xz = t20 + t21;
    link->J_l[2] = J_l_xz;
    const ella_real J_l_yx = t19 + t18;
    link->J_l[3] = J_l_yx;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    link->J_l[4] = J_l_yy;
    const ella_real t22 = c3 * theta_hat2_23;
    const ella_real t23 = c2 * theta_x;
    const ella_real J_l_yz = t22 - t23;
    link->J_l[5] = J_l_yz;
    const ella_real J_l_zx = t21 - t20;
    link->J_l[6] = J_l_zx;
    const ella_real J_l_zy = t23 + t22;
    link->J_l[7] = J_l_zy;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;
    link->J_l[8] = J_l_zz;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    link->R_T[0] = R_T_xx;
    tip->R_T[0] = R_T_xx;
    const ella_real t24 = c2 * theta_hat2_12;
    const ella_real t25 = c1 * theta_z;
    const ella_real R_T_xy = t24 - t25;
    link->R_T[1] = R_T_xy;
    tip->R_T[1] = R_T_xy;
    const ella_real t26 = c1 * theta_y;
    const ella_real t27 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t26 + t27;
    link->R_T[2] = R_T_xz;
    tip->R_T[2] = R_T_xz;
    const ella_real R_T_yx = t25 + t24;
    link->R_T[3] = R_T_yx;
    tip->R_T[3] = R_T_yx;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    link->R_T[4] = R_T_yy;
    tip->R_T[4] = R_T_yy;
    const ella_real t28 = c2 * theta_hat2_23;
    const ella_real t29 = c1 * theta_x;
    const ella_real R_T_yz = t28 - t29;
    link->R_T[5] = R_T_yz;
    tip->R_T[5] = R_T_yz;
    const ella_real R_T_zx = t27 - t26;
    link->R_T[6] = R_T_zx;
    tip->R_T[6] = R_T_zx;
    const ella_real R_T_zy = t29 + t28;
    link->R_T[7] = R_T_zy;
    tip->R_T[7] = R_T_zy;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;
    link->R_T[8] = R_T_zz;
    tip->R_T[8] = R_T_zz;

    /* outputs */
    qdot[1] = twist[2];
    link->omega[2] = twist[2];
    return ELLA_OK;
}

/* dae kinematics, links like forearm: 192 operations */
ELLA_PART ella_status dae_kinematics_forearm(const ella_link_constants *restrict c, ella_link_store *restrict link,
    const ella_node *restrict base, ella_node *restrict tip, const ella_real q[restrict 1],
    const ella_real twist[restrict 6], const ella_real eta[restrict 7], const ella_real etadot[restrict 7],
    ella_real qdot[restrict 1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const ella_real R_P_xx = base->R_T[0] * R_rel_xx + base->R_T[1] * R_rel_yx;
    link->R_P[0] = R_P_xx;
    const ella_real R_P_xy = base->R_T[1] * R_rel_xx - base->R_T[0] * R_rel_yx;
    link->R_P[1] = R_P_xy;
    const ella_real R_P_yx = base->R_T[3] * R_rel_xx + base->R_T[4] * R_rel_yx;
    link->R_P[3] = R_P_yx;
    const ella_real R_P_yy = base->R_T[4] * R_rel_xx - base->R_T[3] * R_rel_yx;
    link->R_P[4] = R_P_yy;
    const ella_real R_P_zx = base->R_T[6] * R_rel_xx + base->R_T[7] * R_rel_yx;
    link->R_P[6] = R_P_zx;
    const ella_real R_P_zy = base->R_T[7] * R_rel_xx - base->R_T[6] * R_rel_yx;
    link->R_P[7] = R_P_zy;
    const ella_real omega_R_x = R_P_xx * base->omega[0] + R_P_yx * base->omega[1] + R_P_zx * base->omega[2];
    link->omega[0] = omega_R_x;
    const ella_real omega_R_y = R_P_xy * base->omega[0] + R_P_yy * base->omega[1] + R_P_zy * base->omega[2];
    link->omega[1] = omega_R_y;
    const ella_real omega_R_z = base->R_T[2] * base->omega[0] + base->R_T[5] * base->omega[1]
        + base->R_T[8] * base->omega[2];

    const ella_real qdot_1 = twist[2] - omega_R_z;
    qdot[0] = qdot_1;

    /* acceleration of the parent's tip in F_i axes */
    const ella_real t1 = R_P_xx * base->acc_0[0] + R_P_yx * base->acc_0[1] + R_P_zx * base->acc_0[2];
    const ella_real t2 = R_P_xy * base->acc_0[0] + R_P_yy * base->acc_0[1] + R_P_zy * base->acc_0[2];
    const ella_real acc_0_alpha_z = base->R_T[2] * base->acc_0[0] + base->R_T[5] * base->acc_0[1]
        + base->R_T[8] * base->acc_0[2];
    link->acc_0[2] = acc_0_alpha_z;
    const ella_real acc_0_a_x = R_P_xx * base->acc_0[3] + R_P_yx * base->acc_0[4] + R_P_zx * base->acc_0[5];
    link->acc_0[3] = acc_0_a_x;
    const ella_real acc_0_a_y = R_P_xy * base->acc_0[3] + R_P_yy * base->acc_0[4] + R_P_zy * base->acc_0[5];
    link->acc_0[4] = acc_0_a_y;
    const ella_real acc_0_a_z = base->R_T[2] * base->acc_0[3] + base->R_T[5] * base->acc_0[4]
        + base->R_T[8] * base->acc_0[5];
    link->acc_0[5] = acc_0_a_z;

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const ella_real alpha_x = t1 + omega_R_y * qdot_1;
    link->acc_0[0] = alpha_x;
    const ella_real alpha_y = t2 - omega_R_x * qdot_1;
    link->acc_0[1] = alpha_y;

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    link->r_T[0] = r_T_y;
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);
    link->r_T[1] = r_T_z;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t3 = theta_x * theta_x;
    const ella_real t4 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t3 + t4;
    const ella_real t5 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t5;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* c3: Stumpff function of order 3 */
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * ella_c5(x);

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_y = etadot[0] * ELLA_REAL(2.0011941703010714) + etadot[1] * ELLA_REAL(2.0700807911885764)
        + etadot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_z = etadot[3] * ELLA_REAL(2.0011941703010714) + etadot[4] * ELLA_REAL(2.0700807911885764)
        + etadot[5] * ELLA_REAL(3.5651069283690613);

    /* a_t: acceleration of the tip point (accconst1b) */
    const ella_real t6 = udot_T_z * 2 + omega_R_x * r_T_y - c->length * omega_R_y;
    const ella_real t7 = udot_T_y * 2 + c->length * twist[2] - omega_R_x * r_T_z;
    const ella_real a_t_x = acc_0_a_x + alpha_y * r_T_z + omega_R_y * t6 - acc_0_alpha_z * r_T_y - twist[2] * t7;
    tip->acc_0[3] = a_t_x;
    const ella_real t8 = omega_R_y * r_T_z - twist[2] * r_T_y;
    const ella_real a_t_y = acc_0_a_y + acc_0_alpha_z * c->length + twist[2] * t8 - alpha_x * r_T_z - omega_R_x * t6;
    tip->acc_0[4] = a_t_y;
    const ella_real a_t_z = acc_0_a_z + alpha_x * r_T_y + omega_R_x * t7 - alpha_y * c->length - omega_R_y * t8;
    tip->acc_0[5] = a_t_z;

    /* c1: Stumpff function of order 1 */
    const ella_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t4 + t5;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t3 + t5;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    link->J_l[0] = J_l_xx;
    const ella_real t9 = c3 * theta_hat2_12;
    const ella_real t10 = c2 * theta_z;
    const ella_real J_l_xy = t9 - t10;
    link->J_l[1] = J_l_xy;
    const ella_real t11 = c2 * theta_y;
    const ella_real t12 = c3 * theta_hat2_13;
    const ella_real J_l_xz = t11 + t12;
    link->J_l[2] = J_l_xz;
    const ella_real J_l_yx = t10 + t9;
    link->J_l[3] = J_l_yx;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    link->J_l[4] = J_l_yy;
    const ella_real t13 = c3 * theta_hat2_23;
    const ella_real t14 = c2 * theta_x;
    const ella_real J_l_yz = t13 - t14;
    link->J_l[5] = J_l_yz;
    const ella_real J_l_zx = t12 - t11;
    link->J_l[6] = J_l_zx;
    const ella_real J_l_zy = t14 + t13;
    link->J_l[7] = J_l_zy;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;
    link->J_l[8] = J_l_zz;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    link->R_T[0] = R_T_xx;
    const ella_real t15 = c2 * theta_hat2_12;
    const ella_real t16 = c1 * theta_z;
    const ella_real R_T_xy = t15 - t16;
    link->R_T[1] = R_T_xy;
    const ella_real t17 = c1 * theta_y;
    const ella_real t18 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t17 + t18;
    link->R_T[2] = R_T_xz;
    const ella_real R_T_yx = t16 + t15;
    link->R_T[3] = R_T_yx;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    link->R_T[4] = R_T_yy;
    const ella_real t19 = c2 * theta_hat2_23;
    const ella_real t20 = c1 * theta_x;
    const ella_real R_T_yz = t19 - t20;
    link->R_T[5] = R_T_yz;
    const ella_real R_T_zx = t18 - t17;
    link->R_T[6] = R_T_zx;
    const ella_real R_T_zy = t20 + t19;
    link->R_T[7] = R_T_zy;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;
    link->R_T[8] = R_T_zz;

    /* outputs */
    link->R_P[2] = base->R_T[2];
    link->R_P[5] = base->R_T[5];
    link->R_P[8] = base->R_T[8];
    link->omega[2] = twist[2];
    return ELLA_OK;
}

/* eliminate, links like upper_arm: 1943 operations */
ELLA_PART ella_status eliminate_upper_arm(const ella_link_constants *restrict c, ella_link_store *restrict link,
    const ella_node *restrict tip, const ella_real eta[restrict 7], const ella_real etadot[restrict 7],
    const ella_real w_ext[restrict 6], const ella_real m_eta[restrict 7], const ella_real f_eta[restrict 7],
    const ella_real tau[restrict 2])
{
    /* S: first moment */
    const ella_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2 + eta[2] * c->sigma_y3;
    const ella_real S_z = eta[3] * c->sigma_y1 + eta[4] * c->sigma_y2 + eta[5] * c->sigma_y3;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2 + etadot[2] * c->sigma_y3;
    const ella_real Sdot_z = etadot[3] * c->sigma_y1 + etadot[4] * c->sigma_y2 + etadot[5] * c->sigma_y3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_y1 = c->mu * eta[0];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_y3 = c->mu * eta[2];
    const ella_real L_z1 = eta[3] * c->mu;
    const ella_real L_z2 = eta[4] * c->mu;
    const ella_real L_z3 = eta[5] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_y1 = c->mu * etadot[0];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_y3 = c->mu * etadot[2];
    const ella_real Ldot_z1 = etadot[3] * c->mu;
    const ella_real Ldot_z2 = etadot[4] * c->mu;
    const ella_real Ldot_z3 = etadot[5] * c->mu;

    /* J: second moment */
    const ella_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1] + c->chi_3 * eta[2];
    const ella_real J_xz = c->chi_1 * eta[3] + c->chi_2 * eta[4] + c->chi_3 * eta[5];
    const ella_real J_yy = L_y1 * eta[0] + L_y2 * eta[1] + L_y3 * eta[2];
    const ella_real J_yz = L_z1 * eta[0] + L_z2 * eta[1] + L_z3 * eta[2];
    const ella_real J_zz = L_z1 * eta[3] + L_z2 * eta[4] + L_z3 * eta[5];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = c->J_0_xx + J_zz;
    const ella_real I_zz = c->J_0_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const ella_real t1 = link->omega[1] * link->omega[1];
    const ella_real t2 = link->omega[2] * link->omega[2];
    const ella_real minus_Omega_xx = t1 + t2;
    const ella_real Omega_xy = link->omega[0] * link->omega[1];
    const ella_real t3 = link->omega[0] * link->omega[2];
    const ella_real Omega_xz = link->acc_0[1] + t3;
    const ella_real t4 = link->omega[0] * link->omega[0];
    const ella_real minus_Omega_yy = t4 + t2;
    const ella_real t5 = link->omega[1] * link->omega[2];
    const ella_real Omega_yz = t5 - link->acc_0[0];
    const ella_real Omega_zx = t3 - link->acc_0[1];
    const ella_real Omega_zy = link->acc_0[0] + t5;
    const ella_real minus_Omega_zz = t4 + t1;

    /* B: moment of the elastic velocity */
    const ella_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1] + c->chi_3 * etadot[2];
    const ella_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1] + L_y3 * etadot[2];
    const ella_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1] + L_z3 * etadot[2];
    const ella_real B_zx = c->chi_1 * etadot[3] + c->chi_2 * etadot[4] + c->chi_3 * etadot[5];
    const ella_real B_zy = L_y1 * etadot[3] + L_y2 * etadot[4] + L_y3 * etadot[5];
    const ella_real B_zz = L_z1 * etadot[3] + L_z2 * etadot[4] + L_z3 * etadot[5];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const ella_real h_c_tau_x = B_yy * link->omega[0] + B_zz * link->omega[0];
    const ella_real h_c_tau_y = B_zz * link->omega[1] - B_yx * link->omega[0] - B_yz * link->omega[2];
    const ella_real h_c_tau_z = B_yy * link->omega[2] - B_zx * link->omega[0] - B_zy * link->omega[1];
    const ella_real h_c_f_x = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
    const ella_real minus_h_c_f_y = Sdot_z * link->omega[0];
    const ella_real h_c_f_z = Sdot_y * link->omega[0];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const ella_real h_MD_tau_y = h_c_tau_y + etadot[6] * link->omega[2] * c->sigma_t_7;
    const ella_real h_MD_tau_z = h_c_tau_z - etadot[6] * link->omega[1] * c->sigma_t_7;

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t6 = h_c_tau_x + c->I_s * link->acc_0[0] + J_xy * Omega_zx + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const ella_real H_star_tau_x = t6 + S_y * link->acc_0[5] - J_xz * Omega_xy - J_zz * Omega_yz - S_z * link->acc_0[4];
    const ella_real t7 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->acc_0[3];
    const ella_real t8 = c->I_s * link->omega[0];
    const ella_real H_star_tau_y = t7 + t8 * link->omega[2] - c->J_0_xx * Omega_zx - J_xy * Omega_zy
        - c->S_0_x * link->acc_0[5];
    const ella_real t9 = h_c_tau_z + c->J_0_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + c->S_0_x * link->acc_0[4];
    const ella_real H_star_tau_z = t9 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->acc_0[3] - t8 * link->omega[1];
    const ella_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + link->acc_0[3] * c->mu;
    const ella_real H_star_f_y = Omega_xy * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + link->acc_0[4] * c->mu;
    const ella_real H_star_f_z = h_c_f_z + Omega_zx * c->S_0_x + Omega_zy * S_y - minus_Omega_zz * S_z
        + link->acc_0[5] * c->mu;

    /* h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const ella_real h_V_tau_y = H_star_tau_y + h_MD_tau_y;
    const ella_real h_V_tau_z = H_star_tau_z + h_MD_tau_z;
    const ella_real h_V_f_x = H_star_f_x + h_c_f_x;
    const ella_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const ella_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_xy * c->chi_1
        + link->acc_0[4] * c->sigma_y1 - Ldot_z1 * 2 * link->omega[0];
    const ella_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_xy * c->chi_2
        + link->acc_0[4] * c->sigma_y2 - Ldot_z2 * 2 * link->omega[0];
    const ella_real h_eta_3 = L_z3 * Omega_yz - L_y3 * minus_Omega_yy + Omega_xy * c->chi_3
        + link->acc_0[4] * c->sigma_y3 - Ldot_z3 * 2 * link->omega[0];
    const ella_real h_eta_4 = L_y1 * Omega_zy - L_z1 * minus_Omega_zz + Omega_zx * c->chi_1
        + link->acc_0[5] * c->sigma_y1 + Ldot_y1 * 2 * link->omega[0];
    const ella_real h_eta_5 = L_y2 * Omega_zy - L_z2 * minus_Omega_zz + Omega_zx * c->chi_2
        + link->acc_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];
    const ella_real h_eta_6 = L_y3 * Omega_zy - L_z3 * minus_Omega_zz + Omega_zx * c->chi_3
        + link->acc_0[5] * c->sigma_y3 + Ldot_y3 * 2 * link->omega[0];
    const ella_real h_eta_7 = link->acc_0[0] * c->sigma_t_7;

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real Lambda_T_44 = tip->Lambda[15] + c->body0_mass;
    const ella_real Lambda_T_55 = tip->Lambda[18] + c->body0_mass;
    const ella_real Lambda_T_66 = tip->Lambda[20] + c->body0_mass;
    const ella_real p_T_tau_x = tip->p[0]
        - (link->R_T[0] * w_ext[0] + link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2]);
    const ella_real p_T_tau_y = tip->p[1]
        - (link->R_T[3] * w_ext[0] + link->R_T[4] * w_ext[1] + link->R_T[5] * w_ext[2]);
    const ella_real p_T_tau_z = tip->p[2]
        - (link->R_T[6] * w_ext[0] + link->R_T[7] * w_ext[1] + link->R_T[8] * w_ext[2]);
    const ella_real p_T_f_x = tip->p[3] + c->body0_mass * tip->acc_0[3]
        - (link->R_T[0] * w_ext[3] + link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const ella_real p_T_f_y = tip->p[4] + c->body0_mass * tip->acc_0[4]
        - (link->R_T[3] * w_ext[3] + link->R_T[4] * w_ext[4] + link->R_T[5] * w_ext[5]);
    const ella_real p_T_f_z = tip->p[5] + c->body0_mass * tip->acc_0[5]
        - (link->R_T[6] * w_ext[3] + link->R_T[7] * w_ext[4] + link->R_T[8] * w_ext[5]);

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real Theta_11 = link->J_l[2] * c->Psi_c_z1;
    const ella_real Theta_12 = link->J_l[2] * c->Psi_c_z2;
    const ella_real Theta_13 = link->J_l[2] * c->Psi_c_z3;
    const ella_real Theta_14 = link->J_l[1] * c->Psi_c_y4;
    const ella_real Theta_15 = link->J_l[1] * c->Psi_c_y5;
    const ella_real Theta_16 = link->J_l[1] * c->Psi_c_y6;
    const ella_real Theta_17 = link->J_l[0] * ELLA_REAL(1.7320508075688772);
    const ella_real Theta_21 = link->J_l[5] * c->Psi_c_z1;
    const ella_real Theta_22 = link->J_l[5] * c->Psi_c_z2;
    const ella_real Theta_23 = link->J_l[5] * c->Psi_c_z3;
    const ella_real Theta_24 = link->J_l[4] * c->Psi_c_y4;
    const ella_real Theta_25 = link->J_l[4] * c->Psi_c_y5;
    const ella_real Theta_26 = link->J_l[4] * c->Psi_c_y6;
    const ella_real Theta_27 = link->J_l[3] * ELLA_REAL(1.7320508075688772);
    const ella_real Theta_31 = link->J_l[8] * c->Psi_c_z1;
    const ella_real Theta_32 = link->J_l[8] * c->Psi_c_z2;
    const ella_real Theta_33 = link->J_l[8] * c->Psi_c_z3;
    const ella_real Theta_34 = link->J_l[7] * c->Psi_c_y4;
    const ella_real Theta_35 = link->J_l[7] * c->Psi_c_y5;
    const ella_real Theta_36 = link->J_l[7] * c->Psi_c_y6;
    const ella_real Theta_37 = link->J_l[6] * ELLA_REAL(1.7320508075688772);
    const ella_real t10 = link->r_T[1] * tip->Lambda[16];
    const ella_real t11 = link->r_T[0] * tip->Lambda[17];
    const ella_real t12 = c->length * tip->Lambda[19];
    const ella_real M_loaded_14 = tip->Lambda[3] + (t11 - t10);
    const ella_real t13 = tip->Lambda[4] + (link->r_T[0] * tip->Lambda[19] - link->r_T[1] * Lambda_T_55);
    const ella_real t14 = tip->Lambda[5] + (link->r_T[0] * Lambda_T_66 - link->r_T[1] * tip->Lambda[19]);
    const ella_real t15 = tip->Lambda[8] + (link->r_T[1] * Lambda_T_44 - c->length * tip->Lambda[17]);
    const ella_real M_loaded_25 = tip->Lambda[9] + (t10 - t12);
    const ella_real t16 = tip->Lambda[10] + (link->r_T[1] * tip->Lambda[17] - c->length * Lambda_T_66);
    const ella_real t17 = tip->Lambda[12] + (c->length * tip->Lambda[16] - link->r_T[0] * Lambda_T_44);
    const ella_real t18 = tip->Lambda[13] + (c->length * Lambda_T_55 - link->r_T[0] * tip->Lambda[16]);
    const ella_real M_loaded_36 = tip->Lambda[14] + (t12 - t11);
    const ella_real t19 = tip->Lambda[0] - (tip->Lambda[4] * link->r_T[1] - tip->Lambda[5] * link->r_T[0])
        + (link->r_T[0] * t14 - link->r_T[1] * t13);
    const ella_real t20 = tip->Lambda[1] - (tip->Lambda[5] * c->length - tip->Lambda[3] * link->r_T[1])
        + (link->r_T[0] * t16 - link->r_T[1] * M_loaded_25);
    const ella_real t21 = tip->Lambda[2] - (tip->Lambda[3] * link->r_T[0] - tip->Lambda[4] * c->length)
        + (link->r_T[0] * M_loaded_36 - link->r_T[1] * t18);
    const ella_real t22 = tip->Lambda[6] - (tip->Lambda[10] * c->length - tip->Lambda[8] * link->r_T[1])
        + (link->r_T[1] * t15 - c->length * t16);
    const ella_real t23 = tip->Lambda[7] - (tip->Lambda[8] * link->r_T[0] - tip->Lambda[9] * c->length)
        + (link->r_T[1] * t17 - c->length * M_loaded_36);
    const ella_real t24 = tip->Lambda[11] - (tip->Lambda[12] * link->r_T[0] - tip->Lambda[13] * c->length)
        + (c->length * t18 - link->r_T[0] * t17);
    const ella_real M_loaded_11 = I_xx + t19;
    const ella_real M_loaded_12 = t20 - J_xy;
    const ella_real M_loaded_13 = t21 - J_xz;
    const ella_real M_loaded_15 = t13 - S_z;
    const ella_real M_loaded_16 = S_y + t14;
    const ella_real M_loaded_22 = I_yy + t22;
    const ella_real M_loaded_23 = t23 - J_yz;
    const ella_real M_loaded_24 = S_z + t15;
    const ella_real M_loaded_26 = t16 - c->S_0_x;
    const ella_real M_loaded_33 = I_zz + t24;
    const ella_real M_loaded_34 = t17 - S_y;
    const ella_real M_loaded_35 = c->S_0_x + t18;
    const ella_real h_loaded_tau_x = h_V_tau_x + (p_T_tau_x + (link->r_T[0] * p_T_f_z - link->r_T[1] * p_T_f_y));
    const ella_real h_loaded_tau_y = h_V_tau_y + (p_T_tau_y + (link->r_T[1] * p_T_f_x - c->length * p_T_f_z));
    const ella_real h_loaded_tau_z = h_V_tau_z + (p_T_tau_z + (c->length * p_T_f_y - link->r_T[0] * p_T_f_x));
    const ella_real h_loaded_f_x = h_V_f_x + p_T_f_x;
    const ella_real h_loaded_f_y = h_V_f_y + p_T_f_y;
    const ella_real h_loaded_f_z = h_V_f_z + p_T_f_z;
    const ella_real t25 = tip->Lambda[0] * Theta_11 + tip->Lambda[1] * Theta_21 + tip->Lambda[2] * Theta_31
        + tip->Lambda[4] * ELLA_REAL(2.0011941703010714);
    const ella_real t26 = tip->Lambda[0] * Theta_12 + tip->Lambda[1] * Theta_22 + tip->Lambda[2] * Theta_32
        + tip->Lambda[4] * ELLA_REAL(2.0700807911885764);
    const ella_real t27 = tip->Lambda[0] * Theta_13 + tip->Lambda[1] * Theta_23 + tip->Lambda[2] * Theta_33
        + tip->Lambda[4] * ELLA_REAL(3.5651069283690613);
    const ella_real t28 = tip->Lambda[0] * Theta_14 + tip->Lambda[1] * Theta_24 + tip->Lambda[2] * Theta_34
        + tip->Lambda[5] * ELLA_REAL(2.0011941703010714);
    const ella_real t29 = tip->Lambda[0] * Theta_15 + tip->Lambda[1] * Theta_25 + tip->Lambda[2] * Theta_35
        + tip->Lambda[5] * ELLA_REAL(2.0700807911885764);
    const ella_real t30 = tip->Lambda[0] * Theta_16 + tip->Lambda[1] * Theta_26 + tip->Lambda[2] * Theta_36
        + tip->Lambda[5] * ELLA_REAL(3.5651069283690613);
    const ella_real t31 = tip->Lambda[0] * Theta_17 + tip->Lambda[1] * Theta_27 + tip->Lambda[2] * Theta_37;
    const ella_real t32 = tip->Lambda[1] * Theta_11 + tip->Lambda[6] * Theta_21 + tip->Lambda[7] * Theta_31
        + tip->Lambda[9] * ELLA_REAL(2.0011941703010714);
    const ella_real t33 = tip->Lambda[1] * Theta_12 + tip->Lambda[6] * Theta_22 + tip->Lambda[7] * Theta_32
        + tip->Lambda[9] * ELLA_REAL(2.0700807911885764);
    const ella_real t34 = tip->Lambda[1] * Theta_13 + tip->Lambda[6] * Theta_23 + tip->Lambda[7] * Theta_33
        + tip->Lambda[9] * ELLA_REAL(3.5651069283690613);
    const ella_real t35 = tip->Lambda[1] * Theta_14 + tip->Lambda[6] * Theta_24 + tip->Lambda[7] * Theta_34
        + tip->Lambda[10] * ELLA_REAL(2.0011941703010714);
    const ella_real t36 = tip->Lambda[1] * Theta_15 + tip->Lambda[6] * Theta_25 + tip->Lambda[7] * Theta_35
        + tip->Lambda[10] * ELLA_REAL(2.0700807911885764);
    const ella_real t37 = tip->Lambda[1] * Theta_16 + tip->Lambda[6] * Theta_26 + tip->Lambda[7] * Theta_36
        + tip->Lambda[10] * ELLA_REAL(3.5651069283690613);
    const ella_real t38 = tip->Lambda[1] * Theta_17 + tip->Lambda[6] * Theta_27 + tip->Lambda[7] * Theta_37;
    const ella_real t39 = tip->Lambda[2] * Theta_11 + tip->Lambda[7] * Theta_21 + tip->Lambda[11] * Theta_31
        + tip->Lambda[13] * ELLA_REAL(2.0011941703010714);
    const ella_real t40 = tip->Lambda[2] * Theta_12 + tip->Lambda[7] * Theta_22 + tip->Lambda[11] * Theta_32
        + tip->Lambda[13] * ELLA_REAL(2.0700807911885764);
    const ella_real t41 = tip->Lambda[2] * Theta_13 + tip->Lambda[7] * Theta_23 + tip->Lambda[11] * Theta_33
        + tip->Lambda[13] * ELLA_REAL(3.5651069283690613);
    const ella_real t42 = tip->Lambda[2] * Theta_14 + tip->Lambda[7] * Theta_24 + tip->Lambda[11] * Theta_34
        + tip->Lambda[14] * ELLA_REAL(2.0011941703010714);
    const ella_real t43 = tip->Lambda[2] * Theta_15 + tip->Lambda[7] * Theta_25 + tip->Lambda[11] * Theta_35
        + tip->Lambda[14] * ELLA_REAL(2.0700807911885764);
    const ella_real t44 = tip->Lambda[2] * Theta_16 + tip->Lambda[7] * Theta_26 + tip->Lambda[11] * Theta_36
        + tip->Lambda[14] * ELLA_REAL(3.5651069283690613);
    const ella_real t45 = tip->Lambda[2] * Theta_17 + tip->Lambda[7] * Theta_27 + tip->Lambda[11] * Theta_37;
    const ella_real C_41 = tip->Lambda[3] * Theta_11 + tip->Lambda[8] * Theta_21 + tip->Lambda[12] * Theta_31
        + tip->Lambda[16] * ELLA_REAL(2.0011941703010714);
    const ella_real C_42 = tip->Lambda[3] * Theta_12 + tip->Lambda[8] * Theta_22 + tip->Lambda[12] * Theta_32
        + tip->Lambda[16] * ELLA_REAL(2.0700807911885764);
    const ella_real C_43 = tip->Lambda[3] * Theta_13 + tip->Lambda[8] * Theta_23 + tip->Lambda[12] * Theta_33
        + tip->Lambda[16] * ELLA_REAL(3.5651069283690613);
    const ella_real C_44 = tip->Lambda[3] * Theta_14 + tip->Lambda[8] * Theta_24 + tip->Lambda[12] * Theta_34
        + tip->Lambda[17] * ELLA_REAL(2.0011941703010714);
    const ella_real C_45 = tip->Lambda[3] * Theta_15 + tip->Lambda[8] * Theta_25 + tip->Lambda[12] * Theta_35
        + tip->Lambda[17] * ELLA_REAL(2.0700807911885764);
    const ella_real C_46 = tip->Lambda[3] * Theta_16 + tip->Lambda[8] * Theta_26 + tip->Lambda[12] * Theta_36
        + tip->Lambda[17] * ELLA_REAL(3.5651069283690613);
    const ella_real C_47 = tip->Lambda[3] * Theta_17 + tip->Lambda[8] * Theta_27 + tip->Lambda[12] * Theta_37;
    const ella_real t46 = tip->Lambda[4] * Theta_11 + tip->Lambda[9] * Theta_21 + tip->Lambda[13] * Theta_31
        + Lambda_T_55 * ELLA_REAL(2.0011941703010714);
    const ella_real t47 = tip->Lambda[4] * Theta_12 + tip->Lambda[9] * Theta_22 + tip->Lambda[13] * Theta_32
        + Lambda_T_55 * ELLA_REAL(2.0700807911885764);
    const ella_real t48 = tip->Lambda[4] * Theta_13 + tip->Lambda[9] * Theta_23 + tip->Lambda[13] * Theta_33
        + Lambda_T_55 * ELLA_REAL(3.5651069283690613);
    const ella_real t49 = tip->Lambda[19] * ELLA_REAL(2.0011941703010714);
    const ella_real C_54 = tip->Lambda[4] * Theta_14 + tip->Lambda[9] * Theta_24 + tip->Lambda[13] * Theta_34 + t49;
    const ella_real t50 = tip->Lambda[19] * ELLA_REAL(2.0700807911885764);
    const ella_real C_55 = tip->Lambda[4] * Theta_15 + tip->Lambda[9] * Theta_25 + tip->Lambda[13] * Theta_35 + t50;
    const ella_real t51 = tip->Lambda[19] * ELLA_REAL(3.5651069283690613);
    const ella_real C_56 = tip->Lambda[4] * Theta_16 + tip->Lambda[9] * Theta_26 + tip->Lambda[13] * Theta_36 + t51;
    const ella_real C_57 = tip->Lambda[4] * Theta_17 + tip->Lambda[9] * Theta_27 + tip->Lambda[13] * Theta_37;
    const ella_real C_61 = tip->Lambda[5] * Theta_11 + tip->Lambda[10] * Theta_21 + tip->Lambda[14] * Theta_31 + t49;
    const ella_real C_62 = tip->Lambda[5] * Theta_12 + tip->Lambda[10] * Theta_22 + tip->Lambda[14] * Theta_32 + t50;
    const ella_real C_63 = tip->Lambda[5] * Theta_13 + tip->Lambda[10] * Theta_23 + tip->Lambda[14] * Theta_33 + t51;
    const ella_real t52 = tip->Lambda[5] * Theta_14 + tip->Lambda[10] * Theta_24 + tip->Lambda[14] * Theta_34
        + Lambda_T_66 * ELLA_REAL(2.0011941703010714);
    const ella_real t53 = tip->Lambda[5] * Theta_15 + tip->Lambda[10] * Theta_25 + tip->Lambda[14] * Theta_35
        + Lambda_T_66 * ELLA_REAL(2.0700807911885764);
    const ella_real t54 = tip->Lambda[5] * Theta_16 + tip->Lambda[10] * Theta_26 + tip->Lambda[14] * Theta_36
        + Lambda_T_66 * ELLA_REAL(3.5651069283690613);
    const ella_real C_67 = tip->Lambda[5] * Theta_17 + tip->Lambda[10] * Theta_27 + tip->Lambda[14] * Theta_37;
    const ella_real C_21 = t32 + (link->r_T[1] * C_41 - c->length * C_61);
    const ella_real C_22 = t33 + (link->r_T[1] * C_42 - c->length * C_62);
    const ella_real C_23 = t34 + (link->r_T[1] * C_43 - c->length * C_63);
    const ella_real C_34 = t42 + (c->length * C_54 - link->r_T[0] * C_44);
    const ella_real C_35 = t43 + (c->length * C_55 - link->r_T[0] * C_45);
    const ella_real C_36 = t44 + (c->length * C_56 - link->r_T[0] * C_46);
    const ella_real C_27 = t38 + (link->r_T[1] * C_47 - c->length * C_67);
    const ella_real C_37 = t45 + (c->length * C_57 - link->r_T[0] * C_47);
    const ella_real C_11 = t25 + (link->r_T[0] * C_61 - link->r_T[1] * t46) - L_z1;
    const ella_real C_12 = t26 + (link->r_T[0] * C_62 - link->r_T[1] * t47) - L_z2;
    const ella_real C_13 = t27 + (link->r_T[0] * C_63 - link->r_T[1] * t48) - L_z3;
    const ella_real C_14 = L_y1 + (t28 + (link->r_T[0] * t52 - link->r_T[1] * C_54));
    const ella_real C_15 = L_y2 + (t29 + (link->r_T[0] * t53 - link->r_T[1] * C_55));
    const ella_real C_16 = L_y3 + (t30 + (link->r_T[0] * t54 - link->r_T[1] * C_56));
    const ella_real C_17 = c->sigma_t_7 + (t31 + (link->r_T[0] * C_67 - link->r_T[1] * C_57));
    const ella_real C_24 = t35 + (link->r_T[1] * C_44 - c->length * t52) - c->chi_1;
    const ella_real C_25 = t36 + (link->r_T[1] * C_45 - c->length * t53) - c->chi_2;
    const ella_real C_26 = t37 + (link->r_T[1] * C_46 - c->length * t54) - c->chi_3;
    const ella_real C_31 = c->chi_1 + (t39 + (c->length * t46 - link->r_T[0] * C_41));
    const ella_real C_32 = c->chi_2 + (t40 + (c->length * t47 - link->r_T[0] * C_42));
    const ella_real C_33 = c->chi_3 + (t41 + (c->length * t48 - link->r_T[0] * C_43));
    const ella_real C_51 = c->sigma_y1 + t46;
    const ella_real C_52 = c->sigma_y2 + t47;
    const ella_real C_53 = c->sigma_y3 + t48;
    const ella_real C_64 = c->sigma_y1 + t52;
    const ella_real C_65 = c->sigma_y2 + t53;
    const ella_real C_66 = c->sigma_y3 + t54;
    const ella_real modal_inertia_11 = Theta_11 * t25 + Theta_21 * t32 + Theta_31 * t39
        + t46 * ELLA_REAL(2.0011941703010714) + m_eta[0];
    if (!(modal_inertia_11 > 0)) { return ELLA_SINGULAR; }
    const ella_real modal_inertia_12 = Theta_11 * t26 + Theta_21 * t33 + Theta_31 * t40
        + t47 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_13 = Theta_11 * t27 + Theta_21 * t34 + Theta_31 * t41
        + t48 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_14 = Theta_11 * t28 + Theta_21 * t35 + Theta_31 * t42
        + C_54 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_15 = Theta_11 * t29 + Theta_21 * t36 + Theta_31 * t43
        + C_55 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_16 = Theta_11 * t30 + Theta_21 * t37 + Theta_31 * t44
        + C_56 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_17 = Theta_11 * t31 + Theta_21 * t38 + Theta_31 * t45
        + C_57 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_22 = Theta_12 * t26 + Theta_22 * t33 + Theta_32 * t40
        + t47 * ELLA_REAL(2.0700807911885764) + m_eta[1];
    const ella_real modal_inertia_23 = Theta_12 * t27 + Theta_22 * t34 + Theta_32 * t41
        + t48 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_24 = Theta_12 * t28 + Theta_22 * t35 + Theta_32 * t42
        + C_54 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_25 = Theta_12 * t29 + Theta_22 * t36 + Theta_32 * t43
        + C_55 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_26 = Theta_12 * t30 + Theta_22 * t37 + Theta_32 * t44
        + C_56 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_27 = Theta_12 * t31 + Theta_22 * t38 + Theta_32 * t45
        + C_57 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_33 = Theta_13 * t27 + Theta_23 * t34 + Theta_33 * t41
        + t48 * ELLA_REAL(3.5651069283690613) + m_eta[2];
    const ella_real modal_inertia_34 = Theta_13 * t28 + Theta_23 * t35 + Theta_33 * t42
        + C_54 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_35 = Theta_13 * t29 + Theta_23 * t36 + Theta_33 * t43
        + C_55 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_36 = Theta_13 * t30 + Theta_23 * t37 + Theta_33 * t44
        + C_56 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_37 = Theta_13 * t31 + Theta_23 * t38 + Theta_33 * t45
        + C_57 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_44 = Theta_14 * t28 + Theta_24 * t35 + Theta_34 * t42
        + t52 * ELLA_REAL(2.0011941703010714) + m_eta[3];
    const ella_real modal_inertia_45 = Theta_14 * t29 + Theta_24 * t36 + Theta_34 * t43
        + t53 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_46 = Theta_14 * t30 + Theta_24 * t37 + Theta_34 * t44
        + t54 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_47 = Theta_14 * t31 + Theta_24 * t38 + Theta_34 * t45
        + C_67 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_55 = Theta_15 * t29 + Theta_25 * t36 + Theta_35 * t43
        + t53 * ELLA_REAL(2.0700807911885764) + m_eta[4];
    const ella_real modal_inertia_56 = Theta_15 * t30 + Theta_25 * t37 + Theta_35 * t44
        + t54 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_57 = Theta_15 * t31 + Theta_25 * t38 + Theta_35 * t45
        + C_67 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_66 = Theta_16 * t30 + Theta_26 * t37 + Theta_36 * t44
        + t54 * ELLA_REAL(3.5651069283690613) + m_eta[5];
    const ella_real modal_inertia_67 = Theta_16 * t31 + Theta_26 * t38 + Theta_36 * t45
        + C_67 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_77 = Theta_17 * t31 + Theta_27 * t38 + Theta_37 * t45 + m_eta[6];
    const ella_real t55 = Theta_11 * p_T_tau_x + Theta_21 * p_T_tau_y + Theta_31 * p_T_tau_z
        + p_T_f_y * ELLA_REAL(2.0011941703010714);
    const ella_real t56 = Theta_12 * p_T_tau_x + Theta_22 * p_T_tau_y + Theta_32 * p_T_tau_z
        + p_T_f_y * ELLA_REAL(2.0700807911885764);
    const ella_real t57 = Theta_13 * p_T_tau_x + Theta_23 * p_T_tau_y + Theta_33 * p_T_tau_z
        + p_T_f_y * ELLA_REAL(3.5651069283690613);
    const ella_real t58 = Theta_14 * p_T_tau_x + Theta_24 * p_T_tau_y + Theta_34 * p_T_tau_z
        + p_T_f_z * ELLA_REAL(2.0011941703010714);
    const ella_real t59 = Theta_15 * p_T_tau_x + Theta_25 * p_T_tau_y + Theta_35 * p_T_tau_z
        + p_T_f_z * ELLA_REAL(2.0700807911885764);
    const ella_real t60 = Theta_16 * p_T_tau_x + Theta_26 * p_T_tau_y + Theta_36 * p_T_tau_z
        + p_T_f_z * ELLA_REAL(3.5651069283690613);
    const ella_real h_phi_1 = h_eta_1 + f_eta[0] + t55;
    const ella_real h_phi_2 = h_eta_2 + f_eta[1] + t56;
    const ella_real h_phi_3 = h_eta_3 + f_eta[2] + t57;
    const ella_real h_phi_4 = h_eta_4 + f_eta[3] + t58;
    const ella_real h_phi_5 = h_eta_5 + f_eta[4] + t59;
    const ella_real h_phi_6 = h_eta_6 + f_eta[5] + t60;
    const ella_real h_phi_7 = h_eta_7 + f_eta[6] + (Theta_17 * p_T_tau_x + Theta_27 * p_T_tau_y + Theta_37 * p_T_tau_z);
    const ella_real modes_inverse_1 = 1 / modal_inertia_11;
    const ella_real modes_L_21 = modal_inertia_12 * modes_inverse_1;
    link->modes_L[0] = modes_L_21;
    const ella_real modes_L_31 = modal_inertia_13 * modes_inverse_1;
    link->modes_L[1] = modes_L_31;
    const ella_real modes_L_41 = modal_inertia_14 * modes_inverse_1;
    link->modes_L[3] = modes_L_41;
    const ella_real modes_L_51 = modal_inertia_15 * modes_inverse_1;
    link->modes_L[6] = modes_L_51;
    const ella_real modes_L_61 = modal_inertia_16 * modes_inverse_1;
    link->modes_L[10] = modes_L_61;
    const ella_real modes_L_71 = modal_inertia_17 * modes_inverse_1;
    link->modes_L[15] = modes_L_71;
    const ella_real t61 = modal_inertia_22 - modal_inertia_12 * modes_L_21;
    if (!(t61 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_2 = 1 / t61;
    const ella_real t62 = modal_inertia_23 - modal_inertia_12 * modes_L_31;
    const ella_real modes_L_32 = t62 * modes_inverse_2;
    link->modes_L[2] = modes_L_32;
    const ella_real t63 = modal_inertia_24 - modal_inertia_12 * modes_L_41;
    const ella_real modes_L_42 = t63 * modes_inverse_2;
    link->modes_L[4] = modes_L_42;
    const ella_real t64 = modal_inertia_25 - modal_inertia_12 * modes_L_51;
    const ella_real modes_L_52 = t64 * modes_inverse_2;
    link->modes_L[7] = modes_L_52;
    const ella_real t65 = modal_inertia_26 - modal_inertia_12 * modes_L_61;
    const ella_real modes_L_62 = t65 * modes_inverse_2;
    link->modes_L[11] = modes_L_62;
    const ella_real t66 = modal_inertia_27 - modal_inertia_12 * modes_L_71;
    const ella_real modes_L_72 = t66 * modes_inverse_2;
    link->modes_L[16] = modes_L_72;
    const ella_real t67 = modal_inertia_33 - (modal_inertia_13 * modes_L_31 + t62 * modes_L_32);
    if (!(t67 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_3 = 1 / t67;
    const ella_real t68 = modal_inertia_34 - (modal_inertia_13 * modes_L_41 + t62 * modes_L_42);
    const ella_real modes_L_43 = t68 * modes_inverse_3;
    link->modes_L[5] = modes_L_43;
    const ella_real t69 = modal_inertia_35 - (modal_inertia_13 * modes_L_51 + t62 * modes_L_52);
    const ella_real modes_L_53 = t69 * modes_inverse_3;
    link->modes_L[8] = modes_L_53;
    const ella_real t70 = modal_inertia_36 - (modal_inertia_13 * modes_L_61 + t62 * modes_L_62);
    const ella_real modes_L_63 = t70 * modes_inverse_3;
    link->modes_L[12] = modes_L_63;
    const ella_real t71 = modal_inertia_37 - (modal_inertia_13 * modes_L_71 + t62 * modes_L_72);
    const ella_real modes_L_73 = t71 * modes_inverse_3;
    link->modes_L[17] = modes_L_73;
    const ella_real t72 = modal_inertia_44 - (modal_inertia_14 * modes_L_41 + t63 * modes_L_42 + t68 * modes_L_43);
    if (!(t72 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_4 = 1 / t72;
    const ella_real t73 = modal_inertia_45 - (modal_inertia_14 * modes_L_51 + t63 * modes_L_52 + t68 * modes_L_53);
    const ella_real modes_L_54 = t73 * modes_inverse_4;
    link->modes_L[9] = modes_L_54;
    const ella_real t74 = modal_inertia_46 - (modal_inertia_14 * modes_L_61 + t63 * modes_L_62 + t68 * modes_L_63);
    const ella_real modes_L_64 = t74 * modes_inverse_4;
    link->modes_L[13] = modes_L_64;
    const ella_real t75 = modal_inertia_47 - (modal_inertia_14 * modes_L_71 + t63 * modes_L_72 + t68 * modes_L_73);
    const ella_real modes_L_74 = t75 * modes_inverse_4;
    link->modes_L[18] = modes_L_74;
    const ella_real t76 = modal_inertia_55
        - (modal_inertia_15 * modes_L_51 + t64 * modes_L_52 + t69 * modes_L_53 + t73 * modes_L_54);
    if (!(t76 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_5 = 1 / t76;
    const ella_real t77 = modal_inertia_56
        - (modal_inertia_15 * modes_L_61 + t64 * modes_L_62 + t69 * modes_L_63 + t73 * modes_L_64);
    const ella_real modes_L_65 = t77 * modes_inverse_5;
    link->modes_L[14] = modes_L_65;
    const ella_real t78 = modal_inertia_57
        - (modal_inertia_15 * modes_L_71 + t64 * modes_L_72 + t69 * modes_L_73 + t73 * modes_L_74);
    const ella_real modes_L_75 = t78 * modes_inverse_5;
    link->modes_L[19] = modes_L_75;
    const ella_real t79 = modal_inertia_16 * modes_L_61 + t65 * modes_L_62 + t70 * modes_L_63 + t74 * modes_L_64
        + t77 * modes_L_65;
    const ella_real t80 = modal_inertia_66 - t79;
    if (!(t80 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_6 = 1 / t80;
    const ella_real t81 = modal_inertia_16 * modes_L_71 + t65 * modes_L_72 + t70 * modes_L_73 + t74 * modes_L_74
        + t77 * modes_L_75;
    const ella_real t82 = modal_inertia_67 - t81;
    const ella_real modes_L_76 = t82 * modes_inverse_6;
    link->modes_L[20] = modes_L_76;
    const ella_real t83 = modal_inertia_17 * modes_L_71 + t66 * modes_L_72 + t71 * modes_L_73 + t75 * modes_L_74
        + t78 * modes_L_75;
    const ella_real t84 = modal_inertia_77 - (t83 + t82 * modes_L_76);
    if (!(t84 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_7 = 1 / t84;
    const ella_real t85 = C_12 - modes_L_21 * C_11;
    const ella_real t86 = C_22 - modes_L_21 * C_21;
    const ella_real t87 = C_32 - modes_L_21 * C_31;
    const ella_real t88 = C_42 - modes_L_21 * C_41;
    const ella_real t89 = C_52 - modes_L_21 * C_51;
    const ella_real t90 = C_62 - modes_L_21 * C_61;
    const ella_real t91 = C_13 - modes_L_31 * C_11 - modes_L_32 * t85;
    const ella_real t92 = C_23 - modes_L_31 * C_21 - modes_L_32 * t86;
    const ella_real t93 = C_33 - modes_L_31 * C_31 - modes_L_32 * t87;
    const ella_real t94 = C_43 - modes_L_31 * C_41 - modes_L_32 * t88;
    const ella_real t95 = C_53 - modes_L_31 * C_51 - modes_L_32 * t89;
    const ella_real t96 = C_63 - modes_L_31 * C_61 - modes_L_32 * t90;
    const ella_real t97 = C_14 - modes_L_41 * C_11 - modes_L_42 * t85 - modes_L_43 * t91;
    const ella_real t98 = C_24 - modes_L_41 * C_21 - modes_L_42 * t86 - modes_L_43 * t92;
    const ella_real t99 = C_34 - modes_L_41 * C_31 - modes_L_42 * t87 - modes_L_43 * t93;
    const ella_real t100 = C_44 - modes_L_41 * C_41 - modes_L_42 * t88 - modes_L_43 * t94;
    const ella_real t101 = C_54 - modes_L_41 * C_51 - modes_L_42 * t89 - modes_L_43 * t95;
    const ella_real t102 = C_64 - modes_L_41 * C_61 - modes_L_42 * t90 - modes_L_43 * t96;
    const ella_real t103 = C_15 - modes_L_51 * C_11 - modes_L_52 * t85 - modes_L_53 * t91 - modes_L_54 * t97;
    const ella_real t104 = C_25 - modes_L_51 * C_21 - modes_L_52 * t86 - modes_L_53 * t92 - modes_L_54 * t98;
    const ella_real t105 = C_35 - modes_L_51 * C_31 - modes_L_52 * t87 - modes_L_53 * t93 - modes_L_54 * t99;
    const ella_real t106 = C_45 - modes_L_51 * C_41 - modes_L_52 * t88 - modes_L_53 * t94 - modes_L_54 * t100;
    const ella_real t107 = C_55 - modes_L_51 * C_51 - modes_L_52 * t89 - modes_L_53 * t95 - modes_L_54 * t101;
    const ella_real t108 = C_65 - modes_L_51 * C_61 - modes_L_52 * t90 - modes_L_53 * t96 - modes_L_54 * t102;
    const ella_real t109 = C_16 - modes_L_61 * C_11 - modes_L_62 * t85 - modes_L_63 * t91 - modes_L_64 * t97
        - modes_L_65 * t103;
    const ella_real t110 = C_26 - modes_L_61 * C_21 - modes_L_62 * t86 - modes_L_63 * t92 - modes_L_64 * t98
        - modes_L_65 * t104;
    const ella_real t111 = C_36 - modes_L_61 * C_31 - modes_L_62 * t87 - modes_L_63 * t93 - modes_L_64 * t99
        - modes_L_65 * t105;
    const ella_real t112 = C_46 - modes_L_61 * C_41 - modes_L_62 * t88 - modes_L_63 * t94 - modes_L_64 * t100
        - modes_L_65 * t106;
    const ella_real t113 = C_56 - modes_L_61 * C_51 - modes_L_62 * t89 - modes_L_63 * t95 - modes_L_64 * t101
        - modes_L_65 * t107;
    const ella_real t114 = C_66 - modes_L_61 * C_61 - modes_L_62 * t90 - modes_L_63 * t96 - modes_L_64 * t102
        - modes_L_65 * t108;
    const ella_real t115 = C_17 - modes_L_71 * C_11 - modes_L_72 * t85 - modes_L_73 * t91 - modes_L_74 * t97
        - modes_L_75 * t103;
    const ella_real t116 = C_27 - modes_L_71 * C_21 - modes_L_72 * t86 - modes_L_73 * t92 - modes_L_74 * t98
        - modes_L_75 * t104;
    const ella_real t117 = C_37 - modes_L_71 * C_31 - modes_L_72 * t87 - modes_L_73 * t93 - modes_L_74 * t99
        - modes_L_75 * t105;
    const ella_real t118 = C_47 - modes_L_71 * C_41 - modes_L_72 * t88 - modes_L_73 * t94 - modes_L_74 * t100
        - modes_L_75 * t106;
    const ella_real t119 = C_57 - modes_L_71 * C_51 - modes_L_72 * t89 - modes_L_73 * t95 - modes_L_74 * t101
        - modes_L_75 * t107;
    const ella_real t120 = C_67 - modes_L_71 * C_61 - modes_L_72 * t90 - modes_L_73 * t96 - modes_L_74 * t102
        - modes_L_75 * t108;
    const ella_real t121 = t115 - modes_L_76 * t109;
    const ella_real t122 = t116 - modes_L_76 * t110;
    const ella_real t123 = t117 - modes_L_76 * t111;
    const ella_real t124 = h_phi_2 - modes_L_21 * h_phi_1;
    const ella_real t125 = h_phi_3 - modes_L_31 * h_phi_1 - modes_L_32 * t124;
    const ella_real t126 = h_phi_4 - modes_L_41 * h_phi_1 - modes_L_42 * t124 - modes_L_43 * t125;
    const ella_real t127 = h_phi_5 - modes_L_51 * h_phi_1 - modes_L_52 * t124 - modes_L_53 * t125 - modes_L_54 * t126;
    const ella_real t128 = h_phi_6 - modes_L_61 * h_phi_1 - modes_L_62 * t124 - modes_L_63 * t125 - modes_L_64 * t126
        - modes_L_65 * t127;
    const ella_real t129 = h_phi_7 - modes_L_71 * h_phi_1 - modes_L_72 * t124 - modes_L_73 * t125 - modes_L_74 * t126
        - modes_L_75 * t127;
    const ella_real t130 = t129 - modes_L_76 * t128;
    const ella_real modes_W_11 = C_11 * modes_inverse_1;
    link->modes_W[0] = modes_W_11;
    const ella_real modes_W_12 = C_21 * modes_inverse_1;
    link->modes_W[1] = modes_W_12;
    const ella_real modes_W_13 = C_31 * modes_inverse_1;
    link->modes_W[2] = modes_W_13;
    const ella_real modes_W_14 = C_41 * modes_inverse_1;
    const ella_real modes_W_15 = C_51 * modes_inverse_1;
    const ella_real modes_W_16 = C_61 * modes_inverse_1;
    const ella_real modes_W_21 = t85 * modes_inverse_2;
    link->modes_W[6] = modes_W_21;
    const ella_real modes_W_22 = t86 * modes_inverse_2;
    link->modes_W[7] = modes_W_22;
    const ella_real modes_W_23 = t87 * modes_inverse_2;
    link->modes_W[8] = modes_W_23;
    const ella_real modes_W_24 = t88 * modes_inverse_2;
    const ella_real modes_W_25 = t89 * modes_inverse_2;
    const ella_real modes_W_26 = t90 * modes_inverse_2;
    const ella_real modes_W_31 = t91 * modes_inverse_3;
    link->modes_W[12] = modes_W_31;
    const ella_real modes_W_32 = t92 * modes_inverse_3;
    link->modes_W[13] = modes_W_32;
    const ella_real modes_W_33 = t93 * modes_inverse_3;
    link->modes_W[14] = modes_W_33;
    const ella_real modes_W_34 = t94 * modes_inverse_3;
    const ella_real modes_W_35 = t95 * modes_inverse_3;
    const ella_real modes_W_36 = t96 * modes_inverse_3;
    const ella_real modes_W_41 = t97 * modes_inverse_4;
    link->modes_W[18] = modes_W_41;
    const ella_real modes_W_42 = t98 * modes_inverse_4;
    link->modes_W[19] = modes_W_42;
    const ella_real modes_W_43 = t99 * modes_inverse_4;
    link->modes_W[20] = modes_W_43;
    const ella_real modes_W_44 = t100 * modes_inverse_4;
    const ella_real modes_W_45 = t101 * modes_inverse_4;
    const ella_real modes_W_46 = t102 * modes_inverse_4;
    const ella_real modes_W_51 = t103 * modes_inverse_5;
    link->modes_W[24] = modes_W_51;
    const ella_real modes_W_52 = t104 * modes_inverse_5;
    link->modes_W[25] = modes_W_52;
    const ella_real modes_W_53 = t105 * modes_inverse_5;
    link->modes_W[26] = modes_W_53;
    const ella_real modes_W_54 = t106 * modes_inverse_5;
    const ella_real modes_W_55 = t107 * modes_inverse_5;
    const ella_real modes_W_56 = t108 * modes_inverse_5;
    const ella_real modes_W_61 = t109 * modes_inverse_6;
    link->modes_W[30] = modes_W_61;
    const ella_real modes_W_62 = t110 * modes_inverse_6;
    link->modes_W[31] = modes_W_62;
    const ella_real modes_W_63 = t111 * modes_inverse_6;
    link->modes_W[32] = modes_W_63;
    const ella_real modes_W_64 = t112 * modes_inverse_6;
    const ella_real modes_W_65 = t113 * modes_inverse_6;
    const ella_real modes_W_66 = t114 * modes_inverse_6;
    const ella_real modes_W_71 = t121 * modes_inverse_7;
    link->modes_W[36] = modes_W_71;
    const ella_real modes_W_72 = t122 * modes_inverse_7;
    link->modes_W[37] = modes_W_72;
    const ella_real modes_W_73 = t123 * modes_inverse_7;
    link->modes_W[38] = modes_W_73;
    const ella_real modes_W_74 = (t118 - modes_L_76 * t112) * modes_inverse_7;
    const ella_real modes_W_75 = (t119 - modes_L_76 * t113) * modes_inverse_7;
    const ella_real modes_W_76 = (t120 - modes_L_76 * t114) * modes_inverse_7;
    const ella_real modes_w_1 = h_phi_1 * modes_inverse_1;
    link->modes_w[0] = modes_w_1;
    const ella_real modes_w_2 = t124 * modes_inverse_2;
    link->modes_w[1] = modes_w_2;
    const ella_real modes_w_3 = t125 * modes_inverse_3;
    link->modes_w[2] = modes_w_3;
    const ella_real modes_w_4 = t126 * modes_inverse_4;
    link->modes_w[3] = modes_w_4;
    const ella_real modes_w_5 = t127 * modes_inverse_5;
    link->modes_w[4] = modes_w_5;
    const ella_real modes_w_6 = t128 * modes_inverse_6;
    link->modes_w[5] = modes_w_6;
    const ella_real modes_w_7 = t130 * modes_inverse_7;
    link->modes_w[6] = modes_w_7;
    const ella_real t131 = C_11 * modes_W_11 + t85 * modes_W_21 + t91 * modes_W_31 + t97 * modes_W_41
        + t103 * modes_W_51 + t109 * modes_W_61;
    const ella_real M_i_11 = M_loaded_11 - (t131 + t121 * modes_W_71);
    const ella_real t132 = C_11 * modes_W_12 + t85 * modes_W_22 + t91 * modes_W_32 + t97 * modes_W_42
        + t103 * modes_W_52 + t109 * modes_W_62;
    const ella_real M_i_12 = M_loaded_12 - (t132 + t121 * modes_W_72);
    const ella_real t133 = C_11 * modes_W_13 + t85 * modes_W_23 + t91 * modes_W_33 + t97 * modes_W_43
        + t103 * modes_W_53 + t109 * modes_W_63;
    const ella_real M_i_13 = M_loaded_13 - (t133 + t121 * modes_W_73);
    const ella_real t134 = C_11 * modes_W_14 + t85 * modes_W_24 + t91 * modes_W_34 + t97 * modes_W_44
        + t103 * modes_W_54 + t109 * modes_W_64;
    const ella_real M_i_14 = M_loaded_14 - (t134 + t121 * modes_W_74);
    const ella_real t135 = C_11 * modes_W_15 + t85 * modes_W_25 + t91 * modes_W_35 + t97 * modes_W_45
        + t103 * modes_W_55 + t109 * modes_W_65;
    const ella_real M_i_15 = M_loaded_15 - (t135 + t121 * modes_W_75);
    const ella_real t136 = C_11 * modes_W_16 + t85 * modes_W_26 + t91 * modes_W_36 + t97 * modes_W_46
        + t103 * modes_W_56 + t109 * modes_W_66;
    const ella_real M_i_16 = M_loaded_16 - (t136 + t121 * modes_W_76);
    const ella_real t137 = C_21 * modes_W_12 + t86 * modes_W_22 + t92 * modes_W_32 + t98 * modes_W_42
        + t104 * modes_W_52 + t110 * modes_W_62;
    const ella_real M_i_22 = M_loaded_22 - (t137 + t122 * modes_W_72);
    const ella_real t138 = C_21 * modes_W_13 + t86 * modes_W_23 + t92 * modes_W_33 + t98 * modes_W_43
        + t104 * modes_W_53 + t110 * modes_W_63;
    const ella_real M_i_23 = M_loaded_23 - (t138 + t122 * modes_W_73);
    const ella_real t139 = C_21 * modes_W_14 + t86 * modes_W_24 + t92 * modes_W_34 + t98 * modes_W_44
        + t104 * modes_W_54 + t110 * modes_W_64;
    const ella_real M_i_24 = M_loaded_24 - (t139 + t122 * modes_W_74);
    const ella_real t140 = C_21 * modes_W_15 + t86 * modes_W_25 + t92 * modes_W_35 + t98 * modes_W_45
        + t104 * modes_W_55 + t110 * modes_W_65;
    const ella_real M_i_25 = M_loaded_25 - (t140 + t122 * modes_W_75);
    const ella_real t141 = C_21 * modes_W_16 + t86 * modes_W_26 + t92 * modes_W_36 + t98 * modes_W_46
        + t104 * modes_W_56 + t110 * modes_W_66;
    const ella_real M_i_26 = M_loaded_26 - (t141 + t122 * modes_W_76);
    const ella_real t142 = C_31 * modes_W_13 + t87 * modes_W_23 + t93 * modes_W_33 + t99 * modes_W_43
        + t105 * modes_W_53 + t111 * modes_W_63;
    const ella_real M_i_33 = M_loaded_33 - (t142 + t123 * modes_W_73);
    const ella_real t143 = C_31 * modes_W_14 + t87 * modes_W_24 + t93 * modes_W_34 + t99 * modes_W_44
        + t105 * modes_W_54 + t111 * modes_W_64;
    const ella_real M_i_34 = M_loaded_34 - (t143 + t123 * modes_W_74);
    const ella_real t144 = C_31 * modes_W_15 + t87 * modes_W_25 + t93 * modes_W_35 + t99 * modes_W_45
        + t105 * modes_W_55 + t111 * modes_W_65;
    const ella_real M_i_35 = M_loaded_35 - (t144 + t123 * modes_W_75);
    const ella_real t145 = C_31 * modes_W_16 + t87 * modes_W_26 + t93 * modes_W_36 + t99 * modes_W_46
        + t105 * modes_W_56 + t111 * modes_W_66;
    const ella_real M_i_36 = M_loaded_36 - (t145 + t123 * modes_W_76);
    const ella_real t146 = modes_W_11 * h_phi_1 + modes_W_21 * t124 + modes_W_31 * t125 + modes_W_41 * t126
        + modes_W_51 * t127;
    const ella_real t147 = modes_W_12 * h_phi_1 + modes_W_22 * t124 + modes_W_32 * t125 + modes_W_42 * t126
        + modes_W_52 * t127;
    const ella_real t148 = modes_W_13 * h_phi_1 + modes_W_23 * t124 + modes_W_33 * t125 + modes_W_43 * t126
        + modes_W_53 * t127;
    const ella_real t149 = modes_W_14 * h_phi_1 + modes_W_24 * t124 + modes_W_34 * t125 + modes_W_44 * t126
        + modes_W_54 * t127;
    const ella_real t150 = modes_W_15 * h_phi_1 + modes_W_25 * t124 + modes_W_35 * t125 + modes_W_45 * t126
        + modes_W_55 * t127;
    const ella_real t151 = modes_W_16 * h_phi_1 + modes_W_26 * t124 + modes_W_36 * t125 + modes_W_46 * t126
        + modes_W_56 * t127;
    const ella_real h_i_tau_x = h_loaded_tau_x - (t146 + modes_W_61 * t128 + modes_W_71 * t130);
    const ella_real h_i_tau_y = h_loaded_tau_y - (t147 + modes_W_62 * t128 + modes_W_72 * t130);
    const ella_real h_i_tau_z = h_loaded_tau_z - (t148 + modes_W_63 * t128 + modes_W_73 * t130);
    const ella_real h_i_f_x = h_loaded_f_x - (t149 + modes_W_64 * t128 + modes_W_74 * t130);
    const ella_real h_i_f_y = h_loaded_f_y - (t150 + modes_W_65 * t128 + modes_W_75 * t130);
    const ella_real h_i_f_z = h_loaded_f_z - (t151 + modes_W_66 * t128 + modes_W_76 * t130);

    /* joint: its accelerations eliminated from its rows (43) */
    const ella_real U_11 = M_i_11 * link->S[0] + M_i_12 * link->S[1];
    const ella_real U_21 = M_i_12 * link->S[0] + M_i_22 * link->S[1];
    const ella_real U_31 = M_i_13 * link->S[0] + M_i_23 * link->S[1];
    const ella_real U_41 = M_i_14 * link->S[0] + M_i_24 * link->S[1];
    const ella_real U_51 = M_i_15 * link->S[0] + M_i_25 * link->S[1];
    const ella_real U_61 = M_i_16 * link->S[0] + M_i_26 * link->S[1];
    const ella_real joint_inertia_11 = link->S[0] * U_11 + link->S[1] * U_21;
    const ella_real t152 = ELLA_REAL_EPSILON * 8 * (M_i_11 + M_i_22 + M_i_33);
    if (!(joint_inertia_11 - t152 > 0)) { return ELLA_SINGULAR; }
    const ella_real joint_inverse_1 = 1 / joint_inertia_11;
    const ella_real joint_L_21 = U_31 * joint_inverse_1;
    link->joint_L[0] = joint_L_21;
    const ella_real t153 = M_i_33 - U_31 * joint_L_21;
    if (!(t153 - t152 > 0)) { return ELLA_SINGULAR; }
    const ella_real joint_inverse_2 = 1 / t153;
    const ella_real t154 = tau[0] - (link->S[0] * h_i_tau_x + link->S[1] * h_i_tau_y);
    const ella_real t155 = tau[1] - h_i_tau_z - joint_L_21 * t154;
    const ella_real joint_w_1 = t154 * joint_inverse_1;
    link->joint_w[0] = joint_w_1;
    const ella_real joint_w_2 = t155 * joint_inverse_2;
    link->joint_w[1] = joint_w_2;
    const ella_real p_i_tau_x = h_i_tau_x + (U_11 * joint_w_1 + (M_i_13 - joint_L_21 * U_11) * joint_w_2);
    link->p_i[0] = p_i_tau_x;
    const ella_real p_i_tau_y = h_i_tau_y + (U_21 * joint_w_1 + (M_i_23 - joint_L_21 * U_21) * joint_w_2);
    link->p_i[1] = p_i_tau_y;
    const ella_real p_i_tau_z = h_i_tau_z + (U_31 * joint_w_1 + t155);
    link->p_i[2] = p_i_tau_z;
    const ella_real p_i_f_x = h_i_f_x + (U_41 * joint_w_1 + (M_i_34 - joint_L_21 * U_41) * joint_w_2);
    link->p_i[3] = p_i_f_x;
    const ella_real p_i_f_y = h_i_f_y + (U_51 * joint_w_1 + (M_i_35 - joint_L_21 * U_51) * joint_w_2);
    link->p_i[4] = p_i_f_y;
    const ella_real p_i_f_z = h_i_f_z + (U_61 * joint_w_1 + (M_i_36 - joint_L_21 * U_61) * joint_w_2);
    link->p_i[5] = p_i_f_z;
    return ELLA_OK;
}

/* eliminate, links like forearm: 902 operations */
ELLA_PART ella_status eliminate_forearm(const ella_link_constants *restrict c, ella_link_store *restrict link,
    ella_node *restrict base, const ella_node *restrict tip, const ella_real eta[restrict 7],
    const ella_real etadot[restrict 7], const ella_real w_ext[restrict 6], const ella_real m_eta[restrict 7],
    const ella_real f_eta[restrict 7], const ella_real tau[restrict 1])
{
    /* S: first moment */
    const ella_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2 + eta[2] * c->sigma_y3;
    const ella_real S_z = eta[3] * c->sigma_y1 + eta[4] * c->sigma_y2 + eta[5] * c->sigma_y3;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2 + etadot[2] * c->sigma_y3;
    const ella_real Sdot_z = etadot[3] * c->sigma_y1 + etadot[4] * c->sigma_y2 + etadot[5] * c->sigma_y3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_y1 = c->mu * eta[0];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_y3 = c->mu * eta[2];
    const ella_real L_z1 = eta[3] * c->mu;
    const ella_real L_z2 = eta[4] * c->mu;
    const ella_real L_z3 = eta[5] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_y1 = c->mu * etadot[0];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_y3 = c->mu * etadot[2];
    const ella_real Ldot_z1 = etadot[3] * c->mu;
    const ella_real Ldot_z2 = etadot[4] * c->mu;
    const ella_real Ldot_z3 = etadot[5] * c->mu;

    /* J: second moment */
    const ella_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1] + c->chi_3 * eta[2];
    const ella_real J_xz = c->chi_1 * eta[3] + c->chi_2 * eta[4] + c->chi_3 * eta[5];
    const ella_real J_yy = L_y1 * eta[0] + L_y2 * eta[1] + L_y3 * eta[2];
    const ella_real J_yz = L_z1 * eta[0] + L_z2 * eta[1] + L_z3 * eta[2];
    const ella_real J_zz = L_z1 * eta[3] + L_z2 * eta[4] + L_z3 * eta[5];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = c->J_0_xx + J_zz;
    const ella_real I_zz = c->J_0_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const ella_real t1 = link->omega[1] * link->omega[1];
    const ella_real t2 = link->omega[2] * link->omega[2];
    const ella_real minus_Omega_xx = t1 + t2;
    const ella_real t3 = link->omega[0] * link->omega[1];
    const ella_real Omega_xy = t3 - link->acc_0[2];
    const ella_real t4 = link->omega[0] * link->omega[2];
    const ella_real Omega_xz = link->acc_0[1] + t4;
    const ella_real Omega_yx = link->acc_0[2] + t3;
    const ella_real t5 = link->omega[0] * link->omega[0];
    const ella_real minus_Omega_yy = t5 + t2;
    const ella_real t6 = link->omega[1] * link->omega[2];
    const ella_real Omega_yz = t6 - link->acc_0[0];
    const ella_real Omega_zx = t4 - link->acc_0[1];
    const ella_real Omega_zy = link->acc_0[0] + t6;
    const ella_real minus_Omega_zz = t5 + t1;

    /* B: moment of the elastic velocity */
    const ella_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1] + c->chi_3 * etadot[2];
    const ella_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1] + L_y3 * etadot[2];
    const ella_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1] + L_z3 * etadot[2];
    const ella_real B_zx = c->chi_1 * etadot[3] + c->chi_2 * etadot[4] + c->chi_3 * etadot[5];
    const ella_real B_zy = L_y1 * etadot[3] + L_y2 * etadot[4] + L_y3 * etadot[5];
    const ella_real B_zz = L_z1 * etadot[3] + L_z2 * etadot[4] + L_z3 * etadot[5];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const ella_real h_c_tau_x = B_yy * link->omega[0] + B_zz * link->omega[0];
    const ella_real h_c_tau_y = B_zz * link->omega[1] - B_yx * link->omega[0] - B_yz * link->omega[2];
    const ella_real h_c_tau_z = B_yy * link->omega[2] - B_zx * link->omega[0] - B_zy * link->omega[1];
    const ella_real h_c_f_x = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
    const ella_real minus_h_c_f_y = Sdot_z * link->omega[0];
    const ella_real h_c_f_z = Sdot_y * link->omega[0];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const ella_real h_MD_tau_y = h_c_tau_y + etadot[6] * link->omega[2] * c->sigma_t_7;
    const ella_real h_MD_tau_z = h_c_tau_z - etadot[6] * link->omega[1] * c->sigma_t_7;

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t7 = h_c_tau_x + c->I_s * link->acc_0[0] + J_xy * Omega_zx + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const ella_real H_star_tau_x = t7 + S_y * link->acc_0[5] - J_xz * Omega_yx - J_zz * Omega_yz - S_z * link->acc_0[4];
    const ella_real t8 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->acc_0[3];
    const ella_real t9 = c->I_s * link->omega[0];
    const ella_real H_star_tau_y = t8 + t9 * link->omega[2] - c->J_0_xx * Omega_zx - J_xy * Omega_zy
        - c->S_0_x * link->acc_0[5];
    const ella_real t10 = h_c_tau_z + c->J_0_xx * Omega_yx + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * link->acc_0[4];
    const ella_real H_star_tau_z = t10 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->acc_0[3] - t9 * link->omega[1];
    const ella_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + link->acc_0[3] * c->mu;
    const ella_real H_star_f_y = Omega_yx * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + link->acc_0[4] * c->mu;
    const ella_real H_star_f_z = h_c_f_z + Omega_zx * c->S_0_x + Omega_zy * S_y - minus_Omega_zz * S_z
        + link->acc_0[5] * c->mu;

    /* h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const ella_real h_V_tau_y = H_star_tau_y + h_MD_tau_y;
    const ella_real h_V_tau_z = H_star_tau_z + h_MD_tau_z;
    const ella_real h_V_f_x = H_star_f_x + h_c_f_x;
    const ella_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const ella_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_yx * c->chi_1
        + link->acc_0[4] * c->sigma_y1 - Ldot_z1 * 2 * link->omega[0];
    const ella_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_yx * c->chi_2
        + link->acc_0[4] * c->sigma_y2 - Ldot_z2 * 2 * link->omega[0];
    const ella_real h_eta_3 = L_z3 * Omega_yz - L_y3 * minus_Omega_yy + Omega_yx * c->chi_3
        + link->acc_0[4] * c->sigma_y3 - Ldot_z3 * 2 * link->omega[0];
    const ella_real h_eta_4 = L_y1 * Omega_zy - L_z1 * minus_Omega_zz + Omega_zx * c->chi_1
        + link->acc_0[5] * c->sigma_y1 + Ldot_y1 * 2 * link->omega[0];
    const ella_real h_eta_5 = L_y2 * Omega_zy - L_z2 * minus_Omega_zz + Omega_zx * c->chi_2
        + link->acc_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];
    const ella_real h_eta_6 = L_y3 * Omega_zy - L_z3 * minus_Omega_zz + Omega_zx * c->chi_3
        + link->acc_0[5] * c->sigma_y3 + Ldot_y3 * 2 * link->omega[0];
    const ella_real h_eta_7 = link->acc_0[0] * c->sigma_t_7;

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real minus_p_T_tau_x = link->R_T[0] * w_ext[0] + link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2];
    const ella_real minus_p_T_tau_y = link->R_T[3] * w_ext[0] + link->R_T[4] * w_ext[1] + link->R_T[5] * w_ext[2];
    const ella_real minus_p_T_tau_z = link->R_T[6] * w_ext[0] + link->R_T[7] * w_ext[1] + link->R_T[8] * w_ext[2];
    const ella_real p_T_f_x = c->body0_mass * tip->acc_0[3]
        - (link->R_T[0] * w_ext[3] + link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const ella_real p_T_f_y = c->body0_mass * tip->acc_0[4]
        - (link->R_T[3] * w_ext[3] + link->R_T[4] * w_ext[4] + link->R_T[5] * w_ext[5]);
    const ella_real p_T_f_z = c->body0_mass * tip->acc_0[5]
        - (link->R_T[6] * w_ext[3] + link->R_T[7] * w_ext[4] + link->R_T[8] * w_ext[5]);

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real Theta_11 = link->J_l[2] * c->Psi_c_z1;
    const ella_real Theta_12 = link->J_l[2] * c->Psi_c_z2;
    const ella_real Theta_13 = link->J_l[2] * c->Psi_c_z3;
    const ella_real Theta_14 = link->J_l[1] * c->Psi_c_y4;
    const ella_real Theta_15 = link->J_l[1] * c->Psi_c_y5;
    const ella_real Theta_16 = link->J_l[1] * c->Psi_c_y6;
    const ella_real Theta_17 = link->J_l[0] * ELLA_REAL(1.7320508075688772);
    const ella_real Theta_21 = link->J_l[5] * c->Psi_c_z1;
    const ella_real Theta_22 = link->J_l[5] * c->Psi_c_z2;
    const ella_real Theta_23 = link->J_l[5] * c->Psi_c_z3;
    const ella_real Theta_24 = link->J_l[4] * c->Psi_c_y4;
    const ella_real Theta_25 = link->J_l[4] * c->Psi_c_y5;
    const ella_real Theta_26 = link->J_l[4] * c->Psi_c_y6;
    const ella_real Theta_27 = link->J_l[3] * ELLA_REAL(1.7320508075688772);
    const ella_real Theta_31 = link->J_l[8] * c->Psi_c_z1;
    const ella_real Theta_32 = link->J_l[8] * c->Psi_c_z2;
    const ella_real Theta_33 = link->J_l[8] * c->Psi_c_z3;
    const ella_real Theta_34 = link->J_l[7] * c->Psi_c_y4;
    const ella_real Theta_35 = link->J_l[7] * c->Psi_c_y5;
    const ella_real Theta_36 = link->J_l[7] * c->Psi_c_y6;
    const ella_real Theta_37 = link->J_l[6] * ELLA_REAL(1.7320508075688772);
    const ella_real t11 = link->r_T[1] * c->body0_mass;
    const ella_real t12 = link->r_T[0] * c->body0_mass;
    const ella_real t13 = -(c->length * c->body0_mass);
    const ella_real t14 = link->r_T[1] * t11;
    const ella_real t15 = link->r_T[0] * t12;
    const ella_real t16 = -(c->length * t13);
    const ella_real M_loaded_11 = I_xx + (t15 + t14);
    const ella_real minus_M_loaded_12 = -(link->r_T[0] * t13) + J_xy;
    const ella_real M_loaded_13 = link->r_T[1] * t13 - J_xz;
    const ella_real M_loaded_24 = t11 + S_z;
    const ella_real M_loaded_16 = S_y + t12;
    const ella_real M_loaded_22 = I_yy + (t14 + t16);
    const ella_real minus_M_loaded_23 = link->r_T[1] * t12 + J_yz;
    const ella_real M_loaded_35 = c->S_0_x - t13;
    const ella_real M_loaded_33 = I_zz + (t16 + t15);
    const ella_real M_loaded_44 = c->mu + c->body0_mass;
    const ella_real h_loaded_tau_x = h_V_tau_x + (link->r_T[0] * p_T_f_z - link->r_T[1] * p_T_f_y - minus_p_T_tau_x);
    const ella_real h_loaded_tau_y = h_V_tau_y + (link->r_T[1] * p_T_f_x - c->length * p_T_f_z - minus_p_T_tau_y);
    const ella_real h_loaded_tau_z = h_V_tau_z + (c->length * p_T_f_y - link->r_T[0] * p_T_f_x - minus_p_T_tau_z);
    const ella_real h_loaded_f_x = h_V_f_x + p_T_f_x;
    const ella_real h_loaded_f_y = h_V_f_y + p_T_f_y;
    const ella_real h_loaded_f_z = h_V_f_z + p_T_f_z;
    const ella_real t17 = c->body0_mass * ELLA_REAL(2.0011941703010714);
    const ella_real t18 = c->body0_mass * ELLA_REAL(2.0700807911885764);
    const ella_real t19 = c->body0_mass * ELLA_REAL(3.5651069283690613);
    const ella_real minus_C_11 = link->r_T[1] * t17 + L_z1;
    const ella_real minus_C_12 = link->r_T[1] * t18 + L_z2;
    const ella_real minus_C_13 = link->r_T[1] * t19 + L_z3;
    const ella_real C_14 = L_y1 + link->r_T[0] * t17;
    const ella_real C_15 = L_y2 + link->r_T[0] * t18;
    const ella_real C_16 = L_y3 + link->r_T[0] * t19;
    const ella_real C_31 = c->length * t17 + c->chi_1;
    const ella_real C_32 = c->length * t18 + c->chi_2;
    const ella_real C_33 = c->length * t19 + c->chi_3;
    const ella_real C_51 = c->sigma_y1 + t17;
    const ella_real C_52 = c->sigma_y2 + t18;
    const ella_real C_53 = c->sigma_y3 + t19;
    const ella_real t20 = c->body0_mass * ELLA_REAL(4.0047781072469935);
    const ella_real modal_inertia_11 = t20 + m_eta[0];
    if (!(modal_inertia_11 > 0)) { return ELLA_SINGULAR; }
    const ella_real modal_inertia_12 = c->body0_mass * ELLA_REAL(4.142633611378808);
    const ella_real modal_inertia_13 = c->body0_mass * ELLA_REAL(7.134471201552125);
    const ella_real t21 = c->body0_mass * ELLA_REAL(4.2852344820479225);
    const ella_real modal_inertia_22 = t21 + m_eta[1];
    const ella_real modal_inertia_23 = c->body0_mass * ELLA_REAL(7.380059370950102);
    const ella_real t22 = c->body0_mass * ELLA_REAL(12.709987410705082);
    const ella_real modal_inertia_33 = t22 + m_eta[2];
    const ella_real modal_inertia_44 = t20 + m_eta[3];
    if (!(modal_inertia_44 > 0)) { return ELLA_SINGULAR; }
    const ella_real modal_inertia_55 = t21 + m_eta[4];
    const ella_real modal_inertia_66 = t22 + m_eta[5];
    const ella_real t23 = p_T_f_y * ELLA_REAL(2.0011941703010714)
        - (Theta_11 * minus_p_T_tau_x + Theta_21 * minus_p_T_tau_y + Theta_31 * minus_p_T_tau_z);
    const ella_real t24 = p_T_f_y * ELLA_REAL(2.0700807911885764)
        - (Theta_12 * minus_p_T_tau_x + Theta_22 * minus_p_T_tau_y + Theta_32 * minus_p_T_tau_z);
    const ella_real t25 = p_T_f_y * ELLA_REAL(3.5651069283690613)
        - (Theta_13 * minus_p_T_tau_x + Theta_23 * minus_p_T_tau_y + Theta_33 * minus_p_T_tau_z);
    const ella_real t26 = p_T_f_z * ELLA_REAL(2.0011941703010714)
        - (Theta_14 * minus_p_T_tau_x + Theta_24 * minus_p_T_tau_y + Theta_34 * minus_p_T_tau_z);
    const ella_real t27 = p_T_f_z * ELLA_REAL(2.0700807911885764)
        - (Theta_15 * minus_p_T_tau_x + Theta_25 * minus_p_T_tau_y + Theta_35 * minus_p_T_tau_z);
    const ella_real t28 = p_T_f_z * ELLA_REAL(3.5651069283690613)
        - (Theta_16 * minus_p_T_tau_x + Theta_26 * minus_p_T_tau_y + Theta_36 * minus_p_T_tau_z);
    const ella_real h_phi_1 = h_eta_1 + f_eta[0] + t23;
    const ella_real h_phi_2 = h_eta_2 + f_eta[1] + t24;
    const ella_real h_phi_3 = h_eta_3 + f_eta[2] + t25;
    const ella_real h_phi_4 = h_eta_4 + f_eta[3] + t26;
    const ella_real h_phi_5 = h_eta_5 + f_eta[4] + t27;
    const ella_real h_phi_6 = h_eta_6 + f_eta[5] + t28;
    const ella_real h_phi_7 = h_eta_7 + f_eta[6]
        - (Theta_17 * minus_p_T_tau_x + Theta_27 * minus_p_T_tau_y + Theta_37 * minus_p_T_tau_z);
    const ella_real modes_inverse_1 = 1 / modal_inertia_11;
    const ella_real modes_L_21 = modal_inertia_12 * modes_inverse_1;
    link->modes_L[0] = modes_L_21;
    const ella_real modes_L_31 = modal_inertia_13 * modes_inverse_1;
    link->modes_L[1] = modes_L_31;
    const ella_real t29 = modal_inertia_22 - modal_inertia_12 * modes_L_21;
    if (!(t29 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_2 = 1 / t29;
    const ella_real t30 = modal_inertia_23 - modal_inertia_12 * modes_L_31;
    const ella_real modes_L_32 = t30 * modes_inverse_2;
    link->modes_L[2] = modes_L_32;
    const ella_real t31 = modal_inertia_33 - (modal_inertia_13 * modes_L_31 + t30 * modes_L_32);
    if (!(t31 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_3 = 1 / t31;
    const ella_real modes_inverse_4 = 1 / modal_inertia_44;
    const ella_real modes_L_54 = modal_inertia_12 * modes_inverse_4;
    link->modes_L[9] = modes_L_54;
    const ella_real modes_L_64 = modal_inertia_13 * modes_inverse_4;
    link->modes_L[13] = modes_L_64;
    const ella_real t32 = modal_inertia_55 - modal_inertia_12 * modes_L_54;
    if (!(t32 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_5 = 1 / t32;
    const ella_real t33 = modal_inertia_23 - modal_inertia_12 * modes_L_64;
    const ella_real modes_L_65 = t33 * modes_inverse_5;
    link->modes_L[14] = modes_L_65;
    const ella_real t34 = modal_inertia_66 - (modal_inertia_13 * modes_L_64 + t33 * modes_L_65);
    if (!(t34 > 0)) { return ELLA_SINGULAR; }
    const ella_real modes_inverse_6 = 1 / t34;
    const ella_real modes_inverse_7 = 1 / m_eta[6];
    const ella_real t35 = modes_L_21 * minus_C_11 - minus_C_12;
    const ella_real t36 = C_32 - modes_L_21 * C_31;
    const ella_real t37 = C_52 - modes_L_21 * C_51;
    const ella_real t38 = modes_L_31 * minus_C_11 - minus_C_13 - modes_L_32 * t35;
    const ella_real t39 = C_33 - modes_L_31 * C_31 - modes_L_32 * t36;
    const ella_real t40 = C_53 - modes_L_31 * C_51 - modes_L_32 * t37;
    const ella_real t41 = C_15 - modes_L_54 * C_14;
    const ella_real t42 = modes_L_54 * C_31 - C_32;
    const ella_real t43 = C_52 - modes_L_54 * C_51;
    const ella_real t44 = C_16 - modes_L_64 * C_14 - modes_L_65 * t41;
    const ella_real t45 = modes_L_64 * C_31 - C_33 - modes_L_65 * t42;
    const ella_real t46 = C_53 - modes_L_64 * C_51 - modes_L_65 * t43;
    const ella_real t47 = h_phi_2 - modes_L_21 * h_phi_1;
    const ella_real t48 = h_phi_3 - modes_L_31 * h_phi_1 - modes_L_32 * t47;
    const ella_real t49 = h_phi_5 - modes_L_54 * h_phi_4;
    const ella_real t50 = h_phi_6 - modes_L_64 * h_phi_4 - modes_L_65 * t49;
    const ella_real minus_modes_W_11 = minus_C_11 * modes_inverse_1;
    link->modes_W[0] = -minus_modes_W_11;
    const ella_real modes_W_13 = C_31 * modes_inverse_1;
    link->modes_W[2] = modes_W_13;
    const ella_real modes_W_15 = C_51 * modes_inverse_1;
    link->modes_W[4] = modes_W_15;
    const ella_real modes_W_21 = t35 * modes_inverse_2;
    link->modes_W[6] = modes_W_21;
    const ella_real modes_W_23 = t36 * modes_inverse_2;
    link->modes_W[8] = modes_W_23;
    const ella_real modes_W_25 = t37 * modes_inverse_2;
    link->modes_W[10] = modes_W_25;
    const ella_real modes_W_31 = t38 * modes_inverse_3;
    link->modes_W[12] = modes_W_31;
    const ella_real modes_W_33 = t39 * modes_inverse_3;
    link->modes_W[14] = modes_W_33;
    const ella_real modes_W_35 = t40 * modes_inverse_3;
    link->modes_W[16] = modes_W_35;
    const ella_real modes_W_41 = C_14 * modes_inverse_4;
    link->modes_W[18] = modes_W_41;
    const ella_real minus_modes_W_42 = C_31 * modes_inverse_4;
    link->modes_W[19] = -minus_modes_W_42;
    const ella_real modes_W_46 = C_51 * modes_inverse_4;
    link->modes_W[23] = modes_W_46;
    const ella_real modes_W_51 = t41 * modes_inverse_5;
    link->modes_W[24] = modes_W_51;
    const ella_real modes_W_52 = t42 * modes_inverse_5;
    link->modes_W[25] = modes_W_52;
    const ella_real modes_W_56 = t43 * modes_inverse_5;
    link->modes_W[29] = modes_W_56;
    const ella_real modes_W_61 = t44 * modes_inverse_6;
    link->modes_W[30] = modes_W_61;
    const ella_real modes_W_62 = t45 * modes_inverse_6;
    link->modes_W[31] = modes_W_62;
    const ella_real modes_W_66 = t46 * modes_inverse_6;
    link->modes_W[35] = modes_W_66;
    const ella_real modes_W_71 = c->sigma_t_7 * modes_inverse_7;
    link->modes_W[36] = modes_W_71;
    const ella_real modes_w_1 = h_phi_1 * modes_inverse_1;
    link->modes_w[0] = modes_w_1;
    const ella_real modes_w_2 = t47 * modes_inverse_2;
    link->modes_w[1] = modes_w_2;
    const ella_real modes_w_3 = t48 * modes_inverse_3;
    link->modes_w[2] = modes_w_3;
    const ella_real modes_w_4 = h_phi_4 * modes_inverse_4;
    link->modes_w[3] = modes_w_4;
    const ella_real modes_w_5 = t49 * modes_inverse_5;
    link->modes_w[4] = modes_w_5;
    const ella_real modes_w_6 = t50 * modes_inverse_6;
    link->modes_w[5] = modes_w_6;
    const ella_real modes_w_7 = h_phi_7 * modes_inverse_7;
    link->modes_w[6] = modes_w_7;
    const ella_real t51 = minus_C_11 * minus_modes_W_11 + t35 * modes_W_21 + t38 * modes_W_31 + C_14 * modes_W_41
        + t41 * modes_W_51;
    const ella_real M_i_11 = M_loaded_11 - (t51 + t44 * modes_W_61 + c->sigma_t_7 * modes_W_71);
    const ella_real M_i_12 = C_14 * minus_modes_W_42 - t41 * modes_W_52 - t44 * modes_W_62 - minus_M_loaded_12;
    const ella_real M_i_13 = M_loaded_13 - (t35 * modes_W_23 - minus_C_11 * modes_W_13 + t38 * modes_W_33);
    const ella_real M_i_15 = minus_C_11 * modes_W_15 - t35 * modes_W_25 - t38 * modes_W_35 - M_loaded_24;
    const ella_real M_i_16 = M_loaded_16 - (C_14 * modes_W_46 + t41 * modes_W_56 + t44 * modes_W_66);
    link->Lambda_i[4] = M_i_16;
    const ella_real M_i_22 = M_loaded_22 - (C_31 * minus_modes_W_42 + t42 * modes_W_52 + t45 * modes_W_62);
    const ella_real M_i_26 = -(t42 * modes_W_56 - C_31 * modes_W_46 + t45 * modes_W_66) - M_loaded_35;
    link->Lambda_i[8] = M_i_26;
    const ella_real M_i_33 = M_loaded_33 - (C_31 * modes_W_13 + t36 * modes_W_23 + t39 * modes_W_33);
    const ella_real M_i_35 = M_loaded_35 - (C_31 * modes_W_15 + t36 * modes_W_25 + t39 * modes_W_35);
    const ella_real M_i_55 = M_loaded_44 - (C_51 * modes_W_15 + t37 * modes_W_25 + t40 * modes_W_35);
    const ella_real M_i_66 = M_loaded_44 - (C_51 * modes_W_46 + t43 * modes_W_56 + t46 * modes_W_66);
    link->Lambda_i[14] = M_i_66;
    const ella_real t52 = modes_W_21 * t47 - minus_modes_W_11 * h_phi_1 + modes_W_31 * t48 + modes_W_41 * h_phi_4
        + modes_W_51 * t49;
    const ella_real h_i_tau_x = h_loaded_tau_x - (t52 + modes_W_61 * t50 + modes_W_71 * h_phi_7);
    const ella_real h_i_tau_y = h_loaded_tau_y - (modes_W_52 * t49 - minus_modes_W_42 * h_phi_4 + modes_W_62 * t50);
    const ella_real h_i_tau_z = h_loaded_tau_z - (modes_W_13 * h_phi_1 + modes_W_23 * t47 + modes_W_33 * t48);
    const ella_real h_i_f_y = h_loaded_f_y - (modes_W_15 * h_phi_1 + modes_W_25 * t47 + modes_W_35 * t48);
    const ella_real h_i_f_z = h_loaded_f_z - (modes_W_46 * h_phi_4 + modes_W_56 * t49 + modes_W_66 * t50);
    link->p_i[5] = h_i_f_z;

    /* joint: its accelerations eliminated from its rows (43) */
    if (!(M_i_33 - ELLA_REAL_EPSILON * 8 * (M_i_11 + M_i_22 + M_i_33) > 0)) { return ELLA_SINGULAR; }
    const ella_real joint_inverse_1 = 1 / M_i_33;
    const ella_real joint_W_11 = M_i_13 * joint_inverse_1;
    link->joint_W[0] = joint_W_11;
    const ella_real minus_joint_W_12 = minus_M_loaded_23 * joint_inverse_1;
    link->joint_W[1] = -minus_joint_W_12;
    const ella_real minus_joint_W_14 = M_loaded_16 * joint_inverse_1;
    link->joint_W[2] = -minus_joint_W_14;
    const ella_real joint_W_15 = M_i_35 * joint_inverse_1;
    link->joint_W[3] = joint_W_15;
    const ella_real joint_w_1 = (tau[0] - h_i_tau_z) * joint_inverse_1;
    link->joint_w[0] = joint_w_1;
    const ella_real Lambda_i_11 = M_i_11 - M_i_13 * joint_W_11;
    link->Lambda_i[0] = Lambda_i_11;
    const ella_real Lambda_i_12 = M_i_12 + M_i_13 * minus_joint_W_12;
    link->Lambda_i[1] = Lambda_i_12;
    const ella_real Lambda_i_14 = M_i_13 * minus_joint_W_14;
    link->Lambda_i[2] = Lambda_i_14;
    const ella_real Lambda_i_15 = M_i_15 - M_i_13 * joint_W_15;
    link->Lambda_i[3] = Lambda_i_15;
    const ella_real Lambda_i_22 = M_i_22 - minus_M_loaded_23 * minus_joint_W_12;
    link->Lambda_i[5] = Lambda_i_22;
    const ella_real Lambda_i_24 = M_loaded_24 - minus_M_loaded_23 * minus_joint_W_14;
    link->Lambda_i[6] = Lambda_i_24;
    const ella_real Lambda_i_25 = minus_M_loaded_23 * joint_W_15;
    link->Lambda_i[7] = Lambda_i_25;
    const ella_real Lambda_i_44 = M_loaded_44 - M_loaded_16 * minus_joint_W_14;
    link->Lambda_i[9] = Lambda_i_44;
    const ella_real Lambda_i_45 = M_loaded_16 * joint_W_15;
    link->Lambda_i[10] = Lambda_i_45;
    const ella_real Lambda_i_55 = M_i_55 - M_i_35 * joint_W_15;
    link->Lambda_i[12] = Lambda_i_55;
    const ella_real p_i_tau_x = h_i_tau_x + M_i_13 * joint_w_1;
    link->p_i[0] = p_i_tau_x;
    const ella_real p_i_tau_y = h_i_tau_y - minus_M_loaded_23 * joint_w_1;
    link->p_i[1] = p_i_tau_y;
    const ella_real p_i_f_x = h_loaded_f_x - M_loaded_16 * joint_w_1;
    link->p_i[3] = p_i_f_x;
    const ella_real p_i_f_y = h_i_f_y + M_i_35 * joint_w_1;
    link->p_i[4] = p_i_f_y;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const ella_real t53 = Lambda_i_11 * link->R_P[3] + Lambda_i_12 * link->R_P[4];
    const ella_real t54 = Lambda_i_11 * link->R_P[6] + Lambda_i_12 * link->R_P[7];
    const ella_real t55 = Lambda_i_22 * link->R_P[4] + Lambda_i_12 * link->R_P[3];
    const ella_real t56 = Lambda_i_22 * link->R_P[7] + Lambda_i_12 * link->R_P[6];
    const ella_real Lambda_1 = link->R_P[0] * (Lambda_i_11 * link->R_P[0] + Lambda_i_12 * link->R_P[1])
        + link->R_P[1] * (Lambda_i_22 * link->R_P[1] + Lambda_i_12 * link->R_P[0]);
    base->Lambda[0] = Lambda_1;
    const ella_real Lambda_2 = link->R_P[0] * t53 + link->R_P[1] * t55;
    base->Lambda[1] = Lambda_2;
    const ella_real Lambda_3 = link->R_P[0] * t54 + link->R_P[1] * t56;
    base->Lambda[2] = Lambda_3;
    const ella_real Lambda_7 = link->R_P[3] * t53 + link->R_P[4] * t55;
    base->Lambda[6] = Lambda_7;
    const ella_real Lambda_8 = link->R_P[3] * t54 + link->R_P[4] * t56;
    base->Lambda[7] = Lambda_8;
    const ella_real Lambda_12 = link->R_P[6] * t54 + link->R_P[7] * t56;
    base->Lambda[11] = Lambda_12;
    const ella_real t57 = Lambda_i_15 * link->R_P[1] + Lambda_i_14 * link->R_P[0] + M_i_16 * link->R_P[2];
    const ella_real t58 = Lambda_i_15 * link->R_P[4] + Lambda_i_14 * link->R_P[3] + M_i_16 * link->R_P[5];
    const ella_real t59 = Lambda_i_15 * link->R_P[7] + Lambda_i_14 * link->R_P[6] + M_i_16 * link->R_P[8];
    const ella_real t60 = Lambda_i_24 * link->R_P[0] + Lambda_i_25 * link->R_P[1] + M_i_26 * link->R_P[2];
    const ella_real t61 = Lambda_i_24 * link->R_P[3] + Lambda_i_25 * link->R_P[4] + M_i_26 * link->R_P[5];
    const ella_real t62 = Lambda_i_24 * link->R_P[6] + Lambda_i_25 * link->R_P[7] + M_i_26 * link->R_P[8];
    const ella_real Lambda_4 = link->R_P[0] * t57 + link->R_P[1] * t60;
    base->Lambda[3] = Lambda_4;
    const ella_real Lambda_5 = link->R_P[0] * t58 + link->R_P[1] * t61;
    base->Lambda[4] = Lambda_5;
    const ella_real Lambda_6 = link->R_P[0] * t59 + link->R_P[1] * t62;
    base->Lambda[5] = Lambda_6;
    const ella_real Lambda_9 = link->R_P[3] * t57 + link->R_P[4] * t60;
    base->Lambda[8] = Lambda_9;
    const ella_real Lambda_10 = link->R_P[3] * t58 + link->R_P[4] * t61;
    base->Lambda[9] = Lambda_10;
    const ella_real Lambda_11 = link->R_P[3] * t59 + link->R_P[4] * t62;
    base->Lambda[10] = Lambda_11;
    const ella_real Lambda_13 = link->R_P[6] * t57 + link->R_P[7] * t60;
    base->Lambda[12] = Lambda_13;
    const ella_real Lambda_14 = link->R_P[6] * t58 + link->R_P[7] * t61;
    base->Lambda[13] = Lambda_14;
    const ella_real Lambda_15 = link->R_P[6] * t59 + link->R_P[7] * t62;
    base->Lambda[14] = Lambda_15;
    const ella_real t63 = (Lambda_i_44 - M_i_66) * ELLA_REAL(0.5);
    const ella_real t64 = t63 * link->R_P[0] + Lambda_i_45 * link->R_P[1];
    const ella_real t65 = t63 * link->R_P[3] + Lambda_i_45 * link->R_P[4];
    const ella_real t66 = t63 * link->R_P[6] + Lambda_i_45 * link->R_P[7];
    const ella_real t67 = (Lambda_i_55 - M_i_66) * ELLA_REAL(0.5);
    const ella_real t68 = t67 * link->R_P[1];
    const ella_real t69 = t67 * link->R_P[4];
    const ella_real t70 = t67 * link->R_P[7];
    const ella_real Lambda_16 = (link->R_P[0] * t64 + link->R_P[1] * t68) * 2 + M_i_66;
    base->Lambda[15] = Lambda_16;
    const ella_real Lambda_17 = link->R_P[0] * t65 + link->R_P[1] * t69 + (link->R_P[3] * t64 + link->R_P[4] * t68);
    base->Lambda[16] = Lambda_17;
    const ella_real Lambda_18 = link->R_P[0] * t66 + link->R_P[1] * t70 + (link->R_P[6] * t64 + link->R_P[7] * t68);
    base->Lambda[17] = Lambda_18;
    const ella_real Lambda_19 = (link->R_P[3] * t65 + link->R_P[4] * t69) * 2 + M_i_66;
    base->Lambda[18] = Lambda_19;
    const ella_real Lambda_20 = link->R_P[3] * t66 + link->R_P[4] * t70 + (link->R_P[6] * t65 + link->R_P[7] * t69);
    base->Lambda[19] = Lambda_20;
    const ella_real Lambda_21 = (link->R_P[6] * t66 + link->R_P[7] * t70) * 2 + M_i_66;
    base->Lambda[20] = Lambda_21;
    const ella_real p_tau_x = link->R_P[0] * p_i_tau_x + link->R_P[1] * p_i_tau_y + link->R_P[2] * tau[0];
    base->p[0] = p_tau_x;
    const ella_real p_tau_y = link->R_P[3] * p_i_tau_x + link->R_P[4] * p_i_tau_y + link->R_P[5] * tau[0];
    base->p[1] = p_tau_y;
    const ella_real p_tau_z = link->R_P[6] * p_i_tau_x + link->R_P[7] * p_i_tau_y + link->R_P[8] * tau[0];
    base->p[2] = p_tau_z;
    const ella_real p_f_x = link->R_P[0] * p_i_f_x + link->R_P[1] * p_i_f_y + link->R_P[2] * h_i_f_z;
    base->p[3] = p_f_x;
    const ella_real p_f_y = link->R_P[3] * p_i_f_x + link->R_P[4] * p_i_f_y + link->R_P[5] * h_i_f_z;
    base->p[4] = p_f_y;
    const ella_real p_f_z = link->R_P[6] * p_i_f_x + link->R_P[7] * p_i_f_y + link->R_P[8] * h_i_f_z;
    base->p[5] = p_f_z;

    /* outputs */
    link->p_i[2] = tau[0];
    return ELLA_OK;
}

/* accelerate, links like upper_arm: 147 operations */
ELLA_PART ella_status accelerate_upper_arm(const ella_link_constants *restrict c, const ella_link_store *restrict link,
    ella_node *restrict tip, ella_real qddot[restrict 2], ella_real wrench[restrict 6], ella_real alpha[restrict 6],
    ella_real etaddot[restrict 7])
{
    /* joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const ella_real qddot_1 = link->joint_w[0] - link->joint_L[0] * link->joint_w[1];
    qddot[0] = qddot_1;

    /* link: what is added to the acceleration of F_i, modal accelerations (83) */
    const ella_real delta_alpha_x = link->S[0] * qddot_1;
    const ella_real delta_alpha_y = link->S[1] * qddot_1;
    const ella_real alpha_alpha_x = delta_alpha_x + link->acc_0[0];
    alpha[0] = alpha_alpha_x;
    const ella_real alpha_alpha_y = delta_alpha_y + link->acc_0[1];
    alpha[1] = alpha_alpha_y;
    const ella_real t1 = link->modes_W[0] * delta_alpha_x + link->modes_W[1] * delta_alpha_y
        + link->modes_W[2] * link->joint_w[1];
    const ella_real t2 = link->modes_W[6] * delta_alpha_x + link->modes_W[7] * delta_alpha_y
        + link->modes_W[8] * link->joint_w[1];
    const ella_real t3 = link->modes_W[12] * delta_alpha_x + link->modes_W[13] * delta_alpha_y
        + link->modes_W[14] * link->joint_w[1];
    const ella_real t4 = -(link->modes_W[18] * delta_alpha_x + link->modes_W[19] * delta_alpha_y)
        - link->modes_W[20] * link->joint_w[1];
    const ella_real t5 = link->modes_W[24] * delta_alpha_x + link->modes_W[25] * delta_alpha_y
        + link->modes_W[26] * link->joint_w[1];
    const ella_real t6 = link->modes_W[30] * delta_alpha_x + link->modes_W[31] * delta_alpha_y
        + link->modes_W[32] * link->joint_w[1];
    const ella_real t7 = -(link->modes_W[36] * delta_alpha_x + link->modes_W[37] * delta_alpha_y)
        - link->modes_W[38] * link->joint_w[1];
    const ella_real etaddot_7 = t7 - link->modes_w[6];
    etaddot[6] = etaddot_7;
    const ella_real etaddot_6 = -(link->modes_w[5] + t6) - link->modes_L[20] * etaddot_7;
    etaddot[5] = etaddot_6;
    const ella_real etaddot_5 = -(link->modes_w[4] + t5 + link->modes_L[14] * etaddot_6)
        - link->modes_L[19] * etaddot_7;
    etaddot[4] = etaddot_5;
    const ella_real etaddot_4 = t4 - link->modes_w[3] - link->modes_L[9] * etaddot_5 - link->modes_L[13] * etaddot_6
        - link->modes_L[18] * etaddot_7;
    etaddot[3] = etaddot_4;
    const ella_real t8 = link->modes_w[2] + t3 + link->modes_L[5] * etaddot_4 + link->modes_L[8] * etaddot_5
        + link->modes_L[12] * etaddot_6;
    const ella_real etaddot_3 = -t8 - link->modes_L[17] * etaddot_7;
    etaddot[2] = etaddot_3;
    const ella_real t9 = link->modes_w[1] + t2 + link->modes_L[2] * etaddot_3 + link->modes_L[4] * etaddot_4
        + link->modes_L[7] * etaddot_5;
    const ella_real etaddot_2 = -(t9 + link->modes_L[11] * etaddot_6) - link->modes_L[16] * etaddot_7;
    etaddot[1] = etaddot_2;
    const ella_real t10 = -(link->modes_w[0] + t1 + link->modes_L[0] * etaddot_2) - link->modes_L[1] * etaddot_3
        - link->modes_L[3] * etaddot_4;
    const ella_real etaddot_1 = t10 - link->modes_L[6] * etaddot_5 - link->modes_L[10] * etaddot_6
        - link->modes_L[15] * etaddot_7;
    etaddot[0] = etaddot_1;

    /* tip: what is added to the acceleration of the tip section (accconst1b) */
    const ella_real t11 = etaddot_7 * ELLA_REAL(1.7320508075688772);
    const ella_real t12 = c->Psi_c_y4 * etaddot_4 + c->Psi_c_y5 * etaddot_5 + c->Psi_c_y6 * etaddot_6;
    const ella_real t13 = c->Psi_c_z1 * etaddot_1 + c->Psi_c_z2 * etaddot_2 + c->Psi_c_z3 * etaddot_3;
    const ella_real t14 = etaddot_1 * ELLA_REAL(2.0011941703010714) + etaddot_2 * ELLA_REAL(2.0700807911885764)
        + etaddot_3 * ELLA_REAL(3.5651069283690613);
    const ella_real t15 = etaddot_4 * ELLA_REAL(2.0011941703010714) + etaddot_5 * ELLA_REAL(2.0700807911885764)
        + etaddot_6 * ELLA_REAL(3.5651069283690613);
    const ella_real delta_T_a_x = delta_alpha_y * link->r_T[1] - link->joint_w[1] * link->r_T[0];
    tip->delta[3] = delta_T_a_x;
    const ella_real delta_T_alpha_x = delta_alpha_x + (link->J_l[0] * t11 + link->J_l[1] * t12 + link->J_l[2] * t13);
    tip->delta[0] = delta_T_alpha_x;
    const ella_real delta_T_alpha_y = delta_alpha_y + (link->J_l[3] * t11 + link->J_l[4] * t12 + link->J_l[5] * t13);
    tip->delta[1] = delta_T_alpha_y;
    const ella_real delta_T_alpha_z = link->joint_w[1] + (link->J_l[6] * t11 + link->J_l[7] * t12 + link->J_l[8] * t13);
    tip->delta[2] = delta_T_alpha_z;
    const ella_real delta_T_a_y = link->joint_w[1] * c->length - delta_alpha_x * link->r_T[1] + t14;
    tip->delta[4] = delta_T_a_y;
    const ella_real delta_T_a_z = delta_alpha_x * link->r_T[0] - delta_alpha_y * c->length + t15;
    tip->delta[5] = delta_T_a_z;

    /* outputs */
    qddot[1] = link->joint_w[1];
    alpha[2] = link->joint_w[1];
    alpha[3] = link->acc_0[3];
    alpha[4] = link->acc_0[4];
    alpha[5] = link->acc_0[5];

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

/* accelerate, links like forearm: 145 operations */
ELLA_PART ella_status accelerate_forearm(const ella_link_store *restrict link, const ella_node *restrict base,
    ella_real qddot[restrict 1], ella_real wrench[restrict 6], ella_real alpha[restrict 6],
    ella_real etaddot[restrict 7])
{
    /* joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const ella_real carried_alpha_x = link->R_P[0] * base->delta[0] + link->R_P[3] * base->delta[1]
        + link->R_P[6] * base->delta[2];
    const ella_real carried_alpha_y = link->R_P[1] * base->delta[0] + link->R_P[4] * base->delta[1]
        + link->R_P[7] * base->delta[2];
    const ella_real carried_alpha_z = link->R_P[2] * base->delta[0] + link->R_P[5] * base->delta[1]
        + link->R_P[8] * base->delta[2];
    const ella_real carried_a_x = link->R_P[0] * base->delta[3] + link->R_P[3] * base->delta[4]
        + link->R_P[6] * base->delta[5];
    const ella_real carried_a_y = link->R_P[1] * base->delta[3] + link->R_P[4] * base->delta[4]
        + link->R_P[7] * base->delta[5];
    const ella_real carried_a_z = link->R_P[2] * base->delta[3] + link->R_P[5] * base->delta[4]
        + link->R_P[8] * base->delta[5];
    const ella_real t1 = link->joint_W[0] * carried_alpha_x + link->joint_W[1] * carried_alpha_y + carried_alpha_z
        + link->joint_W[2] * carried_a_x;
    const ella_real qddot_1 = link->joint_w[0] - (t1 + link->joint_W[3] * carried_a_y);
    qddot[0] = qddot_1;

    /* link: what is added to the acceleration of F_i, modal accelerations (83) */
    const ella_real delta_alpha_z = carried_alpha_z + qddot_1;
    const ella_real alpha_alpha_x = carried_alpha_x + link->acc_0[0];
    alpha[0] = alpha_alpha_x;
    const ella_real alpha_alpha_y = carried_alpha_y + link->acc_0[1];
    alpha[1] = alpha_alpha_y;
    const ella_real alpha_alpha_z = delta_alpha_z + link->acc_0[2];
    alpha[2] = alpha_alpha_z;
    const ella_real alpha_a_x = carried_a_x + link->acc_0[3];
    alpha[3] = alpha_a_x;
    const ella_real alpha_a_y = carried_a_y + link->acc_0[4];
    alpha[4] = alpha_a_y;
    const ella_real alpha_a_z = carried_a_z + link->acc_0[5];
    alpha[5] = alpha_a_z;
    const ella_real t2 = link->modes_W[0] * carried_alpha_x + link->modes_W[2] * delta_alpha_z
        + link->modes_W[4] * carried_a_y;
    const ella_real t3 = link->modes_W[6] * carried_alpha_x + link->modes_W[8] * delta_alpha_z
        + link->modes_W[10] * carried_a_y;
    const ella_real t4 = link->modes_W[12] * carried_alpha_x + link->modes_W[14] * delta_alpha_z
        + link->modes_W[16] * carried_a_y;
    const ella_real t5 = link->modes_W[18] * carried_alpha_x + link->modes_W[19] * carried_alpha_y
        + link->modes_W[23] * carried_a_z;
    const ella_real t6 = link->modes_W[24] * carried_alpha_x + link->modes_W[25] * carried_alpha_y
        + link->modes_W[29] * carried_a_z;
    const ella_real t7 = link->modes_W[30] * carried_alpha_x + link->modes_W[31] * carried_alpha_y
        + link->modes_W[35] * carried_a_z;
    const ella_real etaddot_3 = -t4 - link->modes_w[2];
    etaddot[2] = etaddot_3;
    const ella_real etaddot_6 = -t7 - link->modes_w[5];
    etaddot[5] = etaddot_6;
    const ella_real etaddot_7 = -(link->modes_w[6] + link->modes_W[36] * carried_alpha_x);
    etaddot[6] = etaddot_7;
    const ella_real etaddot_5 = -(link->modes_w[4] + t6) - link->modes_L[14] * etaddot_6;
    etaddot[4] = etaddot_5;
    const ella_real etaddot_4 = -(link->modes_w[3] + t5 + link->modes_L[9] * etaddot_5 + link->modes_L[13] * etaddot_6);
    etaddot[3] = etaddot_4;
    const ella_real etaddot_2 = -(link->modes_w[1] + t3) - link->modes_L[2] * etaddot_3;
    etaddot[1] = etaddot_2;
    const ella_real etaddot_1 = -(link->modes_w[0] + t2 + link->modes_L[0] * etaddot_2 + link->modes_L[1] * etaddot_3);
    etaddot[0] = etaddot_1;

    if (wrench) {
        /* joint wrench (48) */
        const ella_real t8 = link->Lambda_i[0] * carried_alpha_x + link->Lambda_i[1] * carried_alpha_y
            + link->Lambda_i[2] * carried_a_x;
        const ella_real t9 = link->Lambda_i[1] * carried_alpha_x + link->Lambda_i[5] * carried_alpha_y
            + link->Lambda_i[6] * carried_a_x;
        const ella_real t10 = link->Lambda_i[2] * carried_alpha_x + link->Lambda_i[6] * carried_alpha_y
            + link->Lambda_i[9] * carried_a_x;
        const ella_real t11 = link->Lambda_i[3] * carried_alpha_x + link->Lambda_i[7] * carried_alpha_y
            + link->Lambda_i[10] * carried_a_x;
        const ella_real t12 = link->Lambda_i[4] * carried_alpha_x + link->Lambda_i[8] * carried_alpha_y
            + link->Lambda_i[14] * carried_a_z;
        const ella_real wrench_tau_x = t8 + link->Lambda_i[3] * carried_a_y + link->Lambda_i[4] * carried_a_z
            + link->p_i[0];
        wrench[0] = wrench_tau_x;
        const ella_real wrench_tau_y = t9 + link->Lambda_i[7] * carried_a_y + link->Lambda_i[8] * carried_a_z
            + link->p_i[1];
        wrench[1] = wrench_tau_y;
        const ella_real wrench_f_x = t10 + link->Lambda_i[10] * carried_a_y + link->p_i[3];
        wrench[3] = wrench_f_x;
        const ella_real wrench_f_y = t11 + link->Lambda_i[12] * carried_a_y + link->p_i[4];
        wrench[4] = wrench_f_y;
        const ella_real wrench_f_z = t12 + link->p_i[5];
        wrench[5] = wrench_f_z;

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
    const ella_real Vdot_a_x = t12 - (twist[1] * twist[5] - twist[2] * twist[4]);
    Vdot[3] = Vdot_a_x;
    const ella_real Vdot_a_y = t13 - (twist[2] * twist[3] - twist[0] * twist[5]);
    Vdot[4] = Vdot_a_y;
    const ella_real Vdot_a_z = t14 - (twist[0] * twist[4] - twist[1] * twist[3]);
    Vdot[5] = Vdot_a_z;

    /* outputs */
    Vdot[0] = alpha[0];
    Vdot[1] = alpha[1];
    Vdot[2] = alpha[2];
    return ELLA_OK;
}

/* project, links like upper_arm: 416 operations */
ELLA_PART ella_status project_upper_arm(const ella_link_constants *c, ella_node *tip, const ella_real q[2],
    const ella_real twist[6], const ella_real eta[7], const ella_real etadot[7], const ella_real quaternion[4],
    ella_real new_q[2], ella_real new_twist[6], ella_real new_quaternion[4], ella_real new_position[3])
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

    const ella_real t21 = R_rel_yy * t14 - minus_R_rel_xy * t18 + R_rel_zy * t16
        - (R_rel_xx * t12 + R_rel_yx * t19 - minus_R_rel_zx * t17);
    const ella_real t22 = (R_rel_xz * t12 + R_rel_zz * t17 - (R_rel_yy * t15 - minus_R_rel_xy * t13 + R_rel_zy * t20))
        * ELLA_REAL(0.5);
    const ella_real t23 = (R_rel_xx * t13 + R_rel_yx * t15 - minus_R_rel_zx * t20 - (R_rel_xz * t18 + R_rel_zz * t16))
        * ELLA_REAL(0.5);
    const ella_real t24 = R_rel_yx * R_rel_yx + R_rel_yy * R_rel_yy;
    const ella_real t25 = ELLA_REAL_EPSILON * 64;
    if (!(t24 - t25 > 0)) { return ELLA_SINGULAR; }
    const ella_real t26 = 1 / t24;
    const ella_real t27 = q[0] + (R_rel_yx * t26 * t22 + R_rel_yy * t26 * t23);
    const ella_real t28 = q[1] + t21 * ELLA_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn_3 = ella_sine_cosine(t27);
    const ella_real R_rel_xz_2 = turn_3.sine, R_rel_zz_2 = turn_3.cosine;
    const ella_sincos turn_4 = ella_sine_cosine(t28);
    const ella_real R_rel_yx_2 = turn_4.sine, R_rel_yy_2 = turn_4.cosine;
    const ella_real R_rel_xx_2 = R_rel_zz_2 * R_rel_yy_2;
    const ella_real minus_R_rel_xy_2 = R_rel_yx_2 * R_rel_zz_2;
    const ella_real minus_R_rel_zx_2 = R_rel_xz_2 * R_rel_yy_2;
    const ella_real R_rel_zy_2 = R_rel_xz_2 * R_rel_yx_2;

    const ella_real t29 = R_rel_xz_2 * t12 + R_rel_zz_2 * t17
        - (R_rel_yy_2 * t15 - minus_R_rel_xy_2 * t13 + R_rel_zy_2 * t20);
    const ella_real t30 = R_rel_xx_2 * t13 + R_rel_yx_2 * t15 - minus_R_rel_zx_2 * t20
        - (R_rel_xz_2 * t18 + R_rel_zz_2 * t16);
    const ella_real t31 = R_rel_yy_2 * t14 - minus_R_rel_xy_2 * t18 + R_rel_zy_2 * t16
        - (R_rel_xx_2 * t12 + R_rel_yx_2 * t19 - minus_R_rel_zx_2 * t17);
    const ella_real t32 = R_rel_yx_2 * R_rel_yx_2 + R_rel_yy_2 * R_rel_yy_2;
    if (!(t32 - t25 > 0)) { return ELLA_SINGULAR; }
    const ella_real t33 = 1 / t32;
    const ella_real new_q_1 = t27
        + (R_rel_yx_2 * t33 * (t29 * ELLA_REAL(0.5)) + R_rel_yy_2 * t33 * (t30 * ELLA_REAL(0.5)));
    const ella_real new_q_2 = t28 + t31 * ELLA_REAL(0.5);

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
    if (!(t34 - t25 > 0)) { return ELLA_SINGULAR; }
    const ella_real t35 = 1 / t34;
    const ella_real t36 = R_rel_yx_3 * t35 * twist[0] + R_rel_yy_3 * t35 * twist[1];

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t37 = theta_x * theta_x;
    const ella_real t38 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t37 + t38;
    const ella_real t39 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t39;

    /* c1: Stumpff function of order 1 */
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * ella_c5(x);
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t38 + t39;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t37 + t39;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t40 = c2 * theta_hat2_12;
    const ella_real t41 = c1 * theta_z;
    const ella_real R_T_xy = t40 - t41;
    const ella_real t42 = c1 * theta_y;
    const ella_real t43 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t42 + t43;
    const ella_real R_T_yx = t41 + t40;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t44 = c2 * theta_hat2_23;
    const ella_real t45 = c1 * theta_x;
    const ella_real R_T_yz = t44 - t45;
    const ella_real R_T_zx = t43 - t42;
    const ella_real R_T_zy = t45 + t44;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_y = etadot[0] * ELLA_REAL(2.0011941703010714) + etadot[1] * ELLA_REAL(2.0700807911885764)
        + etadot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_z = etadot[3] * ELLA_REAL(2.0011941703010714) + etadot[4] * ELLA_REAL(2.0700807911885764)
        + etadot[5] * ELLA_REAL(3.5651069283690613);

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_x = etadot[6] * ELLA_REAL(1.7320508075688772);
    const ella_real thetadot_y = c->Psi_c_y4 * etadot[3] + c->Psi_c_y5 * etadot[4] + c->Psi_c_y6 * etadot[5];
    const ella_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1] + c->Psi_c_z3 * etadot[2];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t46 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real t47 = theta_x * thetadot_y - theta_y * thetadot_x;
    const ella_real t48 = theta_z * thetadot_x - theta_x * thetadot_z;
    const ella_real omega_s_x = thetadot_x + c2 * t46 + c3 * (theta_y * t47 - theta_z * t48);
    const ella_real omega_s_y = thetadot_y + c2 * t48 + c3 * (theta_z * t46 - theta_x * t47);
    const ella_real omega_s_z = thetadot_z + c2 * t47 + c3 * (theta_x * t48 - theta_y * t46);

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t49 = omega_s_z + twist[2];
    const ella_real t50 = R_T_zx * t49;
    const ella_real t51 = R_T_zy * t49;
    const ella_real t52 = R_T_zz * t49;
    const ella_real omega_T_z = R_T_xz * (omega_s_x + twist[0]) + R_T_yz * (omega_s_y + twist[1]) + t52;

    /* v_T: velocity of the tip point (46) */
    const ella_real t53 = twist[2] * r_T_y;
    const ella_real t54 = c->length * twist[2];

    const ella_real R_m_xx = t18 * R_T_xx + t12 * R_T_yx + t13 * R_T_zx;
    const ella_real R_m_xy = t18 * R_T_xy + t12 * R_T_yy + t13 * R_T_zy;
    const ella_real R_m_yx = t14 * R_T_xx + t19 * R_T_yx + t15 * R_T_zx;
    const ella_real R_m_yy = t14 * R_T_xy + t19 * R_T_yy + t15 * R_T_zy;
    const ella_real R_m_zx = t16 * R_T_xx + t17 * R_T_yx + t20 * R_T_zx;
    const ella_real R_m_zy = t16 * R_T_xy + t17 * R_T_yy + t20 * R_T_zy;

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx_3 * t36;
    const ella_real omega_J_y = R_rel_yy_3 * t36;

    const ella_real t55 = new_q_1 * ELLA_REAL(0.5);
    const ella_sincos turn_7 = ella_sine_cosine(t55);
    const ella_real t56 = turn_7.sine, t57 = turn_7.cosine;
    const ella_real t58 = new_q_2 * ELLA_REAL(0.5);
    const ella_sincos turn_8 = ella_sine_cosine(t58);
    const ella_real t59 = turn_8.sine, t60 = turn_8.cosine;
    const ella_real new_quaternion_1 = t57 * t60;
    const ella_real new_quaternion_4 = t57 * t59;
    const ella_real new_quaternion_3 = t60 * t56;
    const ella_real new_quaternion_2 = t56 * t59;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t61 = omega_s_x + omega_J_x;
    const ella_real t62 = omega_s_y + omega_J_y;
    const ella_real omega_T_x = R_T_xx * t61 + R_T_yx * t62 + t50;
    const ella_real omega_T_y = R_T_xy * t61 + R_T_yy * t62 + t51;
    const ella_real omega_T_z_2 = R_T_xz * t61 + R_T_yz * t62 + t52;

    /* v_T: velocity of the tip point (46) */
    const ella_real t63 = omega_J_y * r_T_z - t53;
    const ella_real t64 = udot_T_y + t54 - omega_J_x * r_T_z;
    const ella_real t65 = udot_T_z + omega_J_x * r_T_y - c->length * omega_J_y;
    const ella_real v_T_x = R_T_xx * t63 + R_T_yx * t64 + R_T_zx * t65;
    const ella_real v_T_y = R_T_xy * t63 + R_T_yy * t64 + R_T_zy * t65;
    const ella_real v_T_z = R_T_xz * t63 + R_T_yz * t64 + R_T_zz * t65;

    const ella_real r_x = R_rel_xx_3 * c->length - minus_R_rel_xy_3 * r_T_y + R_rel_xz_3 * r_T_z;
    const ella_real r_y = R_rel_yx_3 * c->length + R_rel_yy_3 * r_T_y;
    const ella_real r_z = R_rel_zy_3 * r_T_y - minus_R_rel_zx_3 * c->length + R_rel_zz_3 * r_T_z;
    const ella_real t66 = x * ELLA_REAL(0.25);
    const ella_real t67 = 1 - t66 * (ELLA_REAL(0.5) - t66 * ella_c4(t66));
    const ella_real t68 = (1 - t66 * (ELLA_REAL(0.16666666666666666) - t66 * ella_c5(t66))) * ELLA_REAL(0.5);
    const ella_real t69 = t68 * theta_x;
    const ella_real t70 = t68 * theta_y;
    const ella_real t71 = t68 * theta_z;
    const ella_real Q_1 = new_quaternion_1 * t67
        - (new_quaternion_2 * t69 + new_quaternion_3 * t70 + new_quaternion_4 * t71);
    const ella_real Q_2 = new_quaternion_1 * t69 + t67 * new_quaternion_2
        + (new_quaternion_3 * t71 - new_quaternion_4 * t70);
    const ella_real Q_3 = new_quaternion_1 * t70 + t67 * new_quaternion_3
        + (new_quaternion_4 * t69 - new_quaternion_2 * t71);
    const ella_real Q_4 = new_quaternion_1 * t71 + t67 * new_quaternion_4
        + (new_quaternion_2 * t70 - new_quaternion_3 * t69);

    /* outputs */
    new_q[0] = new_q_1;
    new_q[1] = new_q_2;
    tip->omega_m[2] = omega_T_z;
    tip->R_m[0] = R_m_xx;
    tip->R_m[1] = R_m_xy;
    tip->R_m[3] = R_m_yx;
    tip->R_m[4] = R_m_yy;
    tip->R_m[6] = R_m_zx;
    tip->R_m[7] = R_m_zy;
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
    tip->omega_T[0] = omega_T_x;
    tip->omega_T[1] = omega_T_y;
    tip->omega_T[2] = omega_T_z_2;
    tip->v_T[0] = v_T_x;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
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
ELLA_PART ella_status project_forearm(const ella_node *base, const ella_real q[1], const ella_real twist[6],
    const ella_real quaternion[4], ella_real new_q[1], ella_real new_twist[6], ella_real new_quaternion[4],
    ella_real new_position[3])
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
    const ella_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    const ella_real t18 = q[0] + (R_rel_xx * t16 - R_rel_yx * t14 - (R_rel_xx * t15 + R_rel_yx * t17)) * ELLA_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn_2 = ella_sine_cosine(t18);
    const ella_real R_rel_yx_2 = turn_2.sine, R_rel_xx_2 = turn_2.cosine;

    const ella_real new_q_1 = t18
        + (R_rel_xx_2 * t16 - R_rel_yx_2 * t14 - (R_rel_xx_2 * t15 + R_rel_yx_2 * t17)) * ELLA_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn_3 = ella_sine_cosine(new_q_1);
    const ella_real R_rel_yx_3 = turn_3.sine, R_rel_xx_3 = turn_3.cosine;

    const ella_real t19 = twist[2] - base->omega_m[2];

    /* omega_R: angular velocity of the parent's tip */
    const ella_real omega_R_x = R_rel_xx_3 * base->omega_T[0] + R_rel_yx_3 * base->omega_T[1];
    const ella_real omega_R_y = R_rel_xx_3 * base->omega_T[1] - R_rel_yx_3 * base->omega_T[0];

    /* omega: angular velocity of the link (45) */
    const ella_real omega_z = base->omega_T[2] + t19;

    /* v_R: velocity of the joint point, fixed to the parent */
    const ella_real v_R_x = R_rel_xx_3 * base->v_T[0] + R_rel_yx_3 * base->v_T[1];
    const ella_real v_R_y = R_rel_xx_3 * base->v_T[1] - R_rel_yx_3 * base->v_T[0];

    const ella_real t20 = new_q_1 * ELLA_REAL(0.5);
    const ella_sincos turn_4 = ella_sine_cosine(t20);
    const ella_real t21 = turn_4.sine, t22 = turn_4.cosine;
    const ella_real new_quaternion_1 = base->Q[0] * t22 - base->Q[3] * t21;
    const ella_real new_quaternion_4 = base->Q[0] * t21 + t22 * base->Q[3];
    const ella_real new_quaternion_2 = t22 * base->Q[1] + base->Q[2] * t21;
    const ella_real new_quaternion_3 = t22 * base->Q[2] - base->Q[1] * t21;

    /* outputs */
    new_q[0] = new_q_1;
    new_twist[0] = omega_R_x;
    new_twist[1] = omega_R_y;
    new_twist[2] = omega_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = base->v_T[2];
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    return ELLA_OK;
}

/* forward kinematics, links like upper_arm: 267 operations */
ELLA_PART ella_status forward_kinematics_upper_arm(const ella_link_constants *c, ella_node *tip, const ella_real q[2],
    const ella_real qdot[2], const ella_real eta[7], const ella_real etadot[7], ella_real new_twist[6],
    ella_real new_quaternion[4], ella_real new_position[3])
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

    const ella_real t1 = q[0] * ELLA_REAL(0.5);
    const ella_sincos turn_3 = ella_sine_cosine(t1);
    const ella_real t2 = turn_3.sine, t3 = turn_3.cosine;
    const ella_real t4 = q[1] * ELLA_REAL(0.5);
    const ella_sincos turn_4 = ella_sine_cosine(t4);
    const ella_real t5 = turn_4.sine, t6 = turn_4.cosine;
    const ella_real new_quaternion_1 = t3 * t6;
    const ella_real new_quaternion_4 = t3 * t5;
    const ella_real new_quaternion_3 = t6 * t2;
    const ella_real new_quaternion_2 = t2 * t5;

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t7 = theta_x * theta_x;
    const ella_real t8 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t7 + t8;
    const ella_real t9 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t9;

    /* c1: Stumpff function of order 1 */
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * ella_c5(x);
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t8 + t9;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t7 + t9;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t10 = c2 * theta_hat2_12;
    const ella_real t11 = c1 * theta_z;
    const ella_real R_T_xy = t10 - t11;
    const ella_real t12 = c1 * theta_y;
    const ella_real t13 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t12 + t13;
    const ella_real R_T_yx = t11 + t10;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t14 = c2 * theta_hat2_23;
    const ella_real t15 = c1 * theta_x;
    const ella_real R_T_yz = t14 - t15;
    const ella_real R_T_zx = t13 - t12;
    const ella_real R_T_zy = t15 + t14;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_y = etadot[0] * ELLA_REAL(2.0011941703010714) + etadot[1] * ELLA_REAL(2.0700807911885764)
        + etadot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_z = etadot[3] * ELLA_REAL(2.0011941703010714) + etadot[4] * ELLA_REAL(2.0700807911885764)
        + etadot[5] * ELLA_REAL(3.5651069283690613);

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_x = etadot[6] * ELLA_REAL(1.7320508075688772);
    const ella_real thetadot_y = c->Psi_c_y4 * etadot[3] + c->Psi_c_y5 * etadot[4] + c->Psi_c_y6 * etadot[5];
    const ella_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1] + c->Psi_c_z3 * etadot[2];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t16 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real t17 = theta_x * thetadot_y - theta_y * thetadot_x;
    const ella_real t18 = theta_z * thetadot_x - theta_x * thetadot_z;
    const ella_real omega_s_x = thetadot_x + c2 * t16 + c3 * (theta_y * t17 - theta_z * t18);
    const ella_real omega_s_y = thetadot_y + c2 * t18 + c3 * (theta_z * t16 - theta_x * t17);
    const ella_real omega_s_z = thetadot_z + c2 * t17 + c3 * (theta_x * t18 - theta_y * t16);

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t19 = omega_s_x + omega_J_x;
    const ella_real t20 = omega_s_y + omega_J_y;
    const ella_real t21 = omega_s_z + qdot[1];
    const ella_real omega_T_x = R_T_xx * t19 + R_T_yx * t20 + R_T_zx * t21;
    const ella_real omega_T_y = R_T_xy * t19 + R_T_yy * t20 + R_T_zy * t21;
    const ella_real omega_T_z = R_T_xz * t19 + R_T_yz * t20 + R_T_zz * t21;

    /* v_T: velocity of the tip point (46) */
    const ella_real t22 = omega_J_y * r_T_z - qdot[1] * r_T_y;
    const ella_real t23 = udot_T_y + c->length * qdot[1] - omega_J_x * r_T_z;
    const ella_real t24 = udot_T_z + omega_J_x * r_T_y - c->length * omega_J_y;
    const ella_real v_T_x = R_T_xx * t22 + R_T_yx * t23 + R_T_zx * t24;
    const ella_real v_T_y = R_T_xy * t22 + R_T_yy * t23 + R_T_zy * t24;
    const ella_real v_T_z = R_T_xz * t22 + R_T_yz * t23 + R_T_zz * t24;

    const ella_real R_xx = R_rel_xx * R_T_xx - minus_R_rel_xy * R_T_yx + R_rel_xz * R_T_zx;
    const ella_real R_xy = R_rel_xx * R_T_xy - minus_R_rel_xy * R_T_yy + R_rel_xz * R_T_zy;
    const ella_real R_xz = R_rel_xx * R_T_xz - minus_R_rel_xy * R_T_yz + R_rel_xz * R_T_zz;
    const ella_real R_yx = R_rel_yx * R_T_xx + R_rel_yy * R_T_yx;
    const ella_real R_yy = R_rel_yx * R_T_xy + R_rel_yy * R_T_yy;
    const ella_real R_yz = R_rel_yx * R_T_xz + R_rel_yy * R_T_yz;
    const ella_real R_zx = R_rel_zy * R_T_yx - minus_R_rel_zx * R_T_xx + R_rel_zz * R_T_zx;
    const ella_real R_zy = R_rel_zy * R_T_yy - minus_R_rel_zx * R_T_xy + R_rel_zz * R_T_zy;
    const ella_real R_zz = R_rel_zy * R_T_yz - minus_R_rel_zx * R_T_xz + R_rel_zz * R_T_zz;
    const ella_real r_x = R_rel_xx * c->length - minus_R_rel_xy * r_T_y + R_rel_xz * r_T_z;
    const ella_real r_y = R_rel_yx * c->length + R_rel_yy * r_T_y;
    const ella_real r_z = R_rel_zy * r_T_y - minus_R_rel_zx * c->length + R_rel_zz * r_T_z;
    const ella_real t25 = x * ELLA_REAL(0.25);
    const ella_real t26 = 1 - t25 * (ELLA_REAL(0.5) - t25 * ella_c4(t25));
    const ella_real t27 = (1 - t25 * (ELLA_REAL(0.16666666666666666) - t25 * ella_c5(t25))) * ELLA_REAL(0.5);
    const ella_real t28 = t27 * theta_x;
    const ella_real t29 = t27 * theta_y;
    const ella_real t30 = t27 * theta_z;
    const ella_real Q_1 = new_quaternion_1 * t26
        - (new_quaternion_2 * t28 + new_quaternion_3 * t29 + new_quaternion_4 * t30);
    const ella_real Q_2 = new_quaternion_1 * t28 + t26 * new_quaternion_2
        + (new_quaternion_3 * t30 - new_quaternion_4 * t29);
    const ella_real Q_3 = new_quaternion_1 * t29 + t26 * new_quaternion_3
        + (new_quaternion_4 * t28 - new_quaternion_2 * t30);
    const ella_real Q_4 = new_quaternion_1 * t30 + t26 * new_quaternion_4
        + (new_quaternion_2 * t29 - new_quaternion_3 * t28);

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
    tip->omega_T[0] = omega_T_x;
    tip->omega_T[1] = omega_T_y;
    tip->omega_T[2] = omega_T_z;
    tip->v_T[0] = v_T_x;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
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

/* forward kinematics, links like forearm: 168 operations */
ELLA_PART ella_status forward_kinematics_forearm(const ella_link_constants *c, const ella_node *base, ella_node *tip,
    const ella_real q[1], const ella_real qdot[1], const ella_real eta[7], ella_real new_twist[6],
    ella_real new_quaternion[4], ella_real new_position[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    /* omega_R: angular velocity of the parent's tip */
    const ella_real omega_R_x = R_rel_xx * base->omega_T[0] + R_rel_yx * base->omega_T[1];
    const ella_real omega_R_y = R_rel_xx * base->omega_T[1] - R_rel_yx * base->omega_T[0];

    /* omega: angular velocity of the link (45) */
    const ella_real omega_z = base->omega_T[2] + qdot[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const ella_real v_R_x = R_rel_xx * base->v_T[0] + R_rel_yx * base->v_T[1];
    const ella_real v_R_y = R_rel_xx * base->v_T[1] - R_rel_yx * base->v_T[0];

    const ella_real t1 = base->R[0] * R_rel_xx + base->R[1] * R_rel_yx;
    const ella_real t2 = base->R[1] * R_rel_xx - base->R[0] * R_rel_yx;
    const ella_real t3 = base->R[3] * R_rel_xx + base->R[4] * R_rel_yx;
    const ella_real t4 = base->R[4] * R_rel_xx - base->R[3] * R_rel_yx;
    const ella_real t5 = base->R[6] * R_rel_xx + base->R[7] * R_rel_yx;
    const ella_real t6 = base->R[7] * R_rel_xx - base->R[6] * R_rel_yx;
    const ella_real t7 = q[0] * ELLA_REAL(0.5);
    const ella_sincos turn_2 = ella_sine_cosine(t7);
    const ella_real t8 = turn_2.sine, t9 = turn_2.cosine;
    const ella_real new_quaternion_1 = base->Q[0] * t9 - base->Q[3] * t8;
    const ella_real new_quaternion_4 = base->Q[0] * t8 + t9 * base->Q[3];
    const ella_real new_quaternion_2 = t9 * base->Q[1] + base->Q[2] * t8;
    const ella_real new_quaternion_3 = t9 * base->Q[2] - base->Q[1] * t8;

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t10 = theta_x * theta_x;
    const ella_real t11 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t10 + t11;
    const ella_real t12 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t12;

    /* c1: Stumpff function of order 1 */
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * ella_c5(x);
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t11 + t12;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t10 + t12;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t13 = c2 * theta_hat2_12;
    const ella_real t14 = c1 * theta_z;
    const ella_real R_T_xy = t13 - t14;
    const ella_real t15 = c1 * theta_y;
    const ella_real t16 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t15 + t16;
    const ella_real R_T_yx = t14 + t13;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t17 = c2 * theta_hat2_23;
    const ella_real t18 = c1 * theta_x;
    const ella_real R_T_yz = t17 - t18;
    const ella_real R_T_zx = t16 - t15;
    const ella_real R_T_zy = t18 + t17;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    const ella_real R_xx = t1 * R_T_xx + t2 * R_T_yx + base->R[2] * R_T_zx;
    const ella_real R_xy = t1 * R_T_xy + t2 * R_T_yy + base->R[2] * R_T_zy;
    const ella_real R_xz = t1 * R_T_xz + t2 * R_T_yz + base->R[2] * R_T_zz;
    const ella_real R_yx = t3 * R_T_xx + t4 * R_T_yx + base->R[5] * R_T_zx;
    const ella_real R_yy = t3 * R_T_xy + t4 * R_T_yy + base->R[5] * R_T_zy;
    const ella_real R_yz = t3 * R_T_xz + t4 * R_T_yz + base->R[5] * R_T_zz;
    const ella_real R_zx = t5 * R_T_xx + t6 * R_T_yx + base->R[8] * R_T_zx;
    const ella_real R_zy = t5 * R_T_xy + t6 * R_T_yy + base->R[8] * R_T_zy;
    const ella_real R_zz = t5 * R_T_xz + t6 * R_T_yz + base->R[8] * R_T_zz;
    const ella_real r_x = base->r[0] + (t1 * c->length + t2 * r_T_y + base->R[2] * r_T_z);
    const ella_real r_y = base->r[1] + (t3 * c->length + t4 * r_T_y + base->R[5] * r_T_z);
    const ella_real r_z = base->r[2] + (t5 * c->length + t6 * r_T_y + base->R[8] * r_T_z);

    /* outputs */
    new_twist[0] = omega_R_x;
    new_twist[1] = omega_R_y;
    new_twist[2] = omega_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = base->v_T[2];
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

/* kinematics, links like upper_arm: 242 operations */
ELLA_PART ella_status kinematics_upper_arm(const ella_link_constants *c, ella_link_store *link, const ella_node *base,
    ella_node *tip, const ella_real q[2], const ella_real qdot[2], const ella_real eta[7], const ella_real etadot[7])
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

    /* acceleration of the parent's tip in F_i axes */
    const ella_real acc_0_a_x = R_rel_xx * base->acc_0[3] + R_rel_yx * base->acc_0[4] - minus_R_rel_zx * base->acc_0[5];
    const ella_real acc_0_a_y = R_rel_yy * base->acc_0[4] - minus_R_rel_xy * base->acc_0[3] + R_rel_zy * base->acc_0[5];
    const ella_real acc_0_a_z = R_rel_xz * base->acc_0[3] + R_rel_zz * base->acc_0[5];

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx * qdot[0];
    const ella_real omega_J_y = R_rel_yy * qdot[0];

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const ella_real t1 = qdot[0] * qdot[1];
    const ella_real alpha_x = t1 * R_rel_yy;
    const ella_real minus_alpha_y = t1 * R_rel_yx;
    const ella_real t2 = -minus_alpha_y;

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t3 = theta_x * theta_x;
    const ella_real t4 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t3 + t4;
    const ella_real t5 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t5;

    /* c2: Stumpff function of order 2 */
    const ella_real t6 = ella_c4(x);
    const ella_real c2 = ELLA_REAL(0.5) - x * t6;

    /* c3: Stumpff function of order 3 */
    const ella_real t7 = ella_c5(x);
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * t7;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_y = etadot[0] * ELLA_REAL(2.0011941703010714) + etadot[1] * ELLA_REAL(2.0700807911885764)
        + etadot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_z = etadot[3] * ELLA_REAL(2.0011941703010714) + etadot[4] * ELLA_REAL(2.0700807911885764)
        + etadot[5] * ELLA_REAL(3.5651069283690613);

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_x = etadot[6] * ELLA_REAL(1.7320508075688772);
    const ella_real thetadot_y = c->Psi_c_y4 * etadot[3] + c->Psi_c_y5 * etadot[4] + c->Psi_c_y6 * etadot[5];
    const ella_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1] + c->Psi_c_z3 * etadot[2];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t8 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real t9 = theta_x * thetadot_y - theta_y * thetadot_x;
    const ella_real t10 = theta_z * thetadot_x - theta_x * thetadot_z;
    const ella_real t11 = theta_y * t9 - theta_z * t10;
    const ella_real omega_s_x = thetadot_x + c2 * t8 + c3 * t11;
    const ella_real t12 = theta_z * t8 - theta_x * t9;
    const ella_real omega_s_y = thetadot_y + c2 * t10 + c3 * t12;
    const ella_real t13 = theta_x * t10 - theta_y * t8;
    const ella_real omega_s_z = thetadot_z + c2 * t9 + c3 * t13;

    /* xdot: rate of the squared angle */
    const ella_real xdot = eta[6] * ELLA_REAL(3.4641016151377544) * thetadot_x + theta_y * 2 * thetadot_y
        + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const ella_real c2dot = xdot * (t6 - c3 * ELLA_REAL(0.5));

    /* c3dot: rate of c3 */
    const ella_real c3dot = xdot * (t7 * ELLA_REAL(1.5) - t6 * ELLA_REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_x = c2dot * t8 + c3 * (thetadot_y * t9 - thetadot_z * t10) + c3dot * t11;
    const ella_real alpha_s_y = c2dot * t10 + c3 * (thetadot_z * t8 - thetadot_x * t9) + c3dot * t12;
    const ella_real alpha_s_z = c2dot * t9 + c3 * (thetadot_x * t10 - thetadot_y * t8) + c3dot * t13;

    /* omega_t: angular velocity of the tip section (46) */
    const ella_real omega_t_x = omega_s_x + omega_J_x;
    const ella_real omega_t_y = omega_s_y + omega_J_y;
    const ella_real omega_t_z = omega_s_z + qdot[1];

    /* alpha_t: angular acceleration of the tip section (accconst1b) */
    const ella_real alpha_t_x = alpha_s_x + alpha_x + omega_s_z * omega_J_y - omega_s_y * qdot[1];
    const ella_real alpha_t_y = alpha_s_y - minus_alpha_y + omega_s_x * qdot[1] - omega_s_z * omega_J_x;
    const ella_real alpha_t_z = alpha_s_z + omega_s_y * omega_J_x - omega_s_x * omega_J_y;

    /* a_t: acceleration of the tip point (accconst1b) */
    const ella_real t14 = udot_T_z * 2 + omega_J_x * r_T_y - c->length * omega_J_y;
    const ella_real t15 = udot_T_y * 2 + c->length * qdot[1] - omega_J_x * r_T_z;
    const ella_real a_t_x = acc_0_a_x - minus_alpha_y * r_T_z + omega_J_y * t14 - qdot[1] * t15;
    const ella_real t16 = omega_J_y * r_T_z - qdot[1] * r_T_y;
    const ella_real a_t_y = acc_0_a_y + qdot[1] * t16 - alpha_x * r_T_z - omega_J_x * t14;
    const ella_real a_t_z = acc_0_a_z + alpha_x * r_T_y + omega_J_x * t15 + minus_alpha_y * c->length - omega_J_y * t16;

    /* c1: Stumpff function of order 1 */
    const ella_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t4 + t5;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t3 + t5;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    const ella_real t17 = c3 * theta_hat2_12;
    const ella_real t18 = c2 * theta_z;
    const ella_real J_l_xy = t17 - t18;
    const ella_real t19 = c2 * theta_y;
    const ella_real t20 = c3 * theta_hat2_13;
    const ella_real J_l_xz = t19 + t20;
    const ella_real J_l_yx = t18 + t17;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const ella_real t21 = c3 * theta_hat2_23;
    const ella_real t22 = c2 * theta_x;
    const ella_real J_l_yz = t21 - t22;
    const ella_real J_l_zx = t20 - t19;
    const ella_real J_l_zy = t22 + t21;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t23 = c2 * theta_hat2_12;
    const ella_real t24 = c1 * theta_z;
    const ella_real R_T_xy = t23 - t24;
    const ella_real t25 = c1 * theta_y;
    const ella_real t26 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t25 + t26;
    const ella_real R_T_yx = t24 + t23;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t27 = c2 * theta_hat2_23;
    const ella_real t28 = c1 * theta_x;
    const ella_real R_T_yz = t27 - t28;
    const ella_real R_T_zx = t26 - t25;
    const ella_real R_T_zy = t28 + t27;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* outputs */
    link->S[0] = R_rel_yx;
    link->S[1] = R_rel_yy;
    link->omega[0] = omega_J_x;
    link->omega[1] = omega_J_y;
    link->omega[2] = qdot[1];
    link->acc_0[0] = alpha_x;
    link->acc_0[1] = t2;
    link->acc_0[3] = acc_0_a_x;
    link->acc_0[4] = acc_0_a_y;
    link->acc_0[5] = acc_0_a_z;
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yx;
    link->R_T[4] = R_T_yy;
    link->R_T[5] = R_T_yz;
    link->R_T[6] = R_T_zx;
    link->R_T[7] = R_T_zy;
    link->R_T[8] = R_T_zz;
    link->J_l[0] = J_l_xx;
    link->J_l[1] = J_l_xy;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yx;
    link->J_l[4] = J_l_yy;
    link->J_l[5] = J_l_yz;
    link->J_l[6] = J_l_zx;
    link->J_l[7] = J_l_zy;
    link->J_l[8] = J_l_zz;
    tip->R_T[0] = R_T_xx;
    tip->R_T[1] = R_T_xy;
    tip->R_T[2] = R_T_xz;
    tip->R_T[3] = R_T_yx;
    tip->R_T[4] = R_T_yy;
    tip->R_T[5] = R_T_yz;
    tip->R_T[6] = R_T_zx;
    tip->R_T[7] = R_T_zy;
    tip->R_T[8] = R_T_zz;
    tip->omega[0] = omega_t_x;
    tip->omega[1] = omega_t_y;
    tip->omega[2] = omega_t_z;
    tip->acc_0[0] = alpha_t_x;
    tip->acc_0[1] = alpha_t_y;
    tip->acc_0[2] = alpha_t_z;
    tip->acc_0[3] = a_t_x;
    tip->acc_0[4] = a_t_y;
    tip->acc_0[5] = a_t_z;
    return ELLA_OK;
}

/* kinematics, links like forearm: 192 operations */
ELLA_PART ella_status kinematics_forearm(const ella_link_constants *c, ella_link_store *link, const ella_node *base,
    ella_node *tip, const ella_real q[1], const ella_real qdot[1], const ella_real eta[7], const ella_real etadot[7])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const ella_real R_P_xx = base->R_T[0] * R_rel_xx + base->R_T[1] * R_rel_yx;
    const ella_real R_P_xy = base->R_T[1] * R_rel_xx - base->R_T[0] * R_rel_yx;
    const ella_real R_P_yx = base->R_T[3] * R_rel_xx + base->R_T[4] * R_rel_yx;
    const ella_real R_P_yy = base->R_T[4] * R_rel_xx - base->R_T[3] * R_rel_yx;
    const ella_real R_P_zx = base->R_T[6] * R_rel_xx + base->R_T[7] * R_rel_yx;
    const ella_real R_P_zy = base->R_T[7] * R_rel_xx - base->R_T[6] * R_rel_yx;
    const ella_real omega_R_x = R_P_xx * base->omega[0] + R_P_yx * base->omega[1] + R_P_zx * base->omega[2];
    const ella_real omega_R_y = R_P_xy * base->omega[0] + R_P_yy * base->omega[1] + R_P_zy * base->omega[2];
    const ella_real omega_R_z = base->R_T[2] * base->omega[0] + base->R_T[5] * base->omega[1]
        + base->R_T[8] * base->omega[2];

    /* acceleration of the parent's tip in F_i axes */
    const ella_real t1 = R_P_xx * base->acc_0[0] + R_P_yx * base->acc_0[1] + R_P_zx * base->acc_0[2];
    const ella_real t2 = R_P_xy * base->acc_0[0] + R_P_yy * base->acc_0[1] + R_P_zy * base->acc_0[2];
    const ella_real acc_0_alpha_z = base->R_T[2] * base->acc_0[0] + base->R_T[5] * base->acc_0[1]
        + base->R_T[8] * base->acc_0[2];
    const ella_real acc_0_a_x = R_P_xx * base->acc_0[3] + R_P_yx * base->acc_0[4] + R_P_zx * base->acc_0[5];
    const ella_real acc_0_a_y = R_P_xy * base->acc_0[3] + R_P_yy * base->acc_0[4] + R_P_zy * base->acc_0[5];
    const ella_real acc_0_a_z = base->R_T[2] * base->acc_0[3] + base->R_T[5] * base->acc_0[4]
        + base->R_T[8] * base->acc_0[5];

    /* omega: angular velocity of the link (45) */
    const ella_real omega_z = omega_R_z + qdot[0];

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const ella_real alpha_x = t1 + omega_R_y * qdot[0];
    const ella_real alpha_y = t2 - omega_R_x * qdot[0];

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t3 = theta_x * theta_x;
    const ella_real t4 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t3 + t4;
    const ella_real t5 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t5;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* c3: Stumpff function of order 3 */
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * ella_c5(x);

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_y = etadot[0] * ELLA_REAL(2.0011941703010714) + etadot[1] * ELLA_REAL(2.0700807911885764)
        + etadot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_z = etadot[3] * ELLA_REAL(2.0011941703010714) + etadot[4] * ELLA_REAL(2.0700807911885764)
        + etadot[5] * ELLA_REAL(3.5651069283690613);

    /* a_t: acceleration of the tip point (accconst1b) */
    const ella_real t6 = udot_T_z * 2 + omega_R_x * r_T_y - c->length * omega_R_y;
    const ella_real t7 = udot_T_y * 2 + c->length * omega_z - omega_R_x * r_T_z;
    const ella_real a_t_x = acc_0_a_x + alpha_y * r_T_z + omega_R_y * t6 - acc_0_alpha_z * r_T_y - omega_z * t7;
    const ella_real t8 = omega_R_y * r_T_z - omega_z * r_T_y;
    const ella_real a_t_y = acc_0_a_y + acc_0_alpha_z * c->length + omega_z * t8 - alpha_x * r_T_z - omega_R_x * t6;
    const ella_real a_t_z = acc_0_a_z + alpha_x * r_T_y + omega_R_x * t7 - alpha_y * c->length - omega_R_y * t8;

    /* c1: Stumpff function of order 1 */
    const ella_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t4 + t5;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t3 + t5;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    const ella_real t9 = c3 * theta_hat2_12;
    const ella_real t10 = c2 * theta_z;
    const ella_real J_l_xy = t9 - t10;
    const ella_real t11 = c2 * theta_y;
    const ella_real t12 = c3 * theta_hat2_13;
    const ella_real J_l_xz = t11 + t12;
    const ella_real J_l_yx = t10 + t9;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const ella_real t13 = c3 * theta_hat2_23;
    const ella_real t14 = c2 * theta_x;
    const ella_real J_l_yz = t13 - t14;
    const ella_real J_l_zx = t12 - t11;
    const ella_real J_l_zy = t14 + t13;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t15 = c2 * theta_hat2_12;
    const ella_real t16 = c1 * theta_z;
    const ella_real R_T_xy = t15 - t16;
    const ella_real t17 = c1 * theta_y;
    const ella_real t18 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t17 + t18;
    const ella_real R_T_yx = t16 + t15;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t19 = c2 * theta_hat2_23;
    const ella_real t20 = c1 * theta_x;
    const ella_real R_T_yz = t19 - t20;
    const ella_real R_T_zx = t18 - t17;
    const ella_real R_T_zy = t20 + t19;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* outputs */
    link->R_P[0] = R_P_xx;
    link->R_P[1] = R_P_xy;
    link->R_P[2] = base->R_T[2];
    link->R_P[3] = R_P_yx;
    link->R_P[4] = R_P_yy;
    link->R_P[5] = base->R_T[5];
    link->R_P[6] = R_P_zx;
    link->R_P[7] = R_P_zy;
    link->R_P[8] = base->R_T[8];
    link->omega[0] = omega_R_x;
    link->omega[1] = omega_R_y;
    link->omega[2] = omega_z;
    link->acc_0[0] = alpha_x;
    link->acc_0[1] = alpha_y;
    link->acc_0[2] = acc_0_alpha_z;
    link->acc_0[3] = acc_0_a_x;
    link->acc_0[4] = acc_0_a_y;
    link->acc_0[5] = acc_0_a_z;
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yx;
    link->R_T[4] = R_T_yy;
    link->R_T[5] = R_T_yz;
    link->R_T[6] = R_T_zx;
    link->R_T[7] = R_T_zy;
    link->R_T[8] = R_T_zz;
    link->J_l[0] = J_l_xx;
    link->J_l[1] = J_l_xy;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yx;
    link->J_l[4] = J_l_yy;
    link->J_l[5] = J_l_yz;
    link->J_l[6] = J_l_zx;
    link->J_l[7] = J_l_zy;
    link->J_l[8] = J_l_zz;
    tip->acc_0[3] = a_t_x;
    tip->acc_0[4] = a_t_y;
    tip->acc_0[5] = a_t_z;
    return ELLA_OK;
}

/* inverse outward, links like upper_arm: 52 operations */
ELLA_PART ella_status inverse_outward_upper_arm(const ella_link_constants *c, ella_link_store *link, ella_node *tip,
    const ella_real qddot[2], const ella_real etaddot[7])
{
    const ella_real delta_alpha_x = link->S[0] * qddot[0];
    const ella_real delta_alpha_y = link->S[1] * qddot[0];
    const ella_real t1 = etaddot[6] * ELLA_REAL(1.7320508075688772);
    const ella_real t2 = c->Psi_c_y4 * etaddot[3] + c->Psi_c_y5 * etaddot[4] + c->Psi_c_y6 * etaddot[5];
    const ella_real t3 = c->Psi_c_z1 * etaddot[0] + c->Psi_c_z2 * etaddot[1] + c->Psi_c_z3 * etaddot[2];
    const ella_real t4 = etaddot[0] * ELLA_REAL(2.0011941703010714) + etaddot[1] * ELLA_REAL(2.0700807911885764)
        + etaddot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real t5 = etaddot[3] * ELLA_REAL(2.0011941703010714) + etaddot[4] * ELLA_REAL(2.0700807911885764)
        + etaddot[5] * ELLA_REAL(3.5651069283690613);
    const ella_real delta_a_x = delta_alpha_y * link->r_T[1] - qddot[1] * link->r_T[0];
    const ella_real delta_alpha_x_2 = delta_alpha_x + (link->J_l[0] * t1 + link->J_l[1] * t2 + link->J_l[2] * t3);
    const ella_real delta_alpha_y_2 = delta_alpha_y + (link->J_l[3] * t1 + link->J_l[4] * t2 + link->J_l[5] * t3);
    const ella_real delta_alpha_z = qddot[1] + (link->J_l[6] * t1 + link->J_l[7] * t2 + link->J_l[8] * t3);
    const ella_real delta_a_y = qddot[1] * c->length - delta_alpha_x * link->r_T[1] + t4;
    const ella_real delta_a_z = delta_alpha_x * link->r_T[0] - delta_alpha_y * c->length + t5;

    /* outputs */
    link->delta[0] = delta_alpha_x;
    link->delta[1] = delta_alpha_y;
    link->delta[2] = qddot[1];
    tip->delta[0] = delta_alpha_x_2;
    tip->delta[1] = delta_alpha_y_2;
    tip->delta[2] = delta_alpha_z;
    tip->delta[3] = delta_a_x;
    tip->delta[4] = delta_a_y;
    tip->delta[5] = delta_a_z;
    return ELLA_OK;
}

/* inverse outward, links like forearm: 55 operations */
ELLA_PART ella_status inverse_outward_forearm(const ella_link_constants *c, ella_link_store *link,
    const ella_node *base, ella_node *tip, const ella_real qddot[1], const ella_real etaddot[7])
{
    const ella_real delta_alpha_x = link->R_P[0] * base->delta[0] + link->R_P[3] * base->delta[1]
        + link->R_P[6] * base->delta[2];
    const ella_real delta_alpha_y = link->R_P[1] * base->delta[0] + link->R_P[4] * base->delta[1]
        + link->R_P[7] * base->delta[2];
    const ella_real delta_a_x = link->R_P[0] * base->delta[3] + link->R_P[3] * base->delta[4]
        + link->R_P[6] * base->delta[5];
    const ella_real delta_a_y = link->R_P[1] * base->delta[3] + link->R_P[4] * base->delta[4]
        + link->R_P[7] * base->delta[5];
    const ella_real delta_a_z = link->R_P[2] * base->delta[3] + link->R_P[5] * base->delta[4]
        + link->R_P[8] * base->delta[5];
    const ella_real delta_alpha_z = link->R_P[2] * base->delta[0] + link->R_P[5] * base->delta[1]
        + link->R_P[8] * base->delta[2] + qddot[0];
    const ella_real t1 = etaddot[0] * ELLA_REAL(2.0011941703010714) + etaddot[1] * ELLA_REAL(2.0700807911885764)
        + etaddot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real t2 = etaddot[3] * ELLA_REAL(2.0011941703010714) + etaddot[4] * ELLA_REAL(2.0700807911885764)
        + etaddot[5] * ELLA_REAL(3.5651069283690613);
    const ella_real delta_a_x_2 = delta_a_x + (delta_alpha_y * link->r_T[1] - delta_alpha_z * link->r_T[0]);
    const ella_real delta_a_y_2 = delta_a_y + (delta_alpha_z * c->length - delta_alpha_x * link->r_T[1]) + t1;
    const ella_real delta_a_z_2 = delta_a_z + (delta_alpha_x * link->r_T[0] - delta_alpha_y * c->length) + t2;

    /* outputs */
    link->delta[0] = delta_alpha_x;
    link->delta[1] = delta_alpha_y;
    link->delta[2] = delta_alpha_z;
    link->delta[3] = delta_a_x;
    link->delta[4] = delta_a_y;
    link->delta[5] = delta_a_z;
    tip->delta[3] = delta_a_x_2;
    tip->delta[4] = delta_a_y_2;
    tip->delta[5] = delta_a_z_2;
    return ELLA_OK;
}

/* inverse inward, links like upper_arm: 493 operations */
ELLA_PART ella_status inverse_inward_upper_arm(const ella_link_constants *c, const ella_link_store *link,
    const ella_node *tip, const ella_real etaddot[7], const ella_real eta[7], const ella_real etadot[7],
    const ella_real w_ext[6], const ella_real m_eta[7], const ella_real f_eta[7], ella_real force_eta[7],
    ella_real force[2], ella_real wrench[6])
{
    /* S: first moment */
    const ella_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2 + eta[2] * c->sigma_y3;
    const ella_real S_z = eta[3] * c->sigma_y1 + eta[4] * c->sigma_y2 + eta[5] * c->sigma_y3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_y1 = c->mu * eta[0];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_y3 = c->mu * eta[2];
    const ella_real L_z1 = eta[3] * c->mu;
    const ella_real L_z2 = eta[4] * c->mu;
    const ella_real L_z3 = eta[5] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_y1 = c->mu * etadot[0];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_y3 = c->mu * etadot[2];
    const ella_real Ldot_z1 = etadot[3] * c->mu;
    const ella_real Ldot_z2 = etadot[4] * c->mu;
    const ella_real Ldot_z3 = etadot[5] * c->mu;

    /* J: second moment */
    const ella_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1] + c->chi_3 * eta[2];
    const ella_real J_xz = c->chi_1 * eta[3] + c->chi_2 * eta[4] + c->chi_3 * eta[5];
    const ella_real J_yy = L_y1 * eta[0] + L_y2 * eta[1] + L_y3 * eta[2];
    const ella_real J_yz = L_z1 * eta[0] + L_z2 * eta[1] + L_z3 * eta[2];
    const ella_real J_zz = L_z1 * eta[3] + L_z2 * eta[4] + L_z3 * eta[5];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = c->J_0_xx + J_zz;
    const ella_real I_zz = c->J_0_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const ella_real t1 = link->omega[1] * link->omega[1];
    const ella_real t2 = link->omega[2] * link->omega[2];
    const ella_real minus_Omega_xx = t1 + t2;
    const ella_real Omega_xy = link->omega[0] * link->omega[1];
    const ella_real t3 = link->omega[0] * link->omega[2];
    const ella_real Omega_xz = link->acc_0[1] + t3;
    const ella_real t4 = link->omega[0] * link->omega[0];
    const ella_real minus_Omega_yy = t4 + t2;
    const ella_real t5 = link->omega[1] * link->omega[2];
    const ella_real Omega_yz = t5 - link->acc_0[0];
    const ella_real Omega_zx = t3 - link->acc_0[1];
    const ella_real Omega_zy = link->acc_0[0] + t5;
    const ella_real minus_Omega_zz = t4 + t1;

    /* B: moment of the elastic velocity */
    const ella_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1] + c->chi_3 * etadot[2];
    const ella_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1] + L_y3 * etadot[2];
    const ella_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1] + L_z3 * etadot[2];
    const ella_real B_zx = c->chi_1 * etadot[3] + c->chi_2 * etadot[4] + c->chi_3 * etadot[5];
    const ella_real B_zy = L_y1 * etadot[3] + L_y2 * etadot[4] + L_y3 * etadot[5];
    const ella_real B_zz = L_z1 * etadot[3] + L_z2 * etadot[4] + L_z3 * etadot[5];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const ella_real h_c_tau_x = B_yy * link->omega[0] + B_zz * link->omega[0];
    const ella_real h_c_tau_y = B_zz * link->omega[1] - B_yx * link->omega[0] - B_yz * link->omega[2];
    const ella_real h_c_tau_z = B_yy * link->omega[2] - B_zx * link->omega[0] - B_zy * link->omega[1];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const ella_real h_MD_tau_y = h_c_tau_y + etadot[6] * link->omega[2] * c->sigma_t_7;
    const ella_real h_MD_tau_z = h_c_tau_z - etadot[6] * link->omega[1] * c->sigma_t_7;

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t6 = h_c_tau_x + c->I_s * link->acc_0[0] + J_xy * Omega_zx + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const ella_real H_star_tau_x = t6 + S_y * link->acc_0[5] - J_xz * Omega_xy - J_zz * Omega_yz - S_z * link->acc_0[4];
    const ella_real t7 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->acc_0[3];
    const ella_real t8 = c->I_s * link->omega[0];
    const ella_real H_star_tau_y = t7 + t8 * link->omega[2] - c->J_0_xx * Omega_zx - J_xy * Omega_zy
        - c->S_0_x * link->acc_0[5];
    const ella_real t9 = h_c_tau_z + c->J_0_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy) + J_xz * Omega_yz
        + c->S_0_x * link->acc_0[4];
    const ella_real H_star_tau_z = t9 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->acc_0[3] - t8 * link->omega[1];

    /* h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const ella_real h_V_tau_y = H_star_tau_y + h_MD_tau_y;
    const ella_real h_V_tau_z = H_star_tau_z + h_MD_tau_z;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_xy * c->chi_1
        + link->acc_0[4] * c->sigma_y1 - Ldot_z1 * 2 * link->omega[0];
    const ella_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_xy * c->chi_2
        + link->acc_0[4] * c->sigma_y2 - Ldot_z2 * 2 * link->omega[0];
    const ella_real h_eta_3 = L_z3 * Omega_yz - L_y3 * minus_Omega_yy + Omega_xy * c->chi_3
        + link->acc_0[4] * c->sigma_y3 - Ldot_z3 * 2 * link->omega[0];
    const ella_real h_eta_4 = L_y1 * Omega_zy - L_z1 * minus_Omega_zz + Omega_zx * c->chi_1
        + link->acc_0[5] * c->sigma_y1 + Ldot_y1 * 2 * link->omega[0];
    const ella_real h_eta_5 = L_y2 * Omega_zy - L_z2 * minus_Omega_zz + Omega_zx * c->chi_2
        + link->acc_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];
    const ella_real h_eta_6 = L_y3 * Omega_zy - L_z3 * minus_Omega_zz + Omega_zx * c->chi_3
        + link->acc_0[5] * c->sigma_y3 + Ldot_y3 * 2 * link->omega[0];
    const ella_real h_eta_7 = link->acc_0[0] * c->sigma_t_7;

    const ella_real t10 = c->body0_mass * (tip->acc_0[3] + tip->delta[3])
        - (link->R_T[0] * w_ext[3] + link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const ella_real t11 = c->body0_mass * (tip->acc_0[4] + tip->delta[4])
        - (link->R_T[3] * w_ext[3] + link->R_T[4] * w_ext[4] + link->R_T[5] * w_ext[5]);
    const ella_real t12 = c->body0_mass * (tip->acc_0[5] + tip->delta[5])
        - (link->R_T[6] * w_ext[3] + link->R_T[7] * w_ext[4] + link->R_T[8] * w_ext[5]);
    const ella_real t13 = tip->p[0] - (link->R_T[0] * w_ext[0] + link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2]);
    const ella_real t14 = tip->p[1] - (link->R_T[3] * w_ext[0] + link->R_T[4] * w_ext[1] + link->R_T[5] * w_ext[2]);
    const ella_real t15 = tip->p[2] - (link->R_T[6] * w_ext[0] + link->R_T[7] * w_ext[1] + link->R_T[8] * w_ext[2]);
    const ella_real t16 = t10 + tip->p[3];
    const ella_real t17 = t11 + tip->p[4];
    const ella_real t18 = t12 + tip->p[5];
    const ella_real t19 = L_y1 * etaddot[3] - (L_z1 * etaddot[0] + L_z2 * etaddot[1] + L_z3 * etaddot[2])
        + L_y2 * etaddot[4];
    const ella_real t20 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2]
        + (t19 + L_y3 * etaddot[5] + c->sigma_t_7 * etaddot[6]);
    const ella_real t21 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2]
        - (c->chi_1 * etaddot[3] + c->chi_2 * etaddot[4] + c->chi_3 * etaddot[5]);
    const ella_real t22 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        + (c->chi_1 * etaddot[0] + c->chi_2 * etaddot[1] + c->chi_3 * etaddot[2]);
    const ella_real wrench_tau_x = t20 + h_V_tau_x + (t13 + (link->r_T[0] * t18 - link->r_T[1] * t17));
    const ella_real wrench_tau_y = t21 + h_V_tau_y + (t14 + (link->r_T[1] * t16 - c->length * t18));
    const ella_real force_2 = t22 + h_V_tau_z + (t15 + (c->length * t17 - link->r_T[0] * t16));
    const ella_real t23 = link->J_l[1] * t13 + link->J_l[4] * t14 + link->J_l[7] * t15;
    const ella_real t24 = link->J_l[2] * t13 + link->J_l[5] * t14 + link->J_l[8] * t15;
    const ella_real t25 = c->chi_1 * link->delta[2] - L_z1 * link->delta[0] + m_eta[0] * etaddot[0] + h_eta_1
        + f_eta[0] + c->Psi_c_z1 * t24;
    const ella_real t26 = c->chi_2 * link->delta[2] - L_z2 * link->delta[0] + m_eta[1] * etaddot[1] + h_eta_2
        + f_eta[1] + c->Psi_c_z2 * t24;
    const ella_real t27 = c->chi_3 * link->delta[2] - L_z3 * link->delta[0] + m_eta[2] * etaddot[2] + h_eta_3
        + f_eta[2] + c->Psi_c_z3 * t24;
    const ella_real t28 = L_y1 * link->delta[0] - c->chi_1 * link->delta[1] + m_eta[3] * etaddot[3] + h_eta_4
        + f_eta[3] + c->Psi_c_y4 * t23;
    const ella_real t29 = L_y2 * link->delta[0] - c->chi_2 * link->delta[1] + m_eta[4] * etaddot[4] + h_eta_5
        + f_eta[4] + c->Psi_c_y5 * t23;
    const ella_real t30 = L_y3 * link->delta[0] - c->chi_3 * link->delta[1] + m_eta[5] * etaddot[5] + h_eta_6
        + f_eta[5] + c->Psi_c_y6 * t23;
    const ella_real force_eta_7 = c->sigma_t_7 * link->delta[0] + m_eta[6] * etaddot[6] + h_eta_7 + f_eta[6]
        + (link->J_l[0] * t13 + link->J_l[3] * t14 + link->J_l[6] * t15) * ELLA_REAL(1.7320508075688772);
    const ella_real force_eta_1 = t25 + t17 * ELLA_REAL(2.0011941703010714);
    const ella_real force_eta_2 = t26 + t17 * ELLA_REAL(2.0700807911885764);
    const ella_real force_eta_3 = t27 + t17 * ELLA_REAL(3.5651069283690613);
    const ella_real force_eta_4 = t28 + t18 * ELLA_REAL(2.0011941703010714);
    const ella_real force_eta_5 = t29 + t18 * ELLA_REAL(2.0700807911885764);
    const ella_real force_eta_6 = t30 + t18 * ELLA_REAL(3.5651069283690613);
    const ella_real force_1 = link->S[0] * wrench_tau_x + link->S[1] * wrench_tau_y;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force_eta[3] = force_eta_4;
    force_eta[4] = force_eta_5;
    force_eta[5] = force_eta_6;
    force_eta[6] = force_eta_7;
    force[0] = force_1;
    force[1] = force_2;

    if (wrench) {
        /* Sdot: rate of the first moment */
        const ella_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2 + etadot[2] * c->sigma_y3;
        const ella_real Sdot_z = etadot[3] * c->sigma_y1 + etadot[4] * c->sigma_y2 + etadot[5] * c->sigma_y3;

        /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
        const ella_real h_c_f_x = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
        const ella_real minus_h_c_f_y = Sdot_z * link->omega[0];
        const ella_real h_c_f_z = Sdot_y * link->omega[0];

        /* H_star: gyroscopic wrench and weight, angular acceleration included */
        const ella_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
            + link->acc_0[3] * c->mu;
        const ella_real H_star_f_y = Omega_xy * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
            + link->acc_0[4] * c->mu;
        const ella_real H_star_f_z = h_c_f_z + Omega_zx * c->S_0_x + Omega_zy * S_y - minus_Omega_zz * S_z
            + link->acc_0[5] * c->mu;

        /* h_V: bias of the twist rows, angular acceleration included */
        const ella_real h_V_f_x = H_star_f_x + h_c_f_x;
        const ella_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
        const ella_real h_V_f_z = H_star_f_z + h_c_f_z;

        const ella_real t31 = c->S_0_x * link->delta[2] - S_z * link->delta[0]
            + (c->sigma_y1 * etaddot[0] + c->sigma_y2 * etaddot[1] + c->sigma_y3 * etaddot[2]);
        const ella_real t32 = S_y * link->delta[0] - c->S_0_x * link->delta[1]
            + (c->sigma_y1 * etaddot[3] + c->sigma_y2 * etaddot[4] + c->sigma_y3 * etaddot[5]);
        const ella_real motion_4 = S_z * link->delta[1] - S_y * link->delta[2] + h_V_f_x;
        const ella_real wrench_f_x = motion_4 + t16;
        const ella_real wrench_f_y = t31 + h_V_f_y + t17;
        const ella_real wrench_f_z = t32 + h_V_f_z + t18;

        /* outputs */
        wrench[0] = wrench_tau_x;
        wrench[1] = wrench_tau_y;
        wrench[2] = force_2;
        wrench[3] = wrench_f_x;
        wrench[4] = wrench_f_y;
        wrench[5] = wrench_f_z;
    }
    return ELLA_OK;
}

/* inverse inward, links like forearm: 546 operations */
ELLA_PART ella_status inverse_inward_forearm(const ella_link_constants *c, const ella_link_store *link, ella_node *base,
    const ella_node *tip, const ella_real etaddot[7], const ella_real eta[7], const ella_real etadot[7],
    const ella_real w_ext[6], const ella_real m_eta[7], const ella_real f_eta[7], ella_real force_eta[7],
    ella_real force[1], ella_real wrench[6])
{
    /* S: first moment */
    const ella_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2 + eta[2] * c->sigma_y3;
    const ella_real S_z = eta[3] * c->sigma_y1 + eta[4] * c->sigma_y2 + eta[5] * c->sigma_y3;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2 + etadot[2] * c->sigma_y3;
    const ella_real Sdot_z = etadot[3] * c->sigma_y1 + etadot[4] * c->sigma_y2 + etadot[5] * c->sigma_y3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_y1 = c->mu * eta[0];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_y3 = c->mu * eta[2];
    const ella_real L_z1 = eta[3] * c->mu;
    const ella_real L_z2 = eta[4] * c->mu;
    const ella_real L_z3 = eta[5] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_y1 = c->mu * etadot[0];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_y3 = c->mu * etadot[2];
    const ella_real Ldot_z1 = etadot[3] * c->mu;
    const ella_real Ldot_z2 = etadot[4] * c->mu;
    const ella_real Ldot_z3 = etadot[5] * c->mu;

    /* J: second moment */
    const ella_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1] + c->chi_3 * eta[2];
    const ella_real J_xz = c->chi_1 * eta[3] + c->chi_2 * eta[4] + c->chi_3 * eta[5];
    const ella_real J_yy = L_y1 * eta[0] + L_y2 * eta[1] + L_y3 * eta[2];
    const ella_real J_yz = L_z1 * eta[0] + L_z2 * eta[1] + L_z3 * eta[2];
    const ella_real J_zz = L_z1 * eta[3] + L_z2 * eta[4] + L_z3 * eta[5];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = c->J_0_xx + J_zz;
    const ella_real I_zz = c->J_0_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const ella_real t1 = link->omega[1] * link->omega[1];
    const ella_real t2 = link->omega[2] * link->omega[2];
    const ella_real minus_Omega_xx = t1 + t2;
    const ella_real t3 = link->omega[0] * link->omega[1];
    const ella_real Omega_xy = t3 - link->acc_0[2];
    const ella_real t4 = link->omega[0] * link->omega[2];
    const ella_real Omega_xz = link->acc_0[1] + t4;
    const ella_real Omega_yx = link->acc_0[2] + t3;
    const ella_real t5 = link->omega[0] * link->omega[0];
    const ella_real minus_Omega_yy = t5 + t2;
    const ella_real t6 = link->omega[1] * link->omega[2];
    const ella_real Omega_yz = t6 - link->acc_0[0];
    const ella_real Omega_zx = t4 - link->acc_0[1];
    const ella_real Omega_zy = link->acc_0[0] + t6;
    const ella_real minus_Omega_zz = t5 + t1;

    /* B: moment of the elastic velocity */
    const ella_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1] + c->chi_3 * etadot[2];
    const ella_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1] + L_y3 * etadot[2];
    const ella_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1] + L_z3 * etadot[2];
    const ella_real B_zx = c->chi_1 * etadot[3] + c->chi_2 * etadot[4] + c->chi_3 * etadot[5];
    const ella_real B_zy = L_y1 * etadot[3] + L_y2 * etadot[4] + L_y3 * etadot[5];
    const ella_real B_zz = L_z1 * etadot[3] + L_z2 * etadot[4] + L_z3 * etadot[5];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const ella_real h_c_tau_x = B_yy * link->omega[0] + B_zz * link->omega[0];
    const ella_real h_c_tau_y = B_zz * link->omega[1] - B_yx * link->omega[0] - B_yz * link->omega[2];
    const ella_real h_c_tau_z = B_yy * link->omega[2] - B_zx * link->omega[0] - B_zy * link->omega[1];
    const ella_real h_c_f_x = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
    const ella_real minus_h_c_f_y = Sdot_z * link->omega[0];
    const ella_real h_c_f_z = Sdot_y * link->omega[0];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const ella_real h_MD_tau_y = h_c_tau_y + etadot[6] * link->omega[2] * c->sigma_t_7;
    const ella_real h_MD_tau_z = h_c_tau_z - etadot[6] * link->omega[1] * c->sigma_t_7;

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t7 = h_c_tau_x + c->I_s * link->acc_0[0] + J_xy * Omega_zx + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const ella_real H_star_tau_x = t7 + S_y * link->acc_0[5] - J_xz * Omega_yx - J_zz * Omega_yz - S_z * link->acc_0[4];
    const ella_real t8 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->acc_0[3];
    const ella_real t9 = c->I_s * link->omega[0];
    const ella_real H_star_tau_y = t8 + t9 * link->omega[2] - c->J_0_xx * Omega_zx - J_xy * Omega_zy
        - c->S_0_x * link->acc_0[5];
    const ella_real t10 = h_c_tau_z + c->J_0_xx * Omega_yx + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * link->acc_0[4];
    const ella_real H_star_tau_z = t10 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->acc_0[3] - t9 * link->omega[1];
    const ella_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + link->acc_0[3] * c->mu;
    const ella_real H_star_f_y = Omega_yx * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + link->acc_0[4] * c->mu;
    const ella_real H_star_f_z = h_c_f_z + Omega_zx * c->S_0_x + Omega_zy * S_y - minus_Omega_zz * S_z
        + link->acc_0[5] * c->mu;

    /* h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const ella_real h_V_tau_y = H_star_tau_y + h_MD_tau_y;
    const ella_real h_V_tau_z = H_star_tau_z + h_MD_tau_z;
    const ella_real h_V_f_x = H_star_f_x + h_c_f_x;
    const ella_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const ella_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_yx * c->chi_1
        + link->acc_0[4] * c->sigma_y1 - Ldot_z1 * 2 * link->omega[0];
    const ella_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_yx * c->chi_2
        + link->acc_0[4] * c->sigma_y2 - Ldot_z2 * 2 * link->omega[0];
    const ella_real h_eta_3 = L_z3 * Omega_yz - L_y3 * minus_Omega_yy + Omega_yx * c->chi_3
        + link->acc_0[4] * c->sigma_y3 - Ldot_z3 * 2 * link->omega[0];
    const ella_real h_eta_4 = L_y1 * Omega_zy - L_z1 * minus_Omega_zz + Omega_zx * c->chi_1
        + link->acc_0[5] * c->sigma_y1 + Ldot_y1 * 2 * link->omega[0];
    const ella_real h_eta_5 = L_y2 * Omega_zy - L_z2 * minus_Omega_zz + Omega_zx * c->chi_2
        + link->acc_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];
    const ella_real h_eta_6 = L_y3 * Omega_zy - L_z3 * minus_Omega_zz + Omega_zx * c->chi_3
        + link->acc_0[5] * c->sigma_y3 + Ldot_y3 * 2 * link->omega[0];
    const ella_real h_eta_7 = link->acc_0[0] * c->sigma_t_7;

    const ella_real t11 = link->R_T[0] * w_ext[0] + link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2];
    const ella_real t12 = link->R_T[3] * w_ext[0] + link->R_T[4] * w_ext[1] + link->R_T[5] * w_ext[2];
    const ella_real t13 = link->R_T[6] * w_ext[0] + link->R_T[7] * w_ext[1] + link->R_T[8] * w_ext[2];
    const ella_real t14 = c->body0_mass * (tip->acc_0[3] + tip->delta[3])
        - (link->R_T[0] * w_ext[3] + link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const ella_real t15 = c->body0_mass * (tip->acc_0[4] + tip->delta[4])
        - (link->R_T[3] * w_ext[3] + link->R_T[4] * w_ext[4] + link->R_T[5] * w_ext[5]);
    const ella_real t16 = c->body0_mass * (tip->acc_0[5] + tip->delta[5])
        - (link->R_T[6] * w_ext[3] + link->R_T[7] * w_ext[4] + link->R_T[8] * w_ext[5]);
    const ella_real t17 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2] - S_z * link->delta[4]
        + S_y * link->delta[5];
    const ella_real t18 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2] + S_z * link->delta[3]
        - c->S_0_x * link->delta[5];
    const ella_real t19 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        - S_y * link->delta[3] + c->S_0_x * link->delta[4];
    const ella_real t20 = L_y1 * etaddot[3] - (L_z1 * etaddot[0] + L_z2 * etaddot[1] + L_z3 * etaddot[2])
        + L_y2 * etaddot[4];
    const ella_real t21 = c->S_0_x * link->delta[2] - S_z * link->delta[0] + c->mu * link->delta[4]
        + (c->sigma_y1 * etaddot[0] + c->sigma_y2 * etaddot[1] + c->sigma_y3 * etaddot[2]);
    const ella_real t22 = S_y * link->delta[0] - c->S_0_x * link->delta[1] + c->mu * link->delta[5]
        + (c->sigma_y1 * etaddot[3] + c->sigma_y2 * etaddot[4] + c->sigma_y3 * etaddot[5]);
    const ella_real motion_4 = S_z * link->delta[1] - S_y * link->delta[2] + c->mu * link->delta[3] + h_V_f_x;
    const ella_real wrench_tau_x = t17 + (t20 + L_y3 * etaddot[5] + c->sigma_t_7 * etaddot[6]) + h_V_tau_x
        + (link->r_T[0] * t16 - link->r_T[1] * t15 - t11);
    const ella_real wrench_tau_y = t18 - (c->chi_1 * etaddot[3] + c->chi_2 * etaddot[4] + c->chi_3 * etaddot[5])
        + h_V_tau_y + (link->r_T[1] * t14 - c->length * t16 - t12);
    const ella_real force_1 = t19 + (c->chi_1 * etaddot[0] + c->chi_2 * etaddot[1] + c->chi_3 * etaddot[2])
        + h_V_tau_z + (c->length * t15 - link->r_T[0] * t14 - t13);
    const ella_real wrench_f_x = motion_4 + t14;
    const ella_real wrench_f_y = t21 + h_V_f_y + t15;
    const ella_real wrench_f_z = t22 + h_V_f_z + t16;
    const ella_real t23 = c->chi_1 * link->delta[2] - L_z1 * link->delta[0] + c->sigma_y1 * link->delta[4]
        + m_eta[0] * etaddot[0];
    const ella_real t24 = c->chi_2 * link->delta[2] - L_z2 * link->delta[0] + c->sigma_y2 * link->delta[4]
        + m_eta[1] * etaddot[1];
    const ella_real t25 = c->chi_3 * link->delta[2] - L_z3 * link->delta[0] + c->sigma_y3 * link->delta[4]
        + m_eta[2] * etaddot[2];
    const ella_real t26 = L_y1 * link->delta[0] - c->chi_1 * link->delta[1] + c->sigma_y1 * link->delta[5]
        + m_eta[3] * etaddot[3];
    const ella_real t27 = L_y2 * link->delta[0] - c->chi_2 * link->delta[1] + c->sigma_y2 * link->delta[5]
        + m_eta[4] * etaddot[4];
    const ella_real t28 = L_y3 * link->delta[0] - c->chi_3 * link->delta[1] + c->sigma_y3 * link->delta[5]
        + m_eta[5] * etaddot[5];
    const ella_real t29 = link->J_l[1] * t11 + link->J_l[4] * t12 + link->J_l[7] * t13;
    const ella_real t30 = link->J_l[2] * t11 + link->J_l[5] * t12 + link->J_l[8] * t13;
    const ella_real force_eta_7 = c->sigma_t_7 * link->delta[0] + m_eta[6] * etaddot[6] + h_eta_7 + f_eta[6]
        - (link->J_l[0] * t11 + link->J_l[3] * t12 + link->J_l[6] * t13) * ELLA_REAL(1.7320508075688772);
    const ella_real force_eta_1 = t23 + h_eta_1 + f_eta[0] - c->Psi_c_z1 * t30 + t15 * ELLA_REAL(2.0011941703010714);
    const ella_real force_eta_2 = t24 + h_eta_2 + f_eta[1] - c->Psi_c_z2 * t30 + t15 * ELLA_REAL(2.0700807911885764);
    const ella_real force_eta_3 = t25 + h_eta_3 + f_eta[2] - c->Psi_c_z3 * t30 + t15 * ELLA_REAL(3.5651069283690613);
    const ella_real force_eta_4 = t26 + h_eta_4 + f_eta[3] - c->Psi_c_y4 * t29 + t16 * ELLA_REAL(2.0011941703010714);
    const ella_real force_eta_5 = t27 + h_eta_5 + f_eta[4] - c->Psi_c_y5 * t29 + t16 * ELLA_REAL(2.0700807911885764);
    const ella_real force_eta_6 = t28 + h_eta_6 + f_eta[5] - c->Psi_c_y6 * t29 + t16 * ELLA_REAL(3.5651069283690613);
    const ella_real p_tau_x = link->R_P[0] * wrench_tau_x + link->R_P[1] * wrench_tau_y + link->R_P[2] * force_1;
    const ella_real p_tau_y = link->R_P[3] * wrench_tau_x + link->R_P[4] * wrench_tau_y + link->R_P[5] * force_1;
    const ella_real p_tau_z = link->R_P[6] * wrench_tau_x + link->R_P[7] * wrench_tau_y + link->R_P[8] * force_1;
    const ella_real p_f_x = link->R_P[0] * wrench_f_x + link->R_P[1] * wrench_f_y + link->R_P[2] * wrench_f_z;
    const ella_real p_f_y = link->R_P[3] * wrench_f_x + link->R_P[4] * wrench_f_y + link->R_P[5] * wrench_f_z;
    const ella_real p_f_z = link->R_P[6] * wrench_f_x + link->R_P[7] * wrench_f_y + link->R_P[8] * wrench_f_z;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force_eta[3] = force_eta_4;
    force_eta[4] = force_eta_5;
    force_eta[5] = force_eta_6;
    force_eta[6] = force_eta_7;
    force[0] = force_1;
    base->p[0] = p_tau_x;
    base->p[1] = p_tau_y;
    base->p[2] = p_tau_z;
    base->p[3] = p_f_x;
    base->p[4] = p_f_y;
    base->p[5] = p_f_z;

    if (wrench) {
        /* outputs */
        wrench[0] = wrench_tau_x;
        wrench[1] = wrench_tau_y;
        wrench[2] = force_1;
        wrench[3] = wrench_f_x;
        wrench[4] = wrench_f_y;
        wrench[5] = wrench_f_z;
    }
    return ELLA_OK;
}

/* kinematics, links like upper_arm: 77 operations */
ELLA_PART ella_status kinematics_upper_arm_2(const ella_link_constants *c, ella_link_store *link, ella_node *tip,
    const ella_real q[2], const ella_real eta[7])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[1]);
    const ella_real R_rel_yx = turn.sine, R_rel_yy = turn.cosine;

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t1 = theta_x * theta_x;
    const ella_real t2 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t1 + t2;
    const ella_real t3 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* c3: Stumpff function of order 3 */
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * ella_c5(x);

    /* c1: Stumpff function of order 1 */
    const ella_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t2 + t3;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t1 + t3;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    const ella_real t4 = c3 * theta_hat2_12;
    const ella_real t5 = c2 * theta_z;
    const ella_real J_l_xy = t4 - t5;
    const ella_real t6 = c2 * theta_y;
    const ella_real t7 = c3 * theta_hat2_13;
    const ella_real J_l_xz = t6 + t7;
    const ella_real J_l_yx = t5 + t4;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const ella_real t8 = c3 * theta_hat2_23;
    const ella_real t9 = c2 * theta_x;
    const ella_real J_l_yz = t8 - t9;
    const ella_real J_l_zx = t7 - t6;
    const ella_real J_l_zy = t9 + t8;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t10 = c2 * theta_hat2_12;
    const ella_real t11 = c1 * theta_z;
    const ella_real R_T_xy = t10 - t11;
    const ella_real t12 = c1 * theta_y;
    const ella_real t13 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t12 + t13;
    const ella_real R_T_yx = t11 + t10;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t14 = c2 * theta_hat2_23;
    const ella_real t15 = c1 * theta_x;
    const ella_real R_T_yz = t14 - t15;
    const ella_real R_T_zx = t13 - t12;
    const ella_real R_T_zy = t15 + t14;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* outputs */
    link->S[0] = R_rel_yx;
    link->S[1] = R_rel_yy;
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
    link->J_l[0] = J_l_xx;
    link->J_l[1] = J_l_xy;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yx;
    link->J_l[4] = J_l_yy;
    link->J_l[5] = J_l_yz;
    link->J_l[6] = J_l_zx;
    link->J_l[7] = J_l_zy;
    link->J_l[8] = J_l_zz;
    tip->R_T[0] = R_T_xx;
    tip->R_T[1] = R_T_xy;
    tip->R_T[2] = R_T_xz;
    tip->R_T[3] = R_T_yx;
    tip->R_T[4] = R_T_yy;
    tip->R_T[5] = R_T_yz;
    tip->R_T[6] = R_T_zx;
    tip->R_T[7] = R_T_zy;
    tip->R_T[8] = R_T_zz;
    return ELLA_OK;
}

/* kinematics, links like forearm: 30 operations */
ELLA_PART ella_status kinematics_forearm_2(ella_link_store *link, const ella_node *base, const ella_real q[1],
    const ella_real eta[7])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const ella_real R_P_xx = base->R_T[0] * R_rel_xx + base->R_T[1] * R_rel_yx;
    const ella_real R_P_xy = base->R_T[1] * R_rel_xx - base->R_T[0] * R_rel_yx;
    const ella_real R_P_yx = base->R_T[3] * R_rel_xx + base->R_T[4] * R_rel_yx;
    const ella_real R_P_yy = base->R_T[4] * R_rel_xx - base->R_T[3] * R_rel_yx;
    const ella_real R_P_zx = base->R_T[6] * R_rel_xx + base->R_T[7] * R_rel_yx;
    const ella_real R_P_zy = base->R_T[7] * R_rel_xx - base->R_T[6] * R_rel_yx;

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* outputs */
    link->R_P[0] = R_P_xx;
    link->R_P[1] = R_P_xy;
    link->R_P[2] = base->R_T[2];
    link->R_P[3] = R_P_yx;
    link->R_P[4] = R_P_yy;
    link->R_P[5] = base->R_T[5];
    link->R_P[6] = R_P_zx;
    link->R_P[7] = R_P_zy;
    link->R_P[8] = base->R_T[8];
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
    return ELLA_OK;
}

/* inverse inward, links like upper_arm: 174 operations */
ELLA_PART ella_status inverse_inward_upper_arm_2(const ella_link_constants *c, const ella_link_store *link,
    const ella_node *tip, const ella_real etaddot[7], const ella_real eta[7], const ella_real m_eta[7],
    ella_real force_eta[7], ella_real force[2])
{
    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_y1 = c->mu * eta[0];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_y3 = c->mu * eta[2];
    const ella_real L_z1 = eta[3] * c->mu;
    const ella_real L_z2 = eta[4] * c->mu;
    const ella_real L_z3 = eta[5] * c->mu;

    /* J: second moment */
    const ella_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1] + c->chi_3 * eta[2];
    const ella_real J_xz = c->chi_1 * eta[3] + c->chi_2 * eta[4] + c->chi_3 * eta[5];
    const ella_real J_yy = L_y1 * eta[0] + L_y2 * eta[1] + L_y3 * eta[2];
    const ella_real J_yz = L_z1 * eta[0] + L_z2 * eta[1] + L_z3 * eta[2];
    const ella_real J_zz = L_z1 * eta[3] + L_z2 * eta[4] + L_z3 * eta[5];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = c->J_0_xx + J_zz;
    const ella_real I_zz = c->J_0_xx + J_yy;

    const ella_real t1 = c->body0_mass * tip->delta[3] + tip->p[3];
    const ella_real t2 = c->body0_mass * tip->delta[4] + tip->p[4];
    const ella_real t3 = c->body0_mass * tip->delta[5] + tip->p[5];
    const ella_real t4 = L_y1 * etaddot[3] - (L_z1 * etaddot[0] + L_z2 * etaddot[1] + L_z3 * etaddot[2])
        + L_y2 * etaddot[4];
    const ella_real t5 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2]
        + (t4 + L_y3 * etaddot[5] + c->sigma_t_7 * etaddot[6]);
    const ella_real t6 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2]
        - (c->chi_1 * etaddot[3] + c->chi_2 * etaddot[4] + c->chi_3 * etaddot[5]);
    const ella_real t7 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        + (c->chi_1 * etaddot[0] + c->chi_2 * etaddot[1] + c->chi_3 * etaddot[2]);
    const ella_real wrench_tau_x = t5 + (tip->p[0] + (link->r_T[0] * t3 - link->r_T[1] * t2));
    const ella_real wrench_tau_y = t6 + (tip->p[1] + (link->r_T[1] * t1 - c->length * t3));
    const ella_real force_2 = t7 + (tip->p[2] + (c->length * t2 - link->r_T[0] * t1));
    const ella_real t8 = link->J_l[1] * tip->p[0] + link->J_l[4] * tip->p[1] + link->J_l[7] * tip->p[2];
    const ella_real t9 = link->J_l[2] * tip->p[0] + link->J_l[5] * tip->p[1] + link->J_l[8] * tip->p[2];
    const ella_real t10 = (link->J_l[0] * tip->p[0] + link->J_l[3] * tip->p[1] + link->J_l[6] * tip->p[2])
        * ELLA_REAL(1.7320508075688772);
    const ella_real force_eta_7 = c->sigma_t_7 * link->delta[0] + m_eta[6] * etaddot[6] + t10;
    const ella_real force_eta_1 = c->chi_1 * link->delta[2] - L_z1 * link->delta[0] + m_eta[0] * etaddot[0]
        + c->Psi_c_z1 * t9 + t2 * ELLA_REAL(2.0011941703010714);
    const ella_real force_eta_2 = c->chi_2 * link->delta[2] - L_z2 * link->delta[0] + m_eta[1] * etaddot[1]
        + c->Psi_c_z2 * t9 + t2 * ELLA_REAL(2.0700807911885764);
    const ella_real force_eta_3 = c->chi_3 * link->delta[2] - L_z3 * link->delta[0] + m_eta[2] * etaddot[2]
        + c->Psi_c_z3 * t9 + t2 * ELLA_REAL(3.5651069283690613);
    const ella_real force_eta_4 = L_y1 * link->delta[0] - c->chi_1 * link->delta[1] + m_eta[3] * etaddot[3]
        + c->Psi_c_y4 * t8 + t3 * ELLA_REAL(2.0011941703010714);
    const ella_real force_eta_5 = L_y2 * link->delta[0] - c->chi_2 * link->delta[1] + m_eta[4] * etaddot[4]
        + c->Psi_c_y5 * t8 + t3 * ELLA_REAL(2.0700807911885764);
    const ella_real force_eta_6 = L_y3 * link->delta[0] - c->chi_3 * link->delta[1] + m_eta[5] * etaddot[5]
        + c->Psi_c_y6 * t8 + t3 * ELLA_REAL(3.5651069283690613);
    const ella_real force_1 = link->S[0] * wrench_tau_x + link->S[1] * wrench_tau_y;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force_eta[3] = force_eta_4;
    force_eta[4] = force_eta_5;
    force_eta[5] = force_eta_6;
    force_eta[6] = force_eta_7;
    force[0] = force_1;
    force[1] = force_2;
    return ELLA_OK;
}

/* inverse inward, links like forearm: 230 operations */
ELLA_PART ella_status inverse_inward_forearm_2(const ella_link_constants *c, const ella_link_store *link,
    ella_node *base, const ella_node *tip, const ella_real etaddot[7], const ella_real eta[7], const ella_real m_eta[7],
    ella_real force_eta[7], ella_real force[1])
{
    /* S: first moment */
    const ella_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2 + eta[2] * c->sigma_y3;
    const ella_real S_z = eta[3] * c->sigma_y1 + eta[4] * c->sigma_y2 + eta[5] * c->sigma_y3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_y1 = c->mu * eta[0];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_y3 = c->mu * eta[2];
    const ella_real L_z1 = eta[3] * c->mu;
    const ella_real L_z2 = eta[4] * c->mu;
    const ella_real L_z3 = eta[5] * c->mu;

    /* J: second moment */
    const ella_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1] + c->chi_3 * eta[2];
    const ella_real J_xz = c->chi_1 * eta[3] + c->chi_2 * eta[4] + c->chi_3 * eta[5];
    const ella_real J_yy = L_y1 * eta[0] + L_y2 * eta[1] + L_y3 * eta[2];
    const ella_real J_yz = L_z1 * eta[0] + L_z2 * eta[1] + L_z3 * eta[2];
    const ella_real J_zz = L_z1 * eta[3] + L_z2 * eta[4] + L_z3 * eta[5];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = c->J_0_xx + J_zz;
    const ella_real I_zz = c->J_0_xx + J_yy;

    const ella_real t1 = c->body0_mass * tip->delta[3];
    const ella_real t2 = c->body0_mass * tip->delta[4];
    const ella_real t3 = c->body0_mass * tip->delta[5];
    const ella_real t4 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2] - S_z * link->delta[4]
        + S_y * link->delta[5];
    const ella_real t5 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2] + S_z * link->delta[3]
        - c->S_0_x * link->delta[5];
    const ella_real t6 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        - S_y * link->delta[3] + c->S_0_x * link->delta[4];
    const ella_real motion_4 = S_z * link->delta[1] - S_y * link->delta[2] + c->mu * link->delta[3];
    const ella_real t7 = L_y1 * etaddot[3] - (L_z1 * etaddot[0] + L_z2 * etaddot[1] + L_z3 * etaddot[2])
        + L_y2 * etaddot[4];
    const ella_real t8 = c->S_0_x * link->delta[2] - S_z * link->delta[0] + c->mu * link->delta[4]
        + (c->sigma_y1 * etaddot[0] + c->sigma_y2 * etaddot[1] + c->sigma_y3 * etaddot[2]);
    const ella_real t9 = S_y * link->delta[0] - c->S_0_x * link->delta[1] + c->mu * link->delta[5]
        + (c->sigma_y1 * etaddot[3] + c->sigma_y2 * etaddot[4] + c->sigma_y3 * etaddot[5]);
    const ella_real wrench_tau_x = t4 + (t7 + L_y3 * etaddot[5] + c->sigma_t_7 * etaddot[6])
        + (link->r_T[0] * t3 - link->r_T[1] * t2);
    const ella_real wrench_tau_y = t5 - (c->chi_1 * etaddot[3] + c->chi_2 * etaddot[4] + c->chi_3 * etaddot[5])
        + (link->r_T[1] * t1 - c->length * t3);
    const ella_real force_1 = t6 + (c->chi_1 * etaddot[0] + c->chi_2 * etaddot[1] + c->chi_3 * etaddot[2])
        + (c->length * t2 - link->r_T[0] * t1);
    const ella_real wrench_f_x = motion_4 + t1;
    const ella_real wrench_f_y = t8 + t2;
    const ella_real wrench_f_z = t9 + t3;
    const ella_real t10 = c->chi_1 * link->delta[2] - L_z1 * link->delta[0] + c->sigma_y1 * link->delta[4]
        + m_eta[0] * etaddot[0];
    const ella_real t11 = c->chi_2 * link->delta[2] - L_z2 * link->delta[0] + c->sigma_y2 * link->delta[4]
        + m_eta[1] * etaddot[1];
    const ella_real t12 = c->chi_3 * link->delta[2] - L_z3 * link->delta[0] + c->sigma_y3 * link->delta[4]
        + m_eta[2] * etaddot[2];
    const ella_real t13 = L_y1 * link->delta[0] - c->chi_1 * link->delta[1] + c->sigma_y1 * link->delta[5]
        + m_eta[3] * etaddot[3];
    const ella_real t14 = L_y2 * link->delta[0] - c->chi_2 * link->delta[1] + c->sigma_y2 * link->delta[5]
        + m_eta[4] * etaddot[4];
    const ella_real t15 = L_y3 * link->delta[0] - c->chi_3 * link->delta[1] + c->sigma_y3 * link->delta[5]
        + m_eta[5] * etaddot[5];
    const ella_real force_eta_7 = c->sigma_t_7 * link->delta[0] + m_eta[6] * etaddot[6];
    const ella_real force_eta_1 = t10 + t2 * ELLA_REAL(2.0011941703010714);
    const ella_real force_eta_2 = t11 + t2 * ELLA_REAL(2.0700807911885764);
    const ella_real force_eta_3 = t12 + t2 * ELLA_REAL(3.5651069283690613);
    const ella_real force_eta_4 = t13 + t3 * ELLA_REAL(2.0011941703010714);
    const ella_real force_eta_5 = t14 + t3 * ELLA_REAL(2.0700807911885764);
    const ella_real force_eta_6 = t15 + t3 * ELLA_REAL(3.5651069283690613);
    const ella_real p_tau_x = link->R_P[0] * wrench_tau_x + link->R_P[1] * wrench_tau_y + link->R_P[2] * force_1;
    const ella_real p_tau_y = link->R_P[3] * wrench_tau_x + link->R_P[4] * wrench_tau_y + link->R_P[5] * force_1;
    const ella_real p_tau_z = link->R_P[6] * wrench_tau_x + link->R_P[7] * wrench_tau_y + link->R_P[8] * force_1;
    const ella_real p_f_x = link->R_P[0] * wrench_f_x + link->R_P[1] * wrench_f_y + link->R_P[2] * wrench_f_z;
    const ella_real p_f_y = link->R_P[3] * wrench_f_x + link->R_P[4] * wrench_f_y + link->R_P[5] * wrench_f_z;
    const ella_real p_f_z = link->R_P[6] * wrench_f_x + link->R_P[7] * wrench_f_y + link->R_P[8] * wrench_f_z;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force_eta[3] = force_eta_4;
    force_eta[4] = force_eta_5;
    force_eta[5] = force_eta_6;
    force_eta[6] = force_eta_7;
    force[0] = force_1;
    base->p[0] = p_tau_x;
    base->p[1] = p_tau_y;
    base->p[2] = p_tau_z;
    base->p[3] = p_f_x;
    base->p[4] = p_f_y;
    base->p[5] = p_f_z;
    return ELLA_OK;
}

/* velocities, links like upper_arm: 156 operations */
ELLA_PART ella_status velocities_upper_arm(const ella_link_constants *c, ella_node *tip, const ella_real q[2],
    const ella_real qdot[2], const ella_real eta[7], const ella_real etadot[7])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[1]);
    const ella_real R_rel_yx = turn.sine, R_rel_yy = turn.cosine;

    /* omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_x = R_rel_yx * qdot[0];
    const ella_real omega_J_y = R_rel_yy * qdot[0];

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t1 = theta_x * theta_x;
    const ella_real t2 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t1 + t2;
    const ella_real t3 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t3;

    /* c1: Stumpff function of order 1 */
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * ella_c5(x);
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t2 + t3;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t1 + t3;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t4 = c2 * theta_hat2_12;
    const ella_real t5 = c1 * theta_z;
    const ella_real R_T_xy = t4 - t5;
    const ella_real t6 = c1 * theta_y;
    const ella_real t7 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t6 + t7;
    const ella_real R_T_yx = t5 + t4;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t8 = c2 * theta_hat2_23;
    const ella_real t9 = c1 * theta_x;
    const ella_real R_T_yz = t8 - t9;
    const ella_real R_T_zx = t7 - t6;
    const ella_real R_T_zy = t9 + t8;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_y = etadot[0] * ELLA_REAL(2.0011941703010714) + etadot[1] * ELLA_REAL(2.0700807911885764)
        + etadot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_z = etadot[3] * ELLA_REAL(2.0011941703010714) + etadot[4] * ELLA_REAL(2.0700807911885764)
        + etadot[5] * ELLA_REAL(3.5651069283690613);

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_x = etadot[6] * ELLA_REAL(1.7320508075688772);
    const ella_real thetadot_y = c->Psi_c_y4 * etadot[3] + c->Psi_c_y5 * etadot[4] + c->Psi_c_y6 * etadot[5];
    const ella_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1] + c->Psi_c_z3 * etadot[2];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t10 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real t11 = theta_x * thetadot_y - theta_y * thetadot_x;
    const ella_real t12 = theta_z * thetadot_x - theta_x * thetadot_z;
    const ella_real omega_s_x = thetadot_x + c2 * t10 + c3 * (theta_y * t11 - theta_z * t12);
    const ella_real omega_s_y = thetadot_y + c2 * t12 + c3 * (theta_z * t10 - theta_x * t11);
    const ella_real omega_s_z = thetadot_z + c2 * t11 + c3 * (theta_x * t12 - theta_y * t10);

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t13 = omega_s_x + omega_J_x;
    const ella_real t14 = omega_s_y + omega_J_y;
    const ella_real t15 = omega_s_z + qdot[1];
    const ella_real omega_T_x = R_T_xx * t13 + R_T_yx * t14 + R_T_zx * t15;
    const ella_real omega_T_y = R_T_xy * t13 + R_T_yy * t14 + R_T_zy * t15;
    const ella_real omega_T_z = R_T_xz * t13 + R_T_yz * t14 + R_T_zz * t15;

    /* v_T: velocity of the tip point (46) */
    const ella_real t16 = omega_J_y * r_T_z - qdot[1] * r_T_y;
    const ella_real t17 = udot_T_y + c->length * qdot[1] - omega_J_x * r_T_z;
    const ella_real t18 = udot_T_z + omega_J_x * r_T_y - c->length * omega_J_y;
    const ella_real v_T_x = R_T_xx * t16 + R_T_yx * t17 + R_T_zx * t18;
    const ella_real v_T_y = R_T_xy * t16 + R_T_yy * t17 + R_T_zy * t18;
    const ella_real v_T_z = R_T_xz * t16 + R_T_yz * t17 + R_T_zz * t18;

    /* outputs */
    tip->omega_T[0] = omega_T_x;
    tip->omega_T[1] = omega_T_y;
    tip->omega_T[2] = omega_T_z;
    tip->v_T[0] = v_T_x;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    return ELLA_OK;
}

/* velocities, links like forearm: 170 operations */
ELLA_PART ella_status velocities_forearm(const ella_link_constants *c, const ella_node *base, ella_node *tip,
    const ella_real q[1], const ella_real qdot[1], const ella_real eta[7], const ella_real etadot[7])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    /* omega_R: angular velocity of the parent's tip */
    const ella_real omega_R_x = R_rel_xx * base->omega_T[0] + R_rel_yx * base->omega_T[1];
    const ella_real omega_R_y = R_rel_xx * base->omega_T[1] - R_rel_yx * base->omega_T[0];

    /* omega: angular velocity of the link (45) */
    const ella_real omega_z = base->omega_T[2] + qdot[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const ella_real v_R_x = R_rel_xx * base->v_T[0] + R_rel_yx * base->v_T[1];
    const ella_real v_R_y = R_rel_xx * base->v_T[1] - R_rel_yx * base->v_T[0];

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t1 = theta_x * theta_x;
    const ella_real t2 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t1 + t2;
    const ella_real t3 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t3;

    /* c1: Stumpff function of order 1 */
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * ella_c5(x);
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t2 + t3;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t1 + t3;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t4 = c2 * theta_hat2_12;
    const ella_real t5 = c1 * theta_z;
    const ella_real R_T_xy = t4 - t5;
    const ella_real t6 = c1 * theta_y;
    const ella_real t7 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t6 + t7;
    const ella_real R_T_yx = t5 + t4;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t8 = c2 * theta_hat2_23;
    const ella_real t9 = c1 * theta_x;
    const ella_real R_T_yz = t8 - t9;
    const ella_real R_T_zx = t7 - t6;
    const ella_real R_T_zy = t9 + t8;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_y = etadot[0] * ELLA_REAL(2.0011941703010714) + etadot[1] * ELLA_REAL(2.0700807911885764)
        + etadot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_z = etadot[3] * ELLA_REAL(2.0011941703010714) + etadot[4] * ELLA_REAL(2.0700807911885764)
        + etadot[5] * ELLA_REAL(3.5651069283690613);

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_x = etadot[6] * ELLA_REAL(1.7320508075688772);
    const ella_real thetadot_y = c->Psi_c_y4 * etadot[3] + c->Psi_c_y5 * etadot[4] + c->Psi_c_y6 * etadot[5];
    const ella_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1] + c->Psi_c_z3 * etadot[2];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t10 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real t11 = theta_x * thetadot_y - theta_y * thetadot_x;
    const ella_real t12 = theta_z * thetadot_x - theta_x * thetadot_z;
    const ella_real omega_s_x = thetadot_x + c2 * t10 + c3 * (theta_y * t11 - theta_z * t12);
    const ella_real omega_s_y = thetadot_y + c2 * t12 + c3 * (theta_z * t10 - theta_x * t11);
    const ella_real omega_s_z = thetadot_z + c2 * t11 + c3 * (theta_x * t12 - theta_y * t10);

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t13 = omega_s_x + omega_R_x;
    const ella_real t14 = omega_s_y + omega_R_y;
    const ella_real t15 = omega_s_z + omega_z;
    const ella_real omega_T_x = R_T_xx * t13 + R_T_yx * t14 + R_T_zx * t15;
    const ella_real omega_T_y = R_T_xy * t13 + R_T_yy * t14 + R_T_zy * t15;
    const ella_real omega_T_z = R_T_xz * t13 + R_T_yz * t14 + R_T_zz * t15;

    /* v_T: velocity of the tip point (46) */
    const ella_real t16 = v_R_x + omega_R_y * r_T_z - omega_z * r_T_y;
    const ella_real t17 = udot_T_y + v_R_y + c->length * omega_z - omega_R_x * r_T_z;
    const ella_real t18 = udot_T_z + base->v_T[2] + omega_R_x * r_T_y - c->length * omega_R_y;
    const ella_real v_T_x = R_T_xx * t16 + R_T_yx * t17 + R_T_zx * t18;
    const ella_real v_T_y = R_T_xy * t16 + R_T_yy * t17 + R_T_zy * t18;
    const ella_real v_T_z = R_T_xz * t16 + R_T_yz * t17 + R_T_zz * t18;

    /* outputs */
    tip->omega_T[0] = omega_T_x;
    tip->omega_T[1] = omega_T_y;
    tip->omega_T[2] = omega_T_z;
    tip->v_T[0] = v_T_x;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    return ELLA_OK;
}

/* poses, links like upper_arm: 119 operations */
ELLA_PART ella_status poses_upper_arm(const ella_link_constants *c, ella_node *tip, const ella_real q[2],
    const ella_real eta[7], ella_real R[9], ella_real r[3])
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

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t1 = theta_x * theta_x;
    const ella_real t2 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t1 + t2;
    const ella_real t3 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t3;

    /* c1: Stumpff function of order 1 */
    const ella_real c1 = 1 - x * (ELLA_REAL(0.16666666666666666) - x * ella_c5(x));

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t2 + t3;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t1 + t3;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t4 = c2 * theta_hat2_12;
    const ella_real t5 = c1 * theta_z;
    const ella_real R_T_xy = t4 - t5;
    const ella_real t6 = c1 * theta_y;
    const ella_real t7 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t6 + t7;
    const ella_real R_T_yx = t5 + t4;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t8 = c2 * theta_hat2_23;
    const ella_real t9 = c1 * theta_x;
    const ella_real R_T_yz = t8 - t9;
    const ella_real R_T_zx = t7 - t6;
    const ella_real R_T_zy = t9 + t8;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* pose: rotation and position of F_i in the inertial frame (Ad) */
    const ella_real t10 = -minus_R_rel_xy;
    const ella_real t11 = -minus_R_rel_zx;

    /* pose: rotation and position of the tip section in the inertial frame (Ad) */
    const ella_real R_tip_xx = R_rel_xx * R_T_xx - minus_R_rel_xy * R_T_yx + R_rel_xz * R_T_zx;
    const ella_real R_tip_xy = R_rel_xx * R_T_xy - minus_R_rel_xy * R_T_yy + R_rel_xz * R_T_zy;
    const ella_real R_tip_xz = R_rel_xx * R_T_xz - minus_R_rel_xy * R_T_yz + R_rel_xz * R_T_zz;
    const ella_real R_tip_yx = R_rel_yx * R_T_xx + R_rel_yy * R_T_yx;
    const ella_real R_tip_yy = R_rel_yx * R_T_xy + R_rel_yy * R_T_yy;
    const ella_real R_tip_yz = R_rel_yx * R_T_xz + R_rel_yy * R_T_yz;
    const ella_real R_tip_zx = R_rel_zy * R_T_yx - minus_R_rel_zx * R_T_xx + R_rel_zz * R_T_zx;
    const ella_real R_tip_zy = R_rel_zy * R_T_yy - minus_R_rel_zx * R_T_xy + R_rel_zz * R_T_zy;
    const ella_real R_tip_zz = R_rel_zy * R_T_yz - minus_R_rel_zx * R_T_xz + R_rel_zz * R_T_zz;
    const ella_real r_tip_x = R_rel_xx * c->length - minus_R_rel_xy * r_T_y + R_rel_xz * r_T_z;
    const ella_real r_tip_y = R_rel_yx * c->length + R_rel_yy * r_T_y;
    const ella_real r_tip_z = R_rel_zy * r_T_y - minus_R_rel_zx * c->length + R_rel_zz * r_T_z;

    /* outputs */
    R[0] = R_rel_xx;
    R[1] = t10;
    R[2] = R_rel_xz;
    R[3] = R_rel_yx;
    R[4] = R_rel_yy;
    R[5] = 0;
    R[6] = t11;
    R[7] = R_rel_zy;
    R[8] = R_rel_zz;
    r[0] = 0;
    r[1] = 0;
    r[2] = 0;
    tip->R[0] = R_tip_xx;
    tip->R[1] = R_tip_xy;
    tip->R[2] = R_tip_xz;
    tip->R[3] = R_tip_yx;
    tip->R[4] = R_tip_yy;
    tip->R[5] = R_tip_yz;
    tip->R[6] = R_tip_zx;
    tip->R[7] = R_tip_zy;
    tip->R[8] = R_tip_zz;
    tip->r[0] = r_tip_x;
    tip->r[1] = r_tip_y;
    tip->r[2] = r_tip_z;
    return ELLA_OK;
}

/* poses, links like forearm: 140 operations */
ELLA_PART ella_status poses_forearm(const ella_link_constants *c, const ella_node *base, ella_node *tip,
    const ella_real q[1], const ella_real eta[7], ella_real R[9], ella_real r[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t1 = theta_x * theta_x;
    const ella_real t2 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t1 + t2;
    const ella_real t3 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t3;

    /* c1: Stumpff function of order 1 */
    const ella_real c1 = 1 - x * (ELLA_REAL(0.16666666666666666) - x * ella_c5(x));

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t2 + t3;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t1 + t3;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t4 = c2 * theta_hat2_12;
    const ella_real t5 = c1 * theta_z;
    const ella_real R_T_xy = t4 - t5;
    const ella_real t6 = c1 * theta_y;
    const ella_real t7 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t6 + t7;
    const ella_real R_T_yx = t5 + t4;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t8 = c2 * theta_hat2_23;
    const ella_real t9 = c1 * theta_x;
    const ella_real R_T_yz = t8 - t9;
    const ella_real R_T_zx = t7 - t6;
    const ella_real R_T_zy = t9 + t8;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* pose: rotation and position of F_i in the inertial frame (Ad) */
    const ella_real R_xx = base->R[0] * R_rel_xx + base->R[1] * R_rel_yx;
    const ella_real R_xy = base->R[1] * R_rel_xx - base->R[0] * R_rel_yx;
    const ella_real R_yx = base->R[3] * R_rel_xx + base->R[4] * R_rel_yx;
    const ella_real R_yy = base->R[4] * R_rel_xx - base->R[3] * R_rel_yx;
    const ella_real R_zx = base->R[6] * R_rel_xx + base->R[7] * R_rel_yx;
    const ella_real R_zy = base->R[7] * R_rel_xx - base->R[6] * R_rel_yx;

    /* pose: rotation and position of the tip section in the inertial frame (Ad) */
    const ella_real R_tip_xx = R_xx * R_T_xx + R_xy * R_T_yx + base->R[2] * R_T_zx;
    const ella_real R_tip_xy = R_xx * R_T_xy + R_xy * R_T_yy + base->R[2] * R_T_zy;
    const ella_real R_tip_xz = R_xx * R_T_xz + R_xy * R_T_yz + base->R[2] * R_T_zz;
    const ella_real R_tip_yx = R_yx * R_T_xx + R_yy * R_T_yx + base->R[5] * R_T_zx;
    const ella_real R_tip_yy = R_yx * R_T_xy + R_yy * R_T_yy + base->R[5] * R_T_zy;
    const ella_real R_tip_yz = R_yx * R_T_xz + R_yy * R_T_yz + base->R[5] * R_T_zz;
    const ella_real R_tip_zx = R_zx * R_T_xx + R_zy * R_T_yx + base->R[8] * R_T_zx;
    const ella_real R_tip_zy = R_zx * R_T_xy + R_zy * R_T_yy + base->R[8] * R_T_zy;
    const ella_real R_tip_zz = R_zx * R_T_xz + R_zy * R_T_yz + base->R[8] * R_T_zz;
    const ella_real r_tip_x = base->r[0] + (R_xx * c->length + R_xy * r_T_y + base->R[2] * r_T_z);
    const ella_real r_tip_y = base->r[1] + (R_yx * c->length + R_yy * r_T_y + base->R[5] * r_T_z);
    const ella_real r_tip_z = base->r[2] + (R_zx * c->length + R_zy * r_T_y + base->R[8] * r_T_z);

    /* outputs */
    R[0] = R_xx;
    R[1] = R_xy;
    R[2] = base->R[2];
    R[3] = R_yx;
    R[4] = R_yy;
    R[5] = base->R[5];
    R[6] = R_zx;
    R[7] = R_zy;
    R[8] = base->R[8];
    r[0] = base->r[0];
    r[1] = base->r[1];
    r[2] = base->r[2];
    tip->R[0] = R_tip_xx;
    tip->R[1] = R_tip_xy;
    tip->R[2] = R_tip_xz;
    tip->R[3] = R_tip_yx;
    tip->R[4] = R_tip_yy;
    tip->R[5] = R_tip_yz;
    tip->R[6] = R_tip_zx;
    tip->R[7] = R_tip_zy;
    tip->R[8] = R_tip_zz;
    tip->r[0] = r_tip_x;
    tip->r[1] = r_tip_y;
    tip->r[2] = r_tip_z;
    return ELLA_OK;
}

/* tip twist, links like upper_arm: 30 operations */
ELLA_PART ella_status tip_twist_upper_arm(const ella_node *tip, ella_real tip_twist[6])
{
    const ella_real tip_twist_omega_x = tip->R[0] * tip->omega_T[0] + tip->R[1] * tip->omega_T[1]
        + tip->R[2] * tip->omega_T[2];
    const ella_real tip_twist_omega_y = tip->R[3] * tip->omega_T[0] + tip->R[4] * tip->omega_T[1]
        + tip->R[5] * tip->omega_T[2];
    const ella_real tip_twist_omega_z = tip->R[6] * tip->omega_T[0] + tip->R[7] * tip->omega_T[1]
        + tip->R[8] * tip->omega_T[2];
    const ella_real tip_twist_v_x = tip->R[0] * tip->v_T[0] + tip->R[1] * tip->v_T[1] + tip->R[2] * tip->v_T[2];
    const ella_real tip_twist_v_y = tip->R[3] * tip->v_T[0] + tip->R[4] * tip->v_T[1] + tip->R[5] * tip->v_T[2];
    const ella_real tip_twist_v_z = tip->R[6] * tip->v_T[0] + tip->R[7] * tip->v_T[1] + tip->R[8] * tip->v_T[2];

    /* outputs */
    tip_twist[0] = tip_twist_omega_x;
    tip_twist[1] = tip_twist_omega_y;
    tip_twist[2] = tip_twist_omega_z;
    tip_twist[3] = tip_twist_v_x;
    tip_twist[4] = tip_twist_v_y;
    tip_twist[5] = tip_twist_v_z;
    return ELLA_OK;
}

/* measure, links like upper_arm: 43 operations */
ELLA_PART ella_status measure_upper_arm(const ella_link_constants *restrict c, const ella_real eta[restrict 7],
    const ella_real motion[restrict 4], const ella_real wrench[restrict 6], ella_real measures[restrict 4])
{
    /* deflection_T: transverse displacement of the tip, components y and z in F_i */
    const ella_real deflection_T_1 = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real deflection_T_2 = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* deflection_2: its square */
    const ella_real deflection_2 = deflection_T_1 * deflection_T_1 + deflection_T_2 * deflection_T_2;

    /* deflection: transverse displacement of the tip over length */
    const ella_real deflection = ella_sqrt(deflection_2) / c->length;
    measures[0] = deflection;

    /* slope_T: slope of the tip section, components y and z in F_i */
    const ella_real minus_slope_T_1 = eta[4] * ELLA_REAL(9.829048135266044) / c->length
        + eta[3] * ELLA_REAL(2.754638950054297) / c->length + eta[5] * ELLA_REAL(51.65076743872705) / c->length;
    const ella_real slope_T_2 = eta[1] * ELLA_REAL(9.829048135266044) / c->length
        + eta[0] * ELLA_REAL(2.754638950054297) / c->length + eta[2] * ELLA_REAL(51.65076743872705) / c->length;

    /* slope_2: its square */
    const ella_real slope_2 = minus_slope_T_1 * minus_slope_T_1 + slope_T_2 * slope_T_2;

    /* slope: slope of the tip section */
    const ella_real slope = ella_sqrt(slope_2);
    measures[1] = slope;

    /* Omega_2: squared turn of the centreline */
    const ella_real Omega_2 = motion[0] * motion[0] + motion[1] * motion[1];

    /* axial_load: axial load over buckling load, compression > 0 */
    const ella_real axial_load = motion[2] * c->per_acceleration + c->per_force * (wrench[3] - motion[3]);
    measures[2] = axial_load;

    /* rotation: Omega^2 rhoA l^4 / EI */
    const ella_real rotation = Omega_2 * c->per_turn;
    measures[3] = rotation;
    return ELLA_OK;
}

/* joint rows, links like upper_arm: 657 operations */
ELLA_PART ella_status joint_rows_upper_arm(const ella_link_constants *c, ella_link_store *link, ella_node *tip,
    const ella_real twist[6], const ella_real q[2], const ella_real quaternion[4], const ella_real gravity[3],
    const ella_real eta[7], const ella_real etadot[7], const ella_real tau[2], ella_real joint_H[6],
    ella_real joint_W[6], const int *place, ella_real *M)
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
    const ella_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2 + eta[2] * c->sigma_y3;
    const ella_real S_z = eta[3] * c->sigma_y1 + eta[4] * c->sigma_y2 + eta[5] * c->sigma_y3;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2 + etadot[2] * c->sigma_y3;
    const ella_real Sdot_z = etadot[3] * c->sigma_y1 + etadot[4] * c->sigma_y2 + etadot[5] * c->sigma_y3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_y1 = c->mu * eta[0];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_y3 = c->mu * eta[2];
    const ella_real L_z1 = eta[3] * c->mu;
    const ella_real L_z2 = eta[4] * c->mu;
    const ella_real L_z3 = eta[5] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_y1 = c->mu * etadot[0];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_y3 = c->mu * etadot[2];
    const ella_real Ldot_z1 = etadot[3] * c->mu;
    const ella_real Ldot_z2 = etadot[4] * c->mu;
    const ella_real Ldot_z3 = etadot[5] * c->mu;

    /* J: second moment */
    const ella_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1] + c->chi_3 * eta[2];
    const ella_real J_xz = c->chi_1 * eta[3] + c->chi_2 * eta[4] + c->chi_3 * eta[5];
    const ella_real J_yy = L_y1 * eta[0] + L_y2 * eta[1] + L_y3 * eta[2];
    const ella_real J_yz = L_z1 * eta[0] + L_z2 * eta[1] + L_z3 * eta[2];
    const ella_real J_zz = L_z1 * eta[3] + L_z2 * eta[4] + L_z3 * eta[5];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = c->J_0_xx + J_zz;
    const ella_real I_zz = c->J_0_xx + J_yy;

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
    const ella_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1] + c->chi_3 * etadot[2];
    const ella_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1] + L_y3 * etadot[2];
    const ella_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1] + L_z3 * etadot[2];
    const ella_real B_zx = c->chi_1 * etadot[3] + c->chi_2 * etadot[4] + c->chi_3 * etadot[5];
    const ella_real B_zy = L_y1 * etadot[3] + L_y2 * etadot[4] + L_y3 * etadot[5];
    const ella_real B_zz = L_z1 * etadot[3] + L_z2 * etadot[4] + L_z3 * etadot[5];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const ella_real h_c_tau_x = B_yy * twist[0] + B_zz * twist[0];
    const ella_real h_c_tau_y = B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const ella_real h_c_tau_z = B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const ella_real h_c_f_x = Sdot_z * twist[1] - Sdot_y * twist[2];
    const ella_real minus_h_c_f_y = Sdot_z * twist[0];
    const ella_real h_c_f_z = Sdot_y * twist[0];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const ella_real h_MD_tau_y = h_c_tau_y + etadot[6] * twist[2] * c->sigma_t_7;
    const ella_real h_MD_tau_z = h_c_tau_z - etadot[6] * twist[1] * c->sigma_t_7;

    /* H_star: gyroscopic wrench and weight, with half of the Coriolis wrench (29) */
    const ella_real t24 = h_c_tau_x + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const ella_real H_star_tau_x = t24 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const ella_real t25 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const ella_real t26 = c->I_s * twist[0];
    const ella_real H_star_tau_y = t25 + t26 * twist[2] - c->J_0_xx * Omega_xz - J_xy * Omega_yz - c->S_0_x * a_0_z;
    const ella_real t27 = h_c_tau_z + c->J_0_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * a_0_y;
    const ella_real H_star_tau_z = t27 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t26 * twist[1];
    const ella_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z + a_0_x * c->mu;
    const ella_real H_star_f_y = Omega_xy * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + a_0_y * c->mu;
    const ella_real H_star_f_z = h_c_f_z + Omega_xz * c->S_0_x + Omega_yz * S_y - minus_Omega_zz * S_z + a_0_z * c->mu;

    /* h_V: bias of the twist rows */
    const ella_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const ella_real h_V_tau_y = H_star_tau_y + h_MD_tau_y;
    const ella_real h_V_tau_z = H_star_tau_z + h_MD_tau_z;
    const ella_real h_V_f_x = H_star_f_x + h_c_f_x;
    const ella_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const ella_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const ella_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_xy * c->chi_1 + a_0_y * c->sigma_y1
        - Ldot_z1 * 2 * twist[0];
    const ella_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_xy * c->chi_2 + a_0_y * c->sigma_y2
        - Ldot_z2 * 2 * twist[0];
    const ella_real h_eta_3 = L_z3 * Omega_yz - L_y3 * minus_Omega_yy + Omega_xy * c->chi_3 + a_0_y * c->sigma_y3
        - Ldot_z3 * 2 * twist[0];
    const ella_real h_eta_4 = L_y1 * Omega_yz - L_z1 * minus_Omega_zz + Omega_xz * c->chi_1 + a_0_z * c->sigma_y1
        + Ldot_y1 * 2 * twist[0];
    const ella_real h_eta_5 = L_y2 * Omega_yz - L_z2 * minus_Omega_zz + Omega_xz * c->chi_2 + a_0_z * c->sigma_y2
        + Ldot_y2 * 2 * twist[0];
    const ella_real h_eta_6 = L_y3 * Omega_yz - L_z3 * minus_Omega_zz + Omega_xz * c->chi_3 + a_0_z * c->sigma_y3
        + Ldot_y3 * 2 * twist[0];

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t28 = theta_x * theta_x;
    const ella_real t29 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t28 + t29;
    const ella_real t30 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t30;

    /* c1: Stumpff function of order 1 */
    const ella_real t31 = ella_c5(x);
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * t31;
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real t32 = ella_c4(x);
    const ella_real c2 = ELLA_REAL(0.5) - x * t32;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t29 + t30;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t28 + t30;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    const ella_real t33 = c3 * theta_hat2_12;
    const ella_real t34 = c2 * theta_z;
    const ella_real J_l_xy = t33 - t34;
    const ella_real t35 = c2 * theta_y;
    const ella_real t36 = c3 * theta_hat2_13;
    const ella_real J_l_xz = t35 + t36;
    const ella_real J_l_yx = t34 + t33;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const ella_real t37 = c3 * theta_hat2_23;
    const ella_real t38 = c2 * theta_x;
    const ella_real J_l_yz = t37 - t38;
    const ella_real J_l_zx = t36 - t35;
    const ella_real J_l_zy = t38 + t37;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t39 = c2 * theta_hat2_12;
    const ella_real t40 = c1 * theta_z;
    const ella_real R_T_xy = t39 - t40;
    const ella_real t41 = c1 * theta_y;
    const ella_real t42 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t41 + t42;
    const ella_real R_T_yx = t40 + t39;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t43 = c2 * theta_hat2_23;
    const ella_real t44 = c1 * theta_x;
    const ella_real R_T_yz = t43 - t44;
    const ella_real R_T_zx = t42 - t41;
    const ella_real R_T_zy = t44 + t43;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_y = etadot[0] * ELLA_REAL(2.0011941703010714) + etadot[1] * ELLA_REAL(2.0700807911885764)
        + etadot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_z = etadot[3] * ELLA_REAL(2.0011941703010714) + etadot[4] * ELLA_REAL(2.0700807911885764)
        + etadot[5] * ELLA_REAL(3.5651069283690613);

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_x = etadot[6] * ELLA_REAL(1.7320508075688772);
    const ella_real thetadot_y = c->Psi_c_y4 * etadot[3] + c->Psi_c_y5 * etadot[4] + c->Psi_c_y6 * etadot[5];
    const ella_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1] + c->Psi_c_z3 * etadot[2];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t45 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real t46 = theta_x * thetadot_y - theta_y * thetadot_x;
    const ella_real t47 = theta_z * thetadot_x - theta_x * thetadot_z;
    const ella_real t48 = theta_y * t46 - theta_z * t47;
    const ella_real omega_s_x = thetadot_x + c2 * t45 + c3 * t48;
    const ella_real t49 = theta_z * t45 - theta_x * t46;
    const ella_real omega_s_y = thetadot_y + c2 * t47 + c3 * t49;
    const ella_real t50 = theta_x * t47 - theta_y * t45;
    const ella_real omega_s_z = thetadot_z + c2 * t46 + c3 * t50;

    /* xdot: rate of the squared angle */
    const ella_real xdot = eta[6] * ELLA_REAL(3.4641016151377544) * thetadot_x + theta_y * 2 * thetadot_y
        + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const ella_real c2dot = xdot * (t32 - c3 * ELLA_REAL(0.5));

    /* c3dot: rate of c3 */
    const ella_real c3dot = xdot * (t31 * ELLA_REAL(1.5) - t32 * ELLA_REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_x = c2dot * t45 + c3 * (thetadot_y * t46 - thetadot_z * t47) + c3dot * t48;
    const ella_real alpha_s_y = c2dot * t47 + c3 * (thetadot_z * t45 - thetadot_x * t46) + c3dot * t49;
    const ella_real alpha_s_z = c2dot * t46 + c3 * (thetadot_x * t47 - thetadot_y * t45) + c3dot * t50;

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t51 = omega_s_x + twist[0];
    const ella_real t52 = omega_s_y + twist[1];
    const ella_real t53 = omega_s_z + twist[2];
    const ella_real omega_T_x = R_T_xx * t51 + R_T_yx * t52 + R_T_zx * t53;
    const ella_real omega_T_y = R_T_xy * t51 + R_T_yy * t52 + R_T_zy * t53;
    const ella_real omega_T_z = R_T_xz * t51 + R_T_yz * t52 + R_T_zz * t53;

    /* v_T: velocity of the tip point (46) */
    const ella_real t54 = twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const ella_real t55 = udot_T_y + twist[4] + c->length * twist[2] - twist[0] * r_T_z;
    const ella_real t56 = udot_T_z + twist[5] + twist[0] * r_T_y - c->length * twist[1];
    const ella_real v_T_x = R_T_xx * t54 + R_T_yx * t55 + R_T_zx * t56;
    const ella_real v_T_y = R_T_xy * t54 + R_T_yy * t55 + R_T_zy * t56;
    const ella_real v_T_z = R_T_xz * t54 + R_T_yz * t55 + R_T_zz * t56;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const ella_real t57 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const ella_real t58 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const ella_real t59 = alpha_s_z + omega_s_y * twist[0] - omega_s_x * twist[1];
    const ella_real b_omega_x = R_T_xx * t57 + R_T_yx * t58 + R_T_zx * t59;
    const ella_real b_omega_y = R_T_xy * t57 + R_T_yy * t58 + R_T_zy * t59;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const ella_real t60 = omega_s_z * t55 + twist[1] * udot_T_z - omega_s_y * t56 - twist[2] * udot_T_y;
    const ella_real t61 = omega_s_x * t56 - omega_s_z * t54 - twist[0] * udot_T_z;
    const ella_real t62 = omega_s_y * t54 + twist[0] * udot_T_y - omega_s_x * t55;
    const ella_real b_v_x = R_T_xx * t60 + R_T_yx * t61 + R_T_zx * t62;
    const ella_real b_v_y = R_T_xy * t60 + R_T_yy * t61 + R_T_zy * t62;
    const ella_real b_v_z = R_T_xz * t60 + R_T_yz * t61 + R_T_zz * t62;

    const ella_real t63 = R_T_xx * t18 + R_T_yx * t19 + R_T_zx * t20;
    const ella_real t64 = R_T_xy * t18 + R_T_yy * t19 + R_T_zy * t20;
    const ella_real t65 = R_T_xz * t18 + R_T_yz * t19 + R_T_zz * t20;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const ella_real a_T_x = omega_T_y * v_T_z - t63 - omega_T_z * v_T_y;
    const ella_real a_T_y = omega_T_z * v_T_x - t64 - omega_T_x * v_T_z;
    const ella_real a_T_z = omega_T_x * v_T_y - t65 - omega_T_y * v_T_x;

    /* h_T_F: bias force of the tip bodies, weight included */
    const ella_real h_T_F_x = a_T_x * c->body0_mass;
    const ella_real h_T_F_y = a_T_y * c->body0_mass;
    const ella_real h_T_F_z = a_T_z * c->body0_mass;

    /* N: projector onto the joint's motion subspace */
    const ella_real N_xx = t3 * R_rel_yx;
    const ella_real N_xy = t4 * R_rel_yx;
    const ella_real N_yx = t3 * R_rel_yy;
    const ella_real N_yy = t4 * R_rel_yy;

    /* P_c: P with the rotor inertias about the axes (43) */
    const ella_real P_c_11 = 1 - N_xx;
    const ella_real P_c_22 = 1 - N_yy;

    /* joint_H: bias of the joint's rows, springs and dampers included (61) */
    const ella_real joint_H_1 = -(N_xy * minus_beta_omega_y + P_c_11 * beta_omega_x);
    const ella_real joint_H_2 = N_yx * beta_omega_x + P_c_22 * minus_beta_omega_y;

    /* joint_W: the motors' torques in the joint's rows (62) */
    const ella_real joint_W_1 = t3 * tau[0];
    const ella_real joint_W_2 = t4 * tau[0];

    const ella_real t66 = -N_xy;
    const ella_real t67 = -N_yx;

    /* outputs */
    link->M_V[0] = I_xx;
    link->M_V[1] = J_xy;
    link->M_V[2] = J_xz;
    link->M_V[3] = S_z;
    link->M_V[4] = S_y;
    link->M_V[5] = I_yy;
    link->M_V[6] = J_yz;
    link->M_V[7] = I_zz;
    link->M_D[0] = L_z1;
    link->M_D[1] = L_z2;
    link->M_D[2] = L_z3;
    link->M_D[3] = L_y1;
    link->M_D[4] = L_y2;
    link->M_D[5] = L_y3;
    link->h_V[0] = h_V_tau_x;
    link->h_V[1] = h_V_tau_y;
    link->h_V[2] = h_V_tau_z;
    link->h_V[3] = h_V_f_x;
    link->h_V[4] = h_V_f_y;
    link->h_V[5] = h_V_f_z;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
    link->h_eta[2] = h_eta_3;
    link->h_eta[3] = h_eta_4;
    link->h_eta[4] = h_eta_5;
    link->h_eta[5] = h_eta_6;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yx;
    link->R_T[4] = R_T_yy;
    link->R_T[5] = R_T_yz;
    link->R_T[6] = R_T_zx;
    link->R_T[7] = R_T_zy;
    link->R_T[8] = R_T_zz;
    link->J_l[0] = J_l_xx;
    link->J_l[1] = J_l_xy;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yx;
    link->J_l[4] = J_l_yy;
    link->J_l[5] = J_l_yz;
    link->J_l[6] = J_l_zx;
    link->J_l[7] = J_l_zy;
    link->J_l[8] = J_l_zz;
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
    link->b_T[3] = b_v_x;
    link->b_T[4] = b_v_y;
    link->b_T[5] = b_v_z;
    tip->omega_T[0] = omega_T_x;
    tip->omega_T[1] = omega_T_y;
    tip->omega_T[2] = omega_T_z;
    tip->v_T[0] = v_T_x;
    tip->v_T[1] = v_T_y;
    link->h_T[0] = h_T_F_x;
    link->h_T[1] = h_T_F_y;
    link->h_T[2] = h_T_F_z;
    M[place[0]] = N_xx;
    M[place[1]] = N_xy;
    M[place[2]] = N_yx;
    M[place[3]] = N_yy;
    M[place[4]] = 1;
    M[place[5]] = P_c_11;
    M[place[6]] = t66;
    M[place[7]] = t67;
    M[place[8]] = P_c_22;
    M[place[9]] = 1;
    M[place[10]] = 1;
    M[place[11]] = 1;
    joint_H[0] = joint_H_1;
    joint_H[1] = joint_H_2;
    joint_H[2] = 0;
    joint_H[3] = 0;
    joint_H[4] = 0;
    joint_H[5] = 0;
    joint_W[0] = joint_W_1;
    joint_W[1] = joint_W_2;
    joint_W[2] = tau[1];
    joint_W[3] = 0;
    joint_W[4] = 0;
    joint_W[5] = 0;
    tip->b[0] = b_omega_x;
    tip->b[1] = b_omega_y;
    tip->b[3] = b_v_x;
    tip->b[4] = b_v_y;
    tip->b[5] = b_v_z;
    return ELLA_OK;
}

/* joint rows, links like forearm: 602 operations */
ELLA_PART ella_status joint_rows_forearm(const ella_link_constants *c, ella_link_store *link, ella_node *base,
    const ella_real twist[6], const ella_real q[1], const ella_real quaternion[4], const ella_real gravity[3],
    const ella_real eta[7], const ella_real etadot[7], const ella_real tau[1], ella_real joint_H[6],
    ella_real joint_W[6], const int *place, ella_real *M)
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(q[0]);
    const ella_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;
    const ella_real t1 = -R_rel_yx;

    const ella_real omega_R_x = R_rel_xx * base->omega_T[0] + R_rel_yx * base->omega_T[1];
    const ella_real omega_R_y = R_rel_xx * base->omega_T[1] - R_rel_yx * base->omega_T[0];
    const ella_real t2 = twist[2] - base->omega_T[2];

    /* v_R: velocity of the joint point, fixed to the parent */
    const ella_real v_R_x = R_rel_xx * base->v_T[0] + R_rel_yx * base->v_T[1];
    const ella_real v_R_y = R_rel_xx * base->v_T[1] - R_rel_yx * base->v_T[0];

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
    const ella_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2 + eta[2] * c->sigma_y3;
    const ella_real S_z = eta[3] * c->sigma_y1 + eta[4] * c->sigma_y2 + eta[5] * c->sigma_y3;

    /* Sdot: rate of the first moment */
    const ella_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2 + etadot[2] * c->sigma_y3;
    const ella_real Sdot_z = etadot[3] * c->sigma_y1 + etadot[4] * c->sigma_y2 + etadot[5] * c->sigma_y3;

    /* L: first moment weighted by each mode shape (85) */
    const ella_real L_y1 = c->mu * eta[0];
    const ella_real L_y2 = c->mu * eta[1];
    const ella_real L_y3 = c->mu * eta[2];
    const ella_real L_z1 = eta[3] * c->mu;
    const ella_real L_z2 = eta[4] * c->mu;
    const ella_real L_z3 = eta[5] * c->mu;

    /* Ldot: rate of L */
    const ella_real Ldot_y1 = c->mu * etadot[0];
    const ella_real Ldot_y2 = c->mu * etadot[1];
    const ella_real Ldot_y3 = c->mu * etadot[2];
    const ella_real Ldot_z1 = etadot[3] * c->mu;
    const ella_real Ldot_z2 = etadot[4] * c->mu;
    const ella_real Ldot_z3 = etadot[5] * c->mu;

    /* J: second moment */
    const ella_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1] + c->chi_3 * eta[2];
    const ella_real J_xz = c->chi_1 * eta[3] + c->chi_2 * eta[4] + c->chi_3 * eta[5];
    const ella_real J_yy = L_y1 * eta[0] + L_y2 * eta[1] + L_y3 * eta[2];
    const ella_real J_yz = L_z1 * eta[0] + L_z2 * eta[1] + L_z3 * eta[2];
    const ella_real J_zz = L_z1 * eta[3] + L_z2 * eta[4] + L_z3 * eta[5];

    /* I: inertia about the origin, deformed */
    const ella_real I_xx = c->I_s + J_yy + J_zz;
    const ella_real I_yy = c->J_0_xx + J_zz;
    const ella_real I_zz = c->J_0_xx + J_yy;

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
    const ella_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1] + c->chi_3 * etadot[2];
    const ella_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1] + L_y3 * etadot[2];
    const ella_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1] + L_z3 * etadot[2];
    const ella_real B_zx = c->chi_1 * etadot[3] + c->chi_2 * etadot[4] + c->chi_3 * etadot[5];
    const ella_real B_zy = L_y1 * etadot[3] + L_y2 * etadot[4] + L_y3 * etadot[5];
    const ella_real B_zz = L_z1 * etadot[3] + L_z2 * etadot[4] + L_z3 * etadot[5];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const ella_real h_c_tau_x = B_yy * twist[0] + B_zz * twist[0];
    const ella_real h_c_tau_y = B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const ella_real h_c_tau_z = B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const ella_real h_c_f_x = Sdot_z * twist[1] - Sdot_y * twist[2];
    const ella_real minus_h_c_f_y = Sdot_z * twist[0];
    const ella_real h_c_f_z = Sdot_y * twist[0];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const ella_real h_MD_tau_y = h_c_tau_y + etadot[6] * twist[2] * c->sigma_t_7;
    const ella_real h_MD_tau_z = h_c_tau_z - etadot[6] * twist[1] * c->sigma_t_7;

    /* H_star: gyroscopic wrench and weight, with half of the Coriolis wrench (29) */
    const ella_real t20 = h_c_tau_x + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const ella_real H_star_tau_x = t20 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const ella_real t21 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const ella_real t22 = c->I_s * twist[0];
    const ella_real H_star_tau_y = t21 + t22 * twist[2] - c->J_0_xx * Omega_xz - J_xy * Omega_yz - c->S_0_x * a_0_z;
    const ella_real t23 = h_c_tau_z + c->J_0_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * a_0_y;
    const ella_real H_star_tau_z = t23 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t22 * twist[1];
    const ella_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z + a_0_x * c->mu;
    const ella_real H_star_f_y = Omega_xy * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + a_0_y * c->mu;
    const ella_real H_star_f_z = h_c_f_z + Omega_xz * c->S_0_x + Omega_yz * S_y - minus_Omega_zz * S_z + a_0_z * c->mu;

    /* h_V: bias of the twist rows */
    const ella_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const ella_real h_V_tau_y = H_star_tau_y + h_MD_tau_y;
    const ella_real h_V_tau_z = H_star_tau_z + h_MD_tau_z;
    const ella_real h_V_f_x = H_star_f_x + h_c_f_x;
    const ella_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const ella_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const ella_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_xy * c->chi_1 + a_0_y * c->sigma_y1
        - Ldot_z1 * 2 * twist[0];
    const ella_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_xy * c->chi_2 + a_0_y * c->sigma_y2
        - Ldot_z2 * 2 * twist[0];
    const ella_real h_eta_3 = L_z3 * Omega_yz - L_y3 * minus_Omega_yy + Omega_xy * c->chi_3 + a_0_y * c->sigma_y3
        - Ldot_z3 * 2 * twist[0];
    const ella_real h_eta_4 = L_y1 * Omega_yz - L_z1 * minus_Omega_zz + Omega_xz * c->chi_1 + a_0_z * c->sigma_y1
        + Ldot_y1 * 2 * twist[0];
    const ella_real h_eta_5 = L_y2 * Omega_yz - L_z2 * minus_Omega_zz + Omega_xz * c->chi_2 + a_0_z * c->sigma_y2
        + Ldot_y2 * 2 * twist[0];
    const ella_real h_eta_6 = L_y3 * Omega_yz - L_z3 * minus_Omega_zz + Omega_xz * c->chi_3 + a_0_z * c->sigma_y3
        + Ldot_y3 * 2 * twist[0];

    /* r_T: tip point (11) */
    const ella_real r_T_y = eta[0] * ELLA_REAL(2.0011941703010714) + eta[1] * ELLA_REAL(2.0700807911885764)
        + eta[2] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_z = eta[3] * ELLA_REAL(2.0011941703010714) + eta[4] * ELLA_REAL(2.0700807911885764)
        + eta[5] * ELLA_REAL(3.5651069283690613);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_x = eta[6] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_y = c->Psi_c_y4 * eta[3] + c->Psi_c_y5 * eta[4] + c->Psi_c_y6 * eta[5];
    const ella_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1] + c->Psi_c_z3 * eta[2];

    /* x: squared angle of the tip section */
    const ella_real t24 = theta_x * theta_x;
    const ella_real t25 = theta_y * theta_y;
    const ella_real minus_theta_hat2_33 = t24 + t25;
    const ella_real t26 = theta_z * theta_z;
    const ella_real x = minus_theta_hat2_33 + t26;

    /* c1: Stumpff function of order 1 */
    const ella_real c3 = ELLA_REAL(0.16666666666666666) - x * ella_c5(x);
    const ella_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const ella_real c2 = ELLA_REAL(0.5) - x * ella_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_11 = t25 + t26;
    const ella_real theta_hat2_12 = theta_x * theta_y;
    const ella_real theta_hat2_13 = theta_x * theta_z;
    const ella_real minus_theta_hat2_22 = t24 + t26;
    const ella_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const ella_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    const ella_real t27 = c3 * theta_hat2_12;
    const ella_real t28 = c2 * theta_z;
    const ella_real J_l_xy = t27 - t28;
    const ella_real t29 = c2 * theta_y;
    const ella_real t30 = c3 * theta_hat2_13;
    const ella_real J_l_xz = t29 + t30;
    const ella_real J_l_yx = t28 + t27;
    const ella_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const ella_real t31 = c3 * theta_hat2_23;
    const ella_real t32 = c2 * theta_x;
    const ella_real J_l_yz = t31 - t32;
    const ella_real J_l_zx = t30 - t29;
    const ella_real J_l_zy = t32 + t31;
    const ella_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const ella_real t33 = c2 * theta_hat2_12;
    const ella_real t34 = c1 * theta_z;
    const ella_real R_T_xy = t33 - t34;
    const ella_real t35 = c1 * theta_y;
    const ella_real t36 = c2 * theta_hat2_13;
    const ella_real R_T_xz = t35 + t36;
    const ella_real R_T_yx = t34 + t33;
    const ella_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const ella_real t37 = c2 * theta_hat2_23;
    const ella_real t38 = c1 * theta_x;
    const ella_real R_T_yz = t37 - t38;
    const ella_real R_T_zx = t36 - t35;
    const ella_real R_T_zy = t38 + t37;
    const ella_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_y = etadot[0] * ELLA_REAL(2.0011941703010714) + etadot[1] * ELLA_REAL(2.0700807911885764)
        + etadot[2] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_z = etadot[3] * ELLA_REAL(2.0011941703010714) + etadot[4] * ELLA_REAL(2.0700807911885764)
        + etadot[5] * ELLA_REAL(3.5651069283690613);

    /* thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_x = etadot[6] * ELLA_REAL(1.7320508075688772);
    const ella_real thetadot_y = c->Psi_c_y4 * etadot[3] + c->Psi_c_y5 * etadot[4] + c->Psi_c_y6 * etadot[5];
    const ella_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1] + c->Psi_c_z3 * etadot[2];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t39 = theta_y * thetadot_z - theta_z * thetadot_y;
    const ella_real t40 = theta_x * thetadot_y - theta_y * thetadot_x;
    const ella_real t41 = theta_z * thetadot_x - theta_x * thetadot_z;
    const ella_real omega_s_x = thetadot_x + c2 * t39 + c3 * (theta_y * t40 - theta_z * t41);
    const ella_real omega_s_y = thetadot_y + c2 * t41 + c3 * (theta_z * t39 - theta_x * t40);
    const ella_real omega_s_z = thetadot_z + c2 * t40 + c3 * (theta_x * t41 - theta_y * t39);

    /* omega_T: angular velocity of the tip section (46) */
    const ella_real t42 = omega_s_x + twist[0];
    const ella_real t43 = omega_s_y + twist[1];
    const ella_real t44 = omega_s_z + twist[2];
    const ella_real omega_T_x = R_T_xx * t42 + R_T_yx * t43 + R_T_zx * t44;
    const ella_real omega_T_y = R_T_xy * t42 + R_T_yy * t43 + R_T_zy * t44;
    const ella_real omega_T_z = R_T_xz * t42 + R_T_yz * t43 + R_T_zz * t44;

    /* v_T: velocity of the tip point (46) */
    const ella_real t45 = twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const ella_real t46 = udot_T_y + twist[4] + c->length * twist[2] - twist[0] * r_T_z;
    const ella_real t47 = udot_T_z + twist[5] + twist[0] * r_T_y - c->length * twist[1];
    const ella_real v_T_x = R_T_xx * t45 + R_T_yx * t46 + R_T_zx * t47;
    const ella_real v_T_y = R_T_xy * t45 + R_T_yy * t46 + R_T_zy * t47;
    const ella_real v_T_z = R_T_xz * t45 + R_T_yz * t46 + R_T_zz * t47;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const ella_real t48 = omega_s_z * t46 + twist[1] * udot_T_z - omega_s_y * t47 - twist[2] * udot_T_y;
    const ella_real t49 = omega_s_x * t47 - omega_s_z * t45 - twist[0] * udot_T_z;
    const ella_real t50 = omega_s_y * t45 + twist[0] * udot_T_y - omega_s_x * t46;
    const ella_real b_v_x = R_T_xx * t48 + R_T_yx * t49 + R_T_zx * t50;
    const ella_real b_v_y = R_T_xy * t48 + R_T_yy * t49 + R_T_zy * t50;
    const ella_real b_v_z = R_T_xz * t48 + R_T_yz * t49 + R_T_zz * t50;

    const ella_real t51 = R_T_xx * t14 + R_T_yx * t15 + R_T_zx * t16;
    const ella_real t52 = R_T_xy * t14 + R_T_yy * t15 + R_T_zy * t16;
    const ella_real t53 = R_T_xz * t14 + R_T_yz * t15 + R_T_zz * t16;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const ella_real a_T_x = omega_T_y * v_T_z - t51 - omega_T_z * v_T_y;
    const ella_real a_T_y = omega_T_z * v_T_x - t52 - omega_T_x * v_T_z;
    const ella_real a_T_z = omega_T_x * v_T_y - t53 - omega_T_y * v_T_x;

    /* h_T_F: bias force of the tip bodies, weight included */
    const ella_real h_T_F_x = a_T_x * c->body0_mass;
    const ella_real h_T_F_y = a_T_y * c->body0_mass;
    const ella_real h_T_F_z = a_T_z * c->body0_mass;

    /* joint_H: bias of the joint's rows, springs and dampers included (61) */
    const ella_real joint_H_1 = -(R_rel_xx * base->b[0] + R_rel_yx * base->b[1] + beta_omega_x);
    const ella_real joint_H_2 = R_rel_yx * base->b[0] - R_rel_xx * base->b[1] + minus_beta_omega_y;
    const ella_real joint_H_4 = -(beta_v_x + R_rel_xx * base->b[3] + R_rel_yx * base->b[4]);
    const ella_real joint_H_5 = minus_beta_v_y + R_rel_yx * base->b[3] - R_rel_xx * base->b[4];
    const ella_real t54 = -base->b[5];

    /* outputs */
    link->M_V[0] = I_xx;
    link->M_V[1] = J_xy;
    link->M_V[2] = J_xz;
    link->M_V[3] = S_z;
    link->M_V[4] = S_y;
    link->M_V[5] = I_yy;
    link->M_V[6] = J_yz;
    link->M_V[7] = I_zz;
    link->M_D[0] = L_z1;
    link->M_D[1] = L_z2;
    link->M_D[2] = L_z3;
    link->M_D[3] = L_y1;
    link->M_D[4] = L_y2;
    link->M_D[5] = L_y3;
    link->h_V[0] = h_V_tau_x;
    link->h_V[1] = h_V_tau_y;
    link->h_V[2] = h_V_tau_z;
    link->h_V[3] = h_V_f_x;
    link->h_V[4] = h_V_f_y;
    link->h_V[5] = h_V_f_z;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
    link->h_eta[2] = h_eta_3;
    link->h_eta[3] = h_eta_4;
    link->h_eta[4] = h_eta_5;
    link->h_eta[5] = h_eta_6;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = R_T_xy;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yx;
    link->R_T[4] = R_T_yy;
    link->R_T[5] = R_T_yz;
    link->R_T[6] = R_T_zx;
    link->R_T[7] = R_T_zy;
    link->R_T[8] = R_T_zz;
    link->J_l[0] = J_l_xx;
    link->J_l[1] = J_l_xy;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yx;
    link->J_l[4] = J_l_yy;
    link->J_l[5] = J_l_yz;
    link->J_l[6] = J_l_zx;
    link->J_l[7] = J_l_zy;
    link->J_l[8] = J_l_zz;
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
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
    joint_H[0] = joint_H_1;
    joint_H[1] = joint_H_2;
    joint_H[2] = 0;
    joint_H[3] = joint_H_4;
    joint_H[4] = joint_H_5;
    joint_H[5] = t54;
    joint_W[0] = 0;
    joint_W[1] = 0;
    joint_W[2] = tau[0];
    joint_W[3] = 0;
    joint_W[4] = 0;
    joint_W[5] = 0;
    base->X[0] = R_rel_xx;
    base->X[1] = R_rel_yx;
    base->X[6] = t1;
    base->X[7] = R_rel_xx;
    base->X[21] = R_rel_xx;
    base->X[22] = R_rel_yx;
    base->X[27] = t1;
    base->X[28] = R_rel_xx;
    base->PX[0] = R_rel_xx;
    base->PX[1] = R_rel_yx;
    base->PX[6] = t1;
    base->PX[7] = R_rel_xx;
    base->PX[21] = R_rel_xx;
    base->PX[22] = R_rel_yx;
    base->PX[27] = t1;
    base->PX[28] = R_rel_xx;
    return ELLA_OK;
}

/* link rows, links like upper_arm: 1159 operations */
ELLA_PART ella_status link_rows_upper_arm(const ella_link_constants *c, const ella_link_store *link,
    const ella_node *tip, const ella_real m_eta[7], const ella_real f_eta[7], const ella_real w_ext[6],
    ella_real V_H[6], ella_real eta_H[7], ella_real V_W[6], ella_real eta_W[7], const int *place, ella_real *M)
{
    const ella_real t1 = link->h_eta[0] + f_eta[0];
    const ella_real t2 = link->h_eta[1] + f_eta[1];
    const ella_real t3 = link->h_eta[2] + f_eta[2];
    const ella_real t4 = link->h_eta[3] + f_eta[3];
    const ella_real t5 = link->h_eta[4] + f_eta[4];
    const ella_real t6 = link->h_eta[5] + f_eta[5];

    /* J_TV: twist of the tip section from that of F_i (46) */
    const ella_real J_TV_41 = link->R_T[6] * link->r_T[0] - link->R_T[3] * link->r_T[1];
    const ella_real J_TV_42 = link->R_T[0] * link->r_T[1] - link->R_T[6] * c->length;
    const ella_real J_TV_43 = link->R_T[3] * c->length - link->R_T[0] * link->r_T[0];
    const ella_real J_TV_51 = link->R_T[7] * link->r_T[0] - link->R_T[4] * link->r_T[1];
    const ella_real J_TV_52 = link->R_T[1] * link->r_T[1] - link->R_T[7] * c->length;
    const ella_real J_TV_53 = link->R_T[4] * c->length - link->R_T[1] * link->r_T[0];
    const ella_real J_TV_61 = link->R_T[8] * link->r_T[0] - link->R_T[5] * link->r_T[1];
    const ella_real J_TV_62 = link->R_T[2] * link->r_T[1] - link->R_T[8] * c->length;
    const ella_real J_TV_63 = link->R_T[5] * c->length - link->R_T[2] * link->r_T[0];

    /* J_Teta: twist of the tip section from the modal rates (46) */
    const ella_real t7 = link->J_l[2] * c->Psi_c_z1;
    const ella_real t8 = link->J_l[5] * c->Psi_c_z1;
    const ella_real t9 = link->J_l[8] * c->Psi_c_z1;
    const ella_real J_Teta_11 = link->R_T[0] * t7 + link->R_T[3] * t8 + link->R_T[6] * t9;
    const ella_real t10 = link->J_l[2] * c->Psi_c_z2;
    const ella_real t11 = link->J_l[5] * c->Psi_c_z2;
    const ella_real t12 = link->J_l[8] * c->Psi_c_z2;
    const ella_real J_Teta_12 = link->R_T[0] * t10 + link->R_T[3] * t11 + link->R_T[6] * t12;
    const ella_real t13 = link->J_l[2] * c->Psi_c_z3;
    const ella_real t14 = link->J_l[5] * c->Psi_c_z3;
    const ella_real t15 = link->J_l[8] * c->Psi_c_z3;
    const ella_real J_Teta_13 = link->R_T[0] * t13 + link->R_T[3] * t14 + link->R_T[6] * t15;
    const ella_real t16 = link->J_l[1] * c->Psi_c_y4;
    const ella_real t17 = link->J_l[4] * c->Psi_c_y4;
    const ella_real t18 = link->J_l[7] * c->Psi_c_y4;
    const ella_real J_Teta_14 = link->R_T[0] * t16 + link->R_T[3] * t17 + link->R_T[6] * t18;
    const ella_real t19 = link->J_l[1] * c->Psi_c_y5;
    const ella_real t20 = link->J_l[4] * c->Psi_c_y5;
    const ella_real t21 = link->J_l[7] * c->Psi_c_y5;
    const ella_real J_Teta_15 = link->R_T[0] * t19 + link->R_T[3] * t20 + link->R_T[6] * t21;
    const ella_real t22 = link->J_l[1] * c->Psi_c_y6;
    const ella_real t23 = link->J_l[4] * c->Psi_c_y6;
    const ella_real t24 = link->J_l[7] * c->Psi_c_y6;
    const ella_real J_Teta_16 = link->R_T[0] * t22 + link->R_T[3] * t23 + link->R_T[6] * t24;
    const ella_real t25 = link->J_l[0] * ELLA_REAL(1.7320508075688772);
    const ella_real t26 = link->J_l[3] * ELLA_REAL(1.7320508075688772);
    const ella_real t27 = link->J_l[6] * ELLA_REAL(1.7320508075688772);
    const ella_real J_Teta_17 = link->R_T[0] * t25 + link->R_T[3] * t26 + link->R_T[6] * t27;
    const ella_real J_Teta_21 = link->R_T[1] * t7 + link->R_T[4] * t8 + link->R_T[7] * t9;
    const ella_real J_Teta_22 = link->R_T[1] * t10 + link->R_T[4] * t11 + link->R_T[7] * t12;
    const ella_real J_Teta_23 = link->R_T[1] * t13 + link->R_T[4] * t14 + link->R_T[7] * t15;
    const ella_real J_Teta_24 = link->R_T[1] * t16 + link->R_T[4] * t17 + link->R_T[7] * t18;
    const ella_real J_Teta_25 = link->R_T[1] * t19 + link->R_T[4] * t20 + link->R_T[7] * t21;
    const ella_real J_Teta_26 = link->R_T[1] * t22 + link->R_T[4] * t23 + link->R_T[7] * t24;
    const ella_real J_Teta_27 = link->R_T[1] * t25 + link->R_T[4] * t26 + link->R_T[7] * t27;
    const ella_real J_Teta_31 = link->R_T[2] * t7 + link->R_T[5] * t8 + link->R_T[8] * t9;
    const ella_real J_Teta_32 = link->R_T[2] * t10 + link->R_T[5] * t11 + link->R_T[8] * t12;
    const ella_real J_Teta_33 = link->R_T[2] * t13 + link->R_T[5] * t14 + link->R_T[8] * t15;
    const ella_real J_Teta_34 = link->R_T[2] * t16 + link->R_T[5] * t17 + link->R_T[8] * t18;
    const ella_real J_Teta_35 = link->R_T[2] * t19 + link->R_T[5] * t20 + link->R_T[8] * t21;
    const ella_real J_Teta_36 = link->R_T[2] * t22 + link->R_T[5] * t23 + link->R_T[8] * t24;
    const ella_real J_Teta_37 = link->R_T[2] * t25 + link->R_T[5] * t26 + link->R_T[8] * t27;
    const ella_real J_Teta_41 = link->R_T[3] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_42 = link->R_T[3] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_43 = link->R_T[3] * ELLA_REAL(3.5651069283690613);
    const ella_real J_Teta_44 = link->R_T[6] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_45 = link->R_T[6] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_46 = link->R_T[6] * ELLA_REAL(3.5651069283690613);
    const ella_real J_Teta_51 = link->R_T[4] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_52 = link->R_T[4] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_53 = link->R_T[4] * ELLA_REAL(3.5651069283690613);
    const ella_real J_Teta_54 = link->R_T[7] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_55 = link->R_T[7] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_56 = link->R_T[7] * ELLA_REAL(3.5651069283690613);
    const ella_real J_Teta_61 = link->R_T[5] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_62 = link->R_T[5] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_63 = link->R_T[5] * ELLA_REAL(3.5651069283690613);
    const ella_real J_Teta_64 = link->R_T[8] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_65 = link->R_T[8] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_66 = link->R_T[8] * ELLA_REAL(3.5651069283690613);

    /* V_V: twist rows, twist columns (100) */
    const ella_real t28 = J_TV_41 * c->body0_mass;
    const ella_real t29 = J_TV_51 * c->body0_mass;
    const ella_real t30 = J_TV_61 * c->body0_mass;
    const ella_real V_V_11 = link->M_V[0] + J_TV_41 * t28 + J_TV_51 * t29 + J_TV_61 * t30;
    const ella_real V_V_12 = J_TV_42 * t28 - link->M_V[1] + J_TV_52 * t29 + J_TV_62 * t30;
    const ella_real V_V_13 = J_TV_43 * t28 - link->M_V[2] + J_TV_53 * t29 + J_TV_63 * t30;
    const ella_real V_V_14 = link->R_T[0] * t28 + link->R_T[1] * t29 + link->R_T[2] * t30;
    const ella_real V_V_15 = link->R_T[3] * t28 - link->M_V[3] + link->R_T[4] * t29 + link->R_T[5] * t30;
    const ella_real V_V_16 = link->M_V[4] + link->R_T[6] * t28 + link->R_T[7] * t29 + link->R_T[8] * t30;
    const ella_real t31 = J_TV_42 * c->body0_mass;
    const ella_real t32 = J_TV_52 * c->body0_mass;
    const ella_real t33 = J_TV_62 * c->body0_mass;
    const ella_real V_V_22 = link->M_V[5] + J_TV_42 * t31 + J_TV_52 * t32 + J_TV_62 * t33;
    const ella_real V_V_23 = J_TV_43 * t31 - link->M_V[6] + J_TV_53 * t32 + J_TV_63 * t33;
    const ella_real V_V_24 = link->M_V[3] + link->R_T[0] * t31 + link->R_T[1] * t32 + link->R_T[2] * t33;
    const ella_real V_V_25 = link->R_T[3] * t31 + link->R_T[4] * t32 + link->R_T[5] * t33;
    const ella_real V_V_26 = link->R_T[6] * t31 - c->S_0_x + link->R_T[7] * t32 + link->R_T[8] * t33;
    const ella_real t34 = J_TV_43 * c->body0_mass;
    const ella_real t35 = J_TV_53 * c->body0_mass;
    const ella_real t36 = J_TV_63 * c->body0_mass;
    const ella_real V_V_33 = link->M_V[7] + J_TV_43 * t34 + J_TV_53 * t35 + J_TV_63 * t36;
    const ella_real V_V_34 = link->R_T[0] * t34 - link->M_V[4] + link->R_T[1] * t35 + link->R_T[2] * t36;
    const ella_real V_V_35 = c->S_0_x + link->R_T[3] * t34 + link->R_T[4] * t35 + link->R_T[5] * t36;
    const ella_real V_V_36 = link->R_T[6] * t34 + link->R_T[7] * t35 + link->R_T[8] * t36;
    const ella_real t37 = c->body0_mass * link->R_T[0];
    const ella_real t38 = c->body0_mass * link->R_T[1];
    const ella_real t39 = c->body0_mass * link->R_T[2];
    const ella_real V_V_44 = c->mu + link->R_T[0] * t37 + link->R_T[1] * t38 + link->R_T[2] * t39;
    const ella_real V_V_45 = link->R_T[3] * t37 + link->R_T[4] * t38 + link->R_T[5] * t39;
    const ella_real V_V_46 = link->R_T[6] * t37 + link->R_T[7] * t38 + link->R_T[8] * t39;
    const ella_real t40 = c->body0_mass * link->R_T[3];
    const ella_real t41 = c->body0_mass * link->R_T[4];
    const ella_real t42 = c->body0_mass * link->R_T[5];
    const ella_real V_V_55 = c->mu + link->R_T[3] * t40 + link->R_T[4] * t41 + link->R_T[5] * t42;
    const ella_real V_V_56 = link->R_T[6] * t40 + link->R_T[7] * t41 + link->R_T[8] * t42;
    const ella_real t43 = c->body0_mass * link->R_T[6];
    const ella_real t44 = c->body0_mass * link->R_T[7];
    const ella_real t45 = c->body0_mass * link->R_T[8];
    const ella_real V_V_66 = c->mu + link->R_T[6] * t43 + link->R_T[7] * t44 + link->R_T[8] * t45;

    /* V_eta: twist rows, modal columns (100) */
    const ella_real V_eta_11 = J_Teta_41 * t28 - link->M_D[0] + J_Teta_51 * t29 + J_Teta_61 * t30;
    const ella_real V_eta_12 = J_Teta_42 * t28 - link->M_D[1] + J_Teta_52 * t29 + J_Teta_62 * t30;
    const ella_real V_eta_13 = J_Teta_43 * t28 - link->M_D[2] + J_Teta_53 * t29 + J_Teta_63 * t30;
    const ella_real V_eta_14 = link->M_D[3] + J_Teta_44 * t28 + J_Teta_54 * t29 + J_Teta_64 * t30;
    const ella_real V_eta_15 = link->M_D[4] + J_Teta_45 * t28 + J_Teta_55 * t29 + J_Teta_65 * t30;
    const ella_real V_eta_16 = link->M_D[5] + J_Teta_46 * t28 + J_Teta_56 * t29 + J_Teta_66 * t30;
    const ella_real V_eta_21 = J_Teta_41 * t31 + J_Teta_51 * t32 + J_Teta_61 * t33;
    const ella_real V_eta_22 = J_Teta_42 * t31 + J_Teta_52 * t32 + J_Teta_62 * t33;
    const ella_real V_eta_23 = J_Teta_43 * t31 + J_Teta_53 * t32 + J_Teta_63 * t33;
    const ella_real V_eta_24 = J_Teta_44 * t31 - c->chi_1 + J_Teta_54 * t32 + J_Teta_64 * t33;
    const ella_real V_eta_25 = J_Teta_45 * t31 - c->chi_2 + J_Teta_55 * t32 + J_Teta_65 * t33;
    const ella_real V_eta_26 = J_Teta_46 * t31 - c->chi_3 + J_Teta_56 * t32 + J_Teta_66 * t33;
    const ella_real V_eta_31 = c->chi_1 + J_Teta_41 * t34 + J_Teta_51 * t35 + J_Teta_61 * t36;
    const ella_real V_eta_32 = c->chi_2 + J_Teta_42 * t34 + J_Teta_52 * t35 + J_Teta_62 * t36;
    const ella_real V_eta_33 = c->chi_3 + J_Teta_43 * t34 + J_Teta_53 * t35 + J_Teta_63 * t36;
    const ella_real V_eta_34 = J_Teta_44 * t34 + J_Teta_54 * t35 + J_Teta_64 * t36;
    const ella_real V_eta_35 = J_Teta_45 * t34 + J_Teta_55 * t35 + J_Teta_65 * t36;
    const ella_real V_eta_36 = J_Teta_46 * t34 + J_Teta_56 * t35 + J_Teta_66 * t36;
    const ella_real V_eta_41 = J_Teta_41 * t37 + J_Teta_51 * t38 + J_Teta_61 * t39;
    const ella_real V_eta_42 = J_Teta_42 * t37 + J_Teta_52 * t38 + J_Teta_62 * t39;
    const ella_real V_eta_43 = J_Teta_43 * t37 + J_Teta_53 * t38 + J_Teta_63 * t39;
    const ella_real V_eta_44 = J_Teta_44 * t37 + J_Teta_54 * t38 + J_Teta_64 * t39;
    const ella_real V_eta_45 = J_Teta_45 * t37 + J_Teta_55 * t38 + J_Teta_65 * t39;
    const ella_real V_eta_46 = J_Teta_46 * t37 + J_Teta_56 * t38 + J_Teta_66 * t39;
    const ella_real V_eta_51 = c->sigma_y1 + J_Teta_41 * t40 + J_Teta_51 * t41 + J_Teta_61 * t42;
    const ella_real V_eta_52 = c->sigma_y2 + J_Teta_42 * t40 + J_Teta_52 * t41 + J_Teta_62 * t42;
    const ella_real V_eta_53 = c->sigma_y3 + J_Teta_43 * t40 + J_Teta_53 * t41 + J_Teta_63 * t42;
    const ella_real V_eta_54 = J_Teta_44 * t40 + J_Teta_54 * t41 + J_Teta_64 * t42;
    const ella_real V_eta_55 = J_Teta_45 * t40 + J_Teta_55 * t41 + J_Teta_65 * t42;
    const ella_real V_eta_56 = J_Teta_46 * t40 + J_Teta_56 * t41 + J_Teta_66 * t42;
    const ella_real V_eta_61 = J_Teta_41 * t43 + J_Teta_51 * t44 + J_Teta_61 * t45;
    const ella_real V_eta_62 = J_Teta_42 * t43 + J_Teta_52 * t44 + J_Teta_62 * t45;
    const ella_real V_eta_63 = J_Teta_43 * t43 + J_Teta_53 * t44 + J_Teta_63 * t45;
    const ella_real V_eta_64 = c->sigma_y1 + J_Teta_44 * t43 + J_Teta_54 * t44 + J_Teta_64 * t45;
    const ella_real V_eta_65 = c->sigma_y2 + J_Teta_45 * t43 + J_Teta_55 * t44 + J_Teta_65 * t45;
    const ella_real V_eta_66 = c->sigma_y3 + J_Teta_46 * t43 + J_Teta_56 * t44 + J_Teta_66 * t45;

    /* eta_eta: modal rows, modal columns (100) */
    const ella_real t46 = J_Teta_41 * c->body0_mass;
    const ella_real t47 = J_Teta_51 * c->body0_mass;
    const ella_real t48 = J_Teta_61 * c->body0_mass;
    const ella_real eta_eta_11 = m_eta[0] + J_Teta_41 * t46 + J_Teta_51 * t47 + J_Teta_61 * t48;
    const ella_real eta_eta_12 = J_Teta_42 * t46 + J_Teta_52 * t47 + J_Teta_62 * t48;
    const ella_real eta_eta_13 = J_Teta_43 * t46 + J_Teta_53 * t47 + J_Teta_63 * t48;
    const ella_real eta_eta_14 = J_Teta_44 * t46 + J_Teta_54 * t47 + J_Teta_64 * t48;
    const ella_real eta_eta_15 = J_Teta_45 * t46 + J_Teta_55 * t47 + J_Teta_65 * t48;
    const ella_real eta_eta_16 = J_Teta_46 * t46 + J_Teta_56 * t47 + J_Teta_66 * t48;
    const ella_real t49 = J_Teta_42 * c->body0_mass;
    const ella_real t50 = J_Teta_52 * c->body0_mass;
    const ella_real t51 = J_Teta_62 * c->body0_mass;
    const ella_real eta_eta_22 = m_eta[1] + J_Teta_42 * t49 + J_Teta_52 * t50 + J_Teta_62 * t51;
    const ella_real eta_eta_23 = J_Teta_43 * t49 + J_Teta_53 * t50 + J_Teta_63 * t51;
    const ella_real eta_eta_24 = J_Teta_44 * t49 + J_Teta_54 * t50 + J_Teta_64 * t51;
    const ella_real eta_eta_25 = J_Teta_45 * t49 + J_Teta_55 * t50 + J_Teta_65 * t51;
    const ella_real eta_eta_26 = J_Teta_46 * t49 + J_Teta_56 * t50 + J_Teta_66 * t51;
    const ella_real t52 = J_Teta_43 * c->body0_mass;
    const ella_real t53 = J_Teta_53 * c->body0_mass;
    const ella_real t54 = J_Teta_63 * c->body0_mass;
    const ella_real eta_eta_33 = m_eta[2] + J_Teta_43 * t52 + J_Teta_53 * t53 + J_Teta_63 * t54;
    const ella_real eta_eta_34 = J_Teta_44 * t52 + J_Teta_54 * t53 + J_Teta_64 * t54;
    const ella_real eta_eta_35 = J_Teta_45 * t52 + J_Teta_55 * t53 + J_Teta_65 * t54;
    const ella_real eta_eta_36 = J_Teta_46 * t52 + J_Teta_56 * t53 + J_Teta_66 * t54;
    const ella_real t55 = J_Teta_44 * c->body0_mass;
    const ella_real t56 = J_Teta_54 * c->body0_mass;
    const ella_real t57 = J_Teta_64 * c->body0_mass;
    const ella_real eta_eta_44 = m_eta[3] + J_Teta_44 * t55 + J_Teta_54 * t56 + J_Teta_64 * t57;
    const ella_real eta_eta_45 = J_Teta_45 * t55 + J_Teta_55 * t56 + J_Teta_65 * t57;
    const ella_real eta_eta_46 = J_Teta_46 * t55 + J_Teta_56 * t56 + J_Teta_66 * t57;
    const ella_real t58 = J_Teta_45 * c->body0_mass;
    const ella_real t59 = J_Teta_55 * c->body0_mass;
    const ella_real t60 = J_Teta_65 * c->body0_mass;
    const ella_real eta_eta_55 = m_eta[4] + J_Teta_45 * t58 + J_Teta_55 * t59 + J_Teta_65 * t60;
    const ella_real eta_eta_56 = J_Teta_46 * t58 + J_Teta_56 * t59 + J_Teta_66 * t60;
    const ella_real eta_eta_66 = m_eta[5] + J_Teta_46 * (J_Teta_46 * c->body0_mass)
        + J_Teta_56 * (J_Teta_56 * c->body0_mass) + J_Teta_66 * (J_Teta_66 * c->body0_mass);

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const ella_real V_next_11 = link->R_T[0] * tip->X[0] + link->R_T[1] * tip->X[1];
    const ella_real V_next_12 = link->R_T[0] * tip->X[6] + link->R_T[1] * tip->X[7];
    const ella_real V_next_14 = J_TV_41 * tip->X[21] + J_TV_51 * tip->X[22];
    const ella_real V_next_15 = J_TV_41 * tip->X[27] + J_TV_51 * tip->X[28];
    const ella_real V_next_21 = link->R_T[3] * tip->X[0] + link->R_T[4] * tip->X[1];
    const ella_real V_next_22 = link->R_T[3] * tip->X[6] + link->R_T[4] * tip->X[7];
    const ella_real V_next_24 = J_TV_42 * tip->X[21] + J_TV_52 * tip->X[22];
    const ella_real V_next_25 = J_TV_42 * tip->X[27] + J_TV_52 * tip->X[28];
    const ella_real V_next_31 = link->R_T[6] * tip->X[0] + link->R_T[7] * tip->X[1];
    const ella_real V_next_32 = link->R_T[6] * tip->X[6] + link->R_T[7] * tip->X[7];
    const ella_real V_next_34 = J_TV_43 * tip->X[21] + J_TV_53 * tip->X[22];
    const ella_real V_next_35 = J_TV_43 * tip->X[27] + J_TV_53 * tip->X[28];
    const ella_real V_next_44 = link->R_T[0] * tip->X[21] + link->R_T[1] * tip->X[22];
    const ella_real V_next_45 = link->R_T[0] * tip->X[27] + link->R_T[1] * tip->X[28];
    const ella_real V_next_54 = link->R_T[3] * tip->X[21] + link->R_T[4] * tip->X[22];
    const ella_real V_next_55 = link->R_T[3] * tip->X[27] + link->R_T[4] * tip->X[28];
    const ella_real V_next_64 = link->R_T[6] * tip->X[21] + link->R_T[7] * tip->X[22];
    const ella_real V_next_65 = link->R_T[6] * tip->X[27] + link->R_T[7] * tip->X[28];

    /* eta_next: modal rows, columns of the next joint's wrench (100) */
    const ella_real eta_next_11 = J_Teta_11 * tip->X[0] + J_Teta_21 * tip->X[1];
    const ella_real eta_next_12 = J_Teta_11 * tip->X[6] + J_Teta_21 * tip->X[7];
    const ella_real eta_next_14 = J_Teta_41 * tip->X[21] + J_Teta_51 * tip->X[22];
    const ella_real eta_next_15 = J_Teta_41 * tip->X[27] + J_Teta_51 * tip->X[28];
    const ella_real eta_next_21 = J_Teta_12 * tip->X[0] + J_Teta_22 * tip->X[1];
    const ella_real eta_next_22 = J_Teta_12 * tip->X[6] + J_Teta_22 * tip->X[7];
    const ella_real eta_next_24 = J_Teta_42 * tip->X[21] + J_Teta_52 * tip->X[22];
    const ella_real eta_next_25 = J_Teta_42 * tip->X[27] + J_Teta_52 * tip->X[28];
    const ella_real eta_next_31 = J_Teta_13 * tip->X[0] + J_Teta_23 * tip->X[1];
    const ella_real eta_next_32 = J_Teta_13 * tip->X[6] + J_Teta_23 * tip->X[7];
    const ella_real eta_next_34 = J_Teta_43 * tip->X[21] + J_Teta_53 * tip->X[22];
    const ella_real eta_next_35 = J_Teta_43 * tip->X[27] + J_Teta_53 * tip->X[28];
    const ella_real eta_next_41 = J_Teta_14 * tip->X[0] + J_Teta_24 * tip->X[1];
    const ella_real eta_next_42 = J_Teta_14 * tip->X[6] + J_Teta_24 * tip->X[7];
    const ella_real eta_next_44 = J_Teta_44 * tip->X[21] + J_Teta_54 * tip->X[22];
    const ella_real eta_next_45 = J_Teta_44 * tip->X[27] + J_Teta_54 * tip->X[28];
    const ella_real eta_next_51 = J_Teta_15 * tip->X[0] + J_Teta_25 * tip->X[1];
    const ella_real eta_next_52 = J_Teta_15 * tip->X[6] + J_Teta_25 * tip->X[7];
    const ella_real eta_next_54 = J_Teta_45 * tip->X[21] + J_Teta_55 * tip->X[22];
    const ella_real eta_next_55 = J_Teta_45 * tip->X[27] + J_Teta_55 * tip->X[28];
    const ella_real eta_next_61 = J_Teta_16 * tip->X[0] + J_Teta_26 * tip->X[1];
    const ella_real eta_next_62 = J_Teta_16 * tip->X[6] + J_Teta_26 * tip->X[7];
    const ella_real eta_next_64 = J_Teta_46 * tip->X[21] + J_Teta_56 * tip->X[22];
    const ella_real eta_next_65 = J_Teta_46 * tip->X[27] + J_Teta_56 * tip->X[28];
    const ella_real eta_next_71 = J_Teta_17 * tip->X[0] + J_Teta_27 * tip->X[1];
    const ella_real eta_next_72 = J_Teta_17 * tip->X[6] + J_Teta_27 * tip->X[7];

    /* next_V: next joint's rows, twist columns (100) */
    const ella_real next_V_11 = -(tip->PX[0] * link->R_T[0] + tip->PX[1] * link->R_T[1]);
    const ella_real next_V_12 = -(tip->PX[0] * link->R_T[3] + tip->PX[1] * link->R_T[4]);
    const ella_real next_V_13 = -(tip->PX[0] * link->R_T[6] + tip->PX[1] * link->R_T[7]);
    const ella_real next_V_21 = -(tip->PX[6] * link->R_T[0] + tip->PX[7] * link->R_T[1]);
    const ella_real next_V_22 = -(tip->PX[6] * link->R_T[3] + tip->PX[7] * link->R_T[4]);
    const ella_real next_V_23 = -(tip->PX[6] * link->R_T[6] + tip->PX[7] * link->R_T[7]);
    const ella_real next_V_41 = -(J_TV_41 * tip->PX[21] + J_TV_51 * tip->PX[22]);
    const ella_real next_V_42 = -(J_TV_42 * tip->PX[21] + J_TV_52 * tip->PX[22]);
    const ella_real next_V_43 = -(J_TV_43 * tip->PX[21] + J_TV_53 * tip->PX[22]);
    const ella_real next_V_44 = -(tip->PX[21] * link->R_T[0] + tip->PX[22] * link->R_T[1]);
    const ella_real next_V_45 = -(tip->PX[21] * link->R_T[3] + tip->PX[22] * link->R_T[4]);
    const ella_real next_V_46 = -(tip->PX[21] * link->R_T[6] + tip->PX[22] * link->R_T[7]);
    const ella_real next_V_51 = -(J_TV_41 * tip->PX[27] + J_TV_51 * tip->PX[28]);
    const ella_real next_V_52 = -(J_TV_42 * tip->PX[27] + J_TV_52 * tip->PX[28]);
    const ella_real next_V_53 = -(J_TV_43 * tip->PX[27] + J_TV_53 * tip->PX[28]);
    const ella_real next_V_54 = -(tip->PX[27] * link->R_T[0] + tip->PX[28] * link->R_T[1]);
    const ella_real next_V_55 = -(tip->PX[27] * link->R_T[3] + tip->PX[28] * link->R_T[4]);
    const ella_real next_V_56 = -(tip->PX[27] * link->R_T[6] + tip->PX[28] * link->R_T[7]);
    const ella_real t61 = -J_TV_61;
    const ella_real t62 = -J_TV_62;
    const ella_real t63 = -J_TV_63;
    const ella_real t64 = -link->R_T[2];
    const ella_real t65 = -link->R_T[5];
    const ella_real t66 = -link->R_T[8];

    /* next_eta: next joint's rows, modal columns (100) */
    const ella_real next_eta_11 = -(J_Teta_11 * tip->PX[0] + J_Teta_21 * tip->PX[1]);
    const ella_real next_eta_12 = -(J_Teta_12 * tip->PX[0] + J_Teta_22 * tip->PX[1]);
    const ella_real next_eta_13 = -(J_Teta_13 * tip->PX[0] + J_Teta_23 * tip->PX[1]);
    const ella_real next_eta_14 = -(J_Teta_14 * tip->PX[0] + J_Teta_24 * tip->PX[1]);
    const ella_real next_eta_15 = -(J_Teta_15 * tip->PX[0] + J_Teta_25 * tip->PX[1]);
    const ella_real next_eta_16 = -(J_Teta_16 * tip->PX[0] + J_Teta_26 * tip->PX[1]);
    const ella_real next_eta_17 = -(J_Teta_17 * tip->PX[0] + J_Teta_27 * tip->PX[1]);
    const ella_real next_eta_21 = -(J_Teta_11 * tip->PX[6] + J_Teta_21 * tip->PX[7]);
    const ella_real next_eta_22 = -(J_Teta_12 * tip->PX[6] + J_Teta_22 * tip->PX[7]);
    const ella_real next_eta_23 = -(J_Teta_13 * tip->PX[6] + J_Teta_23 * tip->PX[7]);
    const ella_real next_eta_24 = -(J_Teta_14 * tip->PX[6] + J_Teta_24 * tip->PX[7]);
    const ella_real next_eta_25 = -(J_Teta_15 * tip->PX[6] + J_Teta_25 * tip->PX[7]);
    const ella_real next_eta_26 = -(J_Teta_16 * tip->PX[6] + J_Teta_26 * tip->PX[7]);
    const ella_real next_eta_27 = -(J_Teta_17 * tip->PX[6] + J_Teta_27 * tip->PX[7]);
    const ella_real next_eta_41 = -(J_Teta_41 * tip->PX[21] + J_Teta_51 * tip->PX[22]);
    const ella_real next_eta_42 = -(J_Teta_42 * tip->PX[21] + J_Teta_52 * tip->PX[22]);
    const ella_real next_eta_43 = -(J_Teta_43 * tip->PX[21] + J_Teta_53 * tip->PX[22]);
    const ella_real next_eta_44 = -(J_Teta_44 * tip->PX[21] + J_Teta_54 * tip->PX[22]);
    const ella_real next_eta_45 = -(J_Teta_45 * tip->PX[21] + J_Teta_55 * tip->PX[22]);
    const ella_real next_eta_46 = -(J_Teta_46 * tip->PX[21] + J_Teta_56 * tip->PX[22]);
    const ella_real next_eta_51 = -(J_Teta_41 * tip->PX[27] + J_Teta_51 * tip->PX[28]);
    const ella_real next_eta_52 = -(J_Teta_42 * tip->PX[27] + J_Teta_52 * tip->PX[28]);
    const ella_real next_eta_53 = -(J_Teta_43 * tip->PX[27] + J_Teta_53 * tip->PX[28]);
    const ella_real next_eta_54 = -(J_Teta_44 * tip->PX[27] + J_Teta_54 * tip->PX[28]);
    const ella_real next_eta_55 = -(J_Teta_45 * tip->PX[27] + J_Teta_55 * tip->PX[28]);
    const ella_real next_eta_56 = -(J_Teta_46 * tip->PX[27] + J_Teta_56 * tip->PX[28]);
    const ella_real t67 = -J_Teta_61;
    const ella_real t68 = -J_Teta_62;
    const ella_real t69 = -J_Teta_63;
    const ella_real t70 = -J_Teta_64;
    const ella_real t71 = -J_Teta_65;
    const ella_real t72 = -J_Teta_66;

    /* h_carried: bias of the bodies at the tip, its acceleration bias included */
    const ella_real h_carried_f_x = link->h_T[0] + c->body0_mass * link->b_T[3];
    const ella_real h_carried_f_y = link->h_T[1] + c->body0_mass * link->b_T[4];
    const ella_real h_carried_f_z = link->h_T[2] + c->body0_mass * link->b_T[5];

    /* V_H: bias of the twist rows (100) */
    const ella_real V_H_tau_x = link->h_V[0] + J_TV_41 * h_carried_f_x + J_TV_51 * h_carried_f_y
        + J_TV_61 * h_carried_f_z;
    const ella_real V_H_tau_y = link->h_V[1] + J_TV_42 * h_carried_f_x + J_TV_52 * h_carried_f_y
        + J_TV_62 * h_carried_f_z;
    const ella_real V_H_tau_z = link->h_V[2] + J_TV_43 * h_carried_f_x + J_TV_53 * h_carried_f_y
        + J_TV_63 * h_carried_f_z;
    const ella_real V_H_f_x = link->h_V[3] + link->R_T[0] * h_carried_f_x + link->R_T[1] * h_carried_f_y
        + link->R_T[2] * h_carried_f_z;
    const ella_real V_H_f_y = link->h_V[4] + link->R_T[3] * h_carried_f_x + link->R_T[4] * h_carried_f_y
        + link->R_T[5] * h_carried_f_z;
    const ella_real V_H_f_z = link->h_V[5] + link->R_T[6] * h_carried_f_x + link->R_T[7] * h_carried_f_y
        + link->R_T[8] * h_carried_f_z;

    /* eta_H: bias of the modal rows (100) */
    const ella_real eta_H_1 = t1 + J_Teta_41 * h_carried_f_x + J_Teta_51 * h_carried_f_y + J_Teta_61 * h_carried_f_z;
    const ella_real eta_H_2 = t2 + J_Teta_42 * h_carried_f_x + J_Teta_52 * h_carried_f_y + J_Teta_62 * h_carried_f_z;
    const ella_real eta_H_3 = t3 + J_Teta_43 * h_carried_f_x + J_Teta_53 * h_carried_f_y + J_Teta_63 * h_carried_f_z;
    const ella_real eta_H_4 = t4 + J_Teta_44 * h_carried_f_x + J_Teta_54 * h_carried_f_y + J_Teta_64 * h_carried_f_z;
    const ella_real eta_H_5 = t5 + J_Teta_45 * h_carried_f_x + J_Teta_55 * h_carried_f_y + J_Teta_65 * h_carried_f_z;
    const ella_real eta_H_6 = t6 + J_Teta_46 * h_carried_f_x + J_Teta_56 * h_carried_f_y + J_Teta_66 * h_carried_f_z;

    /* V_W: external wrench in the twist rows (100) */
    const ella_real t73 = J_TV_41 * w_ext[3] + J_TV_51 * w_ext[4] + J_TV_61 * w_ext[5] + link->R_T[0] * w_ext[0]
        + link->R_T[1] * w_ext[1];
    const ella_real V_W_tau_x = t73 + link->R_T[2] * w_ext[2];
    const ella_real t74 = J_TV_42 * w_ext[3] + J_TV_52 * w_ext[4] + J_TV_62 * w_ext[5] + link->R_T[3] * w_ext[0]
        + link->R_T[4] * w_ext[1];
    const ella_real V_W_tau_y = t74 + link->R_T[5] * w_ext[2];
    const ella_real t75 = J_TV_43 * w_ext[3] + J_TV_53 * w_ext[4] + J_TV_63 * w_ext[5] + link->R_T[6] * w_ext[0]
        + link->R_T[7] * w_ext[1];
    const ella_real V_W_tau_z = t75 + link->R_T[8] * w_ext[2];
    const ella_real V_W_f_x = link->R_T[0] * w_ext[3] + link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5];
    const ella_real V_W_f_y = link->R_T[3] * w_ext[3] + link->R_T[4] * w_ext[4] + link->R_T[5] * w_ext[5];
    const ella_real V_W_f_z = link->R_T[6] * w_ext[3] + link->R_T[7] * w_ext[4] + link->R_T[8] * w_ext[5];

    /* eta_W: external wrench in the modal rows (100) */
    const ella_real t76 = J_Teta_11 * w_ext[0] + J_Teta_21 * w_ext[1] + J_Teta_31 * w_ext[2] + J_Teta_41 * w_ext[3]
        + J_Teta_51 * w_ext[4];
    const ella_real eta_W_1 = t76 + J_Teta_61 * w_ext[5];
    const ella_real t77 = J_Teta_12 * w_ext[0] + J_Teta_22 * w_ext[1] + J_Teta_32 * w_ext[2] + J_Teta_42 * w_ext[3]
        + J_Teta_52 * w_ext[4];
    const ella_real eta_W_2 = t77 + J_Teta_62 * w_ext[5];
    const ella_real t78 = J_Teta_13 * w_ext[0] + J_Teta_23 * w_ext[1] + J_Teta_33 * w_ext[2] + J_Teta_43 * w_ext[3]
        + J_Teta_53 * w_ext[4];
    const ella_real eta_W_3 = t78 + J_Teta_63 * w_ext[5];
    const ella_real t79 = J_Teta_14 * w_ext[0] + J_Teta_24 * w_ext[1] + J_Teta_34 * w_ext[2] + J_Teta_44 * w_ext[3]
        + J_Teta_54 * w_ext[4];
    const ella_real eta_W_4 = t79 + J_Teta_64 * w_ext[5];
    const ella_real t80 = J_Teta_15 * w_ext[0] + J_Teta_25 * w_ext[1] + J_Teta_35 * w_ext[2] + J_Teta_45 * w_ext[3]
        + J_Teta_55 * w_ext[4];
    const ella_real eta_W_5 = t80 + J_Teta_65 * w_ext[5];
    const ella_real t81 = J_Teta_16 * w_ext[0] + J_Teta_26 * w_ext[1] + J_Teta_36 * w_ext[2] + J_Teta_46 * w_ext[3]
        + J_Teta_56 * w_ext[4];
    const ella_real eta_W_6 = t81 + J_Teta_66 * w_ext[5];
    const ella_real eta_W_7 = J_Teta_17 * w_ext[0] + J_Teta_27 * w_ext[1] + J_Teta_37 * w_ext[2];

    /* outputs */
    M[place[12]] = next_V_11;
    M[place[13]] = next_V_12;
    M[place[14]] = next_V_13;
    M[place[15]] = next_V_21;
    M[place[16]] = next_V_22;
    M[place[17]] = next_V_23;
    M[place[18]] = next_V_41;
    M[place[19]] = next_V_42;
    M[place[20]] = next_V_43;
    M[place[21]] = next_V_44;
    M[place[22]] = next_V_45;
    M[place[23]] = next_V_46;
    M[place[24]] = next_V_51;
    M[place[25]] = next_V_52;
    M[place[26]] = next_V_53;
    M[place[27]] = next_V_54;
    M[place[28]] = next_V_55;
    M[place[29]] = next_V_56;
    M[place[30]] = t61;
    M[place[31]] = t62;
    M[place[32]] = t63;
    M[place[33]] = t64;
    M[place[34]] = t65;
    M[place[35]] = t66;
    M[place[36]] = next_eta_11;
    M[place[37]] = next_eta_12;
    M[place[38]] = next_eta_13;
    M[place[39]] = next_eta_14;
    M[place[40]] = next_eta_15;
    M[place[41]] = next_eta_16;
    M[place[42]] = next_eta_17;
    M[place[43]] = next_eta_21;
    M[place[44]] = next_eta_22;
    M[place[45]] = next_eta_23;
    M[place[46]] = next_eta_24;
    M[place[47]] = next_eta_25;
    M[place[48]] = next_eta_26;
    M[place[49]] = next_eta_27;
    M[place[50]] = next_eta_41;
    M[place[51]] = next_eta_42;
    M[place[52]] = next_eta_43;
    M[place[53]] = next_eta_44;
    M[place[54]] = next_eta_45;
    M[place[55]] = next_eta_46;
    M[place[56]] = next_eta_51;
    M[place[57]] = next_eta_52;
    M[place[58]] = next_eta_53;
    M[place[59]] = next_eta_54;
    M[place[60]] = next_eta_55;
    M[place[61]] = next_eta_56;
    M[place[62]] = t67;
    M[place[63]] = t68;
    M[place[64]] = t69;
    M[place[65]] = t70;
    M[place[66]] = t71;
    M[place[67]] = t72;
    M[place[68]] = -1;
    M[place[69]] = -1;
    M[place[70]] = -1;
    M[place[71]] = -1;
    M[place[72]] = -1;
    M[place[73]] = -1;
    M[place[74]] = V_V_11;
    M[place[75]] = V_V_12;
    M[place[76]] = V_V_13;
    M[place[77]] = V_V_14;
    M[place[78]] = V_V_15;
    M[place[79]] = V_V_16;
    M[place[80]] = V_V_12;
    M[place[81]] = V_V_22;
    M[place[82]] = V_V_23;
    M[place[83]] = V_V_24;
    M[place[84]] = V_V_25;
    M[place[85]] = V_V_26;
    M[place[86]] = V_V_13;
    M[place[87]] = V_V_23;
    M[place[88]] = V_V_33;
    M[place[89]] = V_V_34;
    M[place[90]] = V_V_35;
    M[place[91]] = V_V_36;
    M[place[92]] = V_V_14;
    M[place[93]] = V_V_24;
    M[place[94]] = V_V_34;
    M[place[95]] = V_V_44;
    M[place[96]] = V_V_45;
    M[place[97]] = V_V_46;
    M[place[98]] = V_V_15;
    M[place[99]] = V_V_25;
    M[place[100]] = V_V_35;
    M[place[101]] = V_V_45;
    M[place[102]] = V_V_55;
    M[place[103]] = V_V_56;
    M[place[104]] = V_V_16;
    M[place[105]] = V_V_26;
    M[place[106]] = V_V_36;
    M[place[107]] = V_V_46;
    M[place[108]] = V_V_56;
    M[place[109]] = V_V_66;
    M[place[110]] = V_eta_11;
    M[place[111]] = V_eta_12;
    M[place[112]] = V_eta_13;
    M[place[113]] = V_eta_14;
    M[place[114]] = V_eta_15;
    M[place[115]] = V_eta_16;
    M[place[116]] = c->sigma_t_7;
    M[place[117]] = V_eta_21;
    M[place[118]] = V_eta_22;
    M[place[119]] = V_eta_23;
    M[place[120]] = V_eta_24;
    M[place[121]] = V_eta_25;
    M[place[122]] = V_eta_26;
    M[place[123]] = V_eta_31;
    M[place[124]] = V_eta_32;
    M[place[125]] = V_eta_33;
    M[place[126]] = V_eta_34;
    M[place[127]] = V_eta_35;
    M[place[128]] = V_eta_36;
    M[place[129]] = V_eta_41;
    M[place[130]] = V_eta_42;
    M[place[131]] = V_eta_43;
    M[place[132]] = V_eta_44;
    M[place[133]] = V_eta_45;
    M[place[134]] = V_eta_46;
    M[place[135]] = V_eta_51;
    M[place[136]] = V_eta_52;
    M[place[137]] = V_eta_53;
    M[place[138]] = V_eta_54;
    M[place[139]] = V_eta_55;
    M[place[140]] = V_eta_56;
    M[place[141]] = V_eta_61;
    M[place[142]] = V_eta_62;
    M[place[143]] = V_eta_63;
    M[place[144]] = V_eta_64;
    M[place[145]] = V_eta_65;
    M[place[146]] = V_eta_66;
    M[place[147]] = V_next_11;
    M[place[148]] = V_next_12;
    M[place[149]] = link->R_T[2];
    M[place[150]] = V_next_14;
    M[place[151]] = V_next_15;
    M[place[152]] = J_TV_61;
    M[place[153]] = V_next_21;
    M[place[154]] = V_next_22;
    M[place[155]] = link->R_T[5];
    M[place[156]] = V_next_24;
    M[place[157]] = V_next_25;
    M[place[158]] = J_TV_62;
    M[place[159]] = V_next_31;
    M[place[160]] = V_next_32;
    M[place[161]] = link->R_T[8];
    M[place[162]] = V_next_34;
    M[place[163]] = V_next_35;
    M[place[164]] = J_TV_63;
    M[place[165]] = V_next_44;
    M[place[166]] = V_next_45;
    M[place[167]] = link->R_T[2];
    M[place[168]] = V_next_54;
    M[place[169]] = V_next_55;
    M[place[170]] = link->R_T[5];
    M[place[171]] = V_next_64;
    M[place[172]] = V_next_65;
    M[place[173]] = link->R_T[8];
    M[place[174]] = V_eta_11;
    M[place[175]] = V_eta_21;
    M[place[176]] = V_eta_31;
    M[place[177]] = V_eta_41;
    M[place[178]] = V_eta_51;
    M[place[179]] = V_eta_61;
    M[place[180]] = V_eta_12;
    M[place[181]] = V_eta_22;
    M[place[182]] = V_eta_32;
    M[place[183]] = V_eta_42;
    M[place[184]] = V_eta_52;
    M[place[185]] = V_eta_62;
    M[place[186]] = V_eta_13;
    M[place[187]] = V_eta_23;
    M[place[188]] = V_eta_33;
    M[place[189]] = V_eta_43;
    M[place[190]] = V_eta_53;
    M[place[191]] = V_eta_63;
    M[place[192]] = V_eta_14;
    M[place[193]] = V_eta_24;
    M[place[194]] = V_eta_34;
    M[place[195]] = V_eta_44;
    M[place[196]] = V_eta_54;
    M[place[197]] = V_eta_64;
    M[place[198]] = V_eta_15;
    M[place[199]] = V_eta_25;
    M[place[200]] = V_eta_35;
    M[place[201]] = V_eta_45;
    M[place[202]] = V_eta_55;
    M[place[203]] = V_eta_65;
    M[place[204]] = V_eta_16;
    M[place[205]] = V_eta_26;
    M[place[206]] = V_eta_36;
    M[place[207]] = V_eta_46;
    M[place[208]] = V_eta_56;
    M[place[209]] = V_eta_66;
    M[place[210]] = c->sigma_t_7;
    M[place[211]] = eta_eta_11;
    M[place[212]] = eta_eta_12;
    M[place[213]] = eta_eta_13;
    M[place[214]] = eta_eta_14;
    M[place[215]] = eta_eta_15;
    M[place[216]] = eta_eta_16;
    M[place[217]] = eta_eta_12;
    M[place[218]] = eta_eta_22;
    M[place[219]] = eta_eta_23;
    M[place[220]] = eta_eta_24;
    M[place[221]] = eta_eta_25;
    M[place[222]] = eta_eta_26;
    M[place[223]] = eta_eta_13;
    M[place[224]] = eta_eta_23;
    M[place[225]] = eta_eta_33;
    M[place[226]] = eta_eta_34;
    M[place[227]] = eta_eta_35;
    M[place[228]] = eta_eta_36;
    M[place[229]] = eta_eta_14;
    M[place[230]] = eta_eta_24;
    M[place[231]] = eta_eta_34;
    M[place[232]] = eta_eta_44;
    M[place[233]] = eta_eta_45;
    M[place[234]] = eta_eta_46;
    M[place[235]] = eta_eta_15;
    M[place[236]] = eta_eta_25;
    M[place[237]] = eta_eta_35;
    M[place[238]] = eta_eta_45;
    M[place[239]] = eta_eta_55;
    M[place[240]] = eta_eta_56;
    M[place[241]] = eta_eta_16;
    M[place[242]] = eta_eta_26;
    M[place[243]] = eta_eta_36;
    M[place[244]] = eta_eta_46;
    M[place[245]] = eta_eta_56;
    M[place[246]] = eta_eta_66;
    M[place[247]] = m_eta[6];
    M[place[248]] = eta_next_11;
    M[place[249]] = eta_next_12;
    M[place[250]] = J_Teta_31;
    M[place[251]] = eta_next_14;
    M[place[252]] = eta_next_15;
    M[place[253]] = J_Teta_61;
    M[place[254]] = eta_next_21;
    M[place[255]] = eta_next_22;
    M[place[256]] = J_Teta_32;
    M[place[257]] = eta_next_24;
    M[place[258]] = eta_next_25;
    M[place[259]] = J_Teta_62;
    M[place[260]] = eta_next_31;
    M[place[261]] = eta_next_32;
    M[place[262]] = J_Teta_33;
    M[place[263]] = eta_next_34;
    M[place[264]] = eta_next_35;
    M[place[265]] = J_Teta_63;
    M[place[266]] = eta_next_41;
    M[place[267]] = eta_next_42;
    M[place[268]] = J_Teta_34;
    M[place[269]] = eta_next_44;
    M[place[270]] = eta_next_45;
    M[place[271]] = J_Teta_64;
    M[place[272]] = eta_next_51;
    M[place[273]] = eta_next_52;
    M[place[274]] = J_Teta_35;
    M[place[275]] = eta_next_54;
    M[place[276]] = eta_next_55;
    M[place[277]] = J_Teta_65;
    M[place[278]] = eta_next_61;
    M[place[279]] = eta_next_62;
    M[place[280]] = J_Teta_36;
    M[place[281]] = eta_next_64;
    M[place[282]] = eta_next_65;
    M[place[283]] = J_Teta_66;
    M[place[284]] = eta_next_71;
    M[place[285]] = eta_next_72;
    M[place[286]] = J_Teta_37;
    V_H[0] = V_H_tau_x;
    V_H[1] = V_H_tau_y;
    V_H[2] = V_H_tau_z;
    V_H[3] = V_H_f_x;
    V_H[4] = V_H_f_y;
    V_H[5] = V_H_f_z;
    eta_H[0] = eta_H_1;
    eta_H[1] = eta_H_2;
    eta_H[2] = eta_H_3;
    eta_H[3] = eta_H_4;
    eta_H[4] = eta_H_5;
    eta_H[5] = eta_H_6;
    eta_H[6] = f_eta[6];
    V_W[0] = V_W_tau_x;
    V_W[1] = V_W_tau_y;
    V_W[2] = V_W_tau_z;
    V_W[3] = V_W_f_x;
    V_W[4] = V_W_f_y;
    V_W[5] = V_W_f_z;
    eta_W[0] = eta_W_1;
    eta_W[1] = eta_W_2;
    eta_W[2] = eta_W_3;
    eta_W[3] = eta_W_4;
    eta_W[4] = eta_W_5;
    eta_W[5] = eta_W_6;
    eta_W[6] = eta_W_7;
    return ELLA_OK;
}

/* link rows, links like forearm: 839 operations */
ELLA_PART ella_status link_rows_forearm(const ella_link_constants *c, const ella_link_store *link,
    const ella_real m_eta[7], const ella_real f_eta[7], const ella_real w_ext[6], ella_real V_H[6], ella_real eta_H[7],
    ella_real V_W[6], ella_real eta_W[7], const int *place, ella_real *M)
{
    const ella_real t1 = link->h_eta[0] + f_eta[0];
    const ella_real t2 = link->h_eta[1] + f_eta[1];
    const ella_real t3 = link->h_eta[2] + f_eta[2];
    const ella_real t4 = link->h_eta[3] + f_eta[3];
    const ella_real t5 = link->h_eta[4] + f_eta[4];
    const ella_real t6 = link->h_eta[5] + f_eta[5];

    /* J_TV: twist of the tip section from that of F_i (46) */
    const ella_real J_TV_41 = link->R_T[6] * link->r_T[0] - link->R_T[3] * link->r_T[1];
    const ella_real J_TV_42 = link->R_T[0] * link->r_T[1] - link->R_T[6] * c->length;
    const ella_real J_TV_43 = link->R_T[3] * c->length - link->R_T[0] * link->r_T[0];
    const ella_real J_TV_51 = link->R_T[7] * link->r_T[0] - link->R_T[4] * link->r_T[1];
    const ella_real J_TV_52 = link->R_T[1] * link->r_T[1] - link->R_T[7] * c->length;
    const ella_real J_TV_53 = link->R_T[4] * c->length - link->R_T[1] * link->r_T[0];
    const ella_real J_TV_61 = link->R_T[8] * link->r_T[0] - link->R_T[5] * link->r_T[1];
    const ella_real J_TV_62 = link->R_T[2] * link->r_T[1] - link->R_T[8] * c->length;
    const ella_real J_TV_63 = link->R_T[5] * c->length - link->R_T[2] * link->r_T[0];

    /* J_Teta: twist of the tip section from the modal rates (46) */
    const ella_real t7 = link->J_l[2] * c->Psi_c_z1;
    const ella_real t8 = link->J_l[5] * c->Psi_c_z1;
    const ella_real t9 = link->J_l[8] * c->Psi_c_z1;
    const ella_real J_Teta_11 = link->R_T[0] * t7 + link->R_T[3] * t8 + link->R_T[6] * t9;
    const ella_real t10 = link->J_l[2] * c->Psi_c_z2;
    const ella_real t11 = link->J_l[5] * c->Psi_c_z2;
    const ella_real t12 = link->J_l[8] * c->Psi_c_z2;
    const ella_real J_Teta_12 = link->R_T[0] * t10 + link->R_T[3] * t11 + link->R_T[6] * t12;
    const ella_real t13 = link->J_l[2] * c->Psi_c_z3;
    const ella_real t14 = link->J_l[5] * c->Psi_c_z3;
    const ella_real t15 = link->J_l[8] * c->Psi_c_z3;
    const ella_real J_Teta_13 = link->R_T[0] * t13 + link->R_T[3] * t14 + link->R_T[6] * t15;
    const ella_real t16 = link->J_l[1] * c->Psi_c_y4;
    const ella_real t17 = link->J_l[4] * c->Psi_c_y4;
    const ella_real t18 = link->J_l[7] * c->Psi_c_y4;
    const ella_real J_Teta_14 = link->R_T[0] * t16 + link->R_T[3] * t17 + link->R_T[6] * t18;
    const ella_real t19 = link->J_l[1] * c->Psi_c_y5;
    const ella_real t20 = link->J_l[4] * c->Psi_c_y5;
    const ella_real t21 = link->J_l[7] * c->Psi_c_y5;
    const ella_real J_Teta_15 = link->R_T[0] * t19 + link->R_T[3] * t20 + link->R_T[6] * t21;
    const ella_real t22 = link->J_l[1] * c->Psi_c_y6;
    const ella_real t23 = link->J_l[4] * c->Psi_c_y6;
    const ella_real t24 = link->J_l[7] * c->Psi_c_y6;
    const ella_real J_Teta_16 = link->R_T[0] * t22 + link->R_T[3] * t23 + link->R_T[6] * t24;
    const ella_real t25 = link->J_l[0] * ELLA_REAL(1.7320508075688772);
    const ella_real t26 = link->J_l[3] * ELLA_REAL(1.7320508075688772);
    const ella_real t27 = link->J_l[6] * ELLA_REAL(1.7320508075688772);
    const ella_real J_Teta_17 = link->R_T[0] * t25 + link->R_T[3] * t26 + link->R_T[6] * t27;
    const ella_real J_Teta_21 = link->R_T[1] * t7 + link->R_T[4] * t8 + link->R_T[7] * t9;
    const ella_real J_Teta_22 = link->R_T[1] * t10 + link->R_T[4] * t11 + link->R_T[7] * t12;
    const ella_real J_Teta_23 = link->R_T[1] * t13 + link->R_T[4] * t14 + link->R_T[7] * t15;
    const ella_real J_Teta_24 = link->R_T[1] * t16 + link->R_T[4] * t17 + link->R_T[7] * t18;
    const ella_real J_Teta_25 = link->R_T[1] * t19 + link->R_T[4] * t20 + link->R_T[7] * t21;
    const ella_real J_Teta_26 = link->R_T[1] * t22 + link->R_T[4] * t23 + link->R_T[7] * t24;
    const ella_real J_Teta_27 = link->R_T[1] * t25 + link->R_T[4] * t26 + link->R_T[7] * t27;
    const ella_real J_Teta_31 = link->R_T[2] * t7 + link->R_T[5] * t8 + link->R_T[8] * t9;
    const ella_real J_Teta_32 = link->R_T[2] * t10 + link->R_T[5] * t11 + link->R_T[8] * t12;
    const ella_real J_Teta_33 = link->R_T[2] * t13 + link->R_T[5] * t14 + link->R_T[8] * t15;
    const ella_real J_Teta_34 = link->R_T[2] * t16 + link->R_T[5] * t17 + link->R_T[8] * t18;
    const ella_real J_Teta_35 = link->R_T[2] * t19 + link->R_T[5] * t20 + link->R_T[8] * t21;
    const ella_real J_Teta_36 = link->R_T[2] * t22 + link->R_T[5] * t23 + link->R_T[8] * t24;
    const ella_real J_Teta_37 = link->R_T[2] * t25 + link->R_T[5] * t26 + link->R_T[8] * t27;
    const ella_real J_Teta_41 = link->R_T[3] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_42 = link->R_T[3] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_43 = link->R_T[3] * ELLA_REAL(3.5651069283690613);
    const ella_real J_Teta_44 = link->R_T[6] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_45 = link->R_T[6] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_46 = link->R_T[6] * ELLA_REAL(3.5651069283690613);
    const ella_real J_Teta_51 = link->R_T[4] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_52 = link->R_T[4] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_53 = link->R_T[4] * ELLA_REAL(3.5651069283690613);
    const ella_real J_Teta_54 = link->R_T[7] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_55 = link->R_T[7] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_56 = link->R_T[7] * ELLA_REAL(3.5651069283690613);
    const ella_real J_Teta_61 = link->R_T[5] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_62 = link->R_T[5] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_63 = link->R_T[5] * ELLA_REAL(3.5651069283690613);
    const ella_real J_Teta_64 = link->R_T[8] * ELLA_REAL(2.0011941703010714);
    const ella_real J_Teta_65 = link->R_T[8] * ELLA_REAL(2.0700807911885764);
    const ella_real J_Teta_66 = link->R_T[8] * ELLA_REAL(3.5651069283690613);

    /* V_V: twist rows, twist columns (100) */
    const ella_real t28 = J_TV_41 * c->body0_mass;
    const ella_real t29 = J_TV_51 * c->body0_mass;
    const ella_real t30 = J_TV_61 * c->body0_mass;
    const ella_real V_V_11 = link->M_V[0] + J_TV_41 * t28 + J_TV_51 * t29 + J_TV_61 * t30;
    const ella_real V_V_12 = J_TV_42 * t28 - link->M_V[1] + J_TV_52 * t29 + J_TV_62 * t30;
    const ella_real V_V_13 = J_TV_43 * t28 - link->M_V[2] + J_TV_53 * t29 + J_TV_63 * t30;
    const ella_real V_V_14 = link->R_T[0] * t28 + link->R_T[1] * t29 + link->R_T[2] * t30;
    const ella_real V_V_15 = link->R_T[3] * t28 - link->M_V[3] + link->R_T[4] * t29 + link->R_T[5] * t30;
    const ella_real V_V_16 = link->M_V[4] + link->R_T[6] * t28 + link->R_T[7] * t29 + link->R_T[8] * t30;
    const ella_real t31 = J_TV_42 * c->body0_mass;
    const ella_real t32 = J_TV_52 * c->body0_mass;
    const ella_real t33 = J_TV_62 * c->body0_mass;
    const ella_real V_V_22 = link->M_V[5] + J_TV_42 * t31 + J_TV_52 * t32 + J_TV_62 * t33;
    const ella_real V_V_23 = J_TV_43 * t31 - link->M_V[6] + J_TV_53 * t32 + J_TV_63 * t33;
    const ella_real V_V_24 = link->M_V[3] + link->R_T[0] * t31 + link->R_T[1] * t32 + link->R_T[2] * t33;
    const ella_real V_V_25 = link->R_T[3] * t31 + link->R_T[4] * t32 + link->R_T[5] * t33;
    const ella_real V_V_26 = link->R_T[6] * t31 - c->S_0_x + link->R_T[7] * t32 + link->R_T[8] * t33;
    const ella_real t34 = J_TV_43 * c->body0_mass;
    const ella_real t35 = J_TV_53 * c->body0_mass;
    const ella_real t36 = J_TV_63 * c->body0_mass;
    const ella_real V_V_33 = link->M_V[7] + J_TV_43 * t34 + J_TV_53 * t35 + J_TV_63 * t36;
    const ella_real V_V_34 = link->R_T[0] * t34 - link->M_V[4] + link->R_T[1] * t35 + link->R_T[2] * t36;
    const ella_real V_V_35 = c->S_0_x + link->R_T[3] * t34 + link->R_T[4] * t35 + link->R_T[5] * t36;
    const ella_real V_V_36 = link->R_T[6] * t34 + link->R_T[7] * t35 + link->R_T[8] * t36;
    const ella_real t37 = c->body0_mass * link->R_T[0];
    const ella_real t38 = c->body0_mass * link->R_T[1];
    const ella_real t39 = c->body0_mass * link->R_T[2];
    const ella_real V_V_44 = c->mu + link->R_T[0] * t37 + link->R_T[1] * t38 + link->R_T[2] * t39;
    const ella_real V_V_45 = link->R_T[3] * t37 + link->R_T[4] * t38 + link->R_T[5] * t39;
    const ella_real V_V_46 = link->R_T[6] * t37 + link->R_T[7] * t38 + link->R_T[8] * t39;
    const ella_real t40 = c->body0_mass * link->R_T[3];
    const ella_real t41 = c->body0_mass * link->R_T[4];
    const ella_real t42 = c->body0_mass * link->R_T[5];
    const ella_real V_V_55 = c->mu + link->R_T[3] * t40 + link->R_T[4] * t41 + link->R_T[5] * t42;
    const ella_real V_V_56 = link->R_T[6] * t40 + link->R_T[7] * t41 + link->R_T[8] * t42;
    const ella_real t43 = c->body0_mass * link->R_T[6];
    const ella_real t44 = c->body0_mass * link->R_T[7];
    const ella_real t45 = c->body0_mass * link->R_T[8];
    const ella_real V_V_66 = c->mu + link->R_T[6] * t43 + link->R_T[7] * t44 + link->R_T[8] * t45;

    /* V_eta: twist rows, modal columns (100) */
    const ella_real V_eta_11 = J_Teta_41 * t28 - link->M_D[0] + J_Teta_51 * t29 + J_Teta_61 * t30;
    const ella_real V_eta_12 = J_Teta_42 * t28 - link->M_D[1] + J_Teta_52 * t29 + J_Teta_62 * t30;
    const ella_real V_eta_13 = J_Teta_43 * t28 - link->M_D[2] + J_Teta_53 * t29 + J_Teta_63 * t30;
    const ella_real V_eta_14 = link->M_D[3] + J_Teta_44 * t28 + J_Teta_54 * t29 + J_Teta_64 * t30;
    const ella_real V_eta_15 = link->M_D[4] + J_Teta_45 * t28 + J_Teta_55 * t29 + J_Teta_65 * t30;
    const ella_real V_eta_16 = link->M_D[5] + J_Teta_46 * t28 + J_Teta_56 * t29 + J_Teta_66 * t30;
    const ella_real V_eta_21 = J_Teta_41 * t31 + J_Teta_51 * t32 + J_Teta_61 * t33;
    const ella_real V_eta_22 = J_Teta_42 * t31 + J_Teta_52 * t32 + J_Teta_62 * t33;
    const ella_real V_eta_23 = J_Teta_43 * t31 + J_Teta_53 * t32 + J_Teta_63 * t33;
    const ella_real V_eta_24 = J_Teta_44 * t31 - c->chi_1 + J_Teta_54 * t32 + J_Teta_64 * t33;
    const ella_real V_eta_25 = J_Teta_45 * t31 - c->chi_2 + J_Teta_55 * t32 + J_Teta_65 * t33;
    const ella_real V_eta_26 = J_Teta_46 * t31 - c->chi_3 + J_Teta_56 * t32 + J_Teta_66 * t33;
    const ella_real V_eta_31 = c->chi_1 + J_Teta_41 * t34 + J_Teta_51 * t35 + J_Teta_61 * t36;
    const ella_real V_eta_32 = c->chi_2 + J_Teta_42 * t34 + J_Teta_52 * t35 + J_Teta_62 * t36;
    const ella_real V_eta_33 = c->chi_3 + J_Teta_43 * t34 + J_Teta_53 * t35 + J_Teta_63 * t36;
    const ella_real V_eta_34 = J_Teta_44 * t34 + J_Teta_54 * t35 + J_Teta_64 * t36;
    const ella_real V_eta_35 = J_Teta_45 * t34 + J_Teta_55 * t35 + J_Teta_65 * t36;
    const ella_real V_eta_36 = J_Teta_46 * t34 + J_Teta_56 * t35 + J_Teta_66 * t36;
    const ella_real V_eta_41 = J_Teta_41 * t37 + J_Teta_51 * t38 + J_Teta_61 * t39;
    const ella_real V_eta_42 = J_Teta_42 * t37 + J_Teta_52 * t38 + J_Teta_62 * t39;
    const ella_real V_eta_43 = J_Teta_43 * t37 + J_Teta_53 * t38 + J_Teta_63 * t39;
    const ella_real V_eta_44 = J_Teta_44 * t37 + J_Teta_54 * t38 + J_Teta_64 * t39;
    const ella_real V_eta_45 = J_Teta_45 * t37 + J_Teta_55 * t38 + J_Teta_65 * t39;
    const ella_real V_eta_46 = J_Teta_46 * t37 + J_Teta_56 * t38 + J_Teta_66 * t39;
    const ella_real V_eta_51 = c->sigma_y1 + J_Teta_41 * t40 + J_Teta_51 * t41 + J_Teta_61 * t42;
    const ella_real V_eta_52 = c->sigma_y2 + J_Teta_42 * t40 + J_Teta_52 * t41 + J_Teta_62 * t42;
    const ella_real V_eta_53 = c->sigma_y3 + J_Teta_43 * t40 + J_Teta_53 * t41 + J_Teta_63 * t42;
    const ella_real V_eta_54 = J_Teta_44 * t40 + J_Teta_54 * t41 + J_Teta_64 * t42;
    const ella_real V_eta_55 = J_Teta_45 * t40 + J_Teta_55 * t41 + J_Teta_65 * t42;
    const ella_real V_eta_56 = J_Teta_46 * t40 + J_Teta_56 * t41 + J_Teta_66 * t42;
    const ella_real V_eta_61 = J_Teta_41 * t43 + J_Teta_51 * t44 + J_Teta_61 * t45;
    const ella_real V_eta_62 = J_Teta_42 * t43 + J_Teta_52 * t44 + J_Teta_62 * t45;
    const ella_real V_eta_63 = J_Teta_43 * t43 + J_Teta_53 * t44 + J_Teta_63 * t45;
    const ella_real V_eta_64 = c->sigma_y1 + J_Teta_44 * t43 + J_Teta_54 * t44 + J_Teta_64 * t45;
    const ella_real V_eta_65 = c->sigma_y2 + J_Teta_45 * t43 + J_Teta_55 * t44 + J_Teta_65 * t45;
    const ella_real V_eta_66 = c->sigma_y3 + J_Teta_46 * t43 + J_Teta_56 * t44 + J_Teta_66 * t45;

    /* eta_eta: modal rows, modal columns (100) */
    const ella_real t46 = J_Teta_41 * c->body0_mass;
    const ella_real t47 = J_Teta_51 * c->body0_mass;
    const ella_real t48 = J_Teta_61 * c->body0_mass;
    const ella_real eta_eta_11 = m_eta[0] + J_Teta_41 * t46 + J_Teta_51 * t47 + J_Teta_61 * t48;
    const ella_real eta_eta_12 = J_Teta_42 * t46 + J_Teta_52 * t47 + J_Teta_62 * t48;
    const ella_real eta_eta_13 = J_Teta_43 * t46 + J_Teta_53 * t47 + J_Teta_63 * t48;
    const ella_real eta_eta_14 = J_Teta_44 * t46 + J_Teta_54 * t47 + J_Teta_64 * t48;
    const ella_real eta_eta_15 = J_Teta_45 * t46 + J_Teta_55 * t47 + J_Teta_65 * t48;
    const ella_real eta_eta_16 = J_Teta_46 * t46 + J_Teta_56 * t47 + J_Teta_66 * t48;
    const ella_real t49 = J_Teta_42 * c->body0_mass;
    const ella_real t50 = J_Teta_52 * c->body0_mass;
    const ella_real t51 = J_Teta_62 * c->body0_mass;
    const ella_real eta_eta_22 = m_eta[1] + J_Teta_42 * t49 + J_Teta_52 * t50 + J_Teta_62 * t51;
    const ella_real eta_eta_23 = J_Teta_43 * t49 + J_Teta_53 * t50 + J_Teta_63 * t51;
    const ella_real eta_eta_24 = J_Teta_44 * t49 + J_Teta_54 * t50 + J_Teta_64 * t51;
    const ella_real eta_eta_25 = J_Teta_45 * t49 + J_Teta_55 * t50 + J_Teta_65 * t51;
    const ella_real eta_eta_26 = J_Teta_46 * t49 + J_Teta_56 * t50 + J_Teta_66 * t51;
    const ella_real t52 = J_Teta_43 * c->body0_mass;
    const ella_real t53 = J_Teta_53 * c->body0_mass;
    const ella_real t54 = J_Teta_63 * c->body0_mass;
    const ella_real eta_eta_33 = m_eta[2] + J_Teta_43 * t52 + J_Teta_53 * t53 + J_Teta_63 * t54;
    const ella_real eta_eta_34 = J_Teta_44 * t52 + J_Teta_54 * t53 + J_Teta_64 * t54;
    const ella_real eta_eta_35 = J_Teta_45 * t52 + J_Teta_55 * t53 + J_Teta_65 * t54;
    const ella_real eta_eta_36 = J_Teta_46 * t52 + J_Teta_56 * t53 + J_Teta_66 * t54;
    const ella_real t55 = J_Teta_44 * c->body0_mass;
    const ella_real t56 = J_Teta_54 * c->body0_mass;
    const ella_real t57 = J_Teta_64 * c->body0_mass;
    const ella_real eta_eta_44 = m_eta[3] + J_Teta_44 * t55 + J_Teta_54 * t56 + J_Teta_64 * t57;
    const ella_real eta_eta_45 = J_Teta_45 * t55 + J_Teta_55 * t56 + J_Teta_65 * t57;
    const ella_real eta_eta_46 = J_Teta_46 * t55 + J_Teta_56 * t56 + J_Teta_66 * t57;
    const ella_real t58 = J_Teta_45 * c->body0_mass;
    const ella_real t59 = J_Teta_55 * c->body0_mass;
    const ella_real t60 = J_Teta_65 * c->body0_mass;
    const ella_real eta_eta_55 = m_eta[4] + J_Teta_45 * t58 + J_Teta_55 * t59 + J_Teta_65 * t60;
    const ella_real eta_eta_56 = J_Teta_46 * t58 + J_Teta_56 * t59 + J_Teta_66 * t60;
    const ella_real eta_eta_66 = m_eta[5] + J_Teta_46 * (J_Teta_46 * c->body0_mass)
        + J_Teta_56 * (J_Teta_56 * c->body0_mass) + J_Teta_66 * (J_Teta_66 * c->body0_mass);

    /* h_carried: bias of the bodies at the tip, its acceleration bias included */
    const ella_real h_carried_f_x = link->h_T[0] + c->body0_mass * link->b_T[3];
    const ella_real h_carried_f_y = link->h_T[1] + c->body0_mass * link->b_T[4];
    const ella_real h_carried_f_z = link->h_T[2] + c->body0_mass * link->b_T[5];

    /* V_H: bias of the twist rows (100) */
    const ella_real V_H_tau_x = link->h_V[0] + J_TV_41 * h_carried_f_x + J_TV_51 * h_carried_f_y
        + J_TV_61 * h_carried_f_z;
    const ella_real V_H_tau_y = link->h_V[1] + J_TV_42 * h_carried_f_x + J_TV_52 * h_carried_f_y
        + J_TV_62 * h_carried_f_z;
    const ella_real V_H_tau_z = link->h_V[2] + J_TV_43 * h_carried_f_x + J_TV_53 * h_carried_f_y
        + J_TV_63 * h_carried_f_z;
    const ella_real V_H_f_x = link->h_V[3] + link->R_T[0] * h_carried_f_x + link->R_T[1] * h_carried_f_y
        + link->R_T[2] * h_carried_f_z;
    const ella_real V_H_f_y = link->h_V[4] + link->R_T[3] * h_carried_f_x + link->R_T[4] * h_carried_f_y
        + link->R_T[5] * h_carried_f_z;
    const ella_real V_H_f_z = link->h_V[5] + link->R_T[6] * h_carried_f_x + link->R_T[7] * h_carried_f_y
        + link->R_T[8] * h_carried_f_z;

    /* eta_H: bias of the modal rows (100) */
    const ella_real eta_H_1 = t1 + J_Teta_41 * h_carried_f_x + J_Teta_51 * h_carried_f_y + J_Teta_61 * h_carried_f_z;
    const ella_real eta_H_2 = t2 + J_Teta_42 * h_carried_f_x + J_Teta_52 * h_carried_f_y + J_Teta_62 * h_carried_f_z;
    const ella_real eta_H_3 = t3 + J_Teta_43 * h_carried_f_x + J_Teta_53 * h_carried_f_y + J_Teta_63 * h_carried_f_z;
    const ella_real eta_H_4 = t4 + J_Teta_44 * h_carried_f_x + J_Teta_54 * h_carried_f_y + J_Teta_64 * h_carried_f_z;
    const ella_real eta_H_5 = t5 + J_Teta_45 * h_carried_f_x + J_Teta_55 * h_carried_f_y + J_Teta_65 * h_carried_f_z;
    const ella_real eta_H_6 = t6 + J_Teta_46 * h_carried_f_x + J_Teta_56 * h_carried_f_y + J_Teta_66 * h_carried_f_z;

    /* V_W: external wrench in the twist rows (100) */
    const ella_real t61 = J_TV_41 * w_ext[3] + J_TV_51 * w_ext[4] + J_TV_61 * w_ext[5] + link->R_T[0] * w_ext[0]
        + link->R_T[1] * w_ext[1];
    const ella_real V_W_tau_x = t61 + link->R_T[2] * w_ext[2];
    const ella_real t62 = J_TV_42 * w_ext[3] + J_TV_52 * w_ext[4] + J_TV_62 * w_ext[5] + link->R_T[3] * w_ext[0]
        + link->R_T[4] * w_ext[1];
    const ella_real V_W_tau_y = t62 + link->R_T[5] * w_ext[2];
    const ella_real t63 = J_TV_43 * w_ext[3] + J_TV_53 * w_ext[4] + J_TV_63 * w_ext[5] + link->R_T[6] * w_ext[0]
        + link->R_T[7] * w_ext[1];
    const ella_real V_W_tau_z = t63 + link->R_T[8] * w_ext[2];
    const ella_real V_W_f_x = link->R_T[0] * w_ext[3] + link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5];
    const ella_real V_W_f_y = link->R_T[3] * w_ext[3] + link->R_T[4] * w_ext[4] + link->R_T[5] * w_ext[5];
    const ella_real V_W_f_z = link->R_T[6] * w_ext[3] + link->R_T[7] * w_ext[4] + link->R_T[8] * w_ext[5];

    /* eta_W: external wrench in the modal rows (100) */
    const ella_real t64 = J_Teta_11 * w_ext[0] + J_Teta_21 * w_ext[1] + J_Teta_31 * w_ext[2] + J_Teta_41 * w_ext[3]
        + J_Teta_51 * w_ext[4];
    const ella_real eta_W_1 = t64 + J_Teta_61 * w_ext[5];
    const ella_real t65 = J_Teta_12 * w_ext[0] + J_Teta_22 * w_ext[1] + J_Teta_32 * w_ext[2] + J_Teta_42 * w_ext[3]
        + J_Teta_52 * w_ext[4];
    const ella_real eta_W_2 = t65 + J_Teta_62 * w_ext[5];
    const ella_real t66 = J_Teta_13 * w_ext[0] + J_Teta_23 * w_ext[1] + J_Teta_33 * w_ext[2] + J_Teta_43 * w_ext[3]
        + J_Teta_53 * w_ext[4];
    const ella_real eta_W_3 = t66 + J_Teta_63 * w_ext[5];
    const ella_real t67 = J_Teta_14 * w_ext[0] + J_Teta_24 * w_ext[1] + J_Teta_34 * w_ext[2] + J_Teta_44 * w_ext[3]
        + J_Teta_54 * w_ext[4];
    const ella_real eta_W_4 = t67 + J_Teta_64 * w_ext[5];
    const ella_real t68 = J_Teta_15 * w_ext[0] + J_Teta_25 * w_ext[1] + J_Teta_35 * w_ext[2] + J_Teta_45 * w_ext[3]
        + J_Teta_55 * w_ext[4];
    const ella_real eta_W_5 = t68 + J_Teta_65 * w_ext[5];
    const ella_real t69 = J_Teta_16 * w_ext[0] + J_Teta_26 * w_ext[1] + J_Teta_36 * w_ext[2] + J_Teta_46 * w_ext[3]
        + J_Teta_56 * w_ext[4];
    const ella_real eta_W_6 = t69 + J_Teta_66 * w_ext[5];
    const ella_real eta_W_7 = J_Teta_17 * w_ext[0] + J_Teta_27 * w_ext[1] + J_Teta_37 * w_ext[2];

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
    M[place[51]] = V_eta_14;
    M[place[52]] = V_eta_15;
    M[place[53]] = V_eta_16;
    M[place[54]] = c->sigma_t_7;
    M[place[55]] = V_eta_21;
    M[place[56]] = V_eta_22;
    M[place[57]] = V_eta_23;
    M[place[58]] = V_eta_24;
    M[place[59]] = V_eta_25;
    M[place[60]] = V_eta_26;
    M[place[61]] = V_eta_31;
    M[place[62]] = V_eta_32;
    M[place[63]] = V_eta_33;
    M[place[64]] = V_eta_34;
    M[place[65]] = V_eta_35;
    M[place[66]] = V_eta_36;
    M[place[67]] = V_eta_41;
    M[place[68]] = V_eta_42;
    M[place[69]] = V_eta_43;
    M[place[70]] = V_eta_44;
    M[place[71]] = V_eta_45;
    M[place[72]] = V_eta_46;
    M[place[73]] = V_eta_51;
    M[place[74]] = V_eta_52;
    M[place[75]] = V_eta_53;
    M[place[76]] = V_eta_54;
    M[place[77]] = V_eta_55;
    M[place[78]] = V_eta_56;
    M[place[79]] = V_eta_61;
    M[place[80]] = V_eta_62;
    M[place[81]] = V_eta_63;
    M[place[82]] = V_eta_64;
    M[place[83]] = V_eta_65;
    M[place[84]] = V_eta_66;
    M[place[85]] = V_eta_11;
    M[place[86]] = V_eta_21;
    M[place[87]] = V_eta_31;
    M[place[88]] = V_eta_41;
    M[place[89]] = V_eta_51;
    M[place[90]] = V_eta_61;
    M[place[91]] = V_eta_12;
    M[place[92]] = V_eta_22;
    M[place[93]] = V_eta_32;
    M[place[94]] = V_eta_42;
    M[place[95]] = V_eta_52;
    M[place[96]] = V_eta_62;
    M[place[97]] = V_eta_13;
    M[place[98]] = V_eta_23;
    M[place[99]] = V_eta_33;
    M[place[100]] = V_eta_43;
    M[place[101]] = V_eta_53;
    M[place[102]] = V_eta_63;
    M[place[103]] = V_eta_14;
    M[place[104]] = V_eta_24;
    M[place[105]] = V_eta_34;
    M[place[106]] = V_eta_44;
    M[place[107]] = V_eta_54;
    M[place[108]] = V_eta_64;
    M[place[109]] = V_eta_15;
    M[place[110]] = V_eta_25;
    M[place[111]] = V_eta_35;
    M[place[112]] = V_eta_45;
    M[place[113]] = V_eta_55;
    M[place[114]] = V_eta_65;
    M[place[115]] = V_eta_16;
    M[place[116]] = V_eta_26;
    M[place[117]] = V_eta_36;
    M[place[118]] = V_eta_46;
    M[place[119]] = V_eta_56;
    M[place[120]] = V_eta_66;
    M[place[121]] = c->sigma_t_7;
    M[place[122]] = eta_eta_11;
    M[place[123]] = eta_eta_12;
    M[place[124]] = eta_eta_13;
    M[place[125]] = eta_eta_14;
    M[place[126]] = eta_eta_15;
    M[place[127]] = eta_eta_16;
    M[place[128]] = eta_eta_12;
    M[place[129]] = eta_eta_22;
    M[place[130]] = eta_eta_23;
    M[place[131]] = eta_eta_24;
    M[place[132]] = eta_eta_25;
    M[place[133]] = eta_eta_26;
    M[place[134]] = eta_eta_13;
    M[place[135]] = eta_eta_23;
    M[place[136]] = eta_eta_33;
    M[place[137]] = eta_eta_34;
    M[place[138]] = eta_eta_35;
    M[place[139]] = eta_eta_36;
    M[place[140]] = eta_eta_14;
    M[place[141]] = eta_eta_24;
    M[place[142]] = eta_eta_34;
    M[place[143]] = eta_eta_44;
    M[place[144]] = eta_eta_45;
    M[place[145]] = eta_eta_46;
    M[place[146]] = eta_eta_15;
    M[place[147]] = eta_eta_25;
    M[place[148]] = eta_eta_35;
    M[place[149]] = eta_eta_45;
    M[place[150]] = eta_eta_55;
    M[place[151]] = eta_eta_56;
    M[place[152]] = eta_eta_16;
    M[place[153]] = eta_eta_26;
    M[place[154]] = eta_eta_36;
    M[place[155]] = eta_eta_46;
    M[place[156]] = eta_eta_56;
    M[place[157]] = eta_eta_66;
    M[place[158]] = m_eta[6];
    V_H[0] = V_H_tau_x;
    V_H[1] = V_H_tau_y;
    V_H[2] = V_H_tau_z;
    V_H[3] = V_H_f_x;
    V_H[4] = V_H_f_y;
    V_H[5] = V_H_f_z;
    eta_H[0] = eta_H_1;
    eta_H[1] = eta_H_2;
    eta_H[2] = eta_H_3;
    eta_H[3] = eta_H_4;
    eta_H[4] = eta_H_5;
    eta_H[5] = eta_H_6;
    eta_H[6] = f_eta[6];
    V_W[0] = V_W_tau_x;
    V_W[1] = V_W_tau_y;
    V_W[2] = V_W_tau_z;
    V_W[3] = V_W_f_x;
    V_W[4] = V_W_f_y;
    V_W[5] = V_W_f_z;
    eta_W[0] = eta_W_1;
    eta_W[1] = eta_W_2;
    eta_W[2] = eta_W_3;
    eta_W[3] = eta_W_4;
    eta_W[4] = eta_W_5;
    eta_W[5] = eta_W_6;
    eta_W[6] = eta_W_7;
    return ELLA_OK;
}

static ELLA_TARGETS ella_status dae_dynamics_dae_kinematics(const ella_constants *c, const ella_call *call,
    ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return dae_kinematics_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->new_qdot + q);
    default:
        return dae_kinematics_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->new_qdot + q);
    }
}

static ELLA_TARGETS ella_status dae_dynamics_eliminate(const ella_constants *c, const ella_call *call,
    ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return eliminate_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->eta + e,
            call->etadot + e, call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->tau + q);
    default:
        return eliminate_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->eta + e,
            call->etadot + e, call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->tau + q);
    }
}

static ELLA_TARGETS ella_status dae_dynamics_accelerate(const ella_constants *c, const ella_call *call,
    ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return accelerate_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->new_qddot + q,
            call->new_wrench ? call->new_wrench + 6 * i : 0, call->new_alpha + 6 * i, call->new_etaddot + e);
    default:
        return accelerate_forearm(&chain->links[i], &chain->nodes[i], call->new_qddot + q,
            call->new_wrench ? call->new_wrench + 6 * i : 0, call->new_alpha + 6 * i, call->new_etaddot + e);
    }
}

static ELLA_TARGETS ella_status dae_dynamics_twist_rates(const ella_constants *c, const ella_call *call,
    ella_chain *chain, int i)
{
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    return twist_rates_upper_arm(call->quaternion + 4 * i, call->gravity, call->alpha + 6 * i, call->twist + 6 * i,
        call->new_Vdot + 6 * i);
}

static ELLA_TARGETS ella_status projection_project(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return project_upper_arm(&c->links[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->eta + e,
            call->etadot + e, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i,
            call->new_quaternion + 4 * i, call->new_position + 3 * i);
    default:
        return project_forearm(&chain->nodes[i], call->q + q, call->twist + 6 * i, call->quaternion + 4 * i,
            call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    }
}

static ELLA_TARGETS ella_status placement_forward_kinematics(const ella_constants *c, const ella_call *call,
    ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return forward_kinematics_upper_arm(&c->links[i], &chain->nodes[i + 1], call->q + q, call->qdot + q,
            call->eta + e, call->etadot + e, call->new_twist + 6 * i, call->new_quaternion + 4 * i,
            call->new_position + 3 * i);
    default:
        return forward_kinematics_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q, call->eta + e, call->new_twist + 6 * i, call->new_quaternion + 4 * i,
            call->new_position + 3 * i);
    }
}

static ELLA_TARGETS ella_status inverse_kinematics(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return kinematics_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q, call->eta + e, call->etadot + e);
    default:
        return kinematics_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q, call->eta + e, call->etadot + e);
    }
}

static ELLA_TARGETS ella_status inverse_inverse_outward(const ella_constants *c, const ella_call *call,
    ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_outward_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->qddot + q,
            call->etaddot + e);
    default:
        return inverse_outward_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->etaddot + e);
    }
}

static ELLA_TARGETS ella_status inverse_inverse_inward(const ella_constants *c, const ella_call *call,
    ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_inward_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->etaddot + e,
            call->eta + e, call->etadot + e, call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e,
            call->new_force_eta + e, call->new_force + q, call->new_wrench ? call->new_wrench + 6 * i : 0);
    default:
        return inverse_inward_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->etaddot + e, call->eta + e, call->etadot + e, call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e,
            call->new_force_eta + e, call->new_force + q, call->new_wrench ? call->new_wrench + 6 * i : 0);
    }
}

static ELLA_TARGETS ella_status inertia_kinematics(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return kinematics_upper_arm_2(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->q + q, call->eta + e);
    default:
        return kinematics_forearm_2(&chain->links[i], &chain->nodes[i], call->q + q, call->eta + e);
    }
}

static ELLA_TARGETS ella_status inertia_inverse_outward(const ella_constants *c, const ella_call *call,
    ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_outward_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->qddot + q,
            call->etaddot + e);
    default:
        return inverse_outward_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->etaddot + e);
    }
}

static ELLA_TARGETS ella_status inertia_inverse_inward(const ella_constants *c, const ella_call *call,
    ella_chain *chain, int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_inward_upper_arm_2(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->etaddot + e,
            call->eta + e, call->m_eta + e, call->new_force_eta + e, call->new_force + q);
    default:
        return inverse_inward_forearm_2(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->etaddot + e, call->eta + e, call->m_eta + e, call->new_force_eta + e, call->new_force + q);
    }
}

static ELLA_TARGETS ella_status motion_of_velocities(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return velocities_upper_arm(&c->links[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->eta + e,
            call->etadot + e);
    default:
        return velocities_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q,
            call->eta + e, call->etadot + e);
    }
}

static ELLA_TARGETS ella_status motion_of_poses(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return poses_upper_arm(&c->links[i], &chain->nodes[i + 1], call->q + q, call->eta + e, call->new_R + 9 * i,
            call->new_r + 3 * i);
    default:
        return poses_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->eta + e,
            call->new_R + 9 * i, call->new_r + 3 * i);
    }
}

static ELLA_TARGETS ella_status motion_of_tip_twist(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int i)
{
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    return tip_twist_upper_arm(&chain->nodes[i + 1], call->new_tip_twist + 6 * i);
}

static ELLA_TARGETS ella_status measuring_measure(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int i)
{
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    return measure_upper_arm(&c->links[i], call->eta + e, call->motion + 4 * i, call->wrench + 6 * i,
        call->new_measures + 4 * i);
}

static ELLA_TARGETS ella_status assembly_joint_rows(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return joint_rows_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->twist + 6 * i,
            call->q + q, call->quaternion + 4 * i, call->gravity, call->eta + e, call->etadot + e, call->tau + q,
            call->H + 12 * i, call->W + 12 * i, M_PLACE + M_OFFSET[i], call->M);
    default:
        return joint_rows_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], call->twist + 6 * i, call->q + q,
            call->quaternion + 4 * i, call->gravity, call->eta + e, call->etadot + e, call->tau + q, call->H + 12 * i,
            call->W + 12 * i, M_PLACE + M_OFFSET[i], call->M);
    }
}

static ELLA_TARGETS ella_status assembly_link_rows(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int i)
{
    static const int CLASS[ELLA_NLINKS] = { 0, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return link_rows_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->m_eta + e,
            call->f_eta + e, call->w_ext + 6 * i, call->H + 12 * i + 6, call->H + 12 * ELLA_NLINKS + e,
            call->W + 12 * i + 6, call->W + 12 * ELLA_NLINKS + e, M_PLACE + M_OFFSET[i], call->M);
    default:
        return link_rows_forearm(&c->links[i], &chain->links[i], call->m_eta + e, call->f_eta + e, call->w_ext + 6 * i,
            call->H + 12 * i + 6, call->H + 12 * ELLA_NLINKS + e, call->W + 12 * i + 6, call->W + 12 * ELLA_NLINKS + e,
            M_PLACE + M_OFFSET[i], call->M);
    }
}

/* The base is at rest; in place of gravity on the links it accelerates by -g. */
static void start(const ella_call *call, ella_chain *chain)
{
    int k;
    for (k = 0; k < 3; ++k) {
        chain->nodes[0].acc_0[k + 3] = -call->gravity[k];
    }
}

ELLA_TARGETS ella_status ella_dae_dynamics(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int *fault)
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

ELLA_TARGETS ella_status ella_inertia_posture(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int *fault)
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

ELLA_TARGETS ella_status ella_inertia_column(const ella_constants *c, const ella_call *call, ella_chain *chain,
    int *fault)
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

ELLA_TARGETS ella_status ella_motion_of(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = motion_of_velocities(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = motion_of_poses(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = motion_of_tip_twist(c, call, chain, i);
        if (status != ELLA_OK) {
            *fault = i;
            return status;
        }
    }
    return ELLA_OK;
}

ELLA_TARGETS ella_status ella_measuring(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault)
{
    ella_status status;
    int i;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        status = measuring_measure(c, call, chain, i);
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
