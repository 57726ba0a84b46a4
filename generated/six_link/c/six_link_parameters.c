/* six_link_parameters.c: the robot file's values, and the constants that depend on them. */
#include <string.h>

#include "six_link_real.h"

void six_link_parameters_default(six_link_parameters *p)
{
    memset(p, 0, sizeof *p);
    p->gravity[0] = 0;
    p->gravity[1] = 0;
    p->gravity[2] = SIX_LINK_REAL(-9.81);
    p->links[0].length = SIX_LINK_REAL(0.16);
    p->links[0].rhoA = 22;
    p->links[0].rhoIp = SIX_LINK_REAL(0.11);
    p->links[0].joint.mount_xyz[0] = 0;
    p->links[0].joint.mount_xyz[1] = 0;
    p->links[0].joint.mount_xyz[2] = SIX_LINK_REAL(0.45);
    p->links[0].joint.armature[0] = SIX_LINK_REAL(1.6);
    p->links[0].joint.damping[0] = 14;
    p->links[0].bodies[0].mass = SIX_LINK_REAL(12.5);
    p->links[0].bodies[0].com[0] = 0;
    p->links[0].bodies[0].com[1] = SIX_LINK_REAL(-0.06);
    p->links[0].bodies[0].com[2] = 0;
    p->links[0].bodies[0].inertia[0] = SIX_LINK_REAL(0.075);
    p->links[0].bodies[0].inertia[1] = SIX_LINK_REAL(0.051);
    p->links[0].bodies[0].inertia[2] = SIX_LINK_REAL(0.075);
    p->links[0].bodies[0].inertia[3] = 0;
    p->links[0].bodies[0].inertia[4] = 0;
    p->links[0].bodies[0].inertia[5] = 0;
    p->links[1].length = SIX_LINK_REAL(1.2);
    p->links[1].rhoA = SIX_LINK_REAL(3.9366000000000003);
    p->links[1].EA = SIX_LINK_REAL(100602000.0);
    p->links[1].EIy = SIX_LINK_REAL(169394.99999999997);
    p->links[1].EIz = SIX_LINK_REAL(169394.99999999997);
    p->links[1].GJ = SIX_LINK_REAL(127659.99999999999);
    p->links[1].rhoIp = SIX_LINK_REAL(0.013257);
    p->links[1].damping_ratio = SIX_LINK_REAL(0.008);
    p->links[1].joint.mount_xyz[0] = 0;
    p->links[1].joint.mount_xyz[1] = SIX_LINK_REAL(0.11);
    p->links[1].joint.mount_xyz[2] = 0;
    p->links[1].joint.armature[0] = SIX_LINK_REAL(1.9);
    p->links[1].joint.damping[0] = 16;
    p->links[1].bodies[0].mass = SIX_LINK_REAL(7.8);
    p->links[1].bodies[0].com[0] = SIX_LINK_REAL(0.02);
    p->links[1].bodies[0].com[1] = SIX_LINK_REAL(-0.04);
    p->links[1].bodies[0].com[2] = 0;
    p->links[1].bodies[0].inertia[0] = SIX_LINK_REAL(0.031);
    p->links[1].bodies[0].inertia[1] = SIX_LINK_REAL(0.024);
    p->links[1].bodies[0].inertia[2] = SIX_LINK_REAL(0.031);
    p->links[1].bodies[0].inertia[3] = 0;
    p->links[1].bodies[0].inertia[4] = 0;
    p->links[1].bodies[0].inertia[5] = 0;
    p->links[2].length = 1;
    p->links[2].rhoA = SIX_LINK_REAL(1.70505);
    p->links[2].EA = SIX_LINK_REAL(43573500.0);
    p->links[2].EIy = 24495;
    p->links[2].EIz = 24495;
    p->links[2].rhoIp = SIX_LINK_REAL(0.0019169999999999999);
    p->links[2].damping_ratio = SIX_LINK_REAL(0.008);
    p->links[2].joint.mount_xyz[0] = 0;
    p->links[2].joint.mount_xyz[1] = SIX_LINK_REAL(-0.09);
    p->links[2].joint.mount_xyz[2] = 0;
    p->links[2].joint.mount_rpy[0] = 0;
    p->links[2].joint.mount_rpy[1] = SIX_LINK_REAL(1.5707963267948966);
    p->links[2].joint.mount_rpy[2] = 0;
    p->links[2].joint.armature[0] = SIX_LINK_REAL(0.85);
    p->links[2].joint.damping[0] = 8;
    p->links[2].bodies[0].mass = SIX_LINK_REAL(4.2);
    p->links[2].bodies[0].com[0] = SIX_LINK_REAL(0.05);
    p->links[2].bodies[0].com[1] = 0;
    p->links[2].bodies[0].com[2] = 0;
    p->links[2].bodies[0].inertia[0] = SIX_LINK_REAL(0.006);
    p->links[2].bodies[0].inertia[1] = SIX_LINK_REAL(0.012);
    p->links[2].bodies[0].inertia[2] = SIX_LINK_REAL(0.012);
    p->links[2].bodies[0].inertia[3] = 0;
    p->links[2].bodies[0].inertia[4] = 0;
    p->links[2].bodies[0].inertia[5] = 0;
    p->links[3].length = SIX_LINK_REAL(0.1);
    p->links[3].rhoA = 11;
    p->links[3].rhoIp = SIX_LINK_REAL(0.016);
    p->links[3].joint.armature[0] = SIX_LINK_REAL(0.12);
    p->links[3].joint.damping[0] = SIX_LINK_REAL(1.4);
    p->links[4].length = SIX_LINK_REAL(0.08);
    p->links[4].rhoA = SIX_LINK_REAL(9.5);
    p->links[4].rhoIp = SIX_LINK_REAL(0.011);
    p->links[4].joint.armature[0] = SIX_LINK_REAL(0.1);
    p->links[4].joint.damping[0] = SIX_LINK_REAL(1.2);
    p->links[5].length = SIX_LINK_REAL(0.06);
    p->links[5].rhoA = 8;
    p->links[5].rhoIp = SIX_LINK_REAL(0.008);
    p->links[5].joint.armature[0] = SIX_LINK_REAL(0.04);
    p->links[5].joint.damping[0] = SIX_LINK_REAL(0.7);
    p->links[5].bodies[0].mass = 6;
    p->links[5].bodies[0].com[0] = SIX_LINK_REAL(0.12);
    p->links[5].bodies[0].com[1] = SIX_LINK_REAL(0.01);
    p->links[5].bodies[0].com[2] = SIX_LINK_REAL(-0.015);
    p->links[5].bodies[0].inertia[0] = SIX_LINK_REAL(0.021);
    p->links[5].bodies[0].inertia[1] = SIX_LINK_REAL(0.034);
    p->links[5].bodies[0].inertia[2] = SIX_LINK_REAL(0.038);
    p->links[5].bodies[0].inertia[3] = SIX_LINK_REAL(-0.0012);
    p->links[5].bodies[0].inertia[4] = SIX_LINK_REAL(0.002);
    p->links[5].bodies[0].inertia[5] = SIX_LINK_REAL(0.0005);
}

