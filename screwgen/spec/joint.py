"""The joint that carries a link, and its mount: keys of a robot file."""

from collections.abc import Iterator
from numbers import Real
from typing import Annotated, Any, Self

from pydantic import Field, PlainSerializer, PlainValidator, model_validator

from ..elements import AxisElement, HeldLaw
from ..joints.kind import JointKind
from ..joints.product import product
from ..joints.screw import Screw, Vector
from .axes import AxesOfKind, axes, screw_of, written
from .axis_elements import OfAxis, axis_elements, stated
from .brake import Brake, Brakes, brakes
from .brake import check as check_brakes
from .brake import stated as stated_brakes
from .drive import Drive, check, check_reach
from .limit import Limit
from .limit import check as check_limits
from .part import Part
from .stated import Stated
from .values import array, choice, quoted, refuse

Axes = Annotated[tuple[Vector | Screw, ...], PlainValidator(axes), PlainSerializer(written)]
PerAxis = tuple[float, ...]
XYZ = ("x", "y", "z")
RPY = ("roll", "pitch", "yaw")

PLACE = Stated("position", "joint point from the parent's tip, tip frame", components=XYZ)
TURN = Stated("turn", "turn of the joint, Rz(y) Ry(p) Rx(r)", ", as in URDF", components=RPY)
ARMATURE = Stated(
    *("armature", "rotor inertia seen at the joint axis", ", by the square of the gear ratio"),
    sliding="drive's inertia seen along the joint axis",
    several=True,
)
DAMPING = Stated(
    *("damping", "viscous damping about the joint axis"), sliding="viscous damping along the joint axis", several=True
)
STIFFNESS = Stated(
    *("stiffness", "stiffness about the joint axis", ", relaxed at q = 0"),
    sliding="stiffness along the joint axis",
    several=True,
)

TORQUE, MOTION = "torque", "motion"
"""What the input of an axis is: the effort of its drive, from which its acceleration follows, or the acceleration."""
ACTUATION = (TORQUE, MOTION)
PER_AXIS_WORDS = ("drives", "limits", "elements", "actuation", "brake")
MOVED_BY = ("armature", "drives")
"""The keys that say what drives an axis."""
PER_AXIS = ("armature", "damping", "stiffness")


def _actuation(value: Any) -> tuple[str, ...]:
    """A word of `ACTUATION` for each axis."""
    said = array(value, f"an array of {quoted(ACTUATION[0])} or {quoted(ACTUATION[1])}, one for each axis")
    return tuple(choice(*ACTUATION)(one) for one in said)


def _words(actuation: tuple[str, ...]) -> list[str]:
    """The words of all axes as a file states them."""
    return list(actuation)


class Mount(Part):
    """Where a joint sits on the parent's tip section, or for the first link on the inertial frame.

    `xyz` (m) from the tip point, in tip-frame axes; `rpy` (rad) as URDF's: R_mount = Rz(y) Ry(p) Rx(r).
    """

    xyz: Annotated[Vector, PLACE] | None = None
    rpy: Annotated[Vector, TURN] | None = None


