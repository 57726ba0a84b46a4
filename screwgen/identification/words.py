"""What the data do not determine, in words, with what would determine it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from .identification import NumberPair
from .uncertainty import NAMED, Uncertainty
from .unknowns import FreeNumber

EVEN = 0.1
"""By how much two entries of a direction may differ and count as equal."""
FEW = 4
"""Numbers of a direction that are named."""
TOGETHER = 0.7
"""The correlation from which on numbers are named as a pair: half of the variance of one is that of the other."""
SCALE = "forces and masses have no scale"
SCALED = "state the gain of a drive, or weigh a part"
REMEDIES = (
    (".gain", "state the gain of the drive, or a mass that was weighed"),
    (".scale", "load the arm with a known weight, and state the scale of the gauge"),
    (".offset", "read the sensors at rest in two postures"),
    (".bias", "log the drive at rest with both signs of the friction"),
    (".delay", "log a sharp motion, or measure the delay of the logger"),
    ("gravity", "level the base, or read the sensors at rest in two postures"),
    ("friction.velocity", "log slow motions that turn round"),
    ("friction", "log steady motions at several rates"),
    ("damping", "log a free vibration"),
    ("rotor_inertia", "take the rotor inertia from the data sheet of the motor"),
    ("ratio", "take the ratio from the data sheet of the gear"),
    ("density", "weigh the part"),
    ("nu", "twist the link with a known moment"),
    ("profile.E", "load the link with a known weight"),
    ("mass", "weigh the part"),
    ("inertia", "swing the part as a pendulum"),
    ("com", "balance the part"),
    ("EIy", "load the link along z with a known weight"),
    ("EIz", "load the link along y with a known weight"),
    ("GJ", "twist the link with a known moment"),
)
"""By a piece of a name what determines such a number; the first that fits counts."""

VIBRATE = "log a free vibration, which tells the stiffness alone, or state the scale of the gauge"
BETWEEN = ((".scale", ("EI", "profile.E"), VIBRATE),)
"""By pieces of two names what tells such numbers apart, where what determines one alone does not: under a known weight
a gauge reads the same of a link twice as stiff if its scale is twice as large."""


def direction_in_words(unknowns: Sequence[FreeNumber], direction: np.ndarray, size: float) -> str:
    """A direction that the data do not determine: changes (k,) of what is sought, and their deviation."""
    named = [k for k in np.argsort(-np.abs(direction), kind="stable") if abs(direction[k]) >= NAMED]
    own = [unknowns[k] for k in named]
    what = _what(own, direction[named])
    return f"{what}; {SCALED if what.endswith(SCALE) else remedy(own)}"


def pairs(unknowns: Sequence[FreeNumber], known: Uncertainty) -> tuple[NumberPair, ...]:
    """Those whose errors have a correlation r of TOGETHER or more, the strongest first.

    With one of them known the deviation of the other is smaller by sqrt(1 - r²).
    """
    left = {k for direction, _ in known.directions for k in np.flatnonzero(np.abs(direction) >= NAMED)}
    found = [
        (float(known.correlation[i, j]), unknowns[i], unknowns[j])
        for i, j in combinations(range(len(unknowns)), 2)
        if not {i, j} & left
    ]
    return tuple(
        NumberPair(a.name, b.name, r, float(max(1 - r * r, 1e-12) ** -0.5), remedy((a, b)))
        for r, a, b in sorted(found, key=lambda x: -abs(x[0]))
        if abs(r) >= TOGETHER
    )


def _what(own: Sequence[FreeNumber], entries: np.ndarray) -> str:
    names = [one.name for one in own]
    if len(own) == 1:
        return f"{names[0]} leaves hardly a trace in the data"
    logarithms = all(one.logarithmic for one in own)
    if len(own) == 2 and logarithms and abs(abs(entries[1] / entries[0]) - 1) < EVEN:
        kind = "ratio" if entries[0] * entries[1] > 0 else "product"
        return f"{names[0]} and {names[1]} are known only as a {kind} ({entries[1] / entries[0]:+.2f})"
    if len(own) > FEW and logarithms and (entries * entries[0] > 0).all() and abs(entries[FEW]) > abs(entries[0]) / 2:
        return f"{_list([*names[:3], f'{len(names) - 3} more'])} can all grow together: {SCALE}"
    more = f", and a little of {len(own) - FEW} more" if len(own) > FEW else ""
    changes = ", ".join(f"{one.name} by {_change(one, x)}" for one, x in zip(own[:FEW], entries, strict=False))
    return f"only together are known {_list(names[:FEW])}: the data hardly change with {changes}{more}"


def _change(one: FreeNumber, x: float) -> str:
    """A small change of a number along a direction: of 10 % of its logarithm or scale."""
    return f"{10 * x:+.3g} %" if one.logarithmic else f"{0.1 * x * one.scale:+.3g} {one.unit}".rstrip()


def _list(names: Sequence[str]) -> str:
    return f"{', '.join(names[:-1])} and {names[-1]}"


def remedy(own: Sequence[FreeNumber]) -> str:
    """What would determine one of these numbers."""
    names = [one.name for one in own]
    for piece, others, said in BETWEEN:
        if any(piece in x for x in names) and any(other in x for x in names for other in others):
            return said
    found = [said for one in own for piece, said in REMEDIES if piece in one.name][:1]
    return found[0] if found else "leave one of them out of what is free, or state what is known of it as a prior"
