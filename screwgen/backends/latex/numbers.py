"""The numbers of a robot for the symbols that are known before the state: parameters and what follows from them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

import mpmath
import numpy as np
import sympy as sp

from ...algebra.components import Array
from ...algebra.notation import number
from ...algorithms import fused
from ...algorithms.schedule import preparation
from ...algorithms.scope import derived
from ...ir.block import Binding, Block
from ...ir.replay import run
from ...spec.parameters import parameters
from ...spec.robot import Robot
from ...topology.chain import Chain
from ..numpy.vibrations import held_frequencies
from .content import DocumentTable, unit
from .scalars import entry
from .symbols import written

BLOCKS = ("link", "tip", "tip_body", "joint")
"""The blocks that have the constants of a link."""
MANY_LINKS, MANY_ENTRIES = 12, 81
"""Numbers of more links, and matrices with more entries, are not listed."""
MODAL = ("M_eta", "K")
"""The quantities of the table of modes."""
MANY_FREQUENCIES = 8
"""Further frequencies of a link are not listed."""
ALONE = (
    "The frequency is that of each mode alone: of the bare link, straight and held at its base, without its bodies and "
    "without its other modes."
)
HELD = (
    "Each link straight and held at its base, with its own bodies and all of its modes, without gravity and without "
    "what it carries. The command `modes` says the same of a robot that has this link alone."
)
"""What the tables of frequencies mean."""
CURVED = {ALONE: ("straight and", "as if it were straight and"), HELD: ("straight and", "at rest and")}
"""The words of them that are others where a link is curved at rest."""


Table = list[list[str]]
"""The entries of a matrix, row by row."""


def about(text: str, chain: Chain) -> str:
    """What a table of frequencies means."""
    return text.replace(*CURVED[text]) if any(key.rest for key in chain.keys) else text


def numbers(chain: Chain) -> dict[str, dict[str, Table]]:
    """By a symbol's LaTeX, and by the name of the link: its entries."""
    out: dict[str, dict[str, Table]] = {}
    for i, name in enumerate(chain.names[:MANY_LINKS]):
        for display, table in _of_link(chain, i).items():
            out.setdefault(display, {})[name] = table
    return out


def modes(chain: Chain) -> DocumentTable | None:
    """The modes of the links: inertia, stiffness, frequency of each mode alone. None if there are none."""
    rows = [row for i in range(min(chain.n, MANY_LINKS)) for row in _modes(chain, i)]
    head = ("link", "name", "mode", "direction", "inertia", "stiffness", "frequency, mode alone")
    return DocumentTable(head, (0.06, 0.17, 0.07, 0.18, 0.17, 0.2, 0.15), tuple(rows)) if rows else None


def _of_link(chain: Chain, i: int) -> dict[str, Table]:
    key, out = chain.keys[i], {}
    blocks = [derived(key)[name] for name in BLOCKS]
    known = values(chain, i, blocks)
    for block in blocks:
        for name, entries in _constants(block).items():
            symbols = set().union(*(entry.free_symbols for entry in entries.flat))
            if 0 < entries.size <= MANY_ENTRIES and all(symbol.name in known for symbol in symbols):
                table = [[_number(entry, known) for entry in row] for row in entries]
                out[written(block.signal(name))] = table
    return out


def _constants(block: Block) -> dict[str, Array]:
    """The entries of the signals of a block that the state does not change."""
    signals = [*block.inputs.values(), *(step.signal for step in block.steps.values())]
    return {s.name: block.values[s.name] for s in signals if s.binding <= Binding.PARAMETER}


def entries(chain: Chain) -> dict[str, tuple[str, tuple[int, int]]]:
    """By the LaTeX of entries of vectors and matrices: the symbol that they belong to, their row and column."""
    out: dict[str, tuple[str, tuple[int, int]]] = {}
    for block in (block for key in chain.classes for block in derived(key).values()):
        for signal in (*block.inputs.values(), *(step.signal for step in block.steps.values())):
            if signal.shape != (1, 1):
                for index, _ in signal.labels():
                    out.setdefault(entry(signal, index), (written(signal), index))
    return out


def values(chain: Chain, i: int, blocks: list[Block], names: Collection[str] = ()) -> Mapping[str, mpmath.mpf]:
    """The constants of a link by label, from the parameters of the file; those of some quantities or of all."""
    places, p = chain.parameter_labels[i], parameters(chain.robot)
    wanted = [e for b in blocks for name, e in _constants(b).items() if not names or name in names]
    labels = {s.name for e in wanted for x in e.flat for s in x.free_symbols}
    program = preparation(chain.keys[i], tuple(sorted(labels)))
    with mpmath.workdps(30):
        given = {name: [mpmath.mpf(p[places[name[2:]]].value)] for name in program.inputs}
        outputs = run(program, given, fused.precise)[0]
        return {name.removeprefix("c."): x[0] for name, x in outputs.items() if len(x) == 1}


def _value(entry: sp.Expr, known: Mapping[str, mpmath.mpf]) -> float:
    return float(entry.subs({s: sp.Float(str(known[s.name]), 25) for s in entry.free_symbols}))


def _number(entry: sp.Expr, known: Mapping[str, mpmath.mpf]) -> str:
    value = _value(entry, known)
    return f"{value:.5g}" if value else "0"


def _modes(chain: Chain, i: int) -> Iterator[tuple[str, ...]]:
    key, name = chain.keys[i], chain.names[i]
    block = derived(key)["link"]
    constant = _constants(block)
    if not key.modes or not set(MODAL) <= constant.keys():
        return
    known = values(chain, i, [block], MODAL)
    inertia, stiffness = (np.ravel(constant[label]) for label in MODAL)
    for k, (direction, _) in enumerate(key.directions):
        m, stiff = _value(inertia[k], known), _value(stiffness[k], known)
        units = ("kg*m^2", "N*m") if direction == "torsion" else ("kg", "N/m")
        cells = (f"{_shown(m)} {unit(units[0])}", f"{_shown(stiff)} {unit(units[1])}")
        frequency = f"{np.sqrt(stiff / m) / (2 * np.pi):.4g} Hz"
        yield f"{i + 1}", f"`{name}`", f"{k + 1}", direction.replace("_", " in "), *cells, frequency


def held_table(robot: Robot) -> DocumentTable | None:
    """The frequencies of the flexible links, each held at its base with its bodies. None if there are none."""
    rows = []
    for k, link in enumerate(robot.links[:MANY_LINKS]):
        found = held_frequencies(robot, k)
        shown = ", ".join(f"{f:.4g}" for f in found[:MANY_FREQUENCIES]) + ", …" * (len(found) > MANY_FREQUENCIES)
        rows += [(f"`{link.name}`", f"{shown} Hz")] if len(found) else []
    return DocumentTable(("link", "frequencies, held at its base"), (0.25, 0.75), tuple(rows)) if rows else None


def _shown(value: float) -> str:
    return f"${number(sp.Float(f'{value:.5g}'))}$"
