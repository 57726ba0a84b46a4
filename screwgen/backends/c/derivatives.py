"""The derivatives of the C back end: one straight-line program, cut into functions, and a small dense solver."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence

from ...algorithms import fused
from ...algorithms.linearisation import linearisation
from ...algorithms.wrench_slopes import wrench_program
from ...errors import TargetWarning
from ...integrators.method import Method
from ...topology.chain import Chain
from . import acting, brakes, compliant, inertia_solve, recursive_slopes, step_derivatives
from .code import Place, entries, singular
from .pieces import piece_place, pieces
from .stumpff_slopes import slopes
from .written import once

FILES = ("derivatives.h", "derivatives.c", "wrench_derivatives.c")
"""The files that derivatives add, without the robot's name; their templates have the same names."""

RATE = 1_500
"""The operations that gcc -O2 compiles in a second of a busy processor; functions are of bounded length."""

LIMIT = 45_000
"""The operations, worth half a minute, above which the time is said."""

UNROLLED = 16
"""Up to this many coordinates the solver is written out: values in registers, two to three times as fast as loops."""


def content(
    chain: Chain, baked: Sequence[dict] | None, place: Place, methods: Mapping[str, Method], layout: str
) -> dict:
    """The templates' context; ``place`` is that of the fused function, ``methods`` the integrators to differentiate.

    ``layout`` is the one that is asked for.
    """
    recursion = once(_recursion, chain, baked is not None) if recursive_slopes.is_chosen(chain, layout) else None
    solving = recursion["solving"] if recursion else None
    solve = solving["solve"] if solving else inertia_solve.dense(chain)
    acts = once(acting.content, chain, baked is not None, place) if recursion else None
    made = _by_recursion(recursion, acts) if recursion else _in_pieces(chain, baked is not None, place)
    later = compliant.slopes(chain, baked is not None, place)
    per_stage = made["operations"] + solve
    made |= step_derivatives.content(chain, methods, per_stage, later["count"] if later else per_stage)
    if later:
        made["programs"] = [*made["programs"], later["program"]]
    return made | {
        "compliant": later,
        "recursion": recursion,
        "solving": solving,
        "acting": acts,
        "solve": solve,
        "rows": len(chain.closing.rows),
        "stumpff": slopes(made["programs"], bool(chain.curved)),
        "unrolled": UNROLLED,
        "link_of": _owners(chain),
        "wrenches": _wrenches_by_recursion(chain, baked, place)
        if recursion
        else _wrenches(chain, baked is not None, place),
    }


def _recursion(chain: Chain, baked: bool) -> dict:
    """The slopes where links have functions of their own."""
    return recursive_slopes.content(chain, once(fused.baked, chain) if baked else None)


def _by_recursion(recursion: Mapping, acts: Mapping | None) -> dict:
    """Programs and operations of the slopes where links have functions of their own."""
    found = [{"programs": recursion["distinct"], "operations": recursion["operations"]}, *([acts] if acts else [])]
    programs = [program for one in found for program in one["programs"]]
    return {"programs": programs, "operations": sum(one["operations"] for one in found)}


def _in_pieces(chain: Chain, baked: bool, place: Place) -> dict:
    """The slopes as one program in pieces."""
    made = once(_pieces, chain, baked, place)
    say_time(chain, "derivatives", made["operations"])
    return dict(made)


def _pieces(chain: Chain, baked: bool, place: Place) -> dict:
    program = linearisation(chain, "baked" if baked else "constants", own=False)
    nv = chain.nv
    own = {
        "vdot": entries("out->vdot"),
        "m_eta": entries("work->m_eta"),
        "M": lambda k: "work->M[{}][{}]".format(*_triangle(k)),
        "f_q": entries("out->vdot_q", nv),
        "f_v": entries("out->vdot_v", nv),
        "exerted": entries("work->exerted", nv),
        "f_z": entries("work->by_state", nv),
    }
    own |= brakes.rows(chain)
    of_rows = {"J": "J", "J_q": "rows.q", "J_v": "rows.v"}
    own |= {"row": entries("out->row"), "wanted": entries("out->wanted")}
    own |= {name: entries(f"work->{to}", nv) for name, to in of_rows.items()}
    placed = piece_place(chain, "work->kept", own, place)
    made = pieces(program, placed, ("c", "state", "input", "work", "out"), fail=singular, outline=True)
    return made | {"programs": [program]}


def _wrenches_by_recursion(chain: Chain, baked: Sequence[dict] | None, place: Place) -> dict:
    """The derivatives of joint wrenches where links have functions of their own."""
    found = recursive_slopes.wrenches(chain, baked)
    units = acting.units(chain, baked is not None, place)
    programs, count = [*found["distinct"], *(units["programs"] if units else [])], units["operations"] if units else 0
    own = {"operations": found["operations"] + count, "product": _products_of_wrenches(chain)}
    return own | {"recursion": found, "units": units, "stumpff": slopes(programs)}


def _products_of_wrenches(chain: Chain) -> int:
    """The operations of the products with the derivatives of accelerations."""
    return 12 * chain.n * (chain.nv + len(chain.closing.rows)) * (2 * chain.nv + chain.n_tau)


def _wrenches(chain: Chain, baked: bool, place: Place) -> dict:
    """The same of the joint wrenches."""
    made = once(_wrench_pieces, chain, baked, place)
    say_time(chain, "derivatives of wrenches", made["operations"])
    return made | {"recursion": None, "product": _products_of_wrenches(chain)}


def _wrench_pieces(chain: Chain, baked: bool, place: Place) -> dict:
    program, nv = wrench_program(chain, "baked" if baked else "constants"), chain.nv
    own = {
        "vdot": entries("at->vdot"),
        "wrench": entries("out->wrench", 6),
        "wrench_vdot": entries("work->by_vdot", nv),
        "wrench_q": entries("out->wrench_q", 6, nv),
        "wrench_v": entries("out->wrench_v", 6, nv),
        "wrench_input": entries("work->by_input", 6 * chain.n),
        "wrench_state": entries("work->by_state", 6 * chain.n),
        "row": entries("at->row"),
        "wanted": entries("at->wanted"),
        "m_eta": entries("at->m_eta"),
        "wrench_row": entries("work->by_row", len(chain.closing.rows)),
        "row_share": entries("work->share", nv),
    }
    placed = piece_place(chain, "work->kept", own, place)
    made = pieces(program, placed, ("c", "state", "input", "at", "work", "out"), outline=True)
    return made | {"stumpff": slopes([program])}


def say_time(chain: Chain, what: str, count: int) -> None:
    """A :class:`TargetWarning` where so many operations take long to compile."""
    if count > LIMIT:
        said = f"robot '{chain.robot.name}': its {what} in C have {count} operations"
        said = f"{said}, over which gcc takes about {count / RATE:.0f} s at -O2 and a twentieth of that at -O0"
        warnings.warn(said, TargetWarning, stacklevel=2)


def _triangle(k: int) -> tuple[int, int]:
    """Row and column of entry k of a lower triangle, row by row."""
    i = 0
    while (i + 1) * (i + 2) // 2 <= k:
        i += 1
    return i, k - i * (i + 1) // 2


def _owners(chain: Chain) -> list[int]:
    """The link of every rate."""
    parts = (lambda key: key.joints, lambda key: len(key.added_axes), lambda key: key.modes)
    return [i for count in parts for i, key in enumerate(chain.keys) for _ in range(count(key))] or [0]
