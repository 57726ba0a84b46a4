/* check.c: compares the compiled model with recorded reference values; exit status 0 if all agree.
 *
 * It checks both forms, a step of every integrator in each, inverse dynamics, mass matrix, kinematics, rest and
 * measures of validity, and the refusal of bad arguments, non-finite input and non-finite results.
 */
#include <stdio.h>
#include <string.h>

#include "six_link_reference.h"

/* Three times the rounding error of the reference states in this precision; at least 1e-10 (double) or 1e-4 (float), at
 * most 1e-2.
 */
static const six_link_real TOLERANCE = sizeof(six_link_real) == sizeof(float) ? SIX_LINK_REAL(1e-04)
    : SIX_LINK_REAL(1e-10);
/* m: how far frames and tips are from the origin in these states. */
static const six_link_real EXTENT = SIX_LINK_REAL(2.09538);
/* For wrenches by inverse dynamics: inertial forces that are large beside them cancel. */
static const six_link_real WRENCH_TOLERANCE = sizeof(six_link_real) == sizeof(float) ? SIX_LINK_REAL(2e-04)
    : SIX_LINK_REAL(1e-10);

static six_link_parameters parameters;
static six_link_constants constants;
static six_link_work work;
static six_link_dae_work dae_work;
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
    return scale > SIX_LINK_REAL(1e-6) ? error / scale : error;
}

/* The deviation of the weighted sum of count numbers from a reference, over the sum of their sizes. */
static six_link_real sum_error(const six_link_real *x, int count, six_link_real reference)
{
    six_link_real sum = -reference, size = 0;
    int k;
    for (k = 0; k < count; ++k) {
        const int place = 7 * k % 97;
        const six_link_real weight = 1 + (six_link_real)place / 97;
        sum += weight * x[k];
        size += weight * magnitude(x[k]);
    }
    return magnitude(sum) / (size > SIX_LINK_REAL(1e-9) ? size : 1);
}

/* The largest deviation of the joint moments (first = 0) or forces (first = 3), over the largest of them. */
static six_link_real wrench_deviation(const six_link_real w[][6], const six_link_real reference[][6], int first)
{
    six_link_real error = 0, scale = 0;
    int i, k;
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        for (k = first; k < first + 3; ++k) {
            error = larger(magnitude(w[i][k] - reference[i][k]), error);
            scale = larger(magnitude(reference[i][k]), scale);
        }
    }
    return scale > SIX_LINK_REAL(1e-6) ? error / scale : error;
}

/* Joint and modal accelerations, moments, each component of the forces, and the tip's axes, each over its own size; its
 * position over the robot's.
 */
static six_link_real compare(const six_link_output *y, const six_link_output *r)
{
    six_link_real worst = deviation(y->vdot, r->vdot, SIX_LINK_NV - SIX_LINK_NMODES, 1);
    int k;
    worst = larger(deviation(y->vdot + (SIX_LINK_NV - SIX_LINK_NMODES), r->vdot + (SIX_LINK_NV - SIX_LINK_NMODES),
        SIX_LINK_NMODES, 1), worst);
    worst = larger(wrench_deviation(y->wrench, r->wrench, 0), worst);
    for (k = 0; k < 3; ++k) {
        worst = larger(deviation(&y->wrench[0][k + 3], &r->wrench[0][k + 3], SIX_LINK_NLINKS, 6), worst);
    }
    worst = larger(deviation(&y->tip_rotation[0][0], &r->tip_rotation[0][0], 9, 1), worst);
    for (k = 0; k < 3; ++k) {
        worst = larger(magnitude(y->tip_position[k] - r->tip_position[k]) / EXTENT, worst);
    }
    return worst;
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
        z[12 * SIX_LINK_NLINKS + k] = y.vdot[SIX_LINK_NV - SIX_LINK_NMODES + k];
    }
    forget();
    memset(M, 0xff, sizeof M);
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
    forget();
    memset(&y, 0xff, sizeof y);
    verdict("forward dynamics", number,
        six_link_forward_dynamics(&constants, &r->state, &r->input, &work, &y) == SIX_LINK_OK);
    joint = compare(&y, &r->output);
    verdict("joint form", number, joint <= TOLERANCE);
    memset(&y, 0xff, sizeof y);
    verdict("DAE state", number, six_link_dae_from_state(&constants, &r->state, &dae_work, &dae) == SIX_LINK_OK);
    forget();
    verdict("DAE dynamics", number,
        six_link_dae_forward_dynamics(&constants, &dae, &r->input, &dae_work, &y) == SIX_LINK_OK);
    form = compare(&y, &r->output);
    verdict("DAE form", number, form <= TOLERANCE);
    verdict("assembled system", number, residual(&dae, &r->input) <= TOLERANCE);
    return larger(form, joint);
}

