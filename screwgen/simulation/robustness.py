"""How still an arm arrives whose payload or stiffness is another one than that which a plan was made for."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arguments import Given
from ..errors import ScrewgenError
from ..planning.make import scaled
from ..planning.plan import MotionPlan
from ..robot_model import RobotModel
from ..spec.parameters import parameters as parameters_of
from ..spec.parents import parents
from .arrival import Arrival, play

FACTORS = (0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3)
OF_LINKS = ("EA", "EIy", "EIz", "GJ", "GAy", "GAz")
STIFFNESSES = {*OF_LINKS, *(f"section.{name}" for name in OF_LINKS), "joint.drives.stiffness"}
"""Fields of parameters: of links, also at stations, and of gears."""


@dataclass(frozen=True, eq=False)
class Robustness:
    """What a plan leaves of arms in which some parameters are others, all by the same factor."""

    parameters: tuple[str, ...]
    """Their names."""
    factors: np.ndarray
    """(F,)"""
    residuals: np.ndarray
    """(F,), m: as `Arrival.residual`, or what else was measured; NaN where the arm did not arrive."""
    saturated: np.ndarray
    """(F,): samples at which a drive gave all that it has."""
    failed: tuple[str, ...] = ()
    """Of the runs that did not reach their ends: why."""


def robustness(
    model: RobotModel,
    plan: MotionPlan,
    names: Sequence[str],
    factors: Sequence[float] = FACTORS,
    *,
    parameters: Given = None,
    measure: Callable[[Arrival], float] = lambda arrived: arrived.residual,
    progress: Callable[[], None] = lambda: None,
    **ways: Any,
) -> Robustness:
    """Play a plan on arms whose parameters `names`, or patterns as `*.EIz`, are multiplied by each of `factors`.

    `measure`: what is asked of each run, m; how still it stands, if not given. `ways`: what else :func:`play` takes;
    `progress` is called after every run. A run that diverges is part of the result; raises UsageError where there is
    no such parameter, or none may have such a value.
    """
    values = model.chain.parameters.vector(parameters)
    places = sorted({k for name in names for k in model.chain.parameters.chosen(name)})
    own = tuple(model.parameter_names[k] for k in places)
    residuals, saturated, failed = np.full(len(factors), np.nan), np.zeros(len(factors), int), []
    for k, factor in enumerate(factors):
        p = scaled(model, values, dict.fromkeys(own, factor))
        try:
            arrived = play(model, plan, parameters=p, **ways)
            residuals[k], saturated[k] = measure(arrived), arrived.saturated
        except ScrewgenError as error:
            failed.append(f"by {factor:g}: {error}")
        progress()
    return Robustness(own, np.array(factors, float), residuals, saturated, tuple(failed))


def payload(model: RobotModel) -> list[str]:
    """Masses and inertias of the bodies at the tips of links that carry no link, or of their other bodies."""
    links = model.robot.links
    last = set(range(len(links))) - set(parents(links))
    found = [x for x in parameters_of(model.robot) if x.link in last and x.field in ("bodies.mass", "bodies.inertia")]
    tips = [x.name for x in found if x.link is not None and links[x.link].bodies[x.index[0]].at == "tip"]
    return tips or [x.name for x in found]


def stiffness(model: RobotModel) -> list[str]:
    """Stiffnesses of links and gears."""
    return [x.name for x in parameters_of(model.robot) if x.field in STIFFNESSES]


def usual(model: RobotModel) -> Iterator[tuple[str, list[str]]]:
    """What is known least of an arm, with the names of its parameters: payload and stiffness, where there are any."""
    for what, names in (("payload", payload(model)), ("stiffness", stiffness(model))):
        if names:
            yield what, names
