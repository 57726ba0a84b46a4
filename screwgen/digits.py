"""How many digits tell a number in double precision from all others."""

TELLING = (15, 16)
"""Digits that tell some numbers; all are told by one more."""


def telling(x: float, most: int) -> int:
    """The fewest of 15 to `most` digits with which `x` is read back as it is, or `most`: 15 of 0.3."""
    return next((k for k in TELLING if k < most and float(f"{x:.{k}g}") == x), most)
