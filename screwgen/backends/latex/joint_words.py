"""What people call the joints of an arm: from the names of its links, or for a search from how the arm is built."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import numpy as np

from ...topology.chain import Chain
from ...topology.tree import BASE

CALLED = {
    "elbow": r"fore_?arm|lower_?arm|fore|elbow",
    "shoulder": r"upper_?arm|upper|shoulder",
    "wrist": r"hand|gripper|wrist(?:_?\w+)?",
    "hip": r"thigh|upper_?leg|hip",
    "knee": r"shank|shin|lower_?leg|calf|knee",
    "ankle": r"foot|ankle",
}
"""What people call the joint that carries a link of such a name."""
SIDE = r"(?:left_|right_|l_|r_)?"
ALONG = ("shoulder", "elbow", "wrist")
"""The joints of an arm from its base to its end."""
NEAR = 1e-9
"""m: what lies that near an axis lies on it."""


def called(link: str) -> str:
    """The word for the joint that carries a link, from the link's name; empty where there is none."""
    said = (word for word, names in CALLED.items() if re.fullmatch(f"{SIDE}(?:{names})(?:_link)?", link.lower()))
    return next(said, "")


def sought(chain: Chain) -> list[str]:
    """For every link the word by which a reader may look for its joint: that of its name, else of its place in an arm.

    An arm is links in a row that turn, none of them with such a name. Joints on the axes of the one before belong
    together: at the base they are the shoulder, away from it the elbow, then the wrist. More places have no words.
    """
    words = [called(name) for name in chain.names]
    for arm in [] if chain.closing.rows else _arms(chain):
        groups = [*_groups(chain, arm)]
        if len(groups) in (2, 3) and not any(words[i] for i in arm):
            for word, group in zip(ALONG, groups, strict=False):
                for i in group:
                    words[i] = word
    return words


def _arms(chain: Chain) -> Iterator[list[int]]:
    """Links in a row from the first that a joint turns to the last, where nothing branches off and nothing slides."""
    parents = chain.tree.parents
    for last in sorted(set(range(chain.n)) - set(parents)):
        row = [last]
        while parents[row[0]] != BASE:
            row.insert(0, parents[row[0]])
        while row and not chain.keys[row[0]].joints:
            row.pop(0)
        moves = [screw for i in row for screw in chain.keys[i].screws]
        if row and all(parents.count(i) <= 1 for i in row) and all(s.turn and not s.slides for s in moves):
            yield row


def _groups(chain: Chain, arm: Sequence[int]) -> Iterator[list[int]]:
    """The joints of an arm, those together that lie on the axes of the one before."""
    group: list[int] = []
    away = False
    for i in arm:
        if chain.keys[i].joints:
            if away or (group and _off(chain, i, group[-1])):
                yield group
                group = []
            group.append(i)
            away = False
        elif group:
            away = away or bool(_length(chain, i) or _off(chain, i, group[-1]))
    yield group


def _off(chain: Chain, i: int, before: int) -> bool:
    """Whether link i begins off the axes of the joint of a link before it."""
    mount = chain.robot.links[chain.segments[i].link].joint.mount if chain.segments[i].first else None
    place = np.array((mount and mount.xyz) or (0.0, 0.0, 0.0)) + np.array([_length(chain, before), 0.0, 0.0])
    axes = [np.array(screw.axis) for screw in chain.keys[before].screws] or [np.zeros(3)]
    return any(np.linalg.norm(place - (place @ axis) * axis) > NEAR for axis in axes)


def _length(chain: Chain, i: int) -> float:
    return chain.robot.links[chain.segments[i].link].length or 0.0
