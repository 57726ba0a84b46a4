/* extras.c: derivatives and batches of a generated model, over null pointers and wild numbers.
 *
 * For a model named "robot"; -DEACH_METHOD(X)=X(euler) ... names the integrators. Exit status 0 if every call returned
 * the right status, gave finite results with ROBOT_OK, and left what it refused as it was.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "driver.h"
#include "robot_batch.h"
#include "robot_derivatives.h"

typedef robot_real real;
typedef robot_status (*batch_step)(const robot_constants *, const robot_batch *, real, int);

#define X(m) robot_step_batch_##m,
static const batch_step STEPS[] = { EACH_METHOD(X) };
#undef X

enum { METHODS = (int)(sizeof STEPS / sizeof STEPS[0]), ROUNDS = 60, COUNT = 11, STRIDE = 13 };

static robot_constants constants;

/* Uniform in [-1, 1), or now and then something wild. */
static real draw(int wild)
{
    static unsigned long long seed = 20240229;
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    if (wild && (seed >> 40) % 50 == 0) {
        return (seed >> 20) % 2 ? (real)NAN : (real)1e30;
    }
    return (real)((double)(seed >> 33) / 1073741824.0 - 1);
}

static void draw_all(real *x, size_t n, int wild)
{
    size_t k;
    for (k = 0; k < n; ++k) {
        x[k] = draw(wild) / 4;
    }
}

static int all_finite(const real *x, size_t n)
{
    size_t k;
    for (k = 0; k < n; ++k) {
        if (!isfinite(x[k])) {
            return 0;
        }
    }
    return 1;
}

static void derivatives(int wild)
{
    robot_state x;
    robot_input u;
    robot_linearise_work *work = scratch(sizeof *work);
    robot_derivatives *out = scratch(sizeof *out);
    robot_status status;
    draw_all((real *)&x, sizeof x / sizeof(real), wild);
    draw_all((real *)&u, sizeof u / sizeof(real), wild);
    status = robot_linearise(&constants, &x, &u, work, out);
    expect(status >= ROBOT_OK && status <= ROBOT_BAD_ARGUMENT, "a status that the header does not list", (int)status);
    expect(wild || status == ROBOT_OK, "derivatives were refused", (int)status);
    if (status == ROBOT_OK) {
        expect(all_finite(&out->vdot_q[0][0], ROBOT_NV * ROBOT_NQ) && all_finite(&out->vdot_v[0][0], ROBOT_NV * ROBOT_NV)
                && all_finite(&out->vdot_tau[0][0], ROBOT_NV * ROBOT_NTAU),
            "derivatives that are not finite", 0);
    }
    expect(robot_linearise(NULL, &x, &u, work, out) == ROBOT_BAD_ARGUMENT, "linearise took a null pointer", 0);
    expect(robot_linearise(&constants, &x, &u, work, NULL) == ROBOT_BAD_ARGUMENT, "linearise took a null pointer", 1);
    free(out);
    free(work);
}

static void batches(int method, int wild)
{
    real *q = scratch(ROBOT_NQ * STRIDE * sizeof *q), *v = scratch(ROBOT_NV * STRIDE * sizeof *v);
    real *tau = scratch(ROBOT_NTAU * STRIDE * sizeof *tau), *path = scratch(2 * ROBOT_NQ * STRIDE * sizeof *path);
    int *status = scratch(COUNT * sizeof *status), *fault = scratch(COUNT * sizeof *fault), i, k;
    robot_batch b = { 0 };
    b.count = COUNT;
    b.stride = STRIDE;
    b.q = q;
    b.v = v;
    b.tau = tau;
    b.q_path = path;
    b.status = status;
    b.fault = fault;
    b.hold = 2;
    draw_all(q, ROBOT_NQ * STRIDE, wild);
    draw_all(v, ROBOT_NV * STRIDE, wild);
    draw_all(tau, ROBOT_NTAU * STRIDE, wild);
    for (i = 0; i < COUNT; ++i) {
        status[i] = ROBOT_OK;
        for (k = ROBOT_NTAU; k < ROBOT_NQ; ++k) {
            q[k * STRIDE + i] *= (real)1e-3;
        }
    }
    expect(STEPS[method](&constants, &b, (real)1e-5, 2) == ROBOT_OK, "a batch was refused", method);
    for (i = 0; i < COUNT; ++i) {
        expect(wild || status[i] == ROBOT_OK, "a scenario failed", status[i]);
        for (k = 0; k < ROBOT_NQ && status[i] == ROBOT_OK; ++k) {
            expect(isfinite(q[k * STRIDE + i]) && isfinite(path[(ROBOT_NQ + k) * STRIDE + i]), "not finite", i);
        }
    }
    expect(STEPS[method](NULL, &b, 1, 1) == ROBOT_BAD_ARGUMENT, "a batch took a null pointer", 0);
    expect(STEPS[method](&constants, &b, (real)NAN, 1) == ROBOT_BAD_ARGUMENT, "a batch took a bad step", 0);
    free(fault);
    free(status);
    free(path);
    free(tau);
    free(v);
    free(q);
}

int main(void)
{
    robot_parameters p;
    int round, method;
    robot_parameters_default(&p);
    if (robot_prepare(&p, &constants) != ROBOT_OK) {
        return 1;
    }
    for (round = 0; round < ROUNDS; ++round) {
        derivatives(round % 2);
        for (method = 0; method < METHODS; ++method) {
            batches(method, round % 2);
        }
    }
    return failures != 0;
}
