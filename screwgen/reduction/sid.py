"""Standard input data (SID) of a flexible body as text, after Wallrapp: the file's objects, read and written.

A file is a tree of named objects, each closed by ``end``. The leaves are matrices that are expanded in the modal
coordinates, ``m0(i, j) + sum_k m1(i, k, j) q_k``. What the matrices mean says :mod:`.standard`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from ..errors import RobotFileError, one_line
from ..files import LARGEST as BEYOND
from ..files import NotRegularError, open_regular

MAX_BYTES = 256 * 2**20
NODE_PARTS = ("origin", "phi", "psi", "AP", "sigma")
PARTS = ("mdCM", "J", "Ct", "Cr", "Me", "Gr", "Ge", "Oe", "ksigma", "Ke", "De")
ZERO, DIAGONAL, SYMMETRIC, FULL, IDENTITY = range(5)
"""The values of ``structure``."""
HEAD = ("order", "nrow", "ncol", "nq", "nqn", "structure")
ENTRY = re.compile(r"m([01])\s*\(([\d\s,]*)\)")
LARGEST = 10_000
MOST_NUMBERS = 32_000_000
"""The numbers of all matrices of a file, at most."""


@dataclass
class Taylor:
    """A matrix to first order in the modal coordinates."""

    m0: np.ndarray
    """(rows, columns)."""
    m1: np.ndarray | None = None
    """(rows, modes, columns), or None where the file stops at order 0."""
    structure: int = FULL
    line: int = 0
    """Where the file opens it."""

    @property
    def order(self) -> int:
        return 0 if self.m1 is None else 1


@dataclass
class SidNode:
    """A node: its name and its matrices by name."""

    name: str
    parts: dict[str, Taylor] = field(default_factory=dict)


@dataclass
class Sid:
    """The content of a file."""

    mass: float
    names: list[str]
    """What each mode is."""
    nodes: list[SidNode]
    parts: dict[str, Taylor]


class SidLine(NamedTuple):
    """A line of the file that is not empty."""

    number: int
    text: str

    @property
    def key(self) -> str:
        return self.text.partition("=")[0].strip()

    @property
    def value(self) -> str:
        return self.text.partition("=")[2].strip()


class Reader:
    """Reads the objects line by line; every error names file and line."""

    def __init__(self, text: str, file: str):
        self.file = file
        lines = (SidLine(i, " ".join(line.split())) for i, line in enumerate(text.splitlines(), 1))
        self.lines = iter([line for line in lines if line.text])
        self.last = SidLine(1, "")
        self.left = MOST_NUMBERS

    def error(self, line: int, what: str) -> RobotFileError:
        return RobotFileError(one_line(f"{self.file}: line {line}: {what}"))

    def inside(self, end: str) -> Iterator[SidLine]:
        """The lines up to ``end``."""
        opened = self.last
        for line in self.lines:
            self.last = line
            if line.text.lower() == end.lower():
                return
            yield line
        raise self.error(self.last.number, f"the file ends within '{opened.text}' of line {opened.number}; add '{end}'")

    def unknown(self, line: SidLine, known: tuple[str, ...]) -> RobotFileError:
        return self.error(line.number, f"'{line.text[:40]}' is unknown here; known are {', '.join(known)}")

    def sid(self) -> Sid:
        """The whole file; lines before ``part`` are comments."""
        for line in self.lines:
            self.last = line
            if line.text.lower() == "part":
                return self._part()
        raise self.error(self.last.number, "there is no 'part'; a SID file in text form has one")

    def _part(self) -> Sid:
        found = None
        for line in self.inside("end part"):
            if not line.text.lower().startswith("new modal") or found is not None:
                raise self.unknown(line, ("one 'new modal'", "'end part'"))
            found = self._modal()
        if found is None:
            raise self.error(self.last.number, "the part has no 'new modal'; it holds the body's data")
        return found

    def _modal(self) -> Sid:
        out, seen = Sid(0.0, [], [], {}), set()
        for line in self.inside("end modal"):
            if line.text in seen:
                raise self.error(line.number, f"'{line.text}' occurs twice; leave one of them out")
            seen.add(line.text)
            if line.text == "refmod":
                self._refmod(out)
            elif line.text == "frame":
                out.nodes += self._frame()
            elif line.text in PARTS:
                out.parts[line.text] = self._taylor(line)
            else:
                raise self.unknown(line, ("refmod", "frame", *PARTS))
        if "refmod" not in seen:
            raise self.error(self.last.number, "there is no 'refmod'; it states mass and nelastq")
        return out

    def _refmod(self, out: Sid) -> None:
        stated = {}
        for line in self.inside("end refmod"):
            name = line.key.partition("(")[0].strip()
            if name == "mass":
                stated[name] = out.mass = self._number(line)
            elif name == "nelastq":
                stated[name] = count = self._count(line)
                out.names = [""] * count
            elif name == "ielastq" and "nelastq" in stated:
                (k,) = self._index(line, re.search(r"\(([\d\s,]*)\)", line.key), (len(out.names),))
                out.names[k] = line.value
            else:
                raise self.unknown(line, ("mass", "nelastq", "ielastq after nelastq"))
        if missing := [name for name in ("mass", "nelastq") if name not in stated]:
            raise self.error(self.last.number, f"refmod does not state {missing[0]}; add it")

    def _frame(self) -> Iterator[SidNode]:
        for line in self.inside("end frame"):
            if line.key != "new node":
                raise self.unknown(line, ("new node", "end frame"))
            node = SidNode(line.value or "?")
            for inner in self.inside("end node"):
                if inner.text in NODE_PARTS:
                    node.parts[inner.text] = self._taylor(inner)
                elif inner.key != "rframe":
                    raise self.unknown(inner, ("rframe", *NODE_PARTS))
            yield node

    def _taylor(self, opened: SidLine) -> Taylor:
        """A matrix: its head, then its entries; what is not stated is zero."""
        head: dict[str, int] = {}
        out = None
        for line in self.inside(f"end {opened.text}"):
            if line.key in HEAD and out is None:
                head[line.key] = self._count(line)
            elif match := ENTRY.fullmatch(line.key):
                out = out or self._empty(opened, head)
                self._entry(out, line, match)
            else:
                raise self.unknown(line, (*HEAD, "m0(row, column)", "m1(row, mode, column)"))
        return out or self._empty(opened, head)

    def _empty(self, opened: SidLine, head: dict[str, int]) -> Taylor:
        where = self.last.number
        if missing := [name for name in ("order", "nrow", "ncol", "structure") if name not in head]:
            raise self.error(where, f"{opened.text} does not state {missing[0]}; add it before the entries")
        if head["order"] > 1:
            raise self.error(where, f"{opened.text} has order {head['order']}; orders 0 and 1 are read")
        if head["structure"] > IDENTITY:
            raise self.error(where, f"structure is {head['structure']}; it must be from 0 to {IDENTITY}")
        rows, columns = head["nrow"], head["ncol"]
        if head["order"] == 1 and "nq" not in head:
            raise self.error(where, f"{opened.text} has order 1 but does not state nq; add it")
        if head["structure"] in (DIAGONAL, SYMMETRIC) and rows != columns:
            what = f"structure is {head['structure']} of a matrix of {rows} x {columns}"
            raise self.error(where, f"{what}; state as many rows as columns, or structure = {FULL}")
        self.left -= rows * columns * (1 + head["order"] * head.get("nq", 0))
        if self.left < 0:
            what = f"{opened.text} has {rows} x {columns} numbers, and as many for each mode"
            raise self.error(where, f"{what}; all matrices together may have {MOST_NUMBERS}")
        m0 = np.eye(rows, columns) if head["structure"] == IDENTITY else np.zeros((rows, columns))
        m1 = np.zeros((rows, head["nq"], columns)) if head["order"] else None
        return Taylor(m0, m1, head["structure"], opened.number)

    def _entry(self, out: Taylor, line: SidLine, match: re.Match) -> None:
        into = out.m0 if match[1] == "0" else out.m1
        if into is None:
            raise self.error(line.number, f"'{line.key}' belongs to a matrix of order 0; state order = 1")
        index = self._index(line, re.search(r"\(([\d\s,]*)\)", line.key), into.shape)
        if out.structure in (ZERO, DIAGONAL) and (out.structure == ZERO or index[0] != index[-1]):
            what = f"'{line.key}' is an entry that structure = {out.structure} leaves zero"
            raise self.error(line.number, f"{what}; state structure = {FULL}")
        into[index] = self._number(line)
        if out.structure == SYMMETRIC:
            into[(index[-1], *index[1:-1], index[0])] = into[index]

    def _index(self, line: SidLine, match: re.Match | None, shape: tuple[int, ...]) -> tuple[int, ...]:
        index = [_whole(part.strip()) for part in match[1].split(",") if part.strip()] if match else []
        if len(index) != len(shape) or not all(1 <= i <= n for i, n in zip(index, shape, strict=True)):
            allowed = ", ".join(f"1 to {n}" for n in shape)
            raise self.error(line.number, f"'{line.key[:40]}' must have the indices ({allowed})")
        return tuple(i - 1 for i in index)

    def _number(self, line: SidLine) -> float:
        try:
            value = float(line.value.replace("D", "E").replace("d", "e"))
        except ValueError:
            value = np.nan
        if not abs(value) < BEYOND:
            raise self.error(line.number, f"'{line.value[:40]}' is no number; state a finite one after '='")
        return value

    def _count(self, line: SidLine) -> int:
        if (count := _whole(line.value)) < 0:
            raise self.error(line.number, f"{line.key} must be a whole number from 0 to {LARGEST}")
        return count


def _whole(text: str) -> int:
    """A whole number up to `LARGEST`, -1 where the text is none."""
    value = int(text) if text.isdecimal() and len(text) <= len(str(LARGEST)) else -1
    return value if value <= LARGEST else -1


def read_sid(path: str | os.PathLike[str]) -> Sid:
    """The content of a SID file; raises RobotFileError, `<file>: line <n>: <what is wrong>; <what is allowed>`."""
    return Reader(content(path, MAX_BYTES).decode("utf-8", "replace"), os.fspath(path)).sid()


def content(path: str | os.PathLike[str], most: int) -> bytes:
    """The bytes of a regular file of no more than ``most`` bytes; raises RobotFileError."""
    file = os.fspath(path)
    try:
        with open_regular(path) as stream:
            data = stream.read(most + 1)
    except FileNotFoundError:
        raise RobotFileError(f"{file}: there is no such file; paths are relative to the robot file") from None
    except (OSError, NotRegularError, ValueError) as error:
        raise RobotFileError(f"{file}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    if len(data) > most:
        raise RobotFileError(f"{file}: is too large; at most {most} bytes are read")
    return data


# ------------------------------------------------------------------------------------ writing


def sid_text(sid: Sid) -> str:
    """The text of a file with this content; numbers have all their digits."""
    head = f"{len(sid.nodes)} {len(sid.names)} : numbers of nodes and modes, SI units; written by screwgen"
    return "\n".join([head, "part", *_indented(_modal_lines(sid)), "end part", ""])


def _indented(lines: Iterator[str]) -> Iterator[str]:
    return (f"   {line}" for line in lines)


def _modal_lines(sid: Sid) -> Iterator[str]:
    yield "new modal"
    named = (f"ielastq ({k:4}) = {name}" for k, name in enumerate(sid.names, 1))
    yield from _object("refmod", iter([f"mass = {sid.mass:.16e}", f"nelastq = {len(sid.names)}", *named]))
    yield from _object("frame", (line for node in sid.nodes for line in _node_lines(node)))
    for name, part in sid.parts.items():
        yield from _object(name, _taylor_lines(part))
    yield "end modal"


def _object(name: str, lines: Iterator[str]) -> Iterator[str]:
    yield name
    yield from _indented(lines)
    yield f"end {name}"


def _node_lines(node: SidNode) -> Iterator[str]:
    yield f"new node = {node.name}"
    yield "   rframe = body ref"
    for name, part in node.parts.items():
        yield from _indented(_object(name, _taylor_lines(part)))
    yield "end node"


def _taylor_lines(x: Taylor) -> Iterator[str]:
    """Entries that are zero are left out: a reader takes them so."""
    modes = x.m1.shape[1] if x.m1 is not None else 0
    structure = FULL if x.structure == IDENTITY else x.structure
    for name, value in zip(HEAD, (x.order, *x.m0.shape, modes, 0, structure), strict=True):
        yield f"{name} = {value}"
    arrays = {"m0": x.m0} | ({} if x.m1 is None else {"m1": x.m1})
    for name, array in arrays.items():
        for index in np.argwhere(array):
            if structure != SYMMETRIC or index[0] >= index[-1]:
                place = ",".join(f"{i + 1:4}" for i in index)
                yield f"{name} ({place}) = {array[tuple(index)]:.16e}"
