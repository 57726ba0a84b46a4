"""A hand that moves as is given presses a finger of spring steel on a wall, and rubs it up and down along it.

The model is examples/finger_on_wall.toml. What the wall feels is what a cantilever says, and what the hand bears
is that with the friction of the rubber. Writes build/finger_on_wall/finger_on_wall.html, a page that plays the motion.

    python examples/finger_on_wall.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.interpolate import CubicHermiteSpline

import screwgen

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "finger_on_wall"
TIMES = [0.0, 0.3, 0.45, 0.75, 0.9, 1.2]
FORWARD, UP = [0.0, 0.031, 0.031, 0.031, 0.031, 0.031], [0.0, 0.0, 0.0, 0.03, 0.03, 0.0]
"""m: where the palm is at these times; 7 mm of its way the wall holds the tip back."""
HELD, RISING, SINKING = 0.4, 0.6, 1.05
"""s: times at which the finger rests on the wall, rubs upwards and downwards."""


def main() -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    model = screwgen.derive(screwgen.load(ROOT / "examples" / "finger_on_wall.toml"))
    places = np.array([FORWARD, np.zeros(6), UP, *np.zeros((3, 6))]).T  # and no turn
    hand = CubicHermiteSpline(TIMES, places, np.zeros_like(places))
    run = screwgen.simulate(model, 1.2, 1e-4, motion={"base": hand}, every=20, backend="c")
    values = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    weight = 9.81 * (0.4 + values["finger.bodies[0].mass"] + values["finger.rhoA"] * values["finger.length"])
    for name, t in (("held", HELD), ("rubbing upwards", RISING), ("rubbing downwards", SINKING)):
        k = int(np.argmin(np.abs(run.t - t)))
        depth, press = run.force_quantities[k]
        bent = FORWARD[-1] + values["wall.radius"] - 0.03 - depth
        rigid = 3 * values["finger.EIy"] * bent / values["finger.length"] ** 3
        lift = run.drive_effort[k, 5] - weight
        print(f"{name}: the wall bears {press:.3f} N (a cantilever {rigid:.3f} N), the hand lifts {lift:+.3f} N")
    screwgen.view(run, labels=["finger on a wall"]).save(FOLDER / "finger_on_wall.html")
    print(FOLDER / "finger_on_wall.html")


if __name__ == "__main__":
    main()
