/* six_link_step.c: forward dynamics and the integrators of the joint form. */
#include "six_link_links.h"

/* Inertia and force of every joint coordinate (motor, spring and damper) and of every mode; returns the inertia.
 * Implicit over dt: m = M + dt D + dt^2 K and f = K (x + dt xdot) + D xdot, so that m xddot + f is inertia and force dt
 * after the state s.
 */
static const six_link_real *modal_terms(const six_link_constants *c, const six_link_state *s, six_link_real dt,
    six_link_work *work)
{
    const six_link_real *eta = s->q + (SIX_LINK_NQ - SIX_LINK_NGIVEN), *etadot = s->v + (SIX_LINK_NV - SIX_LINK_NGIVEN);
    int k;
    if (!(dt > 0)) {
        for (k = 0; k < SIX_LINK_NGIVEN; ++k) {
            work->f_eta[k] = c->K[k] * eta[k] + c->D[k] * etadot[k];
        }
        return c->M_eta;
    }
    for (k = 0; k < SIX_LINK_NGIVEN; ++k) {
        work->m_eta[k] = c->M_eta[k] + dt * (c->D[k] + dt * c->K[k]);
        work->f_eta[k] = c->K[k] * (eta[k] + dt * etadot[k]) + c->D[k] * etadot[k];
    }
    return work->m_eta;
}

/* vdot at s with the modal terms m_eta and work->f_eta, and the wanted results; they may be non-finite. */
static six_link_status accelerate(const six_link_constants *c, const six_link_state *s, const six_link_input *u,
    const six_link_real *m_eta, six_link_work *work, int wanted, six_link_output *y)
{
    const six_link_status status = six_link_dynamics(c, s, u, m_eta, work, wanted, y);
    return status == SIX_LINK_OK
        || (six_link_sound(s, u) && six_link_finite(m_eta, SIX_LINK_NGIVEN)) ? status : SIX_LINK_NONFINITE;
}

/* vdot at a state and the wanted results, checked to be finite. */
static six_link_status evaluate(const six_link_constants *c, const six_link_state *s, const six_link_input *u,
    six_link_work *work,
    int wanted, six_link_output *y)
{
    const six_link_status status = accelerate(c, s, u, modal_terms(c, s, 0, work), work, wanted, y);
    return status != SIX_LINK_OK || six_link_finite(y->vdot, SIX_LINK_NV) ? status : SIX_LINK_NONFINITE;
}

/* Forces without effect on the accelerations appear in the joint wrenches alone, so they are checked too. */
static int non_finite(const six_link_input *u)
{
    return !six_link_finite(&u->w_ext[0][0], 6 * SIX_LINK_NLINKS);
}

/* All of output, and the other wanted results. */
static six_link_status complete(const six_link_constants *c, const six_link_state *state, const six_link_input *input,
    six_link_work *work, int wanted, six_link_output *output)
{
    six_link_status status;
    if (!c || !state || !input || !work || !output) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    status = evaluate(c, state, input, work, wanted | SIX_LINK_WRENCHES | SIX_LINK_TIP_POSE, output);
    if (status == SIX_LINK_OK && (non_finite(input) || !six_link_finite(&output->wrench[0][0], 6 * SIX_LINK_NLINKS)
        || !six_link_finite(&output->tip_rotation[0][0], 9) || !six_link_finite(output->tip_position, 3))) {
        return SIX_LINK_NONFINITE;
    }
    return status;
}

six_link_status six_link_forward_dynamics(const six_link_constants *c, const six_link_state *state,
    const six_link_input *input,
    six_link_work *work, six_link_output *output)
{
    return complete(c, state, input, work, 0, output);
}

six_link_status six_link_watched_dynamics(const six_link_constants *c, const six_link_state *state,
    const six_link_input *input,
    six_link_work *work, six_link_output *output)
{
    return complete(c, state, input, work, SIX_LINK_MOTION, output);
}

six_link_status six_link_accelerations(const six_link_constants *c, const six_link_state *state,
    const six_link_input *input,
    six_link_work *work, six_link_output *output)
{
    if (!c || !state || !input || !work || !output) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    return non_finite(input) ? SIX_LINK_NONFINITE : evaluate(c, state, input, work, 0, output);
}

static int bad_step(const six_link_constants *c, const six_link_state *s, const six_link_input *u, six_link_real dt,
    const six_link_work *work)
{
    return !c || !s || !u || !work || !six_link_is_step(dt);
}

/* y = x + dt * rate for coordinates and rates. */
static void advance(const six_link_state *x, six_link_real dt, const six_link_real *qdot, const six_link_real *vdot,
    six_link_state *y)
{
    int k;
    for (k = 0; k < SIX_LINK_NV; ++k) {
        y->q[k] = x->q[k] + dt * qdot[k];
        y->v[k] = x->v[k] + dt * vdot[k];
    }
}

/* y from x: the rates over dt, and the coordinates over dt by the rates that the acceleration gives after `kick`. */
static void leap(const six_link_state *x, six_link_real dt, six_link_real kick, const six_link_real *vdot,
    six_link_state *y)
{
    int k;
    for (k = 0; k < SIX_LINK_NV; ++k) {
        y->q[k] = x->q[k] + dt * (x->v[k] + kick * vdot[k]);
        y->v[k] = x->v[k] + dt * vdot[k];
    }
}

