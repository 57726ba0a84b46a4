/* check.c: compares the compiled model with recorded reference values; exit status 0 if all agree.
 *
 * It checks both forms, the rates of every integrator, its order (in double), and the refusal of bad arguments,
 * non-finite input and non-finite results.
 */
#include <stdio.h>
#include <string.h>

#include "six_link_reference.h"

/* Five times the rounding error of the reference states in this precision; at least 1e-10 (double) or 1e-4 (float), at
 * most 1e-2.
 */
static const six_link_real TOLERANCE = sizeof(six_link_real) == sizeof(float) ? REAL(1e-04) : REAL(1e-10);

static six_link_parameters parameters;
static six_link_constants constants;
static six_link_work work;
static six_link_dae_work dae_work;
static int failures;

static void verdict(const char *what, int number, int good)
{
    if (!good) {
        printf("  FAILED %s, case %d\n", what, number);
        ++failures;
    }
}

static six_link_real magnitude(six_link_real x)
{
    return x < 0 ? -x : x;
}

static six_link_real larger(six_link_real a, six_link_real b)
{
    return a > b || a != a ? a : b; /* NaN is the largest of all */
}

/* The largest deviation of count numbers, beginning at first with a stride, over the largest reference among them. */
static six_link_real deviation(const six_link_real *x, const six_link_real *reference, int count, int stride)
{
    six_link_real error = 0, scale = 0;
    int i;
    for (i = 0; i < count; ++i) {
        error = larger(magnitude(x[i * stride] - reference[i * stride]), error);
        scale = larger(magnitude(reference[i * stride]), scale);
    }
    return scale > REAL(1e-6) ? error / scale : error;
}

/* Joint and modal accelerations, each component of the wrenches, and the pose, each over its own size. */
static six_link_real compare(const six_link_output *y, const six_link_output *r)
{
    six_link_real worst = deviation(y->vdot, r->vdot, SIX_LINK_NTAU, 1);
    int k;
    worst = larger(deviation(y->vdot + SIX_LINK_NTAU, r->vdot + SIX_LINK_NTAU, SIX_LINK_NMODES, 1), worst);
    for (k = 0; k < 3; ++k) {
        worst = larger(deviation(&y->wrench[0][k + 3], &r->wrench[0][k + 3], SIX_LINK_NLINKS, 6), worst);
    }
    worst = larger(deviation(&y->tip_rotation[0][0], &r->tip_rotation[0][0], 9, 1), worst);
    return larger(deviation(y->tip_position, r->tip_position, 3, 1), worst);
}

/* M_sys z + H_sys - W_sys with z from the elimination, over the sizes of its terms. */
static six_link_real residual(const six_link_dae_state *dae, const six_link_input *input)
{
    static six_link_real M[SIX_LINK_NNZ], H[SIX_LINK_NZ], W[SIX_LINK_NZ], z[SIX_LINK_NZ], size[SIX_LINK_NZ];
    static six_link_output y;
    six_link_real worst = 0, scale = 0;
    int i, k;
    if (six_link_dae_forward_dynamics(&constants, dae, input, &dae_work, &y) != SIX_LINK_OK) {
        return 1;
    }
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            z[12 * i + k] = y.wrench[i][k];
            z[12 * i + 6 + k] = dae_work.Vdot[i][k];
        }
    }
    for (k = 0; k < SIX_LINK_NMODES; ++k) {
        z[12 * SIX_LINK_NLINKS + k] = y.vdot[SIX_LINK_NTAU + k];
    }
    if (six_link_assemble(&constants, dae, input, &dae_work, M, H, W) != SIX_LINK_OK) {
        return 1;
    }
    for (i = 0; i < SIX_LINK_NZ; ++i) {
        H[i] -= W[i];
        size[i] = magnitude(H[i]);
    }
    for (i = 0; i < SIX_LINK_NZ; ++i) {
        for (k = six_link_M_column[i]; k < six_link_M_column[i + 1]; ++k) {
            H[six_link_M_row[k]] += M[k] * z[i];
            size[six_link_M_row[k]] += magnitude(M[k] * z[i]);
        }
    }
    for (i = 0; i < SIX_LINK_NZ; ++i) {
        scale = larger(size[i], scale);
        worst = larger(magnitude(H[i]), worst);
    }
    return scale > 0 ? worst / scale : worst;
}

static six_link_real run_case(int number)
{
    const six_link_case *r = &six_link_cases[number];
    six_link_output y;
    six_link_dae_state dae;
    six_link_real joint, form;
    memset(&y, 0, sizeof y);
    verdict("forward dynamics", number,
        six_link_forward_dynamics(&constants, &r->state, &r->input, &work, &y) == SIX_LINK_OK);
    joint = compare(&y, &r->output);
    verdict("joint form", number, joint <= TOLERANCE);
    memset(&y, 0, sizeof y);
    verdict("DAE state", number, six_link_dae_from_state(&constants, &r->state, &dae_work, &dae) == SIX_LINK_OK);
    verdict("DAE dynamics", number,
        six_link_dae_forward_dynamics(&constants, &dae, &r->input, &dae_work, &y) == SIX_LINK_OK);
    form = compare(&y, &r->output);
    verdict("DAE form", number, form <= TOLERANCE);
    verdict("assembled system", number, residual(&dae, &r->input) <= TOLERANCE);
    return larger(form, joint);
}

