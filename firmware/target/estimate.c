/* estimate.c: the Kalman filter of the example arm on a board or on a host. The plant, which has 20 % less stiffness
 * than the model of the filter, is simulated beside it; its encoders and strain gauges are read with noise. Prints, besides
 * what measure.c prints of counts and stacks,
 *
 *   figure NAME NANOMETRES   the deflection of the tip and the errors of the estimates, root of the mean square
 */
#include <math.h>
#include <string.h>

#include "instruments.h"
#include "model.h"
#include "noise.h"
#include ESTIMATOR_HEADER

enum {
    STEPS = 400, /* one millisecond each */
    JOINTS = 3,
    PATH = 300 /* steps in which the references reach the set points */
};

static const real DT = (real)1e-3, SOFTER = (real)0.8;
static const real ENCODER = (real)1e-4, STRAIN = (real)2e-6, FIBRE = (real)0.02;
static const real KP[JOINTS] = { 400, 400, 120 }, KD[JOINTS] = { 28, 28, 12 };
static const real GOAL[JOINTS] = { (real)-0.1, (real)0.14, (real)0.09 };

static M(parameters) parameters;
static M(constants) model, plant;
static M(input) input;
static M(output) output;
static M(work) work;
static M(chain) chain;
static M(estimator) filter;
static M(estimator_work) scratch;
static M(measurement) measured;
static M(state) truth, open_loop;

static int prepare(void)
{
    int i;
    M(parameters_default)(&parameters);
    if (M(prepare)(&parameters, &model) != N(OK)) {
        return 1;
    }
    for (i = 0; i < N(NLINKS); ++i) {
        parameters.links[i].EA *= SOFTER;
        parameters.links[i].EIy *= SOFTER;
        parameters.links[i].EIz *= SOFTER;
    }
    if (M(prepare)(&parameters, &plant) != N(OK)) {
        return 1;
    }
    M(parameters_default)(&parameters);
    return 0;
}

/* In every link an axial mode, then one of bending in y and one in z: what is stiff is left to the model. */
static int start(void)
{
    static M(state) deviation;
    int k;
    for (k = 0; k < N(NQ); ++k) {
        const int axial = k >= JOINTS && (k - JOINTS) % 3 == 0;
        deviation.q[k] = axial ? (real)1e-8 : (real)1e-3;
        deviation.v[k] = 10 * deviation.q[k];
    }
    if (M(estimator_init)(&parameters, &truth, &deviation, &filter) != N(OK)) {
        return 1;
    }
    for (k = 0; k < N(NQ); ++k) {
        const int axial = k >= JOINTS && (k - JOINTS) % 3 == 0;
        filter.density_v[k] = k < JOINTS ? (real)1 : axial ? (real)1e-9 : (real)10;
    }
    for (k = 0; k < JOINTS; ++k) {
        filter.encoder_variance[k] = ENCODER * ENCODER;
        filter.acceleration_variance[k] = 25;
        measured.has_encoder[k] = 1;
    }
    for (k = 0; k < N(NGAUGES); ++k) {
        filter.strain_variance[k] = STRAIN * STRAIN;
        filter.fibre[k] = FIBRE;
        measured.has_strain[k] = 1;
    }
    return 0;
}

/* PD about a smooth path, and what holds the straight arm of the model against its weight. */
static int control(int n)
{
    static M(state) straight;
    static real rest[N(NV)], force[N(NV)];
    const real s = n < PATH ? (real)n / PATH : (real)1, reference = s * s * (3 - 2 * s);
    int k;
    memcpy(straight.q, truth.q, JOINTS * sizeof(real));
    if (M(inverse_dynamics)(&model, &straight, &input, rest, &chain, force, 0) != N(OK)) {
        return 1;
    }
    for (k = 0; k < JOINTS; ++k) {
        input.tau[k] = KP[k] * (reference * GOAL[k] - truth.q[k]) - KD[k] * truth.v[k] + force[k];
    }
    return 0;
}

