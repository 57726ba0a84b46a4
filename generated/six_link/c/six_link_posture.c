/* six_link_posture.c: poses and twists, equilibrium. */
#include "six_link_links.h"

static six_link_call call_for(const six_link_state *state, six_link_motion *motion)
{
    six_link_call call = { 0 };
    call.q = state->q;
    call.qdot = state->v;
    call.eta = state->q + (SIX_LINK_NQ - SIX_LINK_NMODES);
    call.etadot = state->v + (SIX_LINK_NV - SIX_LINK_NMODES);
    call.new_R = &motion->rotation[0][0][0];
    call.new_r = &motion->position[0][0];
    call.new_tip_twist = &motion->tip_twist[0][0];
    return call;
}

static int finite_motion(const six_link_state *s, const six_link_motion *m)
{
    return six_link_finite(s->q, SIX_LINK_NQ) && six_link_finite(s->v, SIX_LINK_NV)
        && six_link_finite(&m->rotation[0][0][0], 9 * SIX_LINK_NLINKS)
            && six_link_finite(&m->position[0][0], 3 * SIX_LINK_NLINKS)
        && six_link_finite(&m->tip_rotation[0][0][0], 9 * SIX_LINK_NLINKS)
        && six_link_finite(&m->tip_position[0][0], 3 * SIX_LINK_NLINKS)
            && six_link_finite(&m->tip_twist[0][0], 6 * SIX_LINK_NLINKS);
}

static six_link_status fill(const six_link_constants *c, const six_link_state *state, six_link_chain *chain,
    six_link_motion *motion)
{
    const six_link_call call = call_for(state, motion);
    int i, fault = 0;
    const six_link_status status = six_link_motion_of(c, &call, chain, &fault);
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        six_link_pose_of(&chain->nodes[i + 1], motion->tip_rotation[i], motion->tip_position[i]);
    }
    return status == SIX_LINK_OK && !finite_motion(state, motion) ? SIX_LINK_NONFINITE : status;
}

six_link_status six_link_kinematics(const six_link_constants *c, const six_link_state *state, six_link_chain *chain,
    six_link_motion *motion)
{
    return c && state && chain && motion ? fill(c, state, chain, motion) : SIX_LINK_BAD_ARGUMENT;
}

six_link_status six_link_tip_jacobian(const six_link_constants *c, const six_link_state *state, six_link_chain *chain,
    six_link_motion *motion, six_link_real J[6][SIX_LINK_LENGTH(SIX_LINK_NV)])
{
    six_link_real unit[SIX_LINK_LENGTH(SIX_LINK_NV)] = { 0 };
    six_link_call call;
    six_link_status status = SIX_LINK_OK;
    int j, k, fault = 0;
    if (!c || !state || !chain || !motion || !J) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    call = call_for(state, motion);
    call.qdot = unit;
    call.etadot = unit + (SIX_LINK_NV - SIX_LINK_NMODES);
    for (j = 0; j < SIX_LINK_NV && status == SIX_LINK_OK; ++j) {
        unit[j] = 1;
        status = six_link_motion_of(c, &call, chain, &fault);
        unit[j] = 0;
        for (k = 0; k < 6; ++k) {
            J[k][j] = motion->tip_twist[SIX_LINK_NLINKS - 1][k];
        }
        if (!six_link_finite(motion->tip_twist[SIX_LINK_NLINKS - 1], 6)) {
            status = SIX_LINK_NONFINITE;
        }
    }
    return status == SIX_LINK_OK ? fill(c, state, chain, motion) : status;
}

six_link_status six_link_gravity(const six_link_constants *c, const six_link_state *state, const six_link_input *input,
    six_link_chain *chain, six_link_real force[], six_link_state *rest)
{
    static const six_link_real still[SIX_LINK_LENGTH(SIX_LINK_NV)] = { 0 };
    six_link_state posture;
    six_link_status status;
    int round, k;
    if (!c || !state || !input || !chain || !force || !rest) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    posture = *state;
    for (k = 0; k < SIX_LINK_NV; ++k) {
        posture.v[k] = 0;
    }
    status = six_link_inverse_dynamics(c, &posture, input, still, chain, force, 0);
    for (round = 0; round < SIX_LINK_ROUNDS && status == SIX_LINK_OK; ++round) {
        for (k = 0; k < SIX_LINK_NMODES; ++k) {
            posture.q[SIX_LINK_NQ - SIX_LINK_NMODES + k] -= force[SIX_LINK_NV - SIX_LINK_NMODES
                + k] / c->K[SIX_LINK_NTAU + k];
        }
        status = six_link_inverse_dynamics(c, &posture, input, still, chain, force, 0);
    }
    if (status == SIX_LINK_OK) {
        *rest = posture;
    }
    return status;
}
