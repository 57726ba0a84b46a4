"""What identification reaches on measured robots and on synthetic logs, as figures.

By hand, `python tests/identified_figures.py [arm] [halves] [steps] [tentacle] [ella] [gantry] …`, all without a word.
"""

from __future__ import annotations

import re
import sys
import warnings
from time import process_time

from helpers import ROOT
from synthetic_logs import ROBOTS, logged
from test_identify_measured import ARM, CURRENTS, FOLDER, FREE, percent

import screwgen
from screwgen.spec.load import loads

TENTACLE = ROOT / "examples" / "tentacle"
DAMPED = ("damping.ratio", "drives[0].damping", "joint.damping[")


def told(name: str, seconds: float, found: screwgen.Identification, *more: str) -> None:
    """A line: how long it took, and what is more to say."""
    tried = found.tried
    print(f"{name}: {tried['iterations']} iterations, {seconds:.1f} s of CPU;", "; ".join(more), flush=True)


def shown(explained: screwgen.identification.identification.Explained, of: str) -> str:
    return " / ".join(f"{x:.2f}" for x in percent(explained, of))


def arm_of_currents(fitted: str, compared: str, name: str) -> None:
    model, began = screwgen.derive(screwgen.load(ARM)), process_time()
    logs = (f"{CURRENTS}@{fitted}", f"{CURRENTS}@{compared}")
    found = screwgen.identify(model, logs[0], free=FREE, sensors=FOLDER / "sensors.toml", held_out=logs[1])
    own = [f"{of} {shown(found.explained[1], of)}" for of in ("whole", "windows")]
    told(name, process_time() - began, found, *own)
    for pair in found.pairs:
        print(f"    pair: {pair.first}, {pair.second} {pair.correlation:+.3f}")
    for line in (*found.undetermined, *found.notes):
        print(f"    {line}")


def arm() -> None:
    arm_of_currents("0:10", "10:20", "measured arm, 0-10 s, held out 10-20 s")


def halves() -> None:
    arm_of_currents("0:5", "5:10", "measured arm, 0-5 s, held out 5-10 s")
    arm_of_currents("5:10", "0:5", "measured arm, 5-10 s, held out 0-5 s")


def steps() -> None:
    """Two runs of steps with joints given, the third held out, by turns."""
    text = ARM.read_text().replace('axes = ["z"]\n', 'axes = ["z"]\nactuation = "motion"\n')
    model, free = screwgen.derive(loads(text, "arm.toml")), ["*.EIz", "gauge*.offset", "gravity[0]", "gravity[1]"]
    runs = [FOLDER / f"steps_{k}.npz" for k in (1, 2, 3)]
    for k in range(3):
        began, others = process_time(), [run for run in runs if run != runs[k]]
        found = screwgen.identify(model, others, free=free, sensors=FOLDER / "joints.toml", held_out=runs[k])
        told(
            f"steps, run {k + 1} held out",
            process_time() - began,
            found,
            f"windows {shown(found.explained[2], 'windows')}",
        )


def tentacle() -> None:
    file, began = ROOT / "examples" / "tentacle.toml", process_time()
    model = screwgen.derive(screwgen.load(file))
    log, free = TENTACLE / "shapes.csv", [f"*.profile.{x} together" for x in ("E", "nu", "density")]
    more = {"sensors": TENTACLE / "sensors.toml", "held_out": f"{log}@8:16", "robot_file": file}
    found = screwgen.identify(model, f"{log}@0:8", free=free, **more)
    said = [f"{x.log}: {1e3 * x.distance:.2f} mm" for x in found.explained]
    told("tentacle, with deriving it", process_time() - began, found, *(re.sub(".*/", "", x) for x in said))


def synthetic(name: str) -> None:
    """Ten seconds at 1 kHz."""
    model, log, columns, true = logged(name, 10.0, 1e-3)
    began = process_time()
    found = screwgen.identify(model, log, free=list(true), sensors=columns, window=0.5)
    off = {x: abs(found[x].value / value - 1) for x, value in true.items()}
    kinds = [[x for x in off if any(y in x for y in DAMPED) == damped] for damped in (False, True)]
    said = [f"{x} {100 * off[x]:.3f} % off" for x in (max(own, key=lambda x: off[x]) for own in kinds if own)]
    told(f"{name}, 10 s at 1 kHz", process_time() - began, found, *said, *found.undetermined, *found.notes)


def main(names: list[str]) -> None:
    own = {"arm": arm, "halves": halves, "steps": steps, "tentacle": tentacle}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", screwgen.ModelValidityWarning)
        for name in names or [*own, *ROBOTS]:
            own[name]() if name in own else synthetic(name)


if __name__ == "__main__":
    main(sys.argv[1:])
