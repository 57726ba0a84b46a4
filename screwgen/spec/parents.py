"""The links that carry others: a tree of names."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

from .names import link_name
from .values import quoted, refuse

WORLD = "world"
"""The parent of a link that no link carries, and the name of none."""


class Named(Protocol):
    """What this module reads of a link."""

    @property
    def name(self) -> str: ...

    @property
    def parent(self) -> str | None: ...


def parent_name(value: Any) -> str:
    """The name of a link, or "world"."""
    return link_name(value)


def parents(links: Sequence[Named]) -> tuple[int, ...]:
    """The number of the link that carries each link, -1 for none.

    Refuses a parent that does not come before it, and a link that is called as the world is.
    """
    places: dict[str, int] = {}
    out = []
    for i, link in enumerate(links):
        if link.name == WORLD:
            what = f"is {quoted(WORLD)}, which as a parent is the inertial frame; choose another name"
            raise refuse(what, at=("links", i, "name"))
        if link.parent is None or link.parent == WORLD:
            out.append(i - 1 if link.parent is None else -1)
        elif link.parent not in places:
            raise refuse(_unknown(link.parent, [x.name for x in links], i, list(places)), at=("links", i, "parent"))
        else:
            out.append(places[link.parent])
        places[link.name] = i
    return tuple(out)


def _unknown(name: str, names: Sequence[str], i: int, before: Sequence[str]) -> str:
    wrong = {True: "comes later", False: "is no link"}[name in names]
    wrong = "is the link itself" if name == names[i] else wrong
    known = " or ".join(map(quoted, [*before[-8:], WORLD]))
    return f"is {quoted(name)}, which {wrong}; a link comes after the one that carries it: {known}"
