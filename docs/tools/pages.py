"""The guides, run: every fenced block of a page does what it says, in a folder of the page's own.

    python docs/tools/pages.py FOLDER [PAGE.md]...     # FOLDER/<page> is where a page's blocks run

Blocks run in the order of the page. Exit status 1 and the page's line where one does not hold.

bash    runs; its exit status must be 0. A block of `make TARGET` lines is not run: each target must be one of the
        Makefile, and what it starts be run by a test of its own.
python  runs, in one namespace per page.
text    is what the block before it prints, all of it; a line `…` stands for any lines. Texts must be equal, but for
        runs of blanks; whole numbers must be equal; a number with a decimal point or an exponent may differ by one unit
        of its last digit. A block that prints must have such a text behind it.
math    is the same, without any tolerance: TeX, a formula a line, which the site sets.
toml, json, xml, c  are files, written under their title; a later block must use them by name. TOML, JSON and XML must
        be read, robot files load, but for side files of URDFs; C must be compiled as C99 with all warnings as errors. A
        title `NAME (excerpt)` instead: these lines stand in that file, in this order; `…` stands for any lines.
Other languages, blocks without one, indented fences and pages without blocks are refused.
"""

from __future__ import annotations

import io
import json
import linecache
import os
import re
import shutil
import subprocess
import sys
import tomllib
import traceback
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[2]
PAGES = (
    "index robot forces functions notebook firmware estimator mpc realtime research modes elements urdf fmi models "
    "viewer rollouts identification motions jax"
)
GUIDES = tuple(ROOT / "docs" / f"{name}.md" for name in PAGES.split())

FILES = ("toml", "json", "xml", "c")
LANGUAGES = (*FILES, "bash", "python", "text", "math")
PRINTED = ("text", "math")
STRICT_C = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror")
EXCERPT = " (excerpt)"
GAP = "…"
NUMBER = re.compile(r"(?<![\w.])[-+−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w])")
FENCE = re.compile(r"^(?P<indent>\s*)(?:>\s*)*(?P<fence>`{3,}|~{3,})\s*(?P<info>.*)$")
SHIMS = ".shims"
LIMIT = 300
"""Seconds for one block."""


class Fault(Exception):
    """What does not hold, with the page and its line."""


@dataclass(frozen=True)
class Block:
    """A fenced block: language, title, lines between the fences, and the page's line of its first one."""

    language: str
    title: str
    text: str
    line: int


# ------------------------------------------------------------------------------ reading a page


def blocks(page: Path) -> list[Block]:
    """The fenced blocks of a page; raises Fault."""
    out, opened, lines = [], None, page.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        match = FENCE.match(line)
        if opened is None and match:
            if match["indent"]:
                raise Fault(f"{page.name}:{number}: an indented fence")
            opened = number, match
        elif opened and line.rstrip() == opened[1]["fence"]:
            out.append(_block(page, opened[0], opened[1]["info"], lines[opened[0] : number - 1]))
            opened = None
    if opened:
        raise Fault(f"{page.name}:{opened[0]}: a fence that is not closed")
    if not out:
        raise Fault(f"{page.name}: a page without blocks")
    return out


def _block(page: Path, line: int, info: str, lines: list[str]) -> Block:
    match = re.fullmatch(r'(\w+)(?: title="([^"]+)")?', info.strip())
    if not match or match[1] not in LANGUAGES:
        raise Fault(f"{page.name}:{line}: the block's head is '{info}'; languages: {', '.join(LANGUAGES)}")
    if (match[1] in FILES) != bool(match[2]):
        raise Fault(f"{page.name}:{line}: a file needs a title, other blocks have none")
    return Block(match[1], match[2] or "", "\n".join(lines) + "\n", line + 1)


# ------------------------------------------------------------------------------ comparing


def differs(expected: str, actual: str) -> str | None:
    """The first expected line that `actual` lacks, by the rules of `text`; None where all is as expected."""
    return _gapped(_lines(expected), _lines(actual), like, whole=True)


def lacks(expected: str, actual: str) -> str | None:
    """The first line of an excerpt that `actual` lacks."""
    return _gapped(_lines(expected), _lines(actual), lambda a, b: a.split() == b.split(), whole=False)


