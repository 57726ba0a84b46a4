"""ELLA's tip deflection from joint encoders and strain gauges: the generated Kalman filter against the open-loop model.

The plant has 20 % less stiffness than the filter's model of it. Both models get the plant's motor torques: the
open-loop model nothing else, the filters the noisy measurements besides. What counts is the deflection of the tip at
the plant's joint angles, so that the joints' drift of the open-loop model is not held against it. Prints a table,
draws build/ekf_ella.png and ends in assertions about its figures.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from ella.sheet import Sheet

import screwgen
from screwgen import PD, Model, Robot
from screwgen.algorithms.gauges import gauges
from screwgen.plotting.look import INK, PALETTE, name_ends, styled
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.integrate import JointStepper
from screwgen.simulation.motion import tip_deformation

ROOT = Path(__file__).resolve().parents[1]
PLOT = ROOT / "build" / "ekf_ella.png"
STEP = 1e-3
SOFTER = 0.8
"""Stiffness of the plant over that of the model."""
FIBRE = 0.02
"""m: the gauges' distance from the centreline."""
ENCODER, STRAIN, ACCELERATION = 1e-4, 2e-6, 0.1
"""Standard deviations of the measurements: rad, 1, m/s²."""
BELIEVED = 5.0
"""m/s²: what the filter is told of the accelerometer; its own stiffness error moves the acceleration by so much."""
LAW = PD((400.0, 400.0, 120.0), (28.0, 28.0, 12.0), (-0.4928, 0.6922, 0.4270), duration=1.7, q_start=(0.0,) * 3)
FINE, COARSE = 15, 51
"""Samples that the picture averages estimates and squared errors over."""
LIMIT = 0.1
"""The filter's error over the open-loop model's, at most."""

SENSORS = {
    "encoders": ("encoder",),
    "encoders, tip acceleration": ("encoder", "acceleration"),
    "encoders, base strain": ("encoder", "strain"),
    "encoders, base strain, tip acceleration": ("encoder", "strain", "acceleration"),
}


@dataclass(frozen=True)
class Recording:
    """A run of the plant: what acted, what was measured and what was true after each of N steps."""

    tau: np.ndarray
    """(N, 3) N·m: torques held over the step."""
    encoder: np.ndarray
    """(N, 3) rad."""
    strain: np.ndarray
    """(N, 4): gauges link by link, y before z."""
    acceleration: np.ndarray
    """(N, 3) m/s²: of the tip less free fall, tip-frame components."""
    q: np.ndarray
    """(N, nq)."""


def softer(robot: Robot, factor: float) -> Robot:
    """The robot with all stiffnesses of its links multiplied."""
    links = []
    for link in robot.links:
        section = {name: factor * getattr(link.section, name) for name in ("EA", "EIy", "EIz")}
        links.append(link.model_copy(update={"section": link.section.model_copy(update=section)}))
    return robot.model_copy(update={"links": tuple(links)})


def record(plant: Model, model: Model, steps: int) -> Recording:
    """The plant's motion to the set points; the controller compensates the weight that the model knows of."""
    rng, stepper = np.random.default_rng(0), JointStepper(plant, "modal_midpoint", plant.parameter_values)
    state, free = stepper.initial(np.zeros(plant.nq), np.zeros(plant.nq)), np.zeros((plant.n_links, 6))
    rows, felt, bias = gauge_rows(plant), Accelerometer(plant), model.numpy().bias
    taken: dict[str, list] = {name: [] for name in Recording.__dataclass_fields__}
    for k in range(steps):
        straight = np.r_[state.q[:3], np.zeros(model.nq - 3)]
        tau = np.array(LAW(k * STEP, state.q, state.v)) + bias(straight, np.zeros(model.nq), free)[:3]
        state = stepper.step(state, tau, free, STEP)
        taken["tau"].append(tau)
        taken["encoder"].append(state.q[:3] + ENCODER * rng.normal(size=3))
        taken["strain"].append(rows @ state.q + STRAIN * rng.normal(size=len(rows)))
        taken["acceleration"].append(felt(state.q, state.v, tau, free) + ACCELERATION * rng.normal(size=3))
        taken["q"].append(state.q)
    return Recording(**{name: np.array(values) for name, values in taken.items()})


