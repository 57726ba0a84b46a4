"""The batch of the generated C: the scalar step in every lane, bit for bit; failures; sine and cosine; cost."""

import ctypes
import math
import re
import subprocess
from functools import cache
from pathlib import Path

import mpmath
import numpy as np
import pytest
import random_robots as rr
from conftest import require_tool
from helpers import arm, equal_links, example_dict, link, model_of

from screwgen.batch import NONFINITE, OK, SINGULAR, CompiledBatch, _Batch, _pointer
from screwgen.chain import fuse
from screwgen.cli_commands import run_generate
from screwgen.compiled import Compiled
from screwgen.emit import c_batch
from screwgen.emit.c import METHODS, CProject
from screwgen.errors import ScrewgenError, SingularError, UsageError
from screwgen.lower.replay import run
from screwgen.lower.split import KEPT, split

BAD_ARGUMENT = 3
STRICT = ("-O0", "-ffp-contract=off")
WARNINGS = "-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wmissing-prototypes -Werror"
WIDTHS = (0, 16, 32, 64)
"""Sizes of registers in bytes; what the machine lacks the compiler takes apart."""

SOFT = {"EA": 1e5, "EIy": 60.0, "EIz": 90.0, "GJ": 40.0, "rhoIp": 1e-3}
STIFF = {"mount": {"xyz": [0.1, 0.0, 0.2], "rpy": [0.3, -0.2, 0.5]}, "armature": [0.05], "damping": [0.2]}
BODY = {"at": "tip", "mass": 0.7, "com": [0.02, 0.01, -0.03], "inertia": [0.01, 0.02, 0.015, 0.001, 0.0, 0.002]}
ROBOTS = {
    "ella": example_dict("ella"),
    "rigid": arm(link("one", axes="yz"), link("two", axes="xyz")),
    "torsion, mount, body": arm(
        link("rod", axes="y", modes={"bending_y": 1, "torsion": 1}, section=SOFT, joint=STIFF, bodies=[BODY])
    ),
    "many modes": arm(link("rod", axes="yz", modes={"bending_y": 5, "bending_z": 5}, section=SOFT)),
    "welded": arm(link("rod", axes=(), modes={"bending_y": 2, "axial": 1}, section=SOFT)),
    "rods": arm(*(link(n, axes=a) | {"section": {"rhoA": 1.0}} for n, a in (("rod", "x"), ("blade", "z")))),
    "eleven links": equal_links(11),
}


@cache
def model(name: str):
    return model_of(ROBOTS[name])


@cache
def batch(name: str, width=16, libm=True, single=False, openmp=False, flags=STRICT) -> CompiledBatch:
    """A batch with registers of a size, whose sine and cosine are the scalar code's unless told otherwise."""
    upper = ROBOTS[name]["name"].upper()
    options = [f"-D{upper}_LANE_BYTES={width}", "-Wno-psabi", *([f"-D{upper}_BATCH_LIBM"] if libm else [])]
    return CompiledBatch(model(name), single, openmp, (*flags, *options))


@cache
def written(name: str, binding="runtime") -> dict[str, str]:
    return CProject(model(name).chain, "", binding, batch=True).files()


def write_into(folder, name: str, binding="runtime") -> dict[str, str]:
    for file, text in written(name, binding).items():
        (folder / file).write_text(text)
    return written(name, binding)


@cache
def scalar(name: str, single=False) -> Compiled:
    return Compiled(model(name), single=single, flags=STRICT)


@cache
def scenarios(name: str, count: int):
    """States (2, nq, count), torques (1, n_joints, count) and wrenches (1, 6 n, count)."""
    states = [rr.random_state(np.random.default_rng(i), ROBOTS[name], modal=0.3) for i in range(count)]
    x = np.array([[s["q"], s["v"]] for s in states]).transpose(1, 2, 0)
    tau, w_ext = (np.array([np.ravel(s[key]) for s in states]).T[None] for key in ("tau", "w_ext"))
    return np.ascontiguousarray(x), np.ascontiguousarray(tau), np.ascontiguousarray(w_ext)


def stepped(b: CompiledBatch, x, tau, w_ext, method="rk4", p=None, periods=1, hold=1, dt=1e-5, threads=1):
    """Paths (2, periods + 1, nq, count) of q and v; status, fault and steps done of the scenarios."""
    path = np.zeros((2, periods + 1, *x.shape[1:]), b.real)
    path[:, 0] = x
    constants = b.constants(np.atleast_2d(b.model.parameter_values if p is None else p))
    inputs = [np.ascontiguousarray(a, b.real) for a in (tau, w_ext)]
    return path, *b.run(*path, *inputs, constants, dt, hold, method, threads)


