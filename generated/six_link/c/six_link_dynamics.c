/* six_link_dynamics.c: forward dynamics of the joint form by block elimination, tip to base;
 * inverse dynamics and mass matrix.
 */
#include "six_link_links.h"

six_link_status six_link_dynamics(const six_link_constants *c, const six_link_state *state, const six_link_input *input,
    six_link_work *work, int wanted, six_link_output *output)
{
    const six_link_node *tip = &work->chain.nodes[SIX_LINK_NLINKS];
    six_link_call call = { 0 };
    six_link_status status;
    int i;
    call.gravity = c->gravity;
    call.q = state->q;
    call.qdot = state->v;
    call.eta = state->q + SIX_LINK_NTAU;
    call.etadot = state->v + SIX_LINK_NTAU;
    call.tau = input->tau;
    call.w_ext = &input->w_ext[0][0];
    call.m_eta = work->m_eta;
    call.f_eta = work->f_eta;
    call.qddot = output->vdot;
    call.etaddot = output->vdot + SIX_LINK_NTAU;
    call.wrench = wanted & SIX_LINK_WRENCHES ? &output->wrench[0][0] : 0;
    call.tip_pose = wanted & SIX_LINK_TIP_POSE;
    status = six_link_joint_dynamics(c, &call, &work->chain, &work->fault);
    if (call.tip_pose && status == SIX_LINK_OK) {
        for (i = 0; i < 3; ++i) {
            output->tip_rotation[i][0] = tip->R[3 * i];
            output->tip_rotation[i][1] = tip->R[3 * i + 1];
            output->tip_rotation[i][2] = tip->R[3 * i + 2];
            output->tip_position[i] = tip->r[i];
        }
    }
    return status;
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
