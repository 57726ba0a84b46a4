"""The runtime parameters of a robot (the numbers that its file states), and the names of its coordinates."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import NamedTuple

from ..elements import Added, Travel
from .axis_elements import numbers_of
from .base import CHANGE, CHANGE_UNITS, POSE, POSE_UNITS, TWIST
from .fields import FIELDS, SLIDING, of_axis
from .inputs import input_names
from .joint import Joint, Mount
from .link_class import link_class
from .part import Part
from .reduced import of_link as directions
from .robot import Body, Damping, Link, Robot
from .section import Section
from .segments import segments
from .stated import stated_numbers
from .stations import Stations

Index = tuple[int, ...]
Value = float | tuple[float, ...] | None


@dataclass(frozen=True)
class Parameter:
    """One number that a robot's user may change without generating anew.

    `name`: as in `upper_arm.bodies[0].mass`; `value` in `unit`; `link`: the link's place in `robot.links`,
    None for gravity and forces; `field`: a key of `FIELDS`, or of an element of an axis or a force; `index`: what the
    name's brackets hold, left to right; `sign`: which values are allowed, ``positive``, ``non-negative`` or ``any``.
    """

    name: str
    value: float
    unit: str
    link: int | None
    field: str
    index: Index
    description: str
    sign: str


BODY_FRAMES = {"base": ("F_i axes", "from the joint point"), "tip": ("tip-frame axes", "from the tip point")}
"""The axes of a body's numbers, and the point from which its centre of mass is meant."""


def parameters(robot: Robot) -> tuple[Parameter, ...]:
    """All runtime parameters of `robot`: gravity, then link by link, each in the order of `FIELDS`, then of forces."""
    links = (of_link(i, link) for i, link in enumerate(robot.links))
    return (*spread("gravity", robot.gravity), *chain.from_iterable(links), *of_forces(robot))


def of_forces(robot: Robot) -> Iterator[Parameter]:
    """The parameters of forces between frames."""
    for force in robot.acting_forces:
        for field, value, unit, meaning, sign, index in force.values:
            name = f"{force.name}.{field.rpartition('.')[2]}{''.join(f'[{k}]' for k in index)}"
            yield Parameter(name, value, unit, None, field, index, meaning, sign)


def of_link(i: int, link: Link) -> Iterator[Parameter]:
    """The parameters of `link`, which is number `i`."""
    for field, value in (*shape(link), *joint(link.joint)):
        for parameter in spread(field, value, i, link.name):
            yield _of_axis(parameter, link.joint)
    for axis, field, value in link.joint.numbers:
        for parameter in spread(field, value, i, link.name, (axis,)):
            yield _of_axis(parameter, link.joint)
    for axis, element, name, key, value in numbers_of(link.joint.elements):
        unit = key.unit if link.joint.screws[axis].turn else key.sliding
        own = f"{link.name}.joint.elements[{axis}].{element.KIND}.{name}"
        yield Parameter(own, value, unit, i, f"joint.elements.{element.KIND}.{name}", (axis,), key.meaning, key.sign)
    for k, tendon in enumerate(link.tendons):
        for end in range(2) if tendon.actuated else ():
            for c, value in enumerate(tendon.offset(end), 1):
                yield _offset(i, link, k, end, c, value)
    for b, body in enumerate(link.bodies):
        for field, value in mass(body):
            axes, point = BODY_FRAMES[body.at]
            frame = f"{axes}, {point}" if field == "bodies.com" else axes
            yield from spread(field, value, i, link.name, (b,), frame)


def _offset(i: int, link: Link, number: int, end: int, component: int, value: float) -> Parameter:
    """An offset of a tendon at one of its ends."""
    kind, index = FIELDS["tendons.at"], (number, end, component)
    where = f"{kind.description}, {'xyz'[component]}, where it {('begins', 'ends')[end]}"
    return Parameter(
        f"{link.name}.{kind.pattern.format(*index)}", value, kind.unit, i, "tendons.at", index, where, kind.sign
    )


COULOMB = "joint.drives.friction.coulomb"


def _of_axis(parameter: Parameter, joint: Joint) -> Parameter:
    """A parameter of a joint with unit, meaning and sign of its axis, if it has others."""
    friction = joint.driven[parameter.index[0]].friction if parameter.field == COULOMB else None
    if friction and friction.bristles:
        parameter = replace(parameter, sign="positive")
    if parameter.field not in SLIDING or not (other := of_axis(parameter.field, joint, parameter.index[0])):
        return parameter
    return replace(parameter, unit=other[0], description=other[1])


