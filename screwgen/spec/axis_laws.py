"""The laws of a link's joint (:mod:`..elements`): which act on which of its coordinates, and their numbers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from ..elements import STOP, AxisElement, ElementLaw, HeldLaw, Law

if TYPE_CHECKING:
    from .link_class import LinkClass

SIDES = {"lower": -1, "upper": 1}
"""The sign of a coordinate beyond each limit."""


class LawOnAxis(NamedTuple):
    """A law on one coordinate of a link, and the labels of the numbers that it is made of, None for one that is zero.

    ``part``: `q`, or `theta` of an added coordinate; ``place``: the number there; ``side``: see
    :class:`..elements.Law`.
    """

    law: Law
    part: str
    place: int
    side: int
    labels: tuple[str | None, ...]


def laws(key: LinkClass) -> Iterator[LawOnAxis]:
    """The laws of a class, law by law; friction in transmissions depends on the posture and is not among them."""
    for axis, drive in enumerate(key.drives):
        place = ("theta", key.added_axes.index(axis)) if axis in key.added_axes else ("q", axis)
        for law, names in () if drive.travel else drive.frictions:
            yield LawOnAxis(law, *place, 1, tuple(name and f"drive_{name}_{axis + 1}" for name in names))
    for axis, side in key.stops:
        damping = f"limit_damping_{axis + 1}" if axis in key.stop_damping else None
        labels = (f"limit_{side}_{axis + 1}", f"limit_stiffness_{axis + 1}", damping)
        yield LawOnAxis(STOP, "q", axis, SIDES[side], labels)
    for kind in dict.fromkeys(kind for kind, _ in key.elements if not issubclass(kind, HeldLaw)):
        for axis in (axis for own, axis in key.elements if own is kind):
            yield LawOnAxis(ElementLaw(kind), "q", axis, 1, _element_labels(kind, axis))


class HeldOnAxis(NamedTuple):
    """A law of what a step holds of the input of an axis, and the labels of its numbers."""

    kind: type[HeldLaw]
    axis: int
    labels: tuple[str, ...]

    def unit_of_state(self, slides: bool) -> str:
        """The unit of its internal state where the drive turns an axis, or ``slides``."""
        assert self.kind.state is not None
        return self.kind.state.sliding if slides else self.kind.state.unit


def held_laws(key: LinkClass) -> Iterator[HeldOnAxis]:
    """Those of a class in the order in which they act: elements as they are stated, then limits."""
    for kind, axis in key.elements:
        if issubclass(kind, HeldLaw):
            yield HeldOnAxis(kind, axis, _element_labels(kind, axis))
    for kind, axis in key.limits:
        yield HeldOnAxis(kind, axis, tuple(f"limit_{name}_{axis + 1}" for name in kind.table()))


def _element_labels(kind: type[AxisElement], axis: int) -> tuple[str, ...]:
    return tuple(element_label(kind.KIND, name, axis) for name in kind.table())


def element_label(kind: str, name: str, axis: int) -> str:
    """The label of a key of an element of an axis."""
    return f"axis_{kind}_{name}_{axis + 1}"
