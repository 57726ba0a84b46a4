"""The paper's Section 7 run again: its two-link arm, its task, its figures, and a report on its numbers.

Writes figures, report.md, report.html, run.csv and results.json into one folder. Everything is stepped in generated C,
compiled on the way. Two runs give the same bytes.
"""

import argparse
import json
import os
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from io import BytesIO
from pathlib import Path

from ella import figures, report, task

from screwgen import ScrewgenError, UsageError
from screwgen.folder import check_folder, write_folder

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "ella_paper"
NUMBERS = """growth frequencies loops numbers limits comparisons axial_start axial_influence peaks""".split()
"""What of the results is written as JSON."""


def main(arguments: Sequence[str] | None = None) -> int:
    given = read(arguments)
    clock, stage = time.perf_counter(), Stage()
    try:
        earlier = check_folder(given.output)
        results = task.compute(task.QUICK if given.quick else task.FULL, stage)
        files = make_files(results, stage)
        write_folder(given.output, files, tuple({name.partition("/")[0] for name in (*earlier, *files)}))
    except ScrewgenError as error:
        stage.clear()
        print(f"ella_paper: error: {error}", file=sys.stderr)
        return 2 if isinstance(error, UsageError) else 1
    stage.clear()
    summary(results, given.output, time.perf_counter() - clock)
    return 0


def read(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="ella_paper.py", description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=FOLDER, help="folder (default: build/ella_paper)")
    parser.add_argument("--quick", action="store_true", help="a short run, small figures: to see that all works")
    return parser.parse_args(arguments)


class Stage:
    """Says on one line what is being done; on anything but a terminal, on a line each."""

    def __call__(self, what: str) -> None:
        if sys.stderr.isatty():
            print(f"\r\033[K  {what} …", end="", file=sys.stderr, flush=True)
        else:
            print(f"  {what}", file=sys.stderr, flush=True)

    def clear(self) -> None:
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def make_files(results: task.Results, stage: Stage) -> Mapping[str, bytes]:
    """Everything that is written: name and bytes."""
    out, document = figures.draw(results, stage), report.write(results)
    numbers = {name: plain(getattr(results, name)) for name in NUMBERS}
    table = BytesIO()
    results.run.write(table, "run.csv")
    return out | {
        "report.md": document.markdown().encode(),
        "report.html": document.html().encode(),
        "results.json": (json.dumps(numbers, indent=1) + "\n").encode(),
        "run.csv": table.getvalue(),
    }


def plain(value):
    """Dataclasses as dictionaries, at any depth of lists."""
    if isinstance(value, list | tuple):
        return [plain(x) for x in value]
    return asdict(value) if hasattr(value, "__dataclass_fields__") else value


def summary(r: task.Results, folder: Path, seconds: float) -> None:
    euler = {g.name: g for g in r.growth if g.joints == "PD"}
    rate = lambda name: f"{euler[name].predicted:+.5g} /s predicted, {euler[name].observed:+.5g} /s observed"  # noqa: E731
    worst = max(g.error for g in r.growth)
    derived, still, dropped = (", ".join(f"{f:.4f}" for f in row.frequencies[-1]) for row in r.frequencies)
    held = [c for c in r.comparisons if c.complete]
    print("ELLA, the paper's Section 7")
    print(f"forward Euler, 1 ms     {rate('forward Euler, 1 ms')}: lost after {1e3 * r.comparisons[0].end:.0f} ms")
    print(f"  without axial modes   {rate('forward Euler, 1 ms, no axial modes')}")
    print(f"growth, all {len(r.growth)} rows     observed within {100 * worst:.2g} % of the prediction")
    print(f"other methods           {len(held)} of {len(r.comparisons)} runs of the task hold")
    print(f"frequencies (Hz)        {derived}  with section rotation, joints locked")
    print(f"                        {still}  without")
    print(f"                        {dropped}  wrench columns dropped, as printed")
    n = r.numbers
    print(
        f"axial displacement      {n.axial_energy / 1e3:.1f} kJ, {n.axial_force / 1e6:.2f} MN: it cannot be a stretch"
    )
    print(f"report                  {shown(folder / 'report.html')}   ({seconds:.0f} s)")


def shown(path: Path) -> str:
    """The path from here, if it lies below."""
    relative = os.path.relpath(path)
    return str(path) if relative.startswith("..") else relative


if __name__ == "__main__":
    sys.exit(main())
