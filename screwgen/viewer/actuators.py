"""What pulls and pushes the links of a scene: tendons along them, and cylinders across their joints."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ..elements.cylinder import Cylinder
from ..spec.robot import Link
from ..spec.segments import Segment
from ..spec.tendons import tendon_classes

PLACES = 17
"""Along a tendon, at which it is drawn."""
ABOVE = 1.04
"""Where a tendon runs inside the tube that is drawn, it is shown at this many radii from the centreline."""


def tendons(link: Link, segment: Segment, values: Mapping[str, float], radius: float) -> Iterator[dict[str, Any]]:
    """The tendons along a link or segment: where along it, and their offsets [y, z] from the centreline there, m."""
    for piece in tendon_classes(link, segment.number) if segment.marker is None else ():
        name = f"{link.name}.tendons[{piece.number}].at"
        ends = np.array([[values[f"{name}[{end}][{axis}]"] for axis in (1, 2)] for end in (0, 1)])
        share = np.linspace(*piece.mixed, PLACES)[:, None]
        offsets = (1 - share) * ends[0] + share * ends[1]
        size = np.linalg.norm(offsets, axis=1, keepdims=True)
        outward = ends[int(np.argmax(np.linalg.norm(ends, axis=1)))]
        way = np.where(size > 1e-9, offsets / np.maximum(size, 1e-9), outward / np.linalg.norm(outward))
        shown = np.where(size < ABOVE * radius, ABOVE * radius * way, offsets)
        yield {"places": np.linspace(*piece.span, PLACES).tolist(), "offsets": shown.tolist()}


def cylinders(
    link: Link, segment: Segment, screws: list[dict[str, Any]], reach: np.ndarray, values: Mapping[str, float]
) -> Iterator[dict[str, Any]]:
    """The cylinders at a link's joint: the number of the axis, and both eyes about the joint point, m.

    ``carrier``: the eye on the carrier, in axes before the joint turned about this axis; ``link``: that on the link,
    in axes behind it. A file states the angle between the two alone: here the link's is along its centreline.
    """
    for k, drive in enumerate(link.joint.drives or () if segment.first and segment.marker is None else ()):
        if not isinstance(drive.travel, Cylinder):
            continue
        stated = f"{link.name}.joint.drives[{k}].transmission."
        crank, base, angle = (values[stated + key] for key in ("crank", "base", "angle"))
        axis = np.array(screws[k]["axis"]) / np.linalg.norm(screws[k]["axis"])
        along = across(reach, axis)
        back = Rotation.from_rotvec(-angle * axis).apply(along)
        yield {"axis": k, "carrier": (base * back).tolist(), "link": (crank * along).tolist()}


def across(way: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """The unit vector across an axis that is nearest to `way`; any one where that is along the axis."""
    for x in (way, *np.eye(3)):
        flat = x - (x @ axis) * axis
        if (size := np.linalg.norm(flat)) > 1e-6 * max(float(np.linalg.norm(x)), 1e-9):
            return np.asarray(flat / size)
    raise AssertionError("one of three axes is not along another")


def eyes(
    link: dict[str, Any], found: dict[str, Any], R: np.ndarray, r: np.ndarray, q: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The eyes of a cylinder on carrier and link, (3,) each, m; `R`, `r`: the pose of the link's frame."""
    place, turn = r + R @ np.array(link["base"]), R
    for k in range(len(link["screws"]) - 1, found["axis"] - 1, -1):
        screw, x = link["screws"][k], q[link["joint"] + k]
        if k == found["axis"]:
            on_link = place + turn @ np.array(found["link"])
        turn = turn @ Rotation.from_rotvec(-x * np.array(screw["axis"]) * screw["turn"]).as_matrix()
        place = place - turn @ (screw["travel"] * x * np.array(screw["axis"]))
    return place + turn @ np.array(found["carrier"]), on_link
