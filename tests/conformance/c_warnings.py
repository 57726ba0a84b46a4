"""A folder of generated C under two compilers that take every warning for an error."""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from pathlib import Path

from conftest import require_tool

WARNINGS = (
    "-std=c99",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wshadow",
    "-Wdouble-promotion",
    "-Wmissing-prototypes",
    "-Wvla",
    "-Werror",
)
OWN = {
    "gcc": (),
    "clang": ("-Wanon-enum-enum-conversion", "-Wconditional-uninitialized", "-Wno-unknown-warning-option"),
}
"""Warnings that only one of the compilers knows; the last of clang's lets older ones take those that they do not."""
COMPILERS = tuple(OWN)
STRICT = {compiler: ("-O0", *WARNINGS, *own) for compiler, own in OWN.items()}
"""Flags of a folder's Makefile under which every warning is an error."""


def compile_cleanly(folder: Path, compiler: str, level: str, defines: Sequence[str] = ()) -> list[str]:
    """What a compiler says of the sources in a folder, the example and the self-check included; best nothing at all.

    Every source is compiled, because what is used uninitialised is found only where code is made. The objects go to the
    null device; sources in folders below, such as a solver's, are parts of these.
    """
    sources = sorted(path.name for path in folder.glob("*.c"))
    assert sources, f"no C in {folder}"
    options = (*WARNINGS, *OWN[compiler], level, *defines)
    said = []
    for source in sources:
        command = [require_tool(compiler), *options, "-c", "-o", "/dev/null", source]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        said += [line for line in done.stderr.splitlines() if "error:" in line or "warning:" in line]
        said += [f"{source}: exit status {done.returncode}"] if done.returncode and not said else []
    return said
