"""Equations in scalars: textbook robots symbol by symbol, numbers as the model has them, size, refusals."""

from __future__ import annotations

import re
from functools import cache
from itertools import accumulate, pairwise

import numpy as np
import pytest
import sympy as sp
from latex_formula import SYMBOL
from textbook_robots import DIGESTS, TEXTBOOKS, Textbook, digests, lump

import screwgen
from screwgen.backends.equations.document import content
from screwgen.backends.equations.equations import Equations
from screwgen.backends.latex import document as latex
from screwgen.cli.posture import posture
from screwgen.spec.robot import Robot

EVERY = pytest.mark.parametrize("name", TEXTBOOKS)


@cache
def textbook(name: str) -> Textbook:
    return TEXTBOOKS[name]()


@cache
def model(name: str) -> screwgen.Model:
    return screwgen.derive(Robot(**textbook(name).robot))


def equations(name: str) -> Equations:
    return model(name).equations()


def same(ours: sp.Matrix, theirs: sp.Matrix) -> bool:
    """Equal term by term: brackets are multiplied out, no identity is used."""
    return (ours - theirs).applyfunc(sp.expand) == sp.zeros(*theirs.shape)


def straight(e: Equations, matrix: sp.Matrix) -> sp.Matrix:
    """Without deflection, as where a source has it so."""
    return e.expanded(matrix).subs({q: 0 for q in e.q if q.name.startswith("eta")})


@EVERY
def test_the_inertia_is_the_textbook_s(name):
    e, book = equations(name), textbook(name)
    M = e.expanded(e.M)
    assert same(straight(e, M) if name == "flexible_arm" else M, book.M), book.source


@EVERY
def test_velocity_terms_and_forces_at_rest_are_the_textbook_s(name):
    e, book = equations(name), textbook(name)
    if name != "flexible_arm":
        assert same(e.expanded((e.C + e.D) * sp.Matrix(e.qdot)), book.velocity), book.source
    assert same(e.K * sp.Matrix(e.q) + e.g, book.rest), book.source


def test_the_elbow_manipulator_is_written_as_the_book_prints_it():
    lines = str(equations("two_link")).splitlines()
    assert "M_11 = m_1*c_1**2 + I_1 + I_2 + m_2*(l_1**2 + c_2**2 + 2*l_1*c_2*cos(q_2))" in lines
    assert "C_12 = -m_2*l_1*c_2*sin(q_2)*(qdot_1 + qdot_2)" in lines
    assert "g_1 = g*((m_1*c_1 + m_2*l_1)*cos(q_1) + m_2*c_2*cos(q_1 + q_2))" in lines


def test_powers_of_one_angle_stand_where_they_are_shorter():
    assert "M_11 = m*c**2*sin(q_2)**2" in str(equations("spherical_pendulum")).splitlines()


@EVERY
def test_twice_the_velocity_matrix_less_the_rate_of_the_inertia_is_skew(name):
    e = equations(name)
    M, C = e.expanded(e.M), e.expanded(e.C)
    slopes = (M.diff(q) * v for q, v in zip(e.q, e.qdot, strict=True))
    skew = sum(slopes, sp.zeros(len(e.q))) - 2 * C
    assert same(skew + skew.T, sp.zeros(len(e.q)))


@EVERY
def test_the_numbers_are_those_of_the_model(name):
    e, numbers = equations(name), model(name).numpy()
    rng = np.random.default_rng(5)
    n = len(e.q)
    arguments = [*e.q, *e.qdot, *e.qddot]
    left = e.expanded(e.M * sp.Matrix(e.qddot) + e.C * sp.Matrix(e.qdot) + e.D * sp.Matrix(e.qdot) + e.g)
    left = (left + e.K * sp.Matrix(e.q)).subs(e.parameters)
    force = sp.lambdify(arguments, left)
    inertia = sp.lambdify(e.q, e.expanded(e.M).subs(e.parameters))
    for _ in range(5):
        q, v, a = rng.uniform(-1.5, 1.5, (3, n))
        q[[x.name.startswith("eta") for x in e.q]] *= 0.05
        wanted = numbers.inverse_dynamics(q, v, a, None)
        np.testing.assert_allclose(force(*q, *v, *a).ravel(), wanted, rtol=1e-12, atol=1e-12 * np.abs(wanted).max())
        np.testing.assert_allclose(inertia(*q), numbers.mass_matrix(q), rtol=1e-12, atol=1e-12)


