"""Programs as JAX functions that compile in seconds: run row by row, differentiated as programs.

XLA takes a minute and more over the thousands of scalar operations of an arm, and minutes over their gradient. So a
program becomes a table (:mod:`...ir.levels`) that one loop of XLA runs on a file of registers, with the scenarios of
``vmap`` side by side. Its reverse mode is the adjoint program (:mod:`...ir.adjoint`), run by the same loop.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax import lax
from jax.custom_batching import custom_vmap

from ...ir.adjoint import GRADIENT, SEED, adjoint
from ...ir.levels import Levels, levels
from ...ir.program import Program
from ...ir.replay import run
from .reverse import tangents

LIMIT, TERMS = 4.0, 14
"""As in the other back ends: where the Stumpff series ends, and its number of terms."""

LANES = 64
"""The largest number of scenarios side by side."""

Values = Mapping[str, Any]


class JaxProgram:
    """A program on JAX arrays: ``(inputs) -> (outputs, guards)``, vectors by name, all of one floating-point type.

    It works below ``jit``, ``vmap``, ``scan`` and ``grad``, of any order; forward mode is refused.
    """

    def __init__(self, program: Program):
        self.program = program
        self._adjoints: dict[tuple[str, ...], JaxProgram] = {}
        self._tables: dict[Any, Callable] = {}
        self._differentiable = jax.custom_jvp(self._plain)
        self._differentiable.defjvp(self._with_tangents, symbolic_zeros=True)

    def __call__(self, inputs: Values) -> tuple[dict[str, Any], Any]:
        return self._differentiable({name: inputs[name] for name in self.program.inputs})

    def _plain(self, inputs: Values) -> tuple[dict[str, Any], Any]:
        real = jnp.result_type(*inputs.values())
        if real not in self._tables:
            self._tables[real] = table_runner(levels(self.program, float(jnp.finfo(real).eps)), real)
        *outputs, guards = self._tables[real](*(inputs[name].astype(real) for name in self.program.inputs))
        return dict(zip(self.program.outputs, outputs, strict=True)), guards

    def _with_tangents(self, given: tuple[Values], moves: tuple[Values]) -> tuple[Any, Any]:
        """The results, and what stands for their tangents; guards are not differentiated."""
        (inputs,), ways = given, {name: x for name, x in moves[0].items() if not _is_zero(x)}
        outputs, guards = self(inputs)  # what an outer derivative differentiates
        names, moving, taken = tuple(outputs), tuple(ways), tuple(inputs)

        def pull(values: Sequence[Any], seeds: Mapping[int, Any]) -> list[Any]:
            made = self._adjoint(moving, tuple(names[place] for place in seeds))
            seeded = {SEED + names[place]: x for place, x in seeds.items()}
            found, _ = made(dict(zip(taken, values, strict=True)) | seeded)
            return [found[GRADIENT + name] for name in moving]

        found = tangents(pull, list(inputs.values()), list(ways.values()), list(outputs.values()))
        return (outputs, guards), (dict(zip(names, found, strict=True)), jnp.zeros_like(guards))

    def _adjoint(self, wanted: tuple[str, ...], outputs: tuple[str, ...]) -> JaxProgram:
        key = (*wanted, "", *outputs)
        if key not in self._adjoints:
            self._adjoints[key] = JaxProgram(adjoint(self.program, wanted, outputs))
        return self._adjoints[key]


def _is_zero(x: Any) -> bool:
    return isinstance(x, jax.custom_derivatives.SymbolicZero)


def table_runner(table: Levels, real: Any) -> Callable:
    """What runs a table: vectors in the order of its inputs -> its outputs and the guards."""

    @custom_vmap
    def evaluate(*inputs: jax.Array) -> list[jax.Array]:
        found = _run(table, real, [x[:, None] for x in inputs])
        return [x[:, 0] for x in found]

    @evaluate.def_vmap
    def batched(size: int, are_batched: Sequence[bool], *inputs: jax.Array) -> tuple[list[jax.Array], list[bool]]:
        columns = [
            x.T if own else jnp.broadcast_to(x[:, None], (*x.shape, size))
            for x, own in zip(inputs, are_batched, strict=True)
        ]
        found = wide(*columns)
        return [x.T for x in found], [True] * len(found)

    @custom_vmap
    def wide(*inputs: jax.Array) -> list[jax.Array]:
        """The same for columns (n, scenarios)."""
        return _in_blocks(table, real, inputs)

    @wide.def_vmap
    def wider(size: int, are_batched: Sequence[bool], *inputs: jax.Array) -> tuple[list[jax.Array], list[bool]]:
        spread = [
            x if own else jnp.broadcast_to(x[None], (size, *x.shape))
            for x, own in zip(inputs, are_batched, strict=True)
        ]
        flat = [jnp.moveaxis(x, 0, 1).reshape(x.shape[1], size * x.shape[2]) for x in spread]
        found = wide(*flat)
        return [jnp.moveaxis(x.reshape(len(x), size, x.shape[1] // size), 1, 0) for x in found], [True] * len(found)

    return evaluate


def _in_blocks(table: Levels, real: Any, inputs: Sequence[jax.Array]) -> list:
    """The same as :func:`_run` for as many scenarios at a time as leave the registers in a cache."""
    scenarios = inputs[0].shape[1]
    count = -(-scenarios // LANES)
    if count < 2:
        return _run(table, real, inputs)
    size = -(-scenarios // count)
    more = count * size - scenarios
    blocks = [jnp.pad(x, ((0, 0), (0, more)), "edge").reshape(len(x), count, size).swapaxes(0, 1) for x in inputs]
    found = lax.map(lambda block: _run(table, real, block), blocks)
    return [x.swapaxes(0, 1).reshape(x.shape[1], count * size)[:, :scenarios] for x in found]


def _run(table: Levels, real: Any, inputs: Sequence[jax.Array]) -> list:
    """Columns (n, scenarios) of the outputs and guards from those of the inputs."""
    scenarios = inputs[0].shape[1]
    literals = jnp.broadcast_to(jnp.asarray(table.literals, real)[:, None], (len(table.literals), scenarios))
    first = len(table.literals) + sum(table.inputs.values())
    results = jnp.zeros((len(table.kind) * table.width, scenarios), real)
    registers = jnp.concatenate([literals, *inputs, results])
    branches = [partial(_row, kind, count, table.width) for kind, count in zip(table.kinds, table.count, strict=True)]

    def row(registers: jax.Array, given: tuple[Any, ...]) -> tuple[jax.Array, None]:
        k, kind, op, a, b = given
        new = lax.switch(kind, branches, registers, op, a, b)
        return lax.dynamic_update_slice_in_dim(registers, new, first + k * table.width, 0), None

    rows = (np.arange(len(table.kind), dtype=np.int32), table.kind, table.op, table.a, table.b)
    if len(table.kind):
        registers, _ = lax.scan(row, registers, rows)
    pick = lambda places: registers[places]  # noqa: E731
    return [*(pick(places) for places in table.outputs.values()), pick(table.guards)]


def _row(
    kind: str, count: int, width: int, registers: jax.Array, op: jax.Array, a: jax.Array, b: jax.Array
) -> jax.Array:
    """The results (width, scenarios) of a row; what stands behind its operations is of no meaning."""
    take = lambda places: registers.at[places[:count]].get(mode="promise_in_bounds")  # noqa: E731
    x = take(a)
    if kind in ("", "div"):
        y, which = take(b), op[:count, None]
        out = x / y if kind else jnp.where(which == 2, x * y, jnp.where(which == 1, x - y, x + y))
    else:
        out = functions(kind, x, *([take(b)] if kind == "atan2" else []))
    return jnp.concatenate([out, jnp.zeros((width - count, out.shape[1]), out.dtype)]) if count < width else out


def functions(op: str, x: jax.Array, *more: jax.Array) -> jax.Array:
    """The primitives on arrays."""
    if op == "neg":
        return -x
    if op == "on":
        return (x > 0).astype(x.dtype)
    if op[0] == "c" and op[1:].isdigit():
        return _stumpff(int(op[1:]), x)
    return jnp.arctan2(x, *more) if op == "atan2" else getattr(jnp, op)(x)


def _stumpff(order: int, x: jax.Array) -> jax.Array:
    """The series below the limit; sine and cosine above, and the recurrence ``c_k = (1/(k-2)! - c_(k-2)) / x``."""
    large = x >= LIMIT
    near = jnp.where(large, 0, x)
    series = jnp.ones_like(x)
    for j in reversed(range(1, TERMS)):
        series = 1 - near / ((order + 2 * j - 1) * (order + 2 * j)) * series
    far = jnp.where(large, x, LIMIT)
    s = jnp.sqrt(far)
    closed = (jnp.cos(s) - 1 + far / 2) / far**2 if order % 2 == 0 else (jnp.sin(s) - s + s * far / 6) / (far**2 * s)
    for k in range(6 + order % 2, order + 1, 2):
        closed = (1 / math.factorial(k - 2) - closed) / far
    return jnp.where(large, closed, series / math.factorial(order))


def straight(program: Program) -> Callable[[Values], tuple[dict[str, Any], Any]]:
    """A program as single operations, which JAX differentiates in any mode and XLA compiles for minutes."""

    def evaluate(inputs: Values) -> tuple[dict[str, Any], Any]:
        given = {name: [inputs[name][i] for i in range(size)] for name, size in program.inputs.items()}
        real = jnp.result_type(*(inputs[name] for name in program.inputs))
        outputs, guards = run(program, given, functions, float(jnp.finfo(real).eps))
        stack = lambda values: jnp.stack([jnp.asarray(x, real) for x in values]) if values else jnp.zeros(0, real)  # noqa: E731
        return {name: stack(values) for name, values in outputs.items()}, stack(guards)

    return evaluate
