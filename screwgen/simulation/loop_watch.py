"""Loops over a run: how far they open, and what a step does to the energy where they are nearly singular.

Forces of loops hold accelerations. A run can leave closed loops in two ways that no status tells: they drift apart, and
where rows come to depend on each other, as where a slider-crank with equal arms folds, forces grow without bound and a
step loses or creates energy.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from ..backends.c.shim import CHANGE
from ..backends.numpy.closing import OPENED, extent
from ..errors import DivergedError

if TYPE_CHECKING:
    from ..model import Model

WARNED = 1e-3
"""Mismatch, over the size of the robot or in rad, that is worth a warning."""
ERROR = 1e-2
"""The error of a step's energy, or of all steps, over the largest kinetic energy of the run, worth a warning."""
PAIRS = ("most", "mismatch", "at", "which")
FIELDS = (*(f"{name}[{k}]" for name in PAIRS for k in range(2)), "total", "kinetic", "error", "when", "sum")


class LoopWarning(UserWarning):
    """Loops that open in a run, or steps that lose energy at them; the text is one line."""


class OpenedError(DivergedError):
    """A run in which a loop has opened."""


class LoopWatch:
    """What a run finds of its loops. `values` is the memory of ``shim_loops``, an entry for each of FIELDS.

    `most`: the mismatch, m and rad, at which the run ends; `mismatch`, `at`, `which`: the largest ones, when and of
    which loop; `total`: the energy at the last step, J; `kinetic`: the largest kinetic energy; `error`, `when`: of the
    step whose energy is farthest from that of several shorter ones; `sum`: of these errors.
    """

    def __init__(self, model: Model, p: np.ndarray, q: np.ndarray):
        self.names = [junction.name for junction in model.chain.junctions]
        numeric = model.numpy(p)
        self.mismatch = numeric.mismatch
        self.sizes = np.array([extent(numeric, q), 1.0]) if self.names else np.ones(2)
        self.values = np.zeros(len(FIELDS))
        self.values[:2], self.values[8] = OPENED * self.sizes, np.nan

    def __bool__(self) -> bool:
        return bool(self.names)

    def look(self, t: float, q: np.ndarray) -> bool:
        """Whether the loops are closed enough to go on."""
        v, found = self.values, self.mismatch(q)
        for kind in range(2):
            k = int(np.argmax(found[:, kind]))
            if found[k, kind] > v[2 + kind]:
                v[2 + kind], v[4 + kind], v[6 + kind] = found[k, kind], t, k
        return bool((v[2:4] <= v[:2]).all())

    def begin(self, energy: Callable[[], np.ndarray]) -> None:
        """Note the `energy` (kinetic, potential) before the first step."""
        if np.isnan(self.values[8]):
            kinetic, potential = energy()
            self.values[8:10] = kinetic + potential, kinetic

    def weigh(self, t: float, energy: np.ndarray, work: float, again: Callable[[], np.ndarray]) -> None:
        """Note the energy after a step over which torques do `work`; `again` gives that after shorter ones."""
        v, total = self.values, float(np.sum(energy))
        v[9] = max(v[9], energy[0])
        if abs(total - v[8] - work) > CHANGE * v[9]:
            error = abs(float(np.sum(again())) - total)
            v[12] += error
            if error > v[10]:
                v[10:12] = error, t
        v[8] = total

    def opened(self) -> OpenedError:
        """The error of a run that has ended because a loop has opened."""
        kind = int(np.argmax(self.values[2:4] / self.sizes))
        return OpenedError(f"{self._said(kind)}; take a smaller step, or form 'dae', which keeps loops closed")

    def _said(self, kind: int) -> str:
        size = f"{self.values[2 + kind]:.3g} {('m', 'rad')[kind]}"
        return f"{self.names[int(self.values[6 + kind])]} has opened by {size}"

    def warn(self, stacklevel: int = 3) -> None:
        """Give what is worth it as one :class:`LoopWarning`."""
        v, said = self.values, []
        kind = int(np.argmax(v[2:4] / self.sizes))
        if self and WARNED < v[2 + kind] / self.sizes[kind] <= OPENED:
            said.append(f"{self._said(kind)} at t = {v[4 + kind]:.3g} s; take a smaller step, or form 'dae'")
        if self and v[12] > ERROR * v[9]:
            one = v[10] > ERROR * v[9]
            what = f"at t = {v[11]:.3g} s a step gets" if one else "steps get"
            share = f"{100 * v[10 if one else 12] / v[9]:.2g} % of the largest kinetic energy"
            where = "which happens where loops are nearly singular; take a smaller step"
            said.append(f"{what} the energy wrong by {share}{'' if one else ' in all'}, {where}")
        if said:
            warnings.warn("; ".join(said), LoopWarning, stacklevel=stacklevel)
