"""The measurements of filters, a row for each sensor. A new one is a row here, and all that the product needs of it.

It stands in ``ROWS`` if filters know it unless they are told otherwise, in ``AT_MARKERS`` if it sits at markers, else
in ``FURTHER``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ..ir.program import Value
from ..spec.parameters import coordinate_names
from ..topology.chain import Chain
from ..topology.joint_coordinates import JointPlace
from . import matrices as mx
from . import sensors
from .functions import CYLINDERS, Functions
from .gauges import Gauge, curvatures, gauges
from .input_functions import LENGTHS
from .marker_functions import ACCELERATING, GIVEN_MOTION, MOVING, PLACED
from .measurement import AtMarkers, Attitude, Measurement, SensorNumber, Told, root
from .robot_function import OUTPUTS
from .signals import TWIST

XYZ = ("x", "y", "z")

# ------------------------------------------------------------------------------ axes, bases and ball joints


def encoders(chain: Chain) -> list[int]:
    """What every encoder measures: the index of a coordinate in `q`."""
    flat = dict(zip(chain.flat_v.tolist(), chain.flat_q.tolist(), strict=True))
    return [flat[k] for k in chain.effort_places if k in flat]


ENCODER = Measurement(
    "encoder",
    "q",
    lambda f, q: [q[k] for k in encoders(f.chain)],
    lambda chain: [coordinate_names(chain.robot).q[k] for k in encoders(chain)],
    "rad, of slides m",
    "the coordinates of axes, none of ball joints; where a drive without transmission is elastic, its rotor's",
    (),
    count="NENCODERS",
)


def posed(chain: Chain, in_space: bool) -> list[JointPlace]:
    """The joints whose coordinates do not add up: of a floating base, or those between links."""
    return [part for part in chain.curved if part.joint.in_space == in_space]


def _pose_rows(word: str, in_space: bool, missing: str, whose: str, axes: str) -> tuple[Measurement, ...]:
    """The attitude and the angular velocity of these joints; the latter has the first three of their rates."""

    def quaternions(f: Functions, q: Sequence) -> list[Value]:
        firsts = [part.q.start + (part.joint.turn_at or 0) for part in posed(f.chain, in_space)]
        return [x for first in firsts for x in q[first : first + 4]]

    def turning(f: Functions, q: Sequence, v: Sequence) -> list[Value]:
        return [x for part in posed(f.chain, in_space) for x in v[part.v.start : part.v.start + 3]]

    labels = lambda chain: [f"{chain.names[part.link]} {x}" for part in posed(chain, in_space) for x in XYZ]  # noqa: E731
    turns = f"{whose} as in q, of either sign; deviations and innovations are turns about {axes}"
    rates, some = f"the angular velocity as in v, in {axes}", lambda chain: bool(posed(chain, in_space))
    return (
        Attitude(f"{word}_attitude", "q", quaternions, labels, "rad", turns, (), some, missing, turning=turning),
        Measurement(f"{word}_rate", "q v", turning, labels, "rad/s", rates, (), some, missing),
    )


BASE_POSITION = Measurement(
    "base_position",
    "q",
    lambda f, q: [x for part in posed(f.chain, True) for x in q[part.q.start : part.q.start + 3]],
    lambda chain: XYZ,
    "m",
    "the origin of the base in the inertial frame",
    (),
    lambda chain: chain.floating,
    "a fixed base",
)
BASE = _pose_rows("base", True, "a fixed base", "the quaternion of the base", "axes of the base")
JOINT = _pose_rows("joint", False, "no ball joint", "quaternions of ball joints", "axes of the joint's link")

# ------------------------------------------------------------------------------ strain gauges

OFF_CENTRE = "m: of the gauge from the centreline"
CENTRED = "is 0 of a gauge whose strain is measured; state its distance from the centreline, m"


def strain_row(name: str, found: Callable[[Chain], list[Gauge]], where: str) -> Measurement:
    """The strain of fibres beside the centreline, of these gauges."""
    ending = name.removeprefix("strain")
    numbers = (
        SensorNumber(f"fibre{ending}", lambda chain: len(found(chain)), OFF_CENTRE, 0.0, CENTRED, "fibre"),
        SensorNumber(
            f"curvature{ending}",
            lambda chain: chain.n_modes,
            "1/m^2: of the centreline per unit of each mode, where gauges are",
            lambda chain, p: curvatures(chain, p, found(chain)),
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
        "1",
        f"-fibre u'' of a fibre {where}, on the side of positive y or z; positive in tension",
        (),
        numbers=numbers,
        count="" if ending else "NGAUGES",
    )


# ------------------------------------------------------------------------------ markers and functions


def _distances(f: Functions, q: Sequence, beacon: Sequence) -> list[Value]:
    """Of every marker from its own point of the inertial frame."""
    apart = [a - b for a, b in zip(f.marker_poses(q)[1], beacon, strict=True)]
    return [root(sum(x * x for x in apart[k : k + 3])) for k in range(0, len(apart), 3)]


def _points(f: Functions, q: Sequence, lever: Sequence) -> list[Value]:
    """Of every marker the point at its own lever from it."""
    R, r = (mx.array(x) for x in f.marker_poses(q))
    each = zip(r.reshape(-1, 3), R.reshape(-1, 3, 3), mx.array(lever).reshape(-1, 3), strict=True)
    return [x for place, turn, own in each for x in place + mx.multiply(turn, own)]


AXES, MARKER = AtMarkers(XYZ), "axes of the marker"
LEVER = SensorNumber(
    "point_position_lever",
    lambda chain: 3 * len(chain.markers),
    "m: from the marker to the point, in its axes",
    role="lever",
)
BEACON = SensorNumber(
    "marker_range_beacon", lambda chain: 3 * len(chain.markers), "m: a fixed point of the inertial frame", role="beacon"
)
FELT = "acceleration less that of free fall, in the marker's axes: at rest it points against gravity"
TURNS = "the marker's quaternion, of either sign; deviations and innovations are turns about its axes"
AT_MARKERS: tuple[Measurement, ...] = (
    Measurement(
        *("gyro", "q v", sensors.turning, AXES, "rad/s", "angular velocity in the marker's axes", (MOVING,)),
        told=Told("omega", "angular velocity of every marker", "What gyroscopes at the markers read.", MARKER),
    ),
    Measurement(
        *("accelerometer", "q v vdot", sensors.felt, AXES, "m/s^2", FELT, (ACCELERATING,)),
        told=Told(
            "a",
            "acceleration of every marker less that of free fall",
            "What accelerometers at the markers read: at rest gravity, upwards; in free fall nothing.",
            MARKER,
        ),
    ),
    Measurement(
        "marker_position", "q", lambda f, q: f.marker_poses(q)[1], AXES, "m", "in the inertial frame", (PLACED,)
    ),
    Measurement(
        "point_position",
        "q",
        _points,
        AXES,
        "m",
        "in the inertial frame, of a point beside the marker that turns with it",
        (PLACED,),
        numbers=(LEVER,),
    ),
    Measurement(
        "marker_velocity",
        "q v",
        lambda f, q, v: f.marker_velocities(q, v),
        AtMarkers(tuple(f"{part}_{x}" for part in ("omega", "v") for x in XYZ)),
        TWIST,
        "angular and linear velocity in the marker's axes",
        (MOVING,),
        told=Told("twist", "[omega; v] of every marker", "The twists of the markers.", MARKER),
    ),
    Attitude(
        "marker_attitude",
        "q",
        lambda f, q: f.marker_poses(q)[0],
        AXES,
        "rad",
        TURNS,
        (PLACED, MOVING),
        turning=sensors.turning,
        matrices=True,
    ),
    Measurement(
        "marker_range",
        "q",
        _distances,
        AtMarkers(),
        "m",
        "distance from a fixed point of the inertial frame",
        (PLACED,),
        numbers=(BEACON,),
    ),
)


CYLINDER_LENGTH = Measurement(
    "cylinder_length",
    "q",
    lambda f, q: f.cylinder_lengths(q),
    lambda chain: [str(k) for k, _ in enumerate(chain.cylinders)],
    "m",
    "length of every cylinder",
    (CYLINDERS,),
    lambda chain: bool(chain.cylinders),
    told=Told(
        "cylinder_length",
        "length of every cylinder",
        "The lengths of the cylinders that drive joints, between their eyes, in the order of their joints.",
        shape=("NCYLINDERS",),
    ),
)
TENDON_LENGTH = Measurement(
    "tendon_length",
    "q",
    lambda f, q: f.tendon_lengths(q),
    lambda chain: [str(k) for k in range(chain.n_tensions)],
    "m",
    "length of every tendon",
    (LENGTHS,),
    lambda chain: bool(chain.n_tensions),
    told=Told(
        "length",
        "length of every tendon",
        "The lengths of the tendons, each the sum of its pieces.",
        shape=("NTENDONS",),
        c_file=OUTPUTS,
    ),
)


# ------------------------------------------------------------------------------ the tables

ACCELERATION = Measurement(
    "acceleration",
    "q v vdot",
    lambda f, q, v, vdot: f.tip_acceleration(q, v, vdot),
    lambda chain: XYZ,
    "m/s^2",
    "of the last tip, in its axes, less that of free fall: at rest it points against gravity",
    (GIVEN_MOTION,),
)
STRAIN = strain_row("strain", gauges, "at the base of a link")
ROWS: tuple[Measurement, ...] = (ENCODER, STRAIN, ACCELERATION, BASE_POSITION, *BASE, *JOINT)
"""What filters know unless they are told otherwise, of robots that have it, in the order of an update's arguments."""
FURTHER: tuple[Measurement, ...] = (CYLINDER_LENGTH, TENDON_LENGTH)
"""What they know where it is asked for, besides what sits at markers."""
