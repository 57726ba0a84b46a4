"""The derivatives of a step: the generated C beside the C that CasADi generates from the jacobian of its step function.

Both have the same compiler and flags and take turns; a time is the best of all rounds, on one processor. CasADi's
function is `step_<method>` with the parameters as numbers, differentiated by `jacobian`. Instructions are counted by
valgrind where it is there. Compilers take minutes for CasADi's function at -O2: `-O1` is the default.

python bench/step_derivatives.py [ROBOT [METHOD [FLAGS ...]]]
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import casadi as ca
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import screwgen  # noqa: E402
from screwgen.backends.c.project import CProject  # noqa: E402

STEP, ROUNDS, LEAST = 0.01, 60, 2e-3
TOLERANCE = 1e-10
COMMON = ("-std=gnu99", "-w", "-ffunction-sections", "-Wl,--gc-sections")

OWN = """
#include "{name}_derivatives.h"
static {name}_parameters p; static {name}_constants c; static {name}_state x, next; static {name}_input u;
static {name}_step_derivatives_work work; static {name}_step_derivatives out;
void own_prepare(const double *given)
{{
    int k;
    {name}_parameters_default(&p);
    if ({name}_prepare(&p, &c)) __builtin_trap();
    for (k = 0; k < {NAME}_NQ; ++k) x.q[k] = *given++;
    for (k = 0; k < {NAME}_NV; ++k) x.v[k] = *given++;
    for (k = 0; k < {NAME}_NTAU; ++k) u.tau[k] = *given++;
}}
void own_call(void)
{{
    if ({name}_step_{method}_derivatives(&c, &x, &u, {h}, &work, &next, &out)) __builtin_trap();
}}
const double *own_A(void) {{ return &out.A[0][0]; }}
const double *own_B(void) {{ return &out.B[0][0]; }}
void own_step(void)
{{
    static {name}_work w;
    {name}_state y = x;
    if ({name}_step_{method}(&c, &y, &u, {h}, &w)) __builtin_trap();
}}
"""

DRIVER = """
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <time.h>
static double seconds(void)
{{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}}
void own_prepare(const double *); void own_call(void); void own_step(void);
const double *own_A(void); const double *own_B(void);
int casadi(const double **, double **, long long *, double *, int);
static const double X[] = {{ {x} }};
{caller}
static void (*const CALLS[])(void) = {{ own_call, own_step, call_casadi }};
enum {{ COUNT = sizeof CALLS / sizeof *CALLS }};
static double check(const double *own, const double *other, int rows, int columns)
{{
    double worst = 0, size = 0;
    int i, k;
    for (i = 0; i < rows; ++i) for (k = 0; k < columns; ++k) {{
        const double e = fabs(own[i * columns + k] - other[k * rows + i]);
        worst = e > worst ? e : worst;
        size = fabs(other[k * rows + i]) > size ? fabs(other[k * rows + i]) : size;
    }}
    return worst / size;
}}
int main(int argc, char **argv)
{{
    double best[COUNT], once[COUNT];
    long calls[COUNT];
    int r, k;
    long j;
    own_prepare(X);
    if (argc > 1) {{
        const int which = atoi(argv[1]);
        for (j = atol(argv[2]); j > 0; --j) CALLS[which]();
        return 0;
    }}
    for (k = 0; k < COUNT; ++k) {{
        double t;
        CALLS[k]();
        t = seconds();
        for (j = 0; j < 20; ++j) CALLS[k]();
        once[k] = (seconds() - t) / 20;
        calls[k] = 1 + (long)({least} / once[k]);
        best[k] = 1e9;
    }}
    printf("differs %.3g\\n",
        fmax(check(own_A(), A_casadi, {rows}, {rows}), check(own_B(), B_casadi, {rows}, {columns})));
    for (r = 0; r < {rounds}; ++r) for (k = 0; k < COUNT; ++k) {{
        double t = seconds();
        for (j = 0; j < calls[k]; ++j) CALLS[k]();
        t = (seconds() - t) / calls[k];
        best[k] = t < best[k] ? t : best[k];
    }}
    for (k = 0; k < COUNT; ++k) printf("time %d %.9g\\n", k, best[k]);
    return 0;
}}
"""

CALLER = """
static double casadi_w[{w} + 1];
static long long casadi_iw[{iw} + 1];
static double A_casadi[{a}], B_casadi[{b}], casadi_next[{nx}];
static void call_casadi(void)
{{
    static const double *arg[{n_arg}];
    static double *res[{n_res}];
    arg[0] = X, arg[1] = X + {nq}, arg[2] = X + {nq} + {nv};
    res[0] = casadi_next, res[1] = casadi_next + {nq}, res[2] = A_casadi, res[3] = B_casadi;
    casadi(arg, res, casadi_iw, casadi_w, 0);
}}
"""


def by_casadi(model, method: str) -> ca.Function:
    """CasADi's step with dense derivatives; `Function.jacobian` and `cse` take as many operations, within 1 %."""
    f, c = model.casadi()[f"step_{method}"], model.chain
    q, v, tau = (ca.SX.sym(n, k) for n, k in (("q", c.nq), ("v", c.nv), ("tau", c.n_tau)))
    q_next, v_next = f(q, v, tau, np.zeros((6, c.n)), model.parameter_values, STEP)
    y, x = ca.vertcat(q_next, v_next), ca.vertcat(q, v)
    slopes = (ca.densify(ca.jacobian(y, given)) for given in (x, tau))
    return ca.Function("casadi", [q, v, tau], [q_next, v_next, *slopes])


