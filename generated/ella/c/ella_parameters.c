/* ella_parameters.c: the robot file's values, and the constants that depend on them. */
#include <string.h>

#include "ella_real.h"

void ella_parameters_default(ella_parameters *p)
{
    memset(p, 0, sizeof *p);
    p->gravity[0] = 0;
    p->gravity[1] = 0;
    p->gravity[2] = ELLA_REAL(-9.81);
    p->links[0].length = ELLA_REAL(0.95);
    p->links[0].rhoA = ELLA_REAL(1.6302);
    p->links[0].EIy = 2120;
    p->links[0].EIz = 3670;
    p->links[0].GJ = 1650;
    p->links[0].rhoIp = ELLA_REAL(0.000215);
    p->links[0].bodies[0].mass = ELLA_REAL(3.3);
    p->links[1].length = ELLA_REAL(0.93);
    p->links[1].rhoA = ELLA_REAL(1.6302);
    p->links[1].EA = ELLA_REAL(43890000.0);
    p->links[1].EIy = ELLA_REAL(2119.9500000000003);
    p->links[1].EIz = ELLA_REAL(3669.96);
    p->links[1].GJ = ELLA_REAL(1647.708);
    p->links[1].rhoIp = ELLA_REAL(0.00021505380000000002);
    p->links[1].bodies[0].mass = ELLA_REAL(2.1);
}

