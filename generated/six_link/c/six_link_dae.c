/* six_link_dae.c: the DAE form. Poses move by the exponential map of SE(3); every step ends with a projection. */
#include "six_link_links.h"
#include "six_link_se3.h"

/* Inertia and force of n coordinates x, implicit over dt; `first` is the first of their columns. */
static void own_terms(const six_link_constants *c, int first, int n, const six_link_real *x, const six_link_real *xdot,
    six_link_real dt,
    six_link_dae_work *work)
{
    int k;
    for (k = 0; k < n; ++k) {
        const six_link_real K = c->K[first + k], D = c->D[first + k];
        work->m_eta[first + k] = c->M_eta[first + k] + dt * (D + dt * K);
        work->f_eta[first + k] = K * (x[k] + dt * xdot[k]) + D * xdot[k];
    }
}

static void modal_terms(const six_link_constants *c, const six_link_dae_state *s, six_link_real dt,
    six_link_dae_work *work)
{
    own_terms(c, SIX_LINK_NGIVEN - SIX_LINK_NMODES, SIX_LINK_NMODES, s->eta, s->etadot, dt, work);
}

static six_link_call call_of(const six_link_constants *c, const six_link_dae_state *s, const six_link_input *u,
    six_link_dae_work *work)
{
    six_link_call call = { 0 };
    call.gravity = c->gravity;
    call.q = s->q;
    call.eta = s->eta;
    call.etadot = s->etadot;
    call.quaternion = &s->quaternion[0][0];
    call.twist = &s->twist[0][0];
    call.m_q = work->m_eta;
    call.f_q = work->f_eta;
    call.m_eta = work->m_eta + (SIX_LINK_NGIVEN - SIX_LINK_NMODES);
    call.f_eta = work->f_eta + (SIX_LINK_NGIVEN - SIX_LINK_NMODES);
    call.new_qdot = work->qdot;
    call.qdot = work->qdot;
    if (u) {
        call.tau = u->tau;
        call.w_ext = &u->w_ext[0][0];
    }
    return call;
}

static int finite_state(const six_link_dae_state *s)
{
    return six_link_finite(&s->quaternion[0][0], 4 * SIX_LINK_NLINKS)
        && six_link_finite(&s->position[0][0], 3 * SIX_LINK_NLINKS)
        && six_link_finite(&s->twist[0][0], 6 * SIX_LINK_NLINKS) && six_link_finite(s->eta, SIX_LINK_NMODES)
        && six_link_finite(s->etadot, SIX_LINK_NMODES) && six_link_finite(s->q, SIX_LINK_NTAU);
}

/* Whether products of three entries are finite. If not, a failed pivot does not mean a singular posture. */
static int moderate_state(const six_link_dae_state *s, const six_link_dae_work *work)
{
    return six_link_moderate(&s->twist[0][0], 6 * SIX_LINK_NLINKS) && six_link_moderate(s->eta, SIX_LINK_NMODES)
        && six_link_moderate(s->etadot, SIX_LINK_NMODES)
            && six_link_finite(work->m_eta + (SIX_LINK_NGIVEN - SIX_LINK_NMODES), SIX_LINK_NMODES);
}

static int finite_input(const six_link_dae_state *s, const six_link_input *u)
{
    return finite_state(s) && six_link_finite(u->tau, SIX_LINK_NTAU)
        && six_link_finite(&u->w_ext[0][0], 6 * SIX_LINK_NLINKS);
}

/* Vdot, etaddot, qdot and the wrenches at s, with the forces of joints and modes implicit, dt after the state from. If
 * from is not s, the joint rates at from are those of the call before.
 */
