"""First-order changes of closed loops: of the accelerations of their gaps, and of their wrenches on the tips.

A gap's row ``g̈ + 2 c ġ + c² g`` is a function of the relative pose of its two tips, of their twists and of their
accelerations, all in tip-frame components; so is what given forces of the rows exert on the tips, of the pose alone.
These functions are differentiated by the tracer, and the chain rule goes through the motions of the tips.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from ..ir.derivative import columns, tangents
from ..ir.program import Array, Node, Program, Tracer, Value, Vector
from ..joints.constraints import Ratio
from ..topology.chain import Chain
from ..topology.loops import ClosingRow
from . import matrices as mx
from .loops import Axes, LoopState, Tip, TipsAndAxes, row_at
from .relations import row_slopes
from .rows import cross_columns
from .schedule import Apply

MOTION = 9
"""The entries of a tip's motion ``[omega; omegadot; a]``."""


@dataclass
class TipChange:
    """The changes of a tip's motion at given ``vdot``, in tip-frame components.

    ``J`` (6, nv): its twist per unit of v; ``by_q``, ``by_v`` (9, nv): the derivatives of its motion.
    """

    J: Array
    by_q: Array
    by_v: Array

    def twist_by_q(self, chain: Chain, v: Array, rates: Sequence = ()) -> Array:
        """The derivative (6, nv) of the tip's twist with q at held ``rates`` (nv,), at the velocity ``v`` of its point.

        A column of the Jacobian has the rate ``Jdot = dV/dq - ad_V J``, and ``d(Vdot)/dv = Jdot + dV/dq``, so
        ``d(vdot + omega x v)/dv = 2 (dv/dq - v x J_omega)``. A floating base moves with its twist held. The turn of a
        ball joint has its angular velocity w in axes that turn with it: there ``Jdot`` has ``J hat(w)`` besides. Only
        robots with such joints need the rates.
        """
        moved = 0.5 * self.by_v[6:] + cross_columns(v, self.J[:3])
        moved[:, : chain.base_v] = 0.0
        for part in (part for part in chain.curved if part.v.start >= chain.base_v):
            turning = mx.hat(mx.array(list(rates[part.v])))
            moved[:, part.v] = moved[:, part.v] - 0.5 * mx.multiply(self.J[3:, part.v], turning)
        return np.vstack([self.by_q[:3], moved])


@dataclass
class RowChange:
    """The rows of the loops, ``J vdot + drift = 0``: their ``forces``, ``J`` and their derivatives at given vdot,
    (rows, nv) each."""

    forces: Sequence
    J: Array
    by_q: Array
    by_v: Array


def tips(chain: Chain) -> list[int]:
    """The links at whose tips loops act, in the order of the file."""
    wrenching = (c for c in chain.closing.rows if not isinstance(c.row, Ratio))
    return list(dict.fromkeys(i for c in wrenching for i in (c.first, c.second)))


def loop_changes(
    chain: Chain, state: LoopState, acc: TipsAndAxes, forces: Sequence, at: Mapping[int, TipChange], apply: Apply
) -> tuple[RowChange, Array]:
    """The changes of the rows, and of the generalised forces that given ``forces`` of the rows exert.

    ``acc``: the accelerations of all tips (6,) in inertial axes, against free fall, and of all joint axes; ``at``: the
    changes of the tips.
    The second is the derivative (nv, nv) with q of the generalised forces, as far as the wrenches change in tip-frame
    components; that of wrenches held in these is part of the inverse dynamics' derivatives.
    """
    rows: list[list[Array]] = [[], [], []]
    bend, nv = mx.zeros(chain.nv, chain.nv), chain.nv
    for loop in dict.fromkeys(c.loop for c in chain.closing.rows):
        own = [(k, c) for k, c in enumerate(chain.closing.rows) if c.loop == loop]
        if isinstance(own[0][1].row, Ratio):
            _add_coupling(chain, own[0][1], rows)
            if own[0][1].row.relation is not None:
                _bend_coupling(chain, state, own[0][1], acc.axes, forces[own[0][0]], rows, bend, apply)
            continue
        found, J, V_q, moved = _of_ends(chain, state, own, acc.tips, forces, at, apply)
        acc_q, acc_v = (np.vstack([getattr(end, x)[3:] for end in moved]) for x in ("by_q", "by_v"))
        units, by_pose, by_twist = found["units"], found["by_pose"], found["by_twist"]
        rows[0].append(mx.multiply(units, J))
        rows[1].append(mx.multiply(by_pose, J) + mx.multiply(by_twist, V_q) + mx.multiply(units, acc_q))
        rows[2].append(mx.multiply(by_twist, J) + mx.multiply(units, acc_v))
        bend = bend + mx.chain(J.T, found["bend"], J)
    return RowChange(forces, *(np.vstack([mx.zeros(0, nv), *x]) for x in rows)), bend


