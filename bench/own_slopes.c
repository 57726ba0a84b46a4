/* own_slopes.c: the generated forward dynamics and its derivatives in loops, timed by the thread's own clock.
 *
 * Give the robot's name with -DROBOT=name -DROBOT_UPPER=NAME -DHEADER='"name_derivatives.h"'; for its steps also
 * -DMETHOD=modal_implicit -DSTEP=1e-3.
 */
#define _GNU_SOURCE
#include <string.h>
#include <time.h>

#include HEADER

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define R(name) JOIN(ROBOT, JOIN(_, name))
#define S(name) JOIN(ROBOT_UPPER, JOIN(_, name))

static R(parameters) p;
static R(constants) c;
static R(state) state;
static R(input) input;
static R(output) output;
static R(work) work;
static R(linearise_work) slopes_work;
static R(derivatives) slopes;

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

static void given(const double *q, const double *v, const double *tau)
{
    memcpy(state.q, q, sizeof state.q);
    memcpy(state.v, v, sizeof state.v);
    memcpy(input.tau, tau, sizeof input.tau);
}

/* Negative where the robot has no dynamics. */
double peer_dynamics(const double *q, const double *v, const double *tau, long calls)
{
    double begin;
    R(parameters_default)(&p);
    if (R(prepare)(&p, &c)) {
        return -1;
    }
    given(q, v, tau);
    begin = seconds();
    while (calls-- > 0) {
        if (R(accelerations)(&c, &state, &input, &work, &output)) {
            return -1;
        }
    }
    return seconds() - begin;
}

double peer_derivatives(const double *q, const double *v, const double *tau, long calls)
{
    double begin;
    given(q, v, tau);
    begin = seconds();
    while (calls-- > 0) {
        if (R(linearise)(&c, &state, &input, &slopes_work, &slopes)) {
            return -1;
        }
    }
    return seconds() - begin;
}

void peer_results(double *vdot, double *by_q, double *by_v, double *by_tau)
{
    memcpy(vdot, slopes.vdot, sizeof slopes.vdot);
    memcpy(by_q, slopes.vdot_q, sizeof slopes.vdot_q);
    memcpy(by_v, slopes.vdot_v, sizeof slopes.vdot_v);
    memcpy(by_tau, slopes.vdot_tau, sizeof slopes.vdot_tau);
}
#ifdef METHOD

static R(state) next;
static R(step_derivatives_work) step_work;
static R(step_derivatives) step_slopes;

/* A step from the same state again and again. */
double peer_step(const double *q, const double *v, const double *tau, long calls)
{
    double begin;
    given(q, v, tau);
    begin = seconds();
    while (calls-- > 0) {
        next = state;
        if (JOIN(R(step_), METHOD)(&c, &next, &input, STEP, &work)) {
            return -1;
        }
    }
    return seconds() - begin;
}

double peer_step_derivatives(const double *q, const double *v, const double *tau, long calls)
{
    double begin;
    given(q, v, tau);
    begin = seconds();
    while (calls-- > 0) {
        if (JOIN(JOIN(R(step_), METHOD), _derivatives)(&c, &state, &input, STEP, &step_work, &next, &step_slopes)) {
            return -1;
        }
    }
    return seconds() - begin;
}
#endif