def gauge_rows(model: Model) -> np.ndarray:
    """Strain of the gauges (4, nq) per coordinate."""
    found = gauges(model.chain)
    rows = np.zeros((len(found), model.nq))
    for row, gauge in zip(rows, found, strict=True):
        first = model.n_joints + gauge.first
        length = model.robot.links[gauge.link].length
        row[first : first + len(gauge.curvatures)] = -FIBRE * np.array(gauge.curvatures) / length**2
    return rows


class Accelerometer:
    """What the plant's tip feels, from CasADi: R^T (d²r/dt² − g) of the tip's pose."""

    def __init__(self, model: Model):
        import casadi as ca

        functions, p = model.casadi(), model.parameter_values
        q, v, tau, w = (ca.SX.sym(n, k) for n, k in (("q", model.nq), ("v", model.nq), ("tau", 3), ("w", 12)))
        vdot = functions["forward_dynamics"](q, v, tau, ca.reshape(w, 6, 2), p)[0]
        R, r = functions["tip_pose"](q, p)
        rate = ca.jtimes(r, q, v)
        a = R.T @ (ca.jtimes(rate, q, v) + ca.jtimes(rate, v, vdot) - ca.DM(p[:3]))
        self.function = ca.Function("a", [q, v, tau, w], [a])

    def __call__(self, q, v, tau, w_ext) -> np.ndarray:
        return np.array(self.function(q, v, tau, np.ravel(w_ext))).ravel()


# ------------------------------------------------------------------------------ estimates


def noise(model: Model) -> Noise:
    """Bending lacks a fifth of its force; the stiff axial modes, which nothing measures, are left to the model."""
    densities = {"axial": 1e-9, "bending_y": 10.0, "bending_z": 10.0}
    modes = [densities[d] for key in model.chain.keys for d, _ in key.directions]
    return Noise(np.r_[np.full(3, 1.0), modes], 0.0, ENCODER, STRAIN, BELIEVED, FIBRE)


def estimate(filter: CompiledEstimator, run: Recording, sensors) -> np.ndarray:
    """The coordinates (N, nq) that the filter has after each step."""
    model, free = filter.model, np.zeros((2, 6))
    stiff = np.array([d == "axial" for key in model.chain.keys for d, _ in key.directions])
    deviation = np.r_[np.full(3, 1e-3), np.where(stiff, 1e-8, 1e-3)]
    filter.start(np.zeros(model.nq), np.zeros(model.nq), deviation, 10 * deviation, noise(model))
    out = []
    for k, tau in enumerate(run.tau):
        filter.predict(tau, free, STEP)
        filter.update(tau, free, **{name: getattr(run, name)[k] for name in sensors})
        out.append(filter.state[0])
    return np.array(out)


def open_loop(model: Model, run: Recording) -> np.ndarray:
    """The coordinates (N, nq) of the model under the plant's torques."""
    stepper, free = JointStepper(model, "modal_midpoint", model.parameter_values), np.zeros((2, 6))
    state, out = stepper.initial(np.zeros(model.nq), np.zeros(model.nq)), []
    for tau in run.tau:
        state = stepper.step(state, tau, free, STEP)
        out.append(state.q)
    return np.array(out)


def deflection(model: Model, q: np.ndarray, joints: np.ndarray) -> np.ndarray:
    """Of the tip (N, 3), m, inertial components, at the given joint angles."""
    return tip_deformation(model, np.c_[joints, q[:, 3:]])


def rms(x: np.ndarray) -> float:
    return float(np.sqrt(np.mean(np.sum(np.square(x), axis=-1))))


