/* ella_dae.c: the DAE form. Poses move by the exponential map of SE(3); every step ends with a projection. */
#include "ella_links.h"
#include "ella_se3.h"

/* Inertia and force of n coordinates x, implicit over dt; `first` is the first of their columns. */
static void own_terms(const ella_constants *c, int first, int n, const ella_real *x, const ella_real *xdot,
    ella_real dt,
    ella_dae_work *work)
{
    int k;
    for (k = 0; k < n; ++k) {
        const ella_real K = c->K[first + k], D = c->D[first + k];
        work->m_eta[first + k] = c->M_eta[first + k] + dt * (D + dt * K);
        work->f_eta[first + k] = K * (x[k] + dt * xdot[k]) + D * xdot[k];
    }
}

static void modal_terms(const ella_constants *c, const ella_dae_state *s, ella_real dt, ella_dae_work *work)
{
    own_terms(c, ELLA_NGIVEN - ELLA_NMODES, ELLA_NMODES, s->eta, s->etadot, dt, work);
}

static ella_call call_of(const ella_constants *c, const ella_dae_state *s, const ella_input *u, ella_dae_work *work)
{
    ella_call call = { 0 };
    call.gravity = c->gravity;
    call.q = s->q;
    call.eta = s->eta;
    call.etadot = s->etadot;
    call.quaternion = &s->quaternion[0][0];
    call.twist = &s->twist[0][0];
    call.m_eta = work->m_eta + (ELLA_NGIVEN - ELLA_NMODES);
    call.f_eta = work->f_eta + (ELLA_NGIVEN - ELLA_NMODES);
    call.new_qdot = work->qdot;
    call.qdot = work->qdot;
    if (u) {
        call.tau = u->tau;
        call.w_ext = &u->w_ext[0][0];
    }
    return call;
}

static int finite_state(const ella_dae_state *s)
{
    return ella_finite(&s->quaternion[0][0], 4 * ELLA_NLINKS) && ella_finite(&s->position[0][0], 3 * ELLA_NLINKS)
        && ella_finite(&s->twist[0][0], 6 * ELLA_NLINKS) && ella_finite(s->eta, ELLA_NMODES)
        && ella_finite(s->etadot, ELLA_NMODES) && ella_finite(s->q, ELLA_NTAU);
}

/* Whether products of three entries are finite. If not, a failed pivot does not mean a singular posture. */
static int moderate_state(const ella_dae_state *s, const ella_dae_work *work)
{
    return ella_moderate(&s->twist[0][0], 6 * ELLA_NLINKS) && ella_moderate(s->eta, ELLA_NMODES)
        && ella_moderate(s->etadot, ELLA_NMODES) && ella_finite(work->m_eta + (ELLA_NGIVEN - ELLA_NMODES), ELLA_NMODES);
}

static int finite_input(const ella_dae_state *s, const ella_input *u)
{
    return finite_state(s) && ella_finite(u->tau, ELLA_NTAU) && ella_finite(&u->w_ext[0][0], 6 * ELLA_NLINKS);
}

/* Vdot, etaddot, qdot and the wrenches at s, with the modal forces implicit, dt after the state from. */
static ella_status accelerate(const ella_constants *c, const ella_dae_state *s, const ella_dae_state *from,
    const ella_input *u, ella_real dt, ella_dae_work *work)
{
    ella_status status;
    ella_call call = call_of(c, s, u, work);
    call.new_qddot = work->qddot;
    call.new_etaddot = work->etaddot;
    call.new_wrench = &work->wrench[0][0];
    call.new_alpha = &work->alpha[0][0];
    call.alpha = &work->alpha[0][0];
    call.new_Vdot = &work->Vdot[0][0];
    if (!finite_input(s, u)) {
        return ELLA_NONFINITE;
    }
    modal_terms(c, from, dt, work);
    status = ella_dae_dynamics(c, &call, &work->chain, &work->fault);
    if (status != ELLA_OK) {
        return moderate_state(s, work) ? status : ELLA_NONFINITE;
    }
    if (!ella_finite(&work->Vdot[0][0], 6 * ELLA_NLINKS) || !ella_finite(work->etaddot, ELLA_NMODES)
        || !ella_finite(&work->wrench[0][0], 6 * ELLA_NLINKS)) {
        return ELLA_NONFINITE;
    }
    return ELLA_OK;
}

