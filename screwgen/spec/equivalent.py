"""The stiffness of a uniform beam that is equivalent to measured frequencies, mode by mode."""

import math

from ..bases import ORDER
from .robot import Link
from .section import Section


def equivalent_stiffness(link: Link) -> dict[str, tuple[float, ...]]:
    """For every direction with frequencies, the stiffness of the uniform beam that has each of them, mode by mode.

    EI in N·m² for bending, `ρA (2π f_n)² / β_n⁴` with `β_n = λ_n/l`; EA in N for axial and GJ in N·m² for torsion
    modes, `ρA (2π f_n)² / β_n²` and with ρI_p. Numbers that differ much from mode to mode tell that the link
    is no uniform beam, or that something was mounted on it.
    """
    frequencies = link.modes.frequencies
    stated = frequencies.stated if frequencies else {}
    return {direction: _equivalent(link, direction, values) for direction, values in stated.items()}


def _equivalent(link: Link, direction: str, values: tuple[float, ...]) -> tuple[float, ...]:
    assert isinstance(link.section, Section) and link.length is not None  # what modes need, the file states
    inertia = link.section.rhoIp if direction == "torsion" else link.section.rhoA
    assert inertia is not None
    scale = inertia * link.length ** (2 * ORDER[direction])
    natural = link.modes.shapes(direction).stiffness
    return tuple(scale * (math.tau * f) ** 2 / k for f, k in zip(values, natural, strict=True))