/* links like shoulder; returns the sum of all, which is finite if they are */
static six_link_real constants_of_shoulder(const six_link_link_parameters *p, six_link_link_constants *c,
        six_link_real M_q[], six_link_real K_q[], six_link_real D_q[])
{
    /* J_T: second moment of the bodies at the tip about the tip point */
    const six_link_real t1 = p->bodies[0].inertia[1] * SIX_LINK_REAL(0.5);
    const six_link_real t2 = p->bodies[0].inertia[2] * SIX_LINK_REAL(0.5);
    const six_link_real t3 = p->bodies[0].inertia[0] * SIX_LINK_REAL(0.5);
    const six_link_real J_T_xx = t1 + t2 + p->bodies[0].com[0] * p->bodies[0].com[0] * p->bodies[0].mass - t3;
    const six_link_real J_T_xy = p->bodies[0].com[0] * p->bodies[0].com[1] * p->bodies[0].mass
        - p->bodies[0].inertia[3];
    const six_link_real J_T_xz = p->bodies[0].com[0] * p->bodies[0].com[2] * p->bodies[0].mass
        - p->bodies[0].inertia[4];
    const six_link_real J_T_yy = t3 + t2 + p->bodies[0].com[1] * p->bodies[0].com[1] * p->bodies[0].mass - t1;
    const six_link_real J_T_yz = p->bodies[0].com[1] * p->bodies[0].com[2] * p->bodies[0].mass
        - p->bodies[0].inertia[5];
    const six_link_real J_T_zz = t3 + t1 + p->bodies[0].com[2] * p->bodies[0].com[2] * p->bodies[0].mass - t2;

    /* I_T: inertia of the bodies at the tip about the tip point */
    const six_link_real I_T_xx = J_T_yy + J_T_zz;
    const six_link_real I_T_yy = J_T_xx + J_T_zz;
    const six_link_real I_T_zz = J_T_xx + J_T_yy;

    /* I_s: spin inertia of the beam */
    const six_link_real I_s = p->length * p->rhoIp;

    /* J_0: second moment, undeformed */
    const six_link_real t4 = p->length * p->length;
    const six_link_real J_0_xx = t4 * p->length * SIX_LINK_REAL(0.3333333333333333) * p->rhoA;

    /* S_0: first moment, undeformed (27) */
    const six_link_real S_0_x = t4 * SIX_LINK_REAL(0.5) * p->rhoA;

    /* S_T: first moment of the bodies at the tip about the tip point */
    const six_link_real S_T_x = p->bodies[0].com[0] * p->bodies[0].mass;
    const six_link_real S_T_y = p->bodies[0].com[1] * p->bodies[0].mass;
    const six_link_real S_T_z = p->bodies[0].com[2] * p->bodies[0].mass;

    /* mu: mass of the beam */
    const six_link_real mu = p->length * p->rhoA;

    /* outputs */
    c->I_T_xx = I_T_xx;
    c->I_T_yy = I_T_yy;
    c->I_T_zz = I_T_zz;
    c->I_s = I_s;
    c->J_0_xx = J_0_xx;
    c->J_T_xy = J_T_xy;
    c->J_T_xz = J_T_xz;
    c->J_T_yz = J_T_yz;
    c->S_0_x = S_0_x;
    c->S_T_x = S_T_x;
    c->S_T_y = S_T_y;
    c->S_T_z = S_T_z;
    c->armature_1 = p->joint.armature[0];
    c->body0_mass = p->bodies[0].mass;
    c->joint_damping_1 = p->joint.damping[0];
    c->length = p->length;
    c->mount_xyz_x = p->joint.mount_xyz[0];
    c->mount_xyz_y = p->joint.mount_xyz[1];
    c->mount_xyz_z = p->joint.mount_xyz[2];
    c->mu = mu;
    M_q[0] = p->joint.armature[0];
    K_q[0] = 0;
    D_q[0] = p->joint.damping[0];

    return (c->I_T_xx + c->I_T_yy + c->I_T_zz + c->I_s + c->J_0_xx + c->J_T_xy)
        + (c->J_T_xz + c->J_T_yz + c->S_0_x + c->S_T_x + c->S_T_y + c->S_T_z)
        + (c->armature_1 + c->body0_mass + c->joint_damping_1 + c->length + c->mount_xyz_x + c->mount_xyz_y)
        + (c->mount_xyz_z + c->mu + M_q[0] + K_q[0] + D_q[0]);
}

