"""The drive of a joint axis: gear, rotor, elasticity and friction."""

from collections.abc import Iterator, Sequence
from math import inf
from typing import Annotated, Self

from pydantic import Field, model_validator

from ..elements import Added, BristleFriction, Travel
from ..elements.dahl import DahlFriction
from ..elements.gear import added_by
from ..joints.screw import Screw
from .limit import Limit
from .part import Part
from .stated import Stated, stated_numbers
from .transmission import Transmission
from .values import refuse, shown

ROTOR_ALWAYS_TURNS = "; of a cylinder as of a slide, of the rotor of an elastic drive as of an axis that turns"
RATIO = Stated(
    *("ratio", "turns of the rotor per turn of the joint", "; of cylinders rad/m; 1 if it is left out"),
    sliding="turn of the rotor per travel of the joint",
)
ROTOR = Stated(
    *("rotor inertia", "inertia of the rotor", "; of slides and cylinders without ratio the mass that moves along"),
    sliding="mass that moves with the drive",
)
LOAD = "; of an elastic gear, whose stretch tells it"
GEAR = Stated(
    *("gear stiffness", "stiffness of the gear at the joint", "; of a cylinder along it; without it the gear is rigid")
)


class FrictionMemory(Part):
    """What dry friction remembers: the deflection z of bristles that bend before they slip (the model called LuGre).

    `zdot = w - stiffness |w| z / coulomb`, and the friction is `stiffness z + damping zdot`: while both bodies stick a
    spring and a damper, where they slip steadily `coulomb`.
    """

    stiffness: Annotated[float, Stated.of(BristleFriction.KEYS["stiffness"])]
    damping: Annotated[float, Stated.of(BristleFriction.KEYS["damping"])] | None = None


class FrictionDahl(Part):
    """What dry friction remembers as metal bends, with the share `u = 1 - F/coulomb` that is left (Dahl's model).

    Where the motion goes on friction grows by `stiffness u (1 - ductility + ductility u)` per rad. Dahl's exponent is 1
    without ductility, and 2 with all of it.
    """

    stiffness: Annotated[float, Stated.of(DahlFriction.KEYS["stiffness"])]
    ductility: Annotated[float, Stated.of(DahlFriction.KEYS["ductility"], ", from 0 to 1")] | None = None


class Stribeck(Part):
    """How dry friction falls with the rate w, `coulomb + (static - coulomb) exp(-(w / velocity)²)`."""

    static: Annotated[float, Stated("static friction", "dry friction where it begins to slip", ROTOR_ALWAYS_TURNS)]
    velocity: Annotated[float, Stated("velocity", "rate over which dry friction falls")]


class FrictionBend(Part):
    """What friction has besides at high rates, `friction w / sqrt(w² + velocity²)`: the bend of strain-wave gears."""

    friction: Annotated[float, Stated("coulomb", "friction that the bend adds at high rates", ROTOR_ALWAYS_TURNS)]
    velocity: Annotated[float, Stated("velocity", "rate over which the bend of friction sets in")]


FRICTION_TABLES: dict[str, type[Part]] = {
    "memory": FrictionMemory,
    "dahl": FrictionDahl,
    "stribeck": Stribeck,
    "bend": FrictionBend,
}
"""The tables with numbers of friction."""
BRISTLES: dict[str, type[BristleFriction]] = {"memory": BristleFriction, "dahl": DahlFriction}
"""The laws of those of bristles."""


