"""The contract of a relation between two axes: a coupling whose ratio changes with the posture, such as a cam.

An example: ``f(x) = x + 0.2 sin(x)``. The following axis is at ``ratio f(x) + offset`` where the other is at x. Its
rate and the force that the coupling exerts follow from f', its acceleration and the changes of forces from further
derivatives; all of these are derived from f.
"""

from __future__ import annotations

from collections.abc import Hashable
from typing import Any, Protocol

from .law import Value


class Relation(Hashable, Protocol):
    """A function of a coordinate, smooth enough to be differentiated three times. Equal relations compare equal."""

    @property
    def words(self) -> str:
        """What it is called in comments, as `cam`."""

    def position(self, t: Any, x: Value) -> Value:
        """f at a coordinate x (rad, of a slide m); of the tracer ``t`` as laws use it, see :mod:`.law`."""
