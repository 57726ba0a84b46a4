"""Energy and closure of every linkage of tests/mechanisms.py over ten seconds.

    python tests/linkage_energy.py 10 1e-3 [names]

runs each from where it is closed, at rates that keep it closed, without torques, in compiled C by every built-in method in
both forms, and prints the largest change of its energy over the largest kinetic energy, and by how much its loops open,
in m or of directions. A run that ends with a status says so.
"""

import sys

import numpy as np
from helpers import model_of, quick
from mechanisms import MECHANISMS

from screwgen import ScrewgenError
from screwgen.backends.numpy.closing import moving
from screwgen.integrators.methods import METHODS
from screwgen.model import Model

SAMPLES = 50


def start(model: Model) -> tuple[np.ndarray, np.ndarray]:
    """Where the linkage is closed, at random rates that keep it so, of half a radian per second or so."""
    q = np.zeros(model.nq)
    return q, moving(model.numpy(), q, 0.5 * np.random.default_rng(0).normal(size=model.nv))


def drift(model: Model, method: str, form: str, duration: float, step: float) -> tuple[float, float]:
    """The largest change of energy over the largest kinetic energy, and the largest offset of a loop."""
    compiled, (q, v) = quick(model), start(model)
    stepper = {"joint": Joint, "dae": Dae}[form](compiled, q, v)
    energies, worst = [compiled.energy(q, v)], 0.0
    for _ in range(SAMPLES):
        q, v = stepper.moved(method, step, round(duration / step / SAMPLES))
        energies.append(compiled.energy(q, v))
        worst = max(worst, float(np.max(np.abs(model.numpy().offsets(q)))))
    totals = np.sum(energies, axis=1)
    return float(np.max(np.abs(totals - totals[0])) / np.max(np.array(energies)[:, 0])), worst


class Joint:
    """Steps of the joint form."""

    def __init__(self, compiled, q, v):
        self.compiled, self.state = compiled, (q, v)

    def moved(self, method: str, step: float, count: int) -> tuple[np.ndarray, np.ndarray]:
        self.state = self.compiled.step(*self.state, None, None, step, method, count)
        return self.state


class Dae:
    """Steps of the DAE form."""

    def __init__(self, compiled, q, v):
        self.compiled, self.state = compiled, compiled.dae_state(q, v)

    def moved(self, method: str, step: float, count: int) -> tuple[np.ndarray, np.ndarray]:
        self.state = self.compiled.dae_step(self.state, None, None, step, method, count)
        return self.compiled.coordinates(self.state)


def main(duration: float, step: float, names: list[str]) -> None:
    print(f"{'linkage':26} {'form':6} " + " ".join(f"{method:>20}" for method in METHODS))
    for name in names:
        model = model_of(MECHANISMS[name]())
        for form in ("joint", "dae"):
            cells = []
            for method in METHODS:
                try:
                    energy, apart = drift(model, method, form, duration, step)
                    cells.append(f"{energy:.1e}, {apart:.0e}")
                except ScrewgenError as error:
                    cells.append(type(error).__name__)
            print(f"{name:26} {form:6} " + " ".join(f"{cell:>20}" for cell in cells), flush=True)


if __name__ == "__main__":
    main(float(sys.argv[1]), float(sys.argv[2]), sys.argv[3:] or list(MECHANISMS))
