"""A soft arm that two tendons bend, beside its measured shapes; half of them tell E, nu and density of its silicone.

The model is examples/tentacle.toml, two cones of order "exact". Three numbers are fitted to eight measured shapes by
least squares over the markers; the other eight judge them. Writes a figure and a table to build/tentacle.

    python examples/tentacle.py [SHAPES.csv]      # other measured shapes judge the fit as well
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from scipy.optimize import least_squares

import screwgen
from screwgen.plotting.look import INK, PALETTE, canvas, png, styled
from screwgen.simulation.motion import centrelines

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "tentacle"
SHAPES = ROOT / "examples" / "tentacle" / "shapes.csv"
MARKERS = ("body.m1", "body.m2", "body.m3", "end.tip")
OFFSETS = np.array([[0.0, 0.0, 0.025], [0.0, 0.0, -0.021], [0.0, 0.0, 0.020], [0.008, 0.0, 0.0]])
"""m, in axes of the sections that have the markers."""
GUESS = {"E": 5.05e5, "nu": 0.45, "density": 1500.0}
"""The material of the robot file: Pa, 1, kg/m³."""
BOUNDS = {"E": (1e5, 1e6), "nu": (0.4, 0.4999), "density": (800.0, 2000.0)}
FITTED = 8
"""The first shapes are those of the fit; each of their tensions is that of one tendon alone."""
DRAWN = (0, 3, 5, 7, 14)


class Tentacle:
    """The model, and the measured shapes in whose words it answers."""

    def __init__(self) -> None:
        self.model = screwgen.derive(screwgen.load(ROOT / "examples" / "tentacle.toml"))
        names = [marker.name for marker in self.model.chain.markers]
        self.places = [names.index(name) for name in MARKERS]

    def parameters(self, E: float, nu: float, density: float) -> dict[str, float]:
        """The robot's parameters of another material: stiffnesses follow E, that of torsion E / (1 + nu)."""
        stiffness, mass = E / GUESS["E"], density / GUESS["density"]
        factors = {"EA": stiffness, "EIy": stiffness, "EIz": stiffness, "rhoA": mass, "rhoIp": mass}
        factors |= {"GJ": stiffness * (1 + GUESS["nu"]) / (1 + nu)}
        own = zip(self.model.parameter_names, self.model.parameter_values, strict=True)
        return {name: x * factors[key] for name, x in own if (key := name.rpartition(".")[2]) in factors}

    def rest(self, tensions: np.ndarray, parameters: dict[str, float]) -> np.ndarray:
        """The coordinates at rest under tensions, N."""
        return screwgen.equilibrium(self.model, tau=tensions, parameters=parameters).q

    def markers(self, shapes: np.ndarray, parameters: dict[str, float]) -> np.ndarray:
        """(cases, 4, 3), m: where the markers are at rest under the tensions of measured shapes."""
        out = []
        for shape in shapes:
            R, r = self.model.numpy(parameters).marker_pose(self.rest(shape[:2], parameters))
            out.append([r[i] + R[i] @ offset for i, offset in zip(self.places, OFFSETS, strict=True)])
        return np.array(out)

    def errors(self, shapes: np.ndarray, parameters: dict[str, float]) -> np.ndarray:
        """(cases, 4, 3), m: the model's markers less the measured ones."""
        return self.markers(shapes, parameters) - shapes[:, 2:].reshape(-1, 4, 3)

    def fit(self, shapes: np.ndarray) -> dict[str, float]:
        """The material that suits shapes best; far outliers weigh less than by squares."""
        names, start = list(GUESS), np.array(list(GUESS.values()))
        lower, upper = np.array([BOUNDS[name] for name in names]).T / start

        def weighed(x: np.ndarray) -> np.ndarray:
            return (self.errors(shapes, self.parameters(*(start * x))) / 0.01).ravel()

        found = least_squares(weighed, np.ones(3), bounds=(lower, upper), loss="soft_l1", diff_step=1e-3)
        return dict(zip(names, start * found.x, strict=True))


def read(path: Path) -> np.ndarray:
    """(cases, 14): two tensions, N, and four positions, m."""
    return np.loadtxt(path, delimiter=",", skiprows=1)


def mean(errors: np.ndarray) -> float:
    """The mean distance over markers and cases, mm."""
    return float(1e3 * np.linalg.norm(errors, axis=2).mean())


def main(arguments: Sequence[str] = ()) -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    arm, shapes = Tentacle(), read(SHAPES)
    fitted, others = shapes[:FITTED], shapes[FITTED:]
    guess = arm.parameters(**GUESS)
    material = arm.fit(fitted)
    found = arm.parameters(**material)
    print(f"E = {material['E']:.3g} Pa, nu = {material['nu']:.3f}, density = {material['density']:.0f} kg/m³")
    print("mean distance of the markers, mm:          first guess   fitted")
    sets = {"the shapes of the fit": fitted, "the other shapes": others}
    sets |= {Path(path).name: read(Path(path)) for path in arguments}
    for name, own in sets.items():
        print(f"  {name:38s} {mean(arm.errors(own, guess)):13.1f} {mean(arm.errors(own, found)):8.1f}")
    left = arm.errors(shapes, found)
    for name, e in zip(MARKERS, left.transpose(1, 0, 2), strict=True):
        shift, spread = 1e3 * e.mean(axis=0), mean((e - e.mean(axis=0))[:, None])
        print(f"  {name}: off by {np.array2string(shift, precision=1)} mm on average, {spread:.1f} mm about that")
    (FOLDER / "tentacle.png").write_bytes(png(figure(arm, shapes, found)))
    print(FOLDER / "tentacle.png")


@styled
def figure(arm: Tentacle, shapes: np.ndarray, parameters: dict[str, float]) -> Figure:
    """The model's centreline and markers beside the measured markers, from the front and from the side."""
    drawing = canvas(8.2, 4.6)
    for k, (across, title) in enumerate(((1, "from the front"), (0, "from the side"))):
        axes = drawing.add_subplot(1, 2, k + 1, aspect="equal", title=title, xlabel=f"{'xy'[across]} (m)")
        axes.set_ylabel("z (m)" if k == 0 else "")
        for case, colour in zip(DRAWN, PALETTE, strict=False):
            _draw(axes, arm, shapes[case], parameters, across, colour)
        axes.plot([], [], "o", color=INK, markerfacecolor="none", label="measured")
        axes.plot([], [], ".-", color=INK, label="model")
    drawing.legend(*axes.get_legend_handles_labels(), loc="outside right center")
    return drawing


def _draw(axes, arm: Tentacle, shape: np.ndarray, parameters: dict[str, float], across: int, colour: str) -> None:
    q = arm.rest(shape[:2], parameters)
    line = centrelines(arm.model, q, np.linspace(0, 1, 30)).reshape(-1, 3)
    measured, model = shape[2:].reshape(4, 3), arm.markers(shape[None], parameters)[0]
    axes.plot(line[:, across], line[:, 2], color=colour, label=f"{shape[0]:.1f} and {shape[1]:.1f} N")
    axes.plot(model[:, across], model[:, 2], ".", color=colour)
    axes.plot(measured[:, across], measured[:, 2], "o", color=colour, markerfacecolor="none")
    for a, b in zip(model, measured, strict=True):
        axes.plot([a[across], b[across]], [a[2], b[2]], color=colour, linewidth=0.6, alpha=0.6)


if __name__ == "__main__":
    main(sys.argv[1:])
