/* check.c: compares the compiled model with recorded reference values; exit status 0 if all agree.
 *
 * It checks both forms, the rates of every integrator, its order (in double), and the refusal of bad arguments,
 * non-finite input and non-finite results.
 */
#include <stdio.h>
#include <string.h>

#include "ella_reference.h"

/* Five times the rounding error of the reference states in this precision; at least 1e-10 (double) or 1e-4 (float), at
 * most 1e-2.
 */
static const ella_real TOLERANCE = sizeof(ella_real) == sizeof(float) ? REAL(4e-03) : REAL(1e-10);

static ella_parameters parameters;
static ella_constants constants;
static ella_work work;
static ella_dae_work dae_work;
static int failures;

static void verdict(const char *what, int number, int good)
{
    if (!good) {
        printf("  FAILED %s, case %d\n", what, number);
        ++failures;
    }
}

static ella_real magnitude(ella_real x)
{
    return x < 0 ? -x : x;
}

static ella_real larger(ella_real a, ella_real b)
{
    return a > b || a != a ? a : b; /* NaN is the largest of all */
}

/* The largest deviation of count numbers, beginning at first with a stride, over the largest reference among them. */
static ella_real deviation(const ella_real *x, const ella_real *reference, int count, int stride)
{
    ella_real error = 0, scale = 0;
    int i;
    for (i = 0; i < count; ++i) {
        error = larger(magnitude(x[i * stride] - reference[i * stride]), error);
        scale = larger(magnitude(reference[i * stride]), scale);
    }
    return scale > REAL(1e-6) ? error / scale : error;
}

/* Joint and modal accelerations, each component of the wrenches, and the pose, each over its own size. */
static ella_real compare(const ella_output *y, const ella_output *r)
{
    ella_real worst = deviation(y->vdot, r->vdot, ELLA_NTAU, 1);
    int k;
    worst = larger(deviation(y->vdot + ELLA_NTAU, r->vdot + ELLA_NTAU, ELLA_NMODES, 1), worst);
    for (k = 0; k < 3; ++k) {
        worst = larger(deviation(&y->wrench[0][k + 3], &r->wrench[0][k + 3], ELLA_NLINKS, 6), worst);
    }
    worst = larger(deviation(&y->tip_rotation[0][0], &r->tip_rotation[0][0], 9, 1), worst);
    return larger(deviation(y->tip_position, r->tip_position, 3, 1), worst);
}

/* M_sys z + H_sys - W_sys with z from the elimination, over the sizes of its terms. */
static ella_real residual(const ella_dae_state *dae, const ella_input *input)
{
    static ella_real M[ELLA_NNZ], H[ELLA_NZ], W[ELLA_NZ], z[ELLA_NZ], size[ELLA_NZ];
    static ella_output y;
    ella_real worst = 0, scale = 0;
    int i, k;
    if (ella_dae_forward_dynamics(&constants, dae, input, &dae_work, &y) != ELLA_OK) {
        return 1;
    }
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            z[12 * i + k] = y.wrench[i][k];
            z[12 * i + 6 + k] = dae_work.Vdot[i][k];
        }
    }
    for (k = 0; k < ELLA_NMODES; ++k) {
        z[12 * ELLA_NLINKS + k] = y.vdot[ELLA_NTAU + k];
    }
    if (ella_assemble(&constants, dae, input, &dae_work, M, H, W) != ELLA_OK) {
        return 1;
    }
    for (i = 0; i < ELLA_NZ; ++i) {
        H[i] -= W[i];
        size[i] = magnitude(H[i]);
    }
    for (i = 0; i < ELLA_NZ; ++i) {
        for (k = ella_M_column[i]; k < ella_M_column[i + 1]; ++k) {
            H[ella_M_row[k]] += M[k] * z[i];
            size[ella_M_row[k]] += magnitude(M[k] * z[i]);
        }
    }
    for (i = 0; i < ELLA_NZ; ++i) {
        scale = larger(size[i], scale);
        worst = larger(magnitude(H[i]), worst);
    }
    return scale > 0 ? worst / scale : worst;
}

