"""The bounds of the model, tried: cases with the number that is watched beside the true error.

`python docs/tools/limits.py` prints the table of the guides; the cases that take no long simulation are tested.
What is true comes from elsewhere: the elastica by shooting, the closed form of the beam-column, a Ritz method for
the rotating beam, and for arms the same robot with its links split into segments.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import eigh
from scipy.optimize import brentq

import screwgen
from screwgen.simulation.validity import BOUND

ELLA = Path(__file__).resolve().parents[2] / "examples" / "ella.toml"
SLENDER = 1e-6
"""kg/m of a beam whose own mass is to play no part."""


class Case(NamedTuple):
    """One line of the table."""

    name: str
    measure: str
    value: float
    """What the tool watches."""
    error: float
    """Of the tip deflection, or of the lowest frequency: what the model gives over what is true, less one."""

    @property
    def reached(self) -> float:
        """The value over its bound."""
        return abs(self.value) / BOUND[self.measure]


def beam(mass: float, rpy=(0.0, 0.0, 0.0), gravity=9.81, rhoA=SLENDER, axes=(), **joint) -> screwgen.Model:
    """A beam of 1 m and 10 N·m² with a mass (kg) at its tip."""
    link = {
        "name": "beam",
        "length": 1.0,
        "section": {"rhoA": rhoA, "EIy": 10.0, "EIz": 10.0},
        "modes": {"basis": "polynomial", "bending_y": 3, "bending_z": 3},
        "joint": {"axes": list(axes), "mount": {"rpy": list(rpy)}, **joint},
        "bodies": [{"at": "tip", "mass": mass}] if mass else [],
    }
    robot = {"name": "beam", "gravity": [0.0, 0.0, -gravity], "links": [link]}
    return screwgen.derive(screwgen.Robot.model_validate(robot))


# ------------------------------------------------------------------------------ what is true


def elastica(load: float) -> float:
    """Tip deflection over length of a clamped beam under a tip force, `load` = F l² / EI, that keeps its direction."""

    def shot(root: float):
        slope = lambda _, y: [y[1], -load * math.cos(y[0]), math.sin(y[0])]  # noqa: E731
        return solve_ivp(slope, (0, 1), [0.0, root, 0.0], rtol=1e-10, atol=1e-12).y[:, -1]

    return shot(brentq(lambda root: shot(root)[1], 0.0, load + 1e-9, xtol=1e-12))[2]


def column(share: float) -> float:
    """The squared frequency of a tip mass on a column over that without axial load; `share` of the buckling load."""
    u = math.pi / 2 * math.sqrt(abs(share))
    swing = math.tan(u) / u - 1 if share > 0 else 1 - math.tanh(u) / u
    return u**2 / (3 * swing)


def rotating(rotation: float, count: int = 8) -> float:
    """The lowest squared frequency in the plane of rotation over EI / (rhoA l^4), by x², x³, …"""
    powers = np.arange(2, 2 + count)
    a, b = np.meshgrid(powers, powers)
    mass = 1.0 / (a + b + 1)
    stiff = a * (a - 1) * b * (b - 1) / (a + b - 3)
    pull = a * b / 2 * (1.0 / (a + b - 1) - 1.0 / (a + b + 1))
    return float(eigh(stiff + rotation * (pull - mass), mass, eigvals_only=True)[0])


# ------------------------------------------------------------------------------ the cases


def bent(deflection: float) -> Case:
    """A beam held level with a mass at its tip that bends it, to first order, so far."""
    model = beam(3 * 10.0 * deflection / 9.81)
    value = screwgen.equilibrium(model).validity.values[0, 0]
    return Case(f"level beam, {100 * deflection:g} % deflection", "deflection", value, value / elastica(3 * value) - 1)


def upright(share: float) -> Case:
    """A column with a mass on it, so much of its buckling load."""
    mass = share * math.pi**2 * 10.0 / 4 / 9.81
    model = beam(mass, rpy=(0.0, -math.pi / 2, 0.0))
    value = screwgen.equilibrium(model).validity.values[0, 2]
    frequency = 2 * math.pi * screwgen.natural_frequencies(model)[0]
    true = 3 * 10.0 / mass * column(share) if share < 1 else math.nan
    return Case(f"column, {share:g} of its buckling load", "axial_load", value, frequency / math.sqrt(true) - 1)


def turning(rotation: float) -> Case:
    """A beam that turns about its base across its centreline, at a steady rate."""
    model = beam(0.0, rhoA=1.0, gravity=0.0, axes=["z"], armature=[1e9])
    v = np.zeros(model.nq)
    v[0] = math.sqrt(rotation * 10.0)
    value = model.validity(np.zeros(model.nq), v).values[0, 3]
    slope = model.numpy().derivatives(np.zeros(model.nq), v, np.zeros(1), np.zeros((1, 6)))[0]
    square = min(np.linalg.eigvals(-slope[1:4, 1:4]).real) / 10.0
    error = math.sqrt(square / rotating(rotation)) - 1 if square > 0 else -1.0
    return Case(f"turning beam, {rotation:g}", "rotation", value, error)


def quick() -> Iterator[Case]:
    """The cases that take no long simulation."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", screwgen.ModelValidityWarning)
        yield from map(bent, (0.03, 0.05, 0.1, 0.2, 0.3, 0.5))
        yield from map(upright, (0.01, 0.02, 0.1, 0.3, 0.6, 1.5))
        yield from map(turning, (0.05, 0.2, 1.0, 4.0, 15.0))


