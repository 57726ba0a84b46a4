/* check.c: compares the compiled model with recorded reference values; exit status 0 if all agree.
 *
 * It checks both forms, a step of every integrator in each, inverse dynamics, mass matrix, kinematics, rest and
 * measures of validity, and the refusal of bad arguments, non-finite input and non-finite results.
 */
#include <stdio.h>
#include <string.h>

#include "ella_reference.h"

/* Three times the rounding error of the reference states in this precision; at least 1e-10 (double) or 1e-4 (float), at
 * most 1e-2.
 */
static const ella_real TOLERANCE = sizeof(ella_real) == sizeof(float) ? ELLA_REAL(3e-03) : ELLA_REAL(1e-10);
/* m: how far frames and tips are from the origin in these states. */
static const ella_real EXTENT = ELLA_REAL(1.4389);
/* For wrenches by inverse dynamics: inertial forces that are large beside them cancel. */
static const ella_real WRENCH_TOLERANCE = sizeof(ella_real) == sizeof(float) ? ELLA_REAL(8e-03) : ELLA_REAL(1e-10);

static ella_parameters parameters;
static ella_constants constants;
static ella_work work;
static ella_dae_work dae_work;
static int failures;

/* Scratch is filled with NaN before a call, because none may need what another one left. */
static void forget(void)
{
    memset(&work, 0xff, sizeof work);
    memset(&dae_work, 0xff, sizeof dae_work);
}

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
    return scale > ELLA_REAL(1e-6) ? error / scale : error;
}

/* The deviation of the weighted sum of count numbers from a reference, over the sum of their sizes. */
static ella_real sum_error(const ella_real *x, int count, ella_real reference)
{
    ella_real sum = -reference, size = 0;
    int k;
    for (k = 0; k < count; ++k) {
        const int place = 7 * k % 97;
        const ella_real weight = 1 + (ella_real)place / 97;
        sum += weight * x[k];
        size += weight * magnitude(x[k]);
    }
    return magnitude(sum) / (size > ELLA_REAL(1e-9) ? size : 1);
}

/* The largest deviation of the joint moments (first = 0) or forces (first = 3), over the largest of them. */
static ella_real wrench_deviation(const ella_real w[][6], const ella_real reference[][6], int first)
{
    ella_real error = 0, scale = 0;
    int i, k;
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = first; k < first + 3; ++k) {
            error = larger(magnitude(w[i][k] - reference[i][k]), error);
            scale = larger(magnitude(reference[i][k]), scale);
        }
    }
    return scale > ELLA_REAL(1e-6) ? error / scale : error;
}

/* Joint and modal accelerations, moments, each component of the forces, and the tip's axes, each over its own size; its
 * position over the robot's.
 */
static ella_real compare(const ella_output *y, const ella_output *r)
{
    ella_real worst = deviation(y->vdot, r->vdot, ELLA_NV - ELLA_NMODES, 1);
    int k;
    worst = larger(deviation(y->vdot + (ELLA_NV - ELLA_NMODES), r->vdot + (ELLA_NV - ELLA_NMODES), ELLA_NMODES, 1),
        worst);
    worst = larger(wrench_deviation(y->wrench, r->wrench, 0), worst);
    for (k = 0; k < 3; ++k) {
        worst = larger(deviation(&y->wrench[0][k + 3], &r->wrench[0][k + 3], ELLA_NLINKS, 6), worst);
    }
    worst = larger(deviation(&y->tip_rotation[0][0], &r->tip_rotation[0][0], 9, 1), worst);
    for (k = 0; k < 3; ++k) {
        worst = larger(magnitude(y->tip_position[k] - r->tip_position[k]) / EXTENT, worst);
    }
    return worst;
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
        z[12 * ELLA_NLINKS + k] = y.vdot[ELLA_NV - ELLA_NMODES + k];
    }
    forget();
    memset(M, 0xff, sizeof M);
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
    forget();
    memset(&y, 0xff, sizeof y);
    verdict("forward dynamics", number,
        ella_forward_dynamics(&constants, &r->state, &r->input, &work, &y) == ELLA_OK);
    joint = compare(&y, &r->output);
    verdict("joint form", number, joint <= TOLERANCE);
    memset(&y, 0xff, sizeof y);
    verdict("DAE state", number, ella_dae_from_state(&constants, &r->state, &dae_work, &dae) == ELLA_OK);
    forget();
    verdict("DAE dynamics", number,
        ella_dae_forward_dynamics(&constants, &dae, &r->input, &dae_work, &y) == ELLA_OK);
    form = compare(&y, &r->output);
    verdict("DAE form", number, form <= TOLERANCE);
    verdict("assembled system", number, residual(&dae, &r->input) <= TOLERANCE);
    return larger(form, joint);
}