/* links like upper_arm; returns the sum of all, which is finite if they are */
static ella_real constants_of_upper_arm(const ella_link_parameters *p, ella_link_constants *c, ella_real M_eta[],
    ella_real K[], ella_real D[])
{
    /* I_s: spin inertia of the beam */
    const ella_real I_s = p->length * p->rhoIp;

    /* J_0: second moment, undeformed */
    const ella_real t1 = p->length * p->length;
    const ella_real t2 = t1 * p->length;
    const ella_real J_0_xx = t2 * ELLA_REAL(0.3333333333333333) * p->rhoA;

    /* Psi_c: turn of the tip section by each mode */
    const ella_real Psi_c_y4 = ELLA_REAL(-2.754638950054297) / p->length;
    const ella_real Psi_c_y5 = ELLA_REAL(-9.829048135266044) / p->length;
    const ella_real Psi_c_y6 = ELLA_REAL(-51.65076743872705) / p->length;
    const ella_real Psi_c_z1 = ELLA_REAL(2.754638950054297) / p->length;
    const ella_real Psi_c_z2 = ELLA_REAL(9.829048135266044) / p->length;
    const ella_real Psi_c_z3 = ELLA_REAL(51.65076743872705) / p->length;

    /* S_0: first moment, undeformed (27) */
    const ella_real S_0_x = t1 * ELLA_REAL(0.5) * p->rhoA;

    /* chi: first moment of each mode shape */
    const ella_real chi_1 = t1 * ELLA_REAL(0.5688984735013527) * p->rhoA;
    const ella_real chi_2 = -(t1 * ELLA_REAL(0.0900071035382269) * p->rhoA);
    const ella_real chi_3 = t1 * ELLA_REAL(0.027445366831025438) * p->rhoA;

    /* mu: mass of the beam */
    const ella_real mu = p->length * p->rhoA;

    /* EI_ratio: bending stiffness, y over z */
    const ella_real EI_ratio = p->EIz / p->EIy;

    /* EI_gap: relative difference of EIy and EIz, squared */
    const ella_real t3 = 1 - EI_ratio;
    const ella_real EI_gap = t3 * t3;

    /* compliance: 1/EI of the softer plane */
    const ella_real compliance = (ELLA_REAL(0.5) + EI_ratio * ELLA_REAL(0.5)
        + ella_sqrt(EI_gap) * ELLA_REAL(0.5)) / p->EIz;

    /* per_acceleration: axial load by acceleration */
    const ella_real per_acceleration = compliance * ELLA_REAL(0.1275941908610559) * t2 * p->rhoA;

    /* per_force: inverse buckling load */
    const ella_real per_force = compliance * 4 * t1 * ELLA_REAL(0.10132118364233778);

    /* per_turn: rotation by the square of the turn */
    const ella_real per_turn = compliance * (t2 * p->length) * p->rhoA;

    /* sigma_t: spin momentum of each torsion mode */
    const ella_real sigma_t_7 = p->length * ELLA_REAL(0.8660254037844386) * p->rhoIp;

    /* sigma: momentum of each mode (B1) */
    const ella_real sigma_y1 = p->length * ELLA_REAL(0.7834687621100629) * p->rhoA;
    const ella_real sigma_y2 = -(p->length * ELLA_REAL(0.4302128963930683) * p->rhoA);
    const ella_real sigma_y3 = p->length * ELLA_REAL(0.2027154719670228) * p->rhoA;

    /* K_full: stiffness of the modes (torsion: N*m) (88) */
    const ella_real K_full_11 = p->EIz * ELLA_REAL(12.36982403868891) / t2;
    const ella_real K_full_22 = p->EIz * ELLA_REAL(494.322388600536) / t2;
    const ella_real K_full_33 = p->EIz * ELLA_REAL(13958.107787360776) / t2;
    const ella_real K_full_44 = p->EIy * ELLA_REAL(12.36982403868891) / t2;
    const ella_real K_full_55 = p->EIy * ELLA_REAL(494.322388600536) / t2;
    const ella_real K_full_66 = p->EIy * ELLA_REAL(13958.107787360776) / t2;
    const ella_real K_full_77 = p->GJ * 3 / p->length;

    /* outputs */
    c->I_s = I_s;
    c->J_0_xx = J_0_xx;
    c->Psi_c_y4 = Psi_c_y4;
    c->Psi_c_y5 = Psi_c_y5;
    c->Psi_c_y6 = Psi_c_y6;
    c->Psi_c_z1 = Psi_c_z1;
    c->Psi_c_z2 = Psi_c_z2;
    c->Psi_c_z3 = Psi_c_z3;
    c->S_0_x = S_0_x;
    c->body0_mass = p->bodies[0].mass;
    c->chi_1 = chi_1;
    c->chi_2 = chi_2;
    c->chi_3 = chi_3;
    c->length = p->length;
    c->mu = mu;
    c->per_acceleration = per_acceleration;
    c->per_force = per_force;
    c->per_turn = per_turn;
    c->sigma_t_7 = sigma_t_7;
    c->sigma_y1 = sigma_y1;
    c->sigma_y2 = sigma_y2;
    c->sigma_y3 = sigma_y3;
    M_eta[0] = mu;
    M_eta[1] = mu;
    M_eta[2] = mu;
    M_eta[3] = mu;
    M_eta[4] = mu;
    M_eta[5] = mu;
    M_eta[6] = I_s;
    K[0] = K_full_11;
    K[1] = K_full_22;
    K[2] = K_full_33;
    K[3] = K_full_44;
    K[4] = K_full_55;
    K[5] = K_full_66;
    K[6] = K_full_77;
    D[0] = 0;
    D[1] = 0;
    D[2] = 0;
    D[3] = 0;
    D[4] = 0;
    D[5] = 0;
    D[6] = 0;

    return (c->I_s + c->J_0_xx + c->Psi_c_y4 + c->Psi_c_y5 + c->Psi_c_y6 + c->Psi_c_z1)
        + (c->Psi_c_z2 + c->Psi_c_z3 + c->S_0_x + c->body0_mass + c->chi_1 + c->chi_2)
        + (c->chi_3 + c->length + c->mu + c->per_acceleration + c->per_force + c->per_turn)
        + (c->sigma_t_7 + c->sigma_y1 + c->sigma_y2 + c->sigma_y3 + M_eta[0] + M_eta[1])
        + (M_eta[2] + M_eta[3] + M_eta[4] + M_eta[5] + M_eta[6] + K[0])
        + (K[1] + K[2] + K[3] + K[4] + K[5] + K[6])
        + (D[0] + D[1] + D[2] + D[3] + D[4] + D[5])
        + (D[6]);
}