/* links like upper_arm; returns the sum of all, which is finite if they are */
static six_link_real constants_of_upper_arm(const six_link_link_parameters *p, six_link_link_constants *c,
    six_link_real M_eta[], six_link_real K[], six_link_real D[],
        six_link_real M_q[], six_link_real K_q[], six_link_real D_q[])
{
    /* J_T: second moment of the bodies at the tip about the tip point */
    const six_link_real t1 = p->bodies[0].inertia[1] * SIX_LINK_REAL(0.5);
    const six_link_real t2 = p->bodies[0].inertia[2] * SIX_LINK_REAL(0.5);
    const six_link_real t3 = p->bodies[0].inertia[0] * SIX_LINK_REAL(0.5);
    const six_link_real J_T_xx = t1 + t2 + p->bodies[0].com[0] * p->bodies[0].com[0] * p->bodies[0].mass - t3;
    const six_link_real J_T_xy = p->bodies[0].com[0] * p->bodies[0].com[1] * p->bodies[0].mass
        - p->bodies[0].inertia[3];
    const six_link_real J_T_xz = p->bodies[0].com[0] * p->bodies[0].com[2] * p->bodies[0].mass
        - p->bodies[0].inertia[4];
    const six_link_real J_T_yy = t3 + t2 + p->bodies[0].com[1] * p->bodies[0].com[1] * p->bodies[0].mass - t1;
    const six_link_real J_T_yz = p->bodies[0].com[1] * p->bodies[0].com[2] * p->bodies[0].mass
        - p->bodies[0].inertia[5];
    const six_link_real J_T_zz = t3 + t1 + p->bodies[0].com[2] * p->bodies[0].com[2] * p->bodies[0].mass - t2;

    /* I_T: inertia of the bodies at the tip about the tip point */
    const six_link_real I_T_xx = J_T_yy + J_T_zz;
    const six_link_real I_T_yy = J_T_xx + J_T_zz;
    const six_link_real I_T_zz = J_T_xx + J_T_yy;

    /* I_s: spin inertia of the beam */
    const six_link_real I_s = p->length * p->rhoIp;

    /* J_0: second moment, undeformed */
    const six_link_real t4 = p->length * p->length;
    const six_link_real t5 = t4 * p->length;
    const six_link_real J_0_xx = t5 * SIX_LINK_REAL(0.3333333333333333) * p->rhoA;

    /* Psi_c: turn of the tip section by each mode */
    const six_link_real Psi_c_y3 = SIX_LINK_REAL(-2.7818912044528052) / p->length;
    const six_link_real Psi_c_y4 = SIX_LINK_REAL(-21.453696215957475) / p->length;
    const six_link_real Psi_c_z1 = SIX_LINK_REAL(2.7818912044528052) / p->length;
    const six_link_real Psi_c_z2 = SIX_LINK_REAL(21.453696215957475) / p->length;

    /* S_0: first moment, undeformed (27) */
    const six_link_real S_0_x = t4 * SIX_LINK_REAL(0.5) * p->rhoA;

    /* S_T: first moment of the bodies at the tip about the tip point */
    const six_link_real S_T_x = p->bodies[0].com[0] * p->bodies[0].mass;
    const six_link_real S_T_y = p->bodies[0].com[1] * p->bodies[0].mass;
    const six_link_real S_T_z = p->bodies[0].com[2] * p->bodies[0].mass;

    /* chi: first moment of each mode shape */
    const six_link_real chi_1 = t4 * SIX_LINK_REAL(0.5677375371714452) * p->rhoA;
    const six_link_real chi_2 = -(t4 * SIX_LINK_REAL(0.08760187718594785) * p->rhoA);

    /* mu: mass of the beam */
    const six_link_real mu = p->length * p->rhoA;

    /* EI_ratio: bending stiffness, y over z */
    const six_link_real EI_ratio = p->EIz / p->EIy;

    /* EI_gap: relative difference of EIy and EIz, squared */
    const six_link_real t6 = 1 - EI_ratio;
    const six_link_real EI_gap = t6 * t6;

    /* compliance: 1/EI of the softer plane */
    const six_link_real compliance = (SIX_LINK_REAL(0.5) + EI_ratio * SIX_LINK_REAL(0.5)
        + six_link_sqrt(EI_gap) * SIX_LINK_REAL(0.5)) / p->EIz;

    /* per_acceleration: axial load by acceleration */
    const six_link_real per_acceleration = compliance * SIX_LINK_REAL(0.1275941908610559) * t5 * p->rhoA;

    /* per_force: inverse buckling load */
    const six_link_real per_force = compliance * 4 * t4 * SIX_LINK_REAL(0.10132118364233778);

    /* per_turn: rotation by the square of the turn */
    const six_link_real per_turn = compliance * (t5 * p->length) * p->rhoA;

    /* sigma_t: spin momentum of each torsion mode */
    const six_link_real sigma_t_5 = p->length * SIX_LINK_REAL(0.8660254037844386) * p->rhoIp;

    /* sigma: momentum of each mode (B1) */
    const six_link_real sigma_y1 = p->length * SIX_LINK_REAL(0.777935872096674) * p->rhoA;
    const six_link_real sigma_y2 = -(p->length * SIX_LINK_REAL(0.38054668426513355) * p->rhoA);

    /* K_full: stiffness of the modes (torsion: N*m) (88) */
    const six_link_real K_full_11 = p->EIz * SIX_LINK_REAL(12.480192153753773) / t5;
    const six_link_real K_full_22 = p->EIz * SIX_LINK_REAL(1211.5198078462463) / t5;
    const six_link_real K_full_33 = p->EIy * SIX_LINK_REAL(12.480192153753773) / t5;
    const six_link_real K_full_44 = p->EIy * SIX_LINK_REAL(1211.5198078462463) / t5;
    const six_link_real K_full_55 = p->GJ * 3 / p->length;

    /* D: damping of each mode (torsion: N*m*s/rad) */
    const six_link_real t7 = p->damping_ratio * 2;
    const six_link_real D_1 = t7 * six_link_sqrt(K_full_11 * mu);
    const six_link_real D_2 = t7 * six_link_sqrt(K_full_22 * mu);
    const six_link_real D_3 = t7 * six_link_sqrt(K_full_33 * mu);
    const six_link_real D_4 = t7 * six_link_sqrt(K_full_44 * mu);
    const six_link_real D_5 = t7 * six_link_sqrt(K_full_55 * I_s);

    /* outputs */
    c->I_T_xx = I_T_xx;
    c->I_T_yy = I_T_yy;
    c->I_T_zz = I_T_zz;
    c->I_s = I_s;
    c->J_0_xx = J_0_xx;
    c->J_T_xy = J_T_xy;
    c->J_T_xz = J_T_xz;
    c->J_T_yz = J_T_yz;
    c->Psi_c_y3 = Psi_c_y3;
    c->Psi_c_y4 = Psi_c_y4;
    c->Psi_c_z1 = Psi_c_z1;
    c->Psi_c_z2 = Psi_c_z2;
    c->S_0_x = S_0_x;
    c->S_T_x = S_T_x;
    c->S_T_y = S_T_y;
    c->S_T_z = S_T_z;
    c->armature_1 = p->joint.armature[0];
    c->body0_mass = p->bodies[0].mass;
    c->chi_1 = chi_1;
    c->chi_2 = chi_2;
    c->joint_damping_1 = p->joint.damping[0];
    c->length = p->length;
    c->mount_xyz_x = p->joint.mount_xyz[0];
    c->mount_xyz_y = p->joint.mount_xyz[1];
    c->mount_xyz_z = p->joint.mount_xyz[2];
    c->mu = mu;
    c->per_acceleration = per_acceleration;
    c->per_force = per_force;
    c->per_turn = per_turn;
    c->sigma_t_5 = sigma_t_5;
    c->sigma_y1 = sigma_y1;
    c->sigma_y2 = sigma_y2;
    M_eta[0] = mu;
    M_eta[1] = mu;
    M_eta[2] = mu;
    M_eta[3] = mu;
    M_eta[4] = I_s;
    K[0] = K_full_11;
    K[1] = K_full_22;
    K[2] = K_full_33;
    K[3] = K_full_44;
    K[4] = K_full_55;
    D[0] = D_1;
    D[1] = D_2;
    D[2] = D_3;
    D[3] = D_4;
    D[4] = D_5;
    M_q[0] = p->joint.armature[0];
    K_q[0] = 0;
    D_q[0] = p->joint.damping[0];

    return (c->I_T_xx + c->I_T_yy + c->I_T_zz + c->I_s + c->J_0_xx + c->J_T_xy)
        + (c->J_T_xz + c->J_T_yz + c->Psi_c_y3 + c->Psi_c_y4 + c->Psi_c_z1 + c->Psi_c_z2)
        + (c->S_0_x + c->S_T_x + c->S_T_y + c->S_T_z + c->armature_1 + c->body0_mass)
        + (c->chi_1 + c->chi_2 + c->joint_damping_1 + c->length + c->mount_xyz_x + c->mount_xyz_y)
        + (c->mount_xyz_z + c->mu + c->per_acceleration + c->per_force + c->per_turn + c->sigma_t_5)
        + (c->sigma_y1 + c->sigma_y2 + M_eta[0] + M_eta[1] + M_eta[2] + M_eta[3])
        + (M_eta[4] + K[0] + K[1] + K[2] + K[3] + K[4])
        + (D[0] + D[1] + D[2] + D[3] + D[4] + M_q[0])
        + (K_q[0] + D_q[0]);
}

