/* six_link_links.c: what each class of links does in each phase, and the phases in their order.
 *
 * A chain of n links has n + 1 nodes: node 0 is the base, node i + 1 the tip of link i. A phase of link i
 * reads and writes the link's own store, its two nodes, and the arrays of the call.
 */
#include "six_link_links.h"

static const int Q_OFFSET[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
static const int ETA_OFFSET[SIX_LINK_NLINKS] = { 0, 0, 3, 5, 5, 5 };

/* Where the entries of M_sys that a link computes stand among the structural nonzeros. */
static const int M_PLACE[SIX_LINK_NNZ] = {
    2, 7, 19, 31, 43, 53, 63, 13, 25, 37, 47, 57, 67, 14, 26, 38, 48, 58, 68, 15,
    27, 39, 49, 59, 69, 16, 28, 40, 50, 60, 70, 17, 29, 41, 51, 61, 71, 18, 30, 42,
    52, 62, 72, 0, 1, 3, 4, 5, 6, 8, 20, 32, 54, 64, 9, 21, 33, 44, 65, 10,
    22, 34, 45, 55, 23, 35, 46, 11, 36, 56, 12, 24, 66, 73, 80, 88, 95, 102, 109, 74,
    81, 89, 96, 103, 110, 75, 82, 90, 97, 104, 111, 76, 83, 91, 98, 105, 112, 77, 84, 92,
    99, 106, 113, 78, 85, 93, 100, 107, 114, 86, 116, 132, 148, 164, 180, 196, 123, 139, 155, 171,
    187, 203, 124, 140, 156, 172, 188, 204, 125, 141, 157, 173, 189, 205, 126, 142, 158, 174, 190, 206,
    127, 143, 159, 175, 191, 207, 128, 144, 160, 176, 192, 208, 626, 641, 656, 627, 642, 657, 628, 643,
    658, 629, 644, 659, 630, 645, 660, 631, 646, 661, 79, 87, 94, 101, 108, 115, 117, 133, 149, 165,
    181, 197, 118, 134, 150, 166, 182, 198, 119, 135, 151, 167, 183, 199, 120, 136, 152, 168, 184, 200,
    121, 137, 153, 169, 185, 201, 122, 138, 154, 170, 186, 202, 620, 635, 650, 621, 636, 651, 622, 637,
    652, 623, 638, 653, 624, 639, 654, 625, 640, 655, 212, 222, 233, 243, 253, 263, 213, 223, 234, 244,
    254, 264, 214, 224, 235, 245, 255, 265, 215, 225, 236, 246, 256, 266, 216, 226, 237, 247, 257, 267,
    217, 227, 238, 248, 258, 268, 129, 145, 161, 177, 193, 209, 130, 146, 162, 178, 194, 210, 131, 147,
    163, 179, 195, 211, 632, 647, 662, 633, 648, 663, 634, 649, 664, 219, 230, 240, 250, 260, 270, 220,
    231, 241, 251, 261, 271, 221, 232, 242, 252, 262, 272, 228, 273, 287, 300, 313, 323, 334, 279, 293,
    306, 317, 327, 338, 280, 294, 307, 318, 328, 339, 281, 295, 308, 319, 329, 340, 282, 296, 309, 320,
    330, 341, 283, 297, 310, 321, 331, 342, 284, 298, 311, 322, 332, 343, 668, 678, 669, 679, 670, 680,
    671, 681, 672, 682, 673, 683, 218, 229, 239, 249, 259, 269, 274, 288, 301, 324, 335, 275, 289, 302,
    314, 336, 276, 290, 303, 315, 325, 291, 304, 316, 277, 305, 326, 278, 292, 337, 665, 675, 676, 666,
    667, 677, 345, 355, 364, 373, 382, 391, 346, 356, 365, 374, 383, 392, 347, 357, 366, 375, 384, 393,
    348, 358, 367, 376, 385, 394, 349, 359, 368, 377, 386, 395, 350, 360, 369, 378, 387, 396, 285, 312,
    333, 286, 299, 344, 674, 684, 353, 362, 371, 380, 389, 398, 354, 363, 372, 381, 390, 399, 351, 400,
    408, 417, 426, 434, 443, 402, 411, 420, 428, 437, 446, 403, 412, 421, 429, 438, 447, 404, 413, 422,
    430, 439, 448, 405, 414, 423, 431, 440, 449, 406, 415, 424, 432, 441, 450, 407, 416, 425, 433, 442,
    451, 352, 361, 370, 379, 388, 397, 401, 409, 444, 418, 435, 427, 419, 436, 410, 445, 452, 459, 467,
    474, 481, 488, 453, 460, 468, 475, 482, 489, 454, 461, 469, 476, 483, 490, 455, 462, 470, 477, 484,
    491, 456, 463, 471, 478, 485, 492, 457, 464, 472, 479, 486, 493, 465, 495, 503, 512, 521, 529, 538,
    497, 506, 515, 523, 532, 541, 498, 507, 516, 524, 533, 542, 499, 508, 517, 525, 534, 543, 500, 509,
    518, 526, 535, 544, 501, 510, 519, 527, 536, 545, 502, 511, 520, 528, 537, 546, 458, 466, 473, 480,
    487, 494, 496, 504, 539, 513, 530, 522, 514, 531, 505, 540, 547, 555, 562, 569, 576, 583, 548, 556,
    563, 570, 577, 584, 549, 557, 564, 571, 578, 585, 550, 558, 565, 572, 579, 586, 551, 559, 566, 573,
    580, 587, 552, 560, 567, 574, 581, 588, 553, 590, 596, 602, 608, 612, 616, 554, 561, 568, 575, 582,
    589, 591, 597, 603, 613, 617, 592, 598, 604, 609, 618, 593, 599, 605, 610, 614, 600, 606, 611, 594,
    607, 615, 595, 601, 619,
};
static const int M_OFFSET[SIX_LINK_NLINKS] = { 0, 109, 311, 458, 553, 648 };

/* dae kinematics, links like shoulder: 132 operations */
static six_link_status dae_kinematics_shoulder(const six_link_link_constants *c, six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, const six_link_real twist[6], const six_link_real q[1], six_link_real qdot[1])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real minus_R_rel_xy = six_link_sin(q[0]);

    const six_link_real omega_R_x = R_rel_xx * base->omega[0] + minus_R_rel_xy * base->omega[1];
    const six_link_real omega_R_y = R_rel_xx * base->omega[1] - minus_R_rel_xy * base->omega[0];
    const six_link_real qdot_1 = twist[2] - base->omega[2];

    /* v_R: velocity of the joint point */
    const six_link_real t1 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t2 = base->v[1] + c->mount_xyz_x * base->omega[2] - c->mount_xyz_z * base->omega[0];
    const six_link_real v_R_x = R_rel_xx * t1 + minus_R_rel_xy * t2;
    const six_link_real v_R_y = R_rel_xx * t2 - minus_R_rel_xy * t1;

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_omega_x = omega_R_y * qdot_1;
    const six_link_real minus_beta_omega_y = omega_R_x * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_v_x = qdot_1 * v_R_y;
    const six_link_real minus_beta_v_y = qdot_1 * v_R_x;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - twist[2] * twist[4];
    const six_link_real t3 = twist[2] * twist[3];
    const six_link_real a_0_y = t3 - twist[0] * twist[5];
    const six_link_real t4 = twist[1] * twist[3];
    const six_link_real a_0_z = twist[0] * twist[4] - t4;

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t5 = c->I_s * twist[0];
    const six_link_real H_star_2 = t5 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_3 = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t5 * twist[1];
    const six_link_real H_star_4 = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_6 = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_x = twist[1] * v_T_z - twist[2] * v_T_y;
    const six_link_real a_T_y = t3 - twist[0] * v_T_z;
    const six_link_real a_T_z = twist[0] * v_T_y - t4;

    /* h_T_tau: moment that the bodies' velocities and weight need */
    const six_link_real t6 = c->I_T_zz * twist[2] - c->J_T_xz * twist[0] - c->J_T_yz * twist[1];
    const six_link_real t7 = c->I_T_yy * twist[1] - c->J_T_xy * twist[0] - c->J_T_yz * twist[2];
    const six_link_real h_T_tau_x = c->S_T_y * a_T_z + twist[1] * t6 - c->S_T_z * a_T_y - twist[2] * t7;
    const six_link_real t8 = c->I_T_xx * twist[0] - c->J_T_xy * twist[1] - c->J_T_xz * twist[2];
    const six_link_real h_T_tau_y = c->S_T_z * a_T_x + twist[2] * t8 - c->S_T_x * a_T_z - twist[0] * t6;
    const six_link_real h_T_tau_z = c->S_T_x * a_T_y + twist[0] * t7 - c->S_T_y * a_T_x - twist[1] * t8;

    /* h_T_F: force that the bodies' velocities and weight need */
    const six_link_real t9 = c->S_T_y * twist[0] - c->S_T_x * twist[1];
    const six_link_real t10 = c->S_T_x * twist[2] - c->S_T_z * twist[0];
    const six_link_real h_T_F_x = a_T_x * c->body0_mass + twist[1] * t9 - twist[2] * t10;
    const six_link_real t11 = c->S_T_z * twist[1] - c->S_T_y * twist[2];
    const six_link_real h_T_F_y = a_T_y * c->body0_mass + twist[2] * t11 - twist[0] * t9;
    const six_link_real h_T_F_z = a_T_z * c->body0_mass + twist[0] * t10 - twist[1] * t11;

    /* outputs */
    qdot[0] = qdot_1;
    link->R_rel[0] = R_rel_xx;
    link->R_rel[1] = minus_R_rel_xy;
    link->beta[0] = beta_omega_x;
    link->beta[1] = minus_beta_omega_y;
    link->beta[2] = beta_v_x;
    link->beta[3] = minus_beta_v_y;
    link->h_V[0] = H_star_2;
    link->h_V[1] = H_star_3;
    link->h_V[2] = H_star_4;
    link->h_V[3] = H_star_5;
    link->h_V[4] = H_star_6;
    tip->omega[0] = twist[0];
    tip->omega[1] = twist[1];
    tip->omega[2] = twist[2];
    tip->v[0] = twist[3];
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    link->h_T[0] = h_T_tau_x;
    link->h_T[1] = h_T_tau_y;
    link->h_T[2] = h_T_tau_z;
    link->h_T[3] = h_T_F_x;
    link->h_T[4] = h_T_F_y;
    link->h_T[5] = h_T_F_z;
    return SIX_LINK_OK;
}

/* dae kinematics, links like upper_arm: 502 operations */
static six_link_status dae_kinematics_upper_arm(const six_link_link_constants *c, six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, const six_link_real twist[6], const six_link_real q[1], const six_link_real eta[3],
    const six_link_real etadot[3], six_link_real qdot[1])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real R_rel_xz = six_link_sin(q[0]);

    const six_link_real omega_R_x = R_rel_xx * base->omega[0] - R_rel_xz * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_xx * base->omega[2];
    const six_link_real qdot_1 = twist[1] - base->omega[1];

    /* v_R: velocity of the joint point */
    const six_link_real t1 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t2 = base->v[2] + c->mount_xyz_y * base->omega[0] - c->mount_xyz_x * base->omega[1];
    const six_link_real v_R_x = R_rel_xx * t1 - R_rel_xz * t2;
    const six_link_real v_R_z = R_rel_xz * t1 + R_rel_xx * t2;

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_omega_x = omega_R_z * qdot_1;
    const six_link_real beta_omega_z = omega_R_x * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_v_x = qdot_1 * v_R_z;
    const six_link_real beta_v_z = qdot_1 * v_R_x;

    /* S: first moment */
    const six_link_real S_y = eta[0] * c->sigma_y1;
    const six_link_real S_z = eta[1] * c->sigma_z2;

    /* Sdot: rate of the first moment */
    const six_link_real Sdot_y = etadot[0] * c->sigma_y1;
    const six_link_real Sdot_z = etadot[1] * c->sigma_z2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->M_Wphi_11 * eta[0];
    const six_link_real L_y2 = eta[0] * c->mu;
    const six_link_real L_z1 = eta[1] * c->mu;
    const six_link_real L_z2 = c->M_Wphi_22 * eta[1];

    /* Ldot: rate of L */
    const six_link_real Ldot_y2 = etadot[0] * c->mu;
    const six_link_real Ldot_z1 = etadot[1] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->chi_1 * eta[0];
    const six_link_real J_xz = c->chi_2 * eta[1];
    const six_link_real J_yy = L_y1 * eta[0];
    const six_link_real J_yz = L_z1 * eta[0];
    const six_link_real J_zz = L_z2 * eta[1];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real t3 = twist[1] * twist[1];
    const six_link_real t4 = twist[2] * twist[2];
    const six_link_real minus_Omega_xx = t3 + t4;
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];
    const six_link_real t5 = twist[0] * twist[0];
    const six_link_real minus_Omega_yy = t5 + t4;
    const six_link_real Omega_yz = twist[1] * twist[2];
    const six_link_real minus_Omega_zz = t5 + t3;

    /* B: moment of the elastic velocity */
    const six_link_real B_yx = c->chi_1 * etadot[0];
    const six_link_real B_yy = L_y1 * etadot[0];
    const six_link_real B_yz = L_z1 * etadot[0];
    const six_link_real B_zx = c->chi_2 * etadot[1];
    const six_link_real B_zy = L_y2 * etadot[1];
    const six_link_real B_zz = L_z2 * etadot[1];

    /* h_c: half of the Coriolis wrench */
    const six_link_real h_c_1 = B_yy * twist[0] + B_zz * twist[0];
    const six_link_real h_c_2 = B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const six_link_real h_c_3 = B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const six_link_real h_c_4 = Sdot_z * twist[1] - Sdot_y * twist[2];
    const six_link_real minus_h_c_5 = Sdot_z * twist[0];
    const six_link_real h_c_6 = Sdot_y * twist[0];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const six_link_real h_MD_2 = h_c_2 + etadot[2] * twist[2] * c->sigma_t_3;
    const six_link_real h_MD_3 = h_c_3 - etadot[2] * twist[1] * c->sigma_t_3;

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t6 = h_c_1 + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const six_link_real H_star_1 = t6 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const six_link_real t7 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy + J_zz * Omega_xz
        + S_z * a_0_x;
    const six_link_real t8 = c->I_s * twist[0];
    const six_link_real H_star_2 = t7 + t8 * twist[2] - c->J_0_xx * Omega_xz - J_xy * Omega_yz - c->S_0_x * a_0_z;
    const six_link_real t9 = h_c_3 + c->J_0_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * a_0_y;
    const six_link_real H_star_3 = t9 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t8 * twist[1];
    const six_link_real H_star_4 = h_c_4 - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + a_0_x * c->mu;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x - minus_h_c_5 - minus_Omega_yy * S_y + Omega_yz * S_z
        + a_0_y * c->mu;
    const six_link_real H_star_6 = h_c_6 + Omega_xz * c->S_0_x + Omega_yz * S_y - minus_Omega_zz * S_z
        + a_0_z * c->mu;

    /* h_V: bias of the twist rows */
    const six_link_real h_V_1 = H_star_1 + h_c_1;
    const six_link_real h_V_2 = H_star_2 + h_MD_2;
    const six_link_real h_V_3 = H_star_3 + h_MD_3;
    const six_link_real h_V_4 = H_star_4 + h_c_4;
    const six_link_real h_V_5 = H_star_5 - minus_h_c_5;
    const six_link_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const six_link_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_xy * c->chi_1
        + a_0_y * c->sigma_y1 - Ldot_z1 * 2 * twist[0];
    const six_link_real h_eta_2 = L_y2 * Omega_yz - L_z2 * minus_Omega_zz + Omega_xz * c->chi_2
        + a_0_z * c->sigma_z2 + Ldot_y2 * 2 * twist[0];

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[0] * 2;
    const six_link_real r_T_z = eta[1] * 2;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[2] * REAL(1.4142135623730951);
    const six_link_real theta_y = c->Psi_c_y2 * eta[1];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0];

    /* x: squared angle of the tip section */
    const six_link_real t10 = theta_x * theta_x;
    const six_link_real t11 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t10 + t11;
    const six_link_real t12 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t12;

    /* c1: Stumpff function of order 1 */
    const six_link_real t13 = six_link_c5(x);
    const six_link_real c3 = REAL(0.16666666666666666) - x * t13;
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real t14 = six_link_c4(x);
    const six_link_real c2 = REAL(0.5) - x * t14;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t11 + t12;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t10 + t12;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    const six_link_real t15 = c3 * theta_hat2_12;
    const six_link_real t16 = c2 * theta_z;
    const six_link_real J_l_xy = t15 - t16;
    const six_link_real t17 = c2 * theta_y;
    const six_link_real t18 = c3 * theta_hat2_13;
    const six_link_real J_l_xz = t17 + t18;
    const six_link_real J_l_yx = t16 + t15;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const six_link_real t19 = c3 * theta_hat2_23;
    const six_link_real t20 = c2 * theta_x;
    const six_link_real J_l_yz = t19 - t20;
    const six_link_real J_l_zx = t18 - t17;
    const six_link_real J_l_zy = t20 + t19;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t21 = c2 * theta_hat2_12;
    const six_link_real t22 = c1 * theta_z;
    const six_link_real R_T_xy = t21 - t22;
    const six_link_real t23 = c1 * theta_y;
    const six_link_real t24 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t23 + t24;
    const six_link_real R_T_yx = t22 + t21;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t25 = c2 * theta_hat2_23;
    const six_link_real t26 = c1 * theta_x;
    const six_link_real R_T_yz = t25 - t26;
    const six_link_real R_T_zx = t24 - t23;
    const six_link_real R_T_zy = t26 + t25;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[0] * 2;
    const six_link_real udot_T_z = etadot[1] * 2;

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_x = etadot[2] * REAL(1.4142135623730951);
    const six_link_real thetadot_y = c->Psi_c_y2 * etadot[1];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t27 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real t28 = theta_x * thetadot_y - theta_y * thetadot_x;
    const six_link_real t29 = theta_z * thetadot_x - theta_x * thetadot_z;
    const six_link_real t30 = theta_y * t28 - theta_z * t29;
    const six_link_real omega_s_x = thetadot_x + c2 * t27 + c3 * t30;
    const six_link_real t31 = theta_z * t27 - theta_x * t28;
    const six_link_real omega_s_y = thetadot_y + c2 * t29 + c3 * t31;
    const six_link_real t32 = theta_x * t29 - theta_y * t27;
    const six_link_real omega_s_z = thetadot_z + c2 * t28 + c3 * t32;

    /* xdot: rate of the squared angle */
    const six_link_real xdot = eta[2] * REAL(2.8284271247461903) * thetadot_x + theta_y * 2 * thetadot_y
        + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const six_link_real c2dot = xdot * (t14 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const six_link_real c3dot = xdot * (t13 * REAL(1.5) - t14 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_x = c2dot * t27 + c3 * (thetadot_y * t28 - thetadot_z * t29) + c3dot * t30;
    const six_link_real alpha_s_y = c2dot * t29 + c3 * (thetadot_z * t27 - thetadot_x * t28) + c3dot * t31;
    const six_link_real alpha_s_z = c2dot * t28 + c3 * (thetadot_x * t29 - thetadot_y * t27) + c3dot * t32;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t33 = omega_s_x + twist[0];
    const six_link_real t34 = omega_s_y + twist[1];
    const six_link_real t35 = omega_s_z + twist[2];
    const six_link_real omega_T_x = R_T_xx * t33 + R_T_yx * t34 + R_T_zx * t35;
    const six_link_real omega_T_y = R_T_xy * t33 + R_T_yy * t34 + R_T_zy * t35;
    const six_link_real omega_T_z = R_T_xz * t33 + R_T_yz * t34 + R_T_zz * t35;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t36 = twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const six_link_real t37 = udot_T_y + twist[4] + c->length * twist[2] - twist[0] * r_T_z;
    const six_link_real t38 = udot_T_z + twist[5] + twist[0] * r_T_y - c->length * twist[1];
    const six_link_real v_T_x = R_T_xx * t36 + R_T_yx * t37 + R_T_zx * t38;
    const six_link_real v_T_y = R_T_xy * t36 + R_T_yy * t37 + R_T_zy * t38;
    const six_link_real v_T_z = R_T_xz * t36 + R_T_yz * t37 + R_T_zz * t38;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const six_link_real t39 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const six_link_real t40 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const six_link_real t41 = alpha_s_z + omega_s_y * twist[0] - omega_s_x * twist[1];
    const six_link_real b_omega_x = R_T_xx * t39 + R_T_yx * t40 + R_T_zx * t41;
    const six_link_real b_omega_y = R_T_xy * t39 + R_T_yy * t40 + R_T_zy * t41;
    const six_link_real b_omega_z = R_T_xz * t39 + R_T_yz * t40 + R_T_zz * t41;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const six_link_real t42 = omega_s_z * t37 + twist[1] * udot_T_z - omega_s_y * t38 - twist[2] * udot_T_y;
    const six_link_real t43 = omega_s_x * t38 - omega_s_z * t36 - twist[0] * udot_T_z;
    const six_link_real t44 = omega_s_y * t36 + twist[0] * udot_T_y - omega_s_x * t37;
    const six_link_real b_v_x = R_T_xx * t42 + R_T_yx * t43 + R_T_zx * t44;
    const six_link_real b_v_y = R_T_xy * t42 + R_T_yy * t43 + R_T_zy * t44;
    const six_link_real b_v_z = R_T_xz * t42 + R_T_yz * t43 + R_T_zz * t44;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_x = omega_T_y * v_T_z - omega_T_z * v_T_y;
    const six_link_real a_T_y = omega_T_z * v_T_x - omega_T_x * v_T_z;
    const six_link_real a_T_z = omega_T_x * v_T_y - omega_T_y * v_T_x;

    /* h_T_tau: moment that the bodies' velocities and weight need */
    const six_link_real t45 = c->I_T_zz * omega_T_z - c->J_T_xz * omega_T_x - c->J_T_yz * omega_T_y;
    const six_link_real t46 = c->I_T_yy * omega_T_y - c->J_T_xy * omega_T_x - c->J_T_yz * omega_T_z;
    const six_link_real h_T_tau_x = c->S_T_y * a_T_z + omega_T_y * t45 - c->S_T_z * a_T_y - omega_T_z * t46;
    const six_link_real t47 = c->I_T_xx * omega_T_x - c->J_T_xy * omega_T_y - c->J_T_xz * omega_T_z;
    const six_link_real h_T_tau_y = c->S_T_z * a_T_x + omega_T_z * t47 - c->S_T_x * a_T_z - omega_T_x * t45;
    const six_link_real h_T_tau_z = c->S_T_x * a_T_y + omega_T_x * t46 - c->S_T_y * a_T_x - omega_T_y * t47;

    /* h_T_F: force that the bodies' velocities and weight need */
    const six_link_real t48 = c->S_T_y * omega_T_x - c->S_T_x * omega_T_y;
    const six_link_real t49 = c->S_T_x * omega_T_z - c->S_T_z * omega_T_x;
    const six_link_real h_T_F_x = a_T_x * c->body0_mass + omega_T_y * t48 - omega_T_z * t49;
    const six_link_real t50 = c->S_T_z * omega_T_y - c->S_T_y * omega_T_z;
    const six_link_real h_T_F_y = a_T_y * c->body0_mass + omega_T_z * t50 - omega_T_x * t48;
    const six_link_real h_T_F_z = a_T_z * c->body0_mass + omega_T_x * t49 - omega_T_y * t50;

    /* outputs */
    qdot[0] = qdot_1;
    link->R_rel[0] = R_rel_xx;
    link->R_rel[1] = R_rel_xz;
    link->beta[0] = minus_beta_omega_x;
    link->beta[1] = beta_omega_z;
    link->beta[2] = minus_beta_v_x;
    link->beta[3] = beta_v_z;
    link->M_V[0] = I_xx;
    link->M_V[1] = J_xy;
    link->M_V[2] = J_xz;
    link->M_V[3] = S_z;
    link->M_V[4] = S_y;
    link->M_V[5] = I_yy;
    link->M_V[6] = J_yz;
    link->M_V[7] = I_zz;
    link->M_D[0] = L_z1;
    link->M_D[1] = L_y2;
    link->h_V[0] = h_V_1;
    link->h_V[1] = h_V_2;
    link->h_V[2] = h_V_3;
    link->h_V[3] = h_V_4;
    link->h_V[4] = h_V_5;
    link->h_V[5] = h_V_6;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
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
    link->G[0] = J_l_xx;
    link->G[1] = J_l_xy;
    link->G[2] = J_l_xz;
    link->G[3] = J_l_yx;
    link->G[4] = J_l_yy;
    link->G[5] = J_l_yz;
    link->G[6] = J_l_zx;
    link->G[7] = J_l_zy;
    link->G[8] = J_l_zz;
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
    link->h_T[0] = h_T_tau_x;
    link->h_T[1] = h_T_tau_y;
    link->h_T[2] = h_T_tau_z;
    link->h_T[3] = h_T_F_x;
    link->h_T[4] = h_T_F_y;
    link->h_T[5] = h_T_F_z;
    return SIX_LINK_OK;
}

/* dae kinematics, links like forearm: 405 operations */
static six_link_status dae_kinematics_forearm(const six_link_link_constants *c, six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, const six_link_real twist[6], const six_link_real q[1], const six_link_real eta[2],
    const six_link_real etadot[2], six_link_real qdot[1])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real t1 = six_link_cos(q[0]);
    const six_link_real t2 = six_link_sin(q[0]);
    const six_link_real R_rel_xx = c->R_m_xx * t1 - c->R_m_xz * t2;
    const six_link_real R_rel_xz = c->R_m_xx * t2 + c->R_m_xz * t1;
    const six_link_real R_rel_yx = c->R_m_yx * t1 - c->R_m_yz * t2;
    const six_link_real R_rel_yz = c->R_m_yx * t2 + c->R_m_yz * t1;
    const six_link_real R_rel_zx = c->R_m_zx * t1 - c->R_m_zz * t2;
    const six_link_real R_rel_zz = c->R_m_zx * t2 + c->R_m_zz * t1;

    const six_link_real omega_R_x = R_rel_xx * base->omega[0] + R_rel_yx * base->omega[1]
        + R_rel_zx * base->omega[2];
    const six_link_real omega_R_y = c->R_m_xy * base->omega[0] + c->R_m_yy * base->omega[1]
        + c->R_m_zy * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_yz * base->omega[1]
        + R_rel_zz * base->omega[2];
    const six_link_real qdot_1 = twist[1] - omega_R_y;

    /* v_R: velocity of the joint point */
    const six_link_real t3 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t4 = base->v[1] + c->mount_xyz_x * base->omega[2] - c->mount_xyz_z * base->omega[0];
    const six_link_real t5 = base->v[2] + c->mount_xyz_y * base->omega[0] - c->mount_xyz_x * base->omega[1];
    const six_link_real v_R_x = R_rel_xx * t3 + R_rel_yx * t4 + R_rel_zx * t5;
    const six_link_real v_R_z = R_rel_xz * t3 + R_rel_yz * t4 + R_rel_zz * t5;

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_omega_x = omega_R_z * qdot_1;
    const six_link_real beta_omega_z = omega_R_x * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_v_x = qdot_1 * v_R_z;
    const six_link_real beta_v_z = qdot_1 * v_R_x;

    /* S: first moment */
    const six_link_real S_y = c->S_B_y + eta[0] * c->sigma_y1;
    const six_link_real S_z = c->S_B_z + eta[1] * c->sigma_z2;

    /* Sdot: rate of the first moment */
    const six_link_real Sdot_y = etadot[0] * c->sigma_y1;
    const six_link_real Sdot_z = etadot[1] * c->sigma_z2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->M_Wphi_11 * eta[0];
    const six_link_real L_y2 = eta[0] * c->mu;
    const six_link_real L_z1 = eta[1] * c->mu;
    const six_link_real L_z2 = c->M_Wphi_22 * eta[1];

    /* Ldot: rate of L */
    const six_link_real Ldot_y2 = etadot[0] * c->mu;
    const six_link_real Ldot_z1 = etadot[1] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->J_B_xy + c->chi_1 * eta[0];
    const six_link_real J_xz = c->J_B_xz + c->chi_2 * eta[1];
    const six_link_real J_yy = c->J_B_yy + L_y1 * eta[0];
    const six_link_real J_yz = c->J_B_yz + L_z1 * eta[0];
    const six_link_real J_zz = c->J_B_zz + L_z2 * eta[1];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real t6 = twist[1] * twist[1];
    const six_link_real t7 = twist[2] * twist[2];
    const six_link_real minus_Omega_xx = t6 + t7;
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];
    const six_link_real t8 = twist[0] * twist[0];
    const six_link_real minus_Omega_yy = t8 + t7;
    const six_link_real Omega_yz = twist[1] * twist[2];
    const six_link_real minus_Omega_zz = t8 + t6;

    /* B: moment of the elastic velocity */
    const six_link_real B_yx = c->chi_1 * etadot[0];
    const six_link_real B_yy = L_y1 * etadot[0];
    const six_link_real B_yz = L_z1 * etadot[0];
    const six_link_real B_zx = c->chi_2 * etadot[1];
    const six_link_real B_zy = L_y2 * etadot[1];
    const six_link_real B_zz = L_z2 * etadot[1];

    /* h_c: half of the Coriolis wrench */
    const six_link_real h_c_1 = B_yy * twist[0] + B_zz * twist[0];
    const six_link_real h_c_2 = B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const six_link_real h_c_3 = B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const six_link_real h_c_4 = Sdot_z * twist[1] - Sdot_y * twist[2];
    const six_link_real minus_h_c_5 = Sdot_z * twist[0];
    const six_link_real h_c_6 = Sdot_y * twist[0];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t9 = h_c_1 + J_xy * Omega_xz + J_yy * Omega_yz + J_yz * (minus_Omega_yy - minus_Omega_zz)
        + S_y * a_0_z;
    const six_link_real H_star_1 = t9 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const six_link_real t10 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy
        + J_zz * Omega_xz + S_z * a_0_x;
    const six_link_real t11 = c->I_s * twist[0];
    const six_link_real H_star_2 = t10 + t11 * twist[2] - c->J_0_xx * Omega_xz - J_xy * Omega_yz
        - c->S_0_x * a_0_z;
    const six_link_real t12 = h_c_3 + c->J_0_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * a_0_y;
    const six_link_real H_star_3 = t12 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t11 * twist[1];
    const six_link_real H_star_4 = h_c_4 - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + a_0_x * c->m;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x - minus_h_c_5 - minus_Omega_yy * S_y + Omega_yz * S_z
        + a_0_y * c->m;
    const six_link_real H_star_6 = h_c_6 + Omega_xz * c->S_0_x + Omega_yz * S_y - minus_Omega_zz * S_z
        + a_0_z * c->m;

    /* h_V: bias of the twist rows */
    const six_link_real h_V_1 = H_star_1 + h_c_1;
    const six_link_real h_V_2 = H_star_2 + h_c_2;
    const six_link_real h_V_3 = H_star_3 + h_c_3;
    const six_link_real h_V_4 = H_star_4 + h_c_4;
    const six_link_real h_V_5 = H_star_5 - minus_h_c_5;
    const six_link_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const six_link_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_xy * c->chi_1
        + a_0_y * c->sigma_y1 - Ldot_z1 * 2 * twist[0];
    const six_link_real h_eta_2 = L_y2 * Omega_yz - L_z2 * minus_Omega_zz + Omega_xz * c->chi_2
        + a_0_z * c->sigma_z2 + Ldot_y2 * 2 * twist[0];

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[0] * REAL(2.23606797749979);
    const six_link_real r_T_z = eta[1] * REAL(2.23606797749979);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y2 * eta[1];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const six_link_real t13 = six_link_c5(x);
    const six_link_real c3 = REAL(0.16666666666666666) - x * t13;
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real t14 = six_link_c4(x);
    const six_link_real c2 = REAL(0.5) - x * t14;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real minus_J_l_xy = c2 * theta_z;
    const six_link_real J_l_xz = c2 * theta_y;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const six_link_real J_l_yz = c3 * theta_hat2_23;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real minus_R_T_xy = c1 * theta_z;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[0] * REAL(2.23606797749979);
    const six_link_real udot_T_z = etadot[1] * REAL(2.23606797749979);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_y = c->Psi_c_y2 * etadot[1];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t15 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real omega_s_x = c2 * t15;
    const six_link_real omega_s_y = thetadot_y + c3 * theta_z * t15;
    const six_link_real omega_s_z = thetadot_z - c3 * theta_y * t15;

    /* xdot: rate of the squared angle */
    const six_link_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const six_link_real c2dot = xdot * (t14 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const six_link_real c3dot = xdot * (t13 * REAL(1.5) - t14 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_x = c2dot * t15;
    const six_link_real alpha_s_y = c3 * thetadot_z * t15 + c3dot * theta_z * t15;
    const six_link_real minus_alpha_s_z = c3 * thetadot_y * t15 + c3dot * theta_y * t15;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t16 = omega_s_x + twist[0];
    const six_link_real t17 = omega_s_y + twist[1];
    const six_link_real t18 = omega_s_z + twist[2];
    const six_link_real omega_T_x = R_T_xx * t16 + minus_R_T_xy * t17 - R_T_xz * t18;
    const six_link_real omega_T_y = R_T_yy * t17 - minus_R_T_xy * t16 + R_T_yz * t18;
    const six_link_real omega_T_z = R_T_xz * t16 + R_T_yz * t17 + R_T_zz * t18;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t19 = twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const six_link_real t20 = udot_T_y + twist[4] + c->length * twist[2] - twist[0] * r_T_z;
    const six_link_real t21 = udot_T_z + twist[5] + twist[0] * r_T_y - c->length * twist[1];
    const six_link_real v_T_x = R_T_xx * t19 + minus_R_T_xy * t20 - R_T_xz * t21;
    const six_link_real v_T_y = R_T_yy * t20 - minus_R_T_xy * t19 + R_T_yz * t21;
    const six_link_real v_T_z = R_T_xz * t19 + R_T_yz * t20 + R_T_zz * t21;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const six_link_real t22 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const six_link_real t23 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const six_link_real t24 = omega_s_y * twist[0] - minus_alpha_s_z - omega_s_x * twist[1];
    const six_link_real b_omega_x = R_T_xx * t22 + minus_R_T_xy * t23 - R_T_xz * t24;
    const six_link_real b_omega_y = R_T_yy * t23 - minus_R_T_xy * t22 + R_T_yz * t24;
    const six_link_real b_omega_z = R_T_xz * t22 + R_T_yz * t23 + R_T_zz * t24;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const six_link_real t25 = omega_s_z * t20 + twist[1] * udot_T_z - omega_s_y * t21 - twist[2] * udot_T_y;
    const six_link_real t26 = omega_s_x * t21 - omega_s_z * t19 - twist[0] * udot_T_z;
    const six_link_real t27 = omega_s_y * t19 + twist[0] * udot_T_y - omega_s_x * t20;
    const six_link_real b_v_x = R_T_xx * t25 + minus_R_T_xy * t26 - R_T_xz * t27;
    const six_link_real b_v_y = R_T_yy * t26 - minus_R_T_xy * t25 + R_T_yz * t27;
    const six_link_real b_v_z = R_T_xz * t25 + R_T_yz * t26 + R_T_zz * t27;

    /* outputs */
    qdot[0] = qdot_1;
    link->R_rel[0] = R_rel_xx;
    link->R_rel[1] = R_rel_xz;
    link->R_rel[2] = R_rel_yx;
    link->R_rel[3] = R_rel_yz;
    link->R_rel[4] = R_rel_zx;
    link->R_rel[5] = R_rel_zz;
    link->beta[0] = minus_beta_omega_x;
    link->beta[1] = beta_omega_z;
    link->beta[2] = minus_beta_v_x;
    link->beta[3] = beta_v_z;
    link->M_V[0] = I_xx;
    link->M_V[1] = J_xy;
    link->M_V[2] = J_xz;
    link->M_V[3] = S_z;
    link->M_V[4] = S_y;
    link->M_V[5] = I_yy;
    link->M_V[6] = J_yz;
    link->M_V[7] = I_zz;
    link->M_D[0] = L_z1;
    link->M_D[1] = L_y2;
    link->h_V[0] = h_V_1;
    link->h_V[1] = h_V_2;
    link->h_V[2] = h_V_3;
    link->h_V[3] = h_V_4;
    link->h_V[4] = h_V_5;
    link->h_V[5] = h_V_6;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
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
    return SIX_LINK_OK;
}

/* dae kinematics, links like wrist_roll: 57 operations */
static six_link_status dae_kinematics_wrist_roll(const six_link_link_constants *c, six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, const six_link_real twist[6], const six_link_real q[1], six_link_real qdot[1])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_yy = six_link_cos(q[0]);
    const six_link_real minus_R_rel_yz = six_link_sin(q[0]);

    const six_link_real omega_R_y = R_rel_yy * base->omega[1] + minus_R_rel_yz * base->omega[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega[2] - minus_R_rel_yz * base->omega[1];
    const six_link_real qdot_1 = twist[0] - base->omega[0];

    /* v_R: velocity of the joint point */
    const six_link_real v_R_y = R_rel_yy * base->v[1] + minus_R_rel_yz * base->v[2];
    const six_link_real v_R_z = R_rel_yy * base->v[2] - minus_R_rel_yz * base->v[1];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_omega_y = omega_R_z * qdot_1;
    const six_link_real minus_beta_omega_z = omega_R_y * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_v_y = qdot_1 * v_R_z;
    const six_link_real minus_beta_v_z = qdot_1 * v_R_y;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t1 = c->I_s * twist[0];
    const six_link_real H_star_2 = t1 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_3 = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t1 * twist[1];
    const six_link_real H_star_4 = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_6 = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* outputs */
    qdot[0] = qdot_1;
    link->R_rel[0] = R_rel_yy;
    link->R_rel[1] = minus_R_rel_yz;
    link->beta[0] = beta_omega_y;
    link->beta[1] = minus_beta_omega_z;
    link->beta[2] = beta_v_y;
    link->beta[3] = minus_beta_v_z;
    link->h_V[0] = H_star_2;
    link->h_V[1] = H_star_3;
    link->h_V[2] = H_star_4;
    link->h_V[3] = H_star_5;
    link->h_V[4] = H_star_6;
    tip->omega[0] = twist[0];
    tip->omega[1] = twist[1];
    tip->omega[2] = twist[2];
    tip->v[0] = twist[3];
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    return SIX_LINK_OK;
}

/* dae kinematics, links like wrist_pitch: 57 operations */
static six_link_status dae_kinematics_wrist_pitch(const six_link_link_constants *c, six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, const six_link_real twist[6], const six_link_real q[1], six_link_real qdot[1])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real R_rel_xz = six_link_sin(q[0]);

    const six_link_real omega_R_x = R_rel_xx * base->omega[0] - R_rel_xz * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_xx * base->omega[2];
    const six_link_real qdot_1 = twist[1] - base->omega[1];

    /* v_R: velocity of the joint point */
    const six_link_real v_R_x = R_rel_xx * base->v[0] - R_rel_xz * base->v[2];
    const six_link_real v_R_z = R_rel_xz * base->v[0] + R_rel_xx * base->v[2];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_omega_x = omega_R_z * qdot_1;
    const six_link_real beta_omega_z = omega_R_x * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_v_x = qdot_1 * v_R_z;
    const six_link_real beta_v_z = qdot_1 * v_R_x;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t1 = c->I_s * twist[0];
    const six_link_real H_star_2 = t1 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_3 = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t1 * twist[1];
    const six_link_real H_star_4 = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_6 = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* outputs */
    qdot[0] = qdot_1;
    link->R_rel[0] = R_rel_xx;
    link->R_rel[1] = R_rel_xz;
    link->beta[0] = minus_beta_omega_x;
    link->beta[1] = beta_omega_z;
    link->beta[2] = minus_beta_v_x;
    link->beta[3] = beta_v_z;
    link->h_V[0] = H_star_2;
    link->h_V[1] = H_star_3;
    link->h_V[2] = H_star_4;
    link->h_V[3] = H_star_5;
    link->h_V[4] = H_star_6;
    tip->omega[0] = twist[0];
    tip->omega[1] = twist[1];
    tip->omega[2] = twist[2];
    tip->v[0] = twist[3];
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    return SIX_LINK_OK;
}

/* dae kinematics, links like flange: 124 operations */
static six_link_status dae_kinematics_flange(const six_link_link_constants *c, six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, const six_link_real twist[6], const six_link_real q[1], six_link_real qdot[1])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_yy = six_link_cos(q[0]);
    const six_link_real minus_R_rel_yz = six_link_sin(q[0]);

    const six_link_real omega_R_y = R_rel_yy * base->omega[1] + minus_R_rel_yz * base->omega[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega[2] - minus_R_rel_yz * base->omega[1];
    const six_link_real qdot_1 = twist[0] - base->omega[0];

    /* v_R: velocity of the joint point */
    const six_link_real v_R_y = R_rel_yy * base->v[1] + minus_R_rel_yz * base->v[2];
    const six_link_real v_R_z = R_rel_yy * base->v[2] - minus_R_rel_yz * base->v[1];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_omega_y = omega_R_z * qdot_1;
    const six_link_real minus_beta_omega_z = omega_R_y * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_v_y = qdot_1 * v_R_z;
    const six_link_real minus_beta_v_z = qdot_1 * v_R_y;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - twist[2] * twist[4];
    const six_link_real t1 = twist[2] * twist[3];
    const six_link_real a_0_y = t1 - twist[0] * twist[5];
    const six_link_real t2 = twist[1] * twist[3];
    const six_link_real a_0_z = twist[0] * twist[4] - t2;

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t3 = c->I_s * twist[0];
    const six_link_real H_star_2 = t3 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_3 = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t3 * twist[1];
    const six_link_real H_star_4 = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_6 = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_x = twist[1] * v_T_z - twist[2] * v_T_y;
    const six_link_real a_T_y = t1 - twist[0] * v_T_z;
    const six_link_real a_T_z = twist[0] * v_T_y - t2;

    /* h_T_tau: moment that the bodies' velocities and weight need */
    const six_link_real t4 = c->I_T_zz * twist[2] - c->J_T_xz * twist[0] - c->J_T_yz * twist[1];
    const six_link_real t5 = c->I_T_yy * twist[1] - c->J_T_xy * twist[0] - c->J_T_yz * twist[2];
    const six_link_real h_T_tau_x = c->S_T_y * a_T_z + twist[1] * t4 - c->S_T_z * a_T_y - twist[2] * t5;
    const six_link_real t6 = c->I_T_xx * twist[0] - c->J_T_xy * twist[1] - c->J_T_xz * twist[2];
    const six_link_real h_T_tau_y = c->S_T_z * a_T_x + twist[2] * t6 - c->S_T_x * a_T_z - twist[0] * t4;
    const six_link_real h_T_tau_z = c->S_T_x * a_T_y + twist[0] * t5 - c->S_T_y * a_T_x - twist[1] * t6;

    /* h_T_F: force that the bodies' velocities and weight need */
    const six_link_real t7 = c->S_T_y * twist[0] - c->S_T_x * twist[1];
    const six_link_real t8 = c->S_T_x * twist[2] - c->S_T_z * twist[0];
    const six_link_real h_T_F_x = a_T_x * c->body0_mass + twist[1] * t7 - twist[2] * t8;
    const six_link_real t9 = c->S_T_z * twist[1] - c->S_T_y * twist[2];
    const six_link_real h_T_F_y = a_T_y * c->body0_mass + twist[2] * t9 - twist[0] * t7;
    const six_link_real h_T_F_z = a_T_z * c->body0_mass + twist[0] * t8 - twist[1] * t9;

    /* outputs */
    qdot[0] = qdot_1;
    link->R_rel[0] = R_rel_yy;
    link->R_rel[1] = minus_R_rel_yz;
    link->beta[0] = beta_omega_y;
    link->beta[1] = minus_beta_omega_z;
    link->beta[2] = beta_v_y;
    link->beta[3] = minus_beta_v_z;
    link->h_V[0] = H_star_2;
    link->h_V[1] = H_star_3;
    link->h_V[2] = H_star_4;
    link->h_V[3] = H_star_5;
    link->h_V[4] = H_star_6;
    tip->omega[0] = twist[0];
    tip->omega[1] = twist[1];
    tip->omega[2] = twist[2];
    tip->v[0] = twist[3];
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    link->h_T[0] = h_T_tau_x;
    link->h_T[1] = h_T_tau_y;
    link->h_T[2] = h_T_tau_z;
    link->h_T[3] = h_T_F_x;
    link->h_T[4] = h_T_F_y;
    link->h_T[5] = h_T_F_z;
    return SIX_LINK_OK;
}

/* eliminate, links like shoulder: 381 operations */
static six_link_status eliminate_shoulder(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base,
    const six_link_node *tip, const six_link_real w_ext[6], const six_link_real tau[1],
    const six_link_real qdot[1])
{

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real Lambda_T_11 = tip->Lambda[0] + c->I_T_xx;
    const six_link_real Lambda_T_12 = tip->Lambda[1] - c->J_T_xy;
    const six_link_real Lambda_T_13 = tip->Lambda[2] - c->J_T_xz;
    const six_link_real Lambda_T_15 = tip->Lambda[4] - c->S_T_z;
    const six_link_real Lambda_T_16 = tip->Lambda[5] + c->S_T_y;
    const six_link_real Lambda_T_22 = tip->Lambda[6] + c->I_T_yy;
    const six_link_real Lambda_T_23 = tip->Lambda[7] - c->J_T_yz;
    const six_link_real Lambda_T_24 = tip->Lambda[8] + c->S_T_z;
    const six_link_real Lambda_T_26 = tip->Lambda[10] - c->S_T_x;
    const six_link_real Lambda_T_33 = tip->Lambda[11] + c->I_T_zz;
    const six_link_real Lambda_T_34 = tip->Lambda[12] - c->S_T_y;
    const six_link_real Lambda_T_35 = tip->Lambda[13] + c->S_T_x;
    const six_link_real Lambda_T_44 = tip->Lambda[15] + c->body0_mass;
    const six_link_real Lambda_T_55 = tip->Lambda[18] + c->body0_mass;
    const six_link_real Lambda_T_66 = tip->Lambda[20] + c->body0_mass;
    const six_link_real p_T_1 = tip->p[0] + link->h_T[0] - w_ext[0];
    const six_link_real p_T_2 = tip->p[1] + link->h_T[1] - w_ext[1];
    const six_link_real p_T_3 = tip->p[2] + link->h_T[2] - w_ext[2];
    const six_link_real p_T_4 = tip->p[3] + link->h_T[3] - w_ext[3];
    const six_link_real p_T_5 = tip->p[4] + link->h_T[4] - w_ext[4];
    const six_link_real p_T_6 = tip->p[5] + link->h_T[5] - w_ext[5];

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t1 = c->length * tip->Lambda[19];
    const six_link_real M_loaded_24 = Lambda_T_24 - c->length * tip->Lambda[17];
    const six_link_real M_loaded_25 = tip->Lambda[9] - t1;
    const six_link_real t2 = Lambda_T_26 - c->length * Lambda_T_66;
    const six_link_real M_loaded_34 = Lambda_T_34 + c->length * tip->Lambda[16];
    const six_link_real t3 = Lambda_T_35 + c->length * Lambda_T_55;
    const six_link_real M_loaded_36 = tip->Lambda[14] + t1;
    const six_link_real M_loaded_12 = Lambda_T_12 - Lambda_T_16 * c->length;
    const six_link_real M_loaded_13 = Lambda_T_13 + Lambda_T_15 * c->length;
    const six_link_real M_loaded_23 = Lambda_T_23 + tip->Lambda[9] * c->length - c->length * M_loaded_36;
    const six_link_real M_loaded_11 = c->I_s + Lambda_T_11;
    const six_link_real M_loaded_22 = c->J_0_xx + (Lambda_T_22 - Lambda_T_26 * c->length - c->length * t2);
    const six_link_real M_loaded_26 = t2 - c->S_0_x;
    const six_link_real M_loaded_33 = c->J_0_xx + (Lambda_T_33 + Lambda_T_35 * c->length + c->length * t3);
    const six_link_real M_loaded_35 = c->S_0_x + t3;
    const six_link_real M_loaded_44 = c->mu + Lambda_T_44;
    const six_link_real M_loaded_55 = c->mu + Lambda_T_55;
    const six_link_real M_loaded_66 = c->mu + Lambda_T_66;
    const six_link_real h_loaded_2 = link->h_V[0] + (p_T_2 - c->length * p_T_6);
    const six_link_real h_loaded_3 = link->h_V[1] + (p_T_3 + c->length * p_T_5);
    const six_link_real h_loaded_4 = link->h_V[2] + p_T_4;
    const six_link_real h_loaded_5 = link->h_V[3] + p_T_5;
    const six_link_real h_loaded_6 = link->h_V[4] + p_T_6;

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real t4 = M_loaded_11 * link->beta[0] - M_loaded_12 * link->beta[1]
        + tip->Lambda[3] * link->beta[2] - Lambda_T_15 * link->beta[3];
    const six_link_real t5 = M_loaded_12 * link->beta[0] - M_loaded_22 * link->beta[1]
        + M_loaded_24 * link->beta[2] - M_loaded_25 * link->beta[3];
    const six_link_real t6 = M_loaded_13 * link->beta[0] - M_loaded_23 * link->beta[1]
        + M_loaded_34 * link->beta[2] - M_loaded_35 * link->beta[3];
    const six_link_real t7 = tip->Lambda[3] * link->beta[0] - M_loaded_24 * link->beta[1]
        + M_loaded_44 * link->beta[2] - tip->Lambda[16] * link->beta[3];
    const six_link_real t8 = Lambda_T_15 * link->beta[0] - M_loaded_25 * link->beta[1]
        + tip->Lambda[16] * link->beta[2] - M_loaded_55 * link->beta[3];
    const six_link_real t9 = Lambda_T_16 * link->beta[0] - M_loaded_26 * link->beta[1]
        + tip->Lambda[17] * link->beta[2] - tip->Lambda[19] * link->beta[3];
    const six_link_real bias_1 = p_T_1 + t4;
    const six_link_real bias_2 = h_loaded_2 + t5;
    const six_link_real bias_3 = h_loaded_3 + t6;
    const six_link_real bias_4 = h_loaded_4 + t7;
    const six_link_real bias_5 = h_loaded_5 + t8;
    const six_link_real bias_6 = h_loaded_6 + t9;
    const six_link_real joint_inertia_11 = M_loaded_33 + c->armature_1;
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8 * (M_loaded_11 + M_loaded_22 + M_loaded_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_loaded_13 * joint_inverse_1;
    const six_link_real joint_W_12 = M_loaded_23 * joint_inverse_1;
    const six_link_real joint_W_13 = M_loaded_33 * joint_inverse_1;
    const six_link_real joint_W_14 = M_loaded_34 * joint_inverse_1;
    const six_link_real joint_W_15 = M_loaded_35 * joint_inverse_1;
    const six_link_real joint_W_16 = M_loaded_36 * joint_inverse_1;
    const six_link_real joint_w_1 = (tau[0] - c->joint_damping_1 * qdot[0] - bias_3) * joint_inverse_1;
    const six_link_real Lambda_i_11 = M_loaded_11 - M_loaded_13 * joint_W_11;
    const six_link_real Lambda_i_12 = M_loaded_12 - M_loaded_13 * joint_W_12;
    const six_link_real Lambda_i_13 = M_loaded_13 - M_loaded_13 * joint_W_13;
    const six_link_real Lambda_i_14 = tip->Lambda[3] - M_loaded_13 * joint_W_14;
    const six_link_real Lambda_i_15 = Lambda_T_15 - M_loaded_13 * joint_W_15;
    const six_link_real Lambda_i_16 = Lambda_T_16 - M_loaded_13 * joint_W_16;
    const six_link_real Lambda_i_22 = M_loaded_22 - M_loaded_23 * joint_W_12;
    const six_link_real Lambda_i_23 = M_loaded_23 - M_loaded_23 * joint_W_13;
    const six_link_real Lambda_i_24 = M_loaded_24 - M_loaded_23 * joint_W_14;
    const six_link_real Lambda_i_25 = M_loaded_25 - M_loaded_23 * joint_W_15;
    const six_link_real Lambda_i_26 = M_loaded_26 - M_loaded_23 * joint_W_16;
    const six_link_real Lambda_i_33 = M_loaded_33 - M_loaded_33 * joint_W_13;
    const six_link_real Lambda_i_34 = M_loaded_34 - M_loaded_33 * joint_W_14;
    const six_link_real Lambda_i_35 = M_loaded_35 - M_loaded_33 * joint_W_15;
    const six_link_real Lambda_i_36 = M_loaded_36 - M_loaded_33 * joint_W_16;
    const six_link_real Lambda_i_44 = M_loaded_44 - M_loaded_34 * joint_W_14;
    const six_link_real Lambda_i_45 = tip->Lambda[16] - M_loaded_34 * joint_W_15;
    const six_link_real Lambda_i_46 = tip->Lambda[17] - M_loaded_34 * joint_W_16;
    const six_link_real Lambda_i_55 = M_loaded_55 - M_loaded_35 * joint_W_15;
    const six_link_real Lambda_i_56 = tip->Lambda[19] - M_loaded_35 * joint_W_16;
    const six_link_real Lambda_i_66 = M_loaded_66 - M_loaded_36 * joint_W_16;
    const six_link_real p_i_1 = bias_1 + M_loaded_13 * joint_w_1;
    const six_link_real p_i_2 = bias_2 + M_loaded_23 * joint_w_1;
    const six_link_real p_i_3 = bias_3 + M_loaded_33 * joint_w_1;
    const six_link_real p_i_4 = bias_4 + M_loaded_34 * joint_w_1;
    const six_link_real p_i_5 = bias_5 + M_loaded_35 * joint_w_1;
    const six_link_real p_i_6 = bias_6 + M_loaded_36 * joint_w_1;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t10 = Lambda_i_12 * link->R_rel[1];
    const six_link_real t11 = Lambda_i_12 * link->R_rel[0];
    const six_link_real t12 = Lambda_i_11 * link->R_rel[1] + t11;
    const six_link_real t13 = t10 + Lambda_i_22 * link->R_rel[0];
    const six_link_real t14 = link->R_rel[0] * (Lambda_i_11 * link->R_rel[0] - t10)
        - link->R_rel[1] * (t11 - Lambda_i_22 * link->R_rel[1]);
    const six_link_real t15 = Lambda_i_14 * link->R_rel[0] - Lambda_i_15 * link->R_rel[1];
    const six_link_real t16 = Lambda_i_14 * link->R_rel[1] + Lambda_i_15 * link->R_rel[0];
    const six_link_real t17 = Lambda_i_24 * link->R_rel[0] - Lambda_i_25 * link->R_rel[1];
    const six_link_real t18 = Lambda_i_24 * link->R_rel[1] + Lambda_i_25 * link->R_rel[0];
    const six_link_real t19 = Lambda_i_34 * link->R_rel[0] - Lambda_i_35 * link->R_rel[1];
    const six_link_real t20 = Lambda_i_34 * link->R_rel[1] + Lambda_i_35 * link->R_rel[0];
    const six_link_real t21 = link->R_rel[0] * t15 - link->R_rel[1] * t17;
    const six_link_real t22 = link->R_rel[0] * t16 - link->R_rel[1] * t18;
    const six_link_real t23 = link->R_rel[0] * Lambda_i_16 - link->R_rel[1] * Lambda_i_26;
    const six_link_real t24 = link->R_rel[1] * t15 + link->R_rel[0] * t17;
    const six_link_real t25 = link->R_rel[1] * t16 + link->R_rel[0] * t18;
    const six_link_real t26 = link->R_rel[1] * Lambda_i_16 + link->R_rel[0] * Lambda_i_26;
    const six_link_real t27 = Lambda_i_45 * link->R_rel[1];
    const six_link_real t28 = Lambda_i_45 * link->R_rel[0];
    const six_link_real t29 = Lambda_i_44 * link->R_rel[1] + t28;
    const six_link_real t30 = t27 + Lambda_i_55 * link->R_rel[0];
    const six_link_real Lambda_18 = Lambda_i_46 * link->R_rel[0] - Lambda_i_56 * link->R_rel[1];
    const six_link_real Lambda_20 = Lambda_i_46 * link->R_rel[1] + Lambda_i_56 * link->R_rel[0];
    const six_link_real Lambda_16 = link->R_rel[0] * (Lambda_i_44 * link->R_rel[0] - t27)
        - link->R_rel[1] * (t28 - Lambda_i_55 * link->R_rel[1]);
    const six_link_real Lambda_17 = link->R_rel[0] * t29 - link->R_rel[1] * t30;
    const six_link_real Lambda_19 = link->R_rel[1] * t29 + link->R_rel[0] * t30;
    const six_link_real t31 = c->mount_xyz_z * Lambda_17;
    const six_link_real t32 = c->mount_xyz_y * Lambda_18;
    const six_link_real t33 = c->mount_xyz_x * Lambda_20;
    const six_link_real Lambda_4 = t21 + (t32 - t31);
    const six_link_real Lambda_5 = t22 + (c->mount_xyz_y * Lambda_20 - c->mount_xyz_z * Lambda_19);
    const six_link_real Lambda_6 = t23 + (c->mount_xyz_y * Lambda_i_66 - c->mount_xyz_z * Lambda_20);
    const six_link_real Lambda_9 = t24 + (c->mount_xyz_z * Lambda_16 - c->mount_xyz_x * Lambda_18);
    const six_link_real Lambda_10 = t25 + (t31 - t33);
    const six_link_real Lambda_11 = t26 + (c->mount_xyz_z * Lambda_18 - c->mount_xyz_x * Lambda_i_66);
    const six_link_real Lambda_13 = t19 + (c->mount_xyz_x * Lambda_17 - c->mount_xyz_y * Lambda_16);
    const six_link_real Lambda_14 = t20 + (c->mount_xyz_x * Lambda_19 - c->mount_xyz_y * Lambda_17);
    const six_link_real Lambda_15 = Lambda_i_36 + (t33 - t32);
    const six_link_real Lambda_1 = t14 - (t22 * c->mount_xyz_z - t23 * c->mount_xyz_y)
        + (c->mount_xyz_y * Lambda_6 - c->mount_xyz_z * Lambda_5);
    const six_link_real Lambda_2 = link->R_rel[0] * t12 - link->R_rel[1] * t13
        - (t23 * c->mount_xyz_x - t21 * c->mount_xyz_z)
        + (c->mount_xyz_y * Lambda_11 - c->mount_xyz_z * Lambda_10);
    const six_link_real t34 = Lambda_i_13 * link->R_rel[0] - Lambda_i_23 * link->R_rel[1]
        - (t21 * c->mount_xyz_y - t22 * c->mount_xyz_x);
    const six_link_real Lambda_3 = t34 + (c->mount_xyz_y * Lambda_15 - c->mount_xyz_z * Lambda_14);
    const six_link_real Lambda_7 = link->R_rel[1] * t12 + link->R_rel[0] * t13
        - (t26 * c->mount_xyz_x - t24 * c->mount_xyz_z)
        + (c->mount_xyz_z * Lambda_9 - c->mount_xyz_x * Lambda_11);
    const six_link_real t35 = Lambda_i_13 * link->R_rel[1] + Lambda_i_23 * link->R_rel[0]
        - (t24 * c->mount_xyz_y - t25 * c->mount_xyz_x);
    const six_link_real Lambda_8 = t35 + (c->mount_xyz_z * Lambda_13 - c->mount_xyz_x * Lambda_15);
    const six_link_real Lambda_12 = Lambda_i_33 - (t19 * c->mount_xyz_y - t20 * c->mount_xyz_x)
        + (c->mount_xyz_x * Lambda_14 - c->mount_xyz_y * Lambda_13);
    const six_link_real p_4 = link->R_rel[0] * p_i_4 - link->R_rel[1] * p_i_5;
    const six_link_real p_5 = link->R_rel[1] * p_i_4 + link->R_rel[0] * p_i_5;
    const six_link_real p_1 = link->R_rel[0] * p_i_1 - link->R_rel[1] * p_i_2
        + (c->mount_xyz_y * p_i_6 - c->mount_xyz_z * p_5);
    const six_link_real p_2 = link->R_rel[1] * p_i_1 + link->R_rel[0] * p_i_2
        + (c->mount_xyz_z * p_4 - c->mount_xyz_x * p_i_6);
    const six_link_real p_3 = p_i_3 + (c->mount_xyz_x * p_5 - c->mount_xyz_y * p_4);

    /* outputs */
    link->joint_W[0] = joint_W_11;
    link->joint_W[1] = joint_W_12;
    link->joint_W[2] = joint_W_13;
    link->joint_W[3] = joint_W_14;
    link->joint_W[4] = joint_W_15;
    link->joint_W[5] = joint_W_16;
    link->joint_w[0] = joint_w_1;
    link->Lambda_i[0] = Lambda_i_11;
    link->Lambda_i[1] = Lambda_i_12;
    link->Lambda_i[2] = Lambda_i_13;
    link->Lambda_i[3] = Lambda_i_14;
    link->Lambda_i[4] = Lambda_i_15;
    link->Lambda_i[5] = Lambda_i_16;
    link->Lambda_i[6] = Lambda_i_22;
    link->Lambda_i[7] = Lambda_i_23;
    link->Lambda_i[8] = Lambda_i_24;
    link->Lambda_i[9] = Lambda_i_25;
    link->Lambda_i[10] = Lambda_i_26;
    link->Lambda_i[11] = Lambda_i_33;
    link->Lambda_i[12] = Lambda_i_34;
    link->Lambda_i[13] = Lambda_i_35;
    link->Lambda_i[14] = Lambda_i_36;
    link->Lambda_i[15] = Lambda_i_44;
    link->Lambda_i[16] = Lambda_i_45;
    link->Lambda_i[17] = Lambda_i_46;
    link->Lambda_i[18] = Lambda_i_55;
    link->Lambda_i[19] = Lambda_i_56;
    link->Lambda_i[20] = Lambda_i_66;
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
    base->Lambda[20] = Lambda_i_66;
    base->p[0] = p_1;
    base->p[1] = p_2;
    base->p[2] = p_3;
    base->p[3] = p_4;
    base->p[4] = p_5;
    base->p[5] = p_i_6;
    return SIX_LINK_OK;
}

/* eliminate, links like upper_arm: 1293 operations */
static six_link_status eliminate_upper_arm(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base,
    const six_link_node *tip, const six_link_real w_ext[6], const six_link_real m_eta[3],
    const six_link_real f_eta[3], const six_link_real tau[1], const six_link_real qdot[1])
{

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t1 = tip->Lambda[0] + c->I_T_xx;
    const six_link_real t2 = tip->Lambda[1] - c->J_T_xy;
    const six_link_real t3 = tip->Lambda[2] - c->J_T_xz;
    const six_link_real t4 = tip->Lambda[4] - c->S_T_z;
    const six_link_real t5 = tip->Lambda[5] + c->S_T_y;
    const six_link_real t6 = tip->Lambda[6] + c->I_T_yy;
    const six_link_real t7 = tip->Lambda[7] - c->J_T_yz;
    const six_link_real t8 = tip->Lambda[8] + c->S_T_z;
    const six_link_real t9 = tip->Lambda[10] - c->S_T_x;
    const six_link_real t10 = tip->Lambda[11] + c->I_T_zz;
    const six_link_real t11 = tip->Lambda[12] - c->S_T_y;
    const six_link_real t12 = tip->Lambda[13] + c->S_T_x;
    const six_link_real t13 = tip->Lambda[15] + c->body0_mass;
    const six_link_real t14 = tip->Lambda[18] + c->body0_mass;
    const six_link_real t15 = tip->Lambda[20] + c->body0_mass;
    const six_link_real t16 = t1 * link->b_T[0] + t2 * link->b_T[1] + t3 * link->b_T[2]
        + tip->Lambda[3] * link->b_T[3] + t4 * link->b_T[4];
    const six_link_real t17 = t2 * link->b_T[0] + t6 * link->b_T[1] + t7 * link->b_T[2] + t8 * link->b_T[3]
        + tip->Lambda[9] * link->b_T[4];
    const six_link_real t18 = t3 * link->b_T[0] + t7 * link->b_T[1] + t10 * link->b_T[2] + t11 * link->b_T[3]
        + t12 * link->b_T[4];
    const six_link_real t19 = tip->Lambda[3] * link->b_T[0] + t8 * link->b_T[1] + t11 * link->b_T[2]
        + t13 * link->b_T[3] + tip->Lambda[16] * link->b_T[4];
    const six_link_real t20 = t4 * link->b_T[0] + tip->Lambda[9] * link->b_T[1] + t12 * link->b_T[2]
        + tip->Lambda[16] * link->b_T[3];
    const six_link_real t21 = t5 * link->b_T[0] + t9 * link->b_T[1] + tip->Lambda[14] * link->b_T[2]
        + tip->Lambda[17] * link->b_T[3];
    const six_link_real t22 = tip->p[0] + link->h_T[0] - w_ext[0] + (t16 + t5 * link->b_T[5]);
    const six_link_real t23 = tip->p[1] + link->h_T[1] - w_ext[1] + (t17 + t9 * link->b_T[5]);
    const six_link_real t24 = tip->p[2] + link->h_T[2] - w_ext[2] + (t18 + tip->Lambda[14] * link->b_T[5]);
    const six_link_real t25 = tip->p[3] + link->h_T[3] - w_ext[3] + (t19 + tip->Lambda[17] * link->b_T[5]);
    const six_link_real t26 = tip->p[4] + link->h_T[4] - w_ext[4]
        + (t20 + t14 * link->b_T[4] + tip->Lambda[19] * link->b_T[5]);
    const six_link_real t27 = tip->p[5] + link->h_T[5] - w_ext[5]
        + (t21 + tip->Lambda[19] * link->b_T[4] + t15 * link->b_T[5]);
    const six_link_real t28 = t1 * link->R_T[3] + t2 * link->R_T[4] + t3 * link->R_T[5];
    const six_link_real t29 = t1 * link->R_T[6] + t2 * link->R_T[7] + t3 * link->R_T[8];
    const six_link_real t30 = t2 * link->R_T[3] + t6 * link->R_T[4] + t7 * link->R_T[5];
    const six_link_real t31 = t2 * link->R_T[6] + t6 * link->R_T[7] + t7 * link->R_T[8];
    const six_link_real t32 = t3 * link->R_T[3] + t7 * link->R_T[4] + t10 * link->R_T[5];
    const six_link_real t33 = t3 * link->R_T[6] + t7 * link->R_T[7] + t10 * link->R_T[8];
    const six_link_real t34 = link->R_T[0] * (t1 * link->R_T[0] + t2 * link->R_T[1] + t3 * link->R_T[2])
        + link->R_T[1] * (t2 * link->R_T[0] + t6 * link->R_T[1] + t7 * link->R_T[2]);
    const six_link_real Lambda_T_11 = t34
        + link->R_T[2] * (t3 * link->R_T[0] + t7 * link->R_T[1] + t10 * link->R_T[2]);
    const six_link_real Lambda_T_12 = link->R_T[0] * t28 + link->R_T[1] * t30 + link->R_T[2] * t32;
    const six_link_real Lambda_T_13 = link->R_T[0] * t29 + link->R_T[1] * t31 + link->R_T[2] * t33;
    const six_link_real Lambda_T_22 = link->R_T[3] * t28 + link->R_T[4] * t30 + link->R_T[5] * t32;
    const six_link_real Lambda_T_23 = link->R_T[3] * t29 + link->R_T[4] * t31 + link->R_T[5] * t33;
    const six_link_real Lambda_T_33 = link->R_T[6] * t29 + link->R_T[7] * t31 + link->R_T[8] * t33;
    const six_link_real t35 = tip->Lambda[3] * link->R_T[0] + t4 * link->R_T[1] + t5 * link->R_T[2];
    const six_link_real t36 = tip->Lambda[3] * link->R_T[3] + t4 * link->R_T[4] + t5 * link->R_T[5];
    const six_link_real t37 = tip->Lambda[3] * link->R_T[6] + t4 * link->R_T[7] + t5 * link->R_T[8];
    const six_link_real t38 = t8 * link->R_T[0] + tip->Lambda[9] * link->R_T[1] + t9 * link->R_T[2];
    const six_link_real t39 = t8 * link->R_T[3] + tip->Lambda[9] * link->R_T[4] + t9 * link->R_T[5];
    const six_link_real t40 = t8 * link->R_T[6] + tip->Lambda[9] * link->R_T[7] + t9 * link->R_T[8];
    const six_link_real t41 = t11 * link->R_T[0] + t12 * link->R_T[1] + tip->Lambda[14] * link->R_T[2];
    const six_link_real t42 = t11 * link->R_T[3] + t12 * link->R_T[4] + tip->Lambda[14] * link->R_T[5];
    const six_link_real t43 = t11 * link->R_T[6] + t12 * link->R_T[7] + tip->Lambda[14] * link->R_T[8];
    const six_link_real Lambda_T_14 = link->R_T[0] * t35 + link->R_T[1] * t38 + link->R_T[2] * t41;
    const six_link_real Lambda_T_15 = link->R_T[0] * t36 + link->R_T[1] * t39 + link->R_T[2] * t42;
    const six_link_real Lambda_T_16 = link->R_T[0] * t37 + link->R_T[1] * t40 + link->R_T[2] * t43;
    const six_link_real Lambda_T_24 = link->R_T[3] * t35 + link->R_T[4] * t38 + link->R_T[5] * t41;
    const six_link_real Lambda_T_25 = link->R_T[3] * t36 + link->R_T[4] * t39 + link->R_T[5] * t42;
    const six_link_real Lambda_T_26 = link->R_T[3] * t37 + link->R_T[4] * t40 + link->R_T[5] * t43;
    const six_link_real Lambda_T_34 = link->R_T[6] * t35 + link->R_T[7] * t38 + link->R_T[8] * t41;
    const six_link_real Lambda_T_35 = link->R_T[6] * t36 + link->R_T[7] * t39 + link->R_T[8] * t42;
    const six_link_real Lambda_T_36 = link->R_T[6] * t37 + link->R_T[7] * t40 + link->R_T[8] * t43;
    const six_link_real t44 = t13 * link->R_T[3] + tip->Lambda[16] * link->R_T[4]
        + tip->Lambda[17] * link->R_T[5];
    const six_link_real t45 = t13 * link->R_T[6] + tip->Lambda[16] * link->R_T[7]
        + tip->Lambda[17] * link->R_T[8];
    const six_link_real t46 = tip->Lambda[16] * link->R_T[3] + t14 * link->R_T[4]
        + tip->Lambda[19] * link->R_T[5];
    const six_link_real t47 = tip->Lambda[16] * link->R_T[6] + t14 * link->R_T[7]
        + tip->Lambda[19] * link->R_T[8];
    const six_link_real t48 = tip->Lambda[17] * link->R_T[3] + tip->Lambda[19] * link->R_T[4]
        + t15 * link->R_T[5];
    const six_link_real t49 = tip->Lambda[17] * link->R_T[6] + tip->Lambda[19] * link->R_T[7]
        + t15 * link->R_T[8];
    const six_link_real t50 = link->R_T[0]
        * (t13 * link->R_T[0] + tip->Lambda[16] * link->R_T[1] + tip->Lambda[17] * link->R_T[2]);
    const six_link_real t51 = link->R_T[1]
        * (tip->Lambda[16] * link->R_T[0] + t14 * link->R_T[1] + tip->Lambda[19] * link->R_T[2]);
    const six_link_real t52 = link->R_T[2]
        * (tip->Lambda[17] * link->R_T[0] + tip->Lambda[19] * link->R_T[1] + t15 * link->R_T[2]);
    const six_link_real Lambda_T_44 = t50 + t51 + t52;
    const six_link_real Lambda_T_45 = link->R_T[0] * t44 + link->R_T[1] * t46 + link->R_T[2] * t48;
    const six_link_real Lambda_T_46 = link->R_T[0] * t45 + link->R_T[1] * t47 + link->R_T[2] * t49;
    const six_link_real Lambda_T_55 = link->R_T[3] * t44 + link->R_T[4] * t46 + link->R_T[5] * t48;
    const six_link_real Lambda_T_56 = link->R_T[3] * t45 + link->R_T[4] * t47 + link->R_T[5] * t49;
    const six_link_real Lambda_T_66 = link->R_T[6] * t45 + link->R_T[7] * t47 + link->R_T[8] * t49;
    const six_link_real p_T_1 = link->R_T[0] * t22 + link->R_T[1] * t23 + link->R_T[2] * t24;
    const six_link_real p_T_2 = link->R_T[3] * t22 + link->R_T[4] * t23 + link->R_T[5] * t24;
    const six_link_real p_T_3 = link->R_T[6] * t22 + link->R_T[7] * t23 + link->R_T[8] * t24;
    const six_link_real p_T_4 = link->R_T[0] * t25 + link->R_T[1] * t26 + link->R_T[2] * t27;
    const six_link_real p_T_5 = link->R_T[3] * t25 + link->R_T[4] * t26 + link->R_T[5] * t27;
    const six_link_real p_T_6 = link->R_T[6] * t25 + link->R_T[7] * t26 + link->R_T[8] * t27;

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t53 = link->r_T[1] * Lambda_T_45;
    const six_link_real t54 = link->r_T[0] * Lambda_T_46;
    const six_link_real t55 = c->length * Lambda_T_56;
    const six_link_real M_loaded_14 = Lambda_T_14 + (t54 - t53);
    const six_link_real t56 = Lambda_T_15 + (link->r_T[0] * Lambda_T_56 - link->r_T[1] * Lambda_T_55);
    const six_link_real t57 = Lambda_T_16 + (link->r_T[0] * Lambda_T_66 - link->r_T[1] * Lambda_T_56);
    const six_link_real t58 = Lambda_T_24 + (link->r_T[1] * Lambda_T_44 - c->length * Lambda_T_46);
    const six_link_real M_loaded_25 = Lambda_T_25 + (t53 - t55);
    const six_link_real t59 = Lambda_T_26 + (link->r_T[1] * Lambda_T_46 - c->length * Lambda_T_66);
    const six_link_real t60 = Lambda_T_34 + (c->length * Lambda_T_45 - link->r_T[0] * Lambda_T_44);
    const six_link_real t61 = Lambda_T_35 + (c->length * Lambda_T_55 - link->r_T[0] * Lambda_T_45);
    const six_link_real M_loaded_36 = Lambda_T_36 + (t55 - t54);
    const six_link_real t62 = Lambda_T_11 - (Lambda_T_15 * link->r_T[1] - Lambda_T_16 * link->r_T[0])
        + (link->r_T[0] * t57 - link->r_T[1] * t56);
    const six_link_real t63 = Lambda_T_12 - (Lambda_T_16 * c->length - Lambda_T_14 * link->r_T[1])
        + (link->r_T[0] * t59 - link->r_T[1] * M_loaded_25);
    const six_link_real t64 = Lambda_T_13 - (Lambda_T_14 * link->r_T[0] - Lambda_T_15 * c->length)
        + (link->r_T[0] * M_loaded_36 - link->r_T[1] * t61);
    const six_link_real t65 = Lambda_T_22 - (Lambda_T_26 * c->length - Lambda_T_24 * link->r_T[1])
        + (link->r_T[1] * t58 - c->length * t59);
    const six_link_real t66 = Lambda_T_23 - (Lambda_T_24 * link->r_T[0] - Lambda_T_25 * c->length)
        + (link->r_T[1] * t60 - c->length * M_loaded_36);
    const six_link_real t67 = Lambda_T_33 - (Lambda_T_34 * link->r_T[0] - Lambda_T_35 * c->length)
        + (c->length * t61 - link->r_T[0] * t60);
    const six_link_real M_loaded_11 = link->M_V[0] + t62;
    const six_link_real M_loaded_12 = t63 - link->M_V[1];
    const six_link_real M_loaded_13 = t64 - link->M_V[2];
    const six_link_real M_loaded_15 = t56 - link->M_V[3];
    const six_link_real M_loaded_16 = link->M_V[4] + t57;
    const six_link_real M_loaded_22 = link->M_V[5] + t65;
    const six_link_real M_loaded_23 = t66 - link->M_V[6];
    const six_link_real M_loaded_24 = link->M_V[3] + t58;
    const six_link_real M_loaded_26 = t59 - c->S_0_x;
    const six_link_real M_loaded_33 = link->M_V[7] + t67;
    const six_link_real M_loaded_34 = t60 - link->M_V[4];
    const six_link_real M_loaded_35 = c->S_0_x + t61;
    const six_link_real M_loaded_44 = c->mu + Lambda_T_44;
    const six_link_real M_loaded_55 = c->mu + Lambda_T_55;
    const six_link_real M_loaded_66 = c->mu + Lambda_T_66;
    const six_link_real h_loaded_1 = link->h_V[0] + (p_T_1 + (link->r_T[0] * p_T_6 - link->r_T[1] * p_T_5));
    const six_link_real h_loaded_2 = link->h_V[1] + (p_T_2 + (link->r_T[1] * p_T_4 - c->length * p_T_6));
    const six_link_real h_loaded_3 = link->h_V[2] + (p_T_3 + (c->length * p_T_5 - link->r_T[0] * p_T_4));
    const six_link_real h_loaded_4 = link->h_V[3] + p_T_4;
    const six_link_real h_loaded_5 = link->h_V[4] + p_T_5;
    const six_link_real h_loaded_6 = link->h_V[5] + p_T_6;
    const six_link_real t68 = Lambda_T_11 * link->G[0] + Lambda_T_12 * link->G[3] + Lambda_T_13 * link->G[6];
    const six_link_real t69 = Lambda_T_11 * link->G[1] + Lambda_T_12 * link->G[4] + Lambda_T_13 * link->G[7];
    const six_link_real t70 = Lambda_T_11 * link->G[2] + Lambda_T_12 * link->G[5] + Lambda_T_13 * link->G[8];
    const six_link_real t71 = Lambda_T_12 * link->G[0] + Lambda_T_22 * link->G[3] + Lambda_T_23 * link->G[6];
    const six_link_real t72 = Lambda_T_12 * link->G[1] + Lambda_T_22 * link->G[4] + Lambda_T_23 * link->G[7];
    const six_link_real t73 = Lambda_T_12 * link->G[2] + Lambda_T_22 * link->G[5] + Lambda_T_23 * link->G[8];
    const six_link_real t74 = Lambda_T_13 * link->G[0] + Lambda_T_23 * link->G[3] + Lambda_T_33 * link->G[6];
    const six_link_real t75 = Lambda_T_13 * link->G[1] + Lambda_T_23 * link->G[4] + Lambda_T_33 * link->G[7];
    const six_link_real t76 = Lambda_T_13 * link->G[2] + Lambda_T_23 * link->G[5] + Lambda_T_33 * link->G[8];
    const six_link_real t77 = Lambda_T_15 * link->G[0] + Lambda_T_25 * link->G[3] + Lambda_T_35 * link->G[6];
    const six_link_real t78 = Lambda_T_15 * link->G[2] + Lambda_T_25 * link->G[5] + Lambda_T_35 * link->G[8];
    const six_link_real t79 = Lambda_T_16 * link->G[0] + Lambda_T_26 * link->G[3] + Lambda_T_36 * link->G[6];
    const six_link_real t80 = Lambda_T_16 * link->G[1] + Lambda_T_26 * link->G[4] + Lambda_T_36 * link->G[7];
    const six_link_real t81 = Lambda_T_16 * link->G[2] + Lambda_T_26 * link->G[5] + Lambda_T_36 * link->G[8];
    const six_link_real C_41 = (Lambda_T_14 * link->G[2] + Lambda_T_24 * link->G[5] + Lambda_T_34 * link->G[8])
        * c->Psi_c_z1 + Lambda_T_45 * 2;
    const six_link_real C_42 = (Lambda_T_14 * link->G[1] + Lambda_T_24 * link->G[4] + Lambda_T_34 * link->G[7])
        * c->Psi_c_y2 + Lambda_T_46 * 2;
    const six_link_real C_43 = (Lambda_T_14 * link->G[0] + Lambda_T_24 * link->G[3] + Lambda_T_34 * link->G[6])
        * REAL(1.4142135623730951);
    const six_link_real t82 = t78 * c->Psi_c_z1 + Lambda_T_55 * 2;
    const six_link_real t83 = Lambda_T_56 * 2;
    const six_link_real C_52 = (Lambda_T_15 * link->G[1] + Lambda_T_25 * link->G[4] + Lambda_T_35 * link->G[7])
        * c->Psi_c_y2 + t83;
    const six_link_real C_53 = t77 * REAL(1.4142135623730951);
    const six_link_real C_61 = t81 * c->Psi_c_z1 + t83;
    const six_link_real t84 = t80 * c->Psi_c_y2 + Lambda_T_66 * 2;
    const six_link_real C_63 = t79 * REAL(1.4142135623730951);
    const six_link_real C_21 = t73 * c->Psi_c_z1 + Lambda_T_25 * 2 + (link->r_T[1] * C_41 - c->length * C_61);
    const six_link_real C_32 = t75 * c->Psi_c_y2 + Lambda_T_36 * 2 + (c->length * C_52 - link->r_T[0] * C_42);
    const six_link_real C_23 = t71 * REAL(1.4142135623730951) + (link->r_T[1] * C_43 - c->length * C_63);
    const six_link_real C_33 = t74 * REAL(1.4142135623730951) + (c->length * C_53 - link->r_T[0] * C_43);
    const six_link_real C_11 = t70 * c->Psi_c_z1 + Lambda_T_15 * 2 + (link->r_T[0] * C_61 - link->r_T[1] * t82)
        - link->M_D[0];
    const six_link_real C_12 = link->M_D[1]
        + (t69 * c->Psi_c_y2 + Lambda_T_16 * 2 + (link->r_T[0] * t84 - link->r_T[1] * C_52));
    const six_link_real C_13 = c->sigma_t_3
        + (t68 * REAL(1.4142135623730951) + (link->r_T[0] * C_63 - link->r_T[1] * C_53));
    const six_link_real C_22 = t72 * c->Psi_c_y2 + Lambda_T_26 * 2 + (link->r_T[1] * C_42 - c->length * t84)
        - c->chi_2;
    const six_link_real C_31 = c->chi_1
        + (t76 * c->Psi_c_z1 + Lambda_T_35 * 2 + (c->length * t82 - link->r_T[0] * C_41));
    const six_link_real C_51 = c->sigma_y1 + t82;
    const six_link_real C_62 = c->sigma_z2 + t84;
    const six_link_real t85 = c->Psi_c_z1
        * ((link->G[2] * t70 + link->G[5] * t73 + link->G[8] * t76) * c->Psi_c_z1 + t78 * 2) + t82 * 2;
    const six_link_real modal_inertia_12 = c->Psi_c_z1
        * ((link->G[1] * t70 + link->G[4] * t73 + link->G[7] * t76) * c->Psi_c_y2 + t81 * 2) + C_52 * 2;
    const six_link_real t86 = c->Psi_c_z1
        * ((link->G[0] * t70 + link->G[3] * t73 + link->G[6] * t76) * REAL(1.4142135623730951));
    const six_link_real modal_inertia_13 = t86 + t77 * REAL(2.8284271247461903);
    const six_link_real t87 = c->Psi_c_y2
        * ((link->G[1] * t69 + link->G[4] * t72 + link->G[7] * t75) * c->Psi_c_y2 + t80 * 2) + t84 * 2;
    const six_link_real t88 = c->Psi_c_y2
        * ((link->G[0] * t69 + link->G[3] * t72 + link->G[6] * t75) * REAL(1.4142135623730951));
    const six_link_real modal_inertia_23 = t88 + t79 * REAL(2.8284271247461903);
    const six_link_real modal_inertia_11 = t85 + m_eta[0];
    if (!(modal_inertia_11 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modal_inertia_22 = t87 + m_eta[1];
    const six_link_real modal_inertia_33 = (link->G[0] * t68 + link->G[3] * t71 + link->G[6] * t74)
        * REAL(2.0000000000000004) + m_eta[2];
    const six_link_real h_phi_1 = link->h_eta[0] + f_eta[0]
        + (c->Psi_c_z1 * (link->G[2] * p_T_1 + link->G[5] * p_T_2 + link->G[8] * p_T_3) + p_T_5 * 2);
    const six_link_real h_phi_2 = link->h_eta[1] + f_eta[1]
        + (c->Psi_c_y2 * (link->G[1] * p_T_1 + link->G[4] * p_T_2 + link->G[7] * p_T_3) + p_T_6 * 2);
    const six_link_real h_phi_3 = f_eta[2]
        + (link->G[0] * p_T_1 + link->G[3] * p_T_2 + link->G[6] * p_T_3) * REAL(1.4142135623730951);
    const six_link_real modes_inverse_1 = 1 / modal_inertia_11;
    const six_link_real modes_L_21 = modal_inertia_12 * modes_inverse_1;
    const six_link_real modes_L_31 = modal_inertia_13 * modes_inverse_1;
    const six_link_real t89 = modal_inertia_22 - modal_inertia_12 * modes_L_21;
    if (!(t89 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modes_inverse_2 = 1 / t89;
    const six_link_real t90 = modal_inertia_23 - modal_inertia_12 * modes_L_31;
    const six_link_real modes_L_32 = t90 * modes_inverse_2;
    const six_link_real t91 = modal_inertia_33 - (modal_inertia_13 * modes_L_31 + t90 * modes_L_32);
    if (!(t91 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modes_inverse_3 = 1 / t91;
    const six_link_real t92 = C_12 - modes_L_21 * C_11;
    const six_link_real t93 = C_22 - modes_L_21 * C_21;
    const six_link_real t94 = C_32 - modes_L_21 * C_31;
    const six_link_real t95 = C_42 - modes_L_21 * C_41;
    const six_link_real t96 = C_52 - modes_L_21 * C_51;
    const six_link_real t97 = C_62 - modes_L_21 * C_61;
    const six_link_real t98 = C_13 - modes_L_31 * C_11 - modes_L_32 * t92;
    const six_link_real t99 = C_23 - modes_L_31 * C_21 - modes_L_32 * t93;
    const six_link_real t100 = C_33 - modes_L_31 * C_31 - modes_L_32 * t94;
    const six_link_real t101 = C_43 - modes_L_31 * C_41 - modes_L_32 * t95;
    const six_link_real t102 = C_53 - modes_L_31 * C_51 - modes_L_32 * t96;
    const six_link_real t103 = C_63 - modes_L_31 * C_61 - modes_L_32 * t97;
    const six_link_real t104 = h_phi_2 - modes_L_21 * h_phi_1;
    const six_link_real t105 = h_phi_3 - modes_L_31 * h_phi_1 - modes_L_32 * t104;
    const six_link_real modes_W_11 = C_11 * modes_inverse_1;
    const six_link_real modes_W_12 = C_21 * modes_inverse_1;
    const six_link_real modes_W_13 = C_31 * modes_inverse_1;
    const six_link_real modes_W_14 = C_41 * modes_inverse_1;
    const six_link_real modes_W_15 = C_51 * modes_inverse_1;
    const six_link_real modes_W_16 = C_61 * modes_inverse_1;
    const six_link_real modes_W_21 = t92 * modes_inverse_2;
    const six_link_real modes_W_22 = t93 * modes_inverse_2;
    const six_link_real modes_W_23 = t94 * modes_inverse_2;
    const six_link_real modes_W_24 = t95 * modes_inverse_2;
    const six_link_real modes_W_25 = t96 * modes_inverse_2;
    const six_link_real modes_W_26 = t97 * modes_inverse_2;
    const six_link_real modes_W_31 = t98 * modes_inverse_3;
    const six_link_real modes_W_32 = t99 * modes_inverse_3;
    const six_link_real modes_W_33 = t100 * modes_inverse_3;
    const six_link_real modes_W_34 = t101 * modes_inverse_3;
    const six_link_real modes_W_35 = t102 * modes_inverse_3;
    const six_link_real modes_W_36 = t103 * modes_inverse_3;
    const six_link_real modes_w_1 = h_phi_1 * modes_inverse_1;
    const six_link_real modes_w_2 = t104 * modes_inverse_2;
    const six_link_real modes_w_3 = t105 * modes_inverse_3;
    const six_link_real M_i_11 = M_loaded_11 - (C_11 * modes_W_11 + t92 * modes_W_21 + t98 * modes_W_31);
    const six_link_real M_i_12 = M_loaded_12 - (C_11 * modes_W_12 + t92 * modes_W_22 + t98 * modes_W_32);
    const six_link_real M_i_13 = M_loaded_13 - (C_11 * modes_W_13 + t92 * modes_W_23 + t98 * modes_W_33);
    const six_link_real M_i_14 = M_loaded_14 - (C_11 * modes_W_14 + t92 * modes_W_24 + t98 * modes_W_34);
    const six_link_real M_i_15 = M_loaded_15 - (C_11 * modes_W_15 + t92 * modes_W_25 + t98 * modes_W_35);
    const six_link_real M_i_16 = M_loaded_16 - (C_11 * modes_W_16 + t92 * modes_W_26 + t98 * modes_W_36);
    const six_link_real M_i_22 = M_loaded_22 - (C_21 * modes_W_12 + t93 * modes_W_22 + t99 * modes_W_32);
    const six_link_real M_i_23 = M_loaded_23 - (C_21 * modes_W_13 + t93 * modes_W_23 + t99 * modes_W_33);
    const six_link_real M_i_24 = M_loaded_24 - (C_21 * modes_W_14 + t93 * modes_W_24 + t99 * modes_W_34);
    const six_link_real M_i_25 = M_loaded_25 - (C_21 * modes_W_15 + t93 * modes_W_25 + t99 * modes_W_35);
    const six_link_real M_i_26 = M_loaded_26 - (C_21 * modes_W_16 + t93 * modes_W_26 + t99 * modes_W_36);
    const six_link_real M_i_33 = M_loaded_33 - (C_31 * modes_W_13 + t94 * modes_W_23 + t100 * modes_W_33);
    const six_link_real M_i_34 = M_loaded_34 - (C_31 * modes_W_14 + t94 * modes_W_24 + t100 * modes_W_34);
    const six_link_real M_i_35 = M_loaded_35 - (C_31 * modes_W_15 + t94 * modes_W_25 + t100 * modes_W_35);
    const six_link_real M_i_36 = M_loaded_36 - (C_31 * modes_W_16 + t94 * modes_W_26 + t100 * modes_W_36);
    const six_link_real M_i_44 = M_loaded_44 - (C_41 * modes_W_14 + t95 * modes_W_24 + t101 * modes_W_34);
    const six_link_real M_i_45 = Lambda_T_45 - (C_41 * modes_W_15 + t95 * modes_W_25 + t101 * modes_W_35);
    const six_link_real M_i_46 = Lambda_T_46 - (C_41 * modes_W_16 + t95 * modes_W_26 + t101 * modes_W_36);
    const six_link_real M_i_55 = M_loaded_55 - (C_51 * modes_W_15 + t96 * modes_W_25 + t102 * modes_W_35);
    const six_link_real M_i_56 = Lambda_T_56 - (C_51 * modes_W_16 + t96 * modes_W_26 + t102 * modes_W_36);
    const six_link_real M_i_66 = M_loaded_66 - (C_61 * modes_W_16 + t97 * modes_W_26 + t103 * modes_W_36);
    const six_link_real h_i_1 = h_loaded_1 - (modes_W_11 * h_phi_1 + modes_W_21 * t104 + modes_W_31 * t105);
    const six_link_real h_i_2 = h_loaded_2 - (modes_W_12 * h_phi_1 + modes_W_22 * t104 + modes_W_32 * t105);
    const six_link_real h_i_3 = h_loaded_3 - (modes_W_13 * h_phi_1 + modes_W_23 * t104 + modes_W_33 * t105);
    const six_link_real h_i_4 = h_loaded_4 - (modes_W_14 * h_phi_1 + modes_W_24 * t104 + modes_W_34 * t105);
    const six_link_real h_i_5 = h_loaded_5 - (modes_W_15 * h_phi_1 + modes_W_25 * t104 + modes_W_35 * t105);
    const six_link_real h_i_6 = h_loaded_6 - (modes_W_16 * h_phi_1 + modes_W_26 * t104 + modes_W_36 * t105);

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real t106 = M_i_13 * link->beta[1] - M_i_11 * link->beta[0] - M_i_14 * link->beta[2]
        + M_i_16 * link->beta[3];
    const six_link_real t107 = M_i_23 * link->beta[1] - M_i_12 * link->beta[0] - M_i_24 * link->beta[2]
        + M_i_26 * link->beta[3];
    const six_link_real t108 = M_i_33 * link->beta[1] - M_i_13 * link->beta[0] - M_i_34 * link->beta[2]
        + M_i_36 * link->beta[3];
    const six_link_real t109 = M_i_34 * link->beta[1] - M_i_14 * link->beta[0] - M_i_44 * link->beta[2]
        + M_i_46 * link->beta[3];
    const six_link_real t110 = M_i_35 * link->beta[1] - M_i_15 * link->beta[0] - M_i_45 * link->beta[2]
        + M_i_56 * link->beta[3];
    const six_link_real t111 = M_i_36 * link->beta[1] - M_i_16 * link->beta[0] - M_i_46 * link->beta[2]
        + M_i_66 * link->beta[3];
    const six_link_real bias_1 = h_i_1 + t106;
    const six_link_real bias_2 = h_i_2 + t107;
    const six_link_real bias_3 = h_i_3 + t108;
    const six_link_real bias_4 = h_i_4 + t109;
    const six_link_real bias_5 = h_i_5 + t110;
    const six_link_real bias_6 = h_i_6 + t111;
    const six_link_real joint_inertia_11 = M_i_22 + c->armature_1;
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8 * (M_i_11 + M_i_22 + M_i_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_i_12 * joint_inverse_1;
    const six_link_real joint_W_12 = M_i_22 * joint_inverse_1;
    const six_link_real joint_W_13 = M_i_23 * joint_inverse_1;
    const six_link_real joint_W_14 = M_i_24 * joint_inverse_1;
    const six_link_real joint_W_15 = M_i_25 * joint_inverse_1;
    const six_link_real joint_W_16 = M_i_26 * joint_inverse_1;
    const six_link_real joint_w_1 = (tau[0] - c->joint_damping_1 * qdot[0] - bias_2) * joint_inverse_1;
    const six_link_real Lambda_i_11 = M_i_11 - M_i_12 * joint_W_11;
    const six_link_real Lambda_i_12 = M_i_12 - M_i_12 * joint_W_12;
    const six_link_real Lambda_i_13 = M_i_13 - M_i_12 * joint_W_13;
    const six_link_real Lambda_i_14 = M_i_14 - M_i_12 * joint_W_14;
    const six_link_real Lambda_i_15 = M_i_15 - M_i_12 * joint_W_15;
    const six_link_real Lambda_i_16 = M_i_16 - M_i_12 * joint_W_16;
    const six_link_real Lambda_i_22 = M_i_22 - M_i_22 * joint_W_12;
    const six_link_real Lambda_i_23 = M_i_23 - M_i_22 * joint_W_13;
    const six_link_real Lambda_i_24 = M_i_24 - M_i_22 * joint_W_14;
    const six_link_real Lambda_i_25 = M_i_25 - M_i_22 * joint_W_15;
    const six_link_real Lambda_i_26 = M_i_26 - M_i_22 * joint_W_16;
    const six_link_real Lambda_i_33 = M_i_33 - M_i_23 * joint_W_13;
    const six_link_real Lambda_i_34 = M_i_34 - M_i_23 * joint_W_14;
    const six_link_real Lambda_i_35 = M_i_35 - M_i_23 * joint_W_15;
    const six_link_real Lambda_i_36 = M_i_36 - M_i_23 * joint_W_16;
    const six_link_real Lambda_i_44 = M_i_44 - M_i_24 * joint_W_14;
    const six_link_real Lambda_i_45 = M_i_45 - M_i_24 * joint_W_15;
    const six_link_real Lambda_i_46 = M_i_46 - M_i_24 * joint_W_16;
    const six_link_real Lambda_i_55 = M_i_55 - M_i_25 * joint_W_15;
    const six_link_real Lambda_i_56 = M_i_56 - M_i_25 * joint_W_16;
    const six_link_real Lambda_i_66 = M_i_66 - M_i_26 * joint_W_16;
    const six_link_real p_i_1 = bias_1 + M_i_12 * joint_w_1;
    const six_link_real p_i_2 = bias_2 + M_i_22 * joint_w_1;
    const six_link_real p_i_3 = bias_3 + M_i_23 * joint_w_1;
    const six_link_real p_i_4 = bias_4 + M_i_24 * joint_w_1;
    const six_link_real p_i_5 = bias_5 + M_i_25 * joint_w_1;
    const six_link_real p_i_6 = bias_6 + M_i_26 * joint_w_1;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t112 = Lambda_i_13 * link->R_rel[1];
    const six_link_real t113 = Lambda_i_13 * link->R_rel[0];
    const six_link_real t114 = t113 - Lambda_i_11 * link->R_rel[1];
    const six_link_real t115 = Lambda_i_33 * link->R_rel[0] - t112;
    const six_link_real t116 = link->R_rel[0] * (Lambda_i_11 * link->R_rel[0] + t112)
        + link->R_rel[1] * (t113 + Lambda_i_33 * link->R_rel[1]);
    const six_link_real t117 = Lambda_i_14 * link->R_rel[0] + Lambda_i_16 * link->R_rel[1];
    const six_link_real t118 = Lambda_i_16 * link->R_rel[0] - Lambda_i_14 * link->R_rel[1];
    const six_link_real t119 = Lambda_i_24 * link->R_rel[0] + Lambda_i_26 * link->R_rel[1];
    const six_link_real t120 = Lambda_i_26 * link->R_rel[0] - Lambda_i_24 * link->R_rel[1];
    const six_link_real t121 = Lambda_i_34 * link->R_rel[0] + Lambda_i_36 * link->R_rel[1];
    const six_link_real t122 = Lambda_i_36 * link->R_rel[0] - Lambda_i_34 * link->R_rel[1];
    const six_link_real t123 = link->R_rel[0] * t117 + link->R_rel[1] * t121;
    const six_link_real t124 = link->R_rel[0] * Lambda_i_15 + link->R_rel[1] * Lambda_i_35;
    const six_link_real t125 = link->R_rel[0] * t118 + link->R_rel[1] * t122;
    const six_link_real t126 = link->R_rel[0] * t121 - link->R_rel[1] * t117;
    const six_link_real t127 = link->R_rel[0] * Lambda_i_35 - link->R_rel[1] * Lambda_i_15;
    const six_link_real t128 = Lambda_i_46 * link->R_rel[1];
    const six_link_real t129 = Lambda_i_46 * link->R_rel[0];
    const six_link_real t130 = t129 - Lambda_i_44 * link->R_rel[1];
    const six_link_real Lambda_17 = Lambda_i_45 * link->R_rel[0] + Lambda_i_56 * link->R_rel[1];
    const six_link_real Lambda_20 = Lambda_i_56 * link->R_rel[0] - Lambda_i_45 * link->R_rel[1];
    const six_link_real t131 = Lambda_i_66 * link->R_rel[0] - t128;
    const six_link_real Lambda_16 = link->R_rel[0] * (Lambda_i_44 * link->R_rel[0] + t128)
        + link->R_rel[1] * (t129 + Lambda_i_66 * link->R_rel[1]);
    const six_link_real Lambda_18 = link->R_rel[0] * t130 + link->R_rel[1] * t131;
    const six_link_real Lambda_21 = link->R_rel[0] * t131 - link->R_rel[1] * t130;
    const six_link_real t132 = c->mount_xyz_z * Lambda_17;
    const six_link_real t133 = c->mount_xyz_y * Lambda_18;
    const six_link_real t134 = c->mount_xyz_x * Lambda_20;
    const six_link_real Lambda_4 = t123 + (t133 - t132);
    const six_link_real Lambda_5 = t124 + (c->mount_xyz_y * Lambda_20 - c->mount_xyz_z * Lambda_i_55);
    const six_link_real Lambda_6 = t125 + (c->mount_xyz_y * Lambda_21 - c->mount_xyz_z * Lambda_20);
    const six_link_real Lambda_9 = t119 + (c->mount_xyz_z * Lambda_16 - c->mount_xyz_x * Lambda_18);
    const six_link_real Lambda_10 = Lambda_i_25 + (t132 - t134);
    const six_link_real Lambda_11 = t120 + (c->mount_xyz_z * Lambda_18 - c->mount_xyz_x * Lambda_21);
    const six_link_real Lambda_13 = t126 + (c->mount_xyz_x * Lambda_17 - c->mount_xyz_y * Lambda_16);
    const six_link_real Lambda_14 = t127 + (c->mount_xyz_x * Lambda_i_55 - c->mount_xyz_y * Lambda_17);
    const six_link_real Lambda_15 = link->R_rel[0] * t122 - link->R_rel[1] * t118 + (t134 - t133);
    const six_link_real Lambda_1 = t116 - (t124 * c->mount_xyz_z - t125 * c->mount_xyz_y)
        + (c->mount_xyz_y * Lambda_6 - c->mount_xyz_z * Lambda_5);
    const six_link_real t135 = Lambda_i_12 * link->R_rel[0] + Lambda_i_23 * link->R_rel[1]
        - (t125 * c->mount_xyz_x - t123 * c->mount_xyz_z);
    const six_link_real Lambda_2 = t135 + (c->mount_xyz_y * Lambda_11 - c->mount_xyz_z * Lambda_10);
    const six_link_real Lambda_3 = link->R_rel[0] * t114 + link->R_rel[1] * t115
        - (t123 * c->mount_xyz_y - t124 * c->mount_xyz_x)
        + (c->mount_xyz_y * Lambda_15 - c->mount_xyz_z * Lambda_14);
    const six_link_real Lambda_7 = Lambda_i_22 - (t120 * c->mount_xyz_x - t119 * c->mount_xyz_z)
        + (c->mount_xyz_z * Lambda_9 - c->mount_xyz_x * Lambda_11);
    const six_link_real t136 = Lambda_i_23 * link->R_rel[0] - Lambda_i_12 * link->R_rel[1]
        - (t119 * c->mount_xyz_y - Lambda_i_25 * c->mount_xyz_x);
    const six_link_real Lambda_8 = t136 + (c->mount_xyz_z * Lambda_13 - c->mount_xyz_x * Lambda_15);
    const six_link_real Lambda_12 = link->R_rel[0] * t115 - link->R_rel[1] * t114
        - (t126 * c->mount_xyz_y - t127 * c->mount_xyz_x)
        + (c->mount_xyz_x * Lambda_14 - c->mount_xyz_y * Lambda_13);
    const six_link_real p_4 = link->R_rel[0] * p_i_4 + link->R_rel[1] * p_i_6;
    const six_link_real p_6 = link->R_rel[0] * p_i_6 - link->R_rel[1] * p_i_4;
    const six_link_real p_1 = link->R_rel[0] * p_i_1 + link->R_rel[1] * p_i_3
        + (c->mount_xyz_y * p_6 - c->mount_xyz_z * p_i_5);
    const six_link_real p_2 = p_i_2 + (c->mount_xyz_z * p_4 - c->mount_xyz_x * p_6);
    const six_link_real p_3 = link->R_rel[0] * p_i_3 - link->R_rel[1] * p_i_1
        + (c->mount_xyz_x * p_i_5 - c->mount_xyz_y * p_4);

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
    link->joint_W[2] = joint_W_13;
    link->joint_W[3] = joint_W_14;
    link->joint_W[4] = joint_W_15;
    link->joint_W[5] = joint_W_16;
    link->joint_w[0] = joint_w_1;
    link->Lambda_i[0] = Lambda_i_11;
    link->Lambda_i[1] = Lambda_i_12;
    link->Lambda_i[2] = Lambda_i_13;
    link->Lambda_i[3] = Lambda_i_14;
    link->Lambda_i[4] = Lambda_i_15;
    link->Lambda_i[5] = Lambda_i_16;
    link->Lambda_i[6] = Lambda_i_22;
    link->Lambda_i[7] = Lambda_i_23;
    link->Lambda_i[8] = Lambda_i_24;
    link->Lambda_i[9] = Lambda_i_25;
    link->Lambda_i[10] = Lambda_i_26;
    link->Lambda_i[11] = Lambda_i_33;
    link->Lambda_i[12] = Lambda_i_34;
    link->Lambda_i[13] = Lambda_i_35;
    link->Lambda_i[14] = Lambda_i_36;
    link->Lambda_i[15] = Lambda_i_44;
    link->Lambda_i[16] = Lambda_i_45;
    link->Lambda_i[17] = Lambda_i_46;
    link->Lambda_i[18] = Lambda_i_55;
    link->Lambda_i[19] = Lambda_i_56;
    link->Lambda_i[20] = Lambda_i_66;
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
    base->Lambda[18] = Lambda_i_55;
    base->Lambda[19] = Lambda_20;
    base->Lambda[20] = Lambda_21;
    base->p[0] = p_1;
    base->p[1] = p_2;
    base->p[2] = p_3;
    base->p[3] = p_4;
    base->p[4] = p_i_5;
    base->p[5] = p_6;
    return SIX_LINK_OK;
}

/* eliminate, links like forearm: 1258 operations */
static six_link_status eliminate_forearm(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base,
    const six_link_node *tip, const six_link_real w_ext[6], const six_link_real m_eta[2],
    const six_link_real f_eta[2], const six_link_real tau[1], const six_link_real qdot[1])
{

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t1 = tip->Lambda[0] * link->b_T[0] + tip->Lambda[1] * link->b_T[1]
        + tip->Lambda[2] * link->b_T[2] + tip->Lambda[3] * link->b_T[3];
    const six_link_real t2 = tip->Lambda[1] * link->b_T[0] + tip->Lambda[6] * link->b_T[1]
        + tip->Lambda[7] * link->b_T[2] + tip->Lambda[8] * link->b_T[3];
    const six_link_real t3 = tip->Lambda[2] * link->b_T[0] + tip->Lambda[7] * link->b_T[1]
        + tip->Lambda[11] * link->b_T[2] + tip->Lambda[12] * link->b_T[3];
    const six_link_real t4 = tip->Lambda[3] * link->b_T[0] + tip->Lambda[8] * link->b_T[1]
        + tip->Lambda[12] * link->b_T[2] + tip->Lambda[15] * link->b_T[3];
    const six_link_real t5 = tip->Lambda[4] * link->b_T[0] + tip->Lambda[9] * link->b_T[1]
        + tip->Lambda[13] * link->b_T[2] + tip->Lambda[16] * link->b_T[3];
    const six_link_real t6 = tip->Lambda[5] * link->b_T[0] + tip->Lambda[10] * link->b_T[1]
        + tip->Lambda[14] * link->b_T[2] + tip->Lambda[17] * link->b_T[3];
    const six_link_real t7 = tip->p[0] - w_ext[0]
        + (t1 + tip->Lambda[4] * link->b_T[4] + tip->Lambda[5] * link->b_T[5]);
    const six_link_real t8 = tip->p[1] - w_ext[1]
        + (t2 + tip->Lambda[9] * link->b_T[4] + tip->Lambda[10] * link->b_T[5]);
    const six_link_real t9 = tip->p[2] - w_ext[2]
        + (t3 + tip->Lambda[13] * link->b_T[4] + tip->Lambda[14] * link->b_T[5]);
    const six_link_real t10 = tip->p[3] - w_ext[3]
        + (t4 + tip->Lambda[16] * link->b_T[4] + tip->Lambda[17] * link->b_T[5]);
    const six_link_real t11 = tip->p[4] - w_ext[4]
        + (t5 + tip->Lambda[18] * link->b_T[4] + tip->Lambda[19] * link->b_T[5]);
    const six_link_real t12 = tip->p[5] - w_ext[5]
        + (t6 + tip->Lambda[19] * link->b_T[4] + tip->Lambda[20] * link->b_T[5]);
    const six_link_real t13 = tip->Lambda[1] * link->R_T[1];
    const six_link_real t14 = tip->Lambda[2] * link->R_T[2];
    const six_link_real t15 = tip->Lambda[0] * link->R_T[1] + tip->Lambda[1] * link->R_T[3]
        + tip->Lambda[2] * link->R_T[4];
    const six_link_real t16 = tip->Lambda[1] * link->R_T[4] - tip->Lambda[0] * link->R_T[2]
        + tip->Lambda[2] * link->R_T[5];
    const six_link_real t17 = tip->Lambda[7] * link->R_T[4];
    const six_link_real t18 = t13 + tip->Lambda[6] * link->R_T[3] + t17;
    const six_link_real t19 = tip->Lambda[6] * link->R_T[4] - tip->Lambda[1] * link->R_T[2]
        + tip->Lambda[7] * link->R_T[5];
    const six_link_real t20 = tip->Lambda[2] * link->R_T[1] + tip->Lambda[7] * link->R_T[3]
        + tip->Lambda[11] * link->R_T[4];
    const six_link_real t21 = t17 - t14 + tip->Lambda[11] * link->R_T[5];
    const six_link_real t22 = link->R_T[1]
        * (tip->Lambda[1] * link->R_T[0] - tip->Lambda[6] * link->R_T[1] + tip->Lambda[7] * link->R_T[2]);
    const six_link_real t23 = link->R_T[2]
        * (tip->Lambda[2] * link->R_T[0] - tip->Lambda[7] * link->R_T[1] + tip->Lambda[11] * link->R_T[2]);
    const six_link_real Lambda_T_11 = link->R_T[0] * (tip->Lambda[0] * link->R_T[0] - t13 + t14) - t22 + t23;
    const six_link_real Lambda_T_12 = link->R_T[0] * t15 - link->R_T[1] * t18 + link->R_T[2] * t20;
    const six_link_real Lambda_T_13 = link->R_T[0] * t16 - link->R_T[1] * t19 + link->R_T[2] * t21;
    const six_link_real Lambda_T_22 = link->R_T[1] * t15 + link->R_T[3] * t18 + link->R_T[4] * t20;
    const six_link_real Lambda_T_23 = link->R_T[1] * t16 + link->R_T[3] * t19 + link->R_T[4] * t21;
    const six_link_real Lambda_T_33 = link->R_T[4] * t19 - link->R_T[2] * t16 + link->R_T[5] * t21;
    const six_link_real t24 = tip->Lambda[3] * link->R_T[0] - tip->Lambda[4] * link->R_T[1]
        + tip->Lambda[5] * link->R_T[2];
    const six_link_real t25 = tip->Lambda[3] * link->R_T[1] + tip->Lambda[4] * link->R_T[3]
        + tip->Lambda[5] * link->R_T[4];
    const six_link_real t26 = tip->Lambda[4] * link->R_T[4] - tip->Lambda[3] * link->R_T[2]
        + tip->Lambda[5] * link->R_T[5];
    const six_link_real t27 = tip->Lambda[8] * link->R_T[0] - tip->Lambda[9] * link->R_T[1]
        + tip->Lambda[10] * link->R_T[2];
    const six_link_real t28 = tip->Lambda[8] * link->R_T[1] + tip->Lambda[9] * link->R_T[3]
        + tip->Lambda[10] * link->R_T[4];
    const six_link_real t29 = tip->Lambda[9] * link->R_T[4] - tip->Lambda[8] * link->R_T[2]
        + tip->Lambda[10] * link->R_T[5];
    const six_link_real t30 = tip->Lambda[12] * link->R_T[0] - tip->Lambda[13] * link->R_T[1]
        + tip->Lambda[14] * link->R_T[2];
    const six_link_real t31 = tip->Lambda[12] * link->R_T[1] + tip->Lambda[13] * link->R_T[3]
        + tip->Lambda[14] * link->R_T[4];
    const six_link_real t32 = tip->Lambda[13] * link->R_T[4] - tip->Lambda[12] * link->R_T[2]
        + tip->Lambda[14] * link->R_T[5];
    const six_link_real Lambda_T_14 = link->R_T[0] * t24 - link->R_T[1] * t27 + link->R_T[2] * t30;
    const six_link_real Lambda_T_15 = link->R_T[0] * t25 - link->R_T[1] * t28 + link->R_T[2] * t31;
    const six_link_real Lambda_T_16 = link->R_T[0] * t26 - link->R_T[1] * t29 + link->R_T[2] * t32;
    const six_link_real Lambda_T_24 = link->R_T[1] * t24 + link->R_T[3] * t27 + link->R_T[4] * t30;
    const six_link_real Lambda_T_25 = link->R_T[1] * t25 + link->R_T[3] * t28 + link->R_T[4] * t31;
    const six_link_real Lambda_T_26 = link->R_T[1] * t26 + link->R_T[3] * t29 + link->R_T[4] * t32;
    const six_link_real Lambda_T_34 = link->R_T[4] * t27 - link->R_T[2] * t24 + link->R_T[5] * t30;
    const six_link_real Lambda_T_35 = link->R_T[4] * t28 - link->R_T[2] * t25 + link->R_T[5] * t31;
    const six_link_real Lambda_T_36 = link->R_T[4] * t29 - link->R_T[2] * t26 + link->R_T[5] * t32;
    const six_link_real t33 = tip->Lambda[16] * link->R_T[1];
    const six_link_real t34 = tip->Lambda[17] * link->R_T[2];
    const six_link_real t35 = tip->Lambda[15] * link->R_T[1] + tip->Lambda[16] * link->R_T[3]
        + tip->Lambda[17] * link->R_T[4];
    const six_link_real t36 = tip->Lambda[16] * link->R_T[4] - tip->Lambda[15] * link->R_T[2]
        + tip->Lambda[17] * link->R_T[5];
    const six_link_real t37 = tip->Lambda[19] * link->R_T[4];
    const six_link_real t38 = t33 + tip->Lambda[18] * link->R_T[3] + t37;
    const six_link_real t39 = tip->Lambda[18] * link->R_T[4] - tip->Lambda[16] * link->R_T[2]
        + tip->Lambda[19] * link->R_T[5];
    const six_link_real t40 = tip->Lambda[17] * link->R_T[1] + tip->Lambda[19] * link->R_T[3]
        + tip->Lambda[20] * link->R_T[4];
    const six_link_real t41 = t37 - t34 + tip->Lambda[20] * link->R_T[5];
    const six_link_real t42 = link->R_T[1]
        * (tip->Lambda[16] * link->R_T[0] - tip->Lambda[18] * link->R_T[1] + tip->Lambda[19] * link->R_T[2]);
    const six_link_real t43 = link->R_T[2]
        * (tip->Lambda[17] * link->R_T[0] - tip->Lambda[19] * link->R_T[1] + tip->Lambda[20] * link->R_T[2]);
    const six_link_real Lambda_T_44 = link->R_T[0] * (tip->Lambda[15] * link->R_T[0] - t33 + t34) - t42 + t43;
    const six_link_real Lambda_T_45 = link->R_T[0] * t35 - link->R_T[1] * t38 + link->R_T[2] * t40;
    const six_link_real Lambda_T_46 = link->R_T[0] * t36 - link->R_T[1] * t39 + link->R_T[2] * t41;
    const six_link_real Lambda_T_55 = link->R_T[1] * t35 + link->R_T[3] * t38 + link->R_T[4] * t40;
    const six_link_real Lambda_T_56 = link->R_T[1] * t36 + link->R_T[3] * t39 + link->R_T[4] * t41;
    const six_link_real Lambda_T_66 = link->R_T[4] * t39 - link->R_T[2] * t36 + link->R_T[5] * t41;
    const six_link_real p_T_1 = link->R_T[0] * t7 - link->R_T[1] * t8 + link->R_T[2] * t9;
    const six_link_real p_T_2 = link->R_T[1] * t7 + link->R_T[3] * t8 + link->R_T[4] * t9;
    const six_link_real p_T_3 = link->R_T[4] * t8 - link->R_T[2] * t7 + link->R_T[5] * t9;
    const six_link_real p_T_4 = link->R_T[0] * t10 - link->R_T[1] * t11 + link->R_T[2] * t12;
    const six_link_real p_T_5 = link->R_T[1] * t10 + link->R_T[3] * t11 + link->R_T[4] * t12;
    const six_link_real p_T_6 = link->R_T[4] * t11 - link->R_T[2] * t10 + link->R_T[5] * t12;

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t44 = link->r_T[1] * Lambda_T_45;
    const six_link_real t45 = link->r_T[0] * Lambda_T_46;
    const six_link_real t46 = c->length * Lambda_T_56;
    const six_link_real M_loaded_14 = Lambda_T_14 + (t45 - t44);
    const six_link_real t47 = Lambda_T_15 + (link->r_T[0] * Lambda_T_56 - link->r_T[1] * Lambda_T_55);
    const six_link_real t48 = Lambda_T_16 + (link->r_T[0] * Lambda_T_66 - link->r_T[1] * Lambda_T_56);
    const six_link_real t49 = Lambda_T_24 + (link->r_T[1] * Lambda_T_44 - c->length * Lambda_T_46);
    const six_link_real M_loaded_25 = Lambda_T_25 + (t44 - t46);
    const six_link_real t50 = Lambda_T_26 + (link->r_T[1] * Lambda_T_46 - c->length * Lambda_T_66);
    const six_link_real t51 = Lambda_T_34 + (c->length * Lambda_T_45 - link->r_T[0] * Lambda_T_44);
    const six_link_real t52 = Lambda_T_35 + (c->length * Lambda_T_55 - link->r_T[0] * Lambda_T_45);
    const six_link_real M_loaded_36 = Lambda_T_36 + (t46 - t45);
    const six_link_real t53 = Lambda_T_11 - (Lambda_T_15 * link->r_T[1] - Lambda_T_16 * link->r_T[0])
        + (link->r_T[0] * t48 - link->r_T[1] * t47);
    const six_link_real t54 = Lambda_T_12 - (Lambda_T_16 * c->length - Lambda_T_14 * link->r_T[1])
        + (link->r_T[0] * t50 - link->r_T[1] * M_loaded_25);
    const six_link_real t55 = Lambda_T_13 - (Lambda_T_14 * link->r_T[0] - Lambda_T_15 * c->length)
        + (link->r_T[0] * M_loaded_36 - link->r_T[1] * t52);
    const six_link_real t56 = Lambda_T_22 - (Lambda_T_26 * c->length - Lambda_T_24 * link->r_T[1])
        + (link->r_T[1] * t49 - c->length * t50);
    const six_link_real t57 = Lambda_T_23 - (Lambda_T_24 * link->r_T[0] - Lambda_T_25 * c->length)
        + (link->r_T[1] * t51 - c->length * M_loaded_36);
    const six_link_real t58 = Lambda_T_33 - (Lambda_T_34 * link->r_T[0] - Lambda_T_35 * c->length)
        + (c->length * t52 - link->r_T[0] * t51);
    const six_link_real M_loaded_11 = link->M_V[0] + t53;
    const six_link_real M_loaded_12 = t54 - link->M_V[1];
    const six_link_real M_loaded_13 = t55 - link->M_V[2];
    const six_link_real M_loaded_15 = t47 - link->M_V[3];
    const six_link_real M_loaded_16 = link->M_V[4] + t48;
    const six_link_real M_loaded_22 = link->M_V[5] + t56;
    const six_link_real M_loaded_23 = t57 - link->M_V[6];
    const six_link_real M_loaded_24 = link->M_V[3] + t49;
    const six_link_real M_loaded_26 = t50 - c->S_0_x;
    const six_link_real M_loaded_33 = link->M_V[7] + t58;
    const six_link_real M_loaded_34 = t51 - link->M_V[4];
    const six_link_real M_loaded_35 = c->S_0_x + t52;
    const six_link_real M_loaded_44 = c->m + Lambda_T_44;
    const six_link_real M_loaded_55 = c->m + Lambda_T_55;
    const six_link_real M_loaded_66 = c->m + Lambda_T_66;
    const six_link_real h_loaded_1 = link->h_V[0] + (p_T_1 + (link->r_T[0] * p_T_6 - link->r_T[1] * p_T_5));
    const six_link_real h_loaded_2 = link->h_V[1] + (p_T_2 + (link->r_T[1] * p_T_4 - c->length * p_T_6));
    const six_link_real h_loaded_3 = link->h_V[2] + (p_T_3 + (c->length * p_T_5 - link->r_T[0] * p_T_4));
    const six_link_real h_loaded_4 = link->h_V[3] + p_T_4;
    const six_link_real h_loaded_5 = link->h_V[4] + p_T_5;
    const six_link_real h_loaded_6 = link->h_V[5] + p_T_6;
    const six_link_real t59 = Lambda_T_12 * link->G[3] - Lambda_T_11 * link->G[1] + Lambda_T_13 * link->G[4];
    const six_link_real t60 = Lambda_T_11 * link->G[2] + Lambda_T_12 * link->G[4] + Lambda_T_13 * link->G[5];
    const six_link_real t61 = Lambda_T_23 * link->G[4];
    const six_link_real t62 = Lambda_T_22 * link->G[3] - Lambda_T_12 * link->G[1] + t61;
    const six_link_real t63 = Lambda_T_12 * link->G[2] + Lambda_T_22 * link->G[4] + Lambda_T_23 * link->G[5];
    const six_link_real t64 = Lambda_T_23 * link->G[3] - Lambda_T_13 * link->G[1] + Lambda_T_33 * link->G[4];
    const six_link_real t65 = Lambda_T_13 * link->G[2] + t61 + Lambda_T_33 * link->G[5];
    const six_link_real t66 = Lambda_T_15 * link->G[2] + Lambda_T_25 * link->G[4] + Lambda_T_35 * link->G[5];
    const six_link_real t67 = Lambda_T_26 * link->G[3] - Lambda_T_16 * link->G[1] + Lambda_T_36 * link->G[4];
    const six_link_real t68 = Lambda_T_16 * link->G[2] + Lambda_T_26 * link->G[4] + Lambda_T_36 * link->G[5];
    const six_link_real C_41 = (Lambda_T_14 * link->G[2] + Lambda_T_24 * link->G[4] + Lambda_T_34 * link->G[5])
        * c->Psi_c_z1 + Lambda_T_45 * REAL(2.23606797749979);
    const six_link_real C_42 = (Lambda_T_24 * link->G[3] - Lambda_T_14 * link->G[1] + Lambda_T_34 * link->G[4])
        * c->Psi_c_y2 + Lambda_T_46 * REAL(2.23606797749979);
    const six_link_real t69 = t66 * c->Psi_c_z1 + Lambda_T_55 * REAL(2.23606797749979);
    const six_link_real t70 = Lambda_T_56 * REAL(2.23606797749979);
    const six_link_real C_52 = (Lambda_T_25 * link->G[3] - Lambda_T_15 * link->G[1] + Lambda_T_35 * link->G[4])
        * c->Psi_c_y2 + t70;
    const six_link_real C_61 = t68 * c->Psi_c_z1 + t70;
    const six_link_real t71 = t67 * c->Psi_c_y2 + Lambda_T_66 * REAL(2.23606797749979);
    const six_link_real t72 = t60 * c->Psi_c_z1 + Lambda_T_15 * REAL(2.23606797749979)
        + (link->r_T[0] * C_61 - link->r_T[1] * t69);
    const six_link_real C_21 = t63 * c->Psi_c_z1 + Lambda_T_25 * REAL(2.23606797749979)
        + (link->r_T[1] * C_41 - c->length * C_61);
    const six_link_real t73 = t65 * c->Psi_c_z1 + Lambda_T_35 * REAL(2.23606797749979)
        + (c->length * t69 - link->r_T[0] * C_41);
    const six_link_real t74 = t59 * c->Psi_c_y2 + Lambda_T_16 * REAL(2.23606797749979)
        + (link->r_T[0] * t71 - link->r_T[1] * C_52);
    const six_link_real t75 = t62 * c->Psi_c_y2 + Lambda_T_26 * REAL(2.23606797749979)
        + (link->r_T[1] * C_42 - c->length * t71);
    const six_link_real C_32 = t64 * c->Psi_c_y2 + Lambda_T_36 * REAL(2.23606797749979)
        + (c->length * C_52 - link->r_T[0] * C_42);
    const six_link_real C_11 = t72 - link->M_D[0];
    const six_link_real C_12 = link->M_D[1] + t74;
    const six_link_real C_22 = t75 - c->chi_2;
    const six_link_real C_31 = c->chi_1 + t73;
    const six_link_real C_51 = c->sigma_y1 + t69;
    const six_link_real C_62 = c->sigma_z2 + t71;
    const six_link_real t76 = (link->G[3] * t62 - link->G[1] * t59 + link->G[4] * t64) * c->Psi_c_y2
        + t67 * REAL(2.23606797749979);
    const six_link_real t77 = (link->G[2] * t60 + link->G[4] * t63 + link->G[5] * t65) * c->Psi_c_z1
        + t66 * REAL(2.23606797749979);
    const six_link_real t78 = (link->G[3] * t63 - link->G[1] * t60 + link->G[4] * t65) * c->Psi_c_y2
        + t68 * REAL(2.23606797749979);
    const six_link_real modal_inertia_12 = c->Psi_c_z1 * t78 + C_52 * REAL(2.23606797749979);
    const six_link_real modal_inertia_11 = c->Psi_c_z1 * t77 + t69 * REAL(2.23606797749979) + m_eta[0];
    if (!(modal_inertia_11 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modal_inertia_22 = c->Psi_c_y2 * t76 + t71 * REAL(2.23606797749979) + m_eta[1];
    const six_link_real t79 = c->Psi_c_z1 * (link->G[2] * p_T_1 + link->G[4] * p_T_2 + link->G[5] * p_T_3)
        + p_T_5 * REAL(2.23606797749979);
    const six_link_real t80 = c->Psi_c_y2 * (link->G[3] * p_T_2 - link->G[1] * p_T_1 + link->G[4] * p_T_3)
        + p_T_6 * REAL(2.23606797749979);
    const six_link_real h_phi_1 = link->h_eta[0] + f_eta[0] + t79;
    const six_link_real h_phi_2 = link->h_eta[1] + f_eta[1] + t80;
    const six_link_real modes_inverse_1 = 1 / modal_inertia_11;
    const six_link_real modes_L_21 = modal_inertia_12 * modes_inverse_1;
    const six_link_real t81 = modal_inertia_22 - modal_inertia_12 * modes_L_21;
    if (!(t81 > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real modes_inverse_2 = 1 / t81;
    const six_link_real t82 = C_12 - modes_L_21 * C_11;
    const six_link_real t83 = C_22 - modes_L_21 * C_21;
    const six_link_real t84 = C_32 - modes_L_21 * C_31;
    const six_link_real t85 = C_42 - modes_L_21 * C_41;
    const six_link_real t86 = C_52 - modes_L_21 * C_51;
    const six_link_real t87 = C_62 - modes_L_21 * C_61;
    const six_link_real t88 = h_phi_2 - modes_L_21 * h_phi_1;
    const six_link_real modes_W_11 = C_11 * modes_inverse_1;
    const six_link_real modes_W_12 = C_21 * modes_inverse_1;
    const six_link_real modes_W_13 = C_31 * modes_inverse_1;
    const six_link_real modes_W_14 = C_41 * modes_inverse_1;
    const six_link_real modes_W_15 = C_51 * modes_inverse_1;
    const six_link_real modes_W_16 = C_61 * modes_inverse_1;
    const six_link_real modes_W_21 = t82 * modes_inverse_2;
    const six_link_real modes_W_22 = t83 * modes_inverse_2;
    const six_link_real modes_W_23 = t84 * modes_inverse_2;
    const six_link_real modes_W_24 = t85 * modes_inverse_2;
    const six_link_real modes_W_25 = t86 * modes_inverse_2;
    const six_link_real modes_W_26 = t87 * modes_inverse_2;
    const six_link_real modes_w_1 = h_phi_1 * modes_inverse_1;
    const six_link_real modes_w_2 = t88 * modes_inverse_2;
    const six_link_real M_i_11 = M_loaded_11 - (C_11 * modes_W_11 + t82 * modes_W_21);
    const six_link_real M_i_12 = M_loaded_12 - (C_11 * modes_W_12 + t82 * modes_W_22);
    const six_link_real M_i_13 = M_loaded_13 - (C_11 * modes_W_13 + t82 * modes_W_23);
    const six_link_real M_i_14 = M_loaded_14 - (C_11 * modes_W_14 + t82 * modes_W_24);
    const six_link_real M_i_15 = M_loaded_15 - (C_11 * modes_W_15 + t82 * modes_W_25);
    const six_link_real M_i_16 = M_loaded_16 - (C_11 * modes_W_16 + t82 * modes_W_26);
    const six_link_real M_i_22 = M_loaded_22 - (C_21 * modes_W_12 + t83 * modes_W_22);
    const six_link_real M_i_23 = M_loaded_23 - (C_21 * modes_W_13 + t83 * modes_W_23);
    const six_link_real M_i_24 = M_loaded_24 - (C_21 * modes_W_14 + t83 * modes_W_24);
    const six_link_real M_i_25 = M_loaded_25 - (C_21 * modes_W_15 + t83 * modes_W_25);
    const six_link_real M_i_26 = M_loaded_26 - (C_21 * modes_W_16 + t83 * modes_W_26);
    const six_link_real M_i_33 = M_loaded_33 - (C_31 * modes_W_13 + t84 * modes_W_23);
    const six_link_real M_i_34 = M_loaded_34 - (C_31 * modes_W_14 + t84 * modes_W_24);
    const six_link_real M_i_35 = M_loaded_35 - (C_31 * modes_W_15 + t84 * modes_W_25);
    const six_link_real M_i_36 = M_loaded_36 - (C_31 * modes_W_16 + t84 * modes_W_26);
    const six_link_real M_i_44 = M_loaded_44 - (C_41 * modes_W_14 + t85 * modes_W_24);
    const six_link_real M_i_45 = Lambda_T_45 - (C_41 * modes_W_15 + t85 * modes_W_25);
    const six_link_real M_i_46 = Lambda_T_46 - (C_41 * modes_W_16 + t85 * modes_W_26);
    const six_link_real M_i_55 = M_loaded_55 - (C_51 * modes_W_15 + t86 * modes_W_25);
    const six_link_real M_i_56 = Lambda_T_56 - (C_51 * modes_W_16 + t86 * modes_W_26);
    const six_link_real M_i_66 = M_loaded_66 - (C_61 * modes_W_16 + t87 * modes_W_26);
    const six_link_real h_i_1 = h_loaded_1 - (modes_W_11 * h_phi_1 + modes_W_21 * t88);
    const six_link_real h_i_2 = h_loaded_2 - (modes_W_12 * h_phi_1 + modes_W_22 * t88);
    const six_link_real h_i_3 = h_loaded_3 - (modes_W_13 * h_phi_1 + modes_W_23 * t88);
    const six_link_real h_i_4 = h_loaded_4 - (modes_W_14 * h_phi_1 + modes_W_24 * t88);
    const six_link_real h_i_5 = h_loaded_5 - (modes_W_15 * h_phi_1 + modes_W_25 * t88);
    const six_link_real h_i_6 = h_loaded_6 - (modes_W_16 * h_phi_1 + modes_W_26 * t88);

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real t89 = M_i_13 * link->beta[1] - M_i_11 * link->beta[0] - M_i_14 * link->beta[2]
        + M_i_16 * link->beta[3];
    const six_link_real t90 = M_i_23 * link->beta[1] - M_i_12 * link->beta[0] - M_i_24 * link->beta[2]
        + M_i_26 * link->beta[3];
    const six_link_real t91 = M_i_33 * link->beta[1] - M_i_13 * link->beta[0] - M_i_34 * link->beta[2]
        + M_i_36 * link->beta[3];
    const six_link_real t92 = M_i_34 * link->beta[1] - M_i_14 * link->beta[0] - M_i_44 * link->beta[2]
        + M_i_46 * link->beta[3];
    const six_link_real t93 = M_i_35 * link->beta[1] - M_i_15 * link->beta[0] - M_i_45 * link->beta[2]
        + M_i_56 * link->beta[3];
    const six_link_real t94 = M_i_36 * link->beta[1] - M_i_16 * link->beta[0] - M_i_46 * link->beta[2]
        + M_i_66 * link->beta[3];
    const six_link_real bias_1 = h_i_1 + t89;
    const six_link_real bias_2 = h_i_2 + t90;
    const six_link_real bias_3 = h_i_3 + t91;
    const six_link_real bias_4 = h_i_4 + t92;
    const six_link_real bias_5 = h_i_5 + t93;
    const six_link_real bias_6 = h_i_6 + t94;
    const six_link_real joint_inertia_11 = M_i_22 + c->armature_1;
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8 * (M_i_11 + M_i_22 + M_i_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_i_12 * joint_inverse_1;
    const six_link_real joint_W_12 = M_i_22 * joint_inverse_1;
    const six_link_real joint_W_13 = M_i_23 * joint_inverse_1;
    const six_link_real joint_W_14 = M_i_24 * joint_inverse_1;
    const six_link_real joint_W_15 = M_i_25 * joint_inverse_1;
    const six_link_real joint_W_16 = M_i_26 * joint_inverse_1;
    const six_link_real joint_w_1 = (tau[0] - c->joint_damping_1 * qdot[0] - bias_2) * joint_inverse_1;
    const six_link_real Lambda_i_11 = M_i_11 - M_i_12 * joint_W_11;
    const six_link_real Lambda_i_12 = M_i_12 - M_i_12 * joint_W_12;
    const six_link_real Lambda_i_13 = M_i_13 - M_i_12 * joint_W_13;
    const six_link_real Lambda_i_14 = M_i_14 - M_i_12 * joint_W_14;
    const six_link_real Lambda_i_15 = M_i_15 - M_i_12 * joint_W_15;
    const six_link_real Lambda_i_16 = M_i_16 - M_i_12 * joint_W_16;
    const six_link_real Lambda_i_22 = M_i_22 - M_i_22 * joint_W_12;
    const six_link_real Lambda_i_23 = M_i_23 - M_i_22 * joint_W_13;
    const six_link_real Lambda_i_24 = M_i_24 - M_i_22 * joint_W_14;
    const six_link_real Lambda_i_25 = M_i_25 - M_i_22 * joint_W_15;
    const six_link_real Lambda_i_26 = M_i_26 - M_i_22 * joint_W_16;
    const six_link_real Lambda_i_33 = M_i_33 - M_i_23 * joint_W_13;
    const six_link_real Lambda_i_34 = M_i_34 - M_i_23 * joint_W_14;
    const six_link_real Lambda_i_35 = M_i_35 - M_i_23 * joint_W_15;
    const six_link_real Lambda_i_36 = M_i_36 - M_i_23 * joint_W_16;
    const six_link_real Lambda_i_44 = M_i_44 - M_i_24 * joint_W_14;
    const six_link_real Lambda_i_45 = M_i_45 - M_i_24 * joint_W_15;
    const six_link_real Lambda_i_46 = M_i_46 - M_i_24 * joint_W_16;
    const six_link_real Lambda_i_55 = M_i_55 - M_i_25 * joint_W_15;
    const six_link_real Lambda_i_56 = M_i_56 - M_i_25 * joint_W_16;
    const six_link_real Lambda_i_66 = M_i_66 - M_i_26 * joint_W_16;
    const six_link_real p_i_1 = bias_1 + M_i_12 * joint_w_1;
    const six_link_real p_i_2 = bias_2 + M_i_22 * joint_w_1;
    const six_link_real p_i_3 = bias_3 + M_i_23 * joint_w_1;
    const six_link_real p_i_4 = bias_4 + M_i_24 * joint_w_1;
    const six_link_real p_i_5 = bias_5 + M_i_25 * joint_w_1;
    const six_link_real p_i_6 = bias_6 + M_i_26 * joint_w_1;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t95 = Lambda_i_11 * link->R_rel[2] + Lambda_i_12 * c->R_m_yy
        + Lambda_i_13 * link->R_rel[3];
    const six_link_real t96 = Lambda_i_11 * link->R_rel[4] + Lambda_i_12 * c->R_m_zy
        + Lambda_i_13 * link->R_rel[5];
    const six_link_real t97 = Lambda_i_12 * link->R_rel[2] + Lambda_i_22 * c->R_m_yy
        + Lambda_i_23 * link->R_rel[3];
    const six_link_real t98 = Lambda_i_12 * link->R_rel[4] + Lambda_i_22 * c->R_m_zy
        + Lambda_i_23 * link->R_rel[5];
    const six_link_real t99 = Lambda_i_13 * link->R_rel[2] + Lambda_i_23 * c->R_m_yy
        + Lambda_i_33 * link->R_rel[3];
    const six_link_real t100 = Lambda_i_13 * link->R_rel[4] + Lambda_i_23 * c->R_m_zy
        + Lambda_i_33 * link->R_rel[5];
    const six_link_real t101 = link->R_rel[0]
        * (Lambda_i_11 * link->R_rel[0] + Lambda_i_12 * c->R_m_xy + Lambda_i_13 * link->R_rel[1]);
    const six_link_real t102 = c->R_m_xy
        * (Lambda_i_12 * link->R_rel[0] + Lambda_i_22 * c->R_m_xy + Lambda_i_23 * link->R_rel[1]);
    const six_link_real t103 = link->R_rel[1]
        * (Lambda_i_13 * link->R_rel[0] + Lambda_i_23 * c->R_m_xy + Lambda_i_33 * link->R_rel[1]);
    const six_link_real t104 = Lambda_i_14 * link->R_rel[0] + Lambda_i_15 * c->R_m_xy
        + Lambda_i_16 * link->R_rel[1];
    const six_link_real t105 = Lambda_i_14 * link->R_rel[2] + Lambda_i_15 * c->R_m_yy
        + Lambda_i_16 * link->R_rel[3];
    const six_link_real t106 = Lambda_i_14 * link->R_rel[4] + Lambda_i_15 * c->R_m_zy
        + Lambda_i_16 * link->R_rel[5];
    const six_link_real t107 = Lambda_i_24 * link->R_rel[0] + Lambda_i_25 * c->R_m_xy
        + Lambda_i_26 * link->R_rel[1];
    const six_link_real t108 = Lambda_i_24 * link->R_rel[2] + Lambda_i_25 * c->R_m_yy
        + Lambda_i_26 * link->R_rel[3];
    const six_link_real t109 = Lambda_i_24 * link->R_rel[4] + Lambda_i_25 * c->R_m_zy
        + Lambda_i_26 * link->R_rel[5];
    const six_link_real t110 = Lambda_i_34 * link->R_rel[0] + Lambda_i_35 * c->R_m_xy
        + Lambda_i_36 * link->R_rel[1];
    const six_link_real t111 = Lambda_i_34 * link->R_rel[2] + Lambda_i_35 * c->R_m_yy
        + Lambda_i_36 * link->R_rel[3];
    const six_link_real t112 = Lambda_i_34 * link->R_rel[4] + Lambda_i_35 * c->R_m_zy
        + Lambda_i_36 * link->R_rel[5];
    const six_link_real t113 = link->R_rel[0] * t104 + c->R_m_xy * t107 + link->R_rel[1] * t110;
    const six_link_real t114 = link->R_rel[0] * t105 + c->R_m_xy * t108 + link->R_rel[1] * t111;
    const six_link_real t115 = link->R_rel[0] * t106 + c->R_m_xy * t109 + link->R_rel[1] * t112;
    const six_link_real t116 = link->R_rel[2] * t104 + c->R_m_yy * t107 + link->R_rel[3] * t110;
    const six_link_real t117 = link->R_rel[2] * t105 + c->R_m_yy * t108 + link->R_rel[3] * t111;
    const six_link_real t118 = link->R_rel[2] * t106 + c->R_m_yy * t109 + link->R_rel[3] * t112;
    const six_link_real t119 = link->R_rel[4] * t104 + c->R_m_zy * t107 + link->R_rel[5] * t110;
    const six_link_real t120 = link->R_rel[4] * t105 + c->R_m_zy * t108 + link->R_rel[5] * t111;
    const six_link_real t121 = Lambda_i_44 * link->R_rel[2] + Lambda_i_45 * c->R_m_yy
        + Lambda_i_46 * link->R_rel[3];
    const six_link_real t122 = Lambda_i_44 * link->R_rel[4] + Lambda_i_45 * c->R_m_zy
        + Lambda_i_46 * link->R_rel[5];
    const six_link_real t123 = Lambda_i_45 * link->R_rel[2] + Lambda_i_55 * c->R_m_yy
        + Lambda_i_56 * link->R_rel[3];
    const six_link_real t124 = Lambda_i_45 * link->R_rel[4] + Lambda_i_55 * c->R_m_zy
        + Lambda_i_56 * link->R_rel[5];
    const six_link_real t125 = Lambda_i_46 * link->R_rel[2] + Lambda_i_56 * c->R_m_yy
        + Lambda_i_66 * link->R_rel[3];
    const six_link_real t126 = Lambda_i_46 * link->R_rel[4] + Lambda_i_56 * c->R_m_zy
        + Lambda_i_66 * link->R_rel[5];
    const six_link_real t127 = link->R_rel[0]
        * (Lambda_i_44 * link->R_rel[0] + Lambda_i_45 * c->R_m_xy + Lambda_i_46 * link->R_rel[1]);
    const six_link_real t128 = c->R_m_xy
        * (Lambda_i_45 * link->R_rel[0] + Lambda_i_55 * c->R_m_xy + Lambda_i_56 * link->R_rel[1]);
    const six_link_real t129 = link->R_rel[1]
        * (Lambda_i_46 * link->R_rel[0] + Lambda_i_56 * c->R_m_xy + Lambda_i_66 * link->R_rel[1]);
    const six_link_real Lambda_16 = t127 + t128 + t129;
    const six_link_real Lambda_17 = link->R_rel[0] * t121 + c->R_m_xy * t123 + link->R_rel[1] * t125;
    const six_link_real Lambda_18 = link->R_rel[0] * t122 + c->R_m_xy * t124 + link->R_rel[1] * t126;
    const six_link_real Lambda_19 = link->R_rel[2] * t121 + c->R_m_yy * t123 + link->R_rel[3] * t125;
    const six_link_real Lambda_20 = link->R_rel[2] * t122 + c->R_m_yy * t124 + link->R_rel[3] * t126;
    const six_link_real Lambda_21 = link->R_rel[4] * t122 + c->R_m_zy * t124 + link->R_rel[5] * t126;
    const six_link_real t130 = c->mount_xyz_z * Lambda_17;
    const six_link_real t131 = c->mount_xyz_y * Lambda_18;
    const six_link_real t132 = c->mount_xyz_x * Lambda_20;
    const six_link_real Lambda_4 = t113 + (t131 - t130);
    const six_link_real Lambda_5 = t114 + (c->mount_xyz_y * Lambda_20 - c->mount_xyz_z * Lambda_19);
    const six_link_real Lambda_6 = t115 + (c->mount_xyz_y * Lambda_21 - c->mount_xyz_z * Lambda_20);
    const six_link_real Lambda_9 = t116 + (c->mount_xyz_z * Lambda_16 - c->mount_xyz_x * Lambda_18);
    const six_link_real Lambda_10 = t117 + (t130 - t132);
    const six_link_real Lambda_11 = t118 + (c->mount_xyz_z * Lambda_18 - c->mount_xyz_x * Lambda_21);
    const six_link_real Lambda_13 = t119 + (c->mount_xyz_x * Lambda_17 - c->mount_xyz_y * Lambda_16);
    const six_link_real Lambda_14 = t120 + (c->mount_xyz_x * Lambda_19 - c->mount_xyz_y * Lambda_17);
    const six_link_real Lambda_15 = link->R_rel[4] * t106 + c->R_m_zy * t109 + link->R_rel[5] * t112
        + (t132 - t131);
    const six_link_real Lambda_1 = t101 + t102 + t103 - (t114 * c->mount_xyz_z - t115 * c->mount_xyz_y)
        + (c->mount_xyz_y * Lambda_6 - c->mount_xyz_z * Lambda_5);
    const six_link_real t133 = link->R_rel[0] * t95 + c->R_m_xy * t97 + link->R_rel[1] * t99
        - (t115 * c->mount_xyz_x - t113 * c->mount_xyz_z);
    const six_link_real Lambda_2 = t133 + (c->mount_xyz_y * Lambda_11 - c->mount_xyz_z * Lambda_10);
    const six_link_real t134 = link->R_rel[0] * t96 + c->R_m_xy * t98 + link->R_rel[1] * t100
        - (t113 * c->mount_xyz_y - t114 * c->mount_xyz_x);
    const six_link_real Lambda_3 = t134 + (c->mount_xyz_y * Lambda_15 - c->mount_xyz_z * Lambda_14);
    const six_link_real t135 = link->R_rel[2] * t95 + c->R_m_yy * t97 + link->R_rel[3] * t99
        - (t118 * c->mount_xyz_x - t116 * c->mount_xyz_z);
    const six_link_real Lambda_7 = t135 + (c->mount_xyz_z * Lambda_9 - c->mount_xyz_x * Lambda_11);
    const six_link_real t136 = link->R_rel[2] * t96 + c->R_m_yy * t98 + link->R_rel[3] * t100
        - (t116 * c->mount_xyz_y - t117 * c->mount_xyz_x);
    const six_link_real Lambda_8 = t136 + (c->mount_xyz_z * Lambda_13 - c->mount_xyz_x * Lambda_15);
    const six_link_real t137 = link->R_rel[4] * t96 + c->R_m_zy * t98 + link->R_rel[5] * t100
        - (t119 * c->mount_xyz_y - t120 * c->mount_xyz_x);
    const six_link_real Lambda_12 = t137 + (c->mount_xyz_x * Lambda_14 - c->mount_xyz_y * Lambda_13);
    const six_link_real p_4 = link->R_rel[0] * p_i_4 + c->R_m_xy * p_i_5 + link->R_rel[1] * p_i_6;
    const six_link_real p_5 = link->R_rel[2] * p_i_4 + c->R_m_yy * p_i_5 + link->R_rel[3] * p_i_6;
    const six_link_real p_6 = link->R_rel[4] * p_i_4 + c->R_m_zy * p_i_5 + link->R_rel[5] * p_i_6;
    const six_link_real p_1 = link->R_rel[0] * p_i_1 + c->R_m_xy * p_i_2 + link->R_rel[1] * p_i_3
        + (c->mount_xyz_y * p_6 - c->mount_xyz_z * p_5);
    const six_link_real p_2 = link->R_rel[2] * p_i_1 + c->R_m_yy * p_i_2 + link->R_rel[3] * p_i_3
        + (c->mount_xyz_z * p_4 - c->mount_xyz_x * p_6);
    const six_link_real p_3 = link->R_rel[4] * p_i_1 + c->R_m_zy * p_i_2 + link->R_rel[5] * p_i_3
        + (c->mount_xyz_x * p_5 - c->mount_xyz_y * p_4);

    /* outputs */
    link->modes_L[0] = modes_L_21;
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
    link->modes_w[0] = modes_w_1;
    link->modes_w[1] = modes_w_2;
    link->joint_W[0] = joint_W_11;
    link->joint_W[1] = joint_W_12;
    link->joint_W[2] = joint_W_13;
    link->joint_W[3] = joint_W_14;
    link->joint_W[4] = joint_W_15;
    link->joint_W[5] = joint_W_16;
    link->joint_w[0] = joint_w_1;
    link->Lambda_i[0] = Lambda_i_11;
    link->Lambda_i[1] = Lambda_i_12;
    link->Lambda_i[2] = Lambda_i_13;
    link->Lambda_i[3] = Lambda_i_14;
    link->Lambda_i[4] = Lambda_i_15;
    link->Lambda_i[5] = Lambda_i_16;
    link->Lambda_i[6] = Lambda_i_22;
    link->Lambda_i[7] = Lambda_i_23;
    link->Lambda_i[8] = Lambda_i_24;
    link->Lambda_i[9] = Lambda_i_25;
    link->Lambda_i[10] = Lambda_i_26;
    link->Lambda_i[11] = Lambda_i_33;
    link->Lambda_i[12] = Lambda_i_34;
    link->Lambda_i[13] = Lambda_i_35;
    link->Lambda_i[14] = Lambda_i_36;
    link->Lambda_i[15] = Lambda_i_44;
    link->Lambda_i[16] = Lambda_i_45;
    link->Lambda_i[17] = Lambda_i_46;
    link->Lambda_i[18] = Lambda_i_55;
    link->Lambda_i[19] = Lambda_i_56;
    link->Lambda_i[20] = Lambda_i_66;
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
    return SIX_LINK_OK;
}

/* eliminate, links like wrist_roll: 267 operations */
static six_link_status eliminate_wrist_roll(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base,
    const six_link_node *tip, const six_link_real w_ext[6], const six_link_real tau[1],
    const six_link_real qdot[1])
{

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_1 = tip->p[0] - w_ext[0];
    const six_link_real p_T_2 = tip->p[1] - w_ext[1];
    const six_link_real p_T_3 = tip->p[2] - w_ext[2];
    const six_link_real p_T_4 = tip->p[3] - w_ext[3];
    const six_link_real p_T_5 = tip->p[4] - w_ext[4];
    const six_link_real p_T_6 = tip->p[5] - w_ext[5];

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t1 = c->length * tip->Lambda[19];
    const six_link_real M_loaded_24 = tip->Lambda[8] - c->length * tip->Lambda[17];
    const six_link_real M_loaded_25 = tip->Lambda[9] - t1;
    const six_link_real t2 = tip->Lambda[10] - c->length * tip->Lambda[20];
    const six_link_real M_loaded_34 = tip->Lambda[12] + c->length * tip->Lambda[16];
    const six_link_real t3 = tip->Lambda[13] + c->length * tip->Lambda[18];
    const six_link_real M_loaded_36 = tip->Lambda[14] + t1;
    const six_link_real M_loaded_12 = tip->Lambda[1] - tip->Lambda[5] * c->length;
    const six_link_real M_loaded_13 = tip->Lambda[2] + tip->Lambda[4] * c->length;
    const six_link_real M_loaded_23 = tip->Lambda[7] + tip->Lambda[9] * c->length - c->length * M_loaded_36;
    const six_link_real M_loaded_11 = c->I_s + tip->Lambda[0];
    const six_link_real M_loaded_22 = c->J_0_xx + (tip->Lambda[6] - tip->Lambda[10] * c->length - c->length * t2);
    const six_link_real M_loaded_26 = t2 - c->S_0_x;
    const six_link_real M_loaded_33 = c->J_0_xx
        + (tip->Lambda[11] + tip->Lambda[13] * c->length + c->length * t3);
    const six_link_real M_loaded_35 = c->S_0_x + t3;
    const six_link_real M_loaded_44 = c->mu + tip->Lambda[15];
    const six_link_real M_loaded_55 = c->mu + tip->Lambda[18];
    const six_link_real M_loaded_66 = c->mu + tip->Lambda[20];
    const six_link_real h_loaded_2 = link->h_V[0] + (p_T_2 - c->length * p_T_6);
    const six_link_real h_loaded_3 = link->h_V[1] + (p_T_3 + c->length * p_T_5);
    const six_link_real h_loaded_4 = link->h_V[2] + p_T_4;
    const six_link_real h_loaded_5 = link->h_V[3] + p_T_5;
    const six_link_real h_loaded_6 = link->h_V[4] + p_T_6;

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real t4 = M_loaded_12 * link->beta[0] - M_loaded_13 * link->beta[1]
        + tip->Lambda[4] * link->beta[2] - tip->Lambda[5] * link->beta[3];
    const six_link_real t5 = M_loaded_22 * link->beta[0] - M_loaded_23 * link->beta[1]
        + M_loaded_25 * link->beta[2] - M_loaded_26 * link->beta[3];
    const six_link_real t6 = M_loaded_23 * link->beta[0] - M_loaded_33 * link->beta[1]
        + M_loaded_35 * link->beta[2] - M_loaded_36 * link->beta[3];
    const six_link_real t7 = M_loaded_24 * link->beta[0] - M_loaded_34 * link->beta[1]
        + tip->Lambda[16] * link->beta[2] - tip->Lambda[17] * link->beta[3];
    const six_link_real t8 = M_loaded_25 * link->beta[0] - M_loaded_35 * link->beta[1]
        + M_loaded_55 * link->beta[2] - tip->Lambda[19] * link->beta[3];
    const six_link_real t9 = M_loaded_26 * link->beta[0] - M_loaded_36 * link->beta[1]
        + tip->Lambda[19] * link->beta[2] - M_loaded_66 * link->beta[3];
    const six_link_real bias_1 = p_T_1 + t4;
    const six_link_real bias_2 = h_loaded_2 + t5;
    const six_link_real bias_3 = h_loaded_3 + t6;
    const six_link_real bias_4 = h_loaded_4 + t7;
    const six_link_real bias_5 = h_loaded_5 + t8;
    const six_link_real bias_6 = h_loaded_6 + t9;
    const six_link_real joint_inertia_11 = M_loaded_11 + c->armature_1;
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8 * (M_loaded_11 + M_loaded_22 + M_loaded_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_loaded_11 * joint_inverse_1;
    const six_link_real joint_W_12 = M_loaded_12 * joint_inverse_1;
    const six_link_real joint_W_13 = M_loaded_13 * joint_inverse_1;
    const six_link_real joint_W_14 = tip->Lambda[3] * joint_inverse_1;
    const six_link_real joint_W_15 = tip->Lambda[4] * joint_inverse_1;
    const six_link_real joint_W_16 = tip->Lambda[5] * joint_inverse_1;
    const six_link_real joint_w_1 = (tau[0] - c->joint_damping_1 * qdot[0] - bias_1) * joint_inverse_1;
    const six_link_real Lambda_i_11 = M_loaded_11 - M_loaded_11 * joint_W_11;
    const six_link_real Lambda_i_12 = M_loaded_12 - M_loaded_11 * joint_W_12;
    const six_link_real Lambda_i_13 = M_loaded_13 - M_loaded_11 * joint_W_13;
    const six_link_real Lambda_i_14 = tip->Lambda[3] - M_loaded_11 * joint_W_14;
    const six_link_real Lambda_i_15 = tip->Lambda[4] - M_loaded_11 * joint_W_15;
    const six_link_real Lambda_i_16 = tip->Lambda[5] - M_loaded_11 * joint_W_16;
    const six_link_real Lambda_i_22 = M_loaded_22 - M_loaded_12 * joint_W_12;
    const six_link_real Lambda_i_23 = M_loaded_23 - M_loaded_12 * joint_W_13;
    const six_link_real Lambda_i_24 = M_loaded_24 - M_loaded_12 * joint_W_14;
    const six_link_real Lambda_i_25 = M_loaded_25 - M_loaded_12 * joint_W_15;
    const six_link_real Lambda_i_26 = M_loaded_26 - M_loaded_12 * joint_W_16;
    const six_link_real Lambda_i_33 = M_loaded_33 - M_loaded_13 * joint_W_13;
    const six_link_real Lambda_i_34 = M_loaded_34 - M_loaded_13 * joint_W_14;
    const six_link_real Lambda_i_35 = M_loaded_35 - M_loaded_13 * joint_W_15;
    const six_link_real Lambda_i_36 = M_loaded_36 - M_loaded_13 * joint_W_16;
    const six_link_real Lambda_i_44 = M_loaded_44 - tip->Lambda[3] * joint_W_14;
    const six_link_real Lambda_i_45 = tip->Lambda[16] - tip->Lambda[3] * joint_W_15;
    const six_link_real Lambda_i_46 = tip->Lambda[17] - tip->Lambda[3] * joint_W_16;
    const six_link_real Lambda_i_55 = M_loaded_55 - tip->Lambda[4] * joint_W_15;
    const six_link_real Lambda_i_56 = tip->Lambda[19] - tip->Lambda[4] * joint_W_16;
    const six_link_real Lambda_i_66 = M_loaded_66 - tip->Lambda[5] * joint_W_16;
    const six_link_real p_i_1 = bias_1 + M_loaded_11 * joint_w_1;
    const six_link_real p_i_2 = bias_2 + M_loaded_12 * joint_w_1;
    const six_link_real p_i_3 = bias_3 + M_loaded_13 * joint_w_1;
    const six_link_real p_i_4 = bias_4 + tip->Lambda[3] * joint_w_1;
    const six_link_real p_i_5 = bias_5 + tip->Lambda[4] * joint_w_1;
    const six_link_real p_i_6 = bias_6 + tip->Lambda[5] * joint_w_1;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real Lambda_2 = Lambda_i_12 * link->R_rel[0] - Lambda_i_13 * link->R_rel[1];
    const six_link_real Lambda_3 = Lambda_i_12 * link->R_rel[1] + Lambda_i_13 * link->R_rel[0];
    const six_link_real t10 = Lambda_i_23 * link->R_rel[1];
    const six_link_real t11 = Lambda_i_23 * link->R_rel[0];
    const six_link_real t12 = Lambda_i_22 * link->R_rel[1] + t11;
    const six_link_real t13 = t10 + Lambda_i_33 * link->R_rel[0];
    const six_link_real Lambda_7 = link->R_rel[0] * (Lambda_i_22 * link->R_rel[0] - t10)
        - link->R_rel[1] * (t11 - Lambda_i_33 * link->R_rel[1]);
    const six_link_real Lambda_8 = link->R_rel[0] * t12 - link->R_rel[1] * t13;
    const six_link_real Lambda_12 = link->R_rel[1] * t12 + link->R_rel[0] * t13;
    const six_link_real Lambda_5 = Lambda_i_15 * link->R_rel[0] - Lambda_i_16 * link->R_rel[1];
    const six_link_real Lambda_6 = Lambda_i_15 * link->R_rel[1] + Lambda_i_16 * link->R_rel[0];
    const six_link_real t14 = Lambda_i_25 * link->R_rel[0] - Lambda_i_26 * link->R_rel[1];
    const six_link_real t15 = Lambda_i_25 * link->R_rel[1] + Lambda_i_26 * link->R_rel[0];
    const six_link_real t16 = Lambda_i_35 * link->R_rel[0] - Lambda_i_36 * link->R_rel[1];
    const six_link_real t17 = Lambda_i_35 * link->R_rel[1] + Lambda_i_36 * link->R_rel[0];
    const six_link_real Lambda_9 = link->R_rel[0] * Lambda_i_24 - link->R_rel[1] * Lambda_i_34;
    const six_link_real Lambda_10 = link->R_rel[0] * t14 - link->R_rel[1] * t16;
    const six_link_real Lambda_11 = link->R_rel[0] * t15 - link->R_rel[1] * t17;
    const six_link_real Lambda_13 = link->R_rel[1] * Lambda_i_24 + link->R_rel[0] * Lambda_i_34;
    const six_link_real Lambda_14 = link->R_rel[1] * t14 + link->R_rel[0] * t16;
    const six_link_real Lambda_15 = link->R_rel[1] * t15 + link->R_rel[0] * t17;
    const six_link_real Lambda_17 = Lambda_i_45 * link->R_rel[0] - Lambda_i_46 * link->R_rel[1];
    const six_link_real Lambda_18 = Lambda_i_45 * link->R_rel[1] + Lambda_i_46 * link->R_rel[0];
    const six_link_real t18 = Lambda_i_56 * link->R_rel[1];
    const six_link_real t19 = Lambda_i_56 * link->R_rel[0];
    const six_link_real t20 = Lambda_i_55 * link->R_rel[1] + t19;
    const six_link_real t21 = t18 + Lambda_i_66 * link->R_rel[0];
    const six_link_real Lambda_19 = link->R_rel[0] * (Lambda_i_55 * link->R_rel[0] - t18)
        - link->R_rel[1] * (t19 - Lambda_i_66 * link->R_rel[1]);
    const six_link_real Lambda_20 = link->R_rel[0] * t20 - link->R_rel[1] * t21;
    const six_link_real Lambda_21 = link->R_rel[1] * t20 + link->R_rel[0] * t21;
    const six_link_real p_2 = link->R_rel[0] * p_i_2 - link->R_rel[1] * p_i_3;
    const six_link_real p_3 = link->R_rel[1] * p_i_2 + link->R_rel[0] * p_i_3;
    const six_link_real p_5 = link->R_rel[0] * p_i_5 - link->R_rel[1] * p_i_6;
    const six_link_real p_6 = link->R_rel[1] * p_i_5 + link->R_rel[0] * p_i_6;

    /* outputs */
    link->joint_W[0] = joint_W_11;
    link->joint_W[1] = joint_W_12;
    link->joint_W[2] = joint_W_13;
    link->joint_W[3] = joint_W_14;
    link->joint_W[4] = joint_W_15;
    link->joint_W[5] = joint_W_16;
    link->joint_w[0] = joint_w_1;
    link->Lambda_i[0] = Lambda_i_11;
    link->Lambda_i[1] = Lambda_i_12;
    link->Lambda_i[2] = Lambda_i_13;
    link->Lambda_i[3] = Lambda_i_14;
    link->Lambda_i[4] = Lambda_i_15;
    link->Lambda_i[5] = Lambda_i_16;
    link->Lambda_i[6] = Lambda_i_22;
    link->Lambda_i[7] = Lambda_i_23;
    link->Lambda_i[8] = Lambda_i_24;
    link->Lambda_i[9] = Lambda_i_25;
    link->Lambda_i[10] = Lambda_i_26;
    link->Lambda_i[11] = Lambda_i_33;
    link->Lambda_i[12] = Lambda_i_34;
    link->Lambda_i[13] = Lambda_i_35;
    link->Lambda_i[14] = Lambda_i_36;
    link->Lambda_i[15] = Lambda_i_44;
    link->Lambda_i[16] = Lambda_i_45;
    link->Lambda_i[17] = Lambda_i_46;
    link->Lambda_i[18] = Lambda_i_55;
    link->Lambda_i[19] = Lambda_i_56;
    link->Lambda_i[20] = Lambda_i_66;
    link->p_i[0] = p_i_1;
    link->p_i[1] = p_i_2;
    link->p_i[2] = p_i_3;
    link->p_i[3] = p_i_4;
    link->p_i[4] = p_i_5;
    link->p_i[5] = p_i_6;
    base->Lambda[0] = Lambda_i_11;
    base->Lambda[1] = Lambda_2;
    base->Lambda[2] = Lambda_3;
    base->Lambda[3] = Lambda_i_14;
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
    base->Lambda[15] = Lambda_i_44;
    base->Lambda[16] = Lambda_17;
    base->Lambda[17] = Lambda_18;
    base->Lambda[18] = Lambda_19;
    base->Lambda[19] = Lambda_20;
    base->Lambda[20] = Lambda_21;
    base->p[0] = p_i_1;
    base->p[1] = p_2;
    base->p[2] = p_3;
    base->p[3] = p_i_4;
    base->p[4] = p_5;
    base->p[5] = p_6;
    return SIX_LINK_OK;
}

/* eliminate, links like wrist_pitch: 267 operations */
static six_link_status eliminate_wrist_pitch(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base,
    const six_link_node *tip, const six_link_real w_ext[6], const six_link_real tau[1],
    const six_link_real qdot[1])
{

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_1 = tip->p[0] - w_ext[0];
    const six_link_real p_T_2 = tip->p[1] - w_ext[1];
    const six_link_real p_T_3 = tip->p[2] - w_ext[2];
    const six_link_real p_T_4 = tip->p[3] - w_ext[3];
    const six_link_real p_T_5 = tip->p[4] - w_ext[4];
    const six_link_real p_T_6 = tip->p[5] - w_ext[5];

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t1 = c->length * tip->Lambda[19];
    const six_link_real M_loaded_24 = tip->Lambda[8] - c->length * tip->Lambda[17];
    const six_link_real M_loaded_25 = tip->Lambda[9] - t1;
    const six_link_real t2 = tip->Lambda[10] - c->length * tip->Lambda[20];
    const six_link_real M_loaded_34 = tip->Lambda[12] + c->length * tip->Lambda[16];
    const six_link_real t3 = tip->Lambda[13] + c->length * tip->Lambda[18];
    const six_link_real M_loaded_36 = tip->Lambda[14] + t1;
    const six_link_real M_loaded_12 = tip->Lambda[1] - tip->Lambda[5] * c->length;
    const six_link_real M_loaded_13 = tip->Lambda[2] + tip->Lambda[4] * c->length;
    const six_link_real M_loaded_23 = tip->Lambda[7] + tip->Lambda[9] * c->length - c->length * M_loaded_36;
    const six_link_real M_loaded_11 = c->I_s + tip->Lambda[0];
    const six_link_real M_loaded_22 = c->J_0_xx + (tip->Lambda[6] - tip->Lambda[10] * c->length - c->length * t2);
    const six_link_real M_loaded_26 = t2 - c->S_0_x;
    const six_link_real M_loaded_33 = c->J_0_xx
        + (tip->Lambda[11] + tip->Lambda[13] * c->length + c->length * t3);
    const six_link_real M_loaded_35 = c->S_0_x + t3;
    const six_link_real M_loaded_44 = c->mu + tip->Lambda[15];
    const six_link_real M_loaded_55 = c->mu + tip->Lambda[18];
    const six_link_real M_loaded_66 = c->mu + tip->Lambda[20];
    const six_link_real h_loaded_2 = link->h_V[0] + (p_T_2 - c->length * p_T_6);
    const six_link_real h_loaded_3 = link->h_V[1] + (p_T_3 + c->length * p_T_5);
    const six_link_real h_loaded_4 = link->h_V[2] + p_T_4;
    const six_link_real h_loaded_5 = link->h_V[3] + p_T_5;
    const six_link_real h_loaded_6 = link->h_V[4] + p_T_6;

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real t4 = M_loaded_13 * link->beta[1] - M_loaded_11 * link->beta[0]
        - tip->Lambda[3] * link->beta[2] + tip->Lambda[5] * link->beta[3];
    const six_link_real t5 = M_loaded_23 * link->beta[1] - M_loaded_12 * link->beta[0]
        - M_loaded_24 * link->beta[2] + M_loaded_26 * link->beta[3];
    const six_link_real t6 = M_loaded_33 * link->beta[1] - M_loaded_13 * link->beta[0]
        - M_loaded_34 * link->beta[2] + M_loaded_36 * link->beta[3];
    const six_link_real t7 = M_loaded_34 * link->beta[1] - tip->Lambda[3] * link->beta[0]
        - M_loaded_44 * link->beta[2] + tip->Lambda[17] * link->beta[3];
    const six_link_real t8 = M_loaded_35 * link->beta[1] - tip->Lambda[4] * link->beta[0]
        - tip->Lambda[16] * link->beta[2] + tip->Lambda[19] * link->beta[3];
    const six_link_real t9 = M_loaded_36 * link->beta[1] - tip->Lambda[5] * link->beta[0]
        - tip->Lambda[17] * link->beta[2] + M_loaded_66 * link->beta[3];
    const six_link_real bias_1 = p_T_1 + t4;
    const six_link_real bias_2 = h_loaded_2 + t5;
    const six_link_real bias_3 = h_loaded_3 + t6;
    const six_link_real bias_4 = h_loaded_4 + t7;
    const six_link_real bias_5 = h_loaded_5 + t8;
    const six_link_real bias_6 = h_loaded_6 + t9;
    const six_link_real joint_inertia_11 = M_loaded_22 + c->armature_1;
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8 * (M_loaded_11 + M_loaded_22 + M_loaded_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_loaded_12 * joint_inverse_1;
    const six_link_real joint_W_12 = M_loaded_22 * joint_inverse_1;
    const six_link_real joint_W_13 = M_loaded_23 * joint_inverse_1;
    const six_link_real joint_W_14 = M_loaded_24 * joint_inverse_1;
    const six_link_real joint_W_15 = M_loaded_25 * joint_inverse_1;
    const six_link_real joint_W_16 = M_loaded_26 * joint_inverse_1;
    const six_link_real joint_w_1 = (tau[0] - c->joint_damping_1 * qdot[0] - bias_2) * joint_inverse_1;
    const six_link_real Lambda_i_11 = M_loaded_11 - M_loaded_12 * joint_W_11;
    const six_link_real Lambda_i_12 = M_loaded_12 - M_loaded_12 * joint_W_12;
    const six_link_real Lambda_i_13 = M_loaded_13 - M_loaded_12 * joint_W_13;
    const six_link_real Lambda_i_14 = tip->Lambda[3] - M_loaded_12 * joint_W_14;
    const six_link_real Lambda_i_15 = tip->Lambda[4] - M_loaded_12 * joint_W_15;
    const six_link_real Lambda_i_16 = tip->Lambda[5] - M_loaded_12 * joint_W_16;
    const six_link_real Lambda_i_22 = M_loaded_22 - M_loaded_22 * joint_W_12;
    const six_link_real Lambda_i_23 = M_loaded_23 - M_loaded_22 * joint_W_13;
    const six_link_real Lambda_i_24 = M_loaded_24 - M_loaded_22 * joint_W_14;
    const six_link_real Lambda_i_25 = M_loaded_25 - M_loaded_22 * joint_W_15;
    const six_link_real Lambda_i_26 = M_loaded_26 - M_loaded_22 * joint_W_16;
    const six_link_real Lambda_i_33 = M_loaded_33 - M_loaded_23 * joint_W_13;
    const six_link_real Lambda_i_34 = M_loaded_34 - M_loaded_23 * joint_W_14;
    const six_link_real Lambda_i_35 = M_loaded_35 - M_loaded_23 * joint_W_15;
    const six_link_real Lambda_i_36 = M_loaded_36 - M_loaded_23 * joint_W_16;
    const six_link_real Lambda_i_44 = M_loaded_44 - M_loaded_24 * joint_W_14;
    const six_link_real Lambda_i_45 = tip->Lambda[16] - M_loaded_24 * joint_W_15;
    const six_link_real Lambda_i_46 = tip->Lambda[17] - M_loaded_24 * joint_W_16;
    const six_link_real Lambda_i_55 = M_loaded_55 - M_loaded_25 * joint_W_15;
    const six_link_real Lambda_i_56 = tip->Lambda[19] - M_loaded_25 * joint_W_16;
    const six_link_real Lambda_i_66 = M_loaded_66 - M_loaded_26 * joint_W_16;
    const six_link_real p_i_1 = bias_1 + M_loaded_12 * joint_w_1;
    const six_link_real p_i_2 = bias_2 + M_loaded_22 * joint_w_1;
    const six_link_real p_i_3 = bias_3 + M_loaded_23 * joint_w_1;
    const six_link_real p_i_4 = bias_4 + M_loaded_24 * joint_w_1;
    const six_link_real p_i_5 = bias_5 + M_loaded_25 * joint_w_1;
    const six_link_real p_i_6 = bias_6 + M_loaded_26 * joint_w_1;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t10 = Lambda_i_13 * link->R_rel[1];
    const six_link_real t11 = Lambda_i_13 * link->R_rel[0];
    const six_link_real t12 = t11 - Lambda_i_11 * link->R_rel[1];
    const six_link_real Lambda_2 = Lambda_i_12 * link->R_rel[0] + Lambda_i_23 * link->R_rel[1];
    const six_link_real Lambda_8 = Lambda_i_23 * link->R_rel[0] - Lambda_i_12 * link->R_rel[1];
    const six_link_real t13 = Lambda_i_33 * link->R_rel[0] - t10;
    const six_link_real Lambda_1 = link->R_rel[0] * (Lambda_i_11 * link->R_rel[0] + t10)
        + link->R_rel[1] * (t11 + Lambda_i_33 * link->R_rel[1]);
    const six_link_real Lambda_3 = link->R_rel[0] * t12 + link->R_rel[1] * t13;
    const six_link_real Lambda_12 = link->R_rel[0] * t13 - link->R_rel[1] * t12;
    const six_link_real t14 = Lambda_i_14 * link->R_rel[0] + Lambda_i_16 * link->R_rel[1];
    const six_link_real t15 = Lambda_i_16 * link->R_rel[0] - Lambda_i_14 * link->R_rel[1];
    const six_link_real Lambda_9 = Lambda_i_24 * link->R_rel[0] + Lambda_i_26 * link->R_rel[1];
    const six_link_real Lambda_11 = Lambda_i_26 * link->R_rel[0] - Lambda_i_24 * link->R_rel[1];
    const six_link_real t16 = Lambda_i_34 * link->R_rel[0] + Lambda_i_36 * link->R_rel[1];
    const six_link_real t17 = Lambda_i_36 * link->R_rel[0] - Lambda_i_34 * link->R_rel[1];
    const six_link_real Lambda_4 = link->R_rel[0] * t14 + link->R_rel[1] * t16;
    const six_link_real Lambda_5 = link->R_rel[0] * Lambda_i_15 + link->R_rel[1] * Lambda_i_35;
    const six_link_real Lambda_6 = link->R_rel[0] * t15 + link->R_rel[1] * t17;
    const six_link_real Lambda_13 = link->R_rel[0] * t16 - link->R_rel[1] * t14;
    const six_link_real Lambda_14 = link->R_rel[0] * Lambda_i_35 - link->R_rel[1] * Lambda_i_15;
    const six_link_real Lambda_15 = link->R_rel[0] * t17 - link->R_rel[1] * t15;
    const six_link_real t18 = Lambda_i_46 * link->R_rel[1];
    const six_link_real t19 = Lambda_i_46 * link->R_rel[0];
    const six_link_real t20 = t19 - Lambda_i_44 * link->R_rel[1];
    const six_link_real Lambda_17 = Lambda_i_45 * link->R_rel[0] + Lambda_i_56 * link->R_rel[1];
    const six_link_real Lambda_20 = Lambda_i_56 * link->R_rel[0] - Lambda_i_45 * link->R_rel[1];
    const six_link_real t21 = Lambda_i_66 * link->R_rel[0] - t18;
    const six_link_real Lambda_16 = link->R_rel[0] * (Lambda_i_44 * link->R_rel[0] + t18)
        + link->R_rel[1] * (t19 + Lambda_i_66 * link->R_rel[1]);
    const six_link_real Lambda_18 = link->R_rel[0] * t20 + link->R_rel[1] * t21;
    const six_link_real Lambda_21 = link->R_rel[0] * t21 - link->R_rel[1] * t20;
    const six_link_real p_1 = link->R_rel[0] * p_i_1 + link->R_rel[1] * p_i_3;
    const six_link_real p_3 = link->R_rel[0] * p_i_3 - link->R_rel[1] * p_i_1;
    const six_link_real p_4 = link->R_rel[0] * p_i_4 + link->R_rel[1] * p_i_6;
    const six_link_real p_6 = link->R_rel[0] * p_i_6 - link->R_rel[1] * p_i_4;

    /* outputs */
    link->joint_W[0] = joint_W_11;
    link->joint_W[1] = joint_W_12;
    link->joint_W[2] = joint_W_13;
    link->joint_W[3] = joint_W_14;
    link->joint_W[4] = joint_W_15;
    link->joint_W[5] = joint_W_16;
    link->joint_w[0] = joint_w_1;
    link->Lambda_i[0] = Lambda_i_11;
    link->Lambda_i[1] = Lambda_i_12;
    link->Lambda_i[2] = Lambda_i_13;
    link->Lambda_i[3] = Lambda_i_14;
    link->Lambda_i[4] = Lambda_i_15;
    link->Lambda_i[5] = Lambda_i_16;
    link->Lambda_i[6] = Lambda_i_22;
    link->Lambda_i[7] = Lambda_i_23;
    link->Lambda_i[8] = Lambda_i_24;
    link->Lambda_i[9] = Lambda_i_25;
    link->Lambda_i[10] = Lambda_i_26;
    link->Lambda_i[11] = Lambda_i_33;
    link->Lambda_i[12] = Lambda_i_34;
    link->Lambda_i[13] = Lambda_i_35;
    link->Lambda_i[14] = Lambda_i_36;
    link->Lambda_i[15] = Lambda_i_44;
    link->Lambda_i[16] = Lambda_i_45;
    link->Lambda_i[17] = Lambda_i_46;
    link->Lambda_i[18] = Lambda_i_55;
    link->Lambda_i[19] = Lambda_i_56;
    link->Lambda_i[20] = Lambda_i_66;
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
    base->Lambda[6] = Lambda_i_22;
    base->Lambda[7] = Lambda_8;
    base->Lambda[8] = Lambda_9;
    base->Lambda[9] = Lambda_i_25;
    base->Lambda[10] = Lambda_11;
    base->Lambda[11] = Lambda_12;
    base->Lambda[12] = Lambda_13;
    base->Lambda[13] = Lambda_14;
    base->Lambda[14] = Lambda_15;
    base->Lambda[15] = Lambda_16;
    base->Lambda[16] = Lambda_17;
    base->Lambda[17] = Lambda_18;
    base->Lambda[18] = Lambda_i_55;
    base->Lambda[19] = Lambda_20;
    base->Lambda[20] = Lambda_21;
    base->p[0] = p_1;
    base->p[1] = p_i_2;
    base->p[2] = p_3;
    base->p[3] = p_4;
    base->p[4] = p_i_5;
    base->p[5] = p_6;
    return SIX_LINK_OK;
}

/* eliminate, links like flange: 288 operations */
static six_link_status eliminate_flange(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base,
    const six_link_node *tip, const six_link_real w_ext[6], const six_link_real tau[1],
    const six_link_real qdot[1])
{

    /* tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real Lambda_T_11 = tip->Lambda[0] + c->I_T_xx;
    const six_link_real Lambda_T_12 = tip->Lambda[1] - c->J_T_xy;
    const six_link_real Lambda_T_13 = tip->Lambda[2] - c->J_T_xz;
    const six_link_real Lambda_T_15 = tip->Lambda[4] - c->S_T_z;
    const six_link_real Lambda_T_16 = tip->Lambda[5] + c->S_T_y;
    const six_link_real Lambda_T_22 = tip->Lambda[6] + c->I_T_yy;
    const six_link_real Lambda_T_23 = tip->Lambda[7] - c->J_T_yz;
    const six_link_real Lambda_T_24 = tip->Lambda[8] + c->S_T_z;
    const six_link_real Lambda_T_26 = tip->Lambda[10] - c->S_T_x;
    const six_link_real Lambda_T_33 = tip->Lambda[11] + c->I_T_zz;
    const six_link_real Lambda_T_34 = tip->Lambda[12] - c->S_T_y;
    const six_link_real Lambda_T_35 = tip->Lambda[13] + c->S_T_x;
    const six_link_real Lambda_T_44 = tip->Lambda[15] + c->body0_mass;
    const six_link_real Lambda_T_55 = tip->Lambda[18] + c->body0_mass;
    const six_link_real Lambda_T_66 = tip->Lambda[20] + c->body0_mass;
    const six_link_real p_T_1 = tip->p[0] + link->h_T[0] - w_ext[0];
    const six_link_real p_T_2 = tip->p[1] + link->h_T[1] - w_ext[1];
    const six_link_real p_T_3 = tip->p[2] + link->h_T[2] - w_ext[2];
    const six_link_real p_T_4 = tip->p[3] + link->h_T[3] - w_ext[3];
    const six_link_real p_T_5 = tip->p[4] + link->h_T[4] - w_ext[4];
    const six_link_real p_T_6 = tip->p[5] + link->h_T[5] - w_ext[5];

    /* modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t1 = c->length * tip->Lambda[19];
    const six_link_real M_loaded_24 = Lambda_T_24 - c->length * tip->Lambda[17];
    const six_link_real M_loaded_25 = tip->Lambda[9] - t1;
    const six_link_real t2 = Lambda_T_26 - c->length * Lambda_T_66;
    const six_link_real M_loaded_34 = Lambda_T_34 + c->length * tip->Lambda[16];
    const six_link_real t3 = Lambda_T_35 + c->length * Lambda_T_55;
    const six_link_real M_loaded_36 = tip->Lambda[14] + t1;
    const six_link_real M_loaded_12 = Lambda_T_12 - Lambda_T_16 * c->length;
    const six_link_real M_loaded_13 = Lambda_T_13 + Lambda_T_15 * c->length;
    const six_link_real M_loaded_23 = Lambda_T_23 + tip->Lambda[9] * c->length - c->length * M_loaded_36;
    const six_link_real M_loaded_11 = c->I_s + Lambda_T_11;
    const six_link_real M_loaded_22 = c->J_0_xx + (Lambda_T_22 - Lambda_T_26 * c->length - c->length * t2);
    const six_link_real M_loaded_26 = t2 - c->S_0_x;
    const six_link_real M_loaded_33 = c->J_0_xx + (Lambda_T_33 + Lambda_T_35 * c->length + c->length * t3);
    const six_link_real M_loaded_35 = c->S_0_x + t3;
    const six_link_real M_loaded_44 = c->mu + Lambda_T_44;
    const six_link_real M_loaded_55 = c->mu + Lambda_T_55;
    const six_link_real M_loaded_66 = c->mu + Lambda_T_66;
    const six_link_real h_loaded_2 = link->h_V[0] + (p_T_2 - c->length * p_T_6);
    const six_link_real h_loaded_3 = link->h_V[1] + (p_T_3 + c->length * p_T_5);
    const six_link_real h_loaded_4 = link->h_V[2] + p_T_4;
    const six_link_real h_loaded_5 = link->h_V[3] + p_T_5;
    const six_link_real h_loaded_6 = link->h_V[4] + p_T_6;

    /* joint: its accelerations eliminated from its rows (43) */
    const six_link_real t4 = M_loaded_12 * link->beta[0] - M_loaded_13 * link->beta[1]
        + Lambda_T_15 * link->beta[2] - Lambda_T_16 * link->beta[3];
    const six_link_real t5 = M_loaded_22 * link->beta[0] - M_loaded_23 * link->beta[1]
        + M_loaded_25 * link->beta[2] - M_loaded_26 * link->beta[3];
    const six_link_real t6 = M_loaded_23 * link->beta[0] - M_loaded_33 * link->beta[1]
        + M_loaded_35 * link->beta[2] - M_loaded_36 * link->beta[3];
    const six_link_real t7 = M_loaded_24 * link->beta[0] - M_loaded_34 * link->beta[1]
        + tip->Lambda[16] * link->beta[2] - tip->Lambda[17] * link->beta[3];
    const six_link_real t8 = M_loaded_25 * link->beta[0] - M_loaded_35 * link->beta[1]
        + M_loaded_55 * link->beta[2] - tip->Lambda[19] * link->beta[3];
    const six_link_real t9 = M_loaded_26 * link->beta[0] - M_loaded_36 * link->beta[1]
        + tip->Lambda[19] * link->beta[2] - M_loaded_66 * link->beta[3];
    const six_link_real bias_1 = p_T_1 + t4;
    const six_link_real bias_2 = h_loaded_2 + t5;
    const six_link_real bias_3 = h_loaded_3 + t6;
    const six_link_real bias_4 = h_loaded_4 + t7;
    const six_link_real bias_5 = h_loaded_5 + t8;
    const six_link_real bias_6 = h_loaded_6 + t9;
    const six_link_real joint_inertia_11 = M_loaded_11 + c->armature_1;
    if (!(joint_inertia_11 - SIX_LINK_REAL_EPSILON * 8 * (M_loaded_11 + M_loaded_22 + M_loaded_33) > 0)) { return SIX_LINK_SINGULAR; }
    const six_link_real joint_inverse_1 = 1 / joint_inertia_11;
    const six_link_real joint_W_11 = M_loaded_11 * joint_inverse_1;
    const six_link_real joint_W_12 = M_loaded_12 * joint_inverse_1;
    const six_link_real joint_W_13 = M_loaded_13 * joint_inverse_1;
    const six_link_real joint_W_14 = tip->Lambda[3] * joint_inverse_1;
    const six_link_real joint_W_15 = Lambda_T_15 * joint_inverse_1;
    const six_link_real joint_W_16 = Lambda_T_16 * joint_inverse_1;
    const six_link_real joint_w_1 = (tau[0] - c->joint_damping_1 * qdot[0] - bias_1) * joint_inverse_1;
    const six_link_real Lambda_i_11 = M_loaded_11 - M_loaded_11 * joint_W_11;
    const six_link_real Lambda_i_12 = M_loaded_12 - M_loaded_11 * joint_W_12;
    const six_link_real Lambda_i_13 = M_loaded_13 - M_loaded_11 * joint_W_13;
    const six_link_real Lambda_i_14 = tip->Lambda[3] - M_loaded_11 * joint_W_14;
    const six_link_real Lambda_i_15 = Lambda_T_15 - M_loaded_11 * joint_W_15;
    const six_link_real Lambda_i_16 = Lambda_T_16 - M_loaded_11 * joint_W_16;
    const six_link_real Lambda_i_22 = M_loaded_22 - M_loaded_12 * joint_W_12;
    const six_link_real Lambda_i_23 = M_loaded_23 - M_loaded_12 * joint_W_13;
    const six_link_real Lambda_i_24 = M_loaded_24 - M_loaded_12 * joint_W_14;
    const six_link_real Lambda_i_25 = M_loaded_25 - M_loaded_12 * joint_W_15;
    const six_link_real Lambda_i_26 = M_loaded_26 - M_loaded_12 * joint_W_16;
    const six_link_real Lambda_i_33 = M_loaded_33 - M_loaded_13 * joint_W_13;
    const six_link_real Lambda_i_34 = M_loaded_34 - M_loaded_13 * joint_W_14;
    const six_link_real Lambda_i_35 = M_loaded_35 - M_loaded_13 * joint_W_15;
    const six_link_real Lambda_i_36 = M_loaded_36 - M_loaded_13 * joint_W_16;
    const six_link_real Lambda_i_44 = M_loaded_44 - tip->Lambda[3] * joint_W_14;
    const six_link_real Lambda_i_45 = tip->Lambda[16] - tip->Lambda[3] * joint_W_15;
    const six_link_real Lambda_i_46 = tip->Lambda[17] - tip->Lambda[3] * joint_W_16;
    const six_link_real Lambda_i_55 = M_loaded_55 - Lambda_T_15 * joint_W_15;
    const six_link_real Lambda_i_56 = tip->Lambda[19] - Lambda_T_15 * joint_W_16;
    const six_link_real Lambda_i_66 = M_loaded_66 - Lambda_T_16 * joint_W_16;
    const six_link_real p_i_1 = bias_1 + M_loaded_11 * joint_w_1;
    const six_link_real p_i_2 = bias_2 + M_loaded_12 * joint_w_1;
    const six_link_real p_i_3 = bias_3 + M_loaded_13 * joint_w_1;
    const six_link_real p_i_4 = bias_4 + tip->Lambda[3] * joint_w_1;
    const six_link_real p_i_5 = bias_5 + Lambda_T_15 * joint_w_1;
    const six_link_real p_i_6 = bias_6 + Lambda_T_16 * joint_w_1;

    /* handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real Lambda_2 = Lambda_i_12 * link->R_rel[0] - Lambda_i_13 * link->R_rel[1];
    const six_link_real Lambda_3 = Lambda_i_12 * link->R_rel[1] + Lambda_i_13 * link->R_rel[0];
    const six_link_real t10 = Lambda_i_23 * link->R_rel[1];
    const six_link_real t11 = Lambda_i_23 * link->R_rel[0];
    const six_link_real t12 = Lambda_i_22 * link->R_rel[1] + t11;
    const six_link_real t13 = t10 + Lambda_i_33 * link->R_rel[0];
    const six_link_real Lambda_7 = link->R_rel[0] * (Lambda_i_22 * link->R_rel[0] - t10)
        - link->R_rel[1] * (t11 - Lambda_i_33 * link->R_rel[1]);
    const six_link_real Lambda_8 = link->R_rel[0] * t12 - link->R_rel[1] * t13;
    const six_link_real Lambda_12 = link->R_rel[1] * t12 + link->R_rel[0] * t13;
    const six_link_real Lambda_5 = Lambda_i_15 * link->R_rel[0] - Lambda_i_16 * link->R_rel[1];
    const six_link_real Lambda_6 = Lambda_i_15 * link->R_rel[1] + Lambda_i_16 * link->R_rel[0];
    const six_link_real t14 = Lambda_i_25 * link->R_rel[0] - Lambda_i_26 * link->R_rel[1];
    const six_link_real t15 = Lambda_i_25 * link->R_rel[1] + Lambda_i_26 * link->R_rel[0];
    const six_link_real t16 = Lambda_i_35 * link->R_rel[0] - Lambda_i_36 * link->R_rel[1];
    const six_link_real t17 = Lambda_i_35 * link->R_rel[1] + Lambda_i_36 * link->R_rel[0];
    const six_link_real Lambda_9 = link->R_rel[0] * Lambda_i_24 - link->R_rel[1] * Lambda_i_34;
    const six_link_real Lambda_10 = link->R_rel[0] * t14 - link->R_rel[1] * t16;
    const six_link_real Lambda_11 = link->R_rel[0] * t15 - link->R_rel[1] * t17;
    const six_link_real Lambda_13 = link->R_rel[1] * Lambda_i_24 + link->R_rel[0] * Lambda_i_34;
    const six_link_real Lambda_14 = link->R_rel[1] * t14 + link->R_rel[0] * t16;
    const six_link_real Lambda_15 = link->R_rel[1] * t15 + link->R_rel[0] * t17;
    const six_link_real Lambda_17 = Lambda_i_45 * link->R_rel[0] - Lambda_i_46 * link->R_rel[1];
    const six_link_real Lambda_18 = Lambda_i_45 * link->R_rel[1] + Lambda_i_46 * link->R_rel[0];
    const six_link_real t18 = Lambda_i_56 * link->R_rel[1];
    const six_link_real t19 = Lambda_i_56 * link->R_rel[0];
    const six_link_real t20 = Lambda_i_55 * link->R_rel[1] + t19;
    const six_link_real t21 = t18 + Lambda_i_66 * link->R_rel[0];
    const six_link_real Lambda_19 = link->R_rel[0] * (Lambda_i_55 * link->R_rel[0] - t18)
        - link->R_rel[1] * (t19 - Lambda_i_66 * link->R_rel[1]);
    const six_link_real Lambda_20 = link->R_rel[0] * t20 - link->R_rel[1] * t21;
    const six_link_real Lambda_21 = link->R_rel[1] * t20 + link->R_rel[0] * t21;
    const six_link_real p_2 = link->R_rel[0] * p_i_2 - link->R_rel[1] * p_i_3;
    const six_link_real p_3 = link->R_rel[1] * p_i_2 + link->R_rel[0] * p_i_3;
    const six_link_real p_5 = link->R_rel[0] * p_i_5 - link->R_rel[1] * p_i_6;
    const six_link_real p_6 = link->R_rel[1] * p_i_5 + link->R_rel[0] * p_i_6;

    /* outputs */
    link->joint_W[0] = joint_W_11;
    link->joint_W[1] = joint_W_12;
    link->joint_W[2] = joint_W_13;
    link->joint_W[3] = joint_W_14;
    link->joint_W[4] = joint_W_15;
    link->joint_W[5] = joint_W_16;
    link->joint_w[0] = joint_w_1;
    link->Lambda_i[0] = Lambda_i_11;
    link->Lambda_i[1] = Lambda_i_12;
    link->Lambda_i[2] = Lambda_i_13;
    link->Lambda_i[3] = Lambda_i_14;
    link->Lambda_i[4] = Lambda_i_15;
    link->Lambda_i[5] = Lambda_i_16;
    link->Lambda_i[6] = Lambda_i_22;
    link->Lambda_i[7] = Lambda_i_23;
    link->Lambda_i[8] = Lambda_i_24;
    link->Lambda_i[9] = Lambda_i_25;
    link->Lambda_i[10] = Lambda_i_26;
    link->Lambda_i[11] = Lambda_i_33;
    link->Lambda_i[12] = Lambda_i_34;
    link->Lambda_i[13] = Lambda_i_35;
    link->Lambda_i[14] = Lambda_i_36;
    link->Lambda_i[15] = Lambda_i_44;
    link->Lambda_i[16] = Lambda_i_45;
    link->Lambda_i[17] = Lambda_i_46;
    link->Lambda_i[18] = Lambda_i_55;
    link->Lambda_i[19] = Lambda_i_56;
    link->Lambda_i[20] = Lambda_i_66;
    link->p_i[0] = p_i_1;
    link->p_i[1] = p_i_2;
    link->p_i[2] = p_i_3;
    link->p_i[3] = p_i_4;
    link->p_i[4] = p_i_5;
    link->p_i[5] = p_i_6;
    base->Lambda[0] = Lambda_i_11;
    base->Lambda[1] = Lambda_2;
    base->Lambda[2] = Lambda_3;
    base->Lambda[3] = Lambda_i_14;
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
    base->Lambda[15] = Lambda_i_44;
    base->Lambda[16] = Lambda_17;
    base->Lambda[17] = Lambda_18;
    base->Lambda[18] = Lambda_19;
    base->Lambda[19] = Lambda_20;
    base->Lambda[20] = Lambda_21;
    base->p[0] = p_i_1;
    base->p[1] = p_2;
    base->p[2] = p_3;
    base->p[3] = p_i_4;
    base->p[4] = p_5;
    base->p[5] = p_6;
    return SIX_LINK_OK;
}

/* accelerate, links like shoulder: 117 operations */
static six_link_status accelerate_shoulder(const six_link_link_constants *c, const six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, six_link_real qddot[1], six_link_real wrench[6], six_link_real alpha[6])
{

    /* joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real t1 = base->alpha[3] + (base->alpha[1] * c->mount_xyz_z - base->alpha[2] * c->mount_xyz_y);
    const six_link_real t2 = base->alpha[4] + (base->alpha[2] * c->mount_xyz_x - base->alpha[0] * c->mount_xyz_z);
    const six_link_real carried_6 = base->alpha[5]
        + (base->alpha[0] * c->mount_xyz_y - base->alpha[1] * c->mount_xyz_x);
    const six_link_real carried_1 = link->R_rel[0] * base->alpha[0] + link->R_rel[1] * base->alpha[1];
    const six_link_real carried_2 = link->R_rel[0] * base->alpha[1] - link->R_rel[1] * base->alpha[0];
    const six_link_real carried_4 = link->R_rel[0] * t1 + link->R_rel[1] * t2;
    const six_link_real carried_5 = link->R_rel[0] * t2 - link->R_rel[1] * t1;
    const six_link_real t3 = link->joint_W[0] * carried_1 + link->joint_W[1] * carried_2
        + link->joint_W[2] * base->alpha[2] + link->joint_W[3] * carried_4;
    const six_link_real qddot_1 = link->joint_w[0]
        - (t3 + link->joint_W[4] * carried_5 + link->joint_W[5] * carried_6);
    const six_link_real t4 = link->Lambda_i[0] * carried_1 + link->Lambda_i[1] * carried_2
        + link->Lambda_i[2] * base->alpha[2];
    const six_link_real t5 = t4 + link->Lambda_i[3] * carried_4 + link->Lambda_i[4] * carried_5
        + link->Lambda_i[5] * carried_6;
    const six_link_real t6 = link->Lambda_i[1] * carried_1 + link->Lambda_i[6] * carried_2
        + link->Lambda_i[7] * base->alpha[2];
    const six_link_real t7 = t6 + link->Lambda_i[8] * carried_4 + link->Lambda_i[9] * carried_5
        + link->Lambda_i[10] * carried_6;
    const six_link_real t8 = link->Lambda_i[2] * carried_1 + link->Lambda_i[7] * carried_2
        + link->Lambda_i[11] * base->alpha[2];
    const six_link_real t9 = t8 + link->Lambda_i[12] * carried_4 + link->Lambda_i[13] * carried_5
        + link->Lambda_i[14] * carried_6;
    const six_link_real t10 = link->Lambda_i[3] * carried_1 + link->Lambda_i[8] * carried_2
        + link->Lambda_i[12] * base->alpha[2];
    const six_link_real t11 = t10 + link->Lambda_i[15] * carried_4 + link->Lambda_i[16] * carried_5
        + link->Lambda_i[17] * carried_6;
    const six_link_real t12 = link->Lambda_i[4] * carried_1 + link->Lambda_i[9] * carried_2
        + link->Lambda_i[13] * base->alpha[2];
    const six_link_real t13 = t12 + link->Lambda_i[16] * carried_4 + link->Lambda_i[18] * carried_5
        + link->Lambda_i[19] * carried_6;
    const six_link_real t14 = link->Lambda_i[5] * carried_1 + link->Lambda_i[10] * carried_2
        + link->Lambda_i[14] * base->alpha[2];
    const six_link_real t15 = t14 + link->Lambda_i[17] * carried_4 + link->Lambda_i[19] * carried_5
        + link->Lambda_i[20] * carried_6;
    const six_link_real wrench_1 = t5 + link->p_i[0];
    const six_link_real wrench_2 = t7 + link->p_i[1];
    const six_link_real wrench_3 = t9 + link->p_i[2];
    const six_link_real wrench_4 = t11 + link->p_i[3];
    const six_link_real wrench_5 = t13 + link->p_i[4];
    const six_link_real wrench_6 = t15 + link->p_i[5];

    /* link: acceleration of F_i, modal accelerations (83) */
    const six_link_real alpha_3 = base->alpha[2] + qddot_1;
    const six_link_real alpha_1 = carried_1 + link->beta[0];
    const six_link_real alpha_2 = carried_2 - link->beta[1];
    const six_link_real alpha_4 = carried_4 + link->beta[2];
    const six_link_real alpha_5 = carried_5 - link->beta[3];

    /* tip: acceleration of the tip section (accconst1b) */
    const six_link_real alpha_T_5 = alpha_5 + alpha_3 * c->length;
    const six_link_real alpha_T_6 = carried_6 - alpha_2 * c->length;

    /* outputs */
    qddot[0] = qddot_1;
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
    alpha[5] = carried_6;
    tip->alpha[0] = alpha_1;
    tip->alpha[1] = alpha_2;
    tip->alpha[2] = alpha_3;
    tip->alpha[3] = alpha_4;
    tip->alpha[4] = alpha_T_5;
    tip->alpha[5] = alpha_T_6;
    return SIX_LINK_OK;
}

/* accelerate, links like upper_arm: 231 operations */
static six_link_status accelerate_upper_arm(const six_link_link_constants *c, const six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, six_link_real qddot[1], six_link_real wrench[6], six_link_real alpha[6],
    six_link_real etaddot[3])
{

    /* joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real t1 = base->alpha[3] + (base->alpha[1] * c->mount_xyz_z - base->alpha[2] * c->mount_xyz_y);
    const six_link_real carried_5 = base->alpha[4]
        + (base->alpha[2] * c->mount_xyz_x - base->alpha[0] * c->mount_xyz_z);
    const six_link_real t2 = base->alpha[5] + (base->alpha[0] * c->mount_xyz_y - base->alpha[1] * c->mount_xyz_x);
    const six_link_real carried_1 = link->R_rel[0] * base->alpha[0] - link->R_rel[1] * base->alpha[2];
    const six_link_real carried_3 = link->R_rel[1] * base->alpha[0] + link->R_rel[0] * base->alpha[2];
    const six_link_real carried_4 = link->R_rel[0] * t1 - link->R_rel[1] * t2;
    const six_link_real carried_6 = link->R_rel[1] * t1 + link->R_rel[0] * t2;
    const six_link_real t3 = link->joint_W[0] * carried_1 + link->joint_W[1] * base->alpha[1]
        + link->joint_W[2] * carried_3 + link->joint_W[3] * carried_4;
    const six_link_real qddot_1 = link->joint_w[0]
        - (t3 + link->joint_W[4] * carried_5 + link->joint_W[5] * carried_6);
    const six_link_real t4 = link->Lambda_i[0] * carried_1 + link->Lambda_i[1] * base->alpha[1]
        + link->Lambda_i[2] * carried_3;
    const six_link_real t5 = t4 + link->Lambda_i[3] * carried_4 + link->Lambda_i[4] * carried_5
        + link->Lambda_i[5] * carried_6;
    const six_link_real t6 = link->Lambda_i[1] * carried_1 + link->Lambda_i[6] * base->alpha[1]
        + link->Lambda_i[7] * carried_3;
    const six_link_real t7 = t6 + link->Lambda_i[8] * carried_4 + link->Lambda_i[9] * carried_5
        + link->Lambda_i[10] * carried_6;
    const six_link_real t8 = link->Lambda_i[2] * carried_1 + link->Lambda_i[7] * base->alpha[1]
        + link->Lambda_i[11] * carried_3;
    const six_link_real t9 = t8 + link->Lambda_i[12] * carried_4 + link->Lambda_i[13] * carried_5
        + link->Lambda_i[14] * carried_6;
    const six_link_real t10 = link->Lambda_i[3] * carried_1 + link->Lambda_i[8] * base->alpha[1]
        + link->Lambda_i[12] * carried_3;
    const six_link_real t11 = t10 + link->Lambda_i[15] * carried_4 + link->Lambda_i[16] * carried_5
        + link->Lambda_i[17] * carried_6;
    const six_link_real t12 = link->Lambda_i[4] * carried_1 + link->Lambda_i[9] * base->alpha[1]
        + link->Lambda_i[13] * carried_3;
    const six_link_real t13 = t12 + link->Lambda_i[16] * carried_4 + link->Lambda_i[18] * carried_5
        + link->Lambda_i[19] * carried_6;
    const six_link_real t14 = link->Lambda_i[5] * carried_1 + link->Lambda_i[10] * base->alpha[1]
        + link->Lambda_i[14] * carried_3;
    const six_link_real t15 = t14 + link->Lambda_i[17] * carried_4 + link->Lambda_i[19] * carried_5
        + link->Lambda_i[20] * carried_6;
    const six_link_real wrench_1 = t5 + link->p_i[0];
    const six_link_real wrench_2 = t7 + link->p_i[1];
    const six_link_real wrench_3 = t9 + link->p_i[2];
    const six_link_real wrench_4 = t11 + link->p_i[3];
    const six_link_real wrench_5 = t13 + link->p_i[4];
    const six_link_real wrench_6 = t15 + link->p_i[5];

    /* link: acceleration of F_i, modal accelerations (83) */
    const six_link_real alpha_2 = base->alpha[1] + qddot_1;
    const six_link_real alpha_1 = carried_1 - link->beta[0];
    const six_link_real alpha_3 = carried_3 + link->beta[1];
    const six_link_real alpha_4 = carried_4 - link->beta[2];
    const six_link_real alpha_6 = carried_6 + link->beta[3];
    const six_link_real t16 = link->modes_W[0] * alpha_1 + link->modes_W[1] * alpha_2
        + link->modes_W[2] * alpha_3 + link->modes_W[3] * alpha_4;
    const six_link_real t17 = link->modes_W[6] * alpha_1 + link->modes_W[7] * alpha_2
        + link->modes_W[8] * alpha_3 + link->modes_W[9] * alpha_4;
    const six_link_real t18 = link->modes_W[12] * alpha_1 + link->modes_W[13] * alpha_2
        + link->modes_W[14] * alpha_3 + link->modes_W[15] * alpha_4;
    const six_link_real minus_etaddot_3 = link->modes_w[2]
        + (t18 + link->modes_W[16] * carried_5 + link->modes_W[17] * alpha_6);
    const six_link_real minus_etaddot_2 = link->modes_w[1]
        + (t17 + link->modes_W[10] * carried_5 + link->modes_W[11] * alpha_6)
        - link->modes_L[2] * minus_etaddot_3;
    const six_link_real t19 = link->modes_w[0]
        + (t16 + link->modes_W[4] * carried_5 + link->modes_W[5] * alpha_6) - link->modes_L[0] * minus_etaddot_2;
    const six_link_real minus_etaddot_1 = t19 - link->modes_L[1] * minus_etaddot_3;
    const six_link_real t20 = -minus_etaddot_1;
    const six_link_real t21 = -minus_etaddot_2;
    const six_link_real t22 = -minus_etaddot_3;

    /* tip: acceleration of the tip section (accconst1b) */
    const six_link_real t23 = minus_etaddot_3 * REAL(1.4142135623730951);
    const six_link_real t24 = c->Psi_c_y2 * minus_etaddot_2;
    const six_link_real t25 = c->Psi_c_z1 * minus_etaddot_1;
    const six_link_real t26 = alpha_4 + (alpha_2 * link->r_T[1] - alpha_3 * link->r_T[0]);
    const six_link_real t27 = alpha_1 - (link->G[0] * t23 + link->G[1] * t24 + link->G[2] * t25);
    const six_link_real t28 = alpha_2 - (link->G[3] * t23 + link->G[4] * t24 + link->G[5] * t25);
    const six_link_real t29 = alpha_3 - (link->G[6] * t23 + link->G[7] * t24 + link->G[8] * t25);
    const six_link_real t30 = carried_5 + (alpha_3 * c->length - alpha_1 * link->r_T[1]) - minus_etaddot_1 * 2;
    const six_link_real t31 = alpha_6 + (alpha_1 * link->r_T[0] - alpha_2 * c->length) - minus_etaddot_2 * 2;
    const six_link_real alpha_T_1 = link->R_T[0] * t27 + link->R_T[3] * t28 + link->R_T[6] * t29 + link->b_T[0];
    const six_link_real alpha_T_2 = link->R_T[1] * t27 + link->R_T[4] * t28 + link->R_T[7] * t29 + link->b_T[1];
    const six_link_real alpha_T_3 = link->R_T[2] * t27 + link->R_T[5] * t28 + link->R_T[8] * t29 + link->b_T[2];
    const six_link_real alpha_T_4 = link->R_T[0] * t26 + link->R_T[3] * t30 + link->R_T[6] * t31 + link->b_T[3];
    const six_link_real alpha_T_5 = link->R_T[1] * t26 + link->R_T[4] * t30 + link->R_T[7] * t31 + link->b_T[4];
    const six_link_real alpha_T_6 = link->R_T[2] * t26 + link->R_T[5] * t30 + link->R_T[8] * t31 + link->b_T[5];

    /* outputs */
    qddot[0] = qddot_1;
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
    alpha[4] = carried_5;
    alpha[5] = alpha_6;
    etaddot[0] = t20;
    etaddot[1] = t21;
    etaddot[2] = t22;
    tip->alpha[0] = alpha_T_1;
    tip->alpha[1] = alpha_T_2;
    tip->alpha[2] = alpha_T_3;
    tip->alpha[3] = alpha_T_4;
    tip->alpha[4] = alpha_T_5;
    tip->alpha[5] = alpha_T_6;
    return SIX_LINK_OK;
}

/* accelerate, links like forearm: 225 operations */
static six_link_status accelerate_forearm(const six_link_link_constants *c, const six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, six_link_real qddot[1], six_link_real wrench[6], six_link_real alpha[6],
    six_link_real etaddot[2])
{

    /* joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real t1 = base->alpha[3] + (base->alpha[1] * c->mount_xyz_z - base->alpha[2] * c->mount_xyz_y);
    const six_link_real t2 = base->alpha[4] + (base->alpha[2] * c->mount_xyz_x - base->alpha[0] * c->mount_xyz_z);
    const six_link_real t3 = base->alpha[5] + (base->alpha[0] * c->mount_xyz_y - base->alpha[1] * c->mount_xyz_x);
    const six_link_real carried_1 = link->R_rel[0] * base->alpha[0] + link->R_rel[2] * base->alpha[1]
        + link->R_rel[4] * base->alpha[2];
    const six_link_real carried_2 = c->R_m_xy * base->alpha[0] + c->R_m_yy * base->alpha[1]
        + c->R_m_zy * base->alpha[2];
    const six_link_real carried_3 = link->R_rel[1] * base->alpha[0] + link->R_rel[3] * base->alpha[1]
        + link->R_rel[5] * base->alpha[2];
    const six_link_real carried_4 = link->R_rel[0] * t1 + link->R_rel[2] * t2 + link->R_rel[4] * t3;
    const six_link_real carried_5 = c->R_m_xy * t1 + c->R_m_yy * t2 + c->R_m_zy * t3;
    const six_link_real carried_6 = link->R_rel[1] * t1 + link->R_rel[3] * t2 + link->R_rel[5] * t3;
    const six_link_real t4 = link->joint_W[0] * carried_1 + link->joint_W[1] * carried_2
        + link->joint_W[2] * carried_3 + link->joint_W[3] * carried_4;
    const six_link_real qddot_1 = link->joint_w[0]
        - (t4 + link->joint_W[4] * carried_5 + link->joint_W[5] * carried_6);
    const six_link_real t5 = link->Lambda_i[0] * carried_1 + link->Lambda_i[1] * carried_2
        + link->Lambda_i[2] * carried_3 + link->Lambda_i[3] * carried_4;
    const six_link_real t6 = link->Lambda_i[1] * carried_1 + link->Lambda_i[6] * carried_2
        + link->Lambda_i[7] * carried_3 + link->Lambda_i[8] * carried_4;
    const six_link_real t7 = link->Lambda_i[2] * carried_1 + link->Lambda_i[7] * carried_2
        + link->Lambda_i[11] * carried_3 + link->Lambda_i[12] * carried_4;
    const six_link_real t8 = link->Lambda_i[3] * carried_1 + link->Lambda_i[8] * carried_2
        + link->Lambda_i[12] * carried_3 + link->Lambda_i[15] * carried_4;
    const six_link_real t9 = link->Lambda_i[4] * carried_1 + link->Lambda_i[9] * carried_2
        + link->Lambda_i[13] * carried_3 + link->Lambda_i[16] * carried_4;
    const six_link_real t10 = link->Lambda_i[5] * carried_1 + link->Lambda_i[10] * carried_2
        + link->Lambda_i[14] * carried_3 + link->Lambda_i[17] * carried_4;
    const six_link_real wrench_1 = t5 + link->Lambda_i[4] * carried_5 + link->Lambda_i[5] * carried_6
        + link->p_i[0];
    const six_link_real wrench_2 = t6 + link->Lambda_i[9] * carried_5 + link->Lambda_i[10] * carried_6
        + link->p_i[1];
    const six_link_real wrench_3 = t7 + link->Lambda_i[13] * carried_5 + link->Lambda_i[14] * carried_6
        + link->p_i[2];
    const six_link_real wrench_4 = t8 + link->Lambda_i[16] * carried_5 + link->Lambda_i[17] * carried_6
        + link->p_i[3];
    const six_link_real wrench_5 = t9 + link->Lambda_i[18] * carried_5 + link->Lambda_i[19] * carried_6
        + link->p_i[4];
    const six_link_real wrench_6 = t10 + link->Lambda_i[19] * carried_5 + link->Lambda_i[20] * carried_6
        + link->p_i[5];

    /* link: acceleration of F_i, modal accelerations (83) */
    const six_link_real alpha_2 = carried_2 + qddot_1;
    const six_link_real alpha_1 = carried_1 - link->beta[0];
    const six_link_real alpha_3 = carried_3 + link->beta[1];
    const six_link_real alpha_4 = carried_4 - link->beta[2];
    const six_link_real alpha_6 = carried_6 + link->beta[3];
    const six_link_real t11 = link->modes_W[0] * alpha_1 + link->modes_W[1] * alpha_2
        + link->modes_W[2] * alpha_3 + link->modes_W[3] * alpha_4;
    const six_link_real t12 = link->modes_W[6] * alpha_1 + link->modes_W[7] * alpha_2
        + link->modes_W[8] * alpha_3 + link->modes_W[9] * alpha_4;
    const six_link_real minus_etaddot_2 = link->modes_w[1]
        + (t12 + link->modes_W[10] * carried_5 + link->modes_W[11] * alpha_6);
    const six_link_real minus_etaddot_1 = link->modes_w[0]
        + (t11 + link->modes_W[4] * carried_5 + link->modes_W[5] * alpha_6) - link->modes_L[0] * minus_etaddot_2;
    const six_link_real t13 = -minus_etaddot_1;
    const six_link_real t14 = -minus_etaddot_2;

    /* tip: acceleration of the tip section (accconst1b) */
    const six_link_real t15 = c->Psi_c_y2 * minus_etaddot_2;
    const six_link_real t16 = c->Psi_c_z1 * minus_etaddot_1;
    const six_link_real t17 = alpha_4 + (alpha_2 * link->r_T[1] - alpha_3 * link->r_T[0]);
    const six_link_real t18 = alpha_1 + (link->G[1] * t15 - link->G[2] * t16);
    const six_link_real t19 = alpha_2 - (link->G[3] * t15 + link->G[4] * t16);
    const six_link_real t20 = alpha_3 - (link->G[4] * t15 + link->G[5] * t16);
    const six_link_real t21 = carried_5 + (alpha_3 * c->length - alpha_1 * link->r_T[1])
        - minus_etaddot_1 * REAL(2.23606797749979);
    const six_link_real t22 = alpha_6 + (alpha_1 * link->r_T[0] - alpha_2 * c->length)
        - minus_etaddot_2 * REAL(2.23606797749979);
    const six_link_real alpha_T_1 = link->R_T[0] * t18 + link->R_T[1] * t19 - link->R_T[2] * t20 + link->b_T[0];
    const six_link_real alpha_T_2 = link->R_T[3] * t19 - link->R_T[1] * t18 + link->R_T[4] * t20 + link->b_T[1];
    const six_link_real alpha_T_3 = link->R_T[2] * t18 + link->R_T[4] * t19 + link->R_T[5] * t20 + link->b_T[2];
    const six_link_real alpha_T_4 = link->R_T[0] * t17 + link->R_T[1] * t21 - link->R_T[2] * t22 + link->b_T[3];
    const six_link_real alpha_T_5 = link->R_T[3] * t21 - link->R_T[1] * t17 + link->R_T[4] * t22 + link->b_T[4];
    const six_link_real alpha_T_6 = link->R_T[2] * t17 + link->R_T[4] * t21 + link->R_T[5] * t22 + link->b_T[5];

    /* outputs */
    qddot[0] = qddot_1;
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
    alpha[4] = carried_5;
    alpha[5] = alpha_6;
    etaddot[0] = t13;
    etaddot[1] = t14;
    tip->alpha[0] = alpha_T_1;
    tip->alpha[1] = alpha_T_2;
    tip->alpha[2] = alpha_T_3;
    tip->alpha[3] = alpha_T_4;
    tip->alpha[4] = alpha_T_5;
    tip->alpha[5] = alpha_T_6;
    return SIX_LINK_OK;
}

/* accelerate, links like wrist_roll: 105 operations */
static six_link_status accelerate_wrist_roll(const six_link_link_constants *c, const six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, six_link_real qddot[1], six_link_real wrench[6], six_link_real alpha[6])
{

    /* joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real carried_2 = link->R_rel[0] * base->alpha[1] + link->R_rel[1] * base->alpha[2];
    const six_link_real carried_3 = link->R_rel[0] * base->alpha[2] - link->R_rel[1] * base->alpha[1];
    const six_link_real carried_5 = link->R_rel[0] * base->alpha[4] + link->R_rel[1] * base->alpha[5];
    const six_link_real carried_6 = link->R_rel[0] * base->alpha[5] - link->R_rel[1] * base->alpha[4];
    const six_link_real t1 = link->joint_W[0] * base->alpha[0] + link->joint_W[1] * carried_2
        + link->joint_W[2] * carried_3 + link->joint_W[3] * base->alpha[3];
    const six_link_real qddot_1 = link->joint_w[0]
        - (t1 + link->joint_W[4] * carried_5 + link->joint_W[5] * carried_6);
    const six_link_real t2 = link->Lambda_i[0] * base->alpha[0] + link->Lambda_i[1] * carried_2
        + link->Lambda_i[2] * carried_3;
    const six_link_real t3 = t2 + link->Lambda_i[3] * base->alpha[3] + link->Lambda_i[4] * carried_5
        + link->Lambda_i[5] * carried_6;
    const six_link_real t4 = link->Lambda_i[1] * base->alpha[0] + link->Lambda_i[6] * carried_2
        + link->Lambda_i[7] * carried_3;
    const six_link_real t5 = t4 + link->Lambda_i[8] * base->alpha[3] + link->Lambda_i[9] * carried_5
        + link->Lambda_i[10] * carried_6;
    const six_link_real t6 = link->Lambda_i[2] * base->alpha[0] + link->Lambda_i[7] * carried_2
        + link->Lambda_i[11] * carried_3;
    const six_link_real t7 = t6 + link->Lambda_i[12] * base->alpha[3] + link->Lambda_i[13] * carried_5
        + link->Lambda_i[14] * carried_6;
    const six_link_real t8 = link->Lambda_i[3] * base->alpha[0] + link->Lambda_i[8] * carried_2
        + link->Lambda_i[12] * carried_3;
    const six_link_real t9 = t8 + link->Lambda_i[15] * base->alpha[3] + link->Lambda_i[16] * carried_5
        + link->Lambda_i[17] * carried_6;
    const six_link_real t10 = link->Lambda_i[4] * base->alpha[0] + link->Lambda_i[9] * carried_2
        + link->Lambda_i[13] * carried_3;
    const six_link_real t11 = t10 + link->Lambda_i[16] * base->alpha[3] + link->Lambda_i[18] * carried_5
        + link->Lambda_i[19] * carried_6;
    const six_link_real t12 = link->Lambda_i[5] * base->alpha[0] + link->Lambda_i[10] * carried_2
        + link->Lambda_i[14] * carried_3;
    const six_link_real t13 = t12 + link->Lambda_i[17] * base->alpha[3] + link->Lambda_i[19] * carried_5
        + link->Lambda_i[20] * carried_6;
    const six_link_real wrench_1 = t3 + link->p_i[0];
    const six_link_real wrench_2 = t5 + link->p_i[1];
    const six_link_real wrench_3 = t7 + link->p_i[2];
    const six_link_real wrench_4 = t9 + link->p_i[3];
    const six_link_real wrench_5 = t11 + link->p_i[4];
    const six_link_real wrench_6 = t13 + link->p_i[5];

    /* link: acceleration of F_i, modal accelerations (83) */
    const six_link_real alpha_1 = base->alpha[0] + qddot_1;
    const six_link_real alpha_2 = carried_2 + link->beta[0];
    const six_link_real alpha_3 = carried_3 - link->beta[1];
    const six_link_real alpha_5 = carried_5 + link->beta[2];
    const six_link_real alpha_6 = carried_6 - link->beta[3];

    /* tip: acceleration of the tip section (accconst1b) */
    const six_link_real alpha_T_5 = alpha_5 + alpha_3 * c->length;
    const six_link_real alpha_T_6 = alpha_6 - alpha_2 * c->length;

    /* outputs */
    qddot[0] = qddot_1;
    wrench[0] = wrench_1;
    wrench[1] = wrench_2;
    wrench[2] = wrench_3;
    wrench[3] = wrench_4;
    wrench[4] = wrench_5;
    wrench[5] = wrench_6;
    alpha[0] = alpha_1;
    alpha[1] = alpha_2;
    alpha[2] = alpha_3;
    alpha[3] = base->alpha[3];
    alpha[4] = alpha_5;
    alpha[5] = alpha_6;
    tip->alpha[0] = alpha_1;
    tip->alpha[1] = alpha_2;
    tip->alpha[2] = alpha_3;
    tip->alpha[3] = base->alpha[3];
    tip->alpha[4] = alpha_T_5;
    tip->alpha[5] = alpha_T_6;
    return SIX_LINK_OK;
}

/* accelerate, links like wrist_pitch: 105 operations */
static six_link_status accelerate_wrist_pitch(const six_link_link_constants *c, const six_link_link_store *link, const six_link_node *base,
    six_link_node *tip, six_link_real qddot[1], six_link_real wrench[6], six_link_real alpha[6])
{

    /* joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real carried_1 = link->R_rel[0] * base->alpha[0] - link->R_rel[1] * base->alpha[2];
    const six_link_real carried_3 = link->R_rel[1] * base->alpha[0] + link->R_rel[0] * base->alpha[2];
    const six_link_real carried_4 = link->R_rel[0] * base->alpha[3] - link->R_rel[1] * base->alpha[5];
    const six_link_real carried_6 = link->R_rel[1] * base->alpha[3] + link->R_rel[0] * base->alpha[5];
    const six_link_real t1 = link->joint_W[0] * carried_1 + link->joint_W[1] * base->alpha[1]
        + link->joint_W[2] * carried_3 + link->joint_W[3] * carried_4;
    const six_link_real qddot_1 = link->joint_w[0]
        - (t1 + link->joint_W[4] * base->alpha[4] + link->joint_W[5] * carried_6);
    const six_link_real t2 = link->Lambda_i[0] * carried_1 + link->Lambda_i[1] * base->alpha[1]
        + link->Lambda_i[2] * carried_3;
    const six_link_real t3 = t2 + link->Lambda_i[3] * carried_4 + link->Lambda_i[4] * base->alpha[4]
        + link->Lambda_i[5] * carried_6;
    const six_link_real t4 = link->Lambda_i[1] * carried_1 + link->Lambda_i[6] * base->alpha[1]
        + link->Lambda_i[7] * carried_3;
    const six_link_real t5 = t4 + link->Lambda_i[8] * carried_4 + link->Lambda_i[9] * base->alpha[4]
        + link->Lambda_i[10] * carried_6;
    const six_link_real t6 = link->Lambda_i[2] * carried_1 + link->Lambda_i[7] * base->alpha[1]
        + link->Lambda_i[11] * carried_3;
    const six_link_real t7 = t6 + link->Lambda_i[12] * carried_4 + link->Lambda_i[13] * base->alpha[4]
        + link->Lambda_i[14] * carried_6;
    const six_link_real t8 = link->Lambda_i[3] * carried_1 + link->Lambda_i[8] * base->alpha[1]
        + link->Lambda_i[12] * carried_3;
    const six_link_real t9 = t8 + link->Lambda_i[15] * carried_4 + link->Lambda_i[16] * base->alpha[4]
        + link->Lambda_i[17] * carried_6;
    const six_link_real t10 = link->Lambda_i[4] * carried_1 + link->Lambda_i[9] * base->alpha[1]
        + link->Lambda_i[13] * carried_3;
    const six_link_real t11 = t10 + link->Lambda_i[16] * carried_4 + link->Lambda_i[18] * base->alpha[4]
        + link->Lambda_i[19] * carried_6;
    const six_link_real t12 = link->Lambda_i[5] * carried_1 + link->Lambda_i[10] * base->alpha[1]
        + link->Lambda_i[14] * carried_3;
    const six_link_real t13 = t12 + link->Lambda_i[17] * carried_4 + link->Lambda_i[19] * base->alpha[4]
        + link->Lambda_i[20] * carried_6;
    const six_link_real wrench_1 = t3 + link->p_i[0];
    const six_link_real wrench_2 = t5 + link->p_i[1];
    const six_link_real wrench_3 = t7 + link->p_i[2];
    const six_link_real wrench_4 = t9 + link->p_i[3];
    const six_link_real wrench_5 = t11 + link->p_i[4];
    const six_link_real wrench_6 = t13 + link->p_i[5];

    /* link: acceleration of F_i, modal accelerations (83) */
    const six_link_real alpha_2 = base->alpha[1] + qddot_1;
    const six_link_real alpha_1 = carried_1 - link->beta[0];
    const six_link_real alpha_3 = carried_3 + link->beta[1];
    const six_link_real alpha_4 = carried_4 - link->beta[2];
    const six_link_real alpha_6 = carried_6 + link->beta[3];

    /* tip: acceleration of the tip section (accconst1b) */
    const six_link_real alpha_T_5 = base->alpha[4] + alpha_3 * c->length;
    const six_link_real alpha_T_6 = alpha_6 - alpha_2 * c->length;

    /* outputs */
    qddot[0] = qddot_1;
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
    alpha[4] = base->alpha[4];
    alpha[5] = alpha_6;
    tip->alpha[0] = alpha_1;
    tip->alpha[1] = alpha_2;
    tip->alpha[2] = alpha_3;
    tip->alpha[3] = alpha_4;
    tip->alpha[4] = alpha_T_5;
    tip->alpha[5] = alpha_T_6;
    return SIX_LINK_OK;
}

/* twist rates, links like shoulder: 55 operations */
static six_link_status twist_rates_shoulder(const six_link_real quaternion[4], const six_link_real gravity[3], const six_link_real alpha[6],
    six_link_real Vdot[6])
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
    const six_link_real Vdot_4 = alpha[3]
        + ((1 + t4 * (t1 - t5)) * gravity[0] + t4 * (t9 + t6) * gravity[1] + t4 * (t7 - t10) * gravity[2]);
    const six_link_real Vdot_5 = alpha[4]
        + (t4 * (t6 - t9) * gravity[0] + (1 + t4 * (t2 - t5)) * gravity[1] + t4 * (t11 + t8) * gravity[2]);
    const six_link_real Vdot_6 = alpha[5]
        + (t4 * (t10 + t7) * gravity[0] + t4 * (t8 - t11) * gravity[1] + (1 + t4 * (t3 - t5)) * gravity[2]);

    /* outputs */
    Vdot[0] = alpha[0];
    Vdot[1] = alpha[1];
    Vdot[2] = alpha[2];
    Vdot[3] = Vdot_4;
    Vdot[4] = Vdot_5;
    Vdot[5] = Vdot_6;
    return SIX_LINK_OK;
}

/* project, links like shoulder: 168 operations */
static six_link_status project_shoulder(const six_link_link_constants *c, const six_link_node *base, six_link_node *tip,
    const six_link_real q[1], const six_link_real twist[6], const six_link_real quaternion[4],
    six_link_real new_q[1], six_link_real new_twist[6], six_link_real new_quaternion[4],
    six_link_real new_position[3])
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
    const six_link_real R_m_12 = t4 * (t6 - t9);
    const six_link_real R_m_13 = t4 * (t10 + t7);
    const six_link_real R_m_21 = t4 * (t9 + t6);
    const six_link_real R_m_23 = t4 * (t8 - t11);
    const six_link_real R_m_31 = t4 * (t7 - t10);
    const six_link_real R_m_32 = t4 * (t11 + t8);
    const six_link_real R_m_11 = 1 + t4 * (t1 - t5);
    const six_link_real R_m_22 = 1 + t4 * (t2 - t5);
    const six_link_real R_m_33 = 1 + t4 * (t3 - t5);
    const six_link_real t12 = base->R_m[0] * R_m_11 + base->R_m[3] * R_m_21 + base->R_m[6] * R_m_31;
    const six_link_real t13 = base->R_m[0] * R_m_12 + base->R_m[3] * R_m_22 + base->R_m[6] * R_m_32;
    const six_link_real t14 = base->R_m[1] * R_m_11 + base->R_m[4] * R_m_21 + base->R_m[7] * R_m_31;
    const six_link_real t15 = base->R_m[1] * R_m_12 + base->R_m[4] * R_m_22 + base->R_m[7] * R_m_32;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real minus_R_rel_xy = six_link_sin(q[0]);

    const six_link_real t16 = q[0]
        + (R_rel_xx * t14 - minus_R_rel_xy * t12 - (R_rel_xx * t13 + minus_R_rel_xy * t15)) * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx_2 = six_link_cos(t16);
    const six_link_real minus_R_rel_xy_2 = six_link_sin(t16);

    const six_link_real t17 = (R_rel_xx_2 * t14 - minus_R_rel_xy_2 * t12
        - (R_rel_xx_2 * t13 + minus_R_rel_xy_2 * t15)) * REAL(0.5);
    const six_link_real new_q_1 = t16 + t17;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx_3 = six_link_cos(new_q_1);
    const six_link_real minus_R_rel_xy_3 = six_link_sin(new_q_1);

    const six_link_real t18 = twist[2] - base->omega_m[2];

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx_3 * base->omega[0] + minus_R_rel_xy_3 * base->omega[1];
    const six_link_real omega_R_y = R_rel_xx_3 * base->omega[1] - minus_R_rel_xy_3 * base->omega[0];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_z = base->omega[2] + t18;

    /* v_R: velocity of the joint point */
    const six_link_real t19 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t20 = base->v[1] + c->mount_xyz_x * base->omega[2] - c->mount_xyz_z * base->omega[0];
    const six_link_real v_R_x = R_rel_xx_3 * t19 + minus_R_rel_xy_3 * t20;
    const six_link_real v_R_y = R_rel_xx_3 * t20 - minus_R_rel_xy_3 * t19;
    const six_link_real v_R_z = base->v[2] + c->mount_xyz_y * base->omega[0] - c->mount_xyz_x * base->omega[1];

    const six_link_real R_xx = base->R[0] * R_rel_xx_3 + base->R[1] * minus_R_rel_xy_3;
    const six_link_real R_xy = base->R[1] * R_rel_xx_3 - base->R[0] * minus_R_rel_xy_3;
    const six_link_real R_yx = base->R[3] * R_rel_xx_3 + base->R[4] * minus_R_rel_xy_3;
    const six_link_real R_yy = base->R[4] * R_rel_xx_3 - base->R[3] * minus_R_rel_xy_3;
    const six_link_real R_zx = base->R[6] * R_rel_xx_3 + base->R[7] * minus_R_rel_xy_3;
    const six_link_real R_zy = base->R[7] * R_rel_xx_3 - base->R[6] * minus_R_rel_xy_3;
    const six_link_real new_position_1 = base->r[0]
        + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y + base->R[2] * c->mount_xyz_z);
    const six_link_real new_position_2 = base->r[1]
        + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y + base->R[5] * c->mount_xyz_z);
    const six_link_real new_position_3 = base->r[2]
        + (base->R[6] * c->mount_xyz_x + base->R[7] * c->mount_xyz_y + base->R[8] * c->mount_xyz_z);
    const six_link_real t21 = new_q_1 * REAL(0.5);
    const six_link_real t22 = six_link_sin(t21);
    const six_link_real t23 = six_link_cos(t21);
    const six_link_real new_quaternion_1 = base->Q[0] * t23 - base->Q[3] * t22;
    const six_link_real new_quaternion_4 = base->Q[0] * t22 + t23 * base->Q[3];
    const six_link_real new_quaternion_2 = t23 * base->Q[1] + base->Q[2] * t22;
    const six_link_real new_quaternion_3 = t23 * base->Q[2] - base->Q[1] * t22;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = v_R_y + c->length * omega_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_R_y;

    const six_link_real r_x = new_position_1 + R_xx * c->length;
    const six_link_real r_y = new_position_2 + R_yx * c->length;
    const six_link_real r_z = new_position_3 + R_zx * c->length;

    /* outputs */
    new_q[0] = new_q_1;
    tip->omega_m[0] = twist[0];
    tip->omega_m[1] = twist[1];
    tip->omega_m[2] = twist[2];
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
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = new_position_1;
    new_position[1] = new_position_2;
    new_position[2] = new_position_3;
    tip->omega[0] = omega_R_x;
    tip->omega[1] = omega_R_y;
    tip->omega[2] = omega_z;
    tip->v[0] = v_R_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    tip->R[0] = R_xx;
    tip->R[1] = R_xy;
    tip->R[2] = base->R[2];
    tip->R[3] = R_yx;
    tip->R[4] = R_yy;
    tip->R[5] = base->R[5];
    tip->R[6] = R_zx;
    tip->R[7] = R_zy;
    tip->R[8] = base->R[8];
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = new_quaternion_1;
    tip->Q[1] = new_quaternion_2;
    tip->Q[2] = new_quaternion_3;
    tip->Q[3] = new_quaternion_4;
    return SIX_LINK_OK;
}

/* project, links like upper_arm: 450 operations */
static six_link_status project_upper_arm(const six_link_link_constants *c, const six_link_node *base, six_link_node *tip,
    const six_link_real q[1], const six_link_real twist[6], const six_link_real eta[3],
    const six_link_real etadot[3], const six_link_real quaternion[4], six_link_real new_q[1],
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
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real R_rel_xz = six_link_sin(q[0]);

    const six_link_real t25 = q[0]
        + (R_rel_xx * t22 - R_rel_xz * t24 - (R_rel_xz * t21 + R_rel_xx * t23)) * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx_2 = six_link_cos(t25);
    const six_link_real R_rel_xz_2 = six_link_sin(t25);

    const six_link_real new_q_1 = t25
        + (R_rel_xx_2 * t22 - R_rel_xz_2 * t24 - (R_rel_xz_2 * t21 + R_rel_xx_2 * t23)) * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx_3 = six_link_cos(new_q_1);
    const six_link_real R_rel_xz_3 = six_link_sin(new_q_1);

    const six_link_real t26 = twist[1] - base->omega_m[1];

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[2] * REAL(1.4142135623730951);
    const six_link_real theta_y = c->Psi_c_y2 * eta[1];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0];

    /* x: squared angle of the tip section */
    const six_link_real t27 = theta_x * theta_x;
    const six_link_real t28 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t27 + t28;
    const six_link_real t29 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t29;

    /* c1: Stumpff function of order 1 */
    const six_link_real c3 = REAL(0.16666666666666666) - x * six_link_c5(x);
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t28 + t29;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t27 + t29;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t30 = c2 * theta_hat2_12;
    const six_link_real t31 = c1 * theta_z;
    const six_link_real R_T_xy = t30 - t31;
    const six_link_real t32 = c1 * theta_y;
    const six_link_real t33 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t32 + t33;
    const six_link_real R_T_yx = t31 + t30;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t34 = c2 * theta_hat2_23;
    const six_link_real t35 = c1 * theta_x;
    const six_link_real R_T_yz = t34 - t35;
    const six_link_real R_T_zx = t33 - t32;
    const six_link_real R_T_zy = t35 + t34;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_x = etadot[2] * REAL(1.4142135623730951);
    const six_link_real thetadot_y = c->Psi_c_y2 * etadot[1];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t36 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real t37 = theta_x * thetadot_y - theta_y * thetadot_x;
    const six_link_real t38 = theta_z * thetadot_x - theta_x * thetadot_z;
    const six_link_real omega_s_x = thetadot_x + c2 * t36 + c3 * (theta_y * t37 - theta_z * t38);
    const six_link_real omega_s_y = thetadot_y + c2 * t38 + c3 * (theta_z * t36 - theta_x * t37);
    const six_link_real omega_s_z = thetadot_z + c2 * t37 + c3 * (theta_x * t38 - theta_y * t36);

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t39 = omega_s_x + twist[0];
    const six_link_real t40 = omega_s_y + twist[1];
    const six_link_real t41 = omega_s_z + twist[2];
    const six_link_real omega_T_x = R_T_xx * t39 + R_T_yx * t40 + R_T_zx * t41;
    const six_link_real omega_T_y = R_T_xy * t39 + R_T_yy * t40 + R_T_zy * t41;
    const six_link_real omega_T_z = R_T_xz * t39 + R_T_yz * t40 + R_T_zz * t41;

    const six_link_real R_m_11 = t18 * R_T_xx + t12 * R_T_yx + t13 * R_T_zx;
    const six_link_real R_m_12 = t18 * R_T_xy + t12 * R_T_yy + t13 * R_T_zy;
    const six_link_real R_m_13 = t18 * R_T_xz + t12 * R_T_yz + t13 * R_T_zz;
    const six_link_real R_m_21 = t14 * R_T_xx + t19 * R_T_yx + t15 * R_T_zx;
    const six_link_real R_m_22 = t14 * R_T_xy + t19 * R_T_yy + t15 * R_T_zy;
    const six_link_real R_m_23 = t14 * R_T_xz + t19 * R_T_yz + t15 * R_T_zz;
    const six_link_real R_m_31 = t16 * R_T_xx + t17 * R_T_yx + t20 * R_T_zx;
    const six_link_real R_m_32 = t16 * R_T_xy + t17 * R_T_yy + t20 * R_T_zy;
    const six_link_real R_m_33 = t16 * R_T_xz + t17 * R_T_yz + t20 * R_T_zz;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx_3 * base->omega[0] - R_rel_xz_3 * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz_3 * base->omega[0] + R_rel_xx_3 * base->omega[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = base->omega[1] + t26;

    /* v_R: velocity of the joint point */
    const six_link_real t42 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t43 = base->v[2] + c->mount_xyz_y * base->omega[0] - c->mount_xyz_x * base->omega[1];
    const six_link_real v_R_x = R_rel_xx_3 * t42 - R_rel_xz_3 * t43;
    const six_link_real v_R_y = base->v[1] + c->mount_xyz_x * base->omega[2] - c->mount_xyz_z * base->omega[0];
    const six_link_real v_R_z = R_rel_xz_3 * t42 + R_rel_xx_3 * t43;

    const six_link_real t44 = base->R[0] * R_rel_xx_3 - base->R[2] * R_rel_xz_3;
    const six_link_real t45 = base->R[0] * R_rel_xz_3 + base->R[2] * R_rel_xx_3;
    const six_link_real t46 = base->R[3] * R_rel_xx_3 - base->R[5] * R_rel_xz_3;
    const six_link_real t47 = base->R[3] * R_rel_xz_3 + base->R[5] * R_rel_xx_3;
    const six_link_real t48 = base->R[6] * R_rel_xx_3 - base->R[8] * R_rel_xz_3;
    const six_link_real t49 = base->R[6] * R_rel_xz_3 + base->R[8] * R_rel_xx_3;
    const six_link_real new_position_1 = base->r[0]
        + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y + base->R[2] * c->mount_xyz_z);
    const six_link_real new_position_2 = base->r[1]
        + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y + base->R[5] * c->mount_xyz_z);
    const six_link_real new_position_3 = base->r[2]
        + (base->R[6] * c->mount_xyz_x + base->R[7] * c->mount_xyz_y + base->R[8] * c->mount_xyz_z);
    const six_link_real t50 = new_q_1 * REAL(0.5);
    const six_link_real t51 = six_link_sin(t50);
    const six_link_real t52 = six_link_cos(t50);
    const six_link_real new_quaternion_1 = base->Q[0] * t52 - base->Q[2] * t51;
    const six_link_real new_quaternion_3 = base->Q[0] * t51 + t52 * base->Q[2];
    const six_link_real new_quaternion_2 = t52 * base->Q[1] - base->Q[3] * t51;
    const six_link_real new_quaternion_4 = t52 * base->Q[3] + base->Q[1] * t51;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[0] * 2;
    const six_link_real r_T_z = eta[1] * 2;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[0] * 2;
    const six_link_real udot_T_z = etadot[1] * 2;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t53 = omega_s_x + omega_R_x;
    const six_link_real t54 = omega_s_y + omega_y;
    const six_link_real t55 = omega_s_z + omega_R_z;
    const six_link_real omega_T_x_2 = R_T_xx * t53 + R_T_yx * t54 + R_T_zx * t55;
    const six_link_real omega_T_y_2 = R_T_xy * t53 + R_T_yy * t54 + R_T_zy * t55;
    const six_link_real omega_T_z_2 = R_T_xz * t53 + R_T_yz * t54 + R_T_zz * t55;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t56 = v_R_x + omega_y * r_T_z - omega_R_z * r_T_y;
    const six_link_real t57 = udot_T_y + v_R_y + c->length * omega_R_z - omega_R_x * r_T_z;
    const six_link_real t58 = udot_T_z + v_R_z + omega_R_x * r_T_y - c->length * omega_y;
    const six_link_real v_T_x = R_T_xx * t56 + R_T_yx * t57 + R_T_zx * t58;
    const six_link_real v_T_y = R_T_xy * t56 + R_T_yy * t57 + R_T_zy * t58;
    const six_link_real v_T_z = R_T_xz * t56 + R_T_yz * t57 + R_T_zz * t58;

    const six_link_real R_xx = t44 * R_T_xx + base->R[1] * R_T_yx + t45 * R_T_zx;
    const six_link_real R_xy = t44 * R_T_xy + base->R[1] * R_T_yy + t45 * R_T_zy;
    const six_link_real R_xz = t44 * R_T_xz + base->R[1] * R_T_yz + t45 * R_T_zz;
    const six_link_real R_yx = t46 * R_T_xx + base->R[4] * R_T_yx + t47 * R_T_zx;
    const six_link_real R_yy = t46 * R_T_xy + base->R[4] * R_T_yy + t47 * R_T_zy;
    const six_link_real R_yz = t46 * R_T_xz + base->R[4] * R_T_yz + t47 * R_T_zz;
    const six_link_real R_zx = t48 * R_T_xx + base->R[7] * R_T_yx + t49 * R_T_zx;
    const six_link_real R_zy = t48 * R_T_xy + base->R[7] * R_T_yy + t49 * R_T_zy;
    const six_link_real R_zz = t48 * R_T_xz + base->R[7] * R_T_yz + t49 * R_T_zz;
    const six_link_real r_x = new_position_1 + (t44 * c->length + base->R[1] * r_T_y + t45 * r_T_z);
    const six_link_real r_y = new_position_2 + (t46 * c->length + base->R[4] * r_T_y + t47 * r_T_z);
    const six_link_real r_z = new_position_3 + (t48 * c->length + base->R[7] * r_T_y + t49 * r_T_z);
    const six_link_real t59 = x * REAL(0.25);
    const six_link_real t60 = 1 - t59 * (REAL(0.5) - t59 * six_link_c4(t59));
    const six_link_real t61 = (1 - t59 * (REAL(0.16666666666666666) - t59 * six_link_c5(t59))) * REAL(0.5);
    const six_link_real t62 = t61 * theta_x;
    const six_link_real t63 = t61 * theta_y;
    const six_link_real t64 = t61 * theta_z;
    const six_link_real Q_1 = new_quaternion_1 * t60
        - (new_quaternion_2 * t62 + new_quaternion_3 * t63 + new_quaternion_4 * t64);
    const six_link_real Q_2 = new_quaternion_1 * t62 + t60 * new_quaternion_2
        + (new_quaternion_3 * t64 - new_quaternion_4 * t63);
    const six_link_real Q_3 = new_quaternion_1 * t63 + t60 * new_quaternion_3
        + (new_quaternion_4 * t62 - new_quaternion_2 * t64);
    const six_link_real Q_4 = new_quaternion_1 * t64 + t60 * new_quaternion_4
        + (new_quaternion_2 * t63 - new_quaternion_3 * t62);

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
    new_twist[1] = omega_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = new_position_1;
    new_position[1] = new_position_2;
    new_position[2] = new_position_3;
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
    return SIX_LINK_OK;
}

/* project, links like forearm: 579 operations */
static six_link_status project_forearm(const six_link_link_constants *c, const six_link_node *base, six_link_node *tip,
    const six_link_real q[1], const six_link_real twist[6], const six_link_real eta[2],
    const six_link_real etadot[2], const six_link_real quaternion[4], six_link_real new_q[1],
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
    const six_link_real t27 = six_link_cos(q[0]);
    const six_link_real t28 = six_link_sin(q[0]);
    const six_link_real R_rel_xx = c->R_m_xx * t27 - c->R_m_xz * t28;
    const six_link_real R_rel_xz = c->R_m_xx * t28 + c->R_m_xz * t27;
    const six_link_real R_rel_yx = c->R_m_yx * t27 - c->R_m_yz * t28;
    const six_link_real R_rel_yz = c->R_m_yx * t28 + c->R_m_yz * t27;
    const six_link_real R_rel_zx = c->R_m_zx * t27 - c->R_m_zz * t28;
    const six_link_real R_rel_zz = c->R_m_zx * t28 + c->R_m_zz * t27;

    const six_link_real t29 = R_rel_xx * t22 + R_rel_yx * t24 + R_rel_zx * t26
        - (R_rel_xz * t21 + R_rel_yz * t23 + R_rel_zz * t25);
    const six_link_real t30 = q[0] + t29 * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real t31 = six_link_cos(t30);
    const six_link_real t32 = six_link_sin(t30);
    const six_link_real R_rel_xx_2 = c->R_m_xx * t31 - c->R_m_xz * t32;
    const six_link_real R_rel_xz_2 = c->R_m_xx * t32 + c->R_m_xz * t31;
    const six_link_real R_rel_yx_2 = c->R_m_yx * t31 - c->R_m_yz * t32;
    const six_link_real R_rel_yz_2 = c->R_m_yx * t32 + c->R_m_yz * t31;
    const six_link_real R_rel_zx_2 = c->R_m_zx * t31 - c->R_m_zz * t32;
    const six_link_real R_rel_zz_2 = c->R_m_zx * t32 + c->R_m_zz * t31;

    const six_link_real t33 = R_rel_xx_2 * t22 + R_rel_yx_2 * t24 + R_rel_zx_2 * t26
        - (R_rel_xz_2 * t21 + R_rel_yz_2 * t23 + R_rel_zz_2 * t25);
    const six_link_real new_q_1 = t30 + t33 * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real t34 = six_link_cos(new_q_1);
    const six_link_real t35 = six_link_sin(new_q_1);
    const six_link_real R_rel_xx_3 = c->R_m_xx * t34 - c->R_m_xz * t35;
    const six_link_real R_rel_xz_3 = c->R_m_xx * t35 + c->R_m_xz * t34;
    const six_link_real R_rel_yx_3 = c->R_m_yx * t34 - c->R_m_yz * t35;
    const six_link_real R_rel_yz_3 = c->R_m_yx * t35 + c->R_m_yz * t34;
    const six_link_real R_rel_zx_3 = c->R_m_zx * t34 - c->R_m_zz * t35;
    const six_link_real R_rel_zz_3 = c->R_m_zx * t35 + c->R_m_zz * t34;

    const six_link_real t36 = twist[1]
        - (c->R_m_xy * base->omega_m[0] + c->R_m_yy * base->omega_m[1] + c->R_m_zy * base->omega_m[2]);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y2 * eta[1];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const six_link_real c3 = REAL(0.16666666666666666) - x * six_link_c5(x);
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real minus_R_T_xy = c1 * theta_z;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_y = c->Psi_c_y2 * etadot[1];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t37 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real omega_s_x = c2 * t37;
    const six_link_real omega_s_y = thetadot_y + c3 * theta_z * t37;
    const six_link_real omega_s_z = thetadot_z - c3 * theta_y * t37;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t38 = omega_s_x + twist[0];
    const six_link_real t39 = omega_s_y + twist[1];
    const six_link_real t40 = omega_s_z + twist[2];
    const six_link_real omega_T_x = R_T_xx * t38 + minus_R_T_xy * t39 - R_T_xz * t40;
    const six_link_real omega_T_y = R_T_yy * t39 - minus_R_T_xy * t38 + R_T_yz * t40;
    const six_link_real omega_T_z = R_T_xz * t38 + R_T_yz * t39 + R_T_zz * t40;

    const six_link_real R_m_11 = t18 * R_T_xx + t12 * minus_R_T_xy - t13 * R_T_xz;
    const six_link_real R_m_12 = t12 * R_T_yy - t18 * minus_R_T_xy + t13 * R_T_yz;
    const six_link_real R_m_13 = t18 * R_T_xz + t12 * R_T_yz + t13 * R_T_zz;
    const six_link_real R_m_21 = t14 * R_T_xx + t19 * minus_R_T_xy - t15 * R_T_xz;
    const six_link_real R_m_22 = t19 * R_T_yy - t14 * minus_R_T_xy + t15 * R_T_yz;
    const six_link_real R_m_23 = t14 * R_T_xz + t19 * R_T_yz + t15 * R_T_zz;
    const six_link_real R_m_31 = t16 * R_T_xx + t17 * minus_R_T_xy - t20 * R_T_xz;
    const six_link_real R_m_32 = t17 * R_T_yy - t16 * minus_R_T_xy + t20 * R_T_yz;
    const six_link_real R_m_33 = t16 * R_T_xz + t17 * R_T_yz + t20 * R_T_zz;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx_3 * base->omega[0] + R_rel_yx_3 * base->omega[1]
        + R_rel_zx_3 * base->omega[2];
    const six_link_real omega_R_y = c->R_m_xy * base->omega[0] + c->R_m_yy * base->omega[1]
        + c->R_m_zy * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz_3 * base->omega[0] + R_rel_yz_3 * base->omega[1]
        + R_rel_zz_3 * base->omega[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = omega_R_y + t36;

    /* v_R: velocity of the joint point */
    const six_link_real t41 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t42 = base->v[1] + c->mount_xyz_x * base->omega[2] - c->mount_xyz_z * base->omega[0];
    const six_link_real t43 = base->v[2] + c->mount_xyz_y * base->omega[0] - c->mount_xyz_x * base->omega[1];
    const six_link_real v_R_x = R_rel_xx_3 * t41 + R_rel_yx_3 * t42 + R_rel_zx_3 * t43;
    const six_link_real v_R_y = c->R_m_xy * t41 + c->R_m_yy * t42 + c->R_m_zy * t43;
    const six_link_real v_R_z = R_rel_xz_3 * t41 + R_rel_yz_3 * t42 + R_rel_zz_3 * t43;

    const six_link_real t44 = base->R[0] * R_rel_xx_3 + base->R[1] * R_rel_yx_3 + base->R[2] * R_rel_zx_3;
    const six_link_real t45 = base->R[0] * c->R_m_xy + base->R[1] * c->R_m_yy + base->R[2] * c->R_m_zy;
    const six_link_real t46 = base->R[0] * R_rel_xz_3 + base->R[1] * R_rel_yz_3 + base->R[2] * R_rel_zz_3;
    const six_link_real t47 = base->R[3] * R_rel_xx_3 + base->R[4] * R_rel_yx_3 + base->R[5] * R_rel_zx_3;
    const six_link_real t48 = base->R[3] * c->R_m_xy + base->R[4] * c->R_m_yy + base->R[5] * c->R_m_zy;
    const six_link_real t49 = base->R[3] * R_rel_xz_3 + base->R[4] * R_rel_yz_3 + base->R[5] * R_rel_zz_3;
    const six_link_real t50 = base->R[6] * R_rel_xx_3 + base->R[7] * R_rel_yx_3 + base->R[8] * R_rel_zx_3;
    const six_link_real t51 = base->R[6] * c->R_m_xy + base->R[7] * c->R_m_yy + base->R[8] * c->R_m_zy;
    const six_link_real t52 = base->R[6] * R_rel_xz_3 + base->R[7] * R_rel_yz_3 + base->R[8] * R_rel_zz_3;
    const six_link_real new_position_1 = base->r[0]
        + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y + base->R[2] * c->mount_xyz_z);
    const six_link_real new_position_2 = base->r[1]
        + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y + base->R[5] * c->mount_xyz_z);
    const six_link_real new_position_3 = base->r[2]
        + (base->R[6] * c->mount_xyz_x + base->R[7] * c->mount_xyz_y + base->R[8] * c->mount_xyz_z);
    const six_link_real t53 = c->mount_rpy_z * REAL(0.5);
    const six_link_real t54 = six_link_sin(t53);
    const six_link_real t55 = six_link_cos(t53);
    const six_link_real t56 = c->mount_rpy_y * REAL(0.5);
    const six_link_real t57 = six_link_sin(t56);
    const six_link_real t58 = six_link_cos(t56);
    const six_link_real t59 = c->mount_rpy_x * REAL(0.5);
    const six_link_real t60 = six_link_sin(t59);
    const six_link_real t61 = six_link_cos(t59);
    const six_link_real t62 = new_q_1 * REAL(0.5);
    const six_link_real t63 = six_link_sin(t62);
    const six_link_real t64 = six_link_cos(t62);
    const six_link_real t65 = t55 * t58;
    const six_link_real t66 = t55 * t57;
    const six_link_real t67 = t58 * t54;
    const six_link_real t68 = t54 * t57;
    const six_link_real t69 = t65 * t61 + t68 * t60;
    const six_link_real t70 = t65 * t60 - t61 * t68;
    const six_link_real t71 = t61 * t66 + t67 * t60;
    const six_link_real t72 = t61 * t67 - t66 * t60;
    const six_link_real t73 = t69 * t64 - t71 * t63;
    const six_link_real t74 = t69 * t63 + t64 * t71;
    const six_link_real t75 = t64 * t70 - t72 * t63;
    const six_link_real t76 = t64 * t72 + t70 * t63;
    const six_link_real new_quaternion_1 = base->Q[0] * t73
        - (base->Q[1] * t75 + base->Q[2] * t74 + base->Q[3] * t76);
    const six_link_real new_quaternion_2 = base->Q[0] * t75 + t73 * base->Q[1]
        + (base->Q[2] * t76 - base->Q[3] * t74);
    const six_link_real new_quaternion_3 = base->Q[0] * t74 + t73 * base->Q[2]
        + (base->Q[3] * t75 - base->Q[1] * t76);
    const six_link_real new_quaternion_4 = base->Q[0] * t76 + t73 * base->Q[3]
        + (base->Q[1] * t74 - base->Q[2] * t75);

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[0] * REAL(2.23606797749979);
    const six_link_real r_T_z = eta[1] * REAL(2.23606797749979);

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[0] * REAL(2.23606797749979);
    const six_link_real udot_T_z = etadot[1] * REAL(2.23606797749979);

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t77 = omega_s_x + omega_R_x;
    const six_link_real t78 = omega_s_y + omega_y;
    const six_link_real t79 = omega_s_z + omega_R_z;
    const six_link_real omega_T_x_2 = R_T_xx * t77 + minus_R_T_xy * t78 - R_T_xz * t79;
    const six_link_real omega_T_y_2 = R_T_yy * t78 - minus_R_T_xy * t77 + R_T_yz * t79;
    const six_link_real omega_T_z_2 = R_T_xz * t77 + R_T_yz * t78 + R_T_zz * t79;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t80 = v_R_x + omega_y * r_T_z - omega_R_z * r_T_y;
    const six_link_real t81 = udot_T_y + v_R_y + c->length * omega_R_z - omega_R_x * r_T_z;
    const six_link_real t82 = udot_T_z + v_R_z + omega_R_x * r_T_y - c->length * omega_y;
    const six_link_real v_T_x = R_T_xx * t80 + minus_R_T_xy * t81 - R_T_xz * t82;
    const six_link_real v_T_y = R_T_yy * t81 - minus_R_T_xy * t80 + R_T_yz * t82;
    const six_link_real v_T_z = R_T_xz * t80 + R_T_yz * t81 + R_T_zz * t82;

    const six_link_real R_xx = t44 * R_T_xx + t45 * minus_R_T_xy - t46 * R_T_xz;
    const six_link_real R_xy = t45 * R_T_yy - t44 * minus_R_T_xy + t46 * R_T_yz;
    const six_link_real R_xz = t44 * R_T_xz + t45 * R_T_yz + t46 * R_T_zz;
    const six_link_real R_yx = t47 * R_T_xx + t48 * minus_R_T_xy - t49 * R_T_xz;
    const six_link_real R_yy = t48 * R_T_yy - t47 * minus_R_T_xy + t49 * R_T_yz;
    const six_link_real R_yz = t47 * R_T_xz + t48 * R_T_yz + t49 * R_T_zz;
    const six_link_real R_zx = t50 * R_T_xx + t51 * minus_R_T_xy - t52 * R_T_xz;
    const six_link_real R_zy = t51 * R_T_yy - t50 * minus_R_T_xy + t52 * R_T_yz;
    const six_link_real R_zz = t50 * R_T_xz + t51 * R_T_yz + t52 * R_T_zz;
    const six_link_real r_x = new_position_1 + (t44 * c->length + t45 * r_T_y + t46 * r_T_z);
    const six_link_real r_y = new_position_2 + (t47 * c->length + t48 * r_T_y + t49 * r_T_z);
    const six_link_real r_z = new_position_3 + (t50 * c->length + t51 * r_T_y + t52 * r_T_z);
    const six_link_real t83 = x * REAL(0.25);
    const six_link_real t84 = 1 - t83 * (REAL(0.5) - t83 * six_link_c4(t83));
    const six_link_real t85 = (1 - t83 * (REAL(0.16666666666666666) - t83 * six_link_c5(t83))) * REAL(0.5);
    const six_link_real t86 = t85 * theta_y;
    const six_link_real t87 = t85 * theta_z;
    const six_link_real Q_1 = new_quaternion_1 * t84 - (new_quaternion_3 * t86 + new_quaternion_4 * t87);
    const six_link_real Q_2 = t84 * new_quaternion_2 + (new_quaternion_3 * t87 - new_quaternion_4 * t86);
    const six_link_real Q_3 = new_quaternion_1 * t86 + t84 * new_quaternion_3 - new_quaternion_2 * t87;
    const six_link_real Q_4 = new_quaternion_1 * t87 + t84 * new_quaternion_4 + new_quaternion_2 * t86;

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
    new_twist[1] = omega_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = new_position_1;
    new_position[1] = new_position_2;
    new_position[2] = new_position_3;
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
    return SIX_LINK_OK;
}

/* project, links like wrist_roll: 138 operations */
static six_link_status project_wrist_roll(const six_link_link_constants *c, const six_link_node *base, six_link_node *tip,
    const six_link_real q[1], const six_link_real twist[6], const six_link_real quaternion[4],
    six_link_real new_q[1], six_link_real new_twist[6], six_link_real new_quaternion[4],
    six_link_real new_position[3])
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
    const six_link_real R_m_12 = t4 * (t6 - t9);
    const six_link_real R_m_13 = t4 * (t10 + t7);
    const six_link_real R_m_21 = t4 * (t9 + t6);
    const six_link_real R_m_23 = t4 * (t8 - t11);
    const six_link_real R_m_31 = t4 * (t7 - t10);
    const six_link_real R_m_32 = t4 * (t11 + t8);
    const six_link_real R_m_11 = 1 + t4 * (t1 - t5);
    const six_link_real R_m_22 = 1 + t4 * (t2 - t5);
    const six_link_real R_m_33 = 1 + t4 * (t3 - t5);
    const six_link_real t12 = base->R_m[1] * R_m_12 + base->R_m[4] * R_m_22 + base->R_m[7] * R_m_32;
    const six_link_real t13 = base->R_m[1] * R_m_13 + base->R_m[4] * R_m_23 + base->R_m[7] * R_m_33;
    const six_link_real t14 = base->R_m[2] * R_m_12 + base->R_m[5] * R_m_22 + base->R_m[8] * R_m_32;
    const six_link_real t15 = base->R_m[2] * R_m_13 + base->R_m[5] * R_m_23 + base->R_m[8] * R_m_33;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_yy = six_link_cos(q[0]);
    const six_link_real minus_R_rel_yz = six_link_sin(q[0]);

    const six_link_real t16 = q[0]
        + (R_rel_yy * t14 - minus_R_rel_yz * t12 - (R_rel_yy * t13 + minus_R_rel_yz * t15)) * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_yy_2 = six_link_cos(t16);
    const six_link_real minus_R_rel_yz_2 = six_link_sin(t16);

    const six_link_real t17 = (R_rel_yy_2 * t14 - minus_R_rel_yz_2 * t12
        - (R_rel_yy_2 * t13 + minus_R_rel_yz_2 * t15)) * REAL(0.5);
    const six_link_real new_q_1 = t16 + t17;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_yy_3 = six_link_cos(new_q_1);
    const six_link_real minus_R_rel_yz_3 = six_link_sin(new_q_1);

    const six_link_real t18 = twist[0] - base->omega_m[0];

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_y = R_rel_yy_3 * base->omega[1] + minus_R_rel_yz_3 * base->omega[2];
    const six_link_real omega_R_z = R_rel_yy_3 * base->omega[2] - minus_R_rel_yz_3 * base->omega[1];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_x = base->omega[0] + t18;

    /* v_R: velocity of the joint point */
    const six_link_real v_R_y = R_rel_yy_3 * base->v[1] + minus_R_rel_yz_3 * base->v[2];
    const six_link_real v_R_z = R_rel_yy_3 * base->v[2] - minus_R_rel_yz_3 * base->v[1];

    const six_link_real R_xy = base->R[1] * R_rel_yy_3 + base->R[2] * minus_R_rel_yz_3;
    const six_link_real R_xz = base->R[2] * R_rel_yy_3 - base->R[1] * minus_R_rel_yz_3;
    const six_link_real R_yy = base->R[4] * R_rel_yy_3 + base->R[5] * minus_R_rel_yz_3;
    const six_link_real R_yz = base->R[5] * R_rel_yy_3 - base->R[4] * minus_R_rel_yz_3;
    const six_link_real R_zy = base->R[7] * R_rel_yy_3 + base->R[8] * minus_R_rel_yz_3;
    const six_link_real R_zz = base->R[8] * R_rel_yy_3 - base->R[7] * minus_R_rel_yz_3;
    const six_link_real t19 = new_q_1 * REAL(0.5);
    const six_link_real t20 = six_link_sin(t19);
    const six_link_real t21 = six_link_cos(t19);
    const six_link_real new_quaternion_1 = base->Q[0] * t21 - base->Q[1] * t20;
    const six_link_real new_quaternion_2 = base->Q[0] * t20 + t21 * base->Q[1];
    const six_link_real new_quaternion_3 = t21 * base->Q[2] + base->Q[3] * t20;
    const six_link_real new_quaternion_4 = t21 * base->Q[3] - base->Q[2] * t20;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = v_R_y + c->length * omega_R_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_R_y;

    const six_link_real r_x = base->r[0] + base->R[0] * c->length;
    const six_link_real r_y = base->r[1] + base->R[3] * c->length;
    const six_link_real r_z = base->r[2] + base->R[6] * c->length;

    /* outputs */
    new_q[0] = new_q_1;
    tip->omega_m[0] = twist[0];
    tip->omega_m[1] = twist[1];
    tip->omega_m[2] = twist[2];
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
    new_twist[1] = omega_R_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = base->v[0];
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega[0] = omega_x;
    tip->omega[1] = omega_R_y;
    tip->omega[2] = omega_R_z;
    tip->v[0] = base->v[0];
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
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

/* project, links like wrist_pitch: 138 operations */
static six_link_status project_wrist_pitch(const six_link_link_constants *c, const six_link_node *base, six_link_node *tip,
    const six_link_real q[1], const six_link_real twist[6], const six_link_real quaternion[4],
    six_link_real new_q[1], six_link_real new_twist[6], six_link_real new_quaternion[4],
    six_link_real new_position[3])
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
    const six_link_real R_m_12 = t4 * (t6 - t9);
    const six_link_real R_m_13 = t4 * (t10 + t7);
    const six_link_real R_m_21 = t4 * (t9 + t6);
    const six_link_real R_m_23 = t4 * (t8 - t11);
    const six_link_real R_m_31 = t4 * (t7 - t10);
    const six_link_real R_m_32 = t4 * (t11 + t8);
    const six_link_real R_m_11 = 1 + t4 * (t1 - t5);
    const six_link_real R_m_22 = 1 + t4 * (t2 - t5);
    const six_link_real R_m_33 = 1 + t4 * (t3 - t5);
    const six_link_real t12 = base->R_m[0] * R_m_11 + base->R_m[3] * R_m_21 + base->R_m[6] * R_m_31;
    const six_link_real t13 = base->R_m[0] * R_m_13 + base->R_m[3] * R_m_23 + base->R_m[6] * R_m_33;
    const six_link_real t14 = base->R_m[2] * R_m_11 + base->R_m[5] * R_m_21 + base->R_m[8] * R_m_31;
    const six_link_real t15 = base->R_m[2] * R_m_13 + base->R_m[5] * R_m_23 + base->R_m[8] * R_m_33;

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real R_rel_xz = six_link_sin(q[0]);

    const six_link_real t16 = q[0]
        + (R_rel_xx * t13 - R_rel_xz * t15 - (R_rel_xz * t12 + R_rel_xx * t14)) * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx_2 = six_link_cos(t16);
    const six_link_real R_rel_xz_2 = six_link_sin(t16);

    const six_link_real new_q_1 = t16
        + (R_rel_xx_2 * t13 - R_rel_xz_2 * t15 - (R_rel_xz_2 * t12 + R_rel_xx_2 * t14)) * REAL(0.5);

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx_3 = six_link_cos(new_q_1);
    const six_link_real R_rel_xz_3 = six_link_sin(new_q_1);

    const six_link_real t17 = twist[1] - base->omega_m[1];

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx_3 * base->omega[0] - R_rel_xz_3 * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz_3 * base->omega[0] + R_rel_xx_3 * base->omega[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = base->omega[1] + t17;

    /* v_R: velocity of the joint point */
    const six_link_real v_R_x = R_rel_xx_3 * base->v[0] - R_rel_xz_3 * base->v[2];
    const six_link_real v_R_z = R_rel_xz_3 * base->v[0] + R_rel_xx_3 * base->v[2];

    const six_link_real R_xx = base->R[0] * R_rel_xx_3 - base->R[2] * R_rel_xz_3;
    const six_link_real R_xz = base->R[0] * R_rel_xz_3 + base->R[2] * R_rel_xx_3;
    const six_link_real R_yx = base->R[3] * R_rel_xx_3 - base->R[5] * R_rel_xz_3;
    const six_link_real R_yz = base->R[3] * R_rel_xz_3 + base->R[5] * R_rel_xx_3;
    const six_link_real R_zx = base->R[6] * R_rel_xx_3 - base->R[8] * R_rel_xz_3;
    const six_link_real R_zz = base->R[6] * R_rel_xz_3 + base->R[8] * R_rel_xx_3;
    const six_link_real t18 = new_q_1 * REAL(0.5);
    const six_link_real t19 = six_link_sin(t18);
    const six_link_real t20 = six_link_cos(t18);
    const six_link_real new_quaternion_1 = base->Q[0] * t20 - base->Q[2] * t19;
    const six_link_real new_quaternion_3 = base->Q[0] * t19 + t20 * base->Q[2];
    const six_link_real new_quaternion_2 = t20 * base->Q[1] - base->Q[3] * t19;
    const six_link_real new_quaternion_4 = t20 * base->Q[3] + base->Q[1] * t19;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = base->v[1] + c->length * omega_R_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_y;

    const six_link_real r_x = base->r[0] + R_xx * c->length;
    const six_link_real r_y = base->r[1] + R_yx * c->length;
    const six_link_real r_z = base->r[2] + R_zx * c->length;

    /* outputs */
    new_q[0] = new_q_1;
    tip->omega_m[0] = twist[0];
    tip->omega_m[1] = twist[1];
    tip->omega_m[2] = twist[2];
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
    new_twist[1] = omega_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = v_R_x;
    new_twist[4] = base->v[1];
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega[0] = omega_R_x;
    tip->omega[1] = omega_y;
    tip->omega[2] = omega_R_z;
    tip->v[0] = v_R_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
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

/* forward kinematics, links like shoulder: 88 operations */
static six_link_status forward_kinematics_shoulder(const six_link_link_constants *c, const six_link_node *base, six_link_node *tip,
    const six_link_real q[1], const six_link_real qdot[1], six_link_real new_twist[6],
    six_link_real new_quaternion[4], six_link_real new_position[3])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real minus_R_rel_xy = six_link_sin(q[0]);

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx * base->omega[0] + minus_R_rel_xy * base->omega[1];
    const six_link_real omega_R_y = R_rel_xx * base->omega[1] - minus_R_rel_xy * base->omega[0];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_z = base->omega[2] + qdot[0];

    /* v_R: velocity of the joint point */
    const six_link_real t1 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t2 = base->v[1] + c->mount_xyz_x * base->omega[2] - c->mount_xyz_z * base->omega[0];
    const six_link_real v_R_x = R_rel_xx * t1 + minus_R_rel_xy * t2;
    const six_link_real v_R_y = R_rel_xx * t2 - minus_R_rel_xy * t1;
    const six_link_real v_R_z = base->v[2] + c->mount_xyz_y * base->omega[0] - c->mount_xyz_x * base->omega[1];

    const six_link_real R_xx = base->R[0] * R_rel_xx + base->R[1] * minus_R_rel_xy;
    const six_link_real R_xy = base->R[1] * R_rel_xx - base->R[0] * minus_R_rel_xy;
    const six_link_real R_yx = base->R[3] * R_rel_xx + base->R[4] * minus_R_rel_xy;
    const six_link_real R_yy = base->R[4] * R_rel_xx - base->R[3] * minus_R_rel_xy;
    const six_link_real R_zx = base->R[6] * R_rel_xx + base->R[7] * minus_R_rel_xy;
    const six_link_real R_zy = base->R[7] * R_rel_xx - base->R[6] * minus_R_rel_xy;
    const six_link_real new_position_1 = base->r[0]
        + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y + base->R[2] * c->mount_xyz_z);
    const six_link_real new_position_2 = base->r[1]
        + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y + base->R[5] * c->mount_xyz_z);
    const six_link_real new_position_3 = base->r[2]
        + (base->R[6] * c->mount_xyz_x + base->R[7] * c->mount_xyz_y + base->R[8] * c->mount_xyz_z);
    const six_link_real t3 = q[0] * REAL(0.5);
    const six_link_real t4 = six_link_sin(t3);
    const six_link_real t5 = six_link_cos(t3);
    const six_link_real new_quaternion_1 = base->Q[0] * t5 - base->Q[3] * t4;
    const six_link_real new_quaternion_4 = base->Q[0] * t4 + t5 * base->Q[3];
    const six_link_real new_quaternion_2 = t5 * base->Q[1] + base->Q[2] * t4;
    const six_link_real new_quaternion_3 = t5 * base->Q[2] - base->Q[1] * t4;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = v_R_y + c->length * omega_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_R_y;

    const six_link_real r_x = new_position_1 + R_xx * c->length;
    const six_link_real r_y = new_position_2 + R_yx * c->length;
    const six_link_real r_z = new_position_3 + R_zx * c->length;

    /* outputs */
    new_twist[0] = omega_R_x;
    new_twist[1] = omega_R_y;
    new_twist[2] = omega_z;
    new_twist[3] = v_R_x;
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = new_position_1;
    new_position[1] = new_position_2;
    new_position[2] = new_position_3;
    tip->omega[0] = omega_R_x;
    tip->omega[1] = omega_R_y;
    tip->omega[2] = omega_z;
    tip->v[0] = v_R_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    tip->R[0] = R_xx;
    tip->R[1] = R_xy;
    tip->R[2] = base->R[2];
    tip->R[3] = R_yx;
    tip->R[4] = R_yy;
    tip->R[5] = base->R[5];
    tip->R[6] = R_zx;
    tip->R[7] = R_zy;
    tip->R[8] = base->R[8];
    tip->r[0] = r_x;
    tip->r[1] = r_y;
    tip->r[2] = r_z;
    tip->Q[0] = new_quaternion_1;
    tip->Q[1] = new_quaternion_2;
    tip->Q[2] = new_quaternion_3;
    tip->Q[3] = new_quaternion_4;
    return SIX_LINK_OK;
}

/* forward kinematics, links like upper_arm: 307 operations */
static six_link_status forward_kinematics_upper_arm(const six_link_link_constants *c, const six_link_node *base, six_link_node *tip,
    const six_link_real q[1], const six_link_real qdot[1], const six_link_real eta[3],
    const six_link_real etadot[3], six_link_real new_twist[6], six_link_real new_quaternion[4],
    six_link_real new_position[3])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real R_rel_xz = six_link_sin(q[0]);

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx * base->omega[0] - R_rel_xz * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_xx * base->omega[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = base->omega[1] + qdot[0];

    /* v_R: velocity of the joint point */
    const six_link_real t1 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t2 = base->v[2] + c->mount_xyz_y * base->omega[0] - c->mount_xyz_x * base->omega[1];
    const six_link_real v_R_x = R_rel_xx * t1 - R_rel_xz * t2;
    const six_link_real v_R_y = base->v[1] + c->mount_xyz_x * base->omega[2] - c->mount_xyz_z * base->omega[0];
    const six_link_real v_R_z = R_rel_xz * t1 + R_rel_xx * t2;

    const six_link_real t3 = base->R[0] * R_rel_xx - base->R[2] * R_rel_xz;
    const six_link_real t4 = base->R[0] * R_rel_xz + base->R[2] * R_rel_xx;
    const six_link_real t5 = base->R[3] * R_rel_xx - base->R[5] * R_rel_xz;
    const six_link_real t6 = base->R[3] * R_rel_xz + base->R[5] * R_rel_xx;
    const six_link_real t7 = base->R[6] * R_rel_xx - base->R[8] * R_rel_xz;
    const six_link_real t8 = base->R[6] * R_rel_xz + base->R[8] * R_rel_xx;
    const six_link_real new_position_1 = base->r[0]
        + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y + base->R[2] * c->mount_xyz_z);
    const six_link_real new_position_2 = base->r[1]
        + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y + base->R[5] * c->mount_xyz_z);
    const six_link_real new_position_3 = base->r[2]
        + (base->R[6] * c->mount_xyz_x + base->R[7] * c->mount_xyz_y + base->R[8] * c->mount_xyz_z);
    const six_link_real t9 = q[0] * REAL(0.5);
    const six_link_real t10 = six_link_sin(t9);
    const six_link_real t11 = six_link_cos(t9);
    const six_link_real new_quaternion_1 = base->Q[0] * t11 - base->Q[2] * t10;
    const six_link_real new_quaternion_3 = base->Q[0] * t10 + t11 * base->Q[2];
    const six_link_real new_quaternion_2 = t11 * base->Q[1] - base->Q[3] * t10;
    const six_link_real new_quaternion_4 = t11 * base->Q[3] + base->Q[1] * t10;

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[0] * 2;
    const six_link_real r_T_z = eta[1] * 2;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[2] * REAL(1.4142135623730951);
    const six_link_real theta_y = c->Psi_c_y2 * eta[1];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0];

    /* x: squared angle of the tip section */
    const six_link_real t12 = theta_x * theta_x;
    const six_link_real t13 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t12 + t13;
    const six_link_real t14 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t14;

    /* c1: Stumpff function of order 1 */
    const six_link_real c3 = REAL(0.16666666666666666) - x * six_link_c5(x);
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t13 + t14;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t12 + t14;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t15 = c2 * theta_hat2_12;
    const six_link_real t16 = c1 * theta_z;
    const six_link_real R_T_xy = t15 - t16;
    const six_link_real t17 = c1 * theta_y;
    const six_link_real t18 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t17 + t18;
    const six_link_real R_T_yx = t16 + t15;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t19 = c2 * theta_hat2_23;
    const six_link_real t20 = c1 * theta_x;
    const six_link_real R_T_yz = t19 - t20;
    const six_link_real R_T_zx = t18 - t17;
    const six_link_real R_T_zy = t20 + t19;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[0] * 2;
    const six_link_real udot_T_z = etadot[1] * 2;

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_x = etadot[2] * REAL(1.4142135623730951);
    const six_link_real thetadot_y = c->Psi_c_y2 * etadot[1];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t21 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real t22 = theta_x * thetadot_y - theta_y * thetadot_x;
    const six_link_real t23 = theta_z * thetadot_x - theta_x * thetadot_z;
    const six_link_real omega_s_x = thetadot_x + c2 * t21 + c3 * (theta_y * t22 - theta_z * t23);
    const six_link_real omega_s_y = thetadot_y + c2 * t23 + c3 * (theta_z * t21 - theta_x * t22);
    const six_link_real omega_s_z = thetadot_z + c2 * t22 + c3 * (theta_x * t23 - theta_y * t21);

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t24 = omega_s_x + omega_R_x;
    const six_link_real t25 = omega_s_y + omega_y;
    const six_link_real t26 = omega_s_z + omega_R_z;
    const six_link_real omega_T_x = R_T_xx * t24 + R_T_yx * t25 + R_T_zx * t26;
    const six_link_real omega_T_y = R_T_xy * t24 + R_T_yy * t25 + R_T_zy * t26;
    const six_link_real omega_T_z = R_T_xz * t24 + R_T_yz * t25 + R_T_zz * t26;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t27 = v_R_x + omega_y * r_T_z - omega_R_z * r_T_y;
    const six_link_real t28 = udot_T_y + v_R_y + c->length * omega_R_z - omega_R_x * r_T_z;
    const six_link_real t29 = udot_T_z + v_R_z + omega_R_x * r_T_y - c->length * omega_y;
    const six_link_real v_T_x = R_T_xx * t27 + R_T_yx * t28 + R_T_zx * t29;
    const six_link_real v_T_y = R_T_xy * t27 + R_T_yy * t28 + R_T_zy * t29;
    const six_link_real v_T_z = R_T_xz * t27 + R_T_yz * t28 + R_T_zz * t29;

    const six_link_real R_xx = t3 * R_T_xx + base->R[1] * R_T_yx + t4 * R_T_zx;
    const six_link_real R_xy = t3 * R_T_xy + base->R[1] * R_T_yy + t4 * R_T_zy;
    const six_link_real R_xz = t3 * R_T_xz + base->R[1] * R_T_yz + t4 * R_T_zz;
    const six_link_real R_yx = t5 * R_T_xx + base->R[4] * R_T_yx + t6 * R_T_zx;
    const six_link_real R_yy = t5 * R_T_xy + base->R[4] * R_T_yy + t6 * R_T_zy;
    const six_link_real R_yz = t5 * R_T_xz + base->R[4] * R_T_yz + t6 * R_T_zz;
    const six_link_real R_zx = t7 * R_T_xx + base->R[7] * R_T_yx + t8 * R_T_zx;
    const six_link_real R_zy = t7 * R_T_xy + base->R[7] * R_T_yy + t8 * R_T_zy;
    const six_link_real R_zz = t7 * R_T_xz + base->R[7] * R_T_yz + t8 * R_T_zz;
    const six_link_real r_x = new_position_1 + (t3 * c->length + base->R[1] * r_T_y + t4 * r_T_z);
    const six_link_real r_y = new_position_2 + (t5 * c->length + base->R[4] * r_T_y + t6 * r_T_z);
    const six_link_real r_z = new_position_3 + (t7 * c->length + base->R[7] * r_T_y + t8 * r_T_z);
    const six_link_real t30 = x * REAL(0.25);
    const six_link_real t31 = 1 - t30 * (REAL(0.5) - t30 * six_link_c4(t30));
    const six_link_real t32 = (1 - t30 * (REAL(0.16666666666666666) - t30 * six_link_c5(t30))) * REAL(0.5);
    const six_link_real t33 = t32 * theta_x;
    const six_link_real t34 = t32 * theta_y;
    const six_link_real t35 = t32 * theta_z;
    const six_link_real Q_1 = new_quaternion_1 * t31
        - (new_quaternion_2 * t33 + new_quaternion_3 * t34 + new_quaternion_4 * t35);
    const six_link_real Q_2 = new_quaternion_1 * t33 + t31 * new_quaternion_2
        + (new_quaternion_3 * t35 - new_quaternion_4 * t34);
    const six_link_real Q_3 = new_quaternion_1 * t34 + t31 * new_quaternion_3
        + (new_quaternion_4 * t33 - new_quaternion_2 * t35);
    const six_link_real Q_4 = new_quaternion_1 * t35 + t31 * new_quaternion_4
        + (new_quaternion_2 * t34 - new_quaternion_3 * t33);

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
    new_position[0] = new_position_1;
    new_position[1] = new_position_2;
    new_position[2] = new_position_3;
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
    return SIX_LINK_OK;
}

/* forward kinematics, links like forearm: 377 operations */
static six_link_status forward_kinematics_forearm(const six_link_link_constants *c, const six_link_node *base, six_link_node *tip,
    const six_link_real q[1], const six_link_real qdot[1], const six_link_real eta[2],
    const six_link_real etadot[2], six_link_real new_twist[6], six_link_real new_quaternion[4],
    six_link_real new_position[3])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real t1 = six_link_cos(q[0]);
    const six_link_real t2 = six_link_sin(q[0]);
    const six_link_real R_rel_xx = c->R_m_xx * t1 - c->R_m_xz * t2;
    const six_link_real R_rel_xz = c->R_m_xx * t2 + c->R_m_xz * t1;
    const six_link_real R_rel_yx = c->R_m_yx * t1 - c->R_m_yz * t2;
    const six_link_real R_rel_yz = c->R_m_yx * t2 + c->R_m_yz * t1;
    const six_link_real R_rel_zx = c->R_m_zx * t1 - c->R_m_zz * t2;
    const six_link_real R_rel_zz = c->R_m_zx * t2 + c->R_m_zz * t1;

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx * base->omega[0] + R_rel_yx * base->omega[1]
        + R_rel_zx * base->omega[2];
    const six_link_real omega_R_y = c->R_m_xy * base->omega[0] + c->R_m_yy * base->omega[1]
        + c->R_m_zy * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_yz * base->omega[1]
        + R_rel_zz * base->omega[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = omega_R_y + qdot[0];

    /* v_R: velocity of the joint point */
    const six_link_real t3 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t4 = base->v[1] + c->mount_xyz_x * base->omega[2] - c->mount_xyz_z * base->omega[0];
    const six_link_real t5 = base->v[2] + c->mount_xyz_y * base->omega[0] - c->mount_xyz_x * base->omega[1];
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
    const six_link_real new_position_1 = base->r[0]
        + (base->R[0] * c->mount_xyz_x + base->R[1] * c->mount_xyz_y + base->R[2] * c->mount_xyz_z);
    const six_link_real new_position_2 = base->r[1]
        + (base->R[3] * c->mount_xyz_x + base->R[4] * c->mount_xyz_y + base->R[5] * c->mount_xyz_z);
    const six_link_real new_position_3 = base->r[2]
        + (base->R[6] * c->mount_xyz_x + base->R[7] * c->mount_xyz_y + base->R[8] * c->mount_xyz_z);
    const six_link_real t15 = c->mount_rpy_z * REAL(0.5);
    const six_link_real t16 = six_link_sin(t15);
    const six_link_real t17 = six_link_cos(t15);
    const six_link_real t18 = c->mount_rpy_y * REAL(0.5);
    const six_link_real t19 = six_link_sin(t18);
    const six_link_real t20 = six_link_cos(t18);
    const six_link_real t21 = c->mount_rpy_x * REAL(0.5);
    const six_link_real t22 = six_link_sin(t21);
    const six_link_real t23 = six_link_cos(t21);
    const six_link_real t24 = q[0] * REAL(0.5);
    const six_link_real t25 = six_link_sin(t24);
    const six_link_real t26 = six_link_cos(t24);
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
    const six_link_real new_quaternion_1 = base->Q[0] * t35
        - (base->Q[1] * t37 + base->Q[2] * t36 + base->Q[3] * t38);
    const six_link_real new_quaternion_2 = base->Q[0] * t37 + t35 * base->Q[1]
        + (base->Q[2] * t38 - base->Q[3] * t36);
    const six_link_real new_quaternion_3 = base->Q[0] * t36 + t35 * base->Q[2]
        + (base->Q[3] * t37 - base->Q[1] * t38);
    const six_link_real new_quaternion_4 = base->Q[0] * t38 + t35 * base->Q[3]
        + (base->Q[1] * t36 - base->Q[2] * t37);

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[0] * REAL(2.23606797749979);
    const six_link_real r_T_z = eta[1] * REAL(2.23606797749979);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y2 * eta[1];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const six_link_real c3 = REAL(0.16666666666666666) - x * six_link_c5(x);
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real c2 = REAL(0.5) - x * six_link_c4(x);

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real minus_R_T_xy = c1 * theta_z;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[0] * REAL(2.23606797749979);
    const six_link_real udot_T_z = etadot[1] * REAL(2.23606797749979);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_y = c->Psi_c_y2 * etadot[1];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t39 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real omega_s_x = c2 * t39;
    const six_link_real omega_s_y = thetadot_y + c3 * theta_z * t39;
    const six_link_real omega_s_z = thetadot_z - c3 * theta_y * t39;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t40 = omega_s_x + omega_R_x;
    const six_link_real t41 = omega_s_y + omega_y;
    const six_link_real t42 = omega_s_z + omega_R_z;
    const six_link_real omega_T_x = R_T_xx * t40 + minus_R_T_xy * t41 - R_T_xz * t42;
    const six_link_real omega_T_y = R_T_yy * t41 - minus_R_T_xy * t40 + R_T_yz * t42;
    const six_link_real omega_T_z = R_T_xz * t40 + R_T_yz * t41 + R_T_zz * t42;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t43 = v_R_x + omega_y * r_T_z - omega_R_z * r_T_y;
    const six_link_real t44 = udot_T_y + v_R_y + c->length * omega_R_z - omega_R_x * r_T_z;
    const six_link_real t45 = udot_T_z + v_R_z + omega_R_x * r_T_y - c->length * omega_y;
    const six_link_real v_T_x = R_T_xx * t43 + minus_R_T_xy * t44 - R_T_xz * t45;
    const six_link_real v_T_y = R_T_yy * t44 - minus_R_T_xy * t43 + R_T_yz * t45;
    const six_link_real v_T_z = R_T_xz * t43 + R_T_yz * t44 + R_T_zz * t45;

    const six_link_real R_xx = t6 * R_T_xx + t7 * minus_R_T_xy - t8 * R_T_xz;
    const six_link_real R_xy = t7 * R_T_yy - t6 * minus_R_T_xy + t8 * R_T_yz;
    const six_link_real R_xz = t6 * R_T_xz + t7 * R_T_yz + t8 * R_T_zz;
    const six_link_real R_yx = t9 * R_T_xx + t10 * minus_R_T_xy - t11 * R_T_xz;
    const six_link_real R_yy = t10 * R_T_yy - t9 * minus_R_T_xy + t11 * R_T_yz;
    const six_link_real R_yz = t9 * R_T_xz + t10 * R_T_yz + t11 * R_T_zz;
    const six_link_real R_zx = t12 * R_T_xx + t13 * minus_R_T_xy - t14 * R_T_xz;
    const six_link_real R_zy = t13 * R_T_yy - t12 * minus_R_T_xy + t14 * R_T_yz;
    const six_link_real R_zz = t12 * R_T_xz + t13 * R_T_yz + t14 * R_T_zz;
    const six_link_real r_x = new_position_1 + (t6 * c->length + t7 * r_T_y + t8 * r_T_z);
    const six_link_real r_y = new_position_2 + (t9 * c->length + t10 * r_T_y + t11 * r_T_z);
    const six_link_real r_z = new_position_3 + (t12 * c->length + t13 * r_T_y + t14 * r_T_z);
    const six_link_real t46 = x * REAL(0.25);
    const six_link_real t47 = 1 - t46 * (REAL(0.5) - t46 * six_link_c4(t46));
    const six_link_real t48 = (1 - t46 * (REAL(0.16666666666666666) - t46 * six_link_c5(t46))) * REAL(0.5);
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
    new_position[0] = new_position_1;
    new_position[1] = new_position_2;
    new_position[2] = new_position_3;
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
    return SIX_LINK_OK;
}

/* forward kinematics, links like wrist_roll: 58 operations */
static six_link_status forward_kinematics_wrist_roll(const six_link_link_constants *c, const six_link_node *base, six_link_node *tip,
    const six_link_real q[1], const six_link_real qdot[1], six_link_real new_twist[6],
    six_link_real new_quaternion[4], six_link_real new_position[3])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_yy = six_link_cos(q[0]);
    const six_link_real minus_R_rel_yz = six_link_sin(q[0]);

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_y = R_rel_yy * base->omega[1] + minus_R_rel_yz * base->omega[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega[2] - minus_R_rel_yz * base->omega[1];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_x = base->omega[0] + qdot[0];

    /* v_R: velocity of the joint point */
    const six_link_real v_R_y = R_rel_yy * base->v[1] + minus_R_rel_yz * base->v[2];
    const six_link_real v_R_z = R_rel_yy * base->v[2] - minus_R_rel_yz * base->v[1];

    const six_link_real R_xy = base->R[1] * R_rel_yy + base->R[2] * minus_R_rel_yz;
    const six_link_real R_xz = base->R[2] * R_rel_yy - base->R[1] * minus_R_rel_yz;
    const six_link_real R_yy = base->R[4] * R_rel_yy + base->R[5] * minus_R_rel_yz;
    const six_link_real R_yz = base->R[5] * R_rel_yy - base->R[4] * minus_R_rel_yz;
    const six_link_real R_zy = base->R[7] * R_rel_yy + base->R[8] * minus_R_rel_yz;
    const six_link_real R_zz = base->R[8] * R_rel_yy - base->R[7] * minus_R_rel_yz;
    const six_link_real t1 = q[0] * REAL(0.5);
    const six_link_real t2 = six_link_sin(t1);
    const six_link_real t3 = six_link_cos(t1);
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
    new_twist[3] = base->v[0];
    new_twist[4] = v_R_y;
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega[0] = omega_x;
    tip->omega[1] = omega_R_y;
    tip->omega[2] = omega_R_z;
    tip->v[0] = base->v[0];
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
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
static six_link_status forward_kinematics_wrist_pitch(const six_link_link_constants *c, const six_link_node *base, six_link_node *tip,
    const six_link_real q[1], const six_link_real qdot[1], six_link_real new_twist[6],
    six_link_real new_quaternion[4], six_link_real new_position[3])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real R_rel_xz = six_link_sin(q[0]);

    /* omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_x = R_rel_xx * base->omega[0] - R_rel_xz * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_xx * base->omega[2];

    /* omega: angular velocity of the link (45) */
    const six_link_real omega_y = base->omega[1] + qdot[0];

    /* v_R: velocity of the joint point */
    const six_link_real v_R_x = R_rel_xx * base->v[0] - R_rel_xz * base->v[2];
    const six_link_real v_R_z = R_rel_xz * base->v[0] + R_rel_xx * base->v[2];

    const six_link_real R_xx = base->R[0] * R_rel_xx - base->R[2] * R_rel_xz;
    const six_link_real R_xz = base->R[0] * R_rel_xz + base->R[2] * R_rel_xx;
    const six_link_real R_yx = base->R[3] * R_rel_xx - base->R[5] * R_rel_xz;
    const six_link_real R_yz = base->R[3] * R_rel_xz + base->R[5] * R_rel_xx;
    const six_link_real R_zx = base->R[6] * R_rel_xx - base->R[8] * R_rel_xz;
    const six_link_real R_zz = base->R[6] * R_rel_xz + base->R[8] * R_rel_xx;
    const six_link_real t1 = q[0] * REAL(0.5);
    const six_link_real t2 = six_link_sin(t1);
    const six_link_real t3 = six_link_cos(t1);
    const six_link_real new_quaternion_1 = base->Q[0] * t3 - base->Q[2] * t2;
    const six_link_real new_quaternion_3 = base->Q[0] * t2 + t3 * base->Q[2];
    const six_link_real new_quaternion_2 = t3 * base->Q[1] - base->Q[3] * t2;
    const six_link_real new_quaternion_4 = t3 * base->Q[3] + base->Q[1] * t2;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = base->v[1] + c->length * omega_R_z;
    const six_link_real v_T_z = v_R_z - c->length * omega_y;

    const six_link_real r_x = base->r[0] + R_xx * c->length;
    const six_link_real r_y = base->r[1] + R_yx * c->length;
    const six_link_real r_z = base->r[2] + R_zx * c->length;

    /* outputs */
    new_twist[0] = omega_R_x;
    new_twist[1] = omega_y;
    new_twist[2] = omega_R_z;
    new_twist[3] = v_R_x;
    new_twist[4] = base->v[1];
    new_twist[5] = v_R_z;
    new_quaternion[0] = new_quaternion_1;
    new_quaternion[1] = new_quaternion_2;
    new_quaternion[2] = new_quaternion_3;
    new_quaternion[3] = new_quaternion_4;
    new_position[0] = base->r[0];
    new_position[1] = base->r[1];
    new_position[2] = base->r[2];
    tip->omega[0] = omega_R_x;
    tip->omega[1] = omega_y;
    tip->omega[2] = omega_R_z;
    tip->v[0] = v_R_x;
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
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

/* joint rows, links like shoulder: 239 operations */
static six_link_status joint_rows_shoulder(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base, six_link_node *tip,
    const six_link_real twist[6], const six_link_real q[1], const six_link_real quaternion[4],
    const six_link_real gravity[3], const six_link_real tau[1], const int *place, six_link_real *M,
    six_link_real H[12], six_link_real W[12])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real minus_R_rel_xy = six_link_sin(q[0]);
    const six_link_real t1 = -minus_R_rel_xy;

    const six_link_real omega_R_x = R_rel_xx * base->omega[0] + minus_R_rel_xy * base->omega[1];
    const six_link_real omega_R_y = R_rel_xx * base->omega[1] - minus_R_rel_xy * base->omega[0];
    const six_link_real qdot_1 = twist[2] - base->omega[2];

    /* v_R: velocity of the joint point */
    const six_link_real t2 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t3 = base->v[1] + c->mount_xyz_x * base->omega[2] - c->mount_xyz_z * base->omega[0];
    const six_link_real v_R_x = R_rel_xx * t2 + minus_R_rel_xy * t3;
    const six_link_real v_R_y = R_rel_xx * t3 - minus_R_rel_xy * t2;

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_omega_x = omega_R_y * qdot_1;
    const six_link_real minus_beta_omega_y = omega_R_x * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_v_x = qdot_1 * v_R_y;
    const six_link_real minus_beta_v_y = qdot_1 * v_R_x;

    const six_link_real t4 = quaternion[1] * quaternion[1];
    const six_link_real t5 = quaternion[2] * quaternion[2];
    const six_link_real t6 = quaternion[3] * quaternion[3];
    const six_link_real t7 = 2 / (quaternion[0] * quaternion[0] + t4 + t5 + t6);
    const six_link_real t8 = t4 + t5 + t6;
    const six_link_real t9 = quaternion[1] * quaternion[2];
    const six_link_real t10 = quaternion[1] * quaternion[3];
    const six_link_real t11 = quaternion[2] * quaternion[3];
    const six_link_real t12 = quaternion[0] * quaternion[3];
    const six_link_real t13 = quaternion[0] * quaternion[2];
    const six_link_real t14 = quaternion[0] * quaternion[1];
    const six_link_real t15 = (1 + t7 * (t4 - t8)) * gravity[0] + t7 * (t12 + t9) * gravity[1]
        + t7 * (t10 - t13) * gravity[2];
    const six_link_real t16 = t7 * (t9 - t12) * gravity[0] + (1 + t7 * (t5 - t8)) * gravity[1]
        + t7 * (t14 + t11) * gravity[2];
    const six_link_real t17 = t7 * (t13 + t10) * gravity[0] + t7 * (t11 - t14) * gravity[1]
        + (1 + t7 * (t6 - t8)) * gravity[2];

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t15 - twist[2] * twist[4];
    const six_link_real t18 = twist[2] * twist[3] - t16;
    const six_link_real a_0_y = t18 - twist[0] * twist[5];
    const six_link_real t19 = twist[1] * twist[3];
    const six_link_real a_0_z = twist[0] * twist[4] - t17 - t19;

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t20 = c->I_s * twist[0];
    const six_link_real H_star_2 = t20 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_3 = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t20 * twist[1];
    const six_link_real H_star_4 = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_6 = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_x = twist[1] * v_T_z - t15 - twist[2] * v_T_y;
    const six_link_real a_T_y = t18 - twist[0] * v_T_z;
    const six_link_real a_T_z = twist[0] * v_T_y - t17 - t19;

    /* h_T_tau: moment that the bodies' velocities and weight need */
    const six_link_real t21 = c->I_T_zz * twist[2] - c->J_T_xz * twist[0] - c->J_T_yz * twist[1];
    const six_link_real t22 = c->I_T_yy * twist[1] - c->J_T_xy * twist[0] - c->J_T_yz * twist[2];
    const six_link_real h_T_tau_x = c->S_T_y * a_T_z + twist[1] * t21 - c->S_T_z * a_T_y - twist[2] * t22;
    const six_link_real t23 = c->I_T_xx * twist[0] - c->J_T_xy * twist[1] - c->J_T_xz * twist[2];
    const six_link_real h_T_tau_y = c->S_T_z * a_T_x + twist[2] * t23 - c->S_T_x * a_T_z - twist[0] * t21;
    const six_link_real h_T_tau_z = c->S_T_x * a_T_y + twist[0] * t22 - c->S_T_y * a_T_x - twist[1] * t23;

    /* h_T_F: force that the bodies' velocities and weight need */
    const six_link_real t24 = c->S_T_y * twist[0] - c->S_T_x * twist[1];
    const six_link_real t25 = c->S_T_x * twist[2] - c->S_T_z * twist[0];
    const six_link_real h_T_F_x = a_T_x * c->body0_mass + twist[1] * t24 - twist[2] * t25;
    const six_link_real t26 = c->S_T_z * twist[1] - c->S_T_y * twist[2];
    const six_link_real h_T_F_y = a_T_y * c->body0_mass + twist[2] * t26 - twist[0] * t24;
    const six_link_real h_T_F_z = a_T_z * c->body0_mass + twist[0] * t25 - twist[1] * t26;

    /* X: twist of the joint point in F_i axes from the parent's tip twist (49) */
    const six_link_real minus_X_41 = minus_R_rel_xy * c->mount_xyz_z;
    const six_link_real t27 = -minus_X_41;
    const six_link_real X_42 = R_rel_xx * c->mount_xyz_z;
    const six_link_real X_43 = minus_R_rel_xy * c->mount_xyz_x - R_rel_xx * c->mount_xyz_y;
    const six_link_real t28 = -X_42;
    const six_link_real X_53 = R_rel_xx * c->mount_xyz_x + minus_R_rel_xy * c->mount_xyz_y;
    const six_link_real t29 = -c->mount_xyz_x;

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_33 = 1 + c->armature_1 - 1;

    /* joint_H: what the velocities, springs and dampers leave in the joint's rows (61) */
    const six_link_real minus_joint_H_1 = R_rel_xx * base->b[0] + minus_R_rel_xy * base->b[1] + beta_omega_x;
    const six_link_real t30 = -minus_joint_H_1;
    const six_link_real joint_H_2 = minus_R_rel_xy * base->b[0] - R_rel_xx * base->b[1] + minus_beta_omega_y;
    const six_link_real joint_H_3 = c->joint_damping_1 * qdot_1 - P_c_33 * base->b[2];
    const six_link_real t31 = minus_X_41 * base->b[0]
        - (beta_v_x + R_rel_xx * base->b[3] + minus_R_rel_xy * base->b[4]) - X_42 * base->b[1];
    const six_link_real joint_H_4 = t31 - X_43 * base->b[2];
    const six_link_real t32 = minus_beta_v_y + minus_R_rel_xy * base->b[3] - R_rel_xx * base->b[4]
        + X_42 * base->b[0] + minus_X_41 * base->b[1];
    const six_link_real joint_H_5 = t32 - X_53 * base->b[2];
    const six_link_real joint_H_6 = c->mount_xyz_x * base->b[1] - (base->b[5] + c->mount_xyz_y * base->b[0]);

    /* outputs */
    link->h_V[0] = H_star_2;
    link->h_V[1] = H_star_3;
    link->h_V[2] = H_star_4;
    link->h_V[3] = H_star_5;
    link->h_V[4] = H_star_6;
    tip->omega[0] = twist[0];
    tip->omega[1] = twist[1];
    tip->omega[2] = twist[2];
    tip->v[0] = twist[3];
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
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
    H[0] = t30;
    H[1] = joint_H_2;
    H[2] = joint_H_3;
    H[3] = joint_H_4;
    H[4] = joint_H_5;
    H[5] = joint_H_6;
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
    base->X[18] = t27;
    base->X[19] = X_42;
    base->X[20] = X_43;
    base->X[21] = R_rel_xx;
    base->X[22] = minus_R_rel_xy;
    base->X[23] = 0;
    base->X[24] = t28;
    base->X[25] = t27;
    base->X[26] = X_53;
    base->X[27] = t1;
    base->X[28] = R_rel_xx;
    base->X[29] = 0;
    base->X[30] = c->mount_xyz_y;
    base->X[31] = t29;
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
    base->PX[14] = P_c_33;
    base->PX[15] = 0;
    base->PX[16] = 0;
    base->PX[17] = 0;
    base->PX[18] = t27;
    base->PX[19] = X_42;
    base->PX[20] = X_43;
    base->PX[21] = R_rel_xx;
    base->PX[22] = minus_R_rel_xy;
    base->PX[23] = 0;
    base->PX[24] = t28;
    base->PX[25] = t27;
    base->PX[26] = X_53;
    base->PX[27] = t1;
    base->PX[28] = R_rel_xx;
    base->PX[29] = 0;
    base->PX[30] = c->mount_xyz_y;
    base->PX[31] = t29;
    base->PX[32] = 0;
    base->PX[33] = 0;
    base->PX[34] = 0;
    base->PX[35] = 1;
    tip->b[0] = 0;
    tip->b[1] = 0;
    tip->b[2] = 0;
    tip->b[3] = 0;
    tip->b[4] = 0;
    tip->b[5] = 0;
    return SIX_LINK_OK;
}

/* joint rows, links like upper_arm: 625 operations */
static six_link_status joint_rows_upper_arm(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base, six_link_node *tip,
    const six_link_real twist[6], const six_link_real q[1], const six_link_real quaternion[4],
    const six_link_real gravity[3], const six_link_real eta[3], const six_link_real etadot[3],
    const six_link_real tau[1], const int *place, six_link_real *M, six_link_real H[12],
    six_link_real W[12])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real R_rel_xz = six_link_sin(q[0]);
    const six_link_real t1 = -R_rel_xz;

    const six_link_real omega_R_x = R_rel_xx * base->omega[0] - R_rel_xz * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_xx * base->omega[2];
    const six_link_real qdot_1 = twist[1] - base->omega[1];

    /* v_R: velocity of the joint point */
    const six_link_real t2 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t3 = base->v[2] + c->mount_xyz_y * base->omega[0] - c->mount_xyz_x * base->omega[1];
    const six_link_real v_R_x = R_rel_xx * t2 - R_rel_xz * t3;
    const six_link_real v_R_z = R_rel_xz * t2 + R_rel_xx * t3;

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_omega_x = omega_R_z * qdot_1;
    const six_link_real beta_omega_z = omega_R_x * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_v_x = qdot_1 * v_R_z;
    const six_link_real beta_v_z = qdot_1 * v_R_x;

    const six_link_real t4 = quaternion[1] * quaternion[1];
    const six_link_real t5 = quaternion[2] * quaternion[2];
    const six_link_real t6 = quaternion[3] * quaternion[3];
    const six_link_real t7 = 2 / (quaternion[0] * quaternion[0] + t4 + t5 + t6);
    const six_link_real t8 = t4 + t5 + t6;
    const six_link_real t9 = quaternion[1] * quaternion[2];
    const six_link_real t10 = quaternion[1] * quaternion[3];
    const six_link_real t11 = quaternion[2] * quaternion[3];
    const six_link_real t12 = quaternion[0] * quaternion[3];
    const six_link_real t13 = quaternion[0] * quaternion[2];
    const six_link_real t14 = quaternion[0] * quaternion[1];
    const six_link_real t15 = (1 + t7 * (t4 - t8)) * gravity[0] + t7 * (t12 + t9) * gravity[1]
        + t7 * (t10 - t13) * gravity[2];
    const six_link_real t16 = t7 * (t9 - t12) * gravity[0] + (1 + t7 * (t5 - t8)) * gravity[1]
        + t7 * (t14 + t11) * gravity[2];
    const six_link_real t17 = t7 * (t13 + t10) * gravity[0] + t7 * (t11 - t14) * gravity[1]
        + (1 + t7 * (t6 - t8)) * gravity[2];

    /* S: first moment */
    const six_link_real S_y = eta[0] * c->sigma_y1;
    const six_link_real S_z = eta[1] * c->sigma_z2;

    /* Sdot: rate of the first moment */
    const six_link_real Sdot_y = etadot[0] * c->sigma_y1;
    const six_link_real Sdot_z = etadot[1] * c->sigma_z2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->M_Wphi_11 * eta[0];
    const six_link_real L_y2 = eta[0] * c->mu;
    const six_link_real L_z1 = eta[1] * c->mu;
    const six_link_real L_z2 = c->M_Wphi_22 * eta[1];

    /* Ldot: rate of L */
    const six_link_real Ldot_y2 = etadot[0] * c->mu;
    const six_link_real Ldot_z1 = etadot[1] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->chi_1 * eta[0];
    const six_link_real J_xz = c->chi_2 * eta[1];
    const six_link_real J_yy = L_y1 * eta[0];
    const six_link_real J_yz = L_z1 * eta[0];
    const six_link_real J_zz = L_z2 * eta[1];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t15 - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - t16 - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - t17 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real t18 = twist[1] * twist[1];
    const six_link_real t19 = twist[2] * twist[2];
    const six_link_real minus_Omega_xx = t18 + t19;
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];
    const six_link_real t20 = twist[0] * twist[0];
    const six_link_real minus_Omega_yy = t20 + t19;
    const six_link_real Omega_yz = twist[1] * twist[2];
    const six_link_real minus_Omega_zz = t20 + t18;

    /* B: moment of the elastic velocity */
    const six_link_real B_yx = c->chi_1 * etadot[0];
    const six_link_real B_yy = L_y1 * etadot[0];
    const six_link_real B_yz = L_z1 * etadot[0];
    const six_link_real B_zx = c->chi_2 * etadot[1];
    const six_link_real B_zy = L_y2 * etadot[1];
    const six_link_real B_zz = L_z2 * etadot[1];

    /* h_c: half of the Coriolis wrench */
    const six_link_real h_c_1 = B_yy * twist[0] + B_zz * twist[0];
    const six_link_real h_c_2 = B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const six_link_real h_c_3 = B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const six_link_real h_c_4 = Sdot_z * twist[1] - Sdot_y * twist[2];
    const six_link_real minus_h_c_5 = Sdot_z * twist[0];
    const six_link_real h_c_6 = Sdot_y * twist[0];

    /* h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const six_link_real h_MD_2 = h_c_2 + etadot[2] * twist[2] * c->sigma_t_3;
    const six_link_real h_MD_3 = h_c_3 - etadot[2] * twist[1] * c->sigma_t_3;

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t21 = h_c_1 + J_xy * Omega_xz + J_yy * Omega_yz
        + J_yz * (minus_Omega_yy - minus_Omega_zz) + S_y * a_0_z;
    const six_link_real H_star_1 = t21 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const six_link_real t22 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy
        + J_zz * Omega_xz + S_z * a_0_x;
    const six_link_real t23 = c->I_s * twist[0];
    const six_link_real H_star_2 = t22 + t23 * twist[2] - c->J_0_xx * Omega_xz - J_xy * Omega_yz
        - c->S_0_x * a_0_z;
    const six_link_real t24 = h_c_3 + c->J_0_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * a_0_y;
    const six_link_real H_star_3 = t24 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t23 * twist[1];
    const six_link_real H_star_4 = h_c_4 - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + a_0_x * c->mu;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x - minus_h_c_5 - minus_Omega_yy * S_y + Omega_yz * S_z
        + a_0_y * c->mu;
    const six_link_real H_star_6 = h_c_6 + Omega_xz * c->S_0_x + Omega_yz * S_y - minus_Omega_zz * S_z
        + a_0_z * c->mu;

    /* h_V: bias of the twist rows */
    const six_link_real h_V_1 = H_star_1 + h_c_1;
    const six_link_real h_V_2 = H_star_2 + h_MD_2;
    const six_link_real h_V_3 = H_star_3 + h_MD_3;
    const six_link_real h_V_4 = H_star_4 + h_c_4;
    const six_link_real h_V_5 = H_star_5 - minus_h_c_5;
    const six_link_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const six_link_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_xy * c->chi_1
        + a_0_y * c->sigma_y1 - Ldot_z1 * 2 * twist[0];
    const six_link_real h_eta_2 = L_y2 * Omega_yz - L_z2 * minus_Omega_zz + Omega_xz * c->chi_2
        + a_0_z * c->sigma_z2 + Ldot_y2 * 2 * twist[0];

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[0] * 2;
    const six_link_real r_T_z = eta[1] * 2;

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_x = eta[2] * REAL(1.4142135623730951);
    const six_link_real theta_y = c->Psi_c_y2 * eta[1];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0];

    /* x: squared angle of the tip section */
    const six_link_real t25 = theta_x * theta_x;
    const six_link_real t26 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_33 = t25 + t26;
    const six_link_real t27 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + t27;

    /* c1: Stumpff function of order 1 */
    const six_link_real t28 = six_link_c5(x);
    const six_link_real c3 = REAL(0.16666666666666666) - x * t28;
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real t29 = six_link_c4(x);
    const six_link_real c2 = REAL(0.5) - x * t29;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_11 = t26 + t27;
    const six_link_real theta_hat2_12 = theta_x * theta_y;
    const six_link_real theta_hat2_13 = theta_x * theta_z;
    const six_link_real minus_theta_hat2_22 = t25 + t27;
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real J_l_xx = 1 - c3 * minus_theta_hat2_11;
    const six_link_real t30 = c3 * theta_hat2_12;
    const six_link_real t31 = c2 * theta_z;
    const six_link_real J_l_xy = t30 - t31;
    const six_link_real t32 = c2 * theta_y;
    const six_link_real t33 = c3 * theta_hat2_13;
    const six_link_real J_l_xz = t32 + t33;
    const six_link_real J_l_yx = t31 + t30;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const six_link_real t34 = c3 * theta_hat2_23;
    const six_link_real t35 = c2 * theta_x;
    const six_link_real J_l_yz = t34 - t35;
    const six_link_real J_l_zx = t33 - t32;
    const six_link_real J_l_zy = t35 + t34;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * minus_theta_hat2_11;
    const six_link_real t36 = c2 * theta_hat2_12;
    const six_link_real t37 = c1 * theta_z;
    const six_link_real R_T_xy = t36 - t37;
    const six_link_real t38 = c1 * theta_y;
    const six_link_real t39 = c2 * theta_hat2_13;
    const six_link_real R_T_xz = t38 + t39;
    const six_link_real R_T_yx = t37 + t36;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real t40 = c2 * theta_hat2_23;
    const six_link_real t41 = c1 * theta_x;
    const six_link_real R_T_yz = t40 - t41;
    const six_link_real R_T_zx = t39 - t38;
    const six_link_real R_T_zy = t41 + t40;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[0] * 2;
    const six_link_real udot_T_z = etadot[1] * 2;

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_x = etadot[2] * REAL(1.4142135623730951);
    const six_link_real thetadot_y = c->Psi_c_y2 * etadot[1];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t42 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real t43 = theta_x * thetadot_y - theta_y * thetadot_x;
    const six_link_real t44 = theta_z * thetadot_x - theta_x * thetadot_z;
    const six_link_real t45 = theta_y * t43 - theta_z * t44;
    const six_link_real omega_s_x = thetadot_x + c2 * t42 + c3 * t45;
    const six_link_real t46 = theta_z * t42 - theta_x * t43;
    const six_link_real omega_s_y = thetadot_y + c2 * t44 + c3 * t46;
    const six_link_real t47 = theta_x * t44 - theta_y * t42;
    const six_link_real omega_s_z = thetadot_z + c2 * t43 + c3 * t47;

    /* xdot: rate of the squared angle */
    const six_link_real xdot = eta[2] * REAL(2.8284271247461903) * thetadot_x + theta_y * 2 * thetadot_y
        + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const six_link_real c2dot = xdot * (t29 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const six_link_real c3dot = xdot * (t28 * REAL(1.5) - t29 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_x = c2dot * t42 + c3 * (thetadot_y * t43 - thetadot_z * t44) + c3dot * t45;
    const six_link_real alpha_s_y = c2dot * t44 + c3 * (thetadot_z * t42 - thetadot_x * t43) + c3dot * t46;
    const six_link_real alpha_s_z = c2dot * t43 + c3 * (thetadot_x * t44 - thetadot_y * t42) + c3dot * t47;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t48 = omega_s_x + twist[0];
    const six_link_real t49 = omega_s_y + twist[1];
    const six_link_real t50 = omega_s_z + twist[2];
    const six_link_real omega_T_x = R_T_xx * t48 + R_T_yx * t49 + R_T_zx * t50;
    const six_link_real omega_T_y = R_T_xy * t48 + R_T_yy * t49 + R_T_zy * t50;
    const six_link_real omega_T_z = R_T_xz * t48 + R_T_yz * t49 + R_T_zz * t50;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t51 = twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const six_link_real t52 = udot_T_y + twist[4] + c->length * twist[2] - twist[0] * r_T_z;
    const six_link_real t53 = udot_T_z + twist[5] + twist[0] * r_T_y - c->length * twist[1];
    const six_link_real v_T_x = R_T_xx * t51 + R_T_yx * t52 + R_T_zx * t53;
    const six_link_real v_T_y = R_T_xy * t51 + R_T_yy * t52 + R_T_zy * t53;
    const six_link_real v_T_z = R_T_xz * t51 + R_T_yz * t52 + R_T_zz * t53;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const six_link_real t54 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const six_link_real t55 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const six_link_real t56 = alpha_s_z + omega_s_y * twist[0] - omega_s_x * twist[1];
    const six_link_real b_omega_x = R_T_xx * t54 + R_T_yx * t55 + R_T_zx * t56;
    const six_link_real b_omega_y = R_T_xy * t54 + R_T_yy * t55 + R_T_zy * t56;
    const six_link_real b_omega_z = R_T_xz * t54 + R_T_yz * t55 + R_T_zz * t56;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const six_link_real t57 = omega_s_z * t52 + twist[1] * udot_T_z - omega_s_y * t53 - twist[2] * udot_T_y;
    const six_link_real t58 = omega_s_x * t53 - omega_s_z * t51 - twist[0] * udot_T_z;
    const six_link_real t59 = omega_s_y * t51 + twist[0] * udot_T_y - omega_s_x * t52;
    const six_link_real b_v_x = R_T_xx * t57 + R_T_yx * t58 + R_T_zx * t59;
    const six_link_real b_v_y = R_T_xy * t57 + R_T_yy * t58 + R_T_zy * t59;
    const six_link_real b_v_z = R_T_xz * t57 + R_T_yz * t58 + R_T_zz * t59;

    const six_link_real t60 = R_T_xx * t15 + R_T_yx * t16 + R_T_zx * t17;
    const six_link_real t61 = R_T_xy * t15 + R_T_yy * t16 + R_T_zy * t17;
    const six_link_real t62 = R_T_xz * t15 + R_T_yz * t16 + R_T_zz * t17;

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_x = omega_T_y * v_T_z - t60 - omega_T_z * v_T_y;
    const six_link_real a_T_y = omega_T_z * v_T_x - t61 - omega_T_x * v_T_z;
    const six_link_real a_T_z = omega_T_x * v_T_y - t62 - omega_T_y * v_T_x;

    /* h_T_tau: moment that the bodies' velocities and weight need */
    const six_link_real t63 = c->I_T_zz * omega_T_z - c->J_T_xz * omega_T_x - c->J_T_yz * omega_T_y;
    const six_link_real t64 = c->I_T_yy * omega_T_y - c->J_T_xy * omega_T_x - c->J_T_yz * omega_T_z;
    const six_link_real h_T_tau_x = c->S_T_y * a_T_z + omega_T_y * t63 - c->S_T_z * a_T_y - omega_T_z * t64;
    const six_link_real t65 = c->I_T_xx * omega_T_x - c->J_T_xy * omega_T_y - c->J_T_xz * omega_T_z;
    const six_link_real h_T_tau_y = c->S_T_z * a_T_x + omega_T_z * t65 - c->S_T_x * a_T_z - omega_T_x * t63;
    const six_link_real h_T_tau_z = c->S_T_x * a_T_y + omega_T_x * t64 - c->S_T_y * a_T_x - omega_T_y * t65;

    /* h_T_F: force that the bodies' velocities and weight need */
    const six_link_real t66 = c->S_T_y * omega_T_x - c->S_T_x * omega_T_y;
    const six_link_real t67 = c->S_T_x * omega_T_z - c->S_T_z * omega_T_x;
    const six_link_real h_T_F_x = a_T_x * c->body0_mass + omega_T_y * t66 - omega_T_z * t67;
    const six_link_real t68 = c->S_T_z * omega_T_y - c->S_T_y * omega_T_z;
    const six_link_real h_T_F_y = a_T_y * c->body0_mass + omega_T_z * t68 - omega_T_x * t66;
    const six_link_real h_T_F_z = a_T_z * c->body0_mass + omega_T_x * t67 - omega_T_y * t68;

    /* X: twist of the joint point in F_i axes from the parent's tip twist (49) */
    const six_link_real minus_X_41 = R_rel_xz * c->mount_xyz_y;
    const six_link_real t69 = -minus_X_41;
    const six_link_real X_42 = R_rel_xx * c->mount_xyz_z + R_rel_xz * c->mount_xyz_x;
    const six_link_real minus_X_43 = R_rel_xx * c->mount_xyz_y;
    const six_link_real t70 = -minus_X_43;
    const six_link_real t71 = -c->mount_xyz_z;
    const six_link_real X_62 = R_rel_xz * c->mount_xyz_z - R_rel_xx * c->mount_xyz_x;

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_22 = 1 + c->armature_1 - 1;

    /* joint_H: what the velocities, springs and dampers leave in the joint's rows (61) */
    const six_link_real joint_H_1 = R_rel_xz * base->b[2] - R_rel_xx * base->b[0] + minus_beta_omega_x;
    const six_link_real joint_H_2 = c->joint_damping_1 * qdot_1 - P_c_22 * base->b[1];
    const six_link_real minus_joint_H_3 = R_rel_xz * base->b[0] + R_rel_xx * base->b[2] + beta_omega_z;
    const six_link_real t72 = -minus_joint_H_3;
    const six_link_real t73 = minus_beta_v_x - R_rel_xx * base->b[3] + R_rel_xz * base->b[5]
        + minus_X_41 * base->b[0] - X_42 * base->b[1];
    const six_link_real joint_H_4 = t73 + minus_X_43 * base->b[2];
    const six_link_real joint_H_5 = c->mount_xyz_z * base->b[0] - base->b[4] - c->mount_xyz_x * base->b[2];
    const six_link_real t74 = beta_v_z + R_rel_xz * base->b[3] + R_rel_xx * base->b[5] + minus_X_43 * base->b[0]
        + X_62 * base->b[1];
    const six_link_real joint_H_6 = minus_X_41 * base->b[2] - t74;

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
    link->M_D[1] = L_y2;
    link->h_V[0] = h_V_1;
    link->h_V[1] = h_V_2;
    link->h_V[2] = h_V_3;
    link->h_V[3] = h_V_4;
    link->h_V[4] = h_V_5;
    link->h_V[5] = h_V_6;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
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
    link->G[0] = J_l_xx;
    link->G[1] = J_l_xy;
    link->G[2] = J_l_xz;
    link->G[3] = J_l_yx;
    link->G[4] = J_l_yy;
    link->G[5] = J_l_yz;
    link->G[6] = J_l_zx;
    link->G[7] = J_l_zy;
    link->G[8] = J_l_zz;
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
    H[0] = joint_H_1;
    H[1] = joint_H_2;
    H[2] = t72;
    H[3] = joint_H_4;
    H[4] = joint_H_5;
    H[5] = joint_H_6;
    W[0] = 0;
    W[1] = tau[0];
    W[2] = 0;
    W[3] = 0;
    W[4] = 0;
    W[5] = 0;
    base->X[0] = R_rel_xx;
    base->X[1] = 0;
    base->X[2] = t1;
    base->X[3] = 0;
    base->X[4] = 0;
    base->X[5] = 0;
    base->X[6] = 0;
    base->X[7] = 1;
    base->X[8] = 0;
    base->X[9] = 0;
    base->X[10] = 0;
    base->X[11] = 0;
    base->X[12] = R_rel_xz;
    base->X[13] = 0;
    base->X[14] = R_rel_xx;
    base->X[15] = 0;
    base->X[16] = 0;
    base->X[17] = 0;
    base->X[18] = t69;
    base->X[19] = X_42;
    base->X[20] = t70;
    base->X[21] = R_rel_xx;
    base->X[22] = 0;
    base->X[23] = t1;
    base->X[24] = t71;
    base->X[25] = 0;
    base->X[26] = c->mount_xyz_x;
    base->X[27] = 0;
    base->X[28] = 1;
    base->X[29] = 0;
    base->X[30] = minus_X_43;
    base->X[31] = X_62;
    base->X[32] = t69;
    base->X[33] = R_rel_xz;
    base->X[34] = 0;
    base->X[35] = R_rel_xx;
    base->PX[0] = R_rel_xx;
    base->PX[1] = 0;
    base->PX[2] = t1;
    base->PX[3] = 0;
    base->PX[4] = 0;
    base->PX[5] = 0;
    base->PX[6] = 0;
    base->PX[7] = P_c_22;
    base->PX[8] = 0;
    base->PX[9] = 0;
    base->PX[10] = 0;
    base->PX[11] = 0;
    base->PX[12] = R_rel_xz;
    base->PX[13] = 0;
    base->PX[14] = R_rel_xx;
    base->PX[15] = 0;
    base->PX[16] = 0;
    base->PX[17] = 0;
    base->PX[18] = t69;
    base->PX[19] = X_42;
    base->PX[20] = t70;
    base->PX[21] = R_rel_xx;
    base->PX[22] = 0;
    base->PX[23] = t1;
    base->PX[24] = t71;
    base->PX[25] = 0;
    base->PX[26] = c->mount_xyz_x;
    base->PX[27] = 0;
    base->PX[28] = 1;
    base->PX[29] = 0;
    base->PX[30] = minus_X_43;
    base->PX[31] = X_62;
    base->PX[32] = t69;
    base->PX[33] = R_rel_xz;
    base->PX[34] = 0;
    base->PX[35] = R_rel_xx;
    tip->b[0] = b_omega_x;
    tip->b[1] = b_omega_y;
    tip->b[2] = b_omega_z;
    tip->b[3] = b_v_x;
    tip->b[4] = b_v_y;
    tip->b[5] = b_v_z;
    return SIX_LINK_OK;
}

/* joint rows, links like forearm: 549 operations */
static six_link_status joint_rows_forearm(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base, six_link_node *tip,
    const six_link_real twist[6], const six_link_real q[1], const six_link_real quaternion[4],
    const six_link_real gravity[3], const six_link_real eta[2], const six_link_real etadot[2],
    const six_link_real tau[1], const int *place, six_link_real *M, six_link_real H[12],
    six_link_real W[12])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real t1 = six_link_cos(q[0]);
    const six_link_real t2 = six_link_sin(q[0]);
    const six_link_real R_rel_xx = c->R_m_xx * t1 - c->R_m_xz * t2;
    const six_link_real R_rel_xz = c->R_m_xx * t2 + c->R_m_xz * t1;
    const six_link_real R_rel_yx = c->R_m_yx * t1 - c->R_m_yz * t2;
    const six_link_real R_rel_yz = c->R_m_yx * t2 + c->R_m_yz * t1;
    const six_link_real R_rel_zx = c->R_m_zx * t1 - c->R_m_zz * t2;
    const six_link_real R_rel_zz = c->R_m_zx * t2 + c->R_m_zz * t1;

    const six_link_real omega_R_x = R_rel_xx * base->omega[0] + R_rel_yx * base->omega[1]
        + R_rel_zx * base->omega[2];
    const six_link_real omega_R_y = c->R_m_xy * base->omega[0] + c->R_m_yy * base->omega[1]
        + c->R_m_zy * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_yz * base->omega[1]
        + R_rel_zz * base->omega[2];
    const six_link_real qdot_1 = twist[1] - omega_R_y;

    /* v_R: velocity of the joint point */
    const six_link_real t3 = base->v[0] + c->mount_xyz_z * base->omega[1] - c->mount_xyz_y * base->omega[2];
    const six_link_real t4 = base->v[1] + c->mount_xyz_x * base->omega[2] - c->mount_xyz_z * base->omega[0];
    const six_link_real t5 = base->v[2] + c->mount_xyz_y * base->omega[0] - c->mount_xyz_x * base->omega[1];
    const six_link_real v_R_x = R_rel_xx * t3 + R_rel_yx * t4 + R_rel_zx * t5;
    const six_link_real v_R_z = R_rel_xz * t3 + R_rel_yz * t4 + R_rel_zz * t5;

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_omega_x = omega_R_z * qdot_1;
    const six_link_real beta_omega_z = omega_R_x * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_v_x = qdot_1 * v_R_z;
    const six_link_real beta_v_z = qdot_1 * v_R_x;

    const six_link_real t6 = quaternion[1] * quaternion[1];
    const six_link_real t7 = quaternion[2] * quaternion[2];
    const six_link_real t8 = quaternion[3] * quaternion[3];
    const six_link_real t9 = 2 / (quaternion[0] * quaternion[0] + t6 + t7 + t8);
    const six_link_real t10 = t6 + t7 + t8;
    const six_link_real t11 = quaternion[1] * quaternion[2];
    const six_link_real t12 = quaternion[1] * quaternion[3];
    const six_link_real t13 = quaternion[2] * quaternion[3];
    const six_link_real t14 = quaternion[0] * quaternion[3];
    const six_link_real t15 = quaternion[0] * quaternion[2];
    const six_link_real t16 = quaternion[0] * quaternion[1];
    const six_link_real t17 = (1 + t9 * (t6 - t10)) * gravity[0] + t9 * (t14 + t11) * gravity[1]
        + t9 * (t12 - t15) * gravity[2];
    const six_link_real t18 = t9 * (t11 - t14) * gravity[0] + (1 + t9 * (t7 - t10)) * gravity[1]
        + t9 * (t16 + t13) * gravity[2];
    const six_link_real t19 = t9 * (t15 + t12) * gravity[0] + t9 * (t13 - t16) * gravity[1]
        + (1 + t9 * (t8 - t10)) * gravity[2];

    /* S: first moment */
    const six_link_real S_y = c->S_B_y + eta[0] * c->sigma_y1;
    const six_link_real S_z = c->S_B_z + eta[1] * c->sigma_z2;

    /* Sdot: rate of the first moment */
    const six_link_real Sdot_y = etadot[0] * c->sigma_y1;
    const six_link_real Sdot_z = etadot[1] * c->sigma_z2;

    /* L: first moment weighted by each mode shape (85) */
    const six_link_real L_y1 = c->M_Wphi_11 * eta[0];
    const six_link_real L_y2 = eta[0] * c->mu;
    const six_link_real L_z1 = eta[1] * c->mu;
    const six_link_real L_z2 = c->M_Wphi_22 * eta[1];

    /* Ldot: rate of L */
    const six_link_real Ldot_y2 = etadot[0] * c->mu;
    const six_link_real Ldot_z1 = etadot[1] * c->mu;

    /* J: second moment */
    const six_link_real J_xy = c->J_B_xy + c->chi_1 * eta[0];
    const six_link_real J_xz = c->J_B_xz + c->chi_2 * eta[1];
    const six_link_real J_yy = c->J_B_yy + L_y1 * eta[0];
    const six_link_real J_yz = c->J_B_yz + L_z1 * eta[0];
    const six_link_real J_zz = c->J_B_zz + L_z2 * eta[1];

    /* I: inertia about the origin, deformed */
    const six_link_real I_xx = c->I_s + J_yy + J_zz;
    const six_link_real I_yy = c->J_0_xx + J_zz;
    const six_link_real I_zz = c->J_0_xx + J_yy;

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t17 - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - t18 - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - t19 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real t20 = twist[1] * twist[1];
    const six_link_real t21 = twist[2] * twist[2];
    const six_link_real minus_Omega_xx = t20 + t21;
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];
    const six_link_real t22 = twist[0] * twist[0];
    const six_link_real minus_Omega_yy = t22 + t21;
    const six_link_real Omega_yz = twist[1] * twist[2];
    const six_link_real minus_Omega_zz = t22 + t20;

    /* B: moment of the elastic velocity */
    const six_link_real B_yx = c->chi_1 * etadot[0];
    const six_link_real B_yy = L_y1 * etadot[0];
    const six_link_real B_yz = L_z1 * etadot[0];
    const six_link_real B_zx = c->chi_2 * etadot[1];
    const six_link_real B_zy = L_y2 * etadot[1];
    const six_link_real B_zz = L_z2 * etadot[1];

    /* h_c: half of the Coriolis wrench */
    const six_link_real h_c_1 = B_yy * twist[0] + B_zz * twist[0];
    const six_link_real h_c_2 = B_zz * twist[1] - B_yx * twist[0] - B_yz * twist[2];
    const six_link_real h_c_3 = B_yy * twist[2] - B_zx * twist[0] - B_zy * twist[1];
    const six_link_real h_c_4 = Sdot_z * twist[1] - Sdot_y * twist[2];
    const six_link_real minus_h_c_5 = Sdot_z * twist[0];
    const six_link_real h_c_6 = Sdot_y * twist[0];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t23 = h_c_1 + J_xy * Omega_xz + J_yy * Omega_yz
        + J_yz * (minus_Omega_yy - minus_Omega_zz) + S_y * a_0_z;
    const six_link_real H_star_1 = t23 - J_xz * Omega_xy - J_zz * Omega_yz - S_z * a_0_y;
    const six_link_real t24 = h_c_2 + J_xz * (minus_Omega_zz - minus_Omega_xx) + J_yz * Omega_xy
        + J_zz * Omega_xz + S_z * a_0_x;
    const six_link_real t25 = c->I_s * twist[0];
    const six_link_real H_star_2 = t24 + t25 * twist[2] - c->J_0_xx * Omega_xz - J_xy * Omega_yz
        - c->S_0_x * a_0_z;
    const six_link_real t26 = h_c_3 + c->J_0_xx * Omega_xy + J_xy * (minus_Omega_xx - minus_Omega_yy)
        + J_xz * Omega_yz + c->S_0_x * a_0_y;
    const six_link_real H_star_3 = t26 - J_yy * Omega_xy - J_yz * Omega_xz - S_y * a_0_x - t25 * twist[1];
    const six_link_real H_star_4 = h_c_4 - minus_Omega_xx * c->S_0_x + Omega_xy * S_y + Omega_xz * S_z
        + a_0_x * c->m;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x - minus_h_c_5 - minus_Omega_yy * S_y + Omega_yz * S_z
        + a_0_y * c->m;
    const six_link_real H_star_6 = h_c_6 + Omega_xz * c->S_0_x + Omega_yz * S_y - minus_Omega_zz * S_z
        + a_0_z * c->m;

    /* h_V: bias of the twist rows */
    const six_link_real h_V_1 = H_star_1 + h_c_1;
    const six_link_real h_V_2 = H_star_2 + h_c_2;
    const six_link_real h_V_3 = H_star_3 + h_c_3;
    const six_link_real h_V_4 = H_star_4 + h_c_4;
    const six_link_real h_V_5 = H_star_5 - minus_h_c_5;
    const six_link_real h_V_6 = H_star_6 + h_c_6;

    /* h_eta: gyroscopic force and weight on the modes (88) */
    const six_link_real h_eta_1 = L_z1 * Omega_yz - L_y1 * minus_Omega_yy + Omega_xy * c->chi_1
        + a_0_y * c->sigma_y1 - Ldot_z1 * 2 * twist[0];
    const six_link_real h_eta_2 = L_y2 * Omega_yz - L_z2 * minus_Omega_zz + Omega_xz * c->chi_2
        + a_0_z * c->sigma_z2 + Ldot_y2 * 2 * twist[0];

    /* r_T: tip point (11) */
    const six_link_real r_T_y = eta[0] * REAL(2.23606797749979);
    const six_link_real r_T_z = eta[1] * REAL(2.23606797749979);

    /* theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_y = c->Psi_c_y2 * eta[1];
    const six_link_real theta_z = c->Psi_c_z1 * eta[0];

    /* x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_33 = theta_y * theta_y;
    const six_link_real minus_theta_hat2_22 = theta_z * theta_z;
    const six_link_real x = minus_theta_hat2_33 + minus_theta_hat2_22;

    /* c1: Stumpff function of order 1 */
    const six_link_real t27 = six_link_c5(x);
    const six_link_real c3 = REAL(0.16666666666666666) - x * t27;
    const six_link_real c1 = 1 - x * c3;

    /* c2: Stumpff function of order 2 */
    const six_link_real t28 = six_link_c4(x);
    const six_link_real c2 = REAL(0.5) - x * t28;

    /* theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_23 = theta_y * theta_z;

    /* J_l: left Jacobian of the exponential */
    const six_link_real minus_J_l_xy = c2 * theta_z;
    const six_link_real J_l_xz = c2 * theta_y;
    const six_link_real J_l_yy = 1 - c3 * minus_theta_hat2_22;
    const six_link_real J_l_yz = c3 * theta_hat2_23;
    const six_link_real J_l_zz = 1 - c3 * minus_theta_hat2_33;

    /* R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_xx = 1 - c2 * x;
    const six_link_real minus_R_T_xy = c1 * theta_z;
    const six_link_real R_T_xz = c1 * theta_y;
    const six_link_real R_T_yy = 1 - c2 * minus_theta_hat2_22;
    const six_link_real R_T_yz = c2 * theta_hat2_23;
    const six_link_real R_T_zz = 1 - c2 * minus_theta_hat2_33;

    /* udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_y = etadot[0] * REAL(2.23606797749979);
    const six_link_real udot_T_z = etadot[1] * REAL(2.23606797749979);

    /* thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_y = c->Psi_c_y2 * etadot[1];
    const six_link_real thetadot_z = c->Psi_c_z1 * etadot[0];

    /* omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t29 = theta_y * thetadot_z - theta_z * thetadot_y;
    const six_link_real omega_s_x = c2 * t29;
    const six_link_real omega_s_y = thetadot_y + c3 * theta_z * t29;
    const six_link_real omega_s_z = thetadot_z - c3 * theta_y * t29;

    /* xdot: rate of the squared angle */
    const six_link_real xdot = theta_y * 2 * thetadot_y + theta_z * 2 * thetadot_z;

    /* c2dot: rate of c2 */
    const six_link_real c2dot = xdot * (t28 - c3 * REAL(0.5));

    /* c3dot: rate of c3 */
    const six_link_real c3dot = xdot * (t27 * REAL(1.5) - t28 * REAL(0.5));

    /* alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_x = c2dot * t29;
    const six_link_real alpha_s_y = c3 * thetadot_z * t29 + c3dot * theta_z * t29;
    const six_link_real minus_alpha_s_z = c3 * thetadot_y * t29 + c3dot * theta_y * t29;

    /* omega_T: angular velocity of the tip section (46) */
    const six_link_real t30 = omega_s_x + twist[0];
    const six_link_real t31 = omega_s_y + twist[1];
    const six_link_real t32 = omega_s_z + twist[2];
    const six_link_real omega_T_x = R_T_xx * t30 + minus_R_T_xy * t31 - R_T_xz * t32;
    const six_link_real omega_T_y = R_T_yy * t31 - minus_R_T_xy * t30 + R_T_yz * t32;
    const six_link_real omega_T_z = R_T_xz * t30 + R_T_yz * t31 + R_T_zz * t32;

    /* v_T: velocity of the tip point (46) */
    const six_link_real t33 = twist[3] + twist[1] * r_T_z - twist[2] * r_T_y;
    const six_link_real t34 = udot_T_y + twist[4] + c->length * twist[2] - twist[0] * r_T_z;
    const six_link_real t35 = udot_T_z + twist[5] + twist[0] * r_T_y - c->length * twist[1];
    const six_link_real v_T_x = R_T_xx * t33 + minus_R_T_xy * t34 - R_T_xz * t35;
    const six_link_real v_T_y = R_T_yy * t34 - minus_R_T_xy * t33 + R_T_yz * t35;
    const six_link_real v_T_z = R_T_xz * t33 + R_T_yz * t34 + R_T_zz * t35;

    /* b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const six_link_real t36 = alpha_s_x + omega_s_z * twist[1] - omega_s_y * twist[2];
    const six_link_real t37 = alpha_s_y + omega_s_x * twist[2] - omega_s_z * twist[0];
    const six_link_real t38 = omega_s_y * twist[0] - minus_alpha_s_z - omega_s_x * twist[1];
    const six_link_real b_omega_x = R_T_xx * t36 + minus_R_T_xy * t37 - R_T_xz * t38;
    const six_link_real b_omega_y = R_T_yy * t37 - minus_R_T_xy * t36 + R_T_yz * t38;
    const six_link_real b_omega_z = R_T_xz * t36 + R_T_yz * t37 + R_T_zz * t38;

    /* b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const six_link_real t39 = omega_s_z * t34 + twist[1] * udot_T_z - omega_s_y * t35 - twist[2] * udot_T_y;
    const six_link_real t40 = omega_s_x * t35 - omega_s_z * t33 - twist[0] * udot_T_z;
    const six_link_real t41 = omega_s_y * t33 + twist[0] * udot_T_y - omega_s_x * t34;
    const six_link_real b_v_x = R_T_xx * t39 + minus_R_T_xy * t40 - R_T_xz * t41;
    const six_link_real b_v_y = R_T_yy * t40 - minus_R_T_xy * t39 + R_T_yz * t41;
    const six_link_real b_v_z = R_T_xz * t39 + R_T_yz * t40 + R_T_zz * t41;

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

    /* joint_H: what the velocities, springs and dampers leave in the joint's rows (61) */
    const six_link_real joint_H_1 = minus_beta_omega_x
        - (R_rel_xx * base->b[0] + R_rel_yx * base->b[1] + R_rel_zx * base->b[2]);
    const six_link_real joint_H_2 = c->joint_damping_1 * qdot_1 - PX_21 * base->b[0] - PX_22 * base->b[1]
        - PX_23 * base->b[2];
    const six_link_real minus_joint_H_3 = R_rel_xz * base->b[0] + R_rel_yz * base->b[1] + R_rel_zz * base->b[2]
        + beta_omega_z;
    const six_link_real t42 = -minus_joint_H_3;
    const six_link_real t43 = minus_beta_v_x - R_rel_xx * base->b[3] - R_rel_yx * base->b[4]
        - R_rel_zx * base->b[5] - X_41 * base->b[0];
    const six_link_real joint_H_4 = t43 - X_42 * base->b[1] - X_43 * base->b[2];
    const six_link_real t44 = c->R_m_xy * base->b[3] + c->R_m_yy * base->b[4] + c->R_m_zy * base->b[5]
        + X_51 * base->b[0] + X_52 * base->b[1];
    const six_link_real minus_joint_H_5 = t44 + X_53 * base->b[2];
    const six_link_real t45 = -minus_joint_H_5;
    const six_link_real t46 = beta_v_z + R_rel_xz * base->b[3] + R_rel_yz * base->b[4] + R_rel_zz * base->b[5]
        + X_61 * base->b[0];
    const six_link_real minus_joint_H_6 = t46 + X_62 * base->b[1] + X_63 * base->b[2];
    const six_link_real t47 = -minus_joint_H_6;

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
    link->M_D[1] = L_y2;
    link->h_V[0] = h_V_1;
    link->h_V[1] = h_V_2;
    link->h_V[2] = h_V_3;
    link->h_V[3] = h_V_4;
    link->h_V[4] = h_V_5;
    link->h_V[5] = h_V_6;
    link->h_eta[0] = h_eta_1;
    link->h_eta[1] = h_eta_2;
    link->r_T[0] = r_T_y;
    link->r_T[1] = r_T_z;
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
    M[place[0]] = 1;
    M[place[1]] = 1;
    M[place[2]] = P_c_22;
    M[place[3]] = 1;
    M[place[4]] = 1;
    M[place[5]] = 1;
    M[place[6]] = 1;
    H[0] = joint_H_1;
    H[1] = joint_H_2;
    H[2] = t42;
    H[3] = joint_H_4;
    H[4] = t45;
    H[5] = t47;
    W[0] = 0;
    W[1] = tau[0];
    W[2] = 0;
    W[3] = 0;
    W[4] = 0;
    W[5] = 0;
    base->X[0] = R_rel_xx;
    base->X[1] = R_rel_yx;
    base->X[2] = R_rel_zx;
    base->X[3] = 0;
    base->X[4] = 0;
    base->X[5] = 0;
    base->X[6] = c->R_m_xy;
    base->X[7] = c->R_m_yy;
    base->X[8] = c->R_m_zy;
    base->X[9] = 0;
    base->X[10] = 0;
    base->X[11] = 0;
    base->X[12] = R_rel_xz;
    base->X[13] = R_rel_yz;
    base->X[14] = R_rel_zz;
    base->X[15] = 0;
    base->X[16] = 0;
    base->X[17] = 0;
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
    base->PX[3] = 0;
    base->PX[4] = 0;
    base->PX[5] = 0;
    base->PX[6] = PX_21;
    base->PX[7] = PX_22;
    base->PX[8] = PX_23;
    base->PX[9] = 0;
    base->PX[10] = 0;
    base->PX[11] = 0;
    base->PX[12] = R_rel_xz;
    base->PX[13] = R_rel_yz;
    base->PX[14] = R_rel_zz;
    base->PX[15] = 0;
    base->PX[16] = 0;
    base->PX[17] = 0;
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

/* joint rows, links like wrist_roll: 137 operations */
static six_link_status joint_rows_wrist_roll(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base, six_link_node *tip,
    const six_link_real twist[6], const six_link_real q[1], const six_link_real quaternion[4],
    const six_link_real gravity[3], const six_link_real tau[1], const int *place, six_link_real *M,
    six_link_real H[12], six_link_real W[12])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_yy = six_link_cos(q[0]);
    const six_link_real minus_R_rel_yz = six_link_sin(q[0]);
    const six_link_real t1 = -minus_R_rel_yz;

    const six_link_real omega_R_y = R_rel_yy * base->omega[1] + minus_R_rel_yz * base->omega[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega[2] - minus_R_rel_yz * base->omega[1];
    const six_link_real qdot_1 = twist[0] - base->omega[0];

    /* v_R: velocity of the joint point */
    const six_link_real v_R_y = R_rel_yy * base->v[1] + minus_R_rel_yz * base->v[2];
    const six_link_real v_R_z = R_rel_yy * base->v[2] - minus_R_rel_yz * base->v[1];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_omega_y = omega_R_z * qdot_1;
    const six_link_real minus_beta_omega_z = omega_R_y * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_v_y = qdot_1 * v_R_z;
    const six_link_real minus_beta_v_z = qdot_1 * v_R_y;

    const six_link_real t2 = quaternion[1] * quaternion[1];
    const six_link_real t3 = quaternion[2] * quaternion[2];
    const six_link_real t4 = quaternion[3] * quaternion[3];
    const six_link_real t5 = 2 / (quaternion[0] * quaternion[0] + t2 + t3 + t4);
    const six_link_real t6 = t2 + t3 + t4;
    const six_link_real t7 = quaternion[1] * quaternion[2];
    const six_link_real t8 = quaternion[1] * quaternion[3];
    const six_link_real t9 = quaternion[2] * quaternion[3];
    const six_link_real t10 = quaternion[0] * quaternion[3];
    const six_link_real t11 = quaternion[0] * quaternion[2];
    const six_link_real t12 = quaternion[0] * quaternion[1];
    const six_link_real t13 = (1 + t5 * (t2 - t6)) * gravity[0] + t5 * (t10 + t7) * gravity[1]
        + t5 * (t8 - t11) * gravity[2];
    const six_link_real t14 = t5 * (t7 - t10) * gravity[0] + (1 + t5 * (t3 - t6)) * gravity[1]
        + t5 * (t12 + t9) * gravity[2];
    const six_link_real t15 = t5 * (t11 + t8) * gravity[0] + t5 * (t9 - t12) * gravity[1]
        + (1 + t5 * (t4 - t6)) * gravity[2];

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t13 - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - t14 - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - t15 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t16 = c->I_s * twist[0];
    const six_link_real H_star_2 = t16 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_3 = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t16 * twist[1];
    const six_link_real H_star_4 = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_6 = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_11 = 1 + c->armature_1 - 1;

    /* joint_H: what the velocities, springs and dampers leave in the joint's rows (61) */
    const six_link_real joint_H_1 = c->joint_damping_1 * qdot_1 - P_c_11 * base->b[0];
    const six_link_real minus_joint_H_2 = R_rel_yy * base->b[1] + minus_R_rel_yz * base->b[2] + beta_omega_y;
    const six_link_real t17 = -minus_joint_H_2;
    const six_link_real joint_H_3 = minus_R_rel_yz * base->b[1] - R_rel_yy * base->b[2] + minus_beta_omega_z;
    const six_link_real t18 = -base->b[3];
    const six_link_real minus_joint_H_5 = beta_v_y + R_rel_yy * base->b[4] + minus_R_rel_yz * base->b[5];
    const six_link_real t19 = -minus_joint_H_5;
    const six_link_real joint_H_6 = minus_beta_v_z + minus_R_rel_yz * base->b[4] - R_rel_yy * base->b[5];

    /* outputs */
    link->h_V[0] = H_star_2;
    link->h_V[1] = H_star_3;
    link->h_V[2] = H_star_4;
    link->h_V[3] = H_star_5;
    link->h_V[4] = H_star_6;
    tip->omega[0] = twist[0];
    tip->omega[1] = twist[1];
    tip->omega[2] = twist[2];
    tip->v[0] = twist[3];
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    M[place[0]] = 1;
    M[place[1]] = P_c_11;
    M[place[2]] = 1;
    M[place[3]] = 1;
    M[place[4]] = 1;
    M[place[5]] = 1;
    M[place[6]] = 1;
    H[0] = joint_H_1;
    H[1] = t17;
    H[2] = joint_H_3;
    H[3] = t18;
    H[4] = t19;
    H[5] = joint_H_6;
    W[0] = tau[0];
    W[1] = 0;
    W[2] = 0;
    W[3] = 0;
    W[4] = 0;
    W[5] = 0;
    base->X[0] = 1;
    base->X[1] = 0;
    base->X[2] = 0;
    base->X[3] = 0;
    base->X[4] = 0;
    base->X[5] = 0;
    base->X[6] = 0;
    base->X[7] = R_rel_yy;
    base->X[8] = minus_R_rel_yz;
    base->X[9] = 0;
    base->X[10] = 0;
    base->X[11] = 0;
    base->X[12] = 0;
    base->X[13] = t1;
    base->X[14] = R_rel_yy;
    base->X[15] = 0;
    base->X[16] = 0;
    base->X[17] = 0;
    base->X[18] = 0;
    base->X[19] = 0;
    base->X[20] = 0;
    base->X[21] = 1;
    base->X[22] = 0;
    base->X[23] = 0;
    base->X[24] = 0;
    base->X[25] = 0;
    base->X[26] = 0;
    base->X[27] = 0;
    base->X[28] = R_rel_yy;
    base->X[29] = minus_R_rel_yz;
    base->X[30] = 0;
    base->X[31] = 0;
    base->X[32] = 0;
    base->X[33] = 0;
    base->X[34] = t1;
    base->X[35] = R_rel_yy;
    base->PX[0] = P_c_11;
    base->PX[1] = 0;
    base->PX[2] = 0;
    base->PX[3] = 0;
    base->PX[4] = 0;
    base->PX[5] = 0;
    base->PX[6] = 0;
    base->PX[7] = R_rel_yy;
    base->PX[8] = minus_R_rel_yz;
    base->PX[9] = 0;
    base->PX[10] = 0;
    base->PX[11] = 0;
    base->PX[12] = 0;
    base->PX[13] = t1;
    base->PX[14] = R_rel_yy;
    base->PX[15] = 0;
    base->PX[16] = 0;
    base->PX[17] = 0;
    base->PX[18] = 0;
    base->PX[19] = 0;
    base->PX[20] = 0;
    base->PX[21] = 1;
    base->PX[22] = 0;
    base->PX[23] = 0;
    base->PX[24] = 0;
    base->PX[25] = 0;
    base->PX[26] = 0;
    base->PX[27] = 0;
    base->PX[28] = R_rel_yy;
    base->PX[29] = minus_R_rel_yz;
    base->PX[30] = 0;
    base->PX[31] = 0;
    base->PX[32] = 0;
    base->PX[33] = 0;
    base->PX[34] = t1;
    base->PX[35] = R_rel_yy;
    tip->b[0] = 0;
    tip->b[1] = 0;
    tip->b[2] = 0;
    tip->b[3] = 0;
    tip->b[4] = 0;
    tip->b[5] = 0;
    return SIX_LINK_OK;
}

/* joint rows, links like wrist_pitch: 137 operations */
static six_link_status joint_rows_wrist_pitch(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base, six_link_node *tip,
    const six_link_real twist[6], const six_link_real q[1], const six_link_real quaternion[4],
    const six_link_real gravity[3], const six_link_real tau[1], const int *place, six_link_real *M,
    six_link_real H[12], six_link_real W[12])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_xx = six_link_cos(q[0]);
    const six_link_real R_rel_xz = six_link_sin(q[0]);
    const six_link_real t1 = -R_rel_xz;

    const six_link_real omega_R_x = R_rel_xx * base->omega[0] - R_rel_xz * base->omega[2];
    const six_link_real omega_R_z = R_rel_xz * base->omega[0] + R_rel_xx * base->omega[2];
    const six_link_real qdot_1 = twist[1] - base->omega[1];

    /* v_R: velocity of the joint point */
    const six_link_real v_R_x = R_rel_xx * base->v[0] - R_rel_xz * base->v[2];
    const six_link_real v_R_z = R_rel_xz * base->v[0] + R_rel_xx * base->v[2];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_omega_x = omega_R_z * qdot_1;
    const six_link_real beta_omega_z = omega_R_x * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_v_x = qdot_1 * v_R_z;
    const six_link_real beta_v_z = qdot_1 * v_R_x;

    const six_link_real t2 = quaternion[1] * quaternion[1];
    const six_link_real t3 = quaternion[2] * quaternion[2];
    const six_link_real t4 = quaternion[3] * quaternion[3];
    const six_link_real t5 = 2 / (quaternion[0] * quaternion[0] + t2 + t3 + t4);
    const six_link_real t6 = t2 + t3 + t4;
    const six_link_real t7 = quaternion[1] * quaternion[2];
    const six_link_real t8 = quaternion[1] * quaternion[3];
    const six_link_real t9 = quaternion[2] * quaternion[3];
    const six_link_real t10 = quaternion[0] * quaternion[3];
    const six_link_real t11 = quaternion[0] * quaternion[2];
    const six_link_real t12 = quaternion[0] * quaternion[1];
    const six_link_real t13 = (1 + t5 * (t2 - t6)) * gravity[0] + t5 * (t10 + t7) * gravity[1]
        + t5 * (t8 - t11) * gravity[2];
    const six_link_real t14 = t5 * (t7 - t10) * gravity[0] + (1 + t5 * (t3 - t6)) * gravity[1]
        + t5 * (t12 + t9) * gravity[2];
    const six_link_real t15 = t5 * (t11 + t8) * gravity[0] + t5 * (t9 - t12) * gravity[1]
        + (1 + t5 * (t4 - t6)) * gravity[2];

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t13 - twist[2] * twist[4];
    const six_link_real a_0_y = twist[2] * twist[3] - t14 - twist[0] * twist[5];
    const six_link_real a_0_z = twist[0] * twist[4] - t15 - twist[1] * twist[3];

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t16 = c->I_s * twist[0];
    const six_link_real H_star_2 = t16 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_3 = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t16 * twist[1];
    const six_link_real H_star_4 = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_6 = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_22 = 1 + c->armature_1 - 1;

    /* joint_H: what the velocities, springs and dampers leave in the joint's rows (61) */
    const six_link_real joint_H_1 = R_rel_xz * base->b[2] - R_rel_xx * base->b[0] + minus_beta_omega_x;
    const six_link_real joint_H_2 = c->joint_damping_1 * qdot_1 - P_c_22 * base->b[1];
    const six_link_real minus_joint_H_3 = R_rel_xz * base->b[0] + R_rel_xx * base->b[2] + beta_omega_z;
    const six_link_real t17 = -minus_joint_H_3;
    const six_link_real joint_H_4 = minus_beta_v_x - R_rel_xx * base->b[3] + R_rel_xz * base->b[5];
    const six_link_real t18 = -base->b[4];
    const six_link_real minus_joint_H_6 = beta_v_z + R_rel_xz * base->b[3] + R_rel_xx * base->b[5];
    const six_link_real t19 = -minus_joint_H_6;

    /* outputs */
    link->h_V[0] = H_star_2;
    link->h_V[1] = H_star_3;
    link->h_V[2] = H_star_4;
    link->h_V[3] = H_star_5;
    link->h_V[4] = H_star_6;
    tip->omega[0] = twist[0];
    tip->omega[1] = twist[1];
    tip->omega[2] = twist[2];
    tip->v[0] = twist[3];
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
    M[place[0]] = 1;
    M[place[1]] = 1;
    M[place[2]] = P_c_22;
    M[place[3]] = 1;
    M[place[4]] = 1;
    M[place[5]] = 1;
    M[place[6]] = 1;
    H[0] = joint_H_1;
    H[1] = joint_H_2;
    H[2] = t17;
    H[3] = joint_H_4;
    H[4] = t18;
    H[5] = t19;
    W[0] = 0;
    W[1] = tau[0];
    W[2] = 0;
    W[3] = 0;
    W[4] = 0;
    W[5] = 0;
    base->X[0] = R_rel_xx;
    base->X[1] = 0;
    base->X[2] = t1;
    base->X[3] = 0;
    base->X[4] = 0;
    base->X[5] = 0;
    base->X[6] = 0;
    base->X[7] = 1;
    base->X[8] = 0;
    base->X[9] = 0;
    base->X[10] = 0;
    base->X[11] = 0;
    base->X[12] = R_rel_xz;
    base->X[13] = 0;
    base->X[14] = R_rel_xx;
    base->X[15] = 0;
    base->X[16] = 0;
    base->X[17] = 0;
    base->X[18] = 0;
    base->X[19] = 0;
    base->X[20] = 0;
    base->X[21] = R_rel_xx;
    base->X[22] = 0;
    base->X[23] = t1;
    base->X[24] = 0;
    base->X[25] = 0;
    base->X[26] = 0;
    base->X[27] = 0;
    base->X[28] = 1;
    base->X[29] = 0;
    base->X[30] = 0;
    base->X[31] = 0;
    base->X[32] = 0;
    base->X[33] = R_rel_xz;
    base->X[34] = 0;
    base->X[35] = R_rel_xx;
    base->PX[0] = R_rel_xx;
    base->PX[1] = 0;
    base->PX[2] = t1;
    base->PX[3] = 0;
    base->PX[4] = 0;
    base->PX[5] = 0;
    base->PX[6] = 0;
    base->PX[7] = P_c_22;
    base->PX[8] = 0;
    base->PX[9] = 0;
    base->PX[10] = 0;
    base->PX[11] = 0;
    base->PX[12] = R_rel_xz;
    base->PX[13] = 0;
    base->PX[14] = R_rel_xx;
    base->PX[15] = 0;
    base->PX[16] = 0;
    base->PX[17] = 0;
    base->PX[18] = 0;
    base->PX[19] = 0;
    base->PX[20] = 0;
    base->PX[21] = R_rel_xx;
    base->PX[22] = 0;
    base->PX[23] = t1;
    base->PX[24] = 0;
    base->PX[25] = 0;
    base->PX[26] = 0;
    base->PX[27] = 0;
    base->PX[28] = 1;
    base->PX[29] = 0;
    base->PX[30] = 0;
    base->PX[31] = 0;
    base->PX[32] = 0;
    base->PX[33] = R_rel_xz;
    base->PX[34] = 0;
    base->PX[35] = R_rel_xx;
    tip->b[0] = 0;
    tip->b[1] = 0;
    tip->b[2] = 0;
    tip->b[3] = 0;
    tip->b[4] = 0;
    tip->b[5] = 0;
    return SIX_LINK_OK;
}

/* joint rows, links like flange: 206 operations */
static six_link_status joint_rows_flange_last(const six_link_link_constants *c, six_link_link_store *link, six_link_node *base, six_link_node *tip,
    const six_link_real twist[6], const six_link_real q[1], const six_link_real quaternion[4],
    const six_link_real gravity[3], const six_link_real tau[1], const int *place, six_link_real *M,
    six_link_real H[12], six_link_real W[12])
{

    /* R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_yy = six_link_cos(q[0]);
    const six_link_real minus_R_rel_yz = six_link_sin(q[0]);
    const six_link_real t1 = -minus_R_rel_yz;

    const six_link_real omega_R_y = R_rel_yy * base->omega[1] + minus_R_rel_yz * base->omega[2];
    const six_link_real omega_R_z = R_rel_yy * base->omega[2] - minus_R_rel_yz * base->omega[1];
    const six_link_real qdot_1 = twist[0] - base->omega[0];

    /* v_R: velocity of the joint point */
    const six_link_real v_R_y = R_rel_yy * base->v[1] + minus_R_rel_yz * base->v[2];
    const six_link_real v_R_z = R_rel_yy * base->v[2] - minus_R_rel_yz * base->v[1];

    /* beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_omega_y = omega_R_z * qdot_1;
    const six_link_real minus_beta_omega_z = omega_R_y * qdot_1;

    /* beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_v_y = qdot_1 * v_R_z;
    const six_link_real minus_beta_v_z = qdot_1 * v_R_y;

    const six_link_real t2 = quaternion[1] * quaternion[1];
    const six_link_real t3 = quaternion[2] * quaternion[2];
    const six_link_real t4 = quaternion[3] * quaternion[3];
    const six_link_real t5 = 2 / (quaternion[0] * quaternion[0] + t2 + t3 + t4);
    const six_link_real t6 = t2 + t3 + t4;
    const six_link_real t7 = quaternion[1] * quaternion[2];
    const six_link_real t8 = quaternion[1] * quaternion[3];
    const six_link_real t9 = quaternion[2] * quaternion[3];
    const six_link_real t10 = quaternion[0] * quaternion[3];
    const six_link_real t11 = quaternion[0] * quaternion[2];
    const six_link_real t12 = quaternion[0] * quaternion[1];
    const six_link_real t13 = (1 + t5 * (t2 - t6)) * gravity[0] + t5 * (t10 + t7) * gravity[1]
        + t5 * (t8 - t11) * gravity[2];
    const six_link_real t14 = t5 * (t7 - t10) * gravity[0] + (1 + t5 * (t3 - t6)) * gravity[1]
        + t5 * (t12 + t9) * gravity[2];
    const six_link_real t15 = t5 * (t11 + t8) * gravity[0] + t5 * (t9 - t12) * gravity[1]
        + (1 + t5 * (t4 - t6)) * gravity[2];

    /* a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_x = twist[1] * twist[5] - t13 - twist[2] * twist[4];
    const six_link_real t16 = twist[2] * twist[3] - t14;
    const six_link_real a_0_y = t16 - twist[0] * twist[5];
    const six_link_real t17 = twist[1] * twist[3];
    const six_link_real a_0_z = twist[0] * twist[4] - t15 - t17;

    /* Omega: centripetal operator */
    const six_link_real minus_Omega_xx = twist[1] * twist[1] + twist[2] * twist[2];
    const six_link_real Omega_xy = twist[0] * twist[1];
    const six_link_real Omega_xz = twist[0] * twist[2];

    /* H_star: gyroscopic wrench and weight (29) */
    const six_link_real t18 = c->I_s * twist[0];
    const six_link_real H_star_2 = t18 * twist[2] - c->J_0_xx * Omega_xz - c->S_0_x * a_0_z;
    const six_link_real H_star_3 = c->J_0_xx * Omega_xy + c->S_0_x * a_0_y - t18 * twist[1];
    const six_link_real H_star_4 = a_0_x * c->mu - minus_Omega_xx * c->S_0_x;
    const six_link_real H_star_5 = Omega_xy * c->S_0_x + a_0_y * c->mu;
    const six_link_real H_star_6 = Omega_xz * c->S_0_x + a_0_z * c->mu;

    /* v_T: velocity of the tip point (46) */
    const six_link_real v_T_y = twist[4] + c->length * twist[2];
    const six_link_real v_T_z = twist[5] - c->length * twist[1];

    /* a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_x = twist[1] * v_T_z - t13 - twist[2] * v_T_y;
    const six_link_real a_T_y = t16 - twist[0] * v_T_z;
    const six_link_real a_T_z = twist[0] * v_T_y - t15 - t17;

    /* h_T_tau: moment that the bodies' velocities and weight need */
    const six_link_real t19 = c->I_T_zz * twist[2] - c->J_T_xz * twist[0] - c->J_T_yz * twist[1];
    const six_link_real t20 = c->I_T_yy * twist[1] - c->J_T_xy * twist[0] - c->J_T_yz * twist[2];
    const six_link_real h_T_tau_x = c->S_T_y * a_T_z + twist[1] * t19 - c->S_T_z * a_T_y - twist[2] * t20;
    const six_link_real t21 = c->I_T_xx * twist[0] - c->J_T_xy * twist[1] - c->J_T_xz * twist[2];
    const six_link_real h_T_tau_y = c->S_T_z * a_T_x + twist[2] * t21 - c->S_T_x * a_T_z - twist[0] * t19;
    const six_link_real h_T_tau_z = c->S_T_x * a_T_y + twist[0] * t20 - c->S_T_y * a_T_x - twist[1] * t21;

    /* h_T_F: force that the bodies' velocities and weight need */
    const six_link_real t22 = c->S_T_y * twist[0] - c->S_T_x * twist[1];
    const six_link_real t23 = c->S_T_x * twist[2] - c->S_T_z * twist[0];
    const six_link_real h_T_F_x = a_T_x * c->body0_mass + twist[1] * t22 - twist[2] * t23;
    const six_link_real t24 = c->S_T_z * twist[1] - c->S_T_y * twist[2];
    const six_link_real h_T_F_y = a_T_y * c->body0_mass + twist[2] * t24 - twist[0] * t22;
    const six_link_real h_T_F_z = a_T_z * c->body0_mass + twist[0] * t23 - twist[1] * t24;

    /* P_c: P with the rotor inertias about the axes (43) */
    const six_link_real P_c_11 = 1 + c->armature_1 - 1;

    /* joint_H: what the velocities, springs and dampers leave in the joint's rows (61) */
    const six_link_real joint_H_1 = c->joint_damping_1 * qdot_1 - P_c_11 * base->b[0];
    const six_link_real minus_joint_H_2 = R_rel_yy * base->b[1] + minus_R_rel_yz * base->b[2] + beta_omega_y;
    const six_link_real t25 = -minus_joint_H_2;
    const six_link_real joint_H_3 = minus_R_rel_yz * base->b[1] - R_rel_yy * base->b[2] + minus_beta_omega_z;
    const six_link_real t26 = -base->b[3];
    const six_link_real minus_joint_H_5 = beta_v_y + R_rel_yy * base->b[4] + minus_R_rel_yz * base->b[5];
    const six_link_real t27 = -minus_joint_H_5;
    const six_link_real joint_H_6 = minus_beta_v_z + minus_R_rel_yz * base->b[4] - R_rel_yy * base->b[5];

    /* outputs */
    link->h_V[0] = H_star_2;
    link->h_V[1] = H_star_3;
    link->h_V[2] = H_star_4;
    link->h_V[3] = H_star_5;
    link->h_V[4] = H_star_6;
    tip->omega[0] = twist[0];
    tip->omega[1] = twist[1];
    tip->omega[2] = twist[2];
    tip->v[0] = twist[3];
    tip->v[1] = v_T_y;
    tip->v[2] = v_T_z;
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
    H[0] = joint_H_1;
    H[1] = t25;
    H[2] = joint_H_3;
    H[3] = t26;
    H[4] = t27;
    H[5] = joint_H_6;
    W[0] = tau[0];
    W[1] = 0;
    W[2] = 0;
    W[3] = 0;
    W[4] = 0;
    W[5] = 0;
    base->X[0] = 1;
    base->X[1] = 0;
    base->X[2] = 0;
    base->X[3] = 0;
    base->X[4] = 0;
    base->X[5] = 0;
    base->X[6] = 0;
    base->X[7] = R_rel_yy;
    base->X[8] = minus_R_rel_yz;
    base->X[9] = 0;
    base->X[10] = 0;
    base->X[11] = 0;
    base->X[12] = 0;
    base->X[13] = t1;
    base->X[14] = R_rel_yy;
    base->X[15] = 0;
    base->X[16] = 0;
    base->X[17] = 0;
    base->X[18] = 0;
    base->X[19] = 0;
    base->X[20] = 0;
    base->X[21] = 1;
    base->X[22] = 0;
    base->X[23] = 0;
    base->X[24] = 0;
    base->X[25] = 0;
    base->X[26] = 0;
    base->X[27] = 0;
    base->X[28] = R_rel_yy;
    base->X[29] = minus_R_rel_yz;
    base->X[30] = 0;
    base->X[31] = 0;
    base->X[32] = 0;
    base->X[33] = 0;
    base->X[34] = t1;
    base->X[35] = R_rel_yy;
    base->PX[0] = P_c_11;
    base->PX[1] = 0;
    base->PX[2] = 0;
    base->PX[3] = 0;
    base->PX[4] = 0;
    base->PX[5] = 0;
    base->PX[6] = 0;
    base->PX[7] = R_rel_yy;
    base->PX[8] = minus_R_rel_yz;
    base->PX[9] = 0;
    base->PX[10] = 0;
    base->PX[11] = 0;
    base->PX[12] = 0;
    base->PX[13] = t1;
    base->PX[14] = R_rel_yy;
    base->PX[15] = 0;
    base->PX[16] = 0;
    base->PX[17] = 0;
    base->PX[18] = 0;
    base->PX[19] = 0;
    base->PX[20] = 0;
    base->PX[21] = 1;
    base->PX[22] = 0;
    base->PX[23] = 0;
    base->PX[24] = 0;
    base->PX[25] = 0;
    base->PX[26] = 0;
    base->PX[27] = 0;
    base->PX[28] = R_rel_yy;
    base->PX[29] = minus_R_rel_yz;
    base->PX[30] = 0;
    base->PX[31] = 0;
    base->PX[32] = 0;
    base->PX[33] = 0;
    base->PX[34] = t1;
    base->PX[35] = R_rel_yy;
    tip->b[0] = 0;
    tip->b[1] = 0;
    tip->b[2] = 0;
    tip->b[3] = 0;
    tip->b[4] = 0;
    tip->b[5] = 0;
    return SIX_LINK_OK;
}

/* link rows, links like shoulder: 113 operations */
static six_link_status link_rows_shoulder(const six_link_link_constants *c, const six_link_link_store *link, const six_link_node *tip,
    const six_link_real w_ext[6], const int *place, six_link_real *M, six_link_real H[12],
    six_link_real W[12])
{

    const six_link_real t1 = -c->S_T_z;
    const six_link_real t2 = -c->J_T_yz;
    const six_link_real t3 = -c->S_T_y;

    /* V_V: twist rows, twist columns (100) */
    const six_link_real V_V_11 = c->I_s + c->I_T_xx;
    const six_link_real minus_V_V_12 = c->length * c->S_T_y + c->J_T_xy;
    const six_link_real t4 = -minus_V_V_12;
    const six_link_real minus_V_V_13 = c->length * c->S_T_z + c->J_T_xz;
    const six_link_real t5 = -minus_V_V_13;
    const six_link_real t6 = c->length * c->body0_mass + c->S_T_x;
    const six_link_real t7 = c->J_0_xx + c->length * t6;
    const six_link_real t8 = c->length * c->S_T_x;
    const six_link_real V_V_22 = t7 + (t8 + c->I_T_yy);
    const six_link_real minus_V_V_26 = c->S_0_x + t6;
    const six_link_real t9 = -minus_V_V_26;
    const six_link_real V_V_33 = t7 + (t8 + c->I_T_zz);
    const six_link_real V_V_44 = c->mu + c->body0_mass;

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const six_link_real V_next_21 = tip->X[1] - c->length * tip->X[5];
    const six_link_real V_next_22 = tip->X[7] - c->length * tip->X[11];
    const six_link_real V_next_23 = tip->X[13] - c->length * tip->X[17];
    const six_link_real V_next_24 = tip->X[19] - c->length * tip->X[23];
    const six_link_real V_next_25 = tip->X[25] - c->length * tip->X[29];
    const six_link_real V_next_26 = tip->X[31] - c->length * tip->X[35];
    const six_link_real V_next_31 = c->length * tip->X[4] + tip->X[2];
    const six_link_real V_next_32 = c->length * tip->X[10] + tip->X[8];
    const six_link_real V_next_33 = c->length * tip->X[16] + tip->X[14];
    const six_link_real V_next_34 = c->length * tip->X[22] + tip->X[20];
    const six_link_real V_next_35 = c->length * tip->X[28] + tip->X[26];
    const six_link_real V_next_36 = c->length * tip->X[34] + tip->X[32];

    /* next_V: next joint's rows, twist columns (100) */
    const six_link_real t10 = -tip->PX[0];
    const six_link_real next_V_12 = c->length * tip->PX[5] - tip->PX[1];
    const six_link_real minus_next_V_13 = c->length * tip->PX[4] + tip->PX[2];
    const six_link_real t11 = -minus_next_V_13;
    const six_link_real t12 = -tip->PX[3];
    const six_link_real t13 = -tip->PX[4];
    const six_link_real t14 = -tip->PX[5];
    const six_link_real t15 = -tip->PX[6];
    const six_link_real next_V_22 = c->length * tip->PX[11] - tip->PX[7];
    const six_link_real minus_next_V_23 = c->length * tip->PX[10] + tip->PX[8];
    const six_link_real t16 = -minus_next_V_23;
    const six_link_real t17 = -tip->PX[9];
    const six_link_real t18 = -tip->PX[10];
    const six_link_real t19 = -tip->PX[11];
    const six_link_real t20 = -tip->PX[12];
    const six_link_real next_V_32 = c->length * tip->PX[17] - tip->PX[13];
    const six_link_real minus_next_V_33 = c->length * tip->PX[16] + tip->PX[14];
    const six_link_real t21 = -minus_next_V_33;
    const six_link_real t22 = -tip->PX[15];
    const six_link_real t23 = -tip->PX[16];
    const six_link_real t24 = -tip->PX[17];
    const six_link_real t25 = -tip->PX[18];
    const six_link_real next_V_42 = c->length * tip->PX[23] - tip->PX[19];
    const six_link_real minus_next_V_43 = c->length * tip->PX[22] + tip->PX[20];
    const six_link_real t26 = -minus_next_V_43;
    const six_link_real t27 = -tip->PX[21];
    const six_link_real t28 = -tip->PX[22];
    const six_link_real t29 = -tip->PX[23];
    const six_link_real t30 = -tip->PX[24];
    const six_link_real next_V_52 = c->length * tip->PX[29] - tip->PX[25];
    const six_link_real minus_next_V_53 = c->length * tip->PX[28] + tip->PX[26];
    const six_link_real t31 = -minus_next_V_53;
    const six_link_real t32 = -tip->PX[27];
    const six_link_real t33 = -tip->PX[28];
    const six_link_real t34 = -tip->PX[29];
    const six_link_real t35 = -tip->PX[30];
    const six_link_real next_V_62 = c->length * tip->PX[35] - tip->PX[31];
    const six_link_real minus_next_V_63 = c->length * tip->PX[34] + tip->PX[32];
    const six_link_real t36 = -minus_next_V_63;
    const six_link_real t37 = -tip->PX[33];
    const six_link_real t38 = -tip->PX[34];
    const six_link_real t39 = -tip->PX[35];

    /* V_H: bias of the twist rows (100) */
    const six_link_real V_H_2 = link->h_V[0] - c->length * link->h_T[5] + link->h_T[1];
    const six_link_real V_H_3 = link->h_V[1] + c->length * link->h_T[4] + link->h_T[2];
    const six_link_real V_H_4 = link->h_V[2] + link->h_T[3];
    const six_link_real V_H_5 = link->h_V[3] + link->h_T[4];
    const six_link_real V_H_6 = link->h_V[4] + link->h_T[5];

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real V_W_2 = w_ext[1] - c->length * w_ext[5];
    const six_link_real V_W_3 = c->length * w_ext[4] + w_ext[2];

    /* outputs */
    M[place[7]] = t10;
    M[place[8]] = next_V_12;
    M[place[9]] = t11;
    M[place[10]] = t12;
    M[place[11]] = t13;
    M[place[12]] = t14;
    M[place[13]] = t15;
    M[place[14]] = next_V_22;
    M[place[15]] = t16;
    M[place[16]] = t17;
    M[place[17]] = t18;
    M[place[18]] = t19;
    M[place[19]] = t20;
    M[place[20]] = next_V_32;
    M[place[21]] = t21;
    M[place[22]] = t22;
    M[place[23]] = t23;
    M[place[24]] = t24;
    M[place[25]] = t25;
    M[place[26]] = next_V_42;
    M[place[27]] = t26;
    M[place[28]] = t27;
    M[place[29]] = t28;
    M[place[30]] = t29;
    M[place[31]] = t30;
    M[place[32]] = next_V_52;
    M[place[33]] = t31;
    M[place[34]] = t32;
    M[place[35]] = t33;
    M[place[36]] = t34;
    M[place[37]] = t35;
    M[place[38]] = next_V_62;
    M[place[39]] = t36;
    M[place[40]] = t37;
    M[place[41]] = t38;
    M[place[42]] = t39;
    M[place[43]] = -1;
    M[place[44]] = -1;
    M[place[45]] = -1;
    M[place[46]] = -1;
    M[place[47]] = -1;
    M[place[48]] = -1;
    M[place[49]] = V_V_11;
    M[place[50]] = t4;
    M[place[51]] = t5;
    M[place[52]] = t1;
    M[place[53]] = c->S_T_y;
    M[place[54]] = t4;
    M[place[55]] = V_V_22;
    M[place[56]] = t2;
    M[place[57]] = c->S_T_z;
    M[place[58]] = t9;
    M[place[59]] = t5;
    M[place[60]] = t2;
    M[place[61]] = V_V_33;
    M[place[62]] = t3;
    M[place[63]] = minus_V_V_26;
    M[place[64]] = c->S_T_z;
    M[place[65]] = t3;
    M[place[66]] = V_V_44;
    M[place[67]] = t1;
    M[place[68]] = minus_V_V_26;
    M[place[69]] = V_V_44;
    M[place[70]] = c->S_T_y;
    M[place[71]] = t9;
    M[place[72]] = V_V_44;
    M[place[73]] = tip->X[0];
    M[place[74]] = tip->X[6];
    M[place[75]] = tip->X[12];
    M[place[76]] = tip->X[18];
    M[place[77]] = tip->X[24];
    M[place[78]] = tip->X[30];
    M[place[79]] = V_next_21;
    M[place[80]] = V_next_22;
    M[place[81]] = V_next_23;
    M[place[82]] = V_next_24;
    M[place[83]] = V_next_25;
    M[place[84]] = V_next_26;
    M[place[85]] = V_next_31;
    M[place[86]] = V_next_32;
    M[place[87]] = V_next_33;
    M[place[88]] = V_next_34;
    M[place[89]] = V_next_35;
    M[place[90]] = V_next_36;
    M[place[91]] = tip->X[3];
    M[place[92]] = tip->X[9];
    M[place[93]] = tip->X[15];
    M[place[94]] = tip->X[21];
    M[place[95]] = tip->X[27];
    M[place[96]] = tip->X[33];
    M[place[97]] = tip->X[4];
    M[place[98]] = tip->X[10];
    M[place[99]] = tip->X[16];
    M[place[100]] = tip->X[22];
    M[place[101]] = tip->X[28];
    M[place[102]] = tip->X[34];
    M[place[103]] = tip->X[5];
    M[place[104]] = tip->X[11];
    M[place[105]] = tip->X[17];
    M[place[106]] = tip->X[23];
    M[place[107]] = tip->X[29];
    M[place[108]] = tip->X[35];
    H[6] = link->h_T[0];
    H[7] = V_H_2;
    H[8] = V_H_3;
    H[9] = V_H_4;
    H[10] = V_H_5;
    H[11] = V_H_6;
    W[6] = w_ext[0];
    W[7] = V_W_2;
    W[8] = V_W_3;
    W[9] = w_ext[3];
    W[10] = w_ext[4];
    W[11] = w_ext[5];
    return SIX_LINK_OK;
}

/* link rows, links like upper_arm: 1869 operations */
static six_link_status link_rows_upper_arm(const six_link_link_constants *c, const six_link_link_store *link, const six_link_node *tip,
    const six_link_real m_eta[3], const six_link_real f_eta[3], const six_link_real w_ext[6],
    six_link_real eta_H[3], six_link_real eta_W[3], const int *place, six_link_real *M,
    six_link_real H[12], six_link_real W[12])
{

    const six_link_real t1 = link->h_eta[0] + f_eta[0];
    const six_link_real t2 = link->h_eta[1] + f_eta[1];

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
    const six_link_real t3 = link->G[2] * c->Psi_c_z1;
    const six_link_real t4 = link->G[5] * c->Psi_c_z1;
    const six_link_real t5 = link->G[8] * c->Psi_c_z1;
    const six_link_real J_Teta_11 = link->R_T[0] * t3 + link->R_T[3] * t4 + link->R_T[6] * t5;
    const six_link_real t6 = link->G[1] * c->Psi_c_y2;
    const six_link_real t7 = link->G[4] * c->Psi_c_y2;
    const six_link_real t8 = link->G[7] * c->Psi_c_y2;
    const six_link_real J_Teta_12 = link->R_T[0] * t6 + link->R_T[3] * t7 + link->R_T[6] * t8;
    const six_link_real t9 = link->G[0] * REAL(1.4142135623730951);
    const six_link_real t10 = link->G[3] * REAL(1.4142135623730951);
    const six_link_real t11 = link->G[6] * REAL(1.4142135623730951);
    const six_link_real J_Teta_13 = link->R_T[0] * t9 + link->R_T[3] * t10 + link->R_T[6] * t11;
    const six_link_real J_Teta_21 = link->R_T[1] * t3 + link->R_T[4] * t4 + link->R_T[7] * t5;
    const six_link_real J_Teta_22 = link->R_T[1] * t6 + link->R_T[4] * t7 + link->R_T[7] * t8;
    const six_link_real J_Teta_23 = link->R_T[1] * t9 + link->R_T[4] * t10 + link->R_T[7] * t11;
    const six_link_real J_Teta_31 = link->R_T[2] * t3 + link->R_T[5] * t4 + link->R_T[8] * t5;
    const six_link_real J_Teta_32 = link->R_T[2] * t6 + link->R_T[5] * t7 + link->R_T[8] * t8;
    const six_link_real J_Teta_33 = link->R_T[2] * t9 + link->R_T[5] * t10 + link->R_T[8] * t11;
    const six_link_real J_Teta_41 = link->R_T[3] * 2;
    const six_link_real J_Teta_42 = link->R_T[6] * 2;
    const six_link_real J_Teta_51 = link->R_T[4] * 2;
    const six_link_real J_Teta_52 = link->R_T[7] * 2;
    const six_link_real J_Teta_61 = link->R_T[5] * 2;
    const six_link_real J_Teta_62 = link->R_T[8] * 2;

    /* V_V: twist rows, twist columns (100) */
    const six_link_real t12 = c->S_T_z * link->R_T[1];
    const six_link_real t13 = c->S_T_y * link->R_T[2];
    const six_link_real t14 = J_TV_41 * c->body0_mass + t12 - t13;
    const six_link_real t15 = c->S_T_z * link->R_T[0];
    const six_link_real t16 = c->S_T_x * link->R_T[2];
    const six_link_real t17 = J_TV_51 * c->body0_mass - t15 + t16;
    const six_link_real t18 = c->S_T_y * link->R_T[0];
    const six_link_real t19 = c->S_T_x * link->R_T[1];
    const six_link_real t20 = J_TV_61 * c->body0_mass + t18 - t19;
    const six_link_real t21 = J_TV_61 * c->S_T_y - J_TV_51 * c->S_T_z + c->I_T_xx * link->R_T[0]
        - c->J_T_xy * link->R_T[1] - c->J_T_xz * link->R_T[2];
    const six_link_real t22 = J_TV_41 * c->S_T_z - J_TV_61 * c->S_T_x - c->J_T_xy * link->R_T[0]
        + c->I_T_yy * link->R_T[1] - c->J_T_yz * link->R_T[2];
    const six_link_real t23 = link->M_V[0] + J_TV_41 * t14 + J_TV_51 * t17 + J_TV_61 * t20 + link->R_T[0] * t21
        + link->R_T[1] * t22;
    const six_link_real t24 = J_TV_51 * c->S_T_x - J_TV_41 * c->S_T_y - c->J_T_xz * link->R_T[0]
        - c->J_T_yz * link->R_T[1] + c->I_T_zz * link->R_T[2];
    const six_link_real V_V_11 = t23 + link->R_T[2] * t24;
    const six_link_real t25 = J_TV_42 * t14 - link->M_V[1] + J_TV_52 * t17 + J_TV_62 * t20 + link->R_T[3] * t21
        + link->R_T[4] * t22;
    const six_link_real V_V_12 = t25 + link->R_T[5] * t24;
    const six_link_real t26 = J_TV_43 * t14 - link->M_V[2] + J_TV_53 * t17 + J_TV_63 * t20 + link->R_T[6] * t21
        + link->R_T[7] * t22;
    const six_link_real V_V_13 = t26 + link->R_T[8] * t24;
    const six_link_real V_V_14 = link->R_T[0] * t14 + link->R_T[1] * t17 + link->R_T[2] * t20;
    const six_link_real V_V_15 = link->R_T[3] * t14 - link->M_V[3] + link->R_T[4] * t17 + link->R_T[5] * t20;
    const six_link_real V_V_16 = link->M_V[4] + link->R_T[6] * t14 + link->R_T[7] * t17 + link->R_T[8] * t20;
    const six_link_real t27 = c->S_T_z * link->R_T[4];
    const six_link_real t28 = c->S_T_y * link->R_T[5];
    const six_link_real t29 = J_TV_42 * c->body0_mass + t27 - t28;
    const six_link_real t30 = c->S_T_z * link->R_T[3];
    const six_link_real t31 = c->S_T_x * link->R_T[5];
    const six_link_real t32 = J_TV_52 * c->body0_mass - t30 + t31;
    const six_link_real t33 = c->S_T_y * link->R_T[3];
    const six_link_real t34 = c->S_T_x * link->R_T[4];
    const six_link_real t35 = J_TV_62 * c->body0_mass + t33 - t34;
    const six_link_real t36 = J_TV_62 * c->S_T_y - J_TV_52 * c->S_T_z + c->I_T_xx * link->R_T[3]
        - c->J_T_xy * link->R_T[4] - c->J_T_xz * link->R_T[5];
    const six_link_real t37 = J_TV_42 * c->S_T_z - J_TV_62 * c->S_T_x - c->J_T_xy * link->R_T[3]
        + c->I_T_yy * link->R_T[4] - c->J_T_yz * link->R_T[5];
    const six_link_real t38 = link->M_V[5] + J_TV_42 * t29 + J_TV_52 * t32 + J_TV_62 * t35 + link->R_T[3] * t36
        + link->R_T[4] * t37;
    const six_link_real t39 = J_TV_52 * c->S_T_x - J_TV_42 * c->S_T_y - c->J_T_xz * link->R_T[3]
        - c->J_T_yz * link->R_T[4] + c->I_T_zz * link->R_T[5];
    const six_link_real V_V_22 = t38 + link->R_T[5] * t39;
    const six_link_real t40 = J_TV_43 * t29 - link->M_V[6] + J_TV_53 * t32 + J_TV_63 * t35 + link->R_T[6] * t36
        + link->R_T[7] * t37;
    const six_link_real V_V_23 = t40 + link->R_T[8] * t39;
    const six_link_real V_V_24 = link->M_V[3] + link->R_T[0] * t29 + link->R_T[1] * t32 + link->R_T[2] * t35;
    const six_link_real V_V_25 = link->R_T[3] * t29 + link->R_T[4] * t32 + link->R_T[5] * t35;
    const six_link_real V_V_26 = link->R_T[6] * t29 - c->S_0_x + link->R_T[7] * t32 + link->R_T[8] * t35;
    const six_link_real t41 = c->S_T_z * link->R_T[7];
    const six_link_real t42 = c->S_T_y * link->R_T[8];
    const six_link_real t43 = J_TV_43 * c->body0_mass + t41 - t42;
    const six_link_real t44 = c->S_T_z * link->R_T[6];
    const six_link_real t45 = c->S_T_x * link->R_T[8];
    const six_link_real t46 = J_TV_53 * c->body0_mass - t44 + t45;
    const six_link_real t47 = c->S_T_y * link->R_T[6];
    const six_link_real t48 = c->S_T_x * link->R_T[7];
    const six_link_real t49 = J_TV_63 * c->body0_mass + t47 - t48;
    const six_link_real t50 = J_TV_63 * c->S_T_y - J_TV_53 * c->S_T_z + c->I_T_xx * link->R_T[6]
        - c->J_T_xy * link->R_T[7] - c->J_T_xz * link->R_T[8];
    const six_link_real t51 = J_TV_43 * c->S_T_z - J_TV_63 * c->S_T_x - c->J_T_xy * link->R_T[6]
        + c->I_T_yy * link->R_T[7] - c->J_T_yz * link->R_T[8];
    const six_link_real t52 = link->M_V[7] + J_TV_43 * t43 + J_TV_53 * t46 + J_TV_63 * t49 + link->R_T[6] * t50
        + link->R_T[7] * t51;
    const six_link_real t53 = J_TV_53 * c->S_T_x - J_TV_43 * c->S_T_y - c->J_T_xz * link->R_T[6]
        - c->J_T_yz * link->R_T[7] + c->I_T_zz * link->R_T[8];
    const six_link_real V_V_33 = t52 + link->R_T[8] * t53;
    const six_link_real V_V_34 = link->R_T[0] * t43 - link->M_V[4] + link->R_T[1] * t46 + link->R_T[2] * t49;
    const six_link_real V_V_35 = c->S_0_x + link->R_T[3] * t43 + link->R_T[4] * t46 + link->R_T[5] * t49;
    const six_link_real V_V_36 = link->R_T[6] * t43 + link->R_T[7] * t46 + link->R_T[8] * t49;
    const six_link_real t54 = c->body0_mass * link->R_T[0];
    const six_link_real t55 = c->body0_mass * link->R_T[1];
    const six_link_real t56 = c->body0_mass * link->R_T[2];
    const six_link_real V_V_44 = c->mu + link->R_T[0] * t54 + link->R_T[1] * t55 + link->R_T[2] * t56;
    const six_link_real V_V_45 = link->R_T[3] * t54 + link->R_T[4] * t55 + link->R_T[5] * t56;
    const six_link_real V_V_46 = link->R_T[6] * t54 + link->R_T[7] * t55 + link->R_T[8] * t56;
    const six_link_real t57 = c->body0_mass * link->R_T[3];
    const six_link_real t58 = c->body0_mass * link->R_T[4];
    const six_link_real t59 = c->body0_mass * link->R_T[5];
    const six_link_real V_V_55 = c->mu + link->R_T[3] * t57 + link->R_T[4] * t58 + link->R_T[5] * t59;
    const six_link_real V_V_56 = link->R_T[6] * t57 + link->R_T[7] * t58 + link->R_T[8] * t59;
    const six_link_real t60 = c->body0_mass * link->R_T[6];
    const six_link_real t61 = c->body0_mass * link->R_T[7];
    const six_link_real t62 = c->body0_mass * link->R_T[8];
    const six_link_real V_V_66 = c->mu + link->R_T[6] * t60 + link->R_T[7] * t61 + link->R_T[8] * t62;

    /* V_eta: twist rows, modal columns (100) */
    const six_link_real t63 = J_Teta_11 * t21 - link->M_D[0] + J_Teta_21 * t22 + J_Teta_31 * t24
        + J_Teta_41 * t14 + J_Teta_51 * t17;
    const six_link_real V_eta_11 = t63 + J_Teta_61 * t20;
    const six_link_real t64 = link->M_D[1] + J_Teta_12 * t21 + J_Teta_22 * t22 + J_Teta_32 * t24
        + J_Teta_42 * t14 + J_Teta_52 * t17;
    const six_link_real V_eta_12 = t64 + J_Teta_62 * t20;
    const six_link_real V_eta_13 = c->sigma_t_3 + J_Teta_13 * t21 + J_Teta_23 * t22 + J_Teta_33 * t24;
    const six_link_real V_eta_21 = J_Teta_11 * t36 + J_Teta_21 * t37 + J_Teta_31 * t39 + J_Teta_41 * t29
        + J_Teta_51 * t32 + J_Teta_61 * t35;
    const six_link_real t65 = J_Teta_12 * t36 - c->chi_2 + J_Teta_22 * t37 + J_Teta_32 * t39 + J_Teta_42 * t29
        + J_Teta_52 * t32;
    const six_link_real V_eta_22 = t65 + J_Teta_62 * t35;
    const six_link_real V_eta_23 = J_Teta_13 * t36 + J_Teta_23 * t37 + J_Teta_33 * t39;
    const six_link_real t66 = c->chi_1 + J_Teta_11 * t50 + J_Teta_21 * t51 + J_Teta_31 * t53 + J_Teta_41 * t43
        + J_Teta_51 * t46;
    const six_link_real V_eta_31 = t66 + J_Teta_61 * t49;
    const six_link_real V_eta_32 = J_Teta_12 * t50 + J_Teta_22 * t51 + J_Teta_32 * t53 + J_Teta_42 * t43
        + J_Teta_52 * t46 + J_Teta_62 * t49;
    const six_link_real V_eta_33 = J_Teta_13 * t50 + J_Teta_23 * t51 + J_Teta_33 * t53;
    const six_link_real t67 = t13 - t12;
    const six_link_real t68 = t15 - t16;
    const six_link_real t69 = t19 - t18;
    const six_link_real V_eta_41 = J_Teta_11 * t67 + J_Teta_21 * t68 + J_Teta_31 * t69 + J_Teta_41 * t54
        + J_Teta_51 * t55 + J_Teta_61 * t56;
    const six_link_real V_eta_42 = J_Teta_12 * t67 + J_Teta_22 * t68 + J_Teta_32 * t69 + J_Teta_42 * t54
        + J_Teta_52 * t55 + J_Teta_62 * t56;
    const six_link_real V_eta_43 = J_Teta_13 * t67 + J_Teta_23 * t68 + J_Teta_33 * t69;
    const six_link_real t70 = t28 - t27;
    const six_link_real t71 = t30 - t31;
    const six_link_real t72 = t34 - t33;
    const six_link_real t73 = c->sigma_y1 + J_Teta_11 * t70 + J_Teta_21 * t71 + J_Teta_31 * t72 + J_Teta_41 * t57
        + J_Teta_51 * t58;
    const six_link_real V_eta_51 = t73 + J_Teta_61 * t59;
    const six_link_real V_eta_52 = J_Teta_12 * t70 + J_Teta_22 * t71 + J_Teta_32 * t72 + J_Teta_42 * t57
        + J_Teta_52 * t58 + J_Teta_62 * t59;
    const six_link_real V_eta_53 = J_Teta_13 * t70 + J_Teta_23 * t71 + J_Teta_33 * t72;
    const six_link_real t74 = t42 - t41;
    const six_link_real t75 = t44 - t45;
    const six_link_real t76 = t48 - t47;
    const six_link_real V_eta_61 = J_Teta_11 * t74 + J_Teta_21 * t75 + J_Teta_31 * t76 + J_Teta_41 * t60
        + J_Teta_51 * t61 + J_Teta_61 * t62;
    const six_link_real t77 = c->sigma_z2 + J_Teta_12 * t74 + J_Teta_22 * t75 + J_Teta_32 * t76 + J_Teta_42 * t60
        + J_Teta_52 * t61;
    const six_link_real V_eta_62 = t77 + J_Teta_62 * t62;
    const six_link_real V_eta_63 = J_Teta_13 * t74 + J_Teta_23 * t75 + J_Teta_33 * t76;

    /* eta_eta: modal rows, modal columns (100) */
    const six_link_real t78 = J_Teta_11 * c->I_T_xx - J_Teta_21 * c->J_T_xy - J_Teta_31 * c->J_T_xz
        - J_Teta_51 * c->S_T_z + J_Teta_61 * c->S_T_y;
    const six_link_real t79 = J_Teta_21 * c->I_T_yy - J_Teta_11 * c->J_T_xy - J_Teta_31 * c->J_T_yz
        + J_Teta_41 * c->S_T_z - J_Teta_61 * c->S_T_x;
    const six_link_real t80 = J_Teta_31 * c->I_T_zz - (J_Teta_11 * c->J_T_xz + J_Teta_21 * c->J_T_yz)
        - J_Teta_41 * c->S_T_y + J_Teta_51 * c->S_T_x;
    const six_link_real t81 = J_Teta_21 * c->S_T_z - J_Teta_31 * c->S_T_y + J_Teta_41 * c->body0_mass;
    const six_link_real t82 = J_Teta_31 * c->S_T_x - J_Teta_11 * c->S_T_z + J_Teta_51 * c->body0_mass;
    const six_link_real t83 = m_eta[0] + J_Teta_11 * t78 + J_Teta_21 * t79 + J_Teta_31 * t80 + J_Teta_41 * t81
        + J_Teta_51 * t82;
    const six_link_real t84 = J_Teta_11 * c->S_T_y - J_Teta_21 * c->S_T_x + J_Teta_61 * c->body0_mass;
    const six_link_real eta_eta_11 = t83 + J_Teta_61 * t84;
    const six_link_real eta_eta_12 = J_Teta_12 * t78 + J_Teta_22 * t79 + J_Teta_32 * t80 + J_Teta_42 * t81
        + J_Teta_52 * t82 + J_Teta_62 * t84;
    const six_link_real eta_eta_13 = J_Teta_13 * t78 + J_Teta_23 * t79 + J_Teta_33 * t80;
    const six_link_real t85 = J_Teta_12 * c->I_T_xx - J_Teta_22 * c->J_T_xy - J_Teta_32 * c->J_T_xz
        - J_Teta_52 * c->S_T_z + J_Teta_62 * c->S_T_y;
    const six_link_real t86 = J_Teta_22 * c->I_T_yy - J_Teta_12 * c->J_T_xy - J_Teta_32 * c->J_T_yz
        + J_Teta_42 * c->S_T_z - J_Teta_62 * c->S_T_x;
    const six_link_real t87 = J_Teta_32 * c->I_T_zz - (J_Teta_12 * c->J_T_xz + J_Teta_22 * c->J_T_yz)
        - J_Teta_42 * c->S_T_y + J_Teta_52 * c->S_T_x;
    const six_link_real t88 = m_eta[1] + J_Teta_12 * t85 + J_Teta_22 * t86 + J_Teta_32 * t87
        + J_Teta_42 * (J_Teta_22 * c->S_T_z - J_Teta_32 * c->S_T_y + J_Teta_42 * c->body0_mass);
    const six_link_real eta_eta_22 = t88
        + J_Teta_52 * (J_Teta_32 * c->S_T_x - J_Teta_12 * c->S_T_z + J_Teta_52 * c->body0_mass)
        + J_Teta_62 * (J_Teta_12 * c->S_T_y - J_Teta_22 * c->S_T_x + J_Teta_62 * c->body0_mass);
    const six_link_real eta_eta_23 = J_Teta_13 * t85 + J_Teta_23 * t86 + J_Teta_33 * t87;
    const six_link_real t89 = m_eta[2]
        + J_Teta_13 * (J_Teta_13 * c->I_T_xx - J_Teta_23 * c->J_T_xy - J_Teta_33 * c->J_T_xz)
        + J_Teta_23 * (J_Teta_23 * c->I_T_yy - J_Teta_13 * c->J_T_xy - J_Teta_33 * c->J_T_yz);
    const six_link_real eta_eta_33 = t89
        + J_Teta_33 * (J_Teta_33 * c->I_T_zz - (J_Teta_13 * c->J_T_xz + J_Teta_23 * c->J_T_yz));

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const six_link_real t90 = J_TV_41 * tip->X[3] + J_TV_51 * tip->X[4] + J_TV_61 * tip->X[5]
        + link->R_T[0] * tip->X[0] + link->R_T[1] * tip->X[1];
    const six_link_real V_next_11 = t90 + link->R_T[2] * tip->X[2];
    const six_link_real t91 = J_TV_41 * tip->X[9] + J_TV_51 * tip->X[10] + J_TV_61 * tip->X[11]
        + link->R_T[0] * tip->X[6] + link->R_T[1] * tip->X[7];
    const six_link_real V_next_12 = t91 + link->R_T[2] * tip->X[8];
    const six_link_real t92 = J_TV_41 * tip->X[15] + J_TV_51 * tip->X[16] + J_TV_61 * tip->X[17]
        + link->R_T[0] * tip->X[12] + link->R_T[1] * tip->X[13];
    const six_link_real V_next_13 = t92 + link->R_T[2] * tip->X[14];
    const six_link_real t93 = J_TV_41 * tip->X[21] + J_TV_51 * tip->X[22] + J_TV_61 * tip->X[23]
        + link->R_T[0] * tip->X[18] + link->R_T[1] * tip->X[19];
    const six_link_real V_next_14 = t93 + link->R_T[2] * tip->X[20];
    const six_link_real t94 = J_TV_41 * tip->X[27] + J_TV_51 * tip->X[28] + J_TV_61 * tip->X[29]
        + link->R_T[0] * tip->X[24] + link->R_T[1] * tip->X[25];
    const six_link_real V_next_15 = t94 + link->R_T[2] * tip->X[26];
    const six_link_real t95 = J_TV_41 * tip->X[33] + J_TV_51 * tip->X[34] + J_TV_61 * tip->X[35]
        + link->R_T[0] * tip->X[30] + link->R_T[1] * tip->X[31];
    const six_link_real V_next_16 = t95 + link->R_T[2] * tip->X[32];
    const six_link_real t96 = J_TV_42 * tip->X[3] + J_TV_52 * tip->X[4] + J_TV_62 * tip->X[5]
        + link->R_T[3] * tip->X[0] + link->R_T[4] * tip->X[1];
    const six_link_real V_next_21 = t96 + link->R_T[5] * tip->X[2];
    const six_link_real t97 = J_TV_42 * tip->X[9] + J_TV_52 * tip->X[10] + J_TV_62 * tip->X[11]
        + link->R_T[3] * tip->X[6] + link->R_T[4] * tip->X[7];
    const six_link_real V_next_22 = t97 + link->R_T[5] * tip->X[8];
    const six_link_real t98 = J_TV_42 * tip->X[15] + J_TV_52 * tip->X[16] + J_TV_62 * tip->X[17]
        + link->R_T[3] * tip->X[12] + link->R_T[4] * tip->X[13];
    const six_link_real V_next_23 = t98 + link->R_T[5] * tip->X[14];
    const six_link_real t99 = J_TV_42 * tip->X[21] + J_TV_52 * tip->X[22] + J_TV_62 * tip->X[23]
        + link->R_T[3] * tip->X[18] + link->R_T[4] * tip->X[19];
    const six_link_real V_next_24 = t99 + link->R_T[5] * tip->X[20];
    const six_link_real t100 = J_TV_42 * tip->X[27] + J_TV_52 * tip->X[28] + J_TV_62 * tip->X[29]
        + link->R_T[3] * tip->X[24] + link->R_T[4] * tip->X[25];
    const six_link_real V_next_25 = t100 + link->R_T[5] * tip->X[26];
    const six_link_real t101 = J_TV_42 * tip->X[33] + J_TV_52 * tip->X[34] + J_TV_62 * tip->X[35]
        + link->R_T[3] * tip->X[30] + link->R_T[4] * tip->X[31];
    const six_link_real V_next_26 = t101 + link->R_T[5] * tip->X[32];
    const six_link_real t102 = J_TV_43 * tip->X[3] + J_TV_53 * tip->X[4] + J_TV_63 * tip->X[5]
        + link->R_T[6] * tip->X[0] + link->R_T[7] * tip->X[1];
    const six_link_real V_next_31 = t102 + link->R_T[8] * tip->X[2];
    const six_link_real t103 = J_TV_43 * tip->X[9] + J_TV_53 * tip->X[10] + J_TV_63 * tip->X[11]
        + link->R_T[6] * tip->X[6] + link->R_T[7] * tip->X[7];
    const six_link_real V_next_32 = t103 + link->R_T[8] * tip->X[8];
    const six_link_real t104 = J_TV_43 * tip->X[15] + J_TV_53 * tip->X[16] + J_TV_63 * tip->X[17]
        + link->R_T[6] * tip->X[12] + link->R_T[7] * tip->X[13];
    const six_link_real V_next_33 = t104 + link->R_T[8] * tip->X[14];
    const six_link_real t105 = J_TV_43 * tip->X[21] + J_TV_53 * tip->X[22] + J_TV_63 * tip->X[23]
        + link->R_T[6] * tip->X[18] + link->R_T[7] * tip->X[19];
    const six_link_real V_next_34 = t105 + link->R_T[8] * tip->X[20];
    const six_link_real t106 = J_TV_43 * tip->X[27] + J_TV_53 * tip->X[28] + J_TV_63 * tip->X[29]
        + link->R_T[6] * tip->X[24] + link->R_T[7] * tip->X[25];
    const six_link_real V_next_35 = t106 + link->R_T[8] * tip->X[26];
    const six_link_real t107 = J_TV_43 * tip->X[33] + J_TV_53 * tip->X[34] + J_TV_63 * tip->X[35]
        + link->R_T[6] * tip->X[30] + link->R_T[7] * tip->X[31];
    const six_link_real V_next_36 = t107 + link->R_T[8] * tip->X[32];
    const six_link_real V_next_41 = link->R_T[0] * tip->X[3] + link->R_T[1] * tip->X[4]
        + link->R_T[2] * tip->X[5];
    const six_link_real V_next_42 = link->R_T[0] * tip->X[9] + link->R_T[1] * tip->X[10]
        + link->R_T[2] * tip->X[11];
    const six_link_real V_next_43 = link->R_T[0] * tip->X[15] + link->R_T[1] * tip->X[16]
        + link->R_T[2] * tip->X[17];
    const six_link_real V_next_44 = link->R_T[0] * tip->X[21] + link->R_T[1] * tip->X[22]
        + link->R_T[2] * tip->X[23];
    const six_link_real V_next_45 = link->R_T[0] * tip->X[27] + link->R_T[1] * tip->X[28]
        + link->R_T[2] * tip->X[29];
    const six_link_real V_next_46 = link->R_T[0] * tip->X[33] + link->R_T[1] * tip->X[34]
        + link->R_T[2] * tip->X[35];
    const six_link_real V_next_51 = link->R_T[3] * tip->X[3] + link->R_T[4] * tip->X[4]
        + link->R_T[5] * tip->X[5];
    const six_link_real V_next_52 = link->R_T[3] * tip->X[9] + link->R_T[4] * tip->X[10]
        + link->R_T[5] * tip->X[11];
    const six_link_real V_next_53 = link->R_T[3] * tip->X[15] + link->R_T[4] * tip->X[16]
        + link->R_T[5] * tip->X[17];
    const six_link_real V_next_54 = link->R_T[3] * tip->X[21] + link->R_T[4] * tip->X[22]
        + link->R_T[5] * tip->X[23];
    const six_link_real V_next_55 = link->R_T[3] * tip->X[27] + link->R_T[4] * tip->X[28]
        + link->R_T[5] * tip->X[29];
    const six_link_real V_next_56 = link->R_T[3] * tip->X[33] + link->R_T[4] * tip->X[34]
        + link->R_T[5] * tip->X[35];
    const six_link_real V_next_61 = link->R_T[6] * tip->X[3] + link->R_T[7] * tip->X[4]
        + link->R_T[8] * tip->X[5];
    const six_link_real V_next_62 = link->R_T[6] * tip->X[9] + link->R_T[7] * tip->X[10]
        + link->R_T[8] * tip->X[11];
    const six_link_real V_next_63 = link->R_T[6] * tip->X[15] + link->R_T[7] * tip->X[16]
        + link->R_T[8] * tip->X[17];
    const six_link_real V_next_64 = link->R_T[6] * tip->X[21] + link->R_T[7] * tip->X[22]
        + link->R_T[8] * tip->X[23];
    const six_link_real V_next_65 = link->R_T[6] * tip->X[27] + link->R_T[7] * tip->X[28]
        + link->R_T[8] * tip->X[29];
    const six_link_real V_next_66 = link->R_T[6] * tip->X[33] + link->R_T[7] * tip->X[34]
        + link->R_T[8] * tip->X[35];

    /* eta_next: modal rows, columns of the next joint's wrench (100) */
    const six_link_real t108 = J_Teta_11 * tip->X[0] + J_Teta_21 * tip->X[1] + J_Teta_31 * tip->X[2]
        + J_Teta_41 * tip->X[3] + J_Teta_51 * tip->X[4];
    const six_link_real eta_next_11 = t108 + J_Teta_61 * tip->X[5];
    const six_link_real t109 = J_Teta_11 * tip->X[6] + J_Teta_21 * tip->X[7] + J_Teta_31 * tip->X[8]
        + J_Teta_41 * tip->X[9] + J_Teta_51 * tip->X[10];
    const six_link_real eta_next_12 = t109 + J_Teta_61 * tip->X[11];
    const six_link_real t110 = J_Teta_11 * tip->X[12] + J_Teta_21 * tip->X[13] + J_Teta_31 * tip->X[14]
        + J_Teta_41 * tip->X[15];
    const six_link_real eta_next_13 = t110 + J_Teta_51 * tip->X[16] + J_Teta_61 * tip->X[17];
    const six_link_real t111 = J_Teta_11 * tip->X[18] + J_Teta_21 * tip->X[19] + J_Teta_31 * tip->X[20]
        + J_Teta_41 * tip->X[21];
    const six_link_real eta_next_14 = t111 + J_Teta_51 * tip->X[22] + J_Teta_61 * tip->X[23];
    const six_link_real t112 = J_Teta_11 * tip->X[24] + J_Teta_21 * tip->X[25] + J_Teta_31 * tip->X[26]
        + J_Teta_41 * tip->X[27];
    const six_link_real eta_next_15 = t112 + J_Teta_51 * tip->X[28] + J_Teta_61 * tip->X[29];
    const six_link_real t113 = J_Teta_11 * tip->X[30] + J_Teta_21 * tip->X[31] + J_Teta_31 * tip->X[32]
        + J_Teta_41 * tip->X[33];
    const six_link_real eta_next_16 = t113 + J_Teta_51 * tip->X[34] + J_Teta_61 * tip->X[35];
    const six_link_real t114 = J_Teta_12 * tip->X[0] + J_Teta_22 * tip->X[1] + J_Teta_32 * tip->X[2]
        + J_Teta_42 * tip->X[3] + J_Teta_52 * tip->X[4];
    const six_link_real eta_next_21 = t114 + J_Teta_62 * tip->X[5];
    const six_link_real t115 = J_Teta_12 * tip->X[6] + J_Teta_22 * tip->X[7] + J_Teta_32 * tip->X[8]
        + J_Teta_42 * tip->X[9] + J_Teta_52 * tip->X[10];
    const six_link_real eta_next_22 = t115 + J_Teta_62 * tip->X[11];
    const six_link_real t116 = J_Teta_12 * tip->X[12] + J_Teta_22 * tip->X[13] + J_Teta_32 * tip->X[14]
        + J_Teta_42 * tip->X[15];
    const six_link_real eta_next_23 = t116 + J_Teta_52 * tip->X[16] + J_Teta_62 * tip->X[17];
    const six_link_real t117 = J_Teta_12 * tip->X[18] + J_Teta_22 * tip->X[19] + J_Teta_32 * tip->X[20]
        + J_Teta_42 * tip->X[21];
    const six_link_real eta_next_24 = t117 + J_Teta_52 * tip->X[22] + J_Teta_62 * tip->X[23];
    const six_link_real t118 = J_Teta_12 * tip->X[24] + J_Teta_22 * tip->X[25] + J_Teta_32 * tip->X[26]
        + J_Teta_42 * tip->X[27];
    const six_link_real eta_next_25 = t118 + J_Teta_52 * tip->X[28] + J_Teta_62 * tip->X[29];
    const six_link_real t119 = J_Teta_12 * tip->X[30] + J_Teta_22 * tip->X[31] + J_Teta_32 * tip->X[32]
        + J_Teta_42 * tip->X[33];
    const six_link_real eta_next_26 = t119 + J_Teta_52 * tip->X[34] + J_Teta_62 * tip->X[35];
    const six_link_real eta_next_31 = J_Teta_13 * tip->X[0] + J_Teta_23 * tip->X[1] + J_Teta_33 * tip->X[2];
    const six_link_real eta_next_32 = J_Teta_13 * tip->X[6] + J_Teta_23 * tip->X[7] + J_Teta_33 * tip->X[8];
    const six_link_real eta_next_33 = J_Teta_13 * tip->X[12] + J_Teta_23 * tip->X[13] + J_Teta_33 * tip->X[14];
    const six_link_real eta_next_34 = J_Teta_13 * tip->X[18] + J_Teta_23 * tip->X[19] + J_Teta_33 * tip->X[20];
    const six_link_real eta_next_35 = J_Teta_13 * tip->X[24] + J_Teta_23 * tip->X[25] + J_Teta_33 * tip->X[26];
    const six_link_real eta_next_36 = J_Teta_13 * tip->X[30] + J_Teta_23 * tip->X[31] + J_Teta_33 * tip->X[32];

    /* next_V: next joint's rows, twist columns (100) */
    const six_link_real t120 = J_TV_41 * tip->PX[3] + J_TV_51 * tip->PX[4] + J_TV_61 * tip->PX[5]
        + tip->PX[0] * link->R_T[0] + tip->PX[1] * link->R_T[1];
    const six_link_real minus_next_V_11 = t120 + tip->PX[2] * link->R_T[2];
    const six_link_real t121 = -minus_next_V_11;
    const six_link_real t122 = J_TV_42 * tip->PX[3] + J_TV_52 * tip->PX[4] + J_TV_62 * tip->PX[5]
        + tip->PX[0] * link->R_T[3] + tip->PX[1] * link->R_T[4];
    const six_link_real minus_next_V_12 = t122 + tip->PX[2] * link->R_T[5];
    const six_link_real t123 = -minus_next_V_12;
    const six_link_real t124 = J_TV_43 * tip->PX[3] + J_TV_53 * tip->PX[4] + J_TV_63 * tip->PX[5]
        + tip->PX[0] * link->R_T[6] + tip->PX[1] * link->R_T[7];
    const six_link_real minus_next_V_13 = t124 + tip->PX[2] * link->R_T[8];
    const six_link_real t125 = -minus_next_V_13;
    const six_link_real minus_next_V_14 = tip->PX[3] * link->R_T[0] + tip->PX[4] * link->R_T[1]
        + tip->PX[5] * link->R_T[2];
    const six_link_real t126 = -minus_next_V_14;
    const six_link_real minus_next_V_15 = tip->PX[3] * link->R_T[3] + tip->PX[4] * link->R_T[4]
        + tip->PX[5] * link->R_T[5];
    const six_link_real t127 = -minus_next_V_15;
    const six_link_real minus_next_V_16 = tip->PX[3] * link->R_T[6] + tip->PX[4] * link->R_T[7]
        + tip->PX[5] * link->R_T[8];
    const six_link_real t128 = -minus_next_V_16;
    const six_link_real t129 = J_TV_41 * tip->PX[9] + J_TV_51 * tip->PX[10] + J_TV_61 * tip->PX[11]
        + tip->PX[6] * link->R_T[0] + tip->PX[7] * link->R_T[1];
    const six_link_real minus_next_V_21 = t129 + tip->PX[8] * link->R_T[2];
    const six_link_real t130 = -minus_next_V_21;
    const six_link_real t131 = J_TV_42 * tip->PX[9] + J_TV_52 * tip->PX[10] + J_TV_62 * tip->PX[11]
        + tip->PX[6] * link->R_T[3] + tip->PX[7] * link->R_T[4];
    const six_link_real minus_next_V_22 = t131 + tip->PX[8] * link->R_T[5];
    const six_link_real t132 = -minus_next_V_22;
    const six_link_real t133 = J_TV_43 * tip->PX[9] + J_TV_53 * tip->PX[10] + J_TV_63 * tip->PX[11]
        + tip->PX[6] * link->R_T[6] + tip->PX[7] * link->R_T[7];
    const six_link_real minus_next_V_23 = t133 + tip->PX[8] * link->R_T[8];
    const six_link_real t134 = -minus_next_V_23;
    const six_link_real minus_next_V_24 = tip->PX[9] * link->R_T[0] + tip->PX[10] * link->R_T[1]
        + tip->PX[11] * link->R_T[2];
    const six_link_real t135 = -minus_next_V_24;
    const six_link_real minus_next_V_25 = tip->PX[9] * link->R_T[3] + tip->PX[10] * link->R_T[4]
        + tip->PX[11] * link->R_T[5];
    const six_link_real t136 = -minus_next_V_25;
    const six_link_real minus_next_V_26 = tip->PX[9] * link->R_T[6] + tip->PX[10] * link->R_T[7]
        + tip->PX[11] * link->R_T[8];
    const six_link_real t137 = -minus_next_V_26;
    const six_link_real t138 = J_TV_41 * tip->PX[15] + J_TV_51 * tip->PX[16] + J_TV_61 * tip->PX[17]
        + tip->PX[12] * link->R_T[0];
    const six_link_real minus_next_V_31 = t138 + tip->PX[13] * link->R_T[1] + tip->PX[14] * link->R_T[2];
    const six_link_real t139 = -minus_next_V_31;
    const six_link_real t140 = J_TV_42 * tip->PX[15] + J_TV_52 * tip->PX[16] + J_TV_62 * tip->PX[17]
        + tip->PX[12] * link->R_T[3];
    const six_link_real minus_next_V_32 = t140 + tip->PX[13] * link->R_T[4] + tip->PX[14] * link->R_T[5];
    const six_link_real t141 = -minus_next_V_32;
    const six_link_real t142 = J_TV_43 * tip->PX[15] + J_TV_53 * tip->PX[16] + J_TV_63 * tip->PX[17]
        + tip->PX[12] * link->R_T[6];
    const six_link_real minus_next_V_33 = t142 + tip->PX[13] * link->R_T[7] + tip->PX[14] * link->R_T[8];
    const six_link_real t143 = -minus_next_V_33;
    const six_link_real minus_next_V_34 = tip->PX[15] * link->R_T[0] + tip->PX[16] * link->R_T[1]
        + tip->PX[17] * link->R_T[2];
    const six_link_real t144 = -minus_next_V_34;
    const six_link_real minus_next_V_35 = tip->PX[15] * link->R_T[3] + tip->PX[16] * link->R_T[4]
        + tip->PX[17] * link->R_T[5];
    const six_link_real t145 = -minus_next_V_35;
    const six_link_real minus_next_V_36 = tip->PX[15] * link->R_T[6] + tip->PX[16] * link->R_T[7]
        + tip->PX[17] * link->R_T[8];
    const six_link_real t146 = -minus_next_V_36;
    const six_link_real t147 = J_TV_41 * tip->PX[21] + J_TV_51 * tip->PX[22] + J_TV_61 * tip->PX[23]
        + tip->PX[18] * link->R_T[0];
    const six_link_real minus_next_V_41 = t147 + tip->PX[19] * link->R_T[1] + tip->PX[20] * link->R_T[2];
    const six_link_real t148 = -minus_next_V_41;
    const six_link_real t149 = J_TV_42 * tip->PX[21] + J_TV_52 * tip->PX[22] + J_TV_62 * tip->PX[23]
        + tip->PX[18] * link->R_T[3];
    const six_link_real minus_next_V_42 = t149 + tip->PX[19] * link->R_T[4] + tip->PX[20] * link->R_T[5];
    const six_link_real t150 = -minus_next_V_42;
    const six_link_real t151 = J_TV_43 * tip->PX[21] + J_TV_53 * tip->PX[22] + J_TV_63 * tip->PX[23]
        + tip->PX[18] * link->R_T[6];
    const six_link_real minus_next_V_43 = t151 + tip->PX[19] * link->R_T[7] + tip->PX[20] * link->R_T[8];
    const six_link_real t152 = -minus_next_V_43;
    const six_link_real minus_next_V_44 = tip->PX[21] * link->R_T[0] + tip->PX[22] * link->R_T[1]
        + tip->PX[23] * link->R_T[2];
    const six_link_real t153 = -minus_next_V_44;
    const six_link_real minus_next_V_45 = tip->PX[21] * link->R_T[3] + tip->PX[22] * link->R_T[4]
        + tip->PX[23] * link->R_T[5];
    const six_link_real t154 = -minus_next_V_45;
    const six_link_real minus_next_V_46 = tip->PX[21] * link->R_T[6] + tip->PX[22] * link->R_T[7]
        + tip->PX[23] * link->R_T[8];
    const six_link_real t155 = -minus_next_V_46;
    const six_link_real t156 = J_TV_41 * tip->PX[27] + J_TV_51 * tip->PX[28] + J_TV_61 * tip->PX[29]
        + tip->PX[24] * link->R_T[0];
    const six_link_real minus_next_V_51 = t156 + tip->PX[25] * link->R_T[1] + tip->PX[26] * link->R_T[2];
    const six_link_real t157 = -minus_next_V_51;
    const six_link_real t158 = J_TV_42 * tip->PX[27] + J_TV_52 * tip->PX[28] + J_TV_62 * tip->PX[29]
        + tip->PX[24] * link->R_T[3];
    const six_link_real minus_next_V_52 = t158 + tip->PX[25] * link->R_T[4] + tip->PX[26] * link->R_T[5];
    const six_link_real t159 = -minus_next_V_52;
    const six_link_real t160 = J_TV_43 * tip->PX[27] + J_TV_53 * tip->PX[28] + J_TV_63 * tip->PX[29]
        + tip->PX[24] * link->R_T[6];
    const six_link_real minus_next_V_53 = t160 + tip->PX[25] * link->R_T[7] + tip->PX[26] * link->R_T[8];
    const six_link_real t161 = -minus_next_V_53;
    const six_link_real minus_next_V_54 = tip->PX[27] * link->R_T[0] + tip->PX[28] * link->R_T[1]
        + tip->PX[29] * link->R_T[2];
    const six_link_real t162 = -minus_next_V_54;
    const six_link_real minus_next_V_55 = tip->PX[27] * link->R_T[3] + tip->PX[28] * link->R_T[4]
        + tip->PX[29] * link->R_T[5];
    const six_link_real t163 = -minus_next_V_55;
    const six_link_real minus_next_V_56 = tip->PX[27] * link->R_T[6] + tip->PX[28] * link->R_T[7]
        + tip->PX[29] * link->R_T[8];
    const six_link_real t164 = -minus_next_V_56;
    const six_link_real t165 = J_TV_41 * tip->PX[33] + J_TV_51 * tip->PX[34] + J_TV_61 * tip->PX[35]
        + tip->PX[30] * link->R_T[0];
    const six_link_real minus_next_V_61 = t165 + tip->PX[31] * link->R_T[1] + tip->PX[32] * link->R_T[2];
    const six_link_real t166 = -minus_next_V_61;
    const six_link_real t167 = J_TV_42 * tip->PX[33] + J_TV_52 * tip->PX[34] + J_TV_62 * tip->PX[35]
        + tip->PX[30] * link->R_T[3];
    const six_link_real minus_next_V_62 = t167 + tip->PX[31] * link->R_T[4] + tip->PX[32] * link->R_T[5];
    const six_link_real t168 = -minus_next_V_62;
    const six_link_real t169 = J_TV_43 * tip->PX[33] + J_TV_53 * tip->PX[34] + J_TV_63 * tip->PX[35]
        + tip->PX[30] * link->R_T[6];
    const six_link_real minus_next_V_63 = t169 + tip->PX[31] * link->R_T[7] + tip->PX[32] * link->R_T[8];
    const six_link_real t170 = -minus_next_V_63;
    const six_link_real minus_next_V_64 = tip->PX[33] * link->R_T[0] + tip->PX[34] * link->R_T[1]
        + tip->PX[35] * link->R_T[2];
    const six_link_real t171 = -minus_next_V_64;
    const six_link_real minus_next_V_65 = tip->PX[33] * link->R_T[3] + tip->PX[34] * link->R_T[4]
        + tip->PX[35] * link->R_T[5];
    const six_link_real t172 = -minus_next_V_65;
    const six_link_real minus_next_V_66 = tip->PX[33] * link->R_T[6] + tip->PX[34] * link->R_T[7]
        + tip->PX[35] * link->R_T[8];
    const six_link_real t173 = -minus_next_V_66;

    /* next_eta: next joint's rows, modal columns (100) */
    const six_link_real t174 = J_Teta_11 * tip->PX[0] + J_Teta_21 * tip->PX[1] + J_Teta_31 * tip->PX[2]
        + J_Teta_41 * tip->PX[3];
    const six_link_real minus_next_eta_11 = t174 + J_Teta_51 * tip->PX[4] + J_Teta_61 * tip->PX[5];
    const six_link_real t175 = -minus_next_eta_11;
    const six_link_real t176 = J_Teta_12 * tip->PX[0] + J_Teta_22 * tip->PX[1] + J_Teta_32 * tip->PX[2]
        + J_Teta_42 * tip->PX[3];
    const six_link_real minus_next_eta_12 = t176 + J_Teta_52 * tip->PX[4] + J_Teta_62 * tip->PX[5];
    const six_link_real t177 = -minus_next_eta_12;
    const six_link_real minus_next_eta_13 = J_Teta_13 * tip->PX[0] + J_Teta_23 * tip->PX[1]
        + J_Teta_33 * tip->PX[2];
    const six_link_real t178 = -minus_next_eta_13;
    const six_link_real t179 = J_Teta_11 * tip->PX[6] + J_Teta_21 * tip->PX[7] + J_Teta_31 * tip->PX[8]
        + J_Teta_41 * tip->PX[9];
    const six_link_real minus_next_eta_21 = t179 + J_Teta_51 * tip->PX[10] + J_Teta_61 * tip->PX[11];
    const six_link_real t180 = -minus_next_eta_21;
    const six_link_real t181 = J_Teta_12 * tip->PX[6] + J_Teta_22 * tip->PX[7] + J_Teta_32 * tip->PX[8]
        + J_Teta_42 * tip->PX[9];
    const six_link_real minus_next_eta_22 = t181 + J_Teta_52 * tip->PX[10] + J_Teta_62 * tip->PX[11];
    const six_link_real t182 = -minus_next_eta_22;
    const six_link_real minus_next_eta_23 = J_Teta_13 * tip->PX[6] + J_Teta_23 * tip->PX[7]
        + J_Teta_33 * tip->PX[8];
    const six_link_real t183 = -minus_next_eta_23;
    const six_link_real t184 = J_Teta_11 * tip->PX[12] + J_Teta_21 * tip->PX[13] + J_Teta_31 * tip->PX[14]
        + J_Teta_41 * tip->PX[15];
    const six_link_real minus_next_eta_31 = t184 + J_Teta_51 * tip->PX[16] + J_Teta_61 * tip->PX[17];
    const six_link_real t185 = -minus_next_eta_31;
    const six_link_real t186 = J_Teta_12 * tip->PX[12] + J_Teta_22 * tip->PX[13] + J_Teta_32 * tip->PX[14]
        + J_Teta_42 * tip->PX[15];
    const six_link_real minus_next_eta_32 = t186 + J_Teta_52 * tip->PX[16] + J_Teta_62 * tip->PX[17];
    const six_link_real t187 = -minus_next_eta_32;
    const six_link_real minus_next_eta_33 = J_Teta_13 * tip->PX[12] + J_Teta_23 * tip->PX[13]
        + J_Teta_33 * tip->PX[14];
    const six_link_real t188 = -minus_next_eta_33;
    const six_link_real t189 = J_Teta_11 * tip->PX[18] + J_Teta_21 * tip->PX[19] + J_Teta_31 * tip->PX[20]
        + J_Teta_41 * tip->PX[21];
    const six_link_real minus_next_eta_41 = t189 + J_Teta_51 * tip->PX[22] + J_Teta_61 * tip->PX[23];
    const six_link_real t190 = -minus_next_eta_41;
    const six_link_real t191 = J_Teta_12 * tip->PX[18] + J_Teta_22 * tip->PX[19] + J_Teta_32 * tip->PX[20]
        + J_Teta_42 * tip->PX[21];
    const six_link_real minus_next_eta_42 = t191 + J_Teta_52 * tip->PX[22] + J_Teta_62 * tip->PX[23];
    const six_link_real t192 = -minus_next_eta_42;
    const six_link_real minus_next_eta_43 = J_Teta_13 * tip->PX[18] + J_Teta_23 * tip->PX[19]
        + J_Teta_33 * tip->PX[20];
    const six_link_real t193 = -minus_next_eta_43;
    const six_link_real t194 = J_Teta_11 * tip->PX[24] + J_Teta_21 * tip->PX[25] + J_Teta_31 * tip->PX[26]
        + J_Teta_41 * tip->PX[27];
    const six_link_real minus_next_eta_51 = t194 + J_Teta_51 * tip->PX[28] + J_Teta_61 * tip->PX[29];
    const six_link_real t195 = -minus_next_eta_51;
    const six_link_real t196 = J_Teta_12 * tip->PX[24] + J_Teta_22 * tip->PX[25] + J_Teta_32 * tip->PX[26]
        + J_Teta_42 * tip->PX[27];
    const six_link_real minus_next_eta_52 = t196 + J_Teta_52 * tip->PX[28] + J_Teta_62 * tip->PX[29];
    const six_link_real t197 = -minus_next_eta_52;
    const six_link_real minus_next_eta_53 = J_Teta_13 * tip->PX[24] + J_Teta_23 * tip->PX[25]
        + J_Teta_33 * tip->PX[26];
    const six_link_real t198 = -minus_next_eta_53;
    const six_link_real t199 = J_Teta_11 * tip->PX[30] + J_Teta_21 * tip->PX[31] + J_Teta_31 * tip->PX[32]
        + J_Teta_41 * tip->PX[33];
    const six_link_real minus_next_eta_61 = t199 + J_Teta_51 * tip->PX[34] + J_Teta_61 * tip->PX[35];
    const six_link_real t200 = -minus_next_eta_61;
    const six_link_real t201 = J_Teta_12 * tip->PX[30] + J_Teta_22 * tip->PX[31] + J_Teta_32 * tip->PX[32]
        + J_Teta_42 * tip->PX[33];
    const six_link_real minus_next_eta_62 = t201 + J_Teta_52 * tip->PX[34] + J_Teta_62 * tip->PX[35];
    const six_link_real t202 = -minus_next_eta_62;
    const six_link_real minus_next_eta_63 = J_Teta_13 * tip->PX[30] + J_Teta_23 * tip->PX[31]
        + J_Teta_33 * tip->PX[32];
    const six_link_real t203 = -minus_next_eta_63;

    /* h_carried: bias of the bodies at the tip, its acceleration bias included */
    const six_link_real t204 = link->h_T[0] + c->I_T_xx * link->b_T[0] - c->J_T_xy * link->b_T[1]
        - c->J_T_xz * link->b_T[2] - c->S_T_z * link->b_T[4];
    const six_link_real h_carried_1 = t204 + c->S_T_y * link->b_T[5];
    const six_link_real t205 = link->h_T[1] - c->J_T_xy * link->b_T[0] + c->I_T_yy * link->b_T[1]
        - c->J_T_yz * link->b_T[2] + c->S_T_z * link->b_T[3];
    const six_link_real h_carried_2 = t205 - c->S_T_x * link->b_T[5];
    const six_link_real t206 = link->h_T[2] - c->J_T_xz * link->b_T[0] - c->J_T_yz * link->b_T[1]
        + c->I_T_zz * link->b_T[2] - c->S_T_y * link->b_T[3];
    const six_link_real h_carried_3 = t206 + c->S_T_x * link->b_T[4];
    const six_link_real h_carried_4 = link->h_T[3] + c->S_T_z * link->b_T[1] - c->S_T_y * link->b_T[2]
        + c->body0_mass * link->b_T[3];
    const six_link_real h_carried_5 = link->h_T[4] - c->S_T_z * link->b_T[0] + c->S_T_x * link->b_T[2]
        + c->body0_mass * link->b_T[4];
    const six_link_real h_carried_6 = link->h_T[5] + c->S_T_y * link->b_T[0] - c->S_T_x * link->b_T[1]
        + c->body0_mass * link->b_T[5];

    /* V_H: bias of the twist rows (100) */
    const six_link_real t207 = link->h_V[0] + J_TV_41 * h_carried_4 + J_TV_51 * h_carried_5
        + J_TV_61 * h_carried_6 + link->R_T[0] * h_carried_1;
    const six_link_real V_H_1 = t207 + link->R_T[1] * h_carried_2 + link->R_T[2] * h_carried_3;
    const six_link_real t208 = link->h_V[1] + J_TV_42 * h_carried_4 + J_TV_52 * h_carried_5
        + J_TV_62 * h_carried_6 + link->R_T[3] * h_carried_1;
    const six_link_real V_H_2 = t208 + link->R_T[4] * h_carried_2 + link->R_T[5] * h_carried_3;
    const six_link_real t209 = link->h_V[2] + J_TV_43 * h_carried_4 + J_TV_53 * h_carried_5
        + J_TV_63 * h_carried_6 + link->R_T[6] * h_carried_1;
    const six_link_real V_H_3 = t209 + link->R_T[7] * h_carried_2 + link->R_T[8] * h_carried_3;
    const six_link_real V_H_4 = link->h_V[3] + link->R_T[0] * h_carried_4 + link->R_T[1] * h_carried_5
        + link->R_T[2] * h_carried_6;
    const six_link_real V_H_5 = link->h_V[4] + link->R_T[3] * h_carried_4 + link->R_T[4] * h_carried_5
        + link->R_T[5] * h_carried_6;
    const six_link_real V_H_6 = link->h_V[5] + link->R_T[6] * h_carried_4 + link->R_T[7] * h_carried_5
        + link->R_T[8] * h_carried_6;

    /* eta_H: bias of the modal rows (100) */
    const six_link_real t210 = t1 + J_Teta_11 * h_carried_1 + J_Teta_21 * h_carried_2 + J_Teta_31 * h_carried_3
        + J_Teta_41 * h_carried_4;
    const six_link_real eta_H_1 = t210 + J_Teta_51 * h_carried_5 + J_Teta_61 * h_carried_6;
    const six_link_real t211 = t2 + J_Teta_12 * h_carried_1 + J_Teta_22 * h_carried_2 + J_Teta_32 * h_carried_3
        + J_Teta_42 * h_carried_4;
    const six_link_real eta_H_2 = t211 + J_Teta_52 * h_carried_5 + J_Teta_62 * h_carried_6;
    const six_link_real eta_H_3 = f_eta[2] + J_Teta_13 * h_carried_1 + J_Teta_23 * h_carried_2
        + J_Teta_33 * h_carried_3;

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real t212 = J_TV_41 * w_ext[3] + J_TV_51 * w_ext[4] + J_TV_61 * w_ext[5]
        + link->R_T[0] * w_ext[0] + link->R_T[1] * w_ext[1];
    const six_link_real V_W_1 = t212 + link->R_T[2] * w_ext[2];
    const six_link_real t213 = J_TV_42 * w_ext[3] + J_TV_52 * w_ext[4] + J_TV_62 * w_ext[5]
        + link->R_T[3] * w_ext[0] + link->R_T[4] * w_ext[1];
    const six_link_real V_W_2 = t213 + link->R_T[5] * w_ext[2];
    const six_link_real t214 = J_TV_43 * w_ext[3] + J_TV_53 * w_ext[4] + J_TV_63 * w_ext[5]
        + link->R_T[6] * w_ext[0] + link->R_T[7] * w_ext[1];
    const six_link_real V_W_3 = t214 + link->R_T[8] * w_ext[2];
    const six_link_real V_W_4 = link->R_T[0] * w_ext[3] + link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5];
    const six_link_real V_W_5 = link->R_T[3] * w_ext[3] + link->R_T[4] * w_ext[4] + link->R_T[5] * w_ext[5];
    const six_link_real V_W_6 = link->R_T[6] * w_ext[3] + link->R_T[7] * w_ext[4] + link->R_T[8] * w_ext[5];

    /* eta_W: external wrench in the modal rows (100) */
    const six_link_real t215 = J_Teta_11 * w_ext[0] + J_Teta_21 * w_ext[1] + J_Teta_31 * w_ext[2]
        + J_Teta_41 * w_ext[3] + J_Teta_51 * w_ext[4];
    const six_link_real eta_W_1 = t215 + J_Teta_61 * w_ext[5];
    const six_link_real t216 = J_Teta_12 * w_ext[0] + J_Teta_22 * w_ext[1] + J_Teta_32 * w_ext[2]
        + J_Teta_42 * w_ext[3] + J_Teta_52 * w_ext[4];
    const six_link_real eta_W_2 = t216 + J_Teta_62 * w_ext[5];
    const six_link_real eta_W_3 = J_Teta_13 * w_ext[0] + J_Teta_23 * w_ext[1] + J_Teta_33 * w_ext[2];

    /* outputs */
    M[place[7]] = t121;
    M[place[8]] = t123;
    M[place[9]] = t125;
    M[place[10]] = t126;
    M[place[11]] = t127;
    M[place[12]] = t128;
    M[place[13]] = t130;
    M[place[14]] = t132;
    M[place[15]] = t134;
    M[place[16]] = t135;
    M[place[17]] = t136;
    M[place[18]] = t137;
    M[place[19]] = t139;
    M[place[20]] = t141;
    M[place[21]] = t143;
    M[place[22]] = t144;
    M[place[23]] = t145;
    M[place[24]] = t146;
    M[place[25]] = t148;
    M[place[26]] = t150;
    M[place[27]] = t152;
    M[place[28]] = t153;
    M[place[29]] = t154;
    M[place[30]] = t155;
    M[place[31]] = t157;
    M[place[32]] = t159;
    M[place[33]] = t161;
    M[place[34]] = t162;
    M[place[35]] = t163;
    M[place[36]] = t164;
    M[place[37]] = t166;
    M[place[38]] = t168;
    M[place[39]] = t170;
    M[place[40]] = t171;
    M[place[41]] = t172;
    M[place[42]] = t173;
    M[place[43]] = t175;
    M[place[44]] = t177;
    M[place[45]] = t178;
    M[place[46]] = t180;
    M[place[47]] = t182;
    M[place[48]] = t183;
    M[place[49]] = t185;
    M[place[50]] = t187;
    M[place[51]] = t188;
    M[place[52]] = t190;
    M[place[53]] = t192;
    M[place[54]] = t193;
    M[place[55]] = t195;
    M[place[56]] = t197;
    M[place[57]] = t198;
    M[place[58]] = t200;
    M[place[59]] = t202;
    M[place[60]] = t203;
    M[place[61]] = -1;
    M[place[62]] = -1;
    M[place[63]] = -1;
    M[place[64]] = -1;
    M[place[65]] = -1;
    M[place[66]] = -1;
    M[place[67]] = V_V_11;
    M[place[68]] = V_V_12;
    M[place[69]] = V_V_13;
    M[place[70]] = V_V_14;
    M[place[71]] = V_V_15;
    M[place[72]] = V_V_16;
    M[place[73]] = V_V_12;
    M[place[74]] = V_V_22;
    M[place[75]] = V_V_23;
    M[place[76]] = V_V_24;
    M[place[77]] = V_V_25;
    M[place[78]] = V_V_26;
    M[place[79]] = V_V_13;
    M[place[80]] = V_V_23;
    M[place[81]] = V_V_33;
    M[place[82]] = V_V_34;
    M[place[83]] = V_V_35;
    M[place[84]] = V_V_36;
    M[place[85]] = V_V_14;
    M[place[86]] = V_V_24;
    M[place[87]] = V_V_34;
    M[place[88]] = V_V_44;
    M[place[89]] = V_V_45;
    M[place[90]] = V_V_46;
    M[place[91]] = V_V_15;
    M[place[92]] = V_V_25;
    M[place[93]] = V_V_35;
    M[place[94]] = V_V_45;
    M[place[95]] = V_V_55;
    M[place[96]] = V_V_56;
    M[place[97]] = V_V_16;
    M[place[98]] = V_V_26;
    M[place[99]] = V_V_36;
    M[place[100]] = V_V_46;
    M[place[101]] = V_V_56;
    M[place[102]] = V_V_66;
    M[place[103]] = V_eta_11;
    M[place[104]] = V_eta_12;
    M[place[105]] = V_eta_13;
    M[place[106]] = V_eta_21;
    M[place[107]] = V_eta_22;
    M[place[108]] = V_eta_23;
    M[place[109]] = V_eta_31;
    M[place[110]] = V_eta_32;
    M[place[111]] = V_eta_33;
    M[place[112]] = V_eta_41;
    M[place[113]] = V_eta_42;
    M[place[114]] = V_eta_43;
    M[place[115]] = V_eta_51;
    M[place[116]] = V_eta_52;
    M[place[117]] = V_eta_53;
    M[place[118]] = V_eta_61;
    M[place[119]] = V_eta_62;
    M[place[120]] = V_eta_63;
    M[place[121]] = V_next_11;
    M[place[122]] = V_next_12;
    M[place[123]] = V_next_13;
    M[place[124]] = V_next_14;
    M[place[125]] = V_next_15;
    M[place[126]] = V_next_16;
    M[place[127]] = V_next_21;
    M[place[128]] = V_next_22;
    M[place[129]] = V_next_23;
    M[place[130]] = V_next_24;
    M[place[131]] = V_next_25;
    M[place[132]] = V_next_26;
    M[place[133]] = V_next_31;
    M[place[134]] = V_next_32;
    M[place[135]] = V_next_33;
    M[place[136]] = V_next_34;
    M[place[137]] = V_next_35;
    M[place[138]] = V_next_36;
    M[place[139]] = V_next_41;
    M[place[140]] = V_next_42;
    M[place[141]] = V_next_43;
    M[place[142]] = V_next_44;
    M[place[143]] = V_next_45;
    M[place[144]] = V_next_46;
    M[place[145]] = V_next_51;
    M[place[146]] = V_next_52;
    M[place[147]] = V_next_53;
    M[place[148]] = V_next_54;
    M[place[149]] = V_next_55;
    M[place[150]] = V_next_56;
    M[place[151]] = V_next_61;
    M[place[152]] = V_next_62;
    M[place[153]] = V_next_63;
    M[place[154]] = V_next_64;
    M[place[155]] = V_next_65;
    M[place[156]] = V_next_66;
    M[place[157]] = V_eta_11;
    M[place[158]] = V_eta_21;
    M[place[159]] = V_eta_31;
    M[place[160]] = V_eta_41;
    M[place[161]] = V_eta_51;
    M[place[162]] = V_eta_61;
    M[place[163]] = V_eta_12;
    M[place[164]] = V_eta_22;
    M[place[165]] = V_eta_32;
    M[place[166]] = V_eta_42;
    M[place[167]] = V_eta_52;
    M[place[168]] = V_eta_62;
    M[place[169]] = V_eta_13;
    M[place[170]] = V_eta_23;
    M[place[171]] = V_eta_33;
    M[place[172]] = V_eta_43;
    M[place[173]] = V_eta_53;
    M[place[174]] = V_eta_63;
    M[place[175]] = eta_eta_11;
    M[place[176]] = eta_eta_12;
    M[place[177]] = eta_eta_13;
    M[place[178]] = eta_eta_12;
    M[place[179]] = eta_eta_22;
    M[place[180]] = eta_eta_23;
    M[place[181]] = eta_eta_13;
    M[place[182]] = eta_eta_23;
    M[place[183]] = eta_eta_33;
    M[place[184]] = eta_next_11;
    M[place[185]] = eta_next_12;
    M[place[186]] = eta_next_13;
    M[place[187]] = eta_next_14;
    M[place[188]] = eta_next_15;
    M[place[189]] = eta_next_16;
    M[place[190]] = eta_next_21;
    M[place[191]] = eta_next_22;
    M[place[192]] = eta_next_23;
    M[place[193]] = eta_next_24;
    M[place[194]] = eta_next_25;
    M[place[195]] = eta_next_26;
    M[place[196]] = eta_next_31;
    M[place[197]] = eta_next_32;
    M[place[198]] = eta_next_33;
    M[place[199]] = eta_next_34;
    M[place[200]] = eta_next_35;
    M[place[201]] = eta_next_36;
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
    return SIX_LINK_OK;
}

/* link rows, links like forearm: 997 operations */
static six_link_status link_rows_forearm(const six_link_link_constants *c, const six_link_link_store *link, const six_link_node *tip,
    const six_link_real m_eta[2], const six_link_real f_eta[2], const six_link_real w_ext[6],
    six_link_real eta_H[2], six_link_real eta_W[2], const int *place, six_link_real *M,
    six_link_real H[12], six_link_real W[12])
{

    const six_link_real t1 = -link->M_V[1];
    const six_link_real t2 = -link->M_V[2];
    const six_link_real t3 = -link->M_V[3];
    const six_link_real t4 = -link->M_V[6];
    const six_link_real t5 = -c->S_0_x;
    const six_link_real t6 = -link->M_V[4];
    const six_link_real t7 = -link->M_D[0];
    const six_link_real t8 = -c->chi_2;
    const six_link_real eta_H_1 = link->h_eta[0] + f_eta[0];
    const six_link_real eta_H_2 = link->h_eta[1] + f_eta[1];

    /* J_TV: twist of the tip section from that of F_i (46) */
    const six_link_real t9 = link->R_T[2] * link->r_T[0];
    const six_link_real t10 = link->R_T[1] * link->r_T[1];
    const six_link_real minus_J_TV_41 = t9 + t10;
    const six_link_real J_TV_42 = link->R_T[0] * link->r_T[1] + link->R_T[2] * c->length;
    const six_link_real J_TV_43 = link->R_T[1] * c->length - link->R_T[0] * link->r_T[0];
    const six_link_real J_TV_51 = link->R_T[4] * link->r_T[0] - link->R_T[3] * link->r_T[1];
    const six_link_real t11 = link->R_T[4] * c->length;
    const six_link_real minus_J_TV_52 = t10 + t11;
    const six_link_real J_TV_53 = link->R_T[3] * c->length + link->R_T[1] * link->r_T[0];
    const six_link_real J_TV_61 = link->R_T[5] * link->r_T[0] - link->R_T[4] * link->r_T[1];
    const six_link_real J_TV_62 = link->R_T[2] * link->r_T[1] - link->R_T[5] * c->length;
    const six_link_real J_TV_63 = t11 - t9;

    /* J_Teta: twist of the tip section from the modal rates (46) */
    const six_link_real t12 = link->G[2] * c->Psi_c_z1;
    const six_link_real t13 = link->G[4] * c->Psi_c_z1;
    const six_link_real t14 = link->G[5] * c->Psi_c_z1;
    const six_link_real J_Teta_11 = link->R_T[0] * t12 + link->R_T[1] * t13 - link->R_T[2] * t14;
    const six_link_real t15 = link->G[1] * c->Psi_c_y2;
    const six_link_real t16 = link->G[3] * c->Psi_c_y2;
    const six_link_real t17 = link->G[4] * c->Psi_c_y2;
    const six_link_real J_Teta_12 = link->R_T[1] * t16 - link->R_T[0] * t15 - link->R_T[2] * t17;
    const six_link_real J_Teta_21 = link->R_T[3] * t13 - link->R_T[1] * t12 + link->R_T[4] * t14;
    const six_link_real J_Teta_22 = link->R_T[1] * t15 + link->R_T[3] * t16 + link->R_T[4] * t17;
    const six_link_real J_Teta_31 = link->R_T[2] * t12 + link->R_T[4] * t13 + link->R_T[5] * t14;
    const six_link_real J_Teta_32 = link->R_T[4] * t16 - link->R_T[2] * t15 + link->R_T[5] * t17;
    const six_link_real J_Teta_41 = link->R_T[1] * REAL(2.23606797749979);
    const six_link_real minus_J_Teta_42 = link->R_T[2] * REAL(2.23606797749979);
    const six_link_real J_Teta_51 = link->R_T[3] * REAL(2.23606797749979);
    const six_link_real J_Teta_52 = link->R_T[4] * REAL(2.23606797749979);
    const six_link_real J_Teta_62 = link->R_T[5] * REAL(2.23606797749979);

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const six_link_real t18 = J_TV_51 * tip->X[4] - minus_J_TV_41 * tip->X[3] + J_TV_61 * tip->X[5]
        + link->R_T[0] * tip->X[0] - link->R_T[1] * tip->X[1];
    const six_link_real V_next_11 = t18 + link->R_T[2] * tip->X[2];
    const six_link_real t19 = J_TV_51 * tip->X[10] - minus_J_TV_41 * tip->X[9] + J_TV_61 * tip->X[11]
        + link->R_T[0] * tip->X[6];
    const six_link_real V_next_12 = t19 - link->R_T[1] * tip->X[7] + link->R_T[2] * tip->X[8];
    const six_link_real t20 = J_TV_51 * tip->X[16] - minus_J_TV_41 * tip->X[15] + J_TV_61 * tip->X[17]
        + link->R_T[0] * tip->X[12];
    const six_link_real V_next_13 = t20 - link->R_T[1] * tip->X[13] + link->R_T[2] * tip->X[14];
    const six_link_real t21 = J_TV_51 * tip->X[22] - minus_J_TV_41 * tip->X[21] + J_TV_61 * tip->X[23]
        + link->R_T[0] * tip->X[18];
    const six_link_real V_next_14 = t21 - link->R_T[1] * tip->X[19] + link->R_T[2] * tip->X[20];
    const six_link_real t22 = J_TV_51 * tip->X[28] - minus_J_TV_41 * tip->X[27] + J_TV_61 * tip->X[29]
        + link->R_T[0] * tip->X[24];
    const six_link_real V_next_15 = t22 - link->R_T[1] * tip->X[25] + link->R_T[2] * tip->X[26];
    const six_link_real t23 = J_TV_51 * tip->X[34] - minus_J_TV_41 * tip->X[33] + J_TV_61 * tip->X[35]
        + link->R_T[0] * tip->X[30];
    const six_link_real V_next_16 = t23 - link->R_T[1] * tip->X[31] + link->R_T[2] * tip->X[32];
    const six_link_real t24 = J_TV_42 * tip->X[3] - minus_J_TV_52 * tip->X[4] + J_TV_62 * tip->X[5]
        + link->R_T[1] * tip->X[0] + link->R_T[3] * tip->X[1];
    const six_link_real V_next_21 = t24 + link->R_T[4] * tip->X[2];
    const six_link_real t25 = J_TV_42 * tip->X[9] - minus_J_TV_52 * tip->X[10] + J_TV_62 * tip->X[11]
        + link->R_T[1] * tip->X[6];
    const six_link_real V_next_22 = t25 + link->R_T[3] * tip->X[7] + link->R_T[4] * tip->X[8];
    const six_link_real t26 = J_TV_42 * tip->X[15] - minus_J_TV_52 * tip->X[16] + J_TV_62 * tip->X[17]
        + link->R_T[1] * tip->X[12];
    const six_link_real V_next_23 = t26 + link->R_T[3] * tip->X[13] + link->R_T[4] * tip->X[14];
    const six_link_real t27 = J_TV_42 * tip->X[21] - minus_J_TV_52 * tip->X[22] + J_TV_62 * tip->X[23]
        + link->R_T[1] * tip->X[18];
    const six_link_real V_next_24 = t27 + link->R_T[3] * tip->X[19] + link->R_T[4] * tip->X[20];
    const six_link_real t28 = J_TV_42 * tip->X[27] - minus_J_TV_52 * tip->X[28] + J_TV_62 * tip->X[29]
        + link->R_T[1] * tip->X[24];
    const six_link_real V_next_25 = t28 + link->R_T[3] * tip->X[25] + link->R_T[4] * tip->X[26];
    const six_link_real t29 = J_TV_42 * tip->X[33] - minus_J_TV_52 * tip->X[34] + J_TV_62 * tip->X[35]
        + link->R_T[1] * tip->X[30];
    const six_link_real V_next_26 = t29 + link->R_T[3] * tip->X[31] + link->R_T[4] * tip->X[32];
    const six_link_real t30 = J_TV_43 * tip->X[3] + J_TV_53 * tip->X[4] + J_TV_63 * tip->X[5]
        - link->R_T[2] * tip->X[0] + link->R_T[4] * tip->X[1];
    const six_link_real V_next_31 = t30 + link->R_T[5] * tip->X[2];
    const six_link_real t31 = J_TV_43 * tip->X[9] + J_TV_53 * tip->X[10] + J_TV_63 * tip->X[11]
        - link->R_T[2] * tip->X[6] + link->R_T[4] * tip->X[7];
    const six_link_real V_next_32 = t31 + link->R_T[5] * tip->X[8];
    const six_link_real t32 = J_TV_43 * tip->X[15] + J_TV_53 * tip->X[16] + J_TV_63 * tip->X[17]
        - link->R_T[2] * tip->X[12] + link->R_T[4] * tip->X[13];
    const six_link_real V_next_33 = t32 + link->R_T[5] * tip->X[14];
    const six_link_real t33 = J_TV_43 * tip->X[21] + J_TV_53 * tip->X[22] + J_TV_63 * tip->X[23]
        - link->R_T[2] * tip->X[18] + link->R_T[4] * tip->X[19];
    const six_link_real V_next_34 = t33 + link->R_T[5] * tip->X[20];
    const six_link_real t34 = J_TV_43 * tip->X[27] + J_TV_53 * tip->X[28] + J_TV_63 * tip->X[29]
        - link->R_T[2] * tip->X[24] + link->R_T[4] * tip->X[25];
    const six_link_real V_next_35 = t34 + link->R_T[5] * tip->X[26];
    const six_link_real t35 = J_TV_43 * tip->X[33] + J_TV_53 * tip->X[34] + J_TV_63 * tip->X[35]
        - link->R_T[2] * tip->X[30] + link->R_T[4] * tip->X[31];
    const six_link_real V_next_36 = t35 + link->R_T[5] * tip->X[32];
    const six_link_real V_next_41 = link->R_T[0] * tip->X[3] - link->R_T[1] * tip->X[4]
        + link->R_T[2] * tip->X[5];
    const six_link_real V_next_42 = link->R_T[0] * tip->X[9] - link->R_T[1] * tip->X[10]
        + link->R_T[2] * tip->X[11];
    const six_link_real V_next_43 = link->R_T[0] * tip->X[15] - link->R_T[1] * tip->X[16]
        + link->R_T[2] * tip->X[17];
    const six_link_real V_next_44 = link->R_T[0] * tip->X[21] - link->R_T[1] * tip->X[22]
        + link->R_T[2] * tip->X[23];
    const six_link_real V_next_45 = link->R_T[0] * tip->X[27] - link->R_T[1] * tip->X[28]
        + link->R_T[2] * tip->X[29];
    const six_link_real V_next_46 = link->R_T[0] * tip->X[33] - link->R_T[1] * tip->X[34]
        + link->R_T[2] * tip->X[35];
    const six_link_real V_next_51 = link->R_T[1] * tip->X[3] + link->R_T[3] * tip->X[4]
        + link->R_T[4] * tip->X[5];
    const six_link_real V_next_52 = link->R_T[1] * tip->X[9] + link->R_T[3] * tip->X[10]
        + link->R_T[4] * tip->X[11];
    const six_link_real V_next_53 = link->R_T[1] * tip->X[15] + link->R_T[3] * tip->X[16]
        + link->R_T[4] * tip->X[17];
    const six_link_real V_next_54 = link->R_T[1] * tip->X[21] + link->R_T[3] * tip->X[22]
        + link->R_T[4] * tip->X[23];
    const six_link_real V_next_55 = link->R_T[1] * tip->X[27] + link->R_T[3] * tip->X[28]
        + link->R_T[4] * tip->X[29];
    const six_link_real V_next_56 = link->R_T[1] * tip->X[33] + link->R_T[3] * tip->X[34]
        + link->R_T[4] * tip->X[35];
    const six_link_real V_next_61 = link->R_T[4] * tip->X[4] - link->R_T[2] * tip->X[3]
        + link->R_T[5] * tip->X[5];
    const six_link_real V_next_62 = link->R_T[4] * tip->X[10] - link->R_T[2] * tip->X[9]
        + link->R_T[5] * tip->X[11];
    const six_link_real V_next_63 = link->R_T[4] * tip->X[16] - link->R_T[2] * tip->X[15]
        + link->R_T[5] * tip->X[17];
    const six_link_real V_next_64 = link->R_T[4] * tip->X[22] - link->R_T[2] * tip->X[21]
        + link->R_T[5] * tip->X[23];
    const six_link_real V_next_65 = link->R_T[4] * tip->X[28] - link->R_T[2] * tip->X[27]
        + link->R_T[5] * tip->X[29];
    const six_link_real V_next_66 = link->R_T[4] * tip->X[34] - link->R_T[2] * tip->X[33]
        + link->R_T[5] * tip->X[35];

    /* eta_next: modal rows, columns of the next joint's wrench (100) */
    const six_link_real t36 = J_Teta_11 * tip->X[0] + J_Teta_21 * tip->X[1] + J_Teta_31 * tip->X[2]
        + J_Teta_41 * tip->X[3] + J_Teta_51 * tip->X[4];
    const six_link_real eta_next_11 = t36 + J_Teta_52 * tip->X[5];
    const six_link_real t37 = J_Teta_11 * tip->X[6] + J_Teta_21 * tip->X[7] + J_Teta_31 * tip->X[8]
        + J_Teta_41 * tip->X[9] + J_Teta_51 * tip->X[10];
    const six_link_real eta_next_12 = t37 + J_Teta_52 * tip->X[11];
    const six_link_real t38 = J_Teta_11 * tip->X[12] + J_Teta_21 * tip->X[13] + J_Teta_31 * tip->X[14]
        + J_Teta_41 * tip->X[15];
    const six_link_real eta_next_13 = t38 + J_Teta_51 * tip->X[16] + J_Teta_52 * tip->X[17];
    const six_link_real t39 = J_Teta_11 * tip->X[18] + J_Teta_21 * tip->X[19] + J_Teta_31 * tip->X[20]
        + J_Teta_41 * tip->X[21];
    const six_link_real eta_next_14 = t39 + J_Teta_51 * tip->X[22] + J_Teta_52 * tip->X[23];
    const six_link_real t40 = J_Teta_11 * tip->X[24] + J_Teta_21 * tip->X[25] + J_Teta_31 * tip->X[26]
        + J_Teta_41 * tip->X[27];
    const six_link_real eta_next_15 = t40 + J_Teta_51 * tip->X[28] + J_Teta_52 * tip->X[29];
    const six_link_real t41 = J_Teta_11 * tip->X[30] + J_Teta_21 * tip->X[31] + J_Teta_31 * tip->X[32]
        + J_Teta_41 * tip->X[33];
    const six_link_real eta_next_16 = t41 + J_Teta_51 * tip->X[34] + J_Teta_52 * tip->X[35];
    const six_link_real t42 = J_Teta_12 * tip->X[0] + J_Teta_22 * tip->X[1] + J_Teta_32 * tip->X[2]
        - minus_J_Teta_42 * tip->X[3];
    const six_link_real eta_next_21 = t42 + J_Teta_52 * tip->X[4] + J_Teta_62 * tip->X[5];
    const six_link_real t43 = J_Teta_12 * tip->X[6] + J_Teta_22 * tip->X[7] + J_Teta_32 * tip->X[8]
        - minus_J_Teta_42 * tip->X[9];
    const six_link_real eta_next_22 = t43 + J_Teta_52 * tip->X[10] + J_Teta_62 * tip->X[11];
    const six_link_real t44 = J_Teta_12 * tip->X[12] + J_Teta_22 * tip->X[13] + J_Teta_32 * tip->X[14]
        - minus_J_Teta_42 * tip->X[15];
    const six_link_real eta_next_23 = t44 + J_Teta_52 * tip->X[16] + J_Teta_62 * tip->X[17];
    const six_link_real t45 = J_Teta_12 * tip->X[18] + J_Teta_22 * tip->X[19] + J_Teta_32 * tip->X[20]
        - minus_J_Teta_42 * tip->X[21];
    const six_link_real eta_next_24 = t45 + J_Teta_52 * tip->X[22] + J_Teta_62 * tip->X[23];
    const six_link_real t46 = J_Teta_12 * tip->X[24] + J_Teta_22 * tip->X[25] + J_Teta_32 * tip->X[26]
        - minus_J_Teta_42 * tip->X[27];
    const six_link_real eta_next_25 = t46 + J_Teta_52 * tip->X[28] + J_Teta_62 * tip->X[29];
    const six_link_real t47 = J_Teta_12 * tip->X[30] + J_Teta_22 * tip->X[31] + J_Teta_32 * tip->X[32]
        - minus_J_Teta_42 * tip->X[33];
    const six_link_real eta_next_26 = t47 + J_Teta_52 * tip->X[34] + J_Teta_62 * tip->X[35];

    /* next_V: next joint's rows, twist columns (100) */
    const six_link_real t48 = minus_J_TV_41 * tip->PX[3] - J_TV_51 * tip->PX[4] - J_TV_61 * tip->PX[5]
        - tip->PX[0] * link->R_T[0];
    const six_link_real next_V_11 = t48 + tip->PX[1] * link->R_T[1] - tip->PX[2] * link->R_T[2];
    const six_link_real t49 = minus_J_TV_52 * tip->PX[4] - J_TV_42 * tip->PX[3] - J_TV_62 * tip->PX[5]
        - tip->PX[0] * link->R_T[1];
    const six_link_real next_V_12 = t49 - tip->PX[1] * link->R_T[3] - tip->PX[2] * link->R_T[4];
    const six_link_real t50 = tip->PX[0] * link->R_T[2]
        - (J_TV_43 * tip->PX[3] + J_TV_53 * tip->PX[4] + J_TV_63 * tip->PX[5]) - tip->PX[1] * link->R_T[4];
    const six_link_real next_V_13 = t50 - tip->PX[2] * link->R_T[5];
    const six_link_real next_V_14 = tip->PX[4] * link->R_T[1] - tip->PX[3] * link->R_T[0]
        - tip->PX[5] * link->R_T[2];
    const six_link_real minus_next_V_15 = tip->PX[3] * link->R_T[1] + tip->PX[4] * link->R_T[3]
        + tip->PX[5] * link->R_T[4];
    const six_link_real t51 = -minus_next_V_15;
    const six_link_real next_V_16 = tip->PX[3] * link->R_T[2] - tip->PX[4] * link->R_T[4]
        - tip->PX[5] * link->R_T[5];
    const six_link_real t52 = minus_J_TV_41 * tip->PX[9] - J_TV_51 * tip->PX[10] - J_TV_61 * tip->PX[11]
        - tip->PX[6] * link->R_T[0];
    const six_link_real next_V_21 = t52 + tip->PX[7] * link->R_T[1] - tip->PX[8] * link->R_T[2];
    const six_link_real t53 = minus_J_TV_52 * tip->PX[10] - J_TV_42 * tip->PX[9] - J_TV_62 * tip->PX[11]
        - tip->PX[6] * link->R_T[1];
    const six_link_real next_V_22 = t53 - tip->PX[7] * link->R_T[3] - tip->PX[8] * link->R_T[4];
    const six_link_real t54 = tip->PX[6] * link->R_T[2]
        - (J_TV_43 * tip->PX[9] + J_TV_53 * tip->PX[10] + J_TV_63 * tip->PX[11]);
    const six_link_real next_V_23 = t54 - tip->PX[7] * link->R_T[4] - tip->PX[8] * link->R_T[5];
    const six_link_real next_V_24 = tip->PX[10] * link->R_T[1] - tip->PX[9] * link->R_T[0]
        - tip->PX[11] * link->R_T[2];
    const six_link_real minus_next_V_25 = tip->PX[9] * link->R_T[1] + tip->PX[10] * link->R_T[3]
        + tip->PX[11] * link->R_T[4];
    const six_link_real t55 = -minus_next_V_25;
    const six_link_real next_V_26 = tip->PX[9] * link->R_T[2] - tip->PX[10] * link->R_T[4]
        - tip->PX[11] * link->R_T[5];
    const six_link_real t56 = minus_J_TV_41 * tip->PX[15] - J_TV_51 * tip->PX[16] - J_TV_61 * tip->PX[17]
        - tip->PX[12] * link->R_T[0];
    const six_link_real next_V_31 = t56 + tip->PX[13] * link->R_T[1] - tip->PX[14] * link->R_T[2];
    const six_link_real t57 = minus_J_TV_52 * tip->PX[16] - J_TV_42 * tip->PX[15] - J_TV_62 * tip->PX[17]
        - tip->PX[12] * link->R_T[1];
    const six_link_real next_V_32 = t57 - tip->PX[13] * link->R_T[3] - tip->PX[14] * link->R_T[4];
    const six_link_real t58 = tip->PX[12] * link->R_T[2]
        - (J_TV_43 * tip->PX[15] + J_TV_53 * tip->PX[16] + J_TV_63 * tip->PX[17]);
    const six_link_real next_V_33 = t58 - tip->PX[13] * link->R_T[4] - tip->PX[14] * link->R_T[5];
    const six_link_real next_V_34 = tip->PX[16] * link->R_T[1] - tip->PX[15] * link->R_T[0]
        - tip->PX[17] * link->R_T[2];
    const six_link_real minus_next_V_35 = tip->PX[15] * link->R_T[1] + tip->PX[16] * link->R_T[3]
        + tip->PX[17] * link->R_T[4];
    const six_link_real t59 = -minus_next_V_35;
    const six_link_real next_V_36 = tip->PX[15] * link->R_T[2] - tip->PX[16] * link->R_T[4]
        - tip->PX[17] * link->R_T[5];
    const six_link_real t60 = minus_J_TV_41 * tip->PX[21] - J_TV_51 * tip->PX[22] - J_TV_61 * tip->PX[23]
        - tip->PX[18] * link->R_T[0];
    const six_link_real next_V_41 = t60 + tip->PX[19] * link->R_T[1] - tip->PX[20] * link->R_T[2];
    const six_link_real t61 = minus_J_TV_52 * tip->PX[22] - J_TV_42 * tip->PX[21] - J_TV_62 * tip->PX[23]
        - tip->PX[18] * link->R_T[1];
    const six_link_real next_V_42 = t61 - tip->PX[19] * link->R_T[3] - tip->PX[20] * link->R_T[4];
    const six_link_real t62 = tip->PX[18] * link->R_T[2]
        - (J_TV_43 * tip->PX[21] + J_TV_53 * tip->PX[22] + J_TV_63 * tip->PX[23]);
    const six_link_real next_V_43 = t62 - tip->PX[19] * link->R_T[4] - tip->PX[20] * link->R_T[5];
    const six_link_real next_V_44 = tip->PX[22] * link->R_T[1] - tip->PX[21] * link->R_T[0]
        - tip->PX[23] * link->R_T[2];
    const six_link_real minus_next_V_45 = tip->PX[21] * link->R_T[1] + tip->PX[22] * link->R_T[3]
        + tip->PX[23] * link->R_T[4];
    const six_link_real t63 = -minus_next_V_45;
    const six_link_real next_V_46 = tip->PX[21] * link->R_T[2] - tip->PX[22] * link->R_T[4]
        - tip->PX[23] * link->R_T[5];
    const six_link_real t64 = minus_J_TV_41 * tip->PX[27] - J_TV_51 * tip->PX[28] - J_TV_61 * tip->PX[29]
        - tip->PX[24] * link->R_T[0];
    const six_link_real next_V_51 = t64 + tip->PX[25] * link->R_T[1] - tip->PX[26] * link->R_T[2];
    const six_link_real t65 = minus_J_TV_52 * tip->PX[28] - J_TV_42 * tip->PX[27] - J_TV_62 * tip->PX[29]
        - tip->PX[24] * link->R_T[1];
    const six_link_real next_V_52 = t65 - tip->PX[25] * link->R_T[3] - tip->PX[26] * link->R_T[4];
    const six_link_real t66 = tip->PX[24] * link->R_T[2]
        - (J_TV_43 * tip->PX[27] + J_TV_53 * tip->PX[28] + J_TV_63 * tip->PX[29]);
    const six_link_real next_V_53 = t66 - tip->PX[25] * link->R_T[4] - tip->PX[26] * link->R_T[5];
    const six_link_real next_V_54 = tip->PX[28] * link->R_T[1] - tip->PX[27] * link->R_T[0]
        - tip->PX[29] * link->R_T[2];
    const six_link_real minus_next_V_55 = tip->PX[27] * link->R_T[1] + tip->PX[28] * link->R_T[3]
        + tip->PX[29] * link->R_T[4];
    const six_link_real t67 = -minus_next_V_55;
    const six_link_real next_V_56 = tip->PX[27] * link->R_T[2] - tip->PX[28] * link->R_T[4]
        - tip->PX[29] * link->R_T[5];
    const six_link_real t68 = minus_J_TV_41 * tip->PX[33] - J_TV_51 * tip->PX[34] - J_TV_61 * tip->PX[35]
        - tip->PX[30] * link->R_T[0];
    const six_link_real next_V_61 = t68 + tip->PX[31] * link->R_T[1] - tip->PX[32] * link->R_T[2];
    const six_link_real t69 = minus_J_TV_52 * tip->PX[34] - J_TV_42 * tip->PX[33] - J_TV_62 * tip->PX[35]
        - tip->PX[30] * link->R_T[1];
    const six_link_real next_V_62 = t69 - tip->PX[31] * link->R_T[3] - tip->PX[32] * link->R_T[4];
    const six_link_real t70 = tip->PX[30] * link->R_T[2]
        - (J_TV_43 * tip->PX[33] + J_TV_53 * tip->PX[34] + J_TV_63 * tip->PX[35]);
    const six_link_real next_V_63 = t70 - tip->PX[31] * link->R_T[4] - tip->PX[32] * link->R_T[5];
    const six_link_real next_V_64 = tip->PX[34] * link->R_T[1] - tip->PX[33] * link->R_T[0]
        - tip->PX[35] * link->R_T[2];
    const six_link_real minus_next_V_65 = tip->PX[33] * link->R_T[1] + tip->PX[34] * link->R_T[3]
        + tip->PX[35] * link->R_T[4];
    const six_link_real t71 = -minus_next_V_65;
    const six_link_real next_V_66 = tip->PX[33] * link->R_T[2] - tip->PX[34] * link->R_T[4]
        - tip->PX[35] * link->R_T[5];

    /* next_eta: next joint's rows, modal columns (100) */
    const six_link_real t72 = J_Teta_11 * tip->PX[0] + J_Teta_21 * tip->PX[1] + J_Teta_31 * tip->PX[2]
        + J_Teta_41 * tip->PX[3];
    const six_link_real minus_next_eta_11 = t72 + J_Teta_51 * tip->PX[4] + J_Teta_52 * tip->PX[5];
    const six_link_real t73 = -minus_next_eta_11;
    const six_link_real t74 = minus_J_Teta_42 * tip->PX[3]
        - (J_Teta_12 * tip->PX[0] + J_Teta_22 * tip->PX[1] + J_Teta_32 * tip->PX[2]);
    const six_link_real next_eta_12 = t74 - J_Teta_52 * tip->PX[4] - J_Teta_62 * tip->PX[5];
    const six_link_real t75 = J_Teta_11 * tip->PX[6] + J_Teta_21 * tip->PX[7] + J_Teta_31 * tip->PX[8]
        + J_Teta_41 * tip->PX[9];
    const six_link_real minus_next_eta_21 = t75 + J_Teta_51 * tip->PX[10] + J_Teta_52 * tip->PX[11];
    const six_link_real t76 = -minus_next_eta_21;
    const six_link_real t77 = minus_J_Teta_42 * tip->PX[9]
        - (J_Teta_12 * tip->PX[6] + J_Teta_22 * tip->PX[7] + J_Teta_32 * tip->PX[8]);
    const six_link_real next_eta_22 = t77 - J_Teta_52 * tip->PX[10] - J_Teta_62 * tip->PX[11];
    const six_link_real t78 = J_Teta_11 * tip->PX[12] + J_Teta_21 * tip->PX[13] + J_Teta_31 * tip->PX[14]
        + J_Teta_41 * tip->PX[15];
    const six_link_real minus_next_eta_31 = t78 + J_Teta_51 * tip->PX[16] + J_Teta_52 * tip->PX[17];
    const six_link_real t79 = -minus_next_eta_31;
    const six_link_real t80 = minus_J_Teta_42 * tip->PX[15]
        - (J_Teta_12 * tip->PX[12] + J_Teta_22 * tip->PX[13] + J_Teta_32 * tip->PX[14]);
    const six_link_real next_eta_32 = t80 - J_Teta_52 * tip->PX[16] - J_Teta_62 * tip->PX[17];
    const six_link_real t81 = J_Teta_11 * tip->PX[18] + J_Teta_21 * tip->PX[19] + J_Teta_31 * tip->PX[20]
        + J_Teta_41 * tip->PX[21];
    const six_link_real minus_next_eta_41 = t81 + J_Teta_51 * tip->PX[22] + J_Teta_52 * tip->PX[23];
    const six_link_real t82 = -minus_next_eta_41;
    const six_link_real t83 = minus_J_Teta_42 * tip->PX[21]
        - (J_Teta_12 * tip->PX[18] + J_Teta_22 * tip->PX[19] + J_Teta_32 * tip->PX[20]);
    const six_link_real next_eta_42 = t83 - J_Teta_52 * tip->PX[22] - J_Teta_62 * tip->PX[23];
    const six_link_real t84 = J_Teta_11 * tip->PX[24] + J_Teta_21 * tip->PX[25] + J_Teta_31 * tip->PX[26]
        + J_Teta_41 * tip->PX[27];
    const six_link_real minus_next_eta_51 = t84 + J_Teta_51 * tip->PX[28] + J_Teta_52 * tip->PX[29];
    const six_link_real t85 = -minus_next_eta_51;
    const six_link_real t86 = minus_J_Teta_42 * tip->PX[27]
        - (J_Teta_12 * tip->PX[24] + J_Teta_22 * tip->PX[25] + J_Teta_32 * tip->PX[26]);
    const six_link_real next_eta_52 = t86 - J_Teta_52 * tip->PX[28] - J_Teta_62 * tip->PX[29];
    const six_link_real t87 = J_Teta_11 * tip->PX[30] + J_Teta_21 * tip->PX[31] + J_Teta_31 * tip->PX[32]
        + J_Teta_41 * tip->PX[33];
    const six_link_real minus_next_eta_61 = t87 + J_Teta_51 * tip->PX[34] + J_Teta_52 * tip->PX[35];
    const six_link_real t88 = -minus_next_eta_61;
    const six_link_real t89 = minus_J_Teta_42 * tip->PX[33]
        - (J_Teta_12 * tip->PX[30] + J_Teta_22 * tip->PX[31] + J_Teta_32 * tip->PX[32]);
    const six_link_real next_eta_62 = t89 - J_Teta_52 * tip->PX[34] - J_Teta_62 * tip->PX[35];

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real t90 = J_TV_51 * w_ext[4] - minus_J_TV_41 * w_ext[3] + J_TV_61 * w_ext[5]
        + link->R_T[0] * w_ext[0] - link->R_T[1] * w_ext[1];
    const six_link_real V_W_1 = t90 + link->R_T[2] * w_ext[2];
    const six_link_real t91 = J_TV_42 * w_ext[3] - minus_J_TV_52 * w_ext[4] + J_TV_62 * w_ext[5]
        + link->R_T[1] * w_ext[0] + link->R_T[3] * w_ext[1];
    const six_link_real V_W_2 = t91 + link->R_T[4] * w_ext[2];
    const six_link_real t92 = J_TV_43 * w_ext[3] + J_TV_53 * w_ext[4] + J_TV_63 * w_ext[5]
        - link->R_T[2] * w_ext[0] + link->R_T[4] * w_ext[1];
    const six_link_real V_W_3 = t92 + link->R_T[5] * w_ext[2];
    const six_link_real V_W_4 = link->R_T[0] * w_ext[3] - link->R_T[1] * w_ext[4] + link->R_T[2] * w_ext[5];
    const six_link_real V_W_5 = link->R_T[1] * w_ext[3] + link->R_T[3] * w_ext[4] + link->R_T[4] * w_ext[5];
    const six_link_real V_W_6 = link->R_T[4] * w_ext[4] - link->R_T[2] * w_ext[3] + link->R_T[5] * w_ext[5];

    /* eta_W: external wrench in the modal rows (100) */
    const six_link_real t93 = J_Teta_11 * w_ext[0] + J_Teta_21 * w_ext[1] + J_Teta_31 * w_ext[2]
        + J_Teta_41 * w_ext[3] + J_Teta_51 * w_ext[4];
    const six_link_real eta_W_1 = t93 + J_Teta_52 * w_ext[5];
    const six_link_real t94 = J_Teta_12 * w_ext[0] + J_Teta_22 * w_ext[1] + J_Teta_32 * w_ext[2]
        - minus_J_Teta_42 * w_ext[3] + J_Teta_52 * w_ext[4];
    const six_link_real eta_W_2 = t94 + J_Teta_62 * w_ext[5];

    /* outputs */
    M[place[7]] = next_V_11;
    M[place[8]] = next_V_12;
    M[place[9]] = next_V_13;
    M[place[10]] = next_V_14;
    M[place[11]] = t51;
    M[place[12]] = next_V_16;
    M[place[13]] = next_V_21;
    M[place[14]] = next_V_22;
    M[place[15]] = next_V_23;
    M[place[16]] = next_V_24;
    M[place[17]] = t55;
    M[place[18]] = next_V_26;
    M[place[19]] = next_V_31;
    M[place[20]] = next_V_32;
    M[place[21]] = next_V_33;
    M[place[22]] = next_V_34;
    M[place[23]] = t59;
    M[place[24]] = next_V_36;
    M[place[25]] = next_V_41;
    M[place[26]] = next_V_42;
    M[place[27]] = next_V_43;
    M[place[28]] = next_V_44;
    M[place[29]] = t63;
    M[place[30]] = next_V_46;
    M[place[31]] = next_V_51;
    M[place[32]] = next_V_52;
    M[place[33]] = next_V_53;
    M[place[34]] = next_V_54;
    M[place[35]] = t67;
    M[place[36]] = next_V_56;
    M[place[37]] = next_V_61;
    M[place[38]] = next_V_62;
    M[place[39]] = next_V_63;
    M[place[40]] = next_V_64;
    M[place[41]] = t71;
    M[place[42]] = next_V_66;
    M[place[43]] = t73;
    M[place[44]] = next_eta_12;
    M[place[45]] = t76;
    M[place[46]] = next_eta_22;
    M[place[47]] = t79;
    M[place[48]] = next_eta_32;
    M[place[49]] = t82;
    M[place[50]] = next_eta_42;
    M[place[51]] = t85;
    M[place[52]] = next_eta_52;
    M[place[53]] = t88;
    M[place[54]] = next_eta_62;
    M[place[55]] = -1;
    M[place[56]] = -1;
    M[place[57]] = -1;
    M[place[58]] = -1;
    M[place[59]] = -1;
    M[place[60]] = -1;
    M[place[61]] = link->M_V[0];
    M[place[62]] = t1;
    M[place[63]] = t2;
    M[place[64]] = t3;
    M[place[65]] = link->M_V[4];
    M[place[66]] = t1;
    M[place[67]] = link->M_V[5];
    M[place[68]] = t4;
    M[place[69]] = link->M_V[3];
    M[place[70]] = t5;
    M[place[71]] = t2;
    M[place[72]] = t4;
    M[place[73]] = link->M_V[7];
    M[place[74]] = t6;
    M[place[75]] = c->S_0_x;
    M[place[76]] = link->M_V[3];
    M[place[77]] = t6;
    M[place[78]] = c->m;
    M[place[79]] = t3;
    M[place[80]] = c->S_0_x;
    M[place[81]] = c->m;
    M[place[82]] = link->M_V[4];
    M[place[83]] = t5;
    M[place[84]] = c->m;
    M[place[85]] = t7;
    M[place[86]] = link->M_D[1];
    M[place[87]] = t8;
    M[place[88]] = c->chi_1;
    M[place[89]] = c->sigma_y1;
    M[place[90]] = c->sigma_z2;
    M[place[91]] = V_next_11;
    M[place[92]] = V_next_12;
    M[place[93]] = V_next_13;
    M[place[94]] = V_next_14;
    M[place[95]] = V_next_15;
    M[place[96]] = V_next_16;
    M[place[97]] = V_next_21;
    M[place[98]] = V_next_22;
    M[place[99]] = V_next_23;
    M[place[100]] = V_next_24;
    M[place[101]] = V_next_25;
    M[place[102]] = V_next_26;
    M[place[103]] = V_next_31;
    M[place[104]] = V_next_32;
    M[place[105]] = V_next_33;
    M[place[106]] = V_next_34;
    M[place[107]] = V_next_35;
    M[place[108]] = V_next_36;
    M[place[109]] = V_next_41;
    M[place[110]] = V_next_42;
    M[place[111]] = V_next_43;
    M[place[112]] = V_next_44;
    M[place[113]] = V_next_45;
    M[place[114]] = V_next_46;
    M[place[115]] = V_next_51;
    M[place[116]] = V_next_52;
    M[place[117]] = V_next_53;
    M[place[118]] = V_next_54;
    M[place[119]] = V_next_55;
    M[place[120]] = V_next_56;
    M[place[121]] = V_next_61;
    M[place[122]] = V_next_62;
    M[place[123]] = V_next_63;
    M[place[124]] = V_next_64;
    M[place[125]] = V_next_65;
    M[place[126]] = V_next_66;
    M[place[127]] = t7;
    M[place[128]] = c->chi_1;
    M[place[129]] = c->sigma_y1;
    M[place[130]] = link->M_D[1];
    M[place[131]] = t8;
    M[place[132]] = c->sigma_z2;
    M[place[133]] = m_eta[0];
    M[place[134]] = m_eta[1];
    M[place[135]] = eta_next_11;
    M[place[136]] = eta_next_12;
    M[place[137]] = eta_next_13;
    M[place[138]] = eta_next_14;
    M[place[139]] = eta_next_15;
    M[place[140]] = eta_next_16;
    M[place[141]] = eta_next_21;
    M[place[142]] = eta_next_22;
    M[place[143]] = eta_next_23;
    M[place[144]] = eta_next_24;
    M[place[145]] = eta_next_25;
    M[place[146]] = eta_next_26;
    H[6] = link->h_V[0];
    H[7] = link->h_V[1];
    H[8] = link->h_V[2];
    H[9] = link->h_V[3];
    H[10] = link->h_V[4];
    H[11] = link->h_V[5];
    eta_H[0] = eta_H_1;
    eta_H[1] = eta_H_2;
    W[6] = V_W_1;
    W[7] = V_W_2;
    W[8] = V_W_3;
    W[9] = V_W_4;
    W[10] = V_W_5;
    W[11] = V_W_6;
    eta_W[0] = eta_W_1;
    eta_W[1] = eta_W_2;
    return SIX_LINK_OK;
}

/* link rows, links like wrist_roll: 83 operations */
static six_link_status link_rows_wrist_roll(const six_link_link_constants *c, const six_link_link_store *link, const six_link_node *tip,
    const six_link_real w_ext[6], const int *place, six_link_real *M, six_link_real H[12],
    six_link_real W[12])
{

    const six_link_real t1 = -c->S_0_x;

    /* V_next: twist rows, columns of the next joint's wrench (100) */
    const six_link_real V_next_21 = tip->X[1] - c->length * tip->X[5];
    const six_link_real V_next_22 = tip->X[7] - c->length * tip->X[11];
    const six_link_real V_next_23 = tip->X[13] - c->length * tip->X[17];
    const six_link_real V_next_24 = tip->X[19] - c->length * tip->X[23];
    const six_link_real V_next_25 = tip->X[25] - c->length * tip->X[29];
    const six_link_real V_next_26 = tip->X[31] - c->length * tip->X[35];
    const six_link_real V_next_31 = c->length * tip->X[4] + tip->X[2];
    const six_link_real V_next_32 = c->length * tip->X[10] + tip->X[8];
    const six_link_real V_next_33 = c->length * tip->X[16] + tip->X[14];
    const six_link_real V_next_34 = c->length * tip->X[22] + tip->X[20];
    const six_link_real V_next_35 = c->length * tip->X[28] + tip->X[26];
    const six_link_real V_next_36 = c->length * tip->X[34] + tip->X[32];

    /* next_V: next joint's rows, twist columns (100) */
    const six_link_real t2 = -tip->PX[0];
    const six_link_real next_V_12 = c->length * tip->PX[5] - tip->PX[1];
    const six_link_real minus_next_V_13 = c->length * tip->PX[4] + tip->PX[2];
    const six_link_real t3 = -minus_next_V_13;
    const six_link_real t4 = -tip->PX[3];
    const six_link_real t5 = -tip->PX[4];
    const six_link_real t6 = -tip->PX[5];
    const six_link_real t7 = -tip->PX[6];
    const six_link_real next_V_22 = c->length * tip->PX[11] - tip->PX[7];
    const six_link_real minus_next_V_23 = c->length * tip->PX[10] + tip->PX[8];
    const six_link_real t8 = -minus_next_V_23;
    const six_link_real t9 = -tip->PX[9];
    const six_link_real t10 = -tip->PX[10];
    const six_link_real t11 = -tip->PX[11];
    const six_link_real t12 = -tip->PX[12];
    const six_link_real next_V_32 = c->length * tip->PX[17] - tip->PX[13];
    const six_link_real minus_next_V_33 = c->length * tip->PX[16] + tip->PX[14];
    const six_link_real t13 = -minus_next_V_33;
    const six_link_real t14 = -tip->PX[15];
    const six_link_real t15 = -tip->PX[16];
    const six_link_real t16 = -tip->PX[17];
    const six_link_real t17 = -tip->PX[18];
    const six_link_real next_V_42 = c->length * tip->PX[23] - tip->PX[19];
    const six_link_real minus_next_V_43 = c->length * tip->PX[22] + tip->PX[20];
    const six_link_real t18 = -minus_next_V_43;
    const six_link_real t19 = -tip->PX[21];
    const six_link_real t20 = -tip->PX[22];
    const six_link_real t21 = -tip->PX[23];
    const six_link_real t22 = -tip->PX[24];
    const six_link_real next_V_52 = c->length * tip->PX[29] - tip->PX[25];
    const six_link_real minus_next_V_53 = c->length * tip->PX[28] + tip->PX[26];
    const six_link_real t23 = -minus_next_V_53;
    const six_link_real t24 = -tip->PX[27];
    const six_link_real t25 = -tip->PX[28];
    const six_link_real t26 = -tip->PX[29];
    const six_link_real t27 = -tip->PX[30];
    const six_link_real next_V_62 = c->length * tip->PX[35] - tip->PX[31];
    const six_link_real minus_next_V_63 = c->length * tip->PX[34] + tip->PX[32];
    const six_link_real t28 = -minus_next_V_63;
    const six_link_real t29 = -tip->PX[33];
    const six_link_real t30 = -tip->PX[34];
    const six_link_real t31 = -tip->PX[35];

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real V_W_2 = w_ext[1] - c->length * w_ext[5];
    const six_link_real V_W_3 = c->length * w_ext[4] + w_ext[2];

    /* outputs */
    M[place[7]] = t2;
    M[place[8]] = next_V_12;
    M[place[9]] = t3;
    M[place[10]] = t4;
    M[place[11]] = t5;
    M[place[12]] = t6;
    M[place[13]] = t7;
    M[place[14]] = next_V_22;
    M[place[15]] = t8;
    M[place[16]] = t9;
    M[place[17]] = t10;
    M[place[18]] = t11;
    M[place[19]] = t12;
    M[place[20]] = next_V_32;
    M[place[21]] = t13;
    M[place[22]] = t14;
    M[place[23]] = t15;
    M[place[24]] = t16;
    M[place[25]] = t17;
    M[place[26]] = next_V_42;
    M[place[27]] = t18;
    M[place[28]] = t19;
    M[place[29]] = t20;
    M[place[30]] = t21;
    M[place[31]] = t22;
    M[place[32]] = next_V_52;
    M[place[33]] = t23;
    M[place[34]] = t24;
    M[place[35]] = t25;
    M[place[36]] = t26;
    M[place[37]] = t27;
    M[place[38]] = next_V_62;
    M[place[39]] = t28;
    M[place[40]] = t29;
    M[place[41]] = t30;
    M[place[42]] = t31;
    M[place[43]] = -1;
    M[place[44]] = -1;
    M[place[45]] = -1;
    M[place[46]] = -1;
    M[place[47]] = -1;
    M[place[48]] = -1;
    M[place[49]] = c->I_s;
    M[place[50]] = c->J_0_xx;
    M[place[51]] = t1;
    M[place[52]] = c->J_0_xx;
    M[place[53]] = c->S_0_x;
    M[place[54]] = c->mu;
    M[place[55]] = c->S_0_x;
    M[place[56]] = c->mu;
    M[place[57]] = t1;
    M[place[58]] = c->mu;
    M[place[59]] = tip->X[0];
    M[place[60]] = tip->X[6];
    M[place[61]] = tip->X[12];
    M[place[62]] = tip->X[18];
    M[place[63]] = tip->X[24];
    M[place[64]] = tip->X[30];
    M[place[65]] = V_next_21;
    M[place[66]] = V_next_22;
    M[place[67]] = V_next_23;
    M[place[68]] = V_next_24;
    M[place[69]] = V_next_25;
    M[place[70]] = V_next_26;
    M[place[71]] = V_next_31;
    M[place[72]] = V_next_32;
    M[place[73]] = V_next_33;
    M[place[74]] = V_next_34;
    M[place[75]] = V_next_35;
    M[place[76]] = V_next_36;
    M[place[77]] = tip->X[3];
    M[place[78]] = tip->X[9];
    M[place[79]] = tip->X[15];
    M[place[80]] = tip->X[21];
    M[place[81]] = tip->X[27];
    M[place[82]] = tip->X[33];
    M[place[83]] = tip->X[4];
    M[place[84]] = tip->X[10];
    M[place[85]] = tip->X[16];
    M[place[86]] = tip->X[22];
    M[place[87]] = tip->X[28];
    M[place[88]] = tip->X[34];
    M[place[89]] = tip->X[5];
    M[place[90]] = tip->X[11];
    M[place[91]] = tip->X[17];
    M[place[92]] = tip->X[23];
    M[place[93]] = tip->X[29];
    M[place[94]] = tip->X[35];
    H[6] = 0;
    H[7] = link->h_V[0];
    H[8] = link->h_V[1];
    H[9] = link->h_V[2];
    H[10] = link->h_V[3];
    H[11] = link->h_V[4];
    W[6] = w_ext[0];
    W[7] = V_W_2;
    W[8] = V_W_3;
    W[9] = w_ext[3];
    W[10] = w_ext[4];
    W[11] = w_ext[5];
    return SIX_LINK_OK;
}

/* link rows, links like flange: 35 operations */
static six_link_status link_rows_flange_last(const six_link_link_constants *c, const six_link_link_store *link, const six_link_real w_ext[6],
    const int *place, six_link_real *M, six_link_real H[12], six_link_real W[12])
{

    const six_link_real t1 = -c->S_T_z;
    const six_link_real t2 = -c->J_T_yz;
    const six_link_real t3 = -c->S_T_y;

    /* V_V: twist rows, twist columns (100) */
    const six_link_real V_V_11 = c->I_s + c->I_T_xx;
    const six_link_real minus_V_V_12 = c->length * c->S_T_y + c->J_T_xy;
    const six_link_real t4 = -minus_V_V_12;
    const six_link_real minus_V_V_13 = c->length * c->S_T_z + c->J_T_xz;
    const six_link_real t5 = -minus_V_V_13;
    const six_link_real t6 = c->length * c->body0_mass + c->S_T_x;
    const six_link_real t7 = c->J_0_xx + c->length * t6;
    const six_link_real t8 = c->length * c->S_T_x;
    const six_link_real V_V_22 = t7 + (t8 + c->I_T_yy);
    const six_link_real minus_V_V_26 = c->S_0_x + t6;
    const six_link_real t9 = -minus_V_V_26;
    const six_link_real V_V_33 = t7 + (t8 + c->I_T_zz);
    const six_link_real V_V_44 = c->mu + c->body0_mass;

    /* V_H: bias of the twist rows (100) */
    const six_link_real V_H_2 = link->h_V[0] - c->length * link->h_T[5] + link->h_T[1];
    const six_link_real V_H_3 = link->h_V[1] + c->length * link->h_T[4] + link->h_T[2];
    const six_link_real V_H_4 = link->h_V[2] + link->h_T[3];
    const six_link_real V_H_5 = link->h_V[3] + link->h_T[4];
    const six_link_real V_H_6 = link->h_V[4] + link->h_T[5];

    /* V_W: external wrench in the twist rows (100) */
    const six_link_real V_W_2 = w_ext[1] - c->length * w_ext[5];
    const six_link_real V_W_3 = c->length * w_ext[4] + w_ext[2];

    /* outputs */
    M[place[7]] = -1;
    M[place[8]] = -1;
    M[place[9]] = -1;
    M[place[10]] = -1;
    M[place[11]] = -1;
    M[place[12]] = -1;
    M[place[13]] = V_V_11;
    M[place[14]] = t4;
    M[place[15]] = t5;
    M[place[16]] = t1;
    M[place[17]] = c->S_T_y;
    M[place[18]] = t4;
    M[place[19]] = V_V_22;
    M[place[20]] = t2;
    M[place[21]] = c->S_T_z;
    M[place[22]] = t9;
    M[place[23]] = t5;
    M[place[24]] = t2;
    M[place[25]] = V_V_33;
    M[place[26]] = t3;
    M[place[27]] = minus_V_V_26;
    M[place[28]] = c->S_T_z;
    M[place[29]] = t3;
    M[place[30]] = V_V_44;
    M[place[31]] = t1;
    M[place[32]] = minus_V_V_26;
    M[place[33]] = V_V_44;
    M[place[34]] = c->S_T_y;
    M[place[35]] = t9;
    M[place[36]] = V_V_44;
    H[6] = link->h_T[0];
    H[7] = V_H_2;
    H[8] = V_H_3;
    H[9] = V_H_4;
    H[10] = V_H_5;
    H[11] = V_H_6;
    W[6] = w_ext[0];
    W[7] = V_W_2;
    W[8] = V_W_3;
    W[9] = w_ext[3];
    W[10] = w_ext[4];
    W[11] = w_ext[5];
    return SIX_LINK_OK;
}

static six_link_status dae_dynamics_dae_kinematics(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return dae_kinematics_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->new_qdot + q);
    case 1:
        return dae_kinematics_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->eta + e, call->etadot + e, call->new_qdot + q);
    case 2:
        return dae_kinematics_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->eta + e, call->etadot + e, call->new_qdot + q);
    case 3:
        return dae_kinematics_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->new_qdot + q);
    case 4:
        return dae_kinematics_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->new_qdot + q);
    default:
        return dae_kinematics_flange(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->new_qdot + q);
    }
}

static six_link_status dae_dynamics_eliminate(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return eliminate_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->w_ext + 6 * i, call->tau + q, call->qdot + q);
    case 1:
        return eliminate_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->tau + q, call->qdot + q);
    case 2:
        return eliminate_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->w_ext + 6 * i, call->m_eta + e, call->f_eta + e, call->tau + q, call->qdot + q);
    case 3:
        return eliminate_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->w_ext + 6 * i, call->tau + q, call->qdot + q);
    case 4:
        return eliminate_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->w_ext + 6 * i, call->tau + q, call->qdot + q);
    default:
        return eliminate_flange(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->w_ext + 6 * i, call->tau + q, call->qdot + q);
    }
}

static six_link_status dae_dynamics_accelerate(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return accelerate_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->qddot + q, call->wrench + 6 * i, call->alpha + 6 * i);
    case 1:
        return accelerate_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->qddot + q, call->wrench + 6 * i, call->alpha + 6 * i, call->etaddot + e);
    case 2:
        return accelerate_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->qddot + q, call->wrench + 6 * i, call->alpha + 6 * i, call->etaddot + e);
    case 3:
        return accelerate_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->qddot + q, call->wrench + 6 * i, call->alpha + 6 * i);
    case 4:
        return accelerate_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->qddot + q, call->wrench + 6 * i, call->alpha + 6 * i);
    default:
        return accelerate_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->qddot + q, call->wrench + 6 * i, call->alpha + 6 * i);
    }
}

static six_link_status dae_dynamics_twist_rates(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return twist_rates_shoulder(call->quaternion + 4 * i, call->gravity, call->given_alpha + 6 * i, call->Vdot + 6 * i);
    case 1:
        return twist_rates_shoulder(call->quaternion + 4 * i, call->gravity, call->given_alpha + 6 * i, call->Vdot + 6 * i);
    case 2:
        return twist_rates_shoulder(call->quaternion + 4 * i, call->gravity, call->given_alpha + 6 * i, call->Vdot + 6 * i);
    case 3:
        return twist_rates_shoulder(call->quaternion + 4 * i, call->gravity, call->given_alpha + 6 * i, call->Vdot + 6 * i);
    case 4:
        return twist_rates_shoulder(call->quaternion + 4 * i, call->gravity, call->given_alpha + 6 * i, call->Vdot + 6 * i);
    default:
        return twist_rates_shoulder(call->quaternion + 4 * i, call->gravity, call->given_alpha + 6 * i, call->Vdot + 6 * i);
    }
}

static six_link_status projection_project(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return project_shoulder(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 1:
        return project_upper_arm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 2:
        return project_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->eta + e, call->etadot + e, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 3:
        return project_wrist_roll(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 4:
        return project_wrist_pitch(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    default:
        return project_wrist_roll(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->twist + 6 * i, call->quaternion + 4 * i, call->new_q + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    }
}

static six_link_status placement_forward_kinematics(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return forward_kinematics_shoulder(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 1:
        return forward_kinematics_upper_arm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->eta + e, call->etadot + e, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 2:
        return forward_kinematics_forearm(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->eta + e, call->etadot + e, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 3:
        return forward_kinematics_wrist_roll(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    case 4:
        return forward_kinematics_wrist_pitch(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    default:
        return forward_kinematics_wrist_roll(&c->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->q + q, call->qdot + q, call->new_twist + 6 * i, call->new_quaternion + 4 * i, call->new_position + 3 * i);
    }
}

static six_link_status assembly_joint_rows(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return joint_rows_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->tau + q, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    case 1:
        return joint_rows_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->eta + e, call->etadot + e, call->tau + q, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    case 2:
        return joint_rows_forearm(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->eta + e, call->etadot + e, call->tau + q, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    case 3:
        return joint_rows_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->tau + q, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    case 4:
        return joint_rows_wrist_pitch(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->tau + q, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    default:
        return joint_rows_flange_last(&c->links[i], &chain->links[i], &chain->nodes[i], &chain->nodes[i + 1], call->twist + 6 * i, call->q + q, call->quaternion + 4 * i, call->gravity, call->tau + q, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    }
}

static six_link_status assembly_link_rows(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int i)
{
    static const int CLASS[SIX_LINK_NLINKS] = { 0, 1, 2, 3, 4, 5 };
    const int q = Q_OFFSET[i], e = ETA_OFFSET[i];
    (void)c, (void)call, (void)chain, (void)q, (void)e;
    switch (CLASS[i]) {
    case 0:
        return link_rows_shoulder(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->w_ext + 6 * i, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    case 1:
        return link_rows_upper_arm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->m_eta + e, call->f_eta + e, call->w_ext + 6 * i, call->H + 72 + e, call->W + 72 + e, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    case 2:
        return link_rows_forearm(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->m_eta + e, call->f_eta + e, call->w_ext + 6 * i, call->H + 72 + e, call->W + 72 + e, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    case 3:
        return link_rows_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->w_ext + 6 * i, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    case 4:
        return link_rows_wrist_roll(&c->links[i], &chain->links[i], &chain->nodes[i + 1], call->w_ext + 6 * i, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    default:
        return link_rows_flange_last(&c->links[i], &chain->links[i], call->w_ext + 6 * i, M_PLACE + M_OFFSET[i], call->M, call->H + 12 * i, call->W + 12 * i);
    }
}

/* What is known beforehand: a base at rest that falls up, a tip that carries nothing. */
static void start(const six_link_call *call, six_link_chain *chain)
{
    six_link_node *base = &chain->nodes[0], *tip = &chain->nodes[SIX_LINK_NLINKS];
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

six_link_status six_link_dae_dynamics(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int *fault)
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

six_link_status six_link_projection(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    start(call, chain);
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = projection_project(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

six_link_status six_link_placement(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    start(call, chain);
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        status = placement_forward_kinematics(c, call, chain, i);
        if (status != SIX_LINK_OK) {
            *fault = i;
            return status;
        }
    }
    return SIX_LINK_OK;
}

six_link_status six_link_assembly(const six_link_constants *c, const six_link_call *call, six_link_chain *chain, int *fault)
{
    six_link_status status;
    int i;
    start(call, chain);
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
