"""The source of the batch: sine and cosine, warnings, README, stack, cost."""

import re
import subprocess
from itertools import product
from pathlib import Path

import mpmath
import numpy as np
import pytest
import random_robots as rr
from batch_c import ROBOTS, model, write_into, written
from conftest import require_tool, swept
from helpers import unfolded

from screwgen.backends.c import batch as c_batch
from screwgen.backends.c import pieces as c_pieces
from screwgen.backends.c.project import CProject
from screwgen.cli.commands import run_generate
from screwgen.errors import UsageError

WARNINGS = "-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wmissing-prototypes -Werror"

# -------- sine and cosine of lanes

SINE_COSINE = """
#include <stdio.h>
#include "ella_lanes.h"
int main(void)
{
    ella_real x[64 / sizeof(ella_real)], s[64 / sizeof(ella_real)], c[64 / sizeof(ella_real)];
    double number;
    int n = 0, i, more = 1;
    while (more) {
        more = scanf("%la", &number) == 1;
        if (more) { x[n++] = (ella_real)number; }
        if (n == ELLA_LANES || !more) {
            ella_lanes_real lanes = ella_lanes_all(0), sine, cosine;
            for (i = 0; i < n; ++i) { *ella_lane(&lanes, i) = x[i]; }
            ella_lanes_sine_cosine(lanes, &sine, &cosine);
            for (i = 0; i < n; ++i) { s[i] = *ella_lane(&sine, i); c[i] = *ella_lane(&cosine, i); }
            for (i = 0; i < n; ++i) { printf("%a %a\\n", (double)s[i], (double)c[i]); }
            n = 0;
        }
    }
    return 0;
}
"""


def angles(single: bool) -> np.ndarray:
    """Of every size, close to multiples of pi/2, up to where libm takes over and beyond."""
    rng, real, far = np.random.default_rng(0), np.float32 if single else np.float64, 8192.0 if single else 1e6
    quarters = np.concatenate([np.arange(-40, 41), rng.integers(-far / 1.6, far / 1.6, 300)])
    close = real(quarters * np.pi / 2)
    x = [close, np.nextafter(close, real(0)), np.nextafter(close, real(9e9))]
    x += [rng.uniform(-s, s, 600) for s in (1e-9, 1e-3, 0.9, 4.0, 30.0, 1e3, far)]
    x += [[0.0, -0.0, 1e-300, far, -far, 1.1 * far, -1e12]]
    return np.concatenate([np.asarray(part, real) for part in x])


SCALAR = """
#include <stdio.h>
#include "ella_real.h"
int main(void)
{
    double number;
    while (scanf("%la", &number) == 1) {
        const ella_sincos y = ella_sine_cosine((ella_real)number);
        printf("%a %a\\n", (double)y.sine, (double)y.cosine);
    }
    return 0;
}
"""


@pytest.mark.parametrize("flags", ["-O2 -ffp-contract=off", "-O3 -march=native -ffp-contract=fast"])
@pytest.mark.parametrize("single", [False, True])
def test_sine_and_cosine_are_right_within_a_unit_in_the_last_place(tmp_path, single, flags):
    """Those of lanes and those of numbers; without contraction they are the same, but for the sign of zero."""
    write_into(tmp_path, "ella")
    x, found = angles(single), []
    for name, source in (("lanes", SINE_COSINE), ("numbers", SCALAR)):
        (tmp_path / f"{name}.c").write_text(source)
        define = ["-DELLA_REAL_FLOAT"] if single else []
        command = ["gcc", "-std=c99", *flags.split(), *define, f"{name}.c", "ella_real.c", "-o", name, "-lm"]
        subprocess.run(command, cwd=tmp_path, check=True)
        text = "\n".join(float(v).hex() for v in x)
        said = subprocess.run([tmp_path / name], input=text, capture_output=True, text=True, check=True).stdout
        found.append([[float.fromhex(word) for word in line.split()] for line in said.splitlines()])
        assert 0.5 <= worst_deviation(x, found[-1]) < 1.0
    assert np.copysign(1, found[0][-6][0]) == -1 and x[-6] == 0
    assert "fast" in flags or found[0] == found[1]


