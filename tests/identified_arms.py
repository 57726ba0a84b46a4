"""An arm whose numbers are known, logs of it, and the same arm with other numbers, for tests of identification."""

from __future__ import annotations

import copy
from typing import NamedTuple

import numpy as np
from helpers import arm, model_of

import screwgen
from screwgen.identification.logs import Log
from screwgen.simulation.played import Played
from screwgen.spec.columns import Column, Columns

TRUE = {
    "rod.EIz": 20.0,
    "rod.damping.ratio": 0.02,
    "rod.joint.drives[0].rotor_inertia": 0.1,
    "rod.joint.drives[0].friction.coulomb": 0.3,
    "rod.joint.drives[0].friction.viscous": 0.2,
    "rod.bodies[0].mass": 0.4,
}
OFF = (1.3, 1.3, 1.3, 0.7, 1.3, 0.7)
"""The factors by which the search starts elsewhere."""
SENSORS = Columns(
    columns=(
        Column(name="motor", drives="rod.torque[0]"),
        Column(name="angle", measures="rod.joint[0]", unit="deg"),
        Column(name="gauge", measures="strain[0]", unit="microstrain", numbers={"fibre": 0.01}),
    )
)


def pendulum(
    values: dict[str, float] = TRUE,
    actuation: str = "torque",
    gravity: tuple[float, ...] = (0.0, -9.81, 0.0),
    across: dict[str, float] | None = None,
) -> screwgen.Model:
    """A flexible pendulum with these numbers; `across` has those of a section that bends across its swing, too."""
    drive = {
        "rotor_inertia": values["rod.joint.drives[0].rotor_inertia"],
        "friction": {
            "coulomb": values["rod.joint.drives[0].friction.coulomb"],
            "viscous": values["rod.joint.drives[0].friction.viscous"],
            "velocity": 0.02,
        },
    }
    rod = {
        "name": "rod",
        "length": 1.0,
        "order": 2,
        "section": {"rhoA": 0.5, "EIz": values["rod.EIz"]} | (across or {}),
        "modes": {"bending_y": 2} | ({"bending_z": 1} if across else {}),
        "damping": {"ratio": values["rod.damping.ratio"]},
        "joint": {"axes": ["z"], "drives": [drive], "actuation": actuation},
        "bodies": [{"at": "tip", "mass": values["rod.bodies[0].mass"]}],
    }
    return model_of(arm(copy.deepcopy(rod), gravity=list(gravity)))


def elsewhere(names=TRUE, **more) -> screwgen.Model:
    """The pendulum with numbers 30 % off."""
    off = dict(zip(TRUE, OFF, strict=True))
    return pendulum({name: x * (off[name] if name in names else 1.0) for name, x in TRUE.items()}, **more)


def torque(t, q, v):
    """What moves it: slow, quick and sudden."""
    return np.array([4 * np.sin(2.2 * t) + 3 * np.sin(7 * t + 1) + 2 * np.sign(np.sin(3.1 * t))])


def swing(seconds=4.0, step=1e-3, noise=0.01, seed=1) -> Log:
    """A log of the true pendulum, with this share of noise on every sensor."""
    return logged(pendulum(), torque, seconds, step, noise, seed)


def logged(model, controller, seconds=4.0, step=1e-3, noise=0.01, seed=1, q0=(-1.5, 0.0, 0.0)) -> Log:
    """A log of a pendulum under a controller."""
    run = screwgen.simulate(model, seconds, step, q0=list(q0), controller=controller)
    rng = np.random.default_rng(seed)
    made = {"angle": np.degrees(run.q[:, 0]), "gauge": -0.01 * run.strain[:, 0] * 1e6}
    of = {"angle": noise, "gauge": noise} if isinstance(noise, float) else noise
    noisy = {name: x + of[name] * x.std() * rng.standard_normal(len(x)) for name, x in made.items()}
    return Log("swing.csv", run.t, noisy | {"motor": run.tau[:, 0]})


class Fits(NamedTuple):
    """Of fits (fits, k): errors of logarithms, and half of the intervals of these."""

    error: np.ndarray
    half: np.ndarray


def fits_of(found, plan, model, other, true, fits) -> Fits:
    """Fits of noisy logs of an excitation's motion, which begin at an `other` model."""
    run = screwgen.simulate(model, plan.time, found.run.t[1], q0=found.run.q[0], controller=Played.of(plan))
    made = {"angle": np.degrees(run.q[:, 0]), "gauge": -0.01 * run.strain[:, 0] * 1e6}
    noise, out = {column.name: column.noise for column in found.columns.sensors}, []
    names = [one.name for one in found.unknowns]
    for k in range(fits):
        rng = np.random.default_rng(k)
        noisy = {name: x + noise[name] * rng.standard_normal(len(x)) for name, x in made.items()}
        log = Log("excited", run.t, noisy | {"motor": run.tau[:, 0]})
        fit = screwgen.identify(other, log, free=names, sensors=found.columns, window=0.5)
        own = [fit[name] for name in names]
        out.append([[np.log(x.value / true[x.name]), np.log(x.high / x.low) / 2] for x in own])
    return Fits(*np.moveaxis(np.array(out), 2, 0))
