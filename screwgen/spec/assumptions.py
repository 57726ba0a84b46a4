"""What the models of links assume and leave out, in sentences that follow from the classes of the links.

Documents, comments of generated C and its README say these sentences, so that none of them speaks of another model than
the robot's.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from .link_class import EXACT, LinkClass

Condition = Callable[[LinkClass], bool]

FEW = 6
"""Of more links in a sentence only the first are named."""
RIGID = "All links are rigid."


def _is_rod(key: LinkClass, order: int | str) -> bool:
    return key.modes > 0 and key.elastic is None and key.order == order


def _bends(key: LinkClass) -> bool:
    return key.elastic is None and any(key.counts[1:3])


SENTENCES: tuple[tuple[Condition, str], ...] = (
    (
        lambda key: _is_rod(key, 1),
        "The shape of {} is linear in the modal coordinates: deflections must stay small against the length.",
    ),
    (
        lambda key: _is_rod(key, 1) and _bends(key),
        "The bending of {} has no foreshortening: rotation does not stiffen it, and axial loads neither stiffen nor "
        "buckle it.",
    ),
    (
        lambda key: _is_rod(key, 2),
        "The shape of {} is of second order in the modal coordinates, and the energy keeps what is of degree two in "
        "them: foreshortening, centrifugal stiffening and the effect of axial loads on bending are included, and "
        "deflections must stay moderate.",
    ),
    (
        lambda key: _is_rod(key, EXACT),
        "The strains of {} are linear in the modal coordinates, and rotations and places of the sections follow from "
        "them without expansion: deflections may be large.",
    ),
    (
        lambda key: bool(key.rest),
        "The shape of {} without loads is curved or twisted, by numbers among the parameters: strains are measured "
        "from there.",
    ),
    (
        lambda key: _bends(key) and len(key.counts) > 4,
        "The sections of {} shear (Timoshenko).",
    ),
    (
        lambda key: _bends(key) and len(key.counts) <= 4,
        "The sections of {} stay at right angles to the centreline (Euler-Bernoulli).",
    ),
    (
        lambda key: key.elastic is not None and not key.elastic.geometric,
        "The displacements of {} are those of a file, linear in the modal coordinates: deflections must stay small, "
        "and neither rotation nor axial loads change the stiffness.",
    ),
    (
        lambda key: key.elastic is not None and key.elastic.geometric,
        "The displacements of {} are those of a file, to second order in the modal coordinates: geometric stiffness is "
        "included, and deflections must stay small.",
    ),
    (
        lambda key: bool(key.tendons) and key.order == 1,
        "Tendons along {} slide without friction, and their lengths are linear in the modal coordinates.",
    ),
    (
        lambda key: bool(key.tendons) and key.order != 1,
        "Tendons along {} slide without friction, and their lengths are those along the bent link.",
    ),
)
"""Which links a sentence is about, and the sentence."""


def assumptions(pairs: Sequence[tuple[str, LinkClass]], quote: str = "'") -> list[str]:
    """The sentences about links, or segments of links, by name and class; names stand between ``quote``."""
    of: Callable[[Condition], list[str]] = lambda holds: list(dict.fromkeys(x for x, key in pairs if holds(key)))  # noqa: E731
    every, flexible = of(lambda key: True), of(lambda key: key.modes > 0)
    if not flexible:
        return [RIGID]
    out = []
    for holds, sentence in SENTENCES:
        if about := of(holds):
            all_of_them = "the links" if about == every else "the flexible links"
            out.append(sentence.format(all_of_them if about == flexible and len(about) > 1 else _named(about, quote)))
    return out


def _named(names: Sequence[str], quote: str) -> str:
    shown = [f"{quote}{name}{quote}" for name in names[:FEW]]
    shown += [f"{len(names) - FEW} more"] if len(names) > FEW else []
    return f"link {shown[0]}" if len(shown) == 1 else f"links {', '.join(shown[:-1])} and {shown[-1]}"