/* Projection of the state onto the joint constraints: q from the poses, then forward kinematics. */
static ella_status project(const ella_constants *c, ella_dae_state *s, ella_dae_work *work)
{
    ella_call call = call_of(c, s, 0, work);
    ella_status status;
    call.new_q = s->q;
    call.new_quaternion = &s->quaternion[0][0];
    call.new_position = &s->position[0][0];
    call.new_twist = &s->twist[0][0];
    status = ella_projection(c, &call, &work->chain, &work->fault);
    if (!finite_state(s)) {
        return ELLA_NONFINITE;
    }
    return status;
}

ella_status ella_dae_from_state(const ella_constants *c, const ella_state *state, ella_dae_work *work,
    ella_dae_state *dae)
{
    ella_call call;
    ella_status status;
    int k;
    if (!c || !state || !work || !dae) {
        return ELLA_BAD_ARGUMENT;
    }
    for (k = 0; k < ELLA_NTAU; ++k) {
        work->next.q[k] = state->q[k];
        work->qdot[k] = state->v[k];
    }
    for (k = 0; k < ELLA_NMODES; ++k) {
        work->next.eta[k] = state->q[ELLA_NQ - ELLA_NMODES + k];
        work->next.etadot[k] = state->v[ELLA_NV - ELLA_NMODES + k];
    }
    call = call_of(c, &work->next, 0, work);
    call.new_quaternion = &work->next.quaternion[0][0];
    call.new_position = &work->next.position[0][0];
    call.new_twist = &work->next.twist[0][0];
    status = ella_placement(c, &call, &work->chain, &work->fault);
    if (status == ELLA_OK && !finite_state(&work->next)) {
        status = ELLA_NONFINITE;
    }
    if (status == ELLA_OK) {
        *dae = work->next;
    }
    return status;
}

ella_status ella_dae_forward_dynamics(const ella_constants *c, const ella_dae_state *state,
    const ella_input *input, ella_dae_work *work, ella_output *output)
{
    ella_status status;
    ella_call call;
    int i, k;
    if (!c || !state || !input || !work || !output) {
        return ELLA_BAD_ARGUMENT;
    }
    status = accelerate(c, state, state, input, 0, work);
    if (status != ELLA_OK) {
        return status;
    }
    for (k = 0; k < ELLA_NTAU; ++k) {
        output->vdot[k] = work->qddot[k];
    }
    for (k = 0; k < ELLA_NMODES; ++k) {
        output->vdot[ELLA_NV - ELLA_NMODES + k] = work->etaddot[k];
    }
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            output->wrench[i][k] = work->wrench[i][k];
        }
    }
    work->next = *state;
    call = call_of(c, state, 0, work);
    call.new_quaternion = &work->next.quaternion[0][0];
    call.new_position = &work->next.position[0][0];
    call.new_twist = &work->next.twist[0][0];
    status = ella_placement(c, &call, &work->chain, &work->fault);
    for (i = 0; i < 3; ++i) {
        for (k = 0; k < 3; ++k) {
            output->tip_rotation[i][k] = work->chain.nodes[ELLA_NLINKS].R[3 * i + k];
        }
        output->tip_position[i] = work->chain.nodes[ELLA_NLINKS].r[i];
    }
    return status;
}

/* y = x + dt * rates for all but the poses; the rates of eta are the given state's etadot. */
static void advance(const ella_dae_state *x, ella_real dt, const ella_real *etadot, const ella_dae_work *work,
    ella_dae_state *y)
{
    int i, k;
    for (k = 0; k < ELLA_NMODES; ++k) {
        y->eta[k] = x->eta[k] + dt * etadot[k];
        y->etadot[k] = x->etadot[k] + dt * work->etaddot[k];
    }
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            y->twist[i][k] = x->twist[i][k] + dt * work->Vdot[i][k];
        }
    }
    for (k = 0; k < ELLA_NTAU; ++k) {
        y->q[k] = x->q[k] + dt * work->qdot[k];
    }
}

