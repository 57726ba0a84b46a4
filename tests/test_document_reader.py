"""A program that reads the document of a robot alone computes its accelerations: robots that the matrix lacks."""

import re

import numpy as np
import pytest
from conftest import swept
from document_mass import mass_matrix_from_document
from document_reader import accelerations_from_document
from document_robots import robot_with
from document_symbols import Scope, plain
from helpers import example, example_dict, model_of

from screwgen.backends.latex import document as latex
from screwgen.backends.latex.algorithm import SPARE
from screwgen.backends.latex.content import Paragraph

TOLERANCE = 1e-10
EXAMPLES = (
    "balanced_arm",
    "bucket",
    "crane",
    "crane_loop",
    "elastic_joint",
    "ella",
    "ella_paper",
    "flexible_arm",
    "gantry",
)
EXAMPLES += ("finger_on_wall", "parallelogram", "ship_crane", "six_link", "soft_gripper", "space_arm", "tentacle")
BEYOND = (
    ("weld loop", "skew"),
    ("sliding loop", "tendons", "varying"),
    ("order 2", "sliding loop", "screw"),
    ("exact", "weld loop", "tendons"),
    ("coupling", "carried", "tendons"),
    ("branched", "floating", "slide"),
    ("forces", "order 2", "hinge loop"),
    ("forces", "curved", "floating"),
    ("forces", "branched", "coupling"),
    ("bristles", "bristles of a slide", "carried"),
    ("falling", "bent bristles of a slide"),
    ("geared bend", "plain"),
    ("geared bristles", "dahl", "weld loop"),
)
"""Loops at markers, several tendons on a link, couplings along the arm, trees of three flexible links, forces; internal
states of both kinds of friction on one robot, on a slide, on a rotor, and of an element that the product lacks;
friction that falls and bends, beside bristles and beside one that does not."""


def state(model, seed=3):
    """Coordinates, rates, inputs and wrenches without pattern; loops may be open, which all equations allow."""
    rng, chain = np.random.default_rng(seed), model.chain
    q, v = rng.uniform(0.2, 0.5, model.nq), rng.normal(size=chain.nvz)
    q[chain.eta_q :] *= 0.03
    v[chain.eta_v :] *= 0.2
    for part in chain.curved:
        turn = slice(part.q.start + part.joint.turn_at, part.q.start + part.joint.turn_at + 4)
        q[turn] = [0.8, 0.3, -0.4, np.sqrt(1 - 0.8**2 - 0.3**2 - 0.4**2)]
    return q, v, rng.normal(size=model.n_tau), rng.normal(size=(model.n_links, 6))


def judged(model) -> float:
    """How far the reader is from the model, the largest of the relative errors."""
    given = state(model)
    own = (*model.numpy().forward_dynamics(*given), model.numpy().mass_matrix(given[0]))
    read = (*accelerations_from_document(model, *given), mass_matrix_from_document(model, given[0]))
    return max(np.max(np.abs(a - b)) / max(1.0, np.max(np.abs(a))) for a, b in zip(own, read, strict=True))


@pytest.mark.parametrize("name", swept(EXAMPLES, "flexible_arm"))
def test_the_documents_of_examples_are_complete(name):
    assert judged(example(name)) < TOLERANCE


@pytest.mark.parametrize("features", swept(BEYOND, BEYOND[0], *BEYOND[-4:]), ids=" and ".join)
def test_so_are_those_of_what_the_matrix_has_no_place_for(features):
    assert judged(model_of(robot_with(*features))) < TOLERANCE


@pytest.mark.parametrize("name", ["tentacle", "soft_gripper"])
def test_what_no_line_needs_is_not_read(name, monkeypatch):
    """The symbols that the section Algorithm says are printed for what they say alone."""
    model, asked = model_of(example_dict(name)), set()
    found = Scope._found
    monkeypatch.setattr(Scope, "_found", lambda scope, symbol: (asked.add(symbol), found(scope, symbol))[1])
    accelerations_from_document(model, *state(model))
    algorithm = next(x for x in latex.content(model.robot).sections if x.title == "Algorithm")
    said = next(x.text for x in algorithm.items if isinstance(x, Paragraph) and x.text.startswith(SPARE))
    spare = {plain(x) for x in re.findall(r"\$([^$]*)\$", said)}
    assert len(spare) > 5 and plain(r"\mathbf{h}_{V}") in asked
    assert not sorted(spare & asked)
