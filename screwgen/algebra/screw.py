"""Screws: the 6 x 6 matrices that move twists between points and frames, angular part first."""

from __future__ import annotations

from .expression import Expression, block, hat, identity, zeros


def shift(r: Expression) -> Expression:
    """``[[I, 0], [-hat(r), I]]``: the twist of the point ``r`` from that of the origin."""
    return block([identity(3), zeros(3, 3)], [-hat(r), identity(3)])


def twice(R: Expression) -> Expression:
    """``blkdiag(R, R)``: turns both parts of a screw."""
    return diagonal_blocks(R, R)


def diagonal_blocks(a: Expression, b: Expression) -> Expression:
    """``blkdiag(a, b)`` of two 3 x 3 blocks."""
    return block([a, zeros(3, 3)], [zeros(3, 3), b])
