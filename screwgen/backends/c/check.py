"""The self-check of the generated C: its tolerances, and whether single precision suffices."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ...errors import UsageError
from ...integrators.method import Method
from ...topology.chain import Chain
from ..numpy import reference_sums
from ..numpy.reference import Case, rounding_error
from .code import literal

USUAL = {"single": (1e-4, 24), "double": (1e-10, 53)}
"""The usual tolerance, relative to the largest value of a kind, and the bits of each precision."""

MARGIN = 5.0
"""The factor for compiled code, whose operations may be ordered and rounded otherwise than in the emulation."""

LOOSEST = 1e-2
"""The largest tolerance: a precision that needs more is of no use for the robot."""


def content(chain: Chain, cases: list[Case]) -> dict[str, object]:
    """``tolerance`` of each precision as a C literal, and ``lost``: the relative error of float if it is too large.

    Raises :class:`UsageError` if double precision does not suffice.
    """
    needed = {name: _needed(chain, cases, *usual) for name, usual in USUAL.items()}
    if needed["double"] > LOOSEST:
        said = f"robot '{chain.robot.name}': rounding in double may change results by {percent(needed['double'])}"
        raise UsageError(f"{said}; give light links that carry heavy loads more mass, or the loads less")
    tolerance = {name: f"{min(value, LOOSEST):.0e}" for name, value in needed.items()}
    return {"tolerance": tolerance, "lost": percent(needed["single"]) if needed["single"] > LOOSEST else ""}


def sums(chain: Chain, cases: list[Case], methods: Iterable[Method]) -> dict[str, object]:
    """The :class:`Sums` of the last case as C literals, and how its state is changed for a step."""
    found = reference_sums.sums(chain, cases[-1], methods)._asdict()
    found |= {"haste": reference_sums.HASTE, "defect": reference_sums.DEFECT}
    return {name: _literals(value) for name, value in found.items()}


def _literals(value: Any) -> Any:
    return [_literals(x) for x in value] if isinstance(value, list) else literal(value)


def _needed(chain: Chain, cases: list[Case], least: float, bits: int) -> float:
    """The usual tolerance, or a multiple of the rounding error of the cases at that precision if it is larger."""
    return max(least, MARGIN * max(rounding_error(chain, case, bits) for case in cases))


def percent(part: float) -> str:
    """A fraction as a text."""
    return f"{100 * part:.0f} %" if part < 1 else "100 % or more"
