"""Derivatives by parameters: what a function of a robot changes with numbers of its file, in forward mode.

An example: how the acceleration of an arm changes with its length. The constants of a link follow from its parameters
by its preparation, and what the function computes from these by the phases; both are traced, and so is the slope.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from ..ir.derivative import tangents
from ..ir.program import Node, Program, Value
from ..spec.parameters import parameters
from ..topology.chain import Chain
from .functions import EVERYTHING, Functions
from .fused import Outputs, fuse, inputs, world
from .robot_function import RobotFunction, shape
from .schedule import Algorithm

BY_P = "_by_p"
"""The end of the names of these functions and of their results."""


@dataclass(frozen=True)
class Differentiable:
    """A function of a robot, as it is differentiated: ``body`` of its functions and inputs gives ``results``."""

    name: str
    inputs: Mapping[str, int]
    """The lengths of its inputs, the parameters left out."""
    results: Mapping[str, tuple[int, ...]]
    """The shapes of its results."""
    body: Callable[[Functions, Mapping[str, Sequence[Value]]], Outputs]
    algorithms: tuple[Algorithm, ...] = EVERYTHING

    @classmethod
    def of(cls, chain: Chain, row: RobotFunction) -> Differentiable:
        """A row of the functions of a robot."""
        shapes = {name: shape(signal, chain) for name, signal in row.results.items()}
        run = lambda f, x: row.program.body(f, **{name: x[name] for name in row.names})  # noqa: E731
        return cls(row.name, inputs(chain, row.inputs), shapes, run, (*EVERYTHING, *row.algorithms))

    def sizes(self) -> dict[str, int]:
        """The number of entries of each result."""
        return {name: math.prod(size) for name, size in self.results.items()}


def along(chain: Chain, what: Differentiable, chosen: Sequence[int]) -> Program:
    """``(inputs, p, d_p) -> (results, d_results)``: the derivative along a change ``d_p`` of the chosen parameters."""

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Outputs:
        found, seeds = what.body(f, x), {x["p"][k]: d for k, d in zip(chosen, x["d_p"], strict=True)}
        values = [value for name in what.results for value in found[name]]
        slopes = tangents(values, {a: d for a, d in seeds.items() if isinstance(a, Node)})
        return {**found, **dict(_split(slopes, what))}

    given = {**what.inputs, "p": len(parameters(chain.robot)), "d_p": len(chosen)}
    return fuse(chain, what.name + BY_P, given, body, algorithms=what.algorithms)


def _split(values: Sequence[Value], what: Differentiable) -> Iterator[tuple[str, Sequence[Value]]]:
    first = 0
    for name, size in what.sizes().items():
        yield f"d_{name}", values[first : first + size]
        first += size


# ------------------------------------------------------------------------------------ at prepared constants


@dataclass(frozen=True)
class ConstantSlopes:
    """The derivatives of the constants of all links with chosen parameters, and of what sensors derive from parameters.

    ``program``: ``(p) -> (slope)`` of those that are no numbers. ``seeds``: for each chosen parameter the derivative of
    every entry of a constant that it changes, by link, name and number: a number, or a place in ``slope``, an int.
    Numbers of sensors stand behind the last link.
    """

    program: Program
    seeds: list[dict[tuple[int, str, int], float | int]]

    @classmethod
    def of(
        cls,
        chain: Chain,
        chosen: Sequence[int],
        algorithms: Sequence[Algorithm],
        derived: Mapping[str, Callable[[Chain, Sequence[Value]], Sequence[Value]]] | None = None,
    ) -> ConstantSlopes:
        """By the chosen parameters, of the constants that these algorithms read, and of ``derived`` numbers by name."""
        seeds: list[dict[tuple[int, str, int], float | int]] = []

        def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Outputs:
            sensed = {name: start(chain, x["p"]) for name, start in (derived or {}).items()}
            read: list[Mapping[str, Sequence[Value]]] = [*f.constants, sensed]
            places = [(i, n, k) for i, own in enumerate(read) for n, v in own.items() for k in range(len(v))]
            values = [read[i][n][k] for i, n, k in places]
            slopes: dict[Node, int] = {}
            for p in (x["p"][k] for k in chosen):
                found = zip(places, tangents(values, {p: 1.0} if isinstance(p, Node) else {}), strict=True)
                own: dict[tuple[int, str, int], float | int] = {}
                for place, slope in found:
                    if isinstance(slope, Node):
                        own[place] = slopes.setdefault(slope, len(slopes))
                    elif slope:
                        own[place] = float(slope)
                seeds.append(own)
            return {"slope": list(slopes)}

        given = {"p": len(parameters(chain.robot))}
        return cls(fuse(chain, "constants" + BY_P, given, body, algorithms=algorithms), seeds)

    @property
    def count(self) -> int:
        """The number of slopes that are no numbers."""
        return len(self.program.outputs["slope"])

    def by_parameters(self, chain: Chain, what: Differentiable, chosen: Sequence[int]) -> Program:
        """``(inputs, constants, slope) -> (results_by_p)``: the last index of each is that of the chosen parameter."""

        def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Outputs:
            found = what.body(f, x)
            values, columns = [value for name in what.results for value in found[name]], []
            for k, number in enumerate(chosen):
                with f.section(f"by {parameters(chain.robot)[number].name}"):
                    columns.append(dict(_split(tangents(values, self.along(f, k, number, x["slope"])), what)))
            return {n + BY_P: [x for row in zip(*(c[f"d_{n}"] for c in columns), strict=True) for x in row]
                    for n in what.results}  # fmt: skip

        given = {**what.inputs, "slope": self.count}
        return fuse(chain, what.name + BY_P, given, body, "constants", algorithms=what.algorithms)

    def along(
        self,
        f: Functions,
        chosen: int,
        number: int,
        slope: Sequence[Value],
        derived: Mapping[str, Sequence[Value]] | None = None,
    ) -> dict[Node, Value]:
        """How what ``f`` reads changes with a chosen parameter, the robot's ``number``; and ``derived`` numbers."""
        read: list[Mapping[str, Sequence[Value]]] = [*f.constants, derived or {}]
        places = list(world(f.chain, range(len(parameters(f.chain.robot)))))
        way: dict[Node, Value] = {f.world[places.index(number)]: 1.0} if number in places else {}
        for (i, n, k), seed in self.seeds[chosen].items():
            if n in read[i] and isinstance(constant := read[i][n][k], Node):
                way[constant] = _slope(seed, slope)
        return way


def _slope(seed: float | int, slopes: Sequence[Value]) -> Value:
    return slopes[seed] if isinstance(seed, int) else seed
