"""The documents as a reader gets them: HTML that any browser shows, PDF in which nothing runs off the page."""

from __future__ import annotations

import io
import re
import shutil
from base64 import b64decode
from xml.etree import ElementTree

import jinja2
import numpy as np
import pytest
from browsers import every_browser, started
from conftest import require_tool, swept
from fontTools.ttLib import TTFont
from helpers import ROOT, arm, example_file, link
from latex_documents import NAMES, page, robot, tex, too_wide

from screwgen import Robot, ScrewgenError, load
from screwgen.backends.latex import document as latex
from screwgen.backends.latex import engine, mathml
from screwgen.backends.latex.style import style
from screwgen.backends.latex.text import in_html
from screwgen.backends.templates import folder, render
from screwgen.cli.main import main

MATHML = "{http://www.w3.org/1998/Math/MathML}"
HEAD = '<!DOCTYPE html><meta charset="utf-8">'
ACCENTED = r"\tilde{\boldsymbol{\theta}}_c^{2} + \dot{\mathbf{r}}^{\top} + \ddot{\boldsymbol{\eta}}_i"

# -------- HTML


@pytest.mark.parametrize("name", swept(NAMES, "ella", "strange"))
def test_html_is_well_formed_and_has_mathml(name):
    tree = ElementTree.fromstring(page(name))
    formulas = [e for e in tree.iter() if e.tag in ("math", f"{MATHML}math")]
    assert len(formulas) > 100
    for element in formulas:
        text = "".join(element.itertext())
        assert "\\" not in text and "&" not in text, text
        assert text.strip()


def test_html_needs_nothing_from_elsewhere():
    assert not re.search(r"(?:src|href)=\"(?!#)", page("ella"))


@pytest.mark.parametrize("name", swept(NAMES, "ella", "strange"))
def test_the_math_font_has_every_character_of_the_formulas(name):
    """Single letters of identifiers are shown as the italic ones, which it has too; brackets have parts to grow by."""
    font = TTFont(io.BytesIO(b64decode(latex.math_font())))
    known, variants = font.getBestCmap(), font["MATH"].table.MathVariants
    letters = {"h": "\u210e"} | {chr(0x61 + k): chr(0x1D44E + k) for k in range(26) if k != 7}
    for first, italic, count in ((0x41, 0x1D434, 26), (0x3B1, 0x1D6FC, 25)):
        letters |= {chr(first + k): chr(italic + k) for k in range(count)}
    for math in ElementTree.fromstring(page(name)).iter("math"):
        texts = ["".join(element.itertext()) for element in math.iter() if not len(element)]
        missing = {c for text in texts for c in {*text, letters.get(text, " ")} if ord(c) not in known} - {"\n"}
        assert not missing, missing
    grows = dict(zip(variants.VertGlyphCoverage.glyphs, variants.VertGlyphConstruction, strict=True))
    assert all(grows[known[ord(c)]].GlyphAssembly.PartRecords for c in "()[]{}")


@pytest.mark.examples
@every_browser
def test_pages_are_set_in_their_own_font(program, tmp_path):
    """In a browser, offline: the font is there, and a bracket is as high as the matrix that it holds."""
    formula = mathml.inline(r"\begin{bmatrix} a \\ b \\ c \\ d \end{bmatrix}")
    style = re.search(r"<style>(.*?)</style>", page("ella"), re.S)[1]
    aligned = mathml.display((("a", "= b"), ("c + d", "= e")))
    (tmp_path / "page.html").write_text(f"{HEAD}<style>{style}</style><p>{formula}</p>{aligned}")
    with started(program, tmp_path) as browser:
        browser.go((tmp_path / "page.html").as_uri())
        browser.until("document.readyState === 'complete' && document.fonts.size")
        assert browser.run("document.fonts.ready.then(fonts => [...fonts].map(x => x.status).join())") == "loaded"
        high = "document.querySelector('{}').getBoundingClientRect().height"
        assert browser.run(high.format("mo")) > 0.95 * browser.run(high.format("mtable")) > 60
        left, right = (f"document.querySelectorAll('.rows > mtr > mtd:nth-child({n}) > *')" for n in (1, 2))
        ends = browser.run(f"[...{left}].map(x => x.getBoundingClientRect().right)")
        starts = browser.run(f"[...{right}].map(x => x.getBoundingClientRect().left)")
        assert np.ptp(ends) < 1.0 and np.ptp(starts) < 1.0, "sides end and begin at the equals signs"
        assert browser.complaints == [] and browser.requests == [(tmp_path / "page.html").as_uri()]


