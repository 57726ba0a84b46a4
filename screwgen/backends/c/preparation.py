"""The preparation of the C back end: constants of the links from their parameters, a function per class of links."""

from __future__ import annotations

from collections.abc import Sequence

from ...algorithms import fused
from ...algorithms.schedule import BUILT_IN, COLUMNS, is_column
from ...ir.program import Program
from ...spec.parameters import parameters
from ...topology.chain import Chain
from .code import Writer, literal, trimmed, with_unused
from .fields import columns
from .parameters import members

NONE: dict[str, list] = {"prepare": [], "prepare_calls": []}
"""The templates' context where constants are numbers of the code."""
STATIC = tuple(name for names in (*COLUMNS.values(), *BUILT_IN) for name in names)
Labels = Sequence[tuple[str, ...]]
"""The constants that the code of every link reads."""


def content(chain: Chain, labels: Labels) -> dict[str, list]:
    """The templates' context."""
    first = {i: chain.keys.index(key) for i, key in enumerate(chain.keys)}
    used = [i for i in range(chain.n) if _prepares(chain, labels, i)]
    functions = [_function(chain, labels, i) for i in used if first[i] == i]
    return {"prepare": functions, "prepare_calls": [_call(chain, i, first[i]) for i in used]}


def tables(chain: Chain, baked: Sequence[dict] | None) -> dict[str, list[str]] | None:
    """Gravity and the robot's columns where all constants are numbers, as C has them; else None."""
    if baked is None:
        return None
    gravity, found = [literal(p.value) for p in parameters(chain.robot)[:3]], fused.columns(chain, baked)
    return {"gravity": gravity} | {name: [literal(x) for x in values] or ["0"] for name, values in found.items()}


def _prepares(chain: Chain, labels: Labels, i: int) -> bool:
    """Whether anything is computed from a link's parameters; a marker has none."""
    return any(fused.preparation(chain.keys[i], labels[i]).outputs.values())


def _function(chain: Chain, labels: Labels, i: int) -> dict:
    program = fused.preparation(chain.keys[i], labels[i])
    outputs = {n: v for n, v in program.outputs.items() if v}
    program = Program(program.name, program.inputs, outputs, [], program.sections)
    given = members(chain.robot, chain.segments[i].link)

    def placed(name: str, k: int) -> str:
        if name.startswith("p."):
            return f"p->{given[name[2:]]}"
        return f"{name}[{k}]" if is_column(name) else f"c->{name}"

    lines = trimmed(Writer(program, placed, None, {"p", "c", *filter(is_column, program.outputs), *STATIC}).lines())
    own = columns(chain, i, lambda name, *_: f"$_real {name}[]")
    lines = with_unused(("p", "c"), lines)
    signature = f"const $_link_parameters *p, $_link_constants *c{own}"
    name = chain.identifiers[i]
    written = [placed(n, k) for n, values in program.outputs.items() for k, _ in enumerate(values)]
    total = [" + ".join(written[k : k + 6]) for k in range(0, len(written), 6)]
    comment = f"links like {name}"
    return {"name": name, "signature": signature, "lines": lines, "total": total, "comment": comment}


def _call(chain: Chain, i: int, first: int) -> str:
    own = columns(chain, i, lambda _, name, k: f"c->{name} + {k}")
    return f"constants_of_{chain.identifiers[first]}(&p->links[{chain.segments[i].link}], &c->links[{i}]{own});"
