"""Frequencies of links that are held at their bases, with and without gravity, beside those of `modes`."""

from __future__ import annotations

import json

import numpy as np
import pytest
from helpers import G, arm, example, link, model_of
from scipy.optimize import brentq

from screwgen import Joint, UsageError, dump, held_frequencies, mode_shapes, natural_frequencies
from screwgen.cli.main import main
from screwgen.studies.modes import changed_by_gravity

BEAM = {"rhoA": 0.5, "modes": {"bending_y": 4, "bending_z": 4, "torsion": 1}, "section": {"EIy": 20.0, "EIz": 30.0}}


def test_a_link_with_a_payload_has_the_frequencies_of_the_textbook():
    """`1 + cos cosh = μ λ (sin cosh − cos sinh)` of a clamped beam with μ times its own mass at its tip."""
    mass, mu = 0.5 * 1.2, 0.4
    robot = model_of(arm(link("beam", 1.2, "y", bodies=[{"at": "tip", "mass": mu * mass}], **BEAM))).robot
    known = lambda x: 1 + np.cos(x) * np.cosh(x) - mu * x * (np.sin(x) * np.cosh(x) - np.cos(x) * np.sinh(x))  # noqa: E731
    root = brentq(known, 0.5, 1.8751)
    expected = [root**2 / (2 * np.pi * 1.2**2) * np.sqrt(EI / 0.5) for EI in (20.0, 30.0)]
    assert np.allclose(held_frequencies(robot, 0)[:2], expected, rtol=1e-6)


def test_they_are_those_of_modes_of_the_link_alone():
    model = example("converged")
    for k, own in enumerate(model.robot.links):
        alone = model.robot.model_copy(update={"links": (own.model_copy(update={"joint": Joint(axes=())}),)})
        found = held_frequencies(model.robot, k)
        assert len(found) == own.modes.total and np.allclose(found, natural_frequencies(type(model)(alone)), rtol=1e-12)
    hub = link("hub", 0.3, "z") | {"bodies": [{"at": "tip", "mass": 9.0}]}
    robot = model_of(arm(hub, link("beam", 1.2, "y", segments=2, at="base", **BEAM), link("last", 0.4, "y"))).robot
    assert held_frequencies(robot, 0).size == 0
    bare, expected = held_frequencies(robot, 1), 1.87510407**2 / (2 * np.pi * 1.44) * np.sqrt(20.0 / 0.5)
    assert len(bare) == 18 and np.isclose(bare, expected, rtol=1e-5).sum() == 1


def hanging(**more):
    """A soft rod that hangs from its clamp: its weight stiffens it."""
    rod = {"modes": {"bending_z": 3}, "section": {"EIy": 0.05}, "joint": {"mount": {"rpy": [0.0, np.pi / 2, 0.0]}}}
    return model_of(arm(link("rod", 1.0, [], 0.5, **rod), order=2, **more))


def test_gravity_that_is_left_out_is_said_where_it_matters(tmp_path, capsys):
    model = hanging()
    changed = changed_by_gravity(model, None, "locked", mode_shapes(model))
    assert changed.number == 1 and changed.growth == 0.0
    assert changed.without == natural_frequencies(model)[0]
    assert changed.loaded == natural_frequencies(model, loaded=True)[0] > 1.5 * changed.without
    path = tmp_path / "rod.toml"
    path.write_text(dump(model.robot))
    for more in ([], ["--json"]):
        assert main(["modes", str(path), *more]) == 0
        note = f"frequency 1 is {changed.loaded:.4g} Hz, not {changed.without:.4g} Hz"
        said = capsys.readouterr()
        assert said.err == f"screwgen: note: gravity is left out; with --loaded, which takes it in, {note}\n"
        assert not more or json.loads(said.out)["frequencies_hz"][0] == changed.without
    assert main(["modes", str(path), "--loaded"]) == 0 and capsys.readouterr().err == ""


@pytest.mark.parametrize("gravity", [(0.0, 0.0, 0.0), (0.0, 0.0, -0.1)])
def test_gravity_that_hardly_matters_is_not_said(gravity):
    model = hanging(gravity=gravity)
    assert changed_by_gravity(model, None, "locked", mode_shapes(model)) is None


def test_a_column_that_its_weight_buckles_is_said_to_grow():
    model = hanging(gravity=(0.0, 0.0, G))
    changed = changed_by_gravity(model, None, "locked", mode_shapes(model))
    assert changed.growth > 0 and changed.loaded == 0.0


def test_rates_without_stiffening_name_the_remedy():
    """A beam of order 1 that turns fast loses the stiffness `m Ω²` and gains none."""
    beam = link("beam", 1.0, "z", 0.5, modes={"bending_y": 2}, section={"EIz": 1.0})
    model = model_of(arm(beam, gravity=(0, 0, 0)))
    said = (
        r"1 of 2 vibrations grow, .*; screwgen.mode_shapes tells how fast they grow; give links that turn order = 2 or"
    )
    with pytest.raises(UsageError, match=said):
        natural_frequencies(model, rates=[20.0])
    assert mode_shapes(model, rates=[20.0]).growth.any()
