"""The equations as documents: complete, well-formed, the same every time, and nothing runs off the page."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections import Counter
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import jinja2
import numpy as np
import pytest
import sympy as sp
from conftest import require_tool

from screwgen import Robot, ScrewgenError, load
from screwgen.algebra.notation import latex as formula
from screwgen.algebra.notation import number, tilde
from screwgen.chain.chain import Chain
from screwgen.chain.scope import derived
from screwgen.derive.block import Block
from screwgen.emit import latex
from screwgen.emit.latex_layout import PAGE, width
from screwgen.emit.latex_scalars import scalars
from screwgen.emit.latex_steps import block_view
from screwgen.emit.latex_symbols import entries, written
from screwgen.emit.templates import folder, render

ROOT = Path(__file__).resolve().parents[1]
MATHML = "{http://www.w3.org/1998/Math/MathML}"

SECTION = {"rhoA": 1.0, "EA": 1e6, "EIy": 1e3, "EIz": 2e3, "GJ": 3e2, "rhoIp": 1e-3}
BODY = {"mass": 1.5, "com": [0.1, 0.0, -0.02], "inertia": [0.02, 0.03, 0.03, 0.0, 0.001, 0.0]}
STRANGE = {
    "name": "strange",
    "gravity": [1.0, 0.0, -9.81],
    "links": [
        {
            "name": "a_link_with_a_name_as_long_as_names_can_",
            "length": 1.0,
            "frame_at": 0.25,
            "section": SECTION,
            "modes": {"basis": "polynomial", "axial": 2, "bending_y": 4, "bending_z": 3, "torsion": 1},
            "damping": {"ratio": 0.01},
            "joint": {
                "axes": [[0.3, -0.4, 0.866], "y", [0.1, 0.2, -0.97]],
                "mount": {"xyz": [0.0, 0.1, 0.2], "rpy": [0.1, 0.2, 0.3]},
                "armature": [0.1, 0.2, 0.3],
                "damping": [0.1, 0.2, 0.3],
                "stiffness": [1.0, 2.0, 3.0],
            },
            "bodies": [{"at": "base", **BODY}, {"at": "tip", **BODY}, {"at": "tip", **BODY}],
        },
        {"name": "welded", "length": 0.5, "section": {"rhoA": 2.0}, "joint": {"axes": []}},
        {
            "name": "thin",
            "length": 0.7,
            "section": {"rhoA": 0.3, "EIy": 10.0},
            "modes": {"bending_z": 1},
            "joint": {"axes": ["x", [1.0, 1.0, 0.0]]},
        },
    ],
}


@cache
def robot(name: str) -> Robot:
    return Robot.model_validate(STRANGE) if name == "strange" else load(ROOT / "examples" / f"{name}.toml")


@cache
def tex(name: str) -> str:
    return latex.document(robot(name))


@cache
def page(name: str) -> str:
    return latex.html(robot(name))


NAMES = ("ella", "six_link", "strange")
every_robot = pytest.mark.parametrize("name", NAMES)


# -------- LaTeX


@every_robot
def test_the_same_every_time(name):
    assert latex.document(robot(name)) == tex(name)
    assert latex.html(robot(name)) == page(name)


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
        assert "http" not in text.replace("http://www.w3.org", "") and "<script" not in text


@every_robot
def test_every_step_is_shown_once_with_name_and_equation(name):
    chain = Chain(robot(name))
    sections = re.split(r"\\section\{", tex(name))
    shown = {int(s.split("}")[0].split()[-1]): s for s in sections if s.startswith("Link class")}
    assert sorted(shown) == list(range(1, len(chain.classes) + 1))
    for class_number, key in enumerate(chain.classes, 1):
        referred = [shown[int(n)] for n in re.findall(r"As for class (\d+)", shown[class_number])]
        wanted = Counter(step.name for view in latex.class_views(key) for step in view.steps)
        own = _steps(shown[class_number])
        assert own <= wanted
        for view in latex.class_views(key):
            for step in view.steps:
                assert own[step.name] == wanted[step.name] or any(_steps(s)[step.name] for s in referred), step.name
                assert step.equation == "" or f"({step.equation})" in tex(name)


def _steps(section: str) -> Counter:
    return Counter(name.replace(r"\_", "_") for name in re.findall(r"\\step\{(.*?)\}\{", section))


@every_robot
def test_nothing_that_is_zero_is_shown(name):
    for key in Chain(robot(name)).classes:
        for view in latex.class_views(key):
            for step in view.steps:
                assert all(right.strip() not in ("= 0", r"= \mathbf{0}") for _, right, *_ in step.formula), step.name


@every_robot
def test_the_table_explains_every_symbol(name):
    chain = Chain(robot(name))
    views = [(derived(key)[v.name], v) for key in chain.classes for v in latex.class_views(key)]
    explained = {entry.display for entry in entries(views)}
    for _, view in views:
        defined = {written(s) for s in view.defined if not s.display.startswith("-")}
        used = {formula(s) for s in view.used if not _is_entry(s)}
        assert defined | used <= explained, (defined | used) - explained


def _is_entry(symbol) -> bool:
    """One entry of a vector, or a shape multiplied by its abscissa: no symbol of its own."""
    return symbol.name.endswith("]") or symbol.name == "lever"


@every_robot
def test_the_table_has_no_symbol_twice(name):
    chain = Chain(robot(name))
    table = entries((derived(key)[v.name], v) for key in chain.classes for v in latex.class_views(key))
    counts = Counter(entry.display for entry in table)
    assert max(counts.values()) == 1
    assert all(entry.meaning for entry in table)


@pytest.mark.parametrize(
    ("block", "step", "expected"),
    [
        (
            "link",
            "S_0",
            r"\mathbf{S}_0 = \rho_i A_i\int_{a_i}^{c_i} \mathbf{r}_b\,d\xi"
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
    assert r"\mathbf{M}_{W\phi,i} & = \rho_i A_i\int_{a_i}^{c_i}" in tex("ella")
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
        for view in latex.class_views(key):
            for step in view.steps:
                for row in (*step.formula, *step.components):
                    assert width(" ".join(row)) <= PAGE + 4.0, step.name


def test_width_of_a_matrix_is_that_of_its_widest_entries():
    narrow, wide = (
        width(r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}"),
        width(r"\begin{bmatrix} 1 & x + y \end{bmatrix}"),
    )
    assert 2.0 < narrow < 4.0 < wide < 6.5


# -------- HTML


@every_robot
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


def test_bold_letters_are_characters():
    assert "\U0001d74e" in page("ella")  # bold italic omega
    assert 'mathvariant="bold' not in page("ella")


def test_notebook_is_short_and_well_formed():
    text = latex.notebook(robot("ella"))
    ElementTree.fromstring(text)
    assert "<math" in text and len(text) < len(page("ella")) / 4


# -------- templates


def test_an_unknown_name_in_a_template_is_an_error():
    with pytest.raises(jinja2.UndefinedError):
        render("latex/document.tex.jinja")


def test_the_templates_are_where_they_belong():
    assert (folder() / "latex" / "document.tex.jinja").is_file()


# -------- pdflatex


def _log(text: str, where: Path) -> str:
    (where / "equations.tex").write_text(text, encoding="utf-8")
    command = [require_tool("pdflatex"), "-interaction=nonstopmode", "-halt-on-error", "equations.tex"]
    done = subprocess.run(command, cwd=where, capture_output=True, text=True, errors="replace")
    assert done.returncode == 0, done.stdout[-2000:]
    return (where / "equations.log").read_text(errors="replace").replace("\n", " ")


@every_robot
def test_pdflatex_compiles_and_nothing_runs_off_the_page(name, tmp_path):
    too_wide = [float(w) for w in re.findall(r"Overfull \\hbox \(([\d.]+)pt", _log(tex(name), tmp_path))]
    assert max(too_wide, default=0.0) <= 5.0


def test_random_robots_compile(tmp_path):
    """One robot with whatever a draw gives; the width of every line is what this looks for."""
    from random_robots import random_robot

    text = latex.document(Robot.model_validate(random_robot(np.random.default_rng(3), n_links=2)))
    too_wide = [float(w) for w in re.findall(r"Overfull \\hbox \(([\d.]+)pt", _log(text, tmp_path))]
    assert max(too_wide, default=0.0) <= 5.0


def test_the_pdf_is_the_same_every_time(tmp_path):
    require_tool("pdflatex")
    for name in ("first", "second"):
        latex.write_pdf(tex("ella"), tmp_path / f"{name}.pdf")
    first, second = ((tmp_path / f"{name}.pdf").read_bytes() for name in ("first", "second"))
    assert first == second and first.startswith(b"%PDF")


def test_without_pdflatex_one_line_says_so(monkeypatch, tmp_path):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(ScrewgenError, match=r"^pdflatex was not found;.*$"):
        latex.write_pdf("", tmp_path / "none.pdf")


def test_a_failure_of_pdflatex_is_one_line(tmp_path):
    require_tool("pdflatex")
    with pytest.raises(ScrewgenError) as caught:
        latex.write_pdf(r"\documentclass{article}\begin{document}\nonsense\end{document}", tmp_path / "none.pdf")
    assert str(caught.value) == "pdflatex failed: Undefined control sequence."
    assert not (tmp_path / "none.pdf").exists()
