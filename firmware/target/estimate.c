/* estimate.c: the Kalman filter of the example arm on a board or on a host. The plant, which has 20 % less stiffness
 * than the model of the filter, is simulated beside it; its encoders and strain gauges are read with noise. Prints, besides
 * what measure.c prints of counts and stacks,
 *
 *   figure NAME NANOMETRES   the deflection of the tip and the errors of the estimates, root of the mean square
 */
#include <math.h>

#include "instruments.h"
#include "model.h"

enum {
    STEPS = 400, /* one millisecond each */
    JOINTS = 3,
    PATH = 300 /* steps in which the references reach the set points */
};

static const real SOFTER = (real)0.8, STRAIN = (real)2e-6, FIBRE = (real)0.02;
static const real GOAL[JOINTS] = { (real)-0.1, (real)0.14, (real)0.09 };

#include "sensed_arm.h"

static M(constants) model, plant;
static M(state) open_loop;

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
        filter.acceleration_variance[k] = 25;
    }
    read_all();
    return 0;
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
        if (control(&model, n) || M(step_modal_midpoint)(&plant, &truth, &input, DT, &work) != N(OK)
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
