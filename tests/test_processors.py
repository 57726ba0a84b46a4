"""Functions compiled for several processors: the loader's choice changes the time, never the bits."""

import subprocess

import numpy as np
import pytest
from helpers import arm, drawn, link, model_of

from screwgen.backends.c.project import CProject
from screwgen.runtime.library import compiler_command

MARKED = "target_clones"


def preprocessed(folder, *flags: str) -> str:
    """``arm_dynamics.c`` without comments and includes, as the compiler sees it."""
    command = [*compiler_command(), "-std=c99", *flags, "-E", "-P", "arm_dynamics.c"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True).stdout


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    path = tmp_path_factory.mktemp("processors")
    model = model_of(arm(link("a", modes={"bending_y": 1}), link("b", axes="y")))
    for name, text in CProject(model.chain, "x", "runtime", "fused").files().items():
        (path / name).write_text(text)
    return path


def able() -> bool:
    """Whether the compiler is GCC for x86-64 Linux."""
    asked = [*compiler_command(), "-dM", "-E", "-xc", "/dev/null"]
    defined = subprocess.run(asked, capture_output=True, text=True, check=True).stdout
    names = ("__x86_64__", "__linux__", "__GNUC__")
    return all(f"#define {name} " in defined for name in names) and "__clang__" not in defined


def test_only_optimised_code_of_one_target_is_compiled_twice(folder):
    """A debugger, a processor named by a flag and a user who declines have one version."""
    assert (MARKED in preprocessed(folder, "-O2")) == able()
    x86 = [("-O2", "-mavx2"), ("-O2", "-fsanitize=thread")] if able() else []
    for flags in (("-O0",), ("-O2", "-DARM_ONE_TARGET"), *x86):
        assert MARKED not in preprocessed(folder, *flags)


@pytest.mark.parametrize("layout", ["fused", "modular"])
def test_both_compute_the_same_bits(layout):
    model = drawn(7, 1, max_modes=1).model
    one = model.compile(layout, flags=("-O1", f"-D{model.robot.name.upper()}_ONE_TARGET"))
    chosen = model.compile(layout, flags=("-O1",))
    rng = np.random.default_rng(5)
    for _ in range(20):
        q, v = 0.3 * rng.normal(size=(2, model.nq))
        given = q, v, rng.normal(size=model.n_joints), rng.normal(size=(model.n_links, 6))
        for function in ("forward_dynamics", "complete_dynamics"):
            pairs = zip(getattr(one, function)(*given), getattr(chosen, function)(*given), strict=True)
            assert all(np.array_equal(a, b) for a, b in pairs)


def test_objects_hold_both_versions_where_the_compiler_makes_them(folder):
    """In files compiled on their own, as anybody's Makefile does."""
    for source in ("arm_dynamics", "arm_links"):
        subprocess.run([*compiler_command(), "-std=c99", "-O1", "-c", f"{source}.c"], cwd=folder, check=True)
    asked = ["nm", "arm_dynamics.o", "arm_links.o"]
    symbols = subprocess.run(asked, cwd=folder, capture_output=True, text=True, check=True).stdout
    for function in ("arm_dynamics", "arm_dae_dynamics"):
        assert (f"{function}.avx" in symbols) == able()
