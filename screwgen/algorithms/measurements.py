"""The measurements of filters: a row for each, and how a caller chooses them by name.

A new sensor is a row here, in ``ROWS`` if filters know it unless they are told otherwise, in ``AT_MARKERS`` if it sits
at markers, else in ``FURTHER``. Functions of the robot with an entry for each of something are rows by themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, TypeVar

from ..arguments import choice
from ..errors import UsageError
from ..ir.program import Value
from ..spec.parameters import coordinate_names, parameters
from ..topology.chain import Chain
from ..topology.joint_coordinates import JointPlace
from ..topology.markers import PlacedMarker
from . import sensors
from .functions import Functions
from .gauges import Gauge, gauges
from .marker_functions import ACCELERATING, GIVEN_MOTION, MOVING, PLACED
from .measurement import Attitude, Measurement, SensorNumber
from .robot_functions import BY_NAME, entries
from .signals import Signal

XYZ = ("x", "y", "z")
_Row = TypeVar("_Row", bound=Measurement)

# ------------------------------------------------------------------------------ axes, bases and ball joints


def encoders(chain: Chain) -> list[tuple[int, int]]:
    """What every encoder measures: the index of a coordinate in `q`, and that of its rate in `v`."""
    flat = dict(zip(chain.flat_v.tolist(), chain.flat_q.tolist(), strict=True))
    return [(flat[k], k) for k in chain.effort_places if k in flat]


ENCODER = Measurement(
    "encoder",
    "q",
    lambda f, q: [q[k] for k, _ in encoders(f.chain)],
    lambda chain: [coordinate_names(chain.robot).q[k] for k, _ in encoders(chain)],
    unit="rad, of slides m",
    about="the coordinates of axes, none of ball joints; where a drive without transmission is elastic, its rotor's",
    count="NENCODERS",
    algorithms=(),
)


def posed(chain: Chain, in_space: bool) -> list[JointPlace]:
    """The joints whose coordinates do not add up: of a floating base, or those between links."""
    return [part for part in chain.curved if part.joint.in_space == in_space]


def quaternions(f: Functions, q: Sequence, in_space: bool) -> list[Value]:
    """Those among the coordinates of these joints, one after the other."""
    firsts = [part.q.start + (part.joint.turn_at or 0) for part in posed(f.chain, in_space)]
    return [x for first in firsts for x in q[first : first + 4]]


def joint_turning(f: Functions, q: Sequence, v: Sequence, in_space: bool) -> list[Value]:
    """The angular velocities of these joints in axes of their links, the first three of the rates of each."""
    return [x for part in posed(f.chain, in_space) for x in v[part.v.start : part.v.start + 3]]


def _pose_rows(word: str, in_space: bool, missing: str, whose: str, axes: str) -> tuple[Measurement, Measurement]:
    """The attitude and the angular velocity of these joints."""
    labels = lambda chain: [f"{chain.names[part.link]} {x}" for part in posed(chain, in_space) for x in XYZ]  # noqa: E731
    same: dict[str, Any] = {"offered": lambda chain: bool(posed(chain, in_space)), "missing": missing, "algorithms": ()}
    attitude = Attitude(
        f"{word}_attitude",
        "q",
        lambda f, q: quaternions(f, q, in_space),
        labels,
        unit="rad",
        about=f"{whose} as in q, of either sign; deviations and innovations are turns about {axes}",
        turning=partial(joint_turning, in_space=in_space),
        **same,
    )
    rate = Measurement(
        f"{word}_rate",
        "v",
        lambda f, v: joint_turning(f, (), v, in_space),
        labels,
        unit="rad/s",
        about=f"the angular velocity as in v, in {axes}",
        **same,
    )
    return attitude, rate


BASE_POSITION = Measurement(
    "base_position",
    "q",
    lambda f, q: [x for part in posed(f.chain, True) for x in q[part.q.start : part.q.start + 3]],
    lambda chain: XYZ,
    unit="m",
    about="the origin of the base in the inertial frame",
    offered=lambda chain: bool(posed(chain, True)),
    missing="a fixed base",
    algorithms=(),
)
BASE = _pose_rows("base", True, "a fixed base", "the quaternion of the base", "axes of the base")
JOINT = _pose_rows("joint", False, "no ball joint", "quaternions of ball joints", "axes of the joint's link")

# ------------------------------------------------------------------------------ strain gauges

CENTRED = "is 0 of a gauge whose strain is measured; state its distance from the centreline, m"


def strain_row(name: str, found: Callable[[Chain], list[Gauge]], where: str) -> Measurement:
    """The strain of fibres beside the centreline, of these gauges."""
    ending = name.removeprefix("strain")
    numbers = (
        SensorNumber(
            f"fibre{ending}",
            lambda chain: len(found(chain)),
            "m: of the gauge from the centreline",
            0.0,
            CENTRED,
            "fibre",
        ),
        SensorNumber(
            f"curvature{ending}",
            lambda chain: chain.n_modes,
            "1/m^2: of the centreline per unit of each mode, where gauges are",
            lambda chain, p: _curvatures(chain, p, found(chain)),
            role="curvature",
        ),
    )

    def value(f: Functions, q: Sequence, fibre: Sequence, curvature: Sequence) -> list[Value]:
        out: list[Value] = []
        for distance, gauge in zip(fibre, found(f.chain), strict=True):
            modes = range(gauge.first, gauge.first + len(gauge.curvatures))
            terms = [-distance * curvature[k] * q[f.chain.eta_q + k] for k in modes]
            out.append(sum(terms[1:], terms[0]))
        return out

    return Measurement(
        name,
        "q",
        value,
        lambda chain: [f"{chain.robot.links[g.link].name}, bending in {g.direction[-1]}" for g in found(chain)],
        unit="1",
        about=f"-fibre u'' of a fibre {where}, on the side of positive y or z; positive in tension",
        numbers=numbers,
        count="" if ending else "NGAUGES",
        algorithms=(),
    )


def _curvatures(chain: Chain, p: Sequence[Value], found: Sequence[Gauge]) -> list[Value]:
    """The second derivative of every mode's shape where a gauge measures it, over the square of the link's length."""
    out: list[Value] = [0.0] * chain.n_modes
    names = [x.name for x in parameters(chain.robot)]
    for gauge in found:
        length = p[names.index(f"{chain.robot.links[gauge.link].name}.length")]
        for k, curvature in enumerate(gauge.curvatures, gauge.first):
            out[k] = curvature / (length * length)
    return out


def _strain_at(chain: Chain, marker: PlacedMarker) -> Measurement:
    place = [(marker.segment, marker.at)]
    if marker.is_tip or not gauges(chain, place):
        raise UsageError(f"strain@{marker.name}: nothing bends there; choose a marker along a link that bends")
    return strain_row(_at_name("strain", marker), lambda chain: gauges(chain, place), f"at {marker.name}")


# ------------------------------------------------------------------------------ markers


def _marked(
    name: str, inputs: str, value: Callable[..., Sequence[Value]], parts: Sequence[str], **more: Any
) -> Measurement:
    """A row of what is measured at all markers, one after the other."""
    labels = lambda chain: [f"{m.name}{part}" for m in chain.markers for part in parts]  # noqa: E731
    return Measurement(name, inputs, value, labels, **more)


AXES = [f".{x}" for x in XYZ]
AT_MARKERS = (
    _marked(
        "gyro",
        "q v",
        sensors.turning,
        AXES,
        unit="rad/s",
        about="angular velocity in the marker's axes",
        algorithms=(MOVING,),
    ),
    _marked(
        "accelerometer",
        "q v vdot",
        sensors.felt,
        AXES,
        unit="m/s^2",
        about="acceleration less that of free fall, in the marker's axes: at rest it points against gravity",
        algorithms=(ACCELERATING,),
    ),
    _marked(
        "marker_position",
        "q",
        lambda f, q: f.marker_poses(q)[1],
        AXES,
        unit="m",
        about="the marker in the inertial frame",
        algorithms=(PLACED,),
    ),
    _marked(
        "marker_velocity",
        "q v",
        lambda f, q, v: f.marker_velocities(q, v),
        [f".{part}_{x}" for part in ("omega", "v") for x in XYZ],
        unit="rad/s, m/s",
        about="angular and linear velocity in the marker's axes",
        algorithms=(MOVING,),
    ),
    Attitude(
        "marker_attitude",
        "q",
        lambda f, q: f.marker_poses(q)[0],
        lambda chain: [f"{m.name}.{x}" for m in chain.markers for x in XYZ],
        unit="rad",
        about="the marker's quaternion, of either sign; deviations and innovations are turns about its axes",
        turning=sensors.turning,
        matrices=True,
        algorithms=(PLACED, MOVING),
    ),
)


def _at(row: _Row, chain: Chain, marker: PlacedMarker) -> _Row:
    """The row at one marker alone."""
    number, count = chain.markers.index(marker), len(chain.markers)

    def own(value: Callable[..., Sequence[Any]], *given: Any, **more: Any) -> Sequence[Any]:
        found = value(*given, **more)
        size = len(found) // count
        return found[number * size : (number + 1) * size]

    more: dict[str, Any] = {"turning": partial(own, row.turning)} if isinstance(row, Attitude) else {}
    return replace(
        row, name=_at_name(row.name, marker), value=partial(own, row.value), labels=partial(own, row.labels), **more
    )


def _at_name(name: str, marker: PlacedMarker) -> str:
    return f"{name}_{marker.name.replace('.', '_')}"


# ------------------------------------------------------------------------------ the tables

ACCELERATION = Measurement(
    "acceleration",
    "q v vdot",
    lambda f, q, v, vdot: f.tip_acceleration(q, v, vdot),
    lambda chain: XYZ,
    unit="m/s^2",
    about="of the last tip, in its axes, less that of free fall: at rest it points against gravity",
    algorithms=(GIVEN_MOTION,),
)
ROWS: tuple[Measurement, ...] = (
    ENCODER,
    strain_row("strain", gauges, "at the base of a link"),
    ACCELERATION,
    BASE_POSITION,
    *BASE,
    *JOINT,
)
"""What filters know unless they are told otherwise, of robots that have it, in the order of an update's arguments."""
FURTHER: tuple[Measurement, ...] = ()
"""What they know where it is asked for, besides what sits at markers and functions of the robot."""


