/* slopes.c: a step and the same with its derivatives, of the example arm on a board. Prints, besides what measure.c prints of
 * sizes, counts and stacks,
 *
 *   sample 0 BITS...   the state after the step and its derivatives A and B, row by row, the bits of doubles
 */
#include <stdint.h>
#include <string.h>

#ifdef CONSOLE
#include "instruments.h"
#endif
#include "model.h"
#include SLOPES_HEADER

static const real DT = (real)1e-3;

static M(parameters) parameters;
static M(constants) constants;
static M(state) state;
static M(input) input;
#if defined(CONSOLE) || defined(STEP_ALONE)
static M(work) work;
#endif
#ifndef STEP_ALONE
static M(state) next;
static M(step_derivatives) slopes;
static M(step_derivatives_work) scratch;
#endif

#ifdef CONSOLE
enum { NX = 2 * N(NV) };

static void print_numbers(const real *values, int count)
{
    int k;
    for (k = 0; k < count; ++k) {
        const double value = (double)values[k];
        uint64_t bits;
        memcpy(&bits, &value, sizeof bits);
        printf(" %08lx%08lx", (unsigned long)(bits >> 32), (unsigned long)(bits & 0xFFFFFFFFu));
    }
}

/* In every coordinate another number; coordinates of modes are small. */
static void start(void)
{
    int k;
    for (k = 0; k < N(NQ); ++k) {
        state.q[k] = k < N(NTAU) ? (real)0.1 * (real)(k + 1) : (real)1e-3 * (real)(k - N(NTAU) + 1);
        state.v[k] = (real)0.2 - (real)0.01 * (real)k;
    }
    for (k = 0; k < N(NTAU); ++k) {
        input.tau[k] = (real)(20 - 5 * k);
    }
}

int main(void)
{
    printf("size slopes %u\n", (unsigned)(sizeof slopes + sizeof scratch));
    printf("size others %u\n", (unsigned)(sizeof constants + 2 * sizeof state + sizeof input + sizeof work));
    count_known();
    M(parameters_default)(&parameters);
    start();
    next = state;
    if (M(prepare)(&parameters, &constants) != N(OK)) {
        printf("failed\n");
        return 1;
    }
    printf("count step 1\ncount slopes 1\n");
    COUNT(M(step_modal_implicit)(&constants, &next, &input, DT, &work));
    count_begin();
    if (M(step_modal_implicit_derivatives)(&constants, &state, &input, DT, &scratch, &next, &slopes) != N(OK)) {
        printf("failed\n");
        return 1;
    }
    count_end();
    printf("sample 0");
    print_numbers(next.q, N(NQ));
    print_numbers(next.v, N(NV));
    print_numbers(&slopes.A[0][0], NX * NX);
    print_numbers(&slopes.B[0][0], NX * N(NTAU));
    printf("\n");
    STACK("step_modal_implicit_derivatives",
          M(step_modal_implicit_derivatives)(&constants, &state, &input, DT, &scratch, &next, &slopes));
    printf("done\n");
    return 0;
}
#else
int main(void)
{
    M(parameters_default)(&parameters);
    if (M(prepare)(&parameters, &constants) != N(OK)) {
        return 1;
    }
    for (;;) {
#ifdef STEP_ALONE
        (void)M(step_modal_implicit)(&constants, &state, &input, DT, &work);
#else
        (void)M(step_modal_implicit_derivatives)(&constants, &state, &input, DT, &scratch, &next, &slopes);
#endif
    }
}
#endif