def shape(link: Link) -> Iterator[tuple[str, Value]]:
    """The fields of the link's own body."""
    yield from numbers("", Link, link)
    if isinstance(link.section, Stations):
        yield from ((f"section.{name}", link.section.values(name)) for name, _ in stated_numbers(Section))
    else:
        yield from numbers("", Section, link.section)
    for direction, values in link.modes.frequencies or ():
        yield f"frequencies.{direction}", values
    if link.rest is not None:
        table = "rest_at" if link.rest.places else "rest"
        yield from ((f"{table}.{direction}", link.rest.values(direction)) for direction in link.rest.directions)
    yield from numbers("damping.", Damping, link.damping)


def joint(joint: Joint) -> Iterator[tuple[str, Value]]:
    """The fields of a joint; its axes are structure, not parameters."""
    yield from numbers("joint.mount.", Mount, joint.mount)
    yield from numbers("joint.", Joint, joint)


def mass(body: Body) -> Iterator[tuple[str, Value]]:
    """The fields of a rigid body."""
    return numbers("bodies.", Body, body)


def numbers(table: str, part: type[Part], given: Part | None) -> Iterator[tuple[str, Value]]:
    """The fields of a table of the file, None where it does not state them."""
    return ((f"{table}{name}", getattr(given, name, None)) for name, _ in stated_numbers(part))


def spread(
    field: str, value: Value, i: int | None = None, link: str = "", place: Index = (), frame: str = ""
) -> Iterator[Parameter]:
    """One parameter for each number in `value`, none where the file omits it; `place`: which body, if one."""
    kind = FIELDS[field]
    for index, number in numbered(value):
        name = ".".join(filter(None, (link, kind.pattern.format(*place, *index))))
        component = (kind.components[index[0]], frame) if kind.components else ()
        description = ", ".join(filter(None, (kind.description, *component)))
        yield Parameter(name, number, kind.unit, i, field, (*place, *index), description, kind.sign)


def numbered(value: Value) -> Iterator[tuple[Index, float]]:
    """The numbers in `value`, each with its index."""
    if isinstance(value, tuple):
        yield from (((k,), number) for k, number in enumerate(value))
    elif value is not None:
        yield (), value


class CoordinateNames(NamedTuple):
    """Names of the entries of q, v = dq/dt, tau and of the joint wrenches (6 a link, in F_i components)."""

    q: tuple[str, ...]
    v: tuple[str, ...]
    tau: tuple[str, ...]
    wrench: tuple[str, ...]


WRENCH = ("tau_x", "tau_y", "tau_z", "F_x", "F_y", "F_z")


def coordinate_names(robot: Robot) -> CoordinateNames:
    """The names (q, v, tau, wrench); no name occurs twice in all four, so they can head one table's columns.

    A floating base comes first: `base.x` … `base.qz` (m, unit quaternion), `base.omega_x` … `base.v_z` (rad/s, m/s).
    q: `forearm.joint[0]` (rad) link by link, then the rotors' angles `forearm.theta[0]` (rad), with the number of
    the axis, or how far the rotor is ahead of the cylinder that it drives, `boom.stretch[0]` (m), or of the crank,
    `boom.gear[0]` (rad), then `forearm.eta.bending_y[0]` (m, torsion: rad) link by link;
    v: `forearm.joint_rate[0]` and `forearm.eta_rate.bending_y[0]`; tau: `forearm.torque[0]` (N·m). Of an axis that
    slides: `cart.slide[0]` (m), `cart.slide_rate[0]`, `cart.force[0]` (N), on the rotor of an elastic
    drive `cart.torque[0]` (N·m). Of an axis that a cylinder drives: `boom.joint[0]` (rad), `boom.force[0]` (N); of one
    that a four-bar linkage drives `boom.torque[0]` (N·m), at the crank.
    Tendons follow: `left.tension` (N). Behind all rates v holds internal states: `hand.friction_state[0]` (rad).
    Of a ball joint q: `hand.joint.qw` … `hand.joint.qz`. wrench: `forearm.tau_x` (N·m) … `forearm.F_z` (N).
    Of a link with segments: `boom[2].eta.bending_y[0]` with the segment's number from 0, `boom.tau_x` … of its joint,
    and `boom[1].tau_x` … of the weld on which segment 1 sits.
    """
    return CoordinateNames(
        q=(
            *per_base(robot, POSE),
            *per_coordinate(robot),
            *per_added(robot),
            *per_mode(robot, "eta"),
        ),
        v=(
            *per_base(robot, TWIST),
            *per_axis(robot, "joint_rate", "slide_rate"),
            *per_added(robot, "_rate"),
            *per_mode(robot, "eta_rate"),
            *per_internal(robot),
        ),
        tau=tuple(input_names(robot)),
        wrench=tuple(f"{segment.jointed}.{component}" for segment in segments(robot) for component in WRENCH),
    )


