"""What `tau` holds: a row for each kind of input, in the order of their entries."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

from ..errors import UsageError
from .base import BASE_MOTION, EFFORT_UNITS
from .brake import BRAKES, braked
from .forces import FORCE_INPUTS
from .input import Input
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

    def of_links(self, chain: Any) -> list[list[int]]:
        return [list(range(*ends)) for ends in pairwise(chain.tau_offset)]


TORQUES = Torques()
OTHERS: tuple[Input, ...] = (TENSIONS, BRAKES, BASE_MOTION, FORCE_INPUTS)
"""Those that a robot file may state besides."""
KIND = re.compile(rf"\.({'|'.join(kind for row in (TORQUES, *OTHERS) for kind in row.kinds)})(?=\[|$)")
"""The kind of an input in its name."""


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
    found = {f"{link.name}.acceleration[{j}]": f"{link.name}.effort[{j}]" for link, j in _given(robot)}
    found |= {f"{link.name}.brake[{j}]": f"{link.name}.brake_effort[{j}]" for link, j in braked(robot)}
    found |= {name: f"base.twist_effort[{k}]" for k, name in enumerate(BASE_MOTION.names(robot))}
    return [found.get(name, name) for name in input_names(robot)]


def _given(robot: Robot) -> Iterator[tuple[Link, int]]:
    return ((link, axis) for link in robot.links for axis in link.joint.prescribed)


def effort_units(robot: Robot) -> list[str]:
    """Their units."""
    axes = [
        (screw, own) for link in robot.links for screw, own in zip(link.joint.screws, link.joint.driven, strict=True)
    ]
    found = [own.effort(screw)[1] for screw, own in axes] + input_units(robot)[len(axes) :]
    at = {name: k for k, name in enumerate(input_names(robot))}
    for link, axis in braked(robot):
        turns = link.joint.driven[axis].elastic or link.joint.screws[axis].turn
        found[at[f"{link.name}.brake[{axis}]"]] = "N·m" if turns else "N"
    for name, unit in zip(BASE_MOTION.names(robot), EFFORT_UNITS, strict=False):
        found[at[name]] = unit
    return found


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
