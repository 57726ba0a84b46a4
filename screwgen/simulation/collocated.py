"""What the points of rods of order EXACT leave out in states: their sections beside those with twice as many."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from ..bodies.collocation import points
from ..robot_model import RobotModel
from ..spec.link_class import EXACT, LinkClass
from ..spec.markers import TIP
from ..spec.values import MAX_POINTS
from .motion import bent_rod, own_length
from .validity import ModelValidityWarning

TOLERANCE = 1e-4
"""The error of a section, over the length of its link, that is worth a warning."""
MOST_STATES = 20
"""Of so many states, those where the link bends most, the sections are compared."""


@dataclass(frozen=True)
class LeftOut:
    """The largest error of a link's sections in some states; of a link with segments that of the worst segment.

    Its sections are its tip, its markers, and those that carry other links.
    """

    link: str
    error: float
    """How far the worst section is from where twice as many points put it, over the length of the link or segment."""
    points: int
    """How many points the link has."""
    enough: int | None
    """How many keep the error below `TOLERANCE`; None: more than a file can state."""
    section: str = "tip"
    """The worst section: "tip", "marker 'name'", or "section at s = …"."""

    @property
    def past(self) -> bool:
        """Whether it is worth a warning."""
        return self.error > TOLERANCE

    def text(self) -> str:
        """The error and the remedy, in a line."""
        remedy = f"state modes.points = {self.enough}" if self.enough else "divide the link into segments"
        said = (
            f"the {self.points} points along it put its {self.section} {self.error:.1g} of its length beside its place"
        )
        return f"link '{self.link}': {said}; {remedy}"


def left_out(model: RobotModel, q: np.ndarray) -> tuple[LeftOut, ...]:
    """What the points of each link of order EXACT leave out in states `q` (…, nq), at the lengths of the file."""
    return worst_of(_of_segment(model, q, i, key) for i, key in enumerate(model.chain.keys) if key.order == EXACT)


def worst_of(found: Iterable[LeftOut]) -> tuple[LeftOut, ...]:
    """The largest error of each link."""
    worst: dict[str, LeftOut] = {}
    for one in found:
        if one.link not in worst or worst[one.link].error < one.error:
            worst[one.link] = one
    return tuple(worst.values())


def warn(model: RobotModel, errors: Iterable[LeftOut], stacklevel: int = 2) -> None:
    """A :class:`ModelValidityWarning` on the link whose error is largest, where it is past; once for each link."""
    found = [x for x in errors if x.past and not model.made(("told", x.link, "points"))]
    for one in found:
        model.once(("told", one.link, "points"), lambda: True)
    if found:
        warnings.warn(max(found, key=lambda x: x.error).text(), ModelValidityWarning, stacklevel=stacklevel + 1)


def _of_segment(model: RobotModel, q: np.ndarray, i: int, key: LinkClass) -> LeftOut:
    first_mode = model.chain.eta_q + model.chain.eta_offset[i]
    eta = _most_bent(q[..., first_mode : first_mode + key.modes].reshape(-1, key.modes))
    length, count, named = own_length(model, i), points(key), _sections(model, i)
    lines = lambda n: bent_rod(replace(key, points=n), length, eta, tuple(named))  # noqa: E731
    errors = lambda n: np.linalg.norm(lines(2 * n) - lines(n), axis=2).max(axis=0, initial=0.0) / length  # noqa: E731
    first = errors(count)
    more = range(count + 1, MAX_POINTS + 1)
    enough = count if first.max() <= TOLERANCE else next((n for n in more if errors(n).max() <= TOLERANCE), None)
    worst = int(np.argmax(first))
    return LeftOut(model.chain.segments[i].owner, float(first[worst]), count, enough, list(named.values())[worst])


def _most_bent(eta: np.ndarray) -> np.ndarray:
    """Of the modal coordinates (N, r) of states those that are largest, without states that are not finite."""
    eta = eta[np.isfinite(eta).all(axis=1)]
    sizes = np.linalg.norm(eta, axis=1)
    return eta[np.argpartition(-sizes, MOST_STATES)[:MOST_STATES]] if len(eta) > MOST_STATES else eta


def _sections(model: RobotModel, i: int) -> dict[float, str]:
    """The places along a segment that functions report, or that carry links, with what to call them."""
    segment, known = model.chain.segments[i], {TIP: "tip"}
    share = segment.number / segment.count
    known |= {s: f"section at s = {share + s / segment.count:.4g}" for s in model.chain.keys[i].stations_at}
    own = [x for x in model.chain.markers if x.segment == i and not x.is_tip]
    return known | {x.at: f"marker '{x.name.split('.')[-1]}'" for x in own}