static six_link_status accelerate(const six_link_constants *c, const six_link_dae_state *s,
    const six_link_dae_state *from,
    const six_link_input *u, six_link_real dt, six_link_dae_work *work)
{
    six_link_status status;
    six_link_call call = call_of(c, s, u, work);
    call.new_qddot = work->qddot;
    call.new_etaddot = work->etaddot;
    call.new_wrench = &work->wrench[0][0];
    call.new_alpha = &work->alpha[0][0];
    call.alpha = &work->alpha[0][0];
    call.new_Vdot = &work->Vdot[0][0];
    if (!finite_input(s, u)) {
        return SIX_LINK_NONFINITE;
    }
    modal_terms(c, from, dt, work);
    status = six_link_dae_motion(c, &call, &work->chain, &work->fault);
    if (status == SIX_LINK_OK) {
        if (from == s) {
            own_terms(c, 0, SIX_LINK_NTAU, s->q, work->qdot, dt, work);
        }
        status = six_link_dae_solution(c, &call, &work->chain, &work->fault);
    }
    if (status != SIX_LINK_OK) {
        return moderate_state(s, work) && six_link_finite(work->qdot, SIX_LINK_NTAU) ? status : SIX_LINK_NONFINITE;
    }
    if (!six_link_finite(&work->Vdot[0][0], 6 * SIX_LINK_NLINKS) || !six_link_finite(work->etaddot, SIX_LINK_NMODES)
        || !six_link_finite(&work->wrench[0][0], 6 * SIX_LINK_NLINKS)) {
        return SIX_LINK_NONFINITE;
    }
    return SIX_LINK_OK;
}

/* Projection of the state onto the joint constraints: q from the poses, then forward kinematics. */
static six_link_status project(const six_link_constants *c, six_link_dae_state *s, six_link_dae_work *work)
{
    six_link_call call = call_of(c, s, 0, work);
    six_link_status status;
    call.new_q = s->q;
    call.new_quaternion = &s->quaternion[0][0];
    call.new_position = &s->position[0][0];
    call.new_twist = &s->twist[0][0];
    status = six_link_projection(c, &call, &work->chain, &work->fault);
    if (!finite_state(s)) {
        return SIX_LINK_NONFINITE;
    }
    return status;
}

six_link_status six_link_dae_from_state(const six_link_constants *c, const six_link_state *state,
    six_link_dae_work *work, six_link_dae_state *dae)
{
    six_link_call call;
    six_link_status status;
    int k;
    if (!c || !state || !work || !dae) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    for (k = 0; k < SIX_LINK_NTAU; ++k) {
        work->next.q[k] = state->q[k];
        work->qdot[k] = state->v[k];
    }
    for (k = 0; k < SIX_LINK_NMODES; ++k) {
        work->next.eta[k] = state->q[SIX_LINK_NQ - SIX_LINK_NMODES + k];
        work->next.etadot[k] = state->v[SIX_LINK_NV - SIX_LINK_NMODES + k];
    }
    call = call_of(c, &work->next, 0, work);
    call.new_quaternion = &work->next.quaternion[0][0];
    call.new_position = &work->next.position[0][0];
    call.new_twist = &work->next.twist[0][0];
    status = six_link_placement(c, &call, &work->chain, &work->fault);
    if (status == SIX_LINK_OK && !finite_state(&work->next)) {
        status = SIX_LINK_NONFINITE;
    }
    if (status == SIX_LINK_OK) {
        *dae = work->next;
    }
    return status;
}

six_link_status six_link_dae_forward_dynamics(const six_link_constants *c, const six_link_dae_state *state,
    const six_link_input *input, six_link_dae_work *work, six_link_output *output)
{
    six_link_status status;
    six_link_call call;
    int i, k;
    if (!c || !state || !input || !work || !output) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    status = accelerate(c, state, state, input, 0, work);
    if (status != SIX_LINK_OK) {
        return status;
    }
    for (k = 0; k < SIX_LINK_NTAU; ++k) {
        output->vdot[k] = work->qddot[k];
    }
    for (k = 0; k < SIX_LINK_NMODES; ++k) {
        output->vdot[SIX_LINK_NV - SIX_LINK_NMODES + k] = work->etaddot[k];
    }
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            output->wrench[i][k] = work->wrench[i][k];
        }
    }
    work->next = *state;
    call = call_of(c, state, 0, work);
    call.new_quaternion = &work->next.quaternion[0][0];
    call.new_position = &work->next.position[0][0];
    call.new_twist = &work->next.twist[0][0];
    status = six_link_placement(c, &call, &work->chain, &work->fault);
    for (i = 0; i < 3; ++i) {
        for (k = 0; k < 3; ++k) {
            output->tip_rotation[i][k] = work->chain.nodes[SIX_LINK_NLINKS].R[3 * i + k];
        }
        output->tip_position[i] = work->chain.nodes[SIX_LINK_NLINKS].r[i];
    }
    return status;
}