/* links like forearm; returns the sum of all, which is finite if they are */
static six_link_real constants_of_forearm(const six_link_link_parameters *p, six_link_link_constants *c,
    six_link_real M_eta[], six_link_real K[], six_link_real D[],
        six_link_real M_q[], six_link_real K_q[], six_link_real D_q[])
{
    /* I_s: spin inertia of the beam */
    const six_link_real I_s = p->length * p->rhoIp;

    /* J_B: second moment of the bodies at the base about the joint point */
    const six_link_real t1 = p->bodies[0].inertia[1] * SIX_LINK_REAL(0.5);
    const six_link_real t2 = p->bodies[0].inertia[2] * SIX_LINK_REAL(0.5);
    const six_link_real t3 = p->bodies[0].inertia[0] * SIX_LINK_REAL(0.5);
    const six_link_real J_B_xx = t1 + t2 + p->bodies[0].com[0] * p->bodies[0].com[0] * p->bodies[0].mass - t3;
    const six_link_real J_B_xy = p->bodies[0].com[0] * p->bodies[0].com[1] * p->bodies[0].mass
        - p->bodies[0].inertia[3];
    const six_link_real J_B_xz = p->bodies[0].com[0] * p->bodies[0].com[2] * p->bodies[0].mass
        - p->bodies[0].inertia[4];
    const six_link_real J_B_yy = t3 + t2 + p->bodies[0].com[1] * p->bodies[0].com[1] * p->bodies[0].mass - t1;
    const six_link_real J_B_yz = p->bodies[0].com[1] * p->bodies[0].com[2] * p->bodies[0].mass
        - p->bodies[0].inertia[5];
    const six_link_real J_B_zz = t3 + t1 + p->bodies[0].com[2] * p->bodies[0].com[2] * p->bodies[0].mass - t2;

    /* J_0: second moment, undeformed */
    const six_link_real t4 = p->length * p->length;
    const six_link_real t5 = t4 * p->length;
    const six_link_real J_0_xx = J_B_xx + t5 * SIX_LINK_REAL(0.3333333333333333) * p->rhoA;

    /* Psi_c: turn of the tip section by each mode */
    const six_link_real Psi_c_y3 = SIX_LINK_REAL(-2.7818912044528052) / p->length;
    const six_link_real Psi_c_y4 = SIX_LINK_REAL(-21.453696215957475) / p->length;
    const six_link_real Psi_c_z1 = SIX_LINK_REAL(2.7818912044528052) / p->length;
    const six_link_real Psi_c_z2 = SIX_LINK_REAL(21.453696215957475) / p->length;

    /* R_m: rotation of the mount */
    const six_link_sincos turn = six_link_sine_cosine(p->joint.mount_rpy[1]);
    const six_link_real minus_R_m_zx = turn.sine, t6 = turn.cosine;
    const six_link_sincos turn_2 = six_link_sine_cosine(p->joint.mount_rpy[2]);
    const six_link_real t7 = turn_2.sine, t8 = turn_2.cosine;
    const six_link_real R_m_xx = t6 * t8;
    const six_link_sincos turn_3 = six_link_sine_cosine(p->joint.mount_rpy[0]);
    const six_link_real t9 = turn_3.sine, t10 = turn_3.cosine;
    const six_link_real t11 = t9 * minus_R_m_zx;
    const six_link_real R_m_xy = t11 * t8 - t7 * t10;
    const six_link_real R_m_xz = t9 * t7 + minus_R_m_zx * t10 * t8;
    const six_link_real R_m_yx = t7 * t6;
    const six_link_real R_m_yy = t10 * t8 + t11 * t7;
    const six_link_real R_m_yz = minus_R_m_zx * t7 * t10 - t9 * t8;
    const six_link_real t12 = -minus_R_m_zx;
    const six_link_real R_m_zy = t9 * t6;
    const six_link_real R_m_zz = t10 * t6;

    /* S_B: first moment of the bodies at the base about the joint point */
    const six_link_real S_B_x = p->bodies[0].com[0] * p->bodies[0].mass;
    const six_link_real S_B_y = p->bodies[0].com[1] * p->bodies[0].mass;
    const six_link_real S_B_z = p->bodies[0].com[2] * p->bodies[0].mass;

    /* S_0: first moment, undeformed (27) */
    const six_link_real S_0_x = S_B_x + t4 * SIX_LINK_REAL(0.5) * p->rhoA;

    /* chi: first moment of each mode shape */
    const six_link_real chi_1 = t4 * SIX_LINK_REAL(0.5677375371714452) * p->rhoA;
    const six_link_real chi_2 = -(t4 * SIX_LINK_REAL(0.08760187718594785) * p->rhoA);

    /* mu: mass of the beam */
    const six_link_real mu = p->length * p->rhoA;

    /* m: mass, base bodies included (27) */
    const six_link_real m = p->bodies[0].mass + mu;

    /* EI_ratio: bending stiffness, y over z */
    const six_link_real EI_ratio = p->EIz / p->EIy;

    /* EI_gap: relative difference of EIy and EIz, squared */
    const six_link_real t13 = 1 - EI_ratio;
    const six_link_real EI_gap = t13 * t13;

    /* compliance: 1/EI of the softer plane */
    const six_link_real compliance = (SIX_LINK_REAL(0.5) + EI_ratio * SIX_LINK_REAL(0.5)
        + six_link_sqrt(EI_gap) * SIX_LINK_REAL(0.5)) / p->EIz;

    /* per_acceleration: axial load by acceleration */
    const six_link_real per_acceleration = compliance * SIX_LINK_REAL(0.1275941908610559) * t5 * p->rhoA;

    /* per_force: inverse buckling load */
    const six_link_real per_force = compliance * 4 * t4 * SIX_LINK_REAL(0.10132118364233778);

    /* per_turn: rotation by the square of the turn */
    const six_link_real per_turn = compliance * (t5 * p->length) * p->rhoA;

    /* sigma: momentum of each mode (B1) */
    const six_link_real sigma_y1 = p->length * SIX_LINK_REAL(0.777935872096674) * p->rhoA;
    const six_link_real sigma_y2 = -(p->length * SIX_LINK_REAL(0.38054668426513355) * p->rhoA);

    /* K_full: stiffness of the modes (torsion: N*m) (88) */
    const six_link_real K_full_11 = p->EIz * SIX_LINK_REAL(12.480192153753773) / t5;
    const six_link_real K_full_22 = p->EIz * SIX_LINK_REAL(1211.5198078462463) / t5;
    const six_link_real K_full_33 = p->EIy * SIX_LINK_REAL(12.480192153753773) / t5;
    const six_link_real K_full_44 = p->EIy * SIX_LINK_REAL(1211.5198078462463) / t5;

    /* D: damping of each mode (torsion: N*m*s/rad) */
    const six_link_real t14 = p->damping_ratio * 2;
    const six_link_real D_1 = t14 * six_link_sqrt(K_full_11 * mu);
    const six_link_real D_2 = t14 * six_link_sqrt(K_full_22 * mu);
    const six_link_real D_3 = t14 * six_link_sqrt(K_full_33 * mu);
    const six_link_real D_4 = t14 * six_link_sqrt(K_full_44 * mu);

    /* outputs */
    c->I_s = I_s;
    c->J_0_xx = J_0_xx;
    c->J_B_xy = J_B_xy;
    c->J_B_xz = J_B_xz;
    c->J_B_yy = J_B_yy;
    c->J_B_yz = J_B_yz;
    c->J_B_zz = J_B_zz;
    c->Psi_c_y3 = Psi_c_y3;
    c->Psi_c_y4 = Psi_c_y4;
    c->Psi_c_z1 = Psi_c_z1;
    c->Psi_c_z2 = Psi_c_z2;
    c->R_m_xx = R_m_xx;
    c->R_m_xy = R_m_xy;
    c->R_m_xz = R_m_xz;
    c->R_m_yx = R_m_yx;
    c->R_m_yy = R_m_yy;
    c->R_m_yz = R_m_yz;
    c->R_m_zx = t12;
    c->R_m_zy = R_m_zy;
    c->R_m_zz = R_m_zz;
    c->S_0_x = S_0_x;
    c->S_B_y = S_B_y;
    c->S_B_z = S_B_z;
    c->armature_1 = p->joint.armature[0];
    c->chi_1 = chi_1;
    c->chi_2 = chi_2;
    c->joint_damping_1 = p->joint.damping[0];
    c->length = p->length;
    c->m = m;
    c->mount_rpy_x = p->joint.mount_rpy[0];
    c->mount_rpy_y = p->joint.mount_rpy[1];
    c->mount_rpy_z = p->joint.mount_rpy[2];
    c->mount_xyz_x = p->joint.mount_xyz[0];
    c->mount_xyz_y = p->joint.mount_xyz[1];
    c->mount_xyz_z = p->joint.mount_xyz[2];
    c->mu = mu;
    c->per_acceleration = per_acceleration;
    c->per_force = per_force;
    c->per_turn = per_turn;
    c->sigma_y1 = sigma_y1;
    c->sigma_y2 = sigma_y2;
    M_eta[0] = mu;
    M_eta[1] = mu;
    M_eta[2] = mu;
    M_eta[3] = mu;
    K[0] = K_full_11;
    K[1] = K_full_22;
    K[2] = K_full_33;
    K[3] = K_full_44;
    D[0] = D_1;
    D[1] = D_2;
    D[2] = D_3;
    D[3] = D_4;
    M_q[0] = p->joint.armature[0];
    K_q[0] = 0;
    D_q[0] = p->joint.damping[0];

    return (c->I_s + c->J_0_xx + c->J_B_xy + c->J_B_xz + c->J_B_yy + c->J_B_yz)
        + (c->J_B_zz + c->Psi_c_y3 + c->Psi_c_y4 + c->Psi_c_z1 + c->Psi_c_z2 + c->R_m_xx)
        + (c->R_m_xy + c->R_m_xz + c->R_m_yx + c->R_m_yy + c->R_m_yz + c->R_m_zx)
        + (c->R_m_zy + c->R_m_zz + c->S_0_x + c->S_B_y + c->S_B_z + c->armature_1)
        + (c->chi_1 + c->chi_2 + c->joint_damping_1 + c->length + c->m + c->mount_rpy_x)
        + (c->mount_rpy_y + c->mount_rpy_z + c->mount_xyz_x + c->mount_xyz_y + c->mount_xyz_z + c->mu)
        + (c->per_acceleration + c->per_force + c->per_turn + c->sigma_y1 + c->sigma_y2 + M_eta[0])
        + (M_eta[1] + M_eta[2] + M_eta[3] + K[0] + K[1] + K[2])
        + (K[3] + D[0] + D[1] + D[2] + D[3] + M_q[0])
        + (K_q[0] + D_q[0]);
}

