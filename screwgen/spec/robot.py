"""The robot as a frozen, validated description: the content of a robot file.

Presence has meaning. `None` is what the file omits: structurally zero, free of cost in generated code. A
stated 0.0 is a runtime parameter that happens to be zero. SI units and radians throughout; the frames are
those of NOTATION.md.
"""

from typing import Annotated, Any, ClassVar, Self

from pydantic import Field, PlainSerializer, PlainValidator, model_validator

from ..errors import UsageError
from ..joints.screw import Vector
from .balls import refuse_beside_balls
from .base import FIXED, FLOATING, MOVING, check_accelerated, check_in_space
from .couplings import Coupling, refuse_couplings
from .forces import Force, Push, forces_of_loops, refuse_forces
from .frequencies import Frequencies
from .input import made_in_python
from .joint import XYZ, Joint
from .loops import Loop, refuse_loops
from .markers import TIP, Marker, Place, carried_at, check_markers, marker, written
from .modes import DIRECTIONS, NEEDS, SHEARED, Modes
from .names import distinct, link_name, robot_name
from .needs import require, require_divisible, require_rigid, require_uniform, segment_count
from .parents import parent_name, parents
from .part import Part
from .physics import inertia
from .profile import profiled
from .reduced import link_body, of_link, refuse_axes, refuse_rod
from .rest import AnyRest, refuse_rest
from .segments import distinct_names
from .sensor import sensors_in_python
from .stated import Stated, stated_numbers
from .stations import AnySection
from .tendons import Tendon, refuse_tendons
from .values import boolean, choice, refuse, shape_order

CENTRE = Stated("position", "centre of mass", ", from the point where the body sits", components=XYZ)
Tensor = tuple[float, float, float, float, float, float]
INERTIA = Stated(
    *("inertia", "inertia about the centre of mass", ": [xx, yy, zz, xy, xz, yz], with xy = −∫ x y dm"),
    components=("xx", "yy", "zz", "xy", "xz", "yz"),
    check=inertia,
)
End = Annotated[str, PlainValidator(choice("base", "tip"))]

STATE_SECTION = "state the section, at least { rhoA = … } or { density = …, area = … }"


class Damping(Part):
    """Damping of the modes: `ratio` ζ of each of the link's own base-clamped, unloaded ones, `time` of the material.

    D_kk = 2 ζ √(K_kk M_kk) of the ratio (1: critical), and by Kelvin and Voigt the whole matrix `time` K.
    """

    ratio: Annotated[float, Stated("damping ratio", "damping ratio of each mode")] | None = None
    time: Annotated[float, Stated("damping time", "damping of the modes over their stiffness")] | None = None

    @property
    def terms(self) -> tuple[str, ...]:
        """The names of those that are stated."""
        return tuple(name for name, _ in stated_numbers(Damping) if getattr(self, name) is not None)

    @model_validator(mode="after")
    def _of_one_term_at_least(self) -> Self:
        if not self.terms:
            raise refuse("states nothing; state ratio or time, or leave damping out")
        return self


class Body(Part):
    """A rigid body fixed to a link's base or tip section.

    Components are in F_i axes from the joint point at "base", in tip-frame axes from the tip point at "tip".
    `mass` (kg, >= 0; zero with an inertia is the ideal rotor whose mass is counted elsewhere), `com` (m),
    `inertia` [xx, yy, zz, xy, xz, yz] about the centre of mass (kg·m²); products are the tensor's entries.
    """

    at: End = Field(description='where the body sits, "base" or "tip"')
    mass: Annotated[float, Stated("mass", "mass of the body")]
    com: Annotated[Vector, CENTRE] | None = None
    inertia: Annotated[Tensor, INERTIA] | None = None


LENGTH = Stated("length", "length of the undeformed centreline", "; a link without a section can do without")
FRAME_AT = Stated("frame_at", "distance from the link's base to its frame's origin", ", along the centreline")


