"""What an unknown payload does to an arm: 100,000 rollouts of ELLA, on all cores, into a file.

The arm starts at rest, held against gravity with the payload of the file; the same torques swing it while the
payload is another. Kept of every scenario is the error of the tip over time. Writes build/monte_carlo.npy and .png; a
sweep that was stopped goes on where it was. Some minutes; `--short`: 2,000 scenarios, seconds; `--workers N`: threads.
"""

from __future__ import annotations

import argparse
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import screwgen
from screwgen.plotting.look import PALETTE, canvas, png, styled

ROOT = Path(__file__).resolve().parents[1]
PAYLOAD, NOMINAL, SPREAD = "forearm.bodies[0].mass", 2.1, 0.4
"""kg; the payload is normally distributed with this standard deviation."""
STEP, SAMPLES, SUBSTEPS = 0.02, 30, 10
POSTURE, SWING = [0.3, 0.2, -0.9], np.array([12.0, 8.0, 5.0])
"""rad; N·m."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--workers", type=int, default=2)
    given = parser.parse_args()
    count = 2000 if given.short else 100_000
    store = ROOT / "build" / f"monte_carlo{'_short' * given.short}.npy"
    store.parent.mkdir(exist_ok=True)
    for old in store.parent.glob(f"{store.stem}.*") if given.short else ():
        old.unlink()
    model = screwgen.derive(screwgen.load(ROOT / "examples" / "ella.toml"))
    start, tau = swing(model)
    p = np.array(model.parameter_values)
    aim = tips(model, screwgen.rollout(model, start, tau, step=STEP, substeps=SUBSTEPS), p)[0]

    def draw(rng: np.random.Generator, n: int) -> dict:
        masses = rng.normal(NOMINAL, SPREAD, n).clip(0.5)
        return {"x0": np.tile(start, (n, 1)), "tau": tau, "parameters": {PAYLOAD: masses}}

    def error(run: screwgen.Rollout) -> np.ndarray:
        return np.linalg.norm(tips(model, run, p) - aim, axis=2).astype(np.float32)

    clock = time.perf_counter()
    with ThreadPoolExecutor(given.workers) as threads:
        how = {"step": STEP, "steps": SAMPLES, "substeps": SUBSTEPS, "executor": threads, "progress": told}
        found = screwgen.sweep(model, draw, count, store, keep=error, **how)
    print(f"\n{count} scenarios in {time.perf_counter() - clock:.1f} s; {(~found.ok).sum()} stopped")
    low, half, high = 1e3 * np.percentile(found.values[:, -1], (5, 50, 95))
    print(f"tip error at the end: 5 % below {low:.1f} mm, half below {half:.0f}, 95 % below {high:.0f}")
    assert found.ok.all() and 0 < low < half < high
    store.with_suffix(".png").write_bytes(picture(found.values))
    print(f"build/{store.name}, build/{store.stem}.png")


def told(done: int, count: int) -> None:
    """A bar on one line."""
    print(f"\r[{'#' * (40 * done // count):40}] {done}/{count}", end="", file=sys.stderr, flush=True)


def swing(model) -> tuple[np.ndarray, np.ndarray]:
    """The state at rest with the file's payload, and torques (samples, 3): those that hold it, and a swing."""
    rest = screwgen.equilibrium(model, POSTURE)
    phase = 2 * np.pi * (np.arange(SAMPLES) + 0.5) / SAMPLES
    return np.concatenate([rest.q, np.zeros(model.nv)]), rest.tau + np.sin(phase)[:, None] * SWING


def tips(model, run: screwgen.Rollout, p: np.ndarray) -> np.ndarray:
    """The positions of the last tip (batch, samples, 3), m."""
    count, samples, nq = run.q.shape
    pose = model.once(("tips", count * samples), lambda: model.casadi()["tip_pose"].map(count * samples))
    return np.array(pose(run.q.reshape(-1, nq).T, p)[1]).T.reshape(count, samples, 3)


@styled
def picture(errors: np.ndarray) -> bytes:
    """The fan of the tip errors over time, and their distribution at the end."""
    figure = canvas(9.0, 3.8)
    left, right = figure.subplots(1, 2, width_ratios=(2, 1))
    t, e = STEP * np.arange(errors.shape[1]), 1e3 * np.asarray(errors)
    for share, shade in ((98, 0.15), (80, 0.25), (50, 0.4)):
        ends = np.percentile(e, (50 - share / 2, 50 + share / 2), axis=0)
        left.fill_between(t, *ends, color=PALETTE[0], alpha=shade, linewidth=0, label=f"{share} %")
    left.plot(t, np.median(e, axis=0), color=PALETTE[1], label="median")
    left.set(title=f"Tip error of {len(e):,} payloads", xlabel="time (s)", ylabel="mm")
    left.legend(loc="upper left")
    right.hist(e[:, -1], bins=80, color=PALETTE[0], density=True)
    right.set(title="At the end", xlabel="mm", yticks=[])
    return png(figure)


if __name__ == "__main__":
    main()
