"""Robot files as a person would write them: a header, a comment and a blank line before each link, lines that fit."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

from ..spec.load import entry, one_line
from ..spec.reduced import Reduced
from ..spec.robot import TABLES

WIDTH = 120


def document(
    tables: dict[str, Any],
    head: Sequence[str],
    comments: dict[str, str],
    from_folder: str,
    to_folder: str | os.PathLike,
) -> str:
    """TOML text of a robot's tables.

    `head`: lines of the comment at the top; `comments`: one for each link by its name; `from_folder`: where the names
    of bodies' files are relative to, `to_folder`: where the text will be.
    """
    lines = [f"# {one_line(line)}" for line in head]
    lines += ["", *assignments("", {k: v for k, v in tables.items() if k not in TABLES})]
    for kind in TABLES:
        for table in tables.get(kind, ()):
            lines.append("")
            if comment := comments.get(table.get("name", "")):
                lines.append(f"# {one_line(comment)}")
            lines += [f"[[{kind}]]", *assignments("", _named(table, from_folder, to_folder))]
    return "\n".join(lines) + "\n"


def _named(table: dict[str, Any], from_folder: str, to_folder: str | os.PathLike) -> dict[str, Any]:
    """A link with its body's file named from the folder of the text."""
    body = table.get("body")
    if not isinstance(body, Reduced):
        return table
    stated = body.model_dump(exclude_none=True, exclude_defaults=True)
    for key in ("sid", "npz"):
        if key in stated and not os.path.isabs(stated[key]):
            stated[key] = os.path.relpath(os.path.join(from_folder or ".", stated[key]), to_folder)
    return table | {"body": stated}


def assignments(prefix: str, table: dict[str, Any]) -> list[str]:
    """`key = value`; what does not fit into a line by dotted keys or over several lines, arrays of tables last."""
    lines: list[str] = []
    behind: list[str] = []
    for key, value in table.items():
        name, plain = f"{prefix}{key}", _plain(value)
        if isinstance(plain, dict) and plain and (key == "joint" or len(entry(key, plain)) > WIDTH - len(name) - 3):
            lines += assignments(f"{name}.", plain)
        elif key == "bodies" and plain:
            behind += [line for body in plain for line in ("", "[[links.bodies]]", *assignments("", body))]
        else:
            lines += _wrapped(f"{name} = {entry(key, plain)}", key, plain)
    return lines + behind


def _wrapped(line: str, key: str, value: Any) -> list[str]:
    """A line, or an array with three entries a line where it is too long."""
    if len(line) <= WIDTH or not isinstance(value, tuple) or key == "axes":
        return [line]
    rows = [", ".join(entry("", x) for x in value[k : k + 3]) for k in range(0, len(value), 3)]
    return [line.partition("[")[0] + "[", *(f"    {row}," for row in rows), "]"]


def _plain(value: Any) -> Any:
    """Arrays as tuples, so that axes find their letters."""
    if isinstance(value, list | tuple):
        return tuple(map(_plain, value))
    return {key: _plain(x) for key, x in value.items()} if isinstance(value, dict) else value
