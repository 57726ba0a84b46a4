"""Three soft fingers, curved outwards at rest, that tendons close, hold closed and let go; then the palm turns them.

The model is examples/soft_gripper.toml. Writes build/soft_gripper/soft_gripper.html, a page that plays the motion, and
a figure of the fingers at rest under some tensions.

    python examples/soft_gripper.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import screwgen
from screwgen.plotting.look import PALETTE, canvas, png, styled
from screwgen.simulation.motion import centrelines

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "soft_gripper"
CLOSED = 4.5
"""N: the tension that brings the tips together."""
TENSIONS = (0.0, 1.5, 3.0, CLOSED)
KP, KD, TURN = 0.3, 0.02, 1.0
"""N·m/rad and N·m·s/rad of the palm, and how far it turns, rad."""


def inputs(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """The torque of the palm, N·m, and three tensions, N, which rise within 0.5 s and fall from 1.5 s on."""
    smooth = lambda x: (y := np.clip(x, 0.0, 1.0)) ** 2 * (3 - 2 * y)  # noqa: E731
    tension = CLOSED * (smooth(t / 0.5) - smooth((t - 1.5) / 0.3))
    return np.array([KP * (TURN * smooth((t - 0.6) / 0.6) - q[0]) - KD * v[0], *[tension] * 3])


def main() -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    model = screwgen.derive(screwgen.load(ROOT / "examples" / "soft_gripper.toml"))
    rest = [screwgen.equilibrium(model, [0.0], hold=True, tau=[tension] * 3) for tension in TENSIONS]
    for tension, found in zip(TENSIONS, rest, strict=True):
        tips = model.numpy().tip_poses(found.q)[1][1:]
        apart = 1e3 * np.linalg.norm(tips[0] - tips[1])
        print(f"{tension:3.1f} N: tips {apart:5.1f} mm apart, {-1e3 * tips[0, 2]:5.1f} mm below the foot")
    run = screwgen.simulate(model, 2.5, 1e-3, q0=rest[0].q, controller=inputs, every=10, backend="c")
    screwgen.view(run, labels=["soft gripper"]).save(FOLDER / "soft_gripper.html")
    (FOLDER / "soft_gripper.png").write_bytes(png(figure(model, rest)))
    print(FOLDER / "soft_gripper.html")


@styled
def figure(model: screwgen.Model, rest: list) -> Figure:
    """The first finger, from the side, at rest under the tensions."""
    drawing = canvas(5.0, 4.2)
    axes = drawing.add_subplot(aspect="equal", xlabel="y (m)", ylabel="z (m)")
    for tension, found, colour in zip(TENSIONS, rest, PALETTE, strict=False):
        line = centrelines(model, found.q, np.linspace(0, 1, 40))[1]
        axes.plot(line[:, 1], line[:, 2], color=colour, label=f"{tension:.1f} N")
    axes.axvline(0.0, color="0.6", linewidth=0.6)
    axes.legend(title="tension")
    return drawing


if __name__ == "__main__":
    main()
