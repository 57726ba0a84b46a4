"""Robot files with other numbers: the text stays as it is, comments included, and the numbers in it are replaced.

Which number of the file states a parameter is found by trying: the number is changed a little, the robot is made again,
and the parameters that changed are those that it states.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from ..errors import ScrewgenError, UsageError
from ..spec.load import decode, loads, one_line, read
from ..spec.parameters import parameters
from .file_numbers import FileNumbers

TOKEN = re.compile(
    r'#[^\n]*|"""[\s\S]*?"""|\'\'\'[\s\S]*?\'\'\'|"(?:\\.|[^"\\\n])*"|\'[^\'\n]*\''
    r"|(?<![\w.+-])(?P<number>[+-]?\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][+-]?\d[\d_]*)?)(?![\w.:-])"
)
NUDGE = 1e-6
DIGITS = 6


class NumberPlace(NamedTuple):
    """Where a number stands in a text."""

    start: int
    end: int
    value: float


def numbers(text: str) -> list[NumberPlace]:
    """The numbers of a TOML text, without those in strings and comments."""
    found = (match for match in TOKEN.finditer(text) if match["number"])
    return [NumberPlace(match.start(), match.end(), float(match["number"].replace("_", ""))) for match in found]


def with_values(text: str, values: Mapping[str, float], notes: Mapping[str, str], file: str, folder: str = "") -> str:
    """The text with parameters at these values, each with its note as a comment at the end of its line.

    Raises UsageError where no number of the file states a parameter by itself.
    """
    where = _places(text, list(values), file, folder)
    edits = sorted(
        ((where[name], f"{value:.{DIGITS}g}", notes.get(name, "")) for name, value in values.items()), reverse=True
    )
    said: dict[int, list[str]] = {}
    for place, number, note in edits:
        text = text[: place.start] + _as_float(number) + text[place.end :]
        if note:
            said.setdefault(text.count("\n", 0, place.start), []).insert(0, note)
    lines = text.split("\n")
    for line, comments in said.items():
        there = lines[line].rstrip()
        joint = "; " if re.search(r"#[^\"']*$", there) else " # "
        lines[line] = there + joint + "; ".join(comments)
    return "\n".join(lines)


def check_stated(path: str | os.PathLike[str], names: Sequence[str]) -> None:
    """Raises UsageError where no number of a robot file states one of these parameters or numbers by itself."""
    file = one_line(os.fsdecode(path))
    _places(decode(read(path, file), file), names, file, folder_of(path))


def _as_float(number: str) -> str:
    return number if re.search(r"[.e]", number) else f"{number}.0"


def _places(text: str, names: Sequence[str], file: str, folder: str) -> dict[str, NumberPlace]:
    """The number of the text that states each parameter, and none besides, or has that name in the file."""
    known = parameters(loads(text, file, folder))
    others = set(names) - {one.name for one in known}
    of_file = {name: x for name, x in FileNumbers(text, file).names.items() if name in others}
    start = np.array([x.value for x in known])
    out: dict[str, NumberPlace] = {}
    stated: set[str] = set()
    for place in numbers(text):
        for name in [name for name, one in of_file.items() if one.value == place.value]:
            other = place.value * (1 + NUDGE)
            changed_file = FileNumbers(_replaced(text, place, other), file).names
            if name in changed_file and changed_file[name].value == other:
                out[name] = place
        if len(of_file) == len(set(names)):
            continue
        changed = _changed(text, place, start, file, folder)
        for k in changed:
            name = known[k].name
            if len(changed) == 1 and abs(start[k] - place.value) <= 1e-12 * abs(place.value):
                out.setdefault(name, place)
            stated.add(name)
    for name in names:
        if name not in out:
            how = "together with others" if name in stated else "by no number"
            raise UsageError(f"{file}: {name} is stated {how}; state it by a number of its own, then identify it")
    return {name: out[name] for name in names}


def _changed(text: str, place: NumberPlace, start: np.ndarray, file: str, folder: str) -> np.ndarray:
    """Which parameters change with a number of the text; none where it is no such number."""
    for other in (place.value * (1 + NUDGE) or NUDGE, place.value * (1 - NUDGE)):
        try:
            now = np.array([x.value for x in parameters(loads(_replaced(text, place, other), file, folder))])
        except ScrewgenError:
            continue
        if now.shape == start.shape:
            return np.flatnonzero(now != start)
    return np.zeros(0, int)


def _replaced(text: str, place: NumberPlace, value: float) -> str:
    return text[: place.start] + repr(value) + text[place.end :]


def folder_of(path: str | os.PathLike[str]) -> str:
    """The folder in which the files lie that a robot file names."""
    return os.path.dirname(os.fspath(path))
