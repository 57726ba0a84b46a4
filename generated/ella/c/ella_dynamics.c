/* ella_dynamics.c: forward dynamics of the joint form by block elimination, tip to base;
 * inverse dynamics and mass matrix.
 */
/* Long straight lines: GCC schedules them before it hands out registers on most processors, on x86 only where it is
 * told to, and makes vectors of neighbours there, which takes longer than it saves. Results are the same to the bit.
 */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#pragma GCC optimize("no-tree-slp-vectorize", "schedule-insns", "sched-pressure")
#endif
#include "ella_links.h"

/* The call at a state, with inertia m and force f of the coordinates that have their own. */
static ella_call call_at(const ella_constants *c, const ella_state *state, const ella_real *m, const ella_real *f)
{
    ella_call call = { 0 };
    call.gravity = c->gravity;
    call.q = state->q;
    call.qdot = state->v;
    call.eta = state->q + (ELLA_NQ - ELLA_NMODES);
    call.etadot = state->v + (ELLA_NV - ELLA_NMODES);
    call.m_eta = m + (ELLA_NGIVEN - ELLA_NMODES);
    call.f_eta = f + (ELLA_NGIVEN - ELLA_NMODES);
    return call;
}

/* The whole chain in one function: outward kinematics, inward elimination, outward accelerations. */
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

    /* upper_arm, acceleration of the parent's tip in F_i axes */
    const ella_real acc_0_upper_arm_a_x = minus_R_rel_upper_arm_zx * c->gravity[2]
        - (R_rel_upper_arm_xx * c->gravity[0] + R_rel_upper_arm_yx * c->gravity[1]);
    const ella_real acc_0_upper_arm_a_y = minus_R_rel_upper_arm_xy * c->gravity[0]
        - R_rel_upper_arm_yy * c->gravity[1] - R_rel_upper_arm_zy * c->gravity[2];
    const ella_real minus_acc_0_upper_arm_a_z = R_rel_upper_arm_xz * c->gravity[0] + R_rel_upper_arm_zz * c->gravity[2];

    /* upper_arm, omega_J: angular velocity of the link relative to its parent's tip */
    const ella_real omega_J_upper_arm_x = R_rel_upper_arm_yx * state->v[0];
    const ella_real omega_J_upper_arm_y = R_rel_upper_arm_yy * state->v[0];

    /* upper_arm, alpha: angular acceleration while no joint accelerates (accconst4) */
    const ella_real t1 = state->v[0] * state->v[1];
    const ella_real alpha_upper_arm_x = t1 * R_rel_upper_arm_yy;
    const ella_real minus_alpha_upper_arm_y = t1 * R_rel_upper_arm_yx;

    /* upper_arm, r_T: tip point (11) */
    const ella_real r_T_upper_arm_y = state->q[3] * ELLA_REAL(2.0011941703010714)
        + state->q[4] * ELLA_REAL(2.0700807911885764) + state->q[5] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_upper_arm_z = state->q[6] * ELLA_REAL(2.0011941703010714)
        + state->q[7] * ELLA_REAL(2.0700807911885764) + state->q[8] * ELLA_REAL(3.5651069283690613);

    /* upper_arm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_upper_arm_x = state->q[9] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_upper_arm_y = c->links[0].Psi_c_y4 * state->q[6] + c->links[0].Psi_c_y5 * state->q[7]
        + c->links[0].Psi_c_y6 * state->q[8];
    const ella_real theta_upper_arm_z = c->links[0].Psi_c_z1 * state->q[3] + c->links[0].Psi_c_z2 * state->q[4]
        + c->links[0].Psi_c_z3 * state->q[5];

    /* upper_arm, x: squared angle of the tip section */
    const ella_real t2 = theta_upper_arm_x * theta_upper_arm_x;
    const ella_real t3 = theta_upper_arm_y * theta_upper_arm_y;
    const ella_real minus_theta_hat2_upper_arm_33 = t2 + t3;
    const ella_real t4 = theta_upper_arm_z * theta_upper_arm_z;
    const ella_real x_upper_arm = minus_theta_hat2_upper_arm_33 + t4;

    /* upper_arm, c2: Stumpff function of order 2 */
    const ella_real t5 = ella_c4(x_upper_arm);
    const ella_real c2_upper_arm = ELLA_REAL(0.5) - x_upper_arm * t5;

    /* upper_arm, c3: Stumpff function of order 3 */
    const ella_real t6 = ella_c5(x_upper_arm);
    const ella_real c3_upper_arm = ELLA_REAL(0.16666666666666666) - x_upper_arm * t6;

    /* upper_arm, udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_upper_arm_y = state->v[3] * ELLA_REAL(2.0011941703010714)
        + state->v[4] * ELLA_REAL(2.0700807911885764) + state->v[5] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_upper_arm_z = state->v[6] * ELLA_REAL(2.0011941703010714)
        + state->v[7] * ELLA_REAL(2.0700807911885764) + state->v[8] * ELLA_REAL(3.5651069283690613);

    /* upper_arm, thetadot: rate of the tip's rotation vector */
    const ella_real thetadot_upper_arm_x = state->v[9] * ELLA_REAL(1.7320508075688772);
    const ella_real thetadot_upper_arm_y = c->links[0].Psi_c_y4 * state->v[6] + c->links[0].Psi_c_y5 * state->v[7]
        + c->links[0].Psi_c_y6 * state->v[8];
    const ella_real thetadot_upper_arm_z = c->links[0].Psi_c_z1 * state->v[3] + c->links[0].Psi_c_z2 * state->v[4]
        + c->links[0].Psi_c_z3 * state->v[5];

    /* upper_arm, omega_s: angular velocity of the tip section relative to F_i */
    const ella_real t7 = theta_upper_arm_y * thetadot_upper_arm_z - theta_upper_arm_z * thetadot_upper_arm_y;
    const ella_real t8 = theta_upper_arm_x * thetadot_upper_arm_y - theta_upper_arm_y * thetadot_upper_arm_x;
    const ella_real t9 = theta_upper_arm_z * thetadot_upper_arm_x - theta_upper_arm_x * thetadot_upper_arm_z;
    const ella_real t10 = theta_upper_arm_y * t8 - theta_upper_arm_z * t9;
    const ella_real omega_s_upper_arm_x = thetadot_upper_arm_x + c2_upper_arm * t7 + c3_upper_arm * t10;
    const ella_real t11 = theta_upper_arm_z * t7 - theta_upper_arm_x * t8;
    const ella_real omega_s_upper_arm_y = thetadot_upper_arm_y + c2_upper_arm * t9 + c3_upper_arm * t11;
    const ella_real t12 = theta_upper_arm_x * t9 - theta_upper_arm_y * t7;
    const ella_real omega_s_upper_arm_z = thetadot_upper_arm_z + c2_upper_arm * t8 + c3_upper_arm * t12;

    /* upper_arm, xdot: rate of the squared angle */
    const ella_real t13 = state->q[9] * ELLA_REAL(3.4641016151377544) * thetadot_upper_arm_x
        + theta_upper_arm_y * 2 * thetadot_upper_arm_y;
    const ella_real xdot_upper_arm = t13 + theta_upper_arm_z * 2 * thetadot_upper_arm_z;

    /* upper_arm, c2dot: rate of c2 */
    const ella_real c2dot_upper_arm = xdot_upper_arm * (t5 - c3_upper_arm * ELLA_REAL(0.5));

    /* upper_arm, c3dot: rate of c3 */
    const ella_real c3dot_upper_arm = xdot_upper_arm * (t6 * ELLA_REAL(1.5) - t5 * ELLA_REAL(0.5));

    /* upper_arm, alpha_s: rate of the section's angular velocity without etaddot */
    const ella_real alpha_s_upper_arm_x = c2dot_upper_arm * t7
        + c3_upper_arm * (thetadot_upper_arm_y * t8 - thetadot_upper_arm_z * t9) + c3dot_upper_arm * t10;
    const ella_real alpha_s_upper_arm_y = c2dot_upper_arm * t9
        + c3_upper_arm * (thetadot_upper_arm_z * t7 - thetadot_upper_arm_x * t8) + c3dot_upper_arm * t11;
    const ella_real alpha_s_upper_arm_z = c2dot_upper_arm * t8
        + c3_upper_arm * (thetadot_upper_arm_x * t9 - thetadot_upper_arm_y * t7) + c3dot_upper_arm * t12;

    /* upper_arm, omega_t: angular velocity of the tip section (46) */
    const ella_real omega_t_upper_arm_x = omega_s_upper_arm_x + omega_J_upper_arm_x;
    const ella_real omega_t_upper_arm_y = omega_s_upper_arm_y + omega_J_upper_arm_y;
    const ella_real omega_t_upper_arm_z = omega_s_upper_arm_z + state->v[1];

    /* upper_arm, alpha_t: angular acceleration of the tip section (accconst1b) */
    const ella_real alpha_t_upper_arm_x = alpha_s_upper_arm_x + alpha_upper_arm_x
        + omega_s_upper_arm_z * omega_J_upper_arm_y - omega_s_upper_arm_y * state->v[1];
    const ella_real alpha_t_upper_arm_y = alpha_s_upper_arm_y - minus_alpha_upper_arm_y
        + omega_s_upper_arm_x * state->v[1] - omega_s_upper_arm_z * omega_J_upper_arm_x;
    const ella_real alpha_t_upper_arm_z = alpha_s_upper_arm_z + omega_s_upper_arm_y * omega_J_upper_arm_x
        - omega_s_upper_arm_x * omega_J_upper_arm_y;

    /* upper_arm, a_t: acceleration of the tip point (accconst1b) */
    const ella_real t14 = udot_T_upper_arm_z * 2 + omega_J_upper_arm_x * r_T_upper_arm_y
        - c->links[0].length * omega_J_upper_arm_y;
    const ella_real t15 = udot_T_upper_arm_y * 2 + c->links[0].length * state->v[1]
        - omega_J_upper_arm_x * r_T_upper_arm_z;
    const ella_real a_t_upper_arm_x = acc_0_upper_arm_a_x - minus_alpha_upper_arm_y * r_T_upper_arm_z
        + omega_J_upper_arm_y * t14 - state->v[1] * t15;
    const ella_real t16 = omega_J_upper_arm_y * r_T_upper_arm_z - state->v[1] * r_T_upper_arm_y;
    const ella_real a_t_upper_arm_y = acc_0_upper_arm_a_y + state->v[1] * t16 - alpha_upper_arm_x * r_T_upper_arm_z
        - omega_J_upper_arm_x * t14;
    const ella_real t17 = alpha_upper_arm_x * r_T_upper_arm_y - minus_acc_0_upper_arm_a_z + omega_J_upper_arm_x * t15
        + minus_alpha_upper_arm_y * c->links[0].length;
    const ella_real a_t_upper_arm_z = t17 - omega_J_upper_arm_y * t16;

    /* upper_arm, c1: Stumpff function of order 1 */
    const ella_real c1_upper_arm = 1 - x_upper_arm * c3_upper_arm;

    /* upper_arm, theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_upper_arm_11 = t3 + t4;
    const ella_real theta_hat2_upper_arm_12 = theta_upper_arm_x * theta_upper_arm_y;
    const ella_real theta_hat2_upper_arm_13 = theta_upper_arm_x * theta_upper_arm_z;
    const ella_real minus_theta_hat2_upper_arm_22 = t2 + t4;
    const ella_real theta_hat2_upper_arm_23 = theta_upper_arm_y * theta_upper_arm_z;

    /* upper_arm, J_l: left Jacobian of the exponential */
    const ella_real J_l_upper_arm_xx = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_11;
    const ella_real t18 = c3_upper_arm * theta_hat2_upper_arm_12;
    const ella_real t19 = c2_upper_arm * theta_upper_arm_z;
    const ella_real J_l_upper_arm_xy = t18 - t19;
    const ella_real t20 = c2_upper_arm * theta_upper_arm_y;
    const ella_real t21 = c3_upper_arm * theta_hat2_upper_arm_13;
    const ella_real J_l_upper_arm_xz = t20 + t21;
    const ella_real J_l_upper_arm_yx = t19 + t18;
    const ella_real J_l_upper_arm_yy = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_22;
    const ella_real t22 = c3_upper_arm * theta_hat2_upper_arm_23;
    const ella_real t23 = c2_upper_arm * theta_upper_arm_x;
    const ella_real J_l_upper_arm_yz = t22 - t23;
    const ella_real J_l_upper_arm_zx = t21 - t20;
    const ella_real J_l_upper_arm_zy = t23 + t22;
    const ella_real J_l_upper_arm_zz = 1 - c3_upper_arm * minus_theta_hat2_upper_arm_33;

    /* upper_arm, R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_upper_arm_xx = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_11;
    const ella_real t24 = c2_upper_arm * theta_hat2_upper_arm_12;
    const ella_real t25 = c1_upper_arm * theta_upper_arm_z;
    const ella_real R_T_upper_arm_xy = t24 - t25;
    const ella_real t26 = c1_upper_arm * theta_upper_arm_y;
    const ella_real t27 = c2_upper_arm * theta_hat2_upper_arm_13;
    const ella_real R_T_upper_arm_xz = t26 + t27;
    const ella_real R_T_upper_arm_yx = t25 + t24;
    const ella_real R_T_upper_arm_yy = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_22;
    const ella_real t28 = c2_upper_arm * theta_hat2_upper_arm_23;
    const ella_real t29 = c1_upper_arm * theta_upper_arm_x;
    const ella_real R_T_upper_arm_yz = t28 - t29;
    const ella_real R_T_upper_arm_zx = t27 - t26;
    const ella_real R_T_upper_arm_zy = t29 + t28;
    const ella_real R_T_upper_arm_zz = 1 - c2_upper_arm * minus_theta_hat2_upper_arm_33;

    /* forearm, R_rel: rotation of F_i relative to the parent's tip frame */
    const ella_sincos turn_3 = ella_sine_cosine(state->q[2]);
    const ella_real R_rel_forearm_yx = turn_3.sine, R_rel_forearm_xx = turn_3.cosine;

    /* forearm, R: rotation of F_i relative to the parent's F_i (Ad) */
    const ella_real R_P_forearm_xx = R_T_upper_arm_xx * R_rel_forearm_xx + R_T_upper_arm_xy * R_rel_forearm_yx;
    const ella_real R_P_forearm_xy = R_T_upper_arm_xy * R_rel_forearm_xx - R_T_upper_arm_xx * R_rel_forearm_yx;
    const ella_real R_P_forearm_yx = R_T_upper_arm_yx * R_rel_forearm_xx + R_T_upper_arm_yy * R_rel_forearm_yx;
    const ella_real R_P_forearm_yy = R_T_upper_arm_yy * R_rel_forearm_xx - R_T_upper_arm_yx * R_rel_forearm_yx;
    const ella_real R_P_forearm_zx = R_T_upper_arm_zx * R_rel_forearm_xx + R_T_upper_arm_zy * R_rel_forearm_yx;
    const ella_real R_P_forearm_zy = R_T_upper_arm_zy * R_rel_forearm_xx - R_T_upper_arm_zx * R_rel_forearm_yx;
    const ella_real omega_R_forearm_x = R_P_forearm_xx * omega_t_upper_arm_x + R_P_forearm_yx * omega_t_upper_arm_y
        + R_P_forearm_zx * omega_t_upper_arm_z;
    const ella_real omega_R_forearm_y = R_P_forearm_xy * omega_t_upper_arm_x + R_P_forearm_yy * omega_t_upper_arm_y
        + R_P_forearm_zy * omega_t_upper_arm_z;
    const ella_real omega_R_forearm_z = R_T_upper_arm_xz * omega_t_upper_arm_x
        + R_T_upper_arm_yz * omega_t_upper_arm_y + R_T_upper_arm_zz * omega_t_upper_arm_z;

    /* forearm, acceleration of the parent's tip in F_i axes */
    const ella_real t30 = R_P_forearm_xx * alpha_t_upper_arm_x + R_P_forearm_yx * alpha_t_upper_arm_y
        + R_P_forearm_zx * alpha_t_upper_arm_z;
    const ella_real t31 = R_P_forearm_xy * alpha_t_upper_arm_x + R_P_forearm_yy * alpha_t_upper_arm_y
        + R_P_forearm_zy * alpha_t_upper_arm_z;
    const ella_real acc_0_forearm_alpha_z = R_T_upper_arm_xz * alpha_t_upper_arm_x
        + R_T_upper_arm_yz * alpha_t_upper_arm_y + R_T_upper_arm_zz * alpha_t_upper_arm_z;
    const ella_real acc_0_forearm_a_x = R_P_forearm_xx * a_t_upper_arm_x + R_P_forearm_yx * a_t_upper_arm_y
        + R_P_forearm_zx * a_t_upper_arm_z;
    const ella_real acc_0_forearm_a_y = R_P_forearm_xy * a_t_upper_arm_x + R_P_forearm_yy * a_t_upper_arm_y
        + R_P_forearm_zy * a_t_upper_arm_z;
    const ella_real acc_0_forearm_a_z = R_T_upper_arm_xz * a_t_upper_arm_x + R_T_upper_arm_yz * a_t_upper_arm_y
        + R_T_upper_arm_zz * a_t_upper_arm_z;

    /* forearm, omega: angular velocity of the link (45) */
    const ella_real omega_forearm_z = omega_R_forearm_z + state->v[2];

    /* forearm, alpha: angular acceleration while no joint accelerates (accconst4) */
    const ella_real alpha_forearm_x = t30 + omega_R_forearm_y * state->v[2];
    const ella_real alpha_forearm_y = t31 - omega_R_forearm_x * state->v[2];

    /* forearm, r_T: tip point (11) */
    const ella_real r_T_forearm_y = state->q[10] * ELLA_REAL(2.0011941703010714)
        + state->q[11] * ELLA_REAL(2.0700807911885764) + state->q[12] * ELLA_REAL(3.5651069283690613);
    const ella_real r_T_forearm_z = state->q[13] * ELLA_REAL(2.0011941703010714)
        + state->q[14] * ELLA_REAL(2.0700807911885764) + state->q[15] * ELLA_REAL(3.5651069283690613);

    /* forearm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const ella_real theta_forearm_x = state->q[16] * ELLA_REAL(1.7320508075688772);
    const ella_real theta_forearm_y = c->links[1].Psi_c_y4 * state->q[13] + c->links[1].Psi_c_y5 * state->q[14]
        + c->links[1].Psi_c_y6 * state->q[15];
    const ella_real theta_forearm_z = c->links[1].Psi_c_z1 * state->q[10] + c->links[1].Psi_c_z2 * state->q[11]
        + c->links[1].Psi_c_z3 * state->q[12];

    /* forearm, x: squared angle of the tip section */
    const ella_real t32 = theta_forearm_x * theta_forearm_x;
    const ella_real t33 = theta_forearm_y * theta_forearm_y;
    const ella_real minus_theta_hat2_forearm_33 = t32 + t33;
    const ella_real t34 = theta_forearm_z * theta_forearm_z;
    const ella_real x_forearm = minus_theta_hat2_forearm_33 + t34;

    /* forearm, c2: Stumpff function of order 2 */
    const ella_real c2_forearm = ELLA_REAL(0.5) - x_forearm * ella_c4(x_forearm);

    /* forearm, c3: Stumpff function of order 3 */
    const ella_real c3_forearm = ELLA_REAL(0.16666666666666666) - x_forearm * ella_c5(x_forearm);

    /* forearm, udot_T: rate of the tip's elastic displacement (23) */
    const ella_real udot_T_forearm_y = state->v[10] * ELLA_REAL(2.0011941703010714)
        + state->v[11] * ELLA_REAL(2.0700807911885764) + state->v[12] * ELLA_REAL(3.5651069283690613);
    const ella_real udot_T_forearm_z = state->v[13] * ELLA_REAL(2.0011941703010714)
        + state->v[14] * ELLA_REAL(2.0700807911885764) + state->v[15] * ELLA_REAL(3.5651069283690613);

    /* forearm, a_t: acceleration of the tip point (accconst1b) */
    const ella_real t35 = udot_T_forearm_z * 2 + omega_R_forearm_x * r_T_forearm_y
        - c->links[1].length * omega_R_forearm_y;
    const ella_real t36 = acc_0_forearm_a_x + alpha_forearm_y * r_T_forearm_z + omega_R_forearm_y * t35
        - acc_0_forearm_alpha_z * r_T_forearm_y;
    const ella_real t37 = udot_T_forearm_y * 2 + c->links[1].length * omega_forearm_z
        - omega_R_forearm_x * r_T_forearm_z;
    const ella_real a_t_forearm_x = t36 - omega_forearm_z * t37;
    const ella_real t38 = omega_R_forearm_y * r_T_forearm_z - omega_forearm_z * r_T_forearm_y;
    const ella_real t39 = acc_0_forearm_a_y + acc_0_forearm_alpha_z * c->links[1].length + omega_forearm_z * t38
        - alpha_forearm_x * r_T_forearm_z;
    const ella_real a_t_forearm_y = t39 - omega_R_forearm_x * t35;
    const ella_real t40 = acc_0_forearm_a_z + alpha_forearm_x * r_T_forearm_y + omega_R_forearm_x * t37
        - alpha_forearm_y * c->links[1].length;
    const ella_real a_t_forearm_z = t40 - omega_R_forearm_y * t38;

    /* forearm, c1: Stumpff function of order 1 */
    const ella_real c1_forearm = 1 - x_forearm * c3_forearm;

    /* forearm, theta_hat2: square of the rotation vector's skew matrix */
    const ella_real minus_theta_hat2_forearm_11 = t33 + t34;
    const ella_real theta_hat2_forearm_12 = theta_forearm_x * theta_forearm_y;
    const ella_real theta_hat2_forearm_13 = theta_forearm_x * theta_forearm_z;
    const ella_real minus_theta_hat2_forearm_22 = t32 + t34;
    const ella_real theta_hat2_forearm_23 = theta_forearm_y * theta_forearm_z;

    /* forearm, J_l: left Jacobian of the exponential */
    const ella_real J_l_forearm_xx = 1 - c3_forearm * minus_theta_hat2_forearm_11;
    const ella_real t41 = c3_forearm * theta_hat2_forearm_12;
    const ella_real t42 = c2_forearm * theta_forearm_z;
    const ella_real J_l_forearm_xy = t41 - t42;
    const ella_real t43 = c2_forearm * theta_forearm_y;
    const ella_real t44 = c3_forearm * theta_hat2_forearm_13;
    const ella_real J_l_forearm_xz = t43 + t44;
    const ella_real J_l_forearm_yx = t42 + t41;
    const ella_real J_l_forearm_yy = 1 - c3_forearm * minus_theta_hat2_forearm_22;
    const ella_real t45 = c3_forearm * theta_hat2_forearm_23;
    const ella_real t46 = c2_forearm * theta_forearm_x;
    const ella_real J_l_forearm_yz = t45 - t46;
    const ella_real J_l_forearm_zx = t44 - t43;
    const ella_real J_l_forearm_zy = t46 + t45;
    const ella_real J_l_forearm_zz = 1 - c3_forearm * minus_theta_hat2_forearm_33;

    /* forearm, R_T: rotation of the tip section, exp of theta */
    const ella_real R_T_forearm_xx = 1 - c2_forearm * minus_theta_hat2_forearm_11;
    const ella_real t47 = c2_forearm * theta_hat2_forearm_12;
    const ella_real t48 = c1_forearm * theta_forearm_z;
    const ella_real R_T_forearm_xy = t47 - t48;
    const ella_real t49 = c1_forearm * theta_forearm_y;
    const ella_real t50 = c2_forearm * theta_hat2_forearm_13;
    const ella_real R_T_forearm_xz = t49 + t50;
    const ella_real R_T_forearm_yx = t48 + t47;
    const ella_real R_T_forearm_yy = 1 - c2_forearm * minus_theta_hat2_forearm_22;
    const ella_real t51 = c2_forearm * theta_hat2_forearm_23;
    const ella_real t52 = c1_forearm * theta_forearm_x;
    const ella_real R_T_forearm_yz = t51 - t52;
    const ella_real R_T_forearm_zx = t50 - t49;
    const ella_real R_T_forearm_zy = t52 + t51;
    const ella_real R_T_forearm_zz = 1 - c2_forearm * minus_theta_hat2_forearm_33;

    /* forearm, S: first moment */
    const ella_real S_forearm_y = state->q[10] * c->links[1].sigma_y1 + state->q[11] * c->links[1].sigma_y2
        + state->q[12] * c->links[1].sigma_y3;
    const ella_real S_forearm_z = state->q[13] * c->links[1].sigma_y1 + state->q[14] * c->links[1].sigma_y2
        + state->q[15] * c->links[1].sigma_y3;

    /* forearm, Sdot: rate of the first moment */
    const ella_real Sdot_forearm_y = state->v[10] * c->links[1].sigma_y1 + state->v[11] * c->links[1].sigma_y2
        + state->v[12] * c->links[1].sigma_y3;
    const ella_real Sdot_forearm_z = state->v[13] * c->links[1].sigma_y1 + state->v[14] * c->links[1].sigma_y2
        + state->v[15] * c->links[1].sigma_y3;

    /* forearm, L: first moment weighted by each mode shape (85) */
    const ella_real L_forearm_y1 = c->links[1].mu * state->q[10];
    const ella_real L_forearm_y2 = c->links[1].mu * state->q[11];
    const ella_real L_forearm_y3 = c->links[1].mu * state->q[12];
    const ella_real L_forearm_z1 = state->q[13] * c->links[1].mu;
    const ella_real L_forearm_z2 = state->q[14] * c->links[1].mu;
    const ella_real L_forearm_z3 = state->q[15] * c->links[1].mu;

    /* forearm, Ldot: rate of L */
    const ella_real Ldot_forearm_y1 = c->links[1].mu * state->v[10];
    const ella_real Ldot_forearm_y2 = c->links[1].mu * state->v[11];
    const ella_real Ldot_forearm_y3 = c->links[1].mu * state->v[12];
    const ella_real Ldot_forearm_z1 = state->v[13] * c->links[1].mu;
    const ella_real Ldot_forearm_z2 = state->v[14] * c->links[1].mu;
    const ella_real Ldot_forearm_z3 = state->v[15] * c->links[1].mu;

    /* forearm, J: second moment */
    const ella_real J_forearm_xy = c->links[1].chi_1 * state->q[10] + c->links[1].chi_2 * state->q[11]
        + c->links[1].chi_3 * state->q[12];
    const ella_real J_forearm_xz = c->links[1].chi_1 * state->q[13] + c->links[1].chi_2 * state->q[14]
        + c->links[1].chi_3 * state->q[15];
    const ella_real J_forearm_yy = L_forearm_y1 * state->q[10] + L_forearm_y2 * state->q[11]
        + L_forearm_y3 * state->q[12];
    const ella_real J_forearm_yz = L_forearm_z1 * state->q[10] + L_forearm_z2 * state->q[11]
        + L_forearm_z3 * state->q[12];
    const ella_real J_forearm_zz = L_forearm_z1 * state->q[13] + L_forearm_z2 * state->q[14]
        + L_forearm_z3 * state->q[15];

    /* forearm, I: inertia about the origin, deformed */
    const ella_real I_forearm_xx = c->links[1].I_s + J_forearm_yy + J_forearm_zz;
    const ella_real I_forearm_yy = c->links[1].J_0_xx + J_forearm_zz;
    const ella_real I_forearm_zz = c->links[1].J_0_xx + J_forearm_yy;

    /* forearm, Omega: acceleration of a place by the link's turning */
    const ella_real t53 = omega_R_forearm_y * omega_R_forearm_y;
    const ella_real t54 = omega_forearm_z * omega_forearm_z;
    const ella_real minus_Omega_forearm_xx = t53 + t54;
    const ella_real t55 = omega_R_forearm_x * omega_R_forearm_y;
    const ella_real Omega_forearm_xy = t55 - acc_0_forearm_alpha_z;
    const ella_real t56 = omega_R_forearm_x * omega_forearm_z;
    const ella_real Omega_forearm_xz = alpha_forearm_y + t56;
    const ella_real Omega_forearm_yx = acc_0_forearm_alpha_z + t55;
    const ella_real t57 = omega_R_forearm_x * omega_R_forearm_x;
    const ella_real minus_Omega_forearm_yy = t57 + t54;
    const ella_real t58 = omega_R_forearm_y * omega_forearm_z;
    const ella_real Omega_forearm_yz = t58 - alpha_forearm_x;
    const ella_real Omega_forearm_zx = t56 - alpha_forearm_y;
    const ella_real Omega_forearm_zy = alpha_forearm_x + t58;
    const ella_real minus_Omega_forearm_zz = t57 + t53;

    /* forearm, B: moment of the elastic velocity */
    const ella_real B_forearm_yx = c->links[1].chi_1 * state->v[10] + c->links[1].chi_2 * state->v[11]
        + c->links[1].chi_3 * state->v[12];
    const ella_real B_forearm_yy = L_forearm_y1 * state->v[10] + L_forearm_y2 * state->v[11]
        + L_forearm_y3 * state->v[12];
    const ella_real B_forearm_yz = L_forearm_z1 * state->v[10] + L_forearm_z2 * state->v[11]
        + L_forearm_z3 * state->v[12];
    const ella_real B_forearm_zx = c->links[1].chi_1 * state->v[13] + c->links[1].chi_2 * state->v[14]
        + c->links[1].chi_3 * state->v[15];
    const ella_real B_forearm_zy = L_forearm_y1 * state->v[13] + L_forearm_y2 * state->v[14]
        + L_forearm_y3 * state->v[15];
    const ella_real B_forearm_zz = L_forearm_z1 * state->v[13] + L_forearm_z2 * state->v[14]
        + L_forearm_z3 * state->v[15];

    /* forearm, h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const ella_real h_c_forearm_tau_x = B_forearm_yy * omega_R_forearm_x + B_forearm_zz * omega_R_forearm_x;
    const ella_real h_c_forearm_tau_y = B_forearm_zz * omega_R_forearm_y - B_forearm_yx * omega_R_forearm_x
        - B_forearm_yz * omega_forearm_z;
    const ella_real h_c_forearm_tau_z = B_forearm_yy * omega_forearm_z - B_forearm_zx * omega_R_forearm_x
        - B_forearm_zy * omega_R_forearm_y;
    const ella_real h_c_forearm_f_x = Sdot_forearm_z * omega_R_forearm_y - Sdot_forearm_y * omega_forearm_z;
    const ella_real minus_h_c_forearm_f_y = Sdot_forearm_z * omega_R_forearm_x;
    const ella_real h_c_forearm_f_z = Sdot_forearm_y * omega_R_forearm_x;

    /* forearm, h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const ella_real h_MD_forearm_tau_y = h_c_forearm_tau_y + state->v[16] * omega_forearm_z * c->links[1].sigma_t_7;
    const ella_real h_MD_forearm_tau_z = h_c_forearm_tau_z - state->v[16] * omega_R_forearm_y * c->links[1].sigma_t_7;

    /* forearm, H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t59 = h_c_forearm_tau_x + c->links[1].I_s * alpha_forearm_x + J_forearm_xy * Omega_forearm_zx
        + J_forearm_yy * Omega_forearm_zy;
    const ella_real t60 = t59 + J_forearm_yz * (minus_Omega_forearm_yy - minus_Omega_forearm_zz)
        + S_forearm_y * acc_0_forearm_a_z;
    const ella_real H_star_forearm_tau_x = t60 - J_forearm_xz * Omega_forearm_yx - J_forearm_zz * Omega_forearm_yz
        - S_forearm_z * acc_0_forearm_a_y;
    const ella_real t61 = h_c_forearm_tau_y + J_forearm_xz * (minus_Omega_forearm_zz - minus_Omega_forearm_xx)
        + J_forearm_yz * Omega_forearm_xy;
    const ella_real t62 = c->links[1].I_s * omega_R_forearm_x;
    const ella_real t63 = t61 + J_forearm_zz * Omega_forearm_xz + S_forearm_z * acc_0_forearm_a_x
        + t62 * omega_forearm_z - c->links[1].J_0_xx * Omega_forearm_zx;
    const ella_real H_star_forearm_tau_y = t63 - J_forearm_xy * Omega_forearm_zy
        - c->links[1].S_0_x * acc_0_forearm_a_z;
    const ella_real t64 = h_c_forearm_tau_z + c->links[1].J_0_xx * Omega_forearm_yx
        + J_forearm_xy * (minus_Omega_forearm_xx - minus_Omega_forearm_yy);
    const ella_real t65 = t64 + J_forearm_xz * Omega_forearm_yz + c->links[1].S_0_x * acc_0_forearm_a_y
        - J_forearm_yy * Omega_forearm_xy;
    const ella_real H_star_forearm_tau_z = t65 - J_forearm_yz * Omega_forearm_xz - S_forearm_y * acc_0_forearm_a_x
        - t62 * omega_R_forearm_y;
    const ella_real t66 = h_c_forearm_f_x - minus_Omega_forearm_xx * c->links[1].S_0_x
        + Omega_forearm_xy * S_forearm_y + Omega_forearm_xz * S_forearm_z;
    const ella_real H_star_forearm_f_x = t66 + acc_0_forearm_a_x * c->links[1].mu;
    const ella_real t67 = Omega_forearm_yx * c->links[1].S_0_x - minus_h_c_forearm_f_y
        - minus_Omega_forearm_yy * S_forearm_y;
    const ella_real H_star_forearm_f_y = t67 + Omega_forearm_yz * S_forearm_z + acc_0_forearm_a_y * c->links[1].mu;
    const ella_real t68 = h_c_forearm_f_z + Omega_forearm_zx * c->links[1].S_0_x + Omega_forearm_zy * S_forearm_y
        - minus_Omega_forearm_zz * S_forearm_z;
    const ella_real H_star_forearm_f_z = t68 + acc_0_forearm_a_z * c->links[1].mu;

    /* forearm, h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_forearm_tau_x = H_star_forearm_tau_x + h_c_forearm_tau_x;
    const ella_real h_V_forearm_tau_y = H_star_forearm_tau_y + h_MD_forearm_tau_y;
    const ella_real h_V_forearm_tau_z = H_star_forearm_tau_z + h_MD_forearm_tau_z;
    const ella_real h_V_forearm_f_x = H_star_forearm_f_x + h_c_forearm_f_x;
    const ella_real h_V_forearm_f_y = H_star_forearm_f_y - minus_h_c_forearm_f_y;
    const ella_real h_V_forearm_f_z = H_star_forearm_f_z + h_c_forearm_f_z;

    /* forearm, h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real t69 = L_forearm_z1 * Omega_forearm_yz - L_forearm_y1 * minus_Omega_forearm_yy
        + Omega_forearm_yx * c->links[1].chi_1;
    const ella_real h_eta_forearm_1 = t69 + acc_0_forearm_a_y * c->links[1].sigma_y1
        - Ldot_forearm_z1 * 2 * omega_R_forearm_x;
    const ella_real t70 = L_forearm_z2 * Omega_forearm_yz - L_forearm_y2 * minus_Omega_forearm_yy
        + Omega_forearm_yx * c->links[1].chi_2;
    const ella_real h_eta_forearm_2 = t70 + acc_0_forearm_a_y * c->links[1].sigma_y2
        - Ldot_forearm_z2 * 2 * omega_R_forearm_x;
    const ella_real t71 = L_forearm_z3 * Omega_forearm_yz - L_forearm_y3 * minus_Omega_forearm_yy
        + Omega_forearm_yx * c->links[1].chi_3;
    const ella_real h_eta_forearm_3 = t71 + acc_0_forearm_a_y * c->links[1].sigma_y3
        - Ldot_forearm_z3 * 2 * omega_R_forearm_x;
    const ella_real t72 = L_forearm_y1 * Omega_forearm_zy - L_forearm_z1 * minus_Omega_forearm_zz
        + Omega_forearm_zx * c->links[1].chi_1;
    const ella_real h_eta_forearm_4 = t72 + acc_0_forearm_a_z * c->links[1].sigma_y1
        + Ldot_forearm_y1 * 2 * omega_R_forearm_x;
    const ella_real t73 = L_forearm_y2 * Omega_forearm_zy - L_forearm_z2 * minus_Omega_forearm_zz
        + Omega_forearm_zx * c->links[1].chi_2;
    const ella_real h_eta_forearm_5 = t73 + acc_0_forearm_a_z * c->links[1].sigma_y2
        + Ldot_forearm_y2 * 2 * omega_R_forearm_x;
    const ella_real t74 = L_forearm_y3 * Omega_forearm_zy - L_forearm_z3 * minus_Omega_forearm_zz
        + Omega_forearm_zx * c->links[1].chi_3;
    const ella_real h_eta_forearm_6 = t74 + acc_0_forearm_a_z * c->links[1].sigma_y3
        + Ldot_forearm_y3 * 2 * omega_R_forearm_x;
    const ella_real h_eta_forearm_7 = alpha_forearm_x * c->links[1].sigma_t_7;

    /* forearm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real minus_p_T_forearm_tau_x = R_T_forearm_xx * input->w_ext[1][0]
        + R_T_forearm_xy * input->w_ext[1][1] + R_T_forearm_xz * input->w_ext[1][2];
    const ella_real minus_p_T_forearm_tau_y = R_T_forearm_yx * input->w_ext[1][0]
        + R_T_forearm_yy * input->w_ext[1][1] + R_T_forearm_yz * input->w_ext[1][2];
    const ella_real minus_p_T_forearm_tau_z = R_T_forearm_zx * input->w_ext[1][0]
        + R_T_forearm_zy * input->w_ext[1][1] + R_T_forearm_zz * input->w_ext[1][2];
    const ella_real t75 = R_T_forearm_xx * input->w_ext[1][3] + R_T_forearm_xy * input->w_ext[1][4]
        + R_T_forearm_xz * input->w_ext[1][5];
    const ella_real t76 = R_T_forearm_yx * input->w_ext[1][3] + R_T_forearm_yy * input->w_ext[1][4]
        + R_T_forearm_yz * input->w_ext[1][5];
    const ella_real t77 = R_T_forearm_zx * input->w_ext[1][3] + R_T_forearm_zy * input->w_ext[1][4]
        + R_T_forearm_zz * input->w_ext[1][5];
    const ella_real p_T_forearm_f_x = c->links[1].body0_mass * a_t_forearm_x - t75;
    const ella_real p_T_forearm_f_y = c->links[1].body0_mass * a_t_forearm_y - t76;
    const ella_real p_T_forearm_f_z = c->links[1].body0_mass * a_t_forearm_z - t77;

    /* forearm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real Theta_forearm_11 = J_l_forearm_xz * c->links[1].Psi_c_z1;
    const ella_real Theta_forearm_12 = J_l_forearm_xz * c->links[1].Psi_c_z2;
    const ella_real Theta_forearm_13 = J_l_forearm_xz * c->links[1].Psi_c_z3;
    const ella_real Theta_forearm_14 = J_l_forearm_xy * c->links[1].Psi_c_y4;
    const ella_real Theta_forearm_15 = J_l_forearm_xy * c->links[1].Psi_c_y5;
    const ella_real Theta_forearm_16 = J_l_forearm_xy * c->links[1].Psi_c_y6;
    const ella_real Theta_forearm_17 = J_l_forearm_xx * ELLA_REAL(1.7320508075688772);
    const ella_real Theta_forearm_21 = J_l_forearm_yz * c->links[1].Psi_c_z1;
    const ella_real Theta_forearm_22 = J_l_forearm_yz * c->links[1].Psi_c_z2;
    const ella_real Theta_forearm_23 = J_l_forearm_yz * c->links[1].Psi_c_z3;
    const ella_real Theta_forearm_24 = J_l_forearm_yy * c->links[1].Psi_c_y4;
    const ella_real Theta_forearm_25 = J_l_forearm_yy * c->links[1].Psi_c_y5;
    const ella_real Theta_forearm_26 = J_l_forearm_yy * c->links[1].Psi_c_y6;
    const ella_real Theta_forearm_27 = J_l_forearm_yx * ELLA_REAL(1.7320508075688772);
    const ella_real Theta_forearm_31 = J_l_forearm_zz * c->links[1].Psi_c_z1;
    const ella_real Theta_forearm_32 = J_l_forearm_zz * c->links[1].Psi_c_z2;
    const ella_real Theta_forearm_33 = J_l_forearm_zz * c->links[1].Psi_c_z3;
    const ella_real Theta_forearm_34 = J_l_forearm_zy * c->links[1].Psi_c_y4;
    const ella_real Theta_forearm_35 = J_l_forearm_zy * c->links[1].Psi_c_y5;
    const ella_real Theta_forearm_36 = J_l_forearm_zy * c->links[1].Psi_c_y6;
    const ella_real Theta_forearm_37 = J_l_forearm_zx * ELLA_REAL(1.7320508075688772);
    const ella_real t78 = r_T_forearm_z * c->links[1].body0_mass;
    const ella_real t79 = r_T_forearm_y * c->links[1].body0_mass;
    const ella_real t80 = c->links[1].length * c->links[1].body0_mass;
    const ella_real t81 = r_T_forearm_z * t78;
    const ella_real t82 = r_T_forearm_y * t79;
    const ella_real t83 = c->links[1].length * t80;
    const ella_real M_loaded_forearm_11 = I_forearm_xx + (t82 + t81);
    const ella_real minus_M_loaded_forearm_12 = r_T_forearm_y * t80 + J_forearm_xy;
    const ella_real minus_M_loaded_forearm_13 = r_T_forearm_z * t80 + J_forearm_xz;
    const ella_real M_loaded_forearm_24 = t78 + S_forearm_z;
    const ella_real M_loaded_forearm_16 = S_forearm_y + t79;
    const ella_real M_loaded_forearm_22 = I_forearm_yy + (t81 + t83);
    const ella_real minus_M_loaded_forearm_23 = r_T_forearm_z * t79 + J_forearm_yz;
    const ella_real M_loaded_forearm_35 = t80 + c->links[1].S_0_x;
    const ella_real M_loaded_forearm_33 = I_forearm_zz + (t83 + t82);
    const ella_real M_loaded_forearm_44 = c->links[1].mu + c->links[1].body0_mass;
    const ella_real h_loaded_forearm_tau_x = h_V_forearm_tau_x
        + (r_T_forearm_y * p_T_forearm_f_z - r_T_forearm_z * p_T_forearm_f_y - minus_p_T_forearm_tau_x);
    const ella_real h_loaded_forearm_tau_y = h_V_forearm_tau_y
        + (r_T_forearm_z * p_T_forearm_f_x - c->links[1].length * p_T_forearm_f_z - minus_p_T_forearm_tau_y);
    const ella_real h_loaded_forearm_tau_z = h_V_forearm_tau_z
        + (c->links[1].length * p_T_forearm_f_y - r_T_forearm_y * p_T_forearm_f_x - minus_p_T_forearm_tau_z);
    const ella_real h_loaded_forearm_f_x = h_V_forearm_f_x + p_T_forearm_f_x;
    const ella_real h_loaded_forearm_f_y = h_V_forearm_f_y + p_T_forearm_f_y;
    const ella_real h_loaded_forearm_f_z = h_V_forearm_f_z + p_T_forearm_f_z;
    const ella_real t84 = c->links[1].body0_mass * ELLA_REAL(2.0011941703010714);
    const ella_real t85 = c->links[1].body0_mass * ELLA_REAL(2.0700807911885764);
    const ella_real t86 = c->links[1].body0_mass * ELLA_REAL(3.5651069283690613);
    const ella_real minus_C_forearm_11 = r_T_forearm_z * t84 + L_forearm_z1;
    const ella_real minus_C_forearm_12 = r_T_forearm_z * t85 + L_forearm_z2;
    const ella_real minus_C_forearm_13 = r_T_forearm_z * t86 + L_forearm_z3;
    const ella_real C_forearm_14 = L_forearm_y1 + r_T_forearm_y * t84;
    const ella_real C_forearm_15 = L_forearm_y2 + r_T_forearm_y * t85;
    const ella_real C_forearm_16 = L_forearm_y3 + r_T_forearm_y * t86;
    const ella_real C_forearm_31 = c->links[1].length * t84 + c->links[1].chi_1;
    const ella_real C_forearm_32 = c->links[1].length * t85 + c->links[1].chi_2;
    const ella_real C_forearm_33 = c->links[1].length * t86 + c->links[1].chi_3;
    const ella_real C_forearm_51 = c->links[1].sigma_y1 + t84;
    const ella_real C_forearm_52 = c->links[1].sigma_y2 + t85;
    const ella_real C_forearm_53 = c->links[1].sigma_y3 + t86;
    const ella_real t87 = c->links[1].body0_mass * ELLA_REAL(4.0047781072469935);
    const ella_real modal_inertia_forearm_11 = t87 + m_eta[7];
    bad |= (unsigned long)(!(modal_inertia_forearm_11 > 0)) << 1;
    const ella_real modal_inertia_forearm_12 = c->links[1].body0_mass * ELLA_REAL(4.142633611378808);
    const ella_real modal_inertia_forearm_13 = c->links[1].body0_mass * ELLA_REAL(7.134471201552125);
    const ella_real t88 = c->links[1].body0_mass * ELLA_REAL(4.2852344820479225);
    const ella_real modal_inertia_forearm_22 = t88 + m_eta[8];
    const ella_real modal_inertia_forearm_23 = c->links[1].body0_mass * ELLA_REAL(7.380059370950102);
    const ella_real t89 = c->links[1].body0_mass * ELLA_REAL(12.709987410705082);
    const ella_real modal_inertia_forearm_33 = t89 + m_eta[9];
    const ella_real modal_inertia_forearm_44 = t87 + m_eta[10];
    bad |= (unsigned long)(!(modal_inertia_forearm_44 > 0)) << 1;
    const ella_real modal_inertia_forearm_55 = t88 + m_eta[11];
    const ella_real modal_inertia_forearm_66 = t89 + m_eta[12];
    const ella_real t90 = Theta_forearm_11 * minus_p_T_forearm_tau_x + Theta_forearm_21 * minus_p_T_forearm_tau_y
        + Theta_forearm_31 * minus_p_T_forearm_tau_z;
    const ella_real t91 = Theta_forearm_12 * minus_p_T_forearm_tau_x + Theta_forearm_22 * minus_p_T_forearm_tau_y
        + Theta_forearm_32 * minus_p_T_forearm_tau_z;
    const ella_real t92 = Theta_forearm_13 * minus_p_T_forearm_tau_x + Theta_forearm_23 * minus_p_T_forearm_tau_y
        + Theta_forearm_33 * minus_p_T_forearm_tau_z;
    const ella_real t93 = Theta_forearm_14 * minus_p_T_forearm_tau_x + Theta_forearm_24 * minus_p_T_forearm_tau_y
        + Theta_forearm_34 * minus_p_T_forearm_tau_z;
    const ella_real t94 = Theta_forearm_15 * minus_p_T_forearm_tau_x + Theta_forearm_25 * minus_p_T_forearm_tau_y
        + Theta_forearm_35 * minus_p_T_forearm_tau_z;
    const ella_real t95 = Theta_forearm_16 * minus_p_T_forearm_tau_x + Theta_forearm_26 * minus_p_T_forearm_tau_y
        + Theta_forearm_36 * minus_p_T_forearm_tau_z;
    const ella_real t96 = Theta_forearm_17 * minus_p_T_forearm_tau_x + Theta_forearm_27 * minus_p_T_forearm_tau_y
        + Theta_forearm_37 * minus_p_T_forearm_tau_z;
    const ella_real h_phi_forearm_1 = h_eta_forearm_1 + work->f_eta[7]
        + (p_T_forearm_f_y * ELLA_REAL(2.0011941703010714) - t90);
    const ella_real h_phi_forearm_2 = h_eta_forearm_2 + work->f_eta[8]
        + (p_T_forearm_f_y * ELLA_REAL(2.0700807911885764) - t91);
    const ella_real h_phi_forearm_3 = h_eta_forearm_3 + work->f_eta[9]
        + (p_T_forearm_f_y * ELLA_REAL(3.5651069283690613) - t92);
    const ella_real h_phi_forearm_4 = h_eta_forearm_4 + work->f_eta[10]
        + (p_T_forearm_f_z * ELLA_REAL(2.0011941703010714) - t93);
    const ella_real h_phi_forearm_5 = h_eta_forearm_5 + work->f_eta[11]
        + (p_T_forearm_f_z * ELLA_REAL(2.0700807911885764) - t94);
    const ella_real h_phi_forearm_6 = h_eta_forearm_6 + work->f_eta[12]
        + (p_T_forearm_f_z * ELLA_REAL(3.5651069283690613) - t95);
    const ella_real h_phi_forearm_7 = h_eta_forearm_7 + work->f_eta[13] - t96;
    const ella_real modes_inverse_forearm_1 = 1 / modal_inertia_forearm_11;
    const ella_real modes_L_forearm_21 = modal_inertia_forearm_12 * modes_inverse_forearm_1;
    const ella_real modes_L_forearm_31 = modal_inertia_forearm_13 * modes_inverse_forearm_1;
    const ella_real t97 = modal_inertia_forearm_22 - modal_inertia_forearm_12 * modes_L_forearm_21;
    bad |= (unsigned long)(!(t97 > 0)) << 1;
    const ella_real modes_inverse_forearm_2 = 1 / t97;
    const ella_real t98 = modal_inertia_forearm_23 - modal_inertia_forearm_12 * modes_L_forearm_31;
    const ella_real modes_L_forearm_32 = t98 * modes_inverse_forearm_2;
    const ella_real t99 = modal_inertia_forearm_33
        - (modal_inertia_forearm_13 * modes_L_forearm_31 + t98 * modes_L_forearm_32);
    bad |= (unsigned long)(!(t99 > 0)) << 1;
    const ella_real modes_inverse_forearm_3 = 1 / t99;
    const ella_real modes_inverse_forearm_4 = 1 / modal_inertia_forearm_44;
    const ella_real modes_L_forearm_54 = modal_inertia_forearm_12 * modes_inverse_forearm_4;
    const ella_real modes_L_forearm_64 = modal_inertia_forearm_13 * modes_inverse_forearm_4;
    const ella_real t100 = modal_inertia_forearm_55 - modal_inertia_forearm_12 * modes_L_forearm_54;
    bad |= (unsigned long)(!(t100 > 0)) << 1;
    const ella_real modes_inverse_forearm_5 = 1 / t100;
    const ella_real t101 = modal_inertia_forearm_23 - modal_inertia_forearm_12 * modes_L_forearm_64;
    const ella_real modes_L_forearm_65 = t101 * modes_inverse_forearm_5;
    const ella_real t102 = modal_inertia_forearm_66
        - (modal_inertia_forearm_13 * modes_L_forearm_64 + t101 * modes_L_forearm_65);
    bad |= (unsigned long)(!(t102 > 0)) << 1;
    const ella_real modes_inverse_forearm_6 = 1 / t102;
    const ella_real modes_inverse_forearm_7 = 1 / m_eta[13];
    const ella_real t103 = modes_L_forearm_21 * minus_C_forearm_11 - minus_C_forearm_12;
    const ella_real t104 = C_forearm_32 - modes_L_forearm_21 * C_forearm_31;
    const ella_real t105 = C_forearm_52 - modes_L_forearm_21 * C_forearm_51;
    const ella_real t106 = modes_L_forearm_31 * minus_C_forearm_11 - minus_C_forearm_13 - modes_L_forearm_32 * t103;
    const ella_real t107 = C_forearm_33 - modes_L_forearm_31 * C_forearm_31 - modes_L_forearm_32 * t104;
    const ella_real t108 = C_forearm_53 - modes_L_forearm_31 * C_forearm_51 - modes_L_forearm_32 * t105;
    const ella_real t109 = C_forearm_15 - modes_L_forearm_54 * C_forearm_14;
    const ella_real t110 = modes_L_forearm_54 * C_forearm_31 - C_forearm_32;
    const ella_real t111 = C_forearm_52 - modes_L_forearm_54 * C_forearm_51;
    const ella_real t112 = C_forearm_16 - modes_L_forearm_64 * C_forearm_14 - modes_L_forearm_65 * t109;
    const ella_real t113 = modes_L_forearm_64 * C_forearm_31 - C_forearm_33 - modes_L_forearm_65 * t110;
    const ella_real t114 = C_forearm_53 - modes_L_forearm_64 * C_forearm_51 - modes_L_forearm_65 * t111;
    const ella_real t115 = h_phi_forearm_2 - modes_L_forearm_21 * h_phi_forearm_1;
    const ella_real t116 = h_phi_forearm_3 - modes_L_forearm_31 * h_phi_forearm_1 - modes_L_forearm_32 * t115;
    const ella_real t117 = h_phi_forearm_5 - modes_L_forearm_54 * h_phi_forearm_4;
    const ella_real t118 = h_phi_forearm_6 - modes_L_forearm_64 * h_phi_forearm_4 - modes_L_forearm_65 * t117;
    const ella_real minus_modes_W_forearm_11 = minus_C_forearm_11 * modes_inverse_forearm_1;
    const ella_real modes_W_forearm_13 = C_forearm_31 * modes_inverse_forearm_1;
    const ella_real modes_W_forearm_15 = C_forearm_51 * modes_inverse_forearm_1;
    const ella_real modes_W_forearm_21 = t103 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_23 = t104 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_25 = t105 * modes_inverse_forearm_2;
    const ella_real modes_W_forearm_31 = t106 * modes_inverse_forearm_3;
    const ella_real modes_W_forearm_33 = t107 * modes_inverse_forearm_3;
    const ella_real modes_W_forearm_35 = t108 * modes_inverse_forearm_3;
    const ella_real modes_W_forearm_41 = C_forearm_14 * modes_inverse_forearm_4;
    const ella_real minus_modes_W_forearm_42 = C_forearm_31 * modes_inverse_forearm_4;
    const ella_real modes_W_forearm_46 = C_forearm_51 * modes_inverse_forearm_4;
    const ella_real modes_W_forearm_51 = t109 * modes_inverse_forearm_5;
    const ella_real modes_W_forearm_52 = t110 * modes_inverse_forearm_5;
    const ella_real modes_W_forearm_56 = t111 * modes_inverse_forearm_5;
    const ella_real modes_W_forearm_61 = t112 * modes_inverse_forearm_6;
    const ella_real modes_W_forearm_62 = t113 * modes_inverse_forearm_6;
    const ella_real modes_W_forearm_66 = t114 * modes_inverse_forearm_6;
    const ella_real modes_W_forearm_71 = c->links[1].sigma_t_7 * modes_inverse_forearm_7;
    const ella_real modes_w_forearm_1 = h_phi_forearm_1 * modes_inverse_forearm_1;
    const ella_real modes_w_forearm_2 = t115 * modes_inverse_forearm_2;
    const ella_real modes_w_forearm_3 = t116 * modes_inverse_forearm_3;
    const ella_real modes_w_forearm_4 = h_phi_forearm_4 * modes_inverse_forearm_4;
    const ella_real modes_w_forearm_5 = t117 * modes_inverse_forearm_5;
    const ella_real modes_w_forearm_6 = t118 * modes_inverse_forearm_6;
    const ella_real modes_w_forearm_7 = h_phi_forearm_7 * modes_inverse_forearm_7;
    const ella_real t119 = minus_C_forearm_11 * minus_modes_W_forearm_11 + t103 * modes_W_forearm_21
        + t106 * modes_W_forearm_31;
    const ella_real t120 = t119 + C_forearm_14 * modes_W_forearm_41 + t109 * modes_W_forearm_51
        + t112 * modes_W_forearm_61 + c->links[1].sigma_t_7 * modes_W_forearm_71;
    const ella_real M_i_forearm_11 = M_loaded_forearm_11 - t120;
    const ella_real M_i_forearm_12 = C_forearm_14 * minus_modes_W_forearm_42 - t109 * modes_W_forearm_52
        - t112 * modes_W_forearm_62 - minus_M_loaded_forearm_12;
    const ella_real minus_M_i_forearm_13 = minus_M_loaded_forearm_13
        + (t103 * modes_W_forearm_23 - minus_C_forearm_11 * modes_W_forearm_13 + t106 * modes_W_forearm_33);
    const ella_real M_i_forearm_15 = minus_C_forearm_11 * modes_W_forearm_15 - t103 * modes_W_forearm_25
        - t106 * modes_W_forearm_35 - M_loaded_forearm_24;
    const ella_real M_i_forearm_16 = M_loaded_forearm_16
        - (C_forearm_14 * modes_W_forearm_46 + t109 * modes_W_forearm_56 + t112 * modes_W_forearm_66);
    const ella_real M_i_forearm_22 = M_loaded_forearm_22
        - (C_forearm_31 * minus_modes_W_forearm_42 + t110 * modes_W_forearm_52 + t113 * modes_W_forearm_62);
    const ella_real M_i_forearm_26 = C_forearm_31 * modes_W_forearm_46 - t110 * modes_W_forearm_56
        - t113 * modes_W_forearm_66 - M_loaded_forearm_35;
    const ella_real M_i_forearm_33 = M_loaded_forearm_33
        - (C_forearm_31 * modes_W_forearm_13 + t104 * modes_W_forearm_23 + t107 * modes_W_forearm_33);
    const ella_real M_i_forearm_35 = M_loaded_forearm_35
        - (C_forearm_31 * modes_W_forearm_15 + t104 * modes_W_forearm_25 + t107 * modes_W_forearm_35);
    const ella_real M_i_forearm_55 = M_loaded_forearm_44
        - (C_forearm_51 * modes_W_forearm_15 + t105 * modes_W_forearm_25 + t108 * modes_W_forearm_35);
    const ella_real M_i_forearm_66 = M_loaded_forearm_44
        - (C_forearm_51 * modes_W_forearm_46 + t111 * modes_W_forearm_56 + t114 * modes_W_forearm_66);
    const ella_real t121 = modes_W_forearm_21 * t115 - minus_modes_W_forearm_11 * h_phi_forearm_1
        + modes_W_forearm_31 * t116;
    const ella_real t122 = t121 + modes_W_forearm_41 * h_phi_forearm_4 + modes_W_forearm_51 * t117
        + modes_W_forearm_61 * t118;
    const ella_real t123 = modes_W_forearm_52 * t117 - minus_modes_W_forearm_42 * h_phi_forearm_4
        + modes_W_forearm_62 * t118;
    const ella_real h_i_forearm_tau_x = h_loaded_forearm_tau_x - (t122 + modes_W_forearm_71 * h_phi_forearm_7);
    const ella_real h_i_forearm_tau_y = h_loaded_forearm_tau_y - t123;
    const ella_real h_i_forearm_tau_z = h_loaded_forearm_tau_z
        - (modes_W_forearm_13 * h_phi_forearm_1 + modes_W_forearm_23 * t115 + modes_W_forearm_33 * t116);
    const ella_real h_i_forearm_f_y = h_loaded_forearm_f_y
        - (modes_W_forearm_15 * h_phi_forearm_1 + modes_W_forearm_25 * t115 + modes_W_forearm_35 * t116);
    const ella_real h_i_forearm_f_z = h_loaded_forearm_f_z
        - (modes_W_forearm_46 * h_phi_forearm_4 + modes_W_forearm_56 * t117 + modes_W_forearm_66 * t118);

    /* forearm, joint: its accelerations eliminated from its rows (43) */
    const ella_real t124 = ELLA_REAL_EPSILON * 8;
    bad |= (unsigned long)(!(M_i_forearm_33 - t124 * (M_i_forearm_11 + M_i_forearm_22 + M_i_forearm_33) > 0)) << 1;
    const ella_real joint_inverse_forearm_1 = 1 / M_i_forearm_33;
    const ella_real minus_joint_W_forearm_11 = minus_M_i_forearm_13 * joint_inverse_forearm_1;
    const ella_real minus_joint_W_forearm_12 = minus_M_loaded_forearm_23 * joint_inverse_forearm_1;
    const ella_real minus_joint_W_forearm_14 = M_loaded_forearm_16 * joint_inverse_forearm_1;
    const ella_real joint_W_forearm_15 = M_i_forearm_35 * joint_inverse_forearm_1;
    const ella_real joint_w_forearm_1 = (input->tau[2] - h_i_forearm_tau_z) * joint_inverse_forearm_1;
    const ella_real Lambda_i_forearm_11 = M_i_forearm_11 - minus_M_i_forearm_13 * minus_joint_W_forearm_11;
    const ella_real Lambda_i_forearm_12 = M_i_forearm_12 - minus_M_i_forearm_13 * minus_joint_W_forearm_12;
    const ella_real minus_Lambda_i_forearm_14 = minus_M_i_forearm_13 * minus_joint_W_forearm_14;
    const ella_real Lambda_i_forearm_15 = minus_M_i_forearm_13 * joint_W_forearm_15 + M_i_forearm_15;
    const ella_real Lambda_i_forearm_22 = M_i_forearm_22 - minus_M_loaded_forearm_23 * minus_joint_W_forearm_12;
    const ella_real Lambda_i_forearm_24 = M_loaded_forearm_24 - minus_M_loaded_forearm_23 * minus_joint_W_forearm_14;
    const ella_real Lambda_i_forearm_25 = minus_M_loaded_forearm_23 * joint_W_forearm_15;
    const ella_real Lambda_i_forearm_44 = M_loaded_forearm_44 - M_loaded_forearm_16 * minus_joint_W_forearm_14;
    const ella_real Lambda_i_forearm_45 = M_loaded_forearm_16 * joint_W_forearm_15;
    const ella_real Lambda_i_forearm_55 = M_i_forearm_55 - M_i_forearm_35 * joint_W_forearm_15;
    const ella_real p_i_forearm_tau_x = h_i_forearm_tau_x - minus_M_i_forearm_13 * joint_w_forearm_1;
    const ella_real p_i_forearm_tau_y = h_i_forearm_tau_y - minus_M_loaded_forearm_23 * joint_w_forearm_1;
    const ella_real p_i_forearm_f_x = h_loaded_forearm_f_x - M_loaded_forearm_16 * joint_w_forearm_1;
    const ella_real p_i_forearm_f_y = h_i_forearm_f_y + M_i_forearm_35 * joint_w_forearm_1;

    /* forearm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const ella_real t125 = Lambda_i_forearm_11 * R_P_forearm_yx + Lambda_i_forearm_12 * R_P_forearm_yy;
    const ella_real t126 = Lambda_i_forearm_11 * R_P_forearm_zx + Lambda_i_forearm_12 * R_P_forearm_zy;
    const ella_real t127 = Lambda_i_forearm_22 * R_P_forearm_yy + Lambda_i_forearm_12 * R_P_forearm_yx;
    const ella_real t128 = Lambda_i_forearm_22 * R_P_forearm_zy + Lambda_i_forearm_12 * R_P_forearm_zx;
    const ella_real Lambda_forearm_1 = R_P_forearm_xx
        * (Lambda_i_forearm_11 * R_P_forearm_xx + Lambda_i_forearm_12 * R_P_forearm_xy)
        + R_P_forearm_xy * (Lambda_i_forearm_22 * R_P_forearm_xy + Lambda_i_forearm_12 * R_P_forearm_xx);
    const ella_real Lambda_forearm_2 = R_P_forearm_xx * t125 + R_P_forearm_xy * t127;
    const ella_real Lambda_forearm_3 = R_P_forearm_xx * t126 + R_P_forearm_xy * t128;
    const ella_real Lambda_forearm_7 = R_P_forearm_yx * t125 + R_P_forearm_yy * t127;
    const ella_real Lambda_forearm_8 = R_P_forearm_yx * t126 + R_P_forearm_yy * t128;
    const ella_real Lambda_forearm_12 = R_P_forearm_zx * t126 + R_P_forearm_zy * t128;
    const ella_real t129 = Lambda_i_forearm_15 * R_P_forearm_xy - minus_Lambda_i_forearm_14 * R_P_forearm_xx
        + M_i_forearm_16 * R_T_upper_arm_xz;
    const ella_real t130 = Lambda_i_forearm_15 * R_P_forearm_yy - minus_Lambda_i_forearm_14 * R_P_forearm_yx
        + M_i_forearm_16 * R_T_upper_arm_yz;
    const ella_real t131 = Lambda_i_forearm_15 * R_P_forearm_zy - minus_Lambda_i_forearm_14 * R_P_forearm_zx
        + M_i_forearm_16 * R_T_upper_arm_zz;
    const ella_real t132 = Lambda_i_forearm_24 * R_P_forearm_xx + Lambda_i_forearm_25 * R_P_forearm_xy
        + M_i_forearm_26 * R_T_upper_arm_xz;
    const ella_real t133 = Lambda_i_forearm_24 * R_P_forearm_yx + Lambda_i_forearm_25 * R_P_forearm_yy
        + M_i_forearm_26 * R_T_upper_arm_yz;
    const ella_real t134 = Lambda_i_forearm_24 * R_P_forearm_zx + Lambda_i_forearm_25 * R_P_forearm_zy
        + M_i_forearm_26 * R_T_upper_arm_zz;
    const ella_real Lambda_forearm_4 = R_P_forearm_xx * t129 + R_P_forearm_xy * t132;
    const ella_real Lambda_forearm_5 = R_P_forearm_xx * t130 + R_P_forearm_xy * t133;
    const ella_real Lambda_forearm_6 = R_P_forearm_xx * t131 + R_P_forearm_xy * t134;
    const ella_real Lambda_forearm_9 = R_P_forearm_yx * t129 + R_P_forearm_yy * t132;
    const ella_real Lambda_forearm_10 = R_P_forearm_yx * t130 + R_P_forearm_yy * t133;
    const ella_real Lambda_forearm_11 = R_P_forearm_yx * t131 + R_P_forearm_yy * t134;
    const ella_real Lambda_forearm_13 = R_P_forearm_zx * t129 + R_P_forearm_zy * t132;
    const ella_real Lambda_forearm_14 = R_P_forearm_zx * t130 + R_P_forearm_zy * t133;
    const ella_real Lambda_forearm_15 = R_P_forearm_zx * t131 + R_P_forearm_zy * t134;
    const ella_real t135 = (Lambda_i_forearm_44 - M_i_forearm_66) * ELLA_REAL(0.5);
    const ella_real t136 = t135 * R_P_forearm_xx + Lambda_i_forearm_45 * R_P_forearm_xy;
    const ella_real t137 = t135 * R_P_forearm_yx + Lambda_i_forearm_45 * R_P_forearm_yy;
    const ella_real t138 = t135 * R_P_forearm_zx + Lambda_i_forearm_45 * R_P_forearm_zy;
    const ella_real t139 = (Lambda_i_forearm_55 - M_i_forearm_66) * ELLA_REAL(0.5);
    const ella_real t140 = t139 * R_P_forearm_xy;
    const ella_real t141 = t139 * R_P_forearm_yy;
    const ella_real t142 = t139 * R_P_forearm_zy;
    const ella_real Lambda_forearm_16 = (R_P_forearm_xx * t136 + R_P_forearm_xy * t140) * 2 + M_i_forearm_66;
    const ella_real Lambda_forearm_17 = R_P_forearm_xx * t137 + R_P_forearm_xy * t141
        + (R_P_forearm_yx * t136 + R_P_forearm_yy * t140);
    const ella_real Lambda_forearm_18 = R_P_forearm_xx * t138 + R_P_forearm_xy * t142
        + (R_P_forearm_zx * t136 + R_P_forearm_zy * t140);
    const ella_real Lambda_forearm_19 = (R_P_forearm_yx * t137 + R_P_forearm_yy * t141) * 2 + M_i_forearm_66;
    const ella_real Lambda_forearm_20 = R_P_forearm_yx * t138 + R_P_forearm_yy * t142
        + (R_P_forearm_zx * t137 + R_P_forearm_zy * t141);
    const ella_real Lambda_forearm_21 = (R_P_forearm_zx * t138 + R_P_forearm_zy * t142) * 2 + M_i_forearm_66;
    const ella_real p_forearm_tau_x = R_P_forearm_xx * p_i_forearm_tau_x + R_P_forearm_xy * p_i_forearm_tau_y
        + R_T_upper_arm_xz * input->tau[2];
    const ella_real p_forearm_tau_y = R_P_forearm_yx * p_i_forearm_tau_x + R_P_forearm_yy * p_i_forearm_tau_y
        + R_T_upper_arm_yz * input->tau[2];
    const ella_real p_forearm_tau_z = R_P_forearm_zx * p_i_forearm_tau_x + R_P_forearm_zy * p_i_forearm_tau_y
        + R_T_upper_arm_zz * input->tau[2];
    const ella_real p_forearm_f_x = R_P_forearm_xx * p_i_forearm_f_x + R_P_forearm_xy * p_i_forearm_f_y
        + R_T_upper_arm_xz * h_i_forearm_f_z;
    const ella_real p_forearm_f_y = R_P_forearm_yx * p_i_forearm_f_x + R_P_forearm_yy * p_i_forearm_f_y
        + R_T_upper_arm_yz * h_i_forearm_f_z;
    const ella_real p_forearm_f_z = R_P_forearm_zx * p_i_forearm_f_x + R_P_forearm_zy * p_i_forearm_f_y
        + R_T_upper_arm_zz * h_i_forearm_f_z;

    /* upper_arm, S: first moment */
    const ella_real S_upper_arm_y = state->q[3] * c->links[0].sigma_y1 + state->q[4] * c->links[0].sigma_y2
        + state->q[5] * c->links[0].sigma_y3;
    const ella_real S_upper_arm_z = state->q[6] * c->links[0].sigma_y1 + state->q[7] * c->links[0].sigma_y2
        + state->q[8] * c->links[0].sigma_y3;

    /* upper_arm, L: first moment weighted by each mode shape (85) */
    const ella_real L_upper_arm_y1 = c->links[0].mu * state->q[3];
    const ella_real L_upper_arm_y2 = c->links[0].mu * state->q[4];
    const ella_real L_upper_arm_y3 = c->links[0].mu * state->q[5];
    const ella_real L_upper_arm_z1 = state->q[6] * c->links[0].mu;
    const ella_real L_upper_arm_z2 = state->q[7] * c->links[0].mu;
    const ella_real L_upper_arm_z3 = state->q[8] * c->links[0].mu;

    /* upper_arm, Ldot: rate of L */
    const ella_real Ldot_upper_arm_y1 = c->links[0].mu * state->v[3];
    const ella_real Ldot_upper_arm_y2 = c->links[0].mu * state->v[4];
    const ella_real Ldot_upper_arm_y3 = c->links[0].mu * state->v[5];
    const ella_real Ldot_upper_arm_z1 = state->v[6] * c->links[0].mu;
    const ella_real Ldot_upper_arm_z2 = state->v[7] * c->links[0].mu;
    const ella_real Ldot_upper_arm_z3 = state->v[8] * c->links[0].mu;

    /* upper_arm, J: second moment */
    const ella_real J_upper_arm_xy = c->links[0].chi_1 * state->q[3] + c->links[0].chi_2 * state->q[4]
        + c->links[0].chi_3 * state->q[5];
    const ella_real J_upper_arm_xz = c->links[0].chi_1 * state->q[6] + c->links[0].chi_2 * state->q[7]
        + c->links[0].chi_3 * state->q[8];
    const ella_real J_upper_arm_yy = L_upper_arm_y1 * state->q[3] + L_upper_arm_y2 * state->q[4]
        + L_upper_arm_y3 * state->q[5];
    const ella_real J_upper_arm_yz = L_upper_arm_z1 * state->q[3] + L_upper_arm_z2 * state->q[4]
        + L_upper_arm_z3 * state->q[5];
    const ella_real J_upper_arm_zz = L_upper_arm_z1 * state->q[6] + L_upper_arm_z2 * state->q[7]
        + L_upper_arm_z3 * state->q[8];

    /* upper_arm, I: inertia about the origin, deformed */
    const ella_real I_upper_arm_xx = c->links[0].I_s + J_upper_arm_yy + J_upper_arm_zz;
    const ella_real I_upper_arm_yy = c->links[0].J_0_xx + J_upper_arm_zz;
    const ella_real I_upper_arm_zz = c->links[0].J_0_xx + J_upper_arm_yy;

    /* upper_arm, Omega: acceleration of a place by the link's turning */
    const ella_real t143 = omega_J_upper_arm_y * omega_J_upper_arm_y;
    const ella_real t144 = state->v[1] * state->v[1];
    const ella_real minus_Omega_upper_arm_xx = t143 + t144;
    const ella_real Omega_upper_arm_xy = omega_J_upper_arm_x * omega_J_upper_arm_y;
    const ella_real t145 = omega_J_upper_arm_x * state->v[1];
    const ella_real Omega_upper_arm_xz = t145 - minus_alpha_upper_arm_y;
    const ella_real t146 = omega_J_upper_arm_x * omega_J_upper_arm_x;
    const ella_real minus_Omega_upper_arm_yy = t146 + t144;
    const ella_real t147 = omega_J_upper_arm_y * state->v[1];
    const ella_real Omega_upper_arm_yz = t147 - alpha_upper_arm_x;
    const ella_real Omega_upper_arm_zx = t145 + minus_alpha_upper_arm_y;
    const ella_real Omega_upper_arm_zy = alpha_upper_arm_x + t147;
    const ella_real minus_Omega_upper_arm_zz = t146 + t143;

    /* upper_arm, B: moment of the elastic velocity */
    const ella_real B_upper_arm_yx = c->links[0].chi_1 * state->v[3] + c->links[0].chi_2 * state->v[4]
        + c->links[0].chi_3 * state->v[5];
    const ella_real B_upper_arm_yy = L_upper_arm_y1 * state->v[3] + L_upper_arm_y2 * state->v[4]
        + L_upper_arm_y3 * state->v[5];
    const ella_real B_upper_arm_yz = L_upper_arm_z1 * state->v[3] + L_upper_arm_z2 * state->v[4]
        + L_upper_arm_z3 * state->v[5];
    const ella_real B_upper_arm_zx = c->links[0].chi_1 * state->v[6] + c->links[0].chi_2 * state->v[7]
        + c->links[0].chi_3 * state->v[8];
    const ella_real B_upper_arm_zy = L_upper_arm_y1 * state->v[6] + L_upper_arm_y2 * state->v[7]
        + L_upper_arm_y3 * state->v[8];
    const ella_real B_upper_arm_zz = L_upper_arm_z1 * state->v[6] + L_upper_arm_z2 * state->v[7]
        + L_upper_arm_z3 * state->v[8];

    /* upper_arm, h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const ella_real h_c_upper_arm_tau_x = B_upper_arm_yy * omega_J_upper_arm_x + B_upper_arm_zz * omega_J_upper_arm_x;
    const ella_real h_c_upper_arm_tau_y = B_upper_arm_zz * omega_J_upper_arm_y - B_upper_arm_yx * omega_J_upper_arm_x
        - B_upper_arm_yz * state->v[1];
    const ella_real h_c_upper_arm_tau_z = B_upper_arm_yy * state->v[1] - B_upper_arm_zx * omega_J_upper_arm_x
        - B_upper_arm_zy * omega_J_upper_arm_y;

    /* upper_arm, h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const ella_real h_MD_upper_arm_tau_y = h_c_upper_arm_tau_y + state->v[9] * state->v[1] * c->links[0].sigma_t_7;
    const ella_real h_MD_upper_arm_tau_z = h_c_upper_arm_tau_z
        - state->v[9] * omega_J_upper_arm_y * c->links[0].sigma_t_7;

    /* upper_arm, H_star: gyroscopic wrench and weight, angular acceleration included */
    const ella_real t148 = h_c_upper_arm_tau_x + c->links[0].I_s * alpha_upper_arm_x
        + J_upper_arm_xy * Omega_upper_arm_zx + J_upper_arm_yy * Omega_upper_arm_zy;
    const ella_real t149 = t148 + J_upper_arm_yz * (minus_Omega_upper_arm_yy - minus_Omega_upper_arm_zz)
        - S_upper_arm_y * minus_acc_0_upper_arm_a_z;
    const ella_real H_star_upper_arm_tau_x = t149 - J_upper_arm_xz * Omega_upper_arm_xy
        - J_upper_arm_zz * Omega_upper_arm_yz - S_upper_arm_z * acc_0_upper_arm_a_y;
    const ella_real t150 = h_c_upper_arm_tau_y
        + J_upper_arm_xz * (minus_Omega_upper_arm_zz - minus_Omega_upper_arm_xx) + J_upper_arm_yz * Omega_upper_arm_xy;
    const ella_real t151 = c->links[0].I_s * omega_J_upper_arm_x;
    const ella_real t152 = t150 + J_upper_arm_zz * Omega_upper_arm_xz + S_upper_arm_z * acc_0_upper_arm_a_x
        + t151 * state->v[1];
    const ella_real H_star_upper_arm_tau_y = t152 - c->links[0].J_0_xx * Omega_upper_arm_zx
        - J_upper_arm_xy * Omega_upper_arm_zy + c->links[0].S_0_x * minus_acc_0_upper_arm_a_z;
    const ella_real t153 = h_c_upper_arm_tau_z + c->links[0].J_0_xx * Omega_upper_arm_xy
        + J_upper_arm_xy * (minus_Omega_upper_arm_xx - minus_Omega_upper_arm_yy);
    const ella_real t154 = t153 + J_upper_arm_xz * Omega_upper_arm_yz + c->links[0].S_0_x * acc_0_upper_arm_a_y
        - J_upper_arm_yy * Omega_upper_arm_xy;
    const ella_real H_star_upper_arm_tau_z = t154 - J_upper_arm_yz * Omega_upper_arm_xz
        - S_upper_arm_y * acc_0_upper_arm_a_x - t151 * omega_J_upper_arm_y;

    /* upper_arm, h_V: bias of the twist rows, angular acceleration included */
    const ella_real h_V_upper_arm_tau_x = H_star_upper_arm_tau_x + h_c_upper_arm_tau_x;
    const ella_real h_V_upper_arm_tau_y = H_star_upper_arm_tau_y + h_MD_upper_arm_tau_y;
    const ella_real h_V_upper_arm_tau_z = H_star_upper_arm_tau_z + h_MD_upper_arm_tau_z;

    /* upper_arm, h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const ella_real t155 = L_upper_arm_z1 * Omega_upper_arm_yz - L_upper_arm_y1 * minus_Omega_upper_arm_yy
        + Omega_upper_arm_xy * c->links[0].chi_1;
    const ella_real h_eta_upper_arm_1 = t155 + acc_0_upper_arm_a_y * c->links[0].sigma_y1
        - Ldot_upper_arm_z1 * 2 * omega_J_upper_arm_x;
    const ella_real t156 = L_upper_arm_z2 * Omega_upper_arm_yz - L_upper_arm_y2 * minus_Omega_upper_arm_yy
        + Omega_upper_arm_xy * c->links[0].chi_2;
    const ella_real h_eta_upper_arm_2 = t156 + acc_0_upper_arm_a_y * c->links[0].sigma_y2
        - Ldot_upper_arm_z2 * 2 * omega_J_upper_arm_x;
    const ella_real t157 = L_upper_arm_z3 * Omega_upper_arm_yz - L_upper_arm_y3 * minus_Omega_upper_arm_yy
        + Omega_upper_arm_xy * c->links[0].chi_3;
    const ella_real h_eta_upper_arm_3 = t157 + acc_0_upper_arm_a_y * c->links[0].sigma_y3
        - Ldot_upper_arm_z3 * 2 * omega_J_upper_arm_x;
    const ella_real t158 = L_upper_arm_y1 * Omega_upper_arm_zy - L_upper_arm_z1 * minus_Omega_upper_arm_zz
        + Omega_upper_arm_zx * c->links[0].chi_1;
    const ella_real h_eta_upper_arm_4 = t158 - minus_acc_0_upper_arm_a_z * c->links[0].sigma_y1
        + Ldot_upper_arm_y1 * 2 * omega_J_upper_arm_x;
    const ella_real t159 = L_upper_arm_y2 * Omega_upper_arm_zy - L_upper_arm_z2 * minus_Omega_upper_arm_zz
        + Omega_upper_arm_zx * c->links[0].chi_2;
    const ella_real h_eta_upper_arm_5 = t159 - minus_acc_0_upper_arm_a_z * c->links[0].sigma_y2
        + Ldot_upper_arm_y2 * 2 * omega_J_upper_arm_x;
    const ella_real t160 = L_upper_arm_y3 * Omega_upper_arm_zy - L_upper_arm_z3 * minus_Omega_upper_arm_zz
        + Omega_upper_arm_zx * c->links[0].chi_3;
    const ella_real h_eta_upper_arm_6 = t160 - minus_acc_0_upper_arm_a_z * c->links[0].sigma_y3
        + Ldot_upper_arm_y3 * 2 * omega_J_upper_arm_x;
    const ella_real h_eta_upper_arm_7 = alpha_upper_arm_x * c->links[0].sigma_t_7;

    /* upper_arm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const ella_real Lambda_T_upper_arm_44 = Lambda_forearm_16 + c->links[0].body0_mass;
    const ella_real Lambda_T_upper_arm_55 = Lambda_forearm_19 + c->links[0].body0_mass;
    const ella_real Lambda_T_upper_arm_66 = Lambda_forearm_21 + c->links[0].body0_mass;
    const ella_real t161 = R_T_upper_arm_xx * input->w_ext[0][0] + R_T_upper_arm_xy * input->w_ext[0][1]
        + R_T_upper_arm_xz * input->w_ext[0][2];
    const ella_real t162 = R_T_upper_arm_yx * input->w_ext[0][0] + R_T_upper_arm_yy * input->w_ext[0][1]
        + R_T_upper_arm_yz * input->w_ext[0][2];
    const ella_real t163 = R_T_upper_arm_zx * input->w_ext[0][0] + R_T_upper_arm_zy * input->w_ext[0][1]
        + R_T_upper_arm_zz * input->w_ext[0][2];
    const ella_real t164 = R_T_upper_arm_xx * input->w_ext[0][3] + R_T_upper_arm_xy * input->w_ext[0][4]
        + R_T_upper_arm_xz * input->w_ext[0][5];
    const ella_real t165 = R_T_upper_arm_yx * input->w_ext[0][3] + R_T_upper_arm_yy * input->w_ext[0][4]
        + R_T_upper_arm_yz * input->w_ext[0][5];
    const ella_real t166 = R_T_upper_arm_zx * input->w_ext[0][3] + R_T_upper_arm_zy * input->w_ext[0][4]
        + R_T_upper_arm_zz * input->w_ext[0][5];
    const ella_real p_T_upper_arm_tau_x = p_forearm_tau_x - t161;
    const ella_real p_T_upper_arm_tau_y = p_forearm_tau_y - t162;
    const ella_real p_T_upper_arm_tau_z = p_forearm_tau_z - t163;
    const ella_real p_T_upper_arm_f_x = p_forearm_f_x + c->links[0].body0_mass * a_t_upper_arm_x - t164;
    const ella_real p_T_upper_arm_f_y = p_forearm_f_y + c->links[0].body0_mass * a_t_upper_arm_y - t165;
    const ella_real p_T_upper_arm_f_z = p_forearm_f_z + c->links[0].body0_mass * a_t_upper_arm_z - t166;

    /* upper_arm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const ella_real Theta_upper_arm_11 = J_l_upper_arm_xz * c->links[0].Psi_c_z1;
    const ella_real Theta_upper_arm_12 = J_l_upper_arm_xz * c->links[0].Psi_c_z2;
    const ella_real Theta_upper_arm_13 = J_l_upper_arm_xz * c->links[0].Psi_c_z3;
    const ella_real Theta_upper_arm_14 = J_l_upper_arm_xy * c->links[0].Psi_c_y4;
    const ella_real Theta_upper_arm_15 = J_l_upper_arm_xy * c->links[0].Psi_c_y5;
    const ella_real Theta_upper_arm_16 = J_l_upper_arm_xy * c->links[0].Psi_c_y6;
    const ella_real Theta_upper_arm_17 = J_l_upper_arm_xx * ELLA_REAL(1.7320508075688772);
    const ella_real Theta_upper_arm_21 = J_l_upper_arm_yz * c->links[0].Psi_c_z1;
    const ella_real Theta_upper_arm_22 = J_l_upper_arm_yz * c->links[0].Psi_c_z2;
    const ella_real Theta_upper_arm_23 = J_l_upper_arm_yz * c->links[0].Psi_c_z3;
    const ella_real Theta_upper_arm_24 = J_l_upper_arm_yy * c->links[0].Psi_c_y4;
    const ella_real Theta_upper_arm_25 = J_l_upper_arm_yy * c->links[0].Psi_c_y5;
    const ella_real Theta_upper_arm_26 = J_l_upper_arm_yy * c->links[0].Psi_c_y6;
    const ella_real Theta_upper_arm_27 = J_l_upper_arm_yx * ELLA_REAL(1.7320508075688772);
    const ella_real Theta_upper_arm_31 = J_l_upper_arm_zz * c->links[0].Psi_c_z1;
    const ella_real Theta_upper_arm_32 = J_l_upper_arm_zz * c->links[0].Psi_c_z2;
    const ella_real Theta_upper_arm_33 = J_l_upper_arm_zz * c->links[0].Psi_c_z3;
    const ella_real Theta_upper_arm_34 = J_l_upper_arm_zy * c->links[0].Psi_c_y4;
    const ella_real Theta_upper_arm_35 = J_l_upper_arm_zy * c->links[0].Psi_c_y5;
    const ella_real Theta_upper_arm_36 = J_l_upper_arm_zy * c->links[0].Psi_c_y6;
    const ella_real Theta_upper_arm_37 = J_l_upper_arm_zx * ELLA_REAL(1.7320508075688772);
    const ella_real t167 = r_T_upper_arm_z * Lambda_forearm_17;
    const ella_real t168 = r_T_upper_arm_y * Lambda_forearm_18;
    const ella_real t169 = c->links[0].length * Lambda_forearm_20;
    const ella_real t170 = Lambda_forearm_5
        + (r_T_upper_arm_y * Lambda_forearm_20 - r_T_upper_arm_z * Lambda_T_upper_arm_55);
    const ella_real t171 = Lambda_forearm_6
        + (r_T_upper_arm_y * Lambda_T_upper_arm_66 - r_T_upper_arm_z * Lambda_forearm_20);
    const ella_real t172 = Lambda_forearm_9
        + (r_T_upper_arm_z * Lambda_T_upper_arm_44 - c->links[0].length * Lambda_forearm_18);
    const ella_real M_loaded_upper_arm_25 = Lambda_forearm_10 + (t167 - t169);
    const ella_real t173 = Lambda_forearm_11
        + (r_T_upper_arm_z * Lambda_forearm_18 - c->links[0].length * Lambda_T_upper_arm_66);
    const ella_real t174 = Lambda_forearm_13
        + (c->links[0].length * Lambda_forearm_17 - r_T_upper_arm_y * Lambda_T_upper_arm_44);
    const ella_real t175 = Lambda_forearm_14
        + (c->links[0].length * Lambda_T_upper_arm_55 - r_T_upper_arm_y * Lambda_forearm_17);
    const ella_real M_loaded_upper_arm_36 = Lambda_forearm_15 + (t169 - t168);
    const ella_real t176 = Lambda_forearm_1
        - (Lambda_forearm_5 * r_T_upper_arm_z - Lambda_forearm_6 * r_T_upper_arm_y)
        + (r_T_upper_arm_y * t171 - r_T_upper_arm_z * t170);
    const ella_real t177 = Lambda_forearm_2
        - (Lambda_forearm_6 * c->links[0].length - Lambda_forearm_4 * r_T_upper_arm_z)
        + (r_T_upper_arm_y * t173 - r_T_upper_arm_z * M_loaded_upper_arm_25);
    const ella_real t178 = Lambda_forearm_3
        - (Lambda_forearm_4 * r_T_upper_arm_y - Lambda_forearm_5 * c->links[0].length)
        + (r_T_upper_arm_y * M_loaded_upper_arm_36 - r_T_upper_arm_z * t175);
    const ella_real t179 = Lambda_forearm_7
        - (Lambda_forearm_11 * c->links[0].length - Lambda_forearm_9 * r_T_upper_arm_z)
        + (r_T_upper_arm_z * t172 - c->links[0].length * t173);
    const ella_real t180 = Lambda_forearm_8
        - (Lambda_forearm_9 * r_T_upper_arm_y - Lambda_forearm_10 * c->links[0].length)
        + (r_T_upper_arm_z * t174 - c->links[0].length * M_loaded_upper_arm_36);
    const ella_real t181 = Lambda_forearm_12
        - (Lambda_forearm_13 * r_T_upper_arm_y - Lambda_forearm_14 * c->links[0].length);
    const ella_real M_loaded_upper_arm_11 = I_upper_arm_xx + t176;
    const ella_real M_loaded_upper_arm_12 = t177 - J_upper_arm_xy;
    const ella_real M_loaded_upper_arm_13 = t178 - J_upper_arm_xz;
    const ella_real M_loaded_upper_arm_22 = I_upper_arm_yy + t179;
    const ella_real M_loaded_upper_arm_23 = t180 - J_upper_arm_yz;
    const ella_real M_loaded_upper_arm_33 = I_upper_arm_zz
        + (t181 + (c->links[0].length * t175 - r_T_upper_arm_y * t174));
    const ella_real t182 = p_T_upper_arm_tau_x
        + (r_T_upper_arm_y * p_T_upper_arm_f_z - r_T_upper_arm_z * p_T_upper_arm_f_y);
    const ella_real t183 = p_T_upper_arm_tau_y
        + (r_T_upper_arm_z * p_T_upper_arm_f_x - c->links[0].length * p_T_upper_arm_f_z);
    const ella_real t184 = p_T_upper_arm_tau_z
        + (c->links[0].length * p_T_upper_arm_f_y - r_T_upper_arm_y * p_T_upper_arm_f_x);
    const ella_real h_loaded_upper_arm_tau_x = h_V_upper_arm_tau_x + t182;
    const ella_real h_loaded_upper_arm_tau_y = h_V_upper_arm_tau_y + t183;
    const ella_real h_loaded_upper_arm_tau_z = h_V_upper_arm_tau_z + t184;
    const ella_real t185 = Lambda_forearm_1 * Theta_upper_arm_11 + Lambda_forearm_2 * Theta_upper_arm_21
        + Lambda_forearm_3 * Theta_upper_arm_31;
    const ella_real t186 = t185 + Lambda_forearm_5 * ELLA_REAL(2.0011941703010714);
    const ella_real t187 = Lambda_forearm_1 * Theta_upper_arm_12 + Lambda_forearm_2 * Theta_upper_arm_22
        + Lambda_forearm_3 * Theta_upper_arm_32;
    const ella_real t188 = t187 + Lambda_forearm_5 * ELLA_REAL(2.0700807911885764);
    const ella_real t189 = Lambda_forearm_1 * Theta_upper_arm_13 + Lambda_forearm_2 * Theta_upper_arm_23
        + Lambda_forearm_3 * Theta_upper_arm_33;
    const ella_real t190 = t189 + Lambda_forearm_5 * ELLA_REAL(3.5651069283690613);
    const ella_real t191 = Lambda_forearm_1 * Theta_upper_arm_14 + Lambda_forearm_2 * Theta_upper_arm_24
        + Lambda_forearm_3 * Theta_upper_arm_34;
    const ella_real t192 = t191 + Lambda_forearm_6 * ELLA_REAL(2.0011941703010714);
    const ella_real t193 = Lambda_forearm_1 * Theta_upper_arm_15 + Lambda_forearm_2 * Theta_upper_arm_25
        + Lambda_forearm_3 * Theta_upper_arm_35;
    const ella_real t194 = t193 + Lambda_forearm_6 * ELLA_REAL(2.0700807911885764);
    const ella_real t195 = Lambda_forearm_1 * Theta_upper_arm_16 + Lambda_forearm_2 * Theta_upper_arm_26
        + Lambda_forearm_3 * Theta_upper_arm_36;
    const ella_real t196 = t195 + Lambda_forearm_6 * ELLA_REAL(3.5651069283690613);
    const ella_real t197 = Lambda_forearm_1 * Theta_upper_arm_17 + Lambda_forearm_2 * Theta_upper_arm_27
        + Lambda_forearm_3 * Theta_upper_arm_37;
    const ella_real t198 = Lambda_forearm_2 * Theta_upper_arm_11 + Lambda_forearm_7 * Theta_upper_arm_21
        + Lambda_forearm_8 * Theta_upper_arm_31;
    const ella_real t199 = t198 + Lambda_forearm_10 * ELLA_REAL(2.0011941703010714);
    const ella_real t200 = Lambda_forearm_2 * Theta_upper_arm_12 + Lambda_forearm_7 * Theta_upper_arm_22
        + Lambda_forearm_8 * Theta_upper_arm_32;
    const ella_real t201 = t200 + Lambda_forearm_10 * ELLA_REAL(2.0700807911885764);
    const ella_real t202 = Lambda_forearm_2 * Theta_upper_arm_13 + Lambda_forearm_7 * Theta_upper_arm_23
        + Lambda_forearm_8 * Theta_upper_arm_33;
    const ella_real t203 = t202 + Lambda_forearm_10 * ELLA_REAL(3.5651069283690613);
    const ella_real t204 = Lambda_forearm_2 * Theta_upper_arm_14 + Lambda_forearm_7 * Theta_upper_arm_24
        + Lambda_forearm_8 * Theta_upper_arm_34;
    const ella_real t205 = t204 + Lambda_forearm_11 * ELLA_REAL(2.0011941703010714);
    const ella_real t206 = Lambda_forearm_2 * Theta_upper_arm_15 + Lambda_forearm_7 * Theta_upper_arm_25
        + Lambda_forearm_8 * Theta_upper_arm_35;
    const ella_real t207 = t206 + Lambda_forearm_11 * ELLA_REAL(2.0700807911885764);
    const ella_real t208 = Lambda_forearm_2 * Theta_upper_arm_16 + Lambda_forearm_7 * Theta_upper_arm_26
        + Lambda_forearm_8 * Theta_upper_arm_36;
    const ella_real t209 = t208 + Lambda_forearm_11 * ELLA_REAL(3.5651069283690613);
    const ella_real t210 = Lambda_forearm_2 * Theta_upper_arm_17 + Lambda_forearm_7 * Theta_upper_arm_27
        + Lambda_forearm_8 * Theta_upper_arm_37;
    const ella_real t211 = Lambda_forearm_3 * Theta_upper_arm_11 + Lambda_forearm_8 * Theta_upper_arm_21
        + Lambda_forearm_12 * Theta_upper_arm_31;
    const ella_real t212 = t211 + Lambda_forearm_14 * ELLA_REAL(2.0011941703010714);
    const ella_real t213 = Lambda_forearm_3 * Theta_upper_arm_12 + Lambda_forearm_8 * Theta_upper_arm_22
        + Lambda_forearm_12 * Theta_upper_arm_32;
    const ella_real t214 = t213 + Lambda_forearm_14 * ELLA_REAL(2.0700807911885764);
    const ella_real t215 = Lambda_forearm_3 * Theta_upper_arm_13 + Lambda_forearm_8 * Theta_upper_arm_23
        + Lambda_forearm_12 * Theta_upper_arm_33;
    const ella_real t216 = t215 + Lambda_forearm_14 * ELLA_REAL(3.5651069283690613);
    const ella_real t217 = Lambda_forearm_3 * Theta_upper_arm_14 + Lambda_forearm_8 * Theta_upper_arm_24
        + Lambda_forearm_12 * Theta_upper_arm_34;
    const ella_real t218 = t217 + Lambda_forearm_15 * ELLA_REAL(2.0011941703010714);
    const ella_real t219 = Lambda_forearm_3 * Theta_upper_arm_15 + Lambda_forearm_8 * Theta_upper_arm_25
        + Lambda_forearm_12 * Theta_upper_arm_35;
    const ella_real t220 = t219 + Lambda_forearm_15 * ELLA_REAL(2.0700807911885764);
    const ella_real t221 = Lambda_forearm_3 * Theta_upper_arm_16 + Lambda_forearm_8 * Theta_upper_arm_26
        + Lambda_forearm_12 * Theta_upper_arm_36;
    const ella_real t222 = t221 + Lambda_forearm_15 * ELLA_REAL(3.5651069283690613);
    const ella_real t223 = Lambda_forearm_3 * Theta_upper_arm_17 + Lambda_forearm_8 * Theta_upper_arm_27
        + Lambda_forearm_12 * Theta_upper_arm_37;
    const ella_real t224 = Lambda_forearm_4 * Theta_upper_arm_11 + Lambda_forearm_9 * Theta_upper_arm_21
        + Lambda_forearm_13 * Theta_upper_arm_31;
    const ella_real C_upper_arm_41 = t224 + Lambda_forearm_17 * ELLA_REAL(2.0011941703010714);
    const ella_real t225 = Lambda_forearm_4 * Theta_upper_arm_12 + Lambda_forearm_9 * Theta_upper_arm_22
        + Lambda_forearm_13 * Theta_upper_arm_32;
    const ella_real C_upper_arm_42 = t225 + Lambda_forearm_17 * ELLA_REAL(2.0700807911885764);
    const ella_real t226 = Lambda_forearm_4 * Theta_upper_arm_13 + Lambda_forearm_9 * Theta_upper_arm_23
        + Lambda_forearm_13 * Theta_upper_arm_33;
    const ella_real C_upper_arm_43 = t226 + Lambda_forearm_17 * ELLA_REAL(3.5651069283690613);
    const ella_real t227 = Lambda_forearm_4 * Theta_upper_arm_14 + Lambda_forearm_9 * Theta_upper_arm_24
        + Lambda_forearm_13 * Theta_upper_arm_34;
    const ella_real C_upper_arm_44 = t227 + Lambda_forearm_18 * ELLA_REAL(2.0011941703010714);
    const ella_real t228 = Lambda_forearm_4 * Theta_upper_arm_15 + Lambda_forearm_9 * Theta_upper_arm_25
        + Lambda_forearm_13 * Theta_upper_arm_35;
    const ella_real C_upper_arm_45 = t228 + Lambda_forearm_18 * ELLA_REAL(2.0700807911885764);
    const ella_real t229 = Lambda_forearm_4 * Theta_upper_arm_16 + Lambda_forearm_9 * Theta_upper_arm_26
        + Lambda_forearm_13 * Theta_upper_arm_36;
    const ella_real C_upper_arm_46 = t229 + Lambda_forearm_18 * ELLA_REAL(3.5651069283690613);
    const ella_real C_upper_arm_47 = Lambda_forearm_4 * Theta_upper_arm_17 + Lambda_forearm_9 * Theta_upper_arm_27
        + Lambda_forearm_13 * Theta_upper_arm_37;
    const ella_real t230 = Lambda_forearm_5 * Theta_upper_arm_11 + Lambda_forearm_10 * Theta_upper_arm_21
        + Lambda_forearm_14 * Theta_upper_arm_31;
    const ella_real t231 = t230 + Lambda_T_upper_arm_55 * ELLA_REAL(2.0011941703010714);
    const ella_real t232 = Lambda_forearm_5 * Theta_upper_arm_12 + Lambda_forearm_10 * Theta_upper_arm_22
        + Lambda_forearm_14 * Theta_upper_arm_32;
    const ella_real t233 = t232 + Lambda_T_upper_arm_55 * ELLA_REAL(2.0700807911885764);
    const ella_real t234 = Lambda_forearm_5 * Theta_upper_arm_13 + Lambda_forearm_10 * Theta_upper_arm_23
        + Lambda_forearm_14 * Theta_upper_arm_33;
    const ella_real t235 = t234 + Lambda_T_upper_arm_55 * ELLA_REAL(3.5651069283690613);
    const ella_real t236 = Lambda_forearm_5 * Theta_upper_arm_14 + Lambda_forearm_10 * Theta_upper_arm_24
        + Lambda_forearm_14 * Theta_upper_arm_34;
    const ella_real t237 = Lambda_forearm_20 * ELLA_REAL(2.0011941703010714);
    const ella_real C_upper_arm_54 = t236 + t237;
    const ella_real t238 = Lambda_forearm_5 * Theta_upper_arm_15 + Lambda_forearm_10 * Theta_upper_arm_25
        + Lambda_forearm_14 * Theta_upper_arm_35;
    const ella_real t239 = Lambda_forearm_20 * ELLA_REAL(2.0700807911885764);
    const ella_real C_upper_arm_55 = t238 + t239;
    const ella_real t240 = Lambda_forearm_5 * Theta_upper_arm_16 + Lambda_forearm_10 * Theta_upper_arm_26
        + Lambda_forearm_14 * Theta_upper_arm_36;
    const ella_real t241 = Lambda_forearm_20 * ELLA_REAL(3.5651069283690613);
    const ella_real C_upper_arm_56 = t240 + t241;
    const ella_real C_upper_arm_57 = Lambda_forearm_5 * Theta_upper_arm_17 + Lambda_forearm_10 * Theta_upper_arm_27
        + Lambda_forearm_14 * Theta_upper_arm_37;
    const ella_real t242 = Lambda_forearm_6 * Theta_upper_arm_11 + Lambda_forearm_11 * Theta_upper_arm_21
        + Lambda_forearm_15 * Theta_upper_arm_31;
    const ella_real C_upper_arm_61 = t242 + t237;
    const ella_real t243 = Lambda_forearm_6 * Theta_upper_arm_12 + Lambda_forearm_11 * Theta_upper_arm_22
        + Lambda_forearm_15 * Theta_upper_arm_32;
    const ella_real C_upper_arm_62 = t243 + t239;
    const ella_real t244 = Lambda_forearm_6 * Theta_upper_arm_13 + Lambda_forearm_11 * Theta_upper_arm_23
        + Lambda_forearm_15 * Theta_upper_arm_33;
    const ella_real C_upper_arm_63 = t244 + t241;
    const ella_real t245 = Lambda_forearm_6 * Theta_upper_arm_14 + Lambda_forearm_11 * Theta_upper_arm_24
        + Lambda_forearm_15 * Theta_upper_arm_34;
    const ella_real t246 = t245 + Lambda_T_upper_arm_66 * ELLA_REAL(2.0011941703010714);
    const ella_real t247 = Lambda_forearm_6 * Theta_upper_arm_15 + Lambda_forearm_11 * Theta_upper_arm_25
        + Lambda_forearm_15 * Theta_upper_arm_35;
    const ella_real t248 = t247 + Lambda_T_upper_arm_66 * ELLA_REAL(2.0700807911885764);
    const ella_real t249 = Lambda_forearm_6 * Theta_upper_arm_16 + Lambda_forearm_11 * Theta_upper_arm_26
        + Lambda_forearm_15 * Theta_upper_arm_36;
    const ella_real t250 = t249 + Lambda_T_upper_arm_66 * ELLA_REAL(3.5651069283690613);
    const ella_real C_upper_arm_67 = Lambda_forearm_6 * Theta_upper_arm_17 + Lambda_forearm_11 * Theta_upper_arm_27
        + Lambda_forearm_15 * Theta_upper_arm_37;
    const ella_real C_upper_arm_21 = t199 + (r_T_upper_arm_z * C_upper_arm_41 - c->links[0].length * C_upper_arm_61);
    const ella_real C_upper_arm_22 = t201 + (r_T_upper_arm_z * C_upper_arm_42 - c->links[0].length * C_upper_arm_62);
    const ella_real C_upper_arm_23 = t203 + (r_T_upper_arm_z * C_upper_arm_43 - c->links[0].length * C_upper_arm_63);
    const ella_real C_upper_arm_34 = t218 + (c->links[0].length * C_upper_arm_54 - r_T_upper_arm_y * C_upper_arm_44);
    const ella_real C_upper_arm_35 = t220 + (c->links[0].length * C_upper_arm_55 - r_T_upper_arm_y * C_upper_arm_45);
    const ella_real C_upper_arm_36 = t222 + (c->links[0].length * C_upper_arm_56 - r_T_upper_arm_y * C_upper_arm_46);
    const ella_real C_upper_arm_27 = t210 + (r_T_upper_arm_z * C_upper_arm_47 - c->links[0].length * C_upper_arm_67);
    const ella_real C_upper_arm_37 = t223 + (c->links[0].length * C_upper_arm_57 - r_T_upper_arm_y * C_upper_arm_47);
    const ella_real C_upper_arm_11 = t186 + (r_T_upper_arm_y * C_upper_arm_61 - r_T_upper_arm_z * t231)
        - L_upper_arm_z1;
    const ella_real C_upper_arm_12 = t188 + (r_T_upper_arm_y * C_upper_arm_62 - r_T_upper_arm_z * t233)
        - L_upper_arm_z2;
    const ella_real C_upper_arm_13 = t190 + (r_T_upper_arm_y * C_upper_arm_63 - r_T_upper_arm_z * t235)
        - L_upper_arm_z3;
    const ella_real C_upper_arm_14 = L_upper_arm_y1
        + (t192 + (r_T_upper_arm_y * t246 - r_T_upper_arm_z * C_upper_arm_54));
    const ella_real C_upper_arm_15 = L_upper_arm_y2
        + (t194 + (r_T_upper_arm_y * t248 - r_T_upper_arm_z * C_upper_arm_55));
    const ella_real C_upper_arm_16 = L_upper_arm_y3
        + (t196 + (r_T_upper_arm_y * t250 - r_T_upper_arm_z * C_upper_arm_56));
    const ella_real C_upper_arm_17 = c->links[0].sigma_t_7
        + (t197 + (r_T_upper_arm_y * C_upper_arm_67 - r_T_upper_arm_z * C_upper_arm_57));
    const ella_real C_upper_arm_24 = t205 + (r_T_upper_arm_z * C_upper_arm_44 - c->links[0].length * t246)
        - c->links[0].chi_1;
    const ella_real C_upper_arm_25 = t207 + (r_T_upper_arm_z * C_upper_arm_45 - c->links[0].length * t248)
        - c->links[0].chi_2;
    const ella_real C_upper_arm_26 = t209 + (r_T_upper_arm_z * C_upper_arm_46 - c->links[0].length * t250)
        - c->links[0].chi_3;
    const ella_real C_upper_arm_31 = c->links[0].chi_1
        + (t212 + (c->links[0].length * t231 - r_T_upper_arm_y * C_upper_arm_41));
    const ella_real C_upper_arm_32 = c->links[0].chi_2
        + (t214 + (c->links[0].length * t233 - r_T_upper_arm_y * C_upper_arm_42));
    const ella_real C_upper_arm_33 = c->links[0].chi_3
        + (t216 + (c->links[0].length * t235 - r_T_upper_arm_y * C_upper_arm_43));
    const ella_real t251 = Theta_upper_arm_11 * t186 + Theta_upper_arm_21 * t199 + Theta_upper_arm_31 * t212
        + t231 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_upper_arm_11 = t251 + m_eta[0];
    bad |= (unsigned long)(!(modal_inertia_upper_arm_11 > 0)) << 0;
    const ella_real modal_inertia_upper_arm_12 = Theta_upper_arm_11 * t188 + Theta_upper_arm_21 * t201
        + Theta_upper_arm_31 * t214 + t233 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_upper_arm_13 = Theta_upper_arm_11 * t190 + Theta_upper_arm_21 * t203
        + Theta_upper_arm_31 * t216 + t235 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_upper_arm_14 = Theta_upper_arm_11 * t192 + Theta_upper_arm_21 * t205
        + Theta_upper_arm_31 * t218 + C_upper_arm_54 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_upper_arm_15 = Theta_upper_arm_11 * t194 + Theta_upper_arm_21 * t207
        + Theta_upper_arm_31 * t220 + C_upper_arm_55 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_upper_arm_16 = Theta_upper_arm_11 * t196 + Theta_upper_arm_21 * t209
        + Theta_upper_arm_31 * t222 + C_upper_arm_56 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_upper_arm_17 = Theta_upper_arm_11 * t197 + Theta_upper_arm_21 * t210
        + Theta_upper_arm_31 * t223 + C_upper_arm_57 * ELLA_REAL(2.0011941703010714);
    const ella_real t252 = Theta_upper_arm_12 * t188 + Theta_upper_arm_22 * t201 + Theta_upper_arm_32 * t214
        + t233 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_upper_arm_22 = t252 + m_eta[1];
    const ella_real modal_inertia_upper_arm_23 = Theta_upper_arm_12 * t190 + Theta_upper_arm_22 * t203
        + Theta_upper_arm_32 * t216 + t235 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_upper_arm_24 = Theta_upper_arm_12 * t192 + Theta_upper_arm_22 * t205
        + Theta_upper_arm_32 * t218 + C_upper_arm_54 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_upper_arm_25 = Theta_upper_arm_12 * t194 + Theta_upper_arm_22 * t207
        + Theta_upper_arm_32 * t220 + C_upper_arm_55 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_upper_arm_26 = Theta_upper_arm_12 * t196 + Theta_upper_arm_22 * t209
        + Theta_upper_arm_32 * t222 + C_upper_arm_56 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_upper_arm_27 = Theta_upper_arm_12 * t197 + Theta_upper_arm_22 * t210
        + Theta_upper_arm_32 * t223 + C_upper_arm_57 * ELLA_REAL(2.0700807911885764);
    const ella_real t253 = Theta_upper_arm_13 * t190 + Theta_upper_arm_23 * t203 + Theta_upper_arm_33 * t216
        + t235 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_upper_arm_33 = t253 + m_eta[2];
    const ella_real modal_inertia_upper_arm_34 = Theta_upper_arm_13 * t192 + Theta_upper_arm_23 * t205
        + Theta_upper_arm_33 * t218 + C_upper_arm_54 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_upper_arm_35 = Theta_upper_arm_13 * t194 + Theta_upper_arm_23 * t207
        + Theta_upper_arm_33 * t220 + C_upper_arm_55 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_upper_arm_36 = Theta_upper_arm_13 * t196 + Theta_upper_arm_23 * t209
        + Theta_upper_arm_33 * t222 + C_upper_arm_56 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_upper_arm_37 = Theta_upper_arm_13 * t197 + Theta_upper_arm_23 * t210
        + Theta_upper_arm_33 * t223 + C_upper_arm_57 * ELLA_REAL(3.5651069283690613);
    const ella_real t254 = Theta_upper_arm_14 * t192 + Theta_upper_arm_24 * t205 + Theta_upper_arm_34 * t218
        + t246 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_upper_arm_44 = t254 + m_eta[3];
    const ella_real modal_inertia_upper_arm_45 = Theta_upper_arm_14 * t194 + Theta_upper_arm_24 * t207
        + Theta_upper_arm_34 * t220 + t248 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_upper_arm_46 = Theta_upper_arm_14 * t196 + Theta_upper_arm_24 * t209
        + Theta_upper_arm_34 * t222 + t250 * ELLA_REAL(2.0011941703010714);
    const ella_real modal_inertia_upper_arm_47 = Theta_upper_arm_14 * t197 + Theta_upper_arm_24 * t210
        + Theta_upper_arm_34 * t223 + C_upper_arm_67 * ELLA_REAL(2.0011941703010714);
    const ella_real t255 = Theta_upper_arm_15 * t194 + Theta_upper_arm_25 * t207 + Theta_upper_arm_35 * t220
        + t248 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_upper_arm_55 = t255 + m_eta[4];
    const ella_real modal_inertia_upper_arm_56 = Theta_upper_arm_15 * t196 + Theta_upper_arm_25 * t209
        + Theta_upper_arm_35 * t222 + t250 * ELLA_REAL(2.0700807911885764);
    const ella_real modal_inertia_upper_arm_57 = Theta_upper_arm_15 * t197 + Theta_upper_arm_25 * t210
        + Theta_upper_arm_35 * t223 + C_upper_arm_67 * ELLA_REAL(2.0700807911885764);
    const ella_real t256 = Theta_upper_arm_16 * t196 + Theta_upper_arm_26 * t209 + Theta_upper_arm_36 * t222
        + t250 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_upper_arm_66 = t256 + m_eta[5];
    const ella_real modal_inertia_upper_arm_67 = Theta_upper_arm_16 * t197 + Theta_upper_arm_26 * t210
        + Theta_upper_arm_36 * t223 + C_upper_arm_67 * ELLA_REAL(3.5651069283690613);
    const ella_real modal_inertia_upper_arm_77 = Theta_upper_arm_17 * t197 + Theta_upper_arm_27 * t210
        + Theta_upper_arm_37 * t223 + m_eta[6];
    const ella_real t257 = Theta_upper_arm_11 * p_T_upper_arm_tau_x + Theta_upper_arm_21 * p_T_upper_arm_tau_y
        + Theta_upper_arm_31 * p_T_upper_arm_tau_z;
    const ella_real t258 = Theta_upper_arm_12 * p_T_upper_arm_tau_x + Theta_upper_arm_22 * p_T_upper_arm_tau_y
        + Theta_upper_arm_32 * p_T_upper_arm_tau_z;
    const ella_real t259 = Theta_upper_arm_13 * p_T_upper_arm_tau_x + Theta_upper_arm_23 * p_T_upper_arm_tau_y
        + Theta_upper_arm_33 * p_T_upper_arm_tau_z;
    const ella_real t260 = Theta_upper_arm_14 * p_T_upper_arm_tau_x + Theta_upper_arm_24 * p_T_upper_arm_tau_y
        + Theta_upper_arm_34 * p_T_upper_arm_tau_z;
    const ella_real t261 = Theta_upper_arm_15 * p_T_upper_arm_tau_x + Theta_upper_arm_25 * p_T_upper_arm_tau_y
        + Theta_upper_arm_35 * p_T_upper_arm_tau_z;
    const ella_real t262 = Theta_upper_arm_16 * p_T_upper_arm_tau_x + Theta_upper_arm_26 * p_T_upper_arm_tau_y
        + Theta_upper_arm_36 * p_T_upper_arm_tau_z;
    const ella_real t263 = Theta_upper_arm_17 * p_T_upper_arm_tau_x + Theta_upper_arm_27 * p_T_upper_arm_tau_y
        + Theta_upper_arm_37 * p_T_upper_arm_tau_z;
    const ella_real h_phi_upper_arm_1 = h_eta_upper_arm_1 + work->f_eta[0]
        + (t257 + p_T_upper_arm_f_y * ELLA_REAL(2.0011941703010714));
    const ella_real h_phi_upper_arm_2 = h_eta_upper_arm_2 + work->f_eta[1]
        + (t258 + p_T_upper_arm_f_y * ELLA_REAL(2.0700807911885764));
    const ella_real h_phi_upper_arm_3 = h_eta_upper_arm_3 + work->f_eta[2]
        + (t259 + p_T_upper_arm_f_y * ELLA_REAL(3.5651069283690613));
    const ella_real h_phi_upper_arm_4 = h_eta_upper_arm_4 + work->f_eta[3]
        + (t260 + p_T_upper_arm_f_z * ELLA_REAL(2.0011941703010714));
    const ella_real h_phi_upper_arm_5 = h_eta_upper_arm_5 + work->f_eta[4]
        + (t261 + p_T_upper_arm_f_z * ELLA_REAL(2.0700807911885764));
    const ella_real h_phi_upper_arm_6 = h_eta_upper_arm_6 + work->f_eta[5]
        + (t262 + p_T_upper_arm_f_z * ELLA_REAL(3.5651069283690613));
    const ella_real h_phi_upper_arm_7 = h_eta_upper_arm_7 + work->f_eta[6] + t263;
    const ella_real modes_inverse_upper_arm_1 = 1 / modal_inertia_upper_arm_11;
    const ella_real modes_L_upper_arm_21 = modal_inertia_upper_arm_12 * modes_inverse_upper_arm_1;
    const ella_real modes_L_upper_arm_31 = modal_inertia_upper_arm_13 * modes_inverse_upper_arm_1;
    const ella_real modes_L_upper_arm_41 = modal_inertia_upper_arm_14 * modes_inverse_upper_arm_1;
    const ella_real modes_L_upper_arm_51 = modal_inertia_upper_arm_15 * modes_inverse_upper_arm_1;
    const ella_real modes_L_upper_arm_61 = modal_inertia_upper_arm_16 * modes_inverse_upper_arm_1;
    const ella_real modes_L_upper_arm_71 = modal_inertia_upper_arm_17 * modes_inverse_upper_arm_1;
    const ella_real t264 = modal_inertia_upper_arm_22 - modal_inertia_upper_arm_12 * modes_L_upper_arm_21;
    bad |= (unsigned long)(!(t264 > 0)) << 0;
    const ella_real modes_inverse_upper_arm_2 = 1 / t264;
    const ella_real t265 = modal_inertia_upper_arm_23 - modal_inertia_upper_arm_12 * modes_L_upper_arm_31;
    const ella_real modes_L_upper_arm_32 = t265 * modes_inverse_upper_arm_2;
    const ella_real t266 = modal_inertia_upper_arm_24 - modal_inertia_upper_arm_12 * modes_L_upper_arm_41;
    const ella_real modes_L_upper_arm_42 = t266 * modes_inverse_upper_arm_2;
    const ella_real t267 = modal_inertia_upper_arm_25 - modal_inertia_upper_arm_12 * modes_L_upper_arm_51;
    const ella_real modes_L_upper_arm_52 = t267 * modes_inverse_upper_arm_2;
    const ella_real t268 = modal_inertia_upper_arm_26 - modal_inertia_upper_arm_12 * modes_L_upper_arm_61;
    const ella_real modes_L_upper_arm_62 = t268 * modes_inverse_upper_arm_2;
    const ella_real t269 = modal_inertia_upper_arm_27 - modal_inertia_upper_arm_12 * modes_L_upper_arm_71;
    const ella_real modes_L_upper_arm_72 = t269 * modes_inverse_upper_arm_2;
    const ella_real t270 = modal_inertia_upper_arm_33
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_31 + t265 * modes_L_upper_arm_32);
    bad |= (unsigned long)(!(t270 > 0)) << 0;
    const ella_real modes_inverse_upper_arm_3 = 1 / t270;
    const ella_real t271 = modal_inertia_upper_arm_34
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_41 + t265 * modes_L_upper_arm_42);
    const ella_real modes_L_upper_arm_43 = t271 * modes_inverse_upper_arm_3;
    const ella_real t272 = modal_inertia_upper_arm_35
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_51 + t265 * modes_L_upper_arm_52);
    const ella_real modes_L_upper_arm_53 = t272 * modes_inverse_upper_arm_3;
    const ella_real t273 = modal_inertia_upper_arm_36
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_61 + t265 * modes_L_upper_arm_62);
    const ella_real modes_L_upper_arm_63 = t273 * modes_inverse_upper_arm_3;
    const ella_real t274 = modal_inertia_upper_arm_37
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_71 + t265 * modes_L_upper_arm_72);
    const ella_real modes_L_upper_arm_73 = t274 * modes_inverse_upper_arm_3;
    const ella_real t275 = modal_inertia_upper_arm_14 * modes_L_upper_arm_41 + t266 * modes_L_upper_arm_42
        + t271 * modes_L_upper_arm_43;
    const ella_real t276 = modal_inertia_upper_arm_44 - t275;
    bad |= (unsigned long)(!(t276 > 0)) << 0;
    const ella_real modes_inverse_upper_arm_4 = 1 / t276;
    const ella_real t277 = modal_inertia_upper_arm_14 * modes_L_upper_arm_51 + t266 * modes_L_upper_arm_52
        + t271 * modes_L_upper_arm_53;
    const ella_real t278 = modal_inertia_upper_arm_45 - t277;
    const ella_real modes_L_upper_arm_54 = t278 * modes_inverse_upper_arm_4;
    const ella_real t279 = modal_inertia_upper_arm_14 * modes_L_upper_arm_61 + t266 * modes_L_upper_arm_62
        + t271 * modes_L_upper_arm_63;
    const ella_real t280 = modal_inertia_upper_arm_46 - t279;
    const ella_real modes_L_upper_arm_64 = t280 * modes_inverse_upper_arm_4;
    const ella_real t281 = modal_inertia_upper_arm_14 * modes_L_upper_arm_71 + t266 * modes_L_upper_arm_72
        + t271 * modes_L_upper_arm_73;
    const ella_real t282 = modal_inertia_upper_arm_47 - t281;
    const ella_real modes_L_upper_arm_74 = t282 * modes_inverse_upper_arm_4;
    const ella_real t283 = modal_inertia_upper_arm_15 * modes_L_upper_arm_51 + t267 * modes_L_upper_arm_52
        + t272 * modes_L_upper_arm_53;
    const ella_real t284 = modal_inertia_upper_arm_55 - (t283 + t278 * modes_L_upper_arm_54);
    bad |= (unsigned long)(!(t284 > 0)) << 0;
    const ella_real modes_inverse_upper_arm_5 = 1 / t284;
    const ella_real t285 = modal_inertia_upper_arm_15 * modes_L_upper_arm_61 + t267 * modes_L_upper_arm_62
        + t272 * modes_L_upper_arm_63;
    const ella_real t286 = modal_inertia_upper_arm_56 - (t285 + t278 * modes_L_upper_arm_64);
    const ella_real modes_L_upper_arm_65 = t286 * modes_inverse_upper_arm_5;
    const ella_real t287 = modal_inertia_upper_arm_15 * modes_L_upper_arm_71 + t267 * modes_L_upper_arm_72
        + t272 * modes_L_upper_arm_73;
    const ella_real t288 = modal_inertia_upper_arm_57 - (t287 + t278 * modes_L_upper_arm_74);
    const ella_real modes_L_upper_arm_75 = t288 * modes_inverse_upper_arm_5;
    const ella_real t289 = modal_inertia_upper_arm_16 * modes_L_upper_arm_61 + t268 * modes_L_upper_arm_62
        + t273 * modes_L_upper_arm_63;
    const ella_real t290 = modal_inertia_upper_arm_66
        - (t289 + t280 * modes_L_upper_arm_64 + t286 * modes_L_upper_arm_65);
    bad |= (unsigned long)(!(t290 > 0)) << 0;
    const ella_real modes_inverse_upper_arm_6 = 1 / t290;
    const ella_real t291 = modal_inertia_upper_arm_16 * modes_L_upper_arm_71 + t268 * modes_L_upper_arm_72
        + t273 * modes_L_upper_arm_73;
    const ella_real t292 = modal_inertia_upper_arm_67
        - (t291 + t280 * modes_L_upper_arm_74 + t286 * modes_L_upper_arm_75);
    const ella_real modes_L_upper_arm_76 = t292 * modes_inverse_upper_arm_6;
    const ella_real t293 = modal_inertia_upper_arm_17 * modes_L_upper_arm_71 + t269 * modes_L_upper_arm_72
        + t274 * modes_L_upper_arm_73;
    const ella_real t294 = modal_inertia_upper_arm_77
        - (t293 + t282 * modes_L_upper_arm_74 + t288 * modes_L_upper_arm_75 + t292 * modes_L_upper_arm_76);
    bad |= (unsigned long)(!(t294 > 0)) << 0;
    const ella_real modes_inverse_upper_arm_7 = 1 / t294;
    const ella_real t295 = C_upper_arm_12 - modes_L_upper_arm_21 * C_upper_arm_11;
    const ella_real t296 = C_upper_arm_22 - modes_L_upper_arm_21 * C_upper_arm_21;
    const ella_real t297 = C_upper_arm_32 - modes_L_upper_arm_21 * C_upper_arm_31;
    const ella_real t298 = C_upper_arm_13 - modes_L_upper_arm_31 * C_upper_arm_11 - modes_L_upper_arm_32 * t295;
    const ella_real t299 = C_upper_arm_23 - modes_L_upper_arm_31 * C_upper_arm_21 - modes_L_upper_arm_32 * t296;
    const ella_real t300 = C_upper_arm_33 - modes_L_upper_arm_31 * C_upper_arm_31 - modes_L_upper_arm_32 * t297;
    const ella_real t301 = C_upper_arm_14 - modes_L_upper_arm_41 * C_upper_arm_11 - modes_L_upper_arm_42 * t295
        - modes_L_upper_arm_43 * t298;
    const ella_real t302 = C_upper_arm_24 - modes_L_upper_arm_41 * C_upper_arm_21 - modes_L_upper_arm_42 * t296
        - modes_L_upper_arm_43 * t299;
    const ella_real t303 = C_upper_arm_34 - modes_L_upper_arm_41 * C_upper_arm_31 - modes_L_upper_arm_42 * t297
        - modes_L_upper_arm_43 * t300;
    const ella_real t304 = C_upper_arm_15 - modes_L_upper_arm_51 * C_upper_arm_11 - modes_L_upper_arm_52 * t295
        - modes_L_upper_arm_53 * t298;
    const ella_real t305 = C_upper_arm_25 - modes_L_upper_arm_51 * C_upper_arm_21 - modes_L_upper_arm_52 * t296
        - modes_L_upper_arm_53 * t299;
    const ella_real t306 = C_upper_arm_35 - modes_L_upper_arm_51 * C_upper_arm_31 - modes_L_upper_arm_52 * t297
        - modes_L_upper_arm_53 * t300;
    const ella_real t307 = t304 - modes_L_upper_arm_54 * t301;
    const ella_real t308 = t305 - modes_L_upper_arm_54 * t302;
    const ella_real t309 = t306 - modes_L_upper_arm_54 * t303;
    const ella_real t310 = C_upper_arm_16 - modes_L_upper_arm_61 * C_upper_arm_11 - modes_L_upper_arm_62 * t295
        - modes_L_upper_arm_63 * t298;
    const ella_real t311 = C_upper_arm_26 - modes_L_upper_arm_61 * C_upper_arm_21 - modes_L_upper_arm_62 * t296
        - modes_L_upper_arm_63 * t299;
    const ella_real t312 = C_upper_arm_36 - modes_L_upper_arm_61 * C_upper_arm_31 - modes_L_upper_arm_62 * t297
        - modes_L_upper_arm_63 * t300;
    const ella_real t313 = t310 - modes_L_upper_arm_64 * t301 - modes_L_upper_arm_65 * t307;
    const ella_real t314 = t311 - modes_L_upper_arm_64 * t302 - modes_L_upper_arm_65 * t308;
    const ella_real t315 = t312 - modes_L_upper_arm_64 * t303 - modes_L_upper_arm_65 * t309;
    const ella_real t316 = C_upper_arm_17 - modes_L_upper_arm_71 * C_upper_arm_11 - modes_L_upper_arm_72 * t295
        - modes_L_upper_arm_73 * t298;
    const ella_real t317 = C_upper_arm_27 - modes_L_upper_arm_71 * C_upper_arm_21 - modes_L_upper_arm_72 * t296
        - modes_L_upper_arm_73 * t299;
    const ella_real t318 = C_upper_arm_37 - modes_L_upper_arm_71 * C_upper_arm_31 - modes_L_upper_arm_72 * t297
        - modes_L_upper_arm_73 * t300;
    const ella_real t319 = t316 - modes_L_upper_arm_74 * t301 - modes_L_upper_arm_75 * t307
        - modes_L_upper_arm_76 * t313;
    const ella_real t320 = t317 - modes_L_upper_arm_74 * t302 - modes_L_upper_arm_75 * t308
        - modes_L_upper_arm_76 * t314;
    const ella_real t321 = t318 - modes_L_upper_arm_74 * t303 - modes_L_upper_arm_75 * t309
        - modes_L_upper_arm_76 * t315;
    const ella_real t322 = h_phi_upper_arm_2 - modes_L_upper_arm_21 * h_phi_upper_arm_1;
    const ella_real t323 = h_phi_upper_arm_3 - modes_L_upper_arm_31 * h_phi_upper_arm_1 - modes_L_upper_arm_32 * t322;
    const ella_real t324 = h_phi_upper_arm_4 - modes_L_upper_arm_41 * h_phi_upper_arm_1 - modes_L_upper_arm_42 * t322
        - modes_L_upper_arm_43 * t323;
    const ella_real t325 = h_phi_upper_arm_5 - modes_L_upper_arm_51 * h_phi_upper_arm_1 - modes_L_upper_arm_52 * t322
        - modes_L_upper_arm_53 * t323;
    const ella_real t326 = t325 - modes_L_upper_arm_54 * t324;
    const ella_real t327 = h_phi_upper_arm_6 - modes_L_upper_arm_61 * h_phi_upper_arm_1 - modes_L_upper_arm_62 * t322
        - modes_L_upper_arm_63 * t323;
    const ella_real t328 = t327 - modes_L_upper_arm_64 * t324 - modes_L_upper_arm_65 * t326;
    const ella_real t329 = h_phi_upper_arm_7 - modes_L_upper_arm_71 * h_phi_upper_arm_1 - modes_L_upper_arm_72 * t322
        - modes_L_upper_arm_73 * t323;
    const ella_real t330 = t329 - modes_L_upper_arm_74 * t324 - modes_L_upper_arm_75 * t326
        - modes_L_upper_arm_76 * t328;
    const ella_real modes_W_upper_arm_11 = C_upper_arm_11 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_12 = C_upper_arm_21 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_13 = C_upper_arm_31 * modes_inverse_upper_arm_1;
    const ella_real modes_W_upper_arm_21 = t295 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_22 = t296 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_23 = t297 * modes_inverse_upper_arm_2;
    const ella_real modes_W_upper_arm_31 = t298 * modes_inverse_upper_arm_3;
    const ella_real modes_W_upper_arm_32 = t299 * modes_inverse_upper_arm_3;
    const ella_real modes_W_upper_arm_33 = t300 * modes_inverse_upper_arm_3;
    const ella_real modes_W_upper_arm_41 = t301 * modes_inverse_upper_arm_4;
    const ella_real modes_W_upper_arm_42 = t302 * modes_inverse_upper_arm_4;
    const ella_real modes_W_upper_arm_43 = t303 * modes_inverse_upper_arm_4;
    const ella_real modes_W_upper_arm_51 = t307 * modes_inverse_upper_arm_5;
    const ella_real modes_W_upper_arm_52 = t308 * modes_inverse_upper_arm_5;
    const ella_real modes_W_upper_arm_53 = t309 * modes_inverse_upper_arm_5;
    const ella_real modes_W_upper_arm_61 = t313 * modes_inverse_upper_arm_6;
    const ella_real modes_W_upper_arm_62 = t314 * modes_inverse_upper_arm_6;
    const ella_real modes_W_upper_arm_63 = t315 * modes_inverse_upper_arm_6;
    const ella_real modes_W_upper_arm_71 = t319 * modes_inverse_upper_arm_7;
    const ella_real modes_W_upper_arm_72 = t320 * modes_inverse_upper_arm_7;
    const ella_real modes_W_upper_arm_73 = t321 * modes_inverse_upper_arm_7;
    const ella_real modes_w_upper_arm_1 = h_phi_upper_arm_1 * modes_inverse_upper_arm_1;
    const ella_real modes_w_upper_arm_2 = t322 * modes_inverse_upper_arm_2;
    const ella_real modes_w_upper_arm_3 = t323 * modes_inverse_upper_arm_3;
    const ella_real modes_w_upper_arm_4 = t324 * modes_inverse_upper_arm_4;
    const ella_real modes_w_upper_arm_5 = t326 * modes_inverse_upper_arm_5;
    const ella_real modes_w_upper_arm_6 = t328 * modes_inverse_upper_arm_6;
    const ella_real modes_w_upper_arm_7 = t330 * modes_inverse_upper_arm_7;
    const ella_real t331 = C_upper_arm_11 * modes_W_upper_arm_11 + t295 * modes_W_upper_arm_21
        + t298 * modes_W_upper_arm_31;
    const ella_real t332 = t331 + t301 * modes_W_upper_arm_41 + t307 * modes_W_upper_arm_51
        + t313 * modes_W_upper_arm_61 + t319 * modes_W_upper_arm_71;
    const ella_real M_i_upper_arm_11 = M_loaded_upper_arm_11 - t332;
    const ella_real t333 = C_upper_arm_11 * modes_W_upper_arm_12 + t295 * modes_W_upper_arm_22
        + t298 * modes_W_upper_arm_32;
    const ella_real t334 = t333 + t301 * modes_W_upper_arm_42 + t307 * modes_W_upper_arm_52
        + t313 * modes_W_upper_arm_62 + t319 * modes_W_upper_arm_72;
    const ella_real M_i_upper_arm_12 = M_loaded_upper_arm_12 - t334;
    const ella_real t335 = C_upper_arm_11 * modes_W_upper_arm_13 + t295 * modes_W_upper_arm_23
        + t298 * modes_W_upper_arm_33;
    const ella_real t336 = t335 + t301 * modes_W_upper_arm_43 + t307 * modes_W_upper_arm_53
        + t313 * modes_W_upper_arm_63 + t319 * modes_W_upper_arm_73;
    const ella_real M_i_upper_arm_13 = M_loaded_upper_arm_13 - t336;
    const ella_real t337 = C_upper_arm_21 * modes_W_upper_arm_12 + t296 * modes_W_upper_arm_22
        + t299 * modes_W_upper_arm_32;
    const ella_real t338 = t337 + t302 * modes_W_upper_arm_42 + t308 * modes_W_upper_arm_52
        + t314 * modes_W_upper_arm_62 + t320 * modes_W_upper_arm_72;
    const ella_real M_i_upper_arm_22 = M_loaded_upper_arm_22 - t338;
    const ella_real t339 = C_upper_arm_21 * modes_W_upper_arm_13 + t296 * modes_W_upper_arm_23
        + t299 * modes_W_upper_arm_33;
    const ella_real t340 = t339 + t302 * modes_W_upper_arm_43 + t308 * modes_W_upper_arm_53
        + t314 * modes_W_upper_arm_63 + t320 * modes_W_upper_arm_73;
    const ella_real M_i_upper_arm_23 = M_loaded_upper_arm_23 - t340;
    const ella_real t341 = C_upper_arm_31 * modes_W_upper_arm_13 + t297 * modes_W_upper_arm_23
        + t300 * modes_W_upper_arm_33;
    const ella_real t342 = t341 + t303 * modes_W_upper_arm_43 + t309 * modes_W_upper_arm_53
        + t315 * modes_W_upper_arm_63 + t321 * modes_W_upper_arm_73;
    const ella_real M_i_upper_arm_33 = M_loaded_upper_arm_33 - t342;
    const ella_real t343 = modes_W_upper_arm_11 * h_phi_upper_arm_1 + modes_W_upper_arm_21 * t322
        + modes_W_upper_arm_31 * t323;
    const ella_real t344 = t343 + modes_W_upper_arm_41 * t324 + modes_W_upper_arm_51 * t326
        + modes_W_upper_arm_61 * t328 + modes_W_upper_arm_71 * t330;
    const ella_real t345 = modes_W_upper_arm_12 * h_phi_upper_arm_1 + modes_W_upper_arm_22 * t322
        + modes_W_upper_arm_32 * t323;
    const ella_real t346 = t345 + modes_W_upper_arm_42 * t324 + modes_W_upper_arm_52 * t326
        + modes_W_upper_arm_62 * t328 + modes_W_upper_arm_72 * t330;
    const ella_real t347 = modes_W_upper_arm_13 * h_phi_upper_arm_1 + modes_W_upper_arm_23 * t322
        + modes_W_upper_arm_33 * t323;
    const ella_real t348 = t347 + modes_W_upper_arm_43 * t324 + modes_W_upper_arm_53 * t326
        + modes_W_upper_arm_63 * t328 + modes_W_upper_arm_73 * t330;
    const ella_real h_i_upper_arm_tau_x = h_loaded_upper_arm_tau_x - t344;
    const ella_real h_i_upper_arm_tau_y = h_loaded_upper_arm_tau_y - t346;
    const ella_real h_i_upper_arm_tau_z = h_loaded_upper_arm_tau_z - t348;

    /* upper_arm, joint: its accelerations eliminated from its rows (43) */
    const ella_real U_upper_arm_11 = M_i_upper_arm_11 * R_rel_upper_arm_yx + M_i_upper_arm_12 * R_rel_upper_arm_yy;
    const ella_real U_upper_arm_21 = M_i_upper_arm_12 * R_rel_upper_arm_yx + M_i_upper_arm_22 * R_rel_upper_arm_yy;
    const ella_real U_upper_arm_31 = M_i_upper_arm_13 * R_rel_upper_arm_yx + M_i_upper_arm_23 * R_rel_upper_arm_yy;
    const ella_real joint_inertia_upper_arm_11 = R_rel_upper_arm_yx * U_upper_arm_11
        + R_rel_upper_arm_yy * U_upper_arm_21;
    const ella_real t349 = t124 * (M_i_upper_arm_11 + M_i_upper_arm_22 + M_i_upper_arm_33);
    bad |= (unsigned long)(!(joint_inertia_upper_arm_11 - t349 > 0)) << 0;
    const ella_real joint_inverse_upper_arm_1 = 1 / joint_inertia_upper_arm_11;
    const ella_real joint_L_upper_arm_21 = U_upper_arm_31 * joint_inverse_upper_arm_1;
    const ella_real t350 = M_i_upper_arm_33 - U_upper_arm_31 * joint_L_upper_arm_21;
    bad |= (unsigned long)(!(t350 - t349 > 0)) << 0;
    const ella_real joint_inverse_upper_arm_2 = 1 / t350;
    const ella_real t351 = input->tau[0]
        - (R_rel_upper_arm_yx * h_i_upper_arm_tau_x + R_rel_upper_arm_yy * h_i_upper_arm_tau_y);
    const ella_real t352 = input->tau[1] - h_i_upper_arm_tau_z - joint_L_upper_arm_21 * t351;
    const ella_real joint_w_upper_arm_1 = t351 * joint_inverse_upper_arm_1;
    const ella_real joint_w_upper_arm_2 = t352 * joint_inverse_upper_arm_2;
    output->vdot[1] = joint_w_upper_arm_2;

    /* upper_arm, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const ella_real qddot_upper_arm_1 = joint_w_upper_arm_1 - joint_L_upper_arm_21 * joint_w_upper_arm_2;
    output->vdot[0] = qddot_upper_arm_1;

    /* upper_arm, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const ella_real delta_upper_arm_alpha_x = R_rel_upper_arm_yx * qddot_upper_arm_1;
    const ella_real delta_upper_arm_alpha_y = R_rel_upper_arm_yy * qddot_upper_arm_1;
    const ella_real t353 = modes_W_upper_arm_11 * delta_upper_arm_alpha_x
        + modes_W_upper_arm_12 * delta_upper_arm_alpha_y + modes_W_upper_arm_13 * joint_w_upper_arm_2;
    const ella_real t354 = modes_W_upper_arm_21 * delta_upper_arm_alpha_x
        + modes_W_upper_arm_22 * delta_upper_arm_alpha_y + modes_W_upper_arm_23 * joint_w_upper_arm_2;
    const ella_real t355 = modes_W_upper_arm_31 * delta_upper_arm_alpha_x
        + modes_W_upper_arm_32 * delta_upper_arm_alpha_y + modes_W_upper_arm_33 * joint_w_upper_arm_2;
    const ella_real t356 = -(modes_W_upper_arm_41 * delta_upper_arm_alpha_x
        + modes_W_upper_arm_42 * delta_upper_arm_alpha_y);
    const ella_real t357 = modes_W_upper_arm_51 * delta_upper_arm_alpha_x
        + modes_W_upper_arm_52 * delta_upper_arm_alpha_y + modes_W_upper_arm_53 * joint_w_upper_arm_2;
    const ella_real t358 = modes_W_upper_arm_61 * delta_upper_arm_alpha_x
        + modes_W_upper_arm_62 * delta_upper_arm_alpha_y + modes_W_upper_arm_63 * joint_w_upper_arm_2;
    const ella_real t359 = -(modes_W_upper_arm_71 * delta_upper_arm_alpha_x
        + modes_W_upper_arm_72 * delta_upper_arm_alpha_y);
    const ella_real etaddot_upper_arm_7 = t359 - modes_W_upper_arm_73 * joint_w_upper_arm_2 - modes_w_upper_arm_7;
    output->vdot[9] = etaddot_upper_arm_7;
    const ella_real etaddot_upper_arm_6 = -(modes_w_upper_arm_6 + t358) - modes_L_upper_arm_76 * etaddot_upper_arm_7;
    output->vdot[8] = etaddot_upper_arm_6;
    const ella_real etaddot_upper_arm_5 = -(modes_w_upper_arm_5 + t357 + modes_L_upper_arm_65 * etaddot_upper_arm_6)
        - modes_L_upper_arm_75 * etaddot_upper_arm_7;
    output->vdot[7] = etaddot_upper_arm_5;
    const ella_real t360 = t356 - modes_W_upper_arm_43 * joint_w_upper_arm_2 - modes_w_upper_arm_4
        - modes_L_upper_arm_54 * etaddot_upper_arm_5;
    const ella_real etaddot_upper_arm_4 = t360 - modes_L_upper_arm_64 * etaddot_upper_arm_6
        - modes_L_upper_arm_74 * etaddot_upper_arm_7;
    output->vdot[6] = etaddot_upper_arm_4;
    const ella_real t361 = modes_w_upper_arm_3 + t355 + modes_L_upper_arm_43 * etaddot_upper_arm_4
        + modes_L_upper_arm_53 * etaddot_upper_arm_5;
    const ella_real etaddot_upper_arm_3 = -(t361 + modes_L_upper_arm_63 * etaddot_upper_arm_6)
        - modes_L_upper_arm_73 * etaddot_upper_arm_7;
    output->vdot[5] = etaddot_upper_arm_3;
    const ella_real t362 = modes_w_upper_arm_2 + t354 + modes_L_upper_arm_32 * etaddot_upper_arm_3
        + modes_L_upper_arm_42 * etaddot_upper_arm_4;
    const ella_real t363 = -(t362 + modes_L_upper_arm_52 * etaddot_upper_arm_5
        + modes_L_upper_arm_62 * etaddot_upper_arm_6);
    const ella_real etaddot_upper_arm_2 = t363 - modes_L_upper_arm_72 * etaddot_upper_arm_7;
    output->vdot[4] = etaddot_upper_arm_2;
    const ella_real t364 = -(modes_w_upper_arm_1 + t353 + modes_L_upper_arm_21 * etaddot_upper_arm_2)
        - modes_L_upper_arm_31 * etaddot_upper_arm_3;
    const ella_real t365 = t364 - modes_L_upper_arm_41 * etaddot_upper_arm_4
        - modes_L_upper_arm_51 * etaddot_upper_arm_5 - modes_L_upper_arm_61 * etaddot_upper_arm_6;
    const ella_real etaddot_upper_arm_1 = t365 - modes_L_upper_arm_71 * etaddot_upper_arm_7;
    output->vdot[3] = etaddot_upper_arm_1;

    /* upper_arm, tip: what is added to the acceleration of the tip section (accconst1b) */
    const ella_real t366 = etaddot_upper_arm_7 * ELLA_REAL(1.7320508075688772);
    const ella_real t367 = c->links[0].Psi_c_y4 * etaddot_upper_arm_4 + c->links[0].Psi_c_y5 * etaddot_upper_arm_5
        + c->links[0].Psi_c_y6 * etaddot_upper_arm_6;
    const ella_real t368 = c->links[0].Psi_c_z1 * etaddot_upper_arm_1 + c->links[0].Psi_c_z2 * etaddot_upper_arm_2
        + c->links[0].Psi_c_z3 * etaddot_upper_arm_3;
    const ella_real t369 = etaddot_upper_arm_1 * ELLA_REAL(2.0011941703010714)
        + etaddot_upper_arm_2 * ELLA_REAL(2.0700807911885764) + etaddot_upper_arm_3 * ELLA_REAL(3.5651069283690613);
    const ella_real t370 = etaddot_upper_arm_4 * ELLA_REAL(2.0011941703010714)
        + etaddot_upper_arm_5 * ELLA_REAL(2.0700807911885764) + etaddot_upper_arm_6 * ELLA_REAL(3.5651069283690613);
    const ella_real delta_T_upper_arm_a_x = delta_upper_arm_alpha_y * r_T_upper_arm_z
        - joint_w_upper_arm_2 * r_T_upper_arm_y;
    const ella_real delta_T_upper_arm_alpha_x = delta_upper_arm_alpha_x
        + (J_l_upper_arm_xx * t366 + J_l_upper_arm_xy * t367 + J_l_upper_arm_xz * t368);
    const ella_real delta_T_upper_arm_alpha_y = delta_upper_arm_alpha_y
        + (J_l_upper_arm_yx * t366 + J_l_upper_arm_yy * t367 + J_l_upper_arm_yz * t368);
    const ella_real delta_T_upper_arm_alpha_z = joint_w_upper_arm_2
        + (J_l_upper_arm_zx * t366 + J_l_upper_arm_zy * t367 + J_l_upper_arm_zz * t368);
    const ella_real delta_T_upper_arm_a_y = joint_w_upper_arm_2 * c->links[0].length
        - delta_upper_arm_alpha_x * r_T_upper_arm_z + t369;
    const ella_real delta_T_upper_arm_a_z = delta_upper_arm_alpha_x * r_T_upper_arm_y
        - delta_upper_arm_alpha_y * c->links[0].length + t370;

    /* forearm, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const ella_real carried_forearm_alpha_x = R_P_forearm_xx * delta_T_upper_arm_alpha_x
        + R_P_forearm_yx * delta_T_upper_arm_alpha_y + R_P_forearm_zx * delta_T_upper_arm_alpha_z;
    const ella_real carried_forearm_alpha_y = R_P_forearm_xy * delta_T_upper_arm_alpha_x
        + R_P_forearm_yy * delta_T_upper_arm_alpha_y + R_P_forearm_zy * delta_T_upper_arm_alpha_z;
    const ella_real carried_forearm_alpha_z = R_T_upper_arm_xz * delta_T_upper_arm_alpha_x
        + R_T_upper_arm_yz * delta_T_upper_arm_alpha_y + R_T_upper_arm_zz * delta_T_upper_arm_alpha_z;
    const ella_real carried_forearm_a_x = R_P_forearm_xx * delta_T_upper_arm_a_x
        + R_P_forearm_yx * delta_T_upper_arm_a_y + R_P_forearm_zx * delta_T_upper_arm_a_z;
    const ella_real carried_forearm_a_y = R_P_forearm_xy * delta_T_upper_arm_a_x
        + R_P_forearm_yy * delta_T_upper_arm_a_y + R_P_forearm_zy * delta_T_upper_arm_a_z;
    const ella_real carried_forearm_a_z = R_T_upper_arm_xz * delta_T_upper_arm_a_x
        + R_T_upper_arm_yz * delta_T_upper_arm_a_y + R_T_upper_arm_zz * delta_T_upper_arm_a_z;
    const ella_real t371 = minus_joint_W_forearm_11 * carried_forearm_alpha_x
        + minus_joint_W_forearm_12 * carried_forearm_alpha_y;
    const ella_real t372 = carried_forearm_alpha_z - t371 - minus_joint_W_forearm_14 * carried_forearm_a_x
        + joint_W_forearm_15 * carried_forearm_a_y;
    const ella_real qddot_forearm_1 = joint_w_forearm_1 - t372;
    output->vdot[2] = qddot_forearm_1;

    /* forearm, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const ella_real delta_forearm_alpha_z = carried_forearm_alpha_z + qddot_forearm_1;
    const ella_real t373 = modes_W_forearm_13 * delta_forearm_alpha_z
        - minus_modes_W_forearm_11 * carried_forearm_alpha_x + modes_W_forearm_15 * carried_forearm_a_y;
    const ella_real t374 = modes_W_forearm_21 * carried_forearm_alpha_x + modes_W_forearm_23 * delta_forearm_alpha_z
        + modes_W_forearm_25 * carried_forearm_a_y;
    const ella_real t375 = modes_W_forearm_31 * carried_forearm_alpha_x + modes_W_forearm_33 * delta_forearm_alpha_z
        + modes_W_forearm_35 * carried_forearm_a_y;
    const ella_real t376 = modes_W_forearm_41 * carried_forearm_alpha_x
        - minus_modes_W_forearm_42 * carried_forearm_alpha_y;
    const ella_real t377 = modes_W_forearm_51 * carried_forearm_alpha_x + modes_W_forearm_52 * carried_forearm_alpha_y
        + modes_W_forearm_56 * carried_forearm_a_z;
    const ella_real t378 = modes_W_forearm_61 * carried_forearm_alpha_x + modes_W_forearm_62 * carried_forearm_alpha_y
        + modes_W_forearm_66 * carried_forearm_a_z;
    const ella_real etaddot_forearm_3 = -t375 - modes_w_forearm_3;
    output->vdot[12] = etaddot_forearm_3;
    const ella_real etaddot_forearm_6 = -t378 - modes_w_forearm_6;
    output->vdot[15] = etaddot_forearm_6;
    const ella_real etaddot_forearm_7 = -(modes_w_forearm_7 + modes_W_forearm_71 * carried_forearm_alpha_x);
    output->vdot[16] = etaddot_forearm_7;
    const ella_real etaddot_forearm_5 = -(modes_w_forearm_5 + t377) - modes_L_forearm_65 * etaddot_forearm_6;
    output->vdot[14] = etaddot_forearm_5;
    const ella_real t379 = modes_w_forearm_4 + (t376 + modes_W_forearm_46 * carried_forearm_a_z)
        + modes_L_forearm_54 * etaddot_forearm_5;
    const ella_real etaddot_forearm_4 = -(t379 + modes_L_forearm_64 * etaddot_forearm_6);
    output->vdot[13] = etaddot_forearm_4;
    const ella_real etaddot_forearm_2 = -(modes_w_forearm_2 + t374) - modes_L_forearm_32 * etaddot_forearm_3;
    output->vdot[11] = etaddot_forearm_2;
    const ella_real t380 = modes_w_forearm_1 + t373 + modes_L_forearm_21 * etaddot_forearm_2
        + modes_L_forearm_31 * etaddot_forearm_3;
    output->vdot[10] = -t380;

    if (wanted & ELLA_WRENCHES) {
        /* upper_arm, Sdot: rate of the first moment */
        const ella_real Sdot_upper_arm_y = state->v[3] * c->links[0].sigma_y1 + state->v[4] * c->links[0].sigma_y2
            + state->v[5] * c->links[0].sigma_y3;
        const ella_real Sdot_upper_arm_z = state->v[6] * c->links[0].sigma_y1 + state->v[7] * c->links[0].sigma_y2
            + state->v[8] * c->links[0].sigma_y3;

        /* upper_arm, h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
        const ella_real h_c_upper_arm_f_x = Sdot_upper_arm_z * omega_J_upper_arm_y - Sdot_upper_arm_y * state->v[1];
        const ella_real minus_h_c_upper_arm_f_y = Sdot_upper_arm_z * omega_J_upper_arm_x;
        const ella_real h_c_upper_arm_f_z = Sdot_upper_arm_y * omega_J_upper_arm_x;

        /* upper_arm, H_star: gyroscopic wrench and weight, angular acceleration included */
        const ella_real t381 = h_c_upper_arm_f_x - minus_Omega_upper_arm_xx * c->links[0].S_0_x
            + Omega_upper_arm_xy * S_upper_arm_y;
        const ella_real H_star_upper_arm_f_x = t381 + Omega_upper_arm_xz * S_upper_arm_z
            + acc_0_upper_arm_a_x * c->links[0].mu;
        const ella_real t382 = Omega_upper_arm_xy * c->links[0].S_0_x - minus_h_c_upper_arm_f_y
            - minus_Omega_upper_arm_yy * S_upper_arm_y;
        const ella_real H_star_upper_arm_f_y = t382 + Omega_upper_arm_yz * S_upper_arm_z
            + acc_0_upper_arm_a_y * c->links[0].mu;
        const ella_real t383 = h_c_upper_arm_f_z + Omega_upper_arm_zx * c->links[0].S_0_x
            + Omega_upper_arm_zy * S_upper_arm_y - minus_Omega_upper_arm_zz * S_upper_arm_z;
        const ella_real H_star_upper_arm_f_z = t383 - minus_acc_0_upper_arm_a_z * c->links[0].mu;

        /* upper_arm, h_V: bias of the twist rows, angular acceleration included */
        const ella_real h_V_upper_arm_f_x = H_star_upper_arm_f_x + h_c_upper_arm_f_x;
        const ella_real h_V_upper_arm_f_y = H_star_upper_arm_f_y - minus_h_c_upper_arm_f_y;
        const ella_real h_V_upper_arm_f_z = H_star_upper_arm_f_z + h_c_upper_arm_f_z;

        /* upper_arm, modes: the tip load folded in, modal accelerations eliminated (83) */
        const ella_real M_loaded_upper_arm_14 = Lambda_forearm_4 + (t168 - t167);
        const ella_real M_loaded_upper_arm_15 = t170 - S_upper_arm_z;
        const ella_real M_loaded_upper_arm_16 = S_upper_arm_y + t171;
        const ella_real M_loaded_upper_arm_24 = S_upper_arm_z + t172;
        const ella_real M_loaded_upper_arm_26 = t173 - c->links[0].S_0_x;
        const ella_real M_loaded_upper_arm_34 = t174 - S_upper_arm_y;
        const ella_real M_loaded_upper_arm_35 = c->links[0].S_0_x + t175;
        const ella_real h_loaded_upper_arm_f_x = h_V_upper_arm_f_x + p_T_upper_arm_f_x;
        const ella_real h_loaded_upper_arm_f_y = h_V_upper_arm_f_y + p_T_upper_arm_f_y;
        const ella_real h_loaded_upper_arm_f_z = h_V_upper_arm_f_z + p_T_upper_arm_f_z;
        const ella_real C_upper_arm_51 = c->links[0].sigma_y1 + t231;
        const ella_real C_upper_arm_52 = c->links[0].sigma_y2 + t233;
        const ella_real C_upper_arm_53 = c->links[0].sigma_y3 + t235;
        const ella_real C_upper_arm_64 = c->links[0].sigma_y1 + t246;
        const ella_real C_upper_arm_65 = c->links[0].sigma_y2 + t248;
        const ella_real C_upper_arm_66 = c->links[0].sigma_y3 + t250;
        const ella_real t384 = C_upper_arm_42 - modes_L_upper_arm_21 * C_upper_arm_41;
        const ella_real t385 = C_upper_arm_52 - modes_L_upper_arm_21 * C_upper_arm_51;
        const ella_real t386 = C_upper_arm_62 - modes_L_upper_arm_21 * C_upper_arm_61;
        const ella_real t387 = C_upper_arm_43 - modes_L_upper_arm_31 * C_upper_arm_41 - modes_L_upper_arm_32 * t384;
        const ella_real t388 = C_upper_arm_53 - modes_L_upper_arm_31 * C_upper_arm_51 - modes_L_upper_arm_32 * t385;
        const ella_real t389 = C_upper_arm_63 - modes_L_upper_arm_31 * C_upper_arm_61 - modes_L_upper_arm_32 * t386;
        const ella_real t390 = C_upper_arm_44 - modes_L_upper_arm_41 * C_upper_arm_41 - modes_L_upper_arm_42 * t384
            - modes_L_upper_arm_43 * t387;
        const ella_real t391 = C_upper_arm_54 - modes_L_upper_arm_41 * C_upper_arm_51 - modes_L_upper_arm_42 * t385
            - modes_L_upper_arm_43 * t388;
        const ella_real t392 = C_upper_arm_64 - modes_L_upper_arm_41 * C_upper_arm_61 - modes_L_upper_arm_42 * t386
            - modes_L_upper_arm_43 * t389;
        const ella_real t393 = C_upper_arm_45 - modes_L_upper_arm_51 * C_upper_arm_41 - modes_L_upper_arm_52 * t384
            - modes_L_upper_arm_53 * t387;
        const ella_real t394 = C_upper_arm_55 - modes_L_upper_arm_51 * C_upper_arm_51 - modes_L_upper_arm_52 * t385
            - modes_L_upper_arm_53 * t388;
        const ella_real t395 = C_upper_arm_65 - modes_L_upper_arm_51 * C_upper_arm_61 - modes_L_upper_arm_52 * t386
            - modes_L_upper_arm_53 * t389;
        const ella_real t396 = t393 - modes_L_upper_arm_54 * t390;
        const ella_real t397 = t394 - modes_L_upper_arm_54 * t391;
        const ella_real t398 = t395 - modes_L_upper_arm_54 * t392;
        const ella_real t399 = C_upper_arm_46 - modes_L_upper_arm_61 * C_upper_arm_41 - modes_L_upper_arm_62 * t384
            - modes_L_upper_arm_63 * t387;
        const ella_real t400 = C_upper_arm_56 - modes_L_upper_arm_61 * C_upper_arm_51 - modes_L_upper_arm_62 * t385
            - modes_L_upper_arm_63 * t388;
        const ella_real t401 = C_upper_arm_66 - modes_L_upper_arm_61 * C_upper_arm_61 - modes_L_upper_arm_62 * t386
            - modes_L_upper_arm_63 * t389;
        const ella_real t402 = t399 - modes_L_upper_arm_64 * t390 - modes_L_upper_arm_65 * t396;
        const ella_real t403 = t400 - modes_L_upper_arm_64 * t391 - modes_L_upper_arm_65 * t397;
        const ella_real t404 = t401 - modes_L_upper_arm_64 * t392 - modes_L_upper_arm_65 * t398;
        const ella_real t405 = C_upper_arm_47 - modes_L_upper_arm_71 * C_upper_arm_41 - modes_L_upper_arm_72 * t384
            - modes_L_upper_arm_73 * t387;
        const ella_real t406 = C_upper_arm_57 - modes_L_upper_arm_71 * C_upper_arm_51 - modes_L_upper_arm_72 * t385
            - modes_L_upper_arm_73 * t388;
        const ella_real t407 = C_upper_arm_67 - modes_L_upper_arm_71 * C_upper_arm_61 - modes_L_upper_arm_72 * t386
            - modes_L_upper_arm_73 * t389;
        const ella_real modes_W_upper_arm_14 = C_upper_arm_41 * modes_inverse_upper_arm_1;
        const ella_real modes_W_upper_arm_15 = C_upper_arm_51 * modes_inverse_upper_arm_1;
        const ella_real modes_W_upper_arm_16 = C_upper_arm_61 * modes_inverse_upper_arm_1;
        const ella_real modes_W_upper_arm_24 = t384 * modes_inverse_upper_arm_2;
        const ella_real modes_W_upper_arm_25 = t385 * modes_inverse_upper_arm_2;
        const ella_real modes_W_upper_arm_26 = t386 * modes_inverse_upper_arm_2;
        const ella_real modes_W_upper_arm_34 = t387 * modes_inverse_upper_arm_3;
        const ella_real modes_W_upper_arm_35 = t388 * modes_inverse_upper_arm_3;
        const ella_real modes_W_upper_arm_36 = t389 * modes_inverse_upper_arm_3;
        const ella_real modes_W_upper_arm_44 = t390 * modes_inverse_upper_arm_4;
        const ella_real modes_W_upper_arm_45 = t391 * modes_inverse_upper_arm_4;
        const ella_real modes_W_upper_arm_46 = t392 * modes_inverse_upper_arm_4;
        const ella_real modes_W_upper_arm_54 = t396 * modes_inverse_upper_arm_5;
        const ella_real modes_W_upper_arm_55 = t397 * modes_inverse_upper_arm_5;
        const ella_real modes_W_upper_arm_56 = t398 * modes_inverse_upper_arm_5;
        const ella_real modes_W_upper_arm_64 = t402 * modes_inverse_upper_arm_6;
        const ella_real modes_W_upper_arm_65 = t403 * modes_inverse_upper_arm_6;
        const ella_real modes_W_upper_arm_66 = t404 * modes_inverse_upper_arm_6;
        const ella_real modes_W_upper_arm_74 = (t405 - modes_L_upper_arm_74 * t390 - modes_L_upper_arm_75 * t396
            - modes_L_upper_arm_76 * t402) * modes_inverse_upper_arm_7;
        const ella_real modes_W_upper_arm_75 = (t406 - modes_L_upper_arm_74 * t391 - modes_L_upper_arm_75 * t397
            - modes_L_upper_arm_76 * t403) * modes_inverse_upper_arm_7;
        const ella_real modes_W_upper_arm_76 = (t407 - modes_L_upper_arm_74 * t392 - modes_L_upper_arm_75 * t398
            - modes_L_upper_arm_76 * t404) * modes_inverse_upper_arm_7;
        const ella_real t408 = C_upper_arm_11 * modes_W_upper_arm_14 + t295 * modes_W_upper_arm_24
            + t298 * modes_W_upper_arm_34;
        const ella_real t409 = t408 + t301 * modes_W_upper_arm_44 + t307 * modes_W_upper_arm_54
            + t313 * modes_W_upper_arm_64 + t319 * modes_W_upper_arm_74;
        const ella_real M_i_upper_arm_14 = M_loaded_upper_arm_14 - t409;
        const ella_real t410 = C_upper_arm_11 * modes_W_upper_arm_15 + t295 * modes_W_upper_arm_25
            + t298 * modes_W_upper_arm_35;
        const ella_real t411 = t410 + t301 * modes_W_upper_arm_45 + t307 * modes_W_upper_arm_55
            + t313 * modes_W_upper_arm_65 + t319 * modes_W_upper_arm_75;
        const ella_real M_i_upper_arm_15 = M_loaded_upper_arm_15 - t411;
        const ella_real t412 = C_upper_arm_11 * modes_W_upper_arm_16 + t295 * modes_W_upper_arm_26
            + t298 * modes_W_upper_arm_36;
        const ella_real t413 = t412 + t301 * modes_W_upper_arm_46 + t307 * modes_W_upper_arm_56
            + t313 * modes_W_upper_arm_66 + t319 * modes_W_upper_arm_76;
        const ella_real M_i_upper_arm_16 = M_loaded_upper_arm_16 - t413;
        const ella_real t414 = C_upper_arm_21 * modes_W_upper_arm_14 + t296 * modes_W_upper_arm_24
            + t299 * modes_W_upper_arm_34;
        const ella_real t415 = t414 + t302 * modes_W_upper_arm_44 + t308 * modes_W_upper_arm_54
            + t314 * modes_W_upper_arm_64 + t320 * modes_W_upper_arm_74;
        const ella_real M_i_upper_arm_24 = M_loaded_upper_arm_24 - t415;
        const ella_real t416 = C_upper_arm_21 * modes_W_upper_arm_15 + t296 * modes_W_upper_arm_25
            + t299 * modes_W_upper_arm_35;
        const ella_real t417 = t416 + t302 * modes_W_upper_arm_45 + t308 * modes_W_upper_arm_55
            + t314 * modes_W_upper_arm_65 + t320 * modes_W_upper_arm_75;
        const ella_real M_i_upper_arm_25 = M_loaded_upper_arm_25 - t417;
        const ella_real t418 = C_upper_arm_21 * modes_W_upper_arm_16 + t296 * modes_W_upper_arm_26
            + t299 * modes_W_upper_arm_36;
        const ella_real t419 = t418 + t302 * modes_W_upper_arm_46 + t308 * modes_W_upper_arm_56
            + t314 * modes_W_upper_arm_66 + t320 * modes_W_upper_arm_76;
        const ella_real M_i_upper_arm_26 = M_loaded_upper_arm_26 - t419;
        const ella_real t420 = C_upper_arm_31 * modes_W_upper_arm_14 + t297 * modes_W_upper_arm_24
            + t300 * modes_W_upper_arm_34;
        const ella_real t421 = t420 + t303 * modes_W_upper_arm_44 + t309 * modes_W_upper_arm_54
            + t315 * modes_W_upper_arm_64 + t321 * modes_W_upper_arm_74;
        const ella_real M_i_upper_arm_34 = M_loaded_upper_arm_34 - t421;
        const ella_real t422 = C_upper_arm_31 * modes_W_upper_arm_15 + t297 * modes_W_upper_arm_25
            + t300 * modes_W_upper_arm_35;
        const ella_real t423 = t422 + t303 * modes_W_upper_arm_45 + t309 * modes_W_upper_arm_55
            + t315 * modes_W_upper_arm_65 + t321 * modes_W_upper_arm_75;
        const ella_real M_i_upper_arm_35 = M_loaded_upper_arm_35 - t423;
        const ella_real t424 = C_upper_arm_31 * modes_W_upper_arm_16 + t297 * modes_W_upper_arm_26
            + t300 * modes_W_upper_arm_36;
        const ella_real t425 = t424 + t303 * modes_W_upper_arm_46 + t309 * modes_W_upper_arm_56
            + t315 * modes_W_upper_arm_66 + t321 * modes_W_upper_arm_76;
        const ella_real M_i_upper_arm_36 = M_loaded_upper_arm_36 - t425;
        const ella_real t426 = modes_W_upper_arm_14 * h_phi_upper_arm_1 + modes_W_upper_arm_24 * t322
            + modes_W_upper_arm_34 * t323;
        const ella_real t427 = t426 + modes_W_upper_arm_44 * t324 + modes_W_upper_arm_54 * t326
            + modes_W_upper_arm_64 * t328 + modes_W_upper_arm_74 * t330;
        const ella_real t428 = modes_W_upper_arm_15 * h_phi_upper_arm_1 + modes_W_upper_arm_25 * t322
            + modes_W_upper_arm_35 * t323;
        const ella_real t429 = t428 + modes_W_upper_arm_45 * t324 + modes_W_upper_arm_55 * t326
            + modes_W_upper_arm_65 * t328 + modes_W_upper_arm_75 * t330;
        const ella_real t430 = modes_W_upper_arm_16 * h_phi_upper_arm_1 + modes_W_upper_arm_26 * t322
            + modes_W_upper_arm_36 * t323;
        const ella_real t431 = t430 + modes_W_upper_arm_46 * t324 + modes_W_upper_arm_56 * t326
            + modes_W_upper_arm_66 * t328 + modes_W_upper_arm_76 * t330;
        const ella_real h_i_upper_arm_f_x = h_loaded_upper_arm_f_x - t427;
        const ella_real h_i_upper_arm_f_y = h_loaded_upper_arm_f_y - t429;
        const ella_real h_i_upper_arm_f_z = h_loaded_upper_arm_f_z - t431;

        /* upper_arm, joint: its accelerations eliminated from its rows (43) */
        const ella_real U_upper_arm_41 = M_i_upper_arm_14 * R_rel_upper_arm_yx + M_i_upper_arm_24 * R_rel_upper_arm_yy;
        const ella_real U_upper_arm_51 = M_i_upper_arm_15 * R_rel_upper_arm_yx + M_i_upper_arm_25 * R_rel_upper_arm_yy;
        const ella_real U_upper_arm_61 = M_i_upper_arm_16 * R_rel_upper_arm_yx + M_i_upper_arm_26 * R_rel_upper_arm_yy;
        const ella_real t432 = U_upper_arm_11 * joint_w_upper_arm_1
            + (M_i_upper_arm_13 - joint_L_upper_arm_21 * U_upper_arm_11) * joint_w_upper_arm_2;
        const ella_real t433 = U_upper_arm_21 * joint_w_upper_arm_1
            + (M_i_upper_arm_23 - joint_L_upper_arm_21 * U_upper_arm_21) * joint_w_upper_arm_2;
        const ella_real t434 = U_upper_arm_41 * joint_w_upper_arm_1
            + (M_i_upper_arm_34 - joint_L_upper_arm_21 * U_upper_arm_41) * joint_w_upper_arm_2;
        const ella_real t435 = U_upper_arm_51 * joint_w_upper_arm_1
            + (M_i_upper_arm_35 - joint_L_upper_arm_21 * U_upper_arm_51) * joint_w_upper_arm_2;
        const ella_real t436 = U_upper_arm_61 * joint_w_upper_arm_1
            + (M_i_upper_arm_36 - joint_L_upper_arm_21 * U_upper_arm_61) * joint_w_upper_arm_2;
        const ella_real p_i_upper_arm_tau_x = h_i_upper_arm_tau_x + t432;
        output->wrench[0][0] = p_i_upper_arm_tau_x;
        const ella_real p_i_upper_arm_tau_y = h_i_upper_arm_tau_y + t433;
        output->wrench[0][1] = p_i_upper_arm_tau_y;
        const ella_real p_i_upper_arm_tau_z = h_i_upper_arm_tau_z + (U_upper_arm_31 * joint_w_upper_arm_1 + t352);
        output->wrench[0][2] = p_i_upper_arm_tau_z;
        const ella_real p_i_upper_arm_f_x = h_i_upper_arm_f_x + t434;
        output->wrench[0][3] = p_i_upper_arm_f_x;
        const ella_real p_i_upper_arm_f_y = h_i_upper_arm_f_y + t435;
        output->wrench[0][4] = p_i_upper_arm_f_y;
        const ella_real p_i_upper_arm_f_z = h_i_upper_arm_f_z + t436;
        output->wrench[0][5] = p_i_upper_arm_f_z;

        /* forearm, joint wrench (48) */
        const ella_real t437 = Lambda_i_forearm_11 * carried_forearm_alpha_x
            + Lambda_i_forearm_12 * carried_forearm_alpha_y - minus_Lambda_i_forearm_14 * carried_forearm_a_x;
        const ella_real t438 = Lambda_i_forearm_22 * carried_forearm_alpha_y
            + Lambda_i_forearm_12 * carried_forearm_alpha_x + Lambda_i_forearm_24 * carried_forearm_a_x;
        const ella_real t439 = Lambda_i_forearm_24 * carried_forearm_alpha_y
            - minus_Lambda_i_forearm_14 * carried_forearm_alpha_x;
        const ella_real t440 = Lambda_i_forearm_15 * carried_forearm_alpha_x
            + Lambda_i_forearm_25 * carried_forearm_alpha_y + Lambda_i_forearm_45 * carried_forearm_a_x;
        const ella_real t441 = M_i_forearm_16 * carried_forearm_alpha_x + M_i_forearm_26 * carried_forearm_alpha_y
            + M_i_forearm_66 * carried_forearm_a_z;
        const ella_real wrench_forearm_tau_x = t437 + Lambda_i_forearm_15 * carried_forearm_a_y
            + M_i_forearm_16 * carried_forearm_a_z + p_i_forearm_tau_x;
        output->wrench[1][0] = wrench_forearm_tau_x;
        const ella_real wrench_forearm_tau_y = t438 + Lambda_i_forearm_25 * carried_forearm_a_y
            + M_i_forearm_26 * carried_forearm_a_z + p_i_forearm_tau_y;
        output->wrench[1][1] = wrench_forearm_tau_y;
        const ella_real wrench_forearm_f_x = t439 + Lambda_i_forearm_44 * carried_forearm_a_x
            + Lambda_i_forearm_45 * carried_forearm_a_y + p_i_forearm_f_x;
        output->wrench[1][3] = wrench_forearm_f_x;
        const ella_real wrench_forearm_f_y = t440 + Lambda_i_forearm_55 * carried_forearm_a_y + p_i_forearm_f_y;
        output->wrench[1][4] = wrench_forearm_f_y;
        const ella_real wrench_forearm_f_z = t441 + h_i_forearm_f_z;
        output->wrench[1][5] = wrench_forearm_f_z;

        /* outputs */
        output->wrench[1][2] = input->tau[2];

        if (wanted & ELLA_MOTION) {
            const ella_real motion_upper_arm_4 = S_upper_arm_z * delta_upper_arm_alpha_y
                - S_upper_arm_y * joint_w_upper_arm_2 + h_V_upper_arm_f_x;
            work->motion[0][3] = motion_upper_arm_4;

            /* forearm, link: what is added to the acceleration of F_i, modal accelerations (83) */
            const ella_real alpha_forearm_a_x = carried_forearm_a_x + acc_0_forearm_a_x;
            work->motion[1][2] = alpha_forearm_a_x;

            const ella_real t442 = S_forearm_z * carried_forearm_alpha_y - S_forearm_y * delta_forearm_alpha_z
                + c->links[1].mu * carried_forearm_a_x;
            const ella_real motion_forearm_4 = t442 + h_V_forearm_f_x;
            work->motion[1][3] = motion_forearm_4;

            /* outputs */
            work->motion[0][0] = omega_J_upper_arm_y;
            work->motion[0][1] = state->v[1];
            work->motion[0][2] = acc_0_upper_arm_a_x;
            work->motion[1][0] = omega_R_forearm_y;
            work->motion[1][1] = omega_forearm_z;
        }
    }

    if (wanted & ELLA_TIP_POSE) {
        /* upper_arm, pose: rotation and position of the tip section in the inertial frame (Ad) */
        const ella_real R_tip_upper_arm_xx = R_rel_upper_arm_xx * R_T_upper_arm_xx
            - minus_R_rel_upper_arm_xy * R_T_upper_arm_yx + R_rel_upper_arm_xz * R_T_upper_arm_zx;
        const ella_real R_tip_upper_arm_xy = R_rel_upper_arm_xx * R_T_upper_arm_xy
            - minus_R_rel_upper_arm_xy * R_T_upper_arm_yy + R_rel_upper_arm_xz * R_T_upper_arm_zy;
        const ella_real R_tip_upper_arm_xz = R_rel_upper_arm_xx * R_T_upper_arm_xz
            - minus_R_rel_upper_arm_xy * R_T_upper_arm_yz + R_rel_upper_arm_xz * R_T_upper_arm_zz;
        const ella_real R_tip_upper_arm_yx = R_rel_upper_arm_yx * R_T_upper_arm_xx
            + R_rel_upper_arm_yy * R_T_upper_arm_yx;
        const ella_real R_tip_upper_arm_yy = R_rel_upper_arm_yx * R_T_upper_arm_xy
            + R_rel_upper_arm_yy * R_T_upper_arm_yy;
        const ella_real R_tip_upper_arm_yz = R_rel_upper_arm_yx * R_T_upper_arm_xz
            + R_rel_upper_arm_yy * R_T_upper_arm_yz;
        const ella_real R_tip_upper_arm_zx = R_rel_upper_arm_zy * R_T_upper_arm_yx
            - minus_R_rel_upper_arm_zx * R_T_upper_arm_xx + R_rel_upper_arm_zz * R_T_upper_arm_zx;
        const ella_real R_tip_upper_arm_zy = R_rel_upper_arm_zy * R_T_upper_arm_yy
            - minus_R_rel_upper_arm_zx * R_T_upper_arm_xy + R_rel_upper_arm_zz * R_T_upper_arm_zy;
        const ella_real R_tip_upper_arm_zz = R_rel_upper_arm_zy * R_T_upper_arm_yz
            - minus_R_rel_upper_arm_zx * R_T_upper_arm_xz + R_rel_upper_arm_zz * R_T_upper_arm_zz;
        const ella_real r_tip_upper_arm_x = R_rel_upper_arm_xx * c->links[0].length
            - minus_R_rel_upper_arm_xy * r_T_upper_arm_y + R_rel_upper_arm_xz * r_T_upper_arm_z;
        const ella_real r_tip_upper_arm_y = R_rel_upper_arm_yx * c->links[0].length
            + R_rel_upper_arm_yy * r_T_upper_arm_y;
        const ella_real r_tip_upper_arm_z = R_rel_upper_arm_zy * r_T_upper_arm_y
            - minus_R_rel_upper_arm_zx * c->links[0].length + R_rel_upper_arm_zz * r_T_upper_arm_z;

        /* forearm, pose: rotation and position of F_i in the inertial frame (Ad) */
        const ella_real R_forearm_xx = R_tip_upper_arm_xx * R_rel_forearm_xx + R_tip_upper_arm_xy * R_rel_forearm_yx;
        const ella_real R_forearm_xy = R_tip_upper_arm_xy * R_rel_forearm_xx - R_tip_upper_arm_xx * R_rel_forearm_yx;
        const ella_real R_forearm_yx = R_tip_upper_arm_yx * R_rel_forearm_xx + R_tip_upper_arm_yy * R_rel_forearm_yx;
        const ella_real R_forearm_yy = R_tip_upper_arm_yy * R_rel_forearm_xx - R_tip_upper_arm_yx * R_rel_forearm_yx;
        const ella_real R_forearm_zx = R_tip_upper_arm_zx * R_rel_forearm_xx + R_tip_upper_arm_zy * R_rel_forearm_yx;
        const ella_real R_forearm_zy = R_tip_upper_arm_zy * R_rel_forearm_xx - R_tip_upper_arm_zx * R_rel_forearm_yx;

        /* forearm, pose: rotation and position of the tip section in the inertial frame (Ad) */
        const ella_real R_tip_forearm_xx = R_forearm_xx * R_T_forearm_xx + R_forearm_xy * R_T_forearm_yx
            + R_tip_upper_arm_xz * R_T_forearm_zx;
        output->tip_rotation[0][0] = R_tip_forearm_xx;
        const ella_real R_tip_forearm_xy = R_forearm_xx * R_T_forearm_xy + R_forearm_xy * R_T_forearm_yy
            + R_tip_upper_arm_xz * R_T_forearm_zy;
        output->tip_rotation[0][1] = R_tip_forearm_xy;
        const ella_real R_tip_forearm_xz = R_forearm_xx * R_T_forearm_xz + R_forearm_xy * R_T_forearm_yz
            + R_tip_upper_arm_xz * R_T_forearm_zz;
        output->tip_rotation[0][2] = R_tip_forearm_xz;
        const ella_real R_tip_forearm_yx = R_forearm_yx * R_T_forearm_xx + R_forearm_yy * R_T_forearm_yx
            + R_tip_upper_arm_yz * R_T_forearm_zx;
        output->tip_rotation[1][0] = R_tip_forearm_yx;
        const ella_real R_tip_forearm_yy = R_forearm_yx * R_T_forearm_xy + R_forearm_yy * R_T_forearm_yy
            + R_tip_upper_arm_yz * R_T_forearm_zy;
        output->tip_rotation[1][1] = R_tip_forearm_yy;
        const ella_real R_tip_forearm_yz = R_forearm_yx * R_T_forearm_xz + R_forearm_yy * R_T_forearm_yz
            + R_tip_upper_arm_yz * R_T_forearm_zz;
        output->tip_rotation[1][2] = R_tip_forearm_yz;
        const ella_real R_tip_forearm_zx = R_forearm_zx * R_T_forearm_xx + R_forearm_zy * R_T_forearm_yx
            + R_tip_upper_arm_zz * R_T_forearm_zx;
        output->tip_rotation[2][0] = R_tip_forearm_zx;
        const ella_real R_tip_forearm_zy = R_forearm_zx * R_T_forearm_xy + R_forearm_zy * R_T_forearm_yy
            + R_tip_upper_arm_zz * R_T_forearm_zy;
        output->tip_rotation[2][1] = R_tip_forearm_zy;
        const ella_real R_tip_forearm_zz = R_forearm_zx * R_T_forearm_xz + R_forearm_zy * R_T_forearm_yz
            + R_tip_upper_arm_zz * R_T_forearm_zz;
        output->tip_rotation[2][2] = R_tip_forearm_zz;
        const ella_real t443 = R_forearm_xx * c->links[1].length + R_forearm_xy * r_T_forearm_y
            + R_tip_upper_arm_xz * r_T_forearm_z;
        const ella_real t444 = R_forearm_yx * c->links[1].length + R_forearm_yy * r_T_forearm_y
            + R_tip_upper_arm_yz * r_T_forearm_z;
        const ella_real t445 = R_forearm_zx * c->links[1].length + R_forearm_zy * r_T_forearm_y
            + R_tip_upper_arm_zz * r_T_forearm_z;
        const ella_real r_tip_forearm_x = r_tip_upper_arm_x + t443;
        output->tip_position[0] = r_tip_forearm_x;
        const ella_real r_tip_forearm_y = r_tip_upper_arm_y + t444;
        output->tip_position[1] = r_tip_forearm_y;
        const ella_real r_tip_forearm_z = r_tip_upper_arm_z + t445;
        output->tip_position[2] = r_tip_forearm_z;
    }

    if (bad) {
        /* the elimination runs from the tip: report the outermost link that failed */
        for (link = 0; link < ELLA_NLINKS; ++link) {
            if ((bad >> link) & 1u) {
                work->fault = link;
            }
        }
        return ELLA_SINGULAR;
    }
    return ELLA_OK;
}