static ella_real run_case(int number)
{
    const ella_case *r = &ella_cases[number];
    ella_output y;
    ella_dae_state dae;
    ella_real joint, form;
    memset(&y, 0, sizeof y);
    verdict("forward dynamics", number,
        ella_forward_dynamics(&constants, &r->state, &r->input, &work, &y) == ELLA_OK);
    joint = compare(&y, &r->output);
    verdict("joint form", number, joint <= TOLERANCE);
    memset(&y, 0, sizeof y);
    verdict("DAE state", number, ella_dae_from_state(&constants, &r->state, &dae_work, &dae) == ELLA_OK);
    verdict("DAE dynamics", number,
        ella_dae_forward_dynamics(&constants, &dae, &r->input, &dae_work, &y) == ELLA_OK);
    form = compare(&y, &r->output);
    verdict("DAE form", number, form <= TOLERANCE);
    verdict("assembled system", number, residual(&dae, &r->input) <= TOLERANCE);
    return larger(form, joint);
}

/* A step short enough for stiff modes. Rounding would hide its effect in float, so it is checked in double only. */
static const ella_real SHORT = REAL(1e-8);
static const ella_real SLACK = REAL(0.01);

typedef ella_status (*step)(const ella_constants *, ella_state *, const ella_input *, ella_real, ella_work *);
typedef ella_status (*dae_step)(const ella_constants *, ella_dae_state *, const ella_input *, ella_real,
    ella_dae_work *);

/* A short step moves the state by its rates: deviation of the observed rates, over the rates. */
static void check_speed(int number, step method)
{
    const ella_case *r = &ella_cases[ELLA_CASES - 1];
    const ella_real dt = SHORT;
    ella_state state = r->state;
    ella_real error = 0, scale = 0, slip;
    int k;
    verdict("short step", number, method(&constants, &state, &r->input, dt, &work) == ELLA_OK);
    for (k = 0; k < ELLA_NV; ++k) {
        error = larger(magnitude((state.v[k] - r->state.v[k]) / dt - r->output.vdot[k]), error);
        scale = larger(magnitude(r->output.vdot[k]), scale);
    }
    verdict("speed of the rates", number, error <= SLACK * scale);
    slip = dt * scale;
    error = 0;
    scale = 0;
    for (k = 0; k < ELLA_NQ; ++k) {
        error = larger(magnitude((state.q[k] - r->state.q[k]) / dt - r->state.v[k]), error);
        scale = larger(magnitude(r->state.v[k]), scale);
    }
    verdict("speed of the coordinates", number, error <= SLACK * scale + 2 * slip);
}

/* A short step of the DAE form agrees with the joint form's. */
static void check_dae_speed(int number, dae_step method, step joint)
{
    const ella_case *r = &ella_cases[ELLA_CASES - 1];
    const ella_real dt = SHORT;
    static ella_dae_state start, moved, expected;
    ella_state state = r->state;
    ella_real error = 0, scale = 0;
    int i, k;
    ella_dae_from_state(&constants, &r->state, &dae_work, &start);
    moved = start;
    verdict("short DAE step", number, method(&constants, &moved, &r->input, dt, &dae_work) == ELLA_OK);
    joint(&constants, &state, &r->input, dt, &work);
    ella_dae_from_state(&constants, &state, &dae_work, &expected);
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            error = larger(magnitude(moved.twist[i][k] - expected.twist[i][k]), error);
            scale = larger(magnitude(expected.twist[i][k] - start.twist[i][k]), scale);
        }
    }
    verdict("speed of the twists", number, error <= SLACK * scale);
    error = 0;
    scale = 0;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = 0; k < 4; ++k) {
            error = larger(magnitude(moved.quaternion[i][k] - expected.quaternion[i][k]), error);
            scale = larger(magnitude(expected.quaternion[i][k] - start.quaternion[i][k]), scale);
        }
    }
    verdict("speed of the poses", number, error <= SLACK * scale);
}