class Link(Part):
    """One flexible or rigid link and the joint that carries it.

    `length` (m) of the undeformed centreline; `frame_at` (m) from its base to the link frame's origin,
    a = −frame_at. No `modes`: rigid. A rigid link without `section` has the mass of its `bodies` alone; without
    `length` its tip is at the joint. In Python, `body` may be a rigid body of one's own (`bodies.contract`).
    With `segments` the link is split into as many equal pieces, each with these modes and this damping of its modes;
    length, section, joint and bodies remain those of the link.
    """

    other_keys: ClassVar = {"profile": "in place of section: a tube, rod or box of a material"}

    name: Annotated[str, PlainValidator(link_name)] = Field(description="the link's name, a C identifier")
    length: Annotated[float, LENGTH] | None = None
    frame_at: Annotated[float, FRAME_AT] | None = None
    section: AnySection | None = Field(
        None,
        description="the section, at least { rhoA = … } or { density = …, area = … }, or an array of stations; "
        "without it only bodies have mass",
    )
    modes: Modes = Field(Modes(), description="how many mode shapes; without it the link is rigid")
    damping: Damping | None = Field(None, description="damping of the modes, as { ratio = 0.01 } or { time = 0.001 }")
    order: Annotated[int | str, PlainValidator(shape_order)] | None = Field(
        None, description="the order of the link's shape, 1, 2 or \"exact\"; without it the robot's"
    )
    rest: AnyRest | None = Field(
        None,
        description='curvature of a link of order "exact" where nothing loads it, as { bending_y = 2.0 }, or an array '
        "of stations; without it the link is straight",
    )
    segments: Annotated[int, PlainValidator(segment_count)] = Field(
        1, description="number of equal segments, welded to each other, each with these modes, for large deflections"
    )
    parent: Annotated[str, PlainValidator(parent_name)] | None = Field(
        None, description='the link that carries this one, "world" for none; without it the link before'
    )
    at: Annotated[str | Place, PlainValidator(marker), PlainSerializer(written)] = Field(
        "tip", description='where on its parent the joint sits: "tip", "base", { s = 0.4 } or the name of a marker'
    )
    markers: tuple[Marker, ...] = Field((), description='named places, as { name = "hook", at = 0.7 }')
    tendons: tuple[Tendon, ...] = Field((), description="threads along the link that pull, an array of tables")
    joint: Joint = Field(description='the joint, as { axes = ["z"] }')
    bodies: tuple[Body, ...] = Field((), description="rigid bodies on the link, an array of tables")
    body: Annotated[Any, PlainValidator(link_body)] = Field(
        None, description="in place of length and section: a flexible body from finite elements"
    )

    @model_validator(mode="before")
    @classmethod
    def _section_of_profile(cls, data: Any) -> Any:
        return profiled(data)

    @model_validator(mode="after")
    def _section_along_a_length(self) -> Self:
        refuse_rod(self)
        if self.length is None and (self.section is not None or self.frame_at is not None):
            raise refuse("is missing; state the length of the centreline, m", at=("length",))
        if self.section is None and self.modes.total:
            raise refuse(f"is missing; {STATE_SECTION}", at=("section",))
        if self.section is None and not self.bodies and self.body is None:
            raise refuse(f"is missing; {STATE_SECTION}, or bodies", at=("section",))
        return self

    @model_validator(mode="after")
    def _frame_on_centreline(self) -> Self:
        if self.frame_at is not None and self.length is not None and self.frame_at > self.length:
            what = f"is {self.frame_at}, beyond the tip; it must be from 0 to the length, {self.length}"
            raise refuse(what, at=("frame_at",))
        return self

    @model_validator(mode="after")
    def _stiffness_stated_once(self) -> Self:
        for direction in self.modes.measured:
            require_uniform(self.section, self.modes, direction)
        return self

    @model_validator(mode="after")
    def _segments_of_a_beam(self) -> Self:
        if self.segments > 1:
            require_divisible(self)
        return self

    @model_validator(mode="after")
    def _exact_where_it_bends(self) -> Self:
        if not self.modes.total:
            require_rigid(self)
        return self

    @property
    def pieces(self) -> int:
        """The number of segments that dynamics see: one of a rigid link."""
        return self.segments if self.modes.total else 1

    @model_validator(mode="after")
    def _modes_have_stiffness(self) -> Self:
        for direction, (stiffness, *others) in NEEDS.items():
            if self.section and getattr(self.modes, direction):
                for name in others if direction in self.modes.measured else (stiffness, *others):
                    require(self.section, name, direction)
        return self


