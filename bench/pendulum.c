/* pendulum.c: the two-link pendulum -DROBOT for one second from horizontal and straight at rest.
 *
 *   pendulum <method> <steps> <runs>      prints processor seconds of a run, tip x and z (m)
 */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include HEADER

#include "contract.h"

#define OF_ROBOT(x) JOIN(ROBOT, x)

typedef OF_ROBOT(_status) step_function(const OF_ROBOT(_constants) *, OF_ROBOT(_state) *, const OF_ROBOT(_input) *,
    OF_ROBOT(_real), OF_ROBOT(_work) *);

#define METHOD(name) { #name, OF_ROBOT(_step_##name) },
static const struct {
    const char *name;
    step_function *step;
} methods[] = { METHODS };

static OF_ROBOT(_constants) constants;
static OF_ROBOT(_state) state;
static OF_ROBOT(_input) input;
static OF_ROBOT(_output) output;
static OF_ROBOT(_work) work;

static int simulate(step_function *step, long steps)
{
    static const OF_ROBOT(_state) rest;
    int status = 0;
    long k;
    state = rest;
    for (k = 0; k < steps && !status; ++k) {
        status = (int)step(&constants, &state, &input, 1.0 / (double)steps, &work);
    }
    return status;
}

int main(int argc, char **argv)
{
    static OF_ROBOT(_parameters) parameters;
    struct timespec start, stop;
    int i, k, status = 0, runs, method = -1;
    for (i = 0; argc == 4 && i < (int)(sizeof methods / sizeof methods[0]); ++i) {
        method = strcmp(argv[1], methods[i].name) ? method : i;
    }
    if (method < 0) {
        fprintf(stderr, "usage: pendulum <method> <steps> <runs>\n");
        return 2;
    }
    OF_ROBOT(_parameters_default)(&parameters);
    OF_ROBOT(_prepare)(&parameters, &constants);
    runs = atoi(argv[3]);
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &start);
    for (k = 0; k < runs; ++k) {
        status |= simulate(methods[method].step, atol(argv[2]));
    }
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &stop);
    status |= (int)OF_ROBOT(_forward_dynamics)(&constants, &state, &input, &work, &output);
    printf("%.6e %.9f %.9f\n",
        ((double)(stop.tv_sec - start.tv_sec) + 1e-9 * (double)(stop.tv_nsec - start.tv_nsec)) / runs,
        (double)output.tip_position[0], (double)output.tip_position[2]);
    return status != 0;
}
