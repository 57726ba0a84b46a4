"""A ship's crane lets a load down while the sea moves the ship, by a winch that knows it and by one that does not.

The model is examples/ship_crane.toml. The motion of the hull and of the tower is given; the efforts of their drives
follow. The winch that compensates pays out what the boom's tip rises. Writes build/ship_crane/ship_crane.html, a page
that plays both, and a figure of the load's height.

    python examples/ship_crane.py
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

import screwgen
from screwgen.plotting.look import PALETTE, canvas, png, styled

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "ship_crane"
DURATION, STEP = 24.0, 2e-3
HEAVE, ROLL = (0.5, 9.0), (0.03, 13.0)
"""Amplitude, m and rad, and period, s, of what the sea does to the hull."""
SLEW, LIFT = 0.8, 2.5
"""rad that the boom turns, and m by which the load is let down."""


def smooth(t: np.ndarray | float, begin: float, end: float) -> np.ndarray:
    """From 0 to 1, at rest at both ends with accelerations of zero."""
    x = np.clip((np.asarray(t) - begin) / (end - begin), 0.0, 1.0)
    return x**3 * (10 - 15 * x + 6 * x**2)


def motion() -> dict[str, CubicSpline]:
    """The hull and the tower over time; the sea rises within four seconds."""
    t = np.linspace(0.0, DURATION, 401)
    sea = lambda size, period: smooth(t, 0.0, 4.0) * size * np.sin(2 * np.pi * t / period)  # noqa: E731
    values = {"hull.slide[0]": sea(*HEAVE), "hull.joint[1]": sea(*ROLL), "tower.joint[0]": SLEW * smooth(t, 2.0, 15.0)}
    return {name: CubicSpline(t, x) for name, x in values.items()}


def winch(model: screwgen.Model, moved: dict[str, CubicSpline], compensates: bool) -> Callable:
    """The inputs of the winch: the load goes down from 8 s to 18 s; ``compensates``: what the tip rises is paid out."""
    t, f = np.linspace(0.0, DURATION, 401), model.numpy()
    q = np.zeros((len(t), model.nq))
    q[:, :3] = np.array([curve(t) for curve in moved.values()]).T
    tip = np.array([f.tip_poses(x)[1][2, 2] for x in q])
    out = CubicSpline(t, LIFT * smooth(t, 8.0, 18.0) + compensates * (tip - tip[0]))
    return lambda t, q, v: [0.0] * 6 + [float(out(t)), float(out(t, 1))]


def main() -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    model, moved = screwgen.derive(screwgen.load(ROOT / "examples" / "ship_crane.toml")), motion()
    start, hanging = model.numpy().tip_poses(np.zeros(model.nq))[1], np.zeros(model.nq)
    hanging[3:6] = start[2] - start[3] - [0.0, 0.0, 10.1]
    rest = screwgen.equilibrium(model, hanging)
    print(f"at rest the boom's tip sags by {1e3 * np.linalg.norm(rest.deflections[2]):.0f} mm")
    labels = ("the winch compensates", "it does not")
    runs = [
        screwgen.simulate(model, DURATION, STEP, q0=rest.q, motion=moved, controller=winch(model, moved, yes), every=10)
        for yes in (True, False)
    ]
    for label, run in zip(labels, runs, strict=True):
        height, late = run.tip_position[:, 2], run.t > 18.0
        pull = run.force_quantities[:, list(model.force_quantities).index("rope.pull")]
        print(
            f"{label}: the load ends within {1e3 * np.ptp(height[late]) / 2:.0f} mm of a height; "
            f"the rope bears {pull.min() / 1e3:.1f} to {pull.max() / 1e3:.1f} kN, "
            f"the tower's drive {np.abs(run.drive_effort[:, 2]).max() / 1e3:.1f} kN m"
        )
    screwgen.view(*runs, labels=labels).save(FOLDER / "ship_crane.html")
    (FOLDER / "ship_crane.png").write_bytes(png(figure(runs, labels)))
    print(FOLDER / "ship_crane.html")


@styled
def figure(runs: list[screwgen.Run], labels: tuple[str, ...]):
    """The height of the load."""
    drawing = canvas(6.4, 3.2)
    axes = drawing.add_subplot(xlabel="t (s)", ylabel="height of the load (m)")
    for run, label, colour in zip(runs, labels, PALETTE, strict=False):
        axes.plot(run.t, run.tip_position[:, 2], color=colour, label=label)
    axes.legend()
    return drawing


if __name__ == "__main__":
    main()
