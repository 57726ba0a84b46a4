"""Programs of what acts on tips, for slopes by recursion: how its wrenches change, whatever carries the tips.

An example: a spring between two tips. Its wrenches are functions of the poses and twists of both, so what they change
is two matrices (12, 12). How the tips move with each coordinate, the recursion knows.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from ..ir.program import Array, Program, Value
from ..joints.constraints import Ratio
from ..topology.chain import Chain
from . import matrices as mx
from .force_functions import acting_tips
from .functions import Functions
from .fused import Outputs, fuse, inputs
from .loop_slopes import coupling_changes, row_maps
from .loop_slopes import tips as loop_tips
from .loops import LoopState

OF_ROWS = ("units", "by_pose", "by_twist")
"""What every row of a loop has, (12,) each: see :func:`.slopes_of_rows`."""


def tips_acted_on(chain: Chain) -> list[int]:
    """The segments on whose tips loops or forces act."""
    return list(dict.fromkeys((*loop_tips(chain), *acting_tips(chain))))


def ends(chain: Chain) -> list[tuple[int, ...]]:
    """The segments at whose tips each of the maps ends: of loops first, then of :meth:`.force_maps`."""
    loops = {c.loop: (c.first, c.second) for k in row_numbers(chain) for c in (chain.closing.rows[k],)}
    turned = [(i,) for i in chain.turned_wrenches]
    return [*loops.values(), *turned, *(tuple(force.tips) for force in chain.forces)]


def row_numbers(chain: Chain) -> list[int]:
    """The rows of loops but couplings, loop by loop."""
    tips = [(k, c) for k, c in enumerate(chain.closing.rows) if k not in coupled(chain)]
    return [k for loop in dict.fromkeys(c.loop for _, c in tips) for k, c in tips if c.loop == loop]


def coupled(chain: Chain) -> list[int]:
    """The rows of couplings."""
    return [k for k, c in enumerate(chain.closing.rows) if isinstance(c.row, Ratio)]


def acting_maps(chain: Chain, constants: str = "constants") -> Program:
    """``(q, v, tau, w_ext) -> (by_pose, by_twist, twist)``: the matrices of all that acts, one behind the other, and
    the twists of the :func:`tips_acted_on`, each in its own axes.

    With other inputs than torques also ``exerted``, with states of forces ``f_z``, as :func:`.linearisation` has them.
    Where loops close the tree ``m_eta`` and ``f_eta`` are given too; also ``vdot``, the wrenches ``acted`` on all tips,
    the forces ``row`` of all rows, ``row_units``, ``row_by_pose``, ``row_by_twist`` (12,) of each of the
    :func:`row_numbers`, and of couplings their rows ``coupling_J``, ``coupling_J_q``, ``coupling_J_v`` (nv,) and the
    diagonal ``coupling_bend`` (nv,) of what they change in f.
    """

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Outputs:
        q, v, tau, w_ext = (x[name] for name in ("q", "v", "tau", "w_ext"))
        out: dict = {}
        if chain.closing.rows:
            f.given = (x["m_eta"], x["f_eta"])
            f = f.under_inputs(tau)
            vdot, loads, shut, forces, accelerating = f.closed_motion(q, v, tau, w_ext)
            acc = accelerating()
            found = [found for *_, found in row_maps(chain, shut, acc.tips, forces, f.apply)]
            out |= {"vdot": vdot, "acted": loads.w_ext, "row": list(forces)}
            out |= {f"row_{name}": [y for one in found for y in one[name].flat] for name in OF_ROWS if found}
            _, (J, J_q, J_v), bend = coupling_changes(chain, shut, acc.axes, forces, f.apply)
            if J.size:
                couplings = {"coupling_J": J, "coupling_J_q": J_q, "coupling_J_v": J_v}
                out |= {name: list(rows.flat) for name, rows in couplings.items()}
                out["coupling_bend"] = [bend[k, k] for k in range(chain.nv)]
            maps = [(one["bend"], mx.zeros(12, 12)) for one in found]
        else:
            f, maps = f.under_inputs(tau), []
        return out | _maps(f, q, v, w_ext, maps) | _given(f, q, v, tau)

    return fuse(
        chain,
        "acting_maps",
        inputs(chain, "q v tau w_ext" + " m_eta f_eta" * bool(chain.closing.rows)),
        body,
        constants,
    )


def held_maps(chain: Chain, constants: str = "constants") -> Program:
    """``(q, v, tau, w_ext, row) -> (by_pose, by_twist, twist, acted)``: the same at given forces of the loops' rows."""

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Outputs:
        q, v, tau, w_ext, forces = (x[name] for name in ("q", "v", "tau", "w_ext", "row"))
        f = f.under_inputs(tau)
        shut: LoopState = f.loop_state(q, v)
        still = [mx.zeros(6)] * chain.n
        maps = [(found["bend"], mx.zeros(12, 12)) for *_, found in row_maps(chain, shut, still, forces, f.apply)]
        acted = [a + b for a, b in zip(f.with_forces(q, v, w_ext), shut.wrenches(forces), strict=True)]
        return _maps(f, q, v, w_ext, maps) | {"acted": acted}

    return fuse(chain, "held_maps", inputs(chain, "q v tau w_ext") | {"row": len(chain.closing.rows)}, body, constants)


def _maps(f: Functions, q: Sequence, v: Sequence, w_ext: Sequence, first: Sequence[tuple[Array, Array]]) -> dict:
    """Maps one behind the other, ``first`` and those of forces, and the twists of all tips acted on."""
    maps = [*first, *((found[1], found[2]) for found in (f.force_maps(q, v, w_ext) if f.acts else ()))]
    if not maps:
        return {}
    by_pose, by_twist = ([x for matrices in maps for x in matrices[k].flat] for k in range(2))
    return {"by_pose": by_pose, "by_twist": by_twist, "twist": f.tip_twists(q, v, tips_acted_on(f.chain))}


def _given(f: Functions, q: Sequence, v: Sequence, tau: Sequence) -> dict[str, list[Value]]:
    """What inputs besides torques exert, and what the generalised forces change with states of forces."""
    exerted = f.exerted(q, v, tau) if f.chain.other_inputs else []
    by_states = f.exerted_by_states(q, v) if f.chain.n_force_states else []
    made = {"exerted": exerted, "f_z": by_states}
    return {name: [x for force in forces for x in force] for name, forces in made.items() if forces}


def wrenches_per_unit(chain: Chain, constants: str = "constants") -> Program:
    """``(q, v, tau) -> (wrench_input, wrench_state, wrench_row)``, as :func:`.wrench_program` has them, where there are
    any."""

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Outputs:
        q, v, tau = x["q"], x["v"], x["tau"]
        out: dict = {}
        if chain.inputs_load_links:
            out["wrench_input"] = _flat(f.wrenches_of_inputs(q, v, tau))
        if chain.n_force_states:
            out["wrench_state"] = _flat(f.wrenches_of_states(q, v, tau))
        if chain.closing.rows:
            f = f.under_inputs(tau)
            shut = f.loop_state(q, v)
            out["wrench_row"] = list(mx.array(f.felt(q, map(shut.wrenches, shut.units()))).T.flat)
        return out

    found = fuse(chain, "wrenches_per_unit", inputs(chain, "q v tau"), body, constants)
    return replace(found, guards=[], origins=[])  # of a state at which they were found to hold


def _flat(rows: Sequence[Sequence]) -> list[Value]:
    return [x for row in rows for x in row]
