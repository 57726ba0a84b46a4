"""What a document says of the elements that act on the axes of a robot (:mod:`screwgen.elements`)."""

from __future__ import annotations

from ...elements import STOP, OfElement, friction, gear, stop
from ...ir.block import Binding
from ...topology.chain import Chain
from .content import Named


def symbols(chain: Chain) -> list[Named]:
    """Their symbols."""
    stated = [*gear.SYMBOLS, *friction.SYMBOLS] if _drives(chain) else []
    stated += [symbol for kind in chain.travel_kinds for symbol in kind.SYMBOLS]
    stated += gear.TRAVEL_SYMBOLS if chain.elastic_travels else ()
    stated += stop.SYMBOLS if STOP in chain.laws else ()
    binding = {True: Binding.STATE, False: Binding.PARAMETER}
    return [(symbol, meaning, unit, "1", "-", binding[state]) for symbol, meaning, unit, state in stated]


def equations(chain: Chain) -> list[str]:
    """Their sections of text."""
    out = [gear.EQUATIONS] if _drives(chain) else []
    out += [stop.EQUATIONS] if STOP in chain.laws else []
    out += [law.kind.equations() for law in chain.laws if isinstance(law, OfElement)]
    out += [kind.EQUATIONS for kind in chain.travel_kinds]
    return out + ([gear.travel_equations(chain.travel_kinds)] if chain.elastic_travels else [])


def _drives(chain: Chain) -> bool:
    return any(key.drives for key in chain.keys)
