"""Files of joint laws, TOML."""

from __future__ import annotations

import os
from typing import Any

from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.load import one_line, parse
from ..spec.messages import unknown
from ..spec.ranges import within
from ..spec.values import array, refuse, shown
from .controllers import PD, SUMMED, UNITS, Holding, joint_numbers
from .integral_law import PID
from .state import read_text, refusals

REQUIRED = ("kp", "kd", "q_des")
KEYS = (*UNITS, *SUMMED, "duration", "waypoints", "gravity")


def read_pd(path: str | os.PathLike[str], model: RobotModel) -> PD:
    """The law in the TOML file at `path`: `kp`, `kd`, `q_des`, one number per joint coordinate.

    `duration` (s), `tau_max` and `ki`, which makes it a :class:`.integral_law.PID`, are optional. In place of `q_des`
    and `duration`: `waypoints`, an array of `{ t = …, q = […] }` with ascending times. `gravity = true` adds the
    torques that hold the arm at the measured joint angles. Raises UsageError,
    `<file>: <key>: <fault>; <what is allowed>`.
    """
    model.chain.refuse_quaternion_joints("PD law from a file", "give a function of t, q and v in Python")
    file = one_line(os.fsdecode(path))
    data = parse(read_text(path, "a TOML file"), file, UsageError, "a gains file has no such depth")
    with refusals(file):
        for key in data:
            if key not in KEYS:
                raise refuse(unknown(key, KEYS), (key,))
        given = _goal(data, model.n_joints)
        for key in REQUIRED:
            if key not in given:
                raise refuse(f"is missing; state {model.n_joints} numbers, one per joint, {UNITS[key]}", (key,))
        values = {key: given[key] for key in (*UNITS, *SUMMED) if key in given}
        law: dict[str, Any] = {key: joint_numbers(key, value, model.n_joints, (key,)) for key, value in values.items()}
        law |= {"waypoints": given.get("waypoints", ()), "gravity": _gravity(given, model)}
        return (PID if "ki" in law else PD)(
            **law,
            duration=within("duration")(given["duration"], at=("duration",)) if "duration" in given else None,
        )


def _gravity(given: dict[str, Any], model: RobotModel) -> Holding | None:
    wanted = given.get("gravity", False)
    if not isinstance(wanted, bool):
        raise refuse(f"is {shown(wanted)}; it must be true or false", ("gravity",))
    return Holding(model) if wanted else None


def _goal(data: dict[str, Any], n: int) -> dict[str, Any]:
    """What the file states, with the last of its way points as the goal."""
    if "waypoints" not in data:
        return data
    for key in ("q_des", "duration"):
        if key in data:
            raise refuse("is given beside waypoints, the last of which says it; leave one of them out", (key,))
    points: list[tuple[float, tuple[float, ...]]] = []
    for i, point in enumerate(array(data["waypoints"], "an array of tables { t = …, q = […] }", at=("waypoints",))):
        at = ("waypoints", i)
        if not (isinstance(point, dict) and set(point) == {"t", "q"}):
            raise refuse(f"is {shown(point)}; it must be a table of t and q, as {{ t = 0.5, q = […] }}", at)
        t, q = within("duration")(point["t"], at=(*at, "t")), joint_numbers("q_des", point["q"], n, (*at, "q"))
        if points and t <= points[-1][0]:
            raise refuse(f"is {t}; it must be later than the one before it, {points[-1][0]} s", (*at, "t"))
        points.append((t, q))
    if not points:
        raise refuse("is empty; state at least one { t = …, q = […] }", ("waypoints",))
    return data | {"waypoints": tuple(points), "duration": points[-1][0], "q_des": points[-1][1]}
