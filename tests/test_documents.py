"""What the documents for readers of the code name exists, and the blocks of the tour print what they say."""

import io
import re
import subprocess
from contextlib import redirect_stdout
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PAGES = ("README.md", "DESIGN.md", "CONTRIBUTING.md", "NOTATION.md")
PAGES += ("docs/glossary.md", "docs/features.md", "docs/commands.md")
DESIGN = tuple(sorted(p.relative_to(ROOT).as_posix() for p in (ROOT / "docs" / "design").glob("*.md")))
ROOTS = ("", "screwgen/", "docs/", "docs/design/", "templates/", "tests/", "examples/")
"""Where a path of a page may begin."""
PATH = re.compile(
    r"(?:[\w.-]+/)*[\w.*-]+\.(?:py|jinja|md|toml|ipynb|js|txt|json)"
    r"|(?:screwgen|templates|tests|docs|examples)/[\w./*-]*"
)
SHORT = 4
"""Names of so few letters are symbols of formulas."""
NAME = re.compile(r"[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*(?:\(\))?")
MADE = tuple("build/ out/ run. pendulum robot. links.toml gains mpc.toml every_key .venv".split())
"""What a reader or a command makes."""


def prose(path: str) -> list[tuple[int, str]]:
    """The lines of a page outside of blocks, with their numbers."""
    out, inside = [], False
    for number, line in enumerate((ROOT / path).read_text(encoding="utf-8").splitlines(), 1):
        if line.lstrip().startswith(("```", "~~~")):
            inside = not inside
        elif not inside:
            out.append((number, line))
    return out


@cache
def files() -> frozenset[str]:
    """The names of the files of the repository, without their folders."""
    return frozenset(Path(name).name for name in tracked())


@cache
def tracked() -> list[str]:
    """The files of the repository."""
    command = ["git", "ls-files", "-co", "--exclude-standard"]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()


@cache
def words() -> frozenset[str]:
    """All identifiers of the program, its templates and tests, and of what they generate for the examples."""
    kinds = (".py", ".jinja", ".js", ".toml", ".c", ".h", ".txt", "Makefile", ".cff", ".json")
    own = [ROOT / name for name in tracked() if name.endswith(kinds) and name != "tests/test_documents.py"]
    text = "\n".join(file.read_text(encoding="utf-8", errors="replace") for file in own if file.is_file())
    return frozenset(re.findall(r"\w+", text))


def missing_paths(path: str) -> list[str]:
    """The paths in backticks and links of a page that lead nowhere."""
    out = []
    for number, line in prose(path):
        quoted = re.findall(r"`([^`]+)`", line)
        found = [text for text in quoted if PATH.fullmatch(text)]
        for name in found:
            there = any(any(ROOT.glob(f"{root}{name}")) for root in ROOTS) or ("/" not in name and name in files())
            if not there and not name.startswith(MADE):
                out.append(f"{path}:{number}: there is no {name}")
        for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", line):
            places = (ROOT / path).parent / target, ROOT / target
            if not any(place.exists() for place in places):
                out.append(f"{path}:{number}: the link {target} leads nowhere")
    return out


def unknown_names(path: str) -> list[str]:
    """The identifiers in backticks that nothing in the program is called."""
    out = []
    for number, line in prose(path):
        for text in re.findall(r"`([^`]+)`", line):
            if NAME.fullmatch(text) and not PATH.fullmatch(text):
                parts = (part for part in text.removesuffix("()").split(".") if len(part) > SHORT)
                lost = [part for part in parts if part not in words()]
                out += [f"{path}:{number}: nothing is called {part} ({text})" for part in lost]
    return out


@pytest.mark.parametrize("path", [*PAGES, *DESIGN])
def test_every_path_and_name_of_a_page_exists(path):
    names = [] if path == "NOTATION.md" else unknown_names(path)  # its C names have parts of robots in them
    assert [*missing_paths(path), *names] == []


def test_a_wrong_path_and_a_wrong_name_are_found(tmp_path, monkeypatch):
    (tmp_path / "docs").mkdir()
    text = "See `screwgen/afloat/none.py`, `no_such_name_at_all` and [this](docs/nothing.md).\n"
    (tmp_path / "page.md").write_text(text)
    known, named = words(), files()
    monkeypatch.setattr("test_documents.ROOT", tmp_path)
    monkeypatch.setattr("test_documents.words", lambda: known)
    monkeypatch.setattr("test_documents.files", lambda: named)
    assert missing_paths("page.md") == [
        "page.md:1: there is no screwgen/afloat/none.py",
        "page.md:1: the link docs/nothing.md leads nowhere",
    ]
    assert unknown_names("page.md") == ["page.md:1: nothing is called no_such_name_at_all (no_such_name_at_all)"]


def test_the_numbers_of_the_tour_are_what_its_blocks_print(tmp_path, monkeypatch):
    text = (ROOT / "DESIGN.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```(\w+)(?: title=\"([^\"]+)\")?\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    monkeypatch.chdir(tmp_path)
    space: dict = {}
    for language, title, body in blocks:
        if language == "toml":
            Path(title).write_text(body)
        elif language == "python":
            with redirect_stdout(io.StringIO()) as said:
                exec(compile(body, "DESIGN.md", "exec"), space)
        else:
            assert said.getvalue() == body
    space["model"].write("out", ("c",))
    (line,) = re.findall(r"`(const pendulum_real [^`]*)`", text)
    assert line in Path("out/c/pendulum_dynamics.c").read_text()


def test_sizes_of_the_documents():
    """A screen of promise, and a tour that one reads in a sitting."""
    assert len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()) <= 150
    assert len((ROOT / "DESIGN.md").read_text(encoding="utf-8").split()) <= 2000
