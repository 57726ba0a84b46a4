"""Wild calls of generated C at length: `python tests/wild_calls.py 0 12 [--calls 10000] [--seeds 3] [--valgrind]`.

The robots are those of the matrix that hold every feature, by their numbers, then the same without what predictive
control refuses. Each is built with runtime parameters in double and with baked ones in float, with all options, and
with a predictive controller where it can have one. What is asked of every call stands in :mod:`conformance.c_wild`;
sanitizers watch, or valgrind.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import time
import warnings
from pathlib import Path
from tempfile import TemporaryDirectory

from c_tools import SANITIZERS, VALGRIND
from conformance.arrays import covering, few
from conformance.c_wild import program
from conformance.cases import Case, case_of
from conformance.features import FACTOR_OF
from conftest import require_tool
from feature_robots import CONTROL
from test_c_wild import EXAMPLES

from screwgen import Model, ScrewgenError

BUILDS = (("runtime", "double"), ("baked", "float"))
BY_P = 2
"""Derivatives by so many parameters, the last ones."""
UNCONTROLLED = ("base", "closing", "tendon", "drive", "friction")
"""Factors most of whose features predictive control refuses; it refuses ball joints besides."""


def robots() -> list[Case]:
    """Those that hold every feature, and as many that have a controller."""
    cases = [case_of(tuple(row.items()), covering().index(row)) for row in few()]
    refused = {"ball", *(feature for feature, factor in FACTOR_OF.items() if factor in UNCONTROLLED)}
    return cases + [case.without(refused & set(case.features)) for case in cases]


def write(model: Model, folder: Path, binding: str) -> bool:
    """The C of a robot with all options and the program of its calls; whether it has a predictive controller."""
    (folder / "control.toml").write_text(CONTROL)
    options = dict(batch=True, estimator=True, outputs=True, derivatives=True)
    if binding == "runtime":
        options |= dict(by_p=model.parameter_names[-BY_P:])
    try:
        files, controlled = model.c_files(binding, "auto", folder / "control.toml", **options), True
    except ScrewgenError:
        files, controlled = model.c_files(binding, "auto", None, **options), False
    for name, data in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(data)
    (folder / "wild.c").write_text(program(folder, model.robot.name))
    return controlled


def built(folder: Path, name: str, precision: str, *flags: str) -> None:
    """The program, compiled."""
    sources = sorted(path.name for path in folder.glob("*.c") if path.name not in EXAMPLES)
    defines = [f"-D{name.upper()}_REAL_FLOAT"] * (precision == "float")
    command = [require_tool("gcc"), "-std=c99", "-O0", *flags, *defines, "-o", "wild", *sources, "-lm"]
    subprocess.run(command, cwd=folder, check=True)


def said(folder: Path, calls: int, seed: int, *guard: str) -> tuple[bool, str]:
    """Whether a campaign went well, and what it said."""
    command = [*guard, str(folder / "wild"), str(calls), str(seed)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    return done.returncode == 0, (done.stdout + done.stderr[:3000]).strip()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("first", type=int)
    parser.add_argument("last", type=int)
    parser.add_argument("--calls", type=int, default=10000)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--valgrind", action="store_true")
    given, failed = parser.parse_args(), 0
    flags, guard = ((), (require_tool("valgrind"), *VALGRIND)) if given.valgrind else (SANITIZERS, ())
    for number in range(given.first, min(given.last, len(robots()))):
        model = robots()[number].model
        for binding, precision in BUILDS:
            with TemporaryDirectory() as place, warnings.catch_warnings():
                warnings.simplefilter("ignore")
                start, folder = time.time(), Path(place)
                controlled = write(model, folder, binding)
                built(folder, model.robot.name, precision, *flags)
                for seed in range(1, given.seeds + 1):
                    well, text = said(folder, given.calls, seed, *guard)
                    failed += not well
                    kind = f"{binding} {precision}{' with control' * controlled}"
                    print(f"robot {number} {kind} seed {seed}: {text} ({time.time() - start:.0f} s)", flush=True)
    return failed


if __name__ == "__main__":
    sys.exit(main())