def sources(model, method: str, folder: Path) -> list[str]:
    c, name = model.chain, model.robot.name
    project = CProject(c, model.version, derivatives=True)
    texts = {n: t for n, t in project.files().items() if n.endswith((".c", ".h")) and n not in ("main.c", "check.c")}
    texts["own.c"] = OWN.format(name=name, NAME=name.upper(), method=method, h=STEP)
    f = by_casadi(model, method)
    rng = np.random.default_rng(1)
    x = [*rng.uniform(-1, 1, c.nq - c.n_modes), *rng.uniform(-0.01, 0.01, c.n_modes)]
    x += [*rng.uniform(-1, 1, c.nv - c.n_modes), *rng.uniform(-0.1, 0.1, c.n_modes), *rng.uniform(-5, 5, c.n_tau)]
    rows = 2 * c.nv
    texts["casadi.c"] = generated(f)
    sizes = {"w": f.sz_w(), "iw": f.sz_iw(), "n_arg": f.sz_arg(), "n_res": f.sz_res(), "nq": c.nq, "nv": c.nv}
    texts["driver.c"] = DRIVER.format(
        caller=CALLER.format(a=rows * rows, b=rows * c.n_tau, nx=rows, **sizes),
        x=", ".join(map(repr, map(float, x))),
        rows=rows,
        columns=c.n_tau,
        rounds=ROUNDS,
        least=LEAST,
    )
    for file, text in texts.items():
        (folder / file).write_text(text)
    return [file for file in texts if file.endswith(".c")]


def generated(f: ca.Function) -> str:
    """CasADi's C of a function."""
    made = ca.CodeGenerator("casadi")
    made.add(f)
    return made.dump()


def instructions(program: Path, which: int) -> float | None:
    """Instructions of one call, by the difference of two runs."""
    if not shutil.which("valgrind"):
        return None
    counts = []
    for calls in (2, 12):
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", program, str(which), str(calls)]
        said = subprocess.run(command, capture_output=True, text=True, check=True).stderr
        counts.append(int(re.search(r"Collected : (\d+)", said)[1]))
    return (counts[1] - counts[0]) / 10


def measure(robot: str, method: str, flags: list[str]) -> str:
    model = screwgen.derive(screwgen.load(HERE.parent / "examples" / f"{robot}.toml"))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        files = sources(model, method, folder)
        program = folder / "program"
        subprocess.run(["gcc", *COMMON, *flags, *files, "-lm", "-o", program], cwd=folder, check=True)
        said = subprocess.run([program], capture_output=True, text=True, check=True).stdout.splitlines()
        differs = float(said[0].split()[1])
        if not differs < TOLERANCE:
            raise SystemExit(f"{robot}: the derivatives differ by {differs:.1e}")
        times = [float(line.split()[2]) for line in said[1:]]
        labels = ["screwgen, step and derivatives", "screwgen, step alone", "CasADi, step and derivatives"]
        out = [f"{robot} {method}, nv = {model.chain.nv}, gcc {' '.join(flags)}; largest difference {differs:.0e}"]
        for k, (label, t) in enumerate(zip(labels, times, strict=True)):
            count = instructions(program, k)
            counted = f"{count:10.0f} instructions" if count else ""
            out.append(f"  {label:32} {1e6 * t:8.2f} µs  {t / times[0]:5.2f}  {counted}")
    return "\n".join(out)


if __name__ == "__main__":
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    given = sys.argv[1:]
    print(measure(given[0] if given else "ella", given[1] if given[1:] else "modal_midpoint", given[2:] or ["-O1"]))
