"""Speed of the generated C against CasADi's own C for the same function with the same inputs, in one run.

python bench/bench.py [--quick] [--check] [--robots ella,six_link] [--rounds N]

Prints tables and writes build/bench.csv. The ratio columns are screwgen / CasADi: at most 1 is the claim, and with
--check the exit status says whether it holds for ELLA. Needs a C compiler (CC, else cc) and GNU binutils; instructions
are counted where valgrind is installed.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import shutil
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

import casadi as ca
import contenders as cs
import robots
from native import COUNTABLE, LEVELS, PROCESSES, BenchError, Program
from report import Progress, aligned, number

import screwgen

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build"
CLAIM = ("ella", "fused", "casadi")
COMPARISONS = (
    ("constants given", "fused", ("casadi", "casadi_cse", "casadi_short")),
    ("constants given, modular", "modular", ("casadi",)),
    ("from parameters", "prepare", ("casadi_p", "casadi_p_cse")),
    ("parameters baked in", "baked", ("casadi_baked", "casadi_baked_cse", "casadi_baked_short")),
    ("constants given, float", "float", ("casadi_float",)),
)
BATCH = 3e-4
NOTES = """\
fused, modular: the generated forward_dynamics in that layout, status and checks for non-finite numbers included.
CasADi: Function.generate with its defaults for the same equations, inputs and outputs; cse: after casadi.cse;
short series: cse, and the Stumpff functions replaced by the few terms that these states need, so that it is
wrong for large angles; from p: the preparation of the constants included."""


@dataclass
class Results:
    """What was measured of one robot."""

    name: str
    contenders: list[cs.Contender]
    levels: tuple[str, ...]
    times: dict[str, list[float]] = field(default_factory=dict)
    counts: dict[str, float] = field(default_factory=dict)
    sizes: dict[tuple[str, str], int] = field(default_factory=dict)
    generation: dict[str, float] = field(default_factory=dict)
    deviation: float = 0.0

    def time(self, name: str, level: str) -> float:
        return statistics.median(self.times[f"{name}_{level}"])

    def time_ratio(self, ours: str, theirs: str, level: str) -> float:
        """The median over the rounds of the ratio within a round."""
        pairs = zip(self.times[f"{ours}_{level}"], self.times[f"{theirs}_{level}"], strict=True)
        return statistics.median(a / b for a, b in pairs)

    def count(self, name: str, level: str) -> float | None:
        return self.counts.get(f"{name}_{level}")

    def count_ratio(self, ours: str, theirs: str, level: str) -> float | None:
        a, b = self.count(ours, level), self.count(theirs, level)
        return None if a is None or b is None else a / b


# ------------------------------------------------------------------------------------------- measuring


def measure(name: str, levels: tuple[str, ...], rounds: int, compiler: str, progress: Progress) -> Results:
    """Everything about one robot."""
    progress.stage(f"{name}: derivation and generation")
    command = [sys.executable, Path(__file__).with_name("generation.py"), name]
    generation = subprocess.run(command, capture_output=True, text=True)
    if generation.returncode:
        raise BenchError(f"generating {name} failed: {generation.stderr.strip().splitlines()[-1:]}")
    model = screwgen.derive(robots.robot(name))
    contenders = cs.contenders(model) + (cs.step_contenders(model) if name == "ella" else [])
    program = Program(BUILD / "bench" / name, contenders, levels, compiler)
    progress.stage(f"{name}: compiling", program.jobs())
    program.build(cs.data_header(model), progress.step)
    out = Results(name, contenders, levels, generation=json.loads(generation.stdout))
    out.deviation = program.verify()
    progress.stage(f"{name}: counting instructions")
    out.counts = program.instructions(cs.STATES)
    progress.stage(f"{name}: timing", PROCESSES)
    out.times = program.times(rounds, BATCH, progress.step)
    out.sizes = {(c.name, x): program.text_size(c.library, x) for c in contenders for x in levels}
    progress.stage("")
    return out


# --------------------------------------------------------------------------------------------- tables


def is_step(c: cs.Contender) -> bool:
    return "step_" in c.name


def heads(levels: tuple[str, ...], *quantities: str) -> list[str]:
    """The heads of columns per level; instructions are not counted at every level."""
    return [f"{x} {what}" for x in levels for what in quantities if what != "instr" or x in COUNTABLE]


def speed_table(results: list[Results]) -> str:
    """One line per contender: operations, and per level bytes of code, nanoseconds and instructions."""
    lines = [["robot", "contender", "operations", *heads(results[0].levels, "bytes", "ns", "instr")]]
    for r in results:
        for c in r.contenders:
            if not is_step(c):
                lines.append([r.name, c.title + given(c), str(c.library.operations), *cells(r, c)])
    return aligned(lines, left=2)


def step_table(r: Results) -> str:
    """One line per integrator and form."""
    lines = [["step", *heads(r.levels, "ns", "instr")]]
    lines += [[c.title, *cells(r, c)] for c in r.contenders if is_step(c)]
    return aligned(lines, left=1)


def given(c: cs.Contender) -> str:
    """What a CasADi function is given besides state and input."""
    if not c.title.startswith("CasADi"):
        return ""
    return ", from p" if "_p" in c.name else ", baked" if "baked" in c.name else ""


def cells(r: Results, c: cs.Contender) -> list[str]:
    out = []
    for x in r.levels:
        out += [] if is_step(c) else [str(r.sizes[c.name, x])]
        out.append(number(r.time(c.name, x), 0))
        out += [number(r.count(c.name, x), 0)] if x in COUNTABLE else []
    return out


def ratio_table(results: list[Results]) -> str:
    """One line per comparison: time and instruction ratios per level."""
    levels = results[0].levels
    lines = [["robot", "the same function", "screwgen", "over", *heads(levels, "time", "instr")]]
    for r in results:
        titles = {c.name: c.title for c in r.contenders}
        for what, ours, opponents in COMPARISONS:
            for theirs in opponents:
                row = [r.name, what, titles[ours].removeprefix("screwgen, "), titles[theirs]]
                for x in levels:
                    row.append(number(r.time_ratio(ours, theirs, x), 3))
                    row += [number(r.count_ratio(ours, theirs, x), 3)] if x in COUNTABLE else []
                lines.append(row)
    return aligned(lines, left=4)


def generation_table(results: list[Results]) -> str:
    lines = [["robot", *results[0].generation]]
    lines += [[r.name, *(number(s, 2) for s in r.generation.values())] for r in results]
    return aligned(lines, left=1)


def write_csv(results: list[Results], path: Path) -> None:
    """Everything in long form: robot, contender, opponent, level, quantity, value."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="") as stream:
        out = csv.writer(stream)
        out.writerow(["robot", "contender", "opponent", "level", "quantity", "value"])
        for r in results:
            out.writerows([r.name, "", "", "", f"seconds: {k}", f"{v:.3f}"] for k, v in r.generation.items())
            for c in r.contenders:
                out.writerow([r.name, c.name, "", "", "operations", c.library.operations])
                for x in r.levels:
                    out.writerow([r.name, c.name, "", x, "bytes", r.sizes[c.name, x]])
                    out.writerow([r.name, c.name, "", x, "nanoseconds", f"{r.time(c.name, x):.2f}"])
                    if (count := r.count(c.name, x)) is not None:
                        out.writerow([r.name, c.name, "", x, "instructions", count])
            for _, ours, opponents in COMPARISONS:
                for theirs in opponents:
                    for x in r.levels:
                        out.writerow([r.name, ours, theirs, x, "time ratio", f"{r.time_ratio(ours, theirs, x):.4f}"])
                        if (ratio := r.count_ratio(ours, theirs, x)) is not None:
                            out.writerow([r.name, ours, theirs, x, "instruction ratio", f"{ratio:.4f}"])


