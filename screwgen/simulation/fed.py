"""The controller that follows the references of a joint law with the efforts that they take."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import count
from typing import Any

import numpy as np

from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.load import one_line
from .controller_files import read_pd
from .controllers import PD
from .feedforward import Feedforward
from .inputs import started
from .played import Played
from .shaped import Shaped


@dataclass(frozen=True)
class FeedforwardPD(PD):
    """A :class:`PD` law, perhaps that of a plan, whose references come with the efforts that they take.

    The efforts are those of :func:`feedforward` by the model that :meth:`of` is given, at its parameters, until the
    next sample. `step`, s: between samples; a run puts its own in.
    """

    law: PD | None = None
    ahead_of: Feedforward | None = None
    step: float = 1e-3
    efforts_ahead: list[np.ndarray] = field(default_factory=list, compare=False, repr=False)
    """Those of the samples that were asked for."""
    further: Iterator[np.ndarray] = field(default_factory=lambda: iter(()), compare=False, repr=False)

    @classmethod
    def of(cls, law: PD, model: RobotModel) -> FeedforwardPD:
        """The law with the efforts of a model. Raises UsageError where the law already holds the arm's weight.

        Of laws the efforts go with a :class:`PD`, that of a plan, and a shaped one.
        """
        if type(law) not in (PD, Played, Shaped):
            raise UsageError(f"{type(law).__name__}: has more than kp and kd, which would be left out; give a PD law")
        if law.gravity is not None:
            raise UsageError("gravity: the efforts ahead hold the arm too; leave out the law's own compensation")
        return cls(law.kp, law.kd, law.q_des, tau_max=law.tau_max, law=law, ahead_of=Feedforward(model))

    def sampled_every(self, step: float) -> FeedforwardPD:
        """The same for a run of steps of so many seconds."""
        return replace(self, step=step)

    def starting_at(self, q: Any) -> FeedforwardPD:
        """The law at the start of a run; its path begins at the coordinates `q` (nq,)."""
        assert self.law is not None and self.ahead_of is not None
        law = started(self.law, q, step=self.step)
        further = self.ahead_of.along((law.reference(k * self.step) for k in count()), self.step)
        return replace(self, law=law, efforts_ahead=[], further=further)

    @property
    def set_points(self) -> tuple[tuple[float, tuple[float, ...]], ...]:
        assert self.law is not None
        return self.law.set_points

    def reference(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        assert self.law is not None
        return self.law.reference(t)

    def ahead_at(self, t: float) -> np.ndarray:
        """The efforts (n_joints,) from the sample at or before a time until the next."""
        k = max(int(t / self.step + 1e-6), 0)
        while len(self.efforts_ahead) <= k:
            self.efforts_ahead.append(next(self.further))
        return self.efforts_ahead[k]

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The torques, N·m, of slides forces, N, where they act: on the rotors of elastic drives."""
        q_ref, v_ref = self.reference(t)
        lag, late = q_ref - self.measured(q, self.ahead), v_ref - self.measured(v)
        tau = (self.ahead_at(t) + np.array(self.kp) * lag + np.array(self.kd) * late) / self.own_ratios
        most = self.bounds
        return np.append(tau if most is None else np.clip(tau, -most, most), np.zeros(self.idle))


def read_fed(path: str | os.PathLike[str], model: RobotModel) -> FeedforwardPD:
    """The law in the file at `path`, as :func:`.read_pd` reads it, with the efforts ahead; raises UsageError."""
    law = read_pd(path, model)
    try:
        return FeedforwardPD.of(law, model)
    except UsageError as error:
        raise UsageError(f"{one_line(os.fsdecode(path))}: {error}") from None
