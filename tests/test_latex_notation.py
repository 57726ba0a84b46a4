"""Another notation, another class, a fragment: what `screwgen latex` writes with its options."""

from __future__ import annotations

import pytest
from helpers import arm, link

from screwgen import Robot, ScrewgenError
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.breaking import terms
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


def test_a_class_and_a_fragment():
    assert r"\documentclass[11pt]{report}" in latex.document(ROD, style=style("report[11pt]", False))
    fragment = latex.document(ROD, style=style(None, True))
    assert r"\documentclass" not in fragment and r"%   \usepackage{amsmath,amssymb}" in fragment
    with pytest.raises(ScrewgenError, match="write NAME"):
        style("no class", False)


def test_sums_are_cut_at_the_top_level_alone():
    cut = ["a", r"+ \left( b + c \right)", r"- \tfrac{d + e}{2}"]
    assert terms(r"a + \left( b + c \right) - \tfrac{d + e}{2}") == cut