const ella_real ella_measure_bounds[ELLA_NMEASURES] = { ELLA_REAL(0.1), ELLA_REAL(0.35), ELLA_REAL(0.02),
    ELLA_REAL(0.2) };

ella_status ella_validity(const ella_constants *c, const ella_state *state, const ella_output *output,
    const ella_work *work, ella_measures *measures)
{
    ella_call call = { 0 };
    ella_status status;
    int fault = 0;
    if (!c || !state || !output || !work || !measures) {
        return ELLA_BAD_ARGUMENT;
    }
    call.eta = state->q + (ELLA_NQ - ELLA_NMODES);
    call.wrench = &output->wrench[0][0];
    call.motion = &work->motion[0][0];
    call.new_measures = &measures->value[0][0];
    status = ella_measuring(c, &call, 0, &fault);
    return ella_finite(call.new_measures, ELLA_NMEASURES * ELLA_NLINKS) ? status : ELLA_NONFINITE;
}

ella_status ella_inverse_dynamics(const ella_constants *c, const ella_state *state, const ella_input *input,
    const ella_real vdot[], ella_chain *chain, ella_real force[], ella_real wrench[][6])
{
    ella_real f_eta[ELLA_LENGTH(ELLA_NGIVEN)];
    ella_call call;
    ella_status status;
    int k, fault = 0;
    if (!c || !state || !input || !vdot || !chain || !force) {
        return ELLA_BAD_ARGUMENT;
    }
    for (k = 0; k < ELLA_NGIVEN; ++k) {
        f_eta[k] = c->K[k] * state->q[ELLA_NQ - ELLA_NGIVEN + k] + c->D[k] * state->v[ELLA_NV - ELLA_NGIVEN + k];
    }
    call = call_at(c, state, c->M_eta, f_eta);
    call.w_ext = &input->w_ext[0][0];
    call.qddot = vdot;
    call.etaddot = vdot + (ELLA_NV - ELLA_NMODES);
    call.new_force = force;
    call.new_force_eta = force + (ELLA_NV - ELLA_NMODES);
    call.new_wrench = wrench ? &wrench[0][0] : 0;
    status = ella_inverse(c, &call, chain, &fault);
    if (status == ELLA_OK && !(ella_finite(force, ELLA_NV) && ella_finite(call.w_ext, 6 * ELLA_NLINKS)
        && (!wrench || ella_finite(&wrench[0][0], 6 * ELLA_NLINKS)))) {
        return ELLA_NONFINITE;
    }
    return status;
}

ella_status ella_mass_matrix(const ella_constants *c, const ella_state *state, ella_chain *chain,
    ella_real M[][ELLA_LENGTH(ELLA_NV)])
{
    ella_real unit[ELLA_LENGTH(ELLA_NV)] = { 0 };
    ella_call call;
    ella_status status;
    int j, fault = 0;
    if (!c || !state || !chain || !M) {
        return ELLA_BAD_ARGUMENT;
    }
    call = call_at(c, state, c->M_eta, unit);
    call.qddot = unit;
    call.etaddot = unit + (ELLA_NV - ELLA_NMODES);
    if (!ella_finite(state->q, ELLA_NQ)) {
        return ELLA_NONFINITE;
    }
    status = ella_inertia_posture(c, &call, chain, &fault);
    for (j = 0; j < ELLA_NV && status == ELLA_OK; ++j) {
        unit[j] = 1;
        call.new_force = M[j];
        call.new_force_eta = M[j] + (ELLA_NV - ELLA_NMODES);
        status = ella_inertia_column(c, &call, chain, &fault);
        unit[j] = 0;
        if (!ella_finite(M[j], ELLA_NV)) {
            status = ELLA_NONFINITE;
        }
    }
    return status;
}
