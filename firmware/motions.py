"""What a plan and a feedforward cost on a Cortex-M7: the generated C in double under QEMU, at every millisecond.

python firmware/motions.py [--record]

Prints a table and writes build/firmware_motions.csv. Exit status is 1 where a figure is past its limit, 2 where a tool
is missing or a program fails. --record writes the table into TABLE.md.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass

import budget_table
import numpy as np
from cross import Build, FirmwareError, Sources, require, size_of
from emulate import Counter
from outcome import OUT, beyond, ended, judged, write_section
from predictive import example
from stack import covered_stacks
from targets import HERE, TARGETS, Variant

import screwgen
from screwgen.target_files import feedforward_files

WORK = OUT / "firmware_motions"
VARIANT = Variant(TARGETS["m7"], "double", "fused", "runtime")
PROGRAM = HERE / "target" / "motions.c"
GOAL, TIME, STEP, SHOWN = (-0.5, 0.7, 0.45), 1.2, 1e-3, 20
"""rad, s: of the plan; s between samples, and how many of these lie between two that the program prints."""
FLASH, RAM, STACK, PLAN, FEEDFORWARD = 131_072, 32_768, 8_192, 5_000, 100_000
"""The most that they may take: bytes, and instructions of a sample."""
APART = 1e-12
"""Between numbers on the target and in Python, over the largest."""
TITLE = "Plans and feedforward"


class MotionSources(Sources):
    """A plan's C and a feedforward's in one folder."""

    @property
    def defines(self) -> list[str]:
        return [f"-I{self.folder}"]


@dataclass(frozen=True)
class Result:
    """Of plan and feedforward on the target: bytes, executed instructions, relative differences."""

    flash_plan: int
    """Of the image with the plan alone."""
    flash: int
    """Of the image with both."""
    sizes: dict[str, int]
    stacks: dict[str, int]
    counts: dict[str, list[int]]
    apart: float

    @property
    def ram(self) -> int:
        """The structs of the caller."""
        return sum(self.sizes.values())


def generate() -> tuple[Sources, np.ndarray]:
    """The C of both, and what Python has for the samples that the program prints."""
    model = example()
    plan = screwgen.plan(model, [0.0] * 3, GOAL, TIME)
    folder = WORK / "source"
    folder.mkdir(parents=True, exist_ok=True)
    files = feedforward_files(model, parameters=VARIANT.parameters, layout=VARIANT.layout, methods=())
    for name, data in (files | {name: text.encode() for name, text in plan.c().items()}).items():
        (folder / name).write_bytes(data)
    t = STEP * np.arange(round(TIME / STEP) + 1)
    q, v = plan.reference(t)
    rows = np.hstack([q, v, plan.mean_torque(t, t + STEP)])[SHOWN::SHOWN]
    efforts = screwgen.feedforward(model, q, v, STEP).tau[SHOWN - 1 :: SHOWN]
    return MotionSources(model.robot.name, folder), np.hstack([rows, efforts])


def measure() -> Result:
    """Compile for the target, run there, compare with Python."""
    require(VARIANT.target)
    sources, wanted = generate()
    build = Build(VARIANT, sources, WORK / VARIANT.name)
    alone, whole = (
        size_of(build, build.link(name, PROGRAM, False, *flags))
        for name, flags in (("plan", ["-DPLAN_ALONE"]), ("both", []))
    )
    program = build.link("motions", PROGRAM, True)
    found = Counter(WORK / "counter").run(build, program)
    stacks = covered_stacks(build, program, found.stacks)
    off = np.abs(np.array(found.samples) - wanted).max(axis=0) / np.abs(wanted).max(axis=0)
    return Result(alone.flash, whole.flash, found.sizes, stacks, found.counts, float(off.max()))


def rows(r: Result) -> list[tuple[str, str]]:
    """What is measured, and its figure."""
    parts = (("plan", "plan"), ("feedforward", "feedforward"))
    return [
        ("flash: image with the plan", f"{r.flash_plan:,} B"),
        ("flash: image with plan and feedforward", f"{r.flash:,} B"),
        ("RAM: structs of the plan", f"{r.sizes['plan']:,} B"),
        ("RAM: structs of the feedforward", f"{r.ram - r.sizes['plan']:,} B"),
        *((f"stack: {name}", f"{r.stacks[call]:,} B") for name, call in (("plan", "plan_sample"), parts[1])),
        *((f"instructions: sample of the {name}", f"{max(r.counts[call]):,} at most") for name, call in parts),
        ("beside Python, over the largest", f"{r.apart:.0e}"),
    ]


HEAD = "Cortex-M7, double, ELLA with 22 states, a plan of 24 intervals in 1.2 s, a sample every millisecond"


def text(r: Result) -> str:
    return "\n".join([HEAD, *(f"{name:40} {value}" for name, value in rows(r))])


def columns(r: Result) -> dict[str, object]:
    """The row of the CSV."""
    row: dict[str, object] = {"flash_plan": r.flash_plan, "flash": r.flash, "ram": r.ram}
    row |= {f"stack_{name}": x for name, x in r.stacks.items()}
    return row | {name: max(numbers) for name, numbers in r.counts.items()} | {"apart": r.apart}


def failures(r: Result) -> list[str]:
    """What is beyond its limit."""
    out = [] if r.apart < APART else [f"numbers on the target and in Python are {r.apart:.1e} apart"]
    taken = {"flash": (r.flash, FLASH), "RAM": (r.ram, RAM), "stack": (max(r.stacks.values()), STACK)}
    taken |= {name: (max(r.counts[name]), most) for name, most in (("plan", PLAN), ("feedforward", FEEDFORWARD))}
    return out + beyond(taken)


def main(arguments: list[str]) -> int:
    if arguments not in ([], ["--record"]):
        raise FirmwareError("motions.py takes --record or nothing")
    result = measure()
    if arguments:
        write_section(budget_table.TABLE, TITLE, HEAD, rows(result))
    return judged(text(result), "firmware_motions", columns(result), failures(result))


if __name__ == "__main__":
    ended(lambda: main(sys.argv[1:]))
