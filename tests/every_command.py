"""Random robots with everything at once through every command: `python tests/every_command.py 0 300 [results.jsonl]`.

The robots are those of :mod:`mixed_arms`, but small. Each is written to TOML, its state to JSON, and every command is
called as a user would call it. A command does its work, or says in one line why not. The C that it writes is built by
`make check`, in double and in float. Results are added to the file, and robots that stand there are not run again.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import traceback
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import flexible_robots as fr
import numpy as np
import random_robots as rr
from mixed_arms import LIMITS, STATE, Mixed, described, drawn

from screwgen.cli.main import main as screwgen

SMALL = LIMITS | {"gears": 0.5, "max_modes": 1}
LINKS = 4
LONGEST = 300
"""s: what takes longer has died."""
GCC = str(Path(__file__).parent / "tools" / "cc")
TCC = shutil.which("tcc") or GCC
"""The compilers of units and of all else; neither optimises."""
DONE, REFUSED, DIED, WRONG = "done", "refused", "died", "check failed"
OPTIONS = (("auto",), ("fused",), ("modular",), ("auto", "--batch"), ("modular", "--batch"), ("auto", "--baked"))
"""The layout of the C, and what else is asked of it, by robot."""


class Outcome(NamedTuple):
    """What came of a command: one of DONE, REFUSED, DIED and WRONG, and its reason."""

    said: str
    why: str = ""


def commands(number: int, case: Mixed) -> dict[str, list[str]]:
    """The command lines for a robot, in its folder, in their order."""
    layout, *more = OPTIONS[number % len(OPTIONS)]
    more = ["--parameters", "baked"] if more == ["--baked"] else more
    run = ["simulate", "robot.toml", "--duration", "0.01", "--step", "0.001", "--state", "state.json"]
    at = ["--state", "state.json"]
    lines = {
        "generate c": ["generate", "robot.toml", "-o", "out", "--target", "c", "--layout", layout, *more],
        "generate casadi": ["generate", "robot.toml", "-o", "casadi", "--target", "casadi", "--functions", "all"],
        "generate latex": ["generate", "robot.toml", "-o", "latex", "--target", "latex"],
        "generate fmu": ["generate", "robot.toml", "-o", "fmu", "--target", f"fmu{2 + number % 2}"],
        "simulate joint": [*run, "-o", "joint.npz"],
        "simulate dae": [*run, "-o", "dae.npz", "--form", "dae"],
        "view": ["view", "joint.npz", "dae.npz", "-o", "run.html"],
        "modes": ["modes", "robot.toml", "--posture", "state.json"],
        "modes free": ["modes", "robot.toml", "--posture", "state.json", "--joints", "free", "--json"],
        "modes loaded": ["modes", "robot.toml", "--posture", "state.json", "--loaded"],
        "analyse": ["analyse", "robot.toml", *at, "--samples", "1"],
        "equilibrium": ["equilibrium", "robot.toml", "--state", "rest.json"],
        "equilibrium hold": ["equilibrium", "robot.toml", "--hold", "--json"],
        "latex": ["latex", "robot.toml", "-o", "equations.html"],
    }
    if "loops" in case.robot:
        joints = case.given[0][case.model.chain.base_q :][: case.model.n_joints]
        lines["assemble"] = ["assemble", "robot.toml", f"--q={','.join(map(repr, map(float, joints)))}"]
    for backend in ("numpy", "casadi", "c"):
        for form in ("joint", "dae"):
            lines[f"evaluate {backend} {form}"] = ["evaluate", "robot.toml", *at, "--backend", backend, "--form", form]
    return lines


def written(case: Mixed, folder: Path) -> None:
    """Robot and state as the files that the commands read."""
    (folder / "robot.toml").write_text(rr.to_toml(fr.with_files(case.robot, folder) | {"name": "robot"}))
    state = dict(zip(STATE, map(np.asarray, case.given), strict=True))
    state["w_ext"] = state["w_ext"].reshape(-1, 6)[case.model.chain.lasts]
    state = {name: x.tolist() for name, x in state.items()}
    (folder / "state.json").write_text(json.dumps(state))
    (folder / "rest.json").write_text(json.dumps({"q": state["q"]}))


def small(seed: int, folder: Path) -> Mixed:
    """The robot of a number."""
    return drawn(seed, folder, LINKS, **SMALL)


def results(seed: int, wanted: frozenset[str] | None = None) -> tuple[str, dict[str, Outcome]]:
    """What the robot of a number has, and what came of each command, or of those that are `wanted`."""
    with TemporaryDirectory() as name, contextlib.chdir(name):
        folder = Path(name)
        case = small(seed, folder)
        written(case, folder)
        found = {}
        for key, line in commands(seed, case).items():
            if wanted is None or key in wanted:
                os.environ["CC"] = GCC if key == "generate fmu" else TCC
                found[key] = called(line)
        if found.get("generate c", Outcome(REFUSED)).said == DONE:
            found["make check"] = checked(folder / "out" / "c")
        return described(case), found


def called(line: list[str]) -> Outcome:
    """What came of a command line in this process."""
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(said), limited():
            status = screwgen([*line])
    except Exception as error:  # the sweep goes on; what was raised is what a user would see as a traceback
        frame = traceback.extract_tb(error.__traceback__)[-1]
        return Outcome(DIED, f"{type(error).__name__} in {Path(frame.filename).name}, {frame.name}: {error}")
    errors = [text for text in said.getvalue().splitlines() if text.startswith("screwgen: error: ")]
    if status == 0:
        return Outcome(DONE)
    if len(errors) != 1 or "Traceback" in said.getvalue():
        return Outcome(DIED, f"status {status}: {said.getvalue()}")
    return Outcome(REFUSED, f"status {status}: {errors[0].removeprefix('screwgen: error: ')}")


@contextlib.contextmanager
def limited() -> Iterator[None]:
    """Raises TimeoutError in what takes longer than LONGEST."""

    def late(*_) -> None:
        raise TimeoutError(f"takes more than {LONGEST} s")

    before = signal.signal(signal.SIGALRM, late)
    signal.alarm(LONGEST)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def checked(folder: Path) -> Outcome:
    """`make check`, in double and, unless the folder says that it is of no use, in float."""
    make = ["make", "-s", "CC=gcc", "CFLAGS=-O0", "check"]
    done = subprocess.run(make, cwd=folder, capture_output=True, text=True, timeout=LONGEST)
    failed = [x for x in (*done.stdout.splitlines(), *done.stderr.splitlines()) if "FAILED" in x or "error" in x]
    if done.returncode == 0 and not failed and "all checks passed" in done.stdout:
        return Outcome(DONE)
    return Outcome(WRONG, "; ".join(failed) or done.stderr)


# ---------------------------------------------------------------------------------------------- the sweep


def alike(why: str) -> str:
    """A reason without numbers and names, for those that are alike."""
    why = re.sub(r"'[^']*'", "'…'", why)
    why = re.sub(r"\b(link_?\d+|l\d+|bridge\d+)(_part\d+)?(\[\d+\])?", "LINK", why)
    return re.sub(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", "N", why)


def table(found: list[dict]) -> str:
    """A line for each command with the counts of its outcomes, and then the reasons."""
    counts: dict[str, Counter] = {}
    reasons: dict[tuple[str, str, str], list[int]] = {}
    for row in found:
        for command, (said, why) in row["results"].items():
            counts.setdefault(command, Counter())[said] += 1
            if why:
                reasons.setdefault((command, said, alike(why)), []).append(row["seed"])
    kinds = (DONE, REFUSED, DIED, WRONG)
    lines = [f"{'':24}" + "".join(f"{kind:>14}" for kind in kinds)]
    lines += [f"{command:24}" + "".join(f"{count[kind]:14}" for kind in kinds) for command, count in counts.items()]
    for (command, said, why), seeds in sorted(reasons.items(), key=lambda item: (item[0][:2], -len(item[1]))):
        lines.append(f"{command} {said}, {len(seeds)} ({', '.join(map(str, seeds[:6]))}): {why[:400]}")
    return "\n".join(lines)


def main() -> int:
    """Run the robots that the file of results does not have, and print the table of those asked for."""
    first, last = int(sys.argv[1]), int(sys.argv[2])
    kept = Path(sys.argv[3]).absolute() if len(sys.argv) > 3 else None
    rows = [json.loads(line) for line in kept.read_text().splitlines()] if kept and kept.exists() else []
    rows = [row for row in rows if first <= row["seed"] < last]
    for seed in sorted(set(range(first, last)) - {row["seed"] for row in rows}):
        start = time.time()
        text, found = results(seed)
        rows.append({"seed": seed, "robot": text, "seconds": round(time.time() - start), "results": found})
        bad = {command: outcome for command, outcome in found.items() if outcome.said != DONE}
        print(f"{seed} {text} ({time.time() - start:.0f} s) {bad or 'all done'}", flush=True)
        if kept:
            with kept.open("a") as file:
                file.write(json.dumps(rows[-1]) + "\n")
    print(table(rows))
    return int(any(said in (DIED, WRONG) for row in rows for said, _ in row["results"].values()))


if __name__ == "__main__":
    sys.exit(main())
