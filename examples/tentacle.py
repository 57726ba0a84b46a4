"""A soft arm that two tendons bend, beside its measured shapes; half of them tell E, nu and density of its silicone.

The model is examples/tentacle.toml, two cones of order "exact". Three numbers are identified from eight measured
shapes; the other eight judge them. Writes a figure and a table to build/tentacle. The fit alone, in examples/tentacle:

    screwgen identify ../tentacle.toml shapes.csv@0:8 --check shapes.csv@8:16 --sensors sensors.toml \
        --free '*.profile.E together' --free '*.profile.nu together' --free '*.profile.density together' -o found.toml

    python examples/tentacle.py [SHAPES.csv]      # other measured shapes judge the fit as well
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import screwgen
from screwgen.plotting.look import INK, PALETTE, canvas, png, styled
from screwgen.simulation.motion import centrelines

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "tentacle"
ROBOT = ROOT / "examples" / "tentacle.toml"
SHAPES, SENSORS = (ROOT / "examples" / "tentacle" / name for name in ("shapes.csv", "sensors.toml"))
MATERIAL = ("*.profile.E together", "*.profile.nu together", "*.profile.density together")
FITTED = 8
"""The first shapes are those of the fit; each of their tensions is that of one tendon alone."""
DRAWN = (0, 3, 5, 7, 14)


def points(values: np.ndarray) -> np.ndarray:
    """(cases, 4, 3), m, of columns (cases, 12)."""
    return values.reshape(len(values), -1, 3)


def mean(errors: np.ndarray) -> float:
    """The mean distance over markers and cases, mm."""
    return float(1e3 * np.linalg.norm(errors, axis=2).mean())


def main(arguments: Sequence[str] = ()) -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    arm = screwgen.derive(screwgen.load(ROBOT))
    others = [f"{SHAPES}@{FITTED}:100", *arguments]
    known = {"sensors": SENSORS, "robot_file": ROBOT, "held_out": others}
    found = screwgen.identify(arm, f"{SHAPES}@0:{FITTED}", free=MATERIAL, **known)
    print(found.summary())
    print("mean distance of the markers, mm:          first guess   fitted")
    names = ["the shapes of the fit", "the other shapes", *(Path(path).name for path in arguments)]
    for name, log in zip(names, found.explained, strict=True):
        before, after = (mean(points(log.readings - made)) for made in (log.before, log.whole))
        print(f"  {name:38s} {before:13.1f} {after:8.1f}")
    measured, model = (
        points(np.vstack([getattr(log, of) for log in found.explained[:2]])) for of in ("readings", "whole")
    )
    for k, e in enumerate((model - measured).transpose(1, 0, 2), 1):
        shift, spread = 1e3 * e.mean(axis=0), mean((e - e.mean(axis=0))[:, None])
        print(f"  marker {k}: off by {np.array2string(shift, precision=1)} mm on average, {spread:.1f} mm about that")
    (FOLDER / "tentacle.png").write_bytes(png(figure(arm, measured, model, found.parameters)))
    print(FOLDER / "tentacle.png")


@styled
def figure(arm: screwgen.Model, measured: np.ndarray, model: np.ndarray, parameters: dict[str, float]) -> Figure:
    """The model's centreline and markers beside the measured markers, from the front and from the side."""
    drawing, tensions = canvas(8.2, 4.6), np.loadtxt(SHAPES, delimiter=",", skiprows=1)[:, :2]
    rests = {k: screwgen.equilibrium(arm, tau=tensions[k], parameters=parameters).q for k in DRAWN}
    lines = {k: centrelines(arm, q, np.linspace(0, 1, 30)).reshape(-1, 3) for k, q in rests.items()}
    for k, (across, title) in enumerate(((1, "from the front"), (0, "from the side"))):
        axes = drawing.add_subplot(1, 2, k + 1, aspect="equal", title=title, xlabel=f"{'xy'[across]} (m)")
        axes.set_ylabel("z (m)" if k == 0 else "")
        for (case, line), colour in zip(lines.items(), PALETTE, strict=False):
            label = f"{tensions[case, 0]:.1f} and {tensions[case, 1]:.1f} N"
            axes.plot(line[:, across], line[:, 2], color=colour, label=label)
            axes.plot(model[case, :, across], model[case, :, 2], ".", color=colour)
            axes.plot(measured[case, :, across], measured[case, :, 2], "o", color=colour, markerfacecolor="none")
            for a, b in zip(model[case], measured[case], strict=True):
                axes.plot([a[across], b[across]], [a[2], b[2]], color=colour, linewidth=0.6, alpha=0.6)
        axes.plot([], [], "o", color=INK, markerfacecolor="none", label="measured")
        axes.plot([], [], ".-", color=INK, label="model")
    drawing.legend(*axes.get_legend_handles_labels(), loc="outside right center")
    return drawing


if __name__ == "__main__":
    main(sys.argv[1:])