def like(expected: str, actual: str) -> bool:
    """Whether two lines agree: texts but for blanks, numbers to one unit of the last digit."""
    if [" ".join(part.split()) for part in NUMBER.split(expected)] != [
        " ".join(part.split()) for part in NUMBER.split(actual)
    ]:
        return False
    pairs = zip(NUMBER.findall(expected), NUMBER.findall(actual), strict=True)
    return all(_close(a.replace("−", "-"), b.replace("−", "-")) for a, b in pairs)


def _close(a: str, b: str) -> bool:
    if "." not in a and "e" not in a:
        return a == b
    mantissa, _, exponent = a.partition("e")
    unit = 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))
    return abs(float(a) - float(b)) <= unit * (1 + 1e-9)


def _lines(text: str) -> list[str]:
    return [line.rstrip() for line in text.strip("\n").splitlines()]


def _gapped(expected: list[str], actual: list[str], same: Callable[[str, str], bool], whole: bool) -> str | None:
    """Runs of expected lines between gaps are found in `actual` in order; `whole`: nothing is left over."""
    at, anchored = 0, whole
    for run, last in _runs(expected):
        places = range(at, at + 1) if anchored else range(at, len(actual) - len(run) + 1)
        if last and whole and not anchored:
            places = range(max(at, len(actual) - len(run)), len(actual) - len(run) + 1)
        found = next((k for k in places if _matches(run, actual[k : k + len(run)], same)), None)
        if found is None:
            here = actual[at:] if anchored else []
            return next((e for e, a in zip(run, [*here, *[""] * len(run)], strict=False) if not same(e, a)), run[0])
        at, anchored = found + len(run), False
    if whole and expected[-1:] != [GAP] and at != len(actual):
        return f"(nothing) before '{actual[at]}'"
    return None


def _runs(expected: list[str]) -> Iterator[tuple[list[str], bool]]:
    """The lines between gaps, and whether they are the last."""
    runs: list[list[str]] = [[]]
    for line in expected:
        if line.strip() == GAP:
            runs.append([])
        else:
            runs[-1].append(line)
    for k, run in enumerate(runs):
        if run or k == 0:
            yield run, k == len(runs) - 1


def _matches(run: list[str], lines: list[str], same: Callable[[str, str], bool]) -> bool:
    return len(run) == len(lines) and all(map(same, run, lines))


# ------------------------------------------------------------------------------ running


class Page:
    """A page that runs in a folder."""

    def __init__(self, path: Path, folder: Path):
        self.path, self.folder, self.blocks = path, folder, blocks(path)
        self.namespace: dict = {"__name__": "__main__"}
        self.printed: str | None = None

    def run(self) -> None:
        """All blocks in order; raises Fault."""
        self.folder.mkdir(parents=True, exist_ok=True)
        environment(self.folder)
        os.chdir(self.folder)
        for k, block in enumerate(self.blocks):
            self._one(block, self.blocks[k + 1 :])

    def _one(self, block: Block, later: list[Block]) -> None:
        if block.language in PRINTED:
            self._compare(block)
            return
        if block.language in FILES:
            self._file(block, later)
            return
        self.printed = self._bash(block) if block.language == "bash" else self._python(block)
        if not self.printed:
            self.printed = None
        elif not (later and later[0].language in PRINTED):
            raise self.fault(block, f"prints, and no text says what:\n{self.printed}")

    def _compare(self, block: Block) -> None:
        if self.printed is None:
            raise self.fault(block, f"a {block.language} that follows no block that prints")
        line = differs(block.text, self.printed)
        if line is not None or (block.language == "math" and block.text != self.printed):
            raise self.fault(block, f"expected {line or block.text!r}; printed:\n{self.printed}")
        self.printed = None

    def fault(self, block: Block, what: str) -> Fault:
        return Fault(f"{self.path.name}:{block.line}: {what}")

    def _file(self, block: Block, later: list[Block]) -> None:
        name = block.title.removesuffix(EXCERPT)
        if block.title.endswith(EXCERPT):
            if not Path(name).is_file() or (line := lacks(block.text, Path(name).read_text(encoding="utf-8"))):
                raise self.fault(block, f"{name} does not hold {line!r}" if Path(name).is_file() else f"no {name}")
            return
        users = [b.text for b in later if name in b.text]
        if not users:
            raise self.fault(block, f"no later block uses {name}")
        Path(name).write_text(block.text, encoding="utf-8")
        if block.language != "c":
            self._loads(block, name, any(f"--flexible {name}" in text for text in users))
        if block.language == "c" and not any(all(flag in text for flag in STRICT_C) for text in users):
            raise self.fault(block, f"{name} is not compiled with {' '.join(STRICT_C)}")

    def _loads(self, block: Block, name: str, side: bool) -> None:
        """Refuse a file that is no TOML, JSON or XML, or a robot file that does not load; `side`: it is part of one."""
        read = {"toml": tomllib.loads, "json": json.loads, "xml": ElementTree.fromstring}[block.language]
        try:
            content = read(block.text)
        except (ValueError, ElementTree.ParseError) as error:
            raise self.fault(block, str(error)) from None
        if side or block.language == "xml" or "links" not in content:
            return
        from screwgen import RobotFileError, load

        try:
            load(name)
        except RobotFileError as error:
            raise self.fault(block, str(error)) from None

    def _bash(self, block: Block) -> str:
        if targets := make_targets(block):
            for target in targets:
                if said := unmakeable(target):
                    raise self.fault(block, said)
            return ""
        script = ["bash", "-euo", "pipefail", "-c", block.text]
        done = subprocess.run(
            script, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, text=True, timeout=LIMIT
        )
        if done.returncode:
            raise self.fault(block, f"exit status {done.returncode}:\n{done.stdout}")
        return done.stdout

    def _python(self, block: Block) -> str:
        out, name = io.StringIO(), str(self.path)
        linecache.cache.pop(name, None)
        try:
            with redirect_stdout(out), redirect_stderr(out):
                exec(compile("\n" * (block.line - 1) + block.text, name, "exec"), self.namespace)
        except Exception:
            raise self.fault(block, f"{out.getvalue()}{traceback.format_exc()}") from None
        return out.getvalue()


