"""A link's body from finite elements: standard input data (SID), or a mesh that is reduced when the file is read."""

import os
from collections.abc import Hashable, Sequence
from pathlib import Path
from typing import Annotated, Any, Self

import numpy as np
from pydantic import ConfigDict, Field, PlainValidator, ValidationInfo, model_validator

from ..errors import RobotFileError
from ..reduction import INTERFACES
from ..reduction.invariants import Invariants
from ..reduction.standard import load_sid
from .modes import DIRECTIONS
from .part import Part
from .ranges import within
from .stations import checked
from .values import choice, count, refuse, shown

FOLDER = "folder"
"""The key of the validation context under which the folder of the robot file stands."""
MESH = ("modes", "frequency", "interface")
ELASTIC = "elastic"
"""The direction of the modes of a body from a file, which have no single one."""
FILE = "De"
"""The damping matrix of a body's file."""
OF_A_ROD = ("length", "frame_at", "section", "rest")


def text(value: Any) -> str:
    """A text that is not empty."""
    if not isinstance(value, str) or not value or "\0" in value:
        raise refuse(f"is {shown(value)}; it must be a text that is not empty")
    return value


class Reduced(Part):
    """A flexible body given by numbers: `sid` or `npz` names a file, its path relative to the robot file.

    `base` and `tip` name the nodes (SID) or node sets (npz) at which the joint holds the body and the next link is
    mounted. F_i sits at the base, in its axes. The numbers are constants of the generated code.
    """

    model_config = ConfigDict(arbitrary_types_allowed=True)

    sid: Annotated[str, PlainValidator(text)] | None = Field(None, description="a file of standard input data (SID)")
    npz: Annotated[str, PlainValidator(text)] | None = Field(
        None, description="a file of sparse mass and stiffness matrices, nodes and node sets"
    )
    modes: Annotated[int, PlainValidator(count)] | None = Field(
        None, description="of an npz: the number of normal modes, beside six static shapes of the tip"
    )
    frequency: Annotated[float, PlainValidator(within("frequency"))] | None = Field(
        None, description="of an npz, in place of modes: all normal modes up to this frequency, Hz"
    )
    interface: Annotated[str, PlainValidator(choice(*INTERFACES))] = Field(
        INTERFACES[0],
        description='of an npz: the tip of the normal modes, "free", "fixed" (Craig–Bampton), or "natural" (free, and '
        "no static shapes)",
    )
    base: Annotated[str, PlainValidator(text)] | None = Field(
        None, description="the node or set of the base; without it the first node, the set base"
    )
    tip: Annotated[str, PlainValidator(text)] | None = Field(
        None, description="the node or set of the tip; without it the last node, the set tip"
    )
    data: Invariants = Field(None, exclude=True, repr=False)  # type: ignore[assignment]

    @model_validator(mode="after")
    def _read(self, info: ValidationInfo) -> Self:
        if (self.sid is None) == (self.npz is None):
            raise refuse("must state one of sid and npz, the file of the body")
        if self.data is None:
            folder = Path((info.context or {}).get(FOLDER, ""))
            try:
                body = self._from_sid(folder) if self.sid is not None else self._from_npz(folder)
                body.check()
            except RobotFileError as error:
                raise refuse(f"{error}", at=("sid" if self.sid is not None else "npz",)) from None
            object.__setattr__(self, "data", body)
        return self

    def _from_sid(self, folder: Path) -> Invariants:
        for name in MESH:
            if name in self.model_fields_set and getattr(self, name) is not None:
                raise refuse("is stated beside sid, whose modes are given; leave it out", at=(name,))
        return load_sid(os.fspath(folder / str(self.sid)), self.base, self.tip)

    def _from_npz(self, folder: Path) -> Invariants:
        if (self.modes is None) == (self.frequency is None):
            raise refuse("must be stated, or frequency in its place; state one of them", at=("modes",))
        from ..reduction.finite_elements import load_npz  # with SciPy, which takes half a second

        names = self.base or "base", self.tip or "tip"
        return load_npz(os.fspath(folder / str(self.npz)), self.modes, self.frequency, self.interface, *names)


