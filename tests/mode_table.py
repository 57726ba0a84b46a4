"""Which basis, how many modes: errors of natural frequencies against finite elements, and operations, as a table.

    python tests/mode_table.py [--counts 1,2,3,4,6]

The robots are those of `beam_arms`: three random arms in space, joints locked and free, and two welded links without
bodies. Every link has n bending modes per plane, and n/2, rounded up, in stretching and in torsion. A cell gives
the largest error of the eight lowest frequencies, and behind it that of the three lowest. About two minutes.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator

import numpy as np
from beam_arms import random_arm, welded_corner, with_modes
from beam_elements import LOWEST, frequencies
from helpers import model_of

from screwgen.backends.c.project import CProject
from screwgen.studies.modes import natural_frequencies

BASES, FEW = ("clamped_free", "polynomial"), 3
HEAD = "| basis | n | 2 links | 3 links | 5 links | corner | operations: 2 links | 5 links |"


def robots() -> list[tuple[dict, list[float]]]:
    """Robots and postures, in the order of the table's columns."""
    return [*(random_arm(n) for n in (2, 3, 5)), (welded_corner(), [])]


def errors(robot: dict, q) -> tuple[float, float]:
    """The largest relative error of the eight lowest and of the three lowest, joints locked and free."""
    model, worst = model_of(robot), np.zeros(LOWEST)
    for joints in ("locked", "free"):
        found = natural_frequencies(model, q, joints)
        found = found[found > 0][:LOWEST]
        off = np.abs(found / frequencies(robot, q, joints)[: len(found)] - 1)
        worst = np.maximum(worst, np.append(off, np.zeros(LOWEST - len(off))))
    return float(worst.max()), float(worst[:FEW].max())


def operations(robot: dict) -> int:
    """Operations of one forward dynamics, as the generated header states them."""
    return CProject(model_of(robot).chain, "arm", "runtime", "auto").operations["total"]


def row(basis: str, count: int) -> str:
    """A line of the table."""
    shaped = [(with_modes(robot, count, -(-count // 2), basis), q) for robot, q in robots()]
    cells = [" / ".join(percent(e) for e in errors(robot, q)) for robot, q in shaped]
    counts = [grouped(operations(robot)) for robot, _ in (shaped[0], shaped[2])]
    return "| " + " | ".join([f"`{basis}`", str(count), *cells, *counts]) + " |"


def grouped(count: int) -> str:
    return f"{count:,}".replace(",", " ")


def percent(error: float) -> str:
    """Two significant digits; what is below 1e-6 only as that."""
    value = 100 * error
    return "< 0.0001" if value < 1e-4 else f"{value:.0f}" if value >= 9.5 else f"{float(f'{value:.2g}'):.7g}"


def lines(counts: list[int]) -> Iterator[str]:
    """The table in Markdown, errors in %."""
    yield HEAD
    yield "|---|" + 7 * "--:|"
    for basis in BASES:
        for count in counts:
            yield row(basis, count)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--counts", default="1,2,3,4,6")
    for line in lines([int(n) for n in parser.parse_args().counts.split(",")]):
        print(line, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
