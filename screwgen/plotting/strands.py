"""The links of a robot as lines in space: each from the tip that carries it, or from where it is mounted."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..spec.parents import parents

if TYPE_CHECKING:
    from ..model import Model


def feet(model: Model) -> list[np.ndarray]:
    """The places (3,), m, at which links that no link carries are mounted."""
    carried = zip(model.robot.links, parents(model.robot.links), strict=True)
    return [_mount(link) for link, parent in carried if parent < 0]


def strands(model: Model, lines: np.ndarray) -> list[np.ndarray]:
    """The polylines (1 + stations, 3), m, of links with the centrelines `lines` (n, stations, 3).

    The first point of each is the tip of its parent, or its mount: a joint that slides moves the link away from it. A
    floating base begins where it is.
    """
    loose = lines[0, 0] if model.chain.floating else None
    carried = enumerate(parents(model.robot.links))
    mounted = lambda i: _mount(model.robot.links[i]) if loose is None else loose  # noqa: E731
    starts = [lines[parent, -1] if parent >= 0 else mounted(i) for i, parent in carried]
    return [np.concatenate([start[None], line]) for start, line in zip(starts, lines, strict=True)]


def _mount(link) -> np.ndarray:
    mount = link.joint.mount
    return np.array(mount.xyz if mount and mount.xyz else np.zeros(3), float)