@EVERY
def test_the_linear_equations_are_those_of_the_model(name):
    e, own = equations(name), model(name)
    posture = np.full(len(e.q), 0.4)
    posture[[x.name.startswith("eta") for x in e.q]] = 0.01
    linear, numbers = e.linearised(posture), own.numpy()
    number = lambda matrix: np.array(linear.expanded(matrix).subs(e.parameters), dtype=float)  # noqa: E731
    zero = np.zeros(len(e.q))
    _, by_q, by_v = numbers.slopes(posture, zero, zero, None)
    wanted = numbers.mass_matrix(posture), by_v, by_q, numbers.inverse_dynamics(posture, zero, zero, None)[:, None]
    for found, right in zip((linear.M, linear.D, linear.K, linear.tau_0), wanted, strict=True):
        np.testing.assert_allclose(number(found), right, rtol=1e-12, atol=1e-11)


def test_the_efforts_act_where_the_drives_are():
    assert [str(x) for x in equations("elastic_joint").forces] == ["0", "tau"]
    assert [str(x) for x in equations("flexible_arm").forces] == ["tau_1", "tau_2", "0", "0"]


def test_parameters_have_values_and_names():
    e = equations("crane")
    assert e.parameters[sp.Symbol("g")] == 9.81
    assert e.parameter_names[sp.Symbol("m_2")] == "rope.bodies[0].mass"
    assert sp.Symbol("alpha_2") not in e.parameters


def test_an_angle_of_a_mount_is_a_symbol_unless_roots_express_its_sine():
    links = [
        {"name": "a", "length": 1.0, "joint": {"axes": ["z"]}, "bodies": [lump(1.0, 0.5, 0.1)]},
        {"name": "b", "joint": {"axes": ["z"]}, "bodies": [lump(1.0, 0.5, 0.1)]},
    ]
    robot = {"name": "bent", "gravity": [0.0, 0.0, -9.81], "links": links}
    for angle, wanted in ((0.3, "cos(alpha_2 + q_2)"), (np.pi / 6, "sqrt(3)*sin(q_2) + cos(q_2)")):
        links[1]["joint"]["mount"] = {"rpy": [0.0, 0.0, angle]}
        e = screwgen.derive(Robot(**robot)).equations()
        assert wanted in str(e)
        rest = screwgen.derive(Robot(**robot)).numpy().mass_matrix([0.2, 0.7])
        found = np.array(e.M.subs(e.parameters).subs({"q_1": 0.2, "q_2": 0.7}), dtype=float)
        np.testing.assert_allclose(found, rest, rtol=1e-12)


def degree(e: Equations, term: str) -> int:
    """The lowest power of modal coordinates in a term."""
    names = {str(x): x for x in e.M.free_symbols | {*e.q, *e.qdot}}
    etas = [q for q in e.q if q.name.startswith("eta")]
    return min(map(sum, sp.Poly(sp.sympify(term, names), *etas).monoms()))


def summands(text: str) -> list[str]:
    """The terms of a sum, as they are written: what stands between signs outside brackets."""
    depths = list(accumulate((c == "(") - (c == ")") for c in text))
    cuts = [m.start() for m in re.finditer(r" [+-] ", text) if depths[m.start()] == 0]
    return [text[i:j].strip(" +-") for i, j in pairwise([0, *cuts, len(text)])]


