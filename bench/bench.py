"""Speed of the generated C against what else computes the same, in one run and one table.

python bench/bench.py [--quick] [--check] [--level O2|O3|native] [--rounds N] [--groups ella,links] [--out FOLDER]

Every row is a time and its ratio to another row of its group, as the group's heading says. Contenders of a group run in
turns in one process; times are medians of rounds in processes of their own, with the spread. Writes bench.csv,
bench.md and bench.png. --check: exit with status 1 where a ratio misses its target. Needs a C compiler (CC, else cc)
and GNU binutils; what else is missing costs rows, and the run says which.
"""

from __future__ import annotations

import argparse
import os
import shutil
import statistics
import sys
import time
from functools import partial
from pathlib import Path

import casadi as ca
import derivation
import groups as gs
import pendulum
import python_calls
from contenders import STATES, Missing
from native import LEVELS, PEAK, PROCESSES, BenchError, Compiler, Program
from plot import draw, short
from report import Progress
from table import Row, bounds, markdown, printed, significant, spread, write_csv

import screwgen

ROOT = Path(__file__).resolve().parents[1]
BATCH = 3e-4
NOTES = """\
ops: operations of straight-line code; multiplications, additions, divisions and calls of libm count
alike. instr: executed instructions, by callgrind. KiB: code and constants of the function, without
libm. ±: half the distance between the quartiles over the median. peak: operations per second over
the machine's rate of scalar multiplications and additions, measured in the same processes.
All C is compiled with the flags of the title. screwgen's source has GCC compile the dynamics for
processors with AVX too, and that runs where there is one (KiB counts it alone); the rows -mavx
give it to CasADi's C by a flag. screwgen's functions also check for numbers that are not finite
and return a status. Where wrenches are said, and against CasADi's C of the same function, joint
wrenches and tip pose are included."""
MEDIANS = "the same function in CasADi's C, all robots above; ratio: median of their ratios"


def measure(group: gs.Group, program: Program, rounds: int, progress: Progress) -> tuple[list[Row], float]:
    """The rows of a group, and the largest deviation between its contenders."""
    progress.stage(f"{group.name}: compiling", program.jobs())
    program.build(group.data, progress.step)
    deviation = program.verify()
    progress.stage(f"{group.name}: counting instructions")
    counts = program.instructions(STATES)
    progress.stage(f"{group.name}: timing", PROCESSES)
    times = program.times(rounds, BATCH, progress.step)
    rate = PEAK.library.operations / statistics.median(times[PEAK.name])
    per = {c.name: c.per for c in program.contenders}
    rows = []
    for c in group.contenders:
        mine, base = times[c.name], times[c.against]
        scale = per[c.against] / c.per
        ns, count = statistics.median(mine), c.library.operations if "step" not in c.name else None
        ratio = statistics.median(a / b for a, b in zip(mine, base, strict=True)) * scale
        row = Row(group.heading, c.title, ns * 1e-9, ratio, spread(mine), c.target, count, counts.get(c.name))
        row.bytes = program.text_size(c)
        row.peak = count / ns / rate if count else None
        if c.name in counts and c.against in counts:
            row.instruction_ratio = counts[c.name] / counts[c.against] * scale
        rows.append(row)
    return rows, deviation


def same_function_medians(rows: list[Row]) -> list[Row]:
    """One row per source of the constants: the median of CasADi's ratios over all robots."""
    out, more = [], [f", {robot}" for robot in gs.MORE]
    for title, kinds, bound in (
        ("CasADi, constants as inputs", ("CasADi", *(f"CasADi{r}" for r in more)), 1.2),
        (gs.AVX, (gs.AVX, *(f"{gs.AVX}{r}" for r in more)), None),
        (gs.FROM_PARAMETERS, (gs.FROM_PARAMETERS, *(f"{gs.FROM_PARAMETERS}{r}" for r in more)), 1.2),
        ("CasADi, baked", ("CasADi, baked / baked", "CasADi, baked, cse / baked"), None),
    ):
        found = [row for row in rows if row.title in kinds]
        if found:
            target = (bound, None)
            ratio = statistics.median(row.ratio for row in found)
            out.append(Row(MEDIANS, title, statistics.median(row.seconds for row in found), ratio, target=target))
    return out


