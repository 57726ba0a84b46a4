"""Controllers: functions `(t, q, v) -> tau`, and the files that describe them."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import UsageError
from .spec.load import DEEP_KEY, one_line, syntax_error
from .spec.messages import unknown
from .spec.values import non_negative, number, positive, refuse
from .state import read_text, refusals, sized

if TYPE_CHECKING:
    from .build import Model

Controller = Callable[[float, np.ndarray, np.ndarray], Sequence[float]]

CHECKS = {"kp": non_negative, "kd": non_negative, "q_des": number, "tau_max": positive}
UNITS = {"kp": "N·m/rad", "kd": "N·m·s/rad", "q_des": "rad", "tau_max": "N·m", "duration": "s"}
REQUIRED = ("kp", "kd", "q_des")


@dataclass(frozen=True)
class PD:
    """A proportional-derivative law about a set point, one entry per joint coordinate.

    `tau = kp (q_ref − q) + kd (v_ref − v)`, limited to `±tau_max` where that is given. `kp` in N·m/rad, `kd`
    in N·m·s/rad, `q_des` in rad. With `duration` (s) the reference travels from `q_start` to `q_des` along a
    minimum-jerk path; without, it is `q_des` at rest. A run fills `q_start` in through `starting_at`.
    """

    kp: tuple[float, ...]
    kd: tuple[float, ...]
    q_des: tuple[float, ...]
    duration: float | None = None
    tau_max: tuple[float, ...] | None = None
    q_start: tuple[float, ...] | None = None

    def __post_init__(self) -> None:
        for name in ("kd", "kp", "tau_max", "q_start"):
            value = getattr(self, name)
            if value is not None and len(value) != len(self.q_des):
                raise UsageError(f"PD: {name} has length {len(value)}; q_des has {len(self.q_des)}, one per joint")

    def starting_at(self, q: Sequence[float]) -> PD:
        """The same law for a run that starts at `q` (nq,)."""
        return replace(self, q_start=tuple(float(x) for x in q[: len(self.q_des)]))

    def reference(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        """Joint coordinates (rad) and rates (rad/s) that the law follows at the time `t` (s)."""
        goal = np.array(self.q_des, float)
        if self.duration is None or self.q_start is None:
            return goal, np.zeros_like(goal)
        start = np.array(self.q_start, float)
        s = min(max(t / self.duration, 0.0), 1.0)
        place, rate = s**3 * (10 - 15 * s + 6 * s**2), 30 * (s * (1 - s)) ** 2 / self.duration
        return start + place * (goal - start), rate * (goal - start)

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The joint torques, N·m."""
        n = len(self.q_des)
        q_ref, v_ref = self.reference(t)
        tau = np.array(self.kp) * (q_ref - q[:n]) + np.array(self.kd) * (v_ref - v[:n])
        return tau if self.tau_max is None else np.clip(tau, -np.array(self.tau_max), np.array(self.tau_max))


def read_pd(path: str | os.PathLike[str], model: Model) -> PD:
    """The law in the TOML file at `path`: `kp`, `kd`, `q_des`, one number per joint coordinate.

    `duration` (s) and `tau_max` are optional. Raises UsageError, `<file>: <key>: <fault>; <what is allowed>`.
    """
    file = one_line(os.fsdecode(path))
    data = _toml(read_text(path, "a TOML file"), file)
    with refusals(file):
        for key in data:
            if key not in UNITS:
                raise refuse(unknown(key, tuple(UNITS)), (key,))
        for key in REQUIRED:
            if key not in data:
                raise refuse(f"is missing; state {model.n_joints} numbers, one per joint, {UNITS[key]}", (key,))
        return PD(**{key: _value(key, value, model.n_joints) for key, value in data.items()})


def _value(key: str, value: Any, n: int) -> Any:
    if key == "duration":
        return positive(value, at=(key,))
    return tuple(sized(value, (key,), n, f"numbers, one per joint, {UNITS[key]}", CHECKS[key]))


def _toml(text: str, file: str) -> dict[str, Any]:
    try:
        if DEEP_KEY.search(text):
            raise RecursionError
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise UsageError(f"{file}: {syntax_error(str(error), text)}") from None
    except RecursionError:
        raise UsageError(f"{file}: is nested too deeply; a gains file has no tables") from None
    except ValueError as error:
        raise UsageError(f"{file}: a value cannot be read ({one_line(str(error))}); use TOML 1.0") from None


CONTROLLERS = {"pd": read_pd}


def read_controller(text: str, model: Model) -> Controller:
    """The controller that `KIND:FILE` names, such as `pd:gains.toml`; raises UsageError."""
    kind, colon, path = text.partition(":")
    known = ", ".join(f"{name}:FILE" for name in CONTROLLERS)
    if kind not in CONTROLLERS:
        raise UsageError(f"there is no controller '{one_line(kind)}'; known: {known}")
    if not (colon and path):
        raise UsageError(f"the controller '{one_line(text)}' names no file; write {known}")
    return CONTROLLERS[kind](path, model)
