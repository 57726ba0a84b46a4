"""What a reader meets first: the robot, its equation, the lines of its algorithm, its mass matrix."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
from conftest import swept
from document_reader import accelerations_from_document
from document_symbols import equations, number, plain
from helpers import example, example_file
from latex_documents import PLUGINS
from latex_formula import SYMBOL
from test_document_reader import EXAMPLES

from screwgen import load
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.check_value import state
from screwgen.backends.latex.content import Display, DocumentTable, Heading, Paragraph
from screwgen.cli.main import main

WORDS = r"\\(?:begin|end)\{\w+\}|\\(?:left|right|q?quad|times|sum|limits|top|frac|sqrt|cos|sin|max)(?![A-Za-z])"
"""What is LaTeX and no symbol."""
CHOSEN = swept(EXAMPLES, "ella", "crane_loop")
OF_ROBOT = {r"\mathbf{g}", r"\mathbf{M}", r"\mathbf{h}", r"\mathbf{v}", "l", "c", "x"}
"""Letters that have one meaning with the index of a link and another without; each of them says so in its row."""


def section(name: str, title: str):
    document = latex.content(example(name).robot, PLUGINS)
    return next(s for s in document.sections if s.title == title)


@pytest.mark.parametrize("level", [1, 2, 3])
def test_numbers_of_sections_have_no_holes_at_any_level_of_detail(level):
    page = latex.html(load(example_file("gantry")), PLUGINS)
    shown = re.findall(r'<section class="l(\d)">\s*<h2 id="\w+">(\d+)\.', page)
    numbers = [int(n) for at, n in shown if int(at) <= level]
    assert numbers == list(range(1, len(numbers) + 1)) and len(numbers) >= 5


@pytest.mark.parametrize("name", CHOSEN)
def test_no_two_symbols_differ_by_the_index_of_the_link_alone(name):
    (table,) = (x for x in section(name, "Symbols").items if isinstance(x, DocumentTable))
    seen: dict[str, str] = {}
    for symbol, *_ in table.rows:
        bare = re.sub(r"_i$|_\{i\}$|,i(?=\})", "", symbol.strip("$"))
        assert seen.setdefault(bare, symbol) == symbol or bare in OF_ROBOT, (symbol, seen[bare])


@pytest.mark.parametrize("name", CHOSEN)
def test_a_line_needs_nothing_that_a_later_line_of_its_pass_defines(name):
    defined: dict[str, int] = {}
    rows = [row for x in section(name, "Algorithm").items if isinstance(x, Display) for row in x.formula]
    lines = [line for row in rows if r"\text{(A" in row[-1] for line in equations([row])]
    numbered = [(plain(left), right) for left, sign, right in lines if sign == "="]
    for k, (left, _) in enumerate(numbered):
        defined.setdefault(left, k)
    for k, (left, right) in enumerate(numbered):
        bare = re.sub(WORDS, " ", re.sub(r"\\tilde\{(.*?\})\}", r"\1", right))
        used = {plain(m[0]) for m in SYMBOL.finditer(bare)}
        late = {s for s in used if defined.get(s, -1) > k} - {left}
        assert not late, (left, late)


@pytest.mark.parametrize("name", CHOSEN)
def test_the_check_value_is_that_of_the_robot_and_of_the_lines(name):
    """As printed: the numbers of the tables, read."""
    model, items = example(name), section(name, "Algorithm").items
    start = next(k for k, x in enumerate(items) if isinstance(x, Heading) and x.text == "Check value")
    first, *others = (x for x in items[start:] if isinstance(x, DocumentTable))
    q, v, u, vdot = (
        [number(x) for x in column if x not in ("", "–")] for column in zip(*(r[1:] for r in first.rows), strict=True)
    )
    w_ext = state(model.chain, 1.0)[3]
    said = next(x.text for x in items[start:] if isinstance(x, Paragraph))
    assert all(f"{x:g}".rstrip("0") in said for x in w_ext[-1])
    wrench = np.hstack([[[number(x) for x in row[1:]] for row in table.rows] for table in others]).T
    for found in (model.numpy().forward_dynamics(q, v, u, w_ext), accelerations_from_document(model, q, v, u, w_ext)):
        np.testing.assert_allclose(found[0], vdot, rtol=1e-9, atol=1e-9 * np.max(np.abs(vdot)))
        np.testing.assert_allclose(found[1][: len(wrench)], wrench, rtol=1e-9, atol=1e-9 * np.max(np.abs(wrench)))


def test_a_page_has_the_mass_matrix_in_numbers_at_a_posture(tmp_path, capsys):
    """Its blocks lead to their formulas; entries are found by the words for coordinates."""
    model, q = example("ella"), [0.2, -0.4, 0.9]
    (tmp_path / "state.json").write_text(json.dumps({"q": q}))
    given = [
        "latex",
        str(example_file("ella")),
        "-o",
        str(tmp_path / "ella.html"),
        "--at",
        str(tmp_path / "state.json"),
    ]
    assert main(given) == 0
    page = (tmp_path / "ella.html").read_text(encoding="utf-8")
    M = model.numpy().mass_matrix([*q, *[0.0] * (model.nq - 3)])
    shown = {tuple(map(int, m[:2])): float(m[2]) for m in re.findall(r'<td id="M-(\d+)-(\d+)">([^<]*)</td>', page)}
    for (i, j), x in shown.items():
        assert x == pytest.approx(M[i - 1, j - 1], rel=1e-4, abs=1e-9)
    assert len(shown) == model.nv**2 and "first bending in y" in page
    for anchor in set(re.findall(r'<td class="(?:own|carried)"><a href="#([^"]+)"', page)):
        assert f'class="formula l1" id="{anchor}"' in page
    assert main([*given[:3], str(tmp_path / "ella.pdf"), *given[4:]]) == 2
    assert "--at: only a page" in capsys.readouterr().err
