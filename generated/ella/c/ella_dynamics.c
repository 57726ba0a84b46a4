/* ella_dynamics.c: forward dynamics of the joint form by block elimination, tip to base. */
#include "ella_links.h"

/* The whole chain in one piece: outward to the tip, inward with the eliminations, outward with the results. */
ella_status ella_dynamics(const ella_constants *c, const ella_state *state, const ella_input *input,
    ella_work *work, ella_output *output)
{
    unsigned long bad = 0; /* bit i: the joint or a mode of link i cannot be solved for */
    int link;

    /* upper_arm, R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_upper_arm_zz = ella_cos(state->q[0]);
    const ella_real R_rel_upper_arm_yy = ella_cos(state->q[1]);
    const ella_real R_rel_upper_arm_xx = R_rel_upper_arm_zz * R_rel_upper_arm_yy;
    const ella_real R_rel_upper_arm_yx = ella_sin(state->q[1]);
    const ella_real minus_R_rel_upper_arm_xy = R_rel_upper_arm_yx * R_rel_upper_arm_zz;
    const ella_real R_rel_upper_arm_xz = ella_sin(state->q[0]);
    const ella_real minus_R_rel_upper_arm_zx = R_rel_upper_arm_xz * R_rel_upper_arm_yy;
    const ella_real R_rel_upper_arm_zy = R_rel_upper_arm_xz * R_rel_upper_arm_yx;

    /* upper_arm, omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_upper_arm_x = R_rel_upper_arm_yx * state->v[0];
    const ella_real omega_J_upper_arm_y = R_rel_upper_arm_yy * state->v[0];

    /* upper_arm, beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real t1 = state->v[0] * state->v[1];
    const ella_real beta_omega_upper_arm_x = t1 * R_rel_upper_arm_yy;
    const ella_real minus_beta_omega_upper_arm_y = t1 * R_rel_upper_arm_yx;

    /* upper_arm, S: first moment */
    const ella_real S_upper_arm_x = c->links[0].S_0_x + state->q[3] * c->links[0].sigma_x1;
    const ella_real S_upper_arm_y = state->q[4] * c->links[0].sigma_y2;
    const ella_real S_upper_arm_z = state->q[5] * c->links[0].sigma_z3;

    /* upper_arm, Sdot: rate of the first moment */
    const ella_real Sdot_upper_arm_x = state->v[3] * c->links[0].sigma_x1;
    const ella_real Sdot_upper_arm_y = state->v[4] * c->links[0].sigma_y2;
    const ella_real Sdot_upper_arm_z = state->v[5] * c->links[0].sigma_z3;

    /* upper_arm, L: first moment weighted by each mode shape (85) */
    const ella_real L_upper_arm_x1 = c->links[0].chi_1 + c->links[0].M_Wphi_11 * state->q[3];
    const ella_real L_upper_arm_x2 = c->links[0].chi_2 + c->links[0].Gamma_xy_11 * state->q[3];
    const ella_real L_upper_arm_x3 = c->links[0].chi_3 + c->links[0].Gamma_xz_11 * state->q[3];
    const ella_real L_upper_arm_y1 = c->links[0].Gamma_xy_11 * state->q[4];
    const ella_real L_upper_arm_y2 = c->links[0].M_Wphi_22 * state->q[4];
    const ella_real L_upper_arm_y3 = state->q[4] * c->links[0].mu;
    const ella_real L_upper_arm_z1 = c->links[0].Gamma_xz_11 * state->q[5];
    const ella_real L_upper_arm_z2 = state->q[5] * c->links[0].mu;
    const ella_real L_upper_arm_z3 = c->links[0].M_Wphi_33 * state->q[5];

    /* upper_arm, Ldot: rate of L */
    const ella_real Ldot_upper_arm_x2 = c->links[0].Gamma_xy_11 * state->v[3];
    const ella_real Ldot_upper_arm_x3 = c->links[0].Gamma_xz_11 * state->v[3];
    const ella_real Ldot_upper_arm_y1 = c->links[0].Gamma_xy_11 * state->v[4];
    const ella_real Ldot_upper_arm_y3 = state->v[4] * c->links[0].mu;
    const ella_real Ldot_upper_arm_z1 = c->links[0].Gamma_xz_11 * state->v[5];
    const ella_real Ldot_upper_arm_z2 = state->v[5] * c->links[0].mu;

    /* upper_arm, J: second moment */
    const ella_real J_upper_arm_xx = c->links[0].J_0_xx + L_upper_arm_x1 * state->q[3]
        + c->links[0].chi_1 * state->q[3];
    const ella_real J_upper_arm_xy = L_upper_arm_y1 * state->q[3] + c->links[0].chi_2 * state->q[4];
    const ella_real J_upper_arm_xz = L_upper_arm_z1 * state->q[3] + c->links[0].chi_3 * state->q[5];
    const ella_real J_upper_arm_yy = L_upper_arm_y2 * state->q[4];
    const ella_real J_upper_arm_yz = L_upper_arm_z2 * state->q[4];
    const ella_real J_upper_arm_zz = L_upper_arm_z3 * state->q[5];

    /* upper_arm, I: inertia about the origin, deformed */
    const ella_real I_upper_arm_xx = c->links[0].I_s + J_upper_arm_yy + J_upper_arm_zz;
    const ella_real I_upper_arm_yy = J_upper_arm_xx + J_upper_arm_zz;
    const ella_real I_upper_arm_zz = J_upper_arm_xx + J_upper_arm_yy;

    /* upper_arm, Omega: centripetal operator */
    const ella_real t2 = omega_J_upper_arm_y * omega_J_upper_arm_y;
    const ella_real t3 = state->v[1] * state->v[1];
    const ella_real minus_Omega_upper_arm_xx = t2 + t3;
    const ella_real Omega_upper_arm_xy = omega_J_upper_arm_x * omega_J_upper_arm_y;
    const ella_real Omega_upper_arm_xz = omega_J_upper_arm_x * state->v[1];
    const ella_real t4 = omega_J_upper_arm_x * omega_J_upper_arm_x;
    const ella_real minus_Omega_upper_arm_yy = t4 + t3;
    const ella_real Omega_upper_arm_yz = omega_J_upper_arm_y * state->v[1];
    const ella_real minus_Omega_upper_arm_zz = t4 + t2;

    /* upper_arm, B: moment of the elastic velocity */
    const ella_real B_upper_arm_xx = L_upper_arm_x1 * state->v[3];
    const ella_real B_upper_arm_xy = L_upper_arm_y1 * state->v[3];
    const ella_real B_upper_arm_xz = L_upper_arm_z1 * state->v[3];
    const ella_real B_upper_arm_yx = L_upper_arm_x2 * state->v[4];
    const ella_real B_upper_arm_yy = L_upper_arm_y2 * state->v[4];
    const ella_real B_upper_arm_yz = L_upper_arm_z2 * state->v[4];
    const ella_real B_upper_arm_zx = L_upper_arm_x3 * state->v[5];
    const ella_real B_upper_arm_zy = L_upper_arm_y3 * state->v[5];
    const ella_real B_upper_arm_zz = L_upper_arm_z3 * state->v[5];

    /* upper_arm, h_c: half of the Coriolis wrench */
    const ella_real t5 = B_upper_arm_yy * omega_J_upper_arm_x + B_upper_arm_zz * omega_J_upper_arm_x
        - B_upper_arm_xy * omega_J_upper_arm_y;
    const ella_real h_c_upper_arm_1 = t5 - B_upper_arm_xz * state->v[1];
    const ella_real t6 = B_upper_arm_xx * omega_J_upper_arm_y + B_upper_arm_zz * omega_J_upper_arm_y
        - B_upper_arm_yx * omega_J_upper_arm_x;
    const ella_real h_c_upper_arm_2 = t6 - B_upper_arm_yz * state->v[1];
    const ella_real t7 = B_upper_arm_xx * state->v[1] + B_upper_arm_yy * state->v[1]
        - B_upper_arm_zx * omega_J_upper_arm_x;
    const ella_real h_c_upper_arm_3 = t7 - B_upper_arm_zy * omega_J_upper_arm_y;
    const ella_real h_c_upper_arm_4 = Sdot_upper_arm_z * omega_J_upper_arm_y - Sdot_upper_arm_y * state->v[1];
    const ella_real h_c_upper_arm_5 = Sdot_upper_arm_x * state->v[1] - Sdot_upper_arm_z * omega_J_upper_arm_x;
    const ella_real h_c_upper_arm_6 = Sdot_upper_arm_y * omega_J_upper_arm_x
        - Sdot_upper_arm_x * omega_J_upper_arm_y;

    /* upper_arm, H_star: gyroscopic wrench and weight (29) */
    const ella_real t8 = h_c_upper_arm_1 + J_upper_arm_xy * Omega_upper_arm_xz
        + J_upper_arm_yy * Omega_upper_arm_yz
        + J_upper_arm_yz * (minus_Omega_upper_arm_yy - minus_Omega_upper_arm_zz);
    const ella_real H_star_upper_arm_1 = t8 - J_upper_arm_xz * Omega_upper_arm_xy
        - J_upper_arm_zz * Omega_upper_arm_yz;
    const ella_real t9 = h_c_upper_arm_2 + J_upper_arm_xz * (minus_Omega_upper_arm_zz - minus_Omega_upper_arm_xx)
        + J_upper_arm_yz * Omega_upper_arm_xy;
    const ella_real t10 = c->links[0].I_s * omega_J_upper_arm_x;
    const ella_real t11 = t9 + J_upper_arm_zz * Omega_upper_arm_xz + t10 * state->v[1]
        - J_upper_arm_xx * Omega_upper_arm_xz;
    const ella_real H_star_upper_arm_2 = t11 - J_upper_arm_xy * Omega_upper_arm_yz;
    const ella_real t12 = h_c_upper_arm_3 + J_upper_arm_xx * Omega_upper_arm_xy
        + J_upper_arm_xy * (minus_Omega_upper_arm_xx - minus_Omega_upper_arm_yy);
    const ella_real t13 = t12 + J_upper_arm_xz * Omega_upper_arm_yz - J_upper_arm_yy * Omega_upper_arm_xy
        - J_upper_arm_yz * Omega_upper_arm_xz;
    const ella_real H_star_upper_arm_3 = t13 - t10 * omega_J_upper_arm_y;
    const ella_real H_star_upper_arm_4 = h_c_upper_arm_4 - minus_Omega_upper_arm_xx * S_upper_arm_x
        + Omega_upper_arm_xy * S_upper_arm_y + Omega_upper_arm_xz * S_upper_arm_z;
    const ella_real H_star_upper_arm_5 = h_c_upper_arm_5 + Omega_upper_arm_xy * S_upper_arm_x
        - minus_Omega_upper_arm_yy * S_upper_arm_y + Omega_upper_arm_yz * S_upper_arm_z;
    const ella_real H_star_upper_arm_6 = h_c_upper_arm_6 + Omega_upper_arm_xz * S_upper_arm_x
        + Omega_upper_arm_yz * S_upper_arm_y - minus_Omega_upper_arm_zz * S_upper_arm_z;

    /* upper_arm, h_V: bias of the twist rows */
    const ella_real h_V_upper_arm_1 = H_star_upper_arm_1 + h_c_upper_arm_1;
    const ella_real h_V_upper_arm_2 = H_star_upper_arm_2 + h_c_upper_arm_2;
    const ella_real h_V_upper_arm_3 = H_star_upper_arm_3 + h_c_upper_arm_3;
    const ella_real h_V_upper_arm_4 = H_star_upper_arm_4 + h_c_upper_arm_4;
    const ella_real h_V_upper_arm_5 = H_star_upper_arm_5 + h_c_upper_arm_5;
    const ella_real h_V_upper_arm_6 = H_star_upper_arm_6 + h_c_upper_arm_6;

    /* upper_arm, h_eta: gyroscopic force and weight on the modes (88) */
    const ella_real t14 = L_upper_arm_y1 * Omega_upper_arm_xy - L_upper_arm_x1 * minus_Omega_upper_arm_xx
        + L_upper_arm_z1 * Omega_upper_arm_xz;
    const ella_real h_eta_upper_arm_1 = t14 + Ldot_upper_arm_z1 * 2 * omega_J_upper_arm_y
        - Ldot_upper_arm_y1 * 2 * state->v[1];
    const ella_real t15 = L_upper_arm_x2 * Omega_upper_arm_xy - L_upper_arm_y2 * minus_Omega_upper_arm_yy
        + L_upper_arm_z2 * Omega_upper_arm_yz;
    const ella_real h_eta_upper_arm_2 = t15 + Ldot_upper_arm_x2 * 2 * state->v[1]
        - Ldot_upper_arm_z2 * 2 * omega_J_upper_arm_x;
    const ella_real t16 = L_upper_arm_x3 * Omega_upper_arm_xz + L_upper_arm_y3 * Omega_upper_arm_yz
        - L_upper_arm_z3 * minus_Omega_upper_arm_zz;
    const ella_real h_eta_upper_arm_3 = t16 + Ldot_upper_arm_y3 * 2 * omega_J_upper_arm_x
        - Ldot_upper_arm_x3 * 2 * omega_J_upper_arm_y;

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
    const ella_real t17 = ella_c5(x_upper_arm);
    const ella_real c3_upper_arm = REAL(0.16666666666666666) - x_upper_arm * t17;
    const ella_real c1_upper_arm = 1 - x_upper_arm * c3_upper_arm;

    /* upper_arm, c2: Stumpff function of order 2 */
    const ella_real t18 = ella_c4(x_upper_arm);
    const ella_real c2_upper_arm = REAL(0.5) - x_upper_arm * t18;

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

    /* upper_arm, udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_upper_arm_x = state->v[3] * REAL(1.4142135623730951);
    const ella_real udot_T_upper_arm_y = state->v[4] * 2;
    const ella_real udot_T_upper_arm_z = state->v[5] * 2;

    /* upper_arm, thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_upper_arm_y = c->links[0].Psi_c_y3 * state->v[5];
    const ella_real thetadot_upper_arm_z = c->links[0].Psi_c_z2 * state->v[4];

    /* upper_arm, omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t19 = theta_upper_arm_y * thetadot_upper_arm_z - theta_upper_arm_z * thetadot_upper_arm_y;
    const ella_real omega_s_upper_arm_x = c2_upper_arm * t19;
    const ella_real omega_s_upper_arm_y = thetadot_upper_arm_y + c3_upper_arm * theta_upper_arm_z * t19;
    const ella_real omega_s_upper_arm_z = thetadot_upper_arm_z - c3_upper_arm * theta_upper_arm_y * t19;

    /* upper_arm, xdot: rate of the squared angle */
    const ella_real xdot_upper_arm = theta_upper_arm_y * 2 * thetadot_upper_arm_y
        + theta_upper_arm_z * 2 * thetadot_upper_arm_z;

    /* upper_arm, c2dot: rate of c2 */
    const ella_real c2dot_upper_arm = xdot_upper_arm * (t18 - c3_upper_arm * REAL(0.5));

    /* upper_arm, c3dot: rate of c3 */
    const ella_real c3dot_upper_arm = xdot_upper_arm * (t17 * REAL(1.5) - t18 * REAL(0.5));

    /* upper_arm, alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_upper_arm_x = c2dot_upper_arm * t19;
    const ella_real alpha_s_upper_arm_y = c3_upper_arm * thetadot_upper_arm_z * t19
        + c3dot_upper_arm * theta_upper_arm_z * t19;
    const ella_real minus_alpha_s_upper_arm_z = c3_upper_arm * thetadot_upper_arm_y * t19
        + c3dot_upper_arm * theta_upper_arm_y * t19;

    /* upper_arm, omega_T: angular velocity of the tip section (46) */
    const ella_real t20 = omega_s_upper_arm_x + omega_J_upper_arm_x;
    const ella_real t21 = omega_s_upper_arm_y + omega_J_upper_arm_y;
    const ella_real t22 = omega_s_upper_arm_z + state->v[1];
    const ella_real omega_T_upper_arm_x = R_T_upper_arm_xx * t20 + minus_R_T_upper_arm_xy * t21
        - R_T_upper_arm_xz * t22;
    const ella_real omega_T_upper_arm_y = R_T_upper_arm_yy * t21 - minus_R_T_upper_arm_xy * t20
        + R_T_upper_arm_yz * t22;
    const ella_real omega_T_upper_arm_z = R_T_upper_arm_xz * t20 + R_T_upper_arm_yz * t21
        + R_T_upper_arm_zz * t22;

    /* upper_arm, v_T: velocity of the tip point (46) */
    const ella_real t23 = udot_T_upper_arm_x + omega_J_upper_arm_y * r_T_upper_arm_z
        - state->v[1] * r_T_upper_arm_y;
    const ella_real t24 = udot_T_upper_arm_y + state->v[1] * r_T_upper_arm_x
        - omega_J_upper_arm_x * r_T_upper_arm_z;
    const ella_real t25 = udot_T_upper_arm_z + omega_J_upper_arm_x * r_T_upper_arm_y
        - omega_J_upper_arm_y * r_T_upper_arm_x;
    const ella_real v_T_upper_arm_x = R_T_upper_arm_xx * t23 + minus_R_T_upper_arm_xy * t24
        - R_T_upper_arm_xz * t25;
    const ella_real v_T_upper_arm_y = R_T_upper_arm_yy * t24 - minus_R_T_upper_arm_xy * t23
        + R_T_upper_arm_yz * t25;
    const ella_real v_T_upper_arm_z = R_T_upper_arm_xz * t23 + R_T_upper_arm_yz * t24 + R_T_upper_arm_zz * t25;

    /* upper_arm, b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const ella_real t26 = alpha_s_upper_arm_x + omega_s_upper_arm_z * omega_J_upper_arm_y
        - omega_s_upper_arm_y * state->v[1];
    const ella_real t27 = alpha_s_upper_arm_y + omega_s_upper_arm_x * state->v[1]
        - omega_s_upper_arm_z * omega_J_upper_arm_x;
    const ella_real t28 = omega_s_upper_arm_y * omega_J_upper_arm_x - minus_alpha_s_upper_arm_z
        - omega_s_upper_arm_x * omega_J_upper_arm_y;
    const ella_real b_omega_upper_arm_x = R_T_upper_arm_xx * t26 + minus_R_T_upper_arm_xy * t27
        - R_T_upper_arm_xz * t28;
    const ella_real b_omega_upper_arm_y = R_T_upper_arm_yy * t27 - minus_R_T_upper_arm_xy * t26
        + R_T_upper_arm_yz * t28;
    const ella_real b_omega_upper_arm_z = R_T_upper_arm_xz * t26 + R_T_upper_arm_yz * t27
        + R_T_upper_arm_zz * t28;

    /* upper_arm, b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const ella_real t29 = omega_s_upper_arm_z * t24 + omega_J_upper_arm_y * udot_T_upper_arm_z
        - omega_s_upper_arm_y * t25 - state->v[1] * udot_T_upper_arm_y;
    const ella_real t30 = omega_s_upper_arm_x * t25 + state->v[1] * udot_T_upper_arm_x
        - omega_s_upper_arm_z * t23 - omega_J_upper_arm_x * udot_T_upper_arm_z;
    const ella_real t31 = omega_s_upper_arm_y * t23 + omega_J_upper_arm_x * udot_T_upper_arm_y
        - omega_s_upper_arm_x * t24 - omega_J_upper_arm_y * udot_T_upper_arm_x;
    const ella_real b_v_upper_arm_x = R_T_upper_arm_xx * t29 + minus_R_T_upper_arm_xy * t30
        - R_T_upper_arm_xz * t31;
    const ella_real b_v_upper_arm_y = R_T_upper_arm_yy * t30 - minus_R_T_upper_arm_xy * t29
        + R_T_upper_arm_yz * t31;
    const ella_real b_v_upper_arm_z = R_T_upper_arm_xz * t29 + R_T_upper_arm_yz * t30 + R_T_upper_arm_zz * t31;

    /* upper_arm, a_T: acceleration of the tip point at rest rates, against free fall */
    const ella_real a_T_upper_arm_x = omega_T_upper_arm_y * v_T_upper_arm_z
        - omega_T_upper_arm_z * v_T_upper_arm_y;
    const ella_real a_T_upper_arm_y = omega_T_upper_arm_z * v_T_upper_arm_x
        - omega_T_upper_arm_x * v_T_upper_arm_z;
    const ella_real a_T_upper_arm_z = omega_T_upper_arm_x * v_T_upper_arm_y
        - omega_T_upper_arm_y * v_T_upper_arm_x;

    /* upper_arm, h_T_F: force that the bodies' velocities and weight need */
    const ella_real h_T_F_upper_arm_x = a_T_upper_arm_x * c->links[0].body0_mass;
    const ella_real h_T_F_upper_arm_y = a_T_upper_arm_y * c->links[0].body0_mass;
    const ella_real h_T_F_upper_arm_z = a_T_upper_arm_z * c->links[0].body0_mass;

    /* forearm, R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_real R_rel_forearm_xx = ella_cos(state->q[2]);
    const ella_real minus_R_rel_forearm_xy = ella_sin(state->q[2]);

    /* forearm, omega_R: angular velocity of the parent's tip */
    const ella_real omega_R_forearm_x = R_rel_forearm_xx * omega_T_upper_arm_x
        + minus_R_rel_forearm_xy * omega_T_upper_arm_y;
    const ella_real omega_R_forearm_y = R_rel_forearm_xx * omega_T_upper_arm_y
        - minus_R_rel_forearm_xy * omega_T_upper_arm_x;

    /* forearm, omega: angular velocity of the link (45) */
    const ella_real omega_forearm_z = omega_T_upper_arm_z + state->v[2];

    /* forearm, v_R: velocity of the joint point */
    const ella_real v_R_forearm_x = R_rel_forearm_xx * v_T_upper_arm_x + minus_R_rel_forearm_xy * v_T_upper_arm_y;
    const ella_real v_R_forearm_y = R_rel_forearm_xx * v_T_upper_arm_y - minus_R_rel_forearm_xy * v_T_upper_arm_x;

    /* forearm, beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const ella_real beta_omega_forearm_x = omega_R_forearm_y * state->v[2];
    const ella_real minus_beta_omega_forearm_y = omega_R_forearm_x * state->v[2];

    /* forearm, beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const ella_real beta_v_forearm_x = state->v[2] * v_R_forearm_y;
    const ella_real minus_beta_v_forearm_y = state->v[2] * v_R_forearm_x;

    /* forearm, S: first moment */
    const ella_real S_forearm_x = c->links[1].S_0_x + state->q[6] * c->links[1].sigma_x1;
    const ella_real S_forearm_y = state->q[7] * c->links[1].sigma_y2;
    const ella_real S_forearm_z = state->q[8] * c->links[1].sigma_z3;

    /* forearm, Sdot: rate of the first moment */
    const ella_real Sdot_forearm_x = state->v[6] * c->links[1].sigma_x1;
    const ella_real Sdot_forearm_y = state->v[7] * c->links[1].sigma_y2;
    const ella_real Sdot_forearm_z = state->v[8] * c->links[1].sigma_z3;

    /* forearm, L: first moment weighted by each mode shape (85) */
    const ella_real L_forearm_x1 = c->links[1].chi_1 + c->links[1].M_Wphi_11 * state->q[6];
    const ella_real L_forearm_x2 = c->links[1].chi_2 + c->links[1].Gamma_xy_11 * state->q[6];
    const ella_real L_forearm_x3 = c->links[1].chi_3 + c->links[1].Gamma_xz_11 * state->q[6];
    const ella_real L_forearm_y1 = c->links[1].Gamma_xy_11 * state->q[7];
    const ella_real L_forearm_y2 = c->links[1].M_Wphi_22 * state->q[7];
    const ella_real L_forearm_y3 = state->q[7] * c->links[1].mu;
    const ella_real L_forearm_z1 = c->links[1].Gamma_xz_11 * state->q[8];
    const ella_real L_forearm_z2 = state->q[8] * c->links[1].mu;
    const ella_real L_forearm_z3 = c->links[1].M_Wphi_33 * state->q[8];

    /* forearm, Ldot: rate of L */
    const ella_real Ldot_forearm_x2 = c->links[1].Gamma_xy_11 * state->v[6];
    const ella_real Ldot_forearm_x3 = c->links[1].Gamma_xz_11 * state->v[6];
    const ella_real Ldot_forearm_y1 = c->links[1].Gamma_xy_11 * state->v[7];
    const ella_real Ldot_forearm_y3 = state->v[7] * c->links[1].mu;
    const ella_real Ldot_forearm_z1 = c->links[1].Gamma_xz_11 * state->v[8];
    const ella_real Ldot_forearm_z2 = state->v[8] * c->links[1].mu;

    /* forearm, J: second moment */
    const ella_real J_forearm_xx = c->links[1].J_0_xx + L_forearm_x1 * state->q[6]
        + c->links[1].chi_1 * state->q[6];
    const ella_real J_forearm_xy = L_forearm_y1 * state->q[6] + c->links[1].chi_2 * state->q[7];
    const ella_real J_forearm_xz = L_forearm_z1 * state->q[6] + c->links[1].chi_3 * state->q[8];
    const ella_real J_forearm_yy = L_forearm_y2 * state->q[7];
    const ella_real J_forearm_yz = L_forearm_z2 * state->q[7];
    const ella_real J_forearm_zz = L_forearm_z3 * state->q[8];

    /* forearm, I: inertia about the origin, deformed */
    const ella_real I_forearm_xx = c->links[1].I_s + J_forearm_yy + J_forearm_zz;
    const ella_real I_forearm_yy = J_forearm_xx + J_forearm_zz;
    const ella_real I_forearm_zz = J_forearm_xx + J_forearm_yy;

    /* forearm, a_0: acceleration of the origin at rest rates, against free fall */
    const ella_real a_0_forearm_x = omega_R_forearm_y * v_T_upper_arm_z - omega_forearm_z * v_R_forearm_y;
    const ella_real a_0_forearm_y = omega_forearm_z * v_R_forearm_x - omega_R_forearm_x * v_T_upper_arm_z;
    const ella_real a_0_forearm_z = omega_R_forearm_x * v_R_forearm_y - omega_R_forearm_y * v_R_forearm_x;

    /* forearm, Omega: centripetal operator */
    const ella_real t32 = omega_R_forearm_y * omega_R_forearm_y;
    const ella_real t33 = omega_forearm_z * omega_forearm_z;
    const ella_real minus_Omega_forearm_xx = t32 + t33;
    const ella_real Omega_forearm_xy = omega_R_forearm_x * omega_R_forearm_y;
    const ella_real Omega_forearm_xz = omega_R_forearm_x * omega_forearm_z;
    const ella_real t34 = omega_R_forearm_x * omega_R_forearm_x;
    const ella_real minus_Omega_forearm_yy = t34 + t33;
    const ella_real Omega_forearm_yz = omega_R_forearm_y * omega_forearm_z;
    const ella_real minus_Omega_forearm_zz = t34 + t32;

    /* forearm, B: moment of the elastic velocity */
    const ella_real B_forearm_xx = L_forearm_x1 * state->v[6];
    const ella_real B_forearm_xy = L_forearm_y1 * state->v[6];
    const ella_real B_forearm_xz = L_forearm_z1 * state->v[6];
    const ella_real B_forearm_yx = L_forearm_x2 * state->v[7];
    const ella_real B_forearm_yy = L_forearm_y2 * state->v[7];
    const ella_real B_forearm_yz = L_forearm_z2 * state->v[7];
    const ella_real B_forearm_zx = L_forearm_x3 * state->v[8];
    const ella_real B_forearm_zy = L_forearm_y3 * state->v[8];
    const ella_real B_forearm_zz = L_forearm_z3 * state->v[8];

    /* forearm, h_c: half of the Coriolis wrench */
    const ella_real t35 = B_forearm_yy * omega_R_forearm_x + B_forearm_zz * omega_R_forearm_x
        - B_forearm_xy * omega_R_forearm_y;
    const ella_real h_c_forearm_1 = t35 - B_forearm_xz * omega_forearm_z;
    const ella_real t36 = B_forearm_xx * omega_R_forearm_y + B_forearm_zz * omega_R_forearm_y
        - B_forearm_yx * omega_R_forearm_x;
    const ella_real h_c_forearm_2 = t36 - B_forearm_yz * omega_forearm_z;
    const ella_real t37 = B_forearm_xx * omega_forearm_z + B_forearm_yy * omega_forearm_z
        - B_forearm_zx * omega_R_forearm_x;
    const ella_real h_c_forearm_3 = t37 - B_forearm_zy * omega_R_forearm_y;
    const ella_real h_c_forearm_4 = Sdot_forearm_z * omega_R_forearm_y - Sdot_forearm_y * omega_forearm_z;
    const ella_real h_c_forearm_5 = Sdot_forearm_x * omega_forearm_z - Sdot_forearm_z * omega_R_forearm_x;
    const ella_real h_c_forearm_6 = Sdot_forearm_y * omega_R_forearm_x - Sdot_forearm_x * omega_R_forearm_y;

    /* forearm, H_star: gyroscopic wrench and weight (29) */
    const ella_real t38 = h_c_forearm_1 + J_forearm_xy * Omega_forearm_xz + J_forearm_yy * Omega_forearm_yz
        + J_forearm_yz * (minus_Omega_forearm_yy - minus_Omega_forearm_zz);
    const ella_real t39 = t38 + S_forearm_y * a_0_forearm_z - J_forearm_xz * Omega_forearm_xy
        - J_forearm_zz * Omega_forearm_yz;
    const ella_real H_star_forearm_1 = t39 - S_forearm_z * a_0_forearm_y;
    const ella_real t40 = h_c_forearm_2 + J_forearm_xz * (minus_Omega_forearm_zz - minus_Omega_forearm_xx)
        + J_forearm_yz * Omega_forearm_xy;
    const ella_real t41 = c->links[1].I_s * omega_R_forearm_x;
    const ella_real t42 = t40 + J_forearm_zz * Omega_forearm_xz + S_forearm_z * a_0_forearm_x
        + t41 * omega_forearm_z - J_forearm_xx * Omega_forearm_xz;
    const ella_real H_star_forearm_2 = t42 - J_forearm_xy * Omega_forearm_yz - S_forearm_x * a_0_forearm_z;
    const ella_real t43 = h_c_forearm_3 + J_forearm_xx * Omega_forearm_xy
        + J_forearm_xy * (minus_Omega_forearm_xx - minus_Omega_forearm_yy);
    const ella_real t44 = t43 + J_forearm_xz * Omega_forearm_yz + S_forearm_x * a_0_forearm_y
        - J_forearm_yy * Omega_forearm_xy;
    const ella_real H_star_forearm_3 = t44 - J_forearm_yz * Omega_forearm_xz - S_forearm_y * a_0_forearm_x
        - t41 * omega_R_forearm_y;
    const ella_real t45 = h_c_forearm_4 - minus_Omega_forearm_xx * S_forearm_x + Omega_forearm_xy * S_forearm_y
        + Omega_forearm_xz * S_forearm_z;
    const ella_real H_star_forearm_4 = t45 + a_0_forearm_x * c->links[1].mu;
    const ella_real t46 = h_c_forearm_5 + Omega_forearm_xy * S_forearm_x - minus_Omega_forearm_yy * S_forearm_y
        + Omega_forearm_yz * S_forearm_z;
    const ella_real H_star_forearm_5 = t46 + a_0_forearm_y * c->links[1].mu;
    const ella_real t47 = h_c_forearm_6 + Omega_forearm_xz * S_forearm_x + Omega_forearm_yz * S_forearm_y
        - minus_Omega_forearm_zz * S_forearm_z;
    const ella_real H_star_forearm_6 = t47 + a_0_forearm_z * c->links[1].mu;

    /* forearm, h_V: bias of the twist rows */
    const ella_real h_V_forearm_1 = H_star_forearm_1 + h_c_forearm_1;
    const ella_real h_V_forearm_2 = H_star_forearm_2 + h_c_forearm_2;
    const ella_real h_V_forearm_3 = H_star_forearm_3 + h_c_forearm_3;
    const ella_real h_V_forearm_4 = H_star_forearm_4 + h_c_forearm_4;
    const ella_real h_V_forearm_5 = H_star_forearm_5 + h_c_forearm_5;
    const ella_real h_V_forearm_6 = H_star_forearm_6 + h_c_forearm_6;

    /* forearm, h_eta: gyroscopic force and weight on the modes (88) */
    const ella_real t48 = L_forearm_y1 * Omega_forearm_xy - L_forearm_x1 * minus_Omega_forearm_xx
        + L_forearm_z1 * Omega_forearm_xz;
    const ella_real h_eta_forearm_1 = t48 + a_0_forearm_x * c->links[1].sigma_x1
        + Ldot_forearm_z1 * 2 * omega_R_forearm_y - Ldot_forearm_y1 * 2 * omega_forearm_z;
    const ella_real t49 = L_forearm_x2 * Omega_forearm_xy - L_forearm_y2 * minus_Omega_forearm_yy
        + L_forearm_z2 * Omega_forearm_yz;
    const ella_real h_eta_forearm_2 = t49 + a_0_forearm_y * c->links[1].sigma_y2
        + Ldot_forearm_x2 * 2 * omega_forearm_z - Ldot_forearm_z2 * 2 * omega_R_forearm_x;
    const ella_real t50 = L_forearm_x3 * Omega_forearm_xz + L_forearm_y3 * Omega_forearm_yz
        - L_forearm_z3 * minus_Omega_forearm_zz;
    const ella_real h_eta_forearm_3 = t50 + a_0_forearm_z * c->links[1].sigma_z3
        + Ldot_forearm_y3 * 2 * omega_R_forearm_x - Ldot_forearm_x3 * 2 * omega_R_forearm_y;

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

    /* forearm, udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_forearm_x = state->v[6] * REAL(1.4142135623730951);
    const ella_real udot_T_forearm_y = state->v[7] * 2;
    const ella_real udot_T_forearm_z = state->v[8] * 2;

    /* forearm, thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_forearm_y = c->links[1].Psi_c_y3 * state->v[8];
    const ella_real thetadot_forearm_z = c->links[1].Psi_c_z2 * state->v[7];

    /* forearm, omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t51 = theta_forearm_y * thetadot_forearm_z - theta_forearm_z * thetadot_forearm_y;
    const ella_real omega_s_forearm_x = c2_forearm * t51;
    const ella_real omega_s_forearm_y = thetadot_forearm_y + c3_forearm * theta_forearm_z * t51;
    const ella_real omega_s_forearm_z = thetadot_forearm_z - c3_forearm * theta_forearm_y * t51;

    /* forearm, omega_T: angular velocity of the tip section (46) */
    const ella_real t52 = omega_s_forearm_x + omega_R_forearm_x;
    const ella_real t53 = omega_s_forearm_y + omega_R_forearm_y;
    const ella_real t54 = omega_s_forearm_z + omega_forearm_z;
    const ella_real omega_T_forearm_x = R_T_forearm_xx * t52 + minus_R_T_forearm_xy * t53 - R_T_forearm_xz * t54;
    const ella_real omega_T_forearm_y = R_T_forearm_yy * t53 - minus_R_T_forearm_xy * t52 + R_T_forearm_yz * t54;
    const ella_real omega_T_forearm_z = R_T_forearm_xz * t52 + R_T_forearm_yz * t53 + R_T_forearm_zz * t54;

    /* forearm, v_T: velocity of the tip point (46) */
    const ella_real t55 = udot_T_forearm_x + v_R_forearm_x + omega_R_forearm_y * r_T_forearm_z
        - omega_forearm_z * r_T_forearm_y;
    const ella_real t56 = udot_T_forearm_y + v_R_forearm_y + omega_forearm_z * r_T_forearm_x
        - omega_R_forearm_x * r_T_forearm_z;
    const ella_real t57 = udot_T_forearm_z + v_T_upper_arm_z + omega_R_forearm_x * r_T_forearm_y
        - omega_R_forearm_y * r_T_forearm_x;
    const ella_real v_T_forearm_x = R_T_forearm_xx * t55 + minus_R_T_forearm_xy * t56 - R_T_forearm_xz * t57;
    const ella_real v_T_forearm_y = R_T_forearm_yy * t56 - minus_R_T_forearm_xy * t55 + R_T_forearm_yz * t57;
    const ella_real v_T_forearm_z = R_T_forearm_xz * t55 + R_T_forearm_yz * t56 + R_T_forearm_zz * t57;

    /* forearm, b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const ella_real t58 = omega_s_forearm_z * t56 + omega_R_forearm_y * udot_T_forearm_z
        - omega_s_forearm_y * t57 - omega_forearm_z * udot_T_forearm_y;
    const ella_real t59 = omega_s_forearm_x * t57 + omega_forearm_z * udot_T_forearm_x - omega_s_forearm_z * t55
        - omega_R_forearm_x * udot_T_forearm_z;
    const ella_real t60 = omega_s_forearm_y * t55 + omega_R_forearm_x * udot_T_forearm_y
        - omega_s_forearm_x * t56 - omega_R_forearm_y * udot_T_forearm_x;
    const ella_real b_v_forearm_x = R_T_forearm_xx * t58 + minus_R_T_forearm_xy * t59 - R_T_forearm_xz * t60;
    const ella_real b_v_forearm_y = R_T_forearm_yy * t59 - minus_R_T_forearm_xy * t58 + R_T_forearm_yz * t60;
    const ella_real b_v_forearm_z = R_T_forearm_xz * t58 + R_T_forearm_yz * t59 + R_T_forearm_zz * t60;

    /* forearm, a_T: acceleration of the tip point at rest rates, against free fall */
    const ella_real a_T_forearm_x = omega_T_forearm_y * v_T_forearm_z - omega_T_forearm_z * v_T_forearm_y;
    const ella_real a_T_forearm_y = omega_T_forearm_z * v_T_forearm_x - omega_T_forearm_x * v_T_forearm_z;
    const ella_real a_T_forearm_z = omega_T_forearm_x * v_T_forearm_y - omega_T_forearm_y * v_T_forearm_x;

    /* forearm, h_T_F: force that the bodies' velocities and weight need */
    const ella_real h_T_F_forearm_x = a_T_forearm_x * c->links[1].body0_mass;
    const ella_real h_T_F_forearm_y = a_T_forearm_y * c->links[1].body0_mass;
    const ella_real h_T_F_forearm_z = a_T_forearm_z * c->links[1].body0_mass;

    /* forearm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real t61 = h_T_F_forearm_x - input->w_ext[1][3] + c->links[1].body0_mass * b_v_forearm_x;
    const ella_real t62 = h_T_F_forearm_y - input->w_ext[1][4] + c->links[1].body0_mass * b_v_forearm_y;
    const ella_real t63 = h_T_F_forearm_z - input->w_ext[1][5] + c->links[1].body0_mass * b_v_forearm_z;
    const ella_real t64 = c->links[1].body0_mass * minus_R_T_forearm_xy;
    const ella_real t65 = c->links[1].body0_mass * R_T_forearm_xz;
    const ella_real t66 = c->links[1].body0_mass * R_T_forearm_yy;
    const ella_real t67 = c->links[1].body0_mass * R_T_forearm_yz;
    const ella_real t68 = c->links[1].body0_mass * R_T_forearm_zz;
    const ella_real t69 = minus_R_T_forearm_xy * t64;
    const ella_real t70 = R_T_forearm_xz * t65;
    const ella_real Lambda_T_forearm_44 = R_T_forearm_xx * (c->links[1].body0_mass * R_T_forearm_xx) + t69 + t70;
    const ella_real Lambda_T_forearm_45 = R_T_forearm_xx * t64 - minus_R_T_forearm_xy * t66
        + R_T_forearm_xz * t67;
    const ella_real Lambda_T_forearm_46 = R_T_forearm_xz * t68
        - (R_T_forearm_xx * t65 + minus_R_T_forearm_xy * t67);
    const ella_real t71 = R_T_forearm_yz * t67;
    const ella_real Lambda_T_forearm_55 = t69 + R_T_forearm_yy * t66 + t71;
    const ella_real Lambda_T_forearm_56 = R_T_forearm_yy * t67 - minus_R_T_forearm_xy * t65
        + R_T_forearm_yz * t68;
    const ella_real Lambda_T_forearm_66 = t71 + t70 + R_T_forearm_zz * t68;
    const ella_real p_T_forearm_1 = minus_R_T_forearm_xy * input->w_ext[1][1]
        - R_T_forearm_xx * input->w_ext[1][0] - R_T_forearm_xz * input->w_ext[1][2];
    const ella_real minus_p_T_forearm_2 = minus_R_T_forearm_xy * input->w_ext[1][0]
        + R_T_forearm_yy * input->w_ext[1][1] + R_T_forearm_yz * input->w_ext[1][2];
    const ella_real p_T_forearm_3 = R_T_forearm_xz * input->w_ext[1][0] - R_T_forearm_yz * input->w_ext[1][1]
        - R_T_forearm_zz * input->w_ext[1][2];
    const ella_real p_T_forearm_4 = R_T_forearm_xx * t61 - minus_R_T_forearm_xy * t62 + R_T_forearm_xz * t63;
    const ella_real p_T_forearm_5 = minus_R_T_forearm_xy * t61 + R_T_forearm_yy * t62 + R_T_forearm_yz * t63;
    const ella_real p_T_forearm_6 = R_T_forearm_yz * t62 - R_T_forearm_xz * t61 + R_T_forearm_zz * t63;

    /* forearm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real t72 = r_T_forearm_z * Lambda_T_forearm_45;
    const ella_real t73 = r_T_forearm_y * Lambda_T_forearm_46;
    const ella_real M_loaded_forearm_14 = t73 - t72;
    const ella_real t74 = r_T_forearm_y * Lambda_T_forearm_56 - r_T_forearm_z * Lambda_T_forearm_55;
    const ella_real t75 = r_T_forearm_y * Lambda_T_forearm_66 - r_T_forearm_z * Lambda_T_forearm_56;
    const ella_real t76 = r_T_forearm_z * Lambda_T_forearm_44 - r_T_forearm_x * Lambda_T_forearm_46;
    const ella_real t77 = r_T_forearm_x * Lambda_T_forearm_56;
    const ella_real M_loaded_forearm_25 = t72 - t77;
    const ella_real t78 = r_T_forearm_z * Lambda_T_forearm_46 - r_T_forearm_x * Lambda_T_forearm_66;
    const ella_real t79 = r_T_forearm_x * Lambda_T_forearm_45 - r_T_forearm_y * Lambda_T_forearm_44;
    const ella_real t80 = r_T_forearm_x * Lambda_T_forearm_55 - r_T_forearm_y * Lambda_T_forearm_45;
    const ella_real M_loaded_forearm_36 = t77 - t73;
    const ella_real M_loaded_forearm_11 = I_forearm_xx + (r_T_forearm_y * t75 - r_T_forearm_z * t74);
    const ella_real M_loaded_forearm_12 = r_T_forearm_y * t78 - r_T_forearm_z * M_loaded_forearm_25
        - J_forearm_xy;
    const ella_real M_loaded_forearm_13 = r_T_forearm_y * M_loaded_forearm_36 - r_T_forearm_z * t80
        - J_forearm_xz;
    const ella_real M_loaded_forearm_15 = t74 - S_forearm_z;
    const ella_real M_loaded_forearm_16 = S_forearm_y + t75;
    const ella_real M_loaded_forearm_22 = I_forearm_yy + (r_T_forearm_z * t76 - r_T_forearm_x * t78);
    const ella_real M_loaded_forearm_23 = r_T_forearm_z * t79 - r_T_forearm_x * M_loaded_forearm_36
        - J_forearm_yz;
    const ella_real M_loaded_forearm_24 = S_forearm_z + t76;
    const ella_real M_loaded_forearm_26 = t78 - S_forearm_x;
    const ella_real M_loaded_forearm_33 = I_forearm_zz + (r_T_forearm_x * t80 - r_T_forearm_y * t79);
    const ella_real M_loaded_forearm_34 = t79 - S_forearm_y;
    const ella_real M_loaded_forearm_35 = S_forearm_x + t80;
    const ella_real M_loaded_forearm_44 = c->links[1].mu + Lambda_T_forearm_44;
    const ella_real M_loaded_forearm_55 = c->links[1].mu + Lambda_T_forearm_55;
    const ella_real M_loaded_forearm_66 = c->links[1].mu + Lambda_T_forearm_66;
    const ella_real h_loaded_forearm_1 = h_V_forearm_1
        + (p_T_forearm_1 + (r_T_forearm_y * p_T_forearm_6 - r_T_forearm_z * p_T_forearm_5));
    const ella_real h_loaded_forearm_2 = h_V_forearm_2
        + (r_T_forearm_z * p_T_forearm_4 - r_T_forearm_x * p_T_forearm_6 - minus_p_T_forearm_2);
    const ella_real h_loaded_forearm_3 = h_V_forearm_3
        + (p_T_forearm_3 + (r_T_forearm_x * p_T_forearm_5 - r_T_forearm_y * p_T_forearm_4));
    const ella_real h_loaded_forearm_4 = h_V_forearm_4 + p_T_forearm_4;
    const ella_real h_loaded_forearm_5 = h_V_forearm_5 + p_T_forearm_5;
    const ella_real h_loaded_forearm_6 = h_V_forearm_6 + p_T_forearm_6;
    const ella_real t81 = Lambda_T_forearm_44 * REAL(1.4142135623730951);
    const ella_real C_forearm_42 = Lambda_T_forearm_45 * 2;
    const ella_real C_forearm_43 = Lambda_T_forearm_46 * 2;
    const ella_real C_forearm_51 = Lambda_T_forearm_45 * REAL(1.4142135623730951);
    const ella_real t82 = Lambda_T_forearm_55 * 2;
    const ella_real C_forearm_53 = Lambda_T_forearm_56 * 2;
    const ella_real C_forearm_61 = Lambda_T_forearm_46 * REAL(1.4142135623730951);
    const ella_real t83 = Lambda_T_forearm_66 * 2;
    const ella_real C_forearm_11 = r_T_forearm_y * C_forearm_61 - r_T_forearm_z * C_forearm_51;
    const ella_real t84 = r_T_forearm_x * C_forearm_53;
    const ella_real C_forearm_22 = r_T_forearm_z * C_forearm_42 - t84;
    const ella_real C_forearm_33 = t84 - r_T_forearm_y * C_forearm_43;
    const ella_real C_forearm_12 = r_T_forearm_y * C_forearm_53 - r_T_forearm_z * t82 - L_forearm_z2;
    const ella_real C_forearm_13 = L_forearm_y3 + (r_T_forearm_y * t83 - r_T_forearm_z * C_forearm_53);
    const ella_real C_forearm_21 = L_forearm_z1 + (r_T_forearm_z * t81 - r_T_forearm_x * C_forearm_61);
    const ella_real C_forearm_23 = r_T_forearm_z * C_forearm_43 - r_T_forearm_x * t83 - L_forearm_x3;
    const ella_real C_forearm_31 = r_T_forearm_x * C_forearm_51 - r_T_forearm_y * t81 - L_forearm_y1;
    const ella_real C_forearm_32 = L_forearm_x2 + (r_T_forearm_x * t82 - r_T_forearm_y * C_forearm_42);
    const ella_real C_forearm_41 = c->links[1].sigma_x1 + t81;
    const ella_real C_forearm_52 = c->links[1].sigma_y2 + t82;
    const ella_real C_forearm_63 = c->links[1].sigma_z3 + t83;
    const ella_real modal_inertia_forearm_12 = Lambda_T_forearm_45 * REAL(2.8284271247461903);
    const ella_real modal_inertia_forearm_13 = Lambda_T_forearm_46 * REAL(2.8284271247461903);
    const ella_real modal_inertia_forearm_23 = Lambda_T_forearm_56 * 4;
    const ella_real modal_inertia_forearm_11 = Lambda_T_forearm_44 * REAL(2.0000000000000004) + work->m_eta[3];
    bad |= (unsigned long)(!(modal_inertia_forearm_11 > 0)) << 1;
    const ella_real modal_inertia_forearm_22 = Lambda_T_forearm_55 * 4 + work->m_eta[4];
    const ella_real modal_inertia_forearm_33 = Lambda_T_forearm_66 * 4 + work->m_eta[5];
    const ella_real t85 = J_l_forearm_yz * p_T_forearm_3
        - (J_l_forearm_yy * minus_p_T_forearm_2 + minus_J_l_forearm_xy * p_T_forearm_1);
    const ella_real t86 = J_l_forearm_xz * p_T_forearm_1 - J_l_forearm_yz * minus_p_T_forearm_2
        + J_l_forearm_zz * p_T_forearm_3;
    const ella_real h_phi_forearm_1 = h_eta_forearm_1 + work->f_eta[3] + p_T_forearm_4 * REAL(1.4142135623730951);
    const ella_real h_phi_forearm_2 = h_eta_forearm_2 + work->f_eta[4]
        + (c->links[1].Psi_c_z2 * t86 + p_T_forearm_5 * 2);
    const ella_real h_phi_forearm_3 = h_eta_forearm_3 + work->f_eta[5]
        + (c->links[1].Psi_c_y3 * t85 + p_T_forearm_6 * 2);
    const ella_real modes_inverse_forearm_1 = 1 / modal_inertia_forearm_11;
    const ella_real modes_L_forearm_21 = modal_inertia_forearm_12 * modes_inverse_forearm_1;
    const ella_real modes_L_forearm_31 = modal_inertia_forearm_13 * modes_inverse_forearm_1;
    const ella_real t87 = modal_inertia_forearm_22 - modal_inertia_forearm_12 * modes_L_forearm_21;
    bad |= (unsigned long)(!(t87 > 0)) << 1;
    const ella_real modes_inverse_forearm_2 = 1 / t87;
    const ella_real t88 = modal_inertia_forearm_23 - modal_inertia_forearm_12 * modes_L_forearm_31;
    const ella_real modes_L_forearm_32 = t88 * modes_inverse_forearm_2;
    const ella_real t89 = modal_inertia_forearm_33
        - (modal_inertia_forearm_13 * modes_L_forearm_31 + t88 * modes_L_forearm_32);
    bad |= (unsigned long)(!(t89 > 0)) << 1;
    const ella_real modes_inverse_forearm_3 = 1 / t89;
    const ella_real t90 = C_forearm_12 - modes_L_forearm_21 * C_forearm_11;
    const ella_real t91 = C_forearm_22 - modes_L_forearm_21 * C_forearm_21;
    const ella_real t92 = C_forearm_32 - modes_L_forearm_21 * C_forearm_31;
    const ella_real t93 = C_forearm_42 - modes_L_forearm_21 * C_forearm_41;
    const ella_real t94 = C_forearm_52 - modes_L_forearm_21 * C_forearm_51;
    const ella_real t95 = C_forearm_53 - modes_L_forearm_21 * C_forearm_61;
    const ella_real t96 = C_forearm_13 - modes_L_forearm_31 * C_forearm_11 - modes_L_forearm_32 * t90;
    const ella_real t97 = C_forearm_23 - modes_L_forearm_31 * C_forearm_21 - modes_L_forearm_32 * t91;
    const ella_real t98 = C_forearm_33 - modes_L_forearm_31 * C_forearm_31 - modes_L_forearm_32 * t92;
    const ella_real t99 = C_forearm_43 - modes_L_forearm_31 * C_forearm_41 - modes_L_forearm_32 * t93;
    const ella_real t100 = C_forearm_53 - modes_L_forearm_31 * C_forearm_51 - modes_L_forearm_32 * t94;
    const ella_real t101 = C_forearm_63 - modes_L_forearm_31 * C_forearm_61 - modes_L_forearm_32 * t95;
    const ella_real t102 = h_phi_forearm_2 - modes_L_forearm_21 * h_phi_forearm_1;
    const ella_real t103 = h_phi_forearm_3 - modes_L_forearm_31 * h_phi_forearm_1 - modes_L_forearm_32 * t102;
    const ella_real modes_W_forearm_11 = C_forearm_11 * modes_inverse_forearm_1;
    const ella_real modes_W_forearm_12 = C_forearm_21 * modes_inverse_forearm_1;
    const ella_real modes_W_forearm_13 = C_forearm_31 * modes_inverse_forearm_1;
    const ella_real modes_W_forearm_14 = C_forearm_41 * modes_inverse_forearm_1;
    const ella_real modes_W_forearm_15 = C_forearm_51 * modes_inverse_forearm_1;
    const ella_real modes_W_forearm_16 = C_forearm_61 * modes_inverse_forearm_1;
    const ella_real modes_W_forearm_21 = t90 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_22 = t91 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_23 = t92 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_24 = t93 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_25 = t94 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_26 = t95 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_31 = t96 * modes_inverse_forearm_3;
    const ella_real modes_W_forearm_32 = t97 * modes_inverse_forearm_3;
    const ella_real modes_W_forearm_33 = t98 * modes_inverse_forearm_3;
    const ella_real modes_W_forearm_34 = t99 * modes_inverse_forearm_3;
    const ella_real modes_W_forearm_35 = t100 * modes_inverse_forearm_3;
    const ella_real modes_W_forearm_36 = t101 * modes_inverse_forearm_3;
    const ella_real modes_w_forearm_1 = h_phi_forearm_1 * modes_inverse_forearm_1;
    const ella_real modes_w_forearm_2 = t102 * modes_inverse_forearm_2;
    const ella_real modes_w_forearm_3 = t103 * modes_inverse_forearm_3;
    const ella_real M_i_forearm_11 = M_loaded_forearm_11
        - (C_forearm_11 * modes_W_forearm_11 + t90 * modes_W_forearm_21 + t96 * modes_W_forearm_31);
    const ella_real M_i_forearm_12 = M_loaded_forearm_12
        - (C_forearm_11 * modes_W_forearm_12 + t90 * modes_W_forearm_22 + t96 * modes_W_forearm_32);
    const ella_real M_i_forearm_13 = M_loaded_forearm_13
        - (C_forearm_11 * modes_W_forearm_13 + t90 * modes_W_forearm_23 + t96 * modes_W_forearm_33);
    const ella_real M_i_forearm_14 = M_loaded_forearm_14
        - (C_forearm_11 * modes_W_forearm_14 + t90 * modes_W_forearm_24 + t96 * modes_W_forearm_34);
    const ella_real M_i_forearm_15 = M_loaded_forearm_15
        - (C_forearm_11 * modes_W_forearm_15 + t90 * modes_W_forearm_25 + t96 * modes_W_forearm_35);
    const ella_real M_i_forearm_16 = M_loaded_forearm_16
        - (C_forearm_11 * modes_W_forearm_16 + t90 * modes_W_forearm_26 + t96 * modes_W_forearm_36);
    const ella_real M_i_forearm_22 = M_loaded_forearm_22
        - (C_forearm_21 * modes_W_forearm_12 + t91 * modes_W_forearm_22 + t97 * modes_W_forearm_32);
    const ella_real M_i_forearm_23 = M_loaded_forearm_23
        - (C_forearm_21 * modes_W_forearm_13 + t91 * modes_W_forearm_23 + t97 * modes_W_forearm_33);
    const ella_real M_i_forearm_24 = M_loaded_forearm_24
        - (C_forearm_21 * modes_W_forearm_14 + t91 * modes_W_forearm_24 + t97 * modes_W_forearm_34);
    const ella_real M_i_forearm_25 = M_loaded_forearm_25
        - (C_forearm_21 * modes_W_forearm_15 + t91 * modes_W_forearm_25 + t97 * modes_W_forearm_35);
    const ella_real M_i_forearm_26 = M_loaded_forearm_26
        - (C_forearm_21 * modes_W_forearm_16 + t91 * modes_W_forearm_26 + t97 * modes_W_forearm_36);
    const ella_real M_i_forearm_33 = M_loaded_forearm_33
        - (C_forearm_31 * modes_W_forearm_13 + t92 * modes_W_forearm_23 + t98 * modes_W_forearm_33);
    const ella_real M_i_forearm_34 = M_loaded_forearm_34
        - (C_forearm_31 * modes_W_forearm_14 + t92 * modes_W_forearm_24 + t98 * modes_W_forearm_34);
    const ella_real M_i_forearm_35 = M_loaded_forearm_35
        - (C_forearm_31 * modes_W_forearm_15 + t92 * modes_W_forearm_25 + t98 * modes_W_forearm_35);
    const ella_real M_i_forearm_36 = M_loaded_forearm_36
        - (C_forearm_31 * modes_W_forearm_16 + t92 * modes_W_forearm_26 + t98 * modes_W_forearm_36);
    const ella_real M_i_forearm_44 = M_loaded_forearm_44
        - (C_forearm_41 * modes_W_forearm_14 + t93 * modes_W_forearm_24 + t99 * modes_W_forearm_34);
    const ella_real M_i_forearm_45 = Lambda_T_forearm_45
        - (C_forearm_41 * modes_W_forearm_15 + t93 * modes_W_forearm_25 + t99 * modes_W_forearm_35);
    const ella_real M_i_forearm_46 = Lambda_T_forearm_46
        - (C_forearm_41 * modes_W_forearm_16 + t93 * modes_W_forearm_26 + t99 * modes_W_forearm_36);
    const ella_real M_i_forearm_55 = M_loaded_forearm_55
        - (C_forearm_51 * modes_W_forearm_15 + t94 * modes_W_forearm_25 + t100 * modes_W_forearm_35);
    const ella_real M_i_forearm_56 = Lambda_T_forearm_56
        - (C_forearm_51 * modes_W_forearm_16 + t94 * modes_W_forearm_26 + t100 * modes_W_forearm_36);
    const ella_real M_i_forearm_66 = M_loaded_forearm_66
        - (C_forearm_61 * modes_W_forearm_16 + t95 * modes_W_forearm_26 + t101 * modes_W_forearm_36);
    const ella_real h_i_forearm_1 = h_loaded_forearm_1
        - (modes_W_forearm_11 * h_phi_forearm_1 + modes_W_forearm_21 * t102 + modes_W_forearm_31 * t103);
    const ella_real h_i_forearm_2 = h_loaded_forearm_2
        - (modes_W_forearm_12 * h_phi_forearm_1 + modes_W_forearm_22 * t102 + modes_W_forearm_32 * t103);
    const ella_real h_i_forearm_3 = h_loaded_forearm_3
        - (modes_W_forearm_13 * h_phi_forearm_1 + modes_W_forearm_23 * t102 + modes_W_forearm_33 * t103);
    const ella_real h_i_forearm_4 = h_loaded_forearm_4
        - (modes_W_forearm_14 * h_phi_forearm_1 + modes_W_forearm_24 * t102 + modes_W_forearm_34 * t103);
    const ella_real h_i_forearm_5 = h_loaded_forearm_5
        - (modes_W_forearm_15 * h_phi_forearm_1 + modes_W_forearm_25 * t102 + modes_W_forearm_35 * t103);
    const ella_real h_i_forearm_6 = h_loaded_forearm_6
        - (modes_W_forearm_16 * h_phi_forearm_1 + modes_W_forearm_26 * t102 + modes_W_forearm_36 * t103);

    /* forearm, joint: its accelerations eliminated from its rows (43) */
    const ella_real t104 = M_i_forearm_11 * beta_omega_forearm_x - M_i_forearm_12 * minus_beta_omega_forearm_y
        + M_i_forearm_14 * beta_v_forearm_x;
    const ella_real t105 = M_i_forearm_12 * beta_omega_forearm_x - M_i_forearm_22 * minus_beta_omega_forearm_y
        + M_i_forearm_24 * beta_v_forearm_x;
    const ella_real t106 = M_i_forearm_13 * beta_omega_forearm_x - M_i_forearm_23 * minus_beta_omega_forearm_y
        + M_i_forearm_34 * beta_v_forearm_x;
    const ella_real t107 = M_i_forearm_14 * beta_omega_forearm_x - M_i_forearm_24 * minus_beta_omega_forearm_y
        + M_i_forearm_44 * beta_v_forearm_x;
    const ella_real t108 = M_i_forearm_15 * beta_omega_forearm_x - M_i_forearm_25 * minus_beta_omega_forearm_y
        + M_i_forearm_45 * beta_v_forearm_x;
    const ella_real t109 = M_i_forearm_16 * beta_omega_forearm_x - M_i_forearm_26 * minus_beta_omega_forearm_y
        + M_i_forearm_46 * beta_v_forearm_x;
    const ella_real bias_forearm_1 = h_i_forearm_1 + (t104 - M_i_forearm_15 * minus_beta_v_forearm_y);
    const ella_real bias_forearm_2 = h_i_forearm_2 + (t105 - M_i_forearm_25 * minus_beta_v_forearm_y);
    const ella_real bias_forearm_3 = h_i_forearm_3 + (t106 - M_i_forearm_35 * minus_beta_v_forearm_y);
    const ella_real bias_forearm_4 = h_i_forearm_4 + (t107 - M_i_forearm_45 * minus_beta_v_forearm_y);
    const ella_real bias_forearm_5 = h_i_forearm_5 + (t108 - M_i_forearm_55 * minus_beta_v_forearm_y);
    const ella_real bias_forearm_6 = h_i_forearm_6 + (t109 - M_i_forearm_56 * minus_beta_v_forearm_y);
    const ella_real t110 = ELLA_REAL_EPSILON * 8;
    bad |= (unsigned long)(!(M_i_forearm_33 - t110 * (M_i_forearm_11 + M_i_forearm_22 + M_i_forearm_33) > 0)) << 1;
    const ella_real joint_inverse_forearm_1 = 1 / M_i_forearm_33;
    const ella_real joint_W_forearm_11 = M_i_forearm_13 * joint_inverse_forearm_1;
    const ella_real joint_W_forearm_12 = M_i_forearm_23 * joint_inverse_forearm_1;
    const ella_real joint_W_forearm_14 = M_i_forearm_34 * joint_inverse_forearm_1;
    const ella_real joint_W_forearm_15 = M_i_forearm_35 * joint_inverse_forearm_1;
    const ella_real joint_W_forearm_16 = M_i_forearm_36 * joint_inverse_forearm_1;
    const ella_real joint_w_forearm_1 = (input->tau[2] - bias_forearm_3) * joint_inverse_forearm_1;
    const ella_real Lambda_i_forearm_11 = M_i_forearm_11 - M_i_forearm_13 * joint_W_forearm_11;
    const ella_real Lambda_i_forearm_12 = M_i_forearm_12 - M_i_forearm_13 * joint_W_forearm_12;
    const ella_real Lambda_i_forearm_14 = M_i_forearm_14 - M_i_forearm_13 * joint_W_forearm_14;
    const ella_real Lambda_i_forearm_15 = M_i_forearm_15 - M_i_forearm_13 * joint_W_forearm_15;
    const ella_real Lambda_i_forearm_16 = M_i_forearm_16 - M_i_forearm_13 * joint_W_forearm_16;
    const ella_real Lambda_i_forearm_22 = M_i_forearm_22 - M_i_forearm_23 * joint_W_forearm_12;
    const ella_real Lambda_i_forearm_24 = M_i_forearm_24 - M_i_forearm_23 * joint_W_forearm_14;
    const ella_real Lambda_i_forearm_25 = M_i_forearm_25 - M_i_forearm_23 * joint_W_forearm_15;
    const ella_real Lambda_i_forearm_26 = M_i_forearm_26 - M_i_forearm_23 * joint_W_forearm_16;
    const ella_real Lambda_i_forearm_44 = M_i_forearm_44 - M_i_forearm_34 * joint_W_forearm_14;
    const ella_real Lambda_i_forearm_45 = M_i_forearm_45 - M_i_forearm_34 * joint_W_forearm_15;
    const ella_real Lambda_i_forearm_46 = M_i_forearm_46 - M_i_forearm_34 * joint_W_forearm_16;
    const ella_real Lambda_i_forearm_55 = M_i_forearm_55 - M_i_forearm_35 * joint_W_forearm_15;
    const ella_real Lambda_i_forearm_56 = M_i_forearm_56 - M_i_forearm_35 * joint_W_forearm_16;
    const ella_real Lambda_i_forearm_66 = M_i_forearm_66 - M_i_forearm_36 * joint_W_forearm_16;
    const ella_real p_i_forearm_1 = bias_forearm_1 + M_i_forearm_13 * joint_w_forearm_1;
    const ella_real p_i_forearm_2 = bias_forearm_2 + M_i_forearm_23 * joint_w_forearm_1;
    const ella_real p_i_forearm_4 = bias_forearm_4 + M_i_forearm_34 * joint_w_forearm_1;
    const ella_real p_i_forearm_5 = bias_forearm_5 + M_i_forearm_35 * joint_w_forearm_1;
    const ella_real p_i_forearm_6 = bias_forearm_6 + M_i_forearm_36 * joint_w_forearm_1;

    /* forearm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const ella_real t111 = Lambda_i_forearm_12 * minus_R_rel_forearm_xy;
    const ella_real t112 = Lambda_i_forearm_12 * R_rel_forearm_xx;
    const ella_real t113 = Lambda_i_forearm_11 * minus_R_rel_forearm_xy + t112;
    const ella_real t114 = t111 + Lambda_i_forearm_22 * R_rel_forearm_xx;
    const ella_real Lambda_forearm_1 = R_rel_forearm_xx * (Lambda_i_forearm_11 * R_rel_forearm_xx - t111)
        - minus_R_rel_forearm_xy * (t112 - Lambda_i_forearm_22 * minus_R_rel_forearm_xy);
    const ella_real Lambda_forearm_2 = R_rel_forearm_xx * t113 - minus_R_rel_forearm_xy * t114;
    const ella_real Lambda_forearm_7 = minus_R_rel_forearm_xy * t113 + R_rel_forearm_xx * t114;
    const ella_real t115 = Lambda_i_forearm_14 * R_rel_forearm_xx - Lambda_i_forearm_15 * minus_R_rel_forearm_xy;
    const ella_real t116 = Lambda_i_forearm_14 * minus_R_rel_forearm_xy + Lambda_i_forearm_15 * R_rel_forearm_xx;
    const ella_real t117 = Lambda_i_forearm_24 * R_rel_forearm_xx - Lambda_i_forearm_25 * minus_R_rel_forearm_xy;
    const ella_real t118 = Lambda_i_forearm_24 * minus_R_rel_forearm_xy + Lambda_i_forearm_25 * R_rel_forearm_xx;
    const ella_real Lambda_forearm_4 = R_rel_forearm_xx * t115 - minus_R_rel_forearm_xy * t117;
    const ella_real Lambda_forearm_5 = R_rel_forearm_xx * t116 - minus_R_rel_forearm_xy * t118;
    const ella_real Lambda_forearm_6 = R_rel_forearm_xx * Lambda_i_forearm_16
        - minus_R_rel_forearm_xy * Lambda_i_forearm_26;
    const ella_real Lambda_forearm_9 = minus_R_rel_forearm_xy * t115 + R_rel_forearm_xx * t117;
    const ella_real Lambda_forearm_10 = minus_R_rel_forearm_xy * t116 + R_rel_forearm_xx * t118;
    const ella_real Lambda_forearm_11 = minus_R_rel_forearm_xy * Lambda_i_forearm_16
        + R_rel_forearm_xx * Lambda_i_forearm_26;
    const ella_real t119 = Lambda_i_forearm_45 * minus_R_rel_forearm_xy;
    const ella_real t120 = Lambda_i_forearm_45 * R_rel_forearm_xx;
    const ella_real t121 = Lambda_i_forearm_44 * minus_R_rel_forearm_xy + t120;
    const ella_real t122 = t119 + Lambda_i_forearm_55 * R_rel_forearm_xx;
    const ella_real Lambda_forearm_18 = Lambda_i_forearm_46 * R_rel_forearm_xx
        - Lambda_i_forearm_56 * minus_R_rel_forearm_xy;
    const ella_real Lambda_forearm_20 = Lambda_i_forearm_46 * minus_R_rel_forearm_xy
        + Lambda_i_forearm_56 * R_rel_forearm_xx;
    const ella_real Lambda_forearm_16 = R_rel_forearm_xx * (Lambda_i_forearm_44 * R_rel_forearm_xx - t119)
        - minus_R_rel_forearm_xy * (t120 - Lambda_i_forearm_55 * minus_R_rel_forearm_xy);
    const ella_real Lambda_forearm_17 = R_rel_forearm_xx * t121 - minus_R_rel_forearm_xy * t122;
    const ella_real Lambda_forearm_19 = minus_R_rel_forearm_xy * t121 + R_rel_forearm_xx * t122;
    const ella_real p_forearm_1 = R_rel_forearm_xx * p_i_forearm_1 - minus_R_rel_forearm_xy * p_i_forearm_2;
    const ella_real p_forearm_2 = minus_R_rel_forearm_xy * p_i_forearm_1 + R_rel_forearm_xx * p_i_forearm_2;
    const ella_real p_forearm_4 = R_rel_forearm_xx * p_i_forearm_4 - minus_R_rel_forearm_xy * p_i_forearm_5;
    const ella_real p_forearm_5 = minus_R_rel_forearm_xy * p_i_forearm_4 + R_rel_forearm_xx * p_i_forearm_5;

    /* upper_arm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real t123 = Lambda_forearm_16 + c->links[0].body0_mass;
    const ella_real t124 = Lambda_forearm_19 + c->links[0].body0_mass;
    const ella_real t125 = Lambda_i_forearm_66 + c->links[0].body0_mass;
    const ella_real t126 = input->tau[2] - input->w_ext[0][2];
    const ella_real t127 = Lambda_forearm_1 * b_omega_upper_arm_x + Lambda_forearm_2 * b_omega_upper_arm_y
        + Lambda_forearm_4 * b_v_upper_arm_x;
    const ella_real t128 = Lambda_forearm_2 * b_omega_upper_arm_x + Lambda_forearm_7 * b_omega_upper_arm_y
        + Lambda_forearm_9 * b_v_upper_arm_x;
    const ella_real t129 = Lambda_forearm_4 * b_omega_upper_arm_x + Lambda_forearm_9 * b_omega_upper_arm_y
        + t123 * b_v_upper_arm_x;
    const ella_real t130 = Lambda_forearm_5 * b_omega_upper_arm_x + Lambda_forearm_10 * b_omega_upper_arm_y
        + Lambda_forearm_17 * b_v_upper_arm_x;
    const ella_real t131 = Lambda_forearm_6 * b_omega_upper_arm_x + Lambda_forearm_11 * b_omega_upper_arm_y
        + Lambda_forearm_18 * b_v_upper_arm_x;
    const ella_real t132 = p_forearm_1 - input->w_ext[0][0]
        + (t127 + Lambda_forearm_5 * b_v_upper_arm_y + Lambda_forearm_6 * b_v_upper_arm_z);
    const ella_real t133 = p_forearm_2 - input->w_ext[0][1]
        + (t128 + Lambda_forearm_10 * b_v_upper_arm_y + Lambda_forearm_11 * b_v_upper_arm_z);
    const ella_real t134 = p_forearm_4 + h_T_F_upper_arm_x - input->w_ext[0][3]
        + (t129 + Lambda_forearm_17 * b_v_upper_arm_y + Lambda_forearm_18 * b_v_upper_arm_z);
    const ella_real t135 = p_forearm_5 + h_T_F_upper_arm_y - input->w_ext[0][4]
        + (t130 + t124 * b_v_upper_arm_y + Lambda_forearm_20 * b_v_upper_arm_z);
    const ella_real t136 = p_i_forearm_6 + h_T_F_upper_arm_z - input->w_ext[0][5]
        + (t131 + Lambda_forearm_20 * b_v_upper_arm_y + t125 * b_v_upper_arm_z);
    const ella_real t137 = Lambda_forearm_2 * minus_R_T_upper_arm_xy;
    const ella_real t138 = Lambda_forearm_1 * minus_R_T_upper_arm_xy + Lambda_forearm_2 * R_T_upper_arm_yy;
    const ella_real t139 = Lambda_forearm_2 * R_T_upper_arm_yz - Lambda_forearm_1 * R_T_upper_arm_xz;
    const ella_real t140 = t137 + Lambda_forearm_7 * R_T_upper_arm_yy;
    const ella_real t141 = Lambda_forearm_7 * R_T_upper_arm_yz - Lambda_forearm_2 * R_T_upper_arm_xz;
    const ella_real t142 = minus_R_T_upper_arm_xy
        * (Lambda_forearm_2 * R_T_upper_arm_xx - Lambda_forearm_7 * minus_R_T_upper_arm_xy);
    const ella_real Lambda_T_upper_arm_11 = R_T_upper_arm_xx * (Lambda_forearm_1 * R_T_upper_arm_xx - t137)
        - t142;
    const ella_real Lambda_T_upper_arm_12 = R_T_upper_arm_xx * t138 - minus_R_T_upper_arm_xy * t140;
    const ella_real Lambda_T_upper_arm_13 = R_T_upper_arm_xx * t139 - minus_R_T_upper_arm_xy * t141;
    const ella_real Lambda_T_upper_arm_22 = minus_R_T_upper_arm_xy * t138 + R_T_upper_arm_yy * t140;
    const ella_real Lambda_T_upper_arm_23 = minus_R_T_upper_arm_xy * t139 + R_T_upper_arm_yy * t141;
    const ella_real Lambda_T_upper_arm_33 = R_T_upper_arm_yz * t141 - R_T_upper_arm_xz * t139;
    const ella_real t143 = Lambda_forearm_4 * R_T_upper_arm_xx - Lambda_forearm_5 * minus_R_T_upper_arm_xy
        + Lambda_forearm_6 * R_T_upper_arm_xz;
    const ella_real t144 = Lambda_forearm_4 * minus_R_T_upper_arm_xy + Lambda_forearm_5 * R_T_upper_arm_yy
        + Lambda_forearm_6 * R_T_upper_arm_yz;
    const ella_real t145 = Lambda_forearm_5 * R_T_upper_arm_yz - Lambda_forearm_4 * R_T_upper_arm_xz
        + Lambda_forearm_6 * R_T_upper_arm_zz;
    const ella_real t146 = Lambda_forearm_9 * R_T_upper_arm_xx - Lambda_forearm_10 * minus_R_T_upper_arm_xy
        + Lambda_forearm_11 * R_T_upper_arm_xz;
    const ella_real t147 = Lambda_forearm_9 * minus_R_T_upper_arm_xy + Lambda_forearm_10 * R_T_upper_arm_yy
        + Lambda_forearm_11 * R_T_upper_arm_yz;
    const ella_real t148 = Lambda_forearm_10 * R_T_upper_arm_yz - Lambda_forearm_9 * R_T_upper_arm_xz
        + Lambda_forearm_11 * R_T_upper_arm_zz;
    const ella_real Lambda_T_upper_arm_14 = R_T_upper_arm_xx * t143 - minus_R_T_upper_arm_xy * t146;
    const ella_real Lambda_T_upper_arm_15 = R_T_upper_arm_xx * t144 - minus_R_T_upper_arm_xy * t147;
    const ella_real Lambda_T_upper_arm_16 = R_T_upper_arm_xx * t145 - minus_R_T_upper_arm_xy * t148;
    const ella_real Lambda_T_upper_arm_24 = minus_R_T_upper_arm_xy * t143 + R_T_upper_arm_yy * t146;
    const ella_real Lambda_T_upper_arm_25 = minus_R_T_upper_arm_xy * t144 + R_T_upper_arm_yy * t147;
    const ella_real Lambda_T_upper_arm_26 = minus_R_T_upper_arm_xy * t145 + R_T_upper_arm_yy * t148;
    const ella_real Lambda_T_upper_arm_34 = R_T_upper_arm_yz * t146 - R_T_upper_arm_xz * t143;
    const ella_real Lambda_T_upper_arm_35 = R_T_upper_arm_yz * t147 - R_T_upper_arm_xz * t144;
    const ella_real Lambda_T_upper_arm_36 = R_T_upper_arm_yz * t148 - R_T_upper_arm_xz * t145;
    const ella_real t149 = Lambda_forearm_17 * minus_R_T_upper_arm_xy;
    const ella_real t150 = Lambda_forearm_18 * R_T_upper_arm_xz;
    const ella_real t151 = t123 * minus_R_T_upper_arm_xy + Lambda_forearm_17 * R_T_upper_arm_yy
        + Lambda_forearm_18 * R_T_upper_arm_yz;
    const ella_real t152 = Lambda_forearm_17 * R_T_upper_arm_yz - t123 * R_T_upper_arm_xz
        + Lambda_forearm_18 * R_T_upper_arm_zz;
    const ella_real t153 = Lambda_forearm_17 * R_T_upper_arm_xx - t124 * minus_R_T_upper_arm_xy
        + Lambda_forearm_20 * R_T_upper_arm_xz;
    const ella_real t154 = Lambda_forearm_20 * R_T_upper_arm_yz;
    const ella_real t155 = t149 + t124 * R_T_upper_arm_yy + t154;
    const ella_real t156 = t124 * R_T_upper_arm_yz - Lambda_forearm_17 * R_T_upper_arm_xz
        + Lambda_forearm_20 * R_T_upper_arm_zz;
    const ella_real t157 = Lambda_forearm_18 * R_T_upper_arm_xx - Lambda_forearm_20 * minus_R_T_upper_arm_xy
        + t125 * R_T_upper_arm_xz;
    const ella_real t158 = Lambda_forearm_18 * minus_R_T_upper_arm_xy + Lambda_forearm_20 * R_T_upper_arm_yy
        + t125 * R_T_upper_arm_yz;
    const ella_real t159 = t154 - t150 + t125 * R_T_upper_arm_zz;
    const ella_real Lambda_T_upper_arm_44 = R_T_upper_arm_xx * (t123 * R_T_upper_arm_xx - t149 + t150)
        - minus_R_T_upper_arm_xy * t153 + R_T_upper_arm_xz * t157;
    const ella_real Lambda_T_upper_arm_45 = R_T_upper_arm_xx * t151 - minus_R_T_upper_arm_xy * t155
        + R_T_upper_arm_xz * t158;
    const ella_real Lambda_T_upper_arm_46 = R_T_upper_arm_xx * t152 - minus_R_T_upper_arm_xy * t156
        + R_T_upper_arm_xz * t159;
    const ella_real Lambda_T_upper_arm_55 = minus_R_T_upper_arm_xy * t151 + R_T_upper_arm_yy * t155
        + R_T_upper_arm_yz * t158;
    const ella_real Lambda_T_upper_arm_56 = minus_R_T_upper_arm_xy * t152 + R_T_upper_arm_yy * t156
        + R_T_upper_arm_yz * t159;
    const ella_real Lambda_T_upper_arm_66 = R_T_upper_arm_yz * t156 - R_T_upper_arm_xz * t152
        + R_T_upper_arm_zz * t159;
    const ella_real p_T_upper_arm_1 = R_T_upper_arm_xx * t132 - minus_R_T_upper_arm_xy * t133
        + R_T_upper_arm_xz * t126;
    const ella_real p_T_upper_arm_2 = minus_R_T_upper_arm_xy * t132 + R_T_upper_arm_yy * t133
        + R_T_upper_arm_yz * t126;
    const ella_real p_T_upper_arm_3 = R_T_upper_arm_yz * t133 - R_T_upper_arm_xz * t132 + R_T_upper_arm_zz * t126;
    const ella_real p_T_upper_arm_4 = R_T_upper_arm_xx * t134 - minus_R_T_upper_arm_xy * t135
        + R_T_upper_arm_xz * t136;
    const ella_real p_T_upper_arm_5 = minus_R_T_upper_arm_xy * t134 + R_T_upper_arm_yy * t135
        + R_T_upper_arm_yz * t136;
    const ella_real p_T_upper_arm_6 = R_T_upper_arm_yz * t135 - R_T_upper_arm_xz * t134 + R_T_upper_arm_zz * t136;

    /* upper_arm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real t160 = r_T_upper_arm_z * Lambda_T_upper_arm_45;
    const ella_real t161 = r_T_upper_arm_y * Lambda_T_upper_arm_46;
    const ella_real t162 = r_T_upper_arm_x * Lambda_T_upper_arm_56;
    const ella_real M_loaded_upper_arm_14 = Lambda_T_upper_arm_14 + (t161 - t160);
    const ella_real t163 = Lambda_T_upper_arm_15
        + (r_T_upper_arm_y * Lambda_T_upper_arm_56 - r_T_upper_arm_z * Lambda_T_upper_arm_55);
    const ella_real t164 = Lambda_T_upper_arm_16
        + (r_T_upper_arm_y * Lambda_T_upper_arm_66 - r_T_upper_arm_z * Lambda_T_upper_arm_56);
    const ella_real t165 = Lambda_T_upper_arm_24
        + (r_T_upper_arm_z * Lambda_T_upper_arm_44 - r_T_upper_arm_x * Lambda_T_upper_arm_46);
    const ella_real M_loaded_upper_arm_25 = Lambda_T_upper_arm_25 + (t160 - t162);
    const ella_real t166 = Lambda_T_upper_arm_26
        + (r_T_upper_arm_z * Lambda_T_upper_arm_46 - r_T_upper_arm_x * Lambda_T_upper_arm_66);
    const ella_real t167 = Lambda_T_upper_arm_34
        + (r_T_upper_arm_x * Lambda_T_upper_arm_45 - r_T_upper_arm_y * Lambda_T_upper_arm_44);
    const ella_real t168 = Lambda_T_upper_arm_35
        + (r_T_upper_arm_x * Lambda_T_upper_arm_55 - r_T_upper_arm_y * Lambda_T_upper_arm_45);
    const ella_real M_loaded_upper_arm_36 = Lambda_T_upper_arm_36 + (t162 - t161);
    const ella_real t169 = Lambda_T_upper_arm_11
        - (Lambda_T_upper_arm_15 * r_T_upper_arm_z - Lambda_T_upper_arm_16 * r_T_upper_arm_y);
    const ella_real t170 = Lambda_T_upper_arm_12
        - (Lambda_T_upper_arm_16 * r_T_upper_arm_x - Lambda_T_upper_arm_14 * r_T_upper_arm_z);
    const ella_real t171 = Lambda_T_upper_arm_13
        - (Lambda_T_upper_arm_14 * r_T_upper_arm_y - Lambda_T_upper_arm_15 * r_T_upper_arm_x);
    const ella_real t172 = Lambda_T_upper_arm_22
        - (Lambda_T_upper_arm_26 * r_T_upper_arm_x - Lambda_T_upper_arm_24 * r_T_upper_arm_z);
    const ella_real t173 = Lambda_T_upper_arm_23
        - (Lambda_T_upper_arm_24 * r_T_upper_arm_y - Lambda_T_upper_arm_25 * r_T_upper_arm_x);
    const ella_real t174 = Lambda_T_upper_arm_33
        - (Lambda_T_upper_arm_34 * r_T_upper_arm_y - Lambda_T_upper_arm_35 * r_T_upper_arm_x);
    const ella_real M_loaded_upper_arm_11 = I_upper_arm_xx
        + (t169 + (r_T_upper_arm_y * t164 - r_T_upper_arm_z * t163));
    const ella_real M_loaded_upper_arm_12 = t170
        + (r_T_upper_arm_y * t166 - r_T_upper_arm_z * M_loaded_upper_arm_25) - J_upper_arm_xy;
    const ella_real M_loaded_upper_arm_13 = t171
        + (r_T_upper_arm_y * M_loaded_upper_arm_36 - r_T_upper_arm_z * t168) - J_upper_arm_xz;
    const ella_real M_loaded_upper_arm_15 = t163 - S_upper_arm_z;
    const ella_real M_loaded_upper_arm_16 = S_upper_arm_y + t164;
    const ella_real M_loaded_upper_arm_22 = I_upper_arm_yy
        + (t172 + (r_T_upper_arm_z * t165 - r_T_upper_arm_x * t166));
    const ella_real M_loaded_upper_arm_23 = t173
        + (r_T_upper_arm_z * t167 - r_T_upper_arm_x * M_loaded_upper_arm_36) - J_upper_arm_yz;
    const ella_real M_loaded_upper_arm_24 = S_upper_arm_z + t165;
    const ella_real M_loaded_upper_arm_26 = t166 - S_upper_arm_x;
    const ella_real M_loaded_upper_arm_33 = I_upper_arm_zz
        + (t174 + (r_T_upper_arm_x * t168 - r_T_upper_arm_y * t167));
    const ella_real M_loaded_upper_arm_34 = t167 - S_upper_arm_y;
    const ella_real M_loaded_upper_arm_35 = S_upper_arm_x + t168;
    const ella_real M_loaded_upper_arm_44 = c->links[0].mu + Lambda_T_upper_arm_44;
    const ella_real M_loaded_upper_arm_55 = c->links[0].mu + Lambda_T_upper_arm_55;
    const ella_real M_loaded_upper_arm_66 = c->links[0].mu + Lambda_T_upper_arm_66;
    const ella_real h_loaded_upper_arm_1 = h_V_upper_arm_1
        + (p_T_upper_arm_1 + (r_T_upper_arm_y * p_T_upper_arm_6 - r_T_upper_arm_z * p_T_upper_arm_5));
    const ella_real h_loaded_upper_arm_2 = h_V_upper_arm_2
        + (p_T_upper_arm_2 + (r_T_upper_arm_z * p_T_upper_arm_4 - r_T_upper_arm_x * p_T_upper_arm_6));
    const ella_real h_loaded_upper_arm_3 = h_V_upper_arm_3
        + (p_T_upper_arm_3 + (r_T_upper_arm_x * p_T_upper_arm_5 - r_T_upper_arm_y * p_T_upper_arm_4));
    const ella_real h_loaded_upper_arm_4 = h_V_upper_arm_4 + p_T_upper_arm_4;
    const ella_real h_loaded_upper_arm_5 = h_V_upper_arm_5 + p_T_upper_arm_5;
    const ella_real h_loaded_upper_arm_6 = h_V_upper_arm_6 + p_T_upper_arm_6;
    const ella_real t175 = Lambda_T_upper_arm_12 * J_l_upper_arm_yy
        - Lambda_T_upper_arm_11 * minus_J_l_upper_arm_xy + Lambda_T_upper_arm_13 * J_l_upper_arm_yz;
    const ella_real t176 = Lambda_T_upper_arm_11 * J_l_upper_arm_xz + Lambda_T_upper_arm_12 * J_l_upper_arm_yz
        + Lambda_T_upper_arm_13 * J_l_upper_arm_zz;
    const ella_real t177 = Lambda_T_upper_arm_23 * J_l_upper_arm_yz;
    const ella_real t178 = Lambda_T_upper_arm_22 * J_l_upper_arm_yy
        - Lambda_T_upper_arm_12 * minus_J_l_upper_arm_xy + t177;
    const ella_real t179 = Lambda_T_upper_arm_12 * J_l_upper_arm_xz + Lambda_T_upper_arm_22 * J_l_upper_arm_yz
        + Lambda_T_upper_arm_23 * J_l_upper_arm_zz;
    const ella_real t180 = Lambda_T_upper_arm_23 * J_l_upper_arm_yy
        - Lambda_T_upper_arm_13 * minus_J_l_upper_arm_xy + Lambda_T_upper_arm_33 * J_l_upper_arm_yz;
    const ella_real t181 = Lambda_T_upper_arm_13 * J_l_upper_arm_xz + t177
        + Lambda_T_upper_arm_33 * J_l_upper_arm_zz;
    const ella_real t182 = Lambda_T_upper_arm_24 * J_l_upper_arm_yy
        - Lambda_T_upper_arm_14 * minus_J_l_upper_arm_xy + Lambda_T_upper_arm_34 * J_l_upper_arm_yz;
    const ella_real t183 = Lambda_T_upper_arm_14 * J_l_upper_arm_xz + Lambda_T_upper_arm_24 * J_l_upper_arm_yz
        + Lambda_T_upper_arm_34 * J_l_upper_arm_zz;
    const ella_real t184 = Lambda_T_upper_arm_25 * J_l_upper_arm_yy
        - Lambda_T_upper_arm_15 * minus_J_l_upper_arm_xy + Lambda_T_upper_arm_35 * J_l_upper_arm_yz;
    const ella_real t185 = Lambda_T_upper_arm_15 * J_l_upper_arm_xz + Lambda_T_upper_arm_25 * J_l_upper_arm_yz
        + Lambda_T_upper_arm_35 * J_l_upper_arm_zz;
    const ella_real t186 = Lambda_T_upper_arm_26 * J_l_upper_arm_yy
        - Lambda_T_upper_arm_16 * minus_J_l_upper_arm_xy + Lambda_T_upper_arm_36 * J_l_upper_arm_yz;
    const ella_real t187 = Lambda_T_upper_arm_16 * J_l_upper_arm_xz + Lambda_T_upper_arm_26 * J_l_upper_arm_yz
        + Lambda_T_upper_arm_36 * J_l_upper_arm_zz;
    const ella_real t188 = Lambda_T_upper_arm_44 * REAL(1.4142135623730951);
    const ella_real C_upper_arm_42 = t183 * c->links[0].Psi_c_z2 + Lambda_T_upper_arm_45 * 2;
    const ella_real C_upper_arm_43 = t182 * c->links[0].Psi_c_y3 + Lambda_T_upper_arm_46 * 2;
    const ella_real C_upper_arm_51 = Lambda_T_upper_arm_45 * REAL(1.4142135623730951);
    const ella_real t189 = t185 * c->links[0].Psi_c_z2 + Lambda_T_upper_arm_55 * 2;
    const ella_real t190 = Lambda_T_upper_arm_56 * 2;
    const ella_real C_upper_arm_53 = t184 * c->links[0].Psi_c_y3 + t190;
    const ella_real C_upper_arm_61 = Lambda_T_upper_arm_46 * REAL(1.4142135623730951);
    const ella_real C_upper_arm_62 = t187 * c->links[0].Psi_c_z2 + t190;
    const ella_real t191 = t186 * c->links[0].Psi_c_y3 + Lambda_T_upper_arm_66 * 2;
    const ella_real C_upper_arm_11 = Lambda_T_upper_arm_14 * REAL(1.4142135623730951)
        + (r_T_upper_arm_y * C_upper_arm_61 - r_T_upper_arm_z * C_upper_arm_51);
    const ella_real t192 = Lambda_T_upper_arm_24 * REAL(1.4142135623730951)
        + (r_T_upper_arm_z * t188 - r_T_upper_arm_x * C_upper_arm_61);
    const ella_real t193 = Lambda_T_upper_arm_34 * REAL(1.4142135623730951)
        + (r_T_upper_arm_x * C_upper_arm_51 - r_T_upper_arm_y * t188);
    const ella_real t194 = t176 * c->links[0].Psi_c_z2 + Lambda_T_upper_arm_15 * 2
        + (r_T_upper_arm_y * C_upper_arm_62 - r_T_upper_arm_z * t189);
    const ella_real C_upper_arm_22 = t179 * c->links[0].Psi_c_z2 + Lambda_T_upper_arm_25 * 2
        + (r_T_upper_arm_z * C_upper_arm_42 - r_T_upper_arm_x * C_upper_arm_62);
    const ella_real t195 = t181 * c->links[0].Psi_c_z2 + Lambda_T_upper_arm_35 * 2
        + (r_T_upper_arm_x * t189 - r_T_upper_arm_y * C_upper_arm_42);
    const ella_real t196 = t175 * c->links[0].Psi_c_y3 + Lambda_T_upper_arm_16 * 2
        + (r_T_upper_arm_y * t191 - r_T_upper_arm_z * C_upper_arm_53);
    const ella_real t197 = t178 * c->links[0].Psi_c_y3 + Lambda_T_upper_arm_26 * 2
        + (r_T_upper_arm_z * C_upper_arm_43 - r_T_upper_arm_x * t191);
    const ella_real C_upper_arm_33 = t180 * c->links[0].Psi_c_y3 + Lambda_T_upper_arm_36 * 2
        + (r_T_upper_arm_x * C_upper_arm_53 - r_T_upper_arm_y * C_upper_arm_43);
    const ella_real C_upper_arm_12 = t194 - L_upper_arm_z2;
    const ella_real C_upper_arm_13 = L_upper_arm_y3 + t196;
    const ella_real C_upper_arm_21 = L_upper_arm_z1 + t192;
    const ella_real C_upper_arm_23 = t197 - L_upper_arm_x3;
    const ella_real C_upper_arm_31 = t193 - L_upper_arm_y1;
    const ella_real C_upper_arm_32 = L_upper_arm_x2 + t195;
    const ella_real C_upper_arm_41 = c->links[0].sigma_x1 + t188;
    const ella_real C_upper_arm_52 = c->links[0].sigma_y2 + t189;
    const ella_real C_upper_arm_63 = c->links[0].sigma_z3 + t191;
    const ella_real t198 = (J_l_upper_arm_yy * t178 - minus_J_l_upper_arm_xy * t175 + J_l_upper_arm_yz * t180)
        * c->links[0].Psi_c_y3;
    const ella_real t199 = (J_l_upper_arm_xz * t176 + J_l_upper_arm_yz * t179 + J_l_upper_arm_zz * t181)
        * c->links[0].Psi_c_z2;
    const ella_real t200 = (J_l_upper_arm_yy * t179 - minus_J_l_upper_arm_xy * t176 + J_l_upper_arm_yz * t181)
        * c->links[0].Psi_c_y3;
    const ella_real modal_inertia_upper_arm_12 = C_upper_arm_42 * REAL(1.4142135623730951);
    const ella_real modal_inertia_upper_arm_13 = C_upper_arm_43 * REAL(1.4142135623730951);
    const ella_real modal_inertia_upper_arm_23 = c->links[0].Psi_c_z2 * (t200 + t187 * 2) + C_upper_arm_53 * 2;
    const ella_real modal_inertia_upper_arm_11 = Lambda_T_upper_arm_44 * REAL(2.0000000000000004)
        + work->m_eta[0];
    bad |= (unsigned long)(!(modal_inertia_upper_arm_11 > 0)) << 0;
    const ella_real modal_inertia_upper_arm_22 = c->links[0].Psi_c_z2 * (t199 + t185 * 2) + t189 * 2
        + work->m_eta[1];
    const ella_real modal_inertia_upper_arm_33 = c->links[0].Psi_c_y3 * (t198 + t186 * 2) + t191 * 2
        + work->m_eta[2];
    const ella_real t201 = J_l_upper_arm_yy * p_T_upper_arm_2 - minus_J_l_upper_arm_xy * p_T_upper_arm_1
        + J_l_upper_arm_yz * p_T_upper_arm_3;
    const ella_real t202 = J_l_upper_arm_xz * p_T_upper_arm_1 + J_l_upper_arm_yz * p_T_upper_arm_2
        + J_l_upper_arm_zz * p_T_upper_arm_3;
    const ella_real h_phi_upper_arm_1 = h_eta_upper_arm_1 + work->f_eta[0]
        + p_T_upper_arm_4 * REAL(1.4142135623730951);
    const ella_real h_phi_upper_arm_2 = h_eta_upper_arm_2 + work->f_eta[1]
        + (c->links[0].Psi_c_z2 * t202 + p_T_upper_arm_5 * 2);
    const ella_real h_phi_upper_arm_3 = h_eta_upper_arm_3 + work->f_eta[2]
        + (c->links[0].Psi_c_y3 * t201 + p_T_upper_arm_6 * 2);
    const ella_real modes_inverse_upper_arm_1 = 1 / modal_inertia_upper_arm_11;
    const ella_real modes_L_upper_arm_21 = modal_inertia_upper_arm_12 * modes_inverse_upper_arm_1;
    const ella_real modes_L_upper_arm_31 = modal_inertia_upper_arm_13 * modes_inverse_upper_arm_1;
    const ella_real t203 = modal_inertia_upper_arm_22 - modal_inertia_upper_arm_12 * modes_L_upper_arm_21;
    bad |= (unsigned long)(!(t203 > 0)) << 0;
    const ella_real modes_inverse_upper_arm_2 = 1 / t203;
    const ella_real t204 = modal_inertia_upper_arm_23 - modal_inertia_upper_arm_12 * modes_L_upper_arm_31;
    const ella_real modes_L_upper_arm_32 = t204 * modes_inverse_upper_arm_2;
    const ella_real t205 = modal_inertia_upper_arm_33
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_31 + t204 * modes_L_upper_arm_32);
    bad |= (unsigned long)(!(t205 > 0)) << 0;
    const ella_real modes_inverse_upper_arm_3 = 1 / t205;
    const ella_real t206 = C_upper_arm_12 - modes_L_upper_arm_21 * C_upper_arm_11;
    const ella_real t207 = C_upper_arm_22 - modes_L_upper_arm_21 * C_upper_arm_21;
    const ella_real t208 = C_upper_arm_32 - modes_L_upper_arm_21 * C_upper_arm_31;
    const ella_real t209 = C_upper_arm_42 - modes_L_upper_arm_21 * C_upper_arm_41;
    const ella_real t210 = C_upper_arm_52 - modes_L_upper_arm_21 * C_upper_arm_51;
    const ella_real t211 = C_upper_arm_62 - modes_L_upper_arm_21 * C_upper_arm_61;
    const ella_real t212 = C_upper_arm_13 - modes_L_upper_arm_31 * C_upper_arm_11 - modes_L_upper_arm_32 * t206;
    const ella_real t213 = C_upper_arm_23 - modes_L_upper_arm_31 * C_upper_arm_21 - modes_L_upper_arm_32 * t207;
    const ella_real t214 = C_upper_arm_33 - modes_L_upper_arm_31 * C_upper_arm_31 - modes_L_upper_arm_32 * t208;
    const ella_real t215 = C_upper_arm_43 - modes_L_upper_arm_31 * C_upper_arm_41 - modes_L_upper_arm_32 * t209;
    const ella_real t216 = C_upper_arm_53 - modes_L_upper_arm_31 * C_upper_arm_51 - modes_L_upper_arm_32 * t210;
    const ella_real t217 = C_upper_arm_63 - modes_L_upper_arm_31 * C_upper_arm_61 - modes_L_upper_arm_32 * t211;
    const ella_real t218 = h_phi_upper_arm_2 - modes_L_upper_arm_21 * h_phi_upper_arm_1;
    const ella_real t219 = h_phi_upper_arm_3 - modes_L_upper_arm_31 * h_phi_upper_arm_1
        - modes_L_upper_arm_32 * t218;
    const ella_real modes_W_upper_arm_11 = C_upper_arm_11 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_12 = C_upper_arm_21 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_13 = C_upper_arm_31 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_14 = C_upper_arm_41 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_15 = C_upper_arm_51 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_16 = C_upper_arm_61 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_21 = t206 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_22 = t207 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_23 = t208 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_24 = t209 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_25 = t210 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_26 = t211 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_31 = t212 * modes_inverse_upper_arm_3;
    const ella_real modes_W_upper_arm_32 = t213 * modes_inverse_upper_arm_3;
    const ella_real modes_W_upper_arm_33 = t214 * modes_inverse_upper_arm_3;
    const ella_real modes_W_upper_arm_34 = t215 * modes_inverse_upper_arm_3;
    const ella_real modes_W_upper_arm_35 = t216 * modes_inverse_upper_arm_3;
    const ella_real modes_W_upper_arm_36 = t217 * modes_inverse_upper_arm_3;
    const ella_real modes_w_upper_arm_1 = h_phi_upper_arm_1 * modes_inverse_upper_arm_1;
    const ella_real modes_w_upper_arm_2 = t218 * modes_inverse_upper_arm_2;
    const ella_real modes_w_upper_arm_3 = t219 * modes_inverse_upper_arm_3;
    const ella_real t220 = C_upper_arm_11 * modes_W_upper_arm_11 + t206 * modes_W_upper_arm_21
        + t212 * modes_W_upper_arm_31;
    const ella_real M_i_upper_arm_11 = M_loaded_upper_arm_11 - t220;
    const ella_real t221 = C_upper_arm_11 * modes_W_upper_arm_12 + t206 * modes_W_upper_arm_22
        + t212 * modes_W_upper_arm_32;
    const ella_real M_i_upper_arm_12 = M_loaded_upper_arm_12 - t221;
    const ella_real t222 = C_upper_arm_11 * modes_W_upper_arm_13 + t206 * modes_W_upper_arm_23
        + t212 * modes_W_upper_arm_33;
    const ella_real M_i_upper_arm_13 = M_loaded_upper_arm_13 - t222;
    const ella_real t223 = C_upper_arm_11 * modes_W_upper_arm_14 + t206 * modes_W_upper_arm_24
        + t212 * modes_W_upper_arm_34;
    const ella_real M_i_upper_arm_14 = M_loaded_upper_arm_14 - t223;
    const ella_real t224 = C_upper_arm_11 * modes_W_upper_arm_15 + t206 * modes_W_upper_arm_25
        + t212 * modes_W_upper_arm_35;
    const ella_real M_i_upper_arm_15 = M_loaded_upper_arm_15 - t224;
    const ella_real t225 = C_upper_arm_11 * modes_W_upper_arm_16 + t206 * modes_W_upper_arm_26
        + t212 * modes_W_upper_arm_36;
    const ella_real M_i_upper_arm_16 = M_loaded_upper_arm_16 - t225;
    const ella_real t226 = C_upper_arm_21 * modes_W_upper_arm_12 + t207 * modes_W_upper_arm_22
        + t213 * modes_W_upper_arm_32;
    const ella_real M_i_upper_arm_22 = M_loaded_upper_arm_22 - t226;
    const ella_real t227 = C_upper_arm_21 * modes_W_upper_arm_13 + t207 * modes_W_upper_arm_23
        + t213 * modes_W_upper_arm_33;
    const ella_real M_i_upper_arm_23 = M_loaded_upper_arm_23 - t227;
    const ella_real t228 = C_upper_arm_21 * modes_W_upper_arm_14 + t207 * modes_W_upper_arm_24
        + t213 * modes_W_upper_arm_34;
    const ella_real M_i_upper_arm_24 = M_loaded_upper_arm_24 - t228;
    const ella_real t229 = C_upper_arm_21 * modes_W_upper_arm_15 + t207 * modes_W_upper_arm_25
        + t213 * modes_W_upper_arm_35;
    const ella_real M_i_upper_arm_25 = M_loaded_upper_arm_25 - t229;
    const ella_real t230 = C_upper_arm_21 * modes_W_upper_arm_16 + t207 * modes_W_upper_arm_26
        + t213 * modes_W_upper_arm_36;
    const ella_real M_i_upper_arm_26 = M_loaded_upper_arm_26 - t230;
    const ella_real t231 = C_upper_arm_31 * modes_W_upper_arm_13 + t208 * modes_W_upper_arm_23
        + t214 * modes_W_upper_arm_33;
    const ella_real M_i_upper_arm_33 = M_loaded_upper_arm_33 - t231;
    const ella_real t232 = C_upper_arm_31 * modes_W_upper_arm_14 + t208 * modes_W_upper_arm_24
        + t214 * modes_W_upper_arm_34;
    const ella_real M_i_upper_arm_34 = M_loaded_upper_arm_34 - t232;
    const ella_real t233 = C_upper_arm_31 * modes_W_upper_arm_15 + t208 * modes_W_upper_arm_25
        + t214 * modes_W_upper_arm_35;
    const ella_real M_i_upper_arm_35 = M_loaded_upper_arm_35 - t233;
    const ella_real t234 = C_upper_arm_31 * modes_W_upper_arm_16 + t208 * modes_W_upper_arm_26
        + t214 * modes_W_upper_arm_36;
    const ella_real M_i_upper_arm_36 = M_loaded_upper_arm_36 - t234;
    const ella_real t235 = C_upper_arm_41 * modes_W_upper_arm_14 + t209 * modes_W_upper_arm_24
        + t215 * modes_W_upper_arm_34;
    const ella_real M_i_upper_arm_44 = M_loaded_upper_arm_44 - t235;
    const ella_real t236 = C_upper_arm_41 * modes_W_upper_arm_15 + t209 * modes_W_upper_arm_25
        + t215 * modes_W_upper_arm_35;
    const ella_real M_i_upper_arm_45 = Lambda_T_upper_arm_45 - t236;
    const ella_real t237 = C_upper_arm_41 * modes_W_upper_arm_16 + t209 * modes_W_upper_arm_26
        + t215 * modes_W_upper_arm_36;
    const ella_real M_i_upper_arm_46 = Lambda_T_upper_arm_46 - t237;
    const ella_real t238 = C_upper_arm_51 * modes_W_upper_arm_15 + t210 * modes_W_upper_arm_25
        + t216 * modes_W_upper_arm_35;
    const ella_real M_i_upper_arm_55 = M_loaded_upper_arm_55 - t238;
    const ella_real t239 = C_upper_arm_51 * modes_W_upper_arm_16 + t210 * modes_W_upper_arm_26
        + t216 * modes_W_upper_arm_36;
    const ella_real M_i_upper_arm_56 = Lambda_T_upper_arm_56 - t239;
    const ella_real t240 = C_upper_arm_61 * modes_W_upper_arm_16 + t211 * modes_W_upper_arm_26
        + t217 * modes_W_upper_arm_36;
    const ella_real M_i_upper_arm_66 = M_loaded_upper_arm_66 - t240;
    const ella_real t241 = modes_W_upper_arm_11 * h_phi_upper_arm_1 + modes_W_upper_arm_21 * t218
        + modes_W_upper_arm_31 * t219;
    const ella_real t242 = modes_W_upper_arm_12 * h_phi_upper_arm_1 + modes_W_upper_arm_22 * t218
        + modes_W_upper_arm_32 * t219;
    const ella_real t243 = modes_W_upper_arm_13 * h_phi_upper_arm_1 + modes_W_upper_arm_23 * t218
        + modes_W_upper_arm_33 * t219;
    const ella_real t244 = modes_W_upper_arm_14 * h_phi_upper_arm_1 + modes_W_upper_arm_24 * t218
        + modes_W_upper_arm_34 * t219;
    const ella_real t245 = modes_W_upper_arm_15 * h_phi_upper_arm_1 + modes_W_upper_arm_25 * t218
        + modes_W_upper_arm_35 * t219;
    const ella_real t246 = modes_W_upper_arm_16 * h_phi_upper_arm_1 + modes_W_upper_arm_26 * t218
        + modes_W_upper_arm_36 * t219;
    const ella_real h_i_upper_arm_1 = h_loaded_upper_arm_1 - t241;
    const ella_real h_i_upper_arm_2 = h_loaded_upper_arm_2 - t242;
    const ella_real h_i_upper_arm_3 = h_loaded_upper_arm_3 - t243;
    const ella_real h_i_upper_arm_4 = h_loaded_upper_arm_4 - t244;
    const ella_real h_i_upper_arm_5 = h_loaded_upper_arm_5 - t245;
    const ella_real h_i_upper_arm_6 = h_loaded_upper_arm_6 - t246;

    /* upper_arm, joint: its accelerations eliminated from its rows (43) */
    const ella_real U_upper_arm_11 = M_i_upper_arm_11 * R_rel_upper_arm_yx
        + M_i_upper_arm_12 * R_rel_upper_arm_yy;
    const ella_real U_upper_arm_21 = M_i_upper_arm_12 * R_rel_upper_arm_yx
        + M_i_upper_arm_22 * R_rel_upper_arm_yy;
    const ella_real U_upper_arm_31 = M_i_upper_arm_13 * R_rel_upper_arm_yx
        + M_i_upper_arm_23 * R_rel_upper_arm_yy;
    const ella_real U_upper_arm_41 = M_i_upper_arm_14 * R_rel_upper_arm_yx
        + M_i_upper_arm_24 * R_rel_upper_arm_yy;
    const ella_real U_upper_arm_51 = M_i_upper_arm_15 * R_rel_upper_arm_yx
        + M_i_upper_arm_25 * R_rel_upper_arm_yy;
    const ella_real U_upper_arm_61 = M_i_upper_arm_16 * R_rel_upper_arm_yx
        + M_i_upper_arm_26 * R_rel_upper_arm_yy;
    const ella_real bias_upper_arm_1 = h_i_upper_arm_1
        + (M_i_upper_arm_11 * beta_omega_upper_arm_x - M_i_upper_arm_12 * minus_beta_omega_upper_arm_y);
    const ella_real bias_upper_arm_2 = h_i_upper_arm_2
        + (M_i_upper_arm_12 * beta_omega_upper_arm_x - M_i_upper_arm_22 * minus_beta_omega_upper_arm_y);
    const ella_real bias_upper_arm_3 = h_i_upper_arm_3
        + (M_i_upper_arm_13 * beta_omega_upper_arm_x - M_i_upper_arm_23 * minus_beta_omega_upper_arm_y);
    const ella_real bias_upper_arm_4 = h_i_upper_arm_4
        + (M_i_upper_arm_14 * beta_omega_upper_arm_x - M_i_upper_arm_24 * minus_beta_omega_upper_arm_y);
    const ella_real bias_upper_arm_5 = h_i_upper_arm_5
        + (M_i_upper_arm_15 * beta_omega_upper_arm_x - M_i_upper_arm_25 * minus_beta_omega_upper_arm_y);
    const ella_real bias_upper_arm_6 = h_i_upper_arm_6
        + (M_i_upper_arm_16 * beta_omega_upper_arm_x - M_i_upper_arm_26 * minus_beta_omega_upper_arm_y);
    const ella_real joint_inertia_upper_arm_11 = R_rel_upper_arm_yx * U_upper_arm_11
        + R_rel_upper_arm_yy * U_upper_arm_21;
    const ella_real t247 = t110 * (M_i_upper_arm_11 + M_i_upper_arm_22 + M_i_upper_arm_33);
    bad |= (unsigned long)(!(joint_inertia_upper_arm_11 - t247 > 0)) << 0;
    const ella_real joint_inverse_upper_arm_1 = 1 / joint_inertia_upper_arm_11;
    const ella_real joint_L_upper_arm_21 = U_upper_arm_31 * joint_inverse_upper_arm_1;
    const ella_real t248 = M_i_upper_arm_33 - U_upper_arm_31 * joint_L_upper_arm_21;
    bad |= (unsigned long)(!(t248 - t247 > 0)) << 0;
    const ella_real joint_inverse_upper_arm_2 = 1 / t248;
    const ella_real t249 = M_i_upper_arm_13 - joint_L_upper_arm_21 * U_upper_arm_11;
    const ella_real t250 = M_i_upper_arm_23 - joint_L_upper_arm_21 * U_upper_arm_21;
    const ella_real t251 = M_i_upper_arm_34 - joint_L_upper_arm_21 * U_upper_arm_41;
    const ella_real t252 = M_i_upper_arm_35 - joint_L_upper_arm_21 * U_upper_arm_51;
    const ella_real t253 = M_i_upper_arm_36 - joint_L_upper_arm_21 * U_upper_arm_61;
    const ella_real joint_W_upper_arm_14 = U_upper_arm_41 * joint_inverse_upper_arm_1;
    const ella_real joint_W_upper_arm_15 = U_upper_arm_51 * joint_inverse_upper_arm_1;
    const ella_real joint_W_upper_arm_16 = U_upper_arm_61 * joint_inverse_upper_arm_1;
    const ella_real joint_W_upper_arm_24 = t251 * joint_inverse_upper_arm_2;
    const ella_real joint_W_upper_arm_25 = t252 * joint_inverse_upper_arm_2;
    const ella_real joint_W_upper_arm_26 = t253 * joint_inverse_upper_arm_2;
    const ella_real t254 = input->tau[0]
        - (R_rel_upper_arm_yx * bias_upper_arm_1 + R_rel_upper_arm_yy * bias_upper_arm_2);
    const ella_real t255 = input->tau[1] - bias_upper_arm_3 - joint_L_upper_arm_21 * t254;
    const ella_real joint_w_upper_arm_1 = t254 * joint_inverse_upper_arm_1;
    const ella_real joint_w_upper_arm_2 = t255 * joint_inverse_upper_arm_2;
    const ella_real Lambda_i_upper_arm_14 = M_i_upper_arm_14
        - (U_upper_arm_11 * joint_W_upper_arm_14 + t249 * joint_W_upper_arm_24);
    const ella_real Lambda_i_upper_arm_15 = M_i_upper_arm_15
        - (U_upper_arm_11 * joint_W_upper_arm_15 + t249 * joint_W_upper_arm_25);
    const ella_real Lambda_i_upper_arm_16 = M_i_upper_arm_16
        - (U_upper_arm_11 * joint_W_upper_arm_16 + t249 * joint_W_upper_arm_26);
    const ella_real Lambda_i_upper_arm_24 = M_i_upper_arm_24
        - (U_upper_arm_21 * joint_W_upper_arm_14 + t250 * joint_W_upper_arm_24);
    const ella_real Lambda_i_upper_arm_25 = M_i_upper_arm_25
        - (U_upper_arm_21 * joint_W_upper_arm_15 + t250 * joint_W_upper_arm_25);
    const ella_real Lambda_i_upper_arm_26 = M_i_upper_arm_26
        - (U_upper_arm_21 * joint_W_upper_arm_16 + t250 * joint_W_upper_arm_26);
    const ella_real Lambda_i_upper_arm_34 = M_i_upper_arm_34 - (U_upper_arm_31 * joint_W_upper_arm_14 + t251);
    const ella_real Lambda_i_upper_arm_35 = M_i_upper_arm_35 - (U_upper_arm_31 * joint_W_upper_arm_15 + t252);
    const ella_real Lambda_i_upper_arm_36 = M_i_upper_arm_36 - (U_upper_arm_31 * joint_W_upper_arm_16 + t253);
    const ella_real Lambda_i_upper_arm_44 = M_i_upper_arm_44
        - (U_upper_arm_41 * joint_W_upper_arm_14 + t251 * joint_W_upper_arm_24);
    const ella_real Lambda_i_upper_arm_45 = M_i_upper_arm_45
        - (U_upper_arm_41 * joint_W_upper_arm_15 + t251 * joint_W_upper_arm_25);
    const ella_real Lambda_i_upper_arm_46 = M_i_upper_arm_46
        - (U_upper_arm_41 * joint_W_upper_arm_16 + t251 * joint_W_upper_arm_26);
    const ella_real Lambda_i_upper_arm_55 = M_i_upper_arm_55
        - (U_upper_arm_51 * joint_W_upper_arm_15 + t252 * joint_W_upper_arm_25);
    const ella_real Lambda_i_upper_arm_56 = M_i_upper_arm_56
        - (U_upper_arm_51 * joint_W_upper_arm_16 + t252 * joint_W_upper_arm_26);
    const ella_real Lambda_i_upper_arm_66 = M_i_upper_arm_66
        - (U_upper_arm_61 * joint_W_upper_arm_16 + t253 * joint_W_upper_arm_26);
    const ella_real p_i_upper_arm_1 = bias_upper_arm_1
        + (U_upper_arm_11 * joint_w_upper_arm_1 + t249 * joint_w_upper_arm_2);
    const ella_real p_i_upper_arm_2 = bias_upper_arm_2
        + (U_upper_arm_21 * joint_w_upper_arm_1 + t250 * joint_w_upper_arm_2);
    const ella_real p_i_upper_arm_3 = bias_upper_arm_3 + (U_upper_arm_31 * joint_w_upper_arm_1 + t255);
    const ella_real p_i_upper_arm_4 = bias_upper_arm_4
        + (U_upper_arm_41 * joint_w_upper_arm_1 + t251 * joint_w_upper_arm_2);
    const ella_real p_i_upper_arm_5 = bias_upper_arm_5
        + (U_upper_arm_51 * joint_w_upper_arm_1 + t252 * joint_w_upper_arm_2);
    const ella_real p_i_upper_arm_6 = bias_upper_arm_6
        + (U_upper_arm_61 * joint_w_upper_arm_1 + t253 * joint_w_upper_arm_2);

    /* upper_arm, joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const ella_real carried_upper_arm_4 = minus_R_rel_upper_arm_zx * c->gravity[2]
        - (R_rel_upper_arm_xx * c->gravity[0] + R_rel_upper_arm_yx * c->gravity[1]);
    const ella_real carried_upper_arm_5 = minus_R_rel_upper_arm_xy * c->gravity[0]
        - R_rel_upper_arm_yy * c->gravity[1] - R_rel_upper_arm_zy * c->gravity[2];
    const ella_real minus_carried_upper_arm_6 = R_rel_upper_arm_xz * c->gravity[0]
        + R_rel_upper_arm_zz * c->gravity[2];
    const ella_real t256 = joint_W_upper_arm_14 * carried_upper_arm_4
        + joint_W_upper_arm_15 * carried_upper_arm_5 - joint_W_upper_arm_16 * minus_carried_upper_arm_6;
    const ella_real t257 = joint_W_upper_arm_24 * carried_upper_arm_4
        + joint_W_upper_arm_25 * carried_upper_arm_5 - joint_W_upper_arm_26 * minus_carried_upper_arm_6;
    const ella_real qddot_upper_arm_2 = joint_w_upper_arm_2 - t257;
    output->vdot[1] = qddot_upper_arm_2;
    const ella_real qddot_upper_arm_1 = joint_w_upper_arm_1 - t256 - joint_L_upper_arm_21 * qddot_upper_arm_2;
    output->vdot[0] = qddot_upper_arm_1;
    const ella_real t258 = Lambda_i_upper_arm_14 * carried_upper_arm_4
        + Lambda_i_upper_arm_15 * carried_upper_arm_5 - Lambda_i_upper_arm_16 * minus_carried_upper_arm_6;
    const ella_real t259 = Lambda_i_upper_arm_24 * carried_upper_arm_4
        + Lambda_i_upper_arm_25 * carried_upper_arm_5 - Lambda_i_upper_arm_26 * minus_carried_upper_arm_6;
    const ella_real t260 = Lambda_i_upper_arm_34 * carried_upper_arm_4
        + Lambda_i_upper_arm_35 * carried_upper_arm_5 - Lambda_i_upper_arm_36 * minus_carried_upper_arm_6;
    const ella_real t261 = Lambda_i_upper_arm_44 * carried_upper_arm_4
        + Lambda_i_upper_arm_45 * carried_upper_arm_5 - Lambda_i_upper_arm_46 * minus_carried_upper_arm_6;
    const ella_real t262 = Lambda_i_upper_arm_45 * carried_upper_arm_4
        + Lambda_i_upper_arm_55 * carried_upper_arm_5 - Lambda_i_upper_arm_56 * minus_carried_upper_arm_6;
    const ella_real t263 = Lambda_i_upper_arm_46 * carried_upper_arm_4
        + Lambda_i_upper_arm_56 * carried_upper_arm_5 - Lambda_i_upper_arm_66 * minus_carried_upper_arm_6;
    const ella_real wrench_upper_arm_1 = t258 + p_i_upper_arm_1;
    output->wrench[0][0] = wrench_upper_arm_1;
    const ella_real wrench_upper_arm_2 = t259 + p_i_upper_arm_2;
    output->wrench[0][1] = wrench_upper_arm_2;
    const ella_real wrench_upper_arm_3 = t260 + p_i_upper_arm_3;
    output->wrench[0][2] = wrench_upper_arm_3;
    const ella_real wrench_upper_arm_4 = t261 + p_i_upper_arm_4;
    output->wrench[0][3] = wrench_upper_arm_4;
    const ella_real wrench_upper_arm_5 = t262 + p_i_upper_arm_5;
    output->wrench[0][4] = wrench_upper_arm_5;
    const ella_real wrench_upper_arm_6 = t263 + p_i_upper_arm_6;
    output->wrench[0][5] = wrench_upper_arm_6;

    /* upper_arm, link: acceleration of F_i, modal accelerations (83) */
    const ella_real alpha_upper_arm_1 = R_rel_upper_arm_yx * qddot_upper_arm_1 + beta_omega_upper_arm_x;
    const ella_real alpha_upper_arm_2 = R_rel_upper_arm_yy * qddot_upper_arm_1 - minus_beta_omega_upper_arm_y;
    const ella_real t264 = modes_W_upper_arm_11 * alpha_upper_arm_1 + modes_W_upper_arm_12 * alpha_upper_arm_2
        + modes_W_upper_arm_13 * qddot_upper_arm_2;
    const ella_real t265 = t264 + modes_W_upper_arm_14 * carried_upper_arm_4
        + modes_W_upper_arm_15 * carried_upper_arm_5 - modes_W_upper_arm_16 * minus_carried_upper_arm_6;
    const ella_real t266 = modes_W_upper_arm_21 * alpha_upper_arm_1 + modes_W_upper_arm_22 * alpha_upper_arm_2
        + modes_W_upper_arm_23 * qddot_upper_arm_2;
    const ella_real t267 = t266 + modes_W_upper_arm_24 * carried_upper_arm_4
        + modes_W_upper_arm_25 * carried_upper_arm_5 - modes_W_upper_arm_26 * minus_carried_upper_arm_6;
    const ella_real t268 = modes_W_upper_arm_31 * alpha_upper_arm_1 + modes_W_upper_arm_32 * alpha_upper_arm_2
        + modes_W_upper_arm_33 * qddot_upper_arm_2;
    const ella_real t269 = t268 + modes_W_upper_arm_34 * carried_upper_arm_4
        + modes_W_upper_arm_35 * carried_upper_arm_5 - modes_W_upper_arm_36 * minus_carried_upper_arm_6;
    const ella_real minus_etaddot_upper_arm_3 = modes_w_upper_arm_3 + t269;
    output->vdot[5] = -minus_etaddot_upper_arm_3;
    const ella_real minus_etaddot_upper_arm_2 = modes_w_upper_arm_2 + t267
        - modes_L_upper_arm_32 * minus_etaddot_upper_arm_3;
    output->vdot[4] = -minus_etaddot_upper_arm_2;
    const ella_real minus_etaddot_upper_arm_1 = modes_w_upper_arm_1 + t265
        - modes_L_upper_arm_21 * minus_etaddot_upper_arm_2 - modes_L_upper_arm_31 * minus_etaddot_upper_arm_3;
    output->vdot[3] = -minus_etaddot_upper_arm_1;
    const ella_real t270 = -minus_etaddot_upper_arm_1;
    output->vdot[3] = t270;
    const ella_real t271 = -minus_etaddot_upper_arm_2;
    output->vdot[4] = t271;
    const ella_real t272 = -minus_etaddot_upper_arm_3;
    output->vdot[5] = t272;

    /* upper_arm, tip: acceleration of the tip section (accconst1b) */
    const ella_real t273 = c->links[0].Psi_c_y3 * minus_etaddot_upper_arm_3;
    const ella_real t274 = c->links[0].Psi_c_z2 * minus_etaddot_upper_arm_2;
    const ella_real t275 = carried_upper_arm_4
        + (alpha_upper_arm_2 * r_T_upper_arm_z - qddot_upper_arm_2 * r_T_upper_arm_y);
    const ella_real t276 = carried_upper_arm_5
        + (qddot_upper_arm_2 * r_T_upper_arm_x - alpha_upper_arm_1 * r_T_upper_arm_z);
    const ella_real t277 = alpha_upper_arm_1 * r_T_upper_arm_y - alpha_upper_arm_2 * r_T_upper_arm_x
        - minus_carried_upper_arm_6;
    const ella_real t278 = alpha_upper_arm_1 + (minus_J_l_upper_arm_xy * t273 - J_l_upper_arm_xz * t274);
    const ella_real t279 = alpha_upper_arm_2 - (J_l_upper_arm_yy * t273 + J_l_upper_arm_yz * t274);
    const ella_real t280 = qddot_upper_arm_2 - (J_l_upper_arm_yz * t273 + J_l_upper_arm_zz * t274);
    const ella_real t281 = t275 - minus_etaddot_upper_arm_1 * REAL(1.4142135623730951);
    const ella_real t282 = t276 - minus_etaddot_upper_arm_2 * 2;
    const ella_real t283 = t277 - minus_etaddot_upper_arm_3 * 2;
    const ella_real alpha_T_upper_arm_1 = R_T_upper_arm_xx * t278 + minus_R_T_upper_arm_xy * t279
        - R_T_upper_arm_xz * t280 + b_omega_upper_arm_x;
    const ella_real alpha_T_upper_arm_2 = R_T_upper_arm_yy * t279 - minus_R_T_upper_arm_xy * t278
        + R_T_upper_arm_yz * t280 + b_omega_upper_arm_y;
    const ella_real alpha_T_upper_arm_3 = R_T_upper_arm_xz * t278 + R_T_upper_arm_yz * t279
        + R_T_upper_arm_zz * t280 + b_omega_upper_arm_z;
    const ella_real alpha_T_upper_arm_4 = R_T_upper_arm_xx * t281 + minus_R_T_upper_arm_xy * t282
        - R_T_upper_arm_xz * t283 + b_v_upper_arm_x;
    const ella_real alpha_T_upper_arm_5 = R_T_upper_arm_yy * t282 - minus_R_T_upper_arm_xy * t281
        + R_T_upper_arm_yz * t283 + b_v_upper_arm_y;
    const ella_real alpha_T_upper_arm_6 = R_T_upper_arm_xz * t281 + R_T_upper_arm_yz * t282
        + R_T_upper_arm_zz * t283 + b_v_upper_arm_z;

    /* forearm, joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const ella_real carried_forearm_1 = R_rel_forearm_xx * alpha_T_upper_arm_1
        + minus_R_rel_forearm_xy * alpha_T_upper_arm_2;
    const ella_real carried_forearm_2 = R_rel_forearm_xx * alpha_T_upper_arm_2
        - minus_R_rel_forearm_xy * alpha_T_upper_arm_1;
    const ella_real carried_forearm_4 = R_rel_forearm_xx * alpha_T_upper_arm_4
        + minus_R_rel_forearm_xy * alpha_T_upper_arm_5;
    const ella_real carried_forearm_5 = R_rel_forearm_xx * alpha_T_upper_arm_5
        - minus_R_rel_forearm_xy * alpha_T_upper_arm_4;
    const ella_real t284 = joint_W_forearm_11 * carried_forearm_1 + joint_W_forearm_12 * carried_forearm_2
        + alpha_T_upper_arm_3;
    const ella_real t285 = t284 + joint_W_forearm_14 * carried_forearm_4 + joint_W_forearm_15 * carried_forearm_5
        + joint_W_forearm_16 * alpha_T_upper_arm_6;
    const ella_real qddot_forearm_1 = joint_w_forearm_1 - t285;
    output->vdot[2] = qddot_forearm_1;
    const ella_real t286 = Lambda_i_forearm_11 * carried_forearm_1 + Lambda_i_forearm_12 * carried_forearm_2
        + Lambda_i_forearm_14 * carried_forearm_4;
    const ella_real t287 = Lambda_i_forearm_12 * carried_forearm_1 + Lambda_i_forearm_22 * carried_forearm_2
        + Lambda_i_forearm_24 * carried_forearm_4;
    const ella_real t288 = Lambda_i_forearm_14 * carried_forearm_1 + Lambda_i_forearm_24 * carried_forearm_2
        + Lambda_i_forearm_44 * carried_forearm_4;
    const ella_real t289 = Lambda_i_forearm_15 * carried_forearm_1 + Lambda_i_forearm_25 * carried_forearm_2
        + Lambda_i_forearm_45 * carried_forearm_4;
    const ella_real t290 = Lambda_i_forearm_16 * carried_forearm_1 + Lambda_i_forearm_26 * carried_forearm_2
        + Lambda_i_forearm_46 * carried_forearm_4;
    const ella_real wrench_forearm_1 = t286 + Lambda_i_forearm_15 * carried_forearm_5
        + Lambda_i_forearm_16 * alpha_T_upper_arm_6 + p_i_forearm_1;
    output->wrench[1][0] = wrench_forearm_1;
    const ella_real wrench_forearm_2 = t287 + Lambda_i_forearm_25 * carried_forearm_5
        + Lambda_i_forearm_26 * alpha_T_upper_arm_6 + p_i_forearm_2;
    output->wrench[1][1] = wrench_forearm_2;
    const ella_real wrench_forearm_4 = t288 + Lambda_i_forearm_45 * carried_forearm_5
        + Lambda_i_forearm_46 * alpha_T_upper_arm_6 + p_i_forearm_4;
    output->wrench[1][3] = wrench_forearm_4;
    const ella_real wrench_forearm_5 = t289 + Lambda_i_forearm_55 * carried_forearm_5
        + Lambda_i_forearm_56 * alpha_T_upper_arm_6 + p_i_forearm_5;
    output->wrench[1][4] = wrench_forearm_5;
    const ella_real wrench_forearm_6 = t290 + Lambda_i_forearm_56 * carried_forearm_5
        + Lambda_i_forearm_66 * alpha_T_upper_arm_6 + p_i_forearm_6;
    output->wrench[1][5] = wrench_forearm_6;

    /* forearm, link: acceleration of F_i, modal accelerations (83) */
    const ella_real alpha_forearm_3 = alpha_T_upper_arm_3 + qddot_forearm_1;
    const ella_real alpha_forearm_1 = carried_forearm_1 + beta_omega_forearm_x;
    const ella_real alpha_forearm_2 = carried_forearm_2 - minus_beta_omega_forearm_y;
    const ella_real alpha_forearm_4 = carried_forearm_4 + beta_v_forearm_x;
    const ella_real alpha_forearm_5 = carried_forearm_5 - minus_beta_v_forearm_y;
    const ella_real t291 = modes_W_forearm_11 * alpha_forearm_1 + modes_W_forearm_12 * alpha_forearm_2
        + modes_W_forearm_13 * alpha_forearm_3;
    const ella_real t292 = t291 + modes_W_forearm_14 * alpha_forearm_4 + modes_W_forearm_15 * alpha_forearm_5
        + modes_W_forearm_16 * alpha_T_upper_arm_6;
    const ella_real t293 = modes_W_forearm_21 * alpha_forearm_1 + modes_W_forearm_22 * alpha_forearm_2
        + modes_W_forearm_23 * alpha_forearm_3;
    const ella_real t294 = t293 + modes_W_forearm_24 * alpha_forearm_4 + modes_W_forearm_25 * alpha_forearm_5
        + modes_W_forearm_26 * alpha_T_upper_arm_6;
    const ella_real t295 = modes_W_forearm_31 * alpha_forearm_1 + modes_W_forearm_32 * alpha_forearm_2
        + modes_W_forearm_33 * alpha_forearm_3;
    const ella_real t296 = t295 + modes_W_forearm_34 * alpha_forearm_4 + modes_W_forearm_35 * alpha_forearm_5
        + modes_W_forearm_36 * alpha_T_upper_arm_6;
    const ella_real minus_etaddot_forearm_3 = modes_w_forearm_3 + t296;
    output->vdot[8] = -minus_etaddot_forearm_3;
    const ella_real minus_etaddot_forearm_2 = modes_w_forearm_2 + t294
        - modes_L_forearm_32 * minus_etaddot_forearm_3;
    output->vdot[7] = -minus_etaddot_forearm_2;
    const ella_real minus_etaddot_forearm_1 = modes_w_forearm_1 + t292
        - modes_L_forearm_21 * minus_etaddot_forearm_2 - modes_L_forearm_31 * minus_etaddot_forearm_3;
    output->vdot[6] = -minus_etaddot_forearm_1;
    const ella_real t297 = -minus_etaddot_forearm_1;
    output->vdot[6] = t297;
    const ella_real t298 = -minus_etaddot_forearm_2;
    output->vdot[7] = t298;
    const ella_real t299 = -minus_etaddot_forearm_3;
    output->vdot[8] = t299;

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

    /* outputs */
    output->wrench[1][2] = input->tau[2];

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
