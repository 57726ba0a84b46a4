"""Another notation, another class, a fragment: what `screwgen latex` writes with its options."""

from __future__ import annotations

import re
from collections import defaultdict

import pytest
from document_robots import robot_with
from helpers import arm, link

from screwgen import Robot, ScrewgenError
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.breaking import terms
from screwgen.backends.latex.content import SYMBOLS, DocumentTable, Paragraph, StepEquation
from screwgen.backends.latex.notation import Notation, notation
from screwgen.backends.latex.style import style

ROD = Robot.model_validate(arm(link("rod", axes="y")))


def test_letters_and_decorations_are_mapped():
    chosen = Notation("own", {r"\mathbf{v}": r"\mathbf{v}_O"}, "arrow", "prime", "cross", r"\mathsf{T}")
    assert chosen.formula(r"\dot{\mathbf{q}}_i^{\top}", {}) == r"\vec{q}_i^{\prime\mathsf{T}}"
    assert chosen.formula(r"\tilde{\mathbf{r}}_T^{2}\,\mathbf{v}_i", {}) == r"[\vec{r}_T]_{\times}^2\,\vec{v}_{O,i}"


def test_the_paper_is_the_default():
    assert latex.document(ROD, notation=notation("paper")) == latex.document(ROD)


def test_featherstone_has_spatial_velocities():
    text = latex.document(ROD, notation=notation("featherstone"))
    assert r"$\mathbf{v}_i = [\boldsymbol{\omega}_i;\ \mathbf{v}_{O,i}]$" in text and r"\mathbf{V}_i" not in text


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ('vector = "arrow"', "own.toml: vector: unknown key; did you mean vectors?"),
        ('rates = "ring"', "own.toml: rates: 'ring' is no choice; write dot or prime"),
        ("[letters]\nV = '1'", "own.toml: letters.V: '1' is no letter; write a letter in LaTeX"),
    ],
)
def test_a_faulty_table_is_one_line(text, fault, tmp_path):
    (tmp_path / "own.toml").write_text(text)
    with pytest.raises(ScrewgenError) as caught:
        notation(str(tmp_path / "own.toml"))
    assert fault in str(caught.value) and "\n" not in str(caught.value)


def test_symbols_that_would_look_alike_are_refused():
    with pytest.raises(ScrewgenError, match="would both be written"):
        latex.document(ROD, notation=Notation("own", {r"\mathbf{V}": r"\mathbf{v}"}))


def skeleton(symbol: str) -> str:
    """A symbol without its typeface, and with one mark for every index that counts: of a link, a section, a mass."""
    symbol = re.sub(r"\\(?:mathbf|boldsymbol|mathcal)\{([^{}]*)\}", r"\1", symbol)
    symbol = re.sub(r"_\{(\w)\}", r"_\1", symbol)
    return re.sub(r"(?<=[_{,])[ijkm](?![A-Za-z])", "#", symbol)


@pytest.mark.parametrize("features", [("exact", "tendons"), ("one exact", "varying", "ball"), ("order 2", "tendons")])
def test_no_two_symbols_print_alike_but_for_typeface_and_kind_of_index(features):
    """Sections, masses and points of tendons have letters of their own; so have functions of the place in the text."""
    content = latex.content(Robot.model_validate(robot_with(*features)))
    found, steps = defaultdict(set), defaultdict(set)
    for section in content.sections:
        for item in section.items:
            if isinstance(item, StepEquation):
                found[skeleton(item.step.formula[0][0])].add(item.step.formula[0][0])
                steps[item.step.name, section.title].add(item.step.formula[0][0])
            elif isinstance(item, DocumentTable) and section.title == SYMBOLS:
                for row in item.rows:
                    found[skeleton(row[0].strip("$"))].add(row[0].strip("$"))
            elif isinstance(item, Paragraph) and "(R2)" in item.text:
                for symbol in re.findall(r"(\\mathbf\{b\}_k)\(", item.text):
                    found[skeleton(symbol)].add(f"{symbol}(x, y)")
    assert len(found) > 60
    assert [sorted(own) for name, own in found.items() if "#" in name and len(own) > 1] == []
    assert [(name, own) for name, own in steps.items() if len(own) > 1] == []


def test_a_class_and_a_fragment():
    assert r"\documentclass[11pt]{report}" in latex.document(ROD, style=style("report[11pt]", False))
    fragment = latex.document(ROD, style=style(None, True))
    assert r"\documentclass" not in fragment and r"%   \usepackage{amsmath,amssymb}" in fragment
    with pytest.raises(ScrewgenError, match="write NAME"):
        style("no class", False)


def test_sums_are_cut_at_the_top_level_alone():
    cut = ["a", r"+ \left( b + c \right)", r"- \tfrac{d + e}{2}"]
    assert terms(r"a + \left( b + c \right) - \tfrac{d + e}{2}") == cut
