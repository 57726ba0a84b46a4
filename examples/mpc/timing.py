"""Latency of the generated controller, measured in C on the samples of a closed loop."""

from __future__ import annotations

import platform
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from screwgen import ScrewgenError
from screwgen.runtime.library import compiler_command

from .arms import PAYLOAD, Arms
from .generated import FILE, Sampled

FLAGS = ("-std=gnu99", "-O3")
MARKS = {"median": 50, "p99": 99, "p99.9": 99.9, "max": 100}
SAME = 1e-6
"""N·m: how far the torques may be from those of the closed loop, which another build of the same C found."""


@dataclass(frozen=True)
class Latency:
    """Seconds of every sample, (N,) each."""

    wall: dict[str, np.ndarray]
    """By phase: `preparation`, `feedback` and their `sum`."""
    cpu: dict[str, np.ndarray]
    """The same in processor time of the thread."""
    bound: bool
    """Whether the thread was bound to one core."""


def measured(arms: Arms, samples: list[Sampled], extra: float, repeats: int) -> dict[str, Latency]:
    """The samples again, `repeats` times: by caches, `warm` from the sample before or `cold`."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        build(arms, folder)
        rows = [np.concatenate([s.state, s.reference.ravel(), s.u[0]]) for s in samples]
        np.array(rows).tofile(folder / "record")
        mass = arms.model.parameter_values[arms.model.parameter_names.index(PAYLOAD)] + extra
        return {name: run(folder, repeats, mass, *word) for name, word in (("warm", ()), ("cold", ("cold",)))}


def build(arms: Arms, folder: Path) -> None:
    """The generated C and `timing.c`, compiled into `folder`."""
    for name, content in arms.model.c_files(mpc=FILE).items():
        target = folder / name
        target.parent.mkdir(exist_ok=True)
        target.write_bytes(content)
    driver = Path(__file__).with_name("timing.c")
    sources = [str(p) for p in folder.glob("ella*.c")]
    call([*compiler_command(), *FLAGS, f"-I{folder}", "-o", str(folder / "timing"), str(driver), *sources, "-lm"])


def run(folder: Path, repeats: int, mass: float, *word: str) -> Latency:
    said = call([str(folder / "timing"), "record", "times", str(repeats), repr(float(mass)), *word], cwd=folder)
    worst, bound = said.split()
    if not float(worst) <= SAME:
        raise ScrewgenError(f"timing: torques differ by {worst} N·m from those of the closed loop")
    rows = np.fromfile(folder / "times").reshape(-1, 4)
    named = lambda pair: dict(zip(("preparation", "feedback", "sum"), (*pair.T, pair.sum(axis=1)), strict=True))  # noqa: E731
    return Latency(named(rows[:, :2]), named(rows[:, 2:]), bound == "1")


def call(command: list[str], **options) -> str:
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode:
        raise ScrewgenError(f"timing: {Path(command[0]).name} failed: {(done.stderr or done.stdout).strip()[:500]}")
    return done.stdout


def percentiles(times: dict[str, np.ndarray]) -> dict[str, dict[str, float]]:
    """ms, by phase and mark."""
    return {phase: {m: float(1e3 * np.percentile(t, q)) for m, q in MARKS.items()} for phase, t in times.items()}


def machine() -> str:
    """Processor and compiler."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        name = next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        name = platform.machine()
    return f"{name}; {call([*compiler_command(), '--version']).splitlines()[0]} {' '.join(FLAGS)}"
