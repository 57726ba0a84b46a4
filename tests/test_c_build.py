"""The generated C as part of other projects: CMake, mixed precision, compiler options, files that may stay out."""

import re
import subprocess
from functools import cache

import pytest
from conftest import require_tool, swept
from helpers import arm, link, model_of, unfolded

from screwgen.backends.c.fields import index_type
from screwgen.backends.c.project import CProject

BENDS = arm(link("a", 0.5, "z", modes={"bending_y": 1}), link("b", 0.4, "y"))


@cache
def texts(layout="fused") -> dict[str, str]:
    model = model_of(BENDS)
    return CProject(model.chain, model.version, "runtime", layout).files()


def write(folder, layout="fused") -> list[str]:
    """The files in a folder; returns the sources of the library."""
    return unfolded(folder, texts(layout))


def run(folder, *command: str) -> subprocess.CompletedProcess:
    return subprocess.run([require_tool(command[0]), *command[1:]], cwd=folder, capture_output=True, text=True)


# -------- CMake

OUTER = """
cmake_minimum_required(VERSION 3.10)
project(outer C)
set(ARM_REAL_FLOAT ON)
add_subdirectory(arm)
add_library(outer STATIC outer.c)
target_link_libraries(outer arm)
"""
OUTER_SOURCE = """
#include "arm.h"
int outer(void);
int outer(void) { return (int)sizeof(arm_real); }
"""
BARE_METAL = ("-DCMAKE_SYSTEM_NAME=Generic", "-DCMAKE_C_COMPILER=arm-none-eabi-gcc")
BARE_METAL += ("-DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY",)


def test_a_bare_metal_project_adds_the_folder(tmp_path):
    """What it sets before is heard: float. All that is built without being named links without a system."""
    require_tool("arm-none-eabi-gcc")
    write(tmp_path / "arm")
    (tmp_path / "CMakeLists.txt").write_text(OUTER)
    (tmp_path / "outer.c").write_text(OUTER_SOURCE)
    made = run(tmp_path, "cmake", "-S", ".", "-B", "build", *BARE_METAL)
    assert made.returncode == 0, made.stdout + made.stderr
    built = run(tmp_path, "cmake", "--build", "build")
    assert built.returncode == 0, built.stdout + built.stderr
    symbols = run(tmp_path, "arm-none-eabi-nm", "build/arm/libarm.a").stdout
    assert "T arm_prepare_float" in symbols and "T arm_prepare\n" not in symbols


def test_cmake_builds_and_runs_the_self_check_of_the_folder_alone(tmp_path):
    write(tmp_path)
    assert run(tmp_path, "cmake", "-S", ".", "-B", "build").returncode == 0
    built = run(tmp_path, "cmake", "--build", "build", "--target", "all", "test")
    assert built.returncode == 0 and "100% tests passed" in built.stdout, built.stdout + built.stderr


# -------- precision


@pytest.mark.parametrize(("library", "missing"), [("float", "arm_prepare"), ("double", "arm_prepare_float")])
def test_program_and_library_of_different_precision_do_not_link(tmp_path, library, missing):
    sources = write(tmp_path)
    define = ["-DARM_REAL_FLOAT"]
    ours, theirs = (define, []) if library == "float" else ([], define)
    assert run(tmp_path, "gcc", "-std=c99", *ours, "-c", *sources).returncode == 0
    objects = [f"{s[:-2]}.o" for s in sources]
    linked = run(tmp_path, "gcc", "-std=c99", *theirs, "main.c", *objects, "-lm")
    assert linked.returncode != 0 and re.search(rf"undefined reference to `{missing}'", linked.stderr)
    assert run(tmp_path, "gcc", "-std=c99", *ours, "main.c", *objects, "-lm").returncode == 0


# -------- compiler options

REORDER = ("-fassociative-math -fno-signed-zeros -fno-trapping-math", "-funsafe-math-optimizations")


@pytest.mark.parametrize("options", REORDER)
def test_gcc_is_refused_options_that_reorder_sums(tmp_path, options):
    write(tmp_path)
    done = run(tmp_path, "gcc", "-O2", *options.split(), "-fsyntax-only", "arm_real.c")
    assert done.returncode != 0 and "compile without -fassociative-math" in done.stderr


@pytest.mark.parametrize("options", swept(REORDER, REORDER[1]))
def test_clang_does_not_reorder_sums(tmp_path, options):
    """It does not tell of these options; the library's sums stand as they are written all the same."""
    sources = write(tmp_path)
    built = run(tmp_path, "clang", "-O2", *options.split(), "-o", "check", "check.c", *sources, "-lm")
    assert built.returncode == 0, built.stderr
    done = subprocess.run([tmp_path / "check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


# -------- what the README says may stay out, sizes of indices


@pytest.mark.parametrize("layout", ["fused", "modular"])
def test_files_that_may_stay_out(tmp_path, layout):
    """A program of the joint form links without them, whatever it calls and without --gc-sections."""
    sources = write(tmp_path, layout)
    without = re.search(r"without the DAE form (.*?) may stay out", texts(layout)["README.md"], re.DOTALL)[1]
    left = [s for s in sources if f"`{s}`" not in without]
    assert len(left) == len(sources) - 1
    done = run(tmp_path, "gcc", "-std=c99", "-o", "arm", "main.c", *left, "-lm")
    assert done.returncode == 0, done.stderr


def test_row_indices_have_a_type_that_holds_them():
    """Rows of M_sys are counted from 0: 2,800 links with modes have more than a short can count."""
    assert index_type(2**15) == "short" and index_type(2**15 + 1) == "int" and index_type(12 * 2800) == "int"
    for file in ("arm.h", "arm_dae.c"):
        assert re.search(r"const short arm_M_row\[ARM_NNZ\]", texts()[file])
