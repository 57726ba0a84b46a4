/* six_link_dynamics.c: forward dynamics of the joint form by block elimination, tip to base. */
#include "six_link_links.h"

/* The whole chain in one piece: outward to the tip, inward with the eliminations, outward with the results. */
six_link_status six_link_dynamics(const six_link_constants *c, const six_link_state *state, const six_link_input *input,
    six_link_work *work, six_link_output *output)
{
    unsigned long bad = 0; /* bit i: the joint or a mode of link i cannot be solved for */
    int link;

    /* shoulder, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_shoulder_xx = six_link_cos(state->q[0]);
    const six_link_real minus_R_rel_shoulder_xy = six_link_sin(state->q[0]);

    /* shoulder, Omega: centripetal operator */
    const six_link_real minus_Omega_shoulder_xx = state->v[0] * state->v[0];

    /* shoulder, H_star: gyroscopic wrench and weight (29) */
    const six_link_real minus_H_star_shoulder_4 = minus_Omega_shoulder_xx * c->links[0].S_0_x;

    /* shoulder, v_T: velocity of the tip point (46) */
    const six_link_real v_T_shoulder_y = c->links[0].length * state->v[0];

    /* shoulder, a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real minus_a_T_shoulder_x = state->v[0] * v_T_shoulder_y;

    /* shoulder, h_T_tau: moment that the bodies' velocities and weight need */
    const six_link_real h_T_tau_shoulder_x = state->v[0] * (c->links[0].J_T_yz * state->v[0]);
    const six_link_real minus_h_T_tau_shoulder_y = c->links[0].S_T_z * minus_a_T_shoulder_x
        + state->v[0] * (c->links[0].J_T_xz * state->v[0]);
    const six_link_real h_T_tau_shoulder_z = c->links[0].S_T_y * minus_a_T_shoulder_x;

    /* shoulder, h_T_F: force that the bodies' velocities and weight need */
    const six_link_real minus_h_T_F_shoulder_x = minus_a_T_shoulder_x * c->links[0].body0_mass
        + state->v[0] * (c->links[0].S_T_x * state->v[0]);
    const six_link_real minus_h_T_F_shoulder_y = state->v[0] * (c->links[0].S_T_y * state->v[0]);

    /* upper_arm, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_upper_arm_xx = six_link_cos(state->q[1]);
    const six_link_real R_rel_upper_arm_xz = six_link_sin(state->q[1]);

    /* upper_arm, omega_R: angular velocity of the parent's tip */
    const six_link_real minus_omega_R_upper_arm_x = R_rel_upper_arm_xz * state->v[0];
    const six_link_real omega_R_upper_arm_z = R_rel_upper_arm_xx * state->v[0];

    /* upper_arm, v_R: velocity of the joint point */
    const six_link_real t1 = c->links[1].mount_xyz_y * state->v[0];
    const six_link_real minus_v_R_upper_arm_x = R_rel_upper_arm_xx * t1;
    const six_link_real v_R_upper_arm_y = v_T_shoulder_y + c->links[1].mount_xyz_x * state->v[0];
    const six_link_real minus_v_R_upper_arm_z = R_rel_upper_arm_xz * t1;

    /* upper_arm, beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_omega_upper_arm_x = omega_R_upper_arm_z * state->v[1];
    const six_link_real minus_beta_omega_upper_arm_z = minus_omega_R_upper_arm_x * state->v[1];

    /* upper_arm, beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_minus_beta_v_upper_arm_x = state->v[1] * minus_v_R_upper_arm_z;
    const six_link_real minus_beta_v_upper_arm_z = state->v[1] * minus_v_R_upper_arm_x;

    /* upper_arm, S: first moment */
    const six_link_real S_upper_arm_y = state->q[6] * c->links[1].sigma_y1;
    const six_link_real S_upper_arm_z = state->q[7] * c->links[1].sigma_z2;

    /* upper_arm, Sdot: rate of the first moment */
    const six_link_real Sdot_upper_arm_y = state->v[6] * c->links[1].sigma_y1;
    const six_link_real Sdot_upper_arm_z = state->v[7] * c->links[1].sigma_z2;

    /* upper_arm, L: first moment weighted by each mode shape (85) */
    const six_link_real L_upper_arm_y1 = c->links[1].M_Wphi_11 * state->q[6];
    const six_link_real L_upper_arm_y2 = state->q[6] * c->links[1].mu;
    const six_link_real L_upper_arm_z1 = state->q[7] * c->links[1].mu;
    const six_link_real L_upper_arm_z2 = c->links[1].M_Wphi_22 * state->q[7];

    /* upper_arm, Ldot: rate of L */
    const six_link_real Ldot_upper_arm_y2 = state->v[6] * c->links[1].mu;
    const six_link_real Ldot_upper_arm_z1 = state->v[7] * c->links[1].mu;

    /* upper_arm, J: second moment */
    const six_link_real J_upper_arm_xy = c->links[1].chi_1 * state->q[6];
    const six_link_real J_upper_arm_xz = c->links[1].chi_2 * state->q[7];
    const six_link_real J_upper_arm_yy = L_upper_arm_y1 * state->q[6];
    const six_link_real J_upper_arm_yz = L_upper_arm_z1 * state->q[6];
    const six_link_real J_upper_arm_zz = L_upper_arm_z2 * state->q[7];

    /* upper_arm, I: inertia about the origin, deformed */
    const six_link_real I_upper_arm_xx = c->links[1].I_s + J_upper_arm_yy + J_upper_arm_zz;
    const six_link_real I_upper_arm_yy = c->links[1].J_0_xx + J_upper_arm_zz;
    const six_link_real I_upper_arm_zz = c->links[1].J_0_xx + J_upper_arm_yy;

    /* upper_arm, a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real minus_a_0_upper_arm_x = minus_minus_beta_v_upper_arm_x
        + omega_R_upper_arm_z * v_R_upper_arm_y;
    const six_link_real minus_a_0_upper_arm_y = omega_R_upper_arm_z * minus_v_R_upper_arm_x
        + minus_omega_R_upper_arm_x * minus_v_R_upper_arm_z;
    const six_link_real a_0_upper_arm_z = minus_beta_v_upper_arm_z - minus_omega_R_upper_arm_x * v_R_upper_arm_y;

    /* upper_arm, Omega: centripetal operator */
    const six_link_real t2 = state->v[1] * state->v[1];
    const six_link_real t3 = omega_R_upper_arm_z * omega_R_upper_arm_z;
    const six_link_real minus_Omega_upper_arm_xx = t2 + t3;
    const six_link_real minus_Omega_upper_arm_xz = minus_omega_R_upper_arm_x * omega_R_upper_arm_z;
    const six_link_real t4 = minus_omega_R_upper_arm_x * minus_omega_R_upper_arm_x;
    const six_link_real minus_Omega_upper_arm_yy = t4 + t3;
    const six_link_real minus_Omega_upper_arm_zz = t4 + t2;

    /* upper_arm, B: moment of the elastic velocity */
    const six_link_real B_upper_arm_yx = c->links[1].chi_1 * state->v[6];
    const six_link_real B_upper_arm_yy = L_upper_arm_y1 * state->v[6];
    const six_link_real B_upper_arm_yz = L_upper_arm_z1 * state->v[6];
    const six_link_real B_upper_arm_zx = c->links[1].chi_2 * state->v[7];
    const six_link_real B_upper_arm_zy = L_upper_arm_y2 * state->v[7];
    const six_link_real B_upper_arm_zz = L_upper_arm_z2 * state->v[7];

    /* upper_arm, h_c: half of the Coriolis wrench */
    const six_link_real minus_h_c_upper_arm_1 = B_upper_arm_yy * minus_omega_R_upper_arm_x
        + B_upper_arm_zz * minus_omega_R_upper_arm_x;
    const six_link_real h_c_upper_arm_2 = B_upper_arm_zz * state->v[1]
        + B_upper_arm_yx * minus_omega_R_upper_arm_x - B_upper_arm_yz * omega_R_upper_arm_z;
    const six_link_real h_c_upper_arm_3 = B_upper_arm_yy * omega_R_upper_arm_z
        + B_upper_arm_zx * minus_omega_R_upper_arm_x - B_upper_arm_zy * state->v[1];
    const six_link_real h_c_upper_arm_4 = Sdot_upper_arm_z * state->v[1] - Sdot_upper_arm_y * omega_R_upper_arm_z;
    const six_link_real minus_minus_h_c_upper_arm_5 = Sdot_upper_arm_z * minus_omega_R_upper_arm_x;
    const six_link_real minus_h_c_upper_arm_6 = Sdot_upper_arm_y * minus_omega_R_upper_arm_x;

    /* upper_arm, h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const six_link_real h_MD_upper_arm_2 = h_c_upper_arm_2
        + state->v[8] * omega_R_upper_arm_z * c->links[1].sigma_t_3;
    const six_link_real h_MD_upper_arm_3 = h_c_upper_arm_3 - state->v[8] * state->v[1] * c->links[1].sigma_t_3;

    /* upper_arm, H_star: gyroscopic wrench and weight (29) */
    const six_link_real t5 = J_upper_arm_yy * minus_beta_omega_upper_arm_x
        - (minus_h_c_upper_arm_1 + J_upper_arm_xy * minus_Omega_upper_arm_xz);
    const six_link_real t6 = t5 + J_upper_arm_yz * (minus_Omega_upper_arm_yy - minus_Omega_upper_arm_zz)
        + S_upper_arm_y * a_0_upper_arm_z;
    const six_link_real t7 = t6 + J_upper_arm_xz * minus_beta_omega_upper_arm_z
        - J_upper_arm_zz * minus_beta_omega_upper_arm_x;
    const six_link_real H_star_upper_arm_1 = t7 + S_upper_arm_z * minus_a_0_upper_arm_y;
    const six_link_real t8 = h_c_upper_arm_2
        + J_upper_arm_xz * (minus_Omega_upper_arm_zz - minus_Omega_upper_arm_xx)
        - J_upper_arm_yz * minus_beta_omega_upper_arm_z;
    const six_link_real t9 = c->links[1].I_s * minus_omega_R_upper_arm_x;
    const six_link_real t10 = t8 - J_upper_arm_zz * minus_Omega_upper_arm_xz
        - S_upper_arm_z * minus_a_0_upper_arm_x - t9 * omega_R_upper_arm_z;
    const six_link_real t11 = t10 + c->links[1].J_0_xx * minus_Omega_upper_arm_xz
        - J_upper_arm_xy * minus_beta_omega_upper_arm_x;
    const six_link_real H_star_upper_arm_2 = t11 - c->links[1].S_0_x * a_0_upper_arm_z;
    const six_link_real t12 = h_c_upper_arm_3 - c->links[1].J_0_xx * minus_beta_omega_upper_arm_z
        + J_upper_arm_xy * (minus_Omega_upper_arm_xx - minus_Omega_upper_arm_yy);
    const six_link_real t13 = t12 + J_upper_arm_xz * minus_beta_omega_upper_arm_x
        - c->links[1].S_0_x * minus_a_0_upper_arm_y + J_upper_arm_yy * minus_beta_omega_upper_arm_z;
    const six_link_real H_star_upper_arm_3 = t13 + J_upper_arm_yz * minus_Omega_upper_arm_xz
        + S_upper_arm_y * minus_a_0_upper_arm_x + t9 * state->v[1];
    const six_link_real t14 = h_c_upper_arm_4 - minus_Omega_upper_arm_xx * c->links[1].S_0_x
        - minus_beta_omega_upper_arm_z * S_upper_arm_y;
    const six_link_real H_star_upper_arm_4 = t14 - minus_Omega_upper_arm_xz * S_upper_arm_z
        - minus_a_0_upper_arm_x * c->links[1].mu;
    const six_link_real t15 = minus_minus_h_c_upper_arm_5 - minus_beta_omega_upper_arm_z * c->links[1].S_0_x
        - minus_Omega_upper_arm_yy * S_upper_arm_y;
    const six_link_real H_star_upper_arm_5 = t15 + minus_beta_omega_upper_arm_x * S_upper_arm_z
        - minus_a_0_upper_arm_y * c->links[1].mu;
    const six_link_real t16 = minus_beta_omega_upper_arm_x * S_upper_arm_y
        - (minus_h_c_upper_arm_6 + minus_Omega_upper_arm_xz * c->links[1].S_0_x);
    const six_link_real H_star_upper_arm_6 = t16 - minus_Omega_upper_arm_zz * S_upper_arm_z
        + a_0_upper_arm_z * c->links[1].mu;

    /* upper_arm, h_V: bias of the twist rows */
    const six_link_real h_V_upper_arm_1 = H_star_upper_arm_1 - minus_h_c_upper_arm_1;
    const six_link_real h_V_upper_arm_2 = H_star_upper_arm_2 + h_MD_upper_arm_2;
    const six_link_real h_V_upper_arm_3 = H_star_upper_arm_3 + h_MD_upper_arm_3;
    const six_link_real h_V_upper_arm_4 = H_star_upper_arm_4 + h_c_upper_arm_4;
    const six_link_real h_V_upper_arm_5 = H_star_upper_arm_5 + minus_minus_h_c_upper_arm_5;
    const six_link_real h_V_upper_arm_6 = H_star_upper_arm_6 - minus_h_c_upper_arm_6;

    /* upper_arm, h_eta: gyroscopic force and weight on the modes (88) */
    const six_link_real t17 = L_upper_arm_z1 * minus_beta_omega_upper_arm_x
        - L_upper_arm_y1 * minus_Omega_upper_arm_yy - minus_beta_omega_upper_arm_z * c->links[1].chi_1;
    const six_link_real h_eta_upper_arm_1 = t17 - minus_a_0_upper_arm_y * c->links[1].sigma_y1
        + Ldot_upper_arm_z1 * 2 * minus_omega_R_upper_arm_x;
    const six_link_real t18 = L_upper_arm_y2 * minus_beta_omega_upper_arm_x
        - L_upper_arm_z2 * minus_Omega_upper_arm_zz - minus_Omega_upper_arm_xz * c->links[1].chi_2;
    const six_link_real h_eta_upper_arm_2 = t18 + a_0_upper_arm_z * c->links[1].sigma_z2
        - Ldot_upper_arm_y2 * 2 * minus_omega_R_upper_arm_x;

    /* upper_arm, r_T: tip point (11) */
    const six_link_real r_T_upper_arm_y = state->q[6] * 2;
    const six_link_real r_T_upper_arm_z = state->q[7] * 2;

    /* upper_arm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_upper_arm_x = state->q[8] * REAL(1.4142135623730951);
    const six_link_real theta_upper_arm_y = c->links[1].Psi_c_y2 * state->q[7];
    const six_link_real theta_upper_arm_z = c->links[1].Psi_c_z1 * state->q[6];

    /* upper_arm, x: squared angle of the tip section */
    const six_link_real t19 = theta_upper_arm_x * theta_upper_arm_x;
    const six_link_real t20 = theta_upper_arm_y * theta_upper_arm_y;
    const six_link_real minus_theta_hat2_upper_arm_33 = t19 + t20;
    const six_link_real t21 = theta_upper_arm_z * theta_upper_arm_z;
    const six_link_real x_upper_arm = minus_theta_hat2_upper_arm_33 + t21;

    /* upper_arm, c1: Stumpff function of order 1 */
    const six_link_real t22 = six_link_c5(x_upper_arm);
    const six_link_real c3_upper_arm = REAL(0.16666666666666666) - x_upper_arm * t22;
    const six_link_real c1_upper_arm = 1 - x_upper_arm * c3_upper_arm;

    /* upper_arm, c2: Stumpff function of order 2 */
    const six_link_real t23 = six_link_c4(x_upper_arm);
    const six_link_real c2_upper_arm = REAL(0.5) - x_upper_arm * t23;

    /* upper_arm, theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_upper_arm_11 = t20 + t21;
    const six_link_real theta_hat2_upper_arm_12 = theta_upper_arm_x * theta_upper_arm_y;
    const six_link_real theta_hat2_upper_arm_13 = theta_upper_arm_x * theta_upper_arm_z;
    const six_link_real minus_theta_hat2_upper_arm_22 = t19 + t21;
    const six_link_real theta_hat2_upper_arm_23 = theta_upper_arm_y * theta_upper_arm_z;

    /* upper_arm, J_l: left Jacobian of the exponential */
    const six_link_real J_l_upper_arm_xx = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_11;
    const six_link_real t24 = c3_upper_arm * theta_hat2_upper_arm_12;
    const six_link_real t25 = c2_upper_arm * theta_upper_arm_z;
    const six_link_real J_l_upper_arm_xy = t24 - t25;
    const six_link_real t26 = c2_upper_arm * theta_upper_arm_y;
    const six_link_real t27 = c3_upper_arm * theta_hat2_upper_arm_13;
    const six_link_real J_l_upper_arm_xz = t26 + t27;
    const six_link_real J_l_upper_arm_yx = t25 + t24;
    const six_link_real J_l_upper_arm_yy = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_22;
    const six_link_real t28 = c3_upper_arm * theta_hat2_upper_arm_23;
    const six_link_real t29 = c2_upper_arm * theta_upper_arm_x;
    const six_link_real J_l_upper_arm_yz = t28 - t29;
    const six_link_real J_l_upper_arm_zx = t27 - t26;
    const six_link_real J_l_upper_arm_zy = t29 + t28;
    const six_link_real J_l_upper_arm_zz = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_33;

    /* upper_arm, R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_upper_arm_xx = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_11;
    const six_link_real t30 = c2_upper_arm * theta_hat2_upper_arm_12;
    const six_link_real t31 = c1_upper_arm * theta_upper_arm_z;
    const six_link_real R_T_upper_arm_xy = t30 - t31;
    const six_link_real t32 = c1_upper_arm * theta_upper_arm_y;
    const six_link_real t33 = c2_upper_arm * theta_hat2_upper_arm_13;
    const six_link_real R_T_upper_arm_xz = t32 + t33;
    const six_link_real R_T_upper_arm_yx = t31 + t30;
    const six_link_real R_T_upper_arm_yy = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_22;
    const six_link_real t34 = c2_upper_arm * theta_hat2_upper_arm_23;
    const six_link_real t35 = c1_upper_arm * theta_upper_arm_x;
    const six_link_real R_T_upper_arm_yz = t34 - t35;
    const six_link_real R_T_upper_arm_zx = t33 - t32;
    const six_link_real R_T_upper_arm_zy = t35 + t34;
    const six_link_real R_T_upper_arm_zz = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_33;

    /* upper_arm, udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_upper_arm_y = state->v[6] * 2;
    const six_link_real udot_T_upper_arm_z = state->v[7] * 2;

    /* upper_arm, thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_upper_arm_x = state->v[8] * REAL(1.4142135623730951);
    const six_link_real thetadot_upper_arm_y = c->links[1].Psi_c_y2 * state->v[7];
    const six_link_real thetadot_upper_arm_z = c->links[1].Psi_c_z1 * state->v[6];

    /* upper_arm, omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t36 = theta_upper_arm_y * thetadot_upper_arm_z - theta_upper_arm_z * thetadot_upper_arm_y;
    const six_link_real t37 = theta_upper_arm_x * thetadot_upper_arm_y - theta_upper_arm_y * thetadot_upper_arm_x;
    const six_link_real t38 = theta_upper_arm_z * thetadot_upper_arm_x - theta_upper_arm_x * thetadot_upper_arm_z;
    const six_link_real t39 = theta_upper_arm_y * t37 - theta_upper_arm_z * t38;
    const six_link_real omega_s_upper_arm_x = thetadot_upper_arm_x + c2_upper_arm * t36 + c3_upper_arm * t39;
    const six_link_real t40 = theta_upper_arm_z * t36 - theta_upper_arm_x * t37;
    const six_link_real omega_s_upper_arm_y = thetadot_upper_arm_y + c2_upper_arm * t38 + c3_upper_arm * t40;
    const six_link_real t41 = theta_upper_arm_x * t38 - theta_upper_arm_y * t36;
    const six_link_real omega_s_upper_arm_z = thetadot_upper_arm_z + c2_upper_arm * t37 + c3_upper_arm * t41;

    /* upper_arm, xdot: rate of the squared angle */
    const six_link_real t42 = state->q[8] * REAL(2.8284271247461903) * thetadot_upper_arm_x
        + theta_upper_arm_y * 2 * thetadot_upper_arm_y;
    const six_link_real xdot_upper_arm = t42 + theta_upper_arm_z * 2 * thetadot_upper_arm_z;

    /* upper_arm, c2dot: rate of c2 */
    const six_link_real c2dot_upper_arm = xdot_upper_arm * (t23 - c3_upper_arm * REAL(0.5));

    /* upper_arm, c3dot: rate of c3 */
    const six_link_real c3dot_upper_arm = xdot_upper_arm * (t22 * REAL(1.5) - t23 * REAL(0.5));

    /* upper_arm, alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_upper_arm_x = c2dot_upper_arm * t36
        + c3_upper_arm * (thetadot_upper_arm_y * t37 - thetadot_upper_arm_z * t38) + c3dot_upper_arm * t39;
    const six_link_real alpha_s_upper_arm_y = c2dot_upper_arm * t38
        + c3_upper_arm * (thetadot_upper_arm_z * t36 - thetadot_upper_arm_x * t37) + c3dot_upper_arm * t40;
    const six_link_real alpha_s_upper_arm_z = c2dot_upper_arm * t37
        + c3_upper_arm * (thetadot_upper_arm_x * t38 - thetadot_upper_arm_y * t36) + c3dot_upper_arm * t41;

    /* upper_arm, omega_T: angular velocity of the tip section (46) */
    const six_link_real t43 = omega_s_upper_arm_x - minus_omega_R_upper_arm_x;
    const six_link_real t44 = omega_s_upper_arm_y + state->v[1];
    const six_link_real t45 = omega_s_upper_arm_z + omega_R_upper_arm_z;
    const six_link_real omega_T_upper_arm_x = R_T_upper_arm_xx * t43 + R_T_upper_arm_yx * t44
        + R_T_upper_arm_zx * t45;
    const six_link_real omega_T_upper_arm_y = R_T_upper_arm_xy * t43 + R_T_upper_arm_yy * t44
        + R_T_upper_arm_zy * t45;
    const six_link_real omega_T_upper_arm_z = R_T_upper_arm_xz * t43 + R_T_upper_arm_yz * t44
        + R_T_upper_arm_zz * t45;

    /* upper_arm, v_T: velocity of the tip point (46) */
    const six_link_real t46 = state->v[1] * r_T_upper_arm_z - minus_v_R_upper_arm_x
        - omega_R_upper_arm_z * r_T_upper_arm_y;
    const six_link_real t47 = udot_T_upper_arm_y + v_R_upper_arm_y + c->links[1].length * omega_R_upper_arm_z
        + minus_omega_R_upper_arm_x * r_T_upper_arm_z;
    const six_link_real t48 = udot_T_upper_arm_z - minus_v_R_upper_arm_z
        - minus_omega_R_upper_arm_x * r_T_upper_arm_y - c->links[1].length * state->v[1];
    const six_link_real v_T_upper_arm_x = R_T_upper_arm_xx * t46 + R_T_upper_arm_yx * t47
        + R_T_upper_arm_zx * t48;
    const six_link_real v_T_upper_arm_y = R_T_upper_arm_xy * t46 + R_T_upper_arm_yy * t47
        + R_T_upper_arm_zy * t48;
    const six_link_real v_T_upper_arm_z = R_T_upper_arm_xz * t46 + R_T_upper_arm_yz * t47
        + R_T_upper_arm_zz * t48;

    /* upper_arm, b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const six_link_real t49 = alpha_s_upper_arm_x + omega_s_upper_arm_z * state->v[1]
        - omega_s_upper_arm_y * omega_R_upper_arm_z;
    const six_link_real t50 = alpha_s_upper_arm_y + omega_s_upper_arm_x * omega_R_upper_arm_z
        + omega_s_upper_arm_z * minus_omega_R_upper_arm_x;
    const six_link_real t51 = alpha_s_upper_arm_z - omega_s_upper_arm_y * minus_omega_R_upper_arm_x
        - omega_s_upper_arm_x * state->v[1];
    const six_link_real b_omega_upper_arm_x = R_T_upper_arm_xx * t49 + R_T_upper_arm_yx * t50
        + R_T_upper_arm_zx * t51;
    const six_link_real b_omega_upper_arm_y = R_T_upper_arm_xy * t49 + R_T_upper_arm_yy * t50
        + R_T_upper_arm_zy * t51;
    const six_link_real b_omega_upper_arm_z = R_T_upper_arm_xz * t49 + R_T_upper_arm_yz * t50
        + R_T_upper_arm_zz * t51;

    /* upper_arm, b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const six_link_real t52 = omega_s_upper_arm_z * t47 + state->v[1] * udot_T_upper_arm_z
        - omega_s_upper_arm_y * t48 - omega_R_upper_arm_z * udot_T_upper_arm_y;
    const six_link_real t53 = omega_s_upper_arm_x * t48 - omega_s_upper_arm_z * t46
        + minus_omega_R_upper_arm_x * udot_T_upper_arm_z;
    const six_link_real t54 = omega_s_upper_arm_y * t46 - minus_omega_R_upper_arm_x * udot_T_upper_arm_y
        - omega_s_upper_arm_x * t47;
    const six_link_real b_v_upper_arm_x = R_T_upper_arm_xx * t52 + R_T_upper_arm_yx * t53
        + R_T_upper_arm_zx * t54;
    const six_link_real b_v_upper_arm_y = R_T_upper_arm_xy * t52 + R_T_upper_arm_yy * t53
        + R_T_upper_arm_zy * t54;
    const six_link_real b_v_upper_arm_z = R_T_upper_arm_xz * t52 + R_T_upper_arm_yz * t53
        + R_T_upper_arm_zz * t54;

    /* upper_arm, a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_upper_arm_x = omega_T_upper_arm_y * v_T_upper_arm_z
        - omega_T_upper_arm_z * v_T_upper_arm_y;
    const six_link_real a_T_upper_arm_y = omega_T_upper_arm_z * v_T_upper_arm_x
        - omega_T_upper_arm_x * v_T_upper_arm_z;
    const six_link_real a_T_upper_arm_z = omega_T_upper_arm_x * v_T_upper_arm_y
        - omega_T_upper_arm_y * v_T_upper_arm_x;

    /* upper_arm, h_T_tau: moment that the bodies' velocities and weight need */
    const six_link_real t55 = c->links[1].I_T_zz * omega_T_upper_arm_z - c->links[1].J_T_xz * omega_T_upper_arm_x
        - c->links[1].J_T_yz * omega_T_upper_arm_y;
    const six_link_real t56 = c->links[1].S_T_y * a_T_upper_arm_z + omega_T_upper_arm_y * t55
        - c->links[1].S_T_z * a_T_upper_arm_y;
    const six_link_real t57 = c->links[1].I_T_yy * omega_T_upper_arm_y - c->links[1].J_T_xy * omega_T_upper_arm_x
        - c->links[1].J_T_yz * omega_T_upper_arm_z;
    const six_link_real h_T_tau_upper_arm_x = t56 - omega_T_upper_arm_z * t57;
    const six_link_real t58 = c->links[1].I_T_xx * omega_T_upper_arm_x - c->links[1].J_T_xy * omega_T_upper_arm_y
        - c->links[1].J_T_xz * omega_T_upper_arm_z;
    const six_link_real t59 = c->links[1].S_T_z * a_T_upper_arm_x + omega_T_upper_arm_z * t58
        - c->links[1].S_T_x * a_T_upper_arm_z;
    const six_link_real h_T_tau_upper_arm_y = t59 - omega_T_upper_arm_x * t55;
    const six_link_real t60 = c->links[1].S_T_x * a_T_upper_arm_y + omega_T_upper_arm_x * t57
        - c->links[1].S_T_y * a_T_upper_arm_x;
    const six_link_real h_T_tau_upper_arm_z = t60 - omega_T_upper_arm_y * t58;

    /* upper_arm, h_T_F: force that the bodies' velocities and weight need */
    const six_link_real t61 = c->links[1].S_T_y * omega_T_upper_arm_x - c->links[1].S_T_x * omega_T_upper_arm_y;
    const six_link_real t62 = c->links[1].S_T_x * omega_T_upper_arm_z - c->links[1].S_T_z * omega_T_upper_arm_x;
    const six_link_real h_T_F_upper_arm_x = a_T_upper_arm_x * c->links[1].body0_mass + omega_T_upper_arm_y * t61
        - omega_T_upper_arm_z * t62;
    const six_link_real t63 = c->links[1].S_T_z * omega_T_upper_arm_y - c->links[1].S_T_y * omega_T_upper_arm_z;
    const six_link_real h_T_F_upper_arm_y = a_T_upper_arm_y * c->links[1].body0_mass + omega_T_upper_arm_z * t63
        - omega_T_upper_arm_x * t61;
    const six_link_real h_T_F_upper_arm_z = a_T_upper_arm_z * c->links[1].body0_mass + omega_T_upper_arm_x * t62
        - omega_T_upper_arm_y * t63;

    /* forearm, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real t64 = six_link_cos(state->q[2]);
    const six_link_real t65 = six_link_sin(state->q[2]);
    const six_link_real R_rel_forearm_xx = c->links[2].R_m_xx * t64 - c->links[2].R_m_xz * t65;
    const six_link_real R_rel_forearm_xz = c->links[2].R_m_xx * t65 + c->links[2].R_m_xz * t64;
    const six_link_real R_rel_forearm_yx = c->links[2].R_m_yx * t64 - c->links[2].R_m_yz * t65;
    const six_link_real R_rel_forearm_yz = c->links[2].R_m_yx * t65 + c->links[2].R_m_yz * t64;
    const six_link_real R_rel_forearm_zx = c->links[2].R_m_zx * t64 - c->links[2].R_m_zz * t65;
    const six_link_real R_rel_forearm_zz = c->links[2].R_m_zx * t65 + c->links[2].R_m_zz * t64;

    /* forearm, omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_forearm_x = R_rel_forearm_xx * omega_T_upper_arm_x
        + R_rel_forearm_yx * omega_T_upper_arm_y + R_rel_forearm_zx * omega_T_upper_arm_z;
    const six_link_real omega_R_forearm_y = c->links[2].R_m_xy * omega_T_upper_arm_x
        + c->links[2].R_m_yy * omega_T_upper_arm_y + c->links[2].R_m_zy * omega_T_upper_arm_z;
    const six_link_real omega_R_forearm_z = R_rel_forearm_xz * omega_T_upper_arm_x
        + R_rel_forearm_yz * omega_T_upper_arm_y + R_rel_forearm_zz * omega_T_upper_arm_z;

    /* forearm, omega: angular velocity of the link (45) */
    const six_link_real omega_forearm_y = omega_R_forearm_y + state->v[2];

    /* forearm, v_R: velocity of the joint point */
    const six_link_real t66 = v_T_upper_arm_x + c->links[2].mount_xyz_z * omega_T_upper_arm_y
        - c->links[2].mount_xyz_y * omega_T_upper_arm_z;
    const six_link_real t67 = v_T_upper_arm_y + c->links[2].mount_xyz_x * omega_T_upper_arm_z
        - c->links[2].mount_xyz_z * omega_T_upper_arm_x;
    const six_link_real t68 = v_T_upper_arm_z + c->links[2].mount_xyz_y * omega_T_upper_arm_x
        - c->links[2].mount_xyz_x * omega_T_upper_arm_y;
    const six_link_real v_R_forearm_x = R_rel_forearm_xx * t66 + R_rel_forearm_yx * t67 + R_rel_forearm_zx * t68;
    const six_link_real v_R_forearm_y = c->links[2].R_m_xy * t66 + c->links[2].R_m_yy * t67
        + c->links[2].R_m_zy * t68;
    const six_link_real v_R_forearm_z = R_rel_forearm_xz * t66 + R_rel_forearm_yz * t67 + R_rel_forearm_zz * t68;

    /* forearm, beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_omega_forearm_x = omega_R_forearm_z * state->v[2];
    const six_link_real beta_omega_forearm_z = omega_R_forearm_x * state->v[2];

    /* forearm, beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_v_forearm_x = state->v[2] * v_R_forearm_z;
    const six_link_real beta_v_forearm_z = state->v[2] * v_R_forearm_x;

    /* forearm, S: first moment */
    const six_link_real S_forearm_y = c->links[2].S_B_y + state->q[9] * c->links[2].sigma_y1;
    const six_link_real S_forearm_z = c->links[2].S_B_z + state->q[10] * c->links[2].sigma_z2;

    /* forearm, Sdot: rate of the first moment */
    const six_link_real Sdot_forearm_y = state->v[9] * c->links[2].sigma_y1;
    const six_link_real Sdot_forearm_z = state->v[10] * c->links[2].sigma_z2;

    /* forearm, L: first moment weighted by each mode shape (85) */
    const six_link_real L_forearm_y1 = c->links[2].M_Wphi_11 * state->q[9];
    const six_link_real L_forearm_y2 = state->q[9] * c->links[2].mu;
    const six_link_real L_forearm_z1 = state->q[10] * c->links[2].mu;
    const six_link_real L_forearm_z2 = c->links[2].M_Wphi_22 * state->q[10];

    /* forearm, Ldot: rate of L */
    const six_link_real Ldot_forearm_y2 = state->v[9] * c->links[2].mu;
    const six_link_real Ldot_forearm_z1 = state->v[10] * c->links[2].mu;

    /* forearm, J: second moment */
    const six_link_real J_forearm_xy = c->links[2].J_B_xy + c->links[2].chi_1 * state->q[9];
    const six_link_real J_forearm_xz = c->links[2].J_B_xz + c->links[2].chi_2 * state->q[10];
    const six_link_real J_forearm_yy = c->links[2].J_B_yy + L_forearm_y1 * state->q[9];
    const six_link_real J_forearm_yz = c->links[2].J_B_yz + L_forearm_z1 * state->q[9];
    const six_link_real J_forearm_zz = c->links[2].J_B_zz + L_forearm_z2 * state->q[10];

    /* forearm, I: inertia about the origin, deformed */
    const six_link_real I_forearm_xx = c->links[2].I_s + J_forearm_yy + J_forearm_zz;
    const six_link_real I_forearm_yy = c->links[2].J_0_xx + J_forearm_zz;
    const six_link_real I_forearm_zz = c->links[2].J_0_xx + J_forearm_yy;

    /* forearm, a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_forearm_x = omega_forearm_y * v_R_forearm_z - omega_R_forearm_z * v_R_forearm_y;
    const six_link_real a_0_forearm_y = omega_R_forearm_z * v_R_forearm_x - omega_R_forearm_x * v_R_forearm_z;
    const six_link_real a_0_forearm_z = omega_R_forearm_x * v_R_forearm_y - omega_forearm_y * v_R_forearm_x;

    /* forearm, Omega: centripetal operator */
    const six_link_real t69 = omega_forearm_y * omega_forearm_y;
    const six_link_real t70 = omega_R_forearm_z * omega_R_forearm_z;
    const six_link_real minus_Omega_forearm_xx = t69 + t70;
    const six_link_real Omega_forearm_xy = omega_R_forearm_x * omega_forearm_y;
    const six_link_real Omega_forearm_xz = omega_R_forearm_x * omega_R_forearm_z;
    const six_link_real t71 = omega_R_forearm_x * omega_R_forearm_x;
    const six_link_real minus_Omega_forearm_yy = t71 + t70;
    const six_link_real Omega_forearm_yz = omega_forearm_y * omega_R_forearm_z;
    const six_link_real minus_Omega_forearm_zz = t71 + t69;

    /* forearm, B: moment of the elastic velocity */
    const six_link_real B_forearm_yx = c->links[2].chi_1 * state->v[9];
    const six_link_real B_forearm_yy = L_forearm_y1 * state->v[9];
    const six_link_real B_forearm_yz = L_forearm_z1 * state->v[9];
    const six_link_real B_forearm_zx = c->links[2].chi_2 * state->v[10];
    const six_link_real B_forearm_zy = L_forearm_y2 * state->v[10];
    const six_link_real B_forearm_zz = L_forearm_z2 * state->v[10];

    /* forearm, h_c: half of the Coriolis wrench */
    const six_link_real h_c_forearm_1 = B_forearm_yy * omega_R_forearm_x + B_forearm_zz * omega_R_forearm_x;
    const six_link_real h_c_forearm_2 = B_forearm_zz * omega_forearm_y - B_forearm_yx * omega_R_forearm_x
        - B_forearm_yz * omega_R_forearm_z;
    const six_link_real h_c_forearm_3 = B_forearm_yy * omega_R_forearm_z - B_forearm_zx * omega_R_forearm_x
        - B_forearm_zy * omega_forearm_y;
    const six_link_real h_c_forearm_4 = Sdot_forearm_z * omega_forearm_y - Sdot_forearm_y * omega_R_forearm_z;
    const six_link_real minus_h_c_forearm_5 = Sdot_forearm_z * omega_R_forearm_x;
    const six_link_real h_c_forearm_6 = Sdot_forearm_y * omega_R_forearm_x;

    /* forearm, H_star: gyroscopic wrench and weight (29) */
    const six_link_real t72 = h_c_forearm_1 + J_forearm_xy * Omega_forearm_xz + J_forearm_yy * Omega_forearm_yz
        + J_forearm_yz * (minus_Omega_forearm_yy - minus_Omega_forearm_zz);
    const six_link_real t73 = t72 + S_forearm_y * a_0_forearm_z - J_forearm_xz * Omega_forearm_xy
        - J_forearm_zz * Omega_forearm_yz;
    const six_link_real H_star_forearm_1 = t73 - S_forearm_z * a_0_forearm_y;
    const six_link_real t74 = h_c_forearm_2 + J_forearm_xz * (minus_Omega_forearm_zz - minus_Omega_forearm_xx)
        + J_forearm_yz * Omega_forearm_xy;
    const six_link_real t75 = c->links[2].I_s * omega_R_forearm_x;
    const six_link_real t76 = t74 + J_forearm_zz * Omega_forearm_xz + S_forearm_z * a_0_forearm_x
        + t75 * omega_R_forearm_z - c->links[2].J_0_xx * Omega_forearm_xz;
    const six_link_real H_star_forearm_2 = t76 - J_forearm_xy * Omega_forearm_yz
        - c->links[2].S_0_x * a_0_forearm_z;
    const six_link_real t77 = h_c_forearm_3 + c->links[2].J_0_xx * Omega_forearm_xy
        + J_forearm_xy * (minus_Omega_forearm_xx - minus_Omega_forearm_yy);
    const six_link_real t78 = t77 + J_forearm_xz * Omega_forearm_yz + c->links[2].S_0_x * a_0_forearm_y
        - J_forearm_yy * Omega_forearm_xy;
    const six_link_real H_star_forearm_3 = t78 - J_forearm_yz * Omega_forearm_xz - S_forearm_y * a_0_forearm_x
        - t75 * omega_forearm_y;
    const six_link_real t79 = h_c_forearm_4 - minus_Omega_forearm_xx * c->links[2].S_0_x
        + Omega_forearm_xy * S_forearm_y + Omega_forearm_xz * S_forearm_z;
    const six_link_real H_star_forearm_4 = t79 + a_0_forearm_x * c->links[2].m;
    const six_link_real t80 = Omega_forearm_xy * c->links[2].S_0_x - minus_h_c_forearm_5
        - minus_Omega_forearm_yy * S_forearm_y;
    const six_link_real H_star_forearm_5 = t80 + Omega_forearm_yz * S_forearm_z + a_0_forearm_y * c->links[2].m;
    const six_link_real t81 = h_c_forearm_6 + Omega_forearm_xz * c->links[2].S_0_x
        + Omega_forearm_yz * S_forearm_y - minus_Omega_forearm_zz * S_forearm_z;
    const six_link_real H_star_forearm_6 = t81 + a_0_forearm_z * c->links[2].m;

    /* forearm, h_V: bias of the twist rows */
    const six_link_real h_V_forearm_1 = H_star_forearm_1 + h_c_forearm_1;
    const six_link_real h_V_forearm_2 = H_star_forearm_2 + h_c_forearm_2;
    const six_link_real h_V_forearm_3 = H_star_forearm_3 + h_c_forearm_3;
    const six_link_real h_V_forearm_4 = H_star_forearm_4 + h_c_forearm_4;
    const six_link_real h_V_forearm_5 = H_star_forearm_5 - minus_h_c_forearm_5;
    const six_link_real h_V_forearm_6 = H_star_forearm_6 + h_c_forearm_6;

    /* forearm, h_eta: gyroscopic force and weight on the modes (88) */
    const six_link_real t82 = L_forearm_z1 * Omega_forearm_yz - L_forearm_y1 * minus_Omega_forearm_yy
        + Omega_forearm_xy * c->links[2].chi_1;
    const six_link_real h_eta_forearm_1 = t82 + a_0_forearm_y * c->links[2].sigma_y1
        - Ldot_forearm_z1 * 2 * omega_R_forearm_x;
    const six_link_real t83 = L_forearm_y2 * Omega_forearm_yz - L_forearm_z2 * minus_Omega_forearm_zz
        + Omega_forearm_xz * c->links[2].chi_2;
    const six_link_real h_eta_forearm_2 = t83 + a_0_forearm_z * c->links[2].sigma_z2
        + Ldot_forearm_y2 * 2 * omega_R_forearm_x;

    /* forearm, r_T: tip point (11) */
    const six_link_real r_T_forearm_y = state->q[9] * REAL(2.23606797749979);
    const six_link_real r_T_forearm_z = state->q[10] * REAL(2.23606797749979);

    /* forearm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_forearm_y = c->links[2].Psi_c_y2 * state->q[10];
    const six_link_real theta_forearm_z = c->links[2].Psi_c_z1 * state->q[9];

    /* forearm, x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_forearm_33 = theta_forearm_y * theta_forearm_y;
    const six_link_real minus_theta_hat2_forearm_22 = theta_forearm_z * theta_forearm_z;
    const six_link_real x_forearm = minus_theta_hat2_forearm_33 + minus_theta_hat2_forearm_22;

    /* forearm, c1: Stumpff function of order 1 */
    const six_link_real t84 = six_link_c5(x_forearm);
    const six_link_real c3_forearm = REAL(0.16666666666666666) - x_forearm * t84;
    const six_link_real c1_forearm = 1 - x_forearm * c3_forearm;

    /* forearm, c2: Stumpff function of order 2 */
    const six_link_real t85 = six_link_c4(x_forearm);
    const six_link_real c2_forearm = REAL(0.5) - x_forearm * t85;

    /* forearm, theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_forearm_23 = theta_forearm_y * theta_forearm_z;

    /* forearm, J_l: left Jacobian of the exponential */
    const six_link_real minus_J_l_forearm_xy = c2_forearm * theta_forearm_z;
    const six_link_real J_l_forearm_xz = c2_forearm * theta_forearm_y;
    const six_link_real J_l_forearm_yy = 1 - c3_forearm * minus_theta_hat2_forearm_22;
    const six_link_real J_l_forearm_yz = c3_forearm * theta_hat2_forearm_23;
    const six_link_real J_l_forearm_zz = 1 - c3_forearm * minus_theta_hat2_forearm_33;

    /* forearm, R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_forearm_xx = 1 - c2_forearm * x_forearm;
    const six_link_real minus_R_T_forearm_xy = c1_forearm * theta_forearm_z;
    const six_link_real R_T_forearm_xz = c1_forearm * theta_forearm_y;
    const six_link_real R_T_forearm_yy = 1 - c2_forearm * minus_theta_hat2_forearm_22;
    const six_link_real R_T_forearm_yz = c2_forearm * theta_hat2_forearm_23;
    const six_link_real R_T_forearm_zz = 1 - c2_forearm * minus_theta_hat2_forearm_33;

    /* forearm, udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_forearm_y = state->v[9] * REAL(2.23606797749979);
    const six_link_real udot_T_forearm_z = state->v[10] * REAL(2.23606797749979);

    /* forearm, thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_forearm_y = c->links[2].Psi_c_y2 * state->v[10];
    const six_link_real thetadot_forearm_z = c->links[2].Psi_c_z1 * state->v[9];

    /* forearm, omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t86 = theta_forearm_y * thetadot_forearm_z - theta_forearm_z * thetadot_forearm_y;
    const six_link_real omega_s_forearm_x = c2_forearm * t86;
    const six_link_real omega_s_forearm_y = thetadot_forearm_y + c3_forearm * theta_forearm_z * t86;
    const six_link_real omega_s_forearm_z = thetadot_forearm_z - c3_forearm * theta_forearm_y * t86;

    /* forearm, xdot: rate of the squared angle */
    const six_link_real xdot_forearm = theta_forearm_y * 2 * thetadot_forearm_y
        + theta_forearm_z * 2 * thetadot_forearm_z;

    /* forearm, c2dot: rate of c2 */
    const six_link_real c2dot_forearm = xdot_forearm * (t85 - c3_forearm * REAL(0.5));

    /* forearm, c3dot: rate of c3 */
    const six_link_real c3dot_forearm = xdot_forearm * (t84 * REAL(1.5) - t85 * REAL(0.5));

    /* forearm, alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_forearm_x = c2dot_forearm * t86;
    const six_link_real alpha_s_forearm_y = c3_forearm * thetadot_forearm_z * t86
        + c3dot_forearm * theta_forearm_z * t86;
    const six_link_real minus_alpha_s_forearm_z = c3_forearm * thetadot_forearm_y * t86
        + c3dot_forearm * theta_forearm_y * t86;

    /* forearm, omega_T: angular velocity of the tip section (46) */
    const six_link_real t87 = omega_s_forearm_x + omega_R_forearm_x;
    const six_link_real t88 = omega_s_forearm_y + omega_forearm_y;
    const six_link_real t89 = omega_s_forearm_z + omega_R_forearm_z;
    const six_link_real omega_T_forearm_x = R_T_forearm_xx * t87 + minus_R_T_forearm_xy * t88
        - R_T_forearm_xz * t89;
    const six_link_real omega_T_forearm_y = R_T_forearm_yy * t88 - minus_R_T_forearm_xy * t87
        + R_T_forearm_yz * t89;
    const six_link_real omega_T_forearm_z = R_T_forearm_xz * t87 + R_T_forearm_yz * t88 + R_T_forearm_zz * t89;

    /* forearm, v_T: velocity of the tip point (46) */
    const six_link_real t90 = v_R_forearm_x + omega_forearm_y * r_T_forearm_z - omega_R_forearm_z * r_T_forearm_y;
    const six_link_real t91 = udot_T_forearm_y + v_R_forearm_y + c->links[2].length * omega_R_forearm_z
        - omega_R_forearm_x * r_T_forearm_z;
    const six_link_real t92 = udot_T_forearm_z + v_R_forearm_z + omega_R_forearm_x * r_T_forearm_y
        - c->links[2].length * omega_forearm_y;
    const six_link_real v_T_forearm_x = R_T_forearm_xx * t90 + minus_R_T_forearm_xy * t91 - R_T_forearm_xz * t92;
    const six_link_real v_T_forearm_y = R_T_forearm_yy * t91 - minus_R_T_forearm_xy * t90 + R_T_forearm_yz * t92;
    const six_link_real v_T_forearm_z = R_T_forearm_xz * t90 + R_T_forearm_yz * t91 + R_T_forearm_zz * t92;

    /* forearm, b_omega: angular acceleration of the tip section that the velocities cause (accconst1b) */
    const six_link_real t93 = alpha_s_forearm_x + omega_s_forearm_z * omega_forearm_y
        - omega_s_forearm_y * omega_R_forearm_z;
    const six_link_real t94 = alpha_s_forearm_y + omega_s_forearm_x * omega_R_forearm_z
        - omega_s_forearm_z * omega_R_forearm_x;
    const six_link_real t95 = omega_s_forearm_y * omega_R_forearm_x - minus_alpha_s_forearm_z
        - omega_s_forearm_x * omega_forearm_y;
    const six_link_real b_omega_forearm_x = R_T_forearm_xx * t93 + minus_R_T_forearm_xy * t94
        - R_T_forearm_xz * t95;
    const six_link_real b_omega_forearm_y = R_T_forearm_yy * t94 - minus_R_T_forearm_xy * t93
        + R_T_forearm_yz * t95;
    const six_link_real b_omega_forearm_z = R_T_forearm_xz * t93 + R_T_forearm_yz * t94 + R_T_forearm_zz * t95;

    /* forearm, b_v: acceleration of the tip point that the velocities cause (accconst1b) */
    const six_link_real t96 = omega_s_forearm_z * t91 + omega_forearm_y * udot_T_forearm_z
        - omega_s_forearm_y * t92 - omega_R_forearm_z * udot_T_forearm_y;
    const six_link_real t97 = omega_s_forearm_x * t92 - omega_s_forearm_z * t90
        - omega_R_forearm_x * udot_T_forearm_z;
    const six_link_real t98 = omega_s_forearm_y * t90 + omega_R_forearm_x * udot_T_forearm_y
        - omega_s_forearm_x * t91;
    const six_link_real b_v_forearm_x = R_T_forearm_xx * t96 + minus_R_T_forearm_xy * t97 - R_T_forearm_xz * t98;
    const six_link_real b_v_forearm_y = R_T_forearm_yy * t97 - minus_R_T_forearm_xy * t96 + R_T_forearm_yz * t98;
    const six_link_real b_v_forearm_z = R_T_forearm_xz * t96 + R_T_forearm_yz * t97 + R_T_forearm_zz * t98;

    /* wrist_roll, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_wrist_roll_yy = six_link_cos(state->q[3]);
    const six_link_real minus_R_rel_wrist_roll_yz = six_link_sin(state->q[3]);

    /* wrist_roll, omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_wrist_roll_y = R_rel_wrist_roll_yy * omega_T_forearm_y
        + minus_R_rel_wrist_roll_yz * omega_T_forearm_z;
    const six_link_real omega_R_wrist_roll_z = R_rel_wrist_roll_yy * omega_T_forearm_z
        - minus_R_rel_wrist_roll_yz * omega_T_forearm_y;

    /* wrist_roll, omega: angular velocity of the link (45) */
    const six_link_real omega_wrist_roll_x = omega_T_forearm_x + state->v[3];

    /* wrist_roll, v_R: velocity of the joint point */
    const six_link_real v_R_wrist_roll_y = R_rel_wrist_roll_yy * v_T_forearm_y
        + minus_R_rel_wrist_roll_yz * v_T_forearm_z;
    const six_link_real v_R_wrist_roll_z = R_rel_wrist_roll_yy * v_T_forearm_z
        - minus_R_rel_wrist_roll_yz * v_T_forearm_y;

    /* wrist_roll, beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_omega_wrist_roll_y = omega_R_wrist_roll_z * state->v[3];
    const six_link_real minus_beta_omega_wrist_roll_z = omega_R_wrist_roll_y * state->v[3];

    /* wrist_roll, beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_v_wrist_roll_y = state->v[3] * v_R_wrist_roll_z;
    const six_link_real minus_beta_v_wrist_roll_z = state->v[3] * v_R_wrist_roll_y;

    /* wrist_roll, a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_wrist_roll_x = omega_R_wrist_roll_y * v_R_wrist_roll_z
        - omega_R_wrist_roll_z * v_R_wrist_roll_y;
    const six_link_real a_0_wrist_roll_y = omega_R_wrist_roll_z * v_T_forearm_x
        - omega_wrist_roll_x * v_R_wrist_roll_z;
    const six_link_real a_0_wrist_roll_z = omega_wrist_roll_x * v_R_wrist_roll_y
        - omega_R_wrist_roll_y * v_T_forearm_x;

    /* wrist_roll, Omega: centripetal operator */
    const six_link_real minus_Omega_wrist_roll_xx = omega_R_wrist_roll_y * omega_R_wrist_roll_y
        + omega_R_wrist_roll_z * omega_R_wrist_roll_z;
    const six_link_real Omega_wrist_roll_xy = omega_wrist_roll_x * omega_R_wrist_roll_y;
    const six_link_real Omega_wrist_roll_xz = omega_wrist_roll_x * omega_R_wrist_roll_z;

    /* wrist_roll, H_star: gyroscopic wrench and weight (29) */
    const six_link_real t99 = c->links[3].I_s * omega_wrist_roll_x;
    const six_link_real H_star_wrist_roll_2 = t99 * omega_R_wrist_roll_z
        - c->links[3].J_0_xx * Omega_wrist_roll_xz - c->links[3].S_0_x * a_0_wrist_roll_z;
    const six_link_real H_star_wrist_roll_3 = c->links[3].J_0_xx * Omega_wrist_roll_xy
        + c->links[3].S_0_x * a_0_wrist_roll_y - t99 * omega_R_wrist_roll_y;
    const six_link_real H_star_wrist_roll_4 = a_0_wrist_roll_x * c->links[3].mu
        - minus_Omega_wrist_roll_xx * c->links[3].S_0_x;
    const six_link_real H_star_wrist_roll_5 = Omega_wrist_roll_xy * c->links[3].S_0_x
        + a_0_wrist_roll_y * c->links[3].mu;
    const six_link_real H_star_wrist_roll_6 = Omega_wrist_roll_xz * c->links[3].S_0_x
        + a_0_wrist_roll_z * c->links[3].mu;

    /* wrist_roll, v_T: velocity of the tip point (46) */
    const six_link_real v_T_wrist_roll_y = v_R_wrist_roll_y + c->links[3].length * omega_R_wrist_roll_z;
    const six_link_real v_T_wrist_roll_z = v_R_wrist_roll_z - c->links[3].length * omega_R_wrist_roll_y;

    /* wrist_pitch, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_wrist_pitch_xx = six_link_cos(state->q[4]);
    const six_link_real R_rel_wrist_pitch_xz = six_link_sin(state->q[4]);

    /* wrist_pitch, omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_wrist_pitch_x = R_rel_wrist_pitch_xx * omega_wrist_roll_x
        - R_rel_wrist_pitch_xz * omega_R_wrist_roll_z;
    const six_link_real omega_R_wrist_pitch_z = R_rel_wrist_pitch_xz * omega_wrist_roll_x
        + R_rel_wrist_pitch_xx * omega_R_wrist_roll_z;

    /* wrist_pitch, omega: angular velocity of the link (45) */
    const six_link_real omega_wrist_pitch_y = omega_R_wrist_roll_y + state->v[4];

    /* wrist_pitch, v_R: velocity of the joint point */
    const six_link_real v_R_wrist_pitch_x = R_rel_wrist_pitch_xx * v_T_forearm_x
        - R_rel_wrist_pitch_xz * v_T_wrist_roll_z;
    const six_link_real v_R_wrist_pitch_z = R_rel_wrist_pitch_xz * v_T_forearm_x
        + R_rel_wrist_pitch_xx * v_T_wrist_roll_z;

    /* wrist_pitch, beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_omega_wrist_pitch_x = omega_R_wrist_pitch_z * state->v[4];
    const six_link_real beta_omega_wrist_pitch_z = omega_R_wrist_pitch_x * state->v[4];

    /* wrist_pitch, beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real minus_beta_v_wrist_pitch_x = state->v[4] * v_R_wrist_pitch_z;
    const six_link_real beta_v_wrist_pitch_z = state->v[4] * v_R_wrist_pitch_x;

    /* wrist_pitch, a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_wrist_pitch_x = omega_wrist_pitch_y * v_R_wrist_pitch_z
        - omega_R_wrist_pitch_z * v_T_wrist_roll_y;
    const six_link_real a_0_wrist_pitch_y = omega_R_wrist_pitch_z * v_R_wrist_pitch_x
        - omega_R_wrist_pitch_x * v_R_wrist_pitch_z;
    const six_link_real a_0_wrist_pitch_z = omega_R_wrist_pitch_x * v_T_wrist_roll_y
        - omega_wrist_pitch_y * v_R_wrist_pitch_x;

    /* wrist_pitch, Omega: centripetal operator */
    const six_link_real minus_Omega_wrist_pitch_xx = omega_wrist_pitch_y * omega_wrist_pitch_y
        + omega_R_wrist_pitch_z * omega_R_wrist_pitch_z;
    const six_link_real Omega_wrist_pitch_xy = omega_R_wrist_pitch_x * omega_wrist_pitch_y;
    const six_link_real Omega_wrist_pitch_xz = omega_R_wrist_pitch_x * omega_R_wrist_pitch_z;

    /* wrist_pitch, H_star: gyroscopic wrench and weight (29) */
    const six_link_real t100 = c->links[4].I_s * omega_R_wrist_pitch_x;
    const six_link_real H_star_wrist_pitch_2 = t100 * omega_R_wrist_pitch_z
        - c->links[4].J_0_xx * Omega_wrist_pitch_xz - c->links[4].S_0_x * a_0_wrist_pitch_z;
    const six_link_real H_star_wrist_pitch_3 = c->links[4].J_0_xx * Omega_wrist_pitch_xy
        + c->links[4].S_0_x * a_0_wrist_pitch_y - t100 * omega_wrist_pitch_y;
    const six_link_real H_star_wrist_pitch_4 = a_0_wrist_pitch_x * c->links[4].mu
        - minus_Omega_wrist_pitch_xx * c->links[4].S_0_x;
    const six_link_real H_star_wrist_pitch_5 = Omega_wrist_pitch_xy * c->links[4].S_0_x
        + a_0_wrist_pitch_y * c->links[4].mu;
    const six_link_real H_star_wrist_pitch_6 = Omega_wrist_pitch_xz * c->links[4].S_0_x
        + a_0_wrist_pitch_z * c->links[4].mu;

    /* wrist_pitch, v_T: velocity of the tip point (46) */
    const six_link_real v_T_wrist_pitch_y = v_T_wrist_roll_y + c->links[4].length * omega_R_wrist_pitch_z;
    const six_link_real v_T_wrist_pitch_z = v_R_wrist_pitch_z - c->links[4].length * omega_wrist_pitch_y;

    /* flange, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_real R_rel_flange_yy = six_link_cos(state->q[5]);
    const six_link_real minus_R_rel_flange_yz = six_link_sin(state->q[5]);

    /* flange, omega_R: angular velocity of the parent's tip */
    const six_link_real omega_R_flange_y = R_rel_flange_yy * omega_wrist_pitch_y
        + minus_R_rel_flange_yz * omega_R_wrist_pitch_z;
    const six_link_real omega_R_flange_z = R_rel_flange_yy * omega_R_wrist_pitch_z
        - minus_R_rel_flange_yz * omega_wrist_pitch_y;

    /* flange, omega: angular velocity of the link (45) */
    const six_link_real omega_flange_x = omega_R_wrist_pitch_x + state->v[5];

    /* flange, v_R: velocity of the joint point */
    const six_link_real v_R_flange_y = R_rel_flange_yy * v_T_wrist_pitch_y
        + minus_R_rel_flange_yz * v_T_wrist_pitch_z;
    const six_link_real v_R_flange_z = R_rel_flange_yy * v_T_wrist_pitch_z
        - minus_R_rel_flange_yz * v_T_wrist_pitch_y;

    /* flange, beta_omega: angular acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_omega_flange_y = omega_R_flange_z * state->v[5];
    const six_link_real minus_beta_omega_flange_z = omega_R_flange_y * state->v[5];

    /* flange, beta_v: acceleration that the velocities cause at the joint (accconst4) */
    const six_link_real beta_v_flange_y = state->v[5] * v_R_flange_z;
    const six_link_real minus_beta_v_flange_z = state->v[5] * v_R_flange_y;

    /* flange, a_0: acceleration of the origin at rest rates, against free fall */
    const six_link_real a_0_flange_x = omega_R_flange_y * v_R_flange_z - omega_R_flange_z * v_R_flange_y;
    const six_link_real t101 = omega_R_flange_z * v_R_wrist_pitch_x;
    const six_link_real a_0_flange_y = t101 - omega_flange_x * v_R_flange_z;
    const six_link_real t102 = omega_R_flange_y * v_R_wrist_pitch_x;
    const six_link_real a_0_flange_z = omega_flange_x * v_R_flange_y - t102;

    /* flange, Omega: centripetal operator */
    const six_link_real minus_Omega_flange_xx = omega_R_flange_y * omega_R_flange_y
        + omega_R_flange_z * omega_R_flange_z;
    const six_link_real Omega_flange_xy = omega_flange_x * omega_R_flange_y;
    const six_link_real Omega_flange_xz = omega_flange_x * omega_R_flange_z;

    /* flange, H_star: gyroscopic wrench and weight (29) */
    const six_link_real t103 = c->links[5].I_s * omega_flange_x;
    const six_link_real H_star_flange_2 = t103 * omega_R_flange_z - c->links[5].J_0_xx * Omega_flange_xz
        - c->links[5].S_0_x * a_0_flange_z;
    const six_link_real H_star_flange_3 = c->links[5].J_0_xx * Omega_flange_xy + c->links[5].S_0_x * a_0_flange_y
        - t103 * omega_R_flange_y;
    const six_link_real H_star_flange_4 = a_0_flange_x * c->links[5].mu
        - minus_Omega_flange_xx * c->links[5].S_0_x;
    const six_link_real H_star_flange_5 = Omega_flange_xy * c->links[5].S_0_x + a_0_flange_y * c->links[5].mu;
    const six_link_real H_star_flange_6 = Omega_flange_xz * c->links[5].S_0_x + a_0_flange_z * c->links[5].mu;

    /* flange, v_T: velocity of the tip point (46) */
    const six_link_real v_T_flange_y = v_R_flange_y + c->links[5].length * omega_R_flange_z;
    const six_link_real v_T_flange_z = v_R_flange_z - c->links[5].length * omega_R_flange_y;

    /* flange, a_T: acceleration of the tip point at rest rates, against free fall */
    const six_link_real a_T_flange_x = omega_R_flange_y * v_T_flange_z - omega_R_flange_z * v_T_flange_y;
    const six_link_real a_T_flange_y = t101 - omega_flange_x * v_T_flange_z;
    const six_link_real a_T_flange_z = omega_flange_x * v_T_flange_y - t102;

    /* flange, h_T_tau: moment that the bodies' velocities and weight need */
    const six_link_real t104 = c->links[5].I_T_zz * omega_R_flange_z - c->links[5].J_T_xz * omega_flange_x
        - c->links[5].J_T_yz * omega_R_flange_y;
    const six_link_real t105 = c->links[5].I_T_yy * omega_R_flange_y - c->links[5].J_T_xy * omega_flange_x
        - c->links[5].J_T_yz * omega_R_flange_z;
    const six_link_real h_T_tau_flange_x = c->links[5].S_T_y * a_T_flange_z + omega_R_flange_y * t104
        - c->links[5].S_T_z * a_T_flange_y - omega_R_flange_z * t105;
    const six_link_real t106 = c->links[5].I_T_xx * omega_flange_x - c->links[5].J_T_xy * omega_R_flange_y
        - c->links[5].J_T_xz * omega_R_flange_z;
    const six_link_real h_T_tau_flange_y = c->links[5].S_T_z * a_T_flange_x + omega_R_flange_z * t106
        - c->links[5].S_T_x * a_T_flange_z - omega_flange_x * t104;
    const six_link_real h_T_tau_flange_z = c->links[5].S_T_x * a_T_flange_y + omega_flange_x * t105
        - c->links[5].S_T_y * a_T_flange_x - omega_R_flange_y * t106;

    /* flange, h_T_F: force that the bodies' velocities and weight need */
    const six_link_real t107 = c->links[5].S_T_y * omega_flange_x - c->links[5].S_T_x * omega_R_flange_y;
    const six_link_real t108 = c->links[5].S_T_x * omega_R_flange_z - c->links[5].S_T_z * omega_flange_x;
    const six_link_real h_T_F_flange_x = a_T_flange_x * c->links[5].body0_mass + omega_R_flange_y * t107
        - omega_R_flange_z * t108;
    const six_link_real t109 = c->links[5].S_T_z * omega_R_flange_y - c->links[5].S_T_y * omega_R_flange_z;
    const six_link_real h_T_F_flange_y = a_T_flange_y * c->links[5].body0_mass + omega_R_flange_z * t109
        - omega_flange_x * t107;
    const six_link_real h_T_F_flange_z = a_T_flange_z * c->links[5].body0_mass + omega_flange_x * t108
        - omega_R_flange_y * t109;

    /* flange, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_flange_1 = h_T_tau_flange_x - input->w_ext[5][0];
    const six_link_real p_T_flange_2 = h_T_tau_flange_y - input->w_ext[5][1];
    const six_link_real p_T_flange_3 = h_T_tau_flange_z - input->w_ext[5][2];
    const six_link_real p_T_flange_4 = h_T_F_flange_x - input->w_ext[5][3];
    const six_link_real p_T_flange_5 = h_T_F_flange_y - input->w_ext[5][4];
    const six_link_real p_T_flange_6 = h_T_F_flange_z - input->w_ext[5][5];

    /* flange, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t110 = c->links[5].S_T_x + c->links[5].length * c->links[5].body0_mass;
    const six_link_real t111 = c->links[5].S_T_x * c->links[5].length;
    const six_link_real t112 = c->links[5].length * t110;
    const six_link_real minus_M_loaded_flange_12 = c->links[5].J_T_xy + c->links[5].S_T_y * c->links[5].length;
    const six_link_real minus_M_loaded_flange_13 = c->links[5].J_T_xz + c->links[5].S_T_z * c->links[5].length;
    const six_link_real M_loaded_flange_11 = c->links[5].I_s + c->links[5].I_T_xx;
    const six_link_real M_loaded_flange_22 = c->links[5].J_0_xx + (c->links[5].I_T_yy + t111 + t112);
    const six_link_real minus_M_loaded_flange_26 = t110 + c->links[5].S_0_x;
    const six_link_real M_loaded_flange_33 = c->links[5].J_0_xx + (c->links[5].I_T_zz + t111 + t112);
    const six_link_real M_loaded_flange_44 = c->links[5].mu + c->links[5].body0_mass;
    const six_link_real h_loaded_flange_2 = H_star_flange_2 + (p_T_flange_2 - c->links[5].length * p_T_flange_6);
    const six_link_real h_loaded_flange_3 = H_star_flange_3 + (p_T_flange_3 + c->links[5].length * p_T_flange_5);
    const six_link_real h_loaded_flange_4 = H_star_flange_4 + p_T_flange_4;
    const six_link_real h_loaded_flange_5 = H_star_flange_5 + p_T_flange_5;
    const six_link_real h_loaded_flange_6 = H_star_flange_6 + p_T_flange_6;

    /* flange, joint: its accelerations eliminated from its rows (43) */
    const six_link_real t113 = minus_M_loaded_flange_13 * minus_beta_omega_flange_z
        - minus_M_loaded_flange_12 * beta_omega_flange_y;
    const six_link_real t114 = M_loaded_flange_22 * beta_omega_flange_y
        + c->links[5].J_T_yz * minus_beta_omega_flange_z + minus_M_loaded_flange_26 * minus_beta_v_flange_z;
    const six_link_real t115 = minus_M_loaded_flange_26 * beta_v_flange_y
        - (c->links[5].J_T_yz * beta_omega_flange_y + M_loaded_flange_33 * minus_beta_omega_flange_z);
    const six_link_real bias_flange_1 = p_T_flange_1
        + (t113 - c->links[5].S_T_z * beta_v_flange_y - c->links[5].S_T_y * minus_beta_v_flange_z);
    const six_link_real bias_flange_2 = h_loaded_flange_2 + t114;
    const six_link_real bias_flange_3 = h_loaded_flange_3 + t115;
    const six_link_real bias_flange_4 = h_loaded_flange_4
        + (c->links[5].S_T_z * beta_omega_flange_y + c->links[5].S_T_y * minus_beta_omega_flange_z);
    const six_link_real bias_flange_5 = h_loaded_flange_5
        + (M_loaded_flange_44 * beta_v_flange_y - minus_M_loaded_flange_26 * minus_beta_omega_flange_z);
    const six_link_real bias_flange_6 = h_loaded_flange_6
        - (minus_M_loaded_flange_26 * beta_omega_flange_y + M_loaded_flange_44 * minus_beta_v_flange_z);
    const six_link_real joint_inertia_flange_11 = M_loaded_flange_11 + c->links[5].armature_1;
    const six_link_real t116 = SIX_LINK_REAL_EPSILON * 8;
    bad |= (unsigned long)(!(joint_inertia_flange_11 - t116 * (M_loaded_flange_11 + M_loaded_flange_22 + M_loaded_flange_33) > 0)) << 5;
    const six_link_real joint_inverse_flange_1 = 1 / joint_inertia_flange_11;
    const six_link_real joint_W_flange_11 = M_loaded_flange_11 * joint_inverse_flange_1;
    const six_link_real minus_joint_W_flange_12 = minus_M_loaded_flange_12 * joint_inverse_flange_1;
    const six_link_real minus_joint_W_flange_13 = minus_M_loaded_flange_13 * joint_inverse_flange_1;
    const six_link_real minus_joint_W_flange_15 = c->links[5].S_T_z * joint_inverse_flange_1;
    const six_link_real joint_W_flange_16 = c->links[5].S_T_y * joint_inverse_flange_1;
    const six_link_real joint_w_flange_1 = (input->tau[5] - c->links[5].joint_damping_1 * state->v[5]
        - bias_flange_1) * joint_inverse_flange_1;
    const six_link_real Lambda_i_flange_11 = M_loaded_flange_11 - M_loaded_flange_11 * joint_W_flange_11;
    const six_link_real Lambda_i_flange_12 = M_loaded_flange_11 * minus_joint_W_flange_12
        - minus_M_loaded_flange_12;
    const six_link_real Lambda_i_flange_13 = M_loaded_flange_11 * minus_joint_W_flange_13
        - minus_M_loaded_flange_13;
    const six_link_real Lambda_i_flange_15 = M_loaded_flange_11 * minus_joint_W_flange_15 - c->links[5].S_T_z;
    const six_link_real Lambda_i_flange_16 = c->links[5].S_T_y - M_loaded_flange_11 * joint_W_flange_16;
    const six_link_real Lambda_i_flange_22 = M_loaded_flange_22
        - minus_M_loaded_flange_12 * minus_joint_W_flange_12;
    const six_link_real minus_Lambda_i_flange_23 = c->links[5].J_T_yz
        + minus_M_loaded_flange_12 * minus_joint_W_flange_13;
    const six_link_real minus_Lambda_i_flange_25 = minus_M_loaded_flange_12 * minus_joint_W_flange_15;
    const six_link_real Lambda_i_flange_26 = minus_M_loaded_flange_12 * joint_W_flange_16
        - minus_M_loaded_flange_26;
    const six_link_real Lambda_i_flange_33 = M_loaded_flange_33
        - minus_M_loaded_flange_13 * minus_joint_W_flange_13;
    const six_link_real Lambda_i_flange_35 = minus_M_loaded_flange_26
        - minus_M_loaded_flange_13 * minus_joint_W_flange_15;
    const six_link_real Lambda_i_flange_36 = minus_M_loaded_flange_13 * joint_W_flange_16;
    const six_link_real Lambda_i_flange_55 = M_loaded_flange_44 - c->links[5].S_T_z * minus_joint_W_flange_15;
    const six_link_real Lambda_i_flange_56 = c->links[5].S_T_z * joint_W_flange_16;
    const six_link_real Lambda_i_flange_66 = M_loaded_flange_44 - c->links[5].S_T_y * joint_W_flange_16;
    const six_link_real p_i_flange_1 = bias_flange_1 + M_loaded_flange_11 * joint_w_flange_1;
    const six_link_real p_i_flange_2 = bias_flange_2 - minus_M_loaded_flange_12 * joint_w_flange_1;
    const six_link_real p_i_flange_3 = bias_flange_3 - minus_M_loaded_flange_13 * joint_w_flange_1;
    const six_link_real p_i_flange_5 = bias_flange_5 - c->links[5].S_T_z * joint_w_flange_1;
    const six_link_real p_i_flange_6 = bias_flange_6 + c->links[5].S_T_y * joint_w_flange_1;

    /* flange, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real Lambda_flange_2 = Lambda_i_flange_12 * R_rel_flange_yy
        - Lambda_i_flange_13 * minus_R_rel_flange_yz;
    const six_link_real Lambda_flange_3 = Lambda_i_flange_12 * minus_R_rel_flange_yz
        + Lambda_i_flange_13 * R_rel_flange_yy;
    const six_link_real t117 = minus_Lambda_i_flange_23 * minus_R_rel_flange_yz;
    const six_link_real t118 = minus_Lambda_i_flange_23 * R_rel_flange_yy;
    const six_link_real t119 = Lambda_i_flange_22 * minus_R_rel_flange_yz - t118;
    const six_link_real t120 = Lambda_i_flange_33 * R_rel_flange_yy - t117;
    const six_link_real Lambda_flange_7 = R_rel_flange_yy * (Lambda_i_flange_22 * R_rel_flange_yy + t117)
        + minus_R_rel_flange_yz * (t118 + Lambda_i_flange_33 * minus_R_rel_flange_yz);
    const six_link_real Lambda_flange_8 = R_rel_flange_yy * t119 - minus_R_rel_flange_yz * t120;
    const six_link_real Lambda_flange_12 = minus_R_rel_flange_yz * t119 + R_rel_flange_yy * t120;
    const six_link_real Lambda_flange_5 = Lambda_i_flange_15 * R_rel_flange_yy
        - Lambda_i_flange_16 * minus_R_rel_flange_yz;
    const six_link_real Lambda_flange_6 = Lambda_i_flange_15 * minus_R_rel_flange_yz
        + Lambda_i_flange_16 * R_rel_flange_yy;
    const six_link_real t121 = minus_Lambda_i_flange_25 * R_rel_flange_yy
        + Lambda_i_flange_26 * minus_R_rel_flange_yz;
    const six_link_real t122 = Lambda_i_flange_26 * R_rel_flange_yy
        - minus_Lambda_i_flange_25 * minus_R_rel_flange_yz;
    const six_link_real t123 = Lambda_i_flange_35 * R_rel_flange_yy - Lambda_i_flange_36 * minus_R_rel_flange_yz;
    const six_link_real t124 = Lambda_i_flange_35 * minus_R_rel_flange_yz + Lambda_i_flange_36 * R_rel_flange_yy;
    const six_link_real Lambda_flange_9 = R_rel_flange_yy * c->links[5].S_T_z
        + minus_R_rel_flange_yz * c->links[5].S_T_y;
    const six_link_real minus_Lambda_flange_10 = R_rel_flange_yy * t121 + minus_R_rel_flange_yz * t123;
    const six_link_real Lambda_flange_11 = R_rel_flange_yy * t122 - minus_R_rel_flange_yz * t124;
    const six_link_real Lambda_flange_13 = minus_R_rel_flange_yz * c->links[5].S_T_z
        - R_rel_flange_yy * c->links[5].S_T_y;
    const six_link_real Lambda_flange_14 = R_rel_flange_yy * t123 - minus_R_rel_flange_yz * t121;
    const six_link_real Lambda_flange_15 = minus_R_rel_flange_yz * t122 + R_rel_flange_yy * t124;
    const six_link_real t125 = Lambda_i_flange_56 * minus_R_rel_flange_yz;
    const six_link_real t126 = Lambda_i_flange_56 * R_rel_flange_yy;
    const six_link_real t127 = Lambda_i_flange_55 * minus_R_rel_flange_yz + t126;
    const six_link_real t128 = t125 + Lambda_i_flange_66 * R_rel_flange_yy;
    const six_link_real Lambda_flange_19 = R_rel_flange_yy * (Lambda_i_flange_55 * R_rel_flange_yy - t125)
        - minus_R_rel_flange_yz * (t126 - Lambda_i_flange_66 * minus_R_rel_flange_yz);
    const six_link_real Lambda_flange_20 = R_rel_flange_yy * t127 - minus_R_rel_flange_yz * t128;
    const six_link_real Lambda_flange_21 = minus_R_rel_flange_yz * t127 + R_rel_flange_yy * t128;
    const six_link_real p_flange_2 = R_rel_flange_yy * p_i_flange_2 - minus_R_rel_flange_yz * p_i_flange_3;
    const six_link_real p_flange_3 = minus_R_rel_flange_yz * p_i_flange_2 + R_rel_flange_yy * p_i_flange_3;
    const six_link_real p_flange_5 = R_rel_flange_yy * p_i_flange_5 - minus_R_rel_flange_yz * p_i_flange_6;
    const six_link_real p_flange_6 = minus_R_rel_flange_yz * p_i_flange_5 + R_rel_flange_yy * p_i_flange_6;

    /* wrist_pitch, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_wrist_pitch_1 = p_i_flange_1 - input->w_ext[4][0];
    const six_link_real p_T_wrist_pitch_2 = p_flange_2 - input->w_ext[4][1];
    const six_link_real p_T_wrist_pitch_3 = p_flange_3 - input->w_ext[4][2];
    const six_link_real p_T_wrist_pitch_4 = bias_flange_4 - input->w_ext[4][3];
    const six_link_real p_T_wrist_pitch_5 = p_flange_5 - input->w_ext[4][4];
    const six_link_real p_T_wrist_pitch_6 = p_flange_6 - input->w_ext[4][5];

    /* wrist_pitch, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t129 = c->links[4].length * Lambda_flange_20;
    const six_link_real minus_M_loaded_wrist_pitch_25 = minus_Lambda_flange_10 + t129;
    const six_link_real t130 = Lambda_flange_11 - c->links[4].length * Lambda_flange_21;
    const six_link_real t131 = Lambda_flange_14 + c->links[4].length * Lambda_flange_19;
    const six_link_real M_loaded_wrist_pitch_36 = Lambda_flange_15 + t129;
    const six_link_real M_loaded_wrist_pitch_12 = Lambda_flange_2 - Lambda_flange_6 * c->links[4].length;
    const six_link_real M_loaded_wrist_pitch_13 = Lambda_flange_3 + Lambda_flange_5 * c->links[4].length;
    const six_link_real M_loaded_wrist_pitch_23 = Lambda_flange_8 - minus_Lambda_flange_10 * c->links[4].length
        - c->links[4].length * M_loaded_wrist_pitch_36;
    const six_link_real M_loaded_wrist_pitch_11 = c->links[4].I_s + Lambda_i_flange_11;
    const six_link_real M_loaded_wrist_pitch_22 = c->links[4].J_0_xx
        + (Lambda_flange_7 - Lambda_flange_11 * c->links[4].length - c->links[4].length * t130);
    const six_link_real M_loaded_wrist_pitch_26 = t130 - c->links[4].S_0_x;
    const six_link_real M_loaded_wrist_pitch_33 = c->links[4].J_0_xx
        + (Lambda_flange_12 + Lambda_flange_14 * c->links[4].length + c->links[4].length * t131);
    const six_link_real M_loaded_wrist_pitch_35 = c->links[4].S_0_x + t131;
    const six_link_real M_loaded_wrist_pitch_44 = c->links[4].mu + M_loaded_flange_44;
    const six_link_real M_loaded_wrist_pitch_55 = c->links[4].mu + Lambda_flange_19;
    const six_link_real M_loaded_wrist_pitch_66 = c->links[4].mu + Lambda_flange_21;
    const six_link_real h_loaded_wrist_pitch_2 = H_star_wrist_pitch_2
        + (p_T_wrist_pitch_2 - c->links[4].length * p_T_wrist_pitch_6);
    const six_link_real h_loaded_wrist_pitch_3 = H_star_wrist_pitch_3
        + (p_T_wrist_pitch_3 + c->links[4].length * p_T_wrist_pitch_5);
    const six_link_real h_loaded_wrist_pitch_4 = H_star_wrist_pitch_4 + p_T_wrist_pitch_4;
    const six_link_real h_loaded_wrist_pitch_5 = H_star_wrist_pitch_5 + p_T_wrist_pitch_5;
    const six_link_real h_loaded_wrist_pitch_6 = H_star_wrist_pitch_6 + p_T_wrist_pitch_6;

    /* wrist_pitch, joint: its accelerations eliminated from its rows (43) */
    const six_link_real t132 = M_loaded_wrist_pitch_13 * beta_omega_wrist_pitch_z
        - M_loaded_wrist_pitch_11 * minus_beta_omega_wrist_pitch_x;
    const six_link_real t133 = M_loaded_wrist_pitch_23 * beta_omega_wrist_pitch_z
        - M_loaded_wrist_pitch_12 * minus_beta_omega_wrist_pitch_x;
    const six_link_real t134 = t133 - Lambda_flange_9 * minus_beta_v_wrist_pitch_x
        + M_loaded_wrist_pitch_26 * beta_v_wrist_pitch_z;
    const six_link_real t135 = M_loaded_wrist_pitch_33 * beta_omega_wrist_pitch_z
        - M_loaded_wrist_pitch_13 * minus_beta_omega_wrist_pitch_x;
    const six_link_real t136 = t135 - Lambda_flange_13 * minus_beta_v_wrist_pitch_x
        + M_loaded_wrist_pitch_36 * beta_v_wrist_pitch_z;
    const six_link_real t137 = Lambda_flange_13 * beta_omega_wrist_pitch_z
        - M_loaded_wrist_pitch_44 * minus_beta_v_wrist_pitch_x;
    const six_link_real t138 = M_loaded_wrist_pitch_35 * beta_omega_wrist_pitch_z
        - Lambda_flange_5 * minus_beta_omega_wrist_pitch_x;
    const six_link_real t139 = M_loaded_wrist_pitch_36 * beta_omega_wrist_pitch_z
        - Lambda_flange_6 * minus_beta_omega_wrist_pitch_x;
    const six_link_real bias_wrist_pitch_1 = p_T_wrist_pitch_1 + (t132 + Lambda_flange_6 * beta_v_wrist_pitch_z);
    const six_link_real bias_wrist_pitch_2 = h_loaded_wrist_pitch_2 + t134;
    const six_link_real bias_wrist_pitch_3 = h_loaded_wrist_pitch_3 + t136;
    const six_link_real bias_wrist_pitch_4 = h_loaded_wrist_pitch_4 + t137;
    const six_link_real bias_wrist_pitch_5 = h_loaded_wrist_pitch_5
        + (t138 + Lambda_flange_20 * beta_v_wrist_pitch_z);
    const six_link_real bias_wrist_pitch_6 = h_loaded_wrist_pitch_6
        + (t139 + M_loaded_wrist_pitch_66 * beta_v_wrist_pitch_z);
    const six_link_real joint_inertia_wrist_pitch_11 = M_loaded_wrist_pitch_22 + c->links[4].armature_1;
    bad |= (unsigned long)(!(joint_inertia_wrist_pitch_11 - t116 * (M_loaded_wrist_pitch_11 + M_loaded_wrist_pitch_22 + M_loaded_wrist_pitch_33) > 0)) << 4;
    const six_link_real joint_inverse_wrist_pitch_1 = 1 / joint_inertia_wrist_pitch_11;
    const six_link_real joint_W_wrist_pitch_11 = M_loaded_wrist_pitch_12 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_12 = M_loaded_wrist_pitch_22 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_13 = M_loaded_wrist_pitch_23 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_14 = Lambda_flange_9 * joint_inverse_wrist_pitch_1;
    const six_link_real minus_joint_W_wrist_pitch_15 = minus_M_loaded_wrist_pitch_25
        * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_16 = M_loaded_wrist_pitch_26 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_w_wrist_pitch_1 = (input->tau[4] - c->links[4].joint_damping_1 * state->v[4]
        - bias_wrist_pitch_2) * joint_inverse_wrist_pitch_1;
    const six_link_real Lambda_i_wrist_pitch_11 = M_loaded_wrist_pitch_11
        - M_loaded_wrist_pitch_12 * joint_W_wrist_pitch_11;
    const six_link_real Lambda_i_wrist_pitch_12 = M_loaded_wrist_pitch_12
        - M_loaded_wrist_pitch_12 * joint_W_wrist_pitch_12;
    const six_link_real Lambda_i_wrist_pitch_13 = M_loaded_wrist_pitch_13
        - M_loaded_wrist_pitch_12 * joint_W_wrist_pitch_13;
    const six_link_real minus_Lambda_i_wrist_pitch_14 = M_loaded_wrist_pitch_12 * joint_W_wrist_pitch_14;
    const six_link_real Lambda_i_wrist_pitch_15 = Lambda_flange_5
        + M_loaded_wrist_pitch_12 * minus_joint_W_wrist_pitch_15;
    const six_link_real Lambda_i_wrist_pitch_16 = Lambda_flange_6
        - M_loaded_wrist_pitch_12 * joint_W_wrist_pitch_16;
    const six_link_real Lambda_i_wrist_pitch_22 = M_loaded_wrist_pitch_22
        - M_loaded_wrist_pitch_22 * joint_W_wrist_pitch_12;
    const six_link_real Lambda_i_wrist_pitch_23 = M_loaded_wrist_pitch_23
        - M_loaded_wrist_pitch_22 * joint_W_wrist_pitch_13;
    const six_link_real Lambda_i_wrist_pitch_24 = Lambda_flange_9
        - M_loaded_wrist_pitch_22 * joint_W_wrist_pitch_14;
    const six_link_real Lambda_i_wrist_pitch_25 = M_loaded_wrist_pitch_22 * minus_joint_W_wrist_pitch_15
        - minus_M_loaded_wrist_pitch_25;
    const six_link_real Lambda_i_wrist_pitch_26 = M_loaded_wrist_pitch_26
        - M_loaded_wrist_pitch_22 * joint_W_wrist_pitch_16;
    const six_link_real Lambda_i_wrist_pitch_33 = M_loaded_wrist_pitch_33
        - M_loaded_wrist_pitch_23 * joint_W_wrist_pitch_13;
    const six_link_real Lambda_i_wrist_pitch_34 = Lambda_flange_13
        - M_loaded_wrist_pitch_23 * joint_W_wrist_pitch_14;
    const six_link_real Lambda_i_wrist_pitch_35 = M_loaded_wrist_pitch_35
        + M_loaded_wrist_pitch_23 * minus_joint_W_wrist_pitch_15;
    const six_link_real Lambda_i_wrist_pitch_36 = M_loaded_wrist_pitch_36
        - M_loaded_wrist_pitch_23 * joint_W_wrist_pitch_16;
    const six_link_real Lambda_i_wrist_pitch_44 = M_loaded_wrist_pitch_44
        - Lambda_flange_9 * joint_W_wrist_pitch_14;
    const six_link_real Lambda_i_wrist_pitch_45 = Lambda_flange_9 * minus_joint_W_wrist_pitch_15;
    const six_link_real minus_Lambda_i_wrist_pitch_46 = Lambda_flange_9 * joint_W_wrist_pitch_16;
    const six_link_real Lambda_i_wrist_pitch_55 = M_loaded_wrist_pitch_55
        - minus_M_loaded_wrist_pitch_25 * minus_joint_W_wrist_pitch_15;
    const six_link_real Lambda_i_wrist_pitch_56 = Lambda_flange_20
        + minus_M_loaded_wrist_pitch_25 * joint_W_wrist_pitch_16;
    const six_link_real Lambda_i_wrist_pitch_66 = M_loaded_wrist_pitch_66
        - M_loaded_wrist_pitch_26 * joint_W_wrist_pitch_16;
    const six_link_real p_i_wrist_pitch_1 = bias_wrist_pitch_1 + M_loaded_wrist_pitch_12 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_2 = bias_wrist_pitch_2 + M_loaded_wrist_pitch_22 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_3 = bias_wrist_pitch_3 + M_loaded_wrist_pitch_23 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_4 = bias_wrist_pitch_4 + Lambda_flange_9 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_5 = bias_wrist_pitch_5
        - minus_M_loaded_wrist_pitch_25 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_6 = bias_wrist_pitch_6 + M_loaded_wrist_pitch_26 * joint_w_wrist_pitch_1;

    /* wrist_pitch, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t140 = Lambda_i_wrist_pitch_13 * R_rel_wrist_pitch_xz;
    const six_link_real t141 = Lambda_i_wrist_pitch_13 * R_rel_wrist_pitch_xx;
    const six_link_real t142 = t141 - Lambda_i_wrist_pitch_11 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_2 = Lambda_i_wrist_pitch_12 * R_rel_wrist_pitch_xx
        + Lambda_i_wrist_pitch_23 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_8 = Lambda_i_wrist_pitch_23 * R_rel_wrist_pitch_xx
        - Lambda_i_wrist_pitch_12 * R_rel_wrist_pitch_xz;
    const six_link_real t143 = Lambda_i_wrist_pitch_33 * R_rel_wrist_pitch_xx - t140;
    const six_link_real Lambda_wrist_pitch_1 = R_rel_wrist_pitch_xx
        * (Lambda_i_wrist_pitch_11 * R_rel_wrist_pitch_xx + t140)
        + R_rel_wrist_pitch_xz * (t141 + Lambda_i_wrist_pitch_33 * R_rel_wrist_pitch_xz);
    const six_link_real Lambda_wrist_pitch_3 = R_rel_wrist_pitch_xx * t142 + R_rel_wrist_pitch_xz * t143;
    const six_link_real Lambda_wrist_pitch_12 = R_rel_wrist_pitch_xx * t143 - R_rel_wrist_pitch_xz * t142;
    const six_link_real t144 = Lambda_i_wrist_pitch_16 * R_rel_wrist_pitch_xz
        - minus_Lambda_i_wrist_pitch_14 * R_rel_wrist_pitch_xx;
    const six_link_real t145 = Lambda_i_wrist_pitch_16 * R_rel_wrist_pitch_xx
        + minus_Lambda_i_wrist_pitch_14 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_9 = Lambda_i_wrist_pitch_24 * R_rel_wrist_pitch_xx
        + Lambda_i_wrist_pitch_26 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_11 = Lambda_i_wrist_pitch_26 * R_rel_wrist_pitch_xx
        - Lambda_i_wrist_pitch_24 * R_rel_wrist_pitch_xz;
    const six_link_real t146 = Lambda_i_wrist_pitch_34 * R_rel_wrist_pitch_xx
        + Lambda_i_wrist_pitch_36 * R_rel_wrist_pitch_xz;
    const six_link_real t147 = Lambda_i_wrist_pitch_36 * R_rel_wrist_pitch_xx
        - Lambda_i_wrist_pitch_34 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_4 = R_rel_wrist_pitch_xx * t144 + R_rel_wrist_pitch_xz * t146;
    const six_link_real Lambda_wrist_pitch_5 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_15
        + R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_35;
    const six_link_real Lambda_wrist_pitch_6 = R_rel_wrist_pitch_xx * t145 + R_rel_wrist_pitch_xz * t147;
    const six_link_real Lambda_wrist_pitch_13 = R_rel_wrist_pitch_xx * t146 - R_rel_wrist_pitch_xz * t144;
    const six_link_real Lambda_wrist_pitch_14 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_35
        - R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_15;
    const six_link_real Lambda_wrist_pitch_15 = R_rel_wrist_pitch_xx * t147 - R_rel_wrist_pitch_xz * t145;
    const six_link_real t148 = minus_Lambda_i_wrist_pitch_46 * R_rel_wrist_pitch_xz;
    const six_link_real t149 = minus_Lambda_i_wrist_pitch_46 * R_rel_wrist_pitch_xx;
    const six_link_real t150 = t149 + Lambda_i_wrist_pitch_44 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_17 = Lambda_i_wrist_pitch_45 * R_rel_wrist_pitch_xx
        + Lambda_i_wrist_pitch_56 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_20 = Lambda_i_wrist_pitch_56 * R_rel_wrist_pitch_xx
        - Lambda_i_wrist_pitch_45 * R_rel_wrist_pitch_xz;
    const six_link_real t151 = Lambda_i_wrist_pitch_66 * R_rel_wrist_pitch_xx + t148;
    const six_link_real Lambda_wrist_pitch_16 = R_rel_wrist_pitch_xx
        * (Lambda_i_wrist_pitch_44 * R_rel_wrist_pitch_xx - t148)
        + R_rel_wrist_pitch_xz * (Lambda_i_wrist_pitch_66 * R_rel_wrist_pitch_xz - t149);
    const six_link_real Lambda_wrist_pitch_18 = R_rel_wrist_pitch_xz * t151 - R_rel_wrist_pitch_xx * t150;
    const six_link_real Lambda_wrist_pitch_21 = R_rel_wrist_pitch_xx * t151 + R_rel_wrist_pitch_xz * t150;
    const six_link_real p_wrist_pitch_1 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_1
        + R_rel_wrist_pitch_xz * p_i_wrist_pitch_3;
    const six_link_real p_wrist_pitch_3 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_3
        - R_rel_wrist_pitch_xz * p_i_wrist_pitch_1;
    const six_link_real p_wrist_pitch_4 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_4
        + R_rel_wrist_pitch_xz * p_i_wrist_pitch_6;
    const six_link_real p_wrist_pitch_6 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_6
        - R_rel_wrist_pitch_xz * p_i_wrist_pitch_4;

    /* wrist_roll, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_wrist_roll_1 = p_wrist_pitch_1 - input->w_ext[3][0];
    const six_link_real p_T_wrist_roll_2 = p_i_wrist_pitch_2 - input->w_ext[3][1];
    const six_link_real p_T_wrist_roll_3 = p_wrist_pitch_3 - input->w_ext[3][2];
    const six_link_real p_T_wrist_roll_4 = p_wrist_pitch_4 - input->w_ext[3][3];
    const six_link_real p_T_wrist_roll_5 = p_i_wrist_pitch_5 - input->w_ext[3][4];
    const six_link_real p_T_wrist_roll_6 = p_wrist_pitch_6 - input->w_ext[3][5];

    /* wrist_roll, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t152 = c->links[3].length * Lambda_wrist_pitch_20;
    const six_link_real M_loaded_wrist_roll_24 = Lambda_wrist_pitch_9
        - c->links[3].length * Lambda_wrist_pitch_18;
    const six_link_real M_loaded_wrist_roll_25 = Lambda_i_wrist_pitch_25 - t152;
    const six_link_real t153 = Lambda_wrist_pitch_11 - c->links[3].length * Lambda_wrist_pitch_21;
    const six_link_real M_loaded_wrist_roll_34 = Lambda_wrist_pitch_13
        + c->links[3].length * Lambda_wrist_pitch_17;
    const six_link_real t154 = Lambda_wrist_pitch_14 + c->links[3].length * Lambda_i_wrist_pitch_55;
    const six_link_real M_loaded_wrist_roll_36 = Lambda_wrist_pitch_15 + t152;
    const six_link_real M_loaded_wrist_roll_12 = Lambda_wrist_pitch_2 - Lambda_wrist_pitch_6 * c->links[3].length;
    const six_link_real M_loaded_wrist_roll_13 = Lambda_wrist_pitch_3 + Lambda_wrist_pitch_5 * c->links[3].length;
    const six_link_real M_loaded_wrist_roll_23 = Lambda_wrist_pitch_8
        + Lambda_i_wrist_pitch_25 * c->links[3].length - c->links[3].length * M_loaded_wrist_roll_36;
    const six_link_real M_loaded_wrist_roll_11 = c->links[3].I_s + Lambda_wrist_pitch_1;
    const six_link_real M_loaded_wrist_roll_22 = c->links[3].J_0_xx
        + (Lambda_i_wrist_pitch_22 - Lambda_wrist_pitch_11 * c->links[3].length - c->links[3].length * t153);
    const six_link_real M_loaded_wrist_roll_26 = t153 - c->links[3].S_0_x;
    const six_link_real M_loaded_wrist_roll_33 = c->links[3].J_0_xx
        + (Lambda_wrist_pitch_12 + Lambda_wrist_pitch_14 * c->links[3].length + c->links[3].length * t154);
    const six_link_real M_loaded_wrist_roll_35 = c->links[3].S_0_x + t154;
    const six_link_real M_loaded_wrist_roll_44 = c->links[3].mu + Lambda_wrist_pitch_16;
    const six_link_real M_loaded_wrist_roll_55 = c->links[3].mu + Lambda_i_wrist_pitch_55;
    const six_link_real M_loaded_wrist_roll_66 = c->links[3].mu + Lambda_wrist_pitch_21;
    const six_link_real h_loaded_wrist_roll_2 = H_star_wrist_roll_2
        + (p_T_wrist_roll_2 - c->links[3].length * p_T_wrist_roll_6);
    const six_link_real h_loaded_wrist_roll_3 = H_star_wrist_roll_3
        + (p_T_wrist_roll_3 + c->links[3].length * p_T_wrist_roll_5);
    const six_link_real h_loaded_wrist_roll_4 = H_star_wrist_roll_4 + p_T_wrist_roll_4;
    const six_link_real h_loaded_wrist_roll_5 = H_star_wrist_roll_5 + p_T_wrist_roll_5;
    const six_link_real h_loaded_wrist_roll_6 = H_star_wrist_roll_6 + p_T_wrist_roll_6;

    /* wrist_roll, joint: its accelerations eliminated from its rows (43) */
    const six_link_real t155 = M_loaded_wrist_roll_12 * beta_omega_wrist_roll_y
        - M_loaded_wrist_roll_13 * minus_beta_omega_wrist_roll_z;
    const six_link_real t156 = t155 + Lambda_wrist_pitch_5 * beta_v_wrist_roll_y
        - Lambda_wrist_pitch_6 * minus_beta_v_wrist_roll_z;
    const six_link_real t157 = M_loaded_wrist_roll_22 * beta_omega_wrist_roll_y
        - M_loaded_wrist_roll_23 * minus_beta_omega_wrist_roll_z;
    const six_link_real t158 = t157 + M_loaded_wrist_roll_25 * beta_v_wrist_roll_y
        - M_loaded_wrist_roll_26 * minus_beta_v_wrist_roll_z;
    const six_link_real t159 = M_loaded_wrist_roll_23 * beta_omega_wrist_roll_y
        - M_loaded_wrist_roll_33 * minus_beta_omega_wrist_roll_z;
    const six_link_real t160 = t159 + M_loaded_wrist_roll_35 * beta_v_wrist_roll_y
        - M_loaded_wrist_roll_36 * minus_beta_v_wrist_roll_z;
    const six_link_real t161 = M_loaded_wrist_roll_24 * beta_omega_wrist_roll_y
        - M_loaded_wrist_roll_34 * minus_beta_omega_wrist_roll_z;
    const six_link_real t162 = t161 + Lambda_wrist_pitch_17 * beta_v_wrist_roll_y
        - Lambda_wrist_pitch_18 * minus_beta_v_wrist_roll_z;
    const six_link_real t163 = M_loaded_wrist_roll_25 * beta_omega_wrist_roll_y
        - M_loaded_wrist_roll_35 * minus_beta_omega_wrist_roll_z;
    const six_link_real t164 = t163 + M_loaded_wrist_roll_55 * beta_v_wrist_roll_y
        - Lambda_wrist_pitch_20 * minus_beta_v_wrist_roll_z;
    const six_link_real t165 = M_loaded_wrist_roll_26 * beta_omega_wrist_roll_y
        - M_loaded_wrist_roll_36 * minus_beta_omega_wrist_roll_z;
    const six_link_real t166 = t165 + Lambda_wrist_pitch_20 * beta_v_wrist_roll_y
        - M_loaded_wrist_roll_66 * minus_beta_v_wrist_roll_z;
    const six_link_real bias_wrist_roll_1 = p_T_wrist_roll_1 + t156;
    const six_link_real bias_wrist_roll_2 = h_loaded_wrist_roll_2 + t158;
    const six_link_real bias_wrist_roll_3 = h_loaded_wrist_roll_3 + t160;
    const six_link_real bias_wrist_roll_4 = h_loaded_wrist_roll_4 + t162;
    const six_link_real bias_wrist_roll_5 = h_loaded_wrist_roll_5 + t164;
    const six_link_real bias_wrist_roll_6 = h_loaded_wrist_roll_6 + t166;
    const six_link_real joint_inertia_wrist_roll_11 = M_loaded_wrist_roll_11 + c->links[3].armature_1;
    bad |= (unsigned long)(!(joint_inertia_wrist_roll_11 - t116 * (M_loaded_wrist_roll_11 + M_loaded_wrist_roll_22 + M_loaded_wrist_roll_33) > 0)) << 3;
    const six_link_real joint_inverse_wrist_roll_1 = 1 / joint_inertia_wrist_roll_11;
    const six_link_real joint_W_wrist_roll_11 = M_loaded_wrist_roll_11 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_12 = M_loaded_wrist_roll_12 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_13 = M_loaded_wrist_roll_13 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_14 = Lambda_wrist_pitch_4 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_15 = Lambda_wrist_pitch_5 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_16 = Lambda_wrist_pitch_6 * joint_inverse_wrist_roll_1;
    const six_link_real joint_w_wrist_roll_1 = (input->tau[3] - c->links[3].joint_damping_1 * state->v[3]
        - bias_wrist_roll_1) * joint_inverse_wrist_roll_1;
    const six_link_real Lambda_i_wrist_roll_11 = M_loaded_wrist_roll_11
        - M_loaded_wrist_roll_11 * joint_W_wrist_roll_11;
    const six_link_real Lambda_i_wrist_roll_12 = M_loaded_wrist_roll_12
        - M_loaded_wrist_roll_11 * joint_W_wrist_roll_12;
    const six_link_real Lambda_i_wrist_roll_13 = M_loaded_wrist_roll_13
        - M_loaded_wrist_roll_11 * joint_W_wrist_roll_13;
    const six_link_real Lambda_i_wrist_roll_14 = Lambda_wrist_pitch_4
        - M_loaded_wrist_roll_11 * joint_W_wrist_roll_14;
    const six_link_real Lambda_i_wrist_roll_15 = Lambda_wrist_pitch_5
        - M_loaded_wrist_roll_11 * joint_W_wrist_roll_15;
    const six_link_real Lambda_i_wrist_roll_16 = Lambda_wrist_pitch_6
        - M_loaded_wrist_roll_11 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_22 = M_loaded_wrist_roll_22
        - M_loaded_wrist_roll_12 * joint_W_wrist_roll_12;
    const six_link_real Lambda_i_wrist_roll_23 = M_loaded_wrist_roll_23
        - M_loaded_wrist_roll_12 * joint_W_wrist_roll_13;
    const six_link_real Lambda_i_wrist_roll_24 = M_loaded_wrist_roll_24
        - M_loaded_wrist_roll_12 * joint_W_wrist_roll_14;
    const six_link_real Lambda_i_wrist_roll_25 = M_loaded_wrist_roll_25
        - M_loaded_wrist_roll_12 * joint_W_wrist_roll_15;
    const six_link_real Lambda_i_wrist_roll_26 = M_loaded_wrist_roll_26
        - M_loaded_wrist_roll_12 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_33 = M_loaded_wrist_roll_33
        - M_loaded_wrist_roll_13 * joint_W_wrist_roll_13;
    const six_link_real Lambda_i_wrist_roll_34 = M_loaded_wrist_roll_34
        - M_loaded_wrist_roll_13 * joint_W_wrist_roll_14;
    const six_link_real Lambda_i_wrist_roll_35 = M_loaded_wrist_roll_35
        - M_loaded_wrist_roll_13 * joint_W_wrist_roll_15;
    const six_link_real Lambda_i_wrist_roll_36 = M_loaded_wrist_roll_36
        - M_loaded_wrist_roll_13 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_44 = M_loaded_wrist_roll_44
        - Lambda_wrist_pitch_4 * joint_W_wrist_roll_14;
    const six_link_real Lambda_i_wrist_roll_45 = Lambda_wrist_pitch_17
        - Lambda_wrist_pitch_4 * joint_W_wrist_roll_15;
    const six_link_real Lambda_i_wrist_roll_46 = Lambda_wrist_pitch_18
        - Lambda_wrist_pitch_4 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_55 = M_loaded_wrist_roll_55
        - Lambda_wrist_pitch_5 * joint_W_wrist_roll_15;
    const six_link_real Lambda_i_wrist_roll_56 = Lambda_wrist_pitch_20
        - Lambda_wrist_pitch_5 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_66 = M_loaded_wrist_roll_66
        - Lambda_wrist_pitch_6 * joint_W_wrist_roll_16;
    const six_link_real p_i_wrist_roll_1 = bias_wrist_roll_1 + M_loaded_wrist_roll_11 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_2 = bias_wrist_roll_2 + M_loaded_wrist_roll_12 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_3 = bias_wrist_roll_3 + M_loaded_wrist_roll_13 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_4 = bias_wrist_roll_4 + Lambda_wrist_pitch_4 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_5 = bias_wrist_roll_5 + Lambda_wrist_pitch_5 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_6 = bias_wrist_roll_6 + Lambda_wrist_pitch_6 * joint_w_wrist_roll_1;

    /* wrist_roll, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real Lambda_wrist_roll_2 = Lambda_i_wrist_roll_12 * R_rel_wrist_roll_yy
        - Lambda_i_wrist_roll_13 * minus_R_rel_wrist_roll_yz;
    const six_link_real Lambda_wrist_roll_3 = Lambda_i_wrist_roll_12 * minus_R_rel_wrist_roll_yz
        + Lambda_i_wrist_roll_13 * R_rel_wrist_roll_yy;
    const six_link_real t167 = Lambda_i_wrist_roll_23 * minus_R_rel_wrist_roll_yz;
    const six_link_real t168 = Lambda_i_wrist_roll_23 * R_rel_wrist_roll_yy;
    const six_link_real t169 = Lambda_i_wrist_roll_22 * minus_R_rel_wrist_roll_yz + t168;
    const six_link_real t170 = t167 + Lambda_i_wrist_roll_33 * R_rel_wrist_roll_yy;
    const six_link_real Lambda_wrist_roll_7 = R_rel_wrist_roll_yy
        * (Lambda_i_wrist_roll_22 * R_rel_wrist_roll_yy - t167)
        - minus_R_rel_wrist_roll_yz * (t168 - Lambda_i_wrist_roll_33 * minus_R_rel_wrist_roll_yz);
    const six_link_real Lambda_wrist_roll_8 = R_rel_wrist_roll_yy * t169 - minus_R_rel_wrist_roll_yz * t170;
    const six_link_real Lambda_wrist_roll_12 = minus_R_rel_wrist_roll_yz * t169 + R_rel_wrist_roll_yy * t170;
    const six_link_real Lambda_wrist_roll_5 = Lambda_i_wrist_roll_15 * R_rel_wrist_roll_yy
        - Lambda_i_wrist_roll_16 * minus_R_rel_wrist_roll_yz;
    const six_link_real Lambda_wrist_roll_6 = Lambda_i_wrist_roll_15 * minus_R_rel_wrist_roll_yz
        + Lambda_i_wrist_roll_16 * R_rel_wrist_roll_yy;
    const six_link_real t171 = Lambda_i_wrist_roll_25 * R_rel_wrist_roll_yy
        - Lambda_i_wrist_roll_26 * minus_R_rel_wrist_roll_yz;
    const six_link_real t172 = Lambda_i_wrist_roll_25 * minus_R_rel_wrist_roll_yz
        + Lambda_i_wrist_roll_26 * R_rel_wrist_roll_yy;
    const six_link_real t173 = Lambda_i_wrist_roll_35 * R_rel_wrist_roll_yy
        - Lambda_i_wrist_roll_36 * minus_R_rel_wrist_roll_yz;
    const six_link_real t174 = Lambda_i_wrist_roll_35 * minus_R_rel_wrist_roll_yz
        + Lambda_i_wrist_roll_36 * R_rel_wrist_roll_yy;
    const six_link_real Lambda_wrist_roll_9 = R_rel_wrist_roll_yy * Lambda_i_wrist_roll_24
        - minus_R_rel_wrist_roll_yz * Lambda_i_wrist_roll_34;
    const six_link_real Lambda_wrist_roll_10 = R_rel_wrist_roll_yy * t171 - minus_R_rel_wrist_roll_yz * t173;
    const six_link_real Lambda_wrist_roll_11 = R_rel_wrist_roll_yy * t172 - minus_R_rel_wrist_roll_yz * t174;
    const six_link_real Lambda_wrist_roll_13 = minus_R_rel_wrist_roll_yz * Lambda_i_wrist_roll_24
        + R_rel_wrist_roll_yy * Lambda_i_wrist_roll_34;
    const six_link_real Lambda_wrist_roll_14 = minus_R_rel_wrist_roll_yz * t171 + R_rel_wrist_roll_yy * t173;
    const six_link_real Lambda_wrist_roll_15 = minus_R_rel_wrist_roll_yz * t172 + R_rel_wrist_roll_yy * t174;
    const six_link_real Lambda_wrist_roll_17 = Lambda_i_wrist_roll_45 * R_rel_wrist_roll_yy
        - Lambda_i_wrist_roll_46 * minus_R_rel_wrist_roll_yz;
    const six_link_real Lambda_wrist_roll_18 = Lambda_i_wrist_roll_45 * minus_R_rel_wrist_roll_yz
        + Lambda_i_wrist_roll_46 * R_rel_wrist_roll_yy;
    const six_link_real t175 = Lambda_i_wrist_roll_56 * minus_R_rel_wrist_roll_yz;
    const six_link_real t176 = Lambda_i_wrist_roll_56 * R_rel_wrist_roll_yy;
    const six_link_real t177 = Lambda_i_wrist_roll_55 * minus_R_rel_wrist_roll_yz + t176;
    const six_link_real t178 = t175 + Lambda_i_wrist_roll_66 * R_rel_wrist_roll_yy;
    const six_link_real Lambda_wrist_roll_19 = R_rel_wrist_roll_yy
        * (Lambda_i_wrist_roll_55 * R_rel_wrist_roll_yy - t175)
        - minus_R_rel_wrist_roll_yz * (t176 - Lambda_i_wrist_roll_66 * minus_R_rel_wrist_roll_yz);
    const six_link_real Lambda_wrist_roll_20 = R_rel_wrist_roll_yy * t177 - minus_R_rel_wrist_roll_yz * t178;
    const six_link_real Lambda_wrist_roll_21 = minus_R_rel_wrist_roll_yz * t177 + R_rel_wrist_roll_yy * t178;
    const six_link_real p_wrist_roll_2 = R_rel_wrist_roll_yy * p_i_wrist_roll_2
        - minus_R_rel_wrist_roll_yz * p_i_wrist_roll_3;
    const six_link_real p_wrist_roll_3 = minus_R_rel_wrist_roll_yz * p_i_wrist_roll_2
        + R_rel_wrist_roll_yy * p_i_wrist_roll_3;
    const six_link_real p_wrist_roll_5 = R_rel_wrist_roll_yy * p_i_wrist_roll_5
        - minus_R_rel_wrist_roll_yz * p_i_wrist_roll_6;
    const six_link_real p_wrist_roll_6 = minus_R_rel_wrist_roll_yz * p_i_wrist_roll_5
        + R_rel_wrist_roll_yy * p_i_wrist_roll_6;

    /* forearm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t179 = Lambda_i_wrist_roll_11 * b_omega_forearm_x
        + Lambda_wrist_roll_2 * b_omega_forearm_y + Lambda_wrist_roll_3 * b_omega_forearm_z;
    const six_link_real t180 = t179 + Lambda_i_wrist_roll_14 * b_v_forearm_x
        + Lambda_wrist_roll_5 * b_v_forearm_y + Lambda_wrist_roll_6 * b_v_forearm_z;
    const six_link_real t181 = Lambda_wrist_roll_2 * b_omega_forearm_x + Lambda_wrist_roll_7 * b_omega_forearm_y
        + Lambda_wrist_roll_8 * b_omega_forearm_z;
    const six_link_real t182 = t181 + Lambda_wrist_roll_9 * b_v_forearm_x + Lambda_wrist_roll_10 * b_v_forearm_y
        + Lambda_wrist_roll_11 * b_v_forearm_z;
    const six_link_real t183 = Lambda_wrist_roll_3 * b_omega_forearm_x + Lambda_wrist_roll_8 * b_omega_forearm_y
        + Lambda_wrist_roll_12 * b_omega_forearm_z;
    const six_link_real t184 = t183 + Lambda_wrist_roll_13 * b_v_forearm_x + Lambda_wrist_roll_14 * b_v_forearm_y
        + Lambda_wrist_roll_15 * b_v_forearm_z;
    const six_link_real t185 = Lambda_i_wrist_roll_14 * b_omega_forearm_x
        + Lambda_wrist_roll_9 * b_omega_forearm_y + Lambda_wrist_roll_13 * b_omega_forearm_z;
    const six_link_real t186 = t185 + Lambda_i_wrist_roll_44 * b_v_forearm_x
        + Lambda_wrist_roll_17 * b_v_forearm_y + Lambda_wrist_roll_18 * b_v_forearm_z;
    const six_link_real t187 = Lambda_wrist_roll_5 * b_omega_forearm_x + Lambda_wrist_roll_10 * b_omega_forearm_y
        + Lambda_wrist_roll_14 * b_omega_forearm_z;
    const six_link_real t188 = t187 + Lambda_wrist_roll_17 * b_v_forearm_x + Lambda_wrist_roll_19 * b_v_forearm_y
        + Lambda_wrist_roll_20 * b_v_forearm_z;
    const six_link_real t189 = Lambda_wrist_roll_6 * b_omega_forearm_x + Lambda_wrist_roll_11 * b_omega_forearm_y
        + Lambda_wrist_roll_15 * b_omega_forearm_z;
    const six_link_real t190 = t189 + Lambda_wrist_roll_18 * b_v_forearm_x + Lambda_wrist_roll_20 * b_v_forearm_y
        + Lambda_wrist_roll_21 * b_v_forearm_z;
    const six_link_real t191 = p_i_wrist_roll_1 - input->w_ext[2][0] + t180;
    const six_link_real t192 = p_wrist_roll_2 - input->w_ext[2][1] + t182;
    const six_link_real t193 = p_wrist_roll_3 - input->w_ext[2][2] + t184;
    const six_link_real t194 = p_i_wrist_roll_4 - input->w_ext[2][3] + t186;
    const six_link_real t195 = p_wrist_roll_5 - input->w_ext[2][4] + t188;
    const six_link_real t196 = p_wrist_roll_6 - input->w_ext[2][5] + t190;
    const six_link_real t197 = Lambda_wrist_roll_2 * minus_R_T_forearm_xy;
    const six_link_real t198 = Lambda_wrist_roll_3 * R_T_forearm_xz;
    const six_link_real t199 = Lambda_i_wrist_roll_11 * minus_R_T_forearm_xy
        + Lambda_wrist_roll_2 * R_T_forearm_yy + Lambda_wrist_roll_3 * R_T_forearm_yz;
    const six_link_real t200 = Lambda_wrist_roll_2 * R_T_forearm_yz - Lambda_i_wrist_roll_11 * R_T_forearm_xz
        + Lambda_wrist_roll_3 * R_T_forearm_zz;
    const six_link_real t201 = Lambda_wrist_roll_2 * R_T_forearm_xx - Lambda_wrist_roll_7 * minus_R_T_forearm_xy
        + Lambda_wrist_roll_8 * R_T_forearm_xz;
    const six_link_real t202 = Lambda_wrist_roll_8 * R_T_forearm_yz;
    const six_link_real t203 = t197 + Lambda_wrist_roll_7 * R_T_forearm_yy + t202;
    const six_link_real t204 = Lambda_wrist_roll_7 * R_T_forearm_yz - Lambda_wrist_roll_2 * R_T_forearm_xz
        + Lambda_wrist_roll_8 * R_T_forearm_zz;
    const six_link_real t205 = Lambda_wrist_roll_3 * R_T_forearm_xx - Lambda_wrist_roll_8 * minus_R_T_forearm_xy
        + Lambda_wrist_roll_12 * R_T_forearm_xz;
    const six_link_real t206 = Lambda_wrist_roll_3 * minus_R_T_forearm_xy + Lambda_wrist_roll_8 * R_T_forearm_yy
        + Lambda_wrist_roll_12 * R_T_forearm_yz;
    const six_link_real t207 = t202 - t198 + Lambda_wrist_roll_12 * R_T_forearm_zz;
    const six_link_real t208 = R_T_forearm_xx * (Lambda_i_wrist_roll_11 * R_T_forearm_xx - t197 + t198)
        - minus_R_T_forearm_xy * t201;
    const six_link_real Lambda_T_forearm_11 = t208 + R_T_forearm_xz * t205;
    const six_link_real Lambda_T_forearm_12 = R_T_forearm_xx * t199 - minus_R_T_forearm_xy * t203
        + R_T_forearm_xz * t206;
    const six_link_real Lambda_T_forearm_13 = R_T_forearm_xx * t200 - minus_R_T_forearm_xy * t204
        + R_T_forearm_xz * t207;
    const six_link_real Lambda_T_forearm_22 = minus_R_T_forearm_xy * t199 + R_T_forearm_yy * t203
        + R_T_forearm_yz * t206;
    const six_link_real Lambda_T_forearm_23 = minus_R_T_forearm_xy * t200 + R_T_forearm_yy * t204
        + R_T_forearm_yz * t207;
    const six_link_real Lambda_T_forearm_33 = R_T_forearm_yz * t204 - R_T_forearm_xz * t200
        + R_T_forearm_zz * t207;
    const six_link_real t209 = Lambda_i_wrist_roll_14 * R_T_forearm_xx
        - Lambda_wrist_roll_5 * minus_R_T_forearm_xy + Lambda_wrist_roll_6 * R_T_forearm_xz;
    const six_link_real t210 = Lambda_i_wrist_roll_14 * minus_R_T_forearm_xy
        + Lambda_wrist_roll_5 * R_T_forearm_yy + Lambda_wrist_roll_6 * R_T_forearm_yz;
    const six_link_real t211 = Lambda_wrist_roll_5 * R_T_forearm_yz - Lambda_i_wrist_roll_14 * R_T_forearm_xz
        + Lambda_wrist_roll_6 * R_T_forearm_zz;
    const six_link_real t212 = Lambda_wrist_roll_9 * R_T_forearm_xx - Lambda_wrist_roll_10 * minus_R_T_forearm_xy
        + Lambda_wrist_roll_11 * R_T_forearm_xz;
    const six_link_real t213 = Lambda_wrist_roll_9 * minus_R_T_forearm_xy + Lambda_wrist_roll_10 * R_T_forearm_yy
        + Lambda_wrist_roll_11 * R_T_forearm_yz;
    const six_link_real t214 = Lambda_wrist_roll_10 * R_T_forearm_yz - Lambda_wrist_roll_9 * R_T_forearm_xz
        + Lambda_wrist_roll_11 * R_T_forearm_zz;
    const six_link_real t215 = Lambda_wrist_roll_13 * R_T_forearm_xx
        - Lambda_wrist_roll_14 * minus_R_T_forearm_xy + Lambda_wrist_roll_15 * R_T_forearm_xz;
    const six_link_real t216 = Lambda_wrist_roll_13 * minus_R_T_forearm_xy
        + Lambda_wrist_roll_14 * R_T_forearm_yy + Lambda_wrist_roll_15 * R_T_forearm_yz;
    const six_link_real t217 = Lambda_wrist_roll_14 * R_T_forearm_yz - Lambda_wrist_roll_13 * R_T_forearm_xz
        + Lambda_wrist_roll_15 * R_T_forearm_zz;
    const six_link_real Lambda_T_forearm_14 = R_T_forearm_xx * t209 - minus_R_T_forearm_xy * t212
        + R_T_forearm_xz * t215;
    const six_link_real Lambda_T_forearm_15 = R_T_forearm_xx * t210 - minus_R_T_forearm_xy * t213
        + R_T_forearm_xz * t216;
    const six_link_real Lambda_T_forearm_16 = R_T_forearm_xx * t211 - minus_R_T_forearm_xy * t214
        + R_T_forearm_xz * t217;
    const six_link_real Lambda_T_forearm_24 = minus_R_T_forearm_xy * t209 + R_T_forearm_yy * t212
        + R_T_forearm_yz * t215;
    const six_link_real Lambda_T_forearm_25 = minus_R_T_forearm_xy * t210 + R_T_forearm_yy * t213
        + R_T_forearm_yz * t216;
    const six_link_real Lambda_T_forearm_26 = minus_R_T_forearm_xy * t211 + R_T_forearm_yy * t214
        + R_T_forearm_yz * t217;
    const six_link_real Lambda_T_forearm_34 = R_T_forearm_yz * t212 - R_T_forearm_xz * t209
        + R_T_forearm_zz * t215;
    const six_link_real Lambda_T_forearm_35 = R_T_forearm_yz * t213 - R_T_forearm_xz * t210
        + R_T_forearm_zz * t216;
    const six_link_real Lambda_T_forearm_36 = R_T_forearm_yz * t214 - R_T_forearm_xz * t211
        + R_T_forearm_zz * t217;
    const six_link_real t218 = Lambda_wrist_roll_17 * minus_R_T_forearm_xy;
    const six_link_real t219 = Lambda_wrist_roll_18 * R_T_forearm_xz;
    const six_link_real t220 = Lambda_i_wrist_roll_44 * minus_R_T_forearm_xy
        + Lambda_wrist_roll_17 * R_T_forearm_yy + Lambda_wrist_roll_18 * R_T_forearm_yz;
    const six_link_real t221 = Lambda_wrist_roll_17 * R_T_forearm_yz - Lambda_i_wrist_roll_44 * R_T_forearm_xz
        + Lambda_wrist_roll_18 * R_T_forearm_zz;
    const six_link_real t222 = Lambda_wrist_roll_17 * R_T_forearm_xx
        - Lambda_wrist_roll_19 * minus_R_T_forearm_xy + Lambda_wrist_roll_20 * R_T_forearm_xz;
    const six_link_real t223 = Lambda_wrist_roll_20 * R_T_forearm_yz;
    const six_link_real t224 = t218 + Lambda_wrist_roll_19 * R_T_forearm_yy + t223;
    const six_link_real t225 = Lambda_wrist_roll_19 * R_T_forearm_yz - Lambda_wrist_roll_17 * R_T_forearm_xz
        + Lambda_wrist_roll_20 * R_T_forearm_zz;
    const six_link_real t226 = Lambda_wrist_roll_18 * R_T_forearm_xx
        - Lambda_wrist_roll_20 * minus_R_T_forearm_xy + Lambda_wrist_roll_21 * R_T_forearm_xz;
    const six_link_real t227 = Lambda_wrist_roll_18 * minus_R_T_forearm_xy
        + Lambda_wrist_roll_20 * R_T_forearm_yy + Lambda_wrist_roll_21 * R_T_forearm_yz;
    const six_link_real t228 = t223 - t219 + Lambda_wrist_roll_21 * R_T_forearm_zz;
    const six_link_real t229 = R_T_forearm_xx * (Lambda_i_wrist_roll_44 * R_T_forearm_xx - t218 + t219)
        - minus_R_T_forearm_xy * t222;
    const six_link_real Lambda_T_forearm_44 = t229 + R_T_forearm_xz * t226;
    const six_link_real Lambda_T_forearm_45 = R_T_forearm_xx * t220 - minus_R_T_forearm_xy * t224
        + R_T_forearm_xz * t227;
    const six_link_real Lambda_T_forearm_46 = R_T_forearm_xx * t221 - minus_R_T_forearm_xy * t225
        + R_T_forearm_xz * t228;
    const six_link_real Lambda_T_forearm_55 = minus_R_T_forearm_xy * t220 + R_T_forearm_yy * t224
        + R_T_forearm_yz * t227;
    const six_link_real Lambda_T_forearm_56 = minus_R_T_forearm_xy * t221 + R_T_forearm_yy * t225
        + R_T_forearm_yz * t228;
    const six_link_real Lambda_T_forearm_66 = R_T_forearm_yz * t225 - R_T_forearm_xz * t221
        + R_T_forearm_zz * t228;
    const six_link_real p_T_forearm_1 = R_T_forearm_xx * t191 - minus_R_T_forearm_xy * t192
        + R_T_forearm_xz * t193;
    const six_link_real p_T_forearm_2 = minus_R_T_forearm_xy * t191 + R_T_forearm_yy * t192
        + R_T_forearm_yz * t193;
    const six_link_real p_T_forearm_3 = R_T_forearm_yz * t192 - R_T_forearm_xz * t191 + R_T_forearm_zz * t193;
    const six_link_real p_T_forearm_4 = R_T_forearm_xx * t194 - minus_R_T_forearm_xy * t195
        + R_T_forearm_xz * t196;
    const six_link_real p_T_forearm_5 = minus_R_T_forearm_xy * t194 + R_T_forearm_yy * t195
        + R_T_forearm_yz * t196;
    const six_link_real p_T_forearm_6 = R_T_forearm_yz * t195 - R_T_forearm_xz * t194 + R_T_forearm_zz * t196;

    /* forearm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t230 = r_T_forearm_z * Lambda_T_forearm_45;
    const six_link_real t231 = r_T_forearm_y * Lambda_T_forearm_46;
    const six_link_real t232 = c->links[2].length * Lambda_T_forearm_56;
    const six_link_real M_loaded_forearm_14 = Lambda_T_forearm_14 + (t231 - t230);
    const six_link_real t233 = Lambda_T_forearm_15
        + (r_T_forearm_y * Lambda_T_forearm_56 - r_T_forearm_z * Lambda_T_forearm_55);
    const six_link_real t234 = Lambda_T_forearm_16
        + (r_T_forearm_y * Lambda_T_forearm_66 - r_T_forearm_z * Lambda_T_forearm_56);
    const six_link_real t235 = Lambda_T_forearm_24
        + (r_T_forearm_z * Lambda_T_forearm_44 - c->links[2].length * Lambda_T_forearm_46);
    const six_link_real M_loaded_forearm_25 = Lambda_T_forearm_25 + (t230 - t232);
    const six_link_real t236 = Lambda_T_forearm_26
        + (r_T_forearm_z * Lambda_T_forearm_46 - c->links[2].length * Lambda_T_forearm_66);
    const six_link_real t237 = Lambda_T_forearm_34
        + (c->links[2].length * Lambda_T_forearm_45 - r_T_forearm_y * Lambda_T_forearm_44);
    const six_link_real t238 = Lambda_T_forearm_35
        + (c->links[2].length * Lambda_T_forearm_55 - r_T_forearm_y * Lambda_T_forearm_45);
    const six_link_real M_loaded_forearm_36 = Lambda_T_forearm_36 + (t232 - t231);
    const six_link_real t239 = Lambda_T_forearm_11
        - (Lambda_T_forearm_15 * r_T_forearm_z - Lambda_T_forearm_16 * r_T_forearm_y);
    const six_link_real t240 = Lambda_T_forearm_12
        - (Lambda_T_forearm_16 * c->links[2].length - Lambda_T_forearm_14 * r_T_forearm_z);
    const six_link_real t241 = Lambda_T_forearm_13
        - (Lambda_T_forearm_14 * r_T_forearm_y - Lambda_T_forearm_15 * c->links[2].length);
    const six_link_real t242 = Lambda_T_forearm_22
        - (Lambda_T_forearm_26 * c->links[2].length - Lambda_T_forearm_24 * r_T_forearm_z);
    const six_link_real t243 = Lambda_T_forearm_23
        - (Lambda_T_forearm_24 * r_T_forearm_y - Lambda_T_forearm_25 * c->links[2].length);
    const six_link_real t244 = Lambda_T_forearm_33
        - (Lambda_T_forearm_34 * r_T_forearm_y - Lambda_T_forearm_35 * c->links[2].length);
    const six_link_real M_loaded_forearm_11 = I_forearm_xx
        + (t239 + (r_T_forearm_y * t234 - r_T_forearm_z * t233));
    const six_link_real M_loaded_forearm_12 = t240 + (r_T_forearm_y * t236 - r_T_forearm_z * M_loaded_forearm_25)
        - J_forearm_xy;
    const six_link_real M_loaded_forearm_13 = t241 + (r_T_forearm_y * M_loaded_forearm_36 - r_T_forearm_z * t238)
        - J_forearm_xz;
    const six_link_real M_loaded_forearm_15 = t233 - S_forearm_z;
    const six_link_real M_loaded_forearm_16 = S_forearm_y + t234;
    const six_link_real M_loaded_forearm_22 = I_forearm_yy
        + (t242 + (r_T_forearm_z * t235 - c->links[2].length * t236));
    const six_link_real M_loaded_forearm_23 = t243
        + (r_T_forearm_z * t237 - c->links[2].length * M_loaded_forearm_36) - J_forearm_yz;
    const six_link_real M_loaded_forearm_24 = S_forearm_z + t235;
    const six_link_real M_loaded_forearm_26 = t236 - c->links[2].S_0_x;
    const six_link_real M_loaded_forearm_33 = I_forearm_zz
        + (t244 + (c->links[2].length * t238 - r_T_forearm_y * t237));
    const six_link_real M_loaded_forearm_34 = t237 - S_forearm_y;
    const six_link_real M_loaded_forearm_35 = c->links[2].S_0_x + t238;
    const six_link_real M_loaded_forearm_44 = c->links[2].m + Lambda_T_forearm_44;
    const six_link_real M_loaded_forearm_55 = c->links[2].m + Lambda_T_forearm_55;
    const six_link_real M_loaded_forearm_66 = c->links[2].m + Lambda_T_forearm_66;
    const six_link_real h_loaded_forearm_1 = h_V_forearm_1
        + (p_T_forearm_1 + (r_T_forearm_y * p_T_forearm_6 - r_T_forearm_z * p_T_forearm_5));
    const six_link_real h_loaded_forearm_2 = h_V_forearm_2
        + (p_T_forearm_2 + (r_T_forearm_z * p_T_forearm_4 - c->links[2].length * p_T_forearm_6));
    const six_link_real h_loaded_forearm_3 = h_V_forearm_3
        + (p_T_forearm_3 + (c->links[2].length * p_T_forearm_5 - r_T_forearm_y * p_T_forearm_4));
    const six_link_real h_loaded_forearm_4 = h_V_forearm_4 + p_T_forearm_4;
    const six_link_real h_loaded_forearm_5 = h_V_forearm_5 + p_T_forearm_5;
    const six_link_real h_loaded_forearm_6 = h_V_forearm_6 + p_T_forearm_6;
    const six_link_real t245 = Lambda_T_forearm_12 * J_l_forearm_yy - Lambda_T_forearm_11 * minus_J_l_forearm_xy
        + Lambda_T_forearm_13 * J_l_forearm_yz;
    const six_link_real t246 = Lambda_T_forearm_11 * J_l_forearm_xz + Lambda_T_forearm_12 * J_l_forearm_yz
        + Lambda_T_forearm_13 * J_l_forearm_zz;
    const six_link_real t247 = Lambda_T_forearm_23 * J_l_forearm_yz;
    const six_link_real t248 = Lambda_T_forearm_22 * J_l_forearm_yy - Lambda_T_forearm_12 * minus_J_l_forearm_xy
        + t247;
    const six_link_real t249 = Lambda_T_forearm_12 * J_l_forearm_xz + Lambda_T_forearm_22 * J_l_forearm_yz
        + Lambda_T_forearm_23 * J_l_forearm_zz;
    const six_link_real t250 = Lambda_T_forearm_23 * J_l_forearm_yy - Lambda_T_forearm_13 * minus_J_l_forearm_xy
        + Lambda_T_forearm_33 * J_l_forearm_yz;
    const six_link_real t251 = Lambda_T_forearm_13 * J_l_forearm_xz + t247 + Lambda_T_forearm_33 * J_l_forearm_zz;
    const six_link_real t252 = Lambda_T_forearm_24 * J_l_forearm_yy - Lambda_T_forearm_14 * minus_J_l_forearm_xy
        + Lambda_T_forearm_34 * J_l_forearm_yz;
    const six_link_real t253 = Lambda_T_forearm_14 * J_l_forearm_xz + Lambda_T_forearm_24 * J_l_forearm_yz
        + Lambda_T_forearm_34 * J_l_forearm_zz;
    const six_link_real t254 = Lambda_T_forearm_25 * J_l_forearm_yy - Lambda_T_forearm_15 * minus_J_l_forearm_xy
        + Lambda_T_forearm_35 * J_l_forearm_yz;
    const six_link_real t255 = Lambda_T_forearm_15 * J_l_forearm_xz + Lambda_T_forearm_25 * J_l_forearm_yz
        + Lambda_T_forearm_35 * J_l_forearm_zz;
    const six_link_real t256 = Lambda_T_forearm_26 * J_l_forearm_yy - Lambda_T_forearm_16 * minus_J_l_forearm_xy
        + Lambda_T_forearm_36 * J_l_forearm_yz;
    const six_link_real t257 = Lambda_T_forearm_16 * J_l_forearm_xz + Lambda_T_forearm_26 * J_l_forearm_yz
        + Lambda_T_forearm_36 * J_l_forearm_zz;
    const six_link_real C_forearm_41 = t253 * c->links[2].Psi_c_z1 + Lambda_T_forearm_45 * REAL(2.23606797749979);
    const six_link_real C_forearm_42 = t252 * c->links[2].Psi_c_y2 + Lambda_T_forearm_46 * REAL(2.23606797749979);
    const six_link_real t258 = t255 * c->links[2].Psi_c_z1 + Lambda_T_forearm_55 * REAL(2.23606797749979);
    const six_link_real t259 = Lambda_T_forearm_56 * REAL(2.23606797749979);
    const six_link_real C_forearm_52 = t254 * c->links[2].Psi_c_y2 + t259;
    const six_link_real C_forearm_61 = t257 * c->links[2].Psi_c_z1 + t259;
    const six_link_real t260 = t256 * c->links[2].Psi_c_y2 + Lambda_T_forearm_66 * REAL(2.23606797749979);
    const six_link_real t261 = t246 * c->links[2].Psi_c_z1 + Lambda_T_forearm_15 * REAL(2.23606797749979)
        + (r_T_forearm_y * C_forearm_61 - r_T_forearm_z * t258);
    const six_link_real C_forearm_21 = t249 * c->links[2].Psi_c_z1 + Lambda_T_forearm_25 * REAL(2.23606797749979)
        + (r_T_forearm_z * C_forearm_41 - c->links[2].length * C_forearm_61);
    const six_link_real t262 = t251 * c->links[2].Psi_c_z1 + Lambda_T_forearm_35 * REAL(2.23606797749979)
        + (c->links[2].length * t258 - r_T_forearm_y * C_forearm_41);
    const six_link_real t263 = t245 * c->links[2].Psi_c_y2 + Lambda_T_forearm_16 * REAL(2.23606797749979)
        + (r_T_forearm_y * t260 - r_T_forearm_z * C_forearm_52);
    const six_link_real t264 = t248 * c->links[2].Psi_c_y2 + Lambda_T_forearm_26 * REAL(2.23606797749979)
        + (r_T_forearm_z * C_forearm_42 - c->links[2].length * t260);
    const six_link_real C_forearm_32 = t250 * c->links[2].Psi_c_y2 + Lambda_T_forearm_36 * REAL(2.23606797749979)
        + (c->links[2].length * C_forearm_52 - r_T_forearm_y * C_forearm_42);
    const six_link_real C_forearm_11 = t261 - L_forearm_z1;
    const six_link_real C_forearm_12 = L_forearm_y2 + t263;
    const six_link_real C_forearm_22 = t264 - c->links[2].chi_2;
    const six_link_real C_forearm_31 = c->links[2].chi_1 + t262;
    const six_link_real C_forearm_51 = c->links[2].sigma_y1 + t258;
    const six_link_real C_forearm_62 = c->links[2].sigma_z2 + t260;
    const six_link_real t265 = (J_l_forearm_yy * t248 - minus_J_l_forearm_xy * t245 + J_l_forearm_yz * t250)
        * c->links[2].Psi_c_y2;
    const six_link_real t266 = (J_l_forearm_xz * t246 + J_l_forearm_yz * t249 + J_l_forearm_zz * t251)
        * c->links[2].Psi_c_z1 + t255 * REAL(2.23606797749979);
    const six_link_real t267 = (J_l_forearm_yy * t249 - minus_J_l_forearm_xy * t246 + J_l_forearm_yz * t251)
        * c->links[2].Psi_c_y2;
    const six_link_real modal_inertia_forearm_12 = c->links[2].Psi_c_z1 * (t267 + t257 * REAL(2.23606797749979))
        + C_forearm_52 * REAL(2.23606797749979);
    const six_link_real modal_inertia_forearm_11 = c->links[2].Psi_c_z1 * t266 + t258 * REAL(2.23606797749979)
        + work->m_eta[3];
    bad |= (unsigned long)(!(modal_inertia_forearm_11 > 0)) << 2;
    const six_link_real modal_inertia_forearm_22 = c->links[2].Psi_c_y2 * (t265 + t256 * REAL(2.23606797749979))
        + t260 * REAL(2.23606797749979) + work->m_eta[4];
    const six_link_real t268 = J_l_forearm_yy * p_T_forearm_2 - minus_J_l_forearm_xy * p_T_forearm_1
        + J_l_forearm_yz * p_T_forearm_3;
    const six_link_real t269 = c->links[2].Psi_c_z1
        * (J_l_forearm_xz * p_T_forearm_1 + J_l_forearm_yz * p_T_forearm_2 + J_l_forearm_zz * p_T_forearm_3);
    const six_link_real h_phi_forearm_1 = h_eta_forearm_1 + work->f_eta[3]
        + (t269 + p_T_forearm_5 * REAL(2.23606797749979));
    const six_link_real h_phi_forearm_2 = h_eta_forearm_2 + work->f_eta[4]
        + (c->links[2].Psi_c_y2 * t268 + p_T_forearm_6 * REAL(2.23606797749979));
    const six_link_real modes_inverse_forearm_1 = 1 / modal_inertia_forearm_11;
    const six_link_real modes_L_forearm_21 = modal_inertia_forearm_12 * modes_inverse_forearm_1;
    const six_link_real t270 = modal_inertia_forearm_22 - modal_inertia_forearm_12 * modes_L_forearm_21;
    bad |= (unsigned long)(!(t270 > 0)) << 2;
    const six_link_real modes_inverse_forearm_2 = 1 / t270;
    const six_link_real t271 = C_forearm_12 - modes_L_forearm_21 * C_forearm_11;
    const six_link_real t272 = C_forearm_22 - modes_L_forearm_21 * C_forearm_21;
    const six_link_real t273 = C_forearm_32 - modes_L_forearm_21 * C_forearm_31;
    const six_link_real t274 = C_forearm_42 - modes_L_forearm_21 * C_forearm_41;
    const six_link_real t275 = C_forearm_52 - modes_L_forearm_21 * C_forearm_51;
    const six_link_real t276 = C_forearm_62 - modes_L_forearm_21 * C_forearm_61;
    const six_link_real t277 = h_phi_forearm_2 - modes_L_forearm_21 * h_phi_forearm_1;
    const six_link_real modes_W_forearm_11 = C_forearm_11 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_12 = C_forearm_21 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_13 = C_forearm_31 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_14 = C_forearm_41 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_15 = C_forearm_51 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_16 = C_forearm_61 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_21 = t271 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_22 = t272 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_23 = t273 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_24 = t274 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_25 = t275 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_26 = t276 * modes_inverse_forearm_2;
    const six_link_real modes_w_forearm_1 = h_phi_forearm_1 * modes_inverse_forearm_1;
    const six_link_real modes_w_forearm_2 = t277 * modes_inverse_forearm_2;
    const six_link_real M_i_forearm_11 = M_loaded_forearm_11
        - (C_forearm_11 * modes_W_forearm_11 + t271 * modes_W_forearm_21);
    const six_link_real M_i_forearm_12 = M_loaded_forearm_12
        - (C_forearm_11 * modes_W_forearm_12 + t271 * modes_W_forearm_22);
    const six_link_real M_i_forearm_13 = M_loaded_forearm_13
        - (C_forearm_11 * modes_W_forearm_13 + t271 * modes_W_forearm_23);
    const six_link_real M_i_forearm_14 = M_loaded_forearm_14
        - (C_forearm_11 * modes_W_forearm_14 + t271 * modes_W_forearm_24);
    const six_link_real M_i_forearm_15 = M_loaded_forearm_15
        - (C_forearm_11 * modes_W_forearm_15 + t271 * modes_W_forearm_25);
    const six_link_real M_i_forearm_16 = M_loaded_forearm_16
        - (C_forearm_11 * modes_W_forearm_16 + t271 * modes_W_forearm_26);
    const six_link_real M_i_forearm_22 = M_loaded_forearm_22
        - (C_forearm_21 * modes_W_forearm_12 + t272 * modes_W_forearm_22);
    const six_link_real M_i_forearm_23 = M_loaded_forearm_23
        - (C_forearm_21 * modes_W_forearm_13 + t272 * modes_W_forearm_23);
    const six_link_real M_i_forearm_24 = M_loaded_forearm_24
        - (C_forearm_21 * modes_W_forearm_14 + t272 * modes_W_forearm_24);
    const six_link_real M_i_forearm_25 = M_loaded_forearm_25
        - (C_forearm_21 * modes_W_forearm_15 + t272 * modes_W_forearm_25);
    const six_link_real M_i_forearm_26 = M_loaded_forearm_26
        - (C_forearm_21 * modes_W_forearm_16 + t272 * modes_W_forearm_26);
    const six_link_real M_i_forearm_33 = M_loaded_forearm_33
        - (C_forearm_31 * modes_W_forearm_13 + t273 * modes_W_forearm_23);
    const six_link_real M_i_forearm_34 = M_loaded_forearm_34
        - (C_forearm_31 * modes_W_forearm_14 + t273 * modes_W_forearm_24);
    const six_link_real M_i_forearm_35 = M_loaded_forearm_35
        - (C_forearm_31 * modes_W_forearm_15 + t273 * modes_W_forearm_25);
    const six_link_real M_i_forearm_36 = M_loaded_forearm_36
        - (C_forearm_31 * modes_W_forearm_16 + t273 * modes_W_forearm_26);
    const six_link_real M_i_forearm_44 = M_loaded_forearm_44
        - (C_forearm_41 * modes_W_forearm_14 + t274 * modes_W_forearm_24);
    const six_link_real M_i_forearm_45 = Lambda_T_forearm_45
        - (C_forearm_41 * modes_W_forearm_15 + t274 * modes_W_forearm_25);
    const six_link_real M_i_forearm_46 = Lambda_T_forearm_46
        - (C_forearm_41 * modes_W_forearm_16 + t274 * modes_W_forearm_26);
    const six_link_real M_i_forearm_55 = M_loaded_forearm_55
        - (C_forearm_51 * modes_W_forearm_15 + t275 * modes_W_forearm_25);
    const six_link_real M_i_forearm_56 = Lambda_T_forearm_56
        - (C_forearm_51 * modes_W_forearm_16 + t275 * modes_W_forearm_26);
    const six_link_real M_i_forearm_66 = M_loaded_forearm_66
        - (C_forearm_61 * modes_W_forearm_16 + t276 * modes_W_forearm_26);
    const six_link_real h_i_forearm_1 = h_loaded_forearm_1
        - (modes_W_forearm_11 * h_phi_forearm_1 + modes_W_forearm_21 * t277);
    const six_link_real h_i_forearm_2 = h_loaded_forearm_2
        - (modes_W_forearm_12 * h_phi_forearm_1 + modes_W_forearm_22 * t277);
    const six_link_real h_i_forearm_3 = h_loaded_forearm_3
        - (modes_W_forearm_13 * h_phi_forearm_1 + modes_W_forearm_23 * t277);
    const six_link_real h_i_forearm_4 = h_loaded_forearm_4
        - (modes_W_forearm_14 * h_phi_forearm_1 + modes_W_forearm_24 * t277);
    const six_link_real h_i_forearm_5 = h_loaded_forearm_5
        - (modes_W_forearm_15 * h_phi_forearm_1 + modes_W_forearm_25 * t277);
    const six_link_real h_i_forearm_6 = h_loaded_forearm_6
        - (modes_W_forearm_16 * h_phi_forearm_1 + modes_W_forearm_26 * t277);

    /* forearm, joint: its accelerations eliminated from its rows (43) */
    const six_link_real t278 = M_i_forearm_13 * beta_omega_forearm_z
        - M_i_forearm_11 * minus_beta_omega_forearm_x - M_i_forearm_14 * minus_beta_v_forearm_x;
    const six_link_real t279 = M_i_forearm_23 * beta_omega_forearm_z
        - M_i_forearm_12 * minus_beta_omega_forearm_x - M_i_forearm_24 * minus_beta_v_forearm_x;
    const six_link_real t280 = M_i_forearm_33 * beta_omega_forearm_z
        - M_i_forearm_13 * minus_beta_omega_forearm_x - M_i_forearm_34 * minus_beta_v_forearm_x;
    const six_link_real t281 = M_i_forearm_34 * beta_omega_forearm_z
        - M_i_forearm_14 * minus_beta_omega_forearm_x - M_i_forearm_44 * minus_beta_v_forearm_x;
    const six_link_real t282 = M_i_forearm_35 * beta_omega_forearm_z
        - M_i_forearm_15 * minus_beta_omega_forearm_x - M_i_forearm_45 * minus_beta_v_forearm_x;
    const six_link_real t283 = M_i_forearm_36 * beta_omega_forearm_z
        - M_i_forearm_16 * minus_beta_omega_forearm_x - M_i_forearm_46 * minus_beta_v_forearm_x;
    const six_link_real bias_forearm_1 = h_i_forearm_1 + (t278 + M_i_forearm_16 * beta_v_forearm_z);
    const six_link_real bias_forearm_2 = h_i_forearm_2 + (t279 + M_i_forearm_26 * beta_v_forearm_z);
    const six_link_real bias_forearm_3 = h_i_forearm_3 + (t280 + M_i_forearm_36 * beta_v_forearm_z);
    const six_link_real bias_forearm_4 = h_i_forearm_4 + (t281 + M_i_forearm_46 * beta_v_forearm_z);
    const six_link_real bias_forearm_5 = h_i_forearm_5 + (t282 + M_i_forearm_56 * beta_v_forearm_z);
    const six_link_real bias_forearm_6 = h_i_forearm_6 + (t283 + M_i_forearm_66 * beta_v_forearm_z);
    const six_link_real joint_inertia_forearm_11 = M_i_forearm_22 + c->links[2].armature_1;
    bad |= (unsigned long)(!(joint_inertia_forearm_11 - t116 * (M_i_forearm_11 + M_i_forearm_22 + M_i_forearm_33) > 0)) << 2;
    const six_link_real joint_inverse_forearm_1 = 1 / joint_inertia_forearm_11;
    const six_link_real joint_W_forearm_11 = M_i_forearm_12 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_12 = M_i_forearm_22 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_13 = M_i_forearm_23 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_14 = M_i_forearm_24 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_15 = M_i_forearm_25 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_16 = M_i_forearm_26 * joint_inverse_forearm_1;
    const six_link_real joint_w_forearm_1 = (input->tau[2] - c->links[2].joint_damping_1 * state->v[2]
        - bias_forearm_2) * joint_inverse_forearm_1;
    const six_link_real Lambda_i_forearm_11 = M_i_forearm_11 - M_i_forearm_12 * joint_W_forearm_11;
    const six_link_real Lambda_i_forearm_12 = M_i_forearm_12 - M_i_forearm_12 * joint_W_forearm_12;
    const six_link_real Lambda_i_forearm_13 = M_i_forearm_13 - M_i_forearm_12 * joint_W_forearm_13;
    const six_link_real Lambda_i_forearm_14 = M_i_forearm_14 - M_i_forearm_12 * joint_W_forearm_14;
    const six_link_real Lambda_i_forearm_15 = M_i_forearm_15 - M_i_forearm_12 * joint_W_forearm_15;
    const six_link_real Lambda_i_forearm_16 = M_i_forearm_16 - M_i_forearm_12 * joint_W_forearm_16;
    const six_link_real Lambda_i_forearm_22 = M_i_forearm_22 - M_i_forearm_22 * joint_W_forearm_12;
    const six_link_real Lambda_i_forearm_23 = M_i_forearm_23 - M_i_forearm_22 * joint_W_forearm_13;
    const six_link_real Lambda_i_forearm_24 = M_i_forearm_24 - M_i_forearm_22 * joint_W_forearm_14;
    const six_link_real Lambda_i_forearm_25 = M_i_forearm_25 - M_i_forearm_22 * joint_W_forearm_15;
    const six_link_real Lambda_i_forearm_26 = M_i_forearm_26 - M_i_forearm_22 * joint_W_forearm_16;
    const six_link_real Lambda_i_forearm_33 = M_i_forearm_33 - M_i_forearm_23 * joint_W_forearm_13;
    const six_link_real Lambda_i_forearm_34 = M_i_forearm_34 - M_i_forearm_23 * joint_W_forearm_14;
    const six_link_real Lambda_i_forearm_35 = M_i_forearm_35 - M_i_forearm_23 * joint_W_forearm_15;
    const six_link_real Lambda_i_forearm_36 = M_i_forearm_36 - M_i_forearm_23 * joint_W_forearm_16;
    const six_link_real Lambda_i_forearm_44 = M_i_forearm_44 - M_i_forearm_24 * joint_W_forearm_14;
    const six_link_real Lambda_i_forearm_45 = M_i_forearm_45 - M_i_forearm_24 * joint_W_forearm_15;
    const six_link_real Lambda_i_forearm_46 = M_i_forearm_46 - M_i_forearm_24 * joint_W_forearm_16;
    const six_link_real Lambda_i_forearm_55 = M_i_forearm_55 - M_i_forearm_25 * joint_W_forearm_15;
    const six_link_real Lambda_i_forearm_56 = M_i_forearm_56 - M_i_forearm_25 * joint_W_forearm_16;
    const six_link_real Lambda_i_forearm_66 = M_i_forearm_66 - M_i_forearm_26 * joint_W_forearm_16;
    const six_link_real p_i_forearm_1 = bias_forearm_1 + M_i_forearm_12 * joint_w_forearm_1;
    const six_link_real p_i_forearm_2 = bias_forearm_2 + M_i_forearm_22 * joint_w_forearm_1;
    const six_link_real p_i_forearm_3 = bias_forearm_3 + M_i_forearm_23 * joint_w_forearm_1;
    const six_link_real p_i_forearm_4 = bias_forearm_4 + M_i_forearm_24 * joint_w_forearm_1;
    const six_link_real p_i_forearm_5 = bias_forearm_5 + M_i_forearm_25 * joint_w_forearm_1;
    const six_link_real p_i_forearm_6 = bias_forearm_6 + M_i_forearm_26 * joint_w_forearm_1;

    /* forearm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t284 = Lambda_i_forearm_11 * R_rel_forearm_xx + Lambda_i_forearm_12 * c->links[2].R_m_xy
        + Lambda_i_forearm_13 * R_rel_forearm_xz;
    const six_link_real t285 = Lambda_i_forearm_11 * R_rel_forearm_yx + Lambda_i_forearm_12 * c->links[2].R_m_yy
        + Lambda_i_forearm_13 * R_rel_forearm_yz;
    const six_link_real t286 = Lambda_i_forearm_11 * R_rel_forearm_zx + Lambda_i_forearm_12 * c->links[2].R_m_zy
        + Lambda_i_forearm_13 * R_rel_forearm_zz;
    const six_link_real t287 = Lambda_i_forearm_12 * R_rel_forearm_xx + Lambda_i_forearm_22 * c->links[2].R_m_xy
        + Lambda_i_forearm_23 * R_rel_forearm_xz;
    const six_link_real t288 = Lambda_i_forearm_12 * R_rel_forearm_yx + Lambda_i_forearm_22 * c->links[2].R_m_yy
        + Lambda_i_forearm_23 * R_rel_forearm_yz;
    const six_link_real t289 = Lambda_i_forearm_12 * R_rel_forearm_zx + Lambda_i_forearm_22 * c->links[2].R_m_zy
        + Lambda_i_forearm_23 * R_rel_forearm_zz;
    const six_link_real t290 = Lambda_i_forearm_13 * R_rel_forearm_xx + Lambda_i_forearm_23 * c->links[2].R_m_xy
        + Lambda_i_forearm_33 * R_rel_forearm_xz;
    const six_link_real t291 = Lambda_i_forearm_13 * R_rel_forearm_yx + Lambda_i_forearm_23 * c->links[2].R_m_yy
        + Lambda_i_forearm_33 * R_rel_forearm_yz;
    const six_link_real t292 = Lambda_i_forearm_13 * R_rel_forearm_zx + Lambda_i_forearm_23 * c->links[2].R_m_zy
        + Lambda_i_forearm_33 * R_rel_forearm_zz;
    const six_link_real t293 = Lambda_i_forearm_14 * R_rel_forearm_xx + Lambda_i_forearm_15 * c->links[2].R_m_xy
        + Lambda_i_forearm_16 * R_rel_forearm_xz;
    const six_link_real t294 = Lambda_i_forearm_14 * R_rel_forearm_yx + Lambda_i_forearm_15 * c->links[2].R_m_yy
        + Lambda_i_forearm_16 * R_rel_forearm_yz;
    const six_link_real t295 = Lambda_i_forearm_14 * R_rel_forearm_zx + Lambda_i_forearm_15 * c->links[2].R_m_zy
        + Lambda_i_forearm_16 * R_rel_forearm_zz;
    const six_link_real t296 = Lambda_i_forearm_24 * R_rel_forearm_xx + Lambda_i_forearm_25 * c->links[2].R_m_xy
        + Lambda_i_forearm_26 * R_rel_forearm_xz;
    const six_link_real t297 = Lambda_i_forearm_24 * R_rel_forearm_yx + Lambda_i_forearm_25 * c->links[2].R_m_yy
        + Lambda_i_forearm_26 * R_rel_forearm_yz;
    const six_link_real t298 = Lambda_i_forearm_24 * R_rel_forearm_zx + Lambda_i_forearm_25 * c->links[2].R_m_zy
        + Lambda_i_forearm_26 * R_rel_forearm_zz;
    const six_link_real t299 = Lambda_i_forearm_34 * R_rel_forearm_xx + Lambda_i_forearm_35 * c->links[2].R_m_xy
        + Lambda_i_forearm_36 * R_rel_forearm_xz;
    const six_link_real t300 = Lambda_i_forearm_34 * R_rel_forearm_yx + Lambda_i_forearm_35 * c->links[2].R_m_yy
        + Lambda_i_forearm_36 * R_rel_forearm_yz;
    const six_link_real t301 = Lambda_i_forearm_34 * R_rel_forearm_zx + Lambda_i_forearm_35 * c->links[2].R_m_zy
        + Lambda_i_forearm_36 * R_rel_forearm_zz;
    const six_link_real t302 = R_rel_forearm_xx * t293 + c->links[2].R_m_xy * t296 + R_rel_forearm_xz * t299;
    const six_link_real t303 = R_rel_forearm_xx * t294 + c->links[2].R_m_xy * t297 + R_rel_forearm_xz * t300;
    const six_link_real t304 = R_rel_forearm_xx * t295 + c->links[2].R_m_xy * t298 + R_rel_forearm_xz * t301;
    const six_link_real t305 = R_rel_forearm_yx * t293 + c->links[2].R_m_yy * t296 + R_rel_forearm_yz * t299;
    const six_link_real t306 = R_rel_forearm_yx * t294 + c->links[2].R_m_yy * t297 + R_rel_forearm_yz * t300;
    const six_link_real t307 = R_rel_forearm_yx * t295 + c->links[2].R_m_yy * t298 + R_rel_forearm_yz * t301;
    const six_link_real t308 = R_rel_forearm_zx * t293 + c->links[2].R_m_zy * t296 + R_rel_forearm_zz * t299;
    const six_link_real t309 = R_rel_forearm_zx * t294 + c->links[2].R_m_zy * t297 + R_rel_forearm_zz * t300;
    const six_link_real t310 = Lambda_i_forearm_44 * R_rel_forearm_xx + Lambda_i_forearm_45 * c->links[2].R_m_xy
        + Lambda_i_forearm_46 * R_rel_forearm_xz;
    const six_link_real t311 = Lambda_i_forearm_44 * R_rel_forearm_yx + Lambda_i_forearm_45 * c->links[2].R_m_yy
        + Lambda_i_forearm_46 * R_rel_forearm_yz;
    const six_link_real t312 = Lambda_i_forearm_44 * R_rel_forearm_zx + Lambda_i_forearm_45 * c->links[2].R_m_zy
        + Lambda_i_forearm_46 * R_rel_forearm_zz;
    const six_link_real t313 = Lambda_i_forearm_45 * R_rel_forearm_xx + Lambda_i_forearm_55 * c->links[2].R_m_xy
        + Lambda_i_forearm_56 * R_rel_forearm_xz;
    const six_link_real t314 = Lambda_i_forearm_45 * R_rel_forearm_yx + Lambda_i_forearm_55 * c->links[2].R_m_yy
        + Lambda_i_forearm_56 * R_rel_forearm_yz;
    const six_link_real t315 = Lambda_i_forearm_45 * R_rel_forearm_zx + Lambda_i_forearm_55 * c->links[2].R_m_zy
        + Lambda_i_forearm_56 * R_rel_forearm_zz;
    const six_link_real t316 = Lambda_i_forearm_46 * R_rel_forearm_xx + Lambda_i_forearm_56 * c->links[2].R_m_xy
        + Lambda_i_forearm_66 * R_rel_forearm_xz;
    const six_link_real t317 = Lambda_i_forearm_46 * R_rel_forearm_yx + Lambda_i_forearm_56 * c->links[2].R_m_yy
        + Lambda_i_forearm_66 * R_rel_forearm_yz;
    const six_link_real t318 = Lambda_i_forearm_46 * R_rel_forearm_zx + Lambda_i_forearm_56 * c->links[2].R_m_zy
        + Lambda_i_forearm_66 * R_rel_forearm_zz;
    const six_link_real Lambda_forearm_16 = R_rel_forearm_xx * t310 + c->links[2].R_m_xy * t313
        + R_rel_forearm_xz * t316;
    const six_link_real Lambda_forearm_17 = R_rel_forearm_xx * t311 + c->links[2].R_m_xy * t314
        + R_rel_forearm_xz * t317;
    const six_link_real Lambda_forearm_18 = R_rel_forearm_xx * t312 + c->links[2].R_m_xy * t315
        + R_rel_forearm_xz * t318;
    const six_link_real Lambda_forearm_19 = R_rel_forearm_yx * t311 + c->links[2].R_m_yy * t314
        + R_rel_forearm_yz * t317;
    const six_link_real Lambda_forearm_20 = R_rel_forearm_yx * t312 + c->links[2].R_m_yy * t315
        + R_rel_forearm_yz * t318;
    const six_link_real Lambda_forearm_21 = R_rel_forearm_zx * t312 + c->links[2].R_m_zy * t315
        + R_rel_forearm_zz * t318;
    const six_link_real t319 = c->links[2].mount_xyz_z * Lambda_forearm_17;
    const six_link_real t320 = c->links[2].mount_xyz_y * Lambda_forearm_18;
    const six_link_real t321 = c->links[2].mount_xyz_x * Lambda_forearm_20;
    const six_link_real Lambda_forearm_4 = t302 + (t320 - t319);
    const six_link_real Lambda_forearm_5 = t303
        + (c->links[2].mount_xyz_y * Lambda_forearm_20 - c->links[2].mount_xyz_z * Lambda_forearm_19);
    const six_link_real Lambda_forearm_6 = t304
        + (c->links[2].mount_xyz_y * Lambda_forearm_21 - c->links[2].mount_xyz_z * Lambda_forearm_20);
    const six_link_real Lambda_forearm_9 = t305
        + (c->links[2].mount_xyz_z * Lambda_forearm_16 - c->links[2].mount_xyz_x * Lambda_forearm_18);
    const six_link_real Lambda_forearm_10 = t306 + (t319 - t321);
    const six_link_real Lambda_forearm_11 = t307
        + (c->links[2].mount_xyz_z * Lambda_forearm_18 - c->links[2].mount_xyz_x * Lambda_forearm_21);
    const six_link_real Lambda_forearm_13 = t308
        + (c->links[2].mount_xyz_x * Lambda_forearm_17 - c->links[2].mount_xyz_y * Lambda_forearm_16);
    const six_link_real Lambda_forearm_14 = t309
        + (c->links[2].mount_xyz_x * Lambda_forearm_19 - c->links[2].mount_xyz_y * Lambda_forearm_17);
    const six_link_real Lambda_forearm_15 = R_rel_forearm_zx * t295 + c->links[2].R_m_zy * t298
        + R_rel_forearm_zz * t301 + (t321 - t320);
    const six_link_real t322 = R_rel_forearm_xx * t284 + c->links[2].R_m_xy * t287 + R_rel_forearm_xz * t290
        - (t303 * c->links[2].mount_xyz_z - t304 * c->links[2].mount_xyz_y);
    const six_link_real Lambda_forearm_1 = t322
        + (c->links[2].mount_xyz_y * Lambda_forearm_6 - c->links[2].mount_xyz_z * Lambda_forearm_5);
    const six_link_real t323 = R_rel_forearm_xx * t285 + c->links[2].R_m_xy * t288 + R_rel_forearm_xz * t291
        - (t304 * c->links[2].mount_xyz_x - t302 * c->links[2].mount_xyz_z);
    const six_link_real Lambda_forearm_2 = t323
        + (c->links[2].mount_xyz_y * Lambda_forearm_11 - c->links[2].mount_xyz_z * Lambda_forearm_10);
    const six_link_real t324 = R_rel_forearm_xx * t286 + c->links[2].R_m_xy * t289 + R_rel_forearm_xz * t292
        - (t302 * c->links[2].mount_xyz_y - t303 * c->links[2].mount_xyz_x);
    const six_link_real Lambda_forearm_3 = t324
        + (c->links[2].mount_xyz_y * Lambda_forearm_15 - c->links[2].mount_xyz_z * Lambda_forearm_14);
    const six_link_real t325 = R_rel_forearm_yx * t285 + c->links[2].R_m_yy * t288 + R_rel_forearm_yz * t291
        - (t307 * c->links[2].mount_xyz_x - t305 * c->links[2].mount_xyz_z);
    const six_link_real Lambda_forearm_7 = t325
        + (c->links[2].mount_xyz_z * Lambda_forearm_9 - c->links[2].mount_xyz_x * Lambda_forearm_11);
    const six_link_real t326 = R_rel_forearm_yx * t286 + c->links[2].R_m_yy * t289 + R_rel_forearm_yz * t292
        - (t305 * c->links[2].mount_xyz_y - t306 * c->links[2].mount_xyz_x);
    const six_link_real Lambda_forearm_8 = t326
        + (c->links[2].mount_xyz_z * Lambda_forearm_13 - c->links[2].mount_xyz_x * Lambda_forearm_15);
    const six_link_real t327 = R_rel_forearm_zx * t286 + c->links[2].R_m_zy * t289 + R_rel_forearm_zz * t292
        - (t308 * c->links[2].mount_xyz_y - t309 * c->links[2].mount_xyz_x);
    const six_link_real Lambda_forearm_12 = t327
        + (c->links[2].mount_xyz_x * Lambda_forearm_14 - c->links[2].mount_xyz_y * Lambda_forearm_13);
    const six_link_real t328 = R_rel_forearm_xx * p_i_forearm_1 + c->links[2].R_m_xy * p_i_forearm_2
        + R_rel_forearm_xz * p_i_forearm_3;
    const six_link_real t329 = R_rel_forearm_yx * p_i_forearm_1 + c->links[2].R_m_yy * p_i_forearm_2
        + R_rel_forearm_yz * p_i_forearm_3;
    const six_link_real t330 = R_rel_forearm_zx * p_i_forearm_1 + c->links[2].R_m_zy * p_i_forearm_2
        + R_rel_forearm_zz * p_i_forearm_3;
    const six_link_real p_forearm_4 = R_rel_forearm_xx * p_i_forearm_4 + c->links[2].R_m_xy * p_i_forearm_5
        + R_rel_forearm_xz * p_i_forearm_6;
    const six_link_real p_forearm_5 = R_rel_forearm_yx * p_i_forearm_4 + c->links[2].R_m_yy * p_i_forearm_5
        + R_rel_forearm_yz * p_i_forearm_6;
    const six_link_real p_forearm_6 = R_rel_forearm_zx * p_i_forearm_4 + c->links[2].R_m_zy * p_i_forearm_5
        + R_rel_forearm_zz * p_i_forearm_6;
    const six_link_real p_forearm_1 = t328
        + (c->links[2].mount_xyz_y * p_forearm_6 - c->links[2].mount_xyz_z * p_forearm_5);
    const six_link_real p_forearm_2 = t329
        + (c->links[2].mount_xyz_z * p_forearm_4 - c->links[2].mount_xyz_x * p_forearm_6);
    const six_link_real p_forearm_3 = t330
        + (c->links[2].mount_xyz_x * p_forearm_5 - c->links[2].mount_xyz_y * p_forearm_4);

    /* upper_arm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t331 = Lambda_forearm_1 + c->links[1].I_T_xx;
    const six_link_real t332 = Lambda_forearm_2 - c->links[1].J_T_xy;
    const six_link_real t333 = Lambda_forearm_3 - c->links[1].J_T_xz;
    const six_link_real t334 = Lambda_forearm_5 - c->links[1].S_T_z;
    const six_link_real t335 = Lambda_forearm_6 + c->links[1].S_T_y;
    const six_link_real t336 = Lambda_forearm_7 + c->links[1].I_T_yy;
    const six_link_real t337 = Lambda_forearm_8 - c->links[1].J_T_yz;
    const six_link_real t338 = Lambda_forearm_9 + c->links[1].S_T_z;
    const six_link_real t339 = Lambda_forearm_11 - c->links[1].S_T_x;
    const six_link_real t340 = Lambda_forearm_12 + c->links[1].I_T_zz;
    const six_link_real t341 = Lambda_forearm_13 - c->links[1].S_T_y;
    const six_link_real t342 = Lambda_forearm_14 + c->links[1].S_T_x;
    const six_link_real t343 = Lambda_forearm_16 + c->links[1].body0_mass;
    const six_link_real t344 = Lambda_forearm_19 + c->links[1].body0_mass;
    const six_link_real t345 = Lambda_forearm_21 + c->links[1].body0_mass;
    const six_link_real t346 = t331 * b_omega_upper_arm_x + t332 * b_omega_upper_arm_y
        + t333 * b_omega_upper_arm_z + Lambda_forearm_4 * b_v_upper_arm_x;
    const six_link_real t347 = t332 * b_omega_upper_arm_x + t336 * b_omega_upper_arm_y
        + t337 * b_omega_upper_arm_z + t338 * b_v_upper_arm_x;
    const six_link_real t348 = t333 * b_omega_upper_arm_x + t337 * b_omega_upper_arm_y
        + t340 * b_omega_upper_arm_z + t341 * b_v_upper_arm_x;
    const six_link_real t349 = Lambda_forearm_4 * b_omega_upper_arm_x + t338 * b_omega_upper_arm_y
        + t341 * b_omega_upper_arm_z + t343 * b_v_upper_arm_x;
    const six_link_real t350 = t334 * b_omega_upper_arm_x + Lambda_forearm_10 * b_omega_upper_arm_y
        + t342 * b_omega_upper_arm_z;
    const six_link_real t351 = t350 + Lambda_forearm_17 * b_v_upper_arm_x + t344 * b_v_upper_arm_y
        + Lambda_forearm_20 * b_v_upper_arm_z;
    const six_link_real t352 = t335 * b_omega_upper_arm_x + t339 * b_omega_upper_arm_y
        + Lambda_forearm_15 * b_omega_upper_arm_z;
    const six_link_real t353 = t352 + Lambda_forearm_18 * b_v_upper_arm_x + Lambda_forearm_20 * b_v_upper_arm_y
        + t345 * b_v_upper_arm_z;
    const six_link_real t354 = p_forearm_1 + h_T_tau_upper_arm_x - input->w_ext[1][0]
        + (t346 + t334 * b_v_upper_arm_y + t335 * b_v_upper_arm_z);
    const six_link_real t355 = p_forearm_2 + h_T_tau_upper_arm_y - input->w_ext[1][1]
        + (t347 + Lambda_forearm_10 * b_v_upper_arm_y + t339 * b_v_upper_arm_z);
    const six_link_real t356 = p_forearm_3 + h_T_tau_upper_arm_z - input->w_ext[1][2]
        + (t348 + t342 * b_v_upper_arm_y + Lambda_forearm_15 * b_v_upper_arm_z);
    const six_link_real t357 = p_forearm_4 + h_T_F_upper_arm_x - input->w_ext[1][3]
        + (t349 + Lambda_forearm_17 * b_v_upper_arm_y + Lambda_forearm_18 * b_v_upper_arm_z);
    const six_link_real t358 = p_forearm_5 + h_T_F_upper_arm_y - input->w_ext[1][4] + t351;
    const six_link_real t359 = p_forearm_6 + h_T_F_upper_arm_z - input->w_ext[1][5] + t353;
    const six_link_real t360 = t331 * R_T_upper_arm_yx + t332 * R_T_upper_arm_yy + t333 * R_T_upper_arm_yz;
    const six_link_real t361 = t331 * R_T_upper_arm_zx + t332 * R_T_upper_arm_zy + t333 * R_T_upper_arm_zz;
    const six_link_real t362 = t332 * R_T_upper_arm_yx + t336 * R_T_upper_arm_yy + t337 * R_T_upper_arm_yz;
    const six_link_real t363 = t332 * R_T_upper_arm_zx + t336 * R_T_upper_arm_zy + t337 * R_T_upper_arm_zz;
    const six_link_real t364 = t333 * R_T_upper_arm_yx + t337 * R_T_upper_arm_yy + t340 * R_T_upper_arm_yz;
    const six_link_real t365 = t333 * R_T_upper_arm_zx + t337 * R_T_upper_arm_zy + t340 * R_T_upper_arm_zz;
    const six_link_real t366 = R_T_upper_arm_xx
        * (t331 * R_T_upper_arm_xx + t332 * R_T_upper_arm_xy + t333 * R_T_upper_arm_xz)
        + R_T_upper_arm_xy * (t332 * R_T_upper_arm_xx + t336 * R_T_upper_arm_xy + t337 * R_T_upper_arm_xz);
    const six_link_real Lambda_T_upper_arm_11 = t366
        + R_T_upper_arm_xz * (t333 * R_T_upper_arm_xx + t337 * R_T_upper_arm_xy + t340 * R_T_upper_arm_xz);
    const six_link_real Lambda_T_upper_arm_12 = R_T_upper_arm_xx * t360 + R_T_upper_arm_xy * t362
        + R_T_upper_arm_xz * t364;
    const six_link_real Lambda_T_upper_arm_13 = R_T_upper_arm_xx * t361 + R_T_upper_arm_xy * t363
        + R_T_upper_arm_xz * t365;
    const six_link_real Lambda_T_upper_arm_22 = R_T_upper_arm_yx * t360 + R_T_upper_arm_yy * t362
        + R_T_upper_arm_yz * t364;
    const six_link_real Lambda_T_upper_arm_23 = R_T_upper_arm_yx * t361 + R_T_upper_arm_yy * t363
        + R_T_upper_arm_yz * t365;
    const six_link_real Lambda_T_upper_arm_33 = R_T_upper_arm_zx * t361 + R_T_upper_arm_zy * t363
        + R_T_upper_arm_zz * t365;
    const six_link_real t367 = Lambda_forearm_4 * R_T_upper_arm_xx + t334 * R_T_upper_arm_xy
        + t335 * R_T_upper_arm_xz;
    const six_link_real t368 = Lambda_forearm_4 * R_T_upper_arm_yx + t334 * R_T_upper_arm_yy
        + t335 * R_T_upper_arm_yz;
    const six_link_real t369 = Lambda_forearm_4 * R_T_upper_arm_zx + t334 * R_T_upper_arm_zy
        + t335 * R_T_upper_arm_zz;
    const six_link_real t370 = t338 * R_T_upper_arm_xx + Lambda_forearm_10 * R_T_upper_arm_xy
        + t339 * R_T_upper_arm_xz;
    const six_link_real t371 = t338 * R_T_upper_arm_yx + Lambda_forearm_10 * R_T_upper_arm_yy
        + t339 * R_T_upper_arm_yz;
    const six_link_real t372 = t338 * R_T_upper_arm_zx + Lambda_forearm_10 * R_T_upper_arm_zy
        + t339 * R_T_upper_arm_zz;
    const six_link_real t373 = t341 * R_T_upper_arm_xx + t342 * R_T_upper_arm_xy
        + Lambda_forearm_15 * R_T_upper_arm_xz;
    const six_link_real t374 = t341 * R_T_upper_arm_yx + t342 * R_T_upper_arm_yy
        + Lambda_forearm_15 * R_T_upper_arm_yz;
    const six_link_real t375 = t341 * R_T_upper_arm_zx + t342 * R_T_upper_arm_zy
        + Lambda_forearm_15 * R_T_upper_arm_zz;
    const six_link_real Lambda_T_upper_arm_14 = R_T_upper_arm_xx * t367 + R_T_upper_arm_xy * t370
        + R_T_upper_arm_xz * t373;
    const six_link_real Lambda_T_upper_arm_15 = R_T_upper_arm_xx * t368 + R_T_upper_arm_xy * t371
        + R_T_upper_arm_xz * t374;
    const six_link_real Lambda_T_upper_arm_16 = R_T_upper_arm_xx * t369 + R_T_upper_arm_xy * t372
        + R_T_upper_arm_xz * t375;
    const six_link_real Lambda_T_upper_arm_24 = R_T_upper_arm_yx * t367 + R_T_upper_arm_yy * t370
        + R_T_upper_arm_yz * t373;
    const six_link_real Lambda_T_upper_arm_25 = R_T_upper_arm_yx * t368 + R_T_upper_arm_yy * t371
        + R_T_upper_arm_yz * t374;
    const six_link_real Lambda_T_upper_arm_26 = R_T_upper_arm_yx * t369 + R_T_upper_arm_yy * t372
        + R_T_upper_arm_yz * t375;
    const six_link_real Lambda_T_upper_arm_34 = R_T_upper_arm_zx * t367 + R_T_upper_arm_zy * t370
        + R_T_upper_arm_zz * t373;
    const six_link_real Lambda_T_upper_arm_35 = R_T_upper_arm_zx * t368 + R_T_upper_arm_zy * t371
        + R_T_upper_arm_zz * t374;
    const six_link_real Lambda_T_upper_arm_36 = R_T_upper_arm_zx * t369 + R_T_upper_arm_zy * t372
        + R_T_upper_arm_zz * t375;
    const six_link_real t376 = t343 * R_T_upper_arm_xx + Lambda_forearm_17 * R_T_upper_arm_xy
        + Lambda_forearm_18 * R_T_upper_arm_xz;
    const six_link_real t377 = t343 * R_T_upper_arm_yx + Lambda_forearm_17 * R_T_upper_arm_yy
        + Lambda_forearm_18 * R_T_upper_arm_yz;
    const six_link_real t378 = t343 * R_T_upper_arm_zx + Lambda_forearm_17 * R_T_upper_arm_zy
        + Lambda_forearm_18 * R_T_upper_arm_zz;
    const six_link_real t379 = Lambda_forearm_17 * R_T_upper_arm_xx + t344 * R_T_upper_arm_xy
        + Lambda_forearm_20 * R_T_upper_arm_xz;
    const six_link_real t380 = Lambda_forearm_17 * R_T_upper_arm_yx + t344 * R_T_upper_arm_yy
        + Lambda_forearm_20 * R_T_upper_arm_yz;
    const six_link_real t381 = Lambda_forearm_17 * R_T_upper_arm_zx + t344 * R_T_upper_arm_zy
        + Lambda_forearm_20 * R_T_upper_arm_zz;
    const six_link_real t382 = Lambda_forearm_18 * R_T_upper_arm_xx + Lambda_forearm_20 * R_T_upper_arm_xy
        + t345 * R_T_upper_arm_xz;
    const six_link_real t383 = Lambda_forearm_18 * R_T_upper_arm_yx + Lambda_forearm_20 * R_T_upper_arm_yy
        + t345 * R_T_upper_arm_yz;
    const six_link_real t384 = Lambda_forearm_18 * R_T_upper_arm_zx + Lambda_forearm_20 * R_T_upper_arm_zy
        + t345 * R_T_upper_arm_zz;
    const six_link_real Lambda_T_upper_arm_44 = R_T_upper_arm_xx * t376 + R_T_upper_arm_xy * t379
        + R_T_upper_arm_xz * t382;
    const six_link_real Lambda_T_upper_arm_45 = R_T_upper_arm_xx * t377 + R_T_upper_arm_xy * t380
        + R_T_upper_arm_xz * t383;
    const six_link_real Lambda_T_upper_arm_46 = R_T_upper_arm_xx * t378 + R_T_upper_arm_xy * t381
        + R_T_upper_arm_xz * t384;
    const six_link_real Lambda_T_upper_arm_55 = R_T_upper_arm_yx * t377 + R_T_upper_arm_yy * t380
        + R_T_upper_arm_yz * t383;
    const six_link_real Lambda_T_upper_arm_56 = R_T_upper_arm_yx * t378 + R_T_upper_arm_yy * t381
        + R_T_upper_arm_yz * t384;
    const six_link_real Lambda_T_upper_arm_66 = R_T_upper_arm_zx * t378 + R_T_upper_arm_zy * t381
        + R_T_upper_arm_zz * t384;
    const six_link_real p_T_upper_arm_1 = R_T_upper_arm_xx * t354 + R_T_upper_arm_xy * t355
        + R_T_upper_arm_xz * t356;
    const six_link_real p_T_upper_arm_2 = R_T_upper_arm_yx * t354 + R_T_upper_arm_yy * t355
        + R_T_upper_arm_yz * t356;
    const six_link_real p_T_upper_arm_3 = R_T_upper_arm_zx * t354 + R_T_upper_arm_zy * t355
        + R_T_upper_arm_zz * t356;
    const six_link_real p_T_upper_arm_4 = R_T_upper_arm_xx * t357 + R_T_upper_arm_xy * t358
        + R_T_upper_arm_xz * t359;
    const six_link_real p_T_upper_arm_5 = R_T_upper_arm_yx * t357 + R_T_upper_arm_yy * t358
        + R_T_upper_arm_yz * t359;
    const six_link_real p_T_upper_arm_6 = R_T_upper_arm_zx * t357 + R_T_upper_arm_zy * t358
        + R_T_upper_arm_zz * t359;

    /* upper_arm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t385 = r_T_upper_arm_z * Lambda_T_upper_arm_45;
    const six_link_real t386 = r_T_upper_arm_y * Lambda_T_upper_arm_46;
    const six_link_real t387 = c->links[1].length * Lambda_T_upper_arm_56;
    const six_link_real M_loaded_upper_arm_14 = Lambda_T_upper_arm_14 + (t386 - t385);
    const six_link_real t388 = Lambda_T_upper_arm_15
        + (r_T_upper_arm_y * Lambda_T_upper_arm_56 - r_T_upper_arm_z * Lambda_T_upper_arm_55);
    const six_link_real t389 = Lambda_T_upper_arm_16
        + (r_T_upper_arm_y * Lambda_T_upper_arm_66 - r_T_upper_arm_z * Lambda_T_upper_arm_56);
    const six_link_real t390 = Lambda_T_upper_arm_24
        + (r_T_upper_arm_z * Lambda_T_upper_arm_44 - c->links[1].length * Lambda_T_upper_arm_46);
    const six_link_real M_loaded_upper_arm_25 = Lambda_T_upper_arm_25 + (t385 - t387);
    const six_link_real t391 = Lambda_T_upper_arm_26
        + (r_T_upper_arm_z * Lambda_T_upper_arm_46 - c->links[1].length * Lambda_T_upper_arm_66);
    const six_link_real t392 = Lambda_T_upper_arm_34
        + (c->links[1].length * Lambda_T_upper_arm_45 - r_T_upper_arm_y * Lambda_T_upper_arm_44);
    const six_link_real t393 = Lambda_T_upper_arm_35
        + (c->links[1].length * Lambda_T_upper_arm_55 - r_T_upper_arm_y * Lambda_T_upper_arm_45);
    const six_link_real M_loaded_upper_arm_36 = Lambda_T_upper_arm_36 + (t387 - t386);
    const six_link_real t394 = Lambda_T_upper_arm_11
        - (Lambda_T_upper_arm_15 * r_T_upper_arm_z - Lambda_T_upper_arm_16 * r_T_upper_arm_y);
    const six_link_real t395 = Lambda_T_upper_arm_12
        - (Lambda_T_upper_arm_16 * c->links[1].length - Lambda_T_upper_arm_14 * r_T_upper_arm_z);
    const six_link_real t396 = Lambda_T_upper_arm_13
        - (Lambda_T_upper_arm_14 * r_T_upper_arm_y - Lambda_T_upper_arm_15 * c->links[1].length);
    const six_link_real t397 = Lambda_T_upper_arm_22
        - (Lambda_T_upper_arm_26 * c->links[1].length - Lambda_T_upper_arm_24 * r_T_upper_arm_z);
    const six_link_real t398 = Lambda_T_upper_arm_23
        - (Lambda_T_upper_arm_24 * r_T_upper_arm_y - Lambda_T_upper_arm_25 * c->links[1].length);
    const six_link_real t399 = Lambda_T_upper_arm_33
        - (Lambda_T_upper_arm_34 * r_T_upper_arm_y - Lambda_T_upper_arm_35 * c->links[1].length);
    const six_link_real M_loaded_upper_arm_11 = I_upper_arm_xx
        + (t394 + (r_T_upper_arm_y * t389 - r_T_upper_arm_z * t388));
    const six_link_real M_loaded_upper_arm_12 = t395
        + (r_T_upper_arm_y * t391 - r_T_upper_arm_z * M_loaded_upper_arm_25) - J_upper_arm_xy;
    const six_link_real M_loaded_upper_arm_13 = t396
        + (r_T_upper_arm_y * M_loaded_upper_arm_36 - r_T_upper_arm_z * t393) - J_upper_arm_xz;
    const six_link_real M_loaded_upper_arm_15 = t388 - S_upper_arm_z;
    const six_link_real M_loaded_upper_arm_16 = S_upper_arm_y + t389;
    const six_link_real M_loaded_upper_arm_22 = I_upper_arm_yy
        + (t397 + (r_T_upper_arm_z * t390 - c->links[1].length * t391));
    const six_link_real M_loaded_upper_arm_23 = t398
        + (r_T_upper_arm_z * t392 - c->links[1].length * M_loaded_upper_arm_36) - J_upper_arm_yz;
    const six_link_real M_loaded_upper_arm_24 = S_upper_arm_z + t390;
    const six_link_real M_loaded_upper_arm_26 = t391 - c->links[1].S_0_x;
    const six_link_real M_loaded_upper_arm_33 = I_upper_arm_zz
        + (t399 + (c->links[1].length * t393 - r_T_upper_arm_y * t392));
    const six_link_real M_loaded_upper_arm_34 = t392 - S_upper_arm_y;
    const six_link_real M_loaded_upper_arm_35 = c->links[1].S_0_x + t393;
    const six_link_real M_loaded_upper_arm_44 = c->links[1].mu + Lambda_T_upper_arm_44;
    const six_link_real M_loaded_upper_arm_55 = c->links[1].mu + Lambda_T_upper_arm_55;
    const six_link_real M_loaded_upper_arm_66 = c->links[1].mu + Lambda_T_upper_arm_66;
    const six_link_real h_loaded_upper_arm_1 = h_V_upper_arm_1
        + (p_T_upper_arm_1 + (r_T_upper_arm_y * p_T_upper_arm_6 - r_T_upper_arm_z * p_T_upper_arm_5));
    const six_link_real h_loaded_upper_arm_2 = h_V_upper_arm_2
        + (p_T_upper_arm_2 + (r_T_upper_arm_z * p_T_upper_arm_4 - c->links[1].length * p_T_upper_arm_6));
    const six_link_real h_loaded_upper_arm_3 = h_V_upper_arm_3
        + (p_T_upper_arm_3 + (c->links[1].length * p_T_upper_arm_5 - r_T_upper_arm_y * p_T_upper_arm_4));
    const six_link_real h_loaded_upper_arm_4 = h_V_upper_arm_4 + p_T_upper_arm_4;
    const six_link_real h_loaded_upper_arm_5 = h_V_upper_arm_5 + p_T_upper_arm_5;
    const six_link_real h_loaded_upper_arm_6 = h_V_upper_arm_6 + p_T_upper_arm_6;
    const six_link_real t400 = Lambda_T_upper_arm_11 * J_l_upper_arm_xx
        + Lambda_T_upper_arm_12 * J_l_upper_arm_yx + Lambda_T_upper_arm_13 * J_l_upper_arm_zx;
    const six_link_real t401 = Lambda_T_upper_arm_11 * J_l_upper_arm_xy
        + Lambda_T_upper_arm_12 * J_l_upper_arm_yy + Lambda_T_upper_arm_13 * J_l_upper_arm_zy;
    const six_link_real t402 = Lambda_T_upper_arm_11 * J_l_upper_arm_xz
        + Lambda_T_upper_arm_12 * J_l_upper_arm_yz + Lambda_T_upper_arm_13 * J_l_upper_arm_zz;
    const six_link_real t403 = Lambda_T_upper_arm_12 * J_l_upper_arm_xx
        + Lambda_T_upper_arm_22 * J_l_upper_arm_yx + Lambda_T_upper_arm_23 * J_l_upper_arm_zx;
    const six_link_real t404 = Lambda_T_upper_arm_12 * J_l_upper_arm_xy
        + Lambda_T_upper_arm_22 * J_l_upper_arm_yy + Lambda_T_upper_arm_23 * J_l_upper_arm_zy;
    const six_link_real t405 = Lambda_T_upper_arm_12 * J_l_upper_arm_xz
        + Lambda_T_upper_arm_22 * J_l_upper_arm_yz + Lambda_T_upper_arm_23 * J_l_upper_arm_zz;
    const six_link_real t406 = Lambda_T_upper_arm_13 * J_l_upper_arm_xx
        + Lambda_T_upper_arm_23 * J_l_upper_arm_yx + Lambda_T_upper_arm_33 * J_l_upper_arm_zx;
    const six_link_real t407 = Lambda_T_upper_arm_13 * J_l_upper_arm_xy
        + Lambda_T_upper_arm_23 * J_l_upper_arm_yy + Lambda_T_upper_arm_33 * J_l_upper_arm_zy;
    const six_link_real t408 = Lambda_T_upper_arm_13 * J_l_upper_arm_xz
        + Lambda_T_upper_arm_23 * J_l_upper_arm_yz + Lambda_T_upper_arm_33 * J_l_upper_arm_zz;
    const six_link_real t409 = Lambda_T_upper_arm_14 * J_l_upper_arm_xx
        + Lambda_T_upper_arm_24 * J_l_upper_arm_yx + Lambda_T_upper_arm_34 * J_l_upper_arm_zx;
    const six_link_real t410 = Lambda_T_upper_arm_14 * J_l_upper_arm_xy
        + Lambda_T_upper_arm_24 * J_l_upper_arm_yy + Lambda_T_upper_arm_34 * J_l_upper_arm_zy;
    const six_link_real t411 = Lambda_T_upper_arm_14 * J_l_upper_arm_xz
        + Lambda_T_upper_arm_24 * J_l_upper_arm_yz + Lambda_T_upper_arm_34 * J_l_upper_arm_zz;
    const six_link_real t412 = Lambda_T_upper_arm_15 * J_l_upper_arm_xx
        + Lambda_T_upper_arm_25 * J_l_upper_arm_yx + Lambda_T_upper_arm_35 * J_l_upper_arm_zx;
    const six_link_real t413 = Lambda_T_upper_arm_15 * J_l_upper_arm_xy
        + Lambda_T_upper_arm_25 * J_l_upper_arm_yy + Lambda_T_upper_arm_35 * J_l_upper_arm_zy;
    const six_link_real t414 = Lambda_T_upper_arm_15 * J_l_upper_arm_xz
        + Lambda_T_upper_arm_25 * J_l_upper_arm_yz + Lambda_T_upper_arm_35 * J_l_upper_arm_zz;
    const six_link_real t415 = Lambda_T_upper_arm_16 * J_l_upper_arm_xx
        + Lambda_T_upper_arm_26 * J_l_upper_arm_yx + Lambda_T_upper_arm_36 * J_l_upper_arm_zx;
    const six_link_real t416 = Lambda_T_upper_arm_16 * J_l_upper_arm_xy
        + Lambda_T_upper_arm_26 * J_l_upper_arm_yy + Lambda_T_upper_arm_36 * J_l_upper_arm_zy;
    const six_link_real t417 = Lambda_T_upper_arm_16 * J_l_upper_arm_xz
        + Lambda_T_upper_arm_26 * J_l_upper_arm_yz + Lambda_T_upper_arm_36 * J_l_upper_arm_zz;
    const six_link_real C_upper_arm_41 = t411 * c->links[1].Psi_c_z1 + Lambda_T_upper_arm_45 * 2;
    const six_link_real C_upper_arm_42 = t410 * c->links[1].Psi_c_y2 + Lambda_T_upper_arm_46 * 2;
    const six_link_real C_upper_arm_43 = t409 * REAL(1.4142135623730951);
    const six_link_real t418 = t414 * c->links[1].Psi_c_z1 + Lambda_T_upper_arm_55 * 2;
    const six_link_real t419 = Lambda_T_upper_arm_56 * 2;
    const six_link_real C_upper_arm_52 = t413 * c->links[1].Psi_c_y2 + t419;
    const six_link_real C_upper_arm_53 = t412 * REAL(1.4142135623730951);
    const six_link_real C_upper_arm_61 = t417 * c->links[1].Psi_c_z1 + t419;
    const six_link_real t420 = t416 * c->links[1].Psi_c_y2 + Lambda_T_upper_arm_66 * 2;
    const six_link_real C_upper_arm_63 = t415 * REAL(1.4142135623730951);
    const six_link_real t421 = t402 * c->links[1].Psi_c_z1 + Lambda_T_upper_arm_15 * 2
        + (r_T_upper_arm_y * C_upper_arm_61 - r_T_upper_arm_z * t418);
    const six_link_real C_upper_arm_21 = t405 * c->links[1].Psi_c_z1 + Lambda_T_upper_arm_25 * 2
        + (r_T_upper_arm_z * C_upper_arm_41 - c->links[1].length * C_upper_arm_61);
    const six_link_real t422 = t408 * c->links[1].Psi_c_z1 + Lambda_T_upper_arm_35 * 2
        + (c->links[1].length * t418 - r_T_upper_arm_y * C_upper_arm_41);
    const six_link_real t423 = t401 * c->links[1].Psi_c_y2 + Lambda_T_upper_arm_16 * 2
        + (r_T_upper_arm_y * t420 - r_T_upper_arm_z * C_upper_arm_52);
    const six_link_real t424 = t404 * c->links[1].Psi_c_y2 + Lambda_T_upper_arm_26 * 2
        + (r_T_upper_arm_z * C_upper_arm_42 - c->links[1].length * t420);
    const six_link_real C_upper_arm_32 = t407 * c->links[1].Psi_c_y2 + Lambda_T_upper_arm_36 * 2
        + (c->links[1].length * C_upper_arm_52 - r_T_upper_arm_y * C_upper_arm_42);
    const six_link_real t425 = t400 * REAL(1.4142135623730951)
        + (r_T_upper_arm_y * C_upper_arm_63 - r_T_upper_arm_z * C_upper_arm_53);
    const six_link_real C_upper_arm_23 = t403 * REAL(1.4142135623730951)
        + (r_T_upper_arm_z * C_upper_arm_43 - c->links[1].length * C_upper_arm_63);
    const six_link_real C_upper_arm_33 = t406 * REAL(1.4142135623730951)
        + (c->links[1].length * C_upper_arm_53 - r_T_upper_arm_y * C_upper_arm_43);
    const six_link_real C_upper_arm_11 = t421 - L_upper_arm_z1;
    const six_link_real C_upper_arm_12 = L_upper_arm_y2 + t423;
    const six_link_real C_upper_arm_13 = c->links[1].sigma_t_3 + t425;
    const six_link_real C_upper_arm_22 = t424 - c->links[1].chi_2;
    const six_link_real C_upper_arm_31 = c->links[1].chi_1 + t422;
    const six_link_real C_upper_arm_51 = c->links[1].sigma_y1 + t418;
    const six_link_real C_upper_arm_62 = c->links[1].sigma_z2 + t420;
    const six_link_real t426 = (J_l_upper_arm_xy * t401 + J_l_upper_arm_yy * t404 + J_l_upper_arm_zy * t407)
        * c->links[1].Psi_c_y2;
    const six_link_real t427 = (J_l_upper_arm_xx * t401 + J_l_upper_arm_yx * t404 + J_l_upper_arm_zx * t407)
        * REAL(1.4142135623730951);
    const six_link_real t428 = (J_l_upper_arm_xz * t402 + J_l_upper_arm_yz * t405 + J_l_upper_arm_zz * t408)
        * c->links[1].Psi_c_z1;
    const six_link_real t429 = (J_l_upper_arm_xy * t402 + J_l_upper_arm_yy * t405 + J_l_upper_arm_zy * t408)
        * c->links[1].Psi_c_y2;
    const six_link_real t430 = (J_l_upper_arm_xx * t402 + J_l_upper_arm_yx * t405 + J_l_upper_arm_zx * t408)
        * REAL(1.4142135623730951);
    const six_link_real modal_inertia_upper_arm_12 = c->links[1].Psi_c_z1 * (t429 + t417 * 2)
        + C_upper_arm_52 * 2;
    const six_link_real modal_inertia_upper_arm_13 = c->links[1].Psi_c_z1 * t430
        + t412 * REAL(2.8284271247461903);
    const six_link_real modal_inertia_upper_arm_23 = c->links[1].Psi_c_y2 * t427
        + t415 * REAL(2.8284271247461903);
    const six_link_real t431 = (J_l_upper_arm_xx * t400 + J_l_upper_arm_yx * t403 + J_l_upper_arm_zx * t406)
        * REAL(2.0000000000000004);
    const six_link_real modal_inertia_upper_arm_11 = c->links[1].Psi_c_z1 * (t428 + t414 * 2) + t418 * 2
        + work->m_eta[0];
    bad |= (unsigned long)(!(modal_inertia_upper_arm_11 > 0)) << 1;
    const six_link_real modal_inertia_upper_arm_22 = c->links[1].Psi_c_y2 * (t426 + t416 * 2) + t420 * 2
        + work->m_eta[1];
    const six_link_real modal_inertia_upper_arm_33 = t431 + work->m_eta[2];
    const six_link_real t432 = J_l_upper_arm_xx * p_T_upper_arm_1 + J_l_upper_arm_yx * p_T_upper_arm_2
        + J_l_upper_arm_zx * p_T_upper_arm_3;
    const six_link_real t433 = J_l_upper_arm_xy * p_T_upper_arm_1 + J_l_upper_arm_yy * p_T_upper_arm_2
        + J_l_upper_arm_zy * p_T_upper_arm_3;
    const six_link_real t434 = J_l_upper_arm_xz * p_T_upper_arm_1 + J_l_upper_arm_yz * p_T_upper_arm_2
        + J_l_upper_arm_zz * p_T_upper_arm_3;
    const six_link_real h_phi_upper_arm_1 = h_eta_upper_arm_1 + work->f_eta[0]
        + (c->links[1].Psi_c_z1 * t434 + p_T_upper_arm_5 * 2);
    const six_link_real h_phi_upper_arm_2 = h_eta_upper_arm_2 + work->f_eta[1]
        + (c->links[1].Psi_c_y2 * t433 + p_T_upper_arm_6 * 2);
    const six_link_real h_phi_upper_arm_3 = work->f_eta[2] + t432 * REAL(1.4142135623730951);
    const six_link_real modes_inverse_upper_arm_1 = 1 / modal_inertia_upper_arm_11;
    const six_link_real modes_L_upper_arm_21 = modal_inertia_upper_arm_12 * modes_inverse_upper_arm_1;
    const six_link_real modes_L_upper_arm_31 = modal_inertia_upper_arm_13 * modes_inverse_upper_arm_1;
    const six_link_real t435 = modal_inertia_upper_arm_22 - modal_inertia_upper_arm_12 * modes_L_upper_arm_21;
    bad |= (unsigned long)(!(t435 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_2 = 1 / t435;
    const six_link_real t436 = modal_inertia_upper_arm_23 - modal_inertia_upper_arm_12 * modes_L_upper_arm_31;
    const six_link_real modes_L_upper_arm_32 = t436 * modes_inverse_upper_arm_2;
    const six_link_real t437 = modal_inertia_upper_arm_33
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_31 + t436 * modes_L_upper_arm_32);
    bad |= (unsigned long)(!(t437 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_3 = 1 / t437;
    const six_link_real t438 = C_upper_arm_12 - modes_L_upper_arm_21 * C_upper_arm_11;
    const six_link_real t439 = C_upper_arm_22 - modes_L_upper_arm_21 * C_upper_arm_21;
    const six_link_real t440 = C_upper_arm_32 - modes_L_upper_arm_21 * C_upper_arm_31;
    const six_link_real t441 = C_upper_arm_42 - modes_L_upper_arm_21 * C_upper_arm_41;
    const six_link_real t442 = C_upper_arm_52 - modes_L_upper_arm_21 * C_upper_arm_51;
    const six_link_real t443 = C_upper_arm_62 - modes_L_upper_arm_21 * C_upper_arm_61;
    const six_link_real t444 = C_upper_arm_13 - modes_L_upper_arm_31 * C_upper_arm_11
        - modes_L_upper_arm_32 * t438;
    const six_link_real t445 = C_upper_arm_23 - modes_L_upper_arm_31 * C_upper_arm_21
        - modes_L_upper_arm_32 * t439;
    const six_link_real t446 = C_upper_arm_33 - modes_L_upper_arm_31 * C_upper_arm_31
        - modes_L_upper_arm_32 * t440;
    const six_link_real t447 = C_upper_arm_43 - modes_L_upper_arm_31 * C_upper_arm_41
        - modes_L_upper_arm_32 * t441;
    const six_link_real t448 = C_upper_arm_53 - modes_L_upper_arm_31 * C_upper_arm_51
        - modes_L_upper_arm_32 * t442;
    const six_link_real t449 = C_upper_arm_63 - modes_L_upper_arm_31 * C_upper_arm_61
        - modes_L_upper_arm_32 * t443;
    const six_link_real t450 = h_phi_upper_arm_2 - modes_L_upper_arm_21 * h_phi_upper_arm_1;
    const six_link_real t451 = h_phi_upper_arm_3 - modes_L_upper_arm_31 * h_phi_upper_arm_1
        - modes_L_upper_arm_32 * t450;
    const six_link_real modes_W_upper_arm_11 = C_upper_arm_11 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_12 = C_upper_arm_21 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_13 = C_upper_arm_31 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_14 = C_upper_arm_41 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_15 = C_upper_arm_51 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_16 = C_upper_arm_61 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_21 = t438 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_22 = t439 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_23 = t440 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_24 = t441 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_25 = t442 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_26 = t443 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_31 = t444 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_32 = t445 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_33 = t446 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_34 = t447 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_35 = t448 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_36 = t449 * modes_inverse_upper_arm_3;
    const six_link_real modes_w_upper_arm_1 = h_phi_upper_arm_1 * modes_inverse_upper_arm_1;
    const six_link_real modes_w_upper_arm_2 = t450 * modes_inverse_upper_arm_2;
    const six_link_real modes_w_upper_arm_3 = t451 * modes_inverse_upper_arm_3;
    const six_link_real t452 = C_upper_arm_11 * modes_W_upper_arm_11 + t438 * modes_W_upper_arm_21
        + t444 * modes_W_upper_arm_31;
    const six_link_real M_i_upper_arm_11 = M_loaded_upper_arm_11 - t452;
    const six_link_real t453 = C_upper_arm_11 * modes_W_upper_arm_12 + t438 * modes_W_upper_arm_22
        + t444 * modes_W_upper_arm_32;
    const six_link_real M_i_upper_arm_12 = M_loaded_upper_arm_12 - t453;
    const six_link_real t454 = C_upper_arm_11 * modes_W_upper_arm_13 + t438 * modes_W_upper_arm_23
        + t444 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_13 = M_loaded_upper_arm_13 - t454;
    const six_link_real t455 = C_upper_arm_11 * modes_W_upper_arm_14 + t438 * modes_W_upper_arm_24
        + t444 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_14 = M_loaded_upper_arm_14 - t455;
    const six_link_real t456 = C_upper_arm_11 * modes_W_upper_arm_15 + t438 * modes_W_upper_arm_25
        + t444 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_15 = M_loaded_upper_arm_15 - t456;
    const six_link_real t457 = C_upper_arm_11 * modes_W_upper_arm_16 + t438 * modes_W_upper_arm_26
        + t444 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_16 = M_loaded_upper_arm_16 - t457;
    const six_link_real t458 = C_upper_arm_21 * modes_W_upper_arm_12 + t439 * modes_W_upper_arm_22
        + t445 * modes_W_upper_arm_32;
    const six_link_real M_i_upper_arm_22 = M_loaded_upper_arm_22 - t458;
    const six_link_real t459 = C_upper_arm_21 * modes_W_upper_arm_13 + t439 * modes_W_upper_arm_23
        + t445 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_23 = M_loaded_upper_arm_23 - t459;
    const six_link_real t460 = C_upper_arm_21 * modes_W_upper_arm_14 + t439 * modes_W_upper_arm_24
        + t445 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_24 = M_loaded_upper_arm_24 - t460;
    const six_link_real t461 = C_upper_arm_21 * modes_W_upper_arm_15 + t439 * modes_W_upper_arm_25
        + t445 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_25 = M_loaded_upper_arm_25 - t461;
    const six_link_real t462 = C_upper_arm_21 * modes_W_upper_arm_16 + t439 * modes_W_upper_arm_26
        + t445 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_26 = M_loaded_upper_arm_26 - t462;
    const six_link_real t463 = C_upper_arm_31 * modes_W_upper_arm_13 + t440 * modes_W_upper_arm_23
        + t446 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_33 = M_loaded_upper_arm_33 - t463;
    const six_link_real t464 = C_upper_arm_31 * modes_W_upper_arm_14 + t440 * modes_W_upper_arm_24
        + t446 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_34 = M_loaded_upper_arm_34 - t464;
    const six_link_real t465 = C_upper_arm_31 * modes_W_upper_arm_15 + t440 * modes_W_upper_arm_25
        + t446 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_35 = M_loaded_upper_arm_35 - t465;
    const six_link_real t466 = C_upper_arm_31 * modes_W_upper_arm_16 + t440 * modes_W_upper_arm_26
        + t446 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_36 = M_loaded_upper_arm_36 - t466;
    const six_link_real t467 = C_upper_arm_41 * modes_W_upper_arm_14 + t441 * modes_W_upper_arm_24
        + t447 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_44 = M_loaded_upper_arm_44 - t467;
    const six_link_real t468 = C_upper_arm_41 * modes_W_upper_arm_15 + t441 * modes_W_upper_arm_25
        + t447 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_45 = Lambda_T_upper_arm_45 - t468;
    const six_link_real t469 = C_upper_arm_41 * modes_W_upper_arm_16 + t441 * modes_W_upper_arm_26
        + t447 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_46 = Lambda_T_upper_arm_46 - t469;
    const six_link_real t470 = C_upper_arm_51 * modes_W_upper_arm_15 + t442 * modes_W_upper_arm_25
        + t448 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_55 = M_loaded_upper_arm_55 - t470;
    const six_link_real t471 = C_upper_arm_51 * modes_W_upper_arm_16 + t442 * modes_W_upper_arm_26
        + t448 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_56 = Lambda_T_upper_arm_56 - t471;
    const six_link_real t472 = C_upper_arm_61 * modes_W_upper_arm_16 + t443 * modes_W_upper_arm_26
        + t449 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_66 = M_loaded_upper_arm_66 - t472;
    const six_link_real t473 = modes_W_upper_arm_11 * h_phi_upper_arm_1 + modes_W_upper_arm_21 * t450
        + modes_W_upper_arm_31 * t451;
    const six_link_real t474 = modes_W_upper_arm_12 * h_phi_upper_arm_1 + modes_W_upper_arm_22 * t450
        + modes_W_upper_arm_32 * t451;
    const six_link_real t475 = modes_W_upper_arm_13 * h_phi_upper_arm_1 + modes_W_upper_arm_23 * t450
        + modes_W_upper_arm_33 * t451;
    const six_link_real t476 = modes_W_upper_arm_14 * h_phi_upper_arm_1 + modes_W_upper_arm_24 * t450
        + modes_W_upper_arm_34 * t451;
    const six_link_real t477 = modes_W_upper_arm_15 * h_phi_upper_arm_1 + modes_W_upper_arm_25 * t450
        + modes_W_upper_arm_35 * t451;
    const six_link_real t478 = modes_W_upper_arm_16 * h_phi_upper_arm_1 + modes_W_upper_arm_26 * t450
        + modes_W_upper_arm_36 * t451;
    const six_link_real h_i_upper_arm_1 = h_loaded_upper_arm_1 - t473;
    const six_link_real h_i_upper_arm_2 = h_loaded_upper_arm_2 - t474;
    const six_link_real h_i_upper_arm_3 = h_loaded_upper_arm_3 - t475;
    const six_link_real h_i_upper_arm_4 = h_loaded_upper_arm_4 - t476;
    const six_link_real h_i_upper_arm_5 = h_loaded_upper_arm_5 - t477;
    const six_link_real h_i_upper_arm_6 = h_loaded_upper_arm_6 - t478;

    /* upper_arm, joint: its accelerations eliminated from its rows (43) */
    const six_link_real t479 = M_i_upper_arm_13 * minus_beta_omega_upper_arm_z
        + M_i_upper_arm_11 * minus_beta_omega_upper_arm_x;
    const six_link_real t480 = M_i_upper_arm_14 * minus_minus_beta_v_upper_arm_x - t479
        - M_i_upper_arm_16 * minus_beta_v_upper_arm_z;
    const six_link_real t481 = M_i_upper_arm_23 * minus_beta_omega_upper_arm_z
        + M_i_upper_arm_12 * minus_beta_omega_upper_arm_x;
    const six_link_real t482 = M_i_upper_arm_24 * minus_minus_beta_v_upper_arm_x - t481
        - M_i_upper_arm_26 * minus_beta_v_upper_arm_z;
    const six_link_real t483 = M_i_upper_arm_33 * minus_beta_omega_upper_arm_z
        + M_i_upper_arm_13 * minus_beta_omega_upper_arm_x;
    const six_link_real t484 = M_i_upper_arm_34 * minus_minus_beta_v_upper_arm_x - t483
        - M_i_upper_arm_36 * minus_beta_v_upper_arm_z;
    const six_link_real t485 = M_i_upper_arm_34 * minus_beta_omega_upper_arm_z
        + M_i_upper_arm_14 * minus_beta_omega_upper_arm_x;
    const six_link_real t486 = M_i_upper_arm_44 * minus_minus_beta_v_upper_arm_x - t485
        - M_i_upper_arm_46 * minus_beta_v_upper_arm_z;
    const six_link_real t487 = M_i_upper_arm_35 * minus_beta_omega_upper_arm_z
        + M_i_upper_arm_15 * minus_beta_omega_upper_arm_x;
    const six_link_real t488 = M_i_upper_arm_45 * minus_minus_beta_v_upper_arm_x - t487
        - M_i_upper_arm_56 * minus_beta_v_upper_arm_z;
    const six_link_real t489 = M_i_upper_arm_36 * minus_beta_omega_upper_arm_z
        + M_i_upper_arm_16 * minus_beta_omega_upper_arm_x;
    const six_link_real t490 = M_i_upper_arm_46 * minus_minus_beta_v_upper_arm_x - t489
        - M_i_upper_arm_66 * minus_beta_v_upper_arm_z;
    const six_link_real bias_upper_arm_1 = h_i_upper_arm_1 + t480;
    const six_link_real bias_upper_arm_2 = h_i_upper_arm_2 + t482;
    const six_link_real bias_upper_arm_3 = h_i_upper_arm_3 + t484;
    const six_link_real bias_upper_arm_4 = h_i_upper_arm_4 + t486;
    const six_link_real bias_upper_arm_5 = h_i_upper_arm_5 + t488;
    const six_link_real bias_upper_arm_6 = h_i_upper_arm_6 + t490;
    const six_link_real joint_inertia_upper_arm_11 = M_i_upper_arm_22 + c->links[1].armature_1;
    bad |= (unsigned long)(!(joint_inertia_upper_arm_11 - t116 * (M_i_upper_arm_11 + M_i_upper_arm_22 + M_i_upper_arm_33) > 0)) << 1;
    const six_link_real joint_inverse_upper_arm_1 = 1 / joint_inertia_upper_arm_11;
    const six_link_real joint_W_upper_arm_11 = M_i_upper_arm_12 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_12 = M_i_upper_arm_22 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_13 = M_i_upper_arm_23 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_14 = M_i_upper_arm_24 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_15 = M_i_upper_arm_25 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_16 = M_i_upper_arm_26 * joint_inverse_upper_arm_1;
    const six_link_real joint_w_upper_arm_1 = (input->tau[1] - c->links[1].joint_damping_1 * state->v[1]
        - bias_upper_arm_2) * joint_inverse_upper_arm_1;
    const six_link_real Lambda_i_upper_arm_11 = M_i_upper_arm_11 - M_i_upper_arm_12 * joint_W_upper_arm_11;
    const six_link_real Lambda_i_upper_arm_12 = M_i_upper_arm_12 - M_i_upper_arm_12 * joint_W_upper_arm_12;
    const six_link_real Lambda_i_upper_arm_13 = M_i_upper_arm_13 - M_i_upper_arm_12 * joint_W_upper_arm_13;
    const six_link_real Lambda_i_upper_arm_14 = M_i_upper_arm_14 - M_i_upper_arm_12 * joint_W_upper_arm_14;
    const six_link_real Lambda_i_upper_arm_15 = M_i_upper_arm_15 - M_i_upper_arm_12 * joint_W_upper_arm_15;
    const six_link_real Lambda_i_upper_arm_16 = M_i_upper_arm_16 - M_i_upper_arm_12 * joint_W_upper_arm_16;
    const six_link_real Lambda_i_upper_arm_22 = M_i_upper_arm_22 - M_i_upper_arm_22 * joint_W_upper_arm_12;
    const six_link_real Lambda_i_upper_arm_23 = M_i_upper_arm_23 - M_i_upper_arm_22 * joint_W_upper_arm_13;
    const six_link_real Lambda_i_upper_arm_24 = M_i_upper_arm_24 - M_i_upper_arm_22 * joint_W_upper_arm_14;
    const six_link_real Lambda_i_upper_arm_25 = M_i_upper_arm_25 - M_i_upper_arm_22 * joint_W_upper_arm_15;
    const six_link_real Lambda_i_upper_arm_26 = M_i_upper_arm_26 - M_i_upper_arm_22 * joint_W_upper_arm_16;
    const six_link_real Lambda_i_upper_arm_33 = M_i_upper_arm_33 - M_i_upper_arm_23 * joint_W_upper_arm_13;
    const six_link_real Lambda_i_upper_arm_34 = M_i_upper_arm_34 - M_i_upper_arm_23 * joint_W_upper_arm_14;
    const six_link_real Lambda_i_upper_arm_35 = M_i_upper_arm_35 - M_i_upper_arm_23 * joint_W_upper_arm_15;
    const six_link_real Lambda_i_upper_arm_36 = M_i_upper_arm_36 - M_i_upper_arm_23 * joint_W_upper_arm_16;
    const six_link_real Lambda_i_upper_arm_44 = M_i_upper_arm_44 - M_i_upper_arm_24 * joint_W_upper_arm_14;
    const six_link_real Lambda_i_upper_arm_45 = M_i_upper_arm_45 - M_i_upper_arm_24 * joint_W_upper_arm_15;
    const six_link_real Lambda_i_upper_arm_46 = M_i_upper_arm_46 - M_i_upper_arm_24 * joint_W_upper_arm_16;
    const six_link_real Lambda_i_upper_arm_55 = M_i_upper_arm_55 - M_i_upper_arm_25 * joint_W_upper_arm_15;
    const six_link_real Lambda_i_upper_arm_56 = M_i_upper_arm_56 - M_i_upper_arm_25 * joint_W_upper_arm_16;
    const six_link_real Lambda_i_upper_arm_66 = M_i_upper_arm_66 - M_i_upper_arm_26 * joint_W_upper_arm_16;
    const six_link_real p_i_upper_arm_1 = bias_upper_arm_1 + M_i_upper_arm_12 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_2 = bias_upper_arm_2 + M_i_upper_arm_22 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_3 = bias_upper_arm_3 + M_i_upper_arm_23 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_4 = bias_upper_arm_4 + M_i_upper_arm_24 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_5 = bias_upper_arm_5 + M_i_upper_arm_25 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_6 = bias_upper_arm_6 + M_i_upper_arm_26 * joint_w_upper_arm_1;

    /* upper_arm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t491 = Lambda_i_upper_arm_13 * R_rel_upper_arm_xz;
    const six_link_real t492 = Lambda_i_upper_arm_13 * R_rel_upper_arm_xx;
    const six_link_real t493 = t492 - Lambda_i_upper_arm_11 * R_rel_upper_arm_xz;
    const six_link_real t494 = Lambda_i_upper_arm_33 * R_rel_upper_arm_xx - t491;
    const six_link_real t495 = R_rel_upper_arm_xx * (Lambda_i_upper_arm_11 * R_rel_upper_arm_xx + t491)
        + R_rel_upper_arm_xz * (t492 + Lambda_i_upper_arm_33 * R_rel_upper_arm_xz);
    const six_link_real t496 = Lambda_i_upper_arm_14 * R_rel_upper_arm_xx
        + Lambda_i_upper_arm_16 * R_rel_upper_arm_xz;
    const six_link_real t497 = Lambda_i_upper_arm_16 * R_rel_upper_arm_xx
        - Lambda_i_upper_arm_14 * R_rel_upper_arm_xz;
    const six_link_real t498 = Lambda_i_upper_arm_24 * R_rel_upper_arm_xx
        + Lambda_i_upper_arm_26 * R_rel_upper_arm_xz;
    const six_link_real t499 = Lambda_i_upper_arm_26 * R_rel_upper_arm_xx
        - Lambda_i_upper_arm_24 * R_rel_upper_arm_xz;
    const six_link_real t500 = Lambda_i_upper_arm_34 * R_rel_upper_arm_xx
        + Lambda_i_upper_arm_36 * R_rel_upper_arm_xz;
    const six_link_real t501 = Lambda_i_upper_arm_36 * R_rel_upper_arm_xx
        - Lambda_i_upper_arm_34 * R_rel_upper_arm_xz;
    const six_link_real t502 = R_rel_upper_arm_xx * t496 + R_rel_upper_arm_xz * t500;
    const six_link_real t503 = R_rel_upper_arm_xx * Lambda_i_upper_arm_15
        + R_rel_upper_arm_xz * Lambda_i_upper_arm_35;
    const six_link_real t504 = R_rel_upper_arm_xx * t497 + R_rel_upper_arm_xz * t501;
    const six_link_real t505 = R_rel_upper_arm_xx * t500 - R_rel_upper_arm_xz * t496;
    const six_link_real t506 = R_rel_upper_arm_xx * Lambda_i_upper_arm_35
        - R_rel_upper_arm_xz * Lambda_i_upper_arm_15;
    const six_link_real t507 = Lambda_i_upper_arm_46 * R_rel_upper_arm_xz;
    const six_link_real t508 = Lambda_i_upper_arm_46 * R_rel_upper_arm_xx;
    const six_link_real t509 = t508 - Lambda_i_upper_arm_44 * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_17 = Lambda_i_upper_arm_45 * R_rel_upper_arm_xx
        + Lambda_i_upper_arm_56 * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_20 = Lambda_i_upper_arm_56 * R_rel_upper_arm_xx
        - Lambda_i_upper_arm_45 * R_rel_upper_arm_xz;
    const six_link_real t510 = Lambda_i_upper_arm_66 * R_rel_upper_arm_xx - t507;
    const six_link_real Lambda_upper_arm_16 = R_rel_upper_arm_xx
        * (Lambda_i_upper_arm_44 * R_rel_upper_arm_xx + t507)
        + R_rel_upper_arm_xz * (t508 + Lambda_i_upper_arm_66 * R_rel_upper_arm_xz);
    const six_link_real Lambda_upper_arm_18 = R_rel_upper_arm_xx * t509 + R_rel_upper_arm_xz * t510;
    const six_link_real Lambda_upper_arm_21 = R_rel_upper_arm_xx * t510 - R_rel_upper_arm_xz * t509;
    const six_link_real t511 = c->links[1].mount_xyz_z * Lambda_upper_arm_17;
    const six_link_real t512 = c->links[1].mount_xyz_y * Lambda_upper_arm_18;
    const six_link_real t513 = c->links[1].mount_xyz_x * Lambda_upper_arm_20;
    const six_link_real Lambda_upper_arm_4 = t502 + (t512 - t511);
    const six_link_real Lambda_upper_arm_5 = t503
        + (c->links[1].mount_xyz_y * Lambda_upper_arm_20 - c->links[1].mount_xyz_z * Lambda_i_upper_arm_55);
    const six_link_real Lambda_upper_arm_6 = t504
        + (c->links[1].mount_xyz_y * Lambda_upper_arm_21 - c->links[1].mount_xyz_z * Lambda_upper_arm_20);
    const six_link_real Lambda_upper_arm_9 = t498
        + (c->links[1].mount_xyz_z * Lambda_upper_arm_16 - c->links[1].mount_xyz_x * Lambda_upper_arm_18);
    const six_link_real Lambda_upper_arm_10 = Lambda_i_upper_arm_25 + (t511 - t513);
    const six_link_real Lambda_upper_arm_11 = t499
        + (c->links[1].mount_xyz_z * Lambda_upper_arm_18 - c->links[1].mount_xyz_x * Lambda_upper_arm_21);
    const six_link_real Lambda_upper_arm_13 = t505
        + (c->links[1].mount_xyz_x * Lambda_upper_arm_17 - c->links[1].mount_xyz_y * Lambda_upper_arm_16);
    const six_link_real Lambda_upper_arm_14 = t506
        + (c->links[1].mount_xyz_x * Lambda_i_upper_arm_55 - c->links[1].mount_xyz_y * Lambda_upper_arm_17);
    const six_link_real Lambda_upper_arm_15 = R_rel_upper_arm_xx * t501 - R_rel_upper_arm_xz * t497
        + (t513 - t512);
    const six_link_real Lambda_upper_arm_1 = t495
        - (t503 * c->links[1].mount_xyz_z - t504 * c->links[1].mount_xyz_y)
        + (c->links[1].mount_xyz_y * Lambda_upper_arm_6 - c->links[1].mount_xyz_z * Lambda_upper_arm_5);
    const six_link_real t514 = R_rel_upper_arm_xx * t493 + R_rel_upper_arm_xz * t494
        - (t502 * c->links[1].mount_xyz_y - t503 * c->links[1].mount_xyz_x);
    const six_link_real Lambda_upper_arm_3 = t514
        + (c->links[1].mount_xyz_y * Lambda_upper_arm_15 - c->links[1].mount_xyz_z * Lambda_upper_arm_14);
    const six_link_real Lambda_upper_arm_7 = Lambda_i_upper_arm_22
        - (t499 * c->links[1].mount_xyz_x - t498 * c->links[1].mount_xyz_z)
        + (c->links[1].mount_xyz_z * Lambda_upper_arm_9 - c->links[1].mount_xyz_x * Lambda_upper_arm_11);
    const six_link_real t515 = Lambda_i_upper_arm_23 * R_rel_upper_arm_xx
        - Lambda_i_upper_arm_12 * R_rel_upper_arm_xz
        - (t498 * c->links[1].mount_xyz_y - Lambda_i_upper_arm_25 * c->links[1].mount_xyz_x);
    const six_link_real Lambda_upper_arm_8 = t515
        + (c->links[1].mount_xyz_z * Lambda_upper_arm_13 - c->links[1].mount_xyz_x * Lambda_upper_arm_15);
    const six_link_real t516 = R_rel_upper_arm_xx * t494 - R_rel_upper_arm_xz * t493
        - (t505 * c->links[1].mount_xyz_y - t506 * c->links[1].mount_xyz_x);
    const six_link_real Lambda_upper_arm_12 = t516
        + (c->links[1].mount_xyz_x * Lambda_upper_arm_14 - c->links[1].mount_xyz_y * Lambda_upper_arm_13);
    const six_link_real p_upper_arm_4 = R_rel_upper_arm_xx * p_i_upper_arm_4
        + R_rel_upper_arm_xz * p_i_upper_arm_6;
    const six_link_real p_upper_arm_6 = R_rel_upper_arm_xx * p_i_upper_arm_6
        - R_rel_upper_arm_xz * p_i_upper_arm_4;
    const six_link_real p_upper_arm_1 = R_rel_upper_arm_xx * p_i_upper_arm_1
        + R_rel_upper_arm_xz * p_i_upper_arm_3
        + (c->links[1].mount_xyz_y * p_upper_arm_6 - c->links[1].mount_xyz_z * p_i_upper_arm_5);
    const six_link_real p_upper_arm_2 = p_i_upper_arm_2
        + (c->links[1].mount_xyz_z * p_upper_arm_4 - c->links[1].mount_xyz_x * p_upper_arm_6);
    const six_link_real p_upper_arm_3 = R_rel_upper_arm_xx * p_i_upper_arm_3
        - R_rel_upper_arm_xz * p_i_upper_arm_1
        + (c->links[1].mount_xyz_x * p_i_upper_arm_5 - c->links[1].mount_xyz_y * p_upper_arm_4);

    /* shoulder, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real Lambda_T_shoulder_11 = Lambda_upper_arm_1 + c->links[0].I_T_xx;
    const six_link_real Lambda_T_shoulder_13 = Lambda_upper_arm_3 - c->links[0].J_T_xz;
    const six_link_real Lambda_T_shoulder_15 = Lambda_upper_arm_5 - c->links[0].S_T_z;
    const six_link_real Lambda_T_shoulder_16 = Lambda_upper_arm_6 + c->links[0].S_T_y;
    const six_link_real Lambda_T_shoulder_22 = Lambda_upper_arm_7 + c->links[0].I_T_yy;
    const six_link_real Lambda_T_shoulder_23 = Lambda_upper_arm_8 - c->links[0].J_T_yz;
    const six_link_real Lambda_T_shoulder_24 = Lambda_upper_arm_9 + c->links[0].S_T_z;
    const six_link_real Lambda_T_shoulder_26 = Lambda_upper_arm_11 - c->links[0].S_T_x;
    const six_link_real Lambda_T_shoulder_33 = Lambda_upper_arm_12 + c->links[0].I_T_zz;
    const six_link_real Lambda_T_shoulder_34 = Lambda_upper_arm_13 - c->links[0].S_T_y;
    const six_link_real Lambda_T_shoulder_35 = Lambda_upper_arm_14 + c->links[0].S_T_x;
    const six_link_real Lambda_T_shoulder_44 = Lambda_upper_arm_16 + c->links[0].body0_mass;
    const six_link_real Lambda_T_shoulder_55 = Lambda_i_upper_arm_55 + c->links[0].body0_mass;
    const six_link_real Lambda_T_shoulder_66 = Lambda_upper_arm_21 + c->links[0].body0_mass;
    const six_link_real p_T_shoulder_1 = p_upper_arm_1 + h_T_tau_shoulder_x - input->w_ext[0][0];
    const six_link_real p_T_shoulder_2 = p_upper_arm_2 - minus_h_T_tau_shoulder_y - input->w_ext[0][1];
    const six_link_real p_T_shoulder_3 = p_upper_arm_3 + h_T_tau_shoulder_z - input->w_ext[0][2];
    const six_link_real p_T_shoulder_4 = p_upper_arm_4 - minus_h_T_F_shoulder_x - input->w_ext[0][3];
    const six_link_real p_T_shoulder_5 = p_i_upper_arm_5 - minus_h_T_F_shoulder_y - input->w_ext[0][4];
    const six_link_real p_T_shoulder_6 = p_upper_arm_6 - input->w_ext[0][5];

    /* shoulder, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t517 = c->links[0].length * Lambda_upper_arm_20;
    const six_link_real M_loaded_shoulder_24 = Lambda_T_shoulder_24 - c->links[0].length * Lambda_upper_arm_18;
    const six_link_real M_loaded_shoulder_25 = Lambda_upper_arm_10 - t517;
    const six_link_real t518 = Lambda_T_shoulder_26 - c->links[0].length * Lambda_T_shoulder_66;
    const six_link_real M_loaded_shoulder_34 = Lambda_T_shoulder_34 + c->links[0].length * Lambda_upper_arm_17;
    const six_link_real t519 = Lambda_T_shoulder_35 + c->links[0].length * Lambda_T_shoulder_55;
    const six_link_real M_loaded_shoulder_36 = Lambda_upper_arm_15 + t517;
    const six_link_real M_loaded_shoulder_13 = Lambda_T_shoulder_13 + Lambda_T_shoulder_15 * c->links[0].length;
    const six_link_real M_loaded_shoulder_23 = Lambda_T_shoulder_23 + Lambda_upper_arm_10 * c->links[0].length
        - c->links[0].length * M_loaded_shoulder_36;
    const six_link_real M_loaded_shoulder_11 = c->links[0].I_s + Lambda_T_shoulder_11;
    const six_link_real M_loaded_shoulder_22 = c->links[0].J_0_xx
        + (Lambda_T_shoulder_22 - Lambda_T_shoulder_26 * c->links[0].length - c->links[0].length * t518);
    const six_link_real M_loaded_shoulder_26 = t518 - c->links[0].S_0_x;
    const six_link_real M_loaded_shoulder_33 = c->links[0].J_0_xx
        + (Lambda_T_shoulder_33 + Lambda_T_shoulder_35 * c->links[0].length + c->links[0].length * t519);
    const six_link_real M_loaded_shoulder_35 = c->links[0].S_0_x + t519;
    const six_link_real M_loaded_shoulder_44 = c->links[0].mu + Lambda_T_shoulder_44;
    const six_link_real M_loaded_shoulder_55 = c->links[0].mu + Lambda_T_shoulder_55;
    const six_link_real M_loaded_shoulder_66 = c->links[0].mu + Lambda_T_shoulder_66;
    const six_link_real h_loaded_shoulder_2 = p_T_shoulder_2 - c->links[0].length * p_T_shoulder_6;
    const six_link_real h_loaded_shoulder_3 = p_T_shoulder_3 + c->links[0].length * p_T_shoulder_5;
    const six_link_real h_loaded_shoulder_4 = p_T_shoulder_4 - minus_H_star_shoulder_4;

    /* shoulder, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_shoulder_11 = M_loaded_shoulder_33 + c->links[0].armature_1;
    bad |= (unsigned long)(!(joint_inertia_shoulder_11 - t116 * (M_loaded_shoulder_11 + M_loaded_shoulder_22 + M_loaded_shoulder_33) > 0)) << 0;
    const six_link_real joint_inverse_shoulder_1 = 1 / joint_inertia_shoulder_11;
    const six_link_real joint_W_shoulder_14 = M_loaded_shoulder_34 * joint_inverse_shoulder_1;
    const six_link_real joint_W_shoulder_15 = M_loaded_shoulder_35 * joint_inverse_shoulder_1;
    const six_link_real joint_W_shoulder_16 = M_loaded_shoulder_36 * joint_inverse_shoulder_1;
    const six_link_real joint_w_shoulder_1 = (input->tau[0] - c->links[0].joint_damping_1 * state->v[0]
        - h_loaded_shoulder_3) * joint_inverse_shoulder_1;
    const six_link_real Lambda_i_shoulder_14 = Lambda_upper_arm_4 - M_loaded_shoulder_13 * joint_W_shoulder_14;
    const six_link_real Lambda_i_shoulder_15 = Lambda_T_shoulder_15 - M_loaded_shoulder_13 * joint_W_shoulder_15;
    const six_link_real Lambda_i_shoulder_16 = Lambda_T_shoulder_16 - M_loaded_shoulder_13 * joint_W_shoulder_16;
    const six_link_real Lambda_i_shoulder_24 = M_loaded_shoulder_24 - M_loaded_shoulder_23 * joint_W_shoulder_14;
    const six_link_real Lambda_i_shoulder_25 = M_loaded_shoulder_25 - M_loaded_shoulder_23 * joint_W_shoulder_15;
    const six_link_real Lambda_i_shoulder_26 = M_loaded_shoulder_26 - M_loaded_shoulder_23 * joint_W_shoulder_16;
    const six_link_real Lambda_i_shoulder_34 = M_loaded_shoulder_34 - M_loaded_shoulder_33 * joint_W_shoulder_14;
    const six_link_real Lambda_i_shoulder_35 = M_loaded_shoulder_35 - M_loaded_shoulder_33 * joint_W_shoulder_15;
    const six_link_real Lambda_i_shoulder_36 = M_loaded_shoulder_36 - M_loaded_shoulder_33 * joint_W_shoulder_16;
    const six_link_real Lambda_i_shoulder_44 = M_loaded_shoulder_44 - M_loaded_shoulder_34 * joint_W_shoulder_14;
    const six_link_real Lambda_i_shoulder_45 = Lambda_upper_arm_17 - M_loaded_shoulder_34 * joint_W_shoulder_15;
    const six_link_real Lambda_i_shoulder_46 = Lambda_upper_arm_18 - M_loaded_shoulder_34 * joint_W_shoulder_16;
    const six_link_real Lambda_i_shoulder_55 = M_loaded_shoulder_55 - M_loaded_shoulder_35 * joint_W_shoulder_15;
    const six_link_real Lambda_i_shoulder_56 = Lambda_upper_arm_20 - M_loaded_shoulder_35 * joint_W_shoulder_16;
    const six_link_real Lambda_i_shoulder_66 = M_loaded_shoulder_66 - M_loaded_shoulder_36 * joint_W_shoulder_16;
    const six_link_real p_i_shoulder_1 = p_T_shoulder_1 + M_loaded_shoulder_13 * joint_w_shoulder_1;
    const six_link_real p_i_shoulder_2 = h_loaded_shoulder_2 + M_loaded_shoulder_23 * joint_w_shoulder_1;
    const six_link_real p_i_shoulder_3 = h_loaded_shoulder_3 + M_loaded_shoulder_33 * joint_w_shoulder_1;
    const six_link_real p_i_shoulder_4 = h_loaded_shoulder_4 + M_loaded_shoulder_34 * joint_w_shoulder_1;
    const six_link_real p_i_shoulder_5 = p_T_shoulder_5 + M_loaded_shoulder_35 * joint_w_shoulder_1;
    const six_link_real p_i_shoulder_6 = p_T_shoulder_6 + M_loaded_shoulder_36 * joint_w_shoulder_1;

    /* shoulder, joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real minus_carried_shoulder_4 = R_rel_shoulder_xx * c->gravity[0]
        + minus_R_rel_shoulder_xy * c->gravity[1];
    const six_link_real carried_shoulder_5 = minus_R_rel_shoulder_xy * c->gravity[0]
        - R_rel_shoulder_xx * c->gravity[1];
    const six_link_real t520 = joint_W_shoulder_15 * carried_shoulder_5
        - joint_W_shoulder_14 * minus_carried_shoulder_4 - joint_W_shoulder_16 * c->gravity[2];
    const six_link_real qddot_shoulder_1 = joint_w_shoulder_1 - t520;
    output->vdot[0] = qddot_shoulder_1;
    const six_link_real t521 = Lambda_i_shoulder_15 * carried_shoulder_5
        - Lambda_i_shoulder_14 * minus_carried_shoulder_4 - Lambda_i_shoulder_16 * c->gravity[2];
    const six_link_real t522 = Lambda_i_shoulder_25 * carried_shoulder_5
        - Lambda_i_shoulder_24 * minus_carried_shoulder_4 - Lambda_i_shoulder_26 * c->gravity[2];
    const six_link_real t523 = Lambda_i_shoulder_35 * carried_shoulder_5
        - Lambda_i_shoulder_34 * minus_carried_shoulder_4 - Lambda_i_shoulder_36 * c->gravity[2];
    const six_link_real t524 = Lambda_i_shoulder_45 * carried_shoulder_5
        - Lambda_i_shoulder_44 * minus_carried_shoulder_4 - Lambda_i_shoulder_46 * c->gravity[2];
    const six_link_real t525 = Lambda_i_shoulder_55 * carried_shoulder_5
        - Lambda_i_shoulder_45 * minus_carried_shoulder_4 - Lambda_i_shoulder_56 * c->gravity[2];
    const six_link_real t526 = Lambda_i_shoulder_56 * carried_shoulder_5
        - Lambda_i_shoulder_46 * minus_carried_shoulder_4 - Lambda_i_shoulder_66 * c->gravity[2];
    const six_link_real wrench_shoulder_1 = t521 + p_i_shoulder_1;
    output->wrench[0][0] = wrench_shoulder_1;
    const six_link_real wrench_shoulder_2 = t522 + p_i_shoulder_2;
    output->wrench[0][1] = wrench_shoulder_2;
    const six_link_real wrench_shoulder_3 = t523 + p_i_shoulder_3;
    output->wrench[0][2] = wrench_shoulder_3;
    const six_link_real wrench_shoulder_4 = t524 + p_i_shoulder_4;
    output->wrench[0][3] = wrench_shoulder_4;
    const six_link_real wrench_shoulder_5 = t525 + p_i_shoulder_5;
    output->wrench[0][4] = wrench_shoulder_5;
    const six_link_real wrench_shoulder_6 = t526 + p_i_shoulder_6;
    output->wrench[0][5] = wrench_shoulder_6;

    /* shoulder, tip: acceleration of the tip section (accconst1b) */
    const six_link_real alpha_T_shoulder_5 = carried_shoulder_5 + qddot_shoulder_1 * c->links[0].length;

    /* upper_arm, joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real t527 = minus_carried_shoulder_4 + qddot_shoulder_1 * c->links[1].mount_xyz_y;
    const six_link_real carried_upper_arm_5 = alpha_T_shoulder_5 + qddot_shoulder_1 * c->links[1].mount_xyz_x;
    const six_link_real minus_carried_upper_arm_1 = R_rel_upper_arm_xz * qddot_shoulder_1;
    const six_link_real carried_upper_arm_3 = R_rel_upper_arm_xx * qddot_shoulder_1;
    const six_link_real carried_upper_arm_4 = R_rel_upper_arm_xz * c->gravity[2] - R_rel_upper_arm_xx * t527;
    const six_link_real minus_carried_upper_arm_6 = R_rel_upper_arm_xz * t527
        + R_rel_upper_arm_xx * c->gravity[2];
    const six_link_real t528 = joint_W_upper_arm_13 * carried_upper_arm_3
        - joint_W_upper_arm_11 * minus_carried_upper_arm_1 + joint_W_upper_arm_14 * carried_upper_arm_4;
    const six_link_real t529 = t528 + joint_W_upper_arm_15 * carried_upper_arm_5
        - joint_W_upper_arm_16 * minus_carried_upper_arm_6;
    const six_link_real qddot_upper_arm_1 = joint_w_upper_arm_1 - t529;
    output->vdot[1] = qddot_upper_arm_1;
    const six_link_real t530 = Lambda_i_upper_arm_13 * carried_upper_arm_3
        - Lambda_i_upper_arm_11 * minus_carried_upper_arm_1 + Lambda_i_upper_arm_14 * carried_upper_arm_4;
    const six_link_real t531 = t530 + Lambda_i_upper_arm_15 * carried_upper_arm_5
        - Lambda_i_upper_arm_16 * minus_carried_upper_arm_6;
    const six_link_real t532 = Lambda_i_upper_arm_23 * carried_upper_arm_3
        - Lambda_i_upper_arm_12 * minus_carried_upper_arm_1 + Lambda_i_upper_arm_24 * carried_upper_arm_4;
    const six_link_real t533 = t532 + Lambda_i_upper_arm_25 * carried_upper_arm_5
        - Lambda_i_upper_arm_26 * minus_carried_upper_arm_6;
    const six_link_real t534 = Lambda_i_upper_arm_33 * carried_upper_arm_3
        - Lambda_i_upper_arm_13 * minus_carried_upper_arm_1 + Lambda_i_upper_arm_34 * carried_upper_arm_4;
    const six_link_real t535 = t534 + Lambda_i_upper_arm_35 * carried_upper_arm_5
        - Lambda_i_upper_arm_36 * minus_carried_upper_arm_6;
    const six_link_real t536 = Lambda_i_upper_arm_34 * carried_upper_arm_3
        - Lambda_i_upper_arm_14 * minus_carried_upper_arm_1 + Lambda_i_upper_arm_44 * carried_upper_arm_4;
    const six_link_real t537 = t536 + Lambda_i_upper_arm_45 * carried_upper_arm_5
        - Lambda_i_upper_arm_46 * minus_carried_upper_arm_6;
    const six_link_real t538 = Lambda_i_upper_arm_35 * carried_upper_arm_3
        - Lambda_i_upper_arm_15 * minus_carried_upper_arm_1 + Lambda_i_upper_arm_45 * carried_upper_arm_4;
    const six_link_real t539 = t538 + Lambda_i_upper_arm_55 * carried_upper_arm_5
        - Lambda_i_upper_arm_56 * minus_carried_upper_arm_6;
    const six_link_real t540 = Lambda_i_upper_arm_36 * carried_upper_arm_3
        - Lambda_i_upper_arm_16 * minus_carried_upper_arm_1 + Lambda_i_upper_arm_46 * carried_upper_arm_4;
    const six_link_real t541 = t540 + Lambda_i_upper_arm_56 * carried_upper_arm_5
        - Lambda_i_upper_arm_66 * minus_carried_upper_arm_6;
    const six_link_real wrench_upper_arm_1 = t531 + p_i_upper_arm_1;
    output->wrench[1][0] = wrench_upper_arm_1;
    const six_link_real wrench_upper_arm_2 = t533 + p_i_upper_arm_2;
    output->wrench[1][1] = wrench_upper_arm_2;
    const six_link_real wrench_upper_arm_3 = t535 + p_i_upper_arm_3;
    output->wrench[1][2] = wrench_upper_arm_3;
    const six_link_real wrench_upper_arm_4 = t537 + p_i_upper_arm_4;
    output->wrench[1][3] = wrench_upper_arm_4;
    const six_link_real wrench_upper_arm_5 = t539 + p_i_upper_arm_5;
    output->wrench[1][4] = wrench_upper_arm_5;
    const six_link_real wrench_upper_arm_6 = t541 + p_i_upper_arm_6;
    output->wrench[1][5] = wrench_upper_arm_6;

    /* upper_arm, link: acceleration of F_i, modal accelerations (83) */
    const six_link_real minus_alpha_upper_arm_1 = minus_carried_upper_arm_1 + minus_beta_omega_upper_arm_x;
    const six_link_real alpha_upper_arm_3 = carried_upper_arm_3 - minus_beta_omega_upper_arm_z;
    const six_link_real alpha_upper_arm_4 = carried_upper_arm_4 + minus_minus_beta_v_upper_arm_x;
    const six_link_real minus_alpha_upper_arm_6 = minus_carried_upper_arm_6 + minus_beta_v_upper_arm_z;
    const six_link_real t542 = modes_W_upper_arm_12 * qddot_upper_arm_1
        - modes_W_upper_arm_11 * minus_alpha_upper_arm_1 + modes_W_upper_arm_13 * alpha_upper_arm_3;
    const six_link_real t543 = t542 + modes_W_upper_arm_14 * alpha_upper_arm_4
        + modes_W_upper_arm_15 * carried_upper_arm_5 - modes_W_upper_arm_16 * minus_alpha_upper_arm_6;
    const six_link_real t544 = modes_W_upper_arm_22 * qddot_upper_arm_1
        - modes_W_upper_arm_21 * minus_alpha_upper_arm_1 + modes_W_upper_arm_23 * alpha_upper_arm_3;
    const six_link_real t545 = t544 + modes_W_upper_arm_24 * alpha_upper_arm_4
        + modes_W_upper_arm_25 * carried_upper_arm_5 - modes_W_upper_arm_26 * minus_alpha_upper_arm_6;
    const six_link_real t546 = modes_W_upper_arm_32 * qddot_upper_arm_1
        - modes_W_upper_arm_31 * minus_alpha_upper_arm_1 + modes_W_upper_arm_33 * alpha_upper_arm_3;
    const six_link_real t547 = t546 + modes_W_upper_arm_34 * alpha_upper_arm_4
        + modes_W_upper_arm_35 * carried_upper_arm_5 - modes_W_upper_arm_36 * minus_alpha_upper_arm_6;
    const six_link_real minus_etaddot_upper_arm_3 = modes_w_upper_arm_3 + t547;
    output->vdot[8] = -minus_etaddot_upper_arm_3;
    const six_link_real minus_etaddot_upper_arm_2 = modes_w_upper_arm_2 + t545
        - modes_L_upper_arm_32 * minus_etaddot_upper_arm_3;
    output->vdot[7] = -minus_etaddot_upper_arm_2;
    const six_link_real minus_etaddot_upper_arm_1 = modes_w_upper_arm_1 + t543
        - modes_L_upper_arm_21 * minus_etaddot_upper_arm_2 - modes_L_upper_arm_31 * minus_etaddot_upper_arm_3;
    output->vdot[6] = -minus_etaddot_upper_arm_1;
    const six_link_real t548 = -minus_etaddot_upper_arm_1;
    output->vdot[6] = t548;
    const six_link_real t549 = -minus_etaddot_upper_arm_2;
    output->vdot[7] = t549;
    const six_link_real t550 = -minus_etaddot_upper_arm_3;
    output->vdot[8] = t550;

    /* upper_arm, tip: acceleration of the tip section (accconst1b) */
    const six_link_real t551 = minus_etaddot_upper_arm_3 * REAL(1.4142135623730951);
    const six_link_real t552 = c->links[1].Psi_c_y2 * minus_etaddot_upper_arm_2;
    const six_link_real t553 = c->links[1].Psi_c_z1 * minus_etaddot_upper_arm_1;
    const six_link_real t554 = alpha_upper_arm_4
        + (qddot_upper_arm_1 * r_T_upper_arm_z - alpha_upper_arm_3 * r_T_upper_arm_y);
    const six_link_real t555 = carried_upper_arm_5
        + (alpha_upper_arm_3 * c->links[1].length + minus_alpha_upper_arm_1 * r_T_upper_arm_z);
    const six_link_real t556 = minus_alpha_upper_arm_6
        + (minus_alpha_upper_arm_1 * r_T_upper_arm_y + qddot_upper_arm_1 * c->links[1].length);
    const six_link_real t557 = minus_alpha_upper_arm_1
        + (J_l_upper_arm_xx * t551 + J_l_upper_arm_xy * t552 + J_l_upper_arm_xz * t553);
    const six_link_real t558 = qddot_upper_arm_1
        - (J_l_upper_arm_yx * t551 + J_l_upper_arm_yy * t552 + J_l_upper_arm_yz * t553);
    const six_link_real t559 = alpha_upper_arm_3
        - (J_l_upper_arm_zx * t551 + J_l_upper_arm_zy * t552 + J_l_upper_arm_zz * t553);
    const six_link_real t560 = t555 - minus_etaddot_upper_arm_1 * 2;
    const six_link_real t561 = t556 + minus_etaddot_upper_arm_2 * 2;
    const six_link_real alpha_T_upper_arm_1 = R_T_upper_arm_yx * t558 - R_T_upper_arm_xx * t557
        + R_T_upper_arm_zx * t559 + b_omega_upper_arm_x;
    const six_link_real alpha_T_upper_arm_2 = R_T_upper_arm_yy * t558 - R_T_upper_arm_xy * t557
        + R_T_upper_arm_zy * t559 + b_omega_upper_arm_y;
    const six_link_real alpha_T_upper_arm_3 = R_T_upper_arm_yz * t558 - R_T_upper_arm_xz * t557
        + R_T_upper_arm_zz * t559 + b_omega_upper_arm_z;
    const six_link_real alpha_T_upper_arm_4 = R_T_upper_arm_xx * t554 + R_T_upper_arm_yx * t560
        - R_T_upper_arm_zx * t561 + b_v_upper_arm_x;
    const six_link_real alpha_T_upper_arm_5 = R_T_upper_arm_xy * t554 + R_T_upper_arm_yy * t560
        - R_T_upper_arm_zy * t561 + b_v_upper_arm_y;
    const six_link_real alpha_T_upper_arm_6 = R_T_upper_arm_xz * t554 + R_T_upper_arm_yz * t560
        - R_T_upper_arm_zz * t561 + b_v_upper_arm_z;

    /* forearm, joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real t562 = alpha_T_upper_arm_4
        + (alpha_T_upper_arm_2 * c->links[2].mount_xyz_z - alpha_T_upper_arm_3 * c->links[2].mount_xyz_y);
    const six_link_real t563 = alpha_T_upper_arm_5
        + (alpha_T_upper_arm_3 * c->links[2].mount_xyz_x - alpha_T_upper_arm_1 * c->links[2].mount_xyz_z);
    const six_link_real t564 = alpha_T_upper_arm_6
        + (alpha_T_upper_arm_1 * c->links[2].mount_xyz_y - alpha_T_upper_arm_2 * c->links[2].mount_xyz_x);
    const six_link_real carried_forearm_1 = R_rel_forearm_xx * alpha_T_upper_arm_1
        + R_rel_forearm_yx * alpha_T_upper_arm_2 + R_rel_forearm_zx * alpha_T_upper_arm_3;
    const six_link_real carried_forearm_2 = c->links[2].R_m_xy * alpha_T_upper_arm_1
        + c->links[2].R_m_yy * alpha_T_upper_arm_2 + c->links[2].R_m_zy * alpha_T_upper_arm_3;
    const six_link_real carried_forearm_3 = R_rel_forearm_xz * alpha_T_upper_arm_1
        + R_rel_forearm_yz * alpha_T_upper_arm_2 + R_rel_forearm_zz * alpha_T_upper_arm_3;
    const six_link_real carried_forearm_4 = R_rel_forearm_xx * t562 + R_rel_forearm_yx * t563
        + R_rel_forearm_zx * t564;
    const six_link_real carried_forearm_5 = c->links[2].R_m_xy * t562 + c->links[2].R_m_yy * t563
        + c->links[2].R_m_zy * t564;
    const six_link_real carried_forearm_6 = R_rel_forearm_xz * t562 + R_rel_forearm_yz * t563
        + R_rel_forearm_zz * t564;
    const six_link_real t565 = joint_W_forearm_11 * carried_forearm_1 + joint_W_forearm_12 * carried_forearm_2
        + joint_W_forearm_13 * carried_forearm_3;
    const six_link_real t566 = t565 + joint_W_forearm_14 * carried_forearm_4
        + joint_W_forearm_15 * carried_forearm_5 + joint_W_forearm_16 * carried_forearm_6;
    const six_link_real qddot_forearm_1 = joint_w_forearm_1 - t566;
    output->vdot[2] = qddot_forearm_1;
    const six_link_real t567 = Lambda_i_forearm_11 * carried_forearm_1 + Lambda_i_forearm_12 * carried_forearm_2
        + Lambda_i_forearm_13 * carried_forearm_3;
    const six_link_real t568 = t567 + Lambda_i_forearm_14 * carried_forearm_4
        + Lambda_i_forearm_15 * carried_forearm_5 + Lambda_i_forearm_16 * carried_forearm_6;
    const six_link_real t569 = Lambda_i_forearm_12 * carried_forearm_1 + Lambda_i_forearm_22 * carried_forearm_2
        + Lambda_i_forearm_23 * carried_forearm_3;
    const six_link_real t570 = t569 + Lambda_i_forearm_24 * carried_forearm_4
        + Lambda_i_forearm_25 * carried_forearm_5 + Lambda_i_forearm_26 * carried_forearm_6;
    const six_link_real t571 = Lambda_i_forearm_13 * carried_forearm_1 + Lambda_i_forearm_23 * carried_forearm_2
        + Lambda_i_forearm_33 * carried_forearm_3;
    const six_link_real t572 = t571 + Lambda_i_forearm_34 * carried_forearm_4
        + Lambda_i_forearm_35 * carried_forearm_5 + Lambda_i_forearm_36 * carried_forearm_6;
    const six_link_real t573 = Lambda_i_forearm_14 * carried_forearm_1 + Lambda_i_forearm_24 * carried_forearm_2
        + Lambda_i_forearm_34 * carried_forearm_3;
    const six_link_real t574 = t573 + Lambda_i_forearm_44 * carried_forearm_4
        + Lambda_i_forearm_45 * carried_forearm_5 + Lambda_i_forearm_46 * carried_forearm_6;
    const six_link_real t575 = Lambda_i_forearm_15 * carried_forearm_1 + Lambda_i_forearm_25 * carried_forearm_2
        + Lambda_i_forearm_35 * carried_forearm_3;
    const six_link_real t576 = t575 + Lambda_i_forearm_45 * carried_forearm_4
        + Lambda_i_forearm_55 * carried_forearm_5 + Lambda_i_forearm_56 * carried_forearm_6;
    const six_link_real t577 = Lambda_i_forearm_16 * carried_forearm_1 + Lambda_i_forearm_26 * carried_forearm_2
        + Lambda_i_forearm_36 * carried_forearm_3;
    const six_link_real t578 = t577 + Lambda_i_forearm_46 * carried_forearm_4
        + Lambda_i_forearm_56 * carried_forearm_5 + Lambda_i_forearm_66 * carried_forearm_6;
    const six_link_real wrench_forearm_1 = t568 + p_i_forearm_1;
    output->wrench[2][0] = wrench_forearm_1;
    const six_link_real wrench_forearm_2 = t570 + p_i_forearm_2;
    output->wrench[2][1] = wrench_forearm_2;
    const six_link_real wrench_forearm_3 = t572 + p_i_forearm_3;
    output->wrench[2][2] = wrench_forearm_3;
    const six_link_real wrench_forearm_4 = t574 + p_i_forearm_4;
    output->wrench[2][3] = wrench_forearm_4;
    const six_link_real wrench_forearm_5 = t576 + p_i_forearm_5;
    output->wrench[2][4] = wrench_forearm_5;
    const six_link_real wrench_forearm_6 = t578 + p_i_forearm_6;
    output->wrench[2][5] = wrench_forearm_6;

    /* forearm, link: acceleration of F_i, modal accelerations (83) */
    const six_link_real alpha_forearm_2 = carried_forearm_2 + qddot_forearm_1;
    const six_link_real alpha_forearm_1 = carried_forearm_1 - minus_beta_omega_forearm_x;
    const six_link_real alpha_forearm_3 = carried_forearm_3 + beta_omega_forearm_z;
    const six_link_real alpha_forearm_4 = carried_forearm_4 - minus_beta_v_forearm_x;
    const six_link_real alpha_forearm_6 = carried_forearm_6 + beta_v_forearm_z;
    const six_link_real t579 = modes_W_forearm_11 * alpha_forearm_1 + modes_W_forearm_12 * alpha_forearm_2
        + modes_W_forearm_13 * alpha_forearm_3;
    const six_link_real t580 = t579 + modes_W_forearm_14 * alpha_forearm_4
        + modes_W_forearm_15 * carried_forearm_5 + modes_W_forearm_16 * alpha_forearm_6;
    const six_link_real t581 = modes_W_forearm_21 * alpha_forearm_1 + modes_W_forearm_22 * alpha_forearm_2
        + modes_W_forearm_23 * alpha_forearm_3;
    const six_link_real t582 = t581 + modes_W_forearm_24 * alpha_forearm_4
        + modes_W_forearm_25 * carried_forearm_5 + modes_W_forearm_26 * alpha_forearm_6;
    const six_link_real minus_etaddot_forearm_2 = modes_w_forearm_2 + t582;
    output->vdot[10] = -minus_etaddot_forearm_2;
    const six_link_real minus_etaddot_forearm_1 = modes_w_forearm_1 + t580
        - modes_L_forearm_21 * minus_etaddot_forearm_2;
    output->vdot[9] = -minus_etaddot_forearm_1;
    const six_link_real t583 = -minus_etaddot_forearm_1;
    output->vdot[9] = t583;
    const six_link_real t584 = -minus_etaddot_forearm_2;
    output->vdot[10] = t584;

    /* forearm, tip: acceleration of the tip section (accconst1b) */
    const six_link_real t585 = c->links[2].Psi_c_y2 * minus_etaddot_forearm_2;
    const six_link_real t586 = c->links[2].Psi_c_z1 * minus_etaddot_forearm_1;
    const six_link_real t587 = alpha_forearm_4
        + (alpha_forearm_2 * r_T_forearm_z - alpha_forearm_3 * r_T_forearm_y);
    const six_link_real t588 = alpha_forearm_1 + (minus_J_l_forearm_xy * t585 - J_l_forearm_xz * t586);
    const six_link_real t589 = alpha_forearm_2 - (J_l_forearm_yy * t585 + J_l_forearm_yz * t586);
    const six_link_real t590 = alpha_forearm_3 - (J_l_forearm_yz * t585 + J_l_forearm_zz * t586);
    const six_link_real t591 = carried_forearm_5
        + (alpha_forearm_3 * c->links[2].length - alpha_forearm_1 * r_T_forearm_z)
        - minus_etaddot_forearm_1 * REAL(2.23606797749979);
    const six_link_real t592 = alpha_forearm_6
        + (alpha_forearm_1 * r_T_forearm_y - alpha_forearm_2 * c->links[2].length)
        - minus_etaddot_forearm_2 * REAL(2.23606797749979);
    const six_link_real alpha_T_forearm_1 = R_T_forearm_xx * t588 + minus_R_T_forearm_xy * t589
        - R_T_forearm_xz * t590 + b_omega_forearm_x;
    const six_link_real alpha_T_forearm_2 = R_T_forearm_yy * t589 - minus_R_T_forearm_xy * t588
        + R_T_forearm_yz * t590 + b_omega_forearm_y;
    const six_link_real alpha_T_forearm_3 = R_T_forearm_xz * t588 + R_T_forearm_yz * t589 + R_T_forearm_zz * t590
        + b_omega_forearm_z;
    const six_link_real alpha_T_forearm_4 = R_T_forearm_xx * t587 + minus_R_T_forearm_xy * t591
        - R_T_forearm_xz * t592 + b_v_forearm_x;
    const six_link_real alpha_T_forearm_5 = R_T_forearm_yy * t591 - minus_R_T_forearm_xy * t587
        + R_T_forearm_yz * t592 + b_v_forearm_y;
    const six_link_real alpha_T_forearm_6 = R_T_forearm_xz * t587 + R_T_forearm_yz * t591 + R_T_forearm_zz * t592
        + b_v_forearm_z;

    /* wrist_roll, joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real carried_wrist_roll_2 = R_rel_wrist_roll_yy * alpha_T_forearm_2
        + minus_R_rel_wrist_roll_yz * alpha_T_forearm_3;
    const six_link_real carried_wrist_roll_3 = R_rel_wrist_roll_yy * alpha_T_forearm_3
        - minus_R_rel_wrist_roll_yz * alpha_T_forearm_2;
    const six_link_real carried_wrist_roll_5 = R_rel_wrist_roll_yy * alpha_T_forearm_5
        + minus_R_rel_wrist_roll_yz * alpha_T_forearm_6;
    const six_link_real carried_wrist_roll_6 = R_rel_wrist_roll_yy * alpha_T_forearm_6
        - minus_R_rel_wrist_roll_yz * alpha_T_forearm_5;
    const six_link_real t593 = joint_W_wrist_roll_11 * alpha_T_forearm_1
        + joint_W_wrist_roll_12 * carried_wrist_roll_2 + joint_W_wrist_roll_13 * carried_wrist_roll_3;
    const six_link_real t594 = t593 + joint_W_wrist_roll_14 * alpha_T_forearm_4
        + joint_W_wrist_roll_15 * carried_wrist_roll_5 + joint_W_wrist_roll_16 * carried_wrist_roll_6;
    const six_link_real qddot_wrist_roll_1 = joint_w_wrist_roll_1 - t594;
    output->vdot[3] = qddot_wrist_roll_1;
    const six_link_real t595 = Lambda_i_wrist_roll_11 * alpha_T_forearm_1
        + Lambda_i_wrist_roll_12 * carried_wrist_roll_2 + Lambda_i_wrist_roll_13 * carried_wrist_roll_3;
    const six_link_real t596 = t595 + Lambda_i_wrist_roll_14 * alpha_T_forearm_4
        + Lambda_i_wrist_roll_15 * carried_wrist_roll_5;
    const six_link_real t597 = Lambda_i_wrist_roll_12 * alpha_T_forearm_1
        + Lambda_i_wrist_roll_22 * carried_wrist_roll_2 + Lambda_i_wrist_roll_23 * carried_wrist_roll_3;
    const six_link_real t598 = t597 + Lambda_i_wrist_roll_24 * alpha_T_forearm_4
        + Lambda_i_wrist_roll_25 * carried_wrist_roll_5;
    const six_link_real t599 = Lambda_i_wrist_roll_13 * alpha_T_forearm_1
        + Lambda_i_wrist_roll_23 * carried_wrist_roll_2 + Lambda_i_wrist_roll_33 * carried_wrist_roll_3;
    const six_link_real t600 = t599 + Lambda_i_wrist_roll_34 * alpha_T_forearm_4
        + Lambda_i_wrist_roll_35 * carried_wrist_roll_5;
    const six_link_real t601 = Lambda_i_wrist_roll_14 * alpha_T_forearm_1
        + Lambda_i_wrist_roll_24 * carried_wrist_roll_2 + Lambda_i_wrist_roll_34 * carried_wrist_roll_3;
    const six_link_real t602 = t601 + Lambda_i_wrist_roll_44 * alpha_T_forearm_4
        + Lambda_i_wrist_roll_45 * carried_wrist_roll_5;
    const six_link_real t603 = Lambda_i_wrist_roll_15 * alpha_T_forearm_1
        + Lambda_i_wrist_roll_25 * carried_wrist_roll_2 + Lambda_i_wrist_roll_35 * carried_wrist_roll_3;
    const six_link_real t604 = t603 + Lambda_i_wrist_roll_45 * alpha_T_forearm_4
        + Lambda_i_wrist_roll_55 * carried_wrist_roll_5;
    const six_link_real t605 = Lambda_i_wrist_roll_16 * alpha_T_forearm_1
        + Lambda_i_wrist_roll_26 * carried_wrist_roll_2 + Lambda_i_wrist_roll_36 * carried_wrist_roll_3;
    const six_link_real t606 = t605 + Lambda_i_wrist_roll_46 * alpha_T_forearm_4
        + Lambda_i_wrist_roll_56 * carried_wrist_roll_5;
    const six_link_real wrench_wrist_roll_1 = t596 + Lambda_i_wrist_roll_16 * carried_wrist_roll_6
        + p_i_wrist_roll_1;
    output->wrench[3][0] = wrench_wrist_roll_1;
    const six_link_real wrench_wrist_roll_2 = t598 + Lambda_i_wrist_roll_26 * carried_wrist_roll_6
        + p_i_wrist_roll_2;
    output->wrench[3][1] = wrench_wrist_roll_2;
    const six_link_real wrench_wrist_roll_3 = t600 + Lambda_i_wrist_roll_36 * carried_wrist_roll_6
        + p_i_wrist_roll_3;
    output->wrench[3][2] = wrench_wrist_roll_3;
    const six_link_real wrench_wrist_roll_4 = t602 + Lambda_i_wrist_roll_46 * carried_wrist_roll_6
        + p_i_wrist_roll_4;
    output->wrench[3][3] = wrench_wrist_roll_4;
    const six_link_real wrench_wrist_roll_5 = t604 + Lambda_i_wrist_roll_56 * carried_wrist_roll_6
        + p_i_wrist_roll_5;
    output->wrench[3][4] = wrench_wrist_roll_5;
    const six_link_real wrench_wrist_roll_6 = t606 + Lambda_i_wrist_roll_66 * carried_wrist_roll_6
        + p_i_wrist_roll_6;
    output->wrench[3][5] = wrench_wrist_roll_6;

    /* wrist_roll, link: acceleration of F_i, modal accelerations (83) */
    const six_link_real alpha_wrist_roll_1 = alpha_T_forearm_1 + qddot_wrist_roll_1;
    const six_link_real alpha_wrist_roll_2 = carried_wrist_roll_2 + beta_omega_wrist_roll_y;
    const six_link_real alpha_wrist_roll_3 = carried_wrist_roll_3 - minus_beta_omega_wrist_roll_z;
    const six_link_real alpha_wrist_roll_5 = carried_wrist_roll_5 + beta_v_wrist_roll_y;
    const six_link_real alpha_wrist_roll_6 = carried_wrist_roll_6 - minus_beta_v_wrist_roll_z;

    /* wrist_roll, tip: acceleration of the tip section (accconst1b) */
    const six_link_real alpha_T_wrist_roll_5 = alpha_wrist_roll_5 + alpha_wrist_roll_3 * c->links[3].length;
    const six_link_real alpha_T_wrist_roll_6 = alpha_wrist_roll_6 - alpha_wrist_roll_2 * c->links[3].length;

    /* wrist_pitch, joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real carried_wrist_pitch_1 = R_rel_wrist_pitch_xx * alpha_wrist_roll_1
        - R_rel_wrist_pitch_xz * alpha_wrist_roll_3;
    const six_link_real carried_wrist_pitch_3 = R_rel_wrist_pitch_xz * alpha_wrist_roll_1
        + R_rel_wrist_pitch_xx * alpha_wrist_roll_3;
    const six_link_real carried_wrist_pitch_4 = R_rel_wrist_pitch_xx * alpha_T_forearm_4
        - R_rel_wrist_pitch_xz * alpha_T_wrist_roll_6;
    const six_link_real carried_wrist_pitch_6 = R_rel_wrist_pitch_xz * alpha_T_forearm_4
        + R_rel_wrist_pitch_xx * alpha_T_wrist_roll_6;
    const six_link_real t607 = joint_W_wrist_pitch_11 * carried_wrist_pitch_1
        + joint_W_wrist_pitch_12 * alpha_wrist_roll_2 + joint_W_wrist_pitch_13 * carried_wrist_pitch_3;
    const six_link_real t608 = t607 + joint_W_wrist_pitch_14 * carried_wrist_pitch_4
        - minus_joint_W_wrist_pitch_15 * alpha_T_wrist_roll_5;
    const six_link_real qddot_wrist_pitch_1 = joint_w_wrist_pitch_1
        - (t608 + joint_W_wrist_pitch_16 * carried_wrist_pitch_6);
    output->vdot[4] = qddot_wrist_pitch_1;
    const six_link_real t609 = Lambda_i_wrist_pitch_11 * carried_wrist_pitch_1
        + Lambda_i_wrist_pitch_12 * alpha_wrist_roll_2 + Lambda_i_wrist_pitch_13 * carried_wrist_pitch_3;
    const six_link_real t610 = t609 - minus_Lambda_i_wrist_pitch_14 * carried_wrist_pitch_4
        + Lambda_i_wrist_pitch_15 * alpha_T_wrist_roll_5;
    const six_link_real t611 = Lambda_i_wrist_pitch_12 * carried_wrist_pitch_1
        + Lambda_i_wrist_pitch_22 * alpha_wrist_roll_2 + Lambda_i_wrist_pitch_23 * carried_wrist_pitch_3;
    const six_link_real t612 = t611 + Lambda_i_wrist_pitch_24 * carried_wrist_pitch_4
        + Lambda_i_wrist_pitch_25 * alpha_T_wrist_roll_5;
    const six_link_real t613 = Lambda_i_wrist_pitch_13 * carried_wrist_pitch_1
        + Lambda_i_wrist_pitch_23 * alpha_wrist_roll_2 + Lambda_i_wrist_pitch_33 * carried_wrist_pitch_3;
    const six_link_real t614 = t613 + Lambda_i_wrist_pitch_34 * carried_wrist_pitch_4
        + Lambda_i_wrist_pitch_35 * alpha_T_wrist_roll_5;
    const six_link_real t615 = Lambda_i_wrist_pitch_24 * alpha_wrist_roll_2
        - minus_Lambda_i_wrist_pitch_14 * carried_wrist_pitch_1;
    const six_link_real t616 = t615 + Lambda_i_wrist_pitch_34 * carried_wrist_pitch_3
        + Lambda_i_wrist_pitch_44 * carried_wrist_pitch_4;
    const six_link_real t617 = t616 + Lambda_i_wrist_pitch_45 * alpha_T_wrist_roll_5
        - minus_Lambda_i_wrist_pitch_46 * carried_wrist_pitch_6;
    const six_link_real t618 = Lambda_i_wrist_pitch_15 * carried_wrist_pitch_1
        + Lambda_i_wrist_pitch_25 * alpha_wrist_roll_2 + Lambda_i_wrist_pitch_35 * carried_wrist_pitch_3;
    const six_link_real t619 = t618 + Lambda_i_wrist_pitch_45 * carried_wrist_pitch_4
        + Lambda_i_wrist_pitch_55 * alpha_T_wrist_roll_5;
    const six_link_real t620 = Lambda_i_wrist_pitch_16 * carried_wrist_pitch_1
        + Lambda_i_wrist_pitch_26 * alpha_wrist_roll_2 + Lambda_i_wrist_pitch_36 * carried_wrist_pitch_3;
    const six_link_real t621 = t620 - minus_Lambda_i_wrist_pitch_46 * carried_wrist_pitch_4
        + Lambda_i_wrist_pitch_56 * alpha_T_wrist_roll_5;
    const six_link_real wrench_wrist_pitch_1 = t610 + Lambda_i_wrist_pitch_16 * carried_wrist_pitch_6
        + p_i_wrist_pitch_1;
    output->wrench[4][0] = wrench_wrist_pitch_1;
    const six_link_real wrench_wrist_pitch_2 = t612 + Lambda_i_wrist_pitch_26 * carried_wrist_pitch_6
        + p_i_wrist_pitch_2;
    output->wrench[4][1] = wrench_wrist_pitch_2;
    const six_link_real wrench_wrist_pitch_3 = t614 + Lambda_i_wrist_pitch_36 * carried_wrist_pitch_6
        + p_i_wrist_pitch_3;
    output->wrench[4][2] = wrench_wrist_pitch_3;
    const six_link_real wrench_wrist_pitch_4 = t617 + p_i_wrist_pitch_4;
    output->wrench[4][3] = wrench_wrist_pitch_4;
    const six_link_real wrench_wrist_pitch_5 = t619 + Lambda_i_wrist_pitch_56 * carried_wrist_pitch_6
        + p_i_wrist_pitch_5;
    output->wrench[4][4] = wrench_wrist_pitch_5;
    const six_link_real wrench_wrist_pitch_6 = t621 + Lambda_i_wrist_pitch_66 * carried_wrist_pitch_6
        + p_i_wrist_pitch_6;
    output->wrench[4][5] = wrench_wrist_pitch_6;

    /* wrist_pitch, link: acceleration of F_i, modal accelerations (83) */
    const six_link_real alpha_wrist_pitch_2 = alpha_wrist_roll_2 + qddot_wrist_pitch_1;
    const six_link_real alpha_wrist_pitch_1 = carried_wrist_pitch_1 - minus_beta_omega_wrist_pitch_x;
    const six_link_real alpha_wrist_pitch_3 = carried_wrist_pitch_3 + beta_omega_wrist_pitch_z;
    const six_link_real alpha_wrist_pitch_4 = carried_wrist_pitch_4 - minus_beta_v_wrist_pitch_x;
    const six_link_real alpha_wrist_pitch_6 = carried_wrist_pitch_6 + beta_v_wrist_pitch_z;

    /* wrist_pitch, tip: acceleration of the tip section (accconst1b) */
    const six_link_real alpha_T_wrist_pitch_5 = alpha_T_wrist_roll_5 + alpha_wrist_pitch_3 * c->links[4].length;
    const six_link_real alpha_T_wrist_pitch_6 = alpha_wrist_pitch_6 - alpha_wrist_pitch_2 * c->links[4].length;

    /* flange, joint: acceleration that the parent's tip imparts, joint accelerations, joint wrench (48) */
    const six_link_real carried_flange_2 = R_rel_flange_yy * alpha_wrist_pitch_2
        + minus_R_rel_flange_yz * alpha_wrist_pitch_3;
    const six_link_real carried_flange_3 = R_rel_flange_yy * alpha_wrist_pitch_3
        - minus_R_rel_flange_yz * alpha_wrist_pitch_2;
    const six_link_real carried_flange_5 = R_rel_flange_yy * alpha_T_wrist_pitch_5
        + minus_R_rel_flange_yz * alpha_T_wrist_pitch_6;
    const six_link_real carried_flange_6 = R_rel_flange_yy * alpha_T_wrist_pitch_6
        - minus_R_rel_flange_yz * alpha_T_wrist_pitch_5;
    const six_link_real t622 = joint_W_flange_11 * alpha_wrist_pitch_1
        - minus_joint_W_flange_12 * carried_flange_2 - minus_joint_W_flange_13 * carried_flange_3;
    const six_link_real qddot_flange_1 = joint_w_flange_1
        - (t622 - minus_joint_W_flange_15 * carried_flange_5 + joint_W_flange_16 * carried_flange_6);
    output->vdot[5] = qddot_flange_1;
    const six_link_real t623 = Lambda_i_flange_11 * alpha_wrist_pitch_1 + Lambda_i_flange_12 * carried_flange_2
        + Lambda_i_flange_13 * carried_flange_3;
    const six_link_real t624 = Lambda_i_flange_12 * alpha_wrist_pitch_1 + Lambda_i_flange_22 * carried_flange_2
        - minus_Lambda_i_flange_23 * carried_flange_3;
    const six_link_real t625 = t624 + c->links[5].S_T_z * alpha_wrist_pitch_4
        - minus_Lambda_i_flange_25 * carried_flange_5 + Lambda_i_flange_26 * carried_flange_6;
    const six_link_real t626 = Lambda_i_flange_13 * alpha_wrist_pitch_1
        - minus_Lambda_i_flange_23 * carried_flange_2 + Lambda_i_flange_33 * carried_flange_3;
    const six_link_real t627 = t626 - c->links[5].S_T_y * alpha_wrist_pitch_4
        + Lambda_i_flange_35 * carried_flange_5 + Lambda_i_flange_36 * carried_flange_6;
    const six_link_real t628 = c->links[5].S_T_z * carried_flange_2 - c->links[5].S_T_y * carried_flange_3
        + M_loaded_flange_44 * alpha_wrist_pitch_4;
    const six_link_real t629 = Lambda_i_flange_15 * alpha_wrist_pitch_1
        - minus_Lambda_i_flange_25 * carried_flange_2 + Lambda_i_flange_35 * carried_flange_3;
    const six_link_real t630 = Lambda_i_flange_16 * alpha_wrist_pitch_1 + Lambda_i_flange_26 * carried_flange_2
        + Lambda_i_flange_36 * carried_flange_3;
    const six_link_real wrench_flange_1 = t623 + Lambda_i_flange_15 * carried_flange_5
        + Lambda_i_flange_16 * carried_flange_6 + p_i_flange_1;
    output->wrench[5][0] = wrench_flange_1;
    const six_link_real wrench_flange_2 = t625 + p_i_flange_2;
    output->wrench[5][1] = wrench_flange_2;
    const six_link_real wrench_flange_3 = t627 + p_i_flange_3;
    output->wrench[5][2] = wrench_flange_3;
    const six_link_real wrench_flange_4 = t628 + bias_flange_4;
    output->wrench[5][3] = wrench_flange_4;
    const six_link_real wrench_flange_5 = t629 + Lambda_i_flange_55 * carried_flange_5
        + Lambda_i_flange_56 * carried_flange_6 + p_i_flange_5;
    output->wrench[5][4] = wrench_flange_5;
    const six_link_real wrench_flange_6 = t630 + Lambda_i_flange_56 * carried_flange_5
        + Lambda_i_flange_66 * carried_flange_6 + p_i_flange_6;
    output->wrench[5][5] = wrench_flange_6;

    /* shoulder, pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real r_tip_shoulder_x = c->links[0].mount_xyz_x + R_rel_shoulder_xx * c->links[0].length;
    const six_link_real r_tip_shoulder_y = c->links[0].mount_xyz_y + minus_R_rel_shoulder_xy * c->links[0].length;

    /* upper_arm, pose: rotation and position of F_i in the inertial frame (Ad) */
    const six_link_real R_upper_arm_xx = R_rel_shoulder_xx * R_rel_upper_arm_xx;
    const six_link_real R_upper_arm_xz = R_rel_shoulder_xx * R_rel_upper_arm_xz;
    const six_link_real R_upper_arm_yx = minus_R_rel_shoulder_xy * R_rel_upper_arm_xx;
    const six_link_real R_upper_arm_yz = minus_R_rel_shoulder_xy * R_rel_upper_arm_xz;
    const six_link_real r_upper_arm_x = r_tip_shoulder_x
        + (R_rel_shoulder_xx * c->links[1].mount_xyz_x - minus_R_rel_shoulder_xy * c->links[1].mount_xyz_y);
    const six_link_real r_upper_arm_y = r_tip_shoulder_y
        + (minus_R_rel_shoulder_xy * c->links[1].mount_xyz_x + R_rel_shoulder_xx * c->links[1].mount_xyz_y);
    const six_link_real r_upper_arm_z = c->links[0].mount_xyz_z + c->links[1].mount_xyz_z;

    /* upper_arm, pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real R_tip_upper_arm_xx = R_upper_arm_xx * R_T_upper_arm_xx
        - minus_R_rel_shoulder_xy * R_T_upper_arm_yx + R_upper_arm_xz * R_T_upper_arm_zx;
    const six_link_real R_tip_upper_arm_xy = R_upper_arm_xx * R_T_upper_arm_xy
        - minus_R_rel_shoulder_xy * R_T_upper_arm_yy + R_upper_arm_xz * R_T_upper_arm_zy;
    const six_link_real R_tip_upper_arm_xz = R_upper_arm_xx * R_T_upper_arm_xz
        - minus_R_rel_shoulder_xy * R_T_upper_arm_yz + R_upper_arm_xz * R_T_upper_arm_zz;
    const six_link_real R_tip_upper_arm_yx = R_upper_arm_yx * R_T_upper_arm_xx
        + R_rel_shoulder_xx * R_T_upper_arm_yx + R_upper_arm_yz * R_T_upper_arm_zx;
    const six_link_real R_tip_upper_arm_yy = R_upper_arm_yx * R_T_upper_arm_xy
        + R_rel_shoulder_xx * R_T_upper_arm_yy + R_upper_arm_yz * R_T_upper_arm_zy;
    const six_link_real R_tip_upper_arm_yz = R_upper_arm_yx * R_T_upper_arm_xz
        + R_rel_shoulder_xx * R_T_upper_arm_yz + R_upper_arm_yz * R_T_upper_arm_zz;
    const six_link_real R_tip_upper_arm_zx = R_rel_upper_arm_xx * R_T_upper_arm_zx
        - R_rel_upper_arm_xz * R_T_upper_arm_xx;
    const six_link_real R_tip_upper_arm_zy = R_rel_upper_arm_xx * R_T_upper_arm_zy
        - R_rel_upper_arm_xz * R_T_upper_arm_xy;
    const six_link_real R_tip_upper_arm_zz = R_rel_upper_arm_xx * R_T_upper_arm_zz
        - R_rel_upper_arm_xz * R_T_upper_arm_xz;
    const six_link_real t631 = R_upper_arm_xx * c->links[1].length - minus_R_rel_shoulder_xy * r_T_upper_arm_y
        + R_upper_arm_xz * r_T_upper_arm_z;
    const six_link_real t632 = R_upper_arm_yx * c->links[1].length + R_rel_shoulder_xx * r_T_upper_arm_y
        + R_upper_arm_yz * r_T_upper_arm_z;
    const six_link_real r_tip_upper_arm_x = r_upper_arm_x + t631;
    const six_link_real r_tip_upper_arm_y = r_upper_arm_y + t632;
    const six_link_real r_tip_upper_arm_z = r_upper_arm_z
        + (R_rel_upper_arm_xx * r_T_upper_arm_z - R_rel_upper_arm_xz * c->links[1].length);

    /* forearm, pose: rotation and position of F_i in the inertial frame (Ad) */
    const six_link_real R_forearm_xx = R_tip_upper_arm_xx * R_rel_forearm_xx
        + R_tip_upper_arm_xy * R_rel_forearm_yx + R_tip_upper_arm_xz * R_rel_forearm_zx;
    const six_link_real R_forearm_xy = R_tip_upper_arm_xx * c->links[2].R_m_xy
        + R_tip_upper_arm_xy * c->links[2].R_m_yy + R_tip_upper_arm_xz * c->links[2].R_m_zy;
    const six_link_real R_forearm_xz = R_tip_upper_arm_xx * R_rel_forearm_xz
        + R_tip_upper_arm_xy * R_rel_forearm_yz + R_tip_upper_arm_xz * R_rel_forearm_zz;
    const six_link_real R_forearm_yx = R_tip_upper_arm_yx * R_rel_forearm_xx
        + R_tip_upper_arm_yy * R_rel_forearm_yx + R_tip_upper_arm_yz * R_rel_forearm_zx;
    const six_link_real R_forearm_yy = R_tip_upper_arm_yx * c->links[2].R_m_xy
        + R_tip_upper_arm_yy * c->links[2].R_m_yy + R_tip_upper_arm_yz * c->links[2].R_m_zy;
    const six_link_real R_forearm_yz = R_tip_upper_arm_yx * R_rel_forearm_xz
        + R_tip_upper_arm_yy * R_rel_forearm_yz + R_tip_upper_arm_yz * R_rel_forearm_zz;
    const six_link_real R_forearm_zx = R_tip_upper_arm_zx * R_rel_forearm_xx
        + R_tip_upper_arm_zy * R_rel_forearm_yx + R_tip_upper_arm_zz * R_rel_forearm_zx;
    const six_link_real R_forearm_zy = R_tip_upper_arm_zx * c->links[2].R_m_xy
        + R_tip_upper_arm_zy * c->links[2].R_m_yy + R_tip_upper_arm_zz * c->links[2].R_m_zy;
    const six_link_real R_forearm_zz = R_tip_upper_arm_zx * R_rel_forearm_xz
        + R_tip_upper_arm_zy * R_rel_forearm_yz + R_tip_upper_arm_zz * R_rel_forearm_zz;
    const six_link_real t633 = R_tip_upper_arm_xx * c->links[2].mount_xyz_x
        + R_tip_upper_arm_xy * c->links[2].mount_xyz_y + R_tip_upper_arm_xz * c->links[2].mount_xyz_z;
    const six_link_real t634 = R_tip_upper_arm_yx * c->links[2].mount_xyz_x
        + R_tip_upper_arm_yy * c->links[2].mount_xyz_y + R_tip_upper_arm_yz * c->links[2].mount_xyz_z;
    const six_link_real t635 = R_tip_upper_arm_zx * c->links[2].mount_xyz_x
        + R_tip_upper_arm_zy * c->links[2].mount_xyz_y + R_tip_upper_arm_zz * c->links[2].mount_xyz_z;
    const six_link_real r_forearm_x = r_tip_upper_arm_x + t633;
    const six_link_real r_forearm_y = r_tip_upper_arm_y + t634;
    const six_link_real r_forearm_z = r_tip_upper_arm_z + t635;

    /* forearm, pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real R_tip_forearm_xx = R_forearm_xx * R_T_forearm_xx + R_forearm_xy * minus_R_T_forearm_xy
        - R_forearm_xz * R_T_forearm_xz;
    const six_link_real R_tip_forearm_xy = R_forearm_xy * R_T_forearm_yy - R_forearm_xx * minus_R_T_forearm_xy
        + R_forearm_xz * R_T_forearm_yz;
    const six_link_real R_tip_forearm_xz = R_forearm_xx * R_T_forearm_xz + R_forearm_xy * R_T_forearm_yz
        + R_forearm_xz * R_T_forearm_zz;
    const six_link_real R_tip_forearm_yx = R_forearm_yx * R_T_forearm_xx + R_forearm_yy * minus_R_T_forearm_xy
        - R_forearm_yz * R_T_forearm_xz;
    const six_link_real R_tip_forearm_yy = R_forearm_yy * R_T_forearm_yy - R_forearm_yx * minus_R_T_forearm_xy
        + R_forearm_yz * R_T_forearm_yz;
    const six_link_real R_tip_forearm_yz = R_forearm_yx * R_T_forearm_xz + R_forearm_yy * R_T_forearm_yz
        + R_forearm_yz * R_T_forearm_zz;
    const six_link_real R_tip_forearm_zx = R_forearm_zx * R_T_forearm_xx + R_forearm_zy * minus_R_T_forearm_xy
        - R_forearm_zz * R_T_forearm_xz;
    const six_link_real R_tip_forearm_zy = R_forearm_zy * R_T_forearm_yy - R_forearm_zx * minus_R_T_forearm_xy
        + R_forearm_zz * R_T_forearm_yz;
    const six_link_real R_tip_forearm_zz = R_forearm_zx * R_T_forearm_xz + R_forearm_zy * R_T_forearm_yz
        + R_forearm_zz * R_T_forearm_zz;
    const six_link_real r_tip_forearm_x = r_forearm_x
        + (R_forearm_xx * c->links[2].length + R_forearm_xy * r_T_forearm_y + R_forearm_xz * r_T_forearm_z);
    const six_link_real r_tip_forearm_y = r_forearm_y
        + (R_forearm_yx * c->links[2].length + R_forearm_yy * r_T_forearm_y + R_forearm_yz * r_T_forearm_z);
    const six_link_real r_tip_forearm_z = r_forearm_z
        + (R_forearm_zx * c->links[2].length + R_forearm_zy * r_T_forearm_y + R_forearm_zz * r_T_forearm_z);

    /* wrist_roll, pose: rotation and position of F_i in the inertial frame (Ad) */
    const six_link_real R_wrist_roll_xy = R_tip_forearm_xy * R_rel_wrist_roll_yy
        + R_tip_forearm_xz * minus_R_rel_wrist_roll_yz;
    const six_link_real R_wrist_roll_xz = R_tip_forearm_xz * R_rel_wrist_roll_yy
        - R_tip_forearm_xy * minus_R_rel_wrist_roll_yz;
    const six_link_real R_wrist_roll_yy = R_tip_forearm_yy * R_rel_wrist_roll_yy
        + R_tip_forearm_yz * minus_R_rel_wrist_roll_yz;
    const six_link_real R_wrist_roll_yz = R_tip_forearm_yz * R_rel_wrist_roll_yy
        - R_tip_forearm_yy * minus_R_rel_wrist_roll_yz;
    const six_link_real R_wrist_roll_zy = R_tip_forearm_zy * R_rel_wrist_roll_yy
        + R_tip_forearm_zz * minus_R_rel_wrist_roll_yz;
    const six_link_real R_wrist_roll_zz = R_tip_forearm_zz * R_rel_wrist_roll_yy
        - R_tip_forearm_zy * minus_R_rel_wrist_roll_yz;

    /* wrist_roll, pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real r_tip_wrist_roll_x = r_tip_forearm_x + R_tip_forearm_xx * c->links[3].length;
    const six_link_real r_tip_wrist_roll_y = r_tip_forearm_y + R_tip_forearm_yx * c->links[3].length;
    const six_link_real r_tip_wrist_roll_z = r_tip_forearm_z + R_tip_forearm_zx * c->links[3].length;

    /* wrist_pitch, pose: rotation and position of F_i in the inertial frame (Ad) */
    const six_link_real R_wrist_pitch_xx = R_tip_forearm_xx * R_rel_wrist_pitch_xx
        - R_wrist_roll_xz * R_rel_wrist_pitch_xz;
    output->tip_rotation[0][0] = R_wrist_pitch_xx;
    const six_link_real R_wrist_pitch_xz = R_tip_forearm_xx * R_rel_wrist_pitch_xz
        + R_wrist_roll_xz * R_rel_wrist_pitch_xx;
    const six_link_real R_wrist_pitch_yx = R_tip_forearm_yx * R_rel_wrist_pitch_xx
        - R_wrist_roll_yz * R_rel_wrist_pitch_xz;
    output->tip_rotation[1][0] = R_wrist_pitch_yx;
    const six_link_real R_wrist_pitch_yz = R_tip_forearm_yx * R_rel_wrist_pitch_xz
        + R_wrist_roll_yz * R_rel_wrist_pitch_xx;
    const six_link_real R_wrist_pitch_zx = R_tip_forearm_zx * R_rel_wrist_pitch_xx
        - R_wrist_roll_zz * R_rel_wrist_pitch_xz;
    output->tip_rotation[2][0] = R_wrist_pitch_zx;
    const six_link_real R_wrist_pitch_zz = R_tip_forearm_zx * R_rel_wrist_pitch_xz
        + R_wrist_roll_zz * R_rel_wrist_pitch_xx;

    /* wrist_pitch, pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real r_tip_wrist_pitch_x = r_tip_wrist_roll_x + R_wrist_pitch_xx * c->links[4].length;
    const six_link_real r_tip_wrist_pitch_y = r_tip_wrist_roll_y + R_wrist_pitch_yx * c->links[4].length;
    const six_link_real r_tip_wrist_pitch_z = r_tip_wrist_roll_z + R_wrist_pitch_zx * c->links[4].length;

    /* flange, pose: rotation and position of F_i in the inertial frame (Ad) */
    const six_link_real R_flange_xy = R_wrist_roll_xy * R_rel_flange_yy
        + R_wrist_pitch_xz * minus_R_rel_flange_yz;
    output->tip_rotation[0][1] = R_flange_xy;
    const six_link_real R_flange_xz = R_wrist_pitch_xz * R_rel_flange_yy
        - R_wrist_roll_xy * minus_R_rel_flange_yz;
    output->tip_rotation[0][2] = R_flange_xz;
    const six_link_real R_flange_yy = R_wrist_roll_yy * R_rel_flange_yy
        + R_wrist_pitch_yz * minus_R_rel_flange_yz;
    output->tip_rotation[1][1] = R_flange_yy;
    const six_link_real R_flange_yz = R_wrist_pitch_yz * R_rel_flange_yy
        - R_wrist_roll_yy * minus_R_rel_flange_yz;
    output->tip_rotation[1][2] = R_flange_yz;
    const six_link_real R_flange_zy = R_wrist_roll_zy * R_rel_flange_yy
        + R_wrist_pitch_zz * minus_R_rel_flange_yz;
    output->tip_rotation[2][1] = R_flange_zy;
    const six_link_real R_flange_zz = R_wrist_pitch_zz * R_rel_flange_yy
        - R_wrist_roll_zy * minus_R_rel_flange_yz;
    output->tip_rotation[2][2] = R_flange_zz;

    /* flange, pose: rotation and position of the tip section in the inertial frame (Ad) */
    const six_link_real r_tip_flange_x = r_tip_wrist_pitch_x + R_wrist_pitch_xx * c->links[5].length;
    output->tip_position[0] = r_tip_flange_x;
    const six_link_real r_tip_flange_y = r_tip_wrist_pitch_y + R_wrist_pitch_yx * c->links[5].length;
    output->tip_position[1] = r_tip_flange_y;
    const six_link_real r_tip_flange_z = r_tip_wrist_pitch_z + R_wrist_pitch_zx * c->links[5].length;
    output->tip_position[2] = r_tip_flange_z;

    if (bad) {
        /* the sweep ran from the tip: the outermost link that failed is to blame */
        for (link = 0; link < SIX_LINK_NLINKS; ++link) {
            if ((bad >> link) & 1u) {
                work->fault = link;
            }
        }
        return SIX_LINK_SINGULAR;
    }
    return SIX_LINK_OK;
}
