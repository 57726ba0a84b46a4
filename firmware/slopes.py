"""What a step with its derivatives costs on a Cortex-M7, beside the step alone: the example arm under QEMU.

python firmware/slopes.py [--record]

Prints a table and writes build/firmware_slopes.csv. Exit status is 1 where a figure is past its limit, 2 where a tool
is missing or a program fails. --record writes the table into TABLE.md.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass

import budget_table
import numpy as np
from cross import Build, FirmwareError, generate, require, size_of
from emulate import Counter
from estimate import EXAMPLE
from outcome import OUT, beyond, ended, judged, write_section
from stack import covered_stacks
from targets import HERE, TARGETS, Variant

import screwgen

WORK = OUT / "firmware_slopes"
PROGRAM = HERE / "target" / "slopes.c"
STEP, CALL = 1e-3, "step_modal_implicit_derivatives"
KINDS = tuple((layout, precision) for layout in ("fused", "modular") for precision in ("double", "float"))
"""Layouts: derivatives in one straight line, and by recursion along the chain."""
APART = {"double": 1e-11, "float": 1e-3}
"""Between numbers on the target and in double on this machine, over the largest of their kind."""
FLASH, RAM, STACK, SLOPES = 524_288, 65_536, 8_192, 100_000
"""The most that it may take: bytes, and instructions."""
TITLE = "A step with its derivatives"
HEAD = (
    "Cortex-M7, ELLA with 9 coordinates, `modal_implicit`, runtime parameters; in double, then in float. *Fused* has "
    "the derivatives in one straight line, *modular* by recursion along the chain"
)


@dataclass(frozen=True)
class Result:
    """Of a layout in a precision: bytes, executed instructions, how far numbers are from those of this machine."""

    flash: int
    """Of the image that takes steps with derivatives."""
    step: int
    """Of the image that takes steps alone."""
    ram: int
    """The structs of the caller: result and scratch of the derivatives."""
    stack: int
    counts: dict[str, int]
    apart: float


Results = dict[tuple[str, str], Result]


def expected(model: screwgen.Model) -> list[np.ndarray]:
    """What the program prints, by the same C on this machine: the next state, A and B."""
    joints, place = model.n_joints, np.arange(model.nq)
    q = np.where(place < joints, 0.1 * (place + 1), 1e-3 * (place - joints + 1))
    v, tau = 0.2 - 0.01 * np.arange(model.nv), 20.0 - 5.0 * np.arange(joints)
    q, v, A, B = model.compile(derivatives=True).step_derivatives(q, v, tau, None, STEP, "modal_implicit")
    return [np.concatenate([q, v]), A.ravel(), B.ravel()]


def measure() -> Results:
    """Compile all variants for the target and run them there."""
    model, out = screwgen.derive(screwgen.load(EXAMPLE)), {}
    wanted = expected(model)
    cuts = np.cumsum([x.size for x in wanted])[:-1]
    for layout, precision in KINDS:
        variant = Variant(TARGETS["m7"], precision, layout, "runtime")
        require(variant.target)
        sources = generate(model, WORK / layout / "source", variant.parameters, layout, derivatives=True)
        build = Build(variant, sources, WORK / layout / variant.name)
        define = f'-DSLOPES_HEADER="{sources.name}_derivatives.h"'
        flash, step = (
            size_of(build, build.link(name, PROGRAM, False, define, *more)).flash
            for name, more in (("slopes", ()), ("step", ("-DSTEP_ALONE",)))
        )
        program = build.link("measure_slopes", PROGRAM, True, define)
        found = Counter(WORK / "counter").run(build, program)
        stack = covered_stacks(build, program, found.stacks)[CALL]
        numbers = np.split(np.array(found.samples[0]), cuts)
        apart = max(np.abs(a - b).max() / np.abs(b).max() for a, b in zip(numbers, wanted, strict=True))
        counts = {name: max(taken) for name, taken in found.counts.items()}
        out[layout, precision] = Result(flash, step, found.sizes["slopes"], stack, counts, float(apart))
    return out


def rows(found: Results) -> list[tuple[str, str]]:
    """What is measured, and its figure."""
    out = []
    for layout in dict.fromkeys(layout for layout, _ in KINDS):
        own = [r for kind, r in found.items() if kind[0] == layout]
        shown = {
            "flash: image with the derivatives": [f"{r.flash:,} B" for r in own],
            "flash: with the step alone": [f"{r.step:,} B" for r in own],
            "RAM: result and scratch": [f"{r.ram:,} B" for r in own],
            "stack: worst": [f"{r.stack:,} B" for r in own],
            "instructions: step with derivatives": [f"{r.counts['slopes']:,}" for r in own],
            "instructions: step alone": [f"{r.counts['step']:,}" for r in own],
            "over a step alone": [f"{r.counts['slopes'] / r.counts['step']:.1f}" for r in own],
            "beside this machine in double, over the largest": [f"{r.apart:.0e}" for r in own],
        }
        out += [(f"{layout}, {name}", "; ".join(values)) for name, values in shown.items()]
    return out


def columns(found: Results) -> dict[str, object]:
    """The row of the CSV."""
    row: dict[str, object] = {}
    for (layout, precision), r in found.items():
        numbers = {"flash": r.flash, "flash_step": r.step, "ram": r.ram, "stack": r.stack, **r.counts}
        row |= {f"{name}_{layout}_{precision}": x for name, x in numbers.items()}
        row[f"apart_{layout}_{precision}"] = f"{r.apart:.3e}"
    return row


def failures(found: Results) -> list[str]:
    """What is beyond its limit."""
    out = []
    for (layout, precision), r in found.items():
        name = f"{layout}, {precision}"
        if not r.apart < APART[precision]:
            out.append(f"{name}: numbers are {r.apart:.1e} apart, the limit is {APART[precision]:g}")
        taken = {"flash": (r.flash, FLASH), "RAM": (r.ram, RAM), "stack": (r.stack, STACK)}
        taken["slopes"] = (r.counts["slopes"], SLOPES)
        out += beyond({f"{name}: {what}": x for what, x in taken.items()})
    return out


def main(arguments: list[str]) -> int:
    if arguments not in ([], ["--record"]):
        raise FirmwareError("slopes.py takes --record or nothing")
    found = measure()
    shown = rows(found)
    text = "\n".join([HEAD, *(f"{name:58} {value}" for name, value in shown)])
    status = judged(text, "firmware_slopes", columns(found), failures(found))
    if arguments and not status:
        write_section(budget_table.TABLE, TITLE, HEAD, shown)
    return status


if __name__ == "__main__":
    ended(lambda: main(sys.argv[1:]))
