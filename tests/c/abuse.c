/* abuse.c: every function of a generated model with null pointers, bad steps and wild numbers.
 *
 * For a model named "robot" with joints and modes; -DEACH_METHOD(X)=X(euler) ... names the integrators, -DFILL=n the
 * byte that scratch holds before a call (without it scratch is uninitialised, for valgrind). Exit status 0 if every
 * call returned a status of the header, the right one where there is only one, and left the state as it was unless
 * that status was OK.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "driver.h"
#include "robot.h"

typedef robot_real real;
typedef robot_status (*step)(const robot_constants *, robot_state *, const robot_input *, real, robot_work *);
typedef robot_status (*dae_step)(const robot_constants *, robot_dae_state *, const robot_input *, real, robot_dae_work *);

#define X(m) robot_step_##m,
static const step STEPS[] = { EACH_METHOD(X) };
#undef X
#define X(m) robot_dae_step_##m,
static const dae_step DAE_STEPS[] = { EACH_METHOD(X) };
#undef X

enum { METHODS = (int)(sizeof STEPS / sizeof STEPS[0]) };

#ifdef ROBOT_REAL_FLOAT
#define LARGEST FLT_MAX
#define SMALLEST FLT_MIN
#define ROUNDING FLT_EPSILON
#define DECADES 37
#else
#define LARGEST DBL_MAX
#define SMALLEST DBL_MIN
#define ROUNDING DBL_EPSILON
#define DECADES 300
#endif

static const real WILD[] = {
    0, (real)NAN, (real)INFINITY, (real)-INFINITY, LARGEST, -LARGEST, LARGEST / 4, SMALLEST, SMALLEST / 8, (real)1e18,
    (real)-1e12, (real)3e6, (real)-100, 1,
};

enum { WILD_COUNT = (int)(sizeof WILD / sizeof WILD[0]), ROUNDS = 400 };

static robot_constants constants;
static long calls[4];

static robot_status counted(robot_status status)
{
    expect(status >= ROBOT_OK && status <= ROBOT_BAD_ARGUMENT, "a status that the header does not list", (int)status);
    ++calls[(int)status & 3];
    return status;
}

static int all_finite(const void *block, size_t size)
{
    const real *x = block;
    size_t k;
    for (k = 0; k < size / sizeof *x; ++k) {
        if (!isfinite(x[k])) {
            return 0;
        }
    }
    return 1;
}

/* Uniform in [0, 1). */
static double draw(void)
{
    static unsigned long long seed = 20240229;
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return (double)(seed >> 33) / 2147483648.0;
}

static void draw_all(void *block, size_t size, double decades)
{
    real *x = block;
    size_t k;
    for (k = 0; k < size / sizeof *x; ++k) {
        x[k] = (real)((draw() < 0.5 ? -1 : 1) * pow(10, decades * (2 * draw() - 1)));
    }
}

/* A posture and an input of ordinary size. */
static void ordinary(robot_state *x, robot_input *u)
{
    int k;
    draw_all(x, sizeof *x, 0.1);
    draw_all(u, sizeof *u, 0.1);
    for (k = 0; k < ROBOT_NMODES; ++k) {
        x->q[ROBOT_NTAU + k] *= (real)1e-3;
    }
}

/* ---------------------------------------------------------------------------------- one call of each kind */

static void try_step(const robot_state *x, const robot_input *u, real dt, int method)
{
    const int sane = all_finite(x, sizeof *x) && all_finite(u, sizeof *u);
    robot_work *work = scratch(sizeof *work);
    robot_state moved = *x;
    const robot_status status = counted(STEPS[method](&constants, &moved, u, dt, work));
    if (status == ROBOT_OK) {
        expect(all_finite(&moved, sizeof moved), "a step gave a state that is not finite", method);
    } else {
        expect(memcmp(&moved, x, sizeof moved) == 0, "a refused step changed the state", method);
    }
    expect(isfinite(dt) && dt * ROUNDING > 0 ? sane || status == ROBOT_NONFINITE : status == ROBOT_BAD_ARGUMENT,
        "a step took bad input", method);
    free(work);
}

static void try_dae_step(const robot_dae_state *x, const robot_input *u, real dt, int method)
{
    const int sane = all_finite(x, sizeof *x) && all_finite(u, sizeof *u);
    robot_dae_work *work = scratch(sizeof *work);
    robot_dae_state moved = *x;
    const robot_status status = counted(DAE_STEPS[method](&constants, &moved, u, dt, work));
    if (status == ROBOT_OK) {
        expect(all_finite(&moved, sizeof moved), "a DAE step gave a state that is not finite", method);
    } else {
        expect(memcmp(&moved, x, sizeof moved) == 0, "a refused DAE step changed the state", method);
    }
    expect(isfinite(dt) && dt * ROUNDING > 0 ? sane || status == ROBOT_NONFINITE : status == ROBOT_BAD_ARGUMENT,
        "a DAE step took bad input", method);
    free(work);
}