/* links like wrist_roll; returns the sum of all, which is finite if they are */
static six_link_real constants_of_wrist_roll(const six_link_link_parameters *p, six_link_link_constants *c,
        six_link_real M_q[], six_link_real K_q[], six_link_real D_q[])
{
    /* I_s: spin inertia of the beam */
    const six_link_real I_s = p->length * p->rhoIp;

    /* J_0: second moment, undeformed */
    const six_link_real t1 = p->length * p->length;
    const six_link_real J_0_xx = t1 * p->length * SIX_LINK_REAL(0.3333333333333333) * p->rhoA;

    /* S_0: first moment, undeformed (27) */
    const six_link_real S_0_x = t1 * SIX_LINK_REAL(0.5) * p->rhoA;

    /* mu: mass of the beam */
    const six_link_real mu = p->length * p->rhoA;

    /* outputs */
    c->I_s = I_s;
    c->J_0_xx = J_0_xx;
    c->S_0_x = S_0_x;
    c->armature_1 = p->joint.armature[0];
    c->joint_damping_1 = p->joint.damping[0];
    c->length = p->length;
    c->mu = mu;
    M_q[0] = p->joint.armature[0];
    K_q[0] = 0;
    D_q[0] = p->joint.damping[0];

    return (c->I_s + c->J_0_xx + c->S_0_x + c->armature_1 + c->joint_damping_1 + c->length)
        + (c->mu + M_q[0] + K_q[0] + D_q[0]);
}

