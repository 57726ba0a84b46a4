"""What a robot answers to its state and inputs: values, directional and adjoint derivatives, sparsity."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property

from ..ir.derivative import gradients, tangents
from ..ir.program import Node, Program, Tracer, Value
from ..ir.replay import inline
from ..spec.parameters import parameters
from ..topology.chain import Chain
from .functions import EVERYTHING, HOLD, Functions
from .fused import fuse, prepared
from .gauges import strain_names
from .marker_functions import STRAINED
from .robot_function import RobotFunction, entries
from .robot_functions import FUNCTIONS, OUTPUTS, reported, sensed
from .schedule import Algorithm

Values = Mapping[str, Sequence[Value]]
Body = Callable[[Functions, Values], Values]

POINT = ("q", "v", "tau", "w_ext")
"""States and inputs, in the order of a direction."""

OWN = ("qdot", "vdot", "position", "rotation", "wrench", "strain")
"""Rates of the states, and outputs besides what functions report."""
REPORTED = tuple(row.name for row in FUNCTIONS if row.c_file == OUTPUTS)


class Response:
    """The answers of a robot: ``OWN``, what functions report at every sample, with ``sensing`` what sensors measure.

    They are those to the inputs as a step from the point holds them: a unit stands for the robot with its drives.

    ``answers``: their names, in the order of a direction's image.
    """

    def __init__(self, chain: Chain, sensing: bool = False):
        self.chain = chain
        self.rows: dict[str, RobotFunction] = {row.name: row for row in reported(chain) + sensed(chain) * sensing}
        self.reports = (*REPORTED, *(name for name in self.rows if name not in REPORTED))
        self.answers = (*OWN, *self.reports)
        own = tuple(algorithm for row in self.rows.values() for algorithm in row.algorithms)
        self.algorithms: tuple[Algorithm, ...] = (*EVERYTHING, HOLD, STRAINED, *own)

    @cached_property
    def sizes(self) -> dict[str, int]:
        """The lengths of states, inputs and answers; poses are those of the tips of the robot's links."""
        chain, tips = self.chain, len(self.chain.lasts)
        point = {"q": chain.nq, "v": chain.nvz, "tau": chain.n_tau, "w_ext": 6 * chain.n}
        outputs = {
            "position": 3 * tips,
            "rotation": 9 * tips,
            "wrench": 6 * chain.n,
            "strain": len(strain_names(chain)),
        }
        told = {name: entries(self.rows[name], chain) if name in self.rows else 0 for name in self.reports}
        return point | {"qdot": chain.nq, "vdot": chain.nvz} | outputs | told

    def observation(self, constants: str = "constants") -> Program:
        """``(q, v, tau, w_ext) -> (qdot, strain, energy, drive_power, ...)``."""
        return self._fused("observation", self._point, self._observed, constants)

    def tangent(self, constants: str = "constants") -> Program:
        """``(q, v, tau, w_ext, d_q, d_v, d_tau, d_w_ext) -> (d_qdot, ...)``: the derivative along a direction."""

        def body(f: Functions, x: Values) -> dict[str, Sequence[Value]]:
            answers = self._answered(f, x)
            seeds = {
                a: b for name in POINT for a, b in zip(x[name], x[f"d_{name}"], strict=True) if isinstance(a, Node)
            }
            with f.section("along the direction"):
                slopes = tangents([value for values in answers.values() for value in values], seeds)
            return _named(slopes, {f"d_{name}": len(values) for name, values in answers.items()})

        inputs = self._point
        return self._fused("tangent", inputs | {f"d_{n}": inputs[n] for n in POINT}, body, constants)

    def adjoint(self, constants: str = "constants") -> Program:
        """``(q, v, tau, w_ext, b_qdot, ...) -> (b_q, b_v, b_tau, b_w_ext)``: the gradient of the weighted sum."""

        def body(f: Functions, x: Values) -> dict[str, Sequence[Value]]:
            answers = self._answered(f, x)
            values = [value for name in self.answers for value in answers[name]]
            weights = [weight for name in self.answers for weight in x[f"b_{name}"]]
            with f.section("against the direction"):
                found = gradients(values, weights, [value for name in POINT for value in x[name]])
            return _named(found, {f"b_{name}": len(x[name]) for name in POINT})

        inputs = self._point | {f"b_{name}": self.sizes[name] for name in self.answers}
        return self._fused("adjoint", inputs, body, constants)

    def sparsity(self) -> dict[str, list[list[int]]]:
        """The entries of the point, counted through ``POINT``, on which each entry of every answer depends."""
        program = self._fused("response", self._point, self._answered, "constants")
        starts = {name: sum(self.sizes[n] for n in POINT[:k]) for k, name in enumerate(POINT)}
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

    @property
    def _point(self) -> dict[str, int]:
        return {name: self.sizes[name] for name in POINT}

    def _fused(
        self,
        name: str,
        inputs: Mapping[str, int],
        body: Callable[[Functions, Values], Mapping[str, Sequence[Value]]],
        constants: str,
    ) -> Program:
        return fuse(self.chain, name, inputs, body, constants, algorithms=self.algorithms)

    def _answered(self, f: Functions, x: Values) -> dict[str, Sequence[Value]]:
        """All answers, those of :meth:`observation` last."""
        _fold(f, self.algorithms)
        x = _held(f, x)
        vdot, wrench = f.forward_dynamics(x["q"], x["v"], x["tau"], x["w_ext"])
        tips = f.poses(x["q"])[1]
        own = self._told(f, x)
        return {
            "qdot": own["qdot"],
            "vdot": vdot,
            "position": [value for i in f.chain.lasts for value in tips[i][1]],
            "rotation": [value for i in f.chain.lasts for value in tips[i][0]],
            "wrench": wrench,
            **{name: own[name] for name in ("strain", *self.reports)},
        }

    def _observed(self, f: Functions, x: Values) -> dict[str, Sequence[Value]]:
        return self._told(f, _held(f, x))

    def _told(self, f: Functions, x: Values) -> dict[str, Sequence[Value]]:
        out: dict[str, Sequence[Value]] = {
            "qdot": f.coordinate_rates(x["q"], x["v"]),
            "strain": f.strains(x["q"]),
        }
        for name, row in self.rows.items():
            found = row.program.body(f, **{name: x[name] for name in row.names})
            out[name] = [value for values in found.values() for value in values]
        return dict.fromkeys(self.reports, ()) | out