/* y = x + dt * rates for all but the poses; the rates of eta are the given state's etadot. */
static void advance(const six_link_dae_state *x, six_link_real dt, const six_link_real *etadot,
    const six_link_dae_work *work, six_link_dae_state *y)
{
    int i, k;
    for (k = 0; k < SIX_LINK_NMODES; ++k) {
        y->eta[k] = x->eta[k] + dt * etadot[k];
        y->etadot[k] = x->etadot[k] + dt * work->etaddot[k];
    }
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            y->twist[i][k] = x->twist[i][k] + dt * work->Vdot[i][k];
        }
    }
    for (k = 0; k < SIX_LINK_NTAU; ++k) {
        y->q[k] = x->q[k] + dt * work->qdot[k];
    }
}

/* The vectors u that move the poses: u = dt V, or u += dt V. */
static void set_turn(six_link_real dt, six_link_real V[][6], six_link_real u[][6])
{
    int i, k;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            u[i][k] = dt * V[i][k];
        }
    }
}

static void add_turn(six_link_real dt, six_link_real V[][6], six_link_real u[][6])
{
    int i, k;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            u[i][k] += dt * V[i][k];
        }
    }
}

/* Replaces u by its rate at the twists of the state to which it moves the poses. */
static void turn_rates(const six_link_dae_state *s, six_link_real u[][6])
{
    six_link_real rate[6];
    int i, k;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        algebra_rate(u[i], s->twist[i], rate);
        for (k = 0; k < 6; ++k) {
            u[i][k] = rate[k];
        }
    }
}

/* The poses of y are those of x times exp(u). */
static void move(const six_link_dae_state *x, six_link_real u[][6], six_link_dae_state *y)
{
    int i;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        exponential(x->quaternion[i], x->position[i], u[i], y->quaternion[i], y->position[i]);
    }
}

/* y from x over dt: poses and modal coordinates by the rates after `kick`, rates over all of dt; joint coordinates by
 * the rates of the last accelerations `lead` later. u is what moves the poses.
 */
static void leap(const six_link_dae_state *x, six_link_real dt, six_link_real kick, six_link_real lead,
    const six_link_dae_work *work,
    six_link_real u[][6], six_link_dae_state *y)
{
    int i, k;
    for (k = 0; k < SIX_LINK_NMODES; ++k) {
        y->eta[k] = x->eta[k] + dt * (x->etadot[k] + kick * work->etaddot[k]);
        y->etadot[k] = x->etadot[k] + dt * work->etaddot[k];
    }
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            u[i][k] = dt * (x->twist[i][k] + kick * work->Vdot[i][k]);
            y->twist[i][k] = x->twist[i][k] + dt * work->Vdot[i][k];
        }
    }
    for (k = 0; k < SIX_LINK_NTAU; ++k) {
        y->q[k] = x->q[k] + dt * (work->qdot[k] + lead * work->qddot[k]);
    }
    move(x, u, y);
}

static int bad_step(const six_link_constants *c, const six_link_dae_state *s, const six_link_input *u, six_link_real dt,
    const six_link_dae_work *work)
{
    return !c || !s || !u || !work || !six_link_is_step(dt);
}

/* Projects the new state, which is accepted only if that succeeds. */
static six_link_status accept(const six_link_constants *c, six_link_dae_work *work, six_link_dae_state *state)
{
    const six_link_status status = project(c, &work->next, work);
    if (status == SIX_LINK_OK) {
        *state = work->next;
    }
    return status;
}