def main(arguments=None) -> dict[str, float]:
    """Run, print, draw; returns the errors of the deflection (RMS, m) by estimate."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--duration", type=float, default=3.0, help="seconds of motion")
    parser.add_argument("--single", action="store_true", help="the filter in single precision")
    options = parser.parse_args(arguments)
    robot = screwgen.load(ROOT / "examples" / "ella_paper.toml")
    model, plant = screwgen.derive(robot), screwgen.derive(softer(robot, SOFTER))
    run = record(plant, model, round(options.duration / STEP))
    truth, joints = tip_deformation(plant, run.q), run.q[:, :3]
    filter = CompiledEstimator(model, single=options.single)
    estimates = {"open-loop model": open_loop(model, run)}
    estimates |= {name: estimate(filter, run, sensors) for name, sensors in SENSORS.items()}
    curves = {name: deflection(model, q, joints) for name, q in estimates.items()}
    errors = {name: rms(d - truth) for name, d in curves.items()}
    report(truth, curves, errors)
    draw(truth, curves)
    best = errors["encoders, base strain"]
    assert best <= LIMIT * errors["open-loop model"], "the filter misses its figure"
    assert best < 0.2 * errors["encoders"], "the gauges do not tell more than the encoders"
    return errors


def report(truth, curves, errors) -> None:
    print(f"deflection of ELLA's tip: {1e3 * rms(truth):.2f} mm RMS, {1e3 * np.abs(truth).max():.2f} mm at most;")
    print(f"the plant has {SOFTER:.0%} of the model's stiffness\n")
    print(f"{'estimate from':41} {'error, RMS':>11} {'largest':>11} {'of open loop':>13}")
    for name, d in curves.items():
        largest = np.linalg.norm(d - truth, axis=1).max()
        part = errors[name] / errors["open-loop model"]
        print(f"{name:41} {1e3 * errors[name]:8.3f} mm {1e3 * largest:8.3f} mm {part:12.1%}")


@styled
def draw(truth, curves) -> None:
    """The plant as a broad band with the smoothed estimates on it, their noise pale behind; below, the errors."""
    t, above = STEP * np.arange(1, len(truth) + 1), ("open-loop model", "encoders", "encoders, base strain")
    colors = dict(zip(curves, (PALETTE[3], PALETTE[1], PALETTE[4], PALETTE[0], PALETTE[2]), strict=True))
    heading = f"Tip deflection of ELLA, the plant with {100 * SOFTER:.0f} % of the model's stiffness"
    out = Sheet(2, 1, heading, (9.0, 3.4))
    title = f"vertical deflection of the tip, estimates as means over {1e3 * FINE * STEP:.0f} ms"
    panel = out.axes(title, ylabel="deflection (mm)")
    lines = panel.plot(t, 1e3 * truth[:, 2], color=INK, linewidth=6, alpha=0.25, label="plant")
    for name in above:
        noisy, smooth = 1e3 * curves[name][:, 2], 1e3 * smoothed(curves[name][:, 2], FINE)
        panel.plot(t, noisy, color=colors[name], linewidth=0.5, alpha=0.25)
        lines += panel.plot(t, smooth, color=colors[name], label=name)
    panel.set_xlim(0, t[-1])
    name_ends(panel, lines)
    panel = out.axes(f"error of the deflection, RMS over {1e3 * COARSE * STEP:.0f} ms", ylabel="error (mm)")
    lines = []
    for name, d in curves.items():
        error = 1e3 * np.sqrt(smoothed(np.sum(np.square(d - truth), axis=1), COARSE))
        lines += panel.semilogy(t, error, color=colors[name], label=name)
    panel.set_xlim(0, t[-1])
    panel.set_ylim(1e-2, 1e2)
    name_ends(panel, lines)
    PLOT.parent.mkdir(exist_ok=True)
    PLOT.write_bytes(out.png(150))
    print(f"\nplot: {PLOT.relative_to(ROOT)}")


def smoothed(x: np.ndarray, window: int) -> np.ndarray:
    """The mean (N,) over `window` samples about each; over fewer at the ends."""
    ones = np.ones(min(window, len(x)))
    return np.convolve(x, ones, "same") / np.convolve(np.ones(len(x)), ones, "same")


if __name__ == "__main__":
    main()
