"""Stiff lines and loops whose joints give way, over an implicit step: wrenches on tips that are those of its end.

A row with the gap g, stiffness k and damping c bears ``-(k g + c gdot)``; as a force between frames it acts on the tree
like all others, at the state of a stage. Where that is too stiff for the step, an implicit method takes it ``h`` after
the start, where g and gdot are known. Its acceleration is ``gddot = J a + gamma``, with the unit wrenches J of the row
and the accelerations a, so

    force = -f - S gddot,    f = k (g + h gdot - h² gamma/2) + c gdot,    S = h (c + h k).

The gap itself moves by ``h² (J a + gamma/2)``, hence the last term of k. What the row bears beside the force at the
stage, nu, follows from ``(J M⁻¹ Jᵀ + 1/S) nu = …`` together with the rows of rigid loops, and acts as an external
wrench. Without bound of k that is the row of a rigid loop; S = 0 leaves the force as it is.

The gap of a line is its length less that at rest. A rope bears nothing where it would be slack at the end of the step
without its own pull, or would have to push: its S and f are then 0.

A stage ahead of the start is the middle of a step, whose coordinates move by the mean of old and new rates. There a row
that the step does not resolve would swing from one side to the other for ever. So its force is taken later, by the part
``z/(1 + z)``, with ``z = h² k J M⁻¹ Jᵀ``: that is of second order in h, small where the step resolves the row, and near
1 where it does not; that of a damper by ``z = h c J M⁻¹ Jᵀ``. With ``s = z/(1 + z)`` that makes ``h (1 + 2 s)`` of the
h beside gdot, ``h² (1 + 3 s)`` of the h² in S, ``h c (1 + s)`` of h c, and ``h² (1 - s)`` of the h² beside gamma.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np

from ..errors import SingularError
from ..interactions import SHORTEST, Length, SoftRow
from ..ir.program import Array, Program, Tracer, Value
from ..topology.chain import Chain
from ..topology.forces import PlacedForce
from ..topology.loops import ClosingRow
from . import loops
from . import matrices as mx
from .schedule import Apply


class CompliantFunctions:
    """What :class:`.functions.Functions` has besides for such loops; the attributes are set there."""

    chain: Chain
    world: Sequence
    given: tuple[Sequence, Sequence] | None
    apply: Apply
    forward: Callable[..., tuple[list, list]]
    under_inputs: Callable[[Sequence], Any]
    falling: Callable[[Sequence], Any]
    braked: Callable[[Sequence], Any]
    loop_state: Callable[..., loops.LoopState]
    chosen: Sequence
    _answers: Callable[..., tuple[Array, list]]
    _end: Callable[..., loops.Tip]

    def row_terms(self, q: Sequence, v: Sequence) -> list[Value]:
        """The gap of every row, then its rate; of a line its length."""
        rows = self.loop_state(q, v, [one.closing for one in self.chain.compliant], self._lines).rows
        return [x.gap for x in rows] + [x.rate for x in rows]

    def settled(self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence, h: Value) -> list[Value]:
        """``w_ext`` with what rows bear besides that settle within ``h``, as a run of such steps reports them."""
        return self.with_rows(q, v, tau, w_ext, self.row_terms(q, v), h, 0.0, settled=True)

    def with_rows(
        self,
        q: Sequence,
        v: Sequence,
        tau: Sequence,
        w_ext: Sequence,
        terms: Sequence,
        h: Value,
        ahead: Value,
        *,
        settled: bool = False,
    ) -> list[Value]:
        """``w_ext`` with what the rows bear beside the forces that act at this state.

        ``terms``: :meth:`row_terms` at the start, ``h`` s before; ``ahead``: 1 at a stage ahead of it, 0 at the start.
        """
        closing, soft = self.chain.closing.rows, self.chain.compliant
        state = self.loop_state(q, v, [*closing, *(one.closing for one in soft)], self.falling(tau)._lines)
        given = loops.Loads(tau, self.under_inputs(tau).with_forces(q, v, w_ext))
        links, places = self.forward(q, v, *given)
        moved, drifts = state.accelerations(links, places), state.drifts(places)[len(closing) :]
        A, _ = self.braked(tau)._answers(q, state, self.given[0] if self.given else None)
        own, laws = state.rows[len(closing) :], self.under_inputs(tau).row_laws()
        gaps = [x.gap - law.rest for x, law in zip(own, laws, strict=True)]
        rates = [x.rate - law.speed for x, law in zip(own, laws, strict=True)]
        inputs = {
            "A": mx.pack(A),
            "gddot": [x.power(moved) + x.drift for x in state.rows],
            "now": [x.stiffness * g + x.damping * w for x, g, w in zip(laws, gaps, rates, strict=True)],
            "start": [a - b for a, b in zip(terms, [*(x.rest for x in laws), *(x.speed for x in laws)], strict=True)],
            "gamma": drifts,
            "k": [x.stiffness for x in laws],
            "c": [x.damping for x in laws],
            "h": [h],
            "ahead": [ahead],
        }
        ropes = tuple(k for k, law in enumerate(laws) if law.slack)
        inputs |= {"stretch": [gaps[k] for k in ropes]} if ropes else {}
        program = solver(len(closing), len(soft), self.chain.closing.overconstrained, settled, ropes)
        try:
            found = self.apply(soft[-1].closing.second, 0, program, inputs)["nu"]
        except SingularError:
            raise self.chain.singular_loops() from None
        added = state.wrenches([*[0.0] * len(closing), *found])
        return [a + b for a, b in zip(w_ext, added, strict=True)]

    def row_laws(self) -> list[SoftRow]:
        """The law of every row."""
        numbers, out = self.world[3:], []
        for row, force in ((one.closing.row, one.force) for one in self.chain.compliant):
            chosen = self.chosen[force.inputs] if self.chosen else [0.0] * len(force.shape.inputs)
            keys = force.shape.keys([*numbers[force.numbers], *chosen])
            out.append(force.shape.kind.soft_row(row, **keys))
        return out

    def _lines(self, tips: Sequence[loops.Tip]) -> dict[ClosingRow, loops.LineState]:
        """The lines whose lengths are among the rows."""
        return {
            one.closing: self._line(one.force, tips)
            for one in self.chain.compliant
            if isinstance(one.closing.row, Length)
        }

    def _line(self, force: PlacedForce, tips: Sequence[loops.Tip]) -> loops.LineState:
        a, b = (self._end(force, i, tips) for i in force.ends)
        found = self.apply(force.tips[-1], -1, span(), {"d": list(b.r - a.r), "rate": list(b.v - a.v)})
        n, gamma = mx.array(found["n"]), found["gamma"][0]
        wrenches: dict[int, Array] = {}
        for i, sign in zip(force.ends, (-1.0, 1.0), strict=True):
            if i is None:  # accelerations here are less free fall, so a point at rest in the world has that of -gravity
                gamma = gamma - sign * mx.dot(n, mx.array(list(self.world[:3])))
            else:
                wrenches[i] = np.concatenate([mx.zeros(3), sign * n])
        return loops.LineState(found["length"][0], wrenches, gamma)


@cache
def span() -> Program:
    """``(d, rate) -> (length, n, gamma)``: of the way d between two points, its direction n, γ of its length."""
    tracer = Tracer()
    d, rate = (mx.array(tracer.input(name, 3)) for name in ("d", "rate"))
    length = tracer.call("sqrt", mx.dot(d, d) + SHORTEST)
    n = mx.array([x / length for x in d])
    gamma = (mx.dot(rate, rate) - mx.dot(n, rate) * mx.dot(n, rate)) / length
    return tracer.program("span", {"d": 3, "rate": 3}, {"length": [length], "n": list(n), "gamma": [gamma]})


OF_ALL = ("h", "ahead")
"""The inputs that all rows share."""


@cache
def solver(rigid: int, soft: int, shared: bool, settled: bool = False, ropes: tuple[int, ...] = ()) -> Program:
    """``(A, gddot, now, start, gamma, k, c, h, ahead) -> (nu)``: what the soft rows, the last, bear besides.

    ``A`` (rows, rows), its upper triangle row by row: the accelerations of the gaps by unit forces of the rows;
    ``gddot`` (rows,): those without the rigid rows, and with the forces ``-now`` of soft ones, ``gamma`` (soft,) those
    without accelerations of coordinates; ``start`` (2 soft,): gaps and rates at the start; the rest as above.
    ``shared``: rigid rows share what they bear, as in :func:`.loops.sharing_solver`. ``ropes``: the soft rows that
    never push, of which ``stretch`` has the gaps at the stage; one that would have to is left out, and the others are
    solved for again.

    Unknowns are divided by the roots of S, so that the matrix has no large entries, whatever the stiffness.
    """
    tracer, count = Tracer(), rigid + soft
    sizes = {"A": count * (count + 1) // 2, "gddot": count, "now": soft, "start": 2 * soft, "gamma": soft}
    sizes |= {"k": soft, "c": soft, "h": 1, "ahead": 1} | ({"stretch": len(ropes)} if ropes else {})
    x = {name: mx.array(tracer.input(name, size), (size,)) for name, size in sizes.items()}
    A = mx.unpack(x["A"], count)
    x |= dict(zip(("gap", "rate"), np.split(x["start"], 2), strict=True)) | {n: np.repeat(x[n], soft) for n in OF_ALL}
    own = ({name: x[name][i] for name in ("k", "c", "now", "gamma", "gap", "rate", *OF_ALL)} for i in range(soft))
    law, rows = _settled if settled else _law, list(own)
    for k, stretch in zip(ropes, x.get("stretch", ()), strict=True):
        rows[k]["now"] = tracer.call("on", stretch) * tracer.call("on", rows[k]["now"]) * rows[k]["now"]
    laws = [law(tracer, A[rigid + i, rigid + i], row) for i, row in enumerate(rows)]
    for k in ropes:
        taut = _taut(tracer, A[rigid + k, rigid + k], rows[k], x["gddot"][rigid + k])
        root, f = laws[k]
        laws[k] = (taut * root, taut * f + (1.0 - taut) * rows[k]["now"] if settled else taut * f)

    def borne(laws: list[tuple[Value, Value]]) -> Array:
        root, less = [r for r, _ in laws], mx.array([row["now"] - f for row, (_, f) in zip(rows, laws, strict=True)])
        scale = mx.array([*[1.0] * rigid, *root], (count,))
        b = -scale * (x["gddot"] + mx.multiply(A[:, rigid:], less))
        scaled = mx.symmetric(count, lambda i, j: scale[i] * A[i, j] * scale[j])
        firm = scaled + mx.diagonal([*[0.0] * rigid, *[1.0] * soft])
        found = _shared(firm, b, rigid) if shared else mx.solve(mx.factorise(firm, tracer, _least(tracer, A, rigid)), b)
        return less + mx.array(root, (soft,)) * found[rigid:]

    nu = borne(laws)
    if ropes:
        pulls = {k: tracer.call("on", rows[k]["now"] - nu[k]) for k in ropes}
        nu = borne([(pulls[k] * r, pulls[k] * f) if k in pulls else (r, f) for k, (r, f) in enumerate(laws)])
    return tracer.program("compliant_rows", sizes, {"nu": list(nu)})


FIRM = 100.0
"""So many times as much as the step itself a report attends to a row that settles within it, over its gap and rate."""


def _settled(tracer: Tracer, A: Value, x: dict[str, Value]) -> tuple[Value, Value]:
    """The same of a row as runs report it: S is small where the step resolves it, and f the present force."""
    firm = x["h"] * (x["c"] + x["h"] * x["k"])
    z = firm * A
    cube = z * z * z
    return tracer.call("sqrt", firm * (cube / (1.0 + cube / FIRM))), x["now"]


def _law(tracer: Tracer, A: Value, x: dict[str, Value]) -> tuple[Value, Value]:
    """The root of S and f of a row, whose own entry is A."""
    S, moved, _ = _later(A, x)
    return tracer.call("sqrt", S), x["k"] * (x["gap"] + moved) + x["c"] * x["rate"]


def _later(A: Value, x: dict[str, Value]) -> tuple[Value, Value, Value]:
    """S of a row, by how much its gap moves without acceleration, and by how much with each unit of it."""
    k, c, h = x["k"], x["c"], x["h"]
    late = [x["ahead"] * z / (1.0 + z) for z in (h * h * k * A, h * c * A)]
    S = h * (c * (1.0 + late[1]) + h * k * (1.0 + 3.0 * late[0]))
    moved = h * (1.0 + 2.0 * late[0]) * x["rate"] - 0.5 * h * h * (1.0 - late[0]) * x["gamma"]
    return S, moved, h * h * (1.0 + 3.0 * late[0])


def _taut(tracer: Tracer, A: Value, x: dict[str, Value], gddot: Value) -> Value:
    """1 of a rope that without its own pull would be stretched at the end of the step, and would pull there; else 0."""
    S, moved, reach = _later(A, x)
    free, gap = gddot + A * x["now"], x["gap"] + moved
    pull = x["k"] * gap + x["c"] * x["rate"] + S * free
    return tracer.call("on", gap + reach * free) * tracer.call("on", pull)


def _shared(firm: Array, b: Array, rigid: int) -> Array:
    """The solution where rigid rows, the first, share what they bear."""
    whole = sum((firm[k, k] for k in range(1, rigid)), firm[0, 0])
    own = [loops.COMPLIANCE * (firm[k, k] + loops.LEAST * whole) if k < rigid else 0.0 for k in range(len(b))]
    factor, x, rest = mx.factorise(firm + mx.diagonal(own)), mx.zeros(len(b)), b
    for _ in range(loops.SHARES):
        x = x + mx.solve(factor, rest)
        rest = b - mx.multiply(firm, x)
    return x


def _least(tracer: Tracer, A: Array, rigid: int) -> Value:
    """What every pivot must exceed: the rounding errors of those of rigid rows."""
    if not rigid:
        return 0.0
    return tracer.epsilon() * 64.0 * sum((A[k, k] for k in range(1, rigid)), A[0, 0])
