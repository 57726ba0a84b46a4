"""Units as FMI has them: exponents of the SI's base units, and names in ASCII."""

from __future__ import annotations

from collections import Counter

BASE = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")
DERIVED = {
    "N": {"kg": 1, "m": 1, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3},
    "Hz": {"s": -1},
    "Pa": {"kg": 1, "m": -1, "s": -2},
    "C": {"A": 1, "s": 1},
    "V": {"kg": 1, "m": 2, "s": -3, "A": -1},
    "Ω": {"kg": 1, "m": 2, "s": -3, "A": -2},
    "F": {"kg": -1, "m": -2, "s": 4, "A": 2},
    "H": {"kg": 1, "m": 2, "s": -2, "A": -2},
    "Wb": {"kg": 1, "m": 2, "s": -2, "A": -1},
    "T": {"kg": 1, "s": -2, "A": -1},
}
POWERS = {"²": 2, "³": 3}


def exponents(unit: str) -> dict[str, int] | None:
    """The exponents of the base units in ``N·m·s/rad``; all that is behind the first stroke is below it.

    None of a unit with a factor that the SI has not, as a force of one's own may have: its name alone is known.
    """
    out: Counter[str] = Counter()
    for sign, part in zip((1, -1), _halves(unit), strict=True):
        for factor in filter(None, part.replace("/", "·").split("·")):
            power = POWERS.get(factor[-1], 1)
            symbol = factor.rstrip("".join(POWERS))
            if symbol != "1":
                for base, n in DERIVED.get(symbol, {symbol: 1}).items():
                    out[base] += sign * power * n
    return {base: out[base] for base in BASE if out[base]} if set(out) <= set(BASE) else None


def _halves(unit: str) -> tuple[str, str]:
    above, _, below = unit.partition("/")
    return above, below


def spelled(unit: str) -> str:
    """The unit as Modelica writes it: ``N.m.s/rad``, ``kg.m2``."""
    text = unit.replace("·", ".").replace("Ω", "Ohm")
    for sign, power in POWERS.items():
        text = text.replace(sign, str(power))
    return text