def one_by_one(c: Compiled, x, tau, w_ext, method="rk4", count=1, dt=1e-5) -> np.ndarray:
    """The states (2, nq, scenarios) after steps of the scalar code."""
    every = range(x.shape[2])
    ends = [c.step(*x[:, :, i], tau[0, :, i], w_ext[0, :, i], dt, method, count) for i in every]
    return np.array(ends).transpose(1, 2, 0)


# -------- the same operations: the same bits


@pytest.mark.parametrize("width", WIDTHS)
def test_lanes_of_every_width_step_bit_for_bit_as_the_scalar_code(width, name="ella"):
    given = scenarios(name, 19)
    for method in METHODS:
        path, status, _, done = stepped(batch(name, width), *given, method, hold=3)
        assert not status.any() and (done == 3).all()
        assert np.array_equal(path[:, -1], one_by_one(scalar(name), *given, method, 3)), method


@pytest.mark.parametrize("name", ["rigid", "torsion, mount, body", "many modes", "welded"])
def test_robots_of_every_kind_step_bit_for_bit(name):
    given = scenarios(name, 5)
    for method in ("rk4", "modal_midpoint"):
        path, status, *_ = stepped(batch(name), *given, method)
        assert not status.any()
        assert np.array_equal(path[:, -1], one_by_one(scalar(name), *given, method)), method


def test_single_precision_steps_bit_for_bit():
    given = scenarios("ella", 7)
    path, status, *_ = stepped(batch("ella", single=True), *given)
    assert path.dtype == np.float32 and not status.any()
    assert np.array_equal(path[:, -1], one_by_one(scalar("ella", True), *given))


def test_wide_turns_of_sections_take_the_long_series_and_the_closed_form():
    """Tip sections turned by 0.1, 0.6, 1.9, 2.1 and 3 radians, side by side in one register."""
    x, tau, w_ext = (a.copy() for a in scenarios("torsion, mount, body", 5))
    x[0, 1:] = 0
    x[0, 2] = np.array([0.1, 0.6, 1.9, 2.1, 3.0]) / 2**0.5
    path, status, *_ = stepped(batch("torsion, mount, body", 64), x, tau, w_ext)
    assert not status.any()
    assert np.array_equal(path[:, -1], one_by_one(scalar("torsion, mount, body"), x, tau, w_ext))


def test_polynomial_sine_and_cosine_change_the_step_by_rounding_only():
    given = scenarios("ella", 16)
    exact, other = (stepped(batch("ella", 32, libm), *given)[0][:, -1] for libm in (True, False))
    scale = np.abs(exact).max(axis=2, keepdims=True)
    assert 0 < np.max(np.abs(exact - other) / scale) < 1e-13


def test_long_chains_are_cut_into_pieces():
    """Eleven links: the scalar code is modular, the batch is not; another order of operations."""
    given = scenarios("eleven links", 5)
    b, c = batch("eleven links"), scalar("eleven links")
    path, status, *_ = stepped(b, *given)
    expected = one_by_one(c, *given)
    assert not status.any() and c.project.layout == "modular"
    assert "dynamics_2(" in written("eleven links")["arm_batch.c"]
    scale = np.abs(expected).max(axis=2, keepdims=True)
    assert np.max(np.abs(path[:, -1] - expected) / scale) < 1e-11


def test_pieces_are_the_program(monkeypatch):
    """ELLA in pieces of some 300 operations, and whole."""
    monkeypatch.setattr(c_batch, "LONGEST", 10)
    monkeypatch.setattr(c_batch, "PIECE", 300)
    options = ("-DELLA_LANE_BYTES=16", "-DELLA_BATCH_LIBM", *STRICT)
    given = scenarios("ella", 4)
    fresh = CompiledBatch(model_of(ROBOTS["ella"]), flags=options)
    path, *_ = stepped(fresh, *given)
    assert np.array_equal(path, stepped(batch("ella"), *given)[0])


