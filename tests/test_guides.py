"""The guides in docs/: blocks do what they say; the site builds without a warning and loads nothing from outside."""

import importlib.util
import json
import os
import re
import struct
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import require_tool
from helpers import ROOT

pytestmark = pytest.mark.examples

DOCS = ROOT / "docs"
GENERATED = {"errata.md", "misra.md"}
"""Pages with tests of their own: test_paper.py, test_static_analysis.py."""
PROSE = {"commands.md", "features.md", "frequencies.md", "glossary.md", "paper.md", "peers.md"}
"""Pages without blocks, or with blocks run by test_control_loop.py, test_measured_parameters.py, test_cli_paper.py."""


def tool(name: str):
    """A script of docs/tools as a module."""
    spec = importlib.util.spec_from_file_location(name, DOCS / "tools" / f"{name}.py")
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


pages = tool("pages")
pictures = tool("pictures")


def pixels(file: Path) -> tuple[int, int]:
    """Width and height of a PNG, from its header."""
    return struct.unpack(">II", file.read_bytes()[16:24])


def run(path: Path, folder: Path) -> subprocess.CompletedProcess:
    command = [sys.executable, str(DOCS / "tools" / "pages.py"), str(folder), str(path)]
    return subprocess.run(command, capture_output=True, text=True)


def test_every_page_written_by_hand_is_run():
    assert {p.name for p in DOCS.glob("*.md")} - GENERATED - PROSE == {p.name for p in pages.GUIDES}


@pytest.mark.parametrize("path", pages.GUIDES, ids=lambda p: p.stem)
def test_every_block_of_a_page_does_what_it_says(path, tmp_path):
    require_tool("cc")
    require_tool("make")
    done = run(path, tmp_path / "pages")
    assert done.returncode == 0, done.stderr
    assert f"{len(pages.blocks(path))} blocks" in done.stdout
    named = re.findall(rf"\]\(pictures/guides/{path.stem}/([^)]+)\)", path.read_text())
    drawn = {f.name: pixels(f) for f in (tmp_path / "pages" / path.stem).glob("*.png")}
    assert set(drawn) == set(named), "a page shows the pictures that its blocks draw, and no others"
    committed = {name: pixels(pictures.PICTURES / "guides" / path.stem / name) for name in named}
    assert drawn == committed, "`make docs` draws the pictures anew"


# ------------------------------------------------------------------------------ the notebook

NOTEBOOK = DOCS / "notebook.ipynb"


def test_the_notebook_is_its_page(monkeypatch):
    """`python docs/tools/notebook.py` writes it: cells run, and what they show of themselves is what it has."""
    monkeypatch.setenv("MPLBACKEND", "Agg")
    assert NOTEBOOK.read_text() == tool("notebook").notebook(DOCS / "notebook.md")


def test_cells_show_models_blocks_steps_programs_functions_and_equations():
    content = json.loads(NOTEBOOK.read_text())
    assert (content["nbformat"], content["nbformat_minor"]) == (4, 4)
    cells = [c for c in content["cells"] if c["cell_type"] == "code"]
    blocks = [b.text.rstrip("\n") for b in pages.blocks(DOCS / "notebook.md") if b.language == "python"]
    assert ["".join(c["source"]) for c in cells] == blocks
    shown = ["".join(o["data"]["text/plain"]) for c in cells for o in c["outputs"] if "data" in o]
    starts = ("<Model", "<Block", "<Step", "<Program", "Functions(", "double_pendulum: M(q)", "double_pendulum: M x")
    assert len(shown) == len(starts) and all(map(str.startswith, shown, starts))
    assert len(NOTEBOOK.read_text()) < 40_000


# ------------------------------------------------------------------------------ what the runner refuses

FILE = 'c title="a.c"'
BUILD = "cc -std=c99 -Wall -Wextra -Wpedantic -Werror -o a a.c"
PROGRAM = '#include <stdio.h>\nint main(void)\n{\n    puts("1.50");\n    return 0;\n}'


def page(*parts: tuple[str, str]) -> str:
    return "\n\n".join(f"```{head}\n{body}\n```" for head, body in parts) + "\n"


