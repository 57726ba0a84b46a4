"""Blocks of a link whose base rests: entries that vanish there are left out of the equations."""

from __future__ import annotations

from collections.abc import Mapping, Set
from copy import copy
from dataclasses import replace

import numpy as np
import sympy as sp

from ...ir.block import Block, NamedSignal

CARRIER = ("omega_P", "v_P")
"""The velocities of what carries a link."""
OWN = ("omega", "v")
"""Those of the link."""


def at_rest(blocks: Mapping[str, Block]) -> dict[str, Block]:
    """The blocks of a link that sits on a base at rest: it has the velocities alone that its joint gives it."""
    joint = blocks["joint"]
    none = {symbol for name in CARRIER for symbol in _symbols(joint.inputs[name])}
    moved = without(joint, none).values
    none |= {s for name in OWN for s, x in _symbols(joint.signal(name), moved[name]).items() if x == 0}
    return {name: without(block, none) for name, block in blocks.items()}


def without(block: Block, none: Set[sp.Symbol]) -> Block:
    """The block with zeros in place of some of its symbols, and of all that vanishes with them."""
    gone = dict.fromkeys(none, sp.S.Zero)
    steps = {}
    for step in block.steps.values():
        made = [(symbol, entry.xreplace(gone)) for symbol, entry in step.assignments]
        gone |= {symbol: sp.S.Zero for symbol, entry in made if entry == 0}
        steps[step.signal.name] = replace(step, assignments=tuple(pair for pair in made if pair[1] != 0))
    out = copy(block)
    out.steps, out.values = steps, {}
    for name, entries in block.values.items():
        out.values[name] = np.vectorize(lambda x: sp.sympify(x).xreplace(gone), otypes=[object])(entries)
    return out


def _symbols(signal: NamedSignal, entries: np.ndarray | None = None) -> dict[sp.Symbol, object]:
    """The symbols of the entries of a signal, each with its entry if these are given."""
    return {sp.Symbol(s, real=True): None if entries is None else entries[index] for index, s in signal.labels()}
