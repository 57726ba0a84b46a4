"""Units as FMI has them: exponents of the SI's base units, and names in ASCII."""

from __future__ import annotations

from collections import Counter

BASE = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")
DERIVED = {
    "N": {"kg": 1, "m": 1, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3},
    "Hz": {"s": -1},
}
POWERS = {"²": 2, "³": 3}


def exponents(unit: str) -> dict[str, int]:
    """The exponents of the base units in ``N·m·s/rad``; all that is behind the first stroke is below it."""
    out: Counter[str] = Counter()
    for sign, part in zip((1, -1), _halves(unit), strict=True):
        for factor in filter(None, part.replace("/", "·").split("·")):
            power = POWERS.get(factor[-1], 1)
            symbol = factor.rstrip("".join(POWERS))
            if symbol != "1":
                for base, n in DERIVED.get(symbol, {symbol: 1}).items():
                    out[base] += sign * power * n
    unknown = set(out) - set(BASE)
    assert not unknown, f"units without exponents: {unknown}"
    return {base: out[base] for base in BASE if out[base]}


def _halves(unit: str) -> tuple[str, str]:
    above, _, below = unit.partition("/")
    return above, below


def spelled(unit: str) -> str:
    """The unit as Modelica writes it: ``N.m.s/rad``, ``kg.m2``."""
    text = unit.replace("·", ".")
    for sign, power in POWERS.items():
        text = text.replace(sign, str(power))
    return text
