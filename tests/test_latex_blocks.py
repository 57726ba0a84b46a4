"""Matrices that are wider than the text stand by blocks, and every block is defined once."""

from __future__ import annotations

import re

import numpy as np
import pytest
import sympy as sp
from latex_documents import ROOT, robot

from screwgen import load
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.blocks import by_blocks
from screwgen.backends.latex.layout import PAGE, width
from screwgen.backends.latex.scalars import scalars
from screwgen.backends.latex.steps import StepView
from screwgen.backends.latex.style import style
from screwgen.topology.chain import Chain

BOLD = r"\\(?:mathbf|boldsymbol)\{[^{}]*\}(?:_\{[^{}]*\})?"


def step(name: str, block: str, of: str) -> StepView:
    key = Chain(load(ROOT / "examples" / "ella.toml") if name == "ella" else robot(name)).classes[0]
    views = latex.class_views(key, latex.class_blocks(key))
    (view,) = (view for view in views if view.name == block)
    return next(s for s in view.steps if s.name == of)


def test_a_stiffness_is_by_the_directions_of_its_modes():
    shown = step("ella", "link", "K_full")
    assert r"\mathbf{K}_{yy} & \mathbf{0} & \mathbf{0} \\" in shown.formula[-1][-1]
    assert shown.components[0][0] == r"\mathbf{K}_{yy}" and r"12.3698 & 0 & 0" in shown.components[0][1]
    assert shown.components[-1][:2] == ("K_{77}", r"= 3\,G_iJ_i/l_i")


@pytest.mark.parametrize(("robot_", "block", "name"), [("ella", "link", "sigma"), ("strange", "link", "K_full")])
def test_every_block_is_defined_once_and_fits(robot_, block, name):
    shown = step(robot_, block, name)
    whole = re.findall(r"\\begin\{bmatrix\} (.*?) \\end", shown.formula[-1][-1])[-1]
    blocks = [cell for cell in re.split(r"&|\\\\", whole) if re.fullmatch(BOLD, cell.strip())]
    used = {cell.strip() for cell in blocks} - {r"\mathbf{0}"}
    defined = [cell.removeprefix(r"\qquad ") for row in shown.components for cell in row if not cell.startswith("=")]
    assert len(used) > 1 and used <= set(defined) and len(defined) == len(set(defined))
    assert all(width(" ".join(row)) <= PAGE for row in shown.components)


@pytest.mark.parametrize(
    ("name", "above"), [("M_V", r"\mathbf{M}_{V,\omega,v}"), ("M_star", r"{\mathbf{M}^*_{\omega,v}}")]
)
def test_a_block_below_the_diagonal_is_a_transpose(name, above):
    """Of a letter with a star the block is a group: LaTeX refuses a second superscript."""
    key = Chain(load(ROOT / "examples" / "ella.toml")).classes[0]
    block = latex.class_blocks(key)["link"]
    entries = np.full((6, 6), sp.Symbol("x"), dtype=object)
    whole, _ = by_blocks(block.steps[name].signal, entries, scalars(block), (), lambda _: "x")
    assert rf"\\ {above}^{{\top}} & " in whole


def test_a_large_diagonal_matrix_is_written_by_its_diagonal():
    formula = " ".join(step("ella", "link", "M_Wphi").formula[-1])
    assert formula.count(r"\rho_i A_i") == 6 and r"\mathrm{diag}" in formula


@pytest.mark.parametrize(
    ("documentclass", "margin"),
    [("article", "22mm"), ("scrartcl", "17mm"), ("scrartcl[fontsize=10pt]", "22mm"), ("report[12pt]", "10mm")],
)
def test_margins_suit_the_size_of_letters(documentclass, margin):
    assert style(documentclass, False).margin == margin
