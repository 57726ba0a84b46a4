"""The links of a robot as lines in space: each from the section that carries it, or from where it is mounted."""

from __future__ import annotations

import numpy as np

from ..robot_model import RobotModel
from ..spec.markers import carried_at
from ..spec.parents import parents
from ..spec.robot import Link


def feet(model: RobotModel) -> list[np.ndarray]:
    """The places (3,), m, at which links that no link carries are mounted."""
    carried = zip(model.robot.links, parents(model.robot.links), strict=True)
    return [_mount(link) for link, parent in carried if parent < 0]


def strands(model: RobotModel, lines: np.ndarray) -> list[np.ndarray]:
    """The polylines (1 + stations, 3), m, of links with the centrelines `lines` (n, stations, 3).

    The first point of each is the section of its parent that carries it, or its mount: a joint that slides moves the
    link away from it. A floating base begins where it is. Between their stations the lines are straight.
    """
    loose = lines[0, 0] if model.chain.base_v else None
    links = model.robot.links
    carried = enumerate(zip(parents(links), carried_at(links), strict=True))
    mounted = lambda i: _mount(model.robot.links[i]) if loose is None else loose  # noqa: E731
    starts = [_on(lines[parent], s) if parent >= 0 else mounted(i) for i, (parent, s) in carried]
    return [np.concatenate([start[None], line]) for start, line in zip(starts, lines, strict=True)]


def _on(line: np.ndarray, s: float) -> np.ndarray:
    """The point (3,) at s of a line (stations, 3) whose stations are at even distances."""
    whole = s * (len(line) - 1)
    first = min(int(whole), len(line) - 2)
    return line[first] + (whole - first) * (line[first + 1] - line[first]) if s < 1 else line[-1]


def _mount(link: Link) -> np.ndarray:
    mount = link.joint.mount
    return np.array(mount.xyz if mount and mount.xyz else np.zeros(3), float)