class Friction(Part):
    """Dry and viscous friction, `(viscous + coulomb / sqrt(w² + velocity²)) w` at the rate w.

    With `stribeck` dry friction falls with the rate, and with `bend` a term of the same form is added. With `load` it
    grows with the torque by which the stretch of an elastic gear loads the rotor, `load stiffness/ratio |θ/ratio - q|`.
    With `memory` or `dahl` dry friction has a state of its own, sticks truly, and has no `velocity` to smooth its sign.

    It acts on what the torque acts on: on the rotor (N·m, N·m·s/rad, rad/s) of an elastic drive, on the cylinder of a
    transmission (N, N·s/m, m/s) or the crank of a linkage, else on the joint (of a slide N, N·s/m, m/s).
    """

    coulomb: Annotated[float, Stated("coulomb", "dry friction", ROTOR_ALWAYS_TURNS)] | None = None
    viscous: Annotated[float, Stated("damping", "viscous friction", ROTOR_ALWAYS_TURNS)] | None = None
    velocity: Annotated[float, Stated("velocity", "rate over which dry friction changes its sign")] | None = None
    load: Annotated[float, Stated("friction by load", "dry friction by the torque that loads a rotor", LOAD)] | None = (
        None
    )
    memory: FrictionMemory | None = Field(
        None, description="of dry friction with bristles, as { stiffness = …, damping = … }"
    )
    dahl: FrictionDahl | None = Field(None, description="of dry friction that holds, as { stiffness = … }")
    stribeck: Stribeck | None = Field(None, description="of dry friction that falls, as { static = …, velocity = … }")
    bend: FrictionBend | None = Field(None, description="of strain-wave gears, as { friction = …, velocity = … }")

    @model_validator(mode="after")
    def _dry_over_a_velocity(self) -> Self:
        if self.coulomb is None and self.viscous is None and self.bend is None:
            raise refuse("states no friction; give { coulomb = …, velocity = … }, viscous, or both")
        if self.coulomb is None and self.load is not None:
            raise refuse("is stated without coulomb, to which it adds; state it, 0 if there is none", at=("load",))
        if self.bristles:
            self._checked_bristles()
        elif self.coulomb is None and self.stribeck is not None:
            raise refuse("is stated without coulomb, to which friction falls; state it", at=("stribeck",))
        elif self.coulomb is not None and self.velocity is None:
            raise refuse("is missing; dry friction needs the rate over which it changes its sign", at=("velocity",))
        if self.coulomb is None and self.velocity is not None:
            raise refuse("is stated without coulomb, whose sign it smooths; leave it out", at=("velocity",))
        return self

    @property
    def bristles(self) -> str:
        """The table of its bristles, empty where it has none."""
        return next((table for table in BRISTLES if getattr(self, table) is not None), "")

    def _checked_bristles(self) -> None:
        """Refuse what does not stand beside bristles."""
        if also := [table for table in BRISTLES if getattr(self, table) and table != self.bristles]:
            raise refuse(f"is stated beside {self.bristles}, and friction has one memory; leave one out", at=(also[0],))
        if not self.coulomb:
            what = "is missing" if self.coulomb is None else "is 0"
            raise refuse(f"{what}; state the friction of bristles that slip, > 0", at=("coulomb",))
        if self.velocity is not None:
            what = f"is stated beside {self.bristles}, whose bristles stick and would creep with a smooth sign"
            raise refuse(f"{what}; leave it out", at=("velocity",))

    def without_internal_states(self) -> Self:
        """The friction without its dry part where that remembers."""
        none = dict.fromkeys(("coulomb", "load", "stribeck", self.bristles))
        return self.model_copy(update=none if self.bristles else {})

    @property
    def numbers(self) -> Iterator[tuple[str, float | None]]:
        """Its runtime parameters, by their keys below this table."""
        yield from ((name, getattr(self, name, None)) for name, _ in stated_numbers(Friction))
        for table, part in FRICTION_TABLES.items():
            own = getattr(self, table, None)
            yield from ((f"{table}.{name}", getattr(own, name, None)) for name, _ in stated_numbers(part))


NO_FRICTION = Friction.model_construct()


