"""Controllers by the names that a command line has for them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.load import one_line
from .controller_files import read_pd
from .controllers import Controller
from .input_table import read_inputs


def _read_played(path: Any, model: RobotModel) -> Controller:
    from .played import read_played

    return read_played(path, model)


def _read_fed(path: Any, model: RobotModel) -> Controller:
    from .fed import read_fed

    return read_fed(path, model)


def _read_lqg(path: Any, model: RobotModel) -> Controller:
    from .lqg_law import read_lqg_law

    return read_lqg_law(path, model)


def _read_shaped(path: Any, model: RobotModel) -> Controller:
    from .shaped import read_shaped

    return read_shaped(path, model)


CONTROLLERS: dict[str, Callable[[Any, RobotModel], Controller]] = {
    "pd": read_pd,
    "plan": _read_played,
    "feedforward": _read_fed,
    "lqg": _read_lqg,
    "shaper": _read_shaped,
    "csv": read_inputs,
}


def read_controller(text: str, model: RobotModel) -> Controller:
    """The controller that `KIND:FILE` names, such as `pd:gains.toml`; raises UsageError."""
    kind, colon, path = text.partition(":")
    known = ", ".join(f"{name}:FILE" for name in CONTROLLERS)
    if kind not in CONTROLLERS:
        raise UsageError(f"there is no controller '{one_line(kind)}'; known: {known}")
    if not (colon and path):
        raise UsageError(f"the controller '{one_line(text)}' names no file; write {known}")
    return CONTROLLERS[kind](path, model)
