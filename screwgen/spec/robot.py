"""The robot as a frozen, validated description: the content of a robot file.

Presence has meaning. `None` is what the file omits: structurally zero, free of cost in generated code. A
stated 0.0 is a runtime parameter that happens to be zero. SI units and radians throughout; the frames are
those of NOTATION.md.
"""

from collections.abc import Callable
from numbers import Real
from typing import Annotated, Any, ClassVar, Self

from pydantic import Field, PlainValidator, model_validator

from ..bases import BASES, DEFAULT, NATURAL, Basis, Shapes, shapes
from ..errors import UsageError
from .frequencies import Frequencies
from .names import distinct, link_name, robot_name
from .part import Part
from .physics import axes, inertia
from .profile import profiled
from .ranges import several, within
from .reduced import link_body, refuse_axes, refuse_rod
from .screw import Screw
from .section import PRODUCTS
from .stations import AnySection, Stations
from .values import DIRECTIONS, boolean, choice, count, quoted, refuse, shape_order


def basis(value: Any) -> str | Basis:
    """The name of a basis, or in Python a function `(count, order) -> Shapes`."""
    return value if callable(value) else choice(*BASES)(value)


def named(basis: str | Basis) -> str:
    """A basis as messages call it."""
    return quoted(basis) if isinstance(basis, str) else "of one's own"


Vector = tuple[float, float, float]
Position = Annotated[Vector, PlainValidator(several("position", 3))]
Inertia = Annotated[tuple[float, float, float, float, float, float], PlainValidator(inertia)]
Axes = Annotated[tuple[Vector | Screw, ...], PlainValidator(axes)]
PerAxis = tuple[float, ...]
Count = Annotated[int, PlainValidator(count)]
BasisName = Annotated[str | Callable, PlainValidator(basis)]
End = Annotated[str, PlainValidator(choice("base", "tip"))]

STATE_SECTION = "state the section, at least { rhoA = … } or { density = …, area = … }"
PER_AXIS = ("armature", "damping", "stiffness")

NEEDS = {  # direction of deflection: its stiffness, then what else of the section it cannot do without
    "axial": ("EA",),
    "bending_y": ("EIz",),
    "bending_z": ("EIy",),
    "torsion": ("GJ", "rhoIp"),
}


class Modes(Part):
    """How many mode shapes describe a link's deflection in each direction, 0 to 32 each.

    `basis` names the shapes. Modal coordinates are in metres, those of torsion in radians. Polynomials, the default,
    converge fast from two bending modes, one axial and one torsion mode on; one alone in bending is too stiff.
    `frequencies` (Hz) of the bare clamped link, if measured, take the place of the section's stiffness; those
    directions have the link's natural modes, `clamped_free`, as shapes.
    """

    basis: BasisName = Field(DEFAULT, description=f"the shapes' family, {' or '.join(map(quoted, BASES))}")
    axial: Count = Field(0, description="number of modes of stretching; needs EA")
    bending_y: Count = Field(0, description="number of modes of bending that deflect in y; needs EIz")
    bending_z: Count = Field(0, description="number of modes of bending that deflect in z; needs EIy")
    torsion: Count = Field(0, description="number of modes of twisting; needs GJ and rhoIp")
    frequencies: Frequencies | None = Field(None, description="measured natural frequencies in place of stiffness")

    @model_validator(mode="before")
    @classmethod
    def _natural_modes_of_measured_bending(cls, given: Any) -> Any:
        """Where bending frequencies are stated and no basis, the basis is the one that they belong to."""
        frequencies = given.get("frequencies") if isinstance(given, dict) else None
        stated = dict(frequencies) if isinstance(frequencies, dict | Frequencies) else {}
        bends = stated.get("bending_y") or stated.get("bending_z")
        return {"basis": NATURAL} | given if bends else given

    @model_validator(mode="after")
    def _one_frequency_per_mode(self) -> Self:
        for direction, values in self.frequencies or ():
            if values is not None and len(values) != getattr(self, direction):
                count = f"modes.{direction} = {getattr(self, direction)}"
                what = f"has length {len(values)}; it must hold one frequency per mode, {count}"
                raise refuse(what, at=("frequencies", direction))
        return self

    @model_validator(mode="after")
    def _frequencies_of_natural_modes(self) -> Self:
        for direction in self.measured:
            if direction.startswith("bending") and self.basis != NATURAL:
                why = f"is stated with basis {named(self.basis)}, whose shapes are not the link's natural modes"
                what = f'{why}; use basis "clamped_free", or state {NEEDS[direction][0]} in the section'
                raise refuse(what, at=("frequencies", direction))
        return self

    @property
    def measured(self) -> tuple[str, ...]:
        """The directions whose stiffness is stated by frequencies."""
        return tuple(self.frequencies.stated) if self.frequencies else ()

    def basis_of(self, direction: str) -> str | Basis:
        """The basis of a direction's shapes."""
        return NATURAL if direction in self.measured else self.basis

    def shapes(self, direction: str) -> Shapes:
        """The mode shapes of a direction."""
        return shapes(self.basis_of(direction), direction, getattr(self, direction))

    @property
    def counts(self) -> tuple[int, int, int, int]:
        """The numbers of modes in the order of the modal coordinates, `DIRECTIONS`."""
        return self.axial, self.bending_y, self.bending_z, self.torsion

    @property
    def total(self) -> int:
        """The number of modal coordinates of the link."""
        return sum(self.counts)