@pytest.mark.parametrize("pieces", [1, 2, 7, 100])
def test_split_programs_give_what_the_whole_gives(pieces):
    program = fuse.forward_dynamics(model("rigid").chain, "baked")
    rng = np.random.default_rng(0)
    inputs = {name: list(rng.normal(size=size)) for name, size in program.inputs.items()}
    unary = lambda op, x: -x if op == "neg" else getattr(math, op)(x)  # noqa: E731
    whole, guards = run(program, inputs, unary)
    parts, size = split(program, pieces)
    kept, found, checked = [None] * size, {name: {} for name in whole}, []
    for part in parts:
        assert part.operation_count <= len(program.nodes) / pieces + 1
        out, positive = run(part, inputs | {KEPT: kept}, unary)
        checked += positive
        for name, values in out.items():
            kind, _, first = name.partition(":")
            for k, value in enumerate(values):
                if kind == KEPT:
                    kept[int(first) + k] = value
                elif value is not None:
                    found[name][k] = value
    assert {name: [values[k] for k in sorted(values)] for name, values in found.items()} == whole
    assert sorted(checked) == sorted(guards)
    assert sum(part.operation_count for part in parts) == program.operation_count


# -------- batches


def test_batches_of_every_size_give_the_same_numbers():
    """0 to 1000 scenarios: remainders of registers, and every scenario independent of the others."""
    b = batch("ella", libm=False, flags=("-O2", "-ffp-contract=off"))
    x, tau, w_ext = (np.resize(a, (*a.shape[:-1], 1000)) for a in scenarios("ella", 50))
    whole = stepped(b, x, tau, w_ext, "semi_implicit")[0]
    for size in range(1001):
        part = [np.ascontiguousarray(a[..., :size]) for a in (x, tau, w_ext)]
        path, status, fault, done = stepped(b, *part, "semi_implicit")
        assert np.array_equal(path, whole[..., :size])
        assert (status == OK).all() and (fault == -1).all() and (done == 1).all() and len(done) == size


def test_periods_hold_their_inputs_and_leave_a_path():
    x, *_ = scenarios("ella", 11)
    rng = np.random.default_rng(1)
    tau, w_ext = rng.normal(size=(4, 3, 11)), rng.normal(size=(4, 12, 11))
    path, _, _, done = stepped(batch("ella"), x, tau, w_ext, "modal_midpoint", periods=4, hold=5, dt=1e-4)
    assert (done == 20).all()
    for k in range(4):
        x = one_by_one(scalar("ella"), x, tau[k : k + 1], w_ext[k : k + 1], "modal_midpoint", 5, 1e-4)
        assert np.array_equal(path[:, k + 1], x)


def test_scenarios_may_have_parameters_of_their_own():
    given, m, c = scenarios("ella", 6), model("ella"), Compiled(model("ella"), flags=STRICT)
    p = np.tile(m.parameter_values, (6, 1))
    p[:, m.parameter_names.index("forearm.bodies[0].mass")] = np.linspace(0.5, 4, 6)
    path, *_ = stepped(batch("ella"), *given, p=p)
    for i in range(6):
        c.prepare(p[i])
        assert np.array_equal(path[:, -1, :, [i]].transpose(1, 2, 0), one_by_one(c, *(a[..., [i]] for a in given)))


def test_openmp_changes_no_bit():
    given = scenarios("ella", 50)
    alone = stepped(batch("ella", libm=False), *given, periods=3)
    for threads in (1, 2, 5):
        several = stepped(batch("ella", libm=False, openmp=True), *given, periods=3, threads=threads)
        assert all(np.array_equal(a, b) for a, b in zip(alone, several, strict=True))


# -------- failures


@pytest.mark.parametrize("method", METHODS)
def test_a_failing_scenario_is_frozen_and_its_neighbours_go_on(method):
    x, tau, w_ext = (a.copy() for a in scenarios("ella", 9))
    good = stepped(batch("ella", 64), x, tau, w_ext, method, periods=3)[0]
    x[0, 0, 2], x[1, 4, 3], tau[0, 1, 5], w_ext[0, 7, 8] = np.nan, 1e200, np.inf, -np.inf
    bad = [2, 3, 5, 8]
    path, status, fault, done = stepped(batch("ella", 64), x, tau, w_ext, method, periods=3)
    fine = [i for i in range(9) if i not in bad]
    assert (status[bad] == NONFINITE).all() and not status[fine].any() and (fault == -1).all()
    assert (done[bad] == 0).all() and (done[fine] == 3).all()
    assert np.array_equal(path[..., fine], good[..., fine])
    assert all(np.array_equal(path[:, k][..., bad], x[..., bad], equal_nan=True) for k in range(4))