/* euler: forward Euler, explicit, order 1. */
six_link_status six_link_dae_step_euler(const six_link_constants *c, six_link_dae_state *state,
    const six_link_input *input,
    six_link_real dt, six_link_dae_work *work)
{
    six_link_status status;
    if (bad_step(c, state, input, dt, work)) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    status = accelerate(c, state, state, input, 0, work);
    if (status != SIX_LINK_OK) {
        return status;
    }
    advance(state, dt, state->etadot, work, &work->next);
    set_turn(dt, state->twist, work->next_turn);
    move(state, work->next_turn, &work->next);
    return accept(c, work, state);
}

/* semi_implicit: rates first, then coordinates with the new rates, order 1. */
six_link_status six_link_dae_step_semi_implicit(const six_link_constants *c, six_link_dae_state *state,
    const six_link_input *input,
    six_link_real dt, six_link_dae_work *work)
{
    six_link_status status;
    if (bad_step(c, state, input, dt, work)) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    status = accelerate(c, state, state, input, 0, work);
    if (status != SIX_LINK_OK) {
        return status;
    }
    leap(state, dt, dt, dt, work, work->next_turn, &work->next);
    return accept(c, work, state);
}

/* modal_implicit: semi_implicit with the elastic forces at the step's end, stable for stiff modes, order 1. */
six_link_status six_link_dae_step_modal_implicit(const six_link_constants *c, six_link_dae_state *state,
    const six_link_input *input,
    six_link_real dt, six_link_dae_work *work)
{
    six_link_status status;
    if (bad_step(c, state, input, dt, work)) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    status = accelerate(c, state, state, input, dt, work);
    if (status != SIX_LINK_OK) {
        return status;
    }
    leap(state, dt, dt, dt, work, work->next_turn, &work->next);
    return accept(c, work, state);
}

/* modal_midpoint: midpoint rule with implicit elastic forces, stable for stiff modes, two forward dynamics, order 2. */
six_link_status six_link_dae_step_modal_midpoint(const six_link_constants *c, six_link_dae_state *state,
    const six_link_input *input,
    six_link_real dt, six_link_dae_work *work)
{
    const six_link_real half = dt / 2;
    six_link_status status;
    if (bad_step(c, state, input, dt, work)) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    /* Stage 1. */
    status = accelerate(c, state, state, input, half, work);
    if (status != SIX_LINK_OK) {
        return status;
    }
    leap(state, half, half, half, work, work->stage_turn, &work->stage);
    /* Stage 2, the terms of the elastic forces as before. */
    status = accelerate(c, &work->stage, state, input, half, work);
    if (status != SIX_LINK_OK) {
        return status;
    }
    leap(state, dt, half, 0, work, work->next_turn, &work->next);
    return accept(c, work, state);
}

