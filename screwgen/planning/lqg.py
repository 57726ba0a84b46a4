"""A linear-quadratic law with integral and its filter over a grid of postures and loads, interpolated between."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..arguments import Numbers, array
from .beyond import beyond
from .lqg_design import LqgGains
from .scheduling import Grid


@dataclass(eq=False)
class LqgMemory:
    """What a law remembers from sample to sample."""

    x: np.ndarray
    """(2 n,): coordinates and rates as they are expected at the next sample."""
    z: np.ndarray
    """(n_joints,): integrals of what the joints lack, rad·s, of slides m·s."""


@dataclass(frozen=True, eq=False)
class Lqg:
    """Gains of a law and of its filter at the vertices of a grid; :meth:`sample` is what a clock calls.

    The law needs encoders alone, those of elastic drives on their rotors. Between vertices gains, model and rests are
    multilinear. It is scheduled by the references of the joints and by loads that the caller knows.
    """

    robot: str
    joints: tuple[str, ...]
    step: float
    """s: of the clock."""
    grid: Grid
    tables: LqgGains
    """Each with an axis of the vertices in front."""
    tau_max: np.ndarray
    """(n_joints,): limits of efforts, N·m, of slides N, perhaps infinite."""
    q_des: np.ndarray
    """(n_joints,): the goal where a run states none."""
    lines: tuple[str, ...] = field(default=())
    """What was found about the loop, in words."""

    def at(self, point: np.ndarray) -> LqgGains:
        """The gains at values (k,) of the scheduling variables."""
        places, weights = self.grid.corners(point)
        return LqgGains(*(np.tensordot(weights, x[places], 1) for x in self.tables))

    def start(self, measured: Numbers, loads: Numbers = ()) -> LqgMemory:
        """The memory of a law at an arm that rests at `measured` joints (n_joints,)."""
        q = array(measured, "measured:", (len(self.joints),))
        gains = self.at(self.grid.point(q, self._loads(loads)))
        rest = np.concatenate([q, gains.modes, np.zeros(len(q) + len(gains.modes))])
        return LqgMemory(rest, np.zeros(len(q)))

    def sample(
        self,
        memory: LqgMemory,
        measured: Numbers,
        reference: Numbers,
        rates: Numbers | None = None,
        loads: Numbers = (),
        ahead: Numbers | None = None,
    ) -> np.ndarray:
        """The efforts (n_joints,) to be held until the next sample, within their limits; the memory goes on.

        `measured`, `reference`, `rates` of the reference and efforts `ahead`: (n_joints,); `loads`: factors of the
        grid's loads. Integrals of joints whose effort is at its limit stand still (anti-windup). Raises UsageError
        on numbers that are not finite, and then the memory stays.
        """
        m, h = len(self.joints), self.step
        names = ("measured:", "reference:", "rates:", "ahead:")
        y, q, v, given = (array(x, n, (m,)) for x, n in zip((measured, reference, rates, ahead), names, strict=True))
        g = self.at(self.grid.point(q, self._loads(loads)))
        rest = np.concatenate([q, g.modes, np.zeros(m + len(g.modes))])
        lacks = -(memory.x - rest + g.L @ (y - memory.x[:m]))
        moving = lacks.copy()
        moving[m + len(g.modes) : 2 * m + len(g.modes)] += v
        wanted = g.hold + given + g.K @ moving + g.Kz @ memory.z
        tau, lack = np.clip(wanted, -self.tau_max, self.tau_max), q - y
        lacking, slow = np.split(lacks, 2)
        force = g.S @ (lacking + h / 2 * slow) + g.D @ slow
        force[:m] += tau - g.hold
        gained = np.linalg.solve(g.M, force)
        memory.x = rest - lacks + h * np.concatenate([h / 2 * gained - slow, gained])
        memory.z = memory.z + np.where((wanted - tau) * lack > 0, 0.0, h * lack)
        return tau

    def outside(self, reference: np.ndarray, loads: Numbers = ()) -> str | None:
        """A line where references (n_joints,) or loads are out of the grid; None within."""
        ends = zip(*((x[0], x[-1]) for x in self.grid.values), strict=True)
        return beyond(self.grid.names, self.grid.point(reference, self._loads(loads)), *ends)

    def c(self) -> dict[str, str]:
        """The law as C99, texts by names of files: `<robot>_lqg.h` and `<robot>_lqg.c`, which need no others.

        `<robot>_lqg_sample` gives what :meth:`sample` gives, to rounding. Raises UsageError.
        """
        from .lqg_c import lqg_files

        return lqg_files(self)

    def _loads(self, given: Numbers) -> np.ndarray:
        return array(np.ones(len(self.grid.loads)) if not len(given) else given, "loads:", (len(self.grid.loads),))
