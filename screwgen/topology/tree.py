"""The topology of an arm: the parent of each link."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

BASE = -1
"""The parent of links on the base."""


@dataclass(frozen=True)
class Tree:
    """``parents[i]``: the number of the link that carries link i, or ``BASE``; parents come before their children.

    Links meet in n + 1 nodes: node 0 is the base, node i + 1 the tip of link i. The contributions of several links to
    one node are summed.
    """

    parents: tuple[int, ...]

    def __post_init__(self):
        if any(not BASE <= parent < i for i, parent in enumerate(self.parents)):
            raise ValueError(f"parents {self.parents}: a link must come after the one that carries it")

    def base(self, link: int) -> int:
        """The node that carries a link."""
        return self.parents[link] + 1

    def tip(self, link: int) -> int:
        """The node at the tip of a link."""
        return link + 1

    @cached_property
    def leaves(self) -> list[int]:
        """The nodes that carry no link."""
        return [node for node, carried in enumerate(self.children) if not carried]

    @cached_property
    def is_chain(self) -> bool:
        """Whether every link is carried by the one before it."""
        return self.parents == tuple(range(BASE, len(self.parents) + BASE))

    @cached_property
    def children(self) -> list[list[int]]:
        """The links that each node carries, in their order."""
        nodes: list[list[int]] = [[] for _ in range(len(self.parents) + 1)]
        for link in range(len(self.parents)):
            nodes[self.base(link)].append(link)
        return nodes
