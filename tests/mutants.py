"""Mutants of generated C, made by rule, and whether the folder's self-check finds them.

A mutant changes one place of one source. Places are found in the text without comments, preprocessor lines, conditions,
loop headers and returned status: what decides about a status alone is not arithmetic, and other tests look at it. Of
the places of a kind in one function some are chosen, evenly spread over its text.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from conftest import require_tool

PATIENCE = 5.0
"""Seconds after which a self-check is stopped: it has not reported success, so the mutant counts as found."""

STILLBORN = ("-w", "-Werror=incompatible-pointer-types", "-Werror=int-conversion")
"""Warnings that make a mutant none."""

PATH = r"[A-Za-z_]\w*(?:(?:->|\.)\w+|\[[^\[\]]*\])*"
PRODUCT = rf"{PATH}(?: \* {PATH})*"
END = r"(?=\s[+-]\s|[;),])"
KINDS = {
    "sign": (r"(?<=[\w\])])\s+([+-])\s(?=[\w(-])(?!0[,;)])", lambda m: m[0].translate(str.maketrans("+-", "-+"))),
    "sum": (r"([+-])= ", lambda m: {"+": "-", "-": "+"}[m[1]] + "= "),
    "minus": (r"(?<=[=(,] )-(?=[\w(])|(?<=\()-(?=[\w(])", lambda m: "+"),
    "constant": (r"(?<![\w.\[])\d+\.\d+(?:[eE][+-]?\d+)?(?!\w)", lambda m: repr(float(m[0]) * 1.01)),
    "part": (r"(?<= / )\d+\b(?!\.)", lambda m: str(int(m[0]) + 1)),
    "factor": (r"(?<![\w.\[+-] )(?<![\w.\[])\d+(?= [*-] )", lambda m: str(int(m[0]) + 1)),
    "index": (r"(?<=\[)\d+(?=\])|(?<= \+ )\d+(?=\])", lambda m: str(int(m[0]) - 1 if int(m[0]) else 1)),
    "swap": (rf"(?<=[(=] )({PATH}) - ({PATH})(?=[;),])|(?<=\()({PATH}) - ({PATH})(?=[;),])", lambda m: _swapped(m)),
    "term": (rf"(?<=[\w\])])\s+[+-]\s{PRODUCT}{END}", lambda m: " "),
    "statement": (r"(?<=[;{}])\s+[a-zA-Z_]\w*(?:->|\.|\[)[^;={}]*=(?!=)[^;{}]*;", lambda m: " "),
    "arguments": (rf"(?<=[(,\s])({PATH}), ({PATH})(?=[,)])", lambda m: f"{m[2]}, {m[1]}"),
}
"""Kinds of changes: the places, and what is written there. Besides, a local number takes the place of another one."""
LOCAL = re.compile(r"\bconst \w+_real (\w+) = |(?:,\s+|\()(?:const )?\w+_real (\w+)(?=[,)])|, (\w+) = dt\b")

IGNORED = (
    r"/\*[\s\S]*?\*/|^#(?:.*\\\n)*.*$",  # comments, preprocessor lines
    r"\breturn [A-Z]\w*;|\breturn [^;]*(?:status|_OK|NONFINITE|finite\(|moderate\()[^;]*;|\(void\)[^;]*;",  # status
    r"\bint \w+(?:, \w+)*(?:, \w+ = 0)?;|\breturn \(c->[^;]*;|\bsum \+= ",  # counters; the sum of all constants
    r"\bconst \w+ [^;=]*=[^;]*EPSILON[^;]*;|^\s*bad \|=[^;]*;",  # the smallest pivots
    r"^\s*(?:static )?const int CLASS\b[^;]*;|\bcase 0:\s*return [^;]*;",  # the first link's places, all of them 0
)
HEADS = re.compile(r"\b(?:if|for|while|switch) \(")


class Mutant(NamedTuple):
    """A change: the file, its function, the kind, and what text takes the place of the one from start to end."""

    file: str
    function: str
    kind: str
    start: int
    end: int
    new: str

    def applied(self, text: str) -> str:
        return text[: self.start] + self.new + text[self.end :]

    def __str__(self) -> str:
        return f"{self.file}:{self.function}:{self.kind}"


def _swapped(m: re.Match) -> str:
    a, b = (m[1], m[2]) if m[1] else (m[3], m[4])
    return f"{b} - {a}"


# -------- places


def bare(text: str) -> str:
    """C without what is not mutated: blanks stand in its place."""
    for pattern in IGNORED:
        text = re.sub(pattern, lambda m: re.sub(r"\S", " ", m[0]), text, flags=re.MULTILINE)
    for head in list(HEADS.finditer(text)):
        end = head.end() + _closing(text[head.end() :])
        text = text[: head.end()] + re.sub(r"\S", " ", text[head.end() : end]) + text[end:]
    return text


def _closing(text: str) -> int:
    depth = 1
    for k, ch in enumerate(text):
        depth += (ch == "(") - (ch == ")")
        if not depth:
            return k
    raise AssertionError("a parenthesis is not closed")


def functions(text: str) -> Iterator[tuple[str, int, int]]:
    """Name, start and end of the body of every function and table."""
    depth, start, before = 0, 0, 0
    for m in re.finditer(r"[{}]", text):
        depth += 1 if m[0] == "{" else -1
        if depth == 1 and m[0] == "{":
            start = m.end()
        elif depth == 0:
            names = re.findall(r"(\w+)\s*(?=\(|\[)", text[before:start])
            yield (names[0] if names else "", start, m.start())
            before = m.end()


def mutants(file: str, text: str, most: int) -> list[Mutant]:
    """The mutants of a source: up to `most` of each kind in each function."""
    out, clean = [], bare(text)
    used = set(re.findall(r"\w+\[\d+\]|\w+\[[^\[\]]*\]\[\d+\]", clean))
    for function, start, end in functions(clean):
        for kind, (pattern, new) in KINDS.items():
            found = re.compile(pattern).finditer(clean, start, end)
            made = [Mutant(file, function, kind, m.start(), m.end(), new(m)) for m in found]
            made = [x for x in made if x.new != text[x.start : x.end] and _valid(x, clean, used)]
            out += spread(made, most)
        out += spread(list(_renamed(file, function, clean, start, end)), most)
    return out


def spread(made: list[Mutant], most: int) -> list[Mutant]:
    """So many of a list, at even distances."""
    count = min(most, len(made))
    return [made[(2 * j + 1) * len(made) // (2 * count)] for j in range(count)]


def _renamed(file: str, function: str, text: str, start: int, end: int) -> Iterator[Mutant]:
    """Uses of a local number replaced by the one before it in the function, the first by the second."""
    head = text.rfind("\n\n", 0, start)
    known = [(m.end(), m[1] or m[2] or m[3]) for m in LOCAL.finditer(text, max(head, 0), end)]
    known = [(at, name) for j, (at, name) in enumerate(known) if name not in [n for _, n in known[:j]]]
    names = [name for _, name in known]
    if len(names) < 2:
        return
    for (at, name), other in zip(known, [*names[1:2], *names], strict=False):
        for m in re.compile(rf"(?<![\w.>]){name}\b(?! =)").finditer(text, max(at, start), end):
            if all(re.search(r"[,;]", text[at : m.start()]) for at, n in known if n == other):
                yield Mutant(file, function, "name", m.start(), m.end(), other)


def _valid(mutant: Mutant, text: str, used: set[str]) -> bool:
    """Whether an index is one that the file uses for the same array."""
    if mutant.kind != "index" or text[mutant.start - 1] != "[":
        return True
    array = re.search(r"\w+\[$|\w+\[[^\[\]]*\]\[$", text[max(mutant.start - 80, 0) : mutant.start])
    return array is not None and f"{array[0]}{mutant.new}]" in used


# -------- the self-check


class Folder:
    """A generated folder, compiled, of which one source at a time is a mutant."""

    def __init__(self, folder: Path, texts: dict[str, str]):
        self.folder, self.texts = folder, texts
        for name, text in texts.items():
            (folder / name).write_text(text)
        self.sources = [n for n in texts if n.endswith(".c") and n != "main.c"]
        assert all(self._compile(source) for source in self.sources)
        assert self._passes(), "the self-check fails without a mutant"

    @property
    def mutable(self) -> list[str]:
        return [n for n in self.texts if n.endswith((".c", "se3.h", "links.h")) and n not in ("main.c", "check.c")]

    def _compile(self, source: str, to: str | None = None) -> bool:
        command = [require_tool("gcc"), "-std=c99", "-O0", *STILLBORN, "-c", source, "-o", to or f"{source[:-2]}.o"]
        return subprocess.run(command, cwd=self.folder, capture_output=True).returncode == 0

    def _passes(self, *changed: str) -> bool:
        """Whether the self-check passes with changed objects, `mutant-…`, in place of the sources' own."""
        objects = [f"mutant-{s[:-2]}.o" if s in changed else f"{s[:-2]}.o" for s in self.sources]
        subprocess.run([require_tool("gcc"), "-o", "check", *objects, "-lm"], cwd=self.folder, check=True)
        try:
            return subprocess.run(["./check"], cwd=self.folder, capture_output=True, timeout=PATIENCE).returncode == 0
        except subprocess.TimeoutExpired:
            return False

    def line(self, mutant: Mutant) -> str:
        """The line in which a mutant begins."""
        text, start = self.texts[mutant.file], mutant.start
        start += len(text[start : mutant.end]) - len(text[start : mutant.end].lstrip())
        return text[text.rfind("\n", 0, start) + 1 : text.find("\n", start)]

    def shown(self, mutant: Mutant) -> str:
        old = self.texts[mutant.file][mutant.start : mutant.end]
        return f"{mutant}: {old.strip()} -> {mutant.new.strip()} in {self.line(mutant).strip()}"

    def survives(self, mutant: Mutant) -> bool | None:
        """Whether the self-check passes with a mutant; None where it does not compile, which makes it no mutant."""
        path, text = self.folder / mutant.file, self.texts[mutant.file]
        users = [s for s in self.sources if s == mutant.file or f'"{mutant.file}"' in self.texts[s]]
        try:
            path.write_text(mutant.applied(text))
            if not all(self._compile(s, f"mutant-{s[:-2]}.o") for s in users):
                return None
            return self._passes(*users)
        finally:
            path.write_text(text)
