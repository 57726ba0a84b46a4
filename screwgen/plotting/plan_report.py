"""The report of a plan: how it is played, what limits it comes close to, and what errors of the model leave of it.

Of a plan whose tip is on a path it says besides how far off that the tip is.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arguments import Given
from ..planning.drive_coordinates import DriveCoordinates
from ..planning.limits import motion_limits
from ..planning.make import scaled
from ..planning.plan import MotionPlan
from ..planning.task import MotionLimits
from ..robot_model import RobotModel
from ..simulation.arrival import Arrival, play
from ..simulation.robustness import FACTORS, Robustness, robustness, usual

PlannedPath = Callable[[np.ndarray], np.ndarray]
PLANNED = "as planned"
"""The name of the model that a plan was made for."""


@dataclass(frozen=True, eq=False, repr=False)
class PlanReport:
    """A plan, played on its models and on arms with other payloads and stiffnesses."""

    model: RobotModel
    plan: MotionPlan
    limits: MotionLimits
    arrivals: Mapping[str, Arrival]
    """By the names of models; the first is the one that is planned for."""
    robustness: Mapping[str, Robustness]
    """By what is varied, as "payload"."""
    notes: tuple[str, ...]
    """What runs warned of."""
    path: PlannedPath | None = None
    """Where the tip is to be at times of the plan, where it is to be on a path."""

    @property
    def first(self) -> Arrival:
        """How the model that is planned for arrives."""
        return self.arrivals[PLANNED]

    @property
    def measured(self) -> str:
        """What is asked of runs with errors of the model."""
        return "residual of the tip" if self.path is None else "largest distance from the path"

    def off_path(self, arrived: Arrival) -> np.ndarray:
        """(samples,), m: how far the tip of a run is from its path."""
        assert self.path is not None, "the plan follows no path"
        return off_path(self.path, arrived)

    @property
    def drives(self) -> DriveCoordinates:
        """What drives see of the run: rotors of elastic ones."""
        return DriveCoordinates(self.model.chain, self.model.chain.parameters.vector(self.first.run.parameters))

    @property
    def shares(self) -> np.ndarray:
        """(n_joints,): the largest efforts over their limits; NaN where there is no limit, or no drive."""
        most = self.plan.tau_max
        bounded = np.isfinite(most) & (most > 0)
        return np.where(bounded, self.first.effort / np.where(bounded, most, 1.0), np.nan)

    @property
    def strains(self) -> np.ndarray:
        """(n_strains,): the largest strains in the run, of either sign."""
        return np.abs(self.first.run.strain).max(axis=0)

    @property
    def wrenches(self) -> np.ndarray:
        """(6 n_links,): the largest joint wrenches in the run, of either sign."""
        wrench = self.first.run.wrench
        return np.abs(wrench).max(axis=0).ravel()

    @property
    def effort_rates(self) -> np.ndarray:
        """(n_joints,): the largest rates of the planned efforts."""
        return np.abs(np.diff(self.plan.tau, axis=0)).max(axis=0) / self.plan.t[1]

    def __repr__(self) -> str:
        return f"<PlanReport of '{self.plan.robot}': {self.first!r}>"

    def html(self) -> str:
        """The page, which needs nothing else."""
        from .plan_sections import plan_page

        return plan_page(self)


def plan_report(
    model: RobotModel,
    plan: MotionPlan,
    *,
    models: Sequence[Mapping[str, float]] = (),
    limits: Mapping[str, Any] | None = None,
    vary: Mapping[str, Sequence[str]] | None = None,
    factors: Sequence[float] = FACTORS,
    path: PlannedPath | None = None,
    parameters: Given = None,
    progress: Callable[[int, int], None] | None = None,
    **ways: Any,
) -> PlanReport:
    """Play a plan on the model, on further `models`, and on arms with other parameters, and report it.

    `models` and `limits`: as :func:`plan` took them. `vary`: names of parameters, or patterns, that are multiplied by
    `factors`, by what they are called, as `{"payload": ["arm.bodies[0].mass"]}`; without it the payload, which is the
    bodies at the tips of the last links, and the stiffness of links and gears. `path`: where the tip is to be at times
    (…), s, of the plan, as places (…, 3), m; the report then measures runs by how far off it they are at most. `ways`:
    what else :func:`play` takes.

    Warnings of these runs are `notes` of the report. `progress(done, all)` is called after every run. Raises
    UsageError, and what :func:`play` raises where the arm does not arrive with the parameters that were planned for.
    """
    asked = dict(usual(model)) if vary is None else dict(vary)
    bounds = motion_limits(model, limits or {})
    done, runs = 0, 1 + len(models) + len(asked) * len(factors)

    def step() -> None:
        nonlocal done
        done += 1
        if progress is not None:
            progress(done, runs)

    values = model.chain.parameters.vector(parameters)
    heard: list[str] = []
    arrivals = {}
    for name, p in _models(model, values, models):
        with _warned(heard, name):
            arrivals[name] = play(model, plan, parameters=p, **ways)
        step()
    measured = {} if path is None else {"measure": lambda arrived: float(off_path(path, arrived).max())}
    curves = {}
    for what, names in asked.items():
        with _warned(heard, what):
            curves[what] = robustness(model, plan, names, factors, parameters=values, progress=step, **measured, **ways)
    return PlanReport(model, plan, bounds, arrivals, curves, tuple(dict.fromkeys(heard)), path)


def off_path(path: PlannedPath, arrived: Arrival) -> np.ndarray:
    """(samples,), m: how far the tip of a run is from a path."""
    return np.linalg.norm(arrived.run.tip_position - path(arrived.run.t), axis=1)


def _models(
    model: RobotModel, values: np.ndarray, models: Sequence[Mapping[str, float]]
) -> Iterator[tuple[str, np.ndarray]]:
    """Names and parameters of all models of a plan."""
    yield PLANNED, values
    for factors in models:
        yield ", ".join(f"{name} × {factor:g}" for name, factor in factors.items()), scaled(model, values, factors)


@contextmanager
def _warned(heard: list[str], name: str) -> Iterator[None]:
    """Keeps the warnings of runs as lines."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        yield
    heard += [f"{name}: {one.message}" for one in caught]
