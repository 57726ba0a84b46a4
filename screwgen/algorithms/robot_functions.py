"""The functions of a robot that every back end offers, each stated once.

An example: the power of the drives. It is a function of ``q``, ``v`` and ``tau`` with one result, an entry in W for
each drive. Its row in ``FUNCTIONS`` says this and names the lines that compute it, which run on values of any algebra.
From the row come a CasADi function, one on arrays of JAX, one on NumPy's, one of C with its call in the library,
columns of runs and rollouts, variables of mock-up units, docs/functions.md. CONTRIBUTING.md says what one takes.
"""

from __future__ import annotations

from ..bodies.validity import MEASURES
from ..topology.chain import Chain
from . import fused, sensors
from . import robot_programs as programs
from .force_functions import MOTION
from .functions import CYLINDERS, ENERGY, FORWARD, HOLD, INVERSE, LEVERS, MEASURING, PLACES
from .gauges import strain_names
from .input_functions import LENGTHS, POWER
from .marker_functions import ACCELERATING, MOVING, PLACED, STRAINED
from .momentum import CENTRED, MOMENTUM
from .robot_function import RobotFunction
from .signals import ACCELERATION, INERTIAL, ROBOT, TIP, TWIST, WRENCH, Signal

OUTPUTS, SENSORS = "outputs", "sensors"
"""The files of the C: what runs, rollouts and mock-up units report at every sample, and what only who asks is told."""
SENSED = ("cylinder_length", "marker_pose", "marker_velocity", "gyro", "accelerometer")
ROTATION, PLACE, MARKER = (3, 3), (3,), "axes of the marker"


def _pose(turned: str, placed: str, *count: str) -> dict[str, Signal]:
    """Rotation and point of one frame, or of a number of them, in the inertial frame."""
    R, position = Signal((*count, *ROTATION), "-", INERTIAL, turned), Signal((*count, *PLACE), "m", INERTIAL, placed)
    return {"R": R, "position": position}


AXES = "N*m, of axes that slide N"
FUNCTIONS = (
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
    RobotFunction(
        "cylinder_length",
        "q",
        {"cylinder_length": Signal(("NCYLINDERS",), "m", "-", "length of every cylinder")},
        programs.cylinder_length,
        (CYLINDERS,),
        "The lengths of the cylinders that drive joints, between their eyes, in the order of their joints.",
        offered=lambda chain: bool(chain.cylinders),
        c_file=SENSORS,
    ),
    RobotFunction(
        "tendon_length",
        "q",
        {"length": Signal(("NTENDONS",), "m", "-", "length of every tendon")},
        programs.tendon_length,
        (LENGTHS,),
        "The lengths of the tendons, each the sum of its pieces.",
        offered=lambda chain: bool(chain.n_tensions),
        c_file=OUTPUTS,
    ),
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
    ),
    RobotFunction(
        "marker_velocity",
        "q v",
        {"twist": Signal(("NMARKERS", 6), TWIST, MARKER, "[omega; v] of every marker")},
        sensors.marker_velocity,
        (MOVING,),
        "The twists of the markers.",
        c_file=SENSORS,
    ),
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
    RobotFunction(
        "gyro",
        "q v",
        {"omega": Signal(("NMARKERS", 3), "rad/s", MARKER, "angular velocity of every marker")},
        sensors.gyro,
        (MOVING,),
        "What gyroscopes at the markers read.",
        c_file=SENSORS,
    ),
    RobotFunction(
        "accelerometer",
        "q v tau w_ext",
        {"a": Signal(("NMARKERS", 3), "m/s^2", MARKER, "acceleration of every marker less that of free fall")},
        sensors.accelerometer,
        (FORWARD, ACCELERATING),
        "What accelerometers at the markers read: at rest gravity, upwards; in free fall nothing.",
        c_file=SENSORS,
    ),
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
"""The functions of a robot; `mass_matrix`, which each back end makes in its own way, is none of them."""


def offered(chain: Chain) -> tuple[RobotFunction, ...]:
    """The functions that a robot has."""
    return tuple(function.of(chain) for function in FUNCTIONS if function.offered(chain))


def reported(chain: Chain) -> tuple[RobotFunction, ...]:
    """The functions that ``<robot>_outputs.c``, runs and mock-up units report."""
    return in_file(OUTPUTS, chain)


def sensed(chain: Chain) -> tuple[RobotFunction, ...]:
    """The functions of sensors that mock-up units report where they are asked for; strains they have anyway."""
    return tuple(row for row in in_file(SENSORS, chain) if row.name in SENSED)


def in_file(name: str, chain: Chain) -> tuple[RobotFunction, ...]:
    """The functions that a file of the C has."""
    return tuple(function for function in offered(chain) if function.c_file == name)


BY_NAME = {function.name: function for function in FUNCTIONS}
