"""What acts on tips, and inputs besides torques, in slopes by recursion: empty for a robot without them.

An example: a spring between two tips. Its wrenches change with the poses and twists of both, by two matrices (12, 12)
that a straight program finds. How the tips move with every coordinate is known from the recursion, so products of the
two in loops are what the spring changes: the text does not grow with what carries the tips.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...algorithms import acting_programs, pair_slopes
from ...algorithms.acting_programs import tips_acted_on
from ...ir.program import Program
from ...spec.link_class import LinkClass
from ...topology.chain import Chain
from .code import Place, entries, singular
from .columns_loop import over_columns, starts
from .pieces import piece_place, pieces

RESULTS = (
    *("by_pose", "by_twist", "twist", "exerted", "f_z", "vdot", "row", "row_units", "row_by_pose", "row_by_twist"),
    *("coupling_J", "coupling_J_q", "coupling_J_v", "coupling_bend"),
)
"""What the programs find, but for the wrenches on all tips."""
POINTERS = ("c", "state", "input", "work")
AT_TIP = {"R": "R[{}]", "twist": "twist[{}]", "a": "moved->a[{}][j]"}
AT_TIP |= {name: f"moved->{name}[{{}}][j]" for name in ("c_q", "c_v")}
"""The expressions of :func:`.tip_column` that are no columns of changes, but for its results."""
AT_BALL = {"J": "tip->J[3 + j][first + {}]", "w": "rates[first + {}]", "V_q": "tip->V_q[3 + j][first + {}]"}
"""Those of :func:`.ball_row`, over rows."""
AT_JOINT = {"R": "joint->R[{}]", "p": "joint->point[{}]", "R_T": "R[{}]", "r_T": "r[{}]"}
AT_JOINT |= {"D_q": "D_q[{}][j]", "D_v": "D_v[{}][j]", "with_q": "with_q[{} * $$_NV + j]"}
"""Those of :func:`.wrench_change`; its rates follow."""


def is_needed(chain: Chain) -> bool:
    """Whether a robot has any of them."""
    return bool(chain.closing.rows or chain.acts_on_tips or chain.other_inputs or chain.n_force_states)


def content(chain: Chain, baked: bool, place: Place) -> dict | None:
    """The templates' context: the program in pieces, and which tips every map joins."""
    if not is_needed(chain):
        return None
    constants, rows = "baked" if baked else "constants", bool(chain.closing.rows)
    program = acting_programs.acting_maps(chain, constants)
    made = _printed(chain, program, place, ("m_eta", "f_eta") * rows)
    held_program = acting_programs.held_maps(chain, constants) if rows else None
    held = _printed(chain, held_program, place, ("at",)) if held_program else None
    tips, ends = tips_acted_on(chain), acting_programs.ends(chain)
    maps = [[tips.index(i) for i in own] for own in ends]
    begins = [sum(36 * len(own) ** 2 for own in maps[:k]) for k in range(len(maps))]
    numbers = acting_programs.row_numbers(chain)
    bearing = [_bearing(chain, i) for i in tips]
    with_v = {"with_v": f"with_v[{{}} * {'$$_NVZ' if chain.n_internal else '$$_NV'} + j]"}
    return made | {
        "programs": [program, *([held_program] if held_program else [])],
        "kept": max(made["kept"], held["kept"] if held else 0),  # of both, which run one after the other
        "rows": numbers,
        "row_ends": [
            [tips.index(chain.closing.rows[k].first), tips.index(chain.closing.rows[k].second)] for k in numbers
        ],
        "couplings": acting_programs.coupled(chain),
        "held": held,
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
        "column": over_columns(pair_slopes.tip_column(rows), AT_TIP | _of_tip(chain)),
        "change": over_columns(pair_slopes.wrench_change(), AT_JOINT | with_v, adding=True),
    }


def _printed(chain: Chain, program: Program, place: Place, given: Sequence[str]) -> dict:
    """A program in pieces; ``given``: what its functions are told besides."""
    own = {name: entries(f"work->{name}") for name in RESULTS}
    own |= {name: entries(name) for name in ("m_eta", "f_eta")} | {"acted": entries("work->input.w_ext", 6)}
    own |= {"row": entries("at->row")} if "at" in given else {}
    return pieces(program, piece_place(chain, "work->kept", own, place), (*POINTERS, *given), fail=singular)


def _of_tip(chain: Chain) -> dict[str, str]:
    """The expressions of what :func:`.tip_column` finds."""
    return {name: f"tip->{name}[{{}}][{rate_of(chain)}]" for name in ("J", "V_q", "acc_q", "acc_v")}


def units(chain: Chain, baked: bool, place: Place) -> dict | None:
    """The program of what joint wrenches gain by a unit of each input, state and row, in pieces; None where there is
    nothing of that."""
    rows = len(chain.closing.rows)
    if not (chain.inputs_load_links or chain.n_force_states or rows):
        return None
    program = acting_programs.wrenches_per_unit(chain, "baked" if baked else "constants")
    own = {
        "wrench_input": entries("work->by_input", 6 * chain.n),
        "wrench_state": entries("work->by_state", 6 * chain.n),
    }
    own |= {"wrench_row": entries("work->by_row", rows)} if rows else {}
    made = pieces(program, piece_place(chain, "kept", own, place), (*POINTERS, "kept"))
    return made | {"programs": [program]}


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
