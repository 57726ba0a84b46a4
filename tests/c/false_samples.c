/* false_samples.c: predictive control in closed loop under false samples. Usage: false_samples [stride].
 *
 * For a controller named "robot"; the arm is the controller's own model. From rest it moves to the goal; at sample FALSE the
 * controller is given what is false: a coordinate or rate off by twelve sizes, constant or of alternating sign, a state of
 * some samples ago, one that is frozen. For as many samples NaN is what the others are compared with: the arm must be at
 * its goal after at most one and a half times as long, and a sample. An arm that was truly pushed or moved is believed:
 * it must be there as soon as one whose controller believes all samples, and as many samples later as it may refuse.
 * Torques are within their bounds at every sample. stride: every so many-th case. Exit status 0 if nothing failed.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "driver.h"
#include "robot_mpc.h"

enum { SAMPLES = 260, FALSE_AT = 8, STEPS = 20, SIZES = 12, STATES = ROBOT_MPC_STATES };

typedef enum { MISSING, CONSTANT, ALTERNATING, STALE, FROZEN, PUSHED } fault;

typedef struct {
    fault fault;
    int entry, length;
    double size;
} trouble;

static const double SIZE[SIZES] = { 1e-3, 0.03, 0.3, 1, 3, 10, 30, 100, 1e3, 1e6, 1e20, 1e150 };
static const char *const NAMES[] = { "missing", "constant", "alternating", "stale", "frozen", "pushed" };

static robot_constants constants;
static robot_mpc_options options;
static robot_mpc mpc;
static robot_state history[SAMPLES];
static robot_work work;
static int most_refused;

static double *entry_of(robot_state *x, int i)
{
    return i < ROBOT_NQ ? &x->q[i] : &x->v[i - ROBOT_NQ];
}

/* Whether the joints are at their goal and slow. */
static int there(const robot_state *x)
{
    int i;
    for (i = 0; i < ROBOT_NTAU; ++i) {
        if (!(fabs(x->q[i] - options.reference[0].q[i]) < 0.02 && fabs(x->v[i]) < 0.1)) {
            return 0;
        }
    }
    return 1;
}

/* What the controller is told at a sample. */
static robot_state told(const trouble *t, int k)
{
    robot_state x = history[k];
    const int n = k - FALSE_AT;
    if (n < 0 || n >= t->length) {
        return x;
    }
    switch (t->fault) {
    case MISSING:
        x.q[0] = (robot_real)NAN;
        break;
    case CONSTANT:
    case ALTERNATING:
        *entry_of(&x, t->entry) += t->fault == ALTERNATING && n % 2 ? -t->size : t->size;
        break;
    case STALE:
        x = history[k - (int)t->size];
        break;
    case FROZEN:
        x = history[FALSE_AT - (int)t->size];
        break;
    case PUSHED:
        break;
    }
    return x;
}

/* Samples from the first false one until the arm is at its goal for good. */
static int samples_until_there(const trouble *t)
{
    robot_state state, start;
    robot_input input;
    robot_real tau[ROBOT_NTAU], acting[ROBOT_NTAU];
    int k, i, n, last = 0;
    memset(&state, 0, sizeof state);
    memset(&input, 0, sizeof input);
    {
        static robot_chain chain;
        static robot_real force[ROBOT_LENGTH(ROBOT_NV)];
        expect(robot_gravity(&constants, &state, &input, &chain, force, &state) == ROBOT_OK, "no rest at the start", 0);
    }
    start = state;
    expect(robot_mpc_initialise(&mpc, &options, &constants, &start, 0) == ROBOT_OK, "no plan", 0);
    most_refused = 0;
    for (k = 0; k < SAMPLES; ++k) {
        if (t->fault == PUSHED && k == FALSE_AT) {
            *entry_of(&state, t->entry) += t->size;
        }
        history[k] = state;
        memcpy(acting, mpc.acting, sizeof acting);
        if (k > 0) {
            (void)robot_mpc_prepare(&mpc, &options, &constants);
        }
        start = told(t, k);
        (void)robot_mpc_feedback(&mpc, &options, &constants, &start, tau);
        most_refused = mpc.refused > most_refused ? mpc.refused : most_refused;
        for (i = 0; i < ROBOT_NTAU; ++i) {
            expect(tau[i] >= options.torque_lower[i] && tau[i] <= options.torque_upper[i], "a torque out of bounds", k);
        }
        memcpy(input.tau, options.delay ? acting : tau, sizeof tau);
        for (n = 0; n < STEPS; ++n) {
            if (robot_step_modal_midpoint(&constants, &state, &input, (robot_real)(SAMPLE / STEPS), &work) != ROBOT_OK) {
                return SAMPLES;
            }
        }
        if (!there(&state)) {
            last = k + 1;
        }
    }
    return last > FALSE_AT ? last - FALSE_AT : 0;
}