class Drive(Part):
    """The drive of one axis. Without `stiffness` its gear is rigid: the rotor adds `ratio² rotor_inertia` to the axis.

    With `stiffness` the rotor's angle is a coordinate of its own and the torque acts on the rotor; `stiffness` and
    `damping` are those of the gear as seen at the joint. An empty table is no drive. With `transmission` a cylinder
    drives the axis, and the rotor turns by `ratio` (rad/m) per travel of it; with a ratio of 1 `rotor_inertia` is a
    mass that moves with the rod, kg. Of a four-bar linkage `ratio` is turns of the rotor per turn of the crank. The
    gear is then between the rotor and the cylinder or crank; `stiffness` and `damping` are those along its travel.
    """

    ratio: Annotated[float, RATIO] | None = None
    rotor_inertia: Annotated[float, ROTOR] | None = None
    stiffness: Annotated[float, GEAR] | None = None
    damping: Annotated[float, Stated("damping", "damping of the gear at the joint")] | None = None
    friction: Friction | None = Field(None, description="as { coulomb = …, viscous = …, velocity = … }")
    transmission: Transmission | None = Field(
        None, description="of an axis that a cylinder or a linkage drives, as { crank = …, base = …, angle = … }"
    )

    @property
    def elastic(self) -> bool:
        """Whether the rotor has a coordinate of its own."""
        return self.stiffness is not None

    def rigid(self) -> Self:
        """The drive with a rigid gear, whose load is not known."""
        friction = self.friction and self.friction.model_copy(update={"load": None})
        return self.model_copy(update={"stiffness": None, "damping": None, "friction": friction})

    @property
    def travel(self) -> Travel | None:
        """The kind of its transmission, if its ratio depends on the posture."""
        return self.transmission.kind if self.transmission else None

    @property
    def added(self) -> Added | None:
        """The coordinate that an elastic gear adds."""
        return added_by(self.travel) if self.elastic else None

    @property
    def numbers(self) -> Iterator[tuple[str, float | None]]:
        """Its runtime parameters, by their keys below this table."""
        friction = self.friction or NO_FRICTION
        yield from ((name, getattr(self, name)) for name, _ in stated_numbers(Drive))
        yield from ((f"friction.{name}", value) for name, value in friction.numbers)
        if self.transmission:
            yield from ((f"transmission.{name}", value) for name, value in self.transmission.numbers)

    def effort(self, screw: Screw) -> tuple[str, str]:
        """What the input of its axis is called, and its unit."""
        if self.travel:
            return self.travel.EFFORT_NAME, self.travel.EFFORT_UNIT
        return ("torque", "N·m") if self.elastic or screw.turn else ("force", "N")

    @property
    def reach(self) -> tuple[float, float]:
        """The coordinates of the axis between which its transmission reaches the link, rad; infinite without an end."""
        if self.transmission is None:
            return -inf, inf
        return self.transmission.kind.reach(*(value for _, value in self.transmission.numbers))

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.elastic and self.rotor_inertia is None:
            raise refuse("is missing; the rotor of an elastic drive needs its inertia, kg·m²", at=("rotor_inertia",))
        if self.ratio is not None and self.rotor_inertia is None:
            raise refuse("is stated without rotor_inertia, which it acts on; state both, or none", at=("ratio",))
        if self.damping is not None and not self.elastic:
            what = "is stated without stiffness, and a rigid gear has none"
            raise refuse(f"{what}; use the joint's damping, or friction = {{ viscous = … }}", at=("damping",))
        if self.transmission is not None and self.friction and self.friction.bristles:
            what = f"is stated of a {self.transmission.kind.SHORT}, whose friction has none"
            raise refuse(f"{what}; leave it out and state velocity", at=("friction", self.friction.bristles))
        self._checked_load()
        return self

    def _checked_load(self) -> None:
        """Refuse friction by a load that no stretch of a gear tells."""
        if self.friction is None or self.friction.load is None:
            return
        if self.transmission is not None:
            what = f"is stated of a {self.transmission.kind.SHORT}, whose friction does not know the load"
            raise refuse(f"{what}; leave it out", at=("friction", "load"))
        if not self.elastic:
            what = "is stated of a rigid gear, which has no stretch that tells the load"
            raise refuse(
                f"{what}; state the gear's stiffness and rotor_inertia, or leave it out", at=("friction", "load")
            )


def check(drives: Sequence[Drive], screws: Sequence[Screw], armature: Sequence[float] | None) -> None:
    """Refuse another number of drives than of axes, transmissions of axes that slide, and inertia stated twice."""
    if len(drives) != len(screws):
        what = f"has length {len(drives)}; it must hold one table per axis, {len(screws)}; an empty one is no drive"
        raise refuse(what, at=("drives",))
    for k, (drive, screw) in enumerate(zip(drives, screws, strict=True)):
        if drive.transmission is not None and screw.slides:
            what = (
                f"is stated of an axis along which the link slides, and a {drive.transmission.kind.SHORT} turns a link"
            )
            raise refuse(
                f"{what}; leave it out, for the force of a slide acts along it", at=("drives", k, "transmission")
            )
    for k, (drive, inertia) in enumerate(zip(drives, armature or (), strict=False)):
        if drive.rotor_inertia is not None and not drive.elastic and drive.transmission is None and inertia:
            what = f"is stated beside armature[{k}] = {shown(inertia)}, which means the same"
            raise refuse(f"{what}; leave one of them out", at=("drives", k, "rotor_inertia"))


def check_reach(drives: Sequence[Drive], limits: Sequence[Limit]) -> None:
    """Refuse limits of an axis that its four-bar linkage does not reach."""
    for k, (drive, limit) in enumerate(zip(drives, limits, strict=True)):
        least, most = drive.reach
        for name in ("lower", "upper"):
            end = getattr(limit, name)
            if end is not None and not least < end < most:
                what = f"is {shown(end)}, which the linkage of drives[{k}] does not reach"
                raise refuse(f"{what}; it must be between {least:.6g} and {most:.6g} rad", at=("limits", k, name))
