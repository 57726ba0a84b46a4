"""What a model costs on a microcontroller: cross-compiled, run under QEMU, held against the budgets.

python firmware/firmware.py [--quick] [--targets m4f,m7,rv32] [--record] [ROBOT.toml]

Prints tables and writes build/firmware.csv and build/firmware.md. The exit status is 1 where a budget is exceeded, 2
where a tool is missing or a program fails. The budgets are the examples'; another robot is only measured.
"""

from __future__ import annotations

import argparse
import re
import shutil
import sys
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import budget_table as table
from budget_table import Row
from cross import PROGRAMS, Build, FirmwareError, Sources, generate, require, run, run_on_host, size_of
from emulate import Counter, Findings, read_findings, self_check
from outcome import OUT, ROOT, ended
from stack import covered_stacks
from targets import LAYOUTS, PARAMETERS, TARGETS, Target, Variant, variants

import screwgen

WORK = OUT / "firmware"
EXAMPLE = ROOT / "examples" / "ella_paper.toml"
NOTES = """\
flash: the whole image, start-up and libm included; model: the generated code in it. RAM: the caller's structs. Bytes.
stack: worst over all calls, summed along the call graph; painted: deepest that was seen. Neither has an interrupt's.
dynamics: forward dynamics with wrenches and tip pose; then one step of each integrator: executed instructions, the most
over the states of the self-check. error: the largest in 1,000 steps of modal_implicit at 1 ms, against double here; of
ella to second order until its mass matrix is indefinite, in 0.17 s."""


def generate_all(model: screwgen.Model, place: Path) -> dict[tuple[str, str], Sources]:
    """The C of the model in every layout and with both kinds of parameters."""
    kinds = [(layout, parameters) for layout in LAYOUTS for parameters in PARAMETERS]
    return {(x, p): generate(model, place / f"{x}_{p}", p, x) for x, p in kinds}


def errors(found: Findings, reference: Findings, model: screwgen.Model) -> dict[str, float]:
    """Largest deviations of joint angles (rad) and of the tip's coordinates (m) over the samples.

    Where the model becomes singular, rounding decides in which step; one sample more or less is allowed.
    """
    ended, others = found.singular is None, reference.singular is None
    if ended != others or abs(len(found.samples) - len(reference.samples)) > (not ended):
        raise FirmwareError(f"the simulation ended in step {found.singular}, on the host in {reference.singular}")
    pairs = list(zip(found.samples, reference.samples, strict=False))
    joints, tip = range(model.n_joints), range(2 * model.nq, 2 * model.nq + 3)
    return {
        name: max(abs(a[k] - b[k]) for a, b in pairs for k in where)
        for name, where in (("angle", joints), ("tip", tip))
    }


def stacks(build: Build, found: Findings) -> dict[str, int]:
    """The worst stack of both forms, from the call graph and from paint; the first must cover the second."""
    worst, out = covered_stacks(build, build.folder / "measure.elf", found.stacks), {}
    for form, dae in (("stack", False), ("stack_dae", True)):
        calls = [call for call in found.stacks if call.startswith("dae_") == dae]
        out[form] = max(worst[call] for call in calls)
        out[f"{form}_painted"] = max(found.stacks[call] for call in calls)
    return out


def measure(variant: Variant, sources: Sources, model: screwgen.Model, reference: Findings, counter: Counter) -> Row:
    """Compile, check, run and count one variant."""
    build = Build(variant, sources, WORK / variant.name)
    joint, both = (size_of(build, build.image(dae)) for dae in (False, True))
    check = self_check(build)
    found = counter.run(build, build.measure())
    sizes = {"flash": joint.flash, "model": joint.model, "flash_dae": both.flash, "ram": joint.ram, "ram_dae": both.ram}
    counts = {name: max(numbers) for name, numbers in found.counts.items()}
    error = errors(found, reference, model)
    return Row(variant, sizes | stacks(build, found), counts, error, found.sizes, check)


