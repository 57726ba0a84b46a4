/* mpc_abuse.c: the predictive controller of a model named "robot" in wrong order and with wild numbers. Exit status 0 if a
 * call without a plan is refused, no status is OK after one that failed, and every torque is finite and within its bounds.
 */
#include <math.h>

#include "driver.h"
#include "robot_mpc.h"

enum { ROUNDS = 3000 };

static const double WILD[] = { 0, NAN, INFINITY, -INFINITY, 1e308, -1e300, 1e18, -1e6, 1e3, -30, 1, 1e-3 };
static robot_constants constants;
static robot_mpc_options options;
static robot_real tau[ROBOT_NTAU];
static long calls[4];

static unsigned draw(unsigned n)
{
    static unsigned long long seed = 20240229;
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return (unsigned)(seed >> 33) % n;
}

static void within_bounds(int status)
{
    int i;
    ++calls[status & 3];
    for (i = 0; i < ROBOT_NTAU; ++i) {
        expect(isfinite(tau[i]) && tau[i] >= options.torque_lower[i] && tau[i] <= options.torque_upper[i], "a torque", status);
    }
}

/* Memory that nobody has initialised, a start that failed, a preparation that failed. */
static void out_of_order(robot_mpc *m)
{
    robot_state x = { { 0 }, { 0 } };
    memset(m, 0x5a, sizeof *m);
    expect(robot_mpc_prepare(m, &options, &constants) == ROBOT_BAD_ARGUMENT, "prepared before the start", 0);
    expect(robot_mpc_feedback(m, &options, &constants, &x, tau) == ROBOT_BAD_ARGUMENT, "fed back before the start", 0);
    within_bounds(ROBOT_BAD_ARGUMENT);
    x.v[0] = (robot_real)NAN;
    expect(robot_mpc_initialise(m, &options, &constants, &x, 0) != ROBOT_OK, "a start that is not finite", 0);
    x.v[0] = 0;
    expect(robot_mpc_prepare(m, &options, &constants) == ROBOT_BAD_ARGUMENT, "prepared after a start that failed", 0);
    expect(robot_mpc_feedback(m, &options, &constants, &x, tau) == ROBOT_BAD_ARGUMENT, "fed back after it", 0);
    within_bounds(ROBOT_BAD_ARGUMENT);
    expect(robot_mpc_initialise(m, &options, &constants, &x, 0) == ROBOT_OK, "no start", 0);
    options.terminal[0][0] = -1e9;
    expect(robot_mpc_prepare(m, &options, &constants) == ROBOT_SINGULAR, "an indefinite cost was prepared", 0);
    expect(robot_mpc_feedback(m, &options, &constants, &x, tau) == ROBOT_BAD_ARGUMENT, "fed back after a failed one", 0);
    within_bounds(ROBOT_BAD_ARGUMENT);
    robot_mpc_default(&options);
    expect(robot_mpc_prepare(m, &options, &constants) == ROBOT_OK, "no preparation after a failed one", 0);
    expect(robot_mpc_feedback(m, &options, &constants, &x, tau) == ROBOT_OK, "no feedback after a failed one", 0);
}

/* Any call, any order, any numbers. */
static void any_calls(robot_mpc *m)
{
    int ready = 0, k;
    for (k = 0; k < ROUNDS; ++k) {
        robot_state x = { { 0 }, { 0 } };
        const int entry = (int)draw(2 * ROBOT_NQ), call = (int)draw(12);
        const robot_real wild = (robot_real)WILD[draw(sizeof WILD / sizeof WILD[0])];
        *(entry < ROBOT_NQ ? &x.q[entry] : &x.v[entry - ROBOT_NQ]) = draw(3) ? 0 : wild;
        if (draw(4) == 0) {
            options.patience = (int)draw(4);
            options.margin = draw(2) ? 1 : wild;
            options.scatter[entry] = draw(2) ? 1 : wild;
            options.terminal[entry][entry] = draw(2) ? 1 : wild;
            options.joints[0] = draw(2) ? 1 : wild;
            options.penalty = draw(2) ? 1 : wild;
        }
        if (call == 0) {
            ready = robot_mpc_initialise(m, &options, &constants, &x, 0) == ROBOT_OK;
        } else if (call < 6) {
            ready = robot_mpc_prepare(m, &options, &constants) == ROBOT_OK;
        } else {
            const robot_status status = robot_mpc_feedback(m, &options, &constants, &x, tau);
            expect(status != ROBOT_OK || ready, "OK without a preparation", k);
            within_bounds((int)status);
            ready = 0;
        }
    }
}

int main(void)
{
    robot_mpc *m = scratch(sizeof *m);
    robot_parameters p;
    robot_parameters_default(&p);
    robot_mpc_default(&options);
    expect(robot_prepare(&p, &constants) == ROBOT_OK, "the default parameters were refused", 0);
    out_of_order(m);
    any_calls(m);
    free(m);
    printf("%ld ok, %ld non-finite, %ld singular, %ld bad argument; %d failures\n", calls[0], calls[1], calls[2], calls[3], failures);
    return failures != 0;
}