def worst_deviation(x: np.ndarray, found: list[list[float]]) -> float:
    """The largest error of sines and cosines in units of the last place."""
    worst = 0.0
    with mpmath.workdps(50):
        for angle, pair in zip(x, found, strict=True):
            for function, value in zip((mpmath.sin, mpmath.cos), pair, strict=True):
                exact = function(mpmath.mpf(float(angle)))
                unit = float(np.spacing(np.abs(x.dtype.type(float(exact))))) if exact else 1.0
                worst = max(worst, float(abs(mpmath.mpf(value) - exact)) / unit)
    return worst


# -------- the source


OPTIONS = ("", "-march=native -fopenmp", "-DELLA_LANE_BYTES=0", "-DELLA_REAL_FLOAT")
EITHER = [("gcc", OPTIONS[1]), ("gcc", OPTIONS[3]), ("clang", OPTIONS[0]), ("clang", OPTIONS[2])]
"""Every option with one of the compilers."""


@pytest.mark.parametrize("given", swept(product(("gcc", "clang"), OPTIONS), *EITHER), ids=" ".join)
def test_the_source_compiles_without_a_warning(tmp_path, given):
    compiler, options = given
    require_tool(compiler)
    for binding in ("runtime", "baked"):
        write_into(tmp_path, "ella", binding)
        command = [compiler, *WARNINGS.split(), "-O2", *options.split(), "-c", "ella_batch.c"]
        subprocess.run(command, cwd=tmp_path, check=True)


def test_without_the_option_the_files_are_as_they_were():
    with_batch, without = written("ella"), CProject(model("ella").chain, "").files()
    assert set(with_batch) - set(without) == {"ella_batch.h", "ella_batch.c", "ella_lanes.h"}
    different = {name for name in without if with_batch[name] != without[name]}
    assert different == {"Makefile", "CMakeLists.txt", "README.md"}
    assert not any("batch" in text for text in without.values())


README_EXAMPLE = """
#include <stdio.h>
#include "rigid.h"
{block}
int main(void)
{{
    static rigid_parameters p;
    static rigid_constants c;
    rigid_parameters_default(&p);
    rigid_prepare(&p, &c);
    {{
        {body}
        printf("%d %.17g %.17g\\n", status[N - 1], q[0][N - 1], path[STEPS - 1][0][N - 1]);
    }}
    return 0;
}}
"""


def test_the_command_line_writes_a_batch_and_its_readme_runs(tmp_path):
    """`--batch`; make with OpenMP; the README's lines compiled and run as they stand."""
    for tool in ("cc", "make"):
        require_tool(tool)
    (tmp_path / "rigid.toml").write_text(rr.to_toml(ROBOTS["rigid"] | {"name": "rigid"}))
    out = tmp_path / "out"
    run_generate(str(tmp_path / "rigid.toml"), str(out), ["c"], "runtime", "auto", True, batch=True)
    folder = out / "c"
    block = re.search(r"## Many at once.*?```c\n(.*?)```", (folder / "README.md").read_text(), re.DOTALL)[1]
    declared, _, rest = block.partition("rigid_batch batch")
    (folder / "many.c").write_text(README_EXAMPLE.format(block=declared, body=f"rigid_batch batch{rest}"))
    flags = "CFLAGS=-O1 -march=native -fopenmp"
    subprocess.run(["make", "-s", flags, "check", "build/many.o"], cwd=folder, check=True, capture_output=True)
    subprocess.run(["cc", "-fopenmp", "-o", "many", "build/many.o", "build/librigid.a", "-lm"], cwd=folder, check=True)
    status, q, path = subprocess.run([folder / "many"], capture_output=True, text=True, check=True).stdout.split()
    assert status == "0" and q == path and float(q) != 0


