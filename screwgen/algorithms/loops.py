"""Closed loops: the wrenches on tips that keep them closed.

A row g of a loop (:mod:`..joints.constraints`) acts on its two tips by unit wrenches W. So `ġ = Σ Wᵀ V` over both tips,
and `g̈ = Σ Wᵀ a + γ` with the accelerations `a` of the tips. With `M⁻¹` applied by the elimination, once for every row,
the rows' forces λ follow from `(J M⁻¹ Jᵀ) λ = −(J v̇ + γ + 2 c ġ + c² g)`, where `v̇` are the accelerations of the open
tree and `c` is the loop's stabilisation. All vectors are in inertial axes.

A coupling of two axes is a row among coordinates, `g = q_b − r q_a − c`: its force acts on the two axes, as their
torques do, and its acceleration is that of their coordinates.

Where the rows of an overconstrained mechanism depend on each other, as those of four hinges whose axes meet in a point,
that matrix is singular and they share what they bear: :func:`sharing_solver`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from ..interactions import Length
from ..ir.derivative import tangents
from ..ir.program import Array, Program, Tracer, Value, Vector
from ..joints.constraints import Alignment, Angle, Distance, Ratio
from ..topology.chain import Chain
from ..topology.loops import ClosingRow, Junction
from . import matrices as mx
from .joint_moves import integration
from .schedule import Apply


@dataclass(frozen=True)
class Tip:
    """Pose and twist of a tip section: `R` (3, 3), `r` (3,) in m, `omega` (3,) in rad/s, `v` (3,) of the point."""

    R: Array
    r: Array
    omega: Array
    v: Array

    @classmethod
    def of(cls, node: Mapping[str, Sequence], twist: Sequence) -> Tip:
        """The tip of a node."""
        return cls(mx.array(node["R"], (3, 3)), mx.array(node["r"]), mx.array(twist[:3]), mx.array(twist[3:]))

    @property
    def twist(self) -> Array:
        return np.concatenate([self.omega, self.v])


class TipsAndAxes(NamedTuple):
    """What loops ask about: a quantity (6,) of every tip, and one of every joint axis (n_joints,)."""

    tips: Sequence[Array] | Mapping[int, Array]
    axes: Vector


Curve = tuple[Value, Value, Value]
"""A function of a coordinate, and its first two derivatives."""


class Axes(NamedTuple):
    """Coordinates and rates (n_joints,) of the joint axes."""

    q: Vector
    qdot: Vector
    curves: Mapping[Ratio, Curve] = MappingProxyType({})
    """f, f' and f'' of the rows that have a relation."""

    def curve(self, row: Ratio) -> Curve:
        """Those of a row; without a relation f is the coordinate."""
        return self.curves.get(row, (self.q[row.of], 1.0, 0.0))


@dataclass(frozen=True)
class ConstraintRow:
    """A row in a state: its `gap`, and what a unit force of it exerts.

    `wrenches`: on tips (6,), by the numbers of their links; `torques`: on joint axes, by theirs. `rate`: of the gap.
    `drift`: γ and the stabilisation.
    """

    gap: Value
    wrenches: Mapping[int, Array]
    torques: Mapping[int, Value]
    rate: Value
    drift: Value

    def power(self, motion: TipsAndAxes) -> Value:
        """The work of the unit force at accelerations of all tips and axes."""
        return _power(self.wrenches, self.torques, motion)


def _power(wrenches: Mapping[int, Array], torques: Mapping[int, Value], motion: TipsAndAxes) -> Value:
    parts = [mx.dot(w, motion.tips[i]) for i, w in wrenches.items()]
    parts += [torque * motion.axes[k] for k, torque in torques.items()]
    return sum(parts[1:], parts[0])


class LineState(NamedTuple):
    """A line between two points: its length, the wrenches of a unit force that makes it longer, and γ."""

    length: Value
    wrenches: Mapping[int, Array]
    gamma: Value


NO_LINES: Mapping[ClosingRow, LineState] = MappingProxyType({})


