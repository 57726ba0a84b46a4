"""Loops of control, unstable and stable at their steps; how runs of theirs grow, and what is said of them."""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from floating_robots import SATELLITE
from helpers import arm, example_dict, link, model_of

from screwgen import Model, simulate
from screwgen.backends.numpy.closing import closed, moving
from screwgen.errors import ScrewgenError
from screwgen.simulation.control_loop import GROWN, ControlLoopWarning
from screwgen.simulation.controllers import PD

KICK, DURATION = 1e-6, 0.5
RUNAWAY = 1e4
"""A rate of so many times the first one has grown, whatever became of it afterwards."""
TIMES = {"s": 1.0, "ms": 1e-3, "µs": 1e-6}


SOFT = {"rhoA": 0.5, "EIz": 20.0, "EIy": 20.0, "rhoIp": 1e-4}
BENT = {"modes": {"bending_y": 2, "bending_z": 2}}


def boom(joint: dict, gravity: float = 0.0, **more) -> dict:
    """A link of 1 m that bends, on one axis, with 1 kg at its tip."""
    own = link("boom", section=SOFT, bodies=[{"at": "tip", "mass": 1.0}], joint=joint, **BENT) | more
    return arm(own, gravity=(0.0, 0.0, gravity))


def weightless(name: str, **joints: dict) -> dict:
    """An example without gravity; `joints`: what joints of links have besides."""
    robot = example_dict(name) | {"gravity": [0.0, 0.0, 0.0]}
    links = [x | {"joint": x["joint"] | joints.get(x["name"], {})} for x in robot["links"]]
    return robot | {"links": links}


RIGID = arm(
    link("upper", 0.6, "yz", 3.0, section={"rhoIp": 4e-3}), link("fore", 0.5, "z", 2.0, section={"rhoIp": 2e-3}),
    gravity=(0.0, 0.0, 0.0),
)  # fmt: skip
GEAR = {"ratio": 100.0, "rotor_inertia": 2e-5, "stiffness": 2e4, "damping": 5.0}
GEARED = boom({"axes": ["z"], "drives": [GEAR]}, name="geared")
SLIDE = boom({"axes": [{"slide": "y"}], "armature": [0.05]}, name="slide")


class Case(NamedTuple):
    """A loop: a robot, a PD law that holds it where it is, the step and the integrator."""

    robot: dict
    kp: tuple[float, ...]
    kd: tuple[float, ...]
    step: float
    integrator: str = "modal_midpoint"
    function: bool = False
    """Whether the law is a function in Python."""
    q: tuple[float, ...] | None = None
    """The joints' coordinates; zero without."""
    form: str = "joint"


README = (40.0, 40.0, 20.0), (8.0, 8.0, 3.0)
UNSTABLE = {
    "README's gains, ELLA": Case(weightless("converged"), *README, 1e-3, q=(-0.5, 0.7, 0.4)),
    "README's gains, a function": Case(weightless("converged"), *README, 1e-3, function=True),
    "README's gains, semi_implicit": Case(weightless("converged"), *README, 0.2e-3, "semi_implicit"),
    "ELLA with small rotors": Case(
        weightless("converged", upper_arm={"armature": [2e-3, 2e-3]}, forearm={"armature": [1e-3]}),
        (400.0, 400.0, 120.0), (28.0, 28.0, 12.0), 1e-3,
    ),
    "ELLA, fine rotors but one": Case(
        weightless("converged", upper_arm={"armature": [0.2, 0.2]}), (400.0, 400.0, 120.0), (28.0, 28.0, 12.0), 1e-3
    ),
    "a boom": Case(boom({"axes": ["z"]}), (30.0,), (6.0,), 1e-3),
    "a boom, modal_implicit": Case(boom({"axes": ["z"]}), (30.0,), (12.0,), 5e-3, "modal_implicit"),
    "a boom, stiff law without damping": Case(boom({"axes": ["y"]}), (900.0,), (0.0,), 2e-3),
    "rigid links, rk4": Case(RIGID, (50.0, 50.0, 20.0), (9.0, 9.0, 4.0), 20e-3, "rk4"),
    "rigid links, semi_implicit": Case(RIGID, (50.0, 50.0, 20.0), (9.0, 9.0, 4.0), 20e-3, "semi_implicit"),
    "a boom, DAE form": Case(boom({"axes": ["z"]}), (30.0,), (6.0,), 1e-3, form="dae"),
    "a slide": Case(SLIDE, (4e3,), (300.0,), 2e-3),
    "elastic gears": Case(GEARED, (800.0,), (200.0,), 5e-3),
    "a satellite's arms": Case(SATELLITE, (20.0,) * 4, (4.0,) * 4, 2e-3),
    "a parallelogram, loops": Case(weightless("parallelogram"), (800.0, 0.0, 0.0), (600.0, 0.0, 0.0), 5e-3),
}  # fmt: skip


WEAK = SOFT | {"EIz": 8.0, "EIy": 8.0}
TURNING = {"axes": ["y"], "armature": [0.3]}


def two(joint: dict, elbow: dict, **more) -> dict:
    """Two such links, under gravity."""
    robot = boom(joint, -9.81, **more)
    fore = robot["links"][0] | {"name": "fore", "length": 0.6, "joint": elbow}
    return robot | {"links": [*robot["links"], fore]}


