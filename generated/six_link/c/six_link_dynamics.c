/* six_link_dynamics.c: forward dynamics of the joint form by block elimination, tip to base;
 * inverse dynamics and mass matrix.
 */
#include "six_link_links.h"

/* The whole chain in one function: outward kinematics, inward elimination, outward accelerations. */
SIX_LINK_TARGETS six_link_status six_link_dynamics(const six_link_constants *c, const six_link_state *state,
    const six_link_input *input,
    const six_link_real *m_eta, six_link_work *work, int wanted, six_link_output *output)
{
    unsigned long bad = 0; /* bit i: the joint or a mode of link i cannot be solved for */
    int link;

    /* shoulder, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(state->q[0]);
    const six_link_real minus_R_rel_shoulder_xy = turn.sine, R_rel_shoulder_xx = turn.cosine;

    /* acceleration of the parent's tip in F_i axes_shoulder */
    const six_link_real minus_a_J_shoulder_x = R_rel_shoulder_xx * c->gravity[0]
        + minus_R_rel_shoulder_xy * c->gravity[1];
    const six_link_real a_J_shoulder_y = minus_R_rel_shoulder_xy * c->gravity[0] - R_rel_shoulder_xx * c->gravity[1];

    /* shoulder, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real minus_Omega_shoulder_xx = state->v[0] * state->v[0];
    const six_link_real minus_a_t_shoulder_x = minus_a_J_shoulder_x + c->links[0].length * minus_Omega_shoulder_xx;

    /* upper_arm, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_2 = six_link_sine_cosine(state->q[1]);
    const six_link_real R_rel_upper_arm_xz = turn_2.sine, R_rel_upper_arm_xx = turn_2.cosine;

    /* upper_arm, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real minus_omega_R_upper_arm_1 = R_rel_upper_arm_xz * state->v[0];
    const six_link_real omega_R_upper_arm_3 = R_rel_upper_arm_xx * state->v[0];

    /* acceleration of the parent's tip in F_i axes_upper_arm */
    const six_link_real t1 = R_rel_upper_arm_xz * c->gravity[2] - R_rel_upper_arm_xx * minus_a_t_shoulder_x;
    const six_link_real t2 = R_rel_upper_arm_xz * minus_a_t_shoulder_x + R_rel_upper_arm_xx * c->gravity[2];

    /* upper_arm, alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real minus_alpha_upper_arm_x = omega_R_upper_arm_3 * state->v[1];
    const six_link_real minus_alpha_upper_arm_z = minus_omega_R_upper_arm_1 * state->v[1];

    /* upper_arm, r_R: joint point relative to the parent's tip point */
    const six_link_real r_R_upper_arm_x = R_rel_upper_arm_xx * c->links[1].mount_xyz_x
        - R_rel_upper_arm_xz * c->links[1].mount_xyz_z;
    const six_link_real r_R_upper_arm_z = R_rel_upper_arm_xz * c->links[1].mount_xyz_x
        + R_rel_upper_arm_xx * c->links[1].mount_xyz_z;

    /* upper_arm, a_J: acceleration of the joint point while no joint accelerates (accconst4) */
    const six_link_real t3 = omega_R_upper_arm_3 * r_R_upper_arm_x + minus_omega_R_upper_arm_1 * r_R_upper_arm_z;
    const six_link_real a_J_upper_arm_x = t1 - omega_R_upper_arm_3 * t3;
    const six_link_real a_J_upper_arm_y = a_J_shoulder_y
        - omega_R_upper_arm_3 * (c->links[1].mount_xyz_y * omega_R_upper_arm_3)
        - minus_omega_R_upper_arm_1 * (c->links[1].mount_xyz_y * minus_omega_R_upper_arm_1);
    const six_link_real minus_a_J_upper_arm_z = t2 + minus_omega_R_upper_arm_1 * t3;

    /* upper_arm, r_T: tip point (11) */
    const six_link_real r_T_upper_arm_y = state->q[7] * REAL(2.8145226674626453)
        + state->q[6] * REAL(2.0195202782688155);
    const six_link_real r_T_upper_arm_z = state->q[9] * REAL(2.8145226674626453)
        + state->q[8] * REAL(2.0195202782688155);

    /* upper_arm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_upper_arm_x = state->q[10] * REAL(1.7320508075688772);
    const six_link_real theta_upper_arm_y = c->links[1].Psi_c_y3 * state->q[8] + c->links[1].Psi_c_y4 * state->q[9];
    const six_link_real theta_upper_arm_z = c->links[1].Psi_c_z1 * state->q[6] + c->links[1].Psi_c_z2 * state->q[7];

    /* upper_arm, x: squared angle of the tip section */
    const six_link_real t4 = theta_upper_arm_x * theta_upper_arm_x;
    const six_link_real t5 = theta_upper_arm_y * theta_upper_arm_y;
    const six_link_real minus_theta_hat2_upper_arm_33 = t4 + t5;
    const six_link_real t6 = theta_upper_arm_z * theta_upper_arm_z;
    const six_link_real x_upper_arm = minus_theta_hat2_upper_arm_33 + t6;

    /* upper_arm, c2: Stumpff function of order 2 */
    const six_link_real t7 = six_link_c4(x_upper_arm);
    const six_link_real c2_upper_arm = REAL(0.5) - x_upper_arm * t7;

    /* upper_arm, c3: Stumpff function of order 3 */
    const six_link_real t8 = six_link_c5(x_upper_arm);
    const six_link_real c3_upper_arm = REAL(0.16666666666666666) - x_upper_arm * t8;

    /* upper_arm, udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_upper_arm_y = state->v[7] * REAL(2.8145226674626453)
        + state->v[6] * REAL(2.0195202782688155);
    const six_link_real udot_T_upper_arm_z = state->v[9] * REAL(2.8145226674626453)
        + state->v[8] * REAL(2.0195202782688155);

    /* upper_arm, thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_upper_arm_x = state->v[10] * REAL(1.7320508075688772);
    const six_link_real thetadot_upper_arm_y = c->links[1].Psi_c_y3 * state->v[8] + c->links[1].Psi_c_y4 * state->v[9];
    const six_link_real thetadot_upper_arm_z = c->links[1].Psi_c_z1 * state->v[6] + c->links[1].Psi_c_z2 * state->v[7];

    /* upper_arm, omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t9 = theta_upper_arm_y * thetadot_upper_arm_z - theta_upper_arm_z * thetadot_upper_arm_y;
    const six_link_real t10 = theta_upper_arm_x * thetadot_upper_arm_y - theta_upper_arm_y * thetadot_upper_arm_x;
    const six_link_real t11 = theta_upper_arm_z * thetadot_upper_arm_x - theta_upper_arm_x * thetadot_upper_arm_z;
    const six_link_real t12 = theta_upper_arm_y * t10 - theta_upper_arm_z * t11;
    const six_link_real omega_s_upper_arm_x = thetadot_upper_arm_x + c2_upper_arm * t9 + c3_upper_arm * t12;
    const six_link_real t13 = theta_upper_arm_z * t9 - theta_upper_arm_x * t10;
    const six_link_real omega_s_upper_arm_y = thetadot_upper_arm_y + c2_upper_arm * t11 + c3_upper_arm * t13;
    const six_link_real t14 = theta_upper_arm_x * t11 - theta_upper_arm_y * t9;
    const six_link_real omega_s_upper_arm_z = thetadot_upper_arm_z + c2_upper_arm * t10 + c3_upper_arm * t14;

    /* upper_arm, xdot: rate of the squared angle */
    const six_link_real t15 = state->q[10] * REAL(3.4641016151377544) * thetadot_upper_arm_x
        + theta_upper_arm_y * 2 * thetadot_upper_arm_y;
    const six_link_real xdot_upper_arm = t15 + theta_upper_arm_z * 2 * thetadot_upper_arm_z;

    /* upper_arm, c2dot: rate of c2 */
    const six_link_real c2dot_upper_arm = xdot_upper_arm * (t7 - c3_upper_arm * REAL(0.5));

    /* upper_arm, c3dot: rate of c3 */
    const six_link_real c3dot_upper_arm = xdot_upper_arm * (t8 * REAL(1.5) - t7 * REAL(0.5));

    /* upper_arm, alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_upper_arm_x = c2dot_upper_arm * t9
        + c3_upper_arm * (thetadot_upper_arm_y * t10 - thetadot_upper_arm_z * t11) + c3dot_upper_arm * t12;
    const six_link_real alpha_s_upper_arm_y = c2dot_upper_arm * t11
        + c3_upper_arm * (thetadot_upper_arm_z * t9 - thetadot_upper_arm_x * t10) + c3dot_upper_arm * t13;
    const six_link_real alpha_s_upper_arm_z = c2dot_upper_arm * t10
        + c3_upper_arm * (thetadot_upper_arm_x * t11 - thetadot_upper_arm_y * t9) + c3dot_upper_arm * t14;

    /* upper_arm, omega_t: angular velocity of the tip section (46) */
    const six_link_real omega_t_upper_arm_x = omega_s_upper_arm_x - minus_omega_R_upper_arm_1;
    const six_link_real omega_t_upper_arm_y = omega_s_upper_arm_y + state->v[1];
    const six_link_real omega_t_upper_arm_z = omega_s_upper_arm_z + omega_R_upper_arm_3;

    /* upper_arm, alpha_t: angular acceleration of the tip section (accconst1b) */
    const six_link_real alpha_t_upper_arm_x = alpha_s_upper_arm_x - minus_alpha_upper_arm_x
        + omega_s_upper_arm_z * state->v[1] - omega_s_upper_arm_y * omega_R_upper_arm_3;
    const six_link_real alpha_t_upper_arm_y = alpha_s_upper_arm_y + omega_s_upper_arm_x * omega_R_upper_arm_3
        + omega_s_upper_arm_z * minus_omega_R_upper_arm_1;
    const six_link_real alpha_t_upper_arm_z = alpha_s_upper_arm_z - minus_alpha_upper_arm_z
        - omega_s_upper_arm_y * minus_omega_R_upper_arm_1 - omega_s_upper_arm_x * state->v[1];

    /* upper_arm, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t16 = udot_T_upper_arm_z * 2 - minus_omega_R_upper_arm_1 * r_T_upper_arm_y
        - c->links[1].length * state->v[1];
    const six_link_real t17 = udot_T_upper_arm_y * 2 + c->links[1].length * omega_R_upper_arm_3
        + minus_omega_R_upper_arm_1 * r_T_upper_arm_z;
    const six_link_real a_t_upper_arm_x = a_J_upper_arm_x + state->v[1] * t16
        + minus_alpha_upper_arm_z * r_T_upper_arm_y - omega_R_upper_arm_3 * t17;
    const six_link_real t18 = state->v[1] * r_T_upper_arm_z - omega_R_upper_arm_3 * r_T_upper_arm_y;
    const six_link_real t19 = a_J_upper_arm_y - minus_alpha_upper_arm_z * c->links[1].length
        + omega_R_upper_arm_3 * t18 + minus_alpha_upper_arm_x * r_T_upper_arm_z;
    const six_link_real a_t_upper_arm_y = t19 + minus_omega_R_upper_arm_1 * t16;
    const six_link_real t20 = minus_a_J_upper_arm_z + minus_alpha_upper_arm_x * r_T_upper_arm_y
        + minus_omega_R_upper_arm_1 * t17;
    const six_link_real minus_a_t_upper_arm_z = t20 + state->v[1] * t18;

    /* upper_arm, c1: Stumpff function of order 1 */
    const six_link_real c1_upper_arm = 1 - x_upper_arm * c3_upper_arm;

    /* upper_arm, theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real minus_theta_hat2_upper_arm_11 = t5 + t6;
    const six_link_real theta_hat2_upper_arm_12 = theta_upper_arm_x * theta_upper_arm_y;
    const six_link_real theta_hat2_upper_arm_13 = theta_upper_arm_x * theta_upper_arm_z;
    const six_link_real minus_theta_hat2_upper_arm_22 = t4 + t6;
    const six_link_real theta_hat2_upper_arm_23 = theta_upper_arm_y * theta_upper_arm_z;

    /* upper_arm, J_l: left Jacobian of the exponential */
    const six_link_real J_l_upper_arm_xx = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_11;
    const six_link_real t21 = c3_upper_arm * theta_hat2_upper_arm_12;
    const six_link_real t22 = c2_upper_arm * theta_upper_arm_z;
    const six_link_real J_l_upper_arm_xy = t21 - t22;
    const six_link_real t23 = c2_upper_arm * theta_upper_arm_y;
    const six_link_real t24 = c3_upper_arm * theta_hat2_upper_arm_13;
    const six_link_real J_l_upper_arm_xz = t23 + t24;
    const six_link_real J_l_upper_arm_yx = t22 + t21;
    const six_link_real J_l_upper_arm_yy = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_22;
    const six_link_real t25 = c3_upper_arm * theta_hat2_upper_arm_23;
    const six_link_real t26 = c2_upper_arm * theta_upper_arm_x;
    const six_link_real J_l_upper_arm_yz = t25 - t26;
    const six_link_real J_l_upper_arm_zx = t24 - t23;
    const six_link_real J_l_upper_arm_zy = t26 + t25;
    const six_link_real J_l_upper_arm_zz = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_33;

    /* upper_arm, R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_upper_arm_xx = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_11;
    const six_link_real t27 = c2_upper_arm * theta_hat2_upper_arm_12;
    const six_link_real t28 = c1_upper_arm * theta_upper_arm_z;
    const six_link_real R_T_upper_arm_xy = t27 - t28;
    const six_link_real t29 = c1_upper_arm * theta_upper_arm_y;
    const six_link_real t30 = c2_upper_arm * theta_hat2_upper_arm_13;
    const six_link_real R_T_upper_arm_xz = t29 + t30;
    const six_link_real R_T_upper_arm_yx = t28 + t27;
    const six_link_real R_T_upper_arm_yy = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_22;
    const six_link_real t31 = c2_upper_arm * theta_hat2_upper_arm_23;
    const six_link_real t32 = c1_upper_arm * theta_upper_arm_x;
    const six_link_real R_T_upper_arm_yz = t31 - t32;
    const six_link_real R_T_upper_arm_zx = t30 - t29;
    const six_link_real R_T_upper_arm_zy = t32 + t31;
    const six_link_real R_T_upper_arm_zz = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_33;

    /* forearm, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_3 = six_link_sine_cosine(state->q[2]);
    const six_link_real t33 = turn_3.sine, t34 = turn_3.cosine;
    const six_link_real R_rel_forearm_xx = c->links[2].R_m_xx * t34 - c->links[2].R_m_xz * t33;
    const six_link_real R_rel_forearm_xz = c->links[2].R_m_xx * t33 + c->links[2].R_m_xz * t34;
    const six_link_real R_rel_forearm_yx = c->links[2].R_m_yx * t34 - c->links[2].R_m_yz * t33;
    const six_link_real R_rel_forearm_yz = c->links[2].R_m_yx * t33 + c->links[2].R_m_yz * t34;
    const six_link_real R_rel_forearm_zx = c->links[2].R_m_zx * t34 - c->links[2].R_m_zz * t33;
    const six_link_real R_rel_forearm_zz = c->links[2].R_m_zx * t33 + c->links[2].R_m_zz * t34;

    /* forearm, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_forearm_11 = R_T_upper_arm_xx * R_rel_forearm_xx + R_T_upper_arm_xy * R_rel_forearm_yx
        + R_T_upper_arm_xz * R_rel_forearm_zx;
    const six_link_real R_P_forearm_12 = R_T_upper_arm_xx * c->links[2].R_m_xy + R_T_upper_arm_xy * c->links[2].R_m_yy
        + R_T_upper_arm_xz * c->links[2].R_m_zy;
    const six_link_real R_P_forearm_13 = R_T_upper_arm_xx * R_rel_forearm_xz + R_T_upper_arm_xy * R_rel_forearm_yz
        + R_T_upper_arm_xz * R_rel_forearm_zz;
    const six_link_real R_P_forearm_21 = R_T_upper_arm_yx * R_rel_forearm_xx + R_T_upper_arm_yy * R_rel_forearm_yx
        + R_T_upper_arm_yz * R_rel_forearm_zx;
    const six_link_real R_P_forearm_22 = R_T_upper_arm_yx * c->links[2].R_m_xy + R_T_upper_arm_yy * c->links[2].R_m_yy
        + R_T_upper_arm_yz * c->links[2].R_m_zy;
    const six_link_real R_P_forearm_23 = R_T_upper_arm_yx * R_rel_forearm_xz + R_T_upper_arm_yy * R_rel_forearm_yz
        + R_T_upper_arm_yz * R_rel_forearm_zz;
    const six_link_real R_P_forearm_31 = R_T_upper_arm_zx * R_rel_forearm_xx + R_T_upper_arm_zy * R_rel_forearm_yx
        + R_T_upper_arm_zz * R_rel_forearm_zx;
    const six_link_real R_P_forearm_32 = R_T_upper_arm_zx * c->links[2].R_m_xy + R_T_upper_arm_zy * c->links[2].R_m_yy
        + R_T_upper_arm_zz * c->links[2].R_m_zy;
    const six_link_real R_P_forearm_33 = R_T_upper_arm_zx * R_rel_forearm_xz + R_T_upper_arm_zy * R_rel_forearm_yz
        + R_T_upper_arm_zz * R_rel_forearm_zz;
    const six_link_real omega_R_forearm_1 = R_P_forearm_11 * omega_t_upper_arm_x
        + R_P_forearm_21 * omega_t_upper_arm_y + R_P_forearm_31 * omega_t_upper_arm_z;
    const six_link_real omega_R_forearm_2 = R_P_forearm_12 * omega_t_upper_arm_x
        + R_P_forearm_22 * omega_t_upper_arm_y + R_P_forearm_32 * omega_t_upper_arm_z;
    const six_link_real omega_R_forearm_3 = R_P_forearm_13 * omega_t_upper_arm_x
        + R_P_forearm_23 * omega_t_upper_arm_y + R_P_forearm_33 * omega_t_upper_arm_z;

    /* acceleration of the parent's tip in F_i axes_forearm */
    const six_link_real t35 = R_P_forearm_11 * alpha_t_upper_arm_x + R_P_forearm_21 * alpha_t_upper_arm_y
        + R_P_forearm_31 * alpha_t_upper_arm_z;
    const six_link_real alpha_0_forearm_2 = R_P_forearm_12 * alpha_t_upper_arm_x
        + R_P_forearm_22 * alpha_t_upper_arm_y + R_P_forearm_32 * alpha_t_upper_arm_z;
    const six_link_real t36 = R_P_forearm_13 * alpha_t_upper_arm_x + R_P_forearm_23 * alpha_t_upper_arm_y
        + R_P_forearm_33 * alpha_t_upper_arm_z;
    const six_link_real t37 = R_P_forearm_11 * a_t_upper_arm_x + R_P_forearm_21 * a_t_upper_arm_y
        - R_P_forearm_31 * minus_a_t_upper_arm_z;
    const six_link_real t38 = R_P_forearm_12 * a_t_upper_arm_x + R_P_forearm_22 * a_t_upper_arm_y
        - R_P_forearm_32 * minus_a_t_upper_arm_z;
    const six_link_real t39 = R_P_forearm_13 * a_t_upper_arm_x + R_P_forearm_23 * a_t_upper_arm_y
        - R_P_forearm_33 * minus_a_t_upper_arm_z;

    /* forearm, omega: angular velocity of the link (45) */
    const six_link_real omega_forearm_y = omega_R_forearm_2 + state->v[2];

    /* forearm, alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_forearm_x = t35 - omega_R_forearm_3 * state->v[2];
    const six_link_real alpha_forearm_z = t36 + omega_R_forearm_1 * state->v[2];

    /* forearm, r_R: joint point relative to the parent's tip point */
    const six_link_real r_R_forearm_x = R_rel_forearm_xx * c->links[2].mount_xyz_x
        + R_rel_forearm_yx * c->links[2].mount_xyz_y + R_rel_forearm_zx * c->links[2].mount_xyz_z;
    const six_link_real r_R_forearm_y = c->links[2].R_m_xy * c->links[2].mount_xyz_x
        + c->links[2].R_m_yy * c->links[2].mount_xyz_y + c->links[2].R_m_zy * c->links[2].mount_xyz_z;
    const six_link_real r_R_forearm_z = R_rel_forearm_xz * c->links[2].mount_xyz_x
        + R_rel_forearm_yz * c->links[2].mount_xyz_y + R_rel_forearm_zz * c->links[2].mount_xyz_z;

    /* forearm, a_J: acceleration of the joint point while no joint accelerates (accconst4) */
    const six_link_real t40 = omega_R_forearm_1 * r_R_forearm_y - omega_R_forearm_2 * r_R_forearm_x;
    const six_link_real t41 = omega_R_forearm_3 * r_R_forearm_x - omega_R_forearm_1 * r_R_forearm_z;
    const six_link_real a_J_forearm_x = t37 + alpha_0_forearm_2 * r_R_forearm_z + omega_R_forearm_2 * t40
        - t36 * r_R_forearm_y - omega_R_forearm_3 * t41;
    const six_link_real t42 = omega_R_forearm_2 * r_R_forearm_z - omega_R_forearm_3 * r_R_forearm_y;
    const six_link_real a_J_forearm_y = t38 + t36 * r_R_forearm_x + omega_R_forearm_3 * t42 - t35 * r_R_forearm_z
        - omega_R_forearm_1 * t40;
    const six_link_real a_J_forearm_z = t39 + t35 * r_R_forearm_y + omega_R_forearm_1 * t41
        - alpha_0_forearm_2 * r_R_forearm_x - omega_R_forearm_2 * t42;

    /* forearm, r_T: tip point (11) */
    const six_link_real r_T_forearm_y = state->q[12] * REAL(2.8145226674626453)
        + state->q[11] * REAL(2.0195202782688155);
    const six_link_real r_T_forearm_z = state->q[14] * REAL(2.8145226674626453)
        + state->q[13] * REAL(2.0195202782688155);

    /* forearm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_forearm_y = c->links[2].Psi_c_y3 * state->q[13] + c->links[2].Psi_c_y4 * state->q[14];
    const six_link_real theta_forearm_z = c->links[2].Psi_c_z1 * state->q[11] + c->links[2].Psi_c_z2 * state->q[12];

    /* forearm, x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_forearm_33 = theta_forearm_y * theta_forearm_y;
    const six_link_real minus_theta_hat2_forearm_22 = theta_forearm_z * theta_forearm_z;
    const six_link_real x_forearm = minus_theta_hat2_forearm_33 + minus_theta_hat2_forearm_22;

    /* forearm, c2: Stumpff function of order 2 */
    const six_link_real t43 = six_link_c4(x_forearm);
    const six_link_real c2_forearm = REAL(0.5) - x_forearm * t43;

    /* forearm, c3: Stumpff function of order 3 */
    const six_link_real t44 = six_link_c5(x_forearm);
    const six_link_real c3_forearm = REAL(0.16666666666666666) - x_forearm * t44;

    /* forearm, udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_forearm_y = state->v[12] * REAL(2.8145226674626453)
        + state->v[11] * REAL(2.0195202782688155);
    const six_link_real udot_T_forearm_z = state->v[14] * REAL(2.8145226674626453)
        + state->v[13] * REAL(2.0195202782688155);

    /* forearm, thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_forearm_y = c->links[2].Psi_c_y3 * state->v[13] + c->links[2].Psi_c_y4 * state->v[14];
    const six_link_real thetadot_forearm_z = c->links[2].Psi_c_z1 * state->v[11] + c->links[2].Psi_c_z2 * state->v[12];

    /* forearm, omega_s: angular velocity of the tip section relative to F_i */
    const six_link_real t45 = theta_forearm_y * thetadot_forearm_z - theta_forearm_z * thetadot_forearm_y;
    const six_link_real omega_s_forearm_x = c2_forearm * t45;
    const six_link_real omega_s_forearm_y = thetadot_forearm_y + c3_forearm * theta_forearm_z * t45;
    const six_link_real omega_s_forearm_z = thetadot_forearm_z - c3_forearm * theta_forearm_y * t45;

    /* forearm, xdot: rate of the squared angle */
    const six_link_real xdot_forearm = theta_forearm_y * 2 * thetadot_forearm_y
        + theta_forearm_z * 2 * thetadot_forearm_z;

    /* forearm, c2dot: rate of c2 */
    const six_link_real c2dot_forearm = xdot_forearm * (t43 - c3_forearm * REAL(0.5));

    /* forearm, c3dot: rate of c3 */
    const six_link_real c3dot_forearm = xdot_forearm * (t44 * REAL(1.5) - t43 * REAL(0.5));

    /* forearm, alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_forearm_x = c2dot_forearm * t45;
    const six_link_real alpha_s_forearm_y = c3_forearm * thetadot_forearm_z * t45
        + c3dot_forearm * theta_forearm_z * t45;
    const six_link_real minus_alpha_s_forearm_z = c3_forearm * thetadot_forearm_y * t45
        + c3dot_forearm * theta_forearm_y * t45;

    /* forearm, omega_t: angular velocity of the tip section (46) */
    const six_link_real omega_t_forearm_x = omega_s_forearm_x + omega_R_forearm_1;
    const six_link_real omega_t_forearm_y = omega_s_forearm_y + omega_forearm_y;
    const six_link_real omega_t_forearm_z = omega_s_forearm_z + omega_R_forearm_3;

    /* forearm, alpha_t: angular acceleration of the tip section (accconst1b) */
    const six_link_real alpha_t_forearm_x = alpha_s_forearm_x + alpha_forearm_x + omega_s_forearm_z * omega_forearm_y
        - omega_s_forearm_y * omega_R_forearm_3;
    const six_link_real alpha_t_forearm_y = alpha_s_forearm_y + alpha_0_forearm_2
        + omega_s_forearm_x * omega_R_forearm_3 - omega_s_forearm_z * omega_R_forearm_1;
    const six_link_real alpha_t_forearm_z = alpha_forearm_z - minus_alpha_s_forearm_z
        + omega_s_forearm_y * omega_R_forearm_1 - omega_s_forearm_x * omega_forearm_y;

    /* forearm, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t46 = udot_T_forearm_z * 2 + omega_R_forearm_1 * r_T_forearm_y
        - c->links[2].length * omega_forearm_y;
    const six_link_real t47 = a_J_forearm_x + alpha_0_forearm_2 * r_T_forearm_z + omega_forearm_y * t46
        - alpha_forearm_z * r_T_forearm_y;
    const six_link_real t48 = udot_T_forearm_y * 2 + c->links[2].length * omega_R_forearm_3
        - omega_R_forearm_1 * r_T_forearm_z;
    const six_link_real a_t_forearm_x = t47 - omega_R_forearm_3 * t48;
    const six_link_real t49 = omega_forearm_y * r_T_forearm_z - omega_R_forearm_3 * r_T_forearm_y;
    const six_link_real t50 = a_J_forearm_y + alpha_forearm_z * c->links[2].length + omega_R_forearm_3 * t49
        - alpha_forearm_x * r_T_forearm_z;
    const six_link_real a_t_forearm_y = t50 - omega_R_forearm_1 * t46;
    const six_link_real t51 = a_J_forearm_z + alpha_forearm_x * r_T_forearm_y + omega_R_forearm_1 * t48
        - alpha_0_forearm_2 * c->links[2].length;
    const six_link_real a_t_forearm_z = t51 - omega_forearm_y * t49;

    /* forearm, c1: Stumpff function of order 1 */
    const six_link_real c1_forearm = 1 - x_forearm * c3_forearm;

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

    /* wrist_roll, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_4 = six_link_sine_cosine(state->q[3]);
    const six_link_real minus_R_rel_wrist_roll_yz = turn_4.sine, R_rel_wrist_roll_yy = turn_4.cosine;

    /* wrist_roll, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_wrist_roll_12 = R_T_forearm_xz * minus_R_rel_wrist_roll_yz
        - minus_R_T_forearm_xy * R_rel_wrist_roll_yy;
    const six_link_real R_P_wrist_roll_13 = R_T_forearm_xz * R_rel_wrist_roll_yy
        + minus_R_T_forearm_xy * minus_R_rel_wrist_roll_yz;
    const six_link_real t52 = R_T_forearm_yz * minus_R_rel_wrist_roll_yz;
    const six_link_real R_P_wrist_roll_22 = R_T_forearm_yy * R_rel_wrist_roll_yy + t52;
    const six_link_real t53 = R_T_forearm_yz * R_rel_wrist_roll_yy;
    const six_link_real R_P_wrist_roll_23 = t53 - R_T_forearm_yy * minus_R_rel_wrist_roll_yz;
    const six_link_real R_P_wrist_roll_32 = t53 + R_T_forearm_zz * minus_R_rel_wrist_roll_yz;
    const six_link_real R_P_wrist_roll_33 = R_T_forearm_zz * R_rel_wrist_roll_yy - t52;
    const six_link_real omega_R_wrist_roll_1 = R_T_forearm_xx * omega_t_forearm_x
        + minus_R_T_forearm_xy * omega_t_forearm_y - R_T_forearm_xz * omega_t_forearm_z;
    const six_link_real omega_R_wrist_roll_2 = R_P_wrist_roll_12 * omega_t_forearm_x
        + R_P_wrist_roll_22 * omega_t_forearm_y + R_P_wrist_roll_32 * omega_t_forearm_z;
    const six_link_real omega_R_wrist_roll_3 = R_P_wrist_roll_13 * omega_t_forearm_x
        + R_P_wrist_roll_23 * omega_t_forearm_y + R_P_wrist_roll_33 * omega_t_forearm_z;

    /* acceleration of the parent's tip in F_i axes_wrist_roll */
    const six_link_real alpha_0_wrist_roll_1 = R_T_forearm_xx * alpha_t_forearm_x
        + minus_R_T_forearm_xy * alpha_t_forearm_y - R_T_forearm_xz * alpha_t_forearm_z;
    const six_link_real t54 = R_P_wrist_roll_12 * alpha_t_forearm_x + R_P_wrist_roll_22 * alpha_t_forearm_y
        + R_P_wrist_roll_32 * alpha_t_forearm_z;
    const six_link_real t55 = R_P_wrist_roll_13 * alpha_t_forearm_x + R_P_wrist_roll_23 * alpha_t_forearm_y
        + R_P_wrist_roll_33 * alpha_t_forearm_z;
    const six_link_real alpha_0_wrist_roll_4 = R_T_forearm_xx * a_t_forearm_x + minus_R_T_forearm_xy * a_t_forearm_y
        - R_T_forearm_xz * a_t_forearm_z;
    const six_link_real alpha_0_wrist_roll_5 = R_P_wrist_roll_12 * a_t_forearm_x + R_P_wrist_roll_22 * a_t_forearm_y
        + R_P_wrist_roll_32 * a_t_forearm_z;
    const six_link_real alpha_0_wrist_roll_6 = R_P_wrist_roll_13 * a_t_forearm_x + R_P_wrist_roll_23 * a_t_forearm_y
        + R_P_wrist_roll_33 * a_t_forearm_z;

    /* wrist_roll, omega: angular velocity of the link (45) */
    const six_link_real omega_wrist_roll_x = omega_R_wrist_roll_1 + state->v[3];

    /* wrist_roll, alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_wrist_roll_y = t54 + omega_R_wrist_roll_3 * state->v[3];
    const six_link_real alpha_wrist_roll_z = t55 - omega_R_wrist_roll_2 * state->v[3];

    /* wrist_roll, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t56 = omega_R_wrist_roll_2 * omega_R_wrist_roll_2;
    const six_link_real t57 = omega_R_wrist_roll_3 * omega_R_wrist_roll_3;
    const six_link_real a_t_wrist_roll_x = alpha_0_wrist_roll_4 - c->links[3].length * t56 - c->links[3].length * t57;
    const six_link_real t58 = c->links[3].length * omega_wrist_roll_x;
    const six_link_real a_t_wrist_roll_y = alpha_0_wrist_roll_5 + alpha_wrist_roll_z * c->links[3].length
        + t58 * omega_R_wrist_roll_2;
    const six_link_real a_t_wrist_roll_z = alpha_0_wrist_roll_6 + t58 * omega_R_wrist_roll_3
        - alpha_wrist_roll_y * c->links[3].length;

    /* wrist_pitch, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_5 = six_link_sine_cosine(state->q[4]);
    const six_link_real R_rel_wrist_pitch_xz = turn_5.sine, R_rel_wrist_pitch_xx = turn_5.cosine;

    /* wrist_pitch, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real omega_R_wrist_pitch_1 = R_rel_wrist_pitch_xx * omega_wrist_roll_x
        - R_rel_wrist_pitch_xz * omega_R_wrist_roll_3;
    const six_link_real omega_R_wrist_pitch_3 = R_rel_wrist_pitch_xz * omega_wrist_roll_x
        + R_rel_wrist_pitch_xx * omega_R_wrist_roll_3;

    /* acceleration of the parent's tip in F_i axes_wrist_pitch */
    const six_link_real t59 = R_rel_wrist_pitch_xx * alpha_0_wrist_roll_1 - R_rel_wrist_pitch_xz * alpha_wrist_roll_z;
    const six_link_real t60 = R_rel_wrist_pitch_xz * alpha_0_wrist_roll_1 + R_rel_wrist_pitch_xx * alpha_wrist_roll_z;
    const six_link_real alpha_0_wrist_pitch_4 = R_rel_wrist_pitch_xx * a_t_wrist_roll_x
        - R_rel_wrist_pitch_xz * a_t_wrist_roll_z;
    const six_link_real alpha_0_wrist_pitch_6 = R_rel_wrist_pitch_xz * a_t_wrist_roll_x
        + R_rel_wrist_pitch_xx * a_t_wrist_roll_z;

    /* wrist_pitch, omega: angular velocity of the link (45) */
    const six_link_real omega_wrist_pitch_y = omega_R_wrist_roll_2 + state->v[4];

    /* wrist_pitch, alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_wrist_pitch_x = t59 - omega_R_wrist_pitch_3 * state->v[4];
    const six_link_real alpha_wrist_pitch_z = t60 + omega_R_wrist_pitch_1 * state->v[4];

    /* wrist_pitch, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t61 = omega_wrist_pitch_y * omega_wrist_pitch_y;
    const six_link_real t62 = omega_R_wrist_pitch_3 * omega_R_wrist_pitch_3;
    const six_link_real a_t_wrist_pitch_x = alpha_0_wrist_pitch_4 - c->links[4].length * t61 - c->links[4].length * t62;
    const six_link_real t63 = c->links[4].length * omega_R_wrist_pitch_1;
    const six_link_real a_t_wrist_pitch_y = a_t_wrist_roll_y + alpha_wrist_pitch_z * c->links[4].length
        + t63 * omega_wrist_pitch_y;
    const six_link_real a_t_wrist_pitch_z = alpha_0_wrist_pitch_6 + t63 * omega_R_wrist_pitch_3
        - alpha_wrist_roll_y * c->links[4].length;

    /* flange, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_6 = six_link_sine_cosine(state->q[5]);
    const six_link_real minus_R_rel_flange_yz = turn_6.sine, R_rel_flange_yy = turn_6.cosine;

    /* flange, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real omega_R_flange_2 = R_rel_flange_yy * omega_wrist_pitch_y
        + minus_R_rel_flange_yz * omega_R_wrist_pitch_3;
    const six_link_real omega_R_flange_3 = R_rel_flange_yy * omega_R_wrist_pitch_3
        - minus_R_rel_flange_yz * omega_wrist_pitch_y;

    /* acceleration of the parent's tip in F_i axes_flange */
    const six_link_real t64 = R_rel_flange_yy * alpha_wrist_roll_y + minus_R_rel_flange_yz * alpha_wrist_pitch_z;
    const six_link_real t65 = R_rel_flange_yy * alpha_wrist_pitch_z - minus_R_rel_flange_yz * alpha_wrist_roll_y;
    const six_link_real alpha_0_flange_5 = R_rel_flange_yy * a_t_wrist_pitch_y
        + minus_R_rel_flange_yz * a_t_wrist_pitch_z;
    const six_link_real alpha_0_flange_6 = R_rel_flange_yy * a_t_wrist_pitch_z
        - minus_R_rel_flange_yz * a_t_wrist_pitch_y;

    /* flange, omega: angular velocity of the link (45) */
    const six_link_real omega_flange_x = omega_R_wrist_pitch_1 + state->v[5];

    /* flange, alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_flange_y = t64 + omega_R_flange_3 * state->v[5];
    const six_link_real alpha_flange_z = t65 - omega_R_flange_2 * state->v[5];

    /* flange, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t66 = omega_R_flange_2 * omega_R_flange_2;
    const six_link_real t67 = omega_R_flange_3 * omega_R_flange_3;
    const six_link_real a_t_flange_x = a_t_wrist_pitch_x - c->links[5].length * t66 - c->links[5].length * t67;
    const six_link_real t68 = c->links[5].length * omega_flange_x;
    const six_link_real a_t_flange_y = alpha_0_flange_5 + alpha_flange_z * c->links[5].length + t68 * omega_R_flange_2;
    const six_link_real a_t_flange_z = alpha_0_flange_6 + t68 * omega_R_flange_3 - alpha_flange_y * c->links[5].length;

    /* flange, Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_flange_xx = t66 + t67;
    const six_link_real Omega_flange_yx = alpha_flange_z + omega_flange_x * omega_R_flange_2;
    const six_link_real Omega_flange_zx = omega_flange_x * omega_R_flange_3 - alpha_flange_y;

    /* flange, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_flange_1 = c->links[5].I_s * alpha_wrist_pitch_x;
    const six_link_real t69 = c->links[5].I_s * omega_flange_x;
    const six_link_real H_star_flange_2 = t69 * omega_R_flange_3 - c->links[5].J_0_xx * Omega_flange_zx
        - c->links[5].S_0_x * alpha_0_flange_6;
    const six_link_real H_star_flange_3 = c->links[5].J_0_xx * Omega_flange_yx + c->links[5].S_0_x * alpha_0_flange_5
        - t69 * omega_R_flange_2;
    const six_link_real H_star_flange_4 = a_t_wrist_pitch_x * c->links[5].mu
        - minus_Omega_flange_xx * c->links[5].S_0_x;
    const six_link_real H_star_flange_5 = Omega_flange_yx * c->links[5].S_0_x + alpha_0_flange_5 * c->links[5].mu;
    const six_link_real H_star_flange_6 = Omega_flange_zx * c->links[5].S_0_x + alpha_0_flange_6 * c->links[5].mu;

    /* flange, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t70 = c->links[5].I_T_xx * alpha_wrist_pitch_x - c->links[5].J_T_xy * alpha_flange_y
        - c->links[5].J_T_xz * alpha_flange_z;
    const six_link_real t71 = c->links[5].I_T_yy * alpha_flange_y - c->links[5].J_T_xy * alpha_wrist_pitch_x
        - c->links[5].J_T_yz * alpha_flange_z;
    const six_link_real t72 = c->links[5].I_T_zz * alpha_flange_z
        - (c->links[5].J_T_xz * alpha_wrist_pitch_x + c->links[5].J_T_yz * alpha_flange_y);
    const six_link_real t73 = c->links[5].I_T_xx * omega_flange_x - c->links[5].J_T_xy * omega_R_flange_2
        - c->links[5].J_T_xz * omega_R_flange_3;
    const six_link_real t74 = c->links[5].I_T_yy * omega_R_flange_2 - c->links[5].J_T_xy * omega_flange_x
        - c->links[5].J_T_yz * omega_R_flange_3;
    const six_link_real t75 = c->links[5].I_T_zz * omega_R_flange_3
        - (c->links[5].J_T_xz * omega_flange_x + c->links[5].J_T_yz * omega_R_flange_2);
    const six_link_real t76 = c->links[5].S_T_y * a_t_flange_z - c->links[5].S_T_z * a_t_flange_y + t70
        + (omega_R_flange_2 * t75 - omega_R_flange_3 * t74);
    const six_link_real t77 = c->links[5].S_T_z * a_t_flange_x - c->links[5].S_T_x * a_t_flange_z + t71
        + (omega_R_flange_3 * t73 - omega_flange_x * t75);
    const six_link_real t78 = c->links[5].S_T_x * a_t_flange_y - c->links[5].S_T_y * a_t_flange_x + t72
        + (omega_flange_x * t74 - omega_R_flange_2 * t73);
    const six_link_real t79 = omega_R_flange_2 * c->links[5].S_T_z - omega_R_flange_3 * c->links[5].S_T_y;
    const six_link_real t80 = omega_R_flange_3 * c->links[5].S_T_x - omega_flange_x * c->links[5].S_T_z;
    const six_link_real t81 = omega_flange_x * c->links[5].S_T_y - omega_R_flange_2 * c->links[5].S_T_x;
    const six_link_real t82 = alpha_flange_y * c->links[5].S_T_z - alpha_flange_z * c->links[5].S_T_y
        + (omega_R_flange_2 * t81 - omega_R_flange_3 * t80);
    const six_link_real t83 = alpha_flange_z * c->links[5].S_T_x - alpha_wrist_pitch_x * c->links[5].S_T_z
        + (omega_R_flange_3 * t79 - omega_flange_x * t81);
    const six_link_real t84 = alpha_wrist_pitch_x * c->links[5].S_T_y - alpha_flange_y * c->links[5].S_T_x
        + (omega_flange_x * t80 - omega_R_flange_2 * t79);
    const six_link_real p_T_flange_1 = t76 - input->w_ext[5][0];
    const six_link_real p_T_flange_2 = t77 - input->w_ext[5][1];
    const six_link_real p_T_flange_3 = t78 - input->w_ext[5][2];
    const six_link_real p_T_flange_4 = c->links[5].body0_mass * a_t_flange_x + t82 - input->w_ext[5][3];
    const six_link_real p_T_flange_5 = c->links[5].body0_mass * a_t_flange_y + t83 - input->w_ext[5][4];
    const six_link_real p_T_flange_6 = c->links[5].body0_mass * a_t_flange_z + t84 - input->w_ext[5][5];

    /* flange, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t85 = c->links[5].S_T_x + c->links[5].length * c->links[5].body0_mass;
    const six_link_real t86 = c->links[5].S_T_x * c->links[5].length;
    const six_link_real t87 = c->links[5].length * t85;
    const six_link_real minus_M_loaded_flange_12 = c->links[5].J_T_xy + c->links[5].S_T_y * c->links[5].length;
    const six_link_real minus_M_loaded_flange_13 = c->links[5].J_T_xz + c->links[5].S_T_z * c->links[5].length;
    const six_link_real M_loaded_flange_11 = c->links[5].I_s + c->links[5].I_T_xx;
    const six_link_real M_loaded_flange_22 = c->links[5].J_0_xx + (c->links[5].I_T_yy + t86 + t87);
    const six_link_real minus_M_loaded_flange_26 = t85 + c->links[5].S_0_x;
    const six_link_real M_loaded_flange_33 = c->links[5].J_0_xx + (c->links[5].I_T_zz + t86 + t87);
    const six_link_real M_loaded_flange_44 = c->links[5].mu + c->links[5].body0_mass;
    const six_link_real h_loaded_flange_1 = H_star_flange_1 + p_T_flange_1;
    const six_link_real h_loaded_flange_2 = H_star_flange_2 + (p_T_flange_2 - c->links[5].length * p_T_flange_6);
    const six_link_real h_loaded_flange_3 = H_star_flange_3 + (p_T_flange_3 + c->links[5].length * p_T_flange_5);
    const six_link_real h_loaded_flange_4 = H_star_flange_4 + p_T_flange_4;
    const six_link_real h_loaded_flange_5 = H_star_flange_5 + p_T_flange_5;
    const six_link_real h_loaded_flange_6 = H_star_flange_6 + p_T_flange_6;

    /* flange, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_flange_11 = M_loaded_flange_11 + m_eta[5];
    const six_link_real t88 = SIX_LINK_REAL_EPSILON * 8;
    bad |= (unsigned long)(!(joint_inertia_flange_11
        - t88 * (M_loaded_flange_11 + M_loaded_flange_22 + M_loaded_flange_33) > 0)) << 5;
    const six_link_real joint_inverse_flange_1 = 1 / joint_inertia_flange_11;
    const six_link_real joint_W_flange_11 = M_loaded_flange_11 * joint_inverse_flange_1;
    const six_link_real minus_joint_W_flange_12 = minus_M_loaded_flange_12 * joint_inverse_flange_1;
    const six_link_real minus_joint_W_flange_13 = minus_M_loaded_flange_13 * joint_inverse_flange_1;
    const six_link_real minus_joint_W_flange_15 = c->links[5].S_T_z * joint_inverse_flange_1;
    const six_link_real joint_W_flange_16 = c->links[5].S_T_y * joint_inverse_flange_1;
    const six_link_real joint_w_flange_1 = (input->tau[5] - work->f_eta[5] - h_loaded_flange_1)
        * joint_inverse_flange_1;
    const six_link_real Lambda_i_flange_11 = M_loaded_flange_11 - M_loaded_flange_11 * joint_W_flange_11;
    const six_link_real Lambda_i_flange_12 = M_loaded_flange_11 * minus_joint_W_flange_12 - minus_M_loaded_flange_12;
    const six_link_real Lambda_i_flange_13 = M_loaded_flange_11 * minus_joint_W_flange_13 - minus_M_loaded_flange_13;
    const six_link_real Lambda_i_flange_15 = M_loaded_flange_11 * minus_joint_W_flange_15 - c->links[5].S_T_z;
    const six_link_real Lambda_i_flange_16 = c->links[5].S_T_y - M_loaded_flange_11 * joint_W_flange_16;
    const six_link_real Lambda_i_flange_22 = M_loaded_flange_22 - minus_M_loaded_flange_12 * minus_joint_W_flange_12;
    const six_link_real minus_Lambda_i_flange_23 = c->links[5].J_T_yz
        + minus_M_loaded_flange_12 * minus_joint_W_flange_13;
    const six_link_real minus_Lambda_i_flange_25 = minus_M_loaded_flange_12 * minus_joint_W_flange_15;
    const six_link_real Lambda_i_flange_26 = minus_M_loaded_flange_12 * joint_W_flange_16 - minus_M_loaded_flange_26;
    const six_link_real Lambda_i_flange_33 = M_loaded_flange_33 - minus_M_loaded_flange_13 * minus_joint_W_flange_13;
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
    const six_link_real t89 = (Lambda_i_flange_22 - Lambda_i_flange_33) * REAL(0.5);
    const six_link_real t90 = t89 * R_rel_flange_yy + minus_Lambda_i_flange_23 * minus_R_rel_flange_yz;
    const six_link_real t91 = t89 * minus_R_rel_flange_yz - minus_Lambda_i_flange_23 * R_rel_flange_yy;
    const six_link_real Lambda_flange_7 = R_rel_flange_yy * t90 * 2 + Lambda_i_flange_33;
    const six_link_real Lambda_flange_8 = R_rel_flange_yy * t91 + minus_R_rel_flange_yz * t90;
    const six_link_real Lambda_flange_12 = minus_R_rel_flange_yz * t91 * 2 + Lambda_i_flange_33;
    const six_link_real Lambda_flange_5 = Lambda_i_flange_15 * R_rel_flange_yy
        - Lambda_i_flange_16 * minus_R_rel_flange_yz;
    const six_link_real Lambda_flange_6 = Lambda_i_flange_15 * minus_R_rel_flange_yz
        + Lambda_i_flange_16 * R_rel_flange_yy;
    const six_link_real t92 = minus_Lambda_i_flange_25 * R_rel_flange_yy + Lambda_i_flange_26 * minus_R_rel_flange_yz;
    const six_link_real t93 = Lambda_i_flange_26 * R_rel_flange_yy - minus_Lambda_i_flange_25 * minus_R_rel_flange_yz;
    const six_link_real t94 = Lambda_i_flange_35 * R_rel_flange_yy - Lambda_i_flange_36 * minus_R_rel_flange_yz;
    const six_link_real t95 = Lambda_i_flange_35 * minus_R_rel_flange_yz + Lambda_i_flange_36 * R_rel_flange_yy;
    const six_link_real Lambda_flange_9 = R_rel_flange_yy * c->links[5].S_T_z
        + minus_R_rel_flange_yz * c->links[5].S_T_y;
    const six_link_real minus_Lambda_flange_10 = R_rel_flange_yy * t92 + minus_R_rel_flange_yz * t94;
    const six_link_real Lambda_flange_11 = R_rel_flange_yy * t93 - minus_R_rel_flange_yz * t95;
    const six_link_real Lambda_flange_13 = minus_R_rel_flange_yz * c->links[5].S_T_z
        - R_rel_flange_yy * c->links[5].S_T_y;
    const six_link_real Lambda_flange_14 = R_rel_flange_yy * t94 - minus_R_rel_flange_yz * t92;
    const six_link_real Lambda_flange_15 = minus_R_rel_flange_yz * t93 + R_rel_flange_yy * t95;
    const six_link_real t96 = (Lambda_i_flange_55 - Lambda_i_flange_66) * REAL(0.5);
    const six_link_real t97 = t96 * R_rel_flange_yy - Lambda_i_flange_56 * minus_R_rel_flange_yz;
    const six_link_real t98 = t96 * minus_R_rel_flange_yz + Lambda_i_flange_56 * R_rel_flange_yy;
    const six_link_real Lambda_flange_19 = R_rel_flange_yy * t97 * 2 + Lambda_i_flange_66;
    const six_link_real Lambda_flange_20 = R_rel_flange_yy * t98 + minus_R_rel_flange_yz * t97;
    const six_link_real Lambda_flange_21 = minus_R_rel_flange_yz * t98 * 2 + Lambda_i_flange_66;
    const six_link_real p_flange_2 = R_rel_flange_yy * p_i_flange_2 - minus_R_rel_flange_yz * p_i_flange_3;
    const six_link_real p_flange_3 = minus_R_rel_flange_yz * p_i_flange_2 + R_rel_flange_yy * p_i_flange_3;
    const six_link_real p_flange_5 = R_rel_flange_yy * p_i_flange_5 - minus_R_rel_flange_yz * p_i_flange_6;
    const six_link_real p_flange_6 = minus_R_rel_flange_yz * p_i_flange_5 + R_rel_flange_yy * p_i_flange_6;

    /* wrist_pitch, Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_wrist_pitch_xx = t61 + t62;
    const six_link_real Omega_wrist_pitch_yx = alpha_wrist_pitch_z + omega_R_wrist_pitch_1 * omega_wrist_pitch_y;
    const six_link_real Omega_wrist_pitch_zx = omega_R_wrist_pitch_1 * omega_R_wrist_pitch_3 - alpha_wrist_roll_y;

    /* wrist_pitch, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_wrist_pitch_1 = c->links[4].I_s * alpha_wrist_pitch_x;
    const six_link_real t99 = c->links[4].I_s * omega_R_wrist_pitch_1;
    const six_link_real H_star_wrist_pitch_2 = t99 * omega_R_wrist_pitch_3 - c->links[4].J_0_xx * Omega_wrist_pitch_zx
        - c->links[4].S_0_x * alpha_0_wrist_pitch_6;
    const six_link_real H_star_wrist_pitch_3 = c->links[4].J_0_xx * Omega_wrist_pitch_yx
        + c->links[4].S_0_x * a_t_wrist_roll_y - t99 * omega_wrist_pitch_y;
    const six_link_real H_star_wrist_pitch_4 = alpha_0_wrist_pitch_4 * c->links[4].mu
        - minus_Omega_wrist_pitch_xx * c->links[4].S_0_x;
    const six_link_real H_star_wrist_pitch_5 = Omega_wrist_pitch_yx * c->links[4].S_0_x
        + a_t_wrist_roll_y * c->links[4].mu;
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
    const six_link_real t100 = c->links[4].length * Lambda_flange_20;
    const six_link_real minus_M_loaded_wrist_pitch_25 = minus_Lambda_flange_10 + t100;
    const six_link_real t101 = Lambda_flange_11 - c->links[4].length * Lambda_flange_21;
    const six_link_real t102 = Lambda_flange_14 + c->links[4].length * Lambda_flange_19;
    const six_link_real M_loaded_wrist_pitch_36 = Lambda_flange_15 + t100;
    const six_link_real M_loaded_wrist_pitch_12 = Lambda_flange_2 - Lambda_flange_6 * c->links[4].length;
    const six_link_real M_loaded_wrist_pitch_13 = Lambda_flange_3 + Lambda_flange_5 * c->links[4].length;
    const six_link_real M_loaded_wrist_pitch_23 = Lambda_flange_8 - minus_Lambda_flange_10 * c->links[4].length
        - c->links[4].length * M_loaded_wrist_pitch_36;
    const six_link_real M_loaded_wrist_pitch_11 = c->links[4].I_s + Lambda_i_flange_11;
    const six_link_real M_loaded_wrist_pitch_22 = c->links[4].J_0_xx
        + (Lambda_flange_7 - Lambda_flange_11 * c->links[4].length - c->links[4].length * t101);
    const six_link_real M_loaded_wrist_pitch_26 = t101 - c->links[4].S_0_x;
    const six_link_real M_loaded_wrist_pitch_33 = c->links[4].J_0_xx
        + (Lambda_flange_12 + Lambda_flange_14 * c->links[4].length + c->links[4].length * t102);
    const six_link_real M_loaded_wrist_pitch_35 = c->links[4].S_0_x + t102;
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
    const six_link_real joint_inertia_wrist_pitch_11 = M_loaded_wrist_pitch_22 + m_eta[4];
    bad |= (unsigned long)(!(joint_inertia_wrist_pitch_11
        - t88 * (M_loaded_wrist_pitch_11 + M_loaded_wrist_pitch_22 + M_loaded_wrist_pitch_33) > 0)) << 4;
    const six_link_real joint_inverse_wrist_pitch_1 = 1 / joint_inertia_wrist_pitch_11;
    const six_link_real joint_W_wrist_pitch_11 = M_loaded_wrist_pitch_12 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_12 = M_loaded_wrist_pitch_22 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_13 = M_loaded_wrist_pitch_23 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_14 = Lambda_flange_9 * joint_inverse_wrist_pitch_1;
    const six_link_real minus_joint_W_wrist_pitch_15 = minus_M_loaded_wrist_pitch_25 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_W_wrist_pitch_16 = M_loaded_wrist_pitch_26 * joint_inverse_wrist_pitch_1;
    const six_link_real joint_w_wrist_pitch_1 = (input->tau[4] - work->f_eta[4] - h_loaded_wrist_pitch_2)
        * joint_inverse_wrist_pitch_1;
    const six_link_real Lambda_i_wrist_pitch_11 = M_loaded_wrist_pitch_11
        - M_loaded_wrist_pitch_12 * joint_W_wrist_pitch_11;
    const six_link_real Lambda_i_wrist_pitch_12 = M_loaded_wrist_pitch_12
        - M_loaded_wrist_pitch_12 * joint_W_wrist_pitch_12;
    const six_link_real Lambda_i_wrist_pitch_13 = M_loaded_wrist_pitch_13
        - M_loaded_wrist_pitch_12 * joint_W_wrist_pitch_13;
    const six_link_real minus_Lambda_i_wrist_pitch_14 = M_loaded_wrist_pitch_12 * joint_W_wrist_pitch_14;
    const six_link_real Lambda_i_wrist_pitch_15 = Lambda_flange_5
        + M_loaded_wrist_pitch_12 * minus_joint_W_wrist_pitch_15;
    const six_link_real Lambda_i_wrist_pitch_16 = Lambda_flange_6 - M_loaded_wrist_pitch_12 * joint_W_wrist_pitch_16;
    const six_link_real Lambda_i_wrist_pitch_22 = M_loaded_wrist_pitch_22
        - M_loaded_wrist_pitch_22 * joint_W_wrist_pitch_12;
    const six_link_real Lambda_i_wrist_pitch_23 = M_loaded_wrist_pitch_23
        - M_loaded_wrist_pitch_22 * joint_W_wrist_pitch_13;
    const six_link_real Lambda_i_wrist_pitch_24 = Lambda_flange_9 - M_loaded_wrist_pitch_22 * joint_W_wrist_pitch_14;
    const six_link_real Lambda_i_wrist_pitch_25 = M_loaded_wrist_pitch_22 * minus_joint_W_wrist_pitch_15
        - minus_M_loaded_wrist_pitch_25;
    const six_link_real Lambda_i_wrist_pitch_26 = M_loaded_wrist_pitch_26
        - M_loaded_wrist_pitch_22 * joint_W_wrist_pitch_16;
    const six_link_real Lambda_i_wrist_pitch_33 = M_loaded_wrist_pitch_33
        - M_loaded_wrist_pitch_23 * joint_W_wrist_pitch_13;
    const six_link_real Lambda_i_wrist_pitch_34 = Lambda_flange_13 - M_loaded_wrist_pitch_23 * joint_W_wrist_pitch_14;
    const six_link_real Lambda_i_wrist_pitch_35 = M_loaded_wrist_pitch_35
        + M_loaded_wrist_pitch_23 * minus_joint_W_wrist_pitch_15;
    const six_link_real Lambda_i_wrist_pitch_36 = M_loaded_wrist_pitch_36
        - M_loaded_wrist_pitch_23 * joint_W_wrist_pitch_16;
    const six_link_real Lambda_i_wrist_pitch_44 = M_loaded_wrist_pitch_44 - Lambda_flange_9 * joint_W_wrist_pitch_14;
    const six_link_real Lambda_i_wrist_pitch_45 = Lambda_flange_9 * minus_joint_W_wrist_pitch_15;
    const six_link_real minus_Lambda_i_wrist_pitch_46 = Lambda_flange_9 * joint_W_wrist_pitch_16;
    const six_link_real Lambda_i_wrist_pitch_55 = M_loaded_wrist_pitch_55
        - minus_M_loaded_wrist_pitch_25 * minus_joint_W_wrist_pitch_15;
    const six_link_real Lambda_i_wrist_pitch_56 = Lambda_flange_20
        + minus_M_loaded_wrist_pitch_25 * joint_W_wrist_pitch_16;
    const six_link_real Lambda_i_wrist_pitch_66 = M_loaded_wrist_pitch_66
        - M_loaded_wrist_pitch_26 * joint_W_wrist_pitch_16;
    const six_link_real p_i_wrist_pitch_1 = h_loaded_wrist_pitch_1 + M_loaded_wrist_pitch_12 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_2 = h_loaded_wrist_pitch_2 + M_loaded_wrist_pitch_22 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_3 = h_loaded_wrist_pitch_3 + M_loaded_wrist_pitch_23 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_4 = h_loaded_wrist_pitch_4 + Lambda_flange_9 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_5 = h_loaded_wrist_pitch_5
        - minus_M_loaded_wrist_pitch_25 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_6 = h_loaded_wrist_pitch_6 + M_loaded_wrist_pitch_26 * joint_w_wrist_pitch_1;

    /* wrist_pitch, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t103 = (Lambda_i_wrist_pitch_11 - Lambda_i_wrist_pitch_33) * REAL(0.5);
    const six_link_real t104 = t103 * R_rel_wrist_pitch_xx + Lambda_i_wrist_pitch_13 * R_rel_wrist_pitch_xz;
    const six_link_real t105 = Lambda_i_wrist_pitch_13 * R_rel_wrist_pitch_xx - t103 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_1 = R_rel_wrist_pitch_xx * t104 * 2 + Lambda_i_wrist_pitch_33;
    const six_link_real Lambda_wrist_pitch_2 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_12
        + Lambda_i_wrist_pitch_23 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_3 = R_rel_wrist_pitch_xx * t105 - R_rel_wrist_pitch_xz * t104;
    const six_link_real Lambda_wrist_pitch_8 = Lambda_i_wrist_pitch_23 * R_rel_wrist_pitch_xx
        - R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_12;
    const six_link_real Lambda_wrist_pitch_12 = Lambda_i_wrist_pitch_33 - R_rel_wrist_pitch_xz * t105 * 2;
    const six_link_real t106 = Lambda_i_wrist_pitch_16 * R_rel_wrist_pitch_xz
        - minus_Lambda_i_wrist_pitch_14 * R_rel_wrist_pitch_xx;
    const six_link_real t107 = minus_Lambda_i_wrist_pitch_14 * R_rel_wrist_pitch_xz
        + Lambda_i_wrist_pitch_16 * R_rel_wrist_pitch_xx;
    const six_link_real Lambda_wrist_pitch_9 = Lambda_i_wrist_pitch_24 * R_rel_wrist_pitch_xx
        + Lambda_i_wrist_pitch_26 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_11 = Lambda_i_wrist_pitch_26 * R_rel_wrist_pitch_xx
        - Lambda_i_wrist_pitch_24 * R_rel_wrist_pitch_xz;
    const six_link_real t108 = Lambda_i_wrist_pitch_34 * R_rel_wrist_pitch_xx
        + Lambda_i_wrist_pitch_36 * R_rel_wrist_pitch_xz;
    const six_link_real t109 = Lambda_i_wrist_pitch_36 * R_rel_wrist_pitch_xx
        - Lambda_i_wrist_pitch_34 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_4 = R_rel_wrist_pitch_xx * t106 + R_rel_wrist_pitch_xz * t108;
    const six_link_real Lambda_wrist_pitch_5 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_15
        + R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_35;
    const six_link_real Lambda_wrist_pitch_6 = R_rel_wrist_pitch_xx * t107 + R_rel_wrist_pitch_xz * t109;
    const six_link_real Lambda_wrist_pitch_13 = R_rel_wrist_pitch_xx * t108 - R_rel_wrist_pitch_xz * t106;
    const six_link_real Lambda_wrist_pitch_14 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_35
        - R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_15;
    const six_link_real Lambda_wrist_pitch_15 = R_rel_wrist_pitch_xx * t109 - R_rel_wrist_pitch_xz * t107;
    const six_link_real t110 = (Lambda_i_wrist_pitch_44 - Lambda_i_wrist_pitch_66) * REAL(0.5);
    const six_link_real t111 = t110 * R_rel_wrist_pitch_xx - minus_Lambda_i_wrist_pitch_46 * R_rel_wrist_pitch_xz;
    const six_link_real t112 = t110 * R_rel_wrist_pitch_xz + minus_Lambda_i_wrist_pitch_46 * R_rel_wrist_pitch_xx;
    const six_link_real Lambda_wrist_pitch_16 = R_rel_wrist_pitch_xx * t111 * 2 + Lambda_i_wrist_pitch_66;
    const six_link_real Lambda_wrist_pitch_17 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_45
        + Lambda_i_wrist_pitch_56 * R_rel_wrist_pitch_xz;
    const six_link_real minus_Lambda_wrist_pitch_18 = R_rel_wrist_pitch_xx * t112 + R_rel_wrist_pitch_xz * t111;
    const six_link_real Lambda_wrist_pitch_20 = Lambda_i_wrist_pitch_56 * R_rel_wrist_pitch_xx
        - R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_45;
    const six_link_real Lambda_wrist_pitch_21 = R_rel_wrist_pitch_xz * t112 * 2 + Lambda_i_wrist_pitch_66;
    const six_link_real p_wrist_pitch_1 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_1
        + R_rel_wrist_pitch_xz * p_i_wrist_pitch_3;
    const six_link_real p_wrist_pitch_3 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_3
        - R_rel_wrist_pitch_xz * p_i_wrist_pitch_1;
    const six_link_real p_wrist_pitch_4 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_4
        + R_rel_wrist_pitch_xz * p_i_wrist_pitch_6;
    const six_link_real p_wrist_pitch_6 = R_rel_wrist_pitch_xx * p_i_wrist_pitch_6
        - R_rel_wrist_pitch_xz * p_i_wrist_pitch_4;

    /* wrist_roll, Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_wrist_roll_xx = t56 + t57;
    const six_link_real Omega_wrist_roll_yx = alpha_wrist_roll_z + omega_wrist_roll_x * omega_R_wrist_roll_2;
    const six_link_real Omega_wrist_roll_zx = omega_wrist_roll_x * omega_R_wrist_roll_3 - alpha_wrist_roll_y;

    /* wrist_roll, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_wrist_roll_1 = c->links[3].I_s * alpha_0_wrist_roll_1;
    const six_link_real t113 = c->links[3].I_s * omega_wrist_roll_x;
    const six_link_real H_star_wrist_roll_2 = t113 * omega_R_wrist_roll_3 - c->links[3].J_0_xx * Omega_wrist_roll_zx
        - c->links[3].S_0_x * alpha_0_wrist_roll_6;
    const six_link_real H_star_wrist_roll_3 = c->links[3].J_0_xx * Omega_wrist_roll_yx
        + c->links[3].S_0_x * alpha_0_wrist_roll_5 - t113 * omega_R_wrist_roll_2;
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
    const six_link_real t114 = c->links[3].length * Lambda_wrist_pitch_20;
    const six_link_real M_loaded_wrist_roll_24 = Lambda_wrist_pitch_9
        + c->links[3].length * minus_Lambda_wrist_pitch_18;
    const six_link_real M_loaded_wrist_roll_25 = Lambda_i_wrist_pitch_25 - t114;
    const six_link_real t115 = Lambda_wrist_pitch_11 - c->links[3].length * Lambda_wrist_pitch_21;
    const six_link_real M_loaded_wrist_roll_34 = Lambda_wrist_pitch_13 + c->links[3].length * Lambda_wrist_pitch_17;
    const six_link_real t116 = Lambda_wrist_pitch_14 + c->links[3].length * Lambda_i_wrist_pitch_55;
    const six_link_real M_loaded_wrist_roll_36 = Lambda_wrist_pitch_15 + t114;
    const six_link_real M_loaded_wrist_roll_12 = Lambda_wrist_pitch_2 - Lambda_wrist_pitch_6 * c->links[3].length;
    const six_link_real M_loaded_wrist_roll_13 = Lambda_wrist_pitch_3 + Lambda_wrist_pitch_5 * c->links[3].length;
    const six_link_real M_loaded_wrist_roll_23 = Lambda_wrist_pitch_8 + Lambda_i_wrist_pitch_25 * c->links[3].length
        - c->links[3].length * M_loaded_wrist_roll_36;
    const six_link_real M_loaded_wrist_roll_11 = c->links[3].I_s + Lambda_wrist_pitch_1;
    const six_link_real M_loaded_wrist_roll_22 = c->links[3].J_0_xx
        + (Lambda_i_wrist_pitch_22 - Lambda_wrist_pitch_11 * c->links[3].length - c->links[3].length * t115);
    const six_link_real M_loaded_wrist_roll_26 = t115 - c->links[3].S_0_x;
    const six_link_real M_loaded_wrist_roll_33 = c->links[3].J_0_xx
        + (Lambda_wrist_pitch_12 + Lambda_wrist_pitch_14 * c->links[3].length + c->links[3].length * t116);
    const six_link_real M_loaded_wrist_roll_35 = c->links[3].S_0_x + t116;
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
    const six_link_real joint_inertia_wrist_roll_11 = M_loaded_wrist_roll_11 + m_eta[3];
    bad |= (unsigned long)(!(joint_inertia_wrist_roll_11
        - t88 * (M_loaded_wrist_roll_11 + M_loaded_wrist_roll_22 + M_loaded_wrist_roll_33) > 0)) << 3;
    const six_link_real joint_inverse_wrist_roll_1 = 1 / joint_inertia_wrist_roll_11;
    const six_link_real joint_W_wrist_roll_11 = M_loaded_wrist_roll_11 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_12 = M_loaded_wrist_roll_12 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_13 = M_loaded_wrist_roll_13 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_14 = Lambda_wrist_pitch_4 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_15 = Lambda_wrist_pitch_5 * joint_inverse_wrist_roll_1;
    const six_link_real joint_W_wrist_roll_16 = Lambda_wrist_pitch_6 * joint_inverse_wrist_roll_1;
    const six_link_real joint_w_wrist_roll_1 = (input->tau[3] - work->f_eta[3] - h_loaded_wrist_roll_1)
        * joint_inverse_wrist_roll_1;
    const six_link_real Lambda_i_wrist_roll_11 = M_loaded_wrist_roll_11
        - M_loaded_wrist_roll_11 * joint_W_wrist_roll_11;
    const six_link_real Lambda_i_wrist_roll_12 = M_loaded_wrist_roll_12
        - M_loaded_wrist_roll_11 * joint_W_wrist_roll_12;
    const six_link_real Lambda_i_wrist_roll_13 = M_loaded_wrist_roll_13
        - M_loaded_wrist_roll_11 * joint_W_wrist_roll_13;
    const six_link_real Lambda_i_wrist_roll_14 = Lambda_wrist_pitch_4 - M_loaded_wrist_roll_11 * joint_W_wrist_roll_14;
    const six_link_real Lambda_i_wrist_roll_15 = Lambda_wrist_pitch_5 - M_loaded_wrist_roll_11 * joint_W_wrist_roll_15;
    const six_link_real Lambda_i_wrist_roll_16 = Lambda_wrist_pitch_6 - M_loaded_wrist_roll_11 * joint_W_wrist_roll_16;
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
    const six_link_real Lambda_i_wrist_roll_44 = M_loaded_wrist_roll_44 - Lambda_wrist_pitch_4 * joint_W_wrist_roll_14;
    const six_link_real Lambda_i_wrist_roll_45 = Lambda_wrist_pitch_17 - Lambda_wrist_pitch_4 * joint_W_wrist_roll_15;
    const six_link_real minus_Lambda_i_wrist_roll_46 = minus_Lambda_wrist_pitch_18
        + Lambda_wrist_pitch_4 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_55 = M_loaded_wrist_roll_55 - Lambda_wrist_pitch_5 * joint_W_wrist_roll_15;
    const six_link_real Lambda_i_wrist_roll_56 = Lambda_wrist_pitch_20 - Lambda_wrist_pitch_5 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_66 = M_loaded_wrist_roll_66 - Lambda_wrist_pitch_6 * joint_W_wrist_roll_16;
    const six_link_real p_i_wrist_roll_1 = h_loaded_wrist_roll_1 + M_loaded_wrist_roll_11 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_2 = h_loaded_wrist_roll_2 + M_loaded_wrist_roll_12 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_3 = h_loaded_wrist_roll_3 + M_loaded_wrist_roll_13 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_4 = h_loaded_wrist_roll_4 + Lambda_wrist_pitch_4 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_5 = h_loaded_wrist_roll_5 + Lambda_wrist_pitch_5 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_6 = h_loaded_wrist_roll_6 + Lambda_wrist_pitch_6 * joint_w_wrist_roll_1;

    /* wrist_roll, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t117 = (Lambda_i_wrist_roll_11 - Lambda_i_wrist_roll_33) * REAL(0.5);
    const six_link_real t118 = t117 * R_T_forearm_xx + Lambda_i_wrist_roll_12 * R_P_wrist_roll_12
        + Lambda_i_wrist_roll_13 * R_P_wrist_roll_13;
    const six_link_real t119 = t117 * minus_R_T_forearm_xy + Lambda_i_wrist_roll_12 * R_P_wrist_roll_22
        + Lambda_i_wrist_roll_13 * R_P_wrist_roll_23;
    const six_link_real t120 = Lambda_i_wrist_roll_12 * R_P_wrist_roll_32 - t117 * R_T_forearm_xz
        + Lambda_i_wrist_roll_13 * R_P_wrist_roll_33;
    const six_link_real t121 = (Lambda_i_wrist_roll_22 - Lambda_i_wrist_roll_33) * REAL(0.5);
    const six_link_real t122 = t121 * R_P_wrist_roll_12 + Lambda_i_wrist_roll_23 * R_P_wrist_roll_13;
    const six_link_real t123 = t121 * R_P_wrist_roll_22 + Lambda_i_wrist_roll_23 * R_P_wrist_roll_23;
    const six_link_real t124 = t121 * R_P_wrist_roll_32 + Lambda_i_wrist_roll_23 * R_P_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_1 = (R_T_forearm_xx * t118 + R_P_wrist_roll_12 * t122) * 2
        + Lambda_i_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_2 = R_T_forearm_xx * t119 + R_P_wrist_roll_12 * t123
        + (minus_R_T_forearm_xy * t118 + R_P_wrist_roll_22 * t122);
    const six_link_real Lambda_wrist_roll_3 = R_T_forearm_xx * t120 + R_P_wrist_roll_12 * t124
        + (R_P_wrist_roll_32 * t122 - R_T_forearm_xz * t118);
    const six_link_real Lambda_wrist_roll_7 = (minus_R_T_forearm_xy * t119 + R_P_wrist_roll_22 * t123) * 2
        + Lambda_i_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_8 = minus_R_T_forearm_xy * t120 + R_P_wrist_roll_22 * t124
        + (R_P_wrist_roll_32 * t123 - R_T_forearm_xz * t119);
    const six_link_real Lambda_wrist_roll_12 = (R_P_wrist_roll_32 * t124 - R_T_forearm_xz * t120) * 2
        + Lambda_i_wrist_roll_33;
    const six_link_real t125 = Lambda_i_wrist_roll_14 * R_T_forearm_xx + Lambda_i_wrist_roll_15 * R_P_wrist_roll_12
        + Lambda_i_wrist_roll_16 * R_P_wrist_roll_13;
    const six_link_real t126 = Lambda_i_wrist_roll_14 * minus_R_T_forearm_xy
        + Lambda_i_wrist_roll_15 * R_P_wrist_roll_22 + Lambda_i_wrist_roll_16 * R_P_wrist_roll_23;
    const six_link_real t127 = Lambda_i_wrist_roll_15 * R_P_wrist_roll_32 - Lambda_i_wrist_roll_14 * R_T_forearm_xz
        + Lambda_i_wrist_roll_16 * R_P_wrist_roll_33;
    const six_link_real t128 = Lambda_i_wrist_roll_24 * R_T_forearm_xx + Lambda_i_wrist_roll_25 * R_P_wrist_roll_12
        + Lambda_i_wrist_roll_26 * R_P_wrist_roll_13;
    const six_link_real t129 = Lambda_i_wrist_roll_24 * minus_R_T_forearm_xy
        + Lambda_i_wrist_roll_25 * R_P_wrist_roll_22 + Lambda_i_wrist_roll_26 * R_P_wrist_roll_23;
    const six_link_real t130 = Lambda_i_wrist_roll_25 * R_P_wrist_roll_32 - Lambda_i_wrist_roll_24 * R_T_forearm_xz
        + Lambda_i_wrist_roll_26 * R_P_wrist_roll_33;
    const six_link_real t131 = Lambda_i_wrist_roll_34 * R_T_forearm_xx + Lambda_i_wrist_roll_35 * R_P_wrist_roll_12
        + Lambda_i_wrist_roll_36 * R_P_wrist_roll_13;
    const six_link_real t132 = Lambda_i_wrist_roll_34 * minus_R_T_forearm_xy
        + Lambda_i_wrist_roll_35 * R_P_wrist_roll_22 + Lambda_i_wrist_roll_36 * R_P_wrist_roll_23;
    const six_link_real t133 = Lambda_i_wrist_roll_35 * R_P_wrist_roll_32 - Lambda_i_wrist_roll_34 * R_T_forearm_xz
        + Lambda_i_wrist_roll_36 * R_P_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_4 = R_T_forearm_xx * t125 + R_P_wrist_roll_12 * t128
        + R_P_wrist_roll_13 * t131;
    const six_link_real Lambda_wrist_roll_5 = R_T_forearm_xx * t126 + R_P_wrist_roll_12 * t129
        + R_P_wrist_roll_13 * t132;
    const six_link_real Lambda_wrist_roll_6 = R_T_forearm_xx * t127 + R_P_wrist_roll_12 * t130
        + R_P_wrist_roll_13 * t133;
    const six_link_real Lambda_wrist_roll_9 = minus_R_T_forearm_xy * t125 + R_P_wrist_roll_22 * t128
        + R_P_wrist_roll_23 * t131;
    const six_link_real Lambda_wrist_roll_10 = minus_R_T_forearm_xy * t126 + R_P_wrist_roll_22 * t129
        + R_P_wrist_roll_23 * t132;
    const six_link_real Lambda_wrist_roll_11 = minus_R_T_forearm_xy * t127 + R_P_wrist_roll_22 * t130
        + R_P_wrist_roll_23 * t133;
    const six_link_real Lambda_wrist_roll_13 = R_P_wrist_roll_32 * t128 - R_T_forearm_xz * t125
        + R_P_wrist_roll_33 * t131;
    const six_link_real Lambda_wrist_roll_14 = R_P_wrist_roll_32 * t129 - R_T_forearm_xz * t126
        + R_P_wrist_roll_33 * t132;
    const six_link_real Lambda_wrist_roll_15 = R_P_wrist_roll_32 * t130 - R_T_forearm_xz * t127
        + R_P_wrist_roll_33 * t133;
    const six_link_real t134 = (Lambda_i_wrist_roll_44 - Lambda_i_wrist_roll_66) * REAL(0.5);
    const six_link_real t135 = t134 * R_T_forearm_xx + Lambda_i_wrist_roll_45 * R_P_wrist_roll_12
        - minus_Lambda_i_wrist_roll_46 * R_P_wrist_roll_13;
    const six_link_real t136 = t134 * minus_R_T_forearm_xy + Lambda_i_wrist_roll_45 * R_P_wrist_roll_22
        - minus_Lambda_i_wrist_roll_46 * R_P_wrist_roll_23;
    const six_link_real t137 = Lambda_i_wrist_roll_45 * R_P_wrist_roll_32 - t134 * R_T_forearm_xz
        - minus_Lambda_i_wrist_roll_46 * R_P_wrist_roll_33;
    const six_link_real t138 = (Lambda_i_wrist_roll_55 - Lambda_i_wrist_roll_66) * REAL(0.5);
    const six_link_real t139 = t138 * R_P_wrist_roll_12 + Lambda_i_wrist_roll_56 * R_P_wrist_roll_13;
    const six_link_real t140 = t138 * R_P_wrist_roll_22 + Lambda_i_wrist_roll_56 * R_P_wrist_roll_23;
    const six_link_real t141 = t138 * R_P_wrist_roll_32 + Lambda_i_wrist_roll_56 * R_P_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_16 = (R_T_forearm_xx * t135 + R_P_wrist_roll_12 * t139) * 2
        + Lambda_i_wrist_roll_66;
    const six_link_real Lambda_wrist_roll_17 = R_T_forearm_xx * t136 + R_P_wrist_roll_12 * t140
        + (minus_R_T_forearm_xy * t135 + R_P_wrist_roll_22 * t139);
    const six_link_real Lambda_wrist_roll_18 = R_T_forearm_xx * t137 + R_P_wrist_roll_12 * t141
        + (R_P_wrist_roll_32 * t139 - R_T_forearm_xz * t135);
    const six_link_real Lambda_wrist_roll_19 = (minus_R_T_forearm_xy * t136 + R_P_wrist_roll_22 * t140) * 2
        + Lambda_i_wrist_roll_66;
    const six_link_real Lambda_wrist_roll_20 = minus_R_T_forearm_xy * t137 + R_P_wrist_roll_22 * t141
        + (R_P_wrist_roll_32 * t140 - R_T_forearm_xz * t136);
    const six_link_real Lambda_wrist_roll_21 = (R_P_wrist_roll_32 * t141 - R_T_forearm_xz * t137) * 2
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
    const six_link_real S_forearm_y = c->links[2].S_B_y + state->q[11] * c->links[2].sigma_y1
        + state->q[12] * c->links[2].sigma_y2;
    const six_link_real S_forearm_z = c->links[2].S_B_z + state->q[13] * c->links[2].sigma_y1
        + state->q[14] * c->links[2].sigma_y2;

    /* forearm, Sdot: rate of the first moment */
    const six_link_real Sdot_forearm_y = state->v[11] * c->links[2].sigma_y1 + state->v[12] * c->links[2].sigma_y2;
    const six_link_real Sdot_forearm_z = state->v[13] * c->links[2].sigma_y1 + state->v[14] * c->links[2].sigma_y2;

    /* forearm, L: first moment weighted by each mode shape (85) */
    const six_link_real L_forearm_y1 = c->links[2].mu * state->q[11];
    const six_link_real L_forearm_y2 = c->links[2].mu * state->q[12];
    const six_link_real L_forearm_z1 = state->q[13] * c->links[2].mu;
    const six_link_real L_forearm_z2 = state->q[14] * c->links[2].mu;

    /* forearm, Ldot: rate of L */
    const six_link_real Ldot_forearm_y1 = c->links[2].mu * state->v[11];
    const six_link_real Ldot_forearm_y2 = c->links[2].mu * state->v[12];
    const six_link_real Ldot_forearm_z1 = state->v[13] * c->links[2].mu;
    const six_link_real Ldot_forearm_z2 = state->v[14] * c->links[2].mu;

    /* forearm, J: second moment */
    const six_link_real J_forearm_xy = c->links[2].J_B_xy + c->links[2].chi_1 * state->q[11]
        + c->links[2].chi_2 * state->q[12];
    const six_link_real J_forearm_xz = c->links[2].J_B_xz + c->links[2].chi_1 * state->q[13]
        + c->links[2].chi_2 * state->q[14];
    const six_link_real J_forearm_yy = c->links[2].J_B_yy + L_forearm_y1 * state->q[11] + L_forearm_y2 * state->q[12];
    const six_link_real J_forearm_yz = c->links[2].J_B_yz + L_forearm_z1 * state->q[11] + L_forearm_z2 * state->q[12];
    const six_link_real J_forearm_zz = c->links[2].J_B_zz + L_forearm_z1 * state->q[13] + L_forearm_z2 * state->q[14];

    /* forearm, I: inertia about the origin, deformed */
    const six_link_real I_forearm_xx = c->links[2].I_s + J_forearm_yy + J_forearm_zz;
    const six_link_real I_forearm_yy = c->links[2].J_0_xx + J_forearm_zz;
    const six_link_real I_forearm_zz = c->links[2].J_0_xx + J_forearm_yy;

    /* forearm, Omega: acceleration of a place by the link's turning */
    const six_link_real t142 = omega_forearm_y * omega_forearm_y;
    const six_link_real t143 = omega_R_forearm_3 * omega_R_forearm_3;
    const six_link_real minus_Omega_forearm_xx = t142 + t143;
    const six_link_real t144 = omega_R_forearm_1 * omega_forearm_y;
    const six_link_real Omega_forearm_xy = t144 - alpha_forearm_z;
    const six_link_real t145 = omega_R_forearm_1 * omega_R_forearm_3;
    const six_link_real Omega_forearm_xz = alpha_0_forearm_2 + t145;
    const six_link_real Omega_forearm_yx = alpha_forearm_z + t144;
    const six_link_real t146 = omega_R_forearm_1 * omega_R_forearm_1;
    const six_link_real minus_Omega_forearm_yy = t146 + t143;
    const six_link_real t147 = omega_forearm_y * omega_R_forearm_3;
    const six_link_real Omega_forearm_yz = t147 - alpha_forearm_x;
    const six_link_real Omega_forearm_zx = t145 - alpha_0_forearm_2;
    const six_link_real Omega_forearm_zy = alpha_forearm_x + t147;
    const six_link_real minus_Omega_forearm_zz = t146 + t142;

    /* forearm, B: moment of the elastic velocity */
    const six_link_real B_forearm_yx = c->links[2].chi_1 * state->v[11] + c->links[2].chi_2 * state->v[12];
    const six_link_real B_forearm_yy = L_forearm_y1 * state->v[11] + L_forearm_y2 * state->v[12];
    const six_link_real B_forearm_yz = L_forearm_z1 * state->v[11] + L_forearm_z2 * state->v[12];
    const six_link_real B_forearm_zx = c->links[2].chi_1 * state->v[13] + c->links[2].chi_2 * state->v[14];
    const six_link_real B_forearm_zy = L_forearm_y1 * state->v[13] + L_forearm_y2 * state->v[14];
    const six_link_real B_forearm_zz = L_forearm_z1 * state->v[13] + L_forearm_z2 * state->v[14];

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
    const six_link_real t148 = h_c_forearm_1 + c->links[2].I_s * alpha_forearm_x + J_forearm_xy * Omega_forearm_zx
        + J_forearm_yy * Omega_forearm_zy;
    const six_link_real t149 = t148 + J_forearm_yz * (minus_Omega_forearm_yy - minus_Omega_forearm_zz)
        + S_forearm_y * a_J_forearm_z;
    const six_link_real H_star_forearm_1 = t149 - J_forearm_xz * Omega_forearm_yx - J_forearm_zz * Omega_forearm_yz
        - S_forearm_z * a_J_forearm_y;
    const six_link_real t150 = h_c_forearm_2 + J_forearm_xz * (minus_Omega_forearm_zz - minus_Omega_forearm_xx)
        + J_forearm_yz * Omega_forearm_xy;
    const six_link_real t151 = c->links[2].I_s * omega_R_forearm_1;
    const six_link_real t152 = t150 + J_forearm_zz * Omega_forearm_xz + S_forearm_z * a_J_forearm_x
        + t151 * omega_R_forearm_3 - c->links[2].J_0_xx * Omega_forearm_zx;
    const six_link_real H_star_forearm_2 = t152 - J_forearm_xy * Omega_forearm_zy - c->links[2].S_0_x * a_J_forearm_z;
    const six_link_real t153 = h_c_forearm_3 + c->links[2].J_0_xx * Omega_forearm_yx
        + J_forearm_xy * (minus_Omega_forearm_xx - minus_Omega_forearm_yy);
    const six_link_real t154 = t153 + J_forearm_xz * Omega_forearm_yz + c->links[2].S_0_x * a_J_forearm_y
        - J_forearm_yy * Omega_forearm_xy;
    const six_link_real H_star_forearm_3 = t154 - J_forearm_yz * Omega_forearm_xz - S_forearm_y * a_J_forearm_x
        - t151 * omega_forearm_y;
    const six_link_real t155 = h_c_forearm_4 - minus_Omega_forearm_xx * c->links[2].S_0_x
        + Omega_forearm_xy * S_forearm_y + Omega_forearm_xz * S_forearm_z;
    const six_link_real H_star_forearm_4 = t155 + a_J_forearm_x * c->links[2].m;
    const six_link_real t156 = Omega_forearm_yx * c->links[2].S_0_x - minus_h_c_forearm_5
        - minus_Omega_forearm_yy * S_forearm_y;
    const six_link_real H_star_forearm_5 = t156 + Omega_forearm_yz * S_forearm_z + a_J_forearm_y * c->links[2].m;
    const six_link_real t157 = h_c_forearm_6 + Omega_forearm_zx * c->links[2].S_0_x + Omega_forearm_zy * S_forearm_y
        - minus_Omega_forearm_zz * S_forearm_z;
    const six_link_real H_star_forearm_6 = t157 + a_J_forearm_z * c->links[2].m;

    /* forearm, h_V: bias of the twist rows, angular acceleration included */
    const six_link_real h_V_forearm_1 = H_star_forearm_1 + h_c_forearm_1;
    const six_link_real h_V_forearm_2 = H_star_forearm_2 + h_c_forearm_2;
    const six_link_real h_V_forearm_3 = H_star_forearm_3 + h_c_forearm_3;
    const six_link_real h_V_forearm_4 = H_star_forearm_4 + h_c_forearm_4;
    const six_link_real h_V_forearm_5 = H_star_forearm_5 - minus_h_c_forearm_5;
    const six_link_real h_V_forearm_6 = H_star_forearm_6 + h_c_forearm_6;

    /* forearm, h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const six_link_real t158 = L_forearm_z1 * Omega_forearm_yz - L_forearm_y1 * minus_Omega_forearm_yy
        + Omega_forearm_yx * c->links[2].chi_1;
    const six_link_real h_eta_forearm_1 = t158 + a_J_forearm_y * c->links[2].sigma_y1
        - Ldot_forearm_z1 * 2 * omega_R_forearm_1;
    const six_link_real t159 = L_forearm_z2 * Omega_forearm_yz - L_forearm_y2 * minus_Omega_forearm_yy
        + Omega_forearm_yx * c->links[2].chi_2;
    const six_link_real h_eta_forearm_2 = t159 + a_J_forearm_y * c->links[2].sigma_y2
        - Ldot_forearm_z2 * 2 * omega_R_forearm_1;
    const six_link_real t160 = L_forearm_y1 * Omega_forearm_zy - L_forearm_z1 * minus_Omega_forearm_zz
        + Omega_forearm_zx * c->links[2].chi_1;
    const six_link_real h_eta_forearm_3 = t160 + a_J_forearm_z * c->links[2].sigma_y1
        + Ldot_forearm_y1 * 2 * omega_R_forearm_1;
    const six_link_real t161 = L_forearm_y2 * Omega_forearm_zy - L_forearm_z2 * minus_Omega_forearm_zz
        + Omega_forearm_zx * c->links[2].chi_2;
    const six_link_real h_eta_forearm_4 = t161 + a_J_forearm_z * c->links[2].sigma_y2
        + Ldot_forearm_y2 * 2 * omega_R_forearm_1;

    /* forearm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t162 = R_T_forearm_xx * input->w_ext[2][0] - minus_R_T_forearm_xy * input->w_ext[2][1]
        + R_T_forearm_xz * input->w_ext[2][2];
    const six_link_real t163 = minus_R_T_forearm_xy * input->w_ext[2][0] + R_T_forearm_yy * input->w_ext[2][1]
        + R_T_forearm_yz * input->w_ext[2][2];
    const six_link_real t164 = R_T_forearm_yz * input->w_ext[2][1] - R_T_forearm_xz * input->w_ext[2][0]
        + R_T_forearm_zz * input->w_ext[2][2];
    const six_link_real t165 = R_T_forearm_xx * input->w_ext[2][3] - minus_R_T_forearm_xy * input->w_ext[2][4]
        + R_T_forearm_xz * input->w_ext[2][5];
    const six_link_real t166 = minus_R_T_forearm_xy * input->w_ext[2][3] + R_T_forearm_yy * input->w_ext[2][4]
        + R_T_forearm_yz * input->w_ext[2][5];
    const six_link_real t167 = R_T_forearm_yz * input->w_ext[2][4] - R_T_forearm_xz * input->w_ext[2][3]
        + R_T_forearm_zz * input->w_ext[2][5];
    const six_link_real p_T_forearm_1 = p_wrist_roll_1 - t162;
    const six_link_real p_T_forearm_2 = p_wrist_roll_2 - t163;
    const six_link_real p_T_forearm_3 = p_wrist_roll_3 - t164;
    const six_link_real p_T_forearm_4 = p_wrist_roll_4 - t165;
    const six_link_real p_T_forearm_5 = p_wrist_roll_5 - t166;
    const six_link_real p_T_forearm_6 = p_wrist_roll_6 - t167;

    /* forearm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real Theta_forearm_11 = J_l_forearm_xz * c->links[2].Psi_c_z1;
    const six_link_real Theta_forearm_12 = J_l_forearm_xz * c->links[2].Psi_c_z2;
    const six_link_real minus_Theta_forearm_13 = minus_J_l_forearm_xy * c->links[2].Psi_c_y3;
    const six_link_real minus_Theta_forearm_14 = minus_J_l_forearm_xy * c->links[2].Psi_c_y4;
    const six_link_real Theta_forearm_21 = J_l_forearm_yz * c->links[2].Psi_c_z1;
    const six_link_real Theta_forearm_22 = J_l_forearm_yz * c->links[2].Psi_c_z2;
    const six_link_real Theta_forearm_23 = J_l_forearm_yy * c->links[2].Psi_c_y3;
    const six_link_real Theta_forearm_24 = J_l_forearm_yy * c->links[2].Psi_c_y4;
    const six_link_real Theta_forearm_31 = J_l_forearm_zz * c->links[2].Psi_c_z1;
    const six_link_real Theta_forearm_32 = J_l_forearm_zz * c->links[2].Psi_c_z2;
    const six_link_real Theta_forearm_33 = J_l_forearm_yz * c->links[2].Psi_c_y3;
    const six_link_real Theta_forearm_34 = J_l_forearm_yz * c->links[2].Psi_c_y4;
    const six_link_real t168 = r_T_forearm_z * Lambda_wrist_roll_17;
    const six_link_real t169 = r_T_forearm_y * Lambda_wrist_roll_18;
    const six_link_real t170 = c->links[2].length * Lambda_wrist_roll_20;
    const six_link_real M_loaded_forearm_14 = Lambda_wrist_roll_4 + (t169 - t168);
    const six_link_real t171 = Lambda_wrist_roll_5
        + (r_T_forearm_y * Lambda_wrist_roll_20 - r_T_forearm_z * Lambda_wrist_roll_19);
    const six_link_real t172 = Lambda_wrist_roll_6
        + (r_T_forearm_y * Lambda_wrist_roll_21 - r_T_forearm_z * Lambda_wrist_roll_20);
    const six_link_real t173 = Lambda_wrist_roll_9
        + (r_T_forearm_z * Lambda_wrist_roll_16 - c->links[2].length * Lambda_wrist_roll_18);
    const six_link_real M_loaded_forearm_25 = Lambda_wrist_roll_10 + (t168 - t170);
    const six_link_real t174 = Lambda_wrist_roll_11
        + (r_T_forearm_z * Lambda_wrist_roll_18 - c->links[2].length * Lambda_wrist_roll_21);
    const six_link_real t175 = Lambda_wrist_roll_13
        + (c->links[2].length * Lambda_wrist_roll_17 - r_T_forearm_y * Lambda_wrist_roll_16);
    const six_link_real t176 = Lambda_wrist_roll_14
        + (c->links[2].length * Lambda_wrist_roll_19 - r_T_forearm_y * Lambda_wrist_roll_17);
    const six_link_real M_loaded_forearm_36 = Lambda_wrist_roll_15 + (t170 - t169);
    const six_link_real t177 = Lambda_wrist_roll_1
        - (Lambda_wrist_roll_5 * r_T_forearm_z - Lambda_wrist_roll_6 * r_T_forearm_y);
    const six_link_real t178 = Lambda_wrist_roll_2
        - (Lambda_wrist_roll_6 * c->links[2].length - Lambda_wrist_roll_4 * r_T_forearm_z);
    const six_link_real t179 = Lambda_wrist_roll_3
        - (Lambda_wrist_roll_4 * r_T_forearm_y - Lambda_wrist_roll_5 * c->links[2].length);
    const six_link_real t180 = Lambda_wrist_roll_7
        - (Lambda_wrist_roll_11 * c->links[2].length - Lambda_wrist_roll_9 * r_T_forearm_z);
    const six_link_real t181 = Lambda_wrist_roll_8
        - (Lambda_wrist_roll_9 * r_T_forearm_y - Lambda_wrist_roll_10 * c->links[2].length);
    const six_link_real t182 = Lambda_wrist_roll_12
        - (Lambda_wrist_roll_13 * r_T_forearm_y - Lambda_wrist_roll_14 * c->links[2].length);
    const six_link_real M_loaded_forearm_11 = I_forearm_xx + (t177 + (r_T_forearm_y * t172 - r_T_forearm_z * t171));
    const six_link_real M_loaded_forearm_12 = t178 + (r_T_forearm_y * t174 - r_T_forearm_z * M_loaded_forearm_25)
        - J_forearm_xy;
    const six_link_real M_loaded_forearm_13 = t179 + (r_T_forearm_y * M_loaded_forearm_36 - r_T_forearm_z * t176)
        - J_forearm_xz;
    const six_link_real M_loaded_forearm_15 = t171 - S_forearm_z;
    const six_link_real M_loaded_forearm_16 = S_forearm_y + t172;
    const six_link_real M_loaded_forearm_22 = I_forearm_yy
        + (t180 + (r_T_forearm_z * t173 - c->links[2].length * t174));
    const six_link_real M_loaded_forearm_23 = t181 + (r_T_forearm_z * t175 - c->links[2].length * M_loaded_forearm_36)
        - J_forearm_yz;
    const six_link_real M_loaded_forearm_24 = S_forearm_z + t173;
    const six_link_real M_loaded_forearm_26 = t174 - c->links[2].S_0_x;
    const six_link_real M_loaded_forearm_33 = I_forearm_zz
        + (t182 + (c->links[2].length * t176 - r_T_forearm_y * t175));
    const six_link_real M_loaded_forearm_34 = t175 - S_forearm_y;
    const six_link_real M_loaded_forearm_35 = c->links[2].S_0_x + t176;
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
    const six_link_real t183 = Lambda_wrist_roll_1 * Theta_forearm_11 + Lambda_wrist_roll_2 * Theta_forearm_21
        + Lambda_wrist_roll_3 * Theta_forearm_31;
    const six_link_real t184 = t183 + Lambda_wrist_roll_5 * REAL(2.0195202782688155);
    const six_link_real t185 = Lambda_wrist_roll_1 * Theta_forearm_12 + Lambda_wrist_roll_2 * Theta_forearm_22
        + Lambda_wrist_roll_3 * Theta_forearm_32;
    const six_link_real t186 = t185 + Lambda_wrist_roll_5 * REAL(2.8145226674626453);
    const six_link_real t187 = Lambda_wrist_roll_2 * Theta_forearm_23 - Lambda_wrist_roll_1 * minus_Theta_forearm_13
        + Lambda_wrist_roll_3 * Theta_forearm_33;
    const six_link_real t188 = t187 + Lambda_wrist_roll_6 * REAL(2.0195202782688155);
    const six_link_real t189 = Lambda_wrist_roll_2 * Theta_forearm_24 - Lambda_wrist_roll_1 * minus_Theta_forearm_14
        + Lambda_wrist_roll_3 * Theta_forearm_34;
    const six_link_real t190 = t189 + Lambda_wrist_roll_6 * REAL(2.8145226674626453);
    const six_link_real t191 = Lambda_wrist_roll_2 * Theta_forearm_11 + Lambda_wrist_roll_7 * Theta_forearm_21
        + Lambda_wrist_roll_8 * Theta_forearm_31;
    const six_link_real t192 = t191 + Lambda_wrist_roll_10 * REAL(2.0195202782688155);
    const six_link_real t193 = Lambda_wrist_roll_2 * Theta_forearm_12 + Lambda_wrist_roll_7 * Theta_forearm_22
        + Lambda_wrist_roll_8 * Theta_forearm_32;
    const six_link_real t194 = t193 + Lambda_wrist_roll_10 * REAL(2.8145226674626453);
    const six_link_real t195 = Lambda_wrist_roll_7 * Theta_forearm_23 - Lambda_wrist_roll_2 * minus_Theta_forearm_13
        + Lambda_wrist_roll_8 * Theta_forearm_33;
    const six_link_real t196 = t195 + Lambda_wrist_roll_11 * REAL(2.0195202782688155);
    const six_link_real t197 = Lambda_wrist_roll_7 * Theta_forearm_24 - Lambda_wrist_roll_2 * minus_Theta_forearm_14
        + Lambda_wrist_roll_8 * Theta_forearm_34;
    const six_link_real t198 = t197 + Lambda_wrist_roll_11 * REAL(2.8145226674626453);
    const six_link_real t199 = Lambda_wrist_roll_3 * Theta_forearm_11 + Lambda_wrist_roll_8 * Theta_forearm_21
        + Lambda_wrist_roll_12 * Theta_forearm_31;
    const six_link_real t200 = t199 + Lambda_wrist_roll_14 * REAL(2.0195202782688155);
    const six_link_real t201 = Lambda_wrist_roll_3 * Theta_forearm_12 + Lambda_wrist_roll_8 * Theta_forearm_22
        + Lambda_wrist_roll_12 * Theta_forearm_32;
    const six_link_real t202 = t201 + Lambda_wrist_roll_14 * REAL(2.8145226674626453);
    const six_link_real t203 = Lambda_wrist_roll_8 * Theta_forearm_23 - Lambda_wrist_roll_3 * minus_Theta_forearm_13
        + Lambda_wrist_roll_12 * Theta_forearm_33;
    const six_link_real t204 = t203 + Lambda_wrist_roll_15 * REAL(2.0195202782688155);
    const six_link_real t205 = Lambda_wrist_roll_8 * Theta_forearm_24 - Lambda_wrist_roll_3 * minus_Theta_forearm_14
        + Lambda_wrist_roll_12 * Theta_forearm_34;
    const six_link_real t206 = t205 + Lambda_wrist_roll_15 * REAL(2.8145226674626453);
    const six_link_real t207 = Lambda_wrist_roll_4 * Theta_forearm_11 + Lambda_wrist_roll_9 * Theta_forearm_21
        + Lambda_wrist_roll_13 * Theta_forearm_31;
    const six_link_real C_forearm_41 = t207 + Lambda_wrist_roll_17 * REAL(2.0195202782688155);
    const six_link_real t208 = Lambda_wrist_roll_4 * Theta_forearm_12 + Lambda_wrist_roll_9 * Theta_forearm_22
        + Lambda_wrist_roll_13 * Theta_forearm_32;
    const six_link_real C_forearm_42 = t208 + Lambda_wrist_roll_17 * REAL(2.8145226674626453);
    const six_link_real t209 = Lambda_wrist_roll_9 * Theta_forearm_23 - Lambda_wrist_roll_4 * minus_Theta_forearm_13
        + Lambda_wrist_roll_13 * Theta_forearm_33;
    const six_link_real C_forearm_43 = t209 + Lambda_wrist_roll_18 * REAL(2.0195202782688155);
    const six_link_real t210 = Lambda_wrist_roll_9 * Theta_forearm_24 - Lambda_wrist_roll_4 * minus_Theta_forearm_14
        + Lambda_wrist_roll_13 * Theta_forearm_34;
    const six_link_real C_forearm_44 = t210 + Lambda_wrist_roll_18 * REAL(2.8145226674626453);
    const six_link_real t211 = Lambda_wrist_roll_5 * Theta_forearm_11 + Lambda_wrist_roll_10 * Theta_forearm_21
        + Lambda_wrist_roll_14 * Theta_forearm_31;
    const six_link_real t212 = t211 + Lambda_wrist_roll_19 * REAL(2.0195202782688155);
    const six_link_real t213 = Lambda_wrist_roll_5 * Theta_forearm_12 + Lambda_wrist_roll_10 * Theta_forearm_22
        + Lambda_wrist_roll_14 * Theta_forearm_32;
    const six_link_real t214 = t213 + Lambda_wrist_roll_19 * REAL(2.8145226674626453);
    const six_link_real t215 = Lambda_wrist_roll_10 * Theta_forearm_23 - Lambda_wrist_roll_5 * minus_Theta_forearm_13
        + Lambda_wrist_roll_14 * Theta_forearm_33;
    const six_link_real t216 = Lambda_wrist_roll_20 * REAL(2.0195202782688155);
    const six_link_real C_forearm_53 = t215 + t216;
    const six_link_real t217 = Lambda_wrist_roll_10 * Theta_forearm_24 - Lambda_wrist_roll_5 * minus_Theta_forearm_14
        + Lambda_wrist_roll_14 * Theta_forearm_34;
    const six_link_real t218 = Lambda_wrist_roll_20 * REAL(2.8145226674626453);
    const six_link_real C_forearm_54 = t217 + t218;
    const six_link_real t219 = Lambda_wrist_roll_6 * Theta_forearm_11 + Lambda_wrist_roll_11 * Theta_forearm_21
        + Lambda_wrist_roll_15 * Theta_forearm_31;
    const six_link_real C_forearm_61 = t219 + t216;
    const six_link_real t220 = Lambda_wrist_roll_6 * Theta_forearm_12 + Lambda_wrist_roll_11 * Theta_forearm_22
        + Lambda_wrist_roll_15 * Theta_forearm_32;
    const six_link_real C_forearm_62 = t220 + t218;
    const six_link_real t221 = Lambda_wrist_roll_11 * Theta_forearm_23 - Lambda_wrist_roll_6 * minus_Theta_forearm_13
        + Lambda_wrist_roll_15 * Theta_forearm_33;
    const six_link_real t222 = t221 + Lambda_wrist_roll_21 * REAL(2.0195202782688155);
    const six_link_real t223 = Lambda_wrist_roll_11 * Theta_forearm_24 - Lambda_wrist_roll_6 * minus_Theta_forearm_14
        + Lambda_wrist_roll_15 * Theta_forearm_34;
    const six_link_real t224 = t223 + Lambda_wrist_roll_21 * REAL(2.8145226674626453);
    const six_link_real C_forearm_21 = t192 + (r_T_forearm_z * C_forearm_41 - c->links[2].length * C_forearm_61);
    const six_link_real C_forearm_22 = t194 + (r_T_forearm_z * C_forearm_42 - c->links[2].length * C_forearm_62);
    const six_link_real C_forearm_33 = t204 + (c->links[2].length * C_forearm_53 - r_T_forearm_y * C_forearm_43);
    const six_link_real C_forearm_34 = t206 + (c->links[2].length * C_forearm_54 - r_T_forearm_y * C_forearm_44);
    const six_link_real C_forearm_11 = t184 + (r_T_forearm_y * C_forearm_61 - r_T_forearm_z * t212) - L_forearm_z1;
    const six_link_real C_forearm_12 = t186 + (r_T_forearm_y * C_forearm_62 - r_T_forearm_z * t214) - L_forearm_z2;
    const six_link_real C_forearm_13 = L_forearm_y1 + (t188 + (r_T_forearm_y * t222 - r_T_forearm_z * C_forearm_53));
    const six_link_real C_forearm_14 = L_forearm_y2 + (t190 + (r_T_forearm_y * t224 - r_T_forearm_z * C_forearm_54));
    const six_link_real C_forearm_23 = t196 + (r_T_forearm_z * C_forearm_43 - c->links[2].length * t222)
        - c->links[2].chi_1;
    const six_link_real C_forearm_24 = t198 + (r_T_forearm_z * C_forearm_44 - c->links[2].length * t224)
        - c->links[2].chi_2;
    const six_link_real C_forearm_31 = c->links[2].chi_1
        + (t200 + (c->links[2].length * t212 - r_T_forearm_y * C_forearm_41));
    const six_link_real C_forearm_32 = c->links[2].chi_2
        + (t202 + (c->links[2].length * t214 - r_T_forearm_y * C_forearm_42));
    const six_link_real C_forearm_51 = c->links[2].sigma_y1 + t212;
    const six_link_real C_forearm_52 = c->links[2].sigma_y2 + t214;
    const six_link_real C_forearm_63 = c->links[2].sigma_y1 + t222;
    const six_link_real C_forearm_64 = c->links[2].sigma_y2 + t224;
    const six_link_real t225 = Theta_forearm_11 * t184 + Theta_forearm_21 * t192 + Theta_forearm_31 * t200
        + t212 * REAL(2.0195202782688155);
    const six_link_real modal_inertia_forearm_11 = t225 + m_eta[11];
    bad |= (unsigned long)(!(modal_inertia_forearm_11 > 0)) << 2;
    const six_link_real modal_inertia_forearm_12 = Theta_forearm_11 * t186 + Theta_forearm_21 * t194
        + Theta_forearm_31 * t202 + t214 * REAL(2.0195202782688155);
    const six_link_real modal_inertia_forearm_13 = Theta_forearm_11 * t188 + Theta_forearm_21 * t196
        + Theta_forearm_31 * t204 + C_forearm_53 * REAL(2.0195202782688155);
    const six_link_real modal_inertia_forearm_14 = Theta_forearm_11 * t190 + Theta_forearm_21 * t198
        + Theta_forearm_31 * t206 + C_forearm_54 * REAL(2.0195202782688155);
    const six_link_real t226 = Theta_forearm_12 * t186 + Theta_forearm_22 * t194 + Theta_forearm_32 * t202
        + t214 * REAL(2.8145226674626453);
    const six_link_real modal_inertia_forearm_22 = t226 + m_eta[12];
    const six_link_real modal_inertia_forearm_23 = Theta_forearm_12 * t188 + Theta_forearm_22 * t196
        + Theta_forearm_32 * t204 + C_forearm_53 * REAL(2.8145226674626453);
    const six_link_real modal_inertia_forearm_24 = Theta_forearm_12 * t190 + Theta_forearm_22 * t198
        + Theta_forearm_32 * t206 + C_forearm_54 * REAL(2.8145226674626453);
    const six_link_real t227 = Theta_forearm_23 * t196 - minus_Theta_forearm_13 * t188 + Theta_forearm_33 * t204
        + t222 * REAL(2.0195202782688155);
    const six_link_real modal_inertia_forearm_33 = t227 + m_eta[13];
    const six_link_real modal_inertia_forearm_34 = Theta_forearm_23 * t198 - minus_Theta_forearm_13 * t190
        + Theta_forearm_33 * t206 + t224 * REAL(2.0195202782688155);
    const six_link_real t228 = Theta_forearm_24 * t198 - minus_Theta_forearm_14 * t190 + Theta_forearm_34 * t206
        + t224 * REAL(2.8145226674626453);
    const six_link_real modal_inertia_forearm_44 = t228 + m_eta[14];
    const six_link_real t229 = Theta_forearm_11 * p_T_forearm_1 + Theta_forearm_21 * p_T_forearm_2
        + Theta_forearm_31 * p_T_forearm_3;
    const six_link_real t230 = Theta_forearm_12 * p_T_forearm_1 + Theta_forearm_22 * p_T_forearm_2
        + Theta_forearm_32 * p_T_forearm_3;
    const six_link_real t231 = Theta_forearm_23 * p_T_forearm_2 - minus_Theta_forearm_13 * p_T_forearm_1
        + Theta_forearm_33 * p_T_forearm_3;
    const six_link_real t232 = Theta_forearm_24 * p_T_forearm_2 - minus_Theta_forearm_14 * p_T_forearm_1
        + Theta_forearm_34 * p_T_forearm_3;
    const six_link_real h_phi_forearm_1 = h_eta_forearm_1 + work->f_eta[11]
        + (t229 + p_T_forearm_5 * REAL(2.0195202782688155));
    const six_link_real h_phi_forearm_2 = h_eta_forearm_2 + work->f_eta[12]
        + (t230 + p_T_forearm_5 * REAL(2.8145226674626453));
    const six_link_real h_phi_forearm_3 = h_eta_forearm_3 + work->f_eta[13]
        + (t231 + p_T_forearm_6 * REAL(2.0195202782688155));
    const six_link_real h_phi_forearm_4 = h_eta_forearm_4 + work->f_eta[14]
        + (t232 + p_T_forearm_6 * REAL(2.8145226674626453));
    const six_link_real modes_inverse_forearm_1 = 1 / modal_inertia_forearm_11;
    const six_link_real modes_L_forearm_21 = modal_inertia_forearm_12 * modes_inverse_forearm_1;
    const six_link_real modes_L_forearm_31 = modal_inertia_forearm_13 * modes_inverse_forearm_1;
    const six_link_real modes_L_forearm_41 = modal_inertia_forearm_14 * modes_inverse_forearm_1;
    const six_link_real t233 = modal_inertia_forearm_22 - modal_inertia_forearm_12 * modes_L_forearm_21;
    bad |= (unsigned long)(!(t233 > 0)) << 2;
    const six_link_real modes_inverse_forearm_2 = 1 / t233;
    const six_link_real t234 = modal_inertia_forearm_23 - modal_inertia_forearm_12 * modes_L_forearm_31;
    const six_link_real modes_L_forearm_32 = t234 * modes_inverse_forearm_2;
    const six_link_real t235 = modal_inertia_forearm_24 - modal_inertia_forearm_12 * modes_L_forearm_41;
    const six_link_real modes_L_forearm_42 = t235 * modes_inverse_forearm_2;
    const six_link_real t236 = modal_inertia_forearm_33
        - (modal_inertia_forearm_13 * modes_L_forearm_31 + t234 * modes_L_forearm_32);
    bad |= (unsigned long)(!(t236 > 0)) << 2;
    const six_link_real modes_inverse_forearm_3 = 1 / t236;
    const six_link_real t237 = modal_inertia_forearm_34
        - (modal_inertia_forearm_13 * modes_L_forearm_41 + t234 * modes_L_forearm_42);
    const six_link_real modes_L_forearm_43 = t237 * modes_inverse_forearm_3;
    const six_link_real t238 = modal_inertia_forearm_14 * modes_L_forearm_41 + t235 * modes_L_forearm_42
        + t237 * modes_L_forearm_43;
    const six_link_real t239 = modal_inertia_forearm_44 - t238;
    bad |= (unsigned long)(!(t239 > 0)) << 2;
    const six_link_real modes_inverse_forearm_4 = 1 / t239;
    const six_link_real t240 = C_forearm_12 - modes_L_forearm_21 * C_forearm_11;
    const six_link_real t241 = C_forearm_22 - modes_L_forearm_21 * C_forearm_21;
    const six_link_real t242 = C_forearm_32 - modes_L_forearm_21 * C_forearm_31;
    const six_link_real t243 = C_forearm_42 - modes_L_forearm_21 * C_forearm_41;
    const six_link_real t244 = C_forearm_52 - modes_L_forearm_21 * C_forearm_51;
    const six_link_real t245 = C_forearm_62 - modes_L_forearm_21 * C_forearm_61;
    const six_link_real t246 = C_forearm_13 - modes_L_forearm_31 * C_forearm_11 - modes_L_forearm_32 * t240;
    const six_link_real t247 = C_forearm_23 - modes_L_forearm_31 * C_forearm_21 - modes_L_forearm_32 * t241;
    const six_link_real t248 = C_forearm_33 - modes_L_forearm_31 * C_forearm_31 - modes_L_forearm_32 * t242;
    const six_link_real t249 = C_forearm_43 - modes_L_forearm_31 * C_forearm_41 - modes_L_forearm_32 * t243;
    const six_link_real t250 = C_forearm_53 - modes_L_forearm_31 * C_forearm_51 - modes_L_forearm_32 * t244;
    const six_link_real t251 = C_forearm_63 - modes_L_forearm_31 * C_forearm_61 - modes_L_forearm_32 * t245;
    const six_link_real t252 = C_forearm_14 - modes_L_forearm_41 * C_forearm_11 - modes_L_forearm_42 * t240
        - modes_L_forearm_43 * t246;
    const six_link_real t253 = C_forearm_24 - modes_L_forearm_41 * C_forearm_21 - modes_L_forearm_42 * t241
        - modes_L_forearm_43 * t247;
    const six_link_real t254 = C_forearm_34 - modes_L_forearm_41 * C_forearm_31 - modes_L_forearm_42 * t242
        - modes_L_forearm_43 * t248;
    const six_link_real t255 = C_forearm_44 - modes_L_forearm_41 * C_forearm_41 - modes_L_forearm_42 * t243
        - modes_L_forearm_43 * t249;
    const six_link_real t256 = C_forearm_54 - modes_L_forearm_41 * C_forearm_51 - modes_L_forearm_42 * t244
        - modes_L_forearm_43 * t250;
    const six_link_real t257 = C_forearm_64 - modes_L_forearm_41 * C_forearm_61 - modes_L_forearm_42 * t245
        - modes_L_forearm_43 * t251;
    const six_link_real t258 = h_phi_forearm_2 - modes_L_forearm_21 * h_phi_forearm_1;
    const six_link_real t259 = h_phi_forearm_3 - modes_L_forearm_31 * h_phi_forearm_1 - modes_L_forearm_32 * t258;
    const six_link_real t260 = h_phi_forearm_4 - modes_L_forearm_41 * h_phi_forearm_1 - modes_L_forearm_42 * t258
        - modes_L_forearm_43 * t259;
    const six_link_real modes_W_forearm_11 = C_forearm_11 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_12 = C_forearm_21 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_13 = C_forearm_31 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_14 = C_forearm_41 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_15 = C_forearm_51 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_16 = C_forearm_61 * modes_inverse_forearm_1;
    const six_link_real modes_W_forearm_21 = t240 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_22 = t241 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_23 = t242 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_24 = t243 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_25 = t244 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_26 = t245 * modes_inverse_forearm_2;
    const six_link_real modes_W_forearm_31 = t246 * modes_inverse_forearm_3;
    const six_link_real modes_W_forearm_32 = t247 * modes_inverse_forearm_3;
    const six_link_real modes_W_forearm_33 = t248 * modes_inverse_forearm_3;
    const six_link_real modes_W_forearm_34 = t249 * modes_inverse_forearm_3;
    const six_link_real modes_W_forearm_35 = t250 * modes_inverse_forearm_3;
    const six_link_real modes_W_forearm_36 = t251 * modes_inverse_forearm_3;
    const six_link_real modes_W_forearm_41 = t252 * modes_inverse_forearm_4;
    const six_link_real modes_W_forearm_42 = t253 * modes_inverse_forearm_4;
    const six_link_real modes_W_forearm_43 = t254 * modes_inverse_forearm_4;
    const six_link_real modes_W_forearm_44 = t255 * modes_inverse_forearm_4;
    const six_link_real modes_W_forearm_45 = t256 * modes_inverse_forearm_4;
    const six_link_real modes_W_forearm_46 = t257 * modes_inverse_forearm_4;
    const six_link_real modes_w_forearm_1 = h_phi_forearm_1 * modes_inverse_forearm_1;
    const six_link_real modes_w_forearm_2 = t258 * modes_inverse_forearm_2;
    const six_link_real modes_w_forearm_3 = t259 * modes_inverse_forearm_3;
    const six_link_real modes_w_forearm_4 = t260 * modes_inverse_forearm_4;
    const six_link_real t261 = C_forearm_11 * modes_W_forearm_11 + t240 * modes_W_forearm_21
        + t246 * modes_W_forearm_31 + t252 * modes_W_forearm_41;
    const six_link_real M_i_forearm_11 = M_loaded_forearm_11 - t261;
    const six_link_real t262 = C_forearm_11 * modes_W_forearm_12 + t240 * modes_W_forearm_22
        + t246 * modes_W_forearm_32 + t252 * modes_W_forearm_42;
    const six_link_real M_i_forearm_12 = M_loaded_forearm_12 - t262;
    const six_link_real t263 = C_forearm_11 * modes_W_forearm_13 + t240 * modes_W_forearm_23
        + t246 * modes_W_forearm_33 + t252 * modes_W_forearm_43;
    const six_link_real M_i_forearm_13 = M_loaded_forearm_13 - t263;
    const six_link_real t264 = C_forearm_11 * modes_W_forearm_14 + t240 * modes_W_forearm_24
        + t246 * modes_W_forearm_34 + t252 * modes_W_forearm_44;
    const six_link_real M_i_forearm_14 = M_loaded_forearm_14 - t264;
    const six_link_real t265 = C_forearm_11 * modes_W_forearm_15 + t240 * modes_W_forearm_25
        + t246 * modes_W_forearm_35 + t252 * modes_W_forearm_45;
    const six_link_real M_i_forearm_15 = M_loaded_forearm_15 - t265;
    const six_link_real t266 = C_forearm_11 * modes_W_forearm_16 + t240 * modes_W_forearm_26
        + t246 * modes_W_forearm_36 + t252 * modes_W_forearm_46;
    const six_link_real M_i_forearm_16 = M_loaded_forearm_16 - t266;
    const six_link_real t267 = C_forearm_21 * modes_W_forearm_12 + t241 * modes_W_forearm_22
        + t247 * modes_W_forearm_32 + t253 * modes_W_forearm_42;
    const six_link_real M_i_forearm_22 = M_loaded_forearm_22 - t267;
    const six_link_real t268 = C_forearm_21 * modes_W_forearm_13 + t241 * modes_W_forearm_23
        + t247 * modes_W_forearm_33 + t253 * modes_W_forearm_43;
    const six_link_real M_i_forearm_23 = M_loaded_forearm_23 - t268;
    const six_link_real t269 = C_forearm_21 * modes_W_forearm_14 + t241 * modes_W_forearm_24
        + t247 * modes_W_forearm_34 + t253 * modes_W_forearm_44;
    const six_link_real M_i_forearm_24 = M_loaded_forearm_24 - t269;
    const six_link_real t270 = C_forearm_21 * modes_W_forearm_15 + t241 * modes_W_forearm_25
        + t247 * modes_W_forearm_35 + t253 * modes_W_forearm_45;
    const six_link_real M_i_forearm_25 = M_loaded_forearm_25 - t270;
    const six_link_real t271 = C_forearm_21 * modes_W_forearm_16 + t241 * modes_W_forearm_26
        + t247 * modes_W_forearm_36 + t253 * modes_W_forearm_46;
    const six_link_real M_i_forearm_26 = M_loaded_forearm_26 - t271;
    const six_link_real t272 = C_forearm_31 * modes_W_forearm_13 + t242 * modes_W_forearm_23
        + t248 * modes_W_forearm_33 + t254 * modes_W_forearm_43;
    const six_link_real M_i_forearm_33 = M_loaded_forearm_33 - t272;
    const six_link_real t273 = C_forearm_31 * modes_W_forearm_14 + t242 * modes_W_forearm_24
        + t248 * modes_W_forearm_34 + t254 * modes_W_forearm_44;
    const six_link_real M_i_forearm_34 = M_loaded_forearm_34 - t273;
    const six_link_real t274 = C_forearm_31 * modes_W_forearm_15 + t242 * modes_W_forearm_25
        + t248 * modes_W_forearm_35 + t254 * modes_W_forearm_45;
    const six_link_real M_i_forearm_35 = M_loaded_forearm_35 - t274;
    const six_link_real t275 = C_forearm_31 * modes_W_forearm_16 + t242 * modes_W_forearm_26
        + t248 * modes_W_forearm_36 + t254 * modes_W_forearm_46;
    const six_link_real M_i_forearm_36 = M_loaded_forearm_36 - t275;
    const six_link_real t276 = C_forearm_41 * modes_W_forearm_14 + t243 * modes_W_forearm_24
        + t249 * modes_W_forearm_34 + t255 * modes_W_forearm_44;
    const six_link_real M_i_forearm_44 = M_loaded_forearm_44 - t276;
    const six_link_real t277 = C_forearm_41 * modes_W_forearm_15 + t243 * modes_W_forearm_25
        + t249 * modes_W_forearm_35 + t255 * modes_W_forearm_45;
    const six_link_real M_i_forearm_45 = Lambda_wrist_roll_17 - t277;
    const six_link_real t278 = C_forearm_41 * modes_W_forearm_16 + t243 * modes_W_forearm_26
        + t249 * modes_W_forearm_36 + t255 * modes_W_forearm_46;
    const six_link_real M_i_forearm_46 = Lambda_wrist_roll_18 - t278;
    const six_link_real t279 = C_forearm_51 * modes_W_forearm_15 + t244 * modes_W_forearm_25
        + t250 * modes_W_forearm_35 + t256 * modes_W_forearm_45;
    const six_link_real M_i_forearm_55 = M_loaded_forearm_55 - t279;
    const six_link_real t280 = C_forearm_51 * modes_W_forearm_16 + t244 * modes_W_forearm_26
        + t250 * modes_W_forearm_36 + t256 * modes_W_forearm_46;
    const six_link_real M_i_forearm_56 = Lambda_wrist_roll_20 - t280;
    const six_link_real t281 = C_forearm_61 * modes_W_forearm_16 + t245 * modes_W_forearm_26
        + t251 * modes_W_forearm_36 + t257 * modes_W_forearm_46;
    const six_link_real M_i_forearm_66 = M_loaded_forearm_66 - t281;
    const six_link_real t282 = modes_W_forearm_11 * h_phi_forearm_1 + modes_W_forearm_21 * t258
        + modes_W_forearm_31 * t259 + modes_W_forearm_41 * t260;
    const six_link_real t283 = modes_W_forearm_12 * h_phi_forearm_1 + modes_W_forearm_22 * t258
        + modes_W_forearm_32 * t259 + modes_W_forearm_42 * t260;
    const six_link_real t284 = modes_W_forearm_13 * h_phi_forearm_1 + modes_W_forearm_23 * t258
        + modes_W_forearm_33 * t259 + modes_W_forearm_43 * t260;
    const six_link_real t285 = modes_W_forearm_14 * h_phi_forearm_1 + modes_W_forearm_24 * t258
        + modes_W_forearm_34 * t259 + modes_W_forearm_44 * t260;
    const six_link_real t286 = modes_W_forearm_15 * h_phi_forearm_1 + modes_W_forearm_25 * t258
        + modes_W_forearm_35 * t259 + modes_W_forearm_45 * t260;
    const six_link_real t287 = modes_W_forearm_16 * h_phi_forearm_1 + modes_W_forearm_26 * t258
        + modes_W_forearm_36 * t259 + modes_W_forearm_46 * t260;
    const six_link_real h_i_forearm_1 = h_loaded_forearm_1 - t282;
    const six_link_real h_i_forearm_2 = h_loaded_forearm_2 - t283;
    const six_link_real h_i_forearm_3 = h_loaded_forearm_3 - t284;
    const six_link_real h_i_forearm_4 = h_loaded_forearm_4 - t285;
    const six_link_real h_i_forearm_5 = h_loaded_forearm_5 - t286;
    const six_link_real h_i_forearm_6 = h_loaded_forearm_6 - t287;

    /* forearm, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_forearm_11 = M_i_forearm_22 + m_eta[2];
    bad |= (unsigned long)(!(joint_inertia_forearm_11
        - t88 * (M_i_forearm_11 + M_i_forearm_22 + M_i_forearm_33) > 0)) << 2;
    const six_link_real joint_inverse_forearm_1 = 1 / joint_inertia_forearm_11;
    const six_link_real joint_W_forearm_11 = M_i_forearm_12 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_12 = M_i_forearm_22 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_13 = M_i_forearm_23 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_14 = M_i_forearm_24 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_15 = M_i_forearm_25 * joint_inverse_forearm_1;
    const six_link_real joint_W_forearm_16 = M_i_forearm_26 * joint_inverse_forearm_1;
    const six_link_real joint_w_forearm_1 = (input->tau[2] - work->f_eta[2] - h_i_forearm_2) * joint_inverse_forearm_1;
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
    const six_link_real t288 = r_R_forearm_z * Lambda_i_forearm_45;
    const six_link_real t289 = r_R_forearm_y * Lambda_i_forearm_46;
    const six_link_real t290 = r_R_forearm_x * Lambda_i_forearm_56;
    const six_link_real t291 = Lambda_i_forearm_14 + (t289 - t288);
    const six_link_real t292 = Lambda_i_forearm_15
        + (r_R_forearm_y * Lambda_i_forearm_56 - r_R_forearm_z * Lambda_i_forearm_55);
    const six_link_real t293 = Lambda_i_forearm_16
        + (r_R_forearm_y * Lambda_i_forearm_66 - r_R_forearm_z * Lambda_i_forearm_56);
    const six_link_real t294 = Lambda_i_forearm_24
        + (r_R_forearm_z * Lambda_i_forearm_44 - r_R_forearm_x * Lambda_i_forearm_46);
    const six_link_real t295 = Lambda_i_forearm_25 + (t288 - t290);
    const six_link_real t296 = Lambda_i_forearm_26
        + (r_R_forearm_z * Lambda_i_forearm_46 - r_R_forearm_x * Lambda_i_forearm_66);
    const six_link_real t297 = Lambda_i_forearm_34
        + (r_R_forearm_x * Lambda_i_forearm_45 - r_R_forearm_y * Lambda_i_forearm_44);
    const six_link_real t298 = Lambda_i_forearm_35
        + (r_R_forearm_x * Lambda_i_forearm_55 - r_R_forearm_y * Lambda_i_forearm_45);
    const six_link_real t299 = Lambda_i_forearm_36 + (t290 - t289);
    const six_link_real t300 = Lambda_i_forearm_11
        - (Lambda_i_forearm_15 * r_R_forearm_z - Lambda_i_forearm_16 * r_R_forearm_y);
    const six_link_real t301 = Lambda_i_forearm_12
        - (Lambda_i_forearm_16 * r_R_forearm_x - Lambda_i_forearm_14 * r_R_forearm_z);
    const six_link_real t302 = t301 + (r_R_forearm_y * t296 - r_R_forearm_z * t295);
    const six_link_real t303 = Lambda_i_forearm_13
        - (Lambda_i_forearm_14 * r_R_forearm_y - Lambda_i_forearm_15 * r_R_forearm_x);
    const six_link_real t304 = t303 + (r_R_forearm_y * t299 - r_R_forearm_z * t298);
    const six_link_real t305 = Lambda_i_forearm_22
        - (Lambda_i_forearm_26 * r_R_forearm_x - Lambda_i_forearm_24 * r_R_forearm_z);
    const six_link_real t306 = Lambda_i_forearm_23
        - (Lambda_i_forearm_24 * r_R_forearm_y - Lambda_i_forearm_25 * r_R_forearm_x);
    const six_link_real t307 = t306 + (r_R_forearm_z * t297 - r_R_forearm_x * t299);
    const six_link_real t308 = Lambda_i_forearm_33
        - (Lambda_i_forearm_34 * r_R_forearm_y - Lambda_i_forearm_35 * r_R_forearm_x);
    const six_link_real t309 = t308 + (r_R_forearm_x * t298 - r_R_forearm_y * t297);
    const six_link_real t310 = (t300 + (r_R_forearm_y * t293 - r_R_forearm_z * t292) - t309) * REAL(0.5);
    const six_link_real t311 = t310 * R_P_forearm_11 + t302 * R_P_forearm_12 + t304 * R_P_forearm_13;
    const six_link_real t312 = t310 * R_P_forearm_21 + t302 * R_P_forearm_22 + t304 * R_P_forearm_23;
    const six_link_real t313 = t310 * R_P_forearm_31 + t302 * R_P_forearm_32 + t304 * R_P_forearm_33;
    const six_link_real t314 = (t305 + (r_R_forearm_z * t294 - r_R_forearm_x * t296) - t309) * REAL(0.5);
    const six_link_real t315 = t314 * R_P_forearm_12 + t307 * R_P_forearm_13;
    const six_link_real t316 = t314 * R_P_forearm_22 + t307 * R_P_forearm_23;
    const six_link_real t317 = t314 * R_P_forearm_32 + t307 * R_P_forearm_33;
    const six_link_real Lambda_forearm_1 = (R_P_forearm_11 * t311 + R_P_forearm_12 * t315) * 2 + t309;
    const six_link_real Lambda_forearm_2 = R_P_forearm_11 * t312 + R_P_forearm_12 * t316
        + (R_P_forearm_21 * t311 + R_P_forearm_22 * t315);
    const six_link_real Lambda_forearm_3 = R_P_forearm_11 * t313 + R_P_forearm_12 * t317
        + (R_P_forearm_31 * t311 + R_P_forearm_32 * t315);
    const six_link_real Lambda_forearm_7 = (R_P_forearm_21 * t312 + R_P_forearm_22 * t316) * 2 + t309;
    const six_link_real Lambda_forearm_8 = R_P_forearm_21 * t313 + R_P_forearm_22 * t317
        + (R_P_forearm_31 * t312 + R_P_forearm_32 * t316);
    const six_link_real Lambda_forearm_12 = (R_P_forearm_31 * t313 + R_P_forearm_32 * t317) * 2 + t309;
    const six_link_real t318 = t291 * R_P_forearm_11 + t292 * R_P_forearm_12 + t293 * R_P_forearm_13;
    const six_link_real t319 = t291 * R_P_forearm_21 + t292 * R_P_forearm_22 + t293 * R_P_forearm_23;
    const six_link_real t320 = t291 * R_P_forearm_31 + t292 * R_P_forearm_32 + t293 * R_P_forearm_33;
    const six_link_real t321 = t294 * R_P_forearm_11 + t295 * R_P_forearm_12 + t296 * R_P_forearm_13;
    const six_link_real t322 = t294 * R_P_forearm_21 + t295 * R_P_forearm_22 + t296 * R_P_forearm_23;
    const six_link_real t323 = t294 * R_P_forearm_31 + t295 * R_P_forearm_32 + t296 * R_P_forearm_33;
    const six_link_real t324 = t297 * R_P_forearm_11 + t298 * R_P_forearm_12 + t299 * R_P_forearm_13;
    const six_link_real t325 = t297 * R_P_forearm_21 + t298 * R_P_forearm_22 + t299 * R_P_forearm_23;
    const six_link_real t326 = t297 * R_P_forearm_31 + t298 * R_P_forearm_32 + t299 * R_P_forearm_33;
    const six_link_real Lambda_forearm_4 = R_P_forearm_11 * t318 + R_P_forearm_12 * t321 + R_P_forearm_13 * t324;
    const six_link_real Lambda_forearm_5 = R_P_forearm_11 * t319 + R_P_forearm_12 * t322 + R_P_forearm_13 * t325;
    const six_link_real Lambda_forearm_6 = R_P_forearm_11 * t320 + R_P_forearm_12 * t323 + R_P_forearm_13 * t326;
    const six_link_real Lambda_forearm_9 = R_P_forearm_21 * t318 + R_P_forearm_22 * t321 + R_P_forearm_23 * t324;
    const six_link_real Lambda_forearm_10 = R_P_forearm_21 * t319 + R_P_forearm_22 * t322 + R_P_forearm_23 * t325;
    const six_link_real Lambda_forearm_11 = R_P_forearm_21 * t320 + R_P_forearm_22 * t323 + R_P_forearm_23 * t326;
    const six_link_real Lambda_forearm_13 = R_P_forearm_31 * t318 + R_P_forearm_32 * t321 + R_P_forearm_33 * t324;
    const six_link_real Lambda_forearm_14 = R_P_forearm_31 * t319 + R_P_forearm_32 * t322 + R_P_forearm_33 * t325;
    const six_link_real Lambda_forearm_15 = R_P_forearm_31 * t320 + R_P_forearm_32 * t323 + R_P_forearm_33 * t326;
    const six_link_real t327 = (Lambda_i_forearm_44 - Lambda_i_forearm_66) * REAL(0.5);
    const six_link_real t328 = t327 * R_P_forearm_11 + Lambda_i_forearm_45 * R_P_forearm_12
        + Lambda_i_forearm_46 * R_P_forearm_13;
    const six_link_real t329 = t327 * R_P_forearm_21 + Lambda_i_forearm_45 * R_P_forearm_22
        + Lambda_i_forearm_46 * R_P_forearm_23;
    const six_link_real t330 = t327 * R_P_forearm_31 + Lambda_i_forearm_45 * R_P_forearm_32
        + Lambda_i_forearm_46 * R_P_forearm_33;
    const six_link_real t331 = (Lambda_i_forearm_55 - Lambda_i_forearm_66) * REAL(0.5);
    const six_link_real t332 = t331 * R_P_forearm_12 + Lambda_i_forearm_56 * R_P_forearm_13;
    const six_link_real t333 = t331 * R_P_forearm_22 + Lambda_i_forearm_56 * R_P_forearm_23;
    const six_link_real t334 = t331 * R_P_forearm_32 + Lambda_i_forearm_56 * R_P_forearm_33;
    const six_link_real Lambda_forearm_16 = (R_P_forearm_11 * t328 + R_P_forearm_12 * t332) * 2 + Lambda_i_forearm_66;
    const six_link_real Lambda_forearm_17 = R_P_forearm_11 * t329 + R_P_forearm_12 * t333
        + (R_P_forearm_21 * t328 + R_P_forearm_22 * t332);
    const six_link_real Lambda_forearm_18 = R_P_forearm_11 * t330 + R_P_forearm_12 * t334
        + (R_P_forearm_31 * t328 + R_P_forearm_32 * t332);
    const six_link_real Lambda_forearm_19 = (R_P_forearm_21 * t329 + R_P_forearm_22 * t333) * 2 + Lambda_i_forearm_66;
    const six_link_real Lambda_forearm_20 = R_P_forearm_21 * t330 + R_P_forearm_22 * t334
        + (R_P_forearm_31 * t329 + R_P_forearm_32 * t333);
    const six_link_real Lambda_forearm_21 = (R_P_forearm_31 * t330 + R_P_forearm_32 * t334) * 2 + Lambda_i_forearm_66;
    const six_link_real t335 = p_i_forearm_1 + (r_R_forearm_y * p_i_forearm_6 - r_R_forearm_z * p_i_forearm_5);
    const six_link_real t336 = p_i_forearm_2 + (r_R_forearm_z * p_i_forearm_4 - r_R_forearm_x * p_i_forearm_6);
    const six_link_real t337 = p_i_forearm_3 + (r_R_forearm_x * p_i_forearm_5 - r_R_forearm_y * p_i_forearm_4);
    const six_link_real p_forearm_1 = R_P_forearm_11 * t335 + R_P_forearm_12 * t336 + R_P_forearm_13 * t337;
    const six_link_real p_forearm_2 = R_P_forearm_21 * t335 + R_P_forearm_22 * t336 + R_P_forearm_23 * t337;
    const six_link_real p_forearm_3 = R_P_forearm_31 * t335 + R_P_forearm_32 * t336 + R_P_forearm_33 * t337;
    const six_link_real p_forearm_4 = R_P_forearm_11 * p_i_forearm_4 + R_P_forearm_12 * p_i_forearm_5
        + R_P_forearm_13 * p_i_forearm_6;
    const six_link_real p_forearm_5 = R_P_forearm_21 * p_i_forearm_4 + R_P_forearm_22 * p_i_forearm_5
        + R_P_forearm_23 * p_i_forearm_6;
    const six_link_real p_forearm_6 = R_P_forearm_31 * p_i_forearm_4 + R_P_forearm_32 * p_i_forearm_5
        + R_P_forearm_33 * p_i_forearm_6;

    /* upper_arm, S: first moment */
    const six_link_real S_upper_arm_y = state->q[6] * c->links[1].sigma_y1 + state->q[7] * c->links[1].sigma_y2;
    const six_link_real S_upper_arm_z = state->q[8] * c->links[1].sigma_y1 + state->q[9] * c->links[1].sigma_y2;

    /* upper_arm, Sdot: rate of the first moment */
    const six_link_real Sdot_upper_arm_y = state->v[6] * c->links[1].sigma_y1 + state->v[7] * c->links[1].sigma_y2;
    const six_link_real Sdot_upper_arm_z = state->v[8] * c->links[1].sigma_y1 + state->v[9] * c->links[1].sigma_y2;

    /* upper_arm, L: first moment weighted by each mode shape (85) */
    const six_link_real L_upper_arm_y1 = c->links[1].mu * state->q[6];
    const six_link_real L_upper_arm_y2 = c->links[1].mu * state->q[7];
    const six_link_real L_upper_arm_z1 = state->q[8] * c->links[1].mu;
    const six_link_real L_upper_arm_z2 = state->q[9] * c->links[1].mu;

    /* upper_arm, Ldot: rate of L */
    const six_link_real Ldot_upper_arm_y1 = c->links[1].mu * state->v[6];
    const six_link_real Ldot_upper_arm_y2 = c->links[1].mu * state->v[7];
    const six_link_real Ldot_upper_arm_z1 = state->v[8] * c->links[1].mu;
    const six_link_real Ldot_upper_arm_z2 = state->v[9] * c->links[1].mu;

    /* upper_arm, J: second moment */
    const six_link_real J_upper_arm_xy = c->links[1].chi_1 * state->q[6] + c->links[1].chi_2 * state->q[7];
    const six_link_real J_upper_arm_xz = c->links[1].chi_1 * state->q[8] + c->links[1].chi_2 * state->q[9];
    const six_link_real J_upper_arm_yy = L_upper_arm_y1 * state->q[6] + L_upper_arm_y2 * state->q[7];
    const six_link_real J_upper_arm_yz = L_upper_arm_z1 * state->q[6] + L_upper_arm_z2 * state->q[7];
    const six_link_real J_upper_arm_zz = L_upper_arm_z1 * state->q[8] + L_upper_arm_z2 * state->q[9];

    /* upper_arm, I: inertia about the origin, deformed */
    const six_link_real I_upper_arm_xx = c->links[1].I_s + J_upper_arm_yy + J_upper_arm_zz;
    const six_link_real I_upper_arm_yy = c->links[1].J_0_xx + J_upper_arm_zz;
    const six_link_real I_upper_arm_zz = c->links[1].J_0_xx + J_upper_arm_yy;

    /* upper_arm, Omega: acceleration of a place by the link's turning */
    const six_link_real t338 = state->v[1] * state->v[1];
    const six_link_real t339 = omega_R_upper_arm_3 * omega_R_upper_arm_3;
    const six_link_real minus_Omega_upper_arm_xx = t338 + t339;
    const six_link_real minus_Omega_upper_arm_xz = minus_omega_R_upper_arm_1 * omega_R_upper_arm_3;
    const six_link_real minus_Omega_upper_arm_yx = minus_alpha_upper_arm_z + minus_alpha_upper_arm_z;
    const six_link_real t340 = minus_omega_R_upper_arm_1 * minus_omega_R_upper_arm_1;
    const six_link_real minus_Omega_upper_arm_yy = t340 + t339;
    const six_link_real Omega_upper_arm_yz = minus_alpha_upper_arm_x + minus_alpha_upper_arm_x;
    const six_link_real minus_Omega_upper_arm_zz = t340 + t338;

    /* upper_arm, B: moment of the elastic velocity */
    const six_link_real B_upper_arm_yx = c->links[1].chi_1 * state->v[6] + c->links[1].chi_2 * state->v[7];
    const six_link_real B_upper_arm_yy = L_upper_arm_y1 * state->v[6] + L_upper_arm_y2 * state->v[7];
    const six_link_real B_upper_arm_yz = L_upper_arm_z1 * state->v[6] + L_upper_arm_z2 * state->v[7];
    const six_link_real B_upper_arm_zx = c->links[1].chi_1 * state->v[8] + c->links[1].chi_2 * state->v[9];
    const six_link_real B_upper_arm_zy = L_upper_arm_y1 * state->v[8] + L_upper_arm_y2 * state->v[9];
    const six_link_real B_upper_arm_zz = L_upper_arm_z1 * state->v[8] + L_upper_arm_z2 * state->v[9];

    /* upper_arm, h_c: half of the Coriolis wrench */
    const six_link_real minus_h_c_upper_arm_1 = B_upper_arm_yy * minus_omega_R_upper_arm_1
        + B_upper_arm_zz * minus_omega_R_upper_arm_1;
    const six_link_real h_c_upper_arm_2 = B_upper_arm_zz * state->v[1] + B_upper_arm_yx * minus_omega_R_upper_arm_1
        - B_upper_arm_yz * omega_R_upper_arm_3;
    const six_link_real h_c_upper_arm_3 = B_upper_arm_yy * omega_R_upper_arm_3
        + B_upper_arm_zx * minus_omega_R_upper_arm_1 - B_upper_arm_zy * state->v[1];
    const six_link_real h_c_upper_arm_4 = Sdot_upper_arm_z * state->v[1] - Sdot_upper_arm_y * omega_R_upper_arm_3;
    const six_link_real minus_minus_h_c_upper_arm_5 = Sdot_upper_arm_z * minus_omega_R_upper_arm_1;
    const six_link_real minus_h_c_upper_arm_6 = Sdot_upper_arm_y * minus_omega_R_upper_arm_1;

    /* upper_arm, h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const six_link_real h_MD_upper_arm_2 = h_c_upper_arm_2 + state->v[10] * omega_R_upper_arm_3 * c->links[1].sigma_t_5;
    const six_link_real h_MD_upper_arm_3 = h_c_upper_arm_3 - state->v[10] * state->v[1] * c->links[1].sigma_t_5;

    /* upper_arm, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real t341 = minus_h_c_upper_arm_1 + c->links[1].I_s * minus_alpha_upper_arm_x
        + J_upper_arm_xy * minus_Omega_upper_arm_xz;
    const six_link_real t342 = J_upper_arm_yz * (minus_Omega_upper_arm_yy - minus_Omega_upper_arm_zz) - t341
        - S_upper_arm_y * minus_a_J_upper_arm_z;
    const six_link_real H_star_upper_arm_1 = t342 + J_upper_arm_xz * minus_Omega_upper_arm_yx
        - J_upper_arm_zz * Omega_upper_arm_yz - S_upper_arm_z * a_J_upper_arm_y;
    const six_link_real t343 = h_c_upper_arm_2
        + J_upper_arm_xz * (minus_Omega_upper_arm_zz - minus_Omega_upper_arm_xx)
        - J_upper_arm_zz * minus_Omega_upper_arm_xz;
    const six_link_real t344 = c->links[1].I_s * minus_omega_R_upper_arm_1;
    const six_link_real t345 = t343 + S_upper_arm_z * a_J_upper_arm_x - t344 * omega_R_upper_arm_3
        + c->links[1].J_0_xx * minus_Omega_upper_arm_xz;
    const six_link_real H_star_upper_arm_2 = t345 + c->links[1].S_0_x * minus_a_J_upper_arm_z;
    const six_link_real t346 = h_c_upper_arm_3 - c->links[1].J_0_xx * minus_Omega_upper_arm_yx
        + J_upper_arm_xy * (minus_Omega_upper_arm_xx - minus_Omega_upper_arm_yy);
    const six_link_real t347 = t346 + J_upper_arm_xz * Omega_upper_arm_yz + c->links[1].S_0_x * a_J_upper_arm_y
        + J_upper_arm_yz * minus_Omega_upper_arm_xz;
    const six_link_real H_star_upper_arm_3 = t347 - S_upper_arm_y * a_J_upper_arm_x + t344 * state->v[1];
    const six_link_real t348 = h_c_upper_arm_4 - minus_Omega_upper_arm_xx * c->links[1].S_0_x
        - minus_Omega_upper_arm_xz * S_upper_arm_z;
    const six_link_real H_star_upper_arm_4 = t348 + a_J_upper_arm_x * c->links[1].mu;
    const six_link_real t349 = minus_minus_h_c_upper_arm_5 - minus_Omega_upper_arm_yx * c->links[1].S_0_x
        - minus_Omega_upper_arm_yy * S_upper_arm_y;
    const six_link_real H_star_upper_arm_5 = t349 + Omega_upper_arm_yz * S_upper_arm_z
        + a_J_upper_arm_y * c->links[1].mu;
    const six_link_real t350 = minus_h_c_upper_arm_6 + minus_Omega_upper_arm_xz * c->links[1].S_0_x
        + minus_Omega_upper_arm_zz * S_upper_arm_z;
    const six_link_real minus_H_star_upper_arm_6 = t350 + minus_a_J_upper_arm_z * c->links[1].mu;

    /* upper_arm, h_V: bias of the twist rows, angular acceleration included */
    const six_link_real h_V_upper_arm_1 = H_star_upper_arm_1 - minus_h_c_upper_arm_1;
    const six_link_real h_V_upper_arm_2 = H_star_upper_arm_2 + h_MD_upper_arm_2;
    const six_link_real h_V_upper_arm_3 = H_star_upper_arm_3 + h_MD_upper_arm_3;
    const six_link_real h_V_upper_arm_4 = H_star_upper_arm_4 + h_c_upper_arm_4;
    const six_link_real h_V_upper_arm_5 = H_star_upper_arm_5 + minus_minus_h_c_upper_arm_5;
    const six_link_real minus_h_V_upper_arm_6 = minus_H_star_upper_arm_6 + minus_h_c_upper_arm_6;

    /* upper_arm, h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const six_link_real t351 = L_upper_arm_z1 * Omega_upper_arm_yz - L_upper_arm_y1 * minus_Omega_upper_arm_yy
        - minus_Omega_upper_arm_yx * c->links[1].chi_1;
    const six_link_real h_eta_upper_arm_1 = t351 + a_J_upper_arm_y * c->links[1].sigma_y1
        + Ldot_upper_arm_z1 * 2 * minus_omega_R_upper_arm_1;
    const six_link_real t352 = L_upper_arm_z2 * Omega_upper_arm_yz - L_upper_arm_y2 * minus_Omega_upper_arm_yy
        - minus_Omega_upper_arm_yx * c->links[1].chi_2;
    const six_link_real h_eta_upper_arm_2 = t352 + a_J_upper_arm_y * c->links[1].sigma_y2
        + Ldot_upper_arm_z2 * 2 * minus_omega_R_upper_arm_1;
    const six_link_real t353 = L_upper_arm_z1 * minus_Omega_upper_arm_zz
        + minus_Omega_upper_arm_xz * c->links[1].chi_1 + minus_a_J_upper_arm_z * c->links[1].sigma_y1;
    const six_link_real minus_h_eta_upper_arm_3 = t353 + Ldot_upper_arm_y1 * 2 * minus_omega_R_upper_arm_1;
    const six_link_real t354 = L_upper_arm_z2 * minus_Omega_upper_arm_zz
        + minus_Omega_upper_arm_xz * c->links[1].chi_2 + minus_a_J_upper_arm_z * c->links[1].sigma_y2;
    const six_link_real minus_h_eta_upper_arm_4 = t354 + Ldot_upper_arm_y2 * 2 * minus_omega_R_upper_arm_1;
    const six_link_real minus_h_eta_upper_arm_5 = minus_alpha_upper_arm_x * c->links[1].sigma_t_5;

    /* upper_arm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t355 = R_T_upper_arm_xx * c->links[1].S_T_x + R_T_upper_arm_xy * c->links[1].S_T_y
        + R_T_upper_arm_xz * c->links[1].S_T_z;
    const six_link_real t356 = R_T_upper_arm_yx * c->links[1].S_T_x + R_T_upper_arm_yy * c->links[1].S_T_y
        + R_T_upper_arm_yz * c->links[1].S_T_z;
    const six_link_real t357 = R_T_upper_arm_zx * c->links[1].S_T_x + R_T_upper_arm_zy * c->links[1].S_T_y
        + R_T_upper_arm_zz * c->links[1].S_T_z;
    const six_link_real t358 = c->links[1].I_T_xx * R_T_upper_arm_xx - c->links[1].J_T_xy * R_T_upper_arm_xy
        - c->links[1].J_T_xz * R_T_upper_arm_xz;
    const six_link_real t359 = c->links[1].I_T_xx * R_T_upper_arm_yx - c->links[1].J_T_xy * R_T_upper_arm_yy
        - c->links[1].J_T_xz * R_T_upper_arm_yz;
    const six_link_real t360 = c->links[1].I_T_xx * R_T_upper_arm_zx - c->links[1].J_T_xy * R_T_upper_arm_zy
        - c->links[1].J_T_xz * R_T_upper_arm_zz;
    const six_link_real t361 = c->links[1].I_T_yy * R_T_upper_arm_xy - c->links[1].J_T_xy * R_T_upper_arm_xx
        - c->links[1].J_T_yz * R_T_upper_arm_xz;
    const six_link_real t362 = c->links[1].I_T_yy * R_T_upper_arm_yy - c->links[1].J_T_xy * R_T_upper_arm_yx
        - c->links[1].J_T_yz * R_T_upper_arm_yz;
    const six_link_real t363 = c->links[1].I_T_yy * R_T_upper_arm_zy - c->links[1].J_T_xy * R_T_upper_arm_zx
        - c->links[1].J_T_yz * R_T_upper_arm_zz;
    const six_link_real t364 = c->links[1].I_T_zz * R_T_upper_arm_xz
        - (c->links[1].J_T_xz * R_T_upper_arm_xx + c->links[1].J_T_yz * R_T_upper_arm_xy);
    const six_link_real t365 = c->links[1].I_T_zz * R_T_upper_arm_yz
        - (c->links[1].J_T_xz * R_T_upper_arm_yx + c->links[1].J_T_yz * R_T_upper_arm_yy);
    const six_link_real t366 = c->links[1].I_T_zz * R_T_upper_arm_zz
        - (c->links[1].J_T_xz * R_T_upper_arm_zx + c->links[1].J_T_yz * R_T_upper_arm_zy);
    const six_link_real t367 = R_T_upper_arm_xx * t358 + R_T_upper_arm_xy * t361 + R_T_upper_arm_xz * t364;
    const six_link_real t368 = R_T_upper_arm_xx * t359 + R_T_upper_arm_xy * t362 + R_T_upper_arm_xz * t365;
    const six_link_real t369 = R_T_upper_arm_xx * t360 + R_T_upper_arm_xy * t363 + R_T_upper_arm_xz * t366;
    const six_link_real t370 = R_T_upper_arm_yx * t359 + R_T_upper_arm_yy * t362 + R_T_upper_arm_yz * t365;
    const six_link_real t371 = R_T_upper_arm_yx * t360 + R_T_upper_arm_yy * t363 + R_T_upper_arm_yz * t366;
    const six_link_real t372 = R_T_upper_arm_zx * t360 + R_T_upper_arm_zy * t363 + R_T_upper_arm_zz * t366;
    const six_link_real Lambda_T_upper_arm_11 = Lambda_forearm_1 + t367;
    const six_link_real Lambda_T_upper_arm_12 = Lambda_forearm_2 + t368;
    const six_link_real Lambda_T_upper_arm_13 = Lambda_forearm_3 + t369;
    const six_link_real Lambda_T_upper_arm_15 = Lambda_forearm_5 - t357;
    const six_link_real Lambda_T_upper_arm_16 = Lambda_forearm_6 + t356;
    const six_link_real Lambda_T_upper_arm_22 = Lambda_forearm_7 + t370;
    const six_link_real Lambda_T_upper_arm_23 = Lambda_forearm_8 + t371;
    const six_link_real Lambda_T_upper_arm_24 = Lambda_forearm_9 + t357;
    const six_link_real Lambda_T_upper_arm_26 = Lambda_forearm_11 - t355;
    const six_link_real Lambda_T_upper_arm_33 = Lambda_forearm_12 + t372;
    const six_link_real Lambda_T_upper_arm_34 = Lambda_forearm_13 - t356;
    const six_link_real Lambda_T_upper_arm_35 = Lambda_forearm_14 + t355;
    const six_link_real Lambda_T_upper_arm_44 = Lambda_forearm_16 + c->links[1].body0_mass;
    const six_link_real Lambda_T_upper_arm_55 = Lambda_forearm_19 + c->links[1].body0_mass;
    const six_link_real Lambda_T_upper_arm_66 = Lambda_forearm_21 + c->links[1].body0_mass;
    const six_link_real t373 = R_T_upper_arm_xx * input->w_ext[1][0] + R_T_upper_arm_xy * input->w_ext[1][1]
        + R_T_upper_arm_xz * input->w_ext[1][2];
    const six_link_real t374 = R_T_upper_arm_yx * input->w_ext[1][0] + R_T_upper_arm_yy * input->w_ext[1][1]
        + R_T_upper_arm_yz * input->w_ext[1][2];
    const six_link_real t375 = R_T_upper_arm_zx * input->w_ext[1][0] + R_T_upper_arm_zy * input->w_ext[1][1]
        + R_T_upper_arm_zz * input->w_ext[1][2];
    const six_link_real t376 = R_T_upper_arm_xx * input->w_ext[1][3] + R_T_upper_arm_xy * input->w_ext[1][4]
        + R_T_upper_arm_xz * input->w_ext[1][5];
    const six_link_real t377 = R_T_upper_arm_yx * input->w_ext[1][3] + R_T_upper_arm_yy * input->w_ext[1][4]
        + R_T_upper_arm_yz * input->w_ext[1][5];
    const six_link_real t378 = R_T_upper_arm_zx * input->w_ext[1][3] + R_T_upper_arm_zy * input->w_ext[1][4]
        + R_T_upper_arm_zz * input->w_ext[1][5];
    const six_link_real t379 = t367 * alpha_t_upper_arm_x + t368 * alpha_t_upper_arm_y + t369 * alpha_t_upper_arm_z
        - (t356 * minus_a_t_upper_arm_z + t357 * a_t_upper_arm_y);
    const six_link_real t380 = t357 * a_t_upper_arm_x + t355 * minus_a_t_upper_arm_z
        + (t368 * alpha_t_upper_arm_x + t370 * alpha_t_upper_arm_y + t371 * alpha_t_upper_arm_z);
    const six_link_real t381 = t355 * a_t_upper_arm_y - t356 * a_t_upper_arm_x
        + (t369 * alpha_t_upper_arm_x + t371 * alpha_t_upper_arm_y + t372 * alpha_t_upper_arm_z);
    const six_link_real t382 = t367 * omega_t_upper_arm_x + t368 * omega_t_upper_arm_y + t369 * omega_t_upper_arm_z;
    const six_link_real t383 = t368 * omega_t_upper_arm_x + t370 * omega_t_upper_arm_y + t371 * omega_t_upper_arm_z;
    const six_link_real t384 = t369 * omega_t_upper_arm_x + t371 * omega_t_upper_arm_y + t372 * omega_t_upper_arm_z;
    const six_link_real t385 = omega_t_upper_arm_y * t357 - omega_t_upper_arm_z * t356;
    const six_link_real t386 = omega_t_upper_arm_z * t355 - omega_t_upper_arm_x * t357;
    const six_link_real t387 = omega_t_upper_arm_x * t356 - omega_t_upper_arm_y * t355;
    const six_link_real t388 = alpha_t_upper_arm_y * t357 - alpha_t_upper_arm_z * t356
        + (omega_t_upper_arm_y * t387 - omega_t_upper_arm_z * t386);
    const six_link_real t389 = alpha_t_upper_arm_z * t355 - alpha_t_upper_arm_x * t357
        + (omega_t_upper_arm_z * t385 - omega_t_upper_arm_x * t387);
    const six_link_real t390 = alpha_t_upper_arm_x * t356 - alpha_t_upper_arm_y * t355
        + (omega_t_upper_arm_x * t386 - omega_t_upper_arm_y * t385);
    const six_link_real p_T_upper_arm_1 = p_forearm_1
        + (t379 + (omega_t_upper_arm_y * t384 - omega_t_upper_arm_z * t383)) - t373;
    const six_link_real p_T_upper_arm_2 = p_forearm_2
        + (t380 + (omega_t_upper_arm_z * t382 - omega_t_upper_arm_x * t384)) - t374;
    const six_link_real p_T_upper_arm_3 = p_forearm_3
        + (t381 + (omega_t_upper_arm_x * t383 - omega_t_upper_arm_y * t382)) - t375;
    const six_link_real p_T_upper_arm_4 = p_forearm_4 + (c->links[1].body0_mass * a_t_upper_arm_x + t388) - t376;
    const six_link_real p_T_upper_arm_5 = p_forearm_5 + (c->links[1].body0_mass * a_t_upper_arm_y + t389) - t377;
    const six_link_real p_T_upper_arm_6 = p_forearm_6 + (t390 - c->links[1].body0_mass * minus_a_t_upper_arm_z) - t378;

    /* upper_arm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real Theta_upper_arm_11 = J_l_upper_arm_xz * c->links[1].Psi_c_z1;
    const six_link_real Theta_upper_arm_12 = J_l_upper_arm_xz * c->links[1].Psi_c_z2;
    const six_link_real Theta_upper_arm_13 = J_l_upper_arm_xy * c->links[1].Psi_c_y3;
    const six_link_real Theta_upper_arm_14 = J_l_upper_arm_xy * c->links[1].Psi_c_y4;
    const six_link_real Theta_upper_arm_15 = J_l_upper_arm_xx * REAL(1.7320508075688772);
    const six_link_real Theta_upper_arm_21 = J_l_upper_arm_yz * c->links[1].Psi_c_z1;
    const six_link_real Theta_upper_arm_22 = J_l_upper_arm_yz * c->links[1].Psi_c_z2;
    const six_link_real Theta_upper_arm_23 = J_l_upper_arm_yy * c->links[1].Psi_c_y3;
    const six_link_real Theta_upper_arm_24 = J_l_upper_arm_yy * c->links[1].Psi_c_y4;
    const six_link_real Theta_upper_arm_25 = J_l_upper_arm_yx * REAL(1.7320508075688772);
    const six_link_real Theta_upper_arm_31 = J_l_upper_arm_zz * c->links[1].Psi_c_z1;
    const six_link_real Theta_upper_arm_32 = J_l_upper_arm_zz * c->links[1].Psi_c_z2;
    const six_link_real Theta_upper_arm_33 = J_l_upper_arm_zy * c->links[1].Psi_c_y3;
    const six_link_real Theta_upper_arm_34 = J_l_upper_arm_zy * c->links[1].Psi_c_y4;
    const six_link_real Theta_upper_arm_35 = J_l_upper_arm_zx * REAL(1.7320508075688772);
    const six_link_real t391 = r_T_upper_arm_z * Lambda_forearm_17;
    const six_link_real t392 = r_T_upper_arm_y * Lambda_forearm_18;
    const six_link_real t393 = c->links[1].length * Lambda_forearm_20;
    const six_link_real M_loaded_upper_arm_14 = Lambda_forearm_4 + (t392 - t391);
    const six_link_real t394 = Lambda_T_upper_arm_15
        + (r_T_upper_arm_y * Lambda_forearm_20 - r_T_upper_arm_z * Lambda_T_upper_arm_55);
    const six_link_real t395 = Lambda_T_upper_arm_16
        + (r_T_upper_arm_y * Lambda_T_upper_arm_66 - r_T_upper_arm_z * Lambda_forearm_20);
    const six_link_real t396 = Lambda_T_upper_arm_24
        + (r_T_upper_arm_z * Lambda_T_upper_arm_44 - c->links[1].length * Lambda_forearm_18);
    const six_link_real M_loaded_upper_arm_25 = Lambda_forearm_10 + (t391 - t393);
    const six_link_real t397 = Lambda_T_upper_arm_26
        + (r_T_upper_arm_z * Lambda_forearm_18 - c->links[1].length * Lambda_T_upper_arm_66);
    const six_link_real t398 = Lambda_T_upper_arm_34
        + (c->links[1].length * Lambda_forearm_17 - r_T_upper_arm_y * Lambda_T_upper_arm_44);
    const six_link_real t399 = Lambda_T_upper_arm_35
        + (c->links[1].length * Lambda_T_upper_arm_55 - r_T_upper_arm_y * Lambda_forearm_17);
    const six_link_real M_loaded_upper_arm_36 = Lambda_forearm_15 + (t393 - t392);
    const six_link_real t400 = Lambda_T_upper_arm_11
        - (Lambda_T_upper_arm_15 * r_T_upper_arm_z - Lambda_T_upper_arm_16 * r_T_upper_arm_y);
    const six_link_real t401 = Lambda_T_upper_arm_12
        - (Lambda_T_upper_arm_16 * c->links[1].length - Lambda_forearm_4 * r_T_upper_arm_z);
    const six_link_real t402 = Lambda_T_upper_arm_13
        - (Lambda_forearm_4 * r_T_upper_arm_y - Lambda_T_upper_arm_15 * c->links[1].length);
    const six_link_real t403 = Lambda_T_upper_arm_22
        - (Lambda_T_upper_arm_26 * c->links[1].length - Lambda_T_upper_arm_24 * r_T_upper_arm_z);
    const six_link_real t404 = Lambda_T_upper_arm_23
        - (Lambda_T_upper_arm_24 * r_T_upper_arm_y - Lambda_forearm_10 * c->links[1].length);
    const six_link_real t405 = Lambda_T_upper_arm_33
        - (Lambda_T_upper_arm_34 * r_T_upper_arm_y - Lambda_T_upper_arm_35 * c->links[1].length);
    const six_link_real M_loaded_upper_arm_11 = I_upper_arm_xx
        + (t400 + (r_T_upper_arm_y * t395 - r_T_upper_arm_z * t394));
    const six_link_real M_loaded_upper_arm_12 = t401
        + (r_T_upper_arm_y * t397 - r_T_upper_arm_z * M_loaded_upper_arm_25) - J_upper_arm_xy;
    const six_link_real M_loaded_upper_arm_13 = t402
        + (r_T_upper_arm_y * M_loaded_upper_arm_36 - r_T_upper_arm_z * t399) - J_upper_arm_xz;
    const six_link_real M_loaded_upper_arm_15 = t394 - S_upper_arm_z;
    const six_link_real M_loaded_upper_arm_16 = S_upper_arm_y + t395;
    const six_link_real M_loaded_upper_arm_22 = I_upper_arm_yy
        + (t403 + (r_T_upper_arm_z * t396 - c->links[1].length * t397));
    const six_link_real M_loaded_upper_arm_23 = t404
        + (r_T_upper_arm_z * t398 - c->links[1].length * M_loaded_upper_arm_36) - J_upper_arm_yz;
    const six_link_real M_loaded_upper_arm_24 = S_upper_arm_z + t396;
    const six_link_real M_loaded_upper_arm_26 = t397 - c->links[1].S_0_x;
    const six_link_real M_loaded_upper_arm_33 = I_upper_arm_zz
        + (t405 + (c->links[1].length * t399 - r_T_upper_arm_y * t398));
    const six_link_real M_loaded_upper_arm_34 = t398 - S_upper_arm_y;
    const six_link_real M_loaded_upper_arm_35 = c->links[1].S_0_x + t399;
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
    const six_link_real t406 = Lambda_T_upper_arm_11 * Theta_upper_arm_11 + Lambda_T_upper_arm_12 * Theta_upper_arm_21
        + Lambda_T_upper_arm_13 * Theta_upper_arm_31;
    const six_link_real t407 = t406 + Lambda_T_upper_arm_15 * REAL(2.0195202782688155);
    const six_link_real t408 = Lambda_T_upper_arm_11 * Theta_upper_arm_12 + Lambda_T_upper_arm_12 * Theta_upper_arm_22
        + Lambda_T_upper_arm_13 * Theta_upper_arm_32;
    const six_link_real t409 = t408 + Lambda_T_upper_arm_15 * REAL(2.8145226674626453);
    const six_link_real t410 = Lambda_T_upper_arm_11 * Theta_upper_arm_13 + Lambda_T_upper_arm_12 * Theta_upper_arm_23
        + Lambda_T_upper_arm_13 * Theta_upper_arm_33;
    const six_link_real t411 = t410 + Lambda_T_upper_arm_16 * REAL(2.0195202782688155);
    const six_link_real t412 = Lambda_T_upper_arm_11 * Theta_upper_arm_14 + Lambda_T_upper_arm_12 * Theta_upper_arm_24
        + Lambda_T_upper_arm_13 * Theta_upper_arm_34;
    const six_link_real t413 = t412 + Lambda_T_upper_arm_16 * REAL(2.8145226674626453);
    const six_link_real t414 = Lambda_T_upper_arm_11 * Theta_upper_arm_15 + Lambda_T_upper_arm_12 * Theta_upper_arm_25
        + Lambda_T_upper_arm_13 * Theta_upper_arm_35;
    const six_link_real t415 = Lambda_T_upper_arm_12 * Theta_upper_arm_11 + Lambda_T_upper_arm_22 * Theta_upper_arm_21
        + Lambda_T_upper_arm_23 * Theta_upper_arm_31;
    const six_link_real t416 = t415 + Lambda_forearm_10 * REAL(2.0195202782688155);
    const six_link_real t417 = Lambda_T_upper_arm_12 * Theta_upper_arm_12 + Lambda_T_upper_arm_22 * Theta_upper_arm_22
        + Lambda_T_upper_arm_23 * Theta_upper_arm_32;
    const six_link_real t418 = t417 + Lambda_forearm_10 * REAL(2.8145226674626453);
    const six_link_real t419 = Lambda_T_upper_arm_12 * Theta_upper_arm_13 + Lambda_T_upper_arm_22 * Theta_upper_arm_23
        + Lambda_T_upper_arm_23 * Theta_upper_arm_33;
    const six_link_real t420 = t419 + Lambda_T_upper_arm_26 * REAL(2.0195202782688155);
    const six_link_real t421 = Lambda_T_upper_arm_12 * Theta_upper_arm_14 + Lambda_T_upper_arm_22 * Theta_upper_arm_24
        + Lambda_T_upper_arm_23 * Theta_upper_arm_34;
    const six_link_real t422 = t421 + Lambda_T_upper_arm_26 * REAL(2.8145226674626453);
    const six_link_real t423 = Lambda_T_upper_arm_12 * Theta_upper_arm_15 + Lambda_T_upper_arm_22 * Theta_upper_arm_25
        + Lambda_T_upper_arm_23 * Theta_upper_arm_35;
    const six_link_real t424 = Lambda_T_upper_arm_13 * Theta_upper_arm_11 + Lambda_T_upper_arm_23 * Theta_upper_arm_21
        + Lambda_T_upper_arm_33 * Theta_upper_arm_31;
    const six_link_real t425 = t424 + Lambda_T_upper_arm_35 * REAL(2.0195202782688155);
    const six_link_real t426 = Lambda_T_upper_arm_13 * Theta_upper_arm_12 + Lambda_T_upper_arm_23 * Theta_upper_arm_22
        + Lambda_T_upper_arm_33 * Theta_upper_arm_32;
    const six_link_real t427 = t426 + Lambda_T_upper_arm_35 * REAL(2.8145226674626453);
    const six_link_real t428 = Lambda_T_upper_arm_13 * Theta_upper_arm_13 + Lambda_T_upper_arm_23 * Theta_upper_arm_23
        + Lambda_T_upper_arm_33 * Theta_upper_arm_33;
    const six_link_real t429 = t428 + Lambda_forearm_15 * REAL(2.0195202782688155);
    const six_link_real t430 = Lambda_T_upper_arm_13 * Theta_upper_arm_14 + Lambda_T_upper_arm_23 * Theta_upper_arm_24
        + Lambda_T_upper_arm_33 * Theta_upper_arm_34;
    const six_link_real t431 = t430 + Lambda_forearm_15 * REAL(2.8145226674626453);
    const six_link_real t432 = Lambda_T_upper_arm_13 * Theta_upper_arm_15 + Lambda_T_upper_arm_23 * Theta_upper_arm_25
        + Lambda_T_upper_arm_33 * Theta_upper_arm_35;
    const six_link_real t433 = Lambda_forearm_4 * Theta_upper_arm_11 + Lambda_T_upper_arm_24 * Theta_upper_arm_21
        + Lambda_T_upper_arm_34 * Theta_upper_arm_31;
    const six_link_real C_upper_arm_41 = t433 + Lambda_forearm_17 * REAL(2.0195202782688155);
    const six_link_real t434 = Lambda_forearm_4 * Theta_upper_arm_12 + Lambda_T_upper_arm_24 * Theta_upper_arm_22
        + Lambda_T_upper_arm_34 * Theta_upper_arm_32;
    const six_link_real C_upper_arm_42 = t434 + Lambda_forearm_17 * REAL(2.8145226674626453);
    const six_link_real t435 = Lambda_forearm_4 * Theta_upper_arm_13 + Lambda_T_upper_arm_24 * Theta_upper_arm_23
        + Lambda_T_upper_arm_34 * Theta_upper_arm_33;
    const six_link_real C_upper_arm_43 = t435 + Lambda_forearm_18 * REAL(2.0195202782688155);
    const six_link_real t436 = Lambda_forearm_4 * Theta_upper_arm_14 + Lambda_T_upper_arm_24 * Theta_upper_arm_24
        + Lambda_T_upper_arm_34 * Theta_upper_arm_34;
    const six_link_real C_upper_arm_44 = t436 + Lambda_forearm_18 * REAL(2.8145226674626453);
    const six_link_real C_upper_arm_45 = Lambda_forearm_4 * Theta_upper_arm_15
        + Lambda_T_upper_arm_24 * Theta_upper_arm_25 + Lambda_T_upper_arm_34 * Theta_upper_arm_35;
    const six_link_real t437 = Lambda_T_upper_arm_15 * Theta_upper_arm_11 + Lambda_forearm_10 * Theta_upper_arm_21
        + Lambda_T_upper_arm_35 * Theta_upper_arm_31;
    const six_link_real t438 = t437 + Lambda_T_upper_arm_55 * REAL(2.0195202782688155);
    const six_link_real t439 = Lambda_T_upper_arm_15 * Theta_upper_arm_12 + Lambda_forearm_10 * Theta_upper_arm_22
        + Lambda_T_upper_arm_35 * Theta_upper_arm_32;
    const six_link_real t440 = t439 + Lambda_T_upper_arm_55 * REAL(2.8145226674626453);
    const six_link_real t441 = Lambda_T_upper_arm_15 * Theta_upper_arm_13 + Lambda_forearm_10 * Theta_upper_arm_23
        + Lambda_T_upper_arm_35 * Theta_upper_arm_33;
    const six_link_real t442 = Lambda_forearm_20 * REAL(2.0195202782688155);
    const six_link_real C_upper_arm_53 = t441 + t442;
    const six_link_real t443 = Lambda_T_upper_arm_15 * Theta_upper_arm_14 + Lambda_forearm_10 * Theta_upper_arm_24
        + Lambda_T_upper_arm_35 * Theta_upper_arm_34;
    const six_link_real t444 = Lambda_forearm_20 * REAL(2.8145226674626453);
    const six_link_real C_upper_arm_54 = t443 + t444;
    const six_link_real C_upper_arm_55 = Lambda_T_upper_arm_15 * Theta_upper_arm_15
        + Lambda_forearm_10 * Theta_upper_arm_25 + Lambda_T_upper_arm_35 * Theta_upper_arm_35;
    const six_link_real t445 = Lambda_T_upper_arm_16 * Theta_upper_arm_11 + Lambda_T_upper_arm_26 * Theta_upper_arm_21
        + Lambda_forearm_15 * Theta_upper_arm_31;
    const six_link_real C_upper_arm_61 = t445 + t442;
    const six_link_real t446 = Lambda_T_upper_arm_16 * Theta_upper_arm_12 + Lambda_T_upper_arm_26 * Theta_upper_arm_22
        + Lambda_forearm_15 * Theta_upper_arm_32;
    const six_link_real C_upper_arm_62 = t446 + t444;
    const six_link_real t447 = Lambda_T_upper_arm_16 * Theta_upper_arm_13 + Lambda_T_upper_arm_26 * Theta_upper_arm_23
        + Lambda_forearm_15 * Theta_upper_arm_33;
    const six_link_real t448 = t447 + Lambda_T_upper_arm_66 * REAL(2.0195202782688155);
    const six_link_real t449 = Lambda_T_upper_arm_16 * Theta_upper_arm_14 + Lambda_T_upper_arm_26 * Theta_upper_arm_24
        + Lambda_forearm_15 * Theta_upper_arm_34;
    const six_link_real t450 = t449 + Lambda_T_upper_arm_66 * REAL(2.8145226674626453);
    const six_link_real C_upper_arm_65 = Lambda_T_upper_arm_16 * Theta_upper_arm_15
        + Lambda_T_upper_arm_26 * Theta_upper_arm_25 + Lambda_forearm_15 * Theta_upper_arm_35;
    const six_link_real C_upper_arm_21 = t416
        + (r_T_upper_arm_z * C_upper_arm_41 - c->links[1].length * C_upper_arm_61);
    const six_link_real C_upper_arm_22 = t418
        + (r_T_upper_arm_z * C_upper_arm_42 - c->links[1].length * C_upper_arm_62);
    const six_link_real C_upper_arm_33 = t429
        + (c->links[1].length * C_upper_arm_53 - r_T_upper_arm_y * C_upper_arm_43);
    const six_link_real C_upper_arm_34 = t431
        + (c->links[1].length * C_upper_arm_54 - r_T_upper_arm_y * C_upper_arm_44);
    const six_link_real C_upper_arm_25 = t423
        + (r_T_upper_arm_z * C_upper_arm_45 - c->links[1].length * C_upper_arm_65);
    const six_link_real C_upper_arm_35 = t432
        + (c->links[1].length * C_upper_arm_55 - r_T_upper_arm_y * C_upper_arm_45);
    const six_link_real C_upper_arm_11 = t407 + (r_T_upper_arm_y * C_upper_arm_61 - r_T_upper_arm_z * t438)
        - L_upper_arm_z1;
    const six_link_real C_upper_arm_12 = t409 + (r_T_upper_arm_y * C_upper_arm_62 - r_T_upper_arm_z * t440)
        - L_upper_arm_z2;
    const six_link_real C_upper_arm_13 = L_upper_arm_y1
        + (t411 + (r_T_upper_arm_y * t448 - r_T_upper_arm_z * C_upper_arm_53));
    const six_link_real C_upper_arm_14 = L_upper_arm_y2
        + (t413 + (r_T_upper_arm_y * t450 - r_T_upper_arm_z * C_upper_arm_54));
    const six_link_real C_upper_arm_15 = c->links[1].sigma_t_5
        + (t414 + (r_T_upper_arm_y * C_upper_arm_65 - r_T_upper_arm_z * C_upper_arm_55));
    const six_link_real C_upper_arm_23 = t420 + (r_T_upper_arm_z * C_upper_arm_43 - c->links[1].length * t448)
        - c->links[1].chi_1;
    const six_link_real C_upper_arm_24 = t422 + (r_T_upper_arm_z * C_upper_arm_44 - c->links[1].length * t450)
        - c->links[1].chi_2;
    const six_link_real C_upper_arm_31 = c->links[1].chi_1
        + (t425 + (c->links[1].length * t438 - r_T_upper_arm_y * C_upper_arm_41));
    const six_link_real C_upper_arm_32 = c->links[1].chi_2
        + (t427 + (c->links[1].length * t440 - r_T_upper_arm_y * C_upper_arm_42));
    const six_link_real C_upper_arm_51 = c->links[1].sigma_y1 + t438;
    const six_link_real C_upper_arm_52 = c->links[1].sigma_y2 + t440;
    const six_link_real C_upper_arm_63 = c->links[1].sigma_y1 + t448;
    const six_link_real C_upper_arm_64 = c->links[1].sigma_y2 + t450;
    const six_link_real t451 = Theta_upper_arm_11 * t407 + Theta_upper_arm_21 * t416 + Theta_upper_arm_31 * t425
        + t438 * REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_11 = t451 + m_eta[6];
    bad |= (unsigned long)(!(modal_inertia_upper_arm_11 > 0)) << 1;
    const six_link_real modal_inertia_upper_arm_12 = Theta_upper_arm_11 * t409 + Theta_upper_arm_21 * t418
        + Theta_upper_arm_31 * t427 + t440 * REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_13 = Theta_upper_arm_11 * t411 + Theta_upper_arm_21 * t420
        + Theta_upper_arm_31 * t429 + C_upper_arm_53 * REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_14 = Theta_upper_arm_11 * t413 + Theta_upper_arm_21 * t422
        + Theta_upper_arm_31 * t431 + C_upper_arm_54 * REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_15 = Theta_upper_arm_11 * t414 + Theta_upper_arm_21 * t423
        + Theta_upper_arm_31 * t432 + C_upper_arm_55 * REAL(2.0195202782688155);
    const six_link_real t452 = Theta_upper_arm_12 * t409 + Theta_upper_arm_22 * t418 + Theta_upper_arm_32 * t427
        + t440 * REAL(2.8145226674626453);
    const six_link_real modal_inertia_upper_arm_22 = t452 + m_eta[7];
    const six_link_real modal_inertia_upper_arm_23 = Theta_upper_arm_12 * t411 + Theta_upper_arm_22 * t420
        + Theta_upper_arm_32 * t429 + C_upper_arm_53 * REAL(2.8145226674626453);
    const six_link_real modal_inertia_upper_arm_24 = Theta_upper_arm_12 * t413 + Theta_upper_arm_22 * t422
        + Theta_upper_arm_32 * t431 + C_upper_arm_54 * REAL(2.8145226674626453);
    const six_link_real modal_inertia_upper_arm_25 = Theta_upper_arm_12 * t414 + Theta_upper_arm_22 * t423
        + Theta_upper_arm_32 * t432 + C_upper_arm_55 * REAL(2.8145226674626453);
    const six_link_real t453 = Theta_upper_arm_13 * t411 + Theta_upper_arm_23 * t420 + Theta_upper_arm_33 * t429
        + t448 * REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_33 = t453 + m_eta[8];
    const six_link_real modal_inertia_upper_arm_34 = Theta_upper_arm_13 * t413 + Theta_upper_arm_23 * t422
        + Theta_upper_arm_33 * t431 + t450 * REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_35 = Theta_upper_arm_13 * t414 + Theta_upper_arm_23 * t423
        + Theta_upper_arm_33 * t432 + C_upper_arm_65 * REAL(2.0195202782688155);
    const six_link_real t454 = Theta_upper_arm_14 * t413 + Theta_upper_arm_24 * t422 + Theta_upper_arm_34 * t431
        + t450 * REAL(2.8145226674626453);
    const six_link_real modal_inertia_upper_arm_44 = t454 + m_eta[9];
    const six_link_real modal_inertia_upper_arm_45 = Theta_upper_arm_14 * t414 + Theta_upper_arm_24 * t423
        + Theta_upper_arm_34 * t432 + C_upper_arm_65 * REAL(2.8145226674626453);
    const six_link_real modal_inertia_upper_arm_55 = Theta_upper_arm_15 * t414 + Theta_upper_arm_25 * t423
        + Theta_upper_arm_35 * t432 + m_eta[10];
    const six_link_real t455 = Theta_upper_arm_11 * p_T_upper_arm_1 + Theta_upper_arm_21 * p_T_upper_arm_2
        + Theta_upper_arm_31 * p_T_upper_arm_3;
    const six_link_real t456 = Theta_upper_arm_12 * p_T_upper_arm_1 + Theta_upper_arm_22 * p_T_upper_arm_2
        + Theta_upper_arm_32 * p_T_upper_arm_3;
    const six_link_real t457 = Theta_upper_arm_13 * p_T_upper_arm_1 + Theta_upper_arm_23 * p_T_upper_arm_2
        + Theta_upper_arm_33 * p_T_upper_arm_3;
    const six_link_real t458 = Theta_upper_arm_14 * p_T_upper_arm_1 + Theta_upper_arm_24 * p_T_upper_arm_2
        + Theta_upper_arm_34 * p_T_upper_arm_3;
    const six_link_real t459 = Theta_upper_arm_15 * p_T_upper_arm_1 + Theta_upper_arm_25 * p_T_upper_arm_2
        + Theta_upper_arm_35 * p_T_upper_arm_3;
    const six_link_real h_phi_upper_arm_1 = h_eta_upper_arm_1 + work->f_eta[6]
        + (t455 + p_T_upper_arm_5 * REAL(2.0195202782688155));
    const six_link_real h_phi_upper_arm_2 = h_eta_upper_arm_2 + work->f_eta[7]
        + (t456 + p_T_upper_arm_5 * REAL(2.8145226674626453));
    const six_link_real h_phi_upper_arm_3 = work->f_eta[8] - minus_h_eta_upper_arm_3
        + (t457 + p_T_upper_arm_6 * REAL(2.0195202782688155));
    const six_link_real h_phi_upper_arm_4 = work->f_eta[9] - minus_h_eta_upper_arm_4
        + (t458 + p_T_upper_arm_6 * REAL(2.8145226674626453));
    const six_link_real h_phi_upper_arm_5 = work->f_eta[10] - minus_h_eta_upper_arm_5 + t459;
    const six_link_real modes_inverse_upper_arm_1 = 1 / modal_inertia_upper_arm_11;
    const six_link_real modes_L_upper_arm_21 = modal_inertia_upper_arm_12 * modes_inverse_upper_arm_1;
    const six_link_real modes_L_upper_arm_31 = modal_inertia_upper_arm_13 * modes_inverse_upper_arm_1;
    const six_link_real modes_L_upper_arm_41 = modal_inertia_upper_arm_14 * modes_inverse_upper_arm_1;
    const six_link_real modes_L_upper_arm_51 = modal_inertia_upper_arm_15 * modes_inverse_upper_arm_1;
    const six_link_real t460 = modal_inertia_upper_arm_22 - modal_inertia_upper_arm_12 * modes_L_upper_arm_21;
    bad |= (unsigned long)(!(t460 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_2 = 1 / t460;
    const six_link_real t461 = modal_inertia_upper_arm_23 - modal_inertia_upper_arm_12 * modes_L_upper_arm_31;
    const six_link_real modes_L_upper_arm_32 = t461 * modes_inverse_upper_arm_2;
    const six_link_real t462 = modal_inertia_upper_arm_24 - modal_inertia_upper_arm_12 * modes_L_upper_arm_41;
    const six_link_real modes_L_upper_arm_42 = t462 * modes_inverse_upper_arm_2;
    const six_link_real t463 = modal_inertia_upper_arm_25 - modal_inertia_upper_arm_12 * modes_L_upper_arm_51;
    const six_link_real modes_L_upper_arm_52 = t463 * modes_inverse_upper_arm_2;
    const six_link_real t464 = modal_inertia_upper_arm_33
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_31 + t461 * modes_L_upper_arm_32);
    bad |= (unsigned long)(!(t464 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_3 = 1 / t464;
    const six_link_real t465 = modal_inertia_upper_arm_34
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_41 + t461 * modes_L_upper_arm_42);
    const six_link_real modes_L_upper_arm_43 = t465 * modes_inverse_upper_arm_3;
    const six_link_real t466 = modal_inertia_upper_arm_35
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_51 + t461 * modes_L_upper_arm_52);
    const six_link_real modes_L_upper_arm_53 = t466 * modes_inverse_upper_arm_3;
    const six_link_real t467 = modal_inertia_upper_arm_14 * modes_L_upper_arm_41 + t462 * modes_L_upper_arm_42
        + t465 * modes_L_upper_arm_43;
    const six_link_real t468 = modal_inertia_upper_arm_44 - t467;
    bad |= (unsigned long)(!(t468 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_4 = 1 / t468;
    const six_link_real t469 = modal_inertia_upper_arm_14 * modes_L_upper_arm_51 + t462 * modes_L_upper_arm_52
        + t465 * modes_L_upper_arm_53;
    const six_link_real t470 = modal_inertia_upper_arm_45 - t469;
    const six_link_real modes_L_upper_arm_54 = t470 * modes_inverse_upper_arm_4;
    const six_link_real t471 = modal_inertia_upper_arm_15 * modes_L_upper_arm_51 + t463 * modes_L_upper_arm_52
        + t466 * modes_L_upper_arm_53;
    const six_link_real t472 = modal_inertia_upper_arm_55 - (t471 + t470 * modes_L_upper_arm_54);
    bad |= (unsigned long)(!(t472 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_5 = 1 / t472;
    const six_link_real t473 = C_upper_arm_12 - modes_L_upper_arm_21 * C_upper_arm_11;
    const six_link_real t474 = C_upper_arm_22 - modes_L_upper_arm_21 * C_upper_arm_21;
    const six_link_real t475 = C_upper_arm_32 - modes_L_upper_arm_21 * C_upper_arm_31;
    const six_link_real t476 = C_upper_arm_42 - modes_L_upper_arm_21 * C_upper_arm_41;
    const six_link_real t477 = C_upper_arm_52 - modes_L_upper_arm_21 * C_upper_arm_51;
    const six_link_real t478 = C_upper_arm_62 - modes_L_upper_arm_21 * C_upper_arm_61;
    const six_link_real t479 = C_upper_arm_13 - modes_L_upper_arm_31 * C_upper_arm_11 - modes_L_upper_arm_32 * t473;
    const six_link_real t480 = C_upper_arm_23 - modes_L_upper_arm_31 * C_upper_arm_21 - modes_L_upper_arm_32 * t474;
    const six_link_real t481 = C_upper_arm_33 - modes_L_upper_arm_31 * C_upper_arm_31 - modes_L_upper_arm_32 * t475;
    const six_link_real t482 = C_upper_arm_43 - modes_L_upper_arm_31 * C_upper_arm_41 - modes_L_upper_arm_32 * t476;
    const six_link_real t483 = C_upper_arm_53 - modes_L_upper_arm_31 * C_upper_arm_51 - modes_L_upper_arm_32 * t477;
    const six_link_real t484 = C_upper_arm_63 - modes_L_upper_arm_31 * C_upper_arm_61 - modes_L_upper_arm_32 * t478;
    const six_link_real t485 = C_upper_arm_14 - modes_L_upper_arm_41 * C_upper_arm_11 - modes_L_upper_arm_42 * t473
        - modes_L_upper_arm_43 * t479;
    const six_link_real t486 = C_upper_arm_24 - modes_L_upper_arm_41 * C_upper_arm_21 - modes_L_upper_arm_42 * t474
        - modes_L_upper_arm_43 * t480;
    const six_link_real t487 = C_upper_arm_34 - modes_L_upper_arm_41 * C_upper_arm_31 - modes_L_upper_arm_42 * t475
        - modes_L_upper_arm_43 * t481;
    const six_link_real t488 = C_upper_arm_44 - modes_L_upper_arm_41 * C_upper_arm_41 - modes_L_upper_arm_42 * t476
        - modes_L_upper_arm_43 * t482;
    const six_link_real t489 = C_upper_arm_54 - modes_L_upper_arm_41 * C_upper_arm_51 - modes_L_upper_arm_42 * t477
        - modes_L_upper_arm_43 * t483;
    const six_link_real t490 = C_upper_arm_64 - modes_L_upper_arm_41 * C_upper_arm_61 - modes_L_upper_arm_42 * t478
        - modes_L_upper_arm_43 * t484;
    const six_link_real t491 = C_upper_arm_15 - modes_L_upper_arm_51 * C_upper_arm_11 - modes_L_upper_arm_52 * t473
        - modes_L_upper_arm_53 * t479;
    const six_link_real t492 = C_upper_arm_25 - modes_L_upper_arm_51 * C_upper_arm_21 - modes_L_upper_arm_52 * t474
        - modes_L_upper_arm_53 * t480;
    const six_link_real t493 = C_upper_arm_35 - modes_L_upper_arm_51 * C_upper_arm_31 - modes_L_upper_arm_52 * t475
        - modes_L_upper_arm_53 * t481;
    const six_link_real t494 = C_upper_arm_45 - modes_L_upper_arm_51 * C_upper_arm_41 - modes_L_upper_arm_52 * t476
        - modes_L_upper_arm_53 * t482;
    const six_link_real t495 = C_upper_arm_55 - modes_L_upper_arm_51 * C_upper_arm_51 - modes_L_upper_arm_52 * t477
        - modes_L_upper_arm_53 * t483;
    const six_link_real t496 = C_upper_arm_65 - modes_L_upper_arm_51 * C_upper_arm_61 - modes_L_upper_arm_52 * t478
        - modes_L_upper_arm_53 * t484;
    const six_link_real t497 = t491 - modes_L_upper_arm_54 * t485;
    const six_link_real t498 = t492 - modes_L_upper_arm_54 * t486;
    const six_link_real t499 = t493 - modes_L_upper_arm_54 * t487;
    const six_link_real t500 = t494 - modes_L_upper_arm_54 * t488;
    const six_link_real t501 = t495 - modes_L_upper_arm_54 * t489;
    const six_link_real t502 = t496 - modes_L_upper_arm_54 * t490;
    const six_link_real t503 = h_phi_upper_arm_2 - modes_L_upper_arm_21 * h_phi_upper_arm_1;
    const six_link_real t504 = h_phi_upper_arm_3 - modes_L_upper_arm_31 * h_phi_upper_arm_1
        - modes_L_upper_arm_32 * t503;
    const six_link_real t505 = h_phi_upper_arm_4 - modes_L_upper_arm_41 * h_phi_upper_arm_1
        - modes_L_upper_arm_42 * t503 - modes_L_upper_arm_43 * t504;
    const six_link_real t506 = h_phi_upper_arm_5 - modes_L_upper_arm_51 * h_phi_upper_arm_1
        - modes_L_upper_arm_52 * t503 - modes_L_upper_arm_53 * t504;
    const six_link_real t507 = t506 - modes_L_upper_arm_54 * t505;
    const six_link_real modes_W_upper_arm_11 = C_upper_arm_11 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_12 = C_upper_arm_21 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_13 = C_upper_arm_31 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_14 = C_upper_arm_41 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_15 = C_upper_arm_51 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_16 = C_upper_arm_61 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_21 = t473 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_22 = t474 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_23 = t475 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_24 = t476 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_25 = t477 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_26 = t478 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_31 = t479 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_32 = t480 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_33 = t481 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_34 = t482 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_35 = t483 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_36 = t484 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_41 = t485 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_42 = t486 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_43 = t487 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_44 = t488 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_45 = t489 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_46 = t490 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_51 = t497 * modes_inverse_upper_arm_5;
    const six_link_real modes_W_upper_arm_52 = t498 * modes_inverse_upper_arm_5;
    const six_link_real modes_W_upper_arm_53 = t499 * modes_inverse_upper_arm_5;
    const six_link_real modes_W_upper_arm_54 = t500 * modes_inverse_upper_arm_5;
    const six_link_real modes_W_upper_arm_55 = t501 * modes_inverse_upper_arm_5;
    const six_link_real modes_W_upper_arm_56 = t502 * modes_inverse_upper_arm_5;
    const six_link_real modes_w_upper_arm_1 = h_phi_upper_arm_1 * modes_inverse_upper_arm_1;
    const six_link_real modes_w_upper_arm_2 = t503 * modes_inverse_upper_arm_2;
    const six_link_real modes_w_upper_arm_3 = t504 * modes_inverse_upper_arm_3;
    const six_link_real modes_w_upper_arm_4 = t505 * modes_inverse_upper_arm_4;
    const six_link_real modes_w_upper_arm_5 = t507 * modes_inverse_upper_arm_5;
    const six_link_real t508 = C_upper_arm_11 * modes_W_upper_arm_11 + t473 * modes_W_upper_arm_21
        + t479 * modes_W_upper_arm_31;
    const six_link_real M_i_upper_arm_11 = M_loaded_upper_arm_11
        - (t508 + t485 * modes_W_upper_arm_41 + t497 * modes_W_upper_arm_51);
    const six_link_real t509 = C_upper_arm_11 * modes_W_upper_arm_12 + t473 * modes_W_upper_arm_22
        + t479 * modes_W_upper_arm_32;
    const six_link_real M_i_upper_arm_12 = M_loaded_upper_arm_12
        - (t509 + t485 * modes_W_upper_arm_42 + t497 * modes_W_upper_arm_52);
    const six_link_real t510 = C_upper_arm_11 * modes_W_upper_arm_13 + t473 * modes_W_upper_arm_23
        + t479 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_13 = M_loaded_upper_arm_13
        - (t510 + t485 * modes_W_upper_arm_43 + t497 * modes_W_upper_arm_53);
    const six_link_real t511 = C_upper_arm_11 * modes_W_upper_arm_14 + t473 * modes_W_upper_arm_24
        + t479 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_14 = M_loaded_upper_arm_14
        - (t511 + t485 * modes_W_upper_arm_44 + t497 * modes_W_upper_arm_54);
    const six_link_real t512 = C_upper_arm_11 * modes_W_upper_arm_15 + t473 * modes_W_upper_arm_25
        + t479 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_15 = M_loaded_upper_arm_15
        - (t512 + t485 * modes_W_upper_arm_45 + t497 * modes_W_upper_arm_55);
    const six_link_real t513 = C_upper_arm_11 * modes_W_upper_arm_16 + t473 * modes_W_upper_arm_26
        + t479 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_16 = M_loaded_upper_arm_16
        - (t513 + t485 * modes_W_upper_arm_46 + t497 * modes_W_upper_arm_56);
    const six_link_real t514 = C_upper_arm_21 * modes_W_upper_arm_12 + t474 * modes_W_upper_arm_22
        + t480 * modes_W_upper_arm_32;
    const six_link_real M_i_upper_arm_22 = M_loaded_upper_arm_22
        - (t514 + t486 * modes_W_upper_arm_42 + t498 * modes_W_upper_arm_52);
    const six_link_real t515 = C_upper_arm_21 * modes_W_upper_arm_13 + t474 * modes_W_upper_arm_23
        + t480 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_23 = M_loaded_upper_arm_23
        - (t515 + t486 * modes_W_upper_arm_43 + t498 * modes_W_upper_arm_53);
    const six_link_real t516 = C_upper_arm_21 * modes_W_upper_arm_14 + t474 * modes_W_upper_arm_24
        + t480 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_24 = M_loaded_upper_arm_24
        - (t516 + t486 * modes_W_upper_arm_44 + t498 * modes_W_upper_arm_54);
    const six_link_real t517 = C_upper_arm_21 * modes_W_upper_arm_15 + t474 * modes_W_upper_arm_25
        + t480 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_25 = M_loaded_upper_arm_25
        - (t517 + t486 * modes_W_upper_arm_45 + t498 * modes_W_upper_arm_55);
    const six_link_real t518 = C_upper_arm_21 * modes_W_upper_arm_16 + t474 * modes_W_upper_arm_26
        + t480 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_26 = M_loaded_upper_arm_26
        - (t518 + t486 * modes_W_upper_arm_46 + t498 * modes_W_upper_arm_56);
    const six_link_real t519 = C_upper_arm_31 * modes_W_upper_arm_13 + t475 * modes_W_upper_arm_23
        + t481 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_33 = M_loaded_upper_arm_33
        - (t519 + t487 * modes_W_upper_arm_43 + t499 * modes_W_upper_arm_53);
    const six_link_real t520 = C_upper_arm_31 * modes_W_upper_arm_14 + t475 * modes_W_upper_arm_24
        + t481 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_34 = M_loaded_upper_arm_34
        - (t520 + t487 * modes_W_upper_arm_44 + t499 * modes_W_upper_arm_54);
    const six_link_real t521 = C_upper_arm_31 * modes_W_upper_arm_15 + t475 * modes_W_upper_arm_25
        + t481 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_35 = M_loaded_upper_arm_35
        - (t521 + t487 * modes_W_upper_arm_45 + t499 * modes_W_upper_arm_55);
    const six_link_real t522 = C_upper_arm_31 * modes_W_upper_arm_16 + t475 * modes_W_upper_arm_26
        + t481 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_36 = M_loaded_upper_arm_36
        - (t522 + t487 * modes_W_upper_arm_46 + t499 * modes_W_upper_arm_56);
    const six_link_real t523 = C_upper_arm_41 * modes_W_upper_arm_14 + t476 * modes_W_upper_arm_24
        + t482 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_44 = M_loaded_upper_arm_44
        - (t523 + t488 * modes_W_upper_arm_44 + t500 * modes_W_upper_arm_54);
    const six_link_real t524 = C_upper_arm_41 * modes_W_upper_arm_15 + t476 * modes_W_upper_arm_25
        + t482 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_45 = Lambda_forearm_17
        - (t524 + t488 * modes_W_upper_arm_45 + t500 * modes_W_upper_arm_55);
    const six_link_real t525 = C_upper_arm_41 * modes_W_upper_arm_16 + t476 * modes_W_upper_arm_26
        + t482 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_46 = Lambda_forearm_18
        - (t525 + t488 * modes_W_upper_arm_46 + t500 * modes_W_upper_arm_56);
    const six_link_real t526 = C_upper_arm_51 * modes_W_upper_arm_15 + t477 * modes_W_upper_arm_25
        + t483 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_55 = M_loaded_upper_arm_55
        - (t526 + t489 * modes_W_upper_arm_45 + t501 * modes_W_upper_arm_55);
    const six_link_real t527 = C_upper_arm_51 * modes_W_upper_arm_16 + t477 * modes_W_upper_arm_26
        + t483 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_56 = Lambda_forearm_20
        - (t527 + t489 * modes_W_upper_arm_46 + t501 * modes_W_upper_arm_56);
    const six_link_real t528 = C_upper_arm_61 * modes_W_upper_arm_16 + t478 * modes_W_upper_arm_26
        + t484 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_66 = M_loaded_upper_arm_66
        - (t528 + t490 * modes_W_upper_arm_46 + t502 * modes_W_upper_arm_56);
    const six_link_real t529 = modes_W_upper_arm_11 * h_phi_upper_arm_1 + modes_W_upper_arm_21 * t503
        + modes_W_upper_arm_31 * t504;
    const six_link_real t530 = modes_W_upper_arm_12 * h_phi_upper_arm_1 + modes_W_upper_arm_22 * t503
        + modes_W_upper_arm_32 * t504;
    const six_link_real t531 = modes_W_upper_arm_13 * h_phi_upper_arm_1 + modes_W_upper_arm_23 * t503
        + modes_W_upper_arm_33 * t504;
    const six_link_real t532 = modes_W_upper_arm_14 * h_phi_upper_arm_1 + modes_W_upper_arm_24 * t503
        + modes_W_upper_arm_34 * t504;
    const six_link_real t533 = modes_W_upper_arm_15 * h_phi_upper_arm_1 + modes_W_upper_arm_25 * t503
        + modes_W_upper_arm_35 * t504;
    const six_link_real t534 = modes_W_upper_arm_16 * h_phi_upper_arm_1 + modes_W_upper_arm_26 * t503
        + modes_W_upper_arm_36 * t504;
    const six_link_real h_i_upper_arm_1 = h_loaded_upper_arm_1
        - (t529 + modes_W_upper_arm_41 * t505 + modes_W_upper_arm_51 * t507);
    const six_link_real h_i_upper_arm_2 = h_loaded_upper_arm_2
        - (t530 + modes_W_upper_arm_42 * t505 + modes_W_upper_arm_52 * t507);
    const six_link_real h_i_upper_arm_3 = h_loaded_upper_arm_3
        - (t531 + modes_W_upper_arm_43 * t505 + modes_W_upper_arm_53 * t507);
    const six_link_real h_i_upper_arm_4 = h_loaded_upper_arm_4
        - (t532 + modes_W_upper_arm_44 * t505 + modes_W_upper_arm_54 * t507);
    const six_link_real h_i_upper_arm_5 = h_loaded_upper_arm_5
        - (t533 + modes_W_upper_arm_45 * t505 + modes_W_upper_arm_55 * t507);
    const six_link_real h_i_upper_arm_6 = h_loaded_upper_arm_6
        - (t534 + modes_W_upper_arm_46 * t505 + modes_W_upper_arm_56 * t507);

    /* upper_arm, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_upper_arm_11 = M_i_upper_arm_22 + m_eta[1];
    bad |= (unsigned long)(!(joint_inertia_upper_arm_11
        - t88 * (M_i_upper_arm_11 + M_i_upper_arm_22 + M_i_upper_arm_33) > 0)) << 1;
    const six_link_real joint_inverse_upper_arm_1 = 1 / joint_inertia_upper_arm_11;
    const six_link_real joint_W_upper_arm_11 = M_i_upper_arm_12 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_12 = M_i_upper_arm_22 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_13 = M_i_upper_arm_23 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_14 = M_i_upper_arm_24 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_15 = M_i_upper_arm_25 * joint_inverse_upper_arm_1;
    const six_link_real joint_W_upper_arm_16 = M_i_upper_arm_26 * joint_inverse_upper_arm_1;
    const six_link_real joint_w_upper_arm_1 = (input->tau[1] - work->f_eta[1] - h_i_upper_arm_2)
        * joint_inverse_upper_arm_1;
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
    const six_link_real t535 = c->links[1].mount_xyz_y * Lambda_i_upper_arm_46;
    const six_link_real t536 = r_R_upper_arm_x * Lambda_i_upper_arm_56;
    const six_link_real t537 = Lambda_i_upper_arm_15
        + (c->links[1].mount_xyz_y * Lambda_i_upper_arm_56 - r_R_upper_arm_z * Lambda_i_upper_arm_55);
    const six_link_real t538 = Lambda_i_upper_arm_16
        + (c->links[1].mount_xyz_y * Lambda_i_upper_arm_66 - r_R_upper_arm_z * Lambda_i_upper_arm_56);
    const six_link_real t539 = Lambda_i_upper_arm_24
        + (r_R_upper_arm_z * Lambda_i_upper_arm_44 - r_R_upper_arm_x * Lambda_i_upper_arm_46);
    const six_link_real t540 = Lambda_i_upper_arm_26
        + (r_R_upper_arm_z * Lambda_i_upper_arm_46 - r_R_upper_arm_x * Lambda_i_upper_arm_66);
    const six_link_real t541 = Lambda_i_upper_arm_34
        + (r_R_upper_arm_x * Lambda_i_upper_arm_45 - c->links[1].mount_xyz_y * Lambda_i_upper_arm_44);
    const six_link_real t542 = Lambda_i_upper_arm_35
        + (r_R_upper_arm_x * Lambda_i_upper_arm_55 - c->links[1].mount_xyz_y * Lambda_i_upper_arm_45);
    const six_link_real t543 = Lambda_i_upper_arm_36 + (t536 - t535);
    const six_link_real t544 = Lambda_i_upper_arm_11
        - (Lambda_i_upper_arm_15 * r_R_upper_arm_z - Lambda_i_upper_arm_16 * c->links[1].mount_xyz_y);
    const six_link_real t545 = Lambda_i_upper_arm_13
        - (Lambda_i_upper_arm_14 * c->links[1].mount_xyz_y - Lambda_i_upper_arm_15 * r_R_upper_arm_x);
    const six_link_real t546 = t545 + (c->links[1].mount_xyz_y * t543 - r_R_upper_arm_z * t542);
    const six_link_real t547 = Lambda_i_upper_arm_22
        - (Lambda_i_upper_arm_26 * r_R_upper_arm_x - Lambda_i_upper_arm_24 * r_R_upper_arm_z);
    const six_link_real Lambda_upper_arm_7 = t547 + (r_R_upper_arm_z * t539 - r_R_upper_arm_x * t540);
    const six_link_real t548 = Lambda_i_upper_arm_33
        - (Lambda_i_upper_arm_34 * c->links[1].mount_xyz_y - Lambda_i_upper_arm_35 * r_R_upper_arm_x);
    const six_link_real t549 = t548 + (r_R_upper_arm_x * t542 - c->links[1].mount_xyz_y * t541);
    const six_link_real t550 = (t544 + (c->links[1].mount_xyz_y * t538 - r_R_upper_arm_z * t537) - t549) * REAL(0.5);
    const six_link_real t551 = t550 * R_rel_upper_arm_xx + t546 * R_rel_upper_arm_xz;
    const six_link_real t552 = t546 * R_rel_upper_arm_xx - t550 * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_1 = R_rel_upper_arm_xx * t551 * 2 + t549;
    const six_link_real Lambda_upper_arm_12 = t549 - R_rel_upper_arm_xz * t552 * 2;
    const six_link_real Lambda_upper_arm_11 = t540 * R_rel_upper_arm_xx - t539 * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_14 = R_rel_upper_arm_xx * t542 - R_rel_upper_arm_xz * t537;
    const six_link_real t553 = Lambda_i_upper_arm_46 * R_rel_upper_arm_xx
        - (Lambda_i_upper_arm_44 - Lambda_i_upper_arm_66) * REAL(0.5) * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_21 = Lambda_i_upper_arm_66 - R_rel_upper_arm_xz * t553 * 2;
    const six_link_real t554 = p_i_upper_arm_1
        + (c->links[1].mount_xyz_y * p_i_upper_arm_6 - r_R_upper_arm_z * p_i_upper_arm_5);
    const six_link_real t555 = p_i_upper_arm_3
        + (r_R_upper_arm_x * p_i_upper_arm_5 - c->links[1].mount_xyz_y * p_i_upper_arm_4);
    const six_link_real p_upper_arm_3 = R_rel_upper_arm_xx * t555 - R_rel_upper_arm_xz * t554;

    /* shoulder, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_shoulder_3 = c->links[0].S_0_x * a_J_shoulder_y;

    /* shoulder, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real Lambda_T_shoulder_11 = Lambda_upper_arm_1 + c->links[0].I_T_xx;
    const six_link_real Lambda_T_shoulder_22 = Lambda_upper_arm_7 + c->links[0].I_T_yy;
    const six_link_real Lambda_T_shoulder_26 = Lambda_upper_arm_11 - c->links[0].S_T_x;
    const six_link_real Lambda_T_shoulder_33 = Lambda_upper_arm_12 + c->links[0].I_T_zz;
    const six_link_real Lambda_T_shoulder_35 = Lambda_upper_arm_14 + c->links[0].S_T_x;
    const six_link_real Lambda_T_shoulder_55 = Lambda_i_upper_arm_55 + c->links[0].body0_mass;
    const six_link_real Lambda_T_shoulder_66 = Lambda_upper_arm_21 + c->links[0].body0_mass;
    const six_link_real t556 = p_i_upper_arm_5
        + (c->links[0].body0_mass * a_J_shoulder_y - state->v[0] * (state->v[0] * c->links[0].S_T_y));
    const six_link_real p_T_shoulder_3 = p_upper_arm_3
        + (c->links[0].S_T_x * a_J_shoulder_y + c->links[0].S_T_y * minus_a_t_shoulder_x) - input->w_ext[0][2];
    const six_link_real p_T_shoulder_5 = t556 - input->w_ext[0][4];

    /* shoulder, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t557 = Lambda_T_shoulder_35 + c->links[0].length * Lambda_T_shoulder_55;
    const six_link_real t558 = Lambda_T_shoulder_22 - Lambda_T_shoulder_26 * c->links[0].length
        - c->links[0].length * (Lambda_T_shoulder_26 - c->links[0].length * Lambda_T_shoulder_66);
    const six_link_real M_loaded_shoulder_11 = c->links[0].I_s + Lambda_T_shoulder_11;
    const six_link_real M_loaded_shoulder_22 = c->links[0].J_0_xx + t558;
    const six_link_real M_loaded_shoulder_33 = c->links[0].J_0_xx
        + (Lambda_T_shoulder_33 + Lambda_T_shoulder_35 * c->links[0].length + c->links[0].length * t557);
    const six_link_real h_loaded_shoulder_3 = H_star_shoulder_3
        + (p_T_shoulder_3 + c->links[0].length * p_T_shoulder_5);

    /* shoulder, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_shoulder_11 = M_loaded_shoulder_33 + m_eta[0];
    bad |= (unsigned long)(!(joint_inertia_shoulder_11
        - t88 * (M_loaded_shoulder_11 + M_loaded_shoulder_22 + M_loaded_shoulder_33) > 0)) << 0;
    const six_link_real joint_inverse_shoulder_1 = 1 / joint_inertia_shoulder_11;
    const six_link_real joint_w_shoulder_1 = (input->tau[0] - work->f_eta[0] - h_loaded_shoulder_3)
        * joint_inverse_shoulder_1;
    output->vdot[0] = joint_w_shoulder_1;

    /* shoulder, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real delta_T_shoulder_5 = joint_w_shoulder_1 * c->links[0].length;

    /* upper_arm, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real minus_carried_upper_arm_1 = R_rel_upper_arm_xz * joint_w_shoulder_1;
    const six_link_real carried_upper_arm_3 = R_rel_upper_arm_xx * joint_w_shoulder_1;
    const six_link_real minus_carried_upper_arm_4 = carried_upper_arm_3 * c->links[1].mount_xyz_y;
    const six_link_real minus_carried_upper_arm_6 = minus_carried_upper_arm_1 * c->links[1].mount_xyz_y;
    const six_link_real carried_upper_arm_5 = delta_T_shoulder_5
        + (carried_upper_arm_3 * r_R_upper_arm_x + minus_carried_upper_arm_1 * r_R_upper_arm_z);
    const six_link_real t559 = joint_W_upper_arm_13 * carried_upper_arm_3
        - joint_W_upper_arm_11 * minus_carried_upper_arm_1 - joint_W_upper_arm_14 * minus_carried_upper_arm_4;
    const six_link_real t560 = t559 + joint_W_upper_arm_15 * carried_upper_arm_5
        - joint_W_upper_arm_16 * minus_carried_upper_arm_6;
    const six_link_real qddot_upper_arm_1 = joint_w_upper_arm_1 - t560;
    output->vdot[1] = qddot_upper_arm_1;

    /* upper_arm, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real t561 = modes_W_upper_arm_12 * qddot_upper_arm_1
        - modes_W_upper_arm_11 * minus_carried_upper_arm_1 + modes_W_upper_arm_13 * carried_upper_arm_3;
    const six_link_real t562 = t561 - modes_W_upper_arm_14 * minus_carried_upper_arm_4
        + modes_W_upper_arm_15 * carried_upper_arm_5;
    const six_link_real t563 = modes_W_upper_arm_22 * qddot_upper_arm_1
        - modes_W_upper_arm_21 * minus_carried_upper_arm_1 + modes_W_upper_arm_23 * carried_upper_arm_3;
    const six_link_real t564 = t563 - modes_W_upper_arm_24 * minus_carried_upper_arm_4
        + modes_W_upper_arm_25 * carried_upper_arm_5;
    const six_link_real t565 = modes_W_upper_arm_32 * qddot_upper_arm_1
        - modes_W_upper_arm_31 * minus_carried_upper_arm_1 + modes_W_upper_arm_33 * carried_upper_arm_3;
    const six_link_real t566 = t565 - modes_W_upper_arm_34 * minus_carried_upper_arm_4
        + modes_W_upper_arm_35 * carried_upper_arm_5;
    const six_link_real t567 = modes_W_upper_arm_42 * qddot_upper_arm_1
        - modes_W_upper_arm_41 * minus_carried_upper_arm_1 + modes_W_upper_arm_43 * carried_upper_arm_3;
    const six_link_real t568 = t567 - modes_W_upper_arm_44 * minus_carried_upper_arm_4
        + modes_W_upper_arm_45 * carried_upper_arm_5;
    const six_link_real t569 = modes_W_upper_arm_52 * qddot_upper_arm_1
        - modes_W_upper_arm_51 * minus_carried_upper_arm_1 + modes_W_upper_arm_53 * carried_upper_arm_3;
    const six_link_real t570 = t569 - modes_W_upper_arm_54 * minus_carried_upper_arm_4
        + modes_W_upper_arm_55 * carried_upper_arm_5;
    const six_link_real minus_etaddot_upper_arm_5 = modes_w_upper_arm_5
        + (t570 - modes_W_upper_arm_56 * minus_carried_upper_arm_6);
    output->vdot[10] = -minus_etaddot_upper_arm_5;
    const six_link_real minus_etaddot_upper_arm_4 = modes_w_upper_arm_4
        + (t568 - modes_W_upper_arm_46 * minus_carried_upper_arm_6) - modes_L_upper_arm_54 * minus_etaddot_upper_arm_5;
    output->vdot[9] = -minus_etaddot_upper_arm_4;
    const six_link_real t571 = modes_w_upper_arm_3 + (t566 - modes_W_upper_arm_36 * minus_carried_upper_arm_6)
        - modes_L_upper_arm_43 * minus_etaddot_upper_arm_4;
    const six_link_real minus_etaddot_upper_arm_3 = t571 - modes_L_upper_arm_53 * minus_etaddot_upper_arm_5;
    output->vdot[8] = -minus_etaddot_upper_arm_3;
    const six_link_real t572 = modes_w_upper_arm_2 + (t564 - modes_W_upper_arm_26 * minus_carried_upper_arm_6)
        - modes_L_upper_arm_32 * minus_etaddot_upper_arm_3;
    const six_link_real minus_etaddot_upper_arm_2 = t572 - modes_L_upper_arm_42 * minus_etaddot_upper_arm_4
        - modes_L_upper_arm_52 * minus_etaddot_upper_arm_5;
    output->vdot[7] = -minus_etaddot_upper_arm_2;
    const six_link_real t573 = modes_w_upper_arm_1 + (t562 - modes_W_upper_arm_16 * minus_carried_upper_arm_6)
        - modes_L_upper_arm_21 * minus_etaddot_upper_arm_2;
    const six_link_real t574 = t573 - modes_L_upper_arm_31 * minus_etaddot_upper_arm_3
        - modes_L_upper_arm_41 * minus_etaddot_upper_arm_4;
    const six_link_real minus_etaddot_upper_arm_1 = t574 - modes_L_upper_arm_51 * minus_etaddot_upper_arm_5;
    output->vdot[6] = -minus_etaddot_upper_arm_1;

    /* upper_arm, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real t575 = minus_etaddot_upper_arm_5 * REAL(1.7320508075688772);
    const six_link_real t576 = c->links[1].Psi_c_y3 * minus_etaddot_upper_arm_3
        + c->links[1].Psi_c_y4 * minus_etaddot_upper_arm_4;
    const six_link_real t577 = c->links[1].Psi_c_z1 * minus_etaddot_upper_arm_1
        + c->links[1].Psi_c_z2 * minus_etaddot_upper_arm_2;
    const six_link_real t578 = minus_etaddot_upper_arm_1 * REAL(2.0195202782688155)
        + minus_etaddot_upper_arm_2 * REAL(2.8145226674626453);
    const six_link_real t579 = minus_etaddot_upper_arm_3 * REAL(2.0195202782688155)
        + minus_etaddot_upper_arm_4 * REAL(2.8145226674626453);
    const six_link_real delta_T_upper_arm_4 = qddot_upper_arm_1 * r_T_upper_arm_z
        - carried_upper_arm_3 * r_T_upper_arm_y - minus_carried_upper_arm_4;
    const six_link_real t580 = carried_upper_arm_5
        + (carried_upper_arm_3 * c->links[1].length + minus_carried_upper_arm_1 * r_T_upper_arm_z);
    const six_link_real t581 = minus_carried_upper_arm_6
        + (minus_carried_upper_arm_1 * r_T_upper_arm_y + qddot_upper_arm_1 * c->links[1].length);
    const six_link_real minus_delta_T_upper_arm_1 = minus_carried_upper_arm_1
        + (J_l_upper_arm_xx * t575 + J_l_upper_arm_xy * t576 + J_l_upper_arm_xz * t577);
    const six_link_real delta_T_upper_arm_2 = qddot_upper_arm_1
        - (J_l_upper_arm_yx * t575 + J_l_upper_arm_yy * t576 + J_l_upper_arm_yz * t577);
    const six_link_real delta_T_upper_arm_3 = carried_upper_arm_3
        - (J_l_upper_arm_zx * t575 + J_l_upper_arm_zy * t576 + J_l_upper_arm_zz * t577);
    const six_link_real delta_T_upper_arm_5 = t580 - t578;
    const six_link_real minus_delta_T_upper_arm_6 = t581 + t579;

    /* forearm, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_forearm_1 = R_P_forearm_21 * delta_T_upper_arm_2
        - R_P_forearm_11 * minus_delta_T_upper_arm_1 + R_P_forearm_31 * delta_T_upper_arm_3;
    const six_link_real carried_forearm_2 = R_P_forearm_22 * delta_T_upper_arm_2
        - R_P_forearm_12 * minus_delta_T_upper_arm_1 + R_P_forearm_32 * delta_T_upper_arm_3;
    const six_link_real carried_forearm_3 = R_P_forearm_23 * delta_T_upper_arm_2
        - R_P_forearm_13 * minus_delta_T_upper_arm_1 + R_P_forearm_33 * delta_T_upper_arm_3;
    const six_link_real t582 = R_P_forearm_11 * delta_T_upper_arm_4 + R_P_forearm_21 * delta_T_upper_arm_5
        - R_P_forearm_31 * minus_delta_T_upper_arm_6;
    const six_link_real t583 = R_P_forearm_12 * delta_T_upper_arm_4 + R_P_forearm_22 * delta_T_upper_arm_5
        - R_P_forearm_32 * minus_delta_T_upper_arm_6;
    const six_link_real t584 = R_P_forearm_13 * delta_T_upper_arm_4 + R_P_forearm_23 * delta_T_upper_arm_5
        - R_P_forearm_33 * minus_delta_T_upper_arm_6;
    const six_link_real carried_forearm_4 = t582
        + (carried_forearm_2 * r_R_forearm_z - carried_forearm_3 * r_R_forearm_y);
    const six_link_real carried_forearm_5 = t583
        + (carried_forearm_3 * r_R_forearm_x - carried_forearm_1 * r_R_forearm_z);
    const six_link_real carried_forearm_6 = t584
        + (carried_forearm_1 * r_R_forearm_y - carried_forearm_2 * r_R_forearm_x);
    const six_link_real t585 = joint_W_forearm_11 * carried_forearm_1 + joint_W_forearm_12 * carried_forearm_2
        + joint_W_forearm_13 * carried_forearm_3;
    const six_link_real t586 = t585 + joint_W_forearm_14 * carried_forearm_4 + joint_W_forearm_15 * carried_forearm_5
        + joint_W_forearm_16 * carried_forearm_6;
    const six_link_real qddot_forearm_1 = joint_w_forearm_1 - t586;
    output->vdot[2] = qddot_forearm_1;

    /* forearm, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_forearm_2 = carried_forearm_2 + qddot_forearm_1;
    const six_link_real t587 = modes_W_forearm_11 * carried_forearm_1 + modes_W_forearm_12 * delta_forearm_2
        + modes_W_forearm_13 * carried_forearm_3;
    const six_link_real t588 = t587 + modes_W_forearm_14 * carried_forearm_4 + modes_W_forearm_15 * carried_forearm_5
        + modes_W_forearm_16 * carried_forearm_6;
    const six_link_real t589 = modes_W_forearm_21 * carried_forearm_1 + modes_W_forearm_22 * delta_forearm_2
        + modes_W_forearm_23 * carried_forearm_3;
    const six_link_real t590 = t589 + modes_W_forearm_24 * carried_forearm_4 + modes_W_forearm_25 * carried_forearm_5
        + modes_W_forearm_26 * carried_forearm_6;
    const six_link_real t591 = modes_W_forearm_31 * carried_forearm_1 + modes_W_forearm_32 * delta_forearm_2
        + modes_W_forearm_33 * carried_forearm_3;
    const six_link_real t592 = t591 + modes_W_forearm_34 * carried_forearm_4 + modes_W_forearm_35 * carried_forearm_5
        + modes_W_forearm_36 * carried_forearm_6;
    const six_link_real t593 = modes_W_forearm_41 * carried_forearm_1 + modes_W_forearm_42 * delta_forearm_2
        + modes_W_forearm_43 * carried_forearm_3;
    const six_link_real t594 = t593 + modes_W_forearm_44 * carried_forearm_4 + modes_W_forearm_45 * carried_forearm_5
        + modes_W_forearm_46 * carried_forearm_6;
    const six_link_real minus_etaddot_forearm_4 = modes_w_forearm_4 + t594;
    output->vdot[14] = -minus_etaddot_forearm_4;
    const six_link_real minus_etaddot_forearm_3 = modes_w_forearm_3 + t592
        - modes_L_forearm_43 * minus_etaddot_forearm_4;
    output->vdot[13] = -minus_etaddot_forearm_3;
    const six_link_real minus_etaddot_forearm_2 = modes_w_forearm_2 + t590
        - modes_L_forearm_32 * minus_etaddot_forearm_3 - modes_L_forearm_42 * minus_etaddot_forearm_4;
    output->vdot[12] = -minus_etaddot_forearm_2;
    const six_link_real t595 = modes_w_forearm_1 + t588 - modes_L_forearm_21 * minus_etaddot_forearm_2
        - modes_L_forearm_31 * minus_etaddot_forearm_3;
    const six_link_real minus_etaddot_forearm_1 = t595 - modes_L_forearm_41 * minus_etaddot_forearm_4;
    output->vdot[11] = -minus_etaddot_forearm_1;

    /* forearm, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real t596 = c->links[2].Psi_c_y3 * minus_etaddot_forearm_3
        + c->links[2].Psi_c_y4 * minus_etaddot_forearm_4;
    const six_link_real t597 = c->links[2].Psi_c_z1 * minus_etaddot_forearm_1
        + c->links[2].Psi_c_z2 * minus_etaddot_forearm_2;
    const six_link_real t598 = minus_etaddot_forearm_1 * REAL(2.0195202782688155)
        + minus_etaddot_forearm_2 * REAL(2.8145226674626453);
    const six_link_real t599 = minus_etaddot_forearm_3 * REAL(2.0195202782688155)
        + minus_etaddot_forearm_4 * REAL(2.8145226674626453);
    const six_link_real delta_T_forearm_4 = carried_forearm_4
        + (delta_forearm_2 * r_T_forearm_z - carried_forearm_3 * r_T_forearm_y);
    const six_link_real delta_T_forearm_1 = carried_forearm_1 + (minus_J_l_forearm_xy * t596 - J_l_forearm_xz * t597);
    const six_link_real delta_T_forearm_2 = delta_forearm_2 - (J_l_forearm_yy * t596 + J_l_forearm_yz * t597);
    const six_link_real delta_T_forearm_3 = carried_forearm_3 - (J_l_forearm_yz * t596 + J_l_forearm_zz * t597);
    const six_link_real delta_T_forearm_5 = carried_forearm_5
        + (carried_forearm_3 * c->links[2].length - carried_forearm_1 * r_T_forearm_z) - t598;
    const six_link_real delta_T_forearm_6 = carried_forearm_6
        + (carried_forearm_1 * r_T_forearm_y - delta_forearm_2 * c->links[2].length) - t599;

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
    const six_link_real t600 = joint_W_wrist_roll_11 * carried_wrist_roll_1
        + joint_W_wrist_roll_12 * carried_wrist_roll_2 + joint_W_wrist_roll_13 * carried_wrist_roll_3;
    const six_link_real t601 = t600 + joint_W_wrist_roll_14 * carried_wrist_roll_4
        + joint_W_wrist_roll_15 * carried_wrist_roll_5;
    const six_link_real qddot_wrist_roll_1 = joint_w_wrist_roll_1
        - (t601 + joint_W_wrist_roll_16 * carried_wrist_roll_6);
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
    const six_link_real t602 = joint_W_wrist_pitch_11 * carried_wrist_pitch_1
        + joint_W_wrist_pitch_12 * carried_wrist_roll_2 + joint_W_wrist_pitch_13 * carried_wrist_pitch_3;
    const six_link_real t603 = t602 + joint_W_wrist_pitch_14 * carried_wrist_pitch_4
        - minus_joint_W_wrist_pitch_15 * delta_T_wrist_roll_5;
    const six_link_real qddot_wrist_pitch_1 = joint_w_wrist_pitch_1
        - (t603 + joint_W_wrist_pitch_16 * carried_wrist_pitch_6);
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
    const six_link_real t604 = joint_W_flange_11 * carried_wrist_pitch_1 - minus_joint_W_flange_12 * carried_flange_2
        - minus_joint_W_flange_13 * carried_flange_3;
    const six_link_real qddot_flange_1 = joint_w_flange_1
        - (t604 - minus_joint_W_flange_15 * carried_flange_5 + joint_W_flange_16 * carried_flange_6);
    output->vdot[5] = qddot_flange_1;

    if (wanted & SIX_LINK_WRENCHES) {
        /* upper_arm, joint: its accelerations eliminated from its rows (43) */
        const six_link_real Lambda_i_upper_arm_12 = M_i_upper_arm_12 - M_i_upper_arm_12 * joint_W_upper_arm_12;
        const six_link_real Lambda_i_upper_arm_23 = M_i_upper_arm_23 - M_i_upper_arm_22 * joint_W_upper_arm_13;
        const six_link_real Lambda_i_upper_arm_25 = M_i_upper_arm_25 - M_i_upper_arm_22 * joint_W_upper_arm_15;
        const six_link_real p_i_upper_arm_2 = h_i_upper_arm_2 + M_i_upper_arm_22 * joint_w_upper_arm_1;

        /* upper_arm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
        const six_link_real t605 = r_R_upper_arm_z * Lambda_i_upper_arm_45;
        const six_link_real t606 = Lambda_i_upper_arm_14 + (t535 - t605);
        const six_link_real Lambda_upper_arm_10 = Lambda_i_upper_arm_25 + (t605 - t536);
        const six_link_real t607 = Lambda_i_upper_arm_12
            - (Lambda_i_upper_arm_16 * r_R_upper_arm_x - Lambda_i_upper_arm_14 * r_R_upper_arm_z);
        const six_link_real t608 = Lambda_i_upper_arm_23
            - (Lambda_i_upper_arm_24 * c->links[1].mount_xyz_y - Lambda_i_upper_arm_25 * r_R_upper_arm_x);
        const six_link_real Lambda_upper_arm_3 = R_rel_upper_arm_xx * t552 - R_rel_upper_arm_xz * t551;
        const six_link_real t609 = R_rel_upper_arm_xz
            * (t607 + (c->links[1].mount_xyz_y * t540 - r_R_upper_arm_z * Lambda_upper_arm_10));
        const six_link_real Lambda_upper_arm_8 = (t608 + (r_R_upper_arm_z * t541 - r_R_upper_arm_x * t543))
            * R_rel_upper_arm_xx - t609;
        const six_link_real Lambda_upper_arm_5 = R_rel_upper_arm_xx * t537 + R_rel_upper_arm_xz * t542;
        const six_link_real Lambda_upper_arm_13 = R_rel_upper_arm_xx
            * (t541 * R_rel_upper_arm_xx + t543 * R_rel_upper_arm_xz)
            - R_rel_upper_arm_xz * (t606 * R_rel_upper_arm_xx + t538 * R_rel_upper_arm_xz);
        const six_link_real Lambda_upper_arm_15 = R_rel_upper_arm_xx
            * (t543 * R_rel_upper_arm_xx - t541 * R_rel_upper_arm_xz)
            - R_rel_upper_arm_xz * (t538 * R_rel_upper_arm_xx - t606 * R_rel_upper_arm_xz);
        const six_link_real Lambda_upper_arm_17 = R_rel_upper_arm_xx * Lambda_i_upper_arm_45
            + Lambda_i_upper_arm_56 * R_rel_upper_arm_xz;
        const six_link_real Lambda_upper_arm_20 = Lambda_i_upper_arm_56 * R_rel_upper_arm_xx
            - R_rel_upper_arm_xz * Lambda_i_upper_arm_45;
        const six_link_real p_upper_arm_2 = p_i_upper_arm_2
            + (r_R_upper_arm_z * p_i_upper_arm_4 - r_R_upper_arm_x * p_i_upper_arm_6);
        const six_link_real p_upper_arm_1 = R_rel_upper_arm_xx * t554 + R_rel_upper_arm_xz * t555;
        const six_link_real p_upper_arm_4 = R_rel_upper_arm_xx * p_i_upper_arm_4 + R_rel_upper_arm_xz * p_i_upper_arm_6;
        const six_link_real p_upper_arm_6 = R_rel_upper_arm_xx * p_i_upper_arm_6 - R_rel_upper_arm_xz * p_i_upper_arm_4;

        /* shoulder, H_star: gyroscopic wrench and weight, angular acceleration included */
        const six_link_real H_star_shoulder_2 = c->links[0].S_0_x * c->gravity[2];
        const six_link_real minus_H_star_shoulder_4 = minus_a_J_shoulder_x * c->links[0].mu
            + minus_Omega_shoulder_xx * c->links[0].S_0_x;
        const six_link_real H_star_shoulder_5 = a_J_shoulder_y * c->links[0].mu;
        const six_link_real minus_H_star_shoulder_6 = c->gravity[2] * c->links[0].mu;

        /* shoulder, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
        const six_link_real Lambda_T_shoulder_13 = Lambda_upper_arm_3 - c->links[0].J_T_xz;
        const six_link_real Lambda_T_shoulder_15 = Lambda_upper_arm_5 - c->links[0].S_T_z;
        const six_link_real Lambda_T_shoulder_23 = Lambda_upper_arm_8 - c->links[0].J_T_yz;
        const six_link_real Lambda_T_shoulder_34 = Lambda_upper_arm_13 - c->links[0].S_T_y;
        const six_link_real t610 = state->v[0] * (c->links[0].J_T_yz * state->v[0])
            - (c->links[0].S_T_y * c->gravity[2] + c->links[0].S_T_z * a_J_shoulder_y);
        const six_link_real t611 = c->links[0].S_T_x * c->gravity[2] - c->links[0].S_T_z * minus_a_t_shoulder_x
            - state->v[0] * (c->links[0].J_T_xz * state->v[0]);
        const six_link_real t612 = p_upper_arm_4
            - (c->links[0].body0_mass * minus_a_t_shoulder_x + state->v[0] * (state->v[0] * c->links[0].S_T_x));
        const six_link_real p_T_shoulder_1 = p_upper_arm_1 + t610 - input->w_ext[0][0];
        const six_link_real p_T_shoulder_2 = p_upper_arm_2 + t611 - input->w_ext[0][1];
        const six_link_real p_T_shoulder_4 = t612 - input->w_ext[0][3];
        const six_link_real p_T_shoulder_6 = p_upper_arm_6 - c->links[0].body0_mass * c->gravity[2]
            - input->w_ext[0][5];

        /* shoulder, modes: the tip load folded in, modal accelerations eliminated (83) */
        const six_link_real M_loaded_shoulder_34 = Lambda_T_shoulder_34 + c->links[0].length * Lambda_upper_arm_17;
        const six_link_real M_loaded_shoulder_36 = Lambda_upper_arm_15 + c->links[0].length * Lambda_upper_arm_20;
        const six_link_real M_loaded_shoulder_13 = Lambda_T_shoulder_13 + Lambda_T_shoulder_15 * c->links[0].length;
        const six_link_real M_loaded_shoulder_23 = Lambda_T_shoulder_23 + Lambda_upper_arm_10 * c->links[0].length
            - c->links[0].length * M_loaded_shoulder_36;
        const six_link_real M_loaded_shoulder_35 = c->links[0].S_0_x + t557;
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
        const six_link_real t613 = Lambda_i_upper_arm_13 * carried_upper_arm_3
            - Lambda_i_upper_arm_11 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_14 * minus_carried_upper_arm_4;
        const six_link_real t614 = t613 + Lambda_i_upper_arm_15 * carried_upper_arm_5
            - Lambda_i_upper_arm_16 * minus_carried_upper_arm_6;
        const six_link_real t615 = Lambda_i_upper_arm_23 * carried_upper_arm_3
            - Lambda_i_upper_arm_12 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_24 * minus_carried_upper_arm_4;
        const six_link_real t616 = t615 + Lambda_i_upper_arm_25 * carried_upper_arm_5
            - Lambda_i_upper_arm_26 * minus_carried_upper_arm_6;
        const six_link_real t617 = Lambda_i_upper_arm_33 * carried_upper_arm_3
            - Lambda_i_upper_arm_13 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_34 * minus_carried_upper_arm_4;
        const six_link_real t618 = t617 + Lambda_i_upper_arm_35 * carried_upper_arm_5
            - Lambda_i_upper_arm_36 * minus_carried_upper_arm_6;
        const six_link_real t619 = Lambda_i_upper_arm_34 * carried_upper_arm_3
            - Lambda_i_upper_arm_14 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_44 * minus_carried_upper_arm_4;
        const six_link_real t620 = t619 + Lambda_i_upper_arm_45 * carried_upper_arm_5
            - Lambda_i_upper_arm_46 * minus_carried_upper_arm_6;
        const six_link_real t621 = Lambda_i_upper_arm_35 * carried_upper_arm_3
            - Lambda_i_upper_arm_15 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_45 * minus_carried_upper_arm_4;
        const six_link_real t622 = t621 + Lambda_i_upper_arm_55 * carried_upper_arm_5
            - Lambda_i_upper_arm_56 * minus_carried_upper_arm_6;
        const six_link_real t623 = Lambda_i_upper_arm_36 * carried_upper_arm_3
            - Lambda_i_upper_arm_16 * minus_carried_upper_arm_1 - Lambda_i_upper_arm_46 * minus_carried_upper_arm_4;
        const six_link_real t624 = t623 + Lambda_i_upper_arm_56 * carried_upper_arm_5
            - Lambda_i_upper_arm_66 * minus_carried_upper_arm_6;
        const six_link_real wrench_upper_arm_1 = t614 + p_i_upper_arm_1;
        output->wrench[1][0] = wrench_upper_arm_1;
        const six_link_real wrench_upper_arm_2 = t616 + p_i_upper_arm_2;
        output->wrench[1][1] = wrench_upper_arm_2;
        const six_link_real wrench_upper_arm_3 = t618 + p_i_upper_arm_3;
        output->wrench[1][2] = wrench_upper_arm_3;
        const six_link_real wrench_upper_arm_4 = t620 + p_i_upper_arm_4;
        output->wrench[1][3] = wrench_upper_arm_4;
        const six_link_real wrench_upper_arm_5 = t622 + p_i_upper_arm_5;
        output->wrench[1][4] = wrench_upper_arm_5;
        const six_link_real wrench_upper_arm_6 = t624 + p_i_upper_arm_6;
        output->wrench[1][5] = wrench_upper_arm_6;

        /* joint wrench (48)_forearm */
        const six_link_real t625 = Lambda_i_forearm_11 * carried_forearm_1 + Lambda_i_forearm_12 * carried_forearm_2
            + Lambda_i_forearm_13 * carried_forearm_3;
        const six_link_real t626 = t625 + Lambda_i_forearm_14 * carried_forearm_4
            + Lambda_i_forearm_15 * carried_forearm_5 + Lambda_i_forearm_16 * carried_forearm_6;
        const six_link_real t627 = Lambda_i_forearm_12 * carried_forearm_1 + Lambda_i_forearm_22 * carried_forearm_2
            + Lambda_i_forearm_23 * carried_forearm_3;
        const six_link_real t628 = t627 + Lambda_i_forearm_24 * carried_forearm_4
            + Lambda_i_forearm_25 * carried_forearm_5 + Lambda_i_forearm_26 * carried_forearm_6;
        const six_link_real t629 = Lambda_i_forearm_13 * carried_forearm_1 + Lambda_i_forearm_23 * carried_forearm_2
            + Lambda_i_forearm_33 * carried_forearm_3;
        const six_link_real t630 = t629 + Lambda_i_forearm_34 * carried_forearm_4
            + Lambda_i_forearm_35 * carried_forearm_5 + Lambda_i_forearm_36 * carried_forearm_6;
        const six_link_real t631 = Lambda_i_forearm_14 * carried_forearm_1 + Lambda_i_forearm_24 * carried_forearm_2
            + Lambda_i_forearm_34 * carried_forearm_3;
        const six_link_real t632 = t631 + Lambda_i_forearm_44 * carried_forearm_4
            + Lambda_i_forearm_45 * carried_forearm_5 + Lambda_i_forearm_46 * carried_forearm_6;
        const six_link_real t633 = Lambda_i_forearm_15 * carried_forearm_1 + Lambda_i_forearm_25 * carried_forearm_2
            + Lambda_i_forearm_35 * carried_forearm_3;
        const six_link_real t634 = t633 + Lambda_i_forearm_45 * carried_forearm_4
            + Lambda_i_forearm_55 * carried_forearm_5 + Lambda_i_forearm_56 * carried_forearm_6;
        const six_link_real t635 = Lambda_i_forearm_16 * carried_forearm_1 + Lambda_i_forearm_26 * carried_forearm_2
            + Lambda_i_forearm_36 * carried_forearm_3;
        const six_link_real t636 = t635 + Lambda_i_forearm_46 * carried_forearm_4
            + Lambda_i_forearm_56 * carried_forearm_5 + Lambda_i_forearm_66 * carried_forearm_6;
        const six_link_real wrench_forearm_1 = t626 + p_i_forearm_1;
        output->wrench[2][0] = wrench_forearm_1;
        const six_link_real wrench_forearm_2 = t628 + p_i_forearm_2;
        output->wrench[2][1] = wrench_forearm_2;
        const six_link_real wrench_forearm_3 = t630 + p_i_forearm_3;
        output->wrench[2][2] = wrench_forearm_3;
        const six_link_real wrench_forearm_4 = t632 + p_i_forearm_4;
        output->wrench[2][3] = wrench_forearm_4;
        const six_link_real wrench_forearm_5 = t634 + p_i_forearm_5;
        output->wrench[2][4] = wrench_forearm_5;
        const six_link_real wrench_forearm_6 = t636 + p_i_forearm_6;
        output->wrench[2][5] = wrench_forearm_6;

        /* joint wrench (48)_wrist_roll */
        const six_link_real t637 = Lambda_i_wrist_roll_11 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_12 * carried_wrist_roll_2 + Lambda_i_wrist_roll_13 * carried_wrist_roll_3;
        const six_link_real t638 = t637 + Lambda_i_wrist_roll_14 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_15 * carried_wrist_roll_5;
        const six_link_real t639 = Lambda_i_wrist_roll_12 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_22 * carried_wrist_roll_2 + Lambda_i_wrist_roll_23 * carried_wrist_roll_3;
        const six_link_real t640 = t639 + Lambda_i_wrist_roll_24 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_25 * carried_wrist_roll_5;
        const six_link_real t641 = Lambda_i_wrist_roll_13 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_23 * carried_wrist_roll_2 + Lambda_i_wrist_roll_33 * carried_wrist_roll_3;
        const six_link_real t642 = t641 + Lambda_i_wrist_roll_34 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_35 * carried_wrist_roll_5;
        const six_link_real t643 = Lambda_i_wrist_roll_14 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_24 * carried_wrist_roll_2 + Lambda_i_wrist_roll_34 * carried_wrist_roll_3;
        const six_link_real t644 = t643 + Lambda_i_wrist_roll_44 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_45 * carried_wrist_roll_5;
        const six_link_real t645 = Lambda_i_wrist_roll_15 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_25 * carried_wrist_roll_2 + Lambda_i_wrist_roll_35 * carried_wrist_roll_3;
        const six_link_real t646 = t645 + Lambda_i_wrist_roll_45 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_55 * carried_wrist_roll_5;
        const six_link_real t647 = Lambda_i_wrist_roll_16 * carried_wrist_roll_1
            + Lambda_i_wrist_roll_26 * carried_wrist_roll_2 + Lambda_i_wrist_roll_36 * carried_wrist_roll_3;
        const six_link_real t648 = t647 - minus_Lambda_i_wrist_roll_46 * carried_wrist_roll_4
            + Lambda_i_wrist_roll_56 * carried_wrist_roll_5;
        const six_link_real wrench_wrist_roll_1 = t638 + Lambda_i_wrist_roll_16 * carried_wrist_roll_6
            + p_i_wrist_roll_1;
        output->wrench[3][0] = wrench_wrist_roll_1;
        const six_link_real wrench_wrist_roll_2 = t640 + Lambda_i_wrist_roll_26 * carried_wrist_roll_6
            + p_i_wrist_roll_2;
        output->wrench[3][1] = wrench_wrist_roll_2;
        const six_link_real wrench_wrist_roll_3 = t642 + Lambda_i_wrist_roll_36 * carried_wrist_roll_6
            + p_i_wrist_roll_3;
        output->wrench[3][2] = wrench_wrist_roll_3;
        const six_link_real wrench_wrist_roll_4 = t644 - minus_Lambda_i_wrist_roll_46 * carried_wrist_roll_6
            + p_i_wrist_roll_4;
        output->wrench[3][3] = wrench_wrist_roll_4;
        const six_link_real wrench_wrist_roll_5 = t646 + Lambda_i_wrist_roll_56 * carried_wrist_roll_6
            + p_i_wrist_roll_5;
        output->wrench[3][4] = wrench_wrist_roll_5;
        const six_link_real wrench_wrist_roll_6 = t648 + Lambda_i_wrist_roll_66 * carried_wrist_roll_6
            + p_i_wrist_roll_6;
        output->wrench[3][5] = wrench_wrist_roll_6;

        /* joint wrench (48)_wrist_pitch */
        const six_link_real t649 = Lambda_i_wrist_pitch_11 * carried_wrist_pitch_1
            + Lambda_i_wrist_pitch_12 * carried_wrist_roll_2 + Lambda_i_wrist_pitch_13 * carried_wrist_pitch_3;
        const six_link_real t650 = t649 - minus_Lambda_i_wrist_pitch_14 * carried_wrist_pitch_4
            + Lambda_i_wrist_pitch_15 * delta_T_wrist_roll_5;
        const six_link_real t651 = Lambda_i_wrist_pitch_12 * carried_wrist_pitch_1
            + Lambda_i_wrist_pitch_22 * carried_wrist_roll_2 + Lambda_i_wrist_pitch_23 * carried_wrist_pitch_3;
        const six_link_real t652 = t651 + Lambda_i_wrist_pitch_24 * carried_wrist_pitch_4
            + Lambda_i_wrist_pitch_25 * delta_T_wrist_roll_5;
        const six_link_real t653 = Lambda_i_wrist_pitch_13 * carried_wrist_pitch_1
            + Lambda_i_wrist_pitch_23 * carried_wrist_roll_2 + Lambda_i_wrist_pitch_33 * carried_wrist_pitch_3;
        const six_link_real t654 = t653 + Lambda_i_wrist_pitch_34 * carried_wrist_pitch_4
            + Lambda_i_wrist_pitch_35 * delta_T_wrist_roll_5;
        const six_link_real t655 = Lambda_i_wrist_pitch_24 * carried_wrist_roll_2
            - minus_Lambda_i_wrist_pitch_14 * carried_wrist_pitch_1;
        const six_link_real t656 = t655 + Lambda_i_wrist_pitch_34 * carried_wrist_pitch_3
            + Lambda_i_wrist_pitch_44 * carried_wrist_pitch_4;
        const six_link_real t657 = t656 + Lambda_i_wrist_pitch_45 * delta_T_wrist_roll_5
            - minus_Lambda_i_wrist_pitch_46 * carried_wrist_pitch_6;
        const six_link_real t658 = Lambda_i_wrist_pitch_15 * carried_wrist_pitch_1
            + Lambda_i_wrist_pitch_25 * carried_wrist_roll_2 + Lambda_i_wrist_pitch_35 * carried_wrist_pitch_3;
        const six_link_real t659 = t658 + Lambda_i_wrist_pitch_45 * carried_wrist_pitch_4
            + Lambda_i_wrist_pitch_55 * delta_T_wrist_roll_5;
        const six_link_real t660 = Lambda_i_wrist_pitch_16 * carried_wrist_pitch_1
            + Lambda_i_wrist_pitch_26 * carried_wrist_roll_2 + Lambda_i_wrist_pitch_36 * carried_wrist_pitch_3;
        const six_link_real t661 = t660 - minus_Lambda_i_wrist_pitch_46 * carried_wrist_pitch_4
            + Lambda_i_wrist_pitch_56 * delta_T_wrist_roll_5;
        const six_link_real wrench_wrist_pitch_1 = t650 + Lambda_i_wrist_pitch_16 * carried_wrist_pitch_6
            + p_i_wrist_pitch_1;
        output->wrench[4][0] = wrench_wrist_pitch_1;
        const six_link_real wrench_wrist_pitch_2 = t652 + Lambda_i_wrist_pitch_26 * carried_wrist_pitch_6
            + p_i_wrist_pitch_2;
        output->wrench[4][1] = wrench_wrist_pitch_2;
        const six_link_real wrench_wrist_pitch_3 = t654 + Lambda_i_wrist_pitch_36 * carried_wrist_pitch_6
            + p_i_wrist_pitch_3;
        output->wrench[4][2] = wrench_wrist_pitch_3;
        const six_link_real wrench_wrist_pitch_4 = t657 + p_i_wrist_pitch_4;
        output->wrench[4][3] = wrench_wrist_pitch_4;
        const six_link_real wrench_wrist_pitch_5 = t659 + Lambda_i_wrist_pitch_56 * carried_wrist_pitch_6
            + p_i_wrist_pitch_5;
        output->wrench[4][4] = wrench_wrist_pitch_5;
        const six_link_real wrench_wrist_pitch_6 = t661 + Lambda_i_wrist_pitch_66 * carried_wrist_pitch_6
            + p_i_wrist_pitch_6;
        output->wrench[4][5] = wrench_wrist_pitch_6;

        /* joint wrench (48)_flange */
        const six_link_real t662 = Lambda_i_flange_11 * carried_wrist_pitch_1 + Lambda_i_flange_12 * carried_flange_2
            + Lambda_i_flange_13 * carried_flange_3;
        const six_link_real t663 = Lambda_i_flange_12 * carried_wrist_pitch_1 + Lambda_i_flange_22 * carried_flange_2
            - minus_Lambda_i_flange_23 * carried_flange_3;
        const six_link_real t664 = t663 + c->links[5].S_T_z * carried_wrist_pitch_4
            - minus_Lambda_i_flange_25 * carried_flange_5 + Lambda_i_flange_26 * carried_flange_6;
        const six_link_real t665 = Lambda_i_flange_13 * carried_wrist_pitch_1
            - minus_Lambda_i_flange_23 * carried_flange_2 + Lambda_i_flange_33 * carried_flange_3;
        const six_link_real t666 = t665 - c->links[5].S_T_y * carried_wrist_pitch_4
            + Lambda_i_flange_35 * carried_flange_5 + Lambda_i_flange_36 * carried_flange_6;
        const six_link_real t667 = c->links[5].S_T_z * carried_flange_2 - c->links[5].S_T_y * carried_flange_3
            + M_loaded_flange_44 * carried_wrist_pitch_4;
        const six_link_real t668 = Lambda_i_flange_15 * carried_wrist_pitch_1
            - minus_Lambda_i_flange_25 * carried_flange_2 + Lambda_i_flange_35 * carried_flange_3;
        const six_link_real t669 = Lambda_i_flange_16 * carried_wrist_pitch_1 + Lambda_i_flange_26 * carried_flange_2
            + Lambda_i_flange_36 * carried_flange_3;
        const six_link_real wrench_flange_1 = t662 + Lambda_i_flange_15 * carried_flange_5
            + Lambda_i_flange_16 * carried_flange_6 + p_i_flange_1;
        output->wrench[5][0] = wrench_flange_1;
        const six_link_real wrench_flange_2 = t664 + p_i_flange_2;
        output->wrench[5][1] = wrench_flange_2;
        const six_link_real wrench_flange_3 = t666 + p_i_flange_3;
        output->wrench[5][2] = wrench_flange_3;
        const six_link_real wrench_flange_4 = t667 + h_loaded_flange_4;
        output->wrench[5][3] = wrench_flange_4;
        const six_link_real wrench_flange_5 = t668 + Lambda_i_flange_55 * carried_flange_5
            + Lambda_i_flange_56 * carried_flange_6 + p_i_flange_5;
        output->wrench[5][4] = wrench_flange_5;
        const six_link_real wrench_flange_6 = t669 + Lambda_i_flange_56 * carried_flange_5
            + Lambda_i_flange_66 * carried_flange_6 + p_i_flange_6;
        output->wrench[5][5] = wrench_flange_6;

        if (wanted & SIX_LINK_MOTION) {
            /* upper_arm, link: what is added to the acceleration of F_i, modal accelerations (83) */
            const six_link_real alpha_upper_arm_4 = a_J_upper_arm_x - minus_carried_upper_arm_4;
            work->motion[1][2] = alpha_upper_arm_4;

            const six_link_real t670 = S_upper_arm_z * qddot_upper_arm_1 - S_upper_arm_y * carried_upper_arm_3
                - c->links[1].mu * minus_carried_upper_arm_4;
            const six_link_real motion_upper_arm_4 = t670 + h_V_upper_arm_4;
            work->motion[1][3] = motion_upper_arm_4;

            /* forearm, link: what is added to the acceleration of F_i, modal accelerations (83) */
            const six_link_real alpha_forearm_4 = carried_forearm_4 + a_J_forearm_x;
            work->motion[2][2] = alpha_forearm_4;

            const six_link_real t671 = S_forearm_z * delta_forearm_2 - S_forearm_y * carried_forearm_3
                + c->links[2].m * carried_forearm_4;
            const six_link_real motion_forearm_4 = t671 + h_V_forearm_4;
            work->motion[2][3] = motion_forearm_4;

            /* outputs */
            work->motion[0][0] = 0;
            work->motion[0][1] = 0;
            work->motion[0][2] = 0;
            work->motion[0][3] = 0;
            work->motion[1][0] = state->v[1];
            work->motion[1][1] = omega_R_upper_arm_3;
            work->motion[2][0] = omega_forearm_y;
            work->motion[2][1] = omega_R_forearm_3;
            work->motion[3][0] = 0;
            work->motion[3][1] = 0;
            work->motion[3][2] = 0;
            work->motion[3][3] = 0;
            work->motion[4][0] = 0;
            work->motion[4][1] = 0;
            work->motion[4][2] = 0;
            work->motion[4][3] = 0;
            work->motion[5][0] = 0;
            work->motion[5][1] = 0;
            work->motion[5][2] = 0;
            work->motion[5][3] = 0;
        }
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
        const six_link_real t672 = R_upper_arm_xx * c->links[1].length - minus_R_rel_shoulder_xy * r_T_upper_arm_y
            + R_upper_arm_xz * r_T_upper_arm_z;
        const six_link_real t673 = R_upper_arm_yx * c->links[1].length + R_rel_shoulder_xx * r_T_upper_arm_y
            + R_upper_arm_yz * r_T_upper_arm_z;
        const six_link_real r_tip_upper_arm_x = r_upper_arm_x + t672;
        const six_link_real r_tip_upper_arm_y = r_upper_arm_y + t673;
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
        const six_link_real t674 = R_tip_upper_arm_xx * c->links[2].mount_xyz_x
            + R_tip_upper_arm_xy * c->links[2].mount_xyz_y + R_tip_upper_arm_xz * c->links[2].mount_xyz_z;
        const six_link_real t675 = R_tip_upper_arm_yx * c->links[2].mount_xyz_x
            + R_tip_upper_arm_yy * c->links[2].mount_xyz_y + R_tip_upper_arm_yz * c->links[2].mount_xyz_z;
        const six_link_real t676 = R_tip_upper_arm_zx * c->links[2].mount_xyz_x
            + R_tip_upper_arm_zy * c->links[2].mount_xyz_y + R_tip_upper_arm_zz * c->links[2].mount_xyz_z;
        const six_link_real r_forearm_x = r_tip_upper_arm_x + t674;
        const six_link_real r_forearm_y = r_tip_upper_arm_y + t675;
        const six_link_real r_forearm_z = r_tip_upper_arm_z + t676;

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
        const six_link_real R_flange_xy = R_wrist_roll_xy * R_rel_flange_yy + R_wrist_pitch_xz * minus_R_rel_flange_yz;
        output->tip_rotation[0][1] = R_flange_xy;
        const six_link_real R_flange_xz = R_wrist_pitch_xz * R_rel_flange_yy - R_wrist_roll_xy * minus_R_rel_flange_yz;
        output->tip_rotation[0][2] = R_flange_xz;
        const six_link_real R_flange_yy = R_wrist_roll_yy * R_rel_flange_yy + R_wrist_pitch_yz * minus_R_rel_flange_yz;
        output->tip_rotation[1][1] = R_flange_yy;
        const six_link_real R_flange_yz = R_wrist_pitch_yz * R_rel_flange_yy - R_wrist_roll_yy * minus_R_rel_flange_yz;
        output->tip_rotation[1][2] = R_flange_yz;
        const six_link_real R_flange_zy = R_wrist_roll_zy * R_rel_flange_yy + R_wrist_pitch_zz * minus_R_rel_flange_yz;
        output->tip_rotation[2][1] = R_flange_zy;
        const six_link_real R_flange_zz = R_wrist_pitch_zz * R_rel_flange_yy - R_wrist_roll_zy * minus_R_rel_flange_yz;
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
        /* the elimination runs from the tip: report the outermost link that failed */
        for (link = 0; link < SIX_LINK_NLINKS; ++link) {
            if ((bad >> link) & 1u) {
                work->fault = link;
            }
        }
        return SIX_LINK_SINGULAR;
    }
    return SIX_LINK_OK;
}