/* A step short enough for stiff modes. Rounding would hide its effect in float, so it is checked in double only. */
static const six_link_real SHORT = REAL(1e-8);
static const six_link_real SLACK = REAL(0.01);

typedef six_link_status (*step)(const six_link_constants *, six_link_state *, const six_link_input *, six_link_real,
    six_link_work *);
typedef six_link_status (*dae_step)(const six_link_constants *, six_link_dae_state *, const six_link_input *,
    six_link_real,
    six_link_dae_work *);

/* A short step moves the state by its rates: deviation of the observed rates, over the rates. */
static void check_speed(int number, step method)
{
    const six_link_case *r = &six_link_cases[SIX_LINK_CASES - 1];
    const six_link_real dt = SHORT;
    six_link_state state = r->state;
    six_link_real error = 0, scale = 0, slip;
    int k;
    verdict("short step", number, method(&constants, &state, &r->input, dt, &work) == SIX_LINK_OK);
    for (k = 0; k < SIX_LINK_NV; ++k) {
        error = larger(magnitude((state.v[k] - r->state.v[k]) / dt - r->output.vdot[k]), error);
        scale = larger(magnitude(r->output.vdot[k]), scale);
    }
    verdict("speed of the rates", number, error <= SLACK * scale);
    slip = dt * scale;
    error = 0;
    scale = 0;
    for (k = 0; k < SIX_LINK_NQ; ++k) {
        error = larger(magnitude((state.q[k] - r->state.q[k]) / dt - r->state.v[k]), error);
        scale = larger(magnitude(r->state.v[k]), scale);
    }
    verdict("speed of the coordinates", number, error <= SLACK * scale + 2 * slip);
}

/* A short step of the DAE form agrees with the joint form's. */
static void check_dae_speed(int number, dae_step method, step joint)
{
    const six_link_case *r = &six_link_cases[SIX_LINK_CASES - 1];
    const six_link_real dt = SHORT;
    static six_link_dae_state start, moved, expected;
    six_link_state state = r->state;
    six_link_real error = 0, scale = 0;
    int i, k;
    six_link_dae_from_state(&constants, &r->state, &dae_work, &start);
    moved = start;
    verdict("short DAE step", number, method(&constants, &moved, &r->input, dt, &dae_work) == SIX_LINK_OK);
    joint(&constants, &state, &r->input, dt, &work);
    six_link_dae_from_state(&constants, &state, &dae_work, &expected);
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            error = larger(magnitude(moved.twist[i][k] - expected.twist[i][k]), error);
            scale = larger(magnitude(expected.twist[i][k] - start.twist[i][k]), scale);
        }
    }
    verdict("speed of the twists", number, error <= SLACK * scale);
    error = 0;
    scale = 0;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
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

enum { SIX_LINK_MOVED = 6 * SIX_LINK_NLINKS + SIX_LINK_NV };

/* The state of a step: of the joint form, or of the DAE form if dae_method is not null. */
typedef struct {
    step method;
    dae_step dae_method;
    int rates; /* 1: v, or twists and modal rates; 0: the coordinates */
} motion;

static const six_link_real *after_joint(const motion *m, six_link_real dt, int n, six_link_status *status)
{
    static six_link_state state;
    int i;
    state = six_link_cases[SIX_LINK_CASES - 1].state;
    for (i = 0; i < n && *status == SIX_LINK_OK; ++i) {
        *status = m->method(&constants, &state, &six_link_cases[SIX_LINK_CASES - 1].input, dt, &work);
    }
    return m->rates ? state.v : state.q;
}

static const six_link_real *after_dae(const motion *m, six_link_real dt, int n, six_link_status *status)
{
    static six_link_real moved[SIX_LINK_MOVED];
    static six_link_dae_state state;
    const six_link_real *joints = m->rates ? &state.twist[0][0] : state.q, *modes = m->rates ? state.etadot : state.eta;
    const int many = m->rates ? 6 * SIX_LINK_NLINKS : SIX_LINK_NTAU;
    int i;
    *status = six_link_dae_from_state(&constants, &six_link_cases[SIX_LINK_CASES - 1].state, &dae_work, &state);
    for (i = 0; i < n && *status == SIX_LINK_OK; ++i) {
        *status = m->dae_method(&constants, &state, &six_link_cases[SIX_LINK_CASES - 1].input, dt, &dae_work);
    }
    memset(moved, 0, sizeof moved);
    memcpy(moved, joints, (size_t)many * sizeof *moved);
    memcpy(moved + many, modes, SIX_LINK_NMODES * sizeof *moved);
    return moved;
}

