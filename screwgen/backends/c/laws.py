"""The laws of single coordinates in C: for each a loop over its coordinates, with the traced programs inside."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from ...algorithms.axis_laws import LawsOfRobot, of_robot
from ...algorithms.law_programs import STAGE, spring_slopes, spring_stage, stage, stage_slopes, state_rate, state_slopes
from ...elements import Key
from ...ir.program import Program
from ...topology.chain import Chain
from .batch import LaneWriter
from .code import Place, Writer, trimmed
from .parameters import ascii_unit

RESULTS = {
    "force": "f[i]",
    "inertia": "m[i]",
    "by_x": "by_q[i * ($$_NV + 1)]",
    "by_w": "by_v[i * ($$_NV + 1)]",
    "by_there": "by_there[i * ($$_NV + 1)]",
    "by_axis": "by_q[i * $$_NV + $$_NV - $$_NGIVEN + AXIS[k]]",
    "by_z": "by_v[i * $$_NVZ + $$_NV + STATE[k]]",
    "rate": "vdot[at]",
    "rate_x": "by_q[at * $$_NV + i]",
    "rate_w": "by_v[at * $$_NVZ + i]",
    "rate_axis": "by_q[at * $$_NV + $$_NV - $$_NGIVEN + AXIS[k]]",
    "rate_there": "by_there[at * $$_NVZ + i]",
    "rate_z": "by_v[at * $$_NVZ + at]",
    "rate_a": "follow[STATE[k]]",
}
"""Where the results are added."""
LOCAL = {name: name for name in (*STAGE, "z", "axis")} | {"h": "dt", "there": "w_there", "a": "vdot[i]"}
"""The C names of the inputs of a stage."""
TAKEN = frozenset(
    "at follow states z c k i m f q qdot theta thetadot rotor rotors s dt vdot by_q by_v by_there".split()
)


def content(chain: Chain) -> list[dict]:
    """The laws for the templates.

    ``at``, ``side``: coordinates and sides; ``place``: where these stand in ``q``; ``axes``: the axes that elastic
    gears join to these, if it depends on them, and ``axis_places`` where they do; ``on_added``: whether some are those
    that gears add; ``terms`` and ``lane_terms``: the body of the loop that adds force and inertia, of numbers and of
    lanes; ``slopes``: of that which
    adds the derivatives; ``reads``: which of the stage's inputs they need; ``columns``: the members of the constants,
    each with its comment; ``refused``: what their entries may not be.
    """
    return [_law(chain, one) for one in of_robot(chain)]


def calls(chain: Chain, function: str) -> bool:
    """Whether any of the laws calls a function, `on` or `exp`; friction along transmissions is among them."""
    frictions = (law for key in chain.keys for drive in key.drives for law, _ in drive.frictions)
    return any(function in stage(law).operations for law in {*chain.laws, *frictions})


def _law(chain: Chain, one: LawsOfRobot) -> dict:
    terms, slopes = stage(one.law), stage_slopes(one.law)
    return _internal(chain, one) | {
        "name": one.law.name.upper(),
        "words": one.law.words,
        "at": one.coordinates,
        "place": [chain.given_places[k] for k in one.coordinates],
        "axes": one.axes,
        "axis_places": [chain.given_places[k] for k in one.axes],
        "side": one.sides,
        "on_added": any(k >= chain.n_joints for k in one.coordinates),
        "terms": _body(Writer, terms),
        "lane_terms": _body(LaneWriter, terms),
        "slopes": _wider(chain, _body(Writer, slopes)),
        "reads": {name: _reads(terms, name) for name in STAGE},
        "slopes_read": {name: _reads(slopes, name) for name in STAGE},
        "columns": {name: _comment(chain, key) for name, key in one.law.table.items()},
        "refused": [
            test.format(f"c->{name}[k]")
            for sign, test in TESTS.items()
            for name, key in one.law.table.items()
            if key.sign == sign
        ],
        "notes": one.law.notes,
    }


def _wider(chain: Chain, lines: list[str]) -> list[str]:
    """Statements whose matrices by rates have columns of internal states besides."""
    if not chain.n_internal:
        return lines
    return [re.sub(r"(by_v|by_there)\[i \* \(\$\$_NV \+", r"\1[i * ($$_NVZ +", line) for line in lines]


def _internal(chain: Chain, one: LawsOfRobot) -> dict:
    """Of a law with an internal state: ``internal``, the number of that on every coordinate; ``rates``,
    ``lane_rates`` and ``rate_slopes``, the bodies of loops that find their rates and add the derivatives of these."""
    if one.law not in chain.internal:
        return {"internal": []}
    rates, slopes = state_rate(one.law), state_slopes(one.law)
    names = (*STAGE, "z", "axis")
    return {
        "internal": [k - chain.nv for k in chain.internal[one.law]],
        "rates": _body(Writer, rates, adding=frozenset()),
        "lane_rates": _body(LaneWriter, rates, adding=frozenset()),
        "rate_slopes": _body(Writer, slopes, adding=frozenset({"rate_x", "rate_w", "rate_there", "rate_axis"})),
        "rates_read": {LOCAL[name]: _reads(rates, name) for name in names},
        "rate_slopes_read": {LOCAL[name]: _reads(slopes, name) for name in names},
    }


TESTS = {"positive": "!({} > 0)", "non-negative": "!({} >= 0)"}
"""The conditions that refuse an entry of a column, by its sign."""


def _comment(chain: Chain, key: Key) -> str:
    return ascii_unit(f"{key.unit}{f', of slides {key.sliding}' * chain.sliding}: {key.meaning}")


def spring(motion: tuple[str, str], entry: str, force: str, inertia: str = "", **more: Any) -> list[str]:
    """The statements of a spring and a damper: their force at a coordinate and rate, and the inertia over a step.

    ``entry``: of the constants' columns. ``more`` may hold ``c``: what stands before the columns, else `c->`; ``h``:
    the step, else `dt`, or 0; ``own``: whether the inertia of the coordinate itself is added; ``adds``: whether the
    results are added to what is there.
    """
    c, h = more.get("c", "c->"), more.get("h", "dt")
    given = dict(zip("xw", motion, strict=True)) | {name: f"{c}{name}[{entry}]" for name in "KD"}
    given |= {"M": f"{c}M_eta[{entry}]", "h": h, "force": force, "inertia": inertia}
    program = spring_stage(h != "0", more.get("own", False))
    if not inertia:
        program = replace(program, outputs={"force": program.outputs["force"]})
    adding = frozenset(RESULTS) if more.get("adds") else frozenset[str]()
    return _inlined(_body(Writer, program, lambda name, _: given[name], adding, {}))


def _inlined(lines: list[str]) -> list[str]:
    """The statements without names for values that are at once assigned."""
    found = (re.fullmatch(r"const \$_real (\w+) = (.*);", line) for line in lines)
    named = {match[1]: match[2] for match in found if match}
    used = [re.fullmatch(r"(.* \+?= )(\w+);", line) for line in lines if not line.startswith("const ")]
    return [f"{match[1]}{named[match[2]]};" for match in used if match]


def springs(entry: str, *at: str, rates: Sequence[str] = ()) -> list[str]:
    """The statements that add the derivatives of a spring and a damper at places of the matrices of ``own_slopes``.

    ``entry``: the entry of the constants' columns; ``rates``: the places in the matrix by rates, if they are others.
    """
    by_rates = rates or at

    def place(name: str, k: int) -> str | None:
        given = {"K": f"c->K[{entry}]", "D": f"c->D[{entry}]", "h": "dt"}
        return {"by_x": f"by_q[{at[k]}]", "by_w": f"by_v[{by_rates[k]}]"}.get(name, given.get(name))

    return _body(Writer, spring_slopes(len(at)), place)


def _body(
    writer: type[Writer],
    program: Program,
    place: Place | None = None,
    adding: frozenset[str] = frozenset(RESULTS),
    optional: Mapping[str, str] = MappingProxyType({"inertia": "m"}),
) -> list[str]:
    """The statements for one coordinate."""
    names = TAKEN | set(LOCAL.values())
    placed = place or _place(program)
    lines = writer(program, placed, None, set(names), optional=optional, adding=adding)
    return [line for line in trimmed(lines.lines()) if line.strip() not in ("", "/* outputs */")]


def _place(program: Program) -> Place:
    constants = program.inputs.keys() - LOCAL.keys()

    def place(name: str, k: int) -> str | None:
        if name in RESULTS:
            return RESULTS[name] if not isinstance(program.outputs[name][k], float) else None
        return f"c->{name}[k]" if name in constants else LOCAL[name]

    return place


def _reads(program: Program, name: str) -> bool:
    """Whether a program needs one of its inputs."""
    entries: Iterable = (node.args for node in program.nodes if node.op == "input")
    return any(owner == name for owner, _ in entries)
