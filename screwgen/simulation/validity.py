"""Validity of a motion or posture: measures, bounds of the first-order model, and warnings.

Every link has four measures (`bodies.validity`). At its bound, each effect that the model neglects changes the tip
deflection or the lowest frequency of a uniform clamped link by about 1 %:

`deflection`  elastica under a tip force, d the deflection over the length: first order is off by `36/35 d^2`
`slope`       elastica under a tip moment: first order is off by `slope^2 / 12`
`axial_load`  P of the buckling load: frequencies are off by the factor `sqrt(1 - P)`, deflections by `1 - P`
`rotation`    lambda = Omega^2 rhoA l^4 / EI: the lowest frequency rises by the factor `sqrt(1 + 1.193 lambda / 12.36)`
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ..arguments import Given, Loads, Numbers
from ..bodies.validity import BOUNDS as BOUND
from ..bodies.validity import MEASURES
from ..errors import DivergedError
from ..robot_model import RobotModel
from ..spec.needs import MOST_SEGMENTS
from ..spec.segments import is_marker, owner
from .definiteness import indefinite

FAR = 1.0
"""Deflection over length at which a run ends."""
JUMP = 2.0
"""Deflection over length that no motion reaches between two evaluations: beyond it the integration is unstable."""


class ModelValidityWarning(UserWarning):
    """A link is past the bounds of the first-order model; the text is one line."""


class ModelLeftError(DivergedError):
    """A run in which a link bends by its own length."""


class Measure(NamedTuple):
    """A measure: its name, its bound and its texts."""

    meaning: str
    missing: str
    """The effect that the model neglects."""
    off: str
    """The quantity whose relative error is `error`."""
    error: Callable[[float], float]
    """The relative error to expect at a value."""
    segments: Callable[[float], float]
    """The number of equal segments that are within the bounds, from the value over its bound."""


TENSION = 2 / math.pi**2 * BOUND["rotation"] / BOUND["axial_load"]
"""The first of k segments of a rotating link carries the centrifugal force of the others, `rhoA Omega^2 l^2 / 2`. As an
axial load this is `2 rotation / (pi^2 k^2)`."""
STIFFENING = 1.193 / 12.362
"""Relative rise of the squared lowest frequency of a clamped beam with rotation: Southwell's coefficient."""

KINDS: dict[str, Measure] = {
    "deflection": Measure(
        "tip deflection over length",
        "large deflections",
        "tip deflection",
        lambda d: 36 / 35 * d**2,
        lambda share: 1.5 * share,  # under a tip force the base has 1.5 times the mean curvature that deflects the tip
    ),
    "slope": Measure(
        "slope of the tip in rad",
        "large deflections",
        "tip deflection",
        lambda x: x**2 / 12,
        lambda share: share,
    ),
    "axial_load": Measure(
        "axial load over buckling load",
        "the stiffness that axial load takes or gives",
        "lowest frequency",
        lambda p: abs(math.sqrt(max(1 - p, 0.0)) - 1),
        math.sqrt,
    ),
    "rotation": Measure(
        "rotation, Omega^2 rhoA l^4 / EI",
        "centrifugal stiffening",
        "lowest frequency",
        lambda x: math.sqrt(1 + STIFFENING * x) - 1,
        lambda share: math.sqrt(TENSION * share),
    ),
}
BOUNDS = np.array([BOUND[name] for name in MEASURES])
"""(4,): the bounds, in the order of `bodies.validity.MEASURES`."""


@dataclass(frozen=True)
class Finding:
    """One measure of one link that is past its bound; of a link with segments, that of the segment farthest past it."""

    link: str
    segment: str
    """The segment's name, `boom[2]`; the link's if it has only one."""
    count: int
    """The number of segments that the link has."""
    measure: str
    value: float
    """The largest one, with its sign: an axial load < 0 is tension."""
    bound: float
    error: float
    """The relative error to expect, of the tip deflection or of the lowest frequency."""
    first: float | None
    """When it was first seen past the bound, s; None at rest or in a state."""
    at: float | None
    """When it was largest, s."""

    @property
    def share(self) -> float:
        """How many times the bound."""
        return abs(self.value) / self.bound

    @property
    def unstable(self) -> bool:
        """Whether the straight link buckles."""
        return self.measure == "axial_load" and self.value >= 1

    @property
    def segments(self) -> int:
        """The number of segments that the link should have."""
        factor = min(MOST_SEGMENTS, KINDS[self.measure].segments(self.share))
        return min(MOST_SEGMENTS, self.count * max(2, math.ceil(factor)))

    def text(self) -> str:
        """The text: link, excess, time, and expected error."""
        kind = KINDS[self.measure]
        when = "" if self.first is None else f", first past it at t = {self.first:.4g} s, largest at {self.at:.4g} s"
        where = subject(self.segment, self.count)
        said = f"{where}: {kind.meaning} is {self.value:.3g}, past its bound {self.bound:g}{when}"
        if self.unstable:
            return f"{said}: the straight state is unstable, which this model of first order does not see"
        return f"{said}: the model leaves out {kind.missing}, so expect the {kind.off} {percent(self.error)} off"

    def remedy(self) -> str:
        """The suggested remedy."""
        order = "order = 2 or " if self.measure in ("axial_load", "rotation") else ""
        now = f" (it has {self.count})" if self.count > 1 else ""
        split = f"give the link {order}segments = {self.segments}{now}"
        if self.unstable:
            return f"lower the load or stiffen the link, or {split}"
        return f"{split}, stiffen it or lower its load"


