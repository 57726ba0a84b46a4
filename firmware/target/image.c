/* image.c: the smallest firmware that uses the model; its sections are the table's flash and RAM.
 *
 * It calls the whole joint form: parameters, forward dynamics, every integrator. With -DDAE_FORM the DAE form as well,
 * with -DESTIMATOR_HEADER="ella_estimator.h" the Kalman filter, also with -DFINDS that of parameters, with
 * -DMPC_HEADER="ella_mpc.h" predictive control.
 * All memory of the model is static here, so that .bss is what a caller needs.
 */
#include "model.h"
#ifdef ESTIMATOR_HEADER
#include ESTIMATOR_HEADER
#endif
#ifdef MPC_HEADER
#include MPC_HEADER
#endif

static M(parameters) parameters;
static M(constants) constants;
static M(state) state;
static M(input) input;
static M(output) output;
static M(work) work;
#ifdef DAE_FORM
static M(dae_state) dae_state;
static M(dae_work) dae_work;
#endif
#ifdef ESTIMATOR_HEADER
static M(estimator) estimator;
static M(measurement) measurement;
static M(estimator_work) estimator_work;
#endif
#ifdef MPC_HEADER
static M(mpc) mpc;
static M(mpc_options) mpc_options;
#endif

/* What a controller would set and read; volatile, so that nothing is computed at compile time. */
static volatile unsigned char choice;

int main(void)
{
    const real dt = (real)1e-3;
    M(parameters_default)(&parameters);
    if (M(prepare)(&parameters, &constants) != N(OK)) {
        return 1;
    }
    for (;;) {
        switch (choice) {
#define STEP(number, method) case number: (void)M(JOIN(step_, method))(&constants, &state, &input, dt, &work); break;
            METHODS
#undef STEP
#ifdef DAE_FORM
#define STEP(number, method) \
    case 16 + number: (void)M(JOIN(dae_step_, method))(&constants, &dae_state, &input, dt, &dae_work); break;
            METHODS
#undef STEP
        case 32:
            (void)M(dae_from_state)(&constants, &state, &dae_work, &dae_state);
            break;
        case 33:
            (void)M(dae_forward_dynamics)(&constants, &dae_state, &input, &dae_work, &output);
            break;
#endif
#ifdef ESTIMATOR_HEADER
        case 34:
#ifdef FINDS
            (void)M(estimator_init)(&parameters, &state, &state, &estimator, state.q);
#else
            (void)M(estimator_init)(&parameters, &state, &state, &estimator);
#endif
            break;
        case 35:
            (void)M(estimator_predict)(&constants, &estimator, &input, dt, &estimator_work);
            break;
        case 36:
            (void)M(estimator_update)(&constants, &estimator, &input, &measurement, &estimator_work);
            break;
#endif
#ifdef MPC_HEADER
        case 37:
            M(mpc_default)(&mpc_options);
            (void)M(mpc_initialise)(&mpc, &mpc_options, &constants, &state, 0);
            break;
        case 38:
            (void)M(mpc_prepare)(&mpc, &mpc_options, &constants);
            break;
        case 39:
            (void)M(mpc_feedback)(&mpc, &mpc_options, &constants, &state, input.tau);
            break;
#endif
        default:
            (void)M(forward_dynamics)(&constants, &state, &input, &work, &output);
        }
    }
}
