"""Tendons in generated C: what they write in the files of every robot; empty for a robot without tendons."""

from __future__ import annotations

from itertools import accumulate

from ...algorithms.signals import CALL, Signal
from ...spec.parameters import parameters
from ...spec.tendons import tendon_names
from ...topology.chain import Chain
from ...topology.parameters import label

TENDONS = ("tendons",)
"""What tendons write, as :class:`..template_places.TemplatePlaces` finds it."""


def content(chain: Chain) -> dict[str, object] | None:
    """The templates' context: ``pieces``, the tension of every piece, link by link, and the first piece of every link,
    ``offset``; whether several pieces have one, ``shared``."""
    if not chain.n_tensions:
        return None
    offset = [0, *accumulate(len(own) for own in chain.tensions)]
    return {
        "names": tendon_names(chain.robot),
        "pieces": _pieces(chain),
        "offset": offset[:-1],
        "shared": _shared(chain),
    }


def gathered(chain: Chain) -> dict[str, Signal]:
    """The member of a call's scratch that holds the tensions of all pieces where several have one."""
    return {"tension": CALL["tension"]._replace(shape=(len(_pieces(chain)),))} if _shared(chain) else {}


def note(chain: Chain) -> str:
    """What is added to the comment of inputs."""
    names = tendon_names(chain.robot)
    return f"; then the tension of each tendon, N: {', '.join(names)}" if names else ""


def offset_comments(chain: Chain) -> dict[str, str]:
    """The comments of the constants that are offsets, by their labels."""
    own = (p for p in parameters(chain.robot) if p.field == "tendons.at")
    return {label(p): f"{p.unit}: {p.description}; of tendon {p.index[0]} of the link" for p in own}


def _pieces(chain: Chain) -> list[int]:
    return [k for own in chain.tensions for k in own]


def _shared(chain: Chain) -> bool:
    """Whether the tensions of the pieces are not those of the input in their order."""
    return _pieces(chain) != list(range(chain.n_tensions))
