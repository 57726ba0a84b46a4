"""What the Kalman filter that finds a payload costs on a Cortex-M7, and what it finds: the example arm under QEMU.

python firmware/payload.py [--record]

Prints a table and writes build/firmware_payload.csv. Exit status is 1 where a figure is past its limit, 2 where a tool
is missing or a program fails. --record writes the table into TABLE.md.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass

import budget_table
from cross import Build, FirmwareError, generate, require, run_on_host, size_of
from emulate import Counter, read_findings
from estimate import EXAMPLE, IMAGE
from outcome import OUT, beyond, ended, judged, write_section
from stack import covered_stacks
from targets import HERE, TARGETS, Variant

import screwgen

WORK = OUT / "firmware_payload"
PROGRAM = HERE / "target" / "payload.c"
FOUND = "forearm.bodies[0].mass"
OPTIONS = {"plain": {"estimator": True}, "payload": {"estimate": [FOUND]}}
"""The filter without and with the parameter."""
PRECISIONS = ("double", "float")
PAYLOAD, TIP = 0.01, 4e-4
"""The most that the payload, relative, and the tip, m, may be off one second after it is picked up."""
STACK, RAM, PREDICT, UPDATE = 8192, 65_536, 200_000, 100_000
"""The most that it may take: bytes, and instructions of a prediction and of an update."""
TITLE = "A filter that finds a payload"


@dataclass(frozen=True)
class Result:
    """Of one filter in one precision on the target: bytes, executed instructions; errors."""

    flash: int
    """Of the whole image with filter and joint form."""
    ram: int
    """The structs of the filter."""
    stack: int
    counts: dict[str, int]
    errors: dict[str, float]
    """One second after the payload is picked up: of it, relative, and of the tip, m."""


Results = dict[tuple[str, str], Result]


def measure() -> tuple[Results, dict[str, float]]:
    """Compile both filters for the target and run them; and the errors of the one with the parameter in double here."""
    model, out, host = screwgen.derive(screwgen.load(EXAMPLE)), {}, {}
    for kind, options in OPTIONS.items():
        for precision in PRECISIONS:
            variant = Variant(TARGETS["m7"], precision, "fused", "runtime")
            require(variant.target)
            sources = generate(model, WORK / kind / "source", variant.parameters, variant.layout, **options)
            build = Build(variant, sources, WORK / kind / variant.name)
            define = [f'-DESTIMATOR_HEADER="{sources.name}_estimator.h"', *["-DFINDS"] * (kind == "payload")]
            flash = size_of(build, build.link("filter", IMAGE, False, *define)).flash
            program = build.link("payload", PROGRAM, True, *define)
            found = Counter(WORK / "counter").run(build, program)
            stack = max(covered_stacks(build, program, found.stacks).values())
            counts = {name: max(numbers) for name, numbers in found.counts.items()}
            errors = {name: 1e-9 * x for name, x in found.figures.items()}
            out[kind, precision] = Result(flash, sum(found.sizes.values()), stack, counts, errors)
        if kind == "payload":
            said = read_findings(run_on_host(sources, WORK / "host", PROGRAM, "-O0", *define))
            host = {name: 1e-9 * x for name, x in said.figures.items()}
    return out, host


HEAD = (
    "Cortex-M7, ELLA with 9 coordinates, 3 encoders and 4 gauges, a sample every millisecond; in double, then in "
    "float. The arm picks up 1 kg, which the filter finds; beside it the filter without this state"
)


def rows(found: Results, host: dict[str, float]) -> list[tuple[str, str]]:
    """What is measured, and its figure."""

    def pair(text: str, name: str, kind: str, of: str = "") -> tuple[str, str]:
        numbers = (getattr(found[kind, precision], name) for precision in PRECISIONS)
        unit = "" if of else " B"
        return text, "; ".join(f"{x[of] if of else x:,}{unit}" for x in numbers)

    own, errors = "payload", [found["payload", precision].errors for precision in PRECISIONS]
    return [
        pair("flash: image with the filter", "flash", own),
        pair("flash: without the payload", "flash", "plain"),
        pair("RAM: structs of the filter", "ram", own),
        pair("RAM: without the payload", "ram", "plain"),
        pair("stack: worst", "stack", own),
        pair("instructions: prediction", "counts", own, "predict"),
        pair("instructions: prediction without the payload", "counts", "plain", "predict"),
        pair("instructions: update, with the constants anew", "counts", own, "update"),
        pair("instructions: update without the payload", "counts", "plain", "update"),
        ("payload after one second, error", "; ".join(f"{100 * abs(x['payload']):.2f} %" for x in errors)),
        ("tip then, error", "; ".join(f"{1e3 * x['tip']:.3f} mm" for x in errors)),
        ("both in double on this machine", f"{100 * abs(host['payload']):.2f} %, {1e3 * host['tip']:.3f} mm"),
    ]


def columns(found: Results) -> dict[str, object]:
    """The row of the CSV."""
    row: dict[str, object] = {}
    for (kind, precision), r in found.items():
        numbers = {"flash": r.flash, "ram": r.ram, "stack": r.stack} | r.counts
        row |= {f"{name}_{kind}_{precision}": x for name, x in numbers.items()}
        row |= {f"error_{name}_{kind}_{precision}": f"{x:.3e}" for name, x in r.errors.items() if kind == "payload"}
    return row


def failures(found: Results, host: dict[str, float]) -> list[str]:
    """What is beyond its limit."""
    out, taken = [], {}
    for precision in PRECISIONS:
        r = found["payload", precision]
        for name, most in (("payload", PAYLOAD), ("tip", TIP)):
            if not abs(r.errors[name]) < most:
                out.append(f"{precision}: the error of the {name} is {abs(r.errors[name]):.1e}, the limit is {most:g}")
        taken |= {f"{precision}: stack": (r.stack, STACK), f"{precision}: RAM": (r.ram, RAM)}
        taken |= {f"{precision}: predict": (r.counts["predict"], PREDICT)}
        taken |= {f"{precision}: update": (r.counts["update"], UPDATE)}
    for name, error in found["payload", "double"].errors.items():
        if not abs(error - host[name]) < 1e-8:
            out.append(f"{name}: the error is {error:.3e} on the target and {host[name]:.3e} on this machine")
    return out + beyond(taken)


def main(arguments: list[str]) -> int:
    if arguments not in ([], ["--record"]):
        raise FirmwareError("payload.py takes --record or nothing")
    found, host = measure()
    shown = rows(found, host)
    status = judged(
        "\n".join([HEAD, *(f"{name:46} {value}" for name, value in shown)]),
        *("firmware_payload", columns(found), failures(found, host)),
    )
    if arguments and not status:
        write_section(budget_table.TABLE, TITLE, HEAD, shown)
    return status


if __name__ == "__main__":
    ended(lambda: main(sys.argv[1:]))
