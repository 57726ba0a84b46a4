/* control.c: predictive control of the example arm on a board or on a host. The plant is the controller's model with a
 * heavier payload than the controller knows of, in steps of a millisecond. Prints, besides what measure.c prints of sizes,
 * counts and stacks,
 *
 *   sample NUMBER BITS...   the torques and the tip's position, the bits of doubles
 *   figure NAME NUMBER      unsolved: samples without a solution; iterations: of the quadratic program, the most;
 *                           active: constraints that can be active at once;
 *                           miss: nanometres between the tip and its goal at the end
 */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "instruments.h"
#include "model.h"
#include MPC_HEADER

enum {
    SAMPLES = 60,
    STEPS = 20 /* of the plant in a sample, one millisecond each */
};

static const real DT = (real)1e-3, HEAVIER = (real)1.3;

static M(parameters) parameters;
static M(constants) model, plant;
static M(state) state;
static M(input) input;
static M(output) output;
static M(work) work;
static M(mpc_options) options;
static M(mpc) controller;

/* Every joint at 0, where the arm is straight and horizontal, and the modes as they hang at rest there. */
static int prepare(void)
{
    M(parameters_default)(&parameters);
    if (M(prepare)(&parameters, &model) != N(OK)) {
        return 1;
    }
    parameters.PAYLOAD *= HEAVIER;
    M(mpc_default)(&options);
    return M(prepare)(&parameters, &plant) != N(OK);
}

static void print_number(real x)
{
    const double value = (double)x;
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    printf(" %08lx%08lx", (unsigned long)(bits >> 32), (unsigned long)(bits & 0xFFFFFFFFu));
}

static void print_sample(int number)
{
    int k;
    printf("sample %d", number);
    for (k = 0; k < N(NTAU); ++k) {
        print_number(input.tau[k]);
    }
    for (k = 0; k < 3; ++k) {
        print_number(output.tip_position[k]);
    }
    printf("\n");
}

/* A sample: the torques of the last one act while those of the next are found. */
static int sample(int n, int *unsolved, int *iterations)
{
    real tau[N(NTAU)];
    int k;
    if (n > 0) {
        printf("count preparation 1\n");
        count_begin();
        if (M(mpc_prepare)(&controller, &options, &model) != N(OK)) {
            return 1;
        }
        count_end();
    }
    memcpy(input.tau, controller.acting, sizeof tau);
    printf("count %s 1\n", n > 0 ? "feedback" : "first_feedback");
    count_begin();
    if (M(mpc_feedback)(&controller, &options, &model, &state, tau) != N(OK)) {
        return 1;
    }
    count_end();
    *unsolved += controller.outcome != N(MPC_SOLVED);
    *iterations = controller.iterations > *iterations ? controller.iterations : *iterations;
    for (k = 0; k < STEPS; ++k) {
        if (M(step_modal_midpoint)(&plant, &state, &input, DT, &work) != N(OK)) {
            return 1;
        }
    }
    if (M(forward_dynamics)(&plant, &state, &input, &work, &output) != N(OK)) {
        return 1;
    }
    print_sample(n);
    return 0;
}

static int run(void)
{
    int n, k, unsolved = 0, iterations = 0;
    double miss = 0;
    printf("count start 1\n");
    count_begin();
    if (M(mpc_initialise)(&controller, &options, &model, &state, 0) != N(OK)) {
        return 1;
    }
    count_end();
    printf("figure start_iterations %d\n", controller.iterations);
    for (n = 0; n < SAMPLES; ++n) {
        if (sample(n, &unsolved, &iterations)) {
            return 1;
        }
    }
    for (k = 0; k < 3; ++k) {
        const double off = (double)(output.tip_position[k] - options.reference[0].tip_position[k]);
        miss += off * off;
    }
    printf("figure active %d\n", (int)(sizeof controller.qp_set / sizeof controller.qp_set[0]));
    printf("figure unsolved %d\n", unsolved);
    printf("figure iterations %d\n", iterations);
    printf("figure miss %ld\n", (long)(1e9 * sqrt(miss)));
    return 0;
}

/* What the calls leave behind is not used any more. */
static void measure_stacks(void)
{
    real tau[N(NTAU)];
    STACK("mpc_prepare", M(mpc_prepare)(&controller, &options, &model));
    STACK("mpc_feedback", M(mpc_feedback)(&controller, &options, &model, &state, tau));
    STACK("mpc_initialise", M(mpc_initialise)(&controller, &options, &model, &state, 0));
}

int main(void)
{
    printf("size mpc %u\n", (unsigned)sizeof(M(mpc)));
    printf("size mpc_options %u\n", (unsigned)sizeof(M(mpc_options)));
    printf("size constants %u\n", (unsigned)sizeof(M(constants)));
    count_known();
    if (prepare() || run()) {
        printf("failed\n");
        return 1;
    }
    measure_stacks();
    printf("done\n");
    return 0;
}
