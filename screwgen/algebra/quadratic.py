"""Quadratic forms with few operations: each product of two entries is computed once."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..lazily import sp

Array = np.ndarray


def half_form(H: Array, x: Array, rows: Array) -> sp.Expr:
    """``1/2 x^T H x`` of a symmetric ``H``, with ``rows = H x`` known.

    Entries that couple two groups of coordinates are summed over the smaller group alone.
    """
    terms = []
    for group, others in _groups(H):
        total = sp.Add(*(x[k] * rows[k] for k in group))
        terms.append(total if others else _times(sp.Rational(1, 2), total))
    return sp.Add(*terms)


def form(H: Array, x: Array) -> sp.Expr:
    """``x^T H x`` of a symmetric ``H``."""
    terms = []
    for group, others in _groups(H):
        if others:
            once = sp.Add(*(x[k] * sp.Add(*(H[k, m] * x[m] for m in others)) for k in group))
            terms.append(_times(sp.S(2), once))
            continue
        for n, k in enumerate(group):
            twice = sp.Add(*(H[k, m] * x[m] for m in group[n + 1 :]))
            terms.append(x[k] * sp.Add(H[k, k] * x[k], _times(sp.S(2), twice)))
    return sp.Add(*terms)


def _times(factor: sp.Expr, total: sp.Expr) -> sp.Expr:
    """The product without its distribution over the terms of a sum."""
    return sp.Mul(factor, total, evaluate=not total.is_Add)


def _groups(H: Array) -> Iterator[tuple[list[int], list[int]]]:
    """The sets of coordinates that entries of ``H`` couple.

    Each is split in two, the smaller first, if only entries between its parts are not zero; else the second is empty.
    """
    coupled = [[m for m in range(len(H)) if H[k, m] != 0] for k in range(len(H))]
    side: dict[int, int] = {}
    for first in (k for k, row in enumerate(coupled) if row):
        if first in side:
            continue
        side[first], found = 0, [first]
        for k in found:
            new = [m for m in coupled[k] if m not in side]
            side |= dict.fromkeys(new, 1 - side[k])
            found += new
        if any(side[k] == side[m] for k in found for m in coupled[k]):
            yield sorted(found), []
        else:
            parts = [sorted(k for k in found if side[k] == s) for s in (0, 1)]
            yield tuple(sorted(parts, key=len))  # type: ignore[misc]
