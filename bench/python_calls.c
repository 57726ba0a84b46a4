/* python_calls.c: what compiled models cost without Python: calls of the forward dynamics, and the loop of a run.
 *
 * -DROBOT: the prefix; -DROBOT_UPPER: in capitals; -DHEADER: the header. The energies are the library's.
 */
#define _POSIX_C_SOURCE 199309L
#include <string.h>
#include <time.h>

#include HEADER
#include "shim.h"

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define OF(x) JOIN(ROBOT, x)
#define SIZE(x) JOIN(ROBOT_UPPER, x)

double bare_calls(shim_memory *m, int count);
double bare_run(shim_memory *m, int steps, int every, double dt, double *row);

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Seconds of a call at the state and input in memory. */
double bare_calls(shim_memory *m, int count)
{
    OF(_status) (*volatile hidden)(const OF(_constants) *, const OF(_state) *, const OF(_input) *, OF(_work) *, OF(_output) *)
        = OF(_forward_dynamics);
    const double start = now();
    int k;
    for (k = 0; k < count; ++k) {
        if (hidden(&m->constants, &m->state, &m->input, &m->work, &m->output) != 0) {
            return -1;
        }
    }
    return (now() - start) / count;
}

static double *put(double *row, const double *values, int count)
{
    memcpy(row, values, (size_t)count * sizeof(double));
    return row + count;
}

/* Seconds of a run by the modal midpoint rule, samples into the table that begins at row; every = 0: none. */
double bare_run(shim_memory *m, int steps, int every, double dt, double *row)
{
    const double start = now();
    int k, status = 0;
    for (k = 0; k <= steps && !status; ++k) {
        if (every && (k % every == 0 || k == steps)) {
            const double t = k * dt;
            status |= (int)OF(_forward_dynamics)(&m->constants, &m->state, &m->input, &m->work, &m->output) | shim_energy(m);
            row = put(row, &t, 1);
            row = put(row, m->state.q, SIZE(_NQ));
            row = put(row, m->state.v, SIZE(_NV));
            row = put(row, m->input.tau, SIZE(_NTAU));
            row = put(row, m->output.wrench[0], 6 * SIZE(_NLINKS));
            row = put(row, m->output.tip_position, 3);
            row = put(row, m->energy, 2);
        }
        if (k < steps) {
            status |= (int)OF(_step_modal_midpoint)(&m->constants, &m->state, &m->input, dt, &m->work);
        }
    }
    return status ? -1 : now() - start;
}