typedef ella_status (*step)(const ella_constants *, ella_state *, const ella_input *, ella_real, ella_work *);
typedef ella_status (*dae_step)(const ella_constants *, ella_dae_state *, const ella_input *, ella_real,
    ella_dae_work *);

/* ---- One step of every integrator in both forms: from the last case, its rates multiplied and its modes made softer,
 * so that every term of a step shows. Weighted sums of the results are compared with those of the reference.
 */

/* The constants with softer modes. */
static void soften(ella_constants *soft)
{
    int k;
    *soft = constants;
    for (k = 0; k < ELLA_NGIVEN; ++k) {
        soft->K[k] *= ella_softness * ella_softness;
        soft->D[k] *= ella_softness;
    }
}

static void check_step(const ella_constants *soft, int number, step method)
{
    const ella_case *last = &ella_cases[ELLA_CASES - 1];
    const ella_real *sums = ella_step_sums[number];
    ella_state state = last->state;
    ella_real error;
    int k;
    for (k = 0; k < ELLA_NV; ++k) {
        state.v[k] *= ella_haste;
    }
    forget();
    verdict("step", number, method(soft, &state, &last->input, ella_dt, &work) == ELLA_OK);
    error = larger(sum_error(state.q, ELLA_NQ - ELLA_NMODES, sums[0]),
        sum_error(state.q + (ELLA_NQ - ELLA_NMODES), ELLA_NMODES, sums[1]));
    error = larger(sum_error(state.v, ELLA_NV - ELLA_NMODES, sums[2]), error);
    error = larger(sum_error(state.v + (ELLA_NV - ELLA_NMODES), ELLA_NMODES, sums[3]), error);
    verdict("state after a step", number, error <= TOLERANCE);
}

static void check_dae_step(const ella_constants *soft, int number, dae_step method)
{
    const ella_case *last = &ella_cases[ELLA_CASES - 1];
    const ella_real *sums = ella_dae_step_sums[number];
    static ella_dae_state dae;
    ella_state state = last->state;
    ella_real error;
    int i, k;
    for (k = 0; k < ELLA_NV; ++k) {
        state.v[k] *= ella_haste;
    }
    forget();
    ella_dae_from_state(soft, &state, &dae_work, &dae);
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            dae.twist[i][k] += ella_defect;
            dae.quaternion[i][k < 4 ? k : 0] += k < 4 ? ella_defect : 0;
            dae.position[i][k < 3 ? k : 0] += k < 3 ? ella_defect : 0;
        }
    }
    forget();
    verdict("DAE step", number, method(soft, &dae, &last->input, ella_dt, &dae_work) == ELLA_OK);
    error = larger(sum_error(&dae.quaternion[0][0], 4 * ELLA_NLINKS, sums[0]),
        sum_error(&dae.position[0][0], 3 * ELLA_NLINKS, sums[1]));
    error = larger(sum_error(dae.eta, ELLA_NMODES, sums[2]), error);
    error = larger(sum_error(&dae.twist[0][0], 6 * ELLA_NLINKS, sums[3]), error);
    error = larger(sum_error(dae.etadot, ELLA_NMODES, sums[4]), error);
    error = larger(sum_error(dae.q, ELLA_NTAU, sums[5]), error);
    verdict("DAE state after a step", number, error <= TOLERANCE);
}

/* ---- Functions beside the forward dynamics. */

