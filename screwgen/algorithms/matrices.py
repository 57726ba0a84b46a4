"""Matrix operations on arrays whose entries are program nodes or floats.

Spatial vectors have their angular part first. ``Lambda`` is a symmetric 6 x 6 matrix, ``r`` a point. Entries that are
float zeros or ones cost no operation, and of a symmetric result only one triangle is computed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol

import numpy as np

from ..ir.names import Label
from ..ir.program import Array, Node, Tracer, Value, Vector, give_label


def array(entries: Any, shape: tuple[int, ...] | None = None) -> Array:
    out = np.array(entries, dtype=object)
    return out if shape is None else out.reshape(shape)


def zeros(*shape: int) -> Array:
    return np.full(shape, 0.0, dtype=object)


def identity(n: int) -> Array:
    return array(np.eye(n).tolist(), (n, n))


def name(quantity: str, values: Array) -> Array:
    """The array, its entries named in generated code after a quantity and their places, unless they have a name."""
    for index, value in np.ndenumerate(values):
        give_label(value, Label(quantity, "".join(str(i + 1) for i in index)))
    return values


def dot(a: Vector, b: Vector) -> Value:
    total: Value = 0.0
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def multiply(a: Array, b: Array) -> Array:
    """The product ``a b``; ``b`` may be a vector."""
    if b.ndim == 1:
        return array([dot(row, b) for row in a], (a.shape[0],))
    return array([[dot(row, column) for column in b.T] for row in a], (a.shape[0], b.shape[1]))


def chain(*factors: Array) -> Array:
    """A product of several matrices, from the right (the last may be a vector)."""
    out = factors[-1]
    for factor in reversed(factors[:-1]):
        out = multiply(factor, out)
    return out


def symmetric(n: int, entry: Callable[[int, int], Value]) -> Array:
    """The symmetric matrix whose upper triangle is ``entry(i, j)``."""
    out = np.empty((n, n), dtype=object)
    for i in range(n):
        for j in range(i, n):
            out[i, j] = out[j, i] = entry(i, j)
    return out


def diagonal(values: Vector) -> Array:
    """The matrix with these values on its diagonal."""
    return symmetric(len(values), lambda i, j: values[i] if i == j else 0.0)


def coupled(values: Vector, places: Sequence[tuple[int, int]], below: Vector) -> Array:
    """The symmetric matrix with ``values`` on its diagonal and entries ``below`` it at ``places`` (row, column)."""
    others = dict(zip(places, below, strict=True))
    return symmetric(len(values), lambda i, j: values[i] if i == j else others.get((j, i), 0.0))


def congruence(T: Array, A: Array) -> Array:
    """``T^T A T`` of a symmetric ``A``."""
    half = multiply(A, T)
    return symmetric(T.shape[1], lambda i, j: dot(T[:, i], half[:, j]))


def subtract_product(A: Array, Z: Array, W: Array) -> Array:
    """``A - Z^T W`` where the result is symmetric."""
    return symmetric(A.shape[0], lambda i, j: A[i, j] - dot(Z[:, i], W[:, j]))


def hat(a: Vector) -> Array:
    x, y, z = a
    return array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]], (3, 3))


def cross(a: Vector, b: Vector) -> Array:
    return array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def blocks(A: Array, B: Array, C: Array) -> Array:
    """The symmetric ``[[A, B], [B^T, C]]``."""
    return np.block([[A, B], [B.T, C]])


def pack(Lambda: Array) -> list[Value]:
    """The upper triangle, row by row: 21 numbers of a symmetric 6 x 6."""
    return [Lambda[i, j] for i in range(len(Lambda)) for j in range(i, len(Lambda))]


def unpack(entries: Vector, n: int = 6) -> Array:
    upper = {(i, j): k for k, (i, j) in enumerate((i, j) for i in range(n) for j in range(i, n))}
    return symmetric(n, lambda i, j: entries[upper[i, j]])


def rotate(R: Array, Lambda: Array) -> Array:
    """``blkdiag(R, R) Lambda blkdiag(R, R)^T``: components of the frame that ``R`` maps to."""
    A, B, C = Lambda[:3, :3], Lambda[:3, 3:], Lambda[3:, 3:]
    return blocks(turn(R, A), chain(R, B, R.T), turn(R, C))


def turn(R: Array, A: Array) -> Array:
    """``R A R^T`` of a rotation and a symmetric 3 x 3.

    If no entry is a float: with ``A = a 1 + T + T^T``, where ``T`` is strictly upper triangular but for two diagonal
    entries, the result is ``a 1 + X + X^T`` with ``X = R T R^T``.
    """
    if not all(isinstance(x, Node) for x in (*A.flat, *R.flat)):
        return congruence(R.T, A)
    a, r, s = A[2, 2], R[:, 0], R[:, 1]
    y = (0.5 * (A[0, 0] - a)) * r + A[0, 1] * s + A[0, 2] * R[:, 2]
    z = (0.5 * (A[1, 1] - a)) * s + A[1, 2] * R[:, 2]
    doubled = lambda i: 2.0 * (r[i] * y[i] + s[i] * z[i]) + a  # noqa: E731
    mixed = lambda i, j: (r[i] * y[j] + s[i] * z[j]) + (r[j] * y[i] + s[j] * z[i])  # noqa: E731
    return symmetric(3, lambda i, j: doubled(i) if i == j else mixed(i, j))


def rotate_wrench(R: Array, w: Array) -> Array:
    return np.concatenate([multiply(R, w[:3]), multiply(R, w[3:])])


def shift(r: Array, Lambda: Array) -> Array:
    """``S^T Lambda S`` with ``S = [[I, 0], [-hat(r), I]]``: from the point ``r`` to the origin."""
    A, B, C = Lambda[:3, :3], Lambda[:3, 3:], Lambda[3:, 3:]
    r_hat = hat(r)
    arm = multiply(r_hat, C)
    moved = B + arm
    top = multiply(B, r_hat)
    corner = multiply(r_hat, array(moved.T, (3, 3)))
    return blocks(symmetric(3, lambda i, j: A[i, j] - top[i, j] + corner[i, j]), moved, C)


def shift_wrench(r: Array, w: Array) -> Array:
    """A wrench at the point ``r``, expressed about the origin."""
    return np.concatenate([w[:3] + cross(r, w[3:]), w[3:]])


def shift_twist(r: Array, V: Array) -> Array:
    """The twist (or its rate, without bias) of the point ``r`` of a body whose origin has ``V``."""
    return np.concatenate([V[:3], V[3:] + cross(V[:3], r)])


Factor = tuple[Array, list[Value]]
"""``L`` and ``1/d`` of a symmetric ``L diag(d) L^T``."""


class Yielding(Protocol):
    """What changes the answer of a row: its ``mobility``, ``share / (share pivot + inertia)``."""

    @property
    def share(self) -> Value: ...

    @property
    def inertia(self) -> Value: ...


def factorise(
    M: Array, tracer: Tracer | None = None, threshold: Value = 0.0, held: Mapping[int, Yielding] | None = None
) -> Factor:
    """``M = L diag(d) L^T`` of a small symmetric matrix, unrolled; L, and the inverse of d.

    Every pivot of ``d`` must exceed ``threshold``; a tracer guards that. A row that is ``held`` has another inverse,
    which may be 0: that of ``d + inertia / share``. Then that is eliminated of the row by it, and no more.
    """
    n, held = M.shape[0], held or {}
    d: list[Value] = []
    inverse: list[Value] = []
    L, whole = identity(n), M.copy()
    for j in range(n):
        scaled = [whole[j, k] if k in held else L[j, k] * d[k] for k in range(j)]
        pivot = M[j, j] - dot(scaled, L[j, :j])
        share, inertia = (held[j].share, held[j].inertia) if j in held else (1.0, 0.0)
        if tracer and (isinstance(pivot, Node) or not pivot > 0):
            tracer.guard(share * (pivot - threshold) + inertia)
        d.append(pivot)
        inverse.append(share / (share * pivot + inertia))
        for i in range(j + 1, n):
            whole[i, j] = M[i, j] - dot(scaled, L[i, :j])
            L[i, j] = whole[i, j] * inverse[j]
    return L, inverse


def forward(L: Array, b: Array) -> Array:
    """``L^-1 b`` of a unit lower triangle; ``b`` may have columns."""
    x = array(b.copy(), b.shape)
    for i in range(L.shape[0]):
        for k in range(i):
            x[i] = x[i] - L[i, k] * x[k]
    return x


def backward(L: Array, b: Array) -> Array:
    """``L^-T b`` of a unit lower triangle."""
    x = array(b.copy(), b.shape)
    for i in reversed(range(L.shape[0])):
        for k in range(i + 1, L.shape[0]):
            x[i] = x[i] - L[k, i] * x[k]
    return x


def scale_rows(x: Array, factors: Vector) -> Array:
    """Row ``i`` of ``x`` times ``factors[i]``."""
    return array([x[i] * factors[i] for i in range(len(factors))], x.shape)


def solve(factor: Factor, b: Array) -> Array:
    """``M^-1 b`` of a factorised ``M``; ``b`` may have columns."""
    L, inverse = factor
    return backward(L, scale_rows(forward(L, b), inverse))