/* The difference between one step over dt and two half steps; scale: the largest change of a number. */
static six_link_real halving(const motion *m, six_link_real dt, six_link_real *change, six_link_real *scale)
{
    const int count = m->dae_method ? SIX_LINK_MOVED : SIX_LINK_NV;
    six_link_status status = SIX_LINK_OK;
    const six_link_real *end = m->dae_method ? after_dae(m, dt, 1, &status) : after_joint(m, dt, 1, &status);
    six_link_real worst = status == SIX_LINK_OK ? 0 : 1;
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
static six_link_real shortness(void)
{
    static const motion euler = { six_link_step_euler, 0, 1 };
    const six_link_real *start = six_link_cases[SIX_LINK_CASES - 1].state.v, *end;
    static six_link_real change[SIX_LINK_MOVED];
    six_link_real dt = REAL(0.02), scale;
    int tries, k, steady = 0;
    for (tries = 0; tries < 24 && !steady; ++tries) {
        six_link_status status = SIX_LINK_OK;
        dt /= 2;
        (void)halving(&euler, dt, change, &scale);
        end = after_joint(&euler, dt, 1, &status);
        steady = status == SIX_LINK_OK;
        for (k = 0; k < SIX_LINK_NV; ++k) {
            steady = steady && magnitude(change[k]) <= REAL(0.01) * magnitude(end[k] - start[k]);
        }
    }
    return dt;
}

/* One of three step lengths suffices, because the leading error term may vanish. Errors below rounding are ignored. */
static int has_order(int order, const motion *m, six_link_real dt)
{
    static six_link_real change[SIX_LINK_MOVED];
    six_link_real gain = REAL(1.4); /* ideally 2, times 2 for every further order */
    six_link_real scale, half, whole = halving(m, dt, change, &scale);
    int tries, good = whole <= 20000 * SIX_LINK_REAL_EPSILON * scale;
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
static void check_order(int number, int order, step method, dae_step dae_method, six_link_real dt)
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
    const six_link_case *r = &six_link_cases[0];
    six_link_state state = r->state;
    six_link_input input = r->input;
    verdict("refusal of a null pointer", number,
        method(&constants, 0, &input, REAL(1e-3), &work) == SIX_LINK_BAD_ARGUMENT);
    verdict("refusal of a zero step", number, method(&constants, &state, &input, 0, &work) == SIX_LINK_BAD_ARGUMENT);
    input.w_ext[SIX_LINK_NLINKS - 1][5] = (six_link_real)NAN;
    verdict("refusal of NaN", number, method(&constants, &state, &input, REAL(1e-3), &work) == SIX_LINK_NONFINITE);
    verdict("state left as it was", number, memcmp(&state, &r->state, sizeof state) == 0);
    verdict("step", number, method(&constants, &state, &r->input, REAL(1e-4), &work) == SIX_LINK_OK);
}

static void check_dae_refusals(int number, dae_step method)
{
    const six_link_case *r = &six_link_cases[0];
    six_link_dae_state state, before;
    six_link_input input = r->input;
    six_link_dae_from_state(&constants, &r->state, &dae_work, &state);
    before = state;
    verdict("DAE refusal of a zero step", number,
        method(&constants, &state, &input, 0, &dae_work) == SIX_LINK_BAD_ARGUMENT);
    input.w_ext[0][0] = (six_link_real)NAN;
    verdict("DAE refusal of NaN", number,
        method(&constants, &state, &input, REAL(1e-3), &dae_work) == SIX_LINK_NONFINITE);
    verdict("DAE state left as it was", number, memcmp(&state, &before, sizeof state) == 0);
    verdict("DAE step", number, method(&constants, &state, &r->input, REAL(1e-4), &dae_work) == SIX_LINK_OK);
}

int main(void)
{
    static const step steps[] = { six_link_step_euler, six_link_step_semi_implicit, six_link_step_modal_implicit,
        six_link_step_modal_midpoint, six_link_step_rk4 };
    static const dae_step dae_steps[] = { six_link_dae_step_euler, six_link_dae_step_semi_implicit,
        six_link_dae_step_modal_implicit, six_link_dae_step_modal_midpoint, six_link_dae_step_rk4 };
    static const int ORDERS[] = { 1, 1, 1, 2, 4 };
    six_link_real worst = 0;
    int i;
    six_link_parameters_default(&parameters);
    verdict("prepare", 0, six_link_prepare(&parameters, &constants) == SIX_LINK_OK);
    for (i = 0; i < SIX_LINK_CASES; ++i) {
        worst = larger(run_case(i), worst);
    }
    if (SIX_LINK_REAL_EPSILON < SHORT) {
        const six_link_real reach = shortness();
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
    printf("six_link: largest relative deviation %.1e (allowed %.0e), %s\n", (double)worst, (double)TOLERANCE,
        failures ? "FAILED" : "all checks passed");
    return failures != 0;
}
