"""The topology of an arm: the parent of each link."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

BASE = -1
"""The parent of links on the base."""
TIP = -1
"""In place of the number of a station: the tip."""


@dataclass(frozen=True)
class Tree:
    """``parents[i]``: the number of the link that carries link i, or ``BASE``; parents come before their children.

    Links meet in nodes: node 0 is the base, node i + 1 the tip of link i. Behind the tips come the stations, the other
    sections at which links are carried: `stations[i]` is how many link i has, `carried_at[i]` the number, among those
    of its parent, of the one that carries link i, or ``TIP``. What several links hand to one node is summed.
    """

    parents: tuple[int, ...]
    carried_at: tuple[int, ...] = ()
    stations: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        if any(not BASE <= parent < i for i, parent in enumerate(self.parents)):
            raise ValueError(f"parents {self.parents}: a link must come after the one that carries it")

    @property
    def size(self) -> int:
        """The number of nodes."""
        return len(self.parents) + 1 + sum(self.stations)

    def base(self, link: int) -> int:
        """The node that carries a link."""
        parent, station = self.parents[link], self.at(link)
        return parent + 1 if station == TIP else self.station(parent, station)

    def at(self, link: int) -> int:
        """The number of the station that carries a link, or ``TIP``."""
        return self.carried_at[link] if self.carried_at else TIP

    def station(self, link: int, number: int) -> int:
        """The node of a link's station."""
        return len(self.parents) + 1 + sum(self.stations[:link]) + number

    def tip(self, link: int) -> int:
        """The node at the tip of a link."""
        return link + 1

    def places(self, link: int) -> dict[str, int]:
        """The nodes of a link by the prefix of their signals: `base`, `tip`, and of its stations `at0`, `at1` …"""
        count = self.stations[link] if self.stations else 0
        return {"base": self.base(link), "tip": self.tip(link)} | {
            f"at{number}": self.station(link, number) for number in range(count)
        }

    @cached_property
    def leaves(self) -> list[int]:
        """The nodes that carry no link."""
        return [node for node, carried in enumerate(self.children) if not carried]

    @cached_property
    def is_chain(self) -> bool:
        """Whether every link is carried by the tip of the one before it."""
        return self.parents == tuple(range(BASE, len(self.parents) + BASE)) and not any(self.stations)

    @cached_property
    def children(self) -> list[list[int]]:
        """The links that each node carries, in their order."""
        nodes: list[list[int]] = [[] for _ in range(self.size)]
        for link in range(len(self.parents)):
            nodes[self.base(link)].append(link)
        return nodes
