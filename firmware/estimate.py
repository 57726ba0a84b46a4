"""What the Kalman filter costs on a Cortex-M4F, and what it finds there: the example arm in float under QEMU.

python firmware/estimate.py

Prints a table and writes build/firmware_estimator.csv. The exit status is 1 where the filter misses its figure, 2 where
a tool is missing or a program fails.
"""

from __future__ import annotations

from dataclasses import dataclass

from cross import Build, generate, require, run_on_host, size_of
from emulate import Counter, read_findings
from outcome import OUT, ROOT, beyond, ended, judged
from stack import covered_stacks
from targets import HERE, TARGETS, Variant

import screwgen

EXAMPLE = ROOT / "examples" / "ella_paper.toml"
WORK = OUT / "firmware_estimator"
VARIANT = Variant(TARGETS["m4f"], "float", "fused", "runtime")
PROGRAM, IMAGE = HERE / "target" / "estimate.c", HERE / "target" / "image.c"
LIMIT = 0.1
"""The filter's error over the open-loop model's, at most."""
STACK, RAM, PREDICT, UPDATE = 4096, 16_384, 100_000, 50_000
"""The most that the filter may take: bytes, and instructions of a prediction and of an update."""
ROUNDING = 0.05
"""How far an error in float may be from that in double, relative."""


@dataclass(frozen=True)
class Result:
    """Of the filter on the target: bytes, executed instructions, metres."""

    flash: int
    """Of the whole image with filter and joint form."""
    flash_alone: int
    """Of the image without the filter."""
    ram: int
    """The structs of the filter."""
    stack: int
    counts: dict[str, int]
    errors: dict[str, float]
    errors_on_host: dict[str, float]

    @property
    def part(self) -> float:
        """The filter's error over the open-loop model's."""
        return self.errors["filter"] / self.errors["open_loop"]


def measure() -> Result:
    """Compile for the target and for this machine, run both."""
    require(VARIANT.target)
    model = screwgen.derive(screwgen.load(EXAMPLE))
    sources = generate(model, WORK / "source", VARIANT.parameters, VARIANT.layout, estimator=True)
    build = Build(VARIANT, sources, WORK / VARIANT.name)
    define = f'-DESTIMATOR_HEADER="{sources.name}_estimator.h"'
    alone, whole = size_of(build, build.image(False)), size_of(build, build.link("filter", IMAGE, False, define))
    program = build.link("estimate", PROGRAM, True, define)
    found = Counter(WORK / "counter").run(build, program)
    stacks = covered_stacks(build, program, found.stacks)
    counts = {name: max(numbers) for name, numbers in found.counts.items()}
    reference = read_findings(run_on_host(sources, WORK, PROGRAM, "-O0", define))
    errors, host = ({n: 1e-9 * x for n, x in f.figures.items()} for f in (found, reference))
    return Result(whole.flash, alone.flash, sum(found.sizes.values()), max(stacks.values()), counts, errors, host)


def text(r: Result) -> str:
    """The table."""
    lines = [("Cortex-M4F, float, ELLA with 9 coordinates", "")]
    lines += [("flash: image with the filter", f"{r.flash:,} B"), ("flash: image without", f"{r.flash_alone:,} B")]
    lines += [("RAM: structs of the filter", f"{r.ram:,} B"), ("stack: worst", f"{r.stack:,} B")]
    names = {
        "predict": "instructions: prediction",
        "update": "instructions: update, 3 encoders and 4 gauges",
        "update_acceleration": "instructions: with the accelerometer besides",
    }
    lines += [(title, f"{r.counts[name]:,}") for name, title in names.items()]
    titles = {
        "deflection": "tip deflection",
        "open_loop": "error of the open-loop model",
        "filter": "error of the filter",
    }
    for name, title in titles.items():
        there, here = 1e3 * r.errors[name], 1e3 * r.errors_on_host[name]
        lines.append((f"{title}, RMS", f"{there:.3f} mm (double on this machine: {here:.3f} mm)"))
    lines.append(("filter over open loop", f"{r.part:.1%}"))
    return "\n".join(f"{name:46} {value}".rstrip() for name, value in lines)


def columns(r: Result) -> dict[str, object]:
    """The row of the CSV."""
    row: dict[str, object] = {"flash": r.flash, "flash_alone": r.flash_alone, "ram": r.ram, "stack": r.stack} | r.counts
    row |= {f"error_{n}": f"{x:.3e}" for n, x in r.errors.items()}
    return row | {f"error_{n}_on_host": f"{x:.3e}" for n, x in r.errors_on_host.items()}


def failures(r: Result) -> list[str]:
    """What is beyond its limit."""
    out = []
    if not r.part < LIMIT:
        out.append(f"the filter's error is {r.part:.1%} of the open-loop model's, the limit is {LIMIT:.0%}")
    for name, error in r.errors.items():
        if not abs(error - r.errors_on_host[name]) < ROUNDING * abs(r.errors_on_host[name]):
            out.append(f"{name}: the error in float is {error:.3e} m, in double {r.errors_on_host[name]:.3e} m")
    taken = {"stack": (r.stack, STACK), "RAM": (r.ram, RAM)}
    taken |= {"predict": (r.counts["predict"], PREDICT), "update": (r.counts["update"], UPDATE)}
    return out + beyond(taken)


def main() -> int:
    result = measure()
    return judged(text(result), "firmware_estimator", columns(result), failures(result))


if __name__ == "__main__":
    ended(main)
