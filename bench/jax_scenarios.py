"""Scenarios per second of JAX, jit(vmap(scan(step))) in doubles, beside the batch in C, in turns in one process.

    python bench/jax_scenarios.py [ROBOT.toml ...] [--scenarios 1000] [--steps 50] [--rounds 5]

Torques are zero, starts are random postures at rest. Needs `pip install screwgen[jax]`. `taskset -c 0` gives both one
core; JAX takes all cores otherwise, the batch one.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np

import screwgen

ROBOTS = ("ella_paper", "ella")
METHOD, STEP = "modal_midpoint", 1e-3


def by_jax(model, x0: np.ndarray, steps: int) -> Callable[[], np.ndarray]:
    """What gives the last states (scenarios, nq + nv), compiled."""
    step = model.jax()[f"step_{METHOD}"]
    fixed = jnp.zeros(model.n_tau), jnp.zeros((model.n_links, 6)), jnp.array(model.parameter_values), STEP

    def motion(q, v):
        return jnp.concatenate(jax.lax.scan(lambda x, _: (step(*x, *fixed), None), (q, v), None, length=steps)[0])

    q, v = jnp.array(x0[:, : model.nq]), jnp.array(x0[:, model.nq :])
    batch = jax.jit(jax.vmap(motion)).lower(q, v).compile()
    return lambda: np.asarray(batch(q, v))


def by_c(model, x0: np.ndarray, steps: int) -> Callable[[], np.ndarray]:
    """The same by the batch in C."""

    def run() -> np.ndarray:
        found = screwgen.rollout(model, x0, step=steps * STEP, steps=1, substeps=steps, integrator=METHOD)
        return np.hstack([found.q[:, -1], found.v[:, -1]])

    run()  # compiles
    return run


def measured(file: Path, scenarios: int, steps: int, rounds: int) -> tuple[float, float, float]:
    """Scenarios per second of JAX and of the C, the best of all rounds, and the largest difference of their ends."""
    model = screwgen.derive(screwgen.load(file))
    x0 = np.zeros((scenarios, model.nq + model.nv))
    x0[:, : model.n_joints] = np.random.default_rng(0).uniform(-0.5, 0.5, (scenarios, model.n_joints))
    makers = by_jax(model, x0, steps), by_c(model, x0, steps)
    ends, best = [make() for make in makers], [np.inf, np.inf]
    for _ in range(rounds):
        for k, make in enumerate(makers):
            clock = time.perf_counter()
            make()
            best[k] = min(best[k], time.perf_counter() - clock)
    return scenarios / best[0], scenarios / best[1], float(np.abs(ends[0] - ends[1]).max())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    examples = Path(__file__).resolve().parents[1] / "examples"
    parser.add_argument("robots", nargs="*", type=Path, default=[examples / f"{name}.toml" for name in ROBOTS])
    parser.add_argument("--scenarios", type=int, default=1000)
    parser.add_argument("--steps", type=int, default=50)
    parser.add_argument("--rounds", type=int, default=5)
    given = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    for file in given.robots:
        ours, batch, apart = measured(file, given.scenarios, given.steps, given.rounds)
        print(f"{file.stem}: JAX {ours:.0f}/s, C {batch:.0f}/s, {batch / ours:.1f} times; ends {apart:.0e} apart")


if __name__ == "__main__":
    main()
