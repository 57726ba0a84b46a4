"""What calls from Python cost over the same C without Python: forward dynamics through `compile`, and `simulate`.

Times are those of the thread's processor, by turns. Also on its own: python bench/python_calls.py [ROUNDS]
"""

from __future__ import annotations

import ctypes
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import robots  # noqa: E402
from table import Row, printed, spread  # noqa: E402

import screwgen  # noqa: E402
from screwgen.backends.c.shim import shims  # noqa: E402
from screwgen.runtime import library  # noqa: E402

FLAGS = ("-O2",)
ROUNDS, CALLS, STEP = 41, 20_000, 1e-3
MOST = 3e-6
"""Seconds that a call from Python may cost more than one from C."""

CALL = "ella: forward dynamics from Python, 4 arrays in and 2 out; ratio: time over the first row's / 3 µs"
RUN = (
    "ella: simulate over the same loop in C, modal midpoint rule, both filling a new table of t, q, v, tau, wrench,\n"
    "tip position and energy; ratio: time / that of the loop with the same samples"
)


class Bare:
    """The same C with loops in C, in a library of its own."""

    def __init__(self, model):
        self.compiled = model.compile(flags=FLAGS)
        project, name = self.compiled.project, model.robot.name
        files = project.files() | shims(project) | {"bare.c": (HERE / "python_calls.c").read_text(encoding="utf-8")}
        defines = (f"-DROBOT={name}", f"-DROBOT_UPPER={name.upper()}", f'-DHEADER="{name}.h"')
        self.library = library.load(files, (*FLAGS, *defines), cache=False)
        for call in (self.library.bare_calls, self.library.bare_run):
            call.restype = ctypes.c_double

    def calls(self, count: int) -> float:
        return self.library.bare_calls(self.compiled.memory, count)

    def run(self, q0, steps: int, every: int) -> float:
        c = self.compiled
        c.q[:], c.v[:], c.tau[:], c.w_ext[:] = q0, 0, 0, 0
        width = 1 + 2 * c.model.nq + c.model.n_joints + 6 * c.model.n_links + 5
        table = np.empty((steps // every + 2 if every else 1, width))
        place = ctypes.c_void_p(table.ctypes.data)
        seconds = self.library.bare_run(c.memory, steps, every, ctypes.c_double(STEP), place)
        if seconds < 0:
            raise SystemExit("python_calls: the loop in C fails")
        return seconds


def timed(work: Callable[[], object], count: int = 1) -> float:
    clock = time.thread_time()
    for _ in range(count):
        work()
    return (time.thread_time() - clock) / count


def call_rows(model, bare: Bare, rounds: int) -> list[Row]:
    """Arrays that fit, as they are; new ones for every call; lists, which are converted."""
    rng, c = np.random.default_rng(0), bare.compiled
    given = (
        *(0.05 * rng.normal(size=(2, model.nq))),
        rng.normal(size=model.n_joints),
        rng.normal(size=(model.n_links, 6)),
    )
    lists, out = [x.tolist() for x in given], (np.zeros(model.nq), np.zeros((model.n_links, 6)))
    ways = {
        "in C": None,
        "arrays": lambda: c.forward_dynamics(*given),
        "arrays, out=": lambda: c.forward_dynamics(*given, out=out),
        "lists": lambda: c.forward_dynamics(*lists),
    }
    c.forward_dynamics(*given)
    times = {title: [] for title in ways}
    for _ in range(rounds):
        for title, way in ways.items():
            times[title].append(bare.calls(CALLS) if way is None else timed(way, CALLS // 10))
    rows = []
    for title, mine in times.items():
        over = statistics.median(a - b for a, b in zip(mine, times["in C"], strict=True))
        target = (None, 1.0) if title.startswith("arrays") else (None, None)
        rows.append(Row(CALL, title, statistics.median(mine), over / MOST, spread(mine), target))
    return rows


def run_rows(model, bare: Bare, rounds: int) -> list[Row]:
    """Runs of several lengths, and what sampling costs."""
    q0 = [0.2, 0.5, -0.8, *[0.0] * 6]
    screwgen.simulate(model, 10 * STEP, STEP, q0, backend="c")
    rows = []
    for steps, every in ((2_000, 1), (20_000, 1), (20_000, 10)):
        kinds = {
            "the loop in C": lambda n=steps, e=every: bare.run(q0, n, e),
            "simulate": lambda n=steps, e=every: timed(
                lambda: screwgen.simulate(model, n * STEP, STEP, q0, every=e, backend="c")
            ),
            "the loop in C, no samples": lambda n=steps: bare.run(q0, n, 0),
        }
        times = {title: [kind()] for title, kind in kinds.items()}
        for _ in range(rounds):
            for title, kind in kinds.items():
                times[title].append(kind())
        base = times["the loop in C"]
        for title, mine in times.items():
            ratio = statistics.median(a / b for a, b in zip(mine, base, strict=True))
            target = (None, 1.2) if title == "simulate" else (None, None)
            name = f"{title}, {steps:,} steps" + (f", every {every}th kept" if every > 1 and title[-1] != "s" else "")
            rows.append(Row(RUN, name, statistics.median(mine), ratio, spread(mine), target))
    return rows


def rows(_folder, _compiler, progress) -> tuple[list[Row], list[str]]:
    """The rows of the group `python`; nothing can be missing."""
    progress.stage("python: compiling and timing")
    return measured(ROUNDS), []


def measured(rounds: int) -> list[Row]:
    model = screwgen.derive(robots.example("ella"))
    bare = Bare(model)
    return call_rows(model, bare, rounds) + run_rows(model, bare, rounds)


if __name__ == "__main__":
    print(printed(measured(int(sys.argv[1]) if len(sys.argv) > 1 else ROUNDS)))