/* rk4: classical Runge-Kutta, four forward dynamics, order 4. */
six_link_status six_link_dae_step_rk4(const six_link_constants *c, six_link_dae_state *state,
    const six_link_input *input,
    six_link_real dt, six_link_dae_work *work)
{
    const six_link_real half = dt / 2, third = dt / 3, sixth = dt / 6;
    six_link_status status;
    if (bad_step(c, state, input, dt, work)) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    /* Stage 1. */
    status = accelerate(c, state, state, input, 0, work);
    if (status != SIX_LINK_OK) {
        return status;
    }
    advance(state, sixth, state->etadot, work, &work->next);
    set_turn(sixth, state->twist, work->next_turn);
    advance(state, half, state->etadot, work, &work->stage);
    set_turn(half, state->twist, work->stage_turn);
    move(state, work->stage_turn, &work->stage);
    /* Stage 2. */
    status = accelerate(c, &work->stage, &work->stage, input, 0, work);
    if (status != SIX_LINK_OK) {
        return status;
    }
    turn_rates(&work->stage, work->stage_turn);
    advance(&work->next, third, work->stage.etadot, work, &work->next);
    add_turn(third, work->stage_turn, work->next_turn);
    advance(state, half, work->stage.etadot, work, &work->stage);
    set_turn(half, work->stage_turn, work->stage_turn);
    move(state, work->stage_turn, &work->stage);
    /* Stage 3. */
    status = accelerate(c, &work->stage, &work->stage, input, 0, work);
    if (status != SIX_LINK_OK) {
        return status;
    }
    turn_rates(&work->stage, work->stage_turn);
    advance(&work->next, third, work->stage.etadot, work, &work->next);
    add_turn(third, work->stage_turn, work->next_turn);
    advance(state, dt, work->stage.etadot, work, &work->stage);
    set_turn(dt, work->stage_turn, work->stage_turn);
    move(state, work->stage_turn, &work->stage);
    /* Stage 4. */
    status = accelerate(c, &work->stage, &work->stage, input, 0, work);
    if (status != SIX_LINK_OK) {
        return status;
    }
    turn_rates(&work->stage, work->stage_turn);
    advance(&work->next, sixth, work->stage.etadot, work, &work->next);
    add_turn(sixth, work->stage_turn, work->next_turn);
    move(state, work->next_turn, &work->next);
    return accept(c, work, state);
}

/* ------------------------------------------------------------------------------------ M_sys, H_sys, W_sys */

const short six_link_M_row[SIX_LINK_NNZ] = {
    6, 7, 2, 8, 9, 10, 11, 0, 6, 7, 8, 10, 11, 12, 14, 15, 16, 17, 1, 6,
    7, 8, 9, 11, 13, 15, 17, 2, 6, 7, 8, 9, 10, 12, 14, 15, 16, 17, 3, 7,
    8, 9, 15, 17, 4, 6, 8, 10, 16, 5, 6, 7, 11, 15, 17, 6, 8, 18, 7, 13,
    19, 6, 8, 20, 6, 7, 8, 9, 11, 21, 6, 8, 10, 22, 6, 7, 8, 9, 11, 23,
    12, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 72, 73, 74, 75, 76, 13, 18,
    19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 72, 73, 74, 75, 76, 14, 18, 19, 20,
    21, 22, 23, 24, 25, 26, 27, 28, 29, 72, 73, 74, 75, 76, 15, 18, 19, 20, 21, 22,
    23, 27, 28, 29, 72, 73, 74, 75, 76, 16, 18, 19, 20, 21, 22, 23, 27, 28, 29, 72,
    73, 74, 75, 76, 17, 18, 19, 20, 21, 22, 23, 27, 28, 29, 72, 73, 74, 75, 76, 18,
    19, 20, 30, 72, 73, 74, 75, 76, 18, 19, 20, 25, 31, 72, 73, 74, 75, 76, 18, 19,
    20, 32, 72, 73, 74, 75, 76, 18, 19, 20, 21, 22, 23, 33, 72, 73, 74, 75, 76, 18,
    19, 20, 21, 22, 23, 34, 72, 73, 74, 75, 76, 18, 19, 20, 21, 22, 23, 35, 72, 73,
    74, 75, 76, 24, 30, 31, 32, 34, 35, 36, 37, 38, 39, 40, 41, 77, 78, 79, 80, 25,
    30, 31, 32, 33, 35, 36, 37, 38, 39, 40, 41, 79, 80, 26, 30, 31, 32, 33, 34, 36,
    37, 38, 39, 40, 41, 77, 78, 27, 31, 32, 33, 39, 40, 41, 28, 30, 32, 34, 39, 40,
    41, 77, 78, 29, 30, 31, 35, 39, 40, 41, 79, 80, 30, 31, 32, 36, 42, 77, 78, 79,
    80, 30, 31, 32, 43, 77, 78, 79, 80, 30, 31, 32, 44, 77, 78, 79, 80, 30, 31, 32,
    33, 34, 35, 45, 77, 78, 79, 80, 30, 31, 32, 33, 34, 35, 46, 77, 78, 79, 80, 30,
    31, 32, 33, 34, 35, 47, 77, 78, 79, 80, 36, 42, 48, 50, 37, 43, 47, 49, 51, 53,
    38, 44, 46, 48, 50, 52, 39, 45, 51, 53, 40, 44, 46, 52, 41, 43, 47, 51, 53, 42,
    44, 54, 43, 49, 55, 42, 44, 56, 43, 45, 47, 57, 44, 46, 58, 43, 45, 47, 59, 48,
    54, 60, 49, 55, 59, 61, 62, 64, 65, 50, 56, 58, 61, 62, 64, 65, 51, 57, 63, 52,
    56, 58, 64, 65, 53, 55, 59, 64, 65, 54, 60, 66, 55, 56, 67, 55, 56, 68, 57, 69,
    55, 56, 58, 59, 70, 55, 56, 58, 59, 71, 60, 66, 67, 68, 70, 71, 61, 66, 67, 68,
    69, 71, 62, 66, 67, 68, 69, 70, 63, 67, 68, 69, 64, 66, 68, 70, 65, 66, 67, 71,
    18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 72, 73, 74, 75, 76, 18, 19, 20,
    21, 22, 23, 24, 25, 26, 27, 28, 29, 72, 73, 74, 75, 76, 18, 19, 20, 21, 22, 23,
    24, 25, 26, 27, 28, 29, 72, 73, 74, 75, 76, 18, 19, 20, 21, 22, 23, 24, 25, 26,
    27, 28, 29, 72, 73, 74, 75, 76, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29,
    72, 73, 74, 75, 76, 30, 32, 34, 36, 37, 38, 39, 40, 41, 77, 30, 32, 34, 36, 37,
    38, 39, 40, 41, 78, 30, 31, 35, 36, 37, 38, 39, 40, 41, 79, 30, 31, 35, 36, 37,
    38, 39, 40, 41, 80,
};