def test_polynomials_in_modal_coordinates_rise_by_degree():
    e = equations("flexible_arm")
    lines = [line.split(" = ")[-1] for line in str(e).splitlines() if line.startswith("M_")]
    degrees = [[degree(e, term) for term in summands(line)] for line in lines]
    assert all(d == sorted(d) for d in degrees) and set(degrees[0]) == {0, 1, 2}, degrees


def test_the_same_bytes_with_all_versions():
    """`make minima` compares the same digests with the lowest versions of sympy and of all else."""
    assert digests() == DIGESTS.read_text(encoding="utf-8"), "python tests/textbook_robots.py writes them"


def test_what_it_shows():
    e = equations("flexible_arm")
    assert "\nmu_2 = rhoA_2*l_2\npsi_1 = 2*sqrt(5)*eta_1/l_1\n" in str(e)
    assert e._repr_latex_().startswith(r"$\displaystyle \begin{gathered}")
    assert repr(e) == str(e)
    assert e.operations < 800


REFUSED = {
    "many times as many": "six_link.toml",
    "too large to read": "flexible_arm.toml",
    "loops or couplings": "parallelogram.toml",
    "quaternion": "space_arm.toml",
    "transmission": "bucket.toml",
}


@pytest.mark.parametrize("reason", REFUSED)
def test_what_is_too_large_or_has_no_closed_form_is_refused_in_a_line(reason):
    with pytest.raises(screwgen.UsageError, match=reason) as error:
        screwgen.derive(screwgen.load(f"examples/{REFUSED[reason]}")).equations()
    assert "\n" not in str(error.value)


def test_robots_with_tendons_are_refused():
    """A tension bends the links by the slope of its length: it is no force on one mode."""
    section = {"rhoA": 1.0, "EIz": 40.0, "EIy": 40.0}
    rod = {"name": "rod", "length": 1.0, "section": section, "modes": {"bending_y": 1}, "joint": {"axes": ["z"]}}
    rod["tendons"] = [{"name": "left", "at": [[0.0, 0.01, 0.0], [0.0, 0.01, 0.0]]}]
    with pytest.raises(screwgen.UsageError, match="it has tendons"):
        screwgen.derive(Robot(name="pulled", gravity=[0.0, -9.81, 0.0], links=[rod])).equations()


def test_a_posture_of_another_length_is_refused():
    with pytest.raises(screwgen.UsageError, match="give the 2 of the posture"):
        equations("two_link").linearised([0.1, 0.2, 0.3])


# -------- postures, letters

STATED = {
    "pi/2, -pi/4": (np.pi / 2, -np.pi / 4),
    "2*pi/3 0.5*pi": (2 * np.pi / 3, np.pi / 2),
    "3pi/4,-.5": (3 * np.pi / 4, -0.5),
    "1.5707963,1.5707965": (np.pi / 2, np.pi / 2),
    "-1.0472,0.7854": (-np.pi / 3, np.pi / 4),
    "1.571,0.0001": (1.571, 0.0001),
}


@pytest.mark.parametrize("given", STATED)
def test_angles_are_taken_as_they_are_meant(given):
    """To the last bit or two; of a joint that slides decimals are what they are."""
    np.testing.assert_allclose(posture("--about", given, (True, True)).q, STATED[given], rtol=4e-16)
    assert posture("--about", "1.5708,0.7854", (True, False)).q == (np.pi / 2, 0.7854)


@pytest.mark.parametrize(
    "given", ["pi/0,1", "pi*pi,1", "2*,1", "one,1", "nan,1", "1", "1,2,3", "0,pi", "9**9,1", "1e999,0"]
)
def test_what_is_no_posture_is_refused_in_a_line(given):
    with pytest.raises(screwgen.UsageError, match=r"^--about: ") as error:
        posture("--about", given, (True, False))
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(("given", "rounding"), [((0.3, np.pi / 2 - 0.3), 0.0), ((0.3, 1.2707963), 5e-8)])
def test_sums_of_angles_leave_no_rest_of_rounding(given, rounding):
    """At right angles to gravity the second link has no weight that bends it, and g_2 no term."""
    exact = str(equations("two_link").linearised(given, max(rounding, 1e-12)))
    assert not re.search(r"e-\d|tau0_2", exact) and "K_22 = -m_2*g*c_2\n" in exact + "\n"