/* Sine, cosine and Stumpff functions: libm's, and their series or closed forms. */
static void check_elementary(void)
{
    static const ella_real ANGLES[11] = { ELLA_REAL(0.0), ELLA_REAL(0.3), ELLA_REAL(-0.7), ELLA_REAL(0.9),
        ELLA_REAL(-2.0), ELLA_REAL(3.141592653589793),
        ELLA_REAL(4.5), ELLA_REAL(-6.1), ELLA_REAL(355.0), ELLA_REAL(103993.0), ELLA_REAL(1.5e6) };
    static const ella_real SQUARES[8] = { ELLA_REAL(0.0), ELLA_REAL(0.01), ELLA_REAL(0.2), ELLA_REAL(0.3),
        ELLA_REAL(1.0), ELLA_REAL(3.9), ELLA_REAL(4.1), ELLA_REAL(20.0) };
    const ella_real eps = ELLA_REAL_EPSILON;
    int i, j, k;
    for (i = 0; i < 11; ++i) {
        const ella_real sine = ella_libm_sin(ANGLES[i]), cosine = ella_libm_cos(ANGLES[i]);
        const ella_sincos y = ella_sine_cosine(ANGLES[i]);
        verdict("sine", i, magnitude(y.sine - sine) <= 2 * eps * magnitude(sine));
        verdict("cosine", i, magnitude(y.cosine - cosine) <= 2 * eps * magnitude(cosine));
    }
    for (i = 0; i < 8; ++i) {
        const ella_real x = SQUARES[i], found[2] = { ella_c4(x), ella_c5(x) };
        for (k = 0; k < 2; ++k) {
            ella_real term = k ? ELLA_REAL(1.0) / 120 : ELLA_REAL(1.0) / 24, sum = term;
            for (j = 6 + k; j < 60; j += 2) {
                const int factor = j * (j - 1);
                term *= -x / (ella_real)factor;
                sum += term;
            }
            verdict("Stumpff function", i, magnitude(found[k] - sum) <= 64 * eps * sum);
        }
    }
}

/* Inverse dynamics and mass matrix at the reference accelerations: they must give back the inputs. */
static void check_inverse(int number)
{
    const ella_case *r = &ella_cases[number];
    static ella_real M[ELLA_LENGTH(ELLA_NV)][ELLA_LENGTH(ELLA_NV)];
    static ella_real force[ELLA_LENGTH(ELLA_NV)], bias[ELLA_LENGTH(ELLA_NV)], given[ELLA_LENGTH(ELLA_NV)];
    static const ella_real still[ELLA_LENGTH(ELLA_NV)] = { 0 };
    static ella_real wrench[ELLA_NLINKS][6];
    ella_real scale = 0, error, inertia = 0, size;
    int j, k;
    forget();
    verdict("inverse dynamics", number,
        ella_inverse_dynamics(&constants, &r->state, &r->input, r->output.vdot, &dae_work.chain, force,
            wrench) == ELLA_OK);
    forget();
    verdict("bias forces", number,
        ella_inverse_dynamics(&constants, &r->state, &r->input, still, &dae_work.chain, bias, 0) == ELLA_OK);
    forget();
    verdict("mass matrix", number, ella_mass_matrix(&constants, &r->state, &dae_work.chain, M) == ELLA_OK);
    error = larger(wrench_deviation((const ella_real(*)[6])wrench, r->output.wrench, 0),
        wrench_deviation((const ella_real(*)[6])wrench, r->output.wrench, 3));
    verdict("wrenches of the inverse dynamics", number, error <= WRENCH_TOLERANCE);
    for (k = 0; k < ELLA_NTAU; ++k) {
        given[k] = r->input.tau[k];
    }
    error = 0;
    for (k = 0; k < ELLA_NV; ++k) {
        ella_real rest = bias[k] - force[k];
        size = magnitude(bias[k]) + magnitude(force[k]);
        for (j = 0; j < ELLA_NV; ++j) {
            rest += M[k][j] * r->output.vdot[j];
            size += magnitude(M[k][j] * r->output.vdot[j]);
        }
        scale = larger(size, scale);
        inertia = larger(magnitude(rest), inertia);
        error = larger(magnitude(force[k] - given[k]), error);
    }
    verdict("forces of the inverse dynamics", number, error <= TOLERANCE * scale);
    verdict("inertial forces", number, inertia <= TOLERANCE * scale);
}

