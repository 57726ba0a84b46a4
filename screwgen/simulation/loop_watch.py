"""Loops over a run: how far they open, and what a step does to the energy where they are nearly singular.

Forces of loops hold accelerations. A run can leave closed loops in two ways that no status tells: they drift apart, and
where rows come to depend on each other, as where a slider-crank with equal arms folds, forces grow without bound and a
step loses or creates energy.
"""

from __future__ import annotations

import ctypes
import math
import warnings
from collections.abc import Callable

import numpy as np

from ..backends.c.shim import CHANGE
from ..backends.numpy.closing import OPENED, extent
from ..errors import DivergedError
from ..robot_model import RobotModel

WARNED = 1e-3
"""Mismatch, over the size of the robot or in rad, that is worth a warning."""
ERROR = 1e-2
"""The error of a step's energy, or of all steps, over the largest kinetic energy of the run, worth a warning."""

GAINED = 5e-2
"""The energy that a run gains out of nothing, over its largest kinetic energy, worth a warning."""


class LoopWarning(UserWarning):
    """Loops that open in a run, or steps that lose energy at them; the text is one line."""


class OpenedError(DivergedError):
    """A run in which a loop has opened."""


PAIR = ctypes.c_double * 2
"""A distance, m, and an angle, rad."""


class LoopRecord(ctypes.Structure):
    """``shim_loops`` of the library: what a run has seen of its loops.

    `most`: the mismatch at which the run ends; `mismatch`, `at`, `which`: the largest so far, when, s, and of which
    loop; `total`: the energy after the last step, J, not a number before the first; `kinetic`: the largest kinetic
    energy; `error`, `when`: of the step whose energy is farthest from that of several shorter ones; `sum`: of these;
    `balance`: the energy that steps without wrenches on tips have gained besides the work of the inputs, `gained` and
    `by`: the most of it, and when.
    """

    _fields_ = (
        *((name, PAIR) for name in ("most", "mismatch", "at", "which")),
        *((name, ctypes.c_double) for name in ("total", "kinetic", "error", "when", "sum", "balance", "gained", "by")),
    )


class LoopWatch:
    """What a run finds of its loops, in `seen`, which its C shares."""

    def __init__(self, model: RobotModel, p: np.ndarray, q: np.ndarray):
        self.names = [junction.name for junction in model.chain.closing.junctions]
        numeric = model.numpy(p)
        self.mismatch = numeric.mismatch
        self.sizes = (extent(numeric, q), 1.0) if self.names else (1.0, 1.0)
        self.seen = LoopRecord(most=PAIR(*(OPENED * size for size in self.sizes)), total=math.nan)

    def __bool__(self) -> bool:
        return bool(self.names)

    def look(self, t: float, q: np.ndarray) -> bool:
        """Whether the loops are closed enough to go on."""
        if not self:
            return True
        seen, found = self.seen, self.mismatch(q)
        for kind in range(2):
            k = int(np.argmax(found[:, kind]))
            if not found[k, kind] <= seen.mismatch[kind]:
                seen.mismatch[kind], seen.at[kind], seen.which[kind] = found[k, kind], t, k
        return all(seen.mismatch[kind] <= seen.most[kind] for kind in range(2))

    def begin(self, energy: Callable[[], np.ndarray]) -> None:
        """Note the `energy` (kinetic, potential) before the first step."""
        if math.isnan(self.seen.total):
            kinetic, potential = energy()
            self.seen.total, self.seen.kinetic = kinetic + potential, kinetic

    def weigh(self, t: float, energy: np.ndarray, work: float, again: Callable[[], np.ndarray], alone: bool) -> None:
        """Note the energy after a step over which the inputs do `work`; `again` gives that after shorter ones.

        `alone`: nothing else does work.
        """
        seen, total = self.seen, float(np.sum(energy))
        seen.kinetic = max(seen.kinetic, energy[0])
        if abs(total - seen.total - work) > CHANGE * seen.kinetic:
            error = abs(float(np.sum(again())) - total)
            seen.sum += error
            if error > seen.error:
                seen.error, seen.when = error, t
        seen.balance += total - seen.total - work if alone else 0.0
        if seen.balance > seen.gained:
            seen.gained, seen.by = seen.balance, t
        seen.total = total

    def opened(self) -> OpenedError:
        """The error of a run that has ended because a loop has opened."""
        return OpenedError(f"{self._said(self._worst)}; take a smaller step, or form 'dae', which keeps loops closed")

    @property
    def _worst(self) -> int:
        """Which is the larger mismatch: 0, the distance over the size of the robot, or 1, the angle."""
        return int(self.seen.mismatch[1] > self.seen.mismatch[0] / self.sizes[0])

    def _said(self, kind: int) -> str:
        size = f"{self.seen.mismatch[kind]:.3g} {('m', 'rad')[kind]}"
        return f"{self.names[int(self.seen.which[kind])]} has opened by {size}"

    def warn(self, stacklevel: int = 3) -> None:
        """Give what is worth it as one :class:`LoopWarning`."""
        if said := [text for text in (self._opening(), self._losing()) if text]:
            warnings.warn("; ".join(said), LoopWarning, stacklevel=stacklevel)

    def _opening(self) -> str:
        kind = self._worst
        if self.seen.mismatch[kind] <= WARNED * self.sizes[kind]:
            return ""
        return f"{self._said(kind)} at t = {self.seen.at[kind]:.3g} s; take a smaller step, or form 'dae'"

    def _losing(self) -> str:
        one, all_of_it = (x > ERROR * self.seen.kinetic for x in (self.seen.error, self.seen.sum))
        if not one and (said := self._gaining()):
            return said
        if not all_of_it:
            return ""
        what = f"at t = {self.seen.when:.3g} s a step gets" if one else "steps get"
        part = (self.seen.error if one else self.seen.sum) / self.seen.kinetic
        share = f"{100 * part:.2g} % of the largest kinetic energy{'' if one else ' in all'}"
        return f"{what} the energy wrong by {share}, which happens where loops are nearly singular; take a smaller step"

    def _gaining(self) -> str:
        """Dampers take energy, and no step may give any: what a long run gains comes from steps of low order."""
        part = self.seen.gained / (self.seen.kinetic or 1.0)
        if not part > GAINED:
            return ""
        share = f"{100 * part:.2g} % of the largest kinetic energy out of nothing"
        return f"by t = {self.seen.by:.3g} s steps have gained {share}; take a smaller step, or a higher order"
