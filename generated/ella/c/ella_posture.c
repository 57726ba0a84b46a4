/* ella_posture.c: poses and twists, equilibrium. */
#include "ella_links.h"

static ella_call call_for(const ella_state *state, ella_motion *motion)
{
    ella_call call = { 0 };
    call.q = state->q;
    call.qdot = state->v;
    call.eta = state->q + (ELLA_NQ - ELLA_NMODES);
    call.etadot = state->v + (ELLA_NV - ELLA_NMODES);
    call.new_R = &motion->rotation[0][0][0];
    call.new_r = &motion->position[0][0];
    call.new_tip_twist = &motion->tip_twist[0][0];
    return call;
}

static int finite_motion(const ella_state *s, const ella_motion *m)
{
    return ella_finite(s->q, ELLA_NQ) && ella_finite(s->v, ELLA_NV)
        && ella_finite(&m->rotation[0][0][0], 9 * ELLA_NLINKS) && ella_finite(&m->position[0][0], 3 * ELLA_NLINKS)
        && ella_finite(&m->tip_rotation[0][0][0], 9 * ELLA_NLINKS)
        && ella_finite(&m->tip_position[0][0], 3 * ELLA_NLINKS) && ella_finite(&m->tip_twist[0][0], 6 * ELLA_NLINKS);
}

static ella_status fill(const ella_constants *c, const ella_state *state, ella_chain *chain, ella_motion *motion)
{
    const ella_call call = call_for(state, motion);
    int i, fault = 0;
    const ella_status status = ella_motion_of(c, &call, chain, &fault);
    for (i = 0; i < ELLA_NLINKS; ++i) {
        ella_pose_of(&chain->nodes[i + 1], motion->tip_rotation[i], motion->tip_position[i]);
    }
    return status == ELLA_OK && !finite_motion(state, motion) ? ELLA_NONFINITE : status;
}

ella_status ella_kinematics(const ella_constants *c, const ella_state *state, ella_chain *chain, ella_motion *motion)
{
    return c && state && chain && motion ? fill(c, state, chain, motion) : ELLA_BAD_ARGUMENT;
}

ella_status ella_tip_jacobian(const ella_constants *c, const ella_state *state, ella_chain *chain,
    ella_motion *motion, ella_real J[6][ELLA_LENGTH(ELLA_NV)])
{
    ella_real unit[ELLA_LENGTH(ELLA_NV)] = { 0 };
    ella_call call;
    ella_status status = ELLA_OK;
    int j, k, fault = 0;
    if (!c || !state || !chain || !motion || !J) {
        return ELLA_BAD_ARGUMENT;
    }
    call = call_for(state, motion);
    call.qdot = unit;
    call.etadot = unit + (ELLA_NV - ELLA_NMODES);
    for (j = 0; j < ELLA_NV && status == ELLA_OK; ++j) {
        unit[j] = 1;
        status = ella_motion_of(c, &call, chain, &fault);
        unit[j] = 0;
        for (k = 0; k < 6; ++k) {
            J[k][j] = motion->tip_twist[ELLA_NLINKS - 1][k];
        }
        if (!ella_finite(motion->tip_twist[ELLA_NLINKS - 1], 6)) {
            status = ELLA_NONFINITE;
        }
    }
    return status == ELLA_OK ? fill(c, state, chain, motion) : status;
}

ella_status ella_gravity(const ella_constants *c, const ella_state *state, const ella_input *input,
    ella_chain *chain, ella_real force[], ella_state *rest)
{
    static const ella_real still[ELLA_LENGTH(ELLA_NV)] = { 0 };
    ella_state posture;
    ella_status status;
    int round, k;
    if (!c || !state || !input || !chain || !force || !rest) {
        return ELLA_BAD_ARGUMENT;
    }
    posture = *state;
    for (k = 0; k < ELLA_NV; ++k) {
        posture.v[k] = 0;
    }
    status = ella_inverse_dynamics(c, &posture, input, still, chain, force, 0);
    for (round = 0; round < ELLA_ROUNDS && status == ELLA_OK; ++round) {
        for (k = 0; k < ELLA_NMODES; ++k) {
            posture.q[ELLA_NQ - ELLA_NMODES + k] -= force[ELLA_NV - ELLA_NMODES + k] / c->K[k];
        }
        status = ella_inverse_dynamics(c, &posture, input, still, chain, force, 0);
    }
    if (status == ELLA_OK) {
        *rest = posture;
    }
    return status;
}
