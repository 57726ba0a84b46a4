"""Time per step of the two-link flexible pendulum against Exudyn, at equal accuracy of the tip.

Both swing for one second from horizontal, straight and at rest. The judge is Exudyn with 16 cables (ANCF, geometrically
exact) per link and steps of 0.1 ms. Whoever ends within ``BOUND`` of its tip counts; of each side the run that
takes the least time is measured, from all combinations of its discretisation, integrator and step below.
"""

from __future__ import annotations

import math
import os
import shutil
import statistics
import subprocess
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import count
from pathlib import Path

import robots
from contenders import Missing, screwgen_library
from native import COMMON, HERE, LEVELS, Compiler, command
from table import Row, spread

import screwgen

BOUND = 1e-4
"""m of 1.88 m reach."""

JUDGE = (16, 10000, False)
MESH = (8, 1000, True)
"""The mesh that one would take without trying: 8 elements per link, 1 ms."""

ELEMENTS, EXUDYN_STEPS = (1, 2, 4), (200, 500, 1000)
MODES, METHODS, STEPS = (1, 2), ("rk4", "modal_midpoint", "semi_implicit"), (200, 500, 1000, 2000, 4000)
ROUNDS, RUNS = 15, 200
HEADING = (
    "{what}, two flexible links, by the cheapest runs that end within {bound:g} mm;\n{errors}; ratio: time / screwgen"
)

Tip = tuple[float, float]


@dataclass
class Candidate:
    """A way to compute the pendulum: ``run()`` gives processor seconds and the tip (x, z)."""

    title: str
    steps: int
    run: Callable[[], tuple[float, Tip]]
    seconds: float = math.inf
    error: float = math.inf


def rows(folder: Path, compiler: Compiler, progress) -> tuple[list[Row], list[str]]:
    """The rows, and one line if Exudyn is missing."""
    try:
        judge = exudyn_run(*JUDGE)()[1]
    except Missing as reason:
        return [], [f"pendulum: no rows: {reason}"]
    progress.stage("pendulum: searching the cheapest runs within the bound")
    own = cheapest([c for m in MODES for c in our_candidates(folder, compiler, m)], judge)
    other = cheapest([exudyn_candidate(e, n, m) for e in ELEMENTS for n in EXUDYN_STEPS for m in (True, False)], judge)
    mesh = exudyn_candidate(*MESH)
    progress.stage("pendulum: timing")
    times = {id(c): [] for c in (own, other, mesh)}
    for k in range(ROUNDS):
        with processor(k):
            for c in (own, other, mesh):
                times[id(c)].append(c.run()[0])
    mesh.error = distance(mesh.run()[1], judge)
    for copy in folder.glob("*.run[0-9]*"):
        copy.unlink()
    errors = ", ".join(f"{1e6 * c.error:.0f}" for c in (own, other, mesh))
    out = []
    for what, scale, bound in (
        ("a step of the pendulum", lambda c: c.steps, 100.0),
        ("a second of the pendulum", lambda c: 1, None),
    ):
        heading = HEADING.format(what=what, bound=1e3 * BOUND, errors=f"their tips are off by {errors} µm")
        for c in (own, other, mesh):
            mine, base = ([t / scale(x) for t in times[id(x)]] for x in (c, own))
            ratio = statistics.median(a / b for a, b in zip(mine, base, strict=True))
            title, target = f"{c.title}, {1e3 / c.steps:g} ms", (bound if c is other else None, None)
            out.append(Row(heading, title, statistics.median(mine), ratio, spread(mine), target))
    return out, []


@contextmanager
def processor(number: int) -> Iterator[None]:
    """All on one of the machine's processors, which may have neighbours that others have not."""
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    allowed = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {sorted(allowed)[number % len(allowed)]})
    try:
        yield
    finally:
        os.sched_setaffinity(0, allowed)


def cheapest(candidates: list[Candidate], judge: Tip) -> Candidate:
    """The candidate that takes the least time of those that end within the bound."""
    for c in candidates:
        try:
            (c.seconds, tip), again = c.run(), c.run()[0]
        except (subprocess.SubprocessError, ArithmeticError, RuntimeError):
            continue
        c.seconds, c.error = min(c.seconds, again), distance(tip, judge)
    within = [c for c in candidates if c.error <= BOUND]
    if not within:
        raise Missing(f"pendulum: no run ends within {BOUND} m of the judge")
    return min(within, key=lambda c: c.seconds)


def distance(a: Tip, b: Tip) -> float:
    return math.hypot(a[0] - b[0], a[1] - b[1])