GRAVITY = Stated("gravity", "acceleration of free fall, inertial frame", ", as [0.0, 0.0, -9.81]", components=XYZ)
CLOSING = ("loops", "couplings")
"""The tables of a robot file that close the tree of its links."""
OF_SEVERAL = (*CLOSING, "forces", "pushes")
"""The tables of what several links have in common."""
TABLES = ("links", *OF_SEVERAL)
"""All of which a file may state several; so they come last in it."""


class Robot(Part):
    """Links, each after the one that carries it. `name` is the prefix of everything generated.

    Without `parent` a link is carried by the one before it: a chain. `gravity` (m/s²) is the acceleration of free fall
    in the inertial frame. `section_rotation`: the next link follows the slope of the tip (true by default). `base`:
    "floating" leaves the first link free in space, which then has no joint axes; "moving" moves it as is given.
    `base_acceleration`: three inputs accelerate a fixed base. A loop can build a robot of any number of links:

        Robot(name="arm", gravity=(0, 0, -9.81), links=[Link(name=f"link{i}", ...) for i in range(40)])
    """

    name: Annotated[str, PlainValidator(robot_name)] = Field(description="the robot's name, a C identifier")
    gravity: Annotated[Vector, GRAVITY]
    section_rotation: Annotated[bool, PlainValidator(boolean)] = Field(
        True, description="whether tip frames turn with the slope of the deflected link, and next links with them"
    )
    order: Annotated[int | str, PlainValidator(shape_order)] = Field(
        1,
        description="1: shapes linear in the modes; 2: to second order, with foreshortening and geometric stiffness; "
        '"exact": rods that bend as far as they like',
    )
    base: Annotated[str, PlainValidator(choice(FIXED, FLOATING, MOVING))] = Field(
        FIXED,
        description='"fixed"; "floating": the first link moves freely, its pose is part of the state; "moving": the '
        "same, but its motion is given, by accelerations as inputs",
    )
    base_acceleration: Annotated[bool, PlainValidator(boolean)] = Field(
        False, description="whether what carries a fixed base accelerates, by three inputs in m/s² along inertial axes"
    )
    links: tuple[Link, ...] = Field(description="at least one [[links]] table")
    loops: tuple[Loop, ...] = Field((), description="joints between markers of two links, [[loops]] tables")
    couplings: tuple[Coupling, ...] = Field(
        (), description="axes that follow others in a fixed ratio, [[couplings]] tables"
    )
    inputs: Annotated[tuple[Any, ...], PlainValidator(made_in_python)] = Field(
        (), description="in Python: further kinds of input", exclude=True
    )
    sensors: Annotated[tuple[Any, ...], PlainValidator(sensors_in_python)] = Field(
        (), description="in Python: further sensors", exclude=True
    )
    forces: tuple[Force, ...] = Field(
        (), description="forces between two markers, or a marker and the world, [[forces]] tables"
    )
    pushes: tuple[Push, ...] = Field((), description="markers at which wrenches act from outside, [[pushes]] tables")

    @property
    def rigid_loops(self) -> dict[int, Loop]:
        """The loops that close the tree, by their numbers in the file."""
        return {k: loop for k, loop in enumerate(self.loops) if loop.rigid}

    @property
    def acting_forces(self) -> tuple[Force, ...]:
        """The forces between frames, and behind them the loops whose joints give way, which are such forces."""
        return (*self.forces, *forces_of_loops(self.loops))

    @property
    def floating(self) -> bool:
        """Whether the first link has no joint, and its pose is part of the state."""
        return self.base != FIXED

    def without(self, *directions: str) -> Self:
        """The same robot without the modes of some `DIRECTIONS`, such as "axial".

        Raises UsageError, also for a link that is curved at rest and would be left without modes.
        """
        for name in directions:
            if name not in DIRECTIONS:
                raise UsageError(f"there is no direction '{name}'; choose {' or '.join(DIRECTIONS)}")
        return self.model_copy(update={"links": tuple(stiffened(link, directions) for link in self.links)})

    @property
    def summary(self) -> str:
        """The numbers of links and joint coordinates, and which links bend, in one line."""
        links, joints = len(self.links), sum(len(link.joint.axes) for link in self.links)
        base = f"{self.base} base, " if self.floating else ""
        counted = f"{base}{links} link{'s' * (links != 1)}, {joints} joint coordinate{'s' * (joints != 1)}"
        return f"{counted}, flexible: {', '.join(link.name for link in self.links if of_link(link)) or 'none'}"

    def __repr__(self) -> str:
        return f"<Robot '{self.name}': {self.summary}>"

    __str__ = __repr__

    @model_validator(mode="after")
    def _links_with_names_of_their_own(self) -> Self:
        if not self.links:
            raise refuse("is empty; state at least one [[links]] table", at=("links",))
        distinct([link.name for link in self.links])
        check_markers(self.links)
        check_accelerated(self.base_acceleration, self.base)
        if self.floating:
            check_in_space(self.links, self.base)
        refuse_axes(self)
        refuse_beside_balls(self)
        refuse_loops(self.links, self.loops)
        refuse_couplings(self.links, self.couplings)
        refuse_forces(self)
        refuse_tendons(self.links)
        distinct_names(self)
        for i, link in enumerate(self.links):
            if link.pieces > 1 and not self.section_rotation:
                what = "is stated with section_rotation = false, but segments follow the slope of those before them"
                raise refuse(f"{what}; leave one of them out", at=("links", i, "segments"))
            if link.modes.total and (link.order or self.order) == "exact" and not self.section_rotation:
                what = 'is "exact" with section_rotation = false, but its sections turn; leave one of them out'
                raise refuse(what, at=("links", i, "order") if link.order else ("order",))
            refuse_rest(link, link.order or self.order, ("links", i, "rest"))
            if link.modes.points is not None and (link.order or self.order) != "exact":
                what = 'is stated of a link that is not of order "exact", which has no points; leave it out'
                raise refuse(what, at=("links", i, "modes", "points"))
        return self

    @model_validator(mode="after")
    def _turning_sections_have_inertia(self) -> Self:
        carrying = {parent for parent, s in zip(parents(self.links), carried_at(self.links), strict=True) if s == TIP}
        for i, link in enumerate(self.links):
            carries = i in carrying or any(body.at == "tip" for body in link.bodies)
            for direction, (_, needed) in SHEARED.items():
                if link.section and link.modes.alike(direction) > (carries and self.section_rotation):
                    require(link.section, needed, direction, ("links", i))
        return self


def stiffened(link: Link, directions: tuple[str, ...]) -> Link:
    """A link without modes in these directions; what only flexible links state goes with the last mode."""
    modes = without(link.modes, directions)
    if modes.total:
        return link.model_copy(update={"modes": modes})
    if link.rest:
        raise UsageError(f"link '{link.name}' is curved at rest and would be straight without modes; leave it one")
    rigid = {"modes": modes.model_copy(update={"points": None}), "segments": 1, "tendons": ()}
    return link.model_copy(update=rigid | {"order": None if link.order == "exact" else link.order})


def without(modes: Modes, directions: tuple[str, ...]) -> Modes:
    """No modes in these directions, and no frequencies of them."""
    update: dict[str, object] = dict.fromkeys(directions, 0)
    if modes.frequencies:
        left = {name: x for name, x in modes.frequencies.stated.items() if name not in directions}
        update["frequencies"] = Frequencies(**left) if left else None
    return modes.model_copy(update=update)
