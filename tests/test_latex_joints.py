"""The torques of the joints in the document: the printed rows are those of the program, and joints have their names."""

from __future__ import annotations

import re

import numpy as np
import pytest
from latex_documents import content, robot

import screwgen
from screwgen import Robot
from screwgen.backends.latex.content import SYMBOLS, Display, Document
from screwgen.backends.latex.document import extras
from screwgen.backends.latex.joint_words import called, sought
from screwgen.backends.latex.joints import JOINTS, instance
from screwgen.backends.latex.page import _instances, symbols_of
from screwgen.topology.chain import Chain


def displays(document: Document) -> dict[int, Display]:
    """By the number of a link: the equation of its joint."""
    (section,) = (s for s in document.sections if s.title == JOINTS)
    return {item.link: item for item in section.items if isinstance(item, Display)}


def rows(text: str, q: np.ndarray) -> np.ndarray:
    """A printed matrix whose entries are numbers, sines and cosines of coordinates."""
    (inside,) = re.findall(r"= \\begin\{bmatrix\} (.*?) \\end\{bmatrix\}", text)
    entry = re.compile(r"(-?)(?:\\(sin|cos) q_\{(\d)\}|([\d.]+))")

    def value(cell: str) -> float:
        sign, function, number, constant = entry.fullmatch(cell.strip()).groups()
        size = getattr(np, function)(q[int(number) - 1]) if function else float(constant)
        return -size if sign else size

    return np.array([[value(cell) for cell in row.split("&")] for row in inside.split(r"\\")])


def test_the_torques_are_these_parts_of_the_joints_wrenches():
    model = screwgen.derive(robot("ella"))
    rng = np.random.default_rng(2)
    n = len(model.q_names)
    q = np.concatenate([rng.uniform(-1.0, 1.0, 3), 0.01 * rng.normal(size=n - 3)])
    tau = rng.normal(size=3)
    _, wrench = model.numpy().forward_dynamics(q, 0.1 * rng.normal(size=n), tau, None)
    shown = displays(content("ella"))
    found = [rows(shown[i + 1].formula[0][1], q) @ wrench[i] for i in range(2)]
    np.testing.assert_allclose(np.concatenate(found), tau, atol=1e-9)


def test_an_equation_has_what_its_joint_has():
    ella, six = (displays(content(name)) for name in ("ella", "six_link"))
    carried = r"\mathbf{X}_{2}^{\top}\,\mathbf{w}_{2}"
    text = {i: " ".join(cell for row in x.formula for cell in row) for i, x in ella.items()}
    assert carried in text[1] and "mathbf{X}" not in text[2]
    assert any("mathbf{D}_{q," in cell for x in six.values() for row in x.formula for cell in row)
    assert list(six) == [1, 2, 3, 4, 5, 6]


@pytest.mark.parametrize(
    ("link", "word"),
    [
        ("forearm", "elbow"),
        ("left_fore", "elbow"),
        ("upper_arm", "shoulder"),
        ("boom", ""),
        ("r_hand", "wrist"),
        ("wrist_2_link", "wrist"),
    ],
)
def test_joints_have_the_names_that_people_give_them(link, word):
    assert called(link) == word


def row(*links: dict, **more) -> list[str]:
    """The words of links in a row."""
    return sought(Chain(Robot.model_validate({"name": "row", "gravity": [0.0, 0.0, -9.81], "links": links} | more)))


def turning(name: str, length: float = 0.0, axes: tuple = ("z",), **joint) -> dict:
    body = {"at": "base", "mass": 1.0, "com": [0.1, 0.0, 0.0], "inertia": [0.1, 0.1, 0.1, 0.0, 0.0, 0.0]}
    own = {"name": name, "joint": {"axes": list(axes), **joint}, "bodies": [body]}
    return own | ({"length": length} if length else {})


def test_a_search_finds_joints_by_their_place_in_an_arm():
    """Joints on one axis belong together, away from the base is the elbow; names of links come first."""
    assert row(turning("a", 1.0), turning("b", 1.0)) == ["shoulder", "elbow"]
    column = turning("column", 1.0, ("x",))
    parts = column, turning("a", 0.7, ("y",)), turning("b", 0.5, ("x",)), turning("c", axes=("y",))
    assert row(*parts) == ["shoulder", "shoulder", "elbow", "elbow"]
    placed = {"mount": {"xyz": [0.5, 0.0, 0.0]}}
    assert row(turning("a"), turning("b", **placed), turning("c", **placed)) == ["shoulder", "elbow", "wrist"]
    welded = turning("a", 1.0), turning("sleeve", 0.2, ()), turning("b", 0.5)
    assert row(*welded) == ["shoulder", "", "elbow"]
    assert row(turning("a", 1.0), turning("thigh", 1.0)) == ["", "hip"]


def test_what_is_no_arm_has_no_such_words():
    slide = [{"slide": "x"}]
    assert row(turning("pendulum", 1.0)) == [""]
    assert row(turning("a", 1.0, slide), turning("b", 1.0)) == ["", ""]
    assert row(*(turning(name, 1.0) for name in "abcd")) == ["", "", "", ""]
    assert row(turning("a", 1.0), turning("b", 1.0), turning("c", 1.0) | {"parent": "a"}) == ["", "", ""]


@pytest.mark.parametrize(
    ("symbol", "of_link"),
    [
        (r"\mathbf{V}_i", r"\mathbf{V}_2"),
        (r"\mathbf{M}_{D,i}", r"\mathbf{M}_{D,2}"),
        (r"\mathbf{J}_{TV}", r"\mathbf{J}_{TV,2}"),
        (r"\mathbf{M}_T", r"\mathbf{M}_{T,2}"),
        (r"\mathbf{p}", r"\mathbf{p}_2"),
    ],
)
def test_a_symbol_of_one_link_has_its_number(symbol, of_link):
    assert instance(symbol, 2) == of_link


def test_symbols_of_a_link_mean_what_the_torques_equation_means():
    """No other quantity of the document has the letters of the link's inertia, bias or tip load."""
    document = content("ella")
    found = _instances(symbols_of(document), extras(Chain(robot("ella"))))
    (table,) = (item for s in document.sections if s.title == SYMBOLS for item in s.items)
    meanings = {row[0].strip("$"): row[1] for row in table.rows}
    means = {
        r"\mathbf{M}_{V,2}": "inertia in the twist rows",
        r"\mathbf{M}_{T,2}": "inertia of the bodies at the tip",
        r"\mathbf{M}_{D,2}": "wrench that modal accelerations need (torsion: times m)",
        r"\mathbf{h}_{V,2}": "bias of the twist rows",
    }
    assert {symbol: meanings[found[symbol][0]] for symbol in means} == means