static void try_dynamics(const robot_state *x, const robot_input *u)
{
    const int sane = all_finite(x, sizeof *x) && all_finite(u, sizeof *u);
    robot_work *work = scratch(sizeof *work);
    robot_output *y = scratch(sizeof *y);
    const robot_status status = counted(robot_forward_dynamics(&constants, x, u, work, y));
    expect(sane || status == ROBOT_NONFINITE, "the dynamics took bad input", (int)status);
    if (status == ROBOT_OK) {
        expect(all_finite(y->vdot, ROBOT_NV * sizeof(real)) && all_finite(y->wrench, sizeof y->wrench)
                && all_finite(y->tip_rotation, sizeof y->tip_rotation) && all_finite(y->tip_position, sizeof y->tip_position),
            "the dynamics gave an output that is not finite", 0);
    }
    free(y);
    free(work);
}

static void try_dae_dynamics(const robot_dae_state *x, const robot_input *u)
{
    const int sane = all_finite(x, sizeof *x) && all_finite(u, sizeof *u);
    robot_dae_work *work = scratch(sizeof *work);
    robot_output *y = scratch(sizeof *y);
    real *M = scratch(ROBOT_NNZ * sizeof *M), *H = scratch(ROBOT_NZ * sizeof *H), *W = scratch(ROBOT_NZ * sizeof *W);
    robot_status status = counted(robot_dae_forward_dynamics(&constants, x, u, work, y));
    expect(sane || status == ROBOT_NONFINITE, "the DAE dynamics took bad input", (int)status);
    if (status == ROBOT_OK) {
        expect(all_finite(y->vdot, ROBOT_NV * sizeof(real)) && all_finite(y->wrench, sizeof y->wrench),
            "the DAE dynamics gave an output that is not finite", 0);
    }
    status = counted(robot_assemble(&constants, x, u, work, M, H, W));
    expect(sane || status == ROBOT_NONFINITE, "the assembly took bad input", (int)status);
    if (status == ROBOT_OK) {
        expect(all_finite(M, ROBOT_NNZ * sizeof *M) && all_finite(H, ROBOT_NZ * sizeof *H)
                && all_finite(W, ROBOT_NZ * sizeof *W),
            "the assembly gave a system that is not finite", 0);
    }
    free(W);
    free(H);
    free(M);
    free(y);
    free(work);
}

/* Both forms: dynamics, and steps of dt by every method. A state that the DAE form refuses goes no further. */
static void try_everything(const robot_state *x, const robot_input *u, real dt)
{
    robot_dae_work *work = scratch(sizeof *work);
    robot_dae_state *dae = scratch(sizeof *dae);
    robot_status status;
    int k;
    try_dynamics(x, u);
    for (k = 0; k < METHODS; ++k) {
        try_step(x, u, dt, k);
    }
    status = counted(robot_dae_from_state(&constants, x, work, dae));
    expect(all_finite(x, sizeof *x) || status == ROBOT_NONFINITE, "the DAE state took bad input", (int)status);
    if (status == ROBOT_OK) {
        try_dae_dynamics(dae, u);
        for (k = 0; k < METHODS; ++k) {
            try_dae_step(dae, u, dt, k);
        }
    }
    free(dae);
    free(work);
}

/* --------------------------------------------------------------------------------------------- campaigns */

/* Every pointer null in turn. */
static void null_pointers(void)
{
    static robot_parameters p;
    static robot_state x;
    static robot_dae_state dae;
    static robot_input u;
    static robot_output y;
    static robot_work work;
    static robot_dae_work dae_work;
    static real M[ROBOT_NNZ], H[ROBOT_NZ], W[ROBOT_NZ];
    const robot_constants *c = &constants;
    static robot_constants spare;
    int k, m;
#define BUT(number, pointer) (k == (number) ? NULL : (pointer))
#define REFUSED(call) expect(counted(call) == ROBOT_BAD_ARGUMENT, #call, k)
    for (k = 0; k < 5; ++k) {
        REFUSED(robot_forward_dynamics(BUT(0, c), BUT(1, &x), BUT(2, &u), BUT(3, &work), BUT(4, &y)));
        REFUSED(robot_dae_forward_dynamics(BUT(0, c), BUT(1, &dae), BUT(2, &u), BUT(3, &dae_work), BUT(4, &y)));
    }
    for (k = 0; k < 4; ++k) {
        REFUSED(robot_dae_from_state(BUT(0, c), BUT(1, &x), BUT(2, &dae_work), BUT(3, &dae)));
        for (m = 0; m < METHODS; ++m) {
            REFUSED(STEPS[m](BUT(0, c), BUT(1, &x), BUT(2, &u), 1, BUT(3, &work)));
            REFUSED(DAE_STEPS[m](BUT(0, c), BUT(1, &dae), BUT(2, &u), 1, BUT(3, &dae_work)));
        }
    }
    for (k = 0; k < 7; ++k) {
        REFUSED(robot_assemble(BUT(0, c), BUT(1, &dae), BUT(2, &u), BUT(3, &dae_work), BUT(4, M), BUT(5, H), BUT(6, W)));
    }
    for (k = 0; k < 2; ++k) {
        REFUSED(robot_prepare(BUT(0, &p), BUT(1, &spare)));
    }
}

