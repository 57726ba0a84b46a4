"""The equations as documents: complete, well-formed, the same every time, and nothing runs off the page."""

from __future__ import annotations

import re
from collections import Counter

import pytest
import sympy as sp
from conftest import swept
from helpers import arm, link
from latex_documents import NAMES, PLUGINS, WHOLE, content, every_robot, page, robot, tex, views

from screwgen import Robot
from screwgen.algebra import expression as ex
from screwgen.algebra.notation import latex as formula
from screwgen.algebra.notation import number, tilde
from screwgen.algorithms.scope import derived
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.content import CITATION
from screwgen.backends.latex.layout import PAGE, width
from screwgen.backends.latex.scalars import scalars
from screwgen.backends.latex.steps import block_view
from screwgen.backends.latex.symbols import entries, written
from screwgen.ir.block import Block
from screwgen.topology.chain import Chain

# -------- LaTeX


@pytest.mark.parametrize("name", swept(NAMES, "ella"))
def test_the_same_every_time(name):
    assert latex.document(robot(name), PLUGINS, WHOLE) == tex(name)
    assert latex.html(robot(name), PLUGINS) == page(name)


@every_robot
def test_braces_and_environments_are_balanced(name):
    depth, open_environments = 0, []
    for token in re.findall(r"\\begin\{\w+\*?\}|\\end\{\w+\*?\}|\\.|[{}]", tex(name)):
        if token.startswith(r"\begin"):
            open_environments.append(token[7:-1])
        elif token.startswith(r"\end{"):
            assert open_environments.pop() == token[5:-1]
        elif token in "{}":
            depth += 1 if token == "{" else -1
            assert depth >= 0
    assert depth == 0 and not open_environments
    assert tex(name).count(r"\left") - tex(name).count(r"\leftarrow") == tex(name).count(r"\right")


@every_robot
def test_no_dates_and_no_places(name):
    for text in (tex(name), page(name)):
        assert not re.search(r"/(?:home|tmp|work|Users)/|\b20\d\d-\d\d", text)
        assert "http" not in text.replace("http://www.w3.org", "") and " src=" not in text


@every_robot
def test_the_paper_is_cited_once(name):
    authors, title = CITATION.split(": ")
    for text in (" ".join(tex(name).split()), " ".join(page(name).split())):
        assert text.count(authors) == text.count(title) == 1


@every_robot
def test_every_step_is_shown_once_with_name_and_equation(name):
    chain = Chain(robot(name))
    sections = re.split(r"\\section\{", tex(name))
    shown = {int(s.split("}")[0].split()[-1]): s for s in sections if re.match(r"Link class \d+\}", s)}
    others = [s for s in sections if re.match(r"Link class \d+, other forms\}", s)]
    assert sorted(shown) == list(range(1, len(chain.classes) + 1))
    for class_number, key in enumerate(chain.classes, 1):
        referred = [shown[int(n)] for n in re.findall(r"(?:As for|of) class (\d+)", shown[class_number])] + others
        wanted = Counter(step.name for step in {step for _, view in views(key) for step in view.steps})
        own = _steps(shown[class_number])
        assert own <= wanted
        for _, view in views(key):
            for step in view.steps:
                assert own[step.name] == wanted[step.name] or any(_steps(s)[step.name] for s in referred), step.name
                assert step.equation == "" or f"({step.equation})" in tex(name)


def test_steps_that_a_class_shows_already_are_not_shown_again():
    """The energy has the link's own bias again."""
    (energy,) = re.findall(r"\\subsection\*?\{Energy\}(.*?)\\sub", tex("ella"), re.DOTALL)
    assert r"\step{kinetic}" in energy and "H\\_star" not in energy


def _steps(section: str) -> Counter:
    return Counter(name.replace(r"\_", "_") for name in re.findall(r"\\(?:step|brief)\{(.*?)\}\{", section))


@every_robot
def test_nothing_that_is_zero_is_shown(name):
    for key in Chain(robot(name)).classes:
        for _, view in views(key):
            for step in view.steps:
                assert all(right.strip() not in ("= 0", r"= \mathbf{0}") for _, right, *_ in step.formula), step.name


@every_robot
def test_the_table_explains_every_symbol(name):
    chain = Chain(robot(name))
    shown = [pair for key in chain.classes for pair in views(key)]
    explained = {entry.display for entry in entries(shown)}
    for _, view in shown:
        defined = {written(s) for s in view.defined if not s.display.startswith("-")}
        used = {formula(s) for s in view.used if not _is_entry(s)}
        assert defined | used <= explained, (defined | used) - explained