class Joint(Part):
    """Motions about and along `axes`, in order: the mount, then exp(s1 q1) exp(s2 q2) …; no axes: welded.

    An axis is "x", "y", "z" or a vector, held as a unit vector, about which the link turns; or a `Screw`, in a file
    `{ slide = axis }` (q in m) or `{ screw = axis, pitch = m per rad }`. One number >= 0 per axis, if stated (one axis:
    without brackets as well): `armature` (kg·m², rotor inertia at the joint), `damping` (N·m·s/rad), `stiffness`
    (N·m/rad); of a slide kg, N·s/m and N/m. `drives`: one :class:`.Drive` per axis; `limits`: one :class:`.Limit`;
    `elements`: those of :mod:`screwgen.elements`, of each axis.
    """

    axes: Axes = Field(
        description='the axes in order, as ["y", { slide = "x" }]; [] welds the link, "ball" is a ball joint'
    )
    mount: Mount | None = Field(None, description="where the joint sits; without it at the tip point, axes aligned")
    armature: Annotated[PerAxis, ARMATURE] | None = None
    damping: Annotated[PerAxis, DAMPING] | None = None
    stiffness: Annotated[PerAxis, STIFFNESS] | None = None

    drives: tuple[Drive, ...] | None = Field(
        None, description="the drive of each axis, an array of tables: gear, rotor, friction; {} is none"
    )
    limits: tuple[Limit, ...] | None = Field(
        None, description="the limits of each axis, an array of tables: range and stops; {} is none"
    )

    actuation: Annotated[tuple[str, ...], PlainValidator(_actuation), PlainSerializer(_words)] | None = Field(
        None,
        description='"torque": the input of the axis is the effort of its drive; "motion": its acceleration, and the '
        "effort follows; of several axes an array",
    )

    brake: Annotated[Brakes, PlainValidator(brakes), PlainSerializer(stated_brakes)] | None = Field(
        None,
        description="true: the axis has a brake, an input from 0, open, to 1, closed; or a table with its numbers; of "
        "several axes an array",
    )

    elements: Annotated[tuple[OfAxis, ...], PlainValidator(axis_elements), PlainSerializer(stated)] | None = Field(
        None, description="what else acts on each axis, an array of tables such as { spring = { … } }; {} is nothing"
    )

    @model_validator(mode="before")
    @classmethod
    def _one_number_for_one_axis(cls, given: Any) -> Any:
        """On one axis `damping = 2.0` says what `damping = [2.0]` does, and `drives = { … }` what `[{ … }]` does."""
        axes = given.get("axes") if isinstance(given, dict) else None
        if not (isinstance(axes, list | tuple) and len(axes) == 1):
            return given
        alone = {k: [v] for k, v in given.items() if k in PER_AXIS and isinstance(v, Real) and not isinstance(v, bool)}
        one = dict | Drive | Limit | AxisElement | Brake | bool
        tables = {k: [given[k]] for k in PER_AXIS_WORDS if isinstance(given.get(k), one | str)}
        return given | alone | tables

    @property
    def prescribed(self) -> tuple[int, ...]:
        """The axes whose motion is given."""
        return tuple(k for k, what in enumerate(self.actuation or ()) if what == MOTION)

    @property
    def braked(self) -> tuple[int, ...]:
        """The axes that have a brake."""
        return tuple(k for k, one in enumerate(self.brake or ()) if one)

    @property
    def driven(self) -> tuple[Drive, ...]:
        """The drive of each axis, one that states nothing where the file has none."""
        return self.drives or (Drive(),) * len(self.axes)

    @property
    def numbers(self) -> Iterator[tuple[int, str, float | None]]:
        """The runtime parameters of drives and limits: axis, key as in `joint.limits.lower`, value."""
        for axis, drive in enumerate(self.drives or ()):
            yield from ((axis, f"joint.drives.{name}", value) for name, value in drive.numbers)
        for axis, limit in enumerate(self.limits or ()):
            yield from ((axis, f"joint.limits.{name}", getattr(limit, name)) for name in Limit.model_fields)
        for axis, brake in enumerate(self.brake or ()):
            yield from ((axis, f"joint.brake.{name}", value) for name, value in (brake.numbers if brake else ()))

    def has_inertia(self, axis: int) -> bool:
        """Whether the inertia of what drives an axis is stated."""
        return bool((self.armature and self.armature[axis]) or self.driven[axis].rotor_inertia)

    def is_moved(self, axis: int) -> bool:
        """Whether something drives an axis, see `MOVED_BY`."""
        moved = (self.armature and self.armature[axis]) or self.driven[axis] != Drive()
        return bool(moved or axis in self.prescribed)

    def between(self, axis: int) -> str:
        """What stands between the effort of a drive and its axis, which it then does not act on; empty if nothing."""
        drive = self.driven[axis]
        return "an elastic gear" if drive.elastic else "a transmission" if drive.travel else ""

    def has_spring(self, axis: int) -> bool:
        """Whether a spring holds an axis."""
        return bool(self.stiffness and self.stiffness[axis])

    def rigid(self) -> Self:
        """The joint with rigid gears in place of elastic ones."""
        rigid = tuple(x.rigid() for x in self.drives or ())
        return self.model_copy(update={"drives": rigid} if rigid else {})

    def without_internal_states(self) -> Self:
        """The joint without the laws that have an internal state; viscous friction beside one stays."""
        frictions = ((x, x.friction and x.friction.without_internal_states()) for x in self.drives or ())
        drives = tuple(x.model_copy(update={"friction": friction}) for x, friction in frictions)
        elements = tuple(tuple(one for one in own if one.state is None) for own in self.elements or ())
        limits = tuple(x.without_internal_states() for x in self.limits or ())
        return self.model_copy(
            update={"drives": drives or None, "elements": elements or None, "limits": limits or None}
        )

    @property
    def kind(self) -> JointKind:
        """How the joint moves its link."""
        return self.axes.kind if isinstance(self.axes, AxesOfKind) else product(self.screws)

    @property
    def screws(self) -> tuple[Screw, ...]:
        """The degrees of freedom in order."""
        return tuple(map(screw_of, self.axes))

    @model_validator(mode="after")
    def _a_joint_without_axes_has_damping_alone(self) -> Self:
        for name in ("armature", "stiffness", *PER_AXIS_WORDS) if self.kind.curved else ():
            if getattr(self, name) is not None:
                said = f"is stated of a {self.kind.name} joint, which has no axes; leave it out, damping aside"
                raise refuse(said, at=(name,))
        return self

    @model_validator(mode="after")
    def _one_number_per_axis(self) -> Self:
        for name in PER_AXIS:
            values = getattr(self, name)
            if values is not None and len(values) != len(self.axes):
                what = f"has length {len(values)}; it must hold one number per axis, {len(self.axes)}"
                raise refuse(what, at=(name,))
        if self.actuation is not None and len(self.actuation) != len(self.axes):
            what = f"has length {len(self.actuation)}; it must hold one word per axis, {len(self.axes)}"
            raise refuse(what, at=("actuation",))
        for axis in self.prescribed:
            if drive := self.driven[axis].travel:
                what = f'is "motion" of an axis that a {drive.SHORT} drives; give the motion of the axis without it'
                raise refuse(what, at=("actuation", axis))
        for axis, own in enumerate(self.elements or ()):
            if axis in self.prescribed and any(isinstance(one, HeldLaw) for one in own):
                said = 'changes the effort of a drive, and the axis has actuation "motion"; leave out one of them'
                raise refuse(said, at=("elements", axis))
        if self.elements is not None and len(self.elements) != len(self.axes):
            what = f"has length {len(self.elements)}; it must hold one table per axis, {len(self.axes)}"
            raise refuse(f"{what}; an empty one is no element", at=("elements",))
        if self.drives is not None:
            check(self.drives, self.screws, self.armature)
        if self.limits is not None:
            check_limits(self.limits, len(self.axes))
        if self.brake is not None:
            check_brakes(self.brake, self.screws, self.driven, self.prescribed)
        if self.drives is not None and self.limits is not None:
            check_reach(self.drives, self.limits)
        return self
