"""What estimators may be told of joints: by encoders the coordinates that add up, of the others the pose."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..topology.chain import Chain
from ..topology.joint_coordinates import JointPlace


class PoseSensor(NamedTuple):
    """What may be measured of a joint whose coordinates do not add up: its attitude and angular rates.

    The names of the measurements begin with ``word``, where it is the sensor of this ``number``. The angular rates are
    the first three of such a joint. In space the position of the link is measured, too.
    """

    word: str
    number: int
    part: JointPlace

    @property
    def position(self) -> bool:
        """Whether the position is measured."""
        return self.part.joint.in_space

    def turn(self, q: np.ndarray) -> np.ndarray:
        """The quaternion (4,) among the coordinates of the robot."""
        first = self.part.q.start + (self.part.joint.turn_at or 0)
        return q[first : first + 4]


POSE_SIZES = {"position": (3, 3, 3), "attitude": (4, 1, 3), "rate": (3, 3, 3)}
"""How many values, flags and variances a measurement of a pose has."""


def pose_sensors(chain: Chain) -> list[PoseSensor]:
    """One for each of these joints, that of the base first."""
    found: list[PoseSensor] = []
    for part in chain.curved:
        word = "base" if part.joint.in_space else "joint"
        found.append(PoseSensor(word, sum(one.word == word for one in found), part))
    return found


def pose_measurements(chain: Chain) -> dict[str, tuple[int, int, int]]:
    """How many values, flags and variances every measurement of poses has, those of joints one after the other."""
    out: dict[str, tuple[int, int, int]] = {}
    for one in pose_sensors(chain):
        for what, sizes in POSE_SIZES.items():
            if what != "position" or one.position:
                values, flags, variances = out.get(f"{one.word}_{what}", (0, 0, 0))
                out[f"{one.word}_{what}"] = values + sizes[0], flags + sizes[1], variances + sizes[2]
    return out


def encoders(chain: Chain) -> list[tuple[int, int]]:
    """What every encoder measures: the index of a coordinate in `q`, and that of its rate in `v`."""
    flat = dict(zip(chain.flat_v.tolist(), chain.flat_q.tolist(), strict=True))
    return [(flat[k], k) for k in chain.effort_places if k in flat]
