"""What a robot answers to its state and inputs: values, directional and adjoint derivatives, sparsity."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..ir.derivative import gradients, tangents
from ..ir.program import Node, Program, Tracer, Value
from ..ir.replay import inline
from ..spec.parameters import parameters
from ..topology.chain import Chain
from .functions import EVERYTHING, Functions
from .fused import fuse, prepared
from .gauges import strain_names
from .marker_functions import STRAINED
from .robot_functions import FUNCTIONS, OUTPUTS, entries, reported

Values = Mapping[str, Sequence[Value]]

POINT = ("q", "v", "tau", "w_ext")
"""States and inputs, in the order of a direction."""

REPORTS = tuple(row.name for row in FUNCTIONS if row.c_file == OUTPUTS)
ANSWERS = ("qdot", "vdot", "position", "rotation", "wrench", "strain", *REPORTS)
"""Rates of the states and outputs, in the order of a direction's image."""

ALGORITHMS = (*EVERYTHING, STRAINED)
"""Those for which the answers need constants."""


def sizes(chain: Chain) -> dict[str, int]:
    """The lengths of all of them; poses are those of the tips of the robot's links."""
    tips, gauged = len(chain.lasts), len(strain_names(chain))
    point = {"q": chain.nq, "v": chain.nv, "tau": chain.n_tau, "w_ext": 6 * chain.n}
    outputs = {"position": 3 * tips, "rotation": 9 * tips, "wrench": 6 * chain.n, "strain": gauged}
    told = {row.name: entries(row, chain) for row in reported(chain)}
    outputs |= {name: told.get(name, 0) for name in REPORTS}
    return point | {"qdot": chain.nq, "vdot": chain.nv} | outputs


def observation(chain: Chain, constants: str = "constants") -> Program:
    """``(q, v, tau, w_ext) -> (qdot, strain, energy, drive_power)``."""
    return fuse(chain, "observation", _given(chain, *POINT), _observed, constants, algorithms=ALGORITHMS)


def tangent(chain: Chain, constants: str = "constants") -> Program:
    """``(q, v, tau, w_ext, d_q, d_v, d_tau, d_w_ext) -> (d_qdot, ...)``: the derivative along a direction."""

    def body(f: Functions, x: Values) -> dict[str, Sequence[Value]]:
        answers = _answers(f, x)
        seeds = {a: b for name in POINT for a, b in zip(x[name], x[f"d_{name}"], strict=True) if isinstance(a, Node)}
        with f.section("along the direction"):
            slopes = tangents([value for values in answers.values() for value in values], seeds)
        return _named(slopes, {f"d_{name}": len(values) for name, values in answers.items()})

    inputs = _given(chain, *POINT)
    return fuse(chain, "tangent", inputs | {f"d_{n}": inputs[n] for n in POINT}, body, constants, algorithms=ALGORITHMS)


def adjoint(chain: Chain, constants: str = "constants") -> Program:
    """``(q, v, tau, w_ext, b_qdot, ...) -> (b_q, b_v, b_tau, b_w_ext)``: the gradient of the weighted sum."""

    def body(f: Functions, x: Values) -> dict[str, Sequence[Value]]:
        answers = _answers(f, x)
        values = [value for name in ANSWERS for value in answers[name]]
        weights = [weight for name in ANSWERS for weight in x[f"b_{name}"]]
        with f.section("against the direction"):
            found = gradients(values, weights, [value for name in POINT for value in x[name]])
        return _named(found, {f"b_{name}": len(x[name]) for name in POINT})

    size = sizes(chain)
    inputs = _given(chain, *POINT) | {f"b_{name}": size[name] for name in ANSWERS}
    return fuse(chain, "adjoint", inputs, body, constants, algorithms=ALGORITHMS)


def sparsity(chain: Chain) -> dict[str, list[list[int]]]:
    """The entries of the point, counted through ``POINT``, on which each entry of every answer depends."""
    program = fuse(chain, "response", _given(chain, *POINT), _answers, "constants", algorithms=ALGORITHMS)
    size = sizes(chain)
    starts = {name: sum(size[n] for n in POINT[:k]) for k, name in enumerate(POINT)}
    masks: dict[int, int] = {}
    for node in program.nodes:
        if node.op == "input":
            name, k = node.args
            masks[node.id] = 1 << (starts[name] + k) if name in starts else 0
            continue
        masks[node.id] = 0
        for a in node.args:
            masks[node.id] |= masks[a.id] if isinstance(a, Node) else 0
    return {n: [_bits(masks[v.id]) if isinstance(v, Node) else [] for v in o] for n, o in program.outputs.items()}


def _bits(mask: int) -> list[int]:
    return [k for k in range(mask.bit_length()) if mask >> k & 1]


def _given(chain: Chain, *names: str) -> dict[str, int]:
    size = sizes(chain)
    return {name: size[name] for name in names}


def _answers(f: Functions, x: Values) -> dict[str, Sequence[Value]]:
    """All answers, those of :func:`observation` last."""
    _fold(f)
    vdot, wrench = f.forward_dynamics(x["q"], x["v"], x["tau"], x["w_ext"])
    tips = f.poses(x["q"])[1]
    own = _observed(f, x)
    return {
        "qdot": own["qdot"],
        "vdot": vdot,
        "position": [value for i in f.chain.lasts for value in tips[i][1]],
        "rotation": [value for i in f.chain.lasts for value in tips[i][0]],
        "wrench": wrench,
        **{name: own[name] for name in ("strain", *REPORTS)},
    }


def _fold(f: Functions) -> None:
    """Put constants that depend on no parameter in place of inputs, such as the armature that a joint does not state.

    Without armature the wrench about the axis of a joint is the torque that acts there. The terms of which the
    elimination makes it then cancel as symbols, where numbers leave the rounding errors of large terms.
    """
    tracer = Tracer()
    p = tracer.input("p", len(parameters(f.chain.robot)))
    known = prepared(f.chain, p, lambda _, program, given: inline(program, given, tracer), ALGORITHMS)
    for own, fixed in zip(f.constants, known, strict=True):
        for name in own.keys() & fixed.keys():
            own[name] = [x if isinstance(k, Node) else k for x, k in zip(own[name], fixed[name], strict=True)]


def _observed(f: Functions, x: Values) -> dict[str, Sequence[Value]]:
    out: dict[str, Sequence[Value]] = {
        "qdot": f.coordinate_rates(x["q"], x["v"]) if f.chain.floating else list(x["v"]),
        "strain": f.strains(x["q"]),
    }
    for row in reported(f.chain):
        found = row.program.body(f, **{name: x[name] for name in row.names})
        out[row.name] = [value for values in found.values() for value in values]
    return dict.fromkeys(REPORTS, ()) | out


def _named(values: Sequence[Value], counts: Mapping[str, int]) -> dict[str, Sequence[Value]]:
    out, first = {}, 0
    for name, count in counts.items():
        out[name] = values[first : first + count]
        first += count
    return out
