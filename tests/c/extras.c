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

typedef robot_status (*derived_step)(const robot_constants *, const robot_state *, const robot_input *, real,
    robot_step_derivatives_work *, robot_state *, robot_step_derivatives *);

#define X(m) robot_step_##m##_derivatives,
static const derived_step DERIVED[] = { EACH_METHOD(X) };
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

static void steps(int method, int wild)
{
    robot_state x, next, before;
    robot_input u;
    robot_step_derivatives_work *work = scratch(sizeof *work);
    robot_step_derivatives *out = scratch(sizeof *out);
    robot_wrench_work *other = scratch(sizeof *other);
    robot_wrench_derivatives *wrenches = scratch(sizeof *wrenches);
    robot_status status;
    draw_all((real *)&x, sizeof x / sizeof(real), wild);
    draw_all((real *)&u, sizeof u / sizeof(real), wild);
    draw_all((real *)&next, sizeof next / sizeof(real), 0);
    before = next;
    status = DERIVED[method](&constants, &x, &u, (real)1e-5, work, &next, out);
    expect(status >= ROBOT_OK && status <= ROBOT_BAD_ARGUMENT, "a status that the header does not list", (int)status);
    expect(wild || status == ROBOT_OK, "derivatives of a step were refused", (int)status);
    if (status == ROBOT_OK) {
        expect(all_finite((real *)out, sizeof *out / sizeof(real)) && all_finite((real *)&next, sizeof next / sizeof(real)),
            "derivatives of a step that are not finite", 0);
        status = robot_linearise_wrenches(&constants, &x, &u, &work->stages[0], other, wrenches);
        expect(wild || status == ROBOT_OK, "derivatives of wrenches were refused", (int)status);
        expect(status != ROBOT_OK || all_finite((real *)wrenches, sizeof *wrenches / sizeof(real)),
            "derivatives of wrenches that are not finite", 0);
    } else {
        expect(!memcmp(&next, &before, sizeof next), "a refused step has changed the state", (int)status);
    }
    expect(DERIVED[method](&constants, &x, &u, 0, work, &next, out) == ROBOT_BAD_ARGUMENT, "a step of no length", 0);
    expect(DERIVED[method](&constants, &x, &u, 1, work, NULL, out) == ROBOT_BAD_ARGUMENT, "a step took a null pointer", 0);
    free(wrenches);
    free(other);
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
            steps(method, round % 2);
            batches(method, round % 2);
        }
    }
    return failures != 0;
}
