/* main.c: steps the robot. Usage: six_link [duration [step]], in seconds.
 *
 * The joints are held at zero by a simple PD law and the state is printed as CSV every hundredth of the run.
 */
#include <stdio.h>
#include <stdlib.h>

#include "six_link.h"

static int failure(long step, six_link_status status, int fault)
{
    if (status == SIX_LINK_SINGULAR) {
        fprintf(stderr, "six_link: step %ld: the joint of link %d cannot be solved for\n", step, fault);
    } else {
        fprintf(stderr, "six_link: step %ld: status %d\n", step, (int)status);
    }
    return 1;
}

/* The seconds that a text states, 0 if it states none. */
static six_link_real seconds(const char *text)
{
    char *end;
    const double value = strtod(text, &end);
    return *end == 0 ? (six_link_real)value : 0;
}

int main(int argc, char **argv)
{
    const six_link_real duration = argc > 1 ? seconds(argv[1]) : 1;
    const six_link_real dt = argc > 2 ? seconds(argv[2]) : (six_link_real)1e-3;
    static six_link_parameters parameters;
    static six_link_constants constants;
    static six_link_state state;
    static six_link_input input;
    static six_link_output output;
    static six_link_work work;
    six_link_status status;
    long steps, every, n;
    int k;
    if (!(duration > 0) || !(dt > 0) || (double)duration / (double)dt > 1e9) {
        fprintf(stderr, "usage: six_link [duration [step]], both positive seconds\n");
        return 2;
    }
    six_link_parameters_default(&parameters);
    if (six_link_prepare(&parameters, &constants) != SIX_LINK_OK) {
        fprintf(stderr, "six_link: bad parameters\n");
        return 1;
    }
    steps = (long)(duration / dt + (six_link_real)0.5);
    every = steps >= 100 ? steps / 100 : 1;
    printf("t"
        ",shoulder.joint[0]"
        ",upper_arm.joint[0]"
        ",forearm.joint[0]"
        ",wrist_roll.joint[0]"
        ",wrist_pitch.joint[0]"
        ",flange.joint[0]"
        ",upper_arm.eta.bending_y[0]"
        ",upper_arm.eta.bending_y[1]"
        ",upper_arm.eta.bending_z[0]"
        ",upper_arm.eta.bending_z[1]"
        ",upper_arm.eta.torsion[0]"
        ",forearm.eta.bending_y[0]"
        ",forearm.eta.bending_y[1]"
        ",forearm.eta.bending_z[0]"
        ",forearm.eta.bending_z[1]"
        ",tip_x,tip_y,tip_z\n");
    for (n = 0; n <= steps; ++n) {
        for (k = 0; k < SIX_LINK_NTAU; ++k) {
            input.tau[k] = -200 * state.q[k] - 20 * state.v[k];
        }
        if (n % every == 0) {
            status = six_link_forward_dynamics(&constants, &state, &input, &work, &output);
            if (status != SIX_LINK_OK) {
                return failure(n, status, work.fault);
            }
            printf("%.6g", (double)n * (double)dt);
            for (k = 0; k < SIX_LINK_NQ; ++k) {
                printf(",%.9g", (double)state.q[k]);
            }
            printf(",%.9g,%.9g,%.9g\n", (double)output.tip_position[0], (double)output.tip_position[1],
                (double)output.tip_position[2]);
        }
        status = six_link_step_modal_implicit(&constants, &state, &input, dt, &work);
        if (status != SIX_LINK_OK) {
            return failure(n, status, work.fault);
        }
    }
    return 0;
}
