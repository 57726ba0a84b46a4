"""The estimator of the C back end: an extended Kalman filter on the generated dynamics and their derivatives.

What it measures are rows of :mod:`...algorithms.measurements`: of each the program of its innovation and derivatives.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ...algorithms.joint_moves import midpoint_carry
from ...algorithms.measurement import Comparison, Measurement, SensorNumber, comparison
from ...ir.program import Tracer
from ...joints.kind import JointKind
from ...spec.parameters import parameters
from ...topology.chain import Chain
from . import parameter_states
from . import parameters as structs
from .by_p import ParameterDerivatives
from .code import Place, Writer, entries, literal, singular, trimmed, with_unused
from .curved import stem
from .derivatives import say_time
from .pieces import KEPT, bodies, piece_place
from .routines import Routines
from .stumpff_slopes import slopes

FILES = ("estimator.h", "estimator.c")
"""The files that an estimator adds, without the robot's name; their templates have the same names."""

PATIENCE = 20
"""How often in a row a gate refuses an entry of a measurement unless one states it."""
POINTERS = ("c", "e", "state", "input", "measured", "work")
"""The arguments of the functions that compare a measurement with a state."""


def content(chain: Chain, rows: Sequence[Measurement], baked: bool, place: Place, by_p: ParameterDerivatives) -> dict:
    """The templates' context; ``place`` is that of the fused function, ``by_p``: whether parameters are states."""
    constants, states = "baked" if baked else "constants", parameter_states.count(by_p)
    further = lambda row: parameter_states.further(chain, by_p, row)  # noqa: E731
    found = {row.name: comparison(row, chain, constants, further(row)) for row in rows if row.size(chain)}
    programs = [one.program for one in found.values()]
    half = chain.nvz + states / 2
    say_time(chain, "measurements", sum(program.operation_count for program in programs))
    routines = Routines(programs)
    measured = [_row(row, chain, found.get(row.name), routines, place) for row in rows]
    numbers = [_number(number, chain, baked, states > 0) for row in rows for number in row.numbers]
    return {
        "rows": measured,
        "numbers": numbers,
        "begun": any(row["noise"] for row in measured) or any(number["said"] for number in numbers),
        "states": parameter_states.content(chain, by_p) if states else None,
        "closed": bool(chain.closing.rows),
        "routines": routines.functions,
        "slopes_of_stumpff": slopes(programs),
        "switches": any("on" in program.operations for program in programs),
        "kept": max((row["kept"] for row in measured), default=1),
        "longest": {
            "rest": max((row["n"] for row in measured), default=0),
            "rows": max(chain.n_changes + states, *(sum(size for _, size in row["spans"]) for row in measured), 1),
            "by_vdot": chain.nvz * max((row["n"] for row in measured if row["accelerates"]), default=0),
        },
        "accelerates": any(row["accelerates"] for row in measured),
        "attitudes": any(row["readings"] > 1 and row["n"] for row in measured),
        "per_prediction": round(11 * half**3) + 24 * len(chain.closing.rows) * chain.nv**2,
        "per_update": round(3 * half**3),
        "per_entry": round(4 * half**2),
        "rates": "$$_NVZ" if chain.n_internal else "NQ",
        "n_changes": _n_changes(chain) + " + $$_NBY_P" * (states > 0),
        "patience": PATIENCE,
        "square": lambda name, at: " + ".join(f"{name}[{k}] * {name}[{k}]" for k in range(at, at + 4)),
    } | _curved(chain)


def _n_changes(chain: Chain) -> str:
    return f"{chain.nv} + {chain.nvz}" if chain.n_internal else f"2 * {chain.nv}"