@pytest.mark.parametrize("width", WIDTHS)
def test_a_singular_scenario_is_blamed_on_its_link_as_by_the_scalar_code(width):
    """A rod that spins about its own axis without spin inertia carries another: singular where that is in line."""
    angles = np.array([0.5, 0.0, -1.2, 0.0, 0.9])
    x = np.zeros((2, 2, 5))
    x[0, 1] = angles
    x[1, 0, 3] = np.nan
    path, status, fault, done = stepped(batch("rods", width), x, np.ones((1, 2, 5)), np.zeros((1, 12, 5)))
    assert list(status) == [OK, SINGULAR, OK, NONFINITE, OK]
    assert list(fault) == [-1, 0, -1, -1, -1] and list(done) == [1, 0, 1, 0, 1]
    assert np.array_equal(path[:, 1, :, 1], x[:, :, 1])


def test_a_motion_that_diverges_is_frozen_where_the_scalar_code_stops():
    """Explicit Euler far beyond its step: every scenario ends, each at its own time, in a finite state."""
    given = scenarios("ella", 9)
    path, status, _, done = stepped(batch("ella"), *given, "euler", periods=40, dt=3e-4)
    assert (status != OK).all() and len(set(done)) > 1 and np.isfinite(path).all()
    for i, k in enumerate(done):
        one = [a[..., [i]] for a in given]
        assert np.array_equal(path[:, k, :, [i]], path[:, -1, :, [i]])
        assert np.array_equal(path[:, k, :, i], one_by_one(scalar("ella"), *one, "euler", int(k), 3e-4)[..., 0])
        with pytest.raises(SingularError if status[i] == SINGULAR else ScrewgenError):
            one_by_one(scalar("ella"), *one, "euler", int(k) + 1, 3e-4)


def test_scenarios_that_have_failed_before_are_left_alone():
    b, (x, tau, w_ext) = batch("ella"), scenarios("ella", 5)
    status, q, v = np.array([0, 1, 0, 2, 7], np.int32), x[0].copy(), x[1].copy()
    given = _Batch(count=5, stride=5, q=_pointer(q), v=_pointer(v), tau=_pointer(tau), w_ext=_pointer(w_ext))
    given.status = _pointer(status)
    assert call(b, given) == OK
    moved = stepped(b, x, tau, w_ext)[0][:, -1]
    assert np.array_equal(np.array([q, v])[..., ::2][..., :2], moved[..., [0, 2]])
    assert np.array_equal(np.array([q, v])[..., [1, 3, 4]], x[..., [1, 3, 4]]) and list(status) == [0, 1, 0, 2, 7]


def call(b: CompiledBatch, given, constants=..., dt=1e-5, periods=1) -> int:
    c = b.constants(np.atleast_2d(b.model.parameter_values)) if constants is ... else constants
    where = None if c is None else _pointer(c)
    place = None if given is None else ctypes.byref(given)
    return b.library.shim_batch(METHODS.index("rk4"), where, place, ctypes.c_double(dt), periods, 1)


def test_bad_arguments_are_refused_and_nothing_is_done():
    b, (x, *_) = batch("ella"), scenarios("ella", 5)
    q, v, status = x[0].copy(), x[1].copy(), np.zeros(5, np.int32)

    def given(**other):
        good = {"count": 5, "stride": 5, "q": _pointer(q), "v": _pointer(v), "status": _pointer(status)}
        return _Batch(**(good | other))

    refused = [given(**{name: value}) for name, value in (("count", -1), ("stride", 4), ("hold", -1))]
    refused += [given(**{name: None}) for name in ("q", "v", "status")]
    assert [call(b, x) for x in refused] == [BAD_ARGUMENT] * 6
    assert [call(b, given(), dt=dt) for dt in (0.0, -1e-3, math.nan, math.inf)] == [BAD_ARGUMENT] * 4
    assert [call(b, None), call(b, given(), None), call(b, given(), periods=-1)] == [BAD_ARGUMENT] * 3
    assert np.array_equal([q, v], x) and not status.any()
    assert call(b, given(count=0, q=None, v=None, status=None)) == call(b, given(), periods=0) == OK
    assert np.array_equal([q, v], x)


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


