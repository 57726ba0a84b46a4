"""Filters under false samples that may pass the gate: `python tests/near_the_gate.py SEED [--doubt 3]`, 720 cases.

Five robots, pushed by unknown forces; of each six measured coordinates are off for 1, 3 or 10 samples by 3 to 32
standard deviations of the innovation. The estimate is held against the undisturbed one, in deviations of this, and
against that from which the samples are missing.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from drive_robots import ELASTIC, RIGID
from floating_robots import SATELLITE, rod
from helpers import arm, link, model_of
from scipy.spatial.transform import Rotation
from sensors import measured
from test_estimator import SOFT, TIP

from screwgen.backends.numpy.dae_step import SERIES
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.integrate import JointStepper

BEND = {"modes": {"bending_y": 1, "bending_z": 1}, "section": SOFT, "bodies": TIP}
GEARED = link("b", axes="y", joint={"drives": [RIGID]}, bodies=TIP)
ROBOTS = {
    "beam": arm(link("a", axes="z", **BEND)),
    "hanging": arm(link("a", axes="z", **BEND), link("b", axes="y", **BEND), gravity=[0.0, 0.0, -9.81]),
    "geared": arm(link("a", axes="z", joint={"drives": [ELASTIC]}, **BEND), GEARED),
    "satellite": SATELLITE | {"links": SATELLITE["links"][:2]},
    "ball": {"name": "mounted", "gravity": [0.3, -0.4, -9.7], "links": [rod("arm", ["y"]), rod("fore", "ball")]},
}
STEP, COUNT, FIRST = 1e-3, 140, 50
SIZES, LENGTHS, COORDINATES = (3.0, 4.5, 6.0, 8.0, 11.0, 16.0, 22.0, 32.0), (1, 3, 10), 6
OFF, FACTOR = 3.0, 1.5
"""Deviations beyond which an estimate is off, and the factor on the time of missing samples that is looked at."""


class Falsified(NamedTuple):
    """An entry of a measurement that is off, and for how many samples; NaN: it is missing."""

    name: str
    entry: int
    length: int
    added: float

    def of(self, z: dict) -> dict:
        z = {name: np.array(x, float) for name, x in z.items()}
        if self.name.endswith("attitude"):
            at = slice(4 * (self.entry // 3), 4 * (self.entry // 3) + 4)
            turn = Rotation.from_rotvec(np.eye(3)[self.entry % 3] * np.nan_to_num(self.added))
            turned = (Rotation.from_quat(z[self.name][at], scalar_first=True) * turn).as_quat(scalar_first=True)
            z[self.name][at] = np.nan if np.isnan(self.added) else turned
        else:
            z[self.name][self.entry] += self.added
        return z


class Watched:
    """A robot whose forces and measurements follow from a seed, and its filter."""

    def __init__(self, name: str, seed: int, doubt: float):
        self.model, self.seed = model_of(ROBOTS[name]), seed
        self.rigid = np.arange(self.model.nv) < self.model.chain.eta_v
        poses = {f"base_{x}": size for x, size in (("position", 2e-3), ("attitude", 2e-3), ("rate", 5e-3))}
        poses |= {"joint_attitude": 2e-3, "joint_rate": 5e-3}
        exact = Noise(np.where(self.rigid, 2.0, 0.1), 1e-12, 1e-4, 2e-6, 0.2, 0.02, **poses)
        self.noise = replace(exact, gate=5.0, doubt=doubt)
        self.filter = CompiledEstimator(self.model, flags=("-O1",))
        self.samples = list(self._samples())

    def _samples(self) -> Iterator[tuple[np.ndarray, dict]]:
        robot, rng, rest = self.model, np.random.default_rng(self.seed), np.zeros((self.model.n_links, 6))
        stepper = JointStepper(robot, "modal_midpoint", robot.parameter_values)
        q, v = np.array(robot.chain.home, float), np.zeros(robot.nv)
        for _ in range(COUNT):
            tau = rng.normal(size=robot.n_tau)
            q, v = stepper.step(stepper.initial(q, v), tau, rest, STEP)
            v = v + np.sqrt(STEP * self.noise.density_v) * rng.normal(size=robot.nv)
            yield tau, measured(robot, q, v, tau, rest, rng, self.noise)

    def estimates(self, false: Falsified | None = None) -> tuple[list, np.ndarray, list]:
        """The states after each sample, their deviations, and the innovations, from the first false sample on."""
        e, rest, out = self.filter, np.zeros((self.model.n_links, 6)), []
        spread = np.where(self.rigid, 1e-2, 1e-3)
        e.start(self.model.chain.home, np.zeros(self.model.nv), spread, 10 * spread, self.noise)
        for k, (tau, z) in enumerate(self.samples):
            e.predict(tau, rest, STEP)
            e.update(tau, rest, **(false.of(z) if false and FIRST <= k < FIRST + false.length else z))
            if k >= FIRST:
                out.append((e.state, np.sqrt(np.diag(e.covariance)), e.innovations))
        states, deviations, innovations = zip(*out, strict=True)
        return list(states), np.array(deviations), list(innovations)

    def off(self, one: list, other: list, deviations: np.ndarray) -> np.ndarray:
        """(samples,): how many deviations the coordinate that is off most is off."""
        between = lambda a, b: np.append(self.model.chain.difference(a[0], b[0], SERIES), b[1] - a[1])  # noqa: E731
        changes = [between(a, b) for a, b in zip(one, other, strict=True)]
        return np.max(np.abs(np.array(changes) / deviations), axis=1)

    def cases(self) -> Iterator[tuple[int, np.ndarray, np.ndarray, int]]:
        """Of each case its length, how far off missing and false samples lead, and right samples refused afterwards."""
        clean, deviations, innovations = self.estimates()
        first = innovations[0]
        every = [(name, k) for name, x in first.items() for k in np.flatnonzero(np.isfinite(x.normalised))]
        for at in np.unique(np.linspace(0, len(every) - 1, COORDINATES).round().astype(int)):
            name, entry = every[at]
            unit = first[name].value[entry] / first[name].normalised[entry]
            for length in LENGTHS:
                missing = self.estimates(Falsified(name, entry, length, np.nan))[0]
                for size in SIZES:
                    false, _, found = self.estimates(Falsified(name, entry, length, size * unit))
                    refused = sum(max(x.refused.sum() for x in made.values()) for made in found[length:])
                    yield length, *(self.off(clean, x, deviations) for x in (missing, false)), int(refused)


def until(off: np.ndarray) -> int:
    """The samples until an estimate is no longer off."""
    return int(np.flatnonzero(off > OFF).max(initial=-1)) + 1


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("seed", type=int)
    parser.add_argument("--doubt", type=float, default=0.0)
    given = parser.parse_args()
    found = [case for name in ROBOTS for case in Watched(name, given.seed, given.doubt).cases()]
    late = sum(until(false) > FACTOR * max(until(missing), length) for length, missing, false, _ in found)
    single = [np.max(false) for length, _, false, _ in found if length == 1]
    print(f"{len(found)} cases: {late} are off for more than {FACTOR} times as long as where samples are missing")
    print(f"right samples refused afterwards: {sum(case[3] for case in found)}")
    print(f"single samples: at most {max(single):.1f} deviations, nine of ten {np.percentile(single, 90):.1f}")


if __name__ == "__main__":
    main()
