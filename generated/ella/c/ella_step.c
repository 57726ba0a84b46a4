/* ella_step.c: forward dynamics and the integrators of the joint form. */
#include "ella_links.h"

/* Inertia and force of every mode; returns the inertia. Implicit over dt: m = M + dt D + dt^2 K and
 * f = K (eta + dt etadot) + D etadot, so that m etaddot + f is inertia and modal force dt after the state s.
 */
static const ella_real *modal_terms(const ella_constants *c, const ella_state *s, ella_real dt, ella_work *work)
{
    const ella_real *eta = s->q + (ELLA_NQ - ELLA_NGIVEN), *etadot = s->v + (ELLA_NV - ELLA_NGIVEN);
    int k;
    if (!(dt > 0)) {
        for (k = 0; k < ELLA_NGIVEN; ++k) {
            work->f_eta[k] = c->K[k] * eta[k] + c->D[k] * etadot[k];
        }
        return c->M_eta;
    }
    for (k = 0; k < ELLA_NGIVEN; ++k) {
        work->m_eta[k] = c->M_eta[k] + dt * (c->D[k] + dt * c->K[k]);
        work->f_eta[k] = c->K[k] * (eta[k] + dt * etadot[k]) + c->D[k] * etadot[k];
    }
    return work->m_eta;
}

/* vdot at s with the modal terms m_eta and work->f_eta, and the wanted results; they may be non-finite. */
static ella_status accelerate(const ella_constants *c, const ella_state *s, const ella_input *u,
    const ella_real *m_eta, ella_work *work, int wanted, ella_output *y)
{
    const ella_status status = ella_dynamics(c, s, u, m_eta, work, wanted, y);
    return status == ELLA_OK || (ella_sound(s, u) && ella_finite(m_eta, ELLA_NGIVEN)) ? status : ELLA_NONFINITE;
}

/* vdot at a state and the wanted results, checked to be finite. */
static ella_status evaluate(const ella_constants *c, const ella_state *s, const ella_input *u, ella_work *work,
    int wanted, ella_output *y)
{
    const ella_status status = accelerate(c, s, u, modal_terms(c, s, 0, work), work, wanted, y);
    return status != ELLA_OK || ella_finite(y->vdot, ELLA_NV) ? status : ELLA_NONFINITE;
}

/* Forces without effect on the accelerations appear in the joint wrenches alone, so they are checked too. */
static int non_finite(const ella_input *u)
{
    return !ella_finite(&u->w_ext[0][0], 6 * ELLA_NLINKS);
}

/* All of output, and the other wanted results. */
static ella_status complete(const ella_constants *c, const ella_state *state, const ella_input *input,
    ella_work *work, int wanted, ella_output *output)
{
    ella_status status;
    if (!c || !state || !input || !work || !output) {
        return ELLA_BAD_ARGUMENT;
    }
    status = evaluate(c, state, input, work, wanted | ELLA_WRENCHES | ELLA_TIP_POSE, output);
    if (status == ELLA_OK && (non_finite(input) || !ella_finite(&output->wrench[0][0], 6 * ELLA_NLINKS)
        || !ella_finite(&output->tip_rotation[0][0], 9) || !ella_finite(output->tip_position, 3))) {
        return ELLA_NONFINITE;
    }
    return status;
}

ella_status ella_forward_dynamics(const ella_constants *c, const ella_state *state, const ella_input *input,
    ella_work *work, ella_output *output)
{
    return complete(c, state, input, work, 0, output);
}

ella_status ella_watched_dynamics(const ella_constants *c, const ella_state *state, const ella_input *input,
    ella_work *work, ella_output *output)
{
    return complete(c, state, input, work, ELLA_MOTION, output);
}

ella_status ella_accelerations(const ella_constants *c, const ella_state *state, const ella_input *input,
    ella_work *work, ella_output *output)
{
    if (!c || !state || !input || !work || !output) {
        return ELLA_BAD_ARGUMENT;
    }
    return non_finite(input) ? ELLA_NONFINITE : evaluate(c, state, input, work, 0, output);
}

static int bad_step(const ella_constants *c, const ella_state *s, const ella_input *u, ella_real dt,
    const ella_work *work)
{
    return !c || !s || !u || !work || !ella_is_step(dt);
}

/* y = x + dt * rate for coordinates and rates. */
static void advance(const ella_state *x, ella_real dt, const ella_real *qdot, const ella_real *vdot, ella_state *y)
{
    int k;
    for (k = 0; k < ELLA_NV; ++k) {
        y->q[k] = x->q[k] + dt * qdot[k];
        y->v[k] = x->v[k] + dt * vdot[k];
    }
}

/* y from x: the rates over dt, and the coordinates over dt by the rates that the acceleration gives after `kick`. */
static void leap(const ella_state *x, ella_real dt, ella_real kick, const ella_real *vdot, ella_state *y)
{
    int k;
    for (k = 0; k < ELLA_NV; ++k) {
        y->q[k] = x->q[k] + dt * (x->v[k] + kick * vdot[k]);
        y->v[k] = x->v[k] + dt * vdot[k];
    }
}