def row_at(closing: ClosingRow, tips: Sequence[Tip], axes: Axes, lines: Mapping = NO_LINES) -> ConstraintRow:
    """A row in a state of all tips and axes; ``lines``: those whose rows are lengths."""
    row, c = closing.row, closing.stabilisation
    wrenches: Mapping[int, mx.Array] = {}
    torques: Mapping[int, Value] = {}
    gamma: Value = 0.0
    if isinstance(row, Ratio):
        gap, torques = _ratio_gap(row, axes), _torques(row, axes)
        gamma = -row.ratio * (axes.curve(row)[2] * axes.qdot[row.of] * axes.qdot[row.of]) if row.relation else 0.0
    elif isinstance(row, Length):
        gap, wrenches, gamma = lines[closing]
    else:
        a, b = tips[closing.first], tips[closing.second]
        gap, *both, gamma = _distance(row.normal, a, b) if isinstance(row, Distance) else _angle(row, a, b)
        wrenches = dict(zip((closing.first, closing.second), both, strict=True))
    rate = _power(wrenches, torques, TipsAndAxes({i: tips[i].twist for i in wrenches}, axes.qdot))
    return ConstraintRow(gap, wrenches, torques, rate, gamma + 2 * c * rate + c * c * gap)


def _ratio_gap(row: Ratio, axes: Axes) -> Value:
    """``g = q_b − r f(q_a) − c``."""
    return axes.q[row.axis] - row.ratio * axes.curve(row)[0] - row.offset


def _torques(row: Ratio, axes: Axes) -> dict[int, Value]:
    """What a unit force of a coupling exerts on its axes."""
    return {row.axis: 1.0, row.of: -row.ratio * axes.curve(row)[1]}


Parts = tuple[Value, Array, Array, Value]
"""The gap, the unit wrenches on A and on B, and γ."""


def _distance(normal: Sequence[float], a: Tip, b: Tip) -> Parts:
    """``g = n · (r_B − r_A)`` with n fixed in A."""
    n, d, rate = mx.multiply(a.R, mx.array(normal)), b.r - a.r, b.v - a.v
    n_rate = mx.cross(a.omega, n)
    gamma = mx.dot(n_rate, rate) - mx.dot(a.omega, mx.cross(rate, n) + mx.cross(d, n_rate))
    return mx.dot(n, d), np.concatenate([-mx.cross(d, n), -n]), np.concatenate([mx.zeros(3), n]), gamma


def _angle(row: Angle, a: Tip, b: Tip) -> Parts:
    """``g = x · y − c`` with x fixed in A and y in B."""
    x, y = mx.multiply(a.R, mx.array(row.first)), mx.multiply(b.R, mx.array(row.second))
    c = mx.cross(x, y)
    c_rate = mx.cross(mx.cross(a.omega, x), y) + mx.cross(x, mx.cross(b.omega, y))
    turn = np.concatenate([c, mx.zeros(3)])
    return mx.dot(x, y) - row.cosine, turn, -turn, mx.dot(a.omega - b.omega, c_rate)


class Offsets(NamedTuple):
    """How far the two frames of a loop are from what it demands: differences of points, m, and of directions, with
    their rates. Where all are zero the loop is closed."""

    places: list[Value]
    turns: list[Value]
    place_rates: list[Value]
    turn_rates: list[Value]


def offsets(junction: Junction, tips: Sequence[Tip], axes: Axes) -> Offsets:
    """The offsets of a loop in a state of all tips and axes."""
    a, b, out = tips[junction.first], tips[junction.second], Offsets([], [], [], [])
    for demand in junction.demands:
        if isinstance(demand, Ratio):
            found, turns = [_ratio_gap(demand, axes)], demand.unit == "rad"
            rates = [_power({}, _torques(demand, axes), TipsAndAxes((), axes.qdot))]
        else:
            found, rates = _offset(demand, a, b)
            turns = not isinstance(demand, Distance)
        out[turns].extend(found)
        out[2 + turns].extend(rates)
    return out


def _offset(demand: Distance | Angle | Alignment, a: Tip, b: Tip) -> tuple[list[Value], list[Value]]:
    if isinstance(demand, Alignment):
        x, y = (mx.multiply(tip.R, mx.array(demand.direction)) * demand.weight for tip in (a, b))
        return list(x - y), list(mx.cross(a.omega, x) - mx.cross(b.omega, y))
    gap, first, second, _ = _distance(demand.normal, a, b) if isinstance(demand, Distance) else _angle(demand, a, b)
    return [gap], [mx.dot(first, a.twist) + mx.dot(second, b.twist)]