/* links like forearm; returns the sum of all, which is finite if they are */
static ella_real constants_of_forearm(const ella_link_parameters *p, ella_link_constants *c, ella_real M_eta[],
    ella_real K[], ella_real D[])
{
    /* I_s: spin inertia of the beam */
    const ella_real I_s = p->length * p->rhoIp;

    /* J_0: second moment, undeformed */
    const ella_real t1 = p->length * p->length;
    const ella_real t2 = t1 * p->length;
    const ella_real J_0_xx = t2 * ELLA_REAL(0.3333333333333333) * p->rhoA;

    /* Psi_c: turn of the tip section by each mode */
    const ella_real Psi_c_y4 = ELLA_REAL(-2.754638950054297) / p->length;
    const ella_real Psi_c_y5 = ELLA_REAL(-9.829048135266044) / p->length;
    const ella_real Psi_c_y6 = ELLA_REAL(-51.65076743872705) / p->length;
    const ella_real Psi_c_z1 = ELLA_REAL(2.754638950054297) / p->length;
    const ella_real Psi_c_z2 = ELLA_REAL(9.829048135266044) / p->length;
    const ella_real Psi_c_z3 = ELLA_REAL(51.65076743872705) / p->length;

    /* S_0: first moment, undeformed (27) */
    const ella_real S_0_x = t1 * ELLA_REAL(0.5) * p->rhoA;

    /* chi: first moment of each mode shape */
    const ella_real chi_1 = t1 * ELLA_REAL(0.5688984735013527) * p->rhoA;
    const ella_real chi_2 = -(t1 * ELLA_REAL(0.0900071035382269) * p->rhoA);
    const ella_real chi_3 = t1 * ELLA_REAL(0.027445366831025438) * p->rhoA;

    /* mu: mass of the beam */
    const ella_real mu = p->length * p->rhoA;

    /* EI_ratio: bending stiffness, y over z */
    const ella_real EI_ratio = p->EIz / p->EIy;

    /* EI_gap: relative difference of EIy and EIz, squared */
    const ella_real t3 = 1 - EI_ratio;
    const ella_real EI_gap = t3 * t3;

    /* compliance: 1/EI of the softer plane */
    const ella_real compliance = (ELLA_REAL(0.5) + EI_ratio * ELLA_REAL(0.5)
        + ella_sqrt(EI_gap) * ELLA_REAL(0.5)) / p->EIz;

    /* per_acceleration: axial load by acceleration */
    const ella_real per_acceleration = compliance * ELLA_REAL(0.1275941908610559) * t2 * p->rhoA;

    /* per_force: inverse buckling load */
    const ella_real per_force = compliance * 4 * t1 * ELLA_REAL(0.10132118364233778);

    /* per_turn: rotation by the square of the turn */
    const ella_real per_turn = compliance * (t2 * p->length) * p->rhoA;

    /* sigma_t: spin momentum of each torsion mode */
    const ella_real sigma_t_7 = p->length * ELLA_REAL(0.8660254037844386) * p->rhoIp;

    /* sigma: momentum of each mode (B1) */
    const ella_real sigma_y1 = p->length * ELLA_REAL(0.7834687621100629) * p->rhoA;
    const ella_real sigma_y2 = -(p->length * ELLA_REAL(0.4302128963930683) * p->rhoA);
    const ella_real sigma_y3 = p->length * ELLA_REAL(0.2027154719670228) * p->rhoA;

    /* K_full: stiffness of the modes (torsion: N*m) (88) */
    const ella_real K_full_11 = p->EIz * ELLA_REAL(12.36982403868891) / t2;
    const ella_real K_full_22 = p->EIz * ELLA_REAL(494.322388600536) / t2;
    const ella_real K_full_33 = p->EIz * ELLA_REAL(13958.107787360776) / t2;
    const ella_real K_full_44 = p->EIy * ELLA_REAL(12.36982403868891) / t2;
    const ella_real K_full_55 = p->EIy * ELLA_REAL(494.322388600536) / t2;
    const ella_real K_full_66 = p->EIy * ELLA_REAL(13958.107787360776) / t2;
    const ella_real K_full_77 = p->GJ * 3 / p->length;

    /* outputs */
    c->I_s = I_s;
    c->J_0_xx = J_0_xx;
    c->Psi_c_y4 = Psi_c_y4;
    c->Psi_c_y5 = Psi_c_y5;
    c->Psi_c_y6 = Psi_c_y6;
    c->Psi_c_z1 = Psi_c_z1;
    c->Psi_c_z2 = Psi_c_z2;
    c->Psi_c_z3 = Psi_c_z3;
    c->S_0_x = S_0_x;
    c->body0_mass = p->bodies[0].mass;
    c->chi_1 = chi_1;
    c->chi_2 = chi_2;
    c->chi_3 = chi_3;
    c->length = p->length;
    c->mu = mu;
    c->per_acceleration = per_acceleration;
    c->per_force = per_force;
    c->per_turn = per_turn;
    c->sigma_t_7 = sigma_t_7;
    c->sigma_y1 = sigma_y1;
    c->sigma_y2 = sigma_y2;
    c->sigma_y3 = sigma_y3;
    M_eta[0] = mu;
    M_eta[1] = mu;
    M_eta[2] = mu;
    M_eta[3] = mu;
    M_eta[4] = mu;
    M_eta[5] = mu;
    M_eta[6] = I_s;
    K[0] = K_full_11;
    K[1] = K_full_22;
    K[2] = K_full_33;
    K[3] = K_full_44;
    K[4] = K_full_55;
    K[5] = K_full_66;
    K[6] = K_full_77;
    D[0] = 0;
    D[1] = 0;
    D[2] = 0;
    D[3] = 0;
    D[4] = 0;
    D[5] = 0;
    D[6] = 0;

    return (c->I_s + c->J_0_xx + c->Psi_c_y4 + c->Psi_c_y5 + c->Psi_c_y6 + c->Psi_c_z1)
        + (c->Psi_c_z2 + c->Psi_c_z3 + c->S_0_x + c->body0_mass + c->chi_1 + c->chi_2)
        + (c->chi_3 + c->length + c->mu + c->per_acceleration + c->per_force + c->per_turn)
        + (c->sigma_t_7 + c->sigma_y1 + c->sigma_y2 + c->sigma_y3 + M_eta[0] + M_eta[1])
        + (M_eta[2] + M_eta[3] + M_eta[4] + M_eta[5] + M_eta[6] + K[0])
        + (K[1] + K[2] + K[3] + K[4] + K[5] + K[6])
        + (D[0] + D[1] + D[2] + D[3] + D[4] + D[5])
        + (D[6]);
}

