"""Standard input data (SID) of a link: a file that other multibody programs read, and this one."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from ..backends.numpy.numeric import Numeric
from ..bodies.rod_integrals import Integrals
from ..errors import UsageError
from ..reduction.invariants import Invariants
from ..reduction.sid import sid_text
from ..reduction.standard import sid_of
from ..spec.reduced import elastic
from ..spec.robot import Link, Robot
from ..topology.chain import Chain

PLACES = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Where a rod has nodes, base to tip."""


def write_sid(link: Link, path: str | os.PathLike[str]) -> None:
    """Write the standard input data of a link: its rod, or its body from a file; without joint and mounted bodies.

    A rod has five nodes, `base`, `1`, `2`, `3` and `tip`; with `order = 2` its geometric stiffness is in the file.
    Raises UsageError for a link without modes.
    """
    body = elastic(link)
    if body is None and not link.modes.total:
        raise UsageError(f"link '{link.name}' has no modes; state modes, or leave it rigid")
    if link.pieces > 1:
        raise UsageError(f"link '{link.name}' has segments, which are bodies of their own; write one without segments")
    if link.rest:
        raise UsageError(
            f"link '{link.name}' is curved at rest; data of straight rods alone are written, leave out rest"
        )
    Path(path).write_text(sid_text(sid_of(body or invariants_of_rod(link))), encoding="utf-8")


def invariants_of_rod(link: Link) -> Invariants:
    """The invariants of a rod at the values that its file states, seen from F_i."""
    alone = link.model_copy(update={"bodies": ()})
    chain = Chain(Robot(name="rod", gravity=(0.0, 0.0, 0.0), links=(alone,)))
    key, constants = chain.keys[0], Numeric(chain, chain.parameters.vector(None)).constants[0]
    rod = Integrals(link, key)
    below = zip(*key.coupled, strict=True) if key.coupled else ((), ())
    rows, columns = map(list, below)

    def full(diagonal: str, lower: str) -> np.ndarray:
        out = np.diag(np.array(constants[diagonal], float))
        out[rows, columns] = out[columns, rows] = np.array(constants.get(lower, [0.0] * len(rows)), float)
        return out

    sag, swing = rod.second()
    names = tuple(f"{direction} {k + 1}" for direction, k in key.directions)
    nodes = tuple(rod.node(s, name) for s, name in zip(PLACES, ("base", "1", "2", "3", "tip"), strict=True))
    matrices = full("M_eta", "M_below"), full("K", "K_below"), full("D", "D_below")
    return Invariants(rod.gram(), *matrices, sag, swing, names, nodes)
