"""Logs of the examples with other numbers than their files have, 1 % of noise on every sensor."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from helpers import example_file

import screwgen
from screwgen.identification.logs import Log
from screwgen.spec.columns import Column, Columns

OFF = (1.3, 0.7)
"""Factors by which the file, from which a search starts, has wrong numbers, in turns."""


class Synthetic(NamedTuple):
    """A robot whose numbers are sought, the factors of sines that move it, and its start."""

    free: str
    efforts: tuple[float, ...]
    """Of each input the size of its sines, N·m or N."""
    q0: tuple[float, ...] | None = None
    back: float = 0.0
    """How strongly joints are pulled back to the start, per unit of effort and radian or metre."""


ROBOTS = {
    "ella": Synthetic(
        "upper_arm.EIy upper_arm.EIz upper_arm.rhoA upper_arm.bodies[0].mass "
        "forearm.EIy forearm.EIz forearm.rhoA forearm.bodies[0].mass",
        (30.0, 30.0, 12.0),
        (0.0, 0.4, 0.7),
        3.0,
    ),
    "gantry": Synthetic(
        "bridge.bodies[0].mass bridge.joint.damping[0] trolley.bodies[0].mass trolley.joint.damping[0] "
        "boom.EIy boom.EIz boom.damping.ratio swivel.bodies[0].mass",
        (400.0, 150.0, 100.0, 6.0),
        (0.0, 0.0, 0.0, 0.0),
        2.0,
    ),
    "elastic_joint": Synthetic(
        "base.joint.drives[0].stiffness base.joint.drives[0].rotor_inertia upper_arm.bodies[1].mass "
        "upper_arm.joint.drives[0].stiffness forearm.joint.drives[0].stiffness hand.bodies[1].mass "
        "base.joint.drives[0].friction.coulomb base.joint.drives[0].damping",
        (0.5, 0.6, 0.3, 0.4, 0.2, 0.2, 0.1),
        (0.0, 0.6, 0.0, 0.9, 0.0, 0.5, 0.0),
        1.0,
    ),
    "space_arm": Synthetic(
        "hull.bodies[0].mass hull.bodies[0].inertia[2] left_upper.EIy left_upper.EIz right_upper.EIz "
        "left_upper.damping.ratio left_fore.bodies[0].mass right_fore.bodies[0].mass",
        (8.0, 8.0, 4.0, 5.0, 5.0, 2.0),
        None,
        3.0,
    ),
}


def true_numbers(model: screwgen.Model, free: str) -> dict[str, float]:
    """The numbers of the log: the file's over the factors."""
    own = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    return {name: own[name] / OFF[k % 2] for k, name in enumerate(free.split())}


def pushed(model: screwgen.Model, robot: Synthetic) -> Callable:
    """A controller: two sines on every input, and a pull to the start."""
    k, size = np.arange(model.n_tau), np.array(robot.efforts)
    start = np.zeros(model.n_tau) if robot.q0 is None else np.array(robot.q0)
    first, joints = model.chain.base_q, slice(model.chain.base_v, model.chain.base_v + model.n_tau)

    def controller(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        wave = np.sin((1.7 + 0.45 * k) * t + k) + 0.7 * np.sin((11.0 + 1.3 * k) * t + 2 * k)
        pull = robot.back * (start - q[first : first + model.n_tau] - 0.2 * v[joints])
        return size * (wave + pull)

    return controller


def logged(name: str, seconds: float, step: float, noise: float = 0.01, seed: int = 1):
    """The model of the file, the log of a robot with other numbers, and the columns."""
    robot = ROBOTS[name]
    model = screwgen.derive(screwgen.load(example_file(name)))
    true = true_numbers(model, robot.free)
    q0 = None if robot.q0 is None else screwgen.equilibrium(model, q=robot.q0, hold=True, parameters=true).q
    run = screwgen.simulate(model, seconds, step, q0=q0, controller=pushed(model, robot), parameters=true)
    rng, chain = np.random.default_rng(seed), model.chain
    measured = {x: run.q[:, k] for k, x in enumerate(model.q_names) if k < chain.base_q + model.n_joints}
    gauges = [k for k, x in enumerate(model.strain_names) if ".base_strain.bending" in x]
    columns = [Column(name=x, measures=x) for x in measured]
    for j, k in enumerate(gauges):
        measured[f"gauge_{j}"] = -0.01 * run.strain[:, k]
        columns.append(Column(name=f"gauge_{j}", measures=f"strain[{j}]", numbers={"fibre": (0.01,)}))
    noisy = {x: y + noise * y.std() * rng.standard_normal(len(y)) for x, y in measured.items()}
    inputs = dict(zip(model.tau_names, run.tau.T, strict=True))
    columns += [Column(name=x, drives=x) for x in inputs]
    return model, Log(f"{name}.csv", run.t, noisy | inputs), Columns(columns=tuple(columns)), true
