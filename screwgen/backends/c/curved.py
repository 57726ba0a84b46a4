"""Joints whose coordinates do not add up, as the C templates print them: their places in `q`, in `v` and in `u`."""

from __future__ import annotations

import re

from ...algorithms.joint_moves import change_rate, coordinate_rates, integration
from ...ir.program import Program
from ...joints.kind import JointKind
from ...topology.chain import Chain
from .code import Writer, trimmed


def content(chain: Chain) -> dict[str, object]:
    """The templates' context: these joints, the runs of coordinates between them, and the length of their moves u."""
    base_alone = len(chain.curved) == 1 and chain.curved[0].joint.in_space
    balls = [part for part in chain.curved if not part.joint.in_space]
    return {
        "curved": _joints(chain),
        "moves_of": [one for joint in kinds(chain) for one in functions(joint, Writer)],
        "adding": _adding(chain),
        "balls": [chain.names[part.link] for part in balls],
        "n_turns": "$$_NTWIST" if base_alone else str(turns(chain)),
        "v_offset": chain.v_offset[:-1],
        "given_places": chain.given_places,
        "rates_of_q": {chain.place_in_q(rate): rate for rate in range(chain.base_v, chain.nv)},
        "turned": {part.q.start: (part.v.start, chain.names[part.link]) for part in balls},
        "n_rates": chain.v_offset[-1],
        "n_redundant": chain.n_redundant,
        "joint_coordinates": chain.q_offset[-1],
        "axis_q": chain.axis_places,
        "axis_places": [k - chain.base_q for k in chain.axis_places],
        "redundant_sums": _redundant_sums(chain),
        "redundant_turns": [
            {
                "kind": stem(part.joint),
                "q": plus(part.q.start - chain.base_q),
                "v": plus(part.v.start - chain.base_v),
            }
            for part in balls
        ],
    }


DAE_RUNS = ("dae_dynamics", "projection", "placement", "assembly")
"""The runs of the DAE form, which has no coordinates and rates of a floating base beside its pose and twist."""


def offset(chain: Chain, run: str, name: str, size: str) -> str:
    """Where a joint's part of a signal begins, of the coordinates (size q), the rates (m) or the torques (a) of all."""
    start, first = ("q", chain.base_q) if size == "q" or not chain.curved else ("v", chain.base_v)
    short = size == "a" or (run in DAE_RUNS and name != "qddot")
    return f"({start} - {first})" if first and short else start


def turns(chain: Chain) -> int:
    """The length of the moves u, whose entries of a joint stand where its rates do in v."""
    return chain.curved[-1].v.stop if chain.curved else 0


def lanes(chain: Chain, writer: type[Writer]) -> list[dict[str, object]]:
    """The functions of the kinds' moves that steps of lanes call."""
    return [one for joint in kinds(chain) for one in functions(joint, writer) if one["name"] != "coordinate_rates"]


def kinds(chain: Chain) -> list[JointKind]:
    """The kinds of these joints but for the floating base, which moves as poses of the DAE form do."""
    return list(dict.fromkeys(part.joint for part in chain.curved if not part.joint.in_space))


def stem(joint: JointKind) -> str:
    """What the names of a kind's functions begin with."""
    return re.sub(r"\W+", "_", joint.name)


SAID = {
    "integration": "q moved by u, the rates times a time if these are constant.",
    "change_rate": "the rate of u by which q moves, where the rates are v; enough for order four.",
    "coordinate_rates": "the rates of the coordinates q at the rates v.",
}


def functions(joint: JointKind, writer: type[Writer]) -> list[dict[str, object]]:
    """The functions of a kind's moves: what they take and make, with its length, and their bodies."""
    programs = (integration(joint), change_rate(joint), coordinate_rates(joint))
    return [_function(joint, program, writer) for program in programs]


def _function(joint: JointKind, program: Program, writer: type[Writer]) -> dict[str, object]:
    (made, values), given = *program.outputs.items(), program.inputs
    lines = trimmed(writer(program, lambda name, k: f"{name}[{k}]", None, {*given, made}).lines())
    text: dict[str, object] = {
        "name": program.name,
        "stem": stem(joint),
        "said": f"A {joint.name} joint: {SAID[program.name]}",
    }
    return text | {"given": dict(given), "made": made, "size": len(values), "lines": lines}


def _joints(chain: Chain) -> list[dict[str, object]]:
    """Offsets as text: nothing where they are 0; ``rates``: how many there are."""
    out = []
    for part in chain.curved:
        turn = part.q.start + (part.joint.turn_at or 0)
        offsets = {"q": part.q.start, "v": part.v.start, "turn": turn}
        rates = "$$_NTWIST" if part.joint.in_space else part.joint.nv
        texts: dict[str, object] = {name: plus(k) for name, k in offsets.items()}
        texts |= {"kind": stem(part.joint), "name": part.joint.name}
        out.append(texts | {"turn_at": turn, "shifts": part.joint.in_space, "rates": rates})
    return out


def plus(k: int) -> str:
    return f" + {k}" if k else ""


def _redundant_sums(chain: Chain) -> list[dict[str, int]]:
    """The axes in a run of the joint coordinates beside poses, by rates, and how far the coordinates are ahead."""
    out = []
    for i, key in enumerate(chain.keys):
        if key.joints and not key.joint.curved:
            start, end = (k - chain.base_v for k in chain.v_offset[i : i + 2])
            out.append({"start": start, "end": end, "ahead": chain.q_offset[i] - chain.base_q - start})
    return out


def _adding(chain: Chain) -> list[dict[str, object]]:
    """The runs of coordinates that add up: their rates ``start`` to ``end``, and how far `q` is ahead of these."""
    bounds = [0, *(k for part in chain.curved for k in (part.v.start, part.v.stop)), chain.nv]
    ends = {chain.base_v: "$$_NTWIST", chain.nv: "$$_NV"} if chain.base_v else {chain.nv: "$$_NV"}
    out, ahead = [], 0
    for number, (start, end) in enumerate(zip(bounds[::2], bounds[1::2], strict=True)):
        if start < end:
            out.append({"start": ends.get(start, start), "end": ends.get(end, end), "ahead": ahead})
        if number < len(chain.curved):
            ahead += chain.curved[number].joint.nq - chain.curved[number].joint.nv
    return out
