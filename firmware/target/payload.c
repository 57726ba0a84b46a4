/* payload.c: the Kalman filter that finds the payload of the example arm, on a board or on a host. The arm picks up a kilogram
 * in motion; its encoders and strain gauges are read with noise. Prints, besides what measure.c prints of counts and stacks,
 *
 *   figure payload BILLIONTHS   the error of the payload one second later, over the payload
 *   figure tip NANOMETRES       that of the tip
 *
 * Without -DFINDS the filter is the plain one, of which only the counts are of use.
 */
#include <math.h>

#include "instruments.h"
#include "model.h"

enum {
    PICKED = 200, /* the sample at which the arm picks it up; one every millisecond */
    STEPS = 1200,
    PATH = 1000, /* samples in which the references reach the set points */
    JOINTS = 3,
    HAND = N(NLINKS) - 1
};

static const real STRAIN = (real)1e-6, FIBRE = (real)0.013;
static const real GOAL[JOINTS] = { (real)0.5, (real)-0.4, (real)0.6 };

#include "sensed_arm.h"

static M(constants) found, light, heavy; /* the model of the filter, the arm before and after */
static real mass;                       /* kg: of the payload */

static int prepare(void)
{
    M(parameters_default)(&parameters);
    if (M(prepare)(&parameters, &light) != N(OK)) {
        return 1;
    }
    parameters.links[HAND].bodies[0].mass += 1;
    mass = parameters.links[HAND].bodies[0].mass;
    if (M(prepare)(&parameters, &heavy) != N(OK)) {
        return 1;
    }
    M(parameters_default)(&parameters);
    found = light;
    return 0;
}

/* In every link an axial mode, then one of bending in y and one in z: what is stiff is left to the model. */
static int start(void)
{
    static M(state) deviation;
    int k;
    for (k = 0; k < N(NQ); ++k) {
        deviation.q[k] = k >= JOINTS && (k - JOINTS) % 3 == 0 ? (real)1e-8 : (real)1e-4;
        deviation.v[k] = 10 * deviation.q[k];
    }
#ifdef FINDS
    {
        static const real deviation_p[N(NBY_P)] = { (real)0.02 };
        if (M(estimator_init)(&parameters, &truth, &deviation, &filter, deviation_p) != N(OK)) {
            return 1;
        }
        filter.density_p[0] = (real)0.03; /* kg^2/s */
        filter.lower[0] = (real)0.1;
        filter.upper[0] = 10;
    }
#else
    if (M(estimator_init)(&parameters, &truth, &deviation, &filter) != N(OK)) {
        return 1;
    }
#endif
    for (k = 0; k < N(NQ); ++k) {
        filter.density_v[k] = (real)1e-7;
    }
    read_all();
    return 0;
}

static int run(void)
{
    int n;
    for (n = 0; n < STEPS; ++n) {
        const M(constants) *const arm = n < PICKED ? &light : &heavy;
        if (control(&light, n) || M(step_modal_midpoint)(arm, &truth, &input, DT, &work) != N(OK)) {
            return 1;
        }
        measure();
        printf("count predict 1\ncount update 1\n");
        count_begin();
        if (M(estimator_predict)(&found, &filter, &input, DT, &scratch) != N(OK)) {
            return 1;
        }
        count_end();
        count_begin();
        if (M(estimator_update)(&found, &filter, &input, &measured, &scratch) != N(OK)) {
            return 1;
        }
        count_end();
    }
    return 0;
}

/* The distance of the tips of truth and estimate, at the last sample, and the error of what was found. */
static int judge(void)
{
    real tip[3], error = 0;
    double apart = 0;
    int k;
    if (M(forward_dynamics)(&heavy, &truth, &input, &work, &output) != N(OK)) {
        return 1;
    }
    memcpy(tip, output.tip_position, sizeof tip);
    if (M(forward_dynamics)(&found, &filter.state, &input, &work, &output) != N(OK)) {
        return 1;
    }
    for (k = 0; k < 3; ++k) {
        apart += (double)(output.tip_position[k] - tip[k]) * (double)(output.tip_position[k] - tip[k]);
    }
#ifdef FINDS
    error = filter.parameters.links[HAND].bodies[0].mass / mass - 1;
#endif
    printf("figure payload %ld\nfigure tip %ld\n", (long)(1e9 * (double)error), (long)(1e9 * sqrt(apart)));
    return 0;
}

int main(void)
{
    printf("size estimator %u\n", (unsigned)sizeof(M(estimator)));
    printf("size measurement %u\n", (unsigned)sizeof(M(measurement)));
    printf("size estimator_work %u\n", (unsigned)sizeof(M(estimator_work)));
    count_known();
    if (prepare() || start() || run() || judge()) {
        printf("failed\n");
        return 1;
    }
    STACK("estimator_predict", M(estimator_predict)(&found, &filter, &input, DT, &scratch));
    STACK("estimator_update", M(estimator_update)(&found, &filter, &input, &measured, &scratch));
    printf("done\n");
    return 0;
}