def claim(results: list[Results]) -> tuple[bool, str]:
    """Whether the generated C of ELLA is no slower than CasADi's, and the sentence that says so."""
    robot, ours, theirs = CLAIM
    found = [r for r in results if r.name == robot]
    if not found:
        return True, "The claim is about ELLA, which was not run."
    ratios = {x: found[0].time_ratio(ours, theirs, x) for x in COUNTABLE}
    holds = all(ratio <= 1 for ratio in ratios.values())
    said = ", ".join(f"{ratio:.3f} at -{x}" for x, ratio in ratios.items())
    verdict = "holds" if holds else "DOES NOT HOLD"
    return holds, f"Claim, ELLA's forward dynamics no slower than CasADi's C: {verdict} ({said})."


# ------------------------------------------------------------------------------------------------ main


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="ELLA, no -march=native, fewer rounds: under a minute")
    parser.add_argument("--check", action="store_true", help="exit with status 1 if the claim does not hold")
    parser.add_argument("--robots", help=f"some of {','.join(robots.NAMES)}")
    parser.add_argument("--rounds", type=int, help="rounds of timing, at least 15")
    given = parser.parse_args()
    given.robots = tuple((given.robots or ("ella" if given.quick else ",".join(robots.NAMES))).split(","))
    given.rounds = given.rounds or (33 if given.quick else 110)
    if unknown := [x for x in given.robots if x not in robots.NAMES]:
        parser.error(f"there is no robot '{unknown[0]}'; choose from {', '.join(robots.NAMES)}")
    if given.rounds < 15:
        parser.error("a median needs at least 15 rounds")
    return given


def main() -> int:
    options, clock = arguments(), time.perf_counter()
    levels = COUNTABLE if options.quick else tuple(LEVELS)
    compiler = os.environ.get("CC") or "cc"
    missing = [tool for tool in (compiler, "objcopy", "size") if not shutil.which(tool)]
    if missing:
        sys.exit(f"bench: there is no '{missing[0]}'; install a C compiler and GNU binutils, or set CC")
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True).stdout.splitlines()[0]
    print(f"screwgen {screwgen.__version__}, CasADi {ca.__version__}, {version}")
    print("; ".join(f"{x}: -std=c99 {' '.join(flags)}" for x, flags in LEVELS.items() if x in levels))
    progress = Progress()
    try:
        results = [measure(x, levels, options.rounds, compiler, progress) for x in options.robots]
    except BenchError as error:
        sys.exit(f"bench: {error}")
    print(f"\nForward dynamics, median of {options.rounds} rounds in {PROCESSES} processes; bytes: what it needs\n")
    print(speed_table(results), NOTES, sep="\n\n")
    print("\nscrewgen / CasADi, median of the ratios within the rounds\n\n" + ratio_table(results))
    if "ella" in options.robots:
        print(f"\nOne step of {cs.TIME_STEP * 1e3:g} ms, fused layout, runtime parameters\n")
        print(step_table(results[options.robots.index("ella")]))
    print("\nSeconds from robot to files, nothing derived before\n\n" + generation_table(results))
    if not all(r.counts for r in results):
        print("\nNo instruction counts: valgrind is not installed.")
    write_csv(results, BUILD / "bench.csv")
    worst = max(r.deviation for r in results)
    holds, sentence = claim(results)
    seconds = time.perf_counter() - clock
    print(f"\nAll contenders agree within {worst:.1e}. {seconds:.0f} s; the numbers are in build/bench.csv.")
    print(sentence)
    return 1 if options.check and not holds else 0


if __name__ == "__main__":
    sys.exit(main())
