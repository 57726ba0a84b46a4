"""The file of a predictive controller (TOML): horizon, cost, bounds, goal and solver. Every fault is one line."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Annotated, Any, Self

from pydantic import Field, PlainValidator, model_validator

from ..errors import RobotFileError
from .load import load_table
from .part import Part
from .values import array, boolean, choice, non_negative, number, positive, refuse, shown

METHODS = ("modal_midpoint", "modal_implicit", "semi_implicit", "euler", "rk4")
MOST = 1000
"""Intervals, substeps and iterations, at most."""
VARIABLES = 120
"""Inputs of the quadratic program, at most: the dense solver takes their third power."""


def whole(least: int, most: int) -> Callable[[Any], int]:
    """The check that a value is a whole number in a range."""

    def check(value: Any) -> int:
        if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
            raise refuse(f"is {shown(value)}; it must be a whole number from {least} to {most}")
        return value

    return check


def each(check: Callable[..., float]) -> Callable[[Any], float | tuple[float, ...]]:
    """One number for all entries, or an array of one for each."""

    def checked(value: Any) -> float | tuple[float, ...]:
        if isinstance(value, list | tuple) or hasattr(value, "tolist"):
            return tuple(check(x, at=(i,)) for i, x in enumerate(array(value, "a number or an array of numbers")))
        return check(value)

    return checked


def counts(value: Any) -> tuple[int, ...]:
    """Numbers of intervals."""
    entries = array(value, "an array of whole numbers")
    return tuple(whole(1, MOST)(x) for x in entries)


Weights = Annotated[float | tuple[float, ...], PlainValidator(each(non_negative))]
Positive = Annotated[float | tuple[float, ...], PlainValidator(each(positive))]
Any_ = Annotated[float | tuple[float, ...], PlainValidator(each(number))]


class Horizon(Part):
    """The plan: `intervals` of `step` seconds, each of `substeps` steps of `method`."""

    intervals: Annotated[int, PlainValidator(whole(1, MOST))] = Field(description="the number of intervals")
    step: Annotated[float, PlainValidator(positive)] = Field(
        description="an interval, which is the time between samples, s"
    )
    substeps: Annotated[int, PlainValidator(whole(1, MOST))] = Field(
        1, description="steps of the method in an interval"
    )
    blocks: Annotated[tuple[int, ...] | None, PlainValidator(counts)] = Field(
        None, description="numbers of intervals over which torques are constant"
    )
    method: Annotated[str, PlainValidator(choice(*METHODS))] = Field("modal_midpoint", description="the integrator")

    @model_validator(mode="after")
    def _blocks_fill_the_horizon(self) -> Self:
        if self.blocks is not None and sum(self.blocks) != self.intervals:
            what = f"add up to {sum(self.blocks)} intervals; they must add up to intervals = {self.intervals}"
            raise refuse(what, at=("blocks",))
        return self

    @property
    def lengths(self) -> tuple[int, ...]:
        """The number of intervals of every block."""
        return self.blocks or (1,) * self.intervals


class Terminal(Part):
    """What the end of the plan costs beside a stage: `factor` times its terms, and with `riccati` the cost-to-go."""

    factor: Annotated[float, PlainValidator(non_negative)] = Field(1.0, description="factor of the last state's terms")
    riccati: Annotated[bool, PlainValidator(boolean)] = Field(
        False, description="add the cost of the linear-quadratic regulator at the goal from there on"
    )


class Cost(Part):
    """Weights of squares, per second; a tip's term that is not stated costs nothing in the code."""

    tip_position: Weights | None = Field(None, description="weight of the tip's distance, 1/m²")
    tip_orientation: Weights | None = Field(None, description="weight of the sine of the tip's turn")
    tip_velocity: Weights | None = Field(None, description="weight of the tip's velocity, s²/m²")
    joints: Weights = Field(0.0, description="weight of the joint coordinates, 1/rad²")
    joint_rates: Weights = Field(0.0, description="weight of the joint rates, s²/rad²")
    modes: Weights = Field(0.0, description="weight of the modal coordinates, 1/m²")
    mode_rates: Weights = Field(0.0, description="weight of the modal rates, s²/m²")
    torques: Weights = Field(description="weight of the torques about the reference, 1/(N·m)²; > 0 in all or rates")
    torque_rates: Weights = Field(0.0, description="weight of the torques' rates, s²/(N·m)²")
    terminal: Terminal = Field(Terminal(), description="the cost of the last state")


class Between(Part):
    """Bounds on both sides, one for all or one for each."""

    lower: Any_ = Field(description="the least value")
    upper: Any_ = Field(description="the largest value")


class StrainLimit(Part):
    """The largest strain at the bases of the links."""

    limit: Positive = Field(description="the largest strain, either sign")
    fibre: Positive = Field(description="the distance from the centreline at which it is meant, m")


class Wrench(Part):
    """A component of a joint wrench."""

    component: str = Field(description='a name such as "forearm.tau_y"')
    limit: Annotated[float, PlainValidator(positive)] = Field(description="its largest size, N·m or N")


class Bounds(Part):
    """Hard bounds of the torques and their rates; soft ones of all else, since they might not be possible to keep.

    A violation of s half widths between two bounds costs `penalty (s + s²/2)`.
    """

    torques: Positive | Between | None = Field(
        None, description="the largest torques, N·m: either sign, or lower and upper; without it the limits of efforts"
    )
    torque_rates: Positive | None = Field(None, description="the largest rates of the torques, N·m/s")
    joints: Between | None = Field(None, description="bounds of the joint coordinates, rad")
    joint_rates: Positive | None = Field(None, description="the largest joint rates, rad/s")
    strains: StrainLimit | None = Field(None, description="the largest strain at the bases of the links")
    wrenches: tuple[Wrench, ...] = Field((), description="components of joint wrenches")
    penalty: Annotated[float, PlainValidator(positive)] = Field(1e3, description="what a violation costs")


class Goal(Part):
    """Where the arm shall rest: the constant reference as long as the caller gives no other."""

    joints: Annotated[tuple[float, ...], PlainValidator(each(number))] = Field(description="joint coordinates, rad")
    given: Any_ = Field(
        0.0, description="the inputs that are given and not chosen, as brakes and the lines of winches, in their order"
    )


class Solver(Part):
    """`iterations` of the quadratic program at most; `delay` 1: a torque acts from the next sample on."""

    iterations: Annotated[int, PlainValidator(whole(1, 100_000))] = Field(100, description="iterations at most")
    delay: Annotated[int, PlainValidator(whole(0, 1))] = Field(1, description="samples between state and torque")
    margin: Annotated[float, PlainValidator(positive)] = Field(
        0.25, description="how far a sample may be from its prediction: share of what half the torques' range does"
    )
    patience: Annotated[int, PlainValidator(whole(0, MOST))] = Field(
        12, description="samples in a row that may be refused; 0 believes every finite one"
    )


class Mpc(Part):
    """A predictive controller: the content of its file."""

    horizon: Horizon = Field(description="the plan: intervals, step")
    goal: Goal = Field(description="where the arm shall rest: joints")
    cost: Cost = Field(description="weights: at least torques")
    bounds: Bounds = Field(Bounds(), description="bounds: torques, unless the robot states limits of all efforts")
    solver: Solver = Field(Solver(), description="the solver")


def load_mpc(path: str | os.PathLike[str]) -> Mpc:
    """The controller that the file at `path` describes.

    Raises RobotFileError, `<file>: <key path>: <what is wrong>; <what is allowed>`.
    """
    return load_table(Mpc, path, RobotFileError)
