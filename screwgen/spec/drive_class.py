"""What drives and stops of a joint state, without their numbers: their part of a link class."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ..elements import BEND, FALLING, FALLING_LOADED, FRICTION, LOADED, STOP, Law, Size, Travel
from .axis_laws import SIDES
from .drive import BRISTLES, NO_FRICTION
from .joint import Joint

DRY = {law.size: law for law in (FRICTION, FALLING, LOADED, FALLING_LOADED)}
"""Dry friction without bristles, by what its size depends on."""
LAWS_OF_KEYS: tuple[Law, ...] = (*DRY.values(), STOP, BEND, *(law(size) for law in BRISTLES.values() for size in DRY))
"""The laws of what drives and limits state; others are those of elements."""


@dataclass(frozen=True)
class DriveClass:
    """What the drive of an axis states."""

    ratio: bool = False
    rotor_inertia: bool = False
    stiffness: bool = False
    damping: bool = False
    coulomb: bool = False
    viscous: bool = False
    bristles: str = ""
    """The table of its bristles, if friction has any."""
    of_bristles: tuple[str, ...] = ()
    """The keys of that table that it states."""
    stribeck: bool = False
    load: bool = False
    bend: bool = False
    travel: Travel | None = None
    """Its transmission, if its ratio depends on the posture."""

    @property
    def elastic(self) -> bool:
        """Whether its gear is, which then adds a coordinate."""
        return self.stiffness

    @property
    def size(self) -> Size:
        """What the size of its dry friction depends on."""
        return Size(self.stribeck, self.load)

    @property
    def frictions(self) -> Iterator[tuple[Law, tuple[str | None, ...]]]:
        """The laws of its friction but for what is viscous, and the numbers that each is made of, None for zero."""
        own = ("stribeck_static", "stribeck_velocity") * self.stribeck
        own += ("load", "stiffness", *["ratio"] * self.ratio) * self.load
        if law := BRISTLES.get(self.bristles):
            names = (f"{self.bristles}_{key}" if key in self.of_bristles else None for key in law.KEYS)
            yield law(self.size), (*names, "coulomb", *own)
        elif self.coulomb:
            yield DRY[self.size], ("coulomb", "velocity", *own)
        if self.bend:
            yield BEND, ("bend_friction", "bend_velocity")

    def stated(self, name: str) -> float:
        """1 for a key that it states, and for the ratio, else 0: what formulas are of these is there or not."""
        return float(getattr(self, name) or name == "ratio")


Stop = tuple[int, str]
"""A compliant stop: the axis, and the limit at which it acts, "lower" or "upper"."""


def drive_classes(joint: Joint) -> tuple[DriveClass, ...]:
    """What the drives of a joint state, axis by axis; none where they state nothing."""
    out = []
    for drive in joint.drives or ():
        friction = drive.friction or NO_FRICTION
        stated = {name: getattr(drive, name) is not None for name in ("ratio", "rotor_inertia", "stiffness", "damping")}
        stated |= {
            name: getattr(friction, name) is not None for name in ("coulomb", "viscous", "load", "stribeck", "bend")
        }
        table = friction.bristles and getattr(friction, friction.bristles)
        of_bristles = tuple(name for name, value in table or () if value is not None)
        out.append(DriveClass(**stated, bristles=friction.bristles, of_bristles=of_bristles, travel=drive.travel))
    return tuple(out) if any(drive != DriveClass() for drive in out) else ()


def stops(joint: Joint) -> tuple[Stop, ...]:
    """The stops of a joint, axis by axis."""
    firm = [(axis, x) for axis, x in enumerate(joint.limits or ()) if x.stiffness is not None]
    return tuple((axis, side) for axis, x in firm for side in SIDES if getattr(x, side) is not None)