static int cases, failed, number, stride = 1;
static double worst;

static void compare(const trouble *t, double allowed, double reference)
{
    const int found = samples_until_there(t), before = failures;
    const double ratio = reference > 0 ? found / reference : 0;
    ++cases;
    worst = ratio > worst ? ratio : worst;
    expect(found <= allowed, NAMES[t->fault], found);
    if (failures > before) {
        ++failed;
        printf("  entry %d, size %g, %d samples: %d samples, %g allowed, %d refused\n", t->entry, t->size, t->length, found,
            allowed, most_refused);
    }
}

/* Everything false for as many samples as NaN is given. */
static void bursts(int length)
{
    const trouble missing = { MISSING, 0, length, 0 };
    const double reference = samples_until_there(&missing);
    trouble t = missing;
    int i, s;
    ++cases;
    printf("%d samples without a state: at the goal after %g\n", length, reference);
    expect(reference < SAMPLES - FALSE_AT - 1, "a missing state", length);
    for (t.fault = CONSTANT; t.fault <= ALTERNATING; ++t.fault) {
        for (t.entry = 0; t.entry < STATES; ++t.entry) {
            for (s = 0; s < SIZES && (t.fault == CONSTANT || length > 1); ++s) {
                t.size = (t.entry + s) % 2 ? -SIZE[s] : SIZE[s];
                if (number++ % stride == 0) {
                    compare(&t, 1.5 * reference + 1, reference);
                }
            }
        }
    }
    t.entry = 0;
    for (t.fault = STALE; t.fault <= FROZEN; ++t.fault) {
        for (i = 1; i < FALSE_AT; i += 2) {
            t.size = i;
            compare(&t, 1.5 * reference + 1, reference);
        }
    }
}

/* What happens to the arm itself. */
static void pushes(void)
{
    trouble t = { PUSHED, 0, 0, 0 };
    int s, j;
    for (j = 0; j < 2 * ROBOT_NTAU; ++j) {
        t.entry = j < ROBOT_NTAU ? j : ROBOT_NQ + j - ROBOT_NTAU;
        for (s = 1; s < (j < ROBOT_NTAU ? 4 : 6); ++s) {
            const int patience = options.patience;
            int all;
            t.size = (s % 2 ? -1 : 1) * (s < 4 ? SIZE[s] : 2 * s - 6);
            options.patience = 0;
            all = samples_until_there(&t);
            options.patience = patience;
            if (all < SAMPLES - FALSE_AT - 40) { /* else the arm is past help */
                compare(&t, 1.5 * all + patience + 1, all);
            }
        }
    }
}

int main(int argc, char **argv)
{
    robot_parameters p;
    stride = argc > 1 ? atoi(argv[1]) : 1;
    robot_parameters_default(&p);
    robot_mpc_default(&options);
    expect(robot_prepare(&p, &constants) == ROBOT_OK, "the default parameters were refused", 0);
    bursts(1);
    bursts(3);
    bursts(10);
    printf("false: %d cases, %d failed, at most %.2f times as long as without a state\n", cases, failed, worst);
    worst = 0;
    pushes();
    printf("%d cases, %d failures; pushed: at most %.2f times as long\n", cases, failures, worst);
    return failures != 0;
}
