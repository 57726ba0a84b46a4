"""The two formulations of a robot's model: derived, or with the paper's equations as they are printed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, overload

from .errors import UsageError
from .model import Model
from .model import derive as consistent
from .spec.robot import Robot

if TYPE_CHECKING:
    from .paper.printed import PrintedModel

FORMULATIONS = ("consistent", "printed")


@overload
def derive(robot: Robot, formulation: Literal["consistent"] = "consistent") -> Model: ...


@overload
def derive(robot: Robot, formulation: Literal["printed"]) -> PrintedModel: ...


def derive(robot: Robot, formulation: str = "consistent") -> Model | PrintedModel:
    """A robot's model.  Cheap: blocks are derived per link class, when they are needed.

    ``formulation``: ``"consistent"``, derived and equal to Lagrange's equations, or ``"printed"``, the paper's
    equations as they stand, to be looked at beside the other (:class:`.paper.printed.PrintedModel`).
    """
    if formulation not in FORMULATIONS:
        raise UsageError(f"there is no formulation '{formulation}'; choose {' or '.join(FORMULATIONS)}")
    if formulation == "consistent":
        return consistent(robot)
    from .paper.printed import PrintedModel

    return PrintedModel(robot)