# --------------------------------------------------------------------------------------------- screwgen


def our_candidates(folder: Path, compiler: Compiler, modes: int) -> list[Candidate]:
    """Every integrator and step for one number of modes per link."""
    model = screwgen.derive(robots.pendulum(modes))
    library, r = screwgen_library(model, "fused", "runtime", "pendulum"), model.robot.name
    place, program, numbers = folder / r, folder / f"{r}.run", count()
    place.mkdir(parents=True, exist_ok=True)
    for name, text in library.files.items():
        (place / name).write_text(text)
    methods = " ".join(f"METHOD({m})" for m in METHODS)
    defines = [f"-DROBOT={r}", f'-DHEADER="{r}.h"', f"-DMETHODS={methods}"]
    flags = [*COMMON, *LEVELS[compiler.level], *defines, "-I", place, "-I", HERE, "-Wl,--gc-sections"]
    command(compiler.name, *flags, HERE / "pendulum.c", *(place / s for s in library.sources), "-lm", "-o", program)

    def run(method: str, steps: int) -> Callable[[], tuple[float, Tip]]:
        def call():
            copy = folder / f"{r}.run{next(numbers)}"  # kept: a file's pages lie well or badly in the caches for good
            shutil.copy(program, copy)
            said = subprocess.run([copy, method, str(steps), str(RUNS)], capture_output=True, text=True, check=True)
            seconds, x, z = map(float, said.stdout.split())
            return seconds, (x, z)

        return call

    title = f"screwgen, {modes} mode{'s' * (modes > 1)}, "
    return [Candidate(title + m, n, run(m, n)) for m in METHODS for n in STEPS]


# ----------------------------------------------------------------------------------------------- Exudyn


def exudyn_candidate(elements: int, steps: int, modified: bool) -> Candidate:
    return Candidate(f"Exudyn, {elements} cable{'s' * (elements > 1)}", steps, exudyn_run(elements, steps, modified))


def exudyn_run(elements: int, steps: int, modified: bool) -> Callable[[], tuple[float, Tip]]:
    """A run with so many ANCF cables per link; ``modified``: Newton's method keeps its Jacobian while it can."""
    try:
        import exudyn as exu
        from exudyn import beams, utilities
    except ImportError as error:
        raise Missing(f"the Python package 'exudyn' is not installed ({error})") from None

    def run() -> tuple[float, Tip]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # names that later versions of Exudyn spell otherwise
            system, mbs, tip = _arm(exu, beams, utilities, elements)
            settings = _settings(exu, steps, modified)
        clock = time.process_time()
        if not mbs.SolveDynamic(settings):
            raise RuntimeError("Exudyn did not converge")
        seconds = time.process_time() - clock
        x, y, _ = mbs.GetNodeOutput(tip, exu.OutputVariableType.Position)
        system.Reset()
        return seconds, (float(x), float(y))

    return run


def _arm(exu, beams, utilities, elements: int):
    """Exudyn's container, which must outlive the rest, its system and the node of the tip."""
    x, system = robots.PENDULUM, exu.SystemContainer()
    mbs = system.AddSystem()
    first, second = x["lengths"]
    cable = utilities.Cable2D(
        physicsMassPerLength=x["rhoA"], physicsBendingStiffness=x["EI"], physicsAxialStiffness=x["EA"]
    )
    load = [0.0, robots.GRAVITY[2], 0.0]
    make = beams.GenerateStraightLineANCFCable2D
    upper = make(mbs, [0, 0, 0], [first, 0, 0], elements, cable, load, fixedConstraintsNode0=[1, 1, 0, 0])
    lower = make(mbs, [first, 0, 0], [first + second, 0, 0], elements, cable, load)
    ends = [mbs.AddMarker(utilities.MarkerNodePosition(nodeNumber=n)) for n in (upper[0][-1], lower[0][0])]
    mbs.AddObject(utilities.RevoluteJoint2D(markerNumbers=ends))
    mbs.Assemble()
    return system, mbs, lower[0][-1]


def _settings(exu, steps: int, modified: bool):
    """Generalised-α with tolerances that stiff axial terms allow; nothing written, nothing said."""
    s = exu.SimulationSettings()
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = 1.0, steps
    s.timeIntegration.verboseMode = 0
    s.timeIntegration.newton.useModifiedNewton = modified
    s.timeIntegration.newton.relativeTolerance = 1e-6
    s.timeIntegration.newton.absoluteTolerance = 1e-8
    s.solutionSettings.writeSolutionToFile = False
    s.solutionSettings.sensorsWritePeriod = 1.0
    return s