def _held(f: Functions, x: Values) -> Values:
    """The point with its inputs as a step that begins there holds them."""
    return {**x, "tau": f.held(x["q"], x["v"], x["tau"])} if f.chain.holds else x


def _bits(mask: int) -> list[int]:
    return [k for k in range(mask.bit_length()) if mask >> k & 1]


def _fold(f: Functions, algorithms: Sequence[Algorithm]) -> None:
    """Put constants that depend on no parameter in place of inputs, such as the armature that a joint does not state.

    Without armature the wrench about the axis of a joint is the torque that acts there. The terms of which the
    elimination makes it then cancel as symbols, where numbers leave the rounding errors of large terms.
    """
    tracer = Tracer()
    p = tracer.input("p", len(parameters(f.chain.robot)))
    known = prepared(f.chain, p, lambda _, program, given: inline(program, given, tracer), algorithms)
    for own, fixed in zip(f.constants, known, strict=True):
        for name in own.keys() & fixed.keys():
            own[name] = [x if isinstance(k, Node) else k for x, k in zip(own[name], fixed[name], strict=True)]


def _named(values: Sequence[Value], counts: Mapping[str, int]) -> dict[str, Sequence[Value]]:
    out, first = {}, 0
    for name, count in counts.items():
        out[name] = values[first : first + count]
        first += count
    return out