/* Every length of a step. */
static void bad_steps(void)
{
    robot_state x = { 0 };
    robot_input u = { 0 };
    int k;
    for (k = 0; k < WILD_COUNT; ++k) {
        ordinary(&x, &u);
        try_everything(&x, &u, WILD[k]);
        try_everything(&x, &u, -WILD[k]);
    }
}

/* Every entry of state and input at every wild value. */
static void wild_entries(void)
{
    robot_state x = { 0 }, given;
    robot_input u = { 0 }, pushed;
    size_t k;
    int w;
    ordinary(&x, &u);
    for (w = 0; w < WILD_COUNT; ++w) {
        for (k = 0; k < sizeof x / sizeof(real); ++k) {
            given = x;
            memcpy((char *)&given + k * sizeof(real), &WILD[w], sizeof(real));
            try_everything(&given, &u, (real)1e-4);
        }
        for (k = 0; k < sizeof u / sizeof(real); ++k) {
            pushed = u;
            memcpy((char *)&pushed + k * sizeof(real), &WILD[w], sizeof(real));
            try_everything(&x, &pushed, (real)1e-4);
        }
    }
}

/* States of the DAE form that belong to no posture, entry by entry. */
static void wild_poses(void)
{
    robot_state x = { 0 };
    robot_input u = { 0 };
    robot_dae_state dae = { 0 }, given;
    robot_dae_work *work = scratch(sizeof *work);
    size_t k;
    int w, m;
    ordinary(&x, &u);
    expect(robot_dae_from_state(&constants, &x, work, &dae) == ROBOT_OK, "an ordinary posture was refused", 0);
    for (w = 0; w < WILD_COUNT; ++w) {
        for (k = 0; k < sizeof dae / sizeof(real); ++k) {
            given = dae;
            memcpy((char *)&given + k * sizeof(real), &WILD[w], sizeof(real));
            try_dae_dynamics(&given, &u);
            for (m = 0; m < METHODS; ++m) {
                try_dae_step(&given, &u, (real)1e-4, m);
            }
        }
    }
    free(work);
}

/* States, inputs and steps of all magnitudes at once. */
static void wild_states(void)
{
    robot_state x = { 0 };
    robot_input u = { 0 };
    int k;
    for (k = 0; k < ROUNDS; ++k) {
        const double decades = DECADES * draw() * draw();
        draw_all(&x, sizeof x, decades);
        draw_all(&u, sizeof u, decades);
        try_everything(&x, &u, (real)pow(10, -6 * draw()));
    }
}

/* Every parameter at every wild value; where the constants are accepted the model must keep its promises. */
static void wild_parameters(void)
{
    robot_parameters p;
    robot_state x = { 0 };
    robot_input u = { 0 };
    size_t k;
    int w;
    for (w = 0; w < WILD_COUNT; ++w) {
        for (k = 0; k < sizeof p / sizeof(real); ++k) {
            robot_status status;
            robot_parameters_default(&p);
            memcpy((char *)&p + k * sizeof(real), &WILD[w], sizeof(real));
            status = counted(robot_prepare(&p, &constants));
#ifndef BAKED
            expect(isfinite(WILD[w]) || status == ROBOT_NONFINITE, "a parameter that is not finite was taken", (int)k);
#endif
            if (status == ROBOT_OK) {
                ordinary(&x, &u);
                try_everything(&x, &u, (real)1e-4);
            }
        }
    }
}

int main(void)
{
    robot_parameters p;
    robot_parameters_default(&p);
    expect(robot_prepare(&p, &constants) == ROBOT_OK, "the default parameters were refused", 0);
    null_pointers();
    bad_steps();
    wild_entries();
    wild_poses();
    wild_states();
    wild_parameters();
    printf("%ld calls: %ld ok, %ld non-finite, %ld singular, %ld bad argument; %d failures\n",
        calls[0] + calls[1] + calls[2] + calls[3], calls[0], calls[1], calls[2], calls[3], failures);
    return failures != 0;
}
