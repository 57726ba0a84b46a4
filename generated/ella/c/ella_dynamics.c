/* ella_dynamics.c: forward dynamics of the joint form by block elimination, tip to base;
 * inverse dynamics and mass matrix.
 */
#include "ella_links.h"

ella_status ella_dynamics(const ella_constants *c, const ella_state *state, const ella_input *input,
    const ella_real *m_eta, ella_work *work, int wanted, ella_output *output)
{
    const ella_node *tip = &work->chain.nodes[ELLA_NLINKS];
    const ella_call call = {
        .gravity = c->gravity,
        .q = state->q,
        .qdot = state->v,
        .eta = state->q + ELLA_NTAU,
        .etadot = state->v + ELLA_NTAU,
        .tau = input->tau,
        .w_ext = &input->w_ext[0][0],
        .m_eta = m_eta,
        .f_eta = work->f_eta,
        .qddot = output->vdot,
        .etaddot = output->vdot + ELLA_NTAU,
        .wrench = wanted & ELLA_WRENCHES ? &output->wrench[0][0] : 0,
        .tip_pose = wanted & ELLA_TIP_POSE,
    };
    ella_status status;
    int i;
    status = ella_joint_dynamics(c, &call, &work->chain, &work->fault);
    if (call.tip_pose && status == ELLA_OK) {
        for (i = 0; i < 3; ++i) {
            output->tip_rotation[i][0] = tip->R[3 * i];
            output->tip_rotation[i][1] = tip->R[3 * i + 1];
            output->tip_rotation[i][2] = tip->R[3 * i + 2];
            output->tip_position[i] = tip->r[i];
        }
    }
    return status;
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
