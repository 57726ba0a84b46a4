"""The mass matrix and the derivatives of the inverse dynamics, as :mod:`.linearise` finds them."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from ..ir.program import Array
from ..topology.chain import Chain
from . import matrices as mx


@dataclass
class Slopes:
    """Mass matrix and partial derivatives of the inverse dynamics with q and rates, (nv, nv) each.

    Derivatives with q are those along v: of a floating base with a twist-like change of its pose, ``pose exp(delta)``.
    ``f_z`` (nv, n_internal): with internal states; ``z_q``, ``z_v``: of their rates, with q and with all of v (nvz),
    zero in the rows of states of forces, which no law of a coordinate has.
    """

    M: Array
    f_q: Array
    f_v: Array
    f_z: Array
    z_q: Array
    z_v: Array

    @classmethod
    def zero(cls, chain: Chain, more: int = 0) -> Slopes:
        """None, with ``more`` rows of the first two derivatives."""
        nv, m = chain.nv, chain.n_internal
        sizes = (nv, nv), (nv + more, nv), (nv + more, nv), (nv, m), (m, nv), (m, chain.nvz)
        return cls(*(mx.zeros(*size) for size in sizes))


def of_numbers(found: Slopes) -> Slopes:
    """The slopes as arrays of doubles."""
    return Slopes(*(getattr(found, one.name).astype(float) for one in fields(found)))


def symmetric(lower: np.ndarray) -> np.ndarray:
    """The symmetric matrix with a lower triangle."""
    return np.tril(lower) + np.tril(lower, -1).T
