"""Steps per second of a soft rod with six strains, each constant along it: stretch, shear, bending and twist.

    python bench/soft_rod.py      # some 30 s; on one core, of which other work must keep off

A step evaluates the dynamics once, or of rk4 four times. Beside SoRoMoX 0.5, a simulator on JAX with geometric variable
strain, one core of the same processor made 12 to 38 times as many steps of a rod with six strains, and 38 to 68 times
as many in single precision.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

import screwgen
from screwgen.algorithms.fused import forward_dynamics
from screwgen.spec.load import loads

ROD = """
name = "soft_rod"
gravity = [0.0, 0.0, -9.81]
order = "exact"

[[links]]
name = "rod"
length = 0.3
profile = {{ rod = {{ diameter = 0.02 }}, E = 5e5, density = 1100.0, nu = 0.45 }}
modes = {{ axial = 1, bending_y = 1, bending_z = 1, torsion = 1, shear_y = 1, shear_z = 1, points = {points} }}
damping = {{ ratio = 0.1 }}
joint = {{ axes = [] }}
"""
STEPS, ROUNDS, SCENARIOS = 20_000, 5, 256
STEP = {"modal_midpoint": 1e-3, "rk4": 1e-4}
"""s: explicit steps are bounded by the fastest mode."""


def best(work: Callable[[], object]) -> float:
    """The least of some times, s."""
    times = []
    for _ in range(ROUNDS):
        clock = time.perf_counter()
        work()
        times.append(time.perf_counter() - clock)
    return min(times)


def main() -> None:
    print("points  operations  method            scalar C   lanes, double   lanes, float   (steps/s)")
    for points in (2, 3, 4):
        model = screwgen.derive(loads(ROD.format(points=points), "soft_rod.toml"))
        x0 = np.zeros(model.nq + model.nv)
        x0[1:3] = 0.05, 0.03
        for method, dt in STEP.items():
            one, many = _scalar(model, x0, method, dt), [_lanes(model, x0, method, dt, x) for x in (False, True)]
            count = forward_dynamics(model.chain).operation_count
            figures = "   ".join(f"{x:13,.0f}" for x in (one, *many))
            print(f"{points:6d}  {count:10,d}  {method:14s} {figures}")


def _scalar(model: screwgen.Model, x0: np.ndarray, method: str, dt: float) -> float:
    """Steps per second of one scenario."""
    (q, v), c = np.split(x0, 2), model.compile()
    return STEPS / best(lambda: c.step(q, v, None, None, dt, method, STEPS))


def _lanes(model: screwgen.Model, x0: np.ndarray, method: str, dt: float, single: bool) -> float:
    """Steps per second of all scenarios together."""
    starts = x0 * np.linspace(0.5, 1.0, SCENARIOS)[:, None]
    count, more = 200, {"step": 100 * dt, "steps": 2, "substeps": 100, "integrator": method, "single": single}
    done = screwgen.rollout(model, starts, **more)
    assert not np.any(done.status)
    return SCENARIOS * count / best(lambda: screwgen.rollout(model, starts, **more))


if __name__ == "__main__":
    main()