class Damping(Part):
    """Modal damping: `ratio` ζ >= 0 of each of the link's own base-clamped, unloaded modes (1: critical)."""

    ratio: Annotated[float, PlainValidator(within("damping ratio"))] = Field(
        description="the damping ratio of each mode"
    )


class Mount(Part):
    """Where a joint sits on the parent's tip section, or for the first link on the inertial frame.

    `xyz` (m) from the tip point, in tip-frame axes; `rpy` (rad) as URDF's: R_mount = Rz(y) Ry(p) Rx(r).
    """

    xyz: Position | None = Field(None, description="the joint point from the parent's tip point, m, in tip-frame axes")
    rpy: Annotated[Vector, PlainValidator(several("turn", 3))] | None = Field(
        None, description="roll, pitch and yaw of the joint's axes, rad, as in URDF"
    )


class Joint(Part):
    """Rotations about `axes`, in order: R_rel = R_mount exp(a1 q1) exp(a2 q2) …; no axes: welded.

    An axis is "x", "y", "z" or a vector, held as a unit vector; in Python also a `Screw`, which may slide.
    One number >= 0 per axis, if stated (one axis: without brackets as well): `armature` (kg·m², rotor inertia at the
    joint), `damping` (N·m·s/rad), `stiffness` (N·m/rad).
    """

    axes: Axes = Field(description='the axes of rotation in order, as ["y", "z"]; [] welds the link')
    mount: Mount | None = Field(None, description="where the joint sits; without it at the tip point, axes aligned")
    armature: Annotated[PerAxis, PlainValidator(several("armature"))] | None = Field(
        None, description="rotor inertia seen at each axis, kg·m² (gear ratio squared)"
    )
    damping: Annotated[PerAxis, PlainValidator(several("damping"))] | None = Field(
        None, description="viscous damping of each axis, N·m·s/rad"
    )
    stiffness: Annotated[PerAxis, PlainValidator(several("stiffness"))] | None = Field(
        None, description="spring of each axis, N·m/rad, relaxed where its angle is 0"
    )

    @model_validator(mode="before")
    @classmethod
    def _one_number_for_one_axis(cls, given: Any) -> Any:
        """On one axis `damping = 2.0` says what `damping = [2.0]` does."""
        axes = given.get("axes") if isinstance(given, dict) else None
        if not (isinstance(axes, list | tuple) and len(axes) == 1):
            return given
        alone = {k: [v] for k, v in given.items() if k in PER_AXIS and isinstance(v, Real) and not isinstance(v, bool)}
        return given | alone

    @property
    def screws(self) -> tuple[Screw, ...]:
        """The degrees of freedom in order."""
        return tuple(axis if isinstance(axis, Screw) else Screw(axis) for axis in self.axes)

    @model_validator(mode="after")
    def _one_number_per_axis(self) -> Self:
        for name in PER_AXIS:
            values = getattr(self, name)
            if values is not None and len(values) != len(self.axes):
                what = f"has length {len(values)}; it must hold one number per axis, {len(self.axes)}"
                raise refuse(what, at=(name,))
        return self


class Body(Part):
    """A rigid body fixed to a link's base or tip section.

    Components are in F_i axes from the joint point at "base", in tip-frame axes from the tip point at "tip".
    `mass` (kg, >= 0; zero with an inertia is the ideal rotor whose mass is counted elsewhere), `com` (m),
    `inertia` [xx, yy, zz, xy, xz, yz] about the centre of mass (kg·m²); products are the tensor's entries.
    """

    at: End = Field(description='where the body sits, "base" or "tip"')
    mass: Annotated[float, PlainValidator(within("mass"))] = Field(description="the mass, kg")
    com: Position | None = Field(None, description="the centre of mass from the point where the body sits, m")
    inertia: Inertia | None = Field(
        None, description="about the centre of mass, kg·m²: [xx, yy, zz, xy, xz, yz], with xy = −∫ x y dm"
    )


