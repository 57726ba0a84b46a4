"""Generated C within a limited number of columns: long statements and comments are broken over several lines."""

from __future__ import annotations

import re
import textwrap

from ...errors import UsageError
from ..templates import render

WIDTH = 120
BREAKS = {", ": 0, "&& ": 1, "|| ": 1, "? ": 2, ": ": 2, "+ ": 3, "- ": 3, "* ": 4}
"""Statements are broken after a comma or before an operator; tokens of lower rank are preferred."""
MARKS = frozenset('"()[]{}').union(token[0] for token in BREAKS)


def rendered(template: str, **values: object) -> str:
    """A template of the C back end as text.

    C has limited columns, and the robot's prefix where templates and programs have ``$_``, in capitals for ``$$_``.
    """
    text = render(f"c/{template}.jinja", **values)
    if template.endswith((".md", "Makefile", ".txt")):
        return text
    return written(text, str(values["name"]))


def written(text: str, name: str) -> str:
    """C source with the robot's prefix, in limited columns; UsageError where that makes a name twice."""
    if twice := _twice(text, name):
        raise UsageError(f"robot '{name}': the generated C has '{twice}' for something else; choose another name")
    return folded(_with_angles(text).replace("$$_", f"{name.upper()}_").replace("$_", f"{name}_"))


def _with_angles(text: str) -> str:
    """C source with what it calls for angles of points; only sources that call it have it, after their includes."""
    lanes, first = "$_lanes_atan2(" in text, re.search(r"\$_(lanes_)?atan2\(", text)
    if first is None:
        return text
    at = text.index("\n", text.rindex("\n#include ", 0, first.start()) + 1)
    return f"{text[: at + 1]}\n{render('c/angles.jinja', lanes=lanes)}{text[at + 1 :]}"


def _twice(text: str, name: str) -> str | None:
    """A name that the source has without the prefix and would have a second time with it."""
    for prefix, mark, always in (
        (f"{name}_", r"(?<!\$)\$_", {"kinematics"}),
        (f"{name.upper()}_", r"\$\$_", IN_HEADERS),
    ):
        if prefix not in text or not re.search(rf"(?<![\w$]){prefix}", text):
            continue
        code = COMMENTS_AND_STRINGS.sub(" ", text)
        own = always.union(re.findall(rf"{mark}(\w+)", code))
        both = sorted(own.intersection(re.findall(rf"(?<![\w$]){prefix}(\w+)", code)))
        if both:
            return prefix + both[0]
    return None


IN_HEADERS = {"H", "ROTATION"}
"""Macros and constants that a file sees and need not use; of functions it is the kinematics."""
COMMENTS_AND_STRINGS = re.compile(r'/\*.*?\*/|"(?:[^"\\\n]|\\.)*"', re.DOTALL)


def folded(text: str) -> str:
    """C source with lines of at most WIDTH columns; preprocessor directives are left as they are."""
    out: list[str] = []
    inside, lines = False, text.split("\n")
    for number, line in enumerate(lines):
        comment = inside or line.lstrip().startswith("/*")
        inside = line.rfind("/*") > line.rfind("*/") or (inside and "*/" not in line)
        if len(line) <= WIDTH or line.startswith("#"):
            out.append(line)
        elif not comment:
            out += _code(line)
        else:
            *whole, rest = _comment(line)
            ahead = CONTINUED.match(lines[number + 1]) if inside and rest[-1] not in ".:" else None
            if ahead:
                lines[number + 1] = f"{rest} {lines[number + 1][ahead.end() :]}"
            out += whole if ahead else [*whole, rest]
    return "\n".join(out)


CONTINUED = re.compile(r" *\* (?=[^ */])")
"""The beginning of a line that continues a comment."""


def _comment(line: str) -> list[str]:
    """A line of a comment, or a comment of one line."""
    body = line.lstrip()
    indent, whole = line[: -len(body)], body.startswith("/*") and body.endswith("*/")
    text = body[:-2].rstrip() if whole else body
    later = indent + {"/*": " * ", "* ": "* "}.get(body[:2], "")
    lines = textwrap.wrap(text, WIDTH, initial_indent=indent, subsequent_indent=later, break_long_words=False)
    return lines + [indent + " */"] * whole


def _code(line: str) -> list[str]:
    """A statement; a comment behind it is put before it."""
    indent = line[: len(line) - len(line.lstrip())]
    behind = re.fullmatch(r"(.*\S) (/\*.*\*/)", line)
    if behind:
        return folded(f"{indent}{behind[2]}\n{behind[1]}").split("\n")
    out = []
    while len(line) > WIDTH and (cut := _break(line, len(indent) + 24)):
        out.append(line[:cut].rstrip())
        line = f"{indent}    {line[cut:].lstrip()}"
    return [*out, line]


def _break(line: str, least: int) -> int | None:
    """The best place to break: outside the innermost parentheses, at the weakest token, the later the better."""
    depth, quoted, best, place = 0, False, (99, 99), None
    for i, ch in enumerate(line[:WIDTH]):
        if ch not in MARKS:
            continue
        quoted ^= ch == '"'
        depth += (ch in "([{") - (ch in ")]}")
        if quoted or i <= least or (ch != "," and line[i - 1] != " "):
            continue
        cost = (depth, BREAKS.get(line[i : i + (2 if ch in ",?:+-*" else 3)], 99))
        if cost <= best and cost[1] < 99:
            best, place = cost, i + (ch == ",")
    return place
