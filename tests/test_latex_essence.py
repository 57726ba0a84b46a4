"""What a reader meets first: the robot, its equation, the lines of its algorithm, its mass matrix."""

from __future__ import annotations

import json
import re
import tomllib
from functools import cache

import numpy as np
import pytest
from conftest import swept
from document_reader import accelerations_from_document, reading
from document_state import State
from document_steps import sized
from document_symbols import equations, number, plain
from helpers import example, example_dict, example_file, model_of
from latex_documents import PLUGINS, ROOT
from latex_formula import SYMBOL, value
from oracle import Oracle
from test_document_reader import EXAMPLES
from test_document_reader import state as random_state

from screwgen import load
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.check_value import state
from screwgen.backends.latex.content import Display, DocumentTable, Heading, Paragraph, StepEquation
from screwgen.backends.latex.mass_matrix import coordinates, formulas
from screwgen.backends.latex.style import DocumentStyle
from screwgen.cli.main import main

WORDS = r"\\(?:begin|end)\{\w+\}|\\(?:left|right|q?quad|times|sum|limits|top|frac|sqrt|cos|sin|max)(?![A-Za-z])"
"""What is LaTeX and no symbol."""
AT_SECTIONS = re.compile("^Section at|a section|of the rod")
CHOSEN = swept((*EXAMPLES, "pendulum"), "ella", "crane_loop", "pendulum")
OF_ROBOT = {r"\mathbf{g}", r"\mathbf{M}", r"\mathbf{h}", r"\mathbf{v}", r"\mathbf{q}", "l", "c", "x"}
"""Letters that have one meaning with the index of a link and another without; each of them says so in its row."""


@cache
def model(name: str):
    """An example, or the pendulum of the README."""
    if name != "pendulum":
        return example(name)
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return model_of(tomllib.loads(re.search(r"cat > pendulum\.toml <<'END'\n(.*?)END", text, re.DOTALL)[1]))


def section(name: str, title: str):
    document = latex.content(model(name).robot, PLUGINS)
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


def test_on_paper_a_pendulum_is_half_of_what_all_forms_take():
    """What the algorithm needs is printed; derivation and further forms are asked for."""
    shown = latex.content(model("pendulum").robot, PLUGINS)
    short, whole = (latex.tex(shown, DocumentStyle(whole=every)) for every in (False, True))
    assert len(short) < 50_000 and len(short) < 0.6 * len(whole)
    titles = [re.findall(r"\\section\{(.*?)\}", text) for text in (short, whole)]
    further = {"Derivation", "The Z-form", "Link class 1, other forms"}
    assert further == set(titles[1]) - set(titles[0]) and titles[0] == [t for t in titles[1] if t not in further]
    assert r"--\cut{}all" in short and r"--\cut{}all" not in whole


def alone(items):
    """The steps printed without components, but for those of a rod's many sections, each of which has its own scope."""
    heading = ""
    for item in items:
        if isinstance(item, Heading):
            heading = item.text
        elif isinstance(item, StepEquation) and item.step.alone and not AT_SECTIONS.search(heading):
            yield item.step


