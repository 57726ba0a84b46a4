"""What readers of a document alone had to guess: each stands in it now, and only where the robot has it."""

from __future__ import annotations

import math
import re
from functools import cache

import numpy as np
import pytest
from document_robots import robot_with
from helpers import ROOT, model_of

from screwgen import Robot, load
from screwgen.algorithms.scope import derived
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.content import Document, DocumentTable, Paragraph, StepEquation
from screwgen.topology.chain import Chain


@cache
def content(*features: str) -> Document:
    return latex.content(Robot.model_validate(robot_with(*features)))


def texts(*features: str) -> str:
    return "\n".join(item.text for s in content(*features).sections for item in s.items if isinstance(item, Paragraph))


def taken(*features: str) -> dict[str, dict[str, int]]:
    """By part of a class: what is taken from it, with the number of the line that first needs it."""
    (algorithm,) = (s for s in content(*features).sections if s.title == "Algorithm")
    (table,) = (x for x in algorithm.items if isinstance(x, DocumentTable) and x.head[0] == "part of a class")
    return {part: {s: int(n) for s, n in re.findall(r"\$([^$]*)\$ \(A(\d+)\)", cell)} for part, cell in table.rows}


def test_what_is_taken_from_a_class_is_all_that_its_lines_and_parts_take():
    tip, rows = (taken("plain")[part] for part in ("Tip section", "Rows of the link"))
    for symbol in (r"\mathbf{R}_T", r"\mathbf{r}_T", r"\mathbf{J}_l", r"\boldsymbol{\phi}_c"):
        assert tip[symbol] == rows[r"\mathbf{J}_{TV}"], "what the Jacobian of the tip needs is needed with it"
    field = taken("exact", "tendons")["Kinematic field"]
    assert field.keys() >= {r"\mathbf{R}_T", r"\mathbf{r}_T", r"\mathbf{J}_l", r"\partial\boldsymbol{\ell}_c"}


@pytest.mark.parametrize(
    ("features", "there", "absent"),
    [
        (("plain",), "A rigid link has no modes, so its vectors and blocks of modes are empty", "Loops"),
        (("mounted",), r"the angles $\boldsymbol{\alpha}_M$ of its mount", "dampers"),
        (("hinge loop",), "A distance along", "the only force of a row alone"),
        (("sliding loop",), "An angle between", "of the two kinds"),
        (("exact", "tendons"), "to the sums it adds nothing", "the number $m$ of the mass"),
    ],
)
def test_a_document_says_what_its_robot_has(features, there, absent):
    assert there in texts(*features) and absent not in texts(*features)


def test_loops_have_the_kinds_of_rows_that_the_robot_has():
    for features in (("hinge loop",), ("sliding loop",), ("weld loop",)):
        chain = latex.chain_of(Robot.model_validate(robot_with(*features)))
        kinds = {type(closing.row).__name__ for closing in chain.closing.rows}
        said = {"Distance": "A distance along", "Angle": "An angle between"}
        assert {kind for kind, words in said.items() if words in texts(*features)} == kinds


def test_entries_that_are_not_listed_are_zero_or_mirrored():
    """Of a matrix whose entries stand below it, the document lists every other one."""
    robot, listed = load(ROOT / "examples" / "ella.toml"), 0
    chain = Chain(robot)
    for item in (x for s in latex.content(robot).sections for x in s.items if isinstance(x, StepEquation)):
        name = item.step.definition.signal.display
        if not item.step.components or name not in (r"\mathbf{J}", r"\mathbf{B}"):
            continue
        written = " ".join(cell for row in item.step.components for cell in row)
        letter, entries = name[-2], derived(chain.classes[0])["link"].values[item.step.name]
        mirrored = bool((entries == entries.T).all())
        assert mirrored == item.meaning.endswith(", symmetric")
        for (i, j), value in np.ndenumerate(entries):
            wanted = value != 0 and not (mirrored and j < i)
            assert (f"{letter}_{{{'xyz'[i]}{'xyz'[j]}}} " in written) == wanted
        listed += 1
    assert listed == 2


def test_bodies_that_a_tip_lacks_are_all_said_to_be_zero():
    said = [x for x in texts("plain").split("\n") if x.startswith("Zero here") and "m_T" in x]
    assert said and all(r"\mathbf{h}_{TF}" in x and r"\mathbf{I}_T" in x for x in said)


def test_stumpff_functions_have_values_beyond_the_range_of_their_series():
    place, values = re.search(r"At \$x = (\d+)\$ the values of .* are (.*?)\.\n", texts("plain") + "\n").groups()
    x, found = float(place), [float(value.strip("$ ")) for value in values.split(",")]
    closed = [math.sin(math.sqrt(x)) / math.sqrt(x), (1 - math.cos(math.sqrt(x))) / x]
    closed += [(1 / math.factorial(k) - closed[k - 1]) / x for k in (1, 2)]
    closed.append((1 / 6 - closed[2]) / x)
    assert x > 4 and found == pytest.approx(closed, rel=1e-14)


def test_the_same_constant_has_the_same_digits_everywhere():
    tables = [t for s in content("plain").sections for t in s.items if isinstance(t, DocumentTable)]
    cells = " ".join(cell for t in tables if set(t.head) == {"entry"} for row in t.rows for cell in row)
    digits = set(re.findall(r"\b\d\.\d{14,}", cells))
    assert len({number[:15] for number in digits}) == len(digits) > 3


def test_parameters_without_a_place_in_the_equations_are_not_used():
    """Each of them may have any value, and the accelerations are the same."""
    robot = robot_with("plain")
    model = model_of(robot)
    (table,) = (t for s in content("plain").sections if s.title == "Parameters" for t in s.items)
    unused = [row[0].strip("`") for row in table.rows if row[1] == "not used"]
    assert unused and "–" not in {row[1] for row in table.rows}
    given = np.full(model.nq, 0.1), np.full(model.nv, 0.3), np.ones(model.n_tau), None
    own = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    twice = [[(1.0 + (name in names)) * x for name, x in own.items()] for names in (unused, ["upper.EIy"])]
    before, same, other = (model.numpy(p).forward_dynamics(*given)[0] for p in (list(own.values()), *twice))
    assert np.array_equal(before, same) and not np.array_equal(before, other)
