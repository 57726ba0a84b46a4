"""Internal states of forces between frames in generated C: their rates in a state or over a step, and the slopes."""

from __future__ import annotations

from collections.abc import Callable

from ...algorithms.robot_programs import force_rate_slopes, force_rates
from ...ir.program import Program
from ...ir.split import KEPT
from ...topology.chain import Chain
from .code import Place, entries
from .pieces import piece_place, pieces
from .stumpff_slopes import slopes as stumpff_slopes

POINTERS = ("c", "state", "input", "start", "dt", "kept")
STEP = {"start": entries("start"), "h": lambda k: "dt"}
SWITCH = "on"


def content(chain: Chain, baked: bool, place: Place) -> dict[str, object]:
    """The templates' context: ``count`` of states, ``first``, where in the internal states they begin; ``rates`` and
    ``slopes``, the statements that find these, and ``by``, what the latter are; None without any."""
    if not chain.n_force_states:
        return {"force_states": None}
    constants = "baked" if baked else "constants"
    count = chain.n_force_states
    rates, slopes = force_rates(chain, constants), force_rate_slopes(chain, constants)
    by = {name: entries(name) for name in slopes.outputs}
    made = pieces(rates, _place(chain, place, {"rate": entries("rate")}), (*POINTERS, "rate"))
    own = {"count": count, "first": chain.n_internal - count, "laws": chain.n_internal > count, "rates": made}
    own |= {"whose": _whose(chain)}
    own |= {"stumpff": stumpff_slopes([slopes]), "by": list(by)}
    return {"force_states": own | {"slopes": pieces(slopes, _place(chain, place, by), (*POINTERS, *by))}}


def _whose(chain: Chain) -> str:
    """What has these states, for comments."""
    if not chain.n_held_states:
        return "the forces' internal states"
    every = chain.n_held_states == chain.n_force_states
    return "the inputs' internal states" if every else "the internal states of forces and inputs"


def switches(chain: Chain) -> bool:
    """Whether a rate calls `on`."""
    return bool(chain.n_force_states) and any(SWITCH in program.operations for program in _programs(chain))


def _programs(chain: Chain) -> tuple[Program, ...]:
    return force_rates(chain, "constants"), force_rate_slopes(chain)


def _place(chain: Chain, place: Place, results: dict[str, Callable[[int], str]]) -> Place:
    return piece_place(chain, KEPT, STEP | results, place)