const six_link_real six_link_measure_bounds[SIX_LINK_NMEASURES] = { REAL(0.1), REAL(0.35), REAL(0.02), REAL(0.2) };

six_link_status six_link_validity(const six_link_constants *c, const six_link_state *state,
    const six_link_output *output,
    const six_link_work *work, six_link_measures *measures)
{
    six_link_call call = { 0 };
    six_link_status status;
    int fault = 0;
    if (!c || !state || !output || !work || !measures) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    call.eta = state->q + SIX_LINK_NTAU;
    call.given_wrench = &output->wrench[0][0];
    call.given_motion = &work->motion[0][0];
    call.measures = &measures->value[0][0];
    status = six_link_measuring(c, &call, 0, &fault);
    return six_link_finite(call.measures, SIX_LINK_NMEASURES * SIX_LINK_NLINKS) ? status : SIX_LINK_NONFINITE;
}

six_link_status six_link_inverse_dynamics(const six_link_constants *c, const six_link_state *state,
    const six_link_input *input,
    const six_link_real vdot[], six_link_chain *chain, six_link_real force[], six_link_real wrench[][6])
{
    six_link_real f_eta[SIX_LINK_LENGTH(SIX_LINK_NV)];
    six_link_call call = { 0 };
    six_link_status status;
    int k, fault = 0;
    if (!c || !state || !input || !vdot || !chain || !force) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    for (k = 0; k < SIX_LINK_NV; ++k) {
        f_eta[k] = c->K[k] * state->q[k] + c->D[k] * state->v[k];
    }
    call.gravity = c->gravity;
    call.q = state->q;
    call.qdot = state->v;
    call.eta = state->q + SIX_LINK_NTAU;
    call.etadot = state->v + SIX_LINK_NTAU;
    call.w_ext = &input->w_ext[0][0];
    call.m_q = c->M_eta;
    call.f_q = f_eta;
    call.m_eta = c->M_eta + SIX_LINK_NTAU;
    call.f_eta = f_eta + SIX_LINK_NTAU;
    call.given_qddot = vdot;
    call.given_etaddot = vdot + SIX_LINK_NTAU;
    call.force = force;
    call.force_eta = force + SIX_LINK_NTAU;
    call.wrench = wrench ? &wrench[0][0] : 0;
    status = six_link_inverse(c, &call, chain, &fault);
    if (status == SIX_LINK_OK
        && !(six_link_finite(force, SIX_LINK_NV) && six_link_finite(call.w_ext, 6 * SIX_LINK_NLINKS)
        && (!wrench || six_link_finite(&wrench[0][0], 6 * SIX_LINK_NLINKS)))) {
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
    call.m_q = c->M_eta;
    call.m_eta = c->M_eta + SIX_LINK_NTAU;
    call.given_qddot = unit;
    call.given_etaddot = unit + SIX_LINK_NTAU;
    if (!six_link_finite(state->q, SIX_LINK_NQ)) {
        return SIX_LINK_NONFINITE;
    }
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
