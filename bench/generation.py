"""Seconds from a robot to its files, in a process of its own so that nothing is derived yet. Prints JSON."""

import json
import sys
import tempfile
import time
from pathlib import Path

from robots import robot

import screwgen
from screwgen.build import TARGETS


def main() -> None:
    clock = time.perf_counter()
    model = screwgen.derive(robot(sys.argv[1]))
    seconds = {}
    with tempfile.TemporaryDirectory() as folder:
        for target in TARGETS:
            start = time.perf_counter()
            model.write(Path(folder) / target, [target])
            seconds[target] = time.perf_counter() - start
    print(json.dumps(seconds | {"together": time.perf_counter() - clock}))


if __name__ == "__main__":
    main()