/* ---- The order of an integrator, from the error's reduction when a step is halved. A wrong weight or length leaves
 * order one.
 */

enum { ELLA_MOVED = 6 * ELLA_NLINKS + ELLA_NV };

/* The state of a step: of the joint form, or of the DAE form if dae_method is not null. */
typedef struct {
    step method;
    dae_step dae_method;
    int rates; /* 1: v, or twists and modal rates; 0: the coordinates */
} motion;

static const ella_real *after_joint(const motion *m, ella_real dt, int n, ella_status *status)
{
    static ella_state state;
    int i;
    state = ella_cases[ELLA_CASES - 1].state;
    for (i = 0; i < n && *status == ELLA_OK; ++i) {
        *status = m->method(&constants, &state, &ella_cases[ELLA_CASES - 1].input, dt, &work);
    }
    return m->rates ? state.v : state.q;
}

static const ella_real *after_dae(const motion *m, ella_real dt, int n, ella_status *status)
{
    static ella_real moved[ELLA_MOVED];
    static ella_dae_state state;
    const ella_real *joints = m->rates ? &state.twist[0][0] : state.q, *modes = m->rates ? state.etadot : state.eta;
    const int many = m->rates ? 6 * ELLA_NLINKS : ELLA_NTAU;
    int i;
    *status = ella_dae_from_state(&constants, &ella_cases[ELLA_CASES - 1].state, &dae_work, &state);
    for (i = 0; i < n && *status == ELLA_OK; ++i) {
        *status = m->dae_method(&constants, &state, &ella_cases[ELLA_CASES - 1].input, dt, &dae_work);
    }
    memset(moved, 0, sizeof moved);
    memcpy(moved, joints, (size_t)many * sizeof *moved);
    memcpy(moved + many, modes, ELLA_NMODES * sizeof *moved);
    return moved;
}

/* The difference between one step over dt and two half steps; scale: the largest change of a number. */
static ella_real halving(const motion *m, ella_real dt, ella_real *change, ella_real *scale)
{
    const int count = m->dae_method ? ELLA_MOVED : ELLA_NV;
    ella_status status = ELLA_OK;
    const ella_real *end = m->dae_method ? after_dae(m, dt, 1, &status) : after_joint(m, dt, 1, &status);
    ella_real worst = status == ELLA_OK ? 0 : 1;
    int k;
    for (k = 0; k < count; ++k) {
        change[k] = end[k];
    }
    end = m->dae_method ? after_dae(m, dt / 2, 2, &status) : after_joint(m, dt / 2, 2, &status);
    *scale = 0;
    for (k = 0; k < count; ++k) {
        change[k] -= end[k];
        worst = larger(magnitude(change[k]), worst);
        *scale = larger(magnitude(end[k]), *scale);
    }
    return worst;
}

/* A step over which no acceleration changes much, found by Euler steps. */
static ella_real shortness(void)
{
    static const motion euler = { ella_step_euler, 0, 1 };
    const ella_real *start = ella_cases[ELLA_CASES - 1].state.v, *end;
    static ella_real change[ELLA_MOVED];
    ella_real dt = REAL(0.02), scale;
    int tries, k, steady = 0;
    for (tries = 0; tries < 24 && !steady; ++tries) {
        ella_status status = ELLA_OK;
        dt /= 2;
        (void)halving(&euler, dt, change, &scale);
        end = after_joint(&euler, dt, 1, &status);
        steady = status == ELLA_OK;
        for (k = 0; k < ELLA_NV; ++k) {
            steady = steady && magnitude(change[k]) <= REAL(0.01) * magnitude(end[k] - start[k]);
        }
    }
    return dt;
}

/* One of three step lengths suffices, because the leading error term may vanish. Errors below rounding are ignored. */
static int has_order(int order, const motion *m, ella_real dt)
{
    static ella_real change[ELLA_MOVED];
    ella_real gain = REAL(1.4); /* ideally 2, times 2 for every further order */
    ella_real scale, half, whole = halving(m, dt, change, &scale);
    int tries, good = whole <= 20000 * ELLA_REAL_EPSILON * scale;
    for (tries = 0; tries < order; ++tries) {
        gain *= 2;
    }
    for (tries = 0; tries < 3 && !good; ++tries) {
        dt /= 2;
        half = halving(m, dt, change, &scale);
        good = gain * half <= whole;
        whole = half;
    }
    return good;
}