/* Poses by their sums; twists of the tips by the power of wrenches on them, the Jacobian by the last of them. */
static void check_kinematics(void)
{
    const int number = ELLA_CASES - 1;
    const ella_case *r = &ella_cases[number];
    const ella_real *sums = ella_pose_sums;
    static ella_motion m;
    static ella_real J[6][ELLA_LENGTH(ELLA_NV)];
    static ella_real free[ELLA_LENGTH(ELLA_NV)], loaded[ELLA_LENGTH(ELLA_NV)];
    static ella_input input;
    ella_real error, power = 0, size = 0;
    int i, j, k;
    forget();
    verdict("Jacobian", number, ella_tip_jacobian(&constants, &r->state, &dae_work.chain, &m, J) == ELLA_OK);
    memset(&m, 0xff, sizeof m);
    forget();
    verdict("kinematics", number, ella_kinematics(&constants, &r->state, &dae_work.chain, &m) == ELLA_OK);
    error = larger(sum_error(&m.rotation[0][0][0], 9 * ELLA_NLINKS, sums[0]),
        sum_error(&m.position[0][0], 3 * ELLA_NLINKS, sums[1]));
    error = larger(sum_error(&m.tip_rotation[0][0][0], 9 * ELLA_NLINKS, sums[2]), error);
    error = larger(sum_error(&m.tip_position[0][0], 3 * ELLA_NLINKS, sums[3]), error);
    verdict("poses", number, error <= TOLERANCE);
    for (i = 0; i < ELLA_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            const int place = (6 * i + k) % 11;
            input.w_ext[i][k] = (k < 3 ? ELLA_REAL(1.0) : ELLA_REAL(2.0)) + (ella_real)place / 11;
        }
        for (k = 0; k < 6; ++k) {
            for (j = 0; j < 3; ++j) {
                const ella_real part = m.tip_twist[i][k] * m.tip_rotation[i][k % 3][j] * input.w_ext[i][k / 3 * 3 + j];
                power += part;
                size += magnitude(part);
            }
        }
    }
    ella_inverse_dynamics(&constants, &r->state, &input, r->state.v, &dae_work.chain, loaded, 0);
    memset(input.w_ext, 0, sizeof input.w_ext);
    ella_inverse_dynamics(&constants, &r->state, &input, r->state.v, &dae_work.chain, free, 0);
    for (k = 0; k < ELLA_NV; ++k) {
        power += (loaded[k] - free[k]) * r->state.v[k];
        size += (magnitude(loaded[k]) + magnitude(free[k])) * magnitude(r->state.v[k]);
    }
    verdict("twists of the tips", number, magnitude(power) <= TOLERANCE * size);
    size = 0;
    error = 0;
    for (k = 0; k < 6; ++k) {
        ella_real twist = 0;
        for (j = 0; j < ELLA_NV; ++j) {
            twist += J[k][j] * r->state.v[j];
        }
        error = larger(magnitude(twist - m.tip_twist[ELLA_NLINKS - 1][k]), error);
        size = larger(magnitude(twist), size);
        if (k % 3 == 2) {
            verdict("twist by the Jacobian", number, error <= TOLERANCE * larger(size, ELLA_REAL(1e-6)));
            size = 0;
            error = 0;
        }
    }
}

/* The measures of validity, and accelerations alone. */
static void check_measures(void)
{
    const int number = ELLA_CASES - 1;
    const ella_case *r = &ella_cases[number];
    static ella_output y;
    static ella_measures measures;
    ella_real error;
    forget();
    verdict("watched dynamics", number, ella_watched_dynamics(&constants, &r->state, &r->input, &work, &y) == ELLA_OK);
    verdict("results of the watched dynamics", number, compare(&y, &r->output) <= TOLERANCE);
    memset(&measures, 0xff, sizeof measures);
    verdict("validity", number, ella_validity(&constants, &r->state, &y, &work, &measures) == ELLA_OK);
    error = sum_error(&measures.value[0][0], ELLA_NMEASURES * ELLA_NLINKS, ella_measure_sums[0]);
    error = larger(sum_error(ella_measure_bounds, ELLA_NMEASURES, ella_measure_sums[1]), error);
    verdict("measures of validity", number, error <= TOLERANCE);
    forget();
    verdict("accelerations", number, ella_accelerations(&constants, &r->state, &r->input, &work, &y) == ELLA_OK);
    verdict("results of the accelerations", number, compare(&y, &r->output) <= TOLERANCE);
}

/* The equilibrium: every round moves the modes by their unbalanced forces over their stiffness. */
static void check_rest(void)
{
    const ella_case *r = &ella_cases[ELLA_CASES - 1];
    static const ella_real still[ELLA_LENGTH(ELLA_NV)] = { 0 };
    static ella_real force[ELLA_LENGTH(ELLA_NV)], found[ELLA_LENGTH(ELLA_NV)];
    static ella_state rest;
    ella_state posture = r->state;
    ella_status status = ELLA_OK;
    const ella_constants *c = &constants;
    int round, k;
    memset(posture.v, 0, sizeof posture.v);
    for (round = 0; round <= ELLA_ROUNDS && status == ELLA_OK; ++round) {
        for (k = 0; k < ELLA_NMODES && round > 0; ++k) {
            posture.q[ELLA_NQ - ELLA_NMODES + k] -= force[ELLA_NV - ELLA_NMODES + k] / c->K[k];
        }
        status = ella_inverse_dynamics(c, &posture, &r->input, still, &dae_work.chain, force, 0);
    }
    verdict("status of rest", 0, ella_gravity(c, &r->state, &r->input, &dae_work.chain, found, &rest) == status);
    if (status == ELLA_OK) {
        verdict("joints at rest", 0, deviation(rest.q, posture.q, ELLA_NQ - ELLA_NMODES, 1) <= TOLERANCE);
        verdict("modes at rest", 0,
            deviation(rest.q + (ELLA_NQ - ELLA_NMODES), posture.q + (ELLA_NQ - ELLA_NMODES), ELLA_NMODES,
            1) <= TOLERANCE);
        verdict("rates at rest", 0, deviation(rest.v, posture.v, ELLA_NV, 1) <= 0);
        verdict("forces at rest", 0, deviation(found, force, ELLA_NV, 1) <= TOLERANCE);
    }
}

