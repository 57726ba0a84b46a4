/* six_link_links.c: the phases of the algorithms for each class of links, and the loops over the links.
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
#include "six_link_links.h"

static const int Q_OFFSET[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
static const int ETA_OFFSET[SIX_LINK_NLINKS] = { 0, 0, 5, 9, 9, 9 };

/* The places, among the structural nonzeros, of the entries of M_sys that each link computes. */
static const int M_PLACE[SIX_LINK_NNZ] = {
    2, 7, 18, 27, 38, 44, 49, 13, 33, 24, 14, 34, 15, 25, 35, 42, 53, 16, 36, 48,
    17, 26, 37, 43, 54, 0, 1, 3, 4, 5, 6, 8, 19, 28, 45, 50, 9, 20, 29, 39,
    51, 10, 21, 30, 40, 46, 22, 31, 41, 11, 32, 47, 12, 23, 52, 55, 61, 64, 70, 74,
    58, 65, 75, 56, 62, 66, 71, 76, 67, 77, 72, 68, 78, 59, 80, 98, 116, 134, 149, 164,
    87, 105, 123, 88, 106, 124, 89, 107, 125, 90, 108, 126, 141, 156, 171, 91, 109, 127, 142, 157,
    172, 92, 110, 128, 143, 158, 173, 506, 523, 540, 557, 574, 507, 524, 541, 558, 575, 508, 525, 542,
    559, 576, 509, 526, 543, 560, 577, 510, 527, 544, 561, 578, 511, 528, 545, 562, 579, 57, 60, 63,
    69, 73, 79, 81, 99, 117, 135, 150, 165, 82, 100, 118, 136, 151, 166, 83, 101, 119, 137, 152,
    167, 84, 102, 120, 138, 153, 168, 85, 103, 121, 139, 154, 169, 86, 104, 122, 140, 155, 170, 500,
    517, 534, 551, 568, 501, 518, 535, 552, 569, 502, 519, 536, 553, 570, 503, 520, 537, 554, 571, 504,
    521, 538, 555, 572, 505, 522, 539, 556, 573, 179, 188, 198, 207, 219, 231, 180, 189, 199, 208, 220,
    232, 181, 190, 200, 209, 221, 233, 210, 222, 234, 211, 223, 235, 212, 224, 236, 93, 111, 129, 144,
    159, 174, 94, 112, 130, 145, 160, 175, 95, 113, 131, 146, 161, 176, 96, 114, 132, 147, 162, 177,
    97, 115, 133, 148, 163, 178, 512, 529, 546, 563, 580, 513, 530, 547, 564, 581, 514, 531, 548, 565,
    582, 515, 532, 549, 566, 583, 516, 533, 550, 567, 584, 183, 193, 202, 214, 226, 238, 184, 194, 203,
    215, 227, 239, 185, 195, 204, 216, 228, 240, 186, 196, 205, 217, 229, 241, 187, 197, 206, 218, 230,
    242, 191, 243, 259, 273, 287, 294, 303, 249, 265, 279, 250, 266, 280, 251, 267, 281, 252, 268, 282,
    291, 298, 307, 253, 269, 283, 292, 299, 308, 254, 270, 284, 293, 300, 309, 588, 598, 608, 618, 589,
    599, 609, 619, 590, 600, 610, 620, 591, 601, 611, 621, 592, 602, 612, 622, 593, 603, 613, 623, 182,
    192, 201, 213, 225, 237, 244, 260, 274, 295, 304, 245, 261, 275, 288, 305, 246, 262, 276, 289, 296,
    263, 277, 290, 247, 278, 297, 248, 264, 306, 585, 595, 605, 615, 606, 616, 586, 596, 587, 597, 607,
    617, 312, 321, 329, 337, 348, 359, 313, 322, 330, 338, 349, 360, 314, 323, 331, 339, 350, 361, 340,
    351, 362, 341, 352, 363, 342, 353, 364, 255, 285, 301, 256, 286, 302, 257, 271, 310, 258, 272, 311,
    594, 604, 614, 624, 317, 325, 333, 344, 355, 366, 318, 326, 334, 345, 356, 367, 319, 327, 335, 346,
    357, 368, 320, 328, 336, 347, 358, 369, 315, 370, 374, 380, 386, 390, 394, 372, 383, 377, 373, 384,
    378, 388, 397, 385, 393, 379, 389, 398, 316, 324, 332, 343, 354, 365, 371, 375, 395, 381, 391, 387,
    382, 392, 376, 396, 399, 405, 402, 408, 415, 400, 406, 412, 409, 416, 413, 410, 417, 403, 419, 422,
    429, 436, 439, 444, 421, 425, 432, 426, 433, 438, 427, 434, 442, 447, 428, 435, 443, 448, 401, 404,
    407, 411, 414, 418, 420, 423, 445, 430, 440, 437, 431, 441, 424, 446, 449, 452, 455, 460, 465, 453,
    456, 461, 466, 458, 462, 467, 463, 468, 450, 470, 476, 482, 488, 492, 496, 451, 454, 457, 459, 464,
    469, 471, 477, 483, 493, 497, 472, 478, 484, 489, 498, 473, 479, 485, 490, 494, 480, 486, 491, 474,
    487, 495, 475, 481, 499,
};
static const int M_OFFSET[SIX_LINK_NLINKS] = { 0, 73, 321, 488, 537, 588 };

/* dae kinematics, links like shoulder: 11 operations */
SIX_LINK_PART six_link_status dae_kinematics_shoulder(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, const six_link_node *restrict base, six_link_node *restrict tip,
    const six_link_real q[restrict 1], const six_link_real twist[restrict 6], six_link_real qdot[restrict 1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real a_J_x = R_rel_xx * base->acc_0[3] + R_rel_yx * base->acc_0[4];
    link->acc_0[3] = a_J_x;
    const six_link_real a_J_y = R_rel_xx * base->acc_0[4] - R_rel_yx * base->acc_0[3];
    link->acc_0[4] = a_J_y;
    tip->acc_0[4] = a_J_y;

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real a_t_x = a_J_x - c->length * (twist[2] * twist[2]);
    tip->acc_0[3] = a_t_x;

    /* outputs */
    qdot[0] = twist[2];
    link->omega[2] = twist[2];
    link->acc_0[5] = base->acc_0[5];
    tip->omega[2] = twist[2];
    tip->acc_0[5] = base->acc_0[5];
    return SIX_LINK_OK;
}

/* dae kinematics, links like upper_arm: 234 operations */
SIX_LINK_PART six_link_status dae_kinematics_upper_arm(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, const six_link_node *restrict base, six_link_node *restrict tip,
    const six_link_real q[restrict 1], const six_link_real twist[restrict 6], const six_link_real eta[restrict 5],
    const six_link_real etadot[restrict 5], six_link_real qdot[restrict 1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;
    link->R_P[2] = R_rel_xz;
    link->R_P[6] = -R_rel_xz;
    link->R_P[0] = R_rel_xx;
    link->R_P[8] = R_rel_xx;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real minus_omega_R_x = R_rel_xz * base->omega[2];
    link->omega[0] = -minus_omega_R_x;
    const six_link_real omega_R_z = R_rel_xx * base->omega[2];
    link->omega[2] = omega_R_z;

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real t1 = R_rel_xx * base->acc_0[3] - R_rel_xz * base->acc_0[5];
    const six_link_real t2 = R_rel_xz * base->acc_0[3] + R_rel_xx * base->acc_0[5];

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real minus_alpha_x = omega_R_z * twist[1];
    link->acc_0[0] = -minus_alpha_x;
    const six_link_real minus_alpha_z = minus_omega_R_x * twist[1];
    link->acc_0[2] = -minus_alpha_z;

    /* r_R: joint point relative to the parent's tip point */
    const six_link_real r_R_x = R_rel_xx * c->mount_xyz_x - R_rel_xz * c->mount_xyz_z;
    link->lever[0] = r_R_x;
    const six_link_real r_R_z = R_rel_xz * c->mount_xyz_x + R_rel_xx * c->mount_xyz_z;
    link->lever[1] = r_R_z;

    /* a_J: acceleration of the joint point while no joint accelerates (accconst4) */
    const six_link_real t3 = omega_R_z * r_R_x + minus_omega_R_x * r_R_z;
    const six_link_real a_J_x = t1 - omega_R_z * t3;
    link->acc_0[3] = a_J_x;
    const six_link_real a_J_y = base->acc_0[4] - omega_R_z * (c->mount_xyz_y * omega_R_z)
        - minus_omega_R_x * (c->mount_xyz_y * minus_omega_R_x);
    link->acc_0[4] = a_J_y;
    const six_link_real a_J_z = t2 - minus_omega_R_x * t3;
    link->acc_0[5] = a_J_z;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    link->r_T[0] = r_T_y;
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);
    link->r_T[1] = r_T_z;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real t4 = theta_x * theta_x;
    const six_link_real t5 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t4 + t5;
    const six_link_real t6 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t6;

    /* c2: Stumpff function of order 2 */
    const six_link_real t7 = six_link_c4(x);
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * t7;

    /* c3: Stumpff function of order 3 */
    const six_link_real t8 = six_link_c5(x);
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * t8;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_x = etadot[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t9 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real t10 = theta_x * thetadot_y - theta_y * thetadot_x;
    const six_link_real t11 = theta_z * thetadot_x - theta_x * thetadot_z;
    const six_link_real t12 = theta_y * t10 - theta_z * t11;
    const six_link_real omega_s_x = thetadot_x + c2 * t9 + c3 * t12;
    const six_link_real t13 = theta_z * t9 - theta_x * t10;
    const six_link_real omega_s_y = thetadot_y + c2 * t11 + c3 * t13;
    const six_link_real t14 = theta_x * t11 - theta_y * t9;
    const six_link_real omega_s_z = thetadot_z + c2 * t10 + c3 * t14;

    /* xdot: rate of the squared angle */
    const six_link_real xdot = eta[4] * SIX_LINK_REAL(3.4641016151377544) * thetadot_x + theta_y * 2 * thetadot_y
        + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const six_link_real c2dot = xdot * (t7 - c3 * SIX_LINK_REAL(0.5));

    /* c3dot: rate of c3 */
    const six_link_real c3dot = xdot * (t8 * SIX_LINK_REAL(1.5) - t7 * SIX_LINK_REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_x = c2dot * t9 + c3 * (thetadot_y * t10 - thetadot_z * t11) + c3dot * t12;
    const six_link_real alpha_s_y = c2dot * t11 + c3 * (thetadot_z * t9 - thetadot_x * t10) + c3dot * t13;
    const six_link_real alpha_s_z = c2dot * t10 + c3 * (thetadot_x * t11 - thetadot_y * t9) + c3dot * t14;

    /* omega_t: angular velocity of the tip section (46) */
    const six_link_real omega_t_x = omega_s_x - minus_omega_R_x;
    tip->omega[0] = omega_t_x;
    const six_link_real omega_t_y = omega_s_y + twist[1];
    tip->omega[1] = omega_t_y;
    const six_link_real omega_t_z = omega_s_z + omega_R_z;
    tip->omega[2] = omega_t_z;

    /* alpha_t: angular acceleration of the tip section (accconst1b) */
    const six_link_real alpha_t_x = alpha_s_x - minus_alpha_x + omega_s_z * twist[1] - omega_s_y * omega_R_z;
    tip->acc_0[0] = alpha_t_x;
    const six_link_real alpha_t_y = alpha_s_y + omega_s_x * omega_R_z + omega_s_z * minus_omega_R_x;
    tip->acc_0[1] = alpha_t_y;
    const six_link_real alpha_t_z = alpha_s_z - minus_alpha_z - omega_s_y * minus_omega_R_x - omega_s_x * twist[1];
    tip->acc_0[2] = alpha_t_z;

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t15 = udot_T_z * 2 - minus_omega_R_x * r_T_y - c->length * twist[1];
    const six_link_real t16 = udot_T_y * 2 + c->length * omega_R_z + minus_omega_R_x * r_T_z;
    const six_link_real a_t_x = a_J_x + twist[1] * t15 + minus_alpha_z * r_T_y - omega_R_z * t16;
    tip->acc_0[3] = a_t_x;
    const six_link_real t17 = twist[1] * r_T_z - omega_R_z * r_T_y;
    const six_link_real a_t_y = a_J_y - minus_alpha_z * c->length + omega_R_z * t17 + minus_alpha_x * r_T_z
        + minus_omega_R_x * t15;
    tip->acc_0[4] = a_t_y;
    const six_link_real a_t_z = a_J_z - minus_alpha_x * r_T_y - minus_omega_R_x * t16 - twist[1] * t17;
    tip->acc_0[5] = a_t_z;

    /* c1: Stumpff function of order 1 */
    const six_link_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t5 + t6;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t4 + t6;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    link->J_l[0] = J_l_xx;
    const six_link_real t18 = c3 * theta_hat2_12;
    const six_link_real t19 = c2 * theta_z;
    const six_link_real J_l_xy = t18 - t19;
    link->J_l[1] = J_l_xy;
    const six_link_real t20 = c2 * theta_y;
    const six_link_real t21 = c3 * theta_hat2_13;
    const six_link_real J_l_xz = t20 + t21;
    link->J_l[2] = J_l_xz;
    const six_link_real J_l_yx = t19 + t18;
    link->J_l[3] = J_l_yx;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    link->J_l[4] = J_l_yy;
    const six_link_real t22 = c3 * theta_hat2_23;
    const six_link_real t23 = c2 * theta_x;
    const six_link_real J_l_yz = t22 - t23;
    link->J_l[5] = J_l_yz;
    const six_link_real J_l_zx = t21 - t20;
    link->J_l[6] = J_l_zx;
    const six_link_real J_l_zy = t23 + t22;
    link->J_l[7] = J_l_zy;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;
    link->J_l[8] = J_l_zz;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    link->R_T[0] = R_T_xx;
    tip->R_T[0] = R_T_xx;
    const six_link_real t24 = c2 * theta_hat2_12;
    const six_link_real t25 = c1 * theta_z;
    const six_link_real R_T_xy = t24 - t25;
    link->R_T[1] = R_T_xy;
    tip->R_T[1] = R_T_xy;
    const six_link_real t26 = c1 * theta_y;
    const six_link_real t27 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t26 + t27;
    link->R_T[2] = R_T_xz;
    tip->R_T[2] = R_T_xz;
    const six_link_real R_T_yx = t25 + t24;
    link->R_T[3] = R_T_yx;
    tip->R_T[3] = R_T_yx;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    link->R_T[4] = R_T_yy;
    tip->R_T[4] = R_T_yy;
    const six_link_real t28 = c2 * theta_hat2_23;
    const six_link_real t29 = c1 * theta_x;
    const six_link_real R_T_yz = t28 - t29;
    link->R_T[5] = R_T_yz;
    tip->R_T[5] = R_T_yz;
    const six_link_real R_T_zx = t27 - t26;
    link->R_T[6] = R_T_zx;
    tip->R_T[6] = R_T_zx;
    const six_link_real R_T_zy = t29 + t28;
    link->R_T[7] = R_T_zy;
    tip->R_T[7] = R_T_zy;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;
    link->R_T[8] = R_T_zz;
    tip->R_T[8] = R_T_zz;

    /* outputs */
    qdot[0] = twist[1];
    link->omega[1] = twist[1];
    return SIX_LINK_OK;
}

/* dae kinematics, links like forearm: 305 operations */
SIX_LINK_PART six_link_status dae_kinematics_forearm(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, const six_link_node *restrict base, six_link_node *restrict tip,
    const six_link_real q[restrict 1], const six_link_real twist[restrict 6], const six_link_real eta[restrict 4],
    const six_link_real etadot[restrict 4], six_link_real qdot[restrict 1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real t1 = turn.sine, t2 = turn.cosine;
    const six_link_real R_rel_xx = c->R_m_xx * t2 - c->R_m_xz * t1;
    const six_link_real R_rel_xz = c->R_m_xx * t1 + c->R_m_xz * t2;
    const six_link_real R_rel_yx = c->R_m_yx * t2 - c->R_m_yz * t1;
    const six_link_real R_rel_yz = c->R_m_yx * t1 + c->R_m_yz * t2;
    const six_link_real R_rel_zx = c->R_m_zx * t2 - c->R_m_zz * t1;
    const six_link_real R_rel_zz = c->R_m_zx * t1 + c->R_m_zz * t2;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_xx = base->R_T[0] * R_rel_xx + base->R_T[1] * R_rel_yx + base->R_T[2] * R_rel_zx;
    link->R_P[0] = R_P_xx;
    const six_link_real R_P_xy = base->R_T[0] * c->R_m_xy + base->R_T[1] * c->R_m_yy + base->R_T[2] * c->R_m_zy;
    link->R_P[1] = R_P_xy;
    const six_link_real R_P_xz = base->R_T[0] * R_rel_xz + base->R_T[1] * R_rel_yz + base->R_T[2] * R_rel_zz;
    link->R_P[2] = R_P_xz;
    const six_link_real R_P_yx = base->R_T[3] * R_rel_xx + base->R_T[4] * R_rel_yx + base->R_T[5] * R_rel_zx;
    link->R_P[3] = R_P_yx;
    const six_link_real R_P_yy = base->R_T[3] * c->R_m_xy + base->R_T[4] * c->R_m_yy + base->R_T[5] * c->R_m_zy;
    link->R_P[4] = R_P_yy;
    const six_link_real R_P_yz = base->R_T[3] * R_rel_xz + base->R_T[4] * R_rel_yz + base->R_T[5] * R_rel_zz;
    link->R_P[5] = R_P_yz;
    const six_link_real R_P_zx = base->R_T[6] * R_rel_xx + base->R_T[7] * R_rel_yx + base->R_T[8] * R_rel_zx;
    link->R_P[6] = R_P_zx;
    const six_link_real R_P_zy = base->R_T[6] * c->R_m_xy + base->R_T[7] * c->R_m_yy + base->R_T[8] * c->R_m_zy;
    link->R_P[7] = R_P_zy;
    const six_link_real R_P_zz = base->R_T[6] * R_rel_xz + base->R_T[7] * R_rel_yz + base->R_T[8] * R_rel_zz;
    link->R_P[8] = R_P_zz;
    const six_link_real omega_R_x = R_P_xx * base->omega[0] + R_P_yx * base->omega[1] + R_P_zx * base->omega[2];
    link->omega[0] = omega_R_x;
    const six_link_real omega_R_y = R_P_xy * base->omega[0] + R_P_yy * base->omega[1] + R_P_zy * base->omega[2];
    const six_link_real omega_R_z = R_P_xz * base->omega[0] + R_P_yz * base->omega[1] + R_P_zz * base->omega[2];
    link->omega[2] = omega_R_z;

    const six_link_real qdot_1 = twist[1] - omega_R_y;
    qdot[0] = qdot_1;

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real t3 = R_P_xx * base->acc_0[0] + R_P_yx * base->acc_0[1] + R_P_zx * base->acc_0[2];
    const six_link_real acc_0_alpha_y = R_P_xy * base->acc_0[0] + R_P_yy * base->acc_0[1] + R_P_zy * base->acc_0[2];
    link->acc_0[1] = acc_0_alpha_y;
    const six_link_real t4 = R_P_xz * base->acc_0[0] + R_P_yz * base->acc_0[1] + R_P_zz * base->acc_0[2];
    const six_link_real t5 = R_P_xx * base->acc_0[3] + R_P_yx * base->acc_0[4] + R_P_zx * base->acc_0[5];
    const six_link_real t6 = R_P_xy * base->acc_0[3] + R_P_yy * base->acc_0[4] + R_P_zy * base->acc_0[5];
    const six_link_real t7 = R_P_xz * base->acc_0[3] + R_P_yz * base->acc_0[4] + R_P_zz * base->acc_0[5];

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_x = t3 - omega_R_z * qdot_1;
    link->acc_0[0] = alpha_x;
    const six_link_real alpha_z = t4 + omega_R_x * qdot_1;
    link->acc_0[2] = alpha_z;

    /* r_R: joint point relative to the parent's tip point */
    const six_link_real r_R_x = R_rel_xx * c->mount_xyz_x + R_rel_yx * c->mount_xyz_y + R_rel_zx * c->mount_xyz_z;
    link->lever[0] = r_R_x;
    const six_link_real r_R_y = c->R_m_xy * c->mount_xyz_x + c->R_m_yy * c->mount_xyz_y + c->R_m_zy * c->mount_xyz_z;
    link->lever[1] = r_R_y;
    const six_link_real r_R_z = R_rel_xz * c->mount_xyz_x + R_rel_yz * c->mount_xyz_y + R_rel_zz * c->mount_xyz_z;
    link->lever[2] = r_R_z;

    /* a_J: acceleration of the joint point while no joint accelerates (accconst4) */
    const six_link_real t8 = omega_R_x * r_R_y - omega_R_y * r_R_x;
    const six_link_real t9 = omega_R_z * r_R_x - omega_R_x * r_R_z;
    const six_link_real a_J_x = t5 + acc_0_alpha_y * r_R_z + omega_R_y * t8 - t4 * r_R_y - omega_R_z * t9;
    link->acc_0[3] = a_J_x;
    const six_link_real t10 = omega_R_y * r_R_z - omega_R_z * r_R_y;
    const six_link_real a_J_y = t6 + t4 * r_R_x + omega_R_z * t10 - t3 * r_R_z - omega_R_x * t8;
    link->acc_0[4] = a_J_y;
    const six_link_real a_J_z = t7 + t3 * r_R_y + omega_R_x * t9 - acc_0_alpha_y * r_R_x - omega_R_y * t10;
    link->acc_0[5] = a_J_z;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    link->r_T[0] = r_T_y;
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);
    link->r_T[1] = r_T_z;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c2: Stumpff function of order 2 */
    const six_link_real t11 = six_link_c4(x);
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * t11;

    /* c3: Stumpff function of order 3 */
    const six_link_real t12 = six_link_c5(x);
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * t12;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t13 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real omega_s_x = c2 * t13;
    const six_link_real omega_s_y = thetadot_y + c3 * theta_z * t13;
    const six_link_real omega_s_z = thetadot_z - c3 * theta_y * t13;

    /* xdot: rate of the squared angle */
    const six_link_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const six_link_real c2dot = xdot * (t11 - c3 * SIX_LINK_REAL(0.5));

    /* c3dot: rate of c3 */
    const six_link_real c3dot = xdot * (t12 * SIX_LINK_REAL(1.5) - t11 * SIX_LINK_REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_x = c2dot * t13;
    const six_link_real alpha_s_y = c3 * thetadot_z * t13 + c3dot * theta_z * t13;
    const six_link_real minus_alpha_s_z = c3 * thetadot_y * t13 + c3dot * theta_y * t13;

    /* omega_t: angular velocity of the tip section (46) */
    const six_link_real omega_t_x = omega_s_x + omega_R_x;
    tip->omega[0] = omega_t_x;
    const six_link_real omega_t_y = omega_s_y + twist[1];
    tip->omega[1] = omega_t_y;
    const six_link_real omega_t_z = omega_s_z + omega_R_z;
    tip->omega[2] = omega_t_z;

    /* alpha_t: angular acceleration of the tip section (accconst1b) */
    const six_link_real alpha_t_x = alpha_s_x + alpha_x + omega_s_z * twist[1] - omega_s_y * omega_R_z;
    tip->acc_0[0] = alpha_t_x;
    const six_link_real alpha_t_y = alpha_s_y + acc_0_alpha_y + omega_s_x * omega_R_z - omega_s_z * omega_R_x;
    tip->acc_0[1] = alpha_t_y;
    const six_link_real alpha_t_z = alpha_z - minus_alpha_s_z + omega_s_y * omega_R_x - omega_s_x * twist[1];
    tip->acc_0[2] = alpha_t_z;

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t14 = udot_T_z * 2 + omega_R_x * r_T_y - c->length * twist[1];
    const six_link_real t15 = udot_T_y * 2 + c->length * omega_R_z - omega_R_x * r_T_z;
    const six_link_real a_t_x = a_J_x + acc_0_alpha_y * r_T_z + twist[1] * t14 - alpha_z * r_T_y - omega_R_z * t15;
    tip->acc_0[3] = a_t_x;
    const six_link_real t16 = twist[1] * r_T_z - omega_R_z * r_T_y;
    const six_link_real a_t_y = a_J_y + alpha_z * c->length + omega_R_z * t16 - alpha_x * r_T_z - omega_R_x * t14;
    tip->acc_0[4] = a_t_y;
    const six_link_real a_t_z = a_J_z + alpha_x * r_T_y + omega_R_x * t15 - acc_0_alpha_y * c->length - twist[1] * t16;
    tip->acc_0[5] = a_t_z;

    /* c1: Stumpff function of order 1 */
    const six_link_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real J_l_yx = c2 * theta_z;
    link->J_l[1] = J_l_yx;
    const six_link_real J_l_xz = c2 * theta_y;
    link->J_l[2] = J_l_xz;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    link->J_l[3] = J_l_yy;
    const six_link_real J_l_yz = c3 * theta_hat2_23;
    link->J_l[4] = J_l_yz;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;
    link->J_l[5] = J_l_zz;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    link->R_T[0] = R_T_xx;
    tip->R_T[0] = R_T_xx;
    const six_link_real R_T_yx = c1 * theta_z;
    link->R_T[1] = R_T_yx;
    tip->R_T[1] = -R_T_yx;
    tip->R_T[3] = R_T_yx;
    const six_link_real R_T_xz = c1 * theta_y;
    link->R_T[2] = R_T_xz;
    tip->R_T[2] = R_T_xz;
    tip->R_T[6] = -R_T_xz;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    link->R_T[3] = R_T_yy;
    tip->R_T[4] = R_T_yy;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    link->R_T[4] = R_T_yz;
    tip->R_T[5] = R_T_yz;
    tip->R_T[7] = R_T_yz;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;
    link->R_T[5] = R_T_zz;
    tip->R_T[8] = R_T_zz;

    /* outputs */
    link->omega[1] = twist[1];
    return SIX_LINK_OK;
}

/* dae kinematics, links like wrist_roll: 85 operations */
SIX_LINK_PART six_link_status dae_kinematics_wrist_roll(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, const six_link_node *restrict base, six_link_node *restrict tip,
    const six_link_real q[restrict 1], const six_link_real twist[restrict 6], six_link_real qdot[restrict 1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_xy = base->R_T[1] * R_rel_yy + base->R_T[2] * R_rel_zy;
    link->R_P[1] = R_P_xy;
    const six_link_real R_P_xz = base->R_T[2] * R_rel_yy - base->R_T[1] * R_rel_zy;
    link->R_P[2] = R_P_xz;
    const six_link_real R_P_yy = base->R_T[4] * R_rel_yy + base->R_T[5] * R_rel_zy;
    link->R_P[4] = R_P_yy;
    const six_link_real R_P_yz = base->R_T[5] * R_rel_yy - base->R_T[4] * R_rel_zy;
    link->R_P[5] = R_P_yz;
    const six_link_real R_P_zy = base->R_T[7] * R_rel_yy + base->R_T[8] * R_rel_zy;
    link->R_P[7] = R_P_zy;
    const six_link_real R_P_zz = base->R_T[8] * R_rel_yy - base->R_T[7] * R_rel_zy;
    link->R_P[8] = R_P_zz;
    const six_link_real omega_R_x = base->R_T[0] * base->omega[0] + base->R_T[3] * base->omega[1]
        + base->R_T[6] * base->omega[2];
    const six_link_real omega_R_y = R_P_xy * base->omega[0] + R_P_yy * base->omega[1] + R_P_zy * base->omega[2];
    link->omega[1] = omega_R_y;
    tip->omega[1] = omega_R_y;
    const six_link_real omega_R_z = R_P_xz * base->omega[0] + R_P_yz * base->omega[1] + R_P_zz * base->omega[2];
    link->omega[2] = omega_R_z;
    tip->omega[2] = omega_R_z;

    const six_link_real qdot_1 = twist[0] - omega_R_x;
    qdot[0] = qdot_1;

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real acc_0_alpha_x = base->R_T[0] * base->acc_0[0] + base->R_T[3] * base->acc_0[1]
        + base->R_T[6] * base->acc_0[2];
    link->acc_0[0] = acc_0_alpha_x;
    tip->acc_0[0] = acc_0_alpha_x;
    const six_link_real t1 = R_P_xy * base->acc_0[0] + R_P_yy * base->acc_0[1] + R_P_zy * base->acc_0[2];
    const six_link_real t2 = R_P_xz * base->acc_0[0] + R_P_yz * base->acc_0[1] + R_P_zz * base->acc_0[2];
    const six_link_real acc_0_a_x = base->R_T[0] * base->acc_0[3] + base->R_T[3] * base->acc_0[4]
        + base->R_T[6] * base->acc_0[5];
    link->acc_0[3] = acc_0_a_x;
    const six_link_real acc_0_a_y = R_P_xy * base->acc_0[3] + R_P_yy * base->acc_0[4] + R_P_zy * base->acc_0[5];
    link->acc_0[4] = acc_0_a_y;
    const six_link_real acc_0_a_z = R_P_xz * base->acc_0[3] + R_P_yz * base->acc_0[4] + R_P_zz * base->acc_0[5];
    link->acc_0[5] = acc_0_a_z;

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_y = t1 + omega_R_z * qdot_1;
    link->acc_0[1] = alpha_y;
    tip->acc_0[1] = alpha_y;
    const six_link_real alpha_z = t2 - omega_R_y * qdot_1;
    link->acc_0[2] = alpha_z;
    tip->acc_0[2] = alpha_z;

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real a_t_x = acc_0_a_x - c->length * (omega_R_y * omega_R_y) - c->length * (omega_R_z * omega_R_z);
    tip->acc_0[3] = a_t_x;
    const six_link_real t3 = c->length * twist[0];
    const six_link_real a_t_y = acc_0_a_y + alpha_z * c->length + t3 * omega_R_y;
    tip->acc_0[4] = a_t_y;
    const six_link_real a_t_z = acc_0_a_z + t3 * omega_R_z - alpha_y * c->length;
    tip->acc_0[5] = a_t_z;

    /* outputs */
    link->R_P[0] = base->R_T[0];
    link->R_P[3] = base->R_T[3];
    link->R_P[6] = base->R_T[6];
    link->omega[0] = twist[0];
    tip->omega[0] = twist[0];
    return SIX_LINK_OK;
}

/* dae kinematics, links like wrist_pitch: 41 operations */
SIX_LINK_PART six_link_status dae_kinematics_wrist_pitch(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, const six_link_node *restrict base, six_link_node *restrict tip,
    const six_link_real q[restrict 1], const six_link_real twist[restrict 6], six_link_real qdot[restrict 1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;
    link->R_P[2] = R_rel_xz;
    link->R_P[6] = -R_rel_xz;
    link->R_P[0] = R_rel_xx;
    link->R_P[8] = R_rel_xx;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real omega_R_x = R_rel_xx * base->omega[0] - R_rel_xz * base->omega[2];
    link->omega[0] = omega_R_x;
    tip->omega[0] = omega_R_x;
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_xx * base->omega[2];
    link->omega[2] = omega_R_z;
    tip->omega[2] = omega_R_z;

    const six_link_real qdot_1 = twist[1] - base->omega[1];
    qdot[0] = qdot_1;

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real t1 = R_rel_xx * base->acc_0[0] - R_rel_xz * base->acc_0[2];
    const six_link_real t2 = R_rel_xz * base->acc_0[0] + R_rel_xx * base->acc_0[2];
    const six_link_real acc_0_a_x = R_rel_xx * base->acc_0[3] - R_rel_xz * base->acc_0[5];
    link->acc_0[3] = acc_0_a_x;
    const six_link_real acc_0_a_z = R_rel_xz * base->acc_0[3] + R_rel_xx * base->acc_0[5];
    link->acc_0[5] = acc_0_a_z;

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_x = t1 - omega_R_z * qdot_1;
    link->acc_0[0] = alpha_x;
    tip->acc_0[0] = alpha_x;
    const six_link_real alpha_z = t2 + omega_R_x * qdot_1;
    link->acc_0[2] = alpha_z;
    tip->acc_0[2] = alpha_z;

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real a_t_x = acc_0_a_x - c->length * (twist[1] * twist[1]) - c->length * (omega_R_z * omega_R_z);
    tip->acc_0[3] = a_t_x;
    const six_link_real t3 = c->length * omega_R_x;
    const six_link_real a_t_y = base->acc_0[4] + alpha_z * c->length + t3 * twist[1];
    tip->acc_0[4] = a_t_y;
    const six_link_real a_t_z = acc_0_a_z + t3 * omega_R_z - base->acc_0[1] * c->length;
    tip->acc_0[5] = a_t_z;

    /* outputs */
    link->omega[1] = twist[1];
    link->acc_0[1] = base->acc_0[1];
    link->acc_0[4] = base->acc_0[4];
    tip->omega[1] = twist[1];
    tip->acc_0[1] = base->acc_0[1];
    return SIX_LINK_OK;
}

/* dae kinematics, links like flange: 41 operations */
SIX_LINK_PART six_link_status dae_kinematics_flange(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, const six_link_node *restrict base, six_link_node *restrict tip,
    const six_link_real q[restrict 1], const six_link_real twist[restrict 6], six_link_real qdot[restrict 1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;
    link->R_P[5] = -R_rel_zy;
    link->R_P[7] = R_rel_zy;
    link->R_P[4] = R_rel_yy;
    link->R_P[8] = R_rel_yy;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real omega_R_y = R_rel_yy * base->omega[1] + R_rel_zy * base->omega[2];
    link->omega[1] = omega_R_y;
    tip->omega[1] = omega_R_y;
    const six_link_real omega_R_z = R_rel_yy * base->omega[2] - R_rel_zy * base->omega[1];
    link->omega[2] = omega_R_z;
    tip->omega[2] = omega_R_z;

    const six_link_real qdot_1 = twist[0] - base->omega[0];
    qdot[0] = qdot_1;

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real t1 = R_rel_yy * base->acc_0[1] + R_rel_zy * base->acc_0[2];
    const six_link_real t2 = R_rel_yy * base->acc_0[2] - R_rel_zy * base->acc_0[1];
    const six_link_real acc_0_a_y = R_rel_yy * base->acc_0[4] + R_rel_zy * base->acc_0[5];
    link->acc_0[4] = acc_0_a_y;
    const six_link_real acc_0_a_z = R_rel_yy * base->acc_0[5] - R_rel_zy * base->acc_0[4];
    link->acc_0[5] = acc_0_a_z;

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_y = t1 + omega_R_z * qdot_1;
    link->acc_0[1] = alpha_y;
    tip->acc_0[1] = alpha_y;
    const six_link_real alpha_z = t2 - omega_R_y * qdot_1;
    link->acc_0[2] = alpha_z;
    tip->acc_0[2] = alpha_z;

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real a_t_x = base->acc_0[3] - c->length * (omega_R_y * omega_R_y)
        - c->length * (omega_R_z * omega_R_z);
    tip->acc_0[3] = a_t_x;
    const six_link_real t3 = c->length * twist[0];
    const six_link_real a_t_y = acc_0_a_y + alpha_z * c->length + t3 * omega_R_y;
    tip->acc_0[4] = a_t_y;
    const six_link_real a_t_z = acc_0_a_z + t3 * omega_R_z - alpha_y * c->length;
    tip->acc_0[5] = a_t_z;

    /* outputs */
    link->omega[0] = twist[0];
    link->acc_0[0] = base->acc_0[0];
    link->acc_0[3] = base->acc_0[3];
    tip->omega[0] = twist[0];
    tip->acc_0[0] = base->acc_0[0];
    return SIX_LINK_OK;
}

/* eliminate, links like shoulder: 112 operations */
SIX_LINK_PART six_link_status eliminate_shoulder(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, const six_link_node *restrict tip, const six_link_real w_ext[restrict 6],
    const six_link_real m_q[restrict 1], const six_link_real f_q[restrict 1], const six_link_real tau[restrict 1])
{
    /* Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_xx = link->omega[2] * link->omega[2];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real minus_H_star_tau_y = c->S_0_x * link->acc_0[5];
    const six_link_real H_star_tau_z = c->S_0_x * link->acc_0[4];
    const six_link_real H_star_f_x = link->acc_0[3] * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = link->acc_0[4] * c->mu;
    const six_link_real H_star_f_z = link->acc_0[5] * c->mu;

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real Lambda_T_11 = tip->Lambda[0] + c->I_T_xx;
    const six_link_real Lambda_T_13 = tip->Lambda[2] - c->J_T_xz;
    const six_link_real Lambda_T_15 = tip->Lambda[4] - c->S_T_z;
    const six_link_real Lambda_T_22 = tip->Lambda[6] + c->I_T_yy;
    const six_link_real Lambda_T_23 = tip->Lambda[7] - c->J_T_yz;
    const six_link_real Lambda_T_26 = tip->Lambda[10] - c->S_T_x;
    const six_link_real Lambda_T_33 = tip->Lambda[11] + c->I_T_zz;
    const six_link_real Lambda_T_34 = tip->Lambda[12] - c->S_T_y;
    const six_link_real Lambda_T_35 = tip->Lambda[13] + c->S_T_x;
    const six_link_real Lambda_T_55 = tip->Lambda[18] + c->body0_mass;
    const six_link_real Lambda_T_66 = tip->Lambda[20] + c->body0_mass;
    const six_link_real t1 = c->S_T_y * tip->acc_0[5] - c->S_T_z * tip->acc_0[4]
        + tip->omega[2] * (c->J_T_yz * tip->omega[2]);
    const six_link_real t2 = c->S_T_z * tip->acc_0[3] - c->S_T_x * tip->acc_0[5]
        - tip->omega[2] * (c->J_T_xz * tip->omega[2]);
    const six_link_real p_T_tau_x = tip->p[0] + t1 - w_ext[0];
    const six_link_real p_T_tau_y = tip->p[1] + t2 - w_ext[1];
    const six_link_real p_T_tau_z = tip->p[2] + (c->S_T_x * tip->acc_0[4] - c->S_T_y * tip->acc_0[3]) - w_ext[2];
    const six_link_real p_T_f_x = tip->p[3]
        + (c->body0_mass * tip->acc_0[3] - tip->omega[2] * (tip->omega[2] * c->S_T_x)) - w_ext[3];
    const six_link_real p_T_f_y = tip->p[4]
        + (c->body0_mass * tip->acc_0[4] - tip->omega[2] * (tip->omega[2] * c->S_T_y)) - w_ext[4];
    const six_link_real p_T_f_z = tip->p[5] + c->body0_mass * tip->acc_0[5] - w_ext[5];

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real M_loaded_34 = Lambda_T_34 + c->length * tip->Lambda[16];
    const six_link_real t3 = Lambda_T_35 + c->length * Lambda_T_55;
    const six_link_real M_loaded_36 = tip->Lambda[14] + c->length * tip->Lambda[19];
    const six_link_real M_loaded_13 = Lambda_T_13 + Lambda_T_15 * c->length;
    const six_link_real M_loaded_23 = Lambda_T_23 + tip->Lambda[9] * c->length - c->length * M_loaded_36;
    const six_link_real M_loaded_11 = c->I_s + Lambda_T_11;
    const six_link_real M_loaded_22 = c->J_0_xx
        + (Lambda_T_22 - Lambda_T_26 * c->length - c->length * (Lambda_T_26 - c->length * Lambda_T_66));
    const six_link_real M_loaded_33 = c->J_0_xx + (Lambda_T_33 + Lambda_T_35 * c->length + c->length * t3);
    const six_link_real M_loaded_35 = c->S_0_x + t3;
    const six_link_real h_loaded_tau_y = p_T_tau_y - c->length * p_T_f_z - minus_H_star_tau_y;
    const six_link_real h_loaded_tau_z = H_star_tau_z + (p_T_tau_z + c->length * p_T_f_y);
    const six_link_real h_loaded_f_x = H_star_f_x + p_T_f_x;
    const six_link_real h_loaded_f_y = H_star_f_y + p_T_f_y;
    const six_link_real h_loaded_f_z = H_star_f_z + p_T_f_z;

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_11 = M_loaded_33 + m_q[0];
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8
        * (M_loaded_11 + M_loaded_22 + M_loaded_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_w_1 = (tau[0] - f_q[0] - h_loaded_tau_z) * joint_inverse_1;
    link->joint_w[0] = joint_w_1;
    const six_link_real p_i_tau_x = p_T_tau_x + M_loaded_13 * joint_w_1;
    link->p_i[0] = p_i_tau_x;
    const six_link_real p_i_tau_y = h_loaded_tau_y + M_loaded_23 * joint_w_1;
    link->p_i[1] = p_i_tau_y;
    const six_link_real p_i_tau_z = h_loaded_tau_z + M_loaded_33 * joint_w_1;
    link->p_i[2] = p_i_tau_z;
    const six_link_real p_i_f_x = h_loaded_f_x + M_loaded_34 * joint_w_1;
    link->p_i[3] = p_i_f_x;
    const six_link_real p_i_f_y = h_loaded_f_y + M_loaded_35 * joint_w_1;
    link->p_i[4] = p_i_f_y;
    const six_link_real p_i_f_z = h_loaded_f_z + M_loaded_36 * joint_w_1;
    link->p_i[5] = p_i_f_z;
    return SIX_LINK_OK;
}

/* eliminate, links like upper_arm: 1739 operations */
SIX_LINK_PART six_link_status eliminate_upper_arm(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, six_link_node *restrict base, const six_link_node *restrict tip,
    const six_link_real eta[restrict 5], const six_link_real etadot[restrict 5], const six_link_real w_ext[restrict 6],
    const six_link_real m_eta[restrict 5], const six_link_real f_eta[restrict 5], const six_link_real m_q[restrict 1],
    const six_link_real f_q[restrict 1], const six_link_real tau[restrict 1])
{
    /* S: first moment */
    const six_link_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2;
    const six_link_real S_z = eta[2] * c->sigma_y1 + eta[3] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const six_link_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2;
    const six_link_real Sdot_z = etadot[2] * c->sigma_y1 + etadot[3] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->mu * eta[0];
    const six_link_real L_y2 = c->mu * eta[1];
    const six_link_real L_z1 = eta[2] * c->mu;
    const six_link_real L_z2 = eta[3] * c->mu;

    /* Ldot: rate of L */
    const six_link_real Ldot_y1 = c->mu * etadot[0];
    const six_link_real Ldot_y2 = c->mu * etadot[1];
    const six_link_real Ldot_z1 = etadot[2] * c->mu;
    const six_link_real Ldot_z2 = etadot[3] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1];
    const six_link_real J_xz = c->chi_1 * eta[2] + c->chi_2 * eta[3];
    const six_link_real J_yy = L_y1 * eta[0] + L_y2 * eta[1];
    const six_link_real J_yz = L_z1 * eta[0] + L_z2 * eta[1];
    const six_link_real J_zz = L_z1 * eta[2] + L_z2 * eta[3];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const six_link_real t1 = link->omega[1] * link->omega[1];
    const six_link_real t2 = link->omega[2] * link->omega[2];
    const six_link_real minus_Omega_xx = t1 + t2;
    const six_link_real t3 = link->omega[0] * link->omega[1];
    const six_link_real Omega_xy = t3 - link->acc_0[2];
    const six_link_real Omega_xz = link->omega[0] * link->omega[2];
    const six_link_real Omega_yx = link->acc_0[2] + t3;
    const six_link_real t4 = link->omega[0] * link->omega[0];
    const six_link_real minus_Omega_yy = t4 + t2;
    const six_link_real t5 = link->omega[1] * link->omega[2];
    const six_link_real Omega_yz = t5 - link->acc_0[0];
    const six_link_real Omega_zy = link->acc_0[0] + t5;
    const six_link_real minus_Omega_zz = t4 + t1;

    /* B: moment of the elastic velocity */
    const six_link_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1];
    const six_link_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1];
    const six_link_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1];
    const six_link_real B_zx = c->chi_1 * etadot[2] + c->chi_2 * etadot[3];
    const six_link_real B_zy = L_y1 * etadot[2] + L_y2 * etadot[3];
    const six_link_real B_zz = L_z1 * etadot[2] + L_z2 * etadot[3];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const six_link_real h_c_tau_x = B_yy * link->omega[0] + B_zz * link->omega[0];
    const six_link_real h_c_tau_y = B_zz * link->omega[1] - B_yx * link->omega[0] - B_yz * link->omega[2];
    const six_link_real h_c_tau_z = B_yy * link->omega[2] - B_zx * link->omega[0] - B_zy * link->omega[1];
    const six_link_real h_c_f_x = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
    const six_link_real minus_h_c_f_y = Sdot_z * link->omega[0];
    const six_link_real h_c_f_z = Sdot_y * link->omega[0];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const six_link_real h_MD_tau_y = h_c_tau_y + etadot[4] * link->omega[2] * c->sigma_t_5;
    const six_link_real h_MD_tau_z = h_c_tau_z - etadot[4] * link->omega[1] * c->sigma_t_5;

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real t6 = h_c_tau_x + c->I_s * link->acc_0[0] + J_xy * Omega_xz + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const six_link_real H_star_tau_x = t6 + S_y * link->acc_0[5] - J_xz * Omega_yx - J_zz * Omega_yz
        - S_z * link->acc_0[4];
    const six_link_real t7 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->acc_0[3];
    const six_link_real t8 = c->I_s * link->omega[0];
    const six_link_real H_star_tau_y = t7 + t8 * link->omega[2] - c->J_0_xx * Omega_xz - J_xy * Omega_zy
        - c->S_0_x * link->acc_0[5];
    const six_link_real t9 = h_c_tau_z + c->J_0_xx * Omega_yx + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * link->acc_0[4];
    const six_link_real H_star_tau_z = t9 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->acc_0[3]
        - t8 * link->omega[1];
    const six_link_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + link->acc_0[3] * c->mu;
    const six_link_real H_star_f_y = Omega_yx * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + link->acc_0[4] * c->mu;
    const six_link_real H_star_f_z = h_c_f_z + Omega_xz * c->S_0_x + Omega_zy * S_y - minus_Omega_zz * S_z
        + link->acc_0[5] * c->mu;

    /* h_V: bias of the twist rows, angular acceleration included */
    const six_link_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const six_link_real h_V_tau_y = H_star_tau_y + h_MD_tau_y;
    const six_link_real h_V_tau_z = H_star_tau_z + h_MD_tau_z;
    const six_link_real h_V_f_x = H_star_f_x + h_c_f_x;
    const six_link_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const six_link_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const six_link_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_yx * c->chi_1
        + link->acc_0[4] * c->sigma_y1 - Ldot_z1 * 2 * link->omega[0];
    const six_link_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_yx * c->chi_2
        + link->acc_0[4] * c->sigma_y2 - Ldot_z2 * 2 * link->omega[0];
    const six_link_real h_eta_3 = L_y1 * Omega_zy - L_z1 * minus_Omega_zz + Omega_xz * c->chi_1
        + link->acc_0[5] * c->sigma_y1 + Ldot_y1 * 2 * link->omega[0];
    const six_link_real h_eta_4 = L_y2 * Omega_zy - L_z2 * minus_Omega_zz + Omega_xz * c->chi_2
        + link->acc_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];
    const six_link_real h_eta_5 = link->acc_0[0] * c->sigma_t_5;

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t10 = link->R_T[0] * c->S_T_x + link->R_T[1] * c->S_T_y + link->R_T[2] * c->S_T_z;
    const six_link_real t11 = link->R_T[3] * c->S_T_x + link->R_T[4] * c->S_T_y + link->R_T[5] * c->S_T_z;
    const six_link_real t12 = link->R_T[6] * c->S_T_x + link->R_T[7] * c->S_T_y + link->R_T[8] * c->S_T_z;
    const six_link_real t13 = c->I_T_xx * link->R_T[3] - c->J_T_xy * link->R_T[4] - c->J_T_xz * link->R_T[5];
    const six_link_real t14 = c->I_T_xx * link->R_T[6] - c->J_T_xy * link->R_T[7] - c->J_T_xz * link->R_T[8];
    const six_link_real t15 = c->I_T_yy * link->R_T[4] - c->J_T_xy * link->R_T[3] - c->J_T_yz * link->R_T[5];
    const six_link_real t16 = c->I_T_yy * link->R_T[7] - c->J_T_xy * link->R_T[6] - c->J_T_yz * link->R_T[8];
    const six_link_real t17 = c->I_T_zz * link->R_T[5] - (c->J_T_xz * link->R_T[3] + c->J_T_yz * link->R_T[4]);
    const six_link_real t18 = c->I_T_zz * link->R_T[8] - (c->J_T_xz * link->R_T[6] + c->J_T_yz * link->R_T[7]);
    const six_link_real t19 = link->R_T[0]
        * (c->I_T_xx * link->R_T[0] - c->J_T_xy * link->R_T[1] - c->J_T_xz * link->R_T[2])
        + link->R_T[1] * (c->I_T_yy * link->R_T[1] - c->J_T_xy * link->R_T[0] - c->J_T_yz * link->R_T[2]);
    const six_link_real t20 = link->R_T[2]
        * (c->I_T_zz * link->R_T[2] - (c->J_T_xz * link->R_T[0] + c->J_T_yz * link->R_T[1]));
    const six_link_real t21 = t19 + t20;
    const six_link_real t22 = link->R_T[0] * t13 + link->R_T[1] * t15 + link->R_T[2] * t17;
    const six_link_real t23 = link->R_T[0] * t14 + link->R_T[1] * t16 + link->R_T[2] * t18;
    const six_link_real t24 = link->R_T[3] * t13 + link->R_T[4] * t15 + link->R_T[5] * t17;
    const six_link_real t25 = link->R_T[3] * t14 + link->R_T[4] * t16 + link->R_T[5] * t18;
    const six_link_real t26 = link->R_T[6] * t14 + link->R_T[7] * t16 + link->R_T[8] * t18;
    const six_link_real Lambda_T_11 = tip->Lambda[0] + t21;
    const six_link_real Lambda_T_12 = tip->Lambda[1] + t22;
    const six_link_real Lambda_T_13 = tip->Lambda[2] + t23;
    const six_link_real Lambda_T_15 = tip->Lambda[4] - t12;
    const six_link_real Lambda_T_16 = tip->Lambda[5] + t11;
    const six_link_real Lambda_T_22 = tip->Lambda[6] + t24;
    const six_link_real Lambda_T_23 = tip->Lambda[7] + t25;
    const six_link_real Lambda_T_24 = tip->Lambda[8] + t12;
    const six_link_real Lambda_T_26 = tip->Lambda[10] - t10;
    const six_link_real Lambda_T_33 = tip->Lambda[11] + t26;
    const six_link_real Lambda_T_34 = tip->Lambda[12] - t11;
    const six_link_real Lambda_T_35 = tip->Lambda[13] + t10;
    const six_link_real Lambda_T_44 = tip->Lambda[15] + c->body0_mass;
    const six_link_real Lambda_T_55 = tip->Lambda[18] + c->body0_mass;
    const six_link_real Lambda_T_66 = tip->Lambda[20] + c->body0_mass;
    const six_link_real t27 = t11 * tip->acc_0[5] - t12 * tip->acc_0[4]
        + (t21 * tip->acc_0[0] + t22 * tip->acc_0[1] + t23 * tip->acc_0[2]);
    const six_link_real t28 = t12 * tip->acc_0[3] - t10 * tip->acc_0[5]
        + (t22 * tip->acc_0[0] + t24 * tip->acc_0[1] + t25 * tip->acc_0[2]);
    const six_link_real t29 = t10 * tip->acc_0[4] - t11 * tip->acc_0[3]
        + (t23 * tip->acc_0[0] + t25 * tip->acc_0[1] + t26 * tip->acc_0[2]);
    const six_link_real t30 = t21 * tip->omega[0] + t22 * tip->omega[1] + t23 * tip->omega[2];
    const six_link_real t31 = t22 * tip->omega[0] + t24 * tip->omega[1] + t25 * tip->omega[2];
    const six_link_real t32 = t23 * tip->omega[0] + t25 * tip->omega[1] + t26 * tip->omega[2];
    const six_link_real t33 = tip->omega[1] * t12 - tip->omega[2] * t11;
    const six_link_real t34 = tip->omega[2] * t10 - tip->omega[0] * t12;
    const six_link_real t35 = tip->omega[0] * t11 - tip->omega[1] * t10;
    const six_link_real t36 = c->body0_mass * tip->acc_0[3]
        + (tip->acc_0[1] * t12 - tip->acc_0[2] * t11 + (tip->omega[1] * t35 - tip->omega[2] * t34));
    const six_link_real t37 = c->body0_mass * tip->acc_0[4]
        + (tip->acc_0[2] * t10 - tip->acc_0[0] * t12 + (tip->omega[2] * t33 - tip->omega[0] * t35));
    const six_link_real t38 = c->body0_mass * tip->acc_0[5]
        + (tip->acc_0[0] * t11 - tip->acc_0[1] * t10 + (tip->omega[0] * t34 - tip->omega[1] * t33));
    const six_link_real p_T_tau_x = tip->p[0] + (t27 + (tip->omega[1] * t32 - tip->omega[2] * t31))
        - (link->R_T[0] * w_ext[0] + link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2]);
    const six_link_real p_T_tau_y = tip->p[1] + (t28 + (tip->omega[2] * t30 - tip->omega[0] * t32))
        - (link->R_T[3] * w_ext[0] + link->R_T[4] * w_ext[1] + link->R_T[5] * w_ext[2]);
    const six_link_real p_T_tau_z = tip->p[2] + (t29 + (tip->omega[0] * t31 - tip->omega[1] * t30))
        - (link->R_T[6] * w_ext[0] + link->R_T[7] * w_ext[1] + link->R_T[8] * w_ext[2]);
    const six_link_real p_T_f_x = tip->p[3] + t36
        - (link->R_T[0] * w_ext[3] + link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const six_link_real p_T_f_y = tip->p[4] + t37
        - (link->R_T[3] * w_ext[3] + link->R_T[4] * w_ext[4] + link->R_T[5] * w_ext[5]);
    const six_link_real p_T_f_z = tip->p[5] + t38
        - (link->R_T[6] * w_ext[3] + link->R_T[7] * w_ext[4] + link->R_T[8] * w_ext[5]);

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real Theta_11 = link->J_l[2] * c->Psi_c_z1;
    const six_link_real Theta_12 = link->J_l[2] * c->Psi_c_z2;
    const six_link_real Theta_13 = link->J_l[1] * c->Psi_c_y3;
    const six_link_real Theta_14 = link->J_l[1] * c->Psi_c_y4;
    const six_link_real Theta_15 = link->J_l[0] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real Theta_21 = link->J_l[5] * c->Psi_c_z1;
    const six_link_real Theta_22 = link->J_l[5] * c->Psi_c_z2;
    const six_link_real Theta_23 = link->J_l[4] * c->Psi_c_y3;
    const six_link_real Theta_24 = link->J_l[4] * c->Psi_c_y4;
    const six_link_real Theta_25 = link->J_l[3] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real Theta_31 = link->J_l[8] * c->Psi_c_z1;
    const six_link_real Theta_32 = link->J_l[8] * c->Psi_c_z2;
    const six_link_real Theta_33 = link->J_l[7] * c->Psi_c_y3;
    const six_link_real Theta_34 = link->J_l[7] * c->Psi_c_y4;
    const six_link_real Theta_35 = link->J_l[6] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real t39 = link->r_T[1] * tip->Lambda[16];
    const six_link_real t40 = link->r_T[0] * tip->Lambda[17];
    const six_link_real t41 = c->length * tip->Lambda[19];
    const six_link_real M_loaded_14 = tip->Lambda[3] + (t40 - t39);
    const six_link_real t42 = Lambda_T_15 + (link->r_T[0] * tip->Lambda[19] - link->r_T[1] * Lambda_T_55);
    const six_link_real t43 = Lambda_T_16 + (link->r_T[0] * Lambda_T_66 - link->r_T[1] * tip->Lambda[19]);
    const six_link_real t44 = Lambda_T_24 + (link->r_T[1] * Lambda_T_44 - c->length * tip->Lambda[17]);
    const six_link_real M_loaded_25 = tip->Lambda[9] + (t39 - t41);
    const six_link_real t45 = Lambda_T_26 + (link->r_T[1] * tip->Lambda[17] - c->length * Lambda_T_66);
    const six_link_real t46 = Lambda_T_34 + (c->length * tip->Lambda[16] - link->r_T[0] * Lambda_T_44);
    const six_link_real t47 = Lambda_T_35 + (c->length * Lambda_T_55 - link->r_T[0] * tip->Lambda[16]);
    const six_link_real M_loaded_36 = tip->Lambda[14] + (t41 - t40);
    const six_link_real t48 = Lambda_T_11 - (Lambda_T_15 * link->r_T[1] - Lambda_T_16 * link->r_T[0])
        + (link->r_T[0] * t43 - link->r_T[1] * t42);
    const six_link_real t49 = Lambda_T_12 - (Lambda_T_16 * c->length - tip->Lambda[3] * link->r_T[1])
        + (link->r_T[0] * t45 - link->r_T[1] * M_loaded_25);
    const six_link_real t50 = Lambda_T_13 - (tip->Lambda[3] * link->r_T[0] - Lambda_T_15 * c->length)
        + (link->r_T[0] * M_loaded_36 - link->r_T[1] * t47);
    const six_link_real t51 = Lambda_T_22 - (Lambda_T_26 * c->length - Lambda_T_24 * link->r_T[1])
        + (link->r_T[1] * t44 - c->length * t45);
    const six_link_real t52 = Lambda_T_23 - (Lambda_T_24 * link->r_T[0] - tip->Lambda[9] * c->length)
        + (link->r_T[1] * t46 - c->length * M_loaded_36);
    const six_link_real t53 = Lambda_T_33 - (Lambda_T_34 * link->r_T[0] - Lambda_T_35 * c->length)
        + (c->length * t47 - link->r_T[0] * t46);
    const six_link_real M_loaded_11 = I_xx + t48;
    const six_link_real M_loaded_12 = t49 - J_xy;
    const six_link_real M_loaded_13 = t50 - J_xz;
    const six_link_real M_loaded_15 = t42 - S_z;
    const six_link_real M_loaded_16 = S_y + t43;
    const six_link_real M_loaded_22 = I_yy + t51;
    const six_link_real M_loaded_23 = t52 - J_yz;
    const six_link_real M_loaded_24 = S_z + t44;
    const six_link_real M_loaded_26 = t45 - c->S_0_x;
    const six_link_real M_loaded_33 = I_zz + t53;
    const six_link_real M_loaded_34 = t46 - S_y;
    const six_link_real M_loaded_35 = c->S_0_x + t47;
    const six_link_real M_loaded_44 = c->mu + Lambda_T_44;
    const six_link_real M_loaded_55 = c->mu + Lambda_T_55;
    const six_link_real M_loaded_66 = c->mu + Lambda_T_66;
    const six_link_real h_loaded_tau_x = h_V_tau_x + (p_T_tau_x + (link->r_T[0] * p_T_f_z - link->r_T[1] * p_T_f_y));
    const six_link_real h_loaded_tau_y = h_V_tau_y + (p_T_tau_y + (link->r_T[1] * p_T_f_x - c->length * p_T_f_z));
    const six_link_real h_loaded_tau_z = h_V_tau_z + (p_T_tau_z + (c->length * p_T_f_y - link->r_T[0] * p_T_f_x));
    const six_link_real h_loaded_f_x = h_V_f_x + p_T_f_x;
    const six_link_real h_loaded_f_y = h_V_f_y + p_T_f_y;
    const six_link_real h_loaded_f_z = h_V_f_z + p_T_f_z;
    const six_link_real t54 = Lambda_T_11 * Theta_11 + Lambda_T_12 * Theta_21 + Lambda_T_13 * Theta_31
        + Lambda_T_15 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t55 = Lambda_T_11 * Theta_12 + Lambda_T_12 * Theta_22 + Lambda_T_13 * Theta_32
        + Lambda_T_15 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t56 = Lambda_T_11 * Theta_13 + Lambda_T_12 * Theta_23 + Lambda_T_13 * Theta_33
        + Lambda_T_16 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t57 = Lambda_T_11 * Theta_14 + Lambda_T_12 * Theta_24 + Lambda_T_13 * Theta_34
        + Lambda_T_16 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t58 = Lambda_T_11 * Theta_15 + Lambda_T_12 * Theta_25 + Lambda_T_13 * Theta_35;
    const six_link_real t59 = Lambda_T_12 * Theta_11 + Lambda_T_22 * Theta_21 + Lambda_T_23 * Theta_31
        + tip->Lambda[9] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t60 = Lambda_T_12 * Theta_12 + Lambda_T_22 * Theta_22 + Lambda_T_23 * Theta_32
        + tip->Lambda[9] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t61 = Lambda_T_12 * Theta_13 + Lambda_T_22 * Theta_23 + Lambda_T_23 * Theta_33
        + Lambda_T_26 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t62 = Lambda_T_12 * Theta_14 + Lambda_T_22 * Theta_24 + Lambda_T_23 * Theta_34
        + Lambda_T_26 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t63 = Lambda_T_12 * Theta_15 + Lambda_T_22 * Theta_25 + Lambda_T_23 * Theta_35;
    const six_link_real t64 = Lambda_T_13 * Theta_11 + Lambda_T_23 * Theta_21 + Lambda_T_33 * Theta_31
        + Lambda_T_35 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t65 = Lambda_T_13 * Theta_12 + Lambda_T_23 * Theta_22 + Lambda_T_33 * Theta_32
        + Lambda_T_35 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t66 = Lambda_T_13 * Theta_13 + Lambda_T_23 * Theta_23 + Lambda_T_33 * Theta_33
        + tip->Lambda[14] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t67 = Lambda_T_13 * Theta_14 + Lambda_T_23 * Theta_24 + Lambda_T_33 * Theta_34
        + tip->Lambda[14] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t68 = Lambda_T_13 * Theta_15 + Lambda_T_23 * Theta_25 + Lambda_T_33 * Theta_35;
    const six_link_real C_41 = tip->Lambda[3] * Theta_11 + Lambda_T_24 * Theta_21 + Lambda_T_34 * Theta_31
        + tip->Lambda[16] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real C_42 = tip->Lambda[3] * Theta_12 + Lambda_T_24 * Theta_22 + Lambda_T_34 * Theta_32
        + tip->Lambda[16] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_43 = tip->Lambda[3] * Theta_13 + Lambda_T_24 * Theta_23 + Lambda_T_34 * Theta_33
        + tip->Lambda[17] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real C_44 = tip->Lambda[3] * Theta_14 + Lambda_T_24 * Theta_24 + Lambda_T_34 * Theta_34
        + tip->Lambda[17] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_45 = tip->Lambda[3] * Theta_15 + Lambda_T_24 * Theta_25 + Lambda_T_34 * Theta_35;
    const six_link_real t69 = Lambda_T_15 * Theta_11 + tip->Lambda[9] * Theta_21 + Lambda_T_35 * Theta_31
        + Lambda_T_55 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t70 = Lambda_T_15 * Theta_12 + tip->Lambda[9] * Theta_22 + Lambda_T_35 * Theta_32
        + Lambda_T_55 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t71 = tip->Lambda[19] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real C_53 = Lambda_T_15 * Theta_13 + tip->Lambda[9] * Theta_23 + Lambda_T_35 * Theta_33 + t71;
    const six_link_real t72 = tip->Lambda[19] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_54 = Lambda_T_15 * Theta_14 + tip->Lambda[9] * Theta_24 + Lambda_T_35 * Theta_34 + t72;
    const six_link_real C_55 = Lambda_T_15 * Theta_15 + tip->Lambda[9] * Theta_25 + Lambda_T_35 * Theta_35;
    const six_link_real C_61 = Lambda_T_16 * Theta_11 + Lambda_T_26 * Theta_21 + tip->Lambda[14] * Theta_31 + t71;
    const six_link_real C_62 = Lambda_T_16 * Theta_12 + Lambda_T_26 * Theta_22 + tip->Lambda[14] * Theta_32 + t72;
    const six_link_real t73 = Lambda_T_16 * Theta_13 + Lambda_T_26 * Theta_23 + tip->Lambda[14] * Theta_33
        + Lambda_T_66 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t74 = Lambda_T_16 * Theta_14 + Lambda_T_26 * Theta_24 + tip->Lambda[14] * Theta_34
        + Lambda_T_66 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_65 = Lambda_T_16 * Theta_15 + Lambda_T_26 * Theta_25 + tip->Lambda[14] * Theta_35;
    const six_link_real C_21 = t59 + (link->r_T[1] * C_41 - c->length * C_61);
    const six_link_real C_22 = t60 + (link->r_T[1] * C_42 - c->length * C_62);
    const six_link_real C_33 = t66 + (c->length * C_53 - link->r_T[0] * C_43);
    const six_link_real C_34 = t67 + (c->length * C_54 - link->r_T[0] * C_44);
    const six_link_real C_25 = t63 + (link->r_T[1] * C_45 - c->length * C_65);
    const six_link_real C_35 = t68 + (c->length * C_55 - link->r_T[0] * C_45);
    const six_link_real C_11 = t54 + (link->r_T[0] * C_61 - link->r_T[1] * t69) - L_z1;
    const six_link_real C_12 = t55 + (link->r_T[0] * C_62 - link->r_T[1] * t70) - L_z2;
    const six_link_real C_13 = L_y1 + (t56 + (link->r_T[0] * t73 - link->r_T[1] * C_53));
    const six_link_real C_14 = L_y2 + (t57 + (link->r_T[0] * t74 - link->r_T[1] * C_54));
    const six_link_real C_15 = c->sigma_t_5 + (t58 + (link->r_T[0] * C_65 - link->r_T[1] * C_55));
    const six_link_real C_23 = t61 + (link->r_T[1] * C_43 - c->length * t73) - c->chi_1;
    const six_link_real C_24 = t62 + (link->r_T[1] * C_44 - c->length * t74) - c->chi_2;
    const six_link_real C_31 = c->chi_1 + (t64 + (c->length * t69 - link->r_T[0] * C_41));
    const six_link_real C_32 = c->chi_2 + (t65 + (c->length * t70 - link->r_T[0] * C_42));
    const six_link_real C_51 = c->sigma_y1 + t69;
    const six_link_real C_52 = c->sigma_y2 + t70;
    const six_link_real C_63 = c->sigma_y1 + t73;
    const six_link_real C_64 = c->sigma_y2 + t74;
    const six_link_real modal_inertia_11 = Theta_11 * t54 + Theta_21 * t59 + Theta_31 * t64
        + t69 * SIX_LINK_REAL(2.0195202782688155) + m_eta[0];
    if (!(modal_inertia_11 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modal_inertia_12 = Theta_11 * t55 + Theta_21 * t60 + Theta_31 * t65
        + t70 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_13 = Theta_11 * t56 + Theta_21 * t61 + Theta_31 * t66
        + C_53 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_14 = Theta_11 * t57 + Theta_21 * t62 + Theta_31 * t67
        + C_54 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_15 = Theta_11 * t58 + Theta_21 * t63 + Theta_31 * t68
        + C_55 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_22 = Theta_12 * t55 + Theta_22 * t60 + Theta_32 * t65
        + t70 * SIX_LINK_REAL(2.8145226674626453) + m_eta[1];
    const six_link_real modal_inertia_23 = Theta_12 * t56 + Theta_22 * t61 + Theta_32 * t66
        + C_53 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_24 = Theta_12 * t57 + Theta_22 * t62 + Theta_32 * t67
        + C_54 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_25 = Theta_12 * t58 + Theta_22 * t63 + Theta_32 * t68
        + C_55 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_33 = Theta_13 * t56 + Theta_23 * t61 + Theta_33 * t66
        + t73 * SIX_LINK_REAL(2.0195202782688155) + m_eta[2];
    const six_link_real modal_inertia_34 = Theta_13 * t57 + Theta_23 * t62 + Theta_33 * t67
        + t74 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_35 = Theta_13 * t58 + Theta_23 * t63 + Theta_33 * t68
        + C_65 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_44 = Theta_14 * t57 + Theta_24 * t62 + Theta_34 * t67
        + t74 * SIX_LINK_REAL(2.8145226674626453) + m_eta[3];
    const six_link_real modal_inertia_45 = Theta_14 * t58 + Theta_24 * t63 + Theta_34 * t68
        + C_65 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_55 = Theta_15 * t58 + Theta_25 * t63 + Theta_35 * t68 + m_eta[4];
    const six_link_real t75 = Theta_11 * p_T_tau_x + Theta_21 * p_T_tau_y + Theta_31 * p_T_tau_z
        + p_T_f_y * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t76 = Theta_12 * p_T_tau_x + Theta_22 * p_T_tau_y + Theta_32 * p_T_tau_z
        + p_T_f_y * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t77 = Theta_13 * p_T_tau_x + Theta_23 * p_T_tau_y + Theta_33 * p_T_tau_z
        + p_T_f_z * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t78 = Theta_14 * p_T_tau_x + Theta_24 * p_T_tau_y + Theta_34 * p_T_tau_z
        + p_T_f_z * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real h_phi_1 = h_eta_1 + f_eta[0] + t75;
    const six_link_real h_phi_2 = h_eta_2 + f_eta[1] + t76;
    const six_link_real h_phi_3 = h_eta_3 + f_eta[2] + t77;
    const six_link_real h_phi_4 = h_eta_4 + f_eta[3] + t78;
    const six_link_real h_phi_5 = h_eta_5 + f_eta[4]
        + (Theta_15 * p_T_tau_x + Theta_25 * p_T_tau_y + Theta_35 * p_T_tau_z);
    const six_link_real modes_inverse_1 = 1 / modal_inertia_11;
    const six_link_real modes_L_21 = modal_inertia_12 * modes_inverse_1;
    link->modes_L[0] = modes_L_21;
    const six_link_real modes_L_31 = modal_inertia_13 * modes_inverse_1;
    link->modes_L[1] = modes_L_31;
    const six_link_real modes_L_41 = modal_inertia_14 * modes_inverse_1;
    link->modes_L[3] = modes_L_41;
    const six_link_real modes_L_51 = modal_inertia_15 * modes_inverse_1;
    link->modes_L[6] = modes_L_51;
    const six_link_real t79 = modal_inertia_22 - modal_inertia_12 * modes_L_21;
    if (!(t79 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modes_inverse_2 = 1 / t79;
    const six_link_real t80 = modal_inertia_23 - modal_inertia_12 * modes_L_31;
    const six_link_real modes_L_32 = t80 * modes_inverse_2;
    link->modes_L[2] = modes_L_32;
    const six_link_real t81 = modal_inertia_24 - modal_inertia_12 * modes_L_41;
    const six_link_real modes_L_42 = t81 * modes_inverse_2;
    link->modes_L[4] = modes_L_42;
    const six_link_real t82 = modal_inertia_25 - modal_inertia_12 * modes_L_51;
    const six_link_real modes_L_52 = t82 * modes_inverse_2;
    link->modes_L[7] = modes_L_52;
    const six_link_real t83 = modal_inertia_33 - (modal_inertia_13 * modes_L_31 + t80 * modes_L_32);
    if (!(t83 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modes_inverse_3 = 1 / t83;
    const six_link_real t84 = modal_inertia_34 - (modal_inertia_13 * modes_L_41 + t80 * modes_L_42);
    const six_link_real modes_L_43 = t84 * modes_inverse_3;
    link->modes_L[5] = modes_L_43;
    const six_link_real t85 = modal_inertia_35 - (modal_inertia_13 * modes_L_51 + t80 * modes_L_52);
    const six_link_real modes_L_53 = t85 * modes_inverse_3;
    link->modes_L[8] = modes_L_53;
    const six_link_real t86 = modal_inertia_44 - (modal_inertia_14 * modes_L_41 + t81 * modes_L_42 + t84 * modes_L_43);
    if (!(t86 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modes_inverse_4 = 1 / t86;
    const six_link_real t87 = modal_inertia_45 - (modal_inertia_14 * modes_L_51 + t81 * modes_L_52 + t84 * modes_L_53);
    const six_link_real modes_L_54 = t87 * modes_inverse_4;
    link->modes_L[9] = modes_L_54;
    const six_link_real t88 = modal_inertia_55
        - (modal_inertia_15 * modes_L_51 + t82 * modes_L_52 + t85 * modes_L_53 + t87 * modes_L_54);
    if (!(t88 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modes_inverse_5 = 1 / t88;
    const six_link_real t89 = C_12 - modes_L_21 * C_11;
    const six_link_real t90 = C_22 - modes_L_21 * C_21;
    const six_link_real t91 = C_32 - modes_L_21 * C_31;
    const six_link_real t92 = C_42 - modes_L_21 * C_41;
    const six_link_real t93 = C_52 - modes_L_21 * C_51;
    const six_link_real t94 = C_62 - modes_L_21 * C_61;
    const six_link_real t95 = C_13 - modes_L_31 * C_11 - modes_L_32 * t89;
    const six_link_real t96 = C_23 - modes_L_31 * C_21 - modes_L_32 * t90;
    const six_link_real t97 = C_33 - modes_L_31 * C_31 - modes_L_32 * t91;
    const six_link_real t98 = C_43 - modes_L_31 * C_41 - modes_L_32 * t92;
    const six_link_real t99 = C_53 - modes_L_31 * C_51 - modes_L_32 * t93;
    const six_link_real t100 = C_63 - modes_L_31 * C_61 - modes_L_32 * t94;
    const six_link_real t101 = C_14 - modes_L_41 * C_11 - modes_L_42 * t89 - modes_L_43 * t95;
    const six_link_real t102 = C_24 - modes_L_41 * C_21 - modes_L_42 * t90 - modes_L_43 * t96;
    const six_link_real t103 = C_34 - modes_L_41 * C_31 - modes_L_42 * t91 - modes_L_43 * t97;
    const six_link_real t104 = C_44 - modes_L_41 * C_41 - modes_L_42 * t92 - modes_L_43 * t98;
    const six_link_real t105 = C_54 - modes_L_41 * C_51 - modes_L_42 * t93 - modes_L_43 * t99;
    const six_link_real t106 = C_64 - modes_L_41 * C_61 - modes_L_42 * t94 - modes_L_43 * t100;
    const six_link_real t107 = C_15 - modes_L_51 * C_11 - modes_L_52 * t89 - modes_L_53 * t95 - modes_L_54 * t101;
    const six_link_real t108 = C_25 - modes_L_51 * C_21 - modes_L_52 * t90 - modes_L_53 * t96 - modes_L_54 * t102;
    const six_link_real t109 = C_35 - modes_L_51 * C_31 - modes_L_52 * t91 - modes_L_53 * t97 - modes_L_54 * t103;
    const six_link_real t110 = C_45 - modes_L_51 * C_41 - modes_L_52 * t92 - modes_L_53 * t98 - modes_L_54 * t104;
    const six_link_real t111 = C_55 - modes_L_51 * C_51 - modes_L_52 * t93 - modes_L_53 * t99 - modes_L_54 * t105;
    const six_link_real t112 = C_65 - modes_L_51 * C_61 - modes_L_52 * t94 - modes_L_53 * t100 - modes_L_54 * t106;
    const six_link_real t113 = h_phi_2 - modes_L_21 * h_phi_1;
    const six_link_real t114 = h_phi_3 - modes_L_31 * h_phi_1 - modes_L_32 * t113;
    const six_link_real t115 = h_phi_4 - modes_L_41 * h_phi_1 - modes_L_42 * t113 - modes_L_43 * t114;
    const six_link_real t116 = h_phi_5 - modes_L_51 * h_phi_1 - modes_L_52 * t113 - modes_L_53 * t114
        - modes_L_54 * t115;
    const six_link_real modes_W_11 = C_11 * modes_inverse_1;
    link->modes_W[0] = modes_W_11;
    const six_link_real modes_W_12 = C_21 * modes_inverse_1;
    link->modes_W[1] = modes_W_12;
    const six_link_real modes_W_13 = C_31 * modes_inverse_1;
    link->modes_W[2] = modes_W_13;
    const six_link_real modes_W_14 = C_41 * modes_inverse_1;
    link->modes_W[3] = modes_W_14;
    const six_link_real modes_W_15 = C_51 * modes_inverse_1;
    link->modes_W[4] = modes_W_15;
    const six_link_real modes_W_16 = C_61 * modes_inverse_1;
    link->modes_W[5] = modes_W_16;
    const six_link_real modes_W_21 = t89 * modes_inverse_2;
    link->modes_W[6] = modes_W_21;
    const six_link_real modes_W_22 = t90 * modes_inverse_2;
    link->modes_W[7] = modes_W_22;
    const six_link_real modes_W_23 = t91 * modes_inverse_2;
    link->modes_W[8] = modes_W_23;
    const six_link_real modes_W_24 = t92 * modes_inverse_2;
    link->modes_W[9] = modes_W_24;
    const six_link_real modes_W_25 = t93 * modes_inverse_2;
    link->modes_W[10] = modes_W_25;
    const six_link_real modes_W_26 = t94 * modes_inverse_2;
    link->modes_W[11] = modes_W_26;
    const six_link_real modes_W_31 = t95 * modes_inverse_3;
    link->modes_W[12] = modes_W_31;
    const six_link_real modes_W_32 = t96 * modes_inverse_3;
    link->modes_W[13] = modes_W_32;
    const six_link_real modes_W_33 = t97 * modes_inverse_3;
    link->modes_W[14] = modes_W_33;
    const six_link_real modes_W_34 = t98 * modes_inverse_3;
    link->modes_W[15] = modes_W_34;
    const six_link_real modes_W_35 = t99 * modes_inverse_3;
    link->modes_W[16] = modes_W_35;
    const six_link_real modes_W_36 = t100 * modes_inverse_3;
    link->modes_W[17] = modes_W_36;
    const six_link_real modes_W_41 = t101 * modes_inverse_4;
    link->modes_W[18] = modes_W_41;
    const six_link_real modes_W_42 = t102 * modes_inverse_4;
    link->modes_W[19] = modes_W_42;
    const six_link_real modes_W_43 = t103 * modes_inverse_4;
    link->modes_W[20] = modes_W_43;
    const six_link_real modes_W_44 = t104 * modes_inverse_4;
    link->modes_W[21] = modes_W_44;
    const six_link_real modes_W_45 = t105 * modes_inverse_4;
    link->modes_W[22] = modes_W_45;
    const six_link_real modes_W_46 = t106 * modes_inverse_4;
    link->modes_W[23] = modes_W_46;
    const six_link_real modes_W_51 = t107 * modes_inverse_5;
    link->modes_W[24] = modes_W_51;
    const six_link_real modes_W_52 = t108 * modes_inverse_5;
    link->modes_W[25] = modes_W_52;
    const six_link_real modes_W_53 = t109 * modes_inverse_5;
    link->modes_W[26] = modes_W_53;
    const six_link_real modes_W_54 = t110 * modes_inverse_5;
    link->modes_W[27] = modes_W_54;
    const six_link_real modes_W_55 = t111 * modes_inverse_5;
    link->modes_W[28] = modes_W_55;
    const six_link_real modes_W_56 = t112 * modes_inverse_5;
    link->modes_W[29] = modes_W_56;
    const six_link_real modes_w_1 = h_phi_1 * modes_inverse_1;
    link->modes_w[0] = modes_w_1;
    const six_link_real modes_w_2 = t113 * modes_inverse_2;
    link->modes_w[1] = modes_w_2;
    const six_link_real modes_w_3 = t114 * modes_inverse_3;
    link->modes_w[2] = modes_w_3;
    const six_link_real modes_w_4 = t115 * modes_inverse_4;
    link->modes_w[3] = modes_w_4;
    const six_link_real modes_w_5 = t116 * modes_inverse_5;
    link->modes_w[4] = modes_w_5;
    const six_link_real M_i_11 = M_loaded_11
        - (C_11 * modes_W_11 + t89 * modes_W_21 + t95 * modes_W_31 + t101 * modes_W_41 + t107 * modes_W_51);
    const six_link_real M_i_12 = M_loaded_12
        - (C_11 * modes_W_12 + t89 * modes_W_22 + t95 * modes_W_32 + t101 * modes_W_42 + t107 * modes_W_52);
    const six_link_real M_i_13 = M_loaded_13
        - (C_11 * modes_W_13 + t89 * modes_W_23 + t95 * modes_W_33 + t101 * modes_W_43 + t107 * modes_W_53);
    const six_link_real M_i_14 = M_loaded_14
        - (C_11 * modes_W_14 + t89 * modes_W_24 + t95 * modes_W_34 + t101 * modes_W_44 + t107 * modes_W_54);
    const six_link_real M_i_15 = M_loaded_15
        - (C_11 * modes_W_15 + t89 * modes_W_25 + t95 * modes_W_35 + t101 * modes_W_45 + t107 * modes_W_55);
    const six_link_real M_i_16 = M_loaded_16
        - (C_11 * modes_W_16 + t89 * modes_W_26 + t95 * modes_W_36 + t101 * modes_W_46 + t107 * modes_W_56);
    const six_link_real M_i_22 = M_loaded_22
        - (C_21 * modes_W_12 + t90 * modes_W_22 + t96 * modes_W_32 + t102 * modes_W_42 + t108 * modes_W_52);
    const six_link_real M_i_23 = M_loaded_23
        - (C_21 * modes_W_13 + t90 * modes_W_23 + t96 * modes_W_33 + t102 * modes_W_43 + t108 * modes_W_53);
    const six_link_real M_i_24 = M_loaded_24
        - (C_21 * modes_W_14 + t90 * modes_W_24 + t96 * modes_W_34 + t102 * modes_W_44 + t108 * modes_W_54);
    const six_link_real M_i_25 = M_loaded_25
        - (C_21 * modes_W_15 + t90 * modes_W_25 + t96 * modes_W_35 + t102 * modes_W_45 + t108 * modes_W_55);
    const six_link_real M_i_26 = M_loaded_26
        - (C_21 * modes_W_16 + t90 * modes_W_26 + t96 * modes_W_36 + t102 * modes_W_46 + t108 * modes_W_56);
    const six_link_real M_i_33 = M_loaded_33
        - (C_31 * modes_W_13 + t91 * modes_W_23 + t97 * modes_W_33 + t103 * modes_W_43 + t109 * modes_W_53);
    const six_link_real M_i_34 = M_loaded_34
        - (C_31 * modes_W_14 + t91 * modes_W_24 + t97 * modes_W_34 + t103 * modes_W_44 + t109 * modes_W_54);
    const six_link_real M_i_35 = M_loaded_35
        - (C_31 * modes_W_15 + t91 * modes_W_25 + t97 * modes_W_35 + t103 * modes_W_45 + t109 * modes_W_55);
    const six_link_real M_i_36 = M_loaded_36
        - (C_31 * modes_W_16 + t91 * modes_W_26 + t97 * modes_W_36 + t103 * modes_W_46 + t109 * modes_W_56);
    const six_link_real M_i_44 = M_loaded_44
        - (C_41 * modes_W_14 + t92 * modes_W_24 + t98 * modes_W_34 + t104 * modes_W_44 + t110 * modes_W_54);
    const six_link_real M_i_45 = tip->Lambda[16]
        - (C_41 * modes_W_15 + t92 * modes_W_25 + t98 * modes_W_35 + t104 * modes_W_45 + t110 * modes_W_55);
    const six_link_real M_i_46 = tip->Lambda[17]
        - (C_41 * modes_W_16 + t92 * modes_W_26 + t98 * modes_W_36 + t104 * modes_W_46 + t110 * modes_W_56);
    const six_link_real M_i_55 = M_loaded_55
        - (C_51 * modes_W_15 + t93 * modes_W_25 + t99 * modes_W_35 + t105 * modes_W_45 + t111 * modes_W_55);
    const six_link_real M_i_56 = tip->Lambda[19]
        - (C_51 * modes_W_16 + t93 * modes_W_26 + t99 * modes_W_36 + t105 * modes_W_46 + t111 * modes_W_56);
    const six_link_real M_i_66 = M_loaded_66
        - (C_61 * modes_W_16 + t94 * modes_W_26 + t100 * modes_W_36 + t106 * modes_W_46 + t112 * modes_W_56);
    const six_link_real t117 = modes_W_11 * h_phi_1 + modes_W_21 * t113 + modes_W_31 * t114 + modes_W_41 * t115
        + modes_W_51 * t116;
    const six_link_real t118 = modes_W_12 * h_phi_1 + modes_W_22 * t113 + modes_W_32 * t114 + modes_W_42 * t115
        + modes_W_52 * t116;
    const six_link_real t119 = modes_W_13 * h_phi_1 + modes_W_23 * t113 + modes_W_33 * t114 + modes_W_43 * t115
        + modes_W_53 * t116;
    const six_link_real t120 = modes_W_14 * h_phi_1 + modes_W_24 * t113 + modes_W_34 * t114 + modes_W_44 * t115
        + modes_W_54 * t116;
    const six_link_real t121 = modes_W_15 * h_phi_1 + modes_W_25 * t113 + modes_W_35 * t114 + modes_W_45 * t115
        + modes_W_55 * t116;
    const six_link_real t122 = modes_W_16 * h_phi_1 + modes_W_26 * t113 + modes_W_36 * t114 + modes_W_46 * t115
        + modes_W_56 * t116;
    const six_link_real h_i_tau_x = h_loaded_tau_x - t117;
    const six_link_real h_i_tau_y = h_loaded_tau_y - t118;
    const six_link_real h_i_tau_z = h_loaded_tau_z - t119;
    const six_link_real h_i_f_x = h_loaded_f_x - t120;
    const six_link_real h_i_f_y = h_loaded_f_y - t121;
    const six_link_real h_i_f_z = h_loaded_f_z - t122;

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_11 = M_i_22 + m_q[0];
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8 * (M_i_11 + M_i_22 + M_i_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_i_12 * joint_inverse_1;
    link->joint_W[0] = joint_W_11;
    const six_link_real joint_W_12 = M_i_22 * joint_inverse_1;
    const six_link_real joint_W_13 = M_i_23 * joint_inverse_1;
    link->joint_W[2] = joint_W_13;
    const six_link_real joint_W_14 = M_i_24 * joint_inverse_1;
    link->joint_W[3] = joint_W_14;
    const six_link_real joint_W_15 = M_i_25 * joint_inverse_1;
    link->joint_W[4] = joint_W_15;
    const six_link_real joint_W_16 = M_i_26 * joint_inverse_1;
    link->joint_W[5] = joint_W_16;
    const six_link_real joint_w_1 = (tau[0] - f_q[0] - h_i_tau_y) * joint_inverse_1;
    link->joint_w[0] = joint_w_1;
    const six_link_real Lambda_i_11 = M_i_11 - M_i_12 * joint_W_11;
    link->Lambda_i[0] = Lambda_i_11;
    const six_link_real Lambda_i_12 = M_i_12 - M_i_12 * joint_W_12;
    link->Lambda_i[1] = Lambda_i_12;
    const six_link_real Lambda_i_13 = M_i_13 - M_i_12 * joint_W_13;
    link->Lambda_i[2] = Lambda_i_13;
    const six_link_real Lambda_i_14 = M_i_14 - M_i_12 * joint_W_14;
    link->Lambda_i[3] = Lambda_i_14;
    const six_link_real Lambda_i_15 = M_i_15 - M_i_12 * joint_W_15;
    link->Lambda_i[4] = Lambda_i_15;
    const six_link_real Lambda_i_16 = M_i_16 - M_i_12 * joint_W_16;
    link->Lambda_i[5] = Lambda_i_16;
    const six_link_real Lambda_i_22 = M_i_22 - M_i_22 * joint_W_12;
    const six_link_real Lambda_i_23 = M_i_23 - M_i_22 * joint_W_13;
    link->Lambda_i[7] = Lambda_i_23;
    const six_link_real Lambda_i_24 = M_i_24 - M_i_22 * joint_W_14;
    link->Lambda_i[8] = Lambda_i_24;
    const six_link_real Lambda_i_25 = M_i_25 - M_i_22 * joint_W_15;
    link->Lambda_i[9] = Lambda_i_25;
    const six_link_real Lambda_i_26 = M_i_26 - M_i_22 * joint_W_16;
    link->Lambda_i[10] = Lambda_i_26;
    const six_link_real Lambda_i_33 = M_i_33 - M_i_23 * joint_W_13;
    link->Lambda_i[11] = Lambda_i_33;
    const six_link_real Lambda_i_34 = M_i_34 - M_i_23 * joint_W_14;
    link->Lambda_i[12] = Lambda_i_34;
    const six_link_real Lambda_i_35 = M_i_35 - M_i_23 * joint_W_15;
    link->Lambda_i[13] = Lambda_i_35;
    const six_link_real Lambda_i_36 = M_i_36 - M_i_23 * joint_W_16;
    link->Lambda_i[14] = Lambda_i_36;
    const six_link_real Lambda_i_44 = M_i_44 - M_i_24 * joint_W_14;
    link->Lambda_i[15] = Lambda_i_44;
    const six_link_real Lambda_i_45 = M_i_45 - M_i_24 * joint_W_15;
    link->Lambda_i[16] = Lambda_i_45;
    const six_link_real Lambda_i_46 = M_i_46 - M_i_24 * joint_W_16;
    link->Lambda_i[17] = Lambda_i_46;
    const six_link_real Lambda_i_55 = M_i_55 - M_i_25 * joint_W_15;
    link->Lambda_i[18] = Lambda_i_55;
    base->Lambda[18] = Lambda_i_55;
    const six_link_real Lambda_i_56 = M_i_56 - M_i_25 * joint_W_16;
    link->Lambda_i[19] = Lambda_i_56;
    const six_link_real Lambda_i_66 = M_i_66 - M_i_26 * joint_W_16;
    link->Lambda_i[20] = Lambda_i_66;
    const six_link_real p_i_tau_x = h_i_tau_x + M_i_12 * joint_w_1;
    link->p_i[0] = p_i_tau_x;
    const six_link_real p_i_tau_y = h_i_tau_y + M_i_22 * joint_w_1;
    link->p_i[1] = p_i_tau_y;
    const six_link_real p_i_tau_z = h_i_tau_z + M_i_23 * joint_w_1;
    link->p_i[2] = p_i_tau_z;
    const six_link_real p_i_f_x = h_i_f_x + M_i_24 * joint_w_1;
    link->p_i[3] = p_i_f_x;
    const six_link_real p_i_f_y = h_i_f_y + M_i_25 * joint_w_1;
    link->p_i[4] = p_i_f_y;
    base->p[4] = p_i_f_y;
    const six_link_real p_i_f_z = h_i_f_z + M_i_26 * joint_w_1;
    link->p_i[5] = p_i_f_z;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t123 = link->lever[1] * Lambda_i_45;
    const six_link_real t124 = c->mount_xyz_y * Lambda_i_46;
    const six_link_real t125 = link->lever[0] * Lambda_i_56;
    const six_link_real t126 = Lambda_i_14 + (t124 - t123);
    const six_link_real t127 = Lambda_i_15 + (c->mount_xyz_y * Lambda_i_56 - link->lever[1] * Lambda_i_55);
    const six_link_real t128 = Lambda_i_16 + (c->mount_xyz_y * Lambda_i_66 - link->lever[1] * Lambda_i_56);
    const six_link_real t129 = Lambda_i_24 + (link->lever[1] * Lambda_i_44 - link->lever[0] * Lambda_i_46);
    const six_link_real Lambda_10 = Lambda_i_25 + (t123 - t125);
    base->Lambda[9] = Lambda_10;
    const six_link_real t130 = Lambda_i_26 + (link->lever[1] * Lambda_i_46 - link->lever[0] * Lambda_i_66);
    const six_link_real t131 = Lambda_i_34 + (link->lever[0] * Lambda_i_45 - c->mount_xyz_y * Lambda_i_44);
    const six_link_real t132 = Lambda_i_35 + (link->lever[0] * Lambda_i_55 - c->mount_xyz_y * Lambda_i_45);
    const six_link_real t133 = Lambda_i_36 + (t125 - t124);
    const six_link_real t134 = Lambda_i_11 - (Lambda_i_15 * link->lever[1] - Lambda_i_16 * c->mount_xyz_y)
        + (c->mount_xyz_y * t128 - link->lever[1] * t127);
    const six_link_real t135 = Lambda_i_12 - (Lambda_i_16 * link->lever[0] - Lambda_i_14 * link->lever[1])
        + (c->mount_xyz_y * t130 - link->lever[1] * Lambda_10);
    const six_link_real t136 = Lambda_i_13 - (Lambda_i_14 * c->mount_xyz_y - Lambda_i_15 * link->lever[0])
        + (c->mount_xyz_y * t133 - link->lever[1] * t132);
    const six_link_real Lambda_7 = Lambda_i_22 - (Lambda_i_26 * link->lever[0] - Lambda_i_24 * link->lever[1])
        + (link->lever[1] * t129 - link->lever[0] * t130);
    base->Lambda[6] = Lambda_7;
    const six_link_real t137 = Lambda_i_23 - (Lambda_i_24 * c->mount_xyz_y - Lambda_i_25 * link->lever[0])
        + (link->lever[1] * t131 - link->lever[0] * t133);
    const six_link_real t138 = Lambda_i_33 - (Lambda_i_34 * c->mount_xyz_y - Lambda_i_35 * link->lever[0])
        + (link->lever[0] * t132 - c->mount_xyz_y * t131);
    const six_link_real t139 = (t134 - t138) * SIX_LINK_REAL(0.5);
    const six_link_real t140 = t139 * link->R_P[0] + t136 * link->R_P[2];
    const six_link_real t141 = t139 * link->R_P[6] + t136 * link->R_P[8];
    const six_link_real Lambda_1 = link->R_P[0] * t140 * 2 + t138;
    base->Lambda[0] = Lambda_1;
    const six_link_real Lambda_3 = link->R_P[0] * t141 + link->R_P[6] * t140;
    base->Lambda[2] = Lambda_3;
    const six_link_real Lambda_8 = t137 * link->R_P[8] + link->R_P[6] * t135;
    base->Lambda[7] = Lambda_8;
    const six_link_real Lambda_12 = link->R_P[6] * t141 * 2 + t138;
    base->Lambda[11] = Lambda_12;
    const six_link_real Lambda_11 = t129 * link->R_P[6] + t130 * link->R_P[8];
    base->Lambda[10] = Lambda_11;
    const six_link_real Lambda_5 = link->R_P[0] * t127 + link->R_P[2] * t132;
    base->Lambda[4] = Lambda_5;
    const six_link_real Lambda_13 = link->R_P[6] * (t126 * link->R_P[0] + t128 * link->R_P[2])
        + link->R_P[8] * (t131 * link->R_P[0] + t133 * link->R_P[2]);
    base->Lambda[12] = Lambda_13;
    const six_link_real Lambda_14 = link->R_P[6] * t127 + link->R_P[8] * t132;
    base->Lambda[13] = Lambda_14;
    const six_link_real Lambda_15 = link->R_P[6] * (t126 * link->R_P[6] + t128 * link->R_P[8])
        + link->R_P[8] * (t131 * link->R_P[6] + t133 * link->R_P[8]);
    base->Lambda[14] = Lambda_15;
    const six_link_real Lambda_17 = link->R_P[0] * Lambda_i_45 + Lambda_i_56 * link->R_P[2];
    base->Lambda[16] = Lambda_17;
    const six_link_real Lambda_20 = Lambda_i_56 * link->R_P[8] + link->R_P[6] * Lambda_i_45;
    base->Lambda[19] = Lambda_20;
    const six_link_real t142 = link->R_P[6]
        * ((Lambda_i_44 - Lambda_i_66) * SIX_LINK_REAL(0.5) * link->R_P[6] + Lambda_i_46 * link->R_P[8]);
    const six_link_real Lambda_21 = t142 * 2 + Lambda_i_66;
    base->Lambda[20] = Lambda_21;
    const six_link_real t143 = p_i_tau_x + (c->mount_xyz_y * p_i_f_z - link->lever[1] * p_i_f_y);
    const six_link_real p_tau_y = p_i_tau_y + (link->lever[1] * p_i_f_x - link->lever[0] * p_i_f_z);
    base->p[1] = p_tau_y;
    const six_link_real t144 = p_i_tau_z + (link->lever[0] * p_i_f_y - c->mount_xyz_y * p_i_f_x);
    const six_link_real p_tau_x = link->R_P[0] * t143 + link->R_P[2] * t144;
    base->p[0] = p_tau_x;
    const six_link_real p_tau_z = link->R_P[6] * t143 + link->R_P[8] * t144;
    base->p[2] = p_tau_z;
    const six_link_real p_f_x = link->R_P[0] * p_i_f_x + link->R_P[2] * p_i_f_z;
    base->p[3] = p_f_x;
    const six_link_real p_f_z = link->R_P[6] * p_i_f_x + link->R_P[8] * p_i_f_z;
    base->p[5] = p_f_z;
    return SIX_LINK_OK;
}

/* eliminate, links like forearm: 1486 operations */
SIX_LINK_PART six_link_status eliminate_forearm(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, six_link_node *restrict base, const six_link_node *restrict tip,
    const six_link_real eta[restrict 4], const six_link_real etadot[restrict 4], const six_link_real w_ext[restrict 6],
    const six_link_real m_eta[restrict 4], const six_link_real f_eta[restrict 4], const six_link_real m_q[restrict 1],
    const six_link_real f_q[restrict 1], const six_link_real tau[restrict 1])
{
    /* S: first moment */
    const six_link_real S_y = c->S_B_y + eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2;
    const six_link_real S_z = c->S_B_z + eta[2] * c->sigma_y1 + eta[3] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const six_link_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2;
    const six_link_real Sdot_z = etadot[2] * c->sigma_y1 + etadot[3] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->mu * eta[0];
    const six_link_real L_y2 = c->mu * eta[1];
    const six_link_real L_z1 = eta[2] * c->mu;
    const six_link_real L_z2 = eta[3] * c->mu;

    /* Ldot: rate of L */
    const six_link_real Ldot_y1 = c->mu * etadot[0];
    const six_link_real Ldot_y2 = c->mu * etadot[1];
    const six_link_real Ldot_z1 = etadot[2] * c->mu;
    const six_link_real Ldot_z2 = etadot[3] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->J_B_xy + c->chi_1 * eta[0] + c->chi_2 * eta[1];
    const six_link_real J_xz = c->J_B_xz + c->chi_1 * eta[2] + c->chi_2 * eta[3];
    const six_link_real J_yy = c->J_B_yy + L_y1 * eta[0] + L_y2 * eta[1];
    const six_link_real J_yz = c->J_B_yz + L_z1 * eta[0] + L_z2 * eta[1];
    const six_link_real J_zz = c->J_B_zz + L_z1 * eta[2] + L_z2 * eta[3];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const six_link_real t1 = link->omega[1] * link->omega[1];
    const six_link_real t2 = link->omega[2] * link->omega[2];
    const six_link_real minus_Omega_xx = t1 + t2;
    const six_link_real t3 = link->omega[0] * link->omega[1];
    const six_link_real Omega_xy = t3 - link->acc_0[2];
    const six_link_real t4 = link->omega[0] * link->omega[2];
    const six_link_real Omega_xz = link->acc_0[1] + t4;
    const six_link_real Omega_yx = link->acc_0[2] + t3;
    const six_link_real t5 = link->omega[0] * link->omega[0];
    const six_link_real minus_Omega_yy = t5 + t2;
    const six_link_real t6 = link->omega[1] * link->omega[2];
    const six_link_real Omega_yz = t6 - link->acc_0[0];
    const six_link_real Omega_zx = t4 - link->acc_0[1];
    const six_link_real Omega_zy = link->acc_0[0] + t6;
    const six_link_real minus_Omega_zz = t5 + t1;

    /* B: moment of the elastic velocity */
    const six_link_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1];
    const six_link_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1];
    const six_link_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1];
    const six_link_real B_zx = c->chi_1 * etadot[2] + c->chi_2 * etadot[3];
    const six_link_real B_zy = L_y1 * etadot[2] + L_y2 * etadot[3];
    const six_link_real B_zz = L_z1 * etadot[2] + L_z2 * etadot[3];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const six_link_real h_c_tau_x = B_yy * link->omega[0] + B_zz * link->omega[0];
    const six_link_real h_c_tau_y = B_zz * link->omega[1] - B_yx * link->omega[0] - B_yz * link->omega[2];
    const six_link_real h_c_tau_z = B_yy * link->omega[2] - B_zx * link->omega[0] - B_zy * link->omega[1];
    const six_link_real h_c_f_x = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
    const six_link_real minus_h_c_f_y = Sdot_z * link->omega[0];
    const six_link_real h_c_f_z = Sdot_y * link->omega[0];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real t7 = h_c_tau_x + c->I_s * link->acc_0[0] + J_xy * Omega_zx + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const six_link_real H_star_tau_x = t7 + S_y * link->acc_0[5] - J_xz * Omega_yx - J_zz * Omega_yz
        - S_z * link->acc_0[4];
    const six_link_real t8 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->acc_0[3];
    const six_link_real t9 = c->I_s * link->omega[0];
    const six_link_real H_star_tau_y = t8 + t9 * link->omega[2] - c->J_0_xx * Omega_zx - J_xy * Omega_zy
        - c->S_0_x * link->acc_0[5];
    const six_link_real t10 = h_c_tau_z + c->J_0_xx * Omega_yx + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * link->acc_0[4];
    const six_link_real H_star_tau_z = t10 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->acc_0[3]
        - t9 * link->omega[1];
    const six_link_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + link->acc_0[3] * c->m;
    const six_link_real H_star_f_y = Omega_yx * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + link->acc_0[4] * c->m;
    const six_link_real H_star_f_z = h_c_f_z + Omega_zx * c->S_0_x + Omega_zy * S_y - minus_Omega_zz * S_z
        + link->acc_0[5] * c->m;

    /* h_V: bias of the twist rows, angular acceleration included */
    const six_link_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const six_link_real h_V_tau_y = H_star_tau_y + h_c_tau_y;
    const six_link_real h_V_tau_z = H_star_tau_z + h_c_tau_z;
    const six_link_real h_V_f_x = H_star_f_x + h_c_f_x;
    const six_link_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const six_link_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const six_link_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_yx * c->chi_1
        + link->acc_0[4] * c->sigma_y1 - Ldot_z1 * 2 * link->omega[0];
    const six_link_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_yx * c->chi_2
        + link->acc_0[4] * c->sigma_y2 - Ldot_z2 * 2 * link->omega[0];
    const six_link_real h_eta_3 = L_y1 * Omega_zy - L_z1 * minus_Omega_zz + Omega_zx * c->chi_1
        + link->acc_0[5] * c->sigma_y1 + Ldot_y1 * 2 * link->omega[0];
    const six_link_real h_eta_4 = L_y2 * Omega_zy - L_z2 * minus_Omega_zz + Omega_zx * c->chi_2
        + link->acc_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_tau_x = tip->p[0]
        - (link->R_T[0] * w_ext[0] - link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2]);
    const six_link_real p_T_tau_y = tip->p[1]
        - (link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1] + link->R_T[4] * w_ext[2]);
    const six_link_real p_T_tau_z = tip->p[2]
        - (link->R_T[4] * w_ext[1] - link->R_T[2] * w_ext[0] + link->R_T[5] * w_ext[2]);
    const six_link_real p_T_f_x = tip->p[3]
        - (link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const six_link_real p_T_f_y = tip->p[4]
        - (link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5]);
    const six_link_real p_T_f_z = tip->p[5]
        - (link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5]);

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real Theta_11 = link->J_l[2] * c->Psi_c_z1;
    const six_link_real Theta_12 = link->J_l[2] * c->Psi_c_z2;
    const six_link_real minus_Theta_13 = link->J_l[1] * c->Psi_c_y3;
    const six_link_real minus_Theta_14 = link->J_l[1] * c->Psi_c_y4;
    const six_link_real Theta_21 = link->J_l[4] * c->Psi_c_z1;
    const six_link_real Theta_22 = link->J_l[4] * c->Psi_c_z2;
    const six_link_real Theta_23 = link->J_l[3] * c->Psi_c_y3;
    const six_link_real Theta_24 = link->J_l[3] * c->Psi_c_y4;
    const six_link_real Theta_31 = link->J_l[5] * c->Psi_c_z1;
    const six_link_real Theta_32 = link->J_l[5] * c->Psi_c_z2;
    const six_link_real Theta_33 = link->J_l[4] * c->Psi_c_y3;
    const six_link_real Theta_34 = link->J_l[4] * c->Psi_c_y4;
    const six_link_real t11 = link->r_T[1] * tip->Lambda[16];
    const six_link_real t12 = link->r_T[0] * tip->Lambda[17];
    const six_link_real t13 = c->length * tip->Lambda[19];
    const six_link_real M_loaded_14 = tip->Lambda[3] + (t12 - t11);
    const six_link_real t14 = tip->Lambda[4] + (link->r_T[0] * tip->Lambda[19] - link->r_T[1] * tip->Lambda[18]);
    const six_link_real t15 = tip->Lambda[5] + (link->r_T[0] * tip->Lambda[20] - link->r_T[1] * tip->Lambda[19]);
    const six_link_real t16 = tip->Lambda[8] + (link->r_T[1] * tip->Lambda[15] - c->length * tip->Lambda[17]);
    const six_link_real M_loaded_25 = tip->Lambda[9] + (t11 - t13);
    const six_link_real t17 = tip->Lambda[10] + (link->r_T[1] * tip->Lambda[17] - c->length * tip->Lambda[20]);
    const six_link_real t18 = tip->Lambda[12] + (c->length * tip->Lambda[16] - link->r_T[0] * tip->Lambda[15]);
    const six_link_real t19 = tip->Lambda[13] + (c->length * tip->Lambda[18] - link->r_T[0] * tip->Lambda[16]);
    const six_link_real M_loaded_36 = tip->Lambda[14] + (t13 - t12);
    const six_link_real t20 = tip->Lambda[0] - (tip->Lambda[4] * link->r_T[1] - tip->Lambda[5] * link->r_T[0])
        + (link->r_T[0] * t15 - link->r_T[1] * t14);
    const six_link_real t21 = tip->Lambda[1] - (tip->Lambda[5] * c->length - tip->Lambda[3] * link->r_T[1])
        + (link->r_T[0] * t17 - link->r_T[1] * M_loaded_25);
    const six_link_real t22 = tip->Lambda[2] - (tip->Lambda[3] * link->r_T[0] - tip->Lambda[4] * c->length)
        + (link->r_T[0] * M_loaded_36 - link->r_T[1] * t19);
    const six_link_real t23 = tip->Lambda[6] - (tip->Lambda[10] * c->length - tip->Lambda[8] * link->r_T[1])
        + (link->r_T[1] * t16 - c->length * t17);
    const six_link_real t24 = tip->Lambda[7] - (tip->Lambda[8] * link->r_T[0] - tip->Lambda[9] * c->length)
        + (link->r_T[1] * t18 - c->length * M_loaded_36);
    const six_link_real t25 = tip->Lambda[11] - (tip->Lambda[12] * link->r_T[0] - tip->Lambda[13] * c->length)
        + (c->length * t19 - link->r_T[0] * t18);
    const six_link_real M_loaded_11 = I_xx + t20;
    const six_link_real M_loaded_12 = t21 - J_xy;
    const six_link_real M_loaded_13 = t22 - J_xz;
    const six_link_real M_loaded_15 = t14 - S_z;
    const six_link_real M_loaded_16 = S_y + t15;
    const six_link_real M_loaded_22 = I_yy + t23;
    const six_link_real M_loaded_23 = t24 - J_yz;
    const six_link_real M_loaded_24 = S_z + t16;
    const six_link_real M_loaded_26 = t17 - c->S_0_x;
    const six_link_real M_loaded_33 = I_zz + t25;
    const six_link_real M_loaded_34 = t18 - S_y;
    const six_link_real M_loaded_35 = c->S_0_x + t19;
    const six_link_real M_loaded_44 = c->m + tip->Lambda[15];
    const six_link_real M_loaded_55 = c->m + tip->Lambda[18];
    const six_link_real M_loaded_66 = c->m + tip->Lambda[20];
    const six_link_real h_loaded_tau_x = h_V_tau_x + (p_T_tau_x + (link->r_T[0] * p_T_f_z - link->r_T[1] * p_T_f_y));
    const six_link_real h_loaded_tau_y = h_V_tau_y + (p_T_tau_y + (link->r_T[1] * p_T_f_x - c->length * p_T_f_z));
    const six_link_real h_loaded_tau_z = h_V_tau_z + (p_T_tau_z + (c->length * p_T_f_y - link->r_T[0] * p_T_f_x));
    const six_link_real h_loaded_f_x = h_V_f_x + p_T_f_x;
    const six_link_real h_loaded_f_y = h_V_f_y + p_T_f_y;
    const six_link_real h_loaded_f_z = h_V_f_z + p_T_f_z;
    const six_link_real t26 = tip->Lambda[0] * Theta_11 + tip->Lambda[1] * Theta_21 + tip->Lambda[2] * Theta_31
        + tip->Lambda[4] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t27 = tip->Lambda[0] * Theta_12 + tip->Lambda[1] * Theta_22 + tip->Lambda[2] * Theta_32
        + tip->Lambda[4] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t28 = tip->Lambda[1] * Theta_23 - tip->Lambda[0] * minus_Theta_13 + tip->Lambda[2] * Theta_33
        + tip->Lambda[5] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t29 = tip->Lambda[1] * Theta_24 - tip->Lambda[0] * minus_Theta_14 + tip->Lambda[2] * Theta_34
        + tip->Lambda[5] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t30 = tip->Lambda[1] * Theta_11 + tip->Lambda[6] * Theta_21 + tip->Lambda[7] * Theta_31
        + tip->Lambda[9] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t31 = tip->Lambda[1] * Theta_12 + tip->Lambda[6] * Theta_22 + tip->Lambda[7] * Theta_32
        + tip->Lambda[9] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t32 = tip->Lambda[6] * Theta_23 - tip->Lambda[1] * minus_Theta_13 + tip->Lambda[7] * Theta_33
        + tip->Lambda[10] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t33 = tip->Lambda[6] * Theta_24 - tip->Lambda[1] * minus_Theta_14 + tip->Lambda[7] * Theta_34
        + tip->Lambda[10] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t34 = tip->Lambda[2] * Theta_11 + tip->Lambda[7] * Theta_21 + tip->Lambda[11] * Theta_31
        + tip->Lambda[13] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t35 = tip->Lambda[2] * Theta_12 + tip->Lambda[7] * Theta_22 + tip->Lambda[11] * Theta_32
        + tip->Lambda[13] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t36 = tip->Lambda[7] * Theta_23 - tip->Lambda[2] * minus_Theta_13 + tip->Lambda[11] * Theta_33
        + tip->Lambda[14] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t37 = tip->Lambda[7] * Theta_24 - tip->Lambda[2] * minus_Theta_14 + tip->Lambda[11] * Theta_34
        + tip->Lambda[14] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_41 = tip->Lambda[3] * Theta_11 + tip->Lambda[8] * Theta_21 + tip->Lambda[12] * Theta_31
        + tip->Lambda[16] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real C_42 = tip->Lambda[3] * Theta_12 + tip->Lambda[8] * Theta_22 + tip->Lambda[12] * Theta_32
        + tip->Lambda[16] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_43 = tip->Lambda[8] * Theta_23 - tip->Lambda[3] * minus_Theta_13
        + tip->Lambda[12] * Theta_33 + tip->Lambda[17] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real C_44 = tip->Lambda[8] * Theta_24 - tip->Lambda[3] * minus_Theta_14
        + tip->Lambda[12] * Theta_34 + tip->Lambda[17] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t38 = tip->Lambda[4] * Theta_11 + tip->Lambda[9] * Theta_21 + tip->Lambda[13] * Theta_31
        + tip->Lambda[18] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t39 = tip->Lambda[4] * Theta_12 + tip->Lambda[9] * Theta_22 + tip->Lambda[13] * Theta_32
        + tip->Lambda[18] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t40 = tip->Lambda[19] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real C_53 = tip->Lambda[9] * Theta_23 - tip->Lambda[4] * minus_Theta_13
        + tip->Lambda[13] * Theta_33 + t40;
    const six_link_real t41 = tip->Lambda[19] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_54 = tip->Lambda[9] * Theta_24 - tip->Lambda[4] * minus_Theta_14
        + tip->Lambda[13] * Theta_34 + t41;
    const six_link_real C_61 = tip->Lambda[5] * Theta_11 + tip->Lambda[10] * Theta_21 + tip->Lambda[14] * Theta_31
        + t40;
    const six_link_real C_62 = tip->Lambda[5] * Theta_12 + tip->Lambda[10] * Theta_22 + tip->Lambda[14] * Theta_32
        + t41;
    const six_link_real t42 = tip->Lambda[10] * Theta_23 - tip->Lambda[5] * minus_Theta_13
        + tip->Lambda[14] * Theta_33 + tip->Lambda[20] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t43 = tip->Lambda[10] * Theta_24 - tip->Lambda[5] * minus_Theta_14
        + tip->Lambda[14] * Theta_34 + tip->Lambda[20] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_21 = t30 + (link->r_T[1] * C_41 - c->length * C_61);
    const six_link_real C_22 = t31 + (link->r_T[1] * C_42 - c->length * C_62);
    const six_link_real C_33 = t36 + (c->length * C_53 - link->r_T[0] * C_43);
    const six_link_real C_34 = t37 + (c->length * C_54 - link->r_T[0] * C_44);
    const six_link_real C_11 = t26 + (link->r_T[0] * C_61 - link->r_T[1] * t38) - L_z1;
    const six_link_real C_12 = t27 + (link->r_T[0] * C_62 - link->r_T[1] * t39) - L_z2;
    const six_link_real C_13 = L_y1 + (t28 + (link->r_T[0] * t42 - link->r_T[1] * C_53));
    const six_link_real C_14 = L_y2 + (t29 + (link->r_T[0] * t43 - link->r_T[1] * C_54));
    const six_link_real C_23 = t32 + (link->r_T[1] * C_43 - c->length * t42) - c->chi_1;
    const six_link_real C_24 = t33 + (link->r_T[1] * C_44 - c->length * t43) - c->chi_2;
    const six_link_real C_31 = c->chi_1 + (t34 + (c->length * t38 - link->r_T[0] * C_41));
    const six_link_real C_32 = c->chi_2 + (t35 + (c->length * t39 - link->r_T[0] * C_42));
    const six_link_real C_51 = c->sigma_y1 + t38;
    const six_link_real C_52 = c->sigma_y2 + t39;
    const six_link_real C_63 = c->sigma_y1 + t42;
    const six_link_real C_64 = c->sigma_y2 + t43;
    const six_link_real modal_inertia_11 = Theta_11 * t26 + Theta_21 * t30 + Theta_31 * t34
        + t38 * SIX_LINK_REAL(2.0195202782688155) + m_eta[0];
    if (!(modal_inertia_11 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modal_inertia_12 = Theta_11 * t27 + Theta_21 * t31 + Theta_31 * t35
        + t39 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_13 = Theta_11 * t28 + Theta_21 * t32 + Theta_31 * t36
        + C_53 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_14 = Theta_11 * t29 + Theta_21 * t33 + Theta_31 * t37
        + C_54 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_22 = Theta_12 * t27 + Theta_22 * t31 + Theta_32 * t35
        + t39 * SIX_LINK_REAL(2.8145226674626453) + m_eta[1];
    const six_link_real modal_inertia_23 = Theta_12 * t28 + Theta_22 * t32 + Theta_32 * t36
        + C_53 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_24 = Theta_12 * t29 + Theta_22 * t33 + Theta_32 * t37
        + C_54 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_33 = Theta_23 * t32 - minus_Theta_13 * t28 + Theta_33 * t36
        + t42 * SIX_LINK_REAL(2.0195202782688155) + m_eta[2];
    const six_link_real modal_inertia_34 = Theta_23 * t33 - minus_Theta_13 * t29 + Theta_33 * t37
        + t43 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_44 = Theta_24 * t33 - minus_Theta_14 * t29 + Theta_34 * t37
        + t43 * SIX_LINK_REAL(2.8145226674626453) + m_eta[3];
    const six_link_real t44 = Theta_11 * p_T_tau_x + Theta_21 * p_T_tau_y + Theta_31 * p_T_tau_z
        + p_T_f_y * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t45 = Theta_12 * p_T_tau_x + Theta_22 * p_T_tau_y + Theta_32 * p_T_tau_z
        + p_T_f_y * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t46 = Theta_23 * p_T_tau_y - minus_Theta_13 * p_T_tau_x + Theta_33 * p_T_tau_z
        + p_T_f_z * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t47 = Theta_24 * p_T_tau_y - minus_Theta_14 * p_T_tau_x + Theta_34 * p_T_tau_z
        + p_T_f_z * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real h_phi_1 = h_eta_1 + f_eta[0] + t44;
    const six_link_real h_phi_2 = h_eta_2 + f_eta[1] + t45;
    const six_link_real h_phi_3 = h_eta_3 + f_eta[2] + t46;
    const six_link_real h_phi_4 = h_eta_4 + f_eta[3] + t47;
    const six_link_real modes_inverse_1 = 1 / modal_inertia_11;
    const six_link_real modes_L_21 = modal_inertia_12 * modes_inverse_1;
    link->modes_L[0] = modes_L_21;
    const six_link_real modes_L_31 = modal_inertia_13 * modes_inverse_1;
    link->modes_L[1] = modes_L_31;
    const six_link_real modes_L_41 = modal_inertia_14 * modes_inverse_1;
    link->modes_L[3] = modes_L_41;
    const six_link_real t48 = modal_inertia_22 - modal_inertia_12 * modes_L_21;
    if (!(t48 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modes_inverse_2 = 1 / t48;
    const six_link_real t49 = modal_inertia_23 - modal_inertia_12 * modes_L_31;
    const six_link_real modes_L_32 = t49 * modes_inverse_2;
    link->modes_L[2] = modes_L_32;
    const six_link_real t50 = modal_inertia_24 - modal_inertia_12 * modes_L_41;
    const six_link_real modes_L_42 = t50 * modes_inverse_2;
    link->modes_L[4] = modes_L_42;
    const six_link_real t51 = modal_inertia_33 - (modal_inertia_13 * modes_L_31 + t49 * modes_L_32);
    if (!(t51 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modes_inverse_3 = 1 / t51;
    const six_link_real t52 = modal_inertia_34 - (modal_inertia_13 * modes_L_41 + t49 * modes_L_42);
    const six_link_real modes_L_43 = t52 * modes_inverse_3;
    link->modes_L[5] = modes_L_43;
    const six_link_real t53 = modal_inertia_44 - (modal_inertia_14 * modes_L_41 + t50 * modes_L_42 + t52 * modes_L_43);
    if (!(t53 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modes_inverse_4 = 1 / t53;
    const six_link_real t54 = C_12 - modes_L_21 * C_11;
    const six_link_real t55 = C_22 - modes_L_21 * C_21;
    const six_link_real t56 = C_32 - modes_L_21 * C_31;
    const six_link_real t57 = C_42 - modes_L_21 * C_41;
    const six_link_real t58 = C_52 - modes_L_21 * C_51;
    const six_link_real t59 = C_62 - modes_L_21 * C_61;
    const six_link_real t60 = C_13 - modes_L_31 * C_11 - modes_L_32 * t54;
    const six_link_real t61 = C_23 - modes_L_31 * C_21 - modes_L_32 * t55;
    const six_link_real t62 = C_33 - modes_L_31 * C_31 - modes_L_32 * t56;
    const six_link_real t63 = C_43 - modes_L_31 * C_41 - modes_L_32 * t57;
    const six_link_real t64 = C_53 - modes_L_31 * C_51 - modes_L_32 * t58;
    const six_link_real t65 = C_63 - modes_L_31 * C_61 - modes_L_32 * t59;
    const six_link_real t66 = C_14 - modes_L_41 * C_11 - modes_L_42 * t54 - modes_L_43 * t60;
    const six_link_real t67 = C_24 - modes_L_41 * C_21 - modes_L_42 * t55 - modes_L_43 * t61;
    const six_link_real t68 = C_34 - modes_L_41 * C_31 - modes_L_42 * t56 - modes_L_43 * t62;
    const six_link_real t69 = C_44 - modes_L_41 * C_41 - modes_L_42 * t57 - modes_L_43 * t63;
    const six_link_real t70 = C_54 - modes_L_41 * C_51 - modes_L_42 * t58 - modes_L_43 * t64;
    const six_link_real t71 = C_64 - modes_L_41 * C_61 - modes_L_42 * t59 - modes_L_43 * t65;
    const six_link_real t72 = h_phi_2 - modes_L_21 * h_phi_1;
    const six_link_real t73 = h_phi_3 - modes_L_31 * h_phi_1 - modes_L_32 * t72;
    const six_link_real t74 = h_phi_4 - modes_L_41 * h_phi_1 - modes_L_42 * t72 - modes_L_43 * t73;
    const six_link_real modes_W_11 = C_11 * modes_inverse_1;
    link->modes_W[0] = modes_W_11;
    const six_link_real modes_W_12 = C_21 * modes_inverse_1;
    link->modes_W[1] = modes_W_12;
    const six_link_real modes_W_13 = C_31 * modes_inverse_1;
    link->modes_W[2] = modes_W_13;
    const six_link_real modes_W_14 = C_41 * modes_inverse_1;
    link->modes_W[3] = modes_W_14;
    const six_link_real modes_W_15 = C_51 * modes_inverse_1;
    link->modes_W[4] = modes_W_15;
    const six_link_real modes_W_16 = C_61 * modes_inverse_1;
    link->modes_W[5] = modes_W_16;
    const six_link_real modes_W_21 = t54 * modes_inverse_2;
    link->modes_W[6] = modes_W_21;
    const six_link_real modes_W_22 = t55 * modes_inverse_2;
    link->modes_W[7] = modes_W_22;
    const six_link_real modes_W_23 = t56 * modes_inverse_2;
    link->modes_W[8] = modes_W_23;
    const six_link_real modes_W_24 = t57 * modes_inverse_2;
    link->modes_W[9] = modes_W_24;
    const six_link_real modes_W_25 = t58 * modes_inverse_2;
    link->modes_W[10] = modes_W_25;
    const six_link_real modes_W_26 = t59 * modes_inverse_2;
    link->modes_W[11] = modes_W_26;
    const six_link_real modes_W_31 = t60 * modes_inverse_3;
    link->modes_W[12] = modes_W_31;
    const six_link_real modes_W_32 = t61 * modes_inverse_3;
    link->modes_W[13] = modes_W_32;
    const six_link_real modes_W_33 = t62 * modes_inverse_3;
    link->modes_W[14] = modes_W_33;
    const six_link_real modes_W_34 = t63 * modes_inverse_3;
    link->modes_W[15] = modes_W_34;
    const six_link_real modes_W_35 = t64 * modes_inverse_3;
    link->modes_W[16] = modes_W_35;
    const six_link_real modes_W_36 = t65 * modes_inverse_3;
    link->modes_W[17] = modes_W_36;
    const six_link_real modes_W_41 = t66 * modes_inverse_4;
    link->modes_W[18] = modes_W_41;
    const six_link_real modes_W_42 = t67 * modes_inverse_4;
    link->modes_W[19] = modes_W_42;
    const six_link_real modes_W_43 = t68 * modes_inverse_4;
    link->modes_W[20] = modes_W_43;
    const six_link_real modes_W_44 = t69 * modes_inverse_4;
    link->modes_W[21] = modes_W_44;
    const six_link_real modes_W_45 = t70 * modes_inverse_4;
    link->modes_W[22] = modes_W_45;
    const six_link_real modes_W_46 = t71 * modes_inverse_4;
    link->modes_W[23] = modes_W_46;
    const six_link_real modes_w_1 = h_phi_1 * modes_inverse_1;
    link->modes_w[0] = modes_w_1;
    const six_link_real modes_w_2 = t72 * modes_inverse_2;
    link->modes_w[1] = modes_w_2;
    const six_link_real modes_w_3 = t73 * modes_inverse_3;
    link->modes_w[2] = modes_w_3;
    const six_link_real modes_w_4 = t74 * modes_inverse_4;
    link->modes_w[3] = modes_w_4;
    const six_link_real M_i_11 = M_loaded_11
        - (C_11 * modes_W_11 + t54 * modes_W_21 + t60 * modes_W_31 + t66 * modes_W_41);
    const six_link_real M_i_12 = M_loaded_12
        - (C_11 * modes_W_12 + t54 * modes_W_22 + t60 * modes_W_32 + t66 * modes_W_42);
    const six_link_real M_i_13 = M_loaded_13
        - (C_11 * modes_W_13 + t54 * modes_W_23 + t60 * modes_W_33 + t66 * modes_W_43);
    const six_link_real M_i_14 = M_loaded_14
        - (C_11 * modes_W_14 + t54 * modes_W_24 + t60 * modes_W_34 + t66 * modes_W_44);
    const six_link_real M_i_15 = M_loaded_15
        - (C_11 * modes_W_15 + t54 * modes_W_25 + t60 * modes_W_35 + t66 * modes_W_45);
    const six_link_real M_i_16 = M_loaded_16
        - (C_11 * modes_W_16 + t54 * modes_W_26 + t60 * modes_W_36 + t66 * modes_W_46);
    const six_link_real M_i_22 = M_loaded_22
        - (C_21 * modes_W_12 + t55 * modes_W_22 + t61 * modes_W_32 + t67 * modes_W_42);
    const six_link_real M_i_23 = M_loaded_23
        - (C_21 * modes_W_13 + t55 * modes_W_23 + t61 * modes_W_33 + t67 * modes_W_43);
    const six_link_real M_i_24 = M_loaded_24
        - (C_21 * modes_W_14 + t55 * modes_W_24 + t61 * modes_W_34 + t67 * modes_W_44);
    const six_link_real M_i_25 = M_loaded_25
        - (C_21 * modes_W_15 + t55 * modes_W_25 + t61 * modes_W_35 + t67 * modes_W_45);
    const six_link_real M_i_26 = M_loaded_26
        - (C_21 * modes_W_16 + t55 * modes_W_26 + t61 * modes_W_36 + t67 * modes_W_46);
    const six_link_real M_i_33 = M_loaded_33
        - (C_31 * modes_W_13 + t56 * modes_W_23 + t62 * modes_W_33 + t68 * modes_W_43);
    const six_link_real M_i_34 = M_loaded_34
        - (C_31 * modes_W_14 + t56 * modes_W_24 + t62 * modes_W_34 + t68 * modes_W_44);
    const six_link_real M_i_35 = M_loaded_35
        - (C_31 * modes_W_15 + t56 * modes_W_25 + t62 * modes_W_35 + t68 * modes_W_45);
    const six_link_real M_i_36 = M_loaded_36
        - (C_31 * modes_W_16 + t56 * modes_W_26 + t62 * modes_W_36 + t68 * modes_W_46);
    const six_link_real M_i_44 = M_loaded_44
        - (C_41 * modes_W_14 + t57 * modes_W_24 + t63 * modes_W_34 + t69 * modes_W_44);
    const six_link_real M_i_45 = tip->Lambda[16]
        - (C_41 * modes_W_15 + t57 * modes_W_25 + t63 * modes_W_35 + t69 * modes_W_45);
    const six_link_real M_i_46 = tip->Lambda[17]
        - (C_41 * modes_W_16 + t57 * modes_W_26 + t63 * modes_W_36 + t69 * modes_W_46);
    const six_link_real M_i_55 = M_loaded_55
        - (C_51 * modes_W_15 + t58 * modes_W_25 + t64 * modes_W_35 + t70 * modes_W_45);
    const six_link_real M_i_56 = tip->Lambda[19]
        - (C_51 * modes_W_16 + t58 * modes_W_26 + t64 * modes_W_36 + t70 * modes_W_46);
    const six_link_real M_i_66 = M_loaded_66
        - (C_61 * modes_W_16 + t59 * modes_W_26 + t65 * modes_W_36 + t71 * modes_W_46);
    const six_link_real h_i_tau_x = h_loaded_tau_x
        - (modes_W_11 * h_phi_1 + modes_W_21 * t72 + modes_W_31 * t73 + modes_W_41 * t74);
    const six_link_real h_i_tau_y = h_loaded_tau_y
        - (modes_W_12 * h_phi_1 + modes_W_22 * t72 + modes_W_32 * t73 + modes_W_42 * t74);
    const six_link_real h_i_tau_z = h_loaded_tau_z
        - (modes_W_13 * h_phi_1 + modes_W_23 * t72 + modes_W_33 * t73 + modes_W_43 * t74);
    const six_link_real h_i_f_x = h_loaded_f_x
        - (modes_W_14 * h_phi_1 + modes_W_24 * t72 + modes_W_34 * t73 + modes_W_44 * t74);
    const six_link_real h_i_f_y = h_loaded_f_y
        - (modes_W_15 * h_phi_1 + modes_W_25 * t72 + modes_W_35 * t73 + modes_W_45 * t74);
    const six_link_real h_i_f_z = h_loaded_f_z
        - (modes_W_16 * h_phi_1 + modes_W_26 * t72 + modes_W_36 * t73 + modes_W_46 * t74);

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_11 = M_i_22 + m_q[0];
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8 * (M_i_11 + M_i_22 + M_i_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_i_12 * joint_inverse_1;
    link->joint_W[0] = joint_W_11;
    const six_link_real joint_W_12 = M_i_22 * joint_inverse_1;
    link->joint_W[1] = joint_W_12;
    const six_link_real joint_W_13 = M_i_23 * joint_inverse_1;
    link->joint_W[2] = joint_W_13;
    const six_link_real joint_W_14 = M_i_24 * joint_inverse_1;
    link->joint_W[3] = joint_W_14;
    const six_link_real joint_W_15 = M_i_25 * joint_inverse_1;
    link->joint_W[4] = joint_W_15;
    const six_link_real joint_W_16 = M_i_26 * joint_inverse_1;
    link->joint_W[5] = joint_W_16;
    const six_link_real joint_w_1 = (tau[0] - f_q[0] - h_i_tau_y) * joint_inverse_1;
    link->joint_w[0] = joint_w_1;
    const six_link_real Lambda_i_11 = M_i_11 - M_i_12 * joint_W_11;
    link->Lambda_i[0] = Lambda_i_11;
    const six_link_real Lambda_i_12 = M_i_12 - M_i_12 * joint_W_12;
    link->Lambda_i[1] = Lambda_i_12;
    const six_link_real Lambda_i_13 = M_i_13 - M_i_12 * joint_W_13;
    link->Lambda_i[2] = Lambda_i_13;
    const six_link_real Lambda_i_14 = M_i_14 - M_i_12 * joint_W_14;
    link->Lambda_i[3] = Lambda_i_14;
    const six_link_real Lambda_i_15 = M_i_15 - M_i_12 * joint_W_15;
    link->Lambda_i[4] = Lambda_i_15;
    const six_link_real Lambda_i_16 = M_i_16 - M_i_12 * joint_W_16;
    link->Lambda_i[5] = Lambda_i_16;
    const six_link_real Lambda_i_22 = M_i_22 - M_i_22 * joint_W_12;
    link->Lambda_i[6] = Lambda_i_22;
    const six_link_real Lambda_i_23 = M_i_23 - M_i_22 * joint_W_13;
    link->Lambda_i[7] = Lambda_i_23;
    const six_link_real Lambda_i_24 = M_i_24 - M_i_22 * joint_W_14;
    link->Lambda_i[8] = Lambda_i_24;
    const six_link_real Lambda_i_25 = M_i_25 - M_i_22 * joint_W_15;
    link->Lambda_i[9] = Lambda_i_25;
    const six_link_real Lambda_i_26 = M_i_26 - M_i_22 * joint_W_16;
    link->Lambda_i[10] = Lambda_i_26;
    const six_link_real Lambda_i_33 = M_i_33 - M_i_23 * joint_W_13;
    link->Lambda_i[11] = Lambda_i_33;
    const six_link_real Lambda_i_34 = M_i_34 - M_i_23 * joint_W_14;
    link->Lambda_i[12] = Lambda_i_34;
    const six_link_real Lambda_i_35 = M_i_35 - M_i_23 * joint_W_15;
    link->Lambda_i[13] = Lambda_i_35;
    const six_link_real Lambda_i_36 = M_i_36 - M_i_23 * joint_W_16;
    link->Lambda_i[14] = Lambda_i_36;
    const six_link_real Lambda_i_44 = M_i_44 - M_i_24 * joint_W_14;
    link->Lambda_i[15] = Lambda_i_44;
    const six_link_real Lambda_i_45 = M_i_45 - M_i_24 * joint_W_15;
    link->Lambda_i[16] = Lambda_i_45;
    const six_link_real Lambda_i_46 = M_i_46 - M_i_24 * joint_W_16;
    link->Lambda_i[17] = Lambda_i_46;
    const six_link_real Lambda_i_55 = M_i_55 - M_i_25 * joint_W_15;
    link->Lambda_i[18] = Lambda_i_55;
    const six_link_real Lambda_i_56 = M_i_56 - M_i_25 * joint_W_16;
    link->Lambda_i[19] = Lambda_i_56;
    const six_link_real Lambda_i_66 = M_i_66 - M_i_26 * joint_W_16;
    link->Lambda_i[20] = Lambda_i_66;
    const six_link_real p_i_tau_x = h_i_tau_x + M_i_12 * joint_w_1;
    link->p_i[0] = p_i_tau_x;
    const six_link_real p_i_tau_y = h_i_tau_y + M_i_22 * joint_w_1;
    link->p_i[1] = p_i_tau_y;
    const six_link_real p_i_tau_z = h_i_tau_z + M_i_23 * joint_w_1;
    link->p_i[2] = p_i_tau_z;
    const six_link_real p_i_f_x = h_i_f_x + M_i_24 * joint_w_1;
    link->p_i[3] = p_i_f_x;
    const six_link_real p_i_f_y = h_i_f_y + M_i_25 * joint_w_1;
    link->p_i[4] = p_i_f_y;
    const six_link_real p_i_f_z = h_i_f_z + M_i_26 * joint_w_1;
    link->p_i[5] = p_i_f_z;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t75 = link->lever[2] * Lambda_i_45;
    const six_link_real t76 = link->lever[1] * Lambda_i_46;
    const six_link_real t77 = link->lever[0] * Lambda_i_56;
    const six_link_real t78 = Lambda_i_14 + (t76 - t75);
    const six_link_real t79 = Lambda_i_15 + (link->lever[1] * Lambda_i_56 - link->lever[2] * Lambda_i_55);
    const six_link_real t80 = Lambda_i_16 + (link->lever[1] * Lambda_i_66 - link->lever[2] * Lambda_i_56);
    const six_link_real t81 = Lambda_i_24 + (link->lever[2] * Lambda_i_44 - link->lever[0] * Lambda_i_46);
    const six_link_real t82 = Lambda_i_25 + (t75 - t77);
    const six_link_real t83 = Lambda_i_26 + (link->lever[2] * Lambda_i_46 - link->lever[0] * Lambda_i_66);
    const six_link_real t84 = Lambda_i_34 + (link->lever[0] * Lambda_i_45 - link->lever[1] * Lambda_i_44);
    const six_link_real t85 = Lambda_i_35 + (link->lever[0] * Lambda_i_55 - link->lever[1] * Lambda_i_45);
    const six_link_real t86 = Lambda_i_36 + (t77 - t76);
    const six_link_real t87 = Lambda_i_11 - (Lambda_i_15 * link->lever[2] - Lambda_i_16 * link->lever[1])
        + (link->lever[1] * t80 - link->lever[2] * t79);
    const six_link_real t88 = Lambda_i_12 - (Lambda_i_16 * link->lever[0] - Lambda_i_14 * link->lever[2])
        + (link->lever[1] * t83 - link->lever[2] * t82);
    const six_link_real t89 = Lambda_i_13 - (Lambda_i_14 * link->lever[1] - Lambda_i_15 * link->lever[0])
        + (link->lever[1] * t86 - link->lever[2] * t85);
    const six_link_real t90 = Lambda_i_22 - (Lambda_i_26 * link->lever[0] - Lambda_i_24 * link->lever[2])
        + (link->lever[2] * t81 - link->lever[0] * t83);
    const six_link_real t91 = Lambda_i_23 - (Lambda_i_24 * link->lever[1] - Lambda_i_25 * link->lever[0])
        + (link->lever[2] * t84 - link->lever[0] * t86);
    const six_link_real t92 = Lambda_i_33 - (Lambda_i_34 * link->lever[1] - Lambda_i_35 * link->lever[0])
        + (link->lever[0] * t85 - link->lever[1] * t84);
    const six_link_real t93 = (t87 - t92) * SIX_LINK_REAL(0.5);
    const six_link_real t94 = t93 * link->R_P[0] + t88 * link->R_P[1] + t89 * link->R_P[2];
    const six_link_real t95 = t93 * link->R_P[3] + t88 * link->R_P[4] + t89 * link->R_P[5];
    const six_link_real t96 = t93 * link->R_P[6] + t88 * link->R_P[7] + t89 * link->R_P[8];
    const six_link_real t97 = (t90 - t92) * SIX_LINK_REAL(0.5);
    const six_link_real t98 = t97 * link->R_P[1] + t91 * link->R_P[2];
    const six_link_real t99 = t97 * link->R_P[4] + t91 * link->R_P[5];
    const six_link_real t100 = t97 * link->R_P[7] + t91 * link->R_P[8];
    const six_link_real Lambda_1 = (link->R_P[0] * t94 + link->R_P[1] * t98) * 2 + t92;
    base->Lambda[0] = Lambda_1;
    const six_link_real Lambda_2 = link->R_P[0] * t95 + link->R_P[1] * t99 + (link->R_P[3] * t94 + link->R_P[4] * t98);
    base->Lambda[1] = Lambda_2;
    const six_link_real Lambda_3 = link->R_P[0] * t96 + link->R_P[1] * t100 + (link->R_P[6] * t94 + link->R_P[7] * t98);
    base->Lambda[2] = Lambda_3;
    const six_link_real Lambda_7 = (link->R_P[3] * t95 + link->R_P[4] * t99) * 2 + t92;
    base->Lambda[6] = Lambda_7;
    const six_link_real Lambda_8 = link->R_P[3] * t96 + link->R_P[4] * t100 + (link->R_P[6] * t95 + link->R_P[7] * t99);
    base->Lambda[7] = Lambda_8;
    const six_link_real Lambda_12 = (link->R_P[6] * t96 + link->R_P[7] * t100) * 2 + t92;
    base->Lambda[11] = Lambda_12;
    const six_link_real t101 = t78 * link->R_P[0] + t79 * link->R_P[1] + t80 * link->R_P[2];
    const six_link_real t102 = t78 * link->R_P[3] + t79 * link->R_P[4] + t80 * link->R_P[5];
    const six_link_real t103 = t78 * link->R_P[6] + t79 * link->R_P[7] + t80 * link->R_P[8];
    const six_link_real t104 = t81 * link->R_P[0] + t82 * link->R_P[1] + t83 * link->R_P[2];
    const six_link_real t105 = t81 * link->R_P[3] + t82 * link->R_P[4] + t83 * link->R_P[5];
    const six_link_real t106 = t81 * link->R_P[6] + t82 * link->R_P[7] + t83 * link->R_P[8];
    const six_link_real t107 = t84 * link->R_P[0] + t85 * link->R_P[1] + t86 * link->R_P[2];
    const six_link_real t108 = t84 * link->R_P[3] + t85 * link->R_P[4] + t86 * link->R_P[5];
    const six_link_real t109 = t84 * link->R_P[6] + t85 * link->R_P[7] + t86 * link->R_P[8];
    const six_link_real Lambda_4 = link->R_P[0] * t101 + link->R_P[1] * t104 + link->R_P[2] * t107;
    base->Lambda[3] = Lambda_4;
    const six_link_real Lambda_5 = link->R_P[0] * t102 + link->R_P[1] * t105 + link->R_P[2] * t108;
    base->Lambda[4] = Lambda_5;
    const six_link_real Lambda_6 = link->R_P[0] * t103 + link->R_P[1] * t106 + link->R_P[2] * t109;
    base->Lambda[5] = Lambda_6;
    const six_link_real Lambda_9 = link->R_P[3] * t101 + link->R_P[4] * t104 + link->R_P[5] * t107;
    base->Lambda[8] = Lambda_9;
    const six_link_real Lambda_10 = link->R_P[3] * t102 + link->R_P[4] * t105 + link->R_P[5] * t108;
    base->Lambda[9] = Lambda_10;
    const six_link_real Lambda_11 = link->R_P[3] * t103 + link->R_P[4] * t106 + link->R_P[5] * t109;
    base->Lambda[10] = Lambda_11;
    const six_link_real Lambda_13 = link->R_P[6] * t101 + link->R_P[7] * t104 + link->R_P[8] * t107;
    base->Lambda[12] = Lambda_13;
    const six_link_real Lambda_14 = link->R_P[6] * t102 + link->R_P[7] * t105 + link->R_P[8] * t108;
    base->Lambda[13] = Lambda_14;
    const six_link_real Lambda_15 = link->R_P[6] * t103 + link->R_P[7] * t106 + link->R_P[8] * t109;
    base->Lambda[14] = Lambda_15;
    const six_link_real t110 = (Lambda_i_44 - Lambda_i_66) * SIX_LINK_REAL(0.5);
    const six_link_real t111 = t110 * link->R_P[0] + Lambda_i_45 * link->R_P[1] + Lambda_i_46 * link->R_P[2];
    const six_link_real t112 = t110 * link->R_P[3] + Lambda_i_45 * link->R_P[4] + Lambda_i_46 * link->R_P[5];
    const six_link_real t113 = t110 * link->R_P[6] + Lambda_i_45 * link->R_P[7] + Lambda_i_46 * link->R_P[8];
    const six_link_real t114 = (Lambda_i_55 - Lambda_i_66) * SIX_LINK_REAL(0.5);
    const six_link_real t115 = t114 * link->R_P[1] + Lambda_i_56 * link->R_P[2];
    const six_link_real t116 = t114 * link->R_P[4] + Lambda_i_56 * link->R_P[5];
    const six_link_real t117 = t114 * link->R_P[7] + Lambda_i_56 * link->R_P[8];
    const six_link_real Lambda_16 = (link->R_P[0] * t111 + link->R_P[1] * t115) * 2 + Lambda_i_66;
    base->Lambda[15] = Lambda_16;
    const six_link_real Lambda_17 = link->R_P[0] * t112 + link->R_P[1] * t116
        + (link->R_P[3] * t111 + link->R_P[4] * t115);
    base->Lambda[16] = Lambda_17;
    const six_link_real Lambda_18 = link->R_P[0] * t113 + link->R_P[1] * t117
        + (link->R_P[6] * t111 + link->R_P[7] * t115);
    base->Lambda[17] = Lambda_18;
    const six_link_real Lambda_19 = (link->R_P[3] * t112 + link->R_P[4] * t116) * 2 + Lambda_i_66;
    base->Lambda[18] = Lambda_19;
    const six_link_real Lambda_20 = link->R_P[3] * t113 + link->R_P[4] * t117
        + (link->R_P[6] * t112 + link->R_P[7] * t116);
    base->Lambda[19] = Lambda_20;
    const six_link_real Lambda_21 = (link->R_P[6] * t113 + link->R_P[7] * t117) * 2 + Lambda_i_66;
    base->Lambda[20] = Lambda_21;
    const six_link_real t118 = p_i_tau_x + (link->lever[1] * p_i_f_z - link->lever[2] * p_i_f_y);
    const six_link_real t119 = p_i_tau_y + (link->lever[2] * p_i_f_x - link->lever[0] * p_i_f_z);
    const six_link_real t120 = p_i_tau_z + (link->lever[0] * p_i_f_y - link->lever[1] * p_i_f_x);
    const six_link_real p_tau_x = link->R_P[0] * t118 + link->R_P[1] * t119 + link->R_P[2] * t120;
    base->p[0] = p_tau_x;
    const six_link_real p_tau_y = link->R_P[3] * t118 + link->R_P[4] * t119 + link->R_P[5] * t120;
    base->p[1] = p_tau_y;
    const six_link_real p_tau_z = link->R_P[6] * t118 + link->R_P[7] * t119 + link->R_P[8] * t120;
    base->p[2] = p_tau_z;
    const six_link_real p_f_x = link->R_P[0] * p_i_f_x + link->R_P[1] * p_i_f_y + link->R_P[2] * p_i_f_z;
    base->p[3] = p_f_x;
    const six_link_real p_f_y = link->R_P[3] * p_i_f_x + link->R_P[4] * p_i_f_y + link->R_P[5] * p_i_f_z;
    base->p[4] = p_f_y;
    const six_link_real p_f_z = link->R_P[6] * p_i_f_x + link->R_P[7] * p_i_f_y + link->R_P[8] * p_i_f_z;
    base->p[5] = p_f_z;
    return SIX_LINK_OK;
}

/* eliminate, links like wrist_roll: 397 operations */
SIX_LINK_PART six_link_status eliminate_wrist_roll(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, six_link_node *restrict base, const six_link_node *restrict tip,
    const six_link_real w_ext[restrict 6], const six_link_real m_q[restrict 1], const six_link_real f_q[restrict 1],
    const six_link_real tau[restrict 1])
{
    /* Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_xx = link->omega[1] * link->omega[1] + link->omega[2] * link->omega[2];
    const six_link_real Omega_yx = link->acc_0[2] + link->omega[0] * link->omega[1];
    const six_link_real Omega_zx = link->omega[0] * link->omega[2] - link->acc_0[1];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_tau_x = c->I_s * link->acc_0[0];
    const six_link_real t1 = c->I_s * link->omega[0];
    const six_link_real H_star_tau_y = t1 * link->omega[2] - c->J_0_xx * Omega_zx - c->S_0_x * link->acc_0[5];
    const six_link_real H_star_tau_z = c->J_0_xx * Omega_yx + c->S_0_x * link->acc_0[4] - t1 * link->omega[1];
    const six_link_real H_star_f_x = link->acc_0[3] * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = Omega_yx * c->S_0_x + link->acc_0[4] * c->mu;
    const six_link_real H_star_f_z = Omega_zx * c->S_0_x + link->acc_0[5] * c->mu;

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_tau_x = tip->p[0] - w_ext[0];
    const six_link_real p_T_tau_y = tip->p[1] - w_ext[1];
    const six_link_real p_T_tau_z = tip->p[2] - w_ext[2];
    const six_link_real p_T_f_x = tip->p[3] - w_ext[3];
    const six_link_real p_T_f_y = tip->p[4] - w_ext[4];
    const six_link_real p_T_f_z = tip->p[5] - w_ext[5];

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t2 = c->length * tip->Lambda[19];
    const six_link_real M_loaded_24 = tip->Lambda[8] - c->length * tip->Lambda[17];
    const six_link_real M_loaded_25 = tip->Lambda[9] - t2;
    const six_link_real t3 = tip->Lambda[10] - c->length * tip->Lambda[20];
    const six_link_real M_loaded_34 = tip->Lambda[12] + c->length * tip->Lambda[16];
    const six_link_real t4 = tip->Lambda[13] + c->length * tip->Lambda[18];
    const six_link_real M_loaded_36 = tip->Lambda[14] + t2;
    const six_link_real M_loaded_12 = tip->Lambda[1] - tip->Lambda[5] * c->length;
    const six_link_real M_loaded_13 = tip->Lambda[2] + tip->Lambda[4] * c->length;
    const six_link_real M_loaded_23 = tip->Lambda[7] + tip->Lambda[9] * c->length - c->length * M_loaded_36;
    const six_link_real M_loaded_11 = c->I_s + tip->Lambda[0];
    const six_link_real M_loaded_22 = c->J_0_xx + (tip->Lambda[6] - tip->Lambda[10] * c->length - c->length * t3);
    const six_link_real M_loaded_26 = t3 - c->S_0_x;
    const six_link_real M_loaded_33 = c->J_0_xx + (tip->Lambda[11] + tip->Lambda[13] * c->length + c->length * t4);
    const six_link_real M_loaded_35 = c->S_0_x + t4;
    const six_link_real M_loaded_44 = c->mu + tip->Lambda[15];
    const six_link_real M_loaded_55 = c->mu + tip->Lambda[18];
    const six_link_real M_loaded_66 = c->mu + tip->Lambda[20];
    const six_link_real h_loaded_tau_x = H_star_tau_x + p_T_tau_x;
    const six_link_real h_loaded_tau_y = H_star_tau_y + (p_T_tau_y - c->length * p_T_f_z);
    const six_link_real h_loaded_tau_z = H_star_tau_z + (p_T_tau_z + c->length * p_T_f_y);
    const six_link_real h_loaded_f_x = H_star_f_x + p_T_f_x;
    const six_link_real h_loaded_f_y = H_star_f_y + p_T_f_y;
    const six_link_real h_loaded_f_z = H_star_f_z + p_T_f_z;

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_11 = M_loaded_11 + m_q[0];
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8
        * (M_loaded_11 + M_loaded_22 + M_loaded_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_loaded_11 * joint_inverse_1;
    link->joint_W[0] = joint_W_11;
    const six_link_real joint_W_12 = M_loaded_12 * joint_inverse_1;
    link->joint_W[1] = joint_W_12;
    const six_link_real joint_W_13 = M_loaded_13 * joint_inverse_1;
    link->joint_W[2] = joint_W_13;
    const six_link_real joint_W_14 = tip->Lambda[3] * joint_inverse_1;
    link->joint_W[3] = joint_W_14;
    const six_link_real joint_W_15 = tip->Lambda[4] * joint_inverse_1;
    link->joint_W[4] = joint_W_15;
    const six_link_real joint_W_16 = tip->Lambda[5] * joint_inverse_1;
    link->joint_W[5] = joint_W_16;
    const six_link_real joint_w_1 = (tau[0] - f_q[0] - h_loaded_tau_x) * joint_inverse_1;
    link->joint_w[0] = joint_w_1;
    const six_link_real Lambda_i_11 = M_loaded_11 - M_loaded_11 * joint_W_11;
    link->Lambda_i[0] = Lambda_i_11;
    const six_link_real Lambda_i_12 = M_loaded_12 - M_loaded_11 * joint_W_12;
    link->Lambda_i[1] = Lambda_i_12;
    const six_link_real Lambda_i_13 = M_loaded_13 - M_loaded_11 * joint_W_13;
    link->Lambda_i[2] = Lambda_i_13;
    const six_link_real Lambda_i_14 = tip->Lambda[3] - M_loaded_11 * joint_W_14;
    link->Lambda_i[3] = Lambda_i_14;
    const six_link_real Lambda_i_15 = tip->Lambda[4] - M_loaded_11 * joint_W_15;
    link->Lambda_i[4] = Lambda_i_15;
    const six_link_real Lambda_i_16 = tip->Lambda[5] - M_loaded_11 * joint_W_16;
    link->Lambda_i[5] = Lambda_i_16;
    const six_link_real Lambda_i_22 = M_loaded_22 - M_loaded_12 * joint_W_12;
    link->Lambda_i[6] = Lambda_i_22;
    const six_link_real Lambda_i_23 = M_loaded_23 - M_loaded_12 * joint_W_13;
    link->Lambda_i[7] = Lambda_i_23;
    const six_link_real Lambda_i_24 = M_loaded_24 - M_loaded_12 * joint_W_14;
    link->Lambda_i[8] = Lambda_i_24;
    const six_link_real Lambda_i_25 = M_loaded_25 - M_loaded_12 * joint_W_15;
    link->Lambda_i[9] = Lambda_i_25;
    const six_link_real Lambda_i_26 = M_loaded_26 - M_loaded_12 * joint_W_16;
    link->Lambda_i[10] = Lambda_i_26;
    const six_link_real Lambda_i_33 = M_loaded_33 - M_loaded_13 * joint_W_13;
    link->Lambda_i[11] = Lambda_i_33;
    const six_link_real Lambda_i_34 = M_loaded_34 - M_loaded_13 * joint_W_14;
    link->Lambda_i[12] = Lambda_i_34;
    const six_link_real Lambda_i_35 = M_loaded_35 - M_loaded_13 * joint_W_15;
    link->Lambda_i[13] = Lambda_i_35;
    const six_link_real Lambda_i_36 = M_loaded_36 - M_loaded_13 * joint_W_16;
    link->Lambda_i[14] = Lambda_i_36;
    const six_link_real Lambda_i_44 = M_loaded_44 - tip->Lambda[3] * joint_W_14;
    link->Lambda_i[15] = Lambda_i_44;
    const six_link_real Lambda_i_45 = tip->Lambda[16] - tip->Lambda[3] * joint_W_15;
    link->Lambda_i[16] = Lambda_i_45;
    const six_link_real Lambda_i_46 = tip->Lambda[17] - tip->Lambda[3] * joint_W_16;
    link->Lambda_i[17] = Lambda_i_46;
    const six_link_real Lambda_i_55 = M_loaded_55 - tip->Lambda[4] * joint_W_15;
    link->Lambda_i[18] = Lambda_i_55;
    const six_link_real Lambda_i_56 = tip->Lambda[19] - tip->Lambda[4] * joint_W_16;
    link->Lambda_i[19] = Lambda_i_56;
    const six_link_real Lambda_i_66 = M_loaded_66 - tip->Lambda[5] * joint_W_16;
    link->Lambda_i[20] = Lambda_i_66;
    const six_link_real p_i_tau_x = h_loaded_tau_x + M_loaded_11 * joint_w_1;
    link->p_i[0] = p_i_tau_x;
    const six_link_real p_i_tau_y = h_loaded_tau_y + M_loaded_12 * joint_w_1;
    link->p_i[1] = p_i_tau_y;
    const six_link_real p_i_tau_z = h_loaded_tau_z + M_loaded_13 * joint_w_1;
    link->p_i[2] = p_i_tau_z;
    const six_link_real p_i_f_x = h_loaded_f_x + tip->Lambda[3] * joint_w_1;
    link->p_i[3] = p_i_f_x;
    const six_link_real p_i_f_y = h_loaded_f_y + tip->Lambda[4] * joint_w_1;
    link->p_i[4] = p_i_f_y;
    const six_link_real p_i_f_z = h_loaded_f_z + tip->Lambda[5] * joint_w_1;
    link->p_i[5] = p_i_f_z;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t5 = (Lambda_i_11 - Lambda_i_33) * SIX_LINK_REAL(0.5);
    const six_link_real t6 = t5 * link->R_P[0] + Lambda_i_12 * link->R_P[1] + Lambda_i_13 * link->R_P[2];
    const six_link_real t7 = t5 * link->R_P[3] + Lambda_i_12 * link->R_P[4] + Lambda_i_13 * link->R_P[5];
    const six_link_real t8 = t5 * link->R_P[6] + Lambda_i_12 * link->R_P[7] + Lambda_i_13 * link->R_P[8];
    const six_link_real t9 = (Lambda_i_22 - Lambda_i_33) * SIX_LINK_REAL(0.5);
    const six_link_real t10 = t9 * link->R_P[1] + Lambda_i_23 * link->R_P[2];
    const six_link_real t11 = t9 * link->R_P[4] + Lambda_i_23 * link->R_P[5];
    const six_link_real t12 = t9 * link->R_P[7] + Lambda_i_23 * link->R_P[8];
    const six_link_real Lambda_1 = (link->R_P[0] * t6 + link->R_P[1] * t10) * 2 + Lambda_i_33;
    base->Lambda[0] = Lambda_1;
    const six_link_real Lambda_2 = link->R_P[0] * t7 + link->R_P[1] * t11 + (link->R_P[3] * t6 + link->R_P[4] * t10);
    base->Lambda[1] = Lambda_2;
    const six_link_real Lambda_3 = link->R_P[0] * t8 + link->R_P[1] * t12 + (link->R_P[6] * t6 + link->R_P[7] * t10);
    base->Lambda[2] = Lambda_3;
    const six_link_real Lambda_7 = (link->R_P[3] * t7 + link->R_P[4] * t11) * 2 + Lambda_i_33;
    base->Lambda[6] = Lambda_7;
    const six_link_real Lambda_8 = link->R_P[3] * t8 + link->R_P[4] * t12 + (link->R_P[6] * t7 + link->R_P[7] * t11);
    base->Lambda[7] = Lambda_8;
    const six_link_real Lambda_12 = (link->R_P[6] * t8 + link->R_P[7] * t12) * 2 + Lambda_i_33;
    base->Lambda[11] = Lambda_12;
    const six_link_real t13 = Lambda_i_14 * link->R_P[0] + Lambda_i_15 * link->R_P[1] + Lambda_i_16 * link->R_P[2];
    const six_link_real t14 = Lambda_i_14 * link->R_P[3] + Lambda_i_15 * link->R_P[4] + Lambda_i_16 * link->R_P[5];
    const six_link_real t15 = Lambda_i_14 * link->R_P[6] + Lambda_i_15 * link->R_P[7] + Lambda_i_16 * link->R_P[8];
    const six_link_real t16 = Lambda_i_24 * link->R_P[0] + Lambda_i_25 * link->R_P[1] + Lambda_i_26 * link->R_P[2];
    const six_link_real t17 = Lambda_i_24 * link->R_P[3] + Lambda_i_25 * link->R_P[4] + Lambda_i_26 * link->R_P[5];
    const six_link_real t18 = Lambda_i_24 * link->R_P[6] + Lambda_i_25 * link->R_P[7] + Lambda_i_26 * link->R_P[8];
    const six_link_real t19 = Lambda_i_34 * link->R_P[0] + Lambda_i_35 * link->R_P[1] + Lambda_i_36 * link->R_P[2];
    const six_link_real t20 = Lambda_i_34 * link->R_P[3] + Lambda_i_35 * link->R_P[4] + Lambda_i_36 * link->R_P[5];
    const six_link_real t21 = Lambda_i_34 * link->R_P[6] + Lambda_i_35 * link->R_P[7] + Lambda_i_36 * link->R_P[8];
    const six_link_real Lambda_4 = link->R_P[0] * t13 + link->R_P[1] * t16 + link->R_P[2] * t19;
    base->Lambda[3] = Lambda_4;
    const six_link_real Lambda_5 = link->R_P[0] * t14 + link->R_P[1] * t17 + link->R_P[2] * t20;
    base->Lambda[4] = Lambda_5;
    const six_link_real Lambda_6 = link->R_P[0] * t15 + link->R_P[1] * t18 + link->R_P[2] * t21;
    base->Lambda[5] = Lambda_6;
    const six_link_real Lambda_9 = link->R_P[3] * t13 + link->R_P[4] * t16 + link->R_P[5] * t19;
    base->Lambda[8] = Lambda_9;
    const six_link_real Lambda_10 = link->R_P[3] * t14 + link->R_P[4] * t17 + link->R_P[5] * t20;
    base->Lambda[9] = Lambda_10;
    const six_link_real Lambda_11 = link->R_P[3] * t15 + link->R_P[4] * t18 + link->R_P[5] * t21;
    base->Lambda[10] = Lambda_11;
    const six_link_real Lambda_13 = link->R_P[6] * t13 + link->R_P[7] * t16 + link->R_P[8] * t19;
    base->Lambda[12] = Lambda_13;
    const six_link_real Lambda_14 = link->R_P[6] * t14 + link->R_P[7] * t17 + link->R_P[8] * t20;
    base->Lambda[13] = Lambda_14;
    const six_link_real Lambda_15 = link->R_P[6] * t15 + link->R_P[7] * t18 + link->R_P[8] * t21;
    base->Lambda[14] = Lambda_15;
    const six_link_real t22 = (Lambda_i_44 - Lambda_i_66) * SIX_LINK_REAL(0.5);
    const six_link_real t23 = t22 * link->R_P[0] + Lambda_i_45 * link->R_P[1] + Lambda_i_46 * link->R_P[2];
    const six_link_real t24 = t22 * link->R_P[3] + Lambda_i_45 * link->R_P[4] + Lambda_i_46 * link->R_P[5];
    const six_link_real t25 = t22 * link->R_P[6] + Lambda_i_45 * link->R_P[7] + Lambda_i_46 * link->R_P[8];
    const six_link_real t26 = (Lambda_i_55 - Lambda_i_66) * SIX_LINK_REAL(0.5);
    const six_link_real t27 = t26 * link->R_P[1] + Lambda_i_56 * link->R_P[2];
    const six_link_real t28 = t26 * link->R_P[4] + Lambda_i_56 * link->R_P[5];
    const six_link_real t29 = t26 * link->R_P[7] + Lambda_i_56 * link->R_P[8];
    const six_link_real Lambda_16 = (link->R_P[0] * t23 + link->R_P[1] * t27) * 2 + Lambda_i_66;
    base->Lambda[15] = Lambda_16;
    const six_link_real Lambda_17 = link->R_P[0] * t24 + link->R_P[1] * t28 + (link->R_P[3] * t23 + link->R_P[4] * t27);
    base->Lambda[16] = Lambda_17;
    const six_link_real Lambda_18 = link->R_P[0] * t25 + link->R_P[1] * t29 + (link->R_P[6] * t23 + link->R_P[7] * t27);
    base->Lambda[17] = Lambda_18;
    const six_link_real Lambda_19 = (link->R_P[3] * t24 + link->R_P[4] * t28) * 2 + Lambda_i_66;
    base->Lambda[18] = Lambda_19;
    const six_link_real Lambda_20 = link->R_P[3] * t25 + link->R_P[4] * t29 + (link->R_P[6] * t24 + link->R_P[7] * t28);
    base->Lambda[19] = Lambda_20;
    const six_link_real Lambda_21 = (link->R_P[6] * t25 + link->R_P[7] * t29) * 2 + Lambda_i_66;
    base->Lambda[20] = Lambda_21;
    const six_link_real p_tau_x = link->R_P[0] * p_i_tau_x + link->R_P[1] * p_i_tau_y + link->R_P[2] * p_i_tau_z;
    base->p[0] = p_tau_x;
    const six_link_real p_tau_y = link->R_P[3] * p_i_tau_x + link->R_P[4] * p_i_tau_y + link->R_P[5] * p_i_tau_z;
    base->p[1] = p_tau_y;
    const six_link_real p_tau_z = link->R_P[6] * p_i_tau_x + link->R_P[7] * p_i_tau_y + link->R_P[8] * p_i_tau_z;
    base->p[2] = p_tau_z;
    const six_link_real p_f_x = link->R_P[0] * p_i_f_x + link->R_P[1] * p_i_f_y + link->R_P[2] * p_i_f_z;
    base->p[3] = p_f_x;
    const six_link_real p_f_y = link->R_P[3] * p_i_f_x + link->R_P[4] * p_i_f_y + link->R_P[5] * p_i_f_z;
    base->p[4] = p_f_y;
    const six_link_real p_f_z = link->R_P[6] * p_i_f_x + link->R_P[7] * p_i_f_y + link->R_P[8] * p_i_f_z;
    base->p[5] = p_f_z;
    return SIX_LINK_OK;
}

/* eliminate, links like wrist_pitch: 239 operations */
SIX_LINK_PART six_link_status eliminate_wrist_pitch(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, six_link_node *restrict base, const six_link_node *restrict tip,
    const six_link_real w_ext[restrict 6], const six_link_real m_q[restrict 1], const six_link_real f_q[restrict 1],
    const six_link_real tau[restrict 1])
{
    /* Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_xx = link->omega[1] * link->omega[1] + link->omega[2] * link->omega[2];
    const six_link_real Omega_yx = link->acc_0[2] + link->omega[0] * link->omega[1];
    const six_link_real Omega_zx = link->omega[0] * link->omega[2] - link->acc_0[1];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_tau_x = c->I_s * link->acc_0[0];
    const six_link_real t1 = c->I_s * link->omega[0];
    const six_link_real H_star_tau_y = t1 * link->omega[2] - c->J_0_xx * Omega_zx - c->S_0_x * link->acc_0[5];
    const six_link_real H_star_tau_z = c->J_0_xx * Omega_yx + c->S_0_x * link->acc_0[4] - t1 * link->omega[1];
    const six_link_real H_star_f_x = link->acc_0[3] * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = Omega_yx * c->S_0_x + link->acc_0[4] * c->mu;
    const six_link_real H_star_f_z = Omega_zx * c->S_0_x + link->acc_0[5] * c->mu;

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_tau_x = tip->p[0] - w_ext[0];
    const six_link_real p_T_tau_y = tip->p[1] - w_ext[1];
    const six_link_real p_T_tau_z = tip->p[2] - w_ext[2];
    const six_link_real p_T_f_x = tip->p[3] - w_ext[3];
    const six_link_real p_T_f_y = tip->p[4] - w_ext[4];
    const six_link_real p_T_f_z = tip->p[5] - w_ext[5];

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t2 = c->length * tip->Lambda[19];
    const six_link_real M_loaded_25 = tip->Lambda[9] - t2;
    const six_link_real t3 = tip->Lambda[10] - c->length * tip->Lambda[20];
    const six_link_real t4 = tip->Lambda[13] + c->length * tip->Lambda[18];
    const six_link_real M_loaded_36 = tip->Lambda[14] + t2;
    const six_link_real M_loaded_12 = tip->Lambda[1] - tip->Lambda[5] * c->length;
    const six_link_real M_loaded_13 = tip->Lambda[2] + tip->Lambda[4] * c->length;
    const six_link_real M_loaded_23 = tip->Lambda[7] + tip->Lambda[9] * c->length - c->length * M_loaded_36;
    const six_link_real M_loaded_11 = c->I_s + tip->Lambda[0];
    const six_link_real M_loaded_22 = c->J_0_xx + (tip->Lambda[6] - tip->Lambda[10] * c->length - c->length * t3);
    const six_link_real M_loaded_26 = t3 - c->S_0_x;
    const six_link_real M_loaded_33 = c->J_0_xx + (tip->Lambda[11] + tip->Lambda[13] * c->length + c->length * t4);
    const six_link_real M_loaded_35 = c->S_0_x + t4;
    const six_link_real M_loaded_44 = c->mu + tip->Lambda[15];
    const six_link_real M_loaded_55 = c->mu + tip->Lambda[18];
    const six_link_real M_loaded_66 = c->mu + tip->Lambda[20];
    const six_link_real h_loaded_tau_x = H_star_tau_x + p_T_tau_x;
    const six_link_real h_loaded_tau_y = H_star_tau_y + (p_T_tau_y - c->length * p_T_f_z);
    const six_link_real h_loaded_tau_z = H_star_tau_z + (p_T_tau_z + c->length * p_T_f_y);
    const six_link_real h_loaded_f_x = H_star_f_x + p_T_f_x;
    const six_link_real h_loaded_f_y = H_star_f_y + p_T_f_y;
    const six_link_real h_loaded_f_z = H_star_f_z + p_T_f_z;

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_11 = M_loaded_22 + m_q[0];
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8
        * (M_loaded_11 + M_loaded_22 + M_loaded_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_loaded_12 * joint_inverse_1;
    link->joint_W[0] = joint_W_11;
    const six_link_real joint_W_12 = M_loaded_22 * joint_inverse_1;
    link->joint_W[1] = joint_W_12;
    const six_link_real joint_W_13 = M_loaded_23 * joint_inverse_1;
    link->joint_W[2] = joint_W_13;
    const six_link_real joint_W_14 = tip->Lambda[8] * joint_inverse_1;
    link->joint_W[3] = joint_W_14;
    const six_link_real joint_W_15 = M_loaded_25 * joint_inverse_1;
    link->joint_W[4] = joint_W_15;
    const six_link_real joint_W_16 = M_loaded_26 * joint_inverse_1;
    link->joint_W[5] = joint_W_16;
    const six_link_real joint_w_1 = (tau[0] - f_q[0] - h_loaded_tau_y) * joint_inverse_1;
    link->joint_w[0] = joint_w_1;
    const six_link_real Lambda_i_11 = M_loaded_11 - M_loaded_12 * joint_W_11;
    link->Lambda_i[0] = Lambda_i_11;
    const six_link_real Lambda_i_12 = M_loaded_12 - M_loaded_12 * joint_W_12;
    link->Lambda_i[1] = Lambda_i_12;
    const six_link_real Lambda_i_13 = M_loaded_13 - M_loaded_12 * joint_W_13;
    link->Lambda_i[2] = Lambda_i_13;
    const six_link_real minus_Lambda_i_14 = M_loaded_12 * joint_W_14;
    link->Lambda_i[3] = -minus_Lambda_i_14;
    const six_link_real Lambda_i_15 = tip->Lambda[4] - M_loaded_12 * joint_W_15;
    link->Lambda_i[4] = Lambda_i_15;
    const six_link_real Lambda_i_16 = tip->Lambda[5] - M_loaded_12 * joint_W_16;
    link->Lambda_i[5] = Lambda_i_16;
    const six_link_real Lambda_i_22 = M_loaded_22 - M_loaded_22 * joint_W_12;
    link->Lambda_i[6] = Lambda_i_22;
    base->Lambda[6] = Lambda_i_22;
    const six_link_real Lambda_i_23 = M_loaded_23 - M_loaded_22 * joint_W_13;
    link->Lambda_i[7] = Lambda_i_23;
    const six_link_real Lambda_i_24 = tip->Lambda[8] - M_loaded_22 * joint_W_14;
    link->Lambda_i[8] = Lambda_i_24;
    const six_link_real Lambda_i_25 = M_loaded_25 - M_loaded_22 * joint_W_15;
    link->Lambda_i[9] = Lambda_i_25;
    base->Lambda[9] = Lambda_i_25;
    const six_link_real Lambda_i_26 = M_loaded_26 - M_loaded_22 * joint_W_16;
    link->Lambda_i[10] = Lambda_i_26;
    const six_link_real Lambda_i_33 = M_loaded_33 - M_loaded_23 * joint_W_13;
    link->Lambda_i[11] = Lambda_i_33;
    const six_link_real Lambda_i_34 = tip->Lambda[12] - M_loaded_23 * joint_W_14;
    link->Lambda_i[12] = Lambda_i_34;
    const six_link_real Lambda_i_35 = M_loaded_35 - M_loaded_23 * joint_W_15;
    link->Lambda_i[13] = Lambda_i_35;
    const six_link_real Lambda_i_36 = M_loaded_36 - M_loaded_23 * joint_W_16;
    link->Lambda_i[14] = Lambda_i_36;
    const six_link_real Lambda_i_44 = M_loaded_44 - tip->Lambda[8] * joint_W_14;
    link->Lambda_i[15] = Lambda_i_44;
    const six_link_real minus_Lambda_i_45 = tip->Lambda[8] * joint_W_15;
    link->Lambda_i[16] = -minus_Lambda_i_45;
    const six_link_real minus_Lambda_i_46 = tip->Lambda[8] * joint_W_16;
    link->Lambda_i[17] = -minus_Lambda_i_46;
    const six_link_real Lambda_i_55 = M_loaded_55 - M_loaded_25 * joint_W_15;
    link->Lambda_i[18] = Lambda_i_55;
    base->Lambda[18] = Lambda_i_55;
    const six_link_real Lambda_i_56 = tip->Lambda[19] - M_loaded_25 * joint_W_16;
    link->Lambda_i[19] = Lambda_i_56;
    const six_link_real Lambda_i_66 = M_loaded_66 - M_loaded_26 * joint_W_16;
    link->Lambda_i[20] = Lambda_i_66;
    const six_link_real p_i_tau_x = h_loaded_tau_x + M_loaded_12 * joint_w_1;
    link->p_i[0] = p_i_tau_x;
    const six_link_real p_i_tau_y = h_loaded_tau_y + M_loaded_22 * joint_w_1;
    link->p_i[1] = p_i_tau_y;
    base->p[1] = p_i_tau_y;
    const six_link_real p_i_tau_z = h_loaded_tau_z + M_loaded_23 * joint_w_1;
    link->p_i[2] = p_i_tau_z;
    const six_link_real p_i_f_x = h_loaded_f_x + tip->Lambda[8] * joint_w_1;
    link->p_i[3] = p_i_f_x;
    const six_link_real p_i_f_y = h_loaded_f_y + M_loaded_25 * joint_w_1;
    link->p_i[4] = p_i_f_y;
    base->p[4] = p_i_f_y;
    const six_link_real p_i_f_z = h_loaded_f_z + M_loaded_26 * joint_w_1;
    link->p_i[5] = p_i_f_z;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t5 = (Lambda_i_11 - Lambda_i_33) * SIX_LINK_REAL(0.5);
    const six_link_real t6 = t5 * link->R_P[0] + Lambda_i_13 * link->R_P[2];
    const six_link_real t7 = t5 * link->R_P[6] + Lambda_i_13 * link->R_P[8];
    const six_link_real Lambda_1 = link->R_P[0] * t6 * 2 + Lambda_i_33;
    base->Lambda[0] = Lambda_1;
    const six_link_real Lambda_2 = link->R_P[0] * Lambda_i_12 + Lambda_i_23 * link->R_P[2];
    base->Lambda[1] = Lambda_2;
    const six_link_real Lambda_3 = link->R_P[0] * t7 + link->R_P[6] * t6;
    base->Lambda[2] = Lambda_3;
    const six_link_real Lambda_8 = Lambda_i_23 * link->R_P[8] + link->R_P[6] * Lambda_i_12;
    base->Lambda[7] = Lambda_8;
    const six_link_real Lambda_12 = link->R_P[6] * t7 * 2 + Lambda_i_33;
    base->Lambda[11] = Lambda_12;
    const six_link_real t8 = Lambda_i_16 * link->R_P[2] - minus_Lambda_i_14 * link->R_P[0];
    const six_link_real t9 = Lambda_i_16 * link->R_P[8] - minus_Lambda_i_14 * link->R_P[6];
    const six_link_real Lambda_9 = Lambda_i_24 * link->R_P[0] + Lambda_i_26 * link->R_P[2];
    base->Lambda[8] = Lambda_9;
    const six_link_real Lambda_11 = Lambda_i_24 * link->R_P[6] + Lambda_i_26 * link->R_P[8];
    base->Lambda[10] = Lambda_11;
    const six_link_real t10 = Lambda_i_34 * link->R_P[0] + Lambda_i_36 * link->R_P[2];
    const six_link_real t11 = Lambda_i_34 * link->R_P[6] + Lambda_i_36 * link->R_P[8];
    const six_link_real Lambda_4 = link->R_P[0] * t8 + link->R_P[2] * t10;
    base->Lambda[3] = Lambda_4;
    const six_link_real Lambda_5 = link->R_P[0] * Lambda_i_15 + link->R_P[2] * Lambda_i_35;
    base->Lambda[4] = Lambda_5;
    const six_link_real Lambda_6 = link->R_P[0] * t9 + link->R_P[2] * t11;
    base->Lambda[5] = Lambda_6;
    const six_link_real Lambda_13 = link->R_P[6] * t8 + link->R_P[8] * t10;
    base->Lambda[12] = Lambda_13;
    const six_link_real Lambda_14 = link->R_P[6] * Lambda_i_15 + link->R_P[8] * Lambda_i_35;
    base->Lambda[13] = Lambda_14;
    const six_link_real Lambda_15 = link->R_P[6] * t9 + link->R_P[8] * t11;
    base->Lambda[14] = Lambda_15;
    const six_link_real t12 = (Lambda_i_44 - Lambda_i_66) * SIX_LINK_REAL(0.5);
    const six_link_real t13 = t12 * link->R_P[0] - minus_Lambda_i_46 * link->R_P[2];
    const six_link_real t14 = t12 * link->R_P[6] - minus_Lambda_i_46 * link->R_P[8];
    const six_link_real Lambda_16 = link->R_P[0] * t13 * 2 + Lambda_i_66;
    base->Lambda[15] = Lambda_16;
    const six_link_real Lambda_17 = Lambda_i_56 * link->R_P[2] - link->R_P[0] * minus_Lambda_i_45;
    base->Lambda[16] = Lambda_17;
    const six_link_real Lambda_18 = link->R_P[0] * t14 + link->R_P[6] * t13;
    base->Lambda[17] = Lambda_18;
    const six_link_real Lambda_20 = Lambda_i_56 * link->R_P[8] - link->R_P[6] * minus_Lambda_i_45;
    base->Lambda[19] = Lambda_20;
    const six_link_real Lambda_21 = link->R_P[6] * t14 * 2 + Lambda_i_66;
    base->Lambda[20] = Lambda_21;
    const six_link_real p_tau_x = link->R_P[0] * p_i_tau_x + link->R_P[2] * p_i_tau_z;
    base->p[0] = p_tau_x;
    const six_link_real p_tau_z = link->R_P[6] * p_i_tau_x + link->R_P[8] * p_i_tau_z;
    base->p[2] = p_tau_z;
    const six_link_real p_f_x = link->R_P[0] * p_i_f_x + link->R_P[2] * p_i_f_z;
    base->p[3] = p_f_x;
    const six_link_real p_f_z = link->R_P[6] * p_i_f_x + link->R_P[8] * p_i_f_z;
    base->p[5] = p_f_z;
    return SIX_LINK_OK;
}

/* eliminate, links like flange: 297 operations */
SIX_LINK_PART six_link_status eliminate_flange(const six_link_link_constants *restrict c,
    six_link_link_store *restrict link, six_link_node *restrict base, const six_link_node *restrict tip,
    const six_link_real w_ext[restrict 6], const six_link_real m_q[restrict 1], const six_link_real f_q[restrict 1],
    const six_link_real tau[restrict 1])
{
    /* Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_xx = link->omega[1] * link->omega[1] + link->omega[2] * link->omega[2];
    const six_link_real Omega_yx = link->acc_0[2] + link->omega[0] * link->omega[1];
    const six_link_real Omega_zx = link->omega[0] * link->omega[2] - link->acc_0[1];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_tau_x = c->I_s * link->acc_0[0];
    const six_link_real t1 = c->I_s * link->omega[0];
    const six_link_real H_star_tau_y = t1 * link->omega[2] - c->J_0_xx * Omega_zx - c->S_0_x * link->acc_0[5];
    const six_link_real H_star_tau_z = c->J_0_xx * Omega_yx + c->S_0_x * link->acc_0[4] - t1 * link->omega[1];
    const six_link_real H_star_f_x = link->acc_0[3] * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = Omega_yx * c->S_0_x + link->acc_0[4] * c->mu;
    const six_link_real H_star_f_z = Omega_zx * c->S_0_x + link->acc_0[5] * c->mu;

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t2 = -c->S_T_y;
    link->Lambda_i[12] = t2;
    const six_link_real t3 = c->S_T_y * tip->acc_0[5] - c->S_T_z * tip->acc_0[4]
        + (c->I_T_xx * tip->acc_0[0] - c->J_T_xy * tip->acc_0[1] - c->J_T_xz * tip->acc_0[2]);
    const six_link_real t4 = c->S_T_z * tip->acc_0[3] - c->S_T_x * tip->acc_0[5]
        + (c->I_T_yy * tip->acc_0[1] - c->J_T_xy * tip->acc_0[0] - c->J_T_yz * tip->acc_0[2]);
    const six_link_real t5 = c->S_T_x * tip->acc_0[4] - c->S_T_y * tip->acc_0[3]
        + (c->I_T_zz * tip->acc_0[2] - (c->J_T_xz * tip->acc_0[0] + c->J_T_yz * tip->acc_0[1]));
    const six_link_real t6 = c->I_T_xx * tip->omega[0] - c->J_T_xy * tip->omega[1] - c->J_T_xz * tip->omega[2];
    const six_link_real t7 = c->I_T_yy * tip->omega[1] - c->J_T_xy * tip->omega[0] - c->J_T_yz * tip->omega[2];
    const six_link_real t8 = c->I_T_zz * tip->omega[2] - (c->J_T_xz * tip->omega[0] + c->J_T_yz * tip->omega[1]);
    const six_link_real t9 = tip->omega[1] * c->S_T_z - tip->omega[2] * c->S_T_y;
    const six_link_real t10 = tip->omega[2] * c->S_T_x - tip->omega[0] * c->S_T_z;
    const six_link_real t11 = tip->omega[0] * c->S_T_y - tip->omega[1] * c->S_T_x;
    const six_link_real t12 = tip->acc_0[1] * c->S_T_z - tip->acc_0[2] * c->S_T_y
        + (tip->omega[1] * t11 - tip->omega[2] * t10);
    const six_link_real t13 = c->body0_mass * tip->acc_0[4]
        + (tip->acc_0[2] * c->S_T_x - tip->acc_0[0] * c->S_T_z + (tip->omega[2] * t9 - tip->omega[0] * t11));
    const six_link_real t14 = c->body0_mass * tip->acc_0[5]
        + (tip->acc_0[0] * c->S_T_y - tip->acc_0[1] * c->S_T_x + (tip->omega[0] * t10 - tip->omega[1] * t9));
    const six_link_real p_T_tau_x = t3 + (tip->omega[1] * t8 - tip->omega[2] * t7) - w_ext[0];
    const six_link_real p_T_tau_y = t4 + (tip->omega[2] * t6 - tip->omega[0] * t8) - w_ext[1];
    const six_link_real p_T_tau_z = t5 + (tip->omega[0] * t7 - tip->omega[1] * t6) - w_ext[2];
    const six_link_real p_T_f_x = c->body0_mass * tip->acc_0[3] + t12 - w_ext[3];
    const six_link_real p_T_f_y = t13 - w_ext[4];
    const six_link_real p_T_f_z = t14 - w_ext[5];

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t15 = c->S_T_x + c->length * c->body0_mass;
    const six_link_real t16 = c->S_T_x * c->length;
    const six_link_real t17 = c->length * t15;
    const six_link_real minus_M_loaded_12 = c->J_T_xy + c->S_T_y * c->length;
    const six_link_real minus_M_loaded_13 = c->J_T_xz + c->S_T_z * c->length;
    const six_link_real M_loaded_11 = c->I_s + c->I_T_xx;
    const six_link_real M_loaded_22 = c->J_0_xx + (c->I_T_yy + t16 + t17);
    const six_link_real M_loaded_35 = t15 + c->S_0_x;
    const six_link_real M_loaded_33 = c->J_0_xx + (c->I_T_zz + t16 + t17);
    const six_link_real M_loaded_44 = c->mu + c->body0_mass;
    link->Lambda_i[15] = M_loaded_44;
    base->Lambda[15] = M_loaded_44;
    const six_link_real h_loaded_tau_x = H_star_tau_x + p_T_tau_x;
    const six_link_real h_loaded_tau_y = H_star_tau_y + (p_T_tau_y - c->length * p_T_f_z);
    const six_link_real h_loaded_tau_z = H_star_tau_z + (p_T_tau_z + c->length * p_T_f_y);
    const six_link_real h_loaded_f_x = H_star_f_x + p_T_f_x;
    link->p_i[3] = h_loaded_f_x;
    base->p[3] = h_loaded_f_x;
    const six_link_real h_loaded_f_y = H_star_f_y + p_T_f_y;
    const six_link_real h_loaded_f_z = H_star_f_z + p_T_f_z;

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_11 = M_loaded_11 + m_q[0];
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8
        * (M_loaded_11 + M_loaded_22 + M_loaded_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_loaded_11 * joint_inverse_1;
    link->joint_W[0] = joint_W_11;
    const six_link_real minus_joint_W_12 = minus_M_loaded_12 * joint_inverse_1;
    link->joint_W[1] = -minus_joint_W_12;
    const six_link_real minus_joint_W_13 = minus_M_loaded_13 * joint_inverse_1;
    link->joint_W[2] = -minus_joint_W_13;
    const six_link_real minus_joint_W_15 = c->S_T_z * joint_inverse_1;
    link->joint_W[4] = -minus_joint_W_15;
    const six_link_real joint_W_16 = c->S_T_y * joint_inverse_1;
    link->joint_W[5] = joint_W_16;
    const six_link_real joint_w_1 = (tau[0] - f_q[0] - h_loaded_tau_x) * joint_inverse_1;
    link->joint_w[0] = joint_w_1;
    const six_link_real Lambda_i_11 = M_loaded_11 - M_loaded_11 * joint_W_11;
    link->Lambda_i[0] = Lambda_i_11;
    base->Lambda[0] = Lambda_i_11;
    const six_link_real Lambda_i_12 = M_loaded_11 * minus_joint_W_12 - minus_M_loaded_12;
    link->Lambda_i[1] = Lambda_i_12;
    const six_link_real Lambda_i_13 = M_loaded_11 * minus_joint_W_13 - minus_M_loaded_13;
    link->Lambda_i[2] = Lambda_i_13;
    const six_link_real Lambda_i_15 = M_loaded_11 * minus_joint_W_15 - c->S_T_z;
    link->Lambda_i[4] = Lambda_i_15;
    const six_link_real Lambda_i_16 = c->S_T_y - M_loaded_11 * joint_W_16;
    link->Lambda_i[5] = Lambda_i_16;
    const six_link_real Lambda_i_22 = M_loaded_22 - minus_M_loaded_12 * minus_joint_W_12;
    link->Lambda_i[6] = Lambda_i_22;
    const six_link_real Lambda_i_23 = -(minus_M_loaded_12 * minus_joint_W_13) - c->J_T_yz;
    link->Lambda_i[7] = Lambda_i_23;
    const six_link_real minus_Lambda_i_25 = minus_M_loaded_12 * minus_joint_W_15;
    link->Lambda_i[9] = -minus_Lambda_i_25;
    const six_link_real Lambda_i_26 = minus_M_loaded_12 * joint_W_16 - M_loaded_35;
    link->Lambda_i[10] = Lambda_i_26;
    const six_link_real Lambda_i_33 = M_loaded_33 - minus_M_loaded_13 * minus_joint_W_13;
    link->Lambda_i[11] = Lambda_i_33;
    const six_link_real Lambda_i_35 = M_loaded_35 - minus_M_loaded_13 * minus_joint_W_15;
    link->Lambda_i[13] = Lambda_i_35;
    const six_link_real Lambda_i_36 = minus_M_loaded_13 * joint_W_16;
    link->Lambda_i[14] = Lambda_i_36;
    const six_link_real Lambda_i_55 = M_loaded_44 - c->S_T_z * minus_joint_W_15;
    link->Lambda_i[18] = Lambda_i_55;
    const six_link_real Lambda_i_56 = c->S_T_z * joint_W_16;
    link->Lambda_i[19] = Lambda_i_56;
    const six_link_real Lambda_i_66 = M_loaded_44 - c->S_T_y * joint_W_16;
    link->Lambda_i[20] = Lambda_i_66;
    const six_link_real p_i_tau_x = h_loaded_tau_x + M_loaded_11 * joint_w_1;
    link->p_i[0] = p_i_tau_x;
    base->p[0] = p_i_tau_x;
    const six_link_real p_i_tau_y = h_loaded_tau_y - minus_M_loaded_12 * joint_w_1;
    link->p_i[1] = p_i_tau_y;
    const six_link_real p_i_tau_z = h_loaded_tau_z - minus_M_loaded_13 * joint_w_1;
    link->p_i[2] = p_i_tau_z;
    const six_link_real p_i_f_y = h_loaded_f_y - c->S_T_z * joint_w_1;
    link->p_i[4] = p_i_f_y;
    const six_link_real p_i_f_z = h_loaded_f_z + c->S_T_y * joint_w_1;
    link->p_i[5] = p_i_f_z;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real Lambda_2 = Lambda_i_12 * link->R_P[4] + Lambda_i_13 * link->R_P[5];
    base->Lambda[1] = Lambda_2;
    const six_link_real Lambda_3 = Lambda_i_12 * link->R_P[7] + Lambda_i_13 * link->R_P[8];
    base->Lambda[2] = Lambda_3;
    const six_link_real t18 = (Lambda_i_22 - Lambda_i_33) * SIX_LINK_REAL(0.5);
    const six_link_real t19 = t18 * link->R_P[4] + Lambda_i_23 * link->R_P[5];
    const six_link_real t20 = t18 * link->R_P[7] + Lambda_i_23 * link->R_P[8];
    const six_link_real Lambda_7 = link->R_P[4] * t19 * 2 + Lambda_i_33;
    base->Lambda[6] = Lambda_7;
    const six_link_real Lambda_8 = link->R_P[4] * t20 + link->R_P[7] * t19;
    base->Lambda[7] = Lambda_8;
    const six_link_real Lambda_12 = link->R_P[7] * t20 * 2 + Lambda_i_33;
    base->Lambda[11] = Lambda_12;
    const six_link_real Lambda_5 = Lambda_i_15 * link->R_P[4] + Lambda_i_16 * link->R_P[5];
    base->Lambda[4] = Lambda_5;
    const six_link_real Lambda_6 = Lambda_i_15 * link->R_P[7] + Lambda_i_16 * link->R_P[8];
    base->Lambda[5] = Lambda_6;
    const six_link_real t21 = Lambda_i_26 * link->R_P[5] - minus_Lambda_i_25 * link->R_P[4];
    const six_link_real t22 = Lambda_i_26 * link->R_P[8] - minus_Lambda_i_25 * link->R_P[7];
    const six_link_real t23 = Lambda_i_35 * link->R_P[4] + Lambda_i_36 * link->R_P[5];
    const six_link_real t24 = Lambda_i_35 * link->R_P[7] + Lambda_i_36 * link->R_P[8];
    const six_link_real Lambda_9 = link->R_P[4] * c->S_T_z - link->R_P[5] * c->S_T_y;
    base->Lambda[8] = Lambda_9;
    const six_link_real Lambda_10 = link->R_P[4] * t21 + link->R_P[5] * t23;
    base->Lambda[9] = Lambda_10;
    const six_link_real Lambda_11 = link->R_P[4] * t22 + link->R_P[5] * t24;
    base->Lambda[10] = Lambda_11;
    const six_link_real Lambda_13 = link->R_P[7] * c->S_T_z - link->R_P[8] * c->S_T_y;
    base->Lambda[12] = Lambda_13;
    const six_link_real Lambda_14 = link->R_P[7] * t21 + link->R_P[8] * t23;
    base->Lambda[13] = Lambda_14;
    const six_link_real Lambda_15 = link->R_P[7] * t22 + link->R_P[8] * t24;
    base->Lambda[14] = Lambda_15;
    const six_link_real t25 = (Lambda_i_55 - Lambda_i_66) * SIX_LINK_REAL(0.5);
    const six_link_real t26 = t25 * link->R_P[4] + Lambda_i_56 * link->R_P[5];
    const six_link_real t27 = t25 * link->R_P[7] + Lambda_i_56 * link->R_P[8];
    const six_link_real Lambda_19 = link->R_P[4] * t26 * 2 + Lambda_i_66;
    base->Lambda[18] = Lambda_19;
    const six_link_real Lambda_20 = link->R_P[4] * t27 + link->R_P[7] * t26;
    base->Lambda[19] = Lambda_20;
    const six_link_real Lambda_21 = link->R_P[7] * t27 * 2 + Lambda_i_66;
    base->Lambda[20] = Lambda_21;
    const six_link_real p_tau_y = link->R_P[4] * p_i_tau_y + link->R_P[5] * p_i_tau_z;
    base->p[1] = p_tau_y;
    const six_link_real p_tau_z = link->R_P[7] * p_i_tau_y + link->R_P[8] * p_i_tau_z;
    base->p[2] = p_tau_z;
    const six_link_real p_f_y = link->R_P[4] * p_i_f_y + link->R_P[5] * p_i_f_z;
    base->p[4] = p_f_y;
    const six_link_real p_f_z = link->R_P[7] * p_i_f_y + link->R_P[8] * p_i_f_z;
    base->p[5] = p_f_z;

    /* outputs */
    link->Lambda_i[8] = c->S_T_z;
    return SIX_LINK_OK;
}

/* accelerate, links like shoulder: 1 operations */
SIX_LINK_PART six_link_status accelerate_shoulder(const six_link_link_constants *restrict c,
    const six_link_link_store *restrict link, six_link_node *restrict tip, six_link_real qddot[restrict 1],
    six_link_real wrench[restrict 6], six_link_real alpha[restrict 6])
{
    /* tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real delta_T_a_y = link->joint_w[0] * c->length;
    tip->delta[4] = delta_T_a_y;

    /* outputs */
    qddot[0] = link->joint_w[0];
    alpha[2] = link->joint_w[0];
    alpha[3] = link->acc_0[3];
    alpha[4] = link->acc_0[4];
    alpha[5] = link->acc_0[5];
    tip->delta[2] = link->joint_w[0];

    if (wrench) {
        /* outputs */
        wrench[0] = link->p_i[0];
        wrench[1] = link->p_i[1];
        wrench[2] = link->p_i[2];
        wrench[3] = link->p_i[3];
        wrench[4] = link->p_i[4];
        wrench[5] = link->p_i[5];
    }
    return SIX_LINK_OK;
}

/* accelerate, links like upper_arm: 213 operations */
SIX_LINK_PART six_link_status accelerate_upper_arm(const six_link_link_constants *restrict c,
    const six_link_link_store *restrict link, const six_link_node *restrict base, six_link_node *restrict tip,
    six_link_real qddot[restrict 1], six_link_real wrench[restrict 6], six_link_real alpha[restrict 6],
    six_link_real etaddot[restrict 5])
{
    /* joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_alpha_x = link->R_P[6] * base->delta[2];
    const six_link_real carried_alpha_z = link->R_P[8] * base->delta[2];
    const six_link_real minus_carried_a_x = carried_alpha_z * c->mount_xyz_y;
    const six_link_real carried_a_z = carried_alpha_x * c->mount_xyz_y;
    const six_link_real carried_a_y = base->delta[4]
        + (carried_alpha_z * link->lever[0] - carried_alpha_x * link->lever[1]);
    const six_link_real t1 = link->joint_W[0] * carried_alpha_x + link->joint_W[2] * carried_alpha_z
        - link->joint_W[3] * minus_carried_a_x;
    const six_link_real qddot_1 = link->joint_w[0]
        - (t1 + link->joint_W[4] * carried_a_y + link->joint_W[5] * carried_a_z);
    qddot[0] = qddot_1;
    alpha[1] = qddot_1;

    /* link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real alpha_alpha_x = carried_alpha_x + link->acc_0[0];
    alpha[0] = alpha_alpha_x;
    const six_link_real alpha_alpha_z = carried_alpha_z + link->acc_0[2];
    alpha[2] = alpha_alpha_z;
    const six_link_real alpha_a_x = link->acc_0[3] - minus_carried_a_x;
    alpha[3] = alpha_a_x;
    const six_link_real alpha_a_y = carried_a_y + link->acc_0[4];
    alpha[4] = alpha_a_y;
    const six_link_real alpha_a_z = carried_a_z + link->acc_0[5];
    alpha[5] = alpha_a_z;
    const six_link_real t2 = link->modes_W[0] * carried_alpha_x + link->modes_W[1] * qddot_1
        + link->modes_W[2] * carried_alpha_z;
    const six_link_real t3 = t2 - link->modes_W[3] * minus_carried_a_x + link->modes_W[4] * carried_a_y
        + link->modes_W[5] * carried_a_z;
    const six_link_real t4 = link->modes_W[6] * carried_alpha_x + link->modes_W[7] * qddot_1
        + link->modes_W[8] * carried_alpha_z;
    const six_link_real t5 = t4 - link->modes_W[9] * minus_carried_a_x + link->modes_W[10] * carried_a_y
        + link->modes_W[11] * carried_a_z;
    const six_link_real t6 = link->modes_W[12] * carried_alpha_x + link->modes_W[13] * qddot_1
        + link->modes_W[14] * carried_alpha_z;
    const six_link_real t7 = -(t6 - link->modes_W[15] * minus_carried_a_x + link->modes_W[16] * carried_a_y)
        - link->modes_W[17] * carried_a_z;
    const six_link_real t8 = link->modes_W[18] * carried_alpha_x + link->modes_W[19] * qddot_1
        + link->modes_W[20] * carried_alpha_z;
    const six_link_real t9 = t8 - link->modes_W[21] * minus_carried_a_x + link->modes_W[22] * carried_a_y
        + link->modes_W[23] * carried_a_z;
    const six_link_real t10 = link->modes_W[24] * carried_alpha_x + link->modes_W[25] * qddot_1
        + link->modes_W[26] * carried_alpha_z;
    const six_link_real t11 = -(t10 - link->modes_W[27] * minus_carried_a_x + link->modes_W[28] * carried_a_y)
        - link->modes_W[29] * carried_a_z;
    const six_link_real etaddot_5 = t11 - link->modes_w[4];
    etaddot[4] = etaddot_5;
    const six_link_real etaddot_4 = -(link->modes_w[3] + t9) - link->modes_L[9] * etaddot_5;
    etaddot[3] = etaddot_4;
    const six_link_real etaddot_3 = t7 - link->modes_w[2] - link->modes_L[5] * etaddot_4 - link->modes_L[8] * etaddot_5;
    etaddot[2] = etaddot_3;
    const six_link_real etaddot_2 = -(link->modes_w[1] + t5 + link->modes_L[2] * etaddot_3
        + link->modes_L[4] * etaddot_4) - link->modes_L[7] * etaddot_5;
    etaddot[1] = etaddot_2;
    const six_link_real t12 = -(link->modes_w[0] + t3) - link->modes_L[0] * etaddot_2 - link->modes_L[1] * etaddot_3
        - link->modes_L[3] * etaddot_4;
    const six_link_real etaddot_1 = t12 - link->modes_L[6] * etaddot_5;
    etaddot[0] = etaddot_1;

    /* tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real t13 = etaddot_5 * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real t14 = c->Psi_c_y3 * etaddot_3 + c->Psi_c_y4 * etaddot_4;
    const six_link_real t15 = c->Psi_c_z1 * etaddot_1 + c->Psi_c_z2 * etaddot_2;
    const six_link_real delta_T_a_x = qddot_1 * link->r_T[1] - carried_alpha_z * link->r_T[0] - minus_carried_a_x;
    tip->delta[3] = delta_T_a_x;
    const six_link_real delta_T_alpha_x = carried_alpha_x
        + (link->J_l[0] * t13 + link->J_l[1] * t14 + link->J_l[2] * t15);
    tip->delta[0] = delta_T_alpha_x;
    const six_link_real delta_T_alpha_y = qddot_1 + (link->J_l[3] * t13 + link->J_l[4] * t14 + link->J_l[5] * t15);
    tip->delta[1] = delta_T_alpha_y;
    const six_link_real delta_T_alpha_z = carried_alpha_z
        + (link->J_l[6] * t13 + link->J_l[7] * t14 + link->J_l[8] * t15);
    tip->delta[2] = delta_T_alpha_z;
    const six_link_real delta_T_a_y = carried_a_y + (carried_alpha_z * c->length - carried_alpha_x * link->r_T[1])
        + (etaddot_1 * SIX_LINK_REAL(2.0195202782688155) + etaddot_2 * SIX_LINK_REAL(2.8145226674626453));
    tip->delta[4] = delta_T_a_y;
    const six_link_real delta_T_a_z = carried_a_z + (carried_alpha_x * link->r_T[0] - qddot_1 * c->length)
        + (etaddot_3 * SIX_LINK_REAL(2.0195202782688155) + etaddot_4 * SIX_LINK_REAL(2.8145226674626453));
    tip->delta[5] = delta_T_a_z;

    if (wrench) {
        /* joint wrench (48) */
        const six_link_real t16 = link->Lambda_i[0] * carried_alpha_x + link->Lambda_i[2] * carried_alpha_z
            - link->Lambda_i[3] * minus_carried_a_x;
        const six_link_real t17 = link->Lambda_i[1] * carried_alpha_x + link->Lambda_i[7] * carried_alpha_z
            - link->Lambda_i[8] * minus_carried_a_x;
        const six_link_real t18 = link->Lambda_i[2] * carried_alpha_x + link->Lambda_i[11] * carried_alpha_z
            - link->Lambda_i[12] * minus_carried_a_x;
        const six_link_real t19 = link->Lambda_i[3] * carried_alpha_x + link->Lambda_i[12] * carried_alpha_z
            - link->Lambda_i[15] * minus_carried_a_x;
        const six_link_real t20 = link->Lambda_i[4] * carried_alpha_x + link->Lambda_i[13] * carried_alpha_z
            - link->Lambda_i[16] * minus_carried_a_x;
        const six_link_real t21 = link->Lambda_i[5] * carried_alpha_x + link->Lambda_i[14] * carried_alpha_z
            - link->Lambda_i[17] * minus_carried_a_x;
        const six_link_real wrench_tau_x = t16 + link->Lambda_i[4] * carried_a_y + link->Lambda_i[5] * carried_a_z
            + link->p_i[0];
        wrench[0] = wrench_tau_x;
        const six_link_real wrench_tau_y = t17 + link->Lambda_i[9] * carried_a_y + link->Lambda_i[10] * carried_a_z
            + link->p_i[1];
        wrench[1] = wrench_tau_y;
        const six_link_real wrench_tau_z = t18 + link->Lambda_i[13] * carried_a_y + link->Lambda_i[14] * carried_a_z
            + link->p_i[2];
        wrench[2] = wrench_tau_z;
        const six_link_real wrench_f_x = t19 + link->Lambda_i[16] * carried_a_y + link->Lambda_i[17] * carried_a_z
            + link->p_i[3];
        wrench[3] = wrench_f_x;
        const six_link_real wrench_f_y = t20 + link->Lambda_i[18] * carried_a_y + link->Lambda_i[19] * carried_a_z
            + link->p_i[4];
        wrench[4] = wrench_f_y;
        const six_link_real wrench_f_z = t21 + link->Lambda_i[19] * carried_a_y + link->Lambda_i[20] * carried_a_z
            + link->p_i[5];
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* accelerate, links like forearm: 235 operations */
SIX_LINK_PART six_link_status accelerate_forearm(const six_link_link_constants *restrict c,
    const six_link_link_store *restrict link, const six_link_node *restrict base, six_link_node *restrict tip,
    six_link_real qddot[restrict 1], six_link_real wrench[restrict 6], six_link_real alpha[restrict 6],
    six_link_real etaddot[restrict 4])
{
    /* joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_alpha_x = link->R_P[0] * base->delta[0] + link->R_P[3] * base->delta[1]
        + link->R_P[6] * base->delta[2];
    const six_link_real carried_alpha_y = link->R_P[1] * base->delta[0] + link->R_P[4] * base->delta[1]
        + link->R_P[7] * base->delta[2];
    const six_link_real carried_alpha_z = link->R_P[2] * base->delta[0] + link->R_P[5] * base->delta[1]
        + link->R_P[8] * base->delta[2];
    const six_link_real carried_a_x = link->R_P[0] * base->delta[3] + link->R_P[3] * base->delta[4]
        + link->R_P[6] * base->delta[5] + (carried_alpha_y * link->lever[2] - carried_alpha_z * link->lever[1]);
    const six_link_real carried_a_y = link->R_P[1] * base->delta[3] + link->R_P[4] * base->delta[4]
        + link->R_P[7] * base->delta[5] + (carried_alpha_z * link->lever[0] - carried_alpha_x * link->lever[2]);
    const six_link_real carried_a_z = link->R_P[2] * base->delta[3] + link->R_P[5] * base->delta[4]
        + link->R_P[8] * base->delta[5] + (carried_alpha_x * link->lever[1] - carried_alpha_y * link->lever[0]);
    const six_link_real t1 = link->joint_W[0] * carried_alpha_x + link->joint_W[1] * carried_alpha_y
        + link->joint_W[2] * carried_alpha_z;
    const six_link_real t2 = t1 + link->joint_W[3] * carried_a_x + link->joint_W[4] * carried_a_y
        + link->joint_W[5] * carried_a_z;
    const six_link_real qddot_1 = link->joint_w[0] - t2;
    qddot[0] = qddot_1;

    /* link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_alpha_y = carried_alpha_y + qddot_1;
    const six_link_real alpha_alpha_x = carried_alpha_x + link->acc_0[0];
    alpha[0] = alpha_alpha_x;
    const six_link_real alpha_alpha_y = delta_alpha_y + link->acc_0[1];
    alpha[1] = alpha_alpha_y;
    const six_link_real alpha_alpha_z = carried_alpha_z + link->acc_0[2];
    alpha[2] = alpha_alpha_z;
    const six_link_real alpha_a_x = carried_a_x + link->acc_0[3];
    alpha[3] = alpha_a_x;
    const six_link_real alpha_a_y = carried_a_y + link->acc_0[4];
    alpha[4] = alpha_a_y;
    const six_link_real alpha_a_z = carried_a_z + link->acc_0[5];
    alpha[5] = alpha_a_z;
    const six_link_real t3 = link->modes_W[0] * carried_alpha_x + link->modes_W[1] * delta_alpha_y
        + link->modes_W[2] * carried_alpha_z;
    const six_link_real t4 = t3 + link->modes_W[3] * carried_a_x + link->modes_W[4] * carried_a_y
        + link->modes_W[5] * carried_a_z;
    const six_link_real t5 = link->modes_W[6] * carried_alpha_x + link->modes_W[7] * delta_alpha_y
        + link->modes_W[8] * carried_alpha_z;
    const six_link_real t6 = t5 + link->modes_W[9] * carried_a_x + link->modes_W[10] * carried_a_y
        + link->modes_W[11] * carried_a_z;
    const six_link_real t7 = link->modes_W[12] * carried_alpha_x + link->modes_W[13] * delta_alpha_y
        + link->modes_W[14] * carried_alpha_z;
    const six_link_real t8 = -(t7 + link->modes_W[15] * carried_a_x) - link->modes_W[16] * carried_a_y
        - link->modes_W[17] * carried_a_z;
    const six_link_real t9 = link->modes_W[18] * carried_alpha_x + link->modes_W[19] * delta_alpha_y
        + link->modes_W[20] * carried_alpha_z;
    const six_link_real t10 = t9 + link->modes_W[21] * carried_a_x + link->modes_W[22] * carried_a_y
        + link->modes_W[23] * carried_a_z;
    const six_link_real etaddot_4 = -t10 - link->modes_w[3];
    etaddot[3] = etaddot_4;
    const six_link_real etaddot_3 = t8 - link->modes_w[2] - link->modes_L[5] * etaddot_4;
    etaddot[2] = etaddot_3;
    const six_link_real etaddot_2 = -(link->modes_w[1] + t6 + link->modes_L[2] * etaddot_3)
        - link->modes_L[4] * etaddot_4;
    etaddot[1] = etaddot_2;
    const six_link_real etaddot_1 = -t4 - link->modes_w[0] - link->modes_L[0] * etaddot_2
        - link->modes_L[1] * etaddot_3 - link->modes_L[3] * etaddot_4;
    etaddot[0] = etaddot_1;

    /* tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real t11 = c->Psi_c_y3 * etaddot_3 + c->Psi_c_y4 * etaddot_4;
    const six_link_real t12 = c->Psi_c_z1 * etaddot_1 + c->Psi_c_z2 * etaddot_2;
    const six_link_real delta_T_a_x = carried_a_x + (delta_alpha_y * link->r_T[1] - carried_alpha_z * link->r_T[0]);
    tip->delta[3] = delta_T_a_x;
    const six_link_real delta_T_alpha_x = carried_alpha_x - (link->J_l[1] * t11 - link->J_l[2] * t12);
    tip->delta[0] = delta_T_alpha_x;
    const six_link_real delta_T_alpha_y = delta_alpha_y + (link->J_l[3] * t11 + link->J_l[4] * t12);
    tip->delta[1] = delta_T_alpha_y;
    const six_link_real delta_T_alpha_z = carried_alpha_z + (link->J_l[4] * t11 + link->J_l[5] * t12);
    tip->delta[2] = delta_T_alpha_z;
    const six_link_real delta_T_a_y = carried_a_y + (carried_alpha_z * c->length - carried_alpha_x * link->r_T[1])
        + (etaddot_1 * SIX_LINK_REAL(2.0195202782688155) + etaddot_2 * SIX_LINK_REAL(2.8145226674626453));
    tip->delta[4] = delta_T_a_y;
    const six_link_real delta_T_a_z = carried_a_z + (carried_alpha_x * link->r_T[0] - delta_alpha_y * c->length)
        + (etaddot_3 * SIX_LINK_REAL(2.0195202782688155) + etaddot_4 * SIX_LINK_REAL(2.8145226674626453));
    tip->delta[5] = delta_T_a_z;

    if (wrench) {
        /* joint wrench (48) */
        const six_link_real t13 = link->Lambda_i[0] * carried_alpha_x + link->Lambda_i[1] * carried_alpha_y
            + link->Lambda_i[2] * carried_alpha_z;
        const six_link_real t14 = t13 + link->Lambda_i[3] * carried_a_x + link->Lambda_i[4] * carried_a_y
            + link->Lambda_i[5] * carried_a_z;
        const six_link_real t15 = link->Lambda_i[1] * carried_alpha_x + link->Lambda_i[6] * carried_alpha_y
            + link->Lambda_i[7] * carried_alpha_z;
        const six_link_real t16 = t15 + link->Lambda_i[8] * carried_a_x + link->Lambda_i[9] * carried_a_y
            + link->Lambda_i[10] * carried_a_z;
        const six_link_real t17 = link->Lambda_i[2] * carried_alpha_x + link->Lambda_i[7] * carried_alpha_y
            + link->Lambda_i[11] * carried_alpha_z;
        const six_link_real t18 = t17 + link->Lambda_i[12] * carried_a_x + link->Lambda_i[13] * carried_a_y
            + link->Lambda_i[14] * carried_a_z;
        const six_link_real t19 = link->Lambda_i[3] * carried_alpha_x + link->Lambda_i[8] * carried_alpha_y
            + link->Lambda_i[12] * carried_alpha_z;
        const six_link_real t20 = t19 + link->Lambda_i[15] * carried_a_x + link->Lambda_i[16] * carried_a_y
            + link->Lambda_i[17] * carried_a_z;
        const six_link_real t21 = link->Lambda_i[4] * carried_alpha_x + link->Lambda_i[9] * carried_alpha_y
            + link->Lambda_i[13] * carried_alpha_z;
        const six_link_real t22 = t21 + link->Lambda_i[16] * carried_a_x + link->Lambda_i[18] * carried_a_y
            + link->Lambda_i[19] * carried_a_z;
        const six_link_real t23 = link->Lambda_i[5] * carried_alpha_x + link->Lambda_i[10] * carried_alpha_y
            + link->Lambda_i[14] * carried_alpha_z;
        const six_link_real t24 = t23 + link->Lambda_i[17] * carried_a_x + link->Lambda_i[19] * carried_a_y
            + link->Lambda_i[20] * carried_a_z;
        const six_link_real wrench_tau_x = t14 + link->p_i[0];
        wrench[0] = wrench_tau_x;
        const six_link_real wrench_tau_y = t16 + link->p_i[1];
        wrench[1] = wrench_tau_y;
        const six_link_real wrench_tau_z = t18 + link->p_i[2];
        wrench[2] = wrench_tau_z;
        const six_link_real wrench_f_x = t20 + link->p_i[3];
        wrench[3] = wrench_f_x;
        const six_link_real wrench_f_y = t22 + link->p_i[4];
        wrench[4] = wrench_f_y;
        const six_link_real wrench_f_z = t24 + link->p_i[5];
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* accelerate, links like wrist_roll: 125 operations */
SIX_LINK_PART six_link_status accelerate_wrist_roll(const six_link_link_constants *restrict c,
    const six_link_link_store *restrict link, const six_link_node *restrict base, six_link_node *restrict tip,
    six_link_real qddot[restrict 1], six_link_real wrench[restrict 6], six_link_real alpha[restrict 6])
{
    /* joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_alpha_x = link->R_P[0] * base->delta[0] + link->R_P[3] * base->delta[1]
        + link->R_P[6] * base->delta[2];
    const six_link_real carried_alpha_y = link->R_P[1] * base->delta[0] + link->R_P[4] * base->delta[1]
        + link->R_P[7] * base->delta[2];
    tip->delta[1] = carried_alpha_y;
    const six_link_real carried_alpha_z = link->R_P[2] * base->delta[0] + link->R_P[5] * base->delta[1]
        + link->R_P[8] * base->delta[2];
    tip->delta[2] = carried_alpha_z;
    const six_link_real carried_a_x = link->R_P[0] * base->delta[3] + link->R_P[3] * base->delta[4]
        + link->R_P[6] * base->delta[5];
    tip->delta[3] = carried_a_x;
    const six_link_real carried_a_y = link->R_P[1] * base->delta[3] + link->R_P[4] * base->delta[4]
        + link->R_P[7] * base->delta[5];
    const six_link_real carried_a_z = link->R_P[2] * base->delta[3] + link->R_P[5] * base->delta[4]
        + link->R_P[8] * base->delta[5];
    const six_link_real t1 = link->joint_W[0] * carried_alpha_x + link->joint_W[1] * carried_alpha_y
        + link->joint_W[2] * carried_alpha_z;
    const six_link_real t2 = t1 + link->joint_W[3] * carried_a_x + link->joint_W[4] * carried_a_y
        + link->joint_W[5] * carried_a_z;
    const six_link_real qddot_1 = link->joint_w[0] - t2;
    qddot[0] = qddot_1;

    /* link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_alpha_x = carried_alpha_x + qddot_1;
    tip->delta[0] = delta_alpha_x;
    const six_link_real alpha_alpha_x = delta_alpha_x + link->acc_0[0];
    alpha[0] = alpha_alpha_x;
    const six_link_real alpha_alpha_y = carried_alpha_y + link->acc_0[1];
    alpha[1] = alpha_alpha_y;
    const six_link_real alpha_alpha_z = carried_alpha_z + link->acc_0[2];
    alpha[2] = alpha_alpha_z;
    const six_link_real alpha_a_x = carried_a_x + link->acc_0[3];
    alpha[3] = alpha_a_x;
    const six_link_real alpha_a_y = carried_a_y + link->acc_0[4];
    alpha[4] = alpha_a_y;
    const six_link_real alpha_a_z = carried_a_z + link->acc_0[5];
    alpha[5] = alpha_a_z;

    /* tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real delta_T_a_y = carried_a_y + carried_alpha_z * c->length;
    tip->delta[4] = delta_T_a_y;
    const six_link_real delta_T_a_z = carried_a_z - carried_alpha_y * c->length;
    tip->delta[5] = delta_T_a_z;

    if (wrench) {
        /* joint wrench (48) */
        const six_link_real t3 = link->Lambda_i[0] * carried_alpha_x + link->Lambda_i[1] * carried_alpha_y
            + link->Lambda_i[2] * carried_alpha_z;
        const six_link_real t4 = t3 + link->Lambda_i[3] * carried_a_x + link->Lambda_i[4] * carried_a_y
            + link->Lambda_i[5] * carried_a_z;
        const six_link_real t5 = link->Lambda_i[1] * carried_alpha_x + link->Lambda_i[6] * carried_alpha_y
            + link->Lambda_i[7] * carried_alpha_z;
        const six_link_real t6 = t5 + link->Lambda_i[8] * carried_a_x + link->Lambda_i[9] * carried_a_y
            + link->Lambda_i[10] * carried_a_z;
        const six_link_real t7 = link->Lambda_i[2] * carried_alpha_x + link->Lambda_i[7] * carried_alpha_y
            + link->Lambda_i[11] * carried_alpha_z;
        const six_link_real t8 = t7 + link->Lambda_i[12] * carried_a_x + link->Lambda_i[13] * carried_a_y
            + link->Lambda_i[14] * carried_a_z;
        const six_link_real t9 = link->Lambda_i[3] * carried_alpha_x + link->Lambda_i[8] * carried_alpha_y
            + link->Lambda_i[12] * carried_alpha_z;
        const six_link_real t10 = t9 + link->Lambda_i[15] * carried_a_x + link->Lambda_i[16] * carried_a_y
            + link->Lambda_i[17] * carried_a_z;
        const six_link_real t11 = link->Lambda_i[4] * carried_alpha_x + link->Lambda_i[9] * carried_alpha_y
            + link->Lambda_i[13] * carried_alpha_z;
        const six_link_real t12 = t11 + link->Lambda_i[16] * carried_a_x + link->Lambda_i[18] * carried_a_y
            + link->Lambda_i[19] * carried_a_z;
        const six_link_real t13 = link->Lambda_i[5] * carried_alpha_x + link->Lambda_i[10] * carried_alpha_y
            + link->Lambda_i[14] * carried_alpha_z;
        const six_link_real t14 = t13 + link->Lambda_i[17] * carried_a_x + link->Lambda_i[19] * carried_a_y
            + link->Lambda_i[20] * carried_a_z;
        const six_link_real wrench_tau_x = t4 + link->p_i[0];
        wrench[0] = wrench_tau_x;
        const six_link_real wrench_tau_y = t6 + link->p_i[1];
        wrench[1] = wrench_tau_y;
        const six_link_real wrench_tau_z = t8 + link->p_i[2];
        wrench[2] = wrench_tau_z;
        const six_link_real wrench_f_x = t10 + link->p_i[3];
        wrench[3] = wrench_f_x;
        const six_link_real wrench_f_y = t12 + link->p_i[4];
        wrench[4] = wrench_f_y;
        const six_link_real wrench_f_z = t14 + link->p_i[5];
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* accelerate, links like wrist_pitch: 107 operations */
SIX_LINK_PART six_link_status accelerate_wrist_pitch(const six_link_link_constants *restrict c,
    const six_link_link_store *restrict link, const six_link_node *restrict base, six_link_node *restrict tip,
    six_link_real qddot[restrict 1], six_link_real wrench[restrict 6], six_link_real alpha[restrict 6])
{
    /* joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_alpha_x = link->R_P[0] * base->delta[0] + link->R_P[6] * base->delta[2];
    tip->delta[0] = carried_alpha_x;
    const six_link_real carried_alpha_z = link->R_P[2] * base->delta[0] + link->R_P[8] * base->delta[2];
    tip->delta[2] = carried_alpha_z;
    const six_link_real carried_a_x = link->R_P[0] * base->delta[3] + link->R_P[6] * base->delta[5];
    tip->delta[3] = carried_a_x;
    const six_link_real carried_a_z = link->R_P[2] * base->delta[3] + link->R_P[8] * base->delta[5];
    const six_link_real t1 = link->joint_W[0] * carried_alpha_x + link->joint_W[1] * base->delta[1]
        + link->joint_W[2] * carried_alpha_z;
    const six_link_real t2 = t1 + link->joint_W[3] * carried_a_x + link->joint_W[4] * base->delta[4]
        + link->joint_W[5] * carried_a_z;
    const six_link_real qddot_1 = link->joint_w[0] - t2;
    qddot[0] = qddot_1;

    /* link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_alpha_y = base->delta[1] + qddot_1;
    tip->delta[1] = delta_alpha_y;
    const six_link_real alpha_alpha_x = carried_alpha_x + link->acc_0[0];
    alpha[0] = alpha_alpha_x;
    const six_link_real alpha_alpha_y = delta_alpha_y + link->acc_0[1];
    alpha[1] = alpha_alpha_y;
    const six_link_real alpha_alpha_z = carried_alpha_z + link->acc_0[2];
    alpha[2] = alpha_alpha_z;
    const six_link_real alpha_a_x = carried_a_x + link->acc_0[3];
    alpha[3] = alpha_a_x;
    const six_link_real alpha_a_y = base->delta[4] + link->acc_0[4];
    alpha[4] = alpha_a_y;
    const six_link_real alpha_a_z = carried_a_z + link->acc_0[5];
    alpha[5] = alpha_a_z;

    /* tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real delta_T_a_y = base->delta[4] + carried_alpha_z * c->length;
    tip->delta[4] = delta_T_a_y;
    const six_link_real delta_T_a_z = carried_a_z - delta_alpha_y * c->length;
    tip->delta[5] = delta_T_a_z;

    if (wrench) {
        /* joint wrench (48) */
        const six_link_real t3 = link->Lambda_i[0] * carried_alpha_x + link->Lambda_i[1] * base->delta[1]
            + link->Lambda_i[2] * carried_alpha_z;
        const six_link_real t4 = t3 + link->Lambda_i[3] * carried_a_x + link->Lambda_i[4] * base->delta[4]
            + link->Lambda_i[5] * carried_a_z;
        const six_link_real t5 = link->Lambda_i[1] * carried_alpha_x + link->Lambda_i[6] * base->delta[1]
            + link->Lambda_i[7] * carried_alpha_z;
        const six_link_real t6 = t5 + link->Lambda_i[8] * carried_a_x + link->Lambda_i[9] * base->delta[4]
            + link->Lambda_i[10] * carried_a_z;
        const six_link_real t7 = link->Lambda_i[2] * carried_alpha_x + link->Lambda_i[7] * base->delta[1]
            + link->Lambda_i[11] * carried_alpha_z;
        const six_link_real t8 = t7 + link->Lambda_i[12] * carried_a_x + link->Lambda_i[13] * base->delta[4]
            + link->Lambda_i[14] * carried_a_z;
        const six_link_real t9 = link->Lambda_i[3] * carried_alpha_x + link->Lambda_i[8] * base->delta[1]
            + link->Lambda_i[12] * carried_alpha_z;
        const six_link_real t10 = t9 + link->Lambda_i[15] * carried_a_x + link->Lambda_i[16] * base->delta[4]
            + link->Lambda_i[17] * carried_a_z;
        const six_link_real t11 = link->Lambda_i[4] * carried_alpha_x + link->Lambda_i[9] * base->delta[1]
            + link->Lambda_i[13] * carried_alpha_z;
        const six_link_real t12 = t11 + link->Lambda_i[16] * carried_a_x + link->Lambda_i[18] * base->delta[4]
            + link->Lambda_i[19] * carried_a_z;
        const six_link_real t13 = link->Lambda_i[5] * carried_alpha_x + link->Lambda_i[10] * base->delta[1]
            + link->Lambda_i[14] * carried_alpha_z;
        const six_link_real t14 = t13 + link->Lambda_i[17] * carried_a_x + link->Lambda_i[19] * base->delta[4]
            + link->Lambda_i[20] * carried_a_z;
        const six_link_real wrench_tau_x = t4 + link->p_i[0];
        wrench[0] = wrench_tau_x;
        const six_link_real wrench_tau_y = t6 + link->p_i[1];
        wrench[1] = wrench_tau_y;
        const six_link_real wrench_tau_z = t8 + link->p_i[2];
        wrench[2] = wrench_tau_z;
        const six_link_real wrench_f_x = t10 + link->p_i[3];
        wrench[3] = wrench_f_x;
        const six_link_real wrench_f_y = t12 + link->p_i[4];
        wrench[4] = wrench_f_y;
        const six_link_real wrench_f_z = t14 + link->p_i[5];
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* accelerate, links like flange: 89 operations */
SIX_LINK_PART six_link_status accelerate_flange(const six_link_link_store *restrict link,
    const six_link_node *restrict base, six_link_real qddot[restrict 1], six_link_real wrench[restrict 6],
    six_link_real alpha[restrict 6])
{
    /* joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_alpha_y = link->R_P[4] * base->delta[1] + link->R_P[7] * base->delta[2];
    const six_link_real carried_alpha_z = link->R_P[5] * base->delta[1] + link->R_P[8] * base->delta[2];
    const six_link_real carried_a_y = link->R_P[4] * base->delta[4] + link->R_P[7] * base->delta[5];
    const six_link_real carried_a_z = link->R_P[5] * base->delta[4] + link->R_P[8] * base->delta[5];
    const six_link_real t1 = link->joint_W[0] * base->delta[0] + link->joint_W[1] * carried_alpha_y
        + link->joint_W[2] * carried_alpha_z;
    const six_link_real qddot_1 = link->joint_w[0]
        - (t1 + link->joint_W[4] * carried_a_y + link->joint_W[5] * carried_a_z);
    qddot[0] = qddot_1;

    /* link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_alpha_x = base->delta[0] + qddot_1;
    const six_link_real alpha_alpha_x = delta_alpha_x + link->acc_0[0];
    alpha[0] = alpha_alpha_x;
    const six_link_real alpha_alpha_y = carried_alpha_y + link->acc_0[1];
    alpha[1] = alpha_alpha_y;
    const six_link_real alpha_alpha_z = carried_alpha_z + link->acc_0[2];
    alpha[2] = alpha_alpha_z;
    const six_link_real alpha_a_x = base->delta[3] + link->acc_0[3];
    alpha[3] = alpha_a_x;
    const six_link_real alpha_a_y = carried_a_y + link->acc_0[4];
    alpha[4] = alpha_a_y;
    const six_link_real alpha_a_z = carried_a_z + link->acc_0[5];
    alpha[5] = alpha_a_z;

    if (wrench) {
        /* joint wrench (48) */
        const six_link_real t2 = link->Lambda_i[0] * base->delta[0] + link->Lambda_i[1] * carried_alpha_y
            + link->Lambda_i[2] * carried_alpha_z;
        const six_link_real t3 = link->Lambda_i[1] * base->delta[0] + link->Lambda_i[6] * carried_alpha_y
            + link->Lambda_i[7] * carried_alpha_z;
        const six_link_real t4 = t3 + link->Lambda_i[8] * base->delta[3] + link->Lambda_i[9] * carried_a_y
            + link->Lambda_i[10] * carried_a_z;
        const six_link_real t5 = link->Lambda_i[2] * base->delta[0] + link->Lambda_i[7] * carried_alpha_y
            + link->Lambda_i[11] * carried_alpha_z;
        const six_link_real t6 = t5 + link->Lambda_i[12] * base->delta[3] + link->Lambda_i[13] * carried_a_y
            + link->Lambda_i[14] * carried_a_z;
        const six_link_real t7 = link->Lambda_i[8] * carried_alpha_y + link->Lambda_i[12] * carried_alpha_z
            + link->Lambda_i[15] * base->delta[3];
        const six_link_real t8 = link->Lambda_i[4] * base->delta[0] + link->Lambda_i[9] * carried_alpha_y
            + link->Lambda_i[13] * carried_alpha_z;
        const six_link_real t9 = link->Lambda_i[5] * base->delta[0] + link->Lambda_i[10] * carried_alpha_y
            + link->Lambda_i[14] * carried_alpha_z;
        const six_link_real wrench_tau_x = t2 + link->Lambda_i[4] * carried_a_y + link->Lambda_i[5] * carried_a_z
            + link->p_i[0];
        wrench[0] = wrench_tau_x;
        const six_link_real wrench_tau_y = t4 + link->p_i[1];
        wrench[1] = wrench_tau_y;
        const six_link_real wrench_tau_z = t6 + link->p_i[2];
        wrench[2] = wrench_tau_z;
        const six_link_real wrench_f_x = t7 + link->p_i[3];
        wrench[3] = wrench_f_x;
        const six_link_real wrench_f_y = t8 + link->Lambda_i[18] * carried_a_y + link->Lambda_i[19] * carried_a_z
            + link->p_i[4];
        wrench[4] = wrench_f_y;
        const six_link_real wrench_f_z = t9 + link->Lambda_i[19] * carried_a_y + link->Lambda_i[20] * carried_a_z
            + link->p_i[5];
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* twist rates, links like shoulder: 67 operations */
SIX_LINK_PART six_link_status twist_rates_shoulder(const six_link_real quaternion[restrict 4],
    const six_link_real gravity[restrict 3], const six_link_real alpha[restrict 6],
    const six_link_real twist[restrict 6], six_link_real Vdot[restrict 6])
{
    const six_link_real t1 = quaternion[1] * quaternion[1];
    const six_link_real t2 = quaternion[2] * quaternion[2];
    const six_link_real t3 = quaternion[3] * quaternion[3];
    const six_link_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const six_link_real t5 = t1 + t2 + t3;
    const six_link_real t6 = quaternion[1] * quaternion[2];
    const six_link_real t7 = quaternion[1] * quaternion[3];
    const six_link_real t8 = quaternion[2] * quaternion[3];
    const six_link_real t9 = quaternion[0] * quaternion[3];
    const six_link_real t10 = quaternion[0] * quaternion[2];
    const six_link_real t11 = quaternion[0] * quaternion[1];
    const six_link_real t12 = alpha[3]
        + ((1 + t4 * (t1 - t5)) * gravity[0] + t4 * (t9 + t6) * gravity[1] + t4 * (t7 - t10) * gravity[2]);
    const six_link_real t13 = alpha[4]
        + (t4 * (t6 - t9) * gravity[0] + (1 + t4 * (t2 - t5)) * gravity[1] + t4 * (t11 + t8) * gravity[2]);
    const six_link_real t14 = alpha[5]
        + (t4 * (t10 + t7) * gravity[0] + t4 * (t8 - t11) * gravity[1] + (1 + t4 * (t3 - t5)) * gravity[2]);
    const six_link_real Vdot_a_x = t12 - (twist[1] * twist[5] - twist[2] * twist[4]);
    Vdot[3] = Vdot_a_x;
    const six_link_real Vdot_a_y = t13 - (twist[2] * twist[3] - twist[0] * twist[5]);
    Vdot[4] = Vdot_a_y;
    const six_link_real Vdot_a_z = t14 - (twist[0] * twist[4] - twist[1] * twist[3]);
    Vdot[5] = Vdot_a_z;

    /* outputs */
    Vdot[0] = 0;
    Vdot[1] = 0;
    Vdot[2] = alpha[2];
    return SIX_LINK_OK;
}

/* twist rates, links like upper_arm: 67 operations */
SIX_LINK_PART six_link_status twist_rates_upper_arm(const six_link_real quaternion[restrict 4],
    const six_link_real gravity[restrict 3], const six_link_real alpha[restrict 6],
    const six_link_real twist[restrict 6], six_link_real Vdot[restrict 6])
{
    const six_link_real t1 = quaternion[1] * quaternion[1];
    const six_link_real t2 = quaternion[2] * quaternion[2];
    const six_link_real t3 = quaternion[3] * quaternion[3];
    const six_link_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const six_link_real t5 = t1 + t2 + t3;
    const six_link_real t6 = quaternion[1] * quaternion[2];
    const six_link_real t7 = quaternion[1] * quaternion[3];
    const six_link_real t8 = quaternion[2] * quaternion[3];
    const six_link_real t9 = quaternion[0] * quaternion[3];
    const six_link_real t10 = quaternion[0] * quaternion[2];
    const six_link_real t11 = quaternion[0] * quaternion[1];
    const six_link_real t12 = alpha[3]
        + ((1 + t4 * (t1 - t5)) * gravity[0] + t4 * (t9 + t6) * gravity[1] + t4 * (t7 - t10) * gravity[2]);
    const six_link_real t13 = alpha[4]
        + (t4 * (t6 - t9) * gravity[0] + (1 + t4 * (t2 - t5)) * gravity[1] + t4 * (t11 + t8) * gravity[2]);
    const six_link_real t14 = alpha[5]
        + (t4 * (t10 + t7) * gravity[0] + t4 * (t8 - t11) * gravity[1] + (1 + t4 * (t3 - t5)) * gravity[2]);
    const six_link_real Vdot_a_x = t12 - (twist[1] * twist[5] - twist[2] * twist[4]);
    Vdot[3] = Vdot_a_x;
    const six_link_real Vdot_a_y = t13 - (twist[2] * twist[3] - twist[0] * twist[5]);
    Vdot[4] = Vdot_a_y;
    const six_link_real Vdot_a_z = t14 - (twist[0] * twist[4] - twist[1] * twist[3]);
    Vdot[5] = Vdot_a_z;

    /* outputs */
    Vdot[0] = alpha[0];
    Vdot[1] = alpha[1];
    Vdot[2] = alpha[2];
    return SIX_LINK_OK;
}

/* project, links like shoulder: 68 operations */
SIX_LINK_PART six_link_status project_shoulder(const six_link_link_constants *c, six_link_node *tip,
    const six_link_real q[1], const six_link_real twist[6], const six_link_real quaternion[4], six_link_real new_q[1],
    six_link_real new_twist[6], six_link_real new_quaternion[4], six_link_real new_position[3])
{
    const six_link_real t1 = quaternion[1] * quaternion[1];
    const six_link_real t2 = quaternion[2] * quaternion[2];
    const six_link_real t3 = quaternion[3] * quaternion[3];
    const six_link_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const six_link_real t5 = t1 + t2 + t3;
    const six_link_real t6 = quaternion[1] * quaternion[2];
    const six_link_real t7 = quaternion[1] * quaternion[3];
    const six_link_real t8 = quaternion[0] * quaternion[3];
    const six_link_real t9 = quaternion[0] * quaternion[2];
    const six_link_real R_m_xy = t4 * (t6 - t8);
    const six_link_real R_m_xz = t4 * (t9 + t7);
    const six_link_real R_m_yx = t4 * (t8 + t6);
    const six_link_real R_m_yz = t4 * (quaternion[2] * quaternion[3] - quaternion[0] * quaternion[1]);
    const six_link_real R_m_zx = t4 * (t7 - t9);
    const six_link_real R_m_xx = 1 + t4 * (t1 - t5);
    const six_link_real R_m_yy = 1 + t4 * (t2 - t5);
    const six_link_real R_m_zz = 1 + t4 * (t3 - t5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    const six_link_real t10 = q[0]
        + (R_rel_xx * R_m_yx - R_rel_yx * R_m_xx - (R_rel_xx * R_m_xy + R_rel_yx * R_m_yy)) * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_2 = six_link_sine_cosine(t10);
    const six_link_real R_rel_yx_2 = turn_2.sine, R_rel_xx_2 = turn_2.cosine;

    const six_link_real t11 = (R_rel_xx_2 * R_m_yx - R_rel_yx_2 * R_m_xx
        - (R_rel_xx_2 * R_m_xy + R_rel_yx_2 * R_m_yy)) * SIX_LINK_REAL(0.5);
    const six_link_real new_q_1 = t10 + t11;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_3 = six_link_sine_cosine(new_q_1);
    const six_link_real R_rel_yx_3 = turn_3.sine, R_rel_xx_3 = turn_3.cosine;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = c->length * twist[2];

    const six_link_real t12 = -R_rel_yx_3;
    const six_link_real t13 = new_q_1 * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_4 = six_link_sine_cosine(t13);
    const six_link_real new_quaternion_4 = turn_4.sine, new_quaternion_1 = turn_4.cosine;
    const six_link_real r_x = c->mount_xyz_x + R_rel_xx_3 * c->length;
    const six_link_real r_y = c->mount_xyz_y + R_rel_yx_3 * c->length;

    /* outputs */
    new_q[0] = new_q_1;
    tip->omega_m[1] = twist[1];
    tip->R_m[0] = R_m_xx;
    tip->R_m[2] = R_m_xz;
    tip->R_m[3] = R_m_yx;
    tip->R_m[5] = R_m_yz;
    tip->R_m[6] = R_m_zx;
    tip->R_m[8] = R_m_zz;
    new_twist[0] = 0;
    new_twist[1] = 0;
    new_twist[2] = twist[2];
    new_twist[3] = 0;
    new_twist[4] = 0;
    new_twist[5] = 0;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = 0;
    new_quaternion[2] = 0;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = c->mount_xyz_x;
    new_position[1] = c->mount_xyz_y;
    new_position[2] = c->mount_xyz_z;
    tip->omega_T[2] = twist[2];
    tip->v_T[1] = v_T_y;
    tip->R[0] = R_rel_xx_3;
    tip->R[1] = t12;
    tip->R[3] = R_rel_yx_3;
    tip->R[4] = R_rel_xx_3;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = c->mount_xyz_z;
    tip->Q[0] = new_quaternion_1;
    tip->Q[3] = new_quaternion_4;
    return SIX_LINK_OK;
}

/* project, links like upper_arm: 413 operations */
SIX_LINK_PART six_link_status project_upper_arm(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real twist[6], const six_link_real eta[5],
    const six_link_real etadot[5], const six_link_real quaternion[4], six_link_real new_q[1],
    six_link_real new_twist[6], six_link_real new_quaternion[4], six_link_real new_position[3])
{
    const six_link_real t1 = quaternion[1] * quaternion[1];
    const six_link_real t2 = quaternion[2] * quaternion[2];
    const six_link_real t3 = quaternion[3] * quaternion[3];
    const six_link_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const six_link_real t5 = t1 + t2 + t3;
    const six_link_real t6 = quaternion[1] * quaternion[2];
    const six_link_real t7 = quaternion[1] * quaternion[3];
    const six_link_real t8 = quaternion[2] * quaternion[3];
    const six_link_real t9 = quaternion[0] * quaternion[3];
    const six_link_real t10 = quaternion[0] * quaternion[2];
    const six_link_real t11 = quaternion[0] * quaternion[1];
    const six_link_real t12 = t4 * (t6 - t9);
    const six_link_real t13 = t4 * (t10 + t7);
    const six_link_real t14 = t4 * (t9 + t6);
    const six_link_real t15 = t4 * (t8 - t11);
    const six_link_real t16 = t4 * (t7 - t10);
    const six_link_real t17 = t4 * (t11 + t8);
    const six_link_real t18 = 1 + t4 * (t1 - t5);
    const six_link_real t19 = 1 + t4 * (t2 - t5);
    const six_link_real t20 = 1 + t4 * (t3 - t5);
    const six_link_real t21 = base->R_m[0] * t18 + base->R_m[3] * t14 + base->R_m[6] * t16;
    const six_link_real t22 = base->R_m[0] * t13 + base->R_m[3] * t15 + base->R_m[6] * t20;
    const six_link_real t23 = base->R_m[2] * t18 + base->R_m[5] * t14 + base->R_m[8] * t16;
    const six_link_real t24 = base->R_m[2] * t13 + base->R_m[5] * t15 + base->R_m[8] * t20;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    const six_link_real t25 = q[0]
        + (R_rel_xx * t22 - R_rel_xz * t24 - (R_rel_xz * t21 + R_rel_xx * t23)) * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_2 = six_link_sine_cosine(t25);
    const six_link_real R_rel_xz_2 = turn_2.sine, R_rel_xx_2 = turn_2.cosine;

    const six_link_real new_q_1 = t25
        + (R_rel_xx_2 * t22 - R_rel_xz_2 * t24 - (R_rel_xz_2 * t21 + R_rel_xx_2 * t23)) * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_3 = six_link_sine_cosine(new_q_1);
    const six_link_real R_rel_xz_3 = turn_3.sine, R_rel_xx_3 = turn_3.cosine;

    const six_link_real omega_y = twist[1] - base->omega_m[1];

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real t26 = theta_x * theta_x;
    const six_link_real t27 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t26 + t27;
    const six_link_real t28 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t28;

    /* c1: Stumpff function of order 1 */
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * six_link_c5(x);
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t27 + t28;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t26 + t28;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t29 = c2 * theta_hat2_12;
    const six_link_real t30 = c1 * theta_z;
    const six_link_real R_T_xy = t29 - t30;
    const six_link_real t31 = c1 * theta_y;
    const six_link_real t32 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t31 + t32;
    const six_link_real R_T_yx = t30 + t29;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t33 = c2 * theta_hat2_23;
    const six_link_real t34 = c1 * theta_x;
    const six_link_real R_T_yz = t33 - t34;
    const six_link_real R_T_zx = t32 - t31;
    const six_link_real R_T_zy = t34 + t33;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_x = etadot[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t35 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real t36 = theta_x * thetadot_y - theta_y * thetadot_x;
    const six_link_real t37 = theta_z * thetadot_x - theta_x * thetadot_z;
    const six_link_real omega_s_x = thetadot_x + c2 * t35 + c3 * (theta_y * t36 - theta_z * t37);
    const six_link_real omega_s_y = thetadot_y + c2 * t37 + c3 * (theta_z * t35 - theta_x * t36);
    const six_link_real omega_s_z = thetadot_z + c2 * t36 + c3 * (theta_x * t37 - theta_y * t35);

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t38 = omega_s_x + twist[0];
    const six_link_real t39 = omega_s_y + twist[1];
    const six_link_real t40 = omega_s_z + twist[2];
    const six_link_real omega_T_x = R_T_xx * t38 + R_T_yx * t39 + R_T_zx * t40;
    const six_link_real omega_T_y = R_T_xy * t38 + R_T_yy * t39 + R_T_zy * t40;
    const six_link_real omega_T_z = R_T_xz * t38 + R_T_yz * t39 + R_T_zz * t40;

    const six_link_real R_m_xx = t18 * R_T_xx + t12 * R_T_yx + t13 * R_T_zx;
    const six_link_real R_m_xy = t18 * R_T_xy + t12 * R_T_yy + t13 * R_T_zy;
    const six_link_real R_m_xz = t18 * R_T_xz + t12 * R_T_yz + t13 * R_T_zz;
    const six_link_real R_m_yx = t14 * R_T_xx + t19 * R_T_yx + t15 * R_T_zx;
    const six_link_real R_m_yy = t14 * R_T_xy + t19 * R_T_yy + t15 * R_T_zy;
    const six_link_real R_m_yz = t14 * R_T_xz + t19 * R_T_yz + t15 * R_T_zz;
    const six_link_real R_m_zx = t16 * R_T_xx + t17 * R_T_yx + t20 * R_T_zx;
    const six_link_real R_m_zy = t16 * R_T_xy + t17 * R_T_yy + t20 * R_T_zy;
    const six_link_real R_m_zz = t16 * R_T_xz + t17 * R_T_yz + t20 * R_T_zz;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real minus_omega_R_x = R_rel_xz_3 * base->omega_T[2];
    const six_link_real t41 = -minus_omega_R_x;
    const six_link_real omega_R_z = R_rel_xx_3 * base->omega_T[2];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real t42 = c->mount_xyz_y * base->omega_T[2];
    const six_link_real v_R_x = -(R_rel_xx_3 * t42);
    const six_link_real v_R_y = base->v_T[1] + c->mount_xyz_x * base->omega_T[2];
    const six_link_real v_R_z = -(R_rel_xz_3 * t42);

    const six_link_real t43 = base->R[0] * R_rel_xx_3;
    const six_link_real t44 = base->R[0] * R_rel_xz_3;
    const six_link_real t45 = base->R[3] * R_rel_xx_3;
    const six_link_real t46 = base->R[3] * R_rel_xz_3;
    const six_link_real new_position_x = base->r[0] + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y);
    const six_link_real new_position_y = base->r[1] + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y);
    const six_link_real new_position_z = base->r[2] + c->mount_xyz_z;
    const six_link_real t47 = new_q_1 * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_4 = six_link_sine_cosine(t47);
    const six_link_real t48 = turn_4.sine, t49 = turn_4.cosine;
    const six_link_real new_quaternion_1 = base->Q[0] * t49;
    const six_link_real new_quaternion_3 = base->Q[0] * t48;
    const six_link_real new_quaternion_4 = t49 * base->Q[3];
    const six_link_real minus_new_quaternion_2 = base->Q[3] * t48;
    const six_link_real t50 = -minus_new_quaternion_2;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t51 = omega_s_x - minus_omega_R_x;
    const six_link_real t52 = omega_s_y + omega_y;
    const six_link_real t53 = omega_s_z + omega_R_z;
    const six_link_real omega_T_x_2 = R_T_xx * t51 + R_T_yx * t52 + R_T_zx * t53;
    const six_link_real omega_T_y_2 = R_T_xy * t51 + R_T_yy * t52 + R_T_zy * t53;
    const six_link_real omega_T_z_2 = R_T_xz * t51 + R_T_yz * t52 + R_T_zz * t53;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t54 = omega_y * r_T_z + v_R_x - omega_R_z * r_T_y;
    const six_link_real t55 = udot_T_y + v_R_y + c->length * omega_R_z + minus_omega_R_x * r_T_z;
    const six_link_real t56 = udot_T_z + v_R_z - minus_omega_R_x * r_T_y - c->length * omega_y;
    const six_link_real v_T_x = R_T_xx * t54 + R_T_yx * t55 + R_T_zx * t56;
    const six_link_real v_T_y = R_T_xy * t54 + R_T_yy * t55 + R_T_zy * t56;
    const six_link_real v_T_z = R_T_xz * t54 + R_T_yz * t55 + R_T_zz * t56;

    const six_link_real R_xx = t43 * R_T_xx + base->R[1] * R_T_yx + t44 * R_T_zx;
    const six_link_real R_xy = t43 * R_T_xy + base->R[1] * R_T_yy + t44 * R_T_zy;
    const six_link_real R_xz = t43 * R_T_xz + base->R[1] * R_T_yz + t44 * R_T_zz;
    const six_link_real R_yx = t45 * R_T_xx + base->R[4] * R_T_yx + t46 * R_T_zx;
    const six_link_real R_yy = t45 * R_T_xy + base->R[4] * R_T_yy + t46 * R_T_zy;
    const six_link_real R_yz = t45 * R_T_xz + base->R[4] * R_T_yz + t46 * R_T_zz;
    const six_link_real R_zx = R_rel_xx_3 * R_T_zx - R_rel_xz_3 * R_T_xx;
    const six_link_real R_zy = R_rel_xx_3 * R_T_zy - R_rel_xz_3 * R_T_xy;
    const six_link_real R_zz = R_rel_xx_3 * R_T_zz - R_rel_xz_3 * R_T_xz;
    const six_link_real r_x = new_position_x + (t43 * c->length + base->R[1] * r_T_y + t44 * r_T_z);
    const six_link_real r_y = new_position_y + (t45 * c->length + base->R[4] * r_T_y + t46 * r_T_z);
    const six_link_real r_z = new_position_z + (R_rel_xx_3 * r_T_z - R_rel_xz_3 * c->length);
    const six_link_real t57 = x * SIX_LINK_REAL(0.25);
    const six_link_real t58 = 1 - t57 * (SIX_LINK_REAL(0.5) - t57 * six_link_c4(t57));
    const six_link_real t59 = (1 - t57 * (SIX_LINK_REAL(0.16666666666666666) - t57 * six_link_c5(t57)))
        * SIX_LINK_REAL(0.5);
    const six_link_real t60 = t59 * theta_x;
    const six_link_real t61 = t59 * theta_y;
    const six_link_real t62 = t59 * theta_z;
    const six_link_real Q_1 = new_quaternion_1 * t58
        - (new_quaternion_3 * t61 - minus_new_quaternion_2 * t60 + new_quaternion_4 * t62);
    const six_link_real Q_2 = new_quaternion_1 * t60 - t58 * minus_new_quaternion_2
        + (new_quaternion_3 * t62 - new_quaternion_4 * t61);
    const six_link_real Q_3 = new_quaternion_1 * t61 + t58 * new_quaternion_3
        + (new_quaternion_4 * t60 + minus_new_quaternion_2 * t62);
    const six_link_real Q_4 = new_quaternion_1 * t62 + t58 * new_quaternion_4
        - (minus_new_quaternion_2 * t61 + new_quaternion_3 * t60);

    /* outputs */
    new_q[0] = new_q_1;
    tip->omega_m[0] = omega_T_x;
    tip->omega_m[1] = omega_T_y;
    tip->omega_m[2] = omega_T_z;
    tip->R_m[0] = R_m_xx;
    tip->R_m[1] = R_m_xy;
    tip->R_m[2] = R_m_xz;
    tip->R_m[3] = R_m_yx;
    tip->R_m[4] = R_m_yy;
    tip->R_m[5] = R_m_yz;
    tip->R_m[6] = R_m_zx;
    tip->R_m[7] = R_m_zy;
    tip->R_m[8] = R_m_zz;
    new_twist[0] = t41;
    new_twist[1] = omega_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = t50;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = new_position_x;
    new_position[1] = new_position_y;
    new_position[2] = new_position_z;
    tip->omega_T[0] = omega_T_x_2;
    tip->omega_T[1] = omega_T_y_2;
    tip->omega_T[2] = omega_T_z_2;
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
    return SIX_LINK_OK;
}

/* project, links like forearm: 570 operations */
SIX_LINK_PART six_link_status project_forearm(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real twist[6], const six_link_real eta[4],
    const six_link_real etadot[4], const six_link_real quaternion[4], six_link_real new_q[1],
    six_link_real new_twist[6], six_link_real new_quaternion[4], six_link_real new_position[3])
{
    const six_link_real t1 = quaternion[1] * quaternion[1];
    const six_link_real t2 = quaternion[2] * quaternion[2];
    const six_link_real t3 = quaternion[3] * quaternion[3];
    const six_link_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const six_link_real t5 = t1 + t2 + t3;
    const six_link_real t6 = quaternion[1] * quaternion[2];
    const six_link_real t7 = quaternion[1] * quaternion[3];
    const six_link_real t8 = quaternion[2] * quaternion[3];
    const six_link_real t9 = quaternion[0] * quaternion[3];
    const six_link_real t10 = quaternion[0] * quaternion[2];
    const six_link_real t11 = quaternion[0] * quaternion[1];
    const six_link_real t12 = t4 * (t6 - t9);
    const six_link_real t13 = t4 * (t10 + t7);
    const six_link_real t14 = t4 * (t9 + t6);
    const six_link_real t15 = t4 * (t8 - t11);
    const six_link_real t16 = t4 * (t7 - t10);
    const six_link_real t17 = t4 * (t11 + t8);
    const six_link_real t18 = 1 + t4 * (t1 - t5);
    const six_link_real t19 = 1 + t4 * (t2 - t5);
    const six_link_real t20 = 1 + t4 * (t3 - t5);
    const six_link_real t21 = base->R_m[0] * t18 + base->R_m[3] * t14 + base->R_m[6] * t16;
    const six_link_real t22 = base->R_m[0] * t13 + base->R_m[3] * t15 + base->R_m[6] * t20;
    const six_link_real t23 = base->R_m[1] * t18 + base->R_m[4] * t14 + base->R_m[7] * t16;
    const six_link_real t24 = base->R_m[1] * t13 + base->R_m[4] * t15 + base->R_m[7] * t20;
    const six_link_real t25 = base->R_m[2] * t18 + base->R_m[5] * t14 + base->R_m[8] * t16;
    const six_link_real t26 = base->R_m[2] * t13 + base->R_m[5] * t15 + base->R_m[8] * t20;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real t27 = turn.sine, t28 = turn.cosine;
    const six_link_real R_rel_xx = c->R_m_xx * t28 - c->R_m_xz * t27;
    const six_link_real R_rel_xz = c->R_m_xx * t27 + c->R_m_xz * t28;
    const six_link_real R_rel_yx = c->R_m_yx * t28 - c->R_m_yz * t27;
    const six_link_real R_rel_yz = c->R_m_yx * t27 + c->R_m_yz * t28;
    const six_link_real R_rel_zx = c->R_m_zx * t28 - c->R_m_zz * t27;
    const six_link_real R_rel_zz = c->R_m_zx * t27 + c->R_m_zz * t28;

    const six_link_real t29 = R_rel_xx * t22 + R_rel_yx * t24 + R_rel_zx * t26
        - (R_rel_xz * t21 + R_rel_yz * t23 + R_rel_zz * t25);
    const six_link_real t30 = q[0] + t29 * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_2 = six_link_sine_cosine(t30);
    const six_link_real t31 = turn_2.sine, t32 = turn_2.cosine;
    const six_link_real R_rel_xx_2 = c->R_m_xx * t32 - c->R_m_xz * t31;
    const six_link_real R_rel_xz_2 = c->R_m_xx * t31 + c->R_m_xz * t32;
    const six_link_real R_rel_yx_2 = c->R_m_yx * t32 - c->R_m_yz * t31;
    const six_link_real R_rel_yz_2 = c->R_m_yx * t31 + c->R_m_yz * t32;
    const six_link_real R_rel_zx_2 = c->R_m_zx * t32 - c->R_m_zz * t31;
    const six_link_real R_rel_zz_2 = c->R_m_zx * t31 + c->R_m_zz * t32;

    const six_link_real t33 = R_rel_xx_2 * t22 + R_rel_yx_2 * t24 + R_rel_zx_2 * t26
        - (R_rel_xz_2 * t21 + R_rel_yz_2 * t23 + R_rel_zz_2 * t25);
    const six_link_real new_q_1 = t30 + t33 * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_3 = six_link_sine_cosine(new_q_1);
    const six_link_real t34 = turn_3.sine, t35 = turn_3.cosine;
    const six_link_real R_rel_xx_3 = c->R_m_xx * t35 - c->R_m_xz * t34;
    const six_link_real R_rel_xz_3 = c->R_m_xx * t34 + c->R_m_xz * t35;
    const six_link_real R_rel_yx_3 = c->R_m_yx * t35 - c->R_m_yz * t34;
    const six_link_real R_rel_yz_3 = c->R_m_yx * t34 + c->R_m_yz * t35;
    const six_link_real R_rel_zx_3 = c->R_m_zx * t35 - c->R_m_zz * t34;
    const six_link_real R_rel_zz_3 = c->R_m_zx * t34 + c->R_m_zz * t35;

    const six_link_real t36 = twist[1]
        - (c->R_m_xy * base->omega_m[0] + c->R_m_yy * base->omega_m[1] + c->R_m_zy * base->omega_m[2]);

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * six_link_c5(x);
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real R_T_yx = c1 * theta_z;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t37 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real omega_s_x = c2 * t37;
    const six_link_real omega_s_y = thetadot_y + c3 * theta_z * t37;
    const six_link_real omega_s_z = thetadot_z - c3 * theta_y * t37;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real omega_T_x = R_T_xx * (omega_s_x + twist[0]) + R_T_yx * (omega_s_y + twist[1])
        - R_T_xz * (omega_s_z + twist[2]);

    const six_link_real R_m_xy = t12 * R_T_yy - t18 * R_T_yx + t13 * R_T_yz;
    const six_link_real R_m_xz = t18 * R_T_xz + t12 * R_T_yz + t13 * R_T_zz;
    const six_link_real R_m_yy = t19 * R_T_yy - t14 * R_T_yx + t15 * R_T_yz;
    const six_link_real R_m_yz = t14 * R_T_xz + t19 * R_T_yz + t15 * R_T_zz;
    const six_link_real R_m_zy = t17 * R_T_yy - t16 * R_T_yx + t20 * R_T_yz;
    const six_link_real R_m_zz = t16 * R_T_xz + t17 * R_T_yz + t20 * R_T_zz;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx_3 * base->omega_T[0] + R_rel_yx_3 * base->omega_T[1]
        + R_rel_zx_3 * base->omega_T[2];
    const six_link_real omega_R_y = c->R_m_xy * base->omega_T[0] + c->R_m_yy * base->omega_T[1]
        + c->R_m_zy * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_xz_3 * base->omega_T[0] + R_rel_yz_3 * base->omega_T[1]
        + R_rel_zz_3 * base->omega_T[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = omega_R_y + t36;

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real t38 = base->v_T[0] + c->mount_xyz_z * base->omega_T[1] - c->mount_xyz_y * base->omega_T[2];
    const six_link_real t39 = base->v_T[1] + c->mount_xyz_x * base->omega_T[2] - c->mount_xyz_z * base->omega_T[0];
    const six_link_real t40 = base->v_T[2] + c->mount_xyz_y * base->omega_T[0] - c->mount_xyz_x * base->omega_T[1];
    const six_link_real v_R_x = R_rel_xx_3 * t38 + R_rel_yx_3 * t39 + R_rel_zx_3 * t40;
    const six_link_real v_R_y = c->R_m_xy * t38 + c->R_m_yy * t39 + c->R_m_zy * t40;
    const six_link_real v_R_z = R_rel_xz_3 * t38 + R_rel_yz_3 * t39 + R_rel_zz_3 * t40;

    const six_link_real t41 = base->R[0] * R_rel_xx_3 + base->R[1] * R_rel_yx_3 + base->R[2] * R_rel_zx_3;
    const six_link_real t42 = base->R[0] * c->R_m_xy + base->R[1] * c->R_m_yy + base->R[2] * c->R_m_zy;
    const six_link_real t43 = base->R[0] * R_rel_xz_3 + base->R[1] * R_rel_yz_3 + base->R[2] * R_rel_zz_3;
    const six_link_real t44 = base->R[3] * R_rel_xx_3 + base->R[4] * R_rel_yx_3 + base->R[5] * R_rel_zx_3;
    const six_link_real t45 = base->R[3] * c->R_m_xy + base->R[4] * c->R_m_yy + base->R[5] * c->R_m_zy;
    const six_link_real t46 = base->R[3] * R_rel_xz_3 + base->R[4] * R_rel_yz_3 + base->R[5] * R_rel_zz_3;
    const six_link_real t47 = base->R[6] * R_rel_xx_3 + base->R[7] * R_rel_yx_3 + base->R[8] * R_rel_zx_3;
    const six_link_real t48 = base->R[6] * c->R_m_xy + base->R[7] * c->R_m_yy + base->R[8] * c->R_m_zy;
    const six_link_real t49 = base->R[6] * R_rel_xz_3 + base->R[7] * R_rel_yz_3 + base->R[8] * R_rel_zz_3;
    const six_link_real new_position_x = base->r[0]
        + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y + base->R[2] * c->mount_xyz_z);
    const six_link_real new_position_y = base->r[1]
        + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y + base->R[5] * c->mount_xyz_z);
    const six_link_real new_position_z = base->r[2]
        + (base->R[6] * c->mount_xyz_x + base->R[7] * c->mount_xyz_y + base->R[8] * c->mount_xyz_z);
    const six_link_real t50 = c->mount_rpy_z * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_4 = six_link_sine_cosine(t50);
    const six_link_real t51 = turn_4.sine, t52 = turn_4.cosine;
    const six_link_real t53 = c->mount_rpy_y * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_5 = six_link_sine_cosine(t53);
    const six_link_real t54 = turn_5.sine, t55 = turn_5.cosine;
    const six_link_real t56 = c->mount_rpy_x * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_6 = six_link_sine_cosine(t56);
    const six_link_real t57 = turn_6.sine, t58 = turn_6.cosine;
    const six_link_real t59 = new_q_1 * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_7 = six_link_sine_cosine(t59);
    const six_link_real t60 = turn_7.sine, t61 = turn_7.cosine;
    const six_link_real t62 = t52 * t55;
    const six_link_real t63 = t52 * t54;
    const six_link_real t64 = t55 * t51;
    const six_link_real t65 = t51 * t54;
    const six_link_real t66 = t62 * t58 + t65 * t57;
    const six_link_real t67 = t62 * t57 - t58 * t65;
    const six_link_real t68 = t58 * t63 + t64 * t57;
    const six_link_real t69 = t58 * t64 - t63 * t57;
    const six_link_real t70 = t66 * t61 - t68 * t60;
    const six_link_real t71 = t66 * t60 + t61 * t68;
    const six_link_real t72 = t61 * t67 - t69 * t60;
    const six_link_real t73 = t61 * t69 + t67 * t60;
    const six_link_real new_quaternion_1 = base->Q[0] * t70 - (base->Q[1] * t72 + base->Q[2] * t71 + base->Q[3] * t73);
    const six_link_real new_quaternion_2 = base->Q[0] * t72 + t70 * base->Q[1] + (base->Q[2] * t73 - base->Q[3] * t71);
    const six_link_real new_quaternion_3 = base->Q[0] * t71 + t70 * base->Q[2] + (base->Q[3] * t72 - base->Q[1] * t73);
    const six_link_real new_quaternion_4 = base->Q[0] * t73 + t70 * base->Q[3] + (base->Q[1] * t71 - base->Q[2] * t72);

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t74 = omega_s_x + omega_R_x;
    const six_link_real t75 = omega_s_y + omega_y;
    const six_link_real t76 = omega_s_z + omega_R_z;
    const six_link_real omega_T_x_2 = R_T_xx * t74 + R_T_yx * t75 - R_T_xz * t76;
    const six_link_real omega_T_y = R_T_yy * t75 - R_T_yx * t74 + R_T_yz * t76;
    const six_link_real omega_T_z = R_T_xz * t74 + R_T_yz * t75 + R_T_zz * t76;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t77 = v_R_x + omega_y * r_T_z - omega_R_z * r_T_y;
    const six_link_real t78 = udot_T_y + v_R_y + c->length * omega_R_z - omega_R_x * r_T_z;
    const six_link_real t79 = udot_T_z + v_R_z + omega_R_x * r_T_y - c->length * omega_y;
    const six_link_real v_T_x = R_T_xx * t77 + R_T_yx * t78 - R_T_xz * t79;
    const six_link_real v_T_y = R_T_yy * t78 - R_T_yx * t77 + R_T_yz * t79;
    const six_link_real v_T_z = R_T_xz * t77 + R_T_yz * t78 + R_T_zz * t79;

    const six_link_real R_xx = t41 * R_T_xx + t42 * R_T_yx - t43 * R_T_xz;
    const six_link_real R_xy = t42 * R_T_yy - t41 * R_T_yx + t43 * R_T_yz;
    const six_link_real R_xz = t41 * R_T_xz + t42 * R_T_yz + t43 * R_T_zz;
    const six_link_real R_yx = t44 * R_T_xx + t45 * R_T_yx - t46 * R_T_xz;
    const six_link_real R_yy = t45 * R_T_yy - t44 * R_T_yx + t46 * R_T_yz;
    const six_link_real R_yz = t44 * R_T_xz + t45 * R_T_yz + t46 * R_T_zz;
    const six_link_real R_zx = t47 * R_T_xx + t48 * R_T_yx - t49 * R_T_xz;
    const six_link_real R_zy = t48 * R_T_yy - t47 * R_T_yx + t49 * R_T_yz;
    const six_link_real R_zz = t47 * R_T_xz + t48 * R_T_yz + t49 * R_T_zz;
    const six_link_real r_x = new_position_x + (t41 * c->length + t42 * r_T_y + t43 * r_T_z);
    const six_link_real r_y = new_position_y + (t44 * c->length + t45 * r_T_y + t46 * r_T_z);
    const six_link_real r_z = new_position_z + (t47 * c->length + t48 * r_T_y + t49 * r_T_z);
    const six_link_real t80 = x * SIX_LINK_REAL(0.25);
    const six_link_real t81 = 1 - t80 * (SIX_LINK_REAL(0.5) - t80 * six_link_c4(t80));
    const six_link_real t82 = (1 - t80 * (SIX_LINK_REAL(0.16666666666666666) - t80 * six_link_c5(t80)))
        * SIX_LINK_REAL(0.5);
    const six_link_real t83 = t82 * theta_y;
    const six_link_real t84 = t82 * theta_z;
    const six_link_real Q_1 = new_quaternion_1 * t81 - (new_quaternion_3 * t83 + new_quaternion_4 * t84);
    const six_link_real Q_2 = t81 * new_quaternion_2 + (new_quaternion_3 * t84 - new_quaternion_4 * t83);
    const six_link_real Q_3 = new_quaternion_1 * t83 + t81 * new_quaternion_3 - new_quaternion_2 * t84;
    const six_link_real Q_4 = new_quaternion_1 * t84 + t81 * new_quaternion_4 + new_quaternion_2 * t83;

    /* outputs */
    new_q[0] = new_q_1;
    tip->omega_m[0] = omega_T_x;
    tip->R_m[1] = R_m_xy;
    tip->R_m[2] = R_m_xz;
    tip->R_m[4] = R_m_yy;
    tip->R_m[5] = R_m_yz;
    tip->R_m[7] = R_m_zy;
    tip->R_m[8] = R_m_zz;
    new_twist[0] = omega_R_x;
    new_twist[1] = omega_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = new_position_x;
    new_position[1] = new_position_y;
    new_position[2] = new_position_z;
    tip->omega_T[0] = omega_T_x_2;
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
    return SIX_LINK_OK;
}

/* project, links like wrist_roll: 129 operations */
SIX_LINK_PART six_link_status project_wrist_roll(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real twist[6], const six_link_real quaternion[4],
    six_link_real new_q[1], six_link_real new_twist[6], six_link_real new_quaternion[4], six_link_real new_position[3])
{
    const six_link_real t1 = quaternion[1] * quaternion[1];
    const six_link_real t2 = quaternion[2] * quaternion[2];
    const six_link_real t3 = quaternion[3] * quaternion[3];
    const six_link_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const six_link_real t5 = t1 + t2 + t3;
    const six_link_real t6 = quaternion[1] * quaternion[2];
    const six_link_real t7 = quaternion[1] * quaternion[3];
    const six_link_real t8 = quaternion[2] * quaternion[3];
    const six_link_real t9 = quaternion[0] * quaternion[3];
    const six_link_real t10 = quaternion[0] * quaternion[2];
    const six_link_real t11 = quaternion[0] * quaternion[1];
    const six_link_real R_m_xy = t4 * (t6 - t9);
    const six_link_real R_m_xz = t4 * (t10 + t7);
    const six_link_real R_m_yx = t4 * (t9 + t6);
    const six_link_real R_m_yz = t4 * (t8 - t11);
    const six_link_real R_m_zx = t4 * (t7 - t10);
    const six_link_real R_m_zy = t4 * (t11 + t8);
    const six_link_real R_m_xx = 1 + t4 * (t1 - t5);
    const six_link_real R_m_yy = 1 + t4 * (t2 - t5);
    const six_link_real R_m_zz = 1 + t4 * (t3 - t5);
    const six_link_real t12 = base->R_m[1] * R_m_xy + base->R_m[4] * R_m_yy + base->R_m[7] * R_m_zy;
    const six_link_real t13 = base->R_m[1] * R_m_xz + base->R_m[4] * R_m_yz + base->R_m[7] * R_m_zz;
    const six_link_real t14 = base->R_m[2] * R_m_xy + base->R_m[5] * R_m_yy + base->R_m[8] * R_m_zy;
    const six_link_real t15 = base->R_m[2] * R_m_xz + base->R_m[5] * R_m_yz + base->R_m[8] * R_m_zz;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    const six_link_real t16 = q[0]
        + (R_rel_yy * t14 - R_rel_zy * t12 - (R_rel_yy * t13 + R_rel_zy * t15)) * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_2 = six_link_sine_cosine(t16);
    const six_link_real R_rel_zy_2 = turn_2.sine, R_rel_yy_2 = turn_2.cosine;

    const six_link_real new_q_1 = t16
        + (R_rel_yy_2 * t14 - R_rel_zy_2 * t12 - (R_rel_yy_2 * t13 + R_rel_zy_2 * t15)) * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_3 = six_link_sine_cosine(new_q_1);
    const six_link_real R_rel_zy_3 = turn_3.sine, R_rel_yy_3 = turn_3.cosine;

    const six_link_real t17 = twist[0] - base->omega_m[0];

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_y = R_rel_yy_3 * base->omega_T[1] + R_rel_zy_3 * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_yy_3 * base->omega_T[2] - R_rel_zy_3 * base->omega_T[1];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_x = base->omega_T[0] + t17;

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_y = R_rel_yy_3 * base->v_T[1] + R_rel_zy_3 * base->v_T[2];
    const six_link_real v_R_z = R_rel_yy_3 * base->v_T[2] - R_rel_zy_3 * base->v_T[1];

    const six_link_real R_xz = base->R[2] * R_rel_yy_3 - base->R[1] * R_rel_zy_3;
    const six_link_real R_yz = base->R[5] * R_rel_yy_3 - base->R[4] * R_rel_zy_3;
    const six_link_real R_zz = base->R[8] * R_rel_yy_3 - base->R[7] * R_rel_zy_3;
    const six_link_real t18 = new_q_1 * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_4 = six_link_sine_cosine(t18);
    const six_link_real t19 = turn_4.sine, t20 = turn_4.cosine;
    const six_link_real new_quaternion_1 = base->Q[0] * t20 - base->Q[1] * t19;
    const six_link_real new_quaternion_2 = base->Q[0] * t19 + t20 * base->Q[1];
    const six_link_real new_quaternion_3 = t20 * base->Q[2] + base->Q[3] * t19;
    const six_link_real new_quaternion_4 = t20 * base->Q[3] - base->Q[2] * t19;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = v_R_y + c->length * omega_R_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_R_y;

    const six_link_real r_x = base->r[0] + base->R[0] * c->length;
    const six_link_real r_y = base->r[1] + base->R[3] * c->length;
    const six_link_real r_z = base->r[2] + base->R[6] * c->length;

    /* outputs */
    new_q[0] = new_q_1;
    tip->omega_m[1] = twist[1];
    tip->R_m[0] = R_m_xx;
    tip->R_m[2] = R_m_xz;
    tip->R_m[3] = R_m_yx;
    tip->R_m[5] = R_m_yz;
    tip->R_m[6] = R_m_zx;
    tip->R_m[8] = R_m_zz;
    new_twist[0] = omega_x;
    new_twist[1] = omega_R_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = base->v_T[0];
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega_T[0] = omega_x;
    tip->omega_T[1] = omega_R_y;
    tip->omega_T[2] = omega_R_z;
    tip->v_T[0] = base->v_T[0];
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    tip->R[0] = base->R[0];
    tip->R[2] = R_xz;
    tip->R[3] = base->R[3];
    tip->R[5] = R_yz;
    tip->R[6] = base->R[6];
    tip->R[8] = R_zz;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = new_quaternion_1;
    tip->Q[1] = new_quaternion_2;
    tip->Q[2] = new_quaternion_3;
    tip->Q[3] = new_quaternion_4;
    return SIX_LINK_OK;
}

/* project, links like wrist_pitch: 129 operations */
SIX_LINK_PART six_link_status project_wrist_pitch(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real twist[6], const six_link_real quaternion[4],
    six_link_real new_q[1], six_link_real new_twist[6], six_link_real new_quaternion[4], six_link_real new_position[3])
{
    const six_link_real t1 = quaternion[1] * quaternion[1];
    const six_link_real t2 = quaternion[2] * quaternion[2];
    const six_link_real t3 = quaternion[3] * quaternion[3];
    const six_link_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const six_link_real t5 = t1 + t2 + t3;
    const six_link_real t6 = quaternion[1] * quaternion[2];
    const six_link_real t7 = quaternion[1] * quaternion[3];
    const six_link_real t8 = quaternion[2] * quaternion[3];
    const six_link_real t9 = quaternion[0] * quaternion[3];
    const six_link_real t10 = quaternion[0] * quaternion[2];
    const six_link_real t11 = quaternion[0] * quaternion[1];
    const six_link_real R_m_xy = t4 * (t6 - t9);
    const six_link_real R_m_xz = t4 * (t10 + t7);
    const six_link_real R_m_yx = t4 * (t9 + t6);
    const six_link_real R_m_yz = t4 * (t8 - t11);
    const six_link_real R_m_zx = t4 * (t7 - t10);
    const six_link_real R_m_zy = t4 * (t11 + t8);
    const six_link_real R_m_xx = 1 + t4 * (t1 - t5);
    const six_link_real R_m_yy = 1 + t4 * (t2 - t5);
    const six_link_real R_m_zz = 1 + t4 * (t3 - t5);
    const six_link_real t12 = base->R_m[0] * R_m_xx + base->R_m[3] * R_m_yx + base->R_m[6] * R_m_zx;
    const six_link_real t13 = base->R_m[0] * R_m_xz + base->R_m[3] * R_m_yz + base->R_m[6] * R_m_zz;
    const six_link_real t14 = base->R_m[2] * R_m_xx + base->R_m[5] * R_m_yx + base->R_m[8] * R_m_zx;
    const six_link_real t15 = base->R_m[2] * R_m_xz + base->R_m[5] * R_m_yz + base->R_m[8] * R_m_zz;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    const six_link_real t16 = q[0]
        + (R_rel_xx * t13 - R_rel_xz * t15 - (R_rel_xz * t12 + R_rel_xx * t14)) * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_2 = six_link_sine_cosine(t16);
    const six_link_real R_rel_xz_2 = turn_2.sine, R_rel_xx_2 = turn_2.cosine;

    const six_link_real new_q_1 = t16
        + (R_rel_xx_2 * t13 - R_rel_xz_2 * t15 - (R_rel_xz_2 * t12 + R_rel_xx_2 * t14)) * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_3 = six_link_sine_cosine(new_q_1);
    const six_link_real R_rel_xz_3 = turn_3.sine, R_rel_xx_3 = turn_3.cosine;

    const six_link_real t17 = twist[1] - base->omega_m[1];

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx_3 * base->omega_T[0] - R_rel_xz_3 * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_xz_3 * base->omega_T[0] + R_rel_xx_3 * base->omega_T[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = base->omega_T[1] + t17;

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_x = R_rel_xx_3 * base->v_T[0] - R_rel_xz_3 * base->v_T[2];
    const six_link_real v_R_z = R_rel_xz_3 * base->v_T[0] + R_rel_xx_3 * base->v_T[2];

    const six_link_real R_xx = base->R[0] * R_rel_xx_3 - base->R[2] * R_rel_xz_3;
    const six_link_real R_yx = base->R[3] * R_rel_xx_3 - base->R[5] * R_rel_xz_3;
    const six_link_real R_zx = base->R[6] * R_rel_xx_3 - base->R[8] * R_rel_xz_3;
    const six_link_real t18 = new_q_1 * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_4 = six_link_sine_cosine(t18);
    const six_link_real t19 = turn_4.sine, t20 = turn_4.cosine;
    const six_link_real new_quaternion_1 = base->Q[0] * t20 - base->Q[2] * t19;
    const six_link_real new_quaternion_3 = base->Q[0] * t19 + t20 * base->Q[2];
    const six_link_real new_quaternion_2 = t20 * base->Q[1] - base->Q[3] * t19;
    const six_link_real new_quaternion_4 = t20 * base->Q[3] + base->Q[1] * t19;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = base->v_T[1] + c->length * omega_R_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_y;

    const six_link_real r_x = base->r[0] + R_xx * c->length;
    const six_link_real r_y = base->r[1] + R_yx * c->length;
    const six_link_real r_z = base->r[2] + R_zx * c->length;

    /* outputs */
    new_q[0] = new_q_1;
    tip->omega_m[0] = twist[0];
    tip->R_m[1] = R_m_xy;
    tip->R_m[2] = R_m_xz;
    tip->R_m[4] = R_m_yy;
    tip->R_m[5] = R_m_yz;
    tip->R_m[7] = R_m_zy;
    tip->R_m[8] = R_m_zz;
    new_twist[0] = omega_R_x;
    new_twist[1] = omega_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = v_R_x;
    new_twist[4] = base->v_T[1];
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega_T[0] = omega_R_x;
    tip->omega_T[1] = omega_y;
    tip->omega_T[2] = omega_R_z;
    tip->v_T[0] = v_R_x;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = new_quaternion_1;
    tip->Q[1] = new_quaternion_2;
    tip->Q[2] = new_quaternion_3;
    tip->Q[3] = new_quaternion_4;
    return SIX_LINK_OK;
}

/* project, links like flange: 103 operations */
SIX_LINK_PART six_link_status project_flange(const six_link_node *base, const six_link_real q[1],
    const six_link_real twist[6], const six_link_real quaternion[4], six_link_real new_q[1], six_link_real new_twist[6],
    six_link_real new_quaternion[4], six_link_real new_position[3])
{
    const six_link_real t1 = quaternion[1] * quaternion[1];
    const six_link_real t2 = quaternion[2] * quaternion[2];
    const six_link_real t3 = quaternion[3] * quaternion[3];
    const six_link_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const six_link_real t5 = t1 + t2 + t3;
    const six_link_real t6 = quaternion[2] * quaternion[3];
    const six_link_real t7 = quaternion[0] * quaternion[1];
    const six_link_real R_m_xy = t4 * (quaternion[1] * quaternion[2] - quaternion[0] * quaternion[3]);
    const six_link_real R_m_xz = t4 * (quaternion[0] * quaternion[2] + quaternion[1] * quaternion[3]);
    const six_link_real R_m_yz = t4 * (t6 - t7);
    const six_link_real R_m_zy = t4 * (t7 + t6);
    const six_link_real R_m_yy = 1 + t4 * (t2 - t5);
    const six_link_real R_m_zz = 1 + t4 * (t3 - t5);
    const six_link_real t8 = base->R_m[1] * R_m_xy + base->R_m[4] * R_m_yy + base->R_m[7] * R_m_zy;
    const six_link_real t9 = base->R_m[1] * R_m_xz + base->R_m[4] * R_m_yz + base->R_m[7] * R_m_zz;
    const six_link_real t10 = base->R_m[2] * R_m_xy + base->R_m[5] * R_m_yy + base->R_m[8] * R_m_zy;
    const six_link_real t11 = base->R_m[2] * R_m_xz + base->R_m[5] * R_m_yz + base->R_m[8] * R_m_zz;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    const six_link_real t12 = q[0]
        + (R_rel_yy * t10 - R_rel_zy * t8 - (R_rel_yy * t9 + R_rel_zy * t11)) * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_2 = six_link_sine_cosine(t12);
    const six_link_real R_rel_zy_2 = turn_2.sine, R_rel_yy_2 = turn_2.cosine;

    const six_link_real new_q_1 = t12
        + (R_rel_yy_2 * t10 - R_rel_zy_2 * t8 - (R_rel_yy_2 * t9 + R_rel_zy_2 * t11)) * SIX_LINK_REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_3 = six_link_sine_cosine(new_q_1);
    const six_link_real R_rel_zy_3 = turn_3.sine, R_rel_yy_3 = turn_3.cosine;

    const six_link_real t13 = twist[0] - base->omega_m[0];

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_y = R_rel_yy_3 * base->omega_T[1] + R_rel_zy_3 * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_yy_3 * base->omega_T[2] - R_rel_zy_3 * base->omega_T[1];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_x = base->omega_T[0] + t13;

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_y = R_rel_yy_3 * base->v_T[1] + R_rel_zy_3 * base->v_T[2];
    const six_link_real v_R_z = R_rel_yy_3 * base->v_T[2] - R_rel_zy_3 * base->v_T[1];

    const six_link_real t14 = new_q_1 * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_4 = six_link_sine_cosine(t14);
    const six_link_real t15 = turn_4.sine, t16 = turn_4.cosine;
    const six_link_real new_quaternion_1 = base->Q[0] * t16 - base->Q[1] * t15;
    const six_link_real new_quaternion_2 = base->Q[0] * t15 + t16 * base->Q[1];
    const six_link_real new_quaternion_3 = t16 * base->Q[2] + base->Q[3] * t15;
    const six_link_real new_quaternion_4 = t16 * base->Q[3] - base->Q[2] * t15;

    /* outputs */
    new_q[0] = new_q_1;
    new_twist[0] = omega_x;
    new_twist[1] = omega_R_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = base->v_T[0];
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    return SIX_LINK_OK;
}

/* forward kinematics, links like shoulder: 11 operations */
SIX_LINK_PART six_link_status forward_kinematics_shoulder(const six_link_link_constants *c, six_link_node *tip,
    const six_link_real q[1], const six_link_real qdot[1], six_link_real new_twist[6], six_link_real new_quaternion[4],
    six_link_real new_position[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    const six_link_real t1 = -R_rel_yx;
    const six_link_real t2 = q[0] * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_2 = six_link_sine_cosine(t2);
    const six_link_real new_quaternion_4 = turn_2.sine, new_quaternion_1 = turn_2.cosine;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = c->length * qdot[0];

    const six_link_real r_x = c->mount_xyz_x + R_rel_xx * c->length;
    const six_link_real r_y = c->mount_xyz_y + R_rel_yx * c->length;

    /* outputs */
    new_twist[0] = 0;
    new_twist[1] = 0;
    new_twist[2] = qdot[0];
    new_twist[3] = 0;
    new_twist[4] = 0;
    new_twist[5] = 0;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = 0;
    new_quaternion[2] = 0;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = c->mount_xyz_x;
    new_position[1] = c->mount_xyz_y;
    new_position[2] = c->mount_xyz_z;
    tip->omega_T[2] = qdot[0];
    tip->v_T[1] = v_T_y;
    tip->R[0] = R_rel_xx;
    tip->R[1] = t1;
    tip->R[3] = R_rel_yx;
    tip->R[4] = R_rel_xx;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = c->mount_xyz_z;
    tip->Q[0] = new_quaternion_1;
    tip->Q[3] = new_quaternion_4;
    return SIX_LINK_OK;
}

/* forward kinematics, links like upper_arm: 270 operations */
SIX_LINK_PART six_link_status forward_kinematics_upper_arm(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1], const six_link_real eta[5],
    const six_link_real etadot[5], six_link_real new_twist[6], six_link_real new_quaternion[4],
    six_link_real new_position[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real minus_omega_R_x = R_rel_xz * base->omega_T[2];
    const six_link_real t1 = -minus_omega_R_x;
    const six_link_real omega_R_z = R_rel_xx * base->omega_T[2];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real t2 = c->mount_xyz_y * base->omega_T[2];
    const six_link_real v_R_x = -(R_rel_xx * t2);
    const six_link_real v_R_y = base->v_T[1] + c->mount_xyz_x * base->omega_T[2];
    const six_link_real v_R_z = -(R_rel_xz * t2);

    const six_link_real t3 = base->R[0] * R_rel_xx;
    const six_link_real t4 = base->R[0] * R_rel_xz;
    const six_link_real t5 = base->R[3] * R_rel_xx;
    const six_link_real t6 = base->R[3] * R_rel_xz;
    const six_link_real new_position_x = base->r[0] + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y);
    const six_link_real new_position_y = base->r[1] + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y);
    const six_link_real new_position_z = base->r[2] + c->mount_xyz_z;
    const six_link_real t7 = q[0] * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_2 = six_link_sine_cosine(t7);
    const six_link_real t8 = turn_2.sine, t9 = turn_2.cosine;
    const six_link_real new_quaternion_1 = base->Q[0] * t9;
    const six_link_real new_quaternion_3 = base->Q[0] * t8;
    const six_link_real new_quaternion_4 = t9 * base->Q[3];
    const six_link_real minus_new_quaternion_2 = base->Q[3] * t8;
    const six_link_real t10 = -minus_new_quaternion_2;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real t11 = theta_x * theta_x;
    const six_link_real t12 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t11 + t12;
    const six_link_real t13 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t13;

    /* c1: Stumpff function of order 1 */
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * six_link_c5(x);
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t12 + t13;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t11 + t13;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t14 = c2 * theta_hat2_12;
    const six_link_real t15 = c1 * theta_z;
    const six_link_real R_T_xy = t14 - t15;
    const six_link_real t16 = c1 * theta_y;
    const six_link_real t17 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t16 + t17;
    const six_link_real R_T_yx = t15 + t14;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t18 = c2 * theta_hat2_23;
    const six_link_real t19 = c1 * theta_x;
    const six_link_real R_T_yz = t18 - t19;
    const six_link_real R_T_zx = t17 - t16;
    const six_link_real R_T_zy = t19 + t18;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_x = etadot[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t20 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real t21 = theta_x * thetadot_y - theta_y * thetadot_x;
    const six_link_real t22 = theta_z * thetadot_x - theta_x * thetadot_z;
    const six_link_real omega_s_x = thetadot_x + c2 * t20 + c3 * (theta_y * t21 - theta_z * t22);
    const six_link_real omega_s_y = thetadot_y + c2 * t22 + c3 * (theta_z * t20 - theta_x * t21);
    const six_link_real omega_s_z = thetadot_z + c2 * t21 + c3 * (theta_x * t22 - theta_y * t20);

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t23 = omega_s_x - minus_omega_R_x;
    const six_link_real t24 = omega_s_y + qdot[0];
    const six_link_real t25 = omega_s_z + omega_R_z;
    const six_link_real omega_T_x = R_T_xx * t23 + R_T_yx * t24 + R_T_zx * t25;
    const six_link_real omega_T_y = R_T_xy * t23 + R_T_yy * t24 + R_T_zy * t25;
    const six_link_real omega_T_z = R_T_xz * t23 + R_T_yz * t24 + R_T_zz * t25;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t26 = qdot[0] * r_T_z + v_R_x - omega_R_z * r_T_y;
    const six_link_real t27 = udot_T_y + v_R_y + c->length * omega_R_z + minus_omega_R_x * r_T_z;
    const six_link_real t28 = udot_T_z + v_R_z - minus_omega_R_x * r_T_y - c->length * qdot[0];
    const six_link_real v_T_x = R_T_xx * t26 + R_T_yx * t27 + R_T_zx * t28;
    const six_link_real v_T_y = R_T_xy * t26 + R_T_yy * t27 + R_T_zy * t28;
    const six_link_real v_T_z = R_T_xz * t26 + R_T_yz * t27 + R_T_zz * t28;

    const six_link_real R_xx = t3 * R_T_xx + base->R[1] * R_T_yx + t4 * R_T_zx;
    const six_link_real R_xy = t3 * R_T_xy + base->R[1] * R_T_yy + t4 * R_T_zy;
    const six_link_real R_xz = t3 * R_T_xz + base->R[1] * R_T_yz + t4 * R_T_zz;
    const six_link_real R_yx = t5 * R_T_xx + base->R[4] * R_T_yx + t6 * R_T_zx;
    const six_link_real R_yy = t5 * R_T_xy + base->R[4] * R_T_yy + t6 * R_T_zy;
    const six_link_real R_yz = t5 * R_T_xz + base->R[4] * R_T_yz + t6 * R_T_zz;
    const six_link_real R_zx = R_rel_xx * R_T_zx - R_rel_xz * R_T_xx;
    const six_link_real R_zy = R_rel_xx * R_T_zy - R_rel_xz * R_T_xy;
    const six_link_real R_zz = R_rel_xx * R_T_zz - R_rel_xz * R_T_xz;
    const six_link_real r_x = new_position_x + (t3 * c->length + base->R[1] * r_T_y + t4 * r_T_z);
    const six_link_real r_y = new_position_y + (t5 * c->length + base->R[4] * r_T_y + t6 * r_T_z);
    const six_link_real r_z = new_position_z + (R_rel_xx * r_T_z - R_rel_xz * c->length);
    const six_link_real t29 = x * SIX_LINK_REAL(0.25);
    const six_link_real t30 = 1 - t29 * (SIX_LINK_REAL(0.5) - t29 * six_link_c4(t29));
    const six_link_real t31 = (1 - t29 * (SIX_LINK_REAL(0.16666666666666666) - t29 * six_link_c5(t29)))
        * SIX_LINK_REAL(0.5);
    const six_link_real t32 = t31 * theta_x;
    const six_link_real t33 = t31 * theta_y;
    const six_link_real t34 = t31 * theta_z;
    const six_link_real Q_1 = new_quaternion_1 * t30
        - (new_quaternion_3 * t33 - minus_new_quaternion_2 * t32 + new_quaternion_4 * t34);
    const six_link_real Q_2 = new_quaternion_1 * t32 - t30 * minus_new_quaternion_2
        + (new_quaternion_3 * t34 - new_quaternion_4 * t33);
    const six_link_real Q_3 = new_quaternion_1 * t33 + t30 * new_quaternion_3
        + (new_quaternion_4 * t32 + minus_new_quaternion_2 * t34);
    const six_link_real Q_4 = new_quaternion_1 * t34 + t30 * new_quaternion_4
        - (minus_new_quaternion_2 * t33 + new_quaternion_3 * t32);

    /* outputs */
    new_twist[0] = t1;
    new_twist[1] = qdot[0];
    new_twist[2] = omega_R_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = t10;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = new_position_x;
    new_position[1] = new_position_y;
    new_position[2] = new_position_z;
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
    return SIX_LINK_OK;
}

/* forward kinematics, links like forearm: 393 operations */
SIX_LINK_PART six_link_status forward_kinematics_forearm(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1], const six_link_real eta[4],
    const six_link_real etadot[4], six_link_real new_twist[6], six_link_real new_quaternion[4],
    six_link_real new_position[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real t1 = turn.sine, t2 = turn.cosine;
    const six_link_real R_rel_xx = c->R_m_xx * t2 - c->R_m_xz * t1;
    const six_link_real R_rel_xz = c->R_m_xx * t1 + c->R_m_xz * t2;
    const six_link_real R_rel_yx = c->R_m_yx * t2 - c->R_m_yz * t1;
    const six_link_real R_rel_yz = c->R_m_yx * t1 + c->R_m_yz * t2;
    const six_link_real R_rel_zx = c->R_m_zx * t2 - c->R_m_zz * t1;
    const six_link_real R_rel_zz = c->R_m_zx * t1 + c->R_m_zz * t2;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx * base->omega_T[0] + R_rel_yx * base->omega_T[1]
        + R_rel_zx * base->omega_T[2];
    const six_link_real omega_R_y = c->R_m_xy * base->omega_T[0] + c->R_m_yy * base->omega_T[1]
        + c->R_m_zy * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega_T[0] + R_rel_yz * base->omega_T[1]
        + R_rel_zz * base->omega_T[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = omega_R_y + qdot[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real t3 = base->v_T[0] + c->mount_xyz_z * base->omega_T[1] - c->mount_xyz_y * base->omega_T[2];
    const six_link_real t4 = base->v_T[1] + c->mount_xyz_x * base->omega_T[2] - c->mount_xyz_z * base->omega_T[0];
    const six_link_real t5 = base->v_T[2] + c->mount_xyz_y * base->omega_T[0] - c->mount_xyz_x * base->omega_T[1];
    const six_link_real v_R_x = R_rel_xx * t3 + R_rel_yx * t4 + R_rel_zx * t5;
    const six_link_real v_R_y = c->R_m_xy * t3 + c->R_m_yy * t4 + c->R_m_zy * t5;
    const six_link_real v_R_z = R_rel_xz * t3 + R_rel_yz * t4 + R_rel_zz * t5;

    const six_link_real t6 = base->R[0] * R_rel_xx + base->R[1] * R_rel_yx + base->R[2] * R_rel_zx;
    const six_link_real t7 = base->R[0] * c->R_m_xy + base->R[1] * c->R_m_yy + base->R[2] * c->R_m_zy;
    const six_link_real t8 = base->R[0] * R_rel_xz + base->R[1] * R_rel_yz + base->R[2] * R_rel_zz;
    const six_link_real t9 = base->R[3] * R_rel_xx + base->R[4] * R_rel_yx + base->R[5] * R_rel_zx;
    const six_link_real t10 = base->R[3] * c->R_m_xy + base->R[4] * c->R_m_yy + base->R[5] * c->R_m_zy;
    const six_link_real t11 = base->R[3] * R_rel_xz + base->R[4] * R_rel_yz + base->R[5] * R_rel_zz;
    const six_link_real t12 = base->R[6] * R_rel_xx + base->R[7] * R_rel_yx + base->R[8] * R_rel_zx;
    const six_link_real t13 = base->R[6] * c->R_m_xy + base->R[7] * c->R_m_yy + base->R[8] * c->R_m_zy;
    const six_link_real t14 = base->R[6] * R_rel_xz + base->R[7] * R_rel_yz + base->R[8] * R_rel_zz;
    const six_link_real new_position_x = base->r[0]
        + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y + base->R[2] * c->mount_xyz_z);
    const six_link_real new_position_y = base->r[1]
        + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y + base->R[5] * c->mount_xyz_z);
    const six_link_real new_position_z = base->r[2]
        + (base->R[6] * c->mount_xyz_x + base->R[7] * c->mount_xyz_y + base->R[8] * c->mount_xyz_z);
    const six_link_real t15 = c->mount_rpy_z * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_2 = six_link_sine_cosine(t15);
    const six_link_real t16 = turn_2.sine, t17 = turn_2.cosine;
    const six_link_real t18 = c->mount_rpy_y * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_3 = six_link_sine_cosine(t18);
    const six_link_real t19 = turn_3.sine, t20 = turn_3.cosine;
    const six_link_real t21 = c->mount_rpy_x * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_4 = six_link_sine_cosine(t21);
    const six_link_real t22 = turn_4.sine, t23 = turn_4.cosine;
    const six_link_real t24 = q[0] * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_5 = six_link_sine_cosine(t24);
    const six_link_real t25 = turn_5.sine, t26 = turn_5.cosine;
    const six_link_real t27 = t17 * t20;
    const six_link_real t28 = t17 * t19;
    const six_link_real t29 = t20 * t16;
    const six_link_real t30 = t16 * t19;
    const six_link_real t31 = t27 * t23 + t30 * t22;
    const six_link_real t32 = t27 * t22 - t23 * t30;
    const six_link_real t33 = t23 * t28 + t29 * t22;
    const six_link_real t34 = t23 * t29 - t28 * t22;
    const six_link_real t35 = t31 * t26 - t33 * t25;
    const six_link_real t36 = t31 * t25 + t26 * t33;
    const six_link_real t37 = t26 * t32 - t34 * t25;
    const six_link_real t38 = t26 * t34 + t32 * t25;
    const six_link_real new_quaternion_1 = base->Q[0] * t35 - (base->Q[1] * t37 + base->Q[2] * t36 + base->Q[3] * t38);
    const six_link_real new_quaternion_2 = base->Q[0] * t37 + t35 * base->Q[1] + (base->Q[2] * t38 - base->Q[3] * t36);
    const six_link_real new_quaternion_3 = base->Q[0] * t36 + t35 * base->Q[2] + (base->Q[3] * t37 - base->Q[1] * t38);
    const six_link_real new_quaternion_4 = base->Q[0] * t38 + t35 * base->Q[3] + (base->Q[1] * t36 - base->Q[2] * t37);

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * six_link_c5(x);
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real R_T_yx = c1 * theta_z;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t39 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real omega_s_x = c2 * t39;
    const six_link_real omega_s_y = thetadot_y + c3 * theta_z * t39;
    const six_link_real omega_s_z = thetadot_z - c3 * theta_y * t39;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t40 = omega_s_x + omega_R_x;
    const six_link_real t41 = omega_s_y + omega_y;
    const six_link_real t42 = omega_s_z + omega_R_z;
    const six_link_real omega_T_x = R_T_xx * t40 + R_T_yx * t41 - R_T_xz * t42;
    const six_link_real omega_T_y = R_T_yy * t41 - R_T_yx * t40 + R_T_yz * t42;
    const six_link_real omega_T_z = R_T_xz * t40 + R_T_yz * t41 + R_T_zz * t42;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t43 = v_R_x + omega_y * r_T_z - omega_R_z * r_T_y;
    const six_link_real t44 = udot_T_y + v_R_y + c->length * omega_R_z - omega_R_x * r_T_z;
    const six_link_real t45 = udot_T_z + v_R_z + omega_R_x * r_T_y - c->length * omega_y;
    const six_link_real v_T_x = R_T_xx * t43 + R_T_yx * t44 - R_T_xz * t45;
    const six_link_real v_T_y = R_T_yy * t44 - R_T_yx * t43 + R_T_yz * t45;
    const six_link_real v_T_z = R_T_xz * t43 + R_T_yz * t44 + R_T_zz * t45;

    const six_link_real R_xx = t6 * R_T_xx + t7 * R_T_yx - t8 * R_T_xz;
    const six_link_real R_xy = t7 * R_T_yy - t6 * R_T_yx + t8 * R_T_yz;
    const six_link_real R_xz = t6 * R_T_xz + t7 * R_T_yz + t8 * R_T_zz;
    const six_link_real R_yx = t9 * R_T_xx + t10 * R_T_yx - t11 * R_T_xz;
    const six_link_real R_yy = t10 * R_T_yy - t9 * R_T_yx + t11 * R_T_yz;
    const six_link_real R_yz = t9 * R_T_xz + t10 * R_T_yz + t11 * R_T_zz;
    const six_link_real R_zx = t12 * R_T_xx + t13 * R_T_yx - t14 * R_T_xz;
    const six_link_real R_zy = t13 * R_T_yy - t12 * R_T_yx + t14 * R_T_yz;
    const six_link_real R_zz = t12 * R_T_xz + t13 * R_T_yz + t14 * R_T_zz;
    const six_link_real r_x = new_position_x + (t6 * c->length + t7 * r_T_y + t8 * r_T_z);
    const six_link_real r_y = new_position_y + (t9 * c->length + t10 * r_T_y + t11 * r_T_z);
    const six_link_real r_z = new_position_z + (t12 * c->length + t13 * r_T_y + t14 * r_T_z);
    const six_link_real t46 = x * SIX_LINK_REAL(0.25);
    const six_link_real t47 = 1 - t46 * (SIX_LINK_REAL(0.5) - t46 * six_link_c4(t46));
    const six_link_real t48 = (1 - t46 * (SIX_LINK_REAL(0.16666666666666666) - t46 * six_link_c5(t46)))
        * SIX_LINK_REAL(0.5);
    const six_link_real t49 = t48 * theta_y;
    const six_link_real t50 = t48 * theta_z;
    const six_link_real Q_1 = new_quaternion_1 * t47 - (new_quaternion_3 * t49 + new_quaternion_4 * t50);
    const six_link_real Q_2 = t47 * new_quaternion_2 + (new_quaternion_3 * t50 - new_quaternion_4 * t49);
    const six_link_real Q_3 = new_quaternion_1 * t49 + t47 * new_quaternion_3 - new_quaternion_2 * t50;
    const six_link_real Q_4 = new_quaternion_1 * t50 + t47 * new_quaternion_4 + new_quaternion_2 * t49;

    /* outputs */
    new_twist[0] = omega_R_x;
    new_twist[1] = omega_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = new_position_x;
    new_position[1] = new_position_y;
    new_position[2] = new_position_z;
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
    return SIX_LINK_OK;
}

/* forward kinematics, links like wrist_roll: 58 operations */
SIX_LINK_PART six_link_status forward_kinematics_wrist_roll(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1], six_link_real new_twist[6],
    six_link_real new_quaternion[4], six_link_real new_position[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_y = R_rel_yy * base->omega_T[1] + R_rel_zy * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega_T[2] - R_rel_zy * base->omega_T[1];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_x = base->omega_T[0] + qdot[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_y = R_rel_yy * base->v_T[1] + R_rel_zy * base->v_T[2];
    const six_link_real v_R_z = R_rel_yy * base->v_T[2] - R_rel_zy * base->v_T[1];

    const six_link_real R_xy = base->R[1] * R_rel_yy + base->R[2] * R_rel_zy;
    const six_link_real R_xz = base->R[2] * R_rel_yy - base->R[1] * R_rel_zy;
    const six_link_real R_yy = base->R[4] * R_rel_yy + base->R[5] * R_rel_zy;
    const six_link_real R_yz = base->R[5] * R_rel_yy - base->R[4] * R_rel_zy;
    const six_link_real R_zy = base->R[7] * R_rel_yy + base->R[8] * R_rel_zy;
    const six_link_real R_zz = base->R[8] * R_rel_yy - base->R[7] * R_rel_zy;
    const six_link_real t1 = q[0] * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_2 = six_link_sine_cosine(t1);
    const six_link_real t2 = turn_2.sine, t3 = turn_2.cosine;
    const six_link_real new_quaternion_1 = base->Q[0] * t3 - base->Q[1] * t2;
    const six_link_real new_quaternion_2 = base->Q[0] * t2 + t3 * base->Q[1];
    const six_link_real new_quaternion_3 = t3 * base->Q[2] + base->Q[3] * t2;
    const six_link_real new_quaternion_4 = t3 * base->Q[3] - base->Q[2] * t2;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = v_R_y + c->length * omega_R_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_R_y;

    const six_link_real r_x = base->r[0] + base->R[0] * c->length;
    const six_link_real r_y = base->r[1] + base->R[3] * c->length;
    const six_link_real r_z = base->r[2] + base->R[6] * c->length;

    /* outputs */
    new_twist[0] = omega_x;
    new_twist[1] = omega_R_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = base->v_T[0];
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega_T[0] = omega_x;
    tip->omega_T[1] = omega_R_y;
    tip->omega_T[2] = omega_R_z;
    tip->v_T[0] = base->v_T[0];
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    tip->R[0] = base->R[0];
    tip->R[1] = R_xy;
    tip->R[2] = R_xz;
    tip->R[3] = base->R[3];
    tip->R[4] = R_yy;
    tip->R[5] = R_yz;
    tip->R[6] = base->R[6];
    tip->R[7] = R_zy;
    tip->R[8] = R_zz;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = new_quaternion_1;
    tip->Q[1] = new_quaternion_2;
    tip->Q[2] = new_quaternion_3;
    tip->Q[3] = new_quaternion_4;
    return SIX_LINK_OK;
}

/* forward kinematics, links like wrist_pitch: 58 operations */
SIX_LINK_PART six_link_status forward_kinematics_wrist_pitch(const six_link_link_constants *c,
    const six_link_node *base, six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1],
    six_link_real new_twist[6], six_link_real new_quaternion[4], six_link_real new_position[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx * base->omega_T[0] - R_rel_xz * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega_T[0] + R_rel_xx * base->omega_T[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = base->omega_T[1] + qdot[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_x = R_rel_xx * base->v_T[0] - R_rel_xz * base->v_T[2];
    const six_link_real v_R_z = R_rel_xz * base->v_T[0] + R_rel_xx * base->v_T[2];

    const six_link_real R_xx = base->R[0] * R_rel_xx - base->R[2] * R_rel_xz;
    const six_link_real R_xz = base->R[0] * R_rel_xz + base->R[2] * R_rel_xx;
    const six_link_real R_yx = base->R[3] * R_rel_xx - base->R[5] * R_rel_xz;
    const six_link_real R_yz = base->R[3] * R_rel_xz + base->R[5] * R_rel_xx;
    const six_link_real R_zx = base->R[6] * R_rel_xx - base->R[8] * R_rel_xz;
    const six_link_real R_zz = base->R[6] * R_rel_xz + base->R[8] * R_rel_xx;
    const six_link_real t1 = q[0] * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_2 = six_link_sine_cosine(t1);
    const six_link_real t2 = turn_2.sine, t3 = turn_2.cosine;
    const six_link_real new_quaternion_1 = base->Q[0] * t3 - base->Q[2] * t2;
    const six_link_real new_quaternion_3 = base->Q[0] * t2 + t3 * base->Q[2];
    const six_link_real new_quaternion_2 = t3 * base->Q[1] - base->Q[3] * t2;
    const six_link_real new_quaternion_4 = t3 * base->Q[3] + base->Q[1] * t2;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = base->v_T[1] + c->length * omega_R_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_y;

    const six_link_real r_x = base->r[0] + R_xx * c->length;
    const six_link_real r_y = base->r[1] + R_yx * c->length;
    const six_link_real r_z = base->r[2] + R_zx * c->length;

    /* outputs */
    new_twist[0] = omega_R_x;
    new_twist[1] = omega_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = v_R_x;
    new_twist[4] = base->v_T[1];
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega_T[0] = omega_R_x;
    tip->omega_T[1] = omega_y;
    tip->omega_T[2] = omega_R_z;
    tip->v_T[0] = v_R_x;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    tip->R[0] = R_xx;
    tip->R[1] = base->R[1];
    tip->R[2] = R_xz;
    tip->R[3] = R_yx;
    tip->R[4] = base->R[4];
    tip->R[5] = R_yz;
    tip->R[6] = R_zx;
    tip->R[7] = base->R[7];
    tip->R[8] = R_zz;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = new_quaternion_1;
    tip->Q[1] = new_quaternion_2;
    tip->Q[2] = new_quaternion_3;
    tip->Q[3] = new_quaternion_4;
    return SIX_LINK_OK;
}

/* forward kinematics, links like flange: 54 operations */
SIX_LINK_PART six_link_status forward_kinematics_flange(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1], six_link_real new_twist[6],
    six_link_real new_quaternion[4], six_link_real new_position[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_y = R_rel_yy * base->omega_T[1] + R_rel_zy * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega_T[2] - R_rel_zy * base->omega_T[1];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_x = base->omega_T[0] + qdot[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_y = R_rel_yy * base->v_T[1] + R_rel_zy * base->v_T[2];
    const six_link_real v_R_z = R_rel_yy * base->v_T[2] - R_rel_zy * base->v_T[1];

    const six_link_real R_xy = base->R[1] * R_rel_yy + base->R[2] * R_rel_zy;
    const six_link_real R_xz = base->R[2] * R_rel_yy - base->R[1] * R_rel_zy;
    const six_link_real R_yy = base->R[4] * R_rel_yy + base->R[5] * R_rel_zy;
    const six_link_real R_yz = base->R[5] * R_rel_yy - base->R[4] * R_rel_zy;
    const six_link_real R_zy = base->R[7] * R_rel_yy + base->R[8] * R_rel_zy;
    const six_link_real R_zz = base->R[8] * R_rel_yy - base->R[7] * R_rel_zy;
    const six_link_real t1 = q[0] * SIX_LINK_REAL(0.5);
    const six_link_sincos turn_2 = six_link_sine_cosine(t1);
    const six_link_real t2 = turn_2.sine, t3 = turn_2.cosine;
    const six_link_real new_quaternion_1 = base->Q[0] * t3 - base->Q[1] * t2;
    const six_link_real new_quaternion_2 = base->Q[0] * t2 + t3 * base->Q[1];
    const six_link_real new_quaternion_3 = t3 * base->Q[2] + base->Q[3] * t2;
    const six_link_real new_quaternion_4 = t3 * base->Q[3] - base->Q[2] * t2;
    const six_link_real r_x = base->r[0] + base->R[0] * c->length;
    const six_link_real r_y = base->r[1] + base->R[3] * c->length;
    const six_link_real r_z = base->r[2] + base->R[6] * c->length;

    /* outputs */
    new_twist[0] = omega_x;
    new_twist[1] = omega_R_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = base->v_T[0];
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->R[0] = base->R[0];
    tip->R[1] = R_xy;
    tip->R[2] = R_xz;
    tip->R[3] = base->R[3];
    tip->R[4] = R_yy;
    tip->R[5] = R_yz;
    tip->R[6] = base->R[6];
    tip->R[7] = R_zy;
    tip->R[8] = R_zz;
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    return SIX_LINK_OK;
}

/* kinematics, links like shoulder: 11 operations */
SIX_LINK_PART six_link_status kinematics_shoulder(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real a_J_x = R_rel_xx * base->acc_0[3] + R_rel_yx * base->acc_0[4];
    const six_link_real a_J_y = R_rel_xx * base->acc_0[4] - R_rel_yx * base->acc_0[3];

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real a_t_x = a_J_x - c->length * (qdot[0] * qdot[0]);

    /* outputs */
    link->omega[2] = qdot[0];
    link->acc_0[3] = a_J_x;
    link->acc_0[4] = a_J_y;
    link->acc_0[5] = base->acc_0[5];
    tip->omega[2] = qdot[0];
    tip->acc_0[3] = a_t_x;
    tip->acc_0[4] = a_J_y;
    tip->acc_0[5] = base->acc_0[5];
    return SIX_LINK_OK;
}

/* kinematics, links like upper_arm: 234 operations */
SIX_LINK_PART six_link_status kinematics_upper_arm(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1],
    const six_link_real eta[5], const six_link_real etadot[5])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real t1 = -R_rel_xz;
    const six_link_real minus_omega_R_x = R_rel_xz * base->omega[2];
    const six_link_real t2 = -minus_omega_R_x;
    const six_link_real omega_R_z = R_rel_xx * base->omega[2];

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real t3 = R_rel_xx * base->acc_0[3] - R_rel_xz * base->acc_0[5];
    const six_link_real t4 = R_rel_xz * base->acc_0[3] + R_rel_xx * base->acc_0[5];

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real minus_alpha_x = omega_R_z * qdot[0];
    const six_link_real t5 = -minus_alpha_x;
    const six_link_real minus_alpha_z = minus_omega_R_x * qdot[0];
    const six_link_real t6 = -minus_alpha_z;

    /* r_R: joint point relative to the parent's tip point */
    const six_link_real r_R_x = R_rel_xx * c->mount_xyz_x - R_rel_xz * c->mount_xyz_z;
    const six_link_real r_R_z = R_rel_xz * c->mount_xyz_x + R_rel_xx * c->mount_xyz_z;

    /* a_J: acceleration of the joint point while no joint accelerates (accconst4) */
    const six_link_real t7 = omega_R_z * r_R_x + minus_omega_R_x * r_R_z;
    const six_link_real a_J_x = t3 - omega_R_z * t7;
    const six_link_real a_J_y = base->acc_0[4] - omega_R_z * (c->mount_xyz_y * omega_R_z)
        - minus_omega_R_x * (c->mount_xyz_y * minus_omega_R_x);
    const six_link_real a_J_z = t4 - minus_omega_R_x * t7;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real t8 = theta_x * theta_x;
    const six_link_real t9 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t8 + t9;
    const six_link_real t10 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t10;

    /* c2: Stumpff function of order 2 */
    const six_link_real t11 = six_link_c4(x);
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * t11;

    /* c3: Stumpff function of order 3 */
    const six_link_real t12 = six_link_c5(x);
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * t12;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_x = etadot[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t13 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real t14 = theta_x * thetadot_y - theta_y * thetadot_x;
    const six_link_real t15 = theta_z * thetadot_x - theta_x * thetadot_z;
    const six_link_real t16 = theta_y * t14 - theta_z * t15;
    const six_link_real omega_s_x = thetadot_x + c2 * t13 + c3 * t16;
    const six_link_real t17 = theta_z * t13 - theta_x * t14;
    const six_link_real omega_s_y = thetadot_y + c2 * t15 + c3 * t17;
    const six_link_real t18 = theta_x * t15 - theta_y * t13;
    const six_link_real omega_s_z = thetadot_z + c2 * t14 + c3 * t18;

    /* xdot: rate of the squared angle */
    const six_link_real xdot = eta[4] * SIX_LINK_REAL(3.4641016151377544) * thetadot_x + theta_y * 2 * thetadot_y
        + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const six_link_real c2dot = xdot * (t11 - c3 * SIX_LINK_REAL(0.5));

    /* c3dot: rate of c3 */
    const six_link_real c3dot = xdot * (t12 * SIX_LINK_REAL(1.5) - t11 * SIX_LINK_REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_x = c2dot * t13 + c3 * (thetadot_y * t14 - thetadot_z * t15) + c3dot * t16;
    const six_link_real alpha_s_y = c2dot * t15 + c3 * (thetadot_z * t13 - thetadot_x * t14) + c3dot * t17;
    const six_link_real alpha_s_z = c2dot * t14 + c3 * (thetadot_x * t15 - thetadot_y * t13) + c3dot * t18;

    /* omega_t: angular velocity of the tip section (46) */
    const six_link_real omega_t_x = omega_s_x - minus_omega_R_x;
    const six_link_real omega_t_y = omega_s_y + qdot[0];
    const six_link_real omega_t_z = omega_s_z + omega_R_z;

    /* alpha_t: angular acceleration of the tip section (accconst1b) */
    const six_link_real alpha_t_x = alpha_s_x - minus_alpha_x + omega_s_z * qdot[0] - omega_s_y * omega_R_z;
    const six_link_real alpha_t_y = alpha_s_y + omega_s_x * omega_R_z + omega_s_z * minus_omega_R_x;
    const six_link_real alpha_t_z = alpha_s_z - minus_alpha_z - omega_s_y * minus_omega_R_x - omega_s_x * qdot[0];

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t19 = udot_T_z * 2 - minus_omega_R_x * r_T_y - c->length * qdot[0];
    const six_link_real t20 = udot_T_y * 2 + c->length * omega_R_z + minus_omega_R_x * r_T_z;
    const six_link_real a_t_x = a_J_x + qdot[0] * t19 + minus_alpha_z * r_T_y - omega_R_z * t20;
    const six_link_real t21 = qdot[0] * r_T_z - omega_R_z * r_T_y;
    const six_link_real a_t_y = a_J_y - minus_alpha_z * c->length + omega_R_z * t21 + minus_alpha_x * r_T_z
        + minus_omega_R_x * t19;
    const six_link_real a_t_z = a_J_z - minus_alpha_x * r_T_y - minus_omega_R_x * t20 - qdot[0] * t21;

    /* c1: Stumpff function of order 1 */
    const six_link_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t9 + t10;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t8 + t10;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    const six_link_real t22 = c3 * theta_hat2_12;
    const six_link_real t23 = c2 * theta_z;
    const six_link_real J_l_xy = t22 - t23;
    const six_link_real t24 = c2 * theta_y;
    const six_link_real t25 = c3 * theta_hat2_13;
    const six_link_real J_l_xz = t24 + t25;
    const six_link_real J_l_yx = t23 + t22;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const six_link_real t26 = c3 * theta_hat2_23;
    const six_link_real t27 = c2 * theta_x;
    const six_link_real J_l_yz = t26 - t27;
    const six_link_real J_l_zx = t25 - t24;
    const six_link_real J_l_zy = t27 + t26;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t28 = c2 * theta_hat2_12;
    const six_link_real t29 = c1 * theta_z;
    const six_link_real R_T_xy = t28 - t29;
    const six_link_real t30 = c1 * theta_y;
    const six_link_real t31 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t30 + t31;
    const six_link_real R_T_yx = t29 + t28;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t32 = c2 * theta_hat2_23;
    const six_link_real t33 = c1 * theta_x;
    const six_link_real R_T_yz = t32 - t33;
    const six_link_real R_T_zx = t31 - t30;
    const six_link_real R_T_zy = t33 + t32;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* outputs */
    link->R_P[0] = R_rel_xx;
    link->R_P[2] = R_rel_xz;
    link->R_P[6] = t1;
    link->R_P[8] = R_rel_xx;
    link->lever[0] = r_R_x;
    link->lever[1] = r_R_z;
    link->omega[0] = t2;
    link->omega[1] = qdot[0];
    link->omega[2] = omega_R_z;
    link->acc_0[0] = t5;
    link->acc_0[2] = t6;
    link->acc_0[3] = a_J_x;
    link->acc_0[4] = a_J_y;
    link->acc_0[5] = a_J_z;
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
    return SIX_LINK_OK;
}

/* kinematics, links like forearm: 305 operations */
SIX_LINK_PART six_link_status kinematics_forearm(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1],
    const six_link_real eta[4], const six_link_real etadot[4])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real t1 = turn.sine, t2 = turn.cosine;
    const six_link_real R_rel_xx = c->R_m_xx * t2 - c->R_m_xz * t1;
    const six_link_real R_rel_xz = c->R_m_xx * t1 + c->R_m_xz * t2;
    const six_link_real R_rel_yx = c->R_m_yx * t2 - c->R_m_yz * t1;
    const six_link_real R_rel_yz = c->R_m_yx * t1 + c->R_m_yz * t2;
    const six_link_real R_rel_zx = c->R_m_zx * t2 - c->R_m_zz * t1;
    const six_link_real R_rel_zz = c->R_m_zx * t1 + c->R_m_zz * t2;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_xx = base->R_T[0] * R_rel_xx + base->R_T[1] * R_rel_yx + base->R_T[2] * R_rel_zx;
    const six_link_real R_P_xy = base->R_T[0] * c->R_m_xy + base->R_T[1] * c->R_m_yy + base->R_T[2] * c->R_m_zy;
    const six_link_real R_P_xz = base->R_T[0] * R_rel_xz + base->R_T[1] * R_rel_yz + base->R_T[2] * R_rel_zz;
    const six_link_real R_P_yx = base->R_T[3] * R_rel_xx + base->R_T[4] * R_rel_yx + base->R_T[5] * R_rel_zx;
    const six_link_real R_P_yy = base->R_T[3] * c->R_m_xy + base->R_T[4] * c->R_m_yy + base->R_T[5] * c->R_m_zy;
    const six_link_real R_P_yz = base->R_T[3] * R_rel_xz + base->R_T[4] * R_rel_yz + base->R_T[5] * R_rel_zz;
    const six_link_real R_P_zx = base->R_T[6] * R_rel_xx + base->R_T[7] * R_rel_yx + base->R_T[8] * R_rel_zx;
    const six_link_real R_P_zy = base->R_T[6] * c->R_m_xy + base->R_T[7] * c->R_m_yy + base->R_T[8] * c->R_m_zy;
    const six_link_real R_P_zz = base->R_T[6] * R_rel_xz + base->R_T[7] * R_rel_yz + base->R_T[8] * R_rel_zz;
    const six_link_real omega_R_x = R_P_xx * base->omega[0] + R_P_yx * base->omega[1] + R_P_zx * base->omega[2];
    const six_link_real omega_R_y = R_P_xy * base->omega[0] + R_P_yy * base->omega[1] + R_P_zy * base->omega[2];
    const six_link_real omega_R_z = R_P_xz * base->omega[0] + R_P_yz * base->omega[1] + R_P_zz * base->omega[2];

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real t3 = R_P_xx * base->acc_0[0] + R_P_yx * base->acc_0[1] + R_P_zx * base->acc_0[2];
    const six_link_real acc_0_alpha_y = R_P_xy * base->acc_0[0] + R_P_yy * base->acc_0[1] + R_P_zy * base->acc_0[2];
    const six_link_real t4 = R_P_xz * base->acc_0[0] + R_P_yz * base->acc_0[1] + R_P_zz * base->acc_0[2];
    const six_link_real t5 = R_P_xx * base->acc_0[3] + R_P_yx * base->acc_0[4] + R_P_zx * base->acc_0[5];
    const six_link_real t6 = R_P_xy * base->acc_0[3] + R_P_yy * base->acc_0[4] + R_P_zy * base->acc_0[5];
    const six_link_real t7 = R_P_xz * base->acc_0[3] + R_P_yz * base->acc_0[4] + R_P_zz * base->acc_0[5];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = omega_R_y + qdot[0];

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_x = t3 - omega_R_z * qdot[0];
    const six_link_real alpha_z = t4 + omega_R_x * qdot[0];

    /* r_R: joint point relative to the parent's tip point */
    const six_link_real r_R_x = R_rel_xx * c->mount_xyz_x + R_rel_yx * c->mount_xyz_y + R_rel_zx * c->mount_xyz_z;
    const six_link_real r_R_y = c->R_m_xy * c->mount_xyz_x + c->R_m_yy * c->mount_xyz_y + c->R_m_zy * c->mount_xyz_z;
    const six_link_real r_R_z = R_rel_xz * c->mount_xyz_x + R_rel_yz * c->mount_xyz_y + R_rel_zz * c->mount_xyz_z;

    /* a_J: acceleration of the joint point while no joint accelerates (accconst4) */
    const six_link_real t8 = omega_R_x * r_R_y - omega_R_y * r_R_x;
    const six_link_real t9 = omega_R_z * r_R_x - omega_R_x * r_R_z;
    const six_link_real a_J_x = t5 + acc_0_alpha_y * r_R_z + omega_R_y * t8 - t4 * r_R_y - omega_R_z * t9;
    const six_link_real t10 = omega_R_y * r_R_z - omega_R_z * r_R_y;
    const six_link_real a_J_y = t6 + t4 * r_R_x + omega_R_z * t10 - t3 * r_R_z - omega_R_x * t8;
    const six_link_real a_J_z = t7 + t3 * r_R_y + omega_R_x * t9 - acc_0_alpha_y * r_R_x - omega_R_y * t10;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c2: Stumpff function of order 2 */
    const six_link_real t11 = six_link_c4(x);
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * t11;

    /* c3: Stumpff function of order 3 */
    const six_link_real t12 = six_link_c5(x);
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * t12;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t13 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real omega_s_x = c2 * t13;
    const six_link_real omega_s_y = thetadot_y + c3 * theta_z * t13;
    const six_link_real omega_s_z = thetadot_z - c3 * theta_y * t13;

    /* xdot: rate of the squared angle */
    const six_link_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const six_link_real c2dot = xdot * (t11 - c3 * SIX_LINK_REAL(0.5));

    /* c3dot: rate of c3 */
    const six_link_real c3dot = xdot * (t12 * SIX_LINK_REAL(1.5) - t11 * SIX_LINK_REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_x = c2dot * t13;
    const six_link_real alpha_s_y = c3 * thetadot_z * t13 + c3dot * theta_z * t13;
    const six_link_real minus_alpha_s_z = c3 * thetadot_y * t13 + c3dot * theta_y * t13;

    /* omega_t: angular velocity of the tip section (46) */
    const six_link_real omega_t_x = omega_s_x + omega_R_x;
    const six_link_real omega_t_y = omega_s_y + omega_y;
    const six_link_real omega_t_z = omega_s_z + omega_R_z;

    /* alpha_t: angular acceleration of the tip section (accconst1b) */
    const six_link_real alpha_t_x = alpha_s_x + alpha_x + omega_s_z * omega_y - omega_s_y * omega_R_z;
    const six_link_real alpha_t_y = alpha_s_y + acc_0_alpha_y + omega_s_x * omega_R_z - omega_s_z * omega_R_x;
    const six_link_real alpha_t_z = alpha_z - minus_alpha_s_z + omega_s_y * omega_R_x - omega_s_x * omega_y;

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t14 = udot_T_z * 2 + omega_R_x * r_T_y - c->length * omega_y;
    const six_link_real t15 = udot_T_y * 2 + c->length * omega_R_z - omega_R_x * r_T_z;
    const six_link_real a_t_x = a_J_x + acc_0_alpha_y * r_T_z + omega_y * t14 - alpha_z * r_T_y - omega_R_z * t15;
    const six_link_real t16 = omega_y * r_T_z - omega_R_z * r_T_y;
    const six_link_real a_t_y = a_J_y + alpha_z * c->length + omega_R_z * t16 - alpha_x * r_T_z - omega_R_x * t14;
    const six_link_real a_t_z = a_J_z + alpha_x * r_T_y + omega_R_x * t15 - acc_0_alpha_y * c->length - omega_y * t16;

    /* c1: Stumpff function of order 1 */
    const six_link_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real J_l_yx = c2 * theta_z;
    const six_link_real J_l_xz = c2 * theta_y;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const six_link_real J_l_yz = c3 * theta_hat2_23;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real R_T_yx = c1 * theta_z;
    const six_link_real t17 = -R_T_yx;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real t18 = -R_T_xz;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* outputs */
    link->R_P[0] = R_P_xx;
    link->R_P[1] = R_P_xy;
    link->R_P[2] = R_P_xz;
    link->R_P[3] = R_P_yx;
    link->R_P[4] = R_P_yy;
    link->R_P[5] = R_P_yz;
    link->R_P[6] = R_P_zx;
    link->R_P[7] = R_P_zy;
    link->R_P[8] = R_P_zz;
    link->lever[0] = r_R_x;
    link->lever[1] = r_R_y;
    link->lever[2] = r_R_z;
    link->omega[0] = omega_R_x;
    link->omega[1] = omega_y;
    link->omega[2] = omega_R_z;
    link->acc_0[0] = alpha_x;
    link->acc_0[1] = acc_0_alpha_y;
    link->acc_0[2] = alpha_z;
    link->acc_0[3] = a_J_x;
    link->acc_0[4] = a_J_y;
    link->acc_0[5] = a_J_z;
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
    link->R_T[0] = R_T_xx;
    link->R_T[1] = R_T_yx;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yy;
    link->R_T[4] = R_T_yz;
    link->R_T[5] = R_T_zz;
    link->J_l[1] = J_l_yx;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yy;
    link->J_l[4] = J_l_yz;
    link->J_l[5] = J_l_zz;
    tip->R_T[0] = R_T_xx;
    tip->R_T[1] = t17;
    tip->R_T[2] = R_T_xz;
    tip->R_T[3] = R_T_yx;
    tip->R_T[4] = R_T_yy;
    tip->R_T[5] = R_T_yz;
    tip->R_T[6] = t18;
    tip->R_T[7] = R_T_yz;
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
    return SIX_LINK_OK;
}

/* kinematics, links like wrist_roll: 85 operations */
SIX_LINK_PART six_link_status kinematics_wrist_roll(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_xy = base->R_T[1] * R_rel_yy + base->R_T[2] * R_rel_zy;
    const six_link_real R_P_xz = base->R_T[2] * R_rel_yy - base->R_T[1] * R_rel_zy;
    const six_link_real R_P_yy = base->R_T[4] * R_rel_yy + base->R_T[5] * R_rel_zy;
    const six_link_real R_P_yz = base->R_T[5] * R_rel_yy - base->R_T[4] * R_rel_zy;
    const six_link_real R_P_zy = base->R_T[7] * R_rel_yy + base->R_T[8] * R_rel_zy;
    const six_link_real R_P_zz = base->R_T[8] * R_rel_yy - base->R_T[7] * R_rel_zy;
    const six_link_real omega_R_x = base->R_T[0] * base->omega[0] + base->R_T[3] * base->omega[1]
        + base->R_T[6] * base->omega[2];
    const six_link_real omega_R_y = R_P_xy * base->omega[0] + R_P_yy * base->omega[1] + R_P_zy * base->omega[2];
    const six_link_real omega_R_z = R_P_xz * base->omega[0] + R_P_yz * base->omega[1] + R_P_zz * base->omega[2];

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real acc_0_alpha_x = base->R_T[0] * base->acc_0[0] + base->R_T[3] * base->acc_0[1]
        + base->R_T[6] * base->acc_0[2];
    const six_link_real t1 = R_P_xy * base->acc_0[0] + R_P_yy * base->acc_0[1] + R_P_zy * base->acc_0[2];
    const six_link_real t2 = R_P_xz * base->acc_0[0] + R_P_yz * base->acc_0[1] + R_P_zz * base->acc_0[2];
    const six_link_real acc_0_a_x = base->R_T[0] * base->acc_0[3] + base->R_T[3] * base->acc_0[4]
        + base->R_T[6] * base->acc_0[5];
    const six_link_real acc_0_a_y = R_P_xy * base->acc_0[3] + R_P_yy * base->acc_0[4] + R_P_zy * base->acc_0[5];
    const six_link_real acc_0_a_z = R_P_xz * base->acc_0[3] + R_P_yz * base->acc_0[4] + R_P_zz * base->acc_0[5];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_x = omega_R_x + qdot[0];

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_y = t1 + omega_R_z * qdot[0];
    const six_link_real alpha_z = t2 - omega_R_y * qdot[0];

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real a_t_x = acc_0_a_x - c->length * (omega_R_y * omega_R_y) - c->length * (omega_R_z * omega_R_z);
    const six_link_real t3 = c->length * omega_x;
    const six_link_real a_t_y = acc_0_a_y + alpha_z * c->length + t3 * omega_R_y;
    const six_link_real a_t_z = acc_0_a_z + t3 * omega_R_z - alpha_y * c->length;

    /* outputs */
    link->R_P[0] = base->R_T[0];
    link->R_P[1] = R_P_xy;
    link->R_P[2] = R_P_xz;
    link->R_P[3] = base->R_T[3];
    link->R_P[4] = R_P_yy;
    link->R_P[5] = R_P_yz;
    link->R_P[6] = base->R_T[6];
    link->R_P[7] = R_P_zy;
    link->R_P[8] = R_P_zz;
    link->omega[0] = omega_x;
    link->omega[1] = omega_R_y;
    link->omega[2] = omega_R_z;
    link->acc_0[0] = acc_0_alpha_x;
    link->acc_0[1] = alpha_y;
    link->acc_0[2] = alpha_z;
    link->acc_0[3] = acc_0_a_x;
    link->acc_0[4] = acc_0_a_y;
    link->acc_0[5] = acc_0_a_z;
    tip->omega[0] = omega_x;
    tip->omega[1] = omega_R_y;
    tip->omega[2] = omega_R_z;
    tip->acc_0[0] = acc_0_alpha_x;
    tip->acc_0[1] = alpha_y;
    tip->acc_0[2] = alpha_z;
    tip->acc_0[3] = a_t_x;
    tip->acc_0[4] = a_t_y;
    tip->acc_0[5] = a_t_z;
    return SIX_LINK_OK;
}

/* kinematics, links like wrist_pitch: 41 operations */
SIX_LINK_PART six_link_status kinematics_wrist_pitch(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real t1 = -R_rel_xz;
    const six_link_real omega_R_x = R_rel_xx * base->omega[0] - R_rel_xz * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_xx * base->omega[2];

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real t2 = R_rel_xx * base->acc_0[0] - R_rel_xz * base->acc_0[2];
    const six_link_real t3 = R_rel_xz * base->acc_0[0] + R_rel_xx * base->acc_0[2];
    const six_link_real acc_0_a_x = R_rel_xx * base->acc_0[3] - R_rel_xz * base->acc_0[5];
    const six_link_real acc_0_a_z = R_rel_xz * base->acc_0[3] + R_rel_xx * base->acc_0[5];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = base->omega[1] + qdot[0];

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_x = t2 - omega_R_z * qdot[0];
    const six_link_real alpha_z = t3 + omega_R_x * qdot[0];

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real a_t_x = acc_0_a_x - c->length * (omega_y * omega_y) - c->length * (omega_R_z * omega_R_z);
    const six_link_real t4 = c->length * omega_R_x;
    const six_link_real a_t_y = base->acc_0[4] + alpha_z * c->length + t4 * omega_y;
    const six_link_real a_t_z = acc_0_a_z + t4 * omega_R_z - base->acc_0[1] * c->length;

    /* outputs */
    link->R_P[0] = R_rel_xx;
    link->R_P[2] = R_rel_xz;
    link->R_P[6] = t1;
    link->R_P[8] = R_rel_xx;
    link->omega[0] = omega_R_x;
    link->omega[1] = omega_y;
    link->omega[2] = omega_R_z;
    link->acc_0[0] = alpha_x;
    link->acc_0[1] = base->acc_0[1];
    link->acc_0[2] = alpha_z;
    link->acc_0[3] = acc_0_a_x;
    link->acc_0[4] = base->acc_0[4];
    link->acc_0[5] = acc_0_a_z;
    tip->omega[0] = omega_R_x;
    tip->omega[1] = omega_y;
    tip->omega[2] = omega_R_z;
    tip->acc_0[0] = alpha_x;
    tip->acc_0[1] = base->acc_0[1];
    tip->acc_0[2] = alpha_z;
    tip->acc_0[3] = a_t_x;
    tip->acc_0[4] = a_t_y;
    tip->acc_0[5] = a_t_z;
    return SIX_LINK_OK;
}

/* kinematics, links like flange: 41 operations */
SIX_LINK_PART six_link_status kinematics_flange(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real t1 = -R_rel_zy;
    const six_link_real omega_R_y = R_rel_yy * base->omega[1] + R_rel_zy * base->omega[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega[2] - R_rel_zy * base->omega[1];

    /* acceleration of the parent's tip in F_i axes */
    const six_link_real t2 = R_rel_yy * base->acc_0[1] + R_rel_zy * base->acc_0[2];
    const six_link_real t3 = R_rel_yy * base->acc_0[2] - R_rel_zy * base->acc_0[1];
    const six_link_real acc_0_a_y = R_rel_yy * base->acc_0[4] + R_rel_zy * base->acc_0[5];
    const six_link_real acc_0_a_z = R_rel_yy * base->acc_0[5] - R_rel_zy * base->acc_0[4];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_x = base->omega[0] + qdot[0];

    /* alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_y = t2 + omega_R_z * qdot[0];
    const six_link_real alpha_z = t3 - omega_R_y * qdot[0];

    /* a_t: acceleration of the tip point (accconst1b) */
    const six_link_real a_t_x = base->acc_0[3] - c->length * (omega_R_y * omega_R_y)
        - c->length * (omega_R_z * omega_R_z);
    const six_link_real t4 = c->length * omega_x;
    const six_link_real a_t_y = acc_0_a_y + alpha_z * c->length + t4 * omega_R_y;
    const six_link_real a_t_z = acc_0_a_z + t4 * omega_R_z - alpha_y * c->length;

    /* outputs */
    link->R_P[4] = R_rel_yy;
    link->R_P[5] = t1;
    link->R_P[7] = R_rel_zy;
    link->R_P[8] = R_rel_yy;
    link->omega[0] = omega_x;
    link->omega[1] = omega_R_y;
    link->omega[2] = omega_R_z;
    link->acc_0[0] = base->acc_0[0];
    link->acc_0[1] = alpha_y;
    link->acc_0[2] = alpha_z;
    link->acc_0[3] = base->acc_0[3];
    link->acc_0[4] = acc_0_a_y;
    link->acc_0[5] = acc_0_a_z;
    tip->omega[0] = omega_x;
    tip->omega[1] = omega_R_y;
    tip->omega[2] = omega_R_z;
    tip->acc_0[0] = base->acc_0[0];
    tip->acc_0[1] = alpha_y;
    tip->acc_0[2] = alpha_z;
    tip->acc_0[3] = a_t_x;
    tip->acc_0[4] = a_t_y;
    tip->acc_0[5] = a_t_z;
    return SIX_LINK_OK;
}

/* inverse outward, links like shoulder: 1 operations */
SIX_LINK_PART six_link_status inverse_outward_shoulder(const six_link_link_constants *c, six_link_link_store *link,
    six_link_node *tip, const six_link_real qddot[1])
{
    const six_link_real delta_a_y = qddot[0] * c->length;

    /* outputs */
    link->delta[2] = qddot[0];
    tip->delta[2] = qddot[0];
    tip->delta[4] = delta_a_y;
    return SIX_LINK_OK;
}

/* inverse outward, links like upper_arm: 54 operations */
SIX_LINK_PART six_link_status inverse_outward_upper_arm(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real qddot[1], const six_link_real etaddot[5])
{
    const six_link_real delta_alpha_x = link->R_P[6] * base->delta[2];
    const six_link_real delta_alpha_z = link->R_P[8] * base->delta[2];
    const six_link_real delta_a_x = -(delta_alpha_z * c->mount_xyz_y);
    const six_link_real delta_a_z = delta_alpha_x * c->mount_xyz_y;
    const six_link_real delta_a_y = base->delta[4] + (delta_alpha_z * link->lever[0] - delta_alpha_x * link->lever[1]);
    const six_link_real t1 = etaddot[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real t2 = c->Psi_c_y3 * etaddot[2] + c->Psi_c_y4 * etaddot[3];
    const six_link_real t3 = c->Psi_c_z1 * etaddot[0] + c->Psi_c_z2 * etaddot[1];
    const six_link_real delta_a_x_2 = qddot[0] * link->r_T[1] - delta_alpha_z * link->r_T[0] + delta_a_x;
    const six_link_real delta_alpha_x_2 = delta_alpha_x + (link->J_l[0] * t1 + link->J_l[1] * t2 + link->J_l[2] * t3);
    const six_link_real delta_alpha_y = qddot[0] + (link->J_l[3] * t1 + link->J_l[4] * t2 + link->J_l[5] * t3);
    const six_link_real delta_alpha_z_2 = delta_alpha_z + (link->J_l[6] * t1 + link->J_l[7] * t2 + link->J_l[8] * t3);
    const six_link_real delta_a_y_2 = delta_a_y + (delta_alpha_z * c->length - delta_alpha_x * link->r_T[1])
        + (etaddot[0] * SIX_LINK_REAL(2.0195202782688155) + etaddot[1] * SIX_LINK_REAL(2.8145226674626453));
    const six_link_real delta_a_z_2 = delta_a_z + (delta_alpha_x * link->r_T[0] - qddot[0] * c->length)
        + (etaddot[2] * SIX_LINK_REAL(2.0195202782688155) + etaddot[3] * SIX_LINK_REAL(2.8145226674626453));

    /* outputs */
    link->delta[0] = delta_alpha_x;
    link->delta[1] = qddot[0];
    link->delta[2] = delta_alpha_z;
    link->delta[3] = delta_a_x;
    link->delta[4] = delta_a_y;
    link->delta[5] = delta_a_z;
    tip->delta[0] = delta_alpha_x_2;
    tip->delta[1] = delta_alpha_y;
    tip->delta[2] = delta_alpha_z_2;
    tip->delta[3] = delta_a_x_2;
    tip->delta[4] = delta_a_y_2;
    tip->delta[5] = delta_a_z_2;
    return SIX_LINK_OK;
}

/* inverse outward, links like forearm: 81 operations */
SIX_LINK_PART six_link_status inverse_outward_forearm(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real qddot[1], const six_link_real etaddot[4])
{
    const six_link_real delta_alpha_x = link->R_P[0] * base->delta[0] + link->R_P[3] * base->delta[1]
        + link->R_P[6] * base->delta[2];
    const six_link_real t1 = link->R_P[1] * base->delta[0] + link->R_P[4] * base->delta[1]
        + link->R_P[7] * base->delta[2];
    const six_link_real delta_alpha_z = link->R_P[2] * base->delta[0] + link->R_P[5] * base->delta[1]
        + link->R_P[8] * base->delta[2];
    const six_link_real delta_a_x = link->R_P[0] * base->delta[3] + link->R_P[3] * base->delta[4]
        + link->R_P[6] * base->delta[5] + (t1 * link->lever[2] - delta_alpha_z * link->lever[1]);
    const six_link_real delta_a_y = link->R_P[1] * base->delta[3] + link->R_P[4] * base->delta[4]
        + link->R_P[7] * base->delta[5] + (delta_alpha_z * link->lever[0] - delta_alpha_x * link->lever[2]);
    const six_link_real delta_a_z = link->R_P[2] * base->delta[3] + link->R_P[5] * base->delta[4]
        + link->R_P[8] * base->delta[5] + (delta_alpha_x * link->lever[1] - t1 * link->lever[0]);
    const six_link_real delta_alpha_y = t1 + qddot[0];
    const six_link_real t2 = c->Psi_c_y3 * etaddot[2] + c->Psi_c_y4 * etaddot[3];
    const six_link_real t3 = c->Psi_c_z1 * etaddot[0] + c->Psi_c_z2 * etaddot[1];
    const six_link_real delta_a_x_2 = delta_a_x + (delta_alpha_y * link->r_T[1] - delta_alpha_z * link->r_T[0]);
    const six_link_real delta_alpha_x_2 = delta_alpha_x + (link->J_l[2] * t3 - link->J_l[1] * t2);
    const six_link_real delta_alpha_y_2 = delta_alpha_y + (link->J_l[3] * t2 + link->J_l[4] * t3);
    const six_link_real delta_alpha_z_2 = delta_alpha_z + (link->J_l[4] * t2 + link->J_l[5] * t3);
    const six_link_real delta_a_y_2 = delta_a_y + (delta_alpha_z * c->length - delta_alpha_x * link->r_T[1])
        + (etaddot[0] * SIX_LINK_REAL(2.0195202782688155) + etaddot[1] * SIX_LINK_REAL(2.8145226674626453));
    const six_link_real delta_a_z_2 = delta_a_z + (delta_alpha_x * link->r_T[0] - delta_alpha_y * c->length)
        + (etaddot[2] * SIX_LINK_REAL(2.0195202782688155) + etaddot[3] * SIX_LINK_REAL(2.8145226674626453));

    /* outputs */
    link->delta[0] = delta_alpha_x;
    link->delta[1] = delta_alpha_y;
    link->delta[2] = delta_alpha_z;
    link->delta[3] = delta_a_x;
    link->delta[4] = delta_a_y;
    link->delta[5] = delta_a_z;
    tip->delta[0] = delta_alpha_x_2;
    tip->delta[1] = delta_alpha_y_2;
    tip->delta[2] = delta_alpha_z_2;
    tip->delta[3] = delta_a_x_2;
    tip->delta[4] = delta_a_y_2;
    tip->delta[5] = delta_a_z_2;
    return SIX_LINK_OK;
}

/* inverse outward, links like wrist_roll: 35 operations */
SIX_LINK_PART six_link_status inverse_outward_wrist_roll(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real qddot[1])
{
    const six_link_real delta_alpha_y = link->R_P[1] * base->delta[0] + link->R_P[4] * base->delta[1]
        + link->R_P[7] * base->delta[2];
    const six_link_real delta_alpha_z = link->R_P[2] * base->delta[0] + link->R_P[5] * base->delta[1]
        + link->R_P[8] * base->delta[2];
    const six_link_real delta_a_x = link->R_P[0] * base->delta[3] + link->R_P[3] * base->delta[4]
        + link->R_P[6] * base->delta[5];
    const six_link_real delta_a_y = link->R_P[1] * base->delta[3] + link->R_P[4] * base->delta[4]
        + link->R_P[7] * base->delta[5];
    const six_link_real delta_a_z = link->R_P[2] * base->delta[3] + link->R_P[5] * base->delta[4]
        + link->R_P[8] * base->delta[5];
    const six_link_real delta_alpha_x = link->R_P[0] * base->delta[0] + link->R_P[3] * base->delta[1]
        + link->R_P[6] * base->delta[2] + qddot[0];
    const six_link_real delta_a_y_2 = delta_a_y + delta_alpha_z * c->length;
    const six_link_real delta_a_z_2 = delta_a_z - delta_alpha_y * c->length;

    /* outputs */
    link->delta[0] = delta_alpha_x;
    link->delta[1] = delta_alpha_y;
    link->delta[2] = delta_alpha_z;
    link->delta[3] = delta_a_x;
    link->delta[4] = delta_a_y;
    link->delta[5] = delta_a_z;
    tip->delta[0] = delta_alpha_x;
    tip->delta[1] = delta_alpha_y;
    tip->delta[2] = delta_alpha_z;
    tip->delta[3] = delta_a_x;
    tip->delta[4] = delta_a_y_2;
    tip->delta[5] = delta_a_z_2;
    return SIX_LINK_OK;
}

/* inverse outward, links like wrist_pitch: 17 operations */
SIX_LINK_PART six_link_status inverse_outward_wrist_pitch(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real qddot[1])
{
    const six_link_real delta_alpha_x = link->R_P[0] * base->delta[0] + link->R_P[6] * base->delta[2];
    const six_link_real delta_alpha_z = link->R_P[2] * base->delta[0] + link->R_P[8] * base->delta[2];
    const six_link_real delta_a_x = link->R_P[0] * base->delta[3] + link->R_P[6] * base->delta[5];
    const six_link_real delta_a_z = link->R_P[2] * base->delta[3] + link->R_P[8] * base->delta[5];
    const six_link_real delta_alpha_y = base->delta[1] + qddot[0];
    const six_link_real delta_a_y = base->delta[4] + delta_alpha_z * c->length;
    const six_link_real delta_a_z_2 = delta_a_z - delta_alpha_y * c->length;

    /* outputs */
    link->delta[0] = delta_alpha_x;
    link->delta[1] = delta_alpha_y;
    link->delta[2] = delta_alpha_z;
    link->delta[3] = delta_a_x;
    link->delta[4] = base->delta[4];
    link->delta[5] = delta_a_z;
    tip->delta[0] = delta_alpha_x;
    tip->delta[1] = delta_alpha_y;
    tip->delta[2] = delta_alpha_z;
    tip->delta[3] = delta_a_x;
    tip->delta[4] = delta_a_y;
    tip->delta[5] = delta_a_z_2;
    return SIX_LINK_OK;
}

/* inverse outward, links like flange: 17 operations */
SIX_LINK_PART six_link_status inverse_outward_flange(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real qddot[1])
{
    const six_link_real delta_alpha_y = link->R_P[4] * base->delta[1] + link->R_P[7] * base->delta[2];
    const six_link_real delta_alpha_z = link->R_P[5] * base->delta[1] + link->R_P[8] * base->delta[2];
    const six_link_real delta_a_y = link->R_P[4] * base->delta[4] + link->R_P[7] * base->delta[5];
    const six_link_real delta_a_z = link->R_P[5] * base->delta[4] + link->R_P[8] * base->delta[5];
    const six_link_real delta_alpha_x = base->delta[0] + qddot[0];
    const six_link_real delta_a_y_2 = delta_a_y + delta_alpha_z * c->length;
    const six_link_real delta_a_z_2 = delta_a_z - delta_alpha_y * c->length;

    /* outputs */
    link->delta[0] = delta_alpha_x;
    link->delta[1] = delta_alpha_y;
    link->delta[2] = delta_alpha_z;
    link->delta[3] = base->delta[3];
    link->delta[4] = delta_a_y;
    link->delta[5] = delta_a_z;
    tip->delta[0] = delta_alpha_x;
    tip->delta[1] = delta_alpha_y;
    tip->delta[2] = delta_alpha_z;
    tip->delta[3] = base->delta[3];
    tip->delta[4] = delta_a_y_2;
    tip->delta[5] = delta_a_z_2;
    return SIX_LINK_OK;
}

/* inverse inward, links like shoulder: 71 operations */
SIX_LINK_PART six_link_status inverse_inward_shoulder(const six_link_link_constants *c, const six_link_link_store *link,
    const six_link_node *tip, const six_link_real qddot[1], const six_link_real w_ext[6], const six_link_real m_q[1],
    const six_link_real f_q[1], six_link_real force[1], six_link_real wrench[6])
{
    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_tau_z = c->S_0_x * link->acc_0[4];

    const six_link_real t1 = tip->acc_0[4] + tip->delta[4];
    const six_link_real t2 = c->body0_mass * t1
        + (tip->delta[2] * c->S_T_x - tip->omega[2] * (tip->omega[2] * c->S_T_y)) - w_ext[4];
    const six_link_real t3 = t2 + tip->p[4];
    const six_link_real t4 = c->S_T_x * t1 - c->S_T_y * tip->acc_0[3] + c->I_T_zz * tip->delta[2] - w_ext[2]
        + tip->p[2] + c->length * t3;
    const six_link_real wrench_tau_z = c->J_0_xx * link->delta[2] + H_star_tau_z + t4;
    const six_link_real force_1 = wrench_tau_z + m_q[0] * qddot[0] + f_q[0];

    /* outputs */
    force[0] = force_1;

    if (wrench) {
        /* Omega: acceleration of a place by the link's turning */
        const six_link_real minus_Omega_xx = link->omega[2] * link->omega[2];

        /* H_star: gyroscopic wrench and weight, angular acceleration included */
        const six_link_real minus_H_star_tau_y = c->S_0_x * link->acc_0[5];
        const six_link_real H_star_f_x = link->acc_0[3] * c->mu - minus_Omega_xx * c->S_0_x;
        const six_link_real H_star_f_y = link->acc_0[4] * c->mu;
        const six_link_real H_star_f_z = link->acc_0[5] * c->mu;

        const six_link_real t5 = c->S_T_y * tip->acc_0[5] - c->S_T_z * t1 - c->J_T_xz * tip->delta[2]
            + tip->omega[2] * (c->J_T_yz * tip->omega[2]);
        const six_link_real t6 = c->S_T_z * tip->acc_0[3] - c->S_T_x * tip->acc_0[5] - c->J_T_yz * tip->delta[2]
            - tip->omega[2] * (c->J_T_xz * tip->omega[2]);
        const six_link_real t7 = c->body0_mass * tip->acc_0[3]
            - (tip->delta[2] * c->S_T_y + tip->omega[2] * (tip->omega[2] * c->S_T_x));
        const six_link_real wrench_tau_x = t5 - w_ext[0] + tip->p[0];
        const six_link_real t8 = c->body0_mass * tip->acc_0[5] - w_ext[5] + tip->p[5];
        const six_link_real wrench_tau_y = t6 - w_ext[1] + tip->p[1] - c->length * t8 - minus_H_star_tau_y;
        const six_link_real wrench_f_x = H_star_f_x + (t7 - w_ext[3] + tip->p[3]);
        const six_link_real wrench_f_y = c->S_0_x * link->delta[2] + H_star_f_y + t3;
        const six_link_real wrench_f_z = H_star_f_z + t8;

        /* outputs */
        wrench[0] = wrench_tau_x;
        wrench[1] = wrench_tau_y;
        wrench[2] = wrench_tau_z;
        wrench[3] = wrench_f_x;
        wrench[4] = wrench_f_y;
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* inverse inward, links like upper_arm: 638 operations */
SIX_LINK_PART six_link_status inverse_inward_upper_arm(const six_link_link_constants *c,
    const six_link_link_store *link, six_link_node *base, const six_link_node *tip, const six_link_real qddot[1],
    const six_link_real etaddot[5], const six_link_real eta[5], const six_link_real etadot[5],
    const six_link_real w_ext[6], const six_link_real m_eta[5], const six_link_real f_eta[5],
    const six_link_real m_q[1], const six_link_real f_q[1], six_link_real force_eta[5], six_link_real force[1],
    six_link_real wrench[6])
{
    /* S: first moment */
    const six_link_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2;
    const six_link_real S_z = eta[2] * c->sigma_y1 + eta[3] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const six_link_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2;
    const six_link_real Sdot_z = etadot[2] * c->sigma_y1 + etadot[3] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->mu * eta[0];
    const six_link_real L_y2 = c->mu * eta[1];
    const six_link_real L_z1 = eta[2] * c->mu;
    const six_link_real L_z2 = eta[3] * c->mu;

    /* Ldot: rate of L */
    const six_link_real Ldot_y1 = c->mu * etadot[0];
    const six_link_real Ldot_y2 = c->mu * etadot[1];
    const six_link_real Ldot_z1 = etadot[2] * c->mu;
    const six_link_real Ldot_z2 = etadot[3] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1];
    const six_link_real J_xz = c->chi_1 * eta[2] + c->chi_2 * eta[3];
    const six_link_real J_yy = L_y1 * eta[0] + L_y2 * eta[1];
    const six_link_real J_yz = L_z1 * eta[0] + L_z2 * eta[1];
    const six_link_real J_zz = L_z1 * eta[2] + L_z2 * eta[3];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const six_link_real t1 = link->omega[1] * link->omega[1];
    const six_link_real t2 = link->omega[2] * link->omega[2];
    const six_link_real minus_Omega_xx = t1 + t2;
    const six_link_real t3 = link->omega[0] * link->omega[1];
    const six_link_real Omega_xy = t3 - link->acc_0[2];
    const six_link_real Omega_xz = link->omega[0] * link->omega[2];
    const six_link_real Omega_yx = link->acc_0[2] + t3;
    const six_link_real t4 = link->omega[0] * link->omega[0];
    const six_link_real minus_Omega_yy = t4 + t2;
    const six_link_real t5 = link->omega[1] * link->omega[2];
    const six_link_real Omega_yz = t5 - link->acc_0[0];
    const six_link_real Omega_zy = link->acc_0[0] + t5;
    const six_link_real minus_Omega_zz = t4 + t1;

    /* B: moment of the elastic velocity */
    const six_link_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1];
    const six_link_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1];
    const six_link_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1];
    const six_link_real B_zx = c->chi_1 * etadot[2] + c->chi_2 * etadot[3];
    const six_link_real B_zy = L_y1 * etadot[2] + L_y2 * etadot[3];
    const six_link_real B_zz = L_z1 * etadot[2] + L_z2 * etadot[3];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const six_link_real h_c_tau_x = B_yy * link->omega[0] + B_zz * link->omega[0];
    const six_link_real h_c_tau_y = B_zz * link->omega[1] - B_yx * link->omega[0] - B_yz * link->omega[2];
    const six_link_real h_c_tau_z = B_yy * link->omega[2] - B_zx * link->omega[0] - B_zy * link->omega[1];
    const six_link_real h_c_f_x = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
    const six_link_real minus_h_c_f_y = Sdot_z * link->omega[0];
    const six_link_real h_c_f_z = Sdot_y * link->omega[0];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const six_link_real h_MD_tau_y = h_c_tau_y + etadot[4] * link->omega[2] * c->sigma_t_5;
    const six_link_real h_MD_tau_z = h_c_tau_z - etadot[4] * link->omega[1] * c->sigma_t_5;

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real t6 = h_c_tau_x + c->I_s * link->acc_0[0] + J_xy * Omega_xz + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const six_link_real H_star_tau_x = t6 + S_y * link->acc_0[5] - J_xz * Omega_yx - J_zz * Omega_yz
        - S_z * link->acc_0[4];
    const six_link_real t7 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->acc_0[3];
    const six_link_real t8 = c->I_s * link->omega[0];
    const six_link_real H_star_tau_y = t7 + t8 * link->omega[2] - c->J_0_xx * Omega_xz - J_xy * Omega_zy
        - c->S_0_x * link->acc_0[5];
    const six_link_real t9 = h_c_tau_z + c->J_0_xx * Omega_yx + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * link->acc_0[4];
    const six_link_real H_star_tau_z = t9 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->acc_0[3]
        - t8 * link->omega[1];
    const six_link_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + link->acc_0[3] * c->mu;
    const six_link_real H_star_f_y = Omega_yx * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + link->acc_0[4] * c->mu;
    const six_link_real H_star_f_z = h_c_f_z + Omega_xz * c->S_0_x + Omega_zy * S_y - minus_Omega_zz * S_z
        + link->acc_0[5] * c->mu;

    /* h_V: bias of the twist rows, angular acceleration included */
    const six_link_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const six_link_real h_V_tau_y = H_star_tau_y + h_MD_tau_y;
    const six_link_real h_V_tau_z = H_star_tau_z + h_MD_tau_z;
    const six_link_real h_V_f_x = H_star_f_x + h_c_f_x;
    const six_link_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const six_link_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const six_link_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_yx * c->chi_1
        + link->acc_0[4] * c->sigma_y1 - Ldot_z1 * 2 * link->omega[0];
    const six_link_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_yx * c->chi_2
        + link->acc_0[4] * c->sigma_y2 - Ldot_z2 * 2 * link->omega[0];
    const six_link_real h_eta_3 = L_y1 * Omega_zy - L_z1 * minus_Omega_zz + Omega_xz * c->chi_1
        + link->acc_0[5] * c->sigma_y1 + Ldot_y1 * 2 * link->omega[0];
    const six_link_real h_eta_4 = L_y2 * Omega_zy - L_z2 * minus_Omega_zz + Omega_xz * c->chi_2
        + link->acc_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];
    const six_link_real h_eta_5 = link->acc_0[0] * c->sigma_t_5;

    const six_link_real t10 = link->R_T[0] * c->S_T_x + link->R_T[1] * c->S_T_y + link->R_T[2] * c->S_T_z;
    const six_link_real t11 = link->R_T[3] * c->S_T_x + link->R_T[4] * c->S_T_y + link->R_T[5] * c->S_T_z;
    const six_link_real t12 = link->R_T[6] * c->S_T_x + link->R_T[7] * c->S_T_y + link->R_T[8] * c->S_T_z;
    const six_link_real t13 = c->I_T_xx * link->R_T[3] - c->J_T_xy * link->R_T[4] - c->J_T_xz * link->R_T[5];
    const six_link_real t14 = c->I_T_xx * link->R_T[6] - c->J_T_xy * link->R_T[7] - c->J_T_xz * link->R_T[8];
    const six_link_real t15 = c->I_T_yy * link->R_T[4] - c->J_T_xy * link->R_T[3] - c->J_T_yz * link->R_T[5];
    const six_link_real t16 = c->I_T_yy * link->R_T[7] - c->J_T_xy * link->R_T[6] - c->J_T_yz * link->R_T[8];
    const six_link_real t17 = c->I_T_zz * link->R_T[5] - (c->J_T_xz * link->R_T[3] + c->J_T_yz * link->R_T[4]);
    const six_link_real t18 = c->I_T_zz * link->R_T[8] - (c->J_T_xz * link->R_T[6] + c->J_T_yz * link->R_T[7]);
    const six_link_real t19 = link->R_T[0]
        * (c->I_T_xx * link->R_T[0] - c->J_T_xy * link->R_T[1] - c->J_T_xz * link->R_T[2])
        + link->R_T[1] * (c->I_T_yy * link->R_T[1] - c->J_T_xy * link->R_T[0] - c->J_T_yz * link->R_T[2]);
    const six_link_real t20 = link->R_T[2]
        * (c->I_T_zz * link->R_T[2] - (c->J_T_xz * link->R_T[0] + c->J_T_yz * link->R_T[1]));
    const six_link_real t21 = t19 + t20;
    const six_link_real t22 = link->R_T[0] * t13 + link->R_T[1] * t15 + link->R_T[2] * t17;
    const six_link_real t23 = link->R_T[0] * t14 + link->R_T[1] * t16 + link->R_T[2] * t18;
    const six_link_real t24 = link->R_T[3] * t13 + link->R_T[4] * t15 + link->R_T[5] * t17;
    const six_link_real t25 = link->R_T[3] * t14 + link->R_T[4] * t16 + link->R_T[5] * t18;
    const six_link_real t26 = link->R_T[6] * t14 + link->R_T[7] * t16 + link->R_T[8] * t18;
    const six_link_real t27 = tip->acc_0[0] + tip->delta[0];
    const six_link_real t28 = tip->acc_0[1] + tip->delta[1];
    const six_link_real t29 = tip->acc_0[2] + tip->delta[2];
    const six_link_real t30 = tip->acc_0[3] + tip->delta[3];
    const six_link_real t31 = tip->acc_0[4] + tip->delta[4];
    const six_link_real t32 = tip->acc_0[5] + tip->delta[5];
    const six_link_real t33 = t21 * tip->omega[0] + t22 * tip->omega[1] + t23 * tip->omega[2];
    const six_link_real t34 = t22 * tip->omega[0] + t24 * tip->omega[1] + t25 * tip->omega[2];
    const six_link_real t35 = t23 * tip->omega[0] + t25 * tip->omega[1] + t26 * tip->omega[2];
    const six_link_real t36 = t11 * t32 - t12 * t31 + (t21 * t27 + t22 * t28 + t23 * t29)
        + (tip->omega[1] * t35 - tip->omega[2] * t34);
    const six_link_real t37 = t12 * t30 - t10 * t32 + (t22 * t27 + t24 * t28 + t25 * t29)
        + (tip->omega[2] * t33 - tip->omega[0] * t35);
    const six_link_real t38 = t10 * t31 - t11 * t30 + (t23 * t27 + t25 * t28 + t26 * t29)
        + (tip->omega[0] * t34 - tip->omega[1] * t33);
    const six_link_real t39 = tip->omega[1] * t12 - tip->omega[2] * t11;
    const six_link_real t40 = tip->omega[2] * t10 - tip->omega[0] * t12;
    const six_link_real t41 = tip->omega[0] * t11 - tip->omega[1] * t10;
    const six_link_real t42 = c->body0_mass * t30
        + (t28 * t12 - t29 * t11 + (tip->omega[1] * t41 - tip->omega[2] * t40))
        - (link->R_T[0] * w_ext[3] + link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const six_link_real t43 = c->body0_mass * t31
        + (t29 * t10 - t27 * t12 + (tip->omega[2] * t39 - tip->omega[0] * t41))
        - (link->R_T[3] * w_ext[3] + link->R_T[4] * w_ext[4] + link->R_T[5] * w_ext[5]);
    const six_link_real t44 = c->body0_mass * t32
        + (t27 * t11 - t28 * t10 + (tip->omega[0] * t40 - tip->omega[1] * t39))
        - (link->R_T[6] * w_ext[3] + link->R_T[7] * w_ext[4] + link->R_T[8] * w_ext[5]);
    const six_link_real t45 = t36 - (link->R_T[0] * w_ext[0] + link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2])
        + tip->p[0];
    const six_link_real t46 = t37 - (link->R_T[3] * w_ext[0] + link->R_T[4] * w_ext[1] + link->R_T[5] * w_ext[2])
        + tip->p[1];
    const six_link_real t47 = t38 - (link->R_T[6] * w_ext[0] + link->R_T[7] * w_ext[1] + link->R_T[8] * w_ext[2])
        + tip->p[2];
    const six_link_real t48 = t42 + tip->p[3];
    const six_link_real t49 = t43 + tip->p[4];
    const six_link_real t50 = t44 + tip->p[5];
    const six_link_real t51 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2]
        - S_z * link->delta[4] + S_y * link->delta[5];
    const six_link_real t52 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2]
        + S_z * link->delta[3] - c->S_0_x * link->delta[5];
    const six_link_real t53 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        - S_y * link->delta[3] + c->S_0_x * link->delta[4];
    const six_link_real t54 = L_y1 * etaddot[2] - (L_z1 * etaddot[0] + L_z2 * etaddot[1]) + L_y2 * etaddot[3]
        + c->sigma_t_5 * etaddot[4];
    const six_link_real t55 = c->S_0_x * link->delta[2] - S_z * link->delta[0] + c->mu * link->delta[4]
        + (c->sigma_y1 * etaddot[0] + c->sigma_y2 * etaddot[1]);
    const six_link_real t56 = S_y * link->delta[0] - c->S_0_x * link->delta[1] + c->mu * link->delta[5]
        + (c->sigma_y1 * etaddot[2] + c->sigma_y2 * etaddot[3]);
    const six_link_real motion_4 = S_z * link->delta[1] - S_y * link->delta[2] + c->mu * link->delta[3] + h_V_f_x;
    const six_link_real wrench_tau_x = t51 + t54 + h_V_tau_x + (t45 + (link->r_T[0] * t50 - link->r_T[1] * t49));
    const six_link_real wrench_tau_y = t52 - (c->chi_1 * etaddot[2] + c->chi_2 * etaddot[3]) + h_V_tau_y
        + (t46 + (link->r_T[1] * t48 - c->length * t50));
    const six_link_real wrench_tau_z = t53 + (c->chi_1 * etaddot[0] + c->chi_2 * etaddot[1]) + h_V_tau_z
        + (t47 + (c->length * t49 - link->r_T[0] * t48));
    const six_link_real wrench_f_x = motion_4 + t48;
    const six_link_real wrench_f_y = t55 + h_V_f_y + t49;
    const six_link_real wrench_f_z = t56 + h_V_f_z + t50;
    const six_link_real t57 = c->chi_1 * link->delta[2] - L_z1 * link->delta[0] + c->sigma_y1 * link->delta[4]
        + m_eta[0] * etaddot[0];
    const six_link_real t58 = c->chi_2 * link->delta[2] - L_z2 * link->delta[0] + c->sigma_y2 * link->delta[4]
        + m_eta[1] * etaddot[1];
    const six_link_real t59 = L_y1 * link->delta[0] - c->chi_1 * link->delta[1] + c->sigma_y1 * link->delta[5]
        + m_eta[2] * etaddot[2];
    const six_link_real t60 = L_y2 * link->delta[0] - c->chi_2 * link->delta[1] + c->sigma_y2 * link->delta[5]
        + m_eta[3] * etaddot[3];
    const six_link_real t61 = link->J_l[1] * t45 + link->J_l[4] * t46 + link->J_l[7] * t47;
    const six_link_real t62 = link->J_l[2] * t45 + link->J_l[5] * t46 + link->J_l[8] * t47;
    const six_link_real force_eta_5 = c->sigma_t_5 * link->delta[0] + m_eta[4] * etaddot[4] + h_eta_5 + f_eta[4]
        + (link->J_l[0] * t45 + link->J_l[3] * t46 + link->J_l[6] * t47) * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real force_eta_1 = t57 + h_eta_1 + f_eta[0] + c->Psi_c_z1 * t62
        + t49 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real force_eta_2 = t58 + h_eta_2 + f_eta[1] + c->Psi_c_z2 * t62
        + t49 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real force_eta_3 = t59 + h_eta_3 + f_eta[2] + c->Psi_c_y3 * t61
        + t50 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real force_eta_4 = t60 + h_eta_4 + f_eta[3] + c->Psi_c_y4 * t61
        + t50 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real force_1 = wrench_tau_y + m_q[0] * qddot[0] + f_q[0];
    const six_link_real t63 = wrench_tau_x + (c->mount_xyz_y * wrench_f_z - link->lever[1] * wrench_f_y);
    const six_link_real p_tau_y = wrench_tau_y + (link->lever[1] * wrench_f_x - link->lever[0] * wrench_f_z);
    const six_link_real t64 = wrench_tau_z + (link->lever[0] * wrench_f_y - c->mount_xyz_y * wrench_f_x);
    const six_link_real p_tau_x = link->R_P[0] * t63 + link->R_P[2] * t64;
    const six_link_real p_tau_z = link->R_P[6] * t63 + link->R_P[8] * t64;
    const six_link_real p_f_x = link->R_P[0] * wrench_f_x + link->R_P[2] * wrench_f_z;
    const six_link_real p_f_z = link->R_P[6] * wrench_f_x + link->R_P[8] * wrench_f_z;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force_eta[3] = force_eta_4;
    force_eta[4] = force_eta_5;
    force[0] = force_1;
    base->p[0] = p_tau_x;
    base->p[1] = p_tau_y;
    base->p[2] = p_tau_z;
    base->p[3] = p_f_x;
    base->p[4] = wrench_f_y;
    base->p[5] = p_f_z;

    if (wrench) {
        /* outputs */
        wrench[0] = wrench_tau_x;
        wrench[1] = wrench_tau_y;
        wrench[2] = wrench_tau_z;
        wrench[3] = wrench_f_x;
        wrench[4] = wrench_f_y;
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* inverse inward, links like forearm: 452 operations */
SIX_LINK_PART six_link_status inverse_inward_forearm(const six_link_link_constants *c, const six_link_link_store *link,
    six_link_node *base, const six_link_node *tip, const six_link_real qddot[1], const six_link_real etaddot[4],
    const six_link_real eta[4], const six_link_real etadot[4], const six_link_real w_ext[6],
    const six_link_real m_eta[4], const six_link_real f_eta[4], const six_link_real m_q[1], const six_link_real f_q[1],
    six_link_real force_eta[4], six_link_real force[1], six_link_real wrench[6])
{
    /* S: first moment */
    const six_link_real S_y = c->S_B_y + eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2;
    const six_link_real S_z = c->S_B_z + eta[2] * c->sigma_y1 + eta[3] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const six_link_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2;
    const six_link_real Sdot_z = etadot[2] * c->sigma_y1 + etadot[3] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->mu * eta[0];
    const six_link_real L_y2 = c->mu * eta[1];
    const six_link_real L_z1 = eta[2] * c->mu;
    const six_link_real L_z2 = eta[3] * c->mu;

    /* Ldot: rate of L */
    const six_link_real Ldot_y1 = c->mu * etadot[0];
    const six_link_real Ldot_y2 = c->mu * etadot[1];
    const six_link_real Ldot_z1 = etadot[2] * c->mu;
    const six_link_real Ldot_z2 = etadot[3] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->J_B_xy + c->chi_1 * eta[0] + c->chi_2 * eta[1];
    const six_link_real J_xz = c->J_B_xz + c->chi_1 * eta[2] + c->chi_2 * eta[3];
    const six_link_real J_yy = c->J_B_yy + L_y1 * eta[0] + L_y2 * eta[1];
    const six_link_real J_yz = c->J_B_yz + L_z1 * eta[0] + L_z2 * eta[1];
    const six_link_real J_zz = c->J_B_zz + L_z1 * eta[2] + L_z2 * eta[3];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    /* Omega: acceleration of a place by the link's turning */
    const six_link_real t1 = link->omega[1] * link->omega[1];
    const six_link_real t2 = link->omega[2] * link->omega[2];
    const six_link_real minus_Omega_xx = t1 + t2;
    const six_link_real t3 = link->omega[0] * link->omega[1];
    const six_link_real Omega_xy = t3 - link->acc_0[2];
    const six_link_real t4 = link->omega[0] * link->omega[2];
    const six_link_real Omega_xz = link->acc_0[1] + t4;
    const six_link_real Omega_yx = link->acc_0[2] + t3;
    const six_link_real t5 = link->omega[0] * link->omega[0];
    const six_link_real minus_Omega_yy = t5 + t2;
    const six_link_real t6 = link->omega[1] * link->omega[2];
    const six_link_real Omega_yz = t6 - link->acc_0[0];
    const six_link_real Omega_zx = t4 - link->acc_0[1];
    const six_link_real Omega_zy = link->acc_0[0] + t6;
    const six_link_real minus_Omega_zz = t5 + t1;

    /* B: moment of the elastic velocity */
    const six_link_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1];
    const six_link_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1];
    const six_link_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1];
    const six_link_real B_zx = c->chi_1 * etadot[2] + c->chi_2 * etadot[3];
    const six_link_real B_zy = L_y1 * etadot[2] + L_y2 * etadot[3];
    const six_link_real B_zz = L_z1 * etadot[2] + L_z2 * etadot[3];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const six_link_real h_c_tau_x = B_yy * link->omega[0] + B_zz * link->omega[0];
    const six_link_real h_c_tau_y = B_zz * link->omega[1] - B_yx * link->omega[0] - B_yz * link->omega[2];
    const six_link_real h_c_tau_z = B_yy * link->omega[2] - B_zx * link->omega[0] - B_zy * link->omega[1];
    const six_link_real h_c_f_x = Sdot_z * link->omega[1] - Sdot_y * link->omega[2];
    const six_link_real minus_h_c_f_y = Sdot_z * link->omega[0];
    const six_link_real h_c_f_z = Sdot_y * link->omega[0];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real t7 = h_c_tau_x + c->I_s * link->acc_0[0] + J_xy * Omega_zx + J_yy * Omega_zy
        + J_yz * (minus_Omega_yy - minus_Omega_zz);
    const six_link_real H_star_tau_x = t7 + S_y * link->acc_0[5] - J_xz * Omega_yx - J_zz * Omega_yz
        - S_z * link->acc_0[4];
    const six_link_real t8 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * link->acc_0[3];
    const six_link_real t9 = c->I_s * link->omega[0];
    const six_link_real H_star_tau_y = t8 + t9 * link->omega[2] - c->J_0_xx * Omega_zx - J_xy * Omega_zy
        - c->S_0_x * link->acc_0[5];
    const six_link_real t10 = h_c_tau_z + c->J_0_xx * Omega_yx + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * link->acc_0[4];
    const six_link_real H_star_tau_z = t10 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * link->acc_0[3]
        - t9 * link->omega[1];
    const six_link_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + link->acc_0[3] * c->m;
    const six_link_real H_star_f_y = Omega_yx * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + link->acc_0[4] * c->m;
    const six_link_real H_star_f_z = h_c_f_z + Omega_zx * c->S_0_x + Omega_zy * S_y - minus_Omega_zz * S_z
        + link->acc_0[5] * c->m;

    /* h_V: bias of the twist rows, angular acceleration included */
    const six_link_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const six_link_real h_V_tau_y = H_star_tau_y + h_c_tau_y;
    const six_link_real h_V_tau_z = H_star_tau_z + h_c_tau_z;
    const six_link_real h_V_f_x = H_star_f_x + h_c_f_x;
    const six_link_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const six_link_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const six_link_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_yx * c->chi_1
        + link->acc_0[4] * c->sigma_y1 - Ldot_z1 * 2 * link->omega[0];
    const six_link_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_yx * c->chi_2
        + link->acc_0[4] * c->sigma_y2 - Ldot_z2 * 2 * link->omega[0];
    const six_link_real h_eta_3 = L_y1 * Omega_zy - L_z1 * minus_Omega_zz + Omega_zx * c->chi_1
        + link->acc_0[5] * c->sigma_y1 + Ldot_y1 * 2 * link->omega[0];
    const six_link_real h_eta_4 = L_y2 * Omega_zy - L_z2 * minus_Omega_zz + Omega_zx * c->chi_2
        + link->acc_0[5] * c->sigma_y2 + Ldot_y2 * 2 * link->omega[0];

    const six_link_real t11 = tip->p[0] - (link->R_T[0] * w_ext[0] - link->R_T[1] * w_ext[1] + link->R_T[2] * w_ext[2]);
    const six_link_real t12 = tip->p[1] - (link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1] + link->R_T[4] * w_ext[2]);
    const six_link_real t13 = tip->p[2] - (link->R_T[4] * w_ext[1] - link->R_T[2] * w_ext[0] + link->R_T[5] * w_ext[2]);
    const six_link_real t14 = tip->p[3] - (link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5]);
    const six_link_real t15 = tip->p[4] - (link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5]);
    const six_link_real t16 = tip->p[5] - (link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5]);
    const six_link_real t17 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2]
        - S_z * link->delta[4] + S_y * link->delta[5];
    const six_link_real t18 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2]
        + S_z * link->delta[3] - c->S_0_x * link->delta[5];
    const six_link_real t19 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        - S_y * link->delta[3] + c->S_0_x * link->delta[4];
    const six_link_real t20 = c->S_0_x * link->delta[2] - S_z * link->delta[0] + c->m * link->delta[4]
        + (c->sigma_y1 * etaddot[0] + c->sigma_y2 * etaddot[1]);
    const six_link_real t21 = S_y * link->delta[0] - c->S_0_x * link->delta[1] + c->m * link->delta[5]
        + (c->sigma_y1 * etaddot[2] + c->sigma_y2 * etaddot[3]);
    const six_link_real t22 = t17 + (L_y1 * etaddot[2] - (L_z1 * etaddot[0] + L_z2 * etaddot[1]) + L_y2 * etaddot[3])
        + h_V_tau_x;
    const six_link_real motion_4 = S_z * link->delta[1] - S_y * link->delta[2] + c->m * link->delta[3] + h_V_f_x;
    const six_link_real wrench_tau_x = t22 + (t11 + (link->r_T[0] * t16 - link->r_T[1] * t15));
    const six_link_real wrench_tau_y = t18 - (c->chi_1 * etaddot[2] + c->chi_2 * etaddot[3]) + h_V_tau_y
        + (t12 + (link->r_T[1] * t14 - c->length * t16));
    const six_link_real wrench_tau_z = t19 + (c->chi_1 * etaddot[0] + c->chi_2 * etaddot[1]) + h_V_tau_z
        + (t13 + (c->length * t15 - link->r_T[0] * t14));
    const six_link_real wrench_f_x = motion_4 + t14;
    const six_link_real wrench_f_y = t20 + h_V_f_y + t15;
    const six_link_real wrench_f_z = t21 + h_V_f_z + t16;
    const six_link_real t23 = c->chi_1 * link->delta[2] - L_z1 * link->delta[0] + c->sigma_y1 * link->delta[4]
        + m_eta[0] * etaddot[0];
    const six_link_real t24 = c->chi_2 * link->delta[2] - L_z2 * link->delta[0] + c->sigma_y2 * link->delta[4]
        + m_eta[1] * etaddot[1];
    const six_link_real t25 = L_y1 * link->delta[0] - c->chi_1 * link->delta[1] + c->sigma_y1 * link->delta[5]
        + m_eta[2] * etaddot[2];
    const six_link_real t26 = L_y2 * link->delta[0] - c->chi_2 * link->delta[1] + c->sigma_y2 * link->delta[5]
        + m_eta[3] * etaddot[3];
    const six_link_real t27 = link->J_l[3] * t12 - link->J_l[1] * t11 + link->J_l[4] * t13;
    const six_link_real t28 = link->J_l[2] * t11 + link->J_l[4] * t12 + link->J_l[5] * t13;
    const six_link_real force_eta_1 = t23 + h_eta_1 + f_eta[0] + c->Psi_c_z1 * t28
        + t15 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real force_eta_2 = t24 + h_eta_2 + f_eta[1] + c->Psi_c_z2 * t28
        + t15 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real force_eta_3 = t25 + h_eta_3 + f_eta[2] + c->Psi_c_y3 * t27
        + t16 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real force_eta_4 = t26 + h_eta_4 + f_eta[3] + c->Psi_c_y4 * t27
        + t16 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real force_1 = wrench_tau_y + m_q[0] * qddot[0] + f_q[0];
    const six_link_real t29 = wrench_tau_x + (link->lever[1] * wrench_f_z - link->lever[2] * wrench_f_y);
    const six_link_real t30 = wrench_tau_y + (link->lever[2] * wrench_f_x - link->lever[0] * wrench_f_z);
    const six_link_real t31 = wrench_tau_z + (link->lever[0] * wrench_f_y - link->lever[1] * wrench_f_x);
    const six_link_real p_tau_x = link->R_P[0] * t29 + link->R_P[1] * t30 + link->R_P[2] * t31;
    const six_link_real p_tau_y = link->R_P[3] * t29 + link->R_P[4] * t30 + link->R_P[5] * t31;
    const six_link_real p_tau_z = link->R_P[6] * t29 + link->R_P[7] * t30 + link->R_P[8] * t31;
    const six_link_real p_f_x = link->R_P[0] * wrench_f_x + link->R_P[1] * wrench_f_y + link->R_P[2] * wrench_f_z;
    const six_link_real p_f_y = link->R_P[3] * wrench_f_x + link->R_P[4] * wrench_f_y + link->R_P[5] * wrench_f_z;
    const six_link_real p_f_z = link->R_P[6] * wrench_f_x + link->R_P[7] * wrench_f_y + link->R_P[8] * wrench_f_z;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force_eta[3] = force_eta_4;
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
        wrench[2] = wrench_tau_z;
        wrench[3] = wrench_f_x;
        wrench[4] = wrench_f_y;
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* inverse inward, links like wrist_roll: 97 operations */
SIX_LINK_PART six_link_status inverse_inward_wrist_roll(const six_link_link_constants *c,
    const six_link_link_store *link, six_link_node *base, const six_link_node *tip, const six_link_real qddot[1],
    const six_link_real w_ext[6], const six_link_real m_q[1], const six_link_real f_q[1], six_link_real force[1],
    six_link_real wrench[6])
{
    /* Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_xx = link->omega[1] * link->omega[1] + link->omega[2] * link->omega[2];
    const six_link_real Omega_yx = link->acc_0[2] + link->omega[0] * link->omega[1];
    const six_link_real Omega_zx = link->omega[0] * link->omega[2] - link->acc_0[1];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_tau_x = c->I_s * link->acc_0[0];
    const six_link_real t1 = c->I_s * link->omega[0];
    const six_link_real H_star_tau_y = t1 * link->omega[2] - c->J_0_xx * Omega_zx - c->S_0_x * link->acc_0[5];
    const six_link_real H_star_tau_z = c->J_0_xx * Omega_yx + c->S_0_x * link->acc_0[4] - t1 * link->omega[1];
    const six_link_real H_star_f_x = link->acc_0[3] * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = Omega_yx * c->S_0_x + link->acc_0[4] * c->mu;
    const six_link_real H_star_f_z = Omega_zx * c->S_0_x + link->acc_0[5] * c->mu;

    const six_link_real t2 = tip->p[4] - w_ext[4];
    const six_link_real t3 = tip->p[5] - w_ext[5];
    const six_link_real wrench_tau_x = c->I_s * link->delta[0] + H_star_tau_x + (tip->p[0] - w_ext[0]);
    const six_link_real wrench_tau_y = c->J_0_xx * link->delta[1] - c->S_0_x * link->delta[5] + H_star_tau_y
        + (tip->p[1] - w_ext[1] - c->length * t3);
    const six_link_real wrench_tau_z = c->J_0_xx * link->delta[2] + c->S_0_x * link->delta[4] + H_star_tau_z
        + (tip->p[2] - w_ext[2] + c->length * t2);
    const six_link_real wrench_f_x = c->mu * link->delta[3] + H_star_f_x + (tip->p[3] - w_ext[3]);
    const six_link_real wrench_f_y = c->S_0_x * link->delta[2] + c->mu * link->delta[4] + H_star_f_y + t2;
    const six_link_real wrench_f_z = c->mu * link->delta[5] - c->S_0_x * link->delta[1] + H_star_f_z + t3;
    const six_link_real force_1 = wrench_tau_x + m_q[0] * qddot[0] + f_q[0];
    const six_link_real p_tau_x = link->R_P[0] * wrench_tau_x + link->R_P[1] * wrench_tau_y
        + link->R_P[2] * wrench_tau_z;
    const six_link_real p_tau_y = link->R_P[3] * wrench_tau_x + link->R_P[4] * wrench_tau_y
        + link->R_P[5] * wrench_tau_z;
    const six_link_real p_tau_z = link->R_P[6] * wrench_tau_x + link->R_P[7] * wrench_tau_y
        + link->R_P[8] * wrench_tau_z;
    const six_link_real p_f_x = link->R_P[0] * wrench_f_x + link->R_P[1] * wrench_f_y + link->R_P[2] * wrench_f_z;
    const six_link_real p_f_y = link->R_P[3] * wrench_f_x + link->R_P[4] * wrench_f_y + link->R_P[5] * wrench_f_z;
    const six_link_real p_f_z = link->R_P[6] * wrench_f_x + link->R_P[7] * wrench_f_y + link->R_P[8] * wrench_f_z;

    /* outputs */
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
        wrench[2] = wrench_tau_z;
        wrench[3] = wrench_f_x;
        wrench[4] = wrench_f_y;
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* inverse inward, links like wrist_pitch: 79 operations */
SIX_LINK_PART six_link_status inverse_inward_wrist_pitch(const six_link_link_constants *c,
    const six_link_link_store *link, six_link_node *base, const six_link_node *tip, const six_link_real qddot[1],
    const six_link_real w_ext[6], const six_link_real m_q[1], const six_link_real f_q[1], six_link_real force[1],
    six_link_real wrench[6])
{
    /* Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_xx = link->omega[1] * link->omega[1] + link->omega[2] * link->omega[2];
    const six_link_real Omega_yx = link->acc_0[2] + link->omega[0] * link->omega[1];
    const six_link_real Omega_zx = link->omega[0] * link->omega[2] - link->acc_0[1];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_tau_x = c->I_s * link->acc_0[0];
    const six_link_real t1 = c->I_s * link->omega[0];
    const six_link_real H_star_tau_y = t1 * link->omega[2] - c->J_0_xx * Omega_zx - c->S_0_x * link->acc_0[5];
    const six_link_real H_star_tau_z = c->J_0_xx * Omega_yx + c->S_0_x * link->acc_0[4] - t1 * link->omega[1];
    const six_link_real H_star_f_x = link->acc_0[3] * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = Omega_yx * c->S_0_x + link->acc_0[4] * c->mu;
    const six_link_real H_star_f_z = Omega_zx * c->S_0_x + link->acc_0[5] * c->mu;

    const six_link_real t2 = tip->p[4] - w_ext[4];
    const six_link_real t3 = tip->p[5] - w_ext[5];
    const six_link_real wrench_tau_x = c->I_s * link->delta[0] + H_star_tau_x + (tip->p[0] - w_ext[0]);
    const six_link_real wrench_tau_y = c->J_0_xx * link->delta[1] - c->S_0_x * link->delta[5] + H_star_tau_y
        + (tip->p[1] - w_ext[1] - c->length * t3);
    const six_link_real wrench_tau_z = c->J_0_xx * link->delta[2] + c->S_0_x * link->delta[4] + H_star_tau_z
        + (tip->p[2] - w_ext[2] + c->length * t2);
    const six_link_real wrench_f_x = c->mu * link->delta[3] + H_star_f_x + (tip->p[3] - w_ext[3]);
    const six_link_real wrench_f_y = c->S_0_x * link->delta[2] + c->mu * link->delta[4] + H_star_f_y + t2;
    const six_link_real wrench_f_z = c->mu * link->delta[5] - c->S_0_x * link->delta[1] + H_star_f_z + t3;
    const six_link_real force_1 = wrench_tau_y + m_q[0] * qddot[0] + f_q[0];
    const six_link_real p_tau_x = link->R_P[0] * wrench_tau_x + link->R_P[2] * wrench_tau_z;
    const six_link_real p_tau_z = link->R_P[6] * wrench_tau_x + link->R_P[8] * wrench_tau_z;
    const six_link_real p_f_x = link->R_P[0] * wrench_f_x + link->R_P[2] * wrench_f_z;
    const six_link_real p_f_z = link->R_P[6] * wrench_f_x + link->R_P[8] * wrench_f_z;

    /* outputs */
    force[0] = force_1;
    base->p[0] = p_tau_x;
    base->p[1] = wrench_tau_y;
    base->p[2] = p_tau_z;
    base->p[3] = p_f_x;
    base->p[4] = wrench_f_y;
    base->p[5] = p_f_z;

    if (wrench) {
        /* outputs */
        wrench[0] = wrench_tau_x;
        wrench[1] = wrench_tau_y;
        wrench[2] = wrench_tau_z;
        wrench[3] = wrench_f_x;
        wrench[4] = wrench_f_y;
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* inverse inward, links like flange: 175 operations */
SIX_LINK_PART six_link_status inverse_inward_flange(const six_link_link_constants *c, const six_link_link_store *link,
    six_link_node *base, const six_link_node *tip, const six_link_real qddot[1], const six_link_real w_ext[6],
    const six_link_real m_q[1], const six_link_real f_q[1], six_link_real force[1], six_link_real wrench[6])
{
    /* Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_xx = link->omega[1] * link->omega[1] + link->omega[2] * link->omega[2];
    const six_link_real Omega_yx = link->acc_0[2] + link->omega[0] * link->omega[1];
    const six_link_real Omega_zx = link->omega[0] * link->omega[2] - link->acc_0[1];

    /* H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_tau_x = c->I_s * link->acc_0[0];
    const six_link_real t1 = c->I_s * link->omega[0];
    const six_link_real H_star_tau_y = t1 * link->omega[2] - c->J_0_xx * Omega_zx - c->S_0_x * link->acc_0[5];
    const six_link_real H_star_tau_z = c->J_0_xx * Omega_yx + c->S_0_x * link->acc_0[4] - t1 * link->omega[1];
    const six_link_real H_star_f_x = link->acc_0[3] * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = Omega_yx * c->S_0_x + link->acc_0[4] * c->mu;
    const six_link_real H_star_f_z = Omega_zx * c->S_0_x + link->acc_0[5] * c->mu;

    const six_link_real t2 = tip->acc_0[0] + tip->delta[0];
    const six_link_real t3 = tip->acc_0[1] + tip->delta[1];
    const six_link_real t4 = tip->acc_0[2] + tip->delta[2];
    const six_link_real t5 = tip->acc_0[3] + tip->delta[3];
    const six_link_real t6 = tip->acc_0[4] + tip->delta[4];
    const six_link_real t7 = tip->acc_0[5] + tip->delta[5];
    const six_link_real t8 = c->I_T_xx * tip->omega[0] - c->J_T_xy * tip->omega[1] - c->J_T_xz * tip->omega[2];
    const six_link_real t9 = c->I_T_yy * tip->omega[1] - c->J_T_xy * tip->omega[0] - c->J_T_yz * tip->omega[2];
    const six_link_real t10 = c->I_T_zz * tip->omega[2] - (c->J_T_xz * tip->omega[0] + c->J_T_yz * tip->omega[1]);
    const six_link_real t11 = c->S_T_y * t7 - c->S_T_z * t6 + (c->I_T_xx * t2 - c->J_T_xy * t3 - c->J_T_xz * t4)
        + (tip->omega[1] * t10 - tip->omega[2] * t9);
    const six_link_real t12 = c->S_T_z * t5 - c->S_T_x * t7 + (c->I_T_yy * t3 - c->J_T_xy * t2 - c->J_T_yz * t4)
        + (tip->omega[2] * t8 - tip->omega[0] * t10);
    const six_link_real t13 = c->S_T_x * t6 - c->S_T_y * t5 + (c->I_T_zz * t4 - (c->J_T_xz * t2 + c->J_T_yz * t3))
        + (tip->omega[0] * t9 - tip->omega[1] * t8);
    const six_link_real t14 = tip->omega[1] * c->S_T_z - tip->omega[2] * c->S_T_y;
    const six_link_real t15 = tip->omega[2] * c->S_T_x - tip->omega[0] * c->S_T_z;
    const six_link_real t16 = tip->omega[0] * c->S_T_y - tip->omega[1] * c->S_T_x;
    const six_link_real t17 = c->body0_mass * t5
        + (t3 * c->S_T_z - t4 * c->S_T_y + (tip->omega[1] * t16 - tip->omega[2] * t15));
    const six_link_real t18 = c->body0_mass * t6
        + (t4 * c->S_T_x - t2 * c->S_T_z + (tip->omega[2] * t14 - tip->omega[0] * t16));
    const six_link_real t19 = c->body0_mass * t7
        + (t2 * c->S_T_y - t3 * c->S_T_x + (tip->omega[0] * t15 - tip->omega[1] * t14));
    const six_link_real t20 = t18 - w_ext[4];
    const six_link_real t21 = t19 - w_ext[5];
    const six_link_real wrench_tau_x = c->I_s * link->delta[0] + H_star_tau_x + (t11 - w_ext[0]);
    const six_link_real wrench_tau_y = c->J_0_xx * link->delta[1] - c->S_0_x * link->delta[5] + H_star_tau_y
        + (t12 - w_ext[1] - c->length * t21);
    const six_link_real wrench_tau_z = c->J_0_xx * link->delta[2] + c->S_0_x * link->delta[4] + H_star_tau_z
        + (t13 - w_ext[2] + c->length * t20);
    const six_link_real wrench_f_x = c->mu * link->delta[3] + H_star_f_x + (t17 - w_ext[3]);
    const six_link_real wrench_f_y = c->S_0_x * link->delta[2] + c->mu * link->delta[4] + H_star_f_y + t20;
    const six_link_real wrench_f_z = c->mu * link->delta[5] - c->S_0_x * link->delta[1] + H_star_f_z + t21;
    const six_link_real force_1 = wrench_tau_x + m_q[0] * qddot[0] + f_q[0];
    const six_link_real p_tau_y = link->R_P[4] * wrench_tau_y + link->R_P[5] * wrench_tau_z;
    const six_link_real p_tau_z = link->R_P[7] * wrench_tau_y + link->R_P[8] * wrench_tau_z;
    const six_link_real p_f_y = link->R_P[4] * wrench_f_y + link->R_P[5] * wrench_f_z;
    const six_link_real p_f_z = link->R_P[7] * wrench_f_y + link->R_P[8] * wrench_f_z;

    /* outputs */
    force[0] = force_1;
    base->p[0] = wrench_tau_x;
    base->p[1] = p_tau_y;
    base->p[2] = p_tau_z;
    base->p[3] = wrench_f_x;
    base->p[4] = p_f_y;
    base->p[5] = p_f_z;

    if (wrench) {
        /* outputs */
        wrench[0] = wrench_tau_x;
        wrench[1] = wrench_tau_y;
        wrench[2] = wrench_tau_z;
        wrench[3] = wrench_f_x;
        wrench[4] = wrench_f_y;
        wrench[5] = wrench_f_z;
    }
    return SIX_LINK_OK;
}

/* kinematics, links like shoulder: 0 operations */
SIX_LINK_PART six_link_status kinematics_shoulder_2(void)
{

    return SIX_LINK_OK;
}

/* kinematics, links like upper_arm: 76 operations */
SIX_LINK_PART six_link_status kinematics_upper_arm_2(const six_link_link_constants *c, six_link_link_store *link,
    six_link_node *tip, const six_link_real q[1], const six_link_real eta[5])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real t1 = -R_rel_xz;

    /* r_R: joint point relative to the parent's tip point */
    const six_link_real r_R_x = R_rel_xx * c->mount_xyz_x - R_rel_xz * c->mount_xyz_z;
    const six_link_real r_R_z = R_rel_xz * c->mount_xyz_x + R_rel_xx * c->mount_xyz_z;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real t2 = theta_x * theta_x;
    const six_link_real t3 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t2 + t3;
    const six_link_real t4 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t4;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);

    /* c3: Stumpff function of order 3 */
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * six_link_c5(x);

    /* c1: Stumpff function of order 1 */
    const six_link_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t3 + t4;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t2 + t4;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    const six_link_real t5 = c3 * theta_hat2_12;
    const six_link_real t6 = c2 * theta_z;
    const six_link_real J_l_xy = t5 - t6;
    const six_link_real t7 = c2 * theta_y;
    const six_link_real t8 = c3 * theta_hat2_13;
    const six_link_real J_l_xz = t7 + t8;
    const six_link_real J_l_yx = t6 + t5;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const six_link_real t9 = c3 * theta_hat2_23;
    const six_link_real t10 = c2 * theta_x;
    const six_link_real J_l_yz = t9 - t10;
    const six_link_real J_l_zx = t8 - t7;
    const six_link_real J_l_zy = t10 + t9;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t11 = c2 * theta_hat2_12;
    const six_link_real t12 = c1 * theta_z;
    const six_link_real R_T_xy = t11 - t12;
    const six_link_real t13 = c1 * theta_y;
    const six_link_real t14 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t13 + t14;
    const six_link_real R_T_yx = t12 + t11;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t15 = c2 * theta_hat2_23;
    const six_link_real t16 = c1 * theta_x;
    const six_link_real R_T_yz = t15 - t16;
    const six_link_real R_T_zx = t14 - t13;
    const six_link_real R_T_zy = t16 + t15;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* outputs */
    link->R_P[6] = t1;
    link->R_P[8] = R_rel_xx;
    link->lever[0] = r_R_x;
    link->lever[1] = r_R_z;
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
    return SIX_LINK_OK;
}

/* kinematics, links like forearm: 122 operations */
SIX_LINK_PART six_link_status kinematics_forearm_2(const six_link_link_constants *c, six_link_link_store *link,
    const six_link_node *base, six_link_node *tip, const six_link_real q[1], const six_link_real eta[4])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real t1 = turn.sine, t2 = turn.cosine;
    const six_link_real R_rel_xx = c->R_m_xx * t2 - c->R_m_xz * t1;
    const six_link_real R_rel_xz = c->R_m_xx * t1 + c->R_m_xz * t2;
    const six_link_real R_rel_yx = c->R_m_yx * t2 - c->R_m_yz * t1;
    const six_link_real R_rel_yz = c->R_m_yx * t1 + c->R_m_yz * t2;
    const six_link_real R_rel_zx = c->R_m_zx * t2 - c->R_m_zz * t1;
    const six_link_real R_rel_zz = c->R_m_zx * t1 + c->R_m_zz * t2;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_xx = base->R_T[0] * R_rel_xx + base->R_T[1] * R_rel_yx + base->R_T[2] * R_rel_zx;
    const six_link_real R_P_xy = base->R_T[0] * c->R_m_xy + base->R_T[1] * c->R_m_yy + base->R_T[2] * c->R_m_zy;
    const six_link_real R_P_xz = base->R_T[0] * R_rel_xz + base->R_T[1] * R_rel_yz + base->R_T[2] * R_rel_zz;
    const six_link_real R_P_yx = base->R_T[3] * R_rel_xx + base->R_T[4] * R_rel_yx + base->R_T[5] * R_rel_zx;
    const six_link_real R_P_yy = base->R_T[3] * c->R_m_xy + base->R_T[4] * c->R_m_yy + base->R_T[5] * c->R_m_zy;
    const six_link_real R_P_yz = base->R_T[3] * R_rel_xz + base->R_T[4] * R_rel_yz + base->R_T[5] * R_rel_zz;
    const six_link_real R_P_zx = base->R_T[6] * R_rel_xx + base->R_T[7] * R_rel_yx + base->R_T[8] * R_rel_zx;
    const six_link_real R_P_zy = base->R_T[6] * c->R_m_xy + base->R_T[7] * c->R_m_yy + base->R_T[8] * c->R_m_zy;
    const six_link_real R_P_zz = base->R_T[6] * R_rel_xz + base->R_T[7] * R_rel_yz + base->R_T[8] * R_rel_zz;

    /* r_R: joint point relative to the parent's tip point */
    const six_link_real r_R_x = R_rel_xx * c->mount_xyz_x + R_rel_yx * c->mount_xyz_y + R_rel_zx * c->mount_xyz_z;
    const six_link_real r_R_y = c->R_m_xy * c->mount_xyz_x + c->R_m_yy * c->mount_xyz_y + c->R_m_zy * c->mount_xyz_z;
    const six_link_real r_R_z = R_rel_xz * c->mount_xyz_x + R_rel_yz * c->mount_xyz_y + R_rel_zz * c->mount_xyz_z;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);

    /* c3: Stumpff function of order 3 */
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * six_link_c5(x);

    /* c1: Stumpff function of order 1 */
    const six_link_real c1 = 1 - x * c3;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real J_l_yx = c2 * theta_z;
    const six_link_real J_l_xz = c2 * theta_y;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const six_link_real J_l_yz = c3 * theta_hat2_23;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real R_T_yx = c1 * theta_z;
    const six_link_real t3 = -R_T_yx;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real t4 = -R_T_xz;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* outputs */
    link->R_P[0] = R_P_xx;
    link->R_P[1] = R_P_xy;
    link->R_P[2] = R_P_xz;
    link->R_P[3] = R_P_yx;
    link->R_P[4] = R_P_yy;
    link->R_P[5] = R_P_yz;
    link->R_P[6] = R_P_zx;
    link->R_P[7] = R_P_zy;
    link->R_P[8] = R_P_zz;
    link->lever[0] = r_R_x;
    link->lever[1] = r_R_y;
    link->lever[2] = r_R_z;
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
    link->J_l[1] = J_l_yx;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yy;
    link->J_l[4] = J_l_yz;
    link->J_l[5] = J_l_zz;
    tip->R_T[0] = R_T_xx;
    tip->R_T[1] = t3;
    tip->R_T[2] = R_T_xz;
    tip->R_T[3] = R_T_yx;
    tip->R_T[4] = R_T_yy;
    tip->R_T[5] = R_T_yz;
    tip->R_T[6] = t4;
    tip->R_T[7] = R_T_yz;
    tip->R_T[8] = R_T_zz;
    return SIX_LINK_OK;
}

/* kinematics, links like wrist_roll: 20 operations */
SIX_LINK_PART six_link_status kinematics_wrist_roll_2(six_link_link_store *link, const six_link_node *base,
    const six_link_real q[1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_xy = base->R_T[1] * R_rel_yy + base->R_T[2] * R_rel_zy;
    const six_link_real R_P_xz = base->R_T[2] * R_rel_yy - base->R_T[1] * R_rel_zy;
    const six_link_real R_P_yy = base->R_T[4] * R_rel_yy + base->R_T[5] * R_rel_zy;
    const six_link_real R_P_yz = base->R_T[5] * R_rel_yy - base->R_T[4] * R_rel_zy;
    const six_link_real R_P_zy = base->R_T[7] * R_rel_yy + base->R_T[8] * R_rel_zy;
    const six_link_real R_P_zz = base->R_T[8] * R_rel_yy - base->R_T[7] * R_rel_zy;

    /* outputs */
    link->R_P[0] = base->R_T[0];
    link->R_P[1] = R_P_xy;
    link->R_P[2] = R_P_xz;
    link->R_P[3] = base->R_T[3];
    link->R_P[4] = R_P_yy;
    link->R_P[5] = R_P_yz;
    link->R_P[6] = base->R_T[6];
    link->R_P[7] = R_P_zy;
    link->R_P[8] = R_P_zz;
    return SIX_LINK_OK;
}

/* kinematics, links like wrist_pitch: 3 operations */
SIX_LINK_PART six_link_status kinematics_wrist_pitch_2(six_link_link_store *link, const six_link_real q[1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real t1 = -R_rel_xz;

    /* outputs */
    link->R_P[0] = R_rel_xx;
    link->R_P[2] = R_rel_xz;
    link->R_P[6] = t1;
    link->R_P[8] = R_rel_xx;
    return SIX_LINK_OK;
}

/* kinematics, links like flange: 3 operations */
SIX_LINK_PART six_link_status kinematics_flange_2(six_link_link_store *link, const six_link_real q[1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    /* R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real t1 = -R_rel_zy;

    /* outputs */
    link->R_P[4] = R_rel_yy;
    link->R_P[5] = t1;
    link->R_P[7] = R_rel_zy;
    link->R_P[8] = R_rel_yy;
    return SIX_LINK_OK;
}

/* inverse inward, links like shoulder: 14 operations */
SIX_LINK_PART six_link_status inverse_inward_shoulder_2(const six_link_link_constants *c,
    const six_link_link_store *link, const six_link_node *tip, const six_link_real qddot[1], const six_link_real m_q[1],
    six_link_real force[1])
{
    const six_link_real t1 = c->S_T_x * tip->delta[4] + c->I_T_zz * tip->delta[2] + tip->p[2]
        + c->length * (c->body0_mass * tip->delta[4] + tip->delta[2] * c->S_T_x + tip->p[4]);
    const six_link_real wrench_tau_z = c->J_0_xx * link->delta[2] + t1;
    const six_link_real force_1 = wrench_tau_z + m_q[0] * qddot[0];

    /* outputs */
    force[0] = force_1;
    return SIX_LINK_OK;
}

/* inverse inward, links like upper_arm: 330 operations */
SIX_LINK_PART six_link_status inverse_inward_upper_arm_2(const six_link_link_constants *c,
    const six_link_link_store *link, six_link_node *base, const six_link_node *tip, const six_link_real qddot[1],
    const six_link_real etaddot[5], const six_link_real eta[5], const six_link_real m_eta[5],
    const six_link_real m_q[1], six_link_real force_eta[5], six_link_real force[1])
{
    /* S: first moment */
    const six_link_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2;
    const six_link_real S_z = eta[2] * c->sigma_y1 + eta[3] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->mu * eta[0];
    const six_link_real L_y2 = c->mu * eta[1];
    const six_link_real L_z1 = eta[2] * c->mu;
    const six_link_real L_z2 = eta[3] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1];
    const six_link_real J_xz = c->chi_1 * eta[2] + c->chi_2 * eta[3];
    const six_link_real J_yy = L_y1 * eta[0] + L_y2 * eta[1];
    const six_link_real J_yz = L_z1 * eta[0] + L_z2 * eta[1];
    const six_link_real J_zz = L_z1 * eta[2] + L_z2 * eta[3];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    const six_link_real t1 = link->R_T[0] * c->S_T_x + link->R_T[1] * c->S_T_y + link->R_T[2] * c->S_T_z;
    const six_link_real t2 = link->R_T[3] * c->S_T_x + link->R_T[4] * c->S_T_y + link->R_T[5] * c->S_T_z;
    const six_link_real t3 = link->R_T[6] * c->S_T_x + link->R_T[7] * c->S_T_y + link->R_T[8] * c->S_T_z;
    const six_link_real t4 = c->I_T_xx * link->R_T[3] - c->J_T_xy * link->R_T[4] - c->J_T_xz * link->R_T[5];
    const six_link_real t5 = c->I_T_xx * link->R_T[6] - c->J_T_xy * link->R_T[7] - c->J_T_xz * link->R_T[8];
    const six_link_real t6 = c->I_T_yy * link->R_T[4] - c->J_T_xy * link->R_T[3] - c->J_T_yz * link->R_T[5];
    const six_link_real t7 = c->I_T_yy * link->R_T[7] - c->J_T_xy * link->R_T[6] - c->J_T_yz * link->R_T[8];
    const six_link_real t8 = c->I_T_zz * link->R_T[5] - (c->J_T_xz * link->R_T[3] + c->J_T_yz * link->R_T[4]);
    const six_link_real t9 = c->I_T_zz * link->R_T[8] - (c->J_T_xz * link->R_T[6] + c->J_T_yz * link->R_T[7]);
    const six_link_real t10 = link->R_T[0]
        * (c->I_T_xx * link->R_T[0] - c->J_T_xy * link->R_T[1] - c->J_T_xz * link->R_T[2])
        + link->R_T[1] * (c->I_T_yy * link->R_T[1] - c->J_T_xy * link->R_T[0] - c->J_T_yz * link->R_T[2]);
    const six_link_real t11 = link->R_T[2]
        * (c->I_T_zz * link->R_T[2] - (c->J_T_xz * link->R_T[0] + c->J_T_yz * link->R_T[1]));
    const six_link_real t12 = link->R_T[0] * t4 + link->R_T[1] * t6 + link->R_T[2] * t8;
    const six_link_real t13 = link->R_T[0] * t5 + link->R_T[1] * t7 + link->R_T[2] * t9;
    const six_link_real t14 = link->R_T[3] * t5 + link->R_T[4] * t7 + link->R_T[5] * t9;
    const six_link_real t15 = t12 * tip->delta[0]
        + (link->R_T[3] * t4 + link->R_T[4] * t6 + link->R_T[5] * t8) * tip->delta[1];
    const six_link_real t16 = t13 * tip->delta[0] + t14 * tip->delta[1]
        + (link->R_T[6] * t5 + link->R_T[7] * t7 + link->R_T[8] * t9) * tip->delta[2];
    const six_link_real t17 = t2 * tip->delta[5] - t3 * tip->delta[4]
        + ((t10 + t11) * tip->delta[0] + t12 * tip->delta[1] + t13 * tip->delta[2]);
    const six_link_real t18 = t17 + tip->p[0];
    const six_link_real t19 = t3 * tip->delta[3] - t1 * tip->delta[5] + (t15 + t14 * tip->delta[2]) + tip->p[1];
    const six_link_real t20 = t1 * tip->delta[4] - t2 * tip->delta[3] + t16 + tip->p[2];
    const six_link_real t21 = c->body0_mass * tip->delta[3] + (tip->delta[1] * t3 - tip->delta[2] * t2) + tip->p[3];
    const six_link_real t22 = c->body0_mass * tip->delta[4] + (tip->delta[2] * t1 - tip->delta[0] * t3) + tip->p[4];
    const six_link_real t23 = c->body0_mass * tip->delta[5] + (tip->delta[0] * t2 - tip->delta[1] * t1) + tip->p[5];
    const six_link_real t24 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2]
        - S_z * link->delta[4] + S_y * link->delta[5];
    const six_link_real t25 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2]
        + S_z * link->delta[3] - c->S_0_x * link->delta[5];
    const six_link_real t26 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        - S_y * link->delta[3] + c->S_0_x * link->delta[4];
    const six_link_real motion_4 = S_z * link->delta[1] - S_y * link->delta[2] + c->mu * link->delta[3];
    const six_link_real t27 = L_y1 * etaddot[2] - (L_z1 * etaddot[0] + L_z2 * etaddot[1]) + L_y2 * etaddot[3]
        + c->sigma_t_5 * etaddot[4];
    const six_link_real t28 = c->S_0_x * link->delta[2] - S_z * link->delta[0] + c->mu * link->delta[4]
        + (c->sigma_y1 * etaddot[0] + c->sigma_y2 * etaddot[1]);
    const six_link_real t29 = S_y * link->delta[0] - c->S_0_x * link->delta[1] + c->mu * link->delta[5]
        + (c->sigma_y1 * etaddot[2] + c->sigma_y2 * etaddot[3]);
    const six_link_real wrench_tau_x = t24 + t27 + (t18 + (link->r_T[0] * t23 - link->r_T[1] * t22));
    const six_link_real wrench_tau_y = t25 - (c->chi_1 * etaddot[2] + c->chi_2 * etaddot[3])
        + (t19 + (link->r_T[1] * t21 - c->length * t23));
    const six_link_real wrench_tau_z = t26 + (c->chi_1 * etaddot[0] + c->chi_2 * etaddot[1])
        + (t20 + (c->length * t22 - link->r_T[0] * t21));
    const six_link_real wrench_f_x = motion_4 + t21;
    const six_link_real wrench_f_y = t28 + t22;
    const six_link_real wrench_f_z = t29 + t23;
    const six_link_real t30 = c->chi_1 * link->delta[2] - L_z1 * link->delta[0] + c->sigma_y1 * link->delta[4]
        + m_eta[0] * etaddot[0];
    const six_link_real t31 = c->chi_2 * link->delta[2] - L_z2 * link->delta[0] + c->sigma_y2 * link->delta[4]
        + m_eta[1] * etaddot[1];
    const six_link_real t32 = L_y1 * link->delta[0] - c->chi_1 * link->delta[1] + c->sigma_y1 * link->delta[5]
        + m_eta[2] * etaddot[2];
    const six_link_real t33 = L_y2 * link->delta[0] - c->chi_2 * link->delta[1] + c->sigma_y2 * link->delta[5]
        + m_eta[3] * etaddot[3];
    const six_link_real t34 = link->J_l[1] * t18 + link->J_l[4] * t19 + link->J_l[7] * t20;
    const six_link_real t35 = link->J_l[2] * t18 + link->J_l[5] * t19 + link->J_l[8] * t20;
    const six_link_real force_eta_5 = c->sigma_t_5 * link->delta[0] + m_eta[4] * etaddot[4]
        + (link->J_l[0] * t18 + link->J_l[3] * t19 + link->J_l[6] * t20) * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real force_eta_1 = t30 + c->Psi_c_z1 * t35 + t22 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real force_eta_2 = t31 + c->Psi_c_z2 * t35 + t22 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real force_eta_3 = t32 + c->Psi_c_y3 * t34 + t23 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real force_eta_4 = t33 + c->Psi_c_y4 * t34 + t23 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real force_1 = wrench_tau_y + m_q[0] * qddot[0];
    const six_link_real p_tau_z = link->R_P[6]
        * (wrench_tau_x + (c->mount_xyz_y * wrench_f_z - link->lever[1] * wrench_f_y))
        + link->R_P[8] * (wrench_tau_z + (link->lever[0] * wrench_f_y - c->mount_xyz_y * wrench_f_x));

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force_eta[3] = force_eta_4;
    force_eta[4] = force_eta_5;
    force[0] = force_1;
    base->p[2] = p_tau_z;
    base->p[4] = wrench_f_y;
    return SIX_LINK_OK;
}

/* inverse inward, links like forearm: 218 operations */
SIX_LINK_PART six_link_status inverse_inward_forearm_2(const six_link_link_constants *c,
    const six_link_link_store *link, six_link_node *base, const six_link_node *tip, const six_link_real qddot[1],
    const six_link_real etaddot[4], const six_link_real eta[4], const six_link_real m_eta[4],
    const six_link_real m_q[1], six_link_real force_eta[4], six_link_real force[1])
{
    /* S: first moment */
    const six_link_real S_y = c->S_B_y + eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2;
    const six_link_real S_z = c->S_B_z + eta[2] * c->sigma_y1 + eta[3] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->mu * eta[0];
    const six_link_real L_y2 = c->mu * eta[1];
    const six_link_real L_z1 = eta[2] * c->mu;
    const six_link_real L_z2 = eta[3] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->J_B_xy + c->chi_1 * eta[0] + c->chi_2 * eta[1];
    const six_link_real J_xz = c->J_B_xz + c->chi_1 * eta[2] + c->chi_2 * eta[3];
    const six_link_real J_yy = c->J_B_yy + L_y1 * eta[0] + L_y2 * eta[1];
    const six_link_real J_yz = c->J_B_yz + L_z1 * eta[0] + L_z2 * eta[1];
    const six_link_real J_zz = c->J_B_zz + L_z1 * eta[2] + L_z2 * eta[3];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    const six_link_real t1 = I_xx * link->delta[0] - J_xy * link->delta[1] - J_xz * link->delta[2]
        - S_z * link->delta[4] + S_y * link->delta[5];
    const six_link_real t2 = I_yy * link->delta[1] - J_xy * link->delta[0] - J_yz * link->delta[2]
        + S_z * link->delta[3] - c->S_0_x * link->delta[5];
    const six_link_real t3 = I_zz * link->delta[2] - (J_xz * link->delta[0] + J_yz * link->delta[1])
        - S_y * link->delta[3] + c->S_0_x * link->delta[4];
    const six_link_real motion_4 = S_z * link->delta[1] - S_y * link->delta[2] + c->m * link->delta[3];
    const six_link_real t4 = c->S_0_x * link->delta[2] - S_z * link->delta[0] + c->m * link->delta[4]
        + (c->sigma_y1 * etaddot[0] + c->sigma_y2 * etaddot[1]);
    const six_link_real t5 = S_y * link->delta[0] - c->S_0_x * link->delta[1] + c->m * link->delta[5]
        + (c->sigma_y1 * etaddot[2] + c->sigma_y2 * etaddot[3]);
    const six_link_real wrench_tau_x = t1
        + (L_y1 * etaddot[2] - (L_z1 * etaddot[0] + L_z2 * etaddot[1]) + L_y2 * etaddot[3])
        + (tip->p[0] + (link->r_T[0] * tip->p[5] - link->r_T[1] * tip->p[4]));
    const six_link_real wrench_tau_y = t2 - (c->chi_1 * etaddot[2] + c->chi_2 * etaddot[3])
        + (tip->p[1] + (link->r_T[1] * tip->p[3] - c->length * tip->p[5]));
    const six_link_real wrench_tau_z = t3 + (c->chi_1 * etaddot[0] + c->chi_2 * etaddot[1])
        + (tip->p[2] + (c->length * tip->p[4] - link->r_T[0] * tip->p[3]));
    const six_link_real wrench_f_x = motion_4 + tip->p[3];
    const six_link_real wrench_f_y = t4 + tip->p[4];
    const six_link_real wrench_f_z = t5 + tip->p[5];
    const six_link_real t6 = c->chi_1 * link->delta[2] - L_z1 * link->delta[0] + c->sigma_y1 * link->delta[4]
        + m_eta[0] * etaddot[0];
    const six_link_real t7 = c->chi_2 * link->delta[2] - L_z2 * link->delta[0] + c->sigma_y2 * link->delta[4]
        + m_eta[1] * etaddot[1];
    const six_link_real t8 = L_y1 * link->delta[0] - c->chi_1 * link->delta[1] + c->sigma_y1 * link->delta[5]
        + m_eta[2] * etaddot[2];
    const six_link_real t9 = L_y2 * link->delta[0] - c->chi_2 * link->delta[1] + c->sigma_y2 * link->delta[5]
        + m_eta[3] * etaddot[3];
    const six_link_real t10 = link->J_l[3] * tip->p[1] - link->J_l[1] * tip->p[0] + link->J_l[4] * tip->p[2];
    const six_link_real t11 = link->J_l[2] * tip->p[0] + link->J_l[4] * tip->p[1] + link->J_l[5] * tip->p[2];
    const six_link_real force_eta_1 = t6 + c->Psi_c_z1 * t11 + tip->p[4] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real force_eta_2 = t7 + c->Psi_c_z2 * t11 + tip->p[4] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real force_eta_3 = t8 + c->Psi_c_y3 * t10 + tip->p[5] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real force_eta_4 = t9 + c->Psi_c_y4 * t10 + tip->p[5] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real force_1 = wrench_tau_y + m_q[0] * qddot[0];
    const six_link_real t12 = wrench_tau_x + (link->lever[1] * wrench_f_z - link->lever[2] * wrench_f_y);
    const six_link_real t13 = wrench_tau_y + (link->lever[2] * wrench_f_x - link->lever[0] * wrench_f_z);
    const six_link_real t14 = wrench_tau_z + (link->lever[0] * wrench_f_y - link->lever[1] * wrench_f_x);
    const six_link_real p_tau_x = link->R_P[0] * t12 + link->R_P[1] * t13 + link->R_P[2] * t14;
    const six_link_real p_tau_y = link->R_P[3] * t12 + link->R_P[4] * t13 + link->R_P[5] * t14;
    const six_link_real p_tau_z = link->R_P[6] * t12 + link->R_P[7] * t13 + link->R_P[8] * t14;
    const six_link_real p_f_x = link->R_P[0] * wrench_f_x + link->R_P[1] * wrench_f_y + link->R_P[2] * wrench_f_z;
    const six_link_real p_f_y = link->R_P[3] * wrench_f_x + link->R_P[4] * wrench_f_y + link->R_P[5] * wrench_f_z;
    const six_link_real p_f_z = link->R_P[6] * wrench_f_x + link->R_P[7] * wrench_f_y + link->R_P[8] * wrench_f_z;

    /* outputs */
    force_eta[0] = force_eta_1;
    force_eta[1] = force_eta_2;
    force_eta[2] = force_eta_3;
    force_eta[3] = force_eta_4;
    force[0] = force_1;
    base->p[0] = p_tau_x;
    base->p[1] = p_tau_y;
    base->p[2] = p_tau_z;
    base->p[3] = p_f_x;
    base->p[4] = p_f_y;
    base->p[5] = p_f_z;
    return SIX_LINK_OK;
}

/* inverse inward, links like wrist_roll: 56 operations */
SIX_LINK_PART six_link_status inverse_inward_wrist_roll_2(const six_link_link_constants *c,
    const six_link_link_store *link, six_link_node *base, const six_link_node *tip, const six_link_real qddot[1],
    const six_link_real m_q[1], six_link_real force[1])
{
    const six_link_real wrench_tau_x = c->I_s * link->delta[0] + tip->p[0];
    const six_link_real wrench_tau_y = c->J_0_xx * link->delta[1] - c->S_0_x * link->delta[5]
        + (tip->p[1] - c->length * tip->p[5]);
    const six_link_real wrench_tau_z = c->J_0_xx * link->delta[2] + c->S_0_x * link->delta[4]
        + (tip->p[2] + c->length * tip->p[4]);
    const six_link_real wrench_f_x = c->mu * link->delta[3] + tip->p[3];
    const six_link_real wrench_f_y = c->S_0_x * link->delta[2] + c->mu * link->delta[4] + tip->p[4];
    const six_link_real wrench_f_z = c->mu * link->delta[5] - c->S_0_x * link->delta[1] + tip->p[5];
    const six_link_real force_1 = wrench_tau_x + m_q[0] * qddot[0];
    const six_link_real p_tau_x = link->R_P[0] * wrench_tau_x + link->R_P[1] * wrench_tau_y
        + link->R_P[2] * wrench_tau_z;
    const six_link_real p_tau_y = link->R_P[3] * wrench_tau_x + link->R_P[4] * wrench_tau_y
        + link->R_P[5] * wrench_tau_z;
    const six_link_real p_tau_z = link->R_P[6] * wrench_tau_x + link->R_P[7] * wrench_tau_y
        + link->R_P[8] * wrench_tau_z;
    const six_link_real p_f_x = link->R_P[0] * wrench_f_x + link->R_P[1] * wrench_f_y + link->R_P[2] * wrench_f_z;
    const six_link_real p_f_y = link->R_P[3] * wrench_f_x + link->R_P[4] * wrench_f_y + link->R_P[5] * wrench_f_z;
    const six_link_real p_f_z = link->R_P[6] * wrench_f_x + link->R_P[7] * wrench_f_y + link->R_P[8] * wrench_f_z;

    /* outputs */
    force[0] = force_1;
    base->p[0] = p_tau_x;
    base->p[1] = p_tau_y;
    base->p[2] = p_tau_z;
    base->p[3] = p_f_x;
    base->p[4] = p_f_y;
    base->p[5] = p_f_z;
    return SIX_LINK_OK;
}

/* inverse inward, links like wrist_pitch: 38 operations */
SIX_LINK_PART six_link_status inverse_inward_wrist_pitch_2(const six_link_link_constants *c,
    const six_link_link_store *link, six_link_node *base, const six_link_node *tip, const six_link_real qddot[1],
    const six_link_real m_q[1], six_link_real force[1])
{
    const six_link_real wrench_tau_x = c->I_s * link->delta[0] + tip->p[0];
    const six_link_real wrench_tau_y = c->J_0_xx * link->delta[1] - c->S_0_x * link->delta[5]
        + (tip->p[1] - c->length * tip->p[5]);
    const six_link_real wrench_tau_z = c->J_0_xx * link->delta[2] + c->S_0_x * link->delta[4]
        + (tip->p[2] + c->length * tip->p[4]);
    const six_link_real wrench_f_x = c->mu * link->delta[3] + tip->p[3];
    const six_link_real wrench_f_y = c->S_0_x * link->delta[2] + c->mu * link->delta[4] + tip->p[4];
    const six_link_real wrench_f_z = c->mu * link->delta[5] - c->S_0_x * link->delta[1] + tip->p[5];
    const six_link_real force_1 = wrench_tau_y + m_q[0] * qddot[0];
    const six_link_real p_tau_x = link->R_P[0] * wrench_tau_x + link->R_P[2] * wrench_tau_z;
    const six_link_real p_tau_z = link->R_P[6] * wrench_tau_x + link->R_P[8] * wrench_tau_z;
    const six_link_real p_f_x = link->R_P[0] * wrench_f_x + link->R_P[2] * wrench_f_z;
    const six_link_real p_f_z = link->R_P[6] * wrench_f_x + link->R_P[8] * wrench_f_z;

    /* outputs */
    force[0] = force_1;
    base->p[0] = p_tau_x;
    base->p[1] = wrench_tau_y;
    base->p[2] = p_tau_z;
    base->p[3] = p_f_x;
    base->p[4] = wrench_f_y;
    base->p[5] = p_f_z;
    return SIX_LINK_OK;
}

/* inverse inward, links like flange: 80 operations */
SIX_LINK_PART six_link_status inverse_inward_flange_2(const six_link_link_constants *c, const six_link_link_store *link,
    six_link_node *base, const six_link_node *tip, const six_link_real qddot[1], const six_link_real m_q[1],
    six_link_real force[1])
{
    const six_link_real t1 = c->S_T_y * tip->delta[5] - c->S_T_z * tip->delta[4]
        + (c->I_T_xx * tip->delta[0] - c->J_T_xy * tip->delta[1] - c->J_T_xz * tip->delta[2]);
    const six_link_real t2 = c->S_T_z * tip->delta[3] - c->S_T_x * tip->delta[5]
        + (c->I_T_yy * tip->delta[1] - c->J_T_xy * tip->delta[0] - c->J_T_yz * tip->delta[2]);
    const six_link_real t3 = c->S_T_x * tip->delta[4] - c->S_T_y * tip->delta[3]
        + (c->I_T_zz * tip->delta[2] - (c->J_T_xz * tip->delta[0] + c->J_T_yz * tip->delta[1]));
    const six_link_real t4 = c->body0_mass * tip->delta[4] + (tip->delta[2] * c->S_T_x - tip->delta[0] * c->S_T_z);
    const six_link_real t5 = c->body0_mass * tip->delta[5] + (tip->delta[0] * c->S_T_y - tip->delta[1] * c->S_T_x);
    const six_link_real wrench_tau_x = c->I_s * link->delta[0] + t1;
    const six_link_real wrench_tau_y = c->J_0_xx * link->delta[1] - c->S_0_x * link->delta[5] + (t2 - c->length * t5);
    const six_link_real wrench_tau_z = c->J_0_xx * link->delta[2] + c->S_0_x * link->delta[4] + (t3 + c->length * t4);
    const six_link_real wrench_f_x = c->mu * link->delta[3]
        + (c->body0_mass * tip->delta[3] + (tip->delta[1] * c->S_T_z - tip->delta[2] * c->S_T_y));
    const six_link_real wrench_f_y = c->S_0_x * link->delta[2] + c->mu * link->delta[4] + t4;
    const six_link_real wrench_f_z = c->mu * link->delta[5] - c->S_0_x * link->delta[1] + t5;
    const six_link_real force_1 = wrench_tau_x + m_q[0] * qddot[0];
    const six_link_real p_tau_y = link->R_P[4] * wrench_tau_y + link->R_P[5] * wrench_tau_z;
    const six_link_real p_tau_z = link->R_P[7] * wrench_tau_y + link->R_P[8] * wrench_tau_z;
    const six_link_real p_f_y = link->R_P[4] * wrench_f_y + link->R_P[5] * wrench_f_z;
    const six_link_real p_f_z = link->R_P[7] * wrench_f_y + link->R_P[8] * wrench_f_z;

    /* outputs */
    force[0] = force_1;
    base->p[0] = wrench_tau_x;
    base->p[1] = p_tau_y;
    base->p[2] = p_tau_z;
    base->p[3] = wrench_f_x;
    base->p[4] = p_f_y;
    base->p[5] = p_f_z;
    return SIX_LINK_OK;
}

/* velocities, links like shoulder: 1 operations */
SIX_LINK_PART six_link_status velocities_shoulder(const six_link_link_constants *c, six_link_node *tip,
    const six_link_real qdot[1])
{
    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = c->length * qdot[0];

    /* outputs */
    tip->omega_T[2] = qdot[0];
    tip->v_T[1] = v_T_y;
    return SIX_LINK_OK;
}

/* velocities, links like upper_arm: 148 operations */
SIX_LINK_PART six_link_status velocities_upper_arm(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1], const six_link_real eta[5],
    const six_link_real etadot[5])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real minus_omega_R_x = R_rel_xz * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_xx * base->omega_T[2];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real t1 = c->mount_xyz_y * base->omega_T[2];
    const six_link_real minus_v_R_x = R_rel_xx * t1;
    const six_link_real v_R_y = base->v_T[1] + c->mount_xyz_x * base->omega_T[2];
    const six_link_real minus_v_R_z = R_rel_xz * t1;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real t2 = theta_x * theta_x;
    const six_link_real t3 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t2 + t3;
    const six_link_real t4 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t4;

    /* c1: Stumpff function of order 1 */
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * six_link_c5(x);
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t3 + t4;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t2 + t4;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t5 = c2 * theta_hat2_12;
    const six_link_real t6 = c1 * theta_z;
    const six_link_real R_T_xy = t5 - t6;
    const six_link_real t7 = c1 * theta_y;
    const six_link_real t8 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t7 + t8;
    const six_link_real R_T_yx = t6 + t5;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t9 = c2 * theta_hat2_23;
    const six_link_real t10 = c1 * theta_x;
    const six_link_real R_T_yz = t9 - t10;
    const six_link_real R_T_zx = t8 - t7;
    const six_link_real R_T_zy = t10 + t9;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_x = etadot[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t11 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real t12 = theta_x * thetadot_y - theta_y * thetadot_x;
    const six_link_real t13 = theta_z * thetadot_x - theta_x * thetadot_z;
    const six_link_real omega_s_x = thetadot_x + c2 * t11 + c3 * (theta_y * t12 - theta_z * t13);
    const six_link_real omega_s_y = thetadot_y + c2 * t13 + c3 * (theta_z * t11 - theta_x * t12);
    const six_link_real omega_s_z = thetadot_z + c2 * t12 + c3 * (theta_x * t13 - theta_y * t11);

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t14 = omega_s_x - minus_omega_R_x;
    const six_link_real t15 = omega_s_y + qdot[0];
    const six_link_real t16 = omega_s_z + omega_R_z;
    const six_link_real omega_T_x = R_T_xx * t14 + R_T_yx * t15 + R_T_zx * t16;
    const six_link_real omega_T_y = R_T_xy * t14 + R_T_yy * t15 + R_T_zy * t16;
    const six_link_real omega_T_z = R_T_xz * t14 + R_T_yz * t15 + R_T_zz * t16;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t17 = qdot[0] * r_T_z - minus_v_R_x - omega_R_z * r_T_y;
    const six_link_real t18 = udot_T_y + v_R_y + c->length * omega_R_z + minus_omega_R_x * r_T_z;
    const six_link_real t19 = udot_T_z - minus_v_R_z - minus_omega_R_x * r_T_y - c->length * qdot[0];
    const six_link_real v_T_x = R_T_xx * t17 + R_T_yx * t18 + R_T_zx * t19;
    const six_link_real v_T_y = R_T_xy * t17 + R_T_yy * t18 + R_T_zy * t19;
    const six_link_real v_T_z = R_T_xz * t17 + R_T_yz * t18 + R_T_zz * t19;

    /* outputs */
    tip->omega_T[0] = omega_T_x;
    tip->omega_T[1] = omega_T_y;
    tip->omega_T[2] = omega_T_z;
    tip->v_T[0] = v_T_x;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    return SIX_LINK_OK;
}

/* velocities, links like forearm: 165 operations */
SIX_LINK_PART six_link_status velocities_forearm(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1], const six_link_real eta[4],
    const six_link_real etadot[4])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real t1 = turn.sine, t2 = turn.cosine;
    const six_link_real R_rel_xx = c->R_m_xx * t2 - c->R_m_xz * t1;
    const six_link_real R_rel_xz = c->R_m_xx * t1 + c->R_m_xz * t2;
    const six_link_real R_rel_yx = c->R_m_yx * t2 - c->R_m_yz * t1;
    const six_link_real R_rel_yz = c->R_m_yx * t1 + c->R_m_yz * t2;
    const six_link_real R_rel_zx = c->R_m_zx * t2 - c->R_m_zz * t1;
    const six_link_real R_rel_zz = c->R_m_zx * t1 + c->R_m_zz * t2;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx * base->omega_T[0] + R_rel_yx * base->omega_T[1]
        + R_rel_zx * base->omega_T[2];
    const six_link_real omega_R_y = c->R_m_xy * base->omega_T[0] + c->R_m_yy * base->omega_T[1]
        + c->R_m_zy * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega_T[0] + R_rel_yz * base->omega_T[1]
        + R_rel_zz * base->omega_T[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = omega_R_y + qdot[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real t3 = base->v_T[0] + c->mount_xyz_z * base->omega_T[1] - c->mount_xyz_y * base->omega_T[2];
    const six_link_real t4 = base->v_T[1] + c->mount_xyz_x * base->omega_T[2] - c->mount_xyz_z * base->omega_T[0];
    const six_link_real t5 = base->v_T[2] + c->mount_xyz_y * base->omega_T[0] - c->mount_xyz_x * base->omega_T[1];
    const six_link_real v_R_x = R_rel_xx * t3 + R_rel_yx * t4 + R_rel_zx * t5;
    const six_link_real v_R_y = c->R_m_xy * t3 + c->R_m_yy * t4 + c->R_m_zy * t5;
    const six_link_real v_R_z = R_rel_xz * t3 + R_rel_yz * t4 + R_rel_zz * t5;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * six_link_c5(x);
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real R_T_yx = c1 * theta_z;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t6 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real omega_s_x = c2 * t6;
    const six_link_real omega_s_y = thetadot_y + c3 * theta_z * t6;
    const six_link_real omega_s_z = thetadot_z - c3 * theta_y * t6;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t7 = omega_s_x + omega_R_x;
    const six_link_real t8 = omega_s_y + omega_y;
    const six_link_real t9 = omega_s_z + omega_R_z;
    const six_link_real omega_T_x = R_T_xx * t7 + R_T_yx * t8 - R_T_xz * t9;
    const six_link_real omega_T_y = R_T_yy * t8 - R_T_yx * t7 + R_T_yz * t9;
    const six_link_real omega_T_z = R_T_xz * t7 + R_T_yz * t8 + R_T_zz * t9;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t10 = v_R_x + omega_y * r_T_z - omega_R_z * r_T_y;
    const six_link_real t11 = udot_T_y + v_R_y + c->length * omega_R_z - omega_R_x * r_T_z;
    const six_link_real t12 = udot_T_z + v_R_z + omega_R_x * r_T_y - c->length * omega_y;
    const six_link_real v_T_x = R_T_xx * t10 + R_T_yx * t11 - R_T_xz * t12;
    const six_link_real v_T_y = R_T_yy * t11 - R_T_yx * t10 + R_T_yz * t12;
    const six_link_real v_T_z = R_T_xz * t10 + R_T_yz * t11 + R_T_zz * t12;

    /* outputs */
    tip->omega_T[0] = omega_T_x;
    tip->omega_T[1] = omega_T_y;
    tip->omega_T[2] = omega_T_z;
    tip->v_T[0] = v_T_x;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    return SIX_LINK_OK;
}

/* velocities, links like wrist_roll: 19 operations */
SIX_LINK_PART six_link_status velocities_wrist_roll(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_y = R_rel_yy * base->omega_T[1] + R_rel_zy * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega_T[2] - R_rel_zy * base->omega_T[1];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_x = base->omega_T[0] + qdot[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_y = R_rel_yy * base->v_T[1] + R_rel_zy * base->v_T[2];
    const six_link_real v_R_z = R_rel_yy * base->v_T[2] - R_rel_zy * base->v_T[1];

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = v_R_y + c->length * omega_R_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_R_y;

    /* outputs */
    tip->omega_T[0] = omega_x;
    tip->omega_T[1] = omega_R_y;
    tip->omega_T[2] = omega_R_z;
    tip->v_T[0] = base->v_T[0];
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    return SIX_LINK_OK;
}

/* velocities, links like wrist_pitch: 19 operations */
SIX_LINK_PART six_link_status velocities_wrist_pitch(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real qdot[1])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx * base->omega_T[0] - R_rel_xz * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega_T[0] + R_rel_xx * base->omega_T[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = base->omega_T[1] + qdot[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_x = R_rel_xx * base->v_T[0] - R_rel_xz * base->v_T[2];
    const six_link_real v_R_z = R_rel_xz * base->v_T[0] + R_rel_xx * base->v_T[2];

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = base->v_T[1] + c->length * omega_R_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_y;

    /* outputs */
    tip->omega_T[0] = omega_R_x;
    tip->omega_T[1] = omega_y;
    tip->omega_T[2] = omega_R_z;
    tip->v_T[0] = v_R_x;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    return SIX_LINK_OK;
}

/* poses, links like shoulder: 7 operations */
SIX_LINK_PART six_link_status poses_shoulder(const six_link_link_constants *c, six_link_node *tip,
    const six_link_real q[1], six_link_real R[9], six_link_real r[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_yx = turn.sine, R_rel_xx = turn.cosine;

    /* pose: rotation and position of F_i in the inertial frame (Ad) */
    const six_link_real t1 = -R_rel_yx;

    /* pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real r_tip_x = c->mount_xyz_x + R_rel_xx * c->length;
    const six_link_real r_tip_y = c->mount_xyz_y + R_rel_yx * c->length;

    /* outputs */
    R[0] = R_rel_xx;
    R[1] = t1;
    R[2] = 0;
    R[3] = R_rel_yx;
    R[4] = R_rel_xx;
    R[5] = 0;
    R[6] = 0;
    R[7] = 0;
    R[8] = 1;
    r[0] = c->mount_xyz_x;
    r[1] = c->mount_xyz_y;
    r[2] = c->mount_xyz_z;
    tip->R[0] = R_rel_xx;
    tip->R[1] = t1;
    tip->R[2] = 0;
    tip->R[3] = R_rel_yx;
    tip->R[4] = R_rel_xx;
    tip->R[5] = 0;
    tip->R[6] = 0;
    tip->R[7] = 0;
    tip->R[8] = 1;
    tip->r[0] = r_tip_x;
    tip->r[1] = r_tip_y;
    tip->r[2] = c->mount_xyz_z;
    return SIX_LINK_OK;
}

/* poses, links like upper_arm: 120 operations */
SIX_LINK_PART six_link_status poses_upper_arm(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real eta[5], six_link_real R[9], six_link_real r[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real t1 = theta_x * theta_x;
    const six_link_real t2 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t1 + t2;
    const six_link_real t3 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t3;

    /* c1: Stumpff function of order 1 */
    const six_link_real c1 = 1 - x * (SIX_LINK_REAL(0.16666666666666666) - x * six_link_c5(x));

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t2 + t3;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t1 + t3;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t4 = c2 * theta_hat2_12;
    const six_link_real t5 = c1 * theta_z;
    const six_link_real R_T_xy = t4 - t5;
    const six_link_real t6 = c1 * theta_y;
    const six_link_real t7 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t6 + t7;
    const six_link_real R_T_yx = t5 + t4;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t8 = c2 * theta_hat2_23;
    const six_link_real t9 = c1 * theta_x;
    const six_link_real R_T_yz = t8 - t9;
    const six_link_real R_T_zx = t7 - t6;
    const six_link_real R_T_zy = t9 + t8;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* pose: rotation and position of F_i in the inertial frame (Ad) */
    const six_link_real R_xx = base->R[0] * R_rel_xx;
    const six_link_real R_xz = base->R[0] * R_rel_xz;
    const six_link_real R_yx = base->R[3] * R_rel_xx;
    const six_link_real R_yz = base->R[3] * R_rel_xz;
    const six_link_real t10 = -R_rel_xz;
    const six_link_real r_x = base->r[0] + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y);
    const six_link_real r_y = base->r[1] + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y);
    const six_link_real r_z = base->r[2] + c->mount_xyz_z;

    /* pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real R_tip_xx = R_xx * R_T_xx + base->R[1] * R_T_yx + R_xz * R_T_zx;
    const six_link_real R_tip_xy = R_xx * R_T_xy + base->R[1] * R_T_yy + R_xz * R_T_zy;
    const six_link_real R_tip_xz = R_xx * R_T_xz + base->R[1] * R_T_yz + R_xz * R_T_zz;
    const six_link_real R_tip_yx = R_yx * R_T_xx + base->R[4] * R_T_yx + R_yz * R_T_zx;
    const six_link_real R_tip_yy = R_yx * R_T_xy + base->R[4] * R_T_yy + R_yz * R_T_zy;
    const six_link_real R_tip_yz = R_yx * R_T_xz + base->R[4] * R_T_yz + R_yz * R_T_zz;
    const six_link_real R_tip_zx = R_rel_xx * R_T_zx - R_rel_xz * R_T_xx;
    const six_link_real R_tip_zy = R_rel_xx * R_T_zy - R_rel_xz * R_T_xy;
    const six_link_real R_tip_zz = R_rel_xx * R_T_zz - R_rel_xz * R_T_xz;
    const six_link_real r_tip_x = r_x + (R_xx * c->length + base->R[1] * r_T_y + R_xz * r_T_z);
    const six_link_real r_tip_y = r_y + (R_yx * c->length + base->R[4] * r_T_y + R_yz * r_T_z);
    const six_link_real r_tip_z = r_z + (R_rel_xx * r_T_z - R_rel_xz * c->length);

    /* outputs */
    R[0] = R_xx;
    R[1] = base->R[1];
    R[2] = R_xz;
    R[3] = R_yx;
    R[4] = base->R[4];
    R[5] = R_yz;
    R[6] = t10;
    R[7] = 0;
    R[8] = R_rel_xx;
    r[0] = r_x;
    r[1] = r_y;
    r[2] = r_z;
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
    return SIX_LINK_OK;
}

/* poses, links like forearm: 179 operations */
SIX_LINK_PART six_link_status poses_forearm(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], const six_link_real eta[4], six_link_real R[9], six_link_real r[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real t1 = turn.sine, t2 = turn.cosine;
    const six_link_real R_rel_xx = c->R_m_xx * t2 - c->R_m_xz * t1;
    const six_link_real R_rel_xz = c->R_m_xx * t1 + c->R_m_xz * t2;
    const six_link_real R_rel_yx = c->R_m_yx * t2 - c->R_m_yz * t1;
    const six_link_real R_rel_yz = c->R_m_yx * t1 + c->R_m_yz * t2;
    const six_link_real R_rel_zx = c->R_m_zx * t2 - c->R_m_zz * t1;
    const six_link_real R_rel_zz = c->R_m_zx * t1 + c->R_m_zz * t2;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const six_link_real c1 = 1 - x * (SIX_LINK_REAL(0.16666666666666666) - x * six_link_c5(x));

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real R_T_yx = c1 * theta_z;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* pose: rotation and position of F_i in the inertial frame (Ad) */
    const six_link_real R_xx = base->R[0] * R_rel_xx + base->R[1] * R_rel_yx + base->R[2] * R_rel_zx;
    const six_link_real R_xy = base->R[0] * c->R_m_xy + base->R[1] * c->R_m_yy + base->R[2] * c->R_m_zy;
    const six_link_real R_xz = base->R[0] * R_rel_xz + base->R[1] * R_rel_yz + base->R[2] * R_rel_zz;
    const six_link_real R_yx = base->R[3] * R_rel_xx + base->R[4] * R_rel_yx + base->R[5] * R_rel_zx;
    const six_link_real R_yy = base->R[3] * c->R_m_xy + base->R[4] * c->R_m_yy + base->R[5] * c->R_m_zy;
    const six_link_real R_yz = base->R[3] * R_rel_xz + base->R[4] * R_rel_yz + base->R[5] * R_rel_zz;
    const six_link_real R_zx = base->R[6] * R_rel_xx + base->R[7] * R_rel_yx + base->R[8] * R_rel_zx;
    const six_link_real R_zy = base->R[6] * c->R_m_xy + base->R[7] * c->R_m_yy + base->R[8] * c->R_m_zy;
    const six_link_real R_zz = base->R[6] * R_rel_xz + base->R[7] * R_rel_yz + base->R[8] * R_rel_zz;
    const six_link_real r_x = base->r[0]
        + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y + base->R[2] * c->mount_xyz_z);
    const six_link_real r_y = base->r[1]
        + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y + base->R[5] * c->mount_xyz_z);
    const six_link_real r_z = base->r[2]
        + (base->R[6] * c->mount_xyz_x + base->R[7] * c->mount_xyz_y + base->R[8] * c->mount_xyz_z);

    /* pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real R_tip_xx = R_xx * R_T_xx + R_xy * R_T_yx - R_xz * R_T_xz;
    const six_link_real R_tip_xy = R_xy * R_T_yy - R_xx * R_T_yx + R_xz * R_T_yz;
    const six_link_real R_tip_xz = R_xx * R_T_xz + R_xy * R_T_yz + R_xz * R_T_zz;
    const six_link_real R_tip_yx = R_yx * R_T_xx + R_yy * R_T_yx - R_yz * R_T_xz;
    const six_link_real R_tip_yy = R_yy * R_T_yy - R_yx * R_T_yx + R_yz * R_T_yz;
    const six_link_real R_tip_yz = R_yx * R_T_xz + R_yy * R_T_yz + R_yz * R_T_zz;
    const six_link_real R_tip_zx = R_zx * R_T_xx + R_zy * R_T_yx - R_zz * R_T_xz;
    const six_link_real R_tip_zy = R_zy * R_T_yy - R_zx * R_T_yx + R_zz * R_T_yz;
    const six_link_real R_tip_zz = R_zx * R_T_xz + R_zy * R_T_yz + R_zz * R_T_zz;
    const six_link_real r_tip_x = r_x + (R_xx * c->length + R_xy * r_T_y + R_xz * r_T_z);
    const six_link_real r_tip_y = r_y + (R_yx * c->length + R_yy * r_T_y + R_yz * r_T_z);
    const six_link_real r_tip_z = r_z + (R_zx * c->length + R_zy * r_T_y + R_zz * r_T_z);

    /* outputs */
    R[0] = R_xx;
    R[1] = R_xy;
    R[2] = R_xz;
    R[3] = R_yx;
    R[4] = R_yy;
    R[5] = R_yz;
    R[6] = R_zx;
    R[7] = R_zy;
    R[8] = R_zz;
    r[0] = r_x;
    r[1] = r_y;
    r[2] = r_z;
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
    return SIX_LINK_OK;
}

/* poses, links like wrist_roll: 26 operations */
SIX_LINK_PART six_link_status poses_wrist_roll(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], six_link_real R[9], six_link_real r[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;

    /* pose: rotation and position of F_i in the inertial frame (Ad) */
    const six_link_real R_xy = base->R[1] * R_rel_yy + base->R[2] * R_rel_zy;
    const six_link_real R_xz = base->R[2] * R_rel_yy - base->R[1] * R_rel_zy;
    const six_link_real R_yy = base->R[4] * R_rel_yy + base->R[5] * R_rel_zy;
    const six_link_real R_yz = base->R[5] * R_rel_yy - base->R[4] * R_rel_zy;
    const six_link_real R_zy = base->R[7] * R_rel_yy + base->R[8] * R_rel_zy;
    const six_link_real R_zz = base->R[8] * R_rel_yy - base->R[7] * R_rel_zy;

    /* pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real r_tip_x = base->r[0] + base->R[0] * c->length;
    const six_link_real r_tip_y = base->r[1] + base->R[3] * c->length;
    const six_link_real r_tip_z = base->r[2] + base->R[6] * c->length;

    /* outputs */
    R[0] = base->R[0];
    R[1] = R_xy;
    R[2] = R_xz;
    R[3] = base->R[3];
    R[4] = R_yy;
    R[5] = R_yz;
    R[6] = base->R[6];
    R[7] = R_zy;
    R[8] = R_zz;
    r[0] = base->r[0];
    r[1] = base->r[1];
    r[2] = base->r[2];
    tip->R[0] = base->R[0];
    tip->R[1] = R_xy;
    tip->R[2] = R_xz;
    tip->R[3] = base->R[3];
    tip->R[4] = R_yy;
    tip->R[5] = R_yz;
    tip->R[6] = base->R[6];
    tip->R[7] = R_zy;
    tip->R[8] = R_zz;
    tip->r[0] = r_tip_x;
    tip->r[1] = r_tip_y;
    tip->r[2] = r_tip_z;
    return SIX_LINK_OK;
}

/* poses, links like wrist_pitch: 26 operations */
SIX_LINK_PART six_link_status poses_wrist_pitch(const six_link_link_constants *c, const six_link_node *base,
    six_link_node *tip, const six_link_real q[1], six_link_real R[9], six_link_real r[3])
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;

    /* pose: rotation and position of F_i in the inertial frame (Ad) */
    const six_link_real R_xx = base->R[0] * R_rel_xx - base->R[2] * R_rel_xz;
    const six_link_real R_xz = base->R[0] * R_rel_xz + base->R[2] * R_rel_xx;
    const six_link_real R_yx = base->R[3] * R_rel_xx - base->R[5] * R_rel_xz;
    const six_link_real R_yz = base->R[3] * R_rel_xz + base->R[5] * R_rel_xx;
    const six_link_real R_zx = base->R[6] * R_rel_xx - base->R[8] * R_rel_xz;
    const six_link_real R_zz = base->R[6] * R_rel_xz + base->R[8] * R_rel_xx;

    /* pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real r_tip_x = base->r[0] + R_xx * c->length;
    const six_link_real r_tip_y = base->r[1] + R_yx * c->length;
    const six_link_real r_tip_z = base->r[2] + R_zx * c->length;

    /* outputs */
    R[0] = R_xx;
    R[1] = base->R[1];
    R[2] = R_xz;
    R[3] = R_yx;
    R[4] = base->R[4];
    R[5] = R_yz;
    R[6] = R_zx;
    R[7] = base->R[7];
    R[8] = R_zz;
    r[0] = base->r[0];
    r[1] = base->r[1];
    r[2] = base->r[2];
    tip->R[0] = R_xx;
    tip->R[1] = base->R[1];
    tip->R[2] = R_xz;
    tip->R[3] = R_yx;
    tip->R[4] = base->R[4];
    tip->R[5] = R_yz;
    tip->R[6] = R_zx;
    tip->R[7] = base->R[7];
    tip->R[8] = R_zz;
    tip->r[0] = r_tip_x;
    tip->r[1] = r_tip_y;
    tip->r[2] = r_tip_z;
    return SIX_LINK_OK;
}

/* tip twist, links like shoulder: 2 operations */
SIX_LINK_PART six_link_status tip_twist_shoulder(const six_link_node *tip, six_link_real tip_twist[6])
{
    const six_link_real tip_twist_v_x = tip->R[1] * tip->v_T[1];
    const six_link_real tip_twist_v_y = tip->R[4] * tip->v_T[1];

    /* outputs */
    tip_twist[0] = 0;
    tip_twist[1] = 0;
    tip_twist[2] = tip->omega_T[2];
    tip_twist[3] = tip_twist_v_x;
    tip_twist[4] = tip_twist_v_y;
    tip_twist[5] = 0;
    return SIX_LINK_OK;
}

/* tip twist, links like upper_arm: 30 operations */
SIX_LINK_PART six_link_status tip_twist_upper_arm(const six_link_node *tip, six_link_real tip_twist[6])
{
    const six_link_real tip_twist_omega_x = tip->R[0] * tip->omega_T[0] + tip->R[1] * tip->omega_T[1]
        + tip->R[2] * tip->omega_T[2];
    const six_link_real tip_twist_omega_y = tip->R[3] * tip->omega_T[0] + tip->R[4] * tip->omega_T[1]
        + tip->R[5] * tip->omega_T[2];
    const six_link_real tip_twist_omega_z = tip->R[6] * tip->omega_T[0] + tip->R[7] * tip->omega_T[1]
        + tip->R[8] * tip->omega_T[2];
    const six_link_real tip_twist_v_x = tip->R[0] * tip->v_T[0] + tip->R[1] * tip->v_T[1] + tip->R[2] * tip->v_T[2];
    const six_link_real tip_twist_v_y = tip->R[3] * tip->v_T[0] + tip->R[4] * tip->v_T[1] + tip->R[5] * tip->v_T[2];
    const six_link_real tip_twist_v_z = tip->R[6] * tip->v_T[0] + tip->R[7] * tip->v_T[1] + tip->R[8] * tip->v_T[2];

    /* outputs */
    tip_twist[0] = tip_twist_omega_x;
    tip_twist[1] = tip_twist_omega_y;
    tip_twist[2] = tip_twist_omega_z;
    tip_twist[3] = tip_twist_v_x;
    tip_twist[4] = tip_twist_v_y;
    tip_twist[5] = tip_twist_v_z;
    return SIX_LINK_OK;
}

/* measure, links like shoulder: 0 operations */
SIX_LINK_PART six_link_status measure_shoulder(six_link_real measures[restrict 4])
{
    /* outputs */
    measures[0] = 0;
    measures[1] = 0;
    measures[2] = 0;
    measures[3] = 0;
    return SIX_LINK_OK;
}

/* measure, links like upper_arm: 33 operations */
SIX_LINK_PART six_link_status measure_upper_arm(const six_link_link_constants *restrict c,
    const six_link_real eta[restrict 5], const six_link_real motion[restrict 4], const six_link_real wrench[restrict 6],
    six_link_real measures[restrict 4])
{
    /* deflection_T: transverse displacement of the tip, components y and z in F_i */
    const six_link_real deflection_T_1 = eta[1] * SIX_LINK_REAL(2.8145226674626453)
        + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real deflection_T_2 = eta[3] * SIX_LINK_REAL(2.8145226674626453)
        + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* deflection_2: its square */
    const six_link_real deflection_2 = deflection_T_1 * deflection_T_1 + deflection_T_2 * deflection_T_2;

    /* deflection: transverse displacement of the tip over length */
    const six_link_real deflection = six_link_sqrt(deflection_2) / c->length;
    measures[0] = deflection;

    /* slope_T: slope of the tip section, components y and z in F_i */
    const six_link_real minus_slope_T_1 = eta[3] * SIX_LINK_REAL(21.453696215957475) / c->length
        + eta[2] * SIX_LINK_REAL(2.7818912044528052) / c->length;
    const six_link_real slope_T_2 = eta[1] * SIX_LINK_REAL(21.453696215957475) / c->length
        + eta[0] * SIX_LINK_REAL(2.7818912044528052) / c->length;

    /* slope_2: its square */
    const six_link_real slope_2 = minus_slope_T_1 * minus_slope_T_1 + slope_T_2 * slope_T_2;

    /* slope: slope of the tip section */
    const six_link_real slope = six_link_sqrt(slope_2);
    measures[1] = slope;

    /* Omega_2: squared turn of the centreline */
    const six_link_real Omega_2 = motion[0] * motion[0] + motion[1] * motion[1];

    /* axial_load: axial load over buckling load, compression > 0 */
    const six_link_real axial_load = motion[2] * c->per_acceleration + c->per_force * (wrench[3] - motion[3]);
    measures[2] = axial_load;

    /* rotation: Omega^2 rhoA l^4 / EI */
    const six_link_real rotation = Omega_2 * c->per_turn;
    measures[3] = rotation;
    return SIX_LINK_OK;
}

/* measure, links like forearm: 33 operations */
SIX_LINK_PART six_link_status measure_forearm(const six_link_link_constants *restrict c,
    const six_link_real eta[restrict 4], const six_link_real motion[restrict 4], const six_link_real wrench[restrict 6],
    six_link_real measures[restrict 4])
{
    /* deflection_T: transverse displacement of the tip, components y and z in F_i */
    const six_link_real deflection_T_1 = eta[1] * SIX_LINK_REAL(2.8145226674626453)
        + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real deflection_T_2 = eta[3] * SIX_LINK_REAL(2.8145226674626453)
        + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* deflection_2: its square */
    const six_link_real deflection_2 = deflection_T_1 * deflection_T_1 + deflection_T_2 * deflection_T_2;

    /* deflection: transverse displacement of the tip over length */
    const six_link_real deflection = six_link_sqrt(deflection_2) / c->length;
    measures[0] = deflection;

    /* slope_T: slope of the tip section, components y and z in F_i */
    const six_link_real minus_slope_T_1 = eta[3] * SIX_LINK_REAL(21.453696215957475) / c->length
        + eta[2] * SIX_LINK_REAL(2.7818912044528052) / c->length;
    const six_link_real slope_T_2 = eta[1] * SIX_LINK_REAL(21.453696215957475) / c->length
        + eta[0] * SIX_LINK_REAL(2.7818912044528052) / c->length;

    /* slope_2: its square */
    const six_link_real slope_2 = minus_slope_T_1 * minus_slope_T_1 + slope_T_2 * slope_T_2;

    /* slope: slope of the tip section */
    const six_link_real slope = six_link_sqrt(slope_2);
    measures[1] = slope;

    /* Omega_2: squared turn of the centreline */
    const six_link_real Omega_2 = motion[0] * motion[0] + motion[1] * motion[1];

    /* axial_load: axial load over buckling load, compression > 0 */
    const six_link_real axial_load = motion[2] * c->per_acceleration + c->per_force * (wrench[3] - motion[3]);
    measures[2] = axial_load;

    /* rotation: Omega^2 rhoA l^4 / EI */
    const six_link_real rotation = Omega_2 * c->per_turn;
    measures[3] = rotation;
    return SIX_LINK_OK;
}

/* joint rows, links like shoulder: 165 operations */
SIX_LINK_PART six_link_status joint_rows_shoulder(const six_link_link_constants *c, six_link_link_store *link,
    six_link_node *tip, const six_link_real twist[6], const six_link_real quaternion[4], const six_link_real gravity[3],
    const six_link_real tau[1], six_link_real joint_H[6], six_link_real joint_W[6], const int *place, six_link_real *M)
{
    const six_link_real t1 = quaternion[1] * quaternion[1];
    const six_link_real t2 = quaternion[2] * quaternion[2];
    const six_link_real t3 = quaternion[3] * quaternion[3];
    const six_link_real t4 = 2 / (quaternion[0] * quaternion[0] + t1 + t2 + t3);
    const six_link_real t5 = t1 + t2 + t3;
    const six_link_real t6 = quaternion[1] * quaternion[2];
    const six_link_real t7 = quaternion[1] * quaternion[3];
    const six_link_real t8 = quaternion[2] * quaternion[3];
    const six_link_real t9 = quaternion[0] * quaternion[3];
    const six_link_real t10 = quaternion[0] * quaternion[2];
    const six_link_real t11 = quaternion[0] * quaternion[1];
    const six_link_real t12 = (1 + t4 * (t1 - t5)) * gravity[0] + t4 * (t9 + t6) * gravity[1]
        + t4 * (t7 - t10) * gravity[2];
    const six_link_real t13 = t4 * (t6 - t9) * gravity[0] + (1 + t4 * (t2 - t5)) * gravity[1]
        + t4 * (t11 + t8) * gravity[2];
    const six_link_real t14 = t4 * (t10 + t7) * gravity[0] + t4 * (t8 - t11) * gravity[1]
        + (1 + t4 * (t3 - t5)) * gravity[2];

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t12 - twist[2] * twist[4];
    const six_link_real t15 = twist[2] * twist[3] - t13;
    const six_link_real a_0_y = t15 - twist[0] * twist[5];
    const six_link_real t16 = twist[1] * twist[3];
    const six_link_real a_0_z = twist[0] * twist[4] - t14 - t16;

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t17 = c->I_s * twist[0];
    const six_link_real H_star_tau_y = t17 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_tau_z = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t17 * twist[1];
    const six_link_real H_star_f_x = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_f_z = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_x = twist[1] * v_T_z - t12 - twist[2] * v_T_y;
    const six_link_real a_T_y = t15 - twist[0] * v_T_z;
    const six_link_real a_T_z = twist[0] * v_T_y - t14 - t16;

    /* h_T_tau: bias moment of the tip bodies, weight included */
    const six_link_real t18 = c->I_T_zz * twist[2] - c->J_T_xz * twist[0] - c->J_T_yz * twist[1];
    const six_link_real t19 = c->I_T_yy * twist[1] - c->J_T_xy * twist[0] - c->J_T_yz * twist[2];
    const six_link_real h_T_tau_x = c->S_T_y * a_T_z + twist[1] * t18 - c->S_T_z * a_T_y - twist[2] * t19;
    const six_link_real t20 = c->I_T_xx * twist[0] - c->J_T_xy * twist[1] - c->J_T_xz * twist[2];
    const six_link_real h_T_tau_y = c->S_T_z * a_T_x + twist[2] * t20 - c->S_T_x * a_T_z - twist[0] * t18;
    const six_link_real h_T_tau_z = c->S_T_x * a_T_y + twist[0] * t19 - c->S_T_y * a_T_x - twist[1] * t20;

    /* h_T_F: bias force of the tip bodies, weight included */
    const six_link_real t21 = c->S_T_y * twist[0] - c->S_T_x * twist[1];
    const six_link_real t22 = c->S_T_x * twist[2] - c->S_T_z * twist[0];
    const six_link_real h_T_F_x = a_T_x * c->body0_mass + twist[1] * t21 - twist[2] * t22;
    const six_link_real t23 = c->S_T_z * twist[1] - c->S_T_y * twist[2];
    const six_link_real h_T_F_y = a_T_y * c->body0_mass + twist[2] * t23 - twist[0] * t21;
    const six_link_real h_T_F_z = a_T_z * c->body0_mass + twist[0] * t22 - twist[1] * t23;

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_33 = 1 + c->armature_1 - 1;

    /* joint_H: bias of the joint's rows, springs and dampers included (61) */
    const six_link_real joint_H_3 = c->joint_damping_1 * twist[2];

    /* outputs */
    link->h_V[0] = H_star_tau_y;
    link->h_V[1] = H_star_tau_z;
    link->h_V[2] = H_star_f_x;
    link->h_V[3] = H_star_f_y;
    link->h_V[4] = H_star_f_z;
    tip->omega_T[0] = twist[0];
    tip->omega_T[1] = twist[1];
    tip->omega_T[2] = twist[2];
    tip->v_T[0] = twist[3];
    tip->v_T[2] = v_T_z;
    link->h_T[0] = h_T_tau_x;
    link->h_T[1] = h_T_tau_y;
    link->h_T[2] = h_T_tau_z;
    link->h_T[3] = h_T_F_x;
    link->h_T[4] = h_T_F_y;
    link->h_T[5] = h_T_F_z;
    M[place[0]] = 1;
    M[place[1]] = 1;
    M[place[2]] = 1;
    M[place[3]] = P_c_33;
    M[place[4]] = 1;
    M[place[5]] = 1;
    M[place[6]] = 1;
    joint_H[0] = 0;
    joint_H[1] = 0;
    joint_H[2] = joint_H_3;
    joint_H[3] = 0;
    joint_H[4] = 0;
    joint_H[5] = 0;
    joint_W[0] = 0;
    joint_W[1] = 0;
    joint_W[2] = tau[0];
    joint_W[3] = 0;
    joint_W[4] = 0;
    joint_W[5] = 0;
    return SIX_LINK_OK;
}

/* joint rows, links like upper_arm: 660 operations */
SIX_LINK_PART six_link_status joint_rows_upper_arm(const six_link_link_constants *c, six_link_link_store *link,
    six_link_node *base, six_link_node *tip, const six_link_real twist[6], const six_link_real q[1],
    const six_link_real quaternion[4], const six_link_real gravity[3], const six_link_real eta[5],
    const six_link_real etadot[5], const six_link_real tau[1], six_link_real joint_H[6], six_link_real joint_W[6],
    const int *place, six_link_real *M)
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;
    const six_link_real t1 = -R_rel_xz;

    const six_link_real omega_R_x = R_rel_xx * base->omega_T[0] - R_rel_xz * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega_T[0] + R_rel_xx * base->omega_T[2];
    const six_link_real t2 = twist[1] - base->omega_T[1];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real t3 = base->v_T[0] + c->mount_xyz_z * base->omega_T[1] - c->mount_xyz_y * base->omega_T[2];
    const six_link_real t4 = base->v_T[2] + c->mount_xyz_y * base->omega_T[0] - c->mount_xyz_x * base->omega_T[1];
    const six_link_real v_R_x = R_rel_xx * t3 - R_rel_xz * t4;
    const six_link_real v_R_z = R_rel_xz * t3 + R_rel_xx * t4;

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real joint_H_1 = omega_R_z * t2;
    const six_link_real beta_omega_z = omega_R_x * t2;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real joint_H_4 = t2 * v_R_z;
    const six_link_real beta_v_z = t2 * v_R_x;

    const six_link_real t5 = quaternion[1] * quaternion[1];
    const six_link_real t6 = quaternion[2] * quaternion[2];
    const six_link_real t7 = quaternion[3] * quaternion[3];
    const six_link_real t8 = 2 / (quaternion[0] * quaternion[0] + t5 + t6 + t7);
    const six_link_real t9 = t5 + t6 + t7;
    const six_link_real t10 = quaternion[1] * quaternion[2];
    const six_link_real t11 = quaternion[1] * quaternion[3];
    const six_link_real t12 = quaternion[2] * quaternion[3];
    const six_link_real t13 = quaternion[0] * quaternion[3];
    const six_link_real t14 = quaternion[0] * quaternion[2];
    const six_link_real t15 = quaternion[0] * quaternion[1];
    const six_link_real t16 = (1 + t8 * (t5 - t9)) * gravity[0] + t8 * (t13 + t10) * gravity[1]
        + t8 * (t11 - t14) * gravity[2];
    const six_link_real t17 = t8 * (t10 - t13) * gravity[0] + (1 + t8 * (t6 - t9)) * gravity[1]
        + t8 * (t15 + t12) * gravity[2];
    const six_link_real t18 = t8 * (t14 + t11) * gravity[0] + t8 * (t12 - t15) * gravity[1]
        + (1 + t8 * (t7 - t9)) * gravity[2];

    /* S: first moment */
    const six_link_real S_y = eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2;
    const six_link_real S_z = eta[2] * c->sigma_y1 + eta[3] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const six_link_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2;
    const six_link_real Sdot_z = etadot[2] * c->sigma_y1 + etadot[3] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->mu * eta[0];
    const six_link_real L_y2 = c->mu * eta[1];
    const six_link_real L_z1 = eta[2] * c->mu;
    const six_link_real L_z2 = eta[3] * c->mu;

    /* Ldot: rate of L */
    const six_link_real Ldot_y1 = c->mu * etadot[0];
    const six_link_real Ldot_y2 = c->mu * etadot[1];
    const six_link_real Ldot_z1 = etadot[2] * c->mu;
    const six_link_real Ldot_z2 = etadot[3] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->chi_1 * eta[0] + c->chi_2 * eta[1];
    const six_link_real J_xz = c->chi_1 * eta[2] + c->chi_2 * eta[3];
    const six_link_real J_yy = L_y1 * eta[0] + L_y2 * eta[1];
    const six_link_real J_yz = L_z1 * eta[0] + L_z2 * eta[1];
    const six_link_real J_zz = L_z1 * eta[2] + L_z2 * eta[3];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t16 - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - t17 - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - t18 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real t19 = twist[1] * twist[1];
    const six_link_real t20 = twist[2] * twist[2];
    const six_link_real minus_Omega_xx = t19 + t20;
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];
    const six_link_real t21 = twist[0] * twist[0];
    const six_link_real minus_Omega_yy = t21 + t20;
    const six_link_real Omega_yz = twist[1] * twist[2];
    const six_link_real minus_Omega_zz = t21 + t19;

    /* B: moment of the elastic velocity */
    const six_link_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1];
    const six_link_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1];
    const six_link_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1];
    const six_link_real B_zx = c->chi_1 * etadot[2] + c->chi_2 * etadot[3];
    const six_link_real B_zy = L_y1 * etadot[2] + L_y2 * etadot[3];
    const six_link_real B_zz = L_z1 * etadot[2] + L_z2 * etadot[3];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const six_link_real h_c_tau_x = B_yy * twist[0] + B_zz * twist[0];
    const six_link_real h_c_tau_y = B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const six_link_real h_c_tau_z = B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const six_link_real h_c_f_x = Sdot_z * twist[1] - Sdot_y * twist[2];
    const six_link_real minus_h_c_f_y = Sdot_z * twist[0];
    const six_link_real h_c_f_z = Sdot_y * twist[0];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const six_link_real h_MD_tau_y = h_c_tau_y + etadot[4] * twist[2] * c->sigma_t_5;
    const six_link_real h_MD_tau_z = h_c_tau_z - etadot[4] * twist[1] * c->sigma_t_5;

    /* H_star: gyroscopic wrench and weight, with half of the Coriolis wrench (29) */
    const six_link_real t22 = h_c_tau_x + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const six_link_real H_star_tau_x = t22 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const six_link_real t23 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const six_link_real t24 = c->I_s * twist[0];
    const six_link_real H_star_tau_y = t23 + t24 * twist[2] - c->J_0_xx * Omega_xz - J_xy * Omega_yz - c->S_0_x * a_0_z;
    const six_link_real t25 = h_c_tau_z + c->J_0_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * a_0_y;
    const six_link_real H_star_tau_z = t25 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t24 * twist[1];
    const six_link_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + a_0_x * c->mu;
    const six_link_real H_star_f_y = Omega_xy * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + a_0_y * c->mu;
    const six_link_real H_star_f_z = h_c_f_z + Omega_xz * c->S_0_x + Omega_yz * S_y - minus_Omega_zz * S_z
        + a_0_z * c->mu;

    /* h_V: bias of the twist rows */
    const six_link_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const six_link_real h_V_tau_y = H_star_tau_y + h_MD_tau_y;
    const six_link_real h_V_tau_z = H_star_tau_z + h_MD_tau_z;
    const six_link_real h_V_f_x = H_star_f_x + h_c_f_x;
    const six_link_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const six_link_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const six_link_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_xy * c->chi_1 + a_0_y * c->sigma_y1
        - Ldot_z1 * 2 * twist[0];
    const six_link_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_xy * c->chi_2 + a_0_y * c->sigma_y2
        - Ldot_z2 * 2 * twist[0];
    const six_link_real h_eta_3 = L_y1 * Omega_yz - L_z1 * minus_Omega_zz + Omega_xz * c->chi_1 + a_0_z * c->sigma_y1
        + Ldot_y1 * 2 * twist[0];
    const six_link_real h_eta_4 = L_y2 * Omega_yz - L_z2 * minus_Omega_zz + Omega_xz * c->chi_2 + a_0_z * c->sigma_y2
        + Ldot_y2 * 2 * twist[0];

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real t26 = theta_x * theta_x;
    const six_link_real t27 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t26 + t27;
    const six_link_real t28 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t28;

    /* c1: Stumpff function of order 1 */
    const six_link_real t29 = six_link_c5(x);
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * t29;
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real t30 = six_link_c4(x);
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * t30;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t27 + t28;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t26 + t28;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    const six_link_real t31 = c3 * theta_hat2_12;
    const six_link_real t32 = c2 * theta_z;
    const six_link_real J_l_xy = t31 - t32;
    const six_link_real t33 = c2 * theta_y;
    const six_link_real t34 = c3 * theta_hat2_13;
    const six_link_real J_l_xz = t33 + t34;
    const six_link_real J_l_yx = t32 + t31;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const six_link_real t35 = c3 * theta_hat2_23;
    const six_link_real t36 = c2 * theta_x;
    const six_link_real J_l_yz = t35 - t36;
    const six_link_real J_l_zx = t34 - t33;
    const six_link_real J_l_zy = t36 + t35;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t37 = c2 * theta_hat2_12;
    const six_link_real t38 = c1 * theta_z;
    const six_link_real R_T_xy = t37 - t38;
    const six_link_real t39 = c1 * theta_y;
    const six_link_real t40 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t39 + t40;
    const six_link_real R_T_yx = t38 + t37;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t41 = c2 * theta_hat2_23;
    const six_link_real t42 = c1 * theta_x;
    const six_link_real R_T_yz = t41 - t42;
    const six_link_real R_T_zx = t40 - t39;
    const six_link_real R_T_zy = t42 + t41;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_x = etadot[4] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t43 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real t44 = theta_x * thetadot_y - theta_y * thetadot_x;
    const six_link_real t45 = theta_z * thetadot_x - theta_x * thetadot_z;
    const six_link_real t46 = theta_y * t44 - theta_z * t45;
    const six_link_real omega_s_x = thetadot_x + c2 * t43 + c3 * t46;
    const six_link_real t47 = theta_z * t43 - theta_x * t44;
    const six_link_real omega_s_y = thetadot_y + c2 * t45 + c3 * t47;
    const six_link_real t48 = theta_x * t45 - theta_y * t43;
    const six_link_real omega_s_z = thetadot_z + c2 * t44 + c3 * t48;

    /* xdot: rate of the squared angle */
    const six_link_real xdot = eta[4] * SIX_LINK_REAL(3.4641016151377544) * thetadot_x + theta_y * 2 * thetadot_y
        + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const six_link_real c2dot = xdot * (t30 - c3 * SIX_LINK_REAL(0.5));

    /* c3dot: rate of c3 */
    const six_link_real c3dot = xdot * (t29 * SIX_LINK_REAL(1.5) - t30 * SIX_LINK_REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_x = c2dot * t43 + c3 * (thetadot_y * t44 - thetadot_z * t45) + c3dot * t46;
    const six_link_real alpha_s_y = c2dot * t45 + c3 * (thetadot_z * t43 - thetadot_x * t44) + c3dot * t47;
    const six_link_real alpha_s_z = c2dot * t44 + c3 * (thetadot_x * t45 - thetadot_y * t43) + c3dot * t48;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t49 = omega_s_x + twist[0];
    const six_link_real t50 = omega_s_y + twist[1];
    const six_link_real t51 = omega_s_z + twist[2];
    const six_link_real omega_T_x = R_T_xx * t49 + R_T_yx * t50 + R_T_zx * t51;
    const six_link_real omega_T_y = R_T_xy * t49 + R_T_yy * t50 + R_T_zy * t51;
    const six_link_real omega_T_z = R_T_xz * t49 + R_T_yz * t50 + R_T_zz * t51;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t52 = twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const six_link_real t53 = udot_T_y + twist[4] + c->length * twist[2] - twist[0] * r_T_z;
    const six_link_real t54 = udot_T_z + twist[5] + twist[0] * r_T_y - c->length * twist[1];
    const six_link_real v_T_x = R_T_xx * t52 + R_T_yx * t53 + R_T_zx * t54;
    const six_link_real v_T_y = R_T_xy * t52 + R_T_yy * t53 + R_T_zy * t54;
    const six_link_real v_T_z = R_T_xz * t52 + R_T_yz * t53 + R_T_zz * t54;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const six_link_real t55 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const six_link_real t56 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const six_link_real t57 = alpha_s_z + omega_s_y * twist[0] - omega_s_x * twist[1];
    const six_link_real b_omega_x = R_T_xx * t55 + R_T_yx * t56 + R_T_zx * t57;
    const six_link_real b_omega_y = R_T_xy * t55 + R_T_yy * t56 + R_T_zy * t57;
    const six_link_real b_omega_z = R_T_xz * t55 + R_T_yz * t56 + R_T_zz * t57;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const six_link_real t58 = omega_s_z * t53 + twist[1] * udot_T_z - omega_s_y * t54 - twist[2] * udot_T_y;
    const six_link_real t59 = omega_s_x * t54 - omega_s_z * t52 - twist[0] * udot_T_z;
    const six_link_real t60 = omega_s_y * t52 + twist[0] * udot_T_y - omega_s_x * t53;
    const six_link_real b_v_x = R_T_xx * t58 + R_T_yx * t59 + R_T_zx * t60;
    const six_link_real b_v_y = R_T_xy * t58 + R_T_yy * t59 + R_T_zy * t60;
    const six_link_real b_v_z = R_T_xz * t58 + R_T_yz * t59 + R_T_zz * t60;

    const six_link_real t61 = R_T_xx * t16 + R_T_yx * t17 + R_T_zx * t18;
    const six_link_real t62 = R_T_xy * t16 + R_T_yy * t17 + R_T_zy * t18;
    const six_link_real t63 = R_T_xz * t16 + R_T_yz * t17 + R_T_zz * t18;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_x = omega_T_y * v_T_z - t61 - omega_T_z * v_T_y;
    const six_link_real a_T_y = omega_T_z * v_T_x - t62 - omega_T_x * v_T_z;
    const six_link_real a_T_z = omega_T_x * v_T_y - t63 - omega_T_y * v_T_x;

    /* h_T_tau: bias moment of the tip bodies, weight included */
    const six_link_real t64 = c->I_T_zz * omega_T_z - c->J_T_xz * omega_T_x - c->J_T_yz * omega_T_y;
    const six_link_real t65 = c->I_T_yy * omega_T_y - c->J_T_xy * omega_T_x - c->J_T_yz * omega_T_z;
    const six_link_real h_T_tau_x = c->S_T_y * a_T_z + omega_T_y * t64 - c->S_T_z * a_T_y - omega_T_z * t65;
    const six_link_real t66 = c->I_T_xx * omega_T_x - c->J_T_xy * omega_T_y - c->J_T_xz * omega_T_z;
    const six_link_real h_T_tau_y = c->S_T_z * a_T_x + omega_T_z * t66 - c->S_T_x * a_T_z - omega_T_x * t64;
    const six_link_real h_T_tau_z = c->S_T_x * a_T_y + omega_T_x * t65 - c->S_T_y * a_T_x - omega_T_y * t66;

    /* h_T_F: bias force of the tip bodies, weight included */
    const six_link_real t67 = c->S_T_y * omega_T_x - c->S_T_x * omega_T_y;
    const six_link_real t68 = c->S_T_x * omega_T_z - c->S_T_z * omega_T_x;
    const six_link_real h_T_F_x = a_T_x * c->body0_mass + omega_T_y * t67 - omega_T_z * t68;
    const six_link_real t69 = c->S_T_z * omega_T_y - c->S_T_y * omega_T_z;
    const six_link_real h_T_F_y = a_T_y * c->body0_mass + omega_T_z * t69 - omega_T_x * t67;
    const six_link_real h_T_F_z = a_T_z * c->body0_mass + omega_T_x * t68 - omega_T_y * t69;

    /* X: twist of the joint point in F_i axes from the parent's tip twist (49) */
    const six_link_real X_41 = -(R_rel_xz * c->mount_xyz_y);
    const six_link_real X_42 = R_rel_xx * c->mount_xyz_z + R_rel_xz * c->mount_xyz_x;
    const six_link_real X_61 = R_rel_xx * c->mount_xyz_y;
    const six_link_real t70 = -X_61;
    const six_link_real t71 = -c->mount_xyz_z;
    const six_link_real X_62 = R_rel_xz * c->mount_xyz_z - R_rel_xx * c->mount_xyz_x;

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_22 = 1 + c->armature_1 - 1;

    /* joint_H: bias of the joint's rows, springs and dampers included (61) */
    const six_link_real joint_H_2 = c->joint_damping_1 * t2;
    const six_link_real t72 = -beta_omega_z;
    const six_link_real t73 = -beta_v_z;

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
    link->M_D[2] = L_y1;
    link->M_D[3] = L_y2;
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
    link->b_T[0] = b_omega_x;
    link->b_T[1] = b_omega_y;
    link->b_T[2] = b_omega_z;
    link->b_T[3] = b_v_x;
    link->b_T[4] = b_v_y;
    link->b_T[5] = b_v_z;
    tip->omega_T[0] = omega_T_x;
    tip->omega_T[1] = omega_T_y;
    tip->omega_T[2] = omega_T_z;
    tip->v_T[0] = v_T_x;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    link->h_T[0] = h_T_tau_x;
    link->h_T[1] = h_T_tau_y;
    link->h_T[2] = h_T_tau_z;
    link->h_T[3] = h_T_F_x;
    link->h_T[4] = h_T_F_y;
    link->h_T[5] = h_T_F_z;
    M[place[0]] = 1;
    M[place[1]] = 1;
    M[place[2]] = P_c_22;
    M[place[3]] = 1;
    M[place[4]] = 1;
    M[place[5]] = 1;
    M[place[6]] = 1;
    joint_H[0] = joint_H_1;
    joint_H[1] = joint_H_2;
    joint_H[2] = t72;
    joint_H[3] = joint_H_4;
    joint_H[4] = 0;
    joint_H[5] = t73;
    joint_W[0] = 0;
    joint_W[1] = tau[0];
    joint_W[2] = 0;
    joint_W[3] = 0;
    joint_W[4] = 0;
    joint_W[5] = 0;
    base->X[0] = R_rel_xx;
    base->X[2] = t1;
    base->X[12] = R_rel_xz;
    base->X[14] = R_rel_xx;
    base->X[18] = X_41;
    base->X[19] = X_42;
    base->X[20] = t70;
    base->X[21] = R_rel_xx;
    base->X[23] = t1;
    base->X[24] = t71;
    base->X[26] = c->mount_xyz_x;
    base->X[30] = X_61;
    base->X[31] = X_62;
    base->X[32] = X_41;
    base->X[33] = R_rel_xz;
    base->X[35] = R_rel_xx;
    base->PX[0] = R_rel_xx;
    base->PX[2] = t1;
    base->PX[7] = P_c_22;
    base->PX[12] = R_rel_xz;
    base->PX[14] = R_rel_xx;
    base->PX[18] = X_41;
    base->PX[19] = X_42;
    base->PX[20] = t70;
    base->PX[21] = R_rel_xx;
    base->PX[23] = t1;
    base->PX[24] = t71;
    base->PX[26] = c->mount_xyz_x;
    base->PX[30] = X_61;
    base->PX[31] = X_62;
    base->PX[32] = X_41;
    base->PX[33] = R_rel_xz;
    base->PX[35] = R_rel_xx;
    tip->b[0] = b_omega_x;
    tip->b[1] = b_omega_y;
    tip->b[2] = b_omega_z;
    tip->b[3] = b_v_x;
    tip->b[4] = b_v_y;
    tip->b[5] = b_v_z;
    return SIX_LINK_OK;
}

/* joint rows, links like forearm: 612 operations */
SIX_LINK_PART six_link_status joint_rows_forearm(const six_link_link_constants *c, six_link_link_store *link,
    six_link_node *base, six_link_node *tip, const six_link_real twist[6], const six_link_real q[1],
    const six_link_real quaternion[4], const six_link_real gravity[3], const six_link_real eta[4],
    const six_link_real etadot[4], const six_link_real tau[1], six_link_real joint_H[6], six_link_real joint_W[6],
    const int *place, six_link_real *M)
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real t1 = turn.sine, t2 = turn.cosine;
    const six_link_real R_rel_xx = c->R_m_xx * t2 - c->R_m_xz * t1;
    const six_link_real R_rel_xz = c->R_m_xx * t1 + c->R_m_xz * t2;
    const six_link_real R_rel_yx = c->R_m_yx * t2 - c->R_m_yz * t1;
    const six_link_real R_rel_yz = c->R_m_yx * t1 + c->R_m_yz * t2;
    const six_link_real R_rel_zx = c->R_m_zx * t2 - c->R_m_zz * t1;
    const six_link_real R_rel_zz = c->R_m_zx * t1 + c->R_m_zz * t2;

    const six_link_real omega_R_x = R_rel_xx * base->omega_T[0] + R_rel_yx * base->omega_T[1]
        + R_rel_zx * base->omega_T[2];
    const six_link_real omega_R_y = c->R_m_xy * base->omega_T[0] + c->R_m_yy * base->omega_T[1]
        + c->R_m_zy * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega_T[0] + R_rel_yz * base->omega_T[1]
        + R_rel_zz * base->omega_T[2];
    const six_link_real t3 = twist[1] - omega_R_y;

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real t4 = base->v_T[0] + c->mount_xyz_z * base->omega_T[1] - c->mount_xyz_y * base->omega_T[2];
    const six_link_real t5 = base->v_T[1] + c->mount_xyz_x * base->omega_T[2] - c->mount_xyz_z * base->omega_T[0];
    const six_link_real t6 = base->v_T[2] + c->mount_xyz_y * base->omega_T[0] - c->mount_xyz_x * base->omega_T[1];
    const six_link_real v_R_x = R_rel_xx * t4 + R_rel_yx * t5 + R_rel_zx * t6;
    const six_link_real v_R_z = R_rel_xz * t4 + R_rel_yz * t5 + R_rel_zz * t6;

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_omega_x = omega_R_z * t3;
    const six_link_real beta_omega_z = omega_R_x * t3;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_v_x = t3 * v_R_z;
    const six_link_real beta_v_z = t3 * v_R_x;

    const six_link_real t7 = quaternion[1] * quaternion[1];
    const six_link_real t8 = quaternion[2] * quaternion[2];
    const six_link_real t9 = quaternion[3] * quaternion[3];
    const six_link_real t10 = 2 / (quaternion[0] * quaternion[0] + t7 + t8 + t9);
    const six_link_real t11 = t7 + t8 + t9;
    const six_link_real t12 = quaternion[1] * quaternion[2];
    const six_link_real t13 = quaternion[1] * quaternion[3];
    const six_link_real t14 = quaternion[2] * quaternion[3];
    const six_link_real t15 = quaternion[0] * quaternion[3];
    const six_link_real t16 = quaternion[0] * quaternion[2];
    const six_link_real t17 = quaternion[0] * quaternion[1];
    const six_link_real t18 = (1 + t10 * (t7 - t11)) * gravity[0] + t10 * (t15 + t12) * gravity[1]
        + t10 * (t13 - t16) * gravity[2];
    const six_link_real t19 = t10 * (t12 - t15) * gravity[0] + (1 + t10 * (t8 - t11)) * gravity[1]
        + t10 * (t17 + t14) * gravity[2];
    const six_link_real t20 = t10 * (t16 + t13) * gravity[0] + t10 * (t14 - t17) * gravity[1]
        + (1 + t10 * (t9 - t11)) * gravity[2];

    /* S: first moment */
    const six_link_real S_y = c->S_B_y + eta[0] * c->sigma_y1 + eta[1] * c->sigma_y2;
    const six_link_real S_z = c->S_B_z + eta[2] * c->sigma_y1 + eta[3] * c->sigma_y2;

    /* Sdot: rate of the first moment */
    const six_link_real Sdot_y = etadot[0] * c->sigma_y1 + etadot[1] * c->sigma_y2;
    const six_link_real Sdot_z = etadot[2] * c->sigma_y1 + etadot[3] * c->sigma_y2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->mu * eta[0];
    const six_link_real L_y2 = c->mu * eta[1];
    const six_link_real L_z1 = eta[2] * c->mu;
    const six_link_real L_z2 = eta[3] * c->mu;

    /* Ldot: rate of L */
    const six_link_real Ldot_y1 = c->mu * etadot[0];
    const six_link_real Ldot_y2 = c->mu * etadot[1];
    const six_link_real Ldot_z1 = etadot[2] * c->mu;
    const six_link_real Ldot_z2 = etadot[3] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->J_B_xy + c->chi_1 * eta[0] + c->chi_2 * eta[1];
    const six_link_real J_xz = c->J_B_xz + c->chi_1 * eta[2] + c->chi_2 * eta[3];
    const six_link_real J_yy = c->J_B_yy + L_y1 * eta[0] + L_y2 * eta[1];
    const six_link_real J_yz = c->J_B_yz + L_z1 * eta[0] + L_z2 * eta[1];
    const six_link_real J_zz = c->J_B_zz + L_z1 * eta[2] + L_z2 * eta[3];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t18 - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - t19 - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - t20 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real t21 = twist[1] * twist[1];
    const six_link_real t22 = twist[2] * twist[2];
    const six_link_real minus_Omega_xx = t21 + t22;
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];
    const six_link_real t23 = twist[0] * twist[0];
    const six_link_real minus_Omega_yy = t23 + t22;
    const six_link_real Omega_yz = twist[1] * twist[2];
    const six_link_real minus_Omega_zz = t23 + t21;

    /* B: moment of the elastic velocity */
    const six_link_real B_yx = c->chi_1 * etadot[0] + c->chi_2 * etadot[1];
    const six_link_real B_yy = L_y1 * etadot[0] + L_y2 * etadot[1];
    const six_link_real B_yz = L_z1 * etadot[0] + L_z2 * etadot[1];
    const six_link_real B_zx = c->chi_1 * etadot[2] + c->chi_2 * etadot[3];
    const six_link_real B_zy = L_y1 * etadot[2] + L_y2 * etadot[3];
    const six_link_real B_zz = L_z1 * etadot[2] + L_z2 * etadot[3];

    /* h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const six_link_real h_c_tau_x = B_yy * twist[0] + B_zz * twist[0];
    const six_link_real h_c_tau_y = B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const six_link_real h_c_tau_z = B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const six_link_real h_c_f_x = Sdot_z * twist[1] - Sdot_y * twist[2];
    const six_link_real minus_h_c_f_y = Sdot_z * twist[0];
    const six_link_real h_c_f_z = Sdot_y * twist[0];

    /* H_star: gyroscopic wrench and weight, with half of the Coriolis wrench (29) */
    const six_link_real t24 = h_c_tau_x + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const six_link_real H_star_tau_x = t24 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const six_link_real t25 = h_c_tau_y + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const six_link_real t26 = c->I_s * twist[0];
    const six_link_real H_star_tau_y = t25 + t26 * twist[2] - c->J_0_xx * Omega_xz - J_xy * Omega_yz - c->S_0_x * a_0_z;
    const six_link_real t27 = h_c_tau_z + c->J_0_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * a_0_y;
    const six_link_real H_star_tau_z = t27 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t26 * twist[1];
    const six_link_real H_star_f_x = h_c_f_x - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + a_0_x * c->m;
    const six_link_real H_star_f_y = Omega_xy * c->S_0_x - minus_h_c_f_y - minus_Omega_yy * S_y + Omega_yz * S_z
        + a_0_y * c->m;
    const six_link_real H_star_f_z = h_c_f_z + Omega_xz * c->S_0_x + Omega_yz * S_y - minus_Omega_zz * S_z
        + a_0_z * c->m;

    /* h_V: bias of the twist rows */
    const six_link_real h_V_tau_x = H_star_tau_x + h_c_tau_x;
    const six_link_real h_V_tau_y = H_star_tau_y + h_c_tau_y;
    const six_link_real h_V_tau_z = H_star_tau_z + h_c_tau_z;
    const six_link_real h_V_f_x = H_star_f_x + h_c_f_x;
    const six_link_real h_V_f_y = H_star_f_y - minus_h_c_f_y;
    const six_link_real h_V_f_z = H_star_f_z + h_c_f_z;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const six_link_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_xy * c->chi_1 + a_0_y * c->sigma_y1
        - Ldot_z1 * 2 * twist[0];
    const six_link_real h_eta_2 = L_z2 * Omega_yz - L_y2 * minus_Omega_yy + Omega_xy * c->chi_2 + a_0_y * c->sigma_y2
        - Ldot_z2 * 2 * twist[0];
    const six_link_real h_eta_3 = L_y1 * Omega_yz - L_z1 * minus_Omega_zz + Omega_xz * c->chi_1 + a_0_z * c->sigma_y1
        + Ldot_y1 * 2 * twist[0];
    const six_link_real h_eta_4 = L_y2 * Omega_yz - L_z2 * minus_Omega_zz + Omega_xz * c->chi_2 + a_0_z * c->sigma_y2
        + Ldot_y2 * 2 * twist[0];

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[1] * SIX_LINK_REAL(2.8145226674626453) + eta[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_z = eta[3] * SIX_LINK_REAL(2.8145226674626453) + eta[2] * SIX_LINK_REAL(2.0195202782688155);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y3 * eta[2] + c->Psi_c_y4 * eta[3];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0] + c->Psi_c_z2 * eta[1];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const six_link_real t28 = six_link_c5(x);
    const six_link_real c3 = SIX_LINK_REAL(0.16666666666666666) - x * t28;
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real t29 = six_link_c4(x);
    const six_link_real c2 = SIX_LINK_REAL(0.5) - x * t29;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real J_l_yx = c2 * theta_z;
    const six_link_real J_l_xz = c2 * theta_y;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const six_link_real J_l_yz = c3 * theta_hat2_23;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real R_T_yx = c1 * theta_z;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[1] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[0] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_z = etadot[3] * SIX_LINK_REAL(2.8145226674626453)
        + etadot[2] * SIX_LINK_REAL(2.0195202782688155);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_y = c->Psi_c_y3 * etadot[2] + c->Psi_c_y4 * etadot[3];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0] + c->Psi_c_z2 * etadot[1];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t30 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real omega_s_x = c2 * t30;
    const six_link_real omega_s_y = thetadot_y + c3 * theta_z * t30;
    const six_link_real omega_s_z = thetadot_z - c3 * theta_y * t30;

    /* xdot: rate of the squared angle */
    const six_link_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const six_link_real c2dot = xdot * (t29 - c3 * SIX_LINK_REAL(0.5));

    /* c3dot: rate of c3 */
    const six_link_real c3dot = xdot * (t28 * SIX_LINK_REAL(1.5) - t29 * SIX_LINK_REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_x = c2dot * t30;
    const six_link_real alpha_s_y = c3 * thetadot_z * t30 + c3dot * theta_z * t30;
    const six_link_real minus_alpha_s_z = c3 * thetadot_y * t30 + c3dot * theta_y * t30;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t31 = omega_s_x + twist[0];
    const six_link_real t32 = omega_s_y + twist[1];
    const six_link_real t33 = omega_s_z + twist[2];
    const six_link_real omega_T_x = R_T_xx * t31 + R_T_yx * t32 - R_T_xz * t33;
    const six_link_real omega_T_y = R_T_yy * t32 - R_T_yx * t31 + R_T_yz * t33;
    const six_link_real omega_T_z = R_T_xz * t31 + R_T_yz * t32 + R_T_zz * t33;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t34 = twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const six_link_real t35 = udot_T_y + twist[4] + c->length * twist[2] - twist[0] * r_T_z;
    const six_link_real t36 = udot_T_z + twist[5] + twist[0] * r_T_y - c->length * twist[1];
    const six_link_real v_T_y = R_T_yy * t35 - R_T_yx * t34 + R_T_yz * t36;
    const six_link_real v_T_z = R_T_xz * t34 + R_T_yz * t35 + R_T_zz * t36;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const six_link_real t37 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const six_link_real t38 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const six_link_real t39 = omega_s_y * twist[0] - minus_alpha_s_z - omega_s_x * twist[1];
    const six_link_real b_omega_x = R_T_xx * t37 + R_T_yx * t38 - R_T_xz * t39;
    const six_link_real b_omega_y = R_T_yy * t38 - R_T_yx * t37 + R_T_yz * t39;
    const six_link_real b_omega_z = R_T_xz * t37 + R_T_yz * t38 + R_T_zz * t39;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const six_link_real t40 = omega_s_z * t35 + twist[1] * udot_T_z - omega_s_y * t36 - twist[2] * udot_T_y;
    const six_link_real t41 = omega_s_x * t36 - omega_s_z * t34 - twist[0] * udot_T_z;
    const six_link_real t42 = omega_s_y * t34 + twist[0] * udot_T_y - omega_s_x * t35;
    const six_link_real b_v_x = R_T_xx * t40 + R_T_yx * t41 - R_T_xz * t42;
    const six_link_real b_v_y = R_T_yy * t41 - R_T_yx * t40 + R_T_yz * t42;
    const six_link_real b_v_z = R_T_xz * t40 + R_T_yz * t41 + R_T_zz * t42;

    /* X: twist of the joint point in F_i axes from the parent's tip twist (49) */
    const six_link_real X_41 = R_rel_zx * c->mount_xyz_y - R_rel_yx * c->mount_xyz_z;
    const six_link_real X_42 = R_rel_xx * c->mount_xyz_z - R_rel_zx * c->mount_xyz_x;
    const six_link_real X_43 = R_rel_yx * c->mount_xyz_x - R_rel_xx * c->mount_xyz_y;
    const six_link_real X_51 = c->R_m_zy * c->mount_xyz_y - c->R_m_yy * c->mount_xyz_z;
    const six_link_real X_52 = c->R_m_xy * c->mount_xyz_z - c->R_m_zy * c->mount_xyz_x;
    const six_link_real X_53 = c->R_m_yy * c->mount_xyz_x - c->R_m_xy * c->mount_xyz_y;
    const six_link_real X_61 = R_rel_zz * c->mount_xyz_y - R_rel_yz * c->mount_xyz_z;
    const six_link_real X_62 = R_rel_xz * c->mount_xyz_z - R_rel_zz * c->mount_xyz_x;
    const six_link_real X_63 = R_rel_yz * c->mount_xyz_x - R_rel_xz * c->mount_xyz_y;

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_22 = 1 + c->armature_1 - 1;

    /* PX: columns of the parent's tip, with a minus sign (59) */
    const six_link_real PX_21 = P_c_22 * c->R_m_xy;
    const six_link_real PX_22 = P_c_22 * c->R_m_yy;
    const six_link_real PX_23 = P_c_22 * c->R_m_zy;

    /* joint_H: bias of the joint's rows, springs and dampers included (61) */
    const six_link_real joint_H_1 = minus_beta_omega_x
        - (R_rel_xx * base->b[0] + R_rel_yx * base->b[1] + R_rel_zx * base->b[2]);
    const six_link_real joint_H_2 = c->joint_damping_1 * t3 - PX_21 * base->b[0] - PX_22 * base->b[1]
        - PX_23 * base->b[2];
    const six_link_real joint_H_3 = -(R_rel_xz * base->b[0] + R_rel_yz * base->b[1] + R_rel_zz * base->b[2]
        + beta_omega_z);
    const six_link_real t43 = minus_beta_v_x - R_rel_xx * base->b[3] - R_rel_yx * base->b[4] - R_rel_zx * base->b[5]
        - X_41 * base->b[0];
    const six_link_real joint_H_4 = t43 - X_42 * base->b[1] - X_43 * base->b[2];
    const six_link_real t44 = c->R_m_xy * base->b[3] + c->R_m_yy * base->b[4] + c->R_m_zy * base->b[5]
        + X_51 * base->b[0] + X_52 * base->b[1];
    const six_link_real joint_H_5 = -(t44 + X_53 * base->b[2]);
    const six_link_real t45 = beta_v_z + R_rel_xz * base->b[3] + R_rel_yz * base->b[4] + R_rel_zz * base->b[5]
        + X_61 * base->b[0];
    const six_link_real joint_H_6 = -(t45 + X_62 * base->b[1] + X_63 * base->b[2]);

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
    link->M_D[2] = L_y1;
    link->M_D[3] = L_y2;
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
    link->R_T[0] = R_T_xx;
    link->R_T[1] = R_T_yx;
    link->R_T[2] = R_T_xz;
    link->R_T[3] = R_T_yy;
    link->R_T[4] = R_T_yz;
    link->R_T[5] = R_T_zz;
    link->J_l[1] = J_l_yx;
    link->J_l[2] = J_l_xz;
    link->J_l[3] = J_l_yy;
    link->J_l[4] = J_l_yz;
    link->J_l[5] = J_l_zz;
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
    tip->omega_T[0] = omega_T_x;
    tip->omega_T[1] = omega_T_y;
    tip->omega_T[2] = omega_T_z;
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    M[place[0]] = 1;
    M[place[1]] = 1;
    M[place[2]] = P_c_22;
    M[place[3]] = 1;
    M[place[4]] = 1;
    M[place[5]] = 1;
    M[place[6]] = 1;
    joint_H[0] = joint_H_1;
    joint_H[1] = joint_H_2;
    joint_H[2] = joint_H_3;
    joint_H[3] = joint_H_4;
    joint_H[4] = joint_H_5;
    joint_H[5] = joint_H_6;
    joint_W[0] = 0;
    joint_W[1] = tau[0];
    joint_W[2] = 0;
    joint_W[3] = 0;
    joint_W[4] = 0;
    joint_W[5] = 0;
    base->X[0] = R_rel_xx;
    base->X[1] = R_rel_yx;
    base->X[2] = R_rel_zx;
    base->X[6] = c->R_m_xy;
    base->X[7] = c->R_m_yy;
    base->X[8] = c->R_m_zy;
    base->X[12] = R_rel_xz;
    base->X[13] = R_rel_yz;
    base->X[14] = R_rel_zz;
    base->X[18] = X_41;
    base->X[19] = X_42;
    base->X[20] = X_43;
    base->X[21] = R_rel_xx;
    base->X[22] = R_rel_yx;
    base->X[23] = R_rel_zx;
    base->X[24] = X_51;
    base->X[25] = X_52;
    base->X[26] = X_53;
    base->X[27] = c->R_m_xy;
    base->X[28] = c->R_m_yy;
    base->X[29] = c->R_m_zy;
    base->X[30] = X_61;
    base->X[31] = X_62;
    base->X[32] = X_63;
    base->X[33] = R_rel_xz;
    base->X[34] = R_rel_yz;
    base->X[35] = R_rel_zz;
    base->PX[0] = R_rel_xx;
    base->PX[1] = R_rel_yx;
    base->PX[2] = R_rel_zx;
    base->PX[6] = PX_21;
    base->PX[7] = PX_22;
    base->PX[8] = PX_23;
    base->PX[12] = R_rel_xz;
    base->PX[13] = R_rel_yz;
    base->PX[14] = R_rel_zz;
    base->PX[18] = X_41;
    base->PX[19] = X_42;
    base->PX[20] = X_43;
    base->PX[21] = R_rel_xx;
    base->PX[22] = R_rel_yx;
    base->PX[23] = R_rel_zx;
    base->PX[24] = X_51;
    base->PX[25] = X_52;
    base->PX[26] = X_53;
    base->PX[27] = c->R_m_xy;
    base->PX[28] = c->R_m_yy;
    base->PX[29] = c->R_m_zy;
    base->PX[30] = X_61;
    base->PX[31] = X_62;
    base->PX[32] = X_63;
    base->PX[33] = R_rel_xz;
    base->PX[34] = R_rel_yz;
    base->PX[35] = R_rel_zz;
    tip->b[0] = b_omega_x;
    tip->b[1] = b_omega_y;
    tip->b[2] = b_omega_z;
    tip->b[3] = b_v_x;
    tip->b[4] = b_v_y;
    tip->b[5] = b_v_z;
    return SIX_LINK_OK;
}

/* joint rows, links like wrist_roll: 135 operations */
SIX_LINK_PART six_link_status joint_rows_wrist_roll(const six_link_link_constants *c, six_link_link_store *link,
    six_link_node *base, six_link_node *tip, const six_link_real twist[6], const six_link_real q[1],
    const six_link_real quaternion[4], const six_link_real gravity[3], const six_link_real tau[1],
    six_link_real joint_H[6], six_link_real joint_W[6], const int *place, six_link_real *M)
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;
    const six_link_real t1 = -R_rel_zy;

    const six_link_real omega_R_y = R_rel_yy * base->omega_T[1] + R_rel_zy * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega_T[2] - R_rel_zy * base->omega_T[1];
    const six_link_real t2 = twist[0] - base->omega_T[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_y = R_rel_yy * base->v_T[1] + R_rel_zy * base->v_T[2];
    const six_link_real v_R_z = R_rel_yy * base->v_T[2] - R_rel_zy * base->v_T[1];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_omega_y = omega_R_z * t2;
    const six_link_real minus_beta_omega_z = omega_R_y * t2;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_v_y = t2 * v_R_z;
    const six_link_real minus_beta_v_z = t2 * v_R_y;

    const six_link_real t3 = quaternion[1] * quaternion[1];
    const six_link_real t4 = quaternion[2] * quaternion[2];
    const six_link_real t5 = quaternion[3] * quaternion[3];
    const six_link_real t6 = 2 / (quaternion[0] * quaternion[0] + t3 + t4 + t5);
    const six_link_real t7 = t3 + t4 + t5;
    const six_link_real t8 = quaternion[1] * quaternion[2];
    const six_link_real t9 = quaternion[1] * quaternion[3];
    const six_link_real t10 = quaternion[2] * quaternion[3];
    const six_link_real t11 = quaternion[0] * quaternion[3];
    const six_link_real t12 = quaternion[0] * quaternion[2];
    const six_link_real t13 = quaternion[0] * quaternion[1];
    const six_link_real t14 = (1 + t6 * (t3 - t7)) * gravity[0] + t6 * (t11 + t8) * gravity[1]
        + t6 * (t9 - t12) * gravity[2];
    const six_link_real t15 = t6 * (t8 - t11) * gravity[0] + (1 + t6 * (t4 - t7)) * gravity[1]
        + t6 * (t13 + t10) * gravity[2];
    const six_link_real t16 = t6 * (t12 + t9) * gravity[0] + t6 * (t10 - t13) * gravity[1]
        + (1 + t6 * (t5 - t7)) * gravity[2];

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t14 - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - t15 - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - t16 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t17 = c->I_s * twist[0];
    const six_link_real H_star_tau_y = t17 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_tau_z = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t17 * twist[1];
    const six_link_real H_star_f_x = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_f_z = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_11 = 1 + c->armature_1 - 1;

    /* joint_H: bias of the joint's rows, springs and dampers included (61) */
    const six_link_real joint_H_1 = c->joint_damping_1 * t2 - P_c_11 * base->b[0];
    const six_link_real joint_H_2 = -(R_rel_yy * base->b[1] + R_rel_zy * base->b[2] + beta_omega_y);
    const six_link_real joint_H_3 = R_rel_zy * base->b[1] - R_rel_yy * base->b[2] + minus_beta_omega_z;
    const six_link_real t18 = -base->b[3];
    const six_link_real joint_H_5 = -(beta_v_y + R_rel_yy * base->b[4] + R_rel_zy * base->b[5]);
    const six_link_real joint_H_6 = minus_beta_v_z + R_rel_zy * base->b[4] - R_rel_yy * base->b[5];

    /* outputs */
    link->h_V[0] = H_star_tau_y;
    link->h_V[1] = H_star_tau_z;
    link->h_V[2] = H_star_f_x;
    link->h_V[3] = H_star_f_y;
    link->h_V[4] = H_star_f_z;
    tip->omega_T[0] = twist[0];
    tip->omega_T[1] = twist[1];
    tip->omega_T[2] = twist[2];
    tip->v_T[0] = twist[3];
    tip->v_T[2] = v_T_z;
    M[place[0]] = 1;
    M[place[1]] = P_c_11;
    M[place[2]] = 1;
    M[place[3]] = 1;
    M[place[4]] = 1;
    M[place[5]] = 1;
    M[place[6]] = 1;
    joint_H[0] = joint_H_1;
    joint_H[1] = joint_H_2;
    joint_H[2] = joint_H_3;
    joint_H[3] = t18;
    joint_H[4] = joint_H_5;
    joint_H[5] = joint_H_6;
    joint_W[0] = tau[0];
    joint_W[1] = 0;
    joint_W[2] = 0;
    joint_W[3] = 0;
    joint_W[4] = 0;
    joint_W[5] = 0;
    base->X[7] = R_rel_yy;
    base->X[8] = R_rel_zy;
    base->X[13] = t1;
    base->X[14] = R_rel_yy;
    base->X[28] = R_rel_yy;
    base->X[29] = R_rel_zy;
    base->X[34] = t1;
    base->X[35] = R_rel_yy;
    base->PX[0] = P_c_11;
    base->PX[7] = R_rel_yy;
    base->PX[8] = R_rel_zy;
    base->PX[13] = t1;
    base->PX[14] = R_rel_yy;
    base->PX[28] = R_rel_yy;
    base->PX[29] = R_rel_zy;
    base->PX[34] = t1;
    base->PX[35] = R_rel_yy;
    return SIX_LINK_OK;
}

/* joint rows, links like wrist_pitch: 118 operations */
SIX_LINK_PART six_link_status joint_rows_wrist_pitch(const six_link_link_constants *c, six_link_link_store *link,
    six_link_node *base, six_link_node *tip, const six_link_real twist[6], const six_link_real q[1],
    const six_link_real quaternion[4], const six_link_real gravity[3], const six_link_real tau[1],
    six_link_real joint_H[6], six_link_real joint_W[6], const int *place, six_link_real *M)
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_xz = turn.sine, R_rel_xx = turn.cosine;
    const six_link_real t1 = -R_rel_xz;

    const six_link_real omega_R_x = R_rel_xx * base->omega_T[0] - R_rel_xz * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega_T[0] + R_rel_xx * base->omega_T[2];
    const six_link_real t2 = twist[1] - base->omega_T[1];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_x = R_rel_xx * base->v_T[0] - R_rel_xz * base->v_T[2];
    const six_link_real v_R_z = R_rel_xz * base->v_T[0] + R_rel_xx * base->v_T[2];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real joint_H_1 = omega_R_z * t2;
    const six_link_real beta_omega_z = omega_R_x * t2;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real joint_H_4 = t2 * v_R_z;
    const six_link_real beta_v_z = t2 * v_R_x;

    const six_link_real t3 = quaternion[1] * quaternion[1];
    const six_link_real t4 = quaternion[2] * quaternion[2];
    const six_link_real t5 = quaternion[3] * quaternion[3];
    const six_link_real t6 = 2 / (quaternion[0] * quaternion[0] + t3 + t4 + t5);
    const six_link_real t7 = t3 + t4 + t5;
    const six_link_real t8 = quaternion[1] * quaternion[2];
    const six_link_real t9 = quaternion[1] * quaternion[3];
    const six_link_real t10 = quaternion[2] * quaternion[3];
    const six_link_real t11 = quaternion[0] * quaternion[3];
    const six_link_real t12 = quaternion[0] * quaternion[2];
    const six_link_real t13 = quaternion[0] * quaternion[1];
    const six_link_real t14 = (1 + t6 * (t3 - t7)) * gravity[0] + t6 * (t11 + t8) * gravity[1]
        + t6 * (t9 - t12) * gravity[2];
    const six_link_real t15 = t6 * (t8 - t11) * gravity[0] + (1 + t6 * (t4 - t7)) * gravity[1]
        + t6 * (t13 + t10) * gravity[2];
    const six_link_real t16 = t6 * (t12 + t9) * gravity[0] + t6 * (t10 - t13) * gravity[1]
        + (1 + t6 * (t5 - t7)) * gravity[2];

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t14 - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - t15 - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - t16 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t17 = c->I_s * twist[0];
    const six_link_real H_star_tau_y = t17 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_tau_z = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t17 * twist[1];
    const six_link_real H_star_f_x = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_f_z = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_22 = 1 + c->armature_1 - 1;

    /* joint_H: bias of the joint's rows, springs and dampers included (61) */
    const six_link_real joint_H_2 = c->joint_damping_1 * t2;
    const six_link_real t18 = -beta_omega_z;
    const six_link_real t19 = -beta_v_z;

    /* outputs */
    link->h_V[0] = H_star_tau_y;
    link->h_V[1] = H_star_tau_z;
    link->h_V[2] = H_star_f_x;
    link->h_V[3] = H_star_f_y;
    link->h_V[4] = H_star_f_z;
    tip->omega_T[0] = twist[0];
    tip->omega_T[1] = twist[1];
    tip->omega_T[2] = twist[2];
    tip->v_T[1] = v_T_y;
    tip->v_T[2] = v_T_z;
    M[place[0]] = 1;
    M[place[1]] = 1;
    M[place[2]] = P_c_22;
    M[place[3]] = 1;
    M[place[4]] = 1;
    M[place[5]] = 1;
    M[place[6]] = 1;
    joint_H[0] = joint_H_1;
    joint_H[1] = joint_H_2;
    joint_H[2] = t18;
    joint_H[3] = joint_H_4;
    joint_H[4] = 0;
    joint_H[5] = t19;
    joint_W[0] = 0;
    joint_W[1] = tau[0];
    joint_W[2] = 0;
    joint_W[3] = 0;
    joint_W[4] = 0;
    joint_W[5] = 0;
    base->X[0] = R_rel_xx;
    base->X[2] = t1;
    base->X[12] = R_rel_xz;
    base->X[14] = R_rel_xx;
    base->X[21] = R_rel_xx;
    base->X[23] = t1;
    base->X[33] = R_rel_xz;
    base->X[35] = R_rel_xx;
    base->PX[0] = R_rel_xx;
    base->PX[2] = t1;
    base->PX[7] = P_c_22;
    base->PX[12] = R_rel_xz;
    base->PX[14] = R_rel_xx;
    base->PX[21] = R_rel_xx;
    base->PX[23] = t1;
    base->PX[33] = R_rel_xz;
    base->PX[35] = R_rel_xx;
    return SIX_LINK_OK;
}

/* joint rows, links like flange: 187 operations */
SIX_LINK_PART six_link_status joint_rows_flange(const six_link_link_constants *c, six_link_link_store *link,
    six_link_node *base, const six_link_real twist[6], const six_link_real q[1], const six_link_real quaternion[4],
    const six_link_real gravity[3], const six_link_real tau[1], six_link_real joint_H[6], six_link_real joint_W[6],
    const int *place, six_link_real *M)
{
    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(q[0]);
    const six_link_real R_rel_zy = turn.sine, R_rel_yy = turn.cosine;
    const six_link_real t1 = -R_rel_zy;

    const six_link_real omega_R_y = R_rel_yy * base->omega_T[1] + R_rel_zy * base->omega_T[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega_T[2] - R_rel_zy * base->omega_T[1];
    const six_link_real t2 = twist[0] - base->omega_T[0];

    /* v_R: velocity of the joint point, fixed to the parent */
    const six_link_real v_R_y = R_rel_yy * base->v_T[1] + R_rel_zy * base->v_T[2];
    const six_link_real v_R_z = R_rel_yy * base->v_T[2] - R_rel_zy * base->v_T[1];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_omega_y = omega_R_z * t2;
    const six_link_real joint_H_3 = omega_R_y * t2;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_v_y = t2 * v_R_z;
    const six_link_real joint_H_6 = t2 * v_R_y;

    const six_link_real t3 = quaternion[1] * quaternion[1];
    const six_link_real t4 = quaternion[2] * quaternion[2];
    const six_link_real t5 = quaternion[3] * quaternion[3];
    const six_link_real t6 = 2 / (quaternion[0] * quaternion[0] + t3 + t4 + t5);
    const six_link_real t7 = t3 + t4 + t5;
    const six_link_real t8 = quaternion[1] * quaternion[2];
    const six_link_real t9 = quaternion[1] * quaternion[3];
    const six_link_real t10 = quaternion[2] * quaternion[3];
    const six_link_real t11 = quaternion[0] * quaternion[3];
    const six_link_real t12 = quaternion[0] * quaternion[2];
    const six_link_real t13 = quaternion[0] * quaternion[1];
    const six_link_real t14 = (1 + t6 * (t3 - t7)) * gravity[0] + t6 * (t11 + t8) * gravity[1]
        + t6 * (t9 - t12) * gravity[2];
    const six_link_real t15 = t6 * (t8 - t11) * gravity[0] + (1 + t6 * (t4 - t7)) * gravity[1]
        + t6 * (t13 + t10) * gravity[2];
    const six_link_real t16 = t6 * (t12 + t9) * gravity[0] + t6 * (t10 - t13) * gravity[1]
        + (1 + t6 * (t5 - t7)) * gravity[2];

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t14 - twist[2] * twist[4];
    const six_link_real t17 = twist[2] * twist[3] - t15;
    const six_link_real a_0_y = t17 - twist[0] * twist[5];
    const six_link_real t18 = twist[1] * twist[3];
    const six_link_real a_0_z = twist[0] * twist[4] - t16 - t18;

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t19 = c->I_s * twist[0];
    const six_link_real H_star_tau_y = t19 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_tau_z = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t19 * twist[1];
    const six_link_real H_star_f_x = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_f_y = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_f_z = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_x = twist[1] * v_T_z - t14 - twist[2] * v_T_y;
    const six_link_real a_T_y = t17 - twist[0] * v_T_z;
    const six_link_real a_T_z = twist[0] * v_T_y - t16 - t18;

    /* h_T_tau: bias moment of the tip bodies, weight included */
    const six_link_real t20 = c->I_T_zz * twist[2] - c->J_T_xz * twist[0] - c->J_T_yz * twist[1];
    const six_link_real t21 = c->I_T_yy * twist[1] - c->J_T_xy * twist[0] - c->J_T_yz * twist[2];
    const six_link_real h_T_tau_x = c->S_T_y * a_T_z + twist[1] * t20 - c->S_T_z * a_T_y - twist[2] * t21;
    const six_link_real t22 = c->I_T_xx * twist[0] - c->J_T_xy * twist[1] - c->J_T_xz * twist[2];
    const six_link_real h_T_tau_y = c->S_T_z * a_T_x + twist[2] * t22 - c->S_T_x * a_T_z - twist[0] * t20;
    const six_link_real h_T_tau_z = c->S_T_x * a_T_y + twist[0] * t21 - c->S_T_y * a_T_x - twist[1] * t22;

    /* h_T_F: bias force of the tip bodies, weight included */
    const six_link_real t23 = c->S_T_y * twist[0] - c->S_T_x * twist[1];
    const six_link_real t24 = c->S_T_x * twist[2] - c->S_T_z * twist[0];
    const six_link_real h_T_F_x = a_T_x * c->body0_mass + twist[1] * t23 - twist[2] * t24;
    const six_link_real t25 = c->S_T_z * twist[1] - c->S_T_y * twist[2];
    const six_link_real h_T_F_y = a_T_y * c->body0_mass + twist[2] * t25 - twist[0] * t23;
    const six_link_real h_T_F_z = a_T_z * c->body0_mass + twist[0] * t24 - twist[1] * t25;

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_11 = 1 + c->armature_1 - 1;

    /* joint_H: bias of the joint's rows, springs and dampers included (61) */
    const six_link_real joint_H_1 = c->joint_damping_1 * t2;
    const six_link_real t26 = -beta_omega_y;
    const six_link_real t27 = -beta_v_y;

    /* outputs */
    link->h_V[0] = H_star_tau_y;
    link->h_V[1] = H_star_tau_z;
    link->h_V[2] = H_star_f_x;
    link->h_V[3] = H_star_f_y;
    link->h_V[4] = H_star_f_z;
    link->h_T[0] = h_T_tau_x;
    link->h_T[1] = h_T_tau_y;
    link->h_T[2] = h_T_tau_z;
    link->h_T[3] = h_T_F_x;
    link->h_T[4] = h_T_F_y;
    link->h_T[5] = h_T_F_z;
    M[place[0]] = 1;
    M[place[1]] = P_c_11;
    M[place[2]] = 1;
    M[place[3]] = 1;
    M[place[4]] = 1;
    M[place[5]] = 1;
    M[place[6]] = 1;
    joint_H[0] = joint_H_1;
    joint_H[1] = t26;
    joint_H[2] = joint_H_3;
    joint_H[3] = 0;
    joint_H[4] = t27;
    joint_H[5] = joint_H_6;
    joint_W[0] = tau[0];
    joint_W[1] = 0;
    joint_W[2] = 0;
    joint_W[3] = 0;
    joint_W[4] = 0;
    joint_W[5] = 0;
    base->X[7] = R_rel_yy;
    base->X[8] = R_rel_zy;
    base->X[13] = t1;
    base->X[14] = R_rel_yy;
    base->X[28] = R_rel_yy;
    base->X[29] = R_rel_zy;
    base->X[34] = t1;
    base->X[35] = R_rel_yy;
    base->PX[0] = P_c_11;
    base->PX[7] = R_rel_yy;
    base->PX[8] = R_rel_zy;
    base->PX[13] = t1;
    base->PX[14] = R_rel_yy;
    base->PX[28] = R_rel_yy;
    base->PX[29] = R_rel_zy;
    base->PX[34] = t1;
    base->PX[35] = R_rel_yy;
    return SIX_LINK_OK;
}

/* link rows, links like shoulder: 60 operations */
SIX_LINK_PART six_link_status link_rows_shoulder(const six_link_link_constants *c, const six_link_link_store *link,
    const six_link_node *tip, const six_link_real w_ext[6], six_link_real V_H[6], six_link_real V_W[6],
    const int *place, six_link_real *M)
{
    const six_link_real t1 = -c->S_T_z;
    const six_link_real t2 = -c->J_T_yz;
    const six_link_real t3 = -c->S_T_y;

    /* V_V: twist rows, twist columns (100) */
    const six_link_real V_V_11 = c->I_s + c->I_T_xx;
    const six_link_real V_V_12 = -(c->length * c->S_T_y + c->J_T_xy);
    const six_link_real V_V_13 = -(c->length * c->S_T_z + c->J_T_xz);
    const six_link_real t4 = c->length * c->body0_mass + c->S_T_x;
    const six_link_real t5 = c->J_0_xx + c->length * t4;
    const six_link_real t6 = c->length * c->S_T_x;
    const six_link_real V_V_22 = t5 + (t6 + c->I_T_yy);
    const six_link_real V_V_35 = c->S_0_x + t4;
    const six_link_real t7 = -V_V_35;
    const six_link_real V_V_33 = t5 + (t6 + c->I_T_zz);
    const six_link_real V_V_44 = c->mu + c->body0_mass;

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const six_link_real V_next_24 = tip->X[19] - c->length * tip->X[23];
    const six_link_real V_next_26 = tip->X[31] - c->length * tip->X[35];
    const six_link_real V_next_35 = c->length + tip->X[26];

    /* next_V: next joint's rows, twist columns (100) */
    const six_link_real t8 = -tip->PX[0];
    const six_link_real t9 = -tip->PX[2];
    const six_link_real t10 = -tip->PX[7];
    const six_link_real t11 = -tip->PX[12];
    const six_link_real t12 = -tip->PX[14];
    const six_link_real t13 = -tip->PX[18];
    const six_link_real next_V_42 = c->length * tip->PX[23] - tip->PX[19];
    const six_link_real t14 = -tip->PX[20];
    const six_link_real t15 = -tip->PX[21];
    const six_link_real t16 = -tip->PX[23];
    const six_link_real t17 = -tip->PX[24];
    const six_link_real next_V_53 = -(c->length + tip->PX[26]);
    const six_link_real t18 = -tip->PX[30];
    const six_link_real next_V_62 = c->length * tip->PX[35] - tip->PX[31];
    const six_link_real t19 = -tip->PX[32];
    const six_link_real t20 = -tip->PX[33];
    const six_link_real t21 = -tip->PX[35];

    /* V_H: bias of the twist rows (100) */
    const six_link_real V_H_tau_y = link->h_V[0] - c->length * link->h_T[5] + link->h_T[1];
    const six_link_real V_H_tau_z = link->h_V[1] + c->length * link->h_T[4] + link->h_T[2];
    const six_link_real V_H_f_x = link->h_V[2] + link->h_T[3];
    const six_link_real V_H_f_y = link->h_V[3] + link->h_T[4];
    const six_link_real V_H_f_z = link->h_V[4] + link->h_T[5];

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real V_W_tau_y = w_ext[1] - c->length * w_ext[5];
    const six_link_real V_W_tau_z = c->length * w_ext[4] + w_ext[2];

    /* outputs */
    M[place[7]] = t8;
    M[place[8]] = t9;
    M[place[9]] = t10;
    M[place[10]] = t11;
    M[place[11]] = t12;
    M[place[12]] = t13;
    M[place[13]] = next_V_42;
    M[place[14]] = t14;
    M[place[15]] = t15;
    M[place[16]] = t16;
    M[place[17]] = t17;
    M[place[18]] = next_V_53;
    M[place[19]] = -1;
    M[place[20]] = t18;
    M[place[21]] = next_V_62;
    M[place[22]] = t19;
    M[place[23]] = t20;
    M[place[24]] = t21;
    M[place[25]] = -1;
    M[place[26]] = -1;
    M[place[27]] = -1;
    M[place[28]] = -1;
    M[place[29]] = -1;
    M[place[30]] = -1;
    M[place[31]] = V_V_11;
    M[place[32]] = V_V_12;
    M[place[33]] = V_V_13;
    M[place[34]] = t1;
    M[place[35]] = c->S_T_y;
    M[place[36]] = V_V_12;
    M[place[37]] = V_V_22;
    M[place[38]] = t2;
    M[place[39]] = c->S_T_z;
    M[place[40]] = t7;
    M[place[41]] = V_V_13;
    M[place[42]] = t2;
    M[place[43]] = V_V_33;
    M[place[44]] = t3;
    M[place[45]] = V_V_35;
    M[place[46]] = c->S_T_z;
    M[place[47]] = t3;
    M[place[48]] = V_V_44;
    M[place[49]] = t1;
    M[place[50]] = V_V_35;
    M[place[51]] = V_V_44;
    M[place[52]] = c->S_T_y;
    M[place[53]] = t7;
    M[place[54]] = V_V_44;
    M[place[55]] = tip->X[0];
    M[place[56]] = tip->X[12];
    M[place[57]] = tip->X[18];
    M[place[58]] = tip->X[24];
    M[place[59]] = tip->X[30];
    M[place[60]] = 1;
    M[place[61]] = V_next_24;
    M[place[62]] = V_next_26;
    M[place[63]] = tip->X[2];
    M[place[64]] = tip->X[14];
    M[place[65]] = tip->X[20];
    M[place[66]] = V_next_35;
    M[place[67]] = tip->X[32];
    M[place[68]] = tip->X[21];
    M[place[69]] = tip->X[33];
    M[place[70]] = 1;
    M[place[71]] = tip->X[23];
    M[place[72]] = tip->X[35];
    V_H[0] = link->h_T[0];
    V_H[1] = V_H_tau_y;
    V_H[2] = V_H_tau_z;
    V_H[3] = V_H_f_x;
    V_H[4] = V_H_f_y;
    V_H[5] = V_H_f_z;
    V_W[0] = w_ext[0];
    V_W[1] = V_W_tau_y;
    V_W[2] = V_W_tau_z;
    V_W[3] = w_ext[3];
    V_W[4] = w_ext[4];
    V_W[5] = w_ext[5];
    return SIX_LINK_OK;
}

/* link rows, links like upper_arm: 2195 operations */
SIX_LINK_PART six_link_status link_rows_upper_arm(const six_link_link_constants *c, const six_link_link_store *link,
    const six_link_node *tip, const six_link_real m_eta[5], const six_link_real f_eta[5], const six_link_real w_ext[6],
    six_link_real V_H[6], six_link_real eta_H[5], six_link_real V_W[6], six_link_real eta_W[5], const int *place,
    six_link_real *M)
{
    const six_link_real t1 = link->h_eta[0] + f_eta[0];
    const six_link_real t2 = link->h_eta[1] + f_eta[1];
    const six_link_real t3 = link->h_eta[2] + f_eta[2];
    const six_link_real t4 = link->h_eta[3] + f_eta[3];

    /* J_TV: twist of the tip section from that of F_i (46) */
    const six_link_real J_TV_41 = link->R_T[6] * link->r_T[0] - link->R_T[3] * link->r_T[1];
    const six_link_real J_TV_42 = link->R_T[0] * link->r_T[1] - link->R_T[6] * c->length;
    const six_link_real J_TV_43 = link->R_T[3] * c->length - link->R_T[0] * link->r_T[0];
    const six_link_real J_TV_51 = link->R_T[7] * link->r_T[0] - link->R_T[4] * link->r_T[1];
    const six_link_real J_TV_52 = link->R_T[1] * link->r_T[1] - link->R_T[7] * c->length;
    const six_link_real J_TV_53 = link->R_T[4] * c->length - link->R_T[1] * link->r_T[0];
    const six_link_real J_TV_61 = link->R_T[8] * link->r_T[0] - link->R_T[5] * link->r_T[1];
    const six_link_real J_TV_62 = link->R_T[2] * link->r_T[1] - link->R_T[8] * c->length;
    const six_link_real J_TV_63 = link->R_T[5] * c->length - link->R_T[2] * link->r_T[0];

    /* J_Teta: twist of the tip section from the modal rates (46) */
    const six_link_real t5 = link->J_l[2] * c->Psi_c_z1;
    const six_link_real t6 = link->J_l[5] * c->Psi_c_z1;
    const six_link_real t7 = link->J_l[8] * c->Psi_c_z1;
    const six_link_real J_Teta_11 = link->R_T[0] * t5 + link->R_T[3] * t6 + link->R_T[6] * t7;
    const six_link_real t8 = link->J_l[2] * c->Psi_c_z2;
    const six_link_real t9 = link->J_l[5] * c->Psi_c_z2;
    const six_link_real t10 = link->J_l[8] * c->Psi_c_z2;
    const six_link_real J_Teta_12 = link->R_T[0] * t8 + link->R_T[3] * t9 + link->R_T[6] * t10;
    const six_link_real t11 = link->J_l[1] * c->Psi_c_y3;
    const six_link_real t12 = link->J_l[4] * c->Psi_c_y3;
    const six_link_real t13 = link->J_l[7] * c->Psi_c_y3;
    const six_link_real J_Teta_13 = link->R_T[0] * t11 + link->R_T[3] * t12 + link->R_T[6] * t13;
    const six_link_real t14 = link->J_l[1] * c->Psi_c_y4;
    const six_link_real t15 = link->J_l[4] * c->Psi_c_y4;
    const six_link_real t16 = link->J_l[7] * c->Psi_c_y4;
    const six_link_real J_Teta_14 = link->R_T[0] * t14 + link->R_T[3] * t15 + link->R_T[6] * t16;
    const six_link_real t17 = link->J_l[0] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real t18 = link->J_l[3] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real t19 = link->J_l[6] * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real J_Teta_15 = link->R_T[0] * t17 + link->R_T[3] * t18 + link->R_T[6] * t19;
    const six_link_real J_Teta_21 = link->R_T[1] * t5 + link->R_T[4] * t6 + link->R_T[7] * t7;
    const six_link_real J_Teta_22 = link->R_T[1] * t8 + link->R_T[4] * t9 + link->R_T[7] * t10;
    const six_link_real J_Teta_23 = link->R_T[1] * t11 + link->R_T[4] * t12 + link->R_T[7] * t13;
    const six_link_real J_Teta_24 = link->R_T[1] * t14 + link->R_T[4] * t15 + link->R_T[7] * t16;
    const six_link_real J_Teta_25 = link->R_T[1] * t17 + link->R_T[4] * t18 + link->R_T[7] * t19;
    const six_link_real J_Teta_31 = link->R_T[2] * t5 + link->R_T[5] * t6 + link->R_T[8] * t7;
    const six_link_real J_Teta_32 = link->R_T[2] * t8 + link->R_T[5] * t9 + link->R_T[8] * t10;
    const six_link_real J_Teta_33 = link->R_T[2] * t11 + link->R_T[5] * t12 + link->R_T[8] * t13;
    const six_link_real J_Teta_34 = link->R_T[2] * t14 + link->R_T[5] * t15 + link->R_T[8] * t16;
    const six_link_real J_Teta_35 = link->R_T[2] * t17 + link->R_T[5] * t18 + link->R_T[8] * t19;
    const six_link_real J_Teta_41 = link->R_T[3] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real J_Teta_42 = link->R_T[3] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real J_Teta_43 = link->R_T[6] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real J_Teta_44 = link->R_T[6] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real J_Teta_51 = link->R_T[4] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real J_Teta_52 = link->R_T[4] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real J_Teta_53 = link->R_T[7] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real J_Teta_54 = link->R_T[7] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real J_Teta_61 = link->R_T[5] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real J_Teta_62 = link->R_T[5] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real J_Teta_63 = link->R_T[8] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real J_Teta_64 = link->R_T[8] * SIX_LINK_REAL(2.8145226674626453);

    /* V_V: twist rows, twist columns (100) */
    const six_link_real t20 = c->S_T_z * link->R_T[1];
    const six_link_real t21 = c->S_T_y * link->R_T[2];
    const six_link_real t22 = J_TV_41 * c->body0_mass + t20 - t21;
    const six_link_real t23 = c->S_T_z * link->R_T[0];
    const six_link_real t24 = c->S_T_x * link->R_T[2];
    const six_link_real t25 = J_TV_51 * c->body0_mass - t23 + t24;
    const six_link_real t26 = c->S_T_y * link->R_T[0];
    const six_link_real t27 = c->S_T_x * link->R_T[1];
    const six_link_real t28 = J_TV_61 * c->body0_mass + t26 - t27;
    const six_link_real t29 = J_TV_61 * c->S_T_y - J_TV_51 * c->S_T_z + c->I_T_xx * link->R_T[0]
        - c->J_T_xy * link->R_T[1] - c->J_T_xz * link->R_T[2];
    const six_link_real t30 = J_TV_41 * c->S_T_z - J_TV_61 * c->S_T_x - c->J_T_xy * link->R_T[0]
        + c->I_T_yy * link->R_T[1] - c->J_T_yz * link->R_T[2];
    const six_link_real t31 = link->M_V[0] + J_TV_41 * t22 + J_TV_51 * t25 + J_TV_61 * t28 + link->R_T[0] * t29
        + link->R_T[1] * t30;
    const six_link_real t32 = J_TV_51 * c->S_T_x - J_TV_41 * c->S_T_y - c->J_T_xz * link->R_T[0]
        - c->J_T_yz * link->R_T[1] + c->I_T_zz * link->R_T[2];
    const six_link_real V_V_11 = t31 + link->R_T[2] * t32;
    const six_link_real t33 = J_TV_42 * t22 - link->M_V[1] + J_TV_52 * t25 + J_TV_62 * t28 + link->R_T[3] * t29
        + link->R_T[4] * t30;
    const six_link_real V_V_12 = t33 + link->R_T[5] * t32;
    const six_link_real t34 = J_TV_43 * t22 - link->M_V[2] + J_TV_53 * t25 + J_TV_63 * t28 + link->R_T[6] * t29
        + link->R_T[7] * t30;
    const six_link_real V_V_13 = t34 + link->R_T[8] * t32;
    const six_link_real V_V_14 = link->R_T[0] * t22 + link->R_T[1] * t25 + link->R_T[2] * t28;
    const six_link_real V_V_15 = link->R_T[3] * t22 - link->M_V[3] + link->R_T[4] * t25 + link->R_T[5] * t28;
    const six_link_real V_V_16 = link->M_V[4] + link->R_T[6] * t22 + link->R_T[7] * t25 + link->R_T[8] * t28;
    const six_link_real t35 = c->S_T_z * link->R_T[4];
    const six_link_real t36 = c->S_T_y * link->R_T[5];
    const six_link_real t37 = J_TV_42 * c->body0_mass + t35 - t36;
    const six_link_real t38 = c->S_T_z * link->R_T[3];
    const six_link_real t39 = c->S_T_x * link->R_T[5];
    const six_link_real t40 = J_TV_52 * c->body0_mass - t38 + t39;
    const six_link_real t41 = c->S_T_y * link->R_T[3];
    const six_link_real t42 = c->S_T_x * link->R_T[4];
    const six_link_real t43 = J_TV_62 * c->body0_mass + t41 - t42;
    const six_link_real t44 = J_TV_62 * c->S_T_y - J_TV_52 * c->S_T_z + c->I_T_xx * link->R_T[3]
        - c->J_T_xy * link->R_T[4] - c->J_T_xz * link->R_T[5];
    const six_link_real t45 = J_TV_42 * c->S_T_z - J_TV_62 * c->S_T_x - c->J_T_xy * link->R_T[3]
        + c->I_T_yy * link->R_T[4] - c->J_T_yz * link->R_T[5];
    const six_link_real t46 = link->M_V[5] + J_TV_42 * t37 + J_TV_52 * t40 + J_TV_62 * t43 + link->R_T[3] * t44
        + link->R_T[4] * t45;
    const six_link_real t47 = J_TV_52 * c->S_T_x - J_TV_42 * c->S_T_y - c->J_T_xz * link->R_T[3]
        - c->J_T_yz * link->R_T[4] + c->I_T_zz * link->R_T[5];
    const six_link_real V_V_22 = t46 + link->R_T[5] * t47;
    const six_link_real t48 = J_TV_43 * t37 - link->M_V[6] + J_TV_53 * t40 + J_TV_63 * t43 + link->R_T[6] * t44
        + link->R_T[7] * t45;
    const six_link_real V_V_23 = t48 + link->R_T[8] * t47;
    const six_link_real V_V_24 = link->M_V[3] + link->R_T[0] * t37 + link->R_T[1] * t40 + link->R_T[2] * t43;
    const six_link_real V_V_25 = link->R_T[3] * t37 + link->R_T[4] * t40 + link->R_T[5] * t43;
    const six_link_real V_V_26 = link->R_T[6] * t37 - c->S_0_x + link->R_T[7] * t40 + link->R_T[8] * t43;
    const six_link_real t49 = c->S_T_z * link->R_T[7];
    const six_link_real t50 = c->S_T_y * link->R_T[8];
    const six_link_real t51 = J_TV_43 * c->body0_mass + t49 - t50;
    const six_link_real t52 = c->S_T_z * link->R_T[6];
    const six_link_real t53 = c->S_T_x * link->R_T[8];
    const six_link_real t54 = J_TV_53 * c->body0_mass - t52 + t53;
    const six_link_real t55 = c->S_T_y * link->R_T[6];
    const six_link_real t56 = c->S_T_x * link->R_T[7];
    const six_link_real t57 = J_TV_63 * c->body0_mass + t55 - t56;
    const six_link_real t58 = J_TV_63 * c->S_T_y - J_TV_53 * c->S_T_z + c->I_T_xx * link->R_T[6]
        - c->J_T_xy * link->R_T[7] - c->J_T_xz * link->R_T[8];
    const six_link_real t59 = J_TV_43 * c->S_T_z - J_TV_63 * c->S_T_x - c->J_T_xy * link->R_T[6]
        + c->I_T_yy * link->R_T[7] - c->J_T_yz * link->R_T[8];
    const six_link_real t60 = link->M_V[7] + J_TV_43 * t51 + J_TV_53 * t54 + J_TV_63 * t57 + link->R_T[6] * t58
        + link->R_T[7] * t59;
    const six_link_real t61 = J_TV_53 * c->S_T_x - J_TV_43 * c->S_T_y - c->J_T_xz * link->R_T[6]
        - c->J_T_yz * link->R_T[7] + c->I_T_zz * link->R_T[8];
    const six_link_real V_V_33 = t60 + link->R_T[8] * t61;
    const six_link_real V_V_34 = link->R_T[0] * t51 - link->M_V[4] + link->R_T[1] * t54 + link->R_T[2] * t57;
    const six_link_real V_V_35 = c->S_0_x + link->R_T[3] * t51 + link->R_T[4] * t54 + link->R_T[5] * t57;
    const six_link_real V_V_36 = link->R_T[6] * t51 + link->R_T[7] * t54 + link->R_T[8] * t57;
    const six_link_real t62 = c->body0_mass * link->R_T[0];
    const six_link_real t63 = c->body0_mass * link->R_T[1];
    const six_link_real t64 = c->body0_mass * link->R_T[2];
    const six_link_real V_V_44 = c->mu + link->R_T[0] * t62 + link->R_T[1] * t63 + link->R_T[2] * t64;
    const six_link_real V_V_45 = link->R_T[3] * t62 + link->R_T[4] * t63 + link->R_T[5] * t64;
    const six_link_real V_V_46 = link->R_T[6] * t62 + link->R_T[7] * t63 + link->R_T[8] * t64;
    const six_link_real t65 = c->body0_mass * link->R_T[3];
    const six_link_real t66 = c->body0_mass * link->R_T[4];
    const six_link_real t67 = c->body0_mass * link->R_T[5];
    const six_link_real V_V_55 = c->mu + link->R_T[3] * t65 + link->R_T[4] * t66 + link->R_T[5] * t67;
    const six_link_real V_V_56 = link->R_T[6] * t65 + link->R_T[7] * t66 + link->R_T[8] * t67;
    const six_link_real t68 = c->body0_mass * link->R_T[6];
    const six_link_real t69 = c->body0_mass * link->R_T[7];
    const six_link_real t70 = c->body0_mass * link->R_T[8];
    const six_link_real V_V_66 = c->mu + link->R_T[6] * t68 + link->R_T[7] * t69 + link->R_T[8] * t70;

    /* V_eta: twist rows, modal columns (100) */
    const six_link_real t71 = J_Teta_11 * t29 - link->M_D[0] + J_Teta_21 * t30 + J_Teta_31 * t32 + J_Teta_41 * t22
        + J_Teta_51 * t25;
    const six_link_real V_eta_11 = t71 + J_Teta_61 * t28;
    const six_link_real t72 = J_Teta_12 * t29 - link->M_D[1] + J_Teta_22 * t30 + J_Teta_32 * t32 + J_Teta_42 * t22
        + J_Teta_52 * t25;
    const six_link_real V_eta_12 = t72 + J_Teta_62 * t28;
    const six_link_real t73 = link->M_D[2] + J_Teta_13 * t29 + J_Teta_23 * t30 + J_Teta_33 * t32 + J_Teta_43 * t22
        + J_Teta_53 * t25;
    const six_link_real V_eta_13 = t73 + J_Teta_63 * t28;
    const six_link_real t74 = link->M_D[3] + J_Teta_14 * t29 + J_Teta_24 * t30 + J_Teta_34 * t32 + J_Teta_44 * t22
        + J_Teta_54 * t25;
    const six_link_real V_eta_14 = t74 + J_Teta_64 * t28;
    const six_link_real V_eta_15 = c->sigma_t_5 + J_Teta_15 * t29 + J_Teta_25 * t30 + J_Teta_35 * t32;
    const six_link_real V_eta_21 = J_Teta_11 * t44 + J_Teta_21 * t45 + J_Teta_31 * t47 + J_Teta_41 * t37
        + J_Teta_51 * t40 + J_Teta_61 * t43;
    const six_link_real V_eta_22 = J_Teta_12 * t44 + J_Teta_22 * t45 + J_Teta_32 * t47 + J_Teta_42 * t37
        + J_Teta_52 * t40 + J_Teta_62 * t43;
    const six_link_real t75 = J_Teta_13 * t44 - c->chi_1 + J_Teta_23 * t45 + J_Teta_33 * t47 + J_Teta_43 * t37
        + J_Teta_53 * t40;
    const six_link_real V_eta_23 = t75 + J_Teta_63 * t43;
    const six_link_real t76 = J_Teta_14 * t44 - c->chi_2 + J_Teta_24 * t45 + J_Teta_34 * t47 + J_Teta_44 * t37
        + J_Teta_54 * t40;
    const six_link_real V_eta_24 = t76 + J_Teta_64 * t43;
    const six_link_real V_eta_25 = J_Teta_15 * t44 + J_Teta_25 * t45 + J_Teta_35 * t47;
    const six_link_real t77 = c->chi_1 + J_Teta_11 * t58 + J_Teta_21 * t59 + J_Teta_31 * t61 + J_Teta_41 * t51
        + J_Teta_51 * t54;
    const six_link_real V_eta_31 = t77 + J_Teta_61 * t57;
    const six_link_real t78 = c->chi_2 + J_Teta_12 * t58 + J_Teta_22 * t59 + J_Teta_32 * t61 + J_Teta_42 * t51
        + J_Teta_52 * t54;
    const six_link_real V_eta_32 = t78 + J_Teta_62 * t57;
    const six_link_real V_eta_33 = J_Teta_13 * t58 + J_Teta_23 * t59 + J_Teta_33 * t61 + J_Teta_43 * t51
        + J_Teta_53 * t54 + J_Teta_63 * t57;
    const six_link_real V_eta_34 = J_Teta_14 * t58 + J_Teta_24 * t59 + J_Teta_34 * t61 + J_Teta_44 * t51
        + J_Teta_54 * t54 + J_Teta_64 * t57;
    const six_link_real V_eta_35 = J_Teta_15 * t58 + J_Teta_25 * t59 + J_Teta_35 * t61;
    const six_link_real t79 = t21 - t20;
    const six_link_real t80 = t23 - t24;
    const six_link_real t81 = t27 - t26;
    const six_link_real V_eta_41 = J_Teta_11 * t79 + J_Teta_21 * t80 + J_Teta_31 * t81 + J_Teta_41 * t62
        + J_Teta_51 * t63 + J_Teta_61 * t64;
    const six_link_real V_eta_42 = J_Teta_12 * t79 + J_Teta_22 * t80 + J_Teta_32 * t81 + J_Teta_42 * t62
        + J_Teta_52 * t63 + J_Teta_62 * t64;
    const six_link_real V_eta_43 = J_Teta_13 * t79 + J_Teta_23 * t80 + J_Teta_33 * t81 + J_Teta_43 * t62
        + J_Teta_53 * t63 + J_Teta_63 * t64;
    const six_link_real V_eta_44 = J_Teta_14 * t79 + J_Teta_24 * t80 + J_Teta_34 * t81 + J_Teta_44 * t62
        + J_Teta_54 * t63 + J_Teta_64 * t64;
    const six_link_real V_eta_45 = J_Teta_15 * t79 + J_Teta_25 * t80 + J_Teta_35 * t81;
    const six_link_real t82 = t36 - t35;
    const six_link_real t83 = t38 - t39;
    const six_link_real t84 = t42 - t41;
    const six_link_real t85 = c->sigma_y1 + J_Teta_11 * t82 + J_Teta_21 * t83 + J_Teta_31 * t84 + J_Teta_41 * t65
        + J_Teta_51 * t66;
    const six_link_real V_eta_51 = t85 + J_Teta_61 * t67;
    const six_link_real t86 = c->sigma_y2 + J_Teta_12 * t82 + J_Teta_22 * t83 + J_Teta_32 * t84 + J_Teta_42 * t65
        + J_Teta_52 * t66;
    const six_link_real V_eta_52 = t86 + J_Teta_62 * t67;
    const six_link_real V_eta_53 = J_Teta_13 * t82 + J_Teta_23 * t83 + J_Teta_33 * t84 + J_Teta_43 * t65
        + J_Teta_53 * t66 + J_Teta_63 * t67;
    const six_link_real V_eta_54 = J_Teta_14 * t82 + J_Teta_24 * t83 + J_Teta_34 * t84 + J_Teta_44 * t65
        + J_Teta_54 * t66 + J_Teta_64 * t67;
    const six_link_real V_eta_55 = J_Teta_15 * t82 + J_Teta_25 * t83 + J_Teta_35 * t84;
    const six_link_real t87 = t50 - t49;
    const six_link_real t88 = t52 - t53;
    const six_link_real t89 = t56 - t55;
    const six_link_real V_eta_61 = J_Teta_11 * t87 + J_Teta_21 * t88 + J_Teta_31 * t89 + J_Teta_41 * t68
        + J_Teta_51 * t69 + J_Teta_61 * t70;
    const six_link_real V_eta_62 = J_Teta_12 * t87 + J_Teta_22 * t88 + J_Teta_32 * t89 + J_Teta_42 * t68
        + J_Teta_52 * t69 + J_Teta_62 * t70;
    const six_link_real t90 = c->sigma_y1 + J_Teta_13 * t87 + J_Teta_23 * t88 + J_Teta_33 * t89 + J_Teta_43 * t68
        + J_Teta_53 * t69;
    const six_link_real V_eta_63 = t90 + J_Teta_63 * t70;
    const six_link_real t91 = c->sigma_y2 + J_Teta_14 * t87 + J_Teta_24 * t88 + J_Teta_34 * t89 + J_Teta_44 * t68
        + J_Teta_54 * t69;
    const six_link_real V_eta_64 = t91 + J_Teta_64 * t70;
    const six_link_real V_eta_65 = J_Teta_15 * t87 + J_Teta_25 * t88 + J_Teta_35 * t89;

    /* eta_eta: modal rows, modal columns (100) */
    const six_link_real t92 = J_Teta_11 * c->I_T_xx - J_Teta_21 * c->J_T_xy - J_Teta_31 * c->J_T_xz
        - J_Teta_51 * c->S_T_z + J_Teta_61 * c->S_T_y;
    const six_link_real t93 = J_Teta_21 * c->I_T_yy - J_Teta_11 * c->J_T_xy - J_Teta_31 * c->J_T_yz
        + J_Teta_41 * c->S_T_z - J_Teta_61 * c->S_T_x;
    const six_link_real t94 = J_Teta_31 * c->I_T_zz - (J_Teta_11 * c->J_T_xz + J_Teta_21 * c->J_T_yz)
        - J_Teta_41 * c->S_T_y + J_Teta_51 * c->S_T_x;
    const six_link_real t95 = J_Teta_21 * c->S_T_z - J_Teta_31 * c->S_T_y + J_Teta_41 * c->body0_mass;
    const six_link_real t96 = J_Teta_31 * c->S_T_x - J_Teta_11 * c->S_T_z + J_Teta_51 * c->body0_mass;
    const six_link_real t97 = m_eta[0] + J_Teta_11 * t92 + J_Teta_21 * t93 + J_Teta_31 * t94 + J_Teta_41 * t95
        + J_Teta_51 * t96;
    const six_link_real t98 = J_Teta_11 * c->S_T_y - J_Teta_21 * c->S_T_x + J_Teta_61 * c->body0_mass;
    const six_link_real eta_eta_11 = t97 + J_Teta_61 * t98;
    const six_link_real eta_eta_12 = J_Teta_12 * t92 + J_Teta_22 * t93 + J_Teta_32 * t94 + J_Teta_42 * t95
        + J_Teta_52 * t96 + J_Teta_62 * t98;
    const six_link_real eta_eta_13 = J_Teta_13 * t92 + J_Teta_23 * t93 + J_Teta_33 * t94 + J_Teta_43 * t95
        + J_Teta_53 * t96 + J_Teta_63 * t98;
    const six_link_real eta_eta_14 = J_Teta_14 * t92 + J_Teta_24 * t93 + J_Teta_34 * t94 + J_Teta_44 * t95
        + J_Teta_54 * t96 + J_Teta_64 * t98;
    const six_link_real eta_eta_15 = J_Teta_15 * t92 + J_Teta_25 * t93 + J_Teta_35 * t94;
    const six_link_real t99 = J_Teta_12 * c->I_T_xx - J_Teta_22 * c->J_T_xy - J_Teta_32 * c->J_T_xz
        - J_Teta_52 * c->S_T_z + J_Teta_62 * c->S_T_y;
    const six_link_real t100 = J_Teta_22 * c->I_T_yy - J_Teta_12 * c->J_T_xy - J_Teta_32 * c->J_T_yz
        + J_Teta_42 * c->S_T_z - J_Teta_62 * c->S_T_x;
    const six_link_real t101 = J_Teta_32 * c->I_T_zz - (J_Teta_12 * c->J_T_xz + J_Teta_22 * c->J_T_yz)
        - J_Teta_42 * c->S_T_y + J_Teta_52 * c->S_T_x;
    const six_link_real t102 = J_Teta_22 * c->S_T_z - J_Teta_32 * c->S_T_y + J_Teta_42 * c->body0_mass;
    const six_link_real t103 = J_Teta_32 * c->S_T_x - J_Teta_12 * c->S_T_z + J_Teta_52 * c->body0_mass;
    const six_link_real t104 = m_eta[1] + J_Teta_12 * t99 + J_Teta_22 * t100 + J_Teta_32 * t101 + J_Teta_42 * t102
        + J_Teta_52 * t103;
    const six_link_real t105 = J_Teta_12 * c->S_T_y - J_Teta_22 * c->S_T_x + J_Teta_62 * c->body0_mass;
    const six_link_real eta_eta_22 = t104 + J_Teta_62 * t105;
    const six_link_real eta_eta_23 = J_Teta_13 * t99 + J_Teta_23 * t100 + J_Teta_33 * t101 + J_Teta_43 * t102
        + J_Teta_53 * t103 + J_Teta_63 * t105;
    const six_link_real eta_eta_24 = J_Teta_14 * t99 + J_Teta_24 * t100 + J_Teta_34 * t101 + J_Teta_44 * t102
        + J_Teta_54 * t103 + J_Teta_64 * t105;
    const six_link_real eta_eta_25 = J_Teta_15 * t99 + J_Teta_25 * t100 + J_Teta_35 * t101;
    const six_link_real t106 = J_Teta_13 * c->I_T_xx - J_Teta_23 * c->J_T_xy - J_Teta_33 * c->J_T_xz
        - J_Teta_53 * c->S_T_z + J_Teta_63 * c->S_T_y;
    const six_link_real t107 = J_Teta_23 * c->I_T_yy - J_Teta_13 * c->J_T_xy - J_Teta_33 * c->J_T_yz
        + J_Teta_43 * c->S_T_z - J_Teta_63 * c->S_T_x;
    const six_link_real t108 = J_Teta_33 * c->I_T_zz - (J_Teta_13 * c->J_T_xz + J_Teta_23 * c->J_T_yz)
        - J_Teta_43 * c->S_T_y + J_Teta_53 * c->S_T_x;
    const six_link_real t109 = J_Teta_23 * c->S_T_z - J_Teta_33 * c->S_T_y + J_Teta_43 * c->body0_mass;
    const six_link_real t110 = J_Teta_33 * c->S_T_x - J_Teta_13 * c->S_T_z + J_Teta_53 * c->body0_mass;
    const six_link_real t111 = m_eta[2] + J_Teta_13 * t106 + J_Teta_23 * t107 + J_Teta_33 * t108 + J_Teta_43 * t109
        + J_Teta_53 * t110;
    const six_link_real t112 = J_Teta_13 * c->S_T_y - J_Teta_23 * c->S_T_x + J_Teta_63 * c->body0_mass;
    const six_link_real eta_eta_33 = t111 + J_Teta_63 * t112;
    const six_link_real eta_eta_34 = J_Teta_14 * t106 + J_Teta_24 * t107 + J_Teta_34 * t108 + J_Teta_44 * t109
        + J_Teta_54 * t110 + J_Teta_64 * t112;
    const six_link_real eta_eta_35 = J_Teta_15 * t106 + J_Teta_25 * t107 + J_Teta_35 * t108;
    const six_link_real t113 = J_Teta_14 * c->I_T_xx - J_Teta_24 * c->J_T_xy - J_Teta_34 * c->J_T_xz
        - J_Teta_54 * c->S_T_z + J_Teta_64 * c->S_T_y;
    const six_link_real t114 = J_Teta_24 * c->I_T_yy - J_Teta_14 * c->J_T_xy - J_Teta_34 * c->J_T_yz
        + J_Teta_44 * c->S_T_z - J_Teta_64 * c->S_T_x;
    const six_link_real t115 = J_Teta_34 * c->I_T_zz - (J_Teta_14 * c->J_T_xz + J_Teta_24 * c->J_T_yz)
        - J_Teta_44 * c->S_T_y + J_Teta_54 * c->S_T_x;
    const six_link_real t116 = m_eta[3] + J_Teta_14 * t113 + J_Teta_24 * t114 + J_Teta_34 * t115
        + J_Teta_44 * (J_Teta_24 * c->S_T_z - J_Teta_34 * c->S_T_y + J_Teta_44 * c->body0_mass);
    const six_link_real eta_eta_44 = t116
        + J_Teta_54 * (J_Teta_34 * c->S_T_x - J_Teta_14 * c->S_T_z + J_Teta_54 * c->body0_mass)
        + J_Teta_64 * (J_Teta_14 * c->S_T_y - J_Teta_24 * c->S_T_x + J_Teta_64 * c->body0_mass);
    const six_link_real eta_eta_45 = J_Teta_15 * t113 + J_Teta_25 * t114 + J_Teta_35 * t115;
    const six_link_real t117 = m_eta[4]
        + J_Teta_15 * (J_Teta_15 * c->I_T_xx - J_Teta_25 * c->J_T_xy - J_Teta_35 * c->J_T_xz)
        + J_Teta_25 * (J_Teta_25 * c->I_T_yy - J_Teta_15 * c->J_T_xy - J_Teta_35 * c->J_T_yz);
    const six_link_real eta_eta_55 = t117
        + J_Teta_35 * (J_Teta_35 * c->I_T_zz - (J_Teta_15 * c->J_T_xz + J_Teta_25 * c->J_T_yz));

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const six_link_real V_next_11 = link->R_T[0] * tip->X[0] + link->R_T[1] * tip->X[1] + link->R_T[2] * tip->X[2];
    const six_link_real V_next_12 = link->R_T[0] * tip->X[6] + link->R_T[1] * tip->X[7] + link->R_T[2] * tip->X[8];
    const six_link_real V_next_13 = link->R_T[0] * tip->X[12] + link->R_T[1] * tip->X[13] + link->R_T[2] * tip->X[14];
    const six_link_real t118 = J_TV_41 * tip->X[21] + J_TV_51 * tip->X[22] + J_TV_61 * tip->X[23]
        + link->R_T[0] * tip->X[18] + link->R_T[1] * tip->X[19];
    const six_link_real V_next_14 = t118 + link->R_T[2] * tip->X[20];
    const six_link_real t119 = J_TV_41 * tip->X[27] + J_TV_51 * tip->X[28] + J_TV_61 * tip->X[29]
        + link->R_T[0] * tip->X[24] + link->R_T[1] * tip->X[25];
    const six_link_real V_next_15 = t119 + link->R_T[2] * tip->X[26];
    const six_link_real t120 = J_TV_41 * tip->X[33] + J_TV_51 * tip->X[34] + J_TV_61 * tip->X[35]
        + link->R_T[0] * tip->X[30] + link->R_T[1] * tip->X[31];
    const six_link_real V_next_16 = t120 + link->R_T[2] * tip->X[32];
    const six_link_real V_next_21 = link->R_T[3] * tip->X[0] + link->R_T[4] * tip->X[1] + link->R_T[5] * tip->X[2];
    const six_link_real V_next_22 = link->R_T[3] * tip->X[6] + link->R_T[4] * tip->X[7] + link->R_T[5] * tip->X[8];
    const six_link_real V_next_23 = link->R_T[3] * tip->X[12] + link->R_T[4] * tip->X[13] + link->R_T[5] * tip->X[14];
    const six_link_real t121 = J_TV_42 * tip->X[21] + J_TV_52 * tip->X[22] + J_TV_62 * tip->X[23]
        + link->R_T[3] * tip->X[18] + link->R_T[4] * tip->X[19];
    const six_link_real V_next_24 = t121 + link->R_T[5] * tip->X[20];
    const six_link_real t122 = J_TV_42 * tip->X[27] + J_TV_52 * tip->X[28] + J_TV_62 * tip->X[29]
        + link->R_T[3] * tip->X[24] + link->R_T[4] * tip->X[25];
    const six_link_real V_next_25 = t122 + link->R_T[5] * tip->X[26];
    const six_link_real t123 = J_TV_42 * tip->X[33] + J_TV_52 * tip->X[34] + J_TV_62 * tip->X[35]
        + link->R_T[3] * tip->X[30] + link->R_T[4] * tip->X[31];
    const six_link_real V_next_26 = t123 + link->R_T[5] * tip->X[32];
    const six_link_real V_next_31 = link->R_T[6] * tip->X[0] + link->R_T[7] * tip->X[1] + link->R_T[8] * tip->X[2];
    const six_link_real V_next_32 = link->R_T[6] * tip->X[6] + link->R_T[7] * tip->X[7] + link->R_T[8] * tip->X[8];
    const six_link_real V_next_33 = link->R_T[6] * tip->X[12] + link->R_T[7] * tip->X[13] + link->R_T[8] * tip->X[14];
    const six_link_real t124 = J_TV_43 * tip->X[21] + J_TV_53 * tip->X[22] + J_TV_63 * tip->X[23]
        + link->R_T[6] * tip->X[18] + link->R_T[7] * tip->X[19];
    const six_link_real V_next_34 = t124 + link->R_T[8] * tip->X[20];
    const six_link_real t125 = J_TV_43 * tip->X[27] + J_TV_53 * tip->X[28] + J_TV_63 * tip->X[29]
        + link->R_T[6] * tip->X[24] + link->R_T[7] * tip->X[25];
    const six_link_real V_next_35 = t125 + link->R_T[8] * tip->X[26];
    const six_link_real t126 = J_TV_43 * tip->X[33] + J_TV_53 * tip->X[34] + J_TV_63 * tip->X[35]
        + link->R_T[6] * tip->X[30] + link->R_T[7] * tip->X[31];
    const six_link_real V_next_36 = t126 + link->R_T[8] * tip->X[32];
    const six_link_real V_next_44 = link->R_T[0] * tip->X[21] + link->R_T[1] * tip->X[22] + link->R_T[2] * tip->X[23];
    const six_link_real V_next_45 = link->R_T[0] * tip->X[27] + link->R_T[1] * tip->X[28] + link->R_T[2] * tip->X[29];
    const six_link_real V_next_46 = link->R_T[0] * tip->X[33] + link->R_T[1] * tip->X[34] + link->R_T[2] * tip->X[35];
    const six_link_real V_next_54 = link->R_T[3] * tip->X[21] + link->R_T[4] * tip->X[22] + link->R_T[5] * tip->X[23];
    const six_link_real V_next_55 = link->R_T[3] * tip->X[27] + link->R_T[4] * tip->X[28] + link->R_T[5] * tip->X[29];
    const six_link_real V_next_56 = link->R_T[3] * tip->X[33] + link->R_T[4] * tip->X[34] + link->R_T[5] * tip->X[35];
    const six_link_real V_next_64 = link->R_T[6] * tip->X[21] + link->R_T[7] * tip->X[22] + link->R_T[8] * tip->X[23];
    const six_link_real V_next_65 = link->R_T[6] * tip->X[27] + link->R_T[7] * tip->X[28] + link->R_T[8] * tip->X[29];
    const six_link_real V_next_66 = link->R_T[6] * tip->X[33] + link->R_T[7] * tip->X[34] + link->R_T[8] * tip->X[35];

    /* eta_next: modal rows, columns of the next joint's wrench (100) */
    const six_link_real eta_next_11 = J_Teta_11 * tip->X[0] + J_Teta_21 * tip->X[1] + J_Teta_31 * tip->X[2];
    const six_link_real eta_next_12 = J_Teta_11 * tip->X[6] + J_Teta_21 * tip->X[7] + J_Teta_31 * tip->X[8];
    const six_link_real eta_next_13 = J_Teta_11 * tip->X[12] + J_Teta_21 * tip->X[13] + J_Teta_31 * tip->X[14];
    const six_link_real t127 = J_Teta_11 * tip->X[18] + J_Teta_21 * tip->X[19] + J_Teta_31 * tip->X[20]
        + J_Teta_41 * tip->X[21];
    const six_link_real eta_next_14 = t127 + J_Teta_51 * tip->X[22] + J_Teta_61 * tip->X[23];
    const six_link_real t128 = J_Teta_11 * tip->X[24] + J_Teta_21 * tip->X[25] + J_Teta_31 * tip->X[26]
        + J_Teta_41 * tip->X[27];
    const six_link_real eta_next_15 = t128 + J_Teta_51 * tip->X[28] + J_Teta_61 * tip->X[29];
    const six_link_real t129 = J_Teta_11 * tip->X[30] + J_Teta_21 * tip->X[31] + J_Teta_31 * tip->X[32]
        + J_Teta_41 * tip->X[33];
    const six_link_real eta_next_16 = t129 + J_Teta_51 * tip->X[34] + J_Teta_61 * tip->X[35];
    const six_link_real eta_next_21 = J_Teta_12 * tip->X[0] + J_Teta_22 * tip->X[1] + J_Teta_32 * tip->X[2];
    const six_link_real eta_next_22 = J_Teta_12 * tip->X[6] + J_Teta_22 * tip->X[7] + J_Teta_32 * tip->X[8];
    const six_link_real eta_next_23 = J_Teta_12 * tip->X[12] + J_Teta_22 * tip->X[13] + J_Teta_32 * tip->X[14];
    const six_link_real t130 = J_Teta_12 * tip->X[18] + J_Teta_22 * tip->X[19] + J_Teta_32 * tip->X[20]
        + J_Teta_42 * tip->X[21];
    const six_link_real eta_next_24 = t130 + J_Teta_52 * tip->X[22] + J_Teta_62 * tip->X[23];
    const six_link_real t131 = J_Teta_12 * tip->X[24] + J_Teta_22 * tip->X[25] + J_Teta_32 * tip->X[26]
        + J_Teta_42 * tip->X[27];
    const six_link_real eta_next_25 = t131 + J_Teta_52 * tip->X[28] + J_Teta_62 * tip->X[29];
    const six_link_real t132 = J_Teta_12 * tip->X[30] + J_Teta_22 * tip->X[31] + J_Teta_32 * tip->X[32]
        + J_Teta_42 * tip->X[33];
    const six_link_real eta_next_26 = t132 + J_Teta_52 * tip->X[34] + J_Teta_62 * tip->X[35];
    const six_link_real eta_next_31 = J_Teta_13 * tip->X[0] + J_Teta_23 * tip->X[1] + J_Teta_33 * tip->X[2];
    const six_link_real eta_next_32 = J_Teta_13 * tip->X[6] + J_Teta_23 * tip->X[7] + J_Teta_33 * tip->X[8];
    const six_link_real eta_next_33 = J_Teta_13 * tip->X[12] + J_Teta_23 * tip->X[13] + J_Teta_33 * tip->X[14];
    const six_link_real t133 = J_Teta_13 * tip->X[18] + J_Teta_23 * tip->X[19] + J_Teta_33 * tip->X[20]
        + J_Teta_43 * tip->X[21];
    const six_link_real eta_next_34 = t133 + J_Teta_53 * tip->X[22] + J_Teta_63 * tip->X[23];
    const six_link_real t134 = J_Teta_13 * tip->X[24] + J_Teta_23 * tip->X[25] + J_Teta_33 * tip->X[26]
        + J_Teta_43 * tip->X[27];
    const six_link_real eta_next_35 = t134 + J_Teta_53 * tip->X[28] + J_Teta_63 * tip->X[29];
    const six_link_real t135 = J_Teta_13 * tip->X[30] + J_Teta_23 * tip->X[31] + J_Teta_33 * tip->X[32]
        + J_Teta_43 * tip->X[33];
    const six_link_real eta_next_36 = t135 + J_Teta_53 * tip->X[34] + J_Teta_63 * tip->X[35];
    const six_link_real eta_next_41 = J_Teta_14 * tip->X[0] + J_Teta_24 * tip->X[1] + J_Teta_34 * tip->X[2];
    const six_link_real eta_next_42 = J_Teta_14 * tip->X[6] + J_Teta_24 * tip->X[7] + J_Teta_34 * tip->X[8];
    const six_link_real eta_next_43 = J_Teta_14 * tip->X[12] + J_Teta_24 * tip->X[13] + J_Teta_34 * tip->X[14];
    const six_link_real t136 = J_Teta_14 * tip->X[18] + J_Teta_24 * tip->X[19] + J_Teta_34 * tip->X[20]
        + J_Teta_44 * tip->X[21];
    const six_link_real eta_next_44 = t136 + J_Teta_54 * tip->X[22] + J_Teta_64 * tip->X[23];
    const six_link_real t137 = J_Teta_14 * tip->X[24] + J_Teta_24 * tip->X[25] + J_Teta_34 * tip->X[26]
        + J_Teta_44 * tip->X[27];
    const six_link_real eta_next_45 = t137 + J_Teta_54 * tip->X[28] + J_Teta_64 * tip->X[29];
    const six_link_real t138 = J_Teta_14 * tip->X[30] + J_Teta_24 * tip->X[31] + J_Teta_34 * tip->X[32]
        + J_Teta_44 * tip->X[33];
    const six_link_real eta_next_46 = t138 + J_Teta_54 * tip->X[34] + J_Teta_64 * tip->X[35];
    const six_link_real eta_next_51 = J_Teta_15 * tip->X[0] + J_Teta_25 * tip->X[1] + J_Teta_35 * tip->X[2];
    const six_link_real eta_next_52 = J_Teta_15 * tip->X[6] + J_Teta_25 * tip->X[7] + J_Teta_35 * tip->X[8];
    const six_link_real eta_next_53 = J_Teta_15 * tip->X[12] + J_Teta_25 * tip->X[13] + J_Teta_35 * tip->X[14];
    const six_link_real eta_next_54 = J_Teta_15 * tip->X[18] + J_Teta_25 * tip->X[19] + J_Teta_35 * tip->X[20];
    const six_link_real eta_next_55 = J_Teta_15 * tip->X[24] + J_Teta_25 * tip->X[25] + J_Teta_35 * tip->X[26];
    const six_link_real eta_next_56 = J_Teta_15 * tip->X[30] + J_Teta_25 * tip->X[31] + J_Teta_35 * tip->X[32];

    /* next_V: next joint's rows, twist columns (100) */
    const six_link_real next_V_11 = -(tip->PX[0] * link->R_T[0] + tip->PX[1] * link->R_T[1]
        + tip->PX[2] * link->R_T[2]);
    const six_link_real next_V_12 = -(tip->PX[0] * link->R_T[3] + tip->PX[1] * link->R_T[4]
        + tip->PX[2] * link->R_T[5]);
    const six_link_real next_V_13 = -(tip->PX[0] * link->R_T[6] + tip->PX[1] * link->R_T[7]
        + tip->PX[2] * link->R_T[8]);
    const six_link_real next_V_21 = -(tip->PX[6] * link->R_T[0] + tip->PX[7] * link->R_T[1]
        + tip->PX[8] * link->R_T[2]);
    const six_link_real next_V_22 = -(tip->PX[6] * link->R_T[3] + tip->PX[7] * link->R_T[4]
        + tip->PX[8] * link->R_T[5]);
    const six_link_real next_V_23 = -(tip->PX[6] * link->R_T[6] + tip->PX[7] * link->R_T[7]
        + tip->PX[8] * link->R_T[8]);
    const six_link_real next_V_31 = -(tip->PX[12] * link->R_T[0] + tip->PX[13] * link->R_T[1]
        + tip->PX[14] * link->R_T[2]);
    const six_link_real next_V_32 = -(tip->PX[12] * link->R_T[3] + tip->PX[13] * link->R_T[4]
        + tip->PX[14] * link->R_T[5]);
    const six_link_real next_V_33 = -(tip->PX[12] * link->R_T[6] + tip->PX[13] * link->R_T[7]
        + tip->PX[14] * link->R_T[8]);
    const six_link_real t139 = J_TV_41 * tip->PX[21] + J_TV_51 * tip->PX[22] + J_TV_61 * tip->PX[23]
        + tip->PX[18] * link->R_T[0];
    const six_link_real next_V_41 = -(t139 + tip->PX[19] * link->R_T[1] + tip->PX[20] * link->R_T[2]);
    const six_link_real t140 = J_TV_42 * tip->PX[21] + J_TV_52 * tip->PX[22] + J_TV_62 * tip->PX[23]
        + tip->PX[18] * link->R_T[3];
    const six_link_real next_V_42 = -(t140 + tip->PX[19] * link->R_T[4] + tip->PX[20] * link->R_T[5]);
    const six_link_real t141 = J_TV_43 * tip->PX[21] + J_TV_53 * tip->PX[22] + J_TV_63 * tip->PX[23]
        + tip->PX[18] * link->R_T[6];
    const six_link_real next_V_43 = -(t141 + tip->PX[19] * link->R_T[7] + tip->PX[20] * link->R_T[8]);
    const six_link_real next_V_44 = -(tip->PX[21] * link->R_T[0] + tip->PX[22] * link->R_T[1]
        + tip->PX[23] * link->R_T[2]);
    const six_link_real next_V_45 = -(tip->PX[21] * link->R_T[3] + tip->PX[22] * link->R_T[4]
        + tip->PX[23] * link->R_T[5]);
    const six_link_real next_V_46 = -(tip->PX[21] * link->R_T[6] + tip->PX[22] * link->R_T[7]
        + tip->PX[23] * link->R_T[8]);
    const six_link_real t142 = J_TV_41 * tip->PX[27] + J_TV_51 * tip->PX[28] + J_TV_61 * tip->PX[29]
        + tip->PX[24] * link->R_T[0];
    const six_link_real next_V_51 = -(t142 + tip->PX[25] * link->R_T[1] + tip->PX[26] * link->R_T[2]);
    const six_link_real t143 = J_TV_42 * tip->PX[27] + J_TV_52 * tip->PX[28] + J_TV_62 * tip->PX[29]
        + tip->PX[24] * link->R_T[3];
    const six_link_real next_V_52 = -(t143 + tip->PX[25] * link->R_T[4] + tip->PX[26] * link->R_T[5]);
    const six_link_real t144 = J_TV_43 * tip->PX[27] + J_TV_53 * tip->PX[28] + J_TV_63 * tip->PX[29]
        + tip->PX[24] * link->R_T[6];
    const six_link_real next_V_53 = -(t144 + tip->PX[25] * link->R_T[7] + tip->PX[26] * link->R_T[8]);
    const six_link_real next_V_54 = -(tip->PX[27] * link->R_T[0] + tip->PX[28] * link->R_T[1]
        + tip->PX[29] * link->R_T[2]);
    const six_link_real next_V_55 = -(tip->PX[27] * link->R_T[3] + tip->PX[28] * link->R_T[4]
        + tip->PX[29] * link->R_T[5]);
    const six_link_real next_V_56 = -(tip->PX[27] * link->R_T[6] + tip->PX[28] * link->R_T[7]
        + tip->PX[29] * link->R_T[8]);
    const six_link_real t145 = J_TV_41 * tip->PX[33] + J_TV_51 * tip->PX[34] + J_TV_61 * tip->PX[35]
        + tip->PX[30] * link->R_T[0];
    const six_link_real next_V_61 = -(t145 + tip->PX[31] * link->R_T[1] + tip->PX[32] * link->R_T[2]);
    const six_link_real t146 = J_TV_42 * tip->PX[33] + J_TV_52 * tip->PX[34] + J_TV_62 * tip->PX[35]
        + tip->PX[30] * link->R_T[3];
    const six_link_real next_V_62 = -(t146 + tip->PX[31] * link->R_T[4] + tip->PX[32] * link->R_T[5]);
    const six_link_real t147 = J_TV_43 * tip->PX[33] + J_TV_53 * tip->PX[34] + J_TV_63 * tip->PX[35]
        + tip->PX[30] * link->R_T[6];
    const six_link_real next_V_63 = -(t147 + tip->PX[31] * link->R_T[7] + tip->PX[32] * link->R_T[8]);
    const six_link_real next_V_64 = -(tip->PX[33] * link->R_T[0] + tip->PX[34] * link->R_T[1]
        + tip->PX[35] * link->R_T[2]);
    const six_link_real next_V_65 = -(tip->PX[33] * link->R_T[3] + tip->PX[34] * link->R_T[4]
        + tip->PX[35] * link->R_T[5]);
    const six_link_real next_V_66 = -(tip->PX[33] * link->R_T[6] + tip->PX[34] * link->R_T[7]
        + tip->PX[35] * link->R_T[8]);

    /* next_eta: next joint's rows, modal columns (100) */
    const six_link_real next_eta_11 = -(J_Teta_11 * tip->PX[0] + J_Teta_21 * tip->PX[1] + J_Teta_31 * tip->PX[2]);
    const six_link_real next_eta_12 = -(J_Teta_12 * tip->PX[0] + J_Teta_22 * tip->PX[1] + J_Teta_32 * tip->PX[2]);
    const six_link_real next_eta_13 = -(J_Teta_13 * tip->PX[0] + J_Teta_23 * tip->PX[1] + J_Teta_33 * tip->PX[2]);
    const six_link_real next_eta_14 = -(J_Teta_14 * tip->PX[0] + J_Teta_24 * tip->PX[1] + J_Teta_34 * tip->PX[2]);
    const six_link_real next_eta_15 = -(J_Teta_15 * tip->PX[0] + J_Teta_25 * tip->PX[1] + J_Teta_35 * tip->PX[2]);
    const six_link_real next_eta_21 = -(J_Teta_11 * tip->PX[6] + J_Teta_21 * tip->PX[7] + J_Teta_31 * tip->PX[8]);
    const six_link_real next_eta_22 = -(J_Teta_12 * tip->PX[6] + J_Teta_22 * tip->PX[7] + J_Teta_32 * tip->PX[8]);
    const six_link_real next_eta_23 = -(J_Teta_13 * tip->PX[6] + J_Teta_23 * tip->PX[7] + J_Teta_33 * tip->PX[8]);
    const six_link_real next_eta_24 = -(J_Teta_14 * tip->PX[6] + J_Teta_24 * tip->PX[7] + J_Teta_34 * tip->PX[8]);
    const six_link_real next_eta_25 = -(J_Teta_15 * tip->PX[6] + J_Teta_25 * tip->PX[7] + J_Teta_35 * tip->PX[8]);
    const six_link_real next_eta_31 = -(J_Teta_11 * tip->PX[12] + J_Teta_21 * tip->PX[13] + J_Teta_31 * tip->PX[14]);
    const six_link_real next_eta_32 = -(J_Teta_12 * tip->PX[12] + J_Teta_22 * tip->PX[13] + J_Teta_32 * tip->PX[14]);
    const six_link_real next_eta_33 = -(J_Teta_13 * tip->PX[12] + J_Teta_23 * tip->PX[13] + J_Teta_33 * tip->PX[14]);
    const six_link_real next_eta_34 = -(J_Teta_14 * tip->PX[12] + J_Teta_24 * tip->PX[13] + J_Teta_34 * tip->PX[14]);
    const six_link_real next_eta_35 = -(J_Teta_15 * tip->PX[12] + J_Teta_25 * tip->PX[13] + J_Teta_35 * tip->PX[14]);
    const six_link_real t148 = J_Teta_11 * tip->PX[18] + J_Teta_21 * tip->PX[19] + J_Teta_31 * tip->PX[20]
        + J_Teta_41 * tip->PX[21];
    const six_link_real next_eta_41 = -(t148 + J_Teta_51 * tip->PX[22] + J_Teta_61 * tip->PX[23]);
    const six_link_real t149 = J_Teta_12 * tip->PX[18] + J_Teta_22 * tip->PX[19] + J_Teta_32 * tip->PX[20]
        + J_Teta_42 * tip->PX[21];
    const six_link_real next_eta_42 = -(t149 + J_Teta_52 * tip->PX[22] + J_Teta_62 * tip->PX[23]);
    const six_link_real t150 = J_Teta_13 * tip->PX[18] + J_Teta_23 * tip->PX[19] + J_Teta_33 * tip->PX[20]
        + J_Teta_43 * tip->PX[21];
    const six_link_real next_eta_43 = -(t150 + J_Teta_53 * tip->PX[22] + J_Teta_63 * tip->PX[23]);
    const six_link_real t151 = J_Teta_14 * tip->PX[18] + J_Teta_24 * tip->PX[19] + J_Teta_34 * tip->PX[20]
        + J_Teta_44 * tip->PX[21];
    const six_link_real next_eta_44 = -(t151 + J_Teta_54 * tip->PX[22] + J_Teta_64 * tip->PX[23]);
    const six_link_real next_eta_45 = -(J_Teta_15 * tip->PX[18] + J_Teta_25 * tip->PX[19] + J_Teta_35 * tip->PX[20]);
    const six_link_real t152 = J_Teta_11 * tip->PX[24] + J_Teta_21 * tip->PX[25] + J_Teta_31 * tip->PX[26]
        + J_Teta_41 * tip->PX[27];
    const six_link_real next_eta_51 = -(t152 + J_Teta_51 * tip->PX[28] + J_Teta_61 * tip->PX[29]);
    const six_link_real t153 = J_Teta_12 * tip->PX[24] + J_Teta_22 * tip->PX[25] + J_Teta_32 * tip->PX[26]
        + J_Teta_42 * tip->PX[27];
    const six_link_real next_eta_52 = -(t153 + J_Teta_52 * tip->PX[28] + J_Teta_62 * tip->PX[29]);
    const six_link_real t154 = J_Teta_13 * tip->PX[24] + J_Teta_23 * tip->PX[25] + J_Teta_33 * tip->PX[26]
        + J_Teta_43 * tip->PX[27];
    const six_link_real next_eta_53 = -(t154 + J_Teta_53 * tip->PX[28] + J_Teta_63 * tip->PX[29]);
    const six_link_real t155 = J_Teta_14 * tip->PX[24] + J_Teta_24 * tip->PX[25] + J_Teta_34 * tip->PX[26]
        + J_Teta_44 * tip->PX[27];
    const six_link_real next_eta_54 = -(t155 + J_Teta_54 * tip->PX[28] + J_Teta_64 * tip->PX[29]);
    const six_link_real next_eta_55 = -(J_Teta_15 * tip->PX[24] + J_Teta_25 * tip->PX[25] + J_Teta_35 * tip->PX[26]);
    const six_link_real t156 = J_Teta_11 * tip->PX[30] + J_Teta_21 * tip->PX[31] + J_Teta_31 * tip->PX[32]
        + J_Teta_41 * tip->PX[33];
    const six_link_real next_eta_61 = -(t156 + J_Teta_51 * tip->PX[34] + J_Teta_61 * tip->PX[35]);
    const six_link_real t157 = J_Teta_12 * tip->PX[30] + J_Teta_22 * tip->PX[31] + J_Teta_32 * tip->PX[32]
        + J_Teta_42 * tip->PX[33];
    const six_link_real next_eta_62 = -(t157 + J_Teta_52 * tip->PX[34] + J_Teta_62 * tip->PX[35]);
    const six_link_real t158 = J_Teta_13 * tip->PX[30] + J_Teta_23 * tip->PX[31] + J_Teta_33 * tip->PX[32]
        + J_Teta_43 * tip->PX[33];
    const six_link_real next_eta_63 = -(t158 + J_Teta_53 * tip->PX[34] + J_Teta_63 * tip->PX[35]);
    const six_link_real t159 = J_Teta_14 * tip->PX[30] + J_Teta_24 * tip->PX[31] + J_Teta_34 * tip->PX[32]
        + J_Teta_44 * tip->PX[33];
    const six_link_real next_eta_64 = -(t159 + J_Teta_54 * tip->PX[34] + J_Teta_64 * tip->PX[35]);
    const six_link_real next_eta_65 = -(J_Teta_15 * tip->PX[30] + J_Teta_25 * tip->PX[31] + J_Teta_35 * tip->PX[32]);

    /* h_carried: bias of the bodies at the tip, its acceleration bias included */
    const six_link_real t160 = link->h_T[0] + c->I_T_xx * link->b_T[0] - c->J_T_xy * link->b_T[1]
        - c->J_T_xz * link->b_T[2] - c->S_T_z * link->b_T[4];
    const six_link_real h_carried_tau_x = t160 + c->S_T_y * link->b_T[5];
    const six_link_real t161 = link->h_T[1] - c->J_T_xy * link->b_T[0] + c->I_T_yy * link->b_T[1]
        - c->J_T_yz * link->b_T[2] + c->S_T_z * link->b_T[3];
    const six_link_real h_carried_tau_y = t161 - c->S_T_x * link->b_T[5];
    const six_link_real t162 = link->h_T[2] - c->J_T_xz * link->b_T[0] - c->J_T_yz * link->b_T[1]
        + c->I_T_zz * link->b_T[2] - c->S_T_y * link->b_T[3];
    const six_link_real h_carried_tau_z = t162 + c->S_T_x * link->b_T[4];
    const six_link_real h_carried_f_x = link->h_T[3] + c->S_T_z * link->b_T[1] - c->S_T_y * link->b_T[2]
        + c->body0_mass * link->b_T[3];
    const six_link_real h_carried_f_y = link->h_T[4] - c->S_T_z * link->b_T[0] + c->S_T_x * link->b_T[2]
        + c->body0_mass * link->b_T[4];
    const six_link_real h_carried_f_z = link->h_T[5] + c->S_T_y * link->b_T[0] - c->S_T_x * link->b_T[1]
        + c->body0_mass * link->b_T[5];

    /* V_H: bias of the twist rows (100) */
    const six_link_real t163 = link->h_V[0] + J_TV_41 * h_carried_f_x + J_TV_51 * h_carried_f_y
        + J_TV_61 * h_carried_f_z + link->R_T[0] * h_carried_tau_x;
    const six_link_real V_H_tau_x = t163 + link->R_T[1] * h_carried_tau_y + link->R_T[2] * h_carried_tau_z;
    const six_link_real t164 = link->h_V[1] + J_TV_42 * h_carried_f_x + J_TV_52 * h_carried_f_y
        + J_TV_62 * h_carried_f_z + link->R_T[3] * h_carried_tau_x;
    const six_link_real V_H_tau_y = t164 + link->R_T[4] * h_carried_tau_y + link->R_T[5] * h_carried_tau_z;
    const six_link_real t165 = link->h_V[2] + J_TV_43 * h_carried_f_x + J_TV_53 * h_carried_f_y
        + J_TV_63 * h_carried_f_z + link->R_T[6] * h_carried_tau_x;
    const six_link_real V_H_tau_z = t165 + link->R_T[7] * h_carried_tau_y + link->R_T[8] * h_carried_tau_z;
    const six_link_real V_H_f_x = link->h_V[3] + link->R_T[0] * h_carried_f_x + link->R_T[1] * h_carried_f_y
        + link->R_T[2] * h_carried_f_z;
    const six_link_real V_H_f_y = link->h_V[4] + link->R_T[3] * h_carried_f_x + link->R_T[4] * h_carried_f_y
        + link->R_T[5] * h_carried_f_z;
    const six_link_real V_H_f_z = link->h_V[5] + link->R_T[6] * h_carried_f_x + link->R_T[7] * h_carried_f_y
        + link->R_T[8] * h_carried_f_z;

    /* eta_H: bias of the modal rows (100) */
    const six_link_real t166 = t1 + J_Teta_11 * h_carried_tau_x + J_Teta_21 * h_carried_tau_y
        + J_Teta_31 * h_carried_tau_z + J_Teta_41 * h_carried_f_x;
    const six_link_real eta_H_1 = t166 + J_Teta_51 * h_carried_f_y + J_Teta_61 * h_carried_f_z;
    const six_link_real t167 = t2 + J_Teta_12 * h_carried_tau_x + J_Teta_22 * h_carried_tau_y
        + J_Teta_32 * h_carried_tau_z + J_Teta_42 * h_carried_f_x;
    const six_link_real eta_H_2 = t167 + J_Teta_52 * h_carried_f_y + J_Teta_62 * h_carried_f_z;
    const six_link_real t168 = t3 + J_Teta_13 * h_carried_tau_x + J_Teta_23 * h_carried_tau_y
        + J_Teta_33 * h_carried_tau_z + J_Teta_43 * h_carried_f_x;
    const six_link_real eta_H_3 = t168 + J_Teta_53 * h_carried_f_y + J_Teta_63 * h_carried_f_z;
    const six_link_real t169 = t4 + J_Teta_14 * h_carried_tau_x + J_Teta_24 * h_carried_tau_y
        + J_Teta_34 * h_carried_tau_z + J_Teta_44 * h_carried_f_x;
    const six_link_real eta_H_4 = t169 + J_Teta_54 * h_carried_f_y + J_Teta_64 * h_carried_f_z;
    const six_link_real eta_H_5 = f_eta[4] + J_Teta_15 * h_carried_tau_x + J_Teta_25 * h_carried_tau_y
        + J_Teta_35 * h_carried_tau_z;

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real t170 = J_TV_41 * w_ext[3] + J_TV_51 * w_ext[4] + J_TV_61 * w_ext[5] + link->R_T[0] * w_ext[0]
        + link->R_T[1] * w_ext[1];
    const six_link_real V_W_tau_x = t170 + link->R_T[2] * w_ext[2];
    const six_link_real t171 = J_TV_42 * w_ext[3] + J_TV_52 * w_ext[4] + J_TV_62 * w_ext[5] + link->R_T[3] * w_ext[0]
        + link->R_T[4] * w_ext[1];
    const six_link_real V_W_tau_y = t171 + link->R_T[5] * w_ext[2];
    const six_link_real t172 = J_TV_43 * w_ext[3] + J_TV_53 * w_ext[4] + J_TV_63 * w_ext[5] + link->R_T[6] * w_ext[0]
        + link->R_T[7] * w_ext[1];
    const six_link_real V_W_tau_z = t172 + link->R_T[8] * w_ext[2];
    const six_link_real V_W_f_x = link->R_T[0] * w_ext[3] + link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5];
    const six_link_real V_W_f_y = link->R_T[3] * w_ext[3] + link->R_T[4] * w_ext[4] + link->R_T[5] * w_ext[5];
    const six_link_real V_W_f_z = link->R_T[6] * w_ext[3] + link->R_T[7] * w_ext[4] + link->R_T[8] * w_ext[5];

    /* eta_W: external wrench in the modal rows (100) */
    const six_link_real t173 = J_Teta_11 * w_ext[0] + J_Teta_21 * w_ext[1] + J_Teta_31 * w_ext[2]
        + J_Teta_41 * w_ext[3] + J_Teta_51 * w_ext[4];
    const six_link_real eta_W_1 = t173 + J_Teta_61 * w_ext[5];
    const six_link_real t174 = J_Teta_12 * w_ext[0] + J_Teta_22 * w_ext[1] + J_Teta_32 * w_ext[2]
        + J_Teta_42 * w_ext[3] + J_Teta_52 * w_ext[4];
    const six_link_real eta_W_2 = t174 + J_Teta_62 * w_ext[5];
    const six_link_real t175 = J_Teta_13 * w_ext[0] + J_Teta_23 * w_ext[1] + J_Teta_33 * w_ext[2]
        + J_Teta_43 * w_ext[3] + J_Teta_53 * w_ext[4];
    const six_link_real eta_W_3 = t175 + J_Teta_63 * w_ext[5];
    const six_link_real t176 = J_Teta_14 * w_ext[0] + J_Teta_24 * w_ext[1] + J_Teta_34 * w_ext[2]
        + J_Teta_44 * w_ext[3] + J_Teta_54 * w_ext[4];
    const six_link_real eta_W_4 = t176 + J_Teta_64 * w_ext[5];
    const six_link_real eta_W_5 = J_Teta_15 * w_ext[0] + J_Teta_25 * w_ext[1] + J_Teta_35 * w_ext[2];

    /* outputs */
    M[place[7]] = next_V_11;
    M[place[8]] = next_V_12;
    M[place[9]] = next_V_13;
    M[place[10]] = next_V_21;
    M[place[11]] = next_V_22;
    M[place[12]] = next_V_23;
    M[place[13]] = next_V_31;
    M[place[14]] = next_V_32;
    M[place[15]] = next_V_33;
    M[place[16]] = next_V_41;
    M[place[17]] = next_V_42;
    M[place[18]] = next_V_43;
    M[place[19]] = next_V_44;
    M[place[20]] = next_V_45;
    M[place[21]] = next_V_46;
    M[place[22]] = next_V_51;
    M[place[23]] = next_V_52;
    M[place[24]] = next_V_53;
    M[place[25]] = next_V_54;
    M[place[26]] = next_V_55;
    M[place[27]] = next_V_56;
    M[place[28]] = next_V_61;
    M[place[29]] = next_V_62;
    M[place[30]] = next_V_63;
    M[place[31]] = next_V_64;
    M[place[32]] = next_V_65;
    M[place[33]] = next_V_66;
    M[place[34]] = next_eta_11;
    M[place[35]] = next_eta_12;
    M[place[36]] = next_eta_13;
    M[place[37]] = next_eta_14;
    M[place[38]] = next_eta_15;
    M[place[39]] = next_eta_21;
    M[place[40]] = next_eta_22;
    M[place[41]] = next_eta_23;
    M[place[42]] = next_eta_24;
    M[place[43]] = next_eta_25;
    M[place[44]] = next_eta_31;
    M[place[45]] = next_eta_32;
    M[place[46]] = next_eta_33;
    M[place[47]] = next_eta_34;
    M[place[48]] = next_eta_35;
    M[place[49]] = next_eta_41;
    M[place[50]] = next_eta_42;
    M[place[51]] = next_eta_43;
    M[place[52]] = next_eta_44;
    M[place[53]] = next_eta_45;
    M[place[54]] = next_eta_51;
    M[place[55]] = next_eta_52;
    M[place[56]] = next_eta_53;
    M[place[57]] = next_eta_54;
    M[place[58]] = next_eta_55;
    M[place[59]] = next_eta_61;
    M[place[60]] = next_eta_62;
    M[place[61]] = next_eta_63;
    M[place[62]] = next_eta_64;
    M[place[63]] = next_eta_65;
    M[place[64]] = -1;
    M[place[65]] = -1;
    M[place[66]] = -1;
    M[place[67]] = -1;
    M[place[68]] = -1;
    M[place[69]] = -1;
    M[place[70]] = V_V_11;
    M[place[71]] = V_V_12;
    M[place[72]] = V_V_13;
    M[place[73]] = V_V_14;
    M[place[74]] = V_V_15;
    M[place[75]] = V_V_16;
    M[place[76]] = V_V_12;
    M[place[77]] = V_V_22;
    M[place[78]] = V_V_23;
    M[place[79]] = V_V_24;
    M[place[80]] = V_V_25;
    M[place[81]] = V_V_26;
    M[place[82]] = V_V_13;
    M[place[83]] = V_V_23;
    M[place[84]] = V_V_33;
    M[place[85]] = V_V_34;
    M[place[86]] = V_V_35;
    M[place[87]] = V_V_36;
    M[place[88]] = V_V_14;
    M[place[89]] = V_V_24;
    M[place[90]] = V_V_34;
    M[place[91]] = V_V_44;
    M[place[92]] = V_V_45;
    M[place[93]] = V_V_46;
    M[place[94]] = V_V_15;
    M[place[95]] = V_V_25;
    M[place[96]] = V_V_35;
    M[place[97]] = V_V_45;
    M[place[98]] = V_V_55;
    M[place[99]] = V_V_56;
    M[place[100]] = V_V_16;
    M[place[101]] = V_V_26;
    M[place[102]] = V_V_36;
    M[place[103]] = V_V_46;
    M[place[104]] = V_V_56;
    M[place[105]] = V_V_66;
    M[place[106]] = V_eta_11;
    M[place[107]] = V_eta_12;
    M[place[108]] = V_eta_13;
    M[place[109]] = V_eta_14;
    M[place[110]] = V_eta_15;
    M[place[111]] = V_eta_21;
    M[place[112]] = V_eta_22;
    M[place[113]] = V_eta_23;
    M[place[114]] = V_eta_24;
    M[place[115]] = V_eta_25;
    M[place[116]] = V_eta_31;
    M[place[117]] = V_eta_32;
    M[place[118]] = V_eta_33;
    M[place[119]] = V_eta_34;
    M[place[120]] = V_eta_35;
    M[place[121]] = V_eta_41;
    M[place[122]] = V_eta_42;
    M[place[123]] = V_eta_43;
    M[place[124]] = V_eta_44;
    M[place[125]] = V_eta_45;
    M[place[126]] = V_eta_51;
    M[place[127]] = V_eta_52;
    M[place[128]] = V_eta_53;
    M[place[129]] = V_eta_54;
    M[place[130]] = V_eta_55;
    M[place[131]] = V_eta_61;
    M[place[132]] = V_eta_62;
    M[place[133]] = V_eta_63;
    M[place[134]] = V_eta_64;
    M[place[135]] = V_eta_65;
    M[place[136]] = V_next_11;
    M[place[137]] = V_next_12;
    M[place[138]] = V_next_13;
    M[place[139]] = V_next_14;
    M[place[140]] = V_next_15;
    M[place[141]] = V_next_16;
    M[place[142]] = V_next_21;
    M[place[143]] = V_next_22;
    M[place[144]] = V_next_23;
    M[place[145]] = V_next_24;
    M[place[146]] = V_next_25;
    M[place[147]] = V_next_26;
    M[place[148]] = V_next_31;
    M[place[149]] = V_next_32;
    M[place[150]] = V_next_33;
    M[place[151]] = V_next_34;
    M[place[152]] = V_next_35;
    M[place[153]] = V_next_36;
    M[place[154]] = V_next_44;
    M[place[155]] = V_next_45;
    M[place[156]] = V_next_46;
    M[place[157]] = V_next_54;
    M[place[158]] = V_next_55;
    M[place[159]] = V_next_56;
    M[place[160]] = V_next_64;
    M[place[161]] = V_next_65;
    M[place[162]] = V_next_66;
    M[place[163]] = V_eta_11;
    M[place[164]] = V_eta_21;
    M[place[165]] = V_eta_31;
    M[place[166]] = V_eta_41;
    M[place[167]] = V_eta_51;
    M[place[168]] = V_eta_61;
    M[place[169]] = V_eta_12;
    M[place[170]] = V_eta_22;
    M[place[171]] = V_eta_32;
    M[place[172]] = V_eta_42;
    M[place[173]] = V_eta_52;
    M[place[174]] = V_eta_62;
    M[place[175]] = V_eta_13;
    M[place[176]] = V_eta_23;
    M[place[177]] = V_eta_33;
    M[place[178]] = V_eta_43;
    M[place[179]] = V_eta_53;
    M[place[180]] = V_eta_63;
    M[place[181]] = V_eta_14;
    M[place[182]] = V_eta_24;
    M[place[183]] = V_eta_34;
    M[place[184]] = V_eta_44;
    M[place[185]] = V_eta_54;
    M[place[186]] = V_eta_64;
    M[place[187]] = V_eta_15;
    M[place[188]] = V_eta_25;
    M[place[189]] = V_eta_35;
    M[place[190]] = V_eta_45;
    M[place[191]] = V_eta_55;
    M[place[192]] = V_eta_65;
    M[place[193]] = eta_eta_11;
    M[place[194]] = eta_eta_12;
    M[place[195]] = eta_eta_13;
    M[place[196]] = eta_eta_14;
    M[place[197]] = eta_eta_15;
    M[place[198]] = eta_eta_12;
    M[place[199]] = eta_eta_22;
    M[place[200]] = eta_eta_23;
    M[place[201]] = eta_eta_24;
    M[place[202]] = eta_eta_25;
    M[place[203]] = eta_eta_13;
    M[place[204]] = eta_eta_23;
    M[place[205]] = eta_eta_33;
    M[place[206]] = eta_eta_34;
    M[place[207]] = eta_eta_35;
    M[place[208]] = eta_eta_14;
    M[place[209]] = eta_eta_24;
    M[place[210]] = eta_eta_34;
    M[place[211]] = eta_eta_44;
    M[place[212]] = eta_eta_45;
    M[place[213]] = eta_eta_15;
    M[place[214]] = eta_eta_25;
    M[place[215]] = eta_eta_35;
    M[place[216]] = eta_eta_45;
    M[place[217]] = eta_eta_55;
    M[place[218]] = eta_next_11;
    M[place[219]] = eta_next_12;
    M[place[220]] = eta_next_13;
    M[place[221]] = eta_next_14;
    M[place[222]] = eta_next_15;
    M[place[223]] = eta_next_16;
    M[place[224]] = eta_next_21;
    M[place[225]] = eta_next_22;
    M[place[226]] = eta_next_23;
    M[place[227]] = eta_next_24;
    M[place[228]] = eta_next_25;
    M[place[229]] = eta_next_26;
    M[place[230]] = eta_next_31;
    M[place[231]] = eta_next_32;
    M[place[232]] = eta_next_33;
    M[place[233]] = eta_next_34;
    M[place[234]] = eta_next_35;
    M[place[235]] = eta_next_36;
    M[place[236]] = eta_next_41;
    M[place[237]] = eta_next_42;
    M[place[238]] = eta_next_43;
    M[place[239]] = eta_next_44;
    M[place[240]] = eta_next_45;
    M[place[241]] = eta_next_46;
    M[place[242]] = eta_next_51;
    M[place[243]] = eta_next_52;
    M[place[244]] = eta_next_53;
    M[place[245]] = eta_next_54;
    M[place[246]] = eta_next_55;
    M[place[247]] = eta_next_56;
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
    return SIX_LINK_OK;
}

/* link rows, links like forearm: 467 operations */
SIX_LINK_PART six_link_status link_rows_forearm(const six_link_link_constants *c, const six_link_link_store *link,
    const six_link_node *tip, const six_link_real m_eta[4], const six_link_real f_eta[4], const six_link_real w_ext[6],
    six_link_real V_H[6], six_link_real eta_H[4], six_link_real V_W[6], six_link_real eta_W[4], const int *place,
    six_link_real *M)
{
    const six_link_real t1 = -link->M_V[1];
    const six_link_real t2 = -link->M_V[2];
    const six_link_real t3 = -link->M_V[3];
    const six_link_real t4 = -link->M_V[6];
    const six_link_real t5 = -c->S_0_x;
    const six_link_real t6 = -link->M_V[4];
    const six_link_real t7 = -link->M_D[0];
    const six_link_real t8 = -link->M_D[1];
    const six_link_real t9 = -c->chi_1;
    const six_link_real t10 = -c->chi_2;
    const six_link_real eta_H_1 = link->h_eta[0] + f_eta[0];
    const six_link_real eta_H_2 = link->h_eta[1] + f_eta[1];
    const six_link_real eta_H_3 = link->h_eta[2] + f_eta[2];
    const six_link_real eta_H_4 = link->h_eta[3] + f_eta[3];

    /* J_TV: twist of the tip section from that of F_i (46) */
    const six_link_real t11 = link->R_T[2] * link->r_T[0];
    const six_link_real t12 = link->R_T[1] * link->r_T[1];
    const six_link_real next_V_41 = t11 + t12;
    const six_link_real J_TV_42 = link->R_T[0] * link->r_T[1] + link->R_T[2] * c->length;
    const six_link_real J_TV_43 = link->R_T[1] * c->length - link->R_T[0] * link->r_T[0];
    const six_link_real J_TV_51 = link->R_T[4] * link->r_T[0] - link->R_T[3] * link->r_T[1];
    const six_link_real t13 = link->R_T[4] * c->length;
    const six_link_real minus_J_TV_52 = t12 + t13;
    const six_link_real J_TV_53 = link->R_T[3] * c->length + link->R_T[1] * link->r_T[0];
    const six_link_real J_TV_61 = link->R_T[5] * link->r_T[0] - link->R_T[4] * link->r_T[1];
    const six_link_real J_TV_62 = link->R_T[2] * link->r_T[1] - link->R_T[5] * c->length;
    const six_link_real J_TV_63 = t13 - t11;

    /* J_Teta: twist of the tip section from the modal rates (46) */
    const six_link_real t14 = link->J_l[2] * c->Psi_c_z1;
    const six_link_real t15 = link->J_l[4] * c->Psi_c_z1;
    const six_link_real t16 = link->J_l[5] * c->Psi_c_z1;
    const six_link_real J_Teta_11 = link->R_T[0] * t14 + link->R_T[1] * t15 - link->R_T[2] * t16;
    const six_link_real t17 = link->J_l[2] * c->Psi_c_z2;
    const six_link_real t18 = link->J_l[4] * c->Psi_c_z2;
    const six_link_real t19 = link->J_l[5] * c->Psi_c_z2;
    const six_link_real J_Teta_12 = link->R_T[0] * t17 + link->R_T[1] * t18 - link->R_T[2] * t19;
    const six_link_real t20 = link->J_l[1] * c->Psi_c_y3;
    const six_link_real t21 = link->J_l[3] * c->Psi_c_y3;
    const six_link_real t22 = link->J_l[4] * c->Psi_c_y3;
    const six_link_real J_Teta_13 = link->R_T[1] * t21 - link->R_T[0] * t20 - link->R_T[2] * t22;
    const six_link_real t23 = link->J_l[1] * c->Psi_c_y4;
    const six_link_real t24 = link->J_l[3] * c->Psi_c_y4;
    const six_link_real t25 = link->J_l[4] * c->Psi_c_y4;
    const six_link_real J_Teta_14 = link->R_T[1] * t24 - link->R_T[0] * t23 - link->R_T[2] * t25;
    const six_link_real J_Teta_21 = link->R_T[3] * t15 - link->R_T[1] * t14 + link->R_T[4] * t16;
    const six_link_real J_Teta_22 = link->R_T[3] * t18 - link->R_T[1] * t17 + link->R_T[4] * t19;
    const six_link_real J_Teta_23 = link->R_T[1] * t20 + link->R_T[3] * t21 + link->R_T[4] * t22;
    const six_link_real J_Teta_24 = link->R_T[1] * t23 + link->R_T[3] * t24 + link->R_T[4] * t25;
    const six_link_real J_Teta_31 = link->R_T[2] * t14 + link->R_T[4] * t15 + link->R_T[5] * t16;
    const six_link_real J_Teta_32 = link->R_T[2] * t17 + link->R_T[4] * t18 + link->R_T[5] * t19;
    const six_link_real J_Teta_33 = link->R_T[4] * t21 - link->R_T[2] * t20 + link->R_T[5] * t22;
    const six_link_real J_Teta_34 = link->R_T[4] * t24 - link->R_T[2] * t23 + link->R_T[5] * t25;
    const six_link_real J_Teta_41 = link->R_T[1] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real J_Teta_42 = link->R_T[1] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real next_eta_43 = link->R_T[2] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real next_eta_44 = link->R_T[2] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real J_Teta_51 = link->R_T[3] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real J_Teta_52 = link->R_T[3] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real J_Teta_53 = link->R_T[4] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real J_Teta_54 = link->R_T[4] * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real J_Teta_63 = link->R_T[5] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real J_Teta_64 = link->R_T[5] * SIX_LINK_REAL(2.8145226674626453);

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const six_link_real V_next_12 = link->R_T[2] * tip->X[8] - link->R_T[1] * tip->X[7];
    const six_link_real V_next_13 = link->R_T[2] * tip->X[14] - link->R_T[1] * tip->X[13];
    const six_link_real t26 = -next_V_41;
    const six_link_real V_next_15 = J_TV_51 * tip->X[28] + J_TV_61 * tip->X[29];
    const six_link_real V_next_16 = J_TV_51 * tip->X[34] + J_TV_61 * tip->X[35];
    const six_link_real V_next_22 = link->R_T[3] * tip->X[7] + link->R_T[4] * tip->X[8];
    const six_link_real V_next_23 = link->R_T[3] * tip->X[13] + link->R_T[4] * tip->X[14];
    const six_link_real V_next_25 = J_TV_62 * tip->X[29] - minus_J_TV_52 * tip->X[28];
    const six_link_real V_next_26 = J_TV_62 * tip->X[35] - minus_J_TV_52 * tip->X[34];
    const six_link_real t27 = -link->R_T[2];
    const six_link_real V_next_32 = link->R_T[4] * tip->X[7] + link->R_T[5] * tip->X[8];
    const six_link_real V_next_33 = link->R_T[4] * tip->X[13] + link->R_T[5] * tip->X[14];
    const six_link_real V_next_35 = J_TV_53 * tip->X[28] + J_TV_63 * tip->X[29];
    const six_link_real V_next_36 = J_TV_53 * tip->X[34] + J_TV_63 * tip->X[35];
    const six_link_real V_next_45 = link->R_T[2] * tip->X[29] - link->R_T[1] * tip->X[28];
    const six_link_real V_next_46 = link->R_T[2] * tip->X[35] - link->R_T[1] * tip->X[34];
    const six_link_real V_next_55 = link->R_T[3] * tip->X[28] + link->R_T[4] * tip->X[29];
    const six_link_real V_next_56 = link->R_T[3] * tip->X[34] + link->R_T[4] * tip->X[35];
    const six_link_real V_next_65 = link->R_T[4] * tip->X[28] + link->R_T[5] * tip->X[29];
    const six_link_real V_next_66 = link->R_T[4] * tip->X[34] + link->R_T[5] * tip->X[35];

    /* eta_next: modal rows, columns of the next joint's wrench (100) */
    const six_link_real eta_next_12 = J_Teta_21 * tip->X[7] + J_Teta_31 * tip->X[8];
    const six_link_real eta_next_13 = J_Teta_21 * tip->X[13] + J_Teta_31 * tip->X[14];
    const six_link_real eta_next_15 = J_Teta_51 * tip->X[28] + J_Teta_53 * tip->X[29];
    const six_link_real eta_next_16 = J_Teta_51 * tip->X[34] + J_Teta_53 * tip->X[35];
    const six_link_real eta_next_22 = J_Teta_22 * tip->X[7] + J_Teta_32 * tip->X[8];
    const six_link_real eta_next_23 = J_Teta_22 * tip->X[13] + J_Teta_32 * tip->X[14];
    const six_link_real eta_next_25 = J_Teta_52 * tip->X[28] + J_Teta_54 * tip->X[29];
    const six_link_real eta_next_26 = J_Teta_52 * tip->X[34] + J_Teta_54 * tip->X[35];
    const six_link_real eta_next_32 = J_Teta_23 * tip->X[7] + J_Teta_33 * tip->X[8];
    const six_link_real eta_next_33 = J_Teta_23 * tip->X[13] + J_Teta_33 * tip->X[14];
    const six_link_real t28 = -next_eta_43;
    const six_link_real eta_next_35 = J_Teta_53 * tip->X[28] + J_Teta_63 * tip->X[29];
    const six_link_real eta_next_36 = J_Teta_53 * tip->X[34] + J_Teta_63 * tip->X[35];
    const six_link_real eta_next_42 = J_Teta_24 * tip->X[7] + J_Teta_34 * tip->X[8];
    const six_link_real eta_next_43 = J_Teta_24 * tip->X[13] + J_Teta_34 * tip->X[14];
    const six_link_real t29 = -next_eta_44;
    const six_link_real eta_next_45 = J_Teta_54 * tip->X[28] + J_Teta_64 * tip->X[29];
    const six_link_real eta_next_46 = J_Teta_54 * tip->X[34] + J_Teta_64 * tip->X[35];

    /* next_V: next joint's rows, twist columns (100) */
    const six_link_real next_V_11 = -(tip->PX[0] * link->R_T[0]);
    const six_link_real next_V_12 = -(tip->PX[0] * link->R_T[1]);
    const six_link_real next_V_13 = tip->PX[0] * link->R_T[2];
    const six_link_real next_V_21 = tip->PX[7] * link->R_T[1] - tip->PX[8] * link->R_T[2];
    const six_link_real next_V_22 = -(tip->PX[7] * link->R_T[3] + tip->PX[8] * link->R_T[4]);
    const six_link_real next_V_23 = -(tip->PX[7] * link->R_T[4] + tip->PX[8] * link->R_T[5]);
    const six_link_real next_V_31 = tip->PX[13] * link->R_T[1] - tip->PX[14] * link->R_T[2];
    const six_link_real next_V_32 = -(tip->PX[13] * link->R_T[3] + tip->PX[14] * link->R_T[4]);
    const six_link_real next_V_33 = -(tip->PX[13] * link->R_T[4] + tip->PX[14] * link->R_T[5]);
    const six_link_real t30 = -J_TV_42;
    const six_link_real t31 = -J_TV_43;
    const six_link_real t32 = -link->R_T[0];
    const six_link_real t33 = -link->R_T[1];
    const six_link_real next_V_51 = -(J_TV_51 * tip->PX[28] + J_TV_61 * tip->PX[29]);
    const six_link_real next_V_52 = minus_J_TV_52 * tip->PX[28] - J_TV_62 * tip->PX[29];
    const six_link_real next_V_53 = -(J_TV_53 * tip->PX[28] + J_TV_63 * tip->PX[29]);
    const six_link_real next_V_54 = tip->PX[28] * link->R_T[1] - tip->PX[29] * link->R_T[2];
    const six_link_real next_V_55 = -(tip->PX[28] * link->R_T[3] + tip->PX[29] * link->R_T[4]);
    const six_link_real next_V_56 = -(tip->PX[28] * link->R_T[4] + tip->PX[29] * link->R_T[5]);
    const six_link_real next_V_61 = -(J_TV_51 * tip->PX[34] + J_TV_61 * tip->PX[35]);
    const six_link_real next_V_62 = minus_J_TV_52 * tip->PX[34] - J_TV_62 * tip->PX[35];
    const six_link_real next_V_63 = -(J_TV_53 * tip->PX[34] + J_TV_63 * tip->PX[35]);
    const six_link_real next_V_64 = tip->PX[34] * link->R_T[1] - tip->PX[35] * link->R_T[2];
    const six_link_real next_V_65 = -(tip->PX[34] * link->R_T[3] + tip->PX[35] * link->R_T[4]);
    const six_link_real next_V_66 = -(tip->PX[34] * link->R_T[4] + tip->PX[35] * link->R_T[5]);

    /* next_eta: next joint's rows, modal columns (100) */
    const six_link_real next_eta_11 = -(J_Teta_11 * tip->PX[0]);
    const six_link_real next_eta_12 = -(J_Teta_12 * tip->PX[0]);
    const six_link_real next_eta_13 = -(J_Teta_13 * tip->PX[0]);
    const six_link_real next_eta_14 = -(J_Teta_14 * tip->PX[0]);
    const six_link_real next_eta_21 = -(J_Teta_21 * tip->PX[7] + J_Teta_31 * tip->PX[8]);
    const six_link_real next_eta_22 = -(J_Teta_22 * tip->PX[7] + J_Teta_32 * tip->PX[8]);
    const six_link_real next_eta_23 = -(J_Teta_23 * tip->PX[7] + J_Teta_33 * tip->PX[8]);
    const six_link_real next_eta_24 = -(J_Teta_24 * tip->PX[7] + J_Teta_34 * tip->PX[8]);
    const six_link_real next_eta_31 = -(J_Teta_21 * tip->PX[13] + J_Teta_31 * tip->PX[14]);
    const six_link_real next_eta_32 = -(J_Teta_22 * tip->PX[13] + J_Teta_32 * tip->PX[14]);
    const six_link_real next_eta_33 = -(J_Teta_23 * tip->PX[13] + J_Teta_33 * tip->PX[14]);
    const six_link_real next_eta_34 = -(J_Teta_24 * tip->PX[13] + J_Teta_34 * tip->PX[14]);
    const six_link_real t34 = -J_Teta_41;
    const six_link_real t35 = -J_Teta_42;
    const six_link_real next_eta_51 = -(J_Teta_51 * tip->PX[28] + J_Teta_53 * tip->PX[29]);
    const six_link_real next_eta_52 = -(J_Teta_52 * tip->PX[28] + J_Teta_54 * tip->PX[29]);
    const six_link_real next_eta_53 = -(J_Teta_53 * tip->PX[28] + J_Teta_63 * tip->PX[29]);
    const six_link_real next_eta_54 = -(J_Teta_54 * tip->PX[28] + J_Teta_64 * tip->PX[29]);
    const six_link_real next_eta_61 = -(J_Teta_51 * tip->PX[34] + J_Teta_53 * tip->PX[35]);
    const six_link_real next_eta_62 = -(J_Teta_52 * tip->PX[34] + J_Teta_54 * tip->PX[35]);
    const six_link_real next_eta_63 = -(J_Teta_53 * tip->PX[34] + J_Teta_63 * tip->PX[35]);
    const six_link_real next_eta_64 = -(J_Teta_54 * tip->PX[34] + J_Teta_64 * tip->PX[35]);

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real t36 = J_TV_51 * w_ext[4] - next_V_41 * w_ext[3] + J_TV_61 * w_ext[5] + link->R_T[0] * w_ext[0]
        - link->R_T[1] * w_ext[1];
    const six_link_real V_W_tau_x = t36 + link->R_T[2] * w_ext[2];
    const six_link_real t37 = J_TV_42 * w_ext[3] - minus_J_TV_52 * w_ext[4] + J_TV_62 * w_ext[5]
        + link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1];
    const six_link_real V_W_tau_y = t37 + link->R_T[4] * w_ext[2];
    const six_link_real t38 = J_TV_43 * w_ext[3] + J_TV_53 * w_ext[4] + J_TV_63 * w_ext[5] - link->R_T[2] * w_ext[0]
        + link->R_T[4] * w_ext[1];
    const six_link_real V_W_tau_z = t38 + link->R_T[5] * w_ext[2];
    const six_link_real V_W_f_x = link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5];
    const six_link_real V_W_f_y = link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5];
    const six_link_real V_W_f_z = link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5];

    /* eta_W: external wrench in the modal rows (100) */
    const six_link_real t39 = J_Teta_11 * w_ext[0] + J_Teta_21 * w_ext[1] + J_Teta_31 * w_ext[2]
        + J_Teta_41 * w_ext[3] + J_Teta_51 * w_ext[4];
    const six_link_real eta_W_1 = t39 + J_Teta_53 * w_ext[5];
    const six_link_real t40 = J_Teta_12 * w_ext[0] + J_Teta_22 * w_ext[1] + J_Teta_32 * w_ext[2]
        + J_Teta_42 * w_ext[3] + J_Teta_52 * w_ext[4];
    const six_link_real eta_W_2 = t40 + J_Teta_54 * w_ext[5];
    const six_link_real t41 = J_Teta_13 * w_ext[0] + J_Teta_23 * w_ext[1] + J_Teta_33 * w_ext[2]
        - next_eta_43 * w_ext[3] + J_Teta_53 * w_ext[4];
    const six_link_real eta_W_3 = t41 + J_Teta_63 * w_ext[5];
    const six_link_real t42 = J_Teta_14 * w_ext[0] + J_Teta_24 * w_ext[1] + J_Teta_34 * w_ext[2]
        - next_eta_44 * w_ext[3] + J_Teta_54 * w_ext[4];
    const six_link_real eta_W_4 = t42 + J_Teta_64 * w_ext[5];

    /* outputs */
    M[place[7]] = next_V_11;
    M[place[8]] = next_V_12;
    M[place[9]] = next_V_13;
    M[place[10]] = next_V_21;
    M[place[11]] = next_V_22;
    M[place[12]] = next_V_23;
    M[place[13]] = next_V_31;
    M[place[14]] = next_V_32;
    M[place[15]] = next_V_33;
    M[place[16]] = next_V_41;
    M[place[17]] = t30;
    M[place[18]] = t31;
    M[place[19]] = t32;
    M[place[20]] = t33;
    M[place[21]] = link->R_T[2];
    M[place[22]] = next_V_51;
    M[place[23]] = next_V_52;
    M[place[24]] = next_V_53;
    M[place[25]] = next_V_54;
    M[place[26]] = next_V_55;
    M[place[27]] = next_V_56;
    M[place[28]] = next_V_61;
    M[place[29]] = next_V_62;
    M[place[30]] = next_V_63;
    M[place[31]] = next_V_64;
    M[place[32]] = next_V_65;
    M[place[33]] = next_V_66;
    M[place[34]] = next_eta_11;
    M[place[35]] = next_eta_12;
    M[place[36]] = next_eta_13;
    M[place[37]] = next_eta_14;
    M[place[38]] = next_eta_21;
    M[place[39]] = next_eta_22;
    M[place[40]] = next_eta_23;
    M[place[41]] = next_eta_24;
    M[place[42]] = next_eta_31;
    M[place[43]] = next_eta_32;
    M[place[44]] = next_eta_33;
    M[place[45]] = next_eta_34;
    M[place[46]] = t34;
    M[place[47]] = t35;
    M[place[48]] = next_eta_43;
    M[place[49]] = next_eta_44;
    M[place[50]] = next_eta_51;
    M[place[51]] = next_eta_52;
    M[place[52]] = next_eta_53;
    M[place[53]] = next_eta_54;
    M[place[54]] = next_eta_61;
    M[place[55]] = next_eta_62;
    M[place[56]] = next_eta_63;
    M[place[57]] = next_eta_64;
    M[place[58]] = -1;
    M[place[59]] = -1;
    M[place[60]] = -1;
    M[place[61]] = -1;
    M[place[62]] = -1;
    M[place[63]] = -1;
    M[place[64]] = link->M_V[0];
    M[place[65]] = t1;
    M[place[66]] = t2;
    M[place[67]] = t3;
    M[place[68]] = link->M_V[4];
    M[place[69]] = t1;
    M[place[70]] = link->M_V[5];
    M[place[71]] = t4;
    M[place[72]] = link->M_V[3];
    M[place[73]] = t5;
    M[place[74]] = t2;
    M[place[75]] = t4;
    M[place[76]] = link->M_V[7];
    M[place[77]] = t6;
    M[place[78]] = c->S_0_x;
    M[place[79]] = link->M_V[3];
    M[place[80]] = t6;
    M[place[81]] = c->m;
    M[place[82]] = t3;
    M[place[83]] = c->S_0_x;
    M[place[84]] = c->m;
    M[place[85]] = link->M_V[4];
    M[place[86]] = t5;
    M[place[87]] = c->m;
    M[place[88]] = t7;
    M[place[89]] = t8;
    M[place[90]] = link->M_D[2];
    M[place[91]] = link->M_D[3];
    M[place[92]] = t9;
    M[place[93]] = t10;
    M[place[94]] = c->chi_1;
    M[place[95]] = c->chi_2;
    M[place[96]] = c->sigma_y1;
    M[place[97]] = c->sigma_y2;
    M[place[98]] = c->sigma_y1;
    M[place[99]] = c->sigma_y2;
    M[place[100]] = link->R_T[0];
    M[place[101]] = V_next_12;
    M[place[102]] = V_next_13;
    M[place[103]] = t26;
    M[place[104]] = V_next_15;
    M[place[105]] = V_next_16;
    M[place[106]] = link->R_T[1];
    M[place[107]] = V_next_22;
    M[place[108]] = V_next_23;
    M[place[109]] = J_TV_42;
    M[place[110]] = V_next_25;
    M[place[111]] = V_next_26;
    M[place[112]] = t27;
    M[place[113]] = V_next_32;
    M[place[114]] = V_next_33;
    M[place[115]] = J_TV_43;
    M[place[116]] = V_next_35;
    M[place[117]] = V_next_36;
    M[place[118]] = link->R_T[0];
    M[place[119]] = V_next_45;
    M[place[120]] = V_next_46;
    M[place[121]] = link->R_T[1];
    M[place[122]] = V_next_55;
    M[place[123]] = V_next_56;
    M[place[124]] = t27;
    M[place[125]] = V_next_65;
    M[place[126]] = V_next_66;
    M[place[127]] = t7;
    M[place[128]] = c->chi_1;
    M[place[129]] = c->sigma_y1;
    M[place[130]] = t8;
    M[place[131]] = c->chi_2;
    M[place[132]] = c->sigma_y2;
    M[place[133]] = link->M_D[2];
    M[place[134]] = t9;
    M[place[135]] = c->sigma_y1;
    M[place[136]] = link->M_D[3];
    M[place[137]] = t10;
    M[place[138]] = c->sigma_y2;
    M[place[139]] = m_eta[0];
    M[place[140]] = m_eta[1];
    M[place[141]] = m_eta[2];
    M[place[142]] = m_eta[3];
    M[place[143]] = J_Teta_11;
    M[place[144]] = eta_next_12;
    M[place[145]] = eta_next_13;
    M[place[146]] = J_Teta_41;
    M[place[147]] = eta_next_15;
    M[place[148]] = eta_next_16;
    M[place[149]] = J_Teta_12;
    M[place[150]] = eta_next_22;
    M[place[151]] = eta_next_23;
    M[place[152]] = J_Teta_42;
    M[place[153]] = eta_next_25;
    M[place[154]] = eta_next_26;
    M[place[155]] = J_Teta_13;
    M[place[156]] = eta_next_32;
    M[place[157]] = eta_next_33;
    M[place[158]] = t28;
    M[place[159]] = eta_next_35;
    M[place[160]] = eta_next_36;
    M[place[161]] = J_Teta_14;
    M[place[162]] = eta_next_42;
    M[place[163]] = eta_next_43;
    M[place[164]] = t29;
    M[place[165]] = eta_next_45;
    M[place[166]] = eta_next_46;
    V_H[0] = link->h_V[0];
    V_H[1] = link->h_V[1];
    V_H[2] = link->h_V[2];
    V_H[3] = link->h_V[3];
    V_H[4] = link->h_V[4];
    V_H[5] = link->h_V[5];
    eta_H[0] = eta_H_1;
    eta_H[1] = eta_H_2;
    eta_H[2] = eta_H_3;
    eta_H[3] = eta_H_4;
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
    return SIX_LINK_OK;
}

/* link rows, links like wrist_roll: 21 operations */
SIX_LINK_PART six_link_status link_rows_wrist_roll(const six_link_link_constants *c, const six_link_link_store *link,
    const six_link_node *tip, const six_link_real w_ext[6], six_link_real V_H[6], six_link_real V_W[6],
    const int *place, six_link_real *M)
{
    const six_link_real t1 = -c->S_0_x;

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const six_link_real V_next_24 = -(c->length * tip->X[23]);
    const six_link_real V_next_26 = -(c->length * tip->X[35]);

    /* next_V: next joint's rows, twist columns (100) */
    const six_link_real t2 = -tip->PX[0];
    const six_link_real t3 = -tip->PX[2];
    const six_link_real t4 = -tip->PX[7];
    const six_link_real t5 = -tip->PX[12];
    const six_link_real t6 = -tip->PX[14];
    const six_link_real next_V_42 = c->length * tip->PX[23];
    const six_link_real t7 = -tip->PX[21];
    const six_link_real t8 = -tip->PX[23];
    const six_link_real t9 = -c->length;
    const six_link_real next_V_62 = c->length * tip->PX[35];
    const six_link_real t10 = -tip->PX[33];
    const six_link_real t11 = -tip->PX[35];

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real V_W_tau_y = w_ext[1] - c->length * w_ext[5];
    const six_link_real V_W_tau_z = c->length * w_ext[4] + w_ext[2];

    /* outputs */
    M[place[7]] = t2;
    M[place[8]] = t3;
    M[place[9]] = t4;
    M[place[10]] = t5;
    M[place[11]] = t6;
    M[place[12]] = next_V_42;
    M[place[13]] = t7;
    M[place[14]] = t8;
    M[place[15]] = t9;
    M[place[16]] = -1;
    M[place[17]] = next_V_62;
    M[place[18]] = t10;
    M[place[19]] = t11;
    M[place[20]] = -1;
    M[place[21]] = -1;
    M[place[22]] = -1;
    M[place[23]] = -1;
    M[place[24]] = -1;
    M[place[25]] = -1;
    M[place[26]] = c->I_s;
    M[place[27]] = c->J_0_xx;
    M[place[28]] = t1;
    M[place[29]] = c->J_0_xx;
    M[place[30]] = c->S_0_x;
    M[place[31]] = c->mu;
    M[place[32]] = c->S_0_x;
    M[place[33]] = c->mu;
    M[place[34]] = t1;
    M[place[35]] = c->mu;
    M[place[36]] = tip->X[0];
    M[place[37]] = tip->X[12];
    M[place[38]] = 1;
    M[place[39]] = V_next_24;
    M[place[40]] = V_next_26;
    M[place[41]] = tip->X[2];
    M[place[42]] = tip->X[14];
    M[place[43]] = c->length;
    M[place[44]] = tip->X[21];
    M[place[45]] = tip->X[33];
    M[place[46]] = 1;
    M[place[47]] = tip->X[23];
    M[place[48]] = tip->X[35];
    V_H[0] = 0;
    V_H[1] = link->h_V[0];
    V_H[2] = link->h_V[1];
    V_H[3] = link->h_V[2];
    V_H[4] = link->h_V[3];
    V_H[5] = link->h_V[4];
    V_W[0] = w_ext[0];
    V_W[1] = V_W_tau_y;
    V_W[2] = V_W_tau_z;
    V_W[3] = w_ext[3];
    V_W[4] = w_ext[4];
    V_W[5] = w_ext[5];
    return SIX_LINK_OK;
}

/* link rows, links like wrist_pitch: 26 operations */
SIX_LINK_PART six_link_status link_rows_wrist_pitch(const six_link_link_constants *c, const six_link_link_store *link,
    const six_link_node *tip, const six_link_real w_ext[6], six_link_real V_H[6], six_link_real V_W[6],
    const int *place, six_link_real *M)
{
    const six_link_real t1 = -c->S_0_x;

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const six_link_real V_next_25 = -(c->length * tip->X[29]);
    const six_link_real V_next_26 = -(c->length * tip->X[35]);
    const six_link_real V_next_35 = c->length * tip->X[28];
    const six_link_real V_next_36 = c->length * tip->X[34];

    /* next_V: next joint's rows, twist columns (100) */
    const six_link_real t2 = -tip->PX[0];
    const six_link_real t3 = -tip->PX[7];
    const six_link_real t4 = -tip->PX[8];
    const six_link_real t5 = -tip->PX[13];
    const six_link_real t6 = -tip->PX[14];
    const six_link_real next_V_52 = c->length * tip->PX[29];
    const six_link_real next_V_53 = -(c->length * tip->PX[28]);
    const six_link_real t7 = -tip->PX[28];
    const six_link_real t8 = -tip->PX[29];
    const six_link_real next_V_62 = c->length * tip->PX[35];
    const six_link_real next_V_63 = -(c->length * tip->PX[34]);
    const six_link_real t9 = -tip->PX[34];
    const six_link_real t10 = -tip->PX[35];

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real V_W_tau_y = w_ext[1] - c->length * w_ext[5];
    const six_link_real V_W_tau_z = c->length * w_ext[4] + w_ext[2];

    /* outputs */
    M[place[7]] = t2;
    M[place[8]] = t3;
    M[place[9]] = t4;
    M[place[10]] = t5;
    M[place[11]] = t6;
    M[place[12]] = -1;
    M[place[13]] = next_V_52;
    M[place[14]] = next_V_53;
    M[place[15]] = t7;
    M[place[16]] = t8;
    M[place[17]] = next_V_62;
    M[place[18]] = next_V_63;
    M[place[19]] = t9;
    M[place[20]] = t10;
    M[place[21]] = -1;
    M[place[22]] = -1;
    M[place[23]] = -1;
    M[place[24]] = -1;
    M[place[25]] = -1;
    M[place[26]] = -1;
    M[place[27]] = c->I_s;
    M[place[28]] = c->J_0_xx;
    M[place[29]] = t1;
    M[place[30]] = c->J_0_xx;
    M[place[31]] = c->S_0_x;
    M[place[32]] = c->mu;
    M[place[33]] = c->S_0_x;
    M[place[34]] = c->mu;
    M[place[35]] = t1;
    M[place[36]] = c->mu;
    M[place[37]] = 1;
    M[place[38]] = tip->X[7];
    M[place[39]] = tip->X[13];
    M[place[40]] = V_next_25;
    M[place[41]] = V_next_26;
    M[place[42]] = tip->X[8];
    M[place[43]] = tip->X[14];
    M[place[44]] = V_next_35;
    M[place[45]] = V_next_36;
    M[place[46]] = 1;
    M[place[47]] = tip->X[28];
    M[place[48]] = tip->X[34];
    M[place[49]] = tip->X[29];
    M[place[50]] = tip->X[35];
    V_H[0] = 0;
    V_H[1] = link->h_V[0];
    V_H[2] = link->h_V[1];
    V_H[3] = link->h_V[2];
    V_H[4] = link->h_V[3];
    V_H[5] = link->h_V[4];
    V_W[0] = w_ext[0];
    V_W[1] = V_W_tau_y;
    V_W[2] = V_W_tau_z;
    V_W[3] = w_ext[3];
    V_W[4] = w_ext[4];
    V_W[5] = w_ext[5];
    return SIX_LINK_OK;
}

/* link rows, links like flange: 35 operations */
SIX_LINK_PART six_link_status link_rows_flange(const six_link_link_constants *c, const six_link_link_store *link,
    const six_link_real w_ext[6], six_link_real V_H[6], six_link_real V_W[6], const int *place, six_link_real *M)
{
    const six_link_real t1 = -c->S_T_z;
    const six_link_real t2 = -c->J_T_yz;
    const six_link_real t3 = -c->S_T_y;

    /* V_V: twist rows, twist columns (100) */
    const six_link_real V_V_11 = c->I_s + c->I_T_xx;
    const six_link_real V_V_12 = -(c->length * c->S_T_y + c->J_T_xy);
    const six_link_real V_V_13 = -(c->length * c->S_T_z + c->J_T_xz);
    const six_link_real t4 = c->length * c->body0_mass + c->S_T_x;
    const six_link_real t5 = c->J_0_xx + c->length * t4;
    const six_link_real t6 = c->length * c->S_T_x;
    const six_link_real V_V_22 = t5 + (t6 + c->I_T_yy);
    const six_link_real V_V_35 = c->S_0_x + t4;
    const six_link_real t7 = -V_V_35;
    const six_link_real V_V_33 = t5 + (t6 + c->I_T_zz);
    const six_link_real V_V_44 = c->mu + c->body0_mass;

    /* V_H: bias of the twist rows (100) */
    const six_link_real V_H_tau_y = link->h_V[0] - c->length * link->h_T[5] + link->h_T[1];
    const six_link_real V_H_tau_z = link->h_V[1] + c->length * link->h_T[4] + link->h_T[2];
    const six_link_real V_H_f_x = link->h_V[2] + link->h_T[3];
    const six_link_real V_H_f_y = link->h_V[3] + link->h_T[4];
    const six_link_real V_H_f_z = link->h_V[4] + link->h_T[5];

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real V_W_tau_y = w_ext[1] - c->length * w_ext[5];
    const six_link_real V_W_tau_z = c->length * w_ext[4] + w_ext[2];

    /* outputs */
    M[place[7]] = -1;
    M[place[8]] = -1;
    M[place[9]] = -1;
    M[place[10]] = -1;
    M[place[11]] = -1;
    M[place[12]] = -1;
    M[place[13]] = V_V_11;
    M[place[14]] = V_V_12;
    M[place[15]] = V_V_13;
    M[place[16]] = t1;
    M[place[17]] = c->S_T_y;
    M[place[18]] = V_V_12;
    M[place[19]] = V_V_22;
    M[place[20]] = t2;
    M[place[21]] = c->S_T_z;
    M[place[22]] = t7;
    M[place[23]] = V_V_13;
    M[place[24]] = t2;
    M[place[25]] = V_V_33;
    M[place[26]] = t3;
    M[place[27]] = V_V_35;
    M[place[28]] = c->S_T_z;
    M[place[29]] = t3;
    M[place[30]] = V_V_44;
    M[place[31]] = t1;
    M[place[32]] = V_V_35;
    M[place[33]] = V_V_44;
    M[place[34]] = c->S_T_y;
    M[place[35]] = t7;
    M[place[36]] = V_V_44;
    V_H[0] = link->h_T[0];
    V_H[1] = V_H_tau_y;
    V_H[2] = V_H_tau_z;
    V_H[3] = V_H_f_x;
    V_H[4] = V_H_f_y;
    V_H[5] = V_H_f_z;
    V_W[0] = w_ext[0];
    V_W[1] = V_W_tau_y;
    V_W[2] = V_W_tau_z;
    V_W[3] = w_ext[3];
    V_W[4] = w_ext[4];
    V_W[5] = w_ext[5];
    return SIX_LINK_OK;
}

static SIX_LINK_TARGETS six_link_status dae_dynamics_dae_kinematics(const six_link_constants *c,
    const six_link_call *call, six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return dae_kinematics_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->q + q, call->twist + 6 * i, call->new_qdot + q);
    case 1:
        return dae_kinematics_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->new_qdot + q);
    case 2:
        return dae_kinematics_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->new_qdot + q);
    case 3:
        return dae_kinematics_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->q + q, call->twist + 6 * i, call->new_qdot + q);
    case 4:
        return dae_kinematics_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->q + q, call->twist + 6 * i, call->new_qdot + q);
    default:
        return dae_kinematics_flange(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->q + q, call->twist + 6 * i, call->new_qdot + q);
    }
}

static SIX_LINK_TARGETS six_link_status dae_dynamics_eliminate(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return eliminate_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->w_ext + 6 * i,
            call->m_q + q, call->f_q + q, call->tau + q);
    case 1:
        return eliminate_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->eta + e, call->etadot + e, call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->m_q + q,
            call->f_q + q, call->tau + q);
    case 2:
        return eliminate_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->eta + e,
            call->etadot + e, call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->m_q + q, call->f_q + q,
            call->tau + q);
    case 3:
        return eliminate_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->w_ext + 6 * i, call->m_q + q, call->f_q + q, call->tau + q);
    case 4:
        return eliminate_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->w_ext + 6 * i, call->m_q + q, call->f_q + q, call->tau + q);
    default:
        return eliminate_flange(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->w_ext + 6 * i, call->m_q + q, call->f_q + q, call->tau + q);
    }
}

static SIX_LINK_TARGETS six_link_status dae_dynamics_accelerate(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return accelerate_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->new_qddot + q,
            call->new_wrench ? call->new_wrench + 6 * i : 0, call->new_alpha + 6 * i);
    case 1:
        return accelerate_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->new_qddot + q, call->new_wrench ? call->new_wrench + 6 * i : 0, call->new_alpha + 6 * i,
            call->new_etaddot + e);
    case 2:
        return accelerate_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->new_qddot + q, call->new_wrench ? call->new_wrench + 6 * i : 0, call->new_alpha + 6 * i,
            call->new_etaddot + e);
    case 3:
        return accelerate_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->new_qddot + q, call->new_wrench ? call->new_wrench + 6 * i : 0, call->new_alpha + 6 * i);
    case 4:
        return accelerate_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->new_qddot + q, call->new_wrench ? call->new_wrench + 6 * i : 0, call->new_alpha + 6 * i);
    default:
        return accelerate_flange(&chain->links[i], &chain->nodes[i], call->new_qddot + q,
            call->new_wrench ? call->new_wrench + 6 * i : 0, call->new_alpha + 6 * i);
    }
}

static SIX_LINK_TARGETS six_link_status dae_dynamics_twist_rates(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 1, 1, 1, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return twist_rates_shoulder(call->quaternion + 4 * i, call->gravity, call->alpha + 6 * i, call->twist + 6 * i,
            call->new_Vdot + 6 * i);
    default:
        return twist_rates_upper_arm(call->quaternion + 4 * i, call->gravity, call->alpha + 6 * i, call->twist + 6 * i,
            call->new_Vdot + 6 * i);
    }
}

static SIX_LINK_TARGETS six_link_status projection_project(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return project_shoulder(&c->links[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i,
            call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i,
            call->new_position + 3 * i);
    case 1:
        return project_upper_arm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i,
            call->eta + e, call->etadot + e, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i,
            call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 2:
        return project_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i,
            call->eta + e, call->etadot + e, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i,
            call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 3:
        return project_wrist_roll(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->twist + 6 * i, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i,
            call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 4:
        return project_wrist_pitch(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->twist + 6 * i, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i,
            call->new_quaternion + 4 * i, call->new_position + 3 * i);
    default:
        return project_flange(&chain->nodes[i], call->q + q, call->twist + 6 * i, call->quaternion + 4 * i,
            call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    }
}

static SIX_LINK_TARGETS six_link_status placement_forward_kinematics(const six_link_constants *c,
    const six_link_call *call, six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return forward_kinematics_shoulder(&c->links[i], &chain->nodes[i + 1], call->q + q, call->qdot + q,
            call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 1:
        return forward_kinematics_upper_arm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q, call->eta + e, call->etadot + e, call->new_twist + 6 * i, call->new_quaternion + 4 * i,
            call->new_position + 3 * i);
    case 2:
        return forward_kinematics_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q, call->eta + e, call->etadot + e, call->new_twist + 6 * i, call->new_quaternion + 4 * i,
            call->new_position + 3 * i);
    case 3:
        return forward_kinematics_wrist_roll(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 4:
        return forward_kinematics_wrist_pitch(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    default:
        return forward_kinematics_flange(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    }
}

static SIX_LINK_TARGETS six_link_status inverse_kinematics(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return kinematics_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q);
    case 1:
        return kinematics_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q, call->eta + e, call->etadot + e);
    case 2:
        return kinematics_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q, call->eta + e, call->etadot + e);
    case 3:
        return kinematics_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->q + q, call->qdot + q);
    case 4:
        return kinematics_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->q + q, call->qdot + q);
    default:
        return kinematics_flange(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q);
    }
}

static SIX_LINK_TARGETS six_link_status inverse_inverse_outward(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_outward_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->qddot + q);
    case 1:
        return inverse_outward_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->etaddot + e);
    case 2:
        return inverse_outward_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->etaddot + e);
    case 3:
        return inverse_outward_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q);
    case 4:
        return inverse_outward_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q);
    default:
        return inverse_outward_flange(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q);
    }
}

static SIX_LINK_TARGETS six_link_status inverse_inverse_inward(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_inward_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->qddot + q,
            call->w_ext + 6 * i, call->m_q + q, call->f_q + q, call->new_force + q,
            call->new_wrench ? call->new_wrench + 6 * i : 0);
    case 1:
        return inverse_inward_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->etaddot + e, call->eta + e, call->etadot + e, call->w_ext + 6 * i, call->m_eta + e,
            call->f_eta + e, call->m_q + q, call->f_q + q, call->new_force_eta + e, call->new_force + q,
            call->new_wrench ? call->new_wrench + 6 * i : 0);
    case 2:
        return inverse_inward_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->etaddot + e, call->eta + e, call->etadot + e, call->w_ext + 6 * i, call->m_eta + e,
            call->f_eta + e, call->m_q + q, call->f_q + q, call->new_force_eta + e, call->new_force + q,
            call->new_wrench ? call->new_wrench + 6 * i : 0);
    case 3:
        return inverse_inward_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->w_ext + 6 * i, call->m_q + q, call->f_q + q, call->new_force + q,
            call->new_wrench ? call->new_wrench + 6 * i : 0);
    case 4:
        return inverse_inward_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->w_ext + 6 * i, call->m_q + q, call->f_q + q, call->new_force + q,
            call->new_wrench ? call->new_wrench + 6 * i : 0);
    default:
        return inverse_inward_flange(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->w_ext + 6 * i, call->m_q + q, call->f_q + q, call->new_force + q,
            call->new_wrench ? call->new_wrench + 6 * i : 0);
    }
}

static SIX_LINK_TARGETS six_link_status inertia_kinematics(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return kinematics_shoulder_2();
    case 1:
        return kinematics_upper_arm_2(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->q + q, call->eta + e);
    case 2:
        return kinematics_forearm_2(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->eta + e);
    case 3:
        return kinematics_wrist_roll_2(&chain->links[i], &chain->nodes[i], call->q + q);
    case 4:
        return kinematics_wrist_pitch_2(&chain->links[i], call->q + q);
    default:
        return kinematics_flange_2(&chain->links[i], call->q + q);
    }
}

static SIX_LINK_TARGETS six_link_status inertia_inverse_outward(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_outward_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->qddot + q);
    case 1:
        return inverse_outward_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->etaddot + e);
    case 2:
        return inverse_outward_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->etaddot + e);
    case 3:
        return inverse_outward_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q);
    case 4:
        return inverse_outward_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q);
    default:
        return inverse_outward_flange(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q);
    }
}

static SIX_LINK_TARGETS six_link_status inertia_inverse_inward(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return inverse_inward_shoulder_2(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->qddot + q,
            call->m_q + q, call->new_force + q);
    case 1:
        return inverse_inward_upper_arm_2(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->etaddot + e, call->eta + e, call->m_eta + e, call->m_q + q, call->new_force_eta + e,
            call->new_force + q);
    case 2:
        return inverse_inward_forearm_2(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->etaddot + e, call->eta + e, call->m_eta + e, call->m_q + q, call->new_force_eta + e,
            call->new_force + q);
    case 3:
        return inverse_inward_wrist_roll_2(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->m_q + q, call->new_force + q);
    case 4:
        return inverse_inward_wrist_pitch_2(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->m_q + q, call->new_force + q);
    default:
        return inverse_inward_flange_2(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->qddot + q, call->m_q + q, call->new_force + q);
    }
}

static SIX_LINK_TARGETS six_link_status motion_of_velocities(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 3 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return velocities_shoulder(&c->links[i], &chain->nodes[i + 1], call->qdot + q);
    case 1:
        return velocities_upper_arm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q,
            call->eta + e, call->etadot + e);
    case 2:
        return velocities_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q,
            call->eta + e, call->etadot + e);
    case 3:
        return velocities_wrist_roll(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q);
    default:
        return velocities_wrist_pitch(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q,
            call->qdot + q);
    }
}

static SIX_LINK_TARGETS six_link_status motion_of_poses(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 3 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return poses_shoulder(&c->links[i], &chain->nodes[i + 1], call->q + q, call->new_R + 9 * i,
            call->new_r + 3 * i);
    case 1:
        return poses_upper_arm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->eta + e,
            call->new_R + 9 * i, call->new_r + 3 * i);
    case 2:
        return poses_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->eta + e,
            call->new_R + 9 * i, call->new_r + 3 * i);
    case 3:
        return poses_wrist_roll(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->new_R + 9 * i,
            call->new_r + 3 * i);
    default:
        return poses_wrist_pitch(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->new_R + 9 * i,
            call->new_r + 3 * i);
    }
}

static SIX_LINK_TARGETS six_link_status motion_of_tip_twist(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 1, 1, 1, 1 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return tip_twist_shoulder(&chain->nodes[i + 1], call->new_tip_twist + 6 * i);
    default:
        return tip_twist_upper_arm(&chain->nodes[i + 1], call->new_tip_twist + 6 * i);
    }
}

static SIX_LINK_TARGETS six_link_status measuring_measure(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 0, 0, 0 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return measure_shoulder(call->new_measures + 4 * i);
    case 1:
        return measure_upper_arm(&c->links[i], call->eta + e, call->motion + 4 * i, call->wrench + 6 * i,
            call->new_measures + 4 * i);
    default:
        return measure_forearm(&c->links[i], call->eta + e, call->motion + 4 * i, call->wrench + 6 * i,
            call->new_measures + 4 * i);
    }
}

static SIX_LINK_TARGETS six_link_status assembly_joint_rows(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return joint_rows_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->twist + 6 * i,
            call->quaternion + 4 * i, call->gravity, call->tau + q, call->H + 12 * i, call->W + 12 * i,
            M_PLACE + M_OFFSET[i], call->M);
    case 1:
        return joint_rows_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->eta + e, call->etadot + e,
            call->tau + q, call->H + 12 * i, call->W + 12 * i, M_PLACE + M_OFFSET[i], call->M);
    case 2:
        return joint_rows_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->eta + e, call->etadot + e,
            call->tau + q, call->H + 12 * i, call->W + 12 * i, M_PLACE + M_OFFSET[i], call->M);
    case 3:
        return joint_rows_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->tau + q, call->H + 12 * i,
            call->W + 12 * i, M_PLACE + M_OFFSET[i], call->M);
    case 4:
        return joint_rows_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1],
            call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->tau + q, call->H + 12 * i,
            call->W + 12 * i, M_PLACE + M_OFFSET[i], call->M);
    default:
        return joint_rows_flange(&c->links[i], &chain->links[i], &chain->nodes[i], call->twist + 6 * i, call->q + q,
            call->quaternion + 4 * i, call->gravity, call->tau + q, call->H + 12 * i, call->W + 12 * i,
            M_PLACE + M_OFFSET[i], call->M);
    }
}

static SIX_LINK_TARGETS six_link_status assembly_link_rows(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return link_rows_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->w_ext + 6 * i,
            call->H + 12 * i + 6, call->W + 12 * i + 6, M_PLACE + M_OFFSET[i], call->M);
    case 1:
        return link_rows_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->m_eta + e,
            call->f_eta + e, call->w_ext + 6 * i, call->H + 12 * i + 6, call->H + 12 * SIX_LINK_NLINKS + e,
            call->W + 12 * i + 6, call->W + 12 * SIX_LINK_NLINKS + e, M_PLACE + M_OFFSET[i], call->M);
    case 2:
        return link_rows_forearm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->m_eta + e, call->f_eta + e,
            call->w_ext + 6 * i, call->H + 12 * i + 6, call->H + 12 * SIX_LINK_NLINKS + e, call->W + 12 * i + 6,
            call->W + 12 * SIX_LINK_NLINKS + e, M_PLACE + M_OFFSET[i], call->M);
    case 3:
        return link_rows_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->w_ext + 6 * i,
            call->H + 12 * i + 6, call->W + 12 * i + 6, M_PLACE + M_OFFSET[i], call->M);
    case 4:
        return link_rows_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->w_ext + 6 * i,
            call->H + 12 * i + 6, call->W + 12 * i + 6, M_PLACE + M_OFFSET[i], call->M);
    default:
        return link_rows_flange(&c->links[i], &chain->links[i], call->w_ext + 6 * i, call->H + 12 * i + 6,
            call->W + 12 * i + 6, M_PLACE + M_OFFSET[i], call->M);
    }
}

/* The base is at rest; in place of gravity on the links it accelerates by -g. */
static void start(const six_link_call *call, six_link_chain *chain)
{
    int k;
    for (k = 0; k < 3; ++k) {
        chain->nodes[0].acc_0[k + 3] = -call->gravity[k];
    }
}

SIX_LINK_TARGETS six_link_status six_link_dae_motion(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    start(call, chain);
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = dae_dynamics_dae_kinematics(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

SIX_LINK_TARGETS six_link_status six_link_dae_solution(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    for (i = SIX_LINK_NLINKS - 1; i >= 0; --i) {
        status = dae_dynamics_eliminate(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = dae_dynamics_accelerate(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = dae_dynamics_twist_rates(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

SIX_LINK_TARGETS six_link_status six_link_projection(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = projection_project(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

SIX_LINK_TARGETS six_link_status six_link_placement(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = placement_forward_kinematics(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

SIX_LINK_TARGETS six_link_status six_link_inverse(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    start(call, chain);
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = inverse_kinematics(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = inverse_inverse_outward(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = SIX_LINK_NLINKS - 1; i >= 0; --i) {
        status = inverse_inverse_inward(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

SIX_LINK_TARGETS six_link_status six_link_inertia_posture(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = inertia_kinematics(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

SIX_LINK_TARGETS six_link_status six_link_inertia_column(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = inertia_inverse_outward(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = SIX_LINK_NLINKS - 1; i >= 0; --i) {
        status = inertia_inverse_inward(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

SIX_LINK_TARGETS six_link_status six_link_motion_of(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = motion_of_velocities(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = motion_of_poses(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = motion_of_tip_twist(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

SIX_LINK_TARGETS six_link_status six_link_measuring(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = measuring_measure(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

SIX_LINK_TARGETS six_link_status six_link_assembly(const six_link_constants *c, const six_link_call *call,
    six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = assembly_joint_rows(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    for (i = SIX_LINK_NLINKS - 1; i >= 0; --i) {
        status = assembly_link_rows(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}
