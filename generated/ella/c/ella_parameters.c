/* ella_parameters.c: the robot file's values, and what follows from them. */
#include <string.h>

#include "ella_real.h"

void ella_parameters_default(ella_parameters *p)
{
    memset(p, 0, sizeof *p);
    p->gravity[0] = 0;
    p->gravity[1] = 0;
    p->gravity[2] = REAL(-9.81);
    p->links[0].length = REAL(0.95);
    p->links[0].rhoA = REAL(1.6302);
    p->links[0].EA = REAL(43800000.0);
    p->links[0].EIy = 2120;
    p->links[0].EIz = 3670;
    p->links[0].rhoIp = REAL(0.000215);
    p->links[0].bodies[0].mass = REAL(3.3);
    p->links[1].length = REAL(0.93);
    p->links[1].rhoA = REAL(1.6302);
    p->links[1].EA = REAL(43890000.0);
    p->links[1].EIy = REAL(2119.9500000000003);
    p->links[1].EIz = REAL(3669.96);
    p->links[1].rhoIp = REAL(0.00021505380000000002);
    p->links[1].bodies[0].mass = REAL(2.1);
}

/* links like upper_arm; returns the sum of all, which is finite if they are */
static ella_real constants_of_upper_arm(const ella_link_parameters *p, ella_link_constants *c, ella_real M_eta[], ella_real K[], ella_real D[])
{
    /* Gamma_xy: products of the shapes in x with those in y */
    const ella_real Gamma_xy_11 = p->length * REAL(0.9586414454254526) * p->rhoA;

    /* I_s: spin inertia of the beam */
    const ella_real I_s = p->length * p->rhoIp;

    /* J_0: second moment, undeformed */
    const ella_real t1 = p->length * p->length;
    const ella_real t2 = t1 * p->length;
    const ella_real J_0_xx = t2 * REAL(0.3333333333333333) * p->rhoA;

    /* Psi_c: turn of the tip section by each mode */
    const ella_real Psi_c_y3 = REAL(-2.7530109693450697) / p->length;
    const ella_real Psi_c_z2 = REAL(2.7530109693450697) / p->length;

    /* S_0: first moment, undeformed (27) */
    const ella_real S_0_x = t1 * REAL(0.5) * p->rhoA;

    /* chi: first moment of each mode shape */
    const ella_real chi_1 = t1 * REAL(0.5731591682507563) * p->rhoA;
    const ella_real chi_2 = t1 * REAL(0.5688257437099108) * p->rhoA;

    /* mu: mass of the beam */
    const ella_real mu = p->length * p->rhoA;

    /* sigma: momentum of each mode (B1) */
    const ella_real sigma_x1 = p->length * REAL(0.9003163161571061) * p->rhoA;
    const ella_real sigma_y2 = p->length * REAL(0.7829917560396258) * p->rhoA;

    /* K_full: stiffness of the modes (torsion: N*m), diagonal (88) */
    const ella_real K_full_11 = p->EA * REAL(2.4674011002723395) / p->length;
    const ella_real K_full_22 = p->EIz * REAL(12.362363368326191) / t2;
    const ella_real K_full_33 = p->EIy * REAL(12.362363368326191) / t2;

    /* outputs */
    c->Gamma_xy_11 = Gamma_xy_11;
    c->I_s = I_s;
    c->J_0_xx = J_0_xx;
    c->Psi_c_y3 = Psi_c_y3;
    c->Psi_c_z2 = Psi_c_z2;
    c->S_0_x = S_0_x;
    c->body0_mass = p->bodies[0].mass;
    c->chi_1 = chi_1;
    c->chi_2 = chi_2;
    c->length = p->length;
    c->mu = mu;
    c->sigma_x1 = sigma_x1;
    c->sigma_y2 = sigma_y2;
    M_eta[0] = mu;
    M_eta[1] = mu;
    M_eta[2] = mu;
    K[0] = K_full_11;
    K[1] = K_full_22;
    K[2] = K_full_33;
    D[0] = 0;
    D[1] = 0;
    D[2] = 0;

    return (c->Gamma_xy_11 + c->I_s + c->J_0_xx + c->Psi_c_y3 + c->Psi_c_z2 + c->S_0_x)
        + (c->body0_mass + c->chi_1 + c->chi_2 + c->length + c->mu + c->sigma_x1)
        + (c->sigma_y2 + M_eta[0] + M_eta[1] + M_eta[2] + K[0] + K[1])
        + (K[2] + D[0] + D[1] + D[2]);
}

