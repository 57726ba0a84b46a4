"""The self-check of the generated C: its tolerances, and whether single precision suffices."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import islice
from typing import Any, NamedTuple

from ...algorithms import fused
from ...errors import UsageError
from ...integrators.method import Method
from ...lazily import mpmath
from ...topology.chain import Chain
from ..numpy import reference_sums
from ..numpy.reference import Case, Rounding, assembly_error, cases
from .code import literal

USUAL = {"single": (1e-4, 24), "double": (1e-10, 53)}
"""The usual tolerance, relative to the largest value of a kind, and the bits of each precision."""

MARGIN = 3.0
"""The factor for compiled code, whose operations may be ordered and rounded otherwise than in the emulation. Of sixteen
random robots, compiled in both precisions, none had a larger error than the largest of the emulated ones."""

LOOSEST = 1e-2
"""The largest tolerance: a precision that needs more is of no use for the robot."""


GROSS = 0.5
"""The largest tolerance for what no caller needs from rounded accelerations: wrenches of inverse dynamics, and the
assembled system in float."""


STATES = 3
CANDIDATES = 9
"""How many states are recorded, and how many are looked at for them."""


class Recorded(NamedTuple):
    """A state of the self-check with its results, and its two errors by :class:`Rounding` in each precision."""

    case: Case
    errors: dict[str, tuple[float, float]]

    def suits(self, precision: str) -> bool:
        """Whether its results in a precision can be compared."""
        return MARGIN * self.errors[precision][0] <= LOOSEST


def recorded(chain: Chain) -> list[Recorded]:
    """The first STATES that single precision bears; if there are too few, those that double bears, or any."""
    found: list[Recorded] = []
    good = lambda precision: [r for r in found if r.suits(precision)]  # noqa: E731
    rounding = Rounding(chain)
    with mpmath.workdps(fused.DIGITS):
        for case in islice(cases(chain), CANDIDATES):
            found.append(Recorded(case, {x: rounding.errors(case, bits) for x, (_, bits) in USUAL.items()}))
            if len(good("single")) == STATES:
                break
    enough = len(good("single")) >= min(STATES, len(found))
    return (good("single") if enough else good("double") or found)[:STATES]


def content(chain: Chain, states: Sequence[Recorded]) -> dict[str, object]:
    """``tolerance`` of each precision as a C literal, and ``lost``: the relative error of float if it is too large.

    ``inverse``: the tolerances for the wrenches of inverse dynamics, if they need larger ones; where inputs load the
    links they are not compared. ``assembly``: that of float for the assembled system, if it needs a larger one.
    Raises :class:`UsageError` if double precision does not suffice.
    """
    errors = {name: [state.errors[name] for state in states] for name in USUAL}
    needed, inverse = ({name: _needed(name, errors[name], k) for name in USUAL} for k in (0, 1))
    if needed["double"] > LOOSEST:
        said = f"robot '{chain.robot.name}': rounding in double may change results by {percent(needed['double'])}"
        raise UsageError(f"{said}; give light links that carry heavy loads more mass, or the loads less")
    tolerance = {name: f"{min(value, LOOSEST):.0e}" for name, value in needed.items()}
    more = {name: f"{min(max(inverse[name], needed[name]), GROSS):.0e}" for name in USUAL}
    larger = any(float(more[name]) > float(tolerance[name]) for name in USUAL)
    lost = percent(needed["single"]) if needed["single"] > LOOSEST else ""
    extent = max((x for state in states for x in state.case["extent"]), default=1.0)
    inverses = more if larger and not chain.inputs_load_links else {}
    assembly = "" if lost or not states else _assembly(chain, states, float(tolerance["single"]))
    found: dict[str, object] = {"tolerance": tolerance, "inverse": inverses, "lost": lost, "assembly": assembly}
    return found | {"extent": repr(float(f"{extent:.6g}"))}


def _assembly(chain: Chain, states: Sequence[Recorded], usual: float) -> str:
    """The tolerance of float for the assembled system as a C literal, "" if the usual one suffices."""
    needed = MARGIN * assembly_error(chain, [state.case for state in states])
    return f"{min(needed, GROSS):.0e}" if needed > usual else ""


def sums(chain: Chain, cases: Sequence[Case], methods: Iterable[Method]) -> dict[str, object]:
    """The :class:`Sums` of the last case as C literals, and how its state is changed for a step; {} without cases.

    ``stiffer``: the factor of the modes' stiffness with which rest is sought, if that of their own is too little.
    """
    if not cases:
        return {}
    found = reference_sums.sums(chain, cases[-1], tuple(methods))._asdict()
    found |= {"haste": reference_sums.HASTE}
    factor = reference_sums.stiffer(chain, cases[-1])
    stiffer = literal(factor) if factor > 1 else ""
    return {name: _literals(value) for name, value in found.items()} | {"stiffer": stiffer}


def _literals(value: Any) -> Any:
    return [_literals(x) for x in value] if isinstance(value, list) else literal(value)


def _needed(precision: str, errors: list[tuple[float, float]], kind: int) -> float:
    """The usual tolerance, or a multiple of the rounding error of the cases at that precision if it is larger."""
    return max(USUAL[precision][0], MARGIN * max((error[kind] for error in errors), default=0.0))


def percent(part: float) -> str:
    """A fraction as a text."""
    return f"{100 * part:.0f} %" if part < 1 else "100 % or more"