def environment(folder: Path) -> None:
    """`screwgen` on the PATH is this checkout's; one thread, pictures without a screen."""
    shims = folder.parent / SHIMS
    shims.mkdir(exist_ok=True)
    shim = shims / "screwgen"
    shim.write_text(f'#!/bin/sh\nPYTHONPATH="{ROOT}" exec "{sys.executable}" -m screwgen "$@"\n')
    shim.chmod(0o755)
    os.environ |= {"PATH": f"{shims}:{os.environ['PATH']}", "MPLBACKEND": "Agg", "OMP_NUM_THREADS": "1"}
    os.environ |= {"NO_COLOR": "1", "COLUMNS": "100", "LC_ALL": "C.UTF-8"}
    if str(ROOT) not in sys.path:
        sys.path.insert(0, str(ROOT))


def make_targets(block: Block) -> list[str]:
    """The targets of a block that has `make TARGET` lines and no others."""
    lines = [line.partition("#")[0].split() for line in block.text.splitlines()]
    bare = all(len(words) in (2, 3) and words[0] == "make" and not words[1].startswith("-") for words in lines)
    return [words[1] for words in lines] if bare else []


def unmakeable(target: str, root: Path = ROOT) -> str | None:
    """What is wrong with a target: the Makefile lacks it, or no test runs what it starts."""
    makefile = (root / "Makefile").read_text(encoding="utf-8")
    recipe = re.search(rf"^{re.escape(target)}:.*\n((?:\t.*\n)+)", makefile, re.MULTILINE)
    if not recipe:
        return f"the Makefile has no target {target}"
    tests = "".join(f.read_text(encoding="utf-8") for f in sorted((root / "tests").glob("test_*.py")))
    scripts = re.findall(r"\b(\w+)\.py", recipe[1])
    untested = [s for s in scripts if not re.search(rf'"{s}(\.py)?"|import {s}\b', tests)]
    return f"make {target}: no test runs {untested[0]}.py" if untested else None


def main(arguments: list[str]) -> int:
    folder, paths = Path(arguments[0]).resolve(), [Path(a).resolve() for a in arguments[1:]]
    if folder.exists() and any(folder.iterdir()) and not (folder / SHIMS).is_dir():
        print(f"pages: {folder} holds other files; choose a folder for the pages alone", file=sys.stderr)
        return 2
    for path in paths or GUIDES:
        try:
            page = Page(path, folder / path.stem)
            shutil.rmtree(page.folder, ignore_errors=True)
            page.run()
        except Fault as fault:
            print(fault, file=sys.stderr)
            return 1
        print(f"{path.name}: {len(page.blocks)} blocks")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