/* links like forearm; returns the sum of all, which is finite if they are */
static ella_real constants_of_forearm(const ella_link_parameters *p, ella_link_constants *c, ella_real M_eta[], ella_real K[], ella_real D[])
{
    /* Gamma_xy: products of the shapes in x with those in y */
    const ella_real Gamma_xy_11 = p->length * REAL(0.9586414454254526) * p->rhoA;

    /* I_s: spin inertia of the beam */
    const ella_real I_s = p->length * p->rhoIp;

    /* J_0: second moment, undeformed */
    const ella_real t1 = p->length * p->length;
    const ella_real t2 = t1 * p->length;
    const ella_real J_0_xx = t2 * REAL(0.3333333333333333) * p->rhoA;

    /* Psi_c: turn of the tip section by each mode */
    const ella_real Psi_c_y3 = REAL(-2.7530109693450697) / p->length;
    const ella_real Psi_c_z2 = REAL(2.7530109693450697) / p->length;

    /* S_0: first moment, undeformed (27) */
    const ella_real S_0_x = t1 * REAL(0.5) * p->rhoA;

    /* chi: first moment of each mode shape */
    const ella_real chi_1 = t1 * REAL(0.5731591682507563) * p->rhoA;
    const ella_real chi_2 = t1 * REAL(0.5688257437099108) * p->rhoA;

    /* mu: mass of the beam */
    const ella_real mu = p->length * p->rhoA;

    /* sigma: momentum of each mode (B1) */
    const ella_real sigma_x1 = p->length * REAL(0.9003163161571061) * p->rhoA;
    const ella_real sigma_y2 = p->length * REAL(0.7829917560396258) * p->rhoA;

    /* K_full: stiffness of the modes (torsion: N*m), diagonal (88) */
    const ella_real K_full_11 = p->EA * REAL(2.4674011002723395) / p->length;
    const ella_real K_full_22 = p->EIz * REAL(12.362363368326191) / t2;
    const ella_real K_full_33 = p->EIy * REAL(12.362363368326191) / t2;

    /* outputs */
    c->Gamma_xy_11 = Gamma_xy_11;
    c->I_s = I_s;
    c->J_0_xx = J_0_xx;
    c->Psi_c_y3 = Psi_c_y3;
    c->Psi_c_z2 = Psi_c_z2;
    c->S_0_x = S_0_x;
    c->body0_mass = p->bodies[0].mass;
    c->chi_1 = chi_1;
    c->chi_2 = chi_2;
    c->length = p->length;
    c->mu = mu;
    c->sigma_x1 = sigma_x1;
    c->sigma_y2 = sigma_y2;
    M_eta[0] = mu;
    M_eta[1] = mu;
    M_eta[2] = mu;
    K[0] = K_full_11;
    K[1] = K_full_22;
    K[2] = K_full_33;
    D[0] = 0;
    D[1] = 0;
    D[2] = 0;

    return (c->Gamma_xy_11 + c->I_s + c->J_0_xx + c->Psi_c_y3 + c->Psi_c_z2 + c->S_0_x)
        + (c->body0_mass + c->chi_1 + c->chi_2 + c->length + c->mu + c->sigma_x1)
        + (c->sigma_y2 + M_eta[0] + M_eta[1] + M_eta[2] + K[0] + K[1])
        + (K[2] + D[0] + D[1] + D[2]);
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
    sum += constants_of_forearm(&p->links[1], &c->links[1], c->M_eta + 3, c->K + 3, c->D + 3);
    for (k = 0; k < ELLA_NMODES; ++k) {
        if (!(c->M_eta[k] > 0) || !(c->K[k] > 0) || !(c->D[k] >= 0)) {
            return ELLA_BAD_ARGUMENT;
        }
    }
    if (!ella_finite(&sum, 1)) {
        return ELLA_NONFINITE;
    }
    return ELLA_OK;
}
