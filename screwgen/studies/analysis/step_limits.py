"""The longest stable step of each integrator about a state, see `stable_steps`; and the paper's bound."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from ...integrators.methods import METHODS
from ...robot_model import RobotModel
from ...simulation.linearised import Linearised
from ...simulation.stable_steps import LinearisedMotions, exponents, first_failure


@dataclass(frozen=True)
class StepLimit:
    """What a method bears at a state.

    `limit`: the largest step in s up to which no oscillation (of those that are faster than the joints turn) grows
    faster than by itself; 0.0 if there is none, None
    if there is no limit up to `tried` seconds. `factor`: the spectral radius of the step map over the asked step;
    `rate`: its logarithm over the step, 1/s; `borne`: whether that step is within the limit.
    """

    method: str
    limit: float | None
    tried: float
    factor: float
    rate: float
    borne: bool


def step_limits(motion: Linearised, step: float) -> list[StepLimit]:
    """The limit of every method about a state, and its growth at `step` seconds."""
    held = LinearisedMotions(motion.trimmed())
    return [_limit(motion, held, method, step) for method in METHODS]


def _limit(motion: Linearised, held: LinearisedMotions, method: str, step: float) -> StepLimit:
    limit = first_failure(held.steps, partial(held.bears, method))
    S = motion.step_map(method, step)
    mu = np.append(np.linalg.eigvals(S), motion.closing_factors(method, step))
    fastest = mu[np.abs(mu).argmax()] if len(mu) else 1.0
    moving = abs(exponents(np.array(fastest))) > held.noise(step)
    rate = float(np.log(abs(fastest))) / step if moving else 0.0
    within = (limit is None or step <= limit) and held.bears(method, step)
    return StepLimit(method, limit, float(held.steps[-1]), float(abs(fastest)), rate, within)


def paper_bound(model: RobotModel) -> float | None:
    """(stability) as printed, in s, which does not hold: see E19. None where no link bends.

    The least of `2 l² / (1.8751² n²) √(ρA/EI)` over links and directions with n bending modes. Where measured
    frequencies stand for EI, `√(ρA/EI) l² / 1.8751² = 1 / (2π f_1)`.
    """
    values = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    bounds = [
        2.0 / (omega * count**2)
        for link in model.robot.links
        for direction, stiffness in (("bending_y", "EIz"), ("bending_z", "EIy"))
        if (count := getattr(link.modes, direction))
        for omega in [link.pieces**2 * _first(values, link.name, direction, stiffness)]
    ]
    return min(bounds, default=None)


def _first(values: dict[str, float], link: str, direction: str, stiffness: str) -> float:
    """The first circular frequency of a clamped-free link, rad/s."""
    if (measured := values.get(f"{link}.frequencies.{direction}[0]")) is not None:
        return 2 * np.pi * measured
    section = link if f"{link}.rhoA" in values else f"{link}.section[0]"  # the paper knows uniform links only
    EI, rhoA = values[f"{section}.{stiffness}"], values[f"{section}.rhoA"]
    return float(1.8751**2 / values[f"{link}.length"] ** 2 * np.sqrt(EI / rhoA))