/* The vectors u that move the poses: u = dt V, or u += dt V. */
static void set_turn(ella_real dt, ella_real V[][6], ella_real u[][6])
{
    int i, k;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            u[i][k] = dt * V[i][k];
        }
    }
}

static void add_turn(ella_real dt, ella_real V[][6], ella_real u[][6])
{
    int i, k;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            u[i][k] += dt * V[i][k];
        }
    }
}

/* Replaces u by its rate at the twists of the state to which it moves the poses. */
static void turn_rates(const ella_dae_state *s, ella_real u[][6])
{
    ella_real rate[6];
    int i, k;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        algebra_rate(u[i], s->twist[i], rate);
        for (k = 0; k < 6; ++k) {
            u[i][k] = rate[k];
        }
    }
}

/* The poses of y are those of x times exp(u). */
static void move(const ella_dae_state *x, ella_real u[][6], ella_dae_state *y)
{
    int i;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        exponential(x->quaternion[i], x->position[i], u[i], y->quaternion[i], y->position[i]);
    }
}

/* y from x over dt: poses and modal coordinates by the rates after `kick`, rates over all of dt; joint coordinates by
 * the rates of the last accelerations `lead` later. u is what moves the poses.
 */
static void leap(const ella_dae_state *x, ella_real dt, ella_real kick, ella_real lead, const ella_dae_work *work,
    ella_real u[][6], ella_dae_state *y)
{
    int i, k;
    for (k = 0; k < ELLA_NMODES; ++k) {
        y->eta[k] = x->eta[k] + dt * (x->etadot[k] + kick * work->etaddot[k]);
        y->etadot[k] = x->etadot[k] + dt * work->etaddot[k];
    }
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            u[i][k] = dt * (x->twist[i][k] + kick * work->Vdot[i][k]);
            y->twist[i][k] = x->twist[i][k] + dt * work->Vdot[i][k];
        }
    }
    for (k = 0; k < ELLA_NTAU; ++k) {
        y->q[k] = x->q[k] + dt * (work->qdot[k] + lead * work->qddot[k]);
    }
    move(x, u, y);
}

static int bad_step(const ella_constants *c, const ella_dae_state *s, const ella_input *u, ella_real dt,
    const ella_dae_work *work)
{
    return !c || !s || !u || !work || !ella_is_step(dt);
}

/* Projects the new state, which is accepted only if that succeeds. */
static ella_status accept(const ella_constants *c, ella_dae_work *work, ella_dae_state *state)
{
    const ella_status status = project(c, &work->next, work);
    if (status == ELLA_OK) {
        *state = work->next;
    }
    return status;
}

/* euler: forward Euler, explicit, order 1. */
ella_status ella_dae_step_euler(const ella_constants *c, ella_dae_state *state, const ella_input *input,
    ella_real dt, ella_dae_work *work)
{
    ella_status status;
    if (bad_step(c, state, input, dt, work)) {
        return ELLA_BAD_ARGUMENT;
    }
    status = accelerate(c, state, state, input, 0, work);
    if (status != ELLA_OK) {
        return status;
    }
    advance(state, dt, state->etadot, work, &work->next);
    set_turn(dt, state->twist, work->next_turn);
    move(state, work->next_turn, &work->next);
    return accept(c, work, state);
}

/* semi_implicit: rates first, then coordinates with the new rates, order 1. */
ella_status ella_dae_step_semi_implicit(const ella_constants *c, ella_dae_state *state, const ella_input *input,
    ella_real dt, ella_dae_work *work)
{
    ella_status status;
    if (bad_step(c, state, input, dt, work)) {
        return ELLA_BAD_ARGUMENT;
    }
    status = accelerate(c, state, state, input, 0, work);
    if (status != ELLA_OK) {
        return status;
    }
    leap(state, dt, dt, dt, work, work->next_turn, &work->next);
    return accept(c, work, state);
}