def function_row(name: str) -> Measurement:
    """The measurement of a function of the robot that has one result and needs no dynamics."""
    row = BY_NAME[name]
    (signal,) = row.results.values()
    return Measurement(
        name,
        row.inputs,
        lambda f, **given: next(iter(row.program.body(f, **given).values())),
        lambda chain: [str(k) for k in range(entries(row, chain))],
        unit=signal.unit,
        about=signal.meaning,
        offered=row.offered,
        algorithms=row.algorithms,
    )


def measurable() -> list[str]:
    """The functions of the robot that are measurements, too."""
    named = {row.name for row in (*ROWS, *AT_MARKERS, *FURTHER)}
    plain = (
        row for row in BY_NAME.values() if row.c_file and len(row.results) == 1 and {"q", "v", "tau"} >= {*row.names}
    )
    return [row.name for row in plain if row.name not in named and _is_list(*row.results.values())]


def _is_list(signal: Signal) -> bool:
    """Whether a result has an entry for each of something but markers."""
    return len(signal.shape) == 1 and signal.shape[0] != "NMARKERS"


def measurement(chain: Chain, said: str) -> Measurement:
    """The row that is called so: ``encoder``, ``gyro@boom.tip``, ``tendon_length calibrated``.

    Behind a name stand the marker, and whether the sensor has a scale and an offset, and a gate of its own (``gated``).
    Raises UsageError for what is none.
    """
    if not said.strip():
        raise UsageError("a measurement has no name; name one, such as 'encoder'")
    (name, at, place), *options = said.split()[0].partition("@"), *said.split()[1:]
    row = _at_marker(chain, name, place) if at else _of_robot(chain, name)
    for option in options:
        choice(option, ("calibrated", "gated"), f"{said}: there is no option")
    row = replace(row, gated="gated" in options)
    return row.calibrated if "calibrated" in options else row


