/* Efforts of a feedforward along references on standard input: step, then q and v of the joints per sample, the first at rest.
 * What it refuses comes before: a line of statuses, and 1 where nothing was written.
 */
#include <stdio.h>
#include <string.h>

#include "boom_feedforward_efforts.h"

enum { M = BOOM_FEEDFORWARD_NTAU, NV = BOOM_FEEDFORWARD_NV };

static boom_feedforward_real number(int *more)
{
    double x = 0;
    *more = *more && scanf("%lf", &x) == 1;
    return (boom_feedforward_real)x;
}

static int sample(boom_feedforward_real q[], boom_feedforward_real v[])
{
    int k, more = 1;
    for (k = 0; k < 2 * M; ++k) {
        (k < M ? q : v - M)[k] = number(&more);
    }
    return more;
}

int main(void)
{
    static boom_feedforward_parameters p;
    static boom_feedforward_constants c;
    static boom_feedforward_state state, before;
    static boom_feedforward_efforts_work work;
    boom_feedforward_real q[M], v[M], tau[M], kept[M], bad[M], step;
    int k, more = 1;
    boom_feedforward_parameters_default(&p);
    step = number(&more);
    if (boom_feedforward_prepare(&p, &c) != BOOM_FEEDFORWARD_OK || !sample(q, v)) {
        return 1;
    }
    for (k = 0; k < M; ++k) {
        bad[k] = tau[k] = kept[k] = 0;
    }
    bad[0] /= bad[0];
    memcpy(state.q, q, sizeof q);
#ifdef ELASTIC
    before = state;
    if (boom_feedforward_at_rest(&c, bad, &work, &state) != BOOM_FEEDFORWARD_NONFINITE
        || boom_feedforward_at_rest(&c, q, 0, &state) != BOOM_FEEDFORWARD_BAD_ARGUMENT
        || memcmp(&before, &state, sizeof state) || boom_feedforward_at_rest(&c, q, &work, &state)) {
        return 1;
    }
#else
    for (k = 0; k < 5; ++k) {
        static boom_feedforward_input none;
        boom_feedforward_real force[NV];
        if (boom_feedforward_gravity(&c, &state, &none, &work.chain, force, &state) != BOOM_FEEDFORWARD_OK) {
            return 1;
        }
    }
#endif
    before = state;
    printf("%d ", boom_feedforward(&c, &state, bad, v, step, &work, tau));
    printf("%d ", boom_feedforward(&c, &state, q, bad, step, &work, tau));
    printf("%d ", boom_feedforward(&c, &state, q, v, 0, &work, tau));
    printf("%d ", boom_feedforward(&c, &state, q, v, bad[0], &work, tau));
    printf("%d ", boom_feedforward(&c, &state, q, v, step, 0, tau));
    printf("%d\n", !memcmp(&before, &state, sizeof state) && !memcmp(tau, kept, sizeof tau));
    while (sample(q, v)) {
        if (boom_feedforward(&c, &state, q, v, step, &work, tau) != BOOM_FEEDFORWARD_OK) {
            return 1;
        }
        for (k = 0; k < M; ++k) {
            printf("%.17g ", (double)tau[k]);
        }
        for (k = 0; k < BOOM_FEEDFORWARD_NQ; ++k) {
            printf("%.17g ", (double)state.q[k]);
        }
        printf("\n");
    }
    return 0;
}
