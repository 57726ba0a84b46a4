"""Postures of order 2 in which the mass matrix is indefinite: accepted at rest with a warning, refused by motions."""

from __future__ import annotations

import json

import numpy as np
import pytest
from helpers import arm, link, model_of
from oracle import Oracle

from screwgen import ModelValidityWarning, SingularError, dump, equilibrium, natural_frequencies
from screwgen.cli.main import main

SAYS = "link 'beam' bends so far that the mass matrix, of second order in the deflection, is not positive definite"
REMEDY = SAYS + '; give order = "exact", or more segments'


def heavy_beam(order, modes: int = 5) -> dict:
    """A beam that sags by 65 mm per metre, within the bounds of the model, and of little inertia about its axis."""
    counts = {"bending_y": modes, "bending_z": modes, "torsion": 1}
    section = {"EIy": 60.0, "EIz": 60.0, "GJ": 40.0, "rhoIp": 2e-6}
    beam = link("beam", 1.0, "y", 0.5, modes=counts, section=section, bodies=[{"at": "tip", "mass": 1.0}])
    return arm(beam) | {"order": order}


def test_an_indefinite_posture_is_said_wherever_it_is_accepted():
    """The oracle's mass matrix says the same; with one mode less per plane, or none of its terms, it is definite."""
    robot = heavy_beam(2)
    model = model_of(robot)
    with pytest.warns(ModelValidityWarning, match=REMEDY):
        rest = equilibrium(model, hold=True)
    assert np.linalg.eigvalsh(Oracle(robot).mass_matrix(rest.q))[0] < 0
    assert not rest.validity.findings and not rest.validity.holds and rest.validity.record()["indefinite"] == REMEDY
    for study in (
        lambda: natural_frequencies(model, rest.q),
        lambda: natural_frequencies(model, loaded=True),
        lambda: model.linearise(rest.q, tau=rest.tau),
    ):
        with pytest.raises(SingularError, match=REMEDY):
            study()
    assert natural_frequencies(model)[0] > 0


@pytest.mark.parametrize(("order", "modes"), [(1, 5), (2, 2), ("exact", 5)])
def test_definite_postures_are_left_alone(order, modes, recwarn):
    model = model_of(heavy_beam(order, modes))
    rest = equilibrium(model, hold=True)
    assert rest.validity.holds and "indefinite" not in rest.validity.record() and not recwarn.list
    assert natural_frequencies(model, rest.q)[0] > 0


def test_commands_say_it(tmp_path, capsys):
    path = tmp_path / "beam.toml"
    path.write_text(dump(model_of(heavy_beam(2)).robot))
    assert main(["equilibrium", str(path), "--hold", "--json"]) == 0
    said = capsys.readouterr()
    assert json.loads(said.out)["validity"]["indefinite"] == REMEDY
    assert said.err.splitlines()[-1] == f"screwgen: warning: {REMEDY}"
    assert main(["modes", str(path), "--loaded"]) == 1
    assert capsys.readouterr().err.splitlines()[-1] == f"screwgen: error: {REMEDY}"
