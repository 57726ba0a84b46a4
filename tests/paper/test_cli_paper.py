"""The command `paper`: lists, single equations and errata, files, and what it refuses."""

import json
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from conftest import require_tool
from latex_documents import too_wide

from screwgen.cli.main import main
from screwgen.paper import document
from screwgen.paper.plain import WIDTH, shown
from screwgen.paper.register import equations, errata

ROOT = Path(__file__).resolve().parents[2]
ERRATA_PAGE, PAPER_PAGE, README = ROOT / "docs" / "errata.md", ROOT / "docs" / "paper.md", ROOT / "README.md"


def output(capsys, *arguments):
    assert main(["paper", *arguments]) == 0
    return capsys.readouterr().out


def test_the_list_has_every_equation(capsys):
    text = output(capsys)
    for e in equations():
        assert f"({e.label})" in text
    assert f"{len(equations())} equations: " in text
    assert all(shown(line) <= 120 for line in text.splitlines())


@pytest.mark.parametrize("e", equations(), ids=lambda e: e.label)
def test_every_equation_is_shown(e, capsys):
    text = output(capsys, e.label)
    assert f"({e.label})" in text and e.standing.value in text
    assert ("\n  derived\n" in text) == bool(e.derived)
    assert "\\" not in text.replace("\\n", "")
    assert all(shown(line) <= WIDTH + 30 for line in text.splitlines())


@pytest.mark.parametrize("label", ["(29)", "eq:29", "29"])
def test_a_label_may_be_written_as_in_the_paper(label, capsys):
    assert output(capsys, label).startswith("(29)")


def test_the_difference_is_shown_as_a_formula(capsys):
    text = output(capsys, "34")
    assert "printed − derived = −r̃_ξi ω̇_i − ω̃_i v_i" in text


def test_errata_are_shown_with_figures(capsys):
    text = output(capsys, "E16")
    assert "printed" in text and "derived" in text and "must be" in text and "22." in text
    listing = output(capsys, "--errata")
    assert all(e.number in listing for e in errata())


def test_several_at_once(capsys):
    text = output(capsys, "29", "E5")
    assert text.startswith("(29)") and "\nE5 " in text


def test_json_has_the_formulas(capsys):
    rows = json.loads(output(capsys, "--json"))
    assert len(rows) == len(equations())
    by_label = {row["label"]: row for row in rows}
    assert by_label["29"]["standing"] == "fails" and by_label["29"]["difference"]
    (erratum,) = json.loads(output(capsys, "E25", "--json"))
    assert erratum["number"] == "E25" and erratum["figures"]


@pytest.mark.parametrize("suffix", [".tex", ".html", ".pdf"])
def test_the_document_is_written(suffix, tmp_path, capsys):
    file = tmp_path / f"paper{suffix}"
    if suffix == ".pdf":
        require_tool("pdflatex")
    output(capsys, "29", "E7", "-o", str(file))
    text = file.read_text(encoding="latin-1")
    assert text.startswith("%PDF") if suffix == ".pdf" else "(29)" in text and "E7" in text
    first = file.read_bytes()
    output(capsys, "29", "E7", "-o", str(file))
    assert file.read_bytes() == first


def test_all_of_the_paper_in_every_format(tmp_path, capsys, monkeypatch):
    """The page of errata is current; every equation and erratum gets through MathML and pdflatex, within its column."""
    file = tmp_path / "errata.md"
    output(capsys, "--errata", "-o", str(file))
    assert file.read_text(encoding="utf-8") == ERRATA_PAGE.read_text(encoding="utf-8")
    whole = document.content(equations(), errata())
    monkeypatch.setattr(document, "content", lambda *chosen: whole)
    for name in ("paper.html", "paper.tex"):
        output(capsys, "-o", str(tmp_path / name))
        text = (tmp_path / name).read_text(encoding="utf-8").replace(r"\_", "_")
        assert all(f"({e.label}) " in text for e in equations())
        assert all(f"{e.number}: " in text for e in errata())
    ElementTree.parse(tmp_path / "paper.html")
    assert too_wide((tmp_path / "paper.tex").read_text(encoding="utf-8"), tmp_path) <= 1.1


def test_numbers_have_minus_signs():
    cells = [line for line in ERRATA_PAGE.read_text(encoding="utf-8").splitlines() if line.startswith("|")]
    assert not [cell for line in cells for cell in line.split("|") if re.match(r"\s*-\d|.*\de-\d", cell)]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["4711"], "the paper has no equation '4711'"),
        (["phi_q"], "did you mean"),
        (["E99"], "the paper has no erratum 'E99'"),
        (["29", "--errata"], "--errata means all errata"),
        (["29", "-o", "paper.md"], "a .md file holds errata alone"),
        (["--json", "-o", "paper.tex"], "--json prints"),
        (["-o", "paper.doc"], "unknown suffix"),
        (["-o", "missing/paper.tex"], "folder does not exist"),
    ],
)
def test_what_cannot_be_done_is_one_line(arguments, message, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["paper", *arguments]) == 2
    error = capsys.readouterr().err
    assert message in error and error.count("\n") == 1
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("path", [README, ROOT / "docs" / "index.md"], ids=lambda path: path.name)
def test_the_paper_is_cited_once(path):
    text = " ".join(path.read_text(encoding="utf-8").replace("*", "").replace("[", "").split())
    assert text.count(document.CITATION) == 1


def test_the_errata_cite_the_paper_once():
    assert " ".join(ERRATA_PAGE.read_text(encoding="utf-8").split()).count(f"The paper is {document.CITATION}.") == 1


def test_the_readme_says_where_the_command_is_before_its_first_use():
    text = README.read_text(encoding="utf-8")
    assert text.index('export PATH="$PWD/.venv/bin:$PATH"') < text.index("$ screwgen")


def test_the_readme_shows_what_is_printed(capsys):
    block = re.search(r"\$ screwgen paper 34\n(.*?)```", PAPER_PAGE.read_text(encoding="utf-8"), re.DOTALL)[1]
    text = output(capsys, "34")
    for part in block.split("...\n"):
        assert part.rstrip() in text
