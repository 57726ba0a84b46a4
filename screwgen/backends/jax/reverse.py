"""What JAX differentiates backwards alone: a primitive that stands for tangents until it is transposed.

`jax.custom_vjp` would do, but whoever asks for forward mode then reads JAX's words, which name no remedy.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import jax
import jax.numpy as jnp
from jax.extend.core import Primitive
from jax.interpreters import ad, batching, mlir

from ...errors import UsageError

TANGENTS = Primitive("screwgen_tangents")
"""``(inputs, tangents of those that move) -> tangents of the outputs``; ``pull`` gives cotangents of the former."""
TANGENTS.multiple_results = True


def tangents(pull: Any, inputs: Sequence[Any], moves: Sequence[Any], outputs: Sequence[Any]) -> list[Any]:
    """The tangents of `outputs` for those of the inputs that move.

    ``pull(inputs, {place of an output: cotangent})``: the cotangents of the inputs that move, in their order.
    """
    types = tuple(map(jax.typeof, outputs))
    return TANGENTS.bind(*inputs, *moves, pull=pull, count=len(inputs), types=types)


def _refuse(*_: Any, **__: Any) -> Any:
    said = "these functions are differentiated backwards alone, by grad, vjp and jacrev"
    raise UsageError(f"{said}; for jvp, jacfwd and hessian take model.jax(forward_mode=True)")


def _transposed(seeds: Sequence[Any], *given: Any, pull: Any, count: int, types: tuple) -> list[Any]:
    used = {place: seed for place, seed in enumerate(seeds) if type(seed) is not ad.Zero}
    moving = len(given) - count
    return [None] * count + (list(pull(given[:count], used)) if used else [None] * moving)


def _batched(given: Sequence[Any], places: Sequence[Any], pull: Any, count: int, types: tuple) -> tuple[list, list]:
    """Tangents of many at once: along the first axis of all that is given."""
    (size,) = {x.shape[place] for x, place in zip(given, places, strict=True) if place is not None}
    ahead = lambda x, place: jnp.broadcast_to(x, (size, *x.shape)) if place is None else jnp.moveaxis(x, place, 0)  # noqa: E731
    whole = list(map(ahead, given, places))
    wide = tuple(of.update(shape=(size, *of.shape)) for of in types)
    found = TANGENTS.bind(*whole, pull=jax.vmap(pull), count=count, types=wide)
    return found, [0] * len(found)


TANGENTS.def_abstract_eval(lambda *_, types, **__: list(types))
TANGENTS.def_impl(_refuse)
mlir.register_lowering(TANGENTS, _refuse)
batching.primitive_batchers[TANGENTS] = _batched
ad.primitive_jvps[TANGENTS] = _refuse
ad.primitive_transposes[TANGENTS] = _transposed