def _at_marker(chain: Chain, name: str, place: str) -> Measurement:
    makers: Mapping[str, Callable[[Chain, PlacedMarker], Measurement]]
    makers = {"strain": _strain_at, **{row.name: partial(_at, row) for row in AT_MARKERS}}
    by_name = {marker.name: marker for marker in chain.markers}
    marker = by_name[choice(place, by_name, f"{name}@{place}: there is no marker")]
    return makers[choice(name, makers, "at markers there is no measurement")](chain, marker)


def _of_robot(chain: Chain, name: str) -> Measurement:
    rows = {row.name: row for row in (*ROWS, *AT_MARKERS, *FURTHER)}
    name = choice(name, [*rows, *measurable()], "there is no measurement")
    row = rows[name] if name in rows else function_row(name)
    if not row.offered(chain):
        raise UsageError(f"{name}: robot '{chain.robot.name}' has {row.missing or 'no such thing'}; leave it out")
    return row


def chosen(chain: Chain, asked: Sequence[str | Measurement] | None = None) -> tuple[Measurement, ...]:
    """The rows of a filter: those that are asked for, by name or as they are, or else all of ``ROWS`` that it has."""
    if asked is None:
        return tuple(row for row in ROWS if row.offered(chain))
    rows = tuple(measurement(chain, one) if isinstance(one, str) else one for one in asked)
    for k, row in enumerate(rows):
        if row.name in {other.name for other in rows[:k]}:
            raise UsageError(f"measurements: '{row.name}' is there twice; leave one of them out")
    return rows
