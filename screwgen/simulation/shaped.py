"""The controller that plays a joint law about a shaped reference."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass, field, fields
from pathlib import Path

import numpy as np

from ..errors import UsageError
from ..planning.scheduled_shaper import ScheduledShaper
from ..planning.shaper_files import read_shaper
from ..robot_model import RobotModel
from ..spec.load import one_line
from .controller_files import read_pd
from .controllers import PD
from .validity import ModelValidityWarning


@dataclass(frozen=True)
class Shaped(PD):
    """A :class:`PD` law whose reference is shaped: sums of its reference at earlier times, by impulses that follow it.

    Outside of the shaper's bounds a :class:`ModelValidityWarning` says so, once a run.
    `payload`: the value of the shaper's last variable where that is no joint.
    """

    shaper: ScheduledShaper | None = None
    payload: float | None = None
    said: list[str] = field(default_factory=list, init=False, repr=False, compare=False)

    @classmethod
    def of(cls, law: PD, shaper: ScheduledShaper, payload: float | None = None) -> Shaped:
        """A :class:`PD` law with its references shaped; raises UsageError for others, and a shaper of other joints."""
        if type(law) is not PD:
            raise UsageError(f"{type(law).__name__}: has more than kp and kd, which would be left out; give a PD law")
        if len(shaper.joints) != len(law.q_des):
            raise UsageError(f"shaper: is for {len(shaper.joints)} joints, the law for {len(law.q_des)}")
        if payload is None and set(shaper.variables) - set(shaper.joints):
            raise UsageError(f"shaper: follows {shaper.variables[-1]}; give the payload")
        return cls(**{x.name: getattr(law, x.name) for x in fields(PD)}, shaper=shaper, payload=payload)

    def place(self, q: np.ndarray) -> np.ndarray:
        """The shaper's variables (V,) at joints (n_joints,)."""
        assert self.shaper is not None
        own = dict(zip(self.shaper.joints, q, strict=True))
        return np.array([own.get(name, self.payload) for name in self.shaper.variables], float)

    def reference(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        """Shaped coordinates and rates, impulses by where the unshaped reference is.

        Rates are sums of earlier rates: how the delays themselves change is left out.
        """
        assert self.shaper is not None
        place = self.place(super().reference(t)[0])
        if not self.said and (line := self.shaper.outside(place)):
            self.said.append(line)
            warnings.warn(line, ModelValidityWarning, stacklevel=2)
        impulses = self.shaper.at(place)
        earlier = [super(Shaped, self).reference(t - s) for s in impulses.times]
        q, v = (np.tensordot(impulses.amplitudes, [x[k] for x in earlier], 1) for k in (0, 1))
        return q, v


def read_shaped(path: str | os.PathLike[str], model: RobotModel) -> Shaped:
    """The law that the shaper in the file at `path` belongs to, shaped; raises UsageError."""
    file, shaper = one_line(os.fsdecode(path)), read_shaper(path)
    if shaper.law is None:
        raise UsageError(f"{file}: law: names no file of a joint law; shape the robot with --gains")
    if shaper.joints != tuple(model.q_names[: model.n_joints]):
        raise UsageError(f"{file}: is a shaper for {', '.join(shaper.joints)}; shape this robot")
    own = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    payload = own.get(shaper.variables[-1]) if shaper.variables else None
    return Shaped.of(read_pd(Path(os.fsdecode(path)).parent / shaper.law, model), shaper, payload)
