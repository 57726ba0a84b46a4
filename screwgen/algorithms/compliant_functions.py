"""Loops whose joints give way, over an implicit step: the wrenches on tips that make their rows those of its end.

A row with the gap g, stiffness k and damping c bears ``-(k g + c gdot)``; as a force between frames it acts on the tree
like all others, at the state of a stage. Where that is too stiff for the step, an implicit method takes it ``h`` after
the start, where g and gdot are known. Its acceleration is ``gddot = J a + gamma``, with the unit wrenches J of the row
and the accelerations a, so

    force = -f - S gddot,    f = k (g + h gdot - h² gamma/2) + c gdot,    S = h (c + h k).

The gap itself moves by ``h² (J a + gamma/2)``, hence the last term of k. What the row bears beside the force at the
stage, nu, follows from ``(J M⁻¹ Jᵀ + 1/S) nu = …`` together with the rows of rigid loops, and acts as an external
wrench. Without bound of k that is the row of a rigid loop; S = 0 leaves the force as it is.

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
from ..ir.program import Array, Program, Tracer, Value
from ..joints.compliant import of_row
from ..topology.chain import Chain
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
    braked: Callable[[Sequence], Any]
    loop_state: Callable[..., loops.LoopState]
    _answers: Callable[..., tuple[Array, list]]

    def row_terms(self, q: Sequence, v: Sequence) -> list[Value]:
        """The gap of every row, then its rate."""
        rows = self.loop_state(q, v, [one.closing for one in self.chain.compliant]).rows
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
        state = self.loop_state(q, v, [*closing, *(one.closing for one in soft)])
        given = loops.Loads(tau, self.under_inputs(tau).with_forces(q, v, w_ext))
        links, places = self.forward(q, v, *given)
        moved, drifts = state.accelerations(links, places), state.drifts(places)[len(closing) :]
        A, _ = self.braked(tau)._answers(q, state, self.given[0] if self.given else None)
        own, numbers = state.rows[len(closing) :], self.stiffness_and_damping()
        inputs = {
            "A": mx.pack(A),
            "gddot": [x.power(moved) + x.drift for x in state.rows],
            "now": [k * x.gap + c * x.rate for x, (k, c) in zip(own, numbers, strict=True)],
            "start": list(terms),
            "gamma": drifts,
            "k": [k for k, _ in numbers],
            "c": [c for _, c in numbers],
            "h": [h],
            "ahead": [ahead],
        }
        program = solver(len(closing), len(soft), self.chain.closing.overconstrained, settled)
        try:
            found = self.apply(soft[-1].closing.second, 0, program, inputs)["nu"]
        except SingularError:
            raise self.chain.singular_loops() from None
        added = state.wrenches([*[0.0] * len(closing), *found])
        return [a + b for a, b in zip(w_ext, added, strict=True)]

    def stiffness_and_damping(self) -> list[tuple[Value, Value]]:
        """Stiffness and damping of every row."""
        numbers = self.world[3:]
        laws = [(one.closing.row, one.force.shape.keys(numbers[one.force.numbers])) for one in self.chain.compliant]
        return [of_row(row, keys) for row, keys in laws]


OF_ALL = ("h", "ahead")
"""The inputs that all rows share."""


@cache
def solver(rigid: int, soft: int, shared: bool, settled: bool = False) -> Program:
    """``(A, gddot, now, start, gamma, k, c, h, ahead) -> (nu)``: what the soft rows, the last, bear besides.

    ``A`` (rows, rows), its upper triangle row by row: the accelerations of the gaps by unit forces of the rows;
    ``gddot`` (rows,): those without the rigid rows, and with the forces ``-now`` of soft ones, ``gamma`` (soft,) those
    without accelerations of coordinates; ``start`` (2 soft,): gaps and rates at the start; the rest as above.
    ``shared``: rigid rows share what they bear, as in :func:`.loops.sharing_solver`.

    Unknowns are divided by the roots of S, so that the matrix has no large entries, whatever the stiffness.
    """
    tracer, count = Tracer(), rigid + soft
    sizes = {"A": count * (count + 1) // 2, "gddot": count, "now": soft, "start": 2 * soft, "gamma": soft}
    sizes |= {"k": soft, "c": soft, "h": 1, "ahead": 1}
    x = {name: mx.array(tracer.input(name, size), (size,)) for name, size in sizes.items()}
    A = mx.unpack(x["A"], count)
    x |= dict(zip(("gap", "rate"), np.split(x["start"], 2), strict=True)) | {n: np.repeat(x[n], soft) for n in OF_ALL}
    own = ({name: x[name][i] for name in ("k", "c", "now", "gamma", "gap", "rate", *OF_ALL)} for i in range(soft))
    law = _settled if settled else _law
    laws = [law(tracer, A[rigid + i, rigid + i], row) for i, row in enumerate(own)]
    root, less = [r for r, _ in laws], mx.array([now - f for now, (_, f) in zip(x["now"], laws, strict=True)], (soft,))
    scale = mx.array([*[1.0] * rigid, *root], (count,))
    b = -scale * (x["gddot"] + mx.multiply(A[:, rigid:], less))
    scaled = mx.symmetric(count, lambda i, j: scale[i] * A[i, j] * scale[j])
    firm = scaled + mx.diagonal([*[0.0] * rigid, *[1.0] * soft])
    found = _shared(firm, b, rigid) if shared else mx.solve(mx.factorise(firm, tracer, _least(tracer, A, rigid)), b)
    nu = less + mx.array(root, (soft,)) * found[rigid:]
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
    k, c, h = x["k"], x["c"], x["h"]
    late = [x["ahead"] * z / (1.0 + z) for z in (h * h * k * A, h * c * A)]
    S = h * (c * (1.0 + late[1]) + h * k * (1.0 + 3.0 * late[0]))
    moved = h * (1.0 + 2.0 * late[0]) * x["rate"] - 0.5 * h * h * (1.0 - late[0]) * x["gamma"]
    return tracer.call("sqrt", S), k * (x["gap"] + moved) + c * x["rate"]


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