def _is_entry(symbol) -> bool:
    """One entry of a vector, or a shape multiplied by its abscissa: no symbol of its own."""
    return symbol.name.endswith("]") or symbol.name == "lever"


@every_robot
def test_the_table_has_no_symbol_twice(name):
    chain = Chain(robot(name))
    table = entries(pair for key in chain.classes for pair in views(key))
    counts = Counter(entry.display for entry in table)
    assert max(counts.values()) == 1
    assert all(entry.meaning for entry in table)


@every_robot
def test_the_table_says_shape_frame_and_origin_of_every_symbol(name):
    (table,) = next(s.items for s in content(name).sections if s.title == "Symbols")
    assert all(cell for row in table.rows for cell in row)
    rows = {row[0]: row[1:] for row in table.rows}
    assert rows[r"$\mathbf{M}_i$"][2:] == (r"$\mathcal{F}_i$", r"$(6 + r_i) \times (6 + r_i)$", "state")
    if name == "ella":
        sizes = {r"\boldsymbol{\tau}_i": "$n_{q,i}$", r"\mathbf{S}_i": r"$6 \times n_{q,i}$"}
        assert {symbol: rows[f"${symbol}$"][3] for symbol in sizes} == sizes
    no_origin = {row[0] for row in table.rows if row[-1] == "–"}
    assert no_origin == {r"$\xi$", "$s$"}, "what does not follow from anything"


def test_the_system_shown_is_the_robot_s():
    """One link: three places, the pattern of both forms without a second link, 14 unknowns."""
    rod = Robot.model_validate(arm(link("rod", axes="y", modes={"bending_y": 1, "bending_z": 1})))
    text = latex.document(rod, PLUGINS, WHOLE)
    system = text[text.index("The stacked system") : text.index("{Energies}")]
    assert "unknowns: here $14$" in system
    assert r"[\mathbf{w}_1;\ \dot{\mathbf{V}}_1;\ \ddot{\boldsymbol{\eta}}_1]" in system
    assert r"\mathbf{M}_{VV,1}" in system and ",2}" not in system and r"\vdots" not in system
    assert r"\mathbf{M}_{VZ,1}" in text and "1 joint coordinate, 2 modal" in text


@every_robot
def test_no_step_says_that_a_symbol_is_itself(name):
    """As ``c_1 = c_1(x)`` would."""
    chain = Chain(robot(name))
    chapters = [pair for plugin in PLUGINS for pair in plugin.chapter(chain).views]
    for key in chain.classes:
        for _, view in (*views(key), *chapters):
            for step in view.steps:
                left, right, *_ = step.formula[0]
                assert not right.removeprefix("= ").startswith(f"{left}("), step.name
                assert not re.fullmatch(re.escape(left) + r"\\left\(.*\\right\)", right.removeprefix("= ")), step.name


@pytest.mark.parametrize(
    ("block", "step", "expected"),
    [
        (
            "link",
            "S_0",
            r"\mathbf{s}_0 = \rho_i A_i\int_{a_i}^{c_i} \mathbf{r}_b\,d\xi"
            r" = \begin{bmatrix} \tfrac{1}{2}\,\rho_i A_i\,l_i^{2} \\ 0 \\ 0 \end{bmatrix}",
        ),
        (
            "link",
            "sigma",
            r"\boldsymbol{\Sigma} = \rho_i A_i\int_{a_i}^{c_i} \boldsymbol{\phi}\,d\xi = \rho_i A_i\,l_i\,"
            r"\begin{bmatrix} 0.900316 & 0 & 0 \\ 0 & 0.782992 & 0 \\ 0 & 0 & 0.782992 \end{bmatrix}",
        ),
        ("link", "h_MD", r"\mathbf{h}_{M_D,i} = \mathbf{h}_c"),
        (
            "tip",
            "Psi_c",
            r"\boldsymbol{\Psi}_c = \boldsymbol{\Psi}_i(c_i) = \tfrac{1}{l_i}\,"
            r"\begin{bmatrix} 0 & 0 & 0 \\ 0 & 0 & -2.75301 \\ 0 & 2.75301 & 0 \end{bmatrix}",
        ),
        (
            "joint",
            "A",
            r"\mathbf{A}_i = \begin{bmatrix} \exp\left(-\tilde{\mathbf{e}}_z\,q_{2}\right)\,\mathbf{e}_y & \mathbf{e}_z"
            r" \end{bmatrix} = \begin{bmatrix} \sin q_{2} & 0 \\ \cos q_{2} & 0 \\ 0 & 1 \end{bmatrix}",
        ),
    ],
)
def test_known_steps(block, step, expected):
    key = Chain(robot("ella")).classes[0]
    view = next(s for s in block_view(derived(key)[block]).steps if s.name == step)
    assert [" ".join(row) for row in view.formula] == [expected]


