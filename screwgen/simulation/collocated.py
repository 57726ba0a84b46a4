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
from .motion import own_length, own_rest
from .rod_inertia import centreline, inertia_error
from .validity import ModelValidityWarning

TOLERANCE = 1e-4
"""The error of a section, over the length of its link, that is worth a warning."""
INERTIA = 0.01
"""The error of the inertia of a link, of accelerations under given forces, that is worth a warning."""
MOST_STATES, FEWER = 20, 3
"""Of so many states, those where the link bends most, the sections are compared, and the inertia."""


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
    inertia: float = 0.0
    """The largest part by which the inertia of the link, or of a segment, is off beside that of twice as many points,
    in any of its motions: accelerations under given forces are off by about as much."""

    @property
    def size(self) -> float:
        """The larger of both errors, over what is worth a warning."""
        return max(self.error / TOLERANCE, self.inertia / INERTIA)

    @property
    def past(self) -> bool:
        """Whether it is worth a warning."""
        return self.size > 1.0

    def text(self) -> str:
        """The errors that are worth a warning, and the remedy, in a line."""
        remedy = f"state modes.points = {self.enough}" if self.enough else "divide the link into segments"
        said = []
        if self.error > TOLERANCE:
            said.append(f"put its {self.section} {self.error:.1g} of its length beside its place")
        if self.inertia > INERTIA:
            said.append(f"leave its inertia and accelerations off by {100 * self.inertia:.2g} %")
        return f"link '{self.link}': the {self.points} points along it {' and '.join(said)}; {remedy}"


def left_out(model: RobotModel, q: np.ndarray) -> tuple[LeftOut, ...]:
    """What the points of each link of order EXACT leave out in states `q` (…, nq), at the lengths of the file."""
    return worst_of(_of_segment(model, q, i, key) for i, key in enumerate(model.chain.keys) if key.order == EXACT)


def worst_of(found: Iterable[LeftOut]) -> tuple[LeftOut, ...]:
    """The largest error of each link."""
    worst: dict[str, LeftOut] = {}
    for one in found:
        if one.link not in worst or worst[one.link].size < one.size:
            worst[one.link] = one
    return tuple(worst.values())


def warn(model: RobotModel, errors: Iterable[LeftOut], stacklevel: int = 2) -> None:
    """A :class:`ModelValidityWarning` on the link whose error is largest, where it is past; once for each link."""
    found = [x for x in errors if x.past and not model.made(("told", x.link, "points"))]
    for one in found:
        model.once(("told", one.link, "points"), lambda: True)
    if found:
        warnings.warn(max(found, key=lambda x: x.size).text(), ModelValidityWarning, stacklevel=stacklevel + 1)


def _of_segment(model: RobotModel, q: np.ndarray, i: int, key: LinkClass) -> LeftOut:
    first_mode = model.chain.eta_q + model.chain.eta_offset[i]
    every = q[..., first_mode : first_mode + key.modes].reshape(-1, key.modes)
    eta, few = _most_bent(every, MOST_STATES), _most_bent(every, FEWER)
    length, count, named = own_length(model, i), points(key), _sections(model, i)
    scale = np.array([1.0 if direction == "torsion" else 1.0 / length for direction, _ in key.directions])
    kappa_0 = length * np.array(own_rest(model, i))
    zeta = np.hstack([scale * eta, np.tile(kappa_0, (len(eta), 1))])
    finer = lambda n: replace(key, points=n)  # noqa: E731
    lines = lambda n: centreline(finer(n), zeta, tuple(named))  # noqa: E731
    errors = lambda n: np.linalg.norm(lines(2 * n) - lines(n), axis=2).max(axis=0, initial=0.0)  # noqa: E731
    inertia = lambda n: inertia_error(finer(n), scale * few, kappa_0)  # noqa: E731
    first, off = errors(count), inertia(count)
    enough = (n for n in range(count, MAX_POINTS + 1) if errors(n).max() <= TOLERANCE and inertia(n) <= INERTIA)
    worst, owner = int(np.argmax(first)), model.chain.segments[i].owner
    return LeftOut(owner, float(first[worst]), count, next(enough, None), list(named.values())[worst], off)


def _most_bent(eta: np.ndarray, most: int) -> np.ndarray:
    """Of the modal coordinates (N, r) of states the largest, at most so many, without states that are not finite."""
    eta = eta[np.isfinite(eta).all(axis=1)]
    sizes = np.linalg.norm(eta, axis=1)
    return eta[np.argpartition(-sizes, most)[:most]] if len(eta) > most else eta


def _sections(model: RobotModel, i: int) -> dict[float, str]:
    """The places along a segment that functions report, or that carry links, with what to call them."""
    segment, known = model.chain.segments[i], {TIP: "tip"}
    share = segment.number / segment.count
    known |= {s: f"section at s = {share + s / segment.count:.4g}" for s in model.chain.keys[i].stations_at}
    own = [x for x in model.chain.markers if x.segment == i and not x.is_tip]
    return known | {x.at: f"marker '{x.name.split('.')[-1]}'" for x in own}