class Link(Part):
    """One flexible or rigid link and the joint that carries it.

    `length` (m) of the undeformed centreline; `frame_at` (m) from its base to the link frame's origin,
    a = −frame_at. No `modes`: rigid. A rigid link without `section` has the mass of its `bodies` alone; without
    `length` its tip is at the joint. In Python, `body` may be a rigid body of one's own (`bodies.contract`).
    """

    other_keys: ClassVar = {"profile": "in place of section: a tube, rod or box of a material"}

    name: Annotated[str, PlainValidator(link_name)] = Field(description="the link's name, a C identifier")
    length: Annotated[float, PlainValidator(within("length"))] | None = Field(
        None, description="the length of the centreline, m; a link without a section can do without"
    )
    frame_at: Annotated[float, PlainValidator(within("frame_at"))] | None = Field(
        None, description="distance of the link frame's origin from the base, m, along the centreline; 0 to length"
    )
    section: AnySection | None = Field(
        None,
        description="the section, at least { rhoA = … } or { density = …, area = … }, or an array of stations; "
        "without it only bodies have mass",
    )
    modes: Modes = Field(Modes(), description="how many mode shapes; without it the link is rigid")
    damping: Damping | None = Field(None, description="damping of the modes, as { ratio = 0.01 }")
    order: Annotated[int, PlainValidator(shape_order)] | None = Field(
        None, description="the order of the link's shape, 1 or 2; without it the robot's"
    )
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
            if isinstance(self.section, Stations):
                what = (
                    "is stated beside stations; measured frequencies are those of a uniform rod, leave one of them out"
                )
                raise refuse(what, at=("modes", "frequencies", direction))
            refuse_both(self.section, NEEDS[direction][0], direction)
        return self

    @model_validator(mode="after")
    def _modes_have_stiffness(self) -> Self:
        for direction, (stiffness, *others) in NEEDS.items():
            if self.section and getattr(self.modes, direction):
                for name in others if direction in self.modes.measured else (stiffness, *others):
                    require(self.section, name, direction)
        return self


class Robot(Part):
    """A chain of links, base to tip. `name` is the prefix of everything generated.

    `gravity` (m/s²) is the acceleration of free fall in the inertial frame. `section_rotation`: the next link
    follows the slope of the tip (true by default). A loop can build a robot of any number of links:

        Robot(name="arm", gravity=(0, 0, -9.81), links=[Link(name=f"link{i}", ...) for i in range(40)])
    """

    name: Annotated[str, PlainValidator(robot_name)] = Field(description="the robot's name, a C identifier")
    gravity: Annotated[Vector, PlainValidator(several("gravity", 3))] = Field(
        description="the acceleration of free fall, m/s², as [0.0, 0.0, -9.81]"
    )
    section_rotation: Annotated[bool, PlainValidator(boolean)] = Field(
        True, description="whether tip frames turn with the slope of the deflected link, and next links with them"
    )
    order: Annotated[int, PlainValidator(shape_order)] = Field(
        1, description="1: shapes linear in the modes; 2: to second order, with foreshortening and geometric stiffness"
    )
    links: tuple[Link, ...] = Field(description="at least one [[links]] table")

    def without(self, *directions: str) -> Self:
        """The same robot without the modes of some `DIRECTIONS`, such as "axial"; raises UsageError."""
        for name in directions:
            if name not in DIRECTIONS:
                raise UsageError(f"there is no direction '{name}'; choose {' or '.join(DIRECTIONS)}")
        links = tuple(link.model_copy(update={"modes": without(link.modes, directions)}) for link in self.links)
        return self.model_copy(update={"links": links})

    @model_validator(mode="after")
    def _links_with_names_of_their_own(self) -> Self:
        if not self.links:
            raise refuse("is empty; state at least one [[links]] table", at=("links",))
        distinct([link.name for link in self.links])
        refuse_axes(self)
        return self


def without(modes: Modes, directions: tuple[str, ...]) -> Modes:
    """No modes in these directions, and no frequencies of them."""
    update: dict[str, object] = dict.fromkeys(directions, 0)
    if modes.frequencies:
        left = {name: x for name, x in modes.frequencies.stated.items() if name not in directions}
        update["frequencies"] = Frequencies(**left) if left else None
    return modes.model_copy(update=update)


def refuse_both(section: AnySection | None, name: str, direction: str) -> None:
    """Refuse a section that states the stiffness `name` of a direction whose frequencies are stated."""
    if getattr(section, name, None) is not None:
        spelling = " and ".join(map(quoted, PRODUCTS[name]))
        both = f"is stated beside section.{name} (in the material spelling: {spelling})"
        what = f"{both}, but either gives the stiffness; leave one of them out"
        raise refuse(what, at=("modes", "frequencies", direction))


def require(section: AnySection, name: str, direction: str) -> None:
    """Refuse a section whose property `name` is missing or zero, though modes in `direction` rest on it."""
    value = section.least(name)
    if value:
        return
    wrong = "is missing" if value is None else "is zero"
    wrong += " at a station" if value is not None and section.places else ""
    other = " and ".join(map(quoted, PRODUCTS.get(name, ("density", "Iy", "Iz"))))
    what = f"{wrong}, but modes.{direction} needs it; it must be > 0 (in the material spelling: {other})"
    raise refuse(what, at=("section", name))
