"""The result of `excite`: a motion, its run, and how well a log of it will tell what is sought."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import BinaryIO

import numpy as np

from ..planning.plan import MotionPlan
from ..planning.plan_files import write_npz
from ..simulation.runs import Run, suffix
from ..spec.columns import Columns
from .unknowns import Unknowns

FORMATS = (".csv", ".npz")
WIDE = 1.96
"""Half an interval that holds a normal number in 95 of 100 cases, over its deviation."""


@dataclass(frozen=True, eq=False, repr=False)
class Excitation:
    """A motion that excites what is sought, beside a random one of equal limits and time."""

    plan: MotionPlan
    """References of the joints and torques, to be played under the joint law."""
    run: Run
    """The run of the plan on the model."""
    random: MotionPlan
    """The random motion: of those that were looked at the one in the middle."""
    unknowns: Unknowns
    """What is sought."""
    deviation: np.ndarray
    """(k,): the standard deviations that a fit is to have, of logarithms or over scales, infinite where the log does
    not determine a number."""
    deviation_of_random: np.ndarray
    """(k,): those with the random motion."""
    undetermined: tuple[str, ...]
    """Of each direction that the motion does not tell a sentence."""
    notes: tuple[str, ...]
    columns: Columns
    """The columns of a log for which the motion was made, with the noise of sensors."""

    def __repr__(self) -> str:
        return f"<Excitation of {len(self.unknowns)} numbers: {self.plan!r}>"

    @property
    def narrower(self) -> float:
        """How many times narrower the widest interval is than that of the random motion.

        NaN where this motion leaves a number undetermined, infinite where the random motion alone does.
        """
        widest = float(self.deviation.max())
        return float(self.deviation_of_random.max()) / widest if widest < np.inf else np.nan

    def summary(self) -> str:
        """The intervals that are to be expected, as text, a line each."""
        lines = []
        for one, own, other in zip(self.unknowns, self.deviation, self.deviation_of_random, strict=True):
            size, unit = (100.0, "%") if one.logarithmic else (one.scale, one.unit)
            half = [
                f"± {WIDE * x * size:.2g} {unit}".rstrip() if x < np.inf else "not determined" for x in (own, other)
            ]
            lines.append(f"{one.name}: {half[0]}, by a random motion {half[1]}")
        if np.isfinite(self.narrower):
            last = f"the widest interval is {self.narrower:.1f} times narrower than by a random motion"
        else:
            own, other = (int(np.isinf(x).sum()) for x in (self.deviation, self.deviation_of_random))
            last = f"of {len(lines)} numbers {own} are not determined, by a random motion {other}"
        return "\n".join([*lines, last])

    def write(self, stream: BinaryIO, path: str | os.PathLike[str]) -> None:
        """The motion as a file of the format that a path says: .npz has the plan, .csv the inputs of its run."""
        if suffix(path) == ".npz":
            write_npz(self.plan, stream)
            return
        stream.write((",".join(["t", *self.run.names_of("tau")]) + "\n").encode())
        for row in np.column_stack([self.run.t, self.run.tau]).tolist():
            stream.write((",".join(f"{x:.17g}" for x in row) + "\n").encode())
