"""The gate of the filter in C alone: what a burst of false samples leaves is what missing ones leave."""

import subprocess

from c_tools import SANITIZERS
from conftest import require_tool
from test_estimator_gate import model

from screwgen.runtime.lean import RuntimeProject

PROGRAM = """
#include <float.h>
#include <stdio.h>
#include <string.h>
#include "arm_estimator.h"
static arm_parameters p; static arm_constants c; static arm_work work; static arm_estimator_work scratch;
static arm_state run(int entry, int length, double added, int missing)
{
    static arm_estimator e; arm_state truth = {{0}}, deviation; arm_input u = {0}; int k, i;
    for (i = 0; i < ARM_NQ; ++i) { deviation.q[i] = 1e-3; deviation.v[i] = 1e-2; }
    arm_estimator_init(&p, &truth, &deviation, &e);
    for (i = 0; i < ARM_NV; ++i) e.density_v[i] = 0.1;
    e.encoder_variance[0] = 1e-8; e.gate = 5;
    for (i = 0; i < ARM_NGAUGES; ++i) { e.strain_variance[i] = 4e-12; e.fibre[i] = 0.02; }
    for (k = 0; k < 60; ++k) {
        arm_measurement z = {{0}}; int false_one = k >= 30 && k < 30 + length;
        u.tau[0] = k % 20 < 10 ? 1 : -1;
        arm_step_modal_midpoint(&c, &truth, &u, 1e-3, &work);
        z.has_encoder[0] = 1; z.encoder[0] = truth.q[0];
        if (arm_estimator_predict(&c, &e, &u, 1e-3, &scratch) != ARM_OK) printf("predict\\n");
        for (i = 0; i < ARM_NGAUGES; ++i) {
            z.has_strain[i] = 1; z.strain[i] = -0.02 * e.curvature[i] * truth.q[1 + i];
        }
        if (false_one && entry == 0) z.encoder[0] += added, z.has_encoder[0] = !missing;
        if (false_one && entry > 0) { z.strain[entry - 1] += added; z.has_strain[entry - 1] = !missing; }
        if (arm_estimator_update(&c, &e, &u, &z, &scratch) != ARM_OK) printf("update\\n");
        if (e.innovations.refused != (false_one && !missing)) printf("refused %d\\n", e.innovations.refused);
    }
    return e.state;
}
int main(void)
{
    static const double SIZES[] = { 1, -30, 1e3, 1e9, 1e150, 1e307 };
    static const int LENGTHS[] = { 1, 3, 10 }; int entry, s, l;
    arm_parameters_default(&p); arm_prepare(&p, &c);
    for (entry = 0; entry < 1 + ARM_NGAUGES; ++entry)
        for (l = 0; l < 3; ++l) {
            arm_state missing = run(entry, LENGTHS[l], 0, 1);
            for (s = 0; s < 6; ++s) {
                arm_state found = run(entry, LENGTHS[l], SIZES[s], 0);
                if (memcmp(&found, &missing, sizeof found) != 0) printf("entry %d size %g\\n", entry, SIZES[s]);
            }
        }
    return printf("done\\n") < 0;
}
"""


def test_the_gate_in_c_under_sanitizers(tmp_path):
    """Bit for bit what drop-outs leave, and the count of refused entries; nothing else is printed."""
    files = RuntimeProject(model().chain, "0", "runtime", estimator=True).files() | {"main.c": PROGRAM}
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    sources = (name for name in files if name.endswith(".c"))
    command = [require_tool("gcc"), "-std=c99", "-O0", *SANITIZERS, "-o", "run", *sources, "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    assert subprocess.run([tmp_path / "run"], capture_output=True, text=True, check=True).stdout == "done\n"