/* All methods with correct rates are of order one. */
static void check_order(int number, int order, step method, dae_step dae_method, ella_real dt)
{
    motion m = { 0 };
    for (m.rates = 0; m.rates < 2 && order > 1; ++m.rates) {
        m.method = method;
        m.dae_method = 0;
        verdict("order of the step", number, has_order(order, &m, dt));
        m.dae_method = dae_method;
        verdict("order of the DAE step", number, has_order(order, &m, dt));
    }
}

static void check_refusals(int number, step method)
{
    const ella_case *r = &ella_cases[0];
    ella_state state = r->state;
    ella_input input = r->input;
    verdict("refusal of a null pointer", number, method(&constants, 0, &input, REAL(1e-3), &work) == ELLA_BAD_ARGUMENT);
    verdict("refusal of a zero step", number, method(&constants, &state, &input, 0, &work) == ELLA_BAD_ARGUMENT);
    input.w_ext[ELLA_NLINKS - 1][5] = (ella_real)NAN;
    verdict("refusal of NaN", number, method(&constants, &state, &input, REAL(1e-3), &work) == ELLA_NONFINITE);
    verdict("state left as it was", number, memcmp(&state, &r->state, sizeof state) == 0);
    verdict("step", number, method(&constants, &state, &r->input, REAL(1e-4), &work) == ELLA_OK);
}

static void check_dae_refusals(int number, dae_step method)
{
    const ella_case *r = &ella_cases[0];
    ella_dae_state state, before;
    ella_input input = r->input;
    ella_dae_from_state(&constants, &r->state, &dae_work, &state);
    before = state;
    verdict("DAE refusal of a zero step", number,
        method(&constants, &state, &input, 0, &dae_work) == ELLA_BAD_ARGUMENT);
    input.w_ext[0][0] = (ella_real)NAN;
    verdict("DAE refusal of NaN", number, method(&constants, &state, &input, REAL(1e-3), &dae_work) == ELLA_NONFINITE);
    verdict("DAE state left as it was", number, memcmp(&state, &before, sizeof state) == 0);
    verdict("DAE step", number, method(&constants, &state, &r->input, REAL(1e-4), &dae_work) == ELLA_OK);
}

int main(void)
{
    static const step steps[] = { ella_step_euler, ella_step_semi_implicit, ella_step_modal_implicit,
        ella_step_modal_midpoint, ella_step_rk4 };
    static const dae_step dae_steps[] = { ella_dae_step_euler, ella_dae_step_semi_implicit,
        ella_dae_step_modal_implicit, ella_dae_step_modal_midpoint, ella_dae_step_rk4 };
    static const int ORDERS[] = { 1, 1, 1, 2, 4 };
    ella_real worst = 0;
    int i;
    ella_parameters_default(&parameters);
    verdict("prepare", 0, ella_prepare(&parameters, &constants) == ELLA_OK);
    for (i = 0; i < ELLA_CASES; ++i) {
        worst = larger(run_case(i), worst);
    }
    if (ELLA_REAL_EPSILON < SHORT) {
        const ella_real reach = shortness();
        for (i = 0; i < 5; ++i) {
            check_speed(i, steps[i]);
            check_dae_speed(i, dae_steps[i], steps[i]);
            check_order(i, ORDERS[i], steps[i], dae_steps[i], reach);
        }
    }
    for (i = 0; i < 5; ++i) {
        check_refusals(i, steps[i]);
        check_dae_refusals(i, dae_steps[i]);
    }
    printf("ella: largest relative deviation %.1e (allowed %.0e), %s\n", (double)worst, (double)TOLERANCE,
        failures ? "FAILED" : "all checks passed");
    return failures != 0;
}
