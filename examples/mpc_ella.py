"""Model-predictive control of ELLA in generated C, beside PD; late samples; a motion with a bounded joint wrench.

Writes figures, report.md, report.html and results.json into one folder.
"""

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from ella_paper import Stage, shown
from mpc import report, show, task

from screwgen import ScrewgenError, UsageError
from screwgen.folder import check_folder, write_folder

FOLDER = Path(__file__).resolve().parents[1] / "build" / "mpc"


def main(arguments: Sequence[str] | None = None) -> int:
    given, stage = read(arguments), Stage()
    try:
        if given.ghost:
            task.GHOST.write_text(json.dumps(task.ghost(stage)) + "\n")
            stage.clear()
            return 0
        earlier = check_folder(given.output)
        results = task.compute(task.QUICK if given.quick else task.FULL, stage)
        files = make_files(results)
        write_folder(given.output, files, tuple({name.partition("/")[0] for name in (*earlier, *files)}))
    except ScrewgenError as error:
        stage.clear()
        print(f"mpc_ella: error: {error}", file=sys.stderr)
        return 2 if isinstance(error, UsageError) else 1
    stage.clear()
    found = task.numbers(results)
    summary(found, given.output)
    missed = shortfalls(found)
    for claim in missed:
        print(f"mpc_ella: does not hold: {claim}", file=sys.stderr)
    return 1 if missed else 0


def read(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="mpc_ella.py", description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=FOLDER, help="folder (default: build/mpc)")
    parser.add_argument("--quick", action="store_true", help="a short run, small figures: to see that all works")
    parser.add_argument("--ghost", action="store_true", help="record the loop with a converged IPOPT: mpc/ghost.json")
    return parser.parse_args(arguments)


def make_files(results: task.Results) -> dict[str, bytes]:
    document = report.report(results)
    return show.draw(results) | {
        "report.md": document.markdown().encode(),
        "report.html": document.html().encode(),
        "results.json": (json.dumps(task.numbers(results), indent=1) + "\n").encode(),
    }


def shortfalls(n: dict) -> list[str]:
    """What the example claims and these figures do not bear out."""
    w, limits, faster = n["wrench"], np.array(n["limit"]), n["headline"]["faster"]
    mpc, ghost = (times[task.BAND] or np.inf for times in (n["settling"]["mpc"], n["ghost"]["settling"]))
    peaks = [*n["peak"].values(), *n["late_peak"].values()]
    claims = {
        "every sample is solved": n["solved"],
        "a sample takes less than 5 ms, but for one in a thousand": n["latency"]["warm_cpu"]["sum"]["p99.9"] < 5.0,
        "one iteration a sample settles the tip as converged ones do, but for a twentieth": mpc <= 1.05 * ghost,
        "the tip settles twice as fast as under PD": faster is not None and faster >= 2.0,
        "the tip settles within 10 mm without a plan": n["settling"]["cold"][1] is not None,
        "the tip settles where samples are late": all(times[0] is not None for times in n["late"].values()),
        "no controller beats the lower bound": all(
            time is None or time >= bound
            for times in n["settling"].values()
            for time, bound in zip(times, n["lower_bounds"], strict=False)
        ),
        "torques keep to their limits": all(np.all(np.array(p) <= limits + 1e-9) for p in peaks),
        "the bound on the wrench is kept, and needed": w["plant"]["bounded"] < w["bound"] < w["plant"]["free"],
    }
    return [claim for claim, holds in claims.items() if not holds]


def summary(n: dict, folder: Path) -> None:
    w, names = n["wrench"], task.CONTROLLERS
    width = max(map(len, names.values()))
    row = lambda name, times: f"{name:{width}}  " + "".join(f"{report.seconds(t):>9}" for t in times)  # noqa: E731
    print("ELLA, point to point, payload 30 % heavier than designed for")
    print(f"{'tip within … of its goal, for good, after (s)':{width}}  " + "".join(f"{mm:>9}" for mm in report.MM))
    for name, times in n["settling"].items():
        print(row(f"{names[name]}", times))
    if n["lower_bounds"]:
        print(row("fastest possible motion", n["lower_bounds"]))
    print(f"MPC beside PD   {report.ratio(n['headline']['faster'])} times as fast within", end=" ")
    print(f"{report.MM[task.BAND]}, both knowing the payload that the MPC found")
    if n["lower_bounds"]:
        most = n["settling"]["hindsight"][task.BAND] / n["lower_bounds"][task.BAND]
        print(
            f"                {report.ratio(n['faster']['hindsight'][task.BAND])} with its best gains in hindsight,",
            end=" ",
        )
        print(f"where no controller could reach more than {report.ratio(most)}")
    t, g = n["latency"]["warm_cpu"]["sum"], n["ghost"]["solve_ms"]
    print(f"a sample        {t['median']:.2f} ms in the median, {t['p99.9']:.2f} in 999 of 1000,", end=" ")
    print(f"{t['max']:.2f} at most;", end=" ")
    print(f"IPOPT took {g['median']:.0f} and {g['max']:.0f} ms")
    late = {name: report.seconds(times[task.BAND]) for name, times in n["late"].items() if name != "none"}
    print(f"late samples    {'; '.join(f'{name}: {time} s' for name, time in late.items())}")
    print(f"elbow moment    {w['plant']['bounded']:.1f} N·m, bound {w['bound']:g}; {w['plant']['free']:.1f} without")
    print(f"report          {shown(folder / 'report.html')}")


if __name__ == "__main__":
    sys.exit(main())