/* links like wrist_pitch; returns the sum of all, which is finite if they are */
static six_link_real constants_of_wrist_pitch(const six_link_link_parameters *p, six_link_link_constants *c,
        six_link_real M_q[], six_link_real K_q[], six_link_real D_q[])
{
    /* I_s: spin inertia of the beam */
    const six_link_real I_s = p->length * p->rhoIp;

    /* J_0: second moment, undeformed */
    const six_link_real t1 = p->length * p->length;
    const six_link_real J_0_xx = t1 * p->length * SIX_LINK_REAL(0.3333333333333333) * p->rhoA;

    /* S_0: first moment, undeformed (27) */
    const six_link_real S_0_x = t1 * SIX_LINK_REAL(0.5) * p->rhoA;

    /* mu: mass of the beam */
    const six_link_real mu = p->length * p->rhoA;

    /* outputs */
    c->I_s = I_s;
    c->J_0_xx = J_0_xx;
    c->S_0_x = S_0_x;
    c->armature_1 = p->joint.armature[0];
    c->joint_damping_1 = p->joint.damping[0];
    c->length = p->length;
    c->mu = mu;
    M_q[0] = p->joint.armature[0];
    K_q[0] = 0;
    D_q[0] = p->joint.damping[0];

    return (c->I_s + c->J_0_xx + c->S_0_x + c->armature_1 + c->joint_damping_1 + c->length)
        + (c->mu + M_q[0] + K_q[0] + D_q[0]);
}

