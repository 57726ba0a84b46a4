/* six_link_dynamics.c: forward dynamics of the joint form by block elimination, tip to base;
 * inverse dynamics and mass matrix.
 */
#include "six_link_links.h"

/* The whole chain in one piece: outward to the tip, inward with the eliminations, outward with the results. */
SIX_LINK_TARGETS six_link_status six_link_dynamics(const six_link_constants *c, const six_link_state *state, const six_link_input *input,
    const six_link_real *m_eta, six_link_work *work, int wanted, six_link_output *output)
{
    unsigned long bad = 0; /* bit i: the joint or a mode of link i cannot be solved for */
    int link;

    /* shoulder, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(state->q[0]);
    const six_link_real minus_R_rel_shoulder_xy = turn.sine, R_rel_shoulder_xx = turn.cosine;

    /* shoulder, alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const six_link_real minus_alpha_0_shoulder_4 = R_rel_shoulder_xx * c->gravity[0]
        + minus_R_rel_shoulder_xy * c->gravity[1];
    const six_link_real alpha_0_shoulder_5 = minus_R_rel_shoulder_xy * c->gravity[0]
        - R_rel_shoulder_xx * c->gravity[1];

    /* shoulder, tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const six_link_real minus_alpha_0_T_shoulder_4 = minus_alpha_0_shoulder_4
        + state->v[0] * (state->v[0] * c->links[0].length);

    /* upper_arm, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_2 = six_link_sine_cosine(state->q[1]);
    const six_link_real R_rel_upper_arm_xz = turn_2.sine, R_rel_upper_arm_xx = turn_2.cosine;

    /* upper_arm, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real lever_upper_arm_1 = R_rel_upper_arm_xx * c->links[1].mount_xyz_x
        - R_rel_upper_arm_xz * c->links[1].mount_xyz_z;
    const six_link_real lever_upper_arm_3 = R_rel_upper_arm_xz * c->links[1].mount_xyz_x
        + R_rel_upper_arm_xx * c->links[1].mount_xyz_z;
    const six_link_real minus_omega_R_upper_arm_1 = R_rel_upper_arm_xz * state->v[0];
    const six_link_real omega_R_upper_arm_3 = R_rel_upper_arm_xx * state->v[0];

    /* upper_arm, alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const six_link_real minus_alpha_0_upper_arm_1 = omega_R_upper_arm_3 * state->v[1];
    const six_link_real minus_alpha_0_upper_arm_3 = minus_omega_R_upper_arm_1 * state->v[1];
    const six_link_real t1 = omega_R_upper_arm_3 * lever_upper_arm_1
        + minus_omega_R_upper_arm_1 * lever_upper_arm_3;
    const six_link_real t2 = omega_R_upper_arm_3 * (omega_R_upper_arm_3 * c->links[1].mount_xyz_y)
        + minus_omega_R_upper_arm_1 * (minus_omega_R_upper_arm_1 * c->links[1].mount_xyz_y);
    const six_link_real alpha_0_upper_arm_4 = R_rel_upper_arm_xz * c->gravity[2]
        - R_rel_upper_arm_xx * minus_alpha_0_T_shoulder_4 - omega_R_upper_arm_3 * t1;
    const six_link_real alpha_0_upper_arm_5 = alpha_0_shoulder_5 - t2;
    const six_link_real minus_alpha_0_upper_arm_6 = R_rel_upper_arm_xz * minus_alpha_0_T_shoulder_4
        + R_rel_upper_arm_xx * c->gravity[2] + minus_omega_R_upper_arm_1 * t1;

    /* upper_arm, r_T: tip point (11) */
    const six_link_real r_T_upper_arm_y = state->q[6] * 2;
    const six_link_real r_T_upper_arm_z = state->q[7] * 2;

    /* upper_arm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_upper_arm_x = state->q[8] * REAL(1.4142135623730951);
    const six_link_real theta_upper_arm_y = c->links[1].Psi_c_y2 * state->q[7];
    const six_link_real theta_upper_arm_z = c->links[1].Psi_c_z1 * state->q[6];

    /* upper_arm, x: squared angle of the tip section */
    const six_link_real t3 = theta_upper_arm_x * theta_upper_arm_x;
    const six_link_real t4 = theta_upper_arm_y * theta_upper_arm_y;
    const six_link_real minus_theta_hat2_upper_arm_33 = t3 + t4;
    const six_link_real t5 = theta_upper_arm_z * theta_upper_arm_z;
    const six_link_real x_upper_arm = minus_theta_hat2_upper_arm_33 + t5;

    /* upper_arm, c1: Stumpff function of order 1 */
    const six_link_real t6 = six_link_c5(x_upper_arm);
    const six_link_real c3_upper_arm = REAL(0.16666666666666666) - x_upper_arm * t6;
    const six_link_real c1_upper_arm = 1 - x_upper_arm * c3_upper_arm;

    /* upper_arm, c2: Stumpff function of order 2 */
    const six_link_real t7 = six_link_c4(x_upper_arm);
    const six_link_real c2_upper_arm = REAL(0.5) - x_upper_arm * t7;

    /* upper_arm, theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_upper_arm_11 = t4 + t5;
    const six_link_real theta_hat2_upper_arm_12 = theta_upper_arm_x * theta_upper_arm_y;
    const six_link_real theta_hat2_upper_arm_13 = theta_upper_arm_x * theta_upper_arm_z;
    const six_link_real minus_theta_hat2_upper_arm_22 = t3 + t5;
    const six_link_real theta_hat2_upper_arm_23 = theta_upper_arm_y * theta_upper_arm_z;

    /* upper_arm, J_l: left Jacobian of the exponential */
    const six_link_real J_l_upper_arm_xx = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_11;
    const six_link_real t8 = c3_upper_arm * theta_hat2_upper_arm_12;
    const six_link_real t9 = c2_upper_arm * theta_upper_arm_z;
    const six_link_real J_l_upper_arm_xy = t8 - t9;
    const six_link_real t10 = c2_upper_arm * theta_upper_arm_y;
    const six_link_real t11 = c3_upper_arm * theta_hat2_upper_arm_13;
    const six_link_real J_l_upper_arm_xz = t10 + t11;
    const six_link_real J_l_upper_arm_yx = t9 + t8;
    const six_link_real J_l_upper_arm_yy = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_22;
    const six_link_real t12 = c3_upper_arm * theta_hat2_upper_arm_23;
    const six_link_real t13 = c2_upper_arm * theta_upper_arm_x;
    const six_link_real J_l_upper_arm_yz = t12 - t13;
    const six_link_real J_l_upper_arm_zx = t11 - t10;
    const six_link_real J_l_upper_arm_zy = t13 + t12;
    const six_link_real J_l_upper_arm_zz = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_33;

    /* upper_arm, R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_upper_arm_xx = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_11;
    const six_link_real t14 = c2_upper_arm * theta_hat2_upper_arm_12;
    const six_link_real t15 = c1_upper_arm * theta_upper_arm_z;
    const six_link_real R_T_upper_arm_xy = t14 - t15;
    const six_link_real t16 = c1_upper_arm * theta_upper_arm_y;
    const six_link_real t17 = c2_upper_arm * theta_hat2_upper_arm_13;
    const six_link_real R_T_upper_arm_xz = t16 + t17;
    const six_link_real R_T_upper_arm_yx = t15 + t14;
    const six_link_real R_T_upper_arm_yy = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_22;
    const six_link_real t18 = c2_upper_arm * theta_hat2_upper_arm_23;
    const six_link_real t19 = c1_upper_arm * theta_upper_arm_x;
    const six_link_real R_T_upper_arm_yz = t18 - t19;
    const six_link_real R_T_upper_arm_zx = t17 - t16;
    const six_link_real R_T_upper_arm_zy = t19 + t18;
    const six_link_real R_T_upper_arm_zz = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_33;

    /* upper_arm, thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_upper_arm_x = state->v[8] * REAL(1.4142135623730951);
    const six_link_real thetadot_upper_arm_y = c->links[1].Psi_c_y2 * state->v[7];
    const six_link_real thetadot_upper_arm_z = c->links[1].Psi_c_z1 * state->v[6];

    /* upper_arm, omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t20 = theta_upper_arm_y * thetadot_upper_arm_z - theta_upper_arm_z * thetadot_upper_arm_y;
    const six_link_real t21 = theta_upper_arm_x * thetadot_upper_arm_y - theta_upper_arm_y * thetadot_upper_arm_x;
    const six_link_real t22 = theta_upper_arm_z * thetadot_upper_arm_x - theta_upper_arm_x * thetadot_upper_arm_z;
    const six_link_real t23 = theta_upper_arm_y * t21 - theta_upper_arm_z * t22;
    const six_link_real omega_s_upper_arm_x = thetadot_upper_arm_x + c2_upper_arm * t20 + c3_upper_arm * t23;
    const six_link_real t24 = theta_upper_arm_z * t20 - theta_upper_arm_x * t21;
    const six_link_real omega_s_upper_arm_y = thetadot_upper_arm_y + c2_upper_arm * t22 + c3_upper_arm * t24;
    const six_link_real t25 = theta_upper_arm_x * t22 - theta_upper_arm_y * t20;
    const six_link_real omega_s_upper_arm_z = thetadot_upper_arm_z + c2_upper_arm * t21 + c3_upper_arm * t25;

    /* upper_arm, xdot: rate of the squared angle */
    const six_link_real t26 = state->q[8] * REAL(2.8284271247461903) * thetadot_upper_arm_x
        + theta_upper_arm_y * 2 * thetadot_upper_arm_y;
    const six_link_real xdot_upper_arm = t26 + theta_upper_arm_z * 2 * thetadot_upper_arm_z;

    /* upper_arm, c2dot: rate of c2 */
    const six_link_real c2dot_upper_arm = xdot_upper_arm * (t7 - c3_upper_arm * REAL(0.5));

    /* upper_arm, c3dot: rate of c3 */
    const six_link_real c3dot_upper_arm = xdot_upper_arm * (t6 * REAL(1.5) - t7 * REAL(0.5));

    /* upper_arm, alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_upper_arm_x = c2dot_upper_arm * t20
        + c3_upper_arm * (thetadot_upper_arm_y * t21 - thetadot_upper_arm_z * t22) + c3dot_upper_arm * t23;
    const six_link_real alpha_s_upper_arm_y = c2dot_upper_arm * t22
        + c3_upper_arm * (thetadot_upper_arm_z * t20 - thetadot_upper_arm_x * t21) + c3dot_upper_arm * t24;
    const six_link_real alpha_s_upper_arm_z = c2dot_upper_arm * t21
        + c3_upper_arm * (thetadot_upper_arm_x * t22 - thetadot_upper_arm_y * t20) + c3dot_upper_arm * t25;

    /* upper_arm, tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const six_link_real omega_T_upper_arm_1 = omega_s_upper_arm_x - minus_omega_R_upper_arm_1;
    const six_link_real omega_T_upper_arm_2 = state->v[1] + omega_s_upper_arm_y;
    const six_link_real omega_T_upper_arm_3 = omega_R_upper_arm_3 + omega_s_upper_arm_z;
    const six_link_real alpha_0_T_upper_arm_1 = alpha_s_upper_arm_x - minus_alpha_0_upper_arm_1
        + (state->v[1] * omega_s_upper_arm_z - omega_R_upper_arm_3 * omega_s_upper_arm_y);
    const six_link_real alpha_0_T_upper_arm_2 = alpha_s_upper_arm_y
        + (omega_R_upper_arm_3 * omega_s_upper_arm_x + minus_omega_R_upper_arm_1 * omega_s_upper_arm_z);
    const six_link_real alpha_0_T_upper_arm_3 = alpha_s_upper_arm_z - minus_alpha_0_upper_arm_3
        - (minus_omega_R_upper_arm_1 * omega_s_upper_arm_y + state->v[1] * omega_s_upper_arm_x);
    const six_link_real t27 = alpha_0_upper_arm_5
        + (minus_alpha_0_upper_arm_1 * r_T_upper_arm_z - minus_alpha_0_upper_arm_3 * c->links[1].length);
    const six_link_real t28 = state->v[1] * r_T_upper_arm_z - omega_R_upper_arm_3 * r_T_upper_arm_y;
    const six_link_real t29 = omega_R_upper_arm_3 * c->links[1].length
        + minus_omega_R_upper_arm_1 * r_T_upper_arm_z + state->v[6] * 4;
    const six_link_real t30 = state->v[7] * 4
        - (minus_omega_R_upper_arm_1 * r_T_upper_arm_y + state->v[1] * c->links[1].length);
    const six_link_real alpha_0_T_upper_arm_4 = alpha_0_upper_arm_4 + minus_alpha_0_upper_arm_3 * r_T_upper_arm_y
        + (state->v[1] * t30 - omega_R_upper_arm_3 * t29);
    const six_link_real alpha_0_T_upper_arm_5 = t27
        + (omega_R_upper_arm_3 * t28 + minus_omega_R_upper_arm_1 * t30);
    const six_link_real minus_alpha_0_T_upper_arm_6 = minus_alpha_0_upper_arm_6
        + minus_alpha_0_upper_arm_1 * r_T_upper_arm_y + (minus_omega_R_upper_arm_1 * t29 + state->v[1] * t28);

    /* forearm, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_3 = six_link_sine_cosine(state->q[2]);
    const six_link_real t31 = turn_3.sine, t32 = turn_3.cosine;
    const six_link_real R_rel_forearm_xx = c->links[2].R_m_xx * t32 - c->links[2].R_m_xz * t31;
    const six_link_real R_rel_forearm_xz = c->links[2].R_m_xx * t31 + c->links[2].R_m_xz * t32;
    const six_link_real R_rel_forearm_yx = c->links[2].R_m_yx * t32 - c->links[2].R_m_yz * t31;
    const six_link_real R_rel_forearm_yz = c->links[2].R_m_yx * t31 + c->links[2].R_m_yz * t32;
    const six_link_real R_rel_forearm_zx = c->links[2].R_m_zx * t32 - c->links[2].R_m_zz * t31;
    const six_link_real R_rel_forearm_zz = c->links[2].R_m_zx * t31 + c->links[2].R_m_zz * t32;

    /* forearm, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_forearm_11 = R_T_upper_arm_xx * R_rel_forearm_xx
        + R_T_upper_arm_xy * R_rel_forearm_yx + R_T_upper_arm_xz * R_rel_forearm_zx;
    const six_link_real R_P_forearm_12 = R_T_upper_arm_xx * c->links[2].R_m_xy
        + R_T_upper_arm_xy * c->links[2].R_m_yy + R_T_upper_arm_xz * c->links[2].R_m_zy;
    const six_link_real R_P_forearm_13 = R_T_upper_arm_xx * R_rel_forearm_xz
        + R_T_upper_arm_xy * R_rel_forearm_yz + R_T_upper_arm_xz * R_rel_forearm_zz;
    const six_link_real R_P_forearm_21 = R_T_upper_arm_yx * R_rel_forearm_xx
        + R_T_upper_arm_yy * R_rel_forearm_yx + R_T_upper_arm_yz * R_rel_forearm_zx;
    const six_link_real R_P_forearm_22 = R_T_upper_arm_yx * c->links[2].R_m_xy
        + R_T_upper_arm_yy * c->links[2].R_m_yy + R_T_upper_arm_yz * c->links[2].R_m_zy;
    const six_link_real R_P_forearm_23 = R_T_upper_arm_yx * R_rel_forearm_xz
        + R_T_upper_arm_yy * R_rel_forearm_yz + R_T_upper_arm_yz * R_rel_forearm_zz;
    const six_link_real R_P_forearm_31 = R_T_upper_arm_zx * R_rel_forearm_xx
        + R_T_upper_arm_zy * R_rel_forearm_yx + R_T_upper_arm_zz * R_rel_forearm_zx;
    const six_link_real R_P_forearm_32 = R_T_upper_arm_zx * c->links[2].R_m_xy
        + R_T_upper_arm_zy * c->links[2].R_m_yy + R_T_upper_arm_zz * c->links[2].R_m_zy;
    const six_link_real R_P_forearm_33 = R_T_upper_arm_zx * R_rel_forearm_xz
        + R_T_upper_arm_zy * R_rel_forearm_yz + R_T_upper_arm_zz * R_rel_forearm_zz;
    const six_link_real lever_forearm_1 = R_rel_forearm_xx * c->links[2].mount_xyz_x
        + R_rel_forearm_yx * c->links[2].mount_xyz_y + R_rel_forearm_zx * c->links[2].mount_xyz_z;
    const six_link_real lever_forearm_2 = c->links[2].R_m_xy * c->links[2].mount_xyz_x
        + c->links[2].R_m_yy * c->links[2].mount_xyz_y + c->links[2].R_m_zy * c->links[2].mount_xyz_z;
    const six_link_real lever_forearm_3 = R_rel_forearm_xz * c->links[2].mount_xyz_x
        + R_rel_forearm_yz * c->links[2].mount_xyz_y + R_rel_forearm_zz * c->links[2].mount_xyz_z;
    const six_link_real omega_R_forearm_1 = R_P_forearm_11 * omega_T_upper_arm_1
        + R_P_forearm_21 * omega_T_upper_arm_2 + R_P_forearm_31 * omega_T_upper_arm_3;
    const six_link_real omega_R_forearm_2 = R_P_forearm_12 * omega_T_upper_arm_1
        + R_P_forearm_22 * omega_T_upper_arm_2 + R_P_forearm_32 * omega_T_upper_arm_3;
    const six_link_real omega_R_forearm_3 = R_P_forearm_13 * omega_T_upper_arm_1
        + R_P_forearm_23 * omega_T_upper_arm_2 + R_P_forearm_33 * omega_T_upper_arm_3;

    /* forearm, alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const six_link_real omega_forearm_y = omega_R_forearm_2 + state->v[2];
    const six_link_real t33 = R_P_forearm_11 * alpha_0_T_upper_arm_1 + R_P_forearm_21 * alpha_0_T_upper_arm_2
        + R_P_forearm_31 * alpha_0_T_upper_arm_3;
    const six_link_real alpha_0_forearm_2 = R_P_forearm_12 * alpha_0_T_upper_arm_1
        + R_P_forearm_22 * alpha_0_T_upper_arm_2 + R_P_forearm_32 * alpha_0_T_upper_arm_3;
    const six_link_real t34 = R_P_forearm_13 * alpha_0_T_upper_arm_1 + R_P_forearm_23 * alpha_0_T_upper_arm_2
        + R_P_forearm_33 * alpha_0_T_upper_arm_3;
    const six_link_real alpha_0_forearm_1 = t33 - omega_R_forearm_3 * state->v[2];
    const six_link_real alpha_0_forearm_3 = t34 + omega_R_forearm_1 * state->v[2];
    const six_link_real t35 = R_P_forearm_11 * alpha_0_T_upper_arm_4 + R_P_forearm_21 * alpha_0_T_upper_arm_5
        - R_P_forearm_31 * minus_alpha_0_T_upper_arm_6;
    const six_link_real t36 = R_P_forearm_12 * alpha_0_T_upper_arm_4 + R_P_forearm_22 * alpha_0_T_upper_arm_5
        - R_P_forearm_32 * minus_alpha_0_T_upper_arm_6;
    const six_link_real t37 = R_P_forearm_13 * alpha_0_T_upper_arm_4 + R_P_forearm_23 * alpha_0_T_upper_arm_5
        - R_P_forearm_33 * minus_alpha_0_T_upper_arm_6;
    const six_link_real t38 = omega_R_forearm_2 * lever_forearm_3 - omega_R_forearm_3 * lever_forearm_2;
    const six_link_real t39 = omega_R_forearm_3 * lever_forearm_1 - omega_R_forearm_1 * lever_forearm_3;
    const six_link_real t40 = omega_R_forearm_1 * lever_forearm_2 - omega_R_forearm_2 * lever_forearm_1;
    const six_link_real t41 = alpha_0_forearm_2 * lever_forearm_3 - t34 * lever_forearm_2
        + (omega_R_forearm_2 * t40 - omega_R_forearm_3 * t39);
    const six_link_real t42 = t34 * lever_forearm_1 - t33 * lever_forearm_3
        + (omega_R_forearm_3 * t38 - omega_R_forearm_1 * t40);
    const six_link_real t43 = t33 * lever_forearm_2 - alpha_0_forearm_2 * lever_forearm_1
        + (omega_R_forearm_1 * t39 - omega_R_forearm_2 * t38);
    const six_link_real alpha_0_forearm_4 = t35 + t41;
    const six_link_real alpha_0_forearm_5 = t36 + t42;
    const six_link_real alpha_0_forearm_6 = t37 + t43;

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
    const six_link_real t44 = six_link_c5(x_forearm);
    const six_link_real c3_forearm = REAL(0.16666666666666666) - x_forearm * t44;
    const six_link_real c1_forearm = 1 - x_forearm * c3_forearm;

    /* forearm, c2: Stumpff function of order 2 */
    const six_link_real t45 = six_link_c4(x_forearm);
    const six_link_real c2_forearm = REAL(0.5) - x_forearm * t45;

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

    /* forearm, thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_forearm_y = c->links[2].Psi_c_y2 * state->v[10];
    const six_link_real thetadot_forearm_z = c->links[2].Psi_c_z1 * state->v[9];

    /* forearm, omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t46 = theta_forearm_y * thetadot_forearm_z - theta_forearm_z * thetadot_forearm_y;
    const six_link_real omega_s_forearm_x = c2_forearm * t46;
    const six_link_real omega_s_forearm_y = thetadot_forearm_y + c3_forearm * theta_forearm_z * t46;
    const six_link_real omega_s_forearm_z = thetadot_forearm_z - c3_forearm * theta_forearm_y * t46;

    /* forearm, xdot: rate of the squared angle */
    const six_link_real xdot_forearm = theta_forearm_y * 2 * thetadot_forearm_y
        + theta_forearm_z * 2 * thetadot_forearm_z;

    /* forearm, c2dot: rate of c2 */
    const six_link_real c2dot_forearm = xdot_forearm * (t45 - c3_forearm * REAL(0.5));

    /* forearm, c3dot: rate of c3 */
    const six_link_real c3dot_forearm = xdot_forearm * (t44 * REAL(1.5) - t45 * REAL(0.5));

    /* forearm, alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_forearm_x = c2dot_forearm * t46;
    const six_link_real alpha_s_forearm_y = c3_forearm * thetadot_forearm_z * t46
        + c3dot_forearm * theta_forearm_z * t46;
    const six_link_real minus_alpha_s_forearm_z = c3_forearm * thetadot_forearm_y * t46
        + c3dot_forearm * theta_forearm_y * t46;

    /* forearm, tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const six_link_real omega_T_forearm_1 = omega_R_forearm_1 + omega_s_forearm_x;
    const six_link_real omega_T_forearm_2 = omega_forearm_y + omega_s_forearm_y;
    const six_link_real omega_T_forearm_3 = omega_R_forearm_3 + omega_s_forearm_z;
    const six_link_real alpha_0_T_forearm_1 = alpha_0_forearm_1 + alpha_s_forearm_x
        + (omega_forearm_y * omega_s_forearm_z - omega_R_forearm_3 * omega_s_forearm_y);
    const six_link_real alpha_0_T_forearm_2 = alpha_0_forearm_2 + alpha_s_forearm_y
        + (omega_R_forearm_3 * omega_s_forearm_x - omega_R_forearm_1 * omega_s_forearm_z);
    const six_link_real alpha_0_T_forearm_3 = alpha_0_forearm_3 - minus_alpha_s_forearm_z
        + (omega_R_forearm_1 * omega_s_forearm_y - omega_forearm_y * omega_s_forearm_x);
    const six_link_real t47 = omega_forearm_y * r_T_forearm_z - omega_R_forearm_3 * r_T_forearm_y;
    const six_link_real t48 = omega_R_forearm_3 * c->links[2].length - omega_R_forearm_1 * r_T_forearm_z
        + state->v[9] * REAL(4.47213595499958);
    const six_link_real t49 = omega_R_forearm_1 * r_T_forearm_y - omega_forearm_y * c->links[2].length
        + state->v[10] * REAL(4.47213595499958);
    const six_link_real alpha_0_T_forearm_4 = alpha_0_forearm_4
        + (alpha_0_forearm_2 * r_T_forearm_z - alpha_0_forearm_3 * r_T_forearm_y)
        + (omega_forearm_y * t49 - omega_R_forearm_3 * t48);
    const six_link_real alpha_0_T_forearm_5 = alpha_0_forearm_5
        + (alpha_0_forearm_3 * c->links[2].length - alpha_0_forearm_1 * r_T_forearm_z)
        + (omega_R_forearm_3 * t47 - omega_R_forearm_1 * t49);
    const six_link_real alpha_0_T_forearm_6 = alpha_0_forearm_6
        + (alpha_0_forearm_1 * r_T_forearm_y - alpha_0_forearm_2 * c->links[2].length)
        + (omega_R_forearm_1 * t48 - omega_forearm_y * t47);

    /* wrist_roll, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_4 = six_link_sine_cosine(state->q[3]);
    const six_link_real minus_R_rel_wrist_roll_yz = turn_4.sine, R_rel_wrist_roll_yy = turn_4.cosine;

    /* wrist_roll, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_wrist_roll_12 = R_T_forearm_xz * minus_R_rel_wrist_roll_yz
        - minus_R_T_forearm_xy * R_rel_wrist_roll_yy;
    const six_link_real R_P_wrist_roll_13 = R_T_forearm_xz * R_rel_wrist_roll_yy
        + minus_R_T_forearm_xy * minus_R_rel_wrist_roll_yz;
    const six_link_real t50 = R_T_forearm_yz * minus_R_rel_wrist_roll_yz;
    const six_link_real R_P_wrist_roll_22 = R_T_forearm_yy * R_rel_wrist_roll_yy + t50;
    const six_link_real t51 = R_T_forearm_yz * R_rel_wrist_roll_yy;
    const six_link_real R_P_wrist_roll_23 = t51 - R_T_forearm_yy * minus_R_rel_wrist_roll_yz;
    const six_link_real R_P_wrist_roll_32 = t51 + R_T_forearm_zz * minus_R_rel_wrist_roll_yz;
    const six_link_real R_P_wrist_roll_33 = R_T_forearm_zz * R_rel_wrist_roll_yy - t50;
    const six_link_real omega_R_wrist_roll_1 = R_T_forearm_xx * omega_T_forearm_1
        + minus_R_T_forearm_xy * omega_T_forearm_2 - R_T_forearm_xz * omega_T_forearm_3;
    const six_link_real omega_R_wrist_roll_2 = R_P_wrist_roll_12 * omega_T_forearm_1
        + R_P_wrist_roll_22 * omega_T_forearm_2 + R_P_wrist_roll_32 * omega_T_forearm_3;
    const six_link_real omega_R_wrist_roll_3 = R_P_wrist_roll_13 * omega_T_forearm_1
        + R_P_wrist_roll_23 * omega_T_forearm_2 + R_P_wrist_roll_33 * omega_T_forearm_3;

    /* wrist_roll, alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const six_link_real omega_wrist_roll_x = omega_R_wrist_roll_1 + state->v[3];
    const six_link_real alpha_0_wrist_roll_1 = R_T_forearm_xx * alpha_0_T_forearm_1
        + minus_R_T_forearm_xy * alpha_0_T_forearm_2 - R_T_forearm_xz * alpha_0_T_forearm_3;
    const six_link_real t52 = R_P_wrist_roll_12 * alpha_0_T_forearm_1 + R_P_wrist_roll_22 * alpha_0_T_forearm_2
        + R_P_wrist_roll_32 * alpha_0_T_forearm_3;
    const six_link_real t53 = R_P_wrist_roll_13 * alpha_0_T_forearm_1 + R_P_wrist_roll_23 * alpha_0_T_forearm_2
        + R_P_wrist_roll_33 * alpha_0_T_forearm_3;
    const six_link_real alpha_0_wrist_roll_2 = t52 + omega_R_wrist_roll_3 * state->v[3];
    const six_link_real alpha_0_wrist_roll_3 = t53 - omega_R_wrist_roll_2 * state->v[3];
    const six_link_real alpha_0_wrist_roll_4 = R_T_forearm_xx * alpha_0_T_forearm_4
        + minus_R_T_forearm_xy * alpha_0_T_forearm_5 - R_T_forearm_xz * alpha_0_T_forearm_6;
    const six_link_real alpha_0_wrist_roll_5 = R_P_wrist_roll_12 * alpha_0_T_forearm_4
        + R_P_wrist_roll_22 * alpha_0_T_forearm_5 + R_P_wrist_roll_32 * alpha_0_T_forearm_6;
    const six_link_real alpha_0_wrist_roll_6 = R_P_wrist_roll_13 * alpha_0_T_forearm_4
        + R_P_wrist_roll_23 * alpha_0_T_forearm_5 + R_P_wrist_roll_33 * alpha_0_T_forearm_6;

    /* wrist_roll, tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const six_link_real t54 = omega_R_wrist_roll_3 * c->links[3].length;
    const six_link_real t55 = omega_R_wrist_roll_2 * c->links[3].length;
    const six_link_real alpha_0_T_wrist_roll_4 = alpha_0_wrist_roll_4
        - (omega_R_wrist_roll_2 * t55 + omega_R_wrist_roll_3 * t54);
    const six_link_real alpha_0_T_wrist_roll_5 = alpha_0_wrist_roll_5 + alpha_0_wrist_roll_3 * c->links[3].length
        + omega_wrist_roll_x * t55;
    const six_link_real alpha_0_T_wrist_roll_6 = alpha_0_wrist_roll_6 - alpha_0_wrist_roll_2 * c->links[3].length
        + omega_wrist_roll_x * t54;

    /* wrist_pitch, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_5 = six_link_sine_cosine(state->q[4]);
    const six_link_real R_rel_wrist_pitch_xz = turn_5.sine, R_rel_wrist_pitch_xx = turn_5.cosine;

    /* wrist_pitch, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real omega_R_wrist_pitch_1 = R_rel_wrist_pitch_xx * omega_wrist_roll_x
        - R_rel_wrist_pitch_xz * omega_R_wrist_roll_3;
    const six_link_real omega_R_wrist_pitch_3 = R_rel_wrist_pitch_xz * omega_wrist_roll_x
        + R_rel_wrist_pitch_xx * omega_R_wrist_roll_3;

    /* wrist_pitch, alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const six_link_real omega_wrist_pitch_y = omega_R_wrist_roll_2 + state->v[4];
    const six_link_real alpha_0_wrist_pitch_1 = R_rel_wrist_pitch_xx * alpha_0_wrist_roll_1
        - R_rel_wrist_pitch_xz * alpha_0_wrist_roll_3 - omega_R_wrist_pitch_3 * state->v[4];
    const six_link_real alpha_0_wrist_pitch_3 = R_rel_wrist_pitch_xz * alpha_0_wrist_roll_1
        + R_rel_wrist_pitch_xx * alpha_0_wrist_roll_3 + omega_R_wrist_pitch_1 * state->v[4];
    const six_link_real alpha_0_wrist_pitch_4 = R_rel_wrist_pitch_xx * alpha_0_T_wrist_roll_4
        - R_rel_wrist_pitch_xz * alpha_0_T_wrist_roll_6;
    const six_link_real alpha_0_wrist_pitch_6 = R_rel_wrist_pitch_xz * alpha_0_T_wrist_roll_4
        + R_rel_wrist_pitch_xx * alpha_0_T_wrist_roll_6;

    /* wrist_pitch, tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const six_link_real t56 = omega_R_wrist_pitch_3 * c->links[4].length;
    const six_link_real t57 = omega_wrist_pitch_y * c->links[4].length;
    const six_link_real alpha_0_T_wrist_pitch_4 = alpha_0_wrist_pitch_4
        - (omega_wrist_pitch_y * t57 + omega_R_wrist_pitch_3 * t56);
    const six_link_real alpha_0_T_wrist_pitch_5 = alpha_0_T_wrist_roll_5
        + alpha_0_wrist_pitch_3 * c->links[4].length + omega_R_wrist_pitch_1 * t57;
    const six_link_real alpha_0_T_wrist_pitch_6 = alpha_0_wrist_pitch_6
        - alpha_0_wrist_roll_2 * c->links[4].length + omega_R_wrist_pitch_1 * t56;

    /* flange, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_6 = six_link_sine_cosine(state->q[5]);
    const six_link_real minus_R_rel_flange_yz = turn_6.sine, R_rel_flange_yy = turn_6.cosine;

    /* flange, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real omega_R_flange_2 = R_rel_flange_yy * omega_wrist_pitch_y
        + minus_R_rel_flange_yz * omega_R_wrist_pitch_3;
    const six_link_real omega_R_flange_3 = R_rel_flange_yy * omega_R_wrist_pitch_3
        - minus_R_rel_flange_yz * omega_wrist_pitch_y;

    /* flange, alpha_0: acceleration of F_i while no joint and no mode accelerates (accconst4) */
    const six_link_real omega_flange_x = omega_R_wrist_pitch_1 + state->v[5];
    const six_link_real alpha_0_flange_2 = R_rel_flange_yy * alpha_0_wrist_roll_2
        + minus_R_rel_flange_yz * alpha_0_wrist_pitch_3 + omega_R_flange_3 * state->v[5];
    const six_link_real alpha_0_flange_3 = R_rel_flange_yy * alpha_0_wrist_pitch_3
        - minus_R_rel_flange_yz * alpha_0_wrist_roll_2 - omega_R_flange_2 * state->v[5];
    const six_link_real alpha_0_flange_5 = R_rel_flange_yy * alpha_0_T_wrist_pitch_5
        + minus_R_rel_flange_yz * alpha_0_T_wrist_pitch_6;
    const six_link_real alpha_0_flange_6 = R_rel_flange_yy * alpha_0_T_wrist_pitch_6
        - minus_R_rel_flange_yz * alpha_0_T_wrist_pitch_5;

    /* flange, tip: angular velocity and acceleration while no joint and no mode accelerates (accconst1b) */
    const six_link_real t58 = omega_R_flange_3 * c->links[5].length;
    const six_link_real t59 = omega_R_flange_2 * c->links[5].length;
    const six_link_real alpha_0_T_flange_4 = alpha_0_T_wrist_pitch_4
        - (omega_R_flange_2 * t59 + omega_R_flange_3 * t58);
    const six_link_real alpha_0_T_flange_5 = alpha_0_flange_5 + alpha_0_flange_3 * c->links[5].length
        + omega_flange_x * t59;
    const six_link_real alpha_0_T_flange_6 = alpha_0_flange_6 - alpha_0_flange_2 * c->links[5].length
        + omega_flange_x * t58;

    /* flange, Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_flange_xx = omega_R_flange_2 * omega_R_flange_2
        + omega_R_flange_3 * omega_R_flange_3;
    const six_link_real Omega_flange_yx = alpha_0_flange_3 + omega_flange_x * omega_R_flange_2;
    const six_link_real Omega_flange_zx = omega_flange_x * omega_R_flange_3 - alpha_0_flange_2;

    /* flange, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_flange_1 = c->links[5].I_s * alpha_0_wrist_pitch_1;
    const six_link_real t60 = c->links[5].I_s * omega_flange_x;
    const six_link_real H_star_flange_2 = t60 * omega_R_flange_3 - c->links[5].J_0_xx * Omega_flange_zx
        - c->links[5].S_0_x * alpha_0_flange_6;
    const six_link_real H_star_flange_3 = c->links[5].J_0_xx * Omega_flange_yx
        + c->links[5].S_0_x * alpha_0_flange_5 - t60 * omega_R_flange_2;
    const six_link_real H_star_flange_4 = alpha_0_T_wrist_pitch_4 * c->links[5].mu
        - minus_Omega_flange_xx * c->links[5].S_0_x;
    const six_link_real H_star_flange_5 = Omega_flange_yx * c->links[5].S_0_x + alpha_0_flange_5 * c->links[5].mu;
    const six_link_real H_star_flange_6 = Omega_flange_zx * c->links[5].S_0_x + alpha_0_flange_6 * c->links[5].mu;

    /* flange, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t61 = c->links[5].I_T_xx * alpha_0_wrist_pitch_1 - c->links[5].J_T_xy * alpha_0_flange_2
        - c->links[5].J_T_xz * alpha_0_flange_3;
    const six_link_real t62 = c->links[5].I_T_yy * alpha_0_flange_2 - c->links[5].J_T_xy * alpha_0_wrist_pitch_1
        - c->links[5].J_T_yz * alpha_0_flange_3;
    const six_link_real t63 = c->links[5].I_T_zz * alpha_0_flange_3
        - (c->links[5].J_T_xz * alpha_0_wrist_pitch_1 + c->links[5].J_T_yz * alpha_0_flange_2);
    const six_link_real t64 = c->links[5].I_T_xx * omega_flange_x - c->links[5].J_T_xy * omega_R_flange_2
        - c->links[5].J_T_xz * omega_R_flange_3;
    const six_link_real t65 = c->links[5].I_T_yy * omega_R_flange_2 - c->links[5].J_T_xy * omega_flange_x
        - c->links[5].J_T_yz * omega_R_flange_3;
    const six_link_real t66 = c->links[5].I_T_zz * omega_R_flange_3
        - (c->links[5].J_T_xz * omega_flange_x + c->links[5].J_T_yz * omega_R_flange_2);
    const six_link_real t67 = c->links[5].S_T_y * alpha_0_T_flange_6 - c->links[5].S_T_z * alpha_0_T_flange_5
        + t61 + (omega_R_flange_2 * t66 - omega_R_flange_3 * t65);
    const six_link_real t68 = c->links[5].S_T_z * alpha_0_T_flange_4 - c->links[5].S_T_x * alpha_0_T_flange_6
        + t62 + (omega_R_flange_3 * t64 - omega_flange_x * t66);
    const six_link_real t69 = c->links[5].S_T_x * alpha_0_T_flange_5 - c->links[5].S_T_y * alpha_0_T_flange_4
        + t63 + (omega_flange_x * t65 - omega_R_flange_2 * t64);
    const six_link_real t70 = omega_R_flange_2 * c->links[5].S_T_z - omega_R_flange_3 * c->links[5].S_T_y;
    const six_link_real t71 = omega_R_flange_3 * c->links[5].S_T_x - omega_flange_x * c->links[5].S_T_z;
    const six_link_real t72 = omega_flange_x * c->links[5].S_T_y - omega_R_flange_2 * c->links[5].S_T_x;
    const six_link_real t73 = alpha_0_flange_2 * c->links[5].S_T_z - alpha_0_flange_3 * c->links[5].S_T_y
        + (omega_R_flange_2 * t72 - omega_R_flange_3 * t71);
    const six_link_real t74 = alpha_0_flange_3 * c->links[5].S_T_x - alpha_0_wrist_pitch_1 * c->links[5].S_T_z
        + (omega_R_flange_3 * t70 - omega_flange_x * t72);
    const six_link_real t75 = alpha_0_wrist_pitch_1 * c->links[5].S_T_y - alpha_0_flange_2 * c->links[5].S_T_x
        + (omega_flange_x * t71 - omega_R_flange_2 * t70);
    const six_link_real p_T_flange_1 = t67 - input->w_ext[5][0];
    const six_link_real p_T_flange_2 = t68 - input->w_ext[5][1];
    const six_link_real p_T_flange_3 = t69 - input->w_ext[5][2];
    const six_link_real p_T_flange_4 = c->links[5].body0_mass * alpha_0_T_flange_4 + t73 - input->w_ext[5][3];
    const six_link_real p_T_flange_5 = c->links[5].body0_mass * alpha_0_T_flange_5 + t74 - input->w_ext[5][4];
    const six_link_real p_T_flange_6 = c->links[5].body0_mass * alpha_0_T_flange_6 + t75 - input->w_ext[5][5];

    /* flange, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t76 = c->links[5].S_T_x + c->links[5].length * c->links[5].body0_mass;
    const six_link_real t77 = c->links[5].S_T_x * c->links[5].length;
    const six_link_real t78 = c->links[5].length * t76;
    const six_link_real minus_M_loaded_flange_12 = c->links[5].J_T_xy + c->links[5].S_T_y * c->links[5].length;
    const six_link_real minus_M_loaded_flange_13 = c->links[5].J_T_xz + c->links[5].S_T_z * c->links[5].length;
    const six_link_real M_loaded_flange_11 = c->links[5].I_s + c->links[5].I_T_xx;
    const six_link_real M_loaded_flange_22 = c->links[5].J_0_xx + (c->links[5].I_T_yy + t77 + t78);
    const six_link_real minus_M_loaded_flange_26 = t76 + c->links[5].S_0_x;
    const six_link_real M_loaded_flange_33 = c->links[5].J_0_xx + (c->links[5].I_T_zz + t77 + t78);
    const six_link_real M_loaded_flange_44 = c->links[5].mu + c->links[5].body0_mass;
    const six_link_real h_loaded_flange_1 = H_star_flange_1 + p_T_flange_1;
    const six_link_real h_loaded_flange_2 = H_star_flange_2 + (p_T_flange_2 - c->links[5].length * p_T_flange_6);
    const six_link_real h_loaded_flange_3 = H_star_flange_3 + (p_T_flange_3 + c->links[5].length * p_T_flange_5);
    const six_link_real h_loaded_flange_4 = H_star_flange_4 + p_T_flange_4;
    const six_link_real h_loaded_flange_5 = H_star_flange_5 + p_T_flange_5;
    const six_link_real h_loaded_flange_6 = H_star_flange_6 + p_T_flange_6;

    /* flange, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_flange_11 = M_loaded_flange_11 + c->links[5].armature_1;
    const six_link_real t79 = SIX_LINK_REAL_EPSILON * 8;
    bad |= (unsigned long)(!(joint_inertia_flange_11 - t79 * (M_loaded_flange_11 + M_loaded_flange_22 + M_loaded_flange_33) > 0)) << 5;
    const six_link_real joint_inverse_flange_1 = 1 / joint_inertia_flange_11;
    const six_link_real joint_W_flange_11 = M_loaded_flange_11 * joint_inverse_flange_1;
    const six_link_real minus_joint_W_flange_12 = minus_M_loaded_flange_12 * joint_inverse_flange_1;
    const six_link_real minus_joint_W_flange_13 = minus_M_loaded_flange_13 * joint_inverse_flange_1;
    const six_link_real minus_joint_W_flange_15 = c->links[5].S_T_z * joint_inverse_flange_1;
    const six_link_real joint_W_flange_16 = c->links[5].S_T_y * joint_inverse_flange_1;
    const six_link_real joint_w_flange_1 = (input->tau[5] - c->links[5].joint_damping_1 * state->v[5]
        - h_loaded_flange_1) * joint_inverse_flange_1;
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
    const six_link_real p_i_flange_1 = h_loaded_flange_1 + M_loaded_flange_11 * joint_w_flange_1;
    const six_link_real p_i_flange_2 = h_loaded_flange_2 - minus_M_loaded_flange_12 * joint_w_flange_1;
    const six_link_real p_i_flange_3 = h_loaded_flange_3 - minus_M_loaded_flange_13 * joint_w_flange_1;
    const six_link_real p_i_flange_5 = h_loaded_flange_5 - c->links[5].S_T_z * joint_w_flange_1;
    const six_link_real p_i_flange_6 = h_loaded_flange_6 + c->links[5].S_T_y * joint_w_flange_1;

    /* flange, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real Lambda_flange_2 = Lambda_i_flange_12 * R_rel_flange_yy
        - Lambda_i_flange_13 * minus_R_rel_flange_yz;
    const six_link_real Lambda_flange_3 = Lambda_i_flange_12 * minus_R_rel_flange_yz
        + Lambda_i_flange_13 * R_rel_flange_yy;
    const six_link_real t80 = (Lambda_i_flange_22 - Lambda_i_flange_33) * REAL(0.5);
    const six_link_real t81 = t80 * R_rel_flange_yy + minus_Lambda_i_flange_23 * minus_R_rel_flange_yz;
    const six_link_real t82 = t80 * minus_R_rel_flange_yz - minus_Lambda_i_flange_23 * R_rel_flange_yy;
    const six_link_real Lambda_flange_7 = R_rel_flange_yy * t81 * 2 + Lambda_i_flange_33;
    const six_link_real Lambda_flange_8 = R_rel_flange_yy * t82 + minus_R_rel_flange_yz * t81;
    const six_link_real Lambda_flange_12 = minus_R_rel_flange_yz * t82 * 2 + Lambda_i_flange_33;
    const six_link_real Lambda_flange_5 = Lambda_i_flange_15 * R_rel_flange_yy
        - Lambda_i_flange_16 * minus_R_rel_flange_yz;
    const six_link_real Lambda_flange_6 = Lambda_i_flange_15 * minus_R_rel_flange_yz
        + Lambda_i_flange_16 * R_rel_flange_yy;
    const six_link_real t83 = minus_Lambda_i_flange_25 * R_rel_flange_yy
        + Lambda_i_flange_26 * minus_R_rel_flange_yz;
    const six_link_real t84 = Lambda_i_flange_26 * R_rel_flange_yy
        - minus_Lambda_i_flange_25 * minus_R_rel_flange_yz;
    const six_link_real t85 = Lambda_i_flange_35 * R_rel_flange_yy - Lambda_i_flange_36 * minus_R_rel_flange_yz;
    const six_link_real t86 = Lambda_i_flange_35 * minus_R_rel_flange_yz + Lambda_i_flange_36 * R_rel_flange_yy;
    const six_link_real Lambda_flange_9 = R_rel_flange_yy * c->links[5].S_T_z
        + minus_R_rel_flange_yz * c->links[5].S_T_y;
    const six_link_real minus_Lambda_flange_10 = R_rel_flange_yy * t83 + minus_R_rel_flange_yz * t85;
    const six_link_real Lambda_flange_11 = R_rel_flange_yy * t84 - minus_R_rel_flange_yz * t86;
    const six_link_real Lambda_flange_13 = minus_R_rel_flange_yz * c->links[5].S_T_z
        - R_rel_flange_yy * c->links[5].S_T_y;
    const six_link_real Lambda_flange_14 = R_rel_flange_yy * t85 - minus_R_rel_flange_yz * t83;
    const six_link_real Lambda_flange_15 = minus_R_rel_flange_yz * t84 + R_rel_flange_yy * t86;
    const six_link_real t87 = (Lambda_i_flange_55 - Lambda_i_flange_66) * REAL(0.5);
    const six_link_real t88 = t87 * R_rel_flange_yy - Lambda_i_flange_56 * minus_R_rel_flange_yz;
    const six_link_real t89 = t87 * minus_R_rel_flange_yz + Lambda_i_flange_56 * R_rel_flange_yy;
    const six_link_real Lambda_flange_19 = R_rel_flange_yy * t88 * 2 + Lambda_i_flange_66;
    const six_link_real Lambda_flange_20 = R_rel_flange_yy * t89 + minus_R_rel_flange_yz * t88;
    const six_link_real Lambda_flange_21 = minus_R_rel_flange_yz * t89 * 2 + Lambda_i_flange_66;
    const six_link_real p_flange_2 = R_rel_flange_yy * p_i_flange_2 - minus_R_rel_flange_yz * p_i_flange_3;
    const six_link_real p_flange_3 = minus_R_rel_flange_yz * p_i_flange_2 + R_rel_flange_yy * p_i_flange_3;
    const six_link_real p_flange_5 = R_rel_flange_yy * p_i_flange_5 - minus_R_rel_flange_yz * p_i_flange_6;
    const six_link_real p_flange_6 = minus_R_rel_flange_yz * p_i_flange_5 + R_rel_flange_yy * p_i_flange_6;

    /* wrist_pitch, Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_wrist_pitch_xx = omega_wrist_pitch_y * omega_wrist_pitch_y
        + omega_R_wrist_pitch_3 * omega_R_wrist_pitch_3;
    const six_link_real Omega_wrist_pitch_yx = alpha_0_wrist_pitch_3
        + omega_R_wrist_pitch_1 * omega_wrist_pitch_y;
    const six_link_real Omega_wrist_pitch_zx = omega_R_wrist_pitch_1 * omega_R_wrist_pitch_3
        - alpha_0_wrist_roll_2;

    /* wrist_pitch, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_wrist_pitch_1 = c->links[4].I_s * alpha_0_wrist_pitch_1;
    const six_link_real t90 = c->links[4].I_s * omega_R_wrist_pitch_1;
    const six_link_real H_star_wrist_pitch_2 = t90 * omega_R_wrist_pitch_3
        - c->links[4].J_0_xx * Omega_wrist_pitch_zx - c->links[4].S_0_x * alpha_0_wrist_pitch_6;
    const six_link_real H_star_wrist_pitch_3 = c->links[4].J_0_xx * Omega_wrist_pitch_yx
        + c->links[4].S_0_x * alpha_0_T_wrist_roll_5 - t90 * omega_wrist_pitch_y;
    const six_link_real H_star_wrist_pitch_4 = alpha_0_wrist_pitch_4 * c->links[4].mu
        - minus_Omega_wrist_pitch_xx * c->links[4].S_0_x;
    const six_link_real H_star_wrist_pitch_5 = Omega_wrist_pitch_yx * c->links[4].S_0_x
        + alpha_0_T_wrist_roll_5 * c->links[4].mu;
    const six_link_real H_star_wrist_pitch_6 = Omega_wrist_pitch_zx * c->links[4].S_0_x
        + alpha_0_wrist_pitch_6 * c->links[4].mu;

    /* wrist_pitch, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_wrist_pitch_1 = p_i_flange_1 - input->w_ext[4][0];
    const six_link_real p_T_wrist_pitch_2 = p_flange_2 - input->w_ext[4][1];
    const six_link_real p_T_wrist_pitch_3 = p_flange_3 - input->w_ext[4][2];
    const six_link_real p_T_wrist_pitch_4 = h_loaded_flange_4 - input->w_ext[4][3];
    const six_link_real p_T_wrist_pitch_5 = p_flange_5 - input->w_ext[4][4];
    const six_link_real p_T_wrist_pitch_6 = p_flange_6 - input->w_ext[4][5];

    /* wrist_pitch, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t91 = c->links[4].length * Lambda_flange_20;
    const six_link_real minus_M_loaded_wrist_pitch_25 = minus_Lambda_flange_10 + t91;
    const six_link_real t92 = Lambda_flange_11 - c->links[4].length * Lambda_flange_21;
    const six_link_real t93 = Lambda_flange_14 + c->links[4].length * Lambda_flange_19;
    const six_link_real M_loaded_wrist_pitch_36 = Lambda_flange_15 + t91;
    const six_link_real M_loaded_wrist_pitch_12 = Lambda_flange_2 - Lambda_flange_6 * c->links[4].length;
    const six_link_real M_loaded_wrist_pitch_13 = Lambda_flange_3 + Lambda_flange_5 * c->links[4].length;
    const six_link_real M_loaded_wrist_pitch_23 = Lambda_flange_8 - minus_Lambda_flange_10 * c->links[4].length
        - c->links[4].length * M_loaded_wrist_pitch_36;
    const six_link_real M_loaded_wrist_pitch_11 = c->links[4].I_s + Lambda_i_flange_11;
    const six_link_real M_loaded_wrist_pitch_22 = c->links[4].J_0_xx
        + (Lambda_flange_7 - Lambda_flange_11 * c->links[4].length - c->links[4].length * t92);
    const six_link_real M_loaded_wrist_pitch_26 = t92 - c->links[4].S_0_x;
    const six_link_real M_loaded_wrist_pitch_33 = c->links[4].J_0_xx
        + (Lambda_flange_12 + Lambda_flange_14 * c->links[4].length + c->links[4].length * t93);
    const six_link_real M_loaded_wrist_pitch_35 = c->links[4].S_0_x + t93;
    const six_link_real M_loaded_wrist_pitch_44 = c->links[4].mu + M_loaded_flange_44;
    const six_link_real M_loaded_wrist_pitch_55 = c->links[4].mu + Lambda_flange_19;
    const six_link_real M_loaded_wrist_pitch_66 = c->links[4].mu + Lambda_flange_21;
    const six_link_real h_loaded_wrist_pitch_1 = H_star_wrist_pitch_1 + p_T_wrist_pitch_1;
    const six_link_real h_loaded_wrist_pitch_2 = H_star_wrist_pitch_2
        + (p_T_wrist_pitch_2 - c->links[4].length * p_T_wrist_pitch_6);
    const six_link_real h_loaded_wrist_pitch_3 = H_star_wrist_pitch_3
        + (p_T_wrist_pitch_3 + c->links[4].length * p_T_wrist_pitch_5);
    const six_link_real h_loaded_wrist_pitch_4 = H_star_wrist_pitch_4 + p_T_wrist_pitch_4;
    const six_link_real h_loaded_wrist_pitch_5 = H_star_wrist_pitch_5 + p_T_wrist_pitch_5;
    const six_link_real h_loaded_wrist_pitch_6 = H_star_wrist_pitch_6 + p_T_wrist_pitch_6;

    /* wrist_pitch, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_wrist_pitch_11 = M_loaded_wrist_pitch_22 + c->links[4].armature_1;
    bad |= (unsigned long)(!(joint_inertia_wrist_pitch_11 - t79 * (M_loaded_wrist_pitch_11 + M_loaded_wrist_pitch_22 + M_loaded_wrist_pitch_33) > 0)) << 4;
    const six_link_real joint_inverse_wrist_pitch_1 = 1 / joint_inertia_wrist_pitch_11;
    const six_link_real joint_W_wrist_pitch_11 = M_loaded_wrist_pitch_12 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_12 = M_loaded_wrist_pitch_22 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_13 = M_loaded_wrist_pitch_23 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_14 = Lambda_flange_9 * joint_inverse_wrist_pitch_1;
    const six_link_real minus_joint_W_wrist_pitch_15 = minus_M_loaded_wrist_pitch_25
        * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_16 = M_loaded_wrist_pitch_26 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_w_wrist_pitch_1 = (input->tau[4] - c->links[4].joint_damping_1 * state->v[4]
        - h_loaded_wrist_pitch_2) * joint_inverse_wrist_pitch_1;
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
    const six_link_real p_i_wrist_pitch_1 = h_loaded_wrist_pitch_1
        + M_loaded_wrist_pitch_12 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_2 = h_loaded_wrist_pitch_2
        + M_loaded_wrist_pitch_22 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_3 = h_loaded_wrist_pitch_3
        + M_loaded_wrist_pitch_23 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_4 = h_loaded_wrist_pitch_4 + Lambda_flange_9 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_5 = h_loaded_wrist_pitch_5
        - minus_M_loaded_wrist_pitch_25 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_6 = h_loaded_wrist_pitch_6
        + M_loaded_wrist_pitch_26 * joint_w_wrist_pitch_1;

    /* wrist_pitch, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t94 = (Lambda_i_wrist_pitch_11 - Lambda_i_wrist_pitch_33) * REAL(0.5);
    const six_link_real t95 = t94 * R_rel_wrist_pitch_xx + Lambda_i_wrist_pitch_13 * R_rel_wrist_pitch_xz;
    const six_link_real t96 = Lambda_i_wrist_pitch_13 * R_rel_wrist_pitch_xx - t94 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_1 = R_rel_wrist_pitch_xx * t95 * 2 + Lambda_i_wrist_pitch_33;
    const six_link_real Lambda_wrist_pitch_2 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_12
        + Lambda_i_wrist_pitch_23 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_3 = R_rel_wrist_pitch_xx * t96 - R_rel_wrist_pitch_xz * t95;
    const six_link_real Lambda_wrist_pitch_8 = Lambda_i_wrist_pitch_23 * R_rel_wrist_pitch_xx
        - R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_12;
    const six_link_real Lambda_wrist_pitch_12 = Lambda_i_wrist_pitch_33 - R_rel_wrist_pitch_xz * t96 * 2;
    const six_link_real t97 = Lambda_i_wrist_pitch_16 * R_rel_wrist_pitch_xz
        - minus_Lambda_i_wrist_pitch_14 * R_rel_wrist_pitch_xx;
    const six_link_real t98 = minus_Lambda_i_wrist_pitch_14 * R_rel_wrist_pitch_xz
        + Lambda_i_wrist_pitch_16 * R_rel_wrist_pitch_xx;
    const six_link_real Lambda_wrist_pitch_9 = Lambda_i_wrist_pitch_24 * R_rel_wrist_pitch_xx
        + Lambda_i_wrist_pitch_26 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_11 = Lambda_i_wrist_pitch_26 * R_rel_wrist_pitch_xx
        - Lambda_i_wrist_pitch_24 * R_rel_wrist_pitch_xz;
    const six_link_real t99 = Lambda_i_wrist_pitch_34 * R_rel_wrist_pitch_xx
        + Lambda_i_wrist_pitch_36 * R_rel_wrist_pitch_xz;
    const six_link_real t100 = Lambda_i_wrist_pitch_36 * R_rel_wrist_pitch_xx
        - Lambda_i_wrist_pitch_34 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_4 = R_rel_wrist_pitch_xx * t97 + R_rel_wrist_pitch_xz * t99;
    const six_link_real Lambda_wrist_pitch_5 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_15
        + R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_35;
    const six_link_real Lambda_wrist_pitch_6 = R_rel_wrist_pitch_xx * t98 + R_rel_wrist_pitch_xz * t100;
    const six_link_real Lambda_wrist_pitch_13 = R_rel_wrist_pitch_xx * t99 - R_rel_wrist_pitch_xz * t97;
    const six_link_real Lambda_wrist_pitch_14 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_35
        - R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_15;
    const six_link_real Lambda_wrist_pitch_15 = R_rel_wrist_pitch_xx * t100 - R_rel_wrist_pitch_xz * t98;
    const six_link_real t101 = (Lambda_i_wrist_pitch_44 - Lambda_i_wrist_pitch_66) * REAL(0.5);
    const six_link_real t102 = t101 * R_rel_wrist_pitch_xx - minus_Lambda_i_wrist_pitch_46 * R_rel_wrist_pitch_xz;
    const six_link_real t103 = t101 * R_rel_wrist_pitch_xz + minus_Lambda_i_wrist_pitch_46 * R_rel_wrist_pitch_xx;
    const six_link_real Lambda_wrist_pitch_16 = R_rel_wrist_pitch_xx * t102 * 2 + Lambda_i_wrist_pitch_66;
    const six_link_real Lambda_wrist_pitch_17 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_45
        + Lambda_i_wrist_pitch_56 * R_rel_wrist_pitch_xz;
    const six_link_real minus_Lambda_wrist_pitch_18 = R_rel_wrist_pitch_xx * t103 + R_rel_wrist_pitch_xz * t102;
    const six_link_real Lambda_wrist_pitch_20 = Lambda_i_wrist_pitch_56 * R_rel_wrist_pitch_xx
        - R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_45;
    const six_link_real Lambda_wrist_pitch_21 = R_rel_wrist_pitch_xz * t103 * 2 + Lambda_i_wrist_pitch_66;
    const six_link_real p_wrist_pitch_1 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_1
        + R_rel_wrist_pitch_xz * p_i_wrist_pitch_3;
    const six_link_real p_wrist_pitch_3 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_3
        - R_rel_wrist_pitch_xz * p_i_wrist_pitch_1;
    const six_link_real p_wrist_pitch_4 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_4
        + R_rel_wrist_pitch_xz * p_i_wrist_pitch_6;
    const six_link_real p_wrist_pitch_6 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_6
        - R_rel_wrist_pitch_xz * p_i_wrist_pitch_4;

    /* wrist_roll, Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_wrist_roll_xx = omega_R_wrist_roll_2 * omega_R_wrist_roll_2
        + omega_R_wrist_roll_3 * omega_R_wrist_roll_3;
    const six_link_real Omega_wrist_roll_yx = alpha_0_wrist_roll_3 + omega_wrist_roll_x * omega_R_wrist_roll_2;
    const six_link_real Omega_wrist_roll_zx = omega_wrist_roll_x * omega_R_wrist_roll_3 - alpha_0_wrist_roll_2;

    /* wrist_roll, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_wrist_roll_1 = c->links[3].I_s * alpha_0_wrist_roll_1;
    const six_link_real t104 = c->links[3].I_s * omega_wrist_roll_x;
    const six_link_real H_star_wrist_roll_2 = t104 * omega_R_wrist_roll_3
        - c->links[3].J_0_xx * Omega_wrist_roll_zx - c->links[3].S_0_x * alpha_0_wrist_roll_6;
    const six_link_real H_star_wrist_roll_3 = c->links[3].J_0_xx * Omega_wrist_roll_yx
        + c->links[3].S_0_x * alpha_0_wrist_roll_5 - t104 * omega_R_wrist_roll_2;
    const six_link_real H_star_wrist_roll_4 = alpha_0_wrist_roll_4 * c->links[3].mu
        - minus_Omega_wrist_roll_xx * c->links[3].S_0_x;
    const six_link_real H_star_wrist_roll_5 = Omega_wrist_roll_yx * c->links[3].S_0_x
        + alpha_0_wrist_roll_5 * c->links[3].mu;
    const six_link_real H_star_wrist_roll_6 = Omega_wrist_roll_zx * c->links[3].S_0_x
        + alpha_0_wrist_roll_6 * c->links[3].mu;

    /* wrist_roll, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_wrist_roll_1 = p_wrist_pitch_1 - input->w_ext[3][0];
    const six_link_real p_T_wrist_roll_2 = p_i_wrist_pitch_2 - input->w_ext[3][1];
    const six_link_real p_T_wrist_roll_3 = p_wrist_pitch_3 - input->w_ext[3][2];
    const six_link_real p_T_wrist_roll_4 = p_wrist_pitch_4 - input->w_ext[3][3];
    const six_link_real p_T_wrist_roll_5 = p_i_wrist_pitch_5 - input->w_ext[3][4];
    const six_link_real p_T_wrist_roll_6 = p_wrist_pitch_6 - input->w_ext[3][5];

    /* wrist_roll, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t105 = c->links[3].length * Lambda_wrist_pitch_20;
    const six_link_real M_loaded_wrist_roll_24 = Lambda_wrist_pitch_9
        + c->links[3].length * minus_Lambda_wrist_pitch_18;
    const six_link_real M_loaded_wrist_roll_25 = Lambda_i_wrist_pitch_25 - t105;
    const six_link_real t106 = Lambda_wrist_pitch_11 - c->links[3].length * Lambda_wrist_pitch_21;
    const six_link_real M_loaded_wrist_roll_34 = Lambda_wrist_pitch_13
        + c->links[3].length * Lambda_wrist_pitch_17;
    const six_link_real t107 = Lambda_wrist_pitch_14 + c->links[3].length * Lambda_i_wrist_pitch_55;
    const six_link_real M_loaded_wrist_roll_36 = Lambda_wrist_pitch_15 + t105;
    const six_link_real M_loaded_wrist_roll_12 = Lambda_wrist_pitch_2 - Lambda_wrist_pitch_6 * c->links[3].length;
    const six_link_real M_loaded_wrist_roll_13 = Lambda_wrist_pitch_3 + Lambda_wrist_pitch_5 * c->links[3].length;
    const six_link_real M_loaded_wrist_roll_23 = Lambda_wrist_pitch_8
        + Lambda_i_wrist_pitch_25 * c->links[3].length - c->links[3].length * M_loaded_wrist_roll_36;
    const six_link_real M_loaded_wrist_roll_11 = c->links[3].I_s + Lambda_wrist_pitch_1;
    const six_link_real M_loaded_wrist_roll_22 = c->links[3].J_0_xx
        + (Lambda_i_wrist_pitch_22 - Lambda_wrist_pitch_11 * c->links[3].length - c->links[3].length * t106);
    const six_link_real M_loaded_wrist_roll_26 = t106 - c->links[3].S_0_x;
    const six_link_real M_loaded_wrist_roll_33 = c->links[3].J_0_xx
        + (Lambda_wrist_pitch_12 + Lambda_wrist_pitch_14 * c->links[3].length + c->links[3].length * t107);
    const six_link_real M_loaded_wrist_roll_35 = c->links[3].S_0_x + t107;
    const six_link_real M_loaded_wrist_roll_44 = c->links[3].mu + Lambda_wrist_pitch_16;
    const six_link_real M_loaded_wrist_roll_55 = c->links[3].mu + Lambda_i_wrist_pitch_55;
    const six_link_real M_loaded_wrist_roll_66 = c->links[3].mu + Lambda_wrist_pitch_21;
    const six_link_real h_loaded_wrist_roll_1 = H_star_wrist_roll_1 + p_T_wrist_roll_1;
    const six_link_real h_loaded_wrist_roll_2 = H_star_wrist_roll_2
        + (p_T_wrist_roll_2 - c->links[3].length * p_T_wrist_roll_6);
    const six_link_real h_loaded_wrist_roll_3 = H_star_wrist_roll_3
        + (p_T_wrist_roll_3 + c->links[3].length * p_T_wrist_roll_5);
    const six_link_real h_loaded_wrist_roll_4 = H_star_wrist_roll_4 + p_T_wrist_roll_4;
    const six_link_real h_loaded_wrist_roll_5 = H_star_wrist_roll_5 + p_T_wrist_roll_5;
    const six_link_real h_loaded_wrist_roll_6 = H_star_wrist_roll_6 + p_T_wrist_roll_6;

    /* wrist_roll, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_wrist_roll_11 = M_loaded_wrist_roll_11 + c->links[3].armature_1;
    bad |= (unsigned long)(!(joint_inertia_wrist_roll_11 - t79 * (M_loaded_wrist_roll_11 + M_loaded_wrist_roll_22 + M_loaded_wrist_roll_33) > 0)) << 3;
    const six_link_real joint_inverse_wrist_roll_1 = 1 / joint_inertia_wrist_roll_11;
    const six_link_real joint_W_wrist_roll_11 = M_loaded_wrist_roll_11 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_12 = M_loaded_wrist_roll_12 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_13 = M_loaded_wrist_roll_13 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_14 = Lambda_wrist_pitch_4 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_15 = Lambda_wrist_pitch_5 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_16 = Lambda_wrist_pitch_6 * joint_inverse_wrist_roll_1;
    const six_link_real joint_w_wrist_roll_1 = (input->tau[3] - c->links[3].joint_damping_1 * state->v[3]
        - h_loaded_wrist_roll_1) * joint_inverse_wrist_roll_1;
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
    const six_link_real minus_Lambda_i_wrist_roll_46 = minus_Lambda_wrist_pitch_18
        + Lambda_wrist_pitch_4 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_55 = M_loaded_wrist_roll_55
        - Lambda_wrist_pitch_5 * joint_W_wrist_roll_15;
    const six_link_real Lambda_i_wrist_roll_56 = Lambda_wrist_pitch_20
        - Lambda_wrist_pitch_5 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_66 = M_loaded_wrist_roll_66
        - Lambda_wrist_pitch_6 * joint_W_wrist_roll_16;
    const six_link_real p_i_wrist_roll_1 = h_loaded_wrist_roll_1 + M_loaded_wrist_roll_11 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_2 = h_loaded_wrist_roll_2 + M_loaded_wrist_roll_12 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_3 = h_loaded_wrist_roll_3 + M_loaded_wrist_roll_13 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_4 = h_loaded_wrist_roll_4 + Lambda_wrist_pitch_4 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_5 = h_loaded_wrist_roll_5 + Lambda_wrist_pitch_5 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_6 = h_loaded_wrist_roll_6 + Lambda_wrist_pitch_6 * joint_w_wrist_roll_1;

    /* wrist_roll, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t108 = (Lambda_i_wrist_roll_11 - Lambda_i_wrist_roll_33) * REAL(0.5);
    const six_link_real t109 = t108 * R_T_forearm_xx + Lambda_i_wrist_roll_12 * R_P_wrist_roll_12
        + Lambda_i_wrist_roll_13 * R_P_wrist_roll_13;
    const six_link_real t110 = t108 * minus_R_T_forearm_xy + Lambda_i_wrist_roll_12 * R_P_wrist_roll_22
        + Lambda_i_wrist_roll_13 * R_P_wrist_roll_23;
    const six_link_real t111 = Lambda_i_wrist_roll_12 * R_P_wrist_roll_32 - t108 * R_T_forearm_xz
        + Lambda_i_wrist_roll_13 * R_P_wrist_roll_33;
    const six_link_real t112 = (Lambda_i_wrist_roll_22 - Lambda_i_wrist_roll_33) * REAL(0.5);
    const six_link_real t113 = t112 * R_P_wrist_roll_12 + Lambda_i_wrist_roll_23 * R_P_wrist_roll_13;
    const six_link_real t114 = t112 * R_P_wrist_roll_22 + Lambda_i_wrist_roll_23 * R_P_wrist_roll_23;
    const six_link_real t115 = t112 * R_P_wrist_roll_32 + Lambda_i_wrist_roll_23 * R_P_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_1 = (R_T_forearm_xx * t109 + R_P_wrist_roll_12 * t113) * 2
        + Lambda_i_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_2 = R_T_forearm_xx * t110 + R_P_wrist_roll_12 * t114
        + (minus_R_T_forearm_xy * t109 + R_P_wrist_roll_22 * t113);
    const six_link_real Lambda_wrist_roll_3 = R_T_forearm_xx * t111 + R_P_wrist_roll_12 * t115
        + (R_P_wrist_roll_32 * t113 - R_T_forearm_xz * t109);
    const six_link_real Lambda_wrist_roll_7 = (minus_R_T_forearm_xy * t110 + R_P_wrist_roll_22 * t114) * 2
        + Lambda_i_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_8 = minus_R_T_forearm_xy * t111 + R_P_wrist_roll_22 * t115
        + (R_P_wrist_roll_32 * t114 - R_T_forearm_xz * t110);
    const six_link_real Lambda_wrist_roll_12 = (R_P_wrist_roll_32 * t115 - R_T_forearm_xz * t111) * 2
        + Lambda_i_wrist_roll_33;
    const six_link_real t116 = Lambda_i_wrist_roll_14 * R_T_forearm_xx
        + Lambda_i_wrist_roll_15 * R_P_wrist_roll_12 + Lambda_i_wrist_roll_16 * R_P_wrist_roll_13;
    const six_link_real t117 = Lambda_i_wrist_roll_14 * minus_R_T_forearm_xy
        + Lambda_i_wrist_roll_15 * R_P_wrist_roll_22 + Lambda_i_wrist_roll_16 * R_P_wrist_roll_23;
    const six_link_real t118 = Lambda_i_wrist_roll_15 * R_P_wrist_roll_32
        - Lambda_i_wrist_roll_14 * R_T_forearm_xz + Lambda_i_wrist_roll_16 * R_P_wrist_roll_33;
    const six_link_real t119 = Lambda_i_wrist_roll_24 * R_T_forearm_xx
        + Lambda_i_wrist_roll_25 * R_P_wrist_roll_12 + Lambda_i_wrist_roll_26 * R_P_wrist_roll_13;
    const six_link_real t120 = Lambda_i_wrist_roll_24 * minus_R_T_forearm_xy
        + Lambda_i_wrist_roll_25 * R_P_wrist_roll_22 + Lambda_i_wrist_roll_26 * R_P_wrist_roll_23;
    const six_link_real t121 = Lambda_i_wrist_roll_25 * R_P_wrist_roll_32
        - Lambda_i_wrist_roll_24 * R_T_forearm_xz + Lambda_i_wrist_roll_26 * R_P_wrist_roll_33;
    const six_link_real t122 = Lambda_i_wrist_roll_34 * R_T_forearm_xx
        + Lambda_i_wrist_roll_35 * R_P_wrist_roll_12 + Lambda_i_wrist_roll_36 * R_P_wrist_roll_13;
    const six_link_real t123 = Lambda_i_wrist_roll_34 * minus_R_T_forearm_xy
        + Lambda_i_wrist_roll_35 * R_P_wrist_roll_22 + Lambda_i_wrist_roll_36 * R_P_wrist_roll_23;
    const six_link_real t124 = Lambda_i_wrist_roll_35 * R_P_wrist_roll_32
        - Lambda_i_wrist_roll_34 * R_T_forearm_xz + Lambda_i_wrist_roll_36 * R_P_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_4 = R_T_forearm_xx * t116 + R_P_wrist_roll_12 * t119
        + R_P_wrist_roll_13 * t122;
    const six_link_real Lambda_wrist_roll_5 = R_T_forearm_xx * t117 + R_P_wrist_roll_12 * t120
        + R_P_wrist_roll_13 * t123;
    const six_link_real Lambda_wrist_roll_6 = R_T_forearm_xx * t118 + R_P_wrist_roll_12 * t121
        + R_P_wrist_roll_13 * t124;
    const six_link_real Lambda_wrist_roll_9 = minus_R_T_forearm_xy * t116 + R_P_wrist_roll_22 * t119
        + R_P_wrist_roll_23 * t122;
    const six_link_real Lambda_wrist_roll_10 = minus_R_T_forearm_xy * t117 + R_P_wrist_roll_22 * t120
        + R_P_wrist_roll_23 * t123;
    const six_link_real Lambda_wrist_roll_11 = minus_R_T_forearm_xy * t118 + R_P_wrist_roll_22 * t121
        + R_P_wrist_roll_23 * t124;
    const six_link_real Lambda_wrist_roll_13 = R_P_wrist_roll_32 * t119 - R_T_forearm_xz * t116
        + R_P_wrist_roll_33 * t122;
    const six_link_real Lambda_wrist_roll_14 = R_P_wrist_roll_32 * t120 - R_T_forearm_xz * t117
        + R_P_wrist_roll_33 * t123;
    const six_link_real Lambda_wrist_roll_15 = R_P_wrist_roll_32 * t121 - R_T_forearm_xz * t118
        + R_P_wrist_roll_33 * t124;
    const six_link_real t125 = (Lambda_i_wrist_roll_44 - Lambda_i_wrist_roll_66) * REAL(0.5);
    const six_link_real t126 = t125 * R_T_forearm_xx + Lambda_i_wrist_roll_45 * R_P_wrist_roll_12
        - minus_Lambda_i_wrist_roll_46 * R_P_wrist_roll_13;
    const six_link_real t127 = t125 * minus_R_T_forearm_xy + Lambda_i_wrist_roll_45 * R_P_wrist_roll_22
        - minus_Lambda_i_wrist_roll_46 * R_P_wrist_roll_23;
    const six_link_real t128 = Lambda_i_wrist_roll_45 * R_P_wrist_roll_32 - t125 * R_T_forearm_xz
        - minus_Lambda_i_wrist_roll_46 * R_P_wrist_roll_33;
    const six_link_real t129 = (Lambda_i_wrist_roll_55 - Lambda_i_wrist_roll_66) * REAL(0.5);
    const six_link_real t130 = t129 * R_P_wrist_roll_12 + Lambda_i_wrist_roll_56 * R_P_wrist_roll_13;
    const six_link_real t131 = t129 * R_P_wrist_roll_22 + Lambda_i_wrist_roll_56 * R_P_wrist_roll_23;
    const six_link_real t132 = t129 * R_P_wrist_roll_32 + Lambda_i_wrist_roll_56 * R_P_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_16 = (R_T_forearm_xx * t126 + R_P_wrist_roll_12 * t130) * 2
        + Lambda_i_wrist_roll_66;
    const six_link_real Lambda_wrist_roll_17 = R_T_forearm_xx * t127 + R_P_wrist_roll_12 * t131
        + (minus_R_T_forearm_xy * t126 + R_P_wrist_roll_22 * t130);
    const six_link_real Lambda_wrist_roll_18 = R_T_forearm_xx * t128 + R_P_wrist_roll_12 * t132
        + (R_P_wrist_roll_32 * t130 - R_T_forearm_xz * t126);
    const six_link_real Lambda_wrist_roll_19 = (minus_R_T_forearm_xy * t127 + R_P_wrist_roll_22 * t131) * 2
        + Lambda_i_wrist_roll_66;
    const six_link_real Lambda_wrist_roll_20 = minus_R_T_forearm_xy * t128 + R_P_wrist_roll_22 * t132
        + (R_P_wrist_roll_32 * t131 - R_T_forearm_xz * t127);
    const six_link_real Lambda_wrist_roll_21 = (R_P_wrist_roll_32 * t132 - R_T_forearm_xz * t128) * 2
        + Lambda_i_wrist_roll_66;
    const six_link_real p_wrist_roll_1 = R_T_forearm_xx * p_i_wrist_roll_1 + R_P_wrist_roll_12 * p_i_wrist_roll_2
        + R_P_wrist_roll_13 * p_i_wrist_roll_3;
    const six_link_real p_wrist_roll_2 = minus_R_T_forearm_xy * p_i_wrist_roll_1
        + R_P_wrist_roll_22 * p_i_wrist_roll_2 + R_P_wrist_roll_23 * p_i_wrist_roll_3;
    const six_link_real p_wrist_roll_3 = R_P_wrist_roll_32 * p_i_wrist_roll_2 - R_T_forearm_xz * p_i_wrist_roll_1
        + R_P_wrist_roll_33 * p_i_wrist_roll_3;
    const six_link_real p_wrist_roll_4 = R_T_forearm_xx * p_i_wrist_roll_4 + R_P_wrist_roll_12 * p_i_wrist_roll_5
        + R_P_wrist_roll_13 * p_i_wrist_roll_6;
    const six_link_real p_wrist_roll_5 = minus_R_T_forearm_xy * p_i_wrist_roll_4
        + R_P_wrist_roll_22 * p_i_wrist_roll_5 + R_P_wrist_roll_23 * p_i_wrist_roll_6;
    const six_link_real p_wrist_roll_6 = R_P_wrist_roll_32 * p_i_wrist_roll_5 - R_T_forearm_xz * p_i_wrist_roll_4
        + R_P_wrist_roll_33 * p_i_wrist_roll_6;

    /* forearm, S: first moment */
    const six_link_real S_forearm_y = c->links[2].S_B_y + state->q[9] * c->links[2].sigma_y1;
    const six_link_real S_forearm_z = c->links[2].S_B_z + state->q[10] * c->links[2].sigma_y1;

    /* forearm, Sdot: rate of the first moment */
    const six_link_real Sdot_forearm_y = state->v[9] * c->links[2].sigma_y1;
    const six_link_real Sdot_forearm_z = state->v[10] * c->links[2].sigma_y1;

    /* forearm, L: first moment weighted by each mode shape (85) */
    const six_link_real L_forearm_y1 = c->links[2].mu * state->q[9];
    const six_link_real L_forearm_z1 = state->q[10] * c->links[2].mu;

    /* forearm, Ldot: rate of L */
    const six_link_real Ldot_forearm_y1 = c->links[2].mu * state->v[9];
    const six_link_real Ldot_forearm_z1 = state->v[10] * c->links[2].mu;

    /* forearm, J: second moment */
    const six_link_real J_forearm_xy = c->links[2].J_B_xy + c->links[2].chi_1 * state->q[9];
    const six_link_real J_forearm_xz = c->links[2].J_B_xz + c->links[2].chi_1 * state->q[10];
    const six_link_real J_forearm_yy = c->links[2].J_B_yy + L_forearm_y1 * state->q[9];
    const six_link_real J_forearm_yz = c->links[2].J_B_yz + L_forearm_z1 * state->q[9];
    const six_link_real J_forearm_zz = c->links[2].J_B_zz + L_forearm_z1 * state->q[10];

    /* forearm, I: inertia about the origin, deformed */
    const six_link_real I_forearm_xx = c->links[2].I_s + J_forearm_yy + J_forearm_zz;
    const six_link_real I_forearm_yy = c->links[2].J_0_xx + J_forearm_zz;
    const six_link_real I_forearm_zz = c->links[2].J_0_xx + J_forearm_yy;

    /* forearm, Omega: acceleration of a place by the link's turning */
    const six_link_real t133 = omega_forearm_y * omega_forearm_y;
    const six_link_real t134 = omega_R_forearm_3 * omega_R_forearm_3;
    const six_link_real minus_Omega_forearm_xx = t133 + t134;
    const six_link_real t135 = omega_R_forearm_1 * omega_forearm_y;
    const six_link_real Omega_forearm_xy = t135 - alpha_0_forearm_3;
    const six_link_real t136 = omega_R_forearm_1 * omega_R_forearm_3;
    const six_link_real Omega_forearm_xz = alpha_0_forearm_2 + t136;
    const six_link_real Omega_forearm_yx = alpha_0_forearm_3 + t135;
    const six_link_real t137 = omega_R_forearm_1 * omega_R_forearm_1;
    const six_link_real minus_Omega_forearm_yy = t137 + t134;
    const six_link_real t138 = omega_forearm_y * omega_R_forearm_3;
    const six_link_real Omega_forearm_yz = t138 - alpha_0_forearm_1;
    const six_link_real Omega_forearm_zx = t136 - alpha_0_forearm_2;
    const six_link_real Omega_forearm_zy = alpha_0_forearm_1 + t138;
    const six_link_real minus_Omega_forearm_zz = t137 + t133;

    /* forearm, B: moment of the elastic velocity */
    const six_link_real B_forearm_yx = c->links[2].chi_1 * state->v[9];
    const six_link_real B_forearm_yy = L_forearm_y1 * state->v[9];
    const six_link_real B_forearm_yz = L_forearm_z1 * state->v[9];
    const six_link_real B_forearm_zx = c->links[2].chi_1 * state->v[10];
    const six_link_real B_forearm_zy = L_forearm_y1 * state->v[10];
    const six_link_real B_forearm_zz = L_forearm_z1 * state->v[10];

    /* forearm, h_c: half of the Coriolis wrench */
    const six_link_real h_c_forearm_1 = B_forearm_yy * omega_R_forearm_1 + B_forearm_zz * omega_R_forearm_1;
    const six_link_real h_c_forearm_2 = B_forearm_zz * omega_forearm_y - B_forearm_yx * omega_R_forearm_1
        - B_forearm_yz * omega_R_forearm_3;
    const six_link_real h_c_forearm_3 = B_forearm_yy * omega_R_forearm_3 - B_forearm_zx * omega_R_forearm_1
        - B_forearm_zy * omega_forearm_y;
    const six_link_real h_c_forearm_4 = Sdot_forearm_z * omega_forearm_y - Sdot_forearm_y * omega_R_forearm_3;
    const six_link_real minus_h_c_forearm_5 = Sdot_forearm_z * omega_R_forearm_1;
    const six_link_real h_c_forearm_6 = Sdot_forearm_y * omega_R_forearm_1;

    /* forearm, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real t139 = h_c_forearm_1 + c->links[2].I_s * alpha_0_forearm_1
        + J_forearm_xy * Omega_forearm_zx + J_forearm_yy * Omega_forearm_zy;
    const six_link_real t140 = t139 + J_forearm_yz * (minus_Omega_forearm_yy - minus_Omega_forearm_zz)
        + S_forearm_y * alpha_0_forearm_6;
    const six_link_real H_star_forearm_1 = t140 - J_forearm_xz * Omega_forearm_yx
        - J_forearm_zz * Omega_forearm_yz - S_forearm_z * alpha_0_forearm_5;
    const six_link_real t141 = h_c_forearm_2 + J_forearm_xz * (minus_Omega_forearm_zz - minus_Omega_forearm_xx)
        + J_forearm_yz * Omega_forearm_xy;
    const six_link_real t142 = c->links[2].I_s * omega_R_forearm_1;
    const six_link_real t143 = t141 + J_forearm_zz * Omega_forearm_xz + S_forearm_z * alpha_0_forearm_4
        + t142 * omega_R_forearm_3;
    const six_link_real H_star_forearm_2 = t143 - c->links[2].J_0_xx * Omega_forearm_zx
        - J_forearm_xy * Omega_forearm_zy - c->links[2].S_0_x * alpha_0_forearm_6;
    const six_link_real t144 = h_c_forearm_3 + c->links[2].J_0_xx * Omega_forearm_yx
        + J_forearm_xy * (minus_Omega_forearm_xx - minus_Omega_forearm_yy);
    const six_link_real t145 = t144 + J_forearm_xz * Omega_forearm_yz + c->links[2].S_0_x * alpha_0_forearm_5
        - J_forearm_yy * Omega_forearm_xy;
    const six_link_real H_star_forearm_3 = t145 - J_forearm_yz * Omega_forearm_xz
        - S_forearm_y * alpha_0_forearm_4 - t142 * omega_forearm_y;
    const six_link_real t146 = h_c_forearm_4 - minus_Omega_forearm_xx * c->links[2].S_0_x
        + Omega_forearm_xy * S_forearm_y + Omega_forearm_xz * S_forearm_z;
    const six_link_real H_star_forearm_4 = t146 + alpha_0_forearm_4 * c->links[2].m;
    const six_link_real t147 = Omega_forearm_yx * c->links[2].S_0_x - minus_h_c_forearm_5
        - minus_Omega_forearm_yy * S_forearm_y;
    const six_link_real H_star_forearm_5 = t147 + Omega_forearm_yz * S_forearm_z
        + alpha_0_forearm_5 * c->links[2].m;
    const six_link_real t148 = h_c_forearm_6 + Omega_forearm_zx * c->links[2].S_0_x
        + Omega_forearm_zy * S_forearm_y - minus_Omega_forearm_zz * S_forearm_z;
    const six_link_real H_star_forearm_6 = t148 + alpha_0_forearm_6 * c->links[2].m;

    /* forearm, h_V: bias of the twist rows, angular acceleration included */
    const six_link_real h_V_forearm_1 = H_star_forearm_1 + h_c_forearm_1;
    const six_link_real h_V_forearm_2 = H_star_forearm_2 + h_c_forearm_2;
    const six_link_real h_V_forearm_3 = H_star_forearm_3 + h_c_forearm_3;
    const six_link_real h_V_forearm_4 = H_star_forearm_4 + h_c_forearm_4;
    const six_link_real h_V_forearm_5 = H_star_forearm_5 - minus_h_c_forearm_5;
    const six_link_real h_V_forearm_6 = H_star_forearm_6 + h_c_forearm_6;

    /* forearm, h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const six_link_real t149 = L_forearm_z1 * Omega_forearm_yz - L_forearm_y1 * minus_Omega_forearm_yy
        + Omega_forearm_yx * c->links[2].chi_1;
    const six_link_real h_eta_forearm_1 = t149 + alpha_0_forearm_5 * c->links[2].sigma_y1
        - Ldot_forearm_z1 * 2 * omega_R_forearm_1;
    const six_link_real t150 = L_forearm_y1 * Omega_forearm_zy - L_forearm_z1 * minus_Omega_forearm_zz
        + Omega_forearm_zx * c->links[2].chi_1;
    const six_link_real h_eta_forearm_2 = t150 + alpha_0_forearm_6 * c->links[2].sigma_y1
        + Ldot_forearm_y1 * 2 * omega_R_forearm_1;

    /* forearm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t151 = R_T_forearm_xx * input->w_ext[2][0] - minus_R_T_forearm_xy * input->w_ext[2][1]
        + R_T_forearm_xz * input->w_ext[2][2];
    const six_link_real t152 = minus_R_T_forearm_xy * input->w_ext[2][0] + R_T_forearm_yy * input->w_ext[2][1]
        + R_T_forearm_yz * input->w_ext[2][2];
    const six_link_real t153 = R_T_forearm_yz * input->w_ext[2][1] - R_T_forearm_xz * input->w_ext[2][0]
        + R_T_forearm_zz * input->w_ext[2][2];
    const six_link_real t154 = R_T_forearm_xx * input->w_ext[2][3] - minus_R_T_forearm_xy * input->w_ext[2][4]
        + R_T_forearm_xz * input->w_ext[2][5];
    const six_link_real t155 = minus_R_T_forearm_xy * input->w_ext[2][3] + R_T_forearm_yy * input->w_ext[2][4]
        + R_T_forearm_yz * input->w_ext[2][5];
    const six_link_real t156 = R_T_forearm_yz * input->w_ext[2][4] - R_T_forearm_xz * input->w_ext[2][3]
        + R_T_forearm_zz * input->w_ext[2][5];
    const six_link_real p_T_forearm_1 = p_wrist_roll_1 - t151;
    const six_link_real p_T_forearm_2 = p_wrist_roll_2 - t152;
    const six_link_real p_T_forearm_3 = p_wrist_roll_3 - t153;
    const six_link_real p_T_forearm_4 = p_wrist_roll_4 - t154;
    const six_link_real p_T_forearm_5 = p_wrist_roll_5 - t155;
    const six_link_real p_T_forearm_6 = p_wrist_roll_6 - t156;

    /* forearm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real Theta_forearm_11 = J_l_forearm_xz * c->links[2].Psi_c_z1;
    const six_link_real minus_Theta_forearm_12 = minus_J_l_forearm_xy * c->links[2].Psi_c_y2;
    const six_link_real Theta_forearm_21 = J_l_forearm_yz * c->links[2].Psi_c_z1;
    const six_link_real Theta_forearm_22 = J_l_forearm_yy * c->links[2].Psi_c_y2;
    const six_link_real Theta_forearm_31 = J_l_forearm_zz * c->links[2].Psi_c_z1;
    const six_link_real Theta_forearm_32 = J_l_forearm_yz * c->links[2].Psi_c_y2;
    const six_link_real t157 = r_T_forearm_z * Lambda_wrist_roll_17;
    const six_link_real t158 = r_T_forearm_y * Lambda_wrist_roll_18;
    const six_link_real t159 = c->links[2].length * Lambda_wrist_roll_20;
    const six_link_real M_loaded_forearm_14 = Lambda_wrist_roll_4 + (t158 - t157);
    const six_link_real t160 = Lambda_wrist_roll_5
        + (r_T_forearm_y * Lambda_wrist_roll_20 - r_T_forearm_z * Lambda_wrist_roll_19);
    const six_link_real t161 = Lambda_wrist_roll_6
        + (r_T_forearm_y * Lambda_wrist_roll_21 - r_T_forearm_z * Lambda_wrist_roll_20);
    const six_link_real t162 = Lambda_wrist_roll_9
        + (r_T_forearm_z * Lambda_wrist_roll_16 - c->links[2].length * Lambda_wrist_roll_18);
    const six_link_real M_loaded_forearm_25 = Lambda_wrist_roll_10 + (t157 - t159);
    const six_link_real t163 = Lambda_wrist_roll_11
        + (r_T_forearm_z * Lambda_wrist_roll_18 - c->links[2].length * Lambda_wrist_roll_21);
    const six_link_real t164 = Lambda_wrist_roll_13
        + (c->links[2].length * Lambda_wrist_roll_17 - r_T_forearm_y * Lambda_wrist_roll_16);
    const six_link_real t165 = Lambda_wrist_roll_14
        + (c->links[2].length * Lambda_wrist_roll_19 - r_T_forearm_y * Lambda_wrist_roll_17);
    const six_link_real M_loaded_forearm_36 = Lambda_wrist_roll_15 + (t159 - t158);
    const six_link_real t166 = Lambda_wrist_roll_1
        - (Lambda_wrist_roll_5 * r_T_forearm_z - Lambda_wrist_roll_6 * r_T_forearm_y);
    const six_link_real t167 = Lambda_wrist_roll_2
        - (Lambda_wrist_roll_6 * c->links[2].length - Lambda_wrist_roll_4 * r_T_forearm_z);
    const six_link_real t168 = Lambda_wrist_roll_3
        - (Lambda_wrist_roll_4 * r_T_forearm_y - Lambda_wrist_roll_5 * c->links[2].length);
    const six_link_real t169 = Lambda_wrist_roll_7
        - (Lambda_wrist_roll_11 * c->links[2].length - Lambda_wrist_roll_9 * r_T_forearm_z);
    const six_link_real t170 = Lambda_wrist_roll_8
        - (Lambda_wrist_roll_9 * r_T_forearm_y - Lambda_wrist_roll_10 * c->links[2].length);
    const six_link_real t171 = Lambda_wrist_roll_12
        - (Lambda_wrist_roll_13 * r_T_forearm_y - Lambda_wrist_roll_14 * c->links[2].length);
    const six_link_real M_loaded_forearm_11 = I_forearm_xx
        + (t166 + (r_T_forearm_y * t161 - r_T_forearm_z * t160));
    const six_link_real M_loaded_forearm_12 = t167 + (r_T_forearm_y * t163 - r_T_forearm_z * M_loaded_forearm_25)
        - J_forearm_xy;
    const six_link_real M_loaded_forearm_13 = t168 + (r_T_forearm_y * M_loaded_forearm_36 - r_T_forearm_z * t165)
        - J_forearm_xz;
    const six_link_real M_loaded_forearm_15 = t160 - S_forearm_z;
    const six_link_real M_loaded_forearm_16 = S_forearm_y + t161;
    const six_link_real M_loaded_forearm_22 = I_forearm_yy
        + (t169 + (r_T_forearm_z * t162 - c->links[2].length * t163));
    const six_link_real M_loaded_forearm_23 = t170
        + (r_T_forearm_z * t164 - c->links[2].length * M_loaded_forearm_36) - J_forearm_yz;
    const six_link_real M_loaded_forearm_24 = S_forearm_z + t162;
    const six_link_real M_loaded_forearm_26 = t163 - c->links[2].S_0_x;
    const six_link_real M_loaded_forearm_33 = I_forearm_zz
        + (t171 + (c->links[2].length * t165 - r_T_forearm_y * t164));
    const six_link_real M_loaded_forearm_34 = t164 - S_forearm_y;
    const six_link_real M_loaded_forearm_35 = c->links[2].S_0_x + t165;
    const six_link_real M_loaded_forearm_44 = c->links[2].m + Lambda_wrist_roll_16;
    const six_link_real M_loaded_forearm_55 = c->links[2].m + Lambda_wrist_roll_19;
    const six_link_real M_loaded_forearm_66 = c->links[2].m + Lambda_wrist_roll_21;
    const six_link_real h_loaded_forearm_1 = h_V_forearm_1
        + (p_T_forearm_1 + (r_T_forearm_y * p_T_forearm_6 - r_T_forearm_z * p_T_forearm_5));
    const six_link_real h_loaded_forearm_2 = h_V_forearm_2
        + (p_T_forearm_2 + (r_T_forearm_z * p_T_forearm_4 - c->links[2].length * p_T_forearm_6));
    const six_link_real h_loaded_forearm_3 = h_V_forearm_3
        + (p_T_forearm_3 + (c->links[2].length * p_T_forearm_5 - r_T_forearm_y * p_T_forearm_4));
    const six_link_real h_loaded_forearm_4 = h_V_forearm_4 + p_T_forearm_4;
    const six_link_real h_loaded_forearm_5 = h_V_forearm_5 + p_T_forearm_5;
    const six_link_real h_loaded_forearm_6 = h_V_forearm_6 + p_T_forearm_6;
    const six_link_real t172 = Lambda_wrist_roll_1 * Theta_forearm_11 + Lambda_wrist_roll_2 * Theta_forearm_21
        + Lambda_wrist_roll_3 * Theta_forearm_31;
    const six_link_real t173 = t172 + Lambda_wrist_roll_5 * REAL(2.23606797749979);
    const six_link_real t174 = Lambda_wrist_roll_2 * Theta_forearm_22
        - Lambda_wrist_roll_1 * minus_Theta_forearm_12 + Lambda_wrist_roll_3 * Theta_forearm_32;
    const six_link_real t175 = t174 + Lambda_wrist_roll_6 * REAL(2.23606797749979);
    const six_link_real t176 = Lambda_wrist_roll_2 * Theta_forearm_11 + Lambda_wrist_roll_7 * Theta_forearm_21
        + Lambda_wrist_roll_8 * Theta_forearm_31;
    const six_link_real t177 = t176 + Lambda_wrist_roll_10 * REAL(2.23606797749979);
    const six_link_real t178 = Lambda_wrist_roll_7 * Theta_forearm_22
        - Lambda_wrist_roll_2 * minus_Theta_forearm_12 + Lambda_wrist_roll_8 * Theta_forearm_32;
    const six_link_real t179 = t178 + Lambda_wrist_roll_11 * REAL(2.23606797749979);
    const six_link_real t180 = Lambda_wrist_roll_3 * Theta_forearm_11 + Lambda_wrist_roll_8 * Theta_forearm_21
        + Lambda_wrist_roll_12 * Theta_forearm_31;
    const six_link_real t181 = t180 + Lambda_wrist_roll_14 * REAL(2.23606797749979);
    const six_link_real t182 = Lambda_wrist_roll_8 * Theta_forearm_22
        - Lambda_wrist_roll_3 * minus_Theta_forearm_12 + Lambda_wrist_roll_12 * Theta_forearm_32;
    const six_link_real t183 = t182 + Lambda_wrist_roll_15 * REAL(2.23606797749979);
    const six_link_real t184 = Lambda_wrist_roll_4 * Theta_forearm_11 + Lambda_wrist_roll_9 * Theta_forearm_21
        + Lambda_wrist_roll_13 * Theta_forearm_31;
    const six_link_real C_forearm_41 = t184 + Lambda_wrist_roll_17 * REAL(2.23606797749979);
    const six_link_real t185 = Lambda_wrist_roll_9 * Theta_forearm_22
        - Lambda_wrist_roll_4 * minus_Theta_forearm_12 + Lambda_wrist_roll_13 * Theta_forearm_32;
    const six_link_real C_forearm_42 = t185 + Lambda_wrist_roll_18 * REAL(2.23606797749979);
    const six_link_real t186 = Lambda_wrist_roll_5 * Theta_forearm_11 + Lambda_wrist_roll_10 * Theta_forearm_21
        + Lambda_wrist_roll_14 * Theta_forearm_31;
    const six_link_real t187 = t186 + Lambda_wrist_roll_19 * REAL(2.23606797749979);
    const six_link_real t188 = Lambda_wrist_roll_10 * Theta_forearm_22
        - Lambda_wrist_roll_5 * minus_Theta_forearm_12 + Lambda_wrist_roll_14 * Theta_forearm_32;
    const six_link_real t189 = Lambda_wrist_roll_20 * REAL(2.23606797749979);
    const six_link_real C_forearm_52 = t188 + t189;
    const six_link_real t190 = Lambda_wrist_roll_6 * Theta_forearm_11 + Lambda_wrist_roll_11 * Theta_forearm_21
        + Lambda_wrist_roll_15 * Theta_forearm_31;
    const six_link_real C_forearm_61 = t190 + t189;
    const six_link_real t191 = Lambda_wrist_roll_11 * Theta_forearm_22
        - Lambda_wrist_roll_6 * minus_Theta_forearm_12 + Lambda_wrist_roll_15 * Theta_forearm_32;
    const six_link_real t192 = t191 + Lambda_wrist_roll_21 * REAL(2.23606797749979);
    const six_link_real C_forearm_21 = t177 + (r_T_forearm_z * C_forearm_41 - c->links[2].length * C_forearm_61);
    const six_link_real C_forearm_32 = t183 + (c->links[2].length * C_forearm_52 - r_T_forearm_y * C_forearm_42);
    const six_link_real C_forearm_11 = t173 + (r_T_forearm_y * C_forearm_61 - r_T_forearm_z * t187)
        - L_forearm_z1;
    const six_link_real C_forearm_12 = L_forearm_y1
        + (t175 + (r_T_forearm_y * t192 - r_T_forearm_z * C_forearm_52));
    const six_link_real C_forearm_22 = t179 + (r_T_forearm_z * C_forearm_42 - c->links[2].length * t192)
        - c->links[2].chi_1;
    const six_link_real C_forearm_31 = c->links[2].chi_1
        + (t181 + (c->links[2].length * t187 - r_T_forearm_y * C_forearm_41));
    const six_link_real C_forearm_51 = c->links[2].sigma_y1 + t187;
    const six_link_real C_forearm_62 = c->links[2].sigma_y1 + t192;
    const six_link_real t193 = Theta_forearm_11 * t173 + Theta_forearm_21 * t177 + Theta_forearm_31 * t181
        + t187 * REAL(2.23606797749979);
    const six_link_real modal_inertia_forearm_11 = t193 + m_eta[3];
    bad |= (unsigned long)(!(modal_inertia_forearm_11 > 0)) << 2;
    const six_link_real modal_inertia_forearm_12 = Theta_forearm_11 * t175 + Theta_forearm_21 * t179
        + Theta_forearm_31 * t183 + C_forearm_52 * REAL(2.23606797749979);
    const six_link_real t194 = Theta_forearm_22 * t179 - minus_Theta_forearm_12 * t175 + Theta_forearm_32 * t183
        + t192 * REAL(2.23606797749979);
    const six_link_real modal_inertia_forearm_22 = t194 + m_eta[4];
    const six_link_real t195 = Theta_forearm_11 * p_T_forearm_1 + Theta_forearm_21 * p_T_forearm_2
        + Theta_forearm_31 * p_T_forearm_3;
    const six_link_real t196 = Theta_forearm_22 * p_T_forearm_2 - minus_Theta_forearm_12 * p_T_forearm_1
        + Theta_forearm_32 * p_T_forearm_3;
    const six_link_real h_phi_forearm_1 = h_eta_forearm_1 + work->f_eta[3]
        + (t195 + p_T_forearm_5 * REAL(2.23606797749979));
    const six_link_real h_phi_forearm_2 = h_eta_forearm_2 + work->f_eta[4]
        + (t196 + p_T_forearm_6 * REAL(2.23606797749979));
    const six_link_real modes_inverse_forearm_1 = 1 / modal_inertia_forearm_11;
    const six_link_real modes_L_forearm_21 = modal_inertia_forearm_12 * modes_inverse_forearm_1;
    const six_link_real t197 = modal_inertia_forearm_22 - modal_inertia_forearm_12 * modes_L_forearm_21;
    bad |= (unsigned long)(!(t197 > 0)) << 2;
    const six_link_real modes_inverse_forearm_2 = 1 / t197;
    const six_link_real t198 = C_forearm_12 - modes_L_forearm_21 * C_forearm_11;
    const six_link_real t199 = C_forearm_22 - modes_L_forearm_21 * C_forearm_21;
    const six_link_real t200 = C_forearm_32 - modes_L_forearm_21 * C_forearm_31;
    const six_link_real t201 = C_forearm_42 - modes_L_forearm_21 * C_forearm_41;
    const six_link_real t202 = C_forearm_52 - modes_L_forearm_21 * C_forearm_51;
    const six_link_real t203 = C_forearm_62 - modes_L_forearm_21 * C_forearm_61;
    const six_link_real t204 = h_phi_forearm_2 - modes_L_forearm_21 * h_phi_forearm_1;
    const six_link_real modes_W_forearm_11 = C_forearm_11 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_12 = C_forearm_21 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_13 = C_forearm_31 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_14 = C_forearm_41 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_15 = C_forearm_51 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_16 = C_forearm_61 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_21 = t198 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_22 = t199 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_23 = t200 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_24 = t201 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_25 = t202 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_26 = t203 * modes_inverse_forearm_2;
    const six_link_real modes_w_forearm_1 = h_phi_forearm_1 * modes_inverse_forearm_1;
    const six_link_real modes_w_forearm_2 = t204 * modes_inverse_forearm_2;
    const six_link_real M_i_forearm_11 = M_loaded_forearm_11
        - (C_forearm_11 * modes_W_forearm_11 + t198 * modes_W_forearm_21);
    const six_link_real M_i_forearm_12 = M_loaded_forearm_12
        - (C_forearm_11 * modes_W_forearm_12 + t198 * modes_W_forearm_22);
    const six_link_real M_i_forearm_13 = M_loaded_forearm_13
        - (C_forearm_11 * modes_W_forearm_13 + t198 * modes_W_forearm_23);
    const six_link_real M_i_forearm_14 = M_loaded_forearm_14
        - (C_forearm_11 * modes_W_forearm_14 + t198 * modes_W_forearm_24);
    const six_link_real M_i_forearm_15 = M_loaded_forearm_15
        - (C_forearm_11 * modes_W_forearm_15 + t198 * modes_W_forearm_25);
    const six_link_real M_i_forearm_16 = M_loaded_forearm_16
        - (C_forearm_11 * modes_W_forearm_16 + t198 * modes_W_forearm_26);
    const six_link_real M_i_forearm_22 = M_loaded_forearm_22
        - (C_forearm_21 * modes_W_forearm_12 + t199 * modes_W_forearm_22);
    const six_link_real M_i_forearm_23 = M_loaded_forearm_23
        - (C_forearm_21 * modes_W_forearm_13 + t199 * modes_W_forearm_23);
    const six_link_real M_i_forearm_24 = M_loaded_forearm_24
        - (C_forearm_21 * modes_W_forearm_14 + t199 * modes_W_forearm_24);
    const six_link_real M_i_forearm_25 = M_loaded_forearm_25
        - (C_forearm_21 * modes_W_forearm_15 + t199 * modes_W_forearm_25);
    const six_link_real M_i_forearm_26 = M_loaded_forearm_26
        - (C_forearm_21 * modes_W_forearm_16 + t199 * modes_W_forearm_26);
    const six_link_real M_i_forearm_33 = M_loaded_forearm_33
        - (C_forearm_31 * modes_W_forearm_13 + t200 * modes_W_forearm_23);
    const six_link_real M_i_forearm_34 = M_loaded_forearm_34
        - (C_forearm_31 * modes_W_forearm_14 + t200 * modes_W_forearm_24);
    const six_link_real M_i_forearm_35 = M_loaded_forearm_35
        - (C_forearm_31 * modes_W_forearm_15 + t200 * modes_W_forearm_25);
    const six_link_real M_i_forearm_36 = M_loaded_forearm_36
        - (C_forearm_31 * modes_W_forearm_16 + t200 * modes_W_forearm_26);
    const six_link_real M_i_forearm_44 = M_loaded_forearm_44
        - (C_forearm_41 * modes_W_forearm_14 + t201 * modes_W_forearm_24);
    const six_link_real M_i_forearm_45 = Lambda_wrist_roll_17
        - (C_forearm_41 * modes_W_forearm_15 + t201 * modes_W_forearm_25);
    const six_link_real M_i_forearm_46 = Lambda_wrist_roll_18
        - (C_forearm_41 * modes_W_forearm_16 + t201 * modes_W_forearm_26);
    const six_link_real M_i_forearm_55 = M_loaded_forearm_55
        - (C_forearm_51 * modes_W_forearm_15 + t202 * modes_W_forearm_25);
    const six_link_real M_i_forearm_56 = Lambda_wrist_roll_20
        - (C_forearm_51 * modes_W_forearm_16 + t202 * modes_W_forearm_26);
    const six_link_real M_i_forearm_66 = M_loaded_forearm_66
        - (C_forearm_61 * modes_W_forearm_16 + t203 * modes_W_forearm_26);
    const six_link_real h_i_forearm_1 = h_loaded_forearm_1
        - (modes_W_forearm_11 * h_phi_forearm_1 + modes_W_forearm_21 * t204);
    const six_link_real h_i_forearm_2 = h_loaded_forearm_2
        - (modes_W_forearm_12 * h_phi_forearm_1 + modes_W_forearm_22 * t204);
    const six_link_real h_i_forearm_3 = h_loaded_forearm_3
        - (modes_W_forearm_13 * h_phi_forearm_1 + modes_W_forearm_23 * t204);
    const six_link_real h_i_forearm_4 = h_loaded_forearm_4
        - (modes_W_forearm_14 * h_phi_forearm_1 + modes_W_forearm_24 * t204);
    const six_link_real h_i_forearm_5 = h_loaded_forearm_5
        - (modes_W_forearm_15 * h_phi_forearm_1 + modes_W_forearm_25 * t204);
    const six_link_real h_i_forearm_6 = h_loaded_forearm_6
        - (modes_W_forearm_16 * h_phi_forearm_1 + modes_W_forearm_26 * t204);

    /* forearm, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_forearm_11 = M_i_forearm_22 + c->links[2].armature_1;
    bad |= (unsigned long)(!(joint_inertia_forearm_11 - t79 * (M_i_forearm_11 + M_i_forearm_22 + M_i_forearm_33) > 0)) << 2;
    const six_link_real joint_inverse_forearm_1 = 1 / joint_inertia_forearm_11;
    const six_link_real joint_W_forearm_11 = M_i_forearm_12 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_12 = M_i_forearm_22 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_13 = M_i_forearm_23 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_14 = M_i_forearm_24 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_15 = M_i_forearm_25 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_16 = M_i_forearm_26 * joint_inverse_forearm_1;
    const six_link_real joint_w_forearm_1 = (input->tau[2] - c->links[2].joint_damping_1 * state->v[2]
        - h_i_forearm_2) * joint_inverse_forearm_1;
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
    const six_link_real p_i_forearm_1 = h_i_forearm_1 + M_i_forearm_12 * joint_w_forearm_1;
    const six_link_real p_i_forearm_2 = h_i_forearm_2 + M_i_forearm_22 * joint_w_forearm_1;
    const six_link_real p_i_forearm_3 = h_i_forearm_3 + M_i_forearm_23 * joint_w_forearm_1;
    const six_link_real p_i_forearm_4 = h_i_forearm_4 + M_i_forearm_24 * joint_w_forearm_1;
    const six_link_real p_i_forearm_5 = h_i_forearm_5 + M_i_forearm_25 * joint_w_forearm_1;
    const six_link_real p_i_forearm_6 = h_i_forearm_6 + M_i_forearm_26 * joint_w_forearm_1;

    /* forearm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t205 = lever_forearm_3 * Lambda_i_forearm_45;
    const six_link_real t206 = lever_forearm_2 * Lambda_i_forearm_46;
    const six_link_real t207 = lever_forearm_1 * Lambda_i_forearm_56;
    const six_link_real t208 = Lambda_i_forearm_14 + (t206 - t205);
    const six_link_real t209 = Lambda_i_forearm_15
        + (lever_forearm_2 * Lambda_i_forearm_56 - lever_forearm_3 * Lambda_i_forearm_55);
    const six_link_real t210 = Lambda_i_forearm_16
        + (lever_forearm_2 * Lambda_i_forearm_66 - lever_forearm_3 * Lambda_i_forearm_56);
    const six_link_real t211 = Lambda_i_forearm_24
        + (lever_forearm_3 * Lambda_i_forearm_44 - lever_forearm_1 * Lambda_i_forearm_46);
    const six_link_real t212 = Lambda_i_forearm_25 + (t205 - t207);
    const six_link_real t213 = Lambda_i_forearm_26
        + (lever_forearm_3 * Lambda_i_forearm_46 - lever_forearm_1 * Lambda_i_forearm_66);
    const six_link_real t214 = Lambda_i_forearm_34
        + (lever_forearm_1 * Lambda_i_forearm_45 - lever_forearm_2 * Lambda_i_forearm_44);
    const six_link_real t215 = Lambda_i_forearm_35
        + (lever_forearm_1 * Lambda_i_forearm_55 - lever_forearm_2 * Lambda_i_forearm_45);
    const six_link_real t216 = Lambda_i_forearm_36 + (t207 - t206);
    const six_link_real t217 = Lambda_i_forearm_11
        - (Lambda_i_forearm_15 * lever_forearm_3 - Lambda_i_forearm_16 * lever_forearm_2);
    const six_link_real t218 = Lambda_i_forearm_12
        - (Lambda_i_forearm_16 * lever_forearm_1 - Lambda_i_forearm_14 * lever_forearm_3);
    const six_link_real t219 = t218 + (lever_forearm_2 * t213 - lever_forearm_3 * t212);
    const six_link_real t220 = Lambda_i_forearm_13
        - (Lambda_i_forearm_14 * lever_forearm_2 - Lambda_i_forearm_15 * lever_forearm_1);
    const six_link_real t221 = t220 + (lever_forearm_2 * t216 - lever_forearm_3 * t215);
    const six_link_real t222 = Lambda_i_forearm_22
        - (Lambda_i_forearm_26 * lever_forearm_1 - Lambda_i_forearm_24 * lever_forearm_3);
    const six_link_real t223 = Lambda_i_forearm_23
        - (Lambda_i_forearm_24 * lever_forearm_2 - Lambda_i_forearm_25 * lever_forearm_1);
    const six_link_real t224 = t223 + (lever_forearm_3 * t214 - lever_forearm_1 * t216);
    const six_link_real t225 = Lambda_i_forearm_33
        - (Lambda_i_forearm_34 * lever_forearm_2 - Lambda_i_forearm_35 * lever_forearm_1);
    const six_link_real t226 = t225 + (lever_forearm_1 * t215 - lever_forearm_2 * t214);
    const six_link_real t227 = (t217 + (lever_forearm_2 * t210 - lever_forearm_3 * t209) - t226) * REAL(0.5);
    const six_link_real t228 = t227 * R_P_forearm_11 + t219 * R_P_forearm_12 + t221 * R_P_forearm_13;
    const six_link_real t229 = t227 * R_P_forearm_21 + t219 * R_P_forearm_22 + t221 * R_P_forearm_23;
    const six_link_real t230 = t227 * R_P_forearm_31 + t219 * R_P_forearm_32 + t221 * R_P_forearm_33;
    const six_link_real t231 = (t222 + (lever_forearm_3 * t211 - lever_forearm_1 * t213) - t226) * REAL(0.5);
    const six_link_real t232 = t231 * R_P_forearm_12 + t224 * R_P_forearm_13;
    const six_link_real t233 = t231 * R_P_forearm_22 + t224 * R_P_forearm_23;
    const six_link_real t234 = t231 * R_P_forearm_32 + t224 * R_P_forearm_33;
    const six_link_real Lambda_forearm_1 = (R_P_forearm_11 * t228 + R_P_forearm_12 * t232) * 2 + t226;
    const six_link_real Lambda_forearm_2 = R_P_forearm_11 * t229 + R_P_forearm_12 * t233
        + (R_P_forearm_21 * t228 + R_P_forearm_22 * t232);
    const six_link_real Lambda_forearm_3 = R_P_forearm_11 * t230 + R_P_forearm_12 * t234
        + (R_P_forearm_31 * t228 + R_P_forearm_32 * t232);
    const six_link_real Lambda_forearm_7 = (R_P_forearm_21 * t229 + R_P_forearm_22 * t233) * 2 + t226;
    const six_link_real Lambda_forearm_8 = R_P_forearm_21 * t230 + R_P_forearm_22 * t234
        + (R_P_forearm_31 * t229 + R_P_forearm_32 * t233);
    const six_link_real Lambda_forearm_12 = (R_P_forearm_31 * t230 + R_P_forearm_32 * t234) * 2 + t226;
    const six_link_real t235 = t208 * R_P_forearm_11 + t209 * R_P_forearm_12 + t210 * R_P_forearm_13;
    const six_link_real t236 = t208 * R_P_forearm_21 + t209 * R_P_forearm_22 + t210 * R_P_forearm_23;
    const six_link_real t237 = t208 * R_P_forearm_31 + t209 * R_P_forearm_32 + t210 * R_P_forearm_33;
    const six_link_real t238 = t211 * R_P_forearm_11 + t212 * R_P_forearm_12 + t213 * R_P_forearm_13;
    const six_link_real t239 = t211 * R_P_forearm_21 + t212 * R_P_forearm_22 + t213 * R_P_forearm_23;
    const six_link_real t240 = t211 * R_P_forearm_31 + t212 * R_P_forearm_32 + t213 * R_P_forearm_33;
    const six_link_real t241 = t214 * R_P_forearm_11 + t215 * R_P_forearm_12 + t216 * R_P_forearm_13;
    const six_link_real t242 = t214 * R_P_forearm_21 + t215 * R_P_forearm_22 + t216 * R_P_forearm_23;
    const six_link_real t243 = t214 * R_P_forearm_31 + t215 * R_P_forearm_32 + t216 * R_P_forearm_33;
    const six_link_real Lambda_forearm_4 = R_P_forearm_11 * t235 + R_P_forearm_12 * t238 + R_P_forearm_13 * t241;
    const six_link_real Lambda_forearm_5 = R_P_forearm_11 * t236 + R_P_forearm_12 * t239 + R_P_forearm_13 * t242;
    const six_link_real Lambda_forearm_6 = R_P_forearm_11 * t237 + R_P_forearm_12 * t240 + R_P_forearm_13 * t243;
    const six_link_real Lambda_forearm_9 = R_P_forearm_21 * t235 + R_P_forearm_22 * t238 + R_P_forearm_23 * t241;
    const six_link_real Lambda_forearm_10 = R_P_forearm_21 * t236 + R_P_forearm_22 * t239 + R_P_forearm_23 * t242;
    const six_link_real Lambda_forearm_11 = R_P_forearm_21 * t237 + R_P_forearm_22 * t240 + R_P_forearm_23 * t243;
    const six_link_real Lambda_forearm_13 = R_P_forearm_31 * t235 + R_P_forearm_32 * t238 + R_P_forearm_33 * t241;
    const six_link_real Lambda_forearm_14 = R_P_forearm_31 * t236 + R_P_forearm_32 * t239 + R_P_forearm_33 * t242;
    const six_link_real Lambda_forearm_15 = R_P_forearm_31 * t237 + R_P_forearm_32 * t240 + R_P_forearm_33 * t243;
    const six_link_real t244 = (Lambda_i_forearm_44 - Lambda_i_forearm_66) * REAL(0.5);
    const six_link_real t245 = t244 * R_P_forearm_11 + Lambda_i_forearm_45 * R_P_forearm_12
        + Lambda_i_forearm_46 * R_P_forearm_13;
    const six_link_real t246 = t244 * R_P_forearm_21 + Lambda_i_forearm_45 * R_P_forearm_22
        + Lambda_i_forearm_46 * R_P_forearm_23;
    const six_link_real t247 = t244 * R_P_forearm_31 + Lambda_i_forearm_45 * R_P_forearm_32
        + Lambda_i_forearm_46 * R_P_forearm_33;
    const six_link_real t248 = (Lambda_i_forearm_55 - Lambda_i_forearm_66) * REAL(0.5);
    const six_link_real t249 = t248 * R_P_forearm_12 + Lambda_i_forearm_56 * R_P_forearm_13;
    const six_link_real t250 = t248 * R_P_forearm_22 + Lambda_i_forearm_56 * R_P_forearm_23;
    const six_link_real t251 = t248 * R_P_forearm_32 + Lambda_i_forearm_56 * R_P_forearm_33;
    const six_link_real Lambda_forearm_16 = (R_P_forearm_11 * t245 + R_P_forearm_12 * t249) * 2
        + Lambda_i_forearm_66;
    const six_link_real Lambda_forearm_17 = R_P_forearm_11 * t246 + R_P_forearm_12 * t250
        + (R_P_forearm_21 * t245 + R_P_forearm_22 * t249);
    const six_link_real Lambda_forearm_18 = R_P_forearm_11 * t247 + R_P_forearm_12 * t251
        + (R_P_forearm_31 * t245 + R_P_forearm_32 * t249);
    const six_link_real Lambda_forearm_19 = (R_P_forearm_21 * t246 + R_P_forearm_22 * t250) * 2
        + Lambda_i_forearm_66;
    const six_link_real Lambda_forearm_20 = R_P_forearm_21 * t247 + R_P_forearm_22 * t251
        + (R_P_forearm_31 * t246 + R_P_forearm_32 * t250);
    const six_link_real Lambda_forearm_21 = (R_P_forearm_31 * t247 + R_P_forearm_32 * t251) * 2
        + Lambda_i_forearm_66;
    const six_link_real t252 = p_i_forearm_1
        + (lever_forearm_2 * p_i_forearm_6 - lever_forearm_3 * p_i_forearm_5);
    const six_link_real t253 = p_i_forearm_2
        + (lever_forearm_3 * p_i_forearm_4 - lever_forearm_1 * p_i_forearm_6);
    const six_link_real t254 = p_i_forearm_3
        + (lever_forearm_1 * p_i_forearm_5 - lever_forearm_2 * p_i_forearm_4);
    const six_link_real p_forearm_1 = R_P_forearm_11 * t252 + R_P_forearm_12 * t253 + R_P_forearm_13 * t254;
    const six_link_real p_forearm_2 = R_P_forearm_21 * t252 + R_P_forearm_22 * t253 + R_P_forearm_23 * t254;
    const six_link_real p_forearm_3 = R_P_forearm_31 * t252 + R_P_forearm_32 * t253 + R_P_forearm_33 * t254;
    const six_link_real p_forearm_4 = R_P_forearm_11 * p_i_forearm_4 + R_P_forearm_12 * p_i_forearm_5
        + R_P_forearm_13 * p_i_forearm_6;
    const six_link_real p_forearm_5 = R_P_forearm_21 * p_i_forearm_4 + R_P_forearm_22 * p_i_forearm_5
        + R_P_forearm_23 * p_i_forearm_6;
    const six_link_real p_forearm_6 = R_P_forearm_31 * p_i_forearm_4 + R_P_forearm_32 * p_i_forearm_5
        + R_P_forearm_33 * p_i_forearm_6;

    /* upper_arm, S: first moment */
    const six_link_real S_upper_arm_y = state->q[6] * c->links[1].sigma_y1;
    const six_link_real S_upper_arm_z = state->q[7] * c->links[1].sigma_y1;

    /* upper_arm, Sdot: rate of the first moment */
    const six_link_real Sdot_upper_arm_y = state->v[6] * c->links[1].sigma_y1;
    const six_link_real Sdot_upper_arm_z = state->v[7] * c->links[1].sigma_y1;

    /* upper_arm, L: first moment weighted by each mode shape (85) */
    const six_link_real L_upper_arm_y1 = c->links[1].mu * state->q[6];
    const six_link_real L_upper_arm_z1 = state->q[7] * c->links[1].mu;

    /* upper_arm, Ldot: rate of L */
    const six_link_real Ldot_upper_arm_y1 = c->links[1].mu * state->v[6];
    const six_link_real Ldot_upper_arm_z1 = state->v[7] * c->links[1].mu;

    /* upper_arm, J: second moment */
    const six_link_real J_upper_arm_xy = c->links[1].chi_1 * state->q[6];
    const six_link_real J_upper_arm_xz = c->links[1].chi_1 * state->q[7];
    const six_link_real J_upper_arm_yy = L_upper_arm_y1 * state->q[6];
    const six_link_real J_upper_arm_yz = L_upper_arm_z1 * state->q[6];
    const six_link_real J_upper_arm_zz = L_upper_arm_z1 * state->q[7];

    /* upper_arm, I: inertia about the origin, deformed */
    const six_link_real I_upper_arm_xx = c->links[1].I_s + J_upper_arm_yy + J_upper_arm_zz;
    const six_link_real I_upper_arm_yy = c->links[1].J_0_xx + J_upper_arm_zz;
    const six_link_real I_upper_arm_zz = c->links[1].J_0_xx + J_upper_arm_yy;

    /* upper_arm, Omega: acceleration of a place by the link's turning */
    const six_link_real t255 = state->v[1] * state->v[1];
    const six_link_real t256 = omega_R_upper_arm_3 * omega_R_upper_arm_3;
    const six_link_real minus_Omega_upper_arm_xx = t255 + t256;
    const six_link_real minus_Omega_upper_arm_xz = minus_omega_R_upper_arm_1 * omega_R_upper_arm_3;
    const six_link_real minus_Omega_upper_arm_yx = minus_alpha_0_upper_arm_3 + minus_alpha_0_upper_arm_3;
    const six_link_real t257 = minus_omega_R_upper_arm_1 * minus_omega_R_upper_arm_1;
    const six_link_real minus_Omega_upper_arm_yy = t257 + t256;
    const six_link_real Omega_upper_arm_yz = minus_alpha_0_upper_arm_1 + minus_alpha_0_upper_arm_1;
    const six_link_real minus_Omega_upper_arm_zz = t257 + t255;

    /* upper_arm, B: moment of the elastic velocity */
    const six_link_real B_upper_arm_yx = c->links[1].chi_1 * state->v[6];
    const six_link_real B_upper_arm_yy = L_upper_arm_y1 * state->v[6];
    const six_link_real B_upper_arm_yz = L_upper_arm_z1 * state->v[6];
    const six_link_real B_upper_arm_zx = c->links[1].chi_1 * state->v[7];
    const six_link_real B_upper_arm_zy = L_upper_arm_y1 * state->v[7];
    const six_link_real B_upper_arm_zz = L_upper_arm_z1 * state->v[7];

    /* upper_arm, h_c: half of the Coriolis wrench */
    const six_link_real minus_h_c_upper_arm_1 = B_upper_arm_yy * minus_omega_R_upper_arm_1
        + B_upper_arm_zz * minus_omega_R_upper_arm_1;
    const six_link_real h_c_upper_arm_2 = B_upper_arm_zz * state->v[1]
        + B_upper_arm_yx * minus_omega_R_upper_arm_1 - B_upper_arm_yz * omega_R_upper_arm_3;
    const six_link_real h_c_upper_arm_3 = B_upper_arm_yy * omega_R_upper_arm_3
        + B_upper_arm_zx * minus_omega_R_upper_arm_1 - B_upper_arm_zy * state->v[1];
    const six_link_real h_c_upper_arm_4 = Sdot_upper_arm_z * state->v[1] - Sdot_upper_arm_y * omega_R_upper_arm_3;
    const six_link_real minus_minus_h_c_upper_arm_5 = Sdot_upper_arm_z * minus_omega_R_upper_arm_1;
    const six_link_real minus_h_c_upper_arm_6 = Sdot_upper_arm_y * minus_omega_R_upper_arm_1;

    /* upper_arm, h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const six_link_real h_MD_upper_arm_2 = h_c_upper_arm_2
        + state->v[8] * omega_R_upper_arm_3 * c->links[1].sigma_t_3;
    const six_link_real h_MD_upper_arm_3 = h_c_upper_arm_3 - state->v[8] * state->v[1] * c->links[1].sigma_t_3;

    /* upper_arm, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real t258 = minus_h_c_upper_arm_1 + c->links[1].I_s * minus_alpha_0_upper_arm_1
        + J_upper_arm_xy * minus_Omega_upper_arm_xz;
    const six_link_real t259 = J_upper_arm_yz * (minus_Omega_upper_arm_yy - minus_Omega_upper_arm_zz) - t258
        - S_upper_arm_y * minus_alpha_0_upper_arm_6;
    const six_link_real H_star_upper_arm_1 = t259 + J_upper_arm_xz * minus_Omega_upper_arm_yx
        - J_upper_arm_zz * Omega_upper_arm_yz - S_upper_arm_z * alpha_0_upper_arm_5;
    const six_link_real t260 = h_c_upper_arm_2
        + J_upper_arm_xz * (minus_Omega_upper_arm_zz - minus_Omega_upper_arm_xx)
        - J_upper_arm_zz * minus_Omega_upper_arm_xz;
    const six_link_real t261 = c->links[1].I_s * minus_omega_R_upper_arm_1;
    const six_link_real t262 = t260 + S_upper_arm_z * alpha_0_upper_arm_4 - t261 * omega_R_upper_arm_3
        + c->links[1].J_0_xx * minus_Omega_upper_arm_xz;
    const six_link_real H_star_upper_arm_2 = t262 + c->links[1].S_0_x * minus_alpha_0_upper_arm_6;
    const six_link_real t263 = h_c_upper_arm_3 - c->links[1].J_0_xx * minus_Omega_upper_arm_yx
        + J_upper_arm_xy * (minus_Omega_upper_arm_xx - minus_Omega_upper_arm_yy);
    const six_link_real t264 = t263 + J_upper_arm_xz * Omega_upper_arm_yz
        + c->links[1].S_0_x * alpha_0_upper_arm_5 + J_upper_arm_yz * minus_Omega_upper_arm_xz;
    const six_link_real H_star_upper_arm_3 = t264 - S_upper_arm_y * alpha_0_upper_arm_4 + t261 * state->v[1];
    const six_link_real t265 = h_c_upper_arm_4 - minus_Omega_upper_arm_xx * c->links[1].S_0_x
        - minus_Omega_upper_arm_xz * S_upper_arm_z;
    const six_link_real H_star_upper_arm_4 = t265 + alpha_0_upper_arm_4 * c->links[1].mu;
    const six_link_real t266 = minus_minus_h_c_upper_arm_5 - minus_Omega_upper_arm_yx * c->links[1].S_0_x
        - minus_Omega_upper_arm_yy * S_upper_arm_y;
    const six_link_real H_star_upper_arm_5 = t266 + Omega_upper_arm_yz * S_upper_arm_z
        + alpha_0_upper_arm_5 * c->links[1].mu;
    const six_link_real t267 = minus_h_c_upper_arm_6 + minus_Omega_upper_arm_xz * c->links[1].S_0_x
        + minus_Omega_upper_arm_zz * S_upper_arm_z;
    const six_link_real minus_H_star_upper_arm_6 = t267 + minus_alpha_0_upper_arm_6 * c->links[1].mu;

    /* upper_arm, h_V: bias of the twist rows, angular acceleration included */
    const six_link_real h_V_upper_arm_1 = H_star_upper_arm_1 - minus_h_c_upper_arm_1;
    const six_link_real h_V_upper_arm_2 = H_star_upper_arm_2 + h_MD_upper_arm_2;
    const six_link_real h_V_upper_arm_3 = H_star_upper_arm_3 + h_MD_upper_arm_3;
    const six_link_real h_V_upper_arm_4 = H_star_upper_arm_4 + h_c_upper_arm_4;
    const six_link_real h_V_upper_arm_5 = H_star_upper_arm_5 + minus_minus_h_c_upper_arm_5;
    const six_link_real minus_h_V_upper_arm_6 = minus_H_star_upper_arm_6 + minus_h_c_upper_arm_6;

    /* upper_arm, h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const six_link_real t268 = L_upper_arm_z1 * Omega_upper_arm_yz - L_upper_arm_y1 * minus_Omega_upper_arm_yy
        - minus_Omega_upper_arm_yx * c->links[1].chi_1;
    const six_link_real h_eta_upper_arm_1 = t268 + alpha_0_upper_arm_5 * c->links[1].sigma_y1
        + Ldot_upper_arm_z1 * 2 * minus_omega_R_upper_arm_1;
    const six_link_real t269 = L_upper_arm_z1 * minus_Omega_upper_arm_zz
        + minus_Omega_upper_arm_xz * c->links[1].chi_1 + minus_alpha_0_upper_arm_6 * c->links[1].sigma_y1;
    const six_link_real minus_h_eta_upper_arm_2 = t269 + Ldot_upper_arm_y1 * 2 * minus_omega_R_upper_arm_1;
    const six_link_real minus_h_eta_upper_arm_3 = minus_alpha_0_upper_arm_1 * c->links[1].sigma_t_3;

    /* upper_arm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t270 = R_T_upper_arm_xx * c->links[1].S_T_x + R_T_upper_arm_xy * c->links[1].S_T_y
        + R_T_upper_arm_xz * c->links[1].S_T_z;
    const six_link_real t271 = R_T_upper_arm_yx * c->links[1].S_T_x + R_T_upper_arm_yy * c->links[1].S_T_y
        + R_T_upper_arm_yz * c->links[1].S_T_z;
    const six_link_real t272 = R_T_upper_arm_zx * c->links[1].S_T_x + R_T_upper_arm_zy * c->links[1].S_T_y
        + R_T_upper_arm_zz * c->links[1].S_T_z;
    const six_link_real t273 = c->links[1].I_T_xx * R_T_upper_arm_xx - c->links[1].J_T_xy * R_T_upper_arm_xy
        - c->links[1].J_T_xz * R_T_upper_arm_xz;
    const six_link_real t274 = c->links[1].I_T_xx * R_T_upper_arm_yx - c->links[1].J_T_xy * R_T_upper_arm_yy
        - c->links[1].J_T_xz * R_T_upper_arm_yz;
    const six_link_real t275 = c->links[1].I_T_xx * R_T_upper_arm_zx - c->links[1].J_T_xy * R_T_upper_arm_zy
        - c->links[1].J_T_xz * R_T_upper_arm_zz;
    const six_link_real t276 = c->links[1].I_T_yy * R_T_upper_arm_xy - c->links[1].J_T_xy * R_T_upper_arm_xx
        - c->links[1].J_T_yz * R_T_upper_arm_xz;
    const six_link_real t277 = c->links[1].I_T_yy * R_T_upper_arm_yy - c->links[1].J_T_xy * R_T_upper_arm_yx
        - c->links[1].J_T_yz * R_T_upper_arm_yz;
    const six_link_real t278 = c->links[1].I_T_yy * R_T_upper_arm_zy - c->links[1].J_T_xy * R_T_upper_arm_zx
        - c->links[1].J_T_yz * R_T_upper_arm_zz;
    const six_link_real t279 = c->links[1].I_T_zz * R_T_upper_arm_xz
        - (c->links[1].J_T_xz * R_T_upper_arm_xx + c->links[1].J_T_yz * R_T_upper_arm_xy);
    const six_link_real t280 = c->links[1].I_T_zz * R_T_upper_arm_yz
        - (c->links[1].J_T_xz * R_T_upper_arm_yx + c->links[1].J_T_yz * R_T_upper_arm_yy);
    const six_link_real t281 = c->links[1].I_T_zz * R_T_upper_arm_zz
        - (c->links[1].J_T_xz * R_T_upper_arm_zx + c->links[1].J_T_yz * R_T_upper_arm_zy);
    const six_link_real t282 = R_T_upper_arm_xx * t273 + R_T_upper_arm_xy * t276 + R_T_upper_arm_xz * t279;
    const six_link_real t283 = R_T_upper_arm_xx * t274 + R_T_upper_arm_xy * t277 + R_T_upper_arm_xz * t280;
    const six_link_real t284 = R_T_upper_arm_xx * t275 + R_T_upper_arm_xy * t278 + R_T_upper_arm_xz * t281;
    const six_link_real t285 = R_T_upper_arm_yx * t274 + R_T_upper_arm_yy * t277 + R_T_upper_arm_yz * t280;
    const six_link_real t286 = R_T_upper_arm_yx * t275 + R_T_upper_arm_yy * t278 + R_T_upper_arm_yz * t281;
    const six_link_real t287 = R_T_upper_arm_zx * t275 + R_T_upper_arm_zy * t278 + R_T_upper_arm_zz * t281;
    const six_link_real Lambda_T_upper_arm_11 = Lambda_forearm_1 + t282;
    const six_link_real Lambda_T_upper_arm_12 = Lambda_forearm_2 + t283;
    const six_link_real Lambda_T_upper_arm_13 = Lambda_forearm_3 + t284;
    const six_link_real Lambda_T_upper_arm_15 = Lambda_forearm_5 - t272;
    const six_link_real Lambda_T_upper_arm_16 = Lambda_forearm_6 + t271;
    const six_link_real Lambda_T_upper_arm_22 = Lambda_forearm_7 + t285;
    const six_link_real Lambda_T_upper_arm_23 = Lambda_forearm_8 + t286;
    const six_link_real Lambda_T_upper_arm_24 = Lambda_forearm_9 + t272;
    const six_link_real Lambda_T_upper_arm_26 = Lambda_forearm_11 - t270;
    const six_link_real Lambda_T_upper_arm_33 = Lambda_forearm_12 + t287;
    const six_link_real Lambda_T_upper_arm_34 = Lambda_forearm_13 - t271;
    const six_link_real Lambda_T_upper_arm_35 = Lambda_forearm_14 + t270;
    const six_link_real Lambda_T_upper_arm_44 = Lambda_forearm_16 + c->links[1].body0_mass;
    const six_link_real Lambda_T_upper_arm_55 = Lambda_forearm_19 + c->links[1].body0_mass;
    const six_link_real Lambda_T_upper_arm_66 = Lambda_forearm_21 + c->links[1].body0_mass;
    const six_link_real t288 = R_T_upper_arm_xx * input->w_ext[1][0] + R_T_upper_arm_xy * input->w_ext[1][1]
        + R_T_upper_arm_xz * input->w_ext[1][2];
    const six_link_real t289 = R_T_upper_arm_yx * input->w_ext[1][0] + R_T_upper_arm_yy * input->w_ext[1][1]
        + R_T_upper_arm_yz * input->w_ext[1][2];
    const six_link_real t290 = R_T_upper_arm_zx * input->w_ext[1][0] + R_T_upper_arm_zy * input->w_ext[1][1]
        + R_T_upper_arm_zz * input->w_ext[1][2];
    const six_link_real t291 = R_T_upper_arm_xx * input->w_ext[1][3] + R_T_upper_arm_xy * input->w_ext[1][4]
        + R_T_upper_arm_xz * input->w_ext[1][5];
    const six_link_real t292 = R_T_upper_arm_yx * input->w_ext[1][3] + R_T_upper_arm_yy * input->w_ext[1][4]
        + R_T_upper_arm_yz * input->w_ext[1][5];
    const six_link_real t293 = R_T_upper_arm_zx * input->w_ext[1][3] + R_T_upper_arm_zy * input->w_ext[1][4]
        + R_T_upper_arm_zz * input->w_ext[1][5];
    const six_link_real t294 = t282 * alpha_0_T_upper_arm_1 + t283 * alpha_0_T_upper_arm_2
        + t284 * alpha_0_T_upper_arm_3 - (t271 * minus_alpha_0_T_upper_arm_6 + t272 * alpha_0_T_upper_arm_5);
    const six_link_real t295 = t272 * alpha_0_T_upper_arm_4 + t270 * minus_alpha_0_T_upper_arm_6
        + (t283 * alpha_0_T_upper_arm_1 + t285 * alpha_0_T_upper_arm_2 + t286 * alpha_0_T_upper_arm_3);
    const six_link_real t296 = t270 * alpha_0_T_upper_arm_5 - t271 * alpha_0_T_upper_arm_4
        + (t284 * alpha_0_T_upper_arm_1 + t286 * alpha_0_T_upper_arm_2 + t287 * alpha_0_T_upper_arm_3);
    const six_link_real t297 = t282 * omega_T_upper_arm_1 + t283 * omega_T_upper_arm_2
        + t284 * omega_T_upper_arm_3;
    const six_link_real t298 = t283 * omega_T_upper_arm_1 + t285 * omega_T_upper_arm_2
        + t286 * omega_T_upper_arm_3;
    const six_link_real t299 = t284 * omega_T_upper_arm_1 + t286 * omega_T_upper_arm_2
        + t287 * omega_T_upper_arm_3;
    const six_link_real t300 = omega_T_upper_arm_2 * t272 - omega_T_upper_arm_3 * t271;
    const six_link_real t301 = omega_T_upper_arm_3 * t270 - omega_T_upper_arm_1 * t272;
    const six_link_real t302 = omega_T_upper_arm_1 * t271 - omega_T_upper_arm_2 * t270;
    const six_link_real t303 = alpha_0_T_upper_arm_2 * t272 - alpha_0_T_upper_arm_3 * t271
        + (omega_T_upper_arm_2 * t302 - omega_T_upper_arm_3 * t301);
    const six_link_real t304 = alpha_0_T_upper_arm_3 * t270 - alpha_0_T_upper_arm_1 * t272
        + (omega_T_upper_arm_3 * t300 - omega_T_upper_arm_1 * t302);
    const six_link_real t305 = alpha_0_T_upper_arm_1 * t271 - alpha_0_T_upper_arm_2 * t270
        + (omega_T_upper_arm_1 * t301 - omega_T_upper_arm_2 * t300);
    const six_link_real p_T_upper_arm_1 = p_forearm_1
        + (t294 + (omega_T_upper_arm_2 * t299 - omega_T_upper_arm_3 * t298)) - t288;
    const six_link_real p_T_upper_arm_2 = p_forearm_2
        + (t295 + (omega_T_upper_arm_3 * t297 - omega_T_upper_arm_1 * t299)) - t289;
    const six_link_real p_T_upper_arm_3 = p_forearm_3
        + (t296 + (omega_T_upper_arm_1 * t298 - omega_T_upper_arm_2 * t297)) - t290;
    const six_link_real p_T_upper_arm_4 = p_forearm_4 + (c->links[1].body0_mass * alpha_0_T_upper_arm_4 + t303)
        - t291;
    const six_link_real p_T_upper_arm_5 = p_forearm_5 + (c->links[1].body0_mass * alpha_0_T_upper_arm_5 + t304)
        - t292;
    const six_link_real p_T_upper_arm_6 = p_forearm_6
        + (t305 - c->links[1].body0_mass * minus_alpha_0_T_upper_arm_6) - t293;

    /* upper_arm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real Theta_upper_arm_11 = J_l_upper_arm_xz * c->links[1].Psi_c_z1;
    const six_link_real Theta_upper_arm_12 = J_l_upper_arm_xy * c->links[1].Psi_c_y2;
    const six_link_real Theta_upper_arm_13 = J_l_upper_arm_xx * REAL(1.4142135623730951);
    const six_link_real Theta_upper_arm_21 = J_l_upper_arm_yz * c->links[1].Psi_c_z1;
    const six_link_real Theta_upper_arm_22 = J_l_upper_arm_yy * c->links[1].Psi_c_y2;
    const six_link_real Theta_upper_arm_23 = J_l_upper_arm_yx * REAL(1.4142135623730951);
    const six_link_real Theta_upper_arm_31 = J_l_upper_arm_zz * c->links[1].Psi_c_z1;
    const six_link_real Theta_upper_arm_32 = J_l_upper_arm_zy * c->links[1].Psi_c_y2;
    const six_link_real Theta_upper_arm_33 = J_l_upper_arm_zx * REAL(1.4142135623730951);
    const six_link_real t306 = r_T_upper_arm_z * Lambda_forearm_17;
    const six_link_real t307 = r_T_upper_arm_y * Lambda_forearm_18;
    const six_link_real t308 = c->links[1].length * Lambda_forearm_20;
    const six_link_real M_loaded_upper_arm_14 = Lambda_forearm_4 + (t307 - t306);
    const six_link_real t309 = Lambda_T_upper_arm_15
        + (r_T_upper_arm_y * Lambda_forearm_20 - r_T_upper_arm_z * Lambda_T_upper_arm_55);
    const six_link_real t310 = Lambda_T_upper_arm_16
        + (r_T_upper_arm_y * Lambda_T_upper_arm_66 - r_T_upper_arm_z * Lambda_forearm_20);
    const six_link_real t311 = Lambda_T_upper_arm_24
        + (r_T_upper_arm_z * Lambda_T_upper_arm_44 - c->links[1].length * Lambda_forearm_18);
    const six_link_real M_loaded_upper_arm_25 = Lambda_forearm_10 + (t306 - t308);
    const six_link_real t312 = Lambda_T_upper_arm_26
        + (r_T_upper_arm_z * Lambda_forearm_18 - c->links[1].length * Lambda_T_upper_arm_66);
    const six_link_real t313 = Lambda_T_upper_arm_34
        + (c->links[1].length * Lambda_forearm_17 - r_T_upper_arm_y * Lambda_T_upper_arm_44);
    const six_link_real t314 = Lambda_T_upper_arm_35
        + (c->links[1].length * Lambda_T_upper_arm_55 - r_T_upper_arm_y * Lambda_forearm_17);
    const six_link_real M_loaded_upper_arm_36 = Lambda_forearm_15 + (t308 - t307);
    const six_link_real t315 = Lambda_T_upper_arm_11
        - (Lambda_T_upper_arm_15 * r_T_upper_arm_z - Lambda_T_upper_arm_16 * r_T_upper_arm_y);
    const six_link_real t316 = Lambda_T_upper_arm_12
        - (Lambda_T_upper_arm_16 * c->links[1].length - Lambda_forearm_4 * r_T_upper_arm_z);
    const six_link_real t317 = Lambda_T_upper_arm_13
        - (Lambda_forearm_4 * r_T_upper_arm_y - Lambda_T_upper_arm_15 * c->links[1].length);
    const six_link_real t318 = Lambda_T_upper_arm_22
        - (Lambda_T_upper_arm_26 * c->links[1].length - Lambda_T_upper_arm_24 * r_T_upper_arm_z);
    const six_link_real t319 = Lambda_T_upper_arm_23
        - (Lambda_T_upper_arm_24 * r_T_upper_arm_y - Lambda_forearm_10 * c->links[1].length);
    const six_link_real t320 = Lambda_T_upper_arm_33
        - (Lambda_T_upper_arm_34 * r_T_upper_arm_y - Lambda_T_upper_arm_35 * c->links[1].length);
    const six_link_real M_loaded_upper_arm_11 = I_upper_arm_xx
        + (t315 + (r_T_upper_arm_y * t310 - r_T_upper_arm_z * t309));
    const six_link_real M_loaded_upper_arm_12 = t316
        + (r_T_upper_arm_y * t312 - r_T_upper_arm_z * M_loaded_upper_arm_25) - J_upper_arm_xy;
    const six_link_real M_loaded_upper_arm_13 = t317
        + (r_T_upper_arm_y * M_loaded_upper_arm_36 - r_T_upper_arm_z * t314) - J_upper_arm_xz;
    const six_link_real M_loaded_upper_arm_15 = t309 - S_upper_arm_z;
    const six_link_real M_loaded_upper_arm_16 = S_upper_arm_y + t310;
    const six_link_real M_loaded_upper_arm_22 = I_upper_arm_yy
        + (t318 + (r_T_upper_arm_z * t311 - c->links[1].length * t312));
    const six_link_real M_loaded_upper_arm_23 = t319
        + (r_T_upper_arm_z * t313 - c->links[1].length * M_loaded_upper_arm_36) - J_upper_arm_yz;
    const six_link_real M_loaded_upper_arm_24 = S_upper_arm_z + t311;
    const six_link_real M_loaded_upper_arm_26 = t312 - c->links[1].S_0_x;
    const six_link_real M_loaded_upper_arm_33 = I_upper_arm_zz
        + (t320 + (c->links[1].length * t314 - r_T_upper_arm_y * t313));
    const six_link_real M_loaded_upper_arm_34 = t313 - S_upper_arm_y;
    const six_link_real M_loaded_upper_arm_35 = c->links[1].S_0_x + t314;
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
    const six_link_real h_loaded_upper_arm_6 = p_T_upper_arm_6 - minus_h_V_upper_arm_6;
    const six_link_real t321 = Lambda_T_upper_arm_11 * Theta_upper_arm_11
        + Lambda_T_upper_arm_12 * Theta_upper_arm_21 + Lambda_T_upper_arm_13 * Theta_upper_arm_31;
    const six_link_real t322 = t321 + Lambda_T_upper_arm_15 * 2;
    const six_link_real t323 = Lambda_T_upper_arm_11 * Theta_upper_arm_12
        + Lambda_T_upper_arm_12 * Theta_upper_arm_22 + Lambda_T_upper_arm_13 * Theta_upper_arm_32;
    const six_link_real t324 = t323 + Lambda_T_upper_arm_16 * 2;
    const six_link_real t325 = Lambda_T_upper_arm_11 * Theta_upper_arm_13
        + Lambda_T_upper_arm_12 * Theta_upper_arm_23 + Lambda_T_upper_arm_13 * Theta_upper_arm_33;
    const six_link_real t326 = Lambda_T_upper_arm_12 * Theta_upper_arm_11
        + Lambda_T_upper_arm_22 * Theta_upper_arm_21 + Lambda_T_upper_arm_23 * Theta_upper_arm_31;
    const six_link_real t327 = t326 + Lambda_forearm_10 * 2;
    const six_link_real t328 = Lambda_T_upper_arm_12 * Theta_upper_arm_12
        + Lambda_T_upper_arm_22 * Theta_upper_arm_22 + Lambda_T_upper_arm_23 * Theta_upper_arm_32;
    const six_link_real t329 = t328 + Lambda_T_upper_arm_26 * 2;
    const six_link_real t330 = Lambda_T_upper_arm_12 * Theta_upper_arm_13
        + Lambda_T_upper_arm_22 * Theta_upper_arm_23 + Lambda_T_upper_arm_23 * Theta_upper_arm_33;
    const six_link_real t331 = Lambda_T_upper_arm_13 * Theta_upper_arm_11
        + Lambda_T_upper_arm_23 * Theta_upper_arm_21 + Lambda_T_upper_arm_33 * Theta_upper_arm_31;
    const six_link_real t332 = t331 + Lambda_T_upper_arm_35 * 2;
    const six_link_real t333 = Lambda_T_upper_arm_13 * Theta_upper_arm_12
        + Lambda_T_upper_arm_23 * Theta_upper_arm_22 + Lambda_T_upper_arm_33 * Theta_upper_arm_32;
    const six_link_real t334 = t333 + Lambda_forearm_15 * 2;
    const six_link_real t335 = Lambda_T_upper_arm_13 * Theta_upper_arm_13
        + Lambda_T_upper_arm_23 * Theta_upper_arm_23 + Lambda_T_upper_arm_33 * Theta_upper_arm_33;
    const six_link_real t336 = Lambda_forearm_4 * Theta_upper_arm_11 + Lambda_T_upper_arm_24 * Theta_upper_arm_21
        + Lambda_T_upper_arm_34 * Theta_upper_arm_31;
    const six_link_real C_upper_arm_41 = t336 + Lambda_forearm_17 * 2;
    const six_link_real t337 = Lambda_forearm_4 * Theta_upper_arm_12 + Lambda_T_upper_arm_24 * Theta_upper_arm_22
        + Lambda_T_upper_arm_34 * Theta_upper_arm_32;
    const six_link_real C_upper_arm_42 = t337 + Lambda_forearm_18 * 2;
    const six_link_real C_upper_arm_43 = Lambda_forearm_4 * Theta_upper_arm_13
        + Lambda_T_upper_arm_24 * Theta_upper_arm_23 + Lambda_T_upper_arm_34 * Theta_upper_arm_33;
    const six_link_real t338 = Lambda_T_upper_arm_15 * Theta_upper_arm_11
        + Lambda_forearm_10 * Theta_upper_arm_21 + Lambda_T_upper_arm_35 * Theta_upper_arm_31;
    const six_link_real t339 = t338 + Lambda_T_upper_arm_55 * 2;
    const six_link_real t340 = Lambda_T_upper_arm_15 * Theta_upper_arm_12
        + Lambda_forearm_10 * Theta_upper_arm_22 + Lambda_T_upper_arm_35 * Theta_upper_arm_32;
    const six_link_real t341 = Lambda_forearm_20 * 2;
    const six_link_real C_upper_arm_52 = t340 + t341;
    const six_link_real C_upper_arm_53 = Lambda_T_upper_arm_15 * Theta_upper_arm_13
        + Lambda_forearm_10 * Theta_upper_arm_23 + Lambda_T_upper_arm_35 * Theta_upper_arm_33;
    const six_link_real t342 = Lambda_T_upper_arm_16 * Theta_upper_arm_11
        + Lambda_T_upper_arm_26 * Theta_upper_arm_21 + Lambda_forearm_15 * Theta_upper_arm_31;
    const six_link_real C_upper_arm_61 = t342 + t341;
    const six_link_real t343 = Lambda_T_upper_arm_16 * Theta_upper_arm_12
        + Lambda_T_upper_arm_26 * Theta_upper_arm_22 + Lambda_forearm_15 * Theta_upper_arm_32;
    const six_link_real t344 = t343 + Lambda_T_upper_arm_66 * 2;
    const six_link_real C_upper_arm_63 = Lambda_T_upper_arm_16 * Theta_upper_arm_13
        + Lambda_T_upper_arm_26 * Theta_upper_arm_23 + Lambda_forearm_15 * Theta_upper_arm_33;
    const six_link_real C_upper_arm_21 = t327
        + (r_T_upper_arm_z * C_upper_arm_41 - c->links[1].length * C_upper_arm_61);
    const six_link_real C_upper_arm_32 = t334
        + (c->links[1].length * C_upper_arm_52 - r_T_upper_arm_y * C_upper_arm_42);
    const six_link_real C_upper_arm_23 = t330
        + (r_T_upper_arm_z * C_upper_arm_43 - c->links[1].length * C_upper_arm_63);
    const six_link_real C_upper_arm_33 = t335
        + (c->links[1].length * C_upper_arm_53 - r_T_upper_arm_y * C_upper_arm_43);
    const six_link_real C_upper_arm_11 = t322 + (r_T_upper_arm_y * C_upper_arm_61 - r_T_upper_arm_z * t339)
        - L_upper_arm_z1;
    const six_link_real C_upper_arm_12 = L_upper_arm_y1
        + (t324 + (r_T_upper_arm_y * t344 - r_T_upper_arm_z * C_upper_arm_52));
    const six_link_real C_upper_arm_13 = c->links[1].sigma_t_3
        + (t325 + (r_T_upper_arm_y * C_upper_arm_63 - r_T_upper_arm_z * C_upper_arm_53));
    const six_link_real C_upper_arm_22 = t329 + (r_T_upper_arm_z * C_upper_arm_42 - c->links[1].length * t344)
        - c->links[1].chi_1;
    const six_link_real C_upper_arm_31 = c->links[1].chi_1
        + (t332 + (c->links[1].length * t339 - r_T_upper_arm_y * C_upper_arm_41));
    const six_link_real C_upper_arm_51 = c->links[1].sigma_y1 + t339;
    const six_link_real C_upper_arm_62 = c->links[1].sigma_y1 + t344;
    const six_link_real modal_inertia_upper_arm_11 = Theta_upper_arm_11 * t322 + Theta_upper_arm_21 * t327
        + Theta_upper_arm_31 * t332 + t339 * 2 + m_eta[0];
    bad |= (unsigned long)(!(modal_inertia_upper_arm_11 > 0)) << 1;
    const six_link_real modal_inertia_upper_arm_12 = Theta_upper_arm_11 * t324 + Theta_upper_arm_21 * t329
        + Theta_upper_arm_31 * t334 + C_upper_arm_52 * 2;
    const six_link_real modal_inertia_upper_arm_13 = Theta_upper_arm_11 * t325 + Theta_upper_arm_21 * t330
        + Theta_upper_arm_31 * t335 + C_upper_arm_53 * 2;
    const six_link_real modal_inertia_upper_arm_22 = Theta_upper_arm_12 * t324 + Theta_upper_arm_22 * t329
        + Theta_upper_arm_32 * t334 + t344 * 2 + m_eta[1];
    const six_link_real modal_inertia_upper_arm_23 = Theta_upper_arm_12 * t325 + Theta_upper_arm_22 * t330
        + Theta_upper_arm_32 * t335 + C_upper_arm_63 * 2;
    const six_link_real modal_inertia_upper_arm_33 = Theta_upper_arm_13 * t325 + Theta_upper_arm_23 * t330
        + Theta_upper_arm_33 * t335 + m_eta[2];
    const six_link_real t345 = Theta_upper_arm_11 * p_T_upper_arm_1 + Theta_upper_arm_21 * p_T_upper_arm_2
        + Theta_upper_arm_31 * p_T_upper_arm_3;
    const six_link_real t346 = Theta_upper_arm_12 * p_T_upper_arm_1 + Theta_upper_arm_22 * p_T_upper_arm_2
        + Theta_upper_arm_32 * p_T_upper_arm_3;
    const six_link_real t347 = Theta_upper_arm_13 * p_T_upper_arm_1 + Theta_upper_arm_23 * p_T_upper_arm_2
        + Theta_upper_arm_33 * p_T_upper_arm_3;
    const six_link_real h_phi_upper_arm_1 = h_eta_upper_arm_1 + work->f_eta[0] + (t345 + p_T_upper_arm_5 * 2);
    const six_link_real h_phi_upper_arm_2 = work->f_eta[1] - minus_h_eta_upper_arm_2
        + (t346 + p_T_upper_arm_6 * 2);
    const six_link_real h_phi_upper_arm_3 = work->f_eta[2] - minus_h_eta_upper_arm_3 + t347;
    const six_link_real modes_inverse_upper_arm_1 = 1 / modal_inertia_upper_arm_11;
    const six_link_real modes_L_upper_arm_21 = modal_inertia_upper_arm_12 * modes_inverse_upper_arm_1;
    const six_link_real modes_L_upper_arm_31 = modal_inertia_upper_arm_13 * modes_inverse_upper_arm_1;
    const six_link_real t348 = modal_inertia_upper_arm_22 - modal_inertia_upper_arm_12 * modes_L_upper_arm_21;
    bad |= (unsigned long)(!(t348 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_2 = 1 / t348;
    const six_link_real t349 = modal_inertia_upper_arm_23 - modal_inertia_upper_arm_12 * modes_L_upper_arm_31;
    const six_link_real modes_L_upper_arm_32 = t349 * modes_inverse_upper_arm_2;
    const six_link_real t350 = modal_inertia_upper_arm_33
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_31 + t349 * modes_L_upper_arm_32);
    bad |= (unsigned long)(!(t350 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_3 = 1 / t350;
    const six_link_real t351 = C_upper_arm_12 - modes_L_upper_arm_21 * C_upper_arm_11;
    const six_link_real t352 = C_upper_arm_22 - modes_L_upper_arm_21 * C_upper_arm_21;
    const six_link_real t353 = C_upper_arm_32 - modes_L_upper_arm_21 * C_upper_arm_31;
    const six_link_real t354 = C_upper_arm_42 - modes_L_upper_arm_21 * C_upper_arm_41;
    const six_link_real t355 = C_upper_arm_52 - modes_L_upper_arm_21 * C_upper_arm_51;
    const six_link_real t356 = C_upper_arm_62 - modes_L_upper_arm_21 * C_upper_arm_61;
    const six_link_real t357 = C_upper_arm_13 - modes_L_upper_arm_31 * C_upper_arm_11
        - modes_L_upper_arm_32 * t351;
    const six_link_real t358 = C_upper_arm_23 - modes_L_upper_arm_31 * C_upper_arm_21
        - modes_L_upper_arm_32 * t352;
    const six_link_real t359 = C_upper_arm_33 - modes_L_upper_arm_31 * C_upper_arm_31
        - modes_L_upper_arm_32 * t353;
    const six_link_real t360 = C_upper_arm_43 - modes_L_upper_arm_31 * C_upper_arm_41
        - modes_L_upper_arm_32 * t354;
    const six_link_real t361 = C_upper_arm_53 - modes_L_upper_arm_31 * C_upper_arm_51
        - modes_L_upper_arm_32 * t355;
    const six_link_real t362 = C_upper_arm_63 - modes_L_upper_arm_31 * C_upper_arm_61
        - modes_L_upper_arm_32 * t356;
    const six_link_real t363 = h_phi_upper_arm_2 - modes_L_upper_arm_21 * h_phi_upper_arm_1;
    const six_link_real t364 = h_phi_upper_arm_3 - modes_L_upper_arm_31 * h_phi_upper_arm_1
        - modes_L_upper_arm_32 * t363;
    const six_link_real modes_W_upper_arm_11 = C_upper_arm_11 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_12 = C_upper_arm_21 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_13 = C_upper_arm_31 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_14 = C_upper_arm_41 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_15 = C_upper_arm_51 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_16 = C_upper_arm_61 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_21 = t351 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_22 = t352 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_23 = t353 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_24 = t354 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_25 = t355 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_26 = t356 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_31 = t357 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_32 = t358 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_33 = t359 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_34 = t360 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_35 = t361 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_36 = t362 * modes_inverse_upper_arm_3;
    const six_link_real modes_w_upper_arm_1 = h_phi_upper_arm_1 * modes_inverse_upper_arm_1;
    const six_link_real modes_w_upper_arm_2 = t363 * modes_inverse_upper_arm_2;
    const six_link_real modes_w_upper_arm_3 = t364 * modes_inverse_upper_arm_3;
    const six_link_real t365 = C_upper_arm_11 * modes_W_upper_arm_11 + t351 * modes_W_upper_arm_21
        + t357 * modes_W_upper_arm_31;
    const six_link_real M_i_upper_arm_11 = M_loaded_upper_arm_11 - t365;
    const six_link_real t366 = C_upper_arm_11 * modes_W_upper_arm_12 + t351 * modes_W_upper_arm_22
        + t357 * modes_W_upper_arm_32;
    const six_link_real M_i_upper_arm_12 = M_loaded_upper_arm_12 - t366;
    const six_link_real t367 = C_upper_arm_11 * modes_W_upper_arm_13 + t351 * modes_W_upper_arm_23
        + t357 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_13 = M_loaded_upper_arm_13 - t367;
    const six_link_real t368 = C_upper_arm_11 * modes_W_upper_arm_14 + t351 * modes_W_upper_arm_24
        + t357 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_14 = M_loaded_upper_arm_14 - t368;
    const six_link_real t369 = C_upper_arm_11 * modes_W_upper_arm_15 + t351 * modes_W_upper_arm_25
        + t357 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_15 = M_loaded_upper_arm_15 - t369;
    const six_link_real t370 = C_upper_arm_11 * modes_W_upper_arm_16 + t351 * modes_W_upper_arm_26
        + t357 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_16 = M_loaded_upper_arm_16 - t370;
    const six_link_real t371 = C_upper_arm_21 * modes_W_upper_arm_12 + t352 * modes_W_upper_arm_22
        + t358 * modes_W_upper_arm_32;
    const six_link_real M_i_upper_arm_22 = M_loaded_upper_arm_22 - t371;
    const six_link_real t372 = C_upper_arm_21 * modes_W_upper_arm_13 + t352 * modes_W_upper_arm_23
        + t358 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_23 = M_loaded_upper_arm_23 - t372;
    const six_link_real t373 = C_upper_arm_21 * modes_W_upper_arm_14 + t352 * modes_W_upper_arm_24
        + t358 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_24 = M_loaded_upper_arm_24 - t373;
    const six_link_real t374 = C_upper_arm_21 * modes_W_upper_arm_15 + t352 * modes_W_upper_arm_25
        + t358 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_25 = M_loaded_upper_arm_25 - t374;
    const six_link_real t375 = C_upper_arm_21 * modes_W_upper_arm_16 + t352 * modes_W_upper_arm_26
        + t358 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_26 = M_loaded_upper_arm_26 - t375;
    const six_link_real t376 = C_upper_arm_31 * modes_W_upper_arm_13 + t353 * modes_W_upper_arm_23
        + t359 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_33 = M_loaded_upper_arm_33 - t376;
    const six_link_real t377 = C_upper_arm_31 * modes_W_upper_arm_14 + t353 * modes_W_upper_arm_24
        + t359 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_34 = M_loaded_upper_arm_34 - t377;
    const six_link_real t378 = C_upper_arm_31 * modes_W_upper_arm_15 + t353 * modes_W_upper_arm_25
        + t359 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_35 = M_loaded_upper_arm_35 - t378;
    const six_link_real t379 = C_upper_arm_31 * modes_W_upper_arm_16 + t353 * modes_W_upper_arm_26
        + t359 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_36 = M_loaded_upper_arm_36 - t379;
    const six_link_real t380 = C_upper_arm_41 * modes_W_upper_arm_14 + t354 * modes_W_upper_arm_24
        + t360 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_44 = M_loaded_upper_arm_44 - t380;
    const six_link_real t381 = C_upper_arm_41 * modes_W_upper_arm_15 + t354 * modes_W_upper_arm_25
        + t360 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_45 = Lambda_forearm_17 - t381;
    const six_link_real t382 = C_upper_arm_41 * modes_W_upper_arm_16 + t354 * modes_W_upper_arm_26
        + t360 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_46 = Lambda_forearm_18 - t382;
    const six_link_real t383 = C_upper_arm_51 * modes_W_upper_arm_15 + t355 * modes_W_upper_arm_25
        + t361 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_55 = M_loaded_upper_arm_55 - t383;
    const six_link_real t384 = C_upper_arm_51 * modes_W_upper_arm_16 + t355 * modes_W_upper_arm_26
        + t361 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_56 = Lambda_forearm_20 - t384;
    const six_link_real t385 = C_upper_arm_61 * modes_W_upper_arm_16 + t356 * modes_W_upper_arm_26
        + t362 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_66 = M_loaded_upper_arm_66 - t385;
    const six_link_real t386 = modes_W_upper_arm_11 * h_phi_upper_arm_1 + modes_W_upper_arm_21 * t363
        + modes_W_upper_arm_31 * t364;
    const six_link_real t387 = modes_W_upper_arm_12 * h_phi_upper_arm_1 + modes_W_upper_arm_22 * t363
        + modes_W_upper_arm_32 * t364;
    const six_link_real t388 = modes_W_upper_arm_13 * h_phi_upper_arm_1 + modes_W_upper_arm_23 * t363
        + modes_W_upper_arm_33 * t364;
    const six_link_real t389 = modes_W_upper_arm_14 * h_phi_upper_arm_1 + modes_W_upper_arm_24 * t363
        + modes_W_upper_arm_34 * t364;
    const six_link_real t390 = modes_W_upper_arm_15 * h_phi_upper_arm_1 + modes_W_upper_arm_25 * t363
        + modes_W_upper_arm_35 * t364;
    const six_link_real t391 = modes_W_upper_arm_16 * h_phi_upper_arm_1 + modes_W_upper_arm_26 * t363
        + modes_W_upper_arm_36 * t364;
    const six_link_real h_i_upper_arm_1 = h_loaded_upper_arm_1 - t386;
    const six_link_real h_i_upper_arm_2 = h_loaded_upper_arm_2 - t387;
    const six_link_real h_i_upper_arm_3 = h_loaded_upper_arm_3 - t388;
    const six_link_real h_i_upper_arm_4 = h_loaded_upper_arm_4 - t389;
    const six_link_real h_i_upper_arm_5 = h_loaded_upper_arm_5 - t390;
    const six_link_real h_i_upper_arm_6 = h_loaded_upper_arm_6 - t391;

    /* upper_arm, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_upper_arm_11 = M_i_upper_arm_22 + c->links[1].armature_1;
    bad |= (unsigned long)(!(joint_inertia_upper_arm_11 - t79 * (M_i_upper_arm_11 + M_i_upper_arm_22 + M_i_upper_arm_33) > 0)) << 1;
    const six_link_real joint_inverse_upper_arm_1 = 1 / joint_inertia_upper_arm_11;
    const six_link_real joint_W_upper_arm_11 = M_i_upper_arm_12 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_12 = M_i_upper_arm_22 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_13 = M_i_upper_arm_23 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_14 = M_i_upper_arm_24 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_15 = M_i_upper_arm_25 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_16 = M_i_upper_arm_26 * joint_inverse_upper_arm_1;
    const six_link_real joint_w_upper_arm_1 = (input->tau[1] - c->links[1].joint_damping_1 * state->v[1]
        - h_i_upper_arm_2) * joint_inverse_upper_arm_1;
    const six_link_real Lambda_i_upper_arm_11 = M_i_upper_arm_11 - M_i_upper_arm_12 * joint_W_upper_arm_11;
    const six_link_real Lambda_i_upper_arm_13 = M_i_upper_arm_13 - M_i_upper_arm_12 * joint_W_upper_arm_13;
    const six_link_real Lambda_i_upper_arm_14 = M_i_upper_arm_14 - M_i_upper_arm_12 * joint_W_upper_arm_14;
    const six_link_real Lambda_i_upper_arm_15 = M_i_upper_arm_15 - M_i_upper_arm_12 * joint_W_upper_arm_15;
    const six_link_real Lambda_i_upper_arm_16 = M_i_upper_arm_16 - M_i_upper_arm_12 * joint_W_upper_arm_16;
    const six_link_real Lambda_i_upper_arm_22 = M_i_upper_arm_22 - M_i_upper_arm_22 * joint_W_upper_arm_12;
    const six_link_real Lambda_i_upper_arm_24 = M_i_upper_arm_24 - M_i_upper_arm_22 * joint_W_upper_arm_14;
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
    const six_link_real p_i_upper_arm_1 = h_i_upper_arm_1 + M_i_upper_arm_12 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_3 = h_i_upper_arm_3 + M_i_upper_arm_23 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_4 = h_i_upper_arm_4 + M_i_upper_arm_24 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_5 = h_i_upper_arm_5 + M_i_upper_arm_25 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_6 = h_i_upper_arm_6 + M_i_upper_arm_26 * joint_w_upper_arm_1;

    /* upper_arm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t392 = c->links[1].mount_xyz_y * Lambda_i_upper_arm_46;
    const six_link_real t393 = lever_upper_arm_1 * Lambda_i_upper_arm_56;
    const six_link_real t394 = Lambda_i_upper_arm_15
        + (c->links[1].mount_xyz_y * Lambda_i_upper_arm_56 - lever_upper_arm_3 * Lambda_i_upper_arm_55);
    const six_link_real t395 = Lambda_i_upper_arm_16
        + (c->links[1].mount_xyz_y * Lambda_i_upper_arm_66 - lever_upper_arm_3 * Lambda_i_upper_arm_56);
    const six_link_real t396 = Lambda_i_upper_arm_24
        + (lever_upper_arm_3 * Lambda_i_upper_arm_44 - lever_upper_arm_1 * Lambda_i_upper_arm_46);
    const six_link_real t397 = Lambda_i_upper_arm_26
        + (lever_upper_arm_3 * Lambda_i_upper_arm_46 - lever_upper_arm_1 * Lambda_i_upper_arm_66);
    const six_link_real t398 = Lambda_i_upper_arm_34
        + (lever_upper_arm_1 * Lambda_i_upper_arm_45 - c->links[1].mount_xyz_y * Lambda_i_upper_arm_44);
    const six_link_real t399 = Lambda_i_upper_arm_35
        + (lever_upper_arm_1 * Lambda_i_upper_arm_55 - c->links[1].mount_xyz_y * Lambda_i_upper_arm_45);
    const six_link_real t400 = Lambda_i_upper_arm_36 + (t393 - t392);
    const six_link_real t401 = Lambda_i_upper_arm_11
        - (Lambda_i_upper_arm_15 * lever_upper_arm_3 - Lambda_i_upper_arm_16 * c->links[1].mount_xyz_y);
    const six_link_real t402 = Lambda_i_upper_arm_13
        - (Lambda_i_upper_arm_14 * c->links[1].mount_xyz_y - Lambda_i_upper_arm_15 * lever_upper_arm_1);
    const six_link_real t403 = t402 + (c->links[1].mount_xyz_y * t400 - lever_upper_arm_3 * t399);
    const six_link_real t404 = Lambda_i_upper_arm_22
        - (Lambda_i_upper_arm_26 * lever_upper_arm_1 - Lambda_i_upper_arm_24 * lever_upper_arm_3);
    const six_link_real Lambda_upper_arm_7 = t404 + (lever_upper_arm_3 * t396 - lever_upper_arm_1 * t397);
    const six_link_real t405 = Lambda_i_upper_arm_33
        - (Lambda_i_upper_arm_34 * c->links[1].mount_xyz_y - Lambda_i_upper_arm_35 * lever_upper_arm_1);
    const six_link_real t406 = t405 + (lever_upper_arm_1 * t399 - c->links[1].mount_xyz_y * t398);
    const six_link_real t407 = (t401 + (c->links[1].mount_xyz_y * t395 - lever_upper_arm_3 * t394) - t406)
        * REAL(0.5);
    const six_link_real t408 = t407 * R_rel_upper_arm_xx + t403 * R_rel_upper_arm_xz;
    const six_link_real t409 = t403 * R_rel_upper_arm_xx - t407 * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_1 = R_rel_upper_arm_xx * t408 * 2 + t406;
    const six_link_real Lambda_upper_arm_12 = t406 - R_rel_upper_arm_xz * t409 * 2;
    const six_link_real Lambda_upper_arm_11 = t397 * R_rel_upper_arm_xx - t396 * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_14 = R_rel_upper_arm_xx * t399 - R_rel_upper_arm_xz * t394;
    const six_link_real t410 = Lambda_i_upper_arm_46 * R_rel_upper_arm_xx
        - (Lambda_i_upper_arm_44 - Lambda_i_upper_arm_66) * REAL(0.5) * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_21 = Lambda_i_upper_arm_66 - R_rel_upper_arm_xz * t410 * 2;
    const six_link_real t411 = p_i_upper_arm_1
        + (c->links[1].mount_xyz_y * p_i_upper_arm_6 - lever_upper_arm_3 * p_i_upper_arm_5);
    const six_link_real t412 = p_i_upper_arm_3
        + (lever_upper_arm_1 * p_i_upper_arm_5 - c->links[1].mount_xyz_y * p_i_upper_arm_4);
    const six_link_real p_upper_arm_3 = R_rel_upper_arm_xx * t412 - R_rel_upper_arm_xz * t411;

    /* shoulder, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_shoulder_3 = c->links[0].S_0_x * alpha_0_shoulder_5;

    /* shoulder, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real Lambda_T_shoulder_11 = Lambda_upper_arm_1 + c->links[0].I_T_xx;
    const six_link_real Lambda_T_shoulder_22 = Lambda_upper_arm_7 + c->links[0].I_T_yy;
    const six_link_real Lambda_T_shoulder_26 = Lambda_upper_arm_11 - c->links[0].S_T_x;
    const six_link_real Lambda_T_shoulder_33 = Lambda_upper_arm_12 + c->links[0].I_T_zz;
    const six_link_real Lambda_T_shoulder_35 = Lambda_upper_arm_14 + c->links[0].S_T_x;
    const six_link_real Lambda_T_shoulder_55 = Lambda_i_upper_arm_55 + c->links[0].body0_mass;
    const six_link_real Lambda_T_shoulder_66 = Lambda_upper_arm_21 + c->links[0].body0_mass;
    const six_link_real t413 = p_upper_arm_3
        + (c->links[0].S_T_x * alpha_0_shoulder_5 + c->links[0].S_T_y * minus_alpha_0_T_shoulder_4);
    const six_link_real t414 = p_i_upper_arm_5
        + (c->links[0].body0_mass * alpha_0_shoulder_5 - state->v[0] * (state->v[0] * c->links[0].S_T_y));
    const six_link_real p_T_shoulder_3 = t413 - input->w_ext[0][2];
    const six_link_real p_T_shoulder_5 = t414 - input->w_ext[0][4];

    /* shoulder, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t415 = Lambda_T_shoulder_35 + c->links[0].length * Lambda_T_shoulder_55;
    const six_link_real t416 = Lambda_T_shoulder_22 - Lambda_T_shoulder_26 * c->links[0].length
        - c->links[0].length * (Lambda_T_shoulder_26 - c->links[0].length * Lambda_T_shoulder_66);
    const six_link_real M_loaded_shoulder_11 = c->links[0].I_s + Lambda_T_shoulder_11;
    const six_link_real M_loaded_shoulder_22 = c->links[0].J_0_xx + t416;
    const six_link_real M_loaded_shoulder_33 = c->links[0].J_0_xx
        + (Lambda_T_shoulder_33 + Lambda_T_shoulder_35 * c->links[0].length + c->links[0].length * t415);
    const six_link_real h_loaded_shoulder_3 = H_star_shoulder_3
        + (p_T_shoulder_3 + c->links[0].length * p_T_shoulder_5);

    /* shoulder, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_shoulder_11 = M_loaded_shoulder_33 + c->links[0].armature_1;
    bad |= (unsigned long)(!(joint_inertia_shoulder_11 - t79 * (M_loaded_shoulder_11 + M_loaded_shoulder_22 + M_loaded_shoulder_33) > 0)) << 0;
    const six_link_real joint_inverse_shoulder_1 = 1 / joint_inertia_shoulder_11;
    const six_link_real joint_w_shoulder_1 = (input->tau[0] - c->links[0].joint_damping_1 * state->v[0]
        - h_loaded_shoulder_3) * joint_inverse_shoulder_1;
    output->vdot[0] = joint_w_shoulder_1;

    /* shoulder, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real delta_T_shoulder_5 = joint_w_shoulder_1 * c->links[0].length;

    /* upper_arm, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real minus_carried_upper_arm_1 = R_rel_upper_arm_xz * joint_w_shoulder_1;
    const six_link_real carried_upper_arm_3 = R_rel_upper_arm_xx * joint_w_shoulder_1;
    const six_link_real minus_carried_upper_arm_4 = carried_upper_arm_3 * c->links[1].mount_xyz_y;
    const six_link_real minus_carried_upper_arm_6 = minus_carried_upper_arm_1 * c->links[1].mount_xyz_y;
    const six_link_real carried_upper_arm_5 = delta_T_shoulder_5
        + (carried_upper_arm_3 * lever_upper_arm_1 + minus_carried_upper_arm_1 * lever_upper_arm_3);
    const six_link_real t417 = joint_W_upper_arm_13 * carried_upper_arm_3
        - joint_W_upper_arm_11 * minus_carried_upper_arm_1 - joint_W_upper_arm_14 * minus_carried_upper_arm_4;
    const six_link_real t418 = t417 + joint_W_upper_arm_15 * carried_upper_arm_5
        - joint_W_upper_arm_16 * minus_carried_upper_arm_6;
    const six_link_real qddot_upper_arm_1 = joint_w_upper_arm_1 - t418;
    output->vdot[1] = qddot_upper_arm_1;

    /* upper_arm, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real t419 = modes_W_upper_arm_12 * qddot_upper_arm_1
        - modes_W_upper_arm_11 * minus_carried_upper_arm_1 + modes_W_upper_arm_13 * carried_upper_arm_3;
    const six_link_real t420 = t419 - modes_W_upper_arm_14 * minus_carried_upper_arm_4
        + modes_W_upper_arm_15 * carried_upper_arm_5;
    const six_link_real t421 = modes_W_upper_arm_22 * qddot_upper_arm_1
        - modes_W_upper_arm_21 * minus_carried_upper_arm_1 + modes_W_upper_arm_23 * carried_upper_arm_3;
    const six_link_real t422 = t421 - modes_W_upper_arm_24 * minus_carried_upper_arm_4
        + modes_W_upper_arm_25 * carried_upper_arm_5;
    const six_link_real t423 = modes_W_upper_arm_32 * qddot_upper_arm_1
        - modes_W_upper_arm_31 * minus_carried_upper_arm_1 + modes_W_upper_arm_33 * carried_upper_arm_3;
    const six_link_real t424 = t423 - modes_W_upper_arm_34 * minus_carried_upper_arm_4
        + modes_W_upper_arm_35 * carried_upper_arm_5;
    const six_link_real minus_etaddot_upper_arm_3 = modes_w_upper_arm_3
        + (t424 - modes_W_upper_arm_36 * minus_carried_upper_arm_6);
    output->vdot[8] = -minus_etaddot_upper_arm_3;
    const six_link_real minus_etaddot_upper_arm_2 = modes_w_upper_arm_2
        + (t422 - modes_W_upper_arm_26 * minus_carried_upper_arm_6)
        - modes_L_upper_arm_32 * minus_etaddot_upper_arm_3;
    output->vdot[7] = -minus_etaddot_upper_arm_2;
    const six_link_real t425 = modes_w_upper_arm_1 + (t420 - modes_W_upper_arm_16 * minus_carried_upper_arm_6)
        - modes_L_upper_arm_21 * minus_etaddot_upper_arm_2;
    const six_link_real minus_etaddot_upper_arm_1 = t425 - modes_L_upper_arm_31 * minus_etaddot_upper_arm_3;
    output->vdot[6] = -minus_etaddot_upper_arm_1;

    /* upper_arm, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real t426 = minus_etaddot_upper_arm_3 * REAL(1.4142135623730951);
    const six_link_real t427 = c->links[1].Psi_c_y2 * minus_etaddot_upper_arm_2;
    const six_link_real t428 = c->links[1].Psi_c_z1 * minus_etaddot_upper_arm_1;
    const six_link_real delta_T_upper_arm_4 = qddot_upper_arm_1 * r_T_upper_arm_z
        - carried_upper_arm_3 * r_T_upper_arm_y - minus_carried_upper_arm_4;
    const six_link_real t429 = carried_upper_arm_5
        + (carried_upper_arm_3 * c->links[1].length + minus_carried_upper_arm_1 * r_T_upper_arm_z);
    const six_link_real t430 = minus_carried_upper_arm_6
        + (minus_carried_upper_arm_1 * r_T_upper_arm_y + qddot_upper_arm_1 * c->links[1].length);
    const six_link_real minus_delta_T_upper_arm_1 = minus_carried_upper_arm_1
        + (J_l_upper_arm_xx * t426 + J_l_upper_arm_xy * t427 + J_l_upper_arm_xz * t428);
    const six_link_real delta_T_upper_arm_2 = qddot_upper_arm_1
        - (J_l_upper_arm_yx * t426 + J_l_upper_arm_yy * t427 + J_l_upper_arm_yz * t428);
    const six_link_real delta_T_upper_arm_3 = carried_upper_arm_3
        - (J_l_upper_arm_zx * t426 + J_l_upper_arm_zy * t427 + J_l_upper_arm_zz * t428);
    const six_link_real delta_T_upper_arm_5 = t429 - minus_etaddot_upper_arm_1 * 2;
    const six_link_real minus_delta_T_upper_arm_6 = t430 + minus_etaddot_upper_arm_2 * 2;

    /* forearm, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_forearm_1 = R_P_forearm_21 * delta_T_upper_arm_2
        - R_P_forearm_11 * minus_delta_T_upper_arm_1 + R_P_forearm_31 * delta_T_upper_arm_3;
    const six_link_real carried_forearm_2 = R_P_forearm_22 * delta_T_upper_arm_2
        - R_P_forearm_12 * minus_delta_T_upper_arm_1 + R_P_forearm_32 * delta_T_upper_arm_3;
    const six_link_real carried_forearm_3 = R_P_forearm_23 * delta_T_upper_arm_2
        - R_P_forearm_13 * minus_delta_T_upper_arm_1 + R_P_forearm_33 * delta_T_upper_arm_3;
    const six_link_real t431 = R_P_forearm_11 * delta_T_upper_arm_4 + R_P_forearm_21 * delta_T_upper_arm_5
        - R_P_forearm_31 * minus_delta_T_upper_arm_6;
    const six_link_real t432 = R_P_forearm_12 * delta_T_upper_arm_4 + R_P_forearm_22 * delta_T_upper_arm_5
        - R_P_forearm_32 * minus_delta_T_upper_arm_6;
    const six_link_real t433 = R_P_forearm_13 * delta_T_upper_arm_4 + R_P_forearm_23 * delta_T_upper_arm_5
        - R_P_forearm_33 * minus_delta_T_upper_arm_6;
    const six_link_real carried_forearm_4 = t431
        + (carried_forearm_2 * lever_forearm_3 - carried_forearm_3 * lever_forearm_2);
    const six_link_real carried_forearm_5 = t432
        + (carried_forearm_3 * lever_forearm_1 - carried_forearm_1 * lever_forearm_3);
    const six_link_real carried_forearm_6 = t433
        + (carried_forearm_1 * lever_forearm_2 - carried_forearm_2 * lever_forearm_1);
    const six_link_real t434 = joint_W_forearm_11 * carried_forearm_1 + joint_W_forearm_12 * carried_forearm_2
        + joint_W_forearm_13 * carried_forearm_3;
    const six_link_real t435 = t434 + joint_W_forearm_14 * carried_forearm_4
        + joint_W_forearm_15 * carried_forearm_5 + joint_W_forearm_16 * carried_forearm_6;
    const six_link_real qddot_forearm_1 = joint_w_forearm_1 - t435;
    output->vdot[2] = qddot_forearm_1;

    /* forearm, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_forearm_2 = carried_forearm_2 + qddot_forearm_1;
    const six_link_real t436 = modes_W_forearm_11 * carried_forearm_1 + modes_W_forearm_12 * delta_forearm_2
        + modes_W_forearm_13 * carried_forearm_3;
    const six_link_real t437 = t436 + modes_W_forearm_14 * carried_forearm_4
        + modes_W_forearm_15 * carried_forearm_5 + modes_W_forearm_16 * carried_forearm_6;
    const six_link_real t438 = modes_W_forearm_21 * carried_forearm_1 + modes_W_forearm_22 * delta_forearm_2
        + modes_W_forearm_23 * carried_forearm_3;
    const six_link_real t439 = t438 + modes_W_forearm_24 * carried_forearm_4
        + modes_W_forearm_25 * carried_forearm_5 + modes_W_forearm_26 * carried_forearm_6;
    const six_link_real minus_etaddot_forearm_2 = modes_w_forearm_2 + t439;
    output->vdot[10] = -minus_etaddot_forearm_2;
    const six_link_real minus_etaddot_forearm_1 = modes_w_forearm_1 + t437
        - modes_L_forearm_21 * minus_etaddot_forearm_2;
    output->vdot[9] = -minus_etaddot_forearm_1;

    /* forearm, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real t440 = c->links[2].Psi_c_y2 * minus_etaddot_forearm_2;
    const six_link_real t441 = c->links[2].Psi_c_z1 * minus_etaddot_forearm_1;
    const six_link_real delta_T_forearm_4 = carried_forearm_4
        + (delta_forearm_2 * r_T_forearm_z - carried_forearm_3 * r_T_forearm_y);
    const six_link_real delta_T_forearm_1 = carried_forearm_1
        + (minus_J_l_forearm_xy * t440 - J_l_forearm_xz * t441);
    const six_link_real delta_T_forearm_2 = delta_forearm_2 - (J_l_forearm_yy * t440 + J_l_forearm_yz * t441);
    const six_link_real delta_T_forearm_3 = carried_forearm_3 - (J_l_forearm_yz * t440 + J_l_forearm_zz * t441);
    const six_link_real delta_T_forearm_5 = carried_forearm_5
        + (carried_forearm_3 * c->links[2].length - carried_forearm_1 * r_T_forearm_z)
        - minus_etaddot_forearm_1 * REAL(2.23606797749979);
    const six_link_real delta_T_forearm_6 = carried_forearm_6
        + (carried_forearm_1 * r_T_forearm_y - delta_forearm_2 * c->links[2].length)
        - minus_etaddot_forearm_2 * REAL(2.23606797749979);

    /* wrist_roll, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_wrist_roll_1 = R_T_forearm_xx * delta_T_forearm_1
        + minus_R_T_forearm_xy * delta_T_forearm_2 - R_T_forearm_xz * delta_T_forearm_3;
    const six_link_real carried_wrist_roll_2 = R_P_wrist_roll_12 * delta_T_forearm_1
        + R_P_wrist_roll_22 * delta_T_forearm_2 + R_P_wrist_roll_32 * delta_T_forearm_3;
    const six_link_real carried_wrist_roll_3 = R_P_wrist_roll_13 * delta_T_forearm_1
        + R_P_wrist_roll_23 * delta_T_forearm_2 + R_P_wrist_roll_33 * delta_T_forearm_3;
    const six_link_real carried_wrist_roll_4 = R_T_forearm_xx * delta_T_forearm_4
        + minus_R_T_forearm_xy * delta_T_forearm_5 - R_T_forearm_xz * delta_T_forearm_6;
    const six_link_real carried_wrist_roll_5 = R_P_wrist_roll_12 * delta_T_forearm_4
        + R_P_wrist_roll_22 * delta_T_forearm_5 + R_P_wrist_roll_32 * delta_T_forearm_6;
    const six_link_real carried_wrist_roll_6 = R_P_wrist_roll_13 * delta_T_forearm_4
        + R_P_wrist_roll_23 * delta_T_forearm_5 + R_P_wrist_roll_33 * delta_T_forearm_6;
    const six_link_real t442 = joint_W_wrist_roll_11 * carried_wrist_roll_1
        + joint_W_wrist_roll_12 * carried_wrist_roll_2 + joint_W_wrist_roll_13 * carried_wrist_roll_3;
    const six_link_real t443 = t442 + joint_W_wrist_roll_14 * carried_wrist_roll_4
        + joint_W_wrist_roll_15 * carried_wrist_roll_5;
    const six_link_real qddot_wrist_roll_1 = joint_w_wrist_roll_1
        - (t443 + joint_W_wrist_roll_16 * carried_wrist_roll_6);
    output->vdot[3] = qddot_wrist_roll_1;

    /* wrist_roll, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_wrist_roll_1 = carried_wrist_roll_1 + qddot_wrist_roll_1;

    /* wrist_roll, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real delta_T_wrist_roll_5 = carried_wrist_roll_5 + carried_wrist_roll_3 * c->links[3].length;
    const six_link_real delta_T_wrist_roll_6 = carried_wrist_roll_6 - carried_wrist_roll_2 * c->links[3].length;

    /* wrist_pitch, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_wrist_pitch_1 = R_rel_wrist_pitch_xx * delta_wrist_roll_1
        - R_rel_wrist_pitch_xz * carried_wrist_roll_3;
    const six_link_real carried_wrist_pitch_3 = R_rel_wrist_pitch_xz * delta_wrist_roll_1
        + R_rel_wrist_pitch_xx * carried_wrist_roll_3;
    const six_link_real carried_wrist_pitch_4 = R_rel_wrist_pitch_xx * carried_wrist_roll_4
        - R_rel_wrist_pitch_xz * delta_T_wrist_roll_6;
    const six_link_real carried_wrist_pitch_6 = R_rel_wrist_pitch_xz * carried_wrist_roll_4
        + R_rel_wrist_pitch_xx * delta_T_wrist_roll_6;
    const six_link_real t444 = joint_W_wrist_pitch_11 * carried_wrist_pitch_1
        + joint_W_wrist_pitch_12 * carried_wrist_roll_2 + joint_W_wrist_pitch_13 * carried_wrist_pitch_3;
    const six_link_real t445 = t444 + joint_W_wrist_pitch_14 * carried_wrist_pitch_4
        - minus_joint_W_wrist_pitch_15 * delta_T_wrist_roll_5;
    const six_link_real qddot_wrist_pitch_1 = joint_w_wrist_pitch_1
        - (t445 + joint_W_wrist_pitch_16 * carried_wrist_pitch_6);
    output->vdot[4] = qddot_wrist_pitch_1;

    /* wrist_pitch, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_wrist_pitch_2 = carried_wrist_roll_2 + qddot_wrist_pitch_1;

    /* wrist_pitch, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real delta_T_wrist_pitch_5 = delta_T_wrist_roll_5 + carried_wrist_pitch_3 * c->links[4].length;
    const six_link_real delta_T_wrist_pitch_6 = carried_wrist_pitch_6 - delta_wrist_pitch_2 * c->links[4].length;

    /* flange, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_flange_2 = R_rel_flange_yy * delta_wrist_pitch_2
        + minus_R_rel_flange_yz * carried_wrist_pitch_3;
    const six_link_real carried_flange_3 = R_rel_flange_yy * carried_wrist_pitch_3
        - minus_R_rel_flange_yz * delta_wrist_pitch_2;
    const six_link_real carried_flange_5 = R_rel_flange_yy * delta_T_wrist_pitch_5
        + minus_R_rel_flange_yz * delta_T_wrist_pitch_6;
    const six_link_real carried_flange_6 = R_rel_flange_yy * delta_T_wrist_pitch_6
        - minus_R_rel_flange_yz * delta_T_wrist_pitch_5;
    const six_link_real t446 = joint_W_flange_11 * carried_wrist_pitch_1
        - minus_joint_W_flange_12 * carried_flange_2 - minus_joint_W_flange_13 * carried_flange_3;
    const six_link_real qddot_flange_1 = joint_w_flange_1
        - (t446 - minus_joint_W_flange_15 * carried_flange_5 + joint_W_flange_16 * carried_flange_6);
    output->vdot[5] = qddot_flange_1;

    if (wanted & SIX_LINK_WRENCHES) {
        /* upper_arm, joint: its accelerations eliminated from its rows (43) */
        const six_link_real Lambda_i_upper_arm_12 = M_i_upper_arm_12 - M_i_upper_arm_12 * joint_W_upper_arm_12;
        const six_link_real Lambda_i_upper_arm_23 = M_i_upper_arm_23 - M_i_upper_arm_22 * joint_W_upper_arm_13;
        const six_link_real Lambda_i_upper_arm_25 = M_i_upper_arm_25 - M_i_upper_arm_22 * joint_W_upper_arm_15;
        const six_link_real p_i_upper_arm_2 = h_i_upper_arm_2 + M_i_upper_arm_22 * joint_w_upper_arm_1;

        /* upper_arm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
        const six_link_real t447 = lever_upper_arm_3 * Lambda_i_upper_arm_45;
        const six_link_real t448 = Lambda_i_upper_arm_14 + (t392 - t447);
        const six_link_real Lambda_upper_arm_10 = Lambda_i_upper_arm_25 + (t447 - t393);
        const six_link_real t449 = Lambda_i_upper_arm_12
            - (Lambda_i_upper_arm_16 * lever_upper_arm_1 - Lambda_i_upper_arm_14 * lever_upper_arm_3);
        const six_link_real t450 = Lambda_i_upper_arm_23
            - (Lambda_i_upper_arm_24 * c->links[1].mount_xyz_y - Lambda_i_upper_arm_25 * lever_upper_arm_1);
        const six_link_real Lambda_upper_arm_3 = R_rel_upper_arm_xx * t409 - R_rel_upper_arm_xz * t408;
        const six_link_real t451 = R_rel_upper_arm_xz
            * (t449 + (c->links[1].mount_xyz_y * t397 - lever_upper_arm_3 * Lambda_upper_arm_10));
        const six_link_real Lambda_upper_arm_8 = (t450 + (lever_upper_arm_3 * t398 - lever_upper_arm_1 * t400))
            * R_rel_upper_arm_xx - t451;
        const six_link_real Lambda_upper_arm_5 = R_rel_upper_arm_xx * t394 + R_rel_upper_arm_xz * t399;
        const six_link_real Lambda_upper_arm_13 = R_rel_upper_arm_xx
            * (t398 * R_rel_upper_arm_xx + t400 * R_rel_upper_arm_xz)
            - R_rel_upper_arm_xz * (t448 * R_rel_upper_arm_xx + t395 * R_rel_upper_arm_xz);
        const six_link_real Lambda_upper_arm_15 = R_rel_upper_arm_xx
            * (t400 * R_rel_upper_arm_xx - t398 * R_rel_upper_arm_xz)
            - R_rel_upper_arm_xz * (t395 * R_rel_upper_arm_xx - t448 * R_rel_upper_arm_xz);
        const six_link_real Lambda_upper_arm_17 = R_rel_upper_arm_xx * Lambda_i_upper_arm_45
            + Lambda_i_upper_arm_56 * R_rel_upper_arm_xz;
        const six_link_real Lambda_upper_arm_20 = Lambda_i_upper_arm_56 * R_rel_upper_arm_xx
            - R_rel_upper_arm_xz * Lambda_i_upper_arm_45;
        const six_link_real p_upper_arm_2 = p_i_upper_arm_2
            + (lever_upper_arm_3 * p_i_upper_arm_4 - lever_upper_arm_1 * p_i_upper_arm_6);
        const six_link_real p_upper_arm_1 = R_rel_upper_arm_xx * t411 + R_rel_upper_arm_xz * t412;
        const six_link_real p_upper_arm_4 = R_rel_upper_arm_xx * p_i_upper_arm_4
            + R_rel_upper_arm_xz * p_i_upper_arm_6;
        const six_link_real p_upper_arm_6 = R_rel_upper_arm_xx * p_i_upper_arm_6
            - R_rel_upper_arm_xz * p_i_upper_arm_4;

        /* shoulder, Omega: acceleration of a place by the link's turning */
        const six_link_real minus_Omega_shoulder_xx = state->v[0] * state->v[0];

        /* shoulder, H_star: gyroscopic wrench and weight, angular acceleration included */
        const six_link_real H_star_shoulder_2 = c->links[0].S_0_x * c->gravity[2];
        const six_link_real minus_H_star_shoulder_4 = minus_alpha_0_shoulder_4 * c->links[0].mu
            + minus_Omega_shoulder_xx * c->links[0].S_0_x;
        const six_link_real H_star_shoulder_5 = alpha_0_shoulder_5 * c->links[0].mu;
        const six_link_real minus_H_star_shoulder_6 = c->gravity[2] * c->links[0].mu;

        /* shoulder, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
        const six_link_real Lambda_T_shoulder_13 = Lambda_upper_arm_3 - c->links[0].J_T_xz;
        const six_link_real Lambda_T_shoulder_15 = Lambda_upper_arm_5 - c->links[0].S_T_z;
        const six_link_real Lambda_T_shoulder_23 = Lambda_upper_arm_8 - c->links[0].J_T_yz;
        const six_link_real Lambda_T_shoulder_34 = Lambda_upper_arm_13 - c->links[0].S_T_y;
        const six_link_real t452 = state->v[0] * (c->links[0].J_T_yz * state->v[0])
            - (c->links[0].S_T_y * c->gravity[2] + c->links[0].S_T_z * alpha_0_shoulder_5);
        const six_link_real t453 = c->links[0].S_T_x * c->gravity[2] - c->links[0].S_T_z * minus_alpha_0_T_shoulder_4
            - state->v[0] * (c->links[0].J_T_xz * state->v[0]);
        const six_link_real t454 = c->links[0].body0_mass * minus_alpha_0_T_shoulder_4
            + state->v[0] * (state->v[0] * c->links[0].S_T_x);
        const six_link_real p_T_shoulder_1 = p_upper_arm_1 + t452 - input->w_ext[0][0];
        const six_link_real p_T_shoulder_2 = p_upper_arm_2 + t453 - input->w_ext[0][1];
        const six_link_real p_T_shoulder_4 = p_upper_arm_4 - t454 - input->w_ext[0][3];
        const six_link_real p_T_shoulder_6 = p_upper_arm_6 - c->links[0].body0_mass * c->gravity[2]
            - input->w_ext[0][5];

        /* shoulder, modes: the tip load folded in, modal accelerations eliminated (83) */
        const six_link_real M_loaded_shoulder_34 = Lambda_T_shoulder_34 + c->links[0].length * Lambda_upper_arm_17;
        const six_link_real M_loaded_shoulder_36 = Lambda_upper_arm_15 + c->links[0].length * Lambda_upper_arm_20;
        const six_link_real M_loaded_shoulder_13 = Lambda_T_shoulder_13 + Lambda_T_shoulder_15 * c->links[0].length;
        const six_link_real M_loaded_shoulder_23 = Lambda_T_shoulder_23 + Lambda_upper_arm_10 * c->links[0].length
            - c->links[0].length * M_loaded_shoulder_36;
        const six_link_real M_loaded_shoulder_35 = c->links[0].S_0_x + t415;
        const six_link_real h_loaded_shoulder_2 = H_star_shoulder_2
            + (p_T_shoulder_2 - c->links[0].length * p_T_shoulder_6);
        const six_link_real h_loaded_shoulder_4 = p_T_shoulder_4 - minus_H_star_shoulder_4;
        const six_link_real h_loaded_shoulder_5 = H_star_shoulder_5 + p_T_shoulder_5;
        const six_link_real h_loaded_shoulder_6 = p_T_shoulder_6 - minus_H_star_shoulder_6;

        /* shoulder, joint: its accelerations eliminated from its rows (43) */
        const six_link_real p_i_shoulder_1 = p_T_shoulder_1 + M_loaded_shoulder_13 * joint_w_shoulder_1;
        output->wrench[0][0] = p_i_shoulder_1;
        const six_link_real p_i_shoulder_2 = h_loaded_shoulder_2 + M_loaded_shoulder_23 * joint_w_shoulder_1;
        output->wrench[0][1] = p_i_shoulder_2;
        const six_link_real p_i_shoulder_3 = h_loaded_shoulder_3 + M_loaded_shoulder_33 * joint_w_shoulder_1;
        output->wrench[0][2] = p_i_shoulder_3;
        const six_link_real p_i_shoulder_4 = h_loaded_shoulder_4 + M_loaded_shoulder_34 * joint_w_shoulder_1;
        output->wrench[0][3] = p_i_shoulder_4;
        const six_link_real p_i_shoulder_5 = h_loaded_shoulder_5 + M_loaded_shoulder_35 * joint_w_shoulder_1;
        output->wrench[0][4] = p_i_shoulder_5;
        const six_link_real p_i_shoulder_6 = h_loaded_shoulder_6 + M_loaded_shoulder_36 * joint_w_shoulder_1;
        output->wrench[0][5] = p_i_shoulder_6;

        /* joint wrench (48)_upper_arm */
        const six_link_real t455 = Lambda_i_upper_arm_13 * carried_upper_arm_3
            - Lambda_i_upper_arm_11 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_14 * minus_carried_upper_arm_4;
        const six_link_real t456 = t455 + Lambda_i_upper_arm_15 * carried_upper_arm_5
            - Lambda_i_upper_arm_16 * minus_carried_upper_arm_6;
        const six_link_real t457 = Lambda_i_upper_arm_23 * carried_upper_arm_3
            - Lambda_i_upper_arm_12 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_24 * minus_carried_upper_arm_4;
        const six_link_real t458 = t457 + Lambda_i_upper_arm_25 * carried_upper_arm_5
            - Lambda_i_upper_arm_26 * minus_carried_upper_arm_6;
        const six_link_real t459 = Lambda_i_upper_arm_33 * carried_upper_arm_3
            - Lambda_i_upper_arm_13 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_34 * minus_carried_upper_arm_4;
        const six_link_real t460 = t459 + Lambda_i_upper_arm_35 * carried_upper_arm_5
            - Lambda_i_upper_arm_36 * minus_carried_upper_arm_6;
        const six_link_real t461 = Lambda_i_upper_arm_34 * carried_upper_arm_3
            - Lambda_i_upper_arm_14 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_44 * minus_carried_upper_arm_4;
        const six_link_real t462 = t461 + Lambda_i_upper_arm_45 * carried_upper_arm_5
            - Lambda_i_upper_arm_46 * minus_carried_upper_arm_6;
        const six_link_real t463 = Lambda_i_upper_arm_35 * carried_upper_arm_3
            - Lambda_i_upper_arm_15 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_45 * minus_carried_upper_arm_4;
        const six_link_real t464 = t463 + Lambda_i_upper_arm_55 * carried_upper_arm_5
            - Lambda_i_upper_arm_56 * minus_carried_upper_arm_6;
        const six_link_real t465 = Lambda_i_upper_arm_36 * carried_upper_arm_3
            - Lambda_i_upper_arm_16 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_46 * minus_carried_upper_arm_4;
        const six_link_real t466 = t465 + Lambda_i_upper_arm_56 * carried_upper_arm_5
            - Lambda_i_upper_arm_66 * minus_carried_upper_arm_6;
        const six_link_real wrench_upper_arm_1 = t456 + p_i_upper_arm_1;
        output->wrench[1][0] = wrench_upper_arm_1;
        const six_link_real wrench_upper_arm_2 = t458 + p_i_upper_arm_2;
        output->wrench[1][1] = wrench_upper_arm_2;
        const six_link_real wrench_upper_arm_3 = t460 + p_i_upper_arm_3;
        output->wrench[1][2] = wrench_upper_arm_3;
        const six_link_real wrench_upper_arm_4 = t462 + p_i_upper_arm_4;
        output->wrench[1][3] = wrench_upper_arm_4;
        const six_link_real wrench_upper_arm_5 = t464 + p_i_upper_arm_5;
        output->wrench[1][4] = wrench_upper_arm_5;
        const six_link_real wrench_upper_arm_6 = t466 + p_i_upper_arm_6;
        output->wrench[1][5] = wrench_upper_arm_6;

        /* joint wrench (48)_forearm */
        const six_link_real t467 = Lambda_i_forearm_11 * carried_forearm_1 + Lambda_i_forearm_12 * carried_forearm_2
            + Lambda_i_forearm_13 * carried_forearm_3;
        const six_link_real t468 = t467 + Lambda_i_forearm_14 * carried_forearm_4
            + Lambda_i_forearm_15 * carried_forearm_5 + Lambda_i_forearm_16 * carried_forearm_6;
        const six_link_real t469 = Lambda_i_forearm_12 * carried_forearm_1 + Lambda_i_forearm_22 * carried_forearm_2
            + Lambda_i_forearm_23 * carried_forearm_3;
        const six_link_real t470 = t469 + Lambda_i_forearm_24 * carried_forearm_4
            + Lambda_i_forearm_25 * carried_forearm_5 + Lambda_i_forearm_26 * carried_forearm_6;
        const six_link_real t471 = Lambda_i_forearm_13 * carried_forearm_1 + Lambda_i_forearm_23 * carried_forearm_2
            + Lambda_i_forearm_33 * carried_forearm_3;
        const six_link_real t472 = t471 + Lambda_i_forearm_34 * carried_forearm_4
            + Lambda_i_forearm_35 * carried_forearm_5 + Lambda_i_forearm_36 * carried_forearm_6;
        const six_link_real t473 = Lambda_i_forearm_14 * carried_forearm_1 + Lambda_i_forearm_24 * carried_forearm_2
            + Lambda_i_forearm_34 * carried_forearm_3;
        const six_link_real t474 = t473 + Lambda_i_forearm_44 * carried_forearm_4
            + Lambda_i_forearm_45 * carried_forearm_5 + Lambda_i_forearm_46 * carried_forearm_6;
        const six_link_real t475 = Lambda_i_forearm_15 * carried_forearm_1 + Lambda_i_forearm_25 * carried_forearm_2
            + Lambda_i_forearm_35 * carried_forearm_3;
        const six_link_real t476 = t475 + Lambda_i_forearm_45 * carried_forearm_4
            + Lambda_i_forearm_55 * carried_forearm_5 + Lambda_i_forearm_56 * carried_forearm_6;
        const six_link_real t477 = Lambda_i_forearm_16 * carried_forearm_1 + Lambda_i_forearm_26 * carried_forearm_2
            + Lambda_i_forearm_36 * carried_forearm_3;
        const six_link_real t478 = t477 + Lambda_i_forearm_46 * carried_forearm_4
            + Lambda_i_forearm_56 * carried_forearm_5 + Lambda_i_forearm_66 * carried_forearm_6;
        const six_link_real wrench_forearm_1 = t468 + p_i_forearm_1;
        output->wrench[2][0] = wrench_forearm_1;
        const six_link_real wrench_forearm_2 = t470 + p_i_forearm_2;
        output->wrench[2][1] = wrench_forearm_2;
        const six_link_real wrench_forearm_3 = t472 + p_i_forearm_3;
        output->wrench[2][2] = wrench_forearm_3;
        const six_link_real wrench_forearm_4 = t474 + p_i_forearm_4;
        output->wrench[2][3] = wrench_forearm_4;
        const six_link_real wrench_forearm_5 = t476 + p_i_forearm_5;
        output->wrench[2][4] = wrench_forearm_5;
        const six_link_real wrench_forearm_6 = t478 + p_i_forearm_6;
        output->wrench[2][5] = wrench_forearm_6;

        /* joint wrench (48)_wrist_roll */
        const six_link_real t479 = Lambda_i_wrist_roll_11 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_12 * carried_wrist_roll_2 + Lambda_i_wrist_roll_13 * carried_wrist_roll_3;
        const six_link_real t480 = t479 + Lambda_i_wrist_roll_14 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_15 * carried_wrist_roll_5;
        const six_link_real t481 = Lambda_i_wrist_roll_12 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_22 * carried_wrist_roll_2 + Lambda_i_wrist_roll_23 * carried_wrist_roll_3;
        const six_link_real t482 = t481 + Lambda_i_wrist_roll_24 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_25 * carried_wrist_roll_5;
        const six_link_real t483 = Lambda_i_wrist_roll_13 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_23 * carried_wrist_roll_2 + Lambda_i_wrist_roll_33 * carried_wrist_roll_3;
        const six_link_real t484 = t483 + Lambda_i_wrist_roll_34 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_35 * carried_wrist_roll_5;
        const six_link_real t485 = Lambda_i_wrist_roll_14 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_24 * carried_wrist_roll_2 + Lambda_i_wrist_roll_34 * carried_wrist_roll_3;
        const six_link_real t486 = t485 + Lambda_i_wrist_roll_44 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_45 * carried_wrist_roll_5;
        const six_link_real t487 = Lambda_i_wrist_roll_15 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_25 * carried_wrist_roll_2 + Lambda_i_wrist_roll_35 * carried_wrist_roll_3;
        const six_link_real t488 = t487 + Lambda_i_wrist_roll_45 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_55 * carried_wrist_roll_5;
        const six_link_real t489 = Lambda_i_wrist_roll_16 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_26 * carried_wrist_roll_2 + Lambda_i_wrist_roll_36 * carried_wrist_roll_3;
        const six_link_real t490 = t489 - minus_Lambda_i_wrist_roll_46 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_56 * carried_wrist_roll_5;
        const six_link_real wrench_wrist_roll_1 = t480 + Lambda_i_wrist_roll_16 * carried_wrist_roll_6
            + p_i_wrist_roll_1;
        output->wrench[3][0] = wrench_wrist_roll_1;
        const six_link_real wrench_wrist_roll_2 = t482 + Lambda_i_wrist_roll_26 * carried_wrist_roll_6
            + p_i_wrist_roll_2;
        output->wrench[3][1] = wrench_wrist_roll_2;
        const six_link_real wrench_wrist_roll_3 = t484 + Lambda_i_wrist_roll_36 * carried_wrist_roll_6
            + p_i_wrist_roll_3;
        output->wrench[3][2] = wrench_wrist_roll_3;
        const six_link_real wrench_wrist_roll_4 = t486 - minus_Lambda_i_wrist_roll_46 * carried_wrist_roll_6
            + p_i_wrist_roll_4;
        output->wrench[3][3] = wrench_wrist_roll_4;
        const six_link_real wrench_wrist_roll_5 = t488 + Lambda_i_wrist_roll_56 * carried_wrist_roll_6
            + p_i_wrist_roll_5;
        output->wrench[3][4] = wrench_wrist_roll_5;
        const six_link_real wrench_wrist_roll_6 = t490 + Lambda_i_wrist_roll_66 * carried_wrist_roll_6
            + p_i_wrist_roll_6;
        output->wrench[3][5] = wrench_wrist_roll_6;

        /* joint wrench (48)_wrist_pitch */
        const six_link_real t491 = Lambda_i_wrist_pitch_11 * carried_wrist_pitch_1
            + Lambda_i_wrist_pitch_12 * carried_wrist_roll_2 + Lambda_i_wrist_pitch_13 * carried_wrist_pitch_3;
        const six_link_real t492 = t491 - minus_Lambda_i_wrist_pitch_14 * carried_wrist_pitch_4
            + Lambda_i_wrist_pitch_15 * delta_T_wrist_roll_5;
        const six_link_real t493 = Lambda_i_wrist_pitch_12 * carried_wrist_pitch_1
            + Lambda_i_wrist_pitch_22 * carried_wrist_roll_2 + Lambda_i_wrist_pitch_23 * carried_wrist_pitch_3;
        const six_link_real t494 = t493 + Lambda_i_wrist_pitch_24 * carried_wrist_pitch_4
            + Lambda_i_wrist_pitch_25 * delta_T_wrist_roll_5;
        const six_link_real t495 = Lambda_i_wrist_pitch_13 * carried_wrist_pitch_1
            + Lambda_i_wrist_pitch_23 * carried_wrist_roll_2 + Lambda_i_wrist_pitch_33 * carried_wrist_pitch_3;
        const six_link_real t496 = t495 + Lambda_i_wrist_pitch_34 * carried_wrist_pitch_4
            + Lambda_i_wrist_pitch_35 * delta_T_wrist_roll_5;
        const six_link_real t497 = Lambda_i_wrist_pitch_24 * carried_wrist_roll_2
            - minus_Lambda_i_wrist_pitch_14 * carried_wrist_pitch_1;
        const six_link_real t498 = t497 + Lambda_i_wrist_pitch_34 * carried_wrist_pitch_3
            + Lambda_i_wrist_pitch_44 * carried_wrist_pitch_4;
        const six_link_real t499 = t498 + Lambda_i_wrist_pitch_45 * delta_T_wrist_roll_5
            - minus_Lambda_i_wrist_pitch_46 * carried_wrist_pitch_6;
        const six_link_real t500 = Lambda_i_wrist_pitch_15 * carried_wrist_pitch_1
            + Lambda_i_wrist_pitch_25 * carried_wrist_roll_2 + Lambda_i_wrist_pitch_35 * carried_wrist_pitch_3;
        const six_link_real t501 = t500 + Lambda_i_wrist_pitch_45 * carried_wrist_pitch_4
            + Lambda_i_wrist_pitch_55 * delta_T_wrist_roll_5;
        const six_link_real t502 = Lambda_i_wrist_pitch_16 * carried_wrist_pitch_1
            + Lambda_i_wrist_pitch_26 * carried_wrist_roll_2 + Lambda_i_wrist_pitch_36 * carried_wrist_pitch_3;
        const six_link_real t503 = t502 - minus_Lambda_i_wrist_pitch_46 * carried_wrist_pitch_4
            + Lambda_i_wrist_pitch_56 * delta_T_wrist_roll_5;
        const six_link_real wrench_wrist_pitch_1 = t492 + Lambda_i_wrist_pitch_16 * carried_wrist_pitch_6
            + p_i_wrist_pitch_1;
        output->wrench[4][0] = wrench_wrist_pitch_1;
        const six_link_real wrench_wrist_pitch_2 = t494 + Lambda_i_wrist_pitch_26 * carried_wrist_pitch_6
            + p_i_wrist_pitch_2;
        output->wrench[4][1] = wrench_wrist_pitch_2;
        const six_link_real wrench_wrist_pitch_3 = t496 + Lambda_i_wrist_pitch_36 * carried_wrist_pitch_6
            + p_i_wrist_pitch_3;
        output->wrench[4][2] = wrench_wrist_pitch_3;
        const six_link_real wrench_wrist_pitch_4 = t499 + p_i_wrist_pitch_4;
        output->wrench[4][3] = wrench_wrist_pitch_4;
        const six_link_real wrench_wrist_pitch_5 = t501 + Lambda_i_wrist_pitch_56 * carried_wrist_pitch_6
            + p_i_wrist_pitch_5;
        output->wrench[4][4] = wrench_wrist_pitch_5;
        const six_link_real wrench_wrist_pitch_6 = t503 + Lambda_i_wrist_pitch_66 * carried_wrist_pitch_6
            + p_i_wrist_pitch_6;
        output->wrench[4][5] = wrench_wrist_pitch_6;

        /* joint wrench (48)_flange */
        const six_link_real t504 = Lambda_i_flange_11 * carried_wrist_pitch_1 + Lambda_i_flange_12 * carried_flange_2
            + Lambda_i_flange_13 * carried_flange_3;
        const six_link_real t505 = Lambda_i_flange_12 * carried_wrist_pitch_1 + Lambda_i_flange_22 * carried_flange_2
            - minus_Lambda_i_flange_23 * carried_flange_3;
        const six_link_real t506 = t505 + c->links[5].S_T_z * carried_wrist_pitch_4
            - minus_Lambda_i_flange_25 * carried_flange_5 + Lambda_i_flange_26 * carried_flange_6;
        const six_link_real t507 = Lambda_i_flange_13 * carried_wrist_pitch_1
            - minus_Lambda_i_flange_23 * carried_flange_2 + Lambda_i_flange_33 * carried_flange_3;
        const six_link_real t508 = t507 - c->links[5].S_T_y * carried_wrist_pitch_4
            + Lambda_i_flange_35 * carried_flange_5 + Lambda_i_flange_36 * carried_flange_6;
        const six_link_real t509 = c->links[5].S_T_z * carried_flange_2 - c->links[5].S_T_y * carried_flange_3
            + M_loaded_flange_44 * carried_wrist_pitch_4;
        const six_link_real t510 = Lambda_i_flange_15 * carried_wrist_pitch_1
            - minus_Lambda_i_flange_25 * carried_flange_2 + Lambda_i_flange_35 * carried_flange_3;
        const six_link_real t511 = Lambda_i_flange_16 * carried_wrist_pitch_1 + Lambda_i_flange_26 * carried_flange_2
            + Lambda_i_flange_36 * carried_flange_3;
        const six_link_real wrench_flange_1 = t504 + Lambda_i_flange_15 * carried_flange_5
            + Lambda_i_flange_16 * carried_flange_6 + p_i_flange_1;
        output->wrench[5][0] = wrench_flange_1;
        const six_link_real wrench_flange_2 = t506 + p_i_flange_2;
        output->wrench[5][1] = wrench_flange_2;
        const six_link_real wrench_flange_3 = t508 + p_i_flange_3;
        output->wrench[5][2] = wrench_flange_3;
        const six_link_real wrench_flange_4 = t509 + h_loaded_flange_4;
        output->wrench[5][3] = wrench_flange_4;
        const six_link_real wrench_flange_5 = t510 + Lambda_i_flange_55 * carried_flange_5
            + Lambda_i_flange_56 * carried_flange_6 + p_i_flange_5;
        output->wrench[5][4] = wrench_flange_5;
        const six_link_real wrench_flange_6 = t511 + Lambda_i_flange_56 * carried_flange_5
            + Lambda_i_flange_66 * carried_flange_6 + p_i_flange_6;
        output->wrench[5][5] = wrench_flange_6;
    }

    if (wanted & SIX_LINK_TIP_POSE) {
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
        const six_link_real t512 = R_upper_arm_xx * c->links[1].length - minus_R_rel_shoulder_xy * r_T_upper_arm_y
            + R_upper_arm_xz * r_T_upper_arm_z;
        const six_link_real t513 = R_upper_arm_yx * c->links[1].length + R_rel_shoulder_xx * r_T_upper_arm_y
            + R_upper_arm_yz * r_T_upper_arm_z;
        const six_link_real r_tip_upper_arm_x = r_upper_arm_x + t512;
        const six_link_real r_tip_upper_arm_y = r_upper_arm_y + t513;
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
        const six_link_real t514 = R_tip_upper_arm_xx * c->links[2].mount_xyz_x
            + R_tip_upper_arm_xy * c->links[2].mount_xyz_y + R_tip_upper_arm_xz * c->links[2].mount_xyz_z;
        const six_link_real t515 = R_tip_upper_arm_yx * c->links[2].mount_xyz_x
            + R_tip_upper_arm_yy * c->links[2].mount_xyz_y + R_tip_upper_arm_yz * c->links[2].mount_xyz_z;
        const six_link_real t516 = R_tip_upper_arm_zx * c->links[2].mount_xyz_x
            + R_tip_upper_arm_zy * c->links[2].mount_xyz_y + R_tip_upper_arm_zz * c->links[2].mount_xyz_z;
        const six_link_real r_forearm_x = r_tip_upper_arm_x + t514;
        const six_link_real r_forearm_y = r_tip_upper_arm_y + t515;
        const six_link_real r_forearm_z = r_tip_upper_arm_z + t516;

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
    }

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

