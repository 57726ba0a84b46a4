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

#include "model.h"

enum {
    STEPS = 1000, /* of the simulation, one millisecond each */
    EVERY = 20,   /* steps between samples */
    TURNS = 1000  /* of the loop whose instructions are known */
};

static const real DT = (real)1e-3;

static M(parameters) parameters;
static M(constants) constants;
static M(input) input;
static M(output) output;
static M(work) work;
static M(dae_work) dae_work;

/* The counter looks at the addresses of these two. */
__attribute__((noinline, noclone)) void count_begin(void);
__attribute__((noinline, noclone)) void count_end(void);

void count_begin(void)
{
    __asm volatile("" : : : "memory");
}

void count_end(void)
{
    __asm volatile("" : : : "memory");
}

#define COUNT(call)         \
    do {                    \
        count_begin();      \
        (void)(call);       \
        count_end();        \
    } while (0)

/* ------------------------------------------------------------------------------------ painted stack */

enum { PAINTED = 16384 }; /* bytes below the stack pointer */
#define PAINT 0xA5u

#if defined(__arm__)
#define STACK_POINTER(p) __asm volatile("mov %0, sp" : "=r"(p) : : "memory")
#elif defined(__riscv)
#define STACK_POINTER(p) __asm volatile("mv %0, sp" : "=r"(p) : : "memory")
#endif

#ifdef STACK_POINTER
/* Paints below the stack pointer, calls, looks for the deepest byte that has changed. Nothing is pushed in between but
 * by the call itself, and no interrupt is enabled.
 */
#define STACK(name, call)                                                   \
    do {                                                                    \
        volatile unsigned char *sp_, *deepest_;                             \
        long used_;                                                         \
        STACK_POINTER(sp_);                                                 \
        for (deepest_ = sp_ - PAINTED; deepest_ < sp_; ++deepest_) {        \
            *deepest_ = PAINT;                                              \
        }                                                                   \
        (void)(call);                                                       \
        deepest_ = sp_ - PAINTED;                                           \
        while (deepest_ < sp_ && *deepest_ == PAINT) {                      \
            ++deepest_;                                                     \
        }                                                                   \
        used_ = (long)(sp_ - deepest_);                                     \
        printf("stack %s %ld\n", name, used_);                              \
    } while (0)
#else
#define STACK(name, call) (void)(call)
#endif

/* --------------------------------------------------------------------------------------- what is run */

/* A loop of two instructions between begin and end, all in one piece: twice the turns must count twice the loop. */
__attribute__((noinline, noclone)) static void known(long turns)
{
#if defined(__arm__)
    register long n __asm("r4") = turns;
    __asm volatile("bl count_begin\n1:\tsubs %0, #1\n\tbne 1b\n\tbl count_end"
                   : "+r"(n) : : "r0", "r1", "r2", "r3", "r12", "lr", "cc", "memory");
#elif defined(__riscv)
    register long n __asm("s1") = turns;
    __asm volatile("call count_begin\n1:\taddi %0, %0, -1\n\tbnez %0, 1b\n\tcall count_end"
                   : "+r"(n) : : "ra", "t0", "t1", "t2", "t3", "t4", "t5", "t6", "memory");
#else
    (void)turns;
#endif
}

static void count_known(void)
{
    printf("count empty 1\ncount known 2\n");
    count_begin();
    count_end();
    known(TURNS);
    known(2 * TURNS);
}

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

static int print_sample(int number, const M(state) *state)
{
    int k;
    if (M(forward_dynamics)(&constants, state, &input, &work, &output) != N(OK)) {
        return 1;
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
    return 0;
}

/* The arm falls from rest, bent at every joint, against springs and dampers so soft that it swings. */
static int simulate(void)
{
    static M(state) state;
    int n, k;
    memset(&state, 0, sizeof state);
    memset(&input, 0, sizeof input);
    for (k = 0; k < N(NTAU); ++k) {
        state.q[k] = (real)0.5;
    }
    printf("count simulation_step %d\n", (int)STEPS);
    for (n = 0; n < STEPS; ++n) {
        for (k = 0; k < N(NTAU); ++k) {
            input.tau[k] = -40 * state.q[k] - 4 * state.v[k];
        }
        if (n % EVERY == 0 && print_sample(n, &state)) {
            return 1;
        }
        count_begin();
        if (M(step_modal_implicit)(&constants, &state, &input, DT, &work) != N(OK)) {
            return 1;
        }
        count_end();
    }
    return print_sample(STEPS, &state);
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