/* The new state is accepted only if it and the input are finite. */
static ella_status accept(const ella_state *next, const ella_input *input, ella_state *state)
{
    if (non_finite(input) || !ella_finite(next->q, ELLA_NQ) || !ella_finite(next->v, ELLA_NV)) {
        return ELLA_NONFINITE;
    }
    *state = *next;
    return ELLA_OK;
}

/* euler: forward Euler, explicit, order 1. */
ella_status ella_step_euler(const ella_constants *c, ella_state *state, const ella_input *input, ella_real dt,
    ella_work *work)
{
    ella_status status;
    if (bad_step(c, state, input, dt, work)) {
        return ELLA_BAD_ARGUMENT;
    }
    status = accelerate(c, state, input, modal_terms(c, state, 0, work), work, 0, &work->output);
    if (status != ELLA_OK) {
        return status;
    }
    advance(state, dt, state->v, work->output.vdot, &work->next);
    return accept(&work->next, input, state);
}

/* semi_implicit: rates first, then coordinates with the new rates, order 1. */
ella_status ella_step_semi_implicit(const ella_constants *c, ella_state *state, const ella_input *input, ella_real dt,
    ella_work *work)
{
    ella_status status;
    if (bad_step(c, state, input, dt, work)) {
        return ELLA_BAD_ARGUMENT;
    }
    status = accelerate(c, state, input, modal_terms(c, state, 0, work), work, 0, &work->output);
    if (status != ELLA_OK) {
        return status;
    }
    leap(state, dt, dt, work->output.vdot, &work->next);
    return accept(&work->next, input, state);
}

/* modal_implicit: semi_implicit with the elastic forces at the step's end, stable for stiff modes, order 1. */
ella_status ella_step_modal_implicit(const ella_constants *c, ella_state *state, const ella_input *input, ella_real dt,
    ella_work *work)
{
    ella_status status;
    if (bad_step(c, state, input, dt, work)) {
        return ELLA_BAD_ARGUMENT;
    }
    status = accelerate(c, state, input, modal_terms(c, state, dt, work), work, 0, &work->output);
    if (status != ELLA_OK) {
        return status;
    }
    leap(state, dt, dt, work->output.vdot, &work->next);
    return accept(&work->next, input, state);
}

/* modal_midpoint: midpoint rule with implicit elastic forces, stable for stiff modes, two forward dynamics, order 2. */
ella_status ella_step_modal_midpoint(const ella_constants *c, ella_state *state, const ella_input *input, ella_real dt,
    ella_work *work)
{
    const ella_real half = dt / 2;
    ella_status status;
    if (bad_step(c, state, input, dt, work)) {
        return ELLA_BAD_ARGUMENT;
    }
    /* Stage 1. */
    status = accelerate(c, state, input, modal_terms(c, state, half, work), work, 0, &work->output);
    if (status != ELLA_OK) {
        return status;
    }
    leap(state, half, half, work->output.vdot, &work->stage);
    /* Stage 2, the terms of the elastic forces as before. */
    status = accelerate(c, &work->stage, input, work->m_eta, work, 0, &work->output);
    if (status != ELLA_OK) {
        return status;
    }
    leap(state, dt, half, work->output.vdot, &work->next);
    return accept(&work->next, input, state);
}

/* rk4: classical Runge-Kutta, four forward dynamics, order 4. */
ella_status ella_step_rk4(const ella_constants *c, ella_state *state, const ella_input *input, ella_real dt,
    ella_work *work)
{
    const ella_real half = dt / 2, third = dt / 3, sixth = dt / 6;
    ella_status status;
    if (bad_step(c, state, input, dt, work)) {
        return ELLA_BAD_ARGUMENT;
    }
    /* Stage 1. */
    status = accelerate(c, state, input, modal_terms(c, state, 0, work), work, 0, &work->output);
    if (status != ELLA_OK) {
        return status;
    }
    advance(state, sixth, state->v, work->output.vdot, &work->next);
    advance(state, half, state->v, work->output.vdot, &work->stage);
    /* Stage 2. */
    status = accelerate(c, &work->stage, input, modal_terms(c, &work->stage, 0, work), work, 0, &work->output);
    if (status != ELLA_OK) {
        return status;
    }
    advance(&work->next, third, work->stage.v, work->output.vdot, &work->next);
    advance(state, half, work->stage.v, work->output.vdot, &work->stage);
    /* Stage 3. */
    status = accelerate(c, &work->stage, input, modal_terms(c, &work->stage, 0, work), work, 0, &work->output);
    if (status != ELLA_OK) {
        return status;
    }
    advance(&work->next, third, work->stage.v, work->output.vdot, &work->next);
    advance(state, dt, work->stage.v, work->output.vdot, &work->stage);
    /* Stage 4. */
    status = accelerate(c, &work->stage, input, modal_terms(c, &work->stage, 0, work), work, 0, &work->output);
    if (status != ELLA_OK) {
        return status;
    }
    advance(&work->next, sixth, work->stage.v, work->output.vdot, &work->next);
    return accept(&work->next, input, state);
}
