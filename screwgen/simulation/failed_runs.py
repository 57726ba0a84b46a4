"""Why a run failed: the first cause comes first, a loop of control before the links that it shakes."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import numpy as np

from ..backends.numpy.closing import OpenLoopError, closed
from ..errors import DivergedError, SingularError
from .control_loop import ControlLoopWarning, Sampled
from .controllers import PD
from .gains import Posture
from .loop_watch import OpenedError
from .validity import ModelLeftError, Validity

if TYPE_CHECKING:
    from .recording import SampleTable

KNOWN = ModelLeftError, OpenedError, SingularError
"""Failures whose own words name the cause, unless a loop of control is behind them."""
MOST = 4
"""How many postures are examined before a run: the start, and set points."""


class Judge:
    """What there is to say about a run that starts at `q0`, `v0`: before it, after it, and where it fails."""

    def __init__(self, sampled: Sampled, q0: np.ndarray, v0: np.ndarray):
        self.sampled, self.q0, self.v0 = sampled, q0, v0
        self.fault = ""

    @contextmanager
    def of(self, table: SampleTable) -> Iterator[None]:
        """Warn of the loop of control before a run, of the model's limits after it, and name the cause of a failure.

        Of a run that is interrupted there is nothing to say, unless what was made of it is kept.
        """
        self.fault = self.sampled.fault(self._ahead())
        if self.fault:
            warnings.warn(self.fault, ControlLoopWarning, stacklevel=4)
        diverged = lost = False
        try:
            yield
        except (KeyboardInterrupt, SystemExit) as stop:
            lost = isinstance(stop, SystemExit) or not stop.args
            raise
        except (DivergedError, SingularError) as error:
            diverged = not isinstance(error, KNOWN)
            cause = self._cause(error, table)
            if cause is error:
                raise
            diverged = True
            raise cause from None
        finally:
            if not (lost or diverged or self.fault):  # then the measures say nothing about the model
                table.watch.validity().warn(table.model, stacklevel=4)

    def _cause(self, error: DivergedError | SingularError, table: SampleTable) -> DivergedError | SingularError:
        """The error, or one that names what is behind it."""
        when = "" if error.at is None else f"t = {error.at:.6g} s: "
        self.fault = self.fault or self.sampled.fault([self._last(table)] if table.count else [], ended=True)
        if self.fault:
            return DivergedError(f"{when}the motion diverged: {self.fault}")
        if isinstance(error, KNOWN):
            return error
        if self.sampled.controlled:
            more = "the torques are held over a step, which a controller of high gain does not bear"
            return DivergedError(f"{error}; {more}")
        numbers = self.sampled.model.numpy(self.sampled.p)
        measures = numbers.validity(self.q0, self.v0, *self.sampled.given(0.0, self.q0, self.v0))
        start = Validity(tuple(self.sampled.model.chain.names), measures)
        return DivergedError(f"{when}the motion diverged; at the start {start.line()}") if start.buckled else error

    def _ahead(self) -> list[Posture]:
        """The start, and the set points of a PD law at rest."""
        out = [Posture(0.0, self.q0, self.v0)]
        model, p, law = self.sampled.model, self.sampled.p, self.sampled.law
        for t, joints in law.set_points[::-1] if type(law) is PD else ():
            q = np.array(model.chain.complete(np.array(joints, float), p), float)
            if len(out) < MOST and not any(np.allclose(q, x.q, atol=1e-3) for x in out):
                out += self._closed(t, q)
        return out

    def _closed(self, t: float, q: np.ndarray) -> list[Posture]:
        """A posture with closed loops; none where they cannot be closed."""
        model = self.sampled.model
        try:
            q = closed(model.numpy(self.sampled.p), q)
        except OpenLoopError:
            return []
        return [Posture(t, q, np.zeros(model.nv))]

    def _last(self, table: SampleTable) -> Posture:
        """The last sample before a link bent far, without its rates, which may be those of the failure."""
        t, bent = table.rows[: table.count, 0], table.watch.first[:, :2]
        limit = np.nanmin(bent) if np.isfinite(bent).any() else np.inf
        row = table.rows[max(0, int(np.searchsorted(t, limit)) - 1)]
        return Posture(float(row[0]), row[table.places["q"]].copy(), np.zeros(table.model.nv))
