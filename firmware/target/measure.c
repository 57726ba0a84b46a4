/* measure.c: runs the model on a board or on a host and prints what it finds, one line each:
 *
 *   size NAME BYTES          of the structs that a caller owns
 *   count NAME TIMES         the next TIMES intervals between count_begin and count_end are these calls
 *   stack NAME BYTES         deepest stack of the call, from painted memory
 *   sample NUMBER BITS...    q, v and the tip's position in the simulation, the bits of doubles
 *   done
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "instruments.h"
#include "model.h"

enum {
    STEPS = 1000, /* of the simulation, one millisecond each */
    EVERY = 20    /* steps between samples */
};

static const real DT = (real)1e-3;

static M(parameters) parameters;
static M(constants) constants;
static M(input) input;
static M(output) output;
static M(work) work;
static M(dae_work) dae_work;

/* --------------------------------------------------------------------------------------- what is run */

static void print_sizes(void)
{
    printf("size parameters %u\n", (unsigned)sizeof(M(parameters)));
    printf("size constants %u\n", (unsigned)sizeof(M(constants)));
    printf("size state %u\n", (unsigned)sizeof(M(state)));
    printf("size input %u\n", (unsigned)sizeof(M(input)));
    printf("size output %u\n", (unsigned)sizeof(M(output)));
    printf("size work %u\n", (unsigned)sizeof(M(work)));
    printf("size dae_state %u\n", (unsigned)sizeof(M(dae_state)));
    printf("size dae_work %u\n", (unsigned)sizeof(M(dae_work)));
}

__attribute__((noinline)) static void run_prepare(void)
{
    printf("count prepare 1\n");
    COUNT(M(prepare)(&parameters, &constants));
    STACK("prepare", M(prepare)(&parameters, &constants));
}

/* At every state of the self-check: angles of any size, so every branch of the elementary functions. */
__attribute__((noinline)) static void run_dynamics(void)
{
    static M(state) state;
    static M(dae_state) dae;
    int i;
    printf("count forward_dynamics %d\n", (int)N(CASES));
    for (i = 0; i < N(CASES); ++i) {
        state = M(cases)[i].state;
        input = M(cases)[i].input;
        COUNT(M(forward_dynamics)(&constants, &state, &input, &work, &output));
    }
    for (i = 0; i < N(CASES); ++i) {
        state = M(cases)[i].state;
        input = M(cases)[i].input;
        STACK("forward_dynamics", M(forward_dynamics)(&constants, &state, &input, &work, &output));
    }
    printf("count dae_forward_dynamics %d\n", (int)N(CASES));
    for (i = 0; i < N(CASES); ++i) {
        (void)M(dae_from_state)(&constants, &M(cases)[i].state, &dae_work, &dae);
        COUNT(M(dae_forward_dynamics)(&constants, &dae, &M(cases)[i].input, &dae_work, &output));
        STACK("dae_forward_dynamics", M(dae_forward_dynamics)(&constants, &dae, &M(cases)[i].input, &dae_work, &output));
    }
}

/* One step from every state of the self-check. */
#define STEP(number, method)                                                                                        \
    __attribute__((noinline)) static void run_##method(void)                                                        \
    {                                                                                                               \
        static M(state) state;                                                                                      \
        static M(dae_state) dae;                                                                                    \
        int i;                                                                                                      \
        printf("count step_" #method " %d\ncount dae_step_" #method " %d\n", (int)N(CASES), (int)N(CASES));         \
        for (i = 0; i < N(CASES); ++i) {                                                                            \
            state = M(cases)[i].state;                                                                              \
            COUNT(M(step_##method)(&constants, &state, &M(cases)[i].input, DT, &work));                             \
            state = M(cases)[i].state;                                                                              \
            STACK("step_" #method, M(step_##method)(&constants, &state, &M(cases)[i].input, DT, &work));            \
        }                                                                                                           \
        for (i = 0; i < N(CASES); ++i) {                                                                            \
            (void)M(dae_from_state)(&constants, &M(cases)[i].state, &dae_work, &dae);                               \
            COUNT(M(dae_step_##method)(&constants, &dae, &M(cases)[i].input, DT, &dae_work));                       \
            (void)M(dae_from_state)(&constants, &M(cases)[i].state, &dae_work, &dae);                               \
            STACK("dae_step_" #method, M(dae_step_##method)(&constants, &dae, &M(cases)[i].input, DT, &dae_work));  \
        }                                                                                                           \
    }
METHODS
#undef STEP

/* --------------------------------------------------------------------------------------- simulation */

static void print_number(real x)
{
    const double wide = (double)x;
    uint64_t bits;
    memcpy(&bits, &wide, sizeof bits);
    printf(" %08lx%08lx", (unsigned long)(bits >> 32), (unsigned long)(bits & 0xFFFFFFFFu));
}

static M(status) print_sample(int number, const M(state) *state)
{
    const M(status) status = M(forward_dynamics)(&constants, state, &input, &work, &output);
    int k;
    if (status != N(OK)) {
        return status;
    }
    printf("sample %d", number);
    for (k = 0; k < N(NQ); ++k) {
        print_number(state->q[k]);
    }
    for (k = 0; k < N(NV); ++k) {
        print_number(state->v[k]);
    }
    for (k = 0; k < 3; ++k) {
        print_number(output.tip_position[k]);
    }
    printf("\n");
    return status;
}

/* The arm falls from rest, bent at every joint, against springs and dampers so soft that it swings. It ends early in a
 * state for which the model has no accelerations. */
static int simulate(void)
{
    static M(state) state;
    M(status) status = N(OK);
    int n, k, counted = 0;
    memset(&state, 0, sizeof state);
    memset(&input, 0, sizeof input);
    for (k = 0; k < N(NTAU); ++k) {
        state.q[k] = (real)0.5;
    }
    for (n = 0; n < STEPS && status == N(OK); ++n) {
        for (k = 0; k < N(NTAU); ++k) {
            input.tau[k] = -40 * state.q[k] - 4 * state.v[k];
        }
        if (n % EVERY == 0) {
            status = print_sample(n, &state);
        }
        if (status == N(OK)) {
            count_begin();
            status = M(step_modal_implicit)(&constants, &state, &input, DT, &work);
            count_end();
            ++counted;
        }
    }
    printf("count simulation_step %d\n", counted);
    if (status == N(OK)) {
        status = print_sample(STEPS, &state);
    }
    if (status == N(SINGULAR)) {
        printf("singular %d\n", counted);
    }
    return status != N(OK) && status != N(SINGULAR);
}

int main(void)
{
    M(parameters_default)(&parameters);
    print_sizes();
    count_known();
    run_prepare();
    run_dynamics();
#define STEP(number, method) run_##method();
    METHODS
#undef STEP
    if (simulate()) {
        printf("failed\n");
        return 1;
    }
    printf("done\n");
    return 0;
}