def run(options: argparse.Namespace, progress: Progress) -> tuple[list[Row], list[str], float]:
    """All rows, one line per missing contender or failed group, and the largest deviation."""
    rows, missing, worst = [], [], 0.0
    compiler = Compiler(os.environ.get("CC") or "cc", options.level, options.out / "store")

    def native(make) -> tuple[list[Row], list[str]]:
        nonlocal worst
        group = make()
        program = Program(options.out / group.name, group.contenders, compiler)
        found, deviation = measure(group, program, options.rounds, progress)
        worst = max(worst, deviation)
        return found, [f"{group.name}: no row '{title}': {reason}" for title, reason in group.missing]

    jobs = {name: partial(native, make) for name, make in gs.groups(options.quick, compiler.store, options.level)}
    jobs["medians"] = lambda: (same_function_medians(rows), [])
    others = (("pendulum", pendulum.rows), ("derivation", derivation.rows), ("python", python_calls.rows))
    for name, make in others:
        if not options.quick:
            jobs[name] = partial(make, options.out / name, compiler, progress)
    if unknown := [name for name in options.groups or () if name not in jobs]:
        sys.exit(f"bench: there is no group '{unknown[0]}'; choose {', '.join(jobs)}")
    for name, job in jobs.items():
        if options.groups is None or name in (*options.groups, "medians"):
            progress.stage(f"{name}: deriving and generating")
            try:
                found, lines = job()
            except (BenchError, Missing) as error:
                found, lines = [], [f"{name}: FAILED: {error}"]
            rows, missing = rows + found, missing + lines
    progress.stage("")
    return rows, missing, worst


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="two robots, few rounds: half a minute")
    parser.add_argument("--check", action="store_true", help="exit with status 1 if a ratio misses its target")
    parser.add_argument("--level", choices=tuple(LEVELS), default="O3", help="optimisation of all C, O3")
    parser.add_argument("--rounds", type=int, help="rounds of timing, at least 15")
    parser.add_argument("--groups", help="some of them, as ella,links,modes,steps,pendulum,derivation,python")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "bench", help="folder of the results")
    given = parser.parse_args()
    given.groups = given.groups and tuple(given.groups.split(","))
    given.rounds = given.rounds or (33 if given.quick else 110)
    given.out = given.out.resolve()
    if given.rounds < 15:
        parser.error("a median needs at least 15 rounds")
    return given


def main() -> int:
    options, clock = arguments(), time.perf_counter()
    compiler = os.environ.get("CC") or "cc"
    missing = [tool for tool in (compiler, "objcopy", "size") if not shutil.which(tool)]
    if missing:
        sys.exit(f"bench: there is no '{missing[0]}'; install a C compiler and GNU binutils, or set CC")
    options.out.mkdir(parents=True, exist_ok=True)
    progress = Progress()
    try:
        version = Compiler(compiler, options.level, options.out).version
        rows, absent, worst = run(options, progress)
    except (BenchError, Missing) as error:
        sys.exit(f"bench: {error}")
    title = f"screwgen {screwgen.__version__}, CasADi {ca.__version__}, {version}, {' '.join(LEVELS[options.level])}"
    print(title, "", printed(rows), "", NOTES, sep="\n")
    if not shutil.which("valgrind"):
        absent.append("no column 'instr': valgrind is not installed")
    print("\n".join(["", *absent]) if absent else "")
    write_csv(rows, options.out / "bench.csv")
    text = [f"# {title}", "", markdown(rows), NOTES, "", *(f"- {line}" for line in absent)]
    (options.out / "bench.md").write_text("\n".join(text) + "\n", encoding="utf-8")
    draw(rows, options.out / "bench.png")
    missed = [row for row in rows if row.met is False]
    kept = sum(row.met is True for row in rows)
    seconds = time.perf_counter() - clock
    agree = f"Contenders agree within {worst:.1e}; " if worst else ""
    print(f"{agree}{kept} targets met, {len(missed)} missed; {seconds:.0f} s.")
    for row in missed:
        print(f"missed: {short(row.group)}: {row.title}: {significant(row.ratio)}, {bounds(row.target)}")
    print(f"bench.csv, bench.md and bench.png are in {os.path.relpath(options.out)}")
    failed = any(": FAILED: " in line for line in absent)
    return 1 if failed or (options.check and missed) else 0


if __name__ == "__main__":
    sys.exit(main())