@pytest.mark.parametrize("flags", ["-O2 -ffp-contract=off", "-O3 -march=native -ffp-contract=fast"])
@pytest.mark.parametrize("single", [False, True])
def test_sine_and_cosine_are_right_within_a_unit_in_the_last_place(tmp_path, single, flags):
    write_into(tmp_path, "ella")
    (tmp_path / "turn.c").write_text(SINE_COSINE)
    define = ["-DELLA_REAL_FLOAT"] if single else []
    command = ["gcc", "-std=c99", *flags.split(), *define, "turn.c", "-o", "turn", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    x = angles(single)
    text = "\n".join(float(v).hex() for v in x)
    said = subprocess.run([tmp_path / "turn"], input=text, capture_output=True, text=True, check=True).stdout
    worst = 0.0
    with mpmath.workdps(50):
        for angle, line in zip(x, said.splitlines(), strict=True):
            for function, found in zip((mpmath.sin, mpmath.cos), line.split(), strict=True):
                exact = function(mpmath.mpf(float(angle)))
                unit = float(np.spacing(np.abs(x.dtype.type(float(exact))))) if exact else 1.0
                worst = max(worst, float(abs(mpmath.mpf(float.fromhex(found)) - exact)) / unit)
    assert 0.5 <= worst < 1.0
    assert said.splitlines()[-6].split()[0] == "-0x0p+0"


# -------- the source


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("options", ["", "-march=native -fopenmp", "-DELLA_LANE_BYTES=0", "-DELLA_REAL_FLOAT"])
def test_the_source_compiles_without_a_warning(tmp_path, compiler, options):
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
    run_generate(str(tmp_path / "rigid.toml"), str(out), ["c"], "runtime", "auto", True, True, False)
    folder = out / "c"
    block = re.search(r"## Many at once.*?```c\n(.*?)```", (folder / "README.md").read_text(), re.DOTALL)[1]
    declared, _, rest = block.partition("rigid_batch batch")
    (folder / "many.c").write_text(README_EXAMPLE.format(block=declared, body=f"rigid_batch batch{rest}"))
    flags = "CFLAGS=-O1 -march=native -fopenmp"
    subprocess.run(["make", "-s", flags, "check", "many.o"], cwd=folder, check=True, capture_output=True)
    subprocess.run(["cc", "-fopenmp", "-o", "many", "many.o", "librigid.a", "-lm"], cwd=folder, check=True)
    status, q, path = subprocess.run([folder / "many"], capture_output=True, text=True, check=True).stdout.split()
    assert status == "0" and q == path and float(q) != 0


def test_a_batch_without_c_is_refused(tmp_path):
    (tmp_path / "rigid.toml").write_text(rr.to_toml(ROBOTS["rigid"]))
    with pytest.raises(UsageError, match="--batch adds to the C, which --target leaves out"):
        run_generate(
            str(tmp_path / "rigid.toml"), str(tmp_path / "out"), ["latex"], "runtime", "auto", True, True, False
        )
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("longest", [10, 10000])
@pytest.mark.parametrize("name", ["rigid", "welded"])
def test_the_header_states_the_stack(tmp_path, monkeypatch, name, longest):
    monkeypatch.setattr(c_batch, "LONGEST", longest)
    monkeypatch.setattr(c_batch, "PIECE", 100)
    files, robot = CProject(model(name).chain, "", batch=True).files(), ROBOTS[name]["name"]
    for file, text in files.items():
        (tmp_path / file).write_text(text)
    kept = re.search(r"kept\[(\w+\(\d+\))\]", files[f"{robot}_batch.c"])[1]
    turns = f"2 * {robot.upper()}_LENGTH({robot.upper()}_NTAU)"
    (tmp_path / "size.c").write_text(
        f'#include <stdio.h>\n#include "{robot}_batch.c"\n'
        f'int main(void) {{ printf("%zu", sizeof(group) + sizeof(lanes) * ({kept} + {turns})); return 0; }}\n'
    )
    command = ["gcc", "-std=c99", f"-D{robot.upper()}_LANE_BYTES=64", "-Wno-psabi", "size.c", "-o", "size", "-lm"]
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


@pytest.mark.parametrize("method", ["rk4", "semi_implicit"])
def test_a_robot_of_a_batch_costs_less_than_two_fifths_of_a_scalar_step(tmp_path, method):
    """Executed instructions of 64 steps with registers of 32 bytes (AVX2), both sides with the same flags."""
    require_tool("valgrind")
    if "avx2" not in Path("/proc/cpuinfo").read_text():
        pytest.skip("the machine has no AVX2")
    write_into(tmp_path, "ella")
    (tmp_path / "cost.c").write_text(COST.replace("METHOD(", f"CALL({method}, "))
    define = "-DCALL(m,f,a)=CALL_(m,f,a)", "-DCALL_(m,f,a)=(void)ella_##f##_##m a"
    sources = [f"ella_{x}.c" for x in ("parameters", "dynamics", "links", "step", "batch")]
    command = ["gcc", "-std=c99", "-O2", "-mavx2", *define, "cost.c", *sources, "-o", "cost", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    counts = [instructions(tmp_path, function) for function in ("one_by_one", "together")]
    assert counts[0] / counts[1] > 2.5


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
