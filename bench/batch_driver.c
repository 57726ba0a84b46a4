/* Seconds of scalar and batch steps, interleaved: one line per method and round, nanoseconds per scenario and step.
 * ROBOT is the robot's name, ROBOT_UPPER the same in capitals.
 */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define R(x) JOIN(ROBOT, x)
#define U(x) JOIN(ROBOT_UPPER, x)
#define TEXT_(x) #x
#define TEXT(x) TEXT_(x)
#include BATCH_HEADER

typedef R(_real) real;
typedef R(_status) (*scalar_step)(const R(_constants) *, R(_state) *, const R(_input) *, real, R(_work) *);
typedef R(_status) (*batch_step)(const R(_constants) *, const R(_batch) *, real, int);

enum { SCENARIOS = 256, STEPS = 4 };
static const real DT = (real)1e-5;

static R(_constants) constants;
static R(_state) states[SCENARIOS];
static R(_input) inputs[SCENARIOS];
static R(_work) work;
static real q[U(_LENGTH)(U(_NQ))][SCENARIOS], v[U(_LENGTH)(U(_NV))][SCENARIOS], tau[U(_LENGTH)(U(_NTAU))][SCENARIOS];
static int status[SCENARIOS];

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static real draw(double size)
{
    return (real)((2.0 * rand() / RAND_MAX - 1.0) * size);
}

/* The same states and torques for both. */
static void start(void)
{
    int i, k;
    srand(1);
    memset(inputs, 0, sizeof inputs);
    memset(status, 0, sizeof status);
    for (i = 0; i < SCENARIOS; ++i) {
        for (k = 0; k < U(_NQ); ++k) {
            q[k][i] = states[i].q[k] = draw(k < U(_NTAU) ? 3.0 : 1e-5);
            v[k][i] = states[i].v[k] = draw(k < U(_NTAU) ? 2.0 : 1e-4);
        }
        for (k = 0; k < U(_NTAU); ++k) {
            tau[k][i] = inputs[i].tau[k] = draw(10.0);
        }
    }
}

static void measure(const char *name, scalar_step one, batch_step many, int rounds)
{
    const R(_batch) batch = { .count = SCENARIOS, .stride = SCENARIOS, .q = q[0], .v = v[0], .tau = tau[0], .status = status };
    int round, i, k, bad = 0;
    for (round = -1; round < rounds; ++round) {
        double t0, t1, t2;
        start();
        t0 = now();
        for (i = 0; i < SCENARIOS; ++i) {
            for (k = 0; k < STEPS; ++k) {
                bad |= (int)one(&constants, &states[i], &inputs[i], DT, &work);
            }
        }
        t1 = now();
        bad |= (int)many(&constants, &batch, DT, STEPS);
        t2 = now();
        for (i = 0; i < SCENARIOS; ++i) {
            bad |= status[i];
        }
        if (bad) {
            fprintf(stderr, "%s: a step fails\n", name);
            exit(1);
        }
        if (round >= 0) {
            printf("%s %.3f %.3f\n", name, 1e9 * (t1 - t0) / SCENARIOS / STEPS, 1e9 * (t2 - t1) / SCENARIOS / STEPS);
        }
    }
}

int main(int argc, char **argv)
{
    const int rounds = argc > 1 ? atoi(argv[1]) : 31;
    R(_parameters) parameters;
    R(_parameters_default)(&parameters);
    if (R(_prepare)(&parameters, &constants)) {
        return 1;
    }
    measure("semi_implicit", R(_step_semi_implicit), R(_step_batch_semi_implicit), rounds);
    measure("modal_midpoint", R(_step_modal_midpoint), R(_step_batch_modal_midpoint), rounds);
    measure("rk4", R(_step_rk4), R(_step_batch_rk4), rounds);
    return 0;
}
