"""What is written of a robot in C is written once, whatever project asks for it.

An example: the functions that close loops. They are the same in every layout, in a shared library and in a filter, and
so are the slopes of accelerations and, for each layout, the functions of the links.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Any, TypeVar

from ...topology.chain import Chain

_T = TypeVar("_T")

WRITTEN = "_written"
"""The member of a chain under which it is kept as long as the chain; beside it the chain, as copies have others."""


def once(make: Callable[..., _T], chain: Chain, *said: Hashable) -> _T:
    """``make(chain, *said)``, made when it is first asked for; it is read only."""
    members: dict[str, Any] = vars(chain)
    if members.get(WRITTEN, (None,))[0] is not chain:
        members[WRITTEN] = (chain, {})
    kept = members[WRITTEN][1]
    if (make, said) not in kept:
        kept[make, said] = make(chain, *said)
    return kept[make, said]
