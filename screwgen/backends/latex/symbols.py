"""The symbols of a document, gathered from the signals of its blocks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from ...algebra.expression import Symbol
from ...algebra.notation import latex
from ...ir.block import Binding, Block, NamedSignal
from .content import Named, frame, unit, words
from .steps import BlockView
from .text_symbols import TEXT

TIMES = r"\times"
COUNTED = ("n_{q,i}", "r_i")
"""The numbers of joint rates and of modes of a link."""
Counted = tuple[NamedSignal, tuple[int, int]]
"""A signal, and these numbers in the class of links whose block has it."""


@dataclass(frozen=True)
class Entry:
    """One line of the table of symbols."""

    display: str
    meaning: str
    unit: str
    frame: str
    shape: str
    binding: Binding | None


def entries(blocks: Iterable[tuple[Block, BlockView]], named: Iterable[Named] = ()) -> list[Entry]:
    """The symbols of the text and those ``named`` beside, then those of the steps: constants, parameters, state.

    A symbol that is ``named`` replaces that of the text.
    """
    found: dict[str, list[Counted]] = {}
    for block, view in blocks:
        for signal in _signals(block, view):
            found.setdefault(written(signal), []).append((signal, view.counts))
    steps = [_entry(display, known) for display, known in found.items()]
    steps.sort(key=lambda e: Binding.CONSTANT if e.binding is None else e.binding)
    text = {symbol[0]: symbol for symbol in (*TEXT, *named)}
    return [*(e for e in _text(text.values()) if e.display not in found), *steps]


def written(signal: NamedSignal) -> str:
    """A signal as the formulas have it."""
    return latex(Symbol(signal.name, signal.shape, signal.display))


def _text(symbols: Iterable[Named]) -> Iterator[Entry]:
    for display, meaning, unit_, shape, frame_, binding in symbols:
        yield Entry(display, words(meaning), unit(unit_), frame(frame_), _shape_text(shape), binding)


def _signals(block: Block, view: BlockView) -> Iterator[NamedSignal]:
    """The signals that the shown steps define or use."""
    defined = {s.name for s in view.defined}
    yield from (s for s in view.defined if not s.display.startswith("-"))
    for name in dict.fromkeys(used.name.partition("[")[0] for used in view.used):
        if name in block.inputs or (name in block.steps and name not in defined):
            yield block.signal(name)
        elif name in block.along:
            yield block.along[name]


def _entry(display: str, known: list[Counted]) -> Entry:
    first, _ = known[0]
    rows, cols = (_size([(s.shape[d], counts) for s, counts in known]) for d in (0, 1))
    binding = max(s.binding for s, _ in known)
    shape = _shape_text(rows if cols == "1" else f"{rows} × {cols}")
    return Entry(display, words(first.meaning), unit(first.unit), frame(first.frame), shape, binding)


def _size(sizes: list[tuple[int, tuple[int, int]]]) -> str:
    """A dimension: a number, or where links differ the letter of what it is the number of in each of them."""
    found = sorted({size for size, _ in sizes})
    letters = (letter for k, letter in enumerate(COUNTED) if all(counts[k] == size for size, counts in sizes))
    return str(*found) if len(found) == 1 else next(letters, r"\text{ or }".join(map(str, found)))


def _shape_text(shape: str) -> str:
    return "" if shape == "-" else ", ".join(f"${part.replace('×', TIMES)}$" for part in shape.split(", "))
