/* ella_dynamics.c: forward dynamics of the joint form by block elimination, tip to base;
 * inverse dynamics and mass matrix.
 */
#include "ella_links.h"

/* The whole chain in one piece: outward to the tip, inward with the eliminations, outward with the results. */
ELLA_TARGETS ella_status ella_dynamics(const ella_constants *c, const ella_state *state, const ella_input *input,
    const ella_real *m_eta, ella_work *work, int wanted, ella_output *output)
{
    unsigned long bad = 0; /* bit i: the joint or a mode of link i cannot be solved for */
    int link;

    /* upper_arm, R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn = ella_sine_cosine(state->q[0]);
    const ella_real R_rel_upper_arm_xz = turn.sine, R_rel_upper_arm_zz = turn.cosine;
    const ella_sincos turn_2 = ella_sine_cosine(state->q[1]);
    const ella_real R_rel_upper_arm_yx = turn_2.sine, R_rel_upper_arm_yy = turn_2.cosine;
    const ella_real R_rel_upper_arm_xx = R_rel_upper_arm_zz * R_rel_upper_arm_yy;
    const ella_real minus_R_rel_upper_arm_xy = R_rel_upper_arm_yx * R_rel_upper_arm_zz;
    const ella_real minus_R_rel_upper_arm_zx = R_rel_upper_arm_xz * R_rel_upper_arm_yy;
    const ella_real R_rel_upper_arm_zy = R_rel_upper_arm_xz * R_rel_upper_arm_yx;

    /* upper_arm, omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_upper_arm_x = R_rel_upper_arm_yx * state->v[0];
    const ella_real omega_J_upper_arm_y = R_rel_upper_arm_yy * state->v[0];

    /* upper_arm, beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real t1 = state->v[0] * state->v[1];
    const ella_real beta_omega_upper_arm_x = t1 * R_rel_upper_arm_yy;
    const ella_real minus_beta_omega_upper_arm_y = t1 * R_rel_upper_arm_yx;

    /* upper_arm, alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const ella_real alpha_0_upper_arm_4 = minus_R_rel_upper_arm_zx * c->gravity[2]
        - (R_rel_upper_arm_xx * c->gravity[0] + R_rel_upper_arm_yx * c->gravity[1]);
    const ella_real alpha_0_upper_arm_5 = minus_R_rel_upper_arm_xy * c->gravity[0]
        - R_rel_upper_arm_yy * c->gravity[1] - R_rel_upper_arm_zy * c->gravity[2];
    const ella_real minus_alpha_0_upper_arm_6 = R_rel_upper_arm_xz * c->gravity[0]
        + R_rel_upper_arm_zz * c->gravity[2];

    /* upper_arm, r_T: tip point (11) */
    const ella_real r_T_upper_arm_x = c->links[0].length + state->q[3] * REAL(1.4142135623730951);
    const ella_real r_T_upper_arm_y = state->q[4] * 2;
    const ella_real r_T_upper_arm_z = state->q[5] * 2;

    /* upper_arm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_upper_arm_y = c->links[0].Psi_c_y3 * state->q[5];
    const ella_real theta_upper_arm_z = c->links[0].Psi_c_z2 * state->q[4];

    /* upper_arm, x: squared angle of the tip section */
    const ella_real minus_theta_hat2_upper_arm_33 = theta_upper_arm_y * theta_upper_arm_y;
    const ella_real minus_theta_hat2_upper_arm_22 = theta_upper_arm_z * theta_upper_arm_z;
    const ella_real x_upper_arm = minus_theta_hat2_upper_arm_33 + minus_theta_hat2_upper_arm_22;

    /* upper_arm, c1: Stumpff function of order 1 */
    const ella_real t2 = ella_c5(x_upper_arm);
    const ella_real c3_upper_arm = REAL(0.16666666666666666) - x_upper_arm * t2;
    const ella_real c1_upper_arm = 1 - x_upper_arm * c3_upper_arm;

    /* upper_arm, c2: Stumpff function of order 2 */
    const ella_real t3 = ella_c4(x_upper_arm);
    const ella_real c2_upper_arm = REAL(0.5) - x_upper_arm * t3;

    /* upper_arm, theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_upper_arm_23 = theta_upper_arm_y * theta_upper_arm_z;

    /* upper_arm, J_l: left Jacobian of the exponential */
    const ella_real minus_J_l_upper_arm_xy = c2_upper_arm * theta_upper_arm_z;
    const ella_real J_l_upper_arm_xz = c2_upper_arm * theta_upper_arm_y;
    const ella_real J_l_upper_arm_yy = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_22;
    const ella_real J_l_upper_arm_yz = c3_upper_arm * theta_hat2_upper_arm_23;
    const ella_real J_l_upper_arm_zz = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_33;

    /* upper_arm, R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_upper_arm_xx = 1 - c2_upper_arm * x_upper_arm;
    const ella_real minus_R_T_upper_arm_xy = c1_upper_arm * theta_upper_arm_z;
    const ella_real R_T_upper_arm_xz = c1_upper_arm * theta_upper_arm_y;
    const ella_real R_T_upper_arm_yy = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_22;
    const ella_real R_T_upper_arm_yz = c2_upper_arm * theta_hat2_upper_arm_23;
    const ella_real R_T_upper_arm_zz = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_33;

    /* upper_arm, thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_upper_arm_y = c->links[0].Psi_c_y3 * state->v[5];
    const ella_real thetadot_upper_arm_z = c->links[0].Psi_c_z2 * state->v[4];

    /* upper_arm, omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t4 = theta_upper_arm_y * thetadot_upper_arm_z - theta_upper_arm_z * thetadot_upper_arm_y;
    const ella_real omega_s_upper_arm_x = c2_upper_arm * t4;
    const ella_real omega_s_upper_arm_y = thetadot_upper_arm_y + c3_upper_arm * theta_upper_arm_z * t4;
    const ella_real omega_s_upper_arm_z = thetadot_upper_arm_z - c3_upper_arm * theta_upper_arm_y * t4;

    /* upper_arm, xdot: rate of the squared angle */
    const ella_real xdot_upper_arm = theta_upper_arm_y * 2 * thetadot_upper_arm_y
        + theta_upper_arm_z * 2 * thetadot_upper_arm_z;

    /* upper_arm, c2dot: rate of c2 */
    const ella_real c2dot_upper_arm = xdot_upper_arm * (t3 - c3_upper_arm * REAL(0.5));

    /* upper_arm, c3dot: rate of c3 */
    const ella_real c3dot_upper_arm = xdot_upper_arm * (t2 * REAL(1.5) - t3 * REAL(0.5));

    /* upper_arm, alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_upper_arm_x = c2dot_upper_arm * t4;
    const ella_real alpha_s_upper_arm_y = c3_upper_arm * thetadot_upper_arm_z * t4
        + c3dot_upper_arm * theta_upper_arm_z * t4;
    const ella_real minus_alpha_s_upper_arm_z = c3_upper_arm * thetadot_upper_arm_y * t4
        + c3dot_upper_arm * theta_upper_arm_y * t4;

    /* upper_arm, tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const ella_real omega_T_upper_arm_1 = omega_J_upper_arm_x + omega_s_upper_arm_x;
    const ella_real omega_T_upper_arm_2 = omega_J_upper_arm_y + omega_s_upper_arm_y;
    const ella_real omega_T_upper_arm_3 = state->v[1] + omega_s_upper_arm_z;
    const ella_real alpha_0_T_upper_arm_1 = beta_omega_upper_arm_x + alpha_s_upper_arm_x
        + (omega_J_upper_arm_y * omega_s_upper_arm_z - state->v[1] * omega_s_upper_arm_y);
    const ella_real alpha_0_T_upper_arm_2 = alpha_s_upper_arm_y - minus_beta_omega_upper_arm_y
        + (state->v[1] * omega_s_upper_arm_x - omega_J_upper_arm_x * omega_s_upper_arm_z);
    const ella_real alpha_0_T_upper_arm_3 = omega_J_upper_arm_x * omega_s_upper_arm_y
        - omega_J_upper_arm_y * omega_s_upper_arm_x - minus_alpha_s_upper_arm_z;
    const ella_real t5 = beta_omega_upper_arm_x * r_T_upper_arm_y
        + minus_beta_omega_upper_arm_y * r_T_upper_arm_x - minus_alpha_0_upper_arm_6;
    const ella_real t6 = omega_J_upper_arm_y * r_T_upper_arm_z - state->v[1] * r_T_upper_arm_y
        + state->v[3] * REAL(2.8284271247461903);
    const ella_real t7 = state->v[1] * r_T_upper_arm_x - omega_J_upper_arm_x * r_T_upper_arm_z + state->v[4] * 4;
    const ella_real t8 = omega_J_upper_arm_x * r_T_upper_arm_y - omega_J_upper_arm_y * r_T_upper_arm_x
        + state->v[5] * 4;
    const ella_real alpha_0_T_upper_arm_4 = alpha_0_upper_arm_4 - minus_beta_omega_upper_arm_y * r_T_upper_arm_z
        + (omega_J_upper_arm_y * t8 - state->v[1] * t7);
    const ella_real alpha_0_T_upper_arm_5 = alpha_0_upper_arm_5 - beta_omega_upper_arm_x * r_T_upper_arm_z
        + (state->v[1] * t6 - omega_J_upper_arm_x * t8);
    const ella_real alpha_0_T_upper_arm_6 = t5 + (omega_J_upper_arm_x * t7 - omega_J_upper_arm_y * t6);

    /* forearm, R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn_3 = ella_sine_cosine(state->q[2]);
    const ella_real minus_R_rel_forearm_xy = turn_3.sine, R_rel_forearm_xx = turn_3.cosine;

    /* forearm, R: rotation of F_i relative to the parent's F_i (Ad) */
    const ella_real t9 = minus_R_T_upper_arm_xy * minus_R_rel_forearm_xy;
    const ella_real R_P_forearm_11 = R_T_upper_arm_xx * R_rel_forearm_xx - t9;
    const ella_real t10 = minus_R_T_upper_arm_xy * R_rel_forearm_xx;
    const ella_real minus_R_P_forearm_12 = t10 + R_T_upper_arm_xx * minus_R_rel_forearm_xy;
    const ella_real R_P_forearm_21 = t10 + R_T_upper_arm_yy * minus_R_rel_forearm_xy;
    const ella_real R_P_forearm_22 = R_T_upper_arm_yy * R_rel_forearm_xx - t9;
    const ella_real R_P_forearm_31 = R_T_upper_arm_yz * minus_R_rel_forearm_xy
        - R_T_upper_arm_xz * R_rel_forearm_xx;
    const ella_real R_P_forearm_32 = R_T_upper_arm_yz * R_rel_forearm_xx
        + R_T_upper_arm_xz * minus_R_rel_forearm_xy;
    const ella_real omega_R_forearm_1 = R_P_forearm_11 * omega_T_upper_arm_1
        + R_P_forearm_21 * omega_T_upper_arm_2 + R_P_forearm_31 * omega_T_upper_arm_3;
    const ella_real omega_R_forearm_2 = R_P_forearm_22 * omega_T_upper_arm_2
        - minus_R_P_forearm_12 * omega_T_upper_arm_1 + R_P_forearm_32 * omega_T_upper_arm_3;
    const ella_real omega_R_forearm_3 = R_T_upper_arm_xz * omega_T_upper_arm_1
        + R_T_upper_arm_yz * omega_T_upper_arm_2 + R_T_upper_arm_zz * omega_T_upper_arm_3;

    /* forearm, alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const ella_real omega_forearm_z = omega_R_forearm_3 + state->v[2];
    const ella_real t11 = R_P_forearm_11 * alpha_0_T_upper_arm_1 + R_P_forearm_21 * alpha_0_T_upper_arm_2
        + R_P_forearm_31 * alpha_0_T_upper_arm_3;
    const ella_real t12 = R_P_forearm_22 * alpha_0_T_upper_arm_2 - minus_R_P_forearm_12 * alpha_0_T_upper_arm_1
        + R_P_forearm_32 * alpha_0_T_upper_arm_3;
    const ella_real alpha_0_forearm_3 = R_T_upper_arm_xz * alpha_0_T_upper_arm_1
        + R_T_upper_arm_yz * alpha_0_T_upper_arm_2 + R_T_upper_arm_zz * alpha_0_T_upper_arm_3;
    const ella_real alpha_0_forearm_1 = t11 + omega_R_forearm_2 * state->v[2];
    const ella_real alpha_0_forearm_2 = t12 - omega_R_forearm_1 * state->v[2];
    const ella_real alpha_0_forearm_4 = R_P_forearm_11 * alpha_0_T_upper_arm_4
        + R_P_forearm_21 * alpha_0_T_upper_arm_5 + R_P_forearm_31 * alpha_0_T_upper_arm_6;
    const ella_real alpha_0_forearm_5 = R_P_forearm_22 * alpha_0_T_upper_arm_5
        - minus_R_P_forearm_12 * alpha_0_T_upper_arm_4 + R_P_forearm_32 * alpha_0_T_upper_arm_6;
    const ella_real alpha_0_forearm_6 = R_T_upper_arm_xz * alpha_0_T_upper_arm_4
        + R_T_upper_arm_yz * alpha_0_T_upper_arm_5 + R_T_upper_arm_zz * alpha_0_T_upper_arm_6;

    /* forearm, r_T: tip point (11) */
    const ella_real r_T_forearm_x = c->links[1].length + state->q[6] * REAL(1.4142135623730951);
    const ella_real r_T_forearm_y = state->q[7] * 2;
    const ella_real r_T_forearm_z = state->q[8] * 2;

    /* forearm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_forearm_y = c->links[1].Psi_c_y3 * state->q[8];
    const ella_real theta_forearm_z = c->links[1].Psi_c_z2 * state->q[7];

    /* forearm, x: squared angle of the tip section */
    const ella_real minus_theta_hat2_forearm_33 = theta_forearm_y * theta_forearm_y;
    const ella_real minus_theta_hat2_forearm_22 = theta_forearm_z * theta_forearm_z;
    const ella_real x_forearm = minus_theta_hat2_forearm_33 + minus_theta_hat2_forearm_22;

    /* forearm, c1: Stumpff function of order 1 */
    const ella_real c3_forearm = REAL(0.16666666666666666) - x_forearm * ella_c5(x_forearm);
    const ella_real c1_forearm = 1 - x_forearm * c3_forearm;

    /* forearm, c2: Stumpff function of order 2 */
    const ella_real c2_forearm = REAL(0.5) - x_forearm * ella_c4(x_forearm);

    /* forearm, theta_hat2: square of the rotation vector's skew matrix */
    const ella_real theta_hat2_forearm_23 = theta_forearm_y * theta_forearm_z;

    /* forearm, J_l: left Jacobian of the exponential */
    const ella_real minus_J_l_forearm_xy = c2_forearm * theta_forearm_z;
    const ella_real J_l_forearm_xz = c2_forearm * theta_forearm_y;
    const ella_real J_l_forearm_yy = 1 - c3_forearm * minus_theta_hat2_forearm_22;
    const ella_real J_l_forearm_yz = c3_forearm * theta_hat2_forearm_23;
    const ella_real J_l_forearm_zz = 1 - c3_forearm * minus_theta_hat2_forearm_33;

    /* forearm, R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_forearm_xx = 1 - c2_forearm * x_forearm;
    const ella_real minus_R_T_forearm_xy = c1_forearm * theta_forearm_z;
    const ella_real R_T_forearm_xz = c1_forearm * theta_forearm_y;
    const ella_real R_T_forearm_yy = 1 - c2_forearm * minus_theta_hat2_forearm_22;
    const ella_real R_T_forearm_yz = c2_forearm * theta_hat2_forearm_23;
    const ella_real R_T_forearm_zz = 1 - c2_forearm * minus_theta_hat2_forearm_33;

    /* forearm, tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const ella_real t13 = omega_R_forearm_2 * r_T_forearm_z - omega_forearm_z * r_T_forearm_y
        + state->v[6] * REAL(2.8284271247461903);
    const ella_real t14 = omega_forearm_z * r_T_forearm_x - omega_R_forearm_1 * r_T_forearm_z + state->v[7] * 4;
    const ella_real t15 = omega_R_forearm_1 * r_T_forearm_y - omega_R_forearm_2 * r_T_forearm_x + state->v[8] * 4;
    const ella_real alpha_0_T_forearm_4 = alpha_0_forearm_4
        + (alpha_0_forearm_2 * r_T_forearm_z - alpha_0_forearm_3 * r_T_forearm_y)
        + (omega_R_forearm_2 * t15 - omega_forearm_z * t14);
    const ella_real alpha_0_T_forearm_5 = alpha_0_forearm_5
        + (alpha_0_forearm_3 * r_T_forearm_x - alpha_0_forearm_1 * r_T_forearm_z)
        + (omega_forearm_z * t13 - omega_R_forearm_1 * t15);
    const ella_real alpha_0_T_forearm_6 = alpha_0_forearm_6
        + (alpha_0_forearm_1 * r_T_forearm_y - alpha_0_forearm_2 * r_T_forearm_x)
        + (omega_R_forearm_1 * t14 - omega_R_forearm_2 * t13);

    /* forearm, S: first moment */
    const ella_real S_forearm_x = c->links[1].S_0_x + state->q[6] * c->links[1].sigma_x1;
    const ella_real S_forearm_y = state->q[7] * c->links[1].sigma_y2;
    const ella_real S_forearm_z = state->q[8] * c->links[1].sigma_y2;

    /* forearm, Sdot: rate of the first moment */
    const ella_real Sdot_forearm_x = state->v[6] * c->links[1].sigma_x1;
    const ella_real Sdot_forearm_y = state->v[7] * c->links[1].sigma_y2;
    const ella_real Sdot_forearm_z = state->v[8] * c->links[1].sigma_y2;

    /* forearm, L: first moment weighted by each mode shape (85) */
    const ella_real L_forearm_x1 = c->links[1].chi_1 + c->links[1].mu * state->q[6];
    const ella_real L_forearm_x2 = c->links[1].chi_2 + c->links[1].Gamma_xy_11 * state->q[6];
    const ella_real L_forearm_y1 = c->links[1].Gamma_xy_11 * state->q[7];
    const ella_real L_forearm_y2 = c->links[1].mu * state->q[7];
    const ella_real L_forearm_z1 = c->links[1].Gamma_xy_11 * state->q[8];
    const ella_real L_forearm_z2 = state->q[8] * c->links[1].mu;

    /* forearm, Ldot: rate of L */
    const ella_real Ldot_forearm_x2 = c->links[1].Gamma_xy_11 * state->v[6];
    const ella_real Ldot_forearm_y1 = c->links[1].Gamma_xy_11 * state->v[7];
    const ella_real Ldot_forearm_y2 = c->links[1].mu * state->v[7];
    const ella_real Ldot_forearm_z1 = c->links[1].Gamma_xy_11 * state->v[8];
    const ella_real Ldot_forearm_z2 = state->v[8] * c->links[1].mu;

    /* forearm, J: second moment */
    const ella_real J_forearm_xx = c->links[1].J_0_xx + L_forearm_x1 * state->q[6]
        + c->links[1].chi_1 * state->q[6];
    const ella_real J_forearm_xy = L_forearm_y1 * state->q[6] + c->links[1].chi_2 * state->q[7];
    const ella_real J_forearm_xz = L_forearm_z1 * state->q[6] + c->links[1].chi_2 * state->q[8];
    const ella_real J_forearm_yy = L_forearm_y2 * state->q[7];
    const ella_real J_forearm_yz = L_forearm_z2 * state->q[7];
    const ella_real J_forearm_zz = L_forearm_z2 * state->q[8];

    /* forearm, I: inertia about the origin, deformed */
    const ella_real I_forearm_xx = c->links[1].I_s + J_forearm_yy + J_forearm_zz;
    const ella_real I_forearm_yy = J_forearm_xx + J_forearm_zz;
    const ella_real I_forearm_zz = J_forearm_xx + J_forearm_yy;

    /* forearm, Omega: acceleration of a place by the link's turning */
    const ella_real t16 = omega_R_forearm_2 * omega_R_forearm_2;
    const ella_real t17 = omega_forearm_z * omega_forearm_z;
    const ella_real minus_Omega_forearm_xx = t16 + t17;
    const ella_real t18 = omega_R_forearm_1 * omega_R_forearm_2;
    const ella_real Omega_forearm_xy = t18 - alpha_0_forearm_3;
    const ella_real t19 = omega_R_forearm_1 * omega_forearm_z;
    const ella_real Omega_forearm_xz = alpha_0_forearm_2 + t19;
    const ella_real Omega_forearm_yx = alpha_0_forearm_3 + t18;
    const ella_real t20 = omega_R_forearm_1 * omega_R_forearm_1;
    const ella_real minus_Omega_forearm_yy = t20 + t17;
    const ella_real t21 = omega_R_forearm_2 * omega_forearm_z;
    const ella_real Omega_forearm_yz = t21 - alpha_0_forearm_1;
    const ella_real Omega_forearm_zx = t19 - alpha_0_forearm_2;
    const ella_real Omega_forearm_zy = alpha_0_forearm_1 + t21;
    const ella_real minus_Omega_forearm_zz = t20 + t16;

    /* forearm, B: moment of the elastic velocity */
    const ella_real B_forearm_xx = L_forearm_x1 * state->v[6];
    const ella_real B_forearm_xy = L_forearm_y1 * state->v[6];
    const ella_real B_forearm_xz = L_forearm_z1 * state->v[6];
    const ella_real B_forearm_yx = L_forearm_x2 * state->v[7];
    const ella_real B_forearm_yy = L_forearm_y2 * state->v[7];
    const ella_real B_forearm_yz = L_forearm_z2 * state->v[7];
    const ella_real B_forearm_zx = L_forearm_x2 * state->v[8];
    const ella_real B_forearm_zy = L_forearm_y2 * state->v[8];
    const ella_real B_forearm_zz = L_forearm_z2 * state->v[8];

    /* forearm, h_c: half of the Coriolis wrench */
    const ella_real t22 = B_forearm_yy * omega_R_forearm_1 + B_forearm_zz * omega_R_forearm_1
        - B_forearm_xy * omega_R_forearm_2;
    const ella_real h_c_forearm_1 = t22 - B_forearm_xz * omega_forearm_z;
    const ella_real t23 = B_forearm_xx * omega_R_forearm_2 + B_forearm_zz * omega_R_forearm_2
        - B_forearm_yx * omega_R_forearm_1;
    const ella_real h_c_forearm_2 = t23 - B_forearm_yz * omega_forearm_z;
    const ella_real t24 = B_forearm_xx * omega_forearm_z + B_forearm_yy * omega_forearm_z
        - B_forearm_zx * omega_R_forearm_1;
    const ella_real h_c_forearm_3 = t24 - B_forearm_zy * omega_R_forearm_2;
    const ella_real h_c_forearm_4 = Sdot_forearm_z * omega_R_forearm_2 - Sdot_forearm_y * omega_forearm_z;
    const ella_real h_c_forearm_5 = Sdot_forearm_x * omega_forearm_z - Sdot_forearm_z * omega_R_forearm_1;
    const ella_real h_c_forearm_6 = Sdot_forearm_y * omega_R_forearm_1 - Sdot_forearm_x * omega_R_forearm_2;

    /* forearm, H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t25 = h_c_forearm_1 + c->links[1].I_s * alpha_0_forearm_1 + J_forearm_xy * Omega_forearm_zx
        + J_forearm_yy * Omega_forearm_zy;
    const ella_real t26 = t25 + J_forearm_yz * (minus_Omega_forearm_yy - minus_Omega_forearm_zz)
        + S_forearm_y * alpha_0_forearm_6;
    const ella_real H_star_forearm_1 = t26 - J_forearm_xz * Omega_forearm_yx - J_forearm_zz * Omega_forearm_yz
        - S_forearm_z * alpha_0_forearm_5;
    const ella_real t27 = h_c_forearm_2 + J_forearm_xz * (minus_Omega_forearm_zz - minus_Omega_forearm_xx)
        + J_forearm_yz * Omega_forearm_xy;
    const ella_real t28 = c->links[1].I_s * omega_R_forearm_1;
    const ella_real t29 = t27 + J_forearm_zz * Omega_forearm_xz + S_forearm_z * alpha_0_forearm_4
        + t28 * omega_forearm_z - J_forearm_xx * Omega_forearm_zx;
    const ella_real H_star_forearm_2 = t29 - J_forearm_xy * Omega_forearm_zy - S_forearm_x * alpha_0_forearm_6;
    const ella_real t30 = h_c_forearm_3 + J_forearm_xx * Omega_forearm_yx
        + J_forearm_xy * (minus_Omega_forearm_xx - minus_Omega_forearm_yy);
    const ella_real t31 = t30 + J_forearm_xz * Omega_forearm_yz + S_forearm_x * alpha_0_forearm_5
        - J_forearm_yy * Omega_forearm_xy;
    const ella_real H_star_forearm_3 = t31 - J_forearm_yz * Omega_forearm_xz - S_forearm_y * alpha_0_forearm_4
        - t28 * omega_R_forearm_2;
    const ella_real t32 = h_c_forearm_4 - minus_Omega_forearm_xx * S_forearm_x + Omega_forearm_xy * S_forearm_y
        + Omega_forearm_xz * S_forearm_z;
    const ella_real H_star_forearm_4 = t32 + alpha_0_forearm_4 * c->links[1].mu;
    const ella_real t33 = h_c_forearm_5 + Omega_forearm_yx * S_forearm_x - minus_Omega_forearm_yy * S_forearm_y
        + Omega_forearm_yz * S_forearm_z;
    const ella_real H_star_forearm_5 = t33 + alpha_0_forearm_5 * c->links[1].mu;
    const ella_real t34 = h_c_forearm_6 + Omega_forearm_zx * S_forearm_x + Omega_forearm_zy * S_forearm_y
        - minus_Omega_forearm_zz * S_forearm_z;
    const ella_real H_star_forearm_6 = t34 + alpha_0_forearm_6 * c->links[1].mu;

    /* forearm, h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_forearm_1 = H_star_forearm_1 + h_c_forearm_1;
    const ella_real h_V_forearm_2 = H_star_forearm_2 + h_c_forearm_2;
    const ella_real h_V_forearm_3 = H_star_forearm_3 + h_c_forearm_3;
    const ella_real h_V_forearm_4 = H_star_forearm_4 + h_c_forearm_4;
    const ella_real h_V_forearm_5 = H_star_forearm_5 + h_c_forearm_5;
    const ella_real h_V_forearm_6 = H_star_forearm_6 + h_c_forearm_6;

    /* forearm, h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real t35 = L_forearm_y1 * Omega_forearm_xy - L_forearm_x1 * minus_Omega_forearm_xx
        + L_forearm_z1 * Omega_forearm_xz;
    const ella_real h_eta_forearm_1 = t35 + alpha_0_forearm_4 * c->links[1].sigma_x1
        + Ldot_forearm_z1 * 2 * omega_R_forearm_2 - Ldot_forearm_y1 * 2 * omega_forearm_z;
    const ella_real t36 = L_forearm_x2 * Omega_forearm_yx - L_forearm_y2 * minus_Omega_forearm_yy
        + L_forearm_z2 * Omega_forearm_yz;
    const ella_real t37 = Ldot_forearm_x2 * 2;
    const ella_real h_eta_forearm_2 = t36 + alpha_0_forearm_5 * c->links[1].sigma_y2 + t37 * omega_forearm_z
        - Ldot_forearm_z2 * 2 * omega_R_forearm_1;
    const ella_real t38 = L_forearm_x2 * Omega_forearm_zx + L_forearm_y2 * Omega_forearm_zy
        - L_forearm_z2 * minus_Omega_forearm_zz;
    const ella_real h_eta_forearm_3 = t38 + alpha_0_forearm_6 * c->links[1].sigma_y2
        + Ldot_forearm_y2 * 2 * omega_R_forearm_1 - t37 * omega_R_forearm_2;

    /* forearm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real minus_p_T_forearm_1 = R_T_forearm_xx * input->w_ext[1][0]
        - minus_R_T_forearm_xy * input->w_ext[1][1] + R_T_forearm_xz * input->w_ext[1][2];
    const ella_real minus_p_T_forearm_2 = minus_R_T_forearm_xy * input->w_ext[1][0]
        + R_T_forearm_yy * input->w_ext[1][1] + R_T_forearm_yz * input->w_ext[1][2];
    const ella_real minus_p_T_forearm_3 = R_T_forearm_yz * input->w_ext[1][1]
        - R_T_forearm_xz * input->w_ext[1][0] + R_T_forearm_zz * input->w_ext[1][2];
    const ella_real t39 = R_T_forearm_xx * input->w_ext[1][3] - minus_R_T_forearm_xy * input->w_ext[1][4]
        + R_T_forearm_xz * input->w_ext[1][5];
    const ella_real t40 = minus_R_T_forearm_xy * input->w_ext[1][3] + R_T_forearm_yy * input->w_ext[1][4]
        + R_T_forearm_yz * input->w_ext[1][5];
    const ella_real t41 = R_T_forearm_yz * input->w_ext[1][4] - R_T_forearm_xz * input->w_ext[1][3]
        + R_T_forearm_zz * input->w_ext[1][5];
    const ella_real p_T_forearm_4 = c->links[1].body0_mass * alpha_0_T_forearm_4 - t39;
    const ella_real p_T_forearm_5 = c->links[1].body0_mass * alpha_0_T_forearm_5 - t40;
    const ella_real p_T_forearm_6 = c->links[1].body0_mass * alpha_0_T_forearm_6 - t41;

    /* forearm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real Theta_forearm_12 = J_l_forearm_xz * c->links[1].Psi_c_z2;
    const ella_real minus_Theta_forearm_13 = minus_J_l_forearm_xy * c->links[1].Psi_c_y3;
    const ella_real Theta_forearm_22 = J_l_forearm_yz * c->links[1].Psi_c_z2;
    const ella_real Theta_forearm_23 = J_l_forearm_yy * c->links[1].Psi_c_y3;
    const ella_real Theta_forearm_32 = J_l_forearm_zz * c->links[1].Psi_c_z2;
    const ella_real Theta_forearm_33 = J_l_forearm_yz * c->links[1].Psi_c_y3;
    const ella_real t42 = r_T_forearm_z * c->links[1].body0_mass;
    const ella_real t43 = r_T_forearm_y * c->links[1].body0_mass;
    const ella_real t44 = r_T_forearm_x * c->links[1].body0_mass;
    const ella_real t45 = r_T_forearm_z * t42;
    const ella_real t46 = r_T_forearm_y * t43;
    const ella_real t47 = r_T_forearm_x * t44;
    const ella_real M_loaded_forearm_11 = I_forearm_xx + (t46 + t45);
    const ella_real minus_M_loaded_forearm_12 = r_T_forearm_y * t44 + J_forearm_xy;
    const ella_real minus_M_loaded_forearm_13 = r_T_forearm_z * t44 + J_forearm_xz;
    const ella_real minus_M_loaded_forearm_15 = t42 + S_forearm_z;
    const ella_real M_loaded_forearm_16 = S_forearm_y + t43;
    const ella_real M_loaded_forearm_22 = I_forearm_yy + (t45 + t47);
    const ella_real minus_M_loaded_forearm_23 = r_T_forearm_z * t43 + J_forearm_yz;
    const ella_real minus_M_loaded_forearm_26 = t44 + S_forearm_x;
    const ella_real M_loaded_forearm_33 = I_forearm_zz + (t47 + t46);
    const ella_real M_loaded_forearm_44 = c->links[1].mu + c->links[1].body0_mass;
    const ella_real h_loaded_forearm_1 = h_V_forearm_1
        + (r_T_forearm_y * p_T_forearm_6 - r_T_forearm_z * p_T_forearm_5 - minus_p_T_forearm_1);
    const ella_real h_loaded_forearm_2 = h_V_forearm_2
        + (r_T_forearm_z * p_T_forearm_4 - r_T_forearm_x * p_T_forearm_6 - minus_p_T_forearm_2);
    const ella_real h_loaded_forearm_3 = h_V_forearm_3
        + (r_T_forearm_x * p_T_forearm_5 - r_T_forearm_y * p_T_forearm_4 - minus_p_T_forearm_3);
    const ella_real h_loaded_forearm_4 = h_V_forearm_4 + p_T_forearm_4;
    const ella_real h_loaded_forearm_5 = h_V_forearm_5 + p_T_forearm_5;
    const ella_real h_loaded_forearm_6 = h_V_forearm_6 + p_T_forearm_6;
    const ella_real t48 = c->links[1].body0_mass * REAL(1.4142135623730951);
    const ella_real t49 = c->links[1].body0_mass * 2;
    const ella_real minus_C_forearm_12 = r_T_forearm_z * t49 + L_forearm_z2;
    const ella_real C_forearm_13 = L_forearm_y2 + r_T_forearm_y * t49;
    const ella_real C_forearm_21 = L_forearm_z1 + r_T_forearm_z * t48;
    const ella_real minus_C_forearm_23 = r_T_forearm_x * t49 + L_forearm_x2;
    const ella_real minus_C_forearm_31 = r_T_forearm_y * t48 + L_forearm_y1;
    const ella_real C_forearm_41 = c->links[1].sigma_x1 + t48;
    const ella_real C_forearm_52 = c->links[1].sigma_y2 + t49;
    const ella_real modal_inertia_forearm_11 = c->links[1].body0_mass * REAL(2.0000000000000004) + m_eta[3];
    bad |= (unsigned long)(!(modal_inertia_forearm_11 > 0)) << 1;
    const ella_real t50 = c->links[1].body0_mass * 4;
    const ella_real modal_inertia_forearm_22 = t50 + m_eta[4];
    bad |= (unsigned long)(!(modal_inertia_forearm_22 > 0)) << 1;
    const ella_real modal_inertia_forearm_33 = t50 + m_eta[5];
    bad |= (unsigned long)(!(modal_inertia_forearm_33 > 0)) << 1;
    const ella_real t51 = Theta_forearm_12 * minus_p_T_forearm_1 + Theta_forearm_22 * minus_p_T_forearm_2
        + Theta_forearm_32 * minus_p_T_forearm_3;
    const ella_real t52 = minus_Theta_forearm_13 * minus_p_T_forearm_1 - Theta_forearm_23 * minus_p_T_forearm_2
        - Theta_forearm_33 * minus_p_T_forearm_3;
    const ella_real h_phi_forearm_1 = h_eta_forearm_1 + work->f_eta[3] + p_T_forearm_4 * REAL(1.4142135623730951);
    const ella_real h_phi_forearm_2 = h_eta_forearm_2 + work->f_eta[4] + (p_T_forearm_5 * 2 - t51);
    const ella_real h_phi_forearm_3 = h_eta_forearm_3 + work->f_eta[5] + (t52 + p_T_forearm_6 * 2);
    const ella_real modes_inverse_forearm_1 = 1 / modal_inertia_forearm_11;
    const ella_real modes_inverse_forearm_2 = 1 / modal_inertia_forearm_22;
    const ella_real modes_inverse_forearm_3 = 1 / modal_inertia_forearm_33;
    const ella_real modes_W_forearm_12 = C_forearm_21 * modes_inverse_forearm_1;
    const ella_real minus_modes_W_forearm_13 = minus_C_forearm_31 * modes_inverse_forearm_1;
    const ella_real modes_W_forearm_14 = C_forearm_41 * modes_inverse_forearm_1;
    const ella_real minus_modes_W_forearm_21 = minus_C_forearm_12 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_23 = minus_C_forearm_23 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_25 = C_forearm_52 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_31 = C_forearm_13 * modes_inverse_forearm_3;
    const ella_real minus_modes_W_forearm_32 = minus_C_forearm_23 * modes_inverse_forearm_3;
    const ella_real modes_W_forearm_36 = C_forearm_52 * modes_inverse_forearm_3;
    const ella_real modes_w_forearm_1 = h_phi_forearm_1 * modes_inverse_forearm_1;
    const ella_real modes_w_forearm_2 = h_phi_forearm_2 * modes_inverse_forearm_2;
    const ella_real modes_w_forearm_3 = h_phi_forearm_3 * modes_inverse_forearm_3;
    const ella_real M_i_forearm_11 = M_loaded_forearm_11
        - (minus_C_forearm_12 * minus_modes_W_forearm_21 + C_forearm_13 * modes_W_forearm_31);
    const ella_real M_i_forearm_12 = C_forearm_13 * minus_modes_W_forearm_32 - minus_M_loaded_forearm_12;
    const ella_real M_i_forearm_13 = minus_C_forearm_12 * modes_W_forearm_23 - minus_M_loaded_forearm_13;
    const ella_real M_i_forearm_15 = minus_C_forearm_12 * modes_W_forearm_25 - minus_M_loaded_forearm_15;
    const ella_real M_i_forearm_16 = M_loaded_forearm_16 - C_forearm_13 * modes_W_forearm_36;
    const ella_real M_i_forearm_22 = M_loaded_forearm_22
        - (C_forearm_21 * modes_W_forearm_12 + minus_C_forearm_23 * minus_modes_W_forearm_32);
    const ella_real M_i_forearm_23 = C_forearm_21 * minus_modes_W_forearm_13 - minus_M_loaded_forearm_23;
    const ella_real M_i_forearm_24 = minus_M_loaded_forearm_15 - C_forearm_21 * modes_W_forearm_14;
    const ella_real M_i_forearm_26 = minus_C_forearm_23 * modes_W_forearm_36 - minus_M_loaded_forearm_26;
    const ella_real M_i_forearm_33 = M_loaded_forearm_33
        - (minus_C_forearm_31 * minus_modes_W_forearm_13 + minus_C_forearm_23 * modes_W_forearm_23);
    const ella_real M_i_forearm_34 = minus_C_forearm_31 * modes_W_forearm_14 - M_loaded_forearm_16;
    const ella_real M_i_forearm_35 = minus_M_loaded_forearm_26 - minus_C_forearm_23 * modes_W_forearm_25;
    const ella_real M_i_forearm_44 = M_loaded_forearm_44 - C_forearm_41 * modes_W_forearm_14;
    const ella_real M_i_forearm_55 = M_loaded_forearm_44 - C_forearm_52 * modes_W_forearm_25;
    const ella_real M_i_forearm_66 = M_loaded_forearm_44 - C_forearm_52 * modes_W_forearm_36;
    const ella_real h_i_forearm_1 = h_loaded_forearm_1
        - (modes_W_forearm_31 * h_phi_forearm_3 - minus_modes_W_forearm_21 * h_phi_forearm_2);
    const ella_real h_i_forearm_2 = h_loaded_forearm_2
        - (modes_W_forearm_12 * h_phi_forearm_1 - minus_modes_W_forearm_32 * h_phi_forearm_3);
    const ella_real h_i_forearm_3 = h_loaded_forearm_3
        - (modes_W_forearm_23 * h_phi_forearm_2 - minus_modes_W_forearm_13 * h_phi_forearm_1);
    const ella_real h_i_forearm_4 = h_loaded_forearm_4 - modes_W_forearm_14 * h_phi_forearm_1;
    const ella_real h_i_forearm_5 = h_loaded_forearm_5 - modes_W_forearm_25 * h_phi_forearm_2;
    const ella_real h_i_forearm_6 = h_loaded_forearm_6 - modes_W_forearm_36 * h_phi_forearm_3;

    /* forearm, joint: its accelerations eliminated from its rows (43) */
    const ella_real t53 = ELLA_REAL_EPSILON * 8;
    bad |= (unsigned long)(!(M_i_forearm_33 - t53 * (M_i_forearm_11 + M_i_forearm_22 + M_i_forearm_33) > 0)) << 1;
    const ella_real joint_inverse_forearm_1 = 1 / M_i_forearm_33;
    const ella_real joint_W_forearm_11 = M_i_forearm_13 * joint_inverse_forearm_1;
    const ella_real joint_W_forearm_12 = M_i_forearm_23 * joint_inverse_forearm_1;
    const ella_real joint_W_forearm_14 = M_i_forearm_34 * joint_inverse_forearm_1;
    const ella_real joint_W_forearm_15 = M_i_forearm_35 * joint_inverse_forearm_1;
    const ella_real joint_w_forearm_1 = (input->tau[2] - h_i_forearm_3) * joint_inverse_forearm_1;
    const ella_real Lambda_i_forearm_11 = M_i_forearm_11 - M_i_forearm_13 * joint_W_forearm_11;
    const ella_real Lambda_i_forearm_12 = M_i_forearm_12 - M_i_forearm_13 * joint_W_forearm_12;
    const ella_real minus_Lambda_i_forearm_14 = M_i_forearm_13 * joint_W_forearm_14;
    const ella_real Lambda_i_forearm_15 = M_i_forearm_15 - M_i_forearm_13 * joint_W_forearm_15;
    const ella_real Lambda_i_forearm_22 = M_i_forearm_22 - M_i_forearm_23 * joint_W_forearm_12;
    const ella_real Lambda_i_forearm_24 = M_i_forearm_24 - M_i_forearm_23 * joint_W_forearm_14;
    const ella_real minus_Lambda_i_forearm_25 = M_i_forearm_23 * joint_W_forearm_15;
    const ella_real Lambda_i_forearm_44 = M_i_forearm_44 - M_i_forearm_34 * joint_W_forearm_14;
    const ella_real minus_Lambda_i_forearm_45 = M_i_forearm_34 * joint_W_forearm_15;
    const ella_real Lambda_i_forearm_55 = M_i_forearm_55 - M_i_forearm_35 * joint_W_forearm_15;
    const ella_real p_i_forearm_1 = h_i_forearm_1 + M_i_forearm_13 * joint_w_forearm_1;
    const ella_real p_i_forearm_2 = h_i_forearm_2 + M_i_forearm_23 * joint_w_forearm_1;
    const ella_real p_i_forearm_4 = h_i_forearm_4 + M_i_forearm_34 * joint_w_forearm_1;
    const ella_real p_i_forearm_5 = h_i_forearm_5 + M_i_forearm_35 * joint_w_forearm_1;

    /* forearm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const ella_real t54 = Lambda_i_forearm_11 * R_P_forearm_21 + Lambda_i_forearm_12 * R_P_forearm_22;
    const ella_real t55 = Lambda_i_forearm_11 * R_P_forearm_31 + Lambda_i_forearm_12 * R_P_forearm_32;
    const ella_real t56 = Lambda_i_forearm_12 * R_P_forearm_21 + Lambda_i_forearm_22 * R_P_forearm_22;
    const ella_real t57 = Lambda_i_forearm_12 * R_P_forearm_31 + Lambda_i_forearm_22 * R_P_forearm_32;
    const ella_real t58 = R_P_forearm_11
        * (Lambda_i_forearm_11 * R_P_forearm_11 - Lambda_i_forearm_12 * minus_R_P_forearm_12);
    const ella_real t59 = minus_R_P_forearm_12
        * (Lambda_i_forearm_12 * R_P_forearm_11 - Lambda_i_forearm_22 * minus_R_P_forearm_12);
    const ella_real Lambda_forearm_1 = t58 - t59;
    const ella_real Lambda_forearm_2 = R_P_forearm_11 * t54 - minus_R_P_forearm_12 * t56;
    const ella_real Lambda_forearm_3 = R_P_forearm_11 * t55 - minus_R_P_forearm_12 * t57;
    const ella_real Lambda_forearm_7 = R_P_forearm_21 * t54 + R_P_forearm_22 * t56;
    const ella_real Lambda_forearm_8 = R_P_forearm_21 * t55 + R_P_forearm_22 * t57;
    const ella_real Lambda_forearm_12 = R_P_forearm_31 * t55 + R_P_forearm_32 * t57;
    const ella_real t60 = M_i_forearm_16 * R_T_upper_arm_xz
        - (minus_Lambda_i_forearm_14 * R_P_forearm_11 + Lambda_i_forearm_15 * minus_R_P_forearm_12);
    const ella_real t61 = Lambda_i_forearm_15 * R_P_forearm_22 - minus_Lambda_i_forearm_14 * R_P_forearm_21
        + M_i_forearm_16 * R_T_upper_arm_yz;
    const ella_real t62 = Lambda_i_forearm_15 * R_P_forearm_32 - minus_Lambda_i_forearm_14 * R_P_forearm_31
        + M_i_forearm_16 * R_T_upper_arm_zz;
    const ella_real t63 = Lambda_i_forearm_24 * R_P_forearm_11 + minus_Lambda_i_forearm_25 * minus_R_P_forearm_12
        + M_i_forearm_26 * R_T_upper_arm_xz;
    const ella_real t64 = Lambda_i_forearm_24 * R_P_forearm_21 - minus_Lambda_i_forearm_25 * R_P_forearm_22
        + M_i_forearm_26 * R_T_upper_arm_yz;
    const ella_real t65 = Lambda_i_forearm_24 * R_P_forearm_31 - minus_Lambda_i_forearm_25 * R_P_forearm_32
        + M_i_forearm_26 * R_T_upper_arm_zz;
    const ella_real Lambda_forearm_4 = R_P_forearm_11 * t60 - minus_R_P_forearm_12 * t63;
    const ella_real Lambda_forearm_5 = R_P_forearm_11 * t61 - minus_R_P_forearm_12 * t64;
    const ella_real Lambda_forearm_6 = R_P_forearm_11 * t62 - minus_R_P_forearm_12 * t65;
    const ella_real Lambda_forearm_9 = R_P_forearm_21 * t60 + R_P_forearm_22 * t63;
    const ella_real Lambda_forearm_10 = R_P_forearm_21 * t61 + R_P_forearm_22 * t64;
    const ella_real Lambda_forearm_11 = R_P_forearm_21 * t62 + R_P_forearm_22 * t65;
    const ella_real Lambda_forearm_13 = R_P_forearm_31 * t60 + R_P_forearm_32 * t63;
    const ella_real Lambda_forearm_14 = R_P_forearm_31 * t61 + R_P_forearm_32 * t64;
    const ella_real Lambda_forearm_15 = R_P_forearm_31 * t62 + R_P_forearm_32 * t65;
    const ella_real t66 = (Lambda_i_forearm_44 - M_i_forearm_66) * REAL(0.5);
    const ella_real t67 = t66 * R_P_forearm_11 + minus_Lambda_i_forearm_45 * minus_R_P_forearm_12;
    const ella_real t68 = t66 * R_P_forearm_21 - minus_Lambda_i_forearm_45 * R_P_forearm_22;
    const ella_real t69 = t66 * R_P_forearm_31 - minus_Lambda_i_forearm_45 * R_P_forearm_32;
    const ella_real t70 = (Lambda_i_forearm_55 - M_i_forearm_66) * REAL(0.5);
    const ella_real t71 = t70 * minus_R_P_forearm_12;
    const ella_real t72 = t70 * R_P_forearm_22;
    const ella_real t73 = t70 * R_P_forearm_32;
    const ella_real Lambda_forearm_16 = (R_P_forearm_11 * t67 + minus_R_P_forearm_12 * t71) * 2 + M_i_forearm_66;
    const ella_real Lambda_forearm_17 = R_P_forearm_11 * t68 - minus_R_P_forearm_12 * t72
        + (R_P_forearm_21 * t67 - R_P_forearm_22 * t71);
    const ella_real Lambda_forearm_18 = R_P_forearm_11 * t69 - minus_R_P_forearm_12 * t73
        + (R_P_forearm_31 * t67 - R_P_forearm_32 * t71);
    const ella_real Lambda_forearm_19 = (R_P_forearm_21 * t68 + R_P_forearm_22 * t72) * 2 + M_i_forearm_66;
    const ella_real Lambda_forearm_20 = R_P_forearm_21 * t69 + R_P_forearm_22 * t73
        + (R_P_forearm_31 * t68 + R_P_forearm_32 * t72);
    const ella_real Lambda_forearm_21 = (R_P_forearm_31 * t69 + R_P_forearm_32 * t73) * 2 + M_i_forearm_66;
    const ella_real p_forearm_1 = R_P_forearm_11 * p_i_forearm_1 - minus_R_P_forearm_12 * p_i_forearm_2
        + R_T_upper_arm_xz * input->tau[2];
    const ella_real p_forearm_2 = R_P_forearm_21 * p_i_forearm_1 + R_P_forearm_22 * p_i_forearm_2
        + R_T_upper_arm_yz * input->tau[2];
    const ella_real p_forearm_3 = R_P_forearm_31 * p_i_forearm_1 + R_P_forearm_32 * p_i_forearm_2
        + R_T_upper_arm_zz * input->tau[2];
    const ella_real p_forearm_4 = R_P_forearm_11 * p_i_forearm_4 - minus_R_P_forearm_12 * p_i_forearm_5
        + R_T_upper_arm_xz * h_i_forearm_6;
    const ella_real p_forearm_5 = R_P_forearm_21 * p_i_forearm_4 + R_P_forearm_22 * p_i_forearm_5
        + R_T_upper_arm_yz * h_i_forearm_6;
    const ella_real p_forearm_6 = R_P_forearm_31 * p_i_forearm_4 + R_P_forearm_32 * p_i_forearm_5
        + R_T_upper_arm_zz * h_i_forearm_6;

    /* upper_arm, S: first moment */
    const ella_real S_upper_arm_x = c->links[0].S_0_x + state->q[3] * c->links[0].sigma_x1;
    const ella_real S_upper_arm_y = state->q[4] * c->links[0].sigma_y2;
    const ella_real S_upper_arm_z = state->q[5] * c->links[0].sigma_y2;

    /* upper_arm, L: first moment weighted by each mode shape (85) */
    const ella_real L_upper_arm_x1 = c->links[0].chi_1 + c->links[0].mu * state->q[3];
    const ella_real L_upper_arm_x2 = c->links[0].chi_2 + c->links[0].Gamma_xy_11 * state->q[3];
    const ella_real L_upper_arm_y1 = c->links[0].Gamma_xy_11 * state->q[4];
    const ella_real L_upper_arm_y2 = c->links[0].mu * state->q[4];
    const ella_real L_upper_arm_z1 = c->links[0].Gamma_xy_11 * state->q[5];
    const ella_real L_upper_arm_z2 = state->q[5] * c->links[0].mu;

    /* upper_arm, Ldot: rate of L */
    const ella_real Ldot_upper_arm_x2 = c->links[0].Gamma_xy_11 * state->v[3];
    const ella_real Ldot_upper_arm_y1 = c->links[0].Gamma_xy_11 * state->v[4];
    const ella_real Ldot_upper_arm_y2 = c->links[0].mu * state->v[4];
    const ella_real Ldot_upper_arm_z1 = c->links[0].Gamma_xy_11 * state->v[5];
    const ella_real Ldot_upper_arm_z2 = state->v[5] * c->links[0].mu;

    /* upper_arm, J: second moment */
    const ella_real J_upper_arm_xx = c->links[0].J_0_xx + L_upper_arm_x1 * state->q[3]
        + c->links[0].chi_1 * state->q[3];
    const ella_real J_upper_arm_xy = L_upper_arm_y1 * state->q[3] + c->links[0].chi_2 * state->q[4];
    const ella_real J_upper_arm_xz = L_upper_arm_z1 * state->q[3] + c->links[0].chi_2 * state->q[5];
    const ella_real J_upper_arm_yy = L_upper_arm_y2 * state->q[4];
    const ella_real J_upper_arm_yz = L_upper_arm_z2 * state->q[4];
    const ella_real J_upper_arm_zz = L_upper_arm_z2 * state->q[5];

    /* upper_arm, I: inertia about the origin, deformed */
    const ella_real I_upper_arm_xx = c->links[0].I_s + J_upper_arm_yy + J_upper_arm_zz;
    const ella_real I_upper_arm_yy = J_upper_arm_xx + J_upper_arm_zz;
    const ella_real I_upper_arm_zz = J_upper_arm_xx + J_upper_arm_yy;

    /* upper_arm, Omega: acceleration of a place by the link's turning */
    const ella_real t74 = omega_J_upper_arm_y * omega_J_upper_arm_y;
    const ella_real t75 = state->v[1] * state->v[1];
    const ella_real minus_Omega_upper_arm_xx = t74 + t75;
    const ella_real Omega_upper_arm_xy = omega_J_upper_arm_x * omega_J_upper_arm_y;
    const ella_real t76 = omega_J_upper_arm_x * state->v[1];
    const ella_real Omega_upper_arm_xz = t76 - minus_beta_omega_upper_arm_y;
    const ella_real t77 = omega_J_upper_arm_x * omega_J_upper_arm_x;
    const ella_real minus_Omega_upper_arm_yy = t77 + t75;
    const ella_real t78 = omega_J_upper_arm_y * state->v[1];
    const ella_real Omega_upper_arm_yz = t78 - beta_omega_upper_arm_x;
    const ella_real Omega_upper_arm_zx = t76 + minus_beta_omega_upper_arm_y;
    const ella_real Omega_upper_arm_zy = beta_omega_upper_arm_x + t78;
    const ella_real minus_Omega_upper_arm_zz = t77 + t74;

    /* upper_arm, B: moment of the elastic velocity */
    const ella_real B_upper_arm_xx = L_upper_arm_x1 * state->v[3];
    const ella_real B_upper_arm_xy = L_upper_arm_y1 * state->v[3];
    const ella_real B_upper_arm_xz = L_upper_arm_z1 * state->v[3];
    const ella_real B_upper_arm_yx = L_upper_arm_x2 * state->v[4];
    const ella_real B_upper_arm_yy = L_upper_arm_y2 * state->v[4];
    const ella_real B_upper_arm_yz = L_upper_arm_z2 * state->v[4];
    const ella_real B_upper_arm_zx = L_upper_arm_x2 * state->v[5];
    const ella_real B_upper_arm_zy = L_upper_arm_y2 * state->v[5];
    const ella_real B_upper_arm_zz = L_upper_arm_z2 * state->v[5];

    /* upper_arm, h_c: half of the Coriolis wrench */
    const ella_real t79 = B_upper_arm_yy * omega_J_upper_arm_x + B_upper_arm_zz * omega_J_upper_arm_x
        - B_upper_arm_xy * omega_J_upper_arm_y;
    const ella_real h_c_upper_arm_1 = t79 - B_upper_arm_xz * state->v[1];
    const ella_real t80 = B_upper_arm_xx * omega_J_upper_arm_y + B_upper_arm_zz * omega_J_upper_arm_y
        - B_upper_arm_yx * omega_J_upper_arm_x;
    const ella_real h_c_upper_arm_2 = t80 - B_upper_arm_yz * state->v[1];
    const ella_real t81 = B_upper_arm_xx * state->v[1] + B_upper_arm_yy * state->v[1]
        - B_upper_arm_zx * omega_J_upper_arm_x;
    const ella_real h_c_upper_arm_3 = t81 - B_upper_arm_zy * omega_J_upper_arm_y;

    /* upper_arm, H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t82 = h_c_upper_arm_1 + c->links[0].I_s * beta_omega_upper_arm_x
        + J_upper_arm_xy * Omega_upper_arm_zx + J_upper_arm_yy * Omega_upper_arm_zy;
    const ella_real t83 = t82 + J_upper_arm_yz * (minus_Omega_upper_arm_yy - minus_Omega_upper_arm_zz)
        - S_upper_arm_y * minus_alpha_0_upper_arm_6;
    const ella_real H_star_upper_arm_1 = t83 - J_upper_arm_xz * Omega_upper_arm_xy
        - J_upper_arm_zz * Omega_upper_arm_yz - S_upper_arm_z * alpha_0_upper_arm_5;
    const ella_real t84 = h_c_upper_arm_2
        + J_upper_arm_xz * (minus_Omega_upper_arm_zz - minus_Omega_upper_arm_xx)
        + J_upper_arm_yz * Omega_upper_arm_xy;
    const ella_real t85 = c->links[0].I_s * omega_J_upper_arm_x;
    const ella_real t86 = t84 + J_upper_arm_zz * Omega_upper_arm_xz + S_upper_arm_z * alpha_0_upper_arm_4
        + t85 * state->v[1];
    const ella_real H_star_upper_arm_2 = t86 - J_upper_arm_xx * Omega_upper_arm_zx
        - J_upper_arm_xy * Omega_upper_arm_zy + S_upper_arm_x * minus_alpha_0_upper_arm_6;
    const ella_real t87 = h_c_upper_arm_3 + J_upper_arm_xx * Omega_upper_arm_xy
        + J_upper_arm_xy * (minus_Omega_upper_arm_xx - minus_Omega_upper_arm_yy);
    const ella_real t88 = t87 + J_upper_arm_xz * Omega_upper_arm_yz + S_upper_arm_x * alpha_0_upper_arm_5
        - J_upper_arm_yy * Omega_upper_arm_xy;
    const ella_real H_star_upper_arm_3 = t88 - J_upper_arm_yz * Omega_upper_arm_xz
        - S_upper_arm_y * alpha_0_upper_arm_4 - t85 * omega_J_upper_arm_y;

    /* upper_arm, h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_upper_arm_1 = H_star_upper_arm_1 + h_c_upper_arm_1;
    const ella_real h_V_upper_arm_2 = H_star_upper_arm_2 + h_c_upper_arm_2;
    const ella_real h_V_upper_arm_3 = H_star_upper_arm_3 + h_c_upper_arm_3;

    /* upper_arm, h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real t89 = L_upper_arm_y1 * Omega_upper_arm_xy - L_upper_arm_x1 * minus_Omega_upper_arm_xx
        + L_upper_arm_z1 * Omega_upper_arm_xz;
    const ella_real h_eta_upper_arm_1 = t89 + alpha_0_upper_arm_4 * c->links[0].sigma_x1
        + Ldot_upper_arm_z1 * 2 * omega_J_upper_arm_y - Ldot_upper_arm_y1 * 2 * state->v[1];
    const ella_real t90 = L_upper_arm_x2 * Omega_upper_arm_xy - L_upper_arm_y2 * minus_Omega_upper_arm_yy
        + L_upper_arm_z2 * Omega_upper_arm_yz;
    const ella_real t91 = Ldot_upper_arm_x2 * 2;
    const ella_real h_eta_upper_arm_2 = t90 + alpha_0_upper_arm_5 * c->links[0].sigma_y2 + t91 * state->v[1]
        - Ldot_upper_arm_z2 * 2 * omega_J_upper_arm_x;
    const ella_real t92 = L_upper_arm_x2 * Omega_upper_arm_zx + L_upper_arm_y2 * Omega_upper_arm_zy
        - L_upper_arm_z2 * minus_Omega_upper_arm_zz;
    const ella_real t93 = t92 - minus_alpha_0_upper_arm_6 * c->links[0].sigma_y2
        + Ldot_upper_arm_y2 * 2 * omega_J_upper_arm_x;
    const ella_real h_eta_upper_arm_3 = t93 - t91 * omega_J_upper_arm_y;

    /* upper_arm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real Lambda_T_upper_arm_44 = Lambda_forearm_16 + c->links[0].body0_mass;
    const ella_real Lambda_T_upper_arm_55 = Lambda_forearm_19 + c->links[0].body0_mass;
    const ella_real Lambda_T_upper_arm_66 = Lambda_forearm_21 + c->links[0].body0_mass;
    const ella_real t94 = R_T_upper_arm_xx * input->w_ext[0][0] - minus_R_T_upper_arm_xy * input->w_ext[0][1]
        + R_T_upper_arm_xz * input->w_ext[0][2];
    const ella_real t95 = minus_R_T_upper_arm_xy * input->w_ext[0][0] + R_T_upper_arm_yy * input->w_ext[0][1]
        + R_T_upper_arm_yz * input->w_ext[0][2];
    const ella_real t96 = R_T_upper_arm_yz * input->w_ext[0][1] - R_T_upper_arm_xz * input->w_ext[0][0]
        + R_T_upper_arm_zz * input->w_ext[0][2];
    const ella_real t97 = R_T_upper_arm_xx * input->w_ext[0][3] - minus_R_T_upper_arm_xy * input->w_ext[0][4]
        + R_T_upper_arm_xz * input->w_ext[0][5];
    const ella_real t98 = minus_R_T_upper_arm_xy * input->w_ext[0][3] + R_T_upper_arm_yy * input->w_ext[0][4]
        + R_T_upper_arm_yz * input->w_ext[0][5];
    const ella_real t99 = R_T_upper_arm_yz * input->w_ext[0][4] - R_T_upper_arm_xz * input->w_ext[0][3]
        + R_T_upper_arm_zz * input->w_ext[0][5];
    const ella_real p_T_upper_arm_1 = p_forearm_1 - t94;
    const ella_real p_T_upper_arm_2 = p_forearm_2 - t95;
    const ella_real p_T_upper_arm_3 = p_forearm_3 - t96;
    const ella_real p_T_upper_arm_4 = p_forearm_4 + c->links[0].body0_mass * alpha_0_T_upper_arm_4 - t97;
    const ella_real p_T_upper_arm_5 = p_forearm_5 + c->links[0].body0_mass * alpha_0_T_upper_arm_5 - t98;
    const ella_real p_T_upper_arm_6 = p_forearm_6 + c->links[0].body0_mass * alpha_0_T_upper_arm_6 - t99;

    /* upper_arm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real Theta_upper_arm_12 = J_l_upper_arm_xz * c->links[0].Psi_c_z2;
    const ella_real minus_Theta_upper_arm_13 = minus_J_l_upper_arm_xy * c->links[0].Psi_c_y3;
    const ella_real Theta_upper_arm_22 = J_l_upper_arm_yz * c->links[0].Psi_c_z2;
    const ella_real Theta_upper_arm_23 = J_l_upper_arm_yy * c->links[0].Psi_c_y3;
    const ella_real Theta_upper_arm_32 = J_l_upper_arm_zz * c->links[0].Psi_c_z2;
    const ella_real Theta_upper_arm_33 = J_l_upper_arm_yz * c->links[0].Psi_c_y3;
    const ella_real t100 = r_T_upper_arm_z * Lambda_forearm_17;
    const ella_real t101 = r_T_upper_arm_y * Lambda_forearm_18;
    const ella_real t102 = r_T_upper_arm_x * Lambda_forearm_20;
    const ella_real t103 = Lambda_forearm_5
        + (r_T_upper_arm_y * Lambda_forearm_20 - r_T_upper_arm_z * Lambda_T_upper_arm_55);
    const ella_real t104 = Lambda_forearm_6
        + (r_T_upper_arm_y * Lambda_T_upper_arm_66 - r_T_upper_arm_z * Lambda_forearm_20);
    const ella_real t105 = Lambda_forearm_9
        + (r_T_upper_arm_z * Lambda_T_upper_arm_44 - r_T_upper_arm_x * Lambda_forearm_18);
    const ella_real M_loaded_upper_arm_25 = Lambda_forearm_10 + (t100 - t102);
    const ella_real t106 = Lambda_forearm_11
        + (r_T_upper_arm_z * Lambda_forearm_18 - r_T_upper_arm_x * Lambda_T_upper_arm_66);
    const ella_real t107 = Lambda_forearm_13
        + (r_T_upper_arm_x * Lambda_forearm_17 - r_T_upper_arm_y * Lambda_T_upper_arm_44);
    const ella_real t108 = Lambda_forearm_14
        + (r_T_upper_arm_x * Lambda_T_upper_arm_55 - r_T_upper_arm_y * Lambda_forearm_17);
    const ella_real M_loaded_upper_arm_36 = Lambda_forearm_15 + (t102 - t101);
    const ella_real t109 = Lambda_forearm_1
        - (Lambda_forearm_5 * r_T_upper_arm_z - Lambda_forearm_6 * r_T_upper_arm_y)
        + (r_T_upper_arm_y * t104 - r_T_upper_arm_z * t103);
    const ella_real t110 = Lambda_forearm_2
        - (Lambda_forearm_6 * r_T_upper_arm_x - Lambda_forearm_4 * r_T_upper_arm_z)
        + (r_T_upper_arm_y * t106 - r_T_upper_arm_z * M_loaded_upper_arm_25);
    const ella_real t111 = Lambda_forearm_3
        - (Lambda_forearm_4 * r_T_upper_arm_y - Lambda_forearm_5 * r_T_upper_arm_x)
        + (r_T_upper_arm_y * M_loaded_upper_arm_36 - r_T_upper_arm_z * t108);
    const ella_real t112 = Lambda_forearm_7
        - (Lambda_forearm_11 * r_T_upper_arm_x - Lambda_forearm_9 * r_T_upper_arm_z)
        + (r_T_upper_arm_z * t105 - r_T_upper_arm_x * t106);
    const ella_real t113 = Lambda_forearm_8
        - (Lambda_forearm_9 * r_T_upper_arm_y - Lambda_forearm_10 * r_T_upper_arm_x)
        + (r_T_upper_arm_z * t107 - r_T_upper_arm_x * M_loaded_upper_arm_36);
    const ella_real t114 = Lambda_forearm_12
        - (Lambda_forearm_13 * r_T_upper_arm_y - Lambda_forearm_14 * r_T_upper_arm_x)
        + (r_T_upper_arm_x * t108 - r_T_upper_arm_y * t107);
    const ella_real M_loaded_upper_arm_11 = I_upper_arm_xx + t109;
    const ella_real M_loaded_upper_arm_12 = t110 - J_upper_arm_xy;
    const ella_real M_loaded_upper_arm_13 = t111 - J_upper_arm_xz;
    const ella_real M_loaded_upper_arm_22 = I_upper_arm_yy + t112;
    const ella_real M_loaded_upper_arm_23 = t113 - J_upper_arm_yz;
    const ella_real M_loaded_upper_arm_33 = I_upper_arm_zz + t114;
    const ella_real h_loaded_upper_arm_1 = h_V_upper_arm_1
        + (p_T_upper_arm_1 + (r_T_upper_arm_y * p_T_upper_arm_6 - r_T_upper_arm_z * p_T_upper_arm_5));
    const ella_real h_loaded_upper_arm_2 = h_V_upper_arm_2
        + (p_T_upper_arm_2 + (r_T_upper_arm_z * p_T_upper_arm_4 - r_T_upper_arm_x * p_T_upper_arm_6));
    const ella_real h_loaded_upper_arm_3 = h_V_upper_arm_3
        + (p_T_upper_arm_3 + (r_T_upper_arm_x * p_T_upper_arm_5 - r_T_upper_arm_y * p_T_upper_arm_4));
    const ella_real t115 = Lambda_forearm_1 * Theta_upper_arm_12 + Lambda_forearm_2 * Theta_upper_arm_22
        + Lambda_forearm_3 * Theta_upper_arm_32;
    const ella_real t116 = t115 + Lambda_forearm_5 * 2;
    const ella_real t117 = Lambda_forearm_2 * Theta_upper_arm_23 - Lambda_forearm_1 * minus_Theta_upper_arm_13
        + Lambda_forearm_3 * Theta_upper_arm_33;
    const ella_real t118 = t117 + Lambda_forearm_6 * 2;
    const ella_real t119 = Lambda_forearm_2 * Theta_upper_arm_12 + Lambda_forearm_7 * Theta_upper_arm_22
        + Lambda_forearm_8 * Theta_upper_arm_32;
    const ella_real t120 = t119 + Lambda_forearm_10 * 2;
    const ella_real t121 = Lambda_forearm_7 * Theta_upper_arm_23 - Lambda_forearm_2 * minus_Theta_upper_arm_13
        + Lambda_forearm_8 * Theta_upper_arm_33;
    const ella_real t122 = t121 + Lambda_forearm_11 * 2;
    const ella_real t123 = Lambda_forearm_3 * Theta_upper_arm_12 + Lambda_forearm_8 * Theta_upper_arm_22
        + Lambda_forearm_12 * Theta_upper_arm_32;
    const ella_real t124 = t123 + Lambda_forearm_14 * 2;
    const ella_real t125 = Lambda_forearm_8 * Theta_upper_arm_23 - Lambda_forearm_3 * minus_Theta_upper_arm_13
        + Lambda_forearm_12 * Theta_upper_arm_33;
    const ella_real t126 = t125 + Lambda_forearm_15 * 2;
    const ella_real t127 = Lambda_T_upper_arm_44 * REAL(1.4142135623730951);
    const ella_real t128 = Lambda_forearm_4 * Theta_upper_arm_12 + Lambda_forearm_9 * Theta_upper_arm_22
        + Lambda_forearm_13 * Theta_upper_arm_32;
    const ella_real C_upper_arm_42 = t128 + Lambda_forearm_17 * 2;
    const ella_real t129 = Lambda_forearm_9 * Theta_upper_arm_23 - Lambda_forearm_4 * minus_Theta_upper_arm_13
        + Lambda_forearm_13 * Theta_upper_arm_33;
    const ella_real C_upper_arm_43 = t129 + Lambda_forearm_18 * 2;
    const ella_real C_upper_arm_51 = Lambda_forearm_17 * REAL(1.4142135623730951);
    const ella_real t130 = Lambda_forearm_5 * Theta_upper_arm_12 + Lambda_forearm_10 * Theta_upper_arm_22
        + Lambda_forearm_14 * Theta_upper_arm_32;
    const ella_real t131 = t130 + Lambda_T_upper_arm_55 * 2;
    const ella_real t132 = Lambda_forearm_10 * Theta_upper_arm_23 - Lambda_forearm_5 * minus_Theta_upper_arm_13
        + Lambda_forearm_14 * Theta_upper_arm_33;
    const ella_real t133 = Lambda_forearm_20 * 2;
    const ella_real C_upper_arm_53 = t132 + t133;
    const ella_real C_upper_arm_61 = Lambda_forearm_18 * REAL(1.4142135623730951);
    const ella_real t134 = Lambda_forearm_6 * Theta_upper_arm_12 + Lambda_forearm_11 * Theta_upper_arm_22
        + Lambda_forearm_15 * Theta_upper_arm_32;
    const ella_real C_upper_arm_62 = t134 + t133;
    const ella_real t135 = Lambda_forearm_11 * Theta_upper_arm_23 - Lambda_forearm_6 * minus_Theta_upper_arm_13
        + Lambda_forearm_15 * Theta_upper_arm_33;
    const ella_real t136 = t135 + Lambda_T_upper_arm_66 * 2;
    const ella_real C_upper_arm_11 = Lambda_forearm_4 * REAL(1.4142135623730951)
        + (r_T_upper_arm_y * C_upper_arm_61 - r_T_upper_arm_z * C_upper_arm_51);
    const ella_real t137 = Lambda_forearm_9 * REAL(1.4142135623730951)
        + (r_T_upper_arm_z * t127 - r_T_upper_arm_x * C_upper_arm_61);
    const ella_real t138 = Lambda_forearm_13 * REAL(1.4142135623730951)
        + (r_T_upper_arm_x * C_upper_arm_51 - r_T_upper_arm_y * t127);
    const ella_real C_upper_arm_22 = t120 + (r_T_upper_arm_z * C_upper_arm_42 - r_T_upper_arm_x * C_upper_arm_62);
    const ella_real C_upper_arm_33 = t126 + (r_T_upper_arm_x * C_upper_arm_53 - r_T_upper_arm_y * C_upper_arm_43);
    const ella_real C_upper_arm_12 = t116 + (r_T_upper_arm_y * C_upper_arm_62 - r_T_upper_arm_z * t131)
        - L_upper_arm_z2;
    const ella_real C_upper_arm_13 = L_upper_arm_y2
        + (t118 + (r_T_upper_arm_y * t136 - r_T_upper_arm_z * C_upper_arm_53));
    const ella_real C_upper_arm_21 = L_upper_arm_z1 + t137;
    const ella_real C_upper_arm_23 = t122 + (r_T_upper_arm_z * C_upper_arm_43 - r_T_upper_arm_x * t136)
        - L_upper_arm_x2;
    const ella_real C_upper_arm_31 = t138 - L_upper_arm_y1;
    const ella_real C_upper_arm_32 = L_upper_arm_x2
        + (t124 + (r_T_upper_arm_x * t131 - r_T_upper_arm_y * C_upper_arm_42));
    const ella_real modal_inertia_upper_arm_11 = Lambda_T_upper_arm_44 * REAL(2.0000000000000004) + m_eta[0];
    bad |= (unsigned long)(!(modal_inertia_upper_arm_11 > 0)) << 0;
    const ella_real modal_inertia_upper_arm_12 = C_upper_arm_42 * REAL(1.4142135623730951);
    const ella_real modal_inertia_upper_arm_13 = C_upper_arm_43 * REAL(1.4142135623730951);
    const ella_real modal_inertia_upper_arm_22 = Theta_upper_arm_12 * t116 + Theta_upper_arm_22 * t120
        + Theta_upper_arm_32 * t124 + t131 * 2 + m_eta[1];
    const ella_real modal_inertia_upper_arm_23 = Theta_upper_arm_12 * t118 + Theta_upper_arm_22 * t122
        + Theta_upper_arm_32 * t126 + C_upper_arm_53 * 2;
    const ella_real t139 = Theta_upper_arm_23 * t122 - minus_Theta_upper_arm_13 * t118
        + Theta_upper_arm_33 * t126 + t136 * 2;
    const ella_real modal_inertia_upper_arm_33 = t139 + m_eta[2];
    const ella_real t140 = Theta_upper_arm_12 * p_T_upper_arm_1 + Theta_upper_arm_22 * p_T_upper_arm_2
        + Theta_upper_arm_32 * p_T_upper_arm_3;
    const ella_real t141 = Theta_upper_arm_23 * p_T_upper_arm_2 - minus_Theta_upper_arm_13 * p_T_upper_arm_1
        + Theta_upper_arm_33 * p_T_upper_arm_3;
    const ella_real h_phi_upper_arm_1 = h_eta_upper_arm_1 + work->f_eta[0]
        + p_T_upper_arm_4 * REAL(1.4142135623730951);
    const ella_real h_phi_upper_arm_2 = h_eta_upper_arm_2 + work->f_eta[1] + (t140 + p_T_upper_arm_5 * 2);
    const ella_real h_phi_upper_arm_3 = h_eta_upper_arm_3 + work->f_eta[2] + (t141 + p_T_upper_arm_6 * 2);
    const ella_real modes_inverse_upper_arm_1 = 1 / modal_inertia_upper_arm_11;
    const ella_real modes_L_upper_arm_21 = modal_inertia_upper_arm_12 * modes_inverse_upper_arm_1;
    const ella_real modes_L_upper_arm_31 = modal_inertia_upper_arm_13 * modes_inverse_upper_arm_1;
    const ella_real t142 = modal_inertia_upper_arm_22 - modal_inertia_upper_arm_12 * modes_L_upper_arm_21;
    bad |= (unsigned long)(!(t142 > 0)) << 0;
    const ella_real modes_inverse_upper_arm_2 = 1 / t142;
    const ella_real t143 = modal_inertia_upper_arm_23 - modal_inertia_upper_arm_12 * modes_L_upper_arm_31;
    const ella_real modes_L_upper_arm_32 = t143 * modes_inverse_upper_arm_2;
    const ella_real t144 = modal_inertia_upper_arm_33
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_31 + t143 * modes_L_upper_arm_32);
    bad |= (unsigned long)(!(t144 > 0)) << 0;
    const ella_real modes_inverse_upper_arm_3 = 1 / t144;
    const ella_real t145 = C_upper_arm_12 - modes_L_upper_arm_21 * C_upper_arm_11;
    const ella_real t146 = C_upper_arm_22 - modes_L_upper_arm_21 * C_upper_arm_21;
    const ella_real t147 = C_upper_arm_32 - modes_L_upper_arm_21 * C_upper_arm_31;
    const ella_real t148 = C_upper_arm_13 - modes_L_upper_arm_31 * C_upper_arm_11 - modes_L_upper_arm_32 * t145;
    const ella_real t149 = C_upper_arm_23 - modes_L_upper_arm_31 * C_upper_arm_21 - modes_L_upper_arm_32 * t146;
    const ella_real t150 = C_upper_arm_33 - modes_L_upper_arm_31 * C_upper_arm_31 - modes_L_upper_arm_32 * t147;
    const ella_real t151 = h_phi_upper_arm_2 - modes_L_upper_arm_21 * h_phi_upper_arm_1;
    const ella_real t152 = h_phi_upper_arm_3 - modes_L_upper_arm_31 * h_phi_upper_arm_1
        - modes_L_upper_arm_32 * t151;
    const ella_real modes_W_upper_arm_11 = C_upper_arm_11 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_12 = C_upper_arm_21 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_13 = C_upper_arm_31 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_21 = t145 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_22 = t146 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_23 = t147 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_31 = t148 * modes_inverse_upper_arm_3;
    const ella_real modes_W_upper_arm_32 = t149 * modes_inverse_upper_arm_3;
    const ella_real modes_W_upper_arm_33 = t150 * modes_inverse_upper_arm_3;
    const ella_real modes_w_upper_arm_1 = h_phi_upper_arm_1 * modes_inverse_upper_arm_1;
    const ella_real modes_w_upper_arm_2 = t151 * modes_inverse_upper_arm_2;
    const ella_real modes_w_upper_arm_3 = t152 * modes_inverse_upper_arm_3;
    const ella_real t153 = C_upper_arm_11 * modes_W_upper_arm_11 + t145 * modes_W_upper_arm_21
        + t148 * modes_W_upper_arm_31;
    const ella_real M_i_upper_arm_11 = M_loaded_upper_arm_11 - t153;
    const ella_real t154 = C_upper_arm_11 * modes_W_upper_arm_12 + t145 * modes_W_upper_arm_22
        + t148 * modes_W_upper_arm_32;
    const ella_real M_i_upper_arm_12 = M_loaded_upper_arm_12 - t154;
    const ella_real t155 = C_upper_arm_11 * modes_W_upper_arm_13 + t145 * modes_W_upper_arm_23
        + t148 * modes_W_upper_arm_33;
    const ella_real M_i_upper_arm_13 = M_loaded_upper_arm_13 - t155;
    const ella_real t156 = C_upper_arm_21 * modes_W_upper_arm_12 + t146 * modes_W_upper_arm_22
        + t149 * modes_W_upper_arm_32;
    const ella_real M_i_upper_arm_22 = M_loaded_upper_arm_22 - t156;
    const ella_real t157 = C_upper_arm_21 * modes_W_upper_arm_13 + t146 * modes_W_upper_arm_23
        + t149 * modes_W_upper_arm_33;
    const ella_real M_i_upper_arm_23 = M_loaded_upper_arm_23 - t157;
    const ella_real t158 = C_upper_arm_31 * modes_W_upper_arm_13 + t147 * modes_W_upper_arm_23
        + t150 * modes_W_upper_arm_33;
    const ella_real M_i_upper_arm_33 = M_loaded_upper_arm_33 - t158;
    const ella_real t159 = modes_W_upper_arm_11 * h_phi_upper_arm_1 + modes_W_upper_arm_21 * t151
        + modes_W_upper_arm_31 * t152;
    const ella_real t160 = modes_W_upper_arm_12 * h_phi_upper_arm_1 + modes_W_upper_arm_22 * t151
        + modes_W_upper_arm_32 * t152;
    const ella_real t161 = modes_W_upper_arm_13 * h_phi_upper_arm_1 + modes_W_upper_arm_23 * t151
        + modes_W_upper_arm_33 * t152;
    const ella_real h_i_upper_arm_1 = h_loaded_upper_arm_1 - t159;
    const ella_real h_i_upper_arm_2 = h_loaded_upper_arm_2 - t160;
    const ella_real h_i_upper_arm_3 = h_loaded_upper_arm_3 - t161;

    /* upper_arm, joint: its accelerations eliminated from its rows (43) */
    const ella_real U_upper_arm_11 = M_i_upper_arm_11 * R_rel_upper_arm_yx
        + M_i_upper_arm_12 * R_rel_upper_arm_yy;
    const ella_real U_upper_arm_21 = M_i_upper_arm_12 * R_rel_upper_arm_yx
        + M_i_upper_arm_22 * R_rel_upper_arm_yy;
    const ella_real U_upper_arm_31 = M_i_upper_arm_13 * R_rel_upper_arm_yx
        + M_i_upper_arm_23 * R_rel_upper_arm_yy;
    const ella_real joint_inertia_upper_arm_11 = R_rel_upper_arm_yx * U_upper_arm_11
        + R_rel_upper_arm_yy * U_upper_arm_21;
    const ella_real t162 = t53 * (M_i_upper_arm_11 + M_i_upper_arm_22 + M_i_upper_arm_33);
    bad |= (unsigned long)(!(joint_inertia_upper_arm_11 - t162 > 0)) << 0;
    const ella_real joint_inverse_upper_arm_1 = 1 / joint_inertia_upper_arm_11;
    const ella_real joint_L_upper_arm_21 = U_upper_arm_31 * joint_inverse_upper_arm_1;
    const ella_real t163 = M_i_upper_arm_33 - U_upper_arm_31 * joint_L_upper_arm_21;
    bad |= (unsigned long)(!(t163 - t162 > 0)) << 0;
    const ella_real joint_inverse_upper_arm_2 = 1 / t163;
    const ella_real t164 = input->tau[0]
        - (R_rel_upper_arm_yx * h_i_upper_arm_1 + R_rel_upper_arm_yy * h_i_upper_arm_2);
    const ella_real t165 = input->tau[1] - h_i_upper_arm_3 - joint_L_upper_arm_21 * t164;
    const ella_real joint_w_upper_arm_1 = t164 * joint_inverse_upper_arm_1;
    const ella_real joint_w_upper_arm_2 = t165 * joint_inverse_upper_arm_2;
    output->vdot[1] = joint_w_upper_arm_2;

    /* upper_arm, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const ella_real qddot_upper_arm_1 = joint_w_upper_arm_1 - joint_L_upper_arm_21 * joint_w_upper_arm_2;
    output->vdot[0] = qddot_upper_arm_1;

    /* upper_arm, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const ella_real delta_upper_arm_1 = R_rel_upper_arm_yx * qddot_upper_arm_1;
    const ella_real delta_upper_arm_2 = R_rel_upper_arm_yy * qddot_upper_arm_1;
    const ella_real t166 = modes_W_upper_arm_11 * delta_upper_arm_1 + modes_W_upper_arm_12 * delta_upper_arm_2
        + modes_W_upper_arm_13 * joint_w_upper_arm_2;
    const ella_real t167 = modes_W_upper_arm_21 * delta_upper_arm_1 + modes_W_upper_arm_22 * delta_upper_arm_2
        + modes_W_upper_arm_23 * joint_w_upper_arm_2;
    const ella_real t168 = modes_W_upper_arm_31 * delta_upper_arm_1 + modes_W_upper_arm_32 * delta_upper_arm_2
        + modes_W_upper_arm_33 * joint_w_upper_arm_2;
    const ella_real minus_etaddot_upper_arm_3 = modes_w_upper_arm_3 + t168;
    output->vdot[5] = -minus_etaddot_upper_arm_3;
    const ella_real minus_etaddot_upper_arm_2 = modes_w_upper_arm_2 + t167
        - modes_L_upper_arm_32 * minus_etaddot_upper_arm_3;
    output->vdot[4] = -minus_etaddot_upper_arm_2;
    const ella_real minus_etaddot_upper_arm_1 = modes_w_upper_arm_1 + t166
        - modes_L_upper_arm_21 * minus_etaddot_upper_arm_2 - modes_L_upper_arm_31 * minus_etaddot_upper_arm_3;
    output->vdot[3] = -minus_etaddot_upper_arm_1;

    /* upper_arm, tip: what is added to the acceleration of the tip section (accconst1b) */
    const ella_real t169 = c->links[0].Psi_c_y3 * minus_etaddot_upper_arm_3;
    const ella_real t170 = c->links[0].Psi_c_z2 * minus_etaddot_upper_arm_2;
    const ella_real delta_T_upper_arm_1 = delta_upper_arm_1
        + (minus_J_l_upper_arm_xy * t169 - J_l_upper_arm_xz * t170);
    const ella_real delta_T_upper_arm_2 = delta_upper_arm_2 - (J_l_upper_arm_yy * t169 + J_l_upper_arm_yz * t170);
    const ella_real delta_T_upper_arm_3 = joint_w_upper_arm_2
        - (J_l_upper_arm_yz * t169 + J_l_upper_arm_zz * t170);
    const ella_real delta_T_upper_arm_4 = delta_upper_arm_2 * r_T_upper_arm_z
        - joint_w_upper_arm_2 * r_T_upper_arm_y - minus_etaddot_upper_arm_1 * REAL(1.4142135623730951);
    const ella_real delta_T_upper_arm_5 = joint_w_upper_arm_2 * r_T_upper_arm_x
        - delta_upper_arm_1 * r_T_upper_arm_z - minus_etaddot_upper_arm_2 * 2;
    const ella_real delta_T_upper_arm_6 = delta_upper_arm_1 * r_T_upper_arm_y
        - delta_upper_arm_2 * r_T_upper_arm_x - minus_etaddot_upper_arm_3 * 2;

    /* forearm, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const ella_real carried_forearm_1 = R_P_forearm_11 * delta_T_upper_arm_1
        + R_P_forearm_21 * delta_T_upper_arm_2 + R_P_forearm_31 * delta_T_upper_arm_3;
    const ella_real carried_forearm_2 = R_P_forearm_22 * delta_T_upper_arm_2
        - minus_R_P_forearm_12 * delta_T_upper_arm_1 + R_P_forearm_32 * delta_T_upper_arm_3;
    const ella_real carried_forearm_3 = R_T_upper_arm_xz * delta_T_upper_arm_1
        + R_T_upper_arm_yz * delta_T_upper_arm_2 + R_T_upper_arm_zz * delta_T_upper_arm_3;
    const ella_real carried_forearm_4 = R_P_forearm_11 * delta_T_upper_arm_4
        + R_P_forearm_21 * delta_T_upper_arm_5 + R_P_forearm_31 * delta_T_upper_arm_6;
    const ella_real carried_forearm_5 = R_P_forearm_22 * delta_T_upper_arm_5
        - minus_R_P_forearm_12 * delta_T_upper_arm_4 + R_P_forearm_32 * delta_T_upper_arm_6;
    const ella_real carried_forearm_6 = R_T_upper_arm_xz * delta_T_upper_arm_4
        + R_T_upper_arm_yz * delta_T_upper_arm_5 + R_T_upper_arm_zz * delta_T_upper_arm_6;
    const ella_real t171 = joint_W_forearm_11 * carried_forearm_1 + joint_W_forearm_12 * carried_forearm_2
        + carried_forearm_3;
    const ella_real qddot_forearm_1 = joint_w_forearm_1
        - (t171 + joint_W_forearm_14 * carried_forearm_4 + joint_W_forearm_15 * carried_forearm_5);
    output->vdot[2] = qddot_forearm_1;

    /* forearm, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const ella_real delta_forearm_3 = carried_forearm_3 + qddot_forearm_1;
    const ella_real t172 = modes_W_forearm_12 * carried_forearm_2 - minus_modes_W_forearm_13 * delta_forearm_3
        + modes_W_forearm_14 * carried_forearm_4;
    const ella_real t173 = modes_W_forearm_23 * delta_forearm_3 - minus_modes_W_forearm_21 * carried_forearm_1
        + modes_W_forearm_25 * carried_forearm_5;
    const ella_real t174 = modes_W_forearm_31 * carried_forearm_1 - minus_modes_W_forearm_32 * carried_forearm_2
        + modes_W_forearm_36 * carried_forearm_6;
    const ella_real minus_etaddot_forearm_1 = modes_w_forearm_1 + t172;
    output->vdot[6] = -minus_etaddot_forearm_1;
    const ella_real minus_etaddot_forearm_2 = modes_w_forearm_2 + t173;
    output->vdot[7] = -minus_etaddot_forearm_2;
    const ella_real minus_etaddot_forearm_3 = modes_w_forearm_3 + t174;
    output->vdot[8] = -minus_etaddot_forearm_3;

    if (wanted & ELLA_WRENCHES) {
        /* upper_arm, Sdot: rate of the first moment */
        const ella_real Sdot_upper_arm_x = state->v[3] * c->links[0].sigma_x1;
        const ella_real Sdot_upper_arm_y = state->v[4] * c->links[0].sigma_y2;
        const ella_real Sdot_upper_arm_z = state->v[5] * c->links[0].sigma_y2;

        /* upper_arm, h_c: half of the Coriolis wrench */
        const ella_real h_c_upper_arm_4 = Sdot_upper_arm_z * omega_J_upper_arm_y - Sdot_upper_arm_y * state->v[1];
        const ella_real h_c_upper_arm_5 = Sdot_upper_arm_x * state->v[1] - Sdot_upper_arm_z * omega_J_upper_arm_x;
        const ella_real h_c_upper_arm_6 = Sdot_upper_arm_y * omega_J_upper_arm_x
            - Sdot_upper_arm_x * omega_J_upper_arm_y;

        /* upper_arm, H_star: gyroscopic wrench and weight, angular acceleration included */
        const ella_real t175 = h_c_upper_arm_4 - minus_Omega_upper_arm_xx * S_upper_arm_x
            + Omega_upper_arm_xy * S_upper_arm_y + Omega_upper_arm_xz * S_upper_arm_z;
        const ella_real H_star_upper_arm_4 = t175 + alpha_0_upper_arm_4 * c->links[0].mu;
        const ella_real t176 = h_c_upper_arm_5 + Omega_upper_arm_xy * S_upper_arm_x
            - minus_Omega_upper_arm_yy * S_upper_arm_y + Omega_upper_arm_yz * S_upper_arm_z;
        const ella_real H_star_upper_arm_5 = t176 + alpha_0_upper_arm_5 * c->links[0].mu;
        const ella_real t177 = h_c_upper_arm_6 + Omega_upper_arm_zx * S_upper_arm_x
            + Omega_upper_arm_zy * S_upper_arm_y - minus_Omega_upper_arm_zz * S_upper_arm_z;
        const ella_real H_star_upper_arm_6 = t177 - minus_alpha_0_upper_arm_6 * c->links[0].mu;

        /* upper_arm, h_V: bias of the twist rows, angular acceleration included */
        const ella_real h_V_upper_arm_4 = H_star_upper_arm_4 + h_c_upper_arm_4;
        const ella_real h_V_upper_arm_5 = H_star_upper_arm_5 + h_c_upper_arm_5;
        const ella_real h_V_upper_arm_6 = H_star_upper_arm_6 + h_c_upper_arm_6;

        /* upper_arm, modes: the tip load folded in, modal accelerations eliminated (83) */
        const ella_real M_loaded_upper_arm_14 = Lambda_forearm_4 + (t101 - t100);
        const ella_real M_loaded_upper_arm_15 = t103 - S_upper_arm_z;
        const ella_real M_loaded_upper_arm_16 = S_upper_arm_y + t104;
        const ella_real M_loaded_upper_arm_24 = S_upper_arm_z + t105;
        const ella_real M_loaded_upper_arm_26 = t106 - S_upper_arm_x;
        const ella_real M_loaded_upper_arm_34 = t107 - S_upper_arm_y;
        const ella_real M_loaded_upper_arm_35 = S_upper_arm_x + t108;
        const ella_real h_loaded_upper_arm_4 = h_V_upper_arm_4 + p_T_upper_arm_4;
        const ella_real h_loaded_upper_arm_5 = h_V_upper_arm_5 + p_T_upper_arm_5;
        const ella_real h_loaded_upper_arm_6 = h_V_upper_arm_6 + p_T_upper_arm_6;
        const ella_real C_upper_arm_41 = c->links[0].sigma_x1 + t127;
        const ella_real C_upper_arm_52 = c->links[0].sigma_y2 + t131;
        const ella_real C_upper_arm_63 = c->links[0].sigma_y2 + t136;
        const ella_real t178 = C_upper_arm_42 - modes_L_upper_arm_21 * C_upper_arm_41;
        const ella_real t179 = C_upper_arm_52 - modes_L_upper_arm_21 * C_upper_arm_51;
        const ella_real t180 = C_upper_arm_62 - modes_L_upper_arm_21 * C_upper_arm_61;
        const ella_real modes_W_upper_arm_14 = C_upper_arm_41 * modes_inverse_upper_arm_1;
        const ella_real modes_W_upper_arm_15 = C_upper_arm_51 * modes_inverse_upper_arm_1;
        const ella_real modes_W_upper_arm_16 = C_upper_arm_61 * modes_inverse_upper_arm_1;
        const ella_real modes_W_upper_arm_24 = t178 * modes_inverse_upper_arm_2;
        const ella_real modes_W_upper_arm_25 = t179 * modes_inverse_upper_arm_2;
        const ella_real modes_W_upper_arm_26 = t180 * modes_inverse_upper_arm_2;
        const ella_real modes_W_upper_arm_34 = (C_upper_arm_43 - modes_L_upper_arm_31 * C_upper_arm_41
            - modes_L_upper_arm_32 * t178) * modes_inverse_upper_arm_3;
        const ella_real modes_W_upper_arm_35 = (C_upper_arm_53 - modes_L_upper_arm_31 * C_upper_arm_51
            - modes_L_upper_arm_32 * t179) * modes_inverse_upper_arm_3;
        const ella_real modes_W_upper_arm_36 = (C_upper_arm_63 - modes_L_upper_arm_31 * C_upper_arm_61
            - modes_L_upper_arm_32 * t180) * modes_inverse_upper_arm_3;
        const ella_real t181 = C_upper_arm_11 * modes_W_upper_arm_14 + t145 * modes_W_upper_arm_24
            + t148 * modes_W_upper_arm_34;
        const ella_real M_i_upper_arm_14 = M_loaded_upper_arm_14 - t181;
        const ella_real t182 = C_upper_arm_11 * modes_W_upper_arm_15 + t145 * modes_W_upper_arm_25
            + t148 * modes_W_upper_arm_35;
        const ella_real M_i_upper_arm_15 = M_loaded_upper_arm_15 - t182;
        const ella_real t183 = C_upper_arm_11 * modes_W_upper_arm_16 + t145 * modes_W_upper_arm_26
            + t148 * modes_W_upper_arm_36;
        const ella_real M_i_upper_arm_16 = M_loaded_upper_arm_16 - t183;
        const ella_real t184 = C_upper_arm_21 * modes_W_upper_arm_14 + t146 * modes_W_upper_arm_24
            + t149 * modes_W_upper_arm_34;
        const ella_real M_i_upper_arm_24 = M_loaded_upper_arm_24 - t184;
        const ella_real t185 = C_upper_arm_21 * modes_W_upper_arm_15 + t146 * modes_W_upper_arm_25
            + t149 * modes_W_upper_arm_35;
        const ella_real M_i_upper_arm_25 = M_loaded_upper_arm_25 - t185;
        const ella_real t186 = C_upper_arm_21 * modes_W_upper_arm_16 + t146 * modes_W_upper_arm_26
            + t149 * modes_W_upper_arm_36;
        const ella_real M_i_upper_arm_26 = M_loaded_upper_arm_26 - t186;
        const ella_real t187 = C_upper_arm_31 * modes_W_upper_arm_14 + t147 * modes_W_upper_arm_24
            + t150 * modes_W_upper_arm_34;
        const ella_real M_i_upper_arm_34 = M_loaded_upper_arm_34 - t187;
        const ella_real t188 = C_upper_arm_31 * modes_W_upper_arm_15 + t147 * modes_W_upper_arm_25
            + t150 * modes_W_upper_arm_35;
        const ella_real M_i_upper_arm_35 = M_loaded_upper_arm_35 - t188;
        const ella_real t189 = C_upper_arm_31 * modes_W_upper_arm_16 + t147 * modes_W_upper_arm_26
            + t150 * modes_W_upper_arm_36;
        const ella_real M_i_upper_arm_36 = M_loaded_upper_arm_36 - t189;
        const ella_real t190 = modes_W_upper_arm_14 * h_phi_upper_arm_1 + modes_W_upper_arm_24 * t151
            + modes_W_upper_arm_34 * t152;
        const ella_real t191 = modes_W_upper_arm_15 * h_phi_upper_arm_1 + modes_W_upper_arm_25 * t151
            + modes_W_upper_arm_35 * t152;
        const ella_real t192 = modes_W_upper_arm_16 * h_phi_upper_arm_1 + modes_W_upper_arm_26 * t151
            + modes_W_upper_arm_36 * t152;
        const ella_real h_i_upper_arm_4 = h_loaded_upper_arm_4 - t190;
        const ella_real h_i_upper_arm_5 = h_loaded_upper_arm_5 - t191;
        const ella_real h_i_upper_arm_6 = h_loaded_upper_arm_6 - t192;

        /* upper_arm, joint: its accelerations eliminated from its rows (43) */
        const ella_real U_upper_arm_41 = M_i_upper_arm_14 * R_rel_upper_arm_yx
            + M_i_upper_arm_24 * R_rel_upper_arm_yy;
        const ella_real U_upper_arm_51 = M_i_upper_arm_15 * R_rel_upper_arm_yx
            + M_i_upper_arm_25 * R_rel_upper_arm_yy;
        const ella_real U_upper_arm_61 = M_i_upper_arm_16 * R_rel_upper_arm_yx
            + M_i_upper_arm_26 * R_rel_upper_arm_yy;
        const ella_real t193 = U_upper_arm_11 * joint_w_upper_arm_1
            + (M_i_upper_arm_13 - joint_L_upper_arm_21 * U_upper_arm_11) * joint_w_upper_arm_2;
        const ella_real t194 = U_upper_arm_21 * joint_w_upper_arm_1
            + (M_i_upper_arm_23 - joint_L_upper_arm_21 * U_upper_arm_21) * joint_w_upper_arm_2;
        const ella_real t195 = U_upper_arm_41 * joint_w_upper_arm_1
            + (M_i_upper_arm_34 - joint_L_upper_arm_21 * U_upper_arm_41) * joint_w_upper_arm_2;
        const ella_real t196 = U_upper_arm_51 * joint_w_upper_arm_1
            + (M_i_upper_arm_35 - joint_L_upper_arm_21 * U_upper_arm_51) * joint_w_upper_arm_2;
        const ella_real t197 = U_upper_arm_61 * joint_w_upper_arm_1
            + (M_i_upper_arm_36 - joint_L_upper_arm_21 * U_upper_arm_61) * joint_w_upper_arm_2;
        const ella_real p_i_upper_arm_1 = h_i_upper_arm_1 + t193;
        output->wrench[0][0] = p_i_upper_arm_1;
        const ella_real p_i_upper_arm_2 = h_i_upper_arm_2 + t194;
        output->wrench[0][1] = p_i_upper_arm_2;
        const ella_real p_i_upper_arm_3 = h_i_upper_arm_3 + (U_upper_arm_31 * joint_w_upper_arm_1 + t165);
        output->wrench[0][2] = p_i_upper_arm_3;
        const ella_real p_i_upper_arm_4 = h_i_upper_arm_4 + t195;
        output->wrench[0][3] = p_i_upper_arm_4;
        const ella_real p_i_upper_arm_5 = h_i_upper_arm_5 + t196;
        output->wrench[0][4] = p_i_upper_arm_5;
        const ella_real p_i_upper_arm_6 = h_i_upper_arm_6 + t197;
        output->wrench[0][5] = p_i_upper_arm_6;

        /* joint wrench (48)_forearm */
        const ella_real t198 = Lambda_i_forearm_11 * carried_forearm_1 + Lambda_i_forearm_12 * carried_forearm_2
            - minus_Lambda_i_forearm_14 * carried_forearm_4;
        const ella_real t199 = Lambda_i_forearm_12 * carried_forearm_1 + Lambda_i_forearm_22 * carried_forearm_2
            + Lambda_i_forearm_24 * carried_forearm_4;
        const ella_real t200 = Lambda_i_forearm_24 * carried_forearm_2
            - minus_Lambda_i_forearm_14 * carried_forearm_1 + Lambda_i_forearm_44 * carried_forearm_4;
        const ella_real t201 = Lambda_i_forearm_15 * carried_forearm_1
            - minus_Lambda_i_forearm_25 * carried_forearm_2 - minus_Lambda_i_forearm_45 * carried_forearm_4;
        const ella_real t202 = M_i_forearm_16 * carried_forearm_1 + M_i_forearm_26 * carried_forearm_2
            + M_i_forearm_66 * carried_forearm_6;
        const ella_real wrench_forearm_1 = t198 + Lambda_i_forearm_15 * carried_forearm_5
            + M_i_forearm_16 * carried_forearm_6 + p_i_forearm_1;
        output->wrench[1][0] = wrench_forearm_1;
        const ella_real wrench_forearm_2 = t199 - minus_Lambda_i_forearm_25 * carried_forearm_5
            + M_i_forearm_26 * carried_forearm_6 + p_i_forearm_2;
        output->wrench[1][1] = wrench_forearm_2;
        const ella_real wrench_forearm_4 = t200 - minus_Lambda_i_forearm_45 * carried_forearm_5 + p_i_forearm_4;
        output->wrench[1][3] = wrench_forearm_4;
        const ella_real wrench_forearm_5 = t201 + Lambda_i_forearm_55 * carried_forearm_5 + p_i_forearm_5;
        output->wrench[1][4] = wrench_forearm_5;
        const ella_real wrench_forearm_6 = t202 + h_i_forearm_6;
        output->wrench[1][5] = wrench_forearm_6;

        /* outputs */
        output->wrench[1][2] = input->tau[2];
    }

    if (wanted & ELLA_TIP_POSE) {
        /* upper_arm, pose: rotation and position of the tip section in the inertial frame (Ad) */
        const ella_real R_tip_upper_arm_xx = R_rel_upper_arm_xx * R_T_upper_arm_xx
            - minus_R_rel_upper_arm_xy * minus_R_T_upper_arm_xy - R_rel_upper_arm_xz * R_T_upper_arm_xz;
        const ella_real R_tip_upper_arm_xy = R_rel_upper_arm_xz * R_T_upper_arm_yz
            - (minus_R_rel_upper_arm_xy * R_T_upper_arm_yy + R_rel_upper_arm_xx * minus_R_T_upper_arm_xy);
        const ella_real R_tip_upper_arm_xz = R_rel_upper_arm_xx * R_T_upper_arm_xz
            - minus_R_rel_upper_arm_xy * R_T_upper_arm_yz + R_rel_upper_arm_xz * R_T_upper_arm_zz;
        const ella_real R_tip_upper_arm_yx = R_rel_upper_arm_yx * R_T_upper_arm_xx
            + R_rel_upper_arm_yy * minus_R_T_upper_arm_xy;
        const ella_real R_tip_upper_arm_yy = R_rel_upper_arm_yy * R_T_upper_arm_yy
            - R_rel_upper_arm_yx * minus_R_T_upper_arm_xy;
        const ella_real R_tip_upper_arm_yz = R_rel_upper_arm_yx * R_T_upper_arm_xz
            + R_rel_upper_arm_yy * R_T_upper_arm_yz;
        const ella_real R_tip_upper_arm_zx = R_rel_upper_arm_zy * minus_R_T_upper_arm_xy
            - minus_R_rel_upper_arm_zx * R_T_upper_arm_xx - R_rel_upper_arm_zz * R_T_upper_arm_xz;
        const ella_real R_tip_upper_arm_zy = R_rel_upper_arm_zy * R_T_upper_arm_yy
            + minus_R_rel_upper_arm_zx * minus_R_T_upper_arm_xy + R_rel_upper_arm_zz * R_T_upper_arm_yz;
        const ella_real R_tip_upper_arm_zz = R_rel_upper_arm_zy * R_T_upper_arm_yz
            - minus_R_rel_upper_arm_zx * R_T_upper_arm_xz + R_rel_upper_arm_zz * R_T_upper_arm_zz;
        const ella_real r_tip_upper_arm_x = R_rel_upper_arm_xx * r_T_upper_arm_x
            - minus_R_rel_upper_arm_xy * r_T_upper_arm_y + R_rel_upper_arm_xz * r_T_upper_arm_z;
        const ella_real r_tip_upper_arm_y = R_rel_upper_arm_yx * r_T_upper_arm_x
            + R_rel_upper_arm_yy * r_T_upper_arm_y;
        const ella_real r_tip_upper_arm_z = R_rel_upper_arm_zy * r_T_upper_arm_y
            - minus_R_rel_upper_arm_zx * r_T_upper_arm_x + R_rel_upper_arm_zz * r_T_upper_arm_z;

        /* forearm, pose: rotation and position of F_i in the inertial frame (Ad) */
        const ella_real R_forearm_xx = R_tip_upper_arm_xx * R_rel_forearm_xx
            + R_tip_upper_arm_xy * minus_R_rel_forearm_xy;
        const ella_real R_forearm_xy = R_tip_upper_arm_xy * R_rel_forearm_xx
            - R_tip_upper_arm_xx * minus_R_rel_forearm_xy;
        const ella_real R_forearm_yx = R_tip_upper_arm_yx * R_rel_forearm_xx
            + R_tip_upper_arm_yy * minus_R_rel_forearm_xy;
        const ella_real R_forearm_yy = R_tip_upper_arm_yy * R_rel_forearm_xx
            - R_tip_upper_arm_yx * minus_R_rel_forearm_xy;
        const ella_real R_forearm_zx = R_tip_upper_arm_zx * R_rel_forearm_xx
            + R_tip_upper_arm_zy * minus_R_rel_forearm_xy;
        const ella_real R_forearm_zy = R_tip_upper_arm_zy * R_rel_forearm_xx
            - R_tip_upper_arm_zx * minus_R_rel_forearm_xy;

        /* forearm, pose: rotation and position of the tip section in the inertial frame (Ad) */
        const ella_real R_tip_forearm_xx = R_forearm_xx * R_T_forearm_xx + R_forearm_xy * minus_R_T_forearm_xy
            - R_tip_upper_arm_xz * R_T_forearm_xz;
        output->tip_rotation[0][0] = R_tip_forearm_xx;
        const ella_real R_tip_forearm_xy = R_forearm_xy * R_T_forearm_yy - R_forearm_xx * minus_R_T_forearm_xy
            + R_tip_upper_arm_xz * R_T_forearm_yz;
        output->tip_rotation[0][1] = R_tip_forearm_xy;
        const ella_real R_tip_forearm_xz = R_forearm_xx * R_T_forearm_xz + R_forearm_xy * R_T_forearm_yz
            + R_tip_upper_arm_xz * R_T_forearm_zz;
        output->tip_rotation[0][2] = R_tip_forearm_xz;
        const ella_real R_tip_forearm_yx = R_forearm_yx * R_T_forearm_xx + R_forearm_yy * minus_R_T_forearm_xy
            - R_tip_upper_arm_yz * R_T_forearm_xz;
        output->tip_rotation[1][0] = R_tip_forearm_yx;
        const ella_real R_tip_forearm_yy = R_forearm_yy * R_T_forearm_yy - R_forearm_yx * minus_R_T_forearm_xy
            + R_tip_upper_arm_yz * R_T_forearm_yz;
        output->tip_rotation[1][1] = R_tip_forearm_yy;
        const ella_real R_tip_forearm_yz = R_forearm_yx * R_T_forearm_xz + R_forearm_yy * R_T_forearm_yz
            + R_tip_upper_arm_yz * R_T_forearm_zz;
        output->tip_rotation[1][2] = R_tip_forearm_yz;
        const ella_real R_tip_forearm_zx = R_forearm_zx * R_T_forearm_xx + R_forearm_zy * minus_R_T_forearm_xy
            - R_tip_upper_arm_zz * R_T_forearm_xz;
        output->tip_rotation[2][0] = R_tip_forearm_zx;
        const ella_real R_tip_forearm_zy = R_forearm_zy * R_T_forearm_yy - R_forearm_zx * minus_R_T_forearm_xy
            + R_tip_upper_arm_zz * R_T_forearm_yz;
        output->tip_rotation[2][1] = R_tip_forearm_zy;
        const ella_real R_tip_forearm_zz = R_forearm_zx * R_T_forearm_xz + R_forearm_zy * R_T_forearm_yz
            + R_tip_upper_arm_zz * R_T_forearm_zz;
        output->tip_rotation[2][2] = R_tip_forearm_zz;
        const ella_real r_tip_forearm_x = r_tip_upper_arm_x
            + (R_forearm_xx * r_T_forearm_x + R_forearm_xy * r_T_forearm_y + R_tip_upper_arm_xz * r_T_forearm_z);
        output->tip_position[0] = r_tip_forearm_x;
        const ella_real r_tip_forearm_y = r_tip_upper_arm_y
            + (R_forearm_yx * r_T_forearm_x + R_forearm_yy * r_T_forearm_y + R_tip_upper_arm_yz * r_T_forearm_z);
        output->tip_position[1] = r_tip_forearm_y;
        const ella_real r_tip_forearm_z = r_tip_upper_arm_z
            + (R_forearm_zx * r_T_forearm_x + R_forearm_zy * r_T_forearm_y + R_tip_upper_arm_zz * r_T_forearm_z);
        output->tip_position[2] = r_tip_forearm_z;
    }

    if (bad) {
        /* the sweep ran from the tip: the outermost link that failed is to blame */
        for (link = 0; link < ELLA_NLINKS; ++link) {
            if ((bad >> link) & 1u) {
                work->fault = link;
            }
        }
        return ELLA_SINGULAR;
    }
    return ELLA_OK;
}

