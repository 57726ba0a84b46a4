"""How often intervals hold the true number, in logs with other noise: `python tests/covered_runs.py gantry 200`."""

from __future__ import annotations

import sys
from time import process_time

import numpy as np
from test_identify_coverage import gantry, noisy, pendulum

import screwgen


def main(robot: str, runs: int, first: int = 0) -> None:
    """A line every 20 runs, the shares of each number at the end."""
    model, clean, true, columns = {"gantry": gantry, "pendulum": pendulum}[robot]()
    held, began = np.zeros((0, len(true))), process_time()
    for seed in range(first, first + runs):
        log = noisy(clean, seed, [column.name for column in columns.sensors])
        found = screwgen.identify(model, log, free=list(true), sensors=columns, window=0.5)
        held = np.vstack([held, [found[x].low <= value <= found[x].high for x, value in true.items()]])
        if len(held) % 20 == 0:
            print(f"{len(held)} runs, {process_time() - began:.0f} s: {held.mean():.2%}", flush=True)
    for name, share in zip(true, held.mean(axis=0), strict=True):
        print(f"{name}: {share:.1%}")
    print(f"{robot}, {len(held)} runs, intervals that hold the number: {held.mean():.2%}")


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