def test_a_batch_without_c_is_refused(tmp_path):
    (tmp_path / "rigid.toml").write_text(rr.to_toml(ROBOTS["rigid"]))
    with pytest.raises(UsageError, match="--batch adds to the C, which --target leaves out"):
        run_generate(
            str(tmp_path / "rigid.toml"), str(tmp_path / "out"), ["latex"], "runtime", "auto", True, batch=True
        )
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("longest", [10, 10000])
@pytest.mark.parametrize("name", ["rigid", "welded"])
def test_the_header_states_the_stack(tmp_path, monkeypatch, name, longest):
    monkeypatch.setattr(c_batch, "LONGEST", longest)
    monkeypatch.setattr(c_pieces, "PIECE", 100)
    files, robot = CProject(model(name).chain, "", batch=True).files(), ROBOTS[name]["name"]
    unfolded(tmp_path, files)
    angles, kept = re.search(r"lanes (sin_q.*, )?kept\[(\d+)\];", files[f"{robot}_batch.c"]).groups()
    turns = f"2 * {robot.upper()}_LENGTH({robot.upper()}_NTAU)" if angles else "0"
    (tmp_path / "size.c").write_text(
        f'#include <stdio.h>\n#include "{robot}_batch.c"\n'
        f'int main(void) {{ printf("%zu", sizeof(group) + sizeof(lanes) * ({kept} + {turns})); return 0; }}\n'
    )
    command = [
        "gcc",
        "-std=c99",
        f"-D{robot.upper()}_LANE_BYTES=64",
        "-Wno-psabi",
        "size.c",
        f"{robot}_real.c",
        "-o",
        "size",
        "-lm",
    ]
    subprocess.run(command, cwd=tmp_path, check=True)
    size = int(subprocess.run([tmp_path / "size"], capture_output=True, check=True).stdout)
    stated = int(re.search(r"up to (\d+) bytes of stack", files[f"{robot}_batch.h"])[1])
    assert size <= stated <= size + 64


# -------- cost

COST = """
#include <string.h>
#include "ella_batch.h"
enum { N = 64 };
static ella_parameters p;
static ella_constants c;
static ella_state x[N];
static ella_input u;
static ella_work work;
static double q[ELLA_NQ][N], v[ELLA_NV][N];
static int status[N];
__attribute__((noinline)) void one_by_one(void)
{
    int i;
    for (i = 0; i < N; ++i) { METHOD(step, (&c, &x[i], &u, 1e-5, &work)); }
}
__attribute__((noinline)) void together(const ella_batch *b) { METHOD(step_batch, (&c, b, 1e-5, 1)); }
int main(void)
{
    ella_batch b = { .count = N, .stride = N, .q = q[0], .v = v[0], .status = status };
    int i;
    ella_parameters_default(&p);
    ella_prepare(&p, &c);
    for (i = 0; i < N; ++i) { x[i].q[1] = q[1][i] = 0.01 * i; x[i].q[2] = q[2][i] = 1; }
    one_by_one();
    together(&b);
    return 0;
}
"""


@pytest.mark.parametrize("method", swept(["rk4", "semi_implicit"], "semi_implicit"))
def test_a_robot_of_a_batch_costs_less_than_two_fifths_of_a_scalar_step(tmp_path, method):
    """Executed instructions of 64 steps, both sides with the same flags: registers of 32 bytes where there are such."""
    require_tool("valgrind")
    wide = "avx2" in Path("/proc/cpuinfo").read_text()
    write_into(tmp_path, "ella")
    (tmp_path / "cost.c").write_text(COST.replace("METHOD(", f"CALL({method}, "))
    define = "-DCALL(m,f,a)=CALL_(m,f,a)", "-DCALL_(m,f,a)=(void)ella_##f##_##m a"
    sources = [f"ella_{x}.c" for x in ("real", "parameters", "dynamics", "links", "step", "batch")]
    command = ["gcc", "-std=c99", "-O2", *(["-mavx2"] * wide), *define, "cost.c", *sources, "-o", "cost", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    counts = [instructions(tmp_path, function) for function in ("one_by_one", "together")]
    assert counts[0] / counts[1] > (2.5 if wide else 1.25)


def instructions(folder, function: str) -> int:
    tool = [
        "valgrind",
        "-q",
        "--tool=callgrind",
        f"--toggle-collect={function}",
        f"--callgrind-out-file={function}.out",
    ]
    subprocess.run([*tool, "./cost"], cwd=folder, check=True, capture_output=True)
    text = (folder / f"{function}.out").read_text()
    return int(re.search(r"^(?:summary|totals): (\d+)", text, re.MULTILINE)[1])
