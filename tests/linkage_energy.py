"""What the energy of a linkage of tests/mechanisms.py, and its closure, lose in a run of compiled C."""

from functools import cache

import numpy as np
from helpers import model_of, quick
from mechanisms import MECHANISMS

from screwgen.backends.numpy.closing import moving
from screwgen.model import Model
from screwgen.runtime.compiled import Compiled

SAMPLES = 50


def start(model: Model) -> tuple[np.ndarray, np.ndarray]:
    """Where the linkage is closed, at random rates that keep it so, of half a radian per second or so."""
    q = np.zeros(model.nq)
    return q, moving(model.numpy(), q, 0.5 * np.random.default_rng(0).normal(size=model.nv))


@cache
def built(name: str) -> tuple[Model, Compiled]:
    """The linkage of that name, derived and compiled."""
    model = model_of(MECHANISMS[name]())
    return model, quick(model)


def drift(name: str, method: str, form: str, duration: float, step: float) -> tuple[float, float]:
    """The largest change of energy over the largest kinetic energy, and the largest offset of a loop."""
    model, compiled = built(name)
    q, v = start(model)
    state, make = ((q, v), joint_steps) if form == "joint" else (compiled.dae_state(q, v), dae_steps)
    moved = make(model, compiled, method, step, round(duration / step / SAMPLES))
    energies, worst = [compiled.energy(q, v)], 0.0
    for _ in range(SAMPLES):
        state, (q, v) = moved(state)
        energies.append(compiled.energy(q, v))
        worst = max(worst, float(np.max(np.abs(model.numpy().offsets(q)))))
    totals = np.sum(energies, axis=1)
    return float(np.max(np.abs(totals - totals[0])) / np.max(np.array(energies)[:, 0])), worst


def joint_steps(_, compiled, method: str, step: float, count: int):
    """A function that moves a state of the joint form by that many steps, and gives its coordinates and rates too."""

    def moved(state):
        state = compiled.step(*state, None, None, step, method, count)
        return state, state

    return moved


def dae_steps(model: Model, compiled, method: str, step: float, count: int):
    """The same of the DAE form."""
    coordinates = model.numpy().dae_functions.coordinates

    def moved(x):
        x = compiled.dae_step(x, None, None, step, method, count)
        return x, tuple(np.array(part, float) for part in coordinates(x.tolist()))

    return moved
