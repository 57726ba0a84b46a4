"""What `tau` holds: a row for each kind of input, in the order of their entries."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

from ..errors import UsageError
from .base import BASE_ACCELERATION, BASE_MOTION
from .brake import BRAKES
from .forces import FORCE_INPUTS
from .input import Input, InputLine
from .robot import Link, Robot
from .tendons import TENSIONS


class Torques(Input):
    """Torques of joint axes, of those that slide forces; where drives are elastic they act on rotors.

    Of an axis whose motion is given its acceleration; where its drive is elastic that of the rotor.
    """

    words = "torques of axes"
    kinds = ("torque", "force", "acceleration")
    signal = "tau"
    chosen = True

    def names(self, robot: Robot) -> list[str]:
        return [f"{link.name}.{name}[{j}]" for link, j, name, _ in efforts(robot)]

    def units(self, robot: Robot) -> list[str]:
        return [unit for *_, unit in efforts(robot)]

    def efforts(self, robot: Robot) -> list[tuple[str, str]]:
        out = []
        for link in robot.links:
            for j, (screw, own) in enumerate(zip(link.joint.screws, link.joint.driven, strict=True)):
                name, unit = own.effort(screw)
                out.append((f"{link.name}.{'effort' if j in link.joint.prescribed else name}[{j}]", unit))
        return out

    def lines(self, chain: Any, first: int) -> list[InputLine]:
        return [InputLine(rf"\tau_{{{k + 1}}}", self._acts(chain, k)) for k in range(chain.n_joints)]

    def _acts(self, chain: Any, k: int) -> str:
        link = next(i for i in range(chain.n) if chain.tau_offset[i] <= k < chain.tau_offset[i + 1])
        key = chain.keys[link]
        kind = key.travels.get(k - chain.tau_offset[link])
        where = f"the joint of link {link + 1}" + f", $q_{{{k + 1}}}$" * bool(key.screws)
        rotor = k in chain.added_joints and kind is None
        if k in chain.prescribed:
            return f"is the acceleration of {'the rotor that drives ' * rotor}{where}"
        if rotor:
            return f"the rotor that drives {where}"
        return f"{where}, through a {kind.WORD}" if kind is not None else where

    def of_links(self, chain: Any) -> list[list[int]]:
        return [list(range(*ends)) for ends in pairwise(chain.tau_offset)]


TORQUES = Torques()
OTHERS: tuple[Input, ...] = (TENSIONS, BRAKES, BASE_MOTION, BASE_ACCELERATION, FORCE_INPUTS)
"""Those that a robot file may state besides."""


def _kind_in(rows: Sequence[Input]) -> re.Pattern[str]:
    return re.compile(rf"\.({'|'.join(kind for row in rows for kind in row.kinds)})(?=\[|$)")


KIND = _kind_in((TORQUES, *OTHERS))
"""The kind of an input in its name."""
WORD = _kind_in([row for row in (TORQUES, *OTHERS) if not row.apart])
"""The same where the name tells whose input it is without it."""


def inputs(robot: Robot) -> tuple[Input, ...]:
    """The kinds of input of a robot, torques of axes first."""
    for row in (FORCE_INPUTS, *robot.inputs):
        if taken := next((name for name in row.names(robot) if KIND.search(name)), None):
            what = f"is a name that the product's own inputs have; end the names of {row.words} otherwise"
            raise UsageError(f"inputs: '{taken}' {what}")
    return TORQUES, *(row for row in (*OTHERS, *robot.inputs) if row.names(robot))


def places(names: Sequence[str], row: Input | None) -> list[int]:
    """Which of the names of inputs are of a kind; None: of none that a robot file may state."""
    found = [KIND.search(name) for name in names]
    return [k for k, kind in enumerate(found) if (kind and kind[1]) in (row.kinds if row else (None,))]


def input_names(robot: Robot) -> list[str]:
    """The names of the entries of `tau`."""
    return [name for row in inputs(robot) for name in row.names(robot)]


def input_units(robot: Robot) -> list[str]:
    """Their units: N·m for axes that turn and for rotors, N for axes that slide, cylinders and tendons."""
    return [unit for row in inputs(robot) for unit in row.units(robot)]


def effort_names(robot: Robot) -> list[str]:
    """The names of what drives exert: those of `tau`, and `arm.effort[0]` where the motion of an axis is given.

    Of a brake `arm.brake_effort[0]`, of a base whose motion is given `base.twist_effort[0]`.
    """
    return [name for row in inputs(robot) for name, _ in row.efforts(robot)]


def effort_units(robot: Robot) -> list[str]:
    """Their units."""
    return [unit for row in inputs(robot) for _, unit in row.efforts(robot)]


def quantities(robot: Robot) -> list[str]:
    """The key of `ranges.RANGES` of each."""
    return [row.quantity for row in inputs(robot) for _ in row.names(robot)]


def efforts(robot: Robot) -> Iterator[tuple[Link, int, str, str]]:
    """Link and number of every axis, and what its input is called, with its unit: that of the axis, or of its drive."""
    for link in robot.links:
        for j, (screw, own) in enumerate(zip(link.joint.screws, link.joint.driven, strict=True)):
            turns = own.elastic or screw.turn
            given = ("acceleration", "rad/s²" if turns else "m/s²")
            yield link, j, *(given if j in link.joint.prescribed else own.effort(screw))