def test_evaluated_integrals_stand_in_the_document():
    assert r"12.3624\,E_iI_{z_i}/l_i^{3}" in tex("ella")
    assert r"\mathbf{M}_{W\phi,i} = \rho_i A_i\int_{a_i}^{c_i}" in tex("ella")
    assert r"\rho_i A_i\,l_i\,\mathbf{I}_{3}" in tex("ella")


# -------- how numbers, symbols and long sums are written


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (sp.Integer(-2), "-2"),
        (sp.Rational(1, 3), r"\tfrac{1}{3}"),
        (sp.Float(0.782991756039626), "0.782992"),
        (sp.Float(-1.23456789e-7), r"-1.23457\times 10^{-7}"),
        (sp.Float(43.8e6), r"4.38\times 10^{7}"),
    ],
)
def test_numbers_have_six_digits(value, text):
    assert number(value) == text


def test_tilde_sits_on_the_letter():
    assert tilde(r"\boldsymbol{\omega}_i") == r"\tilde{\boldsymbol{\omega}}_i"
    assert tilde(r"\dot{\mathbf{r}}_{\xi}") == r"\tilde{\dot{\mathbf{r}}}_{\xi}"


@pytest.mark.parametrize(("pitch", "plus", "minus"), [("0.07", "+", "-"), ("-0.07", "-", "+")])
def test_each_term_has_one_sign(pitch, plus, minus):
    """Also one whose number is negative, as the pitch of a left-handed screw."""
    r, q = ex.Symbol("r", (3, 1), r"\mathbf{r}"), ex.Symbol("q", (1, 1), "q")
    shift = ex.product(ex.product(ex.number(sp.Float(pitch)), q), ex.unit(2))
    assert formula(ex.add(r, shift)) == rf"\mathbf{{r}} {plus} 0.07\,q\,\mathbf{{e}}_z"
    assert formula(ex.add(r, -shift)) == rf"\mathbf{{r}} {minus} 0.07\,q\,\mathbf{{e}}_z"
    turned = {"joint": {"axes": ["z", {"screw": "y", "pitch": float(pitch)}], "mount": {"xyz": [0.1, 0.0, 0.3]}}}
    text = latex.document(Robot.model_validate(arm(link("rod", 1.0, [], **turned))))
    assert r"0.07\,q_{2}" in text and not re.search(r"[+-] -", text)


def _block(modes: int) -> Block:
    b = Block("sums", "Sums")
    eta = b.input("eta", (modes, 1), r"\boldsymbol{\eta}_i", "m", "-", "modal coordinates")
    k = b.parameter("k", (modes, 1), r"\mathbf{k}_i", "N/m", "-", "stiffness")
    b.step("U", k.T @ eta, "U", unit="N", meaning="a long sum")
    return b


def test_short_sums_are_written_out_and_long_ones_abridged():
    short, long = _block(3), _block(40)
    assert scalars(short)(short.steps["U"].assignments[0][1]) == r"k_{1}\,\eta_{1} + k_{2}\,\eta_{2} + k_{3}\,\eta_{3}"
    text = scalars(long)(long.steps["U"].assignments[0][1])
    assert r"+ \cdots + k_{39}\,\eta_{39} + k_{40}\,\eta_{40}" in text and width(text) < PAGE


@every_robot
def test_every_line_fits(name):
    for key in Chain(robot(name)).classes:
        for _, view in views(key):
            for step in view.steps:
                for row in (*step.formula, *step.components):
                    assert width(" ".join(row)) <= PAGE + 4.0, step.name


def test_width_of_a_matrix_is_that_of_its_widest_entries():
    narrow, wide = (
        width(r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}"),
        width(r"\begin{bmatrix} 1 & x + y \end{bmatrix}"),
    )
    assert 2.0 < narrow < 4.0 < wide < 6.5
