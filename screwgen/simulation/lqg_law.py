"""The controller that plays a linear-quadratic law with its filter: encoders alone, references of a joint law."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..arguments import array
from ..errors import UsageError
from ..planning.lqg import Lqg, LqgMemory
from ..planning.lqg_files import read_lqg
from ..robot_model import RobotModel
from .controllers import PD
from .validity import ModelValidityWarning

SAME = 1e-9
"""Within which the step of a run is that of a law, relative."""


@dataclass(frozen=True)
class LqgLaw(PD):
    """A law with a filter behind the references of a :class:`PD`, whose own gains are zero.

    `loads`: factors of the loads of its grid, 1 if none are given. It measures the joints' coordinates alone, and
    remembers; a run starts it anew. Outside of its grid a :class:`ModelValidityWarning` says so, once a run.
    """

    lqg: Lqg | None = None
    loads: tuple[float, ...] = ()
    memory: list[Any] = field(default_factory=list, init=False, repr=False, compare=False)

    @classmethod
    def of(cls, lqg: Lqg, q_des: Any = None, **reference: Any) -> LqgLaw:
        """Of tables, to a goal (n_joints,), the tables' own by default; `reference`: what else a :class:`PD` takes."""
        if unknown := sorted(set(reference) - {"duration", "waypoints", "loads"}):
            raise UsageError(
                f"law: there is no '{unknown[0]}' of a law with a filter; it takes duration, waypoints, loads"
            )
        m = len(lqg.joints)
        goal = tuple((lqg.q_des if q_des is None else array(q_des, "q_des:", (m,))).tolist())
        limits = tuple(lqg.tau_max.tolist()) if np.isfinite(lqg.tau_max).all() else None
        return cls((0.0,) * m, (0.0,) * m, goal, tau_max=limits, lqg=lqg, **reference)

    @property
    def proportional(self) -> bool:
        """Never: its gains are zero."""
        return False

    @property
    def tables(self) -> Lqg:
        """The tables of the law."""
        assert self.lqg is not None
        return self.lqg

    def sampled_every(self, step: float) -> LqgLaw:
        """The same for a run of steps of so many seconds; raises UsageError where they are not the law's."""
        if abs(step - self.tables.step) > SAME * step:
            raise UsageError(f"the step is {step:g} s; the law was made for {self.tables.step:g} s, so take that")
        return self

    def starting_at(self, q: Any) -> LqgLaw:
        """The same law for a run that starts at `q` (nq,), with an empty memory."""
        law = PD.starting_at(self, q)
        assert isinstance(law, LqgLaw)
        return law

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The efforts, N·m, of slides forces, N, where they act: on the rotors of elastic drives.

        Those of a time that was asked for are kept.
        """
        measured, (reference, rates) = self.measured(q, self.ahead), self.reference(t)
        if not self.memory:
            self.memory[:] = [-np.inf, None, self.tables.start(measured, self.loads), False]
        if t > self.memory[0]:
            memory: LqgMemory = self.memory[2]
            if not self.memory[3] and (line := self.tables.outside(reference, self.loads)):
                self.memory[3] = True
                warnings.warn(line, ModelValidityWarning, stacklevel=2)
            self.memory[:2] = t, self.tables.sample(memory, measured, reference, rates, self.loads)
        return np.append(self.memory[1] / self.own_ratios, np.zeros(self.idle))


def read_lqg_law(path: str | os.PathLike[str], model: RobotModel) -> LqgLaw:
    """The law of the tables in the file at `path`, .npz, to their own goal; raises UsageError."""
    tables = read_lqg(path)
    if tables.joints != (own := tuple(model.q_names[: model.n_joints])):
        said = f"is a law for {', '.join(tables.joints)}; the robot has {', '.join(own) or 'no joints'}"
        raise UsageError(f"{os.fsdecode(path)}: {said}; find gains for this robot")
    return LqgLaw.of(tables)