/* modal_implicit: semi_implicit with the elastic forces at the step's end, stable for stiff modes, order 1. */
ella_status ella_dae_step_modal_implicit(const ella_constants *c, ella_dae_state *state, const ella_input *input,
    ella_real dt, ella_dae_work *work)
{
    ella_status status;
    if (bad_step(c, state, input, dt, work)) {
        return ELLA_BAD_ARGUMENT;
    }
    status = accelerate(c, state, state, input, dt, work);
    if (status != ELLA_OK) {
        return status;
    }
    leap(state, dt, dt, dt, work, work->next_turn, &work->next);
    return accept(c, work, state);
}

/* modal_midpoint: midpoint rule with implicit elastic forces, stable for stiff modes, two forward dynamics, order 2. */
ella_status ella_dae_step_modal_midpoint(const ella_constants *c, ella_dae_state *state, const ella_input *input,
    ella_real dt, ella_dae_work *work)
{
    const ella_real half = dt / 2;
    ella_status status;
    if (bad_step(c, state, input, dt, work)) {
        return ELLA_BAD_ARGUMENT;
    }
    /* Stage 1. */
    status = accelerate(c, state, state, input, half, work);
    if (status != ELLA_OK) {
        return status;
    }
    leap(state, half, half, half, work, work->stage_turn, &work->stage);
    /* Stage 2, the terms of the elastic forces as before. */
    status = accelerate(c, &work->stage, state, input, half, work);
    if (status != ELLA_OK) {
        return status;
    }
    leap(state, dt, half, 0, work, work->next_turn, &work->next);
    return accept(c, work, state);
}

