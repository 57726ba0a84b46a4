"""What predictive control costs on a Cortex-M7: the generated controller in double under QEMU, in closed loop.

python firmware/predictive.py [--record]

Prints a table and writes build/firmware_predictive.csv. Exit status is 1 where a figure is past its limit, 2 where a
tool is missing or a program fails. --record writes the table into TABLE.md.
"""

from __future__ import annotations

import statistics
import sys
from dataclasses import dataclass

import budget_table
from cross import Build, FirmwareError, generate, require, run_on_host, size_of
from emulate import Counter, Findings, read_findings
from outcome import OUT, ROOT, beyond, ended, judged, write_section
from stack import covered_stacks
from targets import HERE, TARGETS, Variant

import screwgen

WORK = OUT / "firmware_predictive"
VARIANT = Variant(TARGETS["m7"], "double", "fused", "runtime")
PROGRAM, IMAGE, FILE = HERE / "target" / "control.c", HERE / "target" / "image.c", HERE / "mpc.toml"
PERIOD, JOINTS = 0.02, 3
"""s between samples, as `FILE` has it; torques at the head of a sample's figures."""
ARMATURE = (1.0, 1.0, 0.4)
"""kg·m²: of the rotors, as in the example `make mpc`."""
CYCLES = (1.0, 1.7)
"""Per instruction: what is assumed where instructions become a clock, see README.md."""
FLASH, RAM, STACK, SAMPLE = 1_048_576, 196_608, 12_288, 6_000_000
"""The most that the controller may take: bytes, and instructions of a sample."""
MISS, APART = 0.05, 1e-6
"""m of the tip from its goal at the end; N·m between torques on the target and on the host."""
TITLE = "Predictive control"


@dataclass(frozen=True)
class Result:
    """Of the controller on the target: bytes, executed instructions, m and N·m."""

    flash: int
    """Of the whole image with controller and joint form."""
    flash_alone: int
    """Of the image without the controller."""
    ram: int
    """Of the image: the controller's memory and that of the joint form."""
    controller: int
    """What of the RAM the controller and its options are."""
    stack: int
    painted: int
    counts: dict[str, list[int]]
    unsolved: int
    iterations: int
    miss: float
    apart: float

    @property
    def samples(self) -> list[int]:
        """Instructions of whole samples, from the second one on: preparation and feedback."""
        return [a + b for a, b in zip(self.counts["preparation"], self.counts["feedback"], strict=True)]

    def clock(self, cycles: float) -> float:
        """MHz at which the longest sample takes `PERIOD`."""
        return max(self.samples) * cycles / PERIOD / 1e6


def example() -> screwgen.Model:
    """ELLA with rotors and two polynomial bending modes per plane and link: 22 states."""
    robot = screwgen.load(ROOT / "examples" / "ella_paper.toml")
    modes, at, links = screwgen.Modes(basis="polynomial", bending_y=2, bending_z=2), 0, []
    for link in robot.links:
        part = slice(at, at := at + len(link.joint.axes))
        joint = link.joint.model_copy(update={"armature": ARMATURE[part]})
        links.append(link.model_copy(update={"modes": modes, "joint": joint}))
    return screwgen.derive(robot.model_copy(update={"links": tuple(links)}))


def apart(found: Findings, reference: Findings) -> float:
    """The largest difference of torques, N·m."""
    pairs = zip(found.samples, reference.samples, strict=True)
    return max(abs(a - b) for x, y in pairs for a, b in zip(x[:JOINTS], y[:JOINTS], strict=True))