def test_formulas_of_a_page_have_no_groups_that_change_nothing():
    """Groups around operators stay, which have room by their place in a group; marks go to what was in a group."""
    matrix = '<mrow><mi>a</mi><mo>=</mo><mrow data-s="1"><mi>b</mi></mrow></mrow>'
    bracket = '<mo stretchy="true" fence="true" form="prefix">(</mo>'
    text = f"<mtd>{matrix}</mtd><msup><mrow><mi>c</mi></mrow><mrow><mo>*</mo></mrow></msup>{bracket}"
    root = ElementTree.fromstring(f"<math>{text}</math>")
    mathml.shorten(root)
    wanted = (
        '<mtd><mi>a</mi><mo>=</mo><mi data-s="1">b</mi></mtd><msup><mi>c</mi><mrow><mo>*</mo></mrow></msup><mo>(</mo>'
    )
    assert ElementTree.tostring(root, encoding="unicode") == f"<math>{wanted}</math>"


def test_units_are_text():
    shown = {
        r"\mathrm{kg}\,\mathrm{m}^{2}": "kg\u00a0m<sup>2</sup>",
        r"1/\mathrm{s}^{2}": '<span class="tie">1/s<sup>2</sup></span>',
        r"\mathrm{N\,m/rad}": '<span class="tie">N\u00a0m/rad</span>',
    }
    assert {formula: in_html(f"${formula}$") for formula in shown} == shown
    assert all("<math>" in in_html(f"${formula}$") for formula in (r"c_{\mathrm{turn}}", r"\mathrm{d}\mathbf{m}", "1"))


def test_bold_letters_are_characters():
    assert "\U0001d74e" in page("ella")  # bold italic omega
    assert 'mathvariant="bold' not in page("ella")


def test_what_is_wider_than_a_telephone_scrolls_by_itself():
    text = page("ella").partition("<script>//")[0]
    assert text.count("<table") == text.count('<div class="wide"><table') > 0
    assert re.search(r"\.wide, [^{]*\.formula \{ overflow-x: auto", text)
    assert "prefers-color-scheme: dark" in page("ella")


def test_superscripts_beside_accents_keep_their_height():
    """The accent is above the letter that scripts are placed by, and is given its room around both."""
    tree = ElementTree.fromstring(f"<p>{mathml.inline(r'{x}^{2}')}{mathml.inline(ACCENTED)}</p>")
    scripted = [e for e in tree.iter() if e.tag in ("msup", "msubsup")]
    assert [e[0].tag for e in scripted] == ["mrow", "mpadded", "mpadded"]
    assert all(e[0].get("height") == "0.7em" and e[0][0].tag == "mover" for e in scripted[1:])
    assert not re.search(r"<m(?:sup|subsup)><mover", page("ella"))


def test_what_a_notebook_shows_is_short():
    """Markdown tables with as many cells in every row, formulas in them; classes with equal blocks share a table."""
    shown = latex.notebook(robot("ella"))
    rows = [line for line in shown.splitlines() if line.startswith("|")]
    assert len(shown) < 10_000 and "Class 1 and 2: " in shown and "`M_D`" in shown
    assert {len(re.findall(r"(?<!\\)\|", row)) for row in rows} == {7, 8}


