"""screwgen beside today's tools for the same work, each installed from PyPI: in one run, by turns, on one core.

python bench/peers.py [--only pinocchio,mujoco,soromox,pyelastica,exudyn,acados] [--level O3|native] [--out FOLDER]

Each heading says what both sides count. Results are compared before times are: who differs ends the run. A time is the
best of its rounds, of what a controller or a pendulum takes the median. Writes peers.csv, peers.md and peers.png. What
is missing costs rows, and the run says which. Some six minutes, half of them for compiling Pinocchio once.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pendulum
from contenders import Missing
from native import Compiler
from peers_control import acados
from peers_rigid import mujoco, pinocchio
from peers_soft import pyelastica, soromox
from plot import bars
from report import Progress
from table import Row, markdown, printed, write_csv

from screwgen.plotting.look import canvas, png, styled

ROOT = Path(__file__).resolve().parents[1]
Rows = Callable[[], list[Row]]


def main() -> int:
    given, progress, rows = _arguments(), Progress(), []
    peers = _peers(given.out, given.level, progress)
    asked = given.only.split(",") if given.only else list(peers)
    if unknown := [name for name in asked if name not in peers]:
        print(f"peers: there is no '{unknown[0]}'; choose {', '.join(peers)}", file=sys.stderr)
        return 2
    _keep_to_one_core()
    given.out.mkdir(parents=True, exist_ok=True)
    for name in asked:
        progress.stage(name)
        try:
            rows += peers[name]()
        except Missing as reason:
            progress.stage("")
            print(f"peers: no rows of {name}: {reason}", file=sys.stderr)
    progress.stage("")
    if not rows:
        return 1
    print(printed(rows))
    write_csv(rows, given.out / "peers.csv")
    (given.out / "peers.md").write_text(markdown(rows), encoding="utf-8")
    draw(rows, given.out / "peers.png")
    return 0


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="peers.py", description=__doc__.splitlines()[0])
    parser.add_argument("--only", default="", help="names, separated by commas")
    parser.add_argument("--level", choices=("O3", "native"), default="O3", help="of rigid chains (default: O3)")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "peers", help="folder (default: build/peers)")
    return parser.parse_args()


def _peers(out: Path, level: str, progress: Progress) -> dict[str, Rows]:
    def exudyn() -> list[Row]:
        folder = out / "pendulum"
        folder.mkdir(parents=True, exist_ok=True)
        rows, notes = pendulum.rows(folder, Compiler("gcc", "O3", out / "objects"), progress)
        if notes:
            raise Missing(notes[0])
        second = [row for row in rows if row.group.startswith("a second")]
        return [replace(row, target=(None, None)) for row in second]

    return {
        "pinocchio": lambda: pinocchio(out / "objects", level),
        "mujoco": mujoco,
        "soromox": soromox,
        "pyelastica": pyelastica,
        "exudyn": exudyn,
        "acados": acados,
    }


def _keep_to_one_core() -> None:
    """This process and what it starts: packages with threads of their own have one core as all others have."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})


@styled
def draw(rows: list[Row], path: Path) -> None:
    """Bars of the ratios of others."""
    others = [row for row in rows if not row.title.startswith("screwgen")]
    figure = canvas(9.0, 1.4 + 0.28 * len(others), "The same work with other tools: their time over screwgen's")
    bars(figure.add_subplot(), others)
    path.write_bytes(png(figure))


if __name__ == "__main__":
    sys.exit(main())
