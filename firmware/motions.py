"""What motions cost on a Cortex-M7: the generated C of a plan, a feedforward, a shaper, joint gains and a law with its
filter, in double under QEMU, at every millisecond.

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
from screwgen.planning.task import JointLaw
from screwgen.target_files import feedforward_files

WORK = OUT / "firmware_motions"
VARIANT = Variant(TARGETS["m7"], "double", "fused", "runtime")
PROGRAM = HERE / "target" / "motions.c"
GOAL, TIME, STEP, SHOWN = (-0.5, 0.7, 0.45), 1.2, 1e-3, 20
"""rad, s: of the plan; s between samples, and how many of these lie between two that the program prints."""
SWEEP, GRID, LOAD = (1.2, 1.2, 1.2), {"forearm.joint[0]": (-1.2, 1.2), "forearm.bodies[0].mass": (0.7, 1.3)}, 1.1
"""rad: how far joints turn, either way, where the shaper is used; the law's grid, and the load that it is told."""
FLASH, RAM, STACK = 131_072, 32_768, 8_192
"""The most bytes that they may take."""
INSTRUCTIONS = {"plan": 5_000, "feedforward": 100_000, "shaper": 20_000, "gains": 1_000, "law": 50_000}
"""The most of a sample."""
CALLS = {"plan": "plan_sample", "feedforward": "feedforward", "shaper": "shaper_sample"}
CALLS |= {"gains": "law_sample", "law": "lqg_sample"}
"""What is called at a sample, without the robot's name."""
APART = 1e-12
"""Between numbers on the target and in Python, over the largest."""
TITLE = "Plans, feedforward, shapers, gains and laws"


class MotionSources(Sources):
    """The C of all parts in one folder."""

    @property
    def defines(self) -> list[str]:
        return [f"-I{self.folder}"]


@dataclass(frozen=True)
class Result:
    """Of all parts on the target, by their names: bytes, executed instructions of samples; relative differences."""

    flash: dict[str, int]
    """Of the image with the plan and this part; that of the plan has nothing else."""
    sizes: dict[str, int]
    """Of the structs of the caller."""
    stacks: dict[str, int]
    counts: dict[str, list[int]]
    apart: float


def generate() -> tuple[Sources, np.ndarray]:
    """The C of all parts, and what Python has for the samples that the program prints."""
    model = example()
    plan = screwgen.plan(model, [0.0] * 3, GOAL, TIME)
    shaper = screwgen.shape(model, np.negative(SWEEP), SWEEP)
    gains, law = screwgen.gains(model, [[0.0] * 3]), screwgen.lqg(model, GRID, step=STEP)
    folder = WORK / "source"
    folder.mkdir(parents=True, exist_ok=True)
    files = feedforward_files(model, parameters=VARIANT.parameters, layout=VARIANT.layout, methods=())
    for name, text in (plan.c() | shaper.c(STEP) | gains.c() | law.c()).items():
        files[name] = text.encode()
    for name, data in files.items():
        (folder / name).write_bytes(data)
    t = STEP * np.arange(round(TIME / STEP) + 1)
    q, v = plan.reference(t)
    ring, memory = shaper.sampled(STEP), law.start(q[0], (LOAD,))
    ring.start(q[0])
    shaped, shaped_rates = np.array([ring(x, y, x) for x, y in zip(q[1:], v[1:], strict=True)]).transpose(1, 0, 2)
    efforts = np.array(
        [law.sample(memory, x, r, np.zeros(3), (LOAD,), np.zeros(3)) for x, r in zip(q[1:], shaped, strict=True)]
    )
    ahead = screwgen.feedforward(model, q, v, STEP).tau
    planned = np.hstack([q, v, plan.mean_torque(t, t + STEP)])[1:]
    held = planned[:, 6:] + JointLaw(gains.kp, gains.kd).torques((shaped - q[1:]).T, (shaped_rates - v[1:]).T).T
    wanted = np.hstack([planned, ahead, shaped, shaped_rates, held, efforts])[SHOWN - 1 :: SHOWN]
    return MotionSources(model.robot.name, folder), wanted


def measure() -> Result:
    """Compile for the target, run there, compare with Python."""
    require(VARIANT.target)
    sources, wanted = generate()
    build = Build(VARIANT, sources, WORK / VARIANT.name)
    flash = {}
    for name in INSTRUCTIONS:
        more = [] if name == "plan" else [f"-D{name.upper()}"]
        flash[name] = size_of(build, build.link(name, PROGRAM, False, *more)).flash
    program = build.link("motions", PROGRAM, True)
    found = Counter(WORK / "counter").run(build, program)
    deepest = covered_stacks(build, program, found.stacks)
    stacks = {name: deepest[call] for name, call in CALLS.items()}
    off = np.abs(np.array(found.samples) - wanted).max(axis=0) / np.abs(wanted).max(axis=0)
    return Result(flash, found.sizes, stacks, found.counts, float(off.max()))


def rows(r: Result) -> list[tuple[str, str]]:
    """What is measured, and its figure."""
    kinds = {"RAM: structs of the": r.sizes, "stack: sample of the": r.stacks}
    return [
        ("flash: image with the plan", f"{r.flash['plan']:,} B"),
        *((f"flash: image with plan and {x}", f"{n:,} B") for x, n in r.flash.items() if x != "plan"),
        *((f"{kind} {name}", f"{found[name]:,} B") for kind, found in kinds.items() for name in INSTRUCTIONS),
        *((f"instructions: sample of the {name}", f"{max(r.counts[name]):,} at most") for name in INSTRUCTIONS),
        ("beside Python, over the largest", f"{r.apart:.0e}"),
    ]


HEAD = (
    "Cortex-M7, double, ELLA with 22 states, a plan of 24 intervals in 1.2 s, a shaper of two modes over three joints, "
    "gains of the joints, a linear-quadratic law of 4 vertices with its filter, a sample every millisecond"
)


def text(r: Result) -> str:
    return "\n".join([HEAD, *(f"{name:45} {value}" for name, value in rows(r))])


def columns(r: Result) -> dict[str, object]:
    """The row of the CSV."""
    row: dict[str, object] = {}
    for what, found in (("flash", r.flash), ("ram", r.sizes), ("stack", r.stacks)):
        row |= {f"{what}_{name}": x for name, x in found.items()}
    return row | {name: max(numbers) for name, numbers in r.counts.items()} | {"apart": r.apart}


def failures(r: Result) -> list[str]:
    """What is beyond its limit."""
    out = [] if r.apart < APART else [f"numbers on the target and in Python are {r.apart:.1e} apart"]
    taken = {"flash": (max(r.flash.values()), FLASH), "RAM": (sum(r.sizes.values()), RAM)}
    taken |= {"stack": (max(r.stacks.values()), STACK)}
    return out + beyond(taken | {name: (max(r.counts[name]), most) for name, most in INSTRUCTIONS.items()})


def main(arguments: list[str]) -> int:
    if arguments not in ([], ["--record"]):
        raise FirmwareError("motions.py takes --record or nothing")
    result = measure()
    if arguments:
        write_section(budget_table.TABLE, TITLE, HEAD, rows(result))
    return judged(text(result), "firmware_motions", columns(result), failures(result))


if __name__ == "__main__":
    ended(lambda: main(sys.argv[1:]))