def measure_all(wanted: Sequence[Variant], folder: Path, workers: int) -> list[Row]:
    """One row per variant, whose robot's file lies in the folder; says each as it is done.

    One model is generated while those before it are measured.
    """
    shutil.rmtree(WORK, ignore_errors=True)
    counter, rows = Counter(WORK / "counter"), {}

    def one(variant: Variant, model: screwgen.Model, sources: Sources, reference: Findings) -> Row:
        row = measure(variant, sources, model, reference, counter)
        print(f"{variant.name}: {row.check}", file=sys.stderr, flush=True)
        return row

    with ThreadPoolExecutor(workers) as pool:
        for arm, order in dict.fromkeys((v.arm, v.order) for v in wanted):
            robot = screwgen.load(folder / f"{arm}.toml")
            model = screwgen.derive(robot if order == 1 else robot.model_copy(update={"order": order}))
            sources = generate_all(model, WORK / f"source_{arm}_{order}")
            place, program = WORK / f"host_{arm}_{order}", PROGRAMS / "measure.c"
            reference = read_findings(run_on_host(sources["fused", "runtime"], place, program, "-O0"))
            for v in (v for v in wanted if (v.arm, v.order) == (arm, order)):
                rows[v.name] = pool.submit(one, v, model, sources[v.layout, v.parameters], reference)
        try:
            return [rows[v.name].result() for v in wanted]
        finally:
            pool.shutdown(cancel_futures=True)


# ------------------------------------------------------------------------------------------- command


def chosen(given: str | None) -> list[Target]:
    """The targets to measure; RISC-V is left out, with a word, where its tools are missing."""
    out = []
    for name in given.split(",") if given else TARGETS:
        if name not in TARGETS:
            raise FirmwareError(f"--targets: there is no '{name}'; choose from {', '.join(TARGETS)}")
        target = TARGETS[name]
        if target.missing and not given and name == "rv32":
            print(f"left out {target.core}: not installed: {', '.join(target.missing)}", file=sys.stderr)
        else:
            require(target)
            out.append(target)
    return out


def compiler_of(target: Target) -> str:
    """Name and version of the compiler, which a recorded budget belongs to."""
    first = run(target.compiler, "--version").splitlines()[0]
    found = re.search(r"\d+\.\d+\.\d+", first)
    return f"{target.compiler} {found[0] if found else first}"


QUICK = ("m4f_float_fused_baked", "m4f_float_modular_runtime")


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(prog="firmware", description=__doc__.partition("\n")[0])
    parser.add_argument(
        "robot",
        nargs="?",
        type=Path,
        default=EXAMPLE,
        help="robot file (.toml); the examples ella_paper and ella by default",
    )
    parser.add_argument("--quick", action="store_true", help=f"only {', '.join(QUICK)}")
    parser.add_argument("--targets", help=f"some of {','.join(TARGETS)}")
    parser.add_argument("--record", action="store_true", help="write the figures into budgets.toml and TABLE.md")
    parser.add_argument("--workers", type=int, default=2, help="variants at a time")
    options = parser.parse_args(arguments)
    targets = chosen("m4f" if options.quick and not options.targets else options.targets)
    example = options.robot.resolve() == EXAMPLE
    wanted = [v for v in variants(targets) if not options.quick or v.name in QUICK]
    if not example:
        wanted = [replace(v, arm=options.robot.stem) for v in wanted if (v.arm, v.order) == (EXAMPLE.stem, 1)]
    rows = measure_all(wanted, options.robot.parent, options.workers)
    compilers = {t.name: compiler_of(t) for t in targets}
    print(f"{table.text(rows)}\n\n{NOTES}")
    notes = f"{NOTES} Compilers: {', '.join(dict.fromkeys(compilers.values()))}."
    for path in table.write(rows, OUT, notes):
        print(path.relative_to(ROOT))
    if not example:
        return 0
    if options.record:
        table.record(rows, compilers, notes)
    return report(table.judge(rows, table.budgets(), compilers))


def report(verdict: table.Verdict) -> int:
    """Say what exceeds its budget; the exit status."""
    for remark in verdict.remarks:
        print(remark)
    for line in verdict.better:
        print(f"better than its budget: {line}")
    if verdict.better:
        print("take over what is better: make firmware ARGS=--record")
    for line in verdict.failures:
        print(f"over budget: {line}", file=sys.stderr)
    if not verdict.failures:
        print("all within budget")
    return 1 if verdict.failures else 0


if __name__ == "__main__":
    ended(lambda: main(sys.argv[1:]))
