/* motions.c: a plan and a feedforward of the example arm on a board. At every millisecond the plan is asked for references and
 * torques, and the feedforward for the efforts of these references. Prints what measure.c prints of counts and stacks; samples
 * have the plan's coordinates, rates and torques, then the efforts of the step before.
 *
 * Without -DCONSOLE it is the image of what a clock calls: with -DPLAN_ALONE of the plan, else of both.
 */
#include <stdint.h>
#include <string.h>

#include "ella_plan.h"
#ifndef PLAN_ALONE
#include "ella_feedforward_efforts.h"

static ella_feedforward_parameters parameters;
static ella_feedforward_constants constants;
static ella_feedforward_input none;
static ella_feedforward_state state;
static ella_feedforward_efforts_work work;
#endif

enum { JOINTS = ELLA_PLAN_JOINTS };

static const double STEP = 1e-3; /* s */

static ella_plan_state place;
static ella_plan_reference out;

#ifndef PLAN_ALONE
static double tau[JOINTS];

static int prepare(void)
{
    double force[ELLA_FEEDFORWARD_NV];
    int k;
    ella_feedforward_parameters_default(&parameters);
    if (ella_feedforward_prepare(&parameters, &constants) != ELLA_FEEDFORWARD_OK) {
        return 1;
    }
    memcpy(state.q, out.q, sizeof out.q);
    for (k = 0; k < 5; ++k) {
        if (ella_feedforward_gravity(&constants, &state, &none, &work.chain, force, &state) != ELLA_FEEDFORWARD_OK) {
            return 1;
        }
    }
    return 0;
}
#endif

#ifdef CONSOLE
#include "instruments.h"

enum { SAMPLES = 1201, SHOWN = 20 };

static void print_numbers(const double *x, int n)
{
    int k;
    for (k = 0; k < n; ++k) {
        uint64_t bits;
        memcpy(&bits, &x[k], sizeof bits);
        printf(" %08lx%08lx", (unsigned long)(bits >> 32), (unsigned long)(bits & 0xffffffffu));
    }
}

static int sample(int n)
{
    printf("count plan 1\n");
    count_begin();
    if (ella_plan_sample(&place, n * STEP, STEP, &out) != ELLA_PLAN_OK) {
        return 1;
    }
    count_end();
    if (n == 0) {
        return prepare();
    }
    printf("count feedforward 1\n");
    count_begin();
    if (ella_feedforward(&constants, &state, out.q, out.v, STEP, &work, tau) != ELLA_FEEDFORWARD_OK) {
        return 1;
    }
    count_end();
    if (n % SHOWN == 0) {
        printf("sample %d", n);
        print_numbers(out.q, JOINTS);
        print_numbers(out.v, JOINTS);
        print_numbers(out.tau, JOINTS);
        print_numbers(tau, JOINTS);
        printf("\n");
    }
    return 0;
}

int main(void)
{
    int n;
    printf("size plan %u\nsize constants %u\n", (unsigned)(sizeof place + sizeof out), (unsigned)sizeof constants);
    printf("size state %u\nsize work %u\n", (unsigned)sizeof state, (unsigned)sizeof work);
    count_known();
    if (ella_plan_start(&place, 0) != ELLA_PLAN_OK) {
        return 1;
    }
    for (n = 0; n < SAMPLES; ++n) {
        if (sample(n)) {
            printf("failed\n");
            return 1;
        }
    }
    STACK("plan_sample", ella_plan_sample(&place, 1.5, STEP, &out));
    STACK("feedforward", ella_feedforward(&constants, &state, out.q, out.v, STEP, &work, tau));
    printf("done\n");
    return 0;
}
#else
int main(void)
{
    static volatile double now;
    (void)ella_plan_start(&place, now);
#ifndef PLAN_ALONE
    (void)prepare();
#endif
    for (;;) {
        (void)ella_plan_sample(&place, now, STEP, &out);
#ifndef PLAN_ALONE
        (void)ella_feedforward(&constants, &state, out.q, out.v, STEP, &work, tau);
#endif
    }
}
#endif