def subject(name: str, count: int) -> str:
    """What a message is about: a link, with its segment if it has several."""
    return f"link '{owner(name)}'" + (f", segment {name} of {count}" if count > 1 else "")


def percent(error: float) -> str:
    """An error as a percentage, or a text if it is beyond the estimate's range."""
    return f"{100 * error:.2g} %" if error < 1 else "100 % or more"


@dataclass(frozen=True, eq=False)
class Validity:
    """The measures of n links, in a state or over a motion; a link with segments has one row for each of them."""

    links: tuple[str, ...]
    """The names of the links, of segments `boom[2]`."""
    values: np.ndarray
    """(n, 4): deflection, slope, axial_load, rotation; over a motion the largest, with its sign."""
    first: np.ndarray | None = None
    """(n, 4): when each was first seen past its bound, s; NaN if never. None in a state."""
    at: np.ndarray | None = None
    """(n, 4): when each was largest, s."""
    indefinite: str = ""
    """What is wrong with the mass matrix of a posture, as :func:`.definiteness.indefinite` says; empty if nothing."""

    @property
    def findings(self) -> list[Finding]:
        """The measures past their bounds, the farthest first; of a link with segments those of its worst segment."""
        worst = ((int(i), k, len(rows)) for rows in self._rows().values() for k, i in enumerate(self._worst(rows)))
        past = [self._finding(i, k, count) for i, k, count in worst if abs(self.values[i, k]) > BOUNDS[k]]
        return sorted(past, key=lambda f: (-f.unstable, -f.share))

    @property
    def buckled(self) -> tuple[str, ...]:
        """The links whose axial load is beyond their buckling load."""
        return tuple(f.link for f in self.findings if f.unstable)

    @property
    def holds(self) -> bool:
        """Whether all measures are within their bounds, and the mass matrix of a posture is definite."""
        return not self.findings and not self.indefinite

    def _rows(self) -> dict[str, list[int]]:
        """The rows of each link."""
        out: dict[str, list[int]] = {}
        for i, name in enumerate(self.links):
            if not is_marker(name):
                out.setdefault(owner(name), []).append(i)
        return out

    def _worst(self, rows: Sequence[int]) -> np.ndarray:
        """Of some rows, that with the largest value of each measure."""
        size = np.abs(self.values[rows])
        return np.array(rows)[np.argmax(np.where(np.isnan(size), 0.0, size), axis=0)]

    def by_link(self) -> dict[str, np.ndarray]:
        """The measures (4,) of each link; with segments each is that of the segment where it is largest."""
        columns = range(len(MEASURES))
        return {name: self.values[self._worst(rows), columns] for name, rows in self._rows().items()}

    def _finding(self, i: int, k: int, count: int) -> Finding:
        name, value = MEASURES[k], float(self.values[i, k])
        first, at = (None if x is None else float(x[i, k]) for x in (self.first, self.at))
        named = owner(self.links[i]), self.links[i], count
        return Finding(*named, name, value, BOUND[name], KINDS[name].error(value), first, at)

    def line(self, known: Callable[[Finding], bool] = lambda _: False) -> str:
        """One line on the farthest that is not `known`; empty if all are within their bounds, or known."""
        found = self.findings
        if self.indefinite:
            return self.indefinite
        new = next((finding for finding in found if not known(finding)), None)
        if new is None:
            return ""
        more = f"; {len(found) - 1} more past their bounds, see analyse" if len(found) > 1 else ""
        return f"{new.text()}; {new.remedy()}{more}"

    def warn(self, model: RobotModel | None = None, stacklevel: int = 2) -> None:
        """Give the line as a :class:`ModelValidityWarning`, if there is one.

        With a `model` each measure of each link of it is warned of once.
        """
        known = lambda finding: model is not None and model.made(_told(finding))  # noqa: E731
        if line := self.line(known):
            for finding in self.findings:
                if model is not None:
                    model.once(_told(finding), lambda: True)
            warnings.warn(line, ModelValidityWarning, stacklevel=stacklevel + 1)

    def record(self) -> dict[str, Any]:
        """For JSON: the measures of every link, and those past their bounds."""
        plain = lambda x: float(x) + 0.0 if math.isfinite(x) else None  # noqa: E731
        measures = {x: dict(zip(MEASURES, map(plain, row), strict=True)) for x, row in self.by_link().items()}
        past = [
            {"link": f.link, "measure": f.measure, "value": plain(f.value), "bound": f.bound, "error": plain(f.error)}
            | ({"segment": f.segment} if f.count > 1 else {})
            | ({} if f.first is None else {"first": f.first, "at": f.at})
            for f in self.findings
        ]
        more = {"indefinite": self.indefinite} if self.indefinite else {}
        return {"measures": measures, "past": past} | more

    def table(self) -> str:
        """The measures of every link beside their bounds, for a terminal."""
        links = self.by_link()
        width = max(8, *map(len, links))
        lines = [" " * width + "".join(f"{name:>14}" for name in MEASURES)]
        for link, row in links.items():
            marks = ("*" if abs(x) > bound else " " for x, bound in zip(row, BOUNDS, strict=True))
            cells = (f"{x:>13.4g}{mark}" for x, mark in zip(row, marks, strict=True))
            lines.append(f"{link:{width}}" + "".join(cells))
        lines.append(f"{'bound':{width}}" + "".join(f"{bound:>13g} " for bound in BOUNDS))
        return "\n".join(lines)