DOTS = re.compile(r"\\d?dot\{((?:[^{}]|\{[^{}]*\})*)\}")
WORD = re.compile(r"\\(?:left|right|Big[lr]|t?frac|sqrt|cos|sin|q?quad|top)(?![a-z])")
ENTRY = re.compile(r"[MCDK]_\{\d\d\}|g_\{\d\}")


def symbols(texts: list[str]) -> set[str]:
    """The symbols of formulas without dots, entries of matrices left out."""
    found = {m[0] for text in texts for m in SYMBOL.finditer(WORD.sub(" ", DOTS.sub(r"\1", text)))}
    return {symbol for symbol in found if not ENTRY.fullmatch(symbol)}


@pytest.mark.parametrize("name", ["flexible_arm", "elastic_joint", "crane"])
def test_the_document_explains_its_letters_before_it_uses_them(name):
    """Every letter of formulas and sketch has a row, the coordinates come in their order; vectors are bold."""
    e = equations(name)
    shown = content(model(name).chain, e)
    first, formulas = shown.sections
    rows = [row for item in first.items if item.kind == "table" for row in item.rows]
    labels = [x.text for x in first.items[0].drawing.labels if x.look in ("q", "body", "mode", "drive", "force")]
    explained = [row[0].strip("$") for row in rows]
    names = [x.latex for x in e.coordinates]
    assert (
        explained[: len(names)] == names
        and len(explained) == len(set(explained))
        and all(row[1] and ",," not in row[1] for row in rows)
    )
    cells = [cell for x in formulas.items if x.kind == "display" for row in x.formula for cell in row]
    drawn = symbols([x.strip("$") for x in labels])
    assert symbols(cells) | drawn <= symbols(explained), (symbols(cells) | drawn) - symbols(explained)
    assert symbols(names) <= drawn, "the sketch has all coordinates"
    text = latex.tex(shown)
    assert r"\mathbf{M}(\mathbf{q})" in text and "M_{11}" in text and r"\tableofcontents" not in text


@pytest.mark.parametrize("count", [1, 2])
def test_the_shapes_that_a_document_prints_are_normalised(count):
    """Read as they stand, and integrated by sympy: with them the square root of five can be found again."""
    rod = {"name": "rod", "length": 1.0, "joint": {"axes": ["z"]}, "section": {"rhoA": 1.0, "EIy": 1.0, "EIz": 1.0}}
    own = screwgen.derive(Robot(name="rod", gravity=[0.0, 0.0, 0.0], links=[rod | {"modes": {"bending_y": count}}]))
    items = content(own.chain, own.equations()).sections[0].items
    lines = [" ".join(row).strip() for x in items if x.kind == "display" for row in x.formula]
    s = sp.Symbol("s")
    shapes = [sp.sympify(as_text(x.partition("= ")[2]), {"s": s}) for x in lines if x.startswith(r"\varphi_{")]
    assert len(shapes) == count and (count > 1 or shapes[0] == sp.sqrt(5) * s**2)
    gram = sp.Matrix([[sp.integrate(a * b, (s, 0, 1)) for a in shapes] for b in shapes])
    np.testing.assert_allclose(np.array(gram, dtype=float), np.eye(count), atol=1e-4)  # six digits, of up to 16


def as_text(formula: str) -> str:
    """LaTeX of a polynomial as sympy reads it."""
    for old, new in ((r"\left", ""), (r"\right", ""), (r"\,", "*"), ("s^{", "s**{"), (r"\sqrt{5}", "sqrt(5)*")):
        formula = formula.replace(old, new)
    return formula.replace("{", "(").replace("}", ")")
