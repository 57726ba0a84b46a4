"""The functions that every back end offers: their page, their names, and what is none of them."""

import dataclasses

import numpy as np
import pytest
from helpers import arm, example, link, model_of, quick

from docs.tools import functions_page
from screwgen import rollout, simulate
from screwgen.algorithms.entry_names import entry_names, entry_units
from screwgen.algorithms.robot_functions import BY_NAME, FUNCTIONS, OUTPUTS
from screwgen.algorithms.signals import Signal


def test_the_page_lists_every_function():
    """`python docs/tools/functions_page.py` writes them."""
    page = functions_page.PAGE.read_text(encoding="utf-8")
    assert functions_page.table(page) == page
    assert all(f"\n| `{row.name}` | " in page for row in FUNCTIONS)


def test_entries_of_vectors_have_names_and_units():
    signals = {"linear": Signal((3,), "kg*m/s", "-", ""), "turn": Signal((), "kg*m^2/s", "-", "")}
    row = dataclasses.replace(BY_NAME["energy"], name="momentum", results=signals)
    names = ["momentum.linear.x", "momentum.linear.y", "momentum.linear.z", "momentum.turn"]
    assert list(entry_names(row, ())) == names
    assert entry_units(row, example("bucket").chain) == ["kg·m/s"] * 3 + ["kg·m²/s"]


def test_a_row_that_names_no_algorithm_is_told_where_to_name_it(monkeypatch):
    """Constants are prepared for the algorithms that rows name."""
    monkeypatch.setitem(BY_NAME, "validity", dataclasses.replace(BY_NAME["validity"], algorithms=()))
    model = model_of(arm(link("boom", modes={"bending_y": 1}, section={"EIz": 20.0})))
    with pytest.raises(LookupError, match=r"'Psi_c_\w+' was not prepared.*name its algorithm in the row"):
        model.numpy().validity([0.1] * model.nq, [0.0] * model.nv, [0.0], None)


def test_what_nothing_reports_is_no_attribute():
    model = example("ella")
    run = simulate(model, 1e-3, 1e-3)
    for x in (model.numpy(), run, rollout(model, np.zeros(2 * model.nq), step=1e-3, steps=1), quick(model)):
        with pytest.raises(AttributeError, match="has no attribute 'powers'"):
            _ = x.powers


@pytest.mark.parametrize("actuation", ["torque", "motion"])
def test_results_that_are_reported_have_names_of_their_own(actuation):
    """`evaluate` prints them side by side, by their names alone."""
    chain = model_of(arm(link("boom") | {"joint": {"axes": ["z"], "actuation": [actuation]}})).chain
    names = [name for row in FUNCTIONS if row.c_file == OUTPUTS and row.offered(chain) for name in row.results]
    assert len(set(names)) == len(names) > 2