typedef six_link_status (*step)(const six_link_constants *, six_link_state *, const six_link_input *, six_link_real,
    six_link_work *);
typedef six_link_status (*dae_step)(const six_link_constants *, six_link_dae_state *, const six_link_input *,
    six_link_real,
    six_link_dae_work *);

/* ---- One step of every integrator in both forms: from the last case, its rates multiplied and its modes made softer,
 * so that every term of a step shows. Weighted sums of the results are compared with those of the reference.
 */

/* The constants with softer modes. */
static void soften(six_link_constants *soft)
{
    int k;
    *soft = constants;
    for (k = 0; k < SIX_LINK_NGIVEN; ++k) {
        soft->K[k] *= six_link_softness * six_link_softness;
        soft->D[k] *= six_link_softness;
    }
}

static void check_step(const six_link_constants *soft, int number, step method)
{
    const six_link_case *last = &six_link_cases[SIX_LINK_CASES - 1];
    const six_link_real *sums = six_link_step_sums[number];
    six_link_state state = last->state;
    six_link_real error;
    int k;
    for (k = 0; k < SIX_LINK_NV; ++k) {
        state.v[k] *= six_link_haste;
    }
    forget();
    verdict("step", number, method(soft, &state, &last->input, six_link_dt, &work) == SIX_LINK_OK);
    error = larger(sum_error(state.q, SIX_LINK_NQ - SIX_LINK_NMODES, sums[0]),
        sum_error(state.q + (SIX_LINK_NQ - SIX_LINK_NMODES), SIX_LINK_NMODES, sums[1]));
    error = larger(sum_error(state.v, SIX_LINK_NV - SIX_LINK_NMODES, sums[2]), error);
    error = larger(sum_error(state.v + (SIX_LINK_NV - SIX_LINK_NMODES), SIX_LINK_NMODES, sums[3]), error);
    verdict("state after a step", number, error <= TOLERANCE);
}

static void check_dae_step(const six_link_constants *soft, int number, dae_step method)
{
    const six_link_case *last = &six_link_cases[SIX_LINK_CASES - 1];
    const six_link_real *sums = six_link_dae_step_sums[number];
    static six_link_dae_state dae;
    six_link_state state = last->state;
    six_link_real error;
    int i, k;
    for (k = 0; k < SIX_LINK_NV; ++k) {
        state.v[k] *= six_link_haste;
    }
    forget();
    six_link_dae_from_state(soft, &state, &dae_work, &dae);
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            dae.twist[i][k] += six_link_defect;
            dae.quaternion[i][k < 4 ? k : 0] += k < 4 ? six_link_defect : 0;
            dae.position[i][k < 3 ? k : 0] += k < 3 ? six_link_defect : 0;
        }
    }
    forget();
    verdict("DAE step", number, method(soft, &dae, &last->input, six_link_dt, &dae_work) == SIX_LINK_OK);
    error = larger(sum_error(&dae.quaternion[0][0], 4 * SIX_LINK_NLINKS, sums[0]),
        sum_error(&dae.position[0][0], 3 * SIX_LINK_NLINKS, sums[1]));
    error = larger(sum_error(dae.eta, SIX_LINK_NMODES, sums[2]), error);
    error = larger(sum_error(&dae.twist[0][0], 6 * SIX_LINK_NLINKS, sums[3]), error);
    error = larger(sum_error(dae.etadot, SIX_LINK_NMODES, sums[4]), error);
    error = larger(sum_error(dae.q, SIX_LINK_NTAU, sums[5]), error);
    verdict("DAE state after a step", number, error <= TOLERANCE);
}

