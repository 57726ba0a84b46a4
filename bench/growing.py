"""How a step and its derivatives grow with a chain: 8 to 64 flexible links, free, and with a spring from tip to tip.

python bench/growing.py [--level O3|native] [--out FOLDER]

Every link has a hinge, a bending mode in each plane and one of torsion. Times are the best of rounds by turns, on one
processor, in loops in C; how long the C takes to write and its bytes are said too. Writes growing.csv and growing.png:
times over links on logarithmic axes, with the slope of each line. Some five minutes.
"""

from __future__ import annotations

import argparse
import ctypes
import os
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from native import COMMON, LEVELS
from table import Row, significant, write_csv

import screwgen
from screwgen.backends.c.project import CProject
from screwgen.plotting.look import PALETTE, canvas, legend_above, png, styled
from screwgen.runtime import library

ROOT = Path(__file__).resolve().parents[1]
SOURCE, NAME = Path(__file__).with_name("own_slopes.c"), "chain"
LINKS, METHOD, ROUNDS, LEAST = (8, 16, 32, 64), "modal_implicit", 15, 5e-3
CALLS = {
    "a step": "peer_step",
    "a step with derivatives": "peer_step_derivatives",
    "derivatives of accelerations": "peer_derivatives",
}


def main() -> None:
    given = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    given.add_argument("--out", type=Path, default=ROOT / "build" / "peers")
    given.add_argument("--level", choices=("O3", "native"), default="O3")
    said = given.parse_args()
    out = said.out
    out.mkdir(parents=True, exist_ok=True)
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    rows = [row for sprung in (False, True) for n in LINKS for row in timed(n, sprung, said.level)]
    for row in rows:
        print(f"{row.title}: {significant(1e6 * row.seconds)} µs, {significant(row.ratio)} steps", flush=True)
    write_csv(rows, out / "growing.csv")
    (out / "growing.png").write_bytes(picture(rows))


def chain(n: int, sprung: bool) -> screwgen.Robot:
    """Equal flexible links with hinges about z and y by turns; the spring reaches from the first tip to the last."""
    section = {"rhoA": 0.5, "EA": 1e6, "EIy": 60.0, "EIz": 60.0, "GJ": 50.0, "rhoIp": 1e-4}
    modes = {"bending_y": 1, "bending_z": 1, "torsion": 1}
    links = [
        {"name": f"link{i}", "length": 0.3, "section": section, "modes": modes, "joint": {"axes": ["zy"[i % 2]]}}
        for i in range(n)
    ]
    line = {"stiffness": 100.0, "damping": 1.0, "rest": 0.2}
    forces = [{"name": "spring", "between": ["link0.tip", f"link{n - 1}.tip"], "line": line}] if sprung else []
    return screwgen.Robot(name=NAME, gravity=[0.0, 0.0, -9.81], links=links, forces=forces)


def timed(n: int, sprung: bool, level: str) -> list[Row]:
    """A step, that with its derivatives, and those of the accelerations."""
    model = screwgen.derive(chain(n, sprung))
    start = time.perf_counter()
    files = CProject(model.chain, model.version, derivatives=True).files()
    size = sum(len(text) for file, text in files.items() if "derivatives" in file)
    print(
        f"{n} links: C written in {time.perf_counter() - start:.1f} s, {size / 1e6:.2f} MB of derivatives", flush=True
    )
    rng = np.random.default_rng(n)
    q, v = 0.3 * rng.normal(size=model.nq) / n, rng.normal(size=model.nv) / n
    q[n:] *= 1e-2
    made = library.load(files | {SOURCE.name: SOURCE.read_text(encoding="utf-8")}, flags(level), "gcc")
    given = [np.ascontiguousarray(x).ctypes.data_as(ctypes.c_void_p) for x in (q, v, np.zeros(model.n_tau))]
    made.peer_dynamics.restype = ctypes.c_double
    made.peer_dynamics(*given, ctypes.c_long(1))  # prepares the constants
    times, group = best(made, given), "with a spring" if sprung else "free"
    return [Row(group, f"{n} links {group}, {name}", x, x / times["a step"]) for name, x in times.items()]


def flags(level: str) -> tuple[str, ...]:
    """Those of the compiler."""
    said = {
        "ROBOT": NAME,
        "ROBOT_UPPER": NAME.upper(),
        "HEADER": f'"{NAME}_derivatives.h"',
        "METHOD": METHOD,
        "STEP": "1e-3",
    }
    return (*(x for x in COMMON if x != "-std=c99"), *LEVELS[level], *(f"-D{name}={x}" for name, x in said.items()))


def best(made: ctypes.CDLL, given: Sequence) -> dict[str, float]:
    """The best times of the calls, which take turns, by the thread's clock."""
    calls, found = {}, {}
    for name, function in CALLS.items():
        call = getattr(made, function)
        call.restype = ctypes.c_double
        calls[name] = lambda often, call=call: call(*given, ctypes.c_long(often))
        found[name] = calls[name](1)
    often = {name: 1 + int(LEAST / max(seconds, 1e-7)) for name, seconds in found.items()}
    for _ in range(ROUNDS):
        for name, call in calls.items():
            found[name] = min(found[name], call(often[name]) / often[name])
    return found


@styled
def picture(rows: Sequence[Row]) -> bytes:
    """Times over links; in the legend how many times as long four times the links take, as a power."""
    figure = canvas(7.5, 4.6, "A step and its derivatives over the links of a chain")
    axes = figure.add_subplot()
    for k, (group, dashes) in enumerate((("free", "-"), ("with a spring", "--"))):
        for colour, name in zip(PALETTE, CALLS, strict=False):
            times = [row.seconds for n in LINKS for row in rows if row.title == f"{n} links {group}, {name}"]
            power = np.log(times[-1] / times[0]) / np.log(LINKS[-1] / LINKS[0])
            label = f"{name}{', spring' if k else ''}: n^{power:.1f}"
            axes.plot(LINKS, 1e6 * np.array(times), dashes, marker="o", color=colour, label=label)
    axes.set(xscale="log", yscale="log", xlabel="links of four coordinates each", ylabel="time, µs")
    axes.set_xticks(LINKS, [str(n) for n in LINKS])
    axes.minorticks_off()
    legend_above(axes, 560)
    return png(figure)


if __name__ == "__main__":
    main()