REFUSED = {
    "no blocks": ("# A page\n", "without blocks"),
    "no language": (page(("", "x")), "the block's head"),
    "another language": (page(("rust", "x")), "the block's head"),
    "a marker": (page(("python skip", "1")), "the block's head"),
    "not closed": ("```python\n1\n", "not closed"),
    "indented": ("- a\n\n    ```python\n    1\n    ```\n", "indented"),
    "fails": (page(("bash", "true\nfalse\ntrue")), "exit status 1"),
    "raises": (page(("python", "1 / 0")), "ZeroDivisionError"),
    "says nothing of what it prints": (page(("python", "print(1)")), "no text says what"),
    "a text alone": (page(("python", "x = 1"), ("text", "1")), "follows no block that prints"),
    "another text": (page(("bash", "echo a"), ("text", "b")), "expected 'b'"),
    "another number": (page(("bash", "echo 1.52"), ("text", "1.50")), "expected '1.50'"),
    "another whole number": (page(("bash", "echo 3"), ("text", "2")), "expected '2'"),
    "a line too many": (page(("bash", "echo a; echo b"), ("text", "a")), "before 'b'"),
    "a line too few": (page(("bash", "echo a"), ("text", "a\nb")), "expected"),
    "another formula": (page(("python", r"print(r'\eta  x')"), ("math", r"\eta x")), "expected"),
    "no JSON": (page(('json title="a.json"', "{1}"), ("bash", "cat a.json")), "Expecting"),
    "a file without a title": (page(("toml", "a = 1")), "needs a title"),
    "a file that nobody uses": (page(('toml title="a.toml"', "a = 1"), ("bash", "true")), "no later block"),
    "a robot file that does not load": (
        page(('toml title="a.toml"', 'name = "a"\nlinks = []'), ("bash", "cat a.toml")),
        "a.toml",
    ),
    "C without warnings": (page((FILE, PROGRAM), ("bash", "cc -o a a.c")), "is not compiled with"),
    "C that warns": (page((FILE, PROGRAM.replace("return 0", "int x; return 0")), ("bash", BUILD)), "exit status 1"),
    "an excerpt of another text": (
        page(("bash", "echo one > a.h"), ('c title="a.h (excerpt)"', "two")),
        "a.h does not hold 'two'",
    ),
    "an unknown target": (page(("bash", "make nonsense")), "no target nonsense"),
    "no TOML": (page(('toml title="a.toml"', "a ="), ("bash", "cat a.toml")), "Invalid"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_a_page_is_refused(name, tmp_path):
    text, reason = REFUSED[name]
    (tmp_path / "page.md").write_text(text)
    done = run(tmp_path / "page.md", tmp_path / "pages")
    assert done.returncode == 1 and reason in done.stderr, done.stderr
    assert done.stderr.startswith("page.md:")


def test_a_page_that_holds_is_run_in_its_order(tmp_path):
    text = page(
        (FILE, PROGRAM),
        ("bash", f"{BUILD}\n./a > out"),
        ("python", "x = float(open('out').read())\nprint(f'{x + 0.01:.2f} is printed')\nprint('more\\nand more')"),
        ("text", "1.50 is  printed\n…\nand more"),
        ('c title="a.c (excerpt)"', "int main(void)\n…\n    return 0;"),
        ("bash", "make demo"),
    )
    (tmp_path / "page.md").write_text(text)
    done = run(tmp_path / "page.md", tmp_path / "pages")
    assert (done.returncode, done.stdout) == (0, "page.md: 6 blocks\n"), done.stderr


def test_a_target_that_no_test_runs_is_refused(tmp_path):
    (tmp_path / "tests").mkdir()
    (tmp_path / "Makefile").write_text("tested: x\n\tpython a/one.py\n\nother:\n\tpython a/one.py\n\tpython two.py\n")
    (tmp_path / "tests" / "test_a.py").write_text('SCRIPT = "one.py"\n')
    assert pages.unmakeable("tested", tmp_path) is None
    assert pages.unmakeable("other", tmp_path) == "make other: no test runs two.py"


def test_a_folder_with_other_files_is_left_alone(tmp_path):
    (tmp_path / "page.md").write_text(page(("bash", "true")))
    (tmp_path / "page").mkdir()
    (tmp_path / "page" / "mine").write_text("x")
    assert run(tmp_path / "page.md", tmp_path).returncode == 2
    assert (tmp_path / "page" / "mine").exists()


@pytest.mark.parametrize(
    ("expected", "actual", "agree"),
    [
        ("a 1.50 b", "a   1.51 b", True),
        ("a 1.50 b", "a 1.52 b", False),
        ("-0.00", "0.00", True),
        ("2.5e-03", "2.6e-03", True),
        ("2.5e-03", "2.7e-03", False),
        ("2.5e-03", "2.5e-04", False),
        ("10", "11", False),
        ("x1", "x2", False),
        ("[1.0, 2]", "[1.1, 2]", True),
        ("1.0 N", "1.0 m", False),
        ("1.0", "1.0 2.0", False),
    ],
)
def test_lines_agree_to_a_unit_of_the_last_digit(expected, actual, agree):
    assert pages.like(expected, actual) is agree


# ------------------------------------------------------------------------------ the site


@pytest.fixture(scope="module")
def site(tmp_path_factory) -> tuple[Path, str]:
    """The site, and all that building it said."""
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(folder)]
    env = os.environ | {"PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, cwd=ROOT, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder, done.stdout + done.stderr


def html(folder: Path) -> dict[str, str]:
    return {p.relative_to(folder).as_posix(): p.read_text() for p in sorted(folder.rglob("*.html"))}


def test_the_site_builds_without_a_warning(site):
    folder, said = site
    assert all(line.startswith("INFO") for line in said.splitlines() if line.strip()), said
    assert {"index.html", "firmware.html", "mpc.html", "research.html", "errata.html", "DESIGN.html"} <= set(
        html(folder)
    )


def test_the_site_loads_nothing_from_outside_and_has_no_date_or_place(site):
    folder, _ = site
    for name, text in html(folder).items():
        loaded = re.findall(r'<(?:script|link|img|iframe|source)\b[^>]*?(?:src|href)="([^"]*)"', text)
        assert loaded and not [u for u in loaded if re.match(r"(https?:)?//", u)], name
        assert "fonts.g" not in text and str(ROOT) not in text, name
        assert not re.search(r"\b20\d\d-\d\d-\d\d\b", text), name
    assert not list(folder.glob("sitemap*"))
    for sheet in folder.rglob("*.css"):
        assert not re.search(r"(@import|url\()\s*[\"']?(https?:)?//", sheet.read_text()), sheet.name


def test_every_block_of_a_guide_in_the_site_is_one_that_was_run(site):
    """However it is written in Markdown: no code block gets past the runner."""
    folder, _ = site
    for path in pages.GUIDES:
        shown = (folder / f"{path.stem}.html").read_text()
        blocks = pages.blocks(path)
        assert len(re.findall(r"<pre\b", shown)) == sum(b.language != "math" for b in blocks)
        assert sum(b.text.count("\n") for b in blocks if b.language == "math") <= shown.count('class="formula"')


def test_formulas_are_set(site):
    folder, _ = site
    pages_with = {name: text.count("<math") for name, text in html(folder).items() if "<math" in text}
    assert pages_with["research.html"] > 8 and pages_with["errata.html"] > 100 and pages_with["NOTATION.html"] > 60
    assert not re.search(r"[φψωηΣΛ]_|_\{|\$", html(folder)["NOTATION.html"].split("<article")[1].split("</article>")[0])
    assert not [name for name, text in html(folder).items() if "arithmatex" in text or "<merror" in text]
    assert "<mi>\U0001d400</mi><mi>\U0001d41d</mi>" in html(folder)["errata.html"], "the Adjoint's letters are bold"


def test_links_lead_somewhere(site):
    """To pages, to pictures, and to places within a page."""
    folder, _ = site
    texts = html(folder)
    ids = {name: set(re.findall(r'\bid="([^"]+)"', text)) for name, text in texts.items()}
    for name, text in texts.items():
        if name == "404.html":
            continue
        for target in re.findall(r'<(?:a|img)\b[^>]*?(?:href|src)="([^"]+)"', text):
            path, _, place = target.partition("#")
            if re.match(r"[a-z]+:", target):
                continue
            found = (folder / name).parent / path if path else folder / name
            found = found / "index.html" if found.is_dir() else found
            assert found.is_file(), (name, target)
            if place and place != "__skip" and found.suffix == ".html":
                assert place in ids[found.resolve().relative_to(folder.resolve()).as_posix()], (name, target)


def test_search_needs_no_server_and_finds_all_pages(site):
    """The index comes as a script, and what stands in for a worker from the site itself: browsers fetch no files."""
    folder, _ = site
    index = json.loads((folder / "search" / "search_index.js").read_text().removeprefix("var __index = "))
    found = {entry["location"].partition("#")[0] for entry in index["docs"]}
    assert {"index.html", "robot.html", "firmware.html", "NOTATION.html", "DESIGN.html", "errata.html"} <= found
    assert any("gravity" in entry["text"] for entry in index["docs"])
    for name, text in html(folder).items():
        scripts = re.findall(r'<script[^>]*\bsrc="([^"]+)"', text)
        assert any(s.endswith("iframe-worker.js") for s in scripts), name
        assert name == "404.html" or all(((folder / name).parent / s).is_file() for s in scripts), name


def test_pictures_are_committed_and_are_those_that_are_shown():
    """So that they show wherever the repository is read; none is left of what no page shows."""
    there = {f.relative_to(pictures.PICTURES).as_posix() for f in pictures.PICTURES.rglob("*") if f.is_file()}
    assert there == pictures.shown() | pictures.MEASURED and len(there) > 8
    assert all(f"](pictures/{name})" in (DOCS / "peers.md").read_text(encoding="utf-8") for name in pictures.MEASURED)
    assert all(min(pixels(pictures.PICTURES / name)) > 300 for name in there)
    assert not [p.name for p in pages.GUIDES if "](../build/" in p.read_text()]


def test_pictures_of_examples_are_what_examples_write():
    scripts = "".join(p.read_text() for p in sorted((ROOT / "examples").rglob("*.py")))
    for name in pictures.shown():
        first, _, rest = name.partition("/")
        if first != "guides":
            assert f'"{rest or first}"' in scripts, name


def test_make_docs_draws_the_pictures_of_examples():
    makefile = (ROOT / "Makefile").read_text()
    made = re.search(r"^docs: (.*)$", makefile, re.MULTILINE)[1]
    for name in pictures.shown():
        folder = name.partition("/")[0]
        assert folder == "guides" or f"build/{folder}" in made, name