/* ---- Functions beside the forward dynamics. */

/* Sine, cosine and Stumpff functions: libm's, and their series or closed forms. */
static void check_elementary(void)
{
    static const six_link_real ANGLES[11] = { SIX_LINK_REAL(0.0), SIX_LINK_REAL(0.3), SIX_LINK_REAL(-0.7),
        SIX_LINK_REAL(0.9), SIX_LINK_REAL(-2.0), SIX_LINK_REAL(3.141592653589793),
        SIX_LINK_REAL(4.5), SIX_LINK_REAL(-6.1), SIX_LINK_REAL(355.0), SIX_LINK_REAL(103993.0), SIX_LINK_REAL(1.5e6) };
    static const six_link_real SQUARES[8] = { SIX_LINK_REAL(0.0), SIX_LINK_REAL(0.01), SIX_LINK_REAL(0.2),
        SIX_LINK_REAL(0.3), SIX_LINK_REAL(1.0), SIX_LINK_REAL(3.9), SIX_LINK_REAL(4.1), SIX_LINK_REAL(20.0) };
    const six_link_real eps = SIX_LINK_REAL_EPSILON;
    int i, j, k;
    for (i = 0; i < 11; ++i) {
        const six_link_real sine = six_link_libm_sin(ANGLES[i]), cosine = six_link_libm_cos(ANGLES[i]);
        const six_link_sincos y = six_link_sine_cosine(ANGLES[i]);
        verdict("sine", i, magnitude(y.sine - sine) <= 2 * eps * magnitude(sine));
        verdict("cosine", i, magnitude(y.cosine - cosine) <= 2 * eps * magnitude(cosine));
    }
    for (i = 0; i < 8; ++i) {
        const six_link_real x = SQUARES[i], found[2] = { six_link_c4(x), six_link_c5(x) };
        for (k = 0; k < 2; ++k) {
            six_link_real term = k ? SIX_LINK_REAL(1.0) / 120 : SIX_LINK_REAL(1.0) / 24, sum = term;
            for (j = 6 + k; j < 60; j += 2) {
                const int factor = j * (j - 1);
                term *= -x / (six_link_real)factor;
                sum += term;
            }
            verdict("Stumpff function", i, magnitude(found[k] - sum) <= 64 * eps * sum);
        }
    }
}