static void check_refusals(int number, step method)
{
    const ella_case *r = &ella_cases[0];
    ella_input input = r->input;
    ella_state state = r->state, before;
    before = state;
    verdict("refusal of a null pointer", number,
        method(&constants, 0, &input, ELLA_REAL(1e-3), &work) == ELLA_BAD_ARGUMENT);
    verdict("refusal of a zero step", number, method(&constants, &state, &input, 0, &work) == ELLA_BAD_ARGUMENT);
    input.w_ext[ELLA_NLINKS - 1][5] = (ella_real)NAN;
    verdict("refusal of NaN", number, method(&constants, &state, &input, ELLA_REAL(1e-3), &work) == ELLA_NONFINITE);
    verdict("state left as it was", number, memcmp(&state, &before, sizeof state) == 0);
    verdict("step", number, method(&constants, &state, &r->input, ELLA_REAL(1e-4), &work) == ELLA_OK);
}

static void check_dae_refusals(int number, dae_step method)
{
    const ella_case *r = &ella_cases[0];
    ella_input input = r->input;
    ella_dae_state state, before;
    ella_dae_from_state(&constants, &r->state, &dae_work, &state);
    before = state;
    verdict("DAE refusal of a null pointer", number,
        method(&constants, 0, &input, ELLA_REAL(1e-3), &dae_work) == ELLA_BAD_ARGUMENT);
    verdict("DAE refusal of a zero step", number,
        method(&constants, &state, &input, 0, &dae_work) == ELLA_BAD_ARGUMENT);
    input.w_ext[ELLA_NLINKS - 1][5] = (ella_real)NAN;
    verdict("DAE refusal of NaN", number,
        method(&constants, &state, &input, ELLA_REAL(1e-3), &dae_work) == ELLA_NONFINITE);
    verdict("DAE state left as it was", number, memcmp(&state, &before, sizeof state) == 0);
    verdict("DAE step", number, method(&constants, &state, &r->input, ELLA_REAL(1e-4), &dae_work) == ELLA_OK);
}

int main(void)
{
    static const step steps[] = { ella_step_euler, ella_step_semi_implicit, ella_step_modal_implicit,
        ella_step_modal_midpoint, ella_step_rk4 };
    static const dae_step dae_steps[] = { ella_dae_step_euler, ella_dae_step_semi_implicit,
        ella_dae_step_modal_implicit, ella_dae_step_modal_midpoint, ella_dae_step_rk4 };
    static ella_constants soft;
    ella_real worst = 0;
    int i;
    memset(&parameters, 0xff, sizeof parameters); /* NaN: what is not set shows */
    memset(&constants, 0xff, sizeof constants);
    ella_parameters_default(&parameters);
    verdict("prepare", 0, ella_prepare(&parameters, &constants) == ELLA_OK);
    for (i = 0; i < ELLA_CASES; ++i) {
        worst = larger(run_case(i), worst);
        check_inverse(i);
    }
    check_kinematics();
    check_measures();
    check_rest();
    check_elementary();
    soften(&soft);
    for (i = 0; i < 5; ++i) {
        if (ELLA_REAL_EPSILON < ELLA_REAL(1e-10)) { /* in float rounding hides what is small */
            check_step(&soft, i, steps[i]);
            check_dae_step(&soft, i, dae_steps[i]);
        }
        check_refusals(i, steps[i]);
        check_dae_refusals(i, dae_steps[i]);
    }
    printf("ella: largest relative deviation %.1e (allowed %.0e), %s\n", (double)worst, (double)TOLERANCE,
        failures ? "FAILED" : "all checks passed");
    return failures != 0;
}