@pytest.mark.parametrize("name", CHOSEN)
def test_components_that_print_leaves_out_follow_from_the_equation(name):
    own = model(name)
    read = State(reading(own), *random_state(own))
    for section in latex.content(own.robot, PLUGINS).sections:
        parts = read.reading.document.classes.get(0 if section.appendix else section.link_class)
        for scope in (s for s in read.scopes if s.parts is parts):
            for step in alone(section.items):
                by_entries = scope.by_entries(step.definition, scope)
                by_formula = sized(scope.step(step.definition), by_entries.shape)
                np.testing.assert_allclose(by_formula, by_entries, rtol=1e-11, atol=1e-11, err_msg=step.name)


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
    own, items = model(name), section(name, "Algorithm").items
    start = next(k for k, x in enumerate(items) if isinstance(x, Heading) and x.text == "Check value")
    first, *others = (x for x in items[start:] if isinstance(x, DocumentTable))
    q, v, u, vdot = (
        [number(x) for x in column if x not in ("", "–")] for column in zip(*(r[1:5] for r in first.rows), strict=True)
    )
    w_ext = state(own.chain, 1.0)[3]
    said = next(x.text for x in items[start:] if isinstance(x, Paragraph))
    assert all(f"{x:g}".rstrip("0") in said for x in w_ext[-1])
    of_links = [[row[1:] for row in table.rows] for table in others] or [[row[6:] for row in first.rows[:6]]]
    wrench = np.hstack([[[number(x) for x in row] for row in rows] for rows in of_links]).T
    for found in (own.numpy().forward_dynamics(q, v, u, w_ext), accelerations_from_document(own, q, v, u, w_ext)):
        np.testing.assert_allclose(found[0], vdot, rtol=1e-9, atol=1e-9 * np.max(np.abs(vdot)))
        np.testing.assert_allclose(found[1][: len(wrench)], wrench, rtol=1e-9, atol=1e-9 * np.max(np.abs(wrench)))


def test_a_page_has_the_mass_matrix_in_numbers_at_a_posture(tmp_path, capsys):
    """Its blocks lead to their formulas; entries are found by the words for coordinates."""
    ella, q = example("ella"), [0.2, -0.4, 0.9]
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
    M = ella.numpy().mass_matrix([*q, *[0.0] * (ella.nq - 3)])
    cells = re.findall(r'<td id="M-(\d+)-(\d+)"[^>]*>([^<]*)</td>', page.replace("−", "-"))
    shown = {(int(i), int(j)): float(x) for i, j, x in cells}
    for (i, j), x in shown.items():
        assert x == pytest.approx(M[i - 1, j - 1], rel=1e-4, abs=1e-9)
    assert len(shown) == ella.nv**2 and "first bending in y" in page
    for anchor in set(re.findall(r'<td class="(?:own|carried)"><a href="#([^"]+)"', page)):
        assert f'class="formula l1" id="{anchor}"' in page
    assert main([*given[:3], str(tmp_path / "ella.pdf"), *given[4:]]) == 2
    assert "--at: only a page" in capsys.readouterr().err


SHORT = {"ella": 6, "six_link": 3, "flexible_arm": 7}
"""How many entries have short formulas at least."""


@pytest.mark.parametrize("name", swept(SHORT, "ella", "six_link"))
def test_short_entries_of_the_mass_matrix_are_those_of_the_oracle(name):
    """Their formulas, read with the values of the table below them: six digits; zeros are zeros in every posture."""
    own, oracle, rng = example(name), Oracle(example_dict(name)), np.random.default_rng(3)
    found = formulas(own.chain)
    names = {row[0].strip("$"): rf"\mathrm{{p{k}}}" for k, row in enumerate(found.letters.rows)}
    known = {names[row[0].strip("$")]: number(row[3]) for row in found.letters.rows}
    for _ in range(3):
        q = rng.uniform(-1.0, 1.0, own.nq)
        q[own.nq - own.chain.n_modes :] *= 0.05
        here = known | {plain(x.name.latex): x_ for x, x_ in zip(coordinates(own.chain), q, strict=True)}
        M = oracle.mass_matrix(q)
        scale = np.sqrt(np.outer(np.diag(M), np.diag(M)))
        for (i, j), rows in found.entries.items():
            text = re.sub(r"\\Big[lr]", "", "".join(cell for row in rows for cell in row)).partition("=")[2]
            for symbol in sorted(names, key=len, reverse=True):
                text = text.replace(symbol, names[symbol])
            entry = value(text, lambda n, here=here: np.full((1, 1), here[plain(n)]))
            assert entry == pytest.approx(M[i - 1, j - 1], abs=1e-5 * scale[i - 1, j - 1]), (i, j)
        assert all(abs(M[i - 1, j - 1]) < 1e-12 * scale[i - 1, j - 1] for i, j in found.zeros)
    assert len(found.entries) >= SHORT[name]