def _row(row: Measurement, chain: Chain, found: Comparison | None, routines: Routines, place: Place) -> dict:
    """A measurement, as the templates print it."""
    n, made = row.size(chain), {"pieces": [], "kept": 1, "operations": 0}
    if found:
        own = {"rest": entries("work->rest"), "rows": entries("work->H"), "by_vdot": entries("work->by_vdot")}
        own |= {"measured": entries("measured"), "vdot": entries("work->derivatives.vdot")}
        own |= {number.keyword: entries(f"e->{number.name}") for number in row.numbers}
        own |= {"slope": entries("e->slopes.slope")}
        placed = piece_place(chain, "work->kept", own, place)
        writer = lambda piece: Writer(piece, placed, singular, {*POINTERS, KEPT}, apart=True)  # noqa: E731
        made = bodies(writer, routines.calling(found.program), POINTERS)
    return made | {
        **{name: getattr(row, name) for name in ("name", "about", "unit", "group", "readings", "count", "gated")},
        "n": n,
        "size": f"$$_LENGTH($$_{row.count})" if row.count else max(n, 1),
        "n_flags": n // row.group,
        "n_values": row.n_values(chain),
        "variance": {"1": "dimensionless", "m": "m^2", "rad": "rad^2"}.get(row.unit, f"({row.unit})^2"),
        "labels": row.labels(chain),
        "spans": found.spans if found else [],
        "accelerates": found is not None and "by_vdot" in found.program.outputs,
        "noise": literal(row.noise**2) if row.noise and n else "",
        "said": f"{row.noise**2:.6g}",
        "not_zero": [number.name for number in row.numbers if number.zero],
        "gate": f"(e->{row.name}_gate > 0 ? e->{row.name}_gate : e->gate)" if row.gated else "e->gate",
    }


def _number(number: SensorNumber, chain: Chain, baked: bool, again: bool) -> dict:
    """Numbers of a sensor, and the lines that set what they start at; ``again``: what is derived has a function."""
    size, to = number.size(chain), entries(f"e->{number.name}")
    lines, own = _derived(number, chain, baked, f"e->{number.name}") if callable(number.start) else [], []
    said = ""
    if lines and again:
        lines, own = [f"set_{number.name}(p, e->{number.name});"], _derived(number, chain, baked, number.name)
    if number.start and not callable(number.start):
        lines = [f"{to(k)} = {literal(x)};" for k, x in enumerate(number.starts(chain))]
        said = "" if number.start == 1.0 else ", ".join(f"{x:.6g}" for x in number.own_starts)
    made = {"lines": lines, "derived": callable(number.start), "function": own, "said": said}
    return {"name": number.name, "about": number.about, "size": size, **made}


def _derived(number: SensorNumber, chain: Chain, baked: bool, to: str) -> list[str]:
    """The lines that set numbers, the array ``to``, as they follow from the robot's parameters ``p``."""
    assert callable(number.start)
    own, tracer = parameters(chain.robot), Tracer()
    p: list[Any] = [x.value for x in own] if baked else tracer.input("p", len(own))
    program = tracer.program(number.name, {"p": len(own)}, {"out": list(number.start(chain, p))})
    places = {"p": lambda k: f"p->{structs.place(own[k])}", "out": entries(to)}
    return trimmed(Writer(program, lambda name, k: places[name](k)).lines())


def _curved(chain: Chain) -> dict[str, object]:
    """How changes of joints whose coordinates do not add up are carried over a step."""
    widest = max((part.joint.nv for part in chain.curved), default=0)
    balls = [part for part in chain.curved if not part.joint.in_space]
    posed = (
        "the base's pose" if not balls else "ball joints" if len(balls) == len(chain.curved) else "base and ball joints"
    )
    return {
        "posed": posed,
        "Posed": posed[0].upper() + posed[1:],
        "widest": widest,
        "carries": [_carry(joint, widest) for joint in dict.fromkeys(part.joint for part in chain.curved)],
    }


def _carry(joint: JointKind, widest: int) -> dict[str, object]:
    """The function that finds how changes of a kind's coordinates are carried over a step."""
    program, n = midpoint_carry(joint), joint.nv
    own = lambda name, k: f"u[{k}]" if name == "u" else f"E[{k // n}][{k % n}]"  # noqa: E731
    lines = with_unused(("u",), trimmed(Writer(program, own, None, {"u", "E"}).lines()))
    said = f"A {joint.name} joint: E of the change u that its rates make in half a step."
    return {"stem": stem(joint), "nv": n, "said": said, "lines": lines}
