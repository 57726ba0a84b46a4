"""The paper's task, run with every method, and all that is measured on it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from screwgen import Run
from screwgen.simulation.motion import amplitude_spectrum, modal_columns, tip_deformation, tip_position

from . import frequencies, growth, numbers
from .arm import MOVE, STEP, Arm, load, start
from .motions import BESIDE, PRINTED, REFERENCE, Library, Motion, Way, follow, recorded

PEAKS = 2
"""How many peaks of a spectrum are named."""


@dataclass(frozen=True)
class Extent:
    """How much is computed."""

    duration: float
    """s: of the task."""
    growth_duration: float
    """s: of each run that growth is observed in, at most."""
    bases: tuple
    dpi: int
    flags: tuple[str, ...]
    """Of the C compiler."""


FULL = Extent(8.0, 4.0, frequencies.BASES, 150, ("-O2",))
QUICK = Extent(2.4, 0.3, frequencies.QUICK, 50, ("-O0",))


@dataclass(frozen=True)
class Comparison:
    """A way of stepping the task, beside the reference with the same modes."""

    name: str
    axial: bool
    end: float
    """s: the last instant with a motion of sensible size."""
    complete: bool
    deviation: float | None
    """m: largest distance of the two tips, of a complete run."""


@dataclass(frozen=True)
class AxialStart:
    """What the printed axial displacement does to the arm, by Runge–Kutta: peaks of the first milliseconds."""

    duration: float
    tip_speed: float
    """m/s, relative to the base of link 2, along it."""
    elbow_force: float
    """N."""


@dataclass(frozen=True)
class Results:
    """Everything that figures and report show."""

    arm: Arm
    extent: Extent
    run: Run
    rigid: Run
    motions: list[tuple[Way, Motion, np.ndarray]]
    """Way, motion and the distance of its tip from the reference's (N,), m, at the motion's samples of 1 ms."""
    comparisons: list[Comparison]
    axial_influence: float
    """m: largest distance of the tips with and without axial modes."""
    growth: list[growth.Growth]
    histories: list[growth.History]
    frequencies: list[frequencies.Row]
    loops: list[frequencies.Loop]
    numbers: numbers.Numbers
    limits: list[tuple[str, float | None, float | None]]
    axial_start: AxialStart
    peaks: list[list[tuple[float, float]]]
    """Per inertial component the largest peaks of the deformation's spectrum after the motion: Hz, m."""


def compute(extent: Extent, progress: Callable[[str], None]) -> Results:
    """All of it; `progress(what)` is called before each part."""
    arm = load()
    library = Library(arm, extent.flags)
    progress("derive and compile the arm with, without axial modes, rigid and locked")
    for name in ("axial", "bending", "rigid", "locked"):
        library[name]
    progress(f"the task for {extent.duration:g} s: modal midpoint, and the rigid arm")
    run = recorded(library, "axial", start(arm.axial), extent.duration)
    rigid = recorded(library, "rigid", np.zeros(3), extent.duration)
    motions, influence = compare(library, extent.duration, progress)
    rows = growth.table(library, extent.growth_duration, lambda name: progress(f"growth: {name}"))
    progress("natural frequencies")
    return Results(
        arm=arm,
        extent=extent,
        run=run,
        rigid=rigid,
        motions=motions,
        comparisons=[comparison(arm, *row) for row in motions],
        axial_influence=influence,
        growth=[growth.in_the_task(library, PRINTED), *(row for row, _ in rows)],
        histories=[history for _, history in rows],
        frequencies=frequencies.table(arm, extent.bases),
        loops=frequencies.loops(arm),
        numbers=numbers.compute(arm),
        limits=growth.step_limits(arm),
        axial_start=axial_start(library),
        peaks=[largest_peaks(*spectrum(arm, run, k, MOVE)) for k in range(3)],
    )


def compare(library: Library, duration: float, progress) -> tuple[list[tuple[Way, Motion, np.ndarray]], float]:
    """The task in every way, each from the paper's start, the printed axial displacement in the printed way alone."""
    out, tips = [], {}
    for name in ("axial", "bending"):
        progress(f"reference: {REFERENCE.name}{'' if name == 'axial' else ', no axial modes'}")
        motion = run_task(library, replace(REFERENCE, model=name), duration)
        tips[name] = tip_position(getattr(library.arm, name), motion.q)
    for way in (PRINTED, *BESIDE):
        progress(f"beside it: {way.name}")
        motion = run_task(library, way, duration)
        every = round(STEP / way.sample)
        tip = tip_position(getattr(library.arm, way.model), motion.q[::every])
        out.append((way, motion, np.linalg.norm(tip - tips[way.model][: len(tip)], axis=1)))
    return out, float(np.linalg.norm(tips["axial"] - tips["bending"], axis=1).max())


def run_task(library: Library, way: Way, duration: float) -> Motion:
    model = getattr(library.arm, way.model)
    return follow(library[way.model], library.arm.law(), start(model, axial=way is PRINTED), way, duration)


def comparison(arm: Arm, way: Way, motion: Motion, distance: np.ndarray) -> Comparison:
    axial = bool(modal_columns(getattr(arm, way.model), 1, "axial"))
    end = float(motion.t[-1])
    return Comparison(way.name, axial, end, motion.complete, float(distance.max()) if motion.complete else None)


def axial_start(library: Library) -> AxialStart:
    """The reference method from the printed start, axial displacement included, for three milliseconds."""
    model, compiled, duration = library.arm.axial, library["axial"], 3e-3
    way = replace(REFERENCE, step=1e-6, substeps=10)
    motion = follow(compiled, library.arm.law(), start(model, axial=True), way, duration)
    column = modal_columns(model, 1, "axial")[0]
    free, law = np.zeros((2, 6)), library.arm.law()
    samples = zip(motion.t, motion.q, motion.v, strict=True)
    forces = [compiled.forward_dynamics(q, v, law(t, q, v), free)[1][1, 3:] for t, q, v in samples]
    speed = float(np.abs(motion.v[:, column]).max() * np.sqrt(2))
    return AxialStart(duration, speed, float(np.linalg.norm(forces, axis=1).max()))


def spectrum(arm: Arm, run: Run, component: int, since: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies, Hz, and amplitudes, m, of a component of the end-point deformation from `since` s on.

    The whole run is not tapered: what the start sets off dies out early.
    """
    rows = run.t >= since - STEP / 2
    f, a = amplitude_spectrum(run.t[rows], tip_deformation(arm.axial, run.q[rows])[:, component], since > 0)
    return f, a[:, 0]


def largest_peaks(f: np.ndarray, a: np.ndarray) -> list[tuple[float, float]]:
    """The largest local maxima above 1 Hz, each at least a hundredth of the largest, Hz and m, by size."""
    inside = [k for k in range(1, len(f) - 1) if f[k] > 1.0 and a[k - 1] < a[k] >= a[k + 1]]
    found = sorted(inside, key=lambda k: -a[k])[:PEAKS]
    return [(float(f[k]), float(a[k])) for k in found if a[k] > 0.01 * a[found[0]]]


def reference(arm: Arm, t: np.ndarray) -> np.ndarray:
    """The minimum-jerk references (N, 3), rad."""
    law = arm.law()
    return np.array([law.reference(x)[0] for x in t])
