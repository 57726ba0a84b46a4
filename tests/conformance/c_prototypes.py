"""What the public headers of generated C declare, read from the headers, and a C++ program that calls it all.

A test that asks here for the functions cannot forget one: a name that is followed by a parenthesis and is no prototype
is refused.
"""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from typing import NamedTuple

from conftest import require_tool

SPACE = 1 << 20
"""The memory behind a pointer in the C++ program, in bytes: more than any struct of a small robot has."""


class Argument(NamedTuple):
    """An argument: its type or that behind it, its name, its arrays' lengths as the header has them."""

    kind: str
    name: str
    pointer: bool
    constant: bool
    lengths: str


class Prototype(NamedTuple):
    """A public function."""

    header: str
    result: str
    name: str
    arguments: tuple[Argument, ...]


def public_headers(folder: Path) -> list[str]:
    """The headers that a user includes; the others say in their first comment that they are private."""
    return sorted(header.name for header in folder.glob("*.h") if not _private(header.read_text(encoding="utf-8")))


def _private(text: str) -> bool:
    first = " ".join(re.match(r"\s*/\*(.*?)\*/", text, re.DOTALL)[1].split())
    return "Private to" in first or "_reference.h:" in first


def prototypes(folder: Path, name: str) -> list[Prototype]:
    """Every function of the robot `name` that its public headers declare, in their order, each once."""
    found: dict[str, Prototype] = {}
    for header in public_headers(folder):
        text = _declarations(folder, header)
        for match in re.finditer(rf"([\w\s*]*)\b({name}_\w+)\s*\(", text):
            given = _within(text, match.end())
            result, function = " ".join(match[1].split()).removeprefix("extern "), match[2]
            assert result and text[match.end() + len(given) + 1 :].lstrip().startswith(";"), f"{header}: {function}"
            parts = (" ".join(part.split()) for part in given.split(","))
            arguments = tuple(_argument(part) for part in parts if part != "void")
            found.setdefault(function, Prototype(header, result, function, arguments))
    return list(found.values())


def _declarations(folder: Path, header: str) -> str:
    """A header without what stands in braces."""
    text = _preprocessed(folder, header)
    while "{" in text:
        text = re.sub(r"\{[^{}]*\}", " ", text)
    return text


def _preprocessed(folder: Path, header: str) -> str:
    """A header with its macros put in, and what it includes."""
    command = [require_tool("gcc"), "-std=c99", "-E", "-P", "-I.", header]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True).stdout


def _within(text: str, start: int) -> str:
    """What stands from a place up to the parenthesis that closes there."""
    depth = 1
    for end in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[end], 0)
        if depth == 0:
            return text[start:end]
    raise ValueError("unbalanced parentheses")


def _argument(text: str) -> Argument:
    match = re.fullmatch(r"(const )?(\w+) ?(\*?) ?(\w+)((?:\[[^]]*\])*)", text)
    assert match, text
    return Argument(match[2], match[4], bool(match[3] or match[5]), bool(match[1]), match[5])


# -------- C++


def called_from_cpp(folder: Path, name: str) -> list[str]:
    """What g++ and the program say where C++ includes each public header alone, and calls each function; best nothing.

    Pointers are null, or where a function returns nothing, memory: what counts is that all of it compiles, links, and
    answers a null pointer with a status.
    """
    said = []
    for header in public_headers(folder):
        said += _compiled(folder, f"alone_{header}.cpp", f'#include "{header}"\n', "-c", "-o", "/dev/null")
    (folder / "calls.cpp").write_text(program := _program(folder, name))
    sources = sorted(p.name for p in folder.glob("*.c") if p.name not in ("main.c", "check.c", "mpc_main.c"))
    built = _said(folder, "gcc", "-std=c99", "-O0", "-c", *sources)
    objects = [source.replace(".c", ".o") for source in sources]
    said += built + _compiled(folder, "calls.cpp", program, *objects, "-o", "calls", "-lm")
    return said or _said(folder, str(folder / "calls"))


def _program(folder: Path, name: str) -> str:
    """Each function, called behind a switch that the compiler does not see through."""
    lines = [f'#include "{header}"' for header in public_headers(folder)]
    lines += ["#include <cstdlib>", f"static double memory[{SPACE // 8}];", "int main()", "{", "    int refused = 0;"]
    for function in prototypes(folder, name):
        space = "memory" if function.result == "void" else "nullptr"
        values = [f"reinterpret_cast<{'const ' * a.constant}{_behind(a)}>({space})" for a in function.arguments]
        values = [
            (v if space == "memory" else "nullptr") if a.pointer else "0"
            for v, a in zip(values, function.arguments, strict=True)
        ]
        call = f"{function.name}({', '.join(values)})"
        if function.result.endswith("_status"):
            lines.append(f"    refused += {call} != {name.upper()}_BAD_ARGUMENT;")
        elif function.result == "void":
            lines.append(f"    {call};")
        else:
            lines.append(f'    if (std::getenv("NEVER_SET")) {{ refused += {call} == nullptr; }}')
    return "\n".join([*lines, "    return refused;", "}", ""])


def _behind(argument: Argument) -> str:
    """The type of a pointer to an argument's memory."""
    rest = argument.lengths.partition("]")[2]
    return f"{argument.kind} (*){rest}" if rest else f"{argument.kind} *"


def _compiled(folder: Path, file: str, text: str, *options: str) -> list[str]:
    (folder / file).write_text(text)
    return _said(folder, "g++", "-std=c++11", "-Wall", "-Wextra", "-Werror", "-I.", file, *options)


def _said(folder: Path, tool: str, *arguments: str) -> list[str]:
    command = [tool if "/" in tool else require_tool(tool), *arguments]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    lines = [line for line in done.stderr.splitlines() if re.search(r"error|undefined", line)]
    return lines or [f"{tool}: exit status {done.returncode}"] * bool(done.returncode)
