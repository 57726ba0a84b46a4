/* motions.c: what moves the example arm on a board, at every millisecond: a plan is asked for references and torques, the
 * feedforward for the efforts of these references, a scheduled shaper shapes them, joint gains and a linear-quadratic law
 * with its filter follow what is shaped. Prints what measure.c prints of counts and stacks; samples have the plan's
 * coordinates, rates and torques, the efforts of the step before, shaped coordinates and rates, efforts of both laws.
 *
 * Without -DCONSOLE it is the image of what a clock calls: the plan, with what -DFEEDFORWARD, -DSHAPER, -DGAINS or -DLAW adds.
 */
#include <stdint.h>
#include <string.h>

#include "ella_plan.h"

#ifdef CONSOLE
#define FEEDFORWARD
#define SHAPER
#define GAINS
#define LAW
#endif

enum { JOINTS = ELLA_PLAN_JOINTS };

static const double STEP = 1e-3; /* s */

static ella_plan_state place;
static ella_plan_reference out;

#ifdef FEEDFORWARD
#include "ella_feedforward_efforts.h"

static ella_feedforward_parameters parameters;
static ella_feedforward_constants constants;
static ella_feedforward_input none;
static ella_feedforward_state state;
static ella_feedforward_efforts_work work;
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

#ifdef SHAPER
#include "ella_shaper.h"

static ella_shaper_state ring;
static double shaped[JOINTS], shaped_rate[JOINTS];
#endif

#ifdef GAINS
#include "ella_law.h"

static ella_law_state latest;
static ella_law_input joints;
static double held[JOINTS];
#endif

#ifdef LAW
#include "ella_lqg.h"

static ella_lqg_state memory;
static ella_lqg_input given;
static double effort[JOINTS];
#endif

#ifdef CONSOLE
#include "instruments.h"

enum { SAMPLES = 1201, SHOWN = 20 };

static const double LOAD = 1.1;

static void print_numbers(const double *x)
{
    int k;
    for (k = 0; k < JOINTS; ++k) {
        uint64_t bits;
        memcpy(&bits, &x[k], sizeof bits);
        printf(" %08lx%08lx", (unsigned long)(bits >> 32), (unsigned long)(bits & 0xffffffffu));
    }
}

static int start(void)
{
    memcpy(given.measured, out.q, sizeof out.q);
    given.load[0] = LOAD;
    return prepare() || ella_shaper_start(&ring, 0, out.q) != ELLA_SHAPER_OK || ella_law_start(&latest) != ELLA_LAW_OK
        || ella_lqg_start(&memory, &given) != ELLA_LQG_OK;
}

static int sample(int n)
{
    const double t = n * STEP;
    printf("count plan 1\n");
    count_begin();
    if (ella_plan_sample(&place, t, STEP, &out) != ELLA_PLAN_OK) {
        return 1;
    }
    count_end();
    if (n == 0) {
        return start();
    }
    printf("count feedforward 1\n");
    count_begin();
    if (ella_feedforward(&constants, &state, out.q, out.v, STEP, &work, tau) != ELLA_FEEDFORWARD_OK) {
        return 1;
    }
    count_end();
    printf("count shaper 1\n");
    count_begin();
    if (ella_shaper_sample(&ring, t, out.q, out.v, out.q, shaped, shaped_rate) != ELLA_SHAPER_OK) {
        return 1;
    }
    count_end();
    memcpy(joints.measured, out.q, sizeof out.q);
    memcpy(joints.rate, out.v, sizeof out.v);
    memcpy(joints.tau, out.tau, sizeof out.tau);
    memcpy(joints.q, shaped, sizeof shaped);
    memcpy(joints.v, shaped_rate, sizeof shaped_rate);
    printf("count gains 1\n");
    count_begin();
    if (ella_law_sample(&latest, t, &joints, held) != ELLA_LAW_OK) {
        return 1;
    }
    count_end();
    memcpy(given.measured, out.q, sizeof out.q);
    memcpy(given.q, shaped, sizeof shaped);
    printf("count law 1\n");
    count_begin();
    if (ella_lqg_sample(&memory, t, &given, effort) != ELLA_LQG_OK) {
        return 1;
    }
    count_end();
    if (n % SHOWN == 0) {
        printf("sample %d", n);
        print_numbers(out.q);
        print_numbers(out.v);
        print_numbers(out.tau);
        print_numbers(tau);
        print_numbers(shaped);
        print_numbers(shaped_rate);
        print_numbers(held);
        print_numbers(effort);
        printf("\n");
    }
    return 0;
}

int main(void)
{
    int n;
    printf("size plan %u\n", (unsigned)(sizeof place + sizeof out));
    printf("size feedforward %u\n", (unsigned)(sizeof constants + sizeof state + sizeof work));
    printf("size shaper %u\nsize gains %u\n", (unsigned)sizeof ring, (unsigned)(sizeof latest + sizeof joints));
    printf("size law %u\n", (unsigned)(sizeof memory + sizeof given));
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
    STACK("shaper_sample", ella_shaper_sample(&ring, SAMPLES * STEP, out.q, out.v, out.q, shaped, shaped_rate));
    STACK("law_sample", ella_law_sample(&latest, SAMPLES * STEP, &joints, held));
    STACK("lqg_sample", ella_lqg_sample(&memory, SAMPLES * STEP, &given, effort));
    printf("done\n");
    return 0;
}
#else
int main(void)
{
    static volatile double now;
    (void)ella_plan_start(&place, now);
#ifdef FEEDFORWARD
    (void)prepare();
#endif
#ifdef SHAPER
    (void)ella_shaper_start(&ring, now, out.q);
#endif
#ifdef GAINS
    (void)ella_law_start(&latest);
#endif
#ifdef LAW
    (void)ella_lqg_start(&memory, &given);
#endif
    for (;;) {
        (void)ella_plan_sample(&place, now, STEP, &out);
#ifdef FEEDFORWARD
        (void)ella_feedforward(&constants, &state, out.q, out.v, STEP, &work, tau);
#endif
#ifdef SHAPER
        (void)ella_shaper_sample(&ring, now, out.q, out.v, out.q, shaped, shaped_rate);
#endif
#ifdef GAINS
        memcpy(joints.q, out.q, sizeof out.q);
        (void)ella_law_sample(&latest, now, &joints, held);
#endif
#ifdef LAW
        memcpy(given.q, out.q, sizeof out.q);
        (void)ella_lqg_sample(&memory, now, &given, effort);
#endif
    }
}
#endif
