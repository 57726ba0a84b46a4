"""The measurements of filters, a row for each sensor. A new one is a row here, and all that filters need of it.

It stands in ``ROWS`` if filters know it unless they are told otherwise, in ``AT_MARKERS`` if it sits at markers, else
in ``FURTHER``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from ..ir.program import Value
from ..spec.parameters import coordinate_names, parameters
from ..topology.chain import Chain
from ..topology.joint_coordinates import JointPlace
from . import sensors
from .functions import Functions
from .gauges import Gauge, gauges
from .marker_functions import ACCELERATING, GIVEN_MOTION, MOVING, PLACED
from .measurement import Attitude, Measurement, SensorNumber

XYZ = ("x", "y", "z")

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
        offered=lambda chain: not chain.falls,
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