class Loads(NamedTuple):
    """What acts on a tree: torques of axes, perhaps with other inputs, and wrenches on all tips in their axes (6 n)."""

    tau: Sequence
    w_ext: Sequence

    def plus(self, more: Loads) -> Loads:
        """The sum of both, of which only the first may have other inputs."""
        torques, wrenches = ([a + b for a, b in zip(x, y, strict=False)] for x, y in zip(self, more, strict=True))
        return Loads([*torques, *self.tau[len(torques) :]], wrenches)


class LoopState:
    """The loops of a chain in a state; `rotations`: of F_i of all links; `rows`: else those that close it; `lines`: of
    which lengths are among these."""

    def __init__(
        self,
        chain: Chain,
        tips: Sequence[Tip],
        axes: Axes,
        rotations: Sequence,
        rows: Sequence[ClosingRow] | None = None,
        lines: Mapping[ClosingRow, LineState] = NO_LINES,
    ):
        self.chain, self.tips, self.axes, self.rotations = chain, tips, axes, rotations
        self.rows = [row_at(c, tips, axes, lines) for c in (chain.closing.rows if rows is None else rows)]

    def accelerations(self, links: Sequence[Mapping], places: Sequence[Mapping[str, Sequence]]) -> TipsAndAxes:
        """[angular; of the point, less free fall] of all tips, and of all axes, after forward dynamics."""
        nodes = [places[self.chain.tree.tip(i)] for i in range(self.chain.n)]
        sums = [[a + b for a, b in zip(node["acc_0"], node["delta"], strict=True)] for node in nodes]
        vdot = self.chain.join(links, "qddot", "etaddot")
        return TipsAndAxes(self._inertial(sums), self.chain.of_joints(vdot, rates=True))

    def drifts(self, places: Sequence[Mapping[str, Sequence]]) -> list[Value]:
        """The accelerations of all gaps while no coordinate accelerates; ``places`` as of :meth:`accelerations`."""
        tips = self._inertial([places[self.chain.tree.tip(i)]["acc_0"] for i in range(self.chain.n)])
        still = TipsAndAxes(tips, [0.0] * len(self.axes.q))
        return [row.power(still) + row.drift for row in self.rows]

    def _inertial(self, tips: Sequence[Sequence]) -> list[Array]:
        """Accelerations of all tips in inertial axes."""
        return [mx.rotate_wrench(R, mx.array(x)) for R, x in zip(self.rotations, tips, strict=True)]

    def wrenches(self, forces: Vector) -> list[Value]:
        """The wrenches on all tips, in their tip frames, of forces of the rows: six numbers for each tip."""
        total = [mx.zeros(6) for _ in self.tips]
        for found, force in zip(self.rows, forces, strict=True):
            for i, wrench in found.wrenches.items():
                total[i] = total[i] + wrench * force
        return [x for tip, w in zip(self.tips, total, strict=True) for x in mx.rotate_wrench(tip.R.T, w)]

    def torques(self, forces: Vector) -> list[Value]:
        """The torques on all axes of forces of the rows: those of couplings."""
        total: list[Value] = [0.0] * len(self.axes.q)
        for found, force in zip(self.rows, forces, strict=True):
            for k, torque in found.torques.items():
                total[k] = total[k] + torque * force
        return total

    def loads(self, forces: Vector) -> Loads:
        """Both, as far as they move anything: torques on axes whose motion is given do not."""
        own = self.chain.prescribed
        torques = [0.0 if k in own else x for k, x in enumerate(self.torques(forces))]
        return Loads(torques, self.wrenches(forces))

    def units(self) -> Iterator[Vector]:
        """A unit force of each row."""
        count = len(self.rows)
        return ([float(j == k) for j in range(count)] for k in range(count))


