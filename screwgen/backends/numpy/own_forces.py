"""The coordinates with inertia, spring and damper of their own: modes, and joints and rotors where any is sprung."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from ...algorithms.axis_laws import LawsOfRobot, of_robot
from ...algorithms.law_programs import replayed, secants, spring_stage, stage_slopes, state_rate, stuck
from ...elements.law import Secant
from ...topology.chain import Chain


class LinearisedLaw(NamedTuple):
    """A law on its coordinates, with its constants by name; over a step the linear force of ``held``."""

    law: LawsOfRobot
    constants: Mapping[str, np.ndarray]
    held: Secant | None = None

    internal: np.ndarray | None = None
    """Its internal states, one for each coordinate."""
    at: Mapping[str, np.ndarray] | None = None
    """The inputs of its programs of which ``held`` is."""

    def stage(self, x: np.ndarray, rate: np.ndarray, there: np.ndarray, h: float) -> dict[str, np.ndarray]:
        """The inputs of its programs."""
        at = self.law.coordinates
        state = {"side": np.array(self.law.sides, float), "x": x[at], "w": rate[at], "there": there[at]}
        state |= {} if self.internal is None else {"z": self.internal}
        state |= {"axis": x[self.law.axes]} if self.law.axes else {}
        return state | {"h": np.full(len(at), h)} | dict(self.constants)


@dataclass
class CoordinateForces:
    """Inertia, stiffness and damping of these coordinates, the last ``n_given`` of ``q``.

    ``M``, ``K``, ``D`` (n_inertia, ...): the diagonal, then the entries below it where modes or rotors are coupled;
    ``laws``: what else acts, as linear forces once :meth:`linearised_over` has set them.
    """

    chain: Chain
    M: np.ndarray
    K: np.ndarray
    D: np.ndarray
    laws: Sequence[LinearisedLaw] = ()

    @classmethod
    def of_columns(cls, chain: Chain, columns: Sequence[np.ndarray]) -> CoordinateForces:
        """Out of the robot's columns, in the order of :func:`...algorithms.columns.columns`."""
        M, K, D, *rest = columns
        own, laws = iter(rest), of_robot(chain)
        return cls(
            chain, M, K, D, [LinearisedLaw(one, {name: next(own) for name in one.law.constants}) for one in laws]
        )

    def of(self, q: np.ndarray) -> np.ndarray:
        """The part of ``q`` (nq, ...) that belongs to these coordinates."""
        return q[self.chain.given_places] if self.chain.curved else q[len(q) - self.chain.n_given :]

    def of_rates(self, v: np.ndarray) -> np.ndarray:
        """The part of ``v`` (nv, ...) or (nvz, ...) that belongs to their rates."""
        return v[self.chain.nv - self.chain.n_given : self.chain.nv]

    def over(self, q: np.ndarray, v: np.ndarray, h: float = 0.0, there: np.ndarray | None = None) -> CoordinateForces:
        """The same with the laws as linear forces ``h`` after the state ``q`` (nq,), ``v`` (nvz,).

        ``there`` (nvz,): the rates at the stage, those of ``v`` by default.
        """
        later, known = v if there is None else there, self.remembering(v[self.chain.nv :])
        return known.linearised_over(self.of(q), self.of_rates(v), h, self.of_rates(later))

    def remembering(self, internal: np.ndarray) -> CoordinateForces:
        """The same with internal states (n_internal,)."""
        chain, places = self.chain, self.chain.internal
        own = lambda law: internal[np.array(places[law]) - chain.nv] if law in places else None  # noqa: E731
        return replace(self, laws=[one._replace(internal=own(one.law.law)) for one in self.laws])

    def linearised_over(
        self, x: np.ndarray, rate: np.ndarray, h: float = 0.0, there: np.ndarray | None = None
    ) -> CoordinateForces:
        """The same with the laws as linear forces ``h`` after the coordinates ``x`` with ``rate``.

        ``x``, ``rate`` (n_given,); ``there``: the rates at the stage, those of ``rate`` by default.
        """
        there = rate if there is None else there
        given = [one.stage(x, rate, there, h) for one in self.laws]
        pairs = zip(self.laws, given, strict=True)
        laws = [one._replace(held=Secant(**replayed(secants(one.law.law), own)), at=own) for one, own in pairs]
        return replace(self, laws=laws)

    def internal_rates(self, vdot: np.ndarray) -> np.ndarray:
        """(n_internal,): the rates of internal states over the time of :meth:`over`, at accelerations (nv,)."""
        a, out = self.of_rates(vdot), np.zeros(self.chain.n_internal)
        for one in self.laws:
            if one.at is not None and (own := self.chain.internal.get(one.law.law)):
                found = replayed(state_rate(one.law.law), {**one.at, "a": a[one.law.coordinates]})
                out[np.array(own) - self.chain.nv] = found["rate"]
        return out

    @property
    def stuck(self) -> CoordinateForces:
        """The same with internal states that follow their coordinates without decay: bristles as springs that stick."""
        out = []
        for one in self.laws:
            if one.at is not None and one.law.law.state is not None:
                x, w = (one.at[name] for name in "xw")
                found = replayed(stuck(one.law.law), one.at)
                out.append(
                    one._replace(
                        held=Secant(found["stiffness"], found["damping"], x, found["force"] - found["damping"] * w)
                    )
                )
            else:
                out.append(one)
        return replace(self, laws=out)

    @property
    def slopes(self) -> CoordinateForces:
        """The same for small changes of coordinates and rates: laws are then at rest at zero."""
        at_zero = [
            one._replace(held=one.held._replace(rest=0.0, constant=0.0)) if one.held else one for one in self.laws
        ]
        return replace(self, laws=at_zero)

    def softened(
        self, x: np.ndarray, rate: np.ndarray, felt: np.ndarray, change: np.ndarray, moved: np.ndarray
    ) -> np.ndarray:
        """(n_given, ...): what the secants of friction add to its force by a ``change`` of the rates.

        ``felt`` (n_given,): the rates that the secants multiply; ``moved``: the change of the coordinates, by which
        friction changes that grows with the load of a gear.
        """
        out, shape = np.zeros_like(change), (-1, *(1,) * (change.ndim - 1))
        for one in self.laws:
            if not one.law.law.positional and one.law.law.state is None:
                at, given = one.law.coordinates, one.stage(x, felt, rate, 0.0) | {"a": 0.0}
                slopes = {n: np.reshape(x, shape) for n, x in replayed(stage_slopes(one.law.law), given).items()}
                np.add.at(out, at, slopes["by_there"] * change[at])
                if one.law.axes:
                    np.add.at(out, at, slopes["by_x"] * moved[at] + slopes["by_axis"] * moved[one.law.axes])
        return out

    def inertia(self, h: float) -> np.ndarray:
        """(n_inertia,): the inertia with the forces implicit over ``h`` seconds, ``M + h (D + h K)``."""
        return self.M + self.added(h)

    def added(self, h: float) -> np.ndarray:
        """(n_inertia,): what the forces add to the inertia."""
        out = replayed(spring_stage(), {"x": 0.0, "w": 0.0, "h": h, "K": self.K, "D": self.D})["inertia"]
        for one in self.laws:
            if one.held is not None:
                np.add.at(out, one.law.coordinates, h * (one.held.damping + h * one.held.stiffness))
        return out

    def force_of(self, q: np.ndarray, v: np.ndarray, h: float) -> np.ndarray:
        """(n_given,): the force of :meth:`force` after the state ``q``, ``v``."""
        return self.force(self.of(q), self.of_rates(v), h)

    def force(self, x: np.ndarray, rate: np.ndarray, h: float) -> np.ndarray:
        """(n_given, ...): the force ``h`` after ``x``, ``rate`` (n_given, ...) without the accelerations' part."""
        column = lambda A: np.reshape(A, (-1, *(1,) * (x.ndim - 1)))  # noqa: E731
        rows, felt, entries = self.chain.springs
        given = {"x": x[felt], "w": rate[felt], "h": h, "K": column(self.K)[entries], "D": column(self.D)[entries]}
        out = np.zeros(np.broadcast_shapes(np.shape(x), np.shape(rate)))
        np.add.at(out, rows, replayed(spring_stage(), given)["force"])
        for one in self.laws:
            if one.held is not None:
                k, (stiffness, damping, rest, constant) = one.law.coordinates, map(column, one.held)
                np.add.at(out, k, stiffness * (x[k] - rest + h * rate[k]) + damping * rate[k] + constant)
        return out