/* links like flange; returns the sum of all, which is finite if they are */
static six_link_real constants_of_flange(const six_link_link_parameters *p, six_link_link_constants *c,
        six_link_real M_q[], six_link_real K_q[], six_link_real D_q[])
{
    /* J_T: second moment of the bodies at the tip about the tip point */
    const six_link_real t1 = p->bodies[0].inertia[1] * SIX_LINK_REAL(0.5);
    const six_link_real t2 = p->bodies[0].inertia[2] * SIX_LINK_REAL(0.5);
    const six_link_real t3 = p->bodies[0].inertia[0] * SIX_LINK_REAL(0.5);
    const six_link_real J_T_xx = t1 + t2 + p->bodies[0].com[0] * p->bodies[0].com[0] * p->bodies[0].mass - t3;
    const six_link_real J_T_xy = p->bodies[0].com[0] * p->bodies[0].com[1] * p->bodies[0].mass
        - p->bodies[0].inertia[3];
    const six_link_real J_T_xz = p->bodies[0].com[0] * p->bodies[0].com[2] * p->bodies[0].mass
        - p->bodies[0].inertia[4];
    const six_link_real J_T_yy = t3 + t2 + p->bodies[0].com[1] * p->bodies[0].com[1] * p->bodies[0].mass - t1;
    const six_link_real J_T_yz = p->bodies[0].com[1] * p->bodies[0].com[2] * p->bodies[0].mass
        - p->bodies[0].inertia[5];
    const six_link_real J_T_zz = t3 + t1 + p->bodies[0].com[2] * p->bodies[0].com[2] * p->bodies[0].mass - t2;

    /* I_T: inertia of the bodies at the tip about the tip point */
    const six_link_real I_T_xx = J_T_yy + J_T_zz;
    const six_link_real I_T_yy = J_T_xx + J_T_zz;
    const six_link_real I_T_zz = J_T_xx + J_T_yy;

    /* I_s: spin inertia of the beam */
    const six_link_real I_s = p->length * p->rhoIp;

    /* J_0: second moment, undeformed */
    const six_link_real t4 = p->length * p->length;
    const six_link_real J_0_xx = t4 * p->length * SIX_LINK_REAL(0.3333333333333333) * p->rhoA;

    /* S_0: first moment, undeformed (27) */
    const six_link_real S_0_x = t4 * SIX_LINK_REAL(0.5) * p->rhoA;

    /* S_T: first moment of the bodies at the tip about the tip point */
    const six_link_real S_T_x = p->bodies[0].com[0] * p->bodies[0].mass;
    const six_link_real S_T_y = p->bodies[0].com[1] * p->bodies[0].mass;
    const six_link_real S_T_z = p->bodies[0].com[2] * p->bodies[0].mass;

    /* mu: mass of the beam */
    const six_link_real mu = p->length * p->rhoA;

    /* outputs */
    c->I_T_xx = I_T_xx;
    c->I_T_yy = I_T_yy;
    c->I_T_zz = I_T_zz;
    c->I_s = I_s;
    c->J_0_xx = J_0_xx;
    c->J_T_xy = J_T_xy;
    c->J_T_xz = J_T_xz;
    c->J_T_yz = J_T_yz;
    c->S_0_x = S_0_x;
    c->S_T_x = S_T_x;
    c->S_T_y = S_T_y;
    c->S_T_z = S_T_z;
    c->armature_1 = p->joint.armature[0];
    c->body0_mass = p->bodies[0].mass;
    c->joint_damping_1 = p->joint.damping[0];
    c->length = p->length;
    c->mu = mu;
    M_q[0] = p->joint.armature[0];
    K_q[0] = 0;
    D_q[0] = p->joint.damping[0];

    return (c->I_T_xx + c->I_T_yy + c->I_T_zz + c->I_s + c->J_0_xx + c->J_T_xy)
        + (c->J_T_xz + c->J_T_yz + c->S_0_x + c->S_T_x + c->S_T_y + c->S_T_z)
        + (c->armature_1 + c->body0_mass + c->joint_damping_1 + c->length + c->mu + M_q[0])
        + (K_q[0] + D_q[0]);
}

