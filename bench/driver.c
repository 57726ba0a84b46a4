/* driver.c: runs the contenders of one group in one process, in turns.
 *
 *   driver verify             prints "deviation <name> <largest relative deviation from its judge>"
 *   driver count              calls every contender once per state, for callgrind
 *   driver time <n> <batch>   n rounds in which every contender runs for about <batch> seconds; prints
 *                             "time <round> <name> <nanoseconds per call>"; processor time of this thread
 *                             only, so that a busy machine disturbs little
 */
#define _POSIX_C_SOURCE 199309L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "contract.h"

/* The list of contenders: "X(symbol, judge)" per line; judge: place of the contender that it is compared with. */
#define X(symbol, judge) extern const contender symbol;
#include LIST
#undef X

typedef struct {
    const contender *it;
    int judge;
    long laps; /* laps over all states in a batch */
} entry;

#define X(symbol, judge) { &symbol, judge, 1 },
static entry entries[] = {
#include LIST
};
#undef X

enum { ENTRIES = sizeof entries / sizeof entries[0] };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Seconds that n laps over the states take; the function is reached through a pointer that nobody can see through. */
static double run(const contender *it, long n)
{
    int (*volatile hidden)(int) = it->call;
    int (*const call)(int) = hidden;
    const double start = now();
    long i;
    int k, status = 0;
    for (i = 0; i < n; ++i) {
        for (k = 0; k < STATES; ++k) {
            status |= call(k);
        }
    }
    if (status) {
        fprintf(stderr, "%s: status %d\n", it->name, status);
        exit(1);
    }
    return now() - start;
}

static double deviation(const entry *e, int k)
{
    static double expected[RESULTS], y[RESULTS];
    const contender *judge = entries[e->judge].it;
    const int n = judge->results < e->it->results ? judge->results : e->it->results;
    double worst = 0;
    int i;
    judge->call(k);
    if (e->it->call(k)) {
        fprintf(stderr, "%s: fails at state %d\n", e->it->name, k);
        exit(1);
    }
    if (n) {
        judge->result(expected);
        e->it->result(y);
    }
    for (i = 0; i < n; ++i) {
        worst = fmax(worst, fabs(y[i] - expected[i]) / (1 + fabs(expected[i])));
        worst = y[i] == y[i] ? worst : INFINITY;
    }
    return worst;
}

static void verify(void)
{
    int e, k;
    for (e = 0; e < ENTRIES; ++e) {
        double worst = 0;
        for (k = 0; k < STATES; ++k) {
            worst = fmax(worst, deviation(&entries[e], k));
        }
        printf("deviation %s %.2e\n", entries[e].it->name, worst);
    }
}

enum { WARM = 3, TRIES = 9 };

/* How many laps make a batch, from the fastest of a few tries. */
static long laps(const contender *it, double batch)
{
    double best = INFINITY;
    int k;
    for (k = 0; k < TRIES; ++k) {
        best = fmin(best, run(it, WARM) / WARM);
    }
    return (long)fmax(WARM, batch / best);
}

static void measure(int rounds, double batch)
{
    int e, r;
    for (e = 0; e < ENTRIES; ++e) {
        entries[e].laps = laps(entries[e].it, batch);
    }
    for (r = 0; r < rounds; ++r) {
        for (e = 0; e < ENTRIES; ++e) {
            double t;
            run(entries[e].it, WARM); /* the others have emptied the caches */
            t = run(entries[e].it, entries[e].laps);
            printf("time %d %s %.4f\n", r, entries[e].it->name, 1e9 * t / ((double)entries[e].laps * STATES));
        }
        fflush(stdout);
    }
}

int main(int argc, char **argv)
{
    int e;
    for (e = 0; e < ENTRIES; ++e) {
        entries[e].it->init();
    }
    if (argc == 2 && strcmp(argv[1], "verify") == 0) {
        verify();
    } else if (argc == 2 && strcmp(argv[1], "count") == 0) {
        for (e = 0; e < ENTRIES; ++e) {
            run(entries[e].it, 1);
        }
    } else if (argc == 4 && strcmp(argv[1], "time") == 0) {
        measure(atoi(argv[2]), atof(argv[3]));
    } else {
        fprintf(stderr, "usage: driver verify | count | time <rounds> <seconds per batch>\n");
        return 2;
    }
    return 0;
}
