/* six_link_dynamics.c: forward dynamics of the joint form by block elimination, tip to base;
 * inverse dynamics and mass matrix.
 */
/* Long straight lines: GCC schedules them before it hands out registers on most processors, on x86 only where it is
 * told to, and makes vectors of neighbours there, which takes longer than it saves. Results are the same to the bit.
 */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#pragma GCC optimize("no-tree-slp-vectorize", "schedule-insns", "sched-pressure")
#endif
#include "six_link_links.h"

/* The call at a state, with inertia m and force f of the coordinates that have their own. */
static six_link_call call_at(const six_link_constants *c, const six_link_state *state, const six_link_real *m,
    const six_link_real *f)
{
    six_link_call call = { 0 };
    call.gravity = c->gravity;
    call.q = state->q;
    call.qdot = state->v;
    call.eta = state->q + (SIX_LINK_NQ - SIX_LINK_NMODES);
    call.etadot = state->v + (SIX_LINK_NV - SIX_LINK_NMODES);
    call.m_q = m;
    call.f_q = f;
    call.m_eta = m + (SIX_LINK_NGIVEN - SIX_LINK_NMODES);
    call.f_eta = f + (SIX_LINK_NGIVEN - SIX_LINK_NMODES);
    return call;
}

/* The whole chain in one function: outward kinematics, inward elimination, outward accelerations. */
SIX_LINK_TARGETS six_link_status six_link_dynamics(const six_link_constants *c, const six_link_state *state,
    const six_link_input *input,
    const six_link_real *m_eta, six_link_work *work, int wanted, six_link_output *output)
{
    unsigned long bad = 0; /* bit i: the joint or a mode of link i cannot be solved for */
    int link;

    /* shoulder, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn = six_link_sine_cosine(state->q[0]);
    const six_link_real R_rel_shoulder_yx = turn.sine, R_rel_shoulder_xx = turn.cosine;

    /* shoulder, acceleration of the parent's tip in F_i axes */
    const six_link_real minus_a_J_shoulder_x = R_rel_shoulder_xx * c->gravity[0] + R_rel_shoulder_yx * c->gravity[1];
    const six_link_real a_J_shoulder_y = R_rel_shoulder_yx * c->gravity[0] - R_rel_shoulder_xx * c->gravity[1];

    /* shoulder, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real minus_Omega_shoulder_xx = state->v[0] * state->v[0];
    const six_link_real minus_a_t_shoulder_x = minus_a_J_shoulder_x + c->links[0].length * minus_Omega_shoulder_xx;

    /* upper_arm, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_2 = six_link_sine_cosine(state->q[1]);
    const six_link_real R_rel_upper_arm_xz = turn_2.sine, R_rel_upper_arm_xx = turn_2.cosine;

    /* upper_arm, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real minus_omega_R_upper_arm_x = R_rel_upper_arm_xz * state->v[0];
    const six_link_real omega_R_upper_arm_z = R_rel_upper_arm_xx * state->v[0];

    /* upper_arm, acceleration of the parent's tip in F_i axes */
    const six_link_real t1 = R_rel_upper_arm_xz * c->gravity[2] - R_rel_upper_arm_xx * minus_a_t_shoulder_x;
    const six_link_real t2 = R_rel_upper_arm_xz * minus_a_t_shoulder_x + R_rel_upper_arm_xx * c->gravity[2];

    /* upper_arm, alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real minus_alpha_upper_arm_x = omega_R_upper_arm_z * state->v[1];
    const six_link_real minus_alpha_upper_arm_z = minus_omega_R_upper_arm_x * state->v[1];

    /* upper_arm, r_R: joint point relative to the parent's tip point */
    const six_link_real r_R_upper_arm_x = R_rel_upper_arm_xx * c->links[1].mount_xyz_x
        - R_rel_upper_arm_xz * c->links[1].mount_xyz_z;
    const six_link_real r_R_upper_arm_z = R_rel_upper_arm_xz * c->links[1].mount_xyz_x
        + R_rel_upper_arm_xx * c->links[1].mount_xyz_z;

    /* upper_arm, a_J: acceleration of the joint point while no joint accelerates (accconst4) */
    const six_link_real t3 = omega_R_upper_arm_z * r_R_upper_arm_x + minus_omega_R_upper_arm_x * r_R_upper_arm_z;
    const six_link_real a_J_upper_arm_x = t1 - omega_R_upper_arm_z * t3;
    const six_link_real a_J_upper_arm_y = a_J_shoulder_y
        - omega_R_upper_arm_z * (c->links[1].mount_xyz_y * omega_R_upper_arm_z)
        - minus_omega_R_upper_arm_x * (c->links[1].mount_xyz_y * minus_omega_R_upper_arm_x);
    const six_link_real minus_a_J_upper_arm_z = t2 + minus_omega_R_upper_arm_x * t3;

    /* upper_arm, r_T: tip point (11) */
    const six_link_real r_T_upper_arm_y = state->q[7] * SIX_LINK_REAL(2.8145226674626453)
        + state->q[6] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_upper_arm_z = state->q[9] * SIX_LINK_REAL(2.8145226674626453)
        + state->q[8] * SIX_LINK_REAL(2.0195202782688155);

    /* upper_arm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_upper_arm_x = state->q[10] * SIX_LINK_REAL(1.7320508075688772);
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
    const six_link_real c2_upper_arm = SIX_LINK_REAL(0.5) - x_upper_arm * t7;

    /* upper_arm, c3: Stumpff function of order 3 */
    const six_link_real t8 = six_link_c5(x_upper_arm);
    const six_link_real c3_upper_arm = SIX_LINK_REAL(0.16666666666666666) - x_upper_arm * t8;

    /* upper_arm, udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_upper_arm_y = state->v[7] * SIX_LINK_REAL(2.8145226674626453)
        + state->v[6] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_upper_arm_z = state->v[9] * SIX_LINK_REAL(2.8145226674626453)
        + state->v[8] * SIX_LINK_REAL(2.0195202782688155);

    /* upper_arm, thetadot: rate of the tip's rotation vector */
    const six_link_real thetadot_upper_arm_x = state->v[10] * SIX_LINK_REAL(1.7320508075688772);
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
    const six_link_real t15 = state->q[10] * SIX_LINK_REAL(3.4641016151377544) * thetadot_upper_arm_x
        + theta_upper_arm_y * 2 * thetadot_upper_arm_y;
    const six_link_real xdot_upper_arm = t15 + theta_upper_arm_z * 2 * thetadot_upper_arm_z;

    /* upper_arm, c2dot: rate of c2 */
    const six_link_real c2dot_upper_arm = xdot_upper_arm * (t7 - c3_upper_arm * SIX_LINK_REAL(0.5));

    /* upper_arm, c3dot: rate of c3 */
    const six_link_real c3dot_upper_arm = xdot_upper_arm * (t8 * SIX_LINK_REAL(1.5) - t7 * SIX_LINK_REAL(0.5));

    /* upper_arm, alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_upper_arm_x = c2dot_upper_arm * t9
        + c3_upper_arm * (thetadot_upper_arm_y * t10 - thetadot_upper_arm_z * t11) + c3dot_upper_arm * t12;
    const six_link_real alpha_s_upper_arm_y = c2dot_upper_arm * t11
        + c3_upper_arm * (thetadot_upper_arm_z * t9 - thetadot_upper_arm_x * t10) + c3dot_upper_arm * t13;
    const six_link_real alpha_s_upper_arm_z = c2dot_upper_arm * t10
        + c3_upper_arm * (thetadot_upper_arm_x * t11 - thetadot_upper_arm_y * t9) + c3dot_upper_arm * t14;

    /* upper_arm, omega_t: angular velocity of the tip section (46) */
    const six_link_real omega_t_upper_arm_x = omega_s_upper_arm_x - minus_omega_R_upper_arm_x;
    const six_link_real omega_t_upper_arm_y = omega_s_upper_arm_y + state->v[1];
    const six_link_real omega_t_upper_arm_z = omega_s_upper_arm_z + omega_R_upper_arm_z;

    /* upper_arm, alpha_t: angular acceleration of the tip section (accconst1b) */
    const six_link_real alpha_t_upper_arm_x = alpha_s_upper_arm_x - minus_alpha_upper_arm_x
        + omega_s_upper_arm_z * state->v[1] - omega_s_upper_arm_y * omega_R_upper_arm_z;
    const six_link_real alpha_t_upper_arm_y = alpha_s_upper_arm_y + omega_s_upper_arm_x * omega_R_upper_arm_z
        + omega_s_upper_arm_z * minus_omega_R_upper_arm_x;
    const six_link_real alpha_t_upper_arm_z = alpha_s_upper_arm_z - minus_alpha_upper_arm_z
        - omega_s_upper_arm_y * minus_omega_R_upper_arm_x - omega_s_upper_arm_x * state->v[1];

    /* upper_arm, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t16 = udot_T_upper_arm_z * 2 - minus_omega_R_upper_arm_x * r_T_upper_arm_y
        - c->links[1].length * state->v[1];
    const six_link_real t17 = udot_T_upper_arm_y * 2 + c->links[1].length * omega_R_upper_arm_z
        + minus_omega_R_upper_arm_x * r_T_upper_arm_z;
    const six_link_real a_t_upper_arm_x = a_J_upper_arm_x + state->v[1] * t16
        + minus_alpha_upper_arm_z * r_T_upper_arm_y - omega_R_upper_arm_z * t17;
    const six_link_real t18 = state->v[1] * r_T_upper_arm_z - omega_R_upper_arm_z * r_T_upper_arm_y;
    const six_link_real t19 = a_J_upper_arm_y - minus_alpha_upper_arm_z * c->links[1].length
        + omega_R_upper_arm_z * t18 + minus_alpha_upper_arm_x * r_T_upper_arm_z;
    const six_link_real a_t_upper_arm_y = t19 + minus_omega_R_upper_arm_x * t16;
    const six_link_real t20 = minus_a_J_upper_arm_z + minus_alpha_upper_arm_x * r_T_upper_arm_y
        + minus_omega_R_upper_arm_x * t17;
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
    const six_link_real R_P_forearm_xx = R_T_upper_arm_xx * R_rel_forearm_xx + R_T_upper_arm_xy * R_rel_forearm_yx
        + R_T_upper_arm_xz * R_rel_forearm_zx;
    const six_link_real R_P_forearm_xy = R_T_upper_arm_xx * c->links[2].R_m_xy + R_T_upper_arm_xy * c->links[2].R_m_yy
        + R_T_upper_arm_xz * c->links[2].R_m_zy;
    const six_link_real R_P_forearm_xz = R_T_upper_arm_xx * R_rel_forearm_xz + R_T_upper_arm_xy * R_rel_forearm_yz
        + R_T_upper_arm_xz * R_rel_forearm_zz;
    const six_link_real R_P_forearm_yx = R_T_upper_arm_yx * R_rel_forearm_xx + R_T_upper_arm_yy * R_rel_forearm_yx
        + R_T_upper_arm_yz * R_rel_forearm_zx;
    const six_link_real R_P_forearm_yy = R_T_upper_arm_yx * c->links[2].R_m_xy + R_T_upper_arm_yy * c->links[2].R_m_yy
        + R_T_upper_arm_yz * c->links[2].R_m_zy;
    const six_link_real R_P_forearm_yz = R_T_upper_arm_yx * R_rel_forearm_xz + R_T_upper_arm_yy * R_rel_forearm_yz
        + R_T_upper_arm_yz * R_rel_forearm_zz;
    const six_link_real R_P_forearm_zx = R_T_upper_arm_zx * R_rel_forearm_xx + R_T_upper_arm_zy * R_rel_forearm_yx
        + R_T_upper_arm_zz * R_rel_forearm_zx;
    const six_link_real R_P_forearm_zy = R_T_upper_arm_zx * c->links[2].R_m_xy + R_T_upper_arm_zy * c->links[2].R_m_yy
        + R_T_upper_arm_zz * c->links[2].R_m_zy;
    const six_link_real R_P_forearm_zz = R_T_upper_arm_zx * R_rel_forearm_xz + R_T_upper_arm_zy * R_rel_forearm_yz
        + R_T_upper_arm_zz * R_rel_forearm_zz;
    const six_link_real omega_R_forearm_x = R_P_forearm_xx * omega_t_upper_arm_x
        + R_P_forearm_yx * omega_t_upper_arm_y + R_P_forearm_zx * omega_t_upper_arm_z;
    const six_link_real omega_R_forearm_y = R_P_forearm_xy * omega_t_upper_arm_x
        + R_P_forearm_yy * omega_t_upper_arm_y + R_P_forearm_zy * omega_t_upper_arm_z;
    const six_link_real omega_R_forearm_z = R_P_forearm_xz * omega_t_upper_arm_x
        + R_P_forearm_yz * omega_t_upper_arm_y + R_P_forearm_zz * omega_t_upper_arm_z;

    /* forearm, acceleration of the parent's tip in F_i axes */
    const six_link_real t35 = R_P_forearm_xx * alpha_t_upper_arm_x + R_P_forearm_yx * alpha_t_upper_arm_y
        + R_P_forearm_zx * alpha_t_upper_arm_z;
    const six_link_real acc_0_forearm_alpha_y = R_P_forearm_xy * alpha_t_upper_arm_x
        + R_P_forearm_yy * alpha_t_upper_arm_y + R_P_forearm_zy * alpha_t_upper_arm_z;
    const six_link_real t36 = R_P_forearm_xz * alpha_t_upper_arm_x + R_P_forearm_yz * alpha_t_upper_arm_y
        + R_P_forearm_zz * alpha_t_upper_arm_z;
    const six_link_real t37 = R_P_forearm_xx * a_t_upper_arm_x + R_P_forearm_yx * a_t_upper_arm_y
        - R_P_forearm_zx * minus_a_t_upper_arm_z;
    const six_link_real t38 = R_P_forearm_xy * a_t_upper_arm_x + R_P_forearm_yy * a_t_upper_arm_y
        - R_P_forearm_zy * minus_a_t_upper_arm_z;
    const six_link_real t39 = R_P_forearm_xz * a_t_upper_arm_x + R_P_forearm_yz * a_t_upper_arm_y
        - R_P_forearm_zz * minus_a_t_upper_arm_z;

    /* forearm, omega: angular velocity of the link (45) */
    const six_link_real omega_forearm_y = omega_R_forearm_y + state->v[2];

    /* forearm, alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_forearm_x = t35 - omega_R_forearm_z * state->v[2];
    const six_link_real alpha_forearm_z = t36 + omega_R_forearm_x * state->v[2];

    /* forearm, r_R: joint point relative to the parent's tip point */
    const six_link_real r_R_forearm_x = R_rel_forearm_xx * c->links[2].mount_xyz_x
        + R_rel_forearm_yx * c->links[2].mount_xyz_y + R_rel_forearm_zx * c->links[2].mount_xyz_z;
    const six_link_real r_R_forearm_y = c->links[2].R_m_xy * c->links[2].mount_xyz_x
        + c->links[2].R_m_yy * c->links[2].mount_xyz_y + c->links[2].R_m_zy * c->links[2].mount_xyz_z;
    const six_link_real r_R_forearm_z = R_rel_forearm_xz * c->links[2].mount_xyz_x
        + R_rel_forearm_yz * c->links[2].mount_xyz_y + R_rel_forearm_zz * c->links[2].mount_xyz_z;

    /* forearm, a_J: acceleration of the joint point while no joint accelerates (accconst4) */
    const six_link_real t40 = omega_R_forearm_x * r_R_forearm_y - omega_R_forearm_y * r_R_forearm_x;
    const six_link_real t41 = omega_R_forearm_z * r_R_forearm_x - omega_R_forearm_x * r_R_forearm_z;
    const six_link_real a_J_forearm_x = t37 + acc_0_forearm_alpha_y * r_R_forearm_z + omega_R_forearm_y * t40
        - t36 * r_R_forearm_y - omega_R_forearm_z * t41;
    const six_link_real t42 = omega_R_forearm_y * r_R_forearm_z - omega_R_forearm_z * r_R_forearm_y;
    const six_link_real a_J_forearm_y = t38 + t36 * r_R_forearm_x + omega_R_forearm_z * t42 - t35 * r_R_forearm_z
        - omega_R_forearm_x * t40;
    const six_link_real a_J_forearm_z = t39 + t35 * r_R_forearm_y + omega_R_forearm_x * t41
        - acc_0_forearm_alpha_y * r_R_forearm_x - omega_R_forearm_y * t42;

    /* forearm, r_T: tip point (11) */
    const six_link_real r_T_forearm_y = state->q[12] * SIX_LINK_REAL(2.8145226674626453)
        + state->q[11] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real r_T_forearm_z = state->q[14] * SIX_LINK_REAL(2.8145226674626453)
        + state->q[13] * SIX_LINK_REAL(2.0195202782688155);

    /* forearm, theta: rotation vector of the tip section, [torsion, -u_z', u_y'] */
    const six_link_real theta_forearm_y = c->links[2].Psi_c_y3 * state->q[13] + c->links[2].Psi_c_y4 * state->q[14];
    const six_link_real theta_forearm_z = c->links[2].Psi_c_z1 * state->q[11] + c->links[2].Psi_c_z2 * state->q[12];

    /* forearm, x: squared angle of the tip section */
    const six_link_real minus_theta_hat2_forearm_33 = theta_forearm_y * theta_forearm_y;
    const six_link_real minus_theta_hat2_forearm_22 = theta_forearm_z * theta_forearm_z;
    const six_link_real x_forearm = minus_theta_hat2_forearm_33 + minus_theta_hat2_forearm_22;

    /* forearm, c2: Stumpff function of order 2 */
    const six_link_real t43 = six_link_c4(x_forearm);
    const six_link_real c2_forearm = SIX_LINK_REAL(0.5) - x_forearm * t43;

    /* forearm, c3: Stumpff function of order 3 */
    const six_link_real t44 = six_link_c5(x_forearm);
    const six_link_real c3_forearm = SIX_LINK_REAL(0.16666666666666666) - x_forearm * t44;

    /* forearm, udot_T: rate of the tip's elastic displacement (23) */
    const six_link_real udot_T_forearm_y = state->v[12] * SIX_LINK_REAL(2.8145226674626453)
        + state->v[11] * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real udot_T_forearm_z = state->v[14] * SIX_LINK_REAL(2.8145226674626453)
        + state->v[13] * SIX_LINK_REAL(2.0195202782688155);

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
    const six_link_real c2dot_forearm = xdot_forearm * (t43 - c3_forearm * SIX_LINK_REAL(0.5));

    /* forearm, c3dot: rate of c3 */
    const six_link_real c3dot_forearm = xdot_forearm * (t44 * SIX_LINK_REAL(1.5) - t43 * SIX_LINK_REAL(0.5));

    /* forearm, alpha_s: rate of the section's angular velocity without etaddot */
    const six_link_real alpha_s_forearm_x = c2dot_forearm * t45;
    const six_link_real alpha_s_forearm_y = c3_forearm * thetadot_forearm_z * t45
        + c3dot_forearm * theta_forearm_z * t45;
    const six_link_real minus_alpha_s_forearm_z = c3_forearm * thetadot_forearm_y * t45
        + c3dot_forearm * theta_forearm_y * t45;

    /* forearm, omega_t: angular velocity of the tip section (46) */
    const six_link_real omega_t_forearm_x = omega_s_forearm_x + omega_R_forearm_x;
    const six_link_real omega_t_forearm_y = omega_s_forearm_y + omega_forearm_y;
    const six_link_real omega_t_forearm_z = omega_s_forearm_z + omega_R_forearm_z;

    /* forearm, alpha_t: angular acceleration of the tip section (accconst1b) */
    const six_link_real alpha_t_forearm_x = alpha_s_forearm_x + alpha_forearm_x + omega_s_forearm_z * omega_forearm_y
        - omega_s_forearm_y * omega_R_forearm_z;
    const six_link_real alpha_t_forearm_y = alpha_s_forearm_y + acc_0_forearm_alpha_y
        + omega_s_forearm_x * omega_R_forearm_z - omega_s_forearm_z * omega_R_forearm_x;
    const six_link_real alpha_t_forearm_z = alpha_forearm_z - minus_alpha_s_forearm_z
        + omega_s_forearm_y * omega_R_forearm_x - omega_s_forearm_x * omega_forearm_y;

    /* forearm, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t46 = udot_T_forearm_z * 2 + omega_R_forearm_x * r_T_forearm_y
        - c->links[2].length * omega_forearm_y;
    const six_link_real t47 = a_J_forearm_x + acc_0_forearm_alpha_y * r_T_forearm_z + omega_forearm_y * t46
        - alpha_forearm_z * r_T_forearm_y;
    const six_link_real t48 = udot_T_forearm_y * 2 + c->links[2].length * omega_R_forearm_z
        - omega_R_forearm_x * r_T_forearm_z;
    const six_link_real a_t_forearm_x = t47 - omega_R_forearm_z * t48;
    const six_link_real t49 = omega_forearm_y * r_T_forearm_z - omega_R_forearm_z * r_T_forearm_y;
    const six_link_real t50 = a_J_forearm_y + alpha_forearm_z * c->links[2].length + omega_R_forearm_z * t49
        - alpha_forearm_x * r_T_forearm_z;
    const six_link_real a_t_forearm_y = t50 - omega_R_forearm_x * t46;
    const six_link_real t51 = a_J_forearm_z + alpha_forearm_x * r_T_forearm_y + omega_R_forearm_x * t48
        - acc_0_forearm_alpha_y * c->links[2].length;
    const six_link_real a_t_forearm_z = t51 - omega_forearm_y * t49;

    /* forearm, c1: Stumpff function of order 1 */
    const six_link_real c1_forearm = 1 - x_forearm * c3_forearm;

    /* forearm, theta_hat2: square of the rotation vector's skew matrix */
    const six_link_real theta_hat2_forearm_23 = theta_forearm_y * theta_forearm_z;

    /* forearm, J_l: left Jacobian of the exponential */
    const six_link_real J_l_forearm_yx = c2_forearm * theta_forearm_z;
    const six_link_real J_l_forearm_xz = c2_forearm * theta_forearm_y;
    const six_link_real J_l_forearm_yy = 1 - c3_forearm * minus_theta_hat2_forearm_22;
    const six_link_real J_l_forearm_yz = c3_forearm * theta_hat2_forearm_23;
    const six_link_real J_l_forearm_zz = 1 - c3_forearm * minus_theta_hat2_forearm_33;

    /* forearm, R_T: rotation of the tip section, exp of theta */
    const six_link_real R_T_forearm_xx = 1 - c2_forearm * x_forearm;
    const six_link_real R_T_forearm_yx = c1_forearm * theta_forearm_z;
    const six_link_real R_T_forearm_xz = c1_forearm * theta_forearm_y;
    const six_link_real R_T_forearm_yy = 1 - c2_forearm * minus_theta_hat2_forearm_22;
    const six_link_real R_T_forearm_yz = c2_forearm * theta_hat2_forearm_23;
    const six_link_real R_T_forearm_zz = 1 - c2_forearm * minus_theta_hat2_forearm_33;

    /* wrist_roll, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_4 = six_link_sine_cosine(state->q[3]);
    const six_link_real R_rel_wrist_roll_zy = turn_4.sine, R_rel_wrist_roll_yy = turn_4.cosine;

    /* wrist_roll, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real R_P_wrist_roll_xy = R_T_forearm_xz * R_rel_wrist_roll_zy - R_T_forearm_yx * R_rel_wrist_roll_yy;
    const six_link_real R_P_wrist_roll_xz = R_T_forearm_xz * R_rel_wrist_roll_yy + R_T_forearm_yx * R_rel_wrist_roll_zy;
    const six_link_real t52 = R_T_forearm_yz * R_rel_wrist_roll_zy;
    const six_link_real R_P_wrist_roll_yy = R_T_forearm_yy * R_rel_wrist_roll_yy + t52;
    const six_link_real t53 = R_T_forearm_yz * R_rel_wrist_roll_yy;
    const six_link_real R_P_wrist_roll_yz = t53 - R_T_forearm_yy * R_rel_wrist_roll_zy;
    const six_link_real R_P_wrist_roll_zy = t53 + R_T_forearm_zz * R_rel_wrist_roll_zy;
    const six_link_real R_P_wrist_roll_zz = R_T_forearm_zz * R_rel_wrist_roll_yy - t52;
    const six_link_real omega_R_wrist_roll_x = R_T_forearm_xx * omega_t_forearm_x + R_T_forearm_yx * omega_t_forearm_y
        - R_T_forearm_xz * omega_t_forearm_z;
    const six_link_real omega_R_wrist_roll_y = R_P_wrist_roll_xy * omega_t_forearm_x
        + R_P_wrist_roll_yy * omega_t_forearm_y + R_P_wrist_roll_zy * omega_t_forearm_z;
    const six_link_real omega_R_wrist_roll_z = R_P_wrist_roll_xz * omega_t_forearm_x
        + R_P_wrist_roll_yz * omega_t_forearm_y + R_P_wrist_roll_zz * omega_t_forearm_z;

    /* wrist_roll, acceleration of the parent's tip in F_i axes */
    const six_link_real acc_0_wrist_roll_alpha_x = R_T_forearm_xx * alpha_t_forearm_x
        + R_T_forearm_yx * alpha_t_forearm_y - R_T_forearm_xz * alpha_t_forearm_z;
    const six_link_real t54 = R_P_wrist_roll_xy * alpha_t_forearm_x + R_P_wrist_roll_yy * alpha_t_forearm_y
        + R_P_wrist_roll_zy * alpha_t_forearm_z;
    const six_link_real t55 = R_P_wrist_roll_xz * alpha_t_forearm_x + R_P_wrist_roll_yz * alpha_t_forearm_y
        + R_P_wrist_roll_zz * alpha_t_forearm_z;
    const six_link_real acc_0_wrist_roll_a_x = R_T_forearm_xx * a_t_forearm_x + R_T_forearm_yx * a_t_forearm_y
        - R_T_forearm_xz * a_t_forearm_z;
    const six_link_real acc_0_wrist_roll_a_y = R_P_wrist_roll_xy * a_t_forearm_x + R_P_wrist_roll_yy * a_t_forearm_y
        + R_P_wrist_roll_zy * a_t_forearm_z;
    const six_link_real acc_0_wrist_roll_a_z = R_P_wrist_roll_xz * a_t_forearm_x + R_P_wrist_roll_yz * a_t_forearm_y
        + R_P_wrist_roll_zz * a_t_forearm_z;

    /* wrist_roll, omega: angular velocity of the link (45) */
    const six_link_real omega_wrist_roll_x = omega_R_wrist_roll_x + state->v[3];

    /* wrist_roll, alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_wrist_roll_y = t54 + omega_R_wrist_roll_z * state->v[3];
    const six_link_real alpha_wrist_roll_z = t55 - omega_R_wrist_roll_y * state->v[3];

    /* wrist_roll, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t56 = omega_R_wrist_roll_y * omega_R_wrist_roll_y;
    const six_link_real t57 = omega_R_wrist_roll_z * omega_R_wrist_roll_z;
    const six_link_real a_t_wrist_roll_x = acc_0_wrist_roll_a_x - c->links[3].length * t56 - c->links[3].length * t57;
    const six_link_real t58 = c->links[3].length * omega_wrist_roll_x;
    const six_link_real a_t_wrist_roll_y = acc_0_wrist_roll_a_y + alpha_wrist_roll_z * c->links[3].length
        + t58 * omega_R_wrist_roll_y;
    const six_link_real a_t_wrist_roll_z = acc_0_wrist_roll_a_z + t58 * omega_R_wrist_roll_z
        - alpha_wrist_roll_y * c->links[3].length;

    /* wrist_pitch, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_5 = six_link_sine_cosine(state->q[4]);
    const six_link_real R_rel_wrist_pitch_xz = turn_5.sine, R_rel_wrist_pitch_xx = turn_5.cosine;

    /* wrist_pitch, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real omega_R_wrist_pitch_x = R_rel_wrist_pitch_xx * omega_wrist_roll_x
        - R_rel_wrist_pitch_xz * omega_R_wrist_roll_z;
    const six_link_real omega_R_wrist_pitch_z = R_rel_wrist_pitch_xz * omega_wrist_roll_x
        + R_rel_wrist_pitch_xx * omega_R_wrist_roll_z;

    /* wrist_pitch, acceleration of the parent's tip in F_i axes */
    const six_link_real t59 = R_rel_wrist_pitch_xx * acc_0_wrist_roll_alpha_x
        - R_rel_wrist_pitch_xz * alpha_wrist_roll_z;
    const six_link_real t60 = R_rel_wrist_pitch_xz * acc_0_wrist_roll_alpha_x
        + R_rel_wrist_pitch_xx * alpha_wrist_roll_z;
    const six_link_real acc_0_wrist_pitch_a_x = R_rel_wrist_pitch_xx * a_t_wrist_roll_x
        - R_rel_wrist_pitch_xz * a_t_wrist_roll_z;
    const six_link_real acc_0_wrist_pitch_a_z = R_rel_wrist_pitch_xz * a_t_wrist_roll_x
        + R_rel_wrist_pitch_xx * a_t_wrist_roll_z;

    /* wrist_pitch, omega: angular velocity of the link (45) */
    const six_link_real omega_wrist_pitch_y = omega_R_wrist_roll_y + state->v[4];

    /* wrist_pitch, alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_wrist_pitch_x = t59 - omega_R_wrist_pitch_z * state->v[4];
    const six_link_real alpha_wrist_pitch_z = t60 + omega_R_wrist_pitch_x * state->v[4];

    /* wrist_pitch, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t61 = omega_wrist_pitch_y * omega_wrist_pitch_y;
    const six_link_real t62 = omega_R_wrist_pitch_z * omega_R_wrist_pitch_z;
    const six_link_real a_t_wrist_pitch_x = acc_0_wrist_pitch_a_x - c->links[4].length * t61 - c->links[4].length * t62;
    const six_link_real t63 = c->links[4].length * omega_R_wrist_pitch_x;
    const six_link_real a_t_wrist_pitch_y = a_t_wrist_roll_y + alpha_wrist_pitch_z * c->links[4].length
        + t63 * omega_wrist_pitch_y;
    const six_link_real a_t_wrist_pitch_z = acc_0_wrist_pitch_a_z + t63 * omega_R_wrist_pitch_z
        - alpha_wrist_roll_y * c->links[4].length;

    /* flange, R_rel: rotation of F_i relative to the parent's tip frame */
    const six_link_sincos turn_6 = six_link_sine_cosine(state->q[5]);
    const six_link_real R_rel_flange_zy = turn_6.sine, R_rel_flange_yy = turn_6.cosine;

    /* flange, R: rotation of F_i relative to the parent's F_i (Ad) */
    const six_link_real omega_R_flange_y = R_rel_flange_yy * omega_wrist_pitch_y
        + R_rel_flange_zy * omega_R_wrist_pitch_z;
    const six_link_real omega_R_flange_z = R_rel_flange_yy * omega_R_wrist_pitch_z
        - R_rel_flange_zy * omega_wrist_pitch_y;

    /* flange, acceleration of the parent's tip in F_i axes */
    const six_link_real t64 = R_rel_flange_yy * alpha_wrist_roll_y + R_rel_flange_zy * alpha_wrist_pitch_z;
    const six_link_real t65 = R_rel_flange_yy * alpha_wrist_pitch_z - R_rel_flange_zy * alpha_wrist_roll_y;
    const six_link_real acc_0_flange_a_y = R_rel_flange_yy * a_t_wrist_pitch_y + R_rel_flange_zy * a_t_wrist_pitch_z;
    const six_link_real acc_0_flange_a_z = R_rel_flange_yy * a_t_wrist_pitch_z - R_rel_flange_zy * a_t_wrist_pitch_y;

    /* flange, omega: angular velocity of the link (45) */
    const six_link_real omega_flange_x = omega_R_wrist_pitch_x + state->v[5];

    /* flange, alpha: angular acceleration while no joint accelerates (accconst4) */
    const six_link_real alpha_flange_y = t64 + omega_R_flange_z * state->v[5];
    const six_link_real alpha_flange_z = t65 - omega_R_flange_y * state->v[5];

    /* flange, a_t: acceleration of the tip point (accconst1b) */
    const six_link_real t66 = omega_R_flange_y * omega_R_flange_y;
    const six_link_real t67 = omega_R_flange_z * omega_R_flange_z;
    const six_link_real a_t_flange_x = a_t_wrist_pitch_x - c->links[5].length * t66 - c->links[5].length * t67;
    const six_link_real t68 = c->links[5].length * omega_flange_x;
    const six_link_real a_t_flange_y = acc_0_flange_a_y + alpha_flange_z * c->links[5].length + t68 * omega_R_flange_y;
    const six_link_real a_t_flange_z = acc_0_flange_a_z + t68 * omega_R_flange_z - alpha_flange_y * c->links[5].length;

    /* flange, Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_flange_xx = t66 + t67;
    const six_link_real Omega_flange_yx = alpha_flange_z + omega_flange_x * omega_R_flange_y;
    const six_link_real Omega_flange_zx = omega_flange_x * omega_R_flange_z - alpha_flange_y;

    /* flange, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_flange_tau_x = c->links[5].I_s * alpha_wrist_pitch_x;
    const six_link_real t69 = c->links[5].I_s * omega_flange_x;
    const six_link_real H_star_flange_tau_y = t69 * omega_R_flange_z - c->links[5].J_0_xx * Omega_flange_zx
        - c->links[5].S_0_x * acc_0_flange_a_z;
    const six_link_real H_star_flange_tau_z = c->links[5].J_0_xx * Omega_flange_yx
        + c->links[5].S_0_x * acc_0_flange_a_y - t69 * omega_R_flange_y;
    const six_link_real H_star_flange_f_x = a_t_wrist_pitch_x * c->links[5].mu
        - minus_Omega_flange_xx * c->links[5].S_0_x;
    const six_link_real H_star_flange_f_y = Omega_flange_yx * c->links[5].S_0_x + acc_0_flange_a_y * c->links[5].mu;
    const six_link_real H_star_flange_f_z = Omega_flange_zx * c->links[5].S_0_x + acc_0_flange_a_z * c->links[5].mu;

    /* flange, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t70 = c->links[5].I_T_xx * alpha_wrist_pitch_x - c->links[5].J_T_xy * alpha_flange_y
        - c->links[5].J_T_xz * alpha_flange_z;
    const six_link_real t71 = c->links[5].I_T_yy * alpha_flange_y - c->links[5].J_T_xy * alpha_wrist_pitch_x
        - c->links[5].J_T_yz * alpha_flange_z;
    const six_link_real t72 = c->links[5].I_T_zz * alpha_flange_z
        - (c->links[5].J_T_xz * alpha_wrist_pitch_x + c->links[5].J_T_yz * alpha_flange_y);
    const six_link_real t73 = c->links[5].I_T_xx * omega_flange_x - c->links[5].J_T_xy * omega_R_flange_y
        - c->links[5].J_T_xz * omega_R_flange_z;
    const six_link_real t74 = c->links[5].I_T_yy * omega_R_flange_y - c->links[5].J_T_xy * omega_flange_x
        - c->links[5].J_T_yz * omega_R_flange_z;
    const six_link_real t75 = c->links[5].I_T_zz * omega_R_flange_z
        - (c->links[5].J_T_xz * omega_flange_x + c->links[5].J_T_yz * omega_R_flange_y);
    const six_link_real t76 = c->links[5].S_T_y * a_t_flange_z - c->links[5].S_T_z * a_t_flange_y + t70
        + (omega_R_flange_y * t75 - omega_R_flange_z * t74);
    const six_link_real t77 = c->links[5].S_T_z * a_t_flange_x - c->links[5].S_T_x * a_t_flange_z + t71
        + (omega_R_flange_z * t73 - omega_flange_x * t75);
    const six_link_real t78 = c->links[5].S_T_x * a_t_flange_y - c->links[5].S_T_y * a_t_flange_x + t72
        + (omega_flange_x * t74 - omega_R_flange_y * t73);
    const six_link_real t79 = omega_R_flange_y * c->links[5].S_T_z - omega_R_flange_z * c->links[5].S_T_y;
    const six_link_real t80 = omega_R_flange_z * c->links[5].S_T_x - omega_flange_x * c->links[5].S_T_z;
    const six_link_real t81 = omega_flange_x * c->links[5].S_T_y - omega_R_flange_y * c->links[5].S_T_x;
    const six_link_real t82 = alpha_flange_y * c->links[5].S_T_z - alpha_flange_z * c->links[5].S_T_y
        + (omega_R_flange_y * t81 - omega_R_flange_z * t80);
    const six_link_real t83 = alpha_flange_z * c->links[5].S_T_x - alpha_wrist_pitch_x * c->links[5].S_T_z
        + (omega_R_flange_z * t79 - omega_flange_x * t81);
    const six_link_real t84 = alpha_wrist_pitch_x * c->links[5].S_T_y - alpha_flange_y * c->links[5].S_T_x
        + (omega_flange_x * t80 - omega_R_flange_y * t79);
    const six_link_real p_T_flange_tau_x = t76 - input->w_ext[5][0];
    const six_link_real p_T_flange_tau_y = t77 - input->w_ext[5][1];
    const six_link_real p_T_flange_tau_z = t78 - input->w_ext[5][2];
    const six_link_real p_T_flange_f_x = c->links[5].body0_mass * a_t_flange_x + t82 - input->w_ext[5][3];
    const six_link_real p_T_flange_f_y = c->links[5].body0_mass * a_t_flange_y + t83 - input->w_ext[5][4];
    const six_link_real p_T_flange_f_z = c->links[5].body0_mass * a_t_flange_z + t84 - input->w_ext[5][5];

    /* flange, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t85 = c->links[5].S_T_x + c->links[5].length * c->links[5].body0_mass;
    const six_link_real t86 = c->links[5].S_T_x * c->links[5].length;
    const six_link_real t87 = c->links[5].length * t85;
    const six_link_real minus_M_loaded_flange_12 = c->links[5].J_T_xy + c->links[5].S_T_y * c->links[5].length;
    const six_link_real minus_M_loaded_flange_13 = c->links[5].J_T_xz + c->links[5].S_T_z * c->links[5].length;
    const six_link_real M_loaded_flange_11 = c->links[5].I_s + c->links[5].I_T_xx;
    const six_link_real M_loaded_flange_22 = c->links[5].J_0_xx + (c->links[5].I_T_yy + t86 + t87);
    const six_link_real M_loaded_flange_35 = t85 + c->links[5].S_0_x;
    const six_link_real M_loaded_flange_33 = c->links[5].J_0_xx + (c->links[5].I_T_zz + t86 + t87);
    const six_link_real M_loaded_flange_44 = c->links[5].mu + c->links[5].body0_mass;
    const six_link_real h_loaded_flange_tau_x = H_star_flange_tau_x + p_T_flange_tau_x;
    const six_link_real h_loaded_flange_tau_y = H_star_flange_tau_y
        + (p_T_flange_tau_y - c->links[5].length * p_T_flange_f_z);
    const six_link_real h_loaded_flange_tau_z = H_star_flange_tau_z
        + (p_T_flange_tau_z + c->links[5].length * p_T_flange_f_y);
    const six_link_real h_loaded_flange_f_x = H_star_flange_f_x + p_T_flange_f_x;
    const six_link_real h_loaded_flange_f_y = H_star_flange_f_y + p_T_flange_f_y;
    const six_link_real h_loaded_flange_f_z = H_star_flange_f_z + p_T_flange_f_z;

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
    const six_link_real joint_w_flange_1 = (input->tau[5] - work->f_eta[5] - h_loaded_flange_tau_x)
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
    const six_link_real Lambda_i_flange_26 = minus_M_loaded_flange_12 * joint_W_flange_16 - M_loaded_flange_35;
    const six_link_real Lambda_i_flange_33 = M_loaded_flange_33 - minus_M_loaded_flange_13 * minus_joint_W_flange_13;
    const six_link_real Lambda_i_flange_35 = M_loaded_flange_35 - minus_M_loaded_flange_13 * minus_joint_W_flange_15;
    const six_link_real Lambda_i_flange_36 = minus_M_loaded_flange_13 * joint_W_flange_16;
    const six_link_real Lambda_i_flange_55 = M_loaded_flange_44 - c->links[5].S_T_z * minus_joint_W_flange_15;
    const six_link_real Lambda_i_flange_56 = c->links[5].S_T_z * joint_W_flange_16;
    const six_link_real Lambda_i_flange_66 = M_loaded_flange_44 - c->links[5].S_T_y * joint_W_flange_16;
    const six_link_real p_i_flange_tau_x = h_loaded_flange_tau_x + M_loaded_flange_11 * joint_w_flange_1;
    const six_link_real p_i_flange_tau_y = h_loaded_flange_tau_y - minus_M_loaded_flange_12 * joint_w_flange_1;
    const six_link_real p_i_flange_tau_z = h_loaded_flange_tau_z - minus_M_loaded_flange_13 * joint_w_flange_1;
    const six_link_real p_i_flange_f_y = h_loaded_flange_f_y - c->links[5].S_T_z * joint_w_flange_1;
    const six_link_real p_i_flange_f_z = h_loaded_flange_f_z + c->links[5].S_T_y * joint_w_flange_1;

    /* flange, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real Lambda_flange_2 = Lambda_i_flange_12 * R_rel_flange_yy - Lambda_i_flange_13 * R_rel_flange_zy;
    const six_link_real Lambda_flange_3 = Lambda_i_flange_12 * R_rel_flange_zy + Lambda_i_flange_13 * R_rel_flange_yy;
    const six_link_real t89 = (Lambda_i_flange_22 - Lambda_i_flange_33) * SIX_LINK_REAL(0.5);
    const six_link_real t90 = t89 * R_rel_flange_yy + minus_Lambda_i_flange_23 * R_rel_flange_zy;
    const six_link_real t91 = t89 * R_rel_flange_zy - minus_Lambda_i_flange_23 * R_rel_flange_yy;
    const six_link_real Lambda_flange_7 = R_rel_flange_yy * t90 * 2 + Lambda_i_flange_33;
    const six_link_real Lambda_flange_8 = R_rel_flange_yy * t91 + R_rel_flange_zy * t90;
    const six_link_real Lambda_flange_12 = R_rel_flange_zy * t91 * 2 + Lambda_i_flange_33;
    const six_link_real Lambda_flange_5 = Lambda_i_flange_15 * R_rel_flange_yy - Lambda_i_flange_16 * R_rel_flange_zy;
    const six_link_real Lambda_flange_6 = Lambda_i_flange_15 * R_rel_flange_zy + Lambda_i_flange_16 * R_rel_flange_yy;
    const six_link_real t92 = minus_Lambda_i_flange_25 * R_rel_flange_yy + Lambda_i_flange_26 * R_rel_flange_zy;
    const six_link_real t93 = Lambda_i_flange_26 * R_rel_flange_yy - minus_Lambda_i_flange_25 * R_rel_flange_zy;
    const six_link_real t94 = Lambda_i_flange_35 * R_rel_flange_yy - Lambda_i_flange_36 * R_rel_flange_zy;
    const six_link_real t95 = Lambda_i_flange_35 * R_rel_flange_zy + Lambda_i_flange_36 * R_rel_flange_yy;
    const six_link_real Lambda_flange_9 = R_rel_flange_yy * c->links[5].S_T_z + R_rel_flange_zy * c->links[5].S_T_y;
    const six_link_real minus_Lambda_flange_10 = R_rel_flange_yy * t92 + R_rel_flange_zy * t94;
    const six_link_real Lambda_flange_11 = R_rel_flange_yy * t93 - R_rel_flange_zy * t95;
    const six_link_real Lambda_flange_13 = R_rel_flange_zy * c->links[5].S_T_z - R_rel_flange_yy * c->links[5].S_T_y;
    const six_link_real Lambda_flange_14 = R_rel_flange_yy * t94 - R_rel_flange_zy * t92;
    const six_link_real Lambda_flange_15 = R_rel_flange_zy * t93 + R_rel_flange_yy * t95;
    const six_link_real t96 = (Lambda_i_flange_55 - Lambda_i_flange_66) * SIX_LINK_REAL(0.5);
    const six_link_real t97 = t96 * R_rel_flange_yy - Lambda_i_flange_56 * R_rel_flange_zy;
    const six_link_real t98 = t96 * R_rel_flange_zy + Lambda_i_flange_56 * R_rel_flange_yy;
    const six_link_real Lambda_flange_19 = R_rel_flange_yy * t97 * 2 + Lambda_i_flange_66;
    const six_link_real Lambda_flange_20 = R_rel_flange_yy * t98 + R_rel_flange_zy * t97;
    const six_link_real Lambda_flange_21 = R_rel_flange_zy * t98 * 2 + Lambda_i_flange_66;
    const six_link_real p_flange_tau_y = R_rel_flange_yy * p_i_flange_tau_y - R_rel_flange_zy * p_i_flange_tau_z;
    const six_link_real p_flange_tau_z = R_rel_flange_zy * p_i_flange_tau_y + R_rel_flange_yy * p_i_flange_tau_z;
    const six_link_real p_flange_f_y = R_rel_flange_yy * p_i_flange_f_y - R_rel_flange_zy * p_i_flange_f_z;
    const six_link_real p_flange_f_z = R_rel_flange_zy * p_i_flange_f_y + R_rel_flange_yy * p_i_flange_f_z;

    /* wrist_pitch, Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_wrist_pitch_xx = t61 + t62;
    const six_link_real Omega_wrist_pitch_yx = alpha_wrist_pitch_z + omega_R_wrist_pitch_x * omega_wrist_pitch_y;
    const six_link_real Omega_wrist_pitch_zx = omega_R_wrist_pitch_x * omega_R_wrist_pitch_z - alpha_wrist_roll_y;

    /* wrist_pitch, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_wrist_pitch_tau_x = c->links[4].I_s * alpha_wrist_pitch_x;
    const six_link_real t99 = c->links[4].I_s * omega_R_wrist_pitch_x;
    const six_link_real H_star_wrist_pitch_tau_y = t99 * omega_R_wrist_pitch_z
        - c->links[4].J_0_xx * Omega_wrist_pitch_zx - c->links[4].S_0_x * acc_0_wrist_pitch_a_z;
    const six_link_real H_star_wrist_pitch_tau_z = c->links[4].J_0_xx * Omega_wrist_pitch_yx
        + c->links[4].S_0_x * a_t_wrist_roll_y - t99 * omega_wrist_pitch_y;
    const six_link_real H_star_wrist_pitch_f_x = acc_0_wrist_pitch_a_x * c->links[4].mu
        - minus_Omega_wrist_pitch_xx * c->links[4].S_0_x;
    const six_link_real H_star_wrist_pitch_f_y = Omega_wrist_pitch_yx * c->links[4].S_0_x
        + a_t_wrist_roll_y * c->links[4].mu;
    const six_link_real H_star_wrist_pitch_f_z = Omega_wrist_pitch_zx * c->links[4].S_0_x
        + acc_0_wrist_pitch_a_z * c->links[4].mu;

    /* wrist_pitch, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_wrist_pitch_tau_x = p_i_flange_tau_x - input->w_ext[4][0];
    const six_link_real p_T_wrist_pitch_tau_y = p_flange_tau_y - input->w_ext[4][1];
    const six_link_real p_T_wrist_pitch_tau_z = p_flange_tau_z - input->w_ext[4][2];
    const six_link_real p_T_wrist_pitch_f_x = h_loaded_flange_f_x - input->w_ext[4][3];
    const six_link_real p_T_wrist_pitch_f_y = p_flange_f_y - input->w_ext[4][4];
    const six_link_real p_T_wrist_pitch_f_z = p_flange_f_z - input->w_ext[4][5];

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
    const six_link_real h_loaded_wrist_pitch_tau_x = H_star_wrist_pitch_tau_x + p_T_wrist_pitch_tau_x;
    const six_link_real h_loaded_wrist_pitch_tau_y = H_star_wrist_pitch_tau_y
        + (p_T_wrist_pitch_tau_y - c->links[4].length * p_T_wrist_pitch_f_z);
    const six_link_real h_loaded_wrist_pitch_tau_z = H_star_wrist_pitch_tau_z
        + (p_T_wrist_pitch_tau_z + c->links[4].length * p_T_wrist_pitch_f_y);
    const six_link_real h_loaded_wrist_pitch_f_x = H_star_wrist_pitch_f_x + p_T_wrist_pitch_f_x;
    const six_link_real h_loaded_wrist_pitch_f_y = H_star_wrist_pitch_f_y + p_T_wrist_pitch_f_y;
    const six_link_real h_loaded_wrist_pitch_f_z = H_star_wrist_pitch_f_z + p_T_wrist_pitch_f_z;

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
    const six_link_real joint_w_wrist_pitch_1 = (input->tau[4] - work->f_eta[4] - h_loaded_wrist_pitch_tau_y)
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
    const six_link_real p_i_wrist_pitch_tau_x = h_loaded_wrist_pitch_tau_x
        + M_loaded_wrist_pitch_12 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_tau_y = h_loaded_wrist_pitch_tau_y
        + M_loaded_wrist_pitch_22 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_tau_z = h_loaded_wrist_pitch_tau_z
        + M_loaded_wrist_pitch_23 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_f_x = h_loaded_wrist_pitch_f_x + Lambda_flange_9 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_f_y = h_loaded_wrist_pitch_f_y
        - minus_M_loaded_wrist_pitch_25 * joint_w_wrist_pitch_1;
    const six_link_real p_i_wrist_pitch_f_z = h_loaded_wrist_pitch_f_z
        + M_loaded_wrist_pitch_26 * joint_w_wrist_pitch_1;

    /* wrist_pitch, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t103 = (Lambda_i_wrist_pitch_11 - Lambda_i_wrist_pitch_33) * SIX_LINK_REAL(0.5);
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
    const six_link_real t110 = (Lambda_i_wrist_pitch_66 - Lambda_i_wrist_pitch_44) * SIX_LINK_REAL(0.5);
    const six_link_real t111 = t110 * R_rel_wrist_pitch_xx + minus_Lambda_i_wrist_pitch_46 * R_rel_wrist_pitch_xz;
    const six_link_real t112 = t110 * R_rel_wrist_pitch_xz - minus_Lambda_i_wrist_pitch_46 * R_rel_wrist_pitch_xx;
    const six_link_real Lambda_wrist_pitch_16 = Lambda_i_wrist_pitch_66 - R_rel_wrist_pitch_xx * t111 * 2;
    const six_link_real Lambda_wrist_pitch_17 = R_rel_wrist_pitch_xx * Lambda_i_wrist_pitch_45
        + Lambda_i_wrist_pitch_56 * R_rel_wrist_pitch_xz;
    const six_link_real Lambda_wrist_pitch_18 = R_rel_wrist_pitch_xx * t112 + R_rel_wrist_pitch_xz * t111;
    const six_link_real Lambda_wrist_pitch_20 = Lambda_i_wrist_pitch_56 * R_rel_wrist_pitch_xx
        - R_rel_wrist_pitch_xz * Lambda_i_wrist_pitch_45;
    const six_link_real Lambda_wrist_pitch_21 = Lambda_i_wrist_pitch_66 - R_rel_wrist_pitch_xz * t112 * 2;
    const six_link_real p_wrist_pitch_tau_x = R_rel_wrist_pitch_xx * p_i_wrist_pitch_tau_x
        + R_rel_wrist_pitch_xz * p_i_wrist_pitch_tau_z;
    const six_link_real p_wrist_pitch_tau_z = R_rel_wrist_pitch_xx * p_i_wrist_pitch_tau_z
        - R_rel_wrist_pitch_xz * p_i_wrist_pitch_tau_x;
    const six_link_real p_wrist_pitch_f_x = R_rel_wrist_pitch_xx * p_i_wrist_pitch_f_x
        + R_rel_wrist_pitch_xz * p_i_wrist_pitch_f_z;
    const six_link_real p_wrist_pitch_f_z = R_rel_wrist_pitch_xx * p_i_wrist_pitch_f_z
        - R_rel_wrist_pitch_xz * p_i_wrist_pitch_f_x;

    /* wrist_roll, Omega: acceleration of a place by the link's turning */
    const six_link_real minus_Omega_wrist_roll_xx = t56 + t57;
    const six_link_real Omega_wrist_roll_yx = alpha_wrist_roll_z + omega_wrist_roll_x * omega_R_wrist_roll_y;
    const six_link_real Omega_wrist_roll_zx = omega_wrist_roll_x * omega_R_wrist_roll_z - alpha_wrist_roll_y;

    /* wrist_roll, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_wrist_roll_tau_x = c->links[3].I_s * acc_0_wrist_roll_alpha_x;
    const six_link_real t113 = c->links[3].I_s * omega_wrist_roll_x;
    const six_link_real H_star_wrist_roll_tau_y = t113 * omega_R_wrist_roll_z
        - c->links[3].J_0_xx * Omega_wrist_roll_zx - c->links[3].S_0_x * acc_0_wrist_roll_a_z;
    const six_link_real H_star_wrist_roll_tau_z = c->links[3].J_0_xx * Omega_wrist_roll_yx
        + c->links[3].S_0_x * acc_0_wrist_roll_a_y - t113 * omega_R_wrist_roll_y;
    const six_link_real H_star_wrist_roll_f_x = acc_0_wrist_roll_a_x * c->links[3].mu
        - minus_Omega_wrist_roll_xx * c->links[3].S_0_x;
    const six_link_real H_star_wrist_roll_f_y = Omega_wrist_roll_yx * c->links[3].S_0_x
        + acc_0_wrist_roll_a_y * c->links[3].mu;
    const six_link_real H_star_wrist_roll_f_z = Omega_wrist_roll_zx * c->links[3].S_0_x
        + acc_0_wrist_roll_a_z * c->links[3].mu;

    /* wrist_roll, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real p_T_wrist_roll_tau_x = p_wrist_pitch_tau_x - input->w_ext[3][0];
    const six_link_real p_T_wrist_roll_tau_y = p_i_wrist_pitch_tau_y - input->w_ext[3][1];
    const six_link_real p_T_wrist_roll_tau_z = p_wrist_pitch_tau_z - input->w_ext[3][2];
    const six_link_real p_T_wrist_roll_f_x = p_wrist_pitch_f_x - input->w_ext[3][3];
    const six_link_real p_T_wrist_roll_f_y = p_i_wrist_pitch_f_y - input->w_ext[3][4];
    const six_link_real p_T_wrist_roll_f_z = p_wrist_pitch_f_z - input->w_ext[3][5];

    /* wrist_roll, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t114 = c->links[3].length * Lambda_wrist_pitch_20;
    const six_link_real M_loaded_wrist_roll_24 = Lambda_wrist_pitch_9 - c->links[3].length * Lambda_wrist_pitch_18;
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
    const six_link_real h_loaded_wrist_roll_tau_x = H_star_wrist_roll_tau_x + p_T_wrist_roll_tau_x;
    const six_link_real h_loaded_wrist_roll_tau_y = H_star_wrist_roll_tau_y
        + (p_T_wrist_roll_tau_y - c->links[3].length * p_T_wrist_roll_f_z);
    const six_link_real h_loaded_wrist_roll_tau_z = H_star_wrist_roll_tau_z
        + (p_T_wrist_roll_tau_z + c->links[3].length * p_T_wrist_roll_f_y);
    const six_link_real h_loaded_wrist_roll_f_x = H_star_wrist_roll_f_x + p_T_wrist_roll_f_x;
    const six_link_real h_loaded_wrist_roll_f_y = H_star_wrist_roll_f_y + p_T_wrist_roll_f_y;
    const six_link_real h_loaded_wrist_roll_f_z = H_star_wrist_roll_f_z + p_T_wrist_roll_f_z;

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
    const six_link_real joint_w_wrist_roll_1 = (input->tau[3] - work->f_eta[3] - h_loaded_wrist_roll_tau_x)
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
    const six_link_real Lambda_i_wrist_roll_46 = Lambda_wrist_pitch_18 - Lambda_wrist_pitch_4 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_55 = M_loaded_wrist_roll_55 - Lambda_wrist_pitch_5 * joint_W_wrist_roll_15;
    const six_link_real Lambda_i_wrist_roll_56 = Lambda_wrist_pitch_20 - Lambda_wrist_pitch_5 * joint_W_wrist_roll_16;
    const six_link_real Lambda_i_wrist_roll_66 = M_loaded_wrist_roll_66 - Lambda_wrist_pitch_6 * joint_W_wrist_roll_16;
    const six_link_real p_i_wrist_roll_tau_x = h_loaded_wrist_roll_tau_x
        + M_loaded_wrist_roll_11 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_tau_y = h_loaded_wrist_roll_tau_y
        + M_loaded_wrist_roll_12 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_tau_z = h_loaded_wrist_roll_tau_z
        + M_loaded_wrist_roll_13 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_f_x = h_loaded_wrist_roll_f_x + Lambda_wrist_pitch_4 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_f_y = h_loaded_wrist_roll_f_y + Lambda_wrist_pitch_5 * joint_w_wrist_roll_1;
    const six_link_real p_i_wrist_roll_f_z = h_loaded_wrist_roll_f_z + Lambda_wrist_pitch_6 * joint_w_wrist_roll_1;

    /* wrist_roll, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t117 = (Lambda_i_wrist_roll_11 - Lambda_i_wrist_roll_33) * SIX_LINK_REAL(0.5);
    const six_link_real t118 = t117 * R_T_forearm_xx + Lambda_i_wrist_roll_12 * R_P_wrist_roll_xy
        + Lambda_i_wrist_roll_13 * R_P_wrist_roll_xz;
    const six_link_real t119 = t117 * R_T_forearm_yx + Lambda_i_wrist_roll_12 * R_P_wrist_roll_yy
        + Lambda_i_wrist_roll_13 * R_P_wrist_roll_yz;
    const six_link_real t120 = Lambda_i_wrist_roll_12 * R_P_wrist_roll_zy - t117 * R_T_forearm_xz
        + Lambda_i_wrist_roll_13 * R_P_wrist_roll_zz;
    const six_link_real t121 = (Lambda_i_wrist_roll_22 - Lambda_i_wrist_roll_33) * SIX_LINK_REAL(0.5);
    const six_link_real t122 = t121 * R_P_wrist_roll_xy + Lambda_i_wrist_roll_23 * R_P_wrist_roll_xz;
    const six_link_real t123 = t121 * R_P_wrist_roll_yy + Lambda_i_wrist_roll_23 * R_P_wrist_roll_yz;
    const six_link_real t124 = t121 * R_P_wrist_roll_zy + Lambda_i_wrist_roll_23 * R_P_wrist_roll_zz;
    const six_link_real Lambda_wrist_roll_1 = (R_T_forearm_xx * t118 + R_P_wrist_roll_xy * t122) * 2
        + Lambda_i_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_2 = R_T_forearm_xx * t119 + R_P_wrist_roll_xy * t123
        + (R_T_forearm_yx * t118 + R_P_wrist_roll_yy * t122);
    const six_link_real Lambda_wrist_roll_3 = R_T_forearm_xx * t120 + R_P_wrist_roll_xy * t124
        + (R_P_wrist_roll_zy * t122 - R_T_forearm_xz * t118);
    const six_link_real Lambda_wrist_roll_7 = (R_T_forearm_yx * t119 + R_P_wrist_roll_yy * t123) * 2
        + Lambda_i_wrist_roll_33;
    const six_link_real Lambda_wrist_roll_8 = R_T_forearm_yx * t120 + R_P_wrist_roll_yy * t124
        + (R_P_wrist_roll_zy * t123 - R_T_forearm_xz * t119);
    const six_link_real Lambda_wrist_roll_12 = (R_P_wrist_roll_zy * t124 - R_T_forearm_xz * t120) * 2
        + Lambda_i_wrist_roll_33;
    const six_link_real t125 = Lambda_i_wrist_roll_14 * R_T_forearm_xx + Lambda_i_wrist_roll_15 * R_P_wrist_roll_xy
        + Lambda_i_wrist_roll_16 * R_P_wrist_roll_xz;
    const six_link_real t126 = Lambda_i_wrist_roll_14 * R_T_forearm_yx + Lambda_i_wrist_roll_15 * R_P_wrist_roll_yy
        + Lambda_i_wrist_roll_16 * R_P_wrist_roll_yz;
    const six_link_real t127 = Lambda_i_wrist_roll_15 * R_P_wrist_roll_zy - Lambda_i_wrist_roll_14 * R_T_forearm_xz
        + Lambda_i_wrist_roll_16 * R_P_wrist_roll_zz;
    const six_link_real t128 = Lambda_i_wrist_roll_24 * R_T_forearm_xx + Lambda_i_wrist_roll_25 * R_P_wrist_roll_xy
        + Lambda_i_wrist_roll_26 * R_P_wrist_roll_xz;
    const six_link_real t129 = Lambda_i_wrist_roll_24 * R_T_forearm_yx + Lambda_i_wrist_roll_25 * R_P_wrist_roll_yy
        + Lambda_i_wrist_roll_26 * R_P_wrist_roll_yz;
    const six_link_real t130 = Lambda_i_wrist_roll_25 * R_P_wrist_roll_zy - Lambda_i_wrist_roll_24 * R_T_forearm_xz
        + Lambda_i_wrist_roll_26 * R_P_wrist_roll_zz;
    const six_link_real t131 = Lambda_i_wrist_roll_34 * R_T_forearm_xx + Lambda_i_wrist_roll_35 * R_P_wrist_roll_xy
        + Lambda_i_wrist_roll_36 * R_P_wrist_roll_xz;
    const six_link_real t132 = Lambda_i_wrist_roll_34 * R_T_forearm_yx + Lambda_i_wrist_roll_35 * R_P_wrist_roll_yy
        + Lambda_i_wrist_roll_36 * R_P_wrist_roll_yz;
    const six_link_real t133 = Lambda_i_wrist_roll_35 * R_P_wrist_roll_zy - Lambda_i_wrist_roll_34 * R_T_forearm_xz
        + Lambda_i_wrist_roll_36 * R_P_wrist_roll_zz;
    const six_link_real Lambda_wrist_roll_4 = R_T_forearm_xx * t125 + R_P_wrist_roll_xy * t128
        + R_P_wrist_roll_xz * t131;
    const six_link_real Lambda_wrist_roll_5 = R_T_forearm_xx * t126 + R_P_wrist_roll_xy * t129
        + R_P_wrist_roll_xz * t132;
    const six_link_real Lambda_wrist_roll_6 = R_T_forearm_xx * t127 + R_P_wrist_roll_xy * t130
        + R_P_wrist_roll_xz * t133;
    const six_link_real Lambda_wrist_roll_9 = R_T_forearm_yx * t125 + R_P_wrist_roll_yy * t128
        + R_P_wrist_roll_yz * t131;
    const six_link_real Lambda_wrist_roll_10 = R_T_forearm_yx * t126 + R_P_wrist_roll_yy * t129
        + R_P_wrist_roll_yz * t132;
    const six_link_real Lambda_wrist_roll_11 = R_T_forearm_yx * t127 + R_P_wrist_roll_yy * t130
        + R_P_wrist_roll_yz * t133;
    const six_link_real Lambda_wrist_roll_13 = R_P_wrist_roll_zy * t128 - R_T_forearm_xz * t125
        + R_P_wrist_roll_zz * t131;
    const six_link_real Lambda_wrist_roll_14 = R_P_wrist_roll_zy * t129 - R_T_forearm_xz * t126
        + R_P_wrist_roll_zz * t132;
    const six_link_real Lambda_wrist_roll_15 = R_P_wrist_roll_zy * t130 - R_T_forearm_xz * t127
        + R_P_wrist_roll_zz * t133;
    const six_link_real t134 = (Lambda_i_wrist_roll_44 - Lambda_i_wrist_roll_66) * SIX_LINK_REAL(0.5);
    const six_link_real t135 = t134 * R_T_forearm_xx + Lambda_i_wrist_roll_45 * R_P_wrist_roll_xy
        + Lambda_i_wrist_roll_46 * R_P_wrist_roll_xz;
    const six_link_real t136 = t134 * R_T_forearm_yx + Lambda_i_wrist_roll_45 * R_P_wrist_roll_yy
        + Lambda_i_wrist_roll_46 * R_P_wrist_roll_yz;
    const six_link_real t137 = Lambda_i_wrist_roll_45 * R_P_wrist_roll_zy - t134 * R_T_forearm_xz
        + Lambda_i_wrist_roll_46 * R_P_wrist_roll_zz;
    const six_link_real t138 = (Lambda_i_wrist_roll_55 - Lambda_i_wrist_roll_66) * SIX_LINK_REAL(0.5);
    const six_link_real t139 = t138 * R_P_wrist_roll_xy + Lambda_i_wrist_roll_56 * R_P_wrist_roll_xz;
    const six_link_real t140 = t138 * R_P_wrist_roll_yy + Lambda_i_wrist_roll_56 * R_P_wrist_roll_yz;
    const six_link_real t141 = t138 * R_P_wrist_roll_zy + Lambda_i_wrist_roll_56 * R_P_wrist_roll_zz;
    const six_link_real Lambda_wrist_roll_16 = (R_T_forearm_xx * t135 + R_P_wrist_roll_xy * t139) * 2
        + Lambda_i_wrist_roll_66;
    const six_link_real Lambda_wrist_roll_17 = R_T_forearm_xx * t136 + R_P_wrist_roll_xy * t140
        + (R_T_forearm_yx * t135 + R_P_wrist_roll_yy * t139);
    const six_link_real Lambda_wrist_roll_18 = R_T_forearm_xx * t137 + R_P_wrist_roll_xy * t141
        + (R_P_wrist_roll_zy * t139 - R_T_forearm_xz * t135);
    const six_link_real Lambda_wrist_roll_19 = (R_T_forearm_yx * t136 + R_P_wrist_roll_yy * t140) * 2
        + Lambda_i_wrist_roll_66;
    const six_link_real Lambda_wrist_roll_20 = R_T_forearm_yx * t137 + R_P_wrist_roll_yy * t141
        + (R_P_wrist_roll_zy * t140 - R_T_forearm_xz * t136);
    const six_link_real Lambda_wrist_roll_21 = (R_P_wrist_roll_zy * t141 - R_T_forearm_xz * t137) * 2
        + Lambda_i_wrist_roll_66;
    const six_link_real p_wrist_roll_tau_x = R_T_forearm_xx * p_i_wrist_roll_tau_x
        + R_P_wrist_roll_xy * p_i_wrist_roll_tau_y + R_P_wrist_roll_xz * p_i_wrist_roll_tau_z;
    const six_link_real p_wrist_roll_tau_y = R_T_forearm_yx * p_i_wrist_roll_tau_x
        + R_P_wrist_roll_yy * p_i_wrist_roll_tau_y + R_P_wrist_roll_yz * p_i_wrist_roll_tau_z;
    const six_link_real p_wrist_roll_tau_z = R_P_wrist_roll_zy * p_i_wrist_roll_tau_y
        - R_T_forearm_xz * p_i_wrist_roll_tau_x + R_P_wrist_roll_zz * p_i_wrist_roll_tau_z;
    const six_link_real p_wrist_roll_f_x = R_T_forearm_xx * p_i_wrist_roll_f_x
        + R_P_wrist_roll_xy * p_i_wrist_roll_f_y + R_P_wrist_roll_xz * p_i_wrist_roll_f_z;
    const six_link_real p_wrist_roll_f_y = R_T_forearm_yx * p_i_wrist_roll_f_x
        + R_P_wrist_roll_yy * p_i_wrist_roll_f_y + R_P_wrist_roll_yz * p_i_wrist_roll_f_z;
    const six_link_real p_wrist_roll_f_z = R_P_wrist_roll_zy * p_i_wrist_roll_f_y
        - R_T_forearm_xz * p_i_wrist_roll_f_x + R_P_wrist_roll_zz * p_i_wrist_roll_f_z;

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
    const six_link_real t143 = omega_R_forearm_z * omega_R_forearm_z;
    const six_link_real minus_Omega_forearm_xx = t142 + t143;
    const six_link_real t144 = omega_R_forearm_x * omega_forearm_y;
    const six_link_real Omega_forearm_xy = t144 - alpha_forearm_z;
    const six_link_real t145 = omega_R_forearm_x * omega_R_forearm_z;
    const six_link_real Omega_forearm_xz = acc_0_forearm_alpha_y + t145;
    const six_link_real Omega_forearm_yx = alpha_forearm_z + t144;
    const six_link_real t146 = omega_R_forearm_x * omega_R_forearm_x;
    const six_link_real minus_Omega_forearm_yy = t146 + t143;
    const six_link_real t147 = omega_forearm_y * omega_R_forearm_z;
    const six_link_real Omega_forearm_yz = t147 - alpha_forearm_x;
    const six_link_real Omega_forearm_zx = t145 - acc_0_forearm_alpha_y;
    const six_link_real Omega_forearm_zy = alpha_forearm_x + t147;
    const six_link_real minus_Omega_forearm_zz = t146 + t142;

    /* forearm, B: moment of the elastic velocity */
    const six_link_real B_forearm_yx = c->links[2].chi_1 * state->v[11] + c->links[2].chi_2 * state->v[12];
    const six_link_real B_forearm_yy = L_forearm_y1 * state->v[11] + L_forearm_y2 * state->v[12];
    const six_link_real B_forearm_yz = L_forearm_z1 * state->v[11] + L_forearm_z2 * state->v[12];
    const six_link_real B_forearm_zx = c->links[2].chi_1 * state->v[13] + c->links[2].chi_2 * state->v[14];
    const six_link_real B_forearm_zy = L_forearm_y1 * state->v[13] + L_forearm_y2 * state->v[14];
    const six_link_real B_forearm_zz = L_forearm_z1 * state->v[13] + L_forearm_z2 * state->v[14];

    /* forearm, h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const six_link_real h_c_forearm_tau_x = B_forearm_yy * omega_R_forearm_x + B_forearm_zz * omega_R_forearm_x;
    const six_link_real h_c_forearm_tau_y = B_forearm_zz * omega_forearm_y - B_forearm_yx * omega_R_forearm_x
        - B_forearm_yz * omega_R_forearm_z;
    const six_link_real h_c_forearm_tau_z = B_forearm_yy * omega_R_forearm_z - B_forearm_zx * omega_R_forearm_x
        - B_forearm_zy * omega_forearm_y;
    const six_link_real h_c_forearm_f_x = Sdot_forearm_z * omega_forearm_y - Sdot_forearm_y * omega_R_forearm_z;
    const six_link_real minus_h_c_forearm_f_y = Sdot_forearm_z * omega_R_forearm_x;
    const six_link_real h_c_forearm_f_z = Sdot_forearm_y * omega_R_forearm_x;

    /* forearm, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real t148 = h_c_forearm_tau_x + c->links[2].I_s * alpha_forearm_x + J_forearm_xy * Omega_forearm_zx
        + J_forearm_yy * Omega_forearm_zy;
    const six_link_real t149 = t148 + J_forearm_yz * (minus_Omega_forearm_yy - minus_Omega_forearm_zz)
        + S_forearm_y * a_J_forearm_z;
    const six_link_real H_star_forearm_tau_x = t149 - J_forearm_xz * Omega_forearm_yx
        - J_forearm_zz * Omega_forearm_yz - S_forearm_z * a_J_forearm_y;
    const six_link_real t150 = h_c_forearm_tau_y + J_forearm_xz * (minus_Omega_forearm_zz - minus_Omega_forearm_xx)
        + J_forearm_yz * Omega_forearm_xy;
    const six_link_real t151 = c->links[2].I_s * omega_R_forearm_x;
    const six_link_real t152 = t150 + J_forearm_zz * Omega_forearm_xz + S_forearm_z * a_J_forearm_x
        + t151 * omega_R_forearm_z - c->links[2].J_0_xx * Omega_forearm_zx;
    const six_link_real H_star_forearm_tau_y = t152 - J_forearm_xy * Omega_forearm_zy
        - c->links[2].S_0_x * a_J_forearm_z;
    const six_link_real t153 = h_c_forearm_tau_z + c->links[2].J_0_xx * Omega_forearm_yx
        + J_forearm_xy * (minus_Omega_forearm_xx - minus_Omega_forearm_yy);
    const six_link_real t154 = t153 + J_forearm_xz * Omega_forearm_yz + c->links[2].S_0_x * a_J_forearm_y
        - J_forearm_yy * Omega_forearm_xy;
    const six_link_real H_star_forearm_tau_z = t154 - J_forearm_yz * Omega_forearm_xz - S_forearm_y * a_J_forearm_x
        - t151 * omega_forearm_y;
    const six_link_real t155 = h_c_forearm_f_x - minus_Omega_forearm_xx * c->links[2].S_0_x
        + Omega_forearm_xy * S_forearm_y + Omega_forearm_xz * S_forearm_z;
    const six_link_real H_star_forearm_f_x = t155 + a_J_forearm_x * c->links[2].m;
    const six_link_real t156 = Omega_forearm_yx * c->links[2].S_0_x - minus_h_c_forearm_f_y
        - minus_Omega_forearm_yy * S_forearm_y;
    const six_link_real H_star_forearm_f_y = t156 + Omega_forearm_yz * S_forearm_z + a_J_forearm_y * c->links[2].m;
    const six_link_real t157 = h_c_forearm_f_z + Omega_forearm_zx * c->links[2].S_0_x + Omega_forearm_zy * S_forearm_y
        - minus_Omega_forearm_zz * S_forearm_z;
    const six_link_real H_star_forearm_f_z = t157 + a_J_forearm_z * c->links[2].m;

    /* forearm, h_V: bias of the twist rows, angular acceleration included */
    const six_link_real h_V_forearm_tau_x = H_star_forearm_tau_x + h_c_forearm_tau_x;
    const six_link_real h_V_forearm_tau_y = H_star_forearm_tau_y + h_c_forearm_tau_y;
    const six_link_real h_V_forearm_tau_z = H_star_forearm_tau_z + h_c_forearm_tau_z;
    const six_link_real h_V_forearm_f_x = H_star_forearm_f_x + h_c_forearm_f_x;
    const six_link_real h_V_forearm_f_y = H_star_forearm_f_y - minus_h_c_forearm_f_y;
    const six_link_real h_V_forearm_f_z = H_star_forearm_f_z + h_c_forearm_f_z;

    /* forearm, h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const six_link_real t158 = L_forearm_z1 * Omega_forearm_yz - L_forearm_y1 * minus_Omega_forearm_yy
        + Omega_forearm_yx * c->links[2].chi_1;
    const six_link_real h_eta_forearm_1 = t158 + a_J_forearm_y * c->links[2].sigma_y1
        - Ldot_forearm_z1 * 2 * omega_R_forearm_x;
    const six_link_real t159 = L_forearm_z2 * Omega_forearm_yz - L_forearm_y2 * minus_Omega_forearm_yy
        + Omega_forearm_yx * c->links[2].chi_2;
    const six_link_real h_eta_forearm_2 = t159 + a_J_forearm_y * c->links[2].sigma_y2
        - Ldot_forearm_z2 * 2 * omega_R_forearm_x;
    const six_link_real t160 = L_forearm_y1 * Omega_forearm_zy - L_forearm_z1 * minus_Omega_forearm_zz
        + Omega_forearm_zx * c->links[2].chi_1;
    const six_link_real h_eta_forearm_3 = t160 + a_J_forearm_z * c->links[2].sigma_y1
        + Ldot_forearm_y1 * 2 * omega_R_forearm_x;
    const six_link_real t161 = L_forearm_y2 * Omega_forearm_zy - L_forearm_z2 * minus_Omega_forearm_zz
        + Omega_forearm_zx * c->links[2].chi_2;
    const six_link_real h_eta_forearm_4 = t161 + a_J_forearm_z * c->links[2].sigma_y2
        + Ldot_forearm_y2 * 2 * omega_R_forearm_x;

    /* forearm, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real t162 = R_T_forearm_xx * input->w_ext[2][0] - R_T_forearm_yx * input->w_ext[2][1]
        + R_T_forearm_xz * input->w_ext[2][2];
    const six_link_real t163 = R_T_forearm_yx * input->w_ext[2][0] + R_T_forearm_yy * input->w_ext[2][1]
        + R_T_forearm_yz * input->w_ext[2][2];
    const six_link_real t164 = R_T_forearm_yz * input->w_ext[2][1] - R_T_forearm_xz * input->w_ext[2][0]
        + R_T_forearm_zz * input->w_ext[2][2];
    const six_link_real t165 = R_T_forearm_xx * input->w_ext[2][3] - R_T_forearm_yx * input->w_ext[2][4]
        + R_T_forearm_xz * input->w_ext[2][5];
    const six_link_real t166 = R_T_forearm_yx * input->w_ext[2][3] + R_T_forearm_yy * input->w_ext[2][4]
        + R_T_forearm_yz * input->w_ext[2][5];
    const six_link_real t167 = R_T_forearm_yz * input->w_ext[2][4] - R_T_forearm_xz * input->w_ext[2][3]
        + R_T_forearm_zz * input->w_ext[2][5];
    const six_link_real p_T_forearm_tau_x = p_wrist_roll_tau_x - t162;
    const six_link_real p_T_forearm_tau_y = p_wrist_roll_tau_y - t163;
    const six_link_real p_T_forearm_tau_z = p_wrist_roll_tau_z - t164;
    const six_link_real p_T_forearm_f_x = p_wrist_roll_f_x - t165;
    const six_link_real p_T_forearm_f_y = p_wrist_roll_f_y - t166;
    const six_link_real p_T_forearm_f_z = p_wrist_roll_f_z - t167;

    /* forearm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real Theta_forearm_11 = J_l_forearm_xz * c->links[2].Psi_c_z1;
    const six_link_real Theta_forearm_12 = J_l_forearm_xz * c->links[2].Psi_c_z2;
    const six_link_real minus_Theta_forearm_13 = J_l_forearm_yx * c->links[2].Psi_c_y3;
    const six_link_real minus_Theta_forearm_14 = J_l_forearm_yx * c->links[2].Psi_c_y4;
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
    const six_link_real h_loaded_forearm_tau_x = h_V_forearm_tau_x
        + (p_T_forearm_tau_x + (r_T_forearm_y * p_T_forearm_f_z - r_T_forearm_z * p_T_forearm_f_y));
    const six_link_real h_loaded_forearm_tau_y = h_V_forearm_tau_y
        + (p_T_forearm_tau_y + (r_T_forearm_z * p_T_forearm_f_x - c->links[2].length * p_T_forearm_f_z));
    const six_link_real h_loaded_forearm_tau_z = h_V_forearm_tau_z
        + (p_T_forearm_tau_z + (c->links[2].length * p_T_forearm_f_y - r_T_forearm_y * p_T_forearm_f_x));
    const six_link_real h_loaded_forearm_f_x = h_V_forearm_f_x + p_T_forearm_f_x;
    const six_link_real h_loaded_forearm_f_y = h_V_forearm_f_y + p_T_forearm_f_y;
    const six_link_real h_loaded_forearm_f_z = h_V_forearm_f_z + p_T_forearm_f_z;
    const six_link_real t183 = Lambda_wrist_roll_1 * Theta_forearm_11 + Lambda_wrist_roll_2 * Theta_forearm_21
        + Lambda_wrist_roll_3 * Theta_forearm_31;
    const six_link_real t184 = t183 + Lambda_wrist_roll_5 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t185 = Lambda_wrist_roll_1 * Theta_forearm_12 + Lambda_wrist_roll_2 * Theta_forearm_22
        + Lambda_wrist_roll_3 * Theta_forearm_32;
    const six_link_real t186 = t185 + Lambda_wrist_roll_5 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t187 = Lambda_wrist_roll_2 * Theta_forearm_23 - Lambda_wrist_roll_1 * minus_Theta_forearm_13
        + Lambda_wrist_roll_3 * Theta_forearm_33;
    const six_link_real t188 = t187 + Lambda_wrist_roll_6 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t189 = Lambda_wrist_roll_2 * Theta_forearm_24 - Lambda_wrist_roll_1 * minus_Theta_forearm_14
        + Lambda_wrist_roll_3 * Theta_forearm_34;
    const six_link_real t190 = t189 + Lambda_wrist_roll_6 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t191 = Lambda_wrist_roll_2 * Theta_forearm_11 + Lambda_wrist_roll_7 * Theta_forearm_21
        + Lambda_wrist_roll_8 * Theta_forearm_31;
    const six_link_real t192 = t191 + Lambda_wrist_roll_10 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t193 = Lambda_wrist_roll_2 * Theta_forearm_12 + Lambda_wrist_roll_7 * Theta_forearm_22
        + Lambda_wrist_roll_8 * Theta_forearm_32;
    const six_link_real t194 = t193 + Lambda_wrist_roll_10 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t195 = Lambda_wrist_roll_7 * Theta_forearm_23 - Lambda_wrist_roll_2 * minus_Theta_forearm_13
        + Lambda_wrist_roll_8 * Theta_forearm_33;
    const six_link_real t196 = t195 + Lambda_wrist_roll_11 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t197 = Lambda_wrist_roll_7 * Theta_forearm_24 - Lambda_wrist_roll_2 * minus_Theta_forearm_14
        + Lambda_wrist_roll_8 * Theta_forearm_34;
    const six_link_real t198 = t197 + Lambda_wrist_roll_11 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t199 = Lambda_wrist_roll_3 * Theta_forearm_11 + Lambda_wrist_roll_8 * Theta_forearm_21
        + Lambda_wrist_roll_12 * Theta_forearm_31;
    const six_link_real t200 = t199 + Lambda_wrist_roll_14 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t201 = Lambda_wrist_roll_3 * Theta_forearm_12 + Lambda_wrist_roll_8 * Theta_forearm_22
        + Lambda_wrist_roll_12 * Theta_forearm_32;
    const six_link_real t202 = t201 + Lambda_wrist_roll_14 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t203 = Lambda_wrist_roll_8 * Theta_forearm_23 - Lambda_wrist_roll_3 * minus_Theta_forearm_13
        + Lambda_wrist_roll_12 * Theta_forearm_33;
    const six_link_real t204 = t203 + Lambda_wrist_roll_15 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t205 = Lambda_wrist_roll_8 * Theta_forearm_24 - Lambda_wrist_roll_3 * minus_Theta_forearm_14
        + Lambda_wrist_roll_12 * Theta_forearm_34;
    const six_link_real t206 = t205 + Lambda_wrist_roll_15 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t207 = Lambda_wrist_roll_4 * Theta_forearm_11 + Lambda_wrist_roll_9 * Theta_forearm_21
        + Lambda_wrist_roll_13 * Theta_forearm_31;
    const six_link_real C_forearm_41 = t207 + Lambda_wrist_roll_17 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t208 = Lambda_wrist_roll_4 * Theta_forearm_12 + Lambda_wrist_roll_9 * Theta_forearm_22
        + Lambda_wrist_roll_13 * Theta_forearm_32;
    const six_link_real C_forearm_42 = t208 + Lambda_wrist_roll_17 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t209 = Lambda_wrist_roll_9 * Theta_forearm_23 - Lambda_wrist_roll_4 * minus_Theta_forearm_13
        + Lambda_wrist_roll_13 * Theta_forearm_33;
    const six_link_real C_forearm_43 = t209 + Lambda_wrist_roll_18 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t210 = Lambda_wrist_roll_9 * Theta_forearm_24 - Lambda_wrist_roll_4 * minus_Theta_forearm_14
        + Lambda_wrist_roll_13 * Theta_forearm_34;
    const six_link_real C_forearm_44 = t210 + Lambda_wrist_roll_18 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t211 = Lambda_wrist_roll_5 * Theta_forearm_11 + Lambda_wrist_roll_10 * Theta_forearm_21
        + Lambda_wrist_roll_14 * Theta_forearm_31;
    const six_link_real t212 = t211 + Lambda_wrist_roll_19 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t213 = Lambda_wrist_roll_5 * Theta_forearm_12 + Lambda_wrist_roll_10 * Theta_forearm_22
        + Lambda_wrist_roll_14 * Theta_forearm_32;
    const six_link_real t214 = t213 + Lambda_wrist_roll_19 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t215 = Lambda_wrist_roll_10 * Theta_forearm_23 - Lambda_wrist_roll_5 * minus_Theta_forearm_13
        + Lambda_wrist_roll_14 * Theta_forearm_33;
    const six_link_real t216 = Lambda_wrist_roll_20 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real C_forearm_53 = t215 + t216;
    const six_link_real t217 = Lambda_wrist_roll_10 * Theta_forearm_24 - Lambda_wrist_roll_5 * minus_Theta_forearm_14
        + Lambda_wrist_roll_14 * Theta_forearm_34;
    const six_link_real t218 = Lambda_wrist_roll_20 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_forearm_54 = t217 + t218;
    const six_link_real t219 = Lambda_wrist_roll_6 * Theta_forearm_11 + Lambda_wrist_roll_11 * Theta_forearm_21
        + Lambda_wrist_roll_15 * Theta_forearm_31;
    const six_link_real C_forearm_61 = t219 + t216;
    const six_link_real t220 = Lambda_wrist_roll_6 * Theta_forearm_12 + Lambda_wrist_roll_11 * Theta_forearm_22
        + Lambda_wrist_roll_15 * Theta_forearm_32;
    const six_link_real C_forearm_62 = t220 + t218;
    const six_link_real t221 = Lambda_wrist_roll_11 * Theta_forearm_23 - Lambda_wrist_roll_6 * minus_Theta_forearm_13
        + Lambda_wrist_roll_15 * Theta_forearm_33;
    const six_link_real t222 = t221 + Lambda_wrist_roll_21 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t223 = Lambda_wrist_roll_11 * Theta_forearm_24 - Lambda_wrist_roll_6 * minus_Theta_forearm_14
        + Lambda_wrist_roll_15 * Theta_forearm_34;
    const six_link_real t224 = t223 + Lambda_wrist_roll_21 * SIX_LINK_REAL(2.8145226674626453);
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
        + t212 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_forearm_11 = t225 + m_eta[11];
    bad |= (unsigned long)(!(modal_inertia_forearm_11 > 0)) << 2;
    const six_link_real modal_inertia_forearm_12 = Theta_forearm_11 * t186 + Theta_forearm_21 * t194
        + Theta_forearm_31 * t202 + t214 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_forearm_13 = Theta_forearm_11 * t188 + Theta_forearm_21 * t196
        + Theta_forearm_31 * t204 + C_forearm_53 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_forearm_14 = Theta_forearm_11 * t190 + Theta_forearm_21 * t198
        + Theta_forearm_31 * t206 + C_forearm_54 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t226 = Theta_forearm_12 * t186 + Theta_forearm_22 * t194 + Theta_forearm_32 * t202
        + t214 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_forearm_22 = t226 + m_eta[12];
    const six_link_real modal_inertia_forearm_23 = Theta_forearm_12 * t188 + Theta_forearm_22 * t196
        + Theta_forearm_32 * t204 + C_forearm_53 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_forearm_24 = Theta_forearm_12 * t190 + Theta_forearm_22 * t198
        + Theta_forearm_32 * t206 + C_forearm_54 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t227 = Theta_forearm_23 * t196 - minus_Theta_forearm_13 * t188 + Theta_forearm_33 * t204
        + t222 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_forearm_33 = t227 + m_eta[13];
    const six_link_real modal_inertia_forearm_34 = Theta_forearm_23 * t198 - minus_Theta_forearm_13 * t190
        + Theta_forearm_33 * t206 + t224 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t228 = Theta_forearm_24 * t198 - minus_Theta_forearm_14 * t190 + Theta_forearm_34 * t206
        + t224 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_forearm_44 = t228 + m_eta[14];
    const six_link_real t229 = Theta_forearm_11 * p_T_forearm_tau_x + Theta_forearm_21 * p_T_forearm_tau_y
        + Theta_forearm_31 * p_T_forearm_tau_z;
    const six_link_real t230 = Theta_forearm_12 * p_T_forearm_tau_x + Theta_forearm_22 * p_T_forearm_tau_y
        + Theta_forearm_32 * p_T_forearm_tau_z;
    const six_link_real t231 = Theta_forearm_23 * p_T_forearm_tau_y - minus_Theta_forearm_13 * p_T_forearm_tau_x
        + Theta_forearm_33 * p_T_forearm_tau_z;
    const six_link_real t232 = Theta_forearm_24 * p_T_forearm_tau_y - minus_Theta_forearm_14 * p_T_forearm_tau_x
        + Theta_forearm_34 * p_T_forearm_tau_z;
    const six_link_real h_phi_forearm_1 = h_eta_forearm_1 + work->f_eta[11]
        + (t229 + p_T_forearm_f_y * SIX_LINK_REAL(2.0195202782688155));
    const six_link_real h_phi_forearm_2 = h_eta_forearm_2 + work->f_eta[12]
        + (t230 + p_T_forearm_f_y * SIX_LINK_REAL(2.8145226674626453));
    const six_link_real h_phi_forearm_3 = h_eta_forearm_3 + work->f_eta[13]
        + (t231 + p_T_forearm_f_z * SIX_LINK_REAL(2.0195202782688155));
    const six_link_real h_phi_forearm_4 = h_eta_forearm_4 + work->f_eta[14]
        + (t232 + p_T_forearm_f_z * SIX_LINK_REAL(2.8145226674626453));
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
    const six_link_real h_i_forearm_tau_x = h_loaded_forearm_tau_x - t282;
    const six_link_real h_i_forearm_tau_y = h_loaded_forearm_tau_y - t283;
    const six_link_real h_i_forearm_tau_z = h_loaded_forearm_tau_z - t284;
    const six_link_real h_i_forearm_f_x = h_loaded_forearm_f_x - t285;
    const six_link_real h_i_forearm_f_y = h_loaded_forearm_f_y - t286;
    const six_link_real h_i_forearm_f_z = h_loaded_forearm_f_z - t287;

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
    const six_link_real joint_w_forearm_1 = (input->tau[2] - work->f_eta[2] - h_i_forearm_tau_y)
        * joint_inverse_forearm_1;
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
    const six_link_real p_i_forearm_tau_x = h_i_forearm_tau_x + M_i_forearm_12 * joint_w_forearm_1;
    const six_link_real p_i_forearm_tau_y = h_i_forearm_tau_y + M_i_forearm_22 * joint_w_forearm_1;
    const six_link_real p_i_forearm_tau_z = h_i_forearm_tau_z + M_i_forearm_23 * joint_w_forearm_1;
    const six_link_real p_i_forearm_f_x = h_i_forearm_f_x + M_i_forearm_24 * joint_w_forearm_1;
    const six_link_real p_i_forearm_f_y = h_i_forearm_f_y + M_i_forearm_25 * joint_w_forearm_1;
    const six_link_real p_i_forearm_f_z = h_i_forearm_f_z + M_i_forearm_26 * joint_w_forearm_1;

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
    const six_link_real t310 = (t300 + (r_R_forearm_y * t293 - r_R_forearm_z * t292) - t309) * SIX_LINK_REAL(0.5);
    const six_link_real t311 = t310 * R_P_forearm_xx + t302 * R_P_forearm_xy + t304 * R_P_forearm_xz;
    const six_link_real t312 = t310 * R_P_forearm_yx + t302 * R_P_forearm_yy + t304 * R_P_forearm_yz;
    const six_link_real t313 = t310 * R_P_forearm_zx + t302 * R_P_forearm_zy + t304 * R_P_forearm_zz;
    const six_link_real t314 = (t305 + (r_R_forearm_z * t294 - r_R_forearm_x * t296) - t309) * SIX_LINK_REAL(0.5);
    const six_link_real t315 = t314 * R_P_forearm_xy + t307 * R_P_forearm_xz;
    const six_link_real t316 = t314 * R_P_forearm_yy + t307 * R_P_forearm_yz;
    const six_link_real t317 = t314 * R_P_forearm_zy + t307 * R_P_forearm_zz;
    const six_link_real Lambda_forearm_1 = (R_P_forearm_xx * t311 + R_P_forearm_xy * t315) * 2 + t309;
    const six_link_real Lambda_forearm_2 = R_P_forearm_xx * t312 + R_P_forearm_xy * t316
        + (R_P_forearm_yx * t311 + R_P_forearm_yy * t315);
    const six_link_real Lambda_forearm_3 = R_P_forearm_xx * t313 + R_P_forearm_xy * t317
        + (R_P_forearm_zx * t311 + R_P_forearm_zy * t315);
    const six_link_real Lambda_forearm_7 = (R_P_forearm_yx * t312 + R_P_forearm_yy * t316) * 2 + t309;
    const six_link_real Lambda_forearm_8 = R_P_forearm_yx * t313 + R_P_forearm_yy * t317
        + (R_P_forearm_zx * t312 + R_P_forearm_zy * t316);
    const six_link_real Lambda_forearm_12 = (R_P_forearm_zx * t313 + R_P_forearm_zy * t317) * 2 + t309;
    const six_link_real t318 = t291 * R_P_forearm_xx + t292 * R_P_forearm_xy + t293 * R_P_forearm_xz;
    const six_link_real t319 = t291 * R_P_forearm_yx + t292 * R_P_forearm_yy + t293 * R_P_forearm_yz;
    const six_link_real t320 = t291 * R_P_forearm_zx + t292 * R_P_forearm_zy + t293 * R_P_forearm_zz;
    const six_link_real t321 = t294 * R_P_forearm_xx + t295 * R_P_forearm_xy + t296 * R_P_forearm_xz;
    const six_link_real t322 = t294 * R_P_forearm_yx + t295 * R_P_forearm_yy + t296 * R_P_forearm_yz;
    const six_link_real t323 = t294 * R_P_forearm_zx + t295 * R_P_forearm_zy + t296 * R_P_forearm_zz;
    const six_link_real t324 = t297 * R_P_forearm_xx + t298 * R_P_forearm_xy + t299 * R_P_forearm_xz;
    const six_link_real t325 = t297 * R_P_forearm_yx + t298 * R_P_forearm_yy + t299 * R_P_forearm_yz;
    const six_link_real t326 = t297 * R_P_forearm_zx + t298 * R_P_forearm_zy + t299 * R_P_forearm_zz;
    const six_link_real Lambda_forearm_4 = R_P_forearm_xx * t318 + R_P_forearm_xy * t321 + R_P_forearm_xz * t324;
    const six_link_real Lambda_forearm_5 = R_P_forearm_xx * t319 + R_P_forearm_xy * t322 + R_P_forearm_xz * t325;
    const six_link_real Lambda_forearm_6 = R_P_forearm_xx * t320 + R_P_forearm_xy * t323 + R_P_forearm_xz * t326;
    const six_link_real Lambda_forearm_9 = R_P_forearm_yx * t318 + R_P_forearm_yy * t321 + R_P_forearm_yz * t324;
    const six_link_real Lambda_forearm_10 = R_P_forearm_yx * t319 + R_P_forearm_yy * t322 + R_P_forearm_yz * t325;
    const six_link_real Lambda_forearm_11 = R_P_forearm_yx * t320 + R_P_forearm_yy * t323 + R_P_forearm_yz * t326;
    const six_link_real Lambda_forearm_13 = R_P_forearm_zx * t318 + R_P_forearm_zy * t321 + R_P_forearm_zz * t324;
    const six_link_real Lambda_forearm_14 = R_P_forearm_zx * t319 + R_P_forearm_zy * t322 + R_P_forearm_zz * t325;
    const six_link_real Lambda_forearm_15 = R_P_forearm_zx * t320 + R_P_forearm_zy * t323 + R_P_forearm_zz * t326;
    const six_link_real t327 = (Lambda_i_forearm_44 - Lambda_i_forearm_66) * SIX_LINK_REAL(0.5);
    const six_link_real t328 = t327 * R_P_forearm_xx + Lambda_i_forearm_45 * R_P_forearm_xy
        + Lambda_i_forearm_46 * R_P_forearm_xz;
    const six_link_real t329 = t327 * R_P_forearm_yx + Lambda_i_forearm_45 * R_P_forearm_yy
        + Lambda_i_forearm_46 * R_P_forearm_yz;
    const six_link_real t330 = t327 * R_P_forearm_zx + Lambda_i_forearm_45 * R_P_forearm_zy
        + Lambda_i_forearm_46 * R_P_forearm_zz;
    const six_link_real t331 = (Lambda_i_forearm_55 - Lambda_i_forearm_66) * SIX_LINK_REAL(0.5);
    const six_link_real t332 = t331 * R_P_forearm_xy + Lambda_i_forearm_56 * R_P_forearm_xz;
    const six_link_real t333 = t331 * R_P_forearm_yy + Lambda_i_forearm_56 * R_P_forearm_yz;
    const six_link_real t334 = t331 * R_P_forearm_zy + Lambda_i_forearm_56 * R_P_forearm_zz;
    const six_link_real Lambda_forearm_16 = (R_P_forearm_xx * t328 + R_P_forearm_xy * t332) * 2 + Lambda_i_forearm_66;
    const six_link_real Lambda_forearm_17 = R_P_forearm_xx * t329 + R_P_forearm_xy * t333
        + (R_P_forearm_yx * t328 + R_P_forearm_yy * t332);
    const six_link_real Lambda_forearm_18 = R_P_forearm_xx * t330 + R_P_forearm_xy * t334
        + (R_P_forearm_zx * t328 + R_P_forearm_zy * t332);
    const six_link_real Lambda_forearm_19 = (R_P_forearm_yx * t329 + R_P_forearm_yy * t333) * 2 + Lambda_i_forearm_66;
    const six_link_real Lambda_forearm_20 = R_P_forearm_yx * t330 + R_P_forearm_yy * t334
        + (R_P_forearm_zx * t329 + R_P_forearm_zy * t333);
    const six_link_real Lambda_forearm_21 = (R_P_forearm_zx * t330 + R_P_forearm_zy * t334) * 2 + Lambda_i_forearm_66;
    const six_link_real t335 = p_i_forearm_tau_x + (r_R_forearm_y * p_i_forearm_f_z - r_R_forearm_z * p_i_forearm_f_y);
    const six_link_real t336 = p_i_forearm_tau_y + (r_R_forearm_z * p_i_forearm_f_x - r_R_forearm_x * p_i_forearm_f_z);
    const six_link_real t337 = p_i_forearm_tau_z + (r_R_forearm_x * p_i_forearm_f_y - r_R_forearm_y * p_i_forearm_f_x);
    const six_link_real p_forearm_tau_x = R_P_forearm_xx * t335 + R_P_forearm_xy * t336 + R_P_forearm_xz * t337;
    const six_link_real p_forearm_tau_y = R_P_forearm_yx * t335 + R_P_forearm_yy * t336 + R_P_forearm_yz * t337;
    const six_link_real p_forearm_tau_z = R_P_forearm_zx * t335 + R_P_forearm_zy * t336 + R_P_forearm_zz * t337;
    const six_link_real p_forearm_f_x = R_P_forearm_xx * p_i_forearm_f_x + R_P_forearm_xy * p_i_forearm_f_y
        + R_P_forearm_xz * p_i_forearm_f_z;
    const six_link_real p_forearm_f_y = R_P_forearm_yx * p_i_forearm_f_x + R_P_forearm_yy * p_i_forearm_f_y
        + R_P_forearm_yz * p_i_forearm_f_z;
    const six_link_real p_forearm_f_z = R_P_forearm_zx * p_i_forearm_f_x + R_P_forearm_zy * p_i_forearm_f_y
        + R_P_forearm_zz * p_i_forearm_f_z;

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
    const six_link_real t339 = omega_R_upper_arm_z * omega_R_upper_arm_z;
    const six_link_real minus_Omega_upper_arm_xx = t338 + t339;
    const six_link_real minus_Omega_upper_arm_xz = minus_omega_R_upper_arm_x * omega_R_upper_arm_z;
    const six_link_real minus_Omega_upper_arm_yx = minus_alpha_upper_arm_z + minus_alpha_upper_arm_z;
    const six_link_real t340 = minus_omega_R_upper_arm_x * minus_omega_R_upper_arm_x;
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

    /* upper_arm, h_c: half of the Coriolis wrench: H* has one half, h_MD the other */
    const six_link_real minus_h_c_upper_arm_tau_x = B_upper_arm_yy * minus_omega_R_upper_arm_x
        + B_upper_arm_zz * minus_omega_R_upper_arm_x;
    const six_link_real h_c_upper_arm_tau_y = B_upper_arm_zz * state->v[1]
        + B_upper_arm_yx * minus_omega_R_upper_arm_x - B_upper_arm_yz * omega_R_upper_arm_z;
    const six_link_real h_c_upper_arm_tau_z = B_upper_arm_yy * omega_R_upper_arm_z
        + B_upper_arm_zx * minus_omega_R_upper_arm_x - B_upper_arm_zy * state->v[1];
    const six_link_real h_c_upper_arm_f_x = Sdot_upper_arm_z * state->v[1] - Sdot_upper_arm_y * omega_R_upper_arm_z;
    const six_link_real h_c_upper_arm_f_y = Sdot_upper_arm_z * minus_omega_R_upper_arm_x;
    const six_link_real minus_h_c_upper_arm_f_z = Sdot_upper_arm_y * minus_omega_R_upper_arm_x;

    /* upper_arm, h_MD: Coriolis wrench of the deformation's inertia (B3) */
    const six_link_real h_MD_upper_arm_tau_y = h_c_upper_arm_tau_y
        + state->v[10] * omega_R_upper_arm_z * c->links[1].sigma_t_5;
    const six_link_real h_MD_upper_arm_tau_z = h_c_upper_arm_tau_z - state->v[10] * state->v[1] * c->links[1].sigma_t_5;

    /* upper_arm, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real t341 = minus_h_c_upper_arm_tau_x + c->links[1].I_s * minus_alpha_upper_arm_x
        + J_upper_arm_xy * minus_Omega_upper_arm_xz;
    const six_link_real t342 = J_upper_arm_yz * (minus_Omega_upper_arm_yy - minus_Omega_upper_arm_zz) - t341
        - S_upper_arm_y * minus_a_J_upper_arm_z;
    const six_link_real H_star_upper_arm_tau_x = t342 + J_upper_arm_xz * minus_Omega_upper_arm_yx
        - J_upper_arm_zz * Omega_upper_arm_yz - S_upper_arm_z * a_J_upper_arm_y;
    const six_link_real t343 = h_c_upper_arm_tau_y
        + J_upper_arm_xz * (minus_Omega_upper_arm_zz - minus_Omega_upper_arm_xx)
        - J_upper_arm_zz * minus_Omega_upper_arm_xz;
    const six_link_real t344 = c->links[1].I_s * minus_omega_R_upper_arm_x;
    const six_link_real t345 = t343 + S_upper_arm_z * a_J_upper_arm_x - t344 * omega_R_upper_arm_z
        + c->links[1].J_0_xx * minus_Omega_upper_arm_xz;
    const six_link_real H_star_upper_arm_tau_y = t345 + c->links[1].S_0_x * minus_a_J_upper_arm_z;
    const six_link_real t346 = h_c_upper_arm_tau_z - c->links[1].J_0_xx * minus_Omega_upper_arm_yx
        + J_upper_arm_xy * (minus_Omega_upper_arm_xx - minus_Omega_upper_arm_yy);
    const six_link_real t347 = t346 + J_upper_arm_xz * Omega_upper_arm_yz + c->links[1].S_0_x * a_J_upper_arm_y
        + J_upper_arm_yz * minus_Omega_upper_arm_xz;
    const six_link_real H_star_upper_arm_tau_z = t347 - S_upper_arm_y * a_J_upper_arm_x + t344 * state->v[1];
    const six_link_real t348 = h_c_upper_arm_f_x - minus_Omega_upper_arm_xx * c->links[1].S_0_x
        - minus_Omega_upper_arm_xz * S_upper_arm_z;
    const six_link_real H_star_upper_arm_f_x = t348 + a_J_upper_arm_x * c->links[1].mu;
    const six_link_real t349 = h_c_upper_arm_f_y - minus_Omega_upper_arm_yx * c->links[1].S_0_x
        - minus_Omega_upper_arm_yy * S_upper_arm_y;
    const six_link_real H_star_upper_arm_f_y = t349 + Omega_upper_arm_yz * S_upper_arm_z
        + a_J_upper_arm_y * c->links[1].mu;
    const six_link_real t350 = minus_h_c_upper_arm_f_z + minus_Omega_upper_arm_xz * c->links[1].S_0_x
        + minus_Omega_upper_arm_zz * S_upper_arm_z;
    const six_link_real minus_H_star_upper_arm_f_z = t350 + minus_a_J_upper_arm_z * c->links[1].mu;

    /* upper_arm, h_V: bias of the twist rows, angular acceleration included */
    const six_link_real h_V_upper_arm_tau_x = H_star_upper_arm_tau_x - minus_h_c_upper_arm_tau_x;
    const six_link_real h_V_upper_arm_tau_y = H_star_upper_arm_tau_y + h_MD_upper_arm_tau_y;
    const six_link_real h_V_upper_arm_tau_z = H_star_upper_arm_tau_z + h_MD_upper_arm_tau_z;
    const six_link_real h_V_upper_arm_f_x = H_star_upper_arm_f_x + h_c_upper_arm_f_x;
    const six_link_real h_V_upper_arm_f_y = H_star_upper_arm_f_y + h_c_upper_arm_f_y;
    const six_link_real minus_h_V_upper_arm_f_z = minus_H_star_upper_arm_f_z + minus_h_c_upper_arm_f_z;

    /* upper_arm, h_eta: gyroscopic force and weight on the modes, angular acceleration included */
    const six_link_real t351 = L_upper_arm_z1 * Omega_upper_arm_yz - L_upper_arm_y1 * minus_Omega_upper_arm_yy
        - minus_Omega_upper_arm_yx * c->links[1].chi_1;
    const six_link_real h_eta_upper_arm_1 = t351 + a_J_upper_arm_y * c->links[1].sigma_y1
        + Ldot_upper_arm_z1 * 2 * minus_omega_R_upper_arm_x;
    const six_link_real t352 = L_upper_arm_z2 * Omega_upper_arm_yz - L_upper_arm_y2 * minus_Omega_upper_arm_yy
        - minus_Omega_upper_arm_yx * c->links[1].chi_2;
    const six_link_real h_eta_upper_arm_2 = t352 + a_J_upper_arm_y * c->links[1].sigma_y2
        + Ldot_upper_arm_z2 * 2 * minus_omega_R_upper_arm_x;
    const six_link_real t353 = L_upper_arm_z1 * minus_Omega_upper_arm_zz
        + minus_Omega_upper_arm_xz * c->links[1].chi_1 + minus_a_J_upper_arm_z * c->links[1].sigma_y1;
    const six_link_real minus_h_eta_upper_arm_3 = t353 + Ldot_upper_arm_y1 * 2 * minus_omega_R_upper_arm_x;
    const six_link_real t354 = L_upper_arm_z2 * minus_Omega_upper_arm_zz
        + minus_Omega_upper_arm_xz * c->links[1].chi_2 + minus_a_J_upper_arm_z * c->links[1].sigma_y2;
    const six_link_real minus_h_eta_upper_arm_4 = t354 + Ldot_upper_arm_y2 * 2 * minus_omega_R_upper_arm_x;
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
    const six_link_real p_T_upper_arm_tau_x = p_forearm_tau_x
        + (t379 + (omega_t_upper_arm_y * t384 - omega_t_upper_arm_z * t383)) - t373;
    const six_link_real p_T_upper_arm_tau_y = p_forearm_tau_y
        + (t380 + (omega_t_upper_arm_z * t382 - omega_t_upper_arm_x * t384)) - t374;
    const six_link_real p_T_upper_arm_tau_z = p_forearm_tau_z
        + (t381 + (omega_t_upper_arm_x * t383 - omega_t_upper_arm_y * t382)) - t375;
    const six_link_real p_T_upper_arm_f_x = p_forearm_f_x + (c->links[1].body0_mass * a_t_upper_arm_x + t388) - t376;
    const six_link_real p_T_upper_arm_f_y = p_forearm_f_y + (c->links[1].body0_mass * a_t_upper_arm_y + t389) - t377;
    const six_link_real p_T_upper_arm_f_z = p_forearm_f_z + (t390 - c->links[1].body0_mass * minus_a_t_upper_arm_z)
        - t378;

    /* upper_arm, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real Theta_upper_arm_11 = J_l_upper_arm_xz * c->links[1].Psi_c_z1;
    const six_link_real Theta_upper_arm_12 = J_l_upper_arm_xz * c->links[1].Psi_c_z2;
    const six_link_real Theta_upper_arm_13 = J_l_upper_arm_xy * c->links[1].Psi_c_y3;
    const six_link_real Theta_upper_arm_14 = J_l_upper_arm_xy * c->links[1].Psi_c_y4;
    const six_link_real Theta_upper_arm_15 = J_l_upper_arm_xx * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real Theta_upper_arm_21 = J_l_upper_arm_yz * c->links[1].Psi_c_z1;
    const six_link_real Theta_upper_arm_22 = J_l_upper_arm_yz * c->links[1].Psi_c_z2;
    const six_link_real Theta_upper_arm_23 = J_l_upper_arm_yy * c->links[1].Psi_c_y3;
    const six_link_real Theta_upper_arm_24 = J_l_upper_arm_yy * c->links[1].Psi_c_y4;
    const six_link_real Theta_upper_arm_25 = J_l_upper_arm_yx * SIX_LINK_REAL(1.7320508075688772);
    const six_link_real Theta_upper_arm_31 = J_l_upper_arm_zz * c->links[1].Psi_c_z1;
    const six_link_real Theta_upper_arm_32 = J_l_upper_arm_zz * c->links[1].Psi_c_z2;
    const six_link_real Theta_upper_arm_33 = J_l_upper_arm_zy * c->links[1].Psi_c_y3;
    const six_link_real Theta_upper_arm_34 = J_l_upper_arm_zy * c->links[1].Psi_c_y4;
    const six_link_real Theta_upper_arm_35 = J_l_upper_arm_zx * SIX_LINK_REAL(1.7320508075688772);
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
    const six_link_real t406 = p_T_upper_arm_tau_x
        + (r_T_upper_arm_y * p_T_upper_arm_f_z - r_T_upper_arm_z * p_T_upper_arm_f_y);
    const six_link_real t407 = p_T_upper_arm_tau_y
        + (r_T_upper_arm_z * p_T_upper_arm_f_x - c->links[1].length * p_T_upper_arm_f_z);
    const six_link_real t408 = p_T_upper_arm_tau_z
        + (c->links[1].length * p_T_upper_arm_f_y - r_T_upper_arm_y * p_T_upper_arm_f_x);
    const six_link_real h_loaded_upper_arm_tau_x = h_V_upper_arm_tau_x + t406;
    const six_link_real h_loaded_upper_arm_tau_y = h_V_upper_arm_tau_y + t407;
    const six_link_real h_loaded_upper_arm_tau_z = h_V_upper_arm_tau_z + t408;
    const six_link_real h_loaded_upper_arm_f_x = h_V_upper_arm_f_x + p_T_upper_arm_f_x;
    const six_link_real h_loaded_upper_arm_f_y = h_V_upper_arm_f_y + p_T_upper_arm_f_y;
    const six_link_real h_loaded_upper_arm_f_z = p_T_upper_arm_f_z - minus_h_V_upper_arm_f_z;
    const six_link_real t409 = Lambda_T_upper_arm_11 * Theta_upper_arm_11 + Lambda_T_upper_arm_12 * Theta_upper_arm_21
        + Lambda_T_upper_arm_13 * Theta_upper_arm_31;
    const six_link_real t410 = t409 + Lambda_T_upper_arm_15 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t411 = Lambda_T_upper_arm_11 * Theta_upper_arm_12 + Lambda_T_upper_arm_12 * Theta_upper_arm_22
        + Lambda_T_upper_arm_13 * Theta_upper_arm_32;
    const six_link_real t412 = t411 + Lambda_T_upper_arm_15 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t413 = Lambda_T_upper_arm_11 * Theta_upper_arm_13 + Lambda_T_upper_arm_12 * Theta_upper_arm_23
        + Lambda_T_upper_arm_13 * Theta_upper_arm_33;
    const six_link_real t414 = t413 + Lambda_T_upper_arm_16 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t415 = Lambda_T_upper_arm_11 * Theta_upper_arm_14 + Lambda_T_upper_arm_12 * Theta_upper_arm_24
        + Lambda_T_upper_arm_13 * Theta_upper_arm_34;
    const six_link_real t416 = t415 + Lambda_T_upper_arm_16 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t417 = Lambda_T_upper_arm_11 * Theta_upper_arm_15 + Lambda_T_upper_arm_12 * Theta_upper_arm_25
        + Lambda_T_upper_arm_13 * Theta_upper_arm_35;
    const six_link_real t418 = Lambda_T_upper_arm_12 * Theta_upper_arm_11 + Lambda_T_upper_arm_22 * Theta_upper_arm_21
        + Lambda_T_upper_arm_23 * Theta_upper_arm_31;
    const six_link_real t419 = t418 + Lambda_forearm_10 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t420 = Lambda_T_upper_arm_12 * Theta_upper_arm_12 + Lambda_T_upper_arm_22 * Theta_upper_arm_22
        + Lambda_T_upper_arm_23 * Theta_upper_arm_32;
    const six_link_real t421 = t420 + Lambda_forearm_10 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t422 = Lambda_T_upper_arm_12 * Theta_upper_arm_13 + Lambda_T_upper_arm_22 * Theta_upper_arm_23
        + Lambda_T_upper_arm_23 * Theta_upper_arm_33;
    const six_link_real t423 = t422 + Lambda_T_upper_arm_26 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t424 = Lambda_T_upper_arm_12 * Theta_upper_arm_14 + Lambda_T_upper_arm_22 * Theta_upper_arm_24
        + Lambda_T_upper_arm_23 * Theta_upper_arm_34;
    const six_link_real t425 = t424 + Lambda_T_upper_arm_26 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t426 = Lambda_T_upper_arm_12 * Theta_upper_arm_15 + Lambda_T_upper_arm_22 * Theta_upper_arm_25
        + Lambda_T_upper_arm_23 * Theta_upper_arm_35;
    const six_link_real t427 = Lambda_T_upper_arm_13 * Theta_upper_arm_11 + Lambda_T_upper_arm_23 * Theta_upper_arm_21
        + Lambda_T_upper_arm_33 * Theta_upper_arm_31;
    const six_link_real t428 = t427 + Lambda_T_upper_arm_35 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t429 = Lambda_T_upper_arm_13 * Theta_upper_arm_12 + Lambda_T_upper_arm_23 * Theta_upper_arm_22
        + Lambda_T_upper_arm_33 * Theta_upper_arm_32;
    const six_link_real t430 = t429 + Lambda_T_upper_arm_35 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t431 = Lambda_T_upper_arm_13 * Theta_upper_arm_13 + Lambda_T_upper_arm_23 * Theta_upper_arm_23
        + Lambda_T_upper_arm_33 * Theta_upper_arm_33;
    const six_link_real t432 = t431 + Lambda_forearm_15 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t433 = Lambda_T_upper_arm_13 * Theta_upper_arm_14 + Lambda_T_upper_arm_23 * Theta_upper_arm_24
        + Lambda_T_upper_arm_33 * Theta_upper_arm_34;
    const six_link_real t434 = t433 + Lambda_forearm_15 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t435 = Lambda_T_upper_arm_13 * Theta_upper_arm_15 + Lambda_T_upper_arm_23 * Theta_upper_arm_25
        + Lambda_T_upper_arm_33 * Theta_upper_arm_35;
    const six_link_real t436 = Lambda_forearm_4 * Theta_upper_arm_11 + Lambda_T_upper_arm_24 * Theta_upper_arm_21
        + Lambda_T_upper_arm_34 * Theta_upper_arm_31;
    const six_link_real C_upper_arm_41 = t436 + Lambda_forearm_17 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t437 = Lambda_forearm_4 * Theta_upper_arm_12 + Lambda_T_upper_arm_24 * Theta_upper_arm_22
        + Lambda_T_upper_arm_34 * Theta_upper_arm_32;
    const six_link_real C_upper_arm_42 = t437 + Lambda_forearm_17 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t438 = Lambda_forearm_4 * Theta_upper_arm_13 + Lambda_T_upper_arm_24 * Theta_upper_arm_23
        + Lambda_T_upper_arm_34 * Theta_upper_arm_33;
    const six_link_real C_upper_arm_43 = t438 + Lambda_forearm_18 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t439 = Lambda_forearm_4 * Theta_upper_arm_14 + Lambda_T_upper_arm_24 * Theta_upper_arm_24
        + Lambda_T_upper_arm_34 * Theta_upper_arm_34;
    const six_link_real C_upper_arm_44 = t439 + Lambda_forearm_18 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_upper_arm_45 = Lambda_forearm_4 * Theta_upper_arm_15
        + Lambda_T_upper_arm_24 * Theta_upper_arm_25 + Lambda_T_upper_arm_34 * Theta_upper_arm_35;
    const six_link_real t440 = Lambda_T_upper_arm_15 * Theta_upper_arm_11 + Lambda_forearm_10 * Theta_upper_arm_21
        + Lambda_T_upper_arm_35 * Theta_upper_arm_31;
    const six_link_real t441 = t440 + Lambda_T_upper_arm_55 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t442 = Lambda_T_upper_arm_15 * Theta_upper_arm_12 + Lambda_forearm_10 * Theta_upper_arm_22
        + Lambda_T_upper_arm_35 * Theta_upper_arm_32;
    const six_link_real t443 = t442 + Lambda_T_upper_arm_55 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t444 = Lambda_T_upper_arm_15 * Theta_upper_arm_13 + Lambda_forearm_10 * Theta_upper_arm_23
        + Lambda_T_upper_arm_35 * Theta_upper_arm_33;
    const six_link_real t445 = Lambda_forearm_20 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real C_upper_arm_53 = t444 + t445;
    const six_link_real t446 = Lambda_T_upper_arm_15 * Theta_upper_arm_14 + Lambda_forearm_10 * Theta_upper_arm_24
        + Lambda_T_upper_arm_35 * Theta_upper_arm_34;
    const six_link_real t447 = Lambda_forearm_20 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_upper_arm_54 = t446 + t447;
    const six_link_real C_upper_arm_55 = Lambda_T_upper_arm_15 * Theta_upper_arm_15
        + Lambda_forearm_10 * Theta_upper_arm_25 + Lambda_T_upper_arm_35 * Theta_upper_arm_35;
    const six_link_real t448 = Lambda_T_upper_arm_16 * Theta_upper_arm_11 + Lambda_T_upper_arm_26 * Theta_upper_arm_21
        + Lambda_forearm_15 * Theta_upper_arm_31;
    const six_link_real C_upper_arm_61 = t448 + t445;
    const six_link_real t449 = Lambda_T_upper_arm_16 * Theta_upper_arm_12 + Lambda_T_upper_arm_26 * Theta_upper_arm_22
        + Lambda_forearm_15 * Theta_upper_arm_32;
    const six_link_real C_upper_arm_62 = t449 + t447;
    const six_link_real t450 = Lambda_T_upper_arm_16 * Theta_upper_arm_13 + Lambda_T_upper_arm_26 * Theta_upper_arm_23
        + Lambda_forearm_15 * Theta_upper_arm_33;
    const six_link_real t451 = t450 + Lambda_T_upper_arm_66 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t452 = Lambda_T_upper_arm_16 * Theta_upper_arm_14 + Lambda_T_upper_arm_26 * Theta_upper_arm_24
        + Lambda_forearm_15 * Theta_upper_arm_34;
    const six_link_real t453 = t452 + Lambda_T_upper_arm_66 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real C_upper_arm_65 = Lambda_T_upper_arm_16 * Theta_upper_arm_15
        + Lambda_T_upper_arm_26 * Theta_upper_arm_25 + Lambda_forearm_15 * Theta_upper_arm_35;
    const six_link_real C_upper_arm_21 = t419
        + (r_T_upper_arm_z * C_upper_arm_41 - c->links[1].length * C_upper_arm_61);
    const six_link_real C_upper_arm_22 = t421
        + (r_T_upper_arm_z * C_upper_arm_42 - c->links[1].length * C_upper_arm_62);
    const six_link_real C_upper_arm_33 = t432
        + (c->links[1].length * C_upper_arm_53 - r_T_upper_arm_y * C_upper_arm_43);
    const six_link_real C_upper_arm_34 = t434
        + (c->links[1].length * C_upper_arm_54 - r_T_upper_arm_y * C_upper_arm_44);
    const six_link_real C_upper_arm_25 = t426
        + (r_T_upper_arm_z * C_upper_arm_45 - c->links[1].length * C_upper_arm_65);
    const six_link_real C_upper_arm_35 = t435
        + (c->links[1].length * C_upper_arm_55 - r_T_upper_arm_y * C_upper_arm_45);
    const six_link_real C_upper_arm_11 = t410 + (r_T_upper_arm_y * C_upper_arm_61 - r_T_upper_arm_z * t441)
        - L_upper_arm_z1;
    const six_link_real C_upper_arm_12 = t412 + (r_T_upper_arm_y * C_upper_arm_62 - r_T_upper_arm_z * t443)
        - L_upper_arm_z2;
    const six_link_real C_upper_arm_13 = L_upper_arm_y1
        + (t414 + (r_T_upper_arm_y * t451 - r_T_upper_arm_z * C_upper_arm_53));
    const six_link_real C_upper_arm_14 = L_upper_arm_y2
        + (t416 + (r_T_upper_arm_y * t453 - r_T_upper_arm_z * C_upper_arm_54));
    const six_link_real C_upper_arm_15 = c->links[1].sigma_t_5
        + (t417 + (r_T_upper_arm_y * C_upper_arm_65 - r_T_upper_arm_z * C_upper_arm_55));
    const six_link_real C_upper_arm_23 = t423 + (r_T_upper_arm_z * C_upper_arm_43 - c->links[1].length * t451)
        - c->links[1].chi_1;
    const six_link_real C_upper_arm_24 = t425 + (r_T_upper_arm_z * C_upper_arm_44 - c->links[1].length * t453)
        - c->links[1].chi_2;
    const six_link_real C_upper_arm_31 = c->links[1].chi_1
        + (t428 + (c->links[1].length * t441 - r_T_upper_arm_y * C_upper_arm_41));
    const six_link_real C_upper_arm_32 = c->links[1].chi_2
        + (t430 + (c->links[1].length * t443 - r_T_upper_arm_y * C_upper_arm_42));
    const six_link_real C_upper_arm_51 = c->links[1].sigma_y1 + t441;
    const six_link_real C_upper_arm_52 = c->links[1].sigma_y2 + t443;
    const six_link_real C_upper_arm_63 = c->links[1].sigma_y1 + t451;
    const six_link_real C_upper_arm_64 = c->links[1].sigma_y2 + t453;
    const six_link_real t454 = Theta_upper_arm_11 * t410 + Theta_upper_arm_21 * t419 + Theta_upper_arm_31 * t428
        + t441 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_11 = t454 + m_eta[6];
    bad |= (unsigned long)(!(modal_inertia_upper_arm_11 > 0)) << 1;
    const six_link_real modal_inertia_upper_arm_12 = Theta_upper_arm_11 * t412 + Theta_upper_arm_21 * t421
        + Theta_upper_arm_31 * t430 + t443 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_13 = Theta_upper_arm_11 * t414 + Theta_upper_arm_21 * t423
        + Theta_upper_arm_31 * t432 + C_upper_arm_53 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_14 = Theta_upper_arm_11 * t416 + Theta_upper_arm_21 * t425
        + Theta_upper_arm_31 * t434 + C_upper_arm_54 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_15 = Theta_upper_arm_11 * t417 + Theta_upper_arm_21 * t426
        + Theta_upper_arm_31 * t435 + C_upper_arm_55 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t455 = Theta_upper_arm_12 * t412 + Theta_upper_arm_22 * t421 + Theta_upper_arm_32 * t430
        + t443 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_upper_arm_22 = t455 + m_eta[7];
    const six_link_real modal_inertia_upper_arm_23 = Theta_upper_arm_12 * t414 + Theta_upper_arm_22 * t423
        + Theta_upper_arm_32 * t432 + C_upper_arm_53 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_upper_arm_24 = Theta_upper_arm_12 * t416 + Theta_upper_arm_22 * t425
        + Theta_upper_arm_32 * t434 + C_upper_arm_54 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_upper_arm_25 = Theta_upper_arm_12 * t417 + Theta_upper_arm_22 * t426
        + Theta_upper_arm_32 * t435 + C_upper_arm_55 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real t456 = Theta_upper_arm_13 * t414 + Theta_upper_arm_23 * t423 + Theta_upper_arm_33 * t432
        + t451 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_33 = t456 + m_eta[8];
    const six_link_real modal_inertia_upper_arm_34 = Theta_upper_arm_13 * t416 + Theta_upper_arm_23 * t425
        + Theta_upper_arm_33 * t434 + t453 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real modal_inertia_upper_arm_35 = Theta_upper_arm_13 * t417 + Theta_upper_arm_23 * t426
        + Theta_upper_arm_33 * t435 + C_upper_arm_65 * SIX_LINK_REAL(2.0195202782688155);
    const six_link_real t457 = Theta_upper_arm_14 * t416 + Theta_upper_arm_24 * t425 + Theta_upper_arm_34 * t434
        + t453 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_upper_arm_44 = t457 + m_eta[9];
    const six_link_real modal_inertia_upper_arm_45 = Theta_upper_arm_14 * t417 + Theta_upper_arm_24 * t426
        + Theta_upper_arm_34 * t435 + C_upper_arm_65 * SIX_LINK_REAL(2.8145226674626453);
    const six_link_real modal_inertia_upper_arm_55 = Theta_upper_arm_15 * t417 + Theta_upper_arm_25 * t426
        + Theta_upper_arm_35 * t435 + m_eta[10];
    const six_link_real t458 = Theta_upper_arm_11 * p_T_upper_arm_tau_x + Theta_upper_arm_21 * p_T_upper_arm_tau_y
        + Theta_upper_arm_31 * p_T_upper_arm_tau_z;
    const six_link_real t459 = Theta_upper_arm_12 * p_T_upper_arm_tau_x + Theta_upper_arm_22 * p_T_upper_arm_tau_y
        + Theta_upper_arm_32 * p_T_upper_arm_tau_z;
    const six_link_real t460 = Theta_upper_arm_13 * p_T_upper_arm_tau_x + Theta_upper_arm_23 * p_T_upper_arm_tau_y
        + Theta_upper_arm_33 * p_T_upper_arm_tau_z;
    const six_link_real t461 = Theta_upper_arm_14 * p_T_upper_arm_tau_x + Theta_upper_arm_24 * p_T_upper_arm_tau_y
        + Theta_upper_arm_34 * p_T_upper_arm_tau_z;
    const six_link_real t462 = Theta_upper_arm_15 * p_T_upper_arm_tau_x + Theta_upper_arm_25 * p_T_upper_arm_tau_y
        + Theta_upper_arm_35 * p_T_upper_arm_tau_z;
    const six_link_real h_phi_upper_arm_1 = h_eta_upper_arm_1 + work->f_eta[6]
        + (t458 + p_T_upper_arm_f_y * SIX_LINK_REAL(2.0195202782688155));
    const six_link_real h_phi_upper_arm_2 = h_eta_upper_arm_2 + work->f_eta[7]
        + (t459 + p_T_upper_arm_f_y * SIX_LINK_REAL(2.8145226674626453));
    const six_link_real h_phi_upper_arm_3 = work->f_eta[8] - minus_h_eta_upper_arm_3
        + (t460 + p_T_upper_arm_f_z * SIX_LINK_REAL(2.0195202782688155));
    const six_link_real h_phi_upper_arm_4 = work->f_eta[9] - minus_h_eta_upper_arm_4
        + (t461 + p_T_upper_arm_f_z * SIX_LINK_REAL(2.8145226674626453));
    const six_link_real h_phi_upper_arm_5 = work->f_eta[10] - minus_h_eta_upper_arm_5 + t462;
    const six_link_real modes_inverse_upper_arm_1 = 1 / modal_inertia_upper_arm_11;
    const six_link_real modes_L_upper_arm_21 = modal_inertia_upper_arm_12 * modes_inverse_upper_arm_1;
    const six_link_real modes_L_upper_arm_31 = modal_inertia_upper_arm_13 * modes_inverse_upper_arm_1;
    const six_link_real modes_L_upper_arm_41 = modal_inertia_upper_arm_14 * modes_inverse_upper_arm_1;
    const six_link_real modes_L_upper_arm_51 = modal_inertia_upper_arm_15 * modes_inverse_upper_arm_1;
    const six_link_real t463 = modal_inertia_upper_arm_22 - modal_inertia_upper_arm_12 * modes_L_upper_arm_21;
    bad |= (unsigned long)(!(t463 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_2 = 1 / t463;
    const six_link_real t464 = modal_inertia_upper_arm_23 - modal_inertia_upper_arm_12 * modes_L_upper_arm_31;
    const six_link_real modes_L_upper_arm_32 = t464 * modes_inverse_upper_arm_2;
    const six_link_real t465 = modal_inertia_upper_arm_24 - modal_inertia_upper_arm_12 * modes_L_upper_arm_41;
    const six_link_real modes_L_upper_arm_42 = t465 * modes_inverse_upper_arm_2;
    const six_link_real t466 = modal_inertia_upper_arm_25 - modal_inertia_upper_arm_12 * modes_L_upper_arm_51;
    const six_link_real modes_L_upper_arm_52 = t466 * modes_inverse_upper_arm_2;
    const six_link_real t467 = modal_inertia_upper_arm_33
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_31 + t464 * modes_L_upper_arm_32);
    bad |= (unsigned long)(!(t467 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_3 = 1 / t467;
    const six_link_real t468 = modal_inertia_upper_arm_34
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_41 + t464 * modes_L_upper_arm_42);
    const six_link_real modes_L_upper_arm_43 = t468 * modes_inverse_upper_arm_3;
    const six_link_real t469 = modal_inertia_upper_arm_35
        - (modal_inertia_upper_arm_13 * modes_L_upper_arm_51 + t464 * modes_L_upper_arm_52);
    const six_link_real modes_L_upper_arm_53 = t469 * modes_inverse_upper_arm_3;
    const six_link_real t470 = modal_inertia_upper_arm_14 * modes_L_upper_arm_41 + t465 * modes_L_upper_arm_42
        + t468 * modes_L_upper_arm_43;
    const six_link_real t471 = modal_inertia_upper_arm_44 - t470;
    bad |= (unsigned long)(!(t471 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_4 = 1 / t471;
    const six_link_real t472 = modal_inertia_upper_arm_14 * modes_L_upper_arm_51 + t465 * modes_L_upper_arm_52
        + t468 * modes_L_upper_arm_53;
    const six_link_real t473 = modal_inertia_upper_arm_45 - t472;
    const six_link_real modes_L_upper_arm_54 = t473 * modes_inverse_upper_arm_4;
    const six_link_real t474 = modal_inertia_upper_arm_15 * modes_L_upper_arm_51 + t466 * modes_L_upper_arm_52
        + t469 * modes_L_upper_arm_53;
    const six_link_real t475 = modal_inertia_upper_arm_55 - (t474 + t473 * modes_L_upper_arm_54);
    bad |= (unsigned long)(!(t475 > 0)) << 1;
    const six_link_real modes_inverse_upper_arm_5 = 1 / t475;
    const six_link_real t476 = C_upper_arm_12 - modes_L_upper_arm_21 * C_upper_arm_11;
    const six_link_real t477 = C_upper_arm_22 - modes_L_upper_arm_21 * C_upper_arm_21;
    const six_link_real t478 = C_upper_arm_32 - modes_L_upper_arm_21 * C_upper_arm_31;
    const six_link_real t479 = C_upper_arm_42 - modes_L_upper_arm_21 * C_upper_arm_41;
    const six_link_real t480 = C_upper_arm_52 - modes_L_upper_arm_21 * C_upper_arm_51;
    const six_link_real t481 = C_upper_arm_62 - modes_L_upper_arm_21 * C_upper_arm_61;
    const six_link_real t482 = C_upper_arm_13 - modes_L_upper_arm_31 * C_upper_arm_11 - modes_L_upper_arm_32 * t476;
    const six_link_real t483 = C_upper_arm_23 - modes_L_upper_arm_31 * C_upper_arm_21 - modes_L_upper_arm_32 * t477;
    const six_link_real t484 = C_upper_arm_33 - modes_L_upper_arm_31 * C_upper_arm_31 - modes_L_upper_arm_32 * t478;
    const six_link_real t485 = C_upper_arm_43 - modes_L_upper_arm_31 * C_upper_arm_41 - modes_L_upper_arm_32 * t479;
    const six_link_real t486 = C_upper_arm_53 - modes_L_upper_arm_31 * C_upper_arm_51 - modes_L_upper_arm_32 * t480;
    const six_link_real t487 = C_upper_arm_63 - modes_L_upper_arm_31 * C_upper_arm_61 - modes_L_upper_arm_32 * t481;
    const six_link_real t488 = C_upper_arm_14 - modes_L_upper_arm_41 * C_upper_arm_11 - modes_L_upper_arm_42 * t476
        - modes_L_upper_arm_43 * t482;
    const six_link_real t489 = C_upper_arm_24 - modes_L_upper_arm_41 * C_upper_arm_21 - modes_L_upper_arm_42 * t477
        - modes_L_upper_arm_43 * t483;
    const six_link_real t490 = C_upper_arm_34 - modes_L_upper_arm_41 * C_upper_arm_31 - modes_L_upper_arm_42 * t478
        - modes_L_upper_arm_43 * t484;
    const six_link_real t491 = C_upper_arm_44 - modes_L_upper_arm_41 * C_upper_arm_41 - modes_L_upper_arm_42 * t479
        - modes_L_upper_arm_43 * t485;
    const six_link_real t492 = C_upper_arm_54 - modes_L_upper_arm_41 * C_upper_arm_51 - modes_L_upper_arm_42 * t480
        - modes_L_upper_arm_43 * t486;
    const six_link_real t493 = C_upper_arm_64 - modes_L_upper_arm_41 * C_upper_arm_61 - modes_L_upper_arm_42 * t481
        - modes_L_upper_arm_43 * t487;
    const six_link_real t494 = C_upper_arm_15 - modes_L_upper_arm_51 * C_upper_arm_11 - modes_L_upper_arm_52 * t476
        - modes_L_upper_arm_53 * t482;
    const six_link_real t495 = C_upper_arm_25 - modes_L_upper_arm_51 * C_upper_arm_21 - modes_L_upper_arm_52 * t477
        - modes_L_upper_arm_53 * t483;
    const six_link_real t496 = C_upper_arm_35 - modes_L_upper_arm_51 * C_upper_arm_31 - modes_L_upper_arm_52 * t478
        - modes_L_upper_arm_53 * t484;
    const six_link_real t497 = C_upper_arm_45 - modes_L_upper_arm_51 * C_upper_arm_41 - modes_L_upper_arm_52 * t479
        - modes_L_upper_arm_53 * t485;
    const six_link_real t498 = C_upper_arm_55 - modes_L_upper_arm_51 * C_upper_arm_51 - modes_L_upper_arm_52 * t480
        - modes_L_upper_arm_53 * t486;
    const six_link_real t499 = C_upper_arm_65 - modes_L_upper_arm_51 * C_upper_arm_61 - modes_L_upper_arm_52 * t481
        - modes_L_upper_arm_53 * t487;
    const six_link_real t500 = t494 - modes_L_upper_arm_54 * t488;
    const six_link_real t501 = t495 - modes_L_upper_arm_54 * t489;
    const six_link_real t502 = t496 - modes_L_upper_arm_54 * t490;
    const six_link_real t503 = t497 - modes_L_upper_arm_54 * t491;
    const six_link_real t504 = t498 - modes_L_upper_arm_54 * t492;
    const six_link_real t505 = t499 - modes_L_upper_arm_54 * t493;
    const six_link_real t506 = h_phi_upper_arm_2 - modes_L_upper_arm_21 * h_phi_upper_arm_1;
    const six_link_real t507 = h_phi_upper_arm_3 - modes_L_upper_arm_31 * h_phi_upper_arm_1
        - modes_L_upper_arm_32 * t506;
    const six_link_real t508 = h_phi_upper_arm_4 - modes_L_upper_arm_41 * h_phi_upper_arm_1
        - modes_L_upper_arm_42 * t506 - modes_L_upper_arm_43 * t507;
    const six_link_real t509 = h_phi_upper_arm_5 - modes_L_upper_arm_51 * h_phi_upper_arm_1
        - modes_L_upper_arm_52 * t506 - modes_L_upper_arm_53 * t507;
    const six_link_real t510 = t509 - modes_L_upper_arm_54 * t508;
    const six_link_real modes_W_upper_arm_11 = C_upper_arm_11 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_12 = C_upper_arm_21 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_13 = C_upper_arm_31 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_14 = C_upper_arm_41 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_15 = C_upper_arm_51 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_16 = C_upper_arm_61 * modes_inverse_upper_arm_1;
    const six_link_real modes_W_upper_arm_21 = t476 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_22 = t477 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_23 = t478 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_24 = t479 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_25 = t480 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_26 = t481 * modes_inverse_upper_arm_2;
    const six_link_real modes_W_upper_arm_31 = t482 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_32 = t483 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_33 = t484 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_34 = t485 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_35 = t486 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_36 = t487 * modes_inverse_upper_arm_3;
    const six_link_real modes_W_upper_arm_41 = t488 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_42 = t489 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_43 = t490 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_44 = t491 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_45 = t492 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_46 = t493 * modes_inverse_upper_arm_4;
    const six_link_real modes_W_upper_arm_51 = t500 * modes_inverse_upper_arm_5;
    const six_link_real modes_W_upper_arm_52 = t501 * modes_inverse_upper_arm_5;
    const six_link_real modes_W_upper_arm_53 = t502 * modes_inverse_upper_arm_5;
    const six_link_real modes_W_upper_arm_54 = t503 * modes_inverse_upper_arm_5;
    const six_link_real modes_W_upper_arm_55 = t504 * modes_inverse_upper_arm_5;
    const six_link_real modes_W_upper_arm_56 = t505 * modes_inverse_upper_arm_5;
    const six_link_real modes_w_upper_arm_1 = h_phi_upper_arm_1 * modes_inverse_upper_arm_1;
    const six_link_real modes_w_upper_arm_2 = t506 * modes_inverse_upper_arm_2;
    const six_link_real modes_w_upper_arm_3 = t507 * modes_inverse_upper_arm_3;
    const six_link_real modes_w_upper_arm_4 = t508 * modes_inverse_upper_arm_4;
    const six_link_real modes_w_upper_arm_5 = t510 * modes_inverse_upper_arm_5;
    const six_link_real t511 = C_upper_arm_11 * modes_W_upper_arm_11 + t476 * modes_W_upper_arm_21
        + t482 * modes_W_upper_arm_31;
    const six_link_real M_i_upper_arm_11 = M_loaded_upper_arm_11
        - (t511 + t488 * modes_W_upper_arm_41 + t500 * modes_W_upper_arm_51);
    const six_link_real t512 = C_upper_arm_11 * modes_W_upper_arm_12 + t476 * modes_W_upper_arm_22
        + t482 * modes_W_upper_arm_32;
    const six_link_real M_i_upper_arm_12 = M_loaded_upper_arm_12
        - (t512 + t488 * modes_W_upper_arm_42 + t500 * modes_W_upper_arm_52);
    const six_link_real t513 = C_upper_arm_11 * modes_W_upper_arm_13 + t476 * modes_W_upper_arm_23
        + t482 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_13 = M_loaded_upper_arm_13
        - (t513 + t488 * modes_W_upper_arm_43 + t500 * modes_W_upper_arm_53);
    const six_link_real t514 = C_upper_arm_11 * modes_W_upper_arm_14 + t476 * modes_W_upper_arm_24
        + t482 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_14 = M_loaded_upper_arm_14
        - (t514 + t488 * modes_W_upper_arm_44 + t500 * modes_W_upper_arm_54);
    const six_link_real t515 = C_upper_arm_11 * modes_W_upper_arm_15 + t476 * modes_W_upper_arm_25
        + t482 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_15 = M_loaded_upper_arm_15
        - (t515 + t488 * modes_W_upper_arm_45 + t500 * modes_W_upper_arm_55);
    const six_link_real t516 = C_upper_arm_11 * modes_W_upper_arm_16 + t476 * modes_W_upper_arm_26
        + t482 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_16 = M_loaded_upper_arm_16
        - (t516 + t488 * modes_W_upper_arm_46 + t500 * modes_W_upper_arm_56);
    const six_link_real t517 = C_upper_arm_21 * modes_W_upper_arm_12 + t477 * modes_W_upper_arm_22
        + t483 * modes_W_upper_arm_32;
    const six_link_real M_i_upper_arm_22 = M_loaded_upper_arm_22
        - (t517 + t489 * modes_W_upper_arm_42 + t501 * modes_W_upper_arm_52);
    const six_link_real t518 = C_upper_arm_21 * modes_W_upper_arm_13 + t477 * modes_W_upper_arm_23
        + t483 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_23 = M_loaded_upper_arm_23
        - (t518 + t489 * modes_W_upper_arm_43 + t501 * modes_W_upper_arm_53);
    const six_link_real t519 = C_upper_arm_21 * modes_W_upper_arm_14 + t477 * modes_W_upper_arm_24
        + t483 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_24 = M_loaded_upper_arm_24
        - (t519 + t489 * modes_W_upper_arm_44 + t501 * modes_W_upper_arm_54);
    const six_link_real t520 = C_upper_arm_21 * modes_W_upper_arm_15 + t477 * modes_W_upper_arm_25
        + t483 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_25 = M_loaded_upper_arm_25
        - (t520 + t489 * modes_W_upper_arm_45 + t501 * modes_W_upper_arm_55);
    const six_link_real t521 = C_upper_arm_21 * modes_W_upper_arm_16 + t477 * modes_W_upper_arm_26
        + t483 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_26 = M_loaded_upper_arm_26
        - (t521 + t489 * modes_W_upper_arm_46 + t501 * modes_W_upper_arm_56);
    const six_link_real t522 = C_upper_arm_31 * modes_W_upper_arm_13 + t478 * modes_W_upper_arm_23
        + t484 * modes_W_upper_arm_33;
    const six_link_real M_i_upper_arm_33 = M_loaded_upper_arm_33
        - (t522 + t490 * modes_W_upper_arm_43 + t502 * modes_W_upper_arm_53);
    const six_link_real t523 = C_upper_arm_31 * modes_W_upper_arm_14 + t478 * modes_W_upper_arm_24
        + t484 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_34 = M_loaded_upper_arm_34
        - (t523 + t490 * modes_W_upper_arm_44 + t502 * modes_W_upper_arm_54);
    const six_link_real t524 = C_upper_arm_31 * modes_W_upper_arm_15 + t478 * modes_W_upper_arm_25
        + t484 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_35 = M_loaded_upper_arm_35
        - (t524 + t490 * modes_W_upper_arm_45 + t502 * modes_W_upper_arm_55);
    const six_link_real t525 = C_upper_arm_31 * modes_W_upper_arm_16 + t478 * modes_W_upper_arm_26
        + t484 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_36 = M_loaded_upper_arm_36
        - (t525 + t490 * modes_W_upper_arm_46 + t502 * modes_W_upper_arm_56);
    const six_link_real t526 = C_upper_arm_41 * modes_W_upper_arm_14 + t479 * modes_W_upper_arm_24
        + t485 * modes_W_upper_arm_34;
    const six_link_real M_i_upper_arm_44 = M_loaded_upper_arm_44
        - (t526 + t491 * modes_W_upper_arm_44 + t503 * modes_W_upper_arm_54);
    const six_link_real t527 = C_upper_arm_41 * modes_W_upper_arm_15 + t479 * modes_W_upper_arm_25
        + t485 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_45 = Lambda_forearm_17
        - (t527 + t491 * modes_W_upper_arm_45 + t503 * modes_W_upper_arm_55);
    const six_link_real t528 = C_upper_arm_41 * modes_W_upper_arm_16 + t479 * modes_W_upper_arm_26
        + t485 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_46 = Lambda_forearm_18
        - (t528 + t491 * modes_W_upper_arm_46 + t503 * modes_W_upper_arm_56);
    const six_link_real t529 = C_upper_arm_51 * modes_W_upper_arm_15 + t480 * modes_W_upper_arm_25
        + t486 * modes_W_upper_arm_35;
    const six_link_real M_i_upper_arm_55 = M_loaded_upper_arm_55
        - (t529 + t492 * modes_W_upper_arm_45 + t504 * modes_W_upper_arm_55);
    const six_link_real t530 = C_upper_arm_51 * modes_W_upper_arm_16 + t480 * modes_W_upper_arm_26
        + t486 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_56 = Lambda_forearm_20
        - (t530 + t492 * modes_W_upper_arm_46 + t504 * modes_W_upper_arm_56);
    const six_link_real t531 = C_upper_arm_61 * modes_W_upper_arm_16 + t481 * modes_W_upper_arm_26
        + t487 * modes_W_upper_arm_36;
    const six_link_real M_i_upper_arm_66 = M_loaded_upper_arm_66
        - (t531 + t493 * modes_W_upper_arm_46 + t505 * modes_W_upper_arm_56);
    const six_link_real t532 = modes_W_upper_arm_11 * h_phi_upper_arm_1 + modes_W_upper_arm_21 * t506
        + modes_W_upper_arm_31 * t507;
    const six_link_real t533 = modes_W_upper_arm_12 * h_phi_upper_arm_1 + modes_W_upper_arm_22 * t506
        + modes_W_upper_arm_32 * t507;
    const six_link_real t534 = modes_W_upper_arm_13 * h_phi_upper_arm_1 + modes_W_upper_arm_23 * t506
        + modes_W_upper_arm_33 * t507;
    const six_link_real t535 = modes_W_upper_arm_14 * h_phi_upper_arm_1 + modes_W_upper_arm_24 * t506
        + modes_W_upper_arm_34 * t507;
    const six_link_real t536 = modes_W_upper_arm_15 * h_phi_upper_arm_1 + modes_W_upper_arm_25 * t506
        + modes_W_upper_arm_35 * t507;
    const six_link_real t537 = modes_W_upper_arm_16 * h_phi_upper_arm_1 + modes_W_upper_arm_26 * t506
        + modes_W_upper_arm_36 * t507;
    const six_link_real h_i_upper_arm_tau_x = h_loaded_upper_arm_tau_x
        - (t532 + modes_W_upper_arm_41 * t508 + modes_W_upper_arm_51 * t510);
    const six_link_real h_i_upper_arm_tau_y = h_loaded_upper_arm_tau_y
        - (t533 + modes_W_upper_arm_42 * t508 + modes_W_upper_arm_52 * t510);
    const six_link_real h_i_upper_arm_tau_z = h_loaded_upper_arm_tau_z
        - (t534 + modes_W_upper_arm_43 * t508 + modes_W_upper_arm_53 * t510);
    const six_link_real h_i_upper_arm_f_x = h_loaded_upper_arm_f_x
        - (t535 + modes_W_upper_arm_44 * t508 + modes_W_upper_arm_54 * t510);
    const six_link_real h_i_upper_arm_f_y = h_loaded_upper_arm_f_y
        - (t536 + modes_W_upper_arm_45 * t508 + modes_W_upper_arm_55 * t510);
    const six_link_real h_i_upper_arm_f_z = h_loaded_upper_arm_f_z
        - (t537 + modes_W_upper_arm_46 * t508 + modes_W_upper_arm_56 * t510);

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
    const six_link_real joint_w_upper_arm_1 = (input->tau[1] - work->f_eta[1] - h_i_upper_arm_tau_y)
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
    const six_link_real p_i_upper_arm_tau_x = h_i_upper_arm_tau_x + M_i_upper_arm_12 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_tau_z = h_i_upper_arm_tau_z + M_i_upper_arm_23 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_f_x = h_i_upper_arm_f_x + M_i_upper_arm_24 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_f_y = h_i_upper_arm_f_y + M_i_upper_arm_25 * joint_w_upper_arm_1;
    const six_link_real p_i_upper_arm_f_z = h_i_upper_arm_f_z + M_i_upper_arm_26 * joint_w_upper_arm_1;

    /* upper_arm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
    const six_link_real t538 = c->links[1].mount_xyz_y * Lambda_i_upper_arm_46;
    const six_link_real t539 = r_R_upper_arm_x * Lambda_i_upper_arm_56;
    const six_link_real t540 = Lambda_i_upper_arm_15
        + (c->links[1].mount_xyz_y * Lambda_i_upper_arm_56 - r_R_upper_arm_z * Lambda_i_upper_arm_55);
    const six_link_real t541 = Lambda_i_upper_arm_16
        + (c->links[1].mount_xyz_y * Lambda_i_upper_arm_66 - r_R_upper_arm_z * Lambda_i_upper_arm_56);
    const six_link_real t542 = Lambda_i_upper_arm_24
        + (r_R_upper_arm_z * Lambda_i_upper_arm_44 - r_R_upper_arm_x * Lambda_i_upper_arm_46);
    const six_link_real t543 = Lambda_i_upper_arm_26
        + (r_R_upper_arm_z * Lambda_i_upper_arm_46 - r_R_upper_arm_x * Lambda_i_upper_arm_66);
    const six_link_real t544 = Lambda_i_upper_arm_34
        + (r_R_upper_arm_x * Lambda_i_upper_arm_45 - c->links[1].mount_xyz_y * Lambda_i_upper_arm_44);
    const six_link_real t545 = Lambda_i_upper_arm_35
        + (r_R_upper_arm_x * Lambda_i_upper_arm_55 - c->links[1].mount_xyz_y * Lambda_i_upper_arm_45);
    const six_link_real t546 = Lambda_i_upper_arm_36 + (t539 - t538);
    const six_link_real t547 = Lambda_i_upper_arm_11
        - (Lambda_i_upper_arm_15 * r_R_upper_arm_z - Lambda_i_upper_arm_16 * c->links[1].mount_xyz_y);
    const six_link_real t548 = Lambda_i_upper_arm_13
        - (Lambda_i_upper_arm_14 * c->links[1].mount_xyz_y - Lambda_i_upper_arm_15 * r_R_upper_arm_x);
    const six_link_real t549 = t548 + (c->links[1].mount_xyz_y * t546 - r_R_upper_arm_z * t545);
    const six_link_real t550 = Lambda_i_upper_arm_22
        - (Lambda_i_upper_arm_26 * r_R_upper_arm_x - Lambda_i_upper_arm_24 * r_R_upper_arm_z);
    const six_link_real Lambda_upper_arm_7 = t550 + (r_R_upper_arm_z * t542 - r_R_upper_arm_x * t543);
    const six_link_real t551 = Lambda_i_upper_arm_33
        - (Lambda_i_upper_arm_34 * c->links[1].mount_xyz_y - Lambda_i_upper_arm_35 * r_R_upper_arm_x);
    const six_link_real t552 = t551 + (r_R_upper_arm_x * t545 - c->links[1].mount_xyz_y * t544);
    const six_link_real t553 = (t547 + (c->links[1].mount_xyz_y * t541 - r_R_upper_arm_z * t540) - t552)
        * SIX_LINK_REAL(0.5);
    const six_link_real t554 = t553 * R_rel_upper_arm_xx + t549 * R_rel_upper_arm_xz;
    const six_link_real t555 = t549 * R_rel_upper_arm_xx - t553 * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_1 = R_rel_upper_arm_xx * t554 * 2 + t552;
    const six_link_real Lambda_upper_arm_12 = t552 - R_rel_upper_arm_xz * t555 * 2;
    const six_link_real Lambda_upper_arm_11 = t543 * R_rel_upper_arm_xx - t542 * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_14 = R_rel_upper_arm_xx * t545 - R_rel_upper_arm_xz * t540;
    const six_link_real t556 = Lambda_i_upper_arm_46 * R_rel_upper_arm_xx
        - (Lambda_i_upper_arm_44 - Lambda_i_upper_arm_66) * SIX_LINK_REAL(0.5) * R_rel_upper_arm_xz;
    const six_link_real Lambda_upper_arm_21 = Lambda_i_upper_arm_66 - R_rel_upper_arm_xz * t556 * 2;
    const six_link_real t557 = p_i_upper_arm_tau_x
        + (c->links[1].mount_xyz_y * p_i_upper_arm_f_z - r_R_upper_arm_z * p_i_upper_arm_f_y);
    const six_link_real t558 = p_i_upper_arm_tau_z
        + (r_R_upper_arm_x * p_i_upper_arm_f_y - c->links[1].mount_xyz_y * p_i_upper_arm_f_x);
    const six_link_real p_upper_arm_tau_z = R_rel_upper_arm_xx * t558 - R_rel_upper_arm_xz * t557;

    /* shoulder, H_star: gyroscopic wrench and weight, angular acceleration included */
    const six_link_real H_star_shoulder_tau_z = c->links[0].S_0_x * a_J_shoulder_y;

    /* shoulder, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
    const six_link_real Lambda_T_shoulder_11 = Lambda_upper_arm_1 + c->links[0].I_T_xx;
    const six_link_real Lambda_T_shoulder_22 = Lambda_upper_arm_7 + c->links[0].I_T_yy;
    const six_link_real Lambda_T_shoulder_26 = Lambda_upper_arm_11 - c->links[0].S_T_x;
    const six_link_real Lambda_T_shoulder_33 = Lambda_upper_arm_12 + c->links[0].I_T_zz;
    const six_link_real Lambda_T_shoulder_35 = Lambda_upper_arm_14 + c->links[0].S_T_x;
    const six_link_real Lambda_T_shoulder_55 = Lambda_i_upper_arm_55 + c->links[0].body0_mass;
    const six_link_real Lambda_T_shoulder_66 = Lambda_upper_arm_21 + c->links[0].body0_mass;
    const six_link_real t559 = p_upper_arm_tau_z
        + (c->links[0].S_T_x * a_J_shoulder_y + c->links[0].S_T_y * minus_a_t_shoulder_x);
    const six_link_real t560 = p_i_upper_arm_f_y
        + (c->links[0].body0_mass * a_J_shoulder_y - state->v[0] * (state->v[0] * c->links[0].S_T_y));
    const six_link_real p_T_shoulder_tau_z = t559 - input->w_ext[0][2];
    const six_link_real p_T_shoulder_f_y = t560 - input->w_ext[0][4];

    /* shoulder, modes: the tip load folded in, modal accelerations eliminated (83) */
    const six_link_real t561 = Lambda_T_shoulder_35 + c->links[0].length * Lambda_T_shoulder_55;
    const six_link_real t562 = Lambda_T_shoulder_22 - Lambda_T_shoulder_26 * c->links[0].length
        - c->links[0].length * (Lambda_T_shoulder_26 - c->links[0].length * Lambda_T_shoulder_66);
    const six_link_real M_loaded_shoulder_11 = c->links[0].I_s + Lambda_T_shoulder_11;
    const six_link_real M_loaded_shoulder_22 = c->links[0].J_0_xx + t562;
    const six_link_real M_loaded_shoulder_33 = c->links[0].J_0_xx
        + (Lambda_T_shoulder_33 + Lambda_T_shoulder_35 * c->links[0].length + c->links[0].length * t561);
    const six_link_real h_loaded_shoulder_tau_z = H_star_shoulder_tau_z
        + (p_T_shoulder_tau_z + c->links[0].length * p_T_shoulder_f_y);

    /* shoulder, joint: its accelerations eliminated from its rows (43) */
    const six_link_real joint_inertia_shoulder_11 = M_loaded_shoulder_33 + m_eta[0];
    bad |= (unsigned long)(!(joint_inertia_shoulder_11
        - t88 * (M_loaded_shoulder_11 + M_loaded_shoulder_22 + M_loaded_shoulder_33) > 0)) << 0;
    const six_link_real joint_inverse_shoulder_1 = 1 / joint_inertia_shoulder_11;
    const six_link_real joint_w_shoulder_1 = (input->tau[0] - work->f_eta[0] - h_loaded_shoulder_tau_z)
        * joint_inverse_shoulder_1;
    output->vdot[0] = joint_w_shoulder_1;

    /* shoulder, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real delta_T_shoulder_a_y = joint_w_shoulder_1 * c->links[0].length;

    /* upper_arm, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real minus_carried_upper_arm_alpha_x = R_rel_upper_arm_xz * joint_w_shoulder_1;
    const six_link_real carried_upper_arm_alpha_z = R_rel_upper_arm_xx * joint_w_shoulder_1;
    const six_link_real minus_carried_upper_arm_a_x = carried_upper_arm_alpha_z * c->links[1].mount_xyz_y;
    const six_link_real minus_carried_upper_arm_a_z = minus_carried_upper_arm_alpha_x * c->links[1].mount_xyz_y;
    const six_link_real carried_upper_arm_a_y = delta_T_shoulder_a_y
        + (carried_upper_arm_alpha_z * r_R_upper_arm_x + minus_carried_upper_arm_alpha_x * r_R_upper_arm_z);
    const six_link_real t563 = joint_W_upper_arm_13 * carried_upper_arm_alpha_z
        - joint_W_upper_arm_11 * minus_carried_upper_arm_alpha_x;
    const six_link_real t564 = t563 - joint_W_upper_arm_14 * minus_carried_upper_arm_a_x
        + joint_W_upper_arm_15 * carried_upper_arm_a_y;
    const six_link_real qddot_upper_arm_1 = joint_w_upper_arm_1
        - (t564 - joint_W_upper_arm_16 * minus_carried_upper_arm_a_z);
    output->vdot[1] = qddot_upper_arm_1;

    /* upper_arm, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real t565 = modes_W_upper_arm_12 * qddot_upper_arm_1
        - modes_W_upper_arm_11 * minus_carried_upper_arm_alpha_x;
    const six_link_real t566 = t565 + modes_W_upper_arm_13 * carried_upper_arm_alpha_z
        - modes_W_upper_arm_14 * minus_carried_upper_arm_a_x;
    const six_link_real t567 = t566 + modes_W_upper_arm_15 * carried_upper_arm_a_y
        - modes_W_upper_arm_16 * minus_carried_upper_arm_a_z;
    const six_link_real t568 = modes_W_upper_arm_22 * qddot_upper_arm_1
        - modes_W_upper_arm_21 * minus_carried_upper_arm_alpha_x;
    const six_link_real t569 = t568 + modes_W_upper_arm_23 * carried_upper_arm_alpha_z
        - modes_W_upper_arm_24 * minus_carried_upper_arm_a_x;
    const six_link_real t570 = t569 + modes_W_upper_arm_25 * carried_upper_arm_a_y
        - modes_W_upper_arm_26 * minus_carried_upper_arm_a_z;
    const six_link_real t571 = modes_W_upper_arm_32 * qddot_upper_arm_1
        - modes_W_upper_arm_31 * minus_carried_upper_arm_alpha_x;
    const six_link_real t572 = t571 + modes_W_upper_arm_33 * carried_upper_arm_alpha_z
        - modes_W_upper_arm_34 * minus_carried_upper_arm_a_x;
    const six_link_real t573 = modes_W_upper_arm_36 * minus_carried_upper_arm_a_z
        - (t572 + modes_W_upper_arm_35 * carried_upper_arm_a_y);
    const six_link_real t574 = modes_W_upper_arm_42 * qddot_upper_arm_1
        - modes_W_upper_arm_41 * minus_carried_upper_arm_alpha_x;
    const six_link_real t575 = t574 + modes_W_upper_arm_43 * carried_upper_arm_alpha_z
        - modes_W_upper_arm_44 * minus_carried_upper_arm_a_x;
    const six_link_real t576 = t575 + modes_W_upper_arm_45 * carried_upper_arm_a_y
        - modes_W_upper_arm_46 * minus_carried_upper_arm_a_z;
    const six_link_real t577 = modes_W_upper_arm_52 * qddot_upper_arm_1
        - modes_W_upper_arm_51 * minus_carried_upper_arm_alpha_x;
    const six_link_real t578 = t577 + modes_W_upper_arm_53 * carried_upper_arm_alpha_z
        - modes_W_upper_arm_54 * minus_carried_upper_arm_a_x;
    const six_link_real t579 = modes_W_upper_arm_56 * minus_carried_upper_arm_a_z
        - (t578 + modes_W_upper_arm_55 * carried_upper_arm_a_y);
    const six_link_real etaddot_upper_arm_5 = t579 - modes_w_upper_arm_5;
    output->vdot[10] = etaddot_upper_arm_5;
    const six_link_real etaddot_upper_arm_4 = -(modes_w_upper_arm_4 + t576)
        - modes_L_upper_arm_54 * etaddot_upper_arm_5;
    output->vdot[9] = etaddot_upper_arm_4;
    const six_link_real etaddot_upper_arm_3 = t573 - modes_w_upper_arm_3 - modes_L_upper_arm_43 * etaddot_upper_arm_4
        - modes_L_upper_arm_53 * etaddot_upper_arm_5;
    output->vdot[8] = etaddot_upper_arm_3;
    const six_link_real t580 = modes_w_upper_arm_2 + t570 + modes_L_upper_arm_32 * etaddot_upper_arm_3
        + modes_L_upper_arm_42 * etaddot_upper_arm_4;
    const six_link_real etaddot_upper_arm_2 = -t580 - modes_L_upper_arm_52 * etaddot_upper_arm_5;
    output->vdot[7] = etaddot_upper_arm_2;
    const six_link_real t581 = -(modes_w_upper_arm_1 + t567 + modes_L_upper_arm_21 * etaddot_upper_arm_2)
        - modes_L_upper_arm_31 * etaddot_upper_arm_3;
    const six_link_real etaddot_upper_arm_1 = t581 - modes_L_upper_arm_41 * etaddot_upper_arm_4
        - modes_L_upper_arm_51 * etaddot_upper_arm_5;
    output->vdot[6] = etaddot_upper_arm_1;

    /* upper_arm, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real t582 = -(etaddot_upper_arm_5 * SIX_LINK_REAL(1.7320508075688772));
    const six_link_real t583 = c->links[1].Psi_c_y3 * etaddot_upper_arm_3 + c->links[1].Psi_c_y4 * etaddot_upper_arm_4;
    const six_link_real t584 = c->links[1].Psi_c_z1 * etaddot_upper_arm_1 + c->links[1].Psi_c_z2 * etaddot_upper_arm_2;
    const six_link_real t585 = carried_upper_arm_alpha_z * c->links[1].length
        + minus_carried_upper_arm_alpha_x * r_T_upper_arm_z;
    const six_link_real delta_T_upper_arm_a_x = qddot_upper_arm_1 * r_T_upper_arm_z
        - carried_upper_arm_alpha_z * r_T_upper_arm_y - minus_carried_upper_arm_a_x;
    const six_link_real t586 = minus_carried_upper_arm_a_z
        + (minus_carried_upper_arm_alpha_x * r_T_upper_arm_y + qddot_upper_arm_1 * c->links[1].length);
    const six_link_real delta_T_upper_arm_alpha_x = J_l_upper_arm_xz * t584
        - (J_l_upper_arm_xx * t582 - J_l_upper_arm_xy * t583) - minus_carried_upper_arm_alpha_x;
    const six_link_real delta_T_upper_arm_alpha_y = qddot_upper_arm_1
        - (J_l_upper_arm_yx * t582 - J_l_upper_arm_yy * t583 - J_l_upper_arm_yz * t584);
    const six_link_real delta_T_upper_arm_alpha_z = carried_upper_arm_alpha_z
        - (J_l_upper_arm_zx * t582 + -(J_l_upper_arm_zy * t583) - J_l_upper_arm_zz * t584);
    const six_link_real delta_T_upper_arm_a_y = carried_upper_arm_a_y + t585
        + (etaddot_upper_arm_1 * SIX_LINK_REAL(2.0195202782688155)
        + etaddot_upper_arm_2 * SIX_LINK_REAL(2.8145226674626453));
    const six_link_real delta_T_upper_arm_a_z = etaddot_upper_arm_3 * SIX_LINK_REAL(2.0195202782688155)
        + etaddot_upper_arm_4 * SIX_LINK_REAL(2.8145226674626453) - t586;

    /* forearm, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_forearm_alpha_x = R_P_forearm_yx * delta_T_upper_arm_alpha_y
        + R_P_forearm_xx * delta_T_upper_arm_alpha_x + R_P_forearm_zx * delta_T_upper_arm_alpha_z;
    const six_link_real carried_forearm_alpha_y = R_P_forearm_yy * delta_T_upper_arm_alpha_y
        + R_P_forearm_xy * delta_T_upper_arm_alpha_x + R_P_forearm_zy * delta_T_upper_arm_alpha_z;
    const six_link_real carried_forearm_alpha_z = R_P_forearm_yz * delta_T_upper_arm_alpha_y
        + R_P_forearm_xz * delta_T_upper_arm_alpha_x + R_P_forearm_zz * delta_T_upper_arm_alpha_z;
    const six_link_real t587 = R_P_forearm_xx * delta_T_upper_arm_a_x + R_P_forearm_yx * delta_T_upper_arm_a_y
        + R_P_forearm_zx * delta_T_upper_arm_a_z;
    const six_link_real t588 = R_P_forearm_xy * delta_T_upper_arm_a_x + R_P_forearm_yy * delta_T_upper_arm_a_y
        + R_P_forearm_zy * delta_T_upper_arm_a_z;
    const six_link_real t589 = R_P_forearm_xz * delta_T_upper_arm_a_x + R_P_forearm_yz * delta_T_upper_arm_a_y
        + R_P_forearm_zz * delta_T_upper_arm_a_z;
    const six_link_real carried_forearm_a_x = t587
        + (carried_forearm_alpha_y * r_R_forearm_z - carried_forearm_alpha_z * r_R_forearm_y);
    const six_link_real carried_forearm_a_y = t588
        + (carried_forearm_alpha_z * r_R_forearm_x - carried_forearm_alpha_x * r_R_forearm_z);
    const six_link_real carried_forearm_a_z = t589
        + (carried_forearm_alpha_x * r_R_forearm_y - carried_forearm_alpha_y * r_R_forearm_x);
    const six_link_real t590 = joint_W_forearm_11 * carried_forearm_alpha_x
        + joint_W_forearm_12 * carried_forearm_alpha_y + joint_W_forearm_13 * carried_forearm_alpha_z;
    const six_link_real t591 = t590 + joint_W_forearm_14 * carried_forearm_a_x
        + joint_W_forearm_15 * carried_forearm_a_y + joint_W_forearm_16 * carried_forearm_a_z;
    const six_link_real qddot_forearm_1 = joint_w_forearm_1 - t591;
    output->vdot[2] = qddot_forearm_1;

    /* forearm, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_forearm_alpha_y = carried_forearm_alpha_y + qddot_forearm_1;
    const six_link_real t592 = modes_W_forearm_11 * carried_forearm_alpha_x
        + modes_W_forearm_12 * delta_forearm_alpha_y + modes_W_forearm_13 * carried_forearm_alpha_z;
    const six_link_real t593 = t592 + modes_W_forearm_14 * carried_forearm_a_x
        + modes_W_forearm_15 * carried_forearm_a_y + modes_W_forearm_16 * carried_forearm_a_z;
    const six_link_real t594 = modes_W_forearm_21 * carried_forearm_alpha_x
        + modes_W_forearm_22 * delta_forearm_alpha_y + modes_W_forearm_23 * carried_forearm_alpha_z;
    const six_link_real t595 = t594 + modes_W_forearm_24 * carried_forearm_a_x
        + modes_W_forearm_25 * carried_forearm_a_y + modes_W_forearm_26 * carried_forearm_a_z;
    const six_link_real t596 = modes_W_forearm_31 * carried_forearm_alpha_x
        + modes_W_forearm_32 * delta_forearm_alpha_y + modes_W_forearm_33 * carried_forearm_alpha_z;
    const six_link_real t597 = -(t596 + modes_W_forearm_34 * carried_forearm_a_x)
        - modes_W_forearm_35 * carried_forearm_a_y - modes_W_forearm_36 * carried_forearm_a_z;
    const six_link_real t598 = modes_W_forearm_41 * carried_forearm_alpha_x
        + modes_W_forearm_42 * delta_forearm_alpha_y + modes_W_forearm_43 * carried_forearm_alpha_z;
    const six_link_real t599 = t598 + modes_W_forearm_44 * carried_forearm_a_x
        + modes_W_forearm_45 * carried_forearm_a_y + modes_W_forearm_46 * carried_forearm_a_z;
    const six_link_real etaddot_forearm_4 = -t599 - modes_w_forearm_4;
    output->vdot[14] = etaddot_forearm_4;
    const six_link_real etaddot_forearm_3 = t597 - modes_w_forearm_3 - modes_L_forearm_43 * etaddot_forearm_4;
    output->vdot[13] = etaddot_forearm_3;
    const six_link_real etaddot_forearm_2 = -(modes_w_forearm_2 + t595 + modes_L_forearm_32 * etaddot_forearm_3)
        - modes_L_forearm_42 * etaddot_forearm_4;
    output->vdot[12] = etaddot_forearm_2;
    const six_link_real t600 = -t593 - modes_w_forearm_1 - modes_L_forearm_21 * etaddot_forearm_2
        - modes_L_forearm_31 * etaddot_forearm_3;
    const six_link_real etaddot_forearm_1 = t600 - modes_L_forearm_41 * etaddot_forearm_4;
    output->vdot[11] = etaddot_forearm_1;

    /* forearm, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real t601 = c->links[2].Psi_c_y3 * etaddot_forearm_3 + c->links[2].Psi_c_y4 * etaddot_forearm_4;
    const six_link_real t602 = c->links[2].Psi_c_z1 * etaddot_forearm_1 + c->links[2].Psi_c_z2 * etaddot_forearm_2;
    const six_link_real delta_T_forearm_a_x = carried_forearm_a_x
        + (delta_forearm_alpha_y * r_T_forearm_z - carried_forearm_alpha_z * r_T_forearm_y);
    const six_link_real t603 = carried_forearm_a_y
        + (carried_forearm_alpha_z * c->links[2].length - carried_forearm_alpha_x * r_T_forearm_z);
    const six_link_real t604 = carried_forearm_a_z
        + (carried_forearm_alpha_x * r_T_forearm_y - delta_forearm_alpha_y * c->links[2].length);
    const six_link_real delta_T_forearm_alpha_x = carried_forearm_alpha_x
        - (J_l_forearm_yx * t601 - J_l_forearm_xz * t602);
    const six_link_real delta_T_forearm_alpha_y = delta_forearm_alpha_y
        + (J_l_forearm_yy * t601 + J_l_forearm_yz * t602);
    const six_link_real delta_T_forearm_alpha_z = carried_forearm_alpha_z
        + (J_l_forearm_yz * t601 + J_l_forearm_zz * t602);
    const six_link_real delta_T_forearm_a_y = t603
        + (etaddot_forearm_1 * SIX_LINK_REAL(2.0195202782688155)
        + etaddot_forearm_2 * SIX_LINK_REAL(2.8145226674626453));
    const six_link_real delta_T_forearm_a_z = t604
        + (etaddot_forearm_3 * SIX_LINK_REAL(2.0195202782688155)
        + etaddot_forearm_4 * SIX_LINK_REAL(2.8145226674626453));

    /* wrist_roll, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_wrist_roll_alpha_x = R_T_forearm_xx * delta_T_forearm_alpha_x
        + R_T_forearm_yx * delta_T_forearm_alpha_y - R_T_forearm_xz * delta_T_forearm_alpha_z;
    const six_link_real carried_wrist_roll_alpha_y = R_P_wrist_roll_xy * delta_T_forearm_alpha_x
        + R_P_wrist_roll_yy * delta_T_forearm_alpha_y + R_P_wrist_roll_zy * delta_T_forearm_alpha_z;
    const six_link_real carried_wrist_roll_alpha_z = R_P_wrist_roll_xz * delta_T_forearm_alpha_x
        + R_P_wrist_roll_yz * delta_T_forearm_alpha_y + R_P_wrist_roll_zz * delta_T_forearm_alpha_z;
    const six_link_real carried_wrist_roll_a_x = R_T_forearm_xx * delta_T_forearm_a_x
        + R_T_forearm_yx * delta_T_forearm_a_y - R_T_forearm_xz * delta_T_forearm_a_z;
    const six_link_real carried_wrist_roll_a_y = R_P_wrist_roll_xy * delta_T_forearm_a_x
        + R_P_wrist_roll_yy * delta_T_forearm_a_y + R_P_wrist_roll_zy * delta_T_forearm_a_z;
    const six_link_real carried_wrist_roll_a_z = R_P_wrist_roll_xz * delta_T_forearm_a_x
        + R_P_wrist_roll_yz * delta_T_forearm_a_y + R_P_wrist_roll_zz * delta_T_forearm_a_z;
    const six_link_real t605 = joint_W_wrist_roll_11 * carried_wrist_roll_alpha_x
        + joint_W_wrist_roll_12 * carried_wrist_roll_alpha_y;
    const six_link_real t606 = t605 + joint_W_wrist_roll_13 * carried_wrist_roll_alpha_z
        + joint_W_wrist_roll_14 * carried_wrist_roll_a_x;
    const six_link_real t607 = t606 + joint_W_wrist_roll_15 * carried_wrist_roll_a_y
        + joint_W_wrist_roll_16 * carried_wrist_roll_a_z;
    const six_link_real qddot_wrist_roll_1 = joint_w_wrist_roll_1 - t607;
    output->vdot[3] = qddot_wrist_roll_1;

    /* wrist_roll, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_wrist_roll_alpha_x = carried_wrist_roll_alpha_x + qddot_wrist_roll_1;

    /* wrist_roll, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real delta_T_wrist_roll_a_y = carried_wrist_roll_a_y
        + carried_wrist_roll_alpha_z * c->links[3].length;
    const six_link_real delta_T_wrist_roll_a_z = carried_wrist_roll_a_z
        - carried_wrist_roll_alpha_y * c->links[3].length;

    /* wrist_pitch, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_wrist_pitch_alpha_x = R_rel_wrist_pitch_xx * delta_wrist_roll_alpha_x
        - R_rel_wrist_pitch_xz * carried_wrist_roll_alpha_z;
    const six_link_real carried_wrist_pitch_alpha_z = R_rel_wrist_pitch_xz * delta_wrist_roll_alpha_x
        + R_rel_wrist_pitch_xx * carried_wrist_roll_alpha_z;
    const six_link_real carried_wrist_pitch_a_x = R_rel_wrist_pitch_xx * carried_wrist_roll_a_x
        - R_rel_wrist_pitch_xz * delta_T_wrist_roll_a_z;
    const six_link_real carried_wrist_pitch_a_z = R_rel_wrist_pitch_xz * carried_wrist_roll_a_x
        + R_rel_wrist_pitch_xx * delta_T_wrist_roll_a_z;
    const six_link_real t608 = joint_W_wrist_pitch_11 * carried_wrist_pitch_alpha_x
        + joint_W_wrist_pitch_12 * carried_wrist_roll_alpha_y;
    const six_link_real t609 = t608 + joint_W_wrist_pitch_13 * carried_wrist_pitch_alpha_z
        + joint_W_wrist_pitch_14 * carried_wrist_pitch_a_x;
    const six_link_real t610 = t609 - minus_joint_W_wrist_pitch_15 * delta_T_wrist_roll_a_y
        + joint_W_wrist_pitch_16 * carried_wrist_pitch_a_z;
    const six_link_real qddot_wrist_pitch_1 = joint_w_wrist_pitch_1 - t610;
    output->vdot[4] = qddot_wrist_pitch_1;

    /* wrist_pitch, link: what is added to the acceleration of F_i, modal accelerations (83) */
    const six_link_real delta_wrist_pitch_alpha_y = carried_wrist_roll_alpha_y + qddot_wrist_pitch_1;

    /* wrist_pitch, tip: what is added to the acceleration of the tip section (accconst1b) */
    const six_link_real delta_T_wrist_pitch_a_y = delta_T_wrist_roll_a_y
        + carried_wrist_pitch_alpha_z * c->links[4].length;
    const six_link_real delta_T_wrist_pitch_a_z = carried_wrist_pitch_a_z
        - delta_wrist_pitch_alpha_y * c->links[4].length;

    /* flange, joint: acceleration that the parent's tip imparts, joint accelerations (48) */
    const six_link_real carried_flange_alpha_y = R_rel_flange_yy * delta_wrist_pitch_alpha_y
        + R_rel_flange_zy * carried_wrist_pitch_alpha_z;
    const six_link_real carried_flange_alpha_z = R_rel_flange_yy * carried_wrist_pitch_alpha_z
        - R_rel_flange_zy * delta_wrist_pitch_alpha_y;
    const six_link_real carried_flange_a_y = R_rel_flange_yy * delta_T_wrist_pitch_a_y
        + R_rel_flange_zy * delta_T_wrist_pitch_a_z;
    const six_link_real carried_flange_a_z = R_rel_flange_yy * delta_T_wrist_pitch_a_z
        - R_rel_flange_zy * delta_T_wrist_pitch_a_y;
    const six_link_real t611 = joint_W_flange_11 * carried_wrist_pitch_alpha_x
        - minus_joint_W_flange_12 * carried_flange_alpha_y;
    const six_link_real t612 = t611 - minus_joint_W_flange_13 * carried_flange_alpha_z
        - minus_joint_W_flange_15 * carried_flange_a_y;
    const six_link_real qddot_flange_1 = joint_w_flange_1 - (t612 + joint_W_flange_16 * carried_flange_a_z);
    output->vdot[5] = qddot_flange_1;

    if (wanted & SIX_LINK_WRENCHES) {
        /* upper_arm, joint: its accelerations eliminated from its rows (43) */
        const six_link_real Lambda_i_upper_arm_12 = M_i_upper_arm_12 - M_i_upper_arm_12 * joint_W_upper_arm_12;
        const six_link_real Lambda_i_upper_arm_23 = M_i_upper_arm_23 - M_i_upper_arm_22 * joint_W_upper_arm_13;
        const six_link_real Lambda_i_upper_arm_25 = M_i_upper_arm_25 - M_i_upper_arm_22 * joint_W_upper_arm_15;
        const six_link_real p_i_upper_arm_tau_y = h_i_upper_arm_tau_y + M_i_upper_arm_22 * joint_w_upper_arm_1;

        /* upper_arm, handed up: inertia and bias that the joint shows to the parent's tip (49) */
        const six_link_real t613 = r_R_upper_arm_z * Lambda_i_upper_arm_45;
        const six_link_real t614 = Lambda_i_upper_arm_14 + (t538 - t613);
        const six_link_real Lambda_upper_arm_10 = Lambda_i_upper_arm_25 + (t613 - t539);
        const six_link_real t615 = Lambda_i_upper_arm_12
            - (Lambda_i_upper_arm_16 * r_R_upper_arm_x - Lambda_i_upper_arm_14 * r_R_upper_arm_z);
        const six_link_real t616 = Lambda_i_upper_arm_23
            - (Lambda_i_upper_arm_24 * c->links[1].mount_xyz_y - Lambda_i_upper_arm_25 * r_R_upper_arm_x);
        const six_link_real Lambda_upper_arm_3 = R_rel_upper_arm_xx * t555 - R_rel_upper_arm_xz * t554;
        const six_link_real t617 = R_rel_upper_arm_xz
            * (t615 + (c->links[1].mount_xyz_y * t543 - r_R_upper_arm_z * Lambda_upper_arm_10));
        const six_link_real Lambda_upper_arm_8 = (t616 + (r_R_upper_arm_z * t544 - r_R_upper_arm_x * t546))
            * R_rel_upper_arm_xx - t617;
        const six_link_real Lambda_upper_arm_5 = R_rel_upper_arm_xx * t540 + R_rel_upper_arm_xz * t545;
        const six_link_real Lambda_upper_arm_13 = R_rel_upper_arm_xx
            * (t544 * R_rel_upper_arm_xx + t546 * R_rel_upper_arm_xz)
            - R_rel_upper_arm_xz * (t614 * R_rel_upper_arm_xx + t541 * R_rel_upper_arm_xz);
        const six_link_real Lambda_upper_arm_15 = R_rel_upper_arm_xx
            * (t546 * R_rel_upper_arm_xx - t544 * R_rel_upper_arm_xz)
            - R_rel_upper_arm_xz * (t541 * R_rel_upper_arm_xx - t614 * R_rel_upper_arm_xz);
        const six_link_real Lambda_upper_arm_17 = R_rel_upper_arm_xx * Lambda_i_upper_arm_45
            + Lambda_i_upper_arm_56 * R_rel_upper_arm_xz;
        const six_link_real Lambda_upper_arm_20 = Lambda_i_upper_arm_56 * R_rel_upper_arm_xx
            - R_rel_upper_arm_xz * Lambda_i_upper_arm_45;
        const six_link_real p_upper_arm_tau_y = p_i_upper_arm_tau_y
            + (r_R_upper_arm_z * p_i_upper_arm_f_x - r_R_upper_arm_x * p_i_upper_arm_f_z);
        const six_link_real p_upper_arm_tau_x = R_rel_upper_arm_xx * t557 + R_rel_upper_arm_xz * t558;
        const six_link_real p_upper_arm_f_x = R_rel_upper_arm_xx * p_i_upper_arm_f_x
            + R_rel_upper_arm_xz * p_i_upper_arm_f_z;
        const six_link_real p_upper_arm_f_z = R_rel_upper_arm_xx * p_i_upper_arm_f_z
            - R_rel_upper_arm_xz * p_i_upper_arm_f_x;

        /* shoulder, H_star: gyroscopic wrench and weight, angular acceleration included */
        const six_link_real H_star_shoulder_tau_y = c->links[0].S_0_x * c->gravity[2];
        const six_link_real minus_H_star_shoulder_f_x = minus_a_J_shoulder_x * c->links[0].mu
            + minus_Omega_shoulder_xx * c->links[0].S_0_x;
        const six_link_real H_star_shoulder_f_y = a_J_shoulder_y * c->links[0].mu;
        const six_link_real minus_H_star_shoulder_f_z = c->gravity[2] * c->links[0].mu;

        /* shoulder, tip load: the next link, bodies and external wrench, at the tip point in F_i axes (46) */
        const six_link_real Lambda_T_shoulder_13 = Lambda_upper_arm_3 - c->links[0].J_T_xz;
        const six_link_real Lambda_T_shoulder_15 = Lambda_upper_arm_5 - c->links[0].S_T_z;
        const six_link_real Lambda_T_shoulder_23 = Lambda_upper_arm_8 - c->links[0].J_T_yz;
        const six_link_real Lambda_T_shoulder_34 = Lambda_upper_arm_13 - c->links[0].S_T_y;
        const six_link_real t618 = state->v[0] * (c->links[0].J_T_yz * state->v[0])
            - (c->links[0].S_T_y * c->gravity[2] + c->links[0].S_T_z * a_J_shoulder_y);
        const six_link_real t619 = c->links[0].S_T_x * c->gravity[2] - c->links[0].S_T_z * minus_a_t_shoulder_x
            - state->v[0] * (c->links[0].J_T_xz * state->v[0]);
        const six_link_real t620 = p_upper_arm_f_x
            - (c->links[0].body0_mass * minus_a_t_shoulder_x + state->v[0] * (state->v[0] * c->links[0].S_T_x));
        const six_link_real p_T_shoulder_tau_x = p_upper_arm_tau_x + t618 - input->w_ext[0][0];
        const six_link_real p_T_shoulder_tau_y = p_upper_arm_tau_y + t619 - input->w_ext[0][1];
        const six_link_real p_T_shoulder_f_x = t620 - input->w_ext[0][3];
        const six_link_real p_T_shoulder_f_z = p_upper_arm_f_z - c->links[0].body0_mass * c->gravity[2]
            - input->w_ext[0][5];

        /* shoulder, modes: the tip load folded in, modal accelerations eliminated (83) */
        const six_link_real M_loaded_shoulder_34 = Lambda_T_shoulder_34 + c->links[0].length * Lambda_upper_arm_17;
        const six_link_real M_loaded_shoulder_36 = Lambda_upper_arm_15 + c->links[0].length * Lambda_upper_arm_20;
        const six_link_real M_loaded_shoulder_13 = Lambda_T_shoulder_13 + Lambda_T_shoulder_15 * c->links[0].length;
        const six_link_real M_loaded_shoulder_23 = Lambda_T_shoulder_23 + Lambda_upper_arm_10 * c->links[0].length
            - c->links[0].length * M_loaded_shoulder_36;
        const six_link_real M_loaded_shoulder_35 = c->links[0].S_0_x + t561;
        const six_link_real h_loaded_shoulder_tau_y = H_star_shoulder_tau_y
            + (p_T_shoulder_tau_y - c->links[0].length * p_T_shoulder_f_z);
        const six_link_real h_loaded_shoulder_f_x = p_T_shoulder_f_x - minus_H_star_shoulder_f_x;
        const six_link_real h_loaded_shoulder_f_y = H_star_shoulder_f_y + p_T_shoulder_f_y;
        const six_link_real h_loaded_shoulder_f_z = p_T_shoulder_f_z - minus_H_star_shoulder_f_z;

        /* shoulder, joint: its accelerations eliminated from its rows (43) */
        const six_link_real p_i_shoulder_tau_x = p_T_shoulder_tau_x + M_loaded_shoulder_13 * joint_w_shoulder_1;
        output->wrench[0][0] = p_i_shoulder_tau_x;
        const six_link_real p_i_shoulder_tau_y = h_loaded_shoulder_tau_y + M_loaded_shoulder_23 * joint_w_shoulder_1;
        output->wrench[0][1] = p_i_shoulder_tau_y;
        const six_link_real p_i_shoulder_tau_z = h_loaded_shoulder_tau_z + M_loaded_shoulder_33 * joint_w_shoulder_1;
        output->wrench[0][2] = p_i_shoulder_tau_z;
        const six_link_real p_i_shoulder_f_x = h_loaded_shoulder_f_x + M_loaded_shoulder_34 * joint_w_shoulder_1;
        output->wrench[0][3] = p_i_shoulder_f_x;
        const six_link_real p_i_shoulder_f_y = h_loaded_shoulder_f_y + M_loaded_shoulder_35 * joint_w_shoulder_1;
        output->wrench[0][4] = p_i_shoulder_f_y;
        const six_link_real p_i_shoulder_f_z = h_loaded_shoulder_f_z + M_loaded_shoulder_36 * joint_w_shoulder_1;
        output->wrench[0][5] = p_i_shoulder_f_z;

        /* upper_arm, joint wrench (48) */
        const six_link_real t621 = Lambda_i_upper_arm_13 * carried_upper_arm_alpha_z
            - Lambda_i_upper_arm_11 * minus_carried_upper_arm_alpha_x;
        const six_link_real t622 = t621 - Lambda_i_upper_arm_14 * minus_carried_upper_arm_a_x
            + Lambda_i_upper_arm_15 * carried_upper_arm_a_y;
        const six_link_real t623 = Lambda_i_upper_arm_23 * carried_upper_arm_alpha_z
            - Lambda_i_upper_arm_12 * minus_carried_upper_arm_alpha_x;
        const six_link_real t624 = t623 - Lambda_i_upper_arm_24 * minus_carried_upper_arm_a_x
            + Lambda_i_upper_arm_25 * carried_upper_arm_a_y;
        const six_link_real t625 = Lambda_i_upper_arm_33 * carried_upper_arm_alpha_z
            - Lambda_i_upper_arm_13 * minus_carried_upper_arm_alpha_x;
        const six_link_real t626 = t625 - Lambda_i_upper_arm_34 * minus_carried_upper_arm_a_x
            + Lambda_i_upper_arm_35 * carried_upper_arm_a_y;
        const six_link_real t627 = Lambda_i_upper_arm_34 * carried_upper_arm_alpha_z
            - Lambda_i_upper_arm_14 * minus_carried_upper_arm_alpha_x;
        const six_link_real t628 = t627 - Lambda_i_upper_arm_44 * minus_carried_upper_arm_a_x
            + Lambda_i_upper_arm_45 * carried_upper_arm_a_y;
        const six_link_real t629 = Lambda_i_upper_arm_35 * carried_upper_arm_alpha_z
            - Lambda_i_upper_arm_15 * minus_carried_upper_arm_alpha_x;
        const six_link_real t630 = t629 - Lambda_i_upper_arm_45 * minus_carried_upper_arm_a_x
            + Lambda_i_upper_arm_55 * carried_upper_arm_a_y;
        const six_link_real t631 = Lambda_i_upper_arm_36 * carried_upper_arm_alpha_z
            - Lambda_i_upper_arm_16 * minus_carried_upper_arm_alpha_x;
        const six_link_real t632 = t631 - Lambda_i_upper_arm_46 * minus_carried_upper_arm_a_x
            + Lambda_i_upper_arm_56 * carried_upper_arm_a_y;
        const six_link_real wrench_upper_arm_tau_x = t622 - Lambda_i_upper_arm_16 * minus_carried_upper_arm_a_z
            + p_i_upper_arm_tau_x;
        output->wrench[1][0] = wrench_upper_arm_tau_x;
        const six_link_real wrench_upper_arm_tau_y = t624 - Lambda_i_upper_arm_26 * minus_carried_upper_arm_a_z
            + p_i_upper_arm_tau_y;
        output->wrench[1][1] = wrench_upper_arm_tau_y;
        const six_link_real wrench_upper_arm_tau_z = t626 - Lambda_i_upper_arm_36 * minus_carried_upper_arm_a_z
            + p_i_upper_arm_tau_z;
        output->wrench[1][2] = wrench_upper_arm_tau_z;
        const six_link_real wrench_upper_arm_f_x = t628 - Lambda_i_upper_arm_46 * minus_carried_upper_arm_a_z
            + p_i_upper_arm_f_x;
        output->wrench[1][3] = wrench_upper_arm_f_x;
        const six_link_real wrench_upper_arm_f_y = t630 - Lambda_i_upper_arm_56 * minus_carried_upper_arm_a_z
            + p_i_upper_arm_f_y;
        output->wrench[1][4] = wrench_upper_arm_f_y;
        const six_link_real wrench_upper_arm_f_z = t632 - Lambda_i_upper_arm_66 * minus_carried_upper_arm_a_z
            + p_i_upper_arm_f_z;
        output->wrench[1][5] = wrench_upper_arm_f_z;

        /* forearm, joint wrench (48) */
        const six_link_real t633 = Lambda_i_forearm_11 * carried_forearm_alpha_x
            + Lambda_i_forearm_12 * carried_forearm_alpha_y + Lambda_i_forearm_13 * carried_forearm_alpha_z;
        const six_link_real t634 = t633 + Lambda_i_forearm_14 * carried_forearm_a_x
            + Lambda_i_forearm_15 * carried_forearm_a_y + Lambda_i_forearm_16 * carried_forearm_a_z;
        const six_link_real t635 = Lambda_i_forearm_12 * carried_forearm_alpha_x
            + Lambda_i_forearm_22 * carried_forearm_alpha_y + Lambda_i_forearm_23 * carried_forearm_alpha_z;
        const six_link_real t636 = t635 + Lambda_i_forearm_24 * carried_forearm_a_x
            + Lambda_i_forearm_25 * carried_forearm_a_y + Lambda_i_forearm_26 * carried_forearm_a_z;
        const six_link_real t637 = Lambda_i_forearm_13 * carried_forearm_alpha_x
            + Lambda_i_forearm_23 * carried_forearm_alpha_y + Lambda_i_forearm_33 * carried_forearm_alpha_z;
        const six_link_real t638 = t637 + Lambda_i_forearm_34 * carried_forearm_a_x
            + Lambda_i_forearm_35 * carried_forearm_a_y + Lambda_i_forearm_36 * carried_forearm_a_z;
        const six_link_real t639 = Lambda_i_forearm_14 * carried_forearm_alpha_x
            + Lambda_i_forearm_24 * carried_forearm_alpha_y + Lambda_i_forearm_34 * carried_forearm_alpha_z;
        const six_link_real t640 = t639 + Lambda_i_forearm_44 * carried_forearm_a_x
            + Lambda_i_forearm_45 * carried_forearm_a_y + Lambda_i_forearm_46 * carried_forearm_a_z;
        const six_link_real t641 = Lambda_i_forearm_15 * carried_forearm_alpha_x
            + Lambda_i_forearm_25 * carried_forearm_alpha_y + Lambda_i_forearm_35 * carried_forearm_alpha_z;
        const six_link_real t642 = t641 + Lambda_i_forearm_45 * carried_forearm_a_x
            + Lambda_i_forearm_55 * carried_forearm_a_y + Lambda_i_forearm_56 * carried_forearm_a_z;
        const six_link_real t643 = Lambda_i_forearm_16 * carried_forearm_alpha_x
            + Lambda_i_forearm_26 * carried_forearm_alpha_y + Lambda_i_forearm_36 * carried_forearm_alpha_z;
        const six_link_real t644 = t643 + Lambda_i_forearm_46 * carried_forearm_a_x
            + Lambda_i_forearm_56 * carried_forearm_a_y + Lambda_i_forearm_66 * carried_forearm_a_z;
        const six_link_real wrench_forearm_tau_x = t634 + p_i_forearm_tau_x;
        output->wrench[2][0] = wrench_forearm_tau_x;
        const six_link_real wrench_forearm_tau_y = t636 + p_i_forearm_tau_y;
        output->wrench[2][1] = wrench_forearm_tau_y;
        const six_link_real wrench_forearm_tau_z = t638 + p_i_forearm_tau_z;
        output->wrench[2][2] = wrench_forearm_tau_z;
        const six_link_real wrench_forearm_f_x = t640 + p_i_forearm_f_x;
        output->wrench[2][3] = wrench_forearm_f_x;
        const six_link_real wrench_forearm_f_y = t642 + p_i_forearm_f_y;
        output->wrench[2][4] = wrench_forearm_f_y;
        const six_link_real wrench_forearm_f_z = t644 + p_i_forearm_f_z;
        output->wrench[2][5] = wrench_forearm_f_z;

        /* wrist_roll, joint wrench (48) */
        const six_link_real t645 = Lambda_i_wrist_roll_11 * carried_wrist_roll_alpha_x
            + Lambda_i_wrist_roll_12 * carried_wrist_roll_alpha_y;
        const six_link_real t646 = t645 + Lambda_i_wrist_roll_13 * carried_wrist_roll_alpha_z
            + Lambda_i_wrist_roll_14 * carried_wrist_roll_a_x;
        const six_link_real t647 = t646 + Lambda_i_wrist_roll_15 * carried_wrist_roll_a_y
            + Lambda_i_wrist_roll_16 * carried_wrist_roll_a_z;
        const six_link_real t648 = Lambda_i_wrist_roll_12 * carried_wrist_roll_alpha_x
            + Lambda_i_wrist_roll_22 * carried_wrist_roll_alpha_y;
        const six_link_real t649 = t648 + Lambda_i_wrist_roll_23 * carried_wrist_roll_alpha_z
            + Lambda_i_wrist_roll_24 * carried_wrist_roll_a_x;
        const six_link_real t650 = t649 + Lambda_i_wrist_roll_25 * carried_wrist_roll_a_y
            + Lambda_i_wrist_roll_26 * carried_wrist_roll_a_z;
        const six_link_real t651 = Lambda_i_wrist_roll_13 * carried_wrist_roll_alpha_x
            + Lambda_i_wrist_roll_23 * carried_wrist_roll_alpha_y;
        const six_link_real t652 = t651 + Lambda_i_wrist_roll_33 * carried_wrist_roll_alpha_z
            + Lambda_i_wrist_roll_34 * carried_wrist_roll_a_x;
        const six_link_real t653 = t652 + Lambda_i_wrist_roll_35 * carried_wrist_roll_a_y
            + Lambda_i_wrist_roll_36 * carried_wrist_roll_a_z;
        const six_link_real t654 = Lambda_i_wrist_roll_14 * carried_wrist_roll_alpha_x
            + Lambda_i_wrist_roll_24 * carried_wrist_roll_alpha_y;
        const six_link_real t655 = t654 + Lambda_i_wrist_roll_34 * carried_wrist_roll_alpha_z
            + Lambda_i_wrist_roll_44 * carried_wrist_roll_a_x;
        const six_link_real t656 = t655 + Lambda_i_wrist_roll_45 * carried_wrist_roll_a_y
            + Lambda_i_wrist_roll_46 * carried_wrist_roll_a_z;
        const six_link_real t657 = Lambda_i_wrist_roll_15 * carried_wrist_roll_alpha_x
            + Lambda_i_wrist_roll_25 * carried_wrist_roll_alpha_y;
        const six_link_real t658 = t657 + Lambda_i_wrist_roll_35 * carried_wrist_roll_alpha_z
            + Lambda_i_wrist_roll_45 * carried_wrist_roll_a_x;
        const six_link_real t659 = t658 + Lambda_i_wrist_roll_55 * carried_wrist_roll_a_y
            + Lambda_i_wrist_roll_56 * carried_wrist_roll_a_z;
        const six_link_real t660 = Lambda_i_wrist_roll_16 * carried_wrist_roll_alpha_x
            + Lambda_i_wrist_roll_26 * carried_wrist_roll_alpha_y;
        const six_link_real t661 = t660 + Lambda_i_wrist_roll_36 * carried_wrist_roll_alpha_z
            + Lambda_i_wrist_roll_46 * carried_wrist_roll_a_x;
        const six_link_real t662 = t661 + Lambda_i_wrist_roll_56 * carried_wrist_roll_a_y
            + Lambda_i_wrist_roll_66 * carried_wrist_roll_a_z;
        const six_link_real wrench_wrist_roll_tau_x = t647 + p_i_wrist_roll_tau_x;
        output->wrench[3][0] = wrench_wrist_roll_tau_x;
        const six_link_real wrench_wrist_roll_tau_y = t650 + p_i_wrist_roll_tau_y;
        output->wrench[3][1] = wrench_wrist_roll_tau_y;
        const six_link_real wrench_wrist_roll_tau_z = t653 + p_i_wrist_roll_tau_z;
        output->wrench[3][2] = wrench_wrist_roll_tau_z;
        const six_link_real wrench_wrist_roll_f_x = t656 + p_i_wrist_roll_f_x;
        output->wrench[3][3] = wrench_wrist_roll_f_x;
        const six_link_real wrench_wrist_roll_f_y = t659 + p_i_wrist_roll_f_y;
        output->wrench[3][4] = wrench_wrist_roll_f_y;
        const six_link_real wrench_wrist_roll_f_z = t662 + p_i_wrist_roll_f_z;
        output->wrench[3][5] = wrench_wrist_roll_f_z;

        /* wrist_pitch, joint wrench (48) */
        const six_link_real t663 = Lambda_i_wrist_pitch_11 * carried_wrist_pitch_alpha_x
            + Lambda_i_wrist_pitch_12 * carried_wrist_roll_alpha_y;
        const six_link_real t664 = t663 + Lambda_i_wrist_pitch_13 * carried_wrist_pitch_alpha_z
            - minus_Lambda_i_wrist_pitch_14 * carried_wrist_pitch_a_x;
        const six_link_real t665 = t664 + Lambda_i_wrist_pitch_15 * delta_T_wrist_roll_a_y
            + Lambda_i_wrist_pitch_16 * carried_wrist_pitch_a_z;
        const six_link_real t666 = Lambda_i_wrist_pitch_12 * carried_wrist_pitch_alpha_x
            + Lambda_i_wrist_pitch_22 * carried_wrist_roll_alpha_y;
        const six_link_real t667 = t666 + Lambda_i_wrist_pitch_23 * carried_wrist_pitch_alpha_z
            + Lambda_i_wrist_pitch_24 * carried_wrist_pitch_a_x;
        const six_link_real t668 = t667 + Lambda_i_wrist_pitch_25 * delta_T_wrist_roll_a_y
            + Lambda_i_wrist_pitch_26 * carried_wrist_pitch_a_z;
        const six_link_real t669 = Lambda_i_wrist_pitch_13 * carried_wrist_pitch_alpha_x
            + Lambda_i_wrist_pitch_23 * carried_wrist_roll_alpha_y;
        const six_link_real t670 = t669 + Lambda_i_wrist_pitch_33 * carried_wrist_pitch_alpha_z
            + Lambda_i_wrist_pitch_34 * carried_wrist_pitch_a_x;
        const six_link_real t671 = t670 + Lambda_i_wrist_pitch_35 * delta_T_wrist_roll_a_y
            + Lambda_i_wrist_pitch_36 * carried_wrist_pitch_a_z;
        const six_link_real t672 = Lambda_i_wrist_pitch_24 * carried_wrist_roll_alpha_y
            - minus_Lambda_i_wrist_pitch_14 * carried_wrist_pitch_alpha_x;
        const six_link_real t673 = t672 + Lambda_i_wrist_pitch_34 * carried_wrist_pitch_alpha_z
            + Lambda_i_wrist_pitch_44 * carried_wrist_pitch_a_x;
        const six_link_real t674 = t673 + Lambda_i_wrist_pitch_45 * delta_T_wrist_roll_a_y
            - minus_Lambda_i_wrist_pitch_46 * carried_wrist_pitch_a_z;
        const six_link_real t675 = Lambda_i_wrist_pitch_15 * carried_wrist_pitch_alpha_x
            + Lambda_i_wrist_pitch_25 * carried_wrist_roll_alpha_y;
        const six_link_real t676 = t675 + Lambda_i_wrist_pitch_35 * carried_wrist_pitch_alpha_z
            + Lambda_i_wrist_pitch_45 * carried_wrist_pitch_a_x;
        const six_link_real t677 = t676 + Lambda_i_wrist_pitch_55 * delta_T_wrist_roll_a_y
            + Lambda_i_wrist_pitch_56 * carried_wrist_pitch_a_z;
        const six_link_real t678 = Lambda_i_wrist_pitch_16 * carried_wrist_pitch_alpha_x
            + Lambda_i_wrist_pitch_26 * carried_wrist_roll_alpha_y;
        const six_link_real t679 = t678 + Lambda_i_wrist_pitch_36 * carried_wrist_pitch_alpha_z
            - minus_Lambda_i_wrist_pitch_46 * carried_wrist_pitch_a_x;
        const six_link_real t680 = t679 + Lambda_i_wrist_pitch_56 * delta_T_wrist_roll_a_y
            + Lambda_i_wrist_pitch_66 * carried_wrist_pitch_a_z;
        const six_link_real wrench_wrist_pitch_tau_x = t665 + p_i_wrist_pitch_tau_x;
        output->wrench[4][0] = wrench_wrist_pitch_tau_x;
        const six_link_real wrench_wrist_pitch_tau_y = t668 + p_i_wrist_pitch_tau_y;
        output->wrench[4][1] = wrench_wrist_pitch_tau_y;
        const six_link_real wrench_wrist_pitch_tau_z = t671 + p_i_wrist_pitch_tau_z;
        output->wrench[4][2] = wrench_wrist_pitch_tau_z;
        const six_link_real wrench_wrist_pitch_f_x = t674 + p_i_wrist_pitch_f_x;
        output->wrench[4][3] = wrench_wrist_pitch_f_x;
        const six_link_real wrench_wrist_pitch_f_y = t677 + p_i_wrist_pitch_f_y;
        output->wrench[4][4] = wrench_wrist_pitch_f_y;
        const six_link_real wrench_wrist_pitch_f_z = t680 + p_i_wrist_pitch_f_z;
        output->wrench[4][5] = wrench_wrist_pitch_f_z;

        /* flange, joint wrench (48) */
        const six_link_real t681 = Lambda_i_flange_11 * carried_wrist_pitch_alpha_x
            + Lambda_i_flange_12 * carried_flange_alpha_y + Lambda_i_flange_13 * carried_flange_alpha_z;
        const six_link_real t682 = Lambda_i_flange_12 * carried_wrist_pitch_alpha_x
            + Lambda_i_flange_22 * carried_flange_alpha_y - minus_Lambda_i_flange_23 * carried_flange_alpha_z;
        const six_link_real t683 = t682 + c->links[5].S_T_z * carried_wrist_pitch_a_x
            - minus_Lambda_i_flange_25 * carried_flange_a_y;
        const six_link_real t684 = Lambda_i_flange_13 * carried_wrist_pitch_alpha_x
            - minus_Lambda_i_flange_23 * carried_flange_alpha_y;
        const six_link_real t685 = t684 + Lambda_i_flange_33 * carried_flange_alpha_z
            - c->links[5].S_T_y * carried_wrist_pitch_a_x + Lambda_i_flange_35 * carried_flange_a_y;
        const six_link_real t686 = c->links[5].S_T_z * carried_flange_alpha_y
            - c->links[5].S_T_y * carried_flange_alpha_z + M_loaded_flange_44 * carried_wrist_pitch_a_x;
        const six_link_real t687 = Lambda_i_flange_15 * carried_wrist_pitch_alpha_x
            - minus_Lambda_i_flange_25 * carried_flange_alpha_y;
        const six_link_real t688 = t687 + Lambda_i_flange_35 * carried_flange_alpha_z
            + Lambda_i_flange_55 * carried_flange_a_y + Lambda_i_flange_56 * carried_flange_a_z;
        const six_link_real t689 = Lambda_i_flange_16 * carried_wrist_pitch_alpha_x
            + Lambda_i_flange_26 * carried_flange_alpha_y + Lambda_i_flange_36 * carried_flange_alpha_z;
        const six_link_real wrench_flange_tau_x = t681 + Lambda_i_flange_15 * carried_flange_a_y
            + Lambda_i_flange_16 * carried_flange_a_z + p_i_flange_tau_x;
        output->wrench[5][0] = wrench_flange_tau_x;
        const six_link_real wrench_flange_tau_y = t683 + Lambda_i_flange_26 * carried_flange_a_z + p_i_flange_tau_y;
        output->wrench[5][1] = wrench_flange_tau_y;
        const six_link_real wrench_flange_tau_z = t685 + Lambda_i_flange_36 * carried_flange_a_z + p_i_flange_tau_z;
        output->wrench[5][2] = wrench_flange_tau_z;
        const six_link_real wrench_flange_f_x = t686 + h_loaded_flange_f_x;
        output->wrench[5][3] = wrench_flange_f_x;
        const six_link_real wrench_flange_f_y = t688 + p_i_flange_f_y;
        output->wrench[5][4] = wrench_flange_f_y;
        const six_link_real wrench_flange_f_z = t689 + Lambda_i_flange_56 * carried_flange_a_y
            + Lambda_i_flange_66 * carried_flange_a_z + p_i_flange_f_z;
        output->wrench[5][5] = wrench_flange_f_z;

        if (wanted & SIX_LINK_MOTION) {
            /* upper_arm, link: what is added to the acceleration of F_i, modal accelerations (83) */
            const six_link_real alpha_upper_arm_a_x = a_J_upper_arm_x - minus_carried_upper_arm_a_x;
            work->motion[1][2] = alpha_upper_arm_a_x;

            const six_link_real t690 = S_upper_arm_z * qddot_upper_arm_1 - S_upper_arm_y * carried_upper_arm_alpha_z
                - c->links[1].mu * minus_carried_upper_arm_a_x;
            const six_link_real motion_upper_arm_4 = t690 + h_V_upper_arm_f_x;
            work->motion[1][3] = motion_upper_arm_4;

            /* forearm, link: what is added to the acceleration of F_i, modal accelerations (83) */
            const six_link_real alpha_forearm_a_x = carried_forearm_a_x + a_J_forearm_x;
            work->motion[2][2] = alpha_forearm_a_x;

            const six_link_real t691 = S_forearm_z * delta_forearm_alpha_y - S_forearm_y * carried_forearm_alpha_z
                + c->links[2].m * carried_forearm_a_x;
            const six_link_real motion_forearm_4 = t691 + h_V_forearm_f_x;
            work->motion[2][3] = motion_forearm_4;

            /* outputs */
            work->motion[0][0] = 0;
            work->motion[0][1] = 0;
            work->motion[0][2] = 0;
            work->motion[0][3] = 0;
            work->motion[1][0] = state->v[1];
            work->motion[1][1] = omega_R_upper_arm_z;
            work->motion[2][0] = omega_forearm_y;
            work->motion[2][1] = omega_R_forearm_z;
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
        const six_link_real r_tip_shoulder_y = c->links[0].mount_xyz_y + R_rel_shoulder_yx * c->links[0].length;

        /* upper_arm, pose: rotation and position of F_i in the inertial frame (Ad) */
        const six_link_real R_upper_arm_xx = R_rel_shoulder_xx * R_rel_upper_arm_xx;
        const six_link_real R_upper_arm_xz = R_rel_shoulder_xx * R_rel_upper_arm_xz;
        const six_link_real R_upper_arm_yx = R_rel_shoulder_yx * R_rel_upper_arm_xx;
        const six_link_real R_upper_arm_yz = R_rel_shoulder_yx * R_rel_upper_arm_xz;
        const six_link_real r_upper_arm_x = r_tip_shoulder_x
            + (R_rel_shoulder_xx * c->links[1].mount_xyz_x - R_rel_shoulder_yx * c->links[1].mount_xyz_y);
        const six_link_real r_upper_arm_y = r_tip_shoulder_y
            + (R_rel_shoulder_yx * c->links[1].mount_xyz_x + R_rel_shoulder_xx * c->links[1].mount_xyz_y);
        const six_link_real r_upper_arm_z = c->links[0].mount_xyz_z + c->links[1].mount_xyz_z;

        /* upper_arm, pose: rotation and position of the tip section in the inertial frame (Ad) */
        const six_link_real R_tip_upper_arm_xx = R_upper_arm_xx * R_T_upper_arm_xx
            - R_rel_shoulder_yx * R_T_upper_arm_yx + R_upper_arm_xz * R_T_upper_arm_zx;
        const six_link_real R_tip_upper_arm_xy = R_upper_arm_xx * R_T_upper_arm_xy
            - R_rel_shoulder_yx * R_T_upper_arm_yy + R_upper_arm_xz * R_T_upper_arm_zy;
        const six_link_real R_tip_upper_arm_xz = R_upper_arm_xx * R_T_upper_arm_xz
            - R_rel_shoulder_yx * R_T_upper_arm_yz + R_upper_arm_xz * R_T_upper_arm_zz;
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
        const six_link_real t692 = R_upper_arm_xx * c->links[1].length - R_rel_shoulder_yx * r_T_upper_arm_y
            + R_upper_arm_xz * r_T_upper_arm_z;
        const six_link_real t693 = R_upper_arm_yx * c->links[1].length + R_rel_shoulder_xx * r_T_upper_arm_y
            + R_upper_arm_yz * r_T_upper_arm_z;
        const six_link_real r_tip_upper_arm_x = r_upper_arm_x + t692;
        const six_link_real r_tip_upper_arm_y = r_upper_arm_y + t693;
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
        const six_link_real t694 = R_tip_upper_arm_xx * c->links[2].mount_xyz_x
            + R_tip_upper_arm_xy * c->links[2].mount_xyz_y + R_tip_upper_arm_xz * c->links[2].mount_xyz_z;
        const six_link_real t695 = R_tip_upper_arm_yx * c->links[2].mount_xyz_x
            + R_tip_upper_arm_yy * c->links[2].mount_xyz_y + R_tip_upper_arm_yz * c->links[2].mount_xyz_z;
        const six_link_real t696 = R_tip_upper_arm_zx * c->links[2].mount_xyz_x
            + R_tip_upper_arm_zy * c->links[2].mount_xyz_y + R_tip_upper_arm_zz * c->links[2].mount_xyz_z;
        const six_link_real r_forearm_x = r_tip_upper_arm_x + t694;
        const six_link_real r_forearm_y = r_tip_upper_arm_y + t695;
        const six_link_real r_forearm_z = r_tip_upper_arm_z + t696;

        /* forearm, pose: rotation and position of the tip section in the inertial frame (Ad) */
        const six_link_real R_tip_forearm_xx = R_forearm_xx * R_T_forearm_xx + R_forearm_xy * R_T_forearm_yx
            - R_forearm_xz * R_T_forearm_xz;
        const six_link_real R_tip_forearm_xy = R_forearm_xy * R_T_forearm_yy - R_forearm_xx * R_T_forearm_yx
            + R_forearm_xz * R_T_forearm_yz;
        const six_link_real R_tip_forearm_xz = R_forearm_xx * R_T_forearm_xz + R_forearm_xy * R_T_forearm_yz
            + R_forearm_xz * R_T_forearm_zz;
        const six_link_real R_tip_forearm_yx = R_forearm_yx * R_T_forearm_xx + R_forearm_yy * R_T_forearm_yx
            - R_forearm_yz * R_T_forearm_xz;
        const six_link_real R_tip_forearm_yy = R_forearm_yy * R_T_forearm_yy - R_forearm_yx * R_T_forearm_yx
            + R_forearm_yz * R_T_forearm_yz;
        const six_link_real R_tip_forearm_yz = R_forearm_yx * R_T_forearm_xz + R_forearm_yy * R_T_forearm_yz
            + R_forearm_yz * R_T_forearm_zz;
        const six_link_real R_tip_forearm_zx = R_forearm_zx * R_T_forearm_xx + R_forearm_zy * R_T_forearm_yx
            - R_forearm_zz * R_T_forearm_xz;
        const six_link_real R_tip_forearm_zy = R_forearm_zy * R_T_forearm_yy - R_forearm_zx * R_T_forearm_yx
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
            + R_tip_forearm_xz * R_rel_wrist_roll_zy;
        const six_link_real R_wrist_roll_xz = R_tip_forearm_xz * R_rel_wrist_roll_yy
            - R_tip_forearm_xy * R_rel_wrist_roll_zy;
        const six_link_real R_wrist_roll_yy = R_tip_forearm_yy * R_rel_wrist_roll_yy
            + R_tip_forearm_yz * R_rel_wrist_roll_zy;
        const six_link_real R_wrist_roll_yz = R_tip_forearm_yz * R_rel_wrist_roll_yy
            - R_tip_forearm_yy * R_rel_wrist_roll_zy;
        const six_link_real R_wrist_roll_zy = R_tip_forearm_zy * R_rel_wrist_roll_yy
            + R_tip_forearm_zz * R_rel_wrist_roll_zy;
        const six_link_real R_wrist_roll_zz = R_tip_forearm_zz * R_rel_wrist_roll_yy
            - R_tip_forearm_zy * R_rel_wrist_roll_zy;

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
        const six_link_real R_flange_xy = R_wrist_roll_xy * R_rel_flange_yy + R_wrist_pitch_xz * R_rel_flange_zy;
        output->tip_rotation[0][1] = R_flange_xy;
        const six_link_real R_flange_xz = R_wrist_pitch_xz * R_rel_flange_yy - R_wrist_roll_xy * R_rel_flange_zy;
        output->tip_rotation[0][2] = R_flange_xz;
        const six_link_real R_flange_yy = R_wrist_roll_yy * R_rel_flange_yy + R_wrist_pitch_yz * R_rel_flange_zy;
        output->tip_rotation[1][1] = R_flange_yy;
        const six_link_real R_flange_yz = R_wrist_pitch_yz * R_rel_flange_yy - R_wrist_roll_yy * R_rel_flange_zy;
        output->tip_rotation[1][2] = R_flange_yz;
        const six_link_real R_flange_zy = R_wrist_roll_zy * R_rel_flange_yy + R_wrist_pitch_zz * R_rel_flange_zy;
        output->tip_rotation[2][1] = R_flange_zy;
        const six_link_real R_flange_zz = R_wrist_pitch_zz * R_rel_flange_yy - R_wrist_roll_zy * R_rel_flange_zy;
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

const six_link_real six_link_measure_bounds[SIX_LINK_NMEASURES] = { SIX_LINK_REAL(0.1), SIX_LINK_REAL(0.35),
    SIX_LINK_REAL(0.02), SIX_LINK_REAL(0.2) };

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
    call.eta = state->q + (SIX_LINK_NQ - SIX_LINK_NMODES);
    call.wrench = &output->wrench[0][0];
    call.motion = &work->motion[0][0];
    call.new_measures = &measures->value[0][0];
    status = six_link_measuring(c, &call, 0, &fault);
    return six_link_finite(call.new_measures, SIX_LINK_NMEASURES * SIX_LINK_NLINKS) ? status : SIX_LINK_NONFINITE;
}

six_link_status six_link_inverse_dynamics(const six_link_constants *c, const six_link_state *state,
    const six_link_input *input,
    const six_link_real vdot[], six_link_chain *chain, six_link_real force[], six_link_real wrench[][6])
{
    six_link_real f_eta[SIX_LINK_LENGTH(SIX_LINK_NGIVEN)];
    six_link_call call;
    six_link_status status;
    int k, fault = 0;
    if (!c || !state || !input || !vdot || !chain || !force) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    for (k = 0; k < SIX_LINK_NGIVEN; ++k) {
        f_eta[k] = c->K[k] * state->q[SIX_LINK_NQ - SIX_LINK_NGIVEN + k]
            + c->D[k] * state->v[SIX_LINK_NV - SIX_LINK_NGIVEN + k];
    }
    call = call_at(c, state, c->M_eta, f_eta);
    call.w_ext = &input->w_ext[0][0];
    call.qddot = vdot;
    call.etaddot = vdot + (SIX_LINK_NV - SIX_LINK_NMODES);
    call.new_force = force;
    call.new_force_eta = force + (SIX_LINK_NV - SIX_LINK_NMODES);
    call.new_wrench = wrench ? &wrench[0][0] : 0;
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
    six_link_call call;
    six_link_status status;
    int j, fault = 0;
    if (!c || !state || !chain || !M) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    call = call_at(c, state, c->M_eta, unit);
    call.qddot = unit;
    call.etaddot = unit + (SIX_LINK_NV - SIX_LINK_NMODES);
    if (!six_link_finite(state->q, SIX_LINK_NQ)) {
        return SIX_LINK_NONFINITE;
    }
    status = six_link_inertia_posture(c, &call, chain, &fault);
    for (j = 0; j < SIX_LINK_NV && status == SIX_LINK_OK; ++j) {
        unit[j] = 1;
        call.new_force = M[j];
        call.new_force_eta = M[j] + (SIX_LINK_NV - SIX_LINK_NMODES);
        status = six_link_inertia_column(c, &call, chain, &fault);
        unit[j] = 0;
        if (!six_link_finite(M[j], SIX_LINK_NV)) {
            status = SIX_LINK_NONFINITE;
        }
    }
    return status;
}