def _told(finding: Finding) -> tuple[str, str, str]:
    """What stands for a warning."""
    return "told", finding.link, finding.measure


@dataclass
class Watch:
    """Gathers the measures of a motion; see :class:`Validity` for the arrays (n, 4)."""

    links: Sequence[str]
    values: np.ndarray = field(init=False)
    first: np.ndarray = field(init=False)
    at: np.ndarray = field(init=False)

    def __post_init__(self) -> None:
        shape = (len(self.links), len(MEASURES))
        self.values, self.at, self.first = np.zeros(shape), np.zeros(shape), np.full(shape, np.nan)

    def __call__(self, t: float, measures: np.ndarray) -> bool:
        """Take the measures (n, 4) at an instant; says whether no link bends by more than its length."""
        size = np.abs(measures)
        larger, past = size > np.abs(self.values), (size > BOUNDS) & np.isnan(self.first)
        self.values[larger], self.at[larger], self.first[past] = measures[larger], t, t
        return not (size[:, 0] > FAR).any()

    @property
    def jumped(self) -> bool:
        """Whether a deflection is too large for a stable integration."""
        return bool((self.values[:, 0] > JUMP).any())

    def left(self, explicit: str = "") -> ModelLeftError:
        """The error of a link that bends by its own length; ``explicit`` names an integrator that may have done it."""
        name = self.links[int(np.argmax(self.values[:, 0]))]
        count = sum(owner(name) == owner(other) for other in self.links if not is_marker(other))
        said = f"{subject(name, count)} bends by more than its length: a model of small deflections has ended there"
        more = "segments" if count == 1 else f"more than {count} segments"
        if explicit:
            what = f"the integrator '{explicit}' diverged; if not, {said}"
            return ModelLeftError(f"{what}, and it needs {more}; take a smaller step, or modal_midpoint")
        return ModelLeftError(f"{said}; give the link {more}, stiffen it or lower its load")

    def validity(self) -> Validity:
        """The measures gathered so far."""
        return Validity(tuple(self.links), self.values.copy(), self.first.copy(), self.at.copy())


# ------------------------------------------------------------------------------ of a model


def validity(
    model: RobotModel,
    q: Numbers,
    v: Numbers | None = None,
    tau: Loads = None,
    w_ext: Loads = None,
    parameters: Given = None,
) -> Validity:
    """The implementation of :meth:`screwgen.Model.validity`."""
    values = model.numpy(parameters).validity(q, v, tau, w_ext)
    return Validity(tuple(model.chain.names), values, indefinite=indefinite(model, q, parameters))


def validity_at_rest(model: RobotModel, q: Numbers, w_ext: Loads = None, parameters: Given = None) -> Validity:
    """The implementation of :meth:`screwgen.Model.validity_at_rest`."""
    values = model.numpy(parameters).validity_at_rest(q, w_ext)
    return Validity(tuple(model.chain.names), values, indefinite=indefinite(model, q, parameters))
