/* Times of the generated controller: the samples of a recorded closed loop again, each phase between two clock_gettime.
 *
 * Usage: timing RECORD TIMES REPEATS MASS [cold].  RECORD: doubles, for each sample q, v, the references of all stages and the
 * torques that were found; the first is the one at rest before the motion.  TIMES gets, for each sample but those, the
 * seconds of preparation and feedback by the wall, then by the thread's processor time.  cold: between two samples memory
 * larger than the second-level cache is walked through.  Prints the largest difference from the recorded torques, N*m, and
 * whether the thread was bound to one core.
 */
#define _GNU_SOURCE
#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "ella_mpc.h"

enum { STAGES = ELLA_MPC_INTERVALS + 1, CACHE = 8 << 20 };

typedef struct {
    double q[ELLA_NQ], v[ELLA_NV];
    ella_mpc_reference reference[STAGES];
    double tau[ELLA_NTAU];
} sample;

static ella_parameters parameters;
static ella_constants constants;
static ella_mpc_options options;
static ella_mpc mpc;
static volatile char others[CACHE];

static double now(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void stamp(double at[2])
{
    at[1] = now(CLOCK_THREAD_CPUTIME_ID);
    at[0] = now(CLOCK_MONOTONIC);
}

static int bind(void)
{
#ifdef __linux__
    cpu_set_t set;
    const int core = sched_getcpu();
    CPU_ZERO(&set);
    CPU_SET(core < 0 ? 0 : core, &set);
    return sched_setaffinity(0, sizeof set, &set) == 0;
#else
    return 0;
#endif
}

static void refer(const sample *s)
{
    memcpy(options.reference, s->reference, sizeof options.reference);
}

static int feed(const sample *s, double *worst)
{
    ella_state state;
    ella_real tau[ELLA_NTAU];
    int i;
    memcpy(state.q, s->q, sizeof state.q);
    memcpy(state.v, s->v, sizeof state.v);
    if (ella_mpc_feedback(&mpc, &options, &constants, &state, tau) != ELLA_OK || mpc.outcome != ELLA_MPC_SOLVED) {
        return 0;
    }
    for (i = 0; i < ELLA_NTAU; ++i) {
        *worst = fmax(*worst, fabs(tau[i] - s->tau[i]));
    }
    return 1;
}

static int begin(const sample *s, double *worst)
{
    ella_state state;
    memcpy(state.q, s->q, sizeof state.q);
    memcpy(state.v, s->v, sizeof state.v);
    refer(s);
    return ella_mpc_initialise(&mpc, &options, &constants, &state, 0) == ELLA_OK && mpc.converged && feed(s, worst);
}

static int timed(const sample *s, double *worst, FILE *out)
{
    double a[2], b[2], c[2], row[4];
    stamp(a);
    refer(s);
    if (ella_mpc_prepare(&mpc, &options, &constants) != ELLA_OK) {
        return 0;
    }
    stamp(b);
    if (!feed(s, worst)) {
        return 0;
    }
    stamp(c);
    row[0] = b[0] - a[0];
    row[1] = c[0] - b[0];
    row[2] = b[1] - a[1];
    row[3] = c[1] - b[1];
    return fwrite(row, sizeof row, 1, out) == 1;
}

int main(int argc, char **argv)
{
    const int repeats = argc > 4 ? atoi(argv[3]) : 0, cold = argc > 5, bound = bind();
    FILE *in = argc > 4 ? fopen(argv[1], "rb") : 0, *out = argc > 4 ? fopen(argv[2], "wb") : 0;
    static sample samples[1000];
    double worst = 0;
    size_t k, count;
    int r, fine = in && out;
    if (!fine) {
        fprintf(stderr, "usage: timing RECORD TIMES REPEATS MASS [cold]\n");
        return 2;
    }
    count = fread(samples, sizeof *samples, sizeof samples / sizeof *samples, in);
    ella_parameters_default(&parameters);
    parameters.links[ELLA_LINK_FOREARM].bodies[0].mass = strtod(argv[4], 0);
    ella_mpc_default(&options);
    fine = ella_prepare(&parameters, &constants) == ELLA_OK;
    for (r = 0; r < repeats && fine; ++r) {
        fine = begin(&samples[0], &worst);
        for (k = 1; k < count && fine; ++k) {
            int i;
            for (i = 0; i < (cold ? CACHE : 0); i += 64) {
                others[i]++;
            }
            fine = timed(&samples[k], &worst, out);
        }
    }
    fclose(in);
    fine = fclose(out) == 0 && fine;
    printf("%.3g %d\n", worst, bound);
    return fine ? 0 : 1;
}
