"""What runs, their files and pages, and units report of forces between frames."""

import csv

import jax
import numpy as np
import pytest
from fmi_units import Unit
from force_robots import lines, sprung, sprung_model, state
from helpers import quick, relative

import screwgen
from screwgen.plotting.run_panels import panels
from screwgen.viewer.view import read_run, view

NAMES = ("spring.length", "spring.pull", "rope.length", "rope.pull")


def by_jax(model, q, v):
    with jax.enable_x64(True):
        return np.asarray(model.jax()["force_quantities"](q, v, np.array(model.parameter_values)))


BACK_ENDS = {
    "numpy": lambda model, q, v: model.numpy().force_quantities(q, v),
    "casadi": lambda model, q, v: model.casadi()["force_quantities"](q, v, model.parameter_values).full().ravel(),
    "c": lambda model, q, v: quick(model).force_quantities(q, v),
    "jax": by_jax,
}


@pytest.mark.parametrize("rest", [1.0, 3.0], ids=["taut", "slack"])
@pytest.mark.parametrize("backend", BACK_ENDS)
def test_lengths_and_pulls_are_those_of_the_geometry(backend, rest):
    model = sprung_model(rest)
    q, v = state(model)
    expected = lines(model, q, v, rest)
    assert (expected[3] == 0) == (rest == 3.0) and expected[1] > 1
    assert relative(BACK_ENDS[backend](model, q, v), expected) < 1e-12


def test_runs_files_and_pages_have_them_by_name(tmp_path):
    model = sprung_model()
    run = screwgen.simulate(model, 0.02, 1e-3, q0=state(model)[0], store=tmp_path / "kept.csv")
    assert (tmp_path / "kept.csv").read_text().partition("\n")[0] == ",".join(run.columns)
    assert run.names_of("force_quantities") == NAMES
    found = run.force_quantities
    assert relative(found[-1], lines(model, run.q[-1], run.v[-1])) < 1e-12
    run.save(tmp_path / "run.npz")
    run.save(tmp_path / "run.csv")
    back = read_run(tmp_path / "run.npz")
    assert back.names_of("force_quantities") == NAMES and np.array_equal(back.force_quantities, found)
    with open(tmp_path / "run.csv", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [float(rows[-1][name]) for name in NAMES] == found[-1].tolist()
    drawn = {x.title: (x.unit, [line.label for line in x.lines]) for x in panels(back)}
    both = ["spring", "rope"]
    assert drawn["Length of forces between frames"] == ("m", both)
    assert drawn["Pull of forces between frames"] == ("N", both)
    assert "Pull of forces between frames" in view(back).html


def test_a_unit_has_them_as_outputs():
    unit = Unit("fmu2", "me", sprung)
    q, v = state(unit.model)
    unit.ready(**dict(zip(unit.states, [*q, *v], strict=True)))
    assert relative(unit.get(NAMES), lines(unit.model, q, v)) < 1e-12
    told = {x.name: x for x in unit.description.modelVariables}
    assert [told[name].unit for name in NAMES[:2]] == ["m", "N"]
    assert told["spring.pull"].description == "force that pulls the ends together"


def test_a_file_whose_names_were_lost_is_refused(tmp_path):
    model = sprung_model()
    screwgen.simulate(model, 0.002, 1e-3, q0=state(model)[0]).save(tmp_path / "run.npz")
    with np.load(tmp_path / "run.npz") as stored:
        kept = {name: stored[name] for name in stored.files if name != "quantity_names"}
    np.savez(tmp_path / "lost.npz", **kept)
    with pytest.raises(screwgen.UsageError, match=r"lost.npz: force_quantities has the shape \(3, 4\), and its names"):
        read_run(tmp_path / "lost.npz")
