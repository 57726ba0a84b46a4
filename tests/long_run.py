"""Ten million steps of one millisecond in the generated C of ELLA: what drifts, and by how much.

Four runs (`RUNS`), each sampled a hundred times: the undamped arm swinging freely about its hanging posture in both
forms, and an arm with damping that comes to rest hanging down and stays there, in double and in float.
`python tests/long_run.py [STEPS]` prints a table.

The swing is wide (half a radian in every joint) and regular. One from the horizontal is not: it is chaotic, whirls past
the singular posture of the universal joint at 45 rad/s, and no step of a millisecond follows it.
"""

from __future__ import annotations

import sys
import time
from functools import cache
from typing import NamedTuple

import numpy as np
from helpers import example, example_dict, model_of
from test_conservation import FREE, REST, judge, violations

from screwgen.runtime.compiled import Compiled

STEP, METHOD, SAMPLES = 1e-3, "modal_midpoint", 100
HANGING = np.array([np.pi / 2, *np.zeros(8)])
START = HANGING + np.array([0.6, -0.4, 0.5, *np.zeros(6)])


class Drift(NamedTuple):
    """What a run of `steps` left: energies over what the swing has to give, the rest in SI units."""

    steps: int
    seconds: float
    gained: float
    """The most that the energy ever stood above its start, over the energy from the start down to hanging."""
    lost: float
    """The most that it ever stood below."""
    violation: float
    """DAE form: the worst of poses and twists against the joints."""
    moved: float
    """How far the coordinates went in the second half of the run."""
    posture: np.ndarray
    """The last coordinates q."""


@cache
def damped() -> dict:
    """ELLA with friction in its joints and losses in its modes."""
    robot = example_dict("ella")
    for link in robot["links"]:
        link["joint"]["damping"] = [4.0] * len(link["joint"]["axes"])
        link["damping"] = {"ratio": 0.02}
    return robot


def sampled(compiled: Compiled, form: str, steps: int):
    """q and v at a hundred equal intervals of a run from rest, and the DAE form's violation."""
    rest = np.zeros(len(START))
    state = compiled.dae_state(START, rest) if form == "dae" else (START, rest)
    for _ in range(SAMPLES):
        if form == "dae":
            state = compiled.dae_step(state, *FREE, STEP, METHOD, steps // SAMPLES)
            yield (*rates(state), max(violations(state)))
        else:
            state = compiled.step(*state, *FREE, STEP, METHOD, steps // SAMPLES)
            yield (*np.array(state, float), 0.0)


def rates(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """q and v of a state of ELLA's DAE form; joint rates by least squares from the twists."""
    q, etadot = np.concatenate([x[-3:], x[14:20]]), x[32:38]
    columns = np.array([judge().link_twists(q, e).ravel() for e in np.eye(9)]).T
    rest = x[20:32] - columns[:, 3:] @ etadot
    return q, np.concatenate([np.linalg.lstsq(columns[:, :3], rest, rcond=None)[0], etadot])


def drift(compiled: Compiled, form: str, steps: int) -> Drift:
    """Run, and fail on the first state that is not finite: the C reports it, and it is looked at again here."""
    energy, started = compiled.model.numpy().energy, time.perf_counter()
    states = list(sampled(compiled, form, steps))
    seconds = time.perf_counter() - started
    q, v = (np.array([s[k] for s in states]) for k in (0, 1))
    assert np.isfinite(q).all() and np.isfinite(v).all()
    energies = np.array([energy(*s[:2]) for s in states])
    start = sum(energy(START, REST))
    change = (energies.sum(axis=1) - start) / (start - sum(energy(HANGING, REST)))
    late = q[SAMPLES // 2 :]
    violation = max(s[2] for s in states)
    return Drift(steps, seconds, change.max(), -change.min(), violation, np.ptp(late, axis=0).max(), q[-1])


@cache
def compiled(which: str, single: bool) -> Compiled:
    return Compiled(model_of(damped()) if which == "damped" else example("ella"), single=single, cache=True)


RUNS = {
    "free swing": ("free", "joint", False),
    "free swing, DAE form": ("free", "dae", False),
    "damped": ("damped", "joint", False),
    "damped, float": ("damped", "joint", True),
}


def run(name: str, steps: int) -> Drift:
    which, form, single = RUNS[name]
    return drift(compiled(which, single), form, steps)


def main(steps: int) -> None:
    print(f"{steps:.0e} steps of {STEP} s, {METHOD}; energies over that of the swing\n")
    print(f"{'':22}{'gained':>10}{'lost':>10}{'joints':>10}{'second half moved':>20}{'us/step':>10}")
    for name in RUNS:
        d = run(name, steps)
        joints = f"{d.violation:.1e}" if d.violation else "-"
        print(
            f"{name:22}{d.gained:10.1e}{d.lost:10.1e}{joints:>10}{d.moved:20.1e}{1e6 * d.seconds / steps:10.2f}",
            flush=True,
        )


if __name__ == "__main__":
    main(int(float(sys.argv[1])) if len(sys.argv) > 1 else 10**7)
