"""Measured natural frequencies and damping ratios beside those of the model: each is a case of one sample.

Frequencies are paired with the nearest of the model at the beginning of a fit, unless the file says which modes they
are. Differences are of logarithms.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.optimize import linear_sum_assignment

from ..errors import ScrewgenError, UsageError
from ..robot_model import RobotModel
from ..spec.dry_friction import without_dry_friction
from ..spec.load import one_line
from ..spec.vibrations import Vibrations, VibrationTest, load_vibrations
from ..studies.modes import mode_shapes
from .identification import MeasuredVibration
from .problem import STEP, MeasuredCases, Problem
from .unknowns import parameter_rows

REST = 1e-9
"""Frequencies below this share of the largest are rigid motions."""


UNITS = {2 * np.pi: "rad/s", 60.0: "per minute", 1000.0: "mHz", 1e-3: "kHz"}
"""What frequencies may be stated in, and how many times larger than in Hz they then are."""
OFF, BETTER = 0.4, 4.0
"""The mean logarithm by which frequencies must be off those of the start, and how many times less in another unit, for
that unit to be suspected."""


@dataclass(frozen=True, eq=False)
class TestedVibrations:
    """The vibrations of one test, and the modes of the model that they are."""

    model: RobotModel
    name: str
    test: VibrationTest
    modes: np.ndarray
    """(F,): places among the model's vibrations."""

    states = np.zeros(0, int)
    step = 1.0

    @property
    def names(self) -> list[str]:
        return [f"{self.name}: frequencies", f"{self.name}: damping ratios"][: self.quantities]

    @property
    def quantities(self) -> int:
        """How many are compared: frequencies, and damping ratios where they were measured."""
        return 1 if self.test.damping is None else 2

    @cached_property
    def compared(self) -> np.ndarray:
        measured = [self.test.frequencies, *([self.test.damping] if self.test.damping else [])]
        return np.log(np.column_stack(measured))[:, None]

    @property
    def stated(self) -> np.ndarray:
        return np.array([self.test.noise, self.test.damping_noise])[: self.quantities]

    @property
    def spread(self) -> np.ndarray:
        return np.ones(self.quantities)

    @cached_property
    def posture(self) -> np.ndarray:
        return posture_of(self.model, self.name, self.test)

    def near(self, other: MeasuredCases) -> bool:
        """Whether the same modes are compared."""
        return isinstance(other, TestedVibrations) and np.array_equal(self.modes, other.modes)

    def read(self, p: np.ndarray) -> np.ndarray:
        """(F, 2): frequencies and damping ratios of the model at parameters (n,); inf where there are none."""
        try:
            found = vibrations(self.model, self.test, self.posture, p)
        except ScrewgenError:
            return np.full((len(self.modes), 2), np.inf)
        return found[self.modes] if self.modes.max() < len(found) else np.full((len(self.modes), 2), np.inf)

    def differences(self, problem: Problem, window: np.ndarray, sought: np.ndarray, shift: np.ndarray) -> np.ndarray:
        p = parameter_rows(self.model, problem.unknowns, problem.unknowns.values(sought))
        rows, lane = np.unique(p, axis=0, return_inverse=True)
        made = np.array([self.read(row) for row in rows])[lane.ravel(), window][:, None, : self.quantities]
        return np.where(np.isinf(made), np.inf, self.compared[window] - np.log(np.maximum(made, 1e-300)))

    def continued(self, problem: Problem, sought: np.ndarray, shift: np.ndarray) -> np.ndarray:
        return shift

    def linearised(
        self, problem: Problem, sought: np.ndarray, shift: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        window, k = np.arange(len(self.modes)), len(sought)
        nudged = sought + np.vstack([np.zeros(k), STEP * np.eye(k)])
        made = [self.differences(problem, window, np.tile(x, (len(window), 1)), shift) for x in nudged]
        if np.isinf(made[0]).any():
            said = "with the numbers that the fit starts from the model has no such vibrations"
            raise UsageError(f"{self.name}: {said}; start from other numbers")
        by_p = np.stack([(x - made[0]) / STEP for x in made[1:]], axis=-1)
        return made[0], np.nan_to_num(by_p, posinf=0.0, neginf=0.0), np.zeros((*made[0].shape, 0))

    def beside(self, p0: np.ndarray, p: np.ndarray) -> list[MeasuredVibration]:
        """The vibrations beside the model at parameters (n,) of the start, and at those that were found."""
        old, new = (self.read(x).tolist() for x in (p0, p))
        ratios = self.test.damping or (None,) * len(self.modes)
        return [
            MeasuredVibration(self.name, int(mode) + 1, f, a[0], b[0], ratio, a[1], b[1])
            for mode, f, ratio, a, b in zip(self.modes, self.test.frequencies, ratios, old, new, strict=True)
        ]


def posture_of(model: RobotModel, name: str, test: VibrationTest) -> np.ndarray:
    """The coordinates (nq,) of a test's posture."""
    q = np.array(model.chain.home, float)
    for coordinate, value in test.posture.items():
        if coordinate not in model.q_names:
            known = ", ".join(model.q_names[:4])
            raise UsageError(f"{name}: posture: '{coordinate}' is no coordinate of the robot; it has {known}")
        q[model.q_names.index(coordinate)] = value
    return q


def vibrations(model: RobotModel, test: VibrationTest, q: np.ndarray, p: np.ndarray) -> np.ndarray:
    """(count, 2): frequencies, Hz, and damping ratios of the model, without rigid motions.

    The damping ratio of a mode φ of unit modal mass is φᵀ D φ / (2 ω): of the small vibrations that a blow makes. Dry
    friction of drives is left out of D.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what bounds of the model say of a trial is no news
        found = mode_shapes(model, q, test.joints, parameters=p, loaded=test.loaded)
    chain, n, own = model.chain, model.nv, found.frequencies
    there = own > REST * max(own.max(initial=0.0), 1e-300)
    ratio = np.full(len(own), np.nan)
    if test.damping is not None:
        numeric, still = model.numpy(without_dry_friction(model.robot, p)), np.zeros(chain.nvz)
        by_rate = numeric.derivatives(q, still, np.zeros(model.n_tau), np.zeros((model.n_links, 6)))[1][:n, :n]
        D = -numeric.mass_matrix(q) @ by_rate
        ratio = np.einsum("ik,ij,jk->k", found.shapes, D, found.shapes) / (4 * np.pi * np.maximum(own, 1e-300))
    return np.column_stack([own, ratio])[there]


def tested(model: RobotModel, name: str, tests: Sequence[VibrationTest], p: np.ndarray) -> list[TestedVibrations]:
    """The tests of a file beside a robot at parameters (n,): frequencies paired with the nearest of the model's."""
    out = []
    for k, test in enumerate(tests, 1):
        called = f"{name}, test {k}" if len(tests) > 1 else name
        found = vibrations(model, test, posture_of(model, called, test), p)[:, 0]
        most = max(test.modes or [len(test.frequencies)])
        if most > len(found):
            raise UsageError(
                f"{called}: mode {most} is asked for; the robot has {len(found)} with joints {test.joints}"
            )
        modes = _paired(test, found)[0]
        out.append(TestedVibrations(model, called, test, modes))
    return out


def _paired(test: VibrationTest, found: np.ndarray, unit: float = 1.0) -> tuple[np.ndarray, float]:
    """The modes (F,) of frequencies `found` (n,), Hz, that a test has, and by which logarithm they are off on average.

    `unit`: how many times larger the test has them than in Hz.
    """
    apart = np.abs(np.log(np.array(test.frequencies)[:, None] / unit / found))
    rows, modes = np.arange(len(apart)), np.array(test.modes or [], int) - 1
    if test.modes is None:
        rows, modes = linear_sum_assignment(apart)
    return modes, float(np.mean(apart[rows, modes]))


def of_frequencies(model: RobotModel, name: str, tests: Sequence[VibrationTest]) -> list[str]:
    """Tests whose frequencies the model of the start has in another unit."""
    out = []
    for group in tested(model, name, tests, model.chain.parameters.values):
        found = vibrations(model, group.test, group.posture, model.chain.parameters.values)[:, 0]
        off = _paired(group.test, found)[1]
        left = {unit: _paired(group.test, found, unit)[1] for unit in UNITS}
        unit = min(left, key=lambda x: left[x])
        if off > OFF and left[unit] < off / BETTER:
            said = "are not those of the model, but would be if they were"
            out.append(f"{group.name}: frequencies {said} {UNITS[unit]}: state them in Hz")
    return out


def tests_of(given: str | os.PathLike[str] | Vibrations | None) -> tuple[str, tuple[VibrationTest, ...]]:
    """The tests that are given, and what messages call them."""
    if given is None or isinstance(given, Vibrations):
        return "vibrations", given.tests if given else ()
    return one_line(os.fsdecode(given)), load_vibrations(given).tests
