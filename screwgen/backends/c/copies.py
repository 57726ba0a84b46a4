"""Copies from array to array in C: loops over consecutive entries."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Sequence

LOOP = 4
"""The fewest consecutive copies that are a loop."""
ENTRY = re.compile(r"(.+)\[(\d+)\]")


def array(declarator: str, values: Sequence[str], width: int) -> list[str]:
    """An array of values: first those that follow no other array, then copies of entries."""
    name = declarator.split()[-1]
    pairs = [(f"{name}[{k}]", value) for k, value in enumerate(values)]
    runs = _runs([(*_entry(place), *_entry(value)) for place, value in pairs])
    long = next((k for k, run in enumerate(runs) if len(run) >= LOOP), len(runs))
    first = sum(len(run) for run in runs[:long])
    if not first:
        return [f"{declarator}[{len(values)}];", *copied(pairs)]
    text = textwrap.wrap(", ".join(values[:first]), width, break_long_words=False)
    lines = [f"{declarator}[{len(values)}] = {{", *(f"    {line}" for line in text), "};"]
    short = f"{lines[0]} {text[0]} }};"
    return [*([short] if len(text) == 1 and len(short) <= width else lines), *copied(pairs[first:])]


def copied(pairs: Iterable[tuple[str, str]], assign: str = "=") -> list[str]:
    """Assignments of places and values; of consecutive entries of two arrays by a loop."""
    out: list[str] = []
    for run in _runs([(*_entry(place), *_entry(value)) for place, value in pairs]):
        place, i, value, j = run[0]
        if len(run) < LOOP:
            out += [f"{_text(p, m)} {assign} {_text(v, n)};" for p, m, v, n in run]
            continue
        at = lambda array, first: f"{array}[k + {first}]" if first else f"{array}[k]"  # noqa: E731
        out += [f"for (int k = 0; k < {len(run)}; ++k) {{", f"    {at(place, i)} {assign} {at(value, j)};", "}"]
    return out


def _entry(text: str) -> tuple[str, int]:
    """The array and the number of an entry; -1 of other expressions."""
    found = ENTRY.fullmatch(text)
    return (found[1], int(found[2])) if found else (text, -1)


def _text(array: str, number: int) -> str:
    return array if number < 0 else f"{array}[{number}]"


def _runs(copies: Sequence[tuple[str, int, str, int]]) -> list[list[tuple[str, int, str, int]]]:
    """The copies in groups of consecutive entries of two arrays."""
    out: list[list[tuple[str, int, str, int]]] = []
    for place, i, value, j in copies:
        last = out[-1][-1] if out else None
        if last and j >= 0 and last == (place, i - 1, value, j - 1):
            out[-1].append((place, i, value, j))
        else:
            out.append([(place, i, value, j)])
    return out
