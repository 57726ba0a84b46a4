"""The analysers of the generated C and what they must not find. Each function returns findings, best none at all."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from c_robots import DRIVERS, EACH_METHOD, Kind, write_robot
from conftest import require_tool
from helpers import ROOT

DEVIATIONS = ROOT / "docs" / "misra.md"
ABUSERS = ("abuse", "extras")
"""Drivers that call everything with what it must refuse."""
SANITIZERS = ("-fsanitize=address,undefined,float-cast-overflow", "-fno-sanitize-recover=all")
"""Division by zero is not among them: IEEE arithmetic defines it, and the guards look at its results."""
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Werror")
VALGRIND = ("-q", "--error-exitcode=9", "--leak-check=full")


def run(folder: Path, tool: str, *arguments: str) -> subprocess.CompletedProcess:
    return subprocess.run([require_tool(tool), *arguments], cwd=folder, capture_output=True, text=True)


# -------- static


def gcc_analyser(kind: Kind, folder: Path, whole=False) -> list[str]:
    """What gcc -fanalyzer says of the library, the example and the self-check."""
    sources = [*write_robot(kind, folder, whole), "main.c", "check.c"]
    done = [run(folder, "gcc", *STRICT, "-O2", "-fanalyzer", *kind.defines, "-c", "-o", "x.o", s) for s in sources]
    return [line for d in done for line in d.stderr.splitlines() if re.search(r"\b(error|warning):", line)]


def clang_tidy(kind: Kind, folder: Path, whole=False) -> list[str]:
    """What clang-tidy says with the checks of .clang-tidy, of the sources, of their headers and of the driver."""
    drivers = [str(DRIVERS / f"{name}.c") for name in ABUSERS[: 1 + whole]]
    sources = [*write_robot(kind, folder, whole), "main.c", "check.c", *drivers]
    options = ("--quiet", "--header-filter=.*", f"--config-file={ROOT / '.clang-tidy'}")
    done = run(folder, "clang-tidy", *options, *sources, "--", "-std=c99", "-I.", EACH_METHOD, *kind.defines)
    lines = [line for line in done.stdout.splitlines() if re.search(r"\b(error|warning):", line)]
    return lines or ([done.stderr] if done.returncode else [])


def cppcheck(kind: Kind, folder: Path) -> list[str]:
    """What cppcheck says beyond cppcheck-suppressions.txt; each line is file:line:identifier:message.

    Not of derivatives and batch: it takes minutes for the one, and the other is made of GCC's vector types.
    """
    sources = [*write_robot(kind, folder, whole=False), "main.c", "check.c"]
    suppressions = ROOT / "tests" / "c" / "cppcheck-suppressions.txt"
    done = run(
        folder,
        "cppcheck",
        "--enable=all",
        "--inconclusive",
        "--std=c99",
        "--addon=misra",
        "--quiet",
        "--template={file}:{line}:{id}:{message}",
        "--template-location=",
        f"--suppressions-list={suppressions}",
        "--suppress=unmatchedSuppression",
        "-D__STDC_VERSION__=199901L",
        "-DFLT_EVAL_METHOD=0",
        *kind.defines,
        *sources,
    )
    return done.stderr.splitlines()


# -------- MISRA


def misra(findings: list[str]) -> set[tuple[str, str]]:
    """Rule and file of cppcheck's MISRA findings; of the library's files without the robot's name."""
    found = (re.match(r"(?:robot_)?([\w.]+):\d+:misra-c2012-([\d.]+):", line) for line in findings)
    return {(m[2], m[1]) for m in found if m}


def deviations() -> set[tuple[str, str]]:
    """Rule and file of the deviations that docs/misra.md argues, from its table."""
    rows = re.findall(r"^\| (\d+\.\d+) \| ([^|]+) \|", DEVIATIONS.read_text(encoding="utf-8"), re.MULTILINE)
    return {(rule, file) for rule, files in rows for file in re.findall(r"`([\w.]+)`", files)}


# -------- running


def build(kind: Kind, folder: Path, programs: tuple[str, ...], *flags: str) -> list[Path]:
    """Programs of a robot's C out of "check", "main" and the drivers."""
    options = (*STRICT, "-g", *flags, *kind.defines, EACH_METHOD, "-I.")
    sources = write_robot(kind, folder)
    objects = [s.replace(".c", ".o") for s in sources]
    steps = [[*options, "-c", *sources]]
    for program in programs:
        first = str(DRIVERS / f"{program}.c") if program in ABUSERS else f"{program}.c"
        steps.append([*options, "-o", program, first, *objects, "-lm"])
    for arguments in steps:
        done = run(folder, "gcc", *arguments)
        assert done.returncode == 0, done.stderr[:3000]
    return [folder / program for program in programs]


def complaint(done: subprocess.CompletedProcess, expected: int = 0) -> list[str]:
    """What a program or its guard said, if it did not end as expected."""
    said = (done.stdout + done.stderr).strip()
    fine = done.returncode == expected and "runtime error" not in said and "Sanitizer" not in said
    return [] if fine else [f"exit status {done.returncode}", *said.splitlines()[:15]]


RUNS_OF_MAIN = (
    (0, ("0.01", "1e-5")),
    (2, ("0",)),
    (2, ("nan",)),
    (2, ("inf", "1e-3")),
    (2, ("1", "1e-300")),
    (2, ("1", "-1")),
    (2, ("1s",)),
    (2, ("",)),
)
"""Exit status and arguments of the example."""


def sanitized(kind: Kind, folder: Path) -> list[str]:
    """Self-check, example and abuse under AddressSanitizer and UndefinedBehaviorSanitizer."""
    example, *others = build(kind, folder, ("main", "check", *ABUSERS), *SANITIZERS, "-DFILL=0xff")
    runs = [*((0, other, ()) for other in others), *((status, example, given) for status, given in RUNS_OF_MAIN)]
    return [line for status, program, given in runs for line in complaint(run(folder, str(program), *given), status)]


def memchecked(kind: Kind, folder: Path) -> list[str]:
    """Self-check and abuse under valgrind, scratch uninitialised."""
    programs = build(kind, folder, ("check", *ABUSERS))
    return [line for p in programs for line in complaint(run(folder, "valgrind", *VALGRIND, str(p)))]