six_link_status six_link_prepare(const six_link_parameters *p, six_link_constants *c)
{
    six_link_real sum = 0;
    int i, k;
    if (!p || !c) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    if (!six_link_finite((const six_link_real *)p, (int)(sizeof *p / sizeof(six_link_real)))) {
        return SIX_LINK_NONFINITE;
    }
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        const six_link_link_parameters *link = &p->links[i];
        if (!(link->length > 0) || !(link->rhoA > 0) || link->rhoIp < 0) {
            return SIX_LINK_BAD_ARGUMENT;
        }
        for (k = 0; k < 1; ++k) {
            if (link->bodies[k].mass < 0) {
                return SIX_LINK_BAD_ARGUMENT;
            }
        }
    }
    for (i = 0; i < 3; ++i) {
        c->gravity[i] = p->gravity[i];
    }
    for (k = 0; k < SIX_LINK_NTAU; ++k) {
        c->M_eta[k] = 0;
        c->K[k] = 0;
        c->D[k] = 0;
    }
    sum += constants_of_shoulder(&p->links[0], &c->links[0],
        c->M_eta + 0, c->K + 0, c->D + 0);
    sum += constants_of_upper_arm(&p->links[1], &c->links[1], c->M_eta + 6, c->K + 6, c->D + 6,
        c->M_eta + 1, c->K + 1, c->D + 1);
    sum += constants_of_forearm(&p->links[2], &c->links[2], c->M_eta + 11, c->K + 11, c->D + 11,
        c->M_eta + 2, c->K + 2, c->D + 2);
    sum += constants_of_wrist_roll(&p->links[3], &c->links[3],
        c->M_eta + 3, c->K + 3, c->D + 3);
    sum += constants_of_wrist_pitch(&p->links[4], &c->links[4],
        c->M_eta + 4, c->K + 4, c->D + 4);
    sum += constants_of_flange(&p->links[5], &c->links[5],
        c->M_eta + 5, c->K + 5, c->D + 5);
    for (k = SIX_LINK_NGIVEN - SIX_LINK_NMODES; k < SIX_LINK_NGIVEN; ++k) {
        if (!(c->M_eta[k] > 0) || !(c->K[k] > 0) || !(c->D[k] >= 0)) {
            return SIX_LINK_BAD_ARGUMENT;
        }
    }
    if (!six_link_finite(&sum, 1)) {
        return SIX_LINK_NONFINITE;
    }
    return SIX_LINK_OK;
}
