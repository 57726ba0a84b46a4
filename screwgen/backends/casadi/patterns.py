"""Sparsity patterns of the CasADi functions' Jacobians: the tables of ``casadi/README.md``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import casadi as ca

from ...spec.base import POSE, TWIST
from ...spec.parameters import coordinate_names, per_added, per_base
from ...spec.robot import Robot
from ...spec.segments import segments

Groups = dict[str, list[int]]
"""Names of parts of a column and the places of their entries."""


def jacobians(functions: Mapping[str, ca.Function]) -> list[dict[str, Any]]:
    """For every function and output, ``{"function", "output", "inputs"}``: nonzeros of its Jacobian by input."""
    return [
        {
            "function": name,
            "output": f.name_out(o),
            "inputs": {f.name_in(i): _count(f.jac_sparsity(o, i)) for i in range(f.n_in())},
        }
        for name, f in functions.items()
        for o in range(f.n_out())
    ]


def _count(pattern: ca.Sparsity) -> str:
    """``0``, ``all 81``, ``77 of 369`` or, of a diagonal, ``9 of 81, diagonal``."""
    if pattern.nnz() == 0:
        return "0"
    if pattern.is_dense():
        return f"all {pattern.nnz()}"
    diagonal = pattern.is_square() and pattern == ca.Sparsity.diag(pattern.size1())
    return f"{pattern.nnz()} of {pattern.numel()}{', diagonal' if diagonal else ''}"


def structures(robot: Robot, functions: Mapping[str, ca.Function]) -> list[dict[str, Any]]:
    """``ode`` and ``dae``, where given, by the parts of their inputs and outputs: ``{"function", "columns", "rows"}``.

    A row holds the name of the part of the right-hand side and the nonzeros of its Jacobian, column by column.
    """
    names = coordinate_names(robot)
    n, m, t = len(segments(robot)), len(names.tau), len(per_added(robot))
    q, v = len(names.q), len(names.v)
    r = v - m - t - len(per_base(robot, TWIST))
    redundant = q - t - r - len(per_base(robot, POSE))
    forces = {"u": _stacked({"`tau`": m, "`w_ext`": 6 * n})}
    state = {"x": _stacked({"`q`": q, "`v`": v})}
    ode_rows = {"ode": _stacked({"dq/dt": q, "dv/dt": v})}
    inner, rates_of_inner = {"rotors' angles": t, "`eta`": r}, {"rotors' rates": t, "dη/dt": r}
    pose = {"poses": 7 * n, **inner, "twists": 6 * n, **rates_of_inner, "`q`": redundant}
    dae_state = {"x": _stacked(pose), "z": _by_link(n, r, ("wrenches", "twists' rates", "d²η/dt²"))}
    rates = _stacked({f"rate of {name}": size for name, size in pose.items()})
    dae_rows = {"ode": rates, "alg": _by_link(n, r, ("rows of joints", "rows of links", "rows of modes"))}
    layouts = {"ode": (ode_rows, state | forces), "dae": (dae_rows, dae_state | forces)}
    return [_structure(name, functions[name], *layout) for name, layout in layouts.items() if name in functions]


def _stacked(sizes: Mapping[str, int]) -> Groups:
    """Parts one below the other; an empty part is left out."""
    groups, first = {}, 0
    for name, size in sizes.items():
        groups[name] = list(range(first, first + size))
        first += size
    return {name: places for name, places in groups.items() if places}


def _by_link(n: int, r: int, names: Sequence[str]) -> Groups:
    """The parts of z and of the rows of ``alg``: six and six for every link, then the modes."""
    firsts = {names[0]: 0, names[1]: 6}
    groups = {name: [12 * i + first + k for i in range(n) for k in range(6)] for name, first in firsts.items()}
    return groups | ({names[2]: list(range(12 * n, 12 * n + r))} if r else {})


def _structure(name: str, f: ca.Function, rows: Mapping[str, Groups], columns: Mapping[str, Groups]) -> dict[str, Any]:
    table = [
        [part, *(_part(f, output, input_, at, to) for input_, parts in columns.items() for to in parts.values())]
        for output, outputs in rows.items()
        for part, at in outputs.items()
    ]
    return {"function": name, "columns": [part for parts in columns.values() for part in parts], "rows": table}


def _part(f: ca.Function, output: str, input_: str, at: Sequence[int], to: Sequence[int]) -> str:
    whole = f.jac_sparsity(f.index_out(output), f.index_in(input_))
    return _count(whole.sub(at, to)[0])
