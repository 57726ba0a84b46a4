/* main.c: steps the robot. Usage: ella [duration [step]], in seconds.
 *
 * The joints are held at zero by a simple PD law and the state is printed as CSV every hundredth of the run.
 */
#include <stdio.h>
#include <stdlib.h>

#include "ella.h"

static int failure(long step, ella_status status, int fault)
{
    if (status == ELLA_SINGULAR) {
        fprintf(stderr, "ella: step %ld: the joint of link %d cannot be solved for\n", step, fault);
    } else {
        fprintf(stderr, "ella: step %ld: status %d\n", step, (int)status);
    }
    return 1;
}

/* The seconds that a text states, 0 if it states none. */
static ella_real seconds(const char *text)
{
    char *end;
    const double value = strtod(text, &end);
    return *end == 0 ? (ella_real)value : 0;
}

int main(int argc, char **argv)
{
    const ella_real duration = argc > 1 ? seconds(argv[1]) : 1;
    const ella_real dt = argc > 2 ? seconds(argv[2]) : (ella_real)1e-3;
    static ella_parameters parameters;
    static ella_constants constants;
    static ella_state state;
    static ella_input input;
    static ella_output output;
    static ella_work work;
    ella_status status;
    long steps, every, n;
    int k;
    if (!(duration > 0) || !(dt > 0) || (double)duration / (double)dt > 1e9) {
        fprintf(stderr, "usage: ella [duration [step]], both positive seconds\n");
        return 2;
    }
    ella_parameters_default(&parameters);
    if (ella_prepare(&parameters, &constants) != ELLA_OK) {
        fprintf(stderr, "ella: bad parameters\n");
        return 1;
    }
    steps = (long)(duration / dt + (ella_real)0.5);
    every = steps >= 100 ? steps / 100 : 1;
    printf("t"
        ",upper_arm.joint[0]"
        ",upper_arm.joint[1]"
        ",forearm.joint[0]"
        ",upper_arm.eta.bending_y[0]"
        ",upper_arm.eta.bending_y[1]"
        ",upper_arm.eta.bending_y[2]"
        ",upper_arm.eta.bending_z[0]"
        ",upper_arm.eta.bending_z[1]"
        ",upper_arm.eta.bending_z[2]"
        ",upper_arm.eta.torsion[0]"
        ",forearm.eta.bending_y[0]"
        ",forearm.eta.bending_y[1]"
        ",forearm.eta.bending_y[2]"
        ",forearm.eta.bending_z[0]"
        ",forearm.eta.bending_z[1]"
        ",forearm.eta.bending_z[2]"
        ",forearm.eta.torsion[0]"
        ",tip_x,tip_y,tip_z\n");
    for (n = 0; n <= steps; ++n) {
        for (k = 0; k < ELLA_NTAU; ++k) {
            input.tau[k] = -200 * state.q[k] - 20 * state.v[k];
        }
        if (n % every == 0) {
            status = ella_forward_dynamics(&constants, &state, &input, &work, &output);
            if (status != ELLA_OK) {
                return failure(n, status, work.fault);
            }
            printf("%.6g", (double)n * (double)dt);
            for (k = 0; k < ELLA_NQ; ++k) {
                printf(",%.9g", (double)state.q[k]);
            }
            printf(",%.9g,%.9g,%.9g\n", (double)output.tip_position[0], (double)output.tip_position[1],
                (double)output.tip_position[2]);
        }
        status = ella_step_modal_implicit(&constants, &state, &input, dt, &work);
        if (status != ELLA_OK) {
            return failure(n, status, work.fault);
        }
    }
    return 0;
}