/* The new state is accepted only if it and the input are finite. */
static six_link_status accept(const six_link_state *next, const six_link_input *input, six_link_state *state)
{
    if (non_finite(input) || !six_link_finite(next->q, SIX_LINK_NQ) || !six_link_finite(next->v, SIX_LINK_NV)) {
        return SIX_LINK_NONFINITE;
    }
    *state = *next;
    return SIX_LINK_OK;
}

/* euler: forward Euler, explicit, order 1. */
six_link_status six_link_step_euler(const six_link_constants *c, six_link_state *state, const six_link_input *input,
    six_link_real dt, six_link_work *work)
{
    six_link_status status;
    if (bad_step(c, state, input, dt, work)) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    status = accelerate(c, state, input, modal_terms(c, state, 0, work), work, 0, &work->output);
    if (status != SIX_LINK_OK) {
        return status;
    }
    advance(state, dt, state->v, work->output.vdot, &work->next);
    return accept(&work->next, input, state);
}

/* semi_implicit: rates first, then coordinates with the new rates, order 1. */
six_link_status six_link_step_semi_implicit(const six_link_constants *c, six_link_state *state,
    const six_link_input *input, six_link_real dt, six_link_work *work)
{
    six_link_status status;
    if (bad_step(c, state, input, dt, work)) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    status = accelerate(c, state, input, modal_terms(c, state, 0, work), work, 0, &work->output);
    if (status != SIX_LINK_OK) {
        return status;
    }
    leap(state, dt, dt, work->output.vdot, &work->next);
    return accept(&work->next, input, state);
}

/* modal_implicit: semi_implicit with the elastic forces at the step's end, stable for stiff modes, order 1. */
six_link_status six_link_step_modal_implicit(const six_link_constants *c, six_link_state *state,
    const six_link_input *input, six_link_real dt, six_link_work *work)
{
    six_link_status status;
    if (bad_step(c, state, input, dt, work)) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    status = accelerate(c, state, input, modal_terms(c, state, dt, work), work, 0, &work->output);
    if (status != SIX_LINK_OK) {
        return status;
    }
    leap(state, dt, dt, work->output.vdot, &work->next);
    return accept(&work->next, input, state);
}

/* modal_midpoint: midpoint rule with implicit elastic forces, stable for stiff modes, two forward dynamics, order 2. */
six_link_status six_link_step_modal_midpoint(const six_link_constants *c, six_link_state *state,
    const six_link_input *input, six_link_real dt, six_link_work *work)
{
    const six_link_real half = dt / 2;
    six_link_status status;
    if (bad_step(c, state, input, dt, work)) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    /* Stage 1. */
    status = accelerate(c, state, input, modal_terms(c, state, half, work), work, 0, &work->output);
    if (status != SIX_LINK_OK) {
        return status;
    }
    leap(state, half, half, work->output.vdot, &work->stage);
    /* Stage 2, the terms of the elastic forces as before. */
    status = accelerate(c, &work->stage, input, work->m_eta, work, 0, &work->output);
    if (status != SIX_LINK_OK) {
        return status;
    }
    leap(state, dt, half, work->output.vdot, &work->next);
    return accept(&work->next, input, state);
}

/* rk4: classical Runge-Kutta, four forward dynamics, order 4. */
six_link_status six_link_step_rk4(const six_link_constants *c, six_link_state *state, const six_link_input *input,
    six_link_real dt, six_link_work *work)
{
    const six_link_real half = dt / 2, third = dt / 3, sixth = dt / 6;
    six_link_status status;
    if (bad_step(c, state, input, dt, work)) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    /* Stage 1. */
    status = accelerate(c, state, input, modal_terms(c, state, 0, work), work, 0, &work->output);
    if (status != SIX_LINK_OK) {
        return status;
    }
    advance(state, sixth, state->v, work->output.vdot, &work->next);
    advance(state, half, state->v, work->output.vdot, &work->stage);
    /* Stage 2. */
    status = accelerate(c, &work->stage, input, modal_terms(c, &work->stage, 0, work), work, 0, &work->output);
    if (status != SIX_LINK_OK) {
        return status;
    }
    advance(&work->next, third, work->stage.v, work->output.vdot, &work->next);
    advance(state, half, work->stage.v, work->output.vdot, &work->stage);
    /* Stage 3. */
    status = accelerate(c, &work->stage, input, modal_terms(c, &work->stage, 0, work), work, 0, &work->output);
    if (status != SIX_LINK_OK) {
        return status;
    }
    advance(&work->next, third, work->stage.v, work->output.vdot, &work->next);
    advance(state, dt, work->stage.v, work->output.vdot, &work->stage);
    /* Stage 4. */
    status = accelerate(c, &work->stage, input, modal_terms(c, &work->stage, 0, work), work, 0, &work->output);
    if (status != SIX_LINK_OK) {
        return status;
    }
    advance(&work->next, sixth, work->stage.v, work->output.vdot, &work->next);
    return accept(&work->next, input, state);
}