const int six_link_M_column[SIX_LINK_NZ + 1] = {
    0, 1, 2, 4, 5, 6, 7, 18, 27, 38, 44, 49, 55, 58, 61, 64, 70, 74, 80, 98,
    116, 134, 149, 164, 179, 188, 198, 207, 219, 231, 243, 259, 273, 287, 294, 303, 312, 321, 329, 337,
    348, 359, 370, 374, 380, 386, 390, 394, 399, 402, 405, 408, 412, 415, 419, 422, 429, 436, 439, 444,
    449, 452, 455, 458, 460, 465, 470, 476, 482, 488, 492, 496, 500, 517, 534, 551, 568, 585, 595, 605,
    615, 625,
};

six_link_status six_link_assemble(const six_link_constants *c, const six_link_dae_state *state,
    const six_link_input *input,
    six_link_dae_work *work, six_link_real M_sys[SIX_LINK_NNZ], six_link_real H_sys[SIX_LINK_NZ],
    six_link_real W_sys[SIX_LINK_NZ])
{
    six_link_status status;
    six_link_call call;
    if (!c || !state || !input || !work || !M_sys || !H_sys || !W_sys) {
        return SIX_LINK_BAD_ARGUMENT;
    }
    call = call_of(c, state, input, work);
    call.M = M_sys;
    call.H = H_sys;
    call.W = W_sys;
    modal_terms(c, state, 0, work);
    if (!finite_input(state, input)) {
        return SIX_LINK_NONFINITE;
    }
    status = six_link_assembly(c, &call, &work->chain, &work->fault);
    if (status != SIX_LINK_OK) {
        return moderate_state(state, work) ? status : SIX_LINK_NONFINITE;
    }
    if (!six_link_finite(M_sys, SIX_LINK_NNZ) || !six_link_finite(H_sys, SIX_LINK_NZ)
        || !six_link_finite(W_sys, SIX_LINK_NZ)) {
        return SIX_LINK_NONFINITE;
    }
    return SIX_LINK_OK;
}