def measure() -> Result:
    """Compile for the target and for this machine, run both."""
    require(VARIANT.target)
    sources = generate(example(), WORK / "source", VARIANT.parameters, VARIANT.layout, mpc=FILE)
    build = Build(VARIANT, sources, WORK / VARIANT.name)
    defines = [f'-DMPC_HEADER="{sources.name}_mpc.h"', "-DPAYLOAD=links[1].bodies[0].mass"]
    alone, whole = size_of(build, build.image(False)), size_of(build, build.link("mpc", IMAGE, False, *defines))
    program = build.link("control", PROGRAM, True, *defines)
    found = Counter(WORK / "counter").run(build, program)
    turns = {f"{sources.name}_daqp_remove_constraint": found.figures["active"]}
    stacks = covered_stacks(build, program, found.stacks, turns)
    reference = read_findings(run_on_host(sources, WORK, PROGRAM, "-O1", *defines))
    figures, controller = found.figures, found.sizes["mpc"] + found.sizes["mpc_options"]
    return Result(
        whole.flash, alone.flash, whole.ram, controller, max(stacks.values()), max(found.stacks.values()), found.counts,
        figures["unsolved"], figures["iterations"], 1e-9 * figures["miss"], apart(found, reference),
    )  # fmt: skip


def rows(r: Result) -> list[tuple[str, str]]:
    """What is measured, and its figure."""

    def spread(numbers: list[int]) -> str:
        return f"{statistics.median(numbers):,.0f} in the median, {max(numbers):,} at most"

    clocks = "; ".join(f"{r.clock(c):,.0f} MHz at {c:g} cycles per instruction" for c in CYCLES)
    return [
        ("flash: image with the controller", f"{r.flash:,} B"),
        ("flash: image without", f"{r.flash_alone:,} B"),
        ("RAM: .data and .bss of the image", f"{r.ram:,} B"),
        ("RAM: controller and options of it", f"{r.controller:,} B"),
        ("stack: worst", f"{r.stack:,} B"),
        ("stack: painted", f"{r.painted:,} B"),
        ("instructions: cold start", f"{max(r.counts['start']):,}"),
        ("instructions: preparation", spread(r.counts["preparation"])),
        ("instructions: feedback", spread(r.counts["feedback"])),
        ("instructions: sample", spread(r.samples)),
        (f"clock for a sample in {1e3 * PERIOD:.0f} ms", clocks),
        ("iterations of the quadratic program", f"{r.iterations} at most"),
        ("torques beside those of this machine", f"{r.apart:.1e} N·m apart at most"),
        ("tip from its goal at the end", f"{1e3 * r.miss:.1f} mm"),
    ]


HEAD = f"Cortex-M7, double, ELLA with 22 states, {FILE.name}: six intervals of 20 ms, a wrench bound"


def text(r: Result) -> str:
    return "\n".join([HEAD, *(f"{name:40} {value}" for name, value in rows(r))])


def record(r: Result) -> None:
    """The section of TABLE.md."""
    write_section(budget_table.TABLE, TITLE, HEAD, rows(r))


def columns(r: Result) -> dict[str, object]:
    """The row of the CSV."""
    row: dict[str, object] = {
        "flash": r.flash,
        "flash_alone": r.flash_alone,
        "ram": r.ram,
        "controller": r.controller,
        "stack": r.stack,
    }
    for name, numbers in (r.counts | {"sample": r.samples}).items():
        row |= {name: statistics.median(numbers), f"{name}_max": max(numbers)}
    return row | {"unsolved": r.unsolved, "iterations": r.iterations, "miss": r.miss, "apart": r.apart}


def failures(r: Result) -> list[str]:
    """What is beyond its limit."""
    out = []
    if r.unsolved:
        out.append(f"{r.unsolved} samples had no solution")
    if not r.miss < MISS:
        out.append(f"the tip ends {1e3 * r.miss:.1f} mm from its goal, the limit is {1e3 * MISS:.0f} mm")
    if not r.apart < APART:
        out.append(f"torques on the target and on this machine are {r.apart:.1e} N·m apart, the limit is {APART:.0e}")
    taken = {"flash": (r.flash, FLASH), "RAM": (r.ram, RAM), "stack": (r.stack, STACK)}
    taken |= {"sample": (max(r.samples), SAMPLE)}
    return out + beyond(taken)


def main(arguments: list[str]) -> int:
    if arguments not in ([], ["--record"]):
        raise FirmwareError("predictive.py takes --record or nothing")
    result = measure()
    if arguments:
        record(result)
    return judged(text(result), "firmware_predictive", columns(result), failures(result))


if __name__ == "__main__":
    ended(lambda: main(sys.argv[1:]))