SAGGING = boom(TURNING, -9.81)
PAIR = two({"axes": ["y", "z"], "armature": [0.5, 0.5]}, {"axes": ["y"], "armature": [0.2]})
STABLE = {
    "a boom that sags": Case(SAGGING, (400.0,), (40.0,), 1e-3),
    "the same, a function": Case(SAGGING, (400.0,), (40.0,), 1e-3, function=True),
    "the same, steps of 4 ms": Case(SAGGING, (400.0,), (40.0,), 4e-3),
    "the same, modal_implicit": Case(SAGGING, (400.0,), (40.0,), 1e-3, "modal_implicit"),
    "the same, rk4": Case(SAGGING, (400.0,), (40.0,), 0.2e-3, "rk4"),
    "the same, DAE form": Case(SAGGING, (400.0,), (40.0,), 2e-3, form="dae"),
    "a weaker boom": Case(boom(TURNING, -9.81, section=WEAK), (400.0,), (40.0,), 1e-3),
    "of second order": Case(boom(TURNING, -9.81) | {"order": 2}, (400.0,), (40.0,), 1e-3),
    "soft gains without rotor": Case(boom({"axes": ["y"]}, -9.81), (40.0,), (2.0,), 1e-3),
    "two links": Case(PAIR, (600.0, 600.0, 200.0), (60.0, 60.0, 20.0), 1e-3),
    "two links, a function": Case(PAIR, (600.0, 600.0, 200.0), (60.0, 60.0, 20.0), 1e-3, function=True),
    "an elastic gear": Case(boom({"axes": ["y"], "drives": [GEAR]}, -9.81), (800.0,), (60.0,), 1e-3),
    "a boom in three segments": Case(boom(TURNING, -9.81, segments=3, section=WEAK), (400.0,), (40.0,), 1e-3),
}
"""Loops that are stable, on links that bend past the bounds of their models."""


@cache
def model_of_case(name: str) -> Model:
    return model_of((UNSTABLE | STABLE)[name].robot)


def start(model: Model, case: Case) -> np.ndarray:
    """The coordinates at which the law holds the robot, with closed loops."""
    joints = np.zeros(model.n_joints) if case.q is None else np.array(case.q)
    q = model.chain.complete(joints, np.array(model.parameter_values))
    return closed(model.numpy(), q) if model.chain.closing.rows else q


def law(model: Model, case: Case, q: np.ndarray, share: float = 1.0) -> Any:
    """The law, with all gains times a share."""
    first, m = model.chain.base_q, model.n_joints
    goal, kp, kd = q[first : first + m].copy(), share * np.array(case.kp), share * np.array(case.kd)
    if case.function:
        b = model.chain.base_v
        return lambda t, q, v: kp * (goal - q[first : first + m]) - kd * v[b : b + m]
    return PD(tuple(kp), tuple(kd), tuple(goal))


def moved(model: Model, case: Case, step: float, share: float = 1.0):
    """The run of a loop from its goal with a small rate."""
    q = start(model, case)
    v = np.full(model.nv, KICK)
    v = moving(model.numpy(), q, v) if model.chain.closing.rows else v
    given = {"q0": q, "v0": v, "controller": law(model, case, q, share)}
    return simulate(model, max(DURATION, 50 * step), step, integrator=case.integrator, form=case.form, **given)


def grows(model: Model, case: Case, step: float) -> bool:
    """Whether the rates of a run grow."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            rates = np.abs(moved(model, case, step).v).max(axis=1)
    except ScrewgenError:
        return True
    part = max(1, len(rates) // 5)
    return bool(rates[-part:].max() > GROWN**0.8 * rates[:part].max() or rates.max() > RUNAWAY * KICK)


def swung(model: Model, case: Case):
    """A run of a loop that moves the first joint by 1 rad in 0.4 s."""
    goal = np.zeros(model.n_joints)
    goal[0] = 1.0
    start = model.chain.complete(np.zeros(0), np.array(model.parameter_values))
    given: Any = PD(case.kp, case.kd, tuple(goal), duration=0.4)
    if case.function:
        kp, kd, m = np.array(case.kp), np.array(case.kd), model.n_joints
        given = lambda t, q, v: kp * (goal * min(1.0, t / 0.4) - q[:m]) - kd * v[:m]  # noqa: E731
    return simulate(model, 0.5, case.step, q0=start, controller=given, integrator=case.integrator, form=case.form)


def said(run: Callable[[], Any]) -> list[str]:
    """The warnings on loops of control of a run, whether it ends well or not."""
    with warnings.catch_warnings(record=True, action="always") as noted:
        try:
            run()
        except ScrewgenError as error:
            noted_error = str(error)
            assert "unstable at a step" in noted_error, noted_error
    return [str(w.message) for w in noted if issubclass(w.category, ControlLoopWarning)]


def named_step(line: str) -> float:
    """The step that a line names, s; 0 where none is short enough."""
    found = re.search(r"the step may be ([\d.]+) (s|ms|µs)", line)
    return float(found[1]) * TIMES[found[2]] if found else 0.0


def named_gains(line: str) -> dict[str, float]:
    """The gains that a line names, with their values."""
    return {key: float(x) for key, x in re.findall(r"(k[pd]\[\d\]) to ([\d.e+-]+)", line)}
