"""Model-predictive control of ELLA on CasADi against the generated C, beside PD; a motion with a bounded joint wrench.

Writes figures, report.md, report.html and results.json into one folder.
"""

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

from ella_paper import Stage, shown
from mpc import show, task

from screwgen import ScrewgenError, UsageError
from screwgen.folder import check_folder, write_folder

FOLDER = Path(__file__).resolve().parents[1] / "build" / "mpc"


def main(arguments: Sequence[str] | None = None) -> int:
    given, stage = read(arguments), Stage()
    try:
        earlier = check_folder(given.output)
        results = task.compute(task.QUICK if given.quick else task.FULL, stage)
        files = make_files(results)
        write_folder(given.output, files, tuple({name.partition("/")[0] for name in (*earlier, *files)}))
    except ScrewgenError as error:
        stage.clear()
        print(f"mpc_ella: error: {error}", file=sys.stderr)
        return 2 if isinstance(error, UsageError) else 1
    stage.clear()
    summary(task.numbers(results), given.output)
    return 0


def read(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="mpc_ella.py", description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=FOLDER, help="folder (default: build/mpc)")
    parser.add_argument("--quick", action="store_true", help="a short run, small figures: to see that all works")
    return parser.parse_args(arguments)


def make_files(results: task.Results) -> dict[str, bytes]:
    document = show.report(results)
    return show.draw(results) | {
        "report.md": document.markdown().encode(),
        "report.html": document.html().encode(),
        "results.json": (json.dumps(task.numbers(results), indent=1) + "\n").encode(),
    }


def summary(n: dict, folder: Path) -> None:
    s, w, times = n["solve_seconds"], n["wrench"], [n[name]["settling"] for name in ("mpc", "pd")]
    print("ELLA, point to point, payload 30 % heavier than the model's")
    print("tip settled     MPC {:.3f} s, best PD {:.3f} s: {:.2f} times".format(*times, n["faster"]))
    print(f"solves          {n['solves']}, {'all' if n['converged'] else 'not all'} converged;", end=" ")
    print(f"{1e3 * s['median']:.0f} ms in the median, {1e3 * s['max']:.0f} ms at most")
    print(f"elbow moment    {w['plant']['bounded']:.1f} N·m, bound {w['bound']:g}; {w['plant']['free']:.1f} without")
    print(f"report          {shown(folder / 'report.html')}")


if __name__ == "__main__":
    sys.exit(main())
