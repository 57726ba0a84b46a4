/* Steps through a functional mock-up unit (FMI 2.0) beside steps of the same C: the time of each, in turns.
 *
 * Arguments: the library of the C, that of the unit, its guid, the step (s), steps in a turn, turns. HEADER is the robot's
 * header, ROBOT(x) the name of its x. Prints seconds per step of the C, of the unit, and of the unit with an input set
 * and the states read, turn by turn.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <sched.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include HEADER
#include "fmi2Functions.h"

#define FIND(library, type, name) \
    type *name = (type *)dlsym(library, #name); \
    if (!name) { \
        fprintf(stderr, "no %s\n", #name); \
        return 1; \
    }

typedef ROBOT(status) step_type(const ROBOT(constants) *, ROBOT(state) *, const ROBOT(input) *, double, ROBOT(work) *);

static void say(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category, fmi2String text, ...)
{
    (void)environment;
    fprintf(stderr, "%s: %d %s: %s\n", name, (int)status, category, text);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int count, char **arguments)
{
    static ROBOT(parameters) p;
    static ROBOT(constants) c;
    static ROBOT(input) input;
    static ROBOT(work) work;
    static ROBOT(state) state;
    const fmi2CallbackFunctions callbacks = { say, calloc, free, 0, 0 };
    void *const model = dlopen(count == 7 ? arguments[1] : "", RTLD_NOW | RTLD_LOCAL);
    void *const unit = dlopen(count == 7 ? arguments[2] : "", RTLD_NOW | RTLD_LOCAL);
    cpu_set_t one;
    if (!model || !unit) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    sched_setaffinity(0, sizeof one, &one);
    {
        const double h = atof(arguments[4]);
        const int steps = atoi(arguments[5]), turns = atoi(arguments[6]);
        step_type *const step = (step_type *)dlsym(model, NAME "_step_modal_implicit");
        ROBOT(status) (*const prepare)(const ROBOT(parameters) *, ROBOT(constants) *)
            = (ROBOT(status) (*)(const ROBOT(parameters) *, ROBOT(constants) *))dlsym(model, NAME "_prepare");
        void (*const defaults)(ROBOT(parameters) *) = (void (*)(ROBOT(parameters) *))dlsym(model, NAME "_parameters_default");
        FIND(unit, fmi2InstantiateTYPE, fmi2Instantiate)
        FIND(unit, fmi2EnterInitializationModeTYPE, fmi2EnterInitializationMode)
        FIND(unit, fmi2ExitInitializationModeTYPE, fmi2ExitInitializationMode)
        FIND(unit, fmi2DoStepTYPE, fmi2DoStep)
        FIND(unit, fmi2SetRealTYPE, fmi2SetReal)
        FIND(unit, fmi2GetRealTYPE, fmi2GetReal)
        FIND(unit, fmi2GetFMUstateTYPE, fmi2GetFMUstate)
        FIND(unit, fmi2SetFMUstateTYPE, fmi2SetFMUstate)
        fmi2Component m = fmi2Instantiate("one", fmi2CoSimulation, arguments[3], "", &callbacks, 0, 0);
        fmi2FMUstate start = 0;
        fmi2ValueReference states[STATES], torque = FIRST_INPUT;
        double values[STATES];
        int k, turn;
        if (!m || !step || !prepare || !defaults || fmi2EnterInitializationMode(m) || fmi2ExitInitializationMode(m)) {
            return 1;
        }
        for (k = 0; k < STATES; ++k) {
            states[k] = FIRST_STATE + (fmi2ValueReference)k;
        }
        defaults(&p);
        if (prepare(&p, &c) || fmi2GetFMUstate(m, &start)) {
            return 1;
        }
        for (turn = 0; turn < turns; ++turn) {
            double t[4], at;
            memset(&state, 0, sizeof state);
            t[0] = now();
            for (k = 0; k < steps; ++k) {
                if (step(&c, &state, &input, h, &work)) {
                    return 2;
                }
            }
            t[1] = now();
            fmi2SetFMUstate(m, start);
            for (k = 0, at = 0; k < steps; ++k, at += h) {
                if (fmi2DoStep(m, at, h, fmi2True)) {
                    return 2;
                }
            }
            t[2] = now();
            fmi2GetReal(m, states, STATES, values);
            if (memcmp(values, state.q, sizeof state.q) || memcmp(values + sizeof state.q / sizeof *values, state.v, sizeof state.v)) {
                return 3;
            }
            fmi2SetFMUstate(m, start);
            for (k = 0, at = 0; k < steps; ++k, at += h) {
                const double tau = 0;
                if (fmi2SetReal(m, &torque, 1, &tau) || fmi2DoStep(m, at, h, fmi2True) || fmi2GetReal(m, states, STATES, values)) {
                    return 2;
                }
            }
            t[3] = now();
            printf("%.9g %.9g %.9g\n", (t[1] - t[0]) / steps, (t[2] - t[1]) / steps, (t[3] - t[2]) / steps);
        }
    }
    return 0;
}