/* rk4: classical Runge-Kutta, four forward dynamics, order 4. */
ella_status ella_dae_step_rk4(const ella_constants *c, ella_dae_state *state, const ella_input *input,
    ella_real dt, ella_dae_work *work)
{
    const ella_real half = dt / 2, third = dt / 3, sixth = dt / 6;
    ella_status status;
    if (bad_step(c, state, input, dt, work)) {
        return ELLA_BAD_ARGUMENT;
    }
    /* Stage 1. */
    status = accelerate(c, state, state, input, 0, work);
    if (status != ELLA_OK) {
        return status;
    }
    advance(state, sixth, state->etadot, work, &work->next);
    set_turn(sixth, state->twist, work->next_turn);
    advance(state, half, state->etadot, work, &work->stage);
    set_turn(half, state->twist, work->stage_turn);
    move(state, work->stage_turn, &work->stage);
    /* Stage 2. */
    status = accelerate(c, &work->stage, &work->stage, input, 0, work);
    if (status != ELLA_OK) {
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
    if (status != ELLA_OK) {
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
    if (status != ELLA_OK) {
        return status;
    }
    turn_rates(&work->stage, work->stage_turn);
    advance(&work->next, sixth, work->stage.etadot, work, &work->next);
    add_turn(sixth, work->stage_turn, work->next_turn);
    move(state, work->next_turn, &work->next);
    return accept(c, work, state);
}

/* ------------------------------------------------------------------------------------ M_sys, H_sys, W_sys */

const short ella_M_row[ELLA_NNZ] = {
    0, 1, 6, 0, 1, 7, 2, 8, 9, 10, 11, 0, 1, 6, 7, 8, 9, 10, 11, 12,
    13, 15, 16, 17, 24, 25, 26, 27, 28, 29, 30, 0, 1, 6, 7, 8, 9, 10, 11, 12,
    13, 15, 16, 17, 24, 25, 26, 27, 28, 29, 6, 7, 8, 9, 10, 11, 12, 13, 15, 16,
    17, 24, 25, 26, 27, 28, 29, 3, 6, 7, 8, 9, 10, 11, 15, 16, 17, 24, 25, 26,
    27, 28, 29, 4, 6, 7, 8, 9, 10, 11, 15, 16, 17, 24, 25, 26, 27, 28, 29, 5,
    6, 7, 8, 9, 10, 11, 15, 16, 17, 24, 25, 26, 27, 28, 29, 6, 7, 8, 18, 24,
    25, 26, 27, 28, 29, 30, 6, 7, 8, 19, 24, 25, 26, 27, 28, 29, 30, 6, 7, 8,
    14, 20, 24, 25, 26, 27, 28, 29, 30, 6, 7, 8, 9, 10, 11, 21, 24, 25, 26, 27,
    28, 29, 6, 7, 8, 9, 10, 11, 22, 24, 25, 26, 27, 28, 29, 6, 7, 8, 9, 10,
    11, 23, 24, 25, 26, 27, 28, 29, 12, 18, 19, 20, 21, 22, 23, 31, 32, 33, 34, 35,
    36, 37, 13, 18, 19, 20, 21, 22, 23, 31, 32, 33, 34, 35, 36, 18, 19, 20, 21, 22,
    23, 31, 32, 33, 34, 35, 36, 15, 18, 19, 20, 21, 22, 23, 31, 32, 33, 34, 35, 36,
    16, 18, 19, 20, 21, 22, 23, 31, 32, 33, 34, 35, 36, 17, 18, 19, 20, 21, 22, 23,
    31, 32, 33, 34, 35, 36, 6, 7, 8, 9, 10, 11, 12, 13, 15, 16, 17, 24, 25, 26,
    27, 28, 29, 6, 7, 8, 9, 10, 11, 12, 13, 15, 16, 17, 24, 25, 26, 27, 28, 29,
    6, 7, 8, 9, 10, 11, 12, 13, 15, 16, 17, 24, 25, 26, 27, 28, 29, 6, 7, 8,
    9, 10, 11, 12, 13, 15, 16, 17, 24, 25, 26, 27, 28, 29, 6, 7, 8, 9, 10, 11,
    12, 13, 15, 16, 17, 24, 25, 26, 27, 28, 29, 6, 7, 8, 9, 10, 11, 12, 13, 15,
    16, 17, 24, 25, 26, 27, 28, 29, 6, 12, 13, 30, 18, 19, 20, 21, 22, 23, 31, 32,
    33, 34, 35, 36, 18, 19, 20, 21, 22, 23, 31, 32, 33, 34, 35, 36, 18, 19, 20, 21,
    22, 23, 31, 32, 33, 34, 35, 36, 18, 19, 20, 21, 22, 23, 31, 32, 33, 34, 35, 36,
    18, 19, 20, 21, 22, 23, 31, 32, 33, 34, 35, 36, 18, 19, 20, 21, 22, 23, 31, 32,
    33, 34, 35, 36, 18, 37,
};

const int ella_M_column[ELLA_NZ + 1] = {
    0, 3, 6, 8, 9, 10, 11, 31, 50, 67, 83, 99, 115, 126, 137, 149, 162, 175, 188, 202,
    215, 227, 240, 253, 266, 283, 300, 317, 334, 351, 368, 372, 384, 396, 408, 420, 432, 444, 446,
};

ella_status ella_assemble(const ella_constants *c, const ella_dae_state *state, const ella_input *input,
    ella_dae_work *work, ella_real M_sys[ELLA_NNZ], ella_real H_sys[ELLA_NZ],
    ella_real W_sys[ELLA_NZ])
{
    ella_status status;
    ella_call call;
    if (!c || !state || !input || !work || !M_sys || !H_sys || !W_sys) {
        return ELLA_BAD_ARGUMENT;
    }
    call = call_of(c, state, input, work);
    call.M = M_sys;
    call.H = H_sys;
    call.W = W_sys;
    modal_terms(c, state, 0, work);
    if (!finite_input(state, input)) {
        return ELLA_NONFINITE;
    }
    status = ella_assembly(c, &call, &work->chain, &work->fault);
    if (status != ELLA_OK) {
        return moderate_state(state, work) ? status : ELLA_NONFINITE;
    }
    if (!ella_finite(M_sys, ELLA_NNZ) || !ella_finite(H_sys, ELLA_NZ) || !ella_finite(W_sys, ELLA_NZ)) {
        return ELLA_NONFINITE;
    }
    return ELLA_OK;
}
