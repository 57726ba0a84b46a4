"""The rows of coordinates that brakes act on, as derivatives of the dynamics need them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from ..spec.brake import BRAKES
from ..topology.chain import Chain
from .brakes import BALANCE, ROWS, braked_rows
from .schedule import OUTWARD, Algorithm, Phase

BRAKED: Algorithm = (Phase(braked_rows, OUTWARD),)


class BrakedRows(NamedTuple):
    """The rows ``share (M vdot + h - tau) + inertia (vdot - stop) = 0`` of coordinates that brakes act on, and their
    derivatives by the own rate and by the own input, at held motion and efforts."""

    share: list
    inertia: list
    by_rate: list
    by_input: list


class BrakeFunctions:
    """What :class:`.functions.Functions` has besides for brakes; the attributes are set there."""

    chain: Chain
    _state: Callable[..., list[dict[str, list]]]
    drive_efforts: Callable[..., list]
    _run: Callable[..., tuple[list, list]]

    def braked_rows(self, q: Sequence, v: Sequence, vdot: Sequence, tau: Sequence, w_ext: Sequence) -> BrakedRows:
        """Those of all brakes; at the accelerations ``vdot`` that the rest makes."""
        efforts = self.drive_efforts(q, v, tau, w_ext)[self.chain.inputs[BRAKES]]
        links = self._braked(q, v, vdot, tau, efforts)
        return BrakedRows(*([x for link in links for x in link[name]] for name in ROWS))

    def braked_balance(self, q: Sequence, v: Sequence, vdot: Sequence, tau: Sequence, efforts: Sequence) -> list:
        """The sums of their rows, which vanish where the brakes have the ``efforts`` that belong to ``vdot``."""
        return [x for link in self._braked(q, v, vdot, tau, efforts) for x in link[BALANCE]]

    def _braked(self, q: Sequence, v: Sequence, vdot: Sequence, tau: Sequence, efforts: Sequence) -> list:
        chain = self.chain
        closed = tau[chain.inputs[BRAKES]]
        told = [
            {"brake": [closed[k] for k in of], "brake_effort": [efforts[k] for k in of]}
            for of in BRAKES.of_links(chain)
        ]
        moving = chain.split(vdot[: chain.nv], "qddot", "etaddot")
        return self._run(BRAKED, self._state(q, v), moving, told)[0]