static void measure(void)
{
    int k;
    for (k = 0; k < JOINTS; ++k) {
        measured.encoder[k] = truth.q[k] + ENCODER * noise();
    }
    for (k = 0; k < N(NGAUGES); ++k) {
        const int mode = 3 * (k / 2) + 1 + k % 2; /* y, z of the upper arm, then of the forearm */
        measured.strain[k] = -FIBRE * filter.curvature[mode] * truth.q[JOINTS + mode] + STRAIN * noise();
    }
}

static const real *tip(const M(constants) *c, const M(state) *s)
{
    return M(forward_dynamics)(c, s, &input, &work, &output) == N(OK) ? output.tip_position : 0;
}

/* Squared distance of the tips that two sets of modal coordinates give at the plant's joint angles. */
static double misfit(const real eta[])
{
    M(state) there = truth;
    real r[3] = { 0, 0, 0 };
    double sum = 0;
    int k;
    memcpy(r, tip(&plant, &truth), sizeof r);
    memcpy(there.q + JOINTS, eta, (N(NQ) - JOINTS) * sizeof(real));
    (void)tip(&plant, &there);
    for (k = 0; k < 3; ++k) {
        sum += (double)(output.tip_position[k] - r[k]) * (double)(output.tip_position[k] - r[k]);
    }
    return sum;
}

static void print_figure(const char *name, double sum)
{
    printf("figure %s %ld\n", name, (long)(1e9 * sqrt(sum / STEPS)));
}

static int run(void)
{
    double deflection = 0, open_error = 0, filter_error = 0;
    static const real straight[N(NMODES)];
    int n;
    for (n = 0; n < STEPS; ++n) {
        if (control(n) || M(step_modal_midpoint)(&plant, &truth, &input, DT, &work) != N(OK)
            || M(step_modal_midpoint)(&model, &open_loop, &input, DT, &work) != N(OK)) {
            return 1;
        }
        measure();
        printf("count predict 1\ncount update 1\n");
        count_begin();
        if (M(estimator_predict)(&model, &filter, &input, DT, &scratch) != N(OK)) {
            return 1;
        }
        count_end();
        count_begin();
        if (M(estimator_update)(&model, &filter, &input, &measured, &scratch) != N(OK)) {
            return 1;
        }
        count_end();
        deflection += misfit(straight);
        open_error += misfit(open_loop.q + JOINTS);
        filter_error += misfit(filter.state.q + JOINTS);
    }
    print_figure("deflection", deflection);
    print_figure("open_loop", open_error);
    print_figure("filter", filter_error);
    return 0;
}

/* The longest update: the accelerometer besides, with what it measures at the estimate itself: where nothing is measured
 * the innovation is the negative of that.
 */
static void run_acceleration(void)
{
    static M(estimator) before;
    int k;
    before = filter;
    measured.has_acceleration[0] = measured.has_acceleration[1] = measured.has_acceleration[2] = 1;
    (void)M(estimator_update)(&model, &filter, &input, &measured, &scratch);
    for (k = 0; k < 3; ++k) {
        measured.acceleration[k] = -filter.innovations.acceleration[k].value;
    }
    filter = before;
    printf("count update_acceleration 1\n");
    COUNT(M(estimator_update)(&model, &filter, &input, &measured, &scratch));
    STACK("estimator_predict", M(estimator_predict)(&model, &filter, &input, DT, &scratch));
    STACK("estimator_update", M(estimator_update)(&model, &filter, &input, &measured, &scratch));
}

int main(void)
{
    printf("size estimator %u\n", (unsigned)sizeof(M(estimator)));
    printf("size measurement %u\n", (unsigned)sizeof(M(measurement)));
    printf("size estimator_work %u\n", (unsigned)sizeof(M(estimator_work)));
    count_known();
    if (prepare() || start() || run()) {
        printf("failed\n");
        return 1;
    }
    run_acceleration();
    printf("done\n");
    return 0;
}