def link_body(value: Any, info: ValidationInfo) -> Any:
    """The body of a link: a table that names a file, or a rigid body made in Python."""
    if value is None or isinstance(value, Reduced):
        return value
    if isinstance(value, dict):
        return checked(Reduced, value, (), context=info.context)
    if callable(getattr(value, "moments", None)) and isinstance(value, Hashable):
        return value
    allowed = "a table with sid or npz, or a hashable Python object with moments(block)"
    raise refuse(f"is {shown(value)}; it must be {allowed}")


def elastic(link: Any) -> Invariants | None:
    """The flexible body of a link from a file; of order 1 without its geometric stiffness. None for other links."""
    if not isinstance(link.body, Reduced):
        return None
    return link.body.data.linear() if link.order == 1 else link.body.data


def directions(counts: Sequence[int], body: Invariants | None) -> tuple[tuple[str, int], ...]:
    """Direction and number (from 0) of every mode: of a rod's counts, or `elastic` of a body from a file."""
    named = dict(zip(DIRECTIONS, counts, strict=False)) | {ELASTIC: body.modes if body else 0}
    return tuple((direction, k) for direction, count in named.items() for k in range(count))


def of_link(link: Any) -> tuple[tuple[str, int], ...]:
    """Direction and number of every mode of a link."""
    return directions(link.modes.counts, elastic(link))


def damped(link: Any) -> tuple[str, ...]:
    """The terms of the damping of a link's modes: those that it states, or `FILE` where its body's file has one."""
    body = elastic(link)
    return (FILE,) if body is not None and body.damping.any() else link.damping.terms if link.damping else ()


def end(link: Any) -> np.ndarray:
    """(3,) m: a link's tip from its base, undeformed, in F_i components."""
    body = elastic(link)
    return body.tip.origin if body else np.array([link.length or 0.0, 0.0, 0.0])


def reach(link: Any) -> float:
    """The distance of a link's tip from its base, m, undeformed."""
    return float(np.linalg.norm(end(link)))


def sizes(link: Any) -> list[float]:
    """What a unit of each modal coordinate displaces: of a body from a file its tip, m, else 1 (torsion: rad)."""
    body = elastic(link)
    return [float(x) or 1.0 for x in np.linalg.norm(body.tip.phi, axis=0)] if body else [1.0] * link.modes.total


def refuse_rod(link: Any) -> None:
    """Refuse what belongs to a rod beside a body from a file, and what the file states already."""
    body = link.body
    if not isinstance(body, Reduced):
        return
    for name in OF_A_ROD:
        if getattr(link, name) is not None:
            raise refuse("is stated beside body, whose file gives it; leave it out", at=(name,))
    for name, stated in (("modes", link.modes.total), ("segments", link.segments > 1)):
        if stated:
            raise refuse("is stated beside body, which has modes of its own; leave it out", at=(name,))
    if link.damping is not None and body.data.damping.any():
        raise refuse("is stated beside body, whose file has De; leave one of them out", at=("damping",))
    if link.order == "exact":
        raise refuse('is "exact", which only rods are; leave it out beside body', at=("order",))
    if link.order == 2 and not body.data.geometric:
        raise refuse("is 2, but the body's file has no geometric stiffness; leave it out", at=("order",))


def refuse_axes(robot: Any) -> None:
    """Refuse a body whose tip has axes of its own in a robot whose tip frames keep those of their links."""
    for link in robot.links:
        body = elastic(link)
        if body and not robot.section_rotation and not np.array_equal(body.tip.axes, np.eye(3)):
            what = f"is false, but the tip of link '{link.name}' has axes of its own (AP)"
            raise refuse(f"{what}; set it to true", at=("section_rotation",))
