"""What acts on tips, and inputs besides torques, in slopes by recursion: empty for a robot without them.

An example: a spring between two tips. Its wrenches change with the poses and twists of both, by two matrices (12, 12)
that a straight program finds. How the tips move with every coordinate is known from the recursion, so products of the
two in loops are what the spring changes: the text does not grow with what carries the tips.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...algorithms import pair_slopes
from ...algorithms.tip_programs import acting_maps, tips_acted_on, wrenches_per_unit
from ...spec.link_class import LinkClass
from ...topology.chain import Chain
from .code import Place, entries, singular
from .columns_loop import over_columns, starts
from .pieces import piece_place, pieces

RESULTS = ("by_pose", "by_twist", "velocity", "exerted", "f_z")
POINTERS = ("c", "state", "input", "work")
AT_TIP = {"R": "R[{}]", "v": "v[{}]", "a": "moved->a[{}][j]", "c_v": "moved->c_v[{}][j]"}
"""The expressions of :func:`.tip_column` that are no columns of changes."""
AT_BALL = {"J": "tip->J[3 + j][first + {}]", "w": "rates[first + {}]", "V_q": "tip->V_q[3 + j][first + {}]"}
"""Those of :func:`.ball_row`, over rows."""
AT_JOINT = {"R": "joint->R[{}]", "p": "joint->point[{}]", "R_T": "R[{}]", "r_T": "r[{}]"}
AT_JOINT |= {"D_q": "D_q[{}][j]", "D_v": "D_v[{}][j]", "with_q": "with_q[{} * $$_NV + j]"}
"""Those of :func:`.wrench_change`; its rates follow."""


def is_needed(chain: Chain) -> bool:
    """Whether a robot has any of them."""
    return bool(chain.acts_on_tips or chain.other_inputs or chain.n_force_states)


def content(chain: Chain, baked: bool, place: Place) -> dict | None:
    """The templates' context: the program in pieces, and which tips every map joins."""
    if not is_needed(chain):
        return None
    program = acting_maps(chain, "baked" if baked else "constants")
    own = {name: entries(f"work->{name}") for name in RESULTS}
    made = pieces(program, piece_place(chain, "work->kept", own, place), POINTERS, fail=singular)
    tips = tips_acted_on(chain) if chain.acts_on_tips else []
    maps = [[tips.index(i) for i in ends] for ends in _ends(chain)] if tips else []
    begins = [sum(36 * len(ends) ** 2 for ends in maps[:k]) for k in range(len(maps))]
    bearing = [_bearing(chain, i) for i in tips]
    with_v = {"with_v": f"with_v[{{}} * {'$$_NVZ' if chain.n_internal else '$$_NV'} + j]"}
    return made | {
        "programs": [program],
        "tips": tips,
        "nodes": [chain.tree.tip(i) for i in tips],
        "maps": maps,
        "begins": begins,
        "bearing": [i for links in bearing for i in links],
        "bearing_at": starts(bearing),
        "base": chain.base_v,
        "balls": [part.v.start for part in chain.curved if part.v.start >= chain.base_v] if tips else [],
        "ball_row": over_columns(pair_slopes.ball_row(), AT_BALL, adding=True),
        "sizes": {name: len(program.outputs.get(name, ())) for name in RESULTS},
        "column": over_columns(
            pair_slopes.tip_column(), AT_TIP | {name: f"tip->{name}[{{}}][{rate_of(chain)}]" for name in ("J", "V_q")}
        ),
        "change": over_columns(pair_slopes.wrench_change(), AT_JOINT | with_v, adding=True),
    }


def units(chain: Chain, baked: bool, place: Place) -> dict | None:
    """The program of what joint wrenches gain by a unit of each input and state, in pieces; None where they gain none."""
    if not (chain.inputs_load_links or chain.n_force_states):
        return None
    program = wrenches_per_unit(chain, "baked" if baked else "constants")
    own = {"wrench_input": entries("work->by_input", 6 * chain.n), "wrench_state": entries("work->by_state", 6 * chain.n)}
    made = pieces(program, piece_place(chain, "kept", own, place), (*POINTERS, "kept"))
    return made | {"programs": [program]}


def _ends(chain: Chain) -> list[Sequence[int]]:
    """The segments at whose tips each of :meth:`.force_maps` ends."""
    return [*((i,) for i in chain.turned_wrenches), *(force.tips for force in chain.forces)]


def _bearing(chain: Chain, i: int) -> list[int]:
    """The links whose joints bear what acts on the tip of link i; none is a base that floats."""
    out = []
    while i >= 0:
        out += [i] * bears(chain.keys[i])
        i = chain.tree.parents[i]
    return out


def bears(key: LinkClass) -> bool:
    """Whether a link's joint has a wrench; that of a floating base has none, unless its motion is given."""
    return not key.floats or key.joint.given


def rate_of(chain: Chain) -> str:
    """The rate to which a column j of changes belongs: those of what stations carry stand behind the others."""
    return "j - shift" if any(chain.tree.stations) else "j"
