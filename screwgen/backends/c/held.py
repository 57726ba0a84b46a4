"""What a step holds of its inputs, in generated C: the traced program of the held laws, and that of its slopes."""

from __future__ import annotations

from ...algorithms.held_slopes import held_slopes
from ...algorithms.robot_programs import held_inputs
from ...ir.program import Program
from ...topology.chain import Chain
from .batch import FunctionOfLanes
from .code import Place, Writer, entries, trimmed, with_unused
from .laws import TESTS
from .pieces import piece_place

TAKEN = frozenset("c state input held g own motion by_q by_v by_tau rows stride i k".split())
"""The names of parameters and variables of the functions."""


def features(chain: Chain) -> tuple[str, ...]:
    """What held laws write in the files of every robot, as :class:`..template_places.TemplatePlaces` finds it."""
    return ("held",) * chain.holds + ("held_by_motion",) * chain.holds_by_motion


def content(chain: Chain, baked: bool, place: Place) -> dict:
    """The templates' context; ``place`` is that of the fused function.

    ``words``: what the laws are called; ``lines``, ``lane_lines``: the body of the function that finds what is held;
    ``slopes``: that of its derivatives, ``inputs`` and ``columns`` of those with the motion, which ``moving`` says
    whether there are; ``refused``: what the laws' constants may not be.
    """
    constants = "baked" if baked else "constants"
    program, (slopes, places) = held_inputs(chain, constants), held_slopes(chain, constants)
    of_lanes = {"tau": entries("g->given"), "held": entries("g->u.tau"), "q": entries("g->x.q"), "v": entries("g->x.v")}
    of_slopes = {"by_tau": entries("own"), "by_motion": entries("motion")}
    laws = dict.fromkeys(law for own in chain.laws_of_inputs for law in own)
    return {
        "words": ", ".join(law.WORDS for law in laws),
        "operations": program.operation_count,
        "moving": chain.holds_by_motion,
        "lines": _body(chain, program, {"held": entries("held->tau")}, place),
        "lane_lines": _body(chain, program, of_lanes, place, FunctionOfLanes),
        "slopes": _body(chain, slopes, of_slopes, place),
        "inputs": [k for k, _ in places],
        "columns": [column for _, column in places],
        "refused": list(_refused(chain)) if not baked else [],
    }


def switches(chain: Chain) -> bool:
    """Whether any of the laws or their slopes calls `on`."""
    made = (held_inputs(chain, "constants"), held_slopes(chain, "constants")[0]) if chain.holds else ()
    return any("on" in program.operations for program in made)


def _body(chain: Chain, program: Program, own: dict, place: Place, writer: type[Writer] = Writer) -> list[str]:
    """The statements of a function of constants, state and input."""
    placed = piece_place(chain, "", own, place)
    lines = trimmed(writer(program, placed, None, {*TAKEN}).lines())
    return with_unused(("c", "state") if writer is Writer else ("c",), lines)


def _refused(chain: Chain) -> list[str]:
    """The conditions on the laws' constants that no robot has."""
    return [
        TESTS[key.sign].format(f"c->links[{i}].{label}")
        for i, own in enumerate(chain.keys)
        for law in own.held_laws
        for label, key in zip(law.labels, law.kind.table().values(), strict=True)
        if key.sign in TESTS
    ]