def coordinate_units(robot: Robot) -> list[str]:
    """The units of q (nq)."""
    modal = ["rad" if ".torsion[" in name else "m" for name in per_mode(robot, "eta")]
    axes = ("m" if ".slide[" in x else "rad" if x.endswith("]") else "1" for x in per_coordinate(robot))
    return [*POSE_UNITS * robot.floating, *axes, *(one.unit for _, _, one in added(robot)), *modal]


def changes(robot: Robot) -> dict[str, str]:
    """The names of small changes of q along the entries of v (nv), with their units.

    Those of the coordinates, but of a floating base `base.rotation_x` … `base.displacement_z`, and of a ball joint the
    turns about the axes of its link, `hand.joint[0]` (rad).
    """
    base = dict(zip(per_base(robot, CHANGE), CHANGE_UNITS, strict=False))
    axes = {name: "m" if ".slide[" in name else "rad" for name in per_axis(robot, "joint", "slide")}
    own = dict(zip(coordinate_names(robot).q, coordinate_units(robot), strict=True))
    return base | axes | {name: own[name] for name in (*per_added(robot), *per_mode(robot, "eta"))}


def rate_units(robot: Robot) -> list[str]:
    """The units of v (nvz)."""
    return [f"{unit}/s" for unit in changes(robot).values()] + list(per_internal(robot).values())


def per_internal(robot: Robot) -> dict[str, str]:
    """The names of the internal states, link by link, then of forces between frames and held laws, with their units."""
    out = {}
    for link in robot.links:
        for law, part, place, *_ in link_class(link, True).internal:
            axes = [j for j, own in enumerate(link.joint.driven) if own.added] if part == "theta" else None
            axis = axes[place] if axes else place
            slides = axes is None and not link.joint.screws[axis].turn
            assert law.state is not None
            out[f"{link.name}.{law.state_name}[{axis}]"] = law.state.sliding if slides else law.state.unit
    for force in robot.acting_forces:
        out |= {f"{force.name}.{name}_state[0]": one.unit for name, one in force.law.shape.states.items()}
    for link in robot.links:
        for one in link_class(link, True).remembering:
            _, unit = link.joint.driven[one.axis].effort(link.joint.screws[one.axis])
            out[f"{link.name}.{one.kind.KIND}_state[{one.axis}]"] = one.unit_of_state(unit == "N")
    return out


def turning(robot: Robot) -> list[bool]:
    """Whether the link turns about each joint axis; about one that slides it does not."""
    return [screw.turn for link in robot.links for screw in link.joint.screws]


def travels(robot: Robot) -> list[Travel]:
    """The transmissions of all drives."""
    return [own.travel for link in robot.links for own in link.joint.driven if own.travel]


def added(robot: Robot) -> Iterator[tuple[Link, int, Added]]:
    """The coordinates that drives add, link by link, each with the number of its axis."""
    for link in robot.links:
        for j, own in enumerate(link.joint.driven):
            if own.added:
                yield link, j, own.added


def per_added(robot: Robot, rate: str = "") -> tuple[str, ...]:
    """One name for each of them; ``rate``: what is put behind its word."""
    return tuple(f"{link.name}.{one.name}{rate}[{j}]" for link, j, one in added(robot))


def per_base(robot: Robot, names: Sequence[str]) -> tuple[str, ...]:
    """The names of a floating base's coordinates or rates, none where the base is fixed."""
    return tuple(f"base.{name}" for name in names if robot.floating)


def per_coordinate(robot: Robot) -> tuple[str, ...]:
    """One name for each joint coordinate, link by link: of an axis, or an entry of a ball joint's quaternion."""
    named, turns = iter(per_axis(robot, "joint", "slide")), [f"joint.{q}" for q in POSE[3:]]
    own = ((link, [next(named) for _ in link.joint.axes]) for link in robot.links)
    return tuple(x for i, axes in own for x in ([f"{i.name}.{q}" for q in turns] if i.joint.kind.curved else axes))


def per_axis(robot: Robot, turning: str, sliding: str) -> tuple[str, ...]:
    """One name for each joint axis, link by link: of an axis that turns and of one that slides."""
    axes = ((link.name, j, screw) for link in robot.links for j, screw in enumerate(link.joint.screws))
    return tuple(f"{name}.{turning if screw.turn else sliding}[{j}]" for name, j, screw in axes)


def per_mode(robot: Robot, quantity: str) -> tuple[str, ...]:
    """One name for each mode, link by link; within a link or segment by direction, then by mode."""
    return tuple(
        f"{segment.name}.{quantity}.{direction}[{k}]"
        for segment in segments(robot)
        if segment.marker is None
        for direction, k in directions(robot.links[segment.link])
    )