def wrench_changes(
    chain: Chain, state: LoopState, forces: Sequence, at: Mapping[int, TipChange], apply: Apply
) -> Iterator[tuple[int, Array]]:
    """The derivatives (6, nv) with q of the wrenches on tips, in their frames, that given ``forces`` of the rows exert.

    A tip may come several times. ``at``: the changes of the tips.
    """
    still = [mx.zeros(6)] * chain.n
    for loop in dict.fromkeys(c.loop for c in chain.closing.rows if not isinstance(c.row, Ratio)):
        own = [(k, c) for k, c in enumerate(chain.closing.rows) if c.loop == loop]
        found, J, *_ = _of_ends(chain, state, own, still, forces, at, apply)
        first, second = np.split(mx.multiply(found["bend"], J), 2)
        yield own[0][1].first, first
        yield own[0][1].second, second


def _of_ends(
    chain: Chain,
    state: LoopState,
    own: Sequence[tuple[int, ClosingRow]],
    acc: Sequence[Array] | Mapping[int, Array],
    forces: Sequence,
    at: Mapping[int, TipChange],
    apply: Apply,
) -> tuple[dict[str, Array], Array, Array, tuple[TipChange, TipChange]]:
    """What :func:`slopes_of_rows` finds of the rows ``own`` of one loop, with their numbers; ``J`` (12, nv) of its two
    tips, the derivative of their twists with q, and their changes."""
    found, twists = _maps(state, own, acc, forces, apply)
    moved = at[own[0][1].first], at[own[0][1].second]
    V_q = np.vstack([end.twist_by_q(chain, V[3:]) for end, V in zip(moved, twists, strict=True)])
    return found, np.vstack([end.J for end in moved]), V_q, moved


def row_maps(
    chain: Chain, state: LoopState, acc: Sequence[Array] | Mapping[int, Array], forces: Sequence, apply: Apply
) -> Iterator[tuple[list[int], tuple[int, int], dict[str, Array]]]:
    """Of every loop but couplings: the numbers of its rows, its two tips, and what :func:`slopes_of_rows` finds."""
    for loop in dict.fromkeys(c.loop for c in chain.closing.rows if not isinstance(c.row, Ratio)):
        own = [(k, c) for k, c in enumerate(chain.closing.rows) if c.loop == loop]
        yield [k for k, _ in own], (own[0][1].first, own[0][1].second), _maps(state, own, acc, forces, apply)[0]


def coupling_changes(
    chain: Chain, state: LoopState, acc: Vector, forces: Sequence, apply: Apply
) -> tuple[list[int], list[Array], Array]:
    """Of couplings: the numbers of their rows, ``J`` and its derivatives (rows, nv), and what they bend (nv, nv)."""
    numbers: list[int] = []
    rows: list[list[Array]] = [[], [], []]
    bend = mx.zeros(chain.nv, chain.nv)
    for k, coupling in enumerate(chain.closing.rows):
        if isinstance(coupling.row, Ratio):
            numbers.append(k)
            _add_coupling(chain, coupling, rows)
            if coupling.row.relation is not None:
                _bend_coupling(chain, state, coupling, acc, forces[k], rows, bend, apply)
    return numbers, [np.vstack([mx.zeros(0, chain.nv), *x]) for x in rows], bend


def _maps(
    state: LoopState,
    own: Sequence[tuple[int, ClosingRow]],
    acc: Sequence[Array] | Mapping[int, Array],
    forces: Sequence,
    apply: Apply,
) -> tuple[dict[str, Array], list[Array]]:
    """What :func:`slopes_of_rows` finds of the rows ``own`` of one loop, and the twists of its tips in their axes."""
    first, second = own[0][1].first, own[0][1].second
    a, b = state.tips[first], state.tips[second]
    twists = [mx.rotate_wrench(tip.R.T, tip.twist) for tip in (a, b)]
    given = {"R": list(mx.multiply(a.R.T, b.R).flat), "d": list(mx.multiply(a.R.T, b.r - a.r))}
    given |= {"V_A": list(twists[0]), "V_B": list(twists[1]), "forces": [forces[k] for k, _ in own]}
    given |= {f"acc_{x}": list(mx.rotate_wrench(t.R.T, acc[i])) for x, t, i in (("A", a, first), ("B", b, second))}
    program = slopes_of_rows(tuple(replace(c, loop=0, first=0, second=1, name="") for _, c in own))
    return {k: mx.array(x, (-1, 12)) for k, x in apply(second, 0, program, given).items()}, twists


