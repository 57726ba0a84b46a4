"""The estimator of the C back end: an extended Kalman filter on the generated dynamics and their derivatives."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from ...algorithms.gauges import Gauge, gauges
from ...algorithms.joint_moves import midpoint_carry
from ...algorithms.joint_sensors import PoseSensor, encoders, pose_measurements, pose_sensors
from ...algorithms.tip_acceleration import tip_acceleration
from ...joints.kind import JointKind
from ...topology.chain import Chain
from .code import Place, Writer, entries, literal, trimmed, with_unused
from .curved import plus, stem
from .derivatives import say_time
from .pieces import piece_place, pieces
from .stumpff_slopes import slopes

FILES = ("estimator.h", "estimator.c")
"""The files that an estimator adds, without the robot's name; their templates have the same names."""

PATIENCE = 20
"""How often in a row a gate refuses an entry of a measurement unless one states it."""
SLOPES = ("a_q", "a_v", "a_vdot")


def content(chain: Chain, baked: bool, place: Place) -> dict:
    """The templates' context; ``place`` is that of the fused function."""
    program = tip_acceleration(chain, "baked" if baked else "constants")
    say_time(chain, "accelerations of the tip", program.operation_count)
    own = {slope: _by_columns(slope) for slope in SLOPES}
    own |= {"a": entries("work->a"), "vdot": entries("work->derivatives.vdot")}
    return (
        pieces(program, piece_place(chain, "work->kept", own, place), ("c", "state", "work"), outline=True)
        | {
            "slopes_of_stumpff": slopes([program]),
            "per_prediction": 11 * chain.nv**3 + 24 * len(chain.closing.rows) * chain.nv**2,
            "per_update": 3 * chain.nv**3,
            "per_entry": 4 * chain.nv**2,
            "patience": PATIENCE,
            "gauges": [_gauge(chain, g) for g in gauges(chain)],
            "curvatures": _curvatures(chain),
            "encoders": encoders(chain),
            "square": lambda name, at: " + ".join(f"{name}[{k}] * {name}[{k}]" for k in range(at, at + 4)),
        }
        | _curved(chain)
    )


def _curved(chain: Chain) -> dict[str, object]:
    """What joints whose coordinates do not add up bring: their measurements, and how changes of them are carried."""
    sensors, sizes = pose_sensors(chain), pose_measurements(chain)
    widest = max((part.joint.nv for part in chain.curved), default=0)
    links = [chain.names[one.part.link] for one in sensors if one.word == "joint"]
    posed = "the base's pose" if not links else "ball joints" if len(links) == len(sensors) else "base and ball joints"
    base = ["Position, attitude and angular rate of the floating base may be measured, too."]
    balls = ["Attitudes and angular rates of ball joints may be measured, too, in this order:", f"{', '.join(links)}."]
    words = dict.fromkeys(one.word for one in sensors)
    return {
        "posed": posed,
        "Posed": posed[0].upper() + posed[1:],
        "told": base * (len(links) < len(sensors)) + balls * bool(links),
        "widest": widest,
        "carries": [_carry(joint, widest) for joint in dict.fromkeys(part.joint for part in chain.curved)],
        "poses": [_pose(one) for one in sensors],
        "measured": [
            {"name": name, "n_values": values, "n_variances": variances, **SAID[name]._asdict()}
            for name, (values, _, variances) in sizes.items()
        ],
        "flags": [
            ", ".join(f"has_{name}[{flags}]" for name, (_, flags, _) in sizes.items() if name.startswith(word))
            for word in words
        ],
    }


class Said(NamedTuple):
    """The comments in C on the variance and on the value of a measurement."""

    variance: str
    value: str


SAID = {
    "base_position": Said("m^2", "m: q[0] to q[2]"),
    "base_attitude": Said(
        "rad^2: of turns about axes of the base",
        "quaternion as q[3] to q[6], of either sign; scaled to length one",
    ),
    "base_rate": Said("rad^2/s^2", "rad/s: v[0] to v[2], a gyroscope's in axes of the base"),
    "joint_attitude": Said(
        "rad^2: of turns about axes of the joint's link",
        "quaternions as in q, of either sign; scaled to length one",
    ),
    "joint_rate": Said("rad^2/s^2", "rad/s: as in v, relative to the carrier, in axes of the joint's link"),
}


def _pose(one: PoseSensor) -> dict[str, object]:
    part = one.part
    places = {"q": part.q.start, "v": part.v.start, "turn": plus(part.q.start + (part.joint.turn_at or 0))}
    return {"word": one.word, "number": one.number, "position": one.position} | places


def _carry(joint: JointKind, widest: int) -> dict[str, object]:
    """The function that finds how changes of a kind's coordinates are carried over a step."""
    program, n = midpoint_carry(joint), joint.nv
    own = lambda name, k: f"u[{k}]" if name == "u" else f"E[{k // n}][{k % n}]"  # noqa: E731
    lines = with_unused(("u",), trimmed(Writer(program, own, None, {"u", "E"}).lines()))
    said = f"A {joint.name} joint: E of the change u that its rates make in half a step."
    return {"stem": stem(joint), "nv": n, "said": said, "lines": lines}


def _by_columns(slope: str) -> Callable[[int], str]:
    """The C expressions of the entries of a matrix with three rows, numbered column by column."""
    return lambda k: f"work->{slope}[{k % 3}][{k // 3}]"


def _gauge(chain: Chain, gauge: Gauge) -> dict:
    link = chain.robot.links[gauge.link]
    assert link.length is not None, "a link that bends has a length"
    return {
        "link": gauge.link,
        "first": gauge.first,
        "count": len(gauge.curvatures),
        "length": literal(link.length),
        "text": f"{link.name}, bending in {gauge.direction[-1]}",
    }


def _curvatures(chain: Chain) -> list[str]:
    """The second derivative of every mode shape at s = 0; zero for all but bending, which is what is measured."""
    out = [0.0] * max(chain.n_modes, 1)
    for gauge in gauges(chain):
        out[gauge.first : gauge.first + len(gauge.curvatures)] = gauge.curvatures
    return [literal(x) for x in out]