# -------- templates


def test_an_unknown_name_in_a_template_is_an_error():
    with pytest.raises(jinja2.UndefinedError):
        render("latex/document.tex.jinja")


def test_the_templates_are_where_they_belong():
    assert (folder() / "latex" / "document.tex.jinja").is_file()


# -------- pdflatex


@pytest.mark.parametrize("name", swept(NAMES, "strange"))
def test_pdflatex_compiles_and_nothing_runs_off_the_page(name, tmp_path):
    assert too_wide(tex(name), tmp_path) <= 5.0


@pytest.mark.parametrize("name", swept(("ella", "tentacle"), "ella"))
def test_no_page_has_the_head_of_a_table_without_its_rows(name, tmp_path):
    """Heads and rows tell in the log that they are printed, page by page."""
    text = latex.document(load(ROOT / "examples" / f"{name}.toml"))
    rows = re.compile(r"(?<=\\endfoot\n).*?(?=\\end\{longtable\})", re.S)
    text = rows.sub(lambda match: re.sub(r"(\\\\\*?)(?=\n)", r"\1\\noalign{\\write-1{TABLE row}}", match[0]), text)
    too_wide(text.replace(r"\endhead", r"\noalign{\write-1{TABLE head}}\endhead"), tmp_path)
    told = re.findall(r"TABLE (\w+)", (tmp_path / "equations.log").read_text(errors="replace"))
    assert told.count("row") > told.count("head") > 8
    assert "head head" not in " ".join(told) and told[-1] == "row"


FRAME = r"""\documentclass{article}
\usepackage{amsmath,amssymb,array,booktabs,longtable}
\usepackage[textwidth=155mm]{geometry}
\begin{document}
FRAGMENT
\end{document}
"""


@pytest.mark.parametrize("chosen", swept(("fragment", "scrartcl", "report[12pt]", "article[twocolumn]"), "fragment"))
@pytest.mark.parametrize("name", ["ella", "crane_loop"])
def test_lines_fit_other_classes_and_a_text_of_44_em(name, chosen, tmp_path):
    alone = chosen == "fragment"
    text = latex.tex(latex.content(load(example_file(name))), style(None if alone else chosen, alone))
    assert too_wide(FRAME.replace("FRAGMENT", text) if alone else text, tmp_path) == 0.0


@pytest.mark.long
def test_random_robots_compile(tmp_path):
    """One robot with whatever a draw gives; the width of every line is what this looks for."""
    from random_robots import random_robot

    text = latex.document(Robot.model_validate(random_robot(np.random.default_rng(3), n_links=2)))
    assert too_wide(text, tmp_path) <= 5.0


def test_the_pdf_is_the_same_every_time():
    """The head, the contents and the first section of a pendulum's document."""
    require_tool("pdflatex")
    text = latex.document(Robot.model_validate(arm(link("rod", axes="y"))))
    text = r"\section{".join(text.split(r"\section{")[:3]) + r"\end{document}"
    first, second = engine.pdf(text), engine.pdf(text)
    assert first == second and first.startswith(b"%PDF")


def test_without_pdflatex_one_line_says_so(monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(ScrewgenError, match=r"^pdflatex was not found;.*$"):
        engine.pdf("")


def test_a_pdf_without_pdflatex_is_refused_before_the_robot_is_read(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(shutil, "which", lambda _: None)
    assert main(["latex", "there-is-no.toml", "-o", str(tmp_path / "x.pdf")]) == 2
    assert "pdflatex was not found; install TeX Live" in capsys.readouterr().err


def test_a_failure_of_pdflatex_is_one_line():
    require_tool("pdflatex")
    with pytest.raises(ScrewgenError) as caught:
        engine.pdf(r"\documentclass{article}\begin{document}\nonsense\end{document}")
    assert str(caught.value) == "pdflatex failed: Undefined control sequence."