/* Inverse dynamics and mass matrix at the reference accelerations: they must give back the inputs. */
static void check_inverse(int number)
{
    const six_link_case *r = &six_link_cases[number];
    static six_link_real M[SIX_LINK_LENGTH(SIX_LINK_NV)][SIX_LINK_LENGTH(SIX_LINK_NV)];
    static six_link_real force[SIX_LINK_LENGTH(SIX_LINK_NV)], bias[SIX_LINK_LENGTH(SIX_LINK_NV)],
        given[SIX_LINK_LENGTH(SIX_LINK_NV)];
    static const six_link_real still[SIX_LINK_LENGTH(SIX_LINK_NV)] = { 0 };
    static six_link_real wrench[SIX_LINK_NLINKS][6];
    six_link_real scale = 0, error, inertia = 0, size;
    int j, k;
    forget();
    verdict("inverse dynamics", number,
        six_link_inverse_dynamics(&constants, &r->state, &r->input, r->output.vdot, &dae_work.chain, force,
            wrench) == SIX_LINK_OK);
    forget();
    verdict("bias forces", number,
        six_link_inverse_dynamics(&constants, &r->state, &r->input, still, &dae_work.chain, bias, 0) == SIX_LINK_OK);
    forget();
    verdict("mass matrix", number, six_link_mass_matrix(&constants, &r->state, &dae_work.chain, M) == SIX_LINK_OK);
    error = larger(wrench_deviation((const six_link_real(*)[6])wrench, r->output.wrench, 0),
        wrench_deviation((const six_link_real(*)[6])wrench, r->output.wrench, 3));
    verdict("wrenches of the inverse dynamics", number, error <= WRENCH_TOLERANCE);
    for (k = 0; k < SIX_LINK_NTAU; ++k) {
        given[k] = r->input.tau[k];
    }
    error = 0;
    for (k = 0; k < SIX_LINK_NV; ++k) {
        six_link_real rest = bias[k] - force[k];
        size = magnitude(bias[k]) + magnitude(force[k]);
        for (j = 0; j < SIX_LINK_NV; ++j) {
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
    const int number = SIX_LINK_CASES - 1;
    const six_link_case *r = &six_link_cases[number];
    const six_link_real *sums = six_link_pose_sums;
    static six_link_motion m;
    static six_link_real J[6][SIX_LINK_LENGTH(SIX_LINK_NV)];
    static six_link_real free[SIX_LINK_LENGTH(SIX_LINK_NV)], loaded[SIX_LINK_LENGTH(SIX_LINK_NV)];
    static six_link_input input;
    six_link_real error, power = 0, size = 0;
    int i, j, k;
    forget();
    verdict("Jacobian", number, six_link_tip_jacobian(&constants, &r->state, &dae_work.chain, &m, J) == SIX_LINK_OK);
    memset(&m, 0xff, sizeof m);
    forget();
    verdict("kinematics", number, six_link_kinematics(&constants, &r->state, &dae_work.chain, &m) == SIX_LINK_OK);
    error = larger(sum_error(&m.rotation[0][0][0], 9 * SIX_LINK_NLINKS, sums[0]),
        sum_error(&m.position[0][0], 3 * SIX_LINK_NLINKS, sums[1]));
    error = larger(sum_error(&m.tip_rotation[0][0][0], 9 * SIX_LINK_NLINKS, sums[2]), error);
    error = larger(sum_error(&m.tip_position[0][0], 3 * SIX_LINK_NLINKS, sums[3]), error);
    verdict("poses", number, error <= TOLERANCE);
    for (i = 0; i < SIX_LINK_NLINKS; ++i) {
        for (k = 0; k < 6; ++k) {
            const int place = (6 * i + k) % 11;
            input.w_ext[i][k] = (k < 3 ? SIX_LINK_REAL(1.0) : SIX_LINK_REAL(2.0)) + (six_link_real)place / 11;
        }
        for (k = 0; k < 6; ++k) {
            for (j = 0; j < 3; ++j) {
                const six_link_real part = m.tip_twist[i][k] * m.tip_rotation[i][k % 3][j]
                    * input.w_ext[i][k / 3 * 3 + j];
                power += part;
                size += magnitude(part);
            }
        }
    }
    six_link_inverse_dynamics(&constants, &r->state, &input, r->state.v, &dae_work.chain, loaded, 0);
    memset(input.w_ext, 0, sizeof input.w_ext);
    six_link_inverse_dynamics(&constants, &r->state, &input, r->state.v, &dae_work.chain, free, 0);
    for (k = 0; k < SIX_LINK_NV; ++k) {
        power += (loaded[k] - free[k]) * r->state.v[k];
        size += (magnitude(loaded[k]) + magnitude(free[k])) * magnitude(r->state.v[k]);
    }
    verdict("twists of the tips", number, magnitude(power) <= TOLERANCE * size);
    size = 0;
    error = 0;
    for (k = 0; k < 6; ++k) {
        six_link_real twist = 0;
        for (j = 0; j < SIX_LINK_NV; ++j) {
            twist += J[k][j] * r->state.v[j];
        }
        error = larger(magnitude(twist - m.tip_twist[SIX_LINK_NLINKS - 1][k]), error);
        size = larger(magnitude(twist), size);
        if (k % 3 == 2) {
            verdict("twist by the Jacobian", number, error <= TOLERANCE * larger(size, SIX_LINK_REAL(1e-6)));
            size = 0;
            error = 0;
        }
    }
}

/* The measures of validity, and accelerations alone. */
static void check_measures(void)
{
    const int number = SIX_LINK_CASES - 1;
    const six_link_case *r = &six_link_cases[number];
    static six_link_output y;
    static six_link_measures measures;
    six_link_real error;
    forget();
    verdict("watched dynamics", number,
        six_link_watched_dynamics(&constants, &r->state, &r->input, &work, &y) == SIX_LINK_OK);
    verdict("results of the watched dynamics", number, compare(&y, &r->output) <= TOLERANCE);
    memset(&measures, 0xff, sizeof measures);
    verdict("validity", number, six_link_validity(&constants, &r->state, &y, &work, &measures) == SIX_LINK_OK);
    error = sum_error(&measures.value[0][0], SIX_LINK_NMEASURES * SIX_LINK_NLINKS, six_link_measure_sums[0]);
    error = larger(sum_error(six_link_measure_bounds, SIX_LINK_NMEASURES, six_link_measure_sums[1]), error);
    verdict("measures of validity", number, error <= TOLERANCE);
    forget();
    verdict("accelerations", number,
        six_link_accelerations(&constants, &r->state, &r->input, &work, &y) == SIX_LINK_OK);
    verdict("results of the accelerations", number, compare(&y, &r->output) <= TOLERANCE);
}

/* The equilibrium: every round moves the modes by their unbalanced forces over their stiffness. */
static void check_rest(void)
{
    const six_link_case *r = &six_link_cases[SIX_LINK_CASES - 1];
    static const six_link_real still[SIX_LINK_LENGTH(SIX_LINK_NV)] = { 0 };
    static six_link_real force[SIX_LINK_LENGTH(SIX_LINK_NV)], found[SIX_LINK_LENGTH(SIX_LINK_NV)];
    static six_link_state rest;
    six_link_state posture = r->state;
    six_link_status status = SIX_LINK_OK;
    const six_link_constants *c = &constants;
    int round, k;
    memset(posture.v, 0, sizeof posture.v);
    for (round = 0; round <= SIX_LINK_ROUNDS && status == SIX_LINK_OK; ++round) {
        for (k = 0; k < SIX_LINK_NMODES && round > 0; ++k) {
            posture.q[SIX_LINK_NQ - SIX_LINK_NMODES + k] -= force[SIX_LINK_NV - SIX_LINK_NMODES
                + k] / c->K[SIX_LINK_NTAU + k];
        }
        status = six_link_inverse_dynamics(c, &posture, &r->input, still, &dae_work.chain, force, 0);
    }
    verdict("status of rest", 0, six_link_gravity(c, &r->state, &r->input, &dae_work.chain, found, &rest) == status);
    if (status == SIX_LINK_OK) {
        verdict("joints at rest", 0, deviation(rest.q, posture.q, SIX_LINK_NQ - SIX_LINK_NMODES, 1) <= TOLERANCE);
        verdict("modes at rest", 0,
            deviation(rest.q + (SIX_LINK_NQ - SIX_LINK_NMODES), posture.q + (SIX_LINK_NQ - SIX_LINK_NMODES),
            SIX_LINK_NMODES, 1) <= TOLERANCE);
        verdict("rates at rest", 0, deviation(rest.v, posture.v, SIX_LINK_NV, 1) <= 0);
        verdict("forces at rest", 0, deviation(found, force, SIX_LINK_NV, 1) <= TOLERANCE);
    }
}

static void check_refusals(int number, step method)
{
    const six_link_case *r = &six_link_cases[0];
    six_link_input input = r->input;
    six_link_state state = r->state, before;
    before = state;
    verdict("refusal of a null pointer", number,
        method(&constants, 0, &input, SIX_LINK_REAL(1e-3), &work) == SIX_LINK_BAD_ARGUMENT);
    verdict("refusal of a zero step", number, method(&constants, &state, &input, 0, &work) == SIX_LINK_BAD_ARGUMENT);
    input.w_ext[SIX_LINK_NLINKS - 1][5] = (six_link_real)NAN;
    verdict("refusal of NaN", number,
        method(&constants, &state, &input, SIX_LINK_REAL(1e-3), &work) == SIX_LINK_NONFINITE);
    verdict("state left as it was", number, memcmp(&state, &before, sizeof state) == 0);
    verdict("step", number, method(&constants, &state, &r->input, SIX_LINK_REAL(1e-4), &work) == SIX_LINK_OK);
}

static void check_dae_refusals(int number, dae_step method)
{
    const six_link_case *r = &six_link_cases[0];
    six_link_input input = r->input;
    six_link_dae_state state, before;
    six_link_dae_from_state(&constants, &r->state, &dae_work, &state);
    before = state;
    verdict("DAE refusal of a null pointer", number,
        method(&constants, 0, &input, SIX_LINK_REAL(1e-3), &dae_work) == SIX_LINK_BAD_ARGUMENT);
    verdict("DAE refusal of a zero step", number,
        method(&constants, &state, &input, 0, &dae_work) == SIX_LINK_BAD_ARGUMENT);
    input.w_ext[SIX_LINK_NLINKS - 1][5] = (six_link_real)NAN;
    verdict("DAE refusal of NaN", number,
        method(&constants, &state, &input, SIX_LINK_REAL(1e-3), &dae_work) == SIX_LINK_NONFINITE);
    verdict("DAE state left as it was", number, memcmp(&state, &before, sizeof state) == 0);
    verdict("DAE step", number, method(&constants, &state, &r->input, SIX_LINK_REAL(1e-4), &dae_work) == SIX_LINK_OK);
}

int main(void)
{
    static const step steps[] = { six_link_step_euler, six_link_step_semi_implicit, six_link_step_modal_implicit,
        six_link_step_modal_midpoint, six_link_step_rk4 };
    static const dae_step dae_steps[] = { six_link_dae_step_euler, six_link_dae_step_semi_implicit,
        six_link_dae_step_modal_implicit, six_link_dae_step_modal_midpoint, six_link_dae_step_rk4 };
    static six_link_constants soft;
    six_link_real worst = 0;
    int i;
    memset(&parameters, 0xff, sizeof parameters); /* NaN: what is not set shows */
    memset(&constants, 0xff, sizeof constants);
    six_link_parameters_default(&parameters);
    verdict("prepare", 0, six_link_prepare(&parameters, &constants) == SIX_LINK_OK);
    for (i = 0; i < SIX_LINK_CASES; ++i) {
        worst = larger(run_case(i), worst);
        check_inverse(i);
    }
    check_kinematics();
    check_measures();
    check_rest();
    check_elementary();
    soften(&soft);
    for (i = 0; i < 5; ++i) {
        if (SIX_LINK_REAL_EPSILON < SIX_LINK_REAL(1e-10)) { /* in float rounding hides what is small */
            check_step(&soft, i, steps[i]);
            check_dae_step(&soft, i, dae_steps[i]);
        }
        check_refusals(i, steps[i]);
        check_dae_refusals(i, dae_steps[i]);
    }
    printf("six_link: largest relative deviation %.1e (allowed %.0e), %s\n", (double)worst, (double)TOLERANCE,
        failures ? "FAILED" : "all checks passed");
    return failures != 0;
}