ella_status ella_prepare(const ella_parameters *p, ella_constants *c)
{
    ella_real sum = 0;
    int i, k;
    if (!p || !c) {
        return ELLA_BAD_ARGUMENT;
    }
    if (!ella_finite((const ella_real *)p, (int)(sizeof *p / sizeof(ella_real)))) {
        return ELLA_NONFINITE;
    }
    for (i = 0; i < ELLA_NLINKS; ++i) {
        const ella_link_parameters *link = &p->links[i];
        if (!(link->length > 0) || !(link->rhoA > 0) || link->rhoIp < 0) {
            return ELLA_BAD_ARGUMENT;
        }
        for (k = 0; k < 1; ++k) {
            if (link->bodies[k].mass < 0) {
                return ELLA_BAD_ARGUMENT;
            }
        }
    }
    for (i = 0; i < 3; ++i) {
        c->gravity[i] = p->gravity[i];
    }
    sum += constants_of_upper_arm(&p->links[0], &c->links[0], c->M_eta + 0, c->K + 0, c->D + 0);
    sum += constants_of_forearm(&p->links[1], &c->links[1], c->M_eta + 7, c->K + 7, c->D + 7);
    for (k = ELLA_NGIVEN - ELLA_NMODES; k < ELLA_NGIVEN; ++k) {
        if (!(c->M_eta[k] > 0) || !(c->K[k] > 0) || !(c->D[k] >= 0)) {
            return ELLA_BAD_ARGUMENT;
        }
    }
    if (!ella_finite(&sum, 1)) {
        return ELLA_NONFINITE;
    }
    return ELLA_OK;
}
