"""The functions of a robot that every back end offers, each stated once.

An example: the power of the drives. It is a function of ``q``, ``v`` and ``tau`` with one result, an entry in W for
each drive. Its row in ``FUNCTIONS`` says this and names the lines that compute it, which run on values of any algebra.
From the row come a CasADi function, one on arrays of JAX, one on NumPy's, one of C with its call in the library,
columns of runs and rollouts, variables of mock-up units, docs/functions.md. CONTRIBUTING.md says what one takes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from ..bodies.validity import MEASURES
from ..errors import UsageError
from ..topology.chain import Chain
from . import fused, sensors
from . import robot_programs as programs
from .force_functions import MOTION
from .functions import ENERGY, FORWARD, HOLD, INVERSE, LEVERS, MEASURING, PLACES
from .gauges import strain_names
from .input_functions import POWER
from .marker_functions import ACCELERATING, MOVING, PLACED, STRAINED
from .measurements import AT_MARKERS, FURTHER, MARKER
from .momentum import CENTRED, MOMENTUM
from .robot_function import OUTPUTS, SENSORS, RobotFunction
from .sensor_functions import function_of, own_function
from .signals import ACCELERATION, INERTIAL, ROBOT, TIP, WRENCH, Signal

ROTATION, PLACE = (3, 3), (3,)
_OF_SENSORS = {row.name: function_of(row) for row in (*AT_MARKERS, *FURTHER) if row.told}
"""The functions that sensors are, by name: the rows of `measurements` state them."""


def _pose(turned: str, placed: str, *count: str) -> dict[str, Signal]:
    """Rotation and point of one frame, or of a number of them, in the inertial frame."""
    R, position = Signal((*count, *ROTATION), "-", INERTIAL, turned), Signal((*count, *PLACE), "m", INERTIAL, placed)
    return {"R": R, "position": position}


AXES = "N*m, of axes that slide N"
_LISTED = (
    RobotFunction(
        "forward_dynamics",
        "q v tau w_ext",
        {name: ROBOT["output"][name] for name in ("vdot", "wrench")},
        fused.forward_dynamics,
        (FORWARD,),
        "Forward dynamics: the accelerations, and the joint wrenches, under the inputs as they are given.",
    ),
    RobotFunction(
        "validity",
        "q v tau w_ext",
        {"measures": Signal(("NLINKS", len(MEASURES)), "-", "-", ", ".join(MEASURES))},
        fused.validity,
        (FORWARD, MEASURING),
        "How far every link is from the limits of the model.",
    ),
    RobotFunction(
        "inverse_dynamics",
        "q v vdot w_ext",
        {"force": Signal(("NV",), "N*m, N", "-", "generalised forces that a motion needs")},
        fused.inverse_dynamics,
        (INVERSE,),
        "Inverse dynamics: the generalised forces of a motion.",
    ),
    RobotFunction(
        "bias",
        "q v w_ext",
        {"h": Signal(("NV",), "N*m, N", "-", "h of M vdot + h = [tau; 0]")},
        fused.bias,
        (INVERSE,),
        "The bias force, which is the inverse dynamics without accelerations.",
    ),
    RobotFunction(
        "energy",
        "q v (tau)",
        {
            "kinetic": Signal((), "J", "-", "kinetic energy"),
            "potential": Signal((), "J", "-", "potential energy of weight, springs and modes"),
        },
        fused.energy,
        (ENERGY,),
        "Kinetic and potential energy.",
        c_file=OUTPUTS,
    ),
    RobotFunction(
        "centre_of_mass",
        "q",
        {
            "mass": Signal((), "kg", "-", "mass of the robot"),
            "centre": Signal(PLACE, "m", INERTIAL, "centre of mass"),
        },
        programs.centre_of_mass,
        (CENTRED,),
        "The mass of the robot, and its centre.",
        c_file=SENSORS,
    ),
    RobotFunction(
        "centre_of_mass_jacobian",
        "q",
        {"J": Signal((3, "NV"), "m per unit of q", INERTIAL, "J v is the velocity of the centre of mass")},
        programs.centre_of_mass_jacobian,
        (CENTRED, MOMENTUM),
        "The Jacobian of the centre of mass.",
        c_file=SENSORS,
    ),
    RobotFunction(
        "momentum",
        "q v",
        {
            "angular": Signal((3,), "kg*m^2/s", INERTIAL, "angular momentum about the origin"),
            "linear": Signal((3,), "kg*m/s", INERTIAL, "linear momentum"),
        },
        programs.momentum,
        (MOMENTUM,),
        "The momentum of the robot: what gravity, outer wrenches and the base change, and nothing inside.",
        c_file=SENSORS,
    ),
    RobotFunction(
        "drive_power",
        "q v tau",
        {"power": Signal(("NTAU",), "W", "-", "power that each drive gives to the arm")},
        programs.drive_power,
        (POWER, INVERSE),
        "The power of each drive: torque times the rate of what it turns, or force times the rate of its travel.",
        c_file=OUTPUTS,
        offered=lambda chain: not chain.has_reactions,
    ),
    RobotFunction(
        "drive_effort",
        "q v tau w_ext",
        {"effort": Signal(("NTAU",), AXES, "-", "effort of each drive and tendon")},
        programs.drive_effort,
        (FORWARD, INVERSE, MOTION),
        "The inputs with the efforts that drives need for accelerations that are given, and those of brakes.",
        offered=lambda chain: chain.has_reactions,
        c_file=OUTPUTS,
    ),
    RobotFunction(
        "effort_power",
        "q v tau w_ext",
        {"power": Signal(("NTAU",), "W", "-", "power that each drive gives to the arm")},
        programs.effort_power,
        (FORWARD, INVERSE, MOTION, POWER),
        "The power of each drive and brake where some efforts follow from the motion: that of `drive_effort`.",
        offered=lambda chain: chain.has_reactions,
        c_file=OUTPUTS,
    ),
    RobotFunction(
        "held_inputs",
        "q v tau",
        {"held": Signal(("NTAU",), AXES, "-", "input of each drive and tendon as a step holds it")},
        programs.held_inputs,
        (HOLD,),
        "What a step that begins here holds of its inputs: efforts within their limits. Steps alone do so.",
        offered=lambda chain: chain.holds,
    ),
    RobotFunction(
        "tip_pose",
        "q",
        _pose("rotation of the last tip frame", "last tip point"),
        programs.tip_pose,
        (PLACES,),
        "The pose of the last tip.",
    ),
    RobotFunction(
        "link_pose",
        "q",
        _pose("rotation of every link frame", "origin of every link frame", "NLINKS"),
        programs.link_pose,
        (PLACES,),
        "The poses of the link frames.",
    ),
    RobotFunction(
        "levers",
        "q",
        {"levers": Signal(("NAXES",), "m/rad, -", "-", "what the torque of each axis is multiplied by")},
        programs.levers,
        (LEVERS,),
        "The travel of each cylinder, or the turn of each crank, per unit of its axis; 1 without a transmission.",
        offered=lambda chain: bool(chain.travels),
    ),
    _OF_SENSORS["cylinder_length"],
    _OF_SENSORS["tendon_length"],
    RobotFunction(
        "force_quantities",
        "q v (tau)",
        {"force_quantities": Signal(("NQUANTITIES",), "m, N", "-", "what forces between frames report")},
        programs.force_quantities,
        (MOTION,),
        "What forces between frames report, as the length and the pull of a spring: `model.force_quantities` names it.",
        offered=lambda chain: bool(chain.force_quantities),
        c_file=OUTPUTS,
    ),
    RobotFunction(
        "loop_wrenches",
        "q v tau w_ext",
        {"loop_wrench": Signal(("NLINKS", 6), WRENCH, TIP, "of the loops on each tip")},
        programs.loop_wrenches,
        (FORWARD, MOTION),
        "The wrenches with which the loops act on the tips.",
        offered=lambda chain: bool(chain.closing.rows),
    ),
    RobotFunction(
        "inverse_dynamics_with_loops",
        "q v vdot w_ext",
        {
            "force": Signal(("NV",), "N*m, N", "-", "generalised forces of drives; what else the motion needs"),
            "loop_wrench": Signal(("NLINKS", 6), WRENCH, TIP, "of the loops on each tip"),
        },
        programs.inverse_dynamics_with_loops,
        (INVERSE, MOTION, LEVERS),
        "Inverse dynamics with closed loops: on axes without a drive nothing else acts, and efforts are least.",
        offered=lambda chain: bool(chain.closing.rows),
    ),
    RobotFunction(
        "coupling_torques",
        "q v tau w_ext",
        {"torque": Signal(("NAXES",), AXES, "-", "of the couplings on each joint axis")},
        programs.coupling_torques,
        (FORWARD, MOTION),
        "The torques with which couplings act on the joint axes.",
        offered=lambda chain: bool(chain.closing.couplings),
    ),
    RobotFunction(
        "marker_pose",
        "q",
        _pose("rotation of every marker", "point of every marker", "NMARKERS"),
        sensors.marker_pose,
        (PLACED,),
        "The poses of the markers.",
        c_file=SENSORS,
        sensor=True,
    ),
    _OF_SENSORS["marker_velocity"],
    RobotFunction(
        "marker_jacobian",
        "q",
        {"J": Signal(("NMARKERS", 6, "NV"), "rad, m per unit of q", MARKER, "J v is the twist of every marker")},
        sensors.marker_jacobian,
        (MOVING,),
        "The Jacobians of the markers.",
        c_file=SENSORS,
    ),
    RobotFunction(
        "marker_bias",
        "q v",
        {"bias": Signal(("NMARKERS", 6), ACCELERATION, MARKER, "J vdot + bias is the acceleration of every marker")},
        sensors.marker_bias,
        (ACCELERATING,),
        "The accelerations of the markers that rates alone cause.",
        c_file=SENSORS,
    ),
    _OF_SENSORS["gyro"],
    _OF_SENSORS["accelerometer"],
    RobotFunction(
        "strain",
        "q",
        {"strain": Signal(("NSTRAINS",), "1, 1/m, rad/m", "-", "stretch, curvatures, twist and shear")},
        sensors.strain,
        (STRAINED,),
        "The strains of the centrelines at the bases of links and at the markers that they declare.",
        c_file=SENSORS,
        offered=lambda chain: bool(strain_names(chain)),
    ),
)
FUNCTIONS = (*_LISTED, *(row for row in _OF_SENSORS.values() if row not in _LISTED))
"""The functions of a robot; `mass_matrix`, which each back end makes in its own way, is none of them."""
BY_NAME = {function.name: function for function in FUNCTIONS}
SENSED = tuple(row.name for row in FUNCTIONS if row.sensor and row.c_file == SENSORS)
"""What sensors read, and runs and mock-up units report where it is asked for."""


def known(chain: Chain) -> Mapping[str, RobotFunction]:
    """The functions by name, those of the sensors that a `Robot` of Python holds behind the product's."""
    own = {row.name: own_function(row) for row in chain.robot.sensors if row.told}
    if twice := own.keys() & BY_NAME.keys():
        raise UsageError(f"sensors: '{min(twice)}' is a function that the product has; take another name")
    return BY_NAME | own if own else BY_NAME


def offered(chain: Chain) -> tuple[RobotFunction, ...]:
    """The functions that a robot has."""
    return tuple(_offered(chain, known(chain).values()))


def _offered(chain: Chain, functions: Iterable[RobotFunction]) -> Iterator[RobotFunction]:
    return (function.of(chain) for function in functions if function.offered(chain))


def reported(chain: Chain) -> tuple[RobotFunction, ...]:
    """The functions that ``<robot>_outputs.c``, runs and mock-up units report."""
    return in_file(OUTPUTS, chain)


def sensed(chain: Chain) -> tuple[RobotFunction, ...]:
    """The functions of sensors that mock-up units report where they are asked for; strains they have anyway."""
    return tuple(row for row in in_file(SENSORS, chain) if row.sensor)


def of_sensors(chain: Chain) -> tuple[RobotFunction, ...]:
    """Those of all sensors, which linear models have as outputs where they are asked for; strains they have anyway."""
    return tuple(row for row in offered(chain) if row.sensor)


def in_file(name: str, chain: Chain) -> tuple[RobotFunction, ...]:
    """The functions that a file of the C has."""
    return tuple(_offered(chain, (function for function in known(chain).values() if function.c_file == name)))