@cache
def solver(count: int) -> Program:
    """``(A, b) -> (x)`` with ``A x = b``; A by its upper triangle, row by row. Pivots must exceed rounding errors."""
    tracer = Tracer()
    A = mx.unpack(tracer.input("A", count * (count + 1) // 2), count)
    b = mx.array(tracer.input("b", count), (count,))
    scale = tracer.epsilon() * 64.0 * sum((A[k, k] for k in range(1, count)), A[0, 0])
    x = mx.solve(mx.factorise(A, tracer, scale), b)
    return tracer.program("loops", {"A": count * (count + 1) // 2, "b": count}, {"x": list(x)})


COMPLIANCE, LEAST = 1e-4, 1e-3
"""Of rows that share forces, as a part of their own entries in A, a thousand times the rounding of single precision;
and by which part of A's trace an entry counts as larger, so that rows that move nothing have a compliance too."""
SHARES = 6
"""Solutions for what is left; each leaves `ε/(ε + σ)` of it, with the compliance ε and an eigenvalue σ of A over its
diagonal: 1e-12 of all after six, where σ is 1 %."""


@cache
def sharing_solver(count: int) -> Program:
    """The same for rows that may depend on each other, which then share what they bear.

    A compliance makes A definite; what it leaves of b is solved for again. What the rows demand that no motion of the
    robot can give, such as the drift of an integrator adds, is hardly answered; a pseudoinverse would multiply it.
    """
    tracer, size = Tracer(), count * (count + 1) // 2
    x = _shared(mx.unpack(tracer.input("A", size), count), mx.array(tracer.input("b", count), (count,)), tracer)
    return tracer.program("shared_loops", {"A": size, "b": count}, {"x": list(x)})


@cache
def share_slopes(count: int) -> Program:
    """``(A, b, A_along) -> (x_along)``: how that solution changes with A, less what ``A dx = -dA x`` answers to it."""
    tracer, size = Tracer(), count * (count + 1) // 2
    entries, b = tracer.input("A", size), mx.array(tracer.input("b", count), (count,))
    along, A = tracer.input("A_along", size), mx.unpack(entries, count)
    x = _shared(A, b, tracer)
    moved = mx.array(tangents(list(x), dict(zip(entries, along, strict=True))))
    found = moved + _shared(A, mx.multiply(mx.unpack(along, count), x), tracer)
    return tracer.program("share_slopes", {"A": size, "b": count, "A_along": size}, {"x_along": list(found)})


def _shared(A: Array, b: Array, tracer: Tracer) -> Array:
    """The forces x of ``A x = b`` of rows that share them."""
    count = len(b)
    whole = sum((A[k, k] for k in range(1, count)), A[0, 0])
    tracer.guard(whole)
    factor = mx.factorise(A + mx.diagonal([COMPLIANCE * (A[k, k] + LEAST * whole) for k in range(count)]))
    x, rest = mx.zeros(count), b
    for k in range(SHARES):
        x = x + mx.solve(factor, rest)
        rest = b - mx.multiply(A, x) if k < SHARES - 1 else rest
    return x


# ------------------------------------------------------------------------------------------ corrections


def combined(x: Sequence, forces: Sequence, answers: Sequence[Sequence]) -> list:
    """``x`` and the sum of the answers, each times a force."""
    total = list(x)
    for force, answer in zip(forces, answers, strict=True):
        total = [a + force * b for a, b in zip(total, answer, strict=True)]
    return total


def moved(chain: Chain, q: Sequence, forces: Sequence, answers: Sequence[Sequence], apply: Apply) -> list:
    """The coordinates (nq,) and that sum of changes (nv,), by which joints move each in its way.

    The answers to forces inside the robot have no momentum, so the centre of mass of one that floats stays, to first
    order.
    """
    own = combined([q[k] for k in chain.flat_q], forces, [[answer[k] for k in chain.flat_v] for answer in answers])
    out = dict(zip(chain.flat_q.tolist(), own, strict=True))
    for part in chain.curved:
        u = combined([0.0] * part.joint.nv, forces, [answer[part.v] for answer in answers])
        found = apply(part.link, 0, integration(part.joint), {"q": list(q[part.q]), "u": u})["moved"]
        out |= dict(zip(range(part.q.start, part.q.stop), found, strict=True))
    return [out[k] for k in range(chain.nq)]