def _add_coupling(chain: Chain, coupling: ClosingRow, rows: list[list[Array]]) -> None:
    """The row of a coupling, which is linear in coordinates and rates."""
    assert isinstance(coupling.row, Ratio)
    J, c = mx.zeros(1, chain.nv), coupling.stabilisation
    for axis, entry in ((coupling.row.axis, 1.0), (coupling.row.of, -coupling.row.ratio)):
        J[0, chain.base_v + axis] = entry
    for matrices, value in zip(rows, (J, c * c * J, 2 * c * J), strict=True):
        matrices.append(value)


def _bend_coupling(
    chain: Chain,
    state: LoopState,
    coupling: ClosingRow,
    acc: Vector,
    force: Value,
    rows: list[list[Array]],
    bend: Array,
    apply: Apply,
) -> None:
    """What a relation changes of the row of a coupling and of the forces that it exerts."""
    row, c = coupling.row, coupling.stabilisation
    assert isinstance(row, Ratio) and row.relation is not None
    q, w = state.axes.q[row.of], state.axes.qdot[row.of]
    given: dict[str, list] = {"x": [q], "w": [w], "acc": [acc[row.of]], "force": [force], "rate": [c]}
    found = apply(coupling.second, -1, row_slopes(row.relation), given)
    of = chain.base_v + row.of
    entries = (-found["slope"][0], found["by_x"][0], found["by_w"][0])
    for matrices, value in zip(rows, entries, strict=True):
        matrices[-1][0, of] = row.ratio * value
    bend[of, of] = bend[of, of] + row.ratio * found["bend"][0]


@cache
def slopes_of_rows(rows: tuple[ClosingRow, ...]) -> Program:
    """The rows of one loop, differentiated; all in tip-frame components, each end's in its own.

    ``R`` (9) and ``d`` (3): the pose of tip B in A; ``V_A``, ``V_B``, ``acc_A``, ``acc_B`` (6): twists and
    accelerations; ``forces``: of the rows. Matrices row by row, with 12 columns, the six of A before those of B:
    ``units``: the rows' unit wrenches, which are their derivatives with the accelerations; ``by_twist``; ``by_pose``:
    those with [turn; shift] of each tip in its own axes; ``bend`` (12 rows): that of the wrenches of the forces.
    """
    tracer = Tracer()
    R, d = mx.array(tracer.input("R", 9), (3, 3)), mx.array(tracer.input("d", 3))
    V_A, V_B, acc_A, acc_B = (mx.array(tracer.input(name, 6)) for name in ("V_A", "V_B", "acc_A", "acc_B"))
    forces = tracer.input("forces", len(rows))
    a = Tip(mx.identity(3), mx.zeros(3), *np.split(V_A, 2))
    b = Tip(R, d, *np.split(mx.rotate_wrench(R, V_B), 2))
    found = [row_at(c, [a, b], Axes((), ())) for c in rows]
    acc = TipsAndAxes([acc_A, mx.rotate_wrench(R, acc_B)], ())
    values = [c.power(acc) + c.drift for c in found]
    units = [np.concatenate([c.wrenches[0], mx.rotate_wrench(R.T, c.wrenches[1])]) for c in found]
    wrenches = sum((unit * force for unit, force in zip(units, forces, strict=True)), mx.zeros(12))
    by_pose = mx.array([tangents([*values, *wrenches], seed) for seed in pose_changes(R, d)]).T
    by_twist = mx.array(columns(values, [*V_A, *V_B])).T
    inputs = {"R": 9, "d": 3, "V_A": 6, "V_B": 6, "acc_A": 6, "acc_B": 6, "forces": len(rows)}
    outputs = {"units": np.array(units), "by_twist": by_twist}
    outputs |= {"by_pose": by_pose[: len(rows)], "bend": by_pose[len(rows) :]}
    return tracer.program("loop_slopes", inputs, {name: list(x.flat) for name, x in outputs.items()})


def pose_changes(R: Array, d: Array) -> list[dict[Node, Value]]:
    """The changes of the pose of B in A with turns and shifts of A, and of B, each in its own axes."""
    none, unit = mx.zeros(3, 3), mx.identity(3)
    pairs = [(-mx.multiply(mx.hat(e), R), -mx.cross(e, d)) for e in unit]
    pairs += [(none, -e) for e in unit]
    pairs += [(mx.multiply(R, mx.hat(e)), mx.zeros(3)) for e in unit]
    pairs += [(none, mx.multiply(R, e)) for e in unit]
    return [dict(zip([*R.flat, *d], [*R_by.flat, *d_by], strict=True)) for R_by, d_by in pairs]
