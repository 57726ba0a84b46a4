"""Bode plot of ELLA: from the motors' torques to the tip's acceleration, with and without payload.

Linear models about the posture at the paper's set points, where the motors hold the arm against gravity. The robot file
has one mode per direction and no damping; here links have three bending modes in y and in z, with 1 % damping, so that
resonances are those of the arm and have a height. Writes build/bode_ella.png.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator

import screwgen
from screwgen import Damping, Modes, ScrewgenError, UsageError
from screwgen.plotting.look import PALETTE, canvas, png, styled
from screwgen.simulation.runs import check_output, outputs

ROOT = Path(__file__).resolve().parents[1]
PLOT = ROOT / "build" / "bode_ella.png"
SET_POINTS = (-0.4928, 0.6922, 0.4270)
RATIO = 0.01
PAYLOAD = "forearm.bodies[0].mass"
CHANNELS = (
    ("upper_arm.torque[0]", "z", "shoulder motor, about y", "tip frame z"),
    ("forearm.torque[0]", "y", "elbow motor, about z", "tip frame y"),
)
"""Input, axis of the tip frame, and both in words."""
BAND, FULL, QUICK = (1.0, 200.0), 4000, 400
"""Hz, and how many frequencies."""


@dataclass(frozen=True)
class Response:
    """ELLA with a payload, seen from its motors."""

    payload: float
    """kg."""
    poles: np.ndarray
    """Resonances: poles with a positive imaginary part, 1/s, by frequency; slow motions of the free joints left out."""
    undamped: np.ndarray
    """Hz: natural frequencies there without gravity and damping, joints free, as `screwgen modes` gives them."""
    f: np.ndarray
    """(N,) Hz."""
    gain: np.ndarray
    """(N, channels), m/s² per N·m."""
    feedthrough: np.ndarray
    """(channels,): what the tip does at once, the limit at high frequencies."""
    limit: np.ndarray
    """(channels,): the response at a million hertz."""
    deflection: float
    """m: how far gravity bends the tip down from where straight links would hold it."""


def main(arguments: Sequence[str] | None = None) -> int:
    given = read(arguments)
    try:
        check_output(given.output, (".png",))
        model = screwgen.derive(refined(screwgen.load(ROOT / "examples" / "ella_paper.toml")))
        mass = dict(zip(model.parameter_names, model.parameter_values, strict=True))[PAYLOAD]
        found = [response(model, m, QUICK if given.quick else FULL) for m in (mass, 0.0)]
        check(found)
        with outputs(given.output) as (stream,):
            stream.write(png(draw(found)))
    except ScrewgenError as error:
        print(f"bode_ella: error: {error}", file=sys.stderr)
        return 2 if isinstance(error, UsageError) else 1
    print(table(found))
    print(f"\nplot {shown(given.output)}")
    return 0


def read(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="bode_ella.py", description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, help="the picture (default: build/bode_ella.png)")
    parser.add_argument("--quick", action="store_true", help="fewer frequencies: to see that all works")
    given = parser.parse_args(arguments)
    if given.output is None:
        PLOT.parent.mkdir(exist_ok=True)
        given.output = PLOT
    return given


def shown(path: Path) -> str:
    """The path from here, if it lies below."""
    relative = os.path.relpath(path)
    return str(path) if relative.startswith("..") else relative


def refined(robot: screwgen.Robot) -> screwgen.Robot:
    """The robot with more modes, damped."""
    changes = {"modes": Modes(basis="polynomial", bending_y=3, bending_z=3), "damping": Damping(ratio=RATIO)}
    return robot.model_copy(update={"links": tuple(link.model_copy(update=changes) for link in robot.links)})


# ------------------------------------------------------------------------------ the model


def response(model: screwgen.Model, payload: float, count: int) -> Response:
    p = np.array(model.parameter_values)
    p[model.parameter_names.index(PAYLOAD)] = payload
    rest = screwgen.equilibrium(model, SET_POINTS, hold=True, parameters=p)
    inputs = [name for name, *_ in CHANNELS]
    linear = model.linearise(rest.q, tau=rest.tau, parameters=p, outputs="tip_acceleration", inputs=inputs)
    axes = model.numpy(p).tip_pose(rest.q)[0][:, ["xyz".index(axis) for _, axis, *_ in CHANNELS]]
    f = np.unique(np.append(np.geomspace(*BAND, count), resonances(linear).imag / (2 * np.pi)))
    f = f[(f >= BAND[0]) & (f <= BAND[1])]
    project = lambda y: np.einsum("...xc,xc->...c", y, axes)  # noqa: E731
    free = screwgen.natural_frequencies(model, rest.q, "free", p)
    gain, limit = project(linear.response(f)), project(linear.response([1e6]))[0]
    sag = float(np.linalg.norm(rest.tip_deflection))
    return Response(payload, resonances(linear), free[free > 0], f, gain, project(linear.D), limit, sag)


def resonances(linear: screwgen.LinearModel) -> np.ndarray:
    """The poles of vibrations, by frequency."""
    poles = linear.eigenvalues()
    return poles[poles.imag > 2 * np.pi]


def check(found: list[Response]) -> None:
    """What the figures must show."""
    loaded, bare = found
    for r in found:
        hertz = np.abs(r.poles) / (2 * np.pi)
        assert np.allclose(hertz, r.undamped, rtol=0.01), "resonances are the natural frequencies, but for gravity"
        lowest = r.f[np.abs(r.gain).argmax(axis=0)][0]
        assert abs(lowest / hertz[0] - 1) < 1e-3, "the shoulder motor moves the tip most at the lowest resonance"
        assert np.allclose(r.limit, r.feedthrough, rtol=1e-3), "at high frequencies the feedthrough is left"
    assert (bare.poles.imag > loaded.poles.imag).all(), "without payload every resonance is higher"
    assert bare.deflection < loaded.deflection, "and the arm sags less"


# ------------------------------------------------------------------------------ what is shown


def table(found: list[Response]) -> str:
    lines = ["ELLA at the set points, held against gravity; resonances with free joints, modal damping 1 %", ""]
    lines += [f"payload   sag of the tip   resonances up to {BAND[1]:g} Hz"]
    for r in found:
        hertz = "".join(f"{f:9.3f}" for f in r.poles.imag / (2 * np.pi) if f <= BAND[1])
        lines.append(f"{r.payload:4.1f} kg {1e3 * r.deflection:13.1f} mm {hertz}")
    lines += ["", "highest gain (dB re 1 m/s² per N·m)" + "".join(f"{words:>26}" for *_, words, _ in CHANNELS)]
    for r in found:
        peaks = 20 * np.log10(np.abs(r.gain).max(axis=0))
        at = r.f[np.abs(r.gain).argmax(axis=0)]
        cells = "".join(f"{f'{g:.1f} at {f:.2f} Hz':>26}" for g, f in zip(peaks, at, strict=True))
        lines.append(f"{r.payload:4.1f} kg{'':28}{cells}")
    return "\n".join(lines)


@styled
def draw(found: list[Response]) -> Figure:
    out = canvas(10.5, 6.4, "ELLA at the set points: motor torque to tip acceleration, modal damping 1 %")
    axes = out.subplots(2, len(CHANNELS), sharex=True, sharey="row", squeeze=False)
    for k, (_, _, motor, seen) in enumerate(CHANNELS):
        for r, shade in zip(found, PALETTE, strict=False):
            label = f"payload {r.payload:g} kg" if r.payload else "without payload"
            axes[0, k].semilogx(r.f, 20 * np.log10(np.abs(r.gain[:, k])), color=shade, label=label)
            axes[1, k].semilogx(r.f, np.degrees(np.unwrap(np.angle(r.gain[:, k]))), color=shade)
        axes[0, k].set_title(f"{motor} → acceleration along {seen}")
        axes[1, k].set_xlabel("f (Hz)")
        axes[1, k].yaxis.set_major_locator(MultipleLocator(180))
        axes[1, k].set_xlim(*BAND)
    axes[0, 0].set_ylabel("gain (dB re 1 m/s² per N·m)")
    axes[1, 0].set_ylabel("phase (°)")
    out.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=len(found))
    return out


if __name__ == "__main__":
    sys.exit(main())
