"""What sensors of acceleration feel: the acceleration less that of free fall, which inputs may change."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from ..ir.program import Value
from ..topology.chain import Chain
from .functions import Functions

if TYPE_CHECKING:
    from .measurement import Measurement


def reads(row: Measurement, chain: Chain) -> str:
    """The arguments from which a row is computed: `tau` too, where inputs change free fall and the row reads `vdot`."""
    own = row.inputs.split()
    return f"{row.inputs} tau" if chain.falls and "vdot" in own and "tau" not in own else row.inputs


def expected(row: Measurement, f: Functions, given: Mapping[str, Sequence[Value]]) -> Sequence[Value]:
    """The entries of a row; ``given`` has what it :func:`reads`, and its numbers."""
    own = row.inputs.split()
    feels = f.falling(given["tau"]) if f.chain.falls and "vdot" in own else f
    return row.value(feels, **{name: x for name, x in given.items() if name != "tau" or name in own})
