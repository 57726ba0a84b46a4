"""What the points of rods of order EXACT leave out in states: their tips beside those with twice as many."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, replace

import numpy as np

from ..bodies.collocation import points
from ..robot_model import RobotModel
from ..spec.link_class import EXACT, LinkClass
from ..spec.values import MAX_POINTS
from .motion import bent_rod, modal, own_length
from .validity import ModelValidityWarning

TOLERANCE = 1e-4
"""The error of a tip, over the length of its link, that is worth a warning."""
MOST_STATES = 20
"""Of so many states, those where the link bends most, the tips are compared."""


@dataclass(frozen=True)
class LeftOut:
    """The largest error of a link's tip in some states; of a link with segments that of the worst segment."""

    link: str
    error: float
    """How far the tip is from where twice as many points put it, over the length of the link or of its segment."""
    points: int
    """How many points the link has."""
    enough: int | None
    """How many keep the error below `TOLERANCE`; None: more than a file can state."""

    @property
    def past(self) -> bool:
        """Whether it is worth a warning."""
        return self.error > TOLERANCE

    def text(self) -> str:
        """The error and the remedy, in a line."""
        remedy = f"state modes.points = {self.enough}" if self.enough else "divide the link into segments"
        said = f"the {self.points} points along it put its tip {self.error:.1g} of its length beside its place"
        return f"link '{self.link}': {said}; {remedy}"


def left_out(model: RobotModel, q: np.ndarray) -> tuple[LeftOut, ...]:
    """What the points of each link of order EXACT leave out in the states `q` (N, nq)."""
    worst: dict[str, LeftOut] = {}
    for i, key in enumerate(model.chain.keys):
        if key.order == EXACT:
            found = _of_segment(model, q, i, key)
            if found.link not in worst or worst[found.link].error < found.error:
                worst[found.link] = found
    return tuple(worst.values())


def warn(model: RobotModel, q: np.ndarray) -> None:
    """A :class:`ModelValidityWarning` on the link whose error is largest, where it is past; once for each link."""
    found = [x for x in left_out(model, q) if x.past and not model.made(("told", x.link, "points"))]
    for one in found:
        model.once(("told", one.link, "points"), lambda: True)
    if found:
        warnings.warn(max(found, key=lambda x: x.error).text(), ModelValidityWarning, stacklevel=3)


def _of_segment(model: RobotModel, q: np.ndarray, i: int, key: LinkClass) -> LeftOut:
    eta, length, count = modal(model, q, i), own_length(model, i), points(key)
    eta = eta[np.argsort(-np.linalg.norm(eta, axis=1))[:MOST_STATES]]
    tips = lambda n: bent_rod(replace(key, points=n), length, eta, (1.0,))[:, 0]  # noqa: E731
    error = lambda n: float(np.linalg.norm(tips(2 * n) - tips(n), axis=1).max(initial=0.0)) / length  # noqa: E731
    first = error(count)
    more = range(count + 1, MAX_POINTS + 1)
    enough = count if first <= TOLERANCE else next((n for n in more if error(n) <= TOLERANCE), None)
    return LeftOut(model.chain.segments[i].owner, first, count, enough)
