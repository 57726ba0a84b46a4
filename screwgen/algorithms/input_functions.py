"""What inputs do: how their entries reach links and base, what forces they exert, what power they give."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import copy
from typing import Self

from ..errors import UsageError
from ..ir.program import Value
from ..spec.base import BASE_MOTION
from ..spec.brake import BRAKES
from ..spec.forces import FORCE_INPUTS
from ..spec.input import Input
from ..spec.inputs import TORQUES
from ..spec.tendons import TENSIONS
from ..topology.chain import Chain
from . import matrices as mx
from . import tendons
from .axis_terms import drive_power
from .loops import Loads
from .schedule import OUTWARD, Algorithm, Phase

POWER: Algorithm = (Phase(drive_power, OUTWARD), Phase(tendons.power, OUTWARD))
LENGTHS: Algorithm = (Phase(tendons.lengths, OUTWARD),)
PULLS: Algorithm = (Phase(tendons.write_pulls, OUTWARD),)

Rows = list[list[Value]]


class InputFunctions:
    """What :class:`.functions.Functions` has besides for inputs; the attributes are set there."""

    closed: Sequence = ()
    """How far brakes are closed where torques are given alone."""

    chain: Chain
    world: Sequence
    given: tuple[Sequence, Sequence] | None
    under_inputs: Callable[[Sequence], Self]
    input_powers: Callable[[Sequence, Sequence], list]
    wrenches_per_input: Callable[[Sequence, Sequence], Iterator[list]]
    wrenches_per_state: Callable[[Sequence, Sequence], Iterator[list]]
    alone: Callable[[], Self]
    without_forces: Callable[[], Self]
    with_loops: Callable[..., Loads]
    coupling_torques: Callable[..., list]
    levers: Callable[[Sequence], list]
    forward: Callable[..., tuple[list, list]]
    loads: Callable[..., tuple[list, list]]
    with_forces: Callable[..., Sequence]
    energy: Callable[..., tuple[Value, Value]]
    _run: Callable[..., tuple[list, list]]
    motion: Callable[..., list[dict[str, list]]]

    def entries(self, tau: Sequence) -> Iterator[tuple[Input, list]]:
        """The kinds of input, each with its entries; of torques alone the others are zero.

        Raises UsageError for another number of them.
        """
        allowed = sorted({self.chain.n_joints, self.chain.n_tau})
        if len(tau) not in allowed:
            raise UsageError(f"tau has {len(tau)} numbers; it must have {' or '.join(map(str, allowed))}")
        every = [*tau, *[0.0] * (self.chain.n_tau - len(tau))]
        if self.closed and len(tau) < len(every):
            every[self.chain.inputs[BRAKES]] = self.closed
        return ((row, every[own]) for row, own in self.chain.inputs.items())

    def braked(self, tau: Sequence) -> Self:
        """The same functions with the brakes closed as they are among ``tau``, also where torques are given alone."""
        if not (self.chain.braked and len(tau) == self.chain.n_tau):
            return self
        out = copy(self)
        out.closed = list(tau[self.chain.inputs[BRAKES]])
        return out

    def of_links(self, tau: Sequence) -> list[dict[str, list]]:
        """The entries that each link reads, by the signals that hold them."""
        out: list[dict[str, list]] = [{} for _ in range(self.chain.n)]
        for row, values in self.entries(tau):
            for link, own in zip(out, row.of_links(self.chain), strict=True):
                link |= {row.signal: [values[k] for k in own]} if own or row is TORQUES else {}
        return out

    def falling(self, tau: Sequence) -> Self:
        """The same functions with the free fall, and with the inputs of forces, that are among ``tau``."""
        out = self.under_inputs(tau)
        for row, values in self.entries(tau):
            if row.free_fall is not None:
                out = copy(out)
                fall = [g + x for g, x in zip(out.world[:3], row.free_fall(values), strict=True)]
                out.world = [*fall, *out.world[3:]]
        return out

    def drive_power(self, q: Sequence, v: Sequence, tau: Sequence) -> list:
        """The power that each entry of ``tau`` gives to the arm; of brakes, and of a base whose motion is
        given, by their efforts in its place."""
        links = self._run(POWER, self.motion(q, v), self.of_links(tau))[0]
        told: dict[Input, list] = {TORQUES: [x for link in links for x in link["power"]]}
        told[TENSIONS] = self._of_tendons(links, "tendon_power")
        for row, values in self.entries(tau):
            if row is FORCE_INPUTS:
                told[row] = self.under_inputs(tau).input_powers(q, v)
            elif row is BRAKES:
                told[row] = [x * v[self.chain.held_places[k]] for x, k in zip(values, self.chain.braked, strict=True)]
            elif row is BASE_MOTION:
                told[row] = [x * rate for x, rate in zip(values, v, strict=False)]
            elif row not in told:
                forces = self._exerted(row, q, v)
                told[row] = [x * mx.dot(force, v[: self.chain.nv]) for x, force in zip(values, forces, strict=True)]
        return [x for row in self.chain.inputs for x in told[row]]

    def drive_efforts(self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> list:
        """The entries of ``tau`` with, in place of accelerations that are given and of brakes, the efforts of these."""
        given = self.with_loops(q, v, tau, w_ext)
        links, _ = self.forward(q, v, *given)
        vdot = self.chain.join(links, "qddot", "etaddot")
        force = self.falling(tau).without_forces().loads(q, v, vdot, given.w_ext)[0]
        coupled = self.coupling_torques(q, v, tau, w_ext) if self.chain.closing.couplings else [0.0] * len(tau)
        out, levers = list(tau), self.levers(q) if self.chain.braked else ()
        out[self.chain.inputs.get(BASE_MOTION, slice(0, 0))] = force[: 6 * self.chain.moving]
        for k in self.chain.prescribed:  # of a coupling's torque the drive is relieved
            out[k] = force[self.chain.held_places[k]] - coupled[k]
        first = self.chain.inputs[BRAKES].start if self.chain.braked else 0
        for place, k in enumerate(self.chain.braked, first):  # and a brake of what the drive exerts
            out[place] = force[self.chain.held_places[k]] - coupled[k] - levers[k] * tau[k]
        return out

    def effort_power(self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> list:
        """The power that each drive gives to the arm where the motion of some is given."""
        return self.drive_power(q, v, self.drive_efforts(q, v, tau, w_ext))

    def exerted(self, q: Sequence, v: Sequence, tau: Sequence) -> Rows:
        """The generalised forces (nv,) per unit of each input, those of torques left out.

        Of forces between frames they are the slopes at the inputs ``tau``; others are linear in theirs.
        """
        f = self.under_inputs(tau)
        return [force for row in self.chain.other_inputs for force in f._exerted(row, q, v)]

    def by_inputs(self, q: Sequence, v: Sequence, tau: Sequence) -> list:
        """The generalised forces (nv,) of all inputs, those of torques left out."""
        out: list[Value] = [0.0] * self.chain.nv
        for row, values in self.entries(tau):
            if row is FORCE_INPUTS:
                out = [a + b for a, b in zip(out, self._by_forces(q, v, tau), strict=True)]
            elif row not in (TORQUES, BRAKES, BASE_MOTION):
                for x, force in zip(values, self._exerted(row, q, v), strict=True):
                    out = [a + x * b for a, b in zip(out, force, strict=True)]
        return out

    def _by_forces(self, q: Sequence, v: Sequence, tau: Sequence) -> list:
        """What forces between frames exert under their inputs, less what they exert without."""
        still, rest, none = self._still(), [0.0] * self.chain.nv, [0.0] * (6 * self.chain.n)
        acted = (f.with_forces(q, v, none) for f in (self, self.under_inputs(tau)))
        idle, under = (still.loads(q, rest, rest, w)[0] for w in acted)
        return [a - b for a, b in zip(idle, under, strict=True)]

    def _exerted(self, row: Input, q: Sequence, v: Sequence) -> Rows:
        if row is FORCE_INPUTS:
            return [[-x for x in found[0]] for found in self._needed(q, self.wrenches_per_input(q, v))]
        if row in (BRAKES, BASE_MOTION):  # they exert what the motion takes, which is not linear in them
            return [[0.0] * self.chain.nv for _ in self._units(row)]
        if row is TENSIONS:
            joints = [0.0] * self.chain.eta_v
            return [[*joints, *(-x for x in pull)] for pull in self.pulls(q)]
        return [[-x for x in self._fallen(row, q, unit)[0]] for unit in self._units(row)]

    def exerted_by_states(self, q: Sequence, v: Sequence) -> Rows:
        """The derivatives (nv,) of the generalised forces that are needed with each internal state of forces."""
        return [found for found, _ in self._needed(q, self.wrenches_per_state(q, v))]

    def _needed(self, q: Sequence, units: Iterator[list]) -> Iterator[tuple[list, list]]:
        """The loads at rest that each of some wrenches on all tips (6 n,) needs, as `_fallen`."""
        still, rest = self._still(), [0.0] * self.chain.nv
        none = still.loads(q, rest, rest, [0.0] * (6 * self.chain.n))
        for wrenches in units:
            pairs = zip(none, still.loads(q, rest, rest, wrenches), strict=True)
            force, wrench = ([b - a for a, b in zip(*pair, strict=True)] for pair in pairs)
            yield force, wrench

    def wrenches_of_inputs(self, q: Sequence, v: Sequence, tau: Sequence) -> Rows:
        """The joint wrenches (6 n,) that a unit of each input adds while nothing moves, those of torques left out."""
        n, borne = self.chain.n, self._unborne
        out: Rows = []
        for row in self.chain.other_inputs:
            if row is FORCE_INPUTS:
                out += self.felt(q, self.under_inputs(tau).wrenches_per_input(q, v))
                continue
            for unit in self._units(row):
                wrench: list[Value] = [0.0] * (6 * n)
                wrench[borne:] = wrench[borne:] if row.free_fall is None else self._fallen(row, q, unit)[1][borne:]
                out.append(wrench)
        return out

    def wrenches_of_states(self, q: Sequence, v: Sequence, tau: Sequence) -> Rows:
        """The joint wrenches (6 n,) that a unit of each internal state of a force adds."""
        return self.felt(q, self.under_inputs(tau).wrenches_per_state(q, v))

    def felt(self, q: Sequence, units: Iterator[list]) -> Rows:
        """The joint wrenches (6 n,) that each of some wrenches on all tips (6 n,) adds while nothing moves."""
        borne = self._unborne
        return [[0.0] * borne + wrench[borne:] for _, wrench in self._needed(q, units)]

    @property
    def _unborne(self) -> int:
        """How many of the first entries of joint wrenches are those of a base that floats, which nothing bears."""
        return 6 * (self.chain.floating and not self.chain.moving)

    def _units(self, row: Input) -> Rows:
        count = len(row.names(self.chain.robot))
        return [[float(i == k) for i in range(count)] for k in range(count)]

    def _fallen(self, row: Input, q: Sequence, entries: Sequence) -> tuple[list, list]:
        """The loads at rest that a change of free fall needs: what they are under it less what they are without."""
        assert row.free_fall is not None
        still, rest = self._still(), [0.0] * self.chain.nv
        under = copy(still)
        under.world = row.free_fall(entries)
        pairs = zip(*(f.loads(q, rest, rest, [0.0] * (6 * self.chain.n)) for f in (still, under)), strict=True)
        force, wrench = ([b - a for a, b in zip(*pair, strict=True)] for pair in pairs)
        return force, wrench

    def _still(self) -> Self:
        """The functions of the robot alone, without springs."""
        still = self.alone()
        still.given = [0.0] * self.chain.n_inertia, [0.0] * self.chain.n_given
        return still

    def tendon_lengths(self, q: Sequence) -> list:
        """The lengths of all tendons."""
        links = self._run(LENGTHS, self.chain.split(q, "q", "eta"))[0]
        return self._of_tendons(links, "tendon_length")

    def pulls(self, q: Sequence) -> Rows:
        """The derivative of the length of each tendon with all modes (n_modes,)."""
        chain = self.chain
        out: Rows = [[0.0] * chain.n_modes for _ in range(chain.n_tensions)]
        for i, link in enumerate(self._run(PULLS, chain.split(q, "q", "eta"))[0]):
            for piece, tendon in enumerate(chain.tensions[i]):
                for m in range(chain.keys[i].modes):
                    place = chain.eta_offset[i] + m
                    out[tendon][place] = out[tendon][place] + link["pull"][piece * chain.keys[i].modes + m]
        return out

    def _of_tendons(self, links: Sequence[Mapping[str, list]], name: str) -> list:
        """The sums over the pieces of each tendon."""
        out: list[Value] = [0.0] * self.chain.n_tensions
        for link, own in zip(links, self.chain.tensions, strict=True):
            for tendon, value in zip(own, link[name], strict=True):
                out[tendon] = out[tendon] + value
        return out
