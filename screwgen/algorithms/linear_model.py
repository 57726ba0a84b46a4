"""Small motions about a state: derivatives of the dynamics and its outputs, of closed loops and of the statics."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from ..ir.derivative import columns, tangents
from ..ir.program import Node, Program, Value, Vector
from ..topology.chain import Chain
from . import matrices as mx
from .functions import ENERGY, INVERSE, MOTION, PLACES, Functions
from .fused import fuse, inputs
from .marker_functions import STRAINED
from .response import POINT
from .robot_function import RobotFunction
from .sensors import ALL, marker_motion

OUTPUTS = ("coordinates", "rates", "position", "velocity", "acceleration", "wrench", "strain")
"""Coordinates and rates, the motion of the last tip in the inertial frame, joint wrenches, strains."""
SENSED = "sensed_"
"""Before the names of functions of sensors."""


def changes(chain: Chain, sensors: Sequence[RobotFunction] = ()) -> Program:
    """``OUTPUTS``, what ``sensors`` read as ``sensed_…``, and ``vdot``; as ``…_along`` derivatives along a direction.

    Of ``(q, v, tau, w_ext, p)`` and the direction ``(d_q, d_v, d_tau, d_w_ext)``. ``d_q`` (nv,) is a change of the
    posture along v: of a floating base a turn and a displacement in axes of F_1.
    """

    def body(f: Functions, x: Mapping[str, Sequence]) -> dict[str, Sequence[Value]]:
        vdot, wrench = f.forward_dynamics(x["q"], x["v"], x["tau"], x["w_ext"])
        found = {
            "vdot": vdot,
            "coordinates": x["q"],
            "rates": x["v"],
            **_tip(f, x, vdot),
            "wrench": wrench,
            "strain": f.strains(x["q"]),
        }
        for row in sensors:
            read = row.program.body(f, **{name: x[name] for name in row.names})
            found[SENSED + row.name] = [value for name in row.results for value in read[name]]
        along = {"q": f.coordinate_rates(x["q"], x["d_q"])} | {name: x[f"d_{name}"] for name in POINT[1:]}
        seeds = {a: b for name in POINT for a, b in _moved(x[name], along[name]).items()}
        slopes = iter(tangents([value for values in found.values() for value in values], seeds))
        return found | {f"{name}_along": [next(slopes) for _ in values] for name, values in found.items()}

    given = inputs(chain, " ".join(POINT))
    given |= {f"d_{name}": size for name, size in given.items()} | {"d_q": chain.nv}
    algorithms = (*ALL, STRAINED, *(algorithm for row in sensors for algorithm in row.algorithms))
    return fuse(chain, "linear_model", given, body, algorithms=tuple(dict.fromkeys(algorithms)))


def _tip(f: Functions, x: Mapping[str, Sequence], vdot: Sequence) -> dict[str, list]:
    """Position, velocity and acceleration of the last tip in the inertial frame."""
    k = [(m.is_tip, m.segment) for m in f.chain.markers].index((True, f.chain.last))
    found = marker_motion.body(f, x["q"], x["v"], vdot)
    R = mx.array(found["R"][9 * k : 9 * k + 9], (3, 3))
    velocity, acceleration = (
        mx.multiply(R, mx.array(found[name][6 * k + 3 : 6 * k + 6])) for name in ("twist", "acceleration")
    )
    return {
        "position": list(found["position"][3 * k : 3 * k + 3]),
        "velocity": list(velocity),
        "acceleration": list(acceleration + mx.array(f.gravity)),
    }


def closing(chain: Chain) -> Program:
    """The loops near the posture `q`, of ``(q, v, forces, p)``; matrices column by column, one for each rate.

    ``gap`` (rows,); ``J`` (rows, nv), its derivative along v; ``J_v`` (rows, nv), that of ``J v``; ``bend`` (nv, nv),
    that of ``Jᵀ forces``; ``wrench`` (6 n,): what forces of the rows exert on the tips, in the tip frames.
    """
    units = _units(chain)

    def body(f: Functions, x: Mapping[str, Sequence]) -> dict[str, Sequence[Value]]:
        gap, loads = f.loops_at(x["q"], x["forces"])
        ways = [_moved(x["q"], f.coordinate_rates(x["q"], unit)) for unit in units]
        J = [tangents(gap, way) for way in ways]
        forces = [mx.dot(column, x["forces"]) for column in J]
        rate = [mx.dot(row, x["v"][: chain.nv]) for row in zip(*J, strict=True)]
        found = {"J": J, "J_v": [tangents(rate, way) for way in ways], "bend": [tangents(forces, way) for way in ways]}
        return {"gap": gap, "wrench": loads.w_ext} | {name: _flat(matrix) for name, matrix in found.items()}

    return fuse(chain, "closing", inputs(chain, "q v") | {"forces": len(chain.closing.rows)}, body)


def gap_accelerations(chain: Chain) -> Program:
    """What closes the loops, of ``(q, v, vdot, forces, p)``: ``rows`` are ``g̈ + 2 c ġ + c² g`` of the gaps g.

    ``torque`` on the axes and ``wrench`` (6 n,) on the tips are what forces of the rows exert.
    """

    def body(f: Functions, x: Mapping[str, Sequence]) -> dict[str, Sequence[Value]]:
        (gap, loads), rate = f.loops_at(x["q"], x["forces"]), f.gaps(x["q"], x["v"])[1]
        along = tangents(rate, _moved(x["q"], f.coordinate_rates(x["q"], x["v"])) | _moved(x["v"], x["vdot"]))
        rates = zip(chain.closing.rows, along, rate, gap, strict=True)
        rows = [a + 2.0 * c.stabilisation * b + c.stabilisation**2 * g for c, a, b, g in rates]
        return {"rows": rows, "torque": loads.tau, "wrench": loads.w_ext}

    return fuse(chain, "gap_accelerations", inputs(chain, "q v vdot") | {"forces": len(chain.closing.rows)}, body)


def braked_balance(chain: Chain) -> Program:
    """``balance`` of the rows that brakes act on, of ``(q, v, vdot, tau, efforts, p)``; zero where they are kept."""

    def body(f: Functions, x: Mapping[str, Sequence]) -> dict[str, Sequence[Value]]:
        return {"balance": f.braked_balance(*(x[name] for name in ("q", "v", "vdot", "tau", "efforts")))}

    given = inputs(chain, "q v vdot tau") | {"efforts": len(chain.braked)}
    return fuse(chain, "braked_balance", given, body)


def statics(chain: Chain) -> Program:
    """Rest at `q`, of ``(q, w_ext, p)``, matrices column by column. Of a robot with loops, of its open tree.

    ``potential``, J; ``force`` (nv,): what must act along the rates to keep the robot there, springs included;
    ``stiffness`` (nv, nv): its derivative with a change of the posture along the rates, of a ball joint a turn in its
    own axes; ``weight`` (nv, 3): that with gravity; ``wrench`` (6 n,): the joint wrenches; ``tip`` (3,): the last tip's
    position.
    """

    units = _units(chain)

    def body(f: Functions, x: Mapping[str, Sequence]) -> dict[str, Sequence[Value]]:
        force, wrench = f.statics(x["q"], x["w_ext"])
        return {
            "potential": [f.energy(x["q"], [0.0] * chain.nv)[1]],
            "force": force,
            "stiffness": _flat(tangents(force, _moved(x["q"], f.coordinate_rates(x["q"], unit))) for unit in units),
            "weight": _flat(columns(force, f.gravity)),
            "wrench": wrench,
            "tip": f.poses(x["q"])[1][chain.last][1],
        }

    return fuse(chain, "statics", inputs(chain, "q w_ext"), body, algorithms=(INVERSE, ENERGY, PLACES, MOTION))


def _units(chain: Chain) -> list[list[float]]:
    """A unit of each rate."""
    return [[float(i == k) for i in range(chain.nv)] for k in range(chain.nv)]


def _flat(columns: Iterable[Vector]) -> list[Value]:
    return [value for column in columns for value in column]


def _moved(variables: Vector, rates: Vector) -> dict[Node, Value]:
    """The direction in which the variables change at these rates; numbers among them do not."""
    return {a: b for a, b in zip(variables, rates, strict=True) if isinstance(a, Node)}
