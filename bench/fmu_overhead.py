"""What a step costs through FMI: a unit's fmi2DoStep beside the C's own step, in turns in one process on one core.

    python bench/fmu_overhead.py [ROBOT.toml ...] [--turns 40]

The states at the end of every turn must be equal bit by bit.
"""

from __future__ import annotations

import argparse
import re
import statistics
import subprocess
import tempfile
import zipfile
from pathlib import Path

import screwgen

HERE = Path(__file__).resolve().parent
ROBOTS = ("ella_paper", "six_link", "elastic_joint")
FLAGS = ("-std=gnu99", "-O2")
STEP = 1e-4


def measured(file: Path, turns: int, steps: int) -> tuple[str, list[list[float]]]:
    """The robot's name, and seconds per step of the C, of the unit, and of the unit with values set and read."""
    model = screwgen.derive(screwgen.load(file))
    name = model.robot.name
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        model.write(folder / "out", targets=("fmu2",))
        with zipfile.ZipFile(folder / "out" / "fmu2" / f"{name}.fmu") as archive:
            archive.extractall(folder)
        sources = [str(path) for path in sorted((folder / "sources").glob("*.c")) if path.name != "fmu2.c"]
        subprocess.run(["cc", *FLAGS, "-fPIC", "-shared", "-o", folder / "model.so", *sources, "-lm"], check=True)
        text = (folder / "modelDescription.xml").read_text(encoding="utf-8")
        first = lambda variable: re.search(rf'name="{re.escape(variable)}" valueReference="(\d+)"', text)[1]  # noqa: E731
        defines = [
            f"-DROBOT(x)={name}_##x",
            f'-DHEADER="{name}.h"',
            f'-DNAME="{name}"',
            f"-DSTATES={model.nq + model.nv}",
        ]
        defines += [f"-DFIRST_STATE={first(model.q_names[0])}", f"-DFIRST_INPUT={first(model.tau_names[0])}"]
        program = [str(folder / "loop"), str(folder / "model.so"), str(folder / "binaries" / "linux64" / f"{name}.so")]
        command = ["cc", *FLAGS, *defines, "-I", folder / "sources", "-o", program[0], HERE / "fmu_overhead.c", "-ldl"]
        subprocess.run(command, check=True)
        token = re.search(r'guid="([^"]*)"', text)[1]
        numbers = (token, str(STEP), str(steps), str(turns))
        done = subprocess.run([*program, *numbers], check=True, capture_output=True, text=True)
    return name, [[float(x) for x in line.split()] for line in done.stdout.splitlines()]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("robots", nargs="*", type=Path)
    parser.add_argument("--turns", type=int, default=40)
    parser.add_argument("--steps", type=int, default=2000)
    given = parser.parse_args()
    for file in given.robots or [HERE.parent / "examples" / f"{name}.toml" for name in ROBOTS]:
        name, rows = measured(file, given.turns, given.steps)
        plain, unit, whole = (1e6 * min(column) for column in zip(*rows, strict=True))
        ratio = statistics.median(row[1] / row[0] for row in rows)
        print(f"{name}: C {plain:.3f} us, unit {unit:.3f} us, with values {whole:.3f} us; median ratio {ratio:.3f}")


if __name__ == "__main__":
    main()
