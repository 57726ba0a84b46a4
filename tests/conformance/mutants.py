"""Does the matrix notice where one consumer forgets one feature? By hand: `python tests/conformance/mutants.py 0 40`.

A mutant is a small change of a text of the product: the filter's C without tensions, the lanes without stops. Each goes
through the robots that have its feature, in a copy of the tree, until a check fails: then it is *found*. The table
stands in `forgotten`; the order is drawn once, with a fixed seed. A check that finds one must hold without any.
"""

from __future__ import annotations

import importlib
import os
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
TREE = TESTS.parent
sys.path[0] = str(TESTS)  # in place of the folder of this file, whose modules have names of libraries

from conformance.arrays import covering  # noqa: E402
from conformance.features import features  # noqa: E402
from conformance.forgotten import Mutant, drawn  # noqa: E402

COPIED = ("screwgen", "templates", "tests")
SHARED = "numpy scipy.optimize scipy.linalg sympy casadi jax pinocchio pydantic jinja2 pytest typer hypothesis".split()
"""Libraries that are loaded once for all mutants."""
HEAVY = ("mock-up unit", "C folder", "commands")
ROBOTS, OTHERS = 12, 2
"""Robots that meet the check of the consumer, and those that meet all others."""
PATIENCE = 1200
"""Seconds that one mutant may take."""


def rows_of(feature: str) -> list[int]:
    """The robots with a feature, those with few others first."""
    return sorted(
        (k for k, row in enumerate(covering()) if feature in features(row)), key=lambda k: len(features(covering()[k]))
    )[:ROBOTS]


def copy_of_tree(folder: Path) -> None:
    """What is mutated is copied, the rest linked."""
    for entry in TREE.iterdir():
        if entry.name in COPIED:
            shutil.copytree(entry, folder / entry.name, ignore=shutil.ignore_patterns("__pycache__", "node_modules"))
        elif not entry.name.startswith("."):
            (folder / entry.name).symlink_to(entry)


def forget_compiled(path: Path) -> None:
    """Python's own copy of a module, which two changes within a second would leave in place."""
    for old in (path.parent / "__pycache__").glob(f"{path.stem}.*"):
        old.unlink()


# ------------------------------------------------------------------------------------------- in the process of a mutant


Cell = tuple[int, str]
"""A robot and a check."""


def cells(mutant: Mutant, names: list[str]) -> list[Cell]:
    """The check of the consumer first, heavy ones last."""
    rows = rows_of(mutant.feature)
    light, heavy = ([name for name in names if (name in HEAVY) == kind] for kind in (False, True))
    others = [(k, name) for some in (light, heavy) for k in rows[:OTHERS] for name in some if name != mutant.consumer]
    return [(k, mutant.consumer) for k in rows] + others


def prepared(folder: Path) -> dict[str, Callable]:
    """The checks of the copy in `folder`, with the manners of the tests: what is compiled is not optimised."""
    for name in [x for x in sys.modules if x.split(".")[0] in ("conformance", "screwgen", "conftest")]:
        del sys.modules[name]
    sys.path[:0] = [str(folder), str(folder / "tests")]
    os.environ["PYTHONPATH"] = f"{folder}:{folder / 'tests'}"
    os.chdir(folder)
    importlib.invalidate_caches()
    import conftest

    conftest._compile_quickly()
    from screwgen.robot_model import RobotModel

    RobotModel.compiler_flags = ("-O0",)
    from conformance.checks import CHECKS

    return CHECKS


def first_failure(folder: Path, mutant: Mutant, broken: set[Cell]) -> str:
    """The first check that fails with the copy in `folder`, and on which robot; "" if all but the `broken` hold."""
    names = prepared(folder)
    for number, name in cells(mutant, list(names)):
        if (number, name) not in broken and (said := failure(number, name)):
            return f"{name}|{number}|{said}"
    return ""


def failure(number: int, name: str) -> str:
    """What a check says of a robot, "" if it holds or refuses as it should."""
    from conformance.cases import case_of
    from conformance.checks import outcome

    try:
        outcome(name, case_of(tuple(covering()[number].items()), number))
    except Exception as error:
        return f"{type(error).__name__}: {' '.join(str(error).split())[:160]}"
    return ""


def apart(work: Callable[[], str]) -> str:
    """What a function returns in a process of its own, which is a copy of this one."""
    there, here = os.pipe()
    child = os.fork()
    if child == 0:
        signal.alarm(PATIENCE)
        out = f"||{sys.exc_info()}"
        with suppress(BaseException):
            out = work()
        os.write(here, out.encode()[:4000])
        os._exit(0)
    os.close(here)
    with os.fdopen(there, "rb") as pipe:
        said = pipe.read().decode()
    os.waitpid(child, 0)
    return said


# ------------------------------------------------------------------------------------------------------------ the table


def tried(folder: Path, mutant: Mutant, broken: set[Cell]) -> str:
    """The first failure with a mutant; the copy is as before afterwards."""
    path = folder / mutant.file
    text = path.read_text(encoding="utf-8")
    forget_compiled(path)
    path.write_text(mutant.applied(text), encoding="utf-8")
    try:
        return apart(lambda: first_failure(folder, mutant, broken))
    finally:
        path.write_text(text, encoding="utf-8")
        forget_compiled(path)


def verdict(folder: Path, mutant: Mutant, sound: dict[Cell, str]) -> str:
    """What finds a mutant, "" if nothing does; `sound`: what checks say without any, tried where they fail."""
    while True:
        broken = {cell for cell, said in sound.items() if said}
        check, _, rest = tried(folder, mutant, broken).partition("|")
        row, _, said = rest.partition("|")
        if not check:
            return said
        cell = (int(row), check)
        if cell not in sound:
            sound[cell] = apart(lambda cell=cell: prepared(folder) and failure(*cell))
        if not sound[cell]:
            return f"found by {check}, robot {row}: {said}"
        print(f"  without a mutant {check}, robot {row}, fails: {sound[cell]}", flush=True)


def main(first: int = 0, last: int = 40) -> int:
    """Runs the mutants first to last of those drawn; 1 if one is missed, or a check fails without any."""
    covering()
    for name in SHARED:
        importlib.import_module(name)
    sys.dont_write_bytecode = False
    missed = 0
    sound: dict[Cell, str] = {}
    with tempfile.TemporaryDirectory(prefix="screwgen-mutants-") as place:
        folder = Path(place) / "tree"
        folder.mkdir()
        os.environ |= {"SCREWGEN_CACHE": f"{place}/cache", "TMPDIR": place, "SYMPY_CACHE_SIZE": "20000"}
        tempfile.tempdir = place
        copy_of_tree(folder)
        for number, mutant in list(enumerate(drawn()))[first:last]:
            start = time.time()
            said = verdict(folder, mutant, sound)
            missed += not said.startswith("found")
            took = f"{time.time() - start:.0f} s"
            print(f"{number} {mutant}: {said if said.startswith('found') else 'MISSED ' + said} [{took}]", flush=True)
    return int(missed > 0 or any(sound.values()))


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3])))