# ------------------------------------------------------------------------------ arms in motion

GOAL = np.array([-0.4928, 0.6922, 0.4270])
GAINS = {"kp": [4e3, 4e3, 1.2e3], "kd": [80.0, 80.0, 24.0], "duration": 1.2}
ROTOR = 1.0
"""kg·m² of the motors, seen at the joint."""
SPUN_UP, RATE = 15.0, 6.0
"""s, rad/s: how long the spin-up takes, and where it ends."""
HUB = 1e7
"""kg·m² about the axis of the spin-up: the link does not disturb the motion."""


def arm(softer: float = 1.0) -> screwgen.Robot:
    """ELLA with two bending modes per plane, its stiffness divided by `softer`; axially and in torsion rigid."""
    robot = screwgen.load(ELLA)
    modes = screwgen.Modes(basis="polynomial", bending_y=2, bending_z=2)
    section = screwgen.Section(rhoA=1.6302, rhoIp=2.15e-4, EIy=2.12e3 / softer, EIz=3.67e3 / softer)
    links = []
    for link in robot.links:
        joint = link.joint.model_copy(update={"armature": (ROTOR,) * len(link.joint.axes)})
        links.append(link.model_copy(update={"modes": modes, "section": section, "joint": joint}))
    return robot.model_copy(update={"links": tuple(links)})


def cut(robot: screwgen.Robot, count: int) -> screwgen.Robot:
    """The robot with every link split into `count` segments."""
    links = [link.model_copy(update={"segments": count}) for link in robot.links]
    return robot.model_copy(update={"links": tuple(links)})


def moved(robot: screwgen.Robot, step: float = 2e-4) -> screwgen.Run:
    """The arm on a minimum-jerk path from its rest to the goal, under PD control and gravity."""
    model = screwgen.derive(robot)
    rest = screwgen.equilibrium(model, np.zeros(3), hold=True)
    law = screwgen.PD(q_des=GOAL, **GAINS)
    return screwgen.simulate(model, 2.5, step, rest.q, controller=law, every=round(5e-3 / step))


def in_motion(softer: float, count: int = 4) -> Case:
    """The move of an arm beside that of the same arm in segments: the largest difference of tips over the bending."""
    run, true = moved(arm(softer)), moved(cut(arm(softer), count))
    model = screwgen.derive(arm(softer))
    straight = [model.numpy().tip_pose(np.append(q[:3], np.zeros(model.nq - 3)))[1] for q in run.q]
    bending = np.linalg.norm(run.tip_position - straight, axis=1).max()
    error = np.linalg.norm(run.tip_position - true.tip_position, axis=1).max() / bending
    share = np.abs(run.validity.values) / list(BOUND.values())
    link, k = np.unravel_index(np.argmax(share), share.shape)
    name = f"ELLA, EI / {softer:g}, under PD" if softer != 1 else "ELLA under PD"
    return Case(name, list(BOUND)[k], float(run.validity.values[link, k]), float(error))


def spin_up(segments: int = 1, duration: float = 20.0, modes: int = 3, **way) -> screwgen.Run:
    """The published spin-up of a beam of 10 m; torque that leads a heavy hub along the path."""
    link = {
        "name": "beam",
        "length": 10.0,
        "section": {"rhoA": 1.2, "EIz": 1.4e4, "rhoIp": 1e-3},
        "segments": segments,
        "modes": {"basis": "polynomial", "bending_y": modes},
        "joint": {"axes": ["z"], "armature": [HUB]},
    }
    robot = screwgen.Robot.model_validate({"name": "spin_up", "gravity": [0.0, 0.0, 0.0], "links": [link]})
    return screwgen.simulate(screwgen.derive(robot), duration, 5e-3, controller=lead, **way)


def lead(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """The torque (1,) of the spin-up law, with feedback."""
    t, after = min(t, SPUN_UP), max(t - SPUN_UP, 0.0)
    turn = 2 * math.pi / SPUN_UP
    angle = RATE / SPUN_UP * (t**2 / 2 + (math.cos(turn * t) - 1) / turn**2) + RATE * after
    rate, rise = RATE / SPUN_UP * (t - math.sin(turn * t) / turn), RATE / SPUN_UP * (1 - math.cos(turn * t))
    return np.array([HUB * (rise + 100 * (angle - q[0]) + 20 * (rate - v[0]))])


def table() -> str:
    """All cases, as Markdown."""
    rows = ["| case | watched | value | value over bound | true error |", "|---|---|--:|--:|--:|"]
    for case in (*quick(), in_motion(1.0), in_motion(9.0)):
        error = "unstable" if math.isnan(case.error) else f"{100 * abs(case.error):.2g} %"
        rows.append(f"| {case.name} | {case.measure} | {case.value:.3g} | {case.reached:.2g} | {error} |")
    return "\n".join(rows)


if __name__ == "__main__":
    warnings.simplefilter("ignore", screwgen.ModelValidityWarning)
    print(table())
