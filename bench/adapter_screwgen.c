/* adapter_screwgen.c: the generated C of a robot as a contender.
 *
 * -DROBOT: its prefix; -DHEADER, -DDATA: its header and its states. -DWITH_PREPARE: every call prepares the
 * constants from the parameters first. -DACCELERATIONS: vdot alone. -DSTEP, -DDAE_STEP: a step by that function instead of forward dynamics.
 */
#include <string.h>

#include DATA
#include HEADER

#include "contract.h"

#define OF_ROBOT(x) JOIN(ROBOT, x)

static OF_ROBOT(_constants) constants;
static OF_ROBOT(_parameters) parameters;
static OF_ROBOT(_state) states[STATES];
static OF_ROBOT(_input) inputs[STATES];
static OF_ROBOT(_output) output;

#if defined(DAE_STEP)
static OF_ROBOT(_dae_state) dae_states[STATES], moved;
static OF_ROBOT(_dae_work) work;
#else
static OF_ROBOT(_work) work;
#endif
#if defined(STEP)
static OF_ROBOT(_state) moved;
#endif

static void init(void)
{
    int i, k;
    OF_ROBOT(_parameters_default)(&parameters);
    OF_ROBOT(_prepare)(&parameters, &constants);
    for (k = 0; k < STATES; ++k) {
        for (i = 0; i < NQ; ++i) {
            states[k].q[i] = (OF_ROBOT(_real))data_q[k][i];
            states[k].v[i] = (OF_ROBOT(_real))data_v[k][i];
        }
        for (i = 0; i < NTAU; ++i) {
            inputs[k].tau[i] = (OF_ROBOT(_real))data_tau[k][i];
        }
        for (i = 0; i < 6 * NLINKS; ++i) {
            inputs[k].w_ext[i / 6][i % 6] = (OF_ROBOT(_real))data_w_ext[k][i];
        }
#if defined(DAE_STEP)
        OF_ROBOT(_dae_from_state)(&constants, &states[k], &work, &dae_states[k]);
#endif
    }
}

int CALL(int k);
int CALL(int k)
{
#if defined(STEP)
    moved = states[k];
    return (int)STEP(&constants, &moved, &inputs[k], (OF_ROBOT(_real))TIME_STEP, &work);
#elif defined(DAE_STEP)
    moved = dae_states[k];
    return (int)DAE_STEP(&constants, &moved, &inputs[k], (OF_ROBOT(_real))TIME_STEP, &work);
#else
#if defined(WITH_PREPARE)
    if (OF_ROBOT(_prepare)(&parameters, &constants)) {
        return 1;
    }
#endif
#if defined(ACCELERATIONS)
    return (int)OF_ROBOT(_accelerations)(&constants, &states[k], &inputs[k], &work, &output);
#else
    return (int)OF_ROBOT(_forward_dynamics)(&constants, &states[k], &inputs[k], &work, &output);
#endif
#endif
}

static void result(double *y)
{
    int i;
    for (i = 0; i < NQ; ++i) {
        *y++ = (double)output.vdot[i];
    }
#if !defined(ACCELERATIONS)
    for (i = 0; i < 6 * NLINKS; ++i) {
        *y++ = (double)output.wrench[i / 6][i % 6];
    }
    for (i = 0; i < 9; ++i) {
        *y++ = (double)output.tip_rotation[i / 3][i % 3];
    }
    for (i = 0; i < 3; ++i) {
        *y++ = (double)output.tip_position[i];
    }
#endif
}

#if defined(STEP) || defined(DAE_STEP)
#define RESULTS 0
#elif defined(ACCELERATIONS)
#define RESULTS NQ
#else
#define RESULTS (NQ + 6 * NLINKS + 12)
#endif

extern const contender VARIANT;
const contender VARIANT = { TEXT(VARIANT), RESULTS, init, CALL, result };
