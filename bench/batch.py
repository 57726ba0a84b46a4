"""The batch beside the scalar step of the same C with the same flags: nanoseconds per scenario and step, and ratios.

    python bench/batch.py [ROBOT.toml]... [--rounds N] [--flags "-O2 -march=native"]... [--openmp]

Rounds are interleaved, a ratio is the median of the rounds' ratios; with --openmp the time is the clock's.
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

import robots  # noqa: E402

import screwgen  # noqa: E402

FLAGS = ("-O2 -mavx2", "-O2 -march=native", "-O2 -march=native -ffp-contract=fast", "-O2 -march=native -DFLOAT")
SOURCES = ("real", "parameters", "dynamics", "links", "step", "batch")


def number(value: float, digits: int) -> str:
    return f"{value:.{digits}f}"


def aligned(lines: list[list[str]], left: int) -> str:
    """Columns of equal width, the first ``left`` of them flush left, the others right; the first line is the head."""
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    lines = [lines[0], ["-" * w for w in widths], *lines[1:]]
    cells = [
        [x.ljust(w) if i < left else x.rjust(w) for i, (x, w) in enumerate(zip(y, widths, strict=True))] for y in lines
    ]
    return "\n".join("  ".join(line).rstrip() for line in cells)


def write(robot: str, folder: Path) -> str:
    """The C of a robot of the bench, or of a file, with its batch; returns the robot's name."""
    model = screwgen.derive(screwgen.load(robot) if robot.endswith(".toml") else robots.example(robot))
    for file, data in model.c_files(batch=True).items():
        (folder / file).write_bytes(data)
    return model.robot.name


def times(name: str, folder: Path, flags: list[str], rounds: int, clock: str) -> dict[str, list[tuple[float, float]]]:
    """Per method and round the nanoseconds of the scalar step and of the batch."""
    upper = name.upper()
    flags = [f"-D{upper}_REAL_FLOAT" if f == "-DFLOAT" else f for f in flags]
    defines = [f"-DROBOT={name}", f"-DROBOT_UPPER={upper}", f'-DBATCH_HEADER="{name}_batch.h"', f"-DCLOCK={clock}"]
    sources = [HERE / "batch_driver.c", *(f"{name}_{part}.c" for part in SOURCES)]
    command = ["gcc", "-std=c99", *flags, *defines, "-I.", *sources, "-o", "driver", "-lm"]
    subprocess.run([str(c) for c in command], cwd=folder, check=True)
    out = defaultdict(list)
    said = subprocess.run([folder / "driver", str(rounds)], check=True, capture_output=True, text=True).stdout
    for method, one, many in (line.split() for line in said.splitlines()):
        out[method].append((float(one), float(many)))
    return out


def rows(name: str, flags: str, found: dict[str, list[tuple[float, float]]]) -> list[list[str]]:
    """The table's lines of one robot and set of flags."""
    out = []
    for method, pairs in found.items():
        one, many = (statistics.median(p[k] for p in pairs) for k in (0, 1))
        ratios = sorted(a / b for a, b in pairs)
        spread = f"{number(ratios[len(ratios) // 10], 2)} to {number(ratios[-1 - len(ratios) // 10], 2)}"
        out.append([name, method, flags, number(one, 0), number(many, 0), number(statistics.median(ratios), 2), spread])
    return out


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("robot", nargs="*", default=["ella", "six_link"])
    parser.add_argument("--rounds", type=int, default=61)
    parser.add_argument("--flags", action="append")
    parser.add_argument("--openmp", action="store_true")
    given = parser.parse_args()
    extra, clock = (" -fopenmp", "CLOCK_MONOTONIC") if given.openmp else ("", "CLOCK_THREAD_CPUTIME_ID")
    table = [["robot", "method", "flags", "scalar ns", "batch ns", "ratio", "80 % of rounds"]]
    for robot in given.robot:
        with tempfile.TemporaryDirectory(prefix="screwgen-") as place:
            name = write(robot, Path(place))
            for flags in (f + extra for f in given.flags or FLAGS):
                table += rows(name, flags, times(name, Path(place), flags.split(), given.rounds, clock))
    print(aligned(table, 3))


if __name__ == "__main__":
    main()
