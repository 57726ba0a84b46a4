"""What acts on the tips of a robot's segments beside the wrenches that a caller states in their frames.

These are forces between frames, such as springs along lines, and wrenches that are stated in the axes of the world. The
tree knows neither: here they become wrenches on tips, before any algorithm runs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from copy import copy
from types import MappingProxyType
from typing import Any, Self

import numpy as np

from ..interactions import InteractionClass
from ..ir.program import Array, Value
from ..spec.forces import FORCE_INPUTS
from ..spec.input import Input
from ..topology.chain import Chain
from ..topology.forces import PlacedForce
from . import force_programs as programs
from . import matrices as mx
from . import motions as mo
from .loop_slopes import TipChange
from .loops import Tip
from .schedule import OUTWARD, Algorithm, Apply, Phase

POSES = Phase(mo.poses, OUTWARD)
MOTION: Algorithm = (Phase(mo.velocities, OUTWARD), POSES, Phase(mo.tip_twist, OUTWARD))


class ForceFunctions:
    """What :class:`.functions.Functions` has besides for what acts on tips; the attributes are set there.

    ``world`` has gravity, three entries, and behind it the numbers of all forces: ``PlacedForce.numbers`` says which
    of these are a force's own, ``PlacedForce.point`` which are the coordinates of its end in the world.
    """

    chain: Chain
    world: Sequence
    acts: bool
    chosen: Sequence = ()
    """The inputs of all forces, in their order; zero where none are given."""
    acting: Sequence = ()
    """The inputs, where held laws remember them."""
    apply: Apply
    section: Callable[[str], AbstractContextManager]
    entries: Callable[[Sequence], Iterator[tuple[Input, list]]]
    _run: Callable[..., tuple[list, list]]
    motion: Callable[..., list[dict[str, list]]]
    memory_rates: Callable[..., list]

    def alone(self) -> Self:
        """The functions of the same robot without weight, and without what acts on its tips."""
        out = self.without_forces()
        out.world = [0.0] * 3
        return out

    def without_forces(self) -> Self:
        """The functions of the same robot whose tips bear nothing but the wrenches that are given in their frames."""
        out = copy(self)
        out.acts = False
        return out

    def under_inputs(self, tau: Sequence) -> Self:
        """The same functions with the inputs of forces that are among ``tau``, and with what held laws see of them."""
        remembers = self.chain.n_held_states
        if not ((self.chain.chooses_forces or remembers) and len(tau)):
            return self
        out = copy(self)
        out.chosen = next((own for row, own in self.entries(tau) if row is FORCE_INPUTS), ())
        out.acting = tau if remembers else ()
        return out

    def with_forces(self, q: Sequence, v: Sequence, w_ext: Sequence) -> Sequence:
        """The wrenches on all tips (6 n,) in their frames, those of forces between frames included.

        Rows of `chain.turned_wrenches` are given in axes of the inertial frame. The result is for `Functions` without
        forces, which would add them again.
        """
        if not self.acts:
            return w_ext
        tips, states = self._tips(q, v), self.remembered(v)
        total = [mx.array(list(w_ext[6 * i : 6 * i + 6])) for i in range(self.chain.n)]
        for i in self.chain.turned_wrenches:
            with self.section(f"{self.chain.names[i]}: the wrench from outside in axes of its section"):
                total[i] = mx.rotate_wrench(tips[i].R.T, total[i])
        for force in self.chain.forces:
            with self.section(f"{force.name}: its wrenches on the frames that it joins"):
                found = self._applied(force, tips, programs.wrenches(force.shape), states)
                for end, name in zip(force.ends, ("first", "second"), strict=True):
                    if end is not None:
                        total[end] = total[end] + mx.name(f"w_{force.name}_{name}", mx.array(found[name]))
        with self.section("wrenches on all tips"):
            named = (mx.name(f"w_{i}", w) for i, w in zip(self.chain.identifiers, total, strict=True))
            return [x for wrench in named for x in wrench]

    def remembered(self, v: Sequence) -> list[Value]:
        """The internal states of all forces, then of held laws; zero where ``v`` has rates alone."""
        own = self.chain.force_states
        return list(v[own]) if len(v) == self.chain.nvz else [0.0] * self.chain.n_force_states

    def force_rates(self, q: Sequence, v: Sequence, start: Sequence, h: Value) -> list[Value]:
        """The rates of these states, the means over ``h`` from the states ``start``; see :class:`StateRate`."""
        remembering, states, out = [x for x in self.chain.forces if x.shape.states], self.remembered(v), []
        tips = self._tips(q, v) if remembering else ()
        for force in remembering:
            over = {"start": list(start[force.states]), "h": [h]}
            out += self._applied(force, tips, programs.state_rates(force.shape), states, over=over)["rate"]
        return out + self.memory_rates(q, v, start[len(out) :], h)

    def energy_of_forces(self, q: Sequence, v: Sequence) -> Value:
        """The potential of the forces between frames, J."""
        if not (self.acts and self.chain.forces):
            return 0.0
        tips, states, total = self._tips(q, [0.0] * self.chain.nv), self.remembered(v), 0.0
        for force in self.chain.forces:
            found = self._applied(force, tips, programs.energy(force.shape), states, twists=False)
            total = total + found["energy"][0]
        return total

    def force_quantities(self, q: Sequence, v: Sequence) -> list[Value]:
        """What runs report of the forces between frames, force by force."""
        tips, states, out = self._tips(q, v), self.remembered(v), []
        for force in self.chain.forces:
            out += self._applied(force, tips, programs.quantities(force.shape), states)["quantity"]
        return out

    def force_slopes(
        self, q: Sequence, v: Sequence, w_ext: Sequence, at: Mapping[int, TipChange]
    ) -> tuple[Array, Array]:
        """The derivatives (nv, nv) with q and v of the generalised forces of :meth:`force_changes`."""
        by_q, by_v = mx.zeros(self.chain.nv, self.chain.nv), mx.zeros(self.chain.nv, self.chain.nv)
        for i, D_q, D_v in self.force_changes(q, v, w_ext, at):
            by_q, by_v = by_q + mx.multiply(at[i].J.T, D_q), by_v + mx.multiply(at[i].J.T, D_v)
        return by_q, by_v

    def force_changes(
        self, q: Sequence, v: Sequence, w_ext: Sequence, at: Mapping[int, TipChange]
    ) -> Iterator[tuple[int, Array, Array]]:
        """The derivatives (6, nv) with q and v of the wrench on each tip on which something acts, in its frame.

        A tip may come several times. ``at``: the changes of the tips.
        """
        tips = self._tips(q, v)
        for ends, by_pose, by_twist in self.force_maps(q, v, w_ext):
            J = np.vstack([at[i].J for i in ends])
            V_q = np.vstack([at[i].twist_by_q(self.chain, self._twist(tips[i])[3:], v) for i in ends])
            for n, i in enumerate(ends):
                row = slice(6 * n, 6 * n + 6)
                D_q = mx.multiply(by_pose[row], J) + mx.multiply(by_twist[row], V_q)
                yield i, D_q, mx.multiply(by_twist[row], J)

    def force_maps(self, q: Sequence, v: Sequence, w_ext: Sequence) -> Iterator[tuple[tuple[int, ...], Array, Array]]:
        """Of all that acts on tips: these tips, and the derivatives of the wrenches on them, each in its tip's axes.

        With m tips matrices (6 m, 6 m): with turn and shift of each tip in its own axes, and with its twist.
        """
        tips, states = self._tips(q, v), self.remembered(v)
        for i in self.chain.turned_wrenches:
            w = mx.rotate_wrench(tips[i].R.T, mx.array(list(w_ext[6 * i : 6 * i + 6])))
            turning = np.vstack([mx.hat(w[:3]), mx.hat(w[3:])])  # of Rᵀ w, by a turn of the tip in its own axes
            yield (i,), np.hstack([turning, mx.zeros(6, 3)]), mx.zeros(6, 6)
        for force in self.chain.forces:
            found = self._applied(force, tips, programs.slopes(force.shape), states)
            own = np.r_[tuple(slice(6 * n, 6 * n + 6) for n, i in enumerate(force.ends) if i is not None)]
            by_pose, by_twist = (mx.array(found[x], (12, 12))[np.ix_(own, own)] for x in ("by_pose", "by_twist"))
            yield tuple(force.tips), by_pose, by_twist

    def tip_twists(self, q: Sequence, v: Sequence, at: Sequence[int]) -> list[Value]:
        """The twists (6,) of some tips, each in its own axes."""
        tips = self._tips(q, v)
        return [x for i in at for x in self._twist(tips[i])]

    def wrenches_by_states(self, q: Sequence, v: Sequence) -> Iterator[tuple[slice, dict[int, Array]]]:
        """The states of every force that has any, and the derivatives (6, states) with them of the wrenches on tips in
        their frames, by segment."""
        tips, states = self._tips(q, v), self.remembered(v)
        for force in self.chain.forces:
            if count := len(force.shape.states):
                by = self._applied(force, tips, programs.state_slopes(force.shape), states)
                ends = zip(force.ends, ("first", "second"), strict=True)
                loads = {i: mx.array(by[name], (count, 6)).T for i, name in ends if i is not None}
                yield force.states, loads

    def input_powers(self, q: Sequence, v: Sequence) -> list[Value]:
        """The power that each input of a force gives to the robot."""
        tips, states = self._tips(q, v), self.remembered(v)
        forces = (force for force in self.chain.forces if force.shape.inputs)
        found = (self._applied(force, tips, programs.powers(force.shape), states)["power"] for force in forces)
        return [x for own in found for x in own]

    def wrenches_per_input(self, q: Sequence, v: Sequence) -> Iterator[list[Value]]:
        """The derivatives of the wrenches on all tips (6 n,) with each input of a force."""
        return self._wrenches_per(q, v, lambda shape: len(shape.inputs), programs.input_slopes)

    def wrenches_per_state(self, q: Sequence, v: Sequence) -> Iterator[list[Value]]:
        """The same with each internal state."""
        yield from self._wrenches_per(q, v, lambda shape: len(shape.states), programs.state_slopes)
        for _ in range(self.chain.n_held_states):
            yield [0.0] * (6 * self.chain.n)

    def _wrenches_per(
        self, q: Sequence, v: Sequence, size: Callable[[InteractionClass], int], program: Callable
    ) -> Iterator[list[Value]]:
        tips, states = self._tips(q, v), self.remembered(v)
        for force in self.chain.forces:
            count = size(force.shape)
            found = self._applied(force, tips, program(force.shape), states) if count else {}
            for k in range(count):
                total: list[Value] = [0.0] * (6 * self.chain.n)
                for end, name in zip(force.ends, ("first", "second"), strict=True):
                    if end is not None:
                        total[6 * end : 6 * end + 6] = found[name][6 * k : 6 * k + 6]
                yield total

    def _applied(
        self,
        force: PlacedForce,
        tips: Sequence[Tip],
        program: Any,
        states: Sequence[Value],
        twists: bool = True,
        over: Mapping[str, list] = MappingProxyType({}),
    ) -> Mapping[str, list]:
        """What a program of a force gives in a state of all tips, and of the internal states of all forces."""
        first, second = (self._end(force, i, tips) for i in force.ends)
        R = mx.multiply(first.R.T, second.R)
        d = mx.name(f"d_{force.name}", mx.multiply(first.R.T, second.r - first.r))
        given: dict[str, list] = {"R": list(R.flat), "d": list(d)}
        given |= {"V_A": list(self._twist(first)), "V_B": list(self._twist(second))} if twists else {}
        idle = [0.0] * len(force.shape.inputs)
        chosen = self.chosen[force.inputs] if self.chosen else idle
        given |= {"numbers": [*self.world[3:][force.numbers], *chosen, *states[force.states]], **over}
        return self.apply(force.tips[-1], -1, program, given)

    def _end(self, force: PlacedForce, segment: int | None, tips: Sequence[Tip]) -> Tip:
        if segment is not None:
            return tips[segment]
        return Tip(mx.identity(3), mx.array(list(self.world[3:][force.point])), mx.zeros(3), mx.zeros(3))

    @staticmethod
    def _twist(tip: Tip) -> Array:
        """In its own axes."""
        return mx.rotate_wrench(tip.R.T, tip.twist)

    def _tips(self, q: Sequence, v: Sequence) -> list[Tip]:
        """Poses and twists of all tips."""
        return self._moving_tips(q, v)[1]

    def _moving_tips(self, q: Sequence, v: Sequence) -> tuple[list, list[Tip]]:
        """All links in motion, and their tips."""
        links, places = self._run(MOTION, self.motion(q, v))
        nodes = [self.chain.tree.tip(i) for i in range(self.chain.n)]
        return links, [Tip.of(places[node], link["tip_twist"]) for node, link in zip(nodes, links, strict=True)]


def acting_tips(chain: Chain) -> Iterator[int]:
    """The segments on whose tips forces act, or wrenches in the axes of the world."""
    yield from chain.turned_wrenches
    yield from (i for force in chain.forces for i in force.tips)
