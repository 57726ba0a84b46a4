"""The estimator of the C back end: an extended Kalman filter on the generated dynamics and their derivatives."""

from __future__ import annotations

from collections.abc import Callable

from ...algorithms import fused
from ...algorithms.gauges import Gauge, gauges
from ...algorithms.tip_acceleration import tip_acceleration
from ...topology.chain import Chain
from .code import Place, entries, literal, singular
from .derivatives import say_time
from .pieces import piece_place, pieces

FILES = ("estimator.h", "estimator.c")
"""The files that an estimator adds, without the robot's name; their templates have the same names."""

SLOPES = ("a_q", "a_v", "a_vdot")


def content(chain: Chain, baked: bool, place: Place) -> dict:
    """The templates' context; ``place`` is that of the fused function."""
    program = tip_acceleration(chain, "baked" if baked else "constants")
    say_time(chain, "accelerations of the tip", program.operation_count)
    own = {slope: _by_columns(slope) for slope in SLOPES}
    own |= {"a": entries("work->a"), "vdot": entries("work->derivatives.vdot")}
    return pieces(program, piece_place(chain, "work->kept", own, place), ("c", "state", "work")) | {
        "slopes_of_stumpff": bool({"c6", "c7"} & program.operations.keys()),
        "per_prediction": 11 * chain.nv**3 + 24 * len(chain.closures) * chain.nv**2,
        "per_entry": 6 * chain.nv**2,
        "gauges": [_gauge(chain, g) for g in gauges(chain)],
        "curvatures": _curvatures(chain),
        "gaps": _gaps(chain, baked, place) if chain.closures else [],
        "stabilisations": [literal(c.stabilisation) for c in chain.closures],
    }


def _by_columns(slope: str) -> Callable[[int], str]:
    """The C expressions of the entries of a matrix with three rows, numbered column by column."""
    return lambda k: f"work->{slope}[{k % 3}][{k // 3}]"


def _gaps(chain: Chain, baked: bool, place: Place) -> list:
    """The functions that find the gaps of the loops, in one piece as they are short."""
    placed = piece_place(chain, "work->kept", {"gap": entries("work->gap")}, place)
    body = lambda f, x: {"gap": f.gaps(x["q"], [0.0] * chain.nv)[0]}  # noqa: E731
    program = fused.fuse(chain, "gaps", {"q": chain.nq}, body, "baked" if baked else "constants")
    return pieces(program, placed, ("c", "state", "work"), program.operation_count, fail=singular)["pieces"]


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