six_link_status six_link_inverse_dynamics(const six_link_constants *c, const six_link_state *state, const six_link_input *input,
    const six_link_real vdot[], six_link_chain *chain, six_link_real force[], six_link_real wrench[][6])
{
    six_link_real f_eta[SIX_LINK_LENGTH(SIX_LINK_NMODES)];
    six_link_call call = { 0 };
    six_link_status status;
    int k, fault = 0;
    if (!c || !state || !input || !vdot || !chain || !force) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    for (k = 0; k < SIX_LINK_NMODES; ++k) {
        f_eta[k] = c->K[k] * state->q[SIX_LINK_NTAU + k] + c->D[k] * state->v[SIX_LINK_NTAU + k];
    }
    call.gravity = c->gravity;
    call.q = state->q;
    call.qdot = state->v;
    call.eta = state->q + SIX_LINK_NTAU;
    call.etadot = state->v + SIX_LINK_NTAU;
    call.w_ext = &input->w_ext[0][0];
    call.m_eta = c->M_eta;
    call.f_eta = f_eta;
    call.given_qddot = vdot;
    call.given_etaddot = vdot + SIX_LINK_NTAU;
    call.force = force;
    call.force_eta = force + SIX_LINK_NTAU;
    call.wrench = wrench ? &wrench[0][0] : 0;
    status = six_link_inverse(c, &call, chain, &fault);
    if (status == SIX_LINK_OK && !(six_link_finite(force, SIX_LINK_NV) && six_link_finite(call.w_ext, 6 * SIX_LINK_NLINKS))) {
        return SIX_LINK_NONFINITE;
    }
    return status;
}

six_link_status six_link_mass_matrix(const six_link_constants *c, const six_link_state *state, six_link_chain *chain,
    six_link_real M[][SIX_LINK_LENGTH(SIX_LINK_NV)])
{
    six_link_real unit[SIX_LINK_LENGTH(SIX_LINK_NV)] = { 0 };
    six_link_call call = { 0 };
    six_link_status status;
    int j, fault = 0;
    if (!c || !state || !chain || !M) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    call.q = state->q;
    call.eta = state->q + SIX_LINK_NTAU;
    call.m_eta = c->M_eta;
    call.given_qddot = unit;
    call.given_etaddot = unit + SIX_LINK_NTAU;
    status = six_link_inertia_posture(c, &call, chain, &fault);
    for (j = 0; j < SIX_LINK_NV && status == SIX_LINK_OK; ++j) {
        unit[j] = 1;
        call.force = M[j];
        call.force_eta = M[j] + SIX_LINK_NTAU;
        status = six_link_inertia_column(c, &call, chain, &fault);
        unit[j] = 0;
        if (!six_link_finite(M[j], SIX_LINK_NV)) {
            status = SIX_LINK_NONFINITE;
        }
    }
    return status;
}
