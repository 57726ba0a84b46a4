"""The functions of robots with loops: the forces of their rows, and whether and how they close."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import Self

from ..errors import SingularError
from ..ir.derivative import tangents
from ..ir.program import Node, Vector
from ..joints.constraints import Ratio
from ..topology.chain import Chain
from ..topology.loops import ClosingRow
from . import loops
from . import matrices as mx
from .columns import columns
from .loop_loads import Shared, sharing
from .relations import curve
from .schedule import Apply

ROUNDS = 3
"""Corrections that close a loop whose gaps are small: each squares what remains."""


class LoopFunctions:
    """What :class:`.functions.Functions` has besides for loops; the attributes are set there."""

    chain: Chain
    constants: Sequence[dict[str, list]]
    apply: Apply
    given: tuple[Sequence, Sequence] | None
    section: Callable[[str], AbstractContextManager]
    forward: Callable[..., tuple[list, list]]
    loads: Callable[..., tuple[list, list]]
    levers: Callable[[Sequence], list]
    alone: Callable[[], Self]
    with_forces: Callable[..., Sequence]
    under_inputs: Callable[[Sequence], Self]
    braked: Callable[[Sequence], Self]
    coordinate_rates: Callable[[Sequence, Sequence], list]
    _moving_tips: Callable[..., tuple[list, list[loops.Tip]]]

    def loop_wrenches(self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> list:
        """The wrenches with which the loops act on the tips, in the order and the frames of ``w_ext``."""
        state, forces = self.loop_forces(q, v, tau, w_ext)
        with self.section("loops: their wrenches on the tips"):
            return state.wrenches(forces)

    def loop_forces(self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> tuple[loops.LoopState, list]:
        """The loops in a state, and the forces of their rows."""
        return self.row_forces(q, v, loops.Loads(tau, self.under_inputs(tau).with_forces(q, v, w_ext)))

    def row_forces(self, q: Sequence, v: Sequence, given: loops.Loads) -> tuple[loops.LoopState, list]:
        """The same where what acts on the tips is known."""
        state, wanted = self.wanted(q, v, given)
        inertia = self.given[0] if self.given else None
        return state, self.braked(given.tau)._unit_answers(q, state, inertia, wanted)[0][0]

    def wanted(self, q: Sequence, v: Sequence, given: loops.Loads) -> tuple[loops.LoopState, list]:
        """The loops in a state, and the accelerations of their gaps that the rows' forces must give."""
        state = self.loop_state(q, v)
        unconstrained = state.accelerations(*self.forward(q, v, *given))
        with self.section("loops: accelerations of the gaps that the rows' forces must give"):
            return state, [-(c.power(unconstrained) + c.drift) for c in state.rows]

    def share_slopes(self, q: Sequence, v: Sequence, tau: Sequence, wanted: Sequence, inertia: Sequence) -> mx.Array:
        """What forces of rows that share them change with q, (rows, nv), in a program that is being recorded.

        The accelerations ``wanted`` of the gaps fix these forces as far as they move anything; that part is left out.
        How rows share the rest follows from ``J M⁻¹ Jᵀ``, which turns with the posture. ``inertia``: that of the given
        coordinates.
        """
        f, nv = self.braked(tau), self.chain.nv
        entries = mx.pack(f._answers(q, self.loop_state(q, v), inertia)[0])
        program, given = loops.share_slopes(len(wanted)), {"A": entries, "b": list(wanted)}
        found = []
        for k in range(nv):
            rates = f.coordinate_rates(q, [float(i == k) for i in range(nv)])
            along = tangents(entries, {a: b for a, b in zip(q, rates, strict=True) if isinstance(a, Node)})
            found.append(self.apply(self.chain.closing.rows[-1].second, 0, program, given | {"A_along": along}))
        return mx.array([one["x_along"] for one in found]).T

    def with_loops(self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> loops.Loads:
        """Torques and wrenches on the tips, those of the loops and of forces between frames included."""
        given = loops.Loads(tau, self.under_inputs(tau).with_forces(q, v, w_ext))
        if not self.chain.closing.rows:
            return given
        state, forces = self.row_forces(q, v, given)
        with self.section("loops: their wrenches on the tips"):
            found = state.loads(forces)
        return given.plus(found)

    def closed_motion(
        self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence
    ) -> tuple[list, loops.Loads, loops.LoopState, list, Callable[[], loops.TipsAndAxes]]:
        """With loops closed: ``vdot``, all loads, the loops, their rows' forces, and how tips and axes accelerate."""
        outer = loops.Loads(tau, self.with_forces(q, v, w_ext))
        shut, forces = self.row_forces(q, v, outer)
        loads = outer.plus(shut.loads(forces))
        links, places = self.forward(q, v, *loads)
        return (
            self.chain.join(links, "qddot", "etaddot"),
            loads,
            shut,
            forces,
            lambda: shut.accelerations(links, places),
        )

    def coupling_torques(self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> list:
        """The torques (n_joints,) with which couplings act on the joint axes, forces on those that slide."""
        state, forces = self.loop_forces(q, v, tau, w_ext)
        return state.torques(forces)

    def shared_loads(self, q: Sequence, v: Sequence, vdot: Sequence, w_ext: Sequence) -> Shared:
        """Inverse dynamics of a motion that keeps the loops closed: see :mod:`.loop_loads`."""
        chain, (force, _), state = self.chain, self.loads(q, v, vdot, w_ext), self.loop_state(q, v)
        still, rest = self.alone(), [0.0] * chain.nv
        still.given, still.section = (self._inertia(), [0.0] * chain.n_given), nullcontext
        exerted = []
        for unit in state.units():
            borne = [-x for x in still.loads(q, rest, rest, state.wrenches(unit))[0]]
            for k, torque in enumerate(state.torques(unit), chain.base_v):
                borne[k] = borne[k] + torque
            exerted.append(borne)
        passive, driven = chain.passive_axes, chain.driven_axes
        wound = range(chain.eta_v - chain.n_added, chain.eta_v)
        others = [k for k in range(chain.nv) if k not in (*passive, *driven, *wound)]
        order, ranks = [*passive, *others, *driven], (len(passive), len(others), len(driven))
        program = sharing(ranks, len(exerted), chain.closing.overconstrained)
        needed, levers = list(force), self.levers(q) if chain.elastic_travels else ()
        for joint, place in chain.elastic_travels.items():  # of both the effort is part, in proportion
            needed[chain.base_v + joint] = needed[chain.base_v + joint] - levers[joint] * force[place]
        given = {"J": [row[k] for row in exerted for k in order], "f": [needed[k] for k in order]}
        try:
            rows = self.apply(chain.closing.rows[-1].second, 0, program, given)["x"]
        except SingularError:
            raise chain.singular_loops() from None
        left = loops.combined(force, [-x for x in rows], exerted)
        return Shared(left, rows, state.wrenches(rows))

    def close(self, q: Sequence, v: Sequence) -> tuple[Sequence, Sequence]:
        """Coordinates and rates near the given ones with which the loops are closed, by ``ROUNDS`` corrections."""
        for _ in range(ROUNDS):
            q, v = self.correct(q, v)
        return q, v

    def correct(self, q: Sequence, v: Sequence) -> tuple[list, list]:
        """Newton's corrections, of least kinetic energy, that close the gaps and stop their rates."""
        state = self.loop_state(q, v)
        wanted = [[-c.gap for c in state.rows], [-c.rate for c in state.rows]]
        forces, answers = self._unit_answers(q, state, None, *wanted)
        rates, internal = v[: self.chain.nv], v[self.chain.nv :]
        new_v = [*loops.combined(rates, forces[1], answers), *internal]
        return loops.moved(self.chain, q, forces[0], answers, self.apply), new_v

    def gaps(self, q: Sequence, v: Sequence) -> tuple[list, list]:
        """The gap of every row of the loops, m or cosines, and its rate."""
        found = self.loop_state(q, v).rows
        return [c.gap for c in found], [c.rate for c in found]

    def offsets(self, q: Sequence, v: Sequence) -> list[loops.Offsets]:
        """How far each loop is from closed, whichever of its rows bear forces, and the rates of it."""
        state = self.loop_state(q, v)
        return [loops.offsets(junction, state.tips, state.axes) for junction in self.chain.closing.junctions]

    def openings(self, q: Sequence) -> list:
        """The squares of how far each loop is from closed: of the distance, m², and of the angle; two for each loop."""
        found = self.offsets(q, [0.0] * self.chain.nv)
        return [mx.dot(x, x) for loop in found for x in (loop.places, loop.turns)]

    def idle_gaps(self) -> list:
        """The gaps of the rows that no motion changes, which depend on parameters alone: those at home."""
        state = self.loop_state(self.chain.home, [0.0] * self.chain.nv)
        return [loops.row_at(row, state.tips, state.axes).gap for row in self.chain.closing.idle]

    def loops_at(self, q: Sequence, forces: Sequence) -> tuple[list, loops.Loads]:
        """The gap of every row, and what forces of the rows exert."""
        state = self.loop_state(q, [0.0] * self.chain.nv)
        return [c.gap for c in state.rows], state.loads(forces)

    def _unit_answers(
        self, q: Sequence, state: loops.LoopState, inertia: Sequence | None, *wanted: Vector
    ) -> tuple[list[list], list[list]]:
        """The rows' forces that give the gaps each of the ``wanted`` accelerations, and ``v̇`` by a unit of each."""
        A, answers = self._answers(q, state, inertia)
        return self.solve_rows(A, wanted), answers

    def _answers(self, q: Sequence, state: loops.LoopState, inertia: Sequence | None) -> tuple[mx.Array, list[list]]:
        """The accelerations (rows, rows) of the gaps by a unit force of each row, and ``v̇`` by it.

        The robot is at rest, without weight, springs and dampers; ``inertia`` is that of the given coordinates, by
        default their own.
        """
        still, own = self.alone(), self._inertia() if inertia is None else inertia
        still.given, still.section = (own, [0.0] * self.chain.n_given), nullcontext
        rest = [0.0] * self.chain.nv
        found = [still.forward(q, rest, *state.loads(unit)) for unit in state.units()]
        answers = [state.accelerations(*one) for one in found]
        with self.section("loops: accelerations of the gaps by unit forces of the rows"):
            A = mx.symmetric(len(answers), lambda i, j: state.rows[i].power(answers[j]))
        return A, [self.chain.join(links, "qddot", "etaddot") for links, _ in found]

    def solve_rows(self, A: mx.Array, wanted: Sequence[Vector]) -> list[list]:
        """The rows' forces x of ``A x = b`` for each b that is wanted; rows may share them."""
        solve = (loops.sharing_solver if self.chain.closing.overconstrained else loops.solver)(len(A))
        apply = lambda b: self.apply(self.chain.closing.rows[-1].second, 0, solve, {"A": mx.pack(A), "b": list(b)})["x"]  # noqa: E731
        try:
            return [apply(b) for b in wanted]
        except (SingularError, ZeroDivisionError):
            raise self.chain.singular_loops() from None

    def _curve(self, link: int, row: Ratio, q: Vector) -> loops.Curve:
        """f, f' and f'' of the relation of a coupling."""
        assert row.relation is not None
        found = self.apply(link, -1, curve(row.relation), {"x": [q[row.of]]})
        return found["f"][0], found["slope"][0], found["bend"][0]

    def _inertia(self) -> list:
        """The inertia of the coordinates that integrators give theirs."""
        return columns(self.chain, self.constants)["M_eta"]

    def loop_state(
        self,
        q: Sequence,
        v: Sequence,
        rows: Sequence[ClosingRow] | None = None,
        lines: Callable[[Sequence[loops.Tip]], Mapping] = lambda tips: {},
    ) -> loops.LoopState:
        """The loops in a state; ``rows``: other rows than those that close the tree, ``lines``: those among these."""
        links, tips = self._moving_tips(q, v)
        axes = loops.Axes(self.chain.of_joints(q), self.chain.of_joints(v, rates=True))
        axes = axes._replace(
            curves={row: self._curve(second, row, axes.q) for second, row in self.chain.closing.related}
        )
        with self.section("loops: gaps, their rates and what their accelerations are without those of the tips"):
            rotations = [mx.array(link["R"], (3, 3)) for link in links]
            return loops.LoopState(self.chain, tips, axes, rotations, rows, lines(tips))