ella_status ella_inverse_dynamics(const ella_constants *c, const ella_state *state, const ella_input *input,
    const ella_real vdot[], ella_chain *chain, ella_real force[], ella_real wrench[][6])
{
    ella_real f_eta[ELLA_LENGTH(ELLA_NMODES)];
    ella_call call = { 0 };
    ella_status status;
    int k, fault = 0;
    if (!c || !state || !input || !vdot || !chain || !force) {
        return ELLA_BAD_ARGUMENT;
    }
    for (k = 0; k < ELLA_NMODES; ++k) {
        f_eta[k] = c->K[k] * state->q[ELLA_NTAU + k] + c->D[k] * state->v[ELLA_NTAU + k];
    }
    call.gravity = c->gravity;
    call.q = state->q;
    call.qdot = state->v;
    call.eta = state->q + ELLA_NTAU;
    call.etadot = state->v + ELLA_NTAU;
    call.w_ext = &input->w_ext[0][0];
    call.m_eta = c->M_eta;
    call.f_eta = f_eta;
    call.given_qddot = vdot;
    call.given_etaddot = vdot + ELLA_NTAU;
    call.force = force;
    call.force_eta = force + ELLA_NTAU;
    call.wrench = wrench ? &wrench[0][0] : 0;
    status = ella_inverse(c, &call, chain, &fault);
    if (status == ELLA_OK && !(ella_finite(force, ELLA_NV) && ella_finite(call.w_ext, 6 * ELLA_NLINKS))) {
        return ELLA_NONFINITE;
    }
    return status;
}

ella_status ella_mass_matrix(const ella_constants *c, const ella_state *state, ella_chain *chain,
    ella_real M[][ELLA_LENGTH(ELLA_NV)])
{
    ella_real unit[ELLA_LENGTH(ELLA_NV)] = { 0 };
    ella_call call = { 0 };
    ella_status status;
    int j, fault = 0;
    if (!c || !state || !chain || !M) {
        return ELLA_BAD_ARGUMENT;
    }
    call.q = state->q;
    call.eta = state->q + ELLA_NTAU;
    call.m_eta = c->M_eta;
    call.given_qddot = unit;
    call.given_etaddot = unit + ELLA_NTAU;
    status = ella_inertia_posture(c, &call, chain, &fault);
    for (j = 0; j < ELLA_NV && status == ELLA_OK; ++j) {
        unit[j] = 1;
        call.force = M[j];
        call.force_eta = M[j] + ELLA_NTAU;
        status = ella_inertia_column(c, &call, chain, &fault);
        unit[j] = 0;
        if (!ella_finite(M[j], ELLA_NV)) {
            status = ELLA_NONFINITE;
        }
    }
    return status;
}
