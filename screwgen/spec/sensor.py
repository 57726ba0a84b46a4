"""Sensors that a `Robot` of Python holds besides those that the product knows: their check; what one is:
:mod:`..algorithms.measurement`.
"""

from __future__ import annotations

import re
from typing import Any

from .values import objects, quoted, refuse

NAME = re.compile("[a-z][a-z0-9_]*", re.IGNORECASE)


class Sensor:
    """What a robot may hold in `sensors`: rows of :class:`screwgen.algorithms.measurement.Measurement`."""

    name: str
    """An identifier: of the function of the robot, of the keyword of an update, of members in C."""


def sensors_in_python(value: Any) -> tuple[Sensor, ...]:
    """The check of `sensors`: rows of measurements with names of their own."""
    own = objects(value, Sensor, "a screwgen.algorithms.measurement.Measurement")
    for k, one in enumerate(own):
        if not NAME.fullmatch(one.name):
            raise refuse(f"is called {quoted(one.name)}; take a name of letters, digits and '_'", (k,))
        if one.name in [other.name for other in own[:k]]:
            raise refuse(f"is called {quoted(one.name)} again; take another name", (k,))
    return own
